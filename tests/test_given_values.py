"""Values as users write them: every kind of real number is taken, all else is refused in words."""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from functools import cache
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from systems import (
    Omega,
    alpha,
    coupled_mathieu,
    d,
    equations,
    k,
    mathieu,
    mu,
    omega,
    omega_1,
    omega_2,
    t,
    x,
)

import mmsgen as mg
from mmsgen import floquet

VALUES = {"omega": 1.0, "alpha": 0.1, "mu": 0.02, "k": 0.05, "sigma": 0.1}
SWING = {"omega": 1.0, "alpha": 0.1, "sigma": 0.0}
PAIR = {"omega_1": 1.0, "omega_2": 2.5, "f_12": 0.2, "f_21": 0.3, "sigma": 0.1}
EXACT = [
    sp.Rational(1, 20),
    sp.Float("0.05"),
    sp.sqrt(2) / 28,
    sp.pi / 60,
    sp.S.Half,
    sp.Integer(1),
    Fraction(1, 20),
    Decimal("0.05"),
    mpmath.mpf("0.05"),
    np.float32(0.05),
    1,
]


@cache
def forced() -> mg.EquationsOfMotion:
    left = d(x, 2) + omega**2 * x + 2 * mu * d(x) + alpha * x**3 - k * sp.cos(Omega * t)
    return equations([left], [x])


@cache
def duffing() -> Any:
    return forced().scale({alpha: 1, mu: 1, k: 1}).expand(1, {Omega: omega})


@cache
def swing() -> Any:
    return mathieu().expand(1, {Omega: 2 * omega})


@cache
def pair() -> Any:
    return coupled_mathieu().expand(1, {Omega: omega_1 + omega_2})


@cache
def found() -> Any:
    return duffing().slow_flow.equilibria(VALUES)


@cache
def response() -> Any:
    return duffing().slow_flow.frequency_response(VALUES | {"sigma": np.linspace(-0.1, 0.1, 5)})


CALLS: dict[str, Callable[[Any], Any]] = {
    "numbers": lambda v: duffing().numbers(v),
    "scaled": lambda v: duffing().weak.scaled.numbers(v),
    "equilibria": lambda v: duffing().slow_flow.equilibria(v),
    "certified": lambda v: duffing().slow_flow.certified(v, found()),
    "frequency_response": lambda v: duffing().slow_flow.frequency_response(v, over="sigma"),
    "backbone": lambda v: duffing().slow_flow.backbone(v, 0.5) if v is not None else refuse(),
    "response": lambda v: duffing().slow_flow.response(v, [0.1], 1.0),
    "initial_amplitudes": lambda v: duffing().slow_flow.initial_amplitudes(v, [0.1], [0.0]),
    "nonlinear evolution": lambda v: duffing().slow_flow.evolution(v, [0.1], [0.0, 1.0]),
    "limit_cycle": lambda v: duffing().slow_flow.limit_cycle(v, [0.1]),
    "growth_rate": lambda v: swing().slow_flow.growth_rate(v),
    "boundaries": lambda v: swing().slow_flow.boundaries(v),
    "zones": lambda v: swing().slow_flow.zones(v),
    "stability boundaries": lambda v: swing().slow_flow.stability.boundaries(v),
    "evolution": lambda v: pair().slow_flow.evolution(v, [0.1, 0.2], 1.0),
    "beating": lambda v: pair().slow_flow.beating(v, [0.1, 0.2]),
    "rank": lambda v: mathieu().resonances(1).rank(v),
    "orbit_near": lambda v: mg.orbit_near(duffing(), v, [0.1]),
    "orbits_along": lambda v: mg.orbits_along(duffing(), v, response()),
    "certify": lambda v: mg.certify(swing(), v),
    "time_integration": lambda v: mg.time_integration(forced(), v, [0.1], [0.0], [0.0, 1.0]),
    "orbits.problem": lambda v: mg.orbits.problem(forced(), v),
    "floquet.growth_rate": lambda v: floquet.growth_rate(mathieu().eom, v),
    "floquet.exponents": lambda v: floquet.exponents(mathieu().eom, v),
    "floquet.boundary": lambda v: floquet.boundary(mathieu().eom, v, Omega, (1.5, 2.5)),
    "floquet.chart": lambda v: floquet.chart(
        mathieu().eom, v, x=(Omega, [1.5, 2.5]), y=(alpha, [0.1])
    ),
}


