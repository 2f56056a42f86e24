"""Gauss-Legendre collocation of M(θ)q'' + C(θ)q' + K(θ)q = 0, for many steps at once.

The unknowns of a step of length h are the accelerations a_i at the s Gauss nodes; velocities and
displacements follow as v_i = v₀ + h Σ A_ij a_j and q_i = q₀ + h c_i v₀ + h² Σ (A²)_ij a_j. M is
kept as it stands: the equations are collocated, not inverted. This is the s-stage Gauss method
(order 2s, A-stable, symplectic) applied to the first-order form, so undamped systems stay undamped.

Error estimate. The collocation polynomial satisfies the equations at the nodes only. What the
accelerations do beyond degree s-1 reappears as a defect, and the error at the end of the step is
h ∫ G·defect, with G the adjoint kernel, the velocity of the adjoint solution. A coefficient f_{s+j}
of the accelerations' Legendre series meets, through the nodes at which it is sampled, the
coefficient G_{s-j} of the kernel, and no lower one:

    |error| ≲ h Σ_j |f_{s+j}| |G_{s-j}| / (2(s-j)+1),  j = 0 … s.

The kernel is one integration smoother than the accelerations, and integration takes a coefficient
of degree k to its neighbours, divided by 2(2k+1); so the computed coefficients give G_k. They end
at degree s-1: f_{s+j} is what the last two become if they go on falling, per degree, as slowly as
on the slowest of all even distances back from the end. For entire coefficients the first terms of
the sum rule, for poles near the real axis, as where M(t) is nearly singular, all of them alike.
Both factors fall like h^s, hence the order 2s, and both are seen in the computed stage values.

Sources: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, ch. II.7 and
II.14; Hairer & Wanner, *… II*, ch. IV.5 (Gauss methods).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .points import Floats

__all__ = ["GaussTable", "gauss_table", "stage_norms", "step_matrices", "truncation"]

SAFETY = 2.0
"""Factor on the estimate of truncation. With it, thousands of random systems with nearly singular
M(t) stay below the estimate."""


@dataclass(frozen=True)
class GaussTable:
    """The s-stage Gauss method on [0, 1].

    Parameters
    ----------
    nodes, weights : numpy.ndarray, shape (s,)
        c_i and b_i.
    matrix : numpy.ndarray, shape (s, s)
        A_ij, the integral of the j-th Lagrange polynomial up to c_i.
    legendre : numpy.ndarray, shape (s, s)
        Rows that turn values at the nodes into their Legendre coefficients of degree 0, …, s-1.
    """

    nodes: Floats
    weights: Floats
    matrix: Floats
    legendre: Floats

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
    return GaussTable(nodes, weights, integral @ projection, projection)


def step_matrices(coefficients: Floats, step: float, table: GaussTable) -> tuple[Floats, Floats]:
    """Transition matrices of many steps, with the Legendre series of their accelerations.

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
    series : numpy.ndarray, shape (s, cells, n, 2n)
        Legendre coefficients of degree 0 … s-1 of the accelerations, for each initial state.

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
            table.legendre,
        ]
    )
    acceleration = solution.reshape(cells * size, stages, 2 * size)
    reduced = np.matmul(rows, acceleration).reshape(cells, size, stages + 2, 2 * size)
    transition = np.empty((cells, 2 * size, 2 * size))
    transition[:, :size] = reduced[:, :, 1]
    transition[:, size:] = reduced[:, :, 0]
    diagonal = np.arange(2 * size)
    transition[:, diagonal, diagonal] += 1.0
    transition[:, diagonal[:size], diagonal[size:]] += step
    return transition, np.moveaxis(reduced[:, :, 2:], 2, 0)


def stage_norms(series: Floats, step: float, scale: Floats) -> Floats:
    """Norms of the Legendre coefficients: changes of velocity in units of the balanced state.

    Parameters
    ----------
    series : numpy.ndarray, shape (s, cells, n, 2n)
        As `step_matrices` returns it.
    step : float
        h.
    scale : numpy.ndarray, shape (cells, 2n)
        Unit of each component of the state (see `balance`).

    Returns
    -------
    numpy.ndarray, shape (s, cells)
    """
    size = series.shape[2]
    weighted = series * (scale[:, None, :] / scale[:, size:, None])
    return np.asarray(step * np.sqrt(np.einsum("lcaj,lcaj->lc", weighted, weighted)))


def truncation(norms: Floats) -> Floats:
    """Estimated truncation error of each step matrix, in the balanced state.

    Parameters
    ----------
    norms : numpy.ndarray, shape (s, cells)
        As `stage_norms` returns them.

    Returns
    -------
    numpy.ndarray, shape (cells,)
        Bounds the 2-norm of the error if the coefficients go on falling as they do.
    """
    stages = len(norms)
    # Pairs of degrees: on a step about which M, C and K are symmetric, every other one vanishes.
    pairs = np.maximum(norms[1:], norms[:-1])
    decay = np.zeros_like(pairs[-1])
    with np.errstate(divide="ignore", invalid="ignore"):
        # What the nodes cannot tell from them falsifies the last coefficients, and may cancel them.
        late = np.fmax(pairs[-1], pairs[-3] * np.minimum(1.0, pairs[-3] / pairs[-5]))
        for gap in {*range(2, stages - 1, 2), stages - 2}:
            fall = np.where(pairs[-1 - gap] > 0, late / pairs[-1 - gap], 1.0)
            decay = np.maximum(decay, fall ** (1 / gap))
    decay = np.minimum(decay, 1.0)
    integrated = norms / (2 * (2 * np.arange(stages) + 1))[:, None]
    kernel = np.concatenate([np.ones_like(decay)[None], integrated])
    kernel[:-2] += integrated[1:]
    # Horner's scheme in the decay for Σ_j decay^j |G_{s-j}| / (2(s-j)+1).
    total = np.zeros_like(decay)
    for degree, part in enumerate(kernel):
        total = total * decay + part / (2 * degree + 1)
    return np.asarray(SAFETY * late * decay * total)
