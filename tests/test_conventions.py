"""Results in other conventions: against published ones, and there and back again."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from second_method import Averaging
from systems import (
    A,
    Ac,
    B,
    Bc,
    Omega,
    alpha,
    beta,
    coupled_mathieu,
    d,
    duffing,
    f,
    kappa,
    mathieu,
    mu,
    omega,
    omega_1,
    omega_2,
    oscillator,
    pair,
    sigma,
    t,
    van_der_pol,
    x,
)

from mmsgen import conventions as cv
from mmsgen.errors import ConventionError
from mmsgen.expansion import Expansion
from mmsgen.symbols import modulus

a = modulus(x)
X, q = sp.symbols("X q", positive=True)
new = sp.Symbol("sigma_hat", real=True)


def numbers(flow: cv.Flow) -> cv.Flow:
    return {p: {v: sp.expand(e) for v, e in g.items()} for p, g in flow.items()}


# --- frequency and amplitude ----------------------------------------------------------------------


def test_two_amplitudes_of_the_duffing_oscillator() -> None:
    """−15/256 with the fundamental, −21/256 with the largest displacement; both are right."""
    case = duffing().expand(3)
    y = alpha * a**2 / omega**2
    coefficients = [1, sp.Rational(3, 8), sp.Rational(-15, 256), sp.Rational(123, 8192)]
    found = cv.frequency(case)
    assert found == {p: sp.expand(omega * c * y**p) for p, c in enumerate(coefficients)}
    over = cv.reversion(cv.displacement(case), a, X)
    y = alpha * X**2 / omega**2
    coefficients = [1, sp.Rational(3, 8), sp.Rational(-21, 256), sp.Rational(81, 2048)]
    largest = cv.substituted(found, {a: over})
    assert largest == {p: sp.expand(omega * c * y**p) for p, c in enumerate(coefficients)}


def test_the_largest_displacement_against_the_elliptic_integral() -> None:
    """π√(1 + y)/(2K(m)), m = y/(2(1 + y)), has the series in y that the conversion gives."""
    case = duffing().expand(4)
    over = cv.reversion(cv.displacement(case), a, X)
    series = cv.substituted(cv.frequency(case), {a: over})
    found = [c.subs({omega: 1, alpha: 1, X: 1}) for c in series.values()]
    with mpmath.workdps(40):
        exact = mpmath.taylor(
            lambda y: mpmath.pi * mpmath.sqrt(1 + y) / (2 * mpmath.ellipk(y / (2 + 2 * y))), 0, 4
        )
        # Differences in mpmath's 40 digits; the fifth coefficient of the series is about 0.04.
        assert all(abs(mpmath.mpf(c.p) / c.q - e) < 1e-9 for c, e in zip(found, exact, strict=True))


def test_both_ends_of_a_motion_have_one_energy() -> None:
    """½ω²x² + βx³/3 + αx⁴/4 at phases 0 and π, through the order that the displacements have."""
    scaled = oscillator(beta * x**2 + alpha * x**3).scale({beta: 1, alpha: 2})
    case = scaled.expand(4)
    ends = [cv.displacement(case, phase) for phase in (0, sp.pi)]
    assert ends[0][1] == -(a**2) * beta / (3 * omega**2) == ends[1][1]
    energies = []
    for end in ends:
        place = sp.Symbol("place")
        parts = {
            0: omega**2 * place**2 / 2,
            1: beta * place**3 / 3,
            2: alpha * place**4 / 4,
            3: sp.Integer(0),
        }
        energies.append(cv.substituted(parts, {place: end}))
    assert energies[0] == energies[1]
    assert energies[0][0] == omega**2 * a**2 / 2


def test_powers_of_a_series() -> None:
    """ω² over the amplitude, as Lindstedt and Poincaré expand it, and back."""
    series = cv.frequency(duffing().expand(2))
    squared = cv.power(series, 2)
    assert squared[1] == 3 * a**2 * alpha / 4
    assert squared[2] == 3 * a**4 * alpha**2 / (128 * omega**2)
    assert cv.power(squared, sp.Rational(1, 2)) == series
    assert cv.power(series, -1)[1] == -3 * a**2 * alpha / (8 * omega**3)


COEFFICIENTS = st.fractions(-3, 3, max_denominator=5)


def as_rational(value: Any) -> sp.Rational:
    return sp.Rational(value.numerator, value.denominator)


@given(st.lists(COEFFICIENTS, min_size=1, max_size=4), COEFFICIENTS.filter(bool))
def test_reversion_there_and_back(values: list[Any], slope: Any) -> None:
    series = {0: as_rational(slope) * a}
    series |= {p: as_rational(c) * a ** (p + 1) for p, c in enumerate(values, start=1)}
    back = cv.reversion(series, a, X)
    assert cv.substituted(series, {a: back}) == {0: X, **dict.fromkeys(range(1, len(series)), 0)}
    assert cv.reversion(back, X, a) == series


# --- amplitudes -----------------------------------------------------------------------------------


def test_the_autonomous_flow_by_orders() -> None:
    case = mathieu().expand(2, {Omega: 2 * omega})
    flow = cv.autonomous(case)
    assert flow[1][A] == -sp.I * sigma * A / 2 + case.solvability[1][A].subs(t, 0)
    whole = case.slow_flow.autonomous[A]
    assert sp.expand(sp.Add(*(g[A] for g in flow.values())) - whole) == 0


def random_polynomials(time: bool) -> st.SearchStrategy[dict[sp.Symbol, sp.Expr]]:
    """Terms in both amplitudes, their conjugates and, where asked for, e^{iσt}."""
    terms = [A, Ac, B, Bc, A**2 * Ac, sp.I * A * Bc, sp.I * B, B * A, kappa * Ac * B]
    if time:
        terms += [sp.exp(sp.I * sigma * t) * Ac, sp.I * sp.exp(-sp.I * sigma * t) * B]
    term = st.tuples(COEFFICIENTS, st.sampled_from(terms))
    entry = st.lists(term, max_size=2).map(
        lambda pairs: sp.Add(*(as_rational(c) * e for c, e in pairs))
    )
    return st.fixed_dictionaries({A: entry, B: entry})


@settings(max_examples=8)
@given(st.lists(random_polynomials(True), min_size=4, max_size=4))
def test_changes_there_and_back(parts: list[Any]) -> None:
    """The inverse undoes a change, and two changes in turn are the change of both."""
    flow = {1: parts[0], 2: parts[1], 3: {A: sp.I * A, B: kappa * B}}
    change, other = {1: parts[2], 2: parts[3]}, {1: parts[3], 2: parts[2]}
    there = cv.changed(flow, change)
    back = cv.changed(there, cv.inverse(change, 2))
    assert numbers(back) == numbers(flow)
    none = dict.fromkeys((A, B), sp.Integer(0))
    assert cv.followed_by(change, cv.inverse(change, 2)) == {1: none, 2: none}
    both = cv.changed(flow, cv.followed_by(change, other))
    assert numbers(both) == numbers(cv.changed(there, other))


def test_a_change_that_turns_with_time() -> None:
    """A at rest: B = A − εk e^{iσt} has B' = −ε²iσk e^{iσt}, with εσ for σ."""
    turn = kappa * sp.exp(sp.I * sigma * t)
    rest = {1: {A: 0}, 2: {A: 0}, 3: {A: 0}}
    flow = cv.changed(rest, {1: {A: turn}})
    assert flow == {1: {A: 0}, 2: {A: -sp.I * sigma * turn}, 3: {A: 0}}


