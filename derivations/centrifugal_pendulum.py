# %% [markdown]
# # Centrifugal pendulum absorber
#
# A pendulum hangs in the centrifugal field of a rotor, so that its frequency is a fixed multiple of
# the speed: tuned to the order of a torque, it balances that torque at every speed. On a circular
# path it does so for small swings only. It softens, and beyond a certain torque it jumps to a large
# swing that adds to the torque.
#
# Sources: J. P. Den Hartog, *Mechanical Vibrations*, for the linear theory; D. E. Newland,
# "Nonlinear aspects of the performance of centrifugal pendulum vibration absorbers",
# *J. Engineering for Industry* 86 (1964) 257–263, for the jump; S. W. Shaw, P. M. Schmitz and
# A. G. Haddow, "Tautochronic vibration absorbers for rotating systems",
# *J. Computational and Nonlinear Dynamics* 1 (2006) 283–293, for the scaling by the
# ratio of inertias.

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown
from scipy.integrate import solve_ivp
from sympy.physics.mechanics import dynamicsymbols
from two_amplitudes import only

import mmsgen as mg
from mmsgen import plotting, report

# %% [markdown]
# ## 1. Model
#
# A rotor of inertia $J$ turns by $\Omega t + \psi$. At the radius $R$ a point mass $m$ is hinged by
# an arm $\rho$, which makes the angle $\phi$ with the radius. A torque $T\cos\nu t$ acts on the
# rotor.
#
# A rotor that nothing holds has a zero frequency: it turns away, it does not oscillate, and no
# expansion in oscillations describes it. The literature takes the rotor's angle instead of time as
# the variable and eliminates the speed approximately. Here the model stays exact: the rotor is held
# by a spring $k$ to a shaft that turns uniformly, such as a generator's; and the free rotor is the
# limit $k \to 0$ of the result, in which nothing is singular.

# %%
t = dynamicsymbols._t
psi, phi = dynamicsymbols("psi phi")
J, m, R, rho, k, c, T, Omega, nu = sp.symbols("J m R rho k c T Omega nu", positive=True)
speed, swing_speed = Omega + psi.diff(t), phi.diff(t)
model = mg.Model(
    lagrangian=J * speed**2 / 2
    + m * (R**2 * speed**2 + rho**2 * (speed + swing_speed) ** 2) / 2
    + m * R * rho * speed * (speed + swing_speed) * sp.cos(phi)
    - k * psi**2 / 2,
    coordinates=[psi, phi],
    parameters=[
        mg.Parameter(J, "kg m^2", "inertia of the rotor"),
        mg.Parameter(m, "kg", "mass of the pendulum"),
        mg.Parameter(R, "m", "radius of the hinge"),
        mg.Parameter(rho, "m", "length of the pendulum"),
        mg.Parameter(k, "N m", "spring between rotor and shaft"),
        mg.Parameter(c, "N m s", "damper of the pendulum"),
        mg.Parameter(T, "N m", "torque"),
        mg.Parameter(Omega, "rad/s", "speed of the shaft"),
        mg.Parameter(nu, "rad/s", "frequency of the torque"),
    ],
    dissipation=c * swing_speed**2 / 2,
    forces={psi: T * sp.cos(nu * t)},
)
exact = model.equations_of_motion()
report.equations(exact)

# %% [markdown]
# The pendulum alone, on a rotor that turns uniformly, swings with $\omega_p = n\Omega$ where
# $n^2 = R/\rho$ is fixed by the geometry: the order to which it is tuned. With $n$, $\omega_p$ and
# the ratio of inertias $b = m(R + \rho)^2/J$:

# %%
omega_r, omega_p, n, b = sp.symbols("omega_r omega_p n b", positive=True)
mu, tau = sp.symbols("mu tau", nonnegative=True)
inertia = m * rho**2 * (1 + n**2) ** 2 / b
eom = exact.reparametrise(
    {
        R: n**2 * rho,
        Omega: omega_p / n,
        J: inertia,
        k: omega_r**2 * inertia,
        T: tau * inertia,
        c: 2 * mu * m * rho**2,
    },
    parameters=[
        mg.Parameter(omega_r, "rad/s", "frequency of the rotor on its spring, without pendulum"),
        mg.Parameter(omega_p, "rad/s", "frequency of the pendulum on a uniform rotor, n Ω"),
        mg.Parameter(n, "1", "order of tuning, the root of R/ρ"),
        mg.Parameter(b, "1", "ratio of inertias, m (R + ρ)²/J"),
        mg.Parameter(mu, "1/s", "damping of the pendulum"),
        mg.Parameter(tau, "1/s^2", "torque over the inertia of the rotor, T/J"),
    ],
    eliminate=[m, rho],
)
report.parameter_table(eom.parameters)

# %%
report.equations(eom, only=[phi])

