# %% [markdown]
# # An oscillator with quadratic and cubic stiffness, driven hard
#
# A quadratic term answers a strong force at half the natural frequency with two swings a period,
# and makes a force at twice the natural frequency feed the oscillator like a modulated stiffness.
# The relations are those of Nayfeh and Mook, *Nonlinear Oscillations* (1979), chapter 4, for
#
# $$\ddot u + 2\mu\dot u + \omega_0^2 u + \alpha_2 u^2 + \alpha_3 u^3 = K\cos\Omega t .$$

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown, display
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
omega_0, alpha_2, mu, K, Omega = sp.symbols("omega_0 alpha_2 mu K Omega", positive=True)
alpha_3 = sp.Symbol("alpha_3", real=True)
potential = omega_0**2 * u**2 / 2 + alpha_2 * u**3 / 3 + alpha_3 * u**4 / 4
model = mg.Model(
    lagrangian=u.diff(t) ** 2 / 2 - potential,
    coordinates=[u],
    dissipation=mu * u.diff(t) ** 2,
    forces={u: K * sp.cos(Omega * t)},
    parameters=[
        mg.Parameter(omega_0, "rad/s", "frequency of small oscillations"),
        mg.Parameter(Omega, "rad/s", "frequency of the force"),
        mg.Parameter(alpha_2, "1/(m s^2)", "quadratic stiffness over the mass"),
        mg.Parameter(alpha_3, "1/(m^2 s^2)", "cubic stiffness over the mass"),
        mg.Parameter(mu, "1/s", "half the damping over the mass"),
        mg.Parameter(K, "m/s^2", "amplitude of the force over the mass"),
    ],
)
eom = model.equations_of_motion()
report.equations(eom)

# %% [markdown]
# ## 2. Orders in ε
#
# The force is hard. Damping and the quadratic term are of order ε, the cubic one of order ε²:

# %%
scaled = eom.scale({alpha_2: 1, mu: 1, alpha_3: 2})
for p in (0, 1, 2):
    display(report.orders(scaled, p))

# %% [markdown]
# ## 3. Resonances
#
# Those of the quadratic term come first, those of the cubic term at order 2:

# %%
scaled.resonances(order=2)

# %% [markdown]
# ## 4. Superharmonic resonance of order 2
#
# $2\Omega = \omega_0 + \varepsilon\sigma$.

# %%
superharmonic = {order: scaled.expand(order, {2 * Omega: omega_0}) for order in (1, 2)}
display(report.solvability(superharmonic[2], 1), report.solvability(superharmonic[2], 2))
report.modulation(superharmonic[1])

# %% [markdown]
# The slow flow of order 1 is that of a linear oscillator driven by the square of the forced motion
# $2\Lambda\cos\Omega t$, where $\Lambda = K/2(\omega_0^2 - \Omega^2) = 2K/3\omega_0^2$. Printed:
#
# $$a = \frac{\alpha_2\Lambda^2}{\omega_0\sqrt{\mu^2 + \sigma^2}} .$$

# %%
a = modulus(u)
sigma = superharmonic[1].relations[0].detuning
Lambda = K / (2 * (omega_0**2 - Omega**2))
half = Lambda.subs(Omega, omega_0 / 2)
printed = a**2 * omega_0**2 * (mu**2 + sigma**2) - alpha_2**2 * half**4
quotient = sp.cancel(superharmonic[1].slow_flow.response_relation() / printed)
assert quotient != 0 and not quotient.has(a, sigma)

# %% [markdown]
# ## 5. Subharmonic resonance of order 1/2
#
# $\Omega = 2\omega_0 + \varepsilon\sigma$.

# %%
subharmonic = {order: scaled.expand(order, {Omega: 2 * omega_0}) for order in (1, 2)}
display(report.solvability(subharmonic[2], 1), report.solvability(subharmonic[2], 2))

# %% [markdown]
# At order 1 the slow flow is linear: the forced motion modulates the stiffness, as in Mathieu's
# equation, and the motion without a subharmonic is stable or not.

# %%
display(report.polynomial(subharmonic[1]))
report.boundary(subharmonic[1])

# %% [markdown]
# Printed, with $\Lambda = -K/6\omega_0^2$: disturbances grow like $e^{\Gamma t}$ with
#
# $$\Gamma = -\mu \pm \sqrt{\frac{\alpha_2^2\Lambda^2}{\omega_0^2} - \frac{\sigma^2}{4}}, \qquad
#   \text{so that}\quad |\sigma| < 2\sqrt{\frac{\alpha_2^2\Lambda^2}{\omega_0^2} - \mu^2}
#   \quad\text{is unstable.}$$

# %%
Gamma = sp.Symbol("Gamma")
double = Lambda.subs(Omega, 2 * omega_0)
polynomial = subharmonic[1].slow_flow.characteristic_polynomial(Gamma)
printed = (Gamma + mu) ** 2 - alpha_2**2 * double**2 / omega_0**2 + sigma**2 / 4
assert sp.cancel(polynomial - printed) == 0
edge = 2 * sp.sqrt(alpha_2**2 * double**2 / omega_0**2 - mu**2)
lower, upper = subharmonic[1].slow_flow.boundary()
assert sp.cancel(upper**2 - edge**2) == 0
assert sp.cancel(lower + upper) == 0

# %% [markdown]
# Order 2 bends the response, by the same combination of both terms as in free motion
# (`helmholtz_duffing`), and so limits the growth.

# %%
report.modulation(subharmonic[2])

# %% [markdown]
# Its backbone curve, about which the response bends, shows it:

# %%
report.expression(r"\sigma", subharmonic[2].slow_flow.backbone()[sigma])

