# %% [markdown]
# # Internal resonance 1:3
#
# Two oscillators with cubic terms, the second nearly three times as fast as the first: a beam
# hinged at one end and clamped at the other, a circular plate. Whatever drives the slower one
# drives the faster one too. If the faster one is driven, the slower one may answer at a third of
# the frequency.
#
# Source: A. H. Nayfeh and D. T. Mook, *Nonlinear Oscillations* (1979), chapter 6, systems with
# cubic nonlinearities; for beams A. H. Nayfeh, D. T. Mook and S. Sridhar, "Nonlinear analysis of
# the forced response of structural elements", *J. Acoustical Society of America* 55 (1974)
# 281–291.

# %%
import numpy as np
import sympy as sp
from IPython.display import Markdown
from sympy.physics.mechanics import dynamicsymbols
from two_amplitudes import bifurcations, drawn, used

import mmsgen as mg
from mmsgen import plotting, report

# %% [markdown]
# ## 1. Model
#
# The equations of the book, all cubic terms in both, with a force on either coordinate.

# %%
t = dynamicsymbols._t
u_1, u_2 = dynamicsymbols("u_1 u_2")
omega_1, omega_2, Omega = sp.symbols("omega_1 omega_2 Omega", positive=True)
mu_1, mu_2, F_1, F_2 = sp.symbols("mu_1 mu_2 F_1 F_2", nonnegative=True)
alpha = sp.symbols("alpha_1:9", real=True)
cubes = [u_1**3, u_1**2 * u_2, u_1 * u_2**2, u_2**3]
couplings = [
    sum(c * p for c, p in zip(part, cubes, strict=True)) for part in (alpha[:4], alpha[4:])
]

model = mg.Model.from_equations(
    [
        u_1.diff(t, 2)
        + omega_1**2 * u_1
        + 2 * mu_1 * u_1.diff(t)
        - couplings[0]
        - F_1 * sp.cos(Omega * t),
        u_2.diff(t, 2)
        + omega_2**2 * u_2
        + 2 * mu_2 * u_2.diff(t)
        - couplings[1]
        - F_2 * sp.cos(Omega * t),
    ],
    [u_1, u_2],
    [
        mg.Parameter(omega_1, "rad/s", "natural frequency of the slower oscillator"),
        mg.Parameter(omega_2, "rad/s", "natural frequency of the faster oscillator"),
        mg.Parameter(mu_1, "1/s", "damping of the slower oscillator"),
        mg.Parameter(mu_2, "1/s", "damping of the faster oscillator"),
        *(mg.Parameter(c, "1/(m^2 s^2)", f"cubic term {k}") for k, c in enumerate(alpha, start=1)),
        mg.Parameter(F_1, "m/s^2", "force on the slower oscillator, over its mass"),
        mg.Parameter(F_2, "m/s^2", "force on the faster oscillator, over its mass"),
        mg.Parameter(Omega, "rad/s", "frequency of the force"),
    ],
)
eom = model.equations_of_motion()
report.parameter_table(eom.parameters)

# %%
report.equations(eom)

# %% [markdown]
# ## 2. Orders and resonances
#
# Damping, cubic terms and forces are of order ε.

# %%
weak = (mu_1, mu_2, *alpha)
scaled = eom.scale(dict.fromkeys((*weak, F_1, F_2), 1))
scaled.resonances(order=1)

# %% [markdown]
# ## 3. Free motion, $\omega_2 = 3\omega_1 + \varepsilon\sigma$

# %%
free_scaled = eom.reparametrise({F_1: 0, F_2: 0}).scale(dict.fromkeys(weak, 1))
free = {order: free_scaled.expand(order, {omega_2: 3 * omega_1}) for order in (1, 2)}
report.solvability(free[1], 1)

# %%
report.modulation(free[1])

