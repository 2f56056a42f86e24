"""Autonomous slow flows at numbers: rates, Jacobians and their spectra, in batches.

A slow flow is a sparse polynomial in complex amplitudes and their moduli,

    dB_j/dt = Σ_m c_m Π_k B_k^{r_k} B̄_k^{s_k} |B_k|^{t_k},

the sum over the terms m of equation j. Its terms are fixed; the coefficients c_m depend on the
parameters, and come as an array whose last axis counts the terms.

A symmetry is a vector k of integers: with B_j also B_j e^{i k_j θ} is a solution, for every θ. An
equilibrium then belongs to a circle of them, and may drift along it, B_j e^{i k_j ρ t}, with a rate
ρ for every symmetry.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Flow", "jacobian", "largest_first", "neutral", "rates", "spectrum", "wirtinger"]


class Flow(NamedTuple):
    """The fixed part of a slow flow.

    Attributes
    ----------
    n : int
        Number of amplitudes.
    terms : tuple of (int, tuple of int)
        Equation j, then r_1, s_1, t_1, … r_n, s_n, t_n.
    symmetries : tuple of tuple of int
        Independent vectors k.
    """

    n: int
    terms: tuple[tuple[int, tuple[int, ...]], ...]
    symmetries: tuple[tuple[int, ...], ...] = ()


def _factor(b: Any, r: int, s: int, t: int) -> Any:
    """B^r B̄^s |B|^t; the modulus of zero to a negative power counts as one."""
    value: Any = 1.0
    if r:
        value = b**r if r > 1 else b
    if s:
        value = value * (b.conj() ** s if s > 1 else b.conj())
    if t:
        size = np.abs(b)
        value = value * (size**t if t > 0 else np.where(size == 0.0, 1.0, size) ** float(t))
    return value


def _product(amplitudes: list[Any], exponents: tuple[int, ...], skip: int = -1) -> Any:
    """The monomial of a term, without the amplitude `skip`."""
    value: Any = 1.0
    for k, b in enumerate(amplitudes):
        r, s, t = exponents[3 * k : 3 * k + 3]
        if k != skip and (r or s or t):
            value = value * _factor(b, r, s, t)
    return value


def _columns(amplitudes: Any, n: int) -> list[Any]:
    b = np.asarray(amplitudes, dtype=np.complex128)
    return [b[..., k] for k in range(n)]


def rates(flow: Flow, coefficients: Any, amplitudes: Any) -> NDArray[np.complex128]:
    """The right-hand sides dB_j/dt.

    Parameters
    ----------
    flow : Flow
    coefficients : array_like
        Shape (..., terms).
    amplitudes : array_like
        Shape (..., n); leading axes broadcast against those of the coefficients.
    """
    c, columns = np.asarray(coefficients), _columns(amplitudes, flow.n)
    shape = np.broadcast_shapes(c.shape[:-1], columns[0].shape)
    out = np.zeros((*shape, flow.n), dtype=np.complex128)
    for m, (j, exponents) in enumerate(flow.terms):
        out[..., j] += c[..., m] * _product(columns, exponents)
    return out


def wirtinger(
    flow: Flow, coefficients: Any, amplitudes: Any
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Derivatives of the rates by B_k and by B̄_k, both of shape (..., n, n)."""
    c, columns = np.asarray(coefficients), _columns(amplitudes, flow.n)
    shape = np.broadcast_shapes(c.shape[:-1], columns[0].shape)
    plain = np.zeros((*shape, flow.n, flow.n), dtype=np.complex128)
    barred = np.zeros_like(plain)
    for m, (j, exponents) in enumerate(flow.terms):
        for k, b in enumerate(columns):
            r, s, t = exponents[3 * k : 3 * k + 3]
            if not (r or s or t):
                continue
            rest = c[..., m] * _product(columns, exponents, skip=k)
            # |B|^t = (B B̄)^{t/2}; its derivative keeps B̄ |B|^{t-2}, which is bounded at zero.
            if r:
                plain[..., j, k] += rest * r * _factor(b, r - 1, s, t)
            if s:
                barred[..., j, k] += rest * s * _factor(b, r, s - 1, t)
            if t:
                plain[..., j, k] += rest * (t / 2) * _factor(b, r, s + 1, t - 2)
                barred[..., j, k] += rest * (t / 2) * _factor(b, r + 1, s, t - 2)
    return plain, barred


def jacobian(
    flow: Flow, coefficients: Any, amplitudes: Any, drift: Any = None
) -> NDArray[np.float64]:
    """The Jacobian of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    Parameters
    ----------
    flow, coefficients, amplitudes
        As for `rates`.
    drift : array_like, optional
        Shape (..., symmetries): rates at which the frame turns along the symmetries.

    Returns
    -------
    numpy.ndarray
        Shape (..., 2n, 2n), rows and columns in the order u_1, v_1, u_2, v_2, …
    """
    plain, barred = wirtinger(flow, coefficients, amplitudes)
    n = flow.n
    if drift is not None and flow.symmetries:
        turn = np.asarray(drift) @ np.array(flow.symmetries, dtype=np.float64)
        shape = np.broadcast_shapes(plain.shape[:-1], turn.shape)
        plain = np.broadcast_to(plain, (*shape, n)).copy()
        plain[..., range(n), range(n)] -= 1j * turn
    both, apart = plain + barred, plain - barred
    out = np.empty((*both.shape[:-2], n, 2, n, 2))
    out[..., 0, :, 0], out[..., 0, :, 1] = both.real, -apart.imag
    out[..., 1, :, 0], out[..., 1, :, 1] = both.imag, apart.real
    return out.reshape(*both.shape[:-2], 2 * n, 2 * n)


