"""How equilibria of nonlinear slow flows move with the parameters.

The theorem on implicit functions says so wherever the Jacobian is regular. Equilibria are known to
some roundings only; where they meet the Jacobian of a neighbour within these may be singular, and
there is no derivative.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._dual import array_slopes
from ._flow import Flow, jacobian, largest_first, neutral, rates, wirtinger

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "Slopes",
    "bordered",
    "carried",
    "directions",
    "eigenvalue_slopes",
    "forces",
    "in_parts",
    "jacobian_slopes",
    "phase_rows",
    "slopes_of",
]

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
    growth : numpy.ndarray
        Shape (..., k): of the growth rate; NaN where two eigenvalues meet that share it.
    """

    amplitudes: NDArray[np.complex128]
    drift: NDArray[np.float64]
    growth: NDArray[np.float64]


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
        matrix = bordered(flow, c, amplitudes, drift)
        right = -forces(flow, dc, amplitudes)
        inverse = _inverse(matrix)
        inverse[_undecided(flow, c, amplitudes, drift, inverse)] = np.nan
        moved = np.einsum("...ij,...j->...i", inverse, right)
        n = flow.n
        speed, turn = in_parts(flow, moved)
        change = jacobian_slopes(flow, dc, amplitudes, turn) + carried(flow, c, amplitudes, speed)
        growth = eigenvalue_slopes(
            flow, matrix[..., : 2 * n, : 2 * n], change, amplitudes, held=False
        )[1]
    each = zip(speed, turn, growth[..., 0].real, strict=True)
    return {name: Slopes(*own) for name, own in zip(names, each, strict=True)}


# --- the Jacobian and its eigenvalues -------------------------------------------------------------


def jacobian_slopes(
    flow: Flow, dc: NDArray[Any], amplitudes: NDArray[Any], turn: NDArray[Any]
) -> NDArray[np.float64]:
    """Derivatives of the Jacobian by the parameters, the amplitudes fixed.

    Parameters
    ----------
    flow : Flow
    dc : numpy.ndarray
        Shape (parameters, ..., terms): those of the coefficients.
    amplitudes : numpy.ndarray
        Shape (..., n).
    turn : numpy.ndarray
        Shape (parameters, ..., symmetries): those of the drift.

    Returns
    -------
    numpy.ndarray
        Shape (parameters, ..., 2n, 2n): the Jacobian is linear in both.
    """
    return jacobian(flow, dc, amplitudes, turn if flow.symmetries else None)


def carried(
    flow: Flow, c: NDArray[Any], amplitudes: NDArray[Any], speed: NDArray[Any]
) -> NDArray[np.float64]:
    """Derivatives of the Jacobian as the amplitudes move."""
    n = flow.n
    wide, places, weights = _lifted(flow)
    both = np.concatenate(np.broadcast_arrays(amplitudes, speed), axis=-1)
    return jacobian(wide, c[..., list(places)] * np.array(weights), both)[..., 2 * n :, : 2 * n]


@lru_cache(maxsize=64)
def _lifted(flow: Flow) -> tuple[Flow, tuple[int, ...], tuple[float, ...]]:
    """The flow of B beside its derivative along Ḃ, a flow of the 2n amplitudes (B, Ḃ).

    Its Jacobian by B has the derivative of the first flow's Jacobian along Ḃ in its lower half.

    Returns
    -------
    flow : Flow
        Without symmetries.
    places : tuple of int
        Which coefficient of the first flow belongs to each term.
    weights : tuple of float
        By what it is multiplied there.
    """
    n, plain = flow.n, (0,) * (3 * flow.n)
    terms: list[tuple[int, tuple[int, ...]]] = []
    places, weights = [], []
    for m, (j, e) in enumerate(flow.terms):
        found = [(j, (*e, *plain), 1.0)]
        for k in range(n):
            r, s, t = e[3 * k : 3 * k + 3]
            # d|B|^t = (t/2) |B|^{t-2} (B̄ dB + B dB̄)
            for weight, own, moving in (
                (r, (r - 1, s, t), (1, 0, 0)),
                (s, (r, s - 1, t), (0, 1, 0)),
                (t / 2, (r, s + 1, t - 2), (1, 0, 0)),
                (t / 2, (r + 1, s, t - 2), (0, 1, 0)),
            ):
                if weight:
                    first = (*e[: 3 * k], *own, *e[3 * k + 3 :])
                    second = (*plain[: 3 * k], *moving, *plain[3 * k + 3 :])
                    found.append((n + j, (*first, *second), float(weight)))
        for j_, e_, weight in found:
            terms.append((j_, e_))
            places.append(m)
            weights.append(weight)
    return Flow(2 * n, tuple(terms)), tuple(places), tuple(weights)


