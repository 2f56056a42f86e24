# Emitted by mmsgen 0.1.0 from derivations/mathieu.py: change that, not this file.
# Made from sha256 576283e9374883e4fa7b3b9d75925befe2626c06f673b33cc3c4a9e20a0e4f11
# Operations for each point: growth_rate 78, boundaries 63, resonance 1, slow_flow_matrix 35,
# characteristic_coefficients 78, slow_flow 39, motion 72
"""mathieu: omega = 3/2*Omega + sigma, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of x. Results are written at ε = 1.

Stability depends: a factor of degree 2 in Gamma is damped, and unstable near resonance if
-4*(12*Omega**5*mu - q**3)*(12*Omega**5*mu + q**3)/(9*Omega**10) > 0.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; NIST DLMF, section 28.6
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._edges import explicit_edges, zone
from .._evolution import Linear, evolution_at
from .._growth import quadratic_growth
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
RELATIONS: tuple[str, ...] = ("omega = 3/2*Omega + sigma",)

#: the highest power of ε
ORDER = 4

#: the coordinates, in the order of amplitudes
COORDINATES = ("x",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, omega = 3*Omega/2 + sigma"),
    "Omega": ("positive", "rad/s", "frequency of the modulation"),
    "q": ("nonnegative", "rad^2/s^2", "half the modulation of the stiffness"),
    "mu": ("nonnegative", "1/s", "rate at which free oscillations decay"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x", "conj(A_x)")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    1,
    (
        ((0, 0), (0, 1)),
    ),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    1,
    (
        (0, 0, (1, 0, 0), (0,)), (1, 0, (1, 0, 0), (-1,)), (1, 0, (1, 0, 0), (1,)),
        (2, 0, (1, 0, 0), (-2,)), (2, 0, (1, 0, 0), (-1,)), (2, 0, (1, 0, 0), (1,)),
        (2, 0, (1, 0, 0), (2,)), (3, 0, (1, 0, 0), (-2,)), (3, 0, (1, 0, 0), (-1,)),
        (3, 0, (1, 0, 0), (1,)), (3, 0, (1, 0, 0), (2,)), (3, 0, (1, 0, 0), (3,)),
        (4, 0, (1, 0, 0), (-4,)), (4, 0, (1, 0, 0), (-2,)), (4, 0, (1, 0, 0), (-1,)),
        (4, 0, (1, 0, 0), (1,)), (4, 0, (1, 0, 0), (2,)), (4, 0, (1, 0, 0), (3,)),
        (4, 0, (1, 0, 0), (4,)),
    ),
    1,
)


def _growth_rate(sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = x0 * x0
    x2 = x1 * x1
    x3 = x0 * x2
    x4 = 1 / x3
    x5 = sigma * sigma
    x6 = q * q
    x7 = x6 * x6
    x8 = x6 * x7
    x9 = sigma * x5
    x10 = mu * mu
    x11 = x0 * x1
    x12 = x7 * x7
    x13 = x11 * x2
    x14 = x1 * x2
    x15 = Omega * x2
    x16 = Omega * x0
    x17 = x1 * x16
    x18 = Omega * x1
    x19 = x16 * x2
    x20 = x5 * x5
    # Outputs
    b_1 = 2 * mu
    c_1 = (
        10009 * sigma * x8 / (311040 * x19) + x10 + 51529 * x12 / (74649600 * x13)
        + 13225 * x20 * x4 * x7 / 186624 + x5 + 133 * x5 * x7 / (1728 * x2) + x7 / (144 * x11)
        + 13 * x5 * x6 / (36 * x1) - 119 * sigma * x7 / (1440 * x17) - sigma * x6 / (6 * x16)
        - 133 * x4 * x8 / 51840 - 115 * x6 * x9 / (216 * x18) - 1495 * x7 * x9 / (15552 * x15)
        - 18107 * x5 * x8 / (373248 * x14)
    )
    return quadratic_growth(b_1, c_1)


def _boundaries(Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = x0 * x0
    x2 = x1 * x1
    x3 = x0 * x2
    x4 = 1 / x3
    x5 = q * q
    x6 = x5 * x5
    x7 = x5 * x6
    x8 = mu * mu
    x9 = x6 * x6
    x10 = x0 * x1
    x11 = x10 * x2
    x12 = Omega * x0
    x13 = x12 * x2
    x14 = x1 * x12
    x15 = x1 * x2
    x16 = Omega * x1
    x17 = Omega * x2
    # Outputs
    p0 = 133 * x4 * x7 / 12960 - 4 * x8 - 51529 * x9 / (18662400 * x11) - x6 / (36 * x10)
    p1 = 119 * x6 / (360 * x14) + 2 * x5 / (3 * x12) - 10009 * x7 / (77760 * x13)
    p2 = 18107 * x7 / (93312 * x15) - 4 - 133 * x6 / (432 * x2) - 13 * x5 / (9 * x1)
    p3 = 1495 * x6 / (3888 * x17) + 115 * x5 / (54 * x16)
    p4 = -13225 * x4 * x6 / 46656
    reach = 3 / 4 * Omega
    return zone((p0, p1, p2, p3, p4), reach=reach)


def _resonance(Omega, q, mu):
    centre = 3 / 2 * Omega
    return centre, Omega, q, mu


def _slow_flow_matrix(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = -mu
    x1 = Omega * Omega
    x2 = x1 * x1
    x3 = Omega * x2
    x4 = 1 / x3
    x5 = q * q
    x6 = Omega * x1
    x7 = x5 * x5
    x8 = x2 * x6
    x9 = sigma * sigma
    x10 = (
        115 * x4 * x5 * x9 / 432 + x5 / (12 * x6) + 227 * x7 / (8640 * x8) - sigma
        - 13 * sigma * x5 / (72 * x2)
    )
    x11 = q * x5
    x12 = x1 * x2
    x13 = x11 * x4 / 12 - 1 / 4 * sigma * x11 / x12
    # Outputs
    out[..., 0, 0].real = x0
    out[..., 0, 0].imag = -x10
    out[..., 0, 1].imag = -x13
    out[..., 1, 0].imag = x13
    out[..., 1, 1].real = x0
    out[..., 1, 1].imag = x10


def _characteristic_coefficients(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = x0 * x0
    x2 = x1 * x1
    x3 = x0 * x2
    x4 = 1 / x3
    x5 = sigma * sigma
    x6 = q * q
    x7 = x6 * x6
    x8 = x6 * x7
    x9 = sigma * x5
    x10 = mu * mu
    x11 = x0 * x1
    x12 = x7 * x7
    x13 = x11 * x2
    x14 = x1 * x2
    x15 = Omega * x2
    x16 = Omega * x0
    x17 = x1 * x16
    x18 = Omega * x1
    x19 = x16 * x2
    x20 = x5 * x5
    # Outputs
    c1_1 = 2 * mu
    c1_0 = (
        10009 * sigma * x8 / (311040 * x19) + x10 + 51529 * x12 / (74649600 * x13)
        + 13225 * x20 * x4 * x7 / 186624 + x5 + 133 * x5 * x7 / (1728 * x2) + x7 / (144 * x11)
        + 13 * x5 * x6 / (36 * x1) - 119 * sigma * x7 / (1440 * x17) - sigma * x6 / (6 * x16)
        - 133 * x4 * x8 / 51840 - 115 * x6 * x9 / (216 * x18) - 1495 * x7 * x9 / (15552 * x15)
        - 18107 * x5 * x8 / (373248 * x14)
    )
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_x, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = x0 * x0
    x2 = Omega * x0
    x3 = x1 * x2
    x4 = q * q
    x5 = x4 * x4
    x6 = sigma * sigma
    x7 = q * x4
    x8 = x0 * x1
    # Outputs
    out[..., 0] = (
        A_x * (1j * (13 * sigma * x2 * x4 / 72 + sigma * x3 - 115 * x0 * x4 * x6 / 432
        - x1 * x4 / 12 - 227 * x5 / 8640) - mu * x3) / x3
        - 1j * x7 * (Omega - 3 * sigma) * np.conj(A_x) / (12 * x8)
    )


def _motion(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = q / x0
    x2 = q * q
    x3 = x0 * x0
    x4 = x2 / x3
    x5 = q * sigma
    x6 = Omega * x0
    x7 = x5 / x6
    x8 = Omega * x3
    x9 = sigma * x2 / x8
    x10 = sigma * sigma
    x11 = x0 * x10
    x12 = x0 * x3
    x13 = 1 / x12
    x14 = q * x13
    x15 = q * x2
    x16 = x3 * x3
    x17 = 1 / x16
    x18 = x2 * x2
    x19 = x17 * x18
    x20 = x17 * x2
    x21 = x3 * x6
    x22 = 1 / x21
    x23 = x22 * x5
    # Outputs
    out[..., 0] = 2
    out[..., 1] = x1
    out[..., 2] = -1 / 2 * x1
    out[..., 3] = 1 / 2 * x4
    out[..., 4] = -x7
    out[..., 5] = 1 / 4 * x7
    out[..., 6] = x4 / 20
    out[..., 7] = -3 / 2 * x9
    out[..., 8] = x14 * (24 * x11 + 5 * x2) / 24
    out[..., 9] = -x14 * (60 * x11 + 31 * x2) / 480
    out[..., 10] = -9 * x9 / 200
    out[..., 11] = -x13 * x15 / 360
    out[..., 12] = -5 * x19 / 96
    out[..., 13] = x20 * (42 * x11 + x2) / 12
    out[..., 14] = -x23 * (144 * x11 + 131 * x2) / 144
    out[..., 15] = x23 * (900 * x11 + 2327 * x2) / 14400
    out[..., 16] = x20 * (2196 * x11 + 695 * x2) / 72000
    out[..., 17] = 37 * sigma * x15 * x22 / 10800
    out[..., 18] = x19 / 10080
    out[..., 19] = 3 / 2 * Omega
    out[..., 20] = Omega


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    The larger real part of the roots of Γ² + bΓ + c, each of them found without cancellation.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega = 3*Omega/2 + sigma, rad/s, real.
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
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("sigma", "Omega", "q", "mu") if gradient else (),
    )


def boundaries(*, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike, gradient: bool = False) -> Any:
    """Both edges of the unstable interval of sigma.

    The interval of sigma in which growth_rate is positive: where one of the polynomials with the
    coefficients in `_boundaries` (lowest power first) is. Infinite where the interval has no end.
    Order 4 leaves out terms of the edges from ε^5 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero, and
    none that begins farther from it than 3*Omega/4, half of the frequencies that resonate;
    SlowFlow.zones() gives all of them.

    Parameters
    ----------
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
    arguments = checked(PARAMETERS, Omega=Omega, q=q, mu=mu)
    return boundaries_at(
        evaluate_pair,
        _boundaries,
        arguments,
        ("Omega", "q", "mu") if gradient else (),
    )