def limit_cycle(flow: cv.Flow) -> tuple[sp.Expr, sp.Expr]:
    """Amplitude to order 1 and change of frequency to order 2 of a limit cycle of radius 2."""
    half = {A: a / 2, Ac: a / 2}
    rates = [sp.expand(flow[p][A].xreplace(half) / (a / 2)) for p in (1, 2)]
    radial, angular = zip(*(r.as_real_imag() for r in rates), strict=True)
    first = sp.cancel(-(radial[1] / radial[0].diff(a)).subs(a, 2))
    turn = angular[0].subs(a, 2) + angular[0].diff(a).subs(a, 2) * first + angular[1].subs(a, 2)
    return first, sp.expand(turn)


def test_the_frequency_does_not_depend_on_the_choice_of_amplitude() -> None:
    """Van der Pol's limit cycle has 1 − μ²/16 whatever homogeneous part is kept."""
    case = van_der_pol().expand(2)
    flow = case.solvability
    flow = {
        p: {v: e.subs(mu, sp.Symbol("m", real=True)) for v, e in g.items()} for p, g in flow.items()
    }
    m = sp.Symbol("m", real=True)
    assert limit_cycle(flow) == (0, -(m**2) / 16)
    kept = cv.changed(flow, {1: {A: m * A / 3 + sp.I * m * A**2 * Ac / 5}})
    assert kept != flow
    # A = B + h: the radius of B is 2 − 2 Re h/|A| at the cycle
    assert limit_cycle(kept) == (-2 * m / 3, -(m**2) / 16)


