# %% [markdown]
# # Internal resonance 1:1: the spherical pendulum
#
# A pendulum that is free to swing in all directions has two coordinates of the same frequency.
# For small swings they know nothing of each other; but the cubic terms turn an ellipse slowly
# round, and a pendulum that is shaken along one direction leaves the plane and whirls.
#
# Sources: G. B. Airy, "On the vibration of a free pendulum in an oval differing little from a
# straight line", *Memoirs of the Royal Astronomical Society* 20 (1851), for the free pendulum; J.
# W. Miles, "Stability of forced oscillations of a spherical pendulum", *Quarterly of Applied
# Mathematics* 20 (1962) 21–32, for the forced one.

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown
from sympy.physics.mechanics import dynamicsymbols
from two_amplitudes import drawn

import mmsgen as mg
from mmsgen import plotting, report

# %% [markdown]
# ## 1. Model
#
# The bob is at $(x, y, z)$ from the pivot, $z = \sqrt{L^2 - x^2 - y^2}$ downwards, and $g =
# \omega_x^2 L$. The thread pulls it back by $\Lambda(x, y, z)$, where $\Lambda L^2 = v^2 + gz +
# xP_x + yP_y$ follows from $x\ddot x + y\ddot y + z\ddot z + v^2 = 0$. The pivot shakes along
# $x$, which acts like the force $P_x = fL\cos\Omega t$; a light spring at the side, $P_y =
# -(\omega_y^2 - \omega_x^2)y$, lets the two frequencies differ. Nothing is expanded.

# %%
t = dynamicsymbols._t
x, y = dynamicsymbols("x y")
omega_x, omega_y, Omega, L = sp.symbols("omega_x omega_y Omega L", positive=True)
mu, f = sp.symbols("mu f", nonnegative=True)

z = sp.sqrt(L**2 - x**2 - y**2)
dx, dy = x.diff(t), y.diff(t)
speed_squared = dx**2 + dy**2 + (x * dx + y * dy) ** 2 / z**2
P_x = f * L * sp.cos(Omega * t)
P_y = -(omega_y**2 - omega_x**2) * y
tension = (speed_squared + omega_x**2 * L * z + x * P_x + y * P_y) / L**2
model = mg.Model.from_equations(
    [
        x.diff(t, 2) + 2 * mu * dx + tension * x - P_x,
        y.diff(t, 2) + 2 * mu * dy + tension * y - P_y,
    ],
    [x, y],
    [
        mg.Parameter(L, "m", "length"),
        mg.Parameter(omega_x, "rad/s", "frequency of small swings along x"),
        mg.Parameter(omega_y, "rad/s", "frequency of small swings along y"),
        mg.Parameter(mu, "1/s", "damping"),
        mg.Parameter(f, "1/s^2", "acceleration of the pivot over the length"),
        mg.Parameter(Omega, "rad/s", "frequency of the pivot"),
    ],
)
eom = model.equations_of_motion()
report.parameter_table(eom.parameters)

# %%
report.equations(eom, only=[y])

# %% [markdown]
# ## 2. Orders and resonances
#
# Swings of order ε. Cubic terms are of order $\varepsilon^2$ beside the linear ones, and so are the
# damping and, beside a swing of order ε, an acceleration of order $\varepsilon^3$.

# %%
scaled = eom.scale({mu: 2, f: 3}, amplitude=1)
scaled.resonances(order=2)

# %% [markdown]
# ## 3. Free motion, $\omega_y = \omega_x + \varepsilon\sigma$
#
# Order 1 holds the detuning alone. Order 2:

# %%
free = {order: scaled.expand(order, {omega_y: omega_x}) for order in (2, 4)}
report.solvability(free[2], 2)

# %%
report.modulation(free[2])

# %% [markdown]
# ### An ellipse turns: Airy's formula
#
# For equal frequencies, an ellipse of semiaxes $a$ and $b$, $A_x = a/2$ and $A_y = -ib/2$, that
# turns with the rate $p$ while its motion gains the phase $\delta t$ has $\dot A_x = i\delta A_x
# - pA_y$ and $\dot A_y = i\delta A_y + pA_x$. The slow flow is of that form:

# %%
a, b, p, delta = sp.symbols("a b p delta", real=True)
A_x, A_y = free[2].amplitudes
sigma = free[2].relations[0].detuning


def on_ellipse(flow):
    """The rates of A_x and A_y for an ellipse of a free symmetric pendulum."""
    bars = {sp.conjugate(A_x): a / 2, sp.conjugate(A_y): sp.I * b / 2}
    axes = {A_x: a / 2, A_y: -sp.I * b / 2, sigma: 0, mu: 0}
    return [sp.expand(flow[A].subs(bars).subs(axes)) for A in (A_x, A_y)]


