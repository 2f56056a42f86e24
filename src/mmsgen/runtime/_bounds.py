"""How many equilibria there are at least, from the exponents alone and within milliseconds.

The mixed volume, which is the number of solutions for generic coefficients, does not increase when
terms are left out. Where the terms that are left make the equations triangular, a block of unknowns
after the other, it is the product over the blocks, each taken with the unknowns of the blocks
before it as constants (Ewald, *Combinatorial Convexity and Algebraic Geometry*, 1996, chapter IV).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from ._starts import generic_solutions
from ._systems import System

__all__ = ["least_count"]

Support = Sequence[tuple[int, ...]]

PAIR = 4
"""Unknowns of two amplitudes: as many as are counted by following paths."""


@lru_cache(maxsize=256)
def least_count(system: System) -> int:
    """A lower bound for the number of solutions that generic coefficients have.

    Parameters
    ----------
    system : System

    Returns
    -------
    int
        Zero where nothing is known.
    """
    p = len(system.active)
    fixed = [k for k, a in enumerate(system.active) if a in system.fixed]
    first = [fixed] if fixed else [[k] for k in range(p)]
    pairs = [sorted({*group, k}) for group in first for k in range(p) if k not in group]
    plain = max((_triangular(system, group) for group in first), default=0)
    # Pairs are counted by following paths: those that occur again, relabelled, are counted once.
    coupled = (_triangular(system, pair) for pair in pairs if len(_own(system, pair)) <= PAIR)
    return max(plain, max(coupled, default=0) if p > 2 else 0)


def _own(system: System, group: list[int]) -> list[int]:
    """Unknowns of a block of amplitudes."""
    return [u for k in group for u in system.places[k] if u >= 0]


def _triangular(system: System, first: list[int]) -> int:
    """The product over the first block and then one amplitude after the other."""
    known = [*_own(system, first), *range(system.logs, system.d)]
    product = _block(system, first, known, [])
    left = [k for k in range(len(system.active)) if k not in first]
    while product and left:
        counts = [_block(system, [k], _own(system, [k]), known) for k in left]
        best = counts.index(max(counts))
        product *= counts[best]
        known += _own(system, [left.pop(best)])
    return product


def _block(system: System, group: list[int], unknowns: list[int], known: list[int]) -> int:
    """How many solutions the equations of a block have, later unknowns left out of them."""
    count = len(system.active)
    sizes = [k for k in range(count) if system.places[k][2] >= 0]
    rows = [2 * k + side for k in group for side in (0, 1)]
    rows += [2 * count + sizes.index(k) for k in group if k in sizes]
    later = [u for u in range(system.d) if u not in unknowns and u not in known]
    terms = {
        (rows.index(row), tuple(e[u] for u in unknowns))
        for row, e in system.terms
        if row in rows and not any(e[u] for u in later)
    }
    if len(rows) != len(unknowns):
        return 0
    supports = [sorted(e for row, e in terms if row == i) for i in range(len(rows))]
    if any(len(support) < 2 for support in supports):
        return 0
    if len(unknowns) == 2:
        return _mixed_area(supports[0], supports[1])
    whole = tuple(sorted(terms))
    plain = sum(u < system.logs for u in unknowns)
    return int(generic_solutions(whole, len(unknowns), plain)[1].shape[1])


def _mixed_area(p: Support, q: Support) -> int:
    """How many common solutions, neither unknown zero, two generic equations have."""
    both = sorted({(a + c, b + d) for a, b in p for c, d in q})
    return (_doubled(both) - _doubled(p) - _doubled(q)) // 2


def _doubled(points: Support) -> int:
    """Twice the area of the convex hull of sorted points."""
    hull: list[tuple[int, ...]] = []
    for side in (points, points[::-1]):
        start = len(hull)
        for x, y in side:
            while len(hull) > start + 1 and _turn(hull[-2], hull[-1], (x, y)) <= 0:
                hull.pop()
            hull.append((x, y))
        hull.pop()
    return sum(x * v - u * y for (x, y), (u, v) in zip(hull, [*hull[1:], *hull[:1]], strict=True))


def _turn(a: tuple[int, ...], b: tuple[int, ...], c: tuple[int, ...]) -> int:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
