# %% [markdown]
# # A pendulum whose support moves
#
# Three experiments with one pendulum. Its support shakes *up and down*: at about twice its own
# frequency it begins to swing. Its support shakes *to and fro*: it resonates at its own frequency,
# the lower, the further it swings. And standing on its head, it falls, unless the support shakes
# up and down fast enough.
#
# What is reproduced: boundary and amplitude of principal parametric resonance, A. H. Nayfeh and
# D. T. Mook, *Nonlinear Oscillations* (1979), chapter 5; the frequency response of primary
# resonance, chapter 4 there; and the condition under which the upright pendulum is stable, after
# P. L. Kapitza (1951).

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown, Math, display
from scipy.special import mathieu_a, mathieu_b
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.symbols import modulus

# %% [markdown]
# ## 1. The model
#
# A point mass on a massless rod of length $l$. Over $ml^2$, with $\omega^2 = g/l$ and lengths in
# units of $l$: the support is at $(h\cos\Omega t,\; z\cos\Omega t)$, the mass at
#
# $$x = h\cos\Omega t + \sin\theta, \qquad y = z\cos\Omega t - \cos\theta, \qquad
#   L = \tfrac12(\dot x^2 + \dot y^2) - \omega^2 y .$$
#
# Sine and cosine are kept as they are; the engine expands them as far as an order needs.

# %%
t = dynamicsymbols._t
theta = dynamicsymbols("theta")
omega, Omega = sp.symbols("omega Omega", positive=True)
h, z, mu = sp.symbols("h z mu", nonnegative=True)


def pendulum(gravity):
    """The exact equation of motion; gravity ω² > 0 where the pendulum hangs."""
    x = h * sp.cos(Omega * t) + sp.sin(theta)
    y = z * sp.cos(Omega * t) - sp.cos(theta)
    return mg.Model(
        lagrangian=sp.expand((x.diff(t) ** 2 + y.diff(t) ** 2) / 2 - gravity * y),
        coordinates=[theta],
        parameters=[
            mg.Parameter(omega, "rad/s", "natural frequency, root of g/l"),
            mg.Parameter(Omega, "rad/s", "frequency of the support"),
            mg.Parameter(h, "1", "amplitude of the support to and fro, over l"),
            mg.Parameter(z, "1", "amplitude of the support up and down, over l"),
            mg.Parameter(mu, "1/s", "damping"),
        ],
        dissipation=mu * theta.diff(t) ** 2,
    ).equations_of_motion()


eom = pendulum(omega**2)
report.equations(eom)

# %% [markdown]
# ## 2. Up and down: principal parametric resonance
#
# $z$ and $\mu$ are of order ε, the angle of order $\sqrt\varepsilon$, so that excitation, damping
# and the first nonlinear term meet at order 1.

# %%
vertical = eom.reparametrise({h: 0}).scale({z: 1, mu: 1}, amplitude=sp.Rational(1, 2))
display(report.orders(vertical, 1))
vertical.resonances(order=2)

# %%
up_down = {order: vertical.expand(order, {Omega: 2 * omega}) for order in (1, 2)}
display(report.solvability(up_down[1], 1))
display(report.solvability(up_down[2], 2))
report.modulation(up_down[1])

# %% [markdown]
# With the phase eliminated, this is left for the amplitude of a steady swing:

# %%
a, P = modulus(theta), sp.Symbol("P", real=True)  # P: a²
swinging = up_down[1].slow_flow.response_relation()
sigma = up_down[1].relations[0].detuning
report.expression("0", swinging)

# %% [markdown]
# The Mathieu–Duffing oscillator
# $\ddot u + 2\mu\dot u + (\omega^2 + 2f\cos\Omega t)u + \alpha u^3 = 0$ has the boundary
# $\sigma^2 = f^2/\omega^2 - 4\mu^2$ and the amplitude
# $a^2 = \frac{4\omega}{3\alpha}\bigl(\sigma \pm \sqrt{f^2/\omega^2 - 4\mu^2}\bigr)$, printed for
# $\omega = 1$. The pendulum is one with $f = -\tfrac12 z\Omega^2 = -2\omega^2 z$ and
# $\alpha = -\omega^2/6$:

# %%
f, alpha = -2 * omega**2 * z, -(omega**2) / 6
root = sp.sqrt(f**2 / omega**2 - 4 * mu**2)
for sign in (-1, 1):
    square = 4 * omega * (sigma + sign * root) / (3 * alpha)
    assert sp.expand(swinging.subs(a, sp.sqrt(P)).subs(P, square)) == 0

linear = eom.reparametrise({h: 0}).linearise().scale({z: 1, mu: 1})
rest = {order: linear.expand(order, {Omega: 2 * omega}) for order in (1, 2)}
lower, upper = rest[1].slow_flow.boundary()
assert sp.expand(lower + upper) == 0 and sp.expand(upper**2 - root**2) == 0
half, width = (4 * omega * part / (3 * alpha) for part in (sigma, root / 2))
display(Math(rf"a_\theta^2 = {sp.latex(half)} \pm {sp.latex(sp.factor(-2 * width))}"))
report.boundary(rest[2])

