# %% [markdown]
# # Autoparametric pendulum absorber
#
# A pendulum hangs from a mass on a spring, and a force shakes the mass up and down at its natural
# frequency. If the pendulum's own frequency is half of that, the vertical motion excites it
# parametrically, and it takes the energy away: the mass stops growing with the force.
#
# Source: R. S. Haxton and A. D. S. Barr, "The autoparametric vibration absorber", *J. Engineering
# for Industry* 94 (1972) 119–125, with a beam in place of the pendulum; the formulas compared are
# those of A. H. Nayfeh and D. T. Mook, *Nonlinear Oscillations* (1979), chapter 6, for internal
# resonance 1:2 with the faster mode driven.

# %%
import numpy as np
import sympy as sp
from IPython.display import Markdown
from sympy.physics.mechanics import dynamicsymbols
from two_amplitudes import bifurcations, drawn, responses

import mmsgen as mg
from mmsgen import plotting, report

# %% [markdown]
# ## 1. Model
#
# $x$ is the displacement of the mass from static equilibrium, upwards; $\theta$ the angle of the
# pendulum, whose bob is at $(L\sin\theta,\; x - L\cos\theta)$. Sine and cosine are kept.

# %%
t = dynamicsymbols._t
x, theta = dynamicsymbols("x theta")
M, m, L, g, k, c_x, c_p, F, Omega = sp.symbols("M m L g k c_x c_p F Omega", positive=True)
dx, dtheta = x.diff(t), theta.diff(t)
model = mg.Model(
    lagrangian=(M + m) * dx**2 / 2
    + m * L * dx * dtheta * sp.sin(theta)
    + m * L**2 * dtheta**2 / 2
    - k * x**2 / 2
    - m * g * L * (1 - sp.cos(theta)),
    coordinates=[x, theta],
    parameters=[
        mg.Parameter(M, "kg", "mass"),
        mg.Parameter(m, "kg", "mass of the bob"),
        mg.Parameter(L, "m", "length of the pendulum"),
        mg.Parameter(g, "m/s^2", "gravity"),
        mg.Parameter(k, "N/m", "spring"),
        mg.Parameter(c_x, "N s/m", "damper of the mass"),
        mg.Parameter(c_p, "N m s", "damper of the pendulum"),
        mg.Parameter(F, "N", "force"),
        mg.Parameter(Omega, "rad/s", "frequency of the force"),
    ],
    dissipation=c_x * dx**2 / 2 + c_p * dtheta**2 / 2,
    forces={x: F * sp.cos(Omega * t)},
)
exact = model.equations_of_motion()
report.equations(exact)

# %% [markdown]
# In frequencies and ratios, $M$ and $m$ cancel:

# %%
omega_x, omega_p, r = sp.symbols("omega_x omega_p r", positive=True)
mu_x, mu_p, f = sp.symbols("mu_x mu_p f", nonnegative=True)
eom = exact.reparametrise(
    {
        M: m * (1 - r) / r,
        k: omega_x**2 * m / r,
        g: omega_p**2 * L,
        c_x: 2 * mu_x * m / r,
        c_p: 2 * mu_p * m * L**2,
        F: f * L * m / r,
    },
    parameters=[
        mg.Parameter(omega_x, "rad/s", "natural frequency of the mass with the bob"),
        mg.Parameter(omega_p, "rad/s", "natural frequency of the pendulum"),
        mg.Parameter(r, "1", "mass of the bob over both masses, m/(M + m)"),
        mg.Parameter(mu_x, "1/s", "damping of the mass"),
        mg.Parameter(mu_p, "1/s", "damping of the pendulum"),
        mg.Parameter(f, "1/s^2", "force over both masses and the length, F/((M + m) L)"),
    ],
    eliminate=[m],
)
report.parameter_table(eom.parameters)

# %%
report.equations(eom)

# %% [markdown]
# ## 2. Orders and resonances
#
# Both amplitudes are of order ε, so that the quadratic coupling is of order ε beside the linear
# terms, and the mass ratio may be as large as it likes. Damping is of order ε, the force of order
# $\varepsilon^2$.

# %%
scaled = eom.scale({mu_x: 1, mu_p: 1, f: 2}, amplitude=1)
scaled.resonances(order=2)

