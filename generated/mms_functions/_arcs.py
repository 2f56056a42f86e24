"""Curves of equilibria along a parameter, followed by their length, so that folds do not matter.

Many pieces of curves are followed together, each from a point at one value of the parameter to
where it first comes to one of two values again. A step counts where Newton's method contracts, the
tangent turns little, and the orientation stays: of two sheets that nearly meet it is different.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._bows import Bow, bows
from ._charts import equations, unpack
from ._curves import Curve, across, bordered, on_plane, turning

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Arc", "follow", "landed", "steps_of"]

LONGEST = 0.25
SHORTEST = 1e-7
ENOUGH = 400
AIM = 1e-3

ROUNDING = 1e-9
"""What Newton's method may leave where it converges no more, close to where two curves cross."""

CROSSING = 1e-4
"""Where two curves cross, the orientation changes, in a step that is as short as that."""

FLOOR = 0.1
"""Lengths are over the largest amplitude, of the point or, times that, of all before it."""


class Arc(NamedTuple):
    """A piece of a curve.

    Attributes
    ----------
    points : numpy.ndarray
        Real unknowns and p over its range, shape (m, d + 1).
    tangents : numpy.ndarray
        In the same coordinates, of any length, the same shape.
    scale : numpy.ndarray
        Of the unknowns in each step, shape (m − 1, d).
    side : int
        −1 or 1 where it ended at the lower or the upper value, 0 where it could not be followed.
    orientation : float
        At the end, as of `bordered`.
    """

    points: NDArray[np.float64]
    tangents: NDArray[np.float64]
    scale: NDArray[np.float64]
    side: int
    orientation: float


def steps_of(arcs: list[Arc], which: slice = slice(None)) -> tuple[Bow, NDArray[np.float64]]:
    """Steps of all pieces, or some steps of each, over their scales, and these."""
    scale = np.concatenate([a.scale[which] for a in arcs])
    ends = [
        np.concatenate([part[which] for part in parts])
        for parts in (
            [a.points[:-1] for a in arcs],
            [a.tangents[:-1] for a in arcs],
            [a.points[1:] for a in arcs],
            [a.tangents[1:] for a in arcs],
        )
    ]
    first, slope, last, end = (_over(x, scale) for x in ends)
    return bows(first, _unit(slope), last, _unit(end)), scale


def _over(x: NDArray[np.float64], scale: NDArray[np.float64]) -> NDArray[np.float64]:
    out = x.copy()
    out[..., :-1] /= scale
    return out


def _times(w: NDArray[np.float64], scale: NDArray[np.float64]) -> NDArray[np.float64]:
    out = w.copy()
    out[..., :-1] *= scale
    return out


def _unit(t: NDArray[np.float64]) -> NDArray[np.float64]:
    size: NDArray[np.float64] = np.linalg.norm(t, axis=-1)[..., None]
    return t / np.where(size > 0.0, size, 1.0)


