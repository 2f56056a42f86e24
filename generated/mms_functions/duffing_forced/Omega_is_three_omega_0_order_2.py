# Emitted by mmsgen 0.1.0 from derivations/duffing_forced.py: change that, not this file.
# Made from sha256 817f426ccbd869e2f73e977ef2d0b0fdaad9b6560829d130248f4291789e238e
# Operations for each point: slow_flow 89
"""duffing_forced: Omega = 3*omega_0 + sigma, order 2.

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
RELATIONS: tuple[str, ...] = ("Omega = 3*omega_0 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = 3*omega_0 + sigma"),
    "omega_0": ("positive", "rad/s", "frequency of small oscillations"),
    "alpha": ("positive", "1/(m^2 s^2)", "cubic stiffness over the mass"),
    "mu": ("positive", "1/s", "half the damping over the mass"),
    "K": ("positive", "m/s^2", "amplitude of the force over the mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {"sigma": 1 / 3},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_u, sigma, omega_0, alpha, mu, K):
    # Intermediates
    x0 = 1j * A_u
    x1 = alpha * alpha
    x2 = 1j * x1
    x3 = omega_0 * omega_0
    x4 = x3 * x3
    x5 = omega_0 * x4
    x6 = 3 / 32 * K / x5
    x7 = np.conj(A_u)
    x8 = mu * x5
    x9 = K * K
    x10 = alpha * x9
    x11 = x7 * x7
    x12 = x3 * x4
    x13 = omega_0 * x3
    x14 = x4 * x4
    x15 = x13 * x14
    x16 = x9 * x9
    x17 = mu * mu
    x18 = x14 * x3
    x19 = A_u * A_u
    x20 = x19 * x19
    x21 = x11 * x7
    x22 = A_u * x19
    x23 = x13 * x4
    x24 = omega_0 * x14
    # Outputs
    out[..., 0] = (
        A_u * (1j * (3 / 256 * alpha * x12 * x9 - 9 / 512 * sigma * x10 * x5
        - 63 / 2097152 * x1 * x16 - 1 / 2 * x17 * x18) - mu * x15) / x15 + K * alpha * x11 * (3
        / 128 * x8 + 1j * (15 / 128 * sigma * x5 - 27 / 32768 * x10 - 3 / 32 * x12)) / x24
        + alpha * x19 * x7 * (3 / 2 * x8 + 1j * (21 / 2048 * x10 + 3 / 2 * x12)) / x23
        - sigma * x0 / 3 - x0 * x1 * x21 * x6 - 15 / 16 * x11 * x2 * x22 / x13 - x2 * x20 * x6
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha: ArrayLike,
    mu: ArrayLike, K: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = 3*omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha=alpha, mu=mu, K=K)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
