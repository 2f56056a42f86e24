"""Whether the emitted functions of a nonlinear slow flow say the same at a steady motion.

The equilibrium of the emitted right-hand side, its stability and its bifurcations are compared with
exact orbits as ε → 0. That the other functions belong to that right-hand side is checked here, at
numbers.
"""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np

from .consistency import arguments_of
from .errors import CertificateError
from .runtime._flow import jacobian, spectrum
from .steady import SteadyState
from .steady_bifurcations import SlowBifurcation

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["demand_bifurcation", "demand_steady_agreement"]

ROUNDING = 1e-10
"""Rounding of a few hundred operations and of an equilibrium that Newton's method found, relative:
a thousand times less than digits compared."""

ROOT = 1e-5
"""How far rounding moves an eigenvalue that is nearly double, or a bifurcation's amplitude."""

AROUND = np.linspace(-0.05, 0.06, 9)
"""Values of the detuning beside a bifurcation, over the size of the slow flow."""


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


def demand_bifurcation(case: Expansion, module: Any, slow: SlowBifurcation, sigma: str) -> None:
    """Raise if `frequency_response` does not find a bifurcation where there is one.

    Parameters
    ----------
    case : Expansion
    module : module
        The emitted functions.
    slow : SlowBifurcation
    sigma : str
        The detuning in which it is one.

    Raises
    ------
    CertificateError
        If there is none.
    """
    if not hasattr(module, "frequency_response"):
        return
    level, unit = slow.values[sigma], slow.unit
    around = {**slow.values, sigma: level + unit * AROUND}
    known = arguments_of(module.frequency_response, around)
    found = module.frequency_response(**known, over=sigma)
    largest = max((float(b.modulus.max()) for b in found.branches), default=0.0)
    size = float(np.abs(slow.amplitudes).max()) or largest
    for point in found.bifurcations:
        near = np.abs(np.abs(point.amplitudes) - np.abs(slow.amplitudes)).max() <= ROOT * size
        close = abs(point.parameter - level) <= 1e2 * ROUNDING * unit
        if point.kind == slow.kind and near and close:
            return
    raise CertificateError(f"frequency_response finds no {slow.kind} at {sigma} = {level:.9g}")
