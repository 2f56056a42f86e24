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
import steady
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
sigma = primary[1].relations[0].detuning
a = modulus(u)
in_rho = {a: 2 * sp.sqrt(rho), K: mu * omega_0 * K, sigma: mu * sigma}
printed = 4 * (rho * (1 - rho) ** 2 + 4 * sigma**2 * rho) / K**2
found = steady.response(primary[1]).subs(in_rho, simultaneous=True)
assert sp.cancel(found - printed) == 0

# %% [markdown]
# They are stable, so that the oscillator stays locked, where the trace $1 - 2\rho$ (times $\mu$)
# is negative and the determinant (times $\mu^2$) is positive:
#
# $$\rho > \tfrac12, \qquad \tfrac14\left(1 - 4\rho + 3\rho^2\right) + \sigma^2 > 0 .$$

# %%
stability = steady.determinant(primary[1]).subs(in_rho, simultaneous=True) / mu**2
assert sp.cancel(stability - (1 - 4 * rho + 3 * rho**2) / 4 - sigma**2) == 0
trace = sp.trace(primary[1].slow_flow.jacobian)
x, y = primary[1].slow_flow.cartesian
on_circle = sp.expand(trace).subs(x**2, a**2 - y**2).expand().subs(in_rho, simultaneous=True)
assert sp.expand(on_circle / mu - (1 - 2 * rho)) == 0

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
# Periodic motions of the unexpanded equation, by collocation (`derivations/steady.py`), beside the
# steady states of the slow flow: the amplitude of order $N$ is off by $\varepsilon^N$.

# %%
LOCKED = {"omega_0": 1.0, "mu": 0.8, "K": 0.9, "sigma": 0.15}
rows = []
for halvings in range(3, 8):
    pairs = []
    for case in primary.values():
        slow, _ = scaled_values(case, LOCKED, 0.5**halvings)
        start = steady.equilibrium(case, slow, -1.1j)
        pairs.append((2 * abs(start), steady.exact_amplitude(case, slow, start)))
    differences = (f"{abs(found - exact):.1e}" for found, exact in pairs)
    rows.append((f"1/{2**halvings}", f"{pairs[1][1]:.6f}", *differences))
report.Table(("ε", "exact $a$ (m)", "order 1", "order 2"), tuple(rows))

# %% [markdown]
# ## 6. Certificates


# %%
def samples(case):
    """Generic numbers at ε = 1."""
    values = {"omega_0": 1.2, "mu": 0.7, "K": 1.3, "sigma": 0.57, "Omega": 2.9}
    names = {p.name for p in case.parameters} - set(case.weak.detuned)
    return {name: value for name, value in values.items() if name in names}


emission = mg.Emission(
    model="van_der_pol_forced",
    cases=[*primary.values(), *quenching.values()],
    samples=samples,
    amplitudes=lambda case: ([-0.2 - 0.4j], 1.0),
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
