"""Whether the emitted functions of a nonlinear slow flow say the same at a steady motion.

The equilibrium of the emitted right-hand side, its stability and its saddle-nodes are compared with
exact orbits as ε → 0. That the other functions belong to that right-hand side is checked here, at
numbers.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from .consistency import arguments_of
from .errors import CertificateError
from .runtime._flow import jacobian, spectrum
from .steady import SteadyState

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["demand_saddle_node", "demand_steady_agreement"]

ROUNDING = 1e-10
"""Rounding of a few hundred operations and of an equilibrium that Newton's method found, relative:
a thousand times less than digits compared."""

ROOT = 1e-5
"""How far rounding moves an eigenvalue that is nearly double, or a saddle-node's amplitude."""

POINTS = 41
"""Of the detuning, on both sides of a saddle-node."""


def demand_steady_agreement(case: Expansion, module: Any, state: SteadyState) -> None:
    """Raise if an emitted function contradicts the slow flow at an equilibrium.

    Parameters
    ----------
    case : Expansion
    module : module
        The emitted functions; those that it does not have are not asked for.
    state : SteadyState

    Raises
    ------
    CertificateError
        Naming the function.
    """
    table, b, values = case.slow_flow.table, state.amplitudes, state.values
    numbers, drift = table.numbers(values), np.asarray(state.drift)

    def at(name: str, *leading: Any, **options: Any) -> Any:
        function = getattr(module, name)
        known = arguments_of(function, {"order": None, "gradient": False, **values})
        return function(*leading, **{**known, **options})

    wanted = jacobian(table.flow, numbers, b, drift)
    size = float(np.linalg.norm(wanted))
    if hasattr(module, "jacobian"):
        if not np.abs(at("jacobian", b) - wanted).max() <= ROUNDING * size:
            raise CertificateError("jacobian is not the derivative of slow_flow")
    if hasattr(module, "stability"):
        own, known = at("stability", b), spectrum(table.flow, numbers, b, drift)
        own, known = (np.sort_complex(x[np.isfinite(x)]) for x in (own, known))
        if own.shape != known.shape or not np.abs(own - known).max(initial=0.0) <= ROOT * size:
            raise CertificateError("stability is not what follows from the jacobian")
    if hasattr(module, "equilibria"):
        _demand_listed(at("equilibria"), state)
    if hasattr(module, "response"):
        _demand_response(case, at, state)


def _demand_listed(found: Any, state: SteadyState) -> None:
    """Raise if an equilibrium is missing in those that are listed."""
    scale = float(np.abs(state.amplitudes).max()) or 1.0
    gap = np.abs(np.abs(found.amplitudes) - np.abs(state.amplitudes)).max(axis=-1)
    if not np.any(gap <= ROOT * scale):
        raise CertificateError(
            f"equilibria does not list the one with the amplitudes {list(state.amplitudes)}"
        )


def _demand_response(case: Expansion, at: Any, state: SteadyState) -> None:
    """Raise if the uniform approximation is not the sum of the expansion's harmonics."""
    n = len(state.amplitudes)
    times = np.linspace(0.0, 20 / float(np.abs(state.rates).max()), 7)
    turned = state.amplitudes * np.exp(1j * np.multiply.outer(times, state.turning))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        own = at("response", times, turned, order=case.order - 1)
    wanted = state.motion(times)[:n].T
    scale = float(np.abs(wanted).max()) or 1.0
    if not np.abs(own - wanted).max() <= ROUNDING * scale:
        raise CertificateError("response is not the sum of the harmonics of the expansion")


def demand_saddle_node(
    case: Expansion, module: Any, values: Mapping[str, float], amplitudes: Any
) -> None:
    """Raise if `frequency_response` does not find a saddle-node where there is one.

    Parameters
    ----------
    case : Expansion
    module : module
        The emitted functions.
    values : mapping
        Those of the slow flow at the saddle-node.
    amplitudes : numpy.ndarray of complex, shape (n,)
        Its amplitudes.

    Raises
    ------
    CertificateError
        If there is none.
    """
    if not hasattr(module, "frequency_response"):
        return
    sigma = str(case.relations[0].detuning.name)
    level, unit = values[sigma], abs(values[sigma])
    around = level + unit * np.linspace(-0.5, 0.5 + 1 / POINTS, POINTS)
    known = {**values, "over": sigma, sigma: around}
    found = module.frequency_response(**arguments_of(module.frequency_response, known))
    size = float(np.abs(amplitudes).max())
    for point in found.bifurcations:
        near = np.abs(np.abs(point.amplitudes) - np.abs(amplitudes)).max() <= ROOT * size
        close = abs(point.parameter - level) <= 1e2 * ROUNDING * unit
        if point.kind == "saddle-node" and near and close:
            return
    raise CertificateError(f"frequency_response finds no saddle-node at {sigma} = {level:.9g}")
