"""Nothing of the order asked for is dropped, also with small parameters in denominators."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp
from systems import alpha, omega, oscillator, p, pair, same, x, y

from mmsgen.errors import ScalingError
from mmsgen.field import ParameterField
from mmsgen.truncation import valuation


def series(function: sp.Expr, last: int) -> sp.Expr:
    """The Taylor polynomial of a function of x, so that it has nothing to be truncated."""
    v = sp.Symbol("v")
    return sp.series(function.subs(x, v), v, 0, last + 1).removeO().subs(v, x)


@pytest.mark.parametrize(
    ("function", "orders", "amplitude"),
    [
        (sp.sin(x) - x, {}, sp.Rational(1, 2)),
        ((sp.sin(x) - x) / p, {p: 1}, 1),
        ((sp.sin(x) - x + x**3 / 6) / p**2, {p: 1}, 1),
        (p * sp.sin(x / p) - x, {p: 1}, 2),
        (alpha * p**4 / (p + x) - alpha * p**3, {p: 1}, 2),
        (alpha * x * sp.sqrt(p**2 + x**2) / p - alpha * x, {p: 1}, 2),
        (sp.tan(x / (1 + p)) - x / (1 + p), {p: 1}, 1),
    ],
    ids=str,
)
def test_orders_are_complete(function: sp.Expr, orders: dict, amplitude: sp.Expr) -> None:
    """A function and its Taylor polynomial of a high degree have one expansion."""
    whole = oscillator(function).scale(orders, amplitude=amplitude).expand(order=3)
    polynomial = oscillator(series(function, 12)).scale(orders, amplitude=amplitude)
    reference = polynomial.expand(order=3)
    assert any(e for flow in whole.solvability.values() for e in flow.values())
    for q in (1, 2, 3):
        for a, e in whole.solvability[q].items():
            assert same(e, reference.solvability[q][a])


def test_the_fifth_power_counts_when_it_is_divided_by_a_small_parameter() -> None:
    """(sin x − x)/p with x and p of order ε: x⁵/(120 p) is of order ε³ beside x'' of order 0.

    By hand: x⁵ has the fundamental part 10A³Ā²e^{iωt}, so that D3A holds i·10/(120·2ωp) A³Ā².
    """
    case = oscillator((sp.sin(x) - x) / p).scale({p: 1}, amplitude=1).expand(order=3)
    ((a, e),) = case.solvability[3].items()
    quintic = sp.expand(e).coeff(1 / p).coeff(a, 3)
    assert same(quintic, sp.I * sp.conjugate(a) ** 2 / (24 * omega))


@pytest.mark.parametrize(
    ("function", "offender"),
    [
        (alpha * p**4 / (p + x) - alpha * p**3, r"1/\(p \+ x\(t\)\)"),
        (alpha * p**3 * sp.sin(x / p), r"sin\(x\(t\)/p\)"),
        (alpha * p**3 * sp.sqrt(p**2 + x), r"sqrt\(p\*\*2 \+ x\(t\)\)"),
    ],
    ids=str,
)
def test_a_small_denominator_without_an_expansion(function: sp.Expr, offender: str) -> None:
    """x and p of one order: all powers of x/p are of order 0."""
    with pytest.raises(ScalingError, match=offender + ".*small parameter in a denominator"):
        oscillator(function).scale({p: 1, alpha: 1}, amplitude=1)


def test_amplitudes_of_their_own() -> None:
    """x of order 2, y of order 1: y² beside x'' is of order 0, y³ of order 1."""
    with pytest.raises(ScalingError, match="nonlinear"):
        pair(y**2, alpha * x).scale({alpha: 1}, amplitude={x: 2, y: 1}).expand(order=1)
    scaled = pair(y**3, x * y).scale({}, amplitude={x: 2, y: 1})
    in_x, in_y = scaled.weak(3).forces
    assert {factors: list(orders) for factors, orders in in_x.items()} == {(1, 1, 1): [1]}
    assert {factors: list(orders) for factors, orders in in_y.items()} == {(0, 1): [2]}


def test_valuations() -> None:
    field = ParameterField(("u", "v"))
    u, v = field.generator("u"), field.generator("v")
    orders = {"u": 1, "v": 3}
    assert valuation(u, orders) == 1
    assert valuation(u + v, orders) == 1
    assert valuation((u + v) * v.inverse(), orders) == -2
    assert valuation((u + v).inverse().scale(Fraction(1, 2)), orders) == -1
    assert valuation(field.one, orders) == 0
