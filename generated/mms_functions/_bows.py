"""Cubics between points of a curve at which its tangents are known."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Bow", "bows"]


class Bow(NamedTuple):
    """Cubics between two points with tangents of length one, over lengths from 0 to h.

    Attributes
    ----------
    first, slope, last, end : numpy.ndarray
        Point and tangent at either end, shape (K, d + 1).
    h : numpy.ndarray
        Shape (K,).
    """

    first: NDArray[np.float64]
    slope: NDArray[np.float64]
    last: NDArray[np.float64]
    end: NDArray[np.float64]
    h: NDArray[np.float64]

    def at(self, u: NDArray[np.float64], columns: Any = slice(None)) -> NDArray[np.float64]:
        """Points at the share u of the length, shape (K,)."""
        u, h = u[:, None], self.h[:, None]
        v = 1.0 - u
        return (
            self.first[:, columns] * ((1.0 + 2.0 * u) * v * v)
            + self.slope[:, columns] * (h * u * v * v)
            + self.last[:, columns] * (u * u * (3.0 - 2.0 * u))
            - self.end[:, columns] * (h * u * u * v)
        )

    def towards(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """Directions there, of length one."""
        u, h = u[:, None], np.maximum(self.h, 1e-300)[:, None]
        out = (
            (self.last - self.first) * (6.0 * u * (1.0 - u))
            + self.slope * (h * (1.0 - u) * (1.0 - 3.0 * u))
            + self.end * (h * u * (3.0 * u - 2.0))
        )
        return out / np.maximum(np.linalg.norm(out, axis=-1), 1e-300)[:, None]

    def where(self, value: NDArray[np.float64]) -> NDArray[np.float64]:
        """The share at which the last coordinate takes a value between those at the ends."""
        first, rise = self.first[:, -1], self.last[:, -1] - self.first[:, -1]
        one, end = self.h * self.slope[:, -1], self.h * self.end[:, -1]
        two, three = 3.0 * rise - 2.0 * one - end, one + end - 2.0 * rise
        rising = rise >= 0.0
        low, high = np.zeros(len(value)), np.ones(len(value))
        u = (value - first) / np.where(rise == 0.0, 1.0, rise)
        for _ in range(6):
            u = np.where((u > low) & (u < high), u, 0.5 * (low + high))
            gap = first - value + u * (one + u * (two + u * three))
            above = (gap > 0.0) == rising
            low, high = np.where(above, low, u), np.where(above, u, high)
            speed = one + u * (2.0 * two + u * (3.0 * three))
            u = u - gap / np.where(speed == 0.0, np.inf, speed)
        return np.clip(u, low, high)

    def pick(self, rows: NDArray[Any]) -> Bow:
        """Some of them."""
        return Bow(*(part[rows] for part in self))


def bows(first: Any, slope: Any, last: Any, end: Any) -> Bow:
    """Cubics whose length is the chord and what the arc of a circle adds to it."""
    angle = ((end - slope) ** 2).sum(axis=-1)
    return Bow(first, slope, last, end, np.linalg.norm(last - first, axis=-1) * (1 + angle / 24))
