"""What is read off the equations, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from floquet_systems import TIME, linear, mathieu, rotor

from mmsgen import floquet
from mmsgen.errors import FloquetError
from mmsgen.floquet.period import find_periodicity

OMEGA, NU = sp.symbols("Omega nu", positive=True)


@pytest.mark.parametrize(
    ("expression", "base"),
    [
        (sp.cos(OMEGA * TIME), OMEGA),
        (sp.cos(OMEGA * TIME + NU) + sp.sin(2 * OMEGA * TIME / 3), OMEGA / 3),
        (sp.cos(2 * OMEGA * TIME) * sp.sin(3 * OMEGA * TIME), OMEGA),
        (sp.cos(4 * OMEGA * TIME) * sp.sin(6 * OMEGA * TIME), 2 * OMEGA),
        (sp.exp(sp.I * OMEGA * TIME) + sp.exp(-sp.I * OMEGA * TIME), OMEGA),
        (sp.cos((OMEGA + NU) * TIME) + sp.cos((2 * OMEGA + 2 * NU) * TIME), OMEGA + NU),
        (sp.exp(sp.cos(OMEGA * TIME)) / (2 + sp.sin(OMEGA * TIME / 2)), OMEGA / 2),
        (sp.cos(0.5 * TIME) + sp.sin(1.5 * TIME), sp.Rational(1, 2)),
        (sp.cos(-3 * TIME), 3),
    ],
)
def test_base_frequency(expression: sp.Expr, base: sp.Expr) -> None:
    found = find_periodicity([expression], TIME)
    assert found is not None
    assert sp.expand(found.base - base) == 0
    for argument, ratio, phase in found.arguments:
        factor = sp.I if argument.has(sp.I) else 1
        assert ratio.is_Integer
        assert sp.expand(factor * (ratio * found.base * TIME + phase) - argument) == 0


def test_no_time() -> None:
    assert find_periodicity([OMEGA, sp.sin(NU)], TIME) is None


@pytest.mark.parametrize(
    ("expression", "message"),
    [
        (sp.cos(OMEGA * TIME) + sp.cos(NU * TIME), "Omega, nu.*pass period="),
        (sp.cos(TIME) + sp.cos(sp.sqrt(2) * TIME), r"1, sqrt\(2\)"),
        (TIME * sp.cos(OMEGA * TIME), "outside"),
        (sp.cos(OMEGA * TIME**2), "outside"),
        (sp.exp(-OMEGA * TIME), "not periodic"),
        (sp.exp((sp.I - 1) * TIME), "not periodic"),
        (sp.Function("g")(TIME), "unknown function"),
    ],
)
def test_no_common_period(expression: sp.Expr, message: str) -> None:
    with pytest.raises(FloquetError, match=message):
        find_periodicity([expression], TIME)


def test_exponentials_give_the_same_as_cosines() -> None:
    wave = (sp.exp(2 * sp.I * TIME) + sp.exp(-2 * sp.I * TIME)) / 2
    other = floquet.growth_rate(linear(1, 0, 1 - sp.Rational(2, 5) * wave), {})
    same = floquet.growth_rate(mathieu(), {"a": 1, "q": 0.2, "c": 0})
    assert abs(other.value - same.value) <= other.error + same.error


def test_period_given() -> None:
    values = {"a": [1.0, 2.0], "q": 0.2, "c": 0}
    found = floquet.multipliers(mathieu(), values)
    np.testing.assert_allclose(found.period, np.pi, rtol=1e-15)
    for period in (np.pi, [np.pi, np.pi], sp.pi):
        given = floquet.multipliers(mathieu(), values, period=period)
        gap = np.abs(given.value - found.value).max()
        assert gap <= given.error.max() + found.error.max()
    double = floquet.growth_rate(mathieu(), values, period=2 * np.pi)
    single = floquet.growth_rate(mathieu(), values)
    assert np.all(np.abs(double.value - single.value) <= double.error + single.error)
    with pytest.raises(FloquetError, match="do not repeat"):
        floquet.growth_rate(mathieu(), values, period=3.0)
    with pytest.raises(FloquetError, match="positive"):
        floquet.growth_rate(mathieu(), values, period=-1.0)


def test_incommensurate_symbols_with_commensurate_values() -> None:
    system = linear(1, 0, 1 + (sp.cos(OMEGA * TIME) + sp.cos(NU * TIME)) / 10)
    with pytest.raises(FloquetError, match="pass period="):
        floquet.growth_rate(system, {"Omega": 2.0, "nu": 1.0})
    result = floquet.growth_rate(system, {"Omega": 2.0, "nu": 1.0}, period=2 * np.pi)
    assert result.verdict == "unstable"


def test_definitions_are_used_unless_the_value_is_given() -> None:
    b, r, phi = sp.symbols("b r phi", positive=True)
    definitions = {phi: sp.sqrt(b**2 + r**2 * OMEGA**2)}
    system = linear(1, 0, phi**2 * (1 + sp.cos(OMEGA * TIME) / 5), definitions)
    implied = floquet.growth_rate(system, {b: 3.0, r: 0.2, OMEGA: [5.0, 6.0]})
    value = np.sqrt(9 + 0.04 * np.array([25.0, 36.0]))
    given = floquet.growth_rate(system, {"phi": value, "Omega": [5.0, 6.0]})
    assert np.all(np.abs(implied.value - given.value) <= implied.error + given.error)
    # A given value has precedence over the definition.
    fixed = floquet.growth_rate(system, {"phi": 3.0, "b": 1.0, "r": 9.0, "Omega": 6.0})
    expected = floquet.growth_rate(system, {"phi": 3.0, "Omega": 6.0})
    assert fixed.value == expected.value


def test_circular_definitions() -> None:
    b, phi = sp.symbols("b phi", positive=True)
    system = linear(1, 0, phi + sp.cos(TIME), {phi: b, b: phi})
    with pytest.raises(FloquetError, match="circle"):
        floquet.growth_rate(system, {})


GOOD = {"a": 1.0, "q": 0.2, "c": 0.0}


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"z": 1.0}, "unknown parameter 'z'"),
        ({"a": float("nan")}, "'a' contains NaN"),
        ({"a": [1.0, float("inf")]}, "'a' contains NaN or infinity"),
        ({"a": 1j}, "'a' is not a real number"),
        ({"a": "one"}, "'a' is not a real number"),
        ({"a": [1, 2, 3], "q": [1, 2]}, r"broadcast.*a: \(3,\)"),
        ({sp.Symbol("a", real=True): 2.0}, "'a' is given twice"),
    ],
)
def test_bad_values(change: dict[object, object], message: str) -> None:
    with pytest.raises(FloquetError, match=message):
        floquet.growth_rate(mathieu(), {**GOOD, **change})


def test_missing_negative_and_zero_values() -> None:
    with pytest.raises(FloquetError, match="no value for a, q"):
        floquet.growth_rate(mathieu(), {"c": 0.0})
    system = linear(1, 0, 1 + sp.cos(OMEGA * TIME) / 5)
    with pytest.raises(FloquetError, match="'Omega' is declared positive"):
        floquet.growth_rate(system, {"Omega": -1.0})
    with pytest.raises(FloquetError, match="must not be zero"):
        floquet.growth_rate(system, {"Omega": [1.0, 0.0]})


def test_singular_mass() -> None:
    m = sp.Symbol("m", real=True)
    mass = sp.Matrix([[1, m], [m, 1]])
    system = linear(mass, sp.zeros(2), sp.eye(2) * (2 + sp.cos(TIME)))
    with pytest.raises(FloquetError, match="singular"):
        floquet.growth_rate(system, {"m": [0.0, 1.0]})
    with pytest.raises(FloquetError, match="row 2 is zero"):
        floquet.growth_rate(linear(sp.diag(1, 0), sp.zeros(2), sp.eye(2)), {})
    # Singular at isolated times only: the accelerations are infinite there, and nothing is known.
    crossing = linear(sp.cos(TIME) + sp.Rational(1, 3), 0, 1)
    with pytest.raises(FloquetError, match="singular"):
        floquet.growth_rate(crossing, {}, max_steps=64)


def test_bad_options() -> None:
    for option in ({"tolerance": 0.0}, {"max_steps": 0}, {"workers": 0}, {"threshold": np.nan}):
        with pytest.raises(FloquetError, match=next(iter(option))):
            floquet.growth_rate(mathieu(), GOOD, **option)
    with pytest.raises(FloquetError, match="ascending"):
        floquet.boundary(mathieu(), {"q": 1, "c": 0}, "a", (2, 1))
    with pytest.raises(FloquetError, match="scalars"):
        floquet.boundary(mathieu(), {"q": [1, 2], "c": 0}, "a", (1, 2))
    with pytest.raises(FloquetError, match="take it out"):
        floquet.boundary(mathieu(), GOOD, "a", (1, 2))
    with pytest.raises(FloquetError, match="1-D"):
        floquet.chart(mathieu(), {"c": 0}, {"a": 1.0}, {"q": [1.0]})
    with pytest.raises(FloquetError, match="given twice"):
        floquet.chart(mathieu(), {"c": 0, "a": 1}, {"a": [1.0]}, {"q": [1.0]})


def test_equations_that_are_not_linearised() -> None:
    q = sp.Function("q")(TIME)
    with pytest.raises(FloquetError, match="linearise"):
        floquet.growth_rate(linear(1, 0, 1 + q**2), {})


def test_two_symbols_of_one_name() -> None:
    twin = sp.Symbol("Omega", real=True)
    with pytest.raises(FloquetError, match="two different symbols"):
        floquet.growth_rate(linear(1, 0, OMEGA + twin + sp.cos(TIME)), {"Omega": 1.0})


def test_rotor_coefficients_share_their_time_functions() -> None:
    from mmsgen.floquet.system import compile_system

    system = rotor()
    given = frozenset(p.name for p in system.parameters)
    compiled = compile_system(system, given, None, False)
    assert compiled.base == "Omega" and compiled.harmonic == 1
