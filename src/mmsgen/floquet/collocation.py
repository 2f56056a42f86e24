"""Gauss-Legendre collocation of M(θ)q'' + C(θ)q' + K(θ)q = 0, for many steps at once.

The unknowns of a step of length h are the accelerations a_i at the s Gauss nodes; velocities and
displacements follow as v_i = v₀ + h Σ A_ij a_j and q_i = q₀ + h c_i v₀ + h² Σ (A²)_ij a_j. M is
kept as it stands: the equations are collocated, not inverted. This is the s-stage Gauss method
(order 2s, A-stable, symplectic) applied to the first-order form, so undamped systems stay undamped.

Error estimate. The collocation polynomial satisfies the equations up to a defect that vanishes
at the nodes, so its leading part is α_s P_s, with P_s the Legendre polynomial of degree s. The
error at the end of the step is h ∫ G·defect, where G is the adjoint kernel, and because P_s is
orthogonal to all lower degrees only the Legendre coefficient G_s of the kernel counts:
|error| ≈ h |G_s| |α_s| / (2s+1). The kernel is the velocity of the adjoint solution, one
integration smoother than the acceleration, and integration divides a Legendre coefficient by
4s and shifts it by one degree: |G_s| ≲ h|α_{s-1}|/(4s). The coefficients of the stage values give
α_{s-1}, and extrapolated with their own decay α_s. Both factors fall like h^s, hence the order
2s, and both are seen in the computed stage values.

Sources: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, ch. II.7 and
II.14; Hairer & Wanner, *… II*, ch. IV.5 (Gauss methods).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .points import Floats

__all__ = ["GaussTable", "gauss_table", "step_matrices", "truncation"]


@dataclass(frozen=True)
class GaussTable:
    """The s-stage Gauss method on [0, 1].

    Parameters
    ----------
    nodes, weights : numpy.ndarray, shape (s,)
        c_i and b_i.
    matrix : numpy.ndarray, shape (s, s)
        A_ij, the integral of the j-th Lagrange polynomial up to c_i.
    tail : numpy.ndarray, shape (4, s)
        Rows that turn values at the nodes into their Legendre coefficients of degree
        s-4, …, s-1.
    """

    nodes: Floats
    weights: Floats
    matrix: Floats
    tail: Floats

    @property
    def stages(self) -> int:
        """The number of stages s."""
        return self.nodes.size


@lru_cache(maxsize=8)
def gauss_table(stages: int) -> GaussTable:
    """Tabulate the Gauss method with `stages` stages (at least 5, for the error estimate).

    A_ij = Σ_l (2l+1) b_j P_l(c_j) ∫₀^{c_i} P_l with shifted Legendre polynomials, whose integrals
    are differences of neighbours: no matrix is inverted.
    """
    if stages < 5:
        raise ValueError(f"stages must be at least 5, got {stages}")
    x, w = np.polynomial.legendre.leggauss(stages)
    nodes, weights = (1 + x) / 2, w / 2
    legendre = np.polynomial.legendre.legvander(x, stages)  # [node, degree 0..s]
    degree = np.arange(stages)
    projection = ((2 * degree + 1) * legendre[:, :-1]).T * weights  # [degree, node]
    integral = np.empty((stages, stages))
    integral[:, 0] = nodes
    inner = degree[1:]
    integral[:, 1:] = (legendre[:, inner + 1] - legendre[:, inner - 1]) / (2 * (2 * inner + 1))
    return GaussTable(nodes, weights, integral @ projection, projection[-4:])


def step_matrices(coefficients: Floats, step: float, table: GaussTable) -> tuple[Floats, Floats]:
    """Transition matrices of many steps, with the tail of their accelerations.

    Parameters
    ----------
    coefficients : numpy.ndarray, shape (s, cells, n, n, 3)
        M, C and K at the nodes of each step; a cell is one step of one point.
    step : float
        h, the same for all cells, in units of the phase.
    table : GaussTable
        The method.

    Returns
    -------
    transition : numpy.ndarray, shape (cells, 2n, 2n)
        Maps (q, q') at the beginning of the step to its end.
    tail : numpy.ndarray, shape (4, cells, n, 2n)
        Legendre coefficients of degree s-4 … s-1 of the accelerations, for each initial state.

    Raises
    ------
    numpy.linalg.LinAlgError
        If a collocation matrix is exactly singular.
    """
    stages, cells, size = coefficients.shape[:3]
    first, second = step * table.matrix, step**2 * (table.matrix @ table.matrix)
    matrix = np.empty((cells, stages, size, size * stages))
    right = np.empty((cells, stages, size, 2 * size))
    for i in range(stages):
        # Row i of δ_ij M + h A_ij C + h² (A²)_ij K for all cells: one product with a 3 x s table.
        rule = np.stack([np.eye(stages)[i], first[i], second[i]])
        block = coefficients[i].reshape(-1, 3) @ rule
        matrix[:, i] = block.reshape(cells, size, size * stages)
        damping, stiffness = coefficients[i, ..., 1], coefficients[i, ..., 2]
        right[:, i, :, :size] = -stiffness
        right[:, i, :, size:] = -damping - (step * table.nodes[i]) * stiffness
    solution = np.linalg.solve(
        matrix.reshape(cells, stages * size, stages * size),
        right.reshape(cells, stages * size, 2 * size),
    )
    rows = np.concatenate(
        [
            [step * table.weights, step**2 * table.weights * (1 - table.nodes)],
            table.tail,
        ]
    )
    acceleration = solution.reshape(cells * size, stages, 2 * size)
    reduced = np.matmul(rows, acceleration).reshape(cells, size, 6, 2 * size)
    transition = np.empty((cells, 2 * size, 2 * size))
    transition[:, :size] = reduced[:, :, 1]
    transition[:, size:] = reduced[:, :, 0]
    diagonal = np.arange(2 * size)
    transition[:, diagonal, diagonal] += 1.0
    transition[:, diagonal[:size], diagonal[size:]] += step
    return transition, np.moveaxis(reduced[:, :, 2:], 2, 0)


def truncation(tail: Floats, step: float, scale: Floats, stages: int) -> Floats:
    """Estimated truncation error of each step matrix, in the balanced state.

    Parameters
    ----------
    tail : numpy.ndarray, shape (4, cells, n, 2n)
        As `step_matrices` returns it.
    step : float
        h.
    scale : numpy.ndarray, shape (cells, 2n)
        Unit of each component of the state (see `balance`).
    stages : int
        s.

    Returns
    -------
    numpy.ndarray, shape (cells,)
        Bounds the 2-norm of the error if the Legendre coefficients go on falling as they do.
    """
    size = tail.shape[2]
    weighted = tail * (scale[:, None, :] / scale[:, size:, None])
    norms = step * np.sqrt(np.einsum("lcaj,lcaj->lc", weighted, weighted))
    # Pairs of degrees: on a step about which M, C and K are symmetric, every other one vanishes.
    late, early = np.maximum(norms[2], norms[3]), np.maximum(norms[0], norms[1])
    with np.errstate(divide="ignore", invalid="ignore"):
        decay = np.sqrt(np.minimum(1.0, np.where(early > 0, late / early, 1.0)))
    return late**2 * decay / (4 * stages * (2 * stages + 1))
