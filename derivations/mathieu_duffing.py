# %% [markdown]
# # Parametric excitation of nonlinear oscillators
#
# When the stiffness of an oscillator pulses at about twice its natural frequency, rest becomes
# unstable, and what the linear theory then has to say is that the motion grows without end. Two
# nonlinear terms that stop it are treated here together,
#
# $$\ddot u + 2\mu\dot u + (\omega^2 + 2f\cos\Omega t)\,u + \alpha u^3 + \eta u^2\dot u = 0 :$$
#
# for $\eta = 0$ the *Mathieu–Duffing* oscillator, stopped by its changing frequency; for
# $\alpha = 0$, $\mu = -\eta/2$ the *parametrically excited van der Pol* oscillator, which would
# oscillate without excitation too, and is caught by it.
#
# What is reproduced: boundary of the trivial solution and steady amplitudes after A. H. Nayfeh and
# D. T. Mook, *Nonlinear Oscillations* (1979), chapter 5, which treats parametrically excited
# systems.

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown, Math, display
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.symbols import modulus

# %% [markdown]
# ## 1. The model

# %%
t = dynamicsymbols._t
u = dynamicsymbols("u")
omega, Omega = sp.symbols("omega Omega", positive=True)
f, alpha, mu, eta = sp.symbols("f alpha mu eta", real=True)
model = mg.Model(
    lagrangian=u.diff(t) ** 2 / 2
    - (omega**2 + 2 * f * sp.cos(Omega * t)) * u**2 / 2
    - alpha * u**4 / 4,
    coordinates=[u],
    parameters=[
        mg.Parameter(omega, "rad/s", "natural frequency"),
        mg.Parameter(Omega, "rad/s", "frequency of the excitation"),
        mg.Parameter(f, "rad^2/s^2", "half the modulation of the stiffness"),
        mg.Parameter(alpha, "1/(m^2 s^2)", "cubic stiffness over the mass"),
        mg.Parameter(mu, "1/s", "damping; negative where the oscillator excites itself"),
        mg.Parameter(eta, "1/(m^2 s)", "damping that grows with the displacement"),
    ],
    dissipation=(mu + eta * u**2 / 2) * u.diff(t) ** 2,
)
eom = model.equations_of_motion()
report.equations(eom)

# %% [markdown]
# ## 2. Orders in ε
#
# All but $\omega$ and $\Omega$ is of order ε.

# %%
scaled = eom.scale({f: 1, alpha: 1, mu: 1, eta: 1})
display(report.orders(scaled, 1))
scaled.resonances(order=2)

# %% [markdown]
# ## 3. The principal resonance $\Omega = 2\omega + \varepsilon\sigma$

# %%
cases = {order: scaled.expand(order, {Omega: 2 * omega}) for order in (1, 2)}
display(report.solvability(cases[1], 1))
report.solvability(cases[2], 2)

# %% [markdown]
# In polar form, $A = \tfrac12 a\,e^{i(\sigma t/2 + \gamma_u)}$, order 1:

# %%
report.modulation(cases[1])

# %% [markdown]
# ## 4. Where rest is unstable
#
# The slow flow of the linearised equation, with its boundary to order 1 and 2:

# %%
linear = eom.linearise().scale({f: 1, mu: 1})
rest = {order: linear.expand(order, {Omega: 2 * omega}) for order in (1, 2)}
display(report.polynomial(rest[1]))
display(report.boundary(rest[1]))
report.boundary(rest[2])

# %% [markdown]
# At $\omega = 1$, order 1, this is $\sigma^2 = f^2 - 4\mu^2$, as printed. The Jacobian of the
# nonlinear slow flow at rest has the same determinant:

# %%
lower, upper = (edge.subs(omega, 1) for edge in rest[1].slow_flow.boundary())
assert sp.expand(upper**2 - (f**2 - 4 * mu**2)) == 0 and sp.expand(lower + upper) == 0

