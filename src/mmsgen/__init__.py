"""From a Lagrangian to certified stability boundaries by the method of multiple scales.

    model -> equations of motion -> scaled system -> expansion -> slow flow -> boundary -> code

Each stage is a record with a method that makes the next one; `floquet` is the independent
reference.
"""

from __future__ import annotations

from . import floquet
from ._version import __version__
from .certificate import Certificate
from .certify import certify
from .codegen import generate
from .emission import Emission, publish
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
    ResonanceError,
    ScalingError,
)
from .expansion import Expansion
from .model import Model
from .parameters import Parameter
from .resonance import Resonance
from .scaling import ScaledSystem
from .slowflow import SlowFlow
from .symbols import epsilon
from .tables import ResonanceTable

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
    "MmsgenError",
    "Model",
    "ModelError",
    "Parameter",
    "Resonance",
    "ResonanceError",
    "ResonanceTable",
    "ScaledSystem",
    "ScalingError",
    "SlowFlow",
    "__version__",
    "certify",
    "epsilon",
    "floquet",
    "generate",
    "publish",
]
