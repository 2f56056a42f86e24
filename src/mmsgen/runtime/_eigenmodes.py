"""Natural frequencies and mode shapes of M q'' + G q' + K q = 0 at numbers, in batches.

M and K are symmetric and positive definite, G is skew: the frequencies are then real. This module
needs NumPy alone, because it is emitted beside the functions that use it.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ._runtime import companion_roots

__all__ = ["eigenmodes", "modal_values", "real_roots"]

#: of coupled coordinates: their number; which are in quadrature; (degree, multiplicity) of each
#: factor of the characteristic polynomial; (name, multiple) of each frequency; (name, coordinate,
#: mode, whether imaginary) of each component of a mode shape
Layout = tuple[
    int,
    "tuple[bool, ...] | None",
    "tuple[tuple[int, int], ...]",
    "tuple[tuple[str, float], ...]",
    "tuple[tuple[str, int, int, bool], ...]",
]


def modal_values(entries: Any, layouts: tuple[Layout, ...]) -> dict[str, Any]:
    """Natural frequencies and components of mode shapes by name.

    Parameters
    ----------
    entries : array_like, shape (..., size)
        For each set of coupled coordinates the entries of M, G and K, then the coefficients of the
        factors of the characteristic polynomial in ω², lowest power first.
    layouts : tuple
        What belongs to each set.

    Returns
    -------
    dict
        Name → array, NaN where M or K is not positive definite, or beyond the range of doubles.
    """
    numbers = np.asarray(entries, dtype=float)
    batch, start = numbers.shape[:-1], 0
    result: dict[str, Any] = {}
    for n, quadrature, factors, frequencies, components in layouts:
        matrices = numbers[..., start : start + 3 * n * n].reshape(*batch, 3, n, n)
        start += 3 * n * n
        squares = []
        for degree, multiplicity in factors:
            roots = real_roots(numbers[..., start : start + degree + 1])
            squares.append(np.repeat(roots, multiplicity, axis=-1))
            start += degree + 1
        inertia, gyroscopic, stiffness = (matrices[..., k, :, :] for k in range(3))
        with np.errstate(all="ignore"):
            omega, shapes = eigenmodes(inertia, gyroscopic, stiffness, quadrature)
        # Modes are numbered factor by factor, not by frequency.
        own = np.concatenate(squares, -1)
        rank = np.argsort(np.argsort(own, -1, kind="stable"), -1)
        known = np.isfinite(own).all(axis=-1)[..., None]
        omega = np.where(known, np.take_along_axis(omega, rank, axis=-1), np.nan)
        shapes = np.take_along_axis(shapes, rank[..., None, :], axis=-1)
        shapes = np.where(known[..., None], shapes, np.nan)
        for mode, (name, multiple) in enumerate(frequencies):
            if name:
                result.setdefault(name, omega[..., mode] / multiple)
        for name, row, mode, imaginary in components:
            part = shapes[..., row, mode]
            result[name] = (part.imag if imaginary else part.real)[()]
    return result


def eigenmodes(
    inertia: Any, gyroscopic: Any, stiffness: Any, quadrature: Any = None
) -> tuple[Any, Any]:
    """Frequencies and shapes, from the Hermitian form of the quadratic eigenproblem.

    With K = L_K L_Kᵀ, M = L_M L_Mᵀ, a = L_Kᵀφ and b = ω L_Mᵀφ, the equation
    (K + iωG − ω²M)φ = 0 becomes ω(a, b) = H(a, b) with H Hermitian.

    Parameters
    ----------
    inertia, gyroscopic, stiffness : array_like, shape (..., n, n)
        `gyroscopic` may be None.
    quadrature : sequence of bool, optional
        Coordinates that move in quadrature with the others, where that is so in every mode.

    Returns
    -------
    omega : numpy.ndarray, shape (..., n)
        Ascending, in rad/s; NaN where M or K is not positive definite.
    shapes : numpy.ndarray, shape (..., n, n), complex
        Column r is φ_r, with φ_rᴴ(2ω_r M − iG)φ_r = 2ω_r; its largest component is positive, or
        i times positive for a coordinate in quadrature.
    """
    m = np.asarray(inertia, dtype=float)
    k = np.asarray(stiffness, dtype=float)
    g = np.zeros_like(m) if gyroscopic is None else np.asarray(gyroscopic, dtype=float)
    m, g, k = np.broadcast_arrays(m, g, k)
    n = m.shape[-1]
    definite = _definite(m) & _definite(k)
    unit = np.eye(n)
    root_m = np.linalg.cholesky(np.where(definite[..., None, None], m, unit))
    root_k = np.linalg.cholesky(np.where(definite[..., None, None], k, unit))
    inverse = np.linalg.inv(root_m)
    h = np.zeros((*m.shape[:-2], 2 * n, 2 * n), dtype=complex)
    h[..., n:, :n] = inverse @ root_k
    h[..., :n, n:] = np.swapaxes(h[..., n:, :n], -1, -2)
    h[..., n:, n:] = 1j * (inverse @ g @ np.swapaxes(inverse, -1, -2))
    turn = np.ones(n, dtype=complex)
    if quadrature is not None:
        turn[np.asarray(quadrature, dtype=bool)] = 1j
        both = np.concatenate([turn, turn])
        h = (both.conj()[:, None] * h * both).real
    values, vectors = np.linalg.eigh(h)
    omega, b = values[..., n:], vectors[..., n:, n:]
    shapes = np.sqrt(2) * np.swapaxes(inverse, -1, -2) @ b
    shapes = _turned(shapes) * turn[:, None]
    omega = np.where(definite[..., None], omega, np.nan)
    return omega, np.where(definite[..., None, None], shapes, np.nan)


def _definite(matrix: Any) -> Any:
    finite = np.all(np.isfinite(matrix), axis=(-2, -1))
    safe = np.where(finite[..., None, None], matrix, 0.0)
    return finite & (np.linalg.eigvalsh(safe)[..., 0] > 0)


def _turned(shapes: Any) -> Any:
    """Every column with its largest component positive; of nearly equal ones the first."""
    size = np.abs(shapes)
    largest = (size > 0.999 * size.max(axis=-2, keepdims=True)).argmax(axis=-2)
    lead = np.take_along_axis(shapes, largest[..., None, :], axis=-2)
    return shapes * (np.abs(lead) / lead)


def real_roots(coefficients: Any) -> Any:
    """All roots of polynomials whose roots are real, ascending.

    Parameters
    ----------
    coefficients : array_like, shape (..., d + 1)
        Lowest power first; NaN comes out where one is not finite, or the highest one is zero.
    """
    c = np.asarray(coefficients, dtype=float)
    with np.errstate(all="ignore"):
        monic = c[..., :-1] / c[..., -1:]
    return np.sort(companion_roots(monic).real, axis=-1)
