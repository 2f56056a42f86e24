# Emitted by mmsgen 0.1.0 from derivations/combination.py: change that, not this file.
# Made from sha256 0df5f815205c4c6974bb939403f958e9d77871b0e8f3d4b7521b2c471fe12c59
# Operations for each point: growth_rate 7, boundaries 7, resonance 1, slow_flow_matrix 6,
# characteristic_coefficients 7, slow_flow 12
"""combination: Omega = omega_2 - omega_1 + sigma, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of x, y. Results are written at ε = 1.

Stability depends: the discriminant of Gamma**2 + I*Gamma*sigma + f_12*f_21/(4*omega_1*omega_2) is
positive in an interval of the detuning if -4*f_12*f_21/(omega_1*omega_2) > 0.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._edges import explicit_edges
from .._runtime import (
    checked,
    checked_amplitudes,
    evaluate,
    evaluate_array,
    evaluate_pair,
    growing,
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
    "boundaries",
    "characteristic_coefficients",
    "critical_speeds",
    "growth_rate",
    "slow_flow",
    "slow_flow_matrix",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ("Omega = omega_2 - omega_1 + sigma",)

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = -omega_1 + omega_2 + sigma"),
    "omega_1": ("positive", "rad/s", "natural frequency of the first mode"),
    "omega_2": ("positive", "rad/s", "natural frequency of the second mode"),
    "f_12": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_21": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
    "y": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x", "A_y")


# --- formulas -------------------------------------------------------------------------------------


def _growth_rate(sigma, omega_1, omega_2, f_12, f_21):
    # Intermediates
    x0 = sigma * sigma
    # Outputs
    discriminant_1 = -f_12 * f_21 / (omega_1 * omega_2) - x0
    return growing(discriminant_1)


def _boundaries(omega_1, omega_2, f_12, f_21):
    # Intermediates
    x0 = np.sqrt(-f_12 * f_21)
    x1 = np.sqrt(1 / (omega_1 * omega_2))
    x2 = x0 * x1
    # Outputs
    lower = -x2
    upper = x2
    return lower, upper


def _resonance(omega_1, omega_2, f_12, f_21):
    centre = omega_2 - omega_1
    return centre, omega_1, omega_2, f_12, f_21


def _slow_flow_matrix(out, sigma, omega_1, omega_2, f_12, f_21):
    out[..., 0, 1].imag = 1 / 2 * f_12 / omega_1
    out[..., 1, 0].imag = 1 / 2 * f_21 / omega_2
    out[..., 1, 1].imag = -sigma


def _characteristic_coefficients(out, sigma, omega_1, omega_2, f_12, f_21):
    c1_1 = 1j * sigma
    c1_0 = 1 / 4 * f_12 * f_21 / (omega_1 * omega_2)
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_x, A_y, sigma, omega_1, omega_2, f_12, f_21):
    # Intermediates
    x0 = 1j * A_y
    # Outputs
    out[..., 0] = 1 / 2 * f_12 * x0 / omega_1
    out[..., 1] = 1 / 2 * 1j * A_x * f_21 / omega_2 - sigma * x0


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Amplitudes grow like exp(Γ t). Where the discriminant of the quadratic in Γ is positive, the
    rate is half its root; elsewhere both modes are neutral and the rate is exactly 0.0.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = -omega_1 + omega_2 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21,
    )
    return evaluate(_growth_rate, arguments)


def boundaries(
    *, omega_1: ArrayLike, omega_2: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable interval of sigma.

    In closed form: the roots of a quadratic in it, between which growth_rate is positive. Order 1
    leaves out terms of the edges from ε^2 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero;
    SlowFlow.zones() gives all of them.

    Parameters
    ----------
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    lower, upper : float64
        In rad/s, float64, in the shape to which the arguments broadcast; NaN where there is no
        unstable interval.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21)
    return evaluate_pair(_boundaries, arguments)


def critical_speeds(
    *, omega_1: ArrayLike, omega_2: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable zone in Omega.

    Where Omega = omega_2 - omega_1 + sigma lies on an edge of `boundaries`.

    Parameters
    ----------
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    lower, upper : float64
        In rad/s, float64, in the shape to which the arguments broadcast; NaN where there is no such
        edge.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21)
    return explicit_edges(_resonance, _boundaries, 1, arguments)


def slow_flow_matrix(
    *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = -omega_1 + omega_2 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    complex128
        Shape (..., 2, 2), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (2, 2))


def characteristic_coefficients(
    *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = -omega_1 + omega_2 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    complex128
        Shape (..., 3), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (3,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    f_12: ArrayLike, f_21: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = -omega_1 + omega_2 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))
