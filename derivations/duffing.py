# %% [markdown]
# # Duffing's oscillator, free
#
# A mass on a spring that stiffens with the displacement: the faster, the further it swings. The
# frequency over the amplitude is the first result of every book on nonlinear vibration, and the
# only one here whose exact answer is known in closed form, so three witnesses can be heard: the
# expansion, the printed series, and the elliptic integral.
#
# The series are those of Nayfeh and Mook, *Nonlinear Oscillations* (1979), chapter 2, and Nayfeh,
# *Introduction to Perturbation Techniques* (1981), chapter 4; the orders three and four can be
# had from the elliptic integral, and are checked against it below.

# %%
import matplotlib.pyplot as plt
import mpmath as mp
import numpy as np
import sympy as sp
from IPython.display import Markdown, Math, display
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.symbols import modulus, phase, time_scale

# %% [markdown]
# ## 1. The model
#
# $$L = \tfrac12 \dot u^2 - \tfrac12 \omega_0^2 u^2 - \tfrac14 \alpha u^4$$

# %%
t = dynamicsymbols._t
u = dynamicsymbols("u")
omega_0, alpha = sp.symbols("omega_0 alpha", positive=True)
model = mg.Model(
    lagrangian=u.diff(t) ** 2 / 2 - omega_0**2 * u**2 / 2 - alpha * u**4 / 4,
    coordinates=[u],
    parameters=[
        mg.Parameter(omega_0, "rad/s", "frequency of small oscillations"),
        mg.Parameter(alpha, "1/(m^2 s^2)", "cubic stiffness over the mass"),
    ],
)
report.parameter_table(model.parameters)

# %%
eom = model.equations_of_motion()
report.equations(eom)

# %% [markdown]
# ## 2. Orders in ε
#
# The cubic term is small: $\alpha$ stands for $\varepsilon\alpha$, and results are written at
# $\varepsilon = 1$. An amplitude of order $\sqrt\varepsilon$ with $\alpha$ of order one says the
# same. Order 0 to order 2:

# %%
scaled = eom.scale({alpha: 1})
for p in range(3):
    display(report.orders(scaled, p))

# %% [markdown]
# Nothing excites the oscillator, and a single frequency cannot resonate with itself otherwise than
# it always does. The table of resonances is empty up to order 4:

# %%
len(scaled.resonances(order=4))

# %% [markdown]
# ## 3. Slow flow to order 4
#
# $u_0 = A e^{i\omega_0 T_0} + \mathrm{c.c.}$, and the solvability conditions order by order:

# %%
cases = {order: scaled.expand(order) for order in (1, 2, 3, 4)}
for p in (1, 2, 3, 4):
    display(report.solvability(cases[4], p))

# %% [markdown]
# With $A = \tfrac12 a e^{i\gamma}$ the amplitude stays, and the phase advances:

# %%
report.modulation(cases[4])

# %% [markdown]
# ## 4. The frequency, for both definitions of the amplitude
#
# With $y = \alpha a^2/\omega_0^2$, where $a$ is the amplitude of the *fundamental*, the frequency
# $\omega_0 + \dot\gamma$ is to order 4


# %%
def ascending(left, series):
    """A series as a formula, its lowest power first."""
    return Math(f"{left} = {sp.latex(series, order='rev-lex')}")


a, gamma = modulus(u), phase(u)
y = sp.Symbol("y", positive=True)
polar = cases[4].slow_flow.polar
assert polar[a] == 0
ratio = sp.expand(1 + (polar[gamma] / omega_0).subs(alpha, y * omega_0**2 / a**2))
ascending(r"\frac{\omega}{\omega_0}", ratio)

# %% [markdown]
# It is the backbone curve of the driven oscillator as well: `backbone` gives $\dot\gamma$ over the
# amplitude, and the series is the printed one.

# %%
assert sp.expand(cases[4].slow_flow.backbone()[gamma] - polar[gamma]) == 0
printed = 1 + 3 * y / 8 - 15 * y**2 / 256 + 123 * y**3 / 8192 - 921 * y**4 / 262144
assert sp.expand(ratio - printed) == 0

