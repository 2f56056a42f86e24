# Emitted by mmsgen 0.1.0 from derivations/van_der_pol_forced.py: change that, not this file.
# Made from sha256 1c9978fb82a6cbb7f0041ca3a35e5f0b737abf684aa6e3444517e8ac34527998
# Operations for each point: slow_flow 47
"""van_der_pol_forced: Omega = omega_0 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of u. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 4
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
RELATIONS: tuple[str, ...] = ("Omega = omega_0 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega_0 + sigma"),
    "omega_0": ("positive", "rad/s", "natural frequency"),
    "mu": ("positive", "1/s", "strength of the self-excitation, which turns at 1 m"),
    "K": ("positive", "m/s^2", "amplitude of the force over the mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_u, sigma, omega_0, mu, K):
    # Intermediates
    x0 = 1 / 16 * mu
    x1 = omega_0 * omega_0
    x2 = K / x1
    x3 = np.conj(A_u)
    x4 = -1 / 2 * omega_0
    x5 = 1j * mu
    x6 = 1 / omega_0
    x7 = mu * x6
    x8 = A_u * A_u
    x9 = x3 * x3
    x10 = A_u * x8
    x11 = mu * mu
    # Outputs
    out[..., 0] = (
        1 / 8 * A_u * mu * x2 * x3 + A_u * x7 * (-x4 - 1 / 8 * x5)
        + x2 * (1j * (1 / 8 * sigma - 1 / 4 * omega_0) - x0) + x3 * x7 * x8 * (x4 + 1 / 2 * x5)
        - 1j * A_u * sigma - x0 * x2 * x8 - 7 / 16 * 1j * x10 * x11 * x6 * x9
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, mu: ArrayLike, K: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, mu=mu, K=K)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
