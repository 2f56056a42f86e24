# %% [markdown]
# # A pendulum whose support moves
#
# Three experiments with one pendulum. Its support shakes *up and down*: at about twice its own
# frequency it begins to swing. Its support shakes *to and fro*: it resonates at its own frequency,
# the lower, the further it swings. And standing on its head, it falls, unless the support shakes
# up and down fast enough.
#
# What is reproduced: boundary and amplitude of principal parametric resonance, A. H. Nayfeh and
# D. T. Mook, *Nonlinear Oscillations* (1979), chapter 5; the frequency response of primary
# resonance, chapter 4 there; and the condition under which the upright pendulum is stable, after
# P. L. Kapitza (1951).

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Markdown, Math, display
from orbits import harmonic, orbit
from scipy.special import mathieu_a, mathieu_b
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.symbols import modulus, phase

# %% [markdown]
# ## 1. The model
#
# A point mass on a massless rod of length $l$. Over $ml^2$, with $\omega^2 = g/l$ and lengths in
# units of $l$: the support is at $(h\cos\Omega t,\; z\cos\Omega t)$, the mass at
#
# $$x = h\cos\Omega t + \sin\theta, \qquad y = z\cos\Omega t - \cos\theta, \qquad
#   L = \tfrac12(\dot x^2 + \dot y^2) - \omega^2 y .$$
#
# Sine and cosine are kept as they are; the engine expands them as far as an order needs.

# %%
t = dynamicsymbols._t
theta = dynamicsymbols("theta")
omega, Omega = sp.symbols("omega Omega", positive=True)
h, z, mu = sp.symbols("h z mu", nonnegative=True)


def pendulum(gravity):
    """The exact equation of motion; gravity ω² > 0 where the pendulum hangs."""
    x = h * sp.cos(Omega * t) + sp.sin(theta)
    y = z * sp.cos(Omega * t) - sp.cos(theta)
    return mg.Model(
        lagrangian=sp.expand((x.diff(t) ** 2 + y.diff(t) ** 2) / 2 - gravity * y),
        coordinates=[theta],
        parameters=[
            mg.Parameter(omega, "rad/s", "natural frequency, root of g/l"),
            mg.Parameter(Omega, "rad/s", "frequency of the support"),
            mg.Parameter(h, "1", "amplitude of the support to and fro, over l"),
            mg.Parameter(z, "1", "amplitude of the support up and down, over l"),
            mg.Parameter(mu, "1/s", "damping"),
        ],
        dissipation=mu * theta.diff(t) ** 2,
    ).equations_of_motion()


eom = pendulum(omega**2)
report.equations(eom)

# %% [markdown]
# ## 2. Up and down: principal parametric resonance
#
# $z$ and $\mu$ are of order ε, the angle of order $\sqrt\varepsilon$, so that excitation, damping
# and the first nonlinear term meet at order 1.

# %%
vertical = eom.reparametrise({h: 0}).scale({z: 1, mu: 1}, amplitude=sp.Rational(1, 2))
display(report.orders(vertical, 1))
vertical.resonances(order=2)

# %%
up_down = {order: vertical.expand(order, {Omega: 2 * omega}) for order in (1, 2)}
display(report.solvability(up_down[1], 1))
display(report.solvability(up_down[2], 2))
report.modulation(up_down[1])

# %% [markdown]
# At rest in polar form the sine and cosine of $2\gamma_\theta$ follow, and their squares add up to
# one:

# %%
a, angle = modulus(theta), phase(theta)
s, c, P = sp.symbols("s c P", real=True)  # sine, cosine, a²


def condition(case, multiple):
    """0 = s² + c² − 1 of a steady motion, and s and c."""
    turned = {sp.sin(multiple * angle): s, sp.cos(multiple * angle): c}
    rates = [sp.expand(rate).subs(turned) for rate in case.slow_flow.polar.values()]
    (solution,) = sp.solve(rates, [s, c], dict=True)
    return sp.expand(solution[s] ** 2 + solution[c] ** 2 - 1), solution


swinging, direction = condition(up_down[1], 2)
sigma = up_down[1].relations[0].detuning
Math(
    rf"\left({sp.latex(sp.expand(direction[s]))}\right)^2 + "
    rf"\left({sp.latex(sp.expand(direction[c]))}\right)^2 = 1"
)

