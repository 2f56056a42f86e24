"""Curves of equilibria in coordinates over their scales, and Newton's method to points of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._bows import Bow, bows
from ._charts import Chart, equations, unpack
from ._flow import rates
from ._paths import solve

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Curve", "across", "bordered", "on_plane", "turning"]

Coefficients = Callable[[Any], Any]

STEP = 1e-6
"""Of a difference for derivatives by the parameter, over its range: errors of 1e-10 and less."""


class Curve(NamedTuple):
    """Equations with a parameter p, in real unknowns over their scales.

    Attributes
    ----------
    place : Chart
    coefficients : callable
        p, shape (K,) → coefficients of the whole flow, shape (K, terms).
    low, high : float
        Ends of the range of p; beyond it the coefficients go on as straight lines.
    """

    place: Chart
    coefficients: Coefficients
    low: float
    high: float

    def at(self, p: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
        """The coefficients that occur in the chart, and their derivatives."""
        inside = np.clip(p, self.low, self.high)
        step = STEP * (self.high - self.low)
        left, right = np.maximum(inside - step, self.low), np.minimum(inside + step, self.high)
        every = self.coefficients(np.concatenate((inside, left, right)))
        c, low, high = np.split(np.asarray(every)[:, list(self.place.columns)], 3)
        slope = (high - low) / np.maximum(right - left, 1e-300)[:, None]
        return c + slope * (p - inside)[:, None], slope

    def system(
        self, w: NDArray[np.float64], scale: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Values and derivatives at w = (x/scale, p/width), shapes (K, d) and (K, d, d + 1)."""
        width = self.high - self.low
        c, slope = self.at(w[:, -1] * width)
        b, rate = unpack(self.place, w[:, :-1] * scale)
        f, matrices = equations(self.place, c, b, rate)
        by = 2.0 * rates(self.place.flow, slope, b) * width
        out = np.empty((*matrices.shape[:-1], matrices.shape[-1] + 1))
        out[..., :-1] = matrices * scale[:, None, :]
        out[:, 0::2, -1], out[:, 1::2, -1] = by.real, by.imag
        return f, out


def bordered(
    curve: Curve, w: NDArray[Any], scale: NDArray[Any], tangent: NDArray[Any]
) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Newton's step across the tangent, the tangent of the curve, and the orientation.

    The orientation is the sign of the determinant of the Jacobian and the tangent. It stays the
    same along a curve, through its folds, until another curve crosses it; sheets that meet in a
    fold have opposite ones in the same direction of p.
    """
    f, matrices = curve.system(w, scale)
    k, d = f.shape
    full = np.concatenate((matrices, tangent[:, None, :]), axis=1)
    right = np.zeros((k, d + 1, 2))
    right[:, :d, 0], right[:, d, 1] = -f, 1.0
    both = solve(full, right)
    new = both[..., 1] / np.linalg.norm(both[..., 1], axis=1)[:, None]
    return both[..., 0], new, np.linalg.slogdet(full)[0]


def on_plane(
    curve: Curve, w: NDArray[Any], scale: NDArray[Any], steps: int = 8
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Newton's method with p held fixed.

    Returns
    -------
    w : numpy.ndarray
        Shape (K, d + 1).
    steady : numpy.ndarray
        Whether it converged.
    """
    w = w.copy()
    last = np.full(len(w), np.inf)
    todo = np.arange(len(w))
    with np.errstate(all="ignore"):
        for _ in range(steps):
            f, matrices = curve.system(w[todo], scale[todo])
            step = solve(matrices[..., :-1], -f[..., None])[..., 0]
            w[todo, :-1] += step
            last[todo] = np.abs(step).max(axis=1)
            todo = todo[~(last[todo] < 1e-9)]
            if not len(todo):
                break
    return w, last < 1e-6


def across(
    curve: Curve, w: NDArray[Any], scale: NDArray[Any], tangent: NDArray[Any], steps: int = 6
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Newton's method across given directions: points of the curve, and the tangents there."""
    new = tangent
    with np.errstate(all="ignore"):
        for _ in range(steps):
            step, new, _ = bordered(curve, w, scale, tangent)
            w = w + step
            if np.abs(step).max(initial=0.0) < 1e-13:
                break
    return w, new


def turning(
    curve: Curve, bow: Bow, scale: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Where p has an extremum between two points: the points and their tangents.

    The slope of p along the curve is zero there to rounding, so p itself is as good as that.
    """
    first, slope, last, end = (part.copy() for part in bow[:4])
    w, tangent = first, slope
    for _ in range(8):
        own = bows(first, slope, last, end)
        low, high = np.zeros(len(w)), np.ones(len(w))
        for _ in range(30):
            middle = 0.5 * (low + high)
            same = (own.towards(middle)[:, -1] > 0.0) == (slope[:, -1] > 0.0)
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        w, tangent = across(curve, own.at(low), scale, own.towards(low))
        if np.abs(tangent[:, -1]).max(initial=0.0) < 1e-12:
            break
        before = ((tangent[:, -1] > 0.0) == (slope[:, -1] > 0.0))[:, None]
        first, slope = np.where(before, w, first), np.where(before, tangent, slope)
        last, end = np.where(before, last, w), np.where(before, end, tangent)
    return w, tangent
