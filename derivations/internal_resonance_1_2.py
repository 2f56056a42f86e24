# %% [markdown]
# # Internal resonance 1:2
#
# Two oscillators, the second nearly twice as fast as the first, coupled by quadratic terms: the
# roll and the pitch of a ship, a beam and its axial motion, a mass on a spring that swings. However
# weak the coupling, energy passes from one to the other. And if the faster one is driven, its
# amplitude *saturates*: from a certain force on it grows no further, and everything that is added
# goes to the slower one, which nobody drives.
#
# Source: A. H. Nayfeh and D. T. Mook, *Nonlinear Oscillations* (1979), chapter 6, systems with
# quadratic nonlinearities; saturation was found by Nayfeh, Mook and Marshall, "Nonlinear coupling
# of pitch and roll modes in ship motions", *J. Hydronautics* 7 (1973) 145–152.

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown, display
from scipy.integrate import solve_ivp
from scipy.special import ellipk
from sympy.physics.mechanics import dynamicsymbols
from two_amplitudes import bifurcations, drawn, responses, used

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.loading import load
from mmsgen.motion import exact_motion, first_order_system, reconstruction
from mmsgen.sampling import scaled_values

# %% [markdown]
# ## 1. Model
#
# The equations of the book, with a force on either coordinate.

# %%
t = dynamicsymbols._t
u_1, u_2 = dynamicsymbols("u_1 u_2")
omega_1, omega_2, Omega = sp.symbols("omega_1 omega_2 Omega", positive=True)
alpha_1, alpha_2 = sp.symbols("alpha_1 alpha_2", positive=True)
mu_1, mu_2, F_1, F_2 = sp.symbols("mu_1 mu_2 F_1 F_2", nonnegative=True)