def averaged(case: Expansion) -> list[sp.Expr]:
    """Averaging of z = (q − iq')/2 to order two: the fundamental of z."""
    averaging = Averaging(case, 2, fundamental=False)
    names = {sp.Symbol("a_0"): A, sp.Symbol("abar_0"): Ac}
    both = (averaging.space.expression(row[0]) for row in averaging.rates_of)
    return [sp.expand(e.subs(names)) for e in both]


@pytest.mark.parametrize(
    "force",
    [
        alpha * x**3,
        -mu * (1 - x**2) * d(x),
        mu * d(x) ** 3 - mu * d(x) + beta * x**2,
        alpha * x * d(x) + kappa * d(x) ** 2 + beta * x**3,
    ],
)
def test_first_order_variables_are_those_of_averaging(force: sp.Expr) -> None:
    eom = oscillator(force, sp.Integer(1))
    case = eom.scale({p.symbol: 1 for p in eom.parameters}).expand(2)
    flow = cv.changed(case.solvability, cv.first_order_variables(case))
    first, second = averaged(case)
    assert sp.expand(flow[1][A] - first) == 0
    assert sp.expand(flow[2][A] - second) == 0
    assert sp.expand(case.solvability[2][A] - second) != 0


def test_factors_and_signs_of_the_exponent() -> None:
    case = duffing().expand(2)
    half = cv.rescaled(case.solvability, sp.Rational(1, 2))  # B = a e^{iβ}
    assert half[1][A] == sp.I * 3 * alpha * A**2 * Ac / (8 * omega)
    forced = oscillator(2 * mu * d(x) + alpha * x**3 - f * sp.cos(Omega * t))
    flow = forced.scale({mu: 1, alpha: 1, f: 1}).expand(1, {Omega: omega}).solvability
    turn = sp.exp(sp.I * sigma * t)
    assert sp.expand(flow[1][A].coeff(turn)) == -sp.I * f / (4 * omega)
    minus = cv.rescaled(flow, 1, conjugate=True)  # q = B e^{−iωt} + c.c.
    assert minus[1][A].coeff(1 / turn) == sp.I * f / (4 * omega)
    assert minus[1][A].coeff(A, 1).coeff(turn, 0) == -mu
    sine = cv.rescaled(flow, -sp.I / 2)  # q = a sin(ωt + β), B = a e^{iβ}
    assert sine[1][A].coeff(turn) == f / (2 * omega)


@cache
def resonant_mathieu() -> Expansion:
    return mathieu().expand(2, {Omega: 2 * omega})


