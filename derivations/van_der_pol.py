# %% [markdown]
# # Van der Pol's oscillator
#
# Damping that feeds small motions and brakes large ones: whatever the start, the motion ends on
# one closed curve. Its amplitude is two and its frequency a little below that of the linear
# oscillator, both by amounts that are known to high order. The formulas are those of Nayfeh and
# Mook, *Nonlinear Oscillations* (1979), chapter 3, and Nayfeh, *Introduction to Perturbation
# Techniques* (1981); the higher terms those of Andersen and Geer, "Power series expansions for the
# frequency and period of the limit cycle of the van der Pol equation", *SIAM J. Appl. Math.* 42
# (1982).

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown, Math, display
from scipy.optimize import brentq
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.symbols import modulus, phase, time_scale

# %% [markdown]
# ## 1. The model

# %%
t = dynamicsymbols._t
u = dynamicsymbols("u")
mu = sp.Symbol("mu", positive=True)
model = mg.Model.from_equations(
    [u.diff(t, 2) + u - mu * (1 - u**2) * u.diff(t)],
    [u],
    [mg.Parameter(mu, "1", "strength of the self-excitation; time and displacement scaled to one")],
)
eom = model.equations_of_motion()
report.equations(eom)

# %% [markdown]
# ## 2. Orders in ε
#
# The self-excitation is weak.

# %%
scaled = eom.scale({mu: 1})
for p in range(3):
    display(report.orders(scaled, p))

# %% [markdown]
# Nothing from outside excites it, and the table of resonances is empty:

# %%
len(scaled.resonances(order=4))

# %% [markdown]
# ## 3. Slow flow to order 4

# %%
cases = {order: scaled.expand(order) for order in (1, 2, 3, 4)}
for p in (1, 2, 3, 4):
    display(report.solvability(cases[4], p))

# %% [markdown]
# With $A = \tfrac12 a e^{i\gamma}$; odd orders change the amplitude, even ones the phase:

# %%
report.modulation(cases[4])

# %% [markdown]
# ## 4. The way to the limit cycle
#
# Order 1 has the printed solution
#
# $$a = \frac{2}{\sqrt{1 + \left(\dfrac{4}{a_0^2} - 1\right) e^{-\mu t}}} .$$

# %%
a, gamma = modulus(u), phase(u)
a_0 = sp.Symbol("a_0", positive=True)
printed = 2 / sp.sqrt(1 + (4 / a_0**2 - 1) * sp.exp(-mu * t))
rate = cases[1].slow_flow.polar[a]
assert sp.cancel((printed.diff(t) - rate.subs(a, printed)) / printed) == 0
assert printed.subs(t, 0) == a_0

# %% [markdown]
# ## 5. The limit cycle
#
# $\mathrm da/\mathrm dt = 0$ is solved for $a$ as a series in $\mu$, and the frequency follows.
# Order $N$ gives the frequency through $\mu^N$, the amplitude through $\mu^{N-1}$; odd powers
# vanish in both. The amplitude of the fundamental:


# %%
def limit_cycle(case):
    """Amplitude through μ^{N−1} and frequency through μ^N."""
    order, flow = case.order, case.slow_flow.polar
    size, balance = sp.Integer(2), sp.expand(flow[a] / (a * mu))
    for n in range(1, order):
        unknown = sp.Symbol("x")
        left = sp.expand(balance.subs(a, size + unknown * mu**n)).coeff(mu, n)
        size += sp.solve(left, unknown)[0] * mu**n
    speed = sp.expand(1 + flow[gamma].subs(a, size))
    return size, sum(speed.coeff(mu, n) * mu**n for n in range(order + 1))


def ascending(left, series):
    """A series as a formula, its lowest power first."""
    return Math(f"{left} = {sp.latex(series, order='rev-lex')}")


size, speed = limit_cycle(cases[4])
assert size == 2 + mu**2 / 64
ascending("a", size)

# %% [markdown]
# The printed frequency is

# %%
assert speed == 1 - mu**2 / 16 + 17 * mu**4 / 3072
ascending(r"\omega", speed)

# %% [markdown]
# The *largest displacement* is printed as $2 + \tfrac{1}{96}\mu^2 + \dots$: another definition of
# the amplitude, to which all harmonics contribute. On the limit cycle the expansion is
# $u(\psi) = \sum_p u_p$ with $\psi = \omega t$, and at its maximum $u' = 0$, which puts $\psi$ off
# zero by a series in $\mu$ as well (the powers of $\psi$ kept suffice through $\mu^3$):

# %%
psi = sp.Symbol("psi", real=True)
turning = {cases[4].amplitudes[0]: a / 2, time_scale(0): psi}
wave = sum(cases[4].particular(p)[u].subs(turning) for p in range(4)).rewrite(sp.cos)
wave = sp.expand(sp.expand(wave.subs(a, size), complex=False))
shift = sum(c * mu**n for n, c in enumerate(sp.symbols("x_1:4"), start=1))
taylor = sp.series(sp.expand(wave, trig=False), psi, 0, 5).removeO()
slope = sp.expand(taylor.diff(psi).subs(psi, shift))
found = {}
for n, x in enumerate(sp.symbols("x_1:4"), start=1):
    found[x] = sp.solve(slope.coeff(mu, n).subs(found), x)[0]
