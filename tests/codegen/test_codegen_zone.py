"""The intervals of emitted code, all points at once, against those of the engine, one by one."""

from __future__ import annotations

import numpy as np
import pytest

from mmsgen.runtime._edges import zone
from mmsgen.zones import unstable_zone

pytestmark = pytest.mark.filterwarnings("ignore::RuntimeWarning")  # callers switch these off


def polynomials(degree: int, count: int, random: np.random.Generator) -> np.ndarray:
    """Coefficients of random polynomials, some of a lower degree, some far from a parabola."""
    table = random.normal(size=(degree + 1, count)) * 10.0 ** random.integers(-2, 2, count)
    table[degree, random.random(count) < 0.2] = 0.0
    return table


@pytest.mark.parametrize("degrees", [(0,), (1,), (2,), (3,), (4,), (6,), (2, 0), (2, 1), (4, 2)])
@pytest.mark.parametrize("reach", [np.inf, 0.7])
def test_random_polynomials(degrees: tuple[int, ...], reach: float) -> None:
    """Coefficients of size 1 and roots of any size: 1e-9 of the edge is left of 1e-16."""
    random = np.random.default_rng(sum(degrees))
    criteria = [polynomials(degree, 300, random) for degree in degrees]
    own = np.array(zone(*(tuple(c) for c in criteria), reach=reach)).T
    wanted = unstable_zone(*criteria, reach=reach)
    assert np.allclose(own, wanted, rtol=1e-9, atol=1e-9, equal_nan=True)
    assert np.isfinite(wanted).any() or max(degrees) < 2


@pytest.mark.parametrize("half", [1e-3, 1e-7, 1e-12])
def test_narrow_zones_of_a_polynomial_that_is_nearly_a_parabola(half: float) -> None:
    """(h² − (σ − c)²)(1 + σ/7 − σ²/9), h far below c, and far below the other roots.

    Relative to c the coefficients are rounded to 1e-16, which moves the edges by 1e-16·c²/h.
    """
    centre = 30 * half
    parabola = [half**2 - centre**2, 2 * centre, -1.0]
    quartic = np.polynomial.polynomial.polymul(parabola, [1.0, 1 / 7, -1 / 9])
    edges = zone(tuple(quartic), reach=0.5)
    assert edges == pytest.approx((centre - half, centre + half), rel=1e-12)
    shifted = quartic - np.array([1.01 * half**2, 0.0, 0.0, 0.0, 0.0])
    assert np.isnan(zone(tuple(shifted), reach=0.5)).all()


def test_a_polynomial_that_counts_where_another_vanishes() -> None:
    damping = (np.array([0.0, 0.1, 0.0]), np.array([0.0, 0.0, 0.2]))
    still = ((damping[0], damping[1]), (1.0, 0.0, -4.0))
    lower, upper = zone((np.zeros(3), 0.0, 0.0), still)
    assert np.array_equal(lower, [-0.5, np.nan, np.nan], equal_nan=True)
    assert np.array_equal(upper, [0.5, np.nan, np.nan], equal_nan=True)


def test_intervals_that_overlap_are_one() -> None:
    lower, upper = zone((0.0, 1.0, -1.0), (-0.5, 2.0, -1.0))
    assert (lower, upper) == pytest.approx((0.0, 1 + np.sqrt(0.5)), abs=1e-15, rel=1e-15)
    # (0, 1) and (2, 3) stay apart, and the nearer one is taken.
    assert zone((0.0, 1.0, -1.0), (-6.0, 5.0, -1.0)) == pytest.approx((0.0, 1.0), abs=1e-15)
