# %% [markdown]
# # Mathieu's equation
#
# A string whose tension pulses, a pendulum whose pivot moves up and down, a rotor with unequal
# stiffnesses: to first approximation each obeys
#
# $$\ddot x + 2\mu\dot x + (\omega^2 - 2q\cos\Omega t)\,x = 0 .$$
#
# Rest is unstable inside *tongues* of the plane of $\omega^2$ and $q$, which touch the axis $q = 0$
# at $\omega = n\Omega/2$. This notebook derives the edges of the first three tongues and the curve
# around $\omega = 0$, without and with damping, to order 4.
#
# What is reproduced: the power series of the eigenvalues $a_n(q)$ and $b_n(q)$ in NIST's *Digital
# Library of Mathematical Functions* (DLMF), equations 28.6.1 to 28.6.7 and 28.6.14; and the
# transition curves with and without damping of A. H. Nayfeh and D. T. Mook, *Nonlinear
# Oscillations* (1979), chapter 5.

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown, Math, display
from scipy.special import mathieu_a, mathieu_b
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report

# %% [markdown]
# ## 1. The model

# %%
t = dynamicsymbols._t
x = dynamicsymbols("x")
omega, Omega = sp.symbols("omega Omega", positive=True)
q, mu = sp.symbols("q mu", nonnegative=True)

model = mg.Model(
    lagrangian=x.diff(t) ** 2 / 2 - (omega**2 - 2 * q * sp.cos(Omega * t)) * x**2 / 2,
    coordinates=[x],
    parameters=[
        mg.Parameter(omega, "rad/s", "natural frequency"),
        mg.Parameter(Omega, "rad/s", "frequency of the modulation"),
        mg.Parameter(q, "rad^2/s^2", "half the modulation of the stiffness"),
        mg.Parameter(mu, "1/s", "rate at which free oscillations decay"),
    ],
    dissipation=mu * x.diff(t) ** 2,
)
eom = model.equations_of_motion()
report.equations(eom)

# %% [markdown]
# For $\Omega = 2$ and $\mu = 0$ this is the standard form of the DLMF, section 28.2,
# $w'' + (a - 2q\cos 2z)w = 0$ with $a = \omega^2$.
#
# ## 2. Orders in ε and resonances
#
# The modulation is of order ε. Without damping:

# %%
undamped = eom.reparametrise({mu: 0}).scale({q: 1})
display(report.orders(undamped, 0))
display(report.orders(undamped, 1))
report.orders(undamped, 2)

# %% [markdown]
# Every resonance up to order 4, from the divisors. Tongue $n$ opens at order $n$:

# %%
undamped.resonances(order=4)

# %% [markdown]
# ## 3. Three tongues without damping
#
# The natural frequency is the one that is detuned, $\omega = n\Omega/2 + \varepsilon\sigma$, so
# that the edges come out as $\omega$ over $q$. Tongue $n$ is expanded to the order $n$ at which it
# opens, and to order 4.

# %%
CASES = ((1, 1), (1, 2), (1, 4), (2, 2), (2, 4), (3, 3), (3, 4))
tongues = {(n, order): undamped.expand(order, {omega: n * Omega / 2}) for n, order in CASES}
for n in (1, 2, 3):
    opening = tongues[n, n]
    display(Markdown(f"### Tongue {n}, ${report.case_title(opening)}$"))
    for order in range(1, n + 1):
        display(report.solvability(opening, order))
    display(Markdown("The edges to order 4:"))
    display(report.boundary(tongues[n, 4]))

# %% [markdown]
# On the edges there are periodic solutions, so the eigenvalues of the standard form are
# $a = (n + \sigma_\pm)^2$ at $\Omega = 2$. As series in $q$ they are those of DLMF 28.6.2 to
# 28.6.7, to the last coefficient:


# %%
def show(name, series):
    """A series, lowest power first."""
    display(Math(f"{name} = {sp.latex(series, order='rev-lex')}"))


def eigenvalue(edge, n, order):
    """a = (n + σ)² at Ω = 2 through q^order."""
    squared = sp.expand((n + edge.subs(Omega, 2)) ** 2)
    return sum(squared.coeff(q, k) * q**k for k in range(order + 1))


