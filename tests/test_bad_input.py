"""Whatever goes in, nothing but an `MmsgenError` comes out, and it has something to say."""

from __future__ import annotations

import contextlib

import numpy as np
import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from systems import (
    Omega,
    Omega_2,
    alpha,
    d,
    f,
    kappa,
    mathieu,
    omega,
    omega_1,
    omega_2,
    oscillator,
    p,
    pair,
    t,
    theta,
    x,
    y,
)

from mmsgen.errors import ExpansionError, MmsgenError

LEAVES = [x, y, d(x), d(y), d(x, 2), alpha, kappa, p, theta, omega_1, Omega * t, t, sp.pi]
LEAVES += [sp.Integer(n) for n in (-2, -1, 0, 1, 2, 3)] + [sp.Rational(1, 2), sp.Rational(-2, 3)]
FUNCTIONS = [sp.sin, sp.cos, sp.exp, sp.log, sp.sqrt, sp.tan, sp.Abs, sp.sign, sp.atan, sp.acos]


@st.composite
def expressions(draw: st.DrawFn, depth: int = 3) -> sp.Expr:
    """Any expression, sensible or not."""
    if depth == 0 or draw(st.integers(0, 3)) == 0:
        return draw(st.sampled_from(LEAVES))
    kind = draw(st.integers(0, 4))
    first = draw(expressions(depth - 1))
    if kind == 0:
        return first + draw(expressions(depth - 1))
    if kind in (1, 2):
        return first * draw(expressions(depth - 1))
    if kind == 3:
        return draw(st.sampled_from(FUNCTIONS))(first)
    return first ** draw(st.sampled_from([2, 3, -1, sp.Rational(1, 2), sp.Rational(-1, 2)]))


@contextlib.contextmanager
def nothing_else() -> object:
    """Let only errors of the package pass, with words in them."""
    try:
        yield
    except MmsgenError as error:
        assert len(str(error)) > 25, error


@settings(suppress_health_check=list(HealthCheck))
@given(expressions(), expressions(), st.sampled_from([0, 1, sp.Rational(1, 2)]))
def test_any_equations(first: sp.Expr, second: sp.Expr, amplitude: sp.Expr) -> None:
    with nothing_else():
        eom = pair(alpha * first, alpha * second)
        small = {s: 1 for s in (alpha, kappa, p) if s in {q.symbol for q in eom.parameters}}
        scaled = eom.scale(small, amplitude=amplitude)
        scaled.expand(1)
        for r in scaled.resonances(1):
            with nothing_else():
                flow = scaled.expand(1, r.mapping).slow_flow
                assert set(flow.complex) == set(flow.case.amplitudes)


SIDES = [
    Omega,
    Omega_2,
    omega,
    omega_1,
    x,
    alpha,
    sp.Integer(0),
    sp.Integer(2),
    sp.I,
    sp.nan,
    sp.oo,
]
SIDES += [2 * omega, Omega - omega, -omega, omega * Omega, sp.sqrt(omega), sp.Float(1.5), "omega"]
SIDES += [None, [], 2, 2.0, 1j, omega / 2, omega + 1, sp.Eq(omega, Omega), float("nan"), (omega,)]


@given(st.lists(st.tuples(st.sampled_from(SIDES), st.sampled_from(SIDES)), max_size=3))
def test_any_relations(pairs: list) -> None:
    relations = {a: b for a, b in pairs if not isinstance(a, list)}
    with nothing_else():
        mathieu().expand(1, relations)


ANYTHING = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-3, 3),
    st.floats(),
    st.text(max_size=5),
    st.sampled_from([alpha, x, omega, sp.oo, sp.Rational(1, 2), [], {}, (), object(), "alpha"]),
)


@given(st.one_of(ANYTHING, st.tuples(ANYTHING, ANYTHING)), ANYTHING, ANYTHING)
def test_any_orders(order: object, amplitude: object, expansion_order: object) -> None:
    eom = oscillator(alpha * x**3 + f * sp.cos(Omega * t))
    for orders in ({alpha: order}, {"alpha": 1, "f": order}, order):
        with nothing_else():
            scaled = eom.scale(orders, amplitude=amplitude)
            if not isinstance(expansion_order, int) or expansion_order <= 2:
                scaled.expand(expansion_order)


VALUES = st.one_of(
    ANYTHING,
    st.lists(st.floats(-2, 2), max_size=3),
    st.sampled_from([1j, [[1.0], [2.0]], "1.0", [None], [1, [2]]]),
)


@given(st.dictionaries(st.sampled_from(["alpha", "omega", "sigma", "Omega", "beta", 3]), VALUES))
def test_any_values(values: dict) -> None:
    """Numbers for growth rates and edges: ragged lists, text, NaN, unknown names, shapes."""
    flow = mathieu().expand(1, {Omega: 2 * omega}).slow_flow
    for function in (flow.growth_rate, flow.boundaries, mathieu().resonances(1).rank):
        with nothing_else():
            function(values)


def test_a_value_for_each_parameter_that_is_needed() -> None:
    """The message names what is missing."""
    flow = pair(2 * alpha * sp.cos(Omega * t) * y, alpha * sp.cos(Omega * t) * x)
    flow = flow.scale({alpha: 1}).expand(1, {Omega: omega_1 + omega_2}).slow_flow
    for given_ in ({}, {"alpha": 0.1}, {"alpha": 0.1, "omega_1": 1.0}):
        try:
            flow.growth_rate(given_)
        except MmsgenError as error:
            assert "omega_2" in str(error) and "no value is given" in str(error)
        else:
            raise AssertionError("a missing value passed")


def test_an_order_for_which_nothing_is_left() -> None:
    scaled = oscillator(alpha * x**3).scale({alpha: 2})
    with pytest.raises(ExpansionError, match=r"order from 1 to 1 in ε.*ask for a higher order"):
        scaled.expand(1)
    assert any(scaled.expand(2).solvability[2].values())


def test_masked_values_are_named() -> None:
    flow = mathieu().expand(1, {Omega: 2 * omega}).slow_flow
    masked = np.ma.masked_array([0.1, 0.2], [False, True])
    with pytest.raises(MmsgenError, match="sigma has masked values"):
        flow.growth_rate({"sigma": masked})
