"""How far eigenvalues can be from those computed, when the matrix is known up to an error E.

Three bounds, the sharpest of which is taken for each eigenvalue. x_i, y_i are right and left
eigenvectors and κ_i = |x_i||y_i|/|y_i*x_i| the condition number of μ_i.

1. *Isolated*: |μ̃_i - μ_i| ≤ κ_i E/(1 - S_i), S_i = Σ_{j≠i} κ_j E/(|μ_i - μ_j| - 2κ_i E), if
   S_i ≤ 1/2. From |(z - Φ)⁻¹| ≤ Σ_j κ_j/|z - μ_j|: on the circle of that radius about μ_i the
   right-hand side is at most 1/E, so no eigenvalue crosses it while the error grows from 0 to E.
   This is first-order perturbation theory with its remainder.
2. *Discs* (Bauer & Fike, Wilkinson): all eigenvalues of Φ + δ lie in the union of the discs
   |z - μ_j| ≤ N κ_j E, each component holding as many as it has centres. Repeated semisimple
   multipliers, as of identical blades, have moderate κ: their common component is of size N κ E,
   not of size √E.
3. *Cluster*: m neighbouring multipliers taken together, with their invariant subspace, whose
   spectral projector has norm p. On it the matrix is μ̄ + A, perturbed by at most 2pE, and by
   Elsner's theorem the eigenvalues move by at most (2|A| + 2pE)^(1-1/m) (2pE)^(1/m). Where two
   multipliers merge into a Jordan block |A| stays finite, and this is the square root of E; where
   they merely meet |A| vanishes with their distance, and the bound is of size E again: the same
   formula tells the cases apart.

Sources: Stewart & Sun, *Matrix Perturbation Theory* (1990), ch. IV and V; Elsner, *Linear Algebra
and its Applications* 71 (1985) 77-80.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt
import scipy  # loads its subpackages when they are first used

from .points import Floats

__all__ = ["Complexes", "eigenvalues_with_error"]

Complexes: TypeAlias = npt.NDArray[np.complex128]
LARGEST_CLUSTER = 4
WORTH_A_LOOK = 1e3


def eigenvalues_with_error(
    matrix: Floats, error: Floats, wanted: Floats, *, absolute: bool = False
) -> tuple[Complexes, Floats]:
    """Eigenvalues of each matrix of a stack, with bounds of their errors.

    Parameters
    ----------
    matrix : numpy.ndarray, shape (points, N, N)
        The computed matrices.
    error : numpy.ndarray, shape (points,)
        Bound of the error of each matrix in the 2-norm; inf where it is unknown.
    wanted : numpy.ndarray, shape (points,)
        An eigenvalue that the cheap bounds place within this radius, in units of the largest
        modulus, is not looked at more closely.
    absolute : bool
        `wanted` is a radius as it stands.

    Returns
    -------
    value : numpy.ndarray of complex, shape (points, N)
        Eigenvalues in LAPACK's order; NaN for a matrix that is not finite.
    radius : numpy.ndarray, shape (points, N)
        Each disc about a value holds an eigenvalue of the exact matrix, and the discs together
        hold them all.
    """
    points, size = matrix.shape[:2]
    value = np.full((points, size), np.nan, dtype=np.complex128)
    radius = np.full((points, size), np.inf)
    finite = np.isfinite(matrix).all(axis=(1, 2))
    if not finite.any():
        return value, radius
    with np.errstate(all="ignore"):
        found, vectors = np.linalg.eig(matrix[finite])
        value[finite] = found
        condition = _conditions(vectors)
        bound = _disc_bounds(value[finite], condition, error[finite])
    radius[finite] = bound
    with np.errstate(all="ignore"):
        largest = 1.0 if absolute else np.abs(value).max(axis=1)
        # Clusters cannot do better than a few E: looking closer pays where κ is large.
        enough = np.maximum(wanted * largest, WORTH_A_LOOK * error)
    known = np.isfinite(error) & finite
    for point in np.flatnonzero(known & (radius > enough[:, None]).any(axis=1)):
        doubtful = np.flatnonzero(radius[point] > enough[point])
        sharpened = _cluster_bounds(matrix[point], value[point], float(error[point]), doubtful)
        radius[point, doubtful] = np.minimum(radius[point, doubtful], sharpened)
    return value, radius


def _conditions(vectors: npt.NDArray[np.inexact]) -> Floats:
    """κ_i of every eigenvalue; inf where the eigenvectors are linearly dependent."""
    try:
        left = np.linalg.inv(vectors)
    except np.linalg.LinAlgError:
        # Some matrix of the stack is exactly defective: only that one must be given up.
        left = np.full_like(vectors, np.inf)
        for k in range(len(vectors)):
            try:
                left[k] = np.linalg.inv(vectors[k])
            except np.linalg.LinAlgError:
                continue
    norms = np.linalg.norm(vectors, axis=1) * np.linalg.norm(left, axis=2)
    return np.where(np.isfinite(norms), norms, np.inf)


def _disc_bounds(value: Complexes, condition: Floats, error: Floats) -> Floats:
    """Bounds 1 and 2 of the module's docstring, whichever is smaller."""
    size = value.shape[1]
    diagonal = np.arange(size)
    reach = condition * error[:, None]
    distance = np.abs(value[:, :, None] - value[:, None, :])
    free = distance - 2 * reach[:, :, None]
    free[:, diagonal, diagonal] = np.inf
    share = np.where(free > 0, reach[:, None, :] / free, np.inf).sum(axis=2)
    isolated = np.where(share <= 0.5, reach / (1 - np.minimum(share, 0.5)), np.inf)
    disc = size * reach
    linked = distance <= disc[:, :, None] + disc[:, None, :]
    linked[:, diagonal, diagonal] = True
    for _ in range(int(np.ceil(np.log2(size))) if size > 1 else 0):
        linked = np.matmul(linked, linked)
    component = np.where(linked, distance + disc[:, None, :], 0.0).max(axis=2)
    bound = np.minimum(isolated, component)
    return np.where(np.isfinite(bound), bound, np.inf)


