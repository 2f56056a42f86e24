# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_2.py: change that, not this file.
# Made from sha256 98708d594cde6d4b90e6b9cc39cf7499e1095f00ceadb0734bfdc1a31da282ca
# Operations for each point: slow_flow 17
"""internal_resonance_1_2: omega_2 = 2*omega_1 + sigma, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of u_1, u_2. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 6
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
RELATIONS: tuple[str, ...] = ("omega_2 = 2*omega_1 + sigma",)

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("u_1", "u_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, omega_2 = 2*omega_1 + sigma"),
    "omega_1": ("positive", "rad/s", "natural frequency of the slower oscillator"),
    "mu_1": ("nonnegative", "1/s", "damping of the slower oscillator"),
    "mu_2": ("nonnegative", "1/s", "damping of the faster oscillator"),
    "alpha_1": ("positive", "1/(m s^2)", "coupling in the first equation"),
    "alpha_2": ("positive", "1/(m s^2)", "coupling in the second equation"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u_1": {},
    "u_2": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_u_1, A_u_2, sigma, omega_1, mu_1, mu_2, alpha_1, alpha_2):
    # Intermediates
    x0 = 1j / omega_1
    x1 = A_u_1 * A_u_1
    # Outputs
    out[..., 0] = -A_u_1 * mu_1 - 1 / 2 * A_u_2 * alpha_1 * x0 * np.conj(A_u_1)
    out[..., 1] = A_u_2 * (1j * sigma - mu_2) - 1 / 4 * alpha_2 * x0 * x1


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike,
    mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, omega_2 = 2*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Coupling in the first equation, 1/(m s^2), > 0.
    alpha_2 : array_like
        Coupling in the second equation, 1/(m s^2), > 0.

    Returns
    -------
    complex128
        Shape (..., 2), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2, alpha_1=alpha_1,
        alpha_2=alpha_2,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))
