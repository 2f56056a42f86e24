"""Sparse polynomial systems, and the paths of their solutions as the coefficients change.

A system of d equations in d complex unknowns is a tuple of terms, each of them its equation and
its exponents; the coefficients come as an array of shape (terms, K), one column for each of K
systems that are treated together, and the unknowns as (d, K).
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Paths", "Terms", "evaluate", "newton", "solve", "track"]

Terms = tuple[tuple[int, tuple[int, ...]], ...]


class _Plan(NamedTuple):
    """In which order monomials are multiplied out, and where each term goes."""

    parents: tuple[tuple[int, int], ...]  # monomial m ≥ 1 = monomial parent × an unknown
    of_terms: NDArray[np.int64]  # monomial of each term, the terms by equation
    order: NDArray[np.int64]
    starts: NDArray[np.int64]  # where each equation begins
    rows: NDArray[np.int64]
    of_slopes: NDArray[np.int64]  # the same for the derivatives, by (equation, unknown)
    slope_term: NDArray[np.int64]
    slope_factor: NDArray[np.float64]
    slope_starts: NDArray[np.int64]
    cells: NDArray[np.int64]


@lru_cache(maxsize=256)
def _plan(terms: Terms, d: int) -> _Plan:
    places: dict[tuple[int, ...], int] = {(0,) * d: 0}
    parents: list[tuple[int, int]] = []

    def place(e: tuple[int, ...]) -> int:
        if e not in places:
            k = max(i for i in range(d) if e[i])
            parent = place(tuple(x - (i == k) for i, x in enumerate(e)))
            places[e] = len(places)
            parents.append((parent, k))
        return places[e]

    order = sorted(range(len(terms)), key=lambda t: terms[t][0])
    of_terms = [place(terms[t][1]) for t in order]
    slopes = []
    for t, (row, e) in enumerate(terms):
        for k in range(d):
            if e[k]:
                rest = tuple(x - (i == k) for i, x in enumerate(e))
                slopes.append((row * d + k, t, float(e[k]), place(rest)))
    slopes.sort(key=lambda s: s[:2])
    rows, starts = np.unique([terms[t][0] for t in order], return_index=True)
    cells, slope_starts = np.unique([s[0] for s in slopes], return_index=True)
    return _Plan(
        tuple(parents),
        np.array(of_terms, dtype=np.int64),
        np.array(order, dtype=np.int64),
        starts,
        rows.astype(np.int64),
        np.array([s[3] for s in slopes], dtype=np.int64),
        np.array([s[1] for s in slopes], dtype=np.int64),
        np.array([s[2] for s in slopes]),
        slope_starts,
        cells.astype(np.int64),
    )


def _monomials(plan: _Plan, z: NDArray[Any]) -> NDArray[Any]:
    table = np.empty((len(plan.parents) + 1, z.shape[1]), dtype=z.dtype)
    table[0] = 1.0
    for m, (parent, k) in enumerate(plan.parents, 1):
        np.multiply(table[parent], z[k], out=table[m])
    return table


def _values(plan: _Plan, c: NDArray[Any], table: NDArray[Any], d: int) -> NDArray[Any]:
    out = np.zeros((d, table.shape[1]), dtype=table.dtype)
    if len(plan.rows):
        products = c[plan.order] * table[plan.of_terms]
        out[plan.rows] = np.add.reduceat(products, plan.starts, axis=0)
    return out


def _slopes(plan: _Plan, c: NDArray[Any], table: NDArray[Any], d: int) -> NDArray[Any]:
    """Jacobians, shape (K, d, d)."""
    out = np.zeros((d * d, table.shape[1]), dtype=table.dtype)
    if len(plan.cells):
        products = c[plan.slope_term] * table[plan.of_slopes]
        products *= plan.slope_factor[:, None]
        out[plan.cells] = np.add.reduceat(products, plan.slope_starts, axis=0)
    return np.ascontiguousarray(out.T).reshape(-1, d, d)


def evaluate(
    terms: Terms, c: NDArray[Any], z: NDArray[Any]
) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Values, Jacobians, and the sums of the moduli of all products.

    Parameters
    ----------
    terms : Terms
    c : numpy.ndarray
        Coefficients, shape (terms, K).
    z : numpy.ndarray
        Unknowns, shape (d, K).

    Returns
    -------
    values, jacobians, sizes : numpy.ndarray
        Shapes (d, K), (K, d, d) and (d, K).
    """
    d = len(z)
    plan = _plan(terms, d)
    table = _monomials(plan, z)
    sizes = _values(plan, np.abs(c), np.abs(table), d)
    return _values(plan, c, table, d), _slopes(plan, c, table, d), sizes


def solve(matrices: NDArray[Any], right: NDArray[Any]) -> NDArray[Any]:
    """Solutions of linear systems, (K, d, d) and (K, d, r); NaN where a matrix is singular."""
    try:
        return np.linalg.solve(matrices, right)
    except np.linalg.LinAlgError:
        regular = np.abs(np.linalg.slogdet(matrices)[0]) > 0.0
        safe = np.where(regular[:, None, None], matrices, np.eye(matrices.shape[1]))
        return np.where(regular[:, None, None], np.linalg.solve(safe, right), np.nan)