# %% [markdown]
# ## 2. Orders and resonances
#
# The pendulum is light, $b$ of order $\varepsilon^2$, and swings by $\phi$ of order ε; then the
# rotor shakes by $\psi$ of order $\varepsilon^2$ under a torque of order $\varepsilon^3$, and
# everything that matters meets at the order $\varepsilon^2$ beside the linear terms: the pendulum's
# softening, its damping, and the reaction of the rotor. (The literature calls that order ε.)

# %%
scaled = eom.scale({b: 2, mu: 2, tau: 3}, amplitude={psi: 2, phi: 1})
scaled.resonances(order=2)

# %% [markdown]
# ## 3. The tuned absorber, $\nu = \omega_p + \varepsilon\sigma$
#
# Nothing happens at order 1. At order 2:

# %%
cases = {order: scaled.expand(order, {nu: omega_p}) for order in (2, 4)}
report.solvability(cases[2], 2)

# %% [markdown]
# Order 3 brings the detuning of the torque's effect, order 4 the next terms of all effects:

# %%
report.solvability(cases[4], 3, only=[phi])

# %% [markdown]
# ## 4. The free rotor
#
# The limit $\omega_r \to 0$ of order 2, with $A_\phi = \tfrac12 a e^{i\gamma}$ in the frame that
# turns with $\sigma$:

# %%
sigma = cases[2].relations[0].detuning
A = cases[2].amplitudes[1]
rate = sp.cancel(cases[2].slow_flow.autonomous[A].subs(omega_r, 0))
report.expression(r"\dot{B}_\phi", sp.expand(rate))

# %% [markdown]
# At rest the term of the torque balances the others. The squares of their moduli give the response:

# %%
a = sp.Symbol("a", positive=True)
forcing = rate.subs({A: 0, sp.conjugate(A): 0})
others = sp.expand((rate - forcing).subs({A: a / 2, sp.conjugate(A): a / 2}))
damping = others.subs(sigma, 0).coeff(mu) * mu
stiffness = sp.expand((others - damping) / sp.I)
response = 4 * (damping**2 + stiffness**2 - (forcing / sp.I) ** 2)
printed = (
    a**2 * (mu**2 + (sigma - omega_p * (b / 2 - a**2 / 16)) ** 2)
    - (tau * (n**2 + 1) / (2 * omega_p)) ** 2
)
assert sp.cancel(response - printed) == 0
report.expression("0", printed)

# %% [markdown]
# In it are the classical results, which follow by plain steps:
#
# * the free pendulum on the free rotor has the frequency $\omega_p(1 + b/2 - a^2/16)$. The linear
#   theory is exact with $\omega_p\sqrt{1 + b}$, which order 4 continues; and a
#   circular path detunes by $1 - a^2/16$, like any pendulum;
# * an undamped, perfectly tuned pendulum, $\sigma = 0$, balances a small torque fully (Den Hartog):
#   the amplitude is that at which $m\rho(R + \rho)\omega^2 a = T$;
# * on a circular path the torque cannot pass a maximum. There $a^2 = 8b/3$, and the pendulum jumps
#   (Newland).

# %%
free = cases[4].slow_flow.autonomous[A].subs({omega_r: 0, mu: 0, tau: 0, sigma: 0})
linear = sp.cancel((free / A).subs({s: 0 for s in free.atoms(sp.conjugate)}))
exact_frequency = omega_p * sp.sqrt(1 + b)
assert sp.expand(linear / sp.I + omega_p - exact_frequency.series(b, 0, 3).removeO()) == 0

torque = sp.solve(printed.subs({sigma: 0, mu: 0}), tau**2)[0]
small = sp.expand(torque).coeff(a, 2)
den_hartog = m * rho * (n**2 * rho + rho) * omega_p**2 / inertia
assert sp.cancel(small - den_hartog**2) == 0

stationary = sp.solve(sp.cancel(sp.diff(torque, a) / a), a**2)
assert sp.Rational(8, 3) * b in stationary
report.expression(
    r"\tau_{\max}", sp.sqrt(sp.factor(torque.subs(a, sp.sqrt(sp.Rational(8, 3) * b))))
)

# %% [markdown]
# Amplitude of the pendulum over the torque on a perfectly tuned, lightly damped absorber: the
# formula as a line, and, as dots, the unexpanded equations of the *free* rotor ($k = 0$),
# integrated from rest until the motion is steady. Past the maximum the pendulum jumps.

# %%
AT = {"omega_r": 0.0, "omega_p": 1.0, "n": 2.0, "b": 0.04, "mu": 0.008, "nu": 1.0}
numbers = {p.symbol: AT[p.name] for p in eom.parameters if p.name in AT}
mass = sp.Matrix(
    [[e.coeff(q.diff(t, 2)) for q in (psi, phi)] for e in map(sp.expand, eom.equations)]
)
rest = [e.subs({q.diff(t, 2): 0 for q in (psi, phi)}) for e in eom.equations]
system = sp.lambdify(
    [t, (psi, phi), (psi.diff(t), phi.diff(t)), tau],
    [*mass.subs(numbers), *(e.subs(numbers) for e in rest)],
    "math",
    cse=True,
)


