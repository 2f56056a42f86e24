"""Closed branches of several amplitudes between two values at which all equilibria are computed.

Complex equilibria come in pairs of conjugates. Where the two meet they become real: at a fold, as
at both folds of a small closed branch. The square of the distance within a pair is smooth along the
parameter and goes to zero there, so that Newton's method finds the place from outside.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._flow import Flow
from ._many_amplitudes import ends
from ._paths import newton
from ._starts import generic_solutions
from ._systems import System, equilibrium_system, measured, patterns, raw_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["meetings"]

Coefficients = Callable[[Any], Any]

REAL = 1e-12
"""Squares of distances within a pair that are smaller are zero, over those of the unknowns."""

STEP = 1e-4
"""Of a difference by the parameter, over the way to the next value, or to the zero."""

BOLD, TIMID = 0.9, 0.01
"""Which part of Newton's step is taken, and the least where it led astray."""

CLOSE = 1e-6
"""A zero that is so close is known, over the way to the next value."""

MARCH = 40
"""Most steps towards a zero."""


class _Pairs(NamedTuple):
    """Pairs of complex equilibria on their way along the parameter, one of each.

    Attributes
    ----------
    row : numpy.ndarray
        The value where each began.
    way : numpy.ndarray
        What is between that and the next value, negative where that is a smaller one.
    p : numpy.ndarray
    z : numpy.ndarray
        Unknowns over the scales of the first value, shape (d, K).
    square, slope : numpy.ndarray
        Of the distance within the pair, and its derivative by p.
    tangent : numpy.ndarray
        Derivatives of z by p.
    part : numpy.ndarray
        Of Newton's step that is taken next.
    """

    row: NDArray[np.int64]
    way: NDArray[np.float64]
    p: NDArray[np.float64]
    z: NDArray[np.complex128]
    square: NDArray[np.float64]
    slope: NDArray[np.float64]
    tangent: NDArray[np.complex128]
    part: NDArray[np.float64]

    def pick(self, rows: Any) -> _Pairs:
        """Some of them."""
        parts: list[Any] = [x[..., rows] for x in self]
        return _Pairs(*parts)


class _Course(NamedTuple):
    """The equations along the parameter, in the scales of the value where a pair began."""

    system: System
    numbers: Coefficients
    factor: NDArray[np.float64]

    def corrected(
        self, row: NDArray[np.int64], p: NDArray[np.float64], z: NDArray[Any], steps: int
    ) -> tuple[NDArray[np.complex128], NDArray[np.bool_]]:
        """Newton's method at p, and whether it converged."""
        target = raw_of(self.system, self.numbers(p)) * self.factor[:, row]
        z, last, _ = newton(self.system.terms, target, z, self.system.logs, steps)
        return z, last < 1e-7

    def sloped(self, pairs: _Pairs, reach: NDArray[np.float64]) -> _Pairs:
        """With derivatives by a difference over that reach."""
        near, good = self.corrected(pairs.row, pairs.p + reach, pairs.z, 4)
        slope = (_square(self.system, near) - pairs.square) / reach
        return pairs._replace(slope=np.where(good, slope, np.nan), tangent=(near - pairs.z) / reach)


