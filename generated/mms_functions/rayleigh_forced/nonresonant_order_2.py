# Emitted by mmsgen 0.1.0 from derivations/rayleigh_forced.py: change that, not this file.
# Made from sha256 51adc36d90e6475e4f8f94cd4088806175b3dc252e6183df91db000245acae23
# Operations for each point: slow_flow 121
"""rayleigh_forced: no resonance, order 2.

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
RELATIONS: tuple[str, ...] = ()

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "omega_0": ("positive", "rad/s", "natural frequency"),
    "Omega": ("positive", "rad/s", "frequency of the force"),
    "mu": ("positive", "1/s", "strength of the self-excitation, which turns at 1 m/s"),
    "K": ("positive", "m/s^2", "amplitude of the force over the mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_u, omega_0, Omega, mu, K):
    # Intermediates
    x0 = np.conj(A_u)
    x1 = Omega + 3 * omega_0
    x2 = 3 * omega_0 - Omega
    x3 = Omega * Omega
    x4 = K * K
    x5 = x3 * x4
    x6 = 1j * mu
    x7 = omega_0 * omega_0
    x8 = Omega + omega_0
    x9 = x8 * x8
    x10 = x8 * x9
    x11 = omega_0 - Omega
    x12 = x11 * x11
    x13 = x11 * x12
    x14 = x3 * x3
    x15 = x7 * x7
    x16 = x14 * x14
    x17 = x4 * x4
    x18 = x14 * x3
    x19 = x15 * x7
    x20 = x0 * x0
    x21 = A_u * A_u
    x22 = A_u * x21
    x23 = mu * mu
    x24 = omega_0 * x7
    x25 = x9 * x9
    x26 = x25 * x8
    x27 = x12 * x12
    x28 = x11 * x27
    x29 = x16 * x3
    x30 = x15 * x15
    x31 = x30 * x7
    # Outputs
    out[..., 0] = (
        A_u * mu * (1 / 4 * omega_0 * x10 * x13 * (2 * x14 + 2 * x15 - 4 * x3 * x7 - x5) - 1 / 64
        * x6 * (24 * x14 * x15 * x4 + 3 * x14 * x17 * x7 + 80 * x14 * x19 + 8 * x16 * x4 + 40 * x16
        * x7 + 8 * x31 - 80 * x15 * x18 - 2 * x17 * x18 - 24 * x18 * x4 * x7 - 8 * x19 * x5 - 8
        * x29 - 40 * x3 * x30)) / (omega_0 * x26 * x28) + mu * x0 * x21 * x7 * (-omega_0 * x5 * x6
        * (3 * x7 - x3) - 1 / 2 * x1 * x10 * x13 * x2) / (x1 * x10 * x13 * x2)
        + 1 / 16 * 1j * x20 * x22 * x23 * x24
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, Omega: ArrayLike, mu: ArrayLike, K: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the force, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, Omega=Omega, mu=mu, K=K)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
