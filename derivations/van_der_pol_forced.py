# %% [markdown]
# # Van der Pol's oscillator, driven
#
# A triode circuit locks to a signal near its own frequency; van der Pol told why. The oscillator is
# either locked to a weak force or beats with it; driven hard elsewhere, its own oscillation can be
# quenched. The relations have the form of those of Nayfeh and Mook, *Nonlinear Oscillations*
# (1979), chapter 4, who write them for Rayleigh's oscillator (`rayleigh_forced`); here they are
# derived for
#
# $$\ddot u + \omega_0^2 u = \mu\left(1 - u^2\right)\dot u + K\cos\Omega t .$$

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
    forces={u: mu * (1 - u**2) * v + K * sp.cos(Omega * t)},
    parameters=[
        mg.Parameter(omega_0, "rad/s", "natural frequency"),
        mg.Parameter(Omega, "rad/s", "frequency of the force"),
        mg.Parameter(mu, "1/s", "strength of the self-excitation, which turns at 1 m"),
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
# Locked motions are the steady states. With $\rho = \tfrac14 a^2$, and the strength of
# the self-excitation divided out ($\sigma$ over $\mu$, and $K$ over $\mu\omega_0$), the relation is
#
# $$\rho(1-\rho)^2 + 4\sigma^2\rho = \tfrac14 K^2 .$$

# %%
rho = sp.Symbol("rho", positive=True)
flow, sigma, a = primary[1].slow_flow, primary[1].relations[0].detuning, modulus(u)
in_rho = {a: 2 * sp.sqrt(rho), K: mu * omega_0 * K, sigma: mu * sigma}


def demand_proportional(found, printed):
    """Both vanish together: their quotient is positive, of the units alone."""
    quotient = sp.cancel(found.subs(in_rho, simultaneous=True) / printed)
    assert quotient.is_positive and quotient.free_symbols <= {mu, omega_0}


relation = flow.response_relation()
demand_proportional(relation, rho * (1 - rho) ** 2 + 4 * sigma**2 * rho - K**2 / 4)
report.expression("0", relation)

# %% [markdown]
# They are stable, so that the oscillator stays locked, where the trace $1 - 2\rho$ (times $\mu$)
# is negative and the determinant (times $\mu^2$) is positive:
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
# away,
#
# $$\dot a = \tfrac12\mu a\left(\eta - \tfrac14 a^2\right), \qquad
#   \eta = 1 - 2\Lambda^2 = 1 - \frac{K^2}{2(\omega_0^2 - \Omega^2)^2} .$$

# %%
quenching = {order: hard.expand(order) for order in (1, 2)}
rate = quenching[1].slow_flow.polar[a]
report.expression(r"\dot a", rate)

# %%
eta = 1 - K**2 / (2 * (omega_0**2 - Omega**2) ** 2)
assert sp.cancel(rate - mu * a * (eta - a**2 / 4) / 2) == 0

# %% [markdown]
# While $\eta > 0$ the oscillator keeps swinging at its own frequency, with
# $a = 2\sqrt\eta$, beside the motion that the force makes; for $\eta < 0$ its own
# oscillation dies out, and only the forced one is left. Order 2 shifts its frequency:

# %%
report.solvability(quenching[2], 2)

# %% [markdown]
# ## 5. Locked motions of the exact equation
#
# $\omega_0 = 1$ rad/s, $\mu = 0.2$ 1/s. Points: periodic orbits of the unexpanded equation, stable
# ones filled. A weak force (left) leaves an island of locked motions about the amplitude 2, over a
# curve on which the mass is merely shaken, and beats; a stronger one (middle) locks all amplitudes
# above $\sqrt2$. Right: where locking is lost, in saddle-nodes at weak forces and in Hopf points
# at strong ones; points: folds and Neimark–Sacker bifurcations of exact periodic orbits.

# %%
NUMBERS = {omega_0: 1.0, mu: 0.2}
figure, panels = plt.subplots(1, 3, figsize=(9.6, 4.2), layout="constrained")
for axes, force in zip(panels[:2], (0.12, 0.3), strict=True):
    here = {**NUMBERS, K: force, sigma: np.linspace(-0.25, 0.25, 501)}
    for order, case in primary.items():
        response = case.slow_flow.frequency_response(here)
        points = mg.orbits_along(case, here, response, 28) if order == 2 else ()
        plotting.frequency_response(
            response, [f"order {order}"], points=points, colour=order - 1, axes=axes
        )
    axes.set(xlabel="σ (rad/s)", ylabel="amplitude (m)", title=f"K = {force} m/s²")

edge = panels[2]
forces = np.concatenate(
    [np.linspace(0.02, 0.2, 4), [0.205, 0.21, 0.215], np.linspace(0.22, 0.38, 4)]
)
for order, case in primary.items():
    found = []
    for force in forces:
        here = {**NUMBERS, K: force, sigma: np.linspace(-0.25, 0.25, 51)}
        response = case.slow_flow.frequency_response(here)
        found += [(force, *own) for own in response.bifurcations]
    for kind, dash in (("saddle-node", "-"), ("Hopf", "--")):
        for side in (-1, 1):
            met = [(f, s, b) for f, k, s, b, *_ in found if k == kind and side * s > 0]
            # Of two saddle-nodes the outer one: there the larger amplitudes are.
            outer = {f: max((abs(b[0]), s) for g, s, b in met if g == f)[1] for f, _, _ in met}
            label = f"{kind}, order {order}" if side > 0 else None
            style = {"color": plotting.COLOURS[order - 1], "lw": plotting.WIDTHS[order - 1]}
            edge.plot(list(outer.values()), list(outer), dash, label=label, **style)


def lost(force, end):
    """Where exact locked motions become unstable, from σ = 0 on."""
    here = {**NUMBERS, K: force, sigma: 0.0}
    found = primary[2].slow_flow.equilibria(here)
    near = mg.orbit_near(primary[2], here, found.amplitudes[found.stable][0])
    path = mg.orbits.follow(
        near.orbit.problem, near.orbit, Omega, 1 + end, progress=lambda orbit, _: orbit.stable
    )
    return path.specials[0]


MARKS = {"fold": ("o", "exact fold"), "Neimark-Sacker": ("^", "exact Neimark–Sacker point")}
known = set()
for force in (0.08, 0.16, 0.25, 0.34):
    for end in (-0.25, 0.25):
        special = lost(force, end)
        mark, label = MARKS[special.kind]
        style = {"mfc": "none", "mec": "black", "ms": 5, "ls": ""}
        edge.plot(special.value - 1, force, mark, label=None if mark in known else label, **style)
        known.add(mark)
edge.set(xlabel="σ (rad/s)", ylabel="K (m/s²)", title="locked above the curves", ylim=(0, None))
edge.locator_params(axis="x", nbins=5)
_ = plotting.shared_legend(panels)

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
    response = case.slow_flow.frequency_response({**hard_numbers, K: np.linspace(0.02, 4, 200)})
    style = {"colour": order - 1, "xlabel": "K (m/s²)", "ylabel": "amplitude at $\\omega_0$ (m)"}
    plotting.frequency_response(response, [f"order {order}"], axes=left, **style)
    _, own = response.branches  # rest, and the oscillator's own oscillation
    speed = np.where(own.modulus > 0, 1 + own.drift, np.nan)
    look = {"color": plotting.COLOURS[order - 1], "lw": plotting.WIDTHS[order - 1]}
    right.plot(own.parameter, speed, **look)

swinging = np.linspace(0.5, 3, 11)
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

forced = mg.orbit_near(quenching[2], {**hard_numbers, K: 4.0}, [0.0]).orbit
assert forced.stable
path = mg.orbits.follow(forced.problem, forced, K, 3.0)
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
# stronger one does; a limit cycle of the slow flow beyond it, its lines and its frequency, beside
# the exact motion, which has two frequencies and never repeats; the motion that is forced alone,
# and the decay or growth of the oscillator's own oscillation in it.


# %%
def samples(case):
    """Generic numbers at ε = 1."""
    values = {"omega_0": 1.2, "mu": 0.7, "K": 1.3, "sigma": 0.57, "Omega": 2.9}
    names = {p.name for p in case.parameters} - set(case.weak.detuned)
    return {name: value for name, value in values.items() if name in names}


LOCKED = {"omega_0": 1.0, "mu": 0.8, "K": 0.9, "sigma": 0.15}
FOLD = {"omega_0": 1.0, "mu": 0.8, "K": 0.6, "sigma": 0.153}
HOPF = {"omega_0": 1.0, "mu": 0.8, "K": 1.5, "sigma": 0.49}
DRIFTING = {"omega_0": 1.0, "mu": 1.0, "K": 1.2, "sigma": 0.8}


def steady(case):
    """Values at ε = 1, and amplitudes near those of order 1."""
    if case in quenching.values():
        return [mg.Steady(samples(case), [0.0])]
    return [
        mg.Steady(LOCKED, [-0.88 - 0.74j]),
        mg.Steady(FOLD, [-0.94 + 0.2j], "saddle-node"),
        mg.Steady(HOPF, [-0.65 + 0.27j], "Hopf"),
        mg.Steady(DRIFTING, [0.8 + 0.3j], cycle=True),
    ]


emission = mg.Emission(
    model="van_der_pol_forced",
    cases=[*primary.values(), *quenching.values()],
    samples=samples,
    amplitudes=lambda case: ([-0.2 - 0.4j], 1.0),
    steady=steady,
    derivation="derivations/van_der_pol_forced.py",
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
