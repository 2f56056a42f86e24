"""Positive roots of batches of polynomials: against known roots and exact counts."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from mmsgen.runtime._roots import near_roots, positive_roots

EPS = 2.0**-52


def product(factors: list[np.ndarray]) -> np.ndarray:
    result = np.ones(1)
    for factor in factors:
        result = np.convolve(result, factor)
    return result


halves = st.integers(1, 12).map(lambda k: k / 2)
polynomials = st.tuples(
    st.dictionaries(halves, st.integers(1, 2), max_size=4),
    st.lists(halves, max_size=2),
    st.lists(st.tuples(st.integers(-4, 4), halves), max_size=1),
    st.integers(0, 2),
)


@given(st.lists(polynomials, min_size=1, max_size=5))
def test_known_roots_of_several_degrees_in_one_batch(batch: list[tuple]) -> None:
    """Halves of integers: the coefficients are exact.

    A root of multiplicity m is off by (ε S/(m! |p^{(m)}|))^{1/m}, S the sum of the terms' absolute
    values; 50 ε stands for the dozen roundings of Horner's scheme.
    """
    rows, expected = [], []
    for roots, negative, pairs, zeros in batch:
        factors = [np.array([-r, 1.0]) for r, m in roots.items() for _ in range(m)]
        factors += [np.array([r, 1.0]) for r in negative]
        factors += [np.array([a * a + b * b, -2.0 * a, 1.0]) for a, b in pairs]
        rows.append(product([*factors, *([np.array([0.0, 1.0])] * zeros)]))
        expected.append(roots)
    width = max(len(r) for r in rows)
    table = np.array([np.pad(r, (0, width - len(r))) for r in rows])
    found = positive_roots(table)
    assert found.shape == (len(rows), width - 1)
    for row, known, own in zip(table, expected, found, strict=True):
        own = own[np.isfinite(own)]
        assert len(own) == len(known)
        p = np.polynomial.Polynomial(row)
        for x, (r, m) in zip(own, sorted(known.items()), strict=True):
            size = np.polynomial.Polynomial(np.abs(row))(r)
            slope = abs(p.deriv(m)(r)) / (1, 1, 2)[m]
            assert abs(x - r) <= (50 * EPS * size / slope) ** (1 / m)


@given(st.lists(st.lists(st.integers(-9, 9), min_size=2, max_size=8), min_size=1, max_size=4))
def test_the_number_of_roots_is_that_of_sturm(batch: list[list[int]]) -> None:
    """Distinct positive roots, counted exactly by SymPy."""
    width = max(map(len, batch))
    table = np.array([row + [0] * (width - len(row)) for row in batch], dtype=float)
    z = sp.Symbol("z")
    for row, found in zip(batch, positive_roots(table), strict=True):
        p = sp.Poly(row[::-1], z)
        exact = 0
        if p.degree() > 0:
            exact = p.count_roots(0, sp.oo) - (row[0] == 0)
        assert np.isfinite(found).sum() == exact
        assert np.all(np.diff(found[np.isfinite(found)]) > 0.0)


def test_units_do_not_matter() -> None:
    """Powers of two in x and in the polynomial change nothing but the exponents."""
    random = np.random.default_rng(5)
    table = random.normal(size=(200, 7))
    powers = np.arange(7)
    found = positive_roots(table)
    for shift, e in ((300, 7), (-500, -40), (0, 101)):
        scaled = np.ldexp(table, shift - e * powers)
        assert np.array_equal(positive_roots(scaled), np.ldexp(found, e), equal_nan=True)


@pytest.mark.parametrize(
    ("row", "roots", "multiplicity"),
    [
        ([-1, 3, -3, 1], [1.0], 3),  # at the cut of the half-line
        ([1, -2, 1], [1.0], 2),
        ([2, -3, 1], [1.0, 2.0], 1),
        ([1, 0, -2, 0, 1], [1.0], 2),
        ([-1, 1, 0, 0, 0], [1.0], 1),
        ([0, 0, -3, 1], [3.0], 1),
        ([1, 1, 1], [], 1),
        ([0, 0, 0], [], 1),
        ([5, 0, 0], [], 1),
        ([np.nan, 1, -1], [], 1),
        ([-1, np.inf, 1], [], 1),
        ([-1, 1, 1e-300], [1.0], 1),
        ([1e-30, -1, 1], [1e-30, 1.0], 1),
        ([1e-200, -1, 1, -1e-90], [1e-200, 1.0, 1e90], 1),
        ([1e-300, -1, 0, 0, 0, 0, 0, 0, 0, 1], [1e-300, 1.0], 1),
        ([3, -10, 12, -6, 1], [1.0, 3.0], 3),
        (list(np.poly([1.1, 1.1, 1.1, 3.3, -0.7])[::-1]), [1.1, 3.3], 3),
        # The half is double, and one of the points at which intervals are halved.
        ([1, -8.0625, 20.5, -17.25, 1], [0.25, 0.5, 16.0], 2),
    ],
)
def test_particular_polynomials(row: list[float], roots: list[float], multiplicity: int) -> None:
    found = positive_roots(np.array(row, dtype=float))
    found = found[np.isfinite(found)]
    # A dozen roundings, and their root where a root is multiple.
    rounding = (20 * EPS) ** (1 / multiplicity)
    assert found == pytest.approx(roots, rel=rounding, abs=0.0)


def test_near_double_roots_are_reported() -> None:
    """(x − 1.3)² ± 1e-10: two roots or none, and the extremum near 1.3 in either case.

    That of the reversed polynomial, if it is taken, is 1.3 (1 + 1e-10/1.69).
    """
    for gap, count in ((1e-10, 0), (-1e-10, 2)):
        roots, extrema = near_roots([1.69 + gap, -2.6, 1.0], 1e-8)
        assert np.isfinite(roots).sum() == count
        assert extrema[0] == pytest.approx(1.3, rel=1e-10)
        assert np.isnan(extrema[1:]).all()
    # At the cut of the half-line.
    roots, extrema = near_roots([1.0 + 1e-10, -2.0, 1.0], 1e-8)
    assert np.isnan(roots).all()
    assert extrema[np.isfinite(extrema)] == pytest.approx(1.0, rel=1e-9)
    assert np.isnan(near_roots([1.69 + 1e-6, -2.6, 1.0], 1e-8)[1]).all()


def test_shapes() -> None:
    assert positive_roots(np.ones((2, 3, 4))).shape == (2, 3, 3)
    assert positive_roots([-2.0, 1.0]) == pytest.approx([2.0], rel=1e-15)
    assert positive_roots(np.zeros((0, 4))).shape == (0, 3)
    assert positive_roots([3.0]).shape == (0,)
