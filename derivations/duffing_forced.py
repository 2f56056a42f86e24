# %% [markdown]
# # Duffing's oscillator, damped and driven
#
# The same oscillator responds in three ways. Driven softly near its own frequency, it bends its
# resonance curve over. Driven hard at a third of its frequency, it answers with three swings a
# period; driven hard at three times its frequency, it may swing once in three periods, or not at
# all. The relations between amplitude and detuning are those of Nayfeh and Mook, *Nonlinear
# Oscillations* (1979), chapter 4, for
#
# $$\ddot u + 2\mu\dot u + \omega_0^2 u + \alpha u^3 = K\cos\Omega t .$$

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown, Math, display
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.certify import scaled_values
from mmsgen.symbols import modulus

# %% [markdown]
# ## 1. The model

# %%
t = dynamicsymbols._t
u = dynamicsymbols("u")
omega_0, alpha, mu, K, Omega = sp.symbols("omega_0 alpha mu K Omega", positive=True)
model = mg.Model(
    lagrangian=u.diff(t) ** 2 / 2 - omega_0**2 * u**2 / 2 - alpha * u**4 / 4,
    coordinates=[u],
    dissipation=mu * u.diff(t) ** 2,
    forces={u: K * sp.cos(Omega * t)},
    parameters=[
        mg.Parameter(omega_0, "rad/s", "frequency of small oscillations"),
        mg.Parameter(Omega, "rad/s", "frequency of the force"),
        mg.Parameter(alpha, "1/(m^2 s^2)", "cubic stiffness over the mass"),
        mg.Parameter(mu, "1/s", "half the damping over the mass"),
        mg.Parameter(K, "m/s^2", "amplitude of the force over the mass"),
    ],
)
report.parameter_table(model.parameters)

# %%
eom = model.equations_of_motion()
report.equations(eom)

# %% [markdown]
# ## 2. Orders in ε
#
# Damping and nonlinearity are small. A *soft* force is small as well, and then excites resonance;
# a *hard* force is not, and adds a motion of its own frequency to order 0:

# %%
soft = eom.scale({alpha: 1, mu: 1, K: 1})
hard = eom.scale({alpha: 1, mu: 1})
display(report.orders(soft, 0), report.orders(soft, 1))
display(report.orders(hard, 0), report.orders(hard, 1))

# %% [markdown]
# ## 3. Resonances
#
# A soft force, to order 1; a hard force, to orders 1 and 2. (The primary resonance of a hard force
# is of order 0: the response is then no longer small against anything, and there is no expansion.)

# %%
soft.resonances(order=1)

# %%
hard.resonances(order=1)

# %%
hard.resonances(order=2)

# %% [markdown]
# ## 4. Primary resonance
#
# $\Omega = \omega_0 + \varepsilon\sigma$, soft force.

# %%
primary = {order: soft.expand(order, {Omega: omega_0}) for order in (1, 2)}
display(report.solvability(primary[2], 1), report.solvability(primary[2], 2))

# %% [markdown]
# Polar form, order 1, with $A = \tfrac12 a e^{i(\gamma + \sigma t)}$; the book's $\gamma$ has the
# other sign:

# %%
report.modulation(primary[1])

# %% [markdown]
# In a steady state both rates vanish. `response_relation` eliminates the phase and gives the
# polynomial that is zero then:


# %%
def vanishes(polynomial):
    """A relation between amplitude and parameters as a formula."""
    return Math(f"{sp.latex(polynomial)} = 0")


def same(found, printed):
    """Whether two relations are the same, but for a factor of the parameters alone."""
    quotient = sp.cancel(found / printed)
    return quotient != 0 and not quotient.has(a, sigma)


a = modulus(u)
sigma = primary[1].relations[0].detuning
vanishes(primary[1].slow_flow.response_relation())

# %% [markdown]
# This is the printed frequency response
#
# $$\left[\mu^2 + \left(\sigma - \frac{3\alpha a^2}{8\omega_0}\right)^2\right] a^2
#   = \frac{K^2}{4\omega_0^2} ,$$
#
# and the parenthesis is zero on the backbone curve, the free oscillator's own frequency.

# %%
bend = alpha * a**2 / (8 * omega_0)
printed = (mu**2 + (sigma - 3 * bend) ** 2) * a**2 - K**2 / (4 * omega_0**2)
assert same(primary[1].slow_flow.response_relation(), printed)
assert sp.cancel(primary[1].slow_flow.backbone()[sigma] - 3 * bend) == 0

