"""Real coordinates for equilibria of which some amplitudes are zero: Newton's method, normal form.

On a circle of equilibria the first amplitude that the symmetry turns is real; in place of its
imaginary part stands the rate of drift. So there are as many unknowns as equations.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import product
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._flow import Flow, jacobian, rates
from ._paths import solve
from ._systems import moving

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Chart", "chart", "equations", "normal", "pack", "parts", "polish", "unpack"]


class Chart(NamedTuple):
    """Where the amplitudes `active` are not zero and all others are.

    Attributes
    ----------
    flow : Flow
        The slow flow of the active amplitudes alone, its symmetries in echelon form.
    columns : tuple of int
        The terms of the whole flow that occur in it.
    active : tuple of int
    pivots : tuple of int
        Which of the active amplitudes is real, for each symmetry of `flow`.
    drifts : tuple of int
        Symmetries of the whole flow along which points drift.
    mixing : tuple of tuple of float
        Rates of drift of the whole flow = rates along the symmetries of `flow` @ mixing; where
        several do the same, those with the least squares.
    parts : tuple of tuple of float
        The other way: rates along the symmetries of `flow` = those of the whole flow @ parts.
    twins : tuple of tuple of float
        Phases, in turns, of the points of an orbit that have the pivots real as well.
    """

    flow: Flow
    columns: tuple[int, ...]
    active: tuple[int, ...]
    pivots: tuple[int, ...]
    drifts: tuple[int, ...]
    mixing: tuple[tuple[float, ...], ...]
    parts: tuple[tuple[float, ...], ...]
    twins: tuple[tuple[float, ...], ...]


def _echelon(rows: list[list[int]]) -> tuple[list[list[int]], list[int]]:
    """Integer combinations of independent rows, each of them zero at the pivots of others above."""
    rows, pivots = [list(r) for r in rows], []
    for i in range(len(rows)):
        column = min(next(k for k, x in enumerate(r) if x) for r in rows[i:])
        at = next(k for k in range(i, len(rows)) if rows[k][column])
        rows[i], rows[at] = rows[at], rows[i]
        for k in range(i + 1, len(rows)):
            x, y = rows[i][column], rows[k][column]
            rows[k] = [x * b - y * a for a, b in zip(rows[i], rows[k], strict=True)]
        common = int(np.gcd.reduce(rows[i]))
        sign = 1 if rows[i][column] > 0 else -1
        rows[i] = [sign * x // common for x in rows[i]]
        pivots.append(column)
    return rows, pivots


def _twins(rows: list[list[int]], pivots: list[int], p: int) -> tuple[tuple[float, ...], ...]:
    """Turns along the rows that leave the phases of the pivots as they are."""
    found: dict[tuple[float, ...], None] = {}
    for choice in product(*(range(rows[i][pivots[i]]) for i in range(len(rows)))):
        phases = np.zeros(p)
        for i, k in enumerate(choice):
            lag = (k - phases[pivots[i]]) / rows[i][pivots[i]]
            phases = phases + lag * np.array(rows[i])
        found[tuple(np.round(phases % 1.0, 12) % 1.0)] = None
    return tuple(found)


@lru_cache(maxsize=256)
def chart(flow: Flow, active: tuple[int, ...]) -> Chart:
    """Coordinates of the points whose amplitudes `active` are not zero."""
    drifts = moving(flow, active)
    plain = [[flow.symmetries[g][a] for a in active] for g in drifts]
    rows, pivots = _echelon(plain)
    terms, columns = [], []
    for m, (j, e) in enumerate(flow.terms):
        if j in active and not any(
            any(e[3 * k : 3 * k + 3]) for k in range(flow.n) if k not in active
        ):
            own = tuple(x for a in active for x in e[3 * a : 3 * a + 3])
            terms.append((active.index(j), own))
            columns.append(m)
    every = np.array(flow.symmetries, dtype=float).reshape(-1, flow.n)[:, list(active)]
    echelon = np.array(rows, dtype=float).reshape(len(rows), len(active))
    mixing, parts = echelon @ np.linalg.pinv(every), every @ np.linalg.pinv(echelon)
    return Chart(
        Flow(len(active), tuple(terms), tuple(map(tuple, rows))),
        tuple(columns),
        active,
        tuple(pivots),
        drifts,
        tuple(tuple(map(float, row)) for row in mixing),
        tuple(tuple(map(float, row)) for row in parts),
        _twins(rows, pivots, len(active)),
    )


def normal(place: Chart, b: NDArray[Any]) -> NDArray[np.complex128]:
    """The point of each orbit whose pivots are real and positive, shape (..., active).

    Where several points are so, the one with the smallest phases in [0, 2π), the first first.
    """
    b = np.array(b, dtype=np.complex128)
    for row, pivot in zip(place.flow.symmetries, place.pivots, strict=True):
        angle = np.angle(b[..., pivot]) / row[pivot]
        b *= np.exp(-1j * angle[..., None] * np.array(row))
        b[..., pivot] = np.abs(b[..., pivot])
    if len(place.twins) > 1:
        images = b[..., None, :] * np.exp(2j * np.pi * np.array(place.twins))
        turns = np.round(np.angle(images) / (2.0 * np.pi) % 1.0, 9) % 1.0
        best = np.zeros(b.shape[:-1], dtype=np.int64)
        for k in range(1, len(place.twins)):
            now = np.take_along_axis(turns, best[..., None, None], axis=-2)[..., 0, :]
            less, equal = turns[..., k, :] < now, turns[..., k, :] == now
            first = less & np.logical_and.accumulate(
                np.concatenate((np.ones_like(equal[..., :1]), equal[..., :-1]), axis=-1), axis=-1
            )
            best = np.where(first.any(axis=-1), k, best)
        b = np.take_along_axis(images, best[..., None, None], axis=-2)[..., 0, :]
        for pivot in place.pivots:
            b[..., pivot] = np.abs(b[..., pivot])
    return b


def equations(
    place: Chart, c: NDArray[Any], b: NDArray[Any], rate: NDArray[Any]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Right-hand sides in the turning frame, and their derivatives by the unknowns.

    Parameters
    ----------
    place : Chart
    c : numpy.ndarray
        Coefficients of `place.flow`, shape (..., terms).
    b : numpy.ndarray
        Shape (..., active), real at the pivots.
    rate : numpy.ndarray
        Shape (..., pivots).

    Returns
    -------
    values, jacobian : numpy.ndarray
        Shapes (..., 2·active) and (..., 2·active, 2·active): real and imaginary parts u_1, v_1, …
        of 2B, a rate of drift in place of each v of a pivot.
    """
    flow = place.flow
    f = rates(flow, c, b)
    if not place.pivots:
        return parts(2.0 * f), jacobian(flow, c, b)
    turns = np.array(flow.symmetries, dtype=np.float64)
    f = f - 1j * (rate @ turns) * b
    matrices = jacobian(flow, c, b, rate)
    for i, pivot in enumerate(place.pivots):
        matrices[..., 2 * pivot + 1] = parts(-2j * turns[i] * b)
    return parts(2.0 * f), matrices


