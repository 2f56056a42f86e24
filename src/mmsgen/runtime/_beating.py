"""How the amplitudes of a linear slow flow beat: period, and the largest amplitude ever reached.

From a start x(0) a block moves as x(t) = Σ_k p_k e^{Γ_k t} over its distinct eigenvalues, with
p_k = Π_{l≠k} (S − Γ_l)/(Γ_k − Γ_l) x(0), Lagrange's interpolation, which needs no eigenvectors.

Neutral modes alone, |e^{Γ_k t}| = 1: with two of them |x_j|² = |p_1|² + |p_2|² + 2|p_1 p_2| cos(…)
has the period 2π/|Γ_1 − Γ_2| and the maximum |p_1| + |p_2|. With more the amplitude comes as near
to Σ|p_k| as one likes if the differences of the eigenvalues are incommensurable (Kronecker 1884).
Where modes decay, the maximum is searched for in time and bounded from above.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._evolution import (
    Blocks,
    Linear,
    block_matrix,
    demand_common_shape,
    exponential,
    linear_parts,
)
from ._runtime import checked_amplitudes, stacked

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Beating", "beat", "beating_at"]

_SAME = 1e-7
"""Eigenvalues that are closer, over the norm of the matrix, count as one: a double one that is
defective comes out of doubles as two, 1e-8 apart."""

_NOTHING = 1e-10
"""A part that is smaller, over the size of the start, counts as none."""

_SAMPLES = 512
"""Times at which decaying amplitudes are looked at."""


class Beating(NamedTuple):
    """How amplitudes beat, for each coordinate, |B_j| being half the real amplitude.

    Attributes
    ----------
    period : numpy.ndarray
        Shape (..., n), s: after it |B_j| repeats, up to the decay; NaN unless exactly two
        frequencies take part.
    largest : numpy.ndarray
        Shape (..., n): the least upper bound of |B_j(t)| for t ≥ 0; infinite where it grows.
    margin : numpy.ndarray
        Shape (..., n): how far `largest` may be too small; 0 where it is a closed form.
    """

    period: Any
    largest: Any
    margin: Any


def beat(
    plain: NDArray[np.complex128],
    barred: NDArray[np.complex128],
    blocks: Blocks,
    amplitudes: NDArray[np.complex128],
) -> Beating:
    """Period and largest amplitude of every coordinate.

    Parameters
    ----------
    plain, barred : numpy.ndarray
        C and D of dB_j/dt = Σ_k (C_jk B_k + D_jk B̄_k), shape (..., n, n).
    blocks : Blocks
    amplitudes : numpy.ndarray
        Those at t = 0, shape (..., n).

    Returns
    -------
    Beating
        NaN where an entry of C or D is not finite.
    """
    n = amplitudes.shape[-1]
    shape = np.broadcast_shapes(plain.shape[:-2], amplitudes.shape[:-1])
    period, largest, margin = (np.full((*shape, n), np.nan) for _ in range(3))
    for nodes in blocks:
        m = len(nodes)
        matrix = block_matrix(plain, barred, nodes)
        start = np.stack([amplitudes[..., j].conj() if b else amplitudes[..., j] for j, b in nodes])
        start = np.moveaxis(start, 0, -1)
        matrices = np.broadcast_to(matrix, (*shape, m, m)).reshape(-1, m, m)
        starts = np.broadcast_to(start, (*shape, m)).reshape(-1, m)
        with np.errstate(all="ignore"):
            found = _in_units(matrices, starts).reshape(3, *shape, m)
        for row, (j, _) in reversed(list(enumerate(nodes))):
            period[..., j], largest[..., j], margin[..., j] = found[..., row]
    return Beating(period, largest, margin)


def _in_units(matrices: NDArray[Any], starts: NDArray[Any]) -> NDArray[np.float64]:
    """Period, largest and margin of points in a row, shape (3, points, m).

    Rates and amplitudes are measured in powers of two near the largest of them: this changes no
    digit, and their squares stay within the range of doubles.
    """
    out = np.full((3, *starts.shape), np.nan)
    good = np.isfinite(matrices).all(axis=(-2, -1)) & np.isfinite(starts).all(axis=-1)
    fast, large = _exponent(matrices[good], (-2, -1)), _exponent(starts[good], (-1,))
    found = _of_block(_shifted(matrices[good], -fast), _shifted(starts[good], -large))
    out[0, good] = np.ldexp(found[0], -fast[:, 0])
    out[1:, good] = np.ldexp(found[1:], large)
    return out


def _exponent(numbers: NDArray[np.complex128], axes: tuple[int, ...]) -> NDArray[np.intc]:
    """The power of two next to the largest part of complex numbers, the axes kept."""
    largest = np.maximum(np.abs(numbers.real), np.abs(numbers.imag)).max(axis=axes, keepdims=True)
    return np.asarray(np.frexp(largest)[1])


def _shifted(numbers: NDArray[np.complex128], power: NDArray[np.intc]) -> NDArray[np.complex128]:
    out = np.empty_like(numbers)
    out.real, out.imag = np.ldexp(numbers.real, power), np.ldexp(numbers.imag, power)
    return out


def _of_block(matrices: NDArray[Any], starts: NDArray[Any]) -> NDArray[np.float64]:
    """Period, largest and margin of points in a row, all numbers finite."""
    out = np.full((3, *starts.shape), np.nan)
    for rows, rates, parts, defective in _parts(matrices, starts):
        size = np.abs(matrices[rows]).sum(axis=-1).max(axis=-1)
        level = _SAME * size[:, None]
        weight = np.abs(parts)  # (points, K, m)
        whole = weight.sum(axis=1)
        active = weight > _NOTHING * np.abs(starts[rows]).max(axis=-1)[:, None, None]
        growing = ((rates.real > level)[:, :, None] & active).any(axis=1)
        decaying = ((rates.real < -level)[:, :, None] & active).any(axis=1)
        endless = growing | (defective & ~decaying & active.any(axis=1))
        own = np.stack([_period(rates, active), whole, np.zeros_like(whole)])
        falling = np.where(np.abs(rates.real) > level, rates.real, 0.0) + 1j * rates.imag
        for simple in (True, False):
            chosen = decaying & ~endless & (defective != simple)
            search = np.flatnonzero(chosen.any(axis=1))
            if len(search):
                points = rows[search]
                found = (
                    _searched(falling[search], parts[search])
                    if simple
                    else _followed(matrices[points], starts[points], falling[search])
                )
                own[1:, search] = np.where(chosen[search], found, own[1:, search])
        own[1][endless] = np.inf
        own[0][endless] = np.nan
        out[:, rows] = own
    return out


def _eigenvalues(matrices: NDArray[Any]) -> NDArray[np.complex128]:
    if matrices.shape[-1] != 2:
        return np.asarray(np.linalg.eigvals(matrices)).astype(complex)
    a, b, c, d = (matrices[:, i, j] for i in (0, 1) for j in (0, 1))
    half = (a - d) / 2
    q = np.sqrt(half * half + b * c)
    return np.stack([(a + d) / 2 + q, (a + d) / 2 - q], axis=-1)


def _parts(
    matrices: NDArray[Any], starts: NDArray[Any]
) -> Iterator[tuple[Any, Any, Any, NDArray[np.bool_]]]:
    """Groups of points with the same number of distinct eigenvalues.

    Yields their rows, the eigenvalues (points, K), the parts p_k (points, K, m), and for each
    coordinate whether a part is no eigenvector, so that a power of t goes with it.
    """
    values = _eigenvalues(matrices)
    size = np.abs(matrices).sum(axis=-1).max(axis=-1) if len(values) else np.zeros(0)
    near = np.abs(values[:, :, None] - values[:, None, :]) <= _SAME * size[:, None, None]
    patterns, index = np.unique(near.argmax(axis=-1), axis=0, return_inverse=True)
    for number, pattern in enumerate(patterns):
        rows = np.flatnonzero(index.ravel() == number)
        labels = np.unique(pattern)
        rates = np.stack([values[rows][:, pattern == k].mean(axis=1) for k in labels], axis=1)
        own = matrices[rows]
        parts = []
        for k in range(len(labels)):
            p = starts[rows][..., None]
            for other in range(len(labels)):
                if other != k:
                    gap = (rates[:, k] - rates[:, other])[:, None, None]
                    p = (own @ p - rates[:, other, None, None] * p) / gap
            parts.append(p[..., 0])
        stacked = np.stack(parts, axis=1)
        left = (own[:, None] @ stacked[..., None])[..., 0] - rates[..., None] * stacked
        scale = size[rows] * np.abs(starts[rows]).max(axis=-1)
        # In a defective pair the nilpotent part takes a start of size one to one of size ‖S‖.
        defective = np.abs(left).max(axis=1) > np.sqrt(_SAME) * scale[:, None]
        yield rows, rates, stacked, defective


def _period(rates: NDArray[Any], active: NDArray[np.bool_]) -> NDArray[np.float64]:
    """2π over the difference of the two frequencies that take part."""
    turning = np.where(active, rates.imag[:, :, None], -np.inf).max(axis=1)
    lowest = np.where(active, rates.imag[:, :, None], np.inf).min(axis=1)
    period = 2 * np.pi / (turning - lowest)
    two = active.sum(axis=1) == 2
    return np.asarray(np.where(two & np.isfinite(period), period, np.nan))


def _searched(rates: NDArray[Any], parts: NDArray[Any]) -> NDArray[np.float64]:
    """The largest |Σ_k p_k e^{Γ_k t}| for t ≥ 0, none of them growing, and its margin.

    At samples a distance h apart |x|² is at most M h²/8 below the maximum near by, M being a bound
    of its second derivative; beyond the last sample Σ|p_k e^{Γ_k t}|, which only falls, is one of
    |x|.
    """
    weight, decay = np.abs(parts), rates.real
    gaps = np.abs(rates.imag[:, :, None] - rates.imag[:, None, :])
    beat_ = np.where(gaps > 0.0, gaps, np.inf).min(axis=(1, 2))
    slowest = np.where(decay < 0.0, -decay, np.inf).min(axis=1)
    until = np.minimum(2 * np.pi * (rates.shape[1] - 1) / beat_, 40.0 / slowest)
    until = np.where(until > 0.0, until, 40.0 / slowest)
    sums = np.abs(rates[:, :, None] + rates[:, None, :].conj()) ** 2
    bend = np.einsum("pkj,plj,pkl->pj", weight, weight, sums)
    top = np.empty_like(bend)
    sampled = np.empty_like(bend)
    for first in range(0, len(top), 32):
        piece = slice(first, first + 32)
        t = until[piece, None] * np.linspace(0.0, 1.0, _SAMPLES)
        values = np.abs(np.exp(t[..., None] * rates[piece, None]) @ parts[piece])
        sampled[piece] = values.max(axis=1)
        top[piece] = _zoomed(rates[piece], parts[piece], t, values)
    step = until / (_SAMPLES - 1)
    between = np.sqrt(sampled**2 + bend * (step**2 / 8)[:, None])
    later = (weight * np.exp(decay * until[:, None])[..., None]).sum(axis=1)
    top = np.maximum(top, np.where((decay < 0.0)[..., None], 0.0, weight).sum(axis=1))
    return np.stack([top, np.maximum(np.maximum(between, later) - top, 0.0)])


def _followed(
    matrices: NDArray[Any], starts: NDArray[Any], rates: NDArray[Any]
) -> NDArray[np.float64]:
    """The same where eigenvalues coincide: sampled, with the bend of |x|² as it is found."""
    out = np.empty((2, *starts.shape))
    for row, (matrix, start) in enumerate(zip(matrices, starts, strict=True)):
        slowest = -rates[row].real[rates[row].real < 0.0].max()
        t = np.linspace(0.0, 40.0 / slowest, _SAMPLES)
        x = (exponential(matrix, t) @ start[:, None])[..., 0]
        speed = x @ matrix.T
        bend = 2 * np.abs((x.conj() * (speed @ matrix.T)).real + np.abs(speed) ** 2).max(axis=0)
        top = np.abs(x).max(axis=0)
        out[0, row], out[1, row] = top, np.sqrt(top**2 + bend * t[1] ** 2 / 8) - top
    return out


def _zoomed(
    rates: NDArray[Any], parts: NDArray[Any], t: NDArray[Any], values: NDArray[Any]
) -> NDArray[np.float64]:
    """The maxima beside the highest samples."""
    best = values.argmax(axis=1)
    centre = np.take_along_axis(t, best, axis=1)  # (points, m)
    step = (t[:, 1] - t[:, 0])[:, None]
    top = values.max(axis=1)
    for _ in range(3):
        local = centre[..., None] + step[..., None] * np.linspace(-1.0, 1.0, 33)
        local = np.maximum(local, 0.0)
        turned = np.exp(local[..., None] * rates[:, None, None])  # (points, m, 33, K)
        found = np.abs(np.einsum("pjtk,pkj->pjt", turned, parts))
        place = found.argmax(axis=-1)[..., None]
        centre = np.take_along_axis(local, place, axis=-1)[..., 0]
        top = np.maximum(top, found.max(axis=-1))
        step = step / 16
    return top


def beating_at(
    linear: Linear,
    kernel: Callable[..., Any],
    arguments: Sequence[NDArray[np.float64]],
    amplitudes: ArrayLike,
) -> Beating:
    """How amplitudes beat from those at t = 0: see `beat` and `linear_parts`.

    Raises
    ------
    ValueError
        If an argument is not as it should be, or the shapes do not broadcast.
    """
    start = stacked(checked_amplitudes(amplitudes, linear.n))
    plain, barred = linear_parts(linear, kernel, arguments)
    demand_common_shape(plain, start)
    return beat(plain, barred, linear.blocks, start)
