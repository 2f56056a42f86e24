# %% [markdown]
# # Ground resonance with blade dampers that are not linear
#
# Inside its zone, linear ground resonance grows without limit. What happens then is up to the
# hinges. Elastomeric dampers stiffen or soften as they move more, hydraulic ones resist by the
# square of the velocity. Either the growth saturates on a limit cycle, or a rotor that is stable at
# rest is thrown off by a kick that is large enough. This notebook derives both, for the sum
# combination $\Omega \approx \omega_x + \omega_\phi$ of the isotropic rotor, and compares them with
# motions of the unexpanded equations.
#
# The model is that of `ground_resonance` (Sanches, Michon, Berlioz and Alazard, *Int. J. Non-Linear
# Mechanics* (2014), doi 10.1016/j.ijnonlinmec.2014.04.003); the average of the velocity-squared
# damper is that of Krylov and Bogoliubov.

# %%
import many_motions
import matplotlib.pyplot as plt
import numpy as np
import rotor
import sympy as sp
from IPython.display import Markdown, display
from scipy.optimize import brentq

import mmsgen as mg
from mmsgen import plotting, report
from mmsgen.runtime._flow import rates, spectrum
from mmsgen.runtime._records import Bifurcation, Branch, Response
from mmsgen.symbols import modulus

# %% [markdown]
# ## 1. The model
#
# The hinge of every blade gets the moment $-K_3\phi^3 - c_2\dot\phi|\dot\phi| - c_3\dot\phi^3$
# beside its linear spring and damper. The fuselage is damped too. Over the inertia of a blade about
# its hinge, the new parameters are $\kappa$, $\mu_2$ and $\mu_3$. Nothing is linearised:

# %%
N_b = 4
model = rotor.with_nonlinear_hinges(rotor.helicopter(N_b))
x, y, *phi = model.coordinates
eom = rotor.at_speed(rotor.in_ratios(rotor.isotropic(model.equations_of_motion())))
display(report.parameter_table(eom.parameters), report.equations(eom, only=[phi[0]]))

# %% [markdown]
# ## 2. Orders in ε
#
# Motions are of order ε. Cubic terms then are of order ε² beside the linear ones, and the
# velocity-squared damper, with $\mu_2$ of order ε, as well. The coupling $r_m$, $r_b$ and the
# linear dampers are put there too, so that all of them meet at order 2. (The number ε² is what is
# small: in the balance, order 2 is the first.)

# %%
named = {p.name: p.symbol for p in eom.parameters}
Omega, omega_x, omega_phi = (named[name] for name in ("Omega", "omega_x", "omega_phi"))
mu_x, mu_b, mu_2, mu_3, kappa = (named[n] for n in ("mu_x", "mu_b", "mu_2", "mu_3", "kappa"))
r_m, r_b, r_a = (named[name] for name in ("r_m", "r_b", "r_a"))
second = dict.fromkeys(["r_m", "r_b", "mu_x", "mu_y", "mu_b"], 2)
scaled = eom.scale({**second, "mu_2": 1}, amplitude=1)
report.orders(scaled, 2)

# %% [markdown]
# ## 3. The slow flow
#
# $\Omega = \omega_x + \omega_\phi + \varepsilon\sigma$. Of the velocity-squared damper the
# fundamental harmonic stays, $\tfrac{8}{3\pi}$ of it: exact at this order, and known at no higher
# one, since it has infinitely many harmonics. The sine of the centrifugal moment
# $r_a^2\Omega^2\sin\phi$ softens the blade, beside $\kappa$.

# %%
case = scaled.expand(2, {Omega: omega_x + omega_phi})
flow = case.slow_flow
display(report.solvability(case, 2, only=[x, y, phi[0]]))

# %% [markdown]
# ## 4. A wave that travels round the rotor
#
# The blades drive the fuselage by their sum with the phases of their azimuths, and it drives them
# with the same phases. So the wave
#
# $$A_{\phi k} = B\,e^{2\pi i (k-1)/N_b}, \qquad A_x = X, \qquad A_y = 0$$
#
# stays a wave: put in, the equations of all blades are one equation, exactly.