sigma = cases[1].relations[0].detuning
flow = cases[1].slow_flow
at_rest = flow.jacobian.subs(dict.fromkeys(flow.cartesian, 0))
Gamma = sp.Symbol("Gamma")
difference = at_rest.charpoly(Gamma).as_expr() - rest[1].slow_flow.characteristic_polynomial(Gamma)
assert sp.expand(difference) == 0
Math(rf"\sigma^2 = {sp.latex(sp.expand(upper**2))}")

# %% [markdown]
# ## 5. Steady amplitudes
#
# With $\dot a = \dot\gamma_u = 0$ the phase can be eliminated. That leaves one condition for $a$:

# %%
a, P = modulus(u), sp.Symbol("P", positive=True)  # P: a²
relation = flow.response_relation()
report.expression("0", relation)

# %% [markdown]
# ### Mathieu–Duffing
#
# $\eta = 0$; printed with $\omega = 1$, as
# $a^2 = \dfrac{4}{3\alpha}\left(\sigma \pm \sqrt{f^2 - 4\mu^2}\right)$:

# %%
unit = {omega: 1, a: sp.sqrt(P)}
condition = sp.expand(relation.subs(unit) / 16)


def from_print(roots, P, lead):
    """The quadratic polynomial that has the printed roots and a leading coefficient."""
    return sp.expand(lead * sp.prod(P - root for root in roots))


mathieu_duffing = condition.subs(eta, 0)
printed = [4 * (sigma + sign * sp.sqrt(f**2 - 4 * mu**2)) / (3 * alpha) for sign in (-1, 1)]
assert sp.expand(from_print(printed, P, mathieu_duffing.coeff(P, 2)) - mathieu_duffing) == 0
display(Math(rf"{sp.latex(sp.collect(mathieu_duffing, P).subs(P, a**2))} = 0"))

# %% [markdown]
# ### Parametrically excited van der Pol
#
# $\alpha = 0$ and $\mu = -\eta/2$, for $\eta = \varepsilon$ and $\omega = 1$ the equation
# $\ddot u + u = \varepsilon(1 - u^2)\dot u - 2\varepsilon f u\cos\Omega t$. At
# $\varepsilon = 1$ its steady amplitude is printed as
# $a^2 = 4\left(1 + \sqrt{f^2 - \sigma^2}\right)$; the other root belongs to an unstable motion:

# %%
van_der_pol = condition.subs({alpha: 0, mu: -eta / 2}).subs(eta, 1)
printed = [4 * (1 + sign * sp.sqrt(f**2 - sigma**2)) for sign in (-1, 1)]
assert sp.expand(from_print(printed, P, van_der_pol.coeff(P, 2)) - van_der_pol) == 0
display(Math(rf"{sp.latex(sp.collect(van_der_pol, P).subs(P, a**2))} = 0"))

# %% [markdown]
# The backbone, about which the two motions lie without damping, and the conditions under which
# motions change their stability: a pitchfork at rest, a saddle-node where the relation has a double
# root, and a Hopf point.

# %%
(backbone,) = flow.backbone().values()
assert sp.expand(backbone - 3 * alpha * a**2 / (4 * omega)) == 0
meeting = flow.bifurcation_equations()
assert sp.expand(meeting["pitchfork"][0].subs(omega, 1) - (sigma**2 - f**2 + 4 * mu**2)) == 0
assert sp.expand(meeting["saddle-node"][1].subs(unit) - 8 * condition.diff(P)) == 0
report.Table(
    ("", "vanishes there"),
    (
        ("backbone", f"${sp.latex(sigma - backbone)}$"),
        *(
            (kind, f"${sp.latex(meeting[kind][-1])}$")
            for kind in ("pitchfork", "saddle-node", "Hopf")
        ),
    ),
)