peak = sp.expand(taylor.subs(psi, shift).subs(found))
peak = sum(sp.nsimplify(peak.coeff(mu, n)) * mu**n for n in range(4))
assert peak == 2 + mu**2 / 96
ascending(r"u_{\max}", peak)

# %% [markdown]
# The first harmonics of the printed motion,
# $u = 2\cos\psi + \mu\left(\dots\right)$, are $-\tfrac14\mu\sin 3\psi$ and
# $-\tfrac{3}{32}\mu^2\cos 3\psi - \tfrac{5}{96}\mu^2\cos 5\psi$ with this definition of $a$:

# %%
second = sp.expand(sum(cases[4].particular(p)[u].subs(turning) for p in (1, 2)).subs(a, 2))
first = -mu * sp.sin(3 * psi) / 4
third = -3 * mu**2 * sp.cos(3 * psi) / 32 - 5 * mu**2 * sp.cos(5 * psi) / 96
assert sp.expand((second - first - third).rewrite(sp.exp)) == 0

# %% [markdown]
# ## 6. The exact limit cycle
#
# The periodic orbit of the exact equation near the limit cycle of order 4. What each series
# leaves, over the next power of $\mu$, tends to the next coefficient:
# $-\tfrac1{16}$ and $\tfrac{17}{3072}$ for the frequency, $\tfrac1{64}$ for the amplitude of the
# fundamental, $\tfrac1{96}$ for the largest displacement.


# %%
def exact_cycle(strength):
    """(frequency, amplitude of the fundamental, largest displacement) of the periodic orbit."""
    _, cycle = cases[4].slow_flow.equilibria({mu: strength}).amplitudes
    near = mg.orbit_near(cases[4], {mu: strength}, cycle)
    # The velocity vanishes once in this half of the period, which begins on the way up.
    period, (up, *_) = near.orbit.period, np.flatnonzero(near.orbit.states[1] > 0)
    start = near.orbit.times[up]
    top = brentq(lambda time: near.orbit(time)[1], start, start + 0.5 * period)
    return 2 * np.pi / period, near.amplitudes[0], near.orbit(top)[0]


rows = []
for strength in (0.8, 0.4, 0.2):
    omega, fundamental, largest = exact_cycle(strength)
    rest = (omega - 1) / strength**2
    next_rest = (rest + 1 / 16) / strength**2
    parts = (rest, next_rest, (fundamental - 2) / strength**2, (largest - 2) / strength**2)
    rows.append((f"{strength}", f"{omega:.7f}", *(f"{x:.5f}" for x in parts)))
limits = (-1 / 16, 17 / 3072, 1 / 64, 1 / 96)
rows.append((r"→ 0", "1", *(f"{x:.5f}" for x in limits)))
report.Table(
    (
        r"$\mu$",
        r"exact $\omega$",
        r"$(\omega - 1)/\mu^2$",
        r"$(\omega - 1 + \mu^2/16)/\mu^4$",
        r"$(a - 2)/\mu^2$",
        r"$(u_{\max} - 2)/\mu^2$",
    ),
    tuple(rows),
)

# %% [markdown]
# Far from small $\mu$ the orders part. Lines: the limit cycle that is an equilibrium of the slow
# flow of each order, not expanded any further; points: exact periodic orbits.

# %%
strengths = {mu: np.linspace(0.01, 2, 200)}
figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.6), layout="constrained")
for order, case in cases.items():
    response = case.slow_flow.frequency_response(strengths)
    _, cycles = response.branches  # rest, and the limit cycle
    style = {"color": plotting.COLOURS[order - 1], "ls": plotting.DASHES[order - 1]}
    style["lw"] = plotting.WIDTHS[order - 1]
    left.plot(cycles.parameter, cycles.modulus, label=f"order {order}", **style)
    right.plot(cycles.parameter, 1 + cycles.drift, **style)
for k in range(9, len(cycles.parameter), 19):
    strength = cycles.parameter[k]
    near = mg.orbit_near(cases[4], {mu: strength}, cycles.amplitudes[k], cycles.drift[k])
    assert near.stable
    speed = 2 * np.pi / near.orbit.period
    for axes, value in ((left, near.amplitudes[0]), (right, speed)):
        label = "periodic orbits" if axes is left and k == 9 else None
        axes.plot(strength, value, "ko", ms=3.4, label=label)
left.set(xlabel="μ", ylabel="amplitude of the fundamental")
right.set(xlabel="μ", ylabel="frequency of the limit cycle")
_ = left.legend(frameon=False, fontsize="small")

# %% [markdown]
# ## 7. Certificates
#
# Motions on the way to the limit cycle, over times of order $1/\varepsilon$; and the limit cycle
# itself beside periodic orbits of the exact equation: its amplitude, its frequency, and how fast
# disturbances of it die out.

# %%
emission = mg.Emission(
    model="van_der_pol",
    cases=list(cases.values()),
    samples=lambda case: {"mu": 2.3},
    amplitudes=lambda case: ([0.5 + 0.3j], 0.7),
    steady=lambda case: [mg.Steady({"mu": 2.3}, [1.0])],
    derivation="derivations/van_der_pol.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 3",
)
report.certificate_table(emission.certificates.values())

# %%
plotting.convergence(
    list(emission.certificates.values()),
    [f"order {c.order}" for c in emission.certificates.values()],
    quantity="motions at times of order 1/ε",
)
plt.show()

# %% [markdown]
# ## 8. The emitted functions

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
