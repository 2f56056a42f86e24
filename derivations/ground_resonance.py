# %% [markdown]
# # Helicopter ground resonance
#
# A helicopter stands on its landing gear while the rotor turns. The blades can lag about their
# hinges; when they do so out of step, the rotor's centre of gravity whirls about the hub and shakes
# the fuselage, which in turn drives the blades. Between certain rotor speeds the two feed each
# other, and the oscillation grows until something breaks. This notebook derives where that
# happens and how fast it grows, by the method of multiple scales, from the Lagrangian to functions
# that can be imported, and compares every result with Floquet theory of the unexpanded equations.
#
# The model is that of Sanches, Michon, Berlioz and Alazard, "Response and instability prediction
# of helicopter dynamics on the ground", *Int. J. Non-Linear Mechanics* (2014),
# doi 10.1016/j.ijnonlinmec.2014.04.003. Nothing is copied from there but the model and its numbers.
#
# | step | section |
# |---|---|
# | Lagrangian and exact equations of motion | 1, 2 |
# | linear equations in ratios and frequencies | 3 |
# | orders in ε, and the hierarchy of equations | 4 |
# | every resonance up to order 2 | 5 |
# | secular terms, solvability conditions, slow flow and boundary of each case | 6, 7 |
# | certificates: the error against Floquet as ε → 0 | 8 |
# | growth rate over rotor speed | 9 |
# | the emitted functions | 10 |

# %%
import inspect

import numpy as np
import rotor
import sympy as sp
from IPython.display import Markdown, Math, display
from scipy.optimize import brentq

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.loading import load

# %% [markdown]
# ## 1. The model
#
# The fuselage moves by $x$ and $y$ on springs and dampers. Blade $k$ of $N_b$ stands at the azimuth
# $\zeta_k = \Omega t + 2\pi(k-1)/N_b$. Its hinge is at eccentricity $a$, its centre of gravity lies
# $b$ further out, and it lags by $\phi_k$, so that its centre of gravity is at
#
# $$x_k = x + a\cos\zeta_k + b\cos(\zeta_k + \phi_k), \qquad
#   y_k = y + a\sin\zeta_k + b\sin(\zeta_k + \phi_k).$$
#
# With the energies
#
# $$T = \tfrac12 m_f(\dot x^2 + \dot y^2) + \sum_k \left[\tfrac12 m_k(\dot x_k^2 + \dot y_k^2)
#     + \tfrac12 I_k(\Omega + \dot\phi_k)^2\right], \qquad
#   V = \tfrac12 K_x x^2 + \tfrac12 K_y y^2 + \sum_k \tfrac12 K_{bk}\phi_k^2$$
#
# and Rayleigh's dissipation function for the dampers, the Lagrangian is built for any number of
# blades, each with its own mass, inertia, spring and damper. Nothing is linearised. The code that
# does it stands in `derivations/rotor.py`, which other derivations share:


# %%
def source(*functions):
    """The code of functions, to be read here."""
    return Markdown("```python\n" + "\n\n".join(map(inspect.getsource, functions)) + "```")


source(rotor.azimuth, rotor.helicopter)

# %%
N_b = 4
model = rotor.helicopter(N_b)
x, y, *phi = model.coordinates
phi_1 = phi[0]
report.parameter_table([p for p in model.parameters if not p.name.endswith(("2", "3", "4"))])

# %% [markdown]
# (Blades 2 to 4 have the same four parameters.) The Lagrangian as the program holds it, the part
# of blade 1, over its mass:

# %%
m_1 = next(p.symbol for p in model.parameters if p.name == "m_1")
report.expression("L_1 / m_1", sp.expand(model.lagrangian).coeff(m_1))

# %% [markdown]
# ## 2. Exact equations of motion
#
# Lagrange's equations, from `sympy.physics.mechanics`. The blades alike from here on
# ($m_k = m$, $I_k = I$, $K_{bk} = K_b$), and no dampers. The equations of $x$ and of blade 1, still
# nonlinear:

# %%
eom = rotor.undamped(rotor.isotropic(model.equations_of_motion()))
report.equations(eom, only=[x, phi_1])

# %% [markdown]
# ## 3. Linear equations, in ratios and frequencies
#
# Stability of rest is decided by the linear part about $x = y = \phi_k = 0$.

# %%
linear = eom.linearise()
report.equations(linear, only=[x, phi_1])