# %%
A_x, A_y, *blades = case.amplitudes
X, B = sp.symbols("X B", complex=True)
turns = [sp.exp(2 * sp.pi * sp.I * sp.Rational(k, N_b)) for k in range(N_b)]
wave = {A_x: X, A_y: sp.Integer(0), **{a: t * B for a, t in zip(blades, turns, strict=True)}}
on_wave = {a: sp.expand(rate.subs(wave)) for a, rate in flow.autonomous.items()}
assert on_wave[A_y] == 0
for blade, turn in zip(blades, turns, strict=True):
    assert sp.expand(on_wave[blade] - turn * on_wave[blades[0]]) == 0
report.expression(r"\dot X", on_wave[A_x])

# %%
report.expression(r"\dot B", sp.collect(on_wave[blades[0]], B * sp.Abs(B)))

# %% [markdown]
# Alone, the blades would turn and decay like $\dot B = (-i\sigma - h + i w)\,B$, with a damping
# rate and a shift of frequency that depend on their amplitude $a = 2|B|$:

# %%
sigma = case.relations[0].detuning
a = modulus(phi[0])
alone = sp.expand(on_wave[blades[0]].subs({X: 0, B: a / 2}) / (a / 2))
real, imaginary = alone.as_real_imag()
h, w = sp.expand(-real), sp.expand(imaginary + sigma)
report.expression("h", h)

# %%
report.expression("w", sp.factor(w))

# %%
Omega_0 = omega_x + omega_phi
assert sp.expand(h - mu_b - 4 * mu_2 * omega_phi * a / (3 * sp.pi)) == sp.expand(
    3 * mu_3 * omega_phi**2 * a**2 / 8
)
assert sp.expand(w - 3 * (kappa - r_a**2 * Omega_0**2 / 6) * a**2 / (8 * omega_phi)) == 0

# %% [markdown]
# ## 5. The limit cycles
#
# On a limit cycle the fuselage turns with $\omega_x + \rho$ and the blades with
# $\omega_\phi + \sigma - \rho$, whose sum is Ω. From $\dot X = i\rho X$ follows
# $X = g_x \bar B/(\mu_x + i\rho)$, and from $\dot B = -i\rho B$, with $g^2 = g_x g_\phi$ (the
# coupling there and back),
#
# $$(\mu_x - i\rho)\,\bigl(h + i(\sigma - w - \rho)\bigr) = g^2 .$$
#
# Its imaginary part gives the drift $\rho = \mu_x(\sigma - w)/(\mu_x + h)$, and its real part then
# the detuning at which the limit cycle has the amplitude $a$, in closed form:
#
# $$\sigma = w(a) \pm \bigl(\mu_x + h(a)\bigr)\sqrt{\frac{g^2}{\mu_x h(a)} - 1} .$$
#
# At $a = 0$ these are the edges of the zone of the linear rotor with dampers. The curve ends where
# $h(a) = g^2/\mu_x$, its largest amplitude; about $w(a)$, the backbone, it is symmetric.

# %%
g_x = on_wave[A_x].coeff(sp.conjugate(B))
g_phi = on_wave[blades[0]].coeff(sp.conjugate(X))
g_squared = sp.cancel(g_x * g_phi)
assert sp.cancel(g_squared - N_b * r_m * r_b * omega_x**3 / (16 * omega_phi)) == 0

H, D, G = sp.symbols("h D g", positive=True)
rho = mu_x * D / (mu_x + H)
balance = sp.numer(sp.together((mu_x - sp.I * rho) * (H + sp.I * (D - rho)) - G**2))
relation = mu_x * H * (D**2 + (mu_x + H) ** 2) - G**2 * (mu_x + H) ** 2
assert sp.rem(sp.Poly(balance, D), sp.Poly(relation, D)).is_zero
report.expression("g^2", g_squared)

