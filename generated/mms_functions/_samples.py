"""Points of branches at given values of the parameter, between equilibria that are known."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._arcs import Curve, turning
from ._bows import Bow, bows
from ._charts import Chart, equations, unpack
from ._nets import Link, Net
from ._paths import solve

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Samples", "mirrored", "samples", "samples_at_rest"]


class Samples(NamedTuple):
    """Points of links: which link, how far along it, p, real unknowns, whether p turns there."""

    link: NDArray[np.int64]
    along: NDArray[np.float64]
    p: NDArray[np.float64]
    x: NDArray[np.float64]
    fold: NDArray[np.bool_]

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
    first, slope, last, end, scale, owner, place = [], [], [], [], [], [], []
    for k, link in enumerate(links):
        arc = link.arc
        first.append(arc.points[:-1])
        slope.append(arc.tangents[:-1])
        last.append(arc.points[1:])
        end.append(arc.tangents[1:])
        steps = len(arc.points) - 1
        scale.append(np.repeat(arc.scale[None], steps, axis=0))
        owner.append(np.full(steps, k))
        place.append(np.arange(steps, dtype=np.float64))
    bow = bows(*(np.concatenate(x) for x in (first, slope, last, end)))
    return bow, np.concatenate(scale), np.concatenate(owner), np.concatenate(place)


def samples(net: Net, p: NDArray[np.float64], c: NDArray[np.complex128]) -> Samples:
    """Points of all links at the given values between the nodes, and their folds."""
    curve = net.curve
    bow, scale, owner, place = _bows(net.links)
    back = np.array([mirrored(link) for link in net.links])[owner]
    turns = (bow.slope[:, -1] > 0.0) != (bow.end[:, -1] > 0.0)
    k = np.flatnonzero(turns & ~back)
    w, tangent = turning(curve, bow.pick(k), scale[k])
    # A step with a fold becomes two, up to it and from it.
    parts = [np.concatenate((part, part[k])) for part in bow[:4]]
    for part, value in zip(parts, (w, tangent, w, tangent), strict=True):
        part[len(owner) :] = value
    parts[2][k], parts[3][k] = w, tangent
    parts[2][len(owner) :], parts[3][len(owner) :] = bow.last[k], bow.end[k]
    whole = bows(*parts)
    scales, owners = np.concatenate((scale, scale[k])), np.concatenate((owner, owner[k]))
    places = np.concatenate((place, place[k] + 0.5))
    sampled = _dense(curve, whole, scales, owners, places, p, c)
    folds = Samples(
        owner[k],
        place[k] + 0.5,
        w[:, -1] * (p[-1] - p[0]),
        w[:, :-1] * scale[k],
        np.ones(len(k), bool),
    )
    return sampled.and_then(folds)


def mirrored(link: Link) -> bool:
    """Whether a piece comes back to an image of where it began, through a point that has none."""
    return (link.start, link.start_side) == (link.end, link.end_side)


def _dense(
    curve: Curve,
    bow: Bow,
    scale: NDArray[np.float64],
    owner: NDArray[np.int64],
    place: NDArray[np.float64],
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
    half = np.where(place[step] % 1.0 > 0.0, 0.5, 1.0)
    half = np.where(np.isin(step, np.flatnonzero(_split(owner, place))), 0.5, half)
    return Samples(
        owner[step], place[step] + half * u * 0.999, p[index], x, np.zeros(len(step), bool)
    )


def _split(owner: NDArray[np.int64], place: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Steps that have been cut at a fold: their first halves."""
    cut = place % 1.0 > 0.0
    later = {(int(o), float(s)) for o, s in zip(owner[cut], place[cut] - 0.5, strict=True)}
    return np.array([(int(o), float(s)) in later for o, s in zip(owner, place)], dtype=bool)


def _polished(
    place: Chart, c: NDArray[Any], x: NDArray[np.float64], scale: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Newton's method at given coefficients, each point until it is there."""
    x = x.copy()
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
    return x


def samples_at_rest(net: Net, p: NDArray[np.float64], sections: NDArray[np.int64]) -> Samples:
    """All values between the nodes of amplitudes that are all zero."""
    links, along, values = [], [], []
    for k, link in enumerate(net.links):
        ends = sorted(int(sections[net.section[node]]) for node in (link.start, link.end))
        inside = p[ends[0] + 1 : ends[1]]
        inside = inside if link.start_side > 0 else inside[::-1]
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
    )
