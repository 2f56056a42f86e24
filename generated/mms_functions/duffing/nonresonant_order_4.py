# Emitted by mmsgen 0.1.0 from derivations/duffing.py: change that, not this file.
# Made from sha256 2b6753938c616a2a53f6c017e52d31734d61e2ee43e8cec194affb15d4a1b381
# Operations for each point: slow_flow 43
"""duffing: no resonance, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of u. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 2
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._runtime import checked, checked_amplitudes, evaluate_array

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "COORDINATES",
    "FRAME",
    "ORDER",
    "PARAMETERS",
    "RELATIONS",
    "VARIABLES",
    "slow_flow",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ()

#: the highest power of ε
ORDER = 4

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "omega_0": ("positive", "rad/s", "frequency of small oscillations"),
    "alpha": ("positive", "1/(m^2 s^2)", "cubic stiffness over the mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_u, omega_0, alpha):
    # Intermediates
    x0 = np.conj(A_u)
    x1 = x0 * x0
    x2 = x1 * x1
    x3 = A_u * A_u
    x4 = x3 * x3
    x5 = A_u * x4
    x6 = alpha * alpha
    x7 = x6 * x6
    x8 = omega_0 * omega_0
    x9 = omega_0 * x8
    x10 = x8 * x8
    x11 = x10 * x9
    x12 = A_u * x3
    x13 = x0 * x1
    x14 = alpha * x6
    x15 = omega_0 * x10
    # Outputs
    out[..., 0] = (
        3 / 2 * 1j * alpha * x0 * x3 / omega_0 + 123 / 128 * 1j * x13 * x14 * x4 / x15
        - 15 / 16 * 1j * x1 * x12 * x6 / x9 - 921 / 1024 * 1j * x2 * x5 * x7 / x11
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, alpha: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha=alpha)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
