"""The unstable intervals of a detuning: where one of several polynomial criteria is positive."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.polynomial import polynomial as polynomials

__all__ = ["positive_zones", "unstable_zone"]


def unstable_zone(*criteria: Sequence[Any], reach: Any = np.inf) -> Any:
    """Edges of the interval nearest to zero on which one of several polynomials is positive.

    Parameters
    ----------
    *criteria : sequence of array_like
        Coefficients, lowest power first; they broadcast.
    reach : array_like
        How far the interval may be from zero.

    Returns
    -------
    numpy.ndarray
        Shape (..., 2); infinite where the interval has no end, NaN where there is none.
    """
    flat = [np.asarray(reach, dtype=float)]
    flat += [np.asarray(c, dtype=float) for polynomial in criteria for c in polynomial]
    arrays = np.broadcast_arrays(*flat)
    shape = arrays[0].shape
    table = np.stack([a.ravel() for a in arrays], axis=-1)
    ends = np.cumsum([len(polynomial) for polynomial in criteria])[:-1]
    zones = np.full((table.shape[0], 2), np.nan)
    for row, (own, *rest) in enumerate(table):
        found = positive_zones(np.split(np.array(rest), ends), own)
        zones[row] = min(found, key=_gap, default=(np.nan, np.nan))
    return zones.reshape(*shape, 2)


def positive_zones(criteria: Sequence[Any], reach: float = np.inf) -> list[tuple[float, float]]:
    """All intervals on which one of several polynomials is positive, in ascending order.

    Parameters
    ----------
    criteria : sequence of array_like
        Coefficients, lowest power first, of one point.
    reach : float
        How far an interval may be from zero.
    """
    table = [np.asarray(p, dtype=float) for p in criteria]
    if not all(np.all(np.isfinite(p)) for p in table):
        return []
    table = [np.trim_zeros(p, "b") for p in table if np.any(p)]
    breaks = np.unique(np.concatenate([np.empty(0), *(_breaks(p) for p in table)]))
    zones: list[tuple[float, float]] = []
    for low, high in pairwise((-np.inf, *breaks, np.inf)):
        if not any(polynomials.polyval(_between(low, high), p) > 0.0 for p in table):
            continue
        if zones and zones[-1][1] == low:
            zones[-1] = zones[-1][0], high
        else:
            zones.append((float(low), float(high)))
    return [zone for zone in zones if _gap(zone) <= reach]


def _gap(zone: tuple[float, float]) -> float:
    """The distance of an interval from zero."""
    return max(zone[0], -zone[1], 0.0)


def _breaks(polynomial: Any) -> Any:
    """Points between which a polynomial keeps its sign: real parts of all its roots.

    Those of complex pairs do no harm, and whether two roots that nearly coincide are real is
    left to the signs.
    """
    roots = polynomials.polyroots(polynomial)
    x = roots.real.copy()
    slope = polynomials.polyder(polynomial)
    for _ in range(2):  # Newton's steps take out the error of the companion matrix
        value, rate = polynomials.polyval(x, polynomial), polynomials.polyval(x, slope)
        better = x - value / np.where(rate == 0.0, np.inf, rate)
        smaller = np.abs(polynomials.polyval(better, polynomial)) < np.abs(value)
        x = np.where(smaller & (roots.imag == 0.0), better, x)
    return x


def _between(low: float, high: float) -> float:
    if np.isinf(low):
        return 0.0 if np.isinf(high) else high - 1.0 - abs(high)
    return low + 1.0 + abs(low) if np.isinf(high) else 0.5 * low + 0.5 * high