# %% [markdown]
# Steady states are stable where the determinant of the Jacobian is positive (the trace is
# $-2\mu$). Printed: unstable where
#
# $$\left(\sigma - \frac{3\alpha a^2}{8\omega_0}\right)
#   \left(\sigma - \frac{9\alpha a^2}{8\omega_0}\right) + \mu^2 < 0 ;$$
#
# where it is zero, two steady states meet in a saddle-node:

# %%
relation, fold = primary[1].slow_flow.bifurcation_equations()["saddle-node"]
assert same(relation, printed)
assert same(fold, (sigma - 3 * bend) * (sigma - 9 * bend) + mu**2)
vanishes(fold)

# %% [markdown]
# ## 5. Superharmonic resonance of order 3
#
# $3\Omega = \omega_0 + \varepsilon\sigma$, hard force. The force alone moves the mass by
# $2\Lambda\cos\Omega t$ with $\Lambda = K/2(\omega_0^2 - \Omega^2)$, and the cube of that has the
# frequency $3\Omega$:

# %%
superharmonic = {order: hard.expand(order, {3 * Omega: omega_0}) for order in (1, 2)}
display(report.solvability(superharmonic[1], 1), report.modulation(superharmonic[1]))

# %% [markdown]
# $\Omega$ is replaced strictly, so that $\Lambda = 9K/16\omega_0^2$ here, and its change with
# $\sigma$ is part of order 2. The printed relation is
#
# $$\left[\mu^2 + \left(\sigma - \frac{3\alpha\Lambda^2}{\omega_0}
#   - \frac{3\alpha a^2}{8\omega_0}\right)^2\right] a^2 = \frac{\alpha^2\Lambda^6}{\omega_0^2} .$$

# %%
Lambda = K / (2 * (omega_0**2 - Omega**2))
third = Lambda.subs(Omega, omega_0 / 3)
shift = sigma - 3 * alpha * third**2 / omega_0 - 3 * bend
printed = (mu**2 + shift**2) * a**2 - alpha**2 * third**6 / omega_0**2
flow = superharmonic[1].slow_flow
assert same(flow.response_relation(), printed)
assert sp.cancel(flow.backbone()[sigma] - (sigma - shift)) == 0

# %% [markdown]
# ## 6. Subharmonic resonance of order 1/3
#
# $\Omega = 3\omega_0 + \varepsilon\sigma$, hard force.

# %%
subharmonic = {order: hard.expand(order, {Omega: 3 * omega_0}) for order in (1, 2)}
display(report.solvability(subharmonic[1], 1), report.modulation(subharmonic[1]))

# %% [markdown]
# Here $\Lambda = -K/16\omega_0^2$. Besides $a = 0$, printed:
#
# $$9\mu^2 + \left(\sigma - \frac{9\alpha\Lambda^2}{\omega_0}
#   - \frac{9\alpha a^2}{8\omega_0}\right)^2 = \frac{81\alpha^2\Lambda^2}{16\omega_0^2}\,a^2 .$$

# %%
triple = Lambda.subs(Omega, 3 * omega_0)
left = 9 * mu**2 + (sigma - 9 * alpha * triple**2 / omega_0 - 9 * bend) ** 2
right = 81 * alpha**2 * triple**2 * a**2 / (16 * omega_0**2)
flow = subharmonic[1].slow_flow
assert same(flow.response_relation(), left - right)
assert sp.cancel(flow.backbone()[sigma] - 9 * alpha * triple**2 / omega_0 - 9 * bend) == 0

# %% [markdown]
# It is quadratic in $a^2$, so the subharmonic exists where the discriminant is not negative and
# the sum of the roots is positive. Printed:
#
# $$\frac{\alpha\Lambda^2}{\omega_0}\left(\sigma - \frac{63\alpha\Lambda^2}{8\omega_0}\right)
#   \ge 2\mu^2, \qquad \Lambda^2 < \frac{4\omega_0\sigma}{27\alpha} .$$

# %%
square = sp.Symbol("x", real=True)
quadratic = sp.Poly((left - right).subs(a, sp.sqrt(square)), square)
leading, middle, _ = quadratic.all_coeffs()
reach = alpha * triple**2 / omega_0
condition = reach * (sigma - 63 * reach / 8) - 2 * mu**2
assert sp.cancel(quadratic.discriminant() / condition - 729 * alpha**2 / (32 * omega_0**2)) == 0
total = sp.cancel(-middle / leading)
assert sp.cancel(total / (4 * omega_0 * sigma / (27 * alpha) - triple**2)) == 12

# %% [markdown]
# With $\omega_0 = \alpha = 1$, $\mu = 0.05$, $K = 8$, $\sigma = 6$ the two amplitudes are