# %% [markdown]
# The Mathieu–Duffing oscillator
# $\ddot u + 2\mu\dot u + (\omega^2 + 2f\cos\Omega t)u + \alpha u^3 = 0$ has the boundary
# $\sigma^2 = f^2/\omega^2 - 4\mu^2$ and the amplitude
# $a^2 = \frac{4\omega}{3\alpha}\bigl(\sigma \pm \sqrt{f^2/\omega^2 - 4\mu^2}\bigr)$, printed for
# $\omega = 1$. The pendulum is one with $f = -\tfrac12 z\Omega^2 = -2\omega^2 z$ and
# $\alpha = -\omega^2/6$:

# %%
f, alpha = -2 * omega**2 * z, -(omega**2) / 6
root = sp.sqrt(f**2 / omega**2 - 4 * mu**2)
for sign in (-1, 1):
    square = 4 * omega * (sigma + sign * root) / (3 * alpha)
    assert sp.expand(swinging.subs(a, sp.sqrt(P)).subs(P, square)) == 0

linear = eom.reparametrise({h: 0}).linearise().scale({z: 1, mu: 1})
rest = {order: linear.expand(order, {Omega: 2 * omega}) for order in (1, 2)}
lower, upper = rest[1].slow_flow.boundary()
assert sp.expand(lower + upper) == 0 and sp.expand(upper**2 - root**2) == 0
half, width = (4 * omega * part / (3 * alpha) for part in (sigma, root / 2))
display(Math(rf"a_\theta^2 = {sp.latex(half)} \pm {sp.latex(sp.factor(-2 * width))}"))
report.boundary(rest[2])

# %% [markdown]
# ## 3. To and fro: primary resonance
#
# Here the angle is of order ε, damping of order ε² and the motion of the support of order ε³; so
# they meet at order 2, with the first nonlinear term.

# %%
horizontal = eom.reparametrise({z: 0}).scale({h: 3, mu: 2}, amplitude=1)
horizontal.resonances(order=2)

# %%
to_fro = {order: horizontal.expand(order, {Omega: omega}) for order in (2, 3)}
for order in (1, 2, 3):
    display(report.solvability(to_fro[3], order))
report.modulation(to_fro[2])

# %% [markdown]
# Order 3 accounts for the force $h\Omega^2$ growing with the frequency. The printed response of the
# Duffing oscillator to a force $k\cos\Omega t$ is
#
# $$\left[\mu^2 + \left(\sigma - \frac{3\alpha a^2}{8\omega}\right)^2\right] a^2
#   = \frac{k^2}{4\omega^2},$$
#
# and the pendulum's is this with $\alpha = -\omega^2/6$ and $k = h\omega^2$:

# %%
response, _ = condition(to_fro[2], 1)
k = h * omega**2
printed = (mu**2 + (sigma - 3 * alpha * a**2 / (8 * omega)) ** 2) * a**2 - k**2 / (4 * omega**2)
assert sp.cancel(response * k**2 / (4 * omega**2) - printed) == 0
bend = sp.expand(sigma - 3 * alpha * a**2 / (8 * omega))
Math(
    rf"\left[\mu^2 + \left({sp.latex(bend)}\right)^2\right] {sp.latex(a**2)} = "
    rf"{sp.latex(sp.expand(k**2 / (4 * omega**2)))}"
)

# %% [markdown]
# ## 4. On its head
#
# Upright, $\omega^2 = g/l$ changes its sign, and there is no leading oscillation to expand about.
# But the frequency $\nu$ with which the hanging pendulum swings, small and away from resonance, is
# known from the case without resonance, and $\nu^2$ is an analytic function of $\omega^2$ (the
# trace of the monodromy matrix, $2\cos(2\pi\nu/\Omega)$, is an entire one), so that it may be
# continued to negative values:

# %%
still = eom.reparametrise({h: 0, mu: 0}).linearise()
free = still.scale({z: 1}).expand(4)
(A,) = free.amplitudes
nu = omega + sum(sp.cancel(free.solvability[p][A] / (sp.I * A)) for p in (2, 4))
W = sp.Symbol("W", real=True)  # ω²
square = sp.expand(nu**2)
c_2, c_4 = (sp.cancel(square.coeff(z, p)).subs(omega, sp.sqrt(W)) for p in (2, 4))
terms = [sp.latex(sp.factor(part.subs(W, omega**2))) for part in (c_2, c_4)]
Math(rf"\nu^2 = \omega^2 + {terms[0]}\, z^2 + {terms[1]}\, z^4")

# %% [markdown]
# The upright pendulum neither falls nor swings where $\nu^2 = 0$. With $g/l$ for $-\omega^2$ that
# is a series in $z$, and Kapitza's condition $g/(l\Omega^2) < z^2/2$ is its first term:

# %%
first = c_2.subs(W, 0)
second = (c_4 - c_2 * c_2.diff(W)).subs(W, 0)
threshold = sp.expand((first * z**2 + second * z**4) / Omega**2)
assert threshold.coeff(z, 2) == sp.Rational(1, 2)
Math(rf"\frac{{g}}{{l\Omega^2}} < {sp.latex(threshold, order='rev-lex')}")

# %% [markdown]
# The same series follows from the first eigenvalue of Mathieu's equation, with
# $a = -4g/(l\Omega^2)$ and $q = 2z$ in $a_0(q) = -\tfrac12 q^2 + \tfrac{7}{128}q^4$ (NIST DLMF,
# equation 28.6.1). The support may also move too far: there the first tongue begins,
# $b_1(q) = 1 - q - \tfrac18 q^2 + \tfrac1{64} q^3 - \tfrac1{1536} q^4$ (28.6.3).

# %%
q = 2 * z
assert sp.expand(threshold + (-(q**2) / 2 + 7 * q**4 / 128) / 4) == 0

# %% [markdown]
# Floquet theory of the unexpanded equation about the upright position, at $\Omega = 1$ rad/s: the
# root of $g/l$ at which rest begins to be unstable, and what the series to order 2 and 4 leave:

# %%
upright = pendulum(-(omega**2)).reparametrise({h: 0, mu: 0}).linearise()
series = [sp.lambdify(z, sp.sqrt(part)) for part in (z**2 / 2, threshold)]
rows, gaps = [], []
for reach in (0.32, 0.16, 0.08):
    guess = series[1](reach)
    found = mg.floquet.boundary(
        upright, {"Omega": 1.0, "z": reach}, omega, (0.9 * guess, 1.1 * guess), points=21
    )
    exact = found.zones[0][0]
    gaps.append([abs(one(reach) - exact) for one in series])
    rows.append((f"{reach}", f"{exact:.6f}", *(f"{gap:.1e}" for gap in gaps[-1])))
report.Table(("z", "Floquet (rad/s)", "error, order 2", "error, order 4"), tuple(rows))

# %% [markdown]
# The error falls like $z^3$ and like $z^5$.
#
# ## 5. Certificates
#
# Motions of the slow flows beside motions of the exact equation, from the same state, over a time
# of order $1/\varepsilon$: the difference, over the order of the angle, has to fall like
# $\varepsilon^N$.

# %%
VERTICAL = {"omega": 1.3, "z": 0.9, "mu": 0.31, "sigma": 0.77}
HORIZONTAL = {"omega": 1.3, "h": 2.1, "mu": 0.7, "sigma": 0.57}


def samples(case):
    """Values at ε = 1, generic ones."""
    return VERTICAL if case in up_down.values() else HORIZONTAL


def amplitudes(case):
    """Starting amplitude, and time in s at ε = 1."""
    return ([0.5 + 0.7j], 1.5) if case in up_down.values() else ([0.8 + 0.5j], 1.0)


emission = mg.Emission(
    model="pendulum",
    cases=[*up_down.values(), *to_fro.values()],
    samples=samples,
    amplitudes=amplitudes,
    derivation="derivations/pendulum.py",
    source="Nayfeh and Mook, Nonlinear Oscillations (1979), chapters 4 and 5",
)
certificates = list(emission.certificates.values())
report.certificate_table(certificates)

# %% [markdown]
# Small oscillations, without the nonlinear terms, against Floquet theory: order $N + 1$.

# %%
SMALL = {"omega": 1.3, "z": 0.9, "mu": 0.31, "sigma": 0.37}
report.certificate_table([mg.certify(rest[2], SMALL)])

