"""Curves of equilibria along a parameter, followed by their length, so that folds do not matter.

Many pieces of curves are followed together, each from a point at one value of the parameter to
where it first comes to one of two values again.
"""

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

__all__ = ["Arc", "Curve", "across", "follow", "landed", "on_plane", "turning"]

Coefficients = Callable[[Any], Any]

LONGEST = 0.25
SHORTEST = 1e-7
ENOUGH = 400
AIM = 1e-3
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


class Arc(NamedTuple):
    """A piece of a curve.

    Attributes
    ----------
    points : numpy.ndarray
        w in the scale of this piece, shape (m, d + 1).
    tangents : numpy.ndarray
        Of length one, the same shape.
    scale : numpy.ndarray
        Shape (d,).
    side : int
        −1 or 1 where it ended at the lower or the upper value, 0 where it could not be followed.
    """

    points: NDArray[np.float64]
    tangents: NDArray[np.float64]
    scale: NDArray[np.float64]
    side: int


def _bordered(
    curve: Curve, w: NDArray[Any], scale: NDArray[Any], tangent: NDArray[Any]
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Newton's step across the tangent, and the tangent of the curve."""
    f, matrices = curve.system(w, scale)
    k, d = f.shape
    full = np.concatenate((matrices, tangent[:, None, :]), axis=1)
    right = np.zeros((k, d + 1, 2))
    right[:, :d, 0], right[:, d, 1] = -f, 1.0
    both = solve(full, right)
    return both[..., 0], both[..., 1] / np.linalg.norm(both[..., 1], axis=1)[:, None]


def follow(
    curve: Curve,
    x: NDArray[np.float64],
    p: NDArray[np.float64],
    direction: NDArray[np.float64],
    bounds: tuple[NDArray[np.float64], NDArray[np.float64]],
) -> list[Arc]:
    """Pieces of curves from given points until p leaves its bounds.

    Parameters
    ----------
    curve : Curve
    x : numpy.ndarray
        Real unknowns of the chart, shape (K, d).
    p : numpy.ndarray
        Shape (K,).
    direction : numpy.ndarray
        1 or −1: which way p goes at first, shape (K,).
    bounds : tuple of numpy.ndarray
        Lower and upper values, shape (K,) each; p is one of them.
    """
    width = curve.high - curve.low
    size = np.maximum(np.abs(x).max(axis=1, initial=0.0), 1e-300)
    scale = np.repeat(size[:, None], x.shape[1], axis=1)
    for pivot in curve.place.pivots:  # rates of drift have another unit
        c, _ = curve.at(p)
        _, matrices = equations(curve.place, c, *unpack(curve.place, x))
        across = np.abs(matrices[:, :, 2 * pivot + 1]).max(axis=1)
        along = np.abs(matrices[:, :, 0::2]).max(axis=(1, 2))
        scale[:, 2 * pivot + 1] = along * size / np.maximum(across, 1e-300)
    w = np.concatenate((x / scale, (p / width)[:, None]), axis=1)
    low, high = bounds[0] / width, bounds[1] / width
    with np.errstate(all="ignore"):
        _, matrices = curve.system(w, scale)
        slope = solve(matrices[..., :-1], -matrices[..., -1:])[..., 0]
        tangent = np.concatenate((slope, np.ones((len(w), 1))), axis=1)
        tangent *= (direction / np.linalg.norm(tangent, axis=1))[:, None]
        return _pieces(curve, w, scale, tangent, low, high)


def _pieces(
    curve: Curve,
    w: NDArray[Any],
    scale: NDArray[Any],
    tangent: NDArray[Any],
    low: NDArray[Any],
    high: NDArray[Any],
) -> list[Arc]:
    count = len(w)
    points, tangents = [[row] for row in w], [[row] for row in tangent]
    side = np.zeros(count, dtype=np.int64)
    h = np.full(count, 0.02)
    going = np.flatnonzero(np.isfinite(tangent).all(axis=1))
    back = np.zeros(count, dtype=bool)
    w, tangent = w.copy(), tangent.copy()
    w_back, tangent_back = w.copy(), tangent.copy()
    for _ in range(ENOUGH):
        if not len(going):
            break
        length, own = h[going][:, None], tangent[going]
        guess = w[going] + length * own
        # A cubic through the last two points and their tangents, gone on with.
        bow = bows(w_back[going], tangent_back[going], w[going], own)
        guess = np.where(back[going][:, None], bow.at(1.0 + h[going] / bow.h), guess)
        first, _ = _bordered(curve, guess, scale[going], own)
        second, new = _bordered(curve, guess + first, scale[going], own)
        third = guess + first + second
        one, rest = np.abs(first).max(axis=1), np.abs(second).max(axis=1)
        turn = (new * own).sum(axis=1)
        good = (one < 20 * AIM) & ((rest < 0.1 * one) & (rest < 1e-5) | (rest < 1e-11))
        good &= turn > 0.9
        wish = np.clip(0.9 * (AIM / np.maximum(one, 1e-16)) ** 0.25, 0.3, 2.5)
        wish = np.where(np.isfinite(wish), wish, 0.3)
        done = going[good]
        w_back[done], tangent_back[done], back[done] = w[done], tangent[done], True
        w[done], tangent[done] = third[good], new[good]
        for k in done:
            points[k].append(w[k].copy())
            tangents[k].append(tangent[k].copy())
        longer = np.minimum(h[going] * wish, LONGEST)
        h[going] = np.where(good, longer, h[going] * np.minimum(wish, 0.5))
        side[done] = np.where(
            w[done, -1] >= high[done], 1, np.where(w[done, -1] <= low[done], -1, 0)
        )
        turned = done[(tangent[done, -1] > 0.0) != (tangent_back[done, -1] > 0.0)]
        bow = bows(w_back[turned], tangent_back[turned], w[turned], tangent[turned])
        outside = _outside(curve, bow, scale[turned], low[turned], high[turned])
        for k, (which, fold, along) in zip(turned, outside, strict=True):
            if which:
                points[k][-1], tangents[k][-1], side[k] = fold, along, which
        going = going[(side[going] == 0) & (h[going] > SHORTEST)]
    return [
        Arc(np.array(a), np.array(t), scale[k], int(side[k]))
        for k, (a, t) in enumerate(zip(points, tangents, strict=True))
    ]


def _outside(
    curve: Curve,
    bow: Bow,
    scale: NDArray[np.float64],
    low: NDArray[np.float64],
    high: NDArray[np.float64],
) -> list[tuple[int, NDArray[np.float64], NDArray[np.float64]]]:
    """Whether p leaves its bounds at a fold between two points, and the fold: side, point, tangent.

    Side 0 where it does not.
    """
    out = [(0, x, t) for x, t in zip(bow.first, bow.slope, strict=True)]
    if not out:
        return out
    # The cubic tells how far p goes to a part of a step; where that is close, the fold decides.
    grid = np.linspace(0.0, 1.0, 17)
    p = np.array([bow.at(np.full(len(bow.h), u), slice(-1, None))[:, 0] for u in grid])
    margin = 0.1 * (p.max(axis=0) - p.min(axis=0)) + 1e-9
    near = np.flatnonzero((p.max(axis=0) > high - margin) | (p.min(axis=0) < low + margin))
    if len(near):
        w, tangent = turning(curve, bow.pick(near), scale[near])
        for k, x, t in zip(near, w, tangent, strict=True):
            out[k] = (int(x[-1] >= high[k]) - int(x[-1] <= low[k]), x, t)
    return out


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
            step, new = _bordered(curve, w, scale, tangent)
            w = w + step
            if np.abs(step).max(initial=0.0) < 1e-13:
                break
    return w, new


def landed(
    curve: Curve, arcs: list[Arc], plane: NDArray[np.float64]
) -> tuple[list[Arc], NDArray[np.bool_]]:
    """The pieces cut where p comes to a value in their last step, and whether a point is there.

    Where it begins there, the next time counts.
    """
    bow = bows(*(np.array([getattr(a, x)[k] for a in arcs]) for k in (-2, -1) for x in FIELDS))
    scale = np.array([a.scale for a in arcs])
    target = plane / (curve.high - curve.low)
    upward = np.array([a.side for a in arcs]) > 0
    grid = np.linspace(0.0, 1.0, 33)
    p = np.array([bow.at(np.full(len(arcs), u), slice(-1, None))[:, 0] for u in grid])
    inside = np.where(upward, p < target, p > target)
    been = np.logical_or.accumulate(inside, axis=0)
    out = np.argmax(been & ~inside, axis=0)
    out = np.where(out == 0, len(grid) - 1, out)
    u = grid[out - 1], grid[out]
    sides = [across(curve, bow.at(x), scale, bow.towards(x), 3) for x in u]
    ends = bows(*sides[0], *sides[1])
    w, tangent = sides[0]
    # The crossing stays between two points of the curve: the other sheet behind a fold close by
    # may be as near, but not along the curve.
    for _ in range(4):
        share = ends.where(target)
        whole = (ends.h > 1e-12)[:, None]
        towards = np.where(whole, ends.towards(share), ends.slope)
        w = np.where(whole, ends.at(share), ends.first)
        w, tangent = across(curve, w, scale, towards, 3)
        before = (w[:, -1] < target) == upward
        new = (w, tangent, w, tangent)
        mask = before[:, None]
        chosen = (mask, mask, ~mask, ~mask)
        ends = bows(*(np.where(m, x, y) for m, x, y in zip(chosen, new, ends[:4], strict=True)))
        if np.abs(w[:, -1] - target).max(initial=0.0) < 1e-9:
            break
    w[:, -1] = target
    w, steady = on_plane(curve, w, scale)
    with np.errstate(all="ignore"):
        _, tangent = _bordered(curve, w, scale, tangent)
    cut = []
    for k, a in enumerate(arcs):
        points, tangents = a.points.copy(), a.tangents.copy()
        points[-1], tangents[-1] = w[k], tangent[k]
        cut.append(Arc(points, tangents, a.scale, a.side))
    return cut, steady


FIELDS = ("points", "tangents")


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