# %%
numbers = {omega_0: 1, alpha: 1, mu: sp.Rational(1, 20), K: 8, sigma: 6}
roots = [sp.sqrt(r).evalf(9) for r in sp.Poly(quadratic.as_expr().subs(numbers), square).nroots(20)]
assert sorted(map(str, roots)) == ["1.39465604", "2.39198687"]
roots

# %% [markdown]
# ## 7. Steady states of the exact equation
#
# Periodic motions of the unexpanded equation are found by collocation, without anything of the
# expansion but the first guess, and the amplitude of the coordinate's own harmonic is set beside
# that of the slow flow, while ε is halved. The differences of order $N$ must fall like
# $\varepsilon^N$: by halves for order 1, by quarters for order 2.

# %%
NUMBERS = {"omega_0": 1.0, "alpha": 0.8, "mu": 0.3}
FAMILIES = {
    # flows, harmonic of the motion that is the coordinate's own, numbers, near which equilibrium
    "primary": (primary, 1, {**NUMBERS, "K": 1.6, "sigma": 0.2}, 0.5 - 0.2j),
    "superharmonic 3": (superharmonic, 3, {**NUMBERS, "K": 1.1, "sigma": 1.2}, 0.5 - 0.2j),
    "subharmonic 1/3": (
        subharmonic,
        1,
        {"omega_0": 1.0, "alpha": 1.0, "mu": 0.05, "K": 8.0, "sigma": 6.0},
        1.2 * np.exp(1j * np.pi / 3),
    ),
}


rows = []
for name, (flows, _, values, guess) in FAMILIES.items():
    for halvings in range(5, 9):
        differences = []
        for case in flows.values():
            slow, _ = scaled_values(case, values, 0.5**halvings)
            found = case.slow_flow.equilibria(slow).amplitudes
            start = min(found, key=lambda b: abs(b[0] - guess))
            (exact,) = mg.orbit_near(case, slow, start).amplitudes
            differences.append(f"{abs(2 * abs(start[0]) - exact):.1e}")
        rows.append((name, f"1/{2**halvings}", f"{exact:.5f}", *differences))
report.Table(("resonance", "ε", "exact $a$ (m)", "order 1", "order 2"), tuple(rows))

# %% [markdown]
# The whole curves at ε = 1 and small numbers: from one periodic motion the exact ones are followed
# along Ω, through folds, with their stability from Floquet multipliers.

# %%
SMALL = {"omega_0": 1.0, "alpha": 0.05}
SHOWN = {
    # numbers, range of σ, σ at which the exact motions begin, largest amplitude
    "primary": ({**SMALL, "mu": 0.02, "K": 0.1}, (-0.1, 0.2), -0.1, 2.8),
    "superharmonic 3": ({**SMALL, "mu": 0.002, "K": 0.7}, (-0.03, 0.09), -0.03, 1.7),
    "subharmonic 1/3": ({**SMALL, "mu": 0.01, "K": 8.0}, (0.05, 0.4), 0.4, 3.2),
}


def response(name, order):
    """All equilibria of an order over σ."""
    values, ends, *_ = SHOWN[name]
    flow = FAMILIES[name][0][order].slow_flow
    return flow.frequency_response({**values, "sigma": np.linspace(*ends, 401)})


def exact_family(name):
    """Exact motions along Ω, begun near the smallest that the slow flow of order 2 has."""
    case, (values, ends, first, _) = FAMILIES[name][0][2], SHOWN[name]
    speeds = [scaled_values(case, {**values, "sigma": s}, 1.0)[1]["Omega"] for s in ends]
    found = case.slow_flow.equilibria({**values, "sigma": first}).amplitudes
    start = next(b for b in found if abs(b[0]) > 0)
    orbit = mg.orbit_near(case, {**values, "sigma": first}, start).orbit
    return mg.orbits.follow(orbit.problem, orbit, Omega, tuple(speeds))


def detuning(name, speed):
    """σ at a frequency of the force."""
    relation = FAMILIES[name][0][1].relations[0]
    return float((relation.lhs - relation.rhs).subs({Omega: speed, omega_0: 1.0}))


responses = {(name, order): response(name, order) for name in FAMILIES for order in (1, 2)}
families = {name: exact_family(name) for name in FAMILIES}

# %% [markdown]
# Stable motions are solid lines and filled points, unstable ones dashed lines and open points.
# Order 2 follows the exact curves where order 1 does not yet; its backbone runs between its two
# branches.