def parts(values: NDArray[np.complex128]) -> NDArray[np.float64]:
    """Real and imaginary parts one after the other along the last axis."""
    both = np.stack((values.real, values.imag), axis=-1)
    return both.reshape(*values.shape[:-1], 2 * values.shape[-1])


def unpack(place: Chart, x: NDArray[np.float64]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Amplitudes and rates from the real unknowns, shape (..., 2·active)."""
    b = (x[..., 0::2] + 1j * x[..., 1::2]) / 2.0
    rate = np.empty((*x.shape[:-1], len(place.pivots)))
    for i, pivot in enumerate(place.pivots):
        rate[..., i] = x[..., 2 * pivot + 1]
        b[..., pivot] = x[..., 2 * pivot] / 2.0
    return b, rate


def pack(place: Chart, b: NDArray[Any], rate: NDArray[Any]) -> NDArray[np.float64]:
    """The real unknowns of amplitudes and rates."""
    x = np.empty((*b.shape[:-1], 2 * b.shape[-1]))
    x[..., 0::2], x[..., 1::2] = 2.0 * b.real, 2.0 * b.imag
    for i, pivot in enumerate(place.pivots):
        x[..., 2 * pivot + 1] = rate[..., i]
    return x


def polish(
    place: Chart, c: NDArray[Any], b: NDArray[Any], rate: NDArray[Any], steps: int = 3
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Newton's method; a step that makes the residual larger is not taken.

    Parameters
    ----------
    place, c, b, rate
        As for `equations`, with one leading axis.
    """
    x = pack(place, b, rate)
    with np.errstate(all="ignore"):
        f, matrices = equations(place, c, *unpack(place, x))
        for _ in range(steps):
            better = x - solve(matrices, f[..., None])[..., 0]
            g, others = equations(place, c, *unpack(place, better))
            less = np.abs(g).max(axis=-1) < np.abs(f).max(axis=-1)
            if not less.any():
                break
            x, f = np.where(less[:, None], better, x), np.where(less[:, None], g, f)
            matrices = np.where(less[:, None, None], others, matrices)
    return unpack(place, x)