def spectrum(
    flow: Flow, coefficients: Any, amplitudes: Any, drift: Any = None
) -> NDArray[np.complex128]:
    """Eigenvalues of the Jacobian at equilibria, in 1/s, without those that symmetries make zero.

    Parameters
    ----------
    flow, coefficients, amplitudes, drift
        As for `jacobian`. A symmetry that leaves the equilibrium where it is takes no eigenvalue
        away.

    Returns
    -------
    numpy.ndarray
        Shape (..., 2n), the largest real part first; NaN at the end for those that are left out,
        and everywhere where an argument is not finite.
    """
    matrices = jacobian(flow, coefficients, amplitudes, drift)
    finite = np.asarray(np.isfinite(matrices).all(axis=(-2, -1)))
    matrices = np.where(finite[..., None, None], matrices, 0.0)
    if flow.symmetries:
        size = 2 * flow.n
        flat = matrices.reshape(-1, size, size)
        found = np.full((len(flat), size), complex(np.nan, np.nan))
        for rows, frames, m in neutral(flow, amplitudes, finite.shape):
            across = frames[..., m:]
            own = across.swapaxes(-1, -2) @ flat[rows] @ across
            found[rows, : size - m] = np.linalg.eigvals(own)
        values = found.reshape(*finite.shape, size)
    else:
        values = np.linalg.eigvals(matrices).astype(complex)
    values = np.where(finite[..., None], values, complex(np.nan, np.nan))
    return np.take_along_axis(values, largest_first(values), axis=-1)


def largest_first(values: NDArray[np.complex128]) -> NDArray[np.int64]:
    """Indices along the last axis by which eigenvalues are sorted; NaN comes last.

    Of two with the same real part that one comes first that LAPACK gives first.
    """
    return np.argsort(-values.real, axis=-1, kind="stable")


def neutral(
    flow: Flow, amplitudes: Any, shape: tuple[int, ...]
) -> Iterator[tuple[NDArray[np.intp], NDArray[np.float64], int]]:
    """The directions along circles of equilibria, i k_j B_j, and their complement.

    The Jacobian takes these directions to zero, so that it is block triangular with them, and the
    other eigenvalues are those on the complement. Where a circle turns by much faster than it
    attracts, a zero that is left in the matrix would take half of all digits from the others.

    Parameters
    ----------
    flow : Flow
    amplitudes : array_like
        Shape (..., n).
    shape : tuple of int
        To which they are broadcast, without the last axis.

    Yields
    ------
    rows : numpy.ndarray
        Points in a row.
    frames : numpy.ndarray
        Shape (rows, 2n, 2n), orthogonal: in the first m columns the directions.
    m : int
        How many symmetries move these points.
    """
    b = np.broadcast_to(np.asarray(amplitudes, dtype=np.complex128), (*shape, flow.n))
    b, unit = b.reshape(-1, flow.n), np.eye(2 * flow.n)
    if not flow.symmetries:
        yield np.arange(len(b)), np.broadcast_to(unit, (len(b), *unit.shape)), 0
        return
    size = np.where(np.abs(b) > 0.0, np.abs(b), 0.0)  # zero for NaN
    order = np.argsort(-size, axis=-1, kind="stable")
    kinds, index = np.unique(
        np.concatenate([size > 0.0, order], axis=-1), axis=0, return_inverse=True
    )
    for number, kind in enumerate(kinds):
        rows = np.flatnonzero(index.ravel() == number)
        turns, pivots = _directions(flow, kind[: flow.n], kind[flow.n :])
        m = len(pivots)
        if not m:
            yield rows, np.broadcast_to(unit, (len(rows), *unit.shape)), 0
            continue
        # over the amplitude that leads, which is the largest one: these are independent
        moved = turns * b[rows, np.newaxis] / size[rows][:, pivots, np.newaxis]
        along = np.stack([-moved.imag, moved.real], axis=-1).reshape(-1, m, 2 * flow.n)
        yield rows, np.linalg.qr(along.swapaxes(-1, -2), mode="complete")[0], m


def _directions(
    flow: Flow, active: NDArray[Any], order: NDArray[Any]
) -> tuple[NDArray[np.float64], list[int]]:
    """Combinations of the symmetries that move a point, each with an amplitude of its own.

    Returns the multiples k, one row for each, and the amplitude that moves in this row alone: the
    largest ones that serve, so that no larger one moves with it.
    """
    k = np.array(flow.symmetries, dtype=np.float64) * active
    pivots: list[int] = []
    for j in map(int, order):
        if np.linalg.matrix_rank(k[:, [*pivots, j]]) > len(pivots):
            pivots.append(j)
    return np.linalg.pinv(k[:, pivots]) @ k if pivots else k[:0], pivots