# %% [markdown]
# ## 3. The absorber at work
#
# $\omega_x = 2\omega_p + \varepsilon\sigma_1$ and $\Omega = \omega_x + \varepsilon\sigma_2$.

# %%
tuned = {omega_x: 2 * omega_p, Omega: omega_x}
working = {order: scaled.expand(order, tuned) for order in (1, 2)}
report.solvability(working[1], 1)

# %%
report.solvability(working[2], 2)

# %%
report.modulation(working[1])

# %% [markdown]
# Order 1 is the slow flow of chapter 6 of Nayfeh and Mook, for
# $\ddot u_1 + \omega_1^2 u_1 + 2\mu_1\dot u_1 = \alpha_1 u_1 u_2$ and
# $\ddot u_2 + \omega_2^2 u_2 + 2\mu_2\dot u_2 = \alpha_2 u_1^2 + F_2\cos\Omega t$
# with $u_1 = \theta$, $u_2 = x$ and
#
# $$\alpha_1 = \frac{4\omega_p^2}{L}, \qquad \alpha_2 = 2 r L\,\omega_p^2, \qquad
#   F_2 = f L.$$
#
# Its formulas, with $\omega_2 = 2\omega_1$, read
# $a_x = 2\omega_p\alpha_1^{-1}[4\mu_p^2 + (\sigma_1 + \sigma_2)^2]^{1/2}$ and
# $a_\theta = 2\{-\Gamma_1 \pm [(F_2/2\alpha_2)^2 - \Gamma_2^2]^{1/2}\}^{1/2}$.
# From the slow flow, by setting its left-hand sides to zero and eliminating the phases:

# %%
sigma_1, sigma_2 = (relation.detuning for relation in working[1].relations)
rates = working[1].slow_flow.polar
(a_x, gamma_x), (a_theta, gamma_theta) = list(rates)[:2], list(rates)[2:]
S, C = sp.symbols("S C")  # sine and cosine of 2γ_θ − γ_x
difference = 2 * gamma_theta - gamma_x
plain = {
    s: sp.expand(rate).subs({sp.sin(difference): S, sp.cos(difference): C})
    for s, rate in rates.items()
}
angle = sp.solve([plain[a_theta] / a_theta, plain[gamma_theta]], [S, C], dict=True)[0]
held = sp.solve(sp.numer(sp.together(angle[S] ** 2 + angle[C] ** 2 - 1)), a_x**2)[0]
report.expression("a_x^2", sp.factor(held))

# %% [markdown]
# The force is not in it. With perfect tuning, $\sigma_1 = \sigma_2 = 0$, the mass is held at
# $a_x = L\mu_p/\omega_p$: the damping ratio of the pendulum times its length, whatever
# the force. The amplitude of the pendulum:

# %%
sine = sp.solve(plain[a_x], sp.sin(gamma_x))[0].subs(angle)
cosine = sp.solve(plain[gamma_x], sp.cos(gamma_x))[0].subs(angle)
response = sp.expand(f**2 * (sine**2 + cosine**2 - 1)).subs(a_x**2, held)

alpha_1, alpha_2 = 4 * omega_p**2 / L, 2 * r * L * omega_p**2
factor = 2 * omega_p * 2 * omega_p / (alpha_1 * alpha_2)
Gamma_1 = factor * (2 * mu_p * mu_x - sigma_2 * (sigma_1 + sigma_2))
Gamma_2 = factor * (2 * mu_p * sigma_2 + mu_x * (sigma_1 + sigma_2))
printed = (a_theta**2 / 4 + Gamma_1) ** 2 + Gamma_2**2 - (f * L / (2 * alpha_2)) ** 2
printed_held = (2 * omega_p / alpha_1) ** 2 * (4 * mu_p**2 + (sigma_1 + sigma_2) ** 2)
assert sp.expand(held - printed_held) == 0
assert sp.cancel(response * (L / (2 * alpha_2)) ** 2 - printed) == 0
report.expression("0", printed)

# %% [markdown]
# Both printed formulas are reproduced exactly. Tuned perfectly, the pendulum swings with

