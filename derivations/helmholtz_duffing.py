# %% [markdown]
# # An oscillator with quadratic and cubic stiffness
#
# A preloaded spring, a cable with sag, a curved beam: the restoring force is not the same on both
# sides. Its quadratic part leaves no trace in the slow flow of order 1, softens the oscillator at
# order 2, where the cubic part enters as well, and makes it drift to one side.
#
# The result to order 2 is that of Nayfeh and Mook, *Nonlinear Oscillations* (1979), chapter 2,
# for $\ddot u + \omega_0^2 u + \alpha_2 u^2 + \alpha_3 u^3 = 0$; order 4 is compared with the exact
# period. With $\alpha_3 = 0$ the equation bears the name of Helmholtz, with $\alpha_2 = 0$ that of
# Duffing.

# %%
import matplotlib.pyplot as plt
import mpmath as mp
import numpy as np
import sympy as sp
from IPython.display import Markdown, display
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.symbols import modulus, phase, time_scale

# %% [markdown]
# ## 1. The model
#
# $$L = \tfrac12 \dot u^2 - \tfrac12 \omega_0^2 u^2 - \tfrac13 \alpha_2 u^3
#   - \tfrac14 \alpha_3 u^4$$

# %%
t = dynamicsymbols._t
u = dynamicsymbols("u")
omega_0 = sp.Symbol("omega_0", positive=True)
alpha_2, alpha_3 = sp.symbols("alpha_2 alpha_3", real=True)
potential = omega_0**2 * u**2 / 2 + alpha_2 * u**3 / 3 + alpha_3 * u**4 / 4
model = mg.Model(
    lagrangian=u.diff(t) ** 2 / 2 - potential,
    coordinates=[u],
    parameters=[
        mg.Parameter(omega_0, "rad/s", "frequency of small oscillations"),
        mg.Parameter(alpha_2, "1/(m s^2)", "quadratic stiffness over the mass"),
        mg.Parameter(alpha_3, "1/(m^2 s^2)", "cubic stiffness over the mass"),
    ],
)
report.parameter_table(model.parameters)

# %%
eom = model.equations_of_motion()
report.equations(eom)

# %% [markdown]
# ## 2. Orders in ε
#
# No parameter is small here but the amplitude: $u$ is of order ε, and the quadratic term is one
# order, the cubic term two orders smaller than the linear one. In the hierarchy
# $u = \varepsilon(u_0 + \varepsilon u_1 + \varepsilon^2 u_2 + \dots)$:

# %%
scaled = eom.scale({}, amplitude=1)
for p in range(3):
    display(report.orders(scaled, p))

# %% [markdown]
# ## 3. Slow flow to order 4

# %%
cases = {order: scaled.expand(order) for order in (2, 4)}
for p in (1, 2, 3, 4):
    display(report.solvability(cases[4], p))

# %% [markdown]
# Odd orders vanish: a shift of time by half a period turns $a$ into $-a$. In polar form:

# %%
report.modulation(cases[2])

# %% [markdown]
# ## 4. The printed formulas
#
# The frequency to order 2,
#
# $$\omega = \omega_0 + \frac{9\alpha_3\omega_0^2 - 10\alpha_2^2}{24\,\omega_0^3}\,a^2 .$$

# %%
a, gamma = modulus(u), phase(u)
shift = cases[2].slow_flow.backbone()[gamma]
printed = (9 * alpha_3 * omega_0**2 - 10 * alpha_2**2) * a**2 / (24 * omega_0**3)
assert sp.cancel(shift - printed) == 0

# %% [markdown]
# The motion to the same order,
# $u = a\cos\psi + \dfrac{\alpha_2 a^2}{6\omega_0^2}(\cos 2\psi - 3)$, drifts to the side on which
# the spring is softer:

# %%
psi, T_0 = sp.Symbol("psi", real=True), time_scale(0)
turning = {cases[4].amplitudes[0]: a / 2, T_0: psi / omega_0}
parts = [cases[4].particular(p)[u].subs(turning) for p in range(4)]
first = alpha_2 * a**2 * (sp.cos(2 * psi) - 3) / (6 * omega_0**2)
assert sp.expand((parts[1] - first).rewrite(sp.exp)) == 0

# %% [markdown]
# Order 4 adds a term in $a^4$. It is written here for the amplitude of the fundamental; another
# definition of the amplitude changes this term, and the one in $a^2$ not.

# %%
report.modulation(cases[4])

# %% [markdown]
# ## 5. The exact period
#
# Energy is conserved, so the time from one turning point to the other is an integral, which mpmath
# gives in as many digits as wanted. For an amplitude $a$ the expansion gives the turning point
# at $\psi = 0$; from there the exact motion starts. The relative error of the frequency:

# %%
numbers = {omega_0: sp.Integer(1), alpha_2: sp.Rational(3, 5), alpha_3: sp.Rational(1, 4)}
start = sp.lambdify(a, sum(parts).subs({psi: 0, **numbers}), "mpmath")
series = {
    n: sp.lambdify(a, (omega_0 + case.slow_flow.polar[gamma]).subs(numbers), "mpmath")
    for n, case in cases.items()
}


def exact_frequency(right):
    """2π over the period of the motion that turns at u = right, numbers as above."""
    x = sp.Symbol("x")
    level = potential.subs({u: x, **numbers})
    gap = sp.Poly(level.subs(x, sp.Float(str(right), 40)) - level, x)
    # Both turning points are simple zeros; the other two zeros are complex or lie further out.
    zeros = mp.polyroots([mp.mpf(str(c)) for c in gap.all_coeffs()], maxsteps=200, extraprec=80)
    low, high = sorted((mp.re(z) for z in zeros if abs(mp.im(z)) < 1e-20), key=abs)[:2]
    low, high = min(low, high), max(low, high)
    others = sp.lambdify(x, sp.quo(gap, sp.Poly((x - low) * (x - high), x)).as_expr(), "mpmath")
    middle, half = (low + high) / 2, (high - low) / 2
    # x = middle + half sin θ takes the zeros out of the root.
    return mp.pi / mp.quad(
        lambda s: 1 / mp.sqrt(-2 * others(middle + half * mp.sin(s))), [-mp.pi / 2, mp.pi / 2]
    )


with mp.workdps(30):
    amplitudes = [mp.mpf(2) ** -k for k in range(1, 7)]
    exact = [exact_frequency(start(x)) for x in amplitudes]
    errors = {n: [abs(f(x) / w - 1) for x, w in zip(amplitudes, exact)] for n, f in series.items()}
rows = [
    (f"1/{2 ** (k + 1)}", *(f"{float(errors[n][k]):.0e}" for n in errors))
    for k in range(len(amplitudes))
]
report.Table(("$a$ (m)", *(f"order {n}" for n in errors)), tuple(rows))

# %% [markdown]
# Halving the amplitude divides the error by 16 at order 2, by 64 at order 4.

# %%
for n, values in errors.items():
    ratio = values[-2] / values[-1]
    print(f"order {n}: {float(ratio):.1f}")
    assert abs(ratio / 2 ** (n + 2) - 1) < 0.05

# %% [markdown]
# The backbone curves of the same numbers at larger amplitudes, beside periodic motions found by
# collocation, whose frequency is that of the integral; $a$ is the amplitude of their fundamental.
# The oscillator softens first and hardens later, which order 4 knows and order 2 does not.

# %%
sizes = np.linspace(0.0, 1.4, 121)
curves = {}
for n, case in cases.items():
    shift = sp.lambdify(a, case.slow_flow.backbone()[gamma].subs(numbers))
    curves[f"order {n}"] = (1 + shift(sizes), sizes)
problem = mg.orbits.problem(eom, {x: float(number) for x, number in numbers.items()})
orbits = []
for size in np.linspace(0.1, 1.3, 13):
    turning = start(mp.mpf(size))
    with mp.workdps(30):
        speed = float(exact_frequency(turning))
    # A whole family of orbits passes by, and the nearest to the guess is found. The guess is a
    # motion integrated from this state with a relative tolerance of 1e-6 a step.
    orbit = mg.orbits.find(problem, [float(turning), 0.0], 2 * np.pi / speed, isolated=False)
    assert abs(2 * np.pi / orbit.period - speed) < 1e-5
    orbits.append((2 * np.pi / orbit.period, orbit.amplitude()))
plotting.backbone(curves, tuple(np.transpose(orbits)), xlabel="ω (rad/s)", ylabel="a (m)")
plt.show()

# %% [markdown]
# ## 6. Certificates
#
# Motions of the emitted slow flow beside time integration of the exact equation, over times of
# order $1/\varepsilon$ and relative to the amplitude: the distance falls like $\varepsilon^N$ or
# faster.

# %%
emission = mg.Emission(
    model="helmholtz_duffing",
    cases=list(cases.values()),
    samples=lambda case: {"omega_0": 1.5, "alpha_2": 1.0, "alpha_3": 1.0},
    amplitudes=lambda case: ([1.1 + 0.8j], 0.9),
    derivation="derivations/helmholtz_duffing.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 2",
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
# ## 7. The emitted functions
#
# ```python
# from mms_functions.helmholtz_duffing import nonresonant_order_4 as case
#
# shift = case.backbone(0.5, omega_0=1.0, alpha_2=0.6, alpha_3=0.25)
# ```

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
