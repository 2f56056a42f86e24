"""Equilibria: found, checked exactly, shifted to, and expanded about."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from sympy.physics.mechanics import dynamicsymbols
from systems import d, equations, t, x, y

from mmsgen.certify import certify
from mmsgen.equations import EquationsOfMotion
from mmsgen.errors import EquilibriumError, ModelError, ScalingError
from mmsgen.expansion import Expansion
from mmsgen.model import Model
from mmsgen.motion import first_order_system
from mmsgen.parameters import Parameter
from mmsgen.symbols import modulus, phase

theta, phi = dynamicsymbols("theta phi")
m, k, h, g, R, Omega, f, w, x_0, length = sp.symbols("m k h g R Omega f omega x_0 l", positive=True)
c, s = sp.symbols("c s", positive=True)
theta_0 = sp.Symbol("theta_0", real=True)
SINE = Parameter(s, "1", "sine of the equilibrium angle", sp.sin(theta_0))
COSINE = Parameter(c, "1", "cosine of the equilibrium angle", sp.cos(theta_0))


def double_well() -> EquationsOfMotion:
    """x'' − kx + hx³ = 0."""
    return equations([d(x, 2) - k * x + h * x**3], [x])


def hoop() -> EquationsOfMotion:
    """A bead on a hoop of radius R that turns about its vertical diameter at the speed Ω."""
    kinetic = R**2 * (theta.diff(t) ** 2 + Omega**2 * sp.sin(theta) ** 2) / 2
    lagrangian = kinetic + g * R * sp.cos(theta)
    return Model(lagrangian, [theta], [g, R, Omega]).equations_of_motion()


def hanging() -> EquationsOfMotion:
    """A mass that hangs from a hardening spring: m x'' + kx + hx³ = mg."""
    return equations([m * d(x, 2) + k * x + h * x**3 - m * g], [x])


def hoop_about() -> EquationsOfMotion:
    balance = {g: R * (w / s) ** 2 * c, Omega: w / s}
    return hoop().about({theta: theta_0}, eliminate=balance, parameters=[SINE, COSINE, w])


def frequency(case: Expansion) -> sp.Expr:
    """The change of frequency of a free oscillator over its amplitude."""
    (q,) = case.coordinates
    flow = case.slow_flow.polar
    assert flow[modulus(q)] == 0
    return flow[phase(q)]


# --- finding --------------------------------------------------------------------------------------


def test_every_equilibrium_of_a_double_well() -> None:
    records = {r.values[x]: r for r in double_well().equilibria()}
    assert set(records) == {sp.Integer(0), sp.sqrt(k / h), -sp.sqrt(k / h)}
    assert all(r.proven for r in records.values())
    assert records[sp.Integer(0)].stiffness == sp.Matrix([[-k]])  # unstable, and visibly so
    assert records[sp.sqrt(k / h)].stiffness == sp.Matrix([[2 * k]])
    assert "x &= 0" in records[sp.Integer(0)]._repr_latex_()


def test_every_equilibrium_on_a_hoop_within_one_turn() -> None:
    angle = sp.acos(g / (R * Omega**2))
    records = {r.values[theta]: r for r in hoop().equilibria()}
    assert set(records) == {sp.Integer(0), sp.pi, angle, -angle}
    assert all(r.proven for r in records.values())
    assert records[angle].stiffness[0] == sp.cancel(R**2 * Omega**2 - g**2 / Omega**2)


def test_two_coordinates() -> None:
    """A pendulum on a spring: it hangs, stands, or rests in its pivot."""
    kinetic = m * (d(x) ** 2 + (length + x) ** 2 * d(phi) ** 2) / 2
    lagrangian = kinetic - k * x**2 / 2 + m * g * (length + x) * sp.cos(phi)
    eom = Model(lagrangian, [x, phi], [m, k, length, g]).equations_of_motion()
    points = [tuple(r.values.values()) for r in eom.equilibria() if r.proven]
    assert (m * g / k, sp.Integer(0)) in points
    assert (-m * g / k, sp.pi) in points
    about = eom.about({x: m * g / k})
    assert about.K[0, 0] == k
    stretched = length + m * g / k
    assert sp.expand(about.K[1, 1] - m * g * stretched) == 0
    assert sp.expand(about.M[1, 1] - m * stretched**2) == 0
    left = eom.equations[1].subs(x, m * g / k + x).doit()
    assert sp.expand(left - about.equations[1]) == 0


def test_excitation_is_left_out_by_name() -> None:
    eom = equations([d(x, 2) - k * x + h * x**3 + f * x * sp.cos(Omega * t)], [x])
    with pytest.raises(EquilibriumError, match=r"depends on time.*neglecting.*Omega, f, h, k"):
        eom.equilibria()
    for name in (f, "f"):
        assert len(eom.equilibria(neglecting=[name])) == 3
    with pytest.raises(ModelError, match="p is no parameter"):
        eom.equilibria(neglecting=["p"])
    with pytest.raises(EquilibriumError, match="must be a list"):
        eom.equilibria(neglecting="f")


@pytest.mark.parametrize(
    ("left", "phrase"),
    [
        (d(x, 2) + x**2 + k, "no real solution"),
        (d(x, 2) + k, "no real solution"),
        (d(x, 2) + k * d(x), "not isolated"),
        (d(x, 2) + sp.exp(x) + x**2 - k, r"no real solution in closed form.*eliminate"),
        (d(x, 2) + k / sp.sin(x) + 1 / x.diff(t), "singular"),
    ],
)
def test_where_there_is_none(left: sp.Expr, phrase: str) -> None:
    with pytest.raises(EquilibriumError, match=phrase):
        equations([left], [x]).equilibria()


# --- shifting -------------------------------------------------------------------------------------


def test_the_double_well_about_its_bottom() -> None:
    wanted = d(x, 2) + 2 * k * x + 3 * sp.sqrt(k * h) * x**2 + h * x**3
    (bottom,) = (r for r in double_well().equilibria() if r.values[x] == sp.sqrt(k / h))
    assert sp.expand(double_well().about(bottom).equations[0] - wanted) == 0
    named = double_well().about({x: x_0}, parameters=[Parameter(x_0, definition=sp.sqrt(k / h))])
    assert named.equations == (d(x, 2) + 2 * k * x + 3 * h * x_0 * x**2 + h * x**3,)
    assert named.parameters[-1].definition == sp.sqrt(k / h)
    numbers = equations([d(x, 2) - x + x**3], [x]).about({x: 1})
    assert numbers.equations == (d(x, 2) + 2 * x + 3 * x**2 + x**3,)


def test_sines_of_the_equilibrium_are_named_and_nothing_is_lost() -> None:
    eom = hoop_about()
    assert eom.K == sp.Matrix([[w**2]])
    assert {p.symbol: p.definition for p in eom.parameters} == {
        w: None,
        s: sp.sin(theta_0),
        c: sp.cos(theta_0),
        theta_0: None,
    }
    numbers = {w: sp.Rational(7, 5), theta_0: sp.Rational(4, 7), theta: sp.Rational(3, 11)}
    written = eom.equations[0].subs({s: sp.sin(theta_0), c: sp.cos(theta_0)}).subs(d(theta, 2), 0)
    speed = w / sp.sin(theta_0)
    angle = theta_0 + theta
    exact = speed**2 * sp.sin(angle) * (sp.cos(theta_0) - sp.cos(angle))
    assert abs(sp.N((written - exact).subs(numbers), 30)) < 1e-28  # 30 digits, both of size one
    again = hoop().about(
        {theta: sp.acos(c)},
        eliminate={g: R * (w / s) ** 2 * c, Omega: w / s},
        parameters=[c, Parameter(s, definition=sp.sqrt(1 - c**2)), w],
    )
    assert sp.cancel(again.K[0]) == w**2


def test_a_pendulum_in_a_steady_wind() -> None:
    """Gravity and a horizontal force add up to one force along the rod at rest."""
    eom = equations([length * theta.diff(t, 2) + g * sp.sin(theta) - f * sp.cos(theta)], [theta])
    about = eom.about({theta: theta_0}, eliminate={f: g * s / c}, parameters=[COSINE, SINE])
    wanted = theta.diff(t, 2) + g * sp.sin(theta) / (length * c)
    assert about.equations == (wanted,)
    closed = eom.about({theta: sp.atan(f / g)}).equations[0]
    assert sp.cancel(closed.coeff(sp.sin(theta)) ** 2 - f**2 - g**2) == 0
    assert closed.coeff(sp.cos(theta)) == 0


def test_a_frequency_may_be_named_afterwards() -> None:
    balance = {g: R * Omega**2 * sp.cos(theta_0)}
    seen = hoop().about({theta: theta_0}, eliminate=balance, parameters=[SINE, COSINE])
    assert seen.K == sp.Matrix([[Omega**2 * s**2]])
    named = seen.reparametrise({Omega: w / s}, [Parameter(w, definition=Omega * s)])
    assert named.equations == hoop_about().equations


def test_radicals_are_written_about_the_equilibrium() -> None:
    """A snap-through spring: √(l² + x²) about x_0, with the free length L in its place."""
    free = sp.Symbol("L", positive=True)
    lagrangian = m * d(x) ** 2 / 2 - k * (sp.sqrt(length**2 + x**2) - free) ** 2 / 2
    eom = Model(lagrangian, [x], [m, k, length, free]).equations_of_motion()
    about = eom.about({x: x_0}, eliminate={length: sp.sqrt(free**2 - x_0**2)})
    assert about.K == sp.Matrix([[k * x_0**2 / (free**2 * m)]])
    assert about.equations[0].has(1 / sp.sqrt(free**2 + 2 * x_0 * x + x**2))


def test_small_constant_forces_stay() -> None:
    eom = equations([d(x, 2) - k * x + h * x**3 + f * (1 + sp.cos(Omega * t))], [x])
    with pytest.raises(EquilibriumError, match=r"equation of x\(t\) the force -f remains"):
        eom.about({x: sp.sqrt(k / h)})
    left = eom.about({x: sp.sqrt(k / h)}, neglecting=[f]).equations[0]
    assert sp.expand(left.subs({x: 0}).doit() - f * (1 + sp.cos(Omega * t))) == 0


@given(st.integers(-4, 4), st.lists(st.integers(-3, 3), min_size=1, max_size=3))
def test_a_shifted_polynomial_is_the_polynomial(root: int, factor: list[int]) -> None:
    force = (x - root) * sp.Add(*(n * x**j for j, n in enumerate(factor)))
    eom = EquationsOfMotion((d(x, 2) + x * d(x) + force,), (x,), ())
    wanted = d(x, 2) + (root + x) * d(x) + force.xreplace({x: root + x})
    assert sp.expand(eom.about({x: root}).equations[0] - wanted) == 0
    remaining = force.xreplace({x: sp.Integer(root + 1)})
    if remaining:
        with pytest.raises(EquilibriumError, match=rf"the force {-remaining} remains"):
            eom.about({x: root + 1})


@pytest.mark.parametrize(
    ("call", "phrases"),
    [
        (lambda: double_well().about({x: 1}), ["x(t) = 1", "no equilibrium", "equation of x(t)"]),
        (lambda: double_well().about({y: 0}), ["y(t) is no coordinate", "x(t)"]),
        (lambda: double_well().about({x: 0.5}), ["equilibrium of x(t)", "floating-point"]),
        (lambda: double_well().about({x: sp.sqrt(-k / h)}), ["equilibrium of x(t)", "imaginary"]),
        (lambda: double_well().about({x: t}), ["equilibrium of x(t)", "not constant"]),
        (lambda: double_well().about({x: x}), ["equilibrium of x(t)", "not constant"]),
        (lambda: double_well().about([0]), ["mapping coordinate -> value"]),  # type: ignore[arg-type]
        (lambda: double_well().about({x: 0}, eliminate={"p": 1}), ["p is no parameter"]),
        (lambda: double_well().about({x: 0}, eliminate=[k]), ["mapping parameter -> expression"]),  # type: ignore[arg-type]
        (
            lambda: double_well().about(
                {x: 0}, eliminate={k: 1 / (sp.sin(theta_0) ** 2 + sp.cos(theta_0) ** 2 - 1)}
            ),
            ["denominator in eliminate"],
        ),
        (lambda: hoop().about({theta: theta_0}), ["theta_0", "the force", "sin(2*theta_0)"]),
        (
            lambda: hoop().about({theta: theta_0}, eliminate={g: R * Omega**2 * sp.cos(theta_0)}),
            ["contain cos(theta_0)", "definition=cos(theta_0)"],
        ),
        (
            lambda: double_well().about({x: x_0}, parameters=[Parameter(x_0, definition=k / h)]),
            ["x_0 = k/h", "eliminate"],
        ),
        (
            lambda: equations([d(x, 2) + x**2 - 2 * x - 2 * sp.sqrt(2) * x + 1], [x]).about(
                {x: sp.sqrt(3 + 2 * sp.sqrt(2)) + sp.sqrt(2) - 1 - sp.sqrt(2)}
            ),
            ["equilibrium"],
        ),
        (
            lambda: equations([d(x, 2) + x - 1 - sp.sqrt(2)], [x]).about(
                {x: sp.sqrt(3 + 2 * sp.sqrt(2))}
            ),
            ["cannot be decided exactly", "equation of x(t)", "eliminate"],
        ),
        (lambda: equations([d(x, 2) - 1 / x], [x]).about({x: 0}), ["singular", "x(t)"]),
    ],
)
def test_refused_by_name_about(call: Any, phrases: list[str]) -> None:
    with pytest.raises(ModelError) as caught:
        call()
    assert not [p for p in phrases if p not in str(caught.value)], caught.value


def test_an_unstable_equilibrium_is_refused_by_the_leading_order() -> None:
    refusal = (
        r"equation of x\(t\) at leading order.*not oscillate.*stiffness over inertia is {} < 0"
    )
    with pytest.raises(ScalingError, match=refusal.format("-k") + ".*equilibria"):
        double_well().about({x: 0}).scale({}, amplitude=1).expand(1)
    unstable = double_well().about({x: 0}, eliminate={k: w**2})
    with pytest.raises(ScalingError, match=refusal.format(r"-omega\*\*2")):
        unstable.scale({}, amplitude=1).expand(1)
    with pytest.raises(ScalingError, match=r"equation of theta\(t\).*not oscillate.*< 0"):
        hoop().about({theta: sp.pi}).scale({}, amplitude=1).expand(1)


# --- expanded about -------------------------------------------------------------------------------


def test_the_published_frequency_of_quadratic_and_cubic_terms() -> None:
    """Nayfeh and Mook (1979), chapter 4: ω_2 = (9α_3ω² − 10α_2²)a²/(24ω³)."""
    a = modulus(x)
    balance = {h: w**2 / (2 * x_0**2), k: w**2 / 2}
    well = double_well().about({x: x_0}, eliminate=balance)
    quadratic, cubic = 3 * w**2 / (2 * x_0), w**2 / (2 * x_0**2)
    wanted = (9 * cubic * w**2 - 10 * quadratic**2) * a**2 / (24 * w**3)
    assert sp.cancel(frequency(well.scale({}, amplitude=1).expand(2)) - wanted) == 0
    sag = hanging().about({x: x_0}, eliminate={g: (k * x_0 + h * x_0**3) / m})
    sag = sag.reparametrise({k: m * w**2 - 3 * h * x_0**2})
    quadratic, cubic = 3 * h * x_0 / m, h / m
    wanted = (9 * cubic * w**2 - 10 * quadratic**2) * a**2 / (24 * w**3)
    assert sp.cancel(frequency(sag.scale({}, amplitude=1).expand(2)) - wanted) == 0


def slope(errors: list[float], sizes: list[float]) -> float:
    """The fitted power of the size."""
    return float(np.polyfit(np.log(sizes), np.log(errors), 1)[0])


def test_the_double_well_against_its_elliptic_function() -> None:
    """x'' − x + x³ = 0 is solved by A dn(At/√2, 2 − 2/A²) (DLMF, chapter 22).

    The fundamental of dn is known from its Fourier series, 2πq/(K(1 + q²)). At order 4 of the
    amplitude the frequency errs by a⁶, at order 2 by a⁴.
    """
    balance = {h: w**2 / (2 * x_0**2), k: w**2 / 2}
    scaled = double_well().about({x: x_0}, eliminate=balance).scale({}, amplitude=1)
    for order, power in ((2, 4), (4, 6)):
        shift = sp.lambdify(
            modulus(x), frequency(scaled.expand(order)).subs({w: sp.sqrt(2), x_0: 1}), "mpmath"
        )
        errors, sizes = [], []
        with mpmath.workdps(40):
            for j in range(4, 9):
                top = 1 + mpmath.mpf(2) ** -j
                modulus_m = 2 - 2 / top**2
                quarter = mpmath.ellipk(modulus_m)
                nome = mpmath.qfrom(m=modulus_m)
                a = top * 2 * mpmath.pi / quarter * nome / (1 + nome**2)
                exact = mpmath.pi * top / (mpmath.sqrt(2) * quarter)
                errors.append(float(abs(mpmath.sqrt(2) + shift(a) - exact)))
                sizes.append(float(a))
        # The next term changes the slope by a² times a number of order one: 4 % at the largest a.
        assert abs(slope(errors, sizes) - power) < 0.05


def test_the_hoop_against_integrated_periods() -> None:
    """Periods of the unshifted equation, its fundamental by a Fourier sum over one of them."""
    at = {w: 1.3, theta_0: 0.8}
    sine, cosine = np.sin(at[theta_0]), np.cos(at[theta_0])
    shift = frequency(hoop_about().scale({}, amplitude=1).expand(2)).subs({s: sine, c: cosine})
    predicted = sp.lambdify(modulus(theta), shift.subs(at))
    speed = at[w] / sine
    values = {"Omega": speed, "R": 0.7, "g": 0.7 * speed**2 * cosine}
    derivative = first_order_system(hoop(), values)

    def crossing(_: float, state: Any) -> Any:
        return state[1]

    crossing.direction = -1  # type: ignore[attr-defined]
    errors, sizes = [], []
    for start in (0.2, 0.15, 0.1, 0.07, 0.05):
        # At rest in its largest angle, and so again after one period.
        run = solve_ivp(
            derivative, (0, 30), [0.8 + start, -1e-300], "DOP853", events=crossing, rtol=1e-12,
            atol=1e-14, dense_output=True,
        )  # fmt: skip
        period = run.t_events[0][run.t_events[0] > 1][0]
        times = np.arange(64) * period / 64
        a = 2 * abs(np.mean(run.sol(times)[0] * np.exp(-2j * np.pi * times / period)))
        errors.append(abs(at[w] + predicted(a) - 2 * np.pi / period))
        sizes.append(a)
    assert abs(slope(errors, sizes) - 4) < 0.1


def test_a_certificate_about_an_equilibrium() -> None:
    """Motions about the hoop's equilibrium have the exponent that the order claims."""
    case = hoop_about().scale({}, amplitude=1).expand(2)
    evidence = certify(case, {"omega": 1.3, "theta_0": 0.8}, amplitudes=[0.2 + 0.1j], span=1.0)
    assert evidence.passed
