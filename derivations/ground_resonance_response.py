# %% [markdown]
# # Ground resonance: free motion at every resonance
#
# Of the resonances between rotor speed, fuselage and blades only the sum combinations
# $\Omega = \omega_x + \omega_\phi$, $\Omega = \omega_y + \omega_\phi$ make an isotropic rotor
# unstable (`ground_resonance`). At the difference combinations
#
# $$\Omega = \omega_x - \omega_\phi, \quad \Omega = \omega_y - \omega_\phi, \quad
#   \Omega = \omega_\phi - \omega_x, \quad \Omega = \omega_\phi - \omega_y$$
#
# nothing grows, but a fuselage that is pushed once hands all of its energy over to the blades and
# gets it back, again and again: the motion beats. So it does between the two directions of a
# fuselage on supports that are equally stiff, $\omega_y = \omega_x$. This notebook computes the
# free motion from given initial conditions, its period of beating and its largest amplitudes, and
# puts it beside the time integration of the *nonlinear* equations, one figure for each case. The
# last ones are of the sum combinations, where the motion grows.
#
# The model is that of Sanches, Michon, Berlioz and Alazard, "Response and instability prediction
# of helicopter dynamics on the ground", *Int. J. Non-Linear Mechanics* (2014),
# doi 10.1016/j.ijnonlinmec.2014.04.003; its Lagrangian and the steps to ratios and frequencies are
# those of `ground_resonance`.

# %%
import warnings

import numpy as np
import rotor
import sympy as sp
from IPython.display import Markdown, display
from matplotlib import pyplot as plt
from scipy.optimize import brentq

import mmsgen as mg
from mmsgen import plotting, report

# %% [markdown]
# ## 1. Equations
#
# A rotor of four blades, all alike, without dampers. The slow flows come from the linear equations.
# The motions that they are compared with are those of the nonlinear ones, of which this is the
# equation of blade 1:

# %%
model = rotor.helicopter(4)
alike = rotor.undamped(rotor.isotropic(model.equations_of_motion()))
nonlinear = rotor.at_speed(rotor.in_ratios(alike))
x, y, *phi = model.coordinates
report.equations(nonlinear, only=[phi[0]])

# %%
linear = nonlinear.linearise()
scaled = linear.scale({rotor.r_m: 1, rotor.r_b: 1})
report.equations(linear, only=[phi[0]])

# %% [markdown]
# ## 2. Slow flows
#
# The four cases, in the frame that makes the slow flow autonomous. The first in full; the others
# differ from it in signs, and in $y$ for $x$.

# %%
Omega, omega_phi = rotor.Omega, rotor.omega_phi
relations = {
    "omega_x_minus_omega_phi": rotor.omega_x - omega_phi,
    "omega_y_minus_omega_phi": rotor.omega_y - omega_phi,
    "omega_phi_minus_omega_x": omega_phi - rotor.omega_x,
    "omega_phi_minus_omega_y": omega_phi - rotor.omega_y,
}
cases = {
    name: [scaled.expand(order, {Omega: right}) for order in (1, 2)]
    for name, right in relations.items()
}
first = cases["omega_x_minus_omega_phi"][0]
display(report.solvability(first, 1, only=[x, *phi]))
report.polynomial(first)

# %% [markdown]
# In $A_x$ two frequencies are seen, those of the quadratic factor, for its discriminant is negative
# at every detuning. So $|A_x|$ repeats after $2\pi$ over their difference, and it is at most the
# sum of the moduli of both parts. These are formulas ($A_j$ stands for the amplitude at $t = 0$):

# %%
for name, (order_1, _) in cases.items():
    (formula,) = order_1.slow_flow.beating_formulas()
    display(Markdown(f"${report.case_title(order_1)}$:"))
    display(report.expression("T", formula.period))

# %%
(formula,) = first.slow_flow.beating_formulas()
A_x = first.amplitudes[0]
start = {a: 0 for a in first.amplitudes[1:]}
report.expression("|A_x|_{max}", formula.largest[A_x])

