"""The unstable interval of a detuning: where a polynomial criterion is positive, near zero."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

__all__ = ["unstable_zone"]


def unstable_zone(coefficients: Sequence[Any]) -> Any:
    """Edges of the interval nearest to zero on which a real polynomial is positive.

    Parameters
    ----------
    coefficients : sequence of array_like
        Lowest power first; they broadcast.

    Returns
    -------
    numpy.ndarray
        Shape (..., 2); infinite where the interval has no end, NaN where there is none.
    """
    arrays = np.broadcast_arrays(*(np.asarray(c, dtype=float) for c in coefficients))
    shape = arrays[0].shape
    table = np.stack([a.ravel() for a in arrays], axis=-1)
    zones = np.full((table.shape[0], 2), np.nan)
    for row, polynomial in enumerate(table):
        zones[row] = _zone(polynomial)
    return zones.reshape(*shape, 2)


def _zone(polynomial: Any) -> tuple[float, float]:
    if not np.all(np.isfinite(polynomial)) or not np.any(polynomial):
        return np.nan, np.nan
    roots = np.polynomial.polynomial.polyroots(np.trim_zeros(polynomial, "b"))
    scale = max(1.0, float(np.max(np.abs(roots), initial=0.0)))
    # A double root splits by the square root of the rounding error; what is left of it is no edge.
    real = np.sort(roots[np.abs(roots.imag) <= 1e-9 * scale].real)
    edges = np.concatenate(([-np.inf], real, [np.inf]))
    best, distance = (np.nan, np.nan), np.inf
    for low, high in pairwise(edges):
        inside = np.clip(0.0, low, high) if np.isinf(low) or np.isinf(high) else (low + high) / 2
        if np.isinf(low) or np.isinf(high):
            inside = high - 1.0 if np.isinf(low) else low + 1.0
            inside = 0.0 if np.isinf(low) and np.isinf(high) else inside
        if high > low and np.polynomial.polynomial.polyval(inside, polynomial) > 0:
            gap = max(low, -high, 0.0)
            if gap < distance:
                best, distance = (low, high), gap
    return best
