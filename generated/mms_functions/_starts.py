"""All solutions, none of their unknowns zero, of sparse systems with generic coefficients.

The pairs of coefficients and solutions of a sparse system are one connected piece: choose any
solution, and the coefficients that go with it form a linear space of a fixed dimension. Loops of
coefficients therefore carry a single solution to every other one (Duff, Hill, Jensen, Lee, Leykin
and Sommars, "Solving polynomial systems via homotopy continuation and monodromy", IMA J. Numer.
Anal. 39, 2019). How many there are depends on the exponents alone: the mixed volume of their
convex hulls (Bernstein 1975), for all coefficients outside a set of measure zero.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from ._paths import Terms, newton, track

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["MOST", "distinct", "generic_solutions", "other_generic", "too_many"]

SEED = 20
# Triangles of coefficients in a round, and rounds without a new solution after which there is
# none. A loop permutes the solutions; were a single one of N missing, and the permutations
# random, all of them would leave it alone with the probability N^(-16).
LOOPS = 16
ROUNDS = 1
MOST = 400
"""More solutions than that take minutes to find, and seconds to follow to each point."""
TOGETHER = 4_000
"""Paths of a round that are followed before what they brought is counted."""


def distinct(z: NDArray[Any], known: NDArray[Any], distance: float = 1e-6) -> NDArray[Any]:
    """Columns of `z` that are neither in `known` nor twice in `z`, appended to `known`."""
    for k in range(z.shape[1]):
        point = z[:, k : k + 1]
        near = (np.abs(known - point) < distance * (np.abs(known) + np.abs(point))).all(axis=0)
        if not near.any():
            known = np.concatenate((known, point), axis=1)
    return known


def _random(random: np.random.Generator, *shape: int) -> NDArray[np.complex128]:
    """Complex numbers of moduli near one."""
    angle = random.uniform(0.0, 2.0 * np.pi, shape)
    return random.uniform(0.7, 1.4, shape) * np.exp(1j * angle)


def _seed(terms: Terms, d: int, random: np.random.Generator) -> tuple[NDArray[Any], NDArray[Any]]:
    """A point and coefficients that it solves."""
    z, c = _random(random, d, 1), _random(random, len(terms), 1)
    exponents = np.array([e for _, e in terms])
    products = np.prod(z[:, 0] ** exponents, axis=1)
    rows = np.array([row for row, _ in terms])
    for row in range(d):
        own = rows == row
        p = products[own]
        if len(p):
            c[own, 0] -= p.conj() * (p @ c[own, 0]) / (p.conj() @ p).real
    return c, z


@lru_cache(maxsize=64)
def generic_solutions(terms: Terms, d: int, logs: int) -> tuple[NDArray[Any], NDArray[Any]]:
    """Generic coefficients, and all solutions that go with them.

    Parameters
    ----------
    terms : Terms
        Exponents not negative; every equation has its own coefficients.
    d : int
        Number of unknowns and of equations.
    logs : int
        As for `track`.

    Returns
    -------
    coefficients : numpy.ndarray
        Shape (terms, 1).
    solutions : numpy.ndarray
        Shape (d, N), N = 0 where generic coefficients have none.

    Raises
    ------
    ValueError
        If there are more than `MOST`.
    """
    random = np.random.default_rng(SEED)
    base, z = _seed(terms, d, random)
    _, last, condition = newton(terms, base, z, logs)
    if not (last[0] < 1e-8 and condition[0] < 1e10):
        # Coefficients that have a solution at all are special: generic ones have none.
        return base, np.zeros((d, 0), dtype=np.complex128)
    idle = 0
    while idle < ROUNDS:
        known = z
        corners = [np.tile(base, (1, LOOPS)), *(_random(random, len(terms), LOOPS) for _ in "ab")]
        step = max(1, TOGETHER // known.shape[1])
        for k in range(0, LOOPS, step):
            some = [corner[:, k : k + step] for corner in corners]
            z = distinct(_carried(terms, known, some, logs), z)
            if z.shape[1] > MOST:
                raise too_many(d, z.shape[1])
        idle = idle + 1 if z.shape[1] == known.shape[1] else 0
    return base, z


@lru_cache(maxsize=64)
def other_generic(terms: Terms, d: int, logs: int) -> tuple[NDArray[Any], NDArray[Any]]:
    """Other generic coefficients and their solutions, as for `generic_solutions`."""
    base, z = generic_solutions(terms, d, logs)
    random = np.random.default_rng(SEED + 1)
    for _ in range(LOOPS):
        other = _random(random, len(terms), 1)
        begin, end = (np.broadcast_to(c, (len(terms), z.shape[1])) for c in (base, other))
        paths = track(terms, begin, end, z, logs, 1e-5)
        if (paths.left == 0.0).all() and distinct(paths.z, paths.z[:, :0]).shape == z.shape:
            return other, paths.z
    return base, z


def _carried(
    terms: Terms, z: NDArray[Any], corners: list[NDArray[Any]], logs: int
) -> NDArray[np.complex128]:
    """Where each triangle of coefficients carries each solution."""
    count = z.shape[1]
    points = np.tile(z, (1, corners[0].shape[1]))
    kept = np.arange(points.shape[1])
    for k in range(3):
        begin, end = (np.repeat(corners[(k + i) % 3], count, axis=1)[:, kept] for i in (0, 1))
        paths = track(terms, begin, end, points, logs)
        arrived = paths.left == 0.0
        points, kept = paths.z[:, arrived], kept[arrived]
    base = np.repeat(corners[0], count, axis=1)[:, kept]
    points, last, condition = newton(terms, base, points, logs, 3)
    return points[:, (last < 1e-10) & (condition < 1e12)]


def too_many(unknowns: int, least: int) -> ValueError:
    """The error for systems whose solutions cannot all be listed."""
    return ValueError(
        f"there are at least {least} complex equilibria, {unknowns} unknown amplitudes and phases "
        f"altogether, and no more than {MOST} can be listed: put amplitudes that are equal or "
        "stay zero together in a smaller model of them, as a symmetry allows, or follow single "
        "motions, with orbits.find and orbits.follow"
    )
