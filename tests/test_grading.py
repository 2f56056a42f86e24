"""Coefficients as power series in ε, denominators included, against SymPy's series."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp

from mmsgen.errors import ScalingError
from mmsgen.expressions import FieldSymbols
from mmsgen.field import Coefficient, ParameterField
from mmsgen.grading import Detuned, Grading

NAMES = ("p", "q", "u", "v", "W")
p, q, u, v, W, s = sp.symbols("p q u v W s", real=True)
e = sp.Symbol("e", positive=True)
ORDERS = {"p": 1, "q": 2}
SIGMA = {"s": Fraction(1)}
RELATIONS = {
    "none": {},
    "sum": {"W": Detuned({"u": Fraction(1), "v": Fraction(1)}, SIGMA)},
    "number": {"W": Detuned({"1": Fraction(3, 2)}, {"s": Fraction(1, 2)})},
}


def coefficient(field: ParameterField, expression: sp.Expr) -> Coefficient:
    """A rational function as an element of the field."""
    top, bottom = sp.fraction(sp.together(expression))

    def polynomial(part: sp.Expr) -> Coefficient:
        symbols = [sp.Symbol(n, real=True) for n in NAMES]
        total = field.zero
        for monomial, c in sp.Poly(part, *symbols).terms():
            term = field.rational(Fraction(int(c.p), int(c.q)))
            for name, k in zip(NAMES, monomial, strict=True):
                term = term * field.generator(name) ** k
            total = total + term
        return total

    return polynomial(top) * polynomial(bottom).inverse()


EXPRESSIONS = [
    u * (1 + p) ** 3,
    1 / (u + p),
    1 / (u + p + q - p**3),
    p / (u * v + q + p**2 * v) ** 2,
    (p + q) / (p * u + q * v),
    1 / (W + v),
    (W - u) / (W**2 - u**2) / (W + p),
    (W**2 + p) / (W * v - p * W**2 + q),
    p * q / (p**2 * (W + u) + q * p) + W**3,
]


@pytest.mark.parametrize("relation", RELATIONS)
@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_against_sympy(expression: sp.Expr, relation: str) -> None:
    """p → εp, q → ε²q, W → its resonant value + εσ: coefficients of ε^-1 … ε^4 at exact points.

    Two points in rational numbers: rational functions of degree 10 at most that differ agree at
    both with no more than chance.
    """
    field = ParameterField(NAMES)
    detuned = RELATIONS[relation]
    grading = Grading(field, ORDERS, detuned, ["s"] if detuned else [], 4)
    graded = grading(coefficient(field, expression))
    show = FieldSymbols(grading.field, {n: sp.Symbol(n, real=True) for n in (*NAMES, "s")})
    resonant = {"none": W, "sum": u + v + e * s, "number": sp.Rational(3, 2) + e * s / 2}
    scaled = expression.subs(W, resonant[relation]).subs({p: e * p, q: e**2 * q})
    for shift in (0, 5):
        symbols = (p, q, u, v, W, s)
        point = {a: sp.Rational(7 + 3 * i + shift, 11 + i) for i, a in enumerate(symbols)}
        top, bottom = (sp.Poly(part, e) for part in sp.fraction(sp.together(scaled.subs(point))))
        low = min(m for (m,), _ in bottom.terms())
        # S·bottom = top through ε^4 determines S, its lowest order being −low.
        found = sum(show(c).subs(point) * e ** (k + low) for k, c in graded.items())
        gap = sp.Poly(sp.expand(found * bottom.as_expr() / e**low) - top.as_expr(), e)
        assert all(c == 0 for (m,), c in gap.terms() if m <= 4 + low)
    assert all(graded.values())


def test_negative_orders_are_kept() -> None:
    field = ParameterField(NAMES)
    graded = Grading(field, ORDERS, order=3)(coefficient(field, u / (q * v + p * q)))
    assert sorted(graded) == [-2, -1, 0, 1, 2, 3]


def test_a_divisor_that_is_small_on_the_resonance() -> None:
    """1/(W − u − v) is 1/(εσ) there, and undefined where the relation holds exactly."""
    field = ParameterField(NAMES)
    c = coefficient(field, 1 / (W - u - v))
    ((order, value),) = Grading(field, ORDERS, RELATIONS["sum"], ["s"], 2)(c).items()
    assert order == -1 and repr(value).count("/") == 1
    exact = {"W": Detuned({"u": Fraction(1), "v": Fraction(1)}, {})}
    with pytest.raises(ScalingError, match="vanishes on the resonance"):
        Grading(field, ORDERS, exact, [], 2)(c)


def test_no_parameter_can_be_the_bookkeeping_one() -> None:
    """The generator of ε has no name that a parameter can have."""
    field = ParameterField(("ε", "epsilon"))
    grading = Grading(field, {"ε": 1, "epsilon": 2}, order=3)
    assert len(set(grading.field.names)) == 3
    assert not grading.field.names[-1].isidentifier()
    assert sorted(grading(field.generator("ε") * field.generator("epsilon"))) == [3]
