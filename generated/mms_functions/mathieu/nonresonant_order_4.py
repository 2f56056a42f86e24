# Emitted by mmsgen 0.1.0 from derivations/mathieu.py: change that, not this file.
# Made from sha256 26fb3c76c4d0f50d24bbfd68bb609521de2cc99e46affb6c4938e902bc920709
# Operations for each point: growth_rate 0, slow_flow_matrix 60, characteristic_coefficients 62,
# slow_flow 118, motion 160
"""mathieu: no resonance, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of x. Results are written at ε = 1.

It cannot be unstable: one mode decays at the rate mu.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: -Omega + 2*omega, -Omega + omega.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; NIST DLMF, section 28.6
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._evolution import Linear, evolution_at
from .._initial import initial_at
from .._motion import Motion, response_at
from .._runtime import (
    checked,
    checked_amplitudes,
    evaluate,
    evaluate_array,
    evaluate_pair,
    multiply_out,
    no_edges,
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
RELATIONS: tuple[str, ...] = ()

#: the highest power of ε
ORDER = 4

#: the coordinates, in the order of amplitudes
COORDINATES = ("x",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "omega": ("positive", "rad/s", "natural frequency"),
    "Omega": ("positive", "rad/s", "frequency of the modulation"),
    "q": ("nonnegative", "rad^2/s^2", "half the modulation of the stiffness"),
    "mu": ("nonnegative", "1/s", "rate at which free oscillations decay"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x",)


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    1,
    (
        ((0, 0),),
    ),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    1,
    (
        (0, 0, (1, 0, 0), (0,)), (1, 0, (1, 0, 0), (-1,)), (1, 0, (1, 0, 0), (1,)),
        (2, 0, (1, 0, 0), (-2,)), (2, 0, (1, 0, 0), (2,)), (3, 0, (1, 0, 0), (-3,)),
        (3, 0, (1, 0, 0), (-1,)), (3, 0, (1, 0, 0), (1,)), (3, 0, (1, 0, 0), (3,)),
        (4, 0, (1, 0, 0), (-4,)), (4, 0, (1, 0, 0), (-2,)), (4, 0, (1, 0, 0), (2,)),
        (4, 0, (1, 0, 0), (4,)),
    ),
    1,
)


def _growth_rate(omega, Omega, q, mu):
    decay_1 = -mu
    return decay_1


def _slow_flow_matrix(out, omega, Omega, q, mu):
    # Intermediates
    x0 = 1 / omega
    x1 = omega * omega
    x2 = omega * x1
    x3 = 1 / x2
    x4 = Omega + 2 * omega
    x5 = 2 * omega - Omega
    x6 = mu * mu
    x7 = q * q
    x8 = Omega * Omega
    x9 = x6 * x6
    x10 = x4 * x4
    x11 = x5 * x5
    x12 = x10 * x4
    x13 = x11 * x5
    x14 = x7 * x7
    x15 = x1 * x1
    x16 = x8 * x8
    # Outputs
    out[..., 0, 0].real = -mu
    out[..., 0, 0].imag = (
        x14 * x3 * (35 / 4 * x1 * x8 - 15 * x15 - 1 / 2 * x16) / (x12 * x13 * (omega - Omega)
        * (Omega + omega)) + x3 * x6 * x7 * (1 / 2 * x8 - 6 * x1) / (x10 * x11) - 1 / 2 * x0 * x6
        - x0 * x7 / (x4 * x5) - 1 / 8 * x3 * x9
    )


def _characteristic_coefficients(out, omega, Omega, q, mu):
    # Intermediates
    x0 = 1 / omega
    x1 = omega * omega
    x2 = omega * x1
    x3 = 1 / x2
    x4 = Omega + 2 * omega
    x5 = 2 * omega - Omega
    x6 = mu * mu
    x7 = q * q
    x8 = Omega * Omega
    x9 = x6 * x6
    x10 = x4 * x4
    x11 = x5 * x5
    x12 = x10 * x4
    x13 = x11 * x5
    x14 = x7 * x7
    x15 = x8 * x8
    x16 = x1 * x1
    # Outputs
    c1_0 = (
        mu + 1j * (1 / 2 * x0 * x6 + x0 * x7 / (x4 * x5) + 1 / 8 * x3 * x9 + x14 * x3 * (1 / 2 * x15
        + 15 * x16 - 35 / 4 * x1 * x8) / (x12 * x13 * (omega - Omega) * (Omega + omega)) + x3 * x6
        * x7 * (6 * x1 - 1 / 2 * x8) / (x10 * x11))
    )
    multiply_out(out, ((c1_0,), 1))


def _slow_flow(out, A_x, omega, Omega, q, mu):
    # Intermediates
    x0 = Omega + omega
    x1 = omega - Omega
    x2 = mu * mu
    x3 = omega * omega
    x4 = x3 * x3
    x5 = x3 * x4
    x6 = x2 * x5
    x7 = Omega * Omega
    x8 = x7 * x7
    x9 = x4 * x8
    x10 = omega * x3
    x11 = Omega + 2 * omega
    x12 = x11 * x11
    x13 = x11 * x12
    x14 = 2 * omega - Omega
    x15 = x14 * x14
    x16 = x14 * x15
    x17 = q * q
    x18 = x17 * x17
    x19 = x8 * x8
    x20 = x2 * x2
    x21 = x4 * x4
    x22 = x7 * x8
    x23 = x21 * x3
    # Outputs
    out[..., 0] = (
        A_x * (1j * (1 / 2 * x17 * x2 * x22 + 32 * x17 * x2 * x4 * x7 + x17 * x22 * x3
        + 24 * x17 * x5 * x7 + 35 / 4 * x18 * x3 * x7 + 56 * x2 * x21 * x7 + 13 / 2 * x2 * x22 * x4
        + 13 / 8 * x20 * x22 * x3 + 14 * x20 * x5 * x7 - 17 / 2 * x17 * x2 * x3 * x8
        - 16 * x17 * x21 - 24 * x17 * x6 - 9 * x17 * x9 - 15 * x18 * x4 - 1 / 2 * x18 * x8
        - 1 / 2 * x19 * x2 * x3 - 1 / 8 * x19 * x20 - 32 * x2 * x23 - 8 * x20 * x21
        - 15 / 2 * x20 * x9 - 30 * x6 * x8) - mu * x0 * x1 * x10 * x13 * x16) / (x0 * x1 * x10 * x13
        * x16)
    )


def _motion(out, omega, Omega, q, mu):
    # Intermediates
    x0 = -2 * omega
    x1 = -Omega - x0
    x2 = 1 / x1
    x3 = q * x2
    x4 = 2 / Omega
    x5 = 2 * omega
    x6 = Omega + x5
    x7 = 1 / x6
    x8 = q * x7
    x9 = -omega
    x10 = -Omega - x9
    x11 = 1 / x10
    x12 = x11 * x2
    x13 = q * q
    x14 = Omega * Omega
    x15 = 1 / 2 * x13 / x14
    x16 = Omega + omega
    x17 = 1 / x16
    x18 = x17 * x7
    x19 = 3 * Omega
    x20 = 1 / (-x0 - x19)
    x21 = x12 * x20
    x22 = Omega * x14
    x23 = 1 / x22
    x24 = q * x13
    x25 = x23 * x24 / 6
    x26 = 8 * x13
    x27 = x22 * x26
    x28 = mu * mu
    x29 = 4 * x28
    x30 = x14 * x14
    x31 = Omega * x30
    x32 = x29 * x31
    x33 = 16 * x28
    x34 = omega * omega
    x35 = x22 * x33 * x34
    x36 = Omega * x26 * x34
    x37 = omega * x34
    x38 = x13 * x37
    x39 = omega * x13
    x40 = x14 * x33 * x37 + 15 * x14 * x39 + 4 * x38 - omega * x29 * x30
    x41 = 1 / omega
    x42 = x1 * x1
    x43 = x1 * x42
    x44 = x41 / x43
    x45 = 1 / 2 * x23
    x46 = x6 * x6
    x47 = x46 * x6
    x48 = x41 / x47
    x49 = 1 / (x19 + x5)
    x50 = x18 * x49
    x51 = 2 * Omega
    x52 = 1 / x30
    x53 = x13 * x13
    x54 = x52 * x53 / 48
    x55 = 216 * x22 * x28 * x37
    x56 = 148 * x22 * x39
    x57 = 56 * Omega * x38
    x58 = 54 * omega * x28 * x31
    x59 = x34 * x34
    x60 = x14 * x30
    x61 = (
        128 * x13 * x14 * x34 + 54 * x13 * x30 + 16 * x13 * x59 + 96 * x14 * x28 * x59
        + 84 * x28 * x30 * x34 - 27 * x28 * x60
    )
    x62 = x13 * x52 / 12
    x63 = x10 * x10
    x64 = x16 * x16
    # Outputs
    out[..., 0] = 2
    out[..., 1] = x3 * x4
    out[..., 2] = -x4 * x8
    out[..., 3] = x12 * x15
    out[..., 4] = x15 * x18
    out[..., 5] = x21 * x25
    out[..., 6] = x11 * x44 * x45 * x8 * (x32 + x40 - x27 - x35 - x36)
    out[..., 7] = -x17 * x3 * x45 * x48 * (x27 + x35 + x36 + x40 - x32)
    out[..., 8] = -x25 * x50
    out[..., 9] = x21 * x54 / (-x51 - x9)
    out[..., 10] = x20 * x44 * x62 * x7 * (x58 + x61 - x55 - x56 - x57) / x63
    out[..., 11] = x2 * x48 * x49 * x62 * (x55 + x56 + x57 + x61 - x58) / x64
    out[..., 12] = x50 * x54 / (omega + x51)
    out[..., 13] = omega
    out[..., 14] = Omega


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, omega: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    A mode that is not coupled decays at the rate of its damping.

    Parameters
    ----------
    omega : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, omega=omega, Omega=Omega, q=q, mu=mu)
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("omega", "Omega", "q", "mu") if gradient else (),
    )


def boundaries(
    *, omega: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable interval of a detuning.

    This case cannot be unstable for any detuning: NaN everywhere.

    Parameters
    ----------
    omega : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, omega=omega, Omega=Omega, q=q, mu=mu)
    return boundaries_at(
        evaluate_pair,
        no_edges,
        arguments,
        ("omega", "Omega", "q", "mu") if gradient else (),
    )


def critical_speeds(*, omega: ArrayLike, q: ArrayLike, mu: ArrayLike) -> tuple[Any, Any]:
    """Both edges of the unstable zone in the detuned frequency: there is none.

    Without a resonance relation no frequency is detuned: NaN everywhere.

    Parameters
    ----------
    omega : array_like
        Natural frequency, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    lower, upper : float64
        NaN, float64, in the shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega=omega, q=q, mu=mu)
    return evaluate_pair(no_edges, arguments)