# %% [markdown]
# Started with the blades at rest, $|A_x|$ is largest at the start, whatever the detuning. What the
# blades get is less away from resonance. With $\sigma = 0$ the fuselage comes to rest completely
# once in every period.
#
# ## 3. Numbers
#
# Those of the paper for a rotor that is soft in lag, $\omega_b = 3\pi$ rad/s. Such blades are
# slower than the fuselage at every speed that matters; for $\Omega = \omega_\phi - \omega_x$ and
# $\Omega = \omega_\phi - \omega_y$ stiff ones are taken, $\omega_b = 10\pi$ rad/s. The speed is
# that of exact resonance. As $\omega_\phi^2 = \omega_b^2 + r_a^2\Omega^2$, it is a root.
#
# A fuselage that is pushed by 1 m, were it linear, would make each blade lag by the angle in the
# last column, of order 1: $\tfrac12\sqrt{r_b\omega_x/(r_m\omega_\phi)}$.

# %%
SOFT = rotor.paper_values(nonlinear)
STIFF = {**SOFT, "omega_b": 10 * np.pi}


def at_resonance(case, values):
    """The values with the speed at which the detuning vanishes, and with ω_φ there."""

    def lag(speed):
        return np.hypot(values["omega_b"], values["r_a"] * speed)

    relation = sp.lambdify([omega_phi, rotor.omega_x, rotor.omega_y], case.relations[0].rhs)

    def gap(speed):
        return speed - relation(lag(speed), values["omega_x"], values["omega_y"])

    speed = brentq(gap, 0.1, 40.0, xtol=1e-14)
    return {**values, "Omega": speed, "omega_phi": float(lag(speed))}


numbers = {
    name: at_resonance(cases[name][0], STIFF if name.startswith("omega_phi") else SOFT)
    for name in cases
}


def arguments(case, values):
    """The values that a case takes; its detuning follows from its frequencies."""
    known = {p.name for p in case.parameters}
    return {name: v for name, v in values.items() if name in known}


rows = []
for name, values in numbers.items():
    j = 0 if "omega_x" in name else 1
    beats = [c.slow_flow.beating(arguments(c, values), np.eye(6)[j]) for c in cases[name]]
    rows.append(
        (
            f"${report.case_title(cases[name][0])}$",
            f"{values['Omega']:.3f}",
            f"{values['omega_phi']:.3f}",
            *(f"{b.period[j]:.3f}" for b in beats),
            f"{beats[0].largest[2]:.3f}",
        )
    )
report.Table(
    (
        "case",
        "Ω (rad/s)",
        "ω_φ (rad/s)",
        "period, order 1 (s)",
        "period, order 2 (s)",
        "largest blade amplitude (rad/m)",
    ),
    tuple(rows),
)

# %% [markdown]
# ## 4. From initial conditions to amplitudes and back
#
# The expansion gives coordinates and velocities from the amplitudes, harmonics included:
# $q_j = A_j e^{i\omega_j t} + \mathrm{c.c.} + q_{j,1}$ for order 2. `initial_amplitudes` solves it
# for the amplitudes at $t = 0$ that belong to a given state, `evolution` takes them to any later
# time by a matrix exponential, and `response` makes coordinates of them again.


# %%
def free_motion(case, values, start, times):
    """Coordinates (times, n) by the slow flow, from zero velocities, and the amplitudes."""
    flow, own = case.slow_flow, arguments(case, values)
    amplitudes = flow.evolution(own, flow.initial_amplitudes(own, start, 0 * start), times)
    with warnings.catch_warnings():
        # It warns where what is left out may be large: how large it is, the comparison says.
        warnings.simplefilter("ignore")
        return flow.response(own, amplitudes, times), amplitudes


def exact(values, start, times):
    """Coordinates (times, n) by time integration of the nonlinear equations."""
    own = arguments(nonlinear, values)
    return mg.time_integration(nonlinear, own, start, 0 * start, times)[0]


def pushed(name, distance):
    """The fuselage displaced by a distance in the direction that resonates, the blades not."""
    start = np.zeros(len(model.coordinates))
    start[0 if "omega_x" in name else 1] = distance
    return start