# %%
axes = plotting.convergence(certificates, quantity="motions at times of order 1/ε")

# %% [markdown]
# ## 6. Responses
#
# Steady amplitudes at $\omega = 1$ rad/s over the frequency of the support. Lines: order 1 for up
# and down, order 3 for to and fro. Points: the fundamental of exact periodic motions, by Newton's
# method on the map over their period (`derivations/orbits.py`), open where unstable. Left: up and
# down, $z = 0.03$, $\mu = 0.007$; middle: to and fro, $h = 0.01$, $\mu = 0.007$. Right: the upright
# pendulum is stable between the curves, from the series (dashed: to order 2) and from exact
# eigenvalues (points).

# %%
NUMBERS = {omega: 1, z: sp.Rational(3, 100), h: sp.Rational(1, 100), mu: sp.Rational(7, 1000)}
detunings, phases = {}, {}
for multiple, case in ((2, up_down[1]), (1, to_fro[3])):
    steady, solution = condition(case, multiple)
    numerator = sp.fraction(sp.together(steady.subs(NUMBERS)))[0]
    detunings[multiple] = [sp.lambdify(a, branch) for branch in sp.solve(numerator, sigma)]
    phases[multiple] = sp.lambdify([a, sigma], [solution[k].subs(NUMBERS) for k in (s, c)])


def exact_point(multiple, branch, size):
    """Frequency, exact amplitude, and stability of a motion near one of a formula."""
    detuning = detunings[multiple][branch](size)
    sine, cosine = phases[multiple](size, detuning)
    gamma = np.arctan2(sine, cosine) / multiple
    speed = 1 + detuning / multiple  # of the pendulum: Ω/2 or Ω
    known = {"omega": 1.0, "mu": 0.007, "Omega": multiple * speed}
    known |= {"z": 0.03, "h": 0.0} if multiple == 2 else {"z": 0.0, "h": 0.01}
    start = [size * np.cos(gamma), -speed * size * np.sin(gamma)]
    (path, _), multipliers = orbit(eom, known, 2 * np.pi / speed, start)
    return known["Omega"], harmonic(path, 1), np.abs(multipliers).max() < 1


figure, (left, middle, right) = plt.subplots(1, 3, figsize=(9.6, 3.3), layout="constrained")
for panel, multiple, highest in ((left, 2, 0.8), (middle, 1, 0.68)):
    sizes = np.linspace(0.08, highest, 400)
    for branch in (0, 1):
        with np.errstate(invalid="ignore"):
            speeds = multiple + detunings[multiple][branch](sizes)
        panel.plot(speeds, sizes, color=plotting.COLOURS[0])
        for size in highest * np.array((0.25, 0.55, 0.88)):
            speed, amplitude, stable = exact_point(multiple, branch, size)
            panel.plot(speed, amplitude, "ko", ms=4, mfc="black" if stable else "none")
    panel.set(xlabel="Ω (rad/s)", ylabel="amplitude of θ (rad)", ylim=(0, None))
    panel.locator_params(axis="x", nbins=4)

reach = np.linspace(0, 0.6, 121)
right.plot(reach**2 / 2, reach, "--", color=plotting.COLOURS[0])
right.plot(sp.lambdify(z, threshold)(reach), reach, color=plotting.COLOURS[0])
b_1 = np.polynomial.Polynomial([1, -1, -1 / 8, 1 / 64, -1 / 1536])
right.plot(-b_1(2 * reach) / 4, reach, color=plotting.COLOURS[1])
for exact in (mathieu_a(0, 2 * reach[::10]), mathieu_b(1, 2 * reach[::10])):
    right.plot(-exact / 4, reach[::10], "ko", ms=3, mfc="none")
_ = right.set(xlabel="g/(lΩ²)", ylabel="z", xlim=(0, 0.15), ylim=(0, 0.6), xticks=[0, 0.05, 0.1])

# %% [markdown]
# ## 7. The emitted functions
#
# ```python
# from mms_functions.pendulum import Omega_is_two_omega_order_2 as case
#
# rate = case.slow_flow([0.3 + 0.1j], omega=3.13, z=0.05, mu=0.02, sigma=-0.05)
# ```

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
