"""How equilibria of nonlinear slow flows move with the parameters.

The theorem on implicit functions says so wherever the Jacobian is regular. Equilibria are known to
some roundings only; where they meet the Jacobian of a neighbour within these may be singular, and
there is no derivative.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._dual import array_slopes
from ._flow import Flow, jacobian, rates, wirtinger

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Slopes", "slopes_of"]

Kernel = Callable[..., Any]
Arguments = Sequence["NDArray[np.float64]"]

EPS = 2.0**-52

# What rates, and entries of the Jacobian, are off by, relative to the sum of their terms' absolute
# values: a rounding for each factor and each sum.
ROUNDING = 8.0 * EPS


class Slopes(NamedTuple):
    """How equilibria move with one parameter, the others fixed.

    Attributes
    ----------
    amplitudes : numpy.ndarray
        Complex dB_j/dp, shape (..., k, n). Phases are normalised as those of the amplitudes are.
    drift : numpy.ndarray
        Shape (..., k, g): dρ/dp.
    """

    amplitudes: NDArray[np.complex128]
    drift: NDArray[np.float64]


def slopes_of(
    flow: Flow,
    kernel: Kernel,
    arguments: Arguments,
    names: Sequence[str],
    amplitudes: NDArray[np.complex128],
    drift: NDArray[np.float64],
) -> dict[str, Slopes]:
    """Derivatives of equilibria by every parameter, from the theorem on implicit functions.

    The equations F(B, p) = i kρB are differentiated, and so are the phases that are fixed.

    Parameters
    ----------
    flow, kernel, arguments
        As for `jacobian_at`.
    names : sequence of str
        Of the arguments.
    amplitudes : numpy.ndarray
        Equilibria, shape (..., k, n), the leading axes those of the arguments.
    drift : numpy.ndarray
        Shape (..., k, symmetries).

    Returns
    -------
    dict
        Name → `Slopes`; NaN where equilibria meet, or so nearly that they may do so for all that
        double precision tells.
    """
    values, slopes = array_slopes(kernel, arguments, len(flow.terms))
    c, dc = values[..., None, :], slopes[..., None, :]
    with np.errstate(all="ignore"):
        matrix = _bordered(flow, c, amplitudes, drift)
        force = rates(flow, dc, amplitudes)  # (parameters, ..., k, n)
        right = np.zeros((*force.shape[:-1], matrix.shape[-1]))
        right[..., 0 : 2 * flow.n : 2] = -2.0 * force.real
        right[..., 1 : 2 * flow.n : 2] = -2.0 * force.imag
        inverse = _inverse(matrix)
        inverse[_undecided(flow, c, amplitudes, drift, inverse)] = np.nan
        moved = np.einsum("...ij,...j->...i", inverse, right)
    speed = (moved[..., 0 : 2 * flow.n : 2] + 1j * moved[..., 1 : 2 * flow.n : 2]) / 2.0
    return {name: Slopes(speed[i], moved[i, ..., 2 * flow.n :]) for i, name in enumerate(names)}


def _inverse(matrices: NDArray[np.float64]) -> NDArray[np.float64]:
    """Inverses, NaN where there is none."""
    finite = np.asarray(np.isfinite(matrices).all(axis=(-2, -1)))
    unit = np.eye(matrices.shape[-1])
    plain = np.where(finite[..., None, None], matrices, unit)
    regular = np.asarray(finite & (np.linalg.slogdet(plain)[0] != 0.0))
    found = np.linalg.inv(np.where(regular[..., None, None], plain, unit))
    return np.where(regular[..., None, None], found, np.nan)


def _undecided(
    flow: Flow,
    c: NDArray[Any],
    b: NDArray[np.complex128],
    drift: NDArray[np.float64],
    inverse: NDArray[np.float64],
) -> NDArray[np.bool_]:
    """Where a matrix within the errors of this one may be singular: meeting equilibria.

    What is left of the rates, rounding, moves the equilibrium, and so the matrix M. As long as
    the norm of |M⁻¹| |ΔM|, columns in units of the amplitudes, is below one, no matrix as near as
    that is singular (S. M. Rump, 1994: for every scaling of the columns).
    """
    n, size = flow.n, np.abs(b)
    turn = np.array(flow.symmetries, dtype=np.float64).reshape(-1, n)
    residual = np.abs(rates(flow, c, b) - 1j * (drift @ turn) * b)
    c, turn = np.abs(c), np.abs(turn)
    bend = np.array([max(sum(map(abs, e)) - 1, 0) for _, e in flow.terms])
    left = rates(flow, c, size).real + (np.abs(drift) @ turn) * size
    error = np.zeros(inverse.shape[:-1])
    error[..., : 2 * n] = np.repeat(2.0 * (residual + ROUNDING * left), 2, axis=-1)
    moved = np.einsum("...ij,...j->...i", np.abs(inverse), error)
    own = np.hypot(moved[..., 0 : 2 * n : 2], moved[..., 1 : 2 * n : 2]) / 2.0
    # Amplitudes that are zero are so exactly.
    shift = np.where(size > 0.0, own / np.where(size > 0.0, size, 1.0), 0.0)
    widest = shift.max(axis=-1)[..., None]
    sensitive = sum(wirtinger(flow, c * (ROUNDING + bend * widest), size))
    change = np.zeros(inverse.shape)
    change[..., : 2 * n, : 2 * n] = np.repeat(np.repeat(sensitive.real, 2, -1), 2, -2)
    units = np.where(size > 0.0, size, size.max(axis=-1, keepdims=True))
    units = np.where(units > 0.0, units, 1.0)
    scale = np.ones(inverse.shape[:-1])
    scale[..., : 2 * n] = np.repeat(2.0 * units, 2, axis=-1)
    if len(turn):
        rate = moved[..., 2 * n :] + ROUNDING * np.abs(drift)
        diagonal = np.repeat(rate @ turn, 2, axis=-1)
        change[..., range(2 * n), range(2 * n)] += diagonal
        column = 2.0 * turn.T * (np.where(size > 0.0, own, 0.0) + ROUNDING * size)[..., None]
        change[..., : 2 * n, 2 * n :] = np.repeat(column, 2, axis=-2)
        fastest = (left / units).max(axis=-1, keepdims=True)
        scale[..., 2 * n :] = np.where(fastest > 0.0, fastest, 1.0)
    image = np.einsum("...ij,...j->...i", change, scale)
    norm = (np.einsum("...ij,...j->...i", np.abs(inverse), image) / scale).max(axis=-1)
    return np.asarray(~(norm < 0.5))


def _bordered(
    flow: Flow, c: NDArray[Any], b: NDArray[np.complex128], drift: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The Jacobian by u_1, v_1, … and ρ_1, …, with a row for each phase that is fixed."""
    n, g = flow.n, len(flow.symmetries)
    inner = jacobian(flow, c, b, drift if g else None)
    missing = np.asarray(np.isnan(b).any(axis=-1))
    inner = np.where(missing[..., None, None], np.nan, inner)
    if not g:
        return inner
    whole = np.zeros((*inner.shape[:-2], 2 * n + g, 2 * n + g))
    whole[..., : 2 * n, : 2 * n] = inner
    for a, k in enumerate(flow.symmetries):
        direction = -2j * np.array(k) * b
        whole[..., 0 : 2 * n : 2, 2 * n + a] = direction.real
        whole[..., 1 : 2 * n : 2, 2 * n + a] = direction.imag
    active = np.abs(b) > 0.0
    flat, rows = whole.reshape(-1, 2 * n + g, 2 * n + g), active.reshape(-1, n)
    for pattern in np.unique(rows, axis=0):
        flat[(rows == pattern).all(axis=1), 2 * n :] = _phase_rows(flow, pattern)
    return flat.reshape(whole.shape)


def _phase_rows(flow: Flow, active: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Which phases are fixed: of the first amplitudes that the symmetries turn independently.

    A combination of symmetries that does not move the point has the rate zero.
    """
    n, k = flow.n, np.array(flow.symmetries, dtype=np.float64) * active
    pivots: list[int] = []
    for j in range(n):
        if np.linalg.matrix_rank(k[:, [*pivots, j]]) > len(pivots):
            pivots.append(j)
    found = np.zeros((len(k), 2 * n + len(k)))
    found[range(len(pivots)), [2 * j + 1 for j in pivots]] = 1.0
    found[len(pivots) :, 2 * n :] = np.linalg.svd(k.T)[2][len(pivots) :]
    return found