@given(COEFFICIENTS.filter(bool), COEFFICIENTS, st.booleans())
def test_factors_there_and_back(real: Any, imaginary: Any, conjugate: bool) -> None:
    flow = resonant_mathieu().solvability
    factor = as_rational(real) + sp.I * as_rational(imaginary)
    there = cv.rescaled(flow, factor, conjugate)
    back = 1 / (sp.conjugate(factor) if conjugate else factor)
    assert numbers(cv.rescaled(there, back, conjugate)) == numbers(flow)


# --- detunings ------------------------------------------------------------------------------------


def tongue(flow: cv.Flow, value: sp.Expr, sign: int, order: int) -> list[sp.Expr]:
    """What is left of |dB/dB| = |dB/dB̄| where σ_hat is a series in q of the first order."""
    whole = sp.expand(sp.Add(*(g[A] for g in flow.values())) / sp.I)
    gap = whole.coeff(A) - sign * whole.coeff(Ac)
    polynomial = sp.Poly(gap.subs({Omega: 2, alpha: q}).subs(new, value), q)
    return [polynomial.coeff_monomial(q**p) for p in range(order + 1)]


@pytest.mark.parametrize(
    ("relation", "order", "value"),
    [
        ({Omega: 2 * omega}, 3, q - q**2 / 8 - q**3 / 64),
        ({Omega: 2 * omega}, 3, -q - q**2 / 8 + q**3 / 64),
        ({Omega: 2 * omega}, 4, q - q**2 / 8 - q**3 / 64 - q**4 / 1536),
        ({Omega: omega}, 2, 5 * q**2 / 12),
        ({Omega: omega}, 2, -(q**2) / 12),
        ({Omega: omega}, 4, 5 * q**2 / 12 - 763 * q**4 / 13824),
        ({Omega: omega}, 4, -(q**2) / 12 + 5 * q**4 / 13824),
    ],
)
def test_characteristic_values_of_mathieu(relation: Any, order: int, value: sp.Expr) -> None:
    """w'' + (a ∓ 2q cos 2z)w = 0, a = ω² = ω_res² + σ_hat: a_1, b_1, a_2, b_2 of DLMF 28.6."""
    case = mathieu().expand(order, relation)
    flow = cv.substituted(cv.autonomous(case), cv.detuned(case, omega, new))
    assert any(not any(tongue(flow, value, sign, order)) for sign in (1, -1))
    assert not any(not any(tongue(flow, value + q**order, s, order)) for s in (1, -1))


def test_a_squared_excitation_frequency_there_and_back() -> None:
    """Ω² = 4ω² + εσ_hat means σ_hat = 4ωσ + εσ²."""
    case = mathieu().expand(3, {Omega: 2 * omega})
    values = cv.detuned(case, Omega, new)
    assert values[sigma][0] == new / (4 * omega)
    assert values[sigma][1] == -(new**2) / (64 * omega**3)
    flow = cv.autonomous(case)
    there = cv.substituted(flow, values)
    assert there[1][A] != flow[1][A]
    zero = sp.Integer(0)
    back = cv.substituted(there, {new: {0: 4 * omega * sigma, 1: sigma**2, 2: zero}})
    assert numbers(back) == numbers(flow)


def test_a_detuning_of_the_natural_frequency_itself() -> None:
    """ω = Ω/2 + εσ_hat: the same flow as with Ω = 2ω − 2εσ_hat."""
    case = mathieu().expand(2, {Omega: 2 * omega})
    values = cv.detuned(case, omega, new, exponent=1)
    assert values[sigma][0] == -2 * new
    assert not any(values[sigma][p] for p in (1, 2))
    flow = cv.substituted(cv.autonomous(case), values)
    assert sp.expand(flow[1][A] - sp.I * new * A - sp.I * alpha * Ac / Omega) == 0


# --- bad input ------------------------------------------------------------------------------------


FLOW = {1: {A: sp.I * A}, 2: {A: A**2 * Ac}}


