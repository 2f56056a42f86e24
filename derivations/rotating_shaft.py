# %% [markdown]
# # A rotor with gyroscopic terms in a bearing whose stiffness varies
#
# A rigid rotor turns at the constant speed $\Omega_s$ on a shaft that lets it tilt by the small
# angles $\alpha$ and $\beta$. Gyroscopic moments couple the two tilts at leading order, so that the
# rotor whirls forward and backward with two different frequencies. The stiffness of one bearing is
# modulated with the frequency $\nu$, as rolling elements do. When $\nu$ is near a sum of whirl
# frequencies, or near twice one of them, the whirling grows.
#
# The equations are those of a Jeffcott rotor that tilts (R. Gasch, R. Nordmann and H. Pfützner,
# *Rotordynamik* (2002); G. Genta, *Dynamics of Rotating Systems* (2005)); parametric resonance of
# gyroscopic systems is treated in A. H. Nayfeh and D. T. Mook, *Nonlinear Oscillations* (1979),
# chapter 5.

# %%
import numpy as np
import sympy as sp
from IPython.display import Markdown, display
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report

# %% [markdown]
# ## 1. The model
#
# With the transverse inertia $I_t$ and the polar one $I_p$, the Lagrangian of the tilts is
#
# $$L = \tfrac12 I_t(\dot\alpha^2 + \dot\beta^2) + \tfrac12 I_p\Omega_s(\alpha\dot\beta -
#   \beta\dot\alpha) - \tfrac12\left(k + \kappa\cos\nu t\right)\alpha^2 - \tfrac12 k\beta^2 .$$

# %%
t = dynamicsymbols._t
alpha, beta = dynamicsymbols("alpha beta")
I_t, I_p, Omega_s, k, kappa, nu = sp.symbols("I_t I_p Omega_s k kappa nu", positive=True)
lagrangian = (
    I_t * (alpha.diff(t) ** 2 + beta.diff(t) ** 2) / 2
    + I_p * Omega_s * (alpha * beta.diff(t) - beta * alpha.diff(t)) / 2
    - (k + kappa * sp.cos(nu * t)) * alpha**2 / 2
    - k * beta**2 / 2
)
model = mg.Model(
    lagrangian=lagrangian,
    coordinates=[alpha, beta],
    parameters=[
        mg.Parameter(I_t, "kg m^2", "inertia about a diameter"),
        mg.Parameter(I_p, "kg m^2", "inertia about the axis of rotation"),
        mg.Parameter(Omega_s, "rad/s", "speed of rotation"),
        mg.Parameter(k, "N m/rad", "stiffness against tilting"),
        mg.Parameter(kappa, "N m/rad", "amplitude of its modulation in one direction"),
        mg.Parameter(nu, "rad/s", "frequency of the modulation"),
    ],
)
eom = model.equations_of_motion()
report.equations(eom)

# %% [markdown]
# ## 2. Orders in ε, and the modes of order 0
#
# The modulation is small. What is left at order 0 is coupled by the gyroscopic terms, which cannot
# be made diagonal by real modal coordinates. The program therefore names the frequencies and the
# components of the complex mode shapes $\varphi = \Phi + i\Theta$ of
# $(K_0 + i\omega G_0 - \omega^2 M_0)\varphi = 0$, scaled as shown. Each mode has a modal coordinate
# $\eta$ and its companion $s$, which is $\dot\eta/\omega$ at order 0.

# %%
scaled = eom.scale({kappa: 1})
report.orders(scaled, 0)

# %%
report.modes(scaled)

# %%
report.parameter_table(scaled.parameters)

# %%
for p in scaled.modes.parameters:
    if p.definition is not None:
        display(report.expression(sp.latex(p.symbol), p.definition))

# %% [markdown]
# One is backward whirl and slows down with the speed of rotation, the other is forward whirl and
# speeds up. Their product is always $k/I_t$ and their difference $I_p\Omega_s/I_t$:

# %%
omega_1, omega_2, _ = scaled.frequencies
formula = {p.symbol: p.definition for p in scaled.modes.parameters if p.definition is not None}
low, high = formula[omega_1] ** 2, formula[omega_2] ** 2
assert sp.expand(low * high - (k / I_t) ** 2) == 0
assert sp.expand(low + high - 2 * k / I_t - (I_p * Omega_s / I_t) ** 2) == 0

# %% [markdown]
# ## 3. Resonances

# %%
scaled.resonances(order=2)

# %%
rotor = {"I_t": 1.3, "I_p": 0.9, "Omega_s": 2.1, "k": 5.2, "kappa": 0.9}
scaled.resonances(order=2).coupled.rank({**rotor, "nu": 4.1})

# %% [markdown]
# ## 4. The sum combination $\nu = \omega_1 + \omega_2$

# %%
relations = [{nu: omega_1 + omega_2}, {nu: 2 * omega_1}, {nu: 2 * omega_2}, {nu: omega_2 - omega_1}]
cases = [scaled.expand(order, relation) for relation in relations for order in (1, 2)]
first, second = cases[:2]
report.solvability(first, 1)

