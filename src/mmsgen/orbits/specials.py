"""Folds and bifurcations between two orbits of a family: told by signs, then located.

| kind | what changes its sign |
|---|---|
| fold | the tangent's part along the parameter |
| branch point | det(Φ − 1), without a fold |
| period doubling | det(Φ + 1) |
| Neimark–Sacker | Π_{i<j} (μ_i μ_j − 1), with a pair of complex multipliers on the unit circle |

Φ is the monodromy matrix, of an autonomous system across the orbit.

Source: Kuznetsov, *Elements of Applied Bifurcation Theory* (2004), ch. 10 (test functions).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from ..errors import OrbitError
from .collocation import Setting
from .records import PeriodicOrbit, transverse

if TYPE_CHECKING:
    from .following import Point

__all__ = ["Special", "located", "root", "tests"]

KINDS = ("fold", "branch point", "period doubling", "Neimark-Sacker")

EVALUATIONS = 40
"""Orbits at most, to locate one point."""

SHARP = 1e-11
"""Width of the bracket, over the step, from which a point counts as located."""

ON_CIRCLE = 1e-6
"""Distance of a located pair of multipliers from the unit circle."""


@dataclass(frozen=True, eq=False)
class Special:
    """A fold or bifurcation of a family of orbits.

    Attributes
    ----------
    kind : str
        ``"fold"``, ``"branch point"``, ``"period doubling"`` or ``"Neimark-Sacker"``.
    value : float
        Of the parameter.
    error : float
        Estimated error of `value`.
    orbit : PeriodicOrbit
    """

    kind: str
    value: float
    error: float
    orbit: PeriodicOrbit = field(repr=False)


def tests(point: Point) -> dict[str, float]:
    """The test functions at one point of a family."""
    solved = point.solved
    setting: Setting = solved.setting
    own = setting.of(solved.curve.value)
    matrix = transverse(own, solved.curve, solved.pair[1].monodromy, setting.scale)
    # Multipliers beyond all bounds, as near a homoclinic orbit, leave NaN, which has no sign.
    finite = bool(np.isfinite(matrix).all())
    values = np.linalg.eigvals(matrix) if finite else np.array([np.nan])
    with np.errstate(all="ignore"):
        pairs = [a * b - 1 for a, b in combinations(values, 2)]
        return {
            "fold": point.tangent.value / setting.unit,
            "branch point": float(np.prod(values - 1).real),
            "period doubling": float(np.prod(values + 1).real),
            "Neimark-Sacker": float(np.prod(pairs).real) if pairs else 1.0,
        }


def located(
    between: Callable[[float], Point],
    first: Mapping[str, float],
    second: Mapping[str, float],
    length: float,
) -> list[Special]:
    """All special points between two neighbours, in their order along the family.

    Parameters
    ----------
    between : callable
        Distance from the first one → point.
    first, second : mapping
        Their test functions.
    length : float
        Their distance.
    """
    changed = [k for k in KINDS if first[k] * second[k] < 0]
    if "fold" in changed and "branch point" in changed:
        changed.remove("branch point")
    found = []
    for kind in changed:
        try:
            share, point = root(
                lambda s, kind=kind: _tested(between(s), kind),  # type: ignore[misc]
                (0.0, first[kind]),
                (length, second[kind]),
            )
        except OrbitError:
            continue
        orbit = point.solved.orbit()
        if kind == "Neimark-Sacker" and not _on_circle(orbit):
            continue
        error = point.solved.value_error
        found.append((share, Special(kind, point.value, error, orbit)))
    return [special for _, special in sorted(found, key=lambda pair: pair[0])]


def _tested(point: Point, kind: str) -> tuple[float, Point]:
    return tests(point)[kind], point


def _on_circle(orbit: PeriodicOrbit) -> bool:
    """Whether a pair of complex multipliers has modulus 1, known well enough to say so."""
    own = orbit.multipliers
    near = np.abs(np.abs(own) - 1) < ON_CIRCLE + orbit.multiplier_errors
    sure = orbit.multiplier_errors < ON_CIRCLE
    return bool(np.any(near & sure & (np.abs(own.imag) > ON_CIRCLE)))


def root(
    function: Callable[[float], tuple[float, Point]],
    low: tuple[float, float],
    high: tuple[float, float],
) -> tuple[float, Point]:
    """Where a function changes its sign, by the Illinois form of the rule of false position."""
    (a, fa), (b, fb) = low, high
    width, size = abs(b - a), max(abs(fa), abs(fb))
    side = 0
    for _ in range(EVALUATIONS):
        c = (a * fb - b * fa) / (fb - fa)
        fc, point = function(c)
        if abs(fc) < 1e-14 * size or abs(b - a) < SHARP * width:
            break
        if fa * fc > 0:
            moved = abs(c - a)
            a, fa = c, fc
            fb, side = (fb / 2, -1) if side == -1 else (fb, -1)
        else:
            moved = abs(c - b)
            b, fb = c, fc
            fa, side = (fa / 2, 1) if side == 1 else (fa, 1)
        if moved < SHARP * width:
            break
    return c, point
