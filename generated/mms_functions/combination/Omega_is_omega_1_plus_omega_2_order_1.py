# Emitted by mmsgen 0.1.0 from derivations/combination.py: change that, not this file.
# Made from sha256 a7288d9b10674a0a9316731802a7de41c1efbcc70b623745e89628b2862bfd37
# Operations for each point: growth_rate 7, boundaries 7, resonance 1, slow_flow_matrix 6,
# characteristic_coefficients 7, slow_flow 15, motion 26
"""combination: Omega = omega_1 + omega_2 + sigma, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of x, y. Results are written at ε = 1.

Stability depends: the discriminant of Gamma**2 - I*Gamma*sigma - f_12*f_21/(4*omega_1*omega_2) is
positive in an interval of the detuning if 4*f_12*f_21/(omega_1*omega_2) > 0.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._edges import explicit_edges
from .._evolution import Linear, evolution_at
from .._growth import growing
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
RELATIONS: tuple[str, ...] = ("Omega = omega_1 + omega_2 + sigma",)

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega_1 + omega_2 + sigma"),
    "omega_1": ("positive", "rad/s", "natural frequency of the first mode"),
    "omega_2": ("positive", "rad/s", "natural frequency of the second mode"),
    "f_12": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_21": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_11": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_22": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
    "y": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x", "conj(A_y)")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    2,
    (
        ((0, 0), (1, 1)),
    ),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (1, 0, 0, 0, 0, 0), (0,)), (0, 1, (0, 0, 0, 1, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 1, 0, 0), (1,)), (1, 0, (1, 0, 0, 0, 0, 0), (-1,)),
        (1, 0, (1, 0, 0, 0, 0, 0), (1,)), (1, 1, (0, 0, 0, 1, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 1, 0, 0), (1,)), (1, 1, (1, 0, 0, 0, 0, 0), (1,)),
    ),
    1,
)


def _growth_rate(sigma, omega_1, omega_2, f_12, f_21):
    # Intermediates
    x0 = sigma * sigma
    # Outputs
    discriminant_1 = f_12 * f_21 / (omega_1 * omega_2) - x0
    return growing(discriminant_1)


def _boundaries(omega_1, omega_2, f_12, f_21):
    # Intermediates
    x0 = np.sqrt(f_12 * f_21)
    x1 = np.sqrt(1 / (omega_1 * omega_2))
    x2 = x0 * x1
    # Outputs
    lower = -x2
    upper = x2
    return lower, upper


def _resonance(omega_1, omega_2, f_12, f_21):
    centre = omega_1 + omega_2
    return centre, omega_1, omega_2, f_12, f_21


def _slow_flow_matrix(out, sigma, omega_1, omega_2, f_12, f_21):
    out[..., 0, 1].imag = 1 / 2 * f_12 / omega_1
    out[..., 1, 0].imag = -1 / 2 * f_21 / omega_2
    out[..., 1, 1].imag = sigma


def _characteristic_coefficients(out, sigma, omega_1, omega_2, f_12, f_21):
    c1_1 = -1j * sigma
    c1_0 = -1 / 4 * f_12 * f_21 / (omega_1 * omega_2)
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_x, A_y, sigma, omega_1, omega_2, f_12, f_21):
    out[..., 0] = 1 / 2 * 1j * f_12 * np.conj(A_y) / omega_1
    out[..., 1] = 1 / 2 * 1j * f_21 * np.conj(A_x) / omega_2 - 1j * A_y * sigma


def _motion(out, sigma, omega_1, omega_2, f_12, f_21, f_11, f_22):
    # Intermediates
    x0 = omega_1 + omega_2
    x1 = 1 / x0
    x2 = 1 / 2 * x1
    x3 = 1 / (omega_1 - omega_2)
    x4 = 2 * x1
    x5 = f_11 * x4
    x6 = f_22 * x4
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = f_12 * x2 / omega_2
    out[..., 3] = -x3 * x5
    out[..., 4] = x5 / (3 * omega_1 + omega_2)
    out[..., 5] = x3 * x6
    out[..., 6] = x6 / (omega_1 + 3 * omega_2)
    out[..., 7] = f_21 * x2 / omega_1
    out[..., 8] = omega_1
    out[..., 9] = omega_2 + sigma
    out[..., 10] = sigma + x0


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Amplitudes grow like exp(Γ t). Where the discriminant of the quadratic in Γ is positive, the
    rate is half its root; elsewhere both modes are neutral and the rate is exactly 0.0.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21,
    )
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("sigma", "omega_1", "omega_2", "f_12", "f_21") if gradient else (),
    )


def boundaries(
    *, omega_1: ArrayLike, omega_2: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
    gradient: bool = False,
) -> Any:
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
    arguments = checked(PARAMETERS, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21)
    return boundaries_at(
        evaluate_pair,
        _boundaries,
        arguments,
        ("omega_1", "omega_2", "f_12", "f_21") if gradient else (),
    )


def critical_speeds(
    *, omega_1: ArrayLike, omega_2: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Both edges of the unstable zone in Omega.

    Where Omega = omega_1 + omega_2 + sigma lies on an edge of `boundaries`.

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
    arguments = checked(PARAMETERS, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21)
    return explicit_edges(
        _resonance,
        _boundaries,
        1,
        arguments,
        ("omega_1", "omega_2", "f_12", "f_21") if gradient else (),
    )


def slow_flow_matrix(
    *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike,
    omega_2: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
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
    sigma : array_like
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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
        Shape (..., 2), complex128, in the unit of the amplitudes.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21,
    )
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    f_12: ArrayLike, f_21: ArrayLike,
) -> Beating:
    """How amplitudes beat: period and largest modulus, from those at t = 0.

    Closed forms where no mode decays: the sum of the moduli of the parts in each eigenvalue, which
    is the least upper bound of |B_j| unless three or more frequencies are commensurable. Else a
    maximum that is searched for in time.

    Parameters
    ----------
    amplitudes : array_like
        Those at t = 0, shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21,
    )
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike,
    omega_2: ArrayLike, f_12: ArrayLike, f_21: ArrayLike, f_11: ArrayLike, f_22: ArrayLike,
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
    sigma : array_like
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_11 : array_like
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
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21, f_11=f_11,
        f_22=f_22,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=("sigma", "omega_1", "omega_2", "f_12", "f_21", "f_11", "f_22") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    f_12: ArrayLike, f_21: ArrayLike, f_11: ArrayLike, f_22: ArrayLike,
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
    sigma : array_like
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_11 : array_like
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
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_12=f_12, f_21=f_21, f_11=f_11,
        f_22=f_22,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 5, False))
