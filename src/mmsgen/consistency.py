"""Whether the emitted functions of one case say the same: those that are not fitted themselves.

Only the slow-flow matrix and the edges are compared with Floquet theory as ε → 0. That the growth
rate, the characteristic polynomial, the right-hand side and the critical speeds belong to that
matrix and those edges is checked here, at numbers.
"""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import CertificateError

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["arguments_of", "demand_agreement", "demand_speed_on_edge"]

ROUNDING = 1e-12
"""Rounding of a few hundred operations, relative: a thousand times less than digits compared."""

DOUBLE_ROOT = 1e-6
"""The root of it: how far rounding moves an eigenvalue that is nearly double, relative."""


def arguments_of(function: Any, values: Mapping[str, Any]) -> dict[str, Any]:
    """The values of the parameters that an emitted function takes.

    Raises
    ------
    CertificateError
        If one is missing.
    """
    kinds = inspect.signature(function).parameters.values()
    wanted = (p for p in kinds if p.kind is p.KEYWORD_ONLY and p.default is p.empty)
    names = [p.name for p in wanted]
    missing = [n for n in names if n not in values]
    if missing:
        raise CertificateError(f"no value is given for {', '.join(missing)}")
    return {n: values[n] for n in names}


def demand_agreement(case: Expansion, module: Any, values: Mapping[str, float]) -> None:
    """Raise if a function of a linear slow flow contradicts its matrix.

    Parameters
    ----------
    case : Expansion
    module : module
        The emitted functions.
    values : mapping
        Name → number, for all of them.

    Raises
    ------
    CertificateError
        Naming the function.
    """

    def at(function: Any, *leading: Any) -> Any:
        return np.asarray(function(*leading, **arguments_of(function, values)))

    matrix = at(module.slow_flow_matrix)
    n, size = len(matrix), float(np.linalg.norm(matrix))
    eigenvalues = np.linalg.eigvals(matrix)
    gap = abs(float(at(module.growth_rate)) - eigenvalues.real.max(initial=-np.inf))
    if not gap <= DOUBLE_ROOT * size:
        raise CertificateError(f"growth_rate is off the eigenvalues of slow_flow_matrix by {gap:g}")
    # A coefficient of Γ^{n−k} is a sum of products of k eigenvalues.
    weights = np.array([size**k for k in range(n + 1)])
    difference = np.abs(at(module.characteristic_coefficients) - np.poly(eigenvalues))
    if not np.all(difference <= 2**n * ROUNDING * weights):
        raise CertificateError("characteristic_coefficients are not those of slow_flow_matrix")
    amplitudes = np.array([1 + j + 1j / (2 + j) for j in range(len(case.coordinates))])
    nodes = [node for block in case.slow_flow.linear.blocks for node in block.nodes]
    state = np.array([amplitudes[j].conj() if b else amplitudes[j] for j, b in nodes])
    flow = at(module.slow_flow, amplitudes)
    wanted = np.array([flow[j].conj() if b else flow[j] for j, b in nodes])
    if not np.all(np.abs(matrix @ state - wanted) <= ROUNDING * size * np.linalg.norm(state)):
        raise CertificateError("slow_flow is not slow_flow_matrix times the amplitudes")


def demand_speed_on_edge(
    case: Expansion, module: Any, values: Mapping[str, float], pivot: str, speeds: tuple[float, ...]
) -> None:
    """Raise if a critical speed does not lie on the edge that `boundaries` gives at that speed.

    Parameters
    ----------
    case : Expansion
    module : module
        The emitted functions.
    values : mapping
        Name → number, without the frequency that is varied and without what depends on it.
    pivot : str
        The frequency that is varied.
    speeds : tuple of float
        Its critical values, lower one first.

    Raises
    ------
    CertificateError
        Naming the speed.
    """
    relation = case.relations[0]
    for k, speed in enumerate(speeds):
        table = case.slow_flow._with_detunings({**values, pivot: speed})
        edge = float(module.boundaries(**arguments_of(module.boundaries, table))[k])
        sigma = float(table[str(relation.detuning.name)])
        if not abs(sigma - edge) <= 1e3 * ROUNDING * abs(speed):
            raise CertificateError(
                f"critical_speeds gives {pivot} = {speed:.9g}, where the detuning is {sigma:.9g} "
                f"and the edge of boundaries {edge:.9g}"
            )
