"""Phases that carry equilibria of a slow flow into others: B → −B, the m phases of a subharmonic.

Turns along a symmetry are left out: along it an equilibrium is a circle, one point of which counts.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import combinations, product
from typing import TYPE_CHECKING, Any

import numpy as np

from ._charts import Chart, normal

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["images", "turned"]


def _reduced(rows: list[list[int]]) -> list[list[int]]:
    """A basis of the integer combinations of the rows."""
    rows = [list(r) for r in rows if any(r)]
    basis: list[list[int]] = []
    width = len(rows[0]) if rows else 0
    for column in range(width):
        while True:
            own = sorted((r for r in rows if r[column]), key=lambda r: abs(r[column]))
            if len(own) < 2:
                break
            for r in own[1:]:
                times = r[column] // own[0][column]
                r[:] = [a - times * b for a, b in zip(r, own[0], strict=True)]
        if own:
            basis.append(own[0])
            rows = [r for r in rows if r is not own[0] and any(r)]
    return basis


def _minors(basis: list[list[int]]) -> int:
    """The greatest common divisor of the largest minors: how many classes of phases there are."""
    size = len(basis)
    found = 0
    for columns in combinations(range(len(basis[0])), size) if size else ():
        minor = [[row[k] for k in columns] for row in basis]
        found = int(np.gcd(found, abs(round(float(np.linalg.det(np.array(minor, float)))))))
    return max(found, 1)


@lru_cache(maxsize=256)
def images(place: Chart) -> tuple[tuple[float, ...], ...]:
    """Phases φ, in turns, with which B_j e^{2πiφ_j} is an equilibrium as well; zero comes first."""
    flow, p = place.flow, len(place.active)
    rows = [[e[3 * k] - e[3 * k + 1] - (k == j) for k in range(p)] for j, e in flow.terms]
    basis = _reduced(rows)
    order = _minors(basis)
    matrix = np.array(basis, dtype=np.int64).reshape(len(basis), p)
    generic = 1.0 + np.arange(p) + 1j * np.sqrt(2.0 + np.arange(p))
    found: list[tuple[float, ...]] = []
    points: list[NDArray[np.complex128]] = []
    for choice in product(range(order), repeat=p):
        if np.any((matrix @ np.array(choice)) % order):
            continue
        phases = tuple(k / order for k in choice)
        point = turned(place, generic, phases)
        if not any(np.abs(point - q).max() < 1e-6 for q in points):
            found.append(phases)
            points.append(point)
    return tuple(found)


def turned(place: Chart, b: NDArray[Any], phases: Any) -> NDArray[np.complex128]:
    """The points with these phases added, in normal form."""
    return normal(place, b * np.exp(2j * np.pi * np.asarray(phases)))