def slow_flow_matrix(
    *, omega: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    omega : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 1, 1), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega=omega, Omega=Omega, q=q, mu=mu)
    return evaluate_array(_slow_flow_matrix, arguments, (1, 1))


def characteristic_coefficients(
    *, omega: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    omega : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 2), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega=omega, Omega=Omega, q=q, mu=mu)
    return evaluate_array(_characteristic_coefficients, arguments, (2,))


def slow_flow(
    amplitudes: ArrayLike, /, *, omega: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    omega : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega=omega, Omega=Omega, q=q, mu=mu)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, omega: ArrayLike, Omega: ArrayLike, q: ArrayLike,
    mu: ArrayLike,
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
        Those at t = 0, shape (..., 1), in the order of COORDINATES.
    omega : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega=omega, Omega=Omega, q=q, mu=mu)
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, omega: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> Beating:
    """How amplitudes beat: period and largest modulus, from those at t = 0.

    Closed forms where no mode decays: the sum of the moduli of the parts in each eigenvalue, which
    is the least upper bound of |B_j| unless three or more frequencies are commensurable. Else a
    maximum that is searched for in time.

    Parameters
    ----------
    amplitudes : array_like
        Those at t = 0, shape (..., 1), in the order of COORDINATES.
    omega : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    Beating
        period (s), largest, margin, each of shape (..., 1). The period is NaN unless exactly two
        frequencies take part; largest is infinite where the amplitude grows without bound; margin
        is how much too small it may be, 0 for closed forms.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega=omega, Omega=Omega, q=q, mu=mu)
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, omega: ArrayLike, Omega: ArrayLike, q: ArrayLike,
    mu: ArrayLike, order: int | None = None, gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. NaN where a harmonic resonates itself. Derivatives
    are taken with these fixed. Over times of order 1/ε the error is O(ε^4). A UserWarning says how
    much is left out where that is more than a tenth of the motion, estimated from the harmonics of
    each order beside those of order zero.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    omega : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 4; all by default.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 1), in the order x; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega=omega, Omega=Omega, q=q, mu=mu)
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=("omega", "Omega", "q", "mu") if gradient else (),
    )


def initial_amplitudes(
    q_: ArrayLike, v: ArrayLike, /, *, omega: ArrayLike, Omega: ArrayLike, q: ArrayLike,
    mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at t = 0 of the motion with given coordinates and velocities there.

    The solution of response(0, amplitudes) = q, and of its derivative along slow_flow = v, that
    goes over into that of order zero as the small parameters go to zero.

    Parameters
    ----------
    q_ : array_like
        Coordinates at t = 0, shape (..., 1), in the order of COORDINATES.
    v : array_like
        Velocities at t = 0, shape (..., 1), per second.
    omega : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128; NaN where there is none near that of order zero, as far outside
        of the scaling, or where a harmonic resonates itself.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega=omega, Omega=Omega, q=q, mu=mu)
    return initial_at(_MOTION, _motion, arguments, q_, v, (_slow_flow, 4, False))
