# Emitted by mmsgen 0.1.0 from derivations/helmholtz_duffing_forced.py: change that, not this file.
# Made from sha256 0ca2676ea60a144489fb44de61dc06de2b142cb46d9351e1d53c8f37fc64fa3e
# Operations for each point: slow_flow 51
"""helmholtz_duffing_forced: Omega = 2*omega_0 + sigma, order 2.

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
RELATIONS: tuple[str, ...] = ("Omega = 2*omega_0 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = 2*omega_0 + sigma"),
    "omega_0": ("positive", "rad/s", "frequency of small oscillations"),
    "alpha_2": ("positive", "1/(m s^2)", "quadratic stiffness over the mass"),
    "alpha_3": ("real", "1/(m^2 s^2)", "cubic stiffness over the mass"),
    "mu": ("positive", "1/s", "half the damping over the mass"),
    "K": ("positive", "m/s^2", "amplitude of the force over the mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {"sigma": 1 / 2},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_u, sigma, omega_0, alpha_2, alpha_3, mu, K):
    # Intermediates
    x0 = np.conj(A_u)
    x1 = alpha_2 * alpha_2
    x2 = omega_0 * omega_0
    x3 = x2 * x2
    x4 = omega_0 * x2
    x5 = x3 * x4
    x6 = K * K
    x7 = mu * mu
    x8 = x2 * x3
    x9 = A_u * A_u
    # Outputs
    out[..., 0] = (
        A_u * (1j * (alpha_3 * x2 * x6 / 12 - 5 * x1 * x6 / 144 - 1 / 2 * x7 * x8) - mu * x5) / x5
        + K * alpha_2 * x0 * (2 * mu / 9 + 1j * (11 * sigma / 36 - omega_0 / 6)) / x3
        + 1j * x0 * x9 * (3 / 2 * alpha_3 * x2 - 5 * x1 / 3) / x4 - 1 / 2 * 1j * A_u * sigma
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike,
    alpha_3: ArrayLike, mu: ArrayLike, K: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = 2*omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    alpha_3 : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.
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
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, alpha_3=alpha_3, mu=mu, K=K,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
