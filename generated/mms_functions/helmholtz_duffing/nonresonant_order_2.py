# Emitted by mmsgen 0.1.0 from derivations/helmholtz_duffing.py: change that, not this file.
# Made from sha256 b44980ed3e5d3d91321139e7f9102c290d808d7d9787a8c92a9cce0c3ceb899f
# Operations for each point: slow_flow 14
"""helmholtz_duffing: no resonance, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of u. Results are written at ε = 1.

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
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "omega_0": ("positive", "rad/s", "frequency of small oscillations"),
    "alpha_2": ("real", "1/(m s^2)", "quadratic stiffness over the mass"),
    "alpha_3": ("real", "1/(m^2 s^2)", "cubic stiffness over the mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_u, omega_0, alpha_2, alpha_3):
    # Intermediates
    x0 = A_u * A_u
    x1 = omega_0 * omega_0
    x2 = omega_0 * x1
    x3 = alpha_2 * alpha_2
    # Outputs
    out[..., 0] = 1j * x0 * (3 / 2 * alpha_3 * x1 - 5 * x3 / 3) * np.conj(A_u) / x2


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), real.
    alpha_3 : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha_2=alpha_2, alpha_3=alpha_3)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
