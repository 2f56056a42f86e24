# %% [markdown]
# # Ground resonance: a rotor whose blades differ in mass
#
# When the blades of a rotor differ in mass, its centre of gravity is off the axis, and the rotor
# shakes the fuselage once in every turn: the force $F_{ext}$. Where the rotor turns as fast as the
# fuselage swings on its landing gear, $\Omega \approx \omega_x$ or $\Omega \approx \omega_y$, that
# is a primary resonance, and the dampers decide how far the aircraft moves. This notebook derives
# the amplitude at equilibrium and the way to it, in the model of Sanches, Michon, Berlioz and
# Alazard (*Int. J. Non-Linear Mechanics* (2014), doi 10.1016/j.ijnonlinmec.2014.04.003), and sets
# both beside the unexpanded nonlinear equations.

# %%
import warnings

import matplotlib.pyplot as plt
import numpy as np
import rotor
import sympy as sp
from IPython.display import Markdown, display

import mmsgen as mg
from mmsgen import orbits, plotting, report
from mmsgen.certify import scaled_values
from mmsgen.motion import reconstruction
from mmsgen.runtime._flow import rates, wirtinger

# %% [markdown]
# ## 1. The model
#
# Blade $k$ has the mass $m(1 + e_k)$ and the inertia $I(1 + e_k)$; springs and dampers in lag are
# the same. Everything else is as in `ground_resonance`, with dampers on fuselage and blades.

# %%
N_b = 4
eom = rotor.at_speed(
    rotor.in_ratios(rotor.unlike_masses(rotor.helicopter(N_b).equations_of_motion()))
)
x, y, *phi = eom.coordinates
linear = eom.linearise()
display(report.parameter_table(eom.parameters), report.equations(eom, only=[phi[0]]))

# %% [markdown]
# The force on the fuselage at rest, $F_{ext}$, over its mass. It has the factor $r_m(1 + r_h)$, and
# only differences of opposite blades count: in general the first harmonic
# $\sum_k e_k e^{2\pi i(k-1)/N_b}$ of what they are heavier by.

# %%
force = sp.factor(linear.f[0])
report.expression("F_x", force)

# %%
named = {p.name: p.symbol for p in eom.parameters}
Omega, omega_x, omega_y = (named[name] for name in ("Omega", "omega_x", "omega_y"))
mu_x, mu_y, r_m, r_h = (named[name] for name in ("mu_x", "mu_y", "r_m", "r_h"))
e_1, e_2, e_3, e_4 = shares = [named[f"e_{k}"] for k in range(1, N_b + 1)]
turn = Omega * eom.time
first = (e_1 - e_3) * sp.cos(turn) - (e_2 - e_4) * sp.sin(turn)
assert sp.expand(force - r_m * (1 + r_h) * Omega**2 * first) == 0

# %% [markdown]
# ## 2. Orders in ε
#
# Coupling, dampers and the differences of the blades are small, and so is the motion: the force is
# a product of two small numbers, and moves the fuselage by a small distance at order 1. In motions
# that small the linear equations suffice, as section 3 shows; the unexpanded ones below are not
# linear.

# %%
small = ["r_m", "r_b", "mu_x", "mu_y", "mu_b", *(f"e_{k}" for k in range(1, N_b + 1))]
scaled = linear.scale(dict.fromkeys(small, 1), amplitude=1)
cases = {
    name: [scaled.expand(order, {Omega: omega}) for order in (1, 2)]
    for name, omega in (("x", omega_x), ("y", omega_y))
}
report.orders(scaled, 1)

# %% [markdown]
# ## 3. Slow flows and equilibria
#
# $\Omega = \omega_x + \varepsilon\sigma$, and the same for $y$. At order 1 the direction that
# resonates is an oscillator alone, driven and damped:

# %%
for name, (first, _) in cases.items():
    display(report.solvability(first, 1, only=[{"x": x, "y": y}[name]]))

# %% [markdown]
# Order 2 brings the blades in: they answer the fuselage with 0 and $2\Omega$, and take their part
# of its inertia.

# %%
display(report.solvability(cases["x"][1], 2, only=[x]))

# %% [markdown]
# In both cases the equation of the fuselage holds no other amplitude, and the blades' own die out.
# So the equilibrium is a formula. At order 1:


# %%
def at_equilibrium(case, name):
    """A of the fuselage at equilibrium, in closed form."""
    j = {"x": 0, "y": 1}[name]
    amplitude = case.amplitudes[j]
    rate = sp.expand(case.slow_flow.autonomous[amplitude])
    others = set(case.amplitudes) - {amplitude}
    assert not rate.free_symbols & others and not rate.has(sp.conjugate)
    slope = rate.coeff(amplitude)
    return -sp.expand(rate - slope * amplitude) / slope


