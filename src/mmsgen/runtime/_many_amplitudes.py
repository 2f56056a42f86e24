"""All equilibria of a slow flow with any number of amplitudes, by following paths.

For each set of amplitudes that are not zero the equilibria solve a system of polynomials in B and
B̄, independent of each other. All solutions of that system for generic complex coefficients are
known (`_starts`); as the coefficients go to those wanted, paths lead from them to every isolated
solution (Morgan and Sommese, "Coefficient-parameter polynomial continuation", Appl. Math. Comput.
29, 1989), along straight lines of the coefficients' logarithms. Those meet no coefficients for
which solutions coincide, with probability one, and amplitudes of very different sizes are reached
at an even speed. Real are those with B̄ = conj(B).
"""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from ._bounds import least_count
from ._charts import chart, equations, normal, pack, polish, unpack
from ._families import EXACT, backwards, conserved, selecting
from ._flow import Flow, spectrum
from ._paths import FAR, newton, solve, track
from ._planes import elsewhere, on_planes, solves
from ._records import Equilibria
from ._starts import MOST, generic_solutions, other_generic, too_many
from ._systems import System, equilibrium_system, patterns, scaled

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

__all__ = ["arranged", "check_size", "ends", "equilibria_of_many", "generic_counts", "with_active"]

# Paths that are followed together.
BLOCK = 12_000
EPS = 2.0**-52
# Amplitudes, over their scales, at which families of equilibria are looked for.
LEVELS = (1.0, 0.1, 10.0)
# What is left of the way of a path that ends in a singular point or at infinity.
LOST = 1e-3
# The same of one that came to a halt on its way to a point that is nearly singular.
STUCK = 1e-12
# Steps to a multiple equilibrium: from 1e-3, where paths to a triple one are lost, (2/3)^32 of that
# is below the errors of 1e-5 there.
SLOW = 32
# Two paths to a triple equilibrium that is none quite can end in the same one of the complex pair
# that is this close to a real one. Newton's method in the reals leads to that.
BESIDE = 1e-3


def generic_counts(flow: Flow) -> dict[tuple[int, ...], int]:
    """How many complex equilibria generic coefficients have, for each set of active amplitudes.

    Those that a symmetry carries into each other count once. No parameters have more isolated
    equilibria, real or complex, counted with their multiplicities.
    """
    counts = {}
    for active in patterns(flow):
        if active:
            system = equilibrium_system(flow, active)
            counts[active] = generic_solutions(system.terms, system.d, system.logs)[1].shape[1]
        else:
            counts[active] = 1
    return counts


def equilibria_of_many(flow: Flow, coefficients: Any) -> Equilibria:
    """All isolated equilibria at each point of a batch.

    Parameters
    ----------
    flow : Flow
    coefficients : array_like
        Shape (..., terms).

    Returns
    -------
    Equilibria
        Complete with probability one: every equilibrium that is isolated among the complex
        solutions, circles along symmetries counted as one point. Everything is NaN where a
        coefficient is not finite, where all terms vanish for some amplitudes, so that these can
        have any value, and where equilibria fill curves in which every amplitude moves, as those of
        undamped free oscillators do: `modes_of` has them. Curves in which only some amplitudes
        move that nothing damps or drives, while others are damped, are left out, and what is
        isolated with these at rest is listed. `certified` tells which of them are proved to be
        equilibria, one each.

    Raises
    ------
    ValueError
        If generic coefficients have more than 400 equilibria; if at every point of the batch some
        amplitudes can have any value, or equilibria fill curves.
    """
    c = np.asarray(coefficients, dtype=np.complex128)
    shape, flat = c.shape[:-1], c.reshape(-1, c.shape[-1])
    finite = np.flatnonzero(np.isfinite(flat).all(axis=-1))
    found, loose, curves = [], 0, 0
    with np.errstate(all="ignore"):
        for rows, own, columns in _groups(flow, flat, finite):
            usual = patterns(own)
            check_size(own, usual)
            if any(active and not chart(own, active).columns for active in usual):
                loose += len(rows)
                continue
            filled = _families(own, usual, flat[rows][:, columns])
            curves, rows = curves + int(filled.sum()), rows[~filled]
            for active in usual:
                found.append(with_active(own, active, flat[:, columns], rows))
    if len(flat) and loose + curves == len(flat):
        raise ValueError(_ANY if loose else _CURVES)
    g = len(flow.symmetries)
    found.append((finite[:0], np.zeros((0, flow.n), complex), np.zeros((0, g))))
    rows, b, drift = (np.concatenate(x) for x in zip(*found, strict=True))
    return arranged(flow, flat, shape, rows, b, drift)