R = sp.Rational
DLMF = {
    "a_1": 1 + q - q**2 / 8 - q**3 / 64 - q**4 / 1536,
    "b_1": 1 - q - q**2 / 8 + q**3 / 64 - q**4 / 1536,
    "a_2": 4 + R(5, 12) * q**2 - R(763, 13824) * q**4,
    "b_2": 4 - q**2 / 12 + R(5, 13824) * q**4,
    "a_3": 9 + q**2 / 16 + q**3 / 64 + R(13, 20480) * q**4,
    "b_3": 9 + q**2 / 16 - q**3 / 64 + R(13, 20480) * q**4,
}
edges = {
    f"{letter}_{n}": tongues[n, 4].slow_flow.boundary()[k]
    for n in (1, 2, 3)
    for k, letter in ((1, "a"), (0, "b"))
}
for name, printed in DLMF.items():
    derived = eigenvalue(edges[name], int(name[-1]), 4)
    assert sp.expand(derived - printed) == 0
    show(f"{name}(q)", derived)

# %% [markdown]
# The same edges in the other form that is common, $\ddot x + (1 + 2q\cos\Omega t)x = 0$, with the
# excitation detuned instead (the sign of $q$ is a shift of time by half a period, and exchanges
# the edges of odd tongues): $\Omega = 2 \pm q - q^2/8$ around the first tongue,
# $\Omega = 1 - 5q^2/6$ and $1 + q^2/6$ around the second. The growth rate at $\Omega = 2$ is
# $q/2 - 15q^3/256$.

# %%
unit = {omega: 1}
excited = {n: undamped.expand(3, {Omega: 2 * omega / n}) for n in (1, 2)}
printed = {1: (2 - q - q**2 / 8, 2 + q - q**2 / 8), 2: (1 - R(5, 6) * q**2, 1 + q**2 / 6)}
for n, case in excited.items():
    for edge, formula in zip(case.slow_flow.boundary(), printed[n], strict=True):
        speed = sp.expand(R(2, n) + edge.subs(unit))
        assert sp.expand(speed + sp.O(q**3) - formula - sp.O(q**3)).removeO() == 0
        show(r"\Omega", speed)

Gamma = sp.Symbol("Gamma")
sigma = excited[1].relations[0].detuning
at_2 = excited[1].slow_flow.characteristic_polynomial(Gamma).subs({sigma: 0, **unit})
growth = sp.series(sp.sqrt(sp.expand(Gamma**2 - at_2)), q, 0, 4).removeO()
assert sp.expand(growth - (q / 2 - R(15, 256) * q**3)) == 0
show(r"\max \mathrm{Re}\, \Gamma", growth)

# %% [markdown]
# ## 4. Around zero
#
# At $\omega = 0$ the leading order does not oscillate, and there is nothing to expand about. The
# curve $a_0(q)$ follows all the same, from the case without resonance. There the modulation shifts
# the frequency of the motion from $\omega$ to $\nu$:

# %%
free = {order: undamped.expand(order) for order in (2, 4)}
display(report.solvability(free[4], 2))
report.solvability(free[4], 4)

# %% [markdown]
# The trace of the monodromy matrix, $2\cos(2\pi\nu/\Omega)$, is an entire function of $\omega^2$
# and $q$, because the solutions of the equation are. So $\nu^2$ is analytic as long as the
# cosine stays away from $-1$, and that includes $\omega = 0$ and negative $\omega^2$. The poles of
# $\dot A/A$ at $\omega = 0$ must disappear from $\nu^2$, and they do. With $\Omega = 2$ and
# $a = \omega^2$:

# %%
(amplitude,) = free[4].amplitudes
a, nu = sp.symbols("a nu")
shift = sum(sp.cancel(free[4].solvability[p][amplitude] / (sp.I * amplitude)) for p in (2, 4))
square = sp.expand((omega + shift.subs(Omega, 2)) ** 2)
c2, c4 = (sp.factor(sp.cancel(square.coeff(q, k)).subs(omega, sp.sqrt(a))) for k in (2, 4))
Math(rf"\nu^2 = {sp.latex(a + c2 * q**2 + c4 * q**4)}")

# %% [markdown]
# Solved for $a$, this is the general series that DLMF prints as 28.6.14 for integer $\nu$ from 7 on
# (and in section 28.15 for any $\nu$ that is no integer):
#
# $$a = \nu^2 + \frac{q^2}{2(\nu^2 - 1)} + \frac{(5\nu^2 + 7)\,q^4}{32(\nu^2 - 1)^3(\nu^2 - 4)} .$$