formulas = {name: [at_equilibrium(c, name) for c in both] for name, both in cases.items()}
tuned = {"x": {Omega: omega_x}, "y": {Omega: omega_y}}
nonlinear = {
    name: eom.scale(dict.fromkeys(small, 1), amplitude=1).expand(2, tuned[name]) for name in cases
}
more = {
    name: {A: sp.expand(rate - cases[name][1].slow_flow.autonomous[A]) for A, rate in flow.items()}
    for name, flow in ((n, c.slow_flow.autonomous) for n, c in nonlinear.items())
}
for name, parts in more.items():
    at_rest = dict.fromkeys(cases[name][1].amplitudes[2:], 0)
    assert not any(sp.expand(part.subs(at_rest)) for part in parts.values())
sigma = cases["x"][0].relations[0].detuning
size = r_m * (1 + r_h) * sp.sqrt((e_1 - e_3) ** 2 + (e_2 - e_4) ** 2) / 2
for name, omega, mu in (("x", omega_x, mu_x), ("y", omega_y, mu_y)):
    found = 4 * formulas[name][0] * sp.conjugate(formulas[name][0])
    assert sp.cancel(found - size**2 * omega**2 / (mu**2 + sigma**2)) == 0
report.expression("a_x", size * omega_x / sp.sqrt(mu_x**2 + sigma**2))

# %% [markdown]
# The nonlinear terms add to order 2 only what vanishes with the amplitudes of the blades. The
# equilibrium stays where it is. Beside it they shift the lag frequency of each blade, by what the
# fuselage does; of the first one, at $\Omega \approx \omega_x$, they add to the rate

# %%
report.expression(r"\Delta\dot A_{\phi_1}", more["x"][cases["x"][1].amplitudes[2]])

# %% [markdown]
# ## 4. Numbers
#
# Those of the paper, with dampers of 0.4 1/s everywhere. Blade 1 is heavier by 6 %, blade 2 lighter
# by 2 %, blade 4 heavier by 1 %. The lag frequency $\omega_\phi$ is held at its value at resonance.

# %%
paper = {n: rotor.PAPER_VALUES[n] for n in ("r_m", "r_b", "r_a", "r_h", "omega_x", "omega_y")}
heavier = {"e_1": 0.06, "e_2": -0.02, "e_3": 0.0, "e_4": 0.01}
damped = {**paper, **heavier, "mu_x": 0.4, "mu_y": 0.4, "mu_b": 0.4}


def numbers(name, detuning):
    """The values of a case at a detuning."""
    lag = np.hypot(rotor.PAPER_VALUES["omega_b"], paper["r_a"] * paper[f"omega_{name}"])
    return {**damped, "omega_phi": float(lag), "sigma": detuning}


def steady(case, values):
    """All amplitudes at equilibrium."""
    table = case.slow_flow.table
    c, still = table.numbers(values), np.zeros(2 + N_b)
    matrix, _ = wirtinger(table.flow, c, still)
    return np.linalg.solve(matrix, -rates(table.flow, c, still)), matrix


def orbit(case, values):
    """The periodic motion of the unexpanded equations near the equilibrium."""
    slow, exact = scaled_values(case, values, 1.0)
    shape, (b, _) = reconstruction(case, slow), steady(case, slow)
    return orbits.find(
        orbits.problem(eom, exact), lambda t: shape(t, np.repeat(b[:, None], len(t), axis=1))
    )


# %% [markdown]
# The slow flow has no other equilibrium, and this one is stable:

# %%
for name, both in cases.items():
    for case in both:
        found = case.slow_flow.equilibria(numbers(name, 0.2))
        assert found.number == 1 and found.stable.all()
        # Of size 0.02, from systems of a condition of 10: each rounded to 1e-16.
        assert np.abs(found.amplitudes[0] - steady(case, numbers(name, 0.2))[0]).max() < 1e-15

# %% [markdown]
# ## 5. The amplitude at equilibrium
#
# Lines: orders 1 and 2. Points: periodic motions of the unexpanded nonlinear equations, all of
# them stable.

# %%
dots = np.array([-1.5, -0.5, 0.0, 0.5, 1.5])
fine = np.linspace(-2, 2, 401)
figure, panes = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
for j, (axes, name) in enumerate(zip(panes, cases, strict=True)):
    for case, formula in zip(cases[name], formulas[name], strict=True):
        values = numbers(name, fine)
        given = [p.symbol for p in case.parameters if p.name in values]
        curve = sp.lambdify(given, sp.Abs(formula), "numpy")
        heights = 2 * curve(*(values[str(s)] for s in given))
        place = case.order - 1
        style = {"color": plotting.COLOURS[place], "lw": plotting.WIDTHS[place]}
        axes.plot(fine, heights, label=f"order {case.order}", **style)
    found = [orbit(cases[name][1], numbers(name, float(s))) for s in dots]
    assert all(o.stable for o in found)
    axes.plot(dots, [o.amplitude(j) for o in found], "ko", ms=4, label="periodic orbits")
    axes.set(xlabel="σ (rad/s)", ylabel=f"amplitude of {name} (m)", ylim=(0, None))
    axes.set_title(f"$\\Omega = \\omega_{name} + \\varepsilon\\sigma$")
