"""The equilibria of a slow flow, some amplitudes zero and others not, as polynomial equations.

B_j and B̄_j count as independent unknowns, and so do the rates of drift along the symmetries and,
where odd powers of moduli occur, |B_j|. The conjugate of an equation is an equation of its own.
Where a symmetry turns amplitudes, B̄_j = 1 of one of them picks a point of each orbit; from there
scaling along the symmetry leads back to B̄_j = conj(B_j).
"""

from __future__ import annotations

from functools import lru_cache
from itertools import combinations
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._flow import Flow

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "System",
    "equilibrium_system",
    "gauges",
    "measured",
    "moving",
    "patterns",
    "raw_of",
    "scaled",
]


def patterns(flow: Flow) -> tuple[tuple[int, ...], ...]:
    """Sets of amplitudes that can be other than zero while the rest stay at zero, fewest first."""
    found = []
    for size in range(flow.n + 1):
        for active in combinations(range(flow.n), size):
            idle = [j for j in range(flow.n) if j not in active]
            if all(
                any(any(e[3 * k : 3 * k + 3]) for k in idle) for j, e in flow.terms if j in idle
            ):
                found.append(active)
    return tuple(found)


def moving(flow: Flow, active: tuple[int, ...]) -> tuple[int, ...]:
    """Symmetries that move the active amplitudes independently of those before them."""
    chosen: list[int] = []
    for g, _ in enumerate(flow.symmetries):
        rows = [[flow.symmetries[i][a] for a in active] for i in (*chosen, g)]
        if active and np.linalg.matrix_rank(np.array(rows)) > len(chosen):
            chosen.append(g)
    return tuple(chosen)


def gauges(flow: Flow, active: tuple[int, ...], drifts: tuple[int, ...]) -> tuple[int, ...]:
    """Amplitudes that fix a point of each orbit: those with the smallest determinant."""
    best: tuple[int, ...] = ()
    least = np.inf
    for chosen in combinations(active, len(drifts)):
        rows = [[flow.symmetries[g][a] for a in chosen] for g in drifts]
        size = abs(float(np.linalg.det(np.array(rows, dtype=float)))) if drifts else 1.0
        if 0.5 < size < least - 0.5:
            best, least = chosen, size
    return best


# Weight of the squares of sizes, and steps to the least sum.
WEAK = 0.05
MOST_STEPS = 200


class System(NamedTuple):
    """Polynomial equations for the equilibria with given amplitudes other than zero.

    Attributes
    ----------
    flow : Flow
    active : tuple of int
        Amplitudes that are not zero.
    drifts : tuple of int
        Symmetries along which these can drift.
    fixed : tuple of int
        Amplitudes with B̄_j = 1.
    terms : tuple of (int, tuple of int)
        Equation and exponents of each term.
    source : tuple of int
        Term of the flow from which the coefficient comes, −1 for a constant.
    factor : tuple of complex
        By which that is multiplied, or the constant.
    conjugate : tuple of bool
        Whether it is conjugated first.
    weights : tuple of tuple of int
        Powers of the scales of active amplitudes, of the drifts, and of each pair of equations.
    places : tuple of tuple of int
        Number of the unknown B_j, B̄_j, |B_j| for each active amplitude, −1 for none.
    d : int
        Number of unknowns.
    """

    flow: Flow
    active: tuple[int, ...]
    drifts: tuple[int, ...]
    fixed: tuple[int, ...]
    terms: tuple[tuple[int, tuple[int, ...]], ...]
    source: tuple[int, ...]
    factor: tuple[complex, ...]
    conjugate: tuple[bool, ...]
    weights: tuple[tuple[int, ...], ...]
    places: tuple[tuple[int, int, int], ...]
    d: int

    @property
    def logs(self) -> int:
        """How many unknowns, the first ones, are none of the drifts."""
        return self.d - len(self.drifts)


def _unknowns(
    active: tuple[int, ...], fixed: tuple[int, ...], odd: set[int]
) -> tuple[tuple[tuple[int, int, int], ...], int]:
    places, d = [], 0
    for a in active:
        plain, d = d, d + 1
        barred, d = (-1, d) if a in fixed else (d, d + 1)
        size, d = (d, d + 1) if a in odd else (-1, d)
        places.append((plain, barred, size))
    return tuple(places), d


