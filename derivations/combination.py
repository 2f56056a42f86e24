# %% [markdown]
# # Combination resonances of two parametrically coupled coordinates
#
# A column under a pulsating load, a plate in a pulsating stream: two modes whose stiffnesses and
# coupling are modulated together,
#
# $$\ddot x + 2\mu_1\dot x + \omega_1^2 x + 2\cos(\Omega t)\,(f_{11} x + f_{12} y) = 0, \qquad
#   \ddot y + 2\mu_2\dot y + \omega_2^2 y + 2\cos(\Omega t)\,(f_{21} x + f_{22} y) = 0 .$$
#
# Besides the principal resonances $\Omega = 2\omega_j$ of each mode by itself there are resonances
# that need both: the *sum* combination $\Omega = \omega_1 + \omega_2$ and the *difference*
# combination $\Omega = \omega_2 - \omega_1$.
#
# What is reproduced: the transition curves of A. H. Nayfeh and D. T. Mook, *Nonlinear Oscillations*
# (1979), chapter 5,
#
# $$\Omega = \omega_1 + \omega_2 \pm \sqrt{\frac{f_{12} f_{21}}{\omega_1\omega_2}}, \qquad
#   \Omega = \omega_2 - \omega_1 \pm \sqrt{-\frac{f_{12} f_{21}}{\omega_1\omega_2}} .$$

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown, display
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report

# %% [markdown]
# ## 1. The model
#
# Where the load has a potential, $f_{12} = f_{21}$ for coordinates of equal mass; loads that follow
# the deflection make the two differ, even in sign. So the equations are written down as they stand.

# %%
t = dynamicsymbols._t
x, y = coordinates = dynamicsymbols("x y")
omega_1, omega_2, Omega = sp.symbols("omega_1 omega_2 Omega", positive=True)
mu_1, mu_2 = sp.symbols("mu_1 mu_2", positive=True)
f_11, f_12, f_21, f_22 = couplings = sp.symbols("f_11 f_12 f_21 f_22", real=True)

model = mg.Model.from_equations(
    [
        q.diff(t, 2)
        + 2 * mu * q.diff(t)
        + omega**2 * q
        + 2 * sp.cos(Omega * t) * (left * x + right * y)
        for q, mu, omega, left, right in (
            (x, mu_1, omega_1, f_11, f_12),
            (y, mu_2, omega_2, f_21, f_22),
        )
    ],
    coordinates,
    parameters=[
        mg.Parameter(omega_1, "rad/s", "natural frequency of the first mode"),
        mg.Parameter(omega_2, "rad/s", "natural frequency of the second mode"),
        mg.Parameter(Omega, "rad/s", "frequency of the load"),
        *(mg.Parameter(f, "rad^2/s^2", "half the modulation of a stiffness") for f in couplings),
        mg.Parameter(mu_1, "1/s", "damping of the first mode"),
        mg.Parameter(mu_2, "1/s", "damping of the second mode"),
    ],
)
eom = model.equations_of_motion()
report.equations(eom)

# %% [markdown]
# ## 2. Orders in ε and resonances
#
# The modulation is of order ε; at first there is no damping.

# %%
undamped = eom.reparametrise({mu_1: 0, mu_2: 0})
scaled = undamped.scale(dict.fromkeys(couplings, 1))
display(report.orders(scaled, 1))
scaled.resonances(order=2)

# %% [markdown]
# ## 3. Sum combination
#
# $\Omega = \omega_1 + \omega_2 + \varepsilon\sigma$:

# %%
sums = {order: scaled.expand(order, {Omega: omega_1 + omega_2}) for order in (1, 2)}
display(report.solvability(sums[1], 1))
display(report.polynomial(sums[1]))
display(report.verdict(sums[1]))
report.boundary(sums[1])

# %% [markdown]
# Exactly the printed curves:


# %%
def agrees(case, product):
    """Whether the edges are ± the root of a product."""
    lower, upper = case.slow_flow.boundary()
    return sp.expand(lower + upper) == 0 and sp.cancel(upper**2 - product) == 0


product = f_12 * f_21 / (omega_1 * omega_2)
assert agrees(sums[1], product)

# %% [markdown]
# Order 2 shifts the centre of the zone, to which the modulation of each mode's own stiffness
# contributes:

# %%
report.boundary(sums[2])

# %% [markdown]
# ## 4. Difference combination
#
# $\Omega = \omega_2 - \omega_1 + \varepsilon\sigma$: the same with the other sign of the product,
# so that with $f_{12} = f_{21}$ there is no zone.

# %%
differences = {order: scaled.expand(order, {Omega: omega_2 - omega_1}) for order in (1, 2)}
display(report.solvability(differences[1], 1))
display(report.verdict(differences[1]))
assert agrees(differences[1], -product)
display(report.boundary(differences[1]))
report.boundary(differences[2])

# %% [markdown]
# ## 5. Principal resonance, alone and together with a combination
#
# $\Omega = 2\omega_1 + \varepsilon\sigma$ moves the first mode alone. The coupling shifts the zone
# at order 2:

# %%
principal = scaled.expand(2, {Omega: 2 * omega_1})
display(report.solvability(principal, 1, only=[x]))
report.boundary(principal)

# %% [markdown]
# If besides $\omega_2$ is nearly $3\omega_1$, then $\Omega$ is near $\omega_2 - \omega_1$ as well,
# and energy passes into the second mode. Each relation has a detuning of its own,
# $\Omega = 2\omega_1 + \varepsilon\sigma_1$ and $\omega_2 = 3\omega_1 + \varepsilon\sigma_2$:

# %%
together = scaled.expand(1, {Omega: 2 * omega_1, omega_2: 3 * omega_1})
display(report.solvability(together, 1))
report.polynomial(together)

# %% [markdown]
# ## 6. Damping
#
# Damping of order ε. The sum combination:

# %%
lossy = eom.scale(dict.fromkeys((*couplings, mu_1, mu_2), 1))
damped = lossy.expand(1, {Omega: omega_1 + omega_2})
display(report.polynomial(damped))
report.boundary(damped)

# %% [markdown]
# The edges are those of
#
# $$\sigma^2 = \frac{(\mu_1 + \mu_2)^2}{4\mu_1\mu_2}
#   \left(\frac{f_{12}f_{21}}{\omega_1\omega_2} - 4\mu_1\mu_2\right).$$
#
# For equal and vanishing damping the curve without damping comes back. For unequal damping it does
# not: the factor $(\mu_1 + \mu_2)^2/4\mu_1\mu_2$ is larger than one, so that a little damping of
# one mode *widens* the zone.

# %%
ratio = (mu_1 + mu_2) ** 2 / (4 * mu_1 * mu_2)
assert agrees(damped, ratio * (product - 4 * mu_1 * mu_2))
k, small = sp.symbols("k small", positive=True)
squared = damped.slow_flow.boundary()[1] ** 2
limit = squared.subs({mu_1: small, mu_2: k * small}).cancel().subs(small, 0)
assert sp.cancel(limit - product * (1 + k) ** 2 / (4 * k)) == 0
report.expression(r"\lim_{\mu_1 \to 0} \sigma^2 |_{\mu_2 = k \mu_1}", sp.factor(limit))

# %% [markdown]
# ## 7. Certificates
#
# Characteristic exponents and edges against Floquet theory of the unexpanded equations; the error
# of order $N$ has to fall like $\varepsilon^{N+1}$.

# %%
STIFFNESS = {"f_11": 0.83, "f_12": 1.9, "f_21": 1.1, "f_22": -1.61}
VALUES = {"omega_1": 1.7, "omega_2": 3.9, **STIFFNESS}
DETUNINGS = {"sigma": 0.23, "sigma_1": 0.31, "sigma_2": 0.17}