_ANY = (
    "the equilibria of this slow flow are not isolated: all terms that move some of the amplitudes "
    "vanish, and these can have any value; detuning, damping or forcing is missing"
)
_CURVES = (
    "the equilibria of this slow flow fill curves: nothing damps or forces its amplitudes, which "
    "can have any value; backbone lists the motions in which one amplitude is given, and damping "
    "leaves those that are isolated"
)


def _families(flow: Flow, usual: tuple[tuple[int, ...], ...], c: NDArray[Any]) -> NDArray[np.bool_]:
    """Where every amplitude can have any value, on some curve of equilibria, shape (K,).

    Amplitudes of which a sum of squares is conserved while others are damped or driven can rest.
    """
    loose = np.zeros((len(c), flow.n), dtype=bool)
    for active in usual:
        if not active:
            continue
        own = list(active)
        weights = conserved(flow, active, c)
        both = backwards(flow, active, c)
        rows = np.flatnonzero(np.isfinite(weights[:, 0]) | both)
        if len(active) == 1:
            loose[rows, own[0]] = True
        if len(active) == 1 or not len(rows):
            continue
        size = scaled(equilibrium_system(flow, active), c[rows])[1][: len(active)].T
        share = np.abs(np.nan_to_num(weights[rows])) * size**2
        best = share.argmax(axis=1)
        concerned = (share > EXACT * share.max(axis=1)[:, None]) | both[rows][:, None]
        left = (concerned & ~loose[rows][:, own]).any(axis=1)
        # A sum of several signs has curves only from certain amplitudes on, or up to them.
        for level, j in product(LEVELS, np.unique(best)):
            there = np.flatnonzero((best == j) & left)
            square = (level * size[there, j]) ** 2
            k = active[j]
            asking, asked = selecting(flow, c[rows[there]], k, square, (k,))
            found, b, _ = with_active(asking, active, asked, np.arange(len(there)))
            exact = np.abs(np.abs(b[:, k]) ** 2 - square[found]) < EXACT * square[found]
            hit = np.unique(there[found[exact]])
            left[hit] = False
            loose[np.ix_(rows[hit], own)] |= concerned[hit]
    return np.asarray(loose.all(axis=1))


def check_size(flow: Flow, usual: tuple[tuple[int, ...], ...]) -> None:
    """Refuse what would take minutes, before any path is followed."""
    for active in reversed(usual):
        if len(active) > 2:
            least = least_count(system := equilibrium_system(flow, active))
            if least > MOST:
                raise too_many(system.d, least)


def _groups(
    flow: Flow, flat: NDArray[Any], finite: NDArray[np.int64]
) -> Iterator[tuple[NDArray[np.int64], Flow, list[int]]]:
    """Rows together in which the same amplitudes can be zero, and the terms that count there.

    A force that vanishes at some points leaves amplitudes at rest there that it moves elsewhere.
    """
    usual = patterns(flow)
    every = list(range(len(flow.terms)))
    present = flat[finite] != 0.0
    kinds, index = np.unique(present, axis=0, return_inverse=True)
    reduced = []
    for kind in kinds:
        columns = [m for m in every if kind[m]]
        own = flow._replace(terms=tuple(flow.terms[m] for m in columns))
        reduced.append((flow, every) if patterns(own) == usual else (own, columns))
    for choice in dict.fromkeys((own, tuple(columns)) for own, columns in reduced):
        same = [(own, tuple(columns)) == choice for own, columns in reduced]
        yield finite[np.array(same)[index.ravel()]], choice[0], list(choice[1])


