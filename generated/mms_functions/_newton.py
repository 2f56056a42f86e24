"""Candidates for equilibria of one amplitude, improved by Newton's method, each of them kept once.

The elimination of the phase has rounding errors of its own; here the slow flow itself decides what
is an equilibrium. Two candidates are one equilibrium if nothing but rounding is left of the rates
between them: so wide is a double root at a fold, and a triple one at a cusp wider still.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._elimination import Structure, harmonics

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["RESIDUAL", "Point", "Sums", "left_of", "polished", "sums"]

EPS = 2.0**-52

# What is left of the rates at an equilibrium, relative to the sum of their terms' absolute values:
# some dozen roundings. A fold that is missed by less than this counts as an equilibrium.
RESIDUAL = 64.0 * EPS

# Equilibria that are closer than this, relatively, are one: so are two that are a relative distance
# of 1e-14 from the fold at which they meet.
SAME = 1e-7

# Equilibria that are closer than this may be one, at a cusp: the cube root of some roundings.
WIDEST = 1e-3


class Sums(NamedTuple):
    """P = Σ f_k w^k at some points; its derivatives by ln r and by the angle of w; sizes."""

    value: NDArray[np.complex128]
    radial: NDArray[np.complex128]
    angular: NDArray[np.complex128]
    size: NDArray[np.float64]


def sums(structure: Structure, c: NDArray[np.complex128], r: NDArray[np.float64], w: Any) -> Sums:
    """P and its derivatives at r and w, one pair for each row of coefficients."""
    value, slope, size = harmonics(structure, c, r)
    total, radial, angular, turn = value[0], slope[0], 0.0 * value[0], w
    for k in range(1, structure.degree + 1):
        term = value[k] * turn
        total, radial, angular = total + term, radial + slope[k] * turn, angular + (1j * k) * term
        turn = turn * w
    return Sums(total, radial, angular, sum(size))


class Point(NamedTuple):
    """Candidates in polar form, w = e^{iθ}, and the sums there."""

    row: NDArray[np.int64]
    r: NDArray[np.float64]
    angle: NDArray[np.float64]
    sums: Sums


def polished(
    structure: Structure,
    c: NDArray[np.complex128],
    row: NDArray[np.int64],
    r: NDArray[np.float64],
    angle: NDArray[np.float64],
) -> Point:
    """Newton's method in ln r and the angle; drops what is no equilibrium, or there twice."""
    own, first, r, angle = c[row], (r, angle), r.copy(), angle.copy()
    going: Any = slice(None)
    for _ in range(16):
        s = sums(structure, own[going], r[going], np.exp(1j * angle[going]))
        det = s.radial.real * s.angular.imag - s.radial.imag * s.angular.real
        det = np.where(det == 0.0, np.inf, det)
        out = (s.value.imag * s.angular.real - s.value.real * s.angular.imag) / det
        turn = (s.value.real * s.radial.imag - s.value.imag * s.radial.real) / det
        length = np.maximum(np.abs(out), np.abs(turn))
        short = np.minimum(1.0, 0.1 / np.maximum(length, 1e-300))
        r[going] *= np.exp(short * out)
        angle[going] += short * turn
        going = np.arange(len(r))[going][length > 1e-9]
        if not len(going):
            break
    left = left_of(sums(structure, own, r, np.exp(1j * angle)))
    lost = np.flatnonzero(~(left <= RESIDUAL))
    if len(lost):
        # Where the Jacobian is nearly singular, at cusps above all, rounding throws Newton's method
        # out of an equilibrium: the candidate itself may be one.
        r[lost], angle[lost] = _valley(structure, own[lost], first[0][lost], first[1][lost])
        s = sums(structure, own[lost], r[lost], np.exp(1j * angle[lost]))
        left[lost] = left_of(s)
    order = np.flatnonzero(left <= RESIDUAL)
    order = order[np.lexsort((r[order], row[order]))]
    order = order[_distinct(structure, own, row, r, angle, left, order)]
    s = sums(structure, own[order], r[order], np.exp(1j * angle[order]))
    return Point(row[order], r[order], angle[order], s)


def left_of(s: Sums) -> NDArray[np.float64]:
    """What is left of the rates, relative to the sum of their terms' absolute values."""
    return np.asarray(np.abs(s.value) / s.size)


def _valley(
    structure: Structure, c: NDArray[np.complex128], r: NDArray[np.float64], angle: Any
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Nearby points where the rates have no part along the Jacobian's larger singular direction.

    These points lie on a curve that passes through all equilibria in the neighbourhood of one whose
    Jacobian is singular; Newton's method in one variable, the large one, finds it.
    """
    for _ in range(3):
        s = sums(structure, c, r, np.exp(1j * angle))
        # With J = [radial, angular], the larger direction (cos φ, sin φ) of JᵀJ.
        cross = 2.0 * (s.radial.conj() * s.angular).real
        phi = 0.5 * np.arctan2(cross, np.abs(s.radial) ** 2 - np.abs(s.angular) ** 2)
        slope = s.radial * np.cos(phi) + s.angular * np.sin(phi)
        step = -(slope.conj() * s.value).real / np.abs(slope) ** 2
        step = np.where(np.isfinite(step), np.clip(step, -0.1, 0.1), 0.0)
        r, angle = r * np.exp(step * np.cos(phi)), angle + step * np.sin(phi)
    return r, angle


def _distinct(
    structure: Structure,
    c: NDArray[np.complex128],
    row: NDArray[np.int64],
    r: NDArray[np.float64],
    angle: NDArray[np.float64],
    left: NDArray[np.float64],
    order: NDArray[np.int64],
) -> NDArray[np.bool_]:
    """Which of some points, in order of their rows and r, are there no better ones for.

    Two are one if they are very close, or if between them nothing but rounding is left of the
    rates; of the two that one stays of whose rates less is left.
    """
    kept = np.ones(len(order), dtype=bool)
    for shift in range(1, len(order)):
        a, b = order[:-shift], order[shift:]
        near = (r[b] - r[a] <= WIDEST * r[b]) & (row[b] == row[a])
        if not near.any():
            break
        place, a, b = np.flatnonzero(near), a[near], b[near]
        turn = np.angle(np.exp(1j * (angle[b] - angle[a])))
        same = (r[b] - r[a] <= SAME * r[b]) & (np.abs(turn) <= SAME)
        apart = np.flatnonzero(~same & (np.abs(turn) <= WIDEST))
        a, b = a[apart], b[apart]
        between = _valley(structure, c[a], np.sqrt(r[a] * r[b]), angle[a] + 0.5 * turn[apart])
        same[apart] = (
            left_of(sums(structure, c[a], between[0], np.exp(1j * between[1]))) <= RESIDUAL
        )
        place = place[same]
        former = left[order[place + shift]] < left[order[place]]
        kept[np.where(former, place, place + shift)] = False
    return kept
