"""All equilibria of a slow flow of one amplitude, in batches.

The elimination of the phase leaves a real polynomial in |B|, all positive roots of which are found;
each gives its phases. Newton's method in the plane takes out the rounding of the elimination, and
what does not satisfy the slow flow to rounding is dropped.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._elimination import Polynomial, Structure, harmonics, relation, rows_of, structure_of
from ._flow import Flow, wirtinger
from ._newton import RESIDUAL, Point, Sums, left_of, polished, sums
from ._records import Equilibria
from ._roots import near_roots

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

__all__ = ["equilibria_of_one"]

EPS = 2.0**-52

# Points that are solved together: their arrays stay in the cache.
BLOCK = 2048

# Extrema of the resultant that are relatively this small may be roots that its rounding hides.
LOOSE = 1e-8

# Binary exponents of coefficients, up to which nothing that is computed here leaves the range of
# the numbers: the resultant of two harmonics is made of their fourth powers.
ORDINARY = 64

# --- equilibria -----------------------------------------------------------------------------------


class _Found(NamedTuple):
    """Equilibria one after the other: their rows, B, drift and growth."""

    row: NDArray[np.int64]
    amplitude: NDArray[np.complex128]
    drift: NDArray[np.float64]
    growth: NDArray[np.float64]


def equilibria_of_one(flow: Flow, coefficients: Any, circles: bool = True) -> Equilibria:
    """All equilibria of a slow flow of one amplitude.

    Parameters
    ----------
    flow : Flow
        With n = 1.
    coefficients : array_like
        Shape (..., terms).
    circles : bool
        Whether to list circles that belong to a symmetry which the flow has at single points only.

    Returns
    -------
    Equilibria
        Every isolated equilibrium, or circle of them where the flow has a symmetry: B = 0 where it
        is one, and each of the m phases of a subharmonic. A double one, at a fold, is there once,
        with a growth rate that is zero to within the square root of the precision. All NaN where
        there is none, where a coefficient is not finite, and where the equilibria fill a curve.

        Where all terms vanish that tell one phase from another, as without its force those of a
        forced oscillator, the flow has a symmetry as well. A circle that is at rest, without a
        drift, is then listed once, by its real and positive B; its growth is that of |B|.

    Raises
    ------
    ValueError
        If they fill a curve at every point of the batch; if at every point the coefficients differ
        by more orders of magnitude than numbers have (points of that kind among others are NaN).
    """
    c = np.asarray(coefficients, dtype=np.complex128)
    lead, flat = c.shape[:-1], c.reshape(-1, c.shape[-1])
    parts, filled, lost = [], 0, 0
    for start in range(0, len(flat), BLOCK):
        part = flat[start : start + BLOCK]
        finite = np.flatnonzero(np.isfinite(part).all(axis=-1))
        for pattern, alike in _patterns(part, finite):
            structure = structure_of(flow, tuple(map(bool, pattern)))
            with np.errstate(all="ignore"):
                scaled, units, usable = _in_range(structure, part[alike])
                rows, lost = alike[usable], lost + len(alike) - len(usable)
                found, infinite = _solved(flow, structure, scaled[usable], circles)
                found = _in_units(found, *(x[usable] for x in units))
            filled += infinite
            parts.append(found._replace(row=rows[found.row] + start))
    if filled and filled == len(flat):
        raise ValueError(
            "the equilibria of this slow flow are not isolated: they fill a curve, as all "
            "amplitudes of an undamped free oscillator do; damping or forcing is missing, or the "
            "backbone curve is what is looked for"
        )
    if lost and lost == len(flat):
        raise ValueError(
            "the terms of this slow flow differ by so many orders of magnitude that their squares "
            "are not in the range of the numbers: take other units, or leave the small ones out"
        )
    return _padded(parts, len(flat), len(flow.symmetries), lead)


def _patterns(
    c: NDArray[np.complex128], rows: NDArray[np.int64]
) -> Iterator[tuple[NDArray[np.bool_], NDArray[np.int64]]]:
    """Rows together whose terms vanish alike."""
    while len(rows):
        present = c[rows] != 0.0
        same = (present == present[0]).all(axis=-1)
        yield present[0], rows[same]
        rows = rows[~same]


def _in_range(structure: Structure, c: NDArray[np.complex128]) -> tuple[Any, ...]:
    """Coefficients for β = B/2^b and the time 2^t, where theirs would leave the numbers' range.

    Returns
    -------
    scaled : numpy.ndarray
        Those that are near one, as they usually are, are left alone.
    units : tuple of numpy.ndarray
        b and −t of each point; empty if all are left alone.
    usable : numpy.ndarray
        Points at which no power becomes so small that its part in the resultant vanishes.
    """
    every = np.arange(len(c))
    terms = [i for i, _, _ in structure.terms]
    powers = np.array([p for _, _, p in structure.terms], dtype=np.int64)
    exponents = np.frexp(np.maximum(np.abs(c[:, terms].real), np.abs(c[:, terms].imag)))[1]
    wide = (np.abs(exponents) > ORDINARY).any(axis=-1)
    if not wide.any():
        return c, (), every
    exponents = exponents.astype(np.int64)
    # The lowest and the highest power become alike, the largest coefficient one.
    low, high = powers == powers.min(), powers == powers.max()
    fall = exponents[:, low].max(axis=-1) - exponents[:, high].max(axis=-1)
    size = np.where(wide, np.round(fall / max(int(np.ptp(powers)), 1)), 0).astype(np.int64)
    own = exponents + size[:, None] * powers
    rate = np.where(wide, own.max(axis=-1), 0)
    smallest = -1000 // max(2 * structure.degree, 1)
    # A term may vanish beside a far larger one of the same power.
    largest = np.stack([own[:, powers == p].max(axis=-1) for p in np.unique(powers)])
    usable = every[~wide | (largest.min(axis=0) - rate > smallest)]
    shift = np.maximum(size[:, None] * powers - rate[:, None], -4000).astype(np.int32)
    scaled = c.copy()
    scaled[:, terms] = np.ldexp(c[:, terms].real, shift) + 1j * np.ldexp(c[:, terms].imag, shift)
    return scaled, (size, rate + size * (structure.common - 1)), usable


def _in_units(found: _Found, *units: NDArray[np.int64]) -> _Found:
    """Amplitudes and rates in their own units again."""
    if not units:
        return found
    size, rate = (x[found.row].astype(np.int32) for x in units)
    b = np.ldexp(found.amplitude.real, size) + 1j * np.ldexp(found.amplitude.imag, size)
    return _Found(found.row, b, np.ldexp(found.drift, rate), np.ldexp(found.growth, rate))


def _padded(parts: list[_Found], count: int, symmetries: int, lead: tuple[int, ...]) -> Equilibria:
    """Rectangular arrays, NaN at the end of each row."""
    none = _Found(np.zeros(0, dtype=np.int64), np.zeros(0, complex), np.zeros(0), np.zeros(0))
    row, b, rate, growing = (np.concatenate(p) for p in zip(none, *parts, strict=True))
    order = np.argsort(row, kind="stable")
    row = row[order]
    number = np.bincount(row, minlength=count)
    width = int(number.max(initial=0))
    place = np.arange(len(row)) - (np.cumsum(number) - number)[row]
    amplitudes = np.full((count, width, 1), complex(np.nan, np.nan))
    drift, growth = np.full((count, width, symmetries), np.nan), np.full((count, width), np.nan)
    amplitudes[row, place, 0], growth[row, place] = b[order], growing[order]
    if symmetries:
        drift[row, place, 0] = rate[order]
    return Equilibria(
        amplitudes.reshape(*lead, width, 1),
        drift.reshape(*lead, width, symmetries),
        growth.reshape(*lead, width),
    )


def _solved(
    flow: Flow, structure: Structure, c: NDArray[np.complex128], circles: bool
) -> tuple[_Found, int]:
    """The equilibria of some points, and at how many points they fill a curve."""
    eliminated = relation(structure, c)
    filled = ~np.any([x != 0.0 for x in eliminated.values()], axis=0) & np.ones(len(c), dtype=bool)
    row, r = _moduli(eliminated, len(c), LOOSE if structure.degree else 0.0)
    if structure.degree:
        row, r, w = _phases(structure, c, row, r)
        point = polished(structure, c, row, r, np.angle(w))
    else:
        point = Point(row, r, np.zeros_like(r), sums(structure, c[row], r, np.ones_like(r)))
    if not (structure.degree or structure.circle):
        point = _at_rest(point)
        # With another harmonic than the first the stability is not the same all along the circle.
        filled[point.row if structure.lowest else []] = True
        if structure.lowest or not circles:
            point = _some(point, np.zeros(0, dtype=np.int64))
    drift, growth = _stability(structure, point)
    row, b, drift, growth = _every_phase(structure, point, drift, growth)
    zero = np.flatnonzero(~filled & _zero_is_one(flow, c))
    plain, barred = wirtinger(flow, c[zero], np.zeros((len(zero), 1)))
    plain, barred = plain[:, 0, 0], barred[:, 0, 0]
    own = _largest(2.0 * plain.real, np.abs(plain) ** 2 - np.abs(barred) ** 2)
    if structure.circle:
        own = plain.real
    row, b = np.concatenate((zero, row)), np.concatenate((np.zeros(len(zero), complex), b))
    drift = np.concatenate((np.zeros(len(zero)), drift))
    growth = np.concatenate((own, growth))
    order = np.argsort(row, kind="stable")
    return _Found(row[order], b[order], drift[order], growth[order]), int(filled.sum())


def _some(point: Point, index: NDArray[np.int64]) -> Point:
    row, r, angle, (value, radial, angular, size) = point
    kept = Sums(value[index], radial[index], angular[index], size[index])
    return Point(row[index], r[index], angle[index], kept)


def _at_rest(point: Point) -> Point:
    """The points, at different r, that do not drift: nothing but rounding is left of the rates."""
    return _some(point, np.flatnonzero(left_of(point.sums) <= RESIDUAL))


def _zero_is_one(flow: Flow, c: NDArray[np.complex128]) -> NDArray[np.bool_]:
    """Where B = 0 is an equilibrium: no force that is left there."""
    at_zero = [i for i, (_, e) in enumerate(flow.terms) if sum(e) <= 0]
    return np.asarray((c[:, at_zero] == 0.0).all(axis=-1))


def _moduli(
    polynomial: Polynomial, count: int, loose: float
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Rows and candidates for r."""
    table, step = rows_of(polynomial, count)
    roots, extrema = near_roots(table, loose)
    row, place = np.nonzero(np.isfinite(roots))
    found = roots[row, place]
    if loose:
        # From both sides of an extremum: two roots may be there, or a double one.
        more, place = np.nonzero(np.isfinite(extrema))
        x = extrema[more, place]
        own = table[more]
        powers = np.arange(table.shape[1])
        terms = own * x[:, None] ** powers
        bend = np.abs((terms * (powers * (powers - 1.0))).sum(axis=-1)) / 2.0
        gap = np.abs(terms.sum(axis=-1)) + EPS * np.abs(terms).sum(axis=-1)
        side = np.clip(np.sqrt(gap / bend), 1e-7, 1e-2)
        row = np.concatenate((row, more, more))
        found = np.concatenate((found, x * (1.0 - side), x * (1.0 + side)))
    return row, found ** (1.0 / step)


