# %% [markdown]
# # Rayleigh's oscillator
#
# Rayleigh explained the sustained note of a clarinet by a damping that is negative while the reed
# moves slowly and positive while it moves fast. The result to order 1 is that of Nayfeh and Mook,
# *Nonlinear Oscillations* (1979), chapter 3; order 4 is compared with van der Pol's oscillator, of
# which this one is the integral.

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown, Math, display
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.symbols import modulus, phase

# %% [markdown]
# ## 1. The model

# %%
t = dynamicsymbols._t
u = dynamicsymbols("u")
omega_0, mu = sp.symbols("omega_0 mu", positive=True)
v = u.diff(t)
model = mg.Model(
    lagrangian=v**2 / 2 - omega_0**2 * u**2 / 2,
    coordinates=[u],
    forces={u: mu * (v - v**3 / 3)},
    parameters=[
        mg.Parameter(omega_0, "rad/s", "natural frequency"),
        mg.Parameter(mu, "1/s", "strength of the self-excitation, which turns at 1 m/s"),
    ],
)
eom = model.equations_of_motion()
report.equations(eom)

# %% [markdown]
# ## 2. Orders in ε
#
# The self-excitation is weak. Nothing from outside excites the oscillator, so it has no resonances.

# %%
scaled = eom.scale({mu: 1})
for p in range(3):
    display(report.orders(scaled, p))
len(scaled.resonances(order=4))

# %% [markdown]
# ## 3. The limit cycle
#
# Order 1 is printed as $\dot a = \tfrac12\mu a\left(1 - \tfrac14\omega_0^2 a^2\right)$:

# %%
a, gamma = modulus(u), phase(u)
cases = {order: scaled.expand(order) for order in (1, 2, 4)}
for p in (1, 2, 3, 4):
    display(report.solvability(cases[4], p))
first, polar = cases[1].slow_flow.polar[a], cases[4].slow_flow.polar
assert sp.expand(first - mu * a * (1 - omega_0**2 * a**2 / 4) / 2) == 0

# %% [markdown]
# To order 4, the amplitude through $\mu^3$ and the frequency through $\mu^4$. If $u$ is Rayleigh's
# motion, then $\dot u$ is van der Pol's (differentiate the equation): both limit cycles have one
# frequency, $1 - \tfrac1{16}\mu^2 + \tfrac{17}{3072}\mu^4$ for $\omega_0 = 1$, and with $a$ the
# amplitude of the fundamental, $\omega a = 2 + \tfrac1{64}\mu^2$.

# %%
one = {omega_0: 1}
size, balance = sp.Integer(2), sp.expand(polar[a].subs(one) / (a * mu))
for n in (1, 2, 3):
    unknown = sp.Symbol("x")
    (correction,) = sp.solve(balance.subs(a, size + unknown * mu**n).expand().coeff(mu, n), unknown)
    size += correction * mu**n
speed = sp.expand(1 + polar[gamma].subs(one).subs(a, size))
speed = sum(speed.coeff(mu, n) * mu**n for n in range(5))
assert speed == 1 - mu**2 / 16 + 17 * mu**4 / 3072
velocity = sp.expand(speed * size)
assert sum(velocity.coeff(mu, n) * mu**n for n in range(4)) == 2 + mu**2 / 64
Math(rf"a = {sp.latex(size, order='rev-lex')},\quad \omega = {sp.latex(speed, order='rev-lex')}")

# %% [markdown]
# Over the strength of the self-excitation, at $\omega_0 = 1$ rad/s. Lines: the equilibrium of the
# slow flow of each order, not expanded any further; points: exact periodic orbits.

# %%
strengths = {omega_0: 1.0, mu: np.linspace(0.01, 2, 200)}
figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.6), layout="constrained")
for order, case in cases.items():
    _, cycles = case.slow_flow.frequency_response(strengths).branches  # rest is the first one
    style = {"color": plotting.COLOURS[order - 1], "ls": plotting.DASHES[order - 1]}
    style["lw"] = plotting.WIDTHS[order - 1]
    left.plot(cycles.parameter, cycles.modulus, label=f"order {order}", **style)
    right.plot(cycles.parameter, 1 + cycles.drift, **style)
for k in range(9, len(cycles.parameter), 19):
    here = {omega_0: 1.0, mu: cycles.parameter[k]}
    near = mg.orbit_near(cases[4], here, cycles.amplitudes[k], cycles.drift[k])
    assert near.stable
    label = "periodic orbits" if k == 9 else None
    left.plot(here[mu], near.amplitudes[0], "ko", ms=3.4, label=label)
    right.plot(here[mu], 2 * np.pi / near.orbit.period, "ko", ms=3.4)
left.set(xlabel="μ (1/s)", ylabel="amplitude of the fundamental (m)")
right.set(xlabel="μ (1/s)", ylabel="frequency of the limit cycle (rad/s)")
_ = left.legend(frameon=False, fontsize="small")

# %% [markdown]
# ## 4. Certificates
#
# Motions on the way to the limit cycle; and the limit cycle beside periodic orbits of the exact
# equation: its amplitude, its frequency, and how fast disturbances of it die out.

# %%
emission = mg.Emission(
    model="rayleigh",
    cases=list(cases.values()),
    samples=lambda case: {"omega_0": 1.2, "mu": 3.9},
    amplitudes=lambda case: ([0.3 + 0.2j], 0.6),
    steady=lambda case: [mg.Steady({"omega_0": 1.2, "mu": 1.9}, [1 / 1.2])],
    derivation="derivations/rayleigh.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 3",
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
# ## 5. The emitted functions

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