def samples(case):
    """Values at ε = 1; the signs such that the combination has a zone."""
    opposite = case.relations[0].rhs == omega_2 - omega_1
    values = {**VALUES, "f_12": -1.9 if opposite else 1.9, **DETUNINGS}
    names = {p.name for p in case.parameters} - set(case.weak.detuned)
    return {name: value for name, value in values.items() if name in names}


emission = mg.Emission(
    model="combination",
    cases=[*sums.values(), *differences.values(), principal, together],
    samples=samples,
    derivation="derivations/combination.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5",
)
certificates = list(emission.certificates.values())
report.certificate_table(certificates)

# %% [markdown]
# The damped case is certified as well, with $\mu_1 = 0.11\,\varepsilon$ and
# $\mu_2 = 0.37\,\varepsilon$:

# %%
with_losses = mg.certify(damped, {**samples(damped), "mu_1": 0.11, "mu_2": 0.37})
report.certificate_table([with_losses])

# %%
axes = plotting.convergence(certificates[:4])

# %% [markdown]
# ## 8. Zones
#
# Left: the zone of the sum combination for $\omega_1 = 1$, $\omega_2 = 2$,
# $f_{12} = f_{21} = f_{11} = f$ and $f_{22} = 0$, from orders 1 and 2 and
# from Floquet theory. Right: half of its width with damping for $f = 0.1$ and
# $\mu_1 + \mu_2 = 0.01$, over the ratio of the dampings; the line without damping is dotted.

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.4), layout="constrained")
frequencies = {"omega_1": 1.0, "omega_2": 2.0}


def load(f):
    """Couplings of one size."""
    return {**frequencies, "f_11": f, "f_12": f, "f_21": f, "f_22": 0.0 * f}


depth = np.linspace(0, 0.3, 61)
for order in (1, 2):
    low, high = 3.0 + sums[order].slow_flow.boundaries(load(depth)).T
    style = {"color": plotting.COLOURS[order - 1], "ls": plotting.DASHES[order - 1]}
    style["lw"] = plotting.WIDTHS[order - 1]
    left.plot(low, depth, label=f"order {order}", **style)
    left.plot(high, depth, **style)
for f in (0.15, 0.3):
    found = mg.floquet.boundary(undamped, load(f), Omega, (2.6, 3.4), points=21)
    for zone in found.zones:
        left.plot(zone, (f, f), "o", ms=4, mfc="none", mec="black", label="Floquet")
left.set(xlabel="Ω (rad/s)", ylabel="f (rad²/s²)", ylim=(0, 0.32))


def split(ratio):
    """Dampings of one sum."""
    return {"mu_1": 0.01 / (1 + ratio), "mu_2": 0.01 * ratio / (1 + ratio)}


ratios = np.geomspace(0.05, 20, 121)
half = damped.slow_flow.boundaries({**load(np.full_like(ratios, 0.1)), **split(ratios)})[:, 1]
right.semilogx(ratios, half, color=plotting.COLOURS[0], lw=2.4, label="order 1")
right.axhline(0.1 / np.sqrt(2), color="black", ls=":", lw=1.2, label="without damping")
for ratio in (0.05, 1.0, 5.0):
    found = mg.floquet.boundary(eom, {**load(0.1), **split(ratio)}, Omega, (2.8, 3.2), points=21)
    ((low, high),) = found.zones
    right.plot(ratio, (high - low) / 2, "o", ms=4, mfc="none", mec="black", label="Floquet")
right.set(xlabel="μ₂/μ₁", ylabel="half width (rad/s)", ylim=(0, None))
_ = plotting.shared_legend([left, right], 4)

# %% [markdown]
# ## 9. The emitted functions
#
# ```python
# from mms_functions.combination import Omega_is_omega_1_plus_omega_2_order_2 as case
#
# low, high = case.boundaries(omega_1=1.0, omega_2=2.0, f_11=0.1, f_12=0.1, f_21=0.1, f_22=0.0)
# ```

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