# %% [markdown]
# The slow flow of order $N$ is off by $\varepsilon^{N+1}$ for a time of order $1/\varepsilon$: over
# one beat the motions must come together like $\varepsilon^N$. The largest difference of the
# fuselage's motion over one beat, relative to the push, against the nonlinear equations, with
# $\varepsilon r_m$, $\varepsilon r_b$. The push is of 1 mm, so that the blades' geometric
# nonlinearity, of the square of their angles, is out of sight:

# %%
rows = []
for name, both in cases.items():
    j = 0 if "omega_x" in name else 1
    errors = {1: [], 2: []}
    for halvings in range(3):
        small = {r: numbers[name][r] / 2**halvings for r in ("r_m", "r_b")}
        values = {**numbers[name], **small}
        start = pushed(name, 1e-3)
        period = both[0].slow_flow.beating(arguments(both[0], values), np.eye(6)[j]).period[j]
        times = np.linspace(0.0, period, 400)
        reference = exact(values, start, times)[:, j]
        for case in both:
            slow, _ = free_motion(case, values, start, times)
            errors[case.order].append(np.abs(slow[:, j] - reference).max() / 1e-3)
    for order, own in errors.items():
        shown = (*(f"{e:.2g}" for e in own), f"{np.log2(own[-2] / own[-1]):.1f}")
        rows.append((f"${report.case_title(both[0])}$", str(order), *shown))
report.Table(("case", "order", "ε = 1", "1/2", "1/4", "exponent"), tuple(rows))

# %% [markdown]
# ## 5. The motions
#
# Pushed by 5 cm, at the ratios of the paper. Above the fuselage, below blade 1. Grey: the nonlinear
# equations, integrated in time. Blue: the slow flow of order 2 with its harmonics. Dashed: its
# envelope, twice the modulus of the amplitude.

# %%
figures = {}


def beats(name):
    """The figure of one case, over two beats and a half."""
    case = cases[name][1]
    j = 0 if "omega_x" in name else 1
    period = case.slow_flow.beating(arguments(case, numbers[name]), np.eye(6)[j]).period[j]
    shown(name, case, 0.05, 2.5 * period)


def shown(name, case, push, end):
    """The fuselage and blade 1 after a push, for a time: slow flow and nonlinear equations."""
    values, j = numbers[name], 0 if "omega_x" in name else 1
    start = pushed(name, push)
    times = np.linspace(0.0, end, 4001)
    slow, amplitudes = free_motion(case, values, start, times)
    found = exact(values, start, times)
    figure, panels = plt.subplots(2, figsize=(7.2, 4.6), sharex=True, layout="constrained")
    labels = (("x", "y")[j] + " (m)", "φ₁ (rad)")
    for axes, row, label in zip(panels, (j, 2), labels, strict=True):
        plotting.time_response(
            times,
            {"nonlinear equations": found[:, row], "slow flow, order 2": slow[:, row]},
            {"envelope": 2 * np.abs(amplitudes[:, row])},
            ylabel=label,
            axes=axes,
        )
    panels[0].set_xlabel("")
    panels[1].get_legend().remove()
    panels[0].set_title(f"${report.case_title(case)}$", fontsize="medium", loc="left")
    figures[f"ground_resonance_free_{name}"] = figure


beats("omega_x_minus_omega_phi")

# %%
beats("omega_y_minus_omega_phi")

# %%
beats("omega_phi_minus_omega_x")

# %%
beats("omega_phi_minus_omega_y")

# %% [markdown]
# ## 6. Off resonance
#
# With a detuning the fuselage keeps some of its energy, and the beats become faster. Lines: the
# closed forms of order 1 and 2, $\omega_\phi$ held fixed. Points: the nonlinear equations over two
# beats and more.

# %%
name = "omega_x_minus_omega_phi"
values = numbers[name]
sigma = np.linspace(-3.0, 3.0, 241)
figure, (left, right) = plt.subplots(1, 2, figsize=(7.4, 3.2), layout="constrained")
for k, case in enumerate(cases[name]):
    style = {"color": plotting.COLOURS[k], "ls": plotting.DASHES[k], "label": f"order {k + 1}"}
    own = arguments(case, {n: v for n, v in values.items() if n != "Omega"})
    found = case.slow_flow.beating({**own, "sigma": sigma}, 0.025 * np.eye(6)[0])
    left.plot(sigma, found.period[:, 0], **style)
    right.plot(sigma, 2 * found.largest[:, 2], **style)