@lru_cache(maxsize=256)
def equilibrium_system(flow: Flow, active: tuple[int, ...]) -> System:
    """The equations of the equilibria whose amplitudes `active` are not zero, and no others.

    A factor that all terms of an equation share is divided out.
    """
    drifts = moving(flow, active)
    fixed = gauges(flow, active, drifts)
    kept = [
        (m, j, e)
        for m, (j, e) in enumerate(flow.terms)
        if j in active and not any(any(e[3 * k : 3 * k + 3]) for k in _others(flow, active))
    ]
    odd = {a for a in active for _, _, e in kept if e[3 * a + 2] % 2}
    places, inner = _unknowns(active, fixed, odd)
    d, count = inner + len(drifts), len(active)
    rows: list[tuple[int, list[int], int, complex, bool, list[int]]] = []

    def add(row: int, powers: dict[int, int], source: int, factor: complex, weight: Any) -> None:
        exponents = [0] * d
        for place, power in powers.items():
            if place >= 0:
                exponents[place] += power
        rows.append((row, exponents, source, factor, bool(row % 2), list(weight)))

    for i, a in enumerate(active):
        for side in (0, 1):
            for m, j, e in kept:
                if j == a:
                    powers, weight = _powers(active, places, e, side)
                    add(2 * i + side, powers, m, 1.0, (*weight, *(0 for _ in drifts)))
            for g, symmetry in enumerate(drifts):
                k = flow.symmetries[symmetry][a]
                if k:
                    powers = {inner + g: 1, places[i][side]: 1}
                    weight = [int(x == i) for x in range(count)]
                    weight += [int(x == g) for x in range(len(drifts))]
                    add(2 * i + side, powers, -1, (1j if side else -1j) * k, weight)
    row = 2 * count
    for plain, barred, size in places:
        if size >= 0:
            blank = (0,) * (count + len(drifts))
            add(row, {size: 2}, -1, 1.0, blank)
            add(row, {plain: 1, barred: 1}, -1, -1.0, blank)
            row += 1
    least = {r: [min(x[1][k] for x in rows if x[0] == r) for k in range(d)] for r, *_ in rows}
    terms = tuple((x[0], tuple(np.subtract(x[1], least[x[0]]).tolist())) for x in rows)
    return System(
        flow,
        active,
        drifts,
        fixed,
        terms,
        tuple(x[2] for x in rows),
        tuple(x[3] for x in rows),
        tuple(x[4] and x[2] >= 0 for x in rows),
        tuple(tuple(x[5]) for x in rows),
        places,
        d,
    )


def _others(flow: Flow, active: tuple[int, ...]) -> tuple[int, ...]:
    return tuple(k for k in range(flow.n) if k not in active)


def _powers(
    active: tuple[int, ...], places: Any, e: tuple[int, ...], side: int
) -> tuple[dict[int, int], list[int]]:
    """Powers of the unknowns in a term, or in its conjugate, and the degree in each amplitude."""
    powers: dict[int, int] = {}
    weight = []
    for (plain, barred, size), a in zip(places, active, strict=True):
        r, s, t = e[3 * a : 3 * a + 3]
        r, s = (s, r) if side else (r, s)
        half = t // 2  # |B|^t = (B B̄)^half |B|^(0 or 1)
        powers |= {plain: r + half, size: t % 2} if size >= 0 else {plain: r + half}
        if barred >= 0:
            powers[barred] = s + half
        weight.append(r + s + t)
    return powers, weight


def raw_of(system: System, flat: NDArray[Any]) -> NDArray[np.complex128]:
    """Coefficients of the system, shape (terms, K), from those of the flow, shape (K, terms)."""
    source, factor = np.array(system.source), np.array(system.factor, dtype=np.complex128)
    raw = np.where(source[:, None] >= 0, flat.T[source], 1.0)
    raw = np.where(np.array(system.conjugate)[:, None], raw.conj(), raw)
    out: NDArray[np.complex128] = raw * factor[:, None]
    return out