def newton(
    terms: Terms, c: NDArray[Any], z: NDArray[Any], logs: int, steps: int = 6
) -> tuple[NDArray[Any], NDArray[np.float64], NDArray[np.float64]]:
    """Newton's method, the first `logs` unknowns over their own size.

    Returns
    -------
    z : numpy.ndarray
        Shape (d, K).
    last : numpy.ndarray
        Largest relative change of an unknown in the last step, shape (K,).
    condition : numpy.ndarray
        Of the Jacobian before that step in the maximum norm, unknowns and equations scaled.
    """
    z, d = z.copy(), len(z)
    last = condition = np.full(z.shape[1], np.inf)
    with np.errstate(all="ignore"):
        for k in range(steps):
            values, matrices, sizes = evaluate(terms, c, z)
            scale = np.abs(z)
            scale[logs:] += 1.0
            matrices = matrices * (scale.T[:, None, :] / sizes.T[:, :, None])
            right = (values / sizes).T[..., None]
            if k < steps - 1:
                step = solve(matrices, right)[..., 0].T
            else:
                inverse = solve(matrices, np.broadcast_to(np.eye(d), matrices.shape))
                step = (inverse @ right)[..., 0].T
                condition = _norm(inverse) * _norm(matrices)
            z = z - scale * step
            last = np.abs(step).max(axis=0)
    return z, last, condition


def _norm(matrices: NDArray[Any]) -> NDArray[np.float64]:
    return np.abs(matrices).sum(axis=2).max(axis=1)


class Paths(NamedTuple):
    """Where paths ended.

    Attributes
    ----------
    z : numpy.ndarray
        Shape (d, K).
    left : numpy.ndarray
        Shape (K,): what was left of the way; zero where a path has arrived.
    """

    z: NDArray[np.complex128]
    left: NDArray[np.float64]


# A path that has come this close to its end without arriving ends in a singular point or at
# infinity; so does one whose unknowns, near its end, are as large or as small as e^FAR and go on
# as a power of the rest of the way, at least the LEAVING-th. Before that they may pass by infinity.
CLOSE = 1e-13
FAR = 18.0
LEAVING = 0.03
NOWHERE = 300.0
ROUNDING = 16 * 2.0**-52
# Corrections up to this may be rounding errors.
VAGUE = 1e-5
LONGEST = 0.2
ENOUGH = 2000


class _State(NamedTuple):
    """Paths under way: where they are, and where they were one step before."""

    place: NDArray[np.int64]
    end: NDArray[Any]  # coefficients are (end + rest · line) e^(rest · turn)
    line: NDArray[Any]
    turn: NDArray[Any]
    rest: NDArray[np.float64]  # of the way
    h: NDArray[np.float64]
    y: NDArray[Any]
    slope: NDArray[Any]
    back: NDArray[np.float64]
    y_back: NDArray[Any]
    slope_back: NDArray[Any]

    def coefficients(self, rest: NDArray[np.float64]) -> tuple[NDArray[Any], NDArray[Any]]:
        """Coefficients where so much of the way is left, and their derivatives along the way."""
        grown = np.exp(rest * self.turn)
        c = (self.end + rest * self.line) * grown
        return c, -(self.line * grown + self.turn * c)

    def pick(self, rows: NDArray[Any]) -> _State:
        """Those of some paths alone."""
        parts: list[Any] = [part[..., rows] for part in self]
        return _State(*parts)