dots, tops = np.linspace(-3.0, 3.0, 7), []
for shift in dots:
    moved = {**values, "Omega": values["Omega"] + shift}
    times = np.linspace(0.0, 7.5, 4001)
    tops.append(np.abs(exact(moved, pushed(name, 0.05), times)[:, 2]).max())
right.plot(dots, tops, "o", ms=3.4, mfc="none", mec="black", label="nonlinear equations")
left.set(xlabel="σ (rad/s)", ylabel="period of beating (s)", ylim=(0, None))
right.set(xlabel="σ (rad/s)", ylabel="largest lag angle of blade 1 (rad)", ylim=(0, None))
right.legend(frameon=False, fontsize="small")
figures["ground_resonance_beating"] = figure

# %% [markdown]
# ## 7. Equal supports
#
# One more resonance of the isotropic rotor is never unstable: supports that are equally stiff,
# $\omega_y = \omega_x$. The blades couple both directions to second order, the coupling is
# gyroscopic, and the plane in which the fuselage swings turns, as that of Foucault's pendulum does.
# With $\omega_y = \omega_x + \varepsilon\sigma$:

# %%
internal = {order: scaled.expand(order, {rotor.omega_y: rotor.omega_x}) for order in (2, 4)}
display(report.solvability(internal[2], 2, only=[x, y]))
report.verdict(internal[2])

# %% [markdown]
# Order 2 is the first that couples, and so knows the rate of turning to its leading term alone; the
# next one comes with order 4. At $\sigma = 0$ and $\Omega = 15$ rad/s, pushed by 5 cm along $x$,
# with the slow flow of order 4:

# %%
speed = 15.0
lag = float(np.hypot(SOFT["omega_b"], SOFT["r_a"] * speed))
equal = {**SOFT, "Omega": speed, "omega_phi": lag, "omega_y": SOFT["omega_x"]}
start = 0.05 * np.eye(6)[0]
own = arguments(internal[4], equal)
first_amplitudes = internal[4].slow_flow.initial_amplitudes(own, start, 0 * start)
half_turns = {
    order: case.slow_flow.beating(own, first_amplitudes).period[0]
    for order, case in internal.items()
}
times = np.linspace(0.0, 2.0 * half_turns[4], 4001)
slow, amplitudes = free_motion(internal[4], equal, start, times)
found = exact(equal, start, times)
figure, panels = plt.subplots(2, figsize=(7.2, 4.6), sharex=True, layout="constrained")
for axes, row, label in zip(panels, (0, 1), ("x (m)", "y (m)"), strict=True):
    plotting.time_response(
        times,
        {"nonlinear equations": found[:, row], "slow flow, order 4": slow[:, row]},
        {"envelope": 2 * np.abs(amplitudes[:, row])},
        ylabel=label,
        axes=axes,
    )
panels[0].set_xlabel("")
panels[1].get_legend().remove()
panels[0].set_title(f"${report.case_title(internal[4])}$", fontsize="medium", loc="left")
figures["ground_resonance_free_omega_y_is_omega_x"] = figure
for order, period in half_turns.items():
    print(f"order {order}: the plane of the motion has turned by 180 degrees after {period:.2f} s")

# %% [markdown]
# ## 8. Where it grows
#
# At the sum combinations the same push, though of 1 mm only, makes an oscillation that grows until
# something stops it (`ground_resonance_nonlinear`). The push is shared between a part that grows
# and one that decays; when the latter is gone, both coordinates grow like $e^{\Gamma t}$:

# %%
growing = {
    "omega_x_plus_omega_phi": rotor.omega_x + omega_phi,
    "omega_y_plus_omega_phi": rotor.omega_y + omega_phi,
}
for name, right in growing.items():
    case = scaled.expand(2, {Omega: right})
    numbers[name] = at_resonance(case, SOFT)
    rate = float(case.slow_flow.growth_rate(arguments(case, numbers[name])))
    print(f"{name}: Γ = {rate:.3f} 1/s at Ω = {numbers[name]['Omega']:.3f} rad/s")
    shown(name, case, 1e-3, 4.0 / rate)

# %%
Markdown(mg.publish(figures=figures))