def scaled(system: System, flat: NDArray[Any]) -> tuple[NDArray[Any], NDArray[np.float64]]:
    """Coefficients of the system near one, and the scales of its unknowns that make them so.

    Parameters
    ----------
    system : System
    flat : numpy.ndarray
        Coefficients of the flow, shape (K, terms).

    Returns
    -------
    target : numpy.ndarray
        Shape (terms, K).
    scales : numpy.ndarray
        Of the active amplitudes, then of the drifts, shape (active + drifts, K).
    """
    raw = raw_of(system, flat)
    factor, scales = measured(system, raw)
    return raw * factor, scales


def measured(
    system: System, raw: NDArray[np.complex128]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Factors of raw coefficients, shape (terms, K), that bring them near one, and the scales."""
    rows, weights = np.array([r for r, _ in system.terms]), np.array(system.weights, dtype=float)
    p, unknowns = len(system.active), weights.shape[1]
    own = np.flatnonzero((rows < 2 * p) & (rows % 2 == 0))
    design = np.concatenate((weights[own], (rows[own, None] // 2 == np.arange(p))), axis=1)
    with np.errstate(divide="ignore"):
        answer = _balanced(design, p, np.log(np.abs(raw[own])).T).T
    powers = np.where(rows[:, None] < 2 * p, weights @ answer[:unknowns], 0.0)
    level = answer[unknowns + np.minimum(rows // 2, p - 1)]
    powers = powers + np.where(rows[:, None] < 2 * p, level, 0.0)
    return np.exp(powers), np.exp(answer[:unknowns])


def _balanced(
    design: NDArray[np.float64], p: int, logs: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The x for which Σ φ(s), φ(s) = e^s − s + s²/20, is least, s = logs + design x.

    That asks for sizes e^s near one, firmly of large ones and gently of small ones: no size is
    larger than the number of terms in its equation, or not by much. Since φ is convex the fit is
    the same in any units, and where x is not determined the sizes do not depend on it.

    Parameters
    ----------
    design : numpy.ndarray
        Shape (terms, unknowns), the last p of them one for each equation.
    p : int
    logs : numpy.ndarray
        Shape (K, terms); −∞ for what does not count.
    """
    counted = np.isfinite(logs)
    logs = np.where(counted, logs, 0.0)
    x = np.zeros((len(logs), design.shape[1]))
    kinds, index = np.unique(counted, axis=0, return_inverse=True)
    for k, kind in enumerate(kinds):
        own = index.ravel() == k
        x[own] = _fitted(design[kind], p, logs[own][:, kind])
    return x


def _fitted(design: NDArray[Any], p: int, logs: NDArray[Any]) -> NDArray[np.float64]:
    """The same where every term counts."""
    _, values, v = np.linalg.svd(design)
    rank = int((values > 1e-9).sum())
    free = v[rank:].T @ v[rank:]  # of what the terms leave open, nothing
    x = -np.linalg.solve(design.T @ design + free, design.T @ logs.T).T
    # No size above one to begin with: the exponentials stay small.
    s = logs + x @ design.T
    for k in range(p):
        x[:, k - p] -= s[:, design[:, k - p] > 0.0].max(axis=1, initial=-np.inf)
    x[~np.isfinite(x)] = 0.0  # equations without terms
    rest = np.arange(len(logs))
    for _ in range(MOST_STEPS):
        s = logs[rest] + x[rest] @ design.T
        large = np.exp(s)
        matrices = (large @ _squares(design)).reshape(-1, *free.shape)
        matrices += WEAK * design.T @ design + free
        right = -(large - 1.0 + WEAK * s) @ design
        step = np.linalg.solve(matrices, right[..., None])[..., 0]
        change = step @ design.T
        most = change.max(axis=1, initial=0.0)
        x[rest] += step * np.minimum(1.0, 2.0 / np.maximum(most, 1.0))[:, None]
        rest = rest[np.abs(change).max(axis=1, initial=0.0) > 1e-4]
        if not len(rest):
            break
    return x


def _squares(design: NDArray[Any]) -> NDArray[np.float64]:
    """Products of each term's row with itself, one row for each term."""
    return (design[:, :, None] * design[:, None, :]).reshape(len(design), design.shape[1] ** 2)