def _phases(
    structure: Structure,
    c: NDArray[np.complex128],
    row: NDArray[np.int64],
    r: NDArray[np.float64],
) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.complex128]]:
    """Candidates for r with those for w, near the unit circle.

    What vanishes there together with its reciprocal does so with what is left of both when their
    highest powers are eliminated, down to a linear one (Schur, 1918).
    """
    f, _, size = harmonics(structure, c[row], r)
    left, bound = f, size
    for d in range(structure.degree, 1, -1):
        first, last = left[0].conj(), left[d]
        left = [first * left[k] - last * left[d - k].conj() for k in range(d)]
        bound = [bound[0] * bound[k] + bound[d] * bound[d - k] for k in range(d)]
    w = -left[0] / left[1]
    if structure.degree > 1:
        # Both vanish where several phases belong to one r.
        many = np.flatnonzero(~(np.abs(left[1]) > 1e-3 * bound[1]))
        more = _all_phases([x[many] for x in f])
        w = np.concatenate((w, *more))
        row = np.concatenate((row, *(row[many] for _ in more)))
        r = np.concatenate((r, *(r[many] for _ in more)))
    near = np.abs(np.abs(w) - 1.0) < 0.1  # false for NaN
    return row[near], r[near], w[near]


def _all_phases(f: list[NDArray[np.complex128]]) -> list[NDArray[np.complex128]]:
    """All roots w of f_0 + f_1 w + … + f_d w^d."""
    d = len(f) - 1
    if d == 2:
        root = np.sqrt(f[1] * f[1] - 4.0 * f[2] * f[0])
        root = np.where((f[1].conj() * root).real < 0.0, -root, root)
        q = -0.5 * (f[1] + root)
        return [q / f[2], f[0] / q]
    matrices = np.zeros((len(f[0]), d, d), dtype=np.complex128)
    matrices[:, 1:, :-1] = np.eye(d - 1)
    matrices[:, :, -1] = -np.stack([x / f[d] for x in f[:d]], axis=-1)
    usable = np.asarray(np.isfinite(matrices).all(axis=(-2, -1)))
    roots = np.linalg.eigvals(np.where(usable[:, None, None], matrices, 0.0))
    return list(np.where(usable[:, None], roots, np.nan).T)


