# Emitted by mmsgen 0.1.0 from derivations/combination.py: change that, not this file.
# Made from sha256 56cf420a26cf066a66c9ff0694b7924e3854c4484a078833d0b4f3ba6509338d
# Operations for each point: growth_rate 50, slow_flow_matrix 9, characteristic_coefficients 48,
# slow_flow 23
"""combination: Omega = 2*omega_1 + sigma_1 and omega_2 = 3*omega_1 + sigma_2, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of x, y. Results are written at ε = 1.

Stability depends: a factor of degree 4 in Gamma has no closed-form criterion here.

No boundaries are emitted: a factor of degree 4 in Gamma has no closed-form criterion here: there is
no boundary; use growth_rate.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._runtime import (
    checked,
    checked_amplitudes,
    conservative_growth,
    evaluate,
    evaluate_array,
    multiply_out,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "COORDINATES",
    "FRAME",
    "ORDER",
    "PARAMETERS",
    "RELATIONS",
    "VARIABLES",
    "characteristic_coefficients",
    "growth_rate",
    "slow_flow",
    "slow_flow_matrix",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ("Omega = 2*omega_1 + sigma_1", "omega_2 = 3*omega_1 + sigma_2")

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma_1": ("real", "rad/s", "detuning, Omega = 2*omega_1 + sigma_1"),
    "sigma_2": ("real", "rad/s", "detuning, omega_2 = 3*omega_1 + sigma_2"),
    "omega_1": ("positive", "rad/s", "natural frequency of the first mode"),
    "f_11": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_12": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_21": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {"sigma_1": 1 / 2},
    "y": {"sigma_1": 3 / 2},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x", "conj(A_x)", "A_y", "conj(A_y)")


# --- formulas -------------------------------------------------------------------------------------


def _growth_rate(sigma_1, sigma_2, omega_1, f_11, f_12, f_21):
    # Intermediates
    x0 = 3 / 4 * sigma_2
    x1 = sigma_2 * sigma_2
    x2 = 1 / 4 * x1
    x3 = omega_1 * omega_1
    x4 = 1 / x3
    x5 = f_12 * f_21 * x4
    x6 = f_11 * f_11
    x7 = x4 * x6
    x8 = sigma_1 * sigma_1
    x9 = x8 * x8
    x10 = sigma_1 * x8
    x11 = f_12 * f_12
    x12 = f_21 * f_21
    x13 = x3 * x3
    # Outputs
    coefficient_1 = (
        sigma_1 * sigma_2 * x5 / 12 + sigma_1 * x0 * x7 + x11 * x12 / (144 * x13) + x2 * x8
        + 9 / 16 * x9 - x0 * x10 - x2 * x7 - 1 / 8 * x5 * x8 - 9 / 16 * x7 * x8
    )
    coefficient_2 = 0
    coefficient_3 = 3 * sigma_1 * sigma_2 + 1 / 4 * x4 * x6 - x1 - x5 / 6 - 5 / 2 * x8
    return conservative_growth(coefficient_1, coefficient_2, coefficient_3, coefficient_2)


def _slow_flow_matrix(out, sigma_1, sigma_2, omega_1, f_11, f_12, f_21):
    # Intermediates
    x0 = 1 / 2 * sigma_1
    x1 = 1 / omega_1
    x2 = 1 / 2 * x1
    x3 = f_11 * x2
    x4 = f_12 * x2
    x5 = f_21 * x1 / 6
    x6 = 3 / 2 * sigma_1 - sigma_2
    # Outputs
    out[..., 0, 0].imag = -x0
    out[..., 0, 1].imag = x3
    out[..., 0, 2].imag = x4
    out[..., 1, 0].imag = -x3
    out[..., 1, 1].imag = x0
    out[..., 1, 3].imag = -x4
    out[..., 2, 0].imag = x5
    out[..., 2, 2].imag = -x6
    out[..., 3, 1].imag = -x5
    out[..., 3, 3].imag = x6


def _characteristic_coefficients(out, sigma_1, sigma_2, omega_1, f_11, f_12, f_21):
    # Intermediates
    x0 = sigma_1 * sigma_2
    x1 = omega_1 * omega_1
    x2 = 1 / x1
    x3 = f_12 * f_21 * x2
    x4 = f_11 * f_11
    x5 = x2 * x4
    x6 = 1 / 4 * x5
    x7 = sigma_2 * sigma_2
    x8 = sigma_1 * sigma_1
    x9 = x8 * x8
    x10 = sigma_1 * x8
    x11 = f_12 * f_12
    x12 = f_21 * f_21
    x13 = x1 * x1
    # Outputs
    c1_2 = x3 / 6 + x7 + 5 / 2 * x8 - 3 * x0 - x6
    c1_0 = (
        x0 * x3 / 12 + 3 / 4 * x0 * x5 + x11 * x12 / (144 * x13) + 1 / 4 * x7 * x8 + 9 / 16 * x9
        - 3 / 4 * sigma_2 * x10 - 1 / 8 * x3 * x8 - 9 / 16 * x5 * x8 - x6 * x7
    )
    multiply_out(out, ((0.0, c1_2, 0.0, c1_0), 1))


def _slow_flow(out, A_x, A_y, sigma_1, sigma_2, omega_1, f_11, f_12, f_21):
    # Intermediates
    x0 = 1 / 2 * 1j
    x1 = 1 / omega_1
    x2 = 1j * A_y
    # Outputs
    out[..., 0] = f_11 * x0 * x1 * np.conj(A_x) + 1 / 2 * f_12 * x1 * x2 - A_x * sigma_1 * x0
    out[..., 1] = 1j * A_x * f_21 * x1 / 6 + sigma_2 * x2 - 3 / 2 * sigma_1 * x2


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike, f_11: ArrayLike, f_12: ArrayLike,
    f_21: ArrayLike,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    The polynomial of the undamped modes is real in Λ, Γ = iΛ; the eigenvalues of its companion
    matrix are exactly real where the modes are neutral, so that the rate is exactly 0.0 there.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, Omega = 2*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    float64
        In 1/s, float64, in the shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, f_11=f_11, f_12=f_12,
        f_21=f_21,
    )
    return evaluate(_growth_rate, arguments)


def slow_flow_matrix(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike, f_11: ArrayLike, f_12: ArrayLike,
    f_21: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, Omega = 2*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    complex128
        Shape (..., 4, 4), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, f_11=f_11, f_12=f_12,
        f_21=f_21,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (4, 4))


def characteristic_coefficients(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike, f_11: ArrayLike, f_12: ArrayLike,
    f_21: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, Omega = 2*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    complex128
        Shape (..., 5), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, f_11=f_11, f_12=f_12,
        f_21=f_21,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (5,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma_1 : array_like
        Detuning, Omega = 2*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, f_11=f_11, f_12=f_12,
        f_21=f_21,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))