# %% [markdown]
# The condition is a parabola in $a^2$ that opens upwards: its smaller root belongs to a saddle; the
# larger one is stable as long as $4\mu + \eta a^2 > 0$.
#
# ## 6. Certificates
#
# The slow flow is nonlinear, so motions are compared: from the same state the exact equation is
# integrated over a time of order $1/\varepsilon$, and the difference has to fall like
# $\varepsilon^N$. Steady motions are compared with periodic orbits of the exact equation: their
# amplitudes, and with one order more the exponents of disturbances, the pitchfork at which rest
# becomes unstable, and the saddle-node at which van der Pol's oscillator is set free. The linear
# boundaries are compared with Floquet theory, where the order is $N + 1$.

# %%
values = {"omega": 1.3, "f": 0.9, "alpha": 0.7, "mu": 0.11, "eta": 0.23, "sigma": 0.37}
free = {"omega": 1.3, "f": 0.6, "alpha": 0.1, "mu": -0.5, "eta": 1.1, "sigma": 0.681}
emission = mg.Emission(
    model="mathieu_duffing",
    cases=list(cases.values()),
    samples=lambda case: values,
    amplitudes=lambda case: ([0.6 + 0.4j], 2.0),
    steady=lambda case: [
        mg.Steady(values, [0.21 + 0.74j]),
        mg.Steady({**values, "sigma": 0.66}, [0.0], "pitchfork"),
        mg.Steady(free, [0.99 + 0.1j], "saddle-node"),
    ],
    derivation="derivations/mathieu_duffing.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5",
)
at_origin = {name: value for name, value in values.items() if name not in ("alpha", "eta")}
certificates = [*emission.certificates.values(), *(mg.certify(c, at_origin) for c in rest.values())]
report.certificate_table(certificates)

# %%
axes = plotting.convergence(certificates[:2], quantity="motions at times of order 1/ε")

# %% [markdown]
# ## 7. Responses
#
# Steady amplitudes over the detuning at $\omega = 1$ rad/s. Points: periodic orbits of the
# unexpanded equation, stable ones filled; they take two periods of the excitation. Left
# Mathieu–Duffing, $f = 0.1$, $\mu = 0.02$, $\alpha = 0.2$, with its backbone of order 1; right van
# der Pol, $\eta = 0.1$, $f = 0.06$.

# %%
hard = {omega: 1.0, f: 0.1, mu: 0.02, alpha: 0.2, eta: 0.0, sigma: np.linspace(-0.12, 0.24, 361)}
caught = {
    omega: 1.0,
    f: 0.06,
    mu: -0.05,
    alpha: 0.0,
    eta: 0.1,
    sigma: np.linspace(-0.08, 0.08, 321),
}
figure, panels = plt.subplots(1, 2, figsize=(8.4, 4.2), layout="constrained")
for axes, numbers in zip(panels, (hard, caught), strict=True):
    for order, case in cases.items():
        response = case.slow_flow.frequency_response(numbers)
        points = mg.orbits_along(case, numbers, response, 24, largest=3) if order == 2 else ()
        plotting.frequency_response(
            response, [f"order {order}"], points=points, colour=order - 1, axes=axes
        )
sizes = np.linspace(0, 1.7, 50)
along = sp.lambdify(a, backbone.subs({omega: 1, alpha: hard[alpha]}))(sizes)
plotting.backbone({"backbone": (along, sizes)}, axes=panels[0])
panels[0].set_xlim(-0.12, 0.24)
panels[1].set_xticks(np.linspace(-0.08, 0.08, 5))
for axes, top in zip(panels, (1.7, 3), strict=True):  # order 2 has more far above, out of its reach
    axes.set(xlabel="σ (rad/s)", ylabel="amplitude of the fundamental (m)", ylim=(-0.05, top))
_ = plotting.shared_legend(panels)

# %% [markdown]
# ## 8. The emitted functions
#
# ```python
# from mms_functions.mathieu_duffing import Omega_is_two_omega_order_2 as case
#
# rate = case.slow_flow([0.5 + 0.2j], omega=1.0, f=0.1, alpha=0.2, mu=0.02, eta=0.0, sigma=0.1)
# ```

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