# %% [markdown]
# ## 6. Numbers
#
# Those of the paper, $\omega_\phi$ held at 11 rad/s, but for $r_m$, a quarter of it (a heavier
# fuselage: the coupling is weaker), with light linear dampers on fuselage and blades. Five rotors.
# Three have hinges with one nonlinearity each: a cubic stiffness, a cubic damper, a
# velocity-squared one. (With the dampers, $\kappa$ just makes up for the softening of the
# centrifugal moment, so that $w = 0$ and the damper acts alone.) The others have all of them: the
# hinges of the *hard* one stiffen and damp well, those of the *soft* one soften. The stability of
# each limit cycle is that in the whole slow flow, all blades and the other direction of the
# fuselage included: eigenvalues of its Jacobian in the frame that drifts with the cycle.

# %%
paper = {n: rotor.PAPER_VALUES[n] for n in ("r_m", "r_b", "r_a", "omega_x", "omega_y")}
common = {**paper, "omega_phi": 11.0, "mu_x": 0.3, "mu_y": 0.3, "mu_b": 0.15}
common["r_m"] /= 4
straight = common["r_a"] ** 2 * (common["omega_x"] + common["omega_phi"]) ** 2 / 6
rotors = {
    "cubic stiffness": {**common, "mu_2": 0.0, "mu_3": 0.0, "kappa": 600.0},
    "cubic damping": {**common, "mu_2": 0.0, "mu_3": 0.2, "kappa": straight},
    "velocity squared": {**common, "mu_2": 0.35, "mu_3": 0.0, "kappa": straight},
    "hard": {**common, "mu_2": 0.35, "mu_3": 0.1, "kappa": 150.0},
    "soft": {**common, "mu_2": 0.2, "mu_3": 0.05, "kappa": -300.0},
}
table = flow.table
symbols = [named[name] for name in common] + [mu_2, mu_3, kappa]
parts = sp.lambdify([a, *symbols], [h, w, g_squared, g_x], "numpy")
pattern = np.array([complex(t) for t in turns])
along = np.array([1.0, 0.0, *[-1.0] * N_b])  # how the amplitudes drift: A_x by ρ, blades by −ρ
assert table.flow.symmetries[1] == tuple(-along.astype(int))


def cycle(values, size, sign):
    """Detuning, drift ρ and amplitudes B_j of the limit cycle of an amplitude, on one side."""
    damping, shift, coupling, to_fuselage = parts(size, *values.values())
    mu = values["mu_x"]
    gap = sign * (mu + damping) * np.sqrt(max(coupling / (mu * damping) - 1, 0))
    drift = mu * gap / (mu + damping)
    body = to_fuselage * size / 2 / (mu + 1j * drift)
    return shift + gap, drift, np.array([body, 0, *(size / 2 * pattern)])


def growth(values, detuning, drift, amplitudes):
    """The largest real part of the eigenvalues of a limit cycle, or of rest."""
    numbers = table.numbers({**values, "sigma": detuning})
    left = rates(table.flow, numbers, amplitudes) - 1j * drift * along * amplitudes
    assert np.abs(left).max() < 1e-12  # a dozen terms of size 1, each rounded to 1e-16
    return spectrum(table.flow, numbers, amplitudes, [0, -drift])[0].real


REACH = 0.3  # rad: how far limit cycles are shown where damping does not bound them


def largest(values):
    """The amplitude at which the damping of the blades has eaten up the coupling, or `REACH`."""

    def excess(size):
        damping, _, coupling, _ = parts(size, *values.values())
        return values["mu_x"] * damping - coupling

    return brentq(excess, 0, 2) if excess(2) > 0 else REACH


def branch(values, way):
    """Limit cycles along (amplitude, side)."""
    points = [cycle(values, *place) for place in way]
    detunings, drifts, amplitudes = map(np.array, zip(*points, strict=True))
    drift = np.stack([0 * drifts, -drifts], axis=1)
    rise = np.array([growth(values, *point) for point in points])
    return Branch(detunings, amplitudes, drift, rise)


