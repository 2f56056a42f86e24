"""Points of branches at given values of the parameter, between equilibria that are known."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._arcs import steps_of
from ._bows import Bow, bows
from ._charts import Chart, equations, unpack
from ._curves import Curve, across, turning
from ._nets import Link, Net
from ._paths import solve

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Samples", "mirrored", "samples", "samples_at_rest"]


class Samples(NamedTuple):
    """Points of links: which link, how far along it, p, real unknowns.

    Then whether p turns there, and whether it is a given value.
    """

    link: NDArray[np.int64]
    along: NDArray[np.float64]
    p: NDArray[np.float64]
    x: NDArray[np.float64]
    fold: NDArray[np.bool_]
    given: NDArray[np.bool_]

    def pick(self, rows: Any) -> Samples:
        """Some of them."""
        parts: list[Any] = [part[rows] for part in self]
        return Samples(*parts)

    def and_then(self, other: Samples) -> Samples:
        """These, and others behind them."""
        parts: list[Any] = [np.concatenate(pair) for pair in zip(self, other, strict=True)]
        return Samples(*parts)


def _bows(links: list[Link]) -> tuple[Bow, NDArray[Any], NDArray[np.int64], NDArray[np.float64]]:
    """Steps of all links, their scales, their links and their places along these."""
    bow, scale = steps_of([link.arc for link in links])
    number = [len(link.arc.scale) for link in links]
    owner = np.repeat(np.arange(len(links)), number)
    place = np.concatenate([np.arange(n, dtype=np.float64) for n in number])
    return bow, scale, owner, place


HALVINGS = 5
"""How often the pieces beside a turn are halved towards it."""

PROBES = 4
"""Into how many parts each step of a curve is cut, to see bifurcations between given values."""

AT_REST = 16
"""Points between two sections, at the least, where all amplitudes are zero."""

SINGULAR = 1e-9
"""Singular values of a Jacobian below this, over the largest, are zero."""

AT_FOLD = 2e-13
"""A given value that is closer to a turn is there, over the range."""


def samples(net: Net, p: NDArray[np.float64], c: NDArray[np.complex128]) -> Samples:
    """Points of all links at the given values between the nodes, between these, and their folds."""
    curve = net.curve
    bow, scale, owner, place = _bows(net.links)
    turns = (bow.slope[:, -1] > 0.0) != (bow.end[:, -1] > 0.0)
    k, plain = np.flatnonzero(turns), np.flatnonzero(~turns)
    w, tangent = turning(curve, bow.pick(k), scale[k])
    near, step, begin, length = _towards(curve, bow.pick(k), scale[k], w, tangent)
    whole = Bow(*(np.concatenate((x[plain], y)) for x, y in zip(bow, near, strict=True)))
    pieces = np.concatenate((plain, k[step]))
    along = np.concatenate((place[plain], place[k[step]] + begin))
    lengths = np.concatenate((np.ones(len(plain)), length))
    parts = whole, scale[pieces], owner[pieces], along, lengths
    sampled = _dense(curve, *parts, p, c).and_then(_probes(curve, *parts))
    width = curve.high - curve.low
    at = w[:, -1] * width
    nearest = p[np.abs(p[:, None] - at).argmin(axis=0)] if len(at) else at
    there = np.abs(nearest - at) < AT_FOLD * width
    at = np.where(there, nearest, at)
    no = np.zeros(len(k), bool)
    folds = Samples(owner[k], place[k] + 0.5, at, w[:, :-1] * scale[k], ~no, there)
    # The second half of a mirrored piece is the first one again.
    middle = _own_image(net.links, owner[k])
    stop = np.array([0.5 * (len(x.arc.points) - 1) if mirrored(x) else np.inf for x in net.links])
    stop[owner[k[middle]]] = place[k[middle]] + 0.5
    keep = sampled.along < stop[sampled.link]
    for i in range(len(k)):
        keep &= (sampled.link != owner[k[i]]) | (np.abs(sampled.p - at[i]) >= AT_FOLD * width)
    return sampled.pick(keep).and_then(folds.pick(folds.along < stop[folds.link]))


def _probes(
    curve: Curve,
    bow: Bow,
    scale: NDArray[np.float64],
    owner: NDArray[np.int64],
    begin: NDArray[np.float64],
    length: NDArray[np.float64],
) -> Samples:
    """Points in steps along which p does not turn, wherever they are."""
    share = np.tile(np.arange(PROBES) / PROBES, len(owner))
    step = np.repeat(np.arange(len(owner)), PROBES)
    own = bow.pick(step)
    # Across the curve: with p held fixed one may come to another sheet close by.
    w, _ = across(curve, own.at(share), scale[step], own.towards(share), 3)
    p = w[:, -1] * (curve.high - curve.low)
    keep = (p > curve.low) & (p < curve.high) & ((begin[step] > 0.0) | (share > 0.0))
    step, share, p = step[keep], share[keep], p[keep]
    x = w[keep, :-1] * scale[step]
    no = np.zeros(len(step), bool)
    return Samples(owner[step], begin[step] + length[step] * share * 0.999, p, x, no, no)


def _towards(
    curve: Curve,
    bow: Bow,
    scale: NDArray[np.float64],
    w: NDArray[np.float64],
    tangent: NDArray[np.float64],
) -> tuple[Bow, NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    """Steps with a turn in pieces; the step of each, where in it that begins, and its length.

    Close to a turn p goes like the square of the distance s. What a cubic errs by goes like s²
    as well, so that the two sides, which are 2s apart, would be taken for each other where p
    changes little along the whole step. With each halving that error falls by sixteen, and s²
    by four.
    """
    sides = bows(bow.first, bow.slope, w, tangent), bows(w, tangent, bow.last, bow.end)
    shares = 0.5 ** np.arange(1, HALVINGS + 1)
    stops = np.concatenate(([0.0], 1.0 - shares, [1.0], 1.0 + shares[::-1], [2.0]))
    points, slopes = [], []
    for stop in stops:
        side = sides[int(stop > 1.0)]
        u = np.full(len(w), stop - float(stop > 1.0))
        at, direction = side.at(u), side.towards(u)
        if stop % 1.0:
            at, direction = across(curve, at, scale, direction)
        elif stop == 1.0:
            at, direction = w, tangent
        points.append(at)
        slopes.append(direction)
    parts = [points[:-1], slopes[:-1], points[1:], slopes[1:]]
    number = len(stops) - 1
    return (
        bows(*(np.concatenate(part) for part in parts)),
        np.tile(np.arange(len(w)), number),
        np.repeat(0.5 * stops[:-1], len(w)),
        np.repeat(0.5 * np.diff(stops), len(w)),
    )


def _own_image(links: list[Link], owner: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Of turns in order along their links: those at the point of a mirrored piece without image.

    It is the middle one: on either side of it are the images of what is on the other.
    """
    out = np.zeros(len(owner), dtype=bool)
    for k, link in enumerate(links):
        own = np.flatnonzero(owner == k)
        if mirrored(link) and len(own) % 2:
            out[own[len(own) // 2]] = True
    return out


def mirrored(link: Link) -> bool:
    """Whether a piece comes back to an image of where it began, through a point that has none."""
    return (link.start, link.start_side) == (link.end, link.end_side)


def _dense(
    curve: Curve,
    bow: Bow,
    scale: NDArray[np.float64],
    owner: NDArray[np.int64],
    begin: NDArray[np.float64],
    length: NDArray[np.float64],
    p: NDArray[np.float64],
    c: NDArray[np.complex128],
) -> Samples:
    """Points at the given values in steps along which p does not turn."""
    width = curve.high - curve.low
    ends = np.stack((bow.first[:, -1], bow.last[:, -1])) * width
    low = np.searchsorted(p, ends.min(axis=0) + 1e-14 * width, side="right")
    high = np.searchsorted(p, ends.max(axis=0) - 1e-14 * width, side="left")
    number = np.maximum(high - low, 0)
    step = np.repeat(np.arange(len(owner)), number)
    first = np.cumsum(number) - number
    index = np.arange(len(step)) - first[step] + low[step]
    own = bow.pick(step)
    u = own.where(p[index] / width)
    x = own.at(u, slice(None, -1)) * scale[step]
    x = _polished(curve.place, c[index], x, scale[step])
    along = begin[step] + length[step] * u * 0.999
    no = np.zeros(len(step), bool)
    return Samples(owner[step], along, p[index], x, no, ~no)


def _polished(
    place: Chart, c: NDArray[Any], x: NDArray[np.float64], scale: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Newton's method at given coefficients, each point until it is there."""
    first, x = x, x.copy()
    own = c[:, list(place.columns)]
    todo = np.arange(len(x))
    with np.errstate(all="ignore"):
        for _ in range(8):
            if not len(todo):
                break
            f, matrices = equations(place, own[todo], *unpack(place, x[todo]))
            step = -solve(matrices, f[..., None])[..., 0]
            good = np.isfinite(step).all(axis=1)
            x[todo[good]] += step[good]
            # Newton's method doubles the digits: what is left is below the rounding.
            todo = todo[good & (np.abs(step / scale[todo]).max(axis=1) > 1e-9)]
        x[todo] = first[todo]
        for _ in range(3 if len(todo) else 0):
            # Where curves cross, nothing but rounding leads along the null vector.
            f, matrices = equations(place, own[todo], *unpack(place, x[todo]))
            finite = np.isfinite(matrices).all(axis=(1, 2))
            todo, f, matrices = todo[finite], f[finite], matrices[finite]
            x[todo] -= (np.linalg.pinv(matrices, rcond=SINGULAR) @ f[..., None])[..., 0]
    return x


def samples_at_rest(net: Net, p: NDArray[np.float64], sections: NDArray[np.float64]) -> Samples:
    """All values between the nodes of amplitudes that are all zero, and others where few are."""
    links, along, values, given = [], [], [], []
    for k, link in enumerate(net.links):
        ends = sorted(float(sections[net.section[node]]) for node in (link.start, link.end))
        inside = p[(p > ends[0]) & (p < ends[1])]
        if len(inside) < AT_REST:
            inside = np.union1d(inside, np.linspace(ends[0], ends[1], AT_REST + 2)[1:-1])
            inside = inside[(inside >= p[0]) & (inside <= p[-1])]
        inside = inside if link.start_side > 0 else inside[::-1]
        given.append(np.isin(inside, p))
        links.append(np.full(len(inside), k))
        along.append(np.arange(len(inside), dtype=np.float64))
        values.append(inside)
    count = sum(map(len, values))
    return Samples(
        np.concatenate(links),
        np.concatenate(along),
        np.concatenate(values),
        np.zeros((count, 0)),
        np.zeros(count, bool),
        np.concatenate(given),
    )
