# %% [markdown]
# # Rayleigh's oscillator, driven
#
# Rayleigh's clarinet reed, whose damping is negative while it moves slowly. Driven near its own
# frequency it is either locked to the force or beats with it; driven hard elsewhere, its own
# oscillation can be quenched. The relations are those of Nayfeh and Mook, *Nonlinear Oscillations*
# (1979), chapter 4, for
#
# $$\ddot u + \omega_0^2 u = \mu\left(\dot u - \tfrac13 \dot u^3\right) + K\cos\Omega t .$$

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown, display
from many_motions import fundamental, integrate
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.motion import reconstruction
from mmsgen.symbols import modulus

# %% [markdown]
# ## 1. The model

# %%
t = dynamicsymbols._t
u = dynamicsymbols("u")
omega_0, mu, K, Omega = sp.symbols("omega_0 mu K Omega", positive=True)
v = u.diff(t)
model = mg.Model(
    lagrangian=v**2 / 2 - omega_0**2 * u**2 / 2,
    coordinates=[u],
    forces={u: mu * (v - v**3 / 3) + K * sp.cos(Omega * t)},
    parameters=[
        mg.Parameter(omega_0, "rad/s", "natural frequency"),
        mg.Parameter(Omega, "rad/s", "frequency of the force"),
        mg.Parameter(mu, "1/s", "strength of the self-excitation, which turns at 1 m/s"),
        mg.Parameter(K, "m/s^2", "amplitude of the force over the mass"),
    ],
)
eom = model.equations_of_motion()
report.equations(eom)

# %% [markdown]
# ## 2. Orders in ε
#
# The self-excitation is weak. A force near $\omega_0$ has to be weak as well (*soft*), elsewhere
# it may be strong (*hard*).

# %%
soft, hard = eom.scale({mu: 1, K: 1}), eom.scale({mu: 1})
display(report.orders(soft, 1), report.orders(hard, 0))
hard.resonances(order=1)

# %% [markdown]
# ## 3. Driven near its own frequency: locked or beating
#
# $\Omega = \omega_0 + \varepsilon\sigma$, soft force.

# %%
primary = {order: soft.expand(order, {Omega: omega_0}) for order in (1, 2)}
display(report.solvability(primary[2], 1), report.solvability(primary[2], 2))
report.modulation(primary[1])

# %% [markdown]
# Locked motions are the steady states. With $\rho = \tfrac14\omega_0^2 a^2$, and the strength of
# the self-excitation divided out ($\sigma$ and $K$ over $\mu$), the printed relation is
#
# $$\rho(1-\rho)^2 + 4\sigma^2\rho = \tfrac14 K^2 .$$

# %%
rho = sp.Symbol("rho", positive=True)
flow, sigma, a = primary[1].slow_flow, primary[1].relations[0].detuning, modulus(u)
in_rho = {a: 2 * sp.sqrt(rho) / omega_0, K: mu * K, sigma: mu * sigma}


def demand_proportional(found, printed):
    """Both vanish together: their quotient is positive, of the units alone."""
    quotient = sp.cancel(found.subs(in_rho, simultaneous=True) / printed)
    assert quotient.is_positive and quotient.free_symbols <= {mu, omega_0}


relation = flow.response_relation()
demand_proportional(relation, rho * (1 - rho) ** 2 + 4 * sigma**2 * rho - K**2 / 4)
report.expression("0", relation)

# %% [markdown]
# They are stable, so that the oscillator stays locked, where the trace $1 - 2\rho$ (times $\mu$)
# is negative and the determinant (times $\mu^2$) is positive. Printed:
#
# $$\rho > \tfrac12, \qquad \tfrac14\left(1 - 4\rho + 3\rho^2\right) + \sigma^2 > 0 .$$
#
# On the edge of the first condition a Hopf bifurcation lets the oscillator beat again, on that of
# the second one a locked motion meets an unstable one, and both are gone: a saddle-node.