def response(values):
    """Rest, the limit cycles that it sheds at the edges of its zone, and their folds."""
    top = largest(values)
    sizes = top * np.sin(np.linspace(0, np.pi / 2, 202))[1:]
    ways = [[(size, -1) for size in sizes], [(size, 1) for size in sizes[-2::-1]]]
    if top < REACH:  # both sides meet
        ways = [ways[0] + ways[1]]
    still = np.zeros((len(detunings), 2 + N_b))
    rise = np.array([growth(values, s, 0.0, still[0]) for s in detunings])
    rest = Branch(detunings, still, still[:, :2], rise)
    cycles = [branch(values, way) for way in ways]
    born = [cycle(values, 0.0, sign) for sign in (-1, 1)]
    edges = [Bifurcation("Hopf", s, b, still[0, :2], abs(drift)) for s, drift, b in born]
    return Response("sigma", (rest, *cycles), (*edges, *folds(values, top)))


def folds(values, top):
    """Limit cycles at which two meet: the slope dσ/da vanishes."""
    given = dict(zip(symbols, values.values(), strict=True))
    for sign in (-1, 1):
        curve = w + sign * (mu_x + h) * sp.sqrt(g_squared / (mu_x * h) - 1)
        slope = sp.lambdify(a, curve.diff(a).subs(given), "numpy")
        sizes = np.linspace(0, 0.999 * top, 400)[1:]
        for k in np.flatnonzero(np.diff(np.sign(slope(sizes)))):
            detuning, drift, b = cycle(values, brentq(slope, *sizes[k : k + 2], xtol=1e-13), sign)
            # There the whole system has an eigenvalue of zero beside that of the drift: a double
            # one, which is rounded to the square root of 1e-16.
            assert abs(growth(values, detuning, drift, b)) < 1e-6
            yield Bifurcation("saddle-node", detuning, b, np.array([0, -drift]), 0.0)


detunings = np.linspace(-1.2, 1.2, 121)
responses = {name: response(values) for name, values in rotors.items()}
rows = []
for name, values in rotors.items():
    edges = " … ".join(f"{cycle(values, 0.0, sign)[0]:.4f}" for sign in (-1, 1))
    turning = ", ".join(
        f"{fold.parameter:.4f} ({fold.modulus[2]:.4f})" for fold in responses[name].bifurcations[2:]
    )
    top = largest(values)
    rows.append((name, edges, f"{top:.4f}" if top < REACH else "unbounded", turning or "none"))
report.Table(("rotor", "zone: σ (rad/s)", "largest $a$ (rad)", "folds: σ ($a$)"), tuple(rows))

# %% [markdown]
# Either damper alone bounds the amplitude: throughout the zone one limit cycle, stable. Stiffness
# alone takes no energy out. It shifts the zone, by $w(a)$: a rotor inside grows until it has left
# the zone by its lower edge, and that is its limit cycle; a rotor above the zone that is kicked so
# hard that the upper edge passes it is thrown off, onto the same limit cycle. The *hard* rotor
# saturates as those with dampers do. The *soft* one has two folds: below its zone, rest and a large
# limit cycle are stable both, and the unstable one between them is the amplitude beyond which the
# rotor is thrown off.
#
# ## 7. Motions of the unexpanded equations
#
# All coordinates, all nonlinear terms, integrated in time: from close to the limit cycles until
# they have settled, and from starts about the unstable ones, for the soft rotor at
# $\sigma = -0.83$ rad/s, for the one with stiffness alone at $\sigma = 1$ rad/s. A start is said
# to be thrown off if the wave ends larger than the unstable limit cycle of the slow flow.


# %%
def amplitude_at(values, detuning, sign, interval):
    """The amplitude of a limit cycle at a detuning."""
    return brentq(lambda size: cycle(values, size, sign)[0] - detuning, *interval, xtol=1e-12)


natural = np.array([common[f"omega_{n}"] for n in ("x", "y", *["phi"] * N_b)])