def meetings(flow: Flow, numbers: Coefficients, p: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values between neighbouring ones, each between two meetings of pairs.

    Parameters
    ----------
    flow : Flow
    numbers : callable
        p → coefficients, shape (K,) → (K, terms).
    p : numpy.ndarray
        Ascending.
    """
    found: list[float] = []
    with np.errstate(all="ignore"):
        for active in patterns(flow):
            if not active or len(p) < 2:
                continue
            up, down = _met(equilibrium_system(flow, active), numbers, p)
            for k in range(len(p) - 1):
                stops = np.sort(down[(down > p[k]) & (down < p[k + 1])])
                for begin in up[(up > p[k]) & (up < p[k + 1])]:
                    behind = stops[stops >= begin]
                    found += [0.5 * (begin + behind[0])] if len(behind) else []
    return np.unique(np.array(found, dtype=np.float64))


def _met(
    system: System, numbers: Coefficients, p: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Where pairs meet on the way up to the next value, and on the way down to it."""
    base, start = generic_solutions(system.terms, system.d, system.logs)
    if not start.shape[1]:
        return np.zeros(0), np.zeros(0)
    raw = raw_of(system, numbers(p))
    factor, _ = measured(system, raw)
    z = ends(system, base, start, raw * factor)[0]
    row, square = np.repeat(np.arange(len(p)), start.shape[1]), _square(system, z)
    kept = np.flatnonzero(np.isfinite(z).all(axis=0) & (square > REAL))
    # The other of the two has the same square, and so have images of both.
    key = np.stack((row[kept], np.round(np.log(square[kept]), 6)))
    kept = kept[np.unique(key, axis=1, return_index=True)[1]]
    column, side = np.tile(kept, 2), np.repeat([1, -1], len(kept))
    inside = (row[column] + side >= 0) & (row[column] + side < len(p))
    column, side = column[inside], side[inside]
    row = row[column]
    way = p[row + side] - p[row]
    z, part = z[:, column], np.full(len(way), BOLD)
    pairs = _Pairs(row, way, p[row], z, square[column], way, z, part)
    course = _Course(system, numbers, factor)
    return _marched(course, course.sloped(pairs, STEP * way), p)


def _marched(
    course: _Course, pairs: _Pairs, p: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    found: list[tuple[Any, Any]] = []
    for _ in range(MARCH):
        rest = -pairs.square / pairs.slope
        # The square has to fall, and to be zero before the next value.
        before = (pairs.p + rest - p[pairs.row]) / pairs.way < 1.0
        alive = (rest * pairs.way > 0.0) & before & (pairs.part > TIMID)
        there = alive & (np.abs(rest) < CLOSE * np.abs(pairs.way))
        found.append(((pairs.p + rest)[there], pairs.way[there] > 0.0))
        pairs, rest = pairs.pick(alive & ~there), rest[alive & ~there]
        if not len(rest):
            break
        step = pairs.part * rest
        at = pairs.p + step
        z, good = course.corrected(pairs.row, at, pairs.z + step * pairs.tangent, 8)
        square = _square(course.system, z)
        # The step led into the closed branch itself.
        inside = good & (square < REAL)
        found.append((at[inside], pairs.way[inside] > 0.0))
        found.append((at[inside], pairs.way[inside] < 0.0))
        good &= square < pairs.square
        new = course.sloped(pairs._replace(p=at, z=z, square=square), STEP * (rest - step))
        parts: list[Any] = [np.where(good, a, b) for a, b in zip(new, pairs, strict=True)]
        part = np.where(good, BOLD, 0.4 * pairs.part)
        pairs = _Pairs(*parts)._replace(part=part).pick(~inside)
    place, up = (np.concatenate(x) for x in zip(*found, strict=True))
    return place[up], place[~up]


def _square(system: System, z: NDArray[Any]) -> NDArray[np.float64]:
    """Of the distance between solutions and their conjugates, over the unknowns."""
    plain = np.array([z[b] for b, _, _ in system.places])
    barred = np.array([z[w] if w >= 0 else np.ones(z.shape[1]) for _, w, _ in system.places])
    if system.drifts:
        turns = np.array(
            [[system.flow.symmetries[g][a] for a in system.active] for g in system.drifts], float
        )
        at = [system.active.index(a) for a in system.fixed]
        # Along the symmetries to where B = B̄ of the amplitudes that fix a point of each orbit.
        ratio = 0.5 * np.log(barred[at] / plain[at])
        stretch = np.exp(turns.T @ np.linalg.solve(turns[:, at].T, ratio))
        plain, barred = plain * stretch, barred / stretch
    rate = z[system.logs :]
    apart = np.abs(barred - plain.conj()) ** 2 / (np.abs(barred) ** 2 + np.abs(plain) ** 2)
    turning = rate.imag**2 / (1.0 + np.abs(rate) ** 2)
    out: NDArray[np.float64] = apart.sum(axis=0) + 4.0 * turning.sum(axis=0)
    return out