# %%
meeting = flow.bifurcation_equations()
assert all(equations[0] == relation for equations in meeting.values())
demand_proportional(meeting["Hopf"][1], 2 * rho - 1)
demand_proportional(meeting["saddle-node"][1], (1 - 4 * rho + 3 * rho**2) / 4 + sigma**2)
display(report.expression(r"\text{Hopf}:\quad 0", meeting["Hopf"][1]))
report.expression(r"\text{saddle-node}:\quad 0", meeting["saddle-node"][1])

# %% [markdown]
# ## 4. Driven hard, far from resonance: quenching
#
# The force alone moves the mass by $2\Lambda\cos\Omega t$,
# $\Lambda = \tfrac12 K/(\omega_0^2 - \Omega^2)$. At order 1 it takes part of the self-excitation
# away, printed
#
# $$\dot a = \tfrac12\mu a\left(\eta - \tfrac14\omega_0^2a^2\right), \qquad
#   \eta = 1 - \frac{\Omega^2K^2}{2(\omega_0^2 - \Omega^2)^2} .$$

# %%
quenching = {order: hard.expand(order) for order in (1, 2)}
rate = quenching[1].slow_flow.polar[a]
report.expression(r"\dot a", rate)

# %%
eta = 1 - Omega**2 * K**2 / (2 * (omega_0**2 - Omega**2) ** 2)
assert sp.cancel(rate - mu * a * (eta - omega_0**2 * a**2 / 4) / 2) == 0

# %% [markdown]
# While $\eta > 0$ the oscillator keeps swinging at its own frequency, with
# $a = 2\sqrt\eta/\omega_0$, beside the motion that the force makes; for $\eta < 0$ its own
# oscillation dies out, and only the forced one is left. Order 2 shifts its frequency:

# %%
report.solvability(quenching[2], 2)

# %% [markdown]
# ## 5. Locked motions of the exact equation
#
# $\omega_0 = 1$ rad/s, $\mu = 0.2$ 1/s. Left: order 1 for five forces; a weak one leaves an island
# of locked motions about the amplitude 2, over a curve on which the mass is merely shaken, and
# beats. Middle and right: two of the forces, with periodic orbits of the unexpanded equation,
# stable ones filled.

# %%
NUMBERS = {omega_0: 1.0, mu: 0.2}
figure, panels = plt.subplots(1, 3, figsize=(9.6, 4.0), layout="constrained")
for force in (0.28, 0.2, 0.154, 0.12, 0.08):
    here = {**NUMBERS, K: force, sigma: np.linspace(-0.12, 0.12, 241)}
    response = primary[1].slow_flow.frequency_response(here)
    plotting.frequency_response(response, ["order 1"], axes=panels[0])
    end = min(b.modulus[-1, 0] for b in response.branches if b.parameter[-1] > 0.119)
    beside = {"xytext": (4, 0), "textcoords": "offset points", "va": "center"}
    panels[0].annotate(f"{force}", (0.12, end), fontsize="small", **beside)
for line in panels[0].get_lines():
    line.set_linewidth(1.4)
panels[0].set(title="K (m/s²) at the curves", xlim=(-0.13, 0.17))
for axes, force in zip(panels[1:], (0.12, 0.28), strict=True):
    here = {**NUMBERS, K: force, sigma: np.linspace(-0.2, 0.2, 401)}
    for order, case in primary.items():
        response = case.slow_flow.frequency_response(here)
        points = mg.orbits_along(case, here, response, 28) if order == 2 else ()
        plotting.frequency_response(
            response, [f"order {order}"], points=points, colour=order - 1, axes=axes
        )
    axes.set_title(f"K = {force} m/s²")
for axes in panels:
    axes.set(xlabel="σ (rad/s)", ylabel="amplitude (m)")
_ = plotting.shared_legend([*panels[1:], panels[0]])

# %% [markdown]
# The same for a hard force of $\Omega = 1.8$ rad/s. The oscillator's own oscillation stands beside
# the forced one, and their frequencies have no simple ratio: that is no periodic orbit, but a
# motion of two frequencies. So the exact equation is integrated from the motions that order 2 makes
# of its equilibria, and the part near $\omega_0$ is read off. From the force on at which it is
# quenched the motion is periodic; in the exact equation that is a Neimark–Sacker bifurcation of the
# forced motion. Both orders have the same amplitude.