# %%
swing = 4 * (f * L / (2 * alpha_2) - Gamma_1)
report.expression(r"a_\theta^2", sp.expand(swing.subs({sigma_1: 0, sigma_2: 0})))

# %% [markdown]
# ## 4. Over force and frequency
#
# All equilibria at perfect tuning, over the force: the pendulum hangs still until the mass shakes
# by $L\mu_p/\omega_p$, and then takes everything. Points: periodic orbits of the unexpanded
# equations, with the harmonics $\Omega$ of $x$ and $\Omega/2$ of $\theta$.

# %%
NUMBERS = {"L": 1.0, "r": 0.2, "omega_p": 1.0, "mu_x": 0.02, "mu_p": 0.02, "sigma_1": 0.0}
LABELS = ["$a_x$ (m)", "$a_\\theta$ (rad)"]
over = {**NUMBERS, "sigma_2": 0.0, "f": np.linspace(0, 0.03, 201)}
figure = drawn(working, over, "f (1/s²)", LABELS)

# %% [markdown]
# Over the frequency of the force. On the dashed branch with a peak the pendulum is at rest: so high
# would the mass be shaken without an absorber, and between the pitchforks that is unstable. Outside
# of them the pendulum may be at rest or swing, up to the saddle-nodes. Order 1 is the formula.

# %%
over = {**NUMBERS, "f": 0.02, "sigma_2": np.linspace(-0.18, 0.18, 401)}
absorber_figure = drawn(working, over, r"$\sigma_2 = \Omega - \omega_x$ (rad/s)", LABELS, 30)

at = {p.symbol: over[p.name] for p in working[1].parameters if p.name in over}
by_formula = sp.lambdify(sigma_2, held.subs({k: x for k, x in at.items() if k != sigma_2}))
branches = responses(working, over)[1].branches
moving = next(b for b in branches if b.modulus[:, 1].max() > 0)
swinging = moving.modulus[:, 1] > 0.01
gap = moving.modulus[swinging, 0] ** 2 - by_formula(moving.parameter[swinging])
assert np.abs(gap).max() < 1e-12

# %% [markdown]
# ## 5. Evidence
#
# Motions of the slow flow beside motions of the unexpanded equations, over times of order
# $1/\varepsilon$: the distance, relative to the amplitude, must fall like $\varepsilon^N$. So must
# the error of the steady amplitudes beside those of periodic orbits. The rates at which
# disturbances of them die out are better by one order, and so are the frequencies at which the
# pendulum begins to swing, where the period of the exact motion doubles, and at which two swings
# meet.

# %%
GENERIC = {"L": 1.3, "r": 0.3, "omega_p": 0.67, "mu_x": 0.11, "mu_p": 0.07, "f": 0.5,
           "sigma_1": 0.23, "sigma_2": -0.31}  # fmt: skip
STEADY = {"L": 1.3, "r": 0.3, "omega_p": 0.67, "mu_x": 0.11, "mu_p": 0.17, "f": 0.9,
          "sigma_1": 0.13, "sigma_2": -0.11}  # fmt: skip
BENT = {**STEADY, "sigma_2": np.linspace(-1, 1, 301)}
working_motion = working[1].slow_flow.equilibria(STEADY).amplitudes[-1]
emission = mg.Emission(
    model="autoparametric_absorber",
    cases=list(working.values()),
    samples=lambda case: GENERIC,
    derivation="derivations/autoparametric_absorber.py",
    source="Haxton and Barr, J. Engineering for Industry 94 (1972) 119-125",
    amplitudes=lambda case: ([0.2 + 0.3j, -0.2 + 0.4j], 0.7),
    steady=lambda case: [
        mg.Steady(STEADY, list(working_motion)),
        *bifurcations(working[1], BENT, ["pitchfork", "saddle-node"]),
    ],
)
certificates = emission.certificates
report.certificate_table(certificates.values())

# %%
axes = plotting.convergence(
    list(certificates.values()), ["order 1", "order 2"], quantity="motions at times of order 1/ε"
)

# %% [markdown]
# ## 6. The emitted functions
#
# Each module holds `slow_flow`, the rates of the complex amplitudes, and what follows from it:
# `equilibria`, `frequency_response`, `stability`, `response`.

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
