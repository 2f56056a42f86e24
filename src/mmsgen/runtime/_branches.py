"""Equilibria along one parameter: branches in order, through folds, and their bifurcations."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._charts import normal
from ._curves import Curve
from ._flow import Flow
from ._images import images
from ._nets import Net, joined, nets
from ._points import Points, bifurcations, points_of
from ._records import Bifurcation, Branch, Response
from ._samples import Samples, mirrored, samples, samples_at_rest
from ._sections import sections_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["response_of"]


def response_of(
    flow: Flow, coefficients: Callable[[Any], Any], values: Any, name: str = ""
) -> Response:
    """All equilibria along one parameter, their branches and bifurcations.

    Parameters
    ----------
    flow : Flow
    coefficients : callable
        Values of the parameter, shape (K,) → coefficients, shape (K, terms). It is called for
        values between the smallest and the largest of `values`.
    values : array_like
        Of the parameter, one-dimensional, in any order.
    name : str
        Of the parameter.

    Returns
    -------
    Response
        The points of a branch are at the given values, in order along the curve, which may turn
        back at folds; these are points of it as well. Of equilibria that are carried into each
        other by B → −B, or by the phases of a subharmonic, one is there.

    Raises
    ------
    ValueError
        If the values are not a one-dimensional array of finite numbers, or as
        `equilibria_of_one` and `equilibria_of_many`.

    Notes
    -----
    All equilibria are computed at 48 values, twice as many where their number changes; for one
    amplitude at 2048; where fewer are given, at others between them too. From there the branches
    are followed. A closed branch between two neighbouring ones of these values is seen where its
    extremum of the relation between amplitude and parameter is there at the values beside it, for
    several amplitudes where complex equilibria approach each other towards it from both sides.

    Bifurcations are looked for along the branches at more points than the given ones, so that they
    do not depend on these; two of a kind within a quarter of a step may be missed.
    Circles are not followed that belong to a symmetry which one amplitude has at single values
    only, as without its force.
    """
    given = np.asarray(values)
    if given.ndim != 1 or given.dtype.kind not in "iuf" or not np.isfinite(given).all():
        raise ValueError("the values of the parameter must be a one-dimensional array of numbers")
    p = np.unique(given.astype(np.float64))
    if not len(p):
        return Response(name, (), ())

    def numbers(x: Any) -> NDArray[np.complex128]:
        c = np.asarray(coefficients(np.asarray(x)), dtype=np.complex128)
        return np.broadcast_to(c, (len(x), c.shape[-1]))

    c = numbers(p)
    finite = np.isfinite(c).all(axis=-1)
    p, c = p[finite], c[finite]
    if not len(p):
        return Response(name, (), ())
    with np.errstate(all="ignore"):
        return _followed(flow, numbers, p, c, name)


def _followed(
    flow: Flow,
    numbers: Callable[[Any], NDArray[np.complex128]],
    p: NDArray[np.float64],
    c: NDArray[np.complex128],
    name: str,
) -> Response:
    """The response at ascending values and the coefficients there."""
    sections, found = sections_of(flow, numbers, p)
    parts = nets(flow, numbers, sections, found, (float(p[0]), float(p[-1])))
    raw: list[_Raw] = []
    for net in parts:
        if len(sections) > 1:
            joined(net, sections)
        raw += _branches(flow, net, p, c, sections)
    size = float(np.nanmax(np.abs(found.amplitudes), initial=0.0)) or 1.0
    marks = bifurcations([(flow, r.curve, r.points) for r in raw], size, float(p[-1] - p[0]))
    marks = tuple(m for m in marks if p[0] <= m.parameter <= p[-1])
    branches = [_finished(r, marks, p) for r in raw]
    long = [b for b in branches if len(b.parameter) > 1 or len(p) == 1]
    alone = [b for b in branches if len(b.parameter) == 1 < len(p) and not _on_any(b, long, size)]
    return Response(name, (*long, *alone), marks)


class _Raw(NamedTuple):
    """A branch whose ends are open where it begins at a point that is its own mirror image."""

    curve: Curve
    points: Points
    open: tuple[bool, bool]


# --- branches -------------------------------------------------------------------------------------


def _branches(
    flow: Flow,
    net: Net,
    p: NDArray[np.float64],
    c: NDArray[np.complex128],
    sections: NDArray[np.float64],
) -> list[_Raw]:
    """The branches of a net, at the given values and at their folds."""
    place = net.curve.place
    at = sections[net.section]
    no = np.zeros(len(at), bool)
    nodes = Samples(
        np.full(len(at), -1), np.zeros(len(at)), at, np.array(net.x), no, np.isin(at, p)
    )
    if net.links:
        between = samples(net, p, c) if place.active else samples_at_rest(net, p, sections)
        order = np.lexsort((between.along, between.link))
        between = between.pick(order)
        every = nodes.and_then(between)
    else:
        between, every = nodes, nodes
    points = points_of(flow, net.curve, every.p, every.x, every.fold, every.given)
    count = len(at)
    inner = [
        count + np.flatnonzero(between.link == k) if net.links else np.zeros(0, int)
        for k in range(len(net.links))
    ]
    branches = []
    for chain in _chains(net):
        index, phases = _along(net, chain, inner)
        own = points.pick(index)
        if place.active:
            turned = own.amplitudes.copy()
            turned[:, list(place.active)] = normal(
                place, own.amplitudes[:, list(place.active)] * np.exp(2j * np.pi * phases)
            )
            own = own._replace(amplitudes=turned)
        steps = chain[1]
        first = bool(steps) and steps[0][1] and _terminal(net, steps[0][0])
        last = bool(steps) and not steps[-1][1] and _terminal(net, steps[-1][0])
        # A fold beyond the given values parts what is within them.
        beyond = own.fold & ((own.parameter < p[0]) | (own.parameter > p[-1]))
        stops = np.concatenate(([-1], np.flatnonzero(beyond), [len(beyond)]))
        for a, b in pairwise(stops):
            ends = first and a < 0, last and b == len(beyond)
            branches.append(_Raw(net.curve, own.pick(slice(a + 1, b)), ends))
    return branches


def _finished(raw: _Raw, marks: tuple[Bifurcation, ...], p: NDArray[np.float64]) -> Branch:
    """The branch, its open ends led on to the bifurcations where they come from."""
    place = raw.curve.place
    out = Branch(*raw.points.pick(raw.points.given | raw.points.fold)[:4])
    for k, is_open in zip((0, -1), raw.open, strict=True):
        if not is_open:
            continue
        at = float(raw.points.parameter[k])
        near = int(np.clip(np.searchsorted(p, at), 1, len(p) - 1))
        reach = 1.5 * float(np.diff(p[max(near - 2, 0) : near + 3]).max())
        b = raw.points.amplitudes[k]
        found = [
            m
            for m in marks
            if m.kind in ("pitchfork", "Hopf")
            and abs(m.parameter - at) <= reach
            and set(np.flatnonzero(np.abs(m.amplitudes))) < set(place.active)
        ]
        if not found:
            continue
        mark = min(found, key=lambda m: abs(m.parameter - at))
        points = np.tile(mark.amplitudes, (len(images(place)), 1))
        own = list(place.active)
        points[:, own] *= np.exp(2j * np.pi * np.array(images(place)))
        end = points[np.argmin(np.abs(points - b).max(axis=1))]
        parts = (np.array([mark.parameter]), end[None], mark.drift[None], np.zeros(1))
        pairs = [(x, y) if k == 0 else (y, x) for x, y in zip(parts, out, strict=True)]
        out = Branch(*(np.concatenate(pair) for pair in pairs))
    return out


def _on_any(point: Branch, others: list[Branch], size: float) -> bool:
    """Whether a single point lies on one of the other branches."""
    for other in others:
        same = other.parameter == point.parameter[0]
        gap = np.abs(np.abs(other.amplitudes[same]) - np.abs(point.amplitudes)).max(axis=1)
        if np.any(gap < 1e-6 * size):
            return True
    return False


Step = tuple[int, bool]
"""A link and whether it is passed from its end to its start."""


def _chains(net: Net) -> list[tuple[int, list[Step]]]:
    """First nodes, and the links that follow each other from there; every link occurs once.

    Where a branch ends in a link, the number of nodes and that of the link together stand for its
    end.
    """
    count = len(net.section)
    ends: dict[tuple[int, int], Step] = {}
    for k, link in enumerate(net.links):
        ends.setdefault((link.start, link.start_side), (k, False))
        other = (count + k, 0) if _terminal(net, k) else (link.end, link.end_side)
        ends.setdefault(other, (k, True))
    used: set[int] = set()
    reached: set[int] = set()
    chains = []

    def section(node: int) -> int:
        return net.section[node if node < count else net.links[node - count].start]

    def free(node: int) -> list[int]:
        return [s for s in (1, 0, -1) if (node, s) in ends and ends[node, s][0] not in used]

    def walk(node: int) -> list[Step]:
        steps: list[Step] = []
        reached.add(node)
        sides = free(node)
        while sides:
            k, back = ends[node, sides[0]]
            used.add(k)
            steps.append((k, back))
            link = net.links[k]
            node = link.start if back else (count + k if _terminal(net, k) else link.end)
            reached.add(node)
            sides = free(node)
        return steps

    order = [*range(count), *(count + k for k in range(len(net.links)) if _terminal(net, k))]
    order.sort(key=lambda node: (section(node), node))
    for most in (1, 2):  # first those that end somewhere, then the closed ones
        for node in order:
            if node not in reached and len(free(node)) <= most:
                chains.append((node, walk(node)))
    return chains


def _terminal(net: Net, k: int) -> bool:
    """Whether a branch ends in a link."""
    return mirrored(net.links[k]) or net.links[k].end < 0


def _along(
    net: Net, chain: tuple[int, list[Step]], inner: list[NDArray[np.int64]]
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Points of a chain in order, and the phases by which each of them is turned."""
    node, steps = chain
    width, count = len(net.curve.place.active), len(net.section)
    phase = np.zeros(width)
    index = [np.array([node] if node < count else [], dtype=np.int64)]
    phases = [np.zeros((len(index[0]), width))]
    for k, back in steps:
        link, ends = net.links[k], _terminal(net, k)
        own = inner[k][::-1] if back else inner[k]
        shift = np.zeros(width) if ends else np.array(link.phases)
        phase = phase - shift if back else phase
        index.append(own)
        phases.append(np.tile(phase, (len(own), 1)))
        phase = phase if back else phase + shift
        if back or not ends:
            index.append(np.array([link.start if back else link.end]))
            phases.append(phase[None])
    return np.concatenate(index), np.concatenate(phases)