# %% [markdown]
# The parameters combine to
#
# $$r_m = \frac{m b}{m_f + N_b m},\quad r_b = \frac{m b}{m b^2 + I},\quad r_a^2 = a r_b,\quad
#   \omega_x^2 = \frac{K_x}{m_f + N_b m},\quad \omega_y^2 = \frac{K_y}{m_f + N_b m},\quad
#   \omega_b^2 = \frac{K_b}{m b^2 + I}.$$
#
# `reparametrise` puts these in and raises an error if any old parameter is left in any equation,
# so that what follows is proved to depend on the new ones alone.

# %%
source(rotor.in_ratios)

# %%
ratios = rotor.in_ratios(linear)
report.equations(ratios, only=[x, phi_1])

# %% [markdown]
# The rotation stiffens a blade: it lags with the frequency
# $\omega_\phi = \sqrt{\omega_b^2 + r_a^2\Omega^2}$, which stays a symbol of its own with this
# definition known. In an expansion it is held fixed; a boundary in $\Omega$ is then the
# root of an implicit equation, which the emitted functions solve.

# %%
eom = rotor.at_speed(ratios)
report.parameter_table(eom.parameters)

# %%
report.equations(eom)

# %% [markdown]
# The same object gives $M(t)\,\ddot q + C(t)\,\dot q + K(t)\,q = 0$ exactly. These three matrices
# are
# all that the Floquet reference is made from; it knows nothing of what follows.

# %%
display(Math("M = " + sp.latex(eom.M)))
display(Math("C = " + sp.latex(eom.C)))
Math("K = " + sp.latex(eom.K))

# %% [markdown]
# ## 4. Orders in ε
#
# The coupling is weak: $r_m$ and $r_b$ are of order ε. They keep their symbols, $r_m$ standing for
# $\varepsilon r_m$, and all results are written at $\varepsilon = 1$. With
# $\mathrm d/\mathrm dt = D_0 + \varepsilon D_1 + \varepsilon^2 D_2 + \dots$ and
# $q_j = q_{j,0} + \varepsilon q_{j,1} + \dots$ the equations of $x$ and of blade 1 fall apart into
# a hierarchy. Order 0: uncoupled oscillators.

# %%
scaled = eom.scale({rotor.r_m: 1, rotor.r_b: 1})
report.orders(scaled, 0, only=[x, phi_1])

# %% [markdown]
# Order 1 and order 2: the same oscillators, driven by what the orders below have given.

# %%
report.orders(scaled, 1, only=[x, phi_1])

# %%
report.orders(scaled, 2, only=[x, phi_1])

# %% [markdown]
# ## 5. Resonances
#
# At order 0, $q_{j,0} = A_j e^{i\omega_j T_0} + \mathrm{c.c.}$ A driving term of frequency $\nu$
# makes
# a particular solution with the divisor $(\omega_j - \nu)(\omega_j + \nu)$. The divisors that
# positive frequencies can annul are all the resonances that there are. At order 1:

# %%
scaled.resonances(order=1)

# %% [markdown]
# At order 2 further candidates come up. For blades that are all alike none of the parametric ones
# is a resonance: their contributions cancel in the sum over the blades, or their coefficient
# vanishes
# just there. They come to life when one blade differs.

# %%
table = scaled.resonances(order=2)
table

# %% [markdown]
# With the numbers of the paper and at a rotor speed of 5 Hz, by distance:

# %%
paper = rotor.paper_values(eom)
at_5_hz = {**paper, "Omega": 2 * np.pi * 5}
table.coupled.rank(at_5_hz)

# %% [markdown]
# ## 6. Each case solved
#
# ### $\Omega = \omega_x + \omega_\phi$
#
# The first case in full. The resonant frequency is replaced strictly,
# $\Omega = \omega_x + \omega_\phi + \varepsilon\sigma$. The secular terms of order 1 must vanish:

# %%
Omega, omega_x, omega_y, omega_phi = rotor.Omega, rotor.omega_x, rotor.omega_y, rotor.omega_phi
sum_x = {order: scaled.expand(order, {Omega: omega_x + omega_phi}) for order in (1, 2)}
report.secular(sum_x[1], 1)

# %% [markdown]
# These are the solvability conditions. They couple $A_x$ with the conjugates of the blades'
# amplitudes, and leave $A_y$ alone:

# %%
report.solvability(sum_x[1], 1)

# %% [markdown]
# In the frame $A_{\phi k} = B_{\phi k} e^{i\sigma t}$ they have constant coefficients,
# $\mathrm dB/\mathrm dt = S(\sigma) B$ for
# $B = (A_x, \bar B_{\phi 1}, \dots, \bar B_{\phi 4}, A_y)$:

# %%
Math("S = " + sp.latex(sum_x[1].slow_flow.matrix))

# %% [markdown]
# The characteristic polynomial splits into factors. The linear ones are motions of the blades
# that do not move the hub; the quadratic one is the resonance.

# %%
report.polynomial(sum_x[1])

# %%
display(report.verdict(sum_x[1]))
report.boundary(sum_x[1])

# %% [markdown]
# Now the rest of order 1 can be solved. These are the particular solutions of $x$ and of blade 1;
# they hold no part at the coordinate's own frequency, so that $A_j$ is the whole fundamental. Each
# denominator is one of the divisors $(\omega_j - \nu)(\omega_j + \nu)$ of section 5, at exact
# resonance:

# %%
report.particular(sum_x[2], 1, only=[x, phi_1])

# %% [markdown]
# Two kinds of terms make the secular terms of order 2: products of these particular solutions with
# the coupling, and what the order-1 terms leave when their coefficients, such as
# $\Omega^2 = (\omega_x + \omega_\phi + \varepsilon\sigma)^2$, and their frequencies are
# expanded in ε. The latter carry $\sigma$. With blade 1 for all blades:

# %%
report.secular(sum_x[2], 2, only=[x, y, phi_1])

# %%
report.solvability(sum_x[2], 2, only=[x, y, phi_1])

# %%
report.polynomial(sum_x[2])

# %% [markdown]
# The edges re-expanded in ε, so that each order has one form. Order 2 moves the centre of the zone,
# not its width:

# %%
report.boundary(sum_x[2])

# %% [markdown]
# ### All the other cases
#
# Each to order 1 and 2: secular terms and solvability conditions of order 1, the characteristic
# polynomial, whether the case can be unstable and why, and the boundary.

# %%
others = [
    {Omega: omega_y + omega_phi},
    {Omega: omega_x - omega_phi},
    {Omega: omega_y - omega_phi},
    {Omega: omega_phi - omega_x},
    {Omega: omega_phi - omega_y},
]
solved = [sum_x[1], sum_x[2]]
for number, relation in enumerate(others, start=1):
    first, second = (scaled.expand(order, relation) for order in (1, 2))
    solved += [first, second]
    moving = [q for q, terms in first.secular_terms(1).items() if terms != 0]
    display(Markdown(f"#### 6.{number} ${report.case_title(first)}$\n\nSecular terms, order 1:"))
    display(report.secular(first, 1, only=moving))
    display(Markdown("Solvability conditions, order 1, and characteristic polynomial:"))
    display(report.solvability(first, 1, only=moving))
    display(report.polynomial(first))
    display(report.verdict(first))
    display(Markdown("Order 2, with blade 1 for all blades, and the characteristic polynomial:"))
    display(report.solvability(second, 2, only=[*(q for q in moving if q in (x, y)), phi_1]))
    display(report.polynomial(second))
    if first.slow_flow.stability.unstable:
        display(Markdown("Edges of the zone, to order 1 and to order 2:"))
        display(report.boundary(first))
        display(report.boundary(second))

# %% [markdown]
# The sum combinations can be unstable, the difference combinations never: there the product of
# the two couplings is negative, and energy only passes to and fro.

# %% [markdown]
# ## 7. Relations that fall together
#
# If the supports are equally stiff, $\omega_y = \omega_x$ exactly, two relations hold at once. The
# fuselage then whirls: one sense of whirling takes part, the other does not. The zone is wider by
# $\sqrt 2$, and its boundary is short at order 2 as well:

# %%
isotropic_support = eom.reparametrise({omega_y: omega_x}).scale({rotor.r_m: 1, rotor.r_b: 1})
whirl = {order: isotropic_support.expand(order, {Omega: omega_x + omega_phi}) for order in (1, 2)}
report.polynomial(whirl[1])

# %%
report.boundary(whirl[2])

# %% [markdown]
# If they are nearly equal, each relation has a detuning of its own,
# $\Omega = \omega_x + \omega_\phi + \varepsilon\sigma_1$ and
# $\omega_y = \omega_x + \varepsilon\sigma_2$. The factor is of degree three, and the boundary
# is found numerically:

# %%
together = {
    order: scaled.expand(order, {Omega: omega_x + omega_phi, omega_y: omega_x}) for order in (1, 2)
}
display(report.secular(together[1], 1, only=[x, y, phi_1]))
display(report.solvability(together[1], 1, only=[x, y, phi_1]))
display(report.polynomial(together[1]))
report.verdict(together[1])

# %% [markdown]
# At order 2, with blade 1 for all blades:

# %%
report.solvability(together[2], 2, only=[x, y, phi_1])

# %% [markdown]
# Away from all resonances order 1 has no secular terms, and the rotor is neutral. To order 2 the
# frequencies shift:

# %%
nonresonant = {order: scaled.expand(order) for order in (1, 2)}
display(report.secular(nonresonant[1], 1, only=[x, y, phi_1]))
display(report.solvability(nonresonant[2], 2, only=[x, y, phi_1]))
report.verdict(nonresonant[2])

# %% [markdown]
# So they do at the internal resonance $\omega_y = \omega_x$, where terms of order 2 couple the two
# directions of the fuselage:

# %%
internal = scaled.expand(2, {omega_y: omega_x})
display(report.secular(internal, 2, only=[x, y, phi_1]))
display(report.solvability(internal, 2, only=[x, y, phi_1]))
display(report.polynomial(internal))
report.verdict(internal)

# %% [markdown]
# ## 8. Certificates
#
# For each case the characteristic exponents of the slow flow are compared with Floquet's, at
# parameter values without any special ratio, with $\varepsilon r_m$, $\varepsilon r_b$,
# $\varepsilon\sigma$ for a range of ε. The error of order $N$ must fall like $\varepsilon^{N+1}$; a
# wrong coefficient anywhere would show as a lower exponent. For the unstable cases the same is
# asked
# of the edges of the zone. A case that fails is not emitted.

# %%
GENERIC = {"r_m": 0.05, "r_b": 0.3, "omega_x": 18.7, "omega_y": 25.9, "omega_phi": 11.3}
FAST_BLADES = {**GENERIC, "omega_y": 13.3, "omega_phi": 27.1}
DETUNINGS = {"sigma": 0.31, "sigma_1": 0.31, "sigma_2": 0.23, "Omega": 21.7}


def samples(case):
    """Values at ε = 1 at which all frequencies of the case are positive."""
    slow = {rotor.omega_x: 18.7, rotor.omega_y: 25.9, rotor.omega_phi: 11.3}
    positive = all(r.rhs.subs(slow) > 0 for r in case.relations)
    values = {**(GENERIC if positive else FAST_BLADES), **DETUNINGS}
    names = {p.name for p in case.parameters} - set(case.weak.detuned)
    return {name: value for name, value in values.items() if name in names}


emission = mg.Emission(
    model="ground_resonance",
    cases=[*solved, *together.values(), internal, *nonresonant.values()],
    samples=samples,
    numbers=paper,
    derivation="derivations/ground_resonance.py",
    source="Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003",
)
certificates = emission.certificates
report.certificate_table(certificates.values())

# %% [markdown]
# The same as a figure, for one sum and one difference combination. The lines have the slopes
# that the theory demands.

# %%
shown = ("Omega = omega_x + omega_phi", "Omega = omega_x - omega_phi")
axes = plotting.convergence([c for c in certificates.values() if c.relation in shown])

# %% [markdown]
# The zone of the whirling fuselage (section 7) is not emitted, its certificate holds as well:

# %%
for case in whirl.values():
    print(mg.certify(case, samples(case)))

# %% [markdown]
# In the middle of the zone, $\sigma = 0$, order 1 does better than it must: the growth rate there
# is odd in ε, so that the error of order 1 is already a cube. With the numbers of the paper and
# $\omega_\phi$ held at 11 rad/s:

# %%
middle = {**paper, "omega_phi": 11.0}
rows = []
for halvings in range(4):
    small = {**middle, "r_m": paper["r_m"] / 2**halvings, "r_b": paper["r_b"] / 2**halvings}
    growth = float(sum_x[1].slow_flow.growth_rate({**small, "sigma": 0.0}))
    speed = {"Omega": paper["omega_x"] + middle["omega_phi"]}
    reference = float(mg.floquet.growth_rate(eom, {**small, **speed}))
    rows.append(
        (f"1/{2**halvings}", f"{growth:.5f}", f"{reference:.5f}", f"{growth - reference:.1e}")
    )
report.Table(("ε", "order 1", "Floquet", "difference"), tuple(rows))

# %% [markdown]
# At the numbers of the paper, $\varepsilon = 1$, the edges of both zones, in Hz, from the
# boundary formulas and from Floquet:

# %%
report.zone_table(certificates.values(), factor=1 / (2 * np.pi), unit="Hz")

# %% [markdown]
# ## 9. Growth rate over rotor speed
#
# The numbers of the paper. Points: Floquet theory of the exact equations. Lines: the slow flows of
# order 1 and 2, the larger growth rate of the two sum combinations at each speed. Shaded: where
# Floquet finds growth.

# %%
hertz = np.linspace(4.2, 6.8, 521)
speeds = {**paper, "Omega": 2 * np.pi * hertz}
sum_y = {case.order: case for case in solved if case.relations[0].rhs == omega_y + omega_phi}
curves = {
    f"order {order}": np.maximum(
        sum_x[order].slow_flow.growth_rate(speeds), sum_y[order].slow_flow.growth_rate(speeds)
    )
    for order in (1, 2)
}
points = hertz[::10]
exact = mg.floquet.growth_rate(eom, {**paper, "Omega": 2 * np.pi * points})
zones = mg.floquet.boundary(eom, paper, Omega, (2 * np.pi * 4.2, 2 * np.pi * 6.8))
axes = plotting.growth_rates(
    hertz,
    (points, np.asarray(exact)),
    curves,
    [(low / 2 / np.pi, high / 2 / np.pi) for low, high in zones.zones],
)
growth_figure = axes.figure

# %% [markdown]
# The same over the strength of the coupling, $r_m$, from the emitted functions of section 10.
# Shaded: where Floquet finds growth, the darker the faster. Order 2 moves the second zone to
# its place. Where the coupling is strong, order 1 lets the two zones overlap; the exact ones keep
# a gap.

# %%
couplings = np.linspace(0.0, 0.08, 41)
constant = {name: value for name, value in paper.items() if name != "r_m"}
chart = mg.floquet.chart(
    eom, constant, {Omega: 2 * np.pi * np.linspace(4.0, 7.2, 81)}, {rotor.r_m: couplings[1:]}
)


def critical(case):
    """Both edges of a zone in rad/s over the couplings, by the emitted function."""
    function = load(case).critical_speeds
    taken = inspect.signature(function).parameters
    values = {**constant, "r_m": couplings[1:]}
    return function(**{name: value for name, value in values.items() if name in taken})


edges_over_r_m = {
    f"order {n}": (np.stack([*critical(sum_x[n]), *critical(sum_y[n])], axis=1), couplings[1:])
    for n in (1, 2)
}
axes = plotting.stability_chart(
    chart,
    edges_over_r_m,
    scale=(1 / (2 * np.pi), 1.0),
    xlabel="rotor speed (Hz)",
    ylabel="$r_m$ (m)",
)
chart_figure = axes.figure

# %% [markdown]
# How the order pays: the speeds at which the growth rate reaches 0.02 1/s at both ends of the
# first zone, for orders 1 to 4.

# %%
LEVEL = 0.02


def edges(growth):
    """The two speeds in Hz at which a growth rate passes through the level."""
    return [f"{brentq(lambda f: growth(f) - LEVEL, *b, xtol=1e-10):.4f}" for b in BRACKETS]


BRACKETS = ((4.40, 4.60), (4.90, 5.10))
rows = []
for order in (1, 2, 3, 4):
    flow = scaled.expand(order, {Omega: omega_x + omega_phi}).slow_flow
    rows.append((str(order), *edges(lambda f: flow.growth_rate({**paper, "Omega": 2 * np.pi * f}))))
rows.append(
    (
        "Floquet",
        *edges(lambda f: float(mg.floquet.growth_rate(eom, {**paper, "Omega": 2 * np.pi * f}))),
    )
)
report.Table(("order", "lower (Hz)", "upper (Hz)"), tuple(rows))

# %% [markdown]
# ## 10. The emitted functions
#
# `make` writes a module for every case whose certificate holds, with its reference values and its
# certificate beside it. They need NumPy alone:
#
# ```python
# from mms_functions.ground_resonance import Omega_is_omega_x_plus_omega_phi_order_2 as case
#
# low, high = case.critical_speeds(r_m=1 / 38, r_b=0.174, r_a=0.1865,
#                                  omega_x=18.85, omega_y=25.13, omega_b=9.42)
# ```

# %%
figures = {"ground_resonance": growth_figure, "ground_resonance_chart": chart_figure}
Markdown("    " + mg.publish(emission, figures).replace("\n", "\n    "))