# %%
figure, panels = plt.subplots(1, 3, figsize=(9.0, 3.8), layout="constrained")
for axes, name in zip(panels, FAMILIES, strict=True):
    family, number = families[name], FAMILIES[name][1]
    for order in (1, 2):
        points = [
            (detuning(name, speed), [orbit.amplitude(0, number)], orbit.stable)
            for speed, orbit in zip(family.values, family.orbits, strict=True)
        ]
        plotting.frequency_response(
            responses[name, order],
            [f"order {order}"],
            points=points if order == 2 else (),
            colour=order - 1,
            xlabel="σ (rad/s)",
            ylabel="a (m)",
            axes=axes,
        )
    numbers = {x: SHOWN[name][0][x.name] for x in (omega_0, alpha, mu, K)}
    curve = FAMILIES[name][0][2].slow_flow.backbone()[sigma].subs(numbers)
    sizes = np.linspace(0.0, SHOWN[name][3], 101)
    shifts = sp.lambdify(a, curve)(sizes)
    plotting.backbone({"backbone, order 2": (shifts, sizes)}, axes=axes)
    axes.set(title=name, xlim=SHOWN[name][1], ylim=np.array([-0.03, 1]) * SHOWN[name][3])
    axes.locator_params(axis="x", nbins=4)
plotting.shared_legend(panels)
plt.show()

# %% [markdown]
# The folds, where the response jumps: saddle-nodes of the slow flow beside those of exact motions.


# %%
def folds(name, order):
    """Detunings at which the slow flow has saddle-nodes of moderate amplitude."""
    found = responses[name, order].bifurcations
    return [b.parameter for b in found if b.kind == "saddle-node" and b.modulus[0] < SHOWN[name][3]]


rows = []
for name, family in families.items():
    exact = sorted(detuning(name, special.value) for special in family.folds)
    for row in zip(exact, folds(name, 1), folds(name, 2), strict=True):
        rows.append((name, *(f"{x:.4f}" for x in row)))
report.Table(("resonance", "exact σ (rad/s)", "order 1", "order 2"), tuple(rows))

# %% [markdown]
# ## 8. Certificates
#
# Motions far from the steady states as well, over times of order $1/\varepsilon$, must part from
# exact ones like $\varepsilon^N$. So must the amplitudes of steady states; their stability and the
# detunings of their folds are better by one order.


# %%
def samples(case):
    """Generic numbers at ε = 1, a strong force where it is hard and far from resonance."""
    force = 8.3 if case in subharmonic.values() else 1.7
    return {"omega_0": 1.3, "alpha": 0.7, "mu": 0.11, "K": force, "sigma": 0.37}


FOLDS = {
    "primary": ({"omega_0": 1.0, "alpha": 1.0, "mu": 0.1, "K": 0.8, "sigma": 0.73}, -0.4 - 0.08j),
    "superharmonic 3": (
        {"omega_0": 1.0, "alpha": 1.0, "mu": 0.02, "K": 1.0, "sigma": 1.38},
        0.31 + 0.02j,
    ),
    "subharmonic 1/3": (
        {"omega_0": 1.0, "alpha": 1.0, "mu": 0.05, "K": 8.0, "sigma": 1.99},
        -0.11 + 0.23j,
    ),
}


def steady(case):
    """The equilibrium of section 7 and a saddle-node of each resonance."""
    name = next(n for n, (flows, *_) in FAMILIES.items() if case in flows.values())
    *_, values, guess = FAMILIES[name]
    return [
        mg.Steady(values, [guess]),
        mg.Steady(FOLDS[name][0], [FOLDS[name][1]], "saddle-node"),
    ]


emission = mg.Emission(
    model="duffing_forced",
    cases=[*primary.values(), *superharmonic.values(), *subharmonic.values()],
    samples=samples,
    amplitudes=lambda case: ([0.5 + 0.4j], 1.0 if case in primary.values() else 0.6),
    steady=steady,
    derivation="derivations/duffing_forced.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 4",
)
report.certificate_table(emission.certificates.values())

# %%
made = list(emission.certificates.values())
plotting.convergence(made, quantity="motions at times of order 1/ε")
plt.show()

# %% [markdown]
# The frequency of the force at which the folds are, against that of folds of exact periodic orbits:

# %%
plotting.convergence(made, quantity="saddle-node")
plt.ylabel("error of Ω at the saddle-node (rad/s)")
plt.show()

# %% [markdown]
# ## 9. The emitted functions
#
# `equilibria` gives all steady states of each point of an array, `frequency_response` branches in
# their order along the curve, with bifurcations:
#
# ```python
# from mms_functions.duffing_forced import Omega_is_omega_0_order_2 as case
#
# found = case.equilibria(omega_0=1.0, alpha=0.05, mu=0.02, K=0.1, sigma=0.07)
# found.modulus, found.stable
# ```

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