# %% [markdown]
# ## 3. To and fro: primary resonance
#
# Here the angle is of order ε, damping of order ε² and the motion of the support of order ε³; so
# they meet at order 2, with the first nonlinear term.

# %%
horizontal = eom.reparametrise({z: 0}).scale({h: 3, mu: 2}, amplitude=1)
horizontal.resonances(order=2)

# %%
to_fro = {order: horizontal.expand(order, {Omega: omega}) for order in (2, 3)}
for order in (1, 2, 3):
    display(report.solvability(to_fro[3], order))
report.modulation(to_fro[2])

# %% [markdown]
# Order 3 accounts for the force $h\Omega^2$ growing with the frequency. The printed response of the
# Duffing oscillator to a force $k\cos\Omega t$ is
#
# $$\left[\mu^2 + \left(\sigma - \frac{3\alpha a^2}{8\omega}\right)^2\right] a^2
#   = \frac{k^2}{4\omega^2},$$
#
# and the pendulum's is this with $\alpha = -\omega^2/6$ and $k = h\omega^2$:

# %%
relation = to_fro[2].slow_flow.response_relation()
k = h * omega**2
printed = (mu**2 + (sigma - 3 * alpha * a**2 / (8 * omega)) ** 2) * a**2 - k**2 / (4 * omega**2)
assert sp.expand(relation - 256 * printed) == 0
(backbone,) = to_fro[2].slow_flow.backbone().values()
assert sp.expand(backbone - 3 * alpha * a**2 / (8 * omega)) == 0
bend = sigma - backbone
Math(
    rf"\left[\mu^2 + \left({sp.latex(bend)}\right)^2\right] {sp.latex(a**2)} = "
    rf"{sp.latex(sp.expand(k**2 / (4 * omega**2)))}"
)

# %% [markdown]
# ## 4. On its head
#
# Upright, $\omega^2 = g/l$ changes its sign, and there is no leading oscillation to expand about.
# But the frequency $\nu$ with which the hanging pendulum swings, small and away from resonance, is
# known from the case without resonance, and $\nu^2$ is an analytic function of $\omega^2$ (the
# trace of the monodromy matrix, $2\cos(2\pi\nu/\Omega)$, is an entire one), so that it may be
# continued to negative values:

# %%
still = eom.reparametrise({h: 0, mu: 0}).linearise()
free = still.scale({z: 1}).expand(4)
(A,) = free.amplitudes
nu = omega + sum(sp.cancel(free.solvability[p][A] / (sp.I * A)) for p in (2, 4))
W = sp.Symbol("W", real=True)  # ω²
square = sp.expand(nu**2)
c_2, c_4 = (sp.cancel(square.coeff(z, p)).subs(omega, sp.sqrt(W)) for p in (2, 4))
terms = [sp.latex(sp.factor(part.subs(W, omega**2))) for part in (c_2, c_4)]
Math(rf"\nu^2 = \omega^2 + {terms[0]}\, z^2 + {terms[1]}\, z^4")

# %% [markdown]
# The upright pendulum neither falls nor swings where $\nu^2 = 0$. With $g/l$ for $-\omega^2$ that
# is a series in $z$, and Kapitza's condition $g/(l\Omega^2) < z^2/2$ is its first term:

# %%
first = c_2.subs(W, 0)
second = (c_4 - c_2 * c_2.diff(W)).subs(W, 0)
threshold = sp.expand((first * z**2 + second * z**4) / Omega**2)
assert threshold.coeff(z, 2) == sp.Rational(1, 2)
Math(rf"\frac{{g}}{{l\Omega^2}} < {sp.latex(threshold, order='rev-lex')}")

# %% [markdown]
# The same series follows from the first eigenvalue of Mathieu's equation, with
# $a = -4g/(l\Omega^2)$ and $q = 2z$ in $a_0(q) = -\tfrac12 q^2 + \tfrac{7}{128}q^4$ (NIST DLMF,
# equation 28.6.1). The support may also move too far: there the first tongue begins,
# $b_1(q) = 1 - q - \tfrac18 q^2 + \tfrac1{64} q^3 - \tfrac1{1536} q^4$ (28.6.3).

# %%
q = 2 * z
assert sp.expand(threshold + (-(q**2) / 2 + 7 * q**4 / 128) / 4) == 0

# %% [markdown]
# Floquet theory of the unexpanded equation about the upright position, at $\Omega = 1$ rad/s: the
# root of $g/l$ at which rest begins to be unstable, and what the series to order 2 and 4 leave:

# %%
upright = pendulum(-(omega**2)).reparametrise({h: 0, mu: 0}).linearise()
series = [sp.lambdify(z, sp.sqrt(part)) for part in (z**2 / 2, threshold)]
rows, gaps = [], []
for reach in (0.32, 0.16, 0.08):
    guess = series[1](reach)
    found = mg.floquet.boundary(
        upright, {"Omega": 1.0, "z": reach}, omega, (0.9 * guess, 1.1 * guess), points=21
    )
    exact = found.zones[0][0]
    gaps.append([abs(one(reach) - exact) for one in series])
    rows.append((f"{reach}", f"{exact:.6f}", *(f"{gap:.1e}" for gap in gaps[-1])))
