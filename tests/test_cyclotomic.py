"""Roots of unity, against complex numbers and against SymPy's minimal polynomials."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from mmsgen.cyclotomic import cyclotomic, gauss_sum

ORDERS = (4, 8, 12, 16, 20, 24, 28, 60)


def value(n: int, combination: object) -> mpmath.mpc:
    """A combination of powers of ζ as a number."""
    return mpmath.fsum(c * mpmath.expjpi(mpmath.mpf(2 * k) / n) for k, c in combination)


@pytest.mark.parametrize("n", ORDERS)
def test_powers_are_the_roots_of_unity(n: int) -> None:
    """Each reduced power is ζ^k: an identity in integers, checked as numbers.

    The combinations have at most 16 terms with coefficients of size 2: at 40 digits sums are good
    to 1e-38, and two different powers of the orders tested lie more than 0.1 apart.
    """
    field = cyclotomic(n)
    assert field.degree == sp.totient(n)
    mpmath.mp.dps = 40
    for k in range(-n, 2 * n):
        assert all(power < field.degree for power, _ in field.power(k))
        error = value(n, field.power(k)) - mpmath.expjpi(mpmath.mpf(2 * k) / n)
        assert abs(error) < mpmath.mpf("1e-36")


@pytest.mark.parametrize("n", ORDERS)
def test_the_basis_is_independent(n: int) -> None:
    """Powers below φ(n) are their own representation, so no combination of them is zero."""
    field = cyclotomic(n)
    assert all(field.power(k) == ((k, 1),) for k in range(field.degree))
    assert sp.degree(sp.minimal_polynomial(sp.exp(2 * sp.pi * sp.I / n), sp.Symbol("v"))) == (
        field.degree
    )


@pytest.mark.parametrize("n", ORDERS)
def test_the_imaginary_unit_squares_to_minus_one(n: int) -> None:
    field = cyclotomic(n)
    square: dict[int, int] = {}
    for k, c in field.power(field.i):
        for m, e in field.power(field.i):
            for b, s in field.power(k + m):
                square[b] = square.get(b, 0) + c * e * s
    assert {b: c for b, c in square.items() if c} == {0: -1}


@given(st.integers(2, 210))
def test_gauss_sums_are_square_roots(radicand: int) -> None:
    """√r as a sum of roots of unity; the positive root, not the negative one.

    Sums have fewer than 10⁴ terms of size 1: 1e-30 is far above rounding at 50 digits and far below
    the distance 2√2 to the other root.
    """
    if max(sp.factorint(radicand).values()) > 1:
        return
    n, terms = gauss_sum(radicand)
    assert n % 4 == 0
    mpmath.mp.dps = 50
    assert abs(value(n, terms.items()) - mpmath.sqrt(radicand)) < mpmath.mpf("1e-30")


@pytest.mark.parametrize("n", [0, -4, 1, 2, 6, 10])
def test_orders_without_i_are_refused(n: int) -> None:
    with pytest.raises(ValueError, match="multiple of 4"):
        cyclotomic(n)
