"""Closed branches between two values of a parameter at which equilibria are computed.

Before two real equilibria appear they are a pair of complex ones. Of one amplitude that shows in an
extremum of the frequency-response relation over the modulus, whose height goes to zero and through
it; of several, in complex equilibria that approach their own conjugates.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._elimination import Structure, relation, rows_of, structure_of
from ._flow import Flow
from ._roots import positive_roots

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

__all__ = ["touching"]

NOISE = 1e-12
"""Heights that are smaller, over the sum of the moduli of all terms, are rounding."""

INNER, ROUNDS = 9, 4
"""Into how many parts the neighbourhood of a low extremum is cut, and how often."""


def touching(
    flow: Flow, numbers: Callable[[Any], NDArray[np.complex128]], p: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Values of the parameter on closed branches of one amplitude between two given ones.

    Parameters
    ----------
    flow : Flow
        With n = 1.
    numbers : callable
        p → coefficients, shape (K,) → (K, terms).
    p : numpy.ndarray
        Ascending.

    Returns
    -------
    numpy.ndarray
        One value for each place where an extremum of the relation, of which three neighbouring
        values have one sign, has the other one in between.
    """
    c = numbers(p)
    structure = structure_of(flow, tuple(map(bool, (c != 0.0).any(axis=0))))
    if not (structure.degree or structure.circle) or len(p) < 3:
        return np.zeros(0)
    h = _heights(structure, c)
    before, here, after = h[:-2], h[1:-1], h[2:]
    number = np.isfinite(h).sum(axis=1)
    alike = (number[:-2] == number[1:-1]) & (number[2:] == number[1:-1])
    low = (np.abs(here) <= np.abs(before)) & (np.abs(here) <= np.abs(after))
    low &= (np.sign(before) == np.sign(here)) & (np.sign(after) == np.sign(here))
    low &= (np.abs(here) > NOISE) & alike[:, None] & (_lowest(p, h) < 0.5)
    row, place = np.nonzero(low)
    sign, many = np.sign(here[row, place]), number[1:-1][row]
    left, right = p[row], p[row + 2]
    found: list[NDArray[np.float64]] = []
    shares = np.arange(INNER + 2) / (INNER + 1.0)
    for _ in range(ROUNDS):
        if not len(left):
            break
        at = left[:, None] + (right - left)[:, None] * shares
        inner = _heights(structure, numbers(at[:, 1:-1].ravel())).reshape(len(left), INNER, -1)
        width = max(inner.shape[2], int(place.max()) + 1)
        inner = np.pad(inner, ((0, 0), (0, 0), (0, width - inner.shape[2])), constant_values=np.nan)
        own = np.take_along_axis(inner, place[:, None, None], axis=2)[..., 0] * sign[:, None]
        own = np.where(np.isfinite(inner).sum(axis=2) == many[:, None], own, np.inf)
        best = np.argmin(own, axis=1)
        crossed = np.take_along_axis(own, best[:, None], axis=1)[:, 0] < -NOISE
        found.append(at[crossed, best[crossed] + 1])
        left, right = (np.take_along_axis(at, (best + k)[:, None], axis=1)[:, 0] for k in (0, 2))
        rest = ~crossed
        left, right, sign = left[rest], right[rest], sign[rest]
        place, many = place[rest], many[rest]
    return np.concatenate([*found, np.zeros(0)])


def _heights(structure: Structure, c: NDArray[np.complex128]) -> NDArray[np.float64]:
    """Extrema of the relation over r > 0, each over the sum of its terms' moduli, in order of r."""
    table, _ = rows_of(relation(structure, c), len(c))
    if table.shape[1] < 3:
        return np.zeros((len(c), 0))
    powers = np.arange(table.shape[1])
    with np.errstate(all="ignore"):
        x = positive_roots(table[:, 1:] * powers[1:])
        terms = table[:, None, :] * x[..., None] ** powers
        height: NDArray[np.float64] = terms.sum(axis=-1) / np.abs(terms).sum(axis=-1)
    return height


def _lowest(p: NDArray[np.float64], h: NDArray[np.float64]) -> NDArray[np.float64]:
    """Least height of the parabola through three neighbours, over that of the middle one."""
    one, two = np.diff(p)[:-1, None], np.diff(p)[1:, None]
    rise, further = (h[1:-1] - h[:-2]) / one, (h[2:] - h[1:-1]) / two
    bend = (further - rise) / (one + two)
    slope = (rise * two + further * one) / (one + two)
    with np.errstate(all="ignore"):
        return 1.0 - slope**2 / (4.0 * bend * h[1:-1])