report.Table(("z", "Floquet (rad/s)", "error, order 2", "error, order 4"), tuple(rows))

# %% [markdown]
# The error falls like $z^3$ and like $z^5$.
#
# ## 5. Certificates
#
# Motions of the slow flows beside motions of the exact equation, from the same state, over a time
# of order $1/\varepsilon$: the difference, over the order of the angle, has to fall like
# $\varepsilon^N$. Steady motions beside periodic orbits of the exact equation: their amplitudes
# likewise, and the exponents of disturbances with one order more.

# %%
VERTICAL = {"omega": 1.3, "z": 0.9, "mu": 0.31, "sigma": 0.77}
HORIZONTAL = {"omega": 1.3, "h": 2.1, "mu": 0.7, "sigma": 0.57}


def samples(case):
    """Values at ε = 1, generic ones."""
    return VERTICAL if case in up_down.values() else HORIZONTAL


def amplitudes(case):
    """Starting amplitude, and time in s at ε = 1."""
    return ([0.5 + 0.7j], 1.5) if case in up_down.values() else ([0.8 + 0.5j], 1.0)


def steady(case):
    """Steady motions, near those of the lowest order."""
    if case in up_down.values():
        return [mg.Steady(VERTICAL, [-0.2 + 1.5j])]
    return [mg.Steady(HORIZONTAL, [-0.49 - 0.47j])]


emission = mg.Emission(
    model="pendulum",
    cases=[*up_down.values(), *to_fro.values()],
    samples=samples,
    amplitudes=amplitudes,
    steady=steady,
    derivation="derivations/pendulum.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapters 4 and 5",
)
certificates = list(emission.certificates.values())
report.certificate_table(certificates)

# %% [markdown]
# Small oscillations, without the nonlinear terms, against Floquet theory: order $N + 1$.

# %%
SMALL = {"omega": 1.3, "z": 0.9, "mu": 0.31, "sigma": 0.37}
report.certificate_table([mg.certify(rest[2], SMALL)])

# %%
axes = plotting.convergence(certificates, quantity="motions at times of order 1/ε")

# %% [markdown]
# ## 6. Responses
#
# Steady amplitudes at $\omega = 1$ rad/s over the detuning of the support. Points: the fundamental
# of periodic orbits of the unexpanded equation, open where unstable. Left: up and down,
# $z = 0.03$, $\mu = 0.007$; middle: to and fro, $h = 0.01$, $\mu = 0.007$. Right: the upright
# pendulum is stable between the curves, from the series (dashed: to order 2) and from exact
# eigenvalues (points).

# %%
shaken = {omega: 1.0, z: 0.03, mu: 0.007, sigma: np.linspace(-0.14, 0.1, 481)}
pushed = {omega: 1.0, h: 0.01, mu: 0.007, sigma: np.linspace(-0.07, 0.05, 481)}
figure, (left, middle, right) = plt.subplots(1, 3, figsize=(9.6, 4.2), layout="constrained")
for panel, numbers, cases in ((left, shaken, up_down), (middle, pushed, to_fro)):
    highest = max(cases)
    for order, case in cases.items():
        response = case.slow_flow.frequency_response(numbers)
        points = mg.orbits_along(case, numbers, response, 24) if order == highest else ()
        plotting.frequency_response(
            response, [f"order {order}"], points=points, colour=order - 1, axes=panel
        )
    panel.set(xlabel="σ (rad/s)", ylabel="amplitude of θ (rad)")
    panel.locator_params(axis="x", nbins=5)
plotting.shared_legend([left, middle])

reach = np.linspace(0, 0.6, 121)
lower = sp.lambdify(z, threshold)(reach)
right.plot(lower, reach, color="black", lw=1.6, label="series")
right.plot(reach**2 / 2, reach, "--", color="black", lw=0.9, label="to order 2")
b_1 = np.polynomial.Polynomial([1, -1, -1 / 8, 1 / 64, -1 / 1536])
upper = -b_1(2 * reach) / 4
right.plot(upper, reach, color="black", lw=1.6)
right.fill_betweenx(reach, np.maximum(upper, 0), lower, color="0.9", lw=0, label="stable")
for exact in (mathieu_a(0, 2 * reach[::10]), mathieu_b(1, 2 * reach[::10])):
    right.plot(-exact / 4, reach[::10], "ko", ms=3.4, mfc="none", label="exact")
right.set(xlabel="g/(lΩ²)", ylabel="z", xlim=(0, 0.15), ylim=(0, 0.6), xticks=[0, 0.05, 0.1])
entries = dict(zip(*reversed(right.get_legend_handles_labels()), strict=True))
_ = right.legend(entries.values(), entries, frameon=False, fontsize="small", loc="lower right")

# %% [markdown]
# ## 7. The emitted functions
#
# ```python
# from mms_functions.pendulum import Omega_is_two_omega_order_2 as case
#
# rate = case.slow_flow([0.3 + 0.1j], omega=3.13, z=0.05, mu=0.02, sigma=-0.05)
# ```

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