plotting.shared_legend(panes)
response_figure = figure

# %% [markdown]
# The error of the amplitude falls with ε at order 1, and with ε² at order 2. For
# $\sigma = 0.2\,\varepsilon$, relative to the periodic motion:

# %%
rows = []
for name, both in cases.items():
    j = {"x": 0, "y": 1}[name]
    for halvings in range(3):
        errors = []
        slow, _ = scaled_values(both[1], numbers(name, 0.2), 0.5**halvings)
        exact = orbit(both[1], slow).amplitude(j)
        for case in both:
            errors.append(2 * abs(steady(case, slow)[0][j]) / exact - 1)
        rows.append((name, f"1/{2**halvings}", *(f"{error:.1e}" for error in errors)))
report.Table(("direction", "ε", "order 1", "order 2"), tuple(rows))

# %% [markdown]
# ## 6. From rest to equilibrium
#
# The rotor turns at $\sigma = 0.3$ rad/s, and everything is at rest at first.
# `initial_amplitudes` gives the amplitudes that belong to this, `evolution` takes them to the
# equilibrium, and `response` makes coordinates of them, harmonics included. Grey: the unexpanded
# nonlinear equations, integrated in time. The fuselage moves by distances of order ε; the blades,
# which it drives through $r_b$, by one order less, in their swing and in the mean of their lag.


# %%
def from_rest(case, values, times):
    """Coordinates (times, n) by the slow flow, its amplitudes, and exact coordinates."""
    flow, still = case.slow_flow, np.zeros(2 + N_b)
    own, exact = scaled_values(case, values, 1.0)
    amplitudes = flow.evolution(own, flow.initial_amplitudes(own, still, still), times)
    with warnings.catch_warnings():
        # It warns where what is left out may be large: how large it is, the comparison says.
        warnings.simplefilter("ignore")
        made = flow.response(own, amplitudes, times)
    numbers = {p.name: exact[p.name] for p in eom.parameters[:-1]}
    return made, amplitudes, mg.time_integration(eom, numbers, still, still, times)[0]


times = np.linspace(0, 16, 1201)
figures = {"ground_resonance_forced": response_figure}
for j, (name, (_, case)) in enumerate(cases.items()):
    motion, amplitudes, found = from_rest(case, numbers(name, 0.3), times)
    figure, panels = plt.subplots(2, figsize=(7.2, 4.6), sharex=True, layout="constrained")
    for axes, row, label in zip(panels, (j, 2), (f"{name} (m)", "φ₁ (rad)"), strict=True):
        envelope = {"envelope": 2 * np.abs(amplitudes[:, j])} if row == j else None
        plotting.time_response(
            times,
            {"nonlinear equations": found[:, row], "slow flow, order 2": motion[:, row]},
            envelope,
            ylabel=label,
            axes=axes,
        )
    panels[0].set_xlabel("")
    panels[1].get_legend().remove()
    panels[0].set_title(f"${report.case_title(case)}$", fontsize="medium", loc="left")
    figures[f"ground_resonance_forced_{name}"] = figure

# %% [markdown]
# ## 7. Certificates
#
# Of the slow flows of the linear equations, beside these equations unexpanded: motions; the
# amplitude at equilibrium, whose error must fall like $\varepsilon^N$ at order $N$; and, better by
# one order, the rates at which disturbances of it die out.


# %%
def samples(case):
    """Generic numbers at ε = 1."""
    return {**numbers("x", 0.17), "omega_phi": 10.1, "e_3": 0.03, "mu_y": 0.3}


def equilibrium(case):
    """The steady motion at stronger dampers."""
    values = {**samples(case), "mu_x": 1.2, "mu_y": 0.9, "mu_b": 1.0}
    return [mg.Steady(values, list(steady(case, case.slow_flow._with_detunings(values))[0]))]


emission = mg.Emission(
    model="ground_resonance_forced",
    cases=[case for both in cases.values() for case in both],
    samples=samples,
    steady=equilibrium,
    amplitudes=lambda case: ([0.02, 0.01j, 0.03, 0.02j, -0.01, 0.02], 0.1),
    derivation="derivations/ground_resonance_forced.py",
    source="Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003",
)
report.certificate_table(emission.certificates.values())

# %%
Markdown("    " + mg.publish(emission, figures).replace("\n", "\n    "))
