"""The errors that mmsgen raises, all of them in the user's language.

Every message says what is wrong, in which equation or symbol, and what to do about it.
"""

from __future__ import annotations

__all__ = [
    "CertificateError",
    "ConventionError",
    "EmissionError",
    "EquilibriumError",
    "ExpansionError",
    "FloquetError",
    "MmsgenError",
    "ModelError",
    "OrbitError",
    "ResonanceError",
    "ScalingError",
    "UnresolvedError",
]


class MmsgenError(ValueError):
    """Base class: the input cannot be carried further as it stands."""


class ModelError(MmsgenError):
    """The Lagrangian, the equations, the coordinates or the parameters are inconsistent."""


class EquilibriumError(ModelError):
    """A point is no equilibrium, there is none, or it cannot be decided exactly."""


class ScalingError(MmsgenError):
    """The orders in ε leave no oscillating, uncoupled leading-order system, or no expansion."""


class ResonanceError(MmsgenError):
    """A resonance relation is unknown to the system, contradictory, or leaves no detuning."""


class ExpansionError(MmsgenError):
    """The expansion cannot be carried out as asked."""


class EmissionError(MmsgenError):
    """Code cannot be generated from what was passed."""


class FloquetError(MmsgenError):
    """The exact equations are not periodic, or a numeric value is missing or unusable."""


class OrbitError(MmsgenError):
    """No periodic orbit is found from what was passed, or it cannot be followed."""


class CertificateError(MmsgenError):
    """A result does not have the accuracy that its order claims."""


class UnresolvedError(CertificateError):
    """Too few errors are above what a reference resolves, so that no exponent can be fitted."""


class ConventionError(MmsgenError):
    """A result cannot be written in another convention as asked."""
