# Emitted by mmsgen 0.1.0 from derivations/combination.py: change that, not this file.
# Made from sha256 207ac8f56e9b601e11b4bf06c37454990338e75ff8ae5d474a8a439c5911df2e
# Operations for each point: growth_rate 50, boundaries 60, resonance 3, slow_flow_matrix 9,
# characteristic_coefficients 48, slow_flow 23, motion 17
"""combination: Omega = 2*omega_1 + sigma_1 and omega_2 = 3*omega_1 + sigma_2, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of x, y. Results are written at ε = 1.

Stability depends: the signs of the coefficients and of the discriminant in Gamma^2 of Gamma**4 +
Gamma**2*(-f_11**2/4 + f_12*f_21/6 + 5*omega_1**2*sigma_1**2/2 - 3*omega_1**2*sigma_1*sigma_2 +
omega_1**2*sigma_2**2)/omega_1**2 + (-9*f_11*omega_1*sigma_1 + 6*f_11*omega_1*sigma_2 - f_12*f_21 +
9*omega_1**2*sigma_1**2 - 6*omega_1**2*sigma_1*sigma_2)*(9*f_11*omega_1*sigma_1 -
6*f_11*omega_1*sigma_2 - f_12*f_21 + 9*omega_1**2*sigma_1**2 -
6*omega_1**2*sigma_1*sigma_2)/(144*omega_1**4) decide.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._edges import explicit_edges, zone
from .._evolution import Linear, evolution_at
from .._growth import conservative_growth
from .._initial import initial_at
from .._motion import Motion, response_at
from .._runtime import (
    checked,
    checked_amplitudes,
    evaluate,
    evaluate_array,
    evaluate_pair,
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
    "beating",
    "boundaries",
    "characteristic_coefficients",
    "critical_speeds",
    "evolution",
    "growth_rate",
    "initial_amplitudes",
    "response",
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
    "omega_2": ("positive", "rad/s", "natural frequency of the second mode"),
    "f_22": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {"sigma_1": 1 / 2},
    "y": {"sigma_1": 3 / 2},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x", "conj(A_x)", "A_y", "conj(A_y)")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    2,
    (
        ((0, 0), (0, 1), (1, 0), (1, 1)),
    ),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (1, 0, 0, 0, 0, 0), (0,)), (0, 1, (0, 0, 0, 1, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 1, 0, 0), (1,)), (1, 0, (1, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 1, 0, 0), (-1,)), (1, 1, (0, 0, 0, 1, 0, 0), (1,)),
        (1, 1, (1, 0, 0, 0, 0, 0), (-1,)),
    ),
    1,
)


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


def _boundaries(sigma_2, omega_1, f_11, f_12, f_21):
    # Intermediates
    x0 = sigma_2 * sigma_2
    x1 = 1 / 4 * x0
    x2 = omega_1 * omega_1
    x3 = 1 / x2
    x4 = f_11 * f_11
    x5 = x3 * x4
    x6 = x2 * x2
    x7 = 1 / x6
    x8 = f_12 * f_12
    x9 = f_21 * f_21
    x10 = f_12 * f_21 * x3
    x11 = 3 / 4 * sigma_2
    x12 = x0 * x0
    x13 = x4 * x4
    x14 = 4 * x10 / 3
    x15 = sigma_2 * x0
    # Outputs
    p1_0 = x1 * x5 - x7 * x8 * x9 / 144
    p1_1 = -sigma_2 * x10 / 12 - x11 * x5
    p1_2 = 1 / 8 * x10 + 9 / 16 * x5 - x1
    p1_3 = x11
    p1_4 = -9 / 16
    p2_0 = 1 / 4 * x3 * x4 - x0 - x10 / 6
    p2_1 = 3 * sigma_2
    p2_2 = -5 / 2
    p3_0 = f_12 * f_21 * x4 * x7 / 12 - x0 * x10 / 3 - 1 / 2 * x0 * x5 - x12 - 1 / 16 * x13 * x7
    p3_1 = sigma_2 * x14 + 3 / 2 * sigma_2 * x5 + 6 * x15
    p3_2 = -13 * x0 - x14 - x5
    p3_3 = 12 * sigma_2
    p3_4 = -4
    reach = omega_1
    return zone(
        (p1_0, p1_1, p1_2, p1_3, p1_4), (p2_0, p2_1, p2_2), (p3_0, p3_1, p3_2, p3_3, p3_4),
        reach=reach,
    )


def _resonance(omega_1, omega_2, f_11, f_12, f_21):
    centre = 2 * omega_1
    sigma_2_ = omega_2 - 3 * omega_1
    return centre, sigma_2_, omega_1, f_11, f_12, f_21


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


def _motion(out, sigma_1, sigma_2, omega_1, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = 1 / 4 * x1
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = f_12 * x1 / 12
    out[..., 3] = f_11 * x2
    out[..., 4] = -f_22 * x2
    out[..., 5] = 1 / 8 * f_22 * x1
    out[..., 6] = -f_21 * x2
    out[..., 7] = omega_1 + 1 / 2 * sigma_1
    out[..., 8] = 3 * omega_1 + 3 / 2 * sigma_1
    out[..., 9] = 2 * omega_1 + sigma_1


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike, f_11: ArrayLike, f_12: ArrayLike,
    f_21: ArrayLike, gradient: bool = False,
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
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        In 1/s, float64, in the shape to which the arguments broadcast; with gradient this and name
        -> derivative, 0.0 where modes are neutral and NaN where they meet, as at edges.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, f_11=f_11, f_12=f_12,
        f_21=f_21,
    )
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("sigma_1", "sigma_2", "omega_1", "f_11", "f_12", "f_21") if gradient else (),
    )


def boundaries(
    *, sigma_2: ArrayLike, omega_1: ArrayLike, f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Both edges of the unstable interval of sigma_1.

    The interval of sigma_1 in which growth_rate is positive: where one of the polynomials with the
    coefficients in `_boundaries` (lowest power first) is. Infinite where the interval has no end.
    Order 1 leaves out terms of the edges from ε^2 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero, and
    none that begins farther from it than omega_1, half of the frequencies that resonate;
    SlowFlow.zones() gives all of them.

    Parameters
    ----------
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
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    lower, upper : float64
        In rad/s, float64, in the shape to which the arguments broadcast; NaN where there is no
        unstable interval. With gradient this pair and name -> pair.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_2=sigma_2, omega_1=omega_1, f_11=f_11, f_12=f_12, f_21=f_21,
    )
    return boundaries_at(
        evaluate_pair,
        _boundaries,
        arguments,
        ("sigma_2", "omega_1", "f_11", "f_12", "f_21") if gradient else (),
    )


def critical_speeds(
    *, omega_1: ArrayLike, omega_2: ArrayLike, f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Both edges of the unstable zone in Omega.

    Where Omega = 2*omega_1 + sigma_1 lies on an edge of `boundaries`.

    Parameters
    ----------
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    lower, upper : float64
        In rad/s, float64, in the shape to which the arguments broadcast; NaN where there is no such
        edge. With gradient this pair and name -> pair.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21,
    )
    return explicit_edges(
        _resonance,
        _boundaries,
        1,
        arguments,
        ("omega_1", "omega_2", "f_11", "f_12", "f_21") if gradient else (),
    )


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


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike,
    omega_1: ArrayLike, f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at any time from those at t = 0.

    The matrix exponential of the slow flow, in the frame A_j = B_j exp(i λ_j t), λ in FRAME: a
    closed form for blocks of one and two variables, scaling and squaring for larger ones; no
    eigenvectors, so that double eigenvalues do no harm.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Those at t = 0, shape (..., 2), in the order of COORDINATES.
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
        Shape (..., 2), complex128, in the unit of the amplitudes.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, f_11=f_11, f_12=f_12,
        f_21=f_21,
    )
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
) -> Beating:
    """How amplitudes beat: period and largest modulus, from those at t = 0.

    Closed forms where no mode decays: the sum of the moduli of the parts in each eigenvalue, which
    is the least upper bound of |B_j| unless three or more frequencies are commensurable. Else a
    maximum that is searched for in time.

    Parameters
    ----------
    amplitudes : array_like
        Those at t = 0, shape (..., 2), in the order of COORDINATES.
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
    Beating
        period (s), largest, margin, each of shape (..., 2). The period is NaN unless exactly two
        frequencies take part; largest is infinite where the amplitude grows without bound; margin
        is how much too small it may be, 0 for closed forms.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, f_11=f_11, f_12=f_12,
        f_21=f_21,
    )
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike,
    omega_1: ArrayLike, f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike, f_22: ArrayLike,
    order: int | None = None, gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. NaN where a harmonic resonates itself. Derivatives
    are taken with these fixed. Over times of order 1/ε the error is O(ε^1). A UserWarning says how
    much is left out where that is more than a tenth of the motion, estimated from the harmonics of
    each order beside those of order zero.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
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
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 1; all by default.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2), in the order x, y; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, f_11=f_11, f_12=f_12,
        f_21=f_21, f_22=f_22,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=("sigma_1", "sigma_2", "omega_1", "f_11", "f_12", "f_21", "f_22") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike, f_22: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at t = 0 of the motion with given coordinates and velocities there.

    The solution of response(0, amplitudes) = q, and of its derivative along slow_flow = v, that
    goes over into that of order zero as the small parameters go to zero.

    Parameters
    ----------
    q : array_like
        Coordinates at t = 0, shape (..., 2), in the order of COORDINATES.
    v : array_like
        Velocities at t = 0, shape (..., 2), per second.
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
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    complex128
        Shape (..., 2), complex128; NaN where there is none near that of order zero, as far outside
        of the scaling, or where a harmonic resonates itself.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, f_11=f_11, f_12=f_12,
        f_21=f_21, f_22=f_22,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 6, False))
