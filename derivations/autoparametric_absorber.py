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
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.loading import load

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
# ## 4. Over frequency
#
# Amplitude of the mass while the frequency of the force passes through resonance. Grey: the
# pendulum locked. Coloured: with the absorber, from the slow flows of order 1 (the formula) and of
# order 2 (its equilibria, found numerically from the emitted functions). Dots: the unexpanded
# equations, integrated until the motion is steady.

# %%
AT = {"L": 1.0, "r": 0.2, "omega_x": 2.0, "omega_p": 1.0, "mu_x": 0.02, "mu_p": 0.02,
      "f": 0.02}  # fmt: skip
numbers = {p.symbol: AT[p.name] for p in eom.parameters if p.name in AT}
solved = sp.solve(eom.equations, [x.diff(t, 2), theta.diff(t, 2)])
accelerations = sp.lambdify(
    [t, (x, theta), (dx, dtheta), Omega],
    [solved[q.diff(t, 2)].subs(numbers) for q in (x, theta)],
    "math",
)


def steady(frequency, begin, settle=70, periods=8):
    """Amplitude of the harmonic Ω of x, once transients are gone."""
    period = 4 * np.pi / frequency
    window = np.linspace(settle * period, (settle + periods) * period, 64 * periods, endpoint=False)

    def state(time, s):
        s = s.tolist()
        return [*s[2:], *accelerations(time, s[:2], s[2:], frequency)]

    motion = solve_ivp(state, (0, window[-1]), begin, "DOP853", window, rtol=1e-7, atol=1e-9).y
    return 2 * abs(np.mean(motion[0] * np.exp(-1j * frequency * window)))


# %%
emitted = {order: load(case) for order, case in working.items()}
first = {"L": AT["L"], "r": AT["r"], "omega_p": AT["omega_p"], "f": AT["f"],
         "mu_x": AT["mu_x"], "mu_p": AT["mu_p"], "sigma_1": 0.0}  # fmt: skip


def equilibrium(order, sigma, guess):
    """Complex amplitudes (B_x, B_θ) at rest, from a guess nearby."""

    def rest(parts):
        b = parts[:2] + 1j * parts[2:]
        rate = emitted[order].slow_flow(b, sigma_2=sigma, **first)
        return np.concatenate([rate.real, rate.imag])

    parts = fsolve(rest, np.concatenate([guess.real, guess.imag]), xtol=1e-12)
    return parts[:2] + 1j * parts[2:]


detunings = np.linspace(-0.06, 0.06, 61)
middle = len(detunings) // 2
lines = {}
for order in (1, 2):
    found = np.empty((len(detunings), 2), dtype=complex)
    for steps in (range(middle, len(detunings)), range(middle, -1, -1)):
        guess = np.array([-0.01 - 0.02j, 0.3 + 0.05j])
        for i in steps:
            guess = found[i] = equilibrium(order, detunings[i], guess)
    lines[order] = 2 * np.abs(found[:, 0])
by_formula = np.array([
    float(sp.sqrt(held).subs(numbers).subs({sigma_1: 0, sigma_2: s})) for s in detunings
])  # fmt: skip
print(f"order 1 at rest is the formula: {np.abs(lines[1] - by_formula).max() < 1e-9}")
dots = detunings[5::10]
shown = np.array([steady(2 + s, [0.02, 0.5, 0.0, 0.1]) for s in dots])

# %%
absorber_figure, axes = plt.subplots(figsize=(6.4, 3.4), layout="constrained")
locked = AT["f"] / (4 * np.hypot(detunings, AT["mu_x"]))
axes.plot(detunings, locked, color="0.6", lw=1, label="pendulum locked")
for order in (1, 2):
    style = {"color": plotting.COLOURS[order - 1], "ls": plotting.DASHES[order - 1]}
    axes.plot(detunings, lines[order], label=f"absorber, order {order}", **style)
axes.plot(dots, shown, "o", color="black", mfc="none", label="unexpanded equations")
axes.set(xlabel=r"$\sigma_2 = \Omega - \omega_x$ (rad/s)", ylabel="$a_x$ (m)", ylim=(0, None))
axes.set_xlim(detunings[0], detunings[-1])
legend = axes.legend(frameon=False, fontsize="small")

# %% [markdown]
# ## 5. Evidence
#
# Motions of the slow flow beside motions of the unexpanded equations, over times of order
# $1/\varepsilon$: the distance, relative to the amplitude, must fall like $\varepsilon^N$.

# %%
GENERIC = {"L": 1.3, "r": 0.3, "omega_p": 0.67, "mu_x": 0.11, "mu_p": 0.07, "f": 0.5,
           "sigma_1": 0.23, "sigma_2": -0.31}  # fmt: skip
emission = mg.Emission(
    model="autoparametric_absorber",
    cases=list(working.values()),
    samples=lambda case: GENERIC,
    derivation="derivations/autoparametric_absorber.py",
    source="Haxton and Barr, J. Engineering for Industry 94 (1972) 119-125",
    amplitudes=lambda case: ([0.2 + 0.3j, -0.2 + 0.4j], 0.7),
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
# Each module holds `slow_flow`, the rates of the complex amplitudes.

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
