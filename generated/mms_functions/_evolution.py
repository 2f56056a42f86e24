"""Linear slow flows as initial-value problems: amplitudes at any time, and how they beat.

A linear slow flow, dB_j/dt = Σ_k (C_jk B_k + D_jk B̄_k), falls apart into blocks of amplitudes and
conjugates, x = (B_j or B̄_j, …), dx/dt = S x, solved by x(t) = e^{St} x(0). The exponential is a
closed form for blocks of one and two. Larger ones are scaled, put into the diagonal Padé
approximant of degree 13 and squared: N. J. Higham, *SIAM J. Matrix Anal. Appl.* 26 (2005) 1179.
No eigenvectors are needed, so that nothing happens where two eigenvalues meet.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._runtime import checked_amplitudes, evaluate_array, refuse_masked, stacked

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Blocks",
    "Linear",
    "block_matrix",
    "checked_times",
    "demand_common_shape",
    "evolution_at",
    "evolve",
    "exponential",
    "linear_parts",
]

Blocks = tuple[tuple[tuple[int, int], ...], ...]
"""For each block its variables: (j, 0) for B_j, (j, 1) for its conjugate."""

_PADE = tuple(
    c / 64764752532480000.0
    for c in (
        64764752532480000.0,
        32382376266240000.0,
        7771770303897600.0,
        1187353796428800.0,
        129060195264000.0,
        10559470521600.0,
        670442572800.0,
        33522128640.0,
        1323241920.0,
        40840800.0,
        960960.0,
        16380.0,
        182.0,
        1.0,
    )
)
"""The numerator of the approximant; the denominator has the signs of the odd powers changed. With
the first one 1, e^0 is 1 to the last bit."""

_REACH = 5.371920351148152
"""Norm up to which the approximant is as good as double precision."""

_PIECE = 2048
"""Matrices that are worked on together."""


def checked_times(t: ArrayLike) -> NDArray[np.float64]:
    """Times as a float64 array.

    Raises
    ------
    ValueError
        If a value is not a finite real number.
    """
    refuse_masked("the array of times", t)
    array = np.asarray(t)
    if array.dtype.kind not in "iuf":
        raise ValueError(f"the times must be real numbers, got {t!r}")
    array = array.astype(np.float64, copy=False)
    if not np.isfinite(array).all():
        raise ValueError("the times must be finite")
    return array


def block_matrix(
    plain: NDArray[np.complex128],
    barred: NDArray[np.complex128],
    nodes: Sequence[tuple[int, int]],
) -> NDArray[np.complex128]:
    """The matrix S of one block.

    Parameters
    ----------
    plain, barred : numpy.ndarray
        C and D, shape (..., n, n).
    nodes : sequence of (int, int)

    Returns
    -------
    numpy.ndarray
        Shape (..., m, m).
    """
    m = len(nodes)
    out = np.empty((*plain.shape[:-2], m, m), dtype=np.complex128)
    for row, (j, turned) in enumerate(nodes):
        for column, (k, other) in enumerate(nodes):
            entry = plain[..., j, k] if turned == other else barred[..., j, k]
            out[..., row, column] = entry.conj() if turned else entry
    return out


def evolve(
    plain: NDArray[np.complex128],
    barred: NDArray[np.complex128],
    blocks: Blocks,
    t: NDArray[np.float64],
    amplitudes: NDArray[np.complex128],
) -> NDArray[np.complex128]:
    """Amplitudes at a time from those at t = 0.

    Parameters
    ----------
    plain, barred : numpy.ndarray
        C and D, shape (..., n, n).
    blocks : Blocks
    t : numpy.ndarray
        Shape (...).
    amplitudes : numpy.ndarray
        Shape (..., n). All leading axes broadcast.

    Returns
    -------
    numpy.ndarray
        Shape (..., n).
    """
    shape = np.broadcast_shapes(plain.shape[:-2], t.shape, amplitudes.shape[:-1])
    out = np.empty((*shape, amplitudes.shape[-1]), dtype=np.complex128)
    for nodes in blocks:
        start = np.stack([_turned(amplitudes[..., j], b) for j, b in nodes], axis=-1)
        with np.errstate(all="ignore"):
            moved = exponential(block_matrix(plain, barred, nodes), t) @ start[..., None]
        for row, (j, b) in reversed(list(enumerate(nodes))):  # B_j itself where both are there
            out[..., j] = _turned(moved[..., row, 0], b)
    return out


def _turned(b: Any, conjugated: int) -> Any:
    return b.conj() if conjugated else b


def exponential(matrix: NDArray[np.complex128], t: Any) -> NDArray[np.complex128]:
    """e^{St} for matrices of shape (..., m, m) and times that broadcast with their leading axes.

    Its error is a few units of rounding times ‖St‖ and the largest ‖e^{Su}‖ ‖e^{S(t−u)}‖, u
    between 0 and t, which no method can avoid; NaN where an entry is not finite.
    """
    t = np.asarray(t, dtype=np.float64)
    m = matrix.shape[-1]
    if m == 1:
        return np.asarray(np.exp(matrix * t[..., None, None]))
    if m == 2:
        return _of_two(matrix, t)
    shape = np.broadcast_shapes(matrix.shape[:-2], t.shape)
    exponents = np.broadcast_to(matrix * t[..., None, None], (*shape, m, m)).reshape(-1, m, m)
    out = np.full(exponents.shape, complex(np.nan, np.nan))
    good = np.flatnonzero(np.isfinite(exponents).all(axis=(-2, -1)))
    for first in range(0, len(good), _PIECE):
        chosen = good[first : first + _PIECE]
        out[chosen] = _by_squaring(exponents[chosen])
    return out.reshape(*shape, m, m)


def _of_two(matrix: NDArray[np.complex128], t: NDArray[np.float64]) -> NDArray[np.complex128]:
    """e^{μt} (cosh qt + (S − μ) sinh(qt)/q), μ the mean of the eigenvalues, μ ± q."""
    a, b = matrix[..., 0, 0], matrix[..., 0, 1]
    c, d = matrix[..., 1, 0], matrix[..., 1, 1]
    mean, half = (a + d) / 2, (a - d) / 2
    q = np.sqrt(half * half + b * c)
    up, down = np.exp((mean + q) * t), np.exp((mean - q) * t)
    small = np.abs(q * t) < 0.5
    squared = np.where(small, q * t, 0.0) ** 2
    series: Any = 1.0  # of sinh(x)/x, to x^{14}/15!, which is below rounding for |x| < 1/2
    for k in range(14, 0, -2):
        series = 1.0 + squared / (k * (k + 1)) * series
    divided = np.where(q == 0.0, 1.0, q)
    even = (up + down) / 2
    odd = np.where(small, t * np.exp(mean * t) * series, (up - down) / (2 * divided))
    out = np.empty((*even.shape, 2, 2), dtype=np.complex128)
    out[..., 0, 0], out[..., 0, 1] = even + half * odd, b * odd
    out[..., 1, 0], out[..., 1, 1] = c * odd, even - half * odd
    return out


def _by_squaring(exponents: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """The exponential of finite matrices, shape (points, m, m)."""
    m = exponents.shape[-1]
    unit = np.eye(m)
    mean = np.trace(exponents, axis1=-2, axis2=-1) / m
    centred = exponents - mean[:, None, None] * unit
    size = np.abs(centred).sum(axis=-2).max(axis=-1)
    halvings = np.ceil(np.log2(np.maximum(size / _REACH, 1.0))).astype(int)
    x = centred / (2.0**halvings)[:, None, None]
    square = x @ x
    fourth = square @ square
    sixth = fourth @ square
    c = _PADE
    odd = sixth @ (c[13] * sixth + c[11] * fourth + c[9] * square)
    odd = x @ (odd + c[7] * sixth + c[5] * fourth + c[3] * square + c[1] * unit)
    even = sixth @ (c[12] * sixth + c[10] * fourth + c[8] * square)
    even = even + c[6] * sixth + c[4] * fourth + c[2] * square + c[0] * unit
    # The mean goes in before the squarings: e^{μ} and the rest may each leave the range of doubles.
    step = np.exp(mean / 2.0**halvings)[:, None, None]
    result = step * np.linalg.solve(even - odd, even + odd)
    for k in range(int(halvings.max(initial=0))):
        rows = np.flatnonzero(halvings > k)
        result[rows] = result[rows] @ result[rows]
    return np.asarray(result)


# --- emitted functions ----------------------------------------------------------------------------


class Linear(NamedTuple):
    """The fixed part of a linear slow flow.

    Attributes
    ----------
    n : int
        Number of amplitudes.
    blocks : Blocks
    """

    n: int
    blocks: Blocks


def linear_parts(
    linear: Linear, kernel: Callable[..., Any], arguments: Sequence[NDArray[np.float64]]
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """C and D of dB_j/dt = Σ_k (C_jk B_k + D_jk B̄_k), from its values at unit vectors.

    Parameters
    ----------
    linear : Linear
    kernel : callable
        Fills its first argument with the rates, from amplitudes and arguments.
    arguments : sequence of numpy.ndarray
    """
    n = linear.n

    def column(k: int, unit: complex) -> NDArray[np.complex128]:
        units = [np.asarray(unit if j == k else 0.0, dtype=np.complex128) for j in range(n)]
        return evaluate_array(kernel, [*units, *arguments], (n,))

    pairs = [(column(k, 1.0), column(k, 1.0j)) for k in range(n)]
    plain = np.stack([(real - 1j * imaginary) / 2 for real, imaginary in pairs], axis=-1)
    barred = np.stack([(real + 1j * imaginary) / 2 for real, imaginary in pairs], axis=-1)
    return plain, barred


def evolution_at(
    linear: Linear,
    kernel: Callable[..., Any],
    arguments: Sequence[NDArray[np.float64]],
    t: ArrayLike,
    amplitudes: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at times from those at t = 0: see `evolve` and `linear_parts`.

    Raises
    ------
    ValueError
        If an argument is not as it should be, or the shapes do not broadcast.
    """
    times, start = checked_times(t), stacked(checked_amplitudes(amplitudes, linear.n))
    plain, barred = linear_parts(linear, kernel, arguments)
    demand_common_shape(plain, start, times)
    return evolve(plain, barred, linear.blocks, times, start)


def demand_common_shape(plain: Any, start: Any, times: Any = 0.0) -> None:
    """Refuse times, amplitudes and parameters that do not broadcast together."""
    shapes = np.shape(times), start.shape[:-1], plain.shape[:-2]
    try:
        np.broadcast_shapes(*shapes)
    except ValueError:
        text = ", ".join(f"{n}: {s}" for n, s in zip(_SHAPES, shapes, strict=True))
        raise ValueError(f"shapes that do not broadcast together: {text}") from None


_SHAPES = ("times", "amplitudes without their last axis", "parameters")
