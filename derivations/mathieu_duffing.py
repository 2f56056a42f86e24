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
from orbits import harmonic, orbit
from scipy.optimize import fsolve
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.symbols import modulus, phase

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
# With $\dot a = \dot\gamma_u = 0$ the polar form is a pair of linear equations in
# $\sin 2\gamma_u$ and $\cos 2\gamma_u$, the squares of which add up to one. That leaves one
# condition for $a$:

# %%
a, angle = modulus(u), phase(u)
s, c = sp.symbols("s c", real=True)
turned = {sp.sin(2 * angle): s, sp.cos(2 * angle): c}
steady = [sp.expand(rate).subs(turned) for rate in flow.polar.values()]
(solved,) = sp.solve(steady, [s, c], dict=True)
parts = [sp.expand(2 * solved[k] * f / omega) for k in (s, c)]
Math(
    rf"\left({sp.latex(parts[0] / 2)}\right)^2 + \left({sp.latex(parts[1] / 2)}\right)^2 "
    r"= \frac{f^2}{\omega^2}"
)

# %% [markdown]
# ### Mathieu–Duffing
#
# $\eta = 0$; printed with $\omega = 1$, as
# $a^2 = \dfrac{4}{3\alpha}\left(\sigma \pm \sqrt{f^2 - 4\mu^2}\right)$:

# %%
P = sp.Symbol("P", positive=True)  # a²
unit = {omega: 1, a: sp.sqrt(P)}
condition = sp.expand(sum(part**2 for part in parts).subs(unit) / 4 - f**2)


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
# Which motions are stable? Trace and determinant of the Jacobian of the polar slow flow there:

# %%
polar = sp.Matrix(list(flow.polar.values()))
jacobian = polar.jacobian([a, angle]).applyfunc(lambda e: sp.expand(e).subs(turned).subs(solved))
trace, determinant = (sp.expand(e).subs(unit) for e in (jacobian.trace(), jacobian.det()))
slope = condition.diff(P)
assert sp.expand(determinant - P * slope / 2) == 0
left = sp.collect(condition, P).subs(P, a**2)
display(Math(rf"\mathrm{{tr}} = {sp.latex(trace.subs(P, a**2))}"))
Math(rf"\det = \frac{{a^2}}{{2}} \frac{{\partial}}{{\partial a^2}} \left[{sp.latex(left)}\right]")

# %% [markdown]
# The condition in square brackets is a parabola in $a^2$ that opens upwards: on the smaller root
# the determinant is negative, a saddle; the larger root is stable as long as
# $4\mu + \eta a^2 > 0$.
#
# ## 6. Certificates
#
# The slow flow is nonlinear, so motions are compared: from the same state the exact equation is
# integrated over a time of order $1/\varepsilon$, and the difference has to fall like
# $\varepsilon^N$. The linear boundaries are compared with Floquet theory, where the order is
# $N + 1$.

# %%
values = {"omega": 1.3, "f": 0.9, "alpha": 0.7, "mu": 0.11, "eta": 0.23, "sigma": 0.37}
emission = mg.Emission(
    model="mathieu_duffing",
    cases=list(cases.values()),
    samples=lambda case: values,
    amplitudes=lambda case: ([0.6 + 0.4j], 2.0),
    derivation="derivations/mathieu_duffing.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5",
)
at_origin = {name: value for name, value in values.items() if name not in ("alpha", "eta")}
certificates = [*emission.certificates.values(), *(mg.certify(c, at_origin) for c in rest.values())]
report.certificate_table(certificates)

# %%
axes = plotting.convergence(certificates[:2], quantity="motions at times of order 1/ε")

# %% [markdown]
# ## 7. Against exact periodic motions
#
# Newton's method on the map over two periods of the excitation finds the periodic motions of the
# unexpanded equation, stable and unstable ones (`derivations/orbits.py`). Their fundamental
# harmonic is what $a$ stands for. Mathieu–Duffing with $\omega = \alpha/\varepsilon = 1$,
# $f = 0.8\,\varepsilon$, $\mu = 0.2\,\varepsilon$ and $\sigma = 0.5\,\varepsilon$: the error of
# order $N$ falls like $\varepsilon^N$.

# %%
names = [p.symbol for p in cases[2].parameters if p.symbol != Omega]
equations = {
    order: sp.lambdify(
        [list(case.slow_flow.cartesian), names], list(case.slow_flow.cartesian.values())
    )
    for order, case in cases.items()
}


