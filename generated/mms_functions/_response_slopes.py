"""How a response moves with the parameters: its branches, and where its bifurcations lie.

A saddle-node lies where the equations F(B, p) = 0 have a singular Jacobian; with w its left null
vector, wᵀF is stationary along the curve, so that wᵀ(∂F/∂p dp + ∂F/∂λ dλ) = 0 for the parameter λ
that varies. At the other bifurcations an eigenvalue, or its real part, vanishes on the branch that
goes through, and λ follows from the derivatives of that. Source: Govaerts (2000), *Numerical
Methods for Bifurcations of Dynamical Equilibria*, chapters 3 and 4.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._dual import array_slopes
from ._flow import Flow
from ._records import Bifurcation, Branch, Response
from ._slopes import (
    Slopes,
    bordered,
    carried,
    directions,
    forces,
    in_parts,
    jacobian_slopes,
    slopes_of,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["ResponseSlopes", "response_slopes"]

Kernel = Callable[..., Any]


class ResponseSlopes(NamedTuple):
    """How a response moves with one parameter.

    Attributes
    ----------
    branches : tuple of Slopes
        Of the points of each branch, shapes (m, n), (m, g) and (m,): with the parameter that varies
        held fixed.
    bifurcations : numpy.ndarray
        Of the value of the parameter that varies at each bifurcation; NaN for that one itself.
    """

    branches: tuple[Slopes, ...]
    bifurcations: NDArray[np.float64]


def response_slopes(
    flow: Flow,
    kernel: Kernel,
    fixed: Sequence[NDArray[np.float64]],
    names: Sequence[str],
    place: int,
    response: Response,
) -> dict[str, ResponseSlopes]:
    """Derivatives of a response by every parameter.

    Parameters
    ----------
    flow : Flow
    kernel : callable
        Fills the coefficients of its terms.
    fixed : sequence of numpy.ndarray
        What it takes, one number each but for the one that varies.
    names : sequence of str
    place : int
        Of the one that varies.
    response : Response

    Returns
    -------
    dict
        Name → `ResponseSlopes`.
    """

    def arguments(values: Any) -> list[Any]:
        own = np.asarray(values, dtype=np.float64)
        return [own if k == place else a for k, a in enumerate(fixed)]

    def along(branch: Branch) -> dict[str, Slopes]:
        b, drift = branch.amplitudes[:, None], branch.drift[:, None]
        found = slopes_of(flow, kernel, arguments(branch.parameter), names, b, drift)
        return {
            name: Slopes(own.amplitudes[:, 0], own.drift[:, 0], own.growth[:, 0])
            for name, own in found.items()
        }

    branches = [along(branch) for branch in response.branches]
    points = response.bifurcations
    moved = np.zeros((len(names), 0))
    if points:
        values, slopes = array_slopes(
            kernel, arguments([p.parameter for p in points]), len(flow.terms)
        )
        each = zip(points, values, np.moveaxis(slopes, 1, 0), strict=True)
        moved = np.stack([_moved(flow, c, dc, point, place) for point, c, dc in each], axis=-1)
        moved[place] = np.nan
    return {
        name: ResponseSlopes(tuple(branch[name] for branch in branches), moved[k])
        for k, name in enumerate(names)
    }


def _moved(
    flow: Flow, c: NDArray[Any], dc: NDArray[Any], point: Bifurcation, place: int
) -> NDArray[np.float64]:
    """Derivatives of the value at which one bifurcation lies, by all parameters."""
    n, kind, b, drift = flow.n, point.kind, point.amplitudes, point.drift
    matrix, force = bordered(flow, c, b, drift), forces(flow, dc, b)
    u, s, vt = np.linalg.svd(matrix)
    if kind == "saddle-node":
        rate = force @ u[:, -1]
        return -rate / rate[place]
    # On the branch that goes through nothing moves along the null vector, by symmetry.
    kept = slice(None) if kind == "Hopf" else slice(0, -1)
    inverse = (vt[kept].T / s[kept]) @ u[:, kept].T
    speed, turn = in_parts(flow, -force @ inverse.T)
    change = np.zeros((len(force), *matrix.shape))
    change[:, : 2 * n, : 2 * n] = jacobian_slopes(flow, dc, b, turn) + carried(flow, c, b, speed)
    if kind != "Hopf":
        if flow.symmetries:
            change[:, : 2 * n, 2 * n :] = directions(flow, speed)
        rate = u[:, -1] @ change @ vt[-1]
        return -rate / rate[place]
    values, right = np.linalg.eig(matrix[: 2 * n, : 2 * n])
    k = int(np.argmin(np.abs(values - 1j * point.frequency)))
    left = np.linalg.inv(right)[k]
    rate = (left @ change[:, : 2 * n, : 2 * n] @ right[:, k]).real
    return -rate / rate[place]