def _largest(trace: Any, determinant: Any) -> Any:
    """The largest real part of the eigenvalues of a real 2 × 2 matrix."""
    half = 0.5 * trace
    root = np.sqrt(np.maximum(half * half - determinant, 0.0))
    # Without cancellation where the determinant is small and the trace negative.
    return np.where((half < 0.0) & (root > 0.0), determinant / (half - root), half + root)


def _stability(
    structure: Structure, point: Point
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Drift and growth rate: eigenvalues of the Jacobian of d(ln r)/dt and dγ/dt."""
    _, r, angle, s = point
    scale = r ** float(structure.common - 1)
    if structure.circle or not structure.degree:
        return scale * s.value.imag, scale * s.radial.real
    factor = scale * np.exp((1j * structure.lowest / structure.fold) * angle)
    radial, angular = factor * s.radial, (structure.fold * factor) * s.angular
    trace = radial.real + angular.imag
    highest = max((p + structure.fold * k for _, k, p in structure.terms), default=0)
    size = scale * s.size * (1 + highest)
    trace = np.where(np.abs(trace) <= 4.0 * EPS * size, 0.0, trace)
    determinant = radial.real * angular.imag - radial.imag * angular.real
    return np.zeros_like(r), _largest(trace, determinant)


def _every_phase(
    structure: Structure, point: Point, drift: Any, growth: Any
) -> tuple[Any, Any, Any, Any]:
    """Each of the m phases, in increasing order of |B| and then of the phase in [0, 2π)."""
    row, r, angle, _ = point
    m = structure.fold if structure.degree else 1
    phase = (angle[:, None] + 2.0 * np.pi * np.arange(m)) / m
    phase = np.mod(phase, 2.0 * np.pi).ravel()
    phase[phase > 2.0 * np.pi - 1e-9] = 0.0
    row, r = np.repeat(row, m), np.repeat(r, m)
    drift, growth = np.repeat(drift, m), np.repeat(growth, m)
    # Moduli that differ by rounding alone, as those of mirror images, leave the order to the phase.
    order = np.lexsort((r, row))
    fresh = np.ones(len(row), dtype=bool)
    fresh[1:] = (np.diff(row[order]) != 0) | (np.diff(r[order]) > 1e-9 * r[order][1:])
    order = order[np.lexsort((phase[order], np.cumsum(fresh)))]
    b = r * np.exp(1j * phase) if structure.degree else r.astype(np.complex128)
    return row[order], b[order], drift[order], growth[order]