# %% [markdown]
# The book prints, with $\gamma = \beta_2 - 3\beta_1 + \sigma t$,
#
# $$8\omega_1(\dot a_1 + \mu_1 a_1) = \alpha_2 a_1^2 a_2\sin\gamma, \qquad
#   8\omega_1 a_1\dot\beta_1 = -3\alpha_1 a_1^3 - 2\alpha_3 a_1 a_2^2
#       - \alpha_2 a_1^2 a_2\cos\gamma,$$
# $$8\omega_2(\dot a_2 + \mu_2 a_2) = -\alpha_5 a_1^3\sin\gamma, \qquad
#   8\omega_2 a_2\dot\beta_2 = -3\alpha_8 a_2^3 - 2\alpha_6 a_1^2 a_2 - \alpha_5 a_1^3\cos\gamma.$$
#
# Here $\omega_2$ is replaced by $3\omega_1$, and the phases are those in the frame in which nothing
# depends on time, $\gamma_1 = \beta_1$ and $\gamma_2 = \beta_2 + \sigma t$. The two agree exactly:

# %%
sigma = free[1].relations[0].detuning
polar = free[1].slow_flow.polar
(a_1, gamma_1), (a_2, gamma_2) = list(polar)[:2], list(polar)[2:]
gamma = gamma_2 - 3 * gamma_1
al = dict(enumerate(alpha, start=1))
slow, fast = 8 * omega_1, 8 * 3 * omega_1
printed = {
    a_1: al[2] * a_1**2 * a_2 * sp.sin(gamma) / slow - mu_1 * a_1,
    gamma_1: -(3 * al[1] * a_1**2 + 2 * al[3] * a_2**2 + al[2] * a_1 * a_2 * sp.cos(gamma)) / slow,
    a_2: -al[5] * a_1**3 * sp.sin(gamma) / fast - mu_2 * a_2,
    gamma_2: sigma - (3 * al[8] * a_2**2 + 2 * al[6] * a_1**2) / fast
    - al[5] * a_1**3 * sp.cos(gamma) / (fast * a_2),
}  # fmt: skip
assert all(sp.expand(polar[s] - printed[s]) == 0 for s in polar)

# %% [markdown]
# Without damping, and if $\alpha_2$ and $\alpha_5$ have the same sign, the energy
# $a_1^2 + \nu a_2^2$ with $\nu = \alpha_2\omega_2/(\alpha_5\omega_1)$ is constant, so that both
# amplitudes are bounded:

# %%
energy = a_1**2 + 3 * al[2] / al[5] * a_2**2
undamped = {mu_1: 0, mu_2: 0}
assert sp.expand(sum(energy.diff(s) * polar[s].subs(undamped) for s in polar)) == 0

# %% [markdown]
# ## 4. The faster oscillator driven, $\Omega = \omega_2 + \varepsilon\sigma_2$

# %%
driven_fast = {
    order: scaled.expand(order, {omega_2: 3 * omega_1, Omega: omega_2}) for order in (1, 2)
}
report.modulation(driven_fast[1])

# %% [markdown]
# Either $a_1 = 0$, and $a_2$ is that of a Duffing oscillator; or the slower oscillator takes
# part, and then, with the phases eliminated,
#
# $$\alpha_2^2 a_1^2 a_2^2 = (8\omega_1\mu_1)^2
#      + \left[\tfrac83\omega_1(\sigma_1 + \sigma_2) + 3\alpha_1 a_1^2 + 2\alpha_3 a_2^2\right]^2,$$
# $$F_2^2 = \left[2\omega_2\mu_2 a_2 + 2\omega_1\mu_1\frac{\alpha_5 a_1^2}{\alpha_2 a_2}\right]^2
#      + \left[2\omega_2\sigma_2 a_2 + \tfrac12\alpha_6 a_1^2 a_2 + \tfrac34\alpha_8 a_2^3
#      - \frac{\alpha_5 a_1^2}{4\alpha_2 a_2}P\right]^2,$$
#
# where $P$ is the last bracket of the first line. There is no saturation: $a_2$ depends on the
# force through $a_1$. From the slow flow:

# %%
sigma_1, sigma_2 = (relation.detuning for relation in driven_fast[1].relations)
S, C = sp.symbols("S C")  # sine and cosine of 3γ_1 − γ_2


def at_rest(case):
    """The polar slow flow with S and C in place of the sine and cosine of 3γ_1 − γ_2."""
    names = {sp.sin(-gamma): S, sp.cos(-gamma): C}
    return {s: sp.expand(rate).subs(names) for s, rate in case.slow_flow.polar.items()}


rest = at_rest(driven_fast[1])
angle = sp.solve([rest[a_1] / a_1, rest[gamma_1]], [S, C], dict=True)[0]
P = sp.Rational(8, 3) * omega_1 * (sigma_1 + sigma_2) + 3 * al[1] * a_1**2 + 2 * al[3] * a_2**2
first = al[2] ** 2 * a_1**2 * a_2**2 - (8 * omega_1 * mu_1) ** 2 - P**2
assert sp.cancel((1 - angle[S] ** 2 - angle[C] ** 2) * al[2] ** 2 * a_1**2 * a_2**2 - first) == 0

sine = sp.solve(rest[a_2], sp.sin(gamma_2))[0].subs(angle)
cosine = sp.solve(rest[gamma_2], sp.cos(gamma_2))[0].subs(angle)
ratio, doubled = al[5] * a_1**2 / (al[2] * a_2), 2 * 3 * omega_1
second = (doubled * mu_2 * a_2 + 2 * omega_1 * mu_1 * ratio) ** 2 + (
    doubled * sigma_2 * a_2 + al[6] * a_1**2 * a_2 / 2 + 3 * al[8] * a_2**3 / 4 - ratio * P / 4
) ** 2
assert sp.cancel(F_2**2 * (sine**2 + cosine**2) - second) == 0

# %% [markdown]
# ## 5. The slower oscillator driven, $\Omega = \omega_1 + \varepsilon\sigma_2$

# %%
driven_slow = {
    order: scaled.expand(order, {omega_2: 3 * omega_1, Omega: omega_1}) for order in (1, 2)
}
report.modulation(driven_slow[1])

# %% [markdown]
# Now both amplitudes are always there. The faster one follows the slower one:
#
# $$\alpha_5^2 a_1^6 = (8\omega_2\mu_2 a_2)^2
#     + \left[8\omega_2(\sigma_1 - 3\sigma_2) - 2\alpha_6 a_1^2 - 3\alpha_8 a_2^2\right]^2 a_2^2.$$

# %%
rest = at_rest(driven_slow[1])
angle = sp.solve([rest[a_2], rest[gamma_2]], [S, C], dict=True)[0]
bracket = fast * (sigma_1 - 3 * sigma_2) - 2 * al[6] * a_1**2 - 3 * al[8] * a_2**2
follows = al[5] ** 2 * a_1**6 - (fast * mu_2 * a_2) ** 2 - bracket**2 * a_2**2
assert sp.cancel((1 - angle[S] ** 2 - angle[C] ** 2) * al[5] ** 2 * a_1**6 - follows) == 0

# %% [markdown]
# Response of a system with a potential, over the frequency of the force. Lines: all equilibria of
# the slow flow. Points: periodic orbits of the unexpanded equations, with the harmonics $\Omega$ of
# $u_1$ and $3\Omega$ of $u_2$.

# %%
NUMBERS = {"omega_1": 1.0, "mu_1": 0.02, "mu_2": 0.03,
           "alpha_1": -0.1, "alpha_2": -0.6, "alpha_3": -0.2, "alpha_4": 0.0,
           "alpha_5": -0.2, "alpha_6": -0.2, "alpha_7": 0.0, "alpha_8": -0.3}  # fmt: skip
LABELS = ["$a_1$ (m)", "$a_2$ (m)"]
over = {**NUMBERS, "F_1": 0.06, "F_2": 0.0, "sigma_1": 0.02,
        "sigma_2": np.linspace(-0.1, 0.2, 401)}  # fmt: skip