def critical_speeds(
    *, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable zone in omega.

    Where omega = 3/2*Omega + sigma lies on an edge of `boundaries`.

    Parameters
    ----------
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
        In rad/s, float64, in the shape to which the arguments broadcast; NaN where there is no such
        edge. With gradient this pair and name -> pair.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, Omega=Omega, q=q, mu=mu)
    return explicit_edges(
        _resonance,
        _boundaries,
        1,
        arguments,
        ("Omega", "q", "mu") if gradient else (),
    )


def slow_flow_matrix(
    *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega = 3*Omega/2 + sigma, rad/s, real.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 2, 2), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return evaluate_array(_slow_flow_matrix, arguments, (2, 2))


def characteristic_coefficients(
    *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega = 3*Omega/2 + sigma, rad/s, real.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 3), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return evaluate_array(_characteristic_coefficients, arguments, (3,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, omega = 3*Omega/2 + sigma, rad/s, real.
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
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike,
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
    sigma : array_like
        Detuning, omega = 3*Omega/2 + sigma, rad/s, real.
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
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> Beating:
    """How amplitudes beat: period and largest modulus, from those at t = 0.

    Closed forms where no mode decays: the sum of the moduli of the parts in each eigenvalue, which
    is the least upper bound of |B_j| unless three or more frequencies are commensurable. Else a
    maximum that is searched for in time.

    Parameters
    ----------
    amplitudes : array_like
        Those at t = 0, shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, omega = 3*Omega/2 + sigma, rad/s, real.
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
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike,
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
    sigma : array_like
        Detuning, omega = 3*Omega/2 + sigma, rad/s, real.
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
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=("sigma", "Omega", "q", "mu") if gradient else (),
    )


def initial_amplitudes(
    q_: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike,
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
    sigma : array_like
        Detuning, omega = 3*Omega/2 + sigma, rad/s, real.
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
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return initial_at(_MOTION, _motion, arguments, q_, v, (_slow_flow, 4, False))
