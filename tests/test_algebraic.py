"""Normal forms over radicals, sines and cosines, and exact verdicts on zero."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from mmsgen.algebraic import Algebra
from mmsgen.parameters import Parameter

k, h, w, c, s = sp.symbols("k h w c s", positive=True)
v = sp.Symbol("v", real=True)


def verdict(expr: sp.Expr, *names: Parameter) -> bool | None:
    expr = sp.sympify(expr)
    return Algebra(names, [expr]).vanishes(expr)


def normal(expr: sp.Expr, *names: Parameter) -> sp.Expr:
    algebra = Algebra(names, [expr])
    return algebra.shown(algebra.reduced(expr))


a = sp.acos(k / w)
ZERO = {
    "pythagoras": sp.sin(v) ** 2 + sp.cos(v) ** 2 - 1,
    "of a number": sp.sin(1) ** 2 + sp.cos(1) ** 2 - 1,
    "half angles": sp.cos(v) - 2 * sp.cos(v / 2) ** 2 + 1,
    "third angles": sp.sin(v) - 3 * sp.sin(v / 3) + 4 * sp.sin(v / 3) ** 3,
    "sums": sp.sin(2 * v - k) - 2 * sp.sin(v) * sp.cos(v) * sp.cos(k) + sp.cos(2 * v) * sp.sin(k),
    "quarter turns": sp.sin(v + sp.pi / 4) - (sp.sin(v) + sp.cos(v)) / sp.sqrt(2),
    "tangent": sp.tan(v) / (1 + sp.tan(v) ** 2) - sp.sin(2 * v) / 2,
    "cubic root": h * sp.sqrt(k / h) ** 3 - k * sp.sqrt(k / h),
    "root of a sum": sp.sqrt(k + h) ** 3 - (k + h) * sp.sqrt(h + k),
    "nested": sp.sqrt(k + sp.sqrt(h)) ** 4 - 2 * k * sp.sqrt(h) - k**2 - h,
    "in a denominator": 1 / (sp.sqrt(k) + sp.sqrt(h)) - (sp.sqrt(k) - sp.sqrt(h)) / (k - h),
    "different roots": k ** sp.Rational(2, 3) * sp.sqrt(k) - k ** sp.Rational(7, 6),
    "inverse": k * sp.sin(a) - w * sp.sin(a) * sp.cos(a),
    "twice an inverse": 2 * k * sp.sin(a) - w * sp.sin(2 * a),
    "arc tangent": sp.sin(sp.atan(k / w)) * sp.sqrt(k**2 + w**2) - k,
    "unknown functions": sp.exp(k) ** 2 - sp.exp(2 * k) + sp.tanh(v) - sp.tanh(v),
}
NONZERO = {
    "pythagoras": sp.sin(v) ** 2 + sp.cos(v) ** 2 - 2,
    "an angle and half of it": sp.cos(v) - sp.cos(v / 2),
    "an angle and its sine": sp.sin(v) - v,
    "a radical": sp.sqrt(k + h) - sp.sqrt(k),
    "nested": sp.sqrt(3 + 2 * sp.sqrt(2)) - sp.sqrt(2),
    "inverse": k * sp.sin(2 * a) - w * sp.sin(a) * sp.cos(a),
    "a transcendental number": sp.pi * k - 3 * k,
}


@pytest.mark.parametrize("name", ZERO)
def test_zero_is_recognised(name: str) -> None:
    assert verdict(ZERO[name]) is True


@pytest.mark.parametrize("name", NONZERO)
def test_what_is_not_zero_is_proven_so(name: str) -> None:
    assert verdict(NONZERO[name]) is False


@pytest.mark.parametrize(
    "expr",
    [
        sp.sqrt(3 + 2 * sp.sqrt(2)) - 1 - sp.sqrt(2),  # zero, of dependent radicals
        sp.cos(sp.pi / 7) - sp.cos(2 * sp.pi / 7) + sp.cos(3 * sp.pi / 7) - sp.Rational(1, 2),  # 0
        sp.cos(a / 2) ** 2 - (1 + k / w) / 2 + sp.tanh(k),
        1 / (sp.sqrt(3 + 2 * sp.sqrt(2)) - 1 - sp.sqrt(2)) + sp.exp(k),
    ],
)
def test_what_this_algebra_cannot_tell_is_left_undecided(expr: sp.Expr) -> None:
    assert verdict(expr) is None


def test_names_stand_for_what_they_define() -> None:
    cosine, sine = Parameter(c, definition=sp.cos(v)), Parameter(s, definition=sp.sin(v))
    assert normal(sp.cos(2 * v) * w, sine, cosine) == sp.expand(w * (1 - 2 * s**2))
    assert normal(sp.cos(2 * v) * w, cosine, sine) == sp.expand(w * (2 * c**2 - 1))
    root = Parameter(s, definition=sp.sqrt(1 - c**2))
    assert normal(w * s**4 / (1 - c**2), root) == sp.expand(w * (1 - c**2))
    assert normal(w / sp.sqrt(1 - c**2), root) == sp.cancel(w * s / (1 - c**2))
    length = Parameter(h, definition=sp.sqrt(k / w))
    assert normal(3 * w * h**2 - k, length) == 2 * k
    assert verdict(w * h**3 - k * h, length) is True


def test_a_normal_form_is_unique() -> None:
    """Two ways to write a number come out as one."""
    cosine, sine = Parameter(c, definition=sp.cos(v)), Parameter(s, definition=sp.sin(v))
    left, right = sp.tan(v), (1 - c**2) / (c * s)
    assert normal(left, cosine, sine) == normal(right, cosine, sine) != left


NUMBERS = st.integers(-2, 2)


@settings(max_examples=20)
@given(st.lists(st.tuples(NUMBERS, NUMBERS, NUMBERS, NUMBERS), min_size=1, max_size=2))
def test_verdicts_agree_with_numbers(terms: list[tuple[int, int, int, int]]) -> None:
    """Σ n sin(pv + k) √k^q √(k + h)^r is zero just where the verdict says so."""
    expr = sp.Add(
        *(n * sp.sin(p * v + k) * sp.sqrt(k) ** q * sp.sqrt(k + h) ** r for n, p, q, r in terms)
    )
    found = verdict(expr)
    value = expr.subs({k: sp.Rational(7, 5), h: sp.Rational(3, 11), v: sp.Rational(5, 7)})
    with mpmath.workdps(40):
        # Terms are below 1e4, so what is zero is below 1e-30; independent numbers do not cancel.
        size = abs(mpmath.mpf(sp.N(value, 40)))
    assert found is (size < mpmath.mpf(10) ** -30)
    assert verdict(expr - sp.expand(sp.expand_trig(expr))) is True