@pytest.mark.parametrize(
    ("call", "phrase"),
    [
        (lambda: cv.changed(FLOW, {1: {B: A}}), "names A_y, no amplitude here: use A_x"),
        (lambda: cv.changed(FLOW, {0: {A: A}}), "order 0"),
        (lambda: cv.changed(FLOW, {True: {A: A}}), "order True"),
        (lambda: cv.changed(FLOW, {1: {A: 0.5 * A}}), "of A_x at order 1 must be an exact"),
        (lambda: cv.changed(FLOW, {1: {A: "A"}}), "must be an exact"),
        (lambda: cv.changed(FLOW, {1: {A: t * A}}), "holds time other than"),
        (lambda: cv.changed(FLOW, {1: {A: sp.conjugate(sp.Symbol("z"))}}), r"conjugate\(z\)"),
        (lambda: cv.changed(FLOW, {1: A}), "order 1 a mapping amplitude"),
        (lambda: cv.changed({}, {}), "mapping order"),
        (lambda: cv.inverse([A]), "mapping order"),  # type: ignore[arg-type]
        (lambda: cv.rescaled(FLOW, 0), "factor of A_x is 0"),
        (lambda: cv.rescaled(FLOW, 0.5), "factor of A_x must be an exact"),
        (lambda: cv.rescaled(FLOW, {B: 1}), "no factor is given for the amplitude A_x"),
        (lambda: cv.rescaled(FLOW, A), "factor of A_x is A_x"),
        (lambda: cv.substituted(FLOW, {A: 1}), "A_x is an amplitude"),
        (lambda: cv.substituted(FLOW, [1]), "mapping symbol -> series"),  # type: ignore[arg-type]
        (lambda: cv.substituted({0: a, 2: a}, {a: {0: X, 1: X}}), "order 1, and order 2 is needed"),
        (lambda: cv.substituted({0: 1 / a, 1: a}, {a: {1: X}}), "no expansion"),
        (lambda: cv.substituted({-1: a}, {a: X}), "order -1"),
        (lambda: cv.reversion({0: a**2}, a, X), "begins with a_x"),
        (lambda: cv.reversion({1: a}, a, X), "begins with 0"),
        (lambda: cv.power({1: a}, 2), "begins at order 0"),
        (lambda: cv.power({0: a}, a), "rational exponent"),
        (lambda: cv.frequency(van_der_pol().expand(1)), "amplitude of .* changes at order 1"),
        (lambda: cv.frequency(pair(alpha * x**3, 0).scale({alpha: 1}).expand(1)), "single one"),
        (
            lambda: cv.frequency(mathieu().expand(1, {Omega: 2 * omega})),
            "amplitude of .* changes at order 1",
        ),
        (lambda: cv.displacement(van_der_pol().expand(2)), "does not turn at the phase 0 at order"),
        (lambda: cv.displacement(mathieu().expand(2)), "motion of .* is excited"),
        (lambda: cv.displacement(duffing().expand(2), sp.pi / 3), "does not turn"),
        (lambda: cv.detuned(mathieu().expand(1), omega, new), "omega is in no relation"),
        (
            lambda: cv.detuned(
                coupled_mathieu().expand(1, {Omega: 2 * omega_1, omega_2: omega_1}), omega_1, new
            ),
            "omega_1 is in several relations",
        ),
        (
            lambda: cv.detuned(mathieu().expand(1, {Omega: 2 * omega}), omega, new, 0),
            "exponent must be a whole number",
        ),
    ],
)
def test_conversions_refuse_by_name(call: Any, phrase: str) -> None:
    with pytest.raises(ConventionError, match=phrase):
        call()


def test_series_are_checked() -> None:
    bad: Sequence[Any] = ([], {}, {"0": a}, {0.5: a}, {0: sp.nan}, {0: None}, None)
    for series in bad:
        with pytest.raises(ConventionError):
            cv.reversion(series, a, X)