class _Map(NamedTuple):
    """Unknowns as functions of the coordinates in which paths are followed."""

    plan: _Plan
    logs: int  # so many of the first coordinates are logarithms

    def unknowns(self, y: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
        """The unknowns, and their derivatives by the coordinates."""
        z = y.copy()
        z[: self.logs] = np.exp(y[: self.logs])
        by = np.ones_like(z)
        by[: self.logs] = z[: self.logs]
        return z, by

    def steps(self, c: NDArray[Any], change: NDArray[Any], y: NDArray[Any]) -> NDArray[Any]:
        """Newton's step, and the tangent of the path, shape (2, d, K)."""
        d = len(y)
        z, by = self.unknowns(y)
        table = _monomials(self.plan, z)
        matrices = _slopes(self.plan, c, table, d) * by.T[:, None, :]
        values = _values(self.plan, c, table, d), _values(self.plan, change, table, d)
        return -solve(matrices, np.stack(values).transpose(2, 1, 0)).transpose(2, 1, 0)

    def noise(self, c: NDArray[Any], y: NDArray[Any]) -> NDArray[np.float64]:
        """What rounding errors of the equations make of Newton's step, shape (K,)."""
        d = len(y)
        z, by = self.unknowns(y)
        table = _monomials(self.plan, z)
        matrices = _slopes(self.plan, c, table, d) * by.T[:, None, :]
        sizes = _values(self.plan, np.abs(c), np.abs(table), d)
        inverse = solve(matrices, np.broadcast_to(np.eye(d), matrices.shape))
        amplified = (np.abs(inverse) @ (ROUNDING * sizes).T[..., None])[..., 0].T
        amplified[self.logs :] /= 1.0 + np.abs(y[self.logs :])
        return np.asarray(amplified.max(axis=0))


def track(
    terms: Terms,
    begin: NDArray[Any],
    end: NDArray[Any],
    z: NDArray[Any],
    logs: int,
    tolerance: float = 2e-3,
) -> Paths:
    """Follow solutions from coefficients `begin` to `end`.

    The logarithms of the coefficients go along straight lines; so do coefficients themselves that
    vanish at one of the ends. Solutions of all sizes are so reached at an even speed, where those
    of coefficients on straight lines come to coefficients that are very small at the last moment.

    A cubic through the last two points and their tangents predicts, Newton's method corrects; a
    step counts where the second correction is a small part of the first. Each path has steps of
    its own. Unknowns that may be very large and very small are followed by their logarithms.

    Parameters
    ----------
    terms : Terms
    begin, end : numpy.ndarray
        Shape (terms, K).
    z : numpy.ndarray
        Solutions at `begin`, shape (d, K).
    logs : int
        How many of the unknowns, the first ones, are followed by their logarithms.
    tolerance : float
        How far a prediction is aimed to be off, relative.
    """
    d, count = z.shape
    way = _Map(_plan(terms, d), logs)
    ends, left = np.array(z, dtype=np.complex128), np.ones(count)
    with np.errstate(all="ignore"):
        y = ends.copy()
        y[:logs] = np.log(y[:logs])
        flat = (begin == 0.0) | (end == 0.0)
        line = np.where(flat, begin - end, 0.0)
        turn = np.where(flat, 0.0, np.log(np.where(flat, 1.0, begin / end)))
        rest, h, back = np.ones(count), np.full(count, 0.02), np.zeros(count)
        s = _State(np.arange(count), end, line, turn, rest, h, y, y, back, y, y)
        slope = way.steps(*s.coefficients(rest), y)[1]
        s = s._replace(slope=slope, slope_back=slope)
        for k in range(ENOUGH + 1):
            large = np.abs(s.y[:logs].real)
            leaving = s.rest * np.abs(s.slope[:logs].real) > LEAVING
            far = ((large > FAR) & leaving & (s.rest < 1e-3)).any(axis=0)
            far |= ~(large < NOWHERE).all(axis=0)
            over = (s.rest <= CLOSE) | far | (s.h < 1e-3 * CLOSE) | (k == ENOUGH)
            if over.any():
                ends[:, s.place[over]] = way.unknowns(s.y[:, over])[0]
                left[s.place[over]] = s.rest[over]
                s = s.pick(~over)
            if not len(s.place):
                break
            s = _step(way, s, tolerance)
    return Paths(ends, left)


def _predicted(s: _State, h: NDArray[np.float64]) -> NDArray[Any]:
    """The cubic through the last two points and their tangents, where there are two."""
    two = s.back > 0.0
    gap = np.where(two, s.back, 1.0)
    mean = (s.y - s.y_back) / gap
    second = (s.slope_back + 2.0 * s.slope - 3.0 * mean) / gap
    third = (s.slope_back + s.slope - 2.0 * mean) / gap**2
    return s.y + h * (s.slope + np.where(two, h * (second + h * third), 0.0))


def _step(way: _Map, s: _State, tolerance: float) -> _State:
    """The next point of each path, or the same one again and a shorter step."""
    h = np.minimum(s.h, s.rest)
    c, change = s.coefficients(s.rest - h)
    y = _predicted(s, h)
    first, _ = way.steps(c, change, y)
    second, slope = way.steps(c, change, y + first)
    y = y + first + second
    size = np.ones_like(y.real)
    size[way.logs :] += np.abs(y[way.logs :])
    one, two = (np.abs(first) / size).max(axis=0), (np.abs(second) / size).max(axis=0)
    near = one < 20.0 * tolerance
    good = near & ((two < 0.05 * one) & (two < 1e-4) | (two < 1e-12))
    # Where a solution is nearly singular the second correction may be rounding errors alone.
    vague = np.flatnonzero(near & ~good & (two < VAGUE))
    if len(vague):
        good[vague] = two[vague] < way.noise(c[:, vague], y[:, vague])
    wish = np.clip(0.9 * (tolerance / np.maximum(one, 1e-16)) ** 0.25, 0.2, 3.0)
    wish = np.where(np.isfinite(wish), wish, 0.2)
    return _State(
        s.place,
        s.end,
        s.line,
        s.turn,
        np.where(good, s.rest - h, s.rest),
        np.where(good, np.minimum(h * wish, LONGEST), h * np.minimum(wish, 0.5)),
        np.where(good, y, s.y),
        np.where(good, slope, s.slope),
        np.where(good, h, s.back),
        np.where(good, s.y, s.y_back),
        np.where(good, s.slope, s.slope_back),
    )