def eigenvalue_slopes(
    flow: Flow,
    matrices: NDArray[Any],
    changes: NDArray[Any],
    amplitudes: NDArray[Any],
    *,
    held: bool,
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Eigenvalues of Jacobians, and their derivatives.

    Parameters
    ----------
    flow : Flow
    matrices : numpy.ndarray
        Shape (..., 2n, 2n).
    changes : numpy.ndarray
        Shape (parameters, ..., 2n, 2n).
    amplitudes : numpy.ndarray
        Shape (..., n).
    held : bool
        Whether the amplitudes are fixed; otherwise they are those of an equilibrium, and move with
        it as `changes` say.

    Returns
    -------
    values : numpy.ndarray
        As from `spectrum`.
    slopes : numpy.ndarray
        Shape (parameters, ..., 2n); NaN where eigenvalues meet, unless each keeps its eigenvector.
    """
    size, shape = 2 * flow.n, matrices.shape[:-2]
    finite = np.asarray(np.isfinite(matrices).all(axis=(-2, -1)))
    flat = np.where(finite[..., None, None], matrices, 0.0).reshape(-1, size, size)
    moved = np.broadcast_to(changes, (len(changes), *matrices.shape)).reshape(-1, *flat.shape)
    values = np.full((len(flat), size), complex(np.nan, np.nan))
    slopes = np.full((len(changes), len(flat), size), complex(np.nan, np.nan))
    for rows, frames, m in neutral(flow, amplitudes, shape):
        found = _eigenvalue_slopes(flat[rows], moved[:, rows], frames, m, held)
        values[rows, : size - m], slopes[:, rows, : size - m] = found
    values = np.where(finite[..., None], values.reshape(*shape, size), np.nan)
    slopes = np.where(finite[..., None], slopes.reshape(-1, *shape, size), np.nan)
    order = largest_first(values)
    values = np.take_along_axis(values, order, axis=-1)
    return values, np.take_along_axis(slopes, np.broadcast_to(order, slopes.shape), axis=-1)


def _eigenvalue_slopes(
    matrices: NDArray[Any], changes: NDArray[Any], frames: NDArray[Any], m: int, held: bool
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """The same for the eigenvalues that belong to the last columns of orthogonal frames.

    The matrix takes the first m columns to zero: left eigenvectors do not contain them. Right ones
    do, and so do the slopes where these columns turn with the equilibrium.
    """
    turned = frames.swapaxes(-1, -2) @ matrices @ frames
    values, right = np.linalg.eig(turned[..., m:, m:])
    values, right = values.astype(complex), right.astype(complex)
    left = _inverse(right)
    # How many digits of the matrix an eigenvalue loses.
    skew = np.linalg.norm(left, axis=-1) * np.linalg.norm(right, axis=-2)
    along = 0.0 if held else 1.0 / values[..., None, :]
    along = turned[..., :m, m:] @ right * along
    right = frames @ np.concatenate([along, right], axis=-2)
    left = left @ frames[..., m:].swapaxes(-1, -2)
    slopes = np.einsum("...ai,...ia->...a", left, changes @ right)
    known = (skew * EPS**0.5 < 1.0) & np.isfinite(right).all(axis=-2)
    return values, np.where(known, slopes, np.nan)


# --- the equations of an equilibrium --------------------------------------------------------------


def _inverse(matrices: NDArray[Any]) -> NDArray[Any]:
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


def forces(flow: Flow, dc: NDArray[Any], amplitudes: NDArray[Any]) -> NDArray[np.float64]:
    """Derivatives of the equations of an equilibrium by the parameters, the amplitudes fixed."""
    force = rates(flow, dc, amplitudes)
    found = np.zeros((*force.shape[:-1], 2 * flow.n + len(flow.symmetries)))
    found[..., 0 : 2 * flow.n : 2] = 2.0 * force.real
    found[..., 1 : 2 * flow.n : 2] = 2.0 * force.imag
    return found


def in_parts(flow: Flow, moved: NDArray[np.float64]) -> tuple[NDArray[Any], NDArray[np.float64]]:
    """Complex amplitudes, and the rates of drift, of what u_1, v_1, …, ρ_1, … do."""
    n = flow.n
    return (moved[..., 0 : 2 * n : 2] + 1j * moved[..., 1 : 2 * n : 2]) / 2.0, moved[..., 2 * n :]


def bordered(
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
    whole[..., : 2 * n, 2 * n :] = directions(flow, b)
    active = np.abs(b) > 0.0
    flat, rows = whole.reshape(-1, 2 * n + g, 2 * n + g), active.reshape(-1, n)
    for pattern in np.unique(rows, axis=0):
        flat[(rows == pattern).all(axis=1), 2 * n :] = phase_rows(flow, pattern)
    return flat.reshape(whole.shape)


def directions(flow: Flow, b: NDArray[np.complex128]) -> NDArray[np.float64]:
    """What the equations change by with the rates of drift: shape (..., 2n, symmetries)."""
    turned = -2j * np.array(flow.symmetries).T * b[..., None]
    return np.stack((turned.real, turned.imag), axis=-2).reshape(
        *b.shape[:-1], 2 * flow.n, len(flow.symmetries)
    )


def phase_rows(flow: Flow, active: NDArray[np.bool_]) -> NDArray[np.float64]:
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