def refuse() -> None:
    """Without values `backbone` is a formula."""
    raise mg.MmsgenError("no values: a formula")


BAD = [None, [1, 2], "omega", 3.0, {"zz": 1}, {5: 1}, {None: 1}, {"omega": "a"}, {"omega": None}]
BAD += [{omega: 1j}, {"omega": sp.I}, {"omega": omega / 2}, {"omega": sp.nan}, {"omega": sp.zoo}]
BAD += [{"omega": [[1], [1, 2]]}, {omega: 1.0, "omega": 1.0}, {"omega": sp.oo}, {"omega": {1.0}}]
BAD += [{"omega": True}, {"omega": [True]}, {"omega": [sp.true, 1]}, {"omega": 10**400}, {(): 1}]


@pytest.mark.parametrize("name", CALLS)
def test_nothing_but_an_error_with_words(name: str) -> None:
    for values in BAD:
        with pytest.raises(mg.MmsgenError) as caught:
            CALLS[name](values)
        assert len(str(caught.value)) > 15, values


@pytest.mark.parametrize("value", EXACT, ids=str)
def test_exact_numbers_are_numbers(value: Any) -> None:
    number = float(value)
    flow = duffing().slow_flow
    one, other = flow.equilibria(VALUES | {"k": value}), flow.equilibria(VALUES | {"k": number})
    np.testing.assert_array_equal(one.amplitudes, other.amplitudes)
    one = flow.equilibria(VALUES | {"k": [value, 0.1]})
    other = flow.equilibria(VALUES | {"k": [number, 0.1]})
    np.testing.assert_array_equal(one.amplitudes, other.amplitudes)
    curve = VALUES | {"sigma": np.linspace(-0.1, 0.1, 5)}
    (one,) = flow.frequency_response(curve | {"k": value}).branches
    (other,) = flow.frequency_response(curve | {"k": number}).branches
    np.testing.assert_array_equal(one.amplitudes, other.amplitudes)
    assert swing().slow_flow.growth_rate(SWING | {"alpha": value}) == (
        swing().slow_flow.growth_rate(SWING | {"alpha": number})
    )
    exact = {omega: 1, alpha: value, Omega: 2}
    plain = {omega: 1, alpha: number, Omega: 2}
    assert floquet.growth_rate(mathieu().eom, exact).value == (
        floquet.growth_rate(mathieu().eom, plain).value
    )
    driven = {"omega": 1, "alpha": 0.1, "mu": 0.02, "Omega": 1.1}
    assert mg.orbits.problem(forced(), driven | {"k": value}).values["k"] == number
    q, _ = mg.time_integration(forced(), driven | {"k": value}, [0.1], [0.0], [0.0, 1.0])
    p, _ = mg.time_integration(forced(), driven | {"k": number}, [0.1], [0.0], [0.0, 1.0])
    np.testing.assert_array_equal(q, p)


def test_a_curve_along_exact_numbers() -> None:
    flow = duffing().slow_flow
    exact = [sp.Rational(j, 20) for j in range(5)]
    (one,) = flow.frequency_response(VALUES | {"sigma": exact}).branches
    (other,) = flow.frequency_response(VALUES | {"sigma": list(map(float, exact))}).branches
    np.testing.assert_array_equal(one.parameter, other.parameter)


def test_messages_say_what_is_expected() -> None:
    flow = duffing().slow_flow
    with pytest.raises(mg.MmsgenError, match=r"values must be a mapping, .*, got NoneType"):
        flow.equilibria(None)
    with pytest.raises(mg.MmsgenError, match="k must be a number, got the expression k: put"):
        flow.equilibria(VALUES | {"k": k})
    with pytest.raises(mg.MmsgenError, match="amplitudes must be finite"):
        flow.limit_cycle(VALUES, [np.nan])
    with pytest.raises(mg.MmsgenError, match="amplitudes must be finite"):
        flow.limit_cycle(VALUES, ["a"])
    with pytest.raises(mg.MmsgenError, match="the time must be a positive number"):
        flow.limit_cycle(VALUES, [0.1], time=np.nan)
    with pytest.raises(mg.MmsgenError, match="amplitudes must be finite"):
        mg.orbit_near(duffing(), VALUES, [None])
    with pytest.raises(mg.MmsgenError, match="k must be one number here"):
        mg.orbit_near(duffing(), VALUES | {"k": [0.1, 0.2]}, [0.1])
