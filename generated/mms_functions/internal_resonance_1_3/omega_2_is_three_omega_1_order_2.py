# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_3.py: change that, not this file.
# Made from sha256 67e865e1ca09e4e43b1bee16441f53e564470686f91de9971800d382d30dc814
# Operations for each point: slow_flow 237
"""internal_resonance_1_3: omega_2 = 3*omega_1 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of u_1, u_2. Results are written at ε = 1.

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
RELATIONS: tuple[str, ...] = ("omega_2 = 3*omega_1 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u_1", "u_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, omega_2 = 3*omega_1 + sigma"),
    "omega_1": ("positive", "rad/s", "natural frequency of the slower oscillator"),
    "mu_1": ("nonnegative", "1/s", "damping of the slower oscillator"),
    "mu_2": ("nonnegative", "1/s", "damping of the faster oscillator"),
    "alpha_1": ("real", "1/(m^2 s^2)", "cubic term 1"),
    "alpha_2": ("real", "1/(m^2 s^2)", "cubic term 2"),
    "alpha_3": ("real", "1/(m^2 s^2)", "cubic term 3"),
    "alpha_4": ("real", "1/(m^2 s^2)", "cubic term 4"),
    "alpha_5": ("real", "1/(m^2 s^2)", "cubic term 5"),
    "alpha_6": ("real", "1/(m^2 s^2)", "cubic term 6"),
    "alpha_7": ("real", "1/(m^2 s^2)", "cubic term 7"),
    "alpha_8": ("real", "1/(m^2 s^2)", "cubic term 8"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u_1": {},
    "u_2": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(
    out, A_u_1, A_u_2, sigma, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4, alpha_5,
    alpha_6, alpha_7, alpha_8,
):
    # Intermediates
    x0 = 1 / omega_1
    x1 = np.conj(A_u_2)
    x2 = 1j * omega_1
    x3 = omega_1 * omega_1
    x4 = 1 / x3
    x5 = A_u_2 * x4
    x6 = A_u_1 * x5
    x7 = np.conj(A_u_1)
    x8 = A_u_1 * A_u_1
    x9 = x7 * x8
    x10 = omega_1 * x3
    x11 = 1j / x10
    x12 = x7 * x7
    x13 = x11 * x12
    x14 = -1 / 2 * alpha_1 * alpha_2
    x15 = alpha_2 * alpha_6
    x16 = alpha_3 * alpha_5
    x17 = x16 / 12
    x18 = x1 * x11
    x19 = x12 * x7
    x20 = x11 * x19
    x21 = 1 / 2 * omega_1
    x22 = alpha_4 * alpha_7
    x23 = x1 * x1
    x24 = x11 * x23
    x25 = A_u_2 * A_u_2
    x26 = A_u_1 * x25
    x27 = 1 / 8 * alpha_2
    x28 = x1 * x25
    x29 = 1 / 16 * alpha_6
    x30 = alpha_4 * alpha_5
    x31 = A_u_2 * x18
    x32 = A_u_1 * x8
    x33 = x8 * x8
    x34 = alpha_1 * alpha_1
    x35 = alpha_3 * alpha_3
    x36 = alpha_2 * alpha_2
    x37 = alpha_6 * x7
    x38 = alpha_5 * alpha_8
    x39 = mu_2 * mu_2
    x40 = A_u_2 * x25
    x41 = alpha_8 * alpha_8
    x42 = alpha_6 * alpha_6
    x43 = alpha_7 * alpha_7
    # Outputs
    out[..., 0] = (
        A_u_1 * A_u_2 * x20 * (-x14 - 5 * x15 / 24 - 7 * x16 / 24)
        + A_u_1 * mu_1 * x0 * (-1 / 2 * 1j * mu_1 - omega_1)
        + alpha_1 * x4 * x9 * (-3 / 2 * mu_1 - 3 / 2 * x2)
        + alpha_2 * x12 * x5 * (1j * (1 / 4 * sigma - x21) - 1 / 4 * mu_1 - 1 / 4 * mu_2)
        + alpha_3 * x1 * x6 * (-mu_2 - x2) + x13 * x28 * (9 / 16 * alpha_1 * alpha_4 + 5 / 16
        * alpha_2 * alpha_3 - 3 / 16 * alpha_3 * alpha_7 - 9 / 32 * alpha_4 * alpha_6 - alpha_8
        * x27) + x13 * x32 * (-29 * alpha_2 * alpha_5 / 48 - 15 / 16 * x34)
        + x18 * x33 * (-x14 - 1 / 16 * x15 - x17)
        + x24 * x26 * (3 / 4 * alpha_2 * alpha_4 - 99 * x22 / 160 - 15 / 32 * x35) + x31 * x9 * (19
        * x36 / 24 - 3 / 2 * alpha_1 * alpha_3 - 3 / 8 * alpha_2 * alpha_7 - alpha_3 * x29 - 9 / 8
        * x30)
    )
    out[..., 1] = (
        A_u_2 * x0 * (1j * (omega_1 * sigma - x39 / 6) - mu_2 * omega_1) + A_u_2 * x13 * x8 * (11
        * alpha_2 * alpha_5 / 48 - 1 / 4 * alpha_5 * alpha_7 - 25 * x42 / 864)
        + alpha_5 * x32 * x4 * (mu_2 / 36 + 1j * (sigma / 36 - omega_1 / 6) - mu_1 / 12)
        + alpha_8 * x28 * x4 * (1j * (sigma / 6 - x21) - mu_2 / 6) + x18 * x26 * x7 * (alpha_3
        * alpha_6 / 48 + alpha_7 * x27 + 3 / 8 * x30 - alpha_6 * alpha_8 / 18 - 11 * x43 / 80) + x20
        * x25 * (alpha_1 * alpha_7 / 48 + x16 / 48 + x38 / 72 - 1 / 32 * alpha_6 * alpha_7 - x15
        / 36) + x24 * x40 * (91 * x22 / 480 - 5 * x41 / 144) + x31 * x32 * (alpha_1 * alpha_7 / 24
        + alpha_2 * alpha_6 / 24 - alpha_7 * x29 - x17 - x38 / 36)
        + x37 * x6 * (1j * (sigma / 9 - omega_1 / 3) - mu_1 / 9)
        - 31 * alpha_5 * x11 * x33 * x37 / 432
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike,
    mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike, alpha_4: ArrayLike,
    alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike, alpha_8: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, omega_2 = 3*omega_1 + sigma, rad/s, real.
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
    alpha_4 : array_like
        Cubic term 4, 1/(m^2 s^2), real.
    alpha_5 : array_like
        Cubic term 5, 1/(m^2 s^2), real.
    alpha_6 : array_like
        Cubic term 6, 1/(m^2 s^2), real.
    alpha_7 : array_like
        Cubic term 7, 1/(m^2 s^2), real.
    alpha_8 : array_like
        Cubic term 8, 1/(m^2 s^2), real.

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
        alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5, alpha_6=alpha_6,
        alpha_7=alpha_7, alpha_8=alpha_8,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))