def with_active(
    flow: Flow, active: tuple[int, ...], flat: NDArray[Any], finite: NDArray[np.int64]
) -> tuple[NDArray[np.int64], NDArray[Any], NDArray[np.float64]]:
    """Equilibria with given amplitudes other than zero: their points, amplitudes and drifts."""
    g = len(flow.symmetries)
    if not active:
        return finite, np.zeros((len(finite), flow.n), complex), np.zeros((len(finite), g))
    system, place = equilibrium_system(flow, active), chart(flow, active)
    base, start = generic_solutions(system.terms, system.d, system.logs)
    found: list[tuple[Any, Any, Any]] = []
    special: list[tuple[Any, Any, Any]] = []
    step = max(1, BLOCK // max(1, start.shape[1]))
    for k in range(0, len(finite) if start.shape[1] else 0, step):
        rows = finite[k : k + step]
        target, scales = scaled(system, flat[rows])
        z, condition, lost = ends(system, base, start, target)
        count = start.shape[1]
        which = np.flatnonzero(np.isfinite(lost).all(axis=0)) // count
        heads = lost[:, np.isfinite(lost).all(axis=0)]
        for paths, b, turns in on_planes(system, flat[rows[which]], scales[:, which], heads):
            special.append((rows[which[paths]], b, turns))
        good, b, rate = _real(system, np.repeat(scales, count, axis=1), z, condition)
        # Two solutions that are δ apart have conditions of 1/δ and errors of EPS/δ: both rules
        # agree that they are one where δ is below 1e-7. Of three that are δ apart, a real one and
        # a complex pair, the real one has to stay.
        close = np.clip(100.0 * EPS * condition, 1e-9, 1e-4)
        keep = np.flatnonzero(good & ~_twice(np.where(good, z, np.nan), count, close))
        near = np.flatnonzero(
            _real(system, np.repeat(scales, count, axis=1), z, condition, BESIDE)[0]
            & ~good
            & (close > 1e-8)
        )
        for chosen, steps in ((keep, 0), (near, SLOW)):
            if not len(chosen):
                continue
            which = rows[chosen // count]
            own = flat[which][:, list(place.columns)]
            now, turns = _in_chart(place, b[chosen], rate[chosen])
            for _ in range(steps):
                # Without regard to residuals, which grow at first near a triple equilibrium.
                f, matrices = equations(place, own, now, turns)
                x = pack(place, now, turns) - solve(matrices, f[..., None])[..., 0]
                now, turns = unpack(place, x)
            now, turns = polish(place, own, now, turns)
            other = elsewhere(place, own, now, turns, scales[:, chosen // count].T)
            which, now, turns = which[~other], now[~other], turns[~other]
            own = own[~other]
            if steps == SLOW:
                fresh = solves(place.flow, own, now, turns) & _fresh(found, which, now)
                which, now, turns = which[fresh], now[fresh], turns[fresh]
            found.append((which, now, turns))
    for rows, b, turns in found:
        whole = np.zeros((len(rows), flow.n), complex)
        whole[:, list(active)] = normal(place, b)
        drift = turns @ np.array(place.mixing).reshape(turns.shape[1], g)
        special.append((rows, whole, drift))
    special.append((finite[:0], np.zeros((0, flow.n), complex), np.zeros((0, g))))
    rows, whole, drift = (np.concatenate(x) for x in zip(*special, strict=True))
    return rows, whole, drift


def _in_chart(place: Any, b: NDArray[Any], rate: NDArray[Any]) -> tuple[Any, Any]:
    """Amplitudes with real pivots, and rates along the symmetries in echelon form."""
    if not place.pivots:
        return b, rate
    return normal(place, b), rate @ np.array(place.parts)[list(place.drifts)]


def ends(
    system: System, base: NDArray[Any], start: NDArray[Any], target: NDArray[Any]
) -> tuple[NDArray[Any], NDArray[np.float64], NDArray[Any]]:
    """Solutions at the ends of all paths, their conditions, and where other paths were lost.

    NaN where there is none.
    """
    terms, logs, count, k = system.terms, system.logs, start.shape[1], target.shape[1]
    end = np.repeat(target, count, axis=1)
    paths = track(terms, np.broadcast_to(base, end.shape), end, np.tile(start, (1, k)), logs)
    z, left = paths.z.copy(), paths.left.copy()
    for tolerance in (1e-5, 1e-7):
        astray = _twice(np.where(left == 0.0, z, np.nan), count, 1e-8) | (left > LOST)
        stuck = (left > STUCK) & (np.abs(np.log(np.abs(z[:logs]))) < FAR).all(axis=0)
        again = np.flatnonzero((astray | stuck).reshape(k, count).any(axis=1))
        if not len(again):
            break
        # Along other ways.
        base, start = other_generic(terms, system.d, logs) if tolerance > 1e-6 else (base, start)
        rows = (again[:, None] * count + np.arange(count)).ravel()
        points, wanted = np.tile(start, (1, len(again))), end[:, rows]
        begin = np.broadcast_to(base, wanted.shape)
        paths = track(terms, begin, wanted, points, logs, tolerance)
        z[:, rows], left[rows] = paths.z, paths.left
    z[:, left > LOST] = np.nan
    heads = z
    z, last, condition = newton(terms, end, z, logs, 8)
    # To a point of multiplicity m each step takes 1/m of the way.
    slow = np.flatnonzero((last >= 1e-6) & (last < 1e-2))
    z[:, slow], last[slow], condition[slow] = newton(terms, end[:, slow], z[:, slow], logs, SLOW)
    settled = last < np.clip(10.0 * EPS * condition, 1e-6, 1e-4)
    z[:, ~(settled & np.isfinite(condition))] = np.nan
    lost = np.where(np.isfinite(z).all(axis=0), np.nan, heads)
    return z, condition, lost


def _twice(z: NDArray[Any], count: int, distance: Any) -> NDArray[np.bool_]:
    """Which of `count` consecutive solutions equal one before them, relative to each unknown."""
    distance = np.broadcast_to(distance, z.shape[1:]).reshape(-1, count, 1)
    table = z.reshape(len(z), -1, count)
    size = np.abs(table)
    same = np.ones((table.shape[1], count, count), dtype=bool)
    for values, sizes in zip(table, size, strict=True):
        gap = np.abs(values[:, :, None] - values[:, None, :])
        same &= gap <= distance * (sizes[:, :, None] + sizes[:, None, :])
    return (same & np.tri(count, k=-1, dtype=bool)).any(axis=-1).ravel()


def _fresh(found: list[Any], rows: NDArray[Any], b: NDArray[Any]) -> NDArray[np.bool_]:
    """Which points are neither among those found nor there before."""
    fresh: NDArray[np.bool_] = np.ones(len(rows), dtype=bool)
    for k, (row, point) in enumerate(zip(rows, b, strict=True)):
        for others, points in (
            (x[0], x[1]) for x in (*found, (rows[:k][fresh[:k]], b[:k][fresh[:k]]))
        ):
            same = points[others == row]
            gap = np.abs(same - point) < 1e-4 * (np.abs(same) + np.abs(point))
            fresh[k] &= not gap.all(axis=-1).any()
    return fresh


def _real(
    system: System,
    scales: NDArray[np.float64],
    z: NDArray[Any],
    condition: NDArray[np.float64],
    least: float = 1e-10,
) -> tuple[NDArray[np.bool_], NDArray[np.complex128], NDArray[np.float64]]:
    """Which solutions have B̄ = conj(B), and the amplitudes and rates of drift."""
    p, inner = len(system.active), system.d - len(system.drifts)
    plain = np.array([z[b] for b, _, _ in system.places])
    barred = np.array([z[w] if w >= 0 else np.ones(z.shape[1]) for _, w, _ in system.places])
    sizes = [z[m] for _, _, m in system.places if m >= 0]
    if system.drifts:
        turns = np.array(
            [[system.flow.symmetries[g][a] for a in system.active] for g in system.drifts], float
        )
        at = [system.active.index(a) for a in system.fixed]
        with np.errstate(all="ignore"):
            ratio = 0.5 * np.log(np.abs(barred[at] / plain[at]))
        stretch = np.exp(turns.T @ np.linalg.solve(turns[:, at].T, ratio))
        plain, barred = plain * stretch, barred / stretch
    rate = z[inner:]
    error = np.maximum(np.clip(1e3 * EPS * condition, 1e-10, 1e-5), least)
    with np.errstate(all="ignore"):
        gap = np.abs(barred - plain.conj()) / (np.abs(barred) + np.abs(plain))
        good = (gap < error).all(axis=0)
        bound = error * (1.0 + np.abs(rate))
        good &= (np.abs(rate.imag) < bound).all(axis=0)
        for m in sizes:
            good &= m.real > 0.0
    b = (0.5 * (plain + barred.conj()) * scales[:p]).T
    return good, b, (rate.real * scales[p:]).T


def arranged(
    flow: Flow,
    flat: NDArray[Any],
    shape: tuple[int, ...],
    rows: NDArray[np.int64],
    b: NDArray[np.complex128],
    drift: NDArray[np.float64],
) -> Equilibria:
    """Equilibria in their order, filled up with NaN."""
    size = (np.abs(b) ** 2).sum(axis=-1)
    order = np.lexsort((size, rows))
    # Sizes that differ by rounding errors alone are the same.
    steps = np.diff(size[order], prepend=0.0) > 1e-9 * size[order]
    rank = np.empty(len(rows), dtype=np.int64)
    rank[order] = np.cumsum(steps | (np.diff(rows[order], prepend=-1) > 0))
    turns = np.round(np.angle(b) / (2.0 * np.pi) % 1.0, 9) % 1.0
    turns[np.abs(b) == 0.0] = 0.0
    order = np.lexsort((*(turns[:, k] for k in reversed(range(flow.n))), rank))
    rows, b, drift = rows[order], b[order], drift[order]
    keep = np.ones(len(rows), dtype=bool)
    if len(rows) > 1:
        near = (np.abs(np.diff(b, axis=0)) <= 1e-9 * np.abs(b[1:])).all(axis=-1)
        keep[1:] = ~(near & (np.diff(rows) == 0))
    rows, b, drift = rows[keep], b[keep], drift[keep]
    first = np.searchsorted(rows, np.arange(len(flat)))
    number = np.arange(len(rows)) - first[rows]
    k = int(number.max()) + 1 if len(rows) else 0
    g = len(flow.symmetries)
    amplitudes = np.full((len(flat), k, flow.n), complex(np.nan, np.nan))
    drifts, growth = np.full((len(flat), k, g), np.nan), np.full((len(flat), k), np.nan)
    amplitudes[rows, number], drifts[rows, number] = b, drift
    if len(rows):
        values = spectrum(flow, flat[rows], b, drift if g else None)
        growth[rows, number] = values[:, 0].real
    return Equilibria(
        amplitudes.reshape(*shape, k, flow.n),
        drifts.reshape(*shape, k, g),
        growth.reshape(*shape, k),
    )
