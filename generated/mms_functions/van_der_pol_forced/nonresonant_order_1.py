# Emitted by mmsgen 0.1.0 from derivations/van_der_pol_forced.py: change that, not this file.
# Made from sha256 ae937305e924ffa7228c1973619a105d1bf4c5b1245fe191d189ff62b740e543
# Operations for each point: slow_flow 29
"""van_der_pol_forced: no resonance, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of u. Results are written at ε = 1.

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
ORDER = 1

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
    x0 = A_u * A_u
    x1 = Omega + omega_0
    x2 = x1 * x1
    x3 = omega_0 - Omega
    x4 = x3 * x3
    x5 = K * K
    x6 = Omega * Omega
    x7 = x6 * x6
    x8 = omega_0 * omega_0
    x9 = x8 * x8
    # Outputs
    out[..., 0] = (
        1 / 4 * A_u * mu * (2 * x7 + 2 * x9 - x5 - 4 * x6 * x8) / (x2 * x4)
        - 1 / 2 * mu * x0 * np.conj(A_u)
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
