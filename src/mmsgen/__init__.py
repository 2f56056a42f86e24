"""From a Lagrangian to certified stability boundaries by the method of multiple scales.

    model -> equations of motion -> scaled system -> expansion -> slow flow -> boundary -> code

Each stage is a record with a method that makes the next one; `floquet` is the independent
reference. The reference, emitted code and certificates are loaded when they are first asked for.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

from ._version import __version__
from .equations import EquationsOfMotion
from .equilibrium import Equilibrium
from .errors import (
    CertificateError,
    ConventionError,
    EmissionError,
    EquilibriumError,
    ExpansionError,
    FloquetError,
    MmsgenError,
    ModelError,
    OrbitError,
    ResonanceError,
    ScalingError,
)
from .expansion import Expansion
from .fourier import FourierSeries, fourier_series
from .model import Model
from .parameters import Parameter
from .resonance import Resonance
from .scaling import ScaledSystem
from .slowflow import SlowFlow
from .symbols import epsilon
from .tables import ResonanceTable

if TYPE_CHECKING:
    from . import conventions, floquet, orbits
    from .certificate import Certificate
    from .certify import certify
    from .codegen import generate
    from .emission import Emission, publish
    from .exact_response import orbit_near, orbits_along
    from .steady import Steady
    from .time_integration import time_integration

__all__ = [
    "Certificate",
    "CertificateError",
    "ConventionError",
    "Emission",
    "EmissionError",
    "EquationsOfMotion",
    "Equilibrium",
    "EquilibriumError",
    "Expansion",
    "ExpansionError",
    "FloquetError",
    "FourierSeries",
    "MmsgenError",
    "Model",
    "ModelError",
    "OrbitError",
    "Parameter",
    "Resonance",
    "ResonanceError",
    "ResonanceTable",
    "ScaledSystem",
    "ScalingError",
    "SlowFlow",
    "Steady",
    "__version__",
    "certify",
    "conventions",
    "epsilon",
    "floquet",
    "fourier_series",
    "generate",
    "orbit_near",
    "orbits",
    "orbits_along",
    "publish",
    "time_integration",
]

_LATER = {
    "Certificate": "certificate",
    "Emission": "emission",
    "Steady": "steady",
    "certify": "certify",
    "generate": "codegen",
    "orbit_near": "exact_response",
    "orbits_along": "exact_response",
    "publish": "emission",
    "time_integration": "time_integration",
}
"""Name → the module that holds it."""


def __getattr__(name: str) -> Any:
    """Load what is needed only now."""
    if name in ("conventions", "floquet", "orbits"):
        return import_module(f".{name}", __name__)
    if name not in _LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f".{_LATER[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


class _Package(ModuleType):
    """Python binds a loaded module to its name in the package: here these are functions."""

    def __setattr__(self, name: str, value: Any) -> None:
        if name in ("certify", "time_integration") and isinstance(value, ModuleType):
            value = getattr(value, name)
        super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package
