# Emitted by mmsgen 0.1.0 from derivations/duffing_forced.py: change that, not this file.
# Made from sha256 f9fb28d9f5a5906a9e392bb2fefa51ad1397c1f0ab2c412bcac6e5a56aaa2fc7
# Operations for each point: slow_flow 89
"""duffing_forced: 3*Omega = omega_0 + sigma, order 2.

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
RELATIONS: tuple[str, ...] = ("3*Omega = omega_0 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, 3*Omega = omega_0 + sigma"),
    "omega_0": ("positive", "rad/s", "frequency of small oscillations"),
    "alpha": ("positive", "1/(m^2 s^2)", "cubic stiffness over the mass"),
    "mu": ("positive", "1/s", "half the damping over the mass"),
    "K": ("positive", "m/s^2", "amplitude of the force over the mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_u, sigma, omega_0, alpha, mu, K):
    # Intermediates
    x0 = 1j * A_u
    x1 = alpha * alpha
    x2 = 1j * x1
    x3 = K * K
    x4 = K * x3
    x5 = omega_0 * omega_0
    x6 = x5 * x5
    x7 = x6 * x6
    x8 = omega_0 * x7
    x9 = x4 / x8
    x10 = np.conj(A_u)
    x11 = omega_0 * x6
    x12 = mu * x11
    x13 = alpha * x3
    x14 = A_u * A_u
    x15 = x5 * x6
    x16 = omega_0 * x5
    x17 = x16 * x7
    x18 = x3 * x3
    x19 = mu * mu
    x20 = x5 * x7
    x21 = x11 * x7
    x22 = x10 * x10
    x23 = A_u * x14
    x24 = x16 * x6
    # Outputs
    out[..., 0] = (
        A_u * (1j * (243 / 512 * alpha * sigma * x11 * x3 + 243 / 256 * alpha * x15 * x3
        - 5727753 / 2097152 * x1 * x18 - 1 / 2 * x19 * x20) - mu * x17) / x17
        + alpha * x10 * x14 * (3 / 2 * x12 + 1j * (3 / 2 * x15 - 245673 * x13 / 20480)) / x24
        + alpha * x4 * (5103 / 32768 * x12 + 1j * (729 / 32768 * sigma * x11 + 729 / 8192 * x15
        - 5491557 / 16777216 * x13)) / x21 - sigma * x0 - 185895 / 65536 * x0 * x1 * x10 * x9
        - 168399 / 131072 * x14 * x2 * x9 - 15 / 16 * x2 * x22 * x23 / x16
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
        Detuning, 3*Omega = omega_0 + sigma, rad/s, real.
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