# %%
report.polynomial(first)

# %%
display(report.verdict(first))
report.boundary(first)

# %%
display(report.solvability(second, 2))
report.boundary(second)

# %% [markdown]
# ### Against a formula in closed form
#
# By the symmetry of the shaft both whirls are circles, $\varphi = c\,(1, \mp i)$. The
# normalisation gives $c$, and with it the half-width of the zone in the parameters of the rotor.
# For circles $2\omega I_t \mp I_p\Omega_s = I_t(\omega_1 + \omega_2)$ for both modes, so that
# $c_r^2 = \omega_r/(I_t(\omega_1 + \omega_2))$ and
#
# $$|\nu - \omega_1 - \omega_2| < \frac{\kappa}{2 I_t(\omega_1 + \omega_2)} .$$

# %%
shape = {p.name: p.symbol for p in scaled.modes.parameters}
circles = {
    shape["Phi_alpha_1"]: sp.sqrt(omega_1 / (I_t * (omega_1 + omega_2))),
    shape["Phi_alpha_2"]: sp.sqrt(omega_2 / (I_t * (omega_1 + omega_2))),
}
lower, upper = first.slow_flow.boundary()
half_width = kappa / (2 * I_t * (omega_1 + omega_2))
assert sp.cancel(sp.powsimp((upper.subs(circles)) ** 2) - half_width**2) == 0
report.expression(r"\sigma_{\max}", half_width)

# %% [markdown]
# The mode shapes that the program computes at numbers are these circles:

# %%
numbers = scaled.numbers(rotor)
exact = {
    p: float(f.subs({omega_1: numbers["omega_1"], omega_2: numbers["omega_2"], I_t: rotor["I_t"]}))
    for p, f in circles.items()
}
assert all(np.isclose(abs(numbers[p.name]), value, rtol=1e-12) for p, value in exact.items())

# %% [markdown]
# ## 5. The other cases

# %%
for number, (one, two) in enumerate(zip(cases[2::2], cases[3::2], strict=True), start=1):
    display(Markdown(f"### 5.{number} ${report.case_title(one)}$"))
    display(report.solvability(one, 1))
    display(report.verdict(one))
    if one.slow_flow.stability.unstable is not False:
        display(report.boundary(one))
        display(report.boundary(two))

# %% [markdown]
# ## 6. Certificates
#
# The characteristic exponents and the edges of the zones against Floquet theory of the exact
# equations, at values without any special ratio.

# %%
emission = mg.Emission(
    model="rotating_shaft",
    cases=cases,
    samples=lambda case: {**rotor, "sigma": 0.31},
    derivation="derivations/rotating_shaft.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; gyroscopic modes after "
    "Meirovitch, AIAA Journal 12 (1974)",
)
certificates = emission.certificates
report.certificate_table(certificates.values())

# %%
axes = plotting.convergence(
    [c for c in certificates.values() if c.relation.startswith("nu = omega_1")]
)

# %% [markdown]
# ## 7. The zones
#
# The two principal zones, at $2\omega_1$ and at $2\omega_2$, are just as wide as the one between
# them at order 1, since the whirls are circles. Shaded: where Floquet theory of the exact equations
# finds growth, the darker the faster. Order 2 moves the zones by little, the highest to where it
# is; for the lowest one, beside whose frequency a strong modulation is large, more orders count.

# %%
for principal in cases[2:5:2]:
    _, upper = principal.slow_flow.boundary()
    assert sp.cancel(sp.powsimp((upper.subs(circles)) ** 2) - half_width**2) == 0

depth = np.linspace(0.0, 2.5, 61)[1:]
constant = {name: value for name, value in rotor.items() if name != "kappa"}
chart = mg.floquet.chart(eom, constant, {nu: np.linspace(2.3, 6.5, 211)}, {kappa: depth})
edges = {}
for order in (1, 2):
    zones = []
    for case in cases[order - 1 : 6 : 2]:
        centre = float(case.relations[0].rhs.subs({w: numbers[w.name] for w in (omega_1, omega_2)}))
        zones.append(centre + case.slow_flow.boundaries({**rotor, "kappa": depth}))
    edges[f"order {order}"] = (np.concatenate(zones, axis=1), depth)
axes = plotting.stability_chart(chart, edges, xlabel="ν (rad/s)", ylabel="κ (N m/rad)")

# %% [markdown]
# ## 8. The emitted functions
#
# Beside the usual ones there is `modes`, which computes the named quantities from the parameters of
# the rotor, as keywords for the others:
#
# ```python
# from mms_functions.rotating_shaft import nu_is_omega_1_plus_omega_2_order_2 as case
#
# modes = case.modes(I_t=1.3, I_p=0.9, Omega_s=2.1, k=5.2)
# low, high = case.boundaries(kappa=0.9, **modes)
# ```

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