response_figure = drawn(driven_slow, over, r"$\sigma_2 = \Omega - \omega_1$ (rad/s)", LABELS, 24)

# %% [markdown]
# If the faster one is driven, the slower one may stay at rest at every frequency, and that motion
# stays stable: cubic terms do not wake it up. But there is another one, in which the slower
# oscillator swings at a third of the frequency. It does not branch off: it is a closed curve, which
# begins and ends in saddle-nodes, and one gets there by a kick.

# %%
over = {**NUMBERS, "F_1": 0.0, "F_2": 0.15, "sigma_1": 0.0,
        "sigma_2": np.linspace(0.0, 0.12, 401)}  # fmt: skip
first = {1: driven_fast[1]}
figure = drawn(first, over, r"$\sigma_2 = \Omega - \omega_2$ (rad/s)", LABELS, 28)

# %% [markdown]
# ## 6. Evidence
#
# Motions of the slow flow beside motions of the unexpanded equations, over times of order
# $1/\varepsilon$: the distance must fall like $\varepsilon^N$. So must the
# error of steady amplitudes beside those of periodic orbits; the rates at which disturbances of
# them die out, and the frequencies of saddle-nodes, are better by one order.

# %%
GENERIC = {"omega_1": 0.57, "mu_1": 0.11, "mu_2": 0.17, "alpha_1": 0.3, "alpha_2": 0.5,
           "alpha_3": -0.4, "alpha_4": 0.3, "alpha_5": 0.45, "alpha_6": 0.35, "alpha_7": -0.3,
           "alpha_8": 0.4, "F_1": 0.3, "F_2": 0.5, "sigma": 0.23, "sigma_1": 0.23,
           "sigma_2": -0.31}  # fmt: skip


def samples(case):
    """Generic values of the parameters of a case, at ε = 1."""
    wanted = {p.name for p in case.parameters} - set(case.weak.detuned)
    return {name: GENERIC[name] for name in GENERIC if name in wanted}


def steady(case):
    """Where there is a force: with that on the faster one, the one that swings at a third of it."""
    if case in free.values():
        return []
    if case in driven_slow.values():
        values, first = SWINGING, driven_slow[1]
    else:
        values, first = {**SWINGING, "F_2": 0.6, "sigma_1": 0.0, "sigma_2": 0.2}, driven_fast[1]
    found = first.slow_flow.equilibria(used(first, values)).amplitudes
    return [
        mg.Steady(used(case, values), list(found[np.isfinite(found[:, 0])][-1])),
        *bifurcations(first, {**values, "sigma_2": np.linspace(-1, 1, 301)}, ["saddle-node"]),
    ]


SWINGING = {"omega_1": 1.0, "mu_1": 0.08, "mu_2": 0.12, "F_1": 0.24, "F_2": 0.0,
            "sigma_1": 0.08, "sigma_2": 0.12}  # fmt: skip
SWINGING |= {c.name: 4 * NUMBERS[c.name] for c in alpha}
cases = [free[2], *driven_fast.values(), *driven_slow.values()]
emission = mg.Emission(
    model="internal_resonance_1_3",
    cases=cases,
    samples=samples,
    derivation="derivations/internal_resonance_1_3.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 6",
    amplitudes=lambda case: ([0.3 + 0.4j, 0.3 + 0.2j], 0.5),
    steady=steady,
)
certificates = emission.certificates
report.certificate_table(certificates.values())

# %%
kinds = ("free", "Ω ≈ ω₂", "Ω ≈ ω₂", "Ω ≈ ω₁", "Ω ≈ ω₁")
labels = [f"{kind}, order {case.order}" for kind, case in zip(kinds, cases, strict=True)]
axes = plotting.convergence(
    list(certificates.values()), labels, quantity="motions at times of order 1/ε"
)

# %% [markdown]
# ## 7. The emitted functions
#
# Each module holds `slow_flow`, the rates of the complex amplitudes, and what follows from it:
# `equilibria`, `frequency_response`, `stability`, `response`.

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