# %% [markdown]
# ## 6. The exact equation
#
# Superharmonic: the amplitude of periodic motions of the unexpanded equation, by collocation. The
# error of order $N$ falls like $\varepsilon^N$.

# %%
NUMBERS = {"omega_0": 1.0, "alpha_2": 0.9, "alpha_3": 0.5, "mu": 0.3, "K": 1.1, "sigma": 0.4}
rows = []
for halvings in range(4, 9):
    pairs = []
    for case in superharmonic.values():
        slow, _ = scaled_values(case, NUMBERS, 0.5**halvings)
        start = case.slow_flow.equilibria(slow).amplitudes[0]
        (exact,) = mg.orbit_near(case, slow, start).amplitudes
        pairs.append((2 * abs(start[0]), exact))
    differences = (f"{abs(found - exact):.1e}" for found, exact in pairs)
    rows.append((f"1/{2**halvings}", f"{pairs[1][1]:.6f}", *differences))
report.Table(("ε", "exact $a$ (m)", "order 1", "order 2"), tuple(rows))

# %% [markdown]
# Subharmonic: how fast disturbances of the forced motion grow, from the Floquet multipliers of the
# exact periodic motion. The error of order $N$ falls like $\varepsilon^{N+1}$.

# %%
GROWING = {"omega_0": 1.0, "alpha_2": 2.9, "alpha_3": 0.5, "mu": 0.05, "K": 1.3, "sigma": 0.2}
rows = []
for halvings in range(3, 8):
    growths = []
    for case in subharmonic.values():
        slow, _ = scaled_values(case, GROWING, 0.5**halvings)
        growths.append(case.slow_flow.equilibria(slow).growth[0])
        exact = mg.orbit_near(case, slow, [0.0]).orbit.growth
    errors = (f"{abs(growth - exact):.1e}" for growth in growths)
    rows.append((f"1/{2**halvings}", f"{exact:.7f}", *errors))
report.Table(("ε", "exact growth (1/s)", "order 1", "order 2"), tuple(rows))

# %% [markdown]
# The responses at ε = 1 and small numbers, stable motions with solid lines and filled points,
# unstable ones with dashed lines and open points. Order 1 of the superharmonic is a linear
# resonance; order 2 leans to the side of the softer spring and folds. The subharmonic branches off
# where the motion that has the force's own period, $a = 0$, loses its stability and regains it.

# %%
SMALL = {"omega_0": 1.0, "alpha_2": 0.2, "alpha_3": 0.01, "mu": 0.003}
SHOWN = {
    # flows, force, range of σ
    "superharmonic 2": (superharmonic, 0.2, (-0.03, 0.02)),
    "subharmonic 1/2": (subharmonic, 0.3, (-0.045, 0.03)),
}


def used(case, numbers):
    """Those numbers that are parameters of a case."""
    names = {p.name for p in case.parameters}
    return {name: number for name, number in numbers.items() if name in names}


figure, panels = plt.subplots(1, 2, figsize=(8.4, 4.2), layout="constrained")
for axes, (name, (flows, force, ends)) in zip(panels, SHOWN.items(), strict=True):
    for order, case in flows.items():
        values, points = used(case, {**SMALL, "K": force}), []
        response = case.slow_flow.frequency_response({**values, "sigma": np.linspace(*ends, 401)})
        if order == 2:
            points = list(mg.orbits_along(case, values, response, 24))
        if order == 2 and name == "subharmonic 1/2":
            for s in np.linspace(*ends, 9)[1:-1]:
                rest = mg.orbit_near(case, {**values, "sigma": s}, [0.0])
                points.append((s, rest.amplitudes, rest.stable))
        plotting.frequency_response(
            response,
            [f"order {order}"],
            points=points,
            colour=order - 1,
            xlabel="σ (rad/s)",
            ylabel="a (m)",
            axes=axes,
        )
    axes.set(title=name, xlim=ends, ylim=(-0.03, 1.5))
    axes.locator_params(axis="x", nbins=6)
plotting.shared_legend(panels)
plt.show()

# %% [markdown]
# ## 7. Certificates
#
# Motions over times of order $1/\varepsilon$. At order 1 of the subharmonic the slow flow is
# linear, the equation is not, and it is certified by motions all the same. Beside them the steady
# states of section 6: amplitudes of the superharmonic, and the stability of both.

# %%
GENERIC = {"omega_0": 1.3, "alpha_2": 0.6, "alpha_3": 0.7, "mu": 0.11, "K": 1.1, "sigma": 0.37}


def steady(case):
    """The superharmonic response, and the forced motion that is no subharmonic."""
    if case in superharmonic.values():
        return [mg.Steady(used(case, NUMBERS), [0.39 + 0.29j])]
    return [mg.Steady(used(case, GROWING), [0.0])]


emission = mg.Emission(
    model="helmholtz_duffing_forced",
    cases=[*superharmonic.values(), *subharmonic.values()],
    samples=lambda case: used(case, GENERIC),
    amplitudes=lambda case: ([0.4 + 0.3j], 1.0),
    steady=steady,
    derivation="derivations/helmholtz_duffing_forced.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 4",
)
report.certificate_table(emission.certificates.values())

# %%
plotting.convergence(list(emission.certificates.values()), quantity="motions at times of order 1/ε")
plt.show()

# %% [markdown]
# ## 8. The emitted functions
#
# The linear slow flow of the subharmonic at order 1 comes with its growth rate and its edges:
#
# ```python
# from mms_functions.helmholtz_duffing_forced import Omega_is_two_omega_0_order_1 as case
#
# low, high = case.boundaries(omega_0=1.0, alpha_2=0.2, mu=0.005, K=1.3)
# ```

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
