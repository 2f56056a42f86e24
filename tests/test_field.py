"""Coefficients: a field with a canonical form, against exact rational points and SymPy."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from flint import fmpq
from hypothesis import assume, given
from hypothesis import strategies as st

from mmsgen.cyclotomic import gauss_sum
from mmsgen.expressions import FieldSymbols
from mmsgen.field import Coefficient, ParameterField, sign, split_generator
from mmsgen.partial_fractions import partial_fractions

NAMES = ("x", "y", "z")
ORDERS = (4, 8, 12, 20, 28)
POINT = {"x": Fraction(7, 11), "y": Fraction(-13, 5), "z": Fraction(17, 3)}
"""No divisor drawn below vanishes here: 7/11, −13/5 and 17/3 have coprime denominators, and the
forms have coefficients of at most 3."""

Build = Callable[[ParameterField], Coefficient]


def atom(draw: st.DrawFn, field: ParameterField) -> Coefficient:
    """A monomial with a rational factor and a root of unity."""
    number = Fraction(draw(st.integers(-6, 6)), draw(st.integers(1, 5)))
    c = field.rational(number)
    for name in NAMES:
        c = c * field.generator(name) ** draw(st.integers(0, 2))
    return field.rotate(c, draw(st.integers(0, field.roots.n - 1)))


@st.composite
def coefficients(draw: st.DrawFn, count: int) -> list[Coefficient]:
    """Several random elements of one field."""
    field = ParameterField(NAMES, draw(st.sampled_from(ORDERS)))
    result = []
    for _ in range(count):
        c = field.sum(atom(draw, field) for _ in range(draw(st.integers(0, 3))))
        for _ in range(draw(st.integers(0, 2))):
            form = {n: Fraction(draw(st.integers(-3, 3))) for n in NAMES}
            p = field.linear(form, draw(st.integers(1, 3)))
            if p:
                c = c * field.reciprocal(p)
        result.append(c)
    return result


def at_point(c: Coefficient) -> dict[int, Fraction]:
    """The value at `POINT`: power of ζ in the basis → rational number, exactly."""
    field = c.field
    arguments = [fmpq(POINT[n].numerator, POINT[n].denominator) for n in field.names]

    def number(p: object) -> Fraction:
        q = p(*arguments)
        return Fraction(int(q.p), int(q.q))

    below = Fraction(1)
    for m, e in c.den.items():
        below *= number(field.divisors[m]) ** e
    parts = {k: number(p) / below for k, p in c.num.items()}
    return {k: v for k, v in parts.items() if v}


def is_canonical(c: Coefficient) -> bool:
    """No divisor divides the whole numerator, and nothing is stored that is zero."""
    again = c.field.cancel(Coefficient(c.field, dict(c.num), dict(c.den)))
    return again == c and all(c.num.values()) and all(e > 0 for e in c.den.values())


@given(coefficients(3))
def test_the_axioms_of_a_field(abc: list[Coefficient]) -> None:
    a, b, c = abc
    field = a.field
    assert a + b == b + a
    assert (a + b) + c == a + (b + c)
    assert a * b == b * a
    assert (a * b) * c == a * (b * c)
    assert a * (b + c) == a * b + a * c
    assert a + field.zero == a
    assert a * field.one == a
    assert not (a - a).num
    assert -(-a) == a
    assert all(is_canonical(v) for v in (a + b, a * b, a * (b + c), a - b))


@given(coefficients(1), st.sampled_from(NAMES))
def test_reciprocals(one: list[Coefficient], name: str) -> None:
    """Of real elements in every field, and of a complex one over the Gaussian rationals.

    The norm of an element in several parameters has degree φ(n) in each: it is kept small here.
    """
    (a,) = one
    field = a.field
    real = a * a.conjugate() if field.roots.n == 4 else field.polynomial(sum(a.num.values()))
    complex_ = field.generator(name) + field.rotate(field.rational(2), 1)
    for c in (real, complex_, a if field.roots.n == 4 else complex_):
        if c:
            assert c * c.inverse() == field.one
            assert (c**-2) * c**2 == field.one
            assert c.inverse().inverse() == c


@given(coefficients(2))
def test_equal_exactly_when_the_difference_is_zero(ab: list[Coefficient]) -> None:
    """a·b written in two ways has one form; two forms that differ have a non-zero difference."""
    a, b = ab
    assert (a == b) == (not (a - b).num)
    detour = (a + b) * (a - b) + b * b
    assert detour == a * a
    assert detour.den == (a * a).den


@given(coefficients(2))
def test_values_at_a_rational_point(ab: list[Coefficient]) -> None:
    """Evaluation is a homomorphism: an exact second opinion on sums and products."""
    a, b = ab
    field = a.field
    va, vb = at_point(a), at_point(b)
    total = {k: va.get(k, Fraction(0)) + vb.get(k, Fraction(0)) for k in {*va, *vb}}
    assert at_point(a + b) == {k: v for k, v in total.items() if v}
    product: dict[int, Fraction] = {}
    for k, p in va.items():
        for m, q in vb.items():
            for basis, s in field.roots.power(k + m):
                product[basis] = product.get(basis, Fraction(0)) + s * p * q
    assert at_point(a * b) == {k: v for k, v in product.items() if v}


@given(coefficients(2))
def test_conjugation(ab: list[Coefficient]) -> None:
    a, b = ab
    assert a.conjugate().conjugate() == a
    assert (a * b).conjugate() == a.conjugate() * b.conjugate()
    assert (a + b).conjugate() == a.conjugate() + b.conjugate()
    norm = a * a.conjugate()
    assert norm.conjugate() == norm
    assert a.times_i().conjugate() == a.conjugate().times_i(-1)
    assert a.times_i(4) == a
    assert a.times_i(2) == -a


@given(coefficients(1))
def test_as_complex_numbers(one: list[Coefficient]) -> None:
    """The display and the algebra mean the same number.

    The values have at most 50 terms of a size up to 1e6 over divisors of at least 1/165: 1e-25 is
    far above rounding at 50 digits.
    """
    (a,) = one
    mpmath.mp.dps = 50
    n = a.field.roots.n
    value = mpmath.fsum(
        mpmath.mpf(v.numerator) / v.denominator * mpmath.expjpi(mpmath.mpf(2 * k) / n)
        for k, v in at_point(a).items()
    )
    symbols = {name: sp.Symbol(name, real=True) for name in NAMES}
    numbers = {s: sp.Rational(POINT[n].numerator, POINT[n].denominator) for n, s in symbols.items()}
    show = FieldSymbols(a.field, symbols)
    shown = sp.N(show(a).subs(numbers), 50)
    assert abs(mpmath.mpmathify(shown) - value) < mpmath.mpf("1e-25")
    real, imaginary = (sp.N(e.subs(numbers), 50) for e in show.real_imaginary(a))
    assert abs(mpmath.mpc(real, imaginary) - value) < mpmath.mpf("1e-25")


@given(coefficients(1))
def test_partial_fractions_add_up(one: list[Coefficient]) -> None:
    (a,) = one
    assert a.field.sum(partial_fractions(a)) == a


@given(coefficients(1), st.sampled_from(NAMES))
def test_splitting_by_a_generator(one: list[Coefficient], name: str) -> None:
    (a,) = one
    field = a.field
    index = field.names.index(name)
    if any(field.divisors[m].degrees()[index] for m in a.den):
        with pytest.raises(ValueError, match=f"{name} occurs in a denominator"):
            split_generator(a, name)
        return
    parts = split_generator(a, name)
    assert field.sum(c * field.generator(name) ** k for k, c in parts.items()) == a
    for c in parts.values():
        assert all(not p.degrees()[index] for p in c.num.values())


@pytest.mark.parametrize("order", ORDERS)
def test_zero_is_recognised(order: int) -> None:
    """1/(x − y) − 1/(x + y) − 2y/(x² − y²) = 0, and others of its kind."""
    field = ParameterField(NAMES, order)
    u, v = field.gens["x"], field.gens["y"]
    difference = field.reciprocal(u - v) - field.reciprocal(u + v)
    both = field.reciprocal(u * u - v * v)
    assert difference == field.polynomial(2 * v) * both
    assert not (difference - field.polynomial(2 * v) * both)
    assert difference - field.polynomial(3 * v) * both
    unity = [field.root_of_unity(Fraction(k, order)) for k in range(order)]
    assert not field.sum(unity)
    assert not field.sum(c * field.reciprocal(u - v) for c in unity)


@pytest.mark.parametrize("order", ORDERS)
def test_complex_divisors_cancel(order: int) -> None:
    """1/(x + iy) − (x − iy)/(x² + y²) = 0, although x² + y² is irreducible over the rationals."""
    field = ParameterField(NAMES, order)
    u, v = field.generator("x"), field.generator("y")
    z = u + v.times_i()
    assert z.inverse() == z.conjugate() * field.reciprocal((u * u + v * v).num[0])
    assert z.inverse() * z == field.one
    zeta = u + field.rotate(v, 1)
    assert zeta.inverse() * zeta == field.one


def test_divisors_are_taken_out() -> None:
    field = ParameterField(NAMES)
    u, v = field.gens["x"], field.gens["y"]
    c = field.polynomial(u * u - v * v) * field.reciprocal((u - v) ** 2 * (u + 2 * v))
    assert c == field.polynomial(u + v) * field.reciprocal(u - v) * field.reciprocal(u + 2 * v)
    assert sorted(c.den.values()) == [1, 1]
    half = field.reciprocal(2 * u - 2 * v)
    assert half == field.reciprocal(u - v).scale(Fraction(1, 2))
    assert field.reciprocal(v - u) == -field.reciprocal(u - v)


@pytest.mark.parametrize("radicand", [2, 3, 5, 6, 7, 15])
def test_gauss_sums_square(radicand: int) -> None:
    n, terms = gauss_sum(radicand)
    field = ParameterField((), n)
    root = field.sum(field.root_of_unity(Fraction(k, n)).scale(c) for k, c in terms.items())
    assert root * root == field.rational(radicand)
    assert root.conjugate() == root


def test_what_has_no_reciprocal_or_no_root() -> None:
    field = ParameterField(NAMES)
    with pytest.raises(ZeroDivisionError):
        field.zero.inverse()
    with pytest.raises(ZeroDivisionError):
        field.reciprocal(field.gens["x"] - field.gens["x"])
    with pytest.raises(ValueError, match="no power"):
        field.root_of_unity(Fraction(1, 3))


@pytest.mark.parametrize(
    ("build", "expected"),
    [
        (lambda f: f.generator("x") * f.generator("y"), 1),
        (lambda f: -(f.generator("x") + f.generator("y")), -1),
        (lambda f: f.generator("x") - f.generator("y"), None),
        (lambda f: (f.generator("x") - f.generator("y")) ** 2, 1),
        (lambda f: f.generator("z"), None),
        (lambda f: f.generator("z") ** 2, 1),
        (lambda f: f.generator("x").times_i(), None),
        (lambda f: -f.reciprocal(f.gens["x"] + f.gens["y"]), -1),
        (lambda f: f.reciprocal(f.gens["x"] - f.gens["y"]), None),
        (lambda f: f.zero, 0),
    ],
)
def test_signs_for_positive_x_and_y(build: Build, expected: int | None) -> None:
    assert sign(build(ParameterField(NAMES)), frozenset("xy")) == expected


@given(coefficients(1))
def test_signs_are_right_where_they_are_claimed(one: list[Coefficient]) -> None:
    """At a point with all generators positive, the sign of the value."""
    (a,) = one
    square = a * a.conjugate()
    assume(set(square.num) <= {0})
    claimed = sign(square, frozenset(NAMES))
    assert claimed in (None, 0, 1)
    assert (claimed == 0) == (not a)