# %% [markdown]
# Other books count the amplitude as the *largest displacement* $u_{\max}$ and print
# $-\tfrac{21}{256}$ instead of $-\tfrac{15}{256}$. Both are right. Particular solutions carry no
# fundamental here, so the largest displacement is the sum of them all at phase zero:

# %%
T_0 = time_scale(0)
at_rest = {cases[4].amplitudes[0]: a / 2, T_0: 0}
peak = sp.expand(sum(cases[4].particular(p)[u].subs(at_rest) for p in range(4)))
stretch = sp.expand((peak / a).subs(alpha, y * omega_0**2 / a**2))
ascending(r"\frac{u_{\max}}{a}", stretch)

# %% [markdown]
# The printed series is in $Y = \alpha u_{\max}^2/\omega_0^2 = y\,(u_{\max}/a)^2$:
#
# $$\frac{\omega}{\omega_0} = 1 + \tfrac38 Y - \tfrac{21}{256} Y^2 + \tfrac{81}{2048} Y^3
#   - \tfrac{6549}{262144} Y^4 + \dots$$
#
# In $y$ it is the one above, term by term:

# %%
Y = sp.Symbol("Y", positive=True)
by_peak = 1 + 3 * Y / 8 - 21 * Y**2 / 256 + 81 * Y**3 / 2048 - 6549 * Y**4 / 262144


def truncated(expression, symbol, order=4):
    """A polynomial without its powers above an order."""
    return sum(sp.expand(expression).coeff(symbol, n) * symbol**n for n in range(order + 1))


assert sp.expand(truncated(by_peak.subs(Y, y * stretch**2), y) - ratio) == 0

# %% [markdown]
# ## 5. The third witness: the elliptic integral
#
# The exact motion is $u = u_{\max}\,\mathrm{cn}(\cdot\,|\,m)$ with
#
# $$m = \frac{Y}{2(1+Y)}, \qquad \frac{\omega}{\omega_0} = \frac{\pi\sqrt{1+Y}}{2K(m)}.$$
#
# Its Taylor series about $Y = 0$, exact rational numbers from
# $K(m) = \tfrac{\pi}{2}\sum_n \left[\binom{2n}{n}/4^n\right]^2 m^n$:

# %%
m = sp.Symbol("m", positive=True)
K = sum((sp.binomial(2 * n, n) / sp.Integer(4) ** n) ** 2 * m**n for n in range(5))
exact = sp.sqrt(1 + Y) / K.subs(m, Y / (2 * (1 + Y)))
from_integral = sp.series(exact, Y, 0, 5).removeO()
assert sp.expand(from_integral - by_peak) == 0
ascending(r"\frac{\omega}{\omega_0}", sp.expand(from_integral))

# %% [markdown]
# The fundamental of the exact motion is known too,
# $a = u_{\max}\,\dfrac{2\pi}{\sqrt m\,K}\,\dfrac{\sqrt q}{1+q}$ with the nome
# $q = e^{-\pi K(1-m)/K(m)}$, so that the expansion can be compared at finite amplitude in its own
# terms. The relative error of the frequency, to one digit and at the same $a$:


# %%
def exact_pair(big_y):
    """(αa²/ω_0², ω/ω_0) of the exact motion whose largest displacement has αu²/ω_0² = Y."""
    modulus_squared = big_y / (2 * (1 + big_y))
    quarter = mp.ellipk(modulus_squared)
    nome = mp.qfrom(m=modulus_squared)
    share = 2 * mp.pi / (mp.sqrt(modulus_squared) * quarter) * mp.sqrt(nome) / (1 + nome)
    return share**2 * big_y, mp.pi * mp.sqrt(1 + big_y) / (2 * quarter)


def series_to(order):
    """The series cut behind an order, as a function."""
    return sp.lambdify(y, truncated(ratio, y, order), "mpmath")


with mp.workdps(30):
    strengths = [mp.mpf(2) ** -k for k in range(7)]
    pairs = [exact_pair(big_y) for big_y in strengths]
    errors = {n: [abs(series_to(n)(p) / w - 1) for p, w in pairs] for n in (1, 2, 3, 4)}
