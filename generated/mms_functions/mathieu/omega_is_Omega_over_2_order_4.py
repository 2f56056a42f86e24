# Emitted by mmsgen 0.1.0 from derivations/mathieu.py: change that, not this file.
# Made from sha256 a4ca2374006f8598a01f12ed69e977c20407f2e08366cea2a1f606e1b69e6adb
# Operations for each point: growth_rate 172, boundaries 157, resonance 1, slow_flow_matrix 55,
# characteristic_coefficients 172, slow_flow 60, motion 74
"""mathieu: omega = 1/2*Omega + sigma, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of x. Results are written at ε = 1.

Stability depends: Gamma**2 + 2*Gamma*mu + (Omega**2*mu**2 + Omega**2*sigma**2 - q**2)/Omega**2 is
damped, and unstable near resonance if -64*(Omega*mu - q)*(Omega*mu + q)/Omega**2 > 0.

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
RELATIONS: tuple[str, ...] = ("omega = 1/2*Omega + sigma",)

#: the highest power of ε
ORDER = 4

#: the coordinates, in the order of amplitudes
COORDINATES = ("x",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, omega = Omega/2 + sigma"),
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
        (0, 0, (1, 0, 0), (0,)), (1, 0, (1, 0, 0), (1,)), (2, 0, (1, 0, 0), (-2,)),
        (2, 0, (1, 0, 0), (1,)), (2, 0, (1, 0, 0), (2,)), (3, 0, (1, 0, 0), (-3,)),
        (3, 0, (1, 0, 0), (-2,)), (3, 0, (1, 0, 0), (1,)), (3, 0, (1, 0, 0), (2,)),
        (3, 0, (1, 0, 0), (3,)), (4, 0, (1, 0, 0), (-4,)), (4, 0, (1, 0, 0), (-3,)),
        (4, 0, (1, 0, 0), (-2,)), (4, 0, (1, 0, 0), (1,)), (4, 0, (1, 0, 0), (2,)),
        (4, 0, (1, 0, 0), (3,)), (4, 0, (1, 0, 0), (4,)),
    ),
    1,
)


def _growth_rate(sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = x0 * x0
    x2 = x0 * x1
    x3 = 1 / x2
    x4 = 1 / x0
    x5 = x1 * x1
    x6 = x0 * x5
    x7 = 1 / x6
    x8 = 1 / x1
    x9 = Omega * x0
    x10 = x1 * x9
    x11 = 1 / x10
    x12 = sigma * x11
    x13 = Omega * x1
    x14 = 1 / x13
    x15 = sigma * x14
    x16 = 1 / x9
    x17 = sigma * x16
    x18 = q * q
    x19 = 3 * x18
    x20 = mu * mu
    x21 = sigma * x20
    x22 = x18 * x18
    x23 = x18 * x22
    x24 = x1 * x5
    x25 = x23 / x24
    x26 = x22 * x7
    x27 = Omega * x5
    x28 = x22 / x27
    x29 = 1 / x5
    x30 = x22 * x29
    x31 = 7 * x18
    x32 = x20 * x20
    x33 = x18 * x32
    x34 = 16 * x32
    x35 = sigma * sigma
    x36 = sigma * x35
    x37 = x14 * x36
    x38 = x35 * x8
    x39 = x20 * x36
    x40 = x20 * x35
    x41 = x18 * x20
    x42 = x20 * x32
    x43 = x35 * x35
    x44 = x32 * x32
    x45 = x22 * x22
    x46 = x2 * x5
    x47 = x5 * x9
    # Outputs
    b_1 = 2 * mu
    c_1 = (
        233 * sigma * x23 / (6 * x47) + 58 * x11 * x18 * x39 + 21 * x12 * x33 + 20 * x15 * x41
        + x17 * x19 + 15 * x18 * x37 + 263 * x20 * x30 / 12 + x20 + 15 / 4 * x22 * x3
        + 71 * x26 * x32 / 3 + 589 * x26 * x40 / 6 + 225 / 4 * x26 * x43 + x3 * x34 * x43
        + 8 * x3 * x35 * x42 + x3 * x44 + 139 / 4 * x30 * x35 + 12 * x32 * x38 + x32 * x4 + x35
        + 4 * x4 * x40 + 2 * x42 * x8 + 18769 * x45 / (576 * x46) - 245 * x12 * x22 / 12
        - 4 * x15 * x42 - 8 * x16 * x39 - 6 * x17 * x32 - 41 * x18 * x3 * x40 - x18 * x4
        - x19 * x20 * x8 - 959 * x20 * x25 / 24 - 142 * x21 * x28 / 3 - 283 / 16 * x23 * x7
        - 1379 / 16 * x25 * x35 - 105 / 2 * x28 * x36 - x29 * x31 * x42 - 43 * x29 * x33 * x35
        - 60 * x29 * x41 * x43 - 10 * x3 * x33 - x31 * x38 - x34 * x37 - 2 * x21 / Omega
    )
    return quadratic_growth(b_1, c_1)


def _boundaries(Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = x0 * x0
    x2 = x1 * x1
    x3 = x0 * x2
    x4 = 1 / x3
    x5 = x0 * x1
    x6 = 1 / x5
    x7 = 1 / x1
    x8 = 1 / x0
    x9 = x1 * x2
    x10 = 1 / x9
    x11 = q * q
    x12 = x11 * x11
    x13 = x12 * x4
    x14 = 1 / x2
    x15 = x12 * x14
    x16 = mu * mu
    x17 = x11 * x12
    x18 = x16 * x16
    x19 = x16 * x18
    x20 = x18 * x18
    x21 = x12 * x12
    x22 = x2 * x5
    x23 = Omega * x0
    x24 = x1 * x23
    x25 = 1 / x24
    x26 = Omega * x1
    x27 = 1 / x26
    x28 = 1 / x23
    x29 = Omega * x2
    x30 = x12 / x29
    x31 = x11 * x27
    x32 = x2 * x23
    x33 = 64 * x18
    # Outputs
    p0 = (
        959 * x10 * x16 * x17 / 6 + 28 * x11 * x14 * x19 + 12 * x11 * x16 * x7 + 40 * x11 * x18 * x6
        + 4 * x11 * x8 + 283 / 4 * x17 * x4 - 15 * x12 * x6 - 284 * x13 * x18 / 3
        - 263 * x15 * x16 / 3 - 4 * x16 - 4 * x18 * x8 - 8 * x19 * x7 - 4 * x20 * x6
        - 18769 * x21 / (144 * x22)
    )
    p1 = (
        245 * x12 * x25 / 3 + 568 * x16 * x30 / 3 + 24 * x18 * x28 + 16 * x19 * x27
        + 8 * x16 / Omega - 84 * x11 * x18 * x25 - 12 * x11 * x28 - 80 * x16 * x31
        - 466 * x17 / (3 * x32)
    )
    p2 = (
        1379 / 4 * x10 * x17 + 172 * x11 * x14 * x18 + 164 * x11 * x16 * x6 + 28 * x11 * x7
        - 1178 * x13 * x16 / 3 - 139 * x15 - 16 * x16 * x8 - 48 * x18 * x7 - 32 * x19 * x6 - 4
    )
    p3 = 32 * x16 * x28 + x27 * x33 + 210 * x30 - 232 * x11 * x16 * x25 - 60 * x31
    p4 = 240 * x11 * x14 * x16 - 225 * x13 - x33 * x6
    reach = 1 / 4 * Omega
    return zone((p0, p1, p2, p3, p4), reach=reach)


def _resonance(Omega, q, mu):
    centre = 1 / 2 * Omega
    return centre, Omega, q, mu


def _slow_flow_matrix(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = -mu
    x1 = Omega * Omega
    x2 = Omega * x1
    x3 = 1 / x2
    x4 = 1 / Omega
    x5 = q * q
    x6 = 7 / 2 * x5
    x7 = x1 * x1
    x8 = Omega * x7
    x9 = 1 / x8
    x10 = mu * mu
    x11 = sigma * sigma
    x12 = x10 * x10
    x13 = x5 * x5
    x14 = x2 * x7
    x15 = (
        sigma + 2 * sigma * x10 / x1 + x10 * x6 * x9 + 15 / 2 * x11 * x5 * x9 + 3 / 2 * x3 * x5
        - sigma * x6 / x7 - 4 * x10 * x11 * x3 - x10 * x4 - x12 * x3 - 137 * x13 / (24 * x14)
    )
    x16 = q * x5
    x17 = 3 / 4 * x16
    x18 = x1 * x7
    x19 = sigma * x17 / x18 + x17 * x9 - q * x4
    # Outputs
    out[..., 0, 0].real = x0
    out[..., 0, 0].imag = x15
    out[..., 0, 1].imag = x19
    out[..., 1, 0].imag = -x19
    out[..., 1, 1].real = x0
    out[..., 1, 1].imag = -x15


def _characteristic_coefficients(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = x0 * x0
    x2 = x0 * x1
    x3 = 1 / x2
    x4 = 1 / x0
    x5 = x1 * x1
    x6 = x0 * x5
    x7 = 1 / x6
    x8 = 1 / x1
    x9 = Omega * x0
    x10 = x1 * x9
    x11 = 1 / x10
    x12 = sigma * x11
    x13 = Omega * x1
    x14 = 1 / x13
    x15 = sigma * x14
    x16 = 1 / x9
    x17 = sigma * x16
    x18 = q * q
    x19 = 3 * x18
    x20 = mu * mu
    x21 = sigma * x20
    x22 = x18 * x18
    x23 = x18 * x22
    x24 = x1 * x5
    x25 = x23 / x24
    x26 = x22 * x7
    x27 = Omega * x5
    x28 = x22 / x27
    x29 = 1 / x5
    x30 = x22 * x29
    x31 = 7 * x18
    x32 = x20 * x20
    x33 = x18 * x32
    x34 = 16 * x32
    x35 = sigma * sigma
    x36 = sigma * x35
    x37 = x14 * x36
    x38 = x35 * x8
    x39 = x20 * x36
    x40 = x20 * x35
    x41 = x18 * x20
    x42 = x20 * x32
    x43 = x35 * x35
    x44 = x32 * x32
    x45 = x22 * x22
    x46 = x2 * x5
    x47 = x5 * x9
    # Outputs
    c1_1 = 2 * mu
    c1_0 = (
        233 * sigma * x23 / (6 * x47) + 58 * x11 * x18 * x39 + 21 * x12 * x33 + 20 * x15 * x41
        + x17 * x19 + 15 * x18 * x37 + 263 * x20 * x30 / 12 + x20 + 15 / 4 * x22 * x3
        + 71 * x26 * x32 / 3 + 589 * x26 * x40 / 6 + 225 / 4 * x26 * x43 + x3 * x34 * x43
        + 8 * x3 * x35 * x42 + x3 * x44 + 139 / 4 * x30 * x35 + 12 * x32 * x38 + x32 * x4 + x35
        + 4 * x4 * x40 + 2 * x42 * x8 + 18769 * x45 / (576 * x46) - 245 * x12 * x22 / 12
        - 4 * x15 * x42 - 8 * x16 * x39 - 6 * x17 * x32 - 41 * x18 * x3 * x40 - x18 * x4
        - x19 * x20 * x8 - 959 * x20 * x25 / 24 - 142 * x21 * x28 / 3 - 283 / 16 * x23 * x7
        - 1379 / 16 * x25 * x35 - 105 / 2 * x28 * x36 - x29 * x31 * x42 - 43 * x29 * x33 * x35
        - 60 * x29 * x41 * x43 - 10 * x3 * x33 - x31 * x38 - x34 * x37 - 2 * x21 / Omega
    )
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_x, sigma, Omega, q, mu):
    # Intermediates
    x0 = q * q
    x1 = 3 * x0
    x2 = 7 / 2 * x0
    x3 = Omega * Omega
    x4 = x3 * x3
    x5 = x3 * x4
    x6 = Omega * x4
    x7 = Omega * x3
    x8 = x4 * x7
    x9 = mu * mu
    x10 = sigma * sigma
    x11 = x0 * x0
    x12 = x9 * x9
    # Outputs
    out[..., 0] = (
        A_x * (1j * (2 * sigma * x6 * x9 + sigma * x8 + 15 / 2 * x0 * x10 * x3 + 3 / 2 * x0 * x4
        + x2 * x3 * x9 - sigma * x2 * x7 - 4 * x10 * x4 * x9 - 137 * x11 / 24 - x12 * x4 - x5 * x9)
        - mu * x8) / x8 - 1 / 4 * 1j * q * (4 * x6 - Omega * x1 - sigma * x1) * np.conj(A_x) / x5
    )


def _motion(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = q * q
    x2 = x0 * x0
    x3 = x1 / x2
    x4 = q * sigma
    x5 = Omega * x0
    x6 = x0 * x2
    x7 = 1 / x6
    x8 = q * x1
    x9 = x7 * x8
    x10 = Omega * x2
    x11 = sigma * x1 / x10
    x12 = 12 * x0
    x13 = mu * mu
    x14 = sigma * sigma
    x15 = x2 * x2
    x16 = 1 / x15
    x17 = x1 * x1
    x18 = x16 * x17
    x19 = x2 * x5
    x20 = 1 / x19
    x21 = sigma * x20 * x8
    x22 = x0 * x13
    x23 = x0 * x14
    x24 = x1 * x16
    # Outputs
    out[..., 0] = 2
    out[..., 1] = -q / x0
    out[..., 2] = -3 / 2 * x3
    out[..., 3] = x4 / x5
    out[..., 4] = x3 / 6
    out[..., 5] = 7 * x9 / 18
    out[..., 6] = -3 / 2 * x11
    out[..., 7] = -q * x7 * (x12 * x13 + x12 * x14 - 47 * x1) / 12
    out[..., 8] = -5 * x11 / 18
    out[..., 9] = -x9 / 72
    out[..., 10] = -35 * x18 / 864
    out[..., 11] = 11 * x21 / 27
    out[..., 12] = x24 * (193 * x1 + 108 * x22 - 324 * x23) / 72
    out[..., 13] = x20 * x4 * (144 * x22 + 36 * x23 - 253 * x1) / 36
    out[..., 14] = x24 * (120 * x22 + 152 * x23 - 499 * x1) / 432
    out[..., 15] = 13 * x21 / 432
    out[..., 16] = x18 / 1440
    out[..., 17] = 1 / 2 * Omega
    out[..., 18] = Omega


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    The larger real part of the roots of Γ² + bΓ + c, each of them found without cancellation.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega = Omega/2 + sigma, rad/s, real.
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
    none that begins farther from it than Omega/4, half of the frequencies that resonate;
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

    Where omega = 1/2*Omega + sigma lies on an edge of `boundaries`.

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
        Detuning, omega = Omega/2 + sigma, rad/s, real.
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
        Detuning, omega = Omega/2 + sigma, rad/s, real.
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
        Detuning, omega = Omega/2 + sigma, rad/s, real.
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
        Detuning, omega = Omega/2 + sigma, rad/s, real.
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
        Detuning, omega = Omega/2 + sigma, rad/s, real.
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
        Detuning, omega = Omega/2 + sigma, rad/s, real.
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
        Detuning, omega = Omega/2 + sigma, rad/s, real.
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
