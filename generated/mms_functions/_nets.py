"""Equilibria at some values of a parameter, and the pieces of curves that join them.

All equilibria are computed at some sections; from each of them its curve is followed to the next
section, or back to the same one behind a fold. Where a curve arrives at an equilibrium that was not
in the list, that one is added.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._arcs import Arc, follow, landed
from ._charts import chart, normal, pack, unpack
from ._curves import Curve
from ._flow import Flow
from ._images import images, turned

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._records import Equilibria

__all__ = ["Link", "Net", "joined", "nets"]

SAME = 1e-5
"""Points that differ by less are one, over the larger of the two."""


class Link(NamedTuple):
    """A piece of a curve between two nodes.

    Attributes
    ----------
    start, end : int
        Nodes; −1 where the curve could not be followed to the end.
    start_side, end_side : int
        On which side of its section the piece leaves each node, −1 or 1.
    phases : tuple of float
        It ends at the image of the node `end` with these phases, in turns.
    arc : Arc
    """

    start: int
    start_side: int
    end: int
    end_side: int
    phases: tuple[float, ...]
    arc: Arc


class Net(NamedTuple):
    """Nodes and links whose amplitudes vanish alike.

    Attributes
    ----------
    curve : Curve
    section : list of int
        Of each node.
    x : list of numpy.ndarray
        Real unknowns of each node.
    links : list of Link
    """

    curve: Curve
    section: list[int]
    x: list[NDArray[np.float64]]
    links: list[Link]


def nets(
    flow: Flow,
    coefficients: Any,
    p: NDArray[np.float64],
    found: Equilibria,
    limits: tuple[float, float],
) -> list[Net]:
    """Nodes from the equilibria at all sections, of images of each other the first one.

    Parameters
    ----------
    flow : Flow
    coefficients : callable
        p → coefficients, shape (K,) → (K, terms).
    p : numpy.ndarray
        The sections, ascending.
    found : Equilibria
        At the sections.
    limits : tuple of float
        Ends of the range of p.
    """
    kinds: dict[tuple[int, ...], Net] = {}
    for i in range(len(p)):
        for b, drift in zip(found.amplitudes[i], found.drift[i], strict=True):
            if not np.isfinite(b).all():
                continue
            active = tuple(int(k) for k in np.flatnonzero(b))
            if active not in kinds:
                kinds[active] = Net(Curve(chart(flow, active), coefficients, *limits), [], [], [])
            net = kinds[active]
            place = net.curve.place
            rate = np.zeros(0)
            if place.drifts:
                rate = drift @ np.array(place.parts)
            own = b[list(active)]
            if _match(net, i, own) is None:
                net.section.append(i)
                net.x.append(pack(place, own, rate))
    return [kinds[k] for k in sorted(kinds, key=lambda k: (len(k), k))]


def _match(
    net: Net, section: int, b: NDArray[Any], x: Any = None
) -> tuple[int, tuple[float, ...]] | None:
    """The node of a section of which a point is an image, and the phases of the image."""
    place, size = net.curve.place, np.abs(b).max(initial=0.0)
    best, which = SAME, None
    here = normal(place, b)
    for node in range(len(net.section)):
        if net.section[node] != section:
            continue
        own = unpack(place, net.x[node])[0]
        for phases in images(place):
            gap = np.abs(turned(place, own, phases) - here).max(initial=0.0)
            if gap <= best * size:
                best, which = (gap / size if size else 0.0), (node, phases)
    return which


CARE = (1.0, 3.0, 10.0)
"""By which steps are shorter, the first time and where pieces contradict each other."""


def joined(net: Net, p: NDArray[np.float64]) -> None:
    """Follow the curves from all nodes in both directions, until each is linked or at an end.

    From each side of a node one curve leads, and to each side one: pieces that end at the same
    side of a node, or somewhere else when they are followed the other way, contradict each other.
    They are followed once more, with shorter steps.
    """
    for care in CARE:
        tried: set[_Side] = set()
        wrong: set[_Side] = set()
        side = 1
        for _ in range(12):
            linked = _linked(net)
            todo = [
                (node, side)
                for node, section in enumerate(net.section)
                if (node, side) not in linked and (node, side) not in tried
                if 0 <= section + side < len(p)
            ]
            tried |= set(todo)
            if todo:
                wrong |= _follow_all(net, p, todo, care)
            elif side < 0:
                break
            side = -side
        if not wrong or care == CARE[-1]:
            break
        net.links[:] = [
            k for k in net.links if not {(k.start, k.start_side), (k.end, k.end_side)} & wrong
        ]
    reached = {(k.end, k.end_side) for k in net.links}
    net.links[:] = [k for k in net.links if k.end >= 0 or (k.start, k.start_side) not in reached]


_Side = tuple[int, int]
"""A node, and on which side of its section."""


def _linked(net: Net) -> set[_Side]:
    links = net.links
    return {(k.start, k.start_side) for k in links} | {(k.end, k.end_side) for k in links}


def _follow_all(net: Net, p: NDArray[np.float64], todo: list[_Side], care: float) -> set[_Side]:
    """Follow curves from some sides of nodes; those whose pieces contradict others."""
    curve, place = net.curve, net.curve.place
    if not place.active:
        _straight(net, p, todo)
        return set()
    here = np.array([net.section[node] for node, _ in todo])
    side = np.array([s for _, s in todo])
    other = here + side
    bounds = p[np.minimum(here, other)], p[np.maximum(here, other)]
    x = np.array([net.x[node] for node, _ in todo])
    arcs = follow(curve, x, p[here], side.astype(float), bounds, care)
    ended = [k for k, a in enumerate(arcs) if a.side]
    steady = np.zeros(len(arcs), dtype=bool)
    goal = np.array([max(h, o) if a.side > 0 else min(h, o) for h, o, a in zip(here, other, arcs)])
    if ended:
        cut, good = landed(curve, [arcs[k] for k in ended], p[goal[ended]])
        for k, a, g in zip(ended, cut, good, strict=True):
            arcs[k], steady[k] = a, g
    taken = dict.fromkeys(_linked(net))
    wrong: set[_Side] = set()
    reached: dict[_Side, _Side] = {}
    for k, (node, start_side) in enumerate(todo):
        start = (node, start_side)
        if not steady[k]:
            wrong.add(start)
            if start not in reached:
                net.links.append(Link(node, start_side, -1, 0, (), arcs[k]))
            continue
        end_side = -start_side if goal[k] != here[k] else start_side
        b, rate = unpack(place, arcs[k].points[-1, :-1])
        found = _match(net, int(goal[k]), b)
        if found is None:
            net.section.append(int(goal[k]))
            net.x.append(pack(place, normal(place, b), rate))
            found = len(net.section) - 1, tuple(0.0 for _ in place.active)
        end = (found[0], end_side)
        if reached.get(start) == end:
            continue
        if start in reached or end in reached or end in taken:
            wrong |= {start, end}
        if start not in reached:
            net.links.append(Link(node, start_side, found[0], end_side, found[1], arcs[k]))
        reached.setdefault(end, start)
        reached.setdefault(start, end)
    return wrong


def _straight(net: Net, p: NDArray[np.float64], todo: list[tuple[int, int]]) -> None:
    """All amplitudes zero: the point stays where it is."""
    at = {section: node for node, section in enumerate(net.section)}
    for node, side in todo:
        section = net.section[node]
        ends = p[[section, section + side]] / (net.curve.high - net.curve.low)
        arc = Arc(ends[:, None], np.full((2, 1), float(side)), np.zeros((1, 0)), side, 1.0)
        if section + side in at:
            net.links.append(Link(node, side, at[section + side], -side, (), arc))