model = mg.Model.from_equations(
    [
        u_1.diff(t, 2)
        + omega_1**2 * u_1
        + 2 * mu_1 * u_1.diff(t)
        - alpha_1 * u_1 * u_2
        - F_1 * sp.cos(Omega * t),
        u_2.diff(t, 2)
        + omega_2**2 * u_2
        + 2 * mu_2 * u_2.diff(t)
        - alpha_2 * u_1**2
        - F_2 * sp.cos(Omega * t),
    ],
    [u_1, u_2],
    [
        mg.Parameter(omega_1, "rad/s", "natural frequency of the slower oscillator"),
        mg.Parameter(omega_2, "rad/s", "natural frequency of the faster oscillator"),
        mg.Parameter(mu_1, "1/s", "damping of the slower oscillator"),
        mg.Parameter(mu_2, "1/s", "damping of the faster oscillator"),
        mg.Parameter(alpha_1, "1/(m s^2)", "coupling in the first equation"),
        mg.Parameter(alpha_2, "1/(m s^2)", "coupling in the second equation"),
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
# Damping, coupling and force are of order ε, the amplitudes of order 1. (The book gives the
# amplitudes the order ε and the force ε². For quadratic terms that is the same expansion.)

# %%
small = {mu_1: 1, mu_2: 1, alpha_1: 1, alpha_2: 1, F_1: 1, F_2: 1}
scaled = eom.scale(small)
scaled.resonances(order=2)

# %% [markdown]
# ## 3. Free motion, $\omega_2 = 2\omega_1 + \varepsilon\sigma$

# %%
free_scaled = eom.reparametrise({F_1: 0, F_2: 0}).scale(
    {p: 1 for p in (mu_1, mu_2, alpha_1, alpha_2)}
)
free = {order: free_scaled.expand(order, {omega_2: 2 * omega_1}) for order in (1, 2)}
report.solvability(free[1], 1)

# %%
report.solvability(free[2], 2)

# %% [markdown]
# Polar form, $A_j = \tfrac12 a_j e^{i\gamma_j}$ in the frame in which the equations are autonomous:

# %%
report.modulation(free[1])

# %% [markdown]
# Without damping there are two integrals (chapter 6): the energy
# $E = a_1^2 + \nu a_2^2$ with $\nu = \alpha_1\omega_2/(\alpha_2\omega_1)$, here at
# $\omega_2 = 2\omega_1$, and a second one, in which $\gamma$ is the angle between the two. Both are
# constant along the slow flow, exactly:

# %%
sigma = free[1].relations[0].detuning
polar = {s: rate.subs({mu_1: 0, mu_2: 0}) for s, rate in free[1].slow_flow.polar.items()}
(a_1, gamma_1), (a_2, gamma_2) = list(polar)[:2], list(polar)[2:]
nu = 2 * alpha_1 / alpha_2
gamma = 2 * gamma_1 - gamma_2
energy = a_1**2 + nu * a_2**2
second = a_1**2 * a_2 * sp.cos(gamma) - 4 * sigma * omega_1 / alpha_2 * a_2**2
for integral in (energy, second):
    rate = sum(integral.diff(s) * polar[s] for s in polar)
    assert sp.expand(rate) == 0
display(report.expression("E", energy), report.expression("L", second))

# %% [markdown]
# At $\sigma = 0$ the share of the energy in the first oscillator, $\xi = a_1^2/E$, obeys
# $\dot\xi^2 = \frac{\alpha_1^2 E}{4\omega_1^2\nu}\,[\xi^2(1 - \xi) - \ell]$ with
# $\ell = \nu L^2/E^3$. The solutions are elliptic functions, and the exchange has the period
#
# $$T = \frac{8\omega_1}{\alpha_1}\sqrt{\frac{\nu}{E(\xi_3 - \xi_1)}}\;K(m), \qquad
#   m = \frac{\xi_3 - \xi_2}{\xi_3 - \xi_1},$$
#
# $\xi_1 < 0 < \xi_2 < \xi_3$ being the zeros of the bracket. The function that is emitted,
# integrated over one such period, comes back to where it was:

# %%
NUMBERS = {"omega_1": 1.0, "mu_1": 0.0, "mu_2": 0.0, "alpha_1": 0.1, "alpha_2": 0.07, "sigma": 0.0}
start = np.array([0.45 + 0.1j, 0.15 - 0.2j])


def exchange_period(start, omega_1, alpha_1, alpha_2, **_):
    """T from the complex amplitudes at one instant, by the formula."""
    share = 2 * alpha_1 / alpha_2
    moduli = 2 * np.abs(start)
    total = moduli[0] ** 2 + share * moduli[1] ** 2
    invariant = 8 * (start[0] ** 2 * start[1].conj()).real
    x_1, x_2, x_3 = np.sort(np.roots([-1, 1, 0, -share * invariant**2 / total**3]).real)
    scale = 8 * omega_1 / alpha_1 * np.sqrt(share / (total * (x_3 - x_1)))
    return scale * ellipk((x_3 - x_2) / (x_3 - x_1))


emitted = load(free[1])
period = exchange_period(start, **NUMBERS)
solution = solve_ivp(
    lambda _, b: emitted.slow_flow(b, **NUMBERS),
    (0, period), start, "DOP853", rtol=1e-11, atol=1e-12, dense_output=True,
)  # fmt: skip
moved = np.abs(np.abs(solution.y[:, -1]) - np.abs(start)).max()
print(f"T = {period:.6f} s; the moduli after T differ by less than 1e-9: {moved < 1e-9}")

# %%
times = np.linspace(0, 2 * period, 400)
moduli = 2 * np.abs(solution.sol(np.mod(times, period)))
figure, axes = plt.subplots(figsize=(6.4, 2.8), layout="constrained")
for j, name in enumerate(("$a_1$", "$a_2$")):
    axes.plot(times, moduli[j], color=plotting.COLOURS[j], ls=plotting.DASHES[j], label=name)
axes.set(xlabel="time (s)", ylabel="amplitude (m)", xlim=(0, 2 * period))
legend = axes.legend(frameon=False)

# %% [markdown]
# ## 4. The faster oscillator driven, $\Omega = \omega_2 + \varepsilon\sigma_2$: saturation
#
# With $\omega_2 = 2\omega_1 + \varepsilon\sigma_1$, as in the book.

# %%
driven_fast = {
    order: scaled.expand(order, {omega_2: 2 * omega_1, Omega: omega_2}) for order in (1, 2)
}
report.solvability(driven_fast[1], 1)

# %%
report.modulation(driven_fast[1])

# %% [markdown]
# Equilibria. Either $a_1 = 0$, and $a_2$ is that of the linear oscillator; or $a_1 \ne 0$, and then
# $\dot a_1 = \dot\gamma_1 = 0$ give sine and cosine of $2\gamma_1 - \gamma_2$, whose squares add to
# 1:

# %%
sigma_1, sigma_2 = (r.detuning for r in driven_fast[1].relations)
rates = driven_fast[1].slow_flow.polar
S, C = sp.symbols("S C")  # sine and cosine of 2γ_1 − γ_2
plain = {s: sp.expand(rate).subs({sp.sin(gamma): S, sp.cos(gamma): C}) for s, rate in rates.items()}
angle = sp.solve([plain[a_1] / a_1, plain[gamma_1]], [S, C], dict=True)[0]
saturated = sp.solve(sp.numer(sp.together(angle[S] ** 2 + angle[C] ** 2 - 1)), a_2**2)[0]
report.expression("a_2^2", sp.factor(saturated))

# %% [markdown]
# There is no force in it: $a_2$ is saturated. The book prints
# $a_2 = 2\omega_1\alpha_1^{-1}[4\mu_1^2 + (\sigma_1 + \sigma_2)^2]^{1/2}$ (its sign of the coupling
# is the present one). The other two equations then are sine and cosine of $\gamma_2$; they leave a
# quadratic equation for $a_1^2$, printed as
#
# $$a_1 = 2\left\{-\Gamma_1 \pm \left[\left(\frac{F_2}{2\alpha_2}\right)^2
#         - \Gamma_2^2\right]^{1/2}\right\}^{1/2},$$
# $$\Gamma_1 = \frac{2\omega_1\omega_2}{\alpha_1\alpha_2}
#        [2\mu_1\mu_2 - \sigma_2(\sigma_1 + \sigma_2)], \qquad
#   \Gamma_2 = \frac{2\omega_1\omega_2}{\alpha_1\alpha_2}
#        [2\mu_1\sigma_2 + \mu_2(\sigma_1 + \sigma_2)].$$
#
# Both are reproduced exactly. (The book keeps $\omega_2$; at this order it is $2\omega_1$, since
# $\omega_2$ has been replaced strictly here.)

# %%
assert (
    sp.expand(saturated - (2 * omega_1 / alpha_1) ** 2 * (4 * mu_1**2 + (sigma_1 + sigma_2) ** 2))
    == 0
)

sine = sp.solve(plain[a_2], sp.sin(gamma_2))[0].subs(angle)
cosine = sp.solve(plain[gamma_2], sp.cos(gamma_2))[0].subs(angle)
response = sp.expand(F_2**2 * (sine**2 + cosine**2 - 1)).subs(a_2**2, saturated)
factor = 2 * omega_1 * (2 * omega_1) / (alpha_1 * alpha_2)
Gamma_1 = factor * (2 * mu_1 * mu_2 - sigma_2 * (sigma_1 + sigma_2))
Gamma_2 = factor * (2 * mu_1 * sigma_2 + mu_2 * (sigma_1 + sigma_2))
printed = (a_1**2 / 4 + Gamma_1) ** 2 + Gamma_2**2 - (F_2 / (2 * alpha_2)) ** 2
assert sp.cancel(response / (4 * alpha_2**2) - printed) == 0
report.expression("0", printed)

# %% [markdown]
# The picture of the book: both amplitudes over the force, at perfect tuning. `frequency_response`
# finds all equilibria of the slow flow; the two formulas are on its branches, and they meet in a
# pitchfork. Points: periodic orbits of the unexpanded equations, with the harmonics $\Omega/2$ of
# $u_1$ and $\Omega$ of $u_2$. Where the slower oscillator is at rest, the orbit loses its stability
# by the doubling of its period.

# %%
NUMBERS = {"omega_1": 1.0, "mu_1": 0.02, "mu_2": 0.03, "alpha_1": 0.4, "alpha_2": 0.3,
           "F_1": 0.0, "sigma_1": 0.0, "sigma_2": 0.0}  # fmt: skip
at = {p.symbol: NUMBERS[p.name] for p in driven_fast[1].parameters if p.name in NUMBERS}
level, threshold = float(sp.sqrt(saturated).subs(at)), 4 * 0.03 * float(sp.sqrt(saturated).subs(at))
forces = np.linspace(0, 4 * threshold, 201)
response = responses(driven_fast, {**NUMBERS, "F_2": forces})[1]
(pitchfork,) = response.bifurcations
assert abs(pitchfork.parameter - threshold) < 1e-9
moving = next(b for b in response.branches if b.modulus[:, 0].max() > 0)
beyond = moving.modulus[:, 0] > 0.01
assert np.abs(moving.modulus[beyond, 1] - level).max() < 1e-9
by_formula = 4 * (moving.parameter[beyond] / 0.6 - float(Gamma_1.subs(at)))
assert np.abs(moving.modulus[beyond, 0] ** 2 - by_formula).max() < 1e-9

LABELS = ["$a_1$ (m)", "$a_2$ (m)"]
figure = drawn(driven_fast, {**NUMBERS, "F_2": forces}, "$F_2$ (m/s²)", LABELS)

# %% [markdown]
# Over the frequency of the force, the two frequencies not being well tuned to each other: between
# the pitchforks the slower oscillator cannot stay at rest, beyond them it may swing up to the
# saddle-nodes, and between two Hopf points there is no stable periodic motion at all.

# %%
WEAK = {"omega_1": 1.0, "mu_1": 0.01, "mu_2": 0.01, "alpha_1": 0.16, "alpha_2": 0.16}
DETUNED = {**WEAK, "F_1": 0.0, "F_2": 0.12, "sigma_1": 0.08}
over = {**DETUNED, "sigma_2": np.linspace(-0.15, 0.1, 401)}
figure = drawn(driven_fast, over, r"$\sigma_2 = \Omega - \omega_2$ (rad/s)", LABELS, 26)

# %% [markdown]
# ## 5. The slower oscillator driven, $\Omega = \omega_1 + \varepsilon\sigma_2$

# %%
driven_slow = {
    order: scaled.expand(order, {omega_2: 2 * omega_1, Omega: omega_1}) for order in (1, 2)
}
report.solvability(driven_slow[1], 1)

# %%
report.modulation(driven_slow[1])

# %% [markdown]
# There is no saturation now, both amplitudes are always there. The faster one follows,
# $a_2 = \alpha_2 a_1^2 / (4\omega_2[\mu_2^2 + (2\sigma_2 - \sigma_1)^2]^{1/2})$, and the slower one
# obeys an equation of the third degree in $a_1^2$: the two conditions of chapter 6 with the phases
# eliminated,
#
# $$\left(\frac{F_1}{2\omega_1}\right)^2 = a_1^2\left[(\mu_1 + \mu_2\kappa a_1^2)^2
#        + (\sigma_2 - (2\sigma_2 - \sigma_1)\kappa a_1^2)^2\right], \qquad
#   \kappa = \frac{\alpha_1\alpha_2}{16\omega_1\omega_2[\mu_2^2 + (2\sigma_2 - \sigma_1)^2]}.$$

# %%
rates = driven_slow[1].slow_flow.polar
plain = {s: sp.expand(rate).subs({sp.sin(gamma): S, sp.cos(gamma): C}) for s, rate in rates.items()}
angle = sp.solve([plain[a_2], plain[gamma_2]], [S, C], dict=True)[0]
follower = sp.solve(sp.numer(sp.together(angle[S] ** 2 + angle[C] ** 2 - 1)), a_2**2)[0]
detuned = mu_2**2 + (2 * sigma_2 - sigma_1) ** 2
assert sp.cancel(follower - (alpha_2 * a_1**2 / (8 * omega_1)) ** 2 / detuned) == 0

sine = sp.solve(plain[a_1], sp.sin(gamma_1))[0].subs(angle)
cosine = sp.solve(plain[gamma_1], sp.cos(gamma_1))[0].subs(angle)
response = sp.expand(F_1**2 * (sine**2 + cosine**2 - 1)).subs(
    {a_2**2: follower, a_2**4: follower**2}
)
kappa = alpha_1 * alpha_2 / (32 * omega_1**2 * detuned)
by_hand = (
    a_1**2
    * (
        (mu_1 + mu_2 * kappa * a_1**2) ** 2
        + (sigma_2 - (2 * sigma_2 - sigma_1) * kappa * a_1**2) ** 2
    )
    - (F_1 / (2 * omega_1)) ** 2
)
assert sp.cancel(response / (4 * omega_1**2) - by_hand) == 0

# %% [markdown]
# Over the frequency of the force, at $\omega_2 = 2\omega_1$: two peaks, one for each way in which
# the two can answer in step, and a valley between two Hopf points. From one of them the limit
# cycles of the slow flow are followed to the other and back again. Shaded: from the smallest to the
# largest amplitude on them.

# %%
SLOW = {**WEAK, "F_1": 0.05, "F_2": 0.0, "sigma_1": 0.0}
axis = np.linspace(-0.06, 0.06, 401)
over = r"$\sigma_2 = \Omega - \omega_1$ (rad/s)"
figure = drawn(driven_slow, {**SLOW, "sigma_2": axis}, over, LABELS, 26)

flow, given = driven_slow[2].slow_flow, used(driven_slow[2], SLOW)
response = flow.frequency_response({**given, "sigma_2": axis})
low, high = (b for b in response.bifurcations if b.kind == "Hopf")
ends = low.parameter - 0.01, high.parameter + 0.01
family = flow.limit_cycles(given, low, "sigma_2", ends)
assert family.path.reason == "closed" and set(family.path.verdicts) == {"stable"}
along = np.argsort(family.values)
sizes = np.array([cycle.modulus for cycle in family.cycles])[along]
for j, axes in enumerate(figure.axes):
    style = {"facecolor": "0.88", "edgecolor": "0.4", "lw": 0.8, "label": "limit cycles"}
    axes.fill_between(family.values[along], *sizes[:, j].T, zorder=0, **style)
figure.legends[0].remove()
_ = plotting.shared_legend(figure.axes)

# %% [markdown]
# In the middle of the valley the motion has two frequencies, and never repeats: the amplitudes go
# round the limit cycle, while the oscillators swing. Grey: the unexpanded equations from the state
# that the limit cycle begins with; black: its amplitudes.

# %%
chosen = int(np.abs(family.values).argmin())
cycle, given = family.cycles[chosen], {**given, "sigma_2": float(family.values[chosen])}
times = np.linspace(0, 2.5 * cycle.period, 4001)
slow, exact = scaled_values(driven_slow[2], given, 1.0)
amplitudes = cycle.amplitudes(times)
made = reconstruction(driven_slow[2], slow)(times, amplitudes)
motion = exact_motion(first_order_system(eom, exact), made[:, 0], times, 1.0)
figure, panels = plt.subplots(2, 1, figsize=(7.2, 4.6), layout="constrained", sharex=True)
for j, axes in enumerate(panels):
    plotting.time_response(
        times,
        {"unexpanded equations": motion[j]},
        {"limit cycle of order 2": 2 * np.abs(amplitudes[j])},
        xlabel="t (s)" if j else "",
        ylabel=f"$u_{j + 1}$ (m)",
        axes=axes,
    )
panels[1].get_legend().remove()
print(f"T = {cycle.period:.1f} s; furthest apart: {np.abs(motion - made)[:2].max():.2g} m")

# %% [markdown]
# ## 6. Evidence
#
# Motions of the slow flow, put back into coordinates, beside motions of the unexpanded equations
# from the same state, over times of order $1/\varepsilon$. The distance must fall like
# $\varepsilon^N$ at order $N$. So must the error of steady amplitudes beside those of periodic
# orbits. The rates at which disturbances of them die out or grow are better by one order, and so
# are the places of bifurcations: saddle-nodes beside folds of periodic orbits, the pitchfork beside
# a doubling of the period, and the Hopf point, with its frequency, beside a Neimark–Sacker point.

# %%
GENERIC = {"omega_1": 0.67, "mu_1": 0.11, "mu_2": 0.17, "alpha_1": 0.9, "alpha_2": 0.6,
           "F_1": 0.7, "F_2": 0.8, "Omega": 1.0, "sigma": 0.23, "sigma_1": 0.23,
           "sigma_2": -0.31}  # fmt: skip


def samples(case):
    """Generic values of the parameters of a case, at ε = 1."""
    names = {p.name for p in case.parameters} - set(case.weak.detuned)
    return {name: value for name, value in GENERIC.items() if name in names}


def steady(case):
    """A steady motion of both oscillators, where there is a force, and bifurcations."""
    if case in free.values():
        return []
    fast = case in driven_fast.values()
    group, bent = (driven_fast, BENT_FAST) if fast else (driven_slow, BENT_SLOW)
    values = used(case, STEADY)
    found = group[1].slow_flow.equilibria(used(group[1], STEADY)).amplitudes[-1]
    kinds = ["saddle-node", "pitchfork" if fast else "Hopf"]
    return [mg.Steady(values, list(found)), *bifurcations(group[1], bent, kinds)]


STEADY = {"omega_1": 1.0, "mu_1": 0.25, "mu_2": 0.2, "alpha_1": 1.1, "alpha_2": 0.9,
          "F_1": 0.9, "F_2": 1.3, "sigma_1": 0.2, "sigma_2": 0.15}  # fmt: skip
ALONG = {**STEADY, "sigma_2": np.linspace(-1, 1, 301)}
BENT_FAST = {**ALONG, "mu_1": 0.15, "mu_2": 0.12, "F_1": 0.0}
BENT_SLOW = {**ALONG, "mu_1": 0.05, "mu_2": 0.05, "alpha_1": 0.9, "alpha_2": 0.8,
             "F_1": 0.6, "F_2": 0.0, "sigma_1": 0.1}  # fmt: skip
cases = [case for group in (free, driven_fast, driven_slow) for case in group.values()]
emission = mg.Emission(
    model="internal_resonance_1_2",
    cases=cases,
    samples=samples,
    derivation="derivations/internal_resonance_1_2.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 6",
    amplitudes=lambda case: ([0.4 + 0.3j, -0.3 + 0.4j], 0.7),
    steady=steady,
)
certificates = emission.certificates
report.certificate_table(certificates.values())

# %%
names = np.repeat(["free", "Ω ≈ ω₂", "Ω ≈ ω₁"], 2)
labels = [f"{name}, order {case.order}" for name, case in zip(names, cases, strict=True)]
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
