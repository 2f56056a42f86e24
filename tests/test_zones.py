"""The interval nearest to zero on which a polynomial is positive, from its roots."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from mmsgen.zones import unstable_zone

spread = st.lists(st.floats(-5, 5).map(lambda v: round(v, 2)), min_size=1, max_size=4, unique=True)


def expected(roots: list[float], lead: float) -> tuple[float, float]:
    """By walking along the axis: the sign left of all roots is that of lead·(−1)^n."""
    edges = [-np.inf, *sorted(roots), np.inf]
    sign = np.sign(lead) * (-1) ** len(roots)
    best, gap = (np.nan, np.nan), np.inf
    for low, high in pairwise(edges):
        distance = max(low, -high, 0.0)
        if sign > 0 and distance < gap:
            best, gap = (low, high), distance
        sign = -sign
    return best


@given(spread, st.sampled_from([1.0, -1.0, 7.0, -0.3]), st.sampled_from([None, 0.7, 3.0]))
def test_zones_between_real_roots(
    roots: list[float], lead: float, complex_part: float | None
) -> None:
    """Roots at least 0.01 apart in [−5, 5], with or without a complex pair.

    The condition number of a root is at most 10⁴·(size of the coefficients)/0.01³ = 1e13·1e-16:
    rounding may move a root by 1e-3 in the worst case, so only wider gaps are asked to 1e-4.
    """
    gaps = np.diff(sorted(roots))
    assume(not gaps.size or gaps.min() > 0.2)
    polynomial = lead * np.polynomial.polynomial.polyfromroots(roots)
    if complex_part is not None:
        pair = [1 + complex_part**2, -2, 1]
        polynomial = np.polynomial.polynomial.polymul(polynomial, pair)
    low, high = unstable_zone(list(polynomial))
    wanted = expected(roots, lead)
    tie = expected([-r for r in roots], lead * (-1) ** len(roots))
    mirrored = (-tie[1], -tie[0])
    assert np.allclose((low, high), wanted, atol=1e-4, equal_nan=True) or np.allclose(
        (low, high), mirrored, atol=1e-4, equal_nan=True
    )


def test_constants() -> None:
    assert unstable_zone([1.0]).tolist() == [-np.inf, np.inf]
    assert np.isnan(unstable_zone([-1.0])).all()
    assert np.isnan(unstable_zone([0.0])).all()
    assert np.isnan(unstable_zone([0.0, 0.0, 0.0])).all()


def test_values_that_are_no_numbers_have_no_zone() -> None:
    """A frequency of zero in a denominator: NaN for that point, the others as they are."""
    zones = unstable_zone([np.array([1.0, np.nan, np.inf]), 0.0, -1.0])
    assert zones[0] == pytest.approx([-1.0, 1.0], abs=1e-14)
    assert np.isnan(zones[1:]).all()


def test_broadcasting() -> None:
    zones = unstable_zone([np.array([[1.0], [4.0]]), 0.0, np.array([-1.0, -4.0, 1.0])])
    assert zones.shape == (2, 3, 2)
    # Square roots of numbers of size 1.
    assert np.allclose(zones[:, :2, 1], [[1.0, 0.5], [2.0, 1.0]], atol=1e-14)
    assert np.isinf(zones[:, 2]).all()
    assert unstable_zone([np.zeros((0, 2)) + 1.0, -1.0]).shape == (0, 2, 2)


@pytest.mark.parametrize("size", [1e-8, 1e-3, 1.0, 1e5])
def test_small_and_large_detunings(size: float) -> None:
    """(h² − (σ − c)²) with c = 3h, and no zone where the square is never exceeded.

    Relative to the size: two roots h apart at a distance 3h lose one digit of 16.
    """
    centre, half = 3 * size, size
    zone = unstable_zone([half**2 - centre**2, 2 * centre, -1.0])
    assert zone == pytest.approx([2 * size, 4 * size], rel=1e-13)
    assert np.isnan(unstable_zone([-(half**2) - centre**2, 2 * centre, -1.0])).all()