def steady_state(order, values, guess):
    """The fixed point B = (x + iy)/2 of a slow flow near a guess."""
    numbers = [values[str(symbol)] for symbol in names]
    x, y = fsolve(lambda z: equations[order](z, numbers), [guess.real, guess.imag], xtol=1e-10)
    return complex(x, y)


def first_order(values, sign):
    """The steady state x + iy of order 1 at ω = 1, from the formulas."""
    numbers = [values[str(symbol)] for symbol in names]
    c0, c1, c2 = coefficients(*numbers)
    amplitude = np.sqrt((-c1 + sign * np.sqrt(c1**2 - 4 * c2 * c0)) / (2 * c2))
    sine, cosine = directions(amplitude, *numbers)
    return amplitude * np.exp(0.5j * np.arctan2(sine, cosine))


coefficients = sp.lambdify(names, [condition.coeff(P, power) for power in range(3)])
directions = sp.lambdify([a, *names], [solved[s], solved[c]])


def exact_amplitude(values, guess):
    """The fundamental of the exact periodic motion, and whether it is stable."""
    known = {**{k: v for k, v in values.items() if k != "sigma"}, "Omega": 2 + values["sigma"]}
    half = known["Omega"] / 2
    (path, _), multipliers = orbit(eom, known, 2 * np.pi / half, [guess.real, -half * guess.imag])
    return harmonic(path, 1), bool(np.abs(multipliers).max() < 1)


rows, gaps = [], []
for epsilon in (0.1, 0.05, 0.025, 0.0125):
    small = {"f": 0.8, "mu": 0.2, "sigma": 0.5, "alpha": 1.0, "eta": 0.0}
    small = {"omega": 1.0, **{name: epsilon * value for name, value in small.items()}}
    one = first_order(small, +1)
    two = steady_state(2, small, one)
    exact, stable = exact_amplitude(small, two)
    gaps.append(np.abs([abs(one) - exact, abs(two) - exact]))
    cells = (f"{x:.5f}" for x in (abs(one), abs(two), exact))
    rows.append((f"{epsilon}", *cells, *(f"{g:.1e}" for g in gaps[-1])))
head = ("ε", "order 1", "order 2", "exact", "error, order 1", "error, order 2")
display(report.Table(head, tuple(rows)))
powers = np.log2(gaps[2] / gaps[3])
Markdown(f"Powers of ε from the last two rows: {powers[0]:.1f} and {powers[1]:.1f}.")

# %% [markdown]
# Steady amplitudes over the detuning; lines: order 1, dashed where unstable, points: exact
# periodic motions, open where unstable. Left Mathieu–Duffing, $f = 0.1$, $\mu = 0.02$,
# $\alpha = 0.2$; right van der Pol, $\eta = 0.1$, $f = 0.06$.

# %%
figure, panels = plt.subplots(1, 2, figsize=(8.4, 3.4), layout="constrained")
hard = {"omega": 1.0, "f": 0.1, "mu": 0.02, "alpha": 0.2, "eta": 0.0}
caught = {"omega": 1.0, "f": 0.06, "mu": -0.05, "alpha": 0.0, "eta": 0.1}
at = {
    1: ((-0.06, 0.02, 0.1, 0.18), (-0.055, -0.03, 0.0, 0.03, 0.055)),
    -1: ((0.12, 0.2), (-0.04, 0.0, 0.04)),
}
for panel, (axes, values) in enumerate(zip(panels, (hard, caught), strict=True)):
    detunings = np.linspace(-0.12, 0.24, 721) if panel == 0 else np.linspace(-0.07, 0.07, 561)
    for sign, style in ((1, "-"), (-1, "--")):
        with np.errstate(invalid="ignore"):
            branch = np.abs(first_order({**values, "sigma": detunings}, sign))
        axes.plot(detunings, branch, style, color=plotting.COLOURS[0])
        for detuning in at[sign][panel]:
            here = {**values, "sigma": detuning}
            amplitude, stable = exact_amplitude(
                here, steady_state(2, here, first_order(here, sign))
            )
            assert stable == (sign > 0)
            axes.plot(detuning, amplitude, "ko", ms=4, mfc="black" if stable else "none")
    axes.set(xlabel="σ (rad/s)", ylabel="amplitude of the fundamental", ylim=(0, None))

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
