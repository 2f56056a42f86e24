# Emitted by mmsgen 0.1.0 from derivations/van_der_pol_forced.py: change that, not this file.
# Made from sha256 a5b54584d6afede978d04825516a0698e06f4735489ba15a1173f87445bdc85c
# Operations for each point: slow_flow 134
"""van_der_pol_forced: no resonance, order 2.

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
    "mu": ("positive", "1/s", "strength of the self-excitation, which turns at 1 m"),
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
    x0 = 1 / omega_0
    x1 = np.conj(A_u)
    x2 = Omega + 3 * omega_0
    x3 = 3 * omega_0 - Omega
    x4 = Omega * Omega
    x5 = x4 * x4
    x6 = K * K
    x7 = x5 * x6
    x8 = omega_0 * omega_0
    x9 = 24 * x8
    x10 = 1j * mu
    x11 = mu * x0
    x12 = Omega + omega_0
    x13 = x12 * x12
    x14 = x12 * x13
    x15 = omega_0 - Omega
    x16 = x15 * x15
    x17 = x15 * x16
    x18 = x5 * x5
    x19 = x8 * x8
    x20 = x19 * x19
    x21 = x19 * x8
    x22 = x4 * x5
    x23 = x6 * x6
    x24 = x13 * x13
    x25 = x12 * x24
    x26 = x16 * x16
    x27 = x15 * x26
    x28 = x18 * x4
    x29 = x20 * x8
    x30 = x1 * x1
    x31 = A_u * A_u
    x32 = A_u * x31
    x33 = mu * mu
    # Outputs
    out[..., 0] = (
        A_u * x11 * (1 / 4 * omega_0 * x14 * x17 * (2 * x19 + 2 * x5 - 4 * x4 * x8 - x6) - 1 / 64
        * x10 * (40 * x18 * x8 + 24 * x19 * x4 * x6 + 80 * x21 * x5 + 8 * x22 * x6 + 3 * x23 * x8
        + 8 * x29 - 80 * x19 * x22 - 40 * x20 * x4 - 8 * x21 * x6 - 2 * x23 * x4 - 8 * x28 - x7
        * x9)) / (x25 * x27) + x1 * x11 * x31 * (1 / 4 * x10 * (2 * x18 + 60 * x19 * x5 + 18 * x20
        + 14 * x4 * x6 * x8 - 21 * x19 * x6 - 56 * x21 * x4 - x22 * x9 - x7) - 1 / 2 * omega_0 * x14
        * x17 * x2 * x3) / (x14 * x17 * x2 * x3) - 7 / 16 * 1j * x0 * x30 * x32 * x33
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
    arguments = checked(PARAMETERS, omega_0=omega_0, Omega=Omega, mu=mu, K=K)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