def _cluster_bounds(
    matrix: Floats, value: Complexes, error: float, doubtful: npt.NDArray[np.intp]
) -> Floats:
    """Bound 3 for some eigenvalues of one matrix: the smallest cluster that stands by itself."""
    best = np.full(doubtful.size, np.inf)
    size = value.size
    schur, _ = scipy.linalg.schur(matrix, output="complex")
    tried: dict[tuple[int, ...], float] = {}
    known: dict[complex, float] = {}
    for place, i in enumerate(doubtful):
        mirror = known.get(complex(value[i].conjugate()))
        if mirror is not None:  # the matrix is real: conjugate clusters have one bound
            best[place] = mirror
            continue
        order = np.argsort(np.abs(value - value[i]), kind="stable")
        for count in range(2, min(LARGEST_CLUSTER, size) + 1):
            members = tuple(sorted(order[:count]))
            if members not in tried:
                tried[members] = _cluster_bound(schur, value[list(members)], error)
            best[place] = tried[members]
            if np.isfinite(best[place]):
                break
        known[complex(value[i])] = float(best[place])
    return best


def _cluster_bound(schur: Complexes, members: Complexes, error: float) -> float:
    """Bound 3 for one cluster, or inf where its subspace is not known well enough."""
    size, count = len(schur), len(members)
    # The diagonal of the Schur form holds the same eigenvalues in another order.
    left = np.diag(schur).copy()
    select = np.zeros(size, dtype=np.int64)
    for member in members:
        nearest = int(np.argmin(np.where(select == 1, np.inf, np.abs(left - member))))
        select[nearest] = 1
    ordered, *_, info = scipy.linalg.lapack.ztrsen(
        select, schur, np.eye(size, dtype=complex), job="N"
    )
    if info != 0:
        return float("inf")
    block, other = ordered[:count, :count], ordered[count:, count:]
    projector, separation = 1.0, float("inf")
    if count < size:
        coupling, factor, info = scipy.linalg.lapack.ztrsyl(
            block, other, -ordered[:count, count:], isgn=-1
        )
        if info != 0 or factor == 0:
            return float("inf")
        projector = float(np.hypot(1.0, np.linalg.norm(coupling / factor)))
        operator = np.kron(np.eye(size - count), block) - np.kron(other.T, np.eye(count))
        separation = float(np.linalg.svd(operator, compute_uv=False)[-1])
    change = 2 * projector * error
    if not change * 4 * projector <= separation:
        return float("inf")
    spread = block - np.mean(np.diag(block)) * np.eye(count)
    size_2 = float(np.linalg.norm(spread, 2))
    return float((2 * size_2 + change) ** (1 - 1 / count) * change ** (1 / count))