rows = [
    (f"1/{2**k}", *(f"{float(errors[n][k]):.0e}" for n in errors)) for k in range(len(strengths))
]
report.Table(("$Y$", *(f"order {n}" for n in errors)), tuple(rows))

# %% [markdown]
# Each halving of $Y$ divides the error of order $N$ by $2^{N+1}$ (thin lines). Even where the
# cubic force is as large as the linear one at the turning point, $Y = 1$, order 4 is off by less
# than a thousandth.

# %%
figure, axes = plt.subplots(figsize=(4.8, 3.6), layout="constrained")
for k, (n, values) in enumerate(errors.items()):
    style = {"color": plotting.COLOURS[k], "marker": plotting.MARKERS[k], "mfc": "none"}
    x = [float(p) for p, _ in pairs]
    axes.loglog(x, [float(e) for e in values], ls="", ms=4, label=f"order {n}", **style)
    slope = [float(values[-1]) * (v / x[-1]) ** (n + 1) for v in x]
    axes.loglog(x, slope, lw=0.8, color=plotting.COLOURS[k])
axes.set(xlabel=r"$\alpha a^2/\omega_0^2$", ylabel="relative error of the frequency")
axes.legend(frameon=False, fontsize="small")
plt.show()

# %% [markdown]
# At amplitudes that are not small the series part from each other. Points: periodic motions of
# the equation found by collocation, which knows nothing of elliptic functions and must have their
# frequency.

# %%
sizes = np.linspace(0.0, 2.4, 121)
curves = {
    f"order {n}": (sp.lambdify(y, truncated(ratio, y, n))(sizes**2) * np.ones_like(sizes), sizes)
    for n in cases
}
problem = mg.orbits.problem(eom, {omega_0: 1, alpha: 1})
orbits = []
for reach in np.linspace(0.2, 2.4, 12):
    _, speed = exact_pair(mp.mpf(reach) ** 2)
    # a whole family of orbits passes by: the nearest one is found
    orbit = mg.orbits.find(problem, [reach, 0.0], float(2 * mp.pi / speed), isolated=False)
    u_0, v_0 = orbit.states[:, 0]
    energy = v_0**2 / 2 + u_0**2 / 2 + u_0**4 / 4
    square, speed = exact_pair(mp.sqrt(1 + 4 * energy) - 1)
    assert abs(orbit.amplitude() - mp.sqrt(square)) < 1e-8
    assert abs(2 * np.pi / orbit.period - speed) < 1e-8
    orbits.append((2 * np.pi / orbit.period, orbit.amplitude()))
axes = plotting.backbone(
    curves,
    tuple(np.transpose(orbits)),
    xlabel=r"$\omega/\omega_0$",
    ylabel=r"$a\sqrt{\alpha}/\omega_0$",
)
axes.set(xlim=(0.9, 2.5), ylim=(0, 2.5))
plt.show()

# %% [markdown]
# ## 6. Certificates
#
# The same without any knowledge of the exact solution, as for every other system: motions of the
# emitted slow flow, put back into $u = \sum_{p<N} u_p$, beside time integration of the exact
# equation from the same state, over a time of order $1/\varepsilon$. The distance must fall like
# $\varepsilon^N$.

# %%
emission = mg.Emission(
    model="duffing",
    cases=list(cases.values()),
    samples=lambda case: {"omega_0": 1.3, "alpha": 2.9},
    amplitudes=lambda case: ([0.8 + 0.3j], 0.5),
    derivation="derivations/duffing.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 2",
)
report.certificate_table(emission.certificates.values())

# %%
axes = plotting.convergence(
    list(emission.certificates.values()),
    [f"order {c.order}" for c in emission.certificates.values()],
    quantity="motions at times of order 1/ε",
)
plt.show()

# %% [markdown]
# ## 7. The emitted functions
#
# `slow_flow` gives $\mathrm dA/\mathrm dt$ for complex amplitudes, `backbone` the shift of the
# frequency at a real amplitude:
#
# ```python
# from mms_functions.duffing import nonresonant_order_4 as case
#
# shift = case.backbone(0.5, omega_0=1.0, alpha=0.3)
# ```

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