# %%
n2 = nu**2
printed = n2 + q**2 / (2 * (n2 - 1)) + (5 * n2 + 7) * q**4 / (32 * (n2 - 1) ** 3 * (n2 - 4))
first = -c2.subs(a, n2)
second = -(c4 + first * c2.diff(a)).subs(a, n2)
assert sp.cancel(n2 + first * q**2 + second * q**4 - printed) == 0

# %% [markdown]
# On the curve $a_0$ the motion neither grows nor turns, $\nu = 0$. This is DLMF 28.6.1:

# %%
a_0 = sp.expand(printed.subs(nu, 0))
assert sp.expand((first * q**2 + second * q**4).subs(nu, 0) - a_0) == 0
assert sp.expand(a_0 - (-(q**2) / 2 + R(7, 128) * q**4)) == 0
DLMF["a_0"] = a_0
show("a_0(q)", a_0)

# %% [markdown]
# Damping is no further matter here: $x = e^{-\mu t}y$ takes it away and replaces $a$ by
# $a - \mu^2$, and $x$ neither grows nor turns where $y$ grows like $e^{\mu t}$, $\nu^2 = -\mu^2$:

# %%
damped_a_0 = mu**2 + printed.subs(nu, sp.I * mu)
parts = [sp.factor(damped_a_0.coeff(q, power)) for power in (2, 4)]
assert damped_a_0.coeff(q, 0) == 0
assert sp.cancel(parts[0] + 1 / (2 * (1 + mu**2))) == 0
show("a_0(q)", parts[0] * q**2 + parts[1] * q**4)

# %% [markdown]
# ## 5. With damping
#
# Damping that can close tongue $n$ is of the order at which the tongue opens, $\mu \to
# \varepsilon^n\mu$. Edges exist where the root is real.

# %%
lossy = {n: eom.scale({q: 1, mu: n}) for n in (1, 2, 3)}
damped = {(n, order): lossy[n].expand(order, {omega: n * Omega / 2}) for n, order in CASES}
for n in (1, 2, 3):
    case = damped[n, max(n, 2)]
    display(Markdown(f"Tongue {n}, order {case.order}:"))
    display(report.polynomial(case))
    display(report.boundary(case))

# %% [markdown]
# At $\Omega = 2$, with $q = \varepsilon$, $\mu = \varepsilon k$ and the stiffness
# $\delta = (1 + \sigma)^2$, the first tongue is bounded by
# $\delta = 1 \pm \varepsilon\sqrt{1 - 4k^2} - \varepsilon^2/8$, as in chapter 5 of Nayfeh and Mook
# (they expand $\delta$, here it is squared and expanded again):

# %%
k, epsilon = sp.symbols("k varepsilon", nonnegative=True)
first, second = (damped[1, order].slow_flow.boundary() for order in (1, 2))
for sign, one, both in zip((-1, 1), first, second, strict=True):
    s_1, s_2 = (s.subs({Omega: 2, q: 1, mu: k}) for s in (one, sp.expand(both - one)))
    d_1, d_2 = 2 * s_1, sp.expand(s_1**2 + 2 * s_2)
    assert sp.expand(d_1**2 - (1 - 4 * k**2)) == 0 and d_1.subs(k, 0) == sign
    assert d_2 == -R(1, 8)
    show(r"\delta", 1 + sign * epsilon * sp.sqrt(sp.expand(d_1**2)) + epsilon**2 * d_2)

# %% [markdown]
# ## 6. Certificates
#
# For each case the characteristic exponents of the slow flow are compared with those of Floquet
# theory for the unexpanded equation, with $\varepsilon q$, $\varepsilon^n\mu$ and
# $\varepsilon\sigma$ for a range of ε, and so are the edges. The error of order $N$ has to fall
# like $\varepsilon^{N+1}$, or faster where the next term vanishes: away from resonance only even
# powers of $q$ occur, and so they do in the edges of the second tongue.

# %%
nonresonant = eom.scale({q: 1, mu: 1}).expand(4)


def samples(case):
    """Values at ε = 1, without any special ratio."""
    if not case.relations:
        return {"omega": 2.3, "Omega": 3.1, "q": 21.0, "mu": 0.17}
    n = int(2 * case.relations[0].rhs / Omega)
    q_n, mu_n, sigma_n = {1: (3.1, 0.7, 3.7), 2: (12.3, 5.1, 9.7), 3: (17.0, 0.3, 31.0)}[n]
    return {"Omega": 1.9, "q": q_n, "mu": mu_n, "sigma": sigma_n}


