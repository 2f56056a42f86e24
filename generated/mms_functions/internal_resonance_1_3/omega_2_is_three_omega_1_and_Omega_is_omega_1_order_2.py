# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_3.py: change that, not this file.
# Made from sha256 3ac367087234b76490ee3edefb5e6e3f84878068336ac46061a60aece9a41a5a
# Operations for each point: slow_flow 298
"""internal_resonance_1_3: omega_2 = 3*omega_1 + sigma_1 and Omega = omega_1 + sigma_2, order 2.

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
RELATIONS: tuple[str, ...] = ("omega_2 = 3*omega_1 + sigma_1", "Omega = omega_1 + sigma_2")

#: the highest power of ε
ORDER = 2

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
    "alpha_4": ("real", "1/(m^2 s^2)", "cubic term 4"),
    "alpha_5": ("real", "1/(m^2 s^2)", "cubic term 5"),
    "alpha_6": ("real", "1/(m^2 s^2)", "cubic term 6"),
    "alpha_7": ("real", "1/(m^2 s^2)", "cubic term 7"),
    "alpha_8": ("real", "1/(m^2 s^2)", "cubic term 8"),
    "F_1": ("nonnegative", "m/s^2", "force on the slower oscillator, over its mass"),
    "F_2": ("nonnegative", "m/s^2", "force on the faster oscillator, over its mass"),
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
    out, A_u_1, A_u_2, sigma_1, sigma_2, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4,
    alpha_5, alpha_6, alpha_7, alpha_8, F_1, F_2,
):
    # Intermediates
    x0 = 1j * sigma_2
    x1 = 1 / omega_1
    x2 = F_1 * alpha_1
    x3 = F_2 * alpha_2
    x4 = omega_1 * omega_1
    x5 = omega_1 * x4
    x6 = 1j / x5
    x7 = A_u_1 * A_u_1
    x8 = x6 * x7
    x9 = np.conj(A_u_1)
    x10 = x6 * x9
    x11 = A_u_1 * x10
    x12 = 1 / 8 * F_1
    x13 = 1 / 16 * alpha_3
    x14 = A_u_2 * x10
    x15 = np.conj(A_u_2)
    x16 = x15 * x6
    x17 = A_u_2 * x16
    x18 = 1j * omega_1
    x19 = 1 / x4
    x20 = A_u_2 * x19
    x21 = A_u_1 * x20
    x22 = -1 / 2 * alpha_1 * alpha_2
    x23 = alpha_2 * alpha_6
    x24 = alpha_3 * alpha_5
    x25 = x24 / 12
    x26 = A_u_1 * x6
    x27 = A_u_2 * x26
    x28 = 1 / 2 * omega_1
    x29 = alpha_4 * alpha_7
    x30 = 1 / 8 * alpha_2
    x31 = alpha_4 * alpha_5
    x32 = A_u_2 * x8
    x33 = A_u_1 * x7
    x34 = x9 * x9
    x35 = x7 * x7
    x36 = x34 * x9
    x37 = A_u_2 * A_u_2
    x38 = x15 * x15
    x39 = alpha_2 * alpha_2
    x40 = alpha_1 * alpha_1
    x41 = alpha_3 * alpha_3
    x42 = F_1 * alpha_6 / 72
    x43 = alpha_7 / 48
    x44 = F_2 * x43
    x45 = x15 * x37
    x46 = alpha_5 * alpha_8
    x47 = alpha_6 * alpha_7
    x48 = mu_2 * mu_2
    x49 = alpha_6 * alpha_6
    x50 = alpha_7 * alpha_7
    x51 = A_u_2 * x37
    x52 = alpha_8 * alpha_8
    # Outputs
    out[..., 0] = (
        A_u_1 * mu_1 * x1 * (-1 / 2 * 1j * mu_1 - omega_1)
        + F_1 * x19 * (1 / 8 * mu_1 + 1j * (1 / 8 * sigma_2 - 1 / 4 * omega_1))
        + alpha_1 * x19 * x7 * x9 * (-3 / 2 * mu_1 - 3 / 2 * x18)
        + alpha_2 * x20 * x34 * (1j * (1 / 4 * sigma_1 - x28) - 1 / 4 * mu_1 - 1 / 4 * mu_2)
        + alpha_3 * x15 * x21 * (-mu_2 - x18) + x11 * (-3 / 8 * x2 - 1 / 16 * x3)
        + x14 * (alpha_2 * x12 - F_2 * x13) + x15 * x32 * x9 * (19 * x39 / 24 - 3 / 2 * alpha_1
        * alpha_3 - 3 / 8 * alpha_2 * alpha_7 - alpha_6 * x13 - 9 / 8 * x31) + x16 * x34 * x37 * (9
        / 16 * alpha_1 * alpha_4 + 5 / 16 * alpha_2 * alpha_3 - 3 / 16 * alpha_3 * alpha_7 - 9 / 32
        * alpha_4 * alpha_6 - alpha_8 * x30) + x16 * x35 * (-x22 - 1 / 16 * x23 - x25)
        + x17 * (-3 / 16 * F_2 * alpha_4 - alpha_3 * x12)
        + x26 * x37 * x38 * (3 / 4 * alpha_2 * alpha_4 - 99 * x29 / 160 - 15 / 32 * x41)
        + x27 * x36 * (-x22 - 5 * x23 / 24 - 7 * x24 / 24)
        + x33 * x34 * x6 * (-29 * alpha_2 * alpha_5 / 48 - 15 / 16 * x40)
        + x8 * (3 / 16 * x2 - 1 / 32 * x3) - A_u_1 * x0
    )
    out[..., 1] = (
        A_u_2 * x1 * (1j * (omega_1 * sigma_1 - x48 / 6) - mu_2 * omega_1)
        + alpha_5 * x19 * x33 * (mu_2 / 36 + 1j * (sigma_1 / 36 - omega_1 / 6) - mu_1 / 12)
        + alpha_6 * x21 * x9 * (1j * (sigma_1 / 9 - omega_1 / 3) - mu_1 / 9)
        + alpha_8 * x19 * x45 * (1j * (sigma_1 / 6 - x28) - mu_2 / 6) + x11 * x45 * (alpha_3
        * alpha_6 / 48 + alpha_7 * x30 + 3 / 8 * x31 - alpha_6 * alpha_8 / 18 - 11 * x50 / 80)
        + x14 * (-x42 - x44) + x17 * x33 * (alpha_1 * alpha_7 / 24 + alpha_2 * alpha_6 / 24 - x25
        - x46 / 36 - 1 / 16 * x47) + x27 * (x42 - x44)
        + x32 * x34 * (11 * alpha_2 * alpha_5 / 48 - 1 / 4 * alpha_5 * alpha_7 - 25 * x49 / 864)
        + x36 * x37 * x6 * (alpha_1 * x43 + x24 / 48 + x46 / 72 - x23 / 36 - 1 / 32 * x47)
        + x38 * x51 * x6 * (91 * x29 / 480 - 5 * x52 / 144)
        + x8 * (-F_1 * alpha_5 / 48 - F_2 * alpha_6 / 96) - 3 * A_u_2 * x0
        - 31 * alpha_5 * alpha_6 * x10 * x35 / 432
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike,
    alpha_4: ArrayLike, alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike,
    alpha_8: ArrayLike, F_1: ArrayLike, F_2: ArrayLike,
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
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.

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
        alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5,
        alpha_6=alpha_6, alpha_7=alpha_7, alpha_8=alpha_8, F_1=F_1, F_2=F_2,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))