def steady(force, settle=100, periods=8):
    """Amplitude of the pendulum's fundamental, from rest, once transients are gone."""
    end = 2 * np.pi * settle
    window = np.linspace(end, end + 2 * np.pi * periods, 32 * periods, endpoint=False)

    def state(time, s):
        s = s.tolist()
        m11, m12, m21, m22, f1, f2 = system(time, s[:2], s[2:], force)
        det = m11 * m22 - m12 * m21
        return [*s[2:], (m12 * f2 - m22 * f1) / det, (m21 * f1 - m11 * f2) / det]

    motion = solve_ivp(state, (0, window[-1]), [0.0] * 4, "DOP853", window, rtol=1e-7, atol=1e-9)
    return 2 * abs(np.mean(motion.y[1] * np.exp(-1j * window)))


swing = np.linspace(0, 0.8, 400)
stiff = AT["b"] / 2 - swing**2 / 16
curve = 2 * swing * np.hypot(AT["mu"], stiff) / (AT["n"] ** 2 + 1)
top = float(sp.sqrt(torque).subs(numbers).subs(a, sp.sqrt(sp.Rational(8, 3) * AT["b"])))
dots = np.array([0.3, 0.6, 0.9, 1.3, 1.6]) * top
found = np.array([steady(force) for force in dots])

# %%
jump_figure, axes = plt.subplots(figsize=(4.8, 3.4), layout="constrained")
axes.plot(curve, swing, color=plotting.COLOURS[0], label="slow flow, order 2")
axes.plot(dots, found, "o", color="black", mfc="none", label="unexpanded equations, free rotor")
axes.set(xlabel="τ (1/s²)", ylabel="a (rad)", xlim=(0, 1.8 * top), ylim=(0, 0.8))
legend = axes.legend(frameon=False, fontsize="small")

# %% [markdown]
# The same torque on a rotor that a soft spring holds, $\omega_r = 0.3\,\omega_p$, where all steady
# motions can be followed: the jumps, up and down, are the two saddle-nodes, and between them there
# is an unstable swing. (Order 2 has no damping of the rotor's own oscillation, and so does not say
# what is stable; order 4 does, by that which the pendulum lends it.) Points: periodic orbits of the
# unexpanded equations.

# %%
HELD = {"omega_r": 0.3, "omega_p": 1.0, "n": 2.0, "b": 0.04, "mu": 0.008, "sigma": 0.0}
torques = {**HELD, "tau": np.linspace(0.0, 0.003, 201)}
found = {n: case.slow_flow.frequency_response(torques) for n, case in cases.items()}
points = [
    (x, amplitudes[1:], stable)
    for x, amplitudes, stable in mg.orbits_along(cases[4], HELD, found[4], 18)
]
held_figure, axes = plt.subplots(figsize=(4.8, 3.6), layout="constrained")
(branch,) = found[2].branches
axes.plot(branch.parameter, branch.modulus[:, 1], "-.", color="0.4", lw=1.2, label="order 2")
axes = plotting.frequency_response(
    only(found[4], 1),
    ["order 4"],
    points=points,
    xlabel="τ (1/s²)",
    ylabel="a (rad)",
    axes=axes,
)
axes.margins(x=0)

# %% [markdown]
# ## 5. Evidence
#
# Motions of the slow flow beside motions of the unexpanded equations, rotor on its spring. Over
# times of order $1/\varepsilon$ the distance, relative to the amplitudes, must fall like
# $\varepsilon^N$. So must the error of steady amplitudes beside those of periodic orbits; the rates
# at which disturbances of them die out are better by one order.

# %%
GENERIC = {"omega_r": 1.31, "omega_p": 0.67, "n": 1.4, "b": 0.9, "mu": 0.3, "tau": 0.7,
           "sigma": 0.4}  # fmt: skip
swinging = cases[2].slow_flow.equilibria(GENERIC).amplitudes[0]
emission = mg.Emission(
    model="centrifugal_pendulum",
    cases=list(cases.values()),
    samples=lambda case: GENERIC,
    derivation="derivations/centrifugal_pendulum.py",
    source="Newland, J. Engineering for Industry 86 (1964) 257-263",
    amplitudes=lambda case: ([0.9 + 0.6j, 0.7 - 0.8j], 0.5),
    steady=lambda case: [mg.Steady(GENERIC, list(swinging))],
)
certificates = emission.certificates
report.certificate_table(certificates.values())

# %%
axes = plotting.convergence(
    list(certificates.values()),
    [f"order {order}" for order in cases],
    quantity="motions at times of order 1/ε",
)

# %% [markdown]
# ## 6. The emitted functions
#
# Each module holds `slow_flow`, the rates of the complex amplitudes, and what follows from it:
# `equilibria`, `frequency_response`, `stability`, `response`.

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
