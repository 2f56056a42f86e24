# Emitted by mmsgen 0.1.0 from derivations/mathieu.py: change that, not this file.
# Made from sha256 9bef71e02237d29c981b9f9a21f1b66da6926f4fb244148ff5b9fd37b52db4dc
# Operations for each point: growth_rate 101, boundaries 84, resonance 0, slow_flow_matrix 40,
# characteristic_coefficients 101, slow_flow 46, motion 66
"""mathieu: omega = Omega + sigma, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of x. Results are written at ε = 1.

Stability depends: a factor of degree 2 in Gamma is damped, and unstable near resonance if
-16*(2*Omega**3*mu - q**2)*(2*Omega**3*mu + q**2)/Omega**6 > 0.

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
RELATIONS: tuple[str, ...] = ("omega = Omega + sigma",)

#: the highest power of ε
ORDER = 4

#: the coordinates, in the order of amplitudes
COORDINATES = ("x",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, omega = Omega + sigma"),
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
        (2, 0, (1, 0, 0), (-1,)), (2, 0, (1, 0, 0), (1,)), (2, 0, (1, 0, 0), (2,)),
        (3, 0, (1, 0, 0), (-3,)), (3, 0, (1, 0, 0), (-1,)), (3, 0, (1, 0, 0), (1,)),
        (3, 0, (1, 0, 0), (2,)), (3, 0, (1, 0, 0), (3,)), (4, 0, (1, 0, 0), (-4,)),
        (4, 0, (1, 0, 0), (-3,)), (4, 0, (1, 0, 0), (-1,)), (4, 0, (1, 0, 0), (1,)),
        (4, 0, (1, 0, 0), (2,)), (4, 0, (1, 0, 0), (3,)), (4, 0, (1, 0, 0), (4,)),
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
    x5 = x0 * x1
    x6 = 1 / x5
    x7 = mu * mu
    x8 = sigma * x7
    x9 = q * q
    x10 = x9 * x9
    x11 = x10 / x2
    x12 = Omega * x1
    x13 = x9 / x12
    x14 = x9 / x1
    x15 = sigma * sigma
    x16 = x10 * x9
    x17 = sigma * x15
    x18 = x7 * x7
    x19 = x10 * x10
    x20 = x2 * x5
    x21 = x1 * x2
    x22 = Omega * x2
    x23 = Omega * x0
    x24 = x1 * x23
    x25 = x2 * x23
    x26 = x15 * x15
    # Outputs
    b_1 = 2 * mu
    c_1 = (
        35 * sigma * x10 / (72 * x24) + 283 * sigma * x16 / (1944 * x25)
        + 4309 * x10 * x26 * x4 / 729 + 16 * x11 * x15 / 27 + 22 * x14 * x15 / 9 + x14 * x7 / 3
        + 85 * x15 * x6 * x7 * x9 / 27 + x15 + 7 * x16 * x4 / 648 + 1921 * x19 / (186624 * x20) + x7
        + 1 / 4 * x18 / x0 - 2 * sigma * x9 / (3 * x23) - 898 * x10 * x17 / (243 * x22)
        - 5 * x10 * x6 / 36 - 65 * x11 * x7 / 432 - 170 * x13 * x17 / 27 - 11 * x13 * x8 / 9
        - 2933 * x15 * x16 / (5832 * x21) - x8 / Omega
    )
    return quadratic_growth(b_1, c_1)


def _boundaries(Omega, q, mu):
    # Intermediates
    x0 = mu * mu
    x1 = 4 * x0
    x2 = Omega * Omega
    x3 = x2 * x2
    x4 = x3 * x3
    x5 = x2 * x4
    x6 = 1 / x5
    x7 = x2 * x3
    x8 = 1 / x7
    x9 = 1 / x4
    x10 = q * q
    x11 = x10 / x3
    x12 = x10 * x10
    x13 = x10 * x12
    x14 = x0 * x0
    x15 = x12 * x12
    x16 = x4 * x7
    x17 = Omega * x3
    x18 = x10 / x17
    x19 = Omega * x2
    x20 = x19 * x4
    x21 = x19 * x3
    x22 = x3 * x4
    x23 = Omega * x4
    # Outputs
    p0 = (
        65 * x0 * x12 * x9 / 108 + 5 * x12 * x8 / 9 - 4 * x0 * x11 / 3 - x1 - 7 * x13 * x6 / 162
        - x14 / x2 - 1921 * x15 / (46656 * x16)
    )
    p1 = (
        44 * x0 * x18 / 9 + 8 * x10 / (3 * x19) + x1 / Omega - 35 * x12 / (18 * x21)
        - 283 * x13 / (486 * x20)
    )
    p2 = (
        2933 * x13 / (1458 * x22) - 340 * x0 * x10 * x8 / 27 - 88 * x11 / 9 - 64 * x12 * x9 / 27 - 4
    )
    p3 = 3592 * x12 / (243 * x23) + 680 * x18 / 27
    p4 = -17236 * x12 * x6 / 729
    reach = 1 / 2 * Omega
    return zone((p0, p1, p2, p3, p4), reach=reach)


def _resonance(Omega, q, mu):
    return Omega, Omega, q, mu


def _slow_flow_matrix(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = -mu
    x1 = Omega * Omega
    x2 = x1 * x1
    x3 = Omega * x1
    x4 = x2 * x3
    x5 = 1 / x4
    x6 = q * q
    x7 = x6 / x3
    x8 = 1 / x2
    x9 = sigma * sigma
    x10 = Omega * x2
    x11 = x6 * x9 / x10
    x12 = x6 * x6
    x13 = mu * mu
    x14 = (
        11 * sigma * x6 * x8 / 9 + sigma + 65 * x12 * x5 / 432 - 85 * x11 / 27 - x7 / 3
        - 1 / 2 * x13 / Omega
    )
    x15 = 2 * x11 + 1 / 2 * x7 - sigma * x6 * x8 - x12 * x5 / 9
    # Outputs
    out[..., 0, 0].real = x0
    out[..., 0, 0].imag = x14
    out[..., 0, 1].imag = -x15
    out[..., 1, 0].imag = x15
    out[..., 1, 1].real = x0
    out[..., 1, 1].imag = -x14


def _characteristic_coefficients(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = x0 * x0
    x2 = x1 * x1
    x3 = x0 * x2
    x4 = 1 / x3
    x5 = x0 * x1
    x6 = 1 / x5
    x7 = mu * mu
    x8 = sigma * x7
    x9 = q * q
    x10 = x9 * x9
    x11 = x10 / x2
    x12 = Omega * x1
    x13 = x9 / x12
    x14 = x9 / x1
    x15 = sigma * sigma
    x16 = x10 * x9
    x17 = sigma * x15
    x18 = x7 * x7
    x19 = x10 * x10
    x20 = x2 * x5
    x21 = x1 * x2
    x22 = Omega * x2
    x23 = Omega * x0
    x24 = x1 * x23
    x25 = x2 * x23
    x26 = x15 * x15
    # Outputs
    c1_1 = 2 * mu
    c1_0 = (
        35 * sigma * x10 / (72 * x24) + 283 * sigma * x16 / (1944 * x25)
        + 4309 * x10 * x26 * x4 / 729 + 16 * x11 * x15 / 27 + 22 * x14 * x15 / 9 + x14 * x7 / 3
        + 85 * x15 * x6 * x7 * x9 / 27 + x15 + 7 * x16 * x4 / 648 + 1921 * x19 / (186624 * x20) + x7
        + 1 / 4 * x18 / x0 - 2 * sigma * x9 / (3 * x23) - 898 * x10 * x17 / (243 * x22)
        - 5 * x10 * x6 / 36 - 65 * x11 * x7 / 432 - 170 * x13 * x17 / 27 - 11 * x13 * x8 / 9
        - 2933 * x15 * x16 / (5832 * x21) - x8 / Omega
    )
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_x, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = x0 * x0
    x2 = Omega * x0
    x3 = x1 * x2
    x4 = 1 / x3
    x5 = sigma * x2
    x6 = sigma * sigma
    x7 = x0 * x6
    x8 = q * q
    x9 = x8 * x8
    x10 = mu * mu
    x11 = x0 * x1
    # Outputs
    out[..., 0] = (
        A_x * x4 * (1j * (sigma * x3 + 11 * x5 * x8 / 9 + 65 * x9 / 432 - x1 * x8 / 3
        - 1 / 2 * x10 * x11 - 85 * x7 * x8 / 27) - mu * x3)
        - 1j * x4 * x8 * (9 * x1 + 36 * x7 - 18 * x5 - 2 * x8) * np.conj(A_x) / 18
    )


def _motion(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = q / x0
    x2 = q * sigma
    x3 = Omega * x0
    x4 = x2 / x3
    x5 = x0 * x0
    x6 = 1 / x5
    x7 = q * q
    x8 = x0 * x5
    x9 = 1 / x8
    x10 = q * x7
    x11 = x10 * x9
    x12 = sigma * sigma
    x13 = x0 * x12
    x14 = Omega * x5
    x15 = x5 * x5
    x16 = 1 / x15
    x17 = x7 * x7
    x18 = x16 * x17
    x19 = x3 * x5
    x20 = 1 / x19
    x21 = sigma * x10 * x20
    x22 = x2 * x20
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2 * x1
    out[..., 2] = -2 * x1 / 3
    out[..., 3] = -4 * x4
    out[..., 4] = 4 * x4 / 9
    out[..., 5] = x6 * x7 / 12
    out[..., 6] = -4 * x11 / 9
    out[..., 7] = 8 * q * x12 * x6
    out[..., 8] = -q * x9 * (32 * x13 + 35 * x7) / 108
    out[..., 9] = -7 * sigma * x7 / (72 * x14)
    out[..., 10] = -x11 / 180
    out[..., 11] = 25 * x18 / 288
    out[..., 12] = 8 * x21 / 27
    out[..., 13] = -4 * x22 * (12 * x13 + x7) / 3
    out[..., 14] = x22 * (128 * x13 + 897 * x7) / 648
    out[..., 15] = x16 * x7 * (185 * x13 + 134 * x7) / 2160
    out[..., 16] = 47 * x21 / 5400
    out[..., 17] = x18 / 4320
    out[..., 18] = Omega
    out[..., 19] = Omega


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    The larger real part of the roots of Γ² + bΓ + c, each of them found without cancellation.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega = Omega + sigma, rad/s, real.
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
    none that begins farther from it than Omega/2, half of the frequencies that resonate;
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

    Where omega = Omega + sigma lies on an edge of `boundaries`.

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
        Detuning, omega = Omega + sigma, rad/s, real.
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
        Detuning, omega = Omega + sigma, rad/s, real.
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
        Detuning, omega = Omega + sigma, rad/s, real.
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
        Detuning, omega = Omega + sigma, rad/s, real.
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
        Detuning, omega = Omega + sigma, rad/s, real.
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
        Detuning, omega = Omega + sigma, rad/s, real.
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
        Detuning, omega = Omega + sigma, rad/s, real.
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