# %%
hard_numbers = {**NUMBERS, Omega: 1.8}
figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.8), layout="constrained")
for order, case in quenching.items():
    response = case.slow_flow.frequency_response({**hard_numbers, K: np.linspace(0.02, 2.2, 200)})
    style = {"colour": order - 1, "xlabel": "K (m/s²)", "ylabel": "amplitude at $\\omega_0$ (m)"}
    plotting.frequency_response(response, [f"order {order}"], axes=left, **style)
    _, own = response.branches  # rest, and the oscillator's own oscillation
    speed = np.where(own.modulus > 0, 1 + own.drift, np.nan)
    look = {"color": plotting.COLOURS[order - 1], "lw": plotting.WIDTHS[order - 1]}
    right.plot(own.parameter, speed, **look)

swinging = np.linspace(0.3, 1.65, 10)
values = {str(symbol): number for symbol, number in hard_numbers.items()}
starts = [
    reconstruction(quenching[2], {**values, "K": force})(np.zeros(1), b[None, -1:])[:, 0]
    for force, b in zip(
        swinging,
        quenching[2].slow_flow.equilibria({**hard_numbers, K: swinging}).amplitudes[:, -1],
        strict=True,
    )
]
times = np.concatenate([[0.0], np.linspace(150, 400, 2501)])
motions, _ = integrate(eom, {**values, "K": swinging}, np.stack(starts, axis=1), times)
sizes, speeds = fundamental(times[1:], motions[:, 1:], 1.0, 0.1)
left.plot(swinging, sizes, "ks", ms=3.4, label="time integration")
right.plot(swinging, speeds, "ks", ms=3.4)

forced = mg.orbit_near(quenching[2], {**hard_numbers, K: 2.2}, [0.0]).orbit
assert forced.stable
path = mg.orbits.follow(forced.problem, forced, K, 1.6)
(quenched,) = path.specials
assert quenched.kind == "Neimark-Sacker"
left.plot(quenched.value, 0, "k^", ms=4, zorder=5, label="exact Neimark–Sacker point")
right.set(xlabel="K (m/s²)", ylabel="frequency of that oscillation (rad/s)")
_ = plotting.shared_legend([left, right])

# %% [markdown]
# ## 6. Certificates
#
# Besides motions: locked motions beside periodic orbits, their amplitudes and how fast disturbances
# die out, the saddle-node at which a weaker force loses its hold, and the Hopf point at which a
# stronger one does; the motion that is forced alone, and the decay or growth of the oscillator's
# own oscillation in it.


# %%
def samples(case):
    """Generic numbers at ε = 1."""
    values = {"omega_0": 1.2, "mu": 0.7, "K": 1.3, "sigma": 0.57, "Omega": 2.9}
    names = {p.name for p in case.parameters} - set(case.weak.detuned)
    return {name: value for name, value in values.items() if name in names}


LOCKED = {"omega_0": 1.0, "mu": 0.8, "K": 0.9, "sigma": 0.15}
FOLD = {"omega_0": 1.0, "mu": 0.8, "K": 0.6, "sigma": 0.153}
HOPF = {"omega_0": 1.0, "mu": 0.8, "K": 1.5, "sigma": 0.49}


def steady(case):
    """Values at ε = 1, and amplitudes near those of order 1."""
    if case in quenching.values():
        return [mg.Steady(samples(case), [0.0])]
    return [
        mg.Steady(LOCKED, [-0.88 - 0.74j]),
        mg.Steady(FOLD, [-0.94 + 0.2j], "saddle-node"),
        mg.Steady(HOPF, [-0.65 + 0.27j], "Hopf"),
    ]


emission = mg.Emission(
    model="rayleigh_forced",
    cases=[*primary.values(), *quenching.values()],
    samples=samples,
    amplitudes=lambda case: ([-0.2 - 0.4j], 1.0),
    steady=steady,
    derivation="derivations/rayleigh_forced.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 4",
)
report.certificate_table(emission.certificates.values())

# %%
plotting.convergence(list(emission.certificates.values()), quantity="motions at times of order 1/ε")
plt.show()

# %% [markdown]
# ## 7. The emitted functions

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