def follow(
    curve: Curve,
    x: NDArray[np.float64],
    p: NDArray[np.float64],
    direction: NDArray[np.float64],
    bounds: tuple[NDArray[np.float64], NDArray[np.float64]],
    care: float = 1.0,
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
    care : float
        By which steps are shorter.
    """
    width = curve.high - curve.low
    drifts = [2 * pivot + 1 for pivot in curve.place.pivots]
    amplitudes = np.setdiff1d(np.arange(x.shape[1]), drifts)
    size = np.maximum(np.abs(x[:, amplitudes]).max(axis=1, initial=0.0), 1e-300)
    scale = np.repeat(size[:, None], x.shape[1], axis=1)
    for pivot in curve.place.pivots:  # rates of drift have another unit
        c, _ = curve.at(p)
        _, matrices = equations(curve.place, c, *unpack(curve.place, x))
        sideways = np.abs(matrices[:, :, 2 * pivot + 1]).max(axis=1)
        along = np.abs(matrices[:, :, 0::2]).max(axis=(1, 2))
        scale[:, 2 * pivot + 1] = along * size / np.maximum(sideways, 1e-300)
    points = np.concatenate((x, (p / width)[:, None]), axis=1)
    low, high = bounds[0] / width, bounds[1] / width
    with np.errstate(all="ignore"):
        upward = np.zeros_like(points)
        upward[:, -1] = direction
        _, tangent, orientation = bordered(curve, _over(points, scale), scale, upward)
        start = _Way(points, _times(tangent, scale), scale, amplitudes, orientation)
        return _pieces(curve, start, low, high, care)


class _Way(NamedTuple):
    """Where the pieces are, in the coordinates of `Arc`."""

    points: NDArray[np.float64]
    tangents: NDArray[np.float64]
    scale: NDArray[np.float64]
    amplitudes: NDArray[np.int64]  # unknowns that are not rates of drift
    orientation: NDArray[np.float64]


class _Step(NamedTuple):
    """Where a step ends, how far off its prediction was, and whether it can be trusted."""

    w: NDArray[np.float64]
    tangent: NDArray[np.float64]
    orientation: NDArray[np.float64]
    off: NDArray[np.float64]
    good: NDArray[np.bool_]


def _stepped(
    curve: Curve,
    before: tuple[NDArray[Any], NDArray[Any]],
    here: tuple[NDArray[Any], NDArray[Any]],
    scale: NDArray[Any],
    h: NDArray[np.float64],
) -> _Step:
    """One step of length h; NaN `before` the first one."""
    w, own = here
    # A cubic through the last two points and their tangents, gone on with.
    bow = bows(before[0], before[1], w, own)
    guess = bow.at(1.0 + h / bow.h)
    guess = np.where(np.isfinite(guess), guess, w + h[:, None] * own)
    first, _, _ = bordered(curve, guess, scale, own)
    second, new, sign = bordered(curve, guess + first, scale, own)
    one, rest = np.abs(first).max(axis=1), np.abs(second).max(axis=1)
    good = (one < 20 * AIM) & ((rest < 0.1 * one) & (rest < 1e-5) | (rest < ROUNDING))
    good &= (new * own).sum(axis=1) > 0.9
    return _Step(guess + first + second, new, sign, one, good)


def _pieces(
    curve: Curve, way: _Way, low: NDArray[Any], high: NDArray[Any], care: float
) -> list[Arc]:
    x, tangent, scale, amplitudes, orientation = way
    count = len(x)
    points, tangents = [[row] for row in x], [[row] for row in tangent]
    scales: list[list[NDArray[Any]]] = [[] for _ in x]
    side = np.zeros(count, dtype=np.int64)
    h, largest = np.full(count, 0.02 / care), np.zeros(count)
    going = np.flatnonzero(np.isfinite(tangent).all(axis=1))
    back = np.zeros(count, dtype=bool)
    x, tangent, orientation = x.copy(), tangent.copy(), orientation.copy()
    x_back, tangent_back = x.copy(), tangent.copy()
    for _ in range(int(ENOUGH * care)):
        if not len(going):
            break
        size = np.abs(x[going][:, amplitudes]).max(axis=1)
        largest[going] = np.maximum(largest[going], size)
        scale[np.ix_(going, amplitudes)] = np.maximum(size, FLOOR * largest[going])[:, None]
        s = scale[going]
        w, own = _over(x[going], s), _unit(_over(tangent[going], s))
        no = np.where(back[going], 0.0, np.nan)[:, None]
        before = _over(x_back[going], s) + no, _unit(_over(tangent_back[going], s))
        to = _stepped(curve, before, (w, own), s, h[going])
        good = to.good & ((to.orientation == orientation[going]) | (h[going] < CROSSING))
        wish = np.clip(0.9 * (AIM / care / np.maximum(to.off, 1e-16)) ** 0.25, 0.3, 2.5)
        wish = np.where(np.isfinite(wish), wish, 0.3)
        done = going[good]
        x_back[done], tangent_back[done], back[done] = x[done], tangent[done], True
        x[done], tangent[done] = _times(to.w[good], s[good]), _times(to.tangent[good], s[good])
        orientation[done] = to.orientation[good]
        for k in done:
            points[k].append(x[k].copy())
            tangents[k].append(tangent[k].copy())
            scales[k].append(scale[k].copy())
        longer = np.minimum(h[going] * wish, LONGEST / care)
        h[going] = np.where(good, longer, h[going] * np.minimum(wish, 0.5))
        side[done] = np.where(
            x[done, -1] >= high[done], 1, np.where(x[done, -1] <= low[done], -1, 0)
        )
        turned = done[(tangent[done, -1] > 0.0) != (tangent_back[done, -1] > 0.0)]
        if len(turned):
            s = scale[turned]
            ends = [_over(x_back[turned], s), _unit(_over(tangent_back[turned], s))]
            ends += [_over(x[turned], s), _unit(_over(tangent[turned], s))]
            outside = _outside(curve, bows(*ends), s, low[turned], high[turned])
            for k, (which, fold, along) in zip(turned, outside, strict=True):
                if which:
                    points[k][-1], tangents[k][-1] = _times(fold, scale[k]), _times(along, scale[k])
                    side[k] = which
        going = going[(side[going] == 0) & (h[going] > SHORTEST)]
    d = scale.shape[1]
    return [
        Arc(np.array(a), np.array(t), np.array(q).reshape(-1, d), int(side[k]), orientation[k])
        for k, (a, t, q) in enumerate(zip(points, tangents, scales, strict=True))
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


def landed(
    curve: Curve, arcs: list[Arc], plane: NDArray[np.float64]
) -> tuple[list[Arc], NDArray[np.bool_]]:
    """The pieces cut where p comes to a value in their last step, and whether a point is there.

    Where it begins there, the next time counts.
    """
    bow, scale = steps_of(arcs, slice(-1, None))
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
        whole = (ends.h > 1e-9)[:, None]
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
    # It leaves there: p goes on in the direction in which it came to the value.
    outward = np.zeros_like(w)
    outward[:, -1] = np.where(upward, 1.0, -1.0)
    with np.errstate(all="ignore"):
        _, tangent, sign = bordered(curve, w, scale, outward)
    steady &= sign == np.array([a.orientation for a in arcs])
    cut = []
    for k, a in enumerate(arcs):
        points, tangents = a.points.copy(), a.tangents.copy()
        points[-1], tangents[-1] = _times(w[k], scale[k]), _times(tangent[k], scale[k])
        cut.append(a._replace(points=points, tangents=tangents))
    return cut, steady
