"""Equilibria at which amplitudes vanish whose equations do not vanish with them.

They are special: an undamped absorber tuned exactly brings the driven amplitude to rest. The paths
that lead there lose themselves in the logarithms of the unknowns, just before the end. Newton's
method in the amplitudes themselves, in which such a point is like any other, takes them over.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._charts import Chart, chart, normal, parts
from ._flow import Flow, jacobian, rates
from ._systems import System, patterns

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["elsewhere", "on_planes", "solves"]

EPS = 2.0**-52
# An amplitude that its path has brought below this, over its scale, may vanish.
SMALL = 1e-3
# What is left of the rates at an equilibrium, over the sum of the terms' absolute values.
RESIDUAL = 64.0 * EPS
# Singular values of the Jacobian below this, over the largest: the point is not isolated.
SINGULAR = 1e-9
# An amplitude that is smaller, over its scale and the largest, vanishes if the others remain an
# equilibrium without it, up to LEFT of its terms.
NOTHING = 1e-12
LEFT = 1e-9

Found = tuple[Any, Any, Any]


def on_planes(
    system: System, flat: NDArray[Any], scales: NDArray[np.float64], z: NDArray[Any]
) -> list[Found]:
    """Regular equilibria where lost paths were heading to amplitudes that vanish.

    Parameters
    ----------
    system : System
    flat : numpy.ndarray
        Coefficients of the flow, one row for each path, shape (K, terms).
    scales : numpy.ndarray
        Of the active amplitudes, then of the drifts, shape (active + drifts, K).
    z : numpy.ndarray
        Where the paths were lost, shape (d, K).

    Returns
    -------
    list of (numpy.ndarray, numpy.ndarray, numpy.ndarray)
        For each set of amplitudes that are not zero: numbers of paths, all amplitudes (K', n) and
        drifts (K', symmetries). Sets that stay at rest by themselves are not among them.
    """
    rows, b, rate = _heading(system, scales, z)
    if not len(rows):
        return []
    flow, active, p = system.flow, list(system.active), len(system.active)
    whole = np.zeros((len(rows), flow.n), dtype=np.complex128)
    whole[:, active] = b
    drift = np.zeros((len(rows), len(flow.symmetries)))
    drift[:, list(system.drifts)] = rate
    size, c = np.zeros(whole.shape), flat[rows]
    size[:, active] = scales[:p, rows].T
    for _ in range(12):
        step, turn, least = _newton(system, c, whole, drift, size)
        whole, drift = whole + step, drift + turn
    # Zero where the rates do not tell it from zero.
    rest = np.where(np.abs(whole) < 1e-10 * size, 0.0, whole)
    rest = np.where(solves(flow, c, rest, drift)[:, None], rest, whole)
    good = solves(flow, c, rest, drift) & (least > SINGULAR)
    usual = patterns(flow)
    found = []
    for moves in np.unique(rest[good] != 0.0, axis=0):
        own = tuple(np.flatnonzero(moves).tolist())
        place = chart(flow, own)
        if own == system.active or (own not in usual and place.drifts == system.drifts):
            chosen = np.flatnonzero(good & ((rest != 0.0) == moves).all(axis=1))
            cells = np.ix_(chosen, np.flatnonzero(moves))
            rest[cells] = normal(place, rest[cells])
            found.append((rows[chosen], rest[chosen], drift[chosen]))
    return found


def elsewhere(
    place: Chart,
    c: NDArray[Any],
    b: NDArray[Any],
    turns: NDArray[Any],
    scales: NDArray[np.float64],
) -> NDArray[np.bool_]:
    """Where amplitudes that vanish leave equilibria of a smaller set of amplitudes.

    Amplitudes that others move do not vanish with their own: they can be as small as their cause.
    """
    size = np.abs(b) / scales[:, : b.shape[1]]
    small = size <= NOTHING * size.max(axis=1, keepdims=True)
    there, other = np.flatnonzero(small.any(axis=1)), np.zeros(len(b), dtype=bool)
    sets = patterns(place.flow)
    usual = [tuple(np.flatnonzero(~row).tolist()) in sets for row in small[there]]
    there = there[np.array(usual, dtype=bool)]
    rest = np.where(small, 0.0, b)[there]
    other[there] = solves(place.flow, c[there], rest, turns[there], LEFT)
    return other


def _heading(
    system: System, scales: NDArray[np.float64], z: NDArray[Any]
) -> tuple[NDArray[np.int64], NDArray[np.complex128], NDArray[np.float64]]:
    """Paths on which B̄ = conj(B) and an amplitude becomes small, none large."""
    p, inner = len(system.active), system.d - len(system.drifts)
    ones = np.ones(z.shape[1], dtype=np.complex128)
    plain = np.log(np.array([z[b] for b, _, _ in system.places]))
    barred = np.log(np.array([z[w] if w >= 0 else ones for _, w, _ in system.places]))
    modulus = 0.5 * (plain + barred).real
    small = modulus < np.log(SMALL)
    wanted = small.any(axis=0) & (modulus < -np.log(SMALL)).all(axis=0)
    wanted &= (np.abs(z[inner:].imag) < SMALL * (1.0 + np.abs(z[inner:]))).all(axis=0)
    rows = np.flatnonzero(wanted)
    plain, barred, small = plain[:, rows], barred[:, rows], small[:, rows]
    if system.drifts and len(rows):
        turns = np.array(system.flow.symmetries)[list(system.drifts)][:, list(system.active)]
        # Along the symmetries to where the amplitudes that do not vanish have |B̄| = |B|.
        weights = (~small).T.astype(float)
        design = weights[:, :, None] * turns.T
        right = 0.5 * (barred - plain).real.T * weights
        stretch = turns.T @ (np.linalg.pinv(design) @ right[..., None])[..., 0].T
        plain, barred = plain + stretch, barred - stretch
    plain, barred = np.exp(plain), np.exp(barred)
    gap = np.abs(barred - plain.conj()) < SMALL * (np.abs(plain) + np.abs(barred))
    kept = np.flatnonzero((gap | small).all(axis=0))
    rows = rows[kept]
    b = 0.5 * (plain + barred.conj())[:, kept] * scales[:p, rows]
    b[small[:, kept]] = 0.0
    return rows, b.T, (z[inner:, rows].real * scales[p:, rows]).T


def _residual(
    flow: Flow, c: NDArray[Any], b: NDArray[Any], drift: NDArray[Any]
) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:
    """Rates in the turning frame, and the sums of the moduli of their terms."""
    turns = np.array(flow.symmetries, dtype=float).reshape(len(flow.symmetries), flow.n)
    sizes = rates(flow, np.abs(c), np.abs(b)).real + np.abs(drift) @ np.abs(turns) * np.abs(b)
    return rates(flow, c, b) - 1j * (drift @ turns) * b, sizes


def solves(
    flow: Flow,
    c: NDArray[Any],
    b: NDArray[Any],
    drift: NDArray[Any],
    bound: float = RESIDUAL,
) -> NDArray[np.bool_]:
    """Where the rates, in the frame that drifts, vanish but for rounding, or a relative bound."""
    values, sizes = _residual(flow, c, b, drift)
    return np.asarray((np.abs(values) <= bound * sizes).all(axis=-1))


def _newton(
    system: System, c: NDArray[Any], b: NDArray[Any], drift: NDArray[Any], size: NDArray[Any]
) -> tuple[NDArray[Any], NDArray[Any], NDArray[np.float64]]:
    """The shortest step of Newton's method, and how regular the point is."""
    flow, p = system.flow, len(system.active)
    cells = [2 * a + side for a in system.active for side in (0, 1)]
    values, sizes = _residual(flow, c, b, drift)
    matrix = jacobian(flow, c, b, drift)[:, cells][:, :, cells]
    unit = np.repeat(size[:, list(system.active)], 2, axis=1)
    matrix = matrix * unit[:, None, :]
    for g in system.drifts:
        along = -1j * np.array(flow.symmetries[g]) * b
        matrix = np.concatenate((matrix, parts(along)[:, cells][..., None]), axis=2)
    # Each equation over the largest of its terms.
    most = np.abs(matrix).max(axis=2)
    most = np.maximum(most.reshape(-1, p, 2).max(axis=2), sizes[:, list(system.active)])
    most = np.repeat(np.where(most > 0.0, most, 1.0), 2, axis=1)
    matrix = matrix / most[:, :, None]
    usable = np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(values).all(axis=1)
    matrix = np.where(usable[:, None, None], matrix, 0.0)
    right = np.where(usable[:, None], parts(values)[:, cells] / most, 0.0)
    u, s, v = np.linalg.svd(matrix, full_matrices=False)
    inverse = np.where(s > SINGULAR * s[:, :1], 1.0 / np.where(s > 0.0, s, 1.0), 0.0)
    step = -np.einsum("kji,kj,klj,kl->ki", v, inverse, u, right)
    moved, turned = np.zeros_like(b), np.zeros_like(drift)
    change = step[:, : 2 * p] * unit
    moved[:, list(system.active)] = change[:, 0::2] + 1j * change[:, 1::2]
    turned[:, list(system.drifts)] = step[:, 2 * p :]
    return moved, turned, s[:, -1] / np.where(s[:, 0] > 0.0, s[:, 0], 1.0)