emission = mg.Emission(
    model="mathieu",
    cases=[*damped.values(), nonresonant],
    samples=samples,
    derivation="derivations/mathieu.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; NIST DLMF, section 28.6",
)
certificates = emission.certificates
report.certificate_table(certificates.values())

# %%
axes = plotting.convergence([c for c in certificates.values() if c.relation == "omega = Omega/2"])

# %% [markdown]
# Without damping the emitted functions are the edges of section 3, exactly:

# %%
for n, order in damped:
    with_damping = damped[n, order].slow_flow.boundary()
    without = tongues[n, order].slow_flow.boundary()
    assert all(
        sp.expand(a.subs(mu, 0) - b) == 0 for a, b in zip(with_damping, without, strict=True)
    )

# %% [markdown]
# ## 7. Against exact eigenvalues
#
# SciPy computes $a_n$ and $b_n$ from continued fractions, to about 15 digits. What order 4 leaves
# falls like $q^5$, or like $q^6$ where the series is even:

# %%
exact = {
    f"{letter}_{n}": (function, n)
    for letter, function, first in (("a", mathieu_a, 0), ("b", mathieu_b, 1))
    for n in range(first, 4)
}
rows = []
for name, (function, n) in sorted(exact.items(), key=lambda pair: (pair[1][1], pair[0])):
    formula = sp.lambdify(q, DLMF[name])
    gap = [abs(formula(x) - function(n, x)) for x in (1.0, 0.5, 0.25, 0.125)]
    power = np.log2(gap[-2] / gap[-1])
    rows.append((f"${name}$", *(f"{g:.1e}" for g in gap), f"{power:.1f}"))
report.Table(("eigenvalue", "q = 1", "q = 1/2", "q = 1/4", "q = 1/8", "power"), tuple(rows))

# %% [markdown]
# Two planes at $\Omega = 2$. Left, $a = \omega^2$ and $q$ without damping: exact curves, and order
# 4 upon them. Right, $\omega$ and $q$ with $\mu = 0.1$: the edges of two tongues to orders
# 1, 2 and 4 over the growth rate by Floquet theory, the darker the faster. Damping cuts the tongues
# off. The second one is there from order 2 on; its tip lies at a $q$ so large that it takes order 4
# to be there.

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.6), layout="constrained", sharey=True)
depth = np.linspace(0, 1.8, 361)
outlines = {name: function(n, depth) for name, (function, n) in exact.items()}
for low, high in (("", "a_0"), ("b_1", "a_1"), ("b_2", "a_2"), ("b_3", "a_3")):
    edge = outlines[low] if low else -2.0
    left.fill_betweenx(depth, edge, outlines[high], color="0.9", lw=0, label="unstable (exact)")
for name, outline in outlines.items():
    left.plot(outline, depth, lw=0.7, color="black", label="exact")
    style = {"color": plotting.COLOURS[2], "ls": plotting.DASHES[2], "lw": plotting.WIDTHS[2]}
    left.plot(sp.lambdify(q, DLMF[name])(depth), depth, label="order 4", **style)
left.set(xlabel="a", ylabel="q", xlim=(-1.5, 10), ylim=(0, 1.8), title="without damping")

values = {"Omega": 2.0, "mu": 0.1}
curves = {}
for order in (1, 2, 4):
    shown = [n for n in (1, 2) if (n, order) in damped]
    shifts = [damped[n, order].slow_flow.boundaries({**values, "q": depth}) for n in shown]
    edges_of = np.concatenate([n + s for n, s in zip(shown, shifts, strict=True)], axis=1)
    curves[f"order {order}"] = (edges_of, depth)
chart = mg.floquet.chart(
    eom, values, {"omega": np.linspace(0.02, 2.6, 130)}, {"q": np.linspace(0.0, 1.8, 91)}
)
plotting.stability_chart(chart, curves, xlabel="ω (rad/s)", ylabel="", axes=right)
right.set_title("μ = 0.1 1/s")
_ = plotting.shared_legend([right, left], 4)

# %% [markdown]
# ## 8. The emitted functions
#
# ```python
# from mms_functions.mathieu import omega_is_Omega_over_2_order_4 as tongue
#
# low, high = tongue.boundaries(Omega=2.0, q=0.4, mu=0.05)
# ```

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
