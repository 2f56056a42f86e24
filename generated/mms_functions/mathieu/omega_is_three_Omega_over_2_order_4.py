# Emitted by mmsgen 0.1.0 from derivations/mathieu.py: change that, not this file.
# Made from sha256 c7cf239b7033f229dcd00466c1ed19be8ff5b7d2768ec857c721fa5f19d0da38
# Operations for each point: growth_rate 78, boundaries 63, resonance 1, slow_flow_matrix 35,
# characteristic_coefficients 78, slow_flow 39
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

from .._edges import explicit_edges, zone
from .._runtime import (
    checked,
    checked_amplitudes,
    evaluate,
    evaluate_array,
    evaluate_pair,
    multiply_out,
    quadratic_growth,
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


# --- functions ------------------------------------------------------------------------------------


def growth_rate(*, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike) -> Any:
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

    Returns
    -------
    float64
        In 1/s, float64, in the shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return evaluate(_growth_rate, arguments)


def boundaries(*, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike) -> tuple[Any, Any]:
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
    arguments = checked(PARAMETERS, Omega=Omega, q=q, mu=mu)
    return evaluate_pair(_boundaries, arguments)


def critical_speeds(*, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike) -> tuple[Any, Any]:
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
    arguments = checked(PARAMETERS, Omega=Omega, q=q, mu=mu)
    return explicit_edges(_resonance, _boundaries, 1, arguments)


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