rates = on_ellipse(free[2].slow_flow.complex)
turning = sp.solve(
    [
        sp.expand((rates[0] - sp.I * delta * a / 2 - sp.I * p * b / 2) / sp.I),
        rates[1] - delta * b / 2 - p * a / 2,
    ],
    [p, delta],
    dict=True,
)[0]
assert sp.cancel(turning[p] - sp.Rational(3, 8) * omega_x * a * b / L**2) == 0
report.expression("p", sp.factor(turning[p]))

# %% [markdown]
# $p = \tfrac38\,\omega\,ab/L^2$: Airy's formula, exactly. It is what spoils a Foucault pendulum.
#
# ### The conical pendulum
#
# On a circle, $b = a$, the motion is known: a single harmonic of the frequency
# $\omega_x(1 - a^2/L^2)^{-1/4}$. So the slow flow has to give its series at any order; to order 6:

# %%
symmetric = eom.reparametrise({omega_y: omega_x, mu: 0, f: 0}).scale({}, amplitude=1)
circling = on_ellipse(symmetric.expand(6).slow_flow.complex)[0].subs(b, a)
shift = sp.expand(circling / (sp.I * a / 2))
s = sp.Symbol("s")
series = sp.series((1 - s) ** sp.Rational(-1, 4), s, 0, 4).removeO().subs(s, a**2 / L**2)
assert sp.expand(omega_x + shift - omega_x * series) == 0
report.expression(r"\omega", omega_x + shift)

# %% [markdown]
# ## 4. Shaken, $\Omega = \omega_x + \varepsilon\sigma_2$

# %%
shaken = scaled.expand(2, {omega_y: omega_x, Omega: omega_x})
report.modulation(shaken)

# %% [markdown]
# ### In the plane
#
# With $a_y = 0$ the pendulum is a softening Duffing oscillator, $a_x^2[\mu^2 + (\sigma_2 +
# \omega_xa_x^2/16L^2)^2] = (fL/2\omega_x)^2$. A small $A_y$ obeys a linear equation in which the
# swing along $x$ is a parametric excitation. With $A_y = \tfrac12(u + iv)e^{i\gamma_x}$ the
# matrix of $(u, v)$ has the determinant

# %%
sigma_1, sigma_2 = (relation.detuning for relation in shaken.relations)
a_x = sp.Symbol("a_x", positive=True)
u, v = sp.symbols("u v", real=True)
B = (u + sp.I * v) / 2
aside = shaken.slow_flow.autonomous[A_y].subs(sp.conjugate(A_y), sp.conjugate(B)).subs(A_y, B)
aside = sp.expand(2 * aside.subs({sp.conjugate(A_x): a_x / 2}).subs(A_x, a_x / 2))
aside = aside.subs({u**2: 0, v**2: 0, u * v: 0, u**3: 0, v**3: 0})
jacobian = sp.Matrix([sp.re(aside), sp.im(aside)]).jacobian([u, v]).subs({u: 0, v: 0})
determinant = sp.expand(jacobian.det())
scale = omega_x * a_x**2 / L**2
wanted = mu**2 + (sigma_1 - sigma_2 + scale / 8) ** 2 - (3 * scale / 16) ** 2
assert sp.expand(determinant - wanted) == 0
report.expression(r"\det", wanted)

# %% [markdown]
# The swing in the plane is unstable where it is negative. Without damping, and with $\omega_y =
# \omega_x$, that is $-\tfrac1{16} < \sigma_2L^2/(\omega_xa_x^2) < \tfrac5{16}$. In phase with the
# force, $\sigma_2 = fL/(2\omega_xa_x) - \omega_xa_x^2/16L^2$, so that the upper limit is where
# $a_x^3 = \tfrac43 fL^3/\omega_x^2$. In antiphase there is a swing, a stable one, up to the fold
# at $a_x^3 = 4fL^3/\omega_x^2$. In Miles' measure of detuning, $\nu =
# (2\sigma_2/\omega_x)(f/\omega_x^2)^{-2/3}$, no swing in the plane is stable in between:

# %%
h = f / omega_x**2
in_phase = f * L / (2 * omega_x * a_x) - omega_x * a_x**2 / (16 * L**2)
antiphase = -f * L / (2 * omega_x * a_x) - omega_x * a_x**2 / (16 * L**2)
upper_swing, fold_swing = L * sp.cbrt(4 * h / 3), L * sp.cbrt(4 * h)
upper_gap = in_phase - sp.Rational(5, 16) * scale
assert sp.powsimp(sp.expand(upper_gap.subs(a_x, upper_swing)), force=True) == 0
assert sp.powsimp(sp.expand(antiphase.diff(a_x).subs(a_x, fold_swing)), force=True) == 0

one = {f: 1, omega_x: 1, L: 1}
nu_high = 2 * in_phase.subs(a_x, upper_swing).subs(one)
nu_low = 2 * antiphase.subs(a_x, fold_swing).subs(one)
assert nu_high - sp.Rational(5, 8) * sp.Rational(4, 3) ** sp.Rational(2, 3) == 0
assert sp.nsimplify(nu_low + 3 * sp.Rational(2) ** sp.Rational(-5, 3)) == 0
print(f"unstable for {sp.N(nu_low, 3)} < ν < {sp.N(nu_high, 3)}")