def beginning(amplitudes):
    """The state q, q' at t = 0."""
    return np.concatenate([2 * amplitudes.real, (2j * natural * amplitudes).real])


def settle(starts, times):
    """The motion of blade 1 from (values, detuning, amplitudes)."""
    speeds = [values["omega_x"] + values["omega_phi"] + s for values, s, _ in starts]
    given = {name: np.array([v[name] for v, _, _ in starts]) for name in rotors["hard"]}
    state = np.stack([beginning(amplitudes) for *_, amplitudes in starts], axis=1)
    found = many_motions.integrate(eom, {**given, "Omega": np.array(speeds)}, state, times, 1e-6)
    return found[2]


def stable_cycle(values, detuning):
    """The amplitude of the limit cycle on the side that is stable throughout."""
    top = largest(values)
    sign = 1 if detuning > cycle(values, top, 1)[0] else -1
    return amplitude_at(values, detuning, sign, (1e-3, top)), sign


hard, soft = rotors["hard"], rotors["soft"]
tops = {name: largest(values) for name, values in rotors.items()}
DETUNINGS = {
    "cubic stiffness": (-0.6, -0.35, -0.1, 0.15, 0.4),
    "cubic damping": (-0.55, -0.3, -0.05, 0.2, 0.45),
    "velocity squared": (-0.55, -0.3, -0.05, 0.2, 0.45),
    "hard": (-0.5, -0.25, 0.0, 0.25, 0.5),
    "soft": (-0.65, -0.4, -0.1, 0.2, 0.5),
}
steady = [(name, s, *stable_cycle(rotors[name], s)) for name, row in DETUNINGS.items() for s in row]
KICKED = {"soft": (-0.83, -1), "cubic stiffness": (1.0, 1)}
thresholds = {
    "soft": amplitude_at(soft, *KICKED["soft"], (0.11, 0.24)),
    "cubic stiffness": amplitude_at(
        rotors["cubic stiffness"], *KICKED["cubic stiffness"], (1e-3, REACH)
    ),
}
factors = np.linspace(0.7, 1.2, 11)
starts = [(rotors[name], s, cycle(rotors[name], size, sign)[2]) for name, s, size, sign in steady]
for name, (s, sign) in KICKED.items():
    unstable = cycle(rotors[name], thresholds[name], sign)[2]
    starts += [(rotors[name], s, k * unstable) for k in factors]
times = np.linspace(0, 80, 2001)
blade = settle(starts, times)

late = times >= 62
sizes, _ = many_motions.fundamental(times[late], blade[:, late], natural[2], 1.0)
settled, *kicked = np.split(sizes, len(steady) + len(factors) * np.arange(len(KICKED)))
thrown = {n: ends > thresholds[n] for n, ends in zip(KICKED, kicked, strict=True)}
rows = [
    (name, f"{s:.2f}", f"{size:.3f}", f"{exact:.3f}")
    for (name, s, size, _), exact in zip(steady, settled, strict=True)
]
report.Table(("rotor", "σ (rad/s)", "slow flow: $a$ (rad)", "in time: $a$ (rad)"), tuple(rows))

# %%
divides = {name: (factors[~off].max(), factors[off].min()) for name, off in thrown.items()}
for name, (last, first) in divides.items():
    assert last < first
    print(
        f"{name}: unstable limit cycle at {thresholds[name]:.3f} rad; starts up to {last:.2f} of it"
    )
    print(f"    come to rest, from {first:.2f} of it on they are thrown off")

# %% [markdown]
# The responses: lines are the formula, points the settled motions; the vertical bar is where starts
# turn from coming to rest to being thrown off. One nonlinearity at a time:


# %%
def panels_of(chosen):
    """A figure with a panel for each of some rotors."""
    shape = {"figsize": (3.2 * len(chosen), 3.8), "layout": "constrained"}
    _, panes = plt.subplots(1, len(chosen), **shape)
    for axes, (name, title) in zip(panes, chosen.items(), strict=True):
        plotting.frequency_response(
            responses[name],
            [None, None, "slow flow", *[None] * (N_b - 1)],
            colour=-2,
            axes=axes,
            xlabel="σ (rad/s)",
            ylabel="amplitude of a blade (rad)",
        )
        own = [(s, exact) for (n, s, *_), exact in zip(steady, settled, strict=True) if n == name]
        axes.plot(*zip(*own, strict=True), "ko", ms=4, label="motions in time")
        if name in KICKED:
            bar = np.array(divides[name]) * thresholds[name]
            label = "starts: rest below, thrown off above"
            axes.plot([KICKED[name][0]] * 2, bar, "k-", lw=4, label=label)
        axes.set(title=title, xlim=(-1.2, 1.2), ylim=(-0.01, 1.1 * tops[name]))
    return plotting.shared_legend(panes, 3)


_ = panels_of(
    {
        "cubic stiffness": "cubic stiffness",
        "cubic damping": "cubic damping",
        "velocity squared": r"damping by $\dot\phi|\dot\phi|$",
    }
)

# %% [markdown]
# And all of them together. The formula errs by a fraction ε² of the shift $w$; where its curve is
# steep, that is much in the amplitude.

# %%
_ = panels_of({"hard": "all, stiffening", "soft": "all, softening"})

# %% [markdown]
# Two starts of the soft rotor on either side of its unstable limit cycle, as they come to rest and
# are thrown off. Dashed: the unstable limit cycle of the slow flow, of which the starts are parts.

# %%
inner, outer = (
    len(steady) + int(np.flatnonzero(thrown["soft"] == side)[k]) for side, k in ((0, -1), (1, 0))
)
last, first = divides["soft"]
axes = plotting.time_response(
    times,
    {
        f"start at {first:.2f} of it, thrown off": blade[outer],
        f"start at {last:.2f} of it, to rest": blade[inner],
    },
    {"unstable limit cycle": thresholds["soft"]},
    ylabel="$\\phi_1$ (rad)",
)

# %% [markdown]
# ## 8. The error falls with ε²
#
# The next terms after the balance are smaller by ε². With everything scaled, the soft rotor at
# $\sigma = -0.4\,\varepsilon^2$:

# %%
starts, slow = [], []
for square in (2.0, 1.0, 0.5):
    small = {n: value * square if n in second else value for n, value in soft.items()}
    small["mu_2"] *= np.sqrt(square)
    size, sign = stable_cycle(small, -0.4 * square)
    slow.append(size)
    starts.append((small, -0.4 * square, cycle(small, size, sign)[2]))
times = np.linspace(0, 72, 1801)
late = times >= 57
exact, _ = many_motions.fundamental(times[late], settle(starts, times)[:, late], natural[2], 1.0)
errors = np.array(slow) / exact - 1
rows = [
    (f"{square:g}", f"{size:.4f}", f"{true:.4f}", f"{error:.1e}")
    for square, size, true, error in zip((2, 1, 0.5), slow, exact, errors, strict=True)
]
report.Table(("ε²", "slow flow: $a$", "in time: $a$", "relative error"), tuple(rows))

# %% [markdown]
# ## 9. Certificate
#
# Motions of the emitted slow flow beside those of the unexpanded equations, from generic starts.


# %%
def samples(case):
    """Generic numbers at ε = 1."""
    return {**hard, "r_b": 0.19, "mu_x": 0.37, "mu_y": 0.23, "kappa": 70.0, "sigma": 0.31}


emission = mg.Emission(
    model="ground_resonance_nonlinear",
    cases=[case],
    samples=samples,
    amplitudes=lambda case: ([0.1, 0.07j, 0.12, 0.2j, -0.1, 0.15], 0.4),
    derivation="derivations/ground_resonance_nonlinear.py",
    source="Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003",
)
report.certificate_table(emission.certificates.values())

# %%
Markdown("    " + mg.publish(emission).replace("\n", "\n    "))
