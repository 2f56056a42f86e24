# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_3.py: change that, not this file.
# Made from sha256 c3ef43c84e75fae554d601df8f144a3f7d882dce5197da50aac4a6823b6f2a33
# Operations for each point: slow_flow 49
"""internal_resonance_1_3: omega_2 = 3*omega_1 + sigma_1 and Omega = omega_1 + sigma_2, order 1.

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
RELATIONS: tuple[str, ...] = ("omega_2 = 3*omega_1 + sigma_1", "Omega = omega_1 + sigma_2")

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("u_1", "u_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma_1": ("real", "rad/s", "detuning, omega_2 = 3*omega_1 + sigma_1"),
    "sigma_2": ("real", "rad/s", "detuning, Omega = omega_1 + sigma_2"),
    "omega_1": ("positive", "rad/s", "natural frequency of the slower oscillator"),
    "mu_1": ("nonnegative", "1/s", "damping of the slower oscillator"),
    "mu_2": ("nonnegative", "1/s", "damping of the faster oscillator"),
    "alpha_1": ("real", "1/(m^2 s^2)", "cubic term 1"),
    "alpha_2": ("real", "1/(m^2 s^2)", "cubic term 2"),
    "alpha_3": ("real", "1/(m^2 s^2)", "cubic term 3"),
    "alpha_5": ("real", "1/(m^2 s^2)", "cubic term 5"),
    "alpha_6": ("real", "1/(m^2 s^2)", "cubic term 6"),
    "alpha_8": ("real", "1/(m^2 s^2)", "cubic term 8"),
    "F_1": ("nonnegative", "m/s^2", "force on the slower oscillator, over its mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u_1": {"sigma_2": 1},
    "u_2": {"sigma_2": 3},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(
    out, A_u_1, A_u_2, sigma_1, sigma_2, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_5,
    alpha_6, alpha_8, F_1,
):
    # Intermediates
    x0 = 1j * sigma_2
    x1 = 1j / omega_1
    x2 = np.conj(A_u_2)
    x3 = A_u_2 * x1
    x4 = np.conj(A_u_1)
    x5 = x1 * x4
    x6 = A_u_1 * A_u_1
    x7 = x4 * x4
    x8 = A_u_1 * x6
    x9 = A_u_2 * A_u_2
    # Outputs
    out[..., 0] = (
        -A_u_1 * alpha_3 * x2 * x3 - A_u_1 * mu_1 - A_u_1 * x0 - 1 / 4 * F_1 * x1
        - 3 / 2 * alpha_1 * x5 * x6 - 1 / 2 * alpha_2 * x3 * x7
    )
    out[..., 1] = (
        A_u_2 * (1j * sigma_1 - mu_2) - A_u_1 * A_u_2 * alpha_6 * x5 / 3 - 3 * A_u_2 * x0
        - alpha_5 * x1 * x8 / 6 - 1 / 2 * alpha_8 * x1 * x2 * x9
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike,
    alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_8: ArrayLike, F_1: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma_1 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_1 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Cubic term 1, 1/(m^2 s^2), real.
    alpha_2 : array_like
        Cubic term 2, 1/(m^2 s^2), real.
    alpha_3 : array_like
        Cubic term 3, 1/(m^2 s^2), real.
    alpha_5 : array_like
        Cubic term 5, 1/(m^2 s^2), real.
    alpha_6 : array_like
        Cubic term 6, 1/(m^2 s^2), real.
    alpha_8 : array_like
        Cubic term 8, 1/(m^2 s^2), real.
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, alpha_5=alpha_5, alpha_6=alpha_6,
        alpha_8=alpha_8, F_1=F_1,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))