# %% [markdown]
# These are the bounds that Miles gives, −0.945 and 0.757: $\nu_- = -3\cdot2^{-5/3}$ and
# $\nu_+ = \tfrac58(\tfrac43)^{2/3}$.
#
# ### Out of the plane
#
# All equilibria over ν, lightly damped. Along the straight line of the right panel the pendulum
# stays in the plane; at the pitchforks, which are close to the bounds of Miles, it leaves it to
# whirl. Between two Hopf points the whirling motion is unstable too, and for most of these ν no
# steady motion is left that is stable. Points: periodic orbits of the unexpanded equations.

# %%
NUMBERS = {"L": 1.0, "omega_x": 1.0, "mu": 0.008, "f": 0.01, "sigma_1": 0.0}
unit = NUMBERS["f"] ** (2 / 3) / 2  # of the detuning, where ν is 1
over = {**NUMBERS, "sigma_2": unit * np.linspace(-3, 3, 401)}
whirls = drawn({2: shaken}, over, "ν", ["$a_x$ (m)", "$a_y$ (m)"], 30, scale=1 / unit)

# %% [markdown]
# Two of the stable motions seen from above.

# %%
orbit_figure, panels = plt.subplots(1, 2, figsize=(6.4, 3.8), layout="constrained", sharey=True)
turn = np.exp(1j * np.linspace(0, 2 * np.pi, 129))
for axes, number in zip(panels, (0.4, 1.2), strict=True):
    here = {**NUMBERS, "sigma_2": unit * number}
    found = shaken.slow_flow.equilibria(here)
    (stable,) = found.amplitudes[found.stable][:1]
    orbit = mg.orbit_near(shaken, here, stable).orbit
    assert orbit.stable
    exact = orbit(np.linspace(0, orbit.period, 129))
    axes.plot(*exact[:2], color="0.72", lw=2.4, label="periodic orbit")
    drawn_ellipse = 2 * (stable[:, None] * turn).real
    axes.plot(*drawn_ellipse, color=plotting.COLOURS[1], lw=1.1, label="slow flow, order 2")
    axes.set(
        title=f"ν = {number}", xlabel="x (m)", aspect="equal", xlim=(-0.4, 0.4), ylim=(-0.4, 0.4)
    )
panels[0].set_ylabel("y (m)")
legend = orbit_figure.legend(
    *panels[0].get_legend_handles_labels(), frameon=False, loc="outside lower center", ncols=2
)

# %% [markdown]
# ## 5. Evidence
#
# Motions of the slow flow beside motions of the unexpanded equations, over times of order
# $1/\varepsilon$: the distance, relative to the swing, must fall like $\varepsilon^N$. So must
# the error of the amplitudes of a whirling motion beside those of the periodic orbit; the rates at
# which disturbances of it die out or grow are better by one order, and so is the frequency at which
# the pendulum leaves the plane, beside that at which the exact orbit in the plane loses its
# stability.

# %%
GENERIC = {"omega_x": 0.67, "L": 1.2, "mu": 0.3, "f": 0.5, "sigma": 0.2, "sigma_1": 0.2,
           "sigma_2": 0.3}  # fmt: skip


def samples(case):
    """Generic values of the parameters of a case, at ε = 1; Ω far from resonance unless tuned."""
    wanted = {q.name for q in case.parameters} - set(case.weak.detuned)
    return {name: value for name, value in {**GENERIC, "Omega": 1.7}.items() if name in wanted}


WHIRLING = {"L": 1.0, "omega_x": 1.0, "mu": 0.1, "f": 0.3, "sigma_1": 0.0, "sigma_2": 0.1}
LEAVING = mg.Steady({**WHIRLING, "sigma_2": 0.128}, [-0.33 - 0.2j, 0], "pitchfork", "sigma_2")
found = shaken.slow_flow.equilibria(WHIRLING)
whirling = found.amplitudes[found.modulus[:, 1] > 0][0]
cases = [*free.values(), shaken]
emission = mg.Emission(
    model="internal_resonance_1_1",
    cases=cases,
    samples=samples,
    derivation="derivations/internal_resonance_1_1.py",
    source="Miles, Quarterly of Applied Mathematics 20 (1962) 21-32",
    amplitudes=lambda case: ([1.1 + 0.8j, -0.6 + 1.2j], 0.6),
    steady=lambda case: [mg.Steady(WHIRLING, list(whirling)), LEAVING] if case is shaken else [],
)
certificates = emission.certificates
report.certificate_table(certificates.values())

# %%
axes = plotting.convergence(
    list(certificates.values()),
    ["free, order 2", "free, order 4", "shaken, order 2"],
    quantity="motions at times of order 1/ε",
)

# %% [markdown]
# ## 6. The emitted functions
#
# Each module holds `slow_flow`, the rates of the complex amplitudes, and what follows from it:
# `equilibria`, `frequency_response`, `stability`, `response`.

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
