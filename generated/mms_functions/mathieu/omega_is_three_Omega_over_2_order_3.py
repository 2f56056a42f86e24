# Emitted by mmsgen 0.1.0 from derivations/mathieu.py: change that, not this file.
# Made from sha256 a9f971b77177f92e639624847320615d98c5a2a80c858cc546bb7db3173acd14
# Operations for each point: growth_rate 42, boundaries 35, resonance 1, slow_flow_matrix 18,
# characteristic_coefficients 42, slow_flow 25
"""mathieu: omega = 3/2*Omega + sigma, order 3.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 3 in ε, of x. Results are written at ε = 1.

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
ORDER = 3

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
    x0 = sigma * sigma
    x1 = q * q
    x2 = x1 * x1
    x3 = mu * mu
    x4 = x1 * x2
    x5 = Omega * Omega
    x6 = x5 * x5
    x7 = x6 * x6
    x8 = x5 * x7
    x9 = x5 * x6
    x10 = Omega * x5
    x11 = x10 * x6
    # Outputs
    b_1 = 2 * mu
    c_1 = (
        13 * x0 * x1 / (36 * x6) + 169 * x0 * x2 / (5184 * x7) + x0 + x2 / (144 * x9) + x3
        - sigma * x1 / (6 * x10) - 13 * sigma * x2 / (432 * x11) - x4 / (144 * x8)
    )
    return quadratic_growth(b_1, c_1)


def _boundaries(Omega, q, mu):
    # Intermediates
    x0 = q * q
    x1 = x0 * x0
    x2 = mu * mu
    x3 = Omega * Omega
    x4 = x3 * x3
    x5 = x3 * x4
    x6 = x0 * x1
    x7 = x4 * x4
    x8 = x3 * x7
    x9 = Omega * x3
    x10 = x4 * x9
    # Outputs
    p0 = x6 / (36 * x8) - x1 / (36 * x5) - 4 * x2
    p1 = 2 * x0 / (3 * x9) + 13 * x1 / (108 * x10)
    p2 = -13 * x0 / (9 * x4) - 169 * x1 / (1296 * x7) - 4
    return zone((p0, p1, p2))


def _resonance(Omega, q, mu):
    centre = 3 / 2 * Omega
    return centre, Omega, q, mu


def _slow_flow_matrix(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = -mu
    x1 = q * q
    x2 = Omega * Omega
    x3 = Omega * x2
    x4 = x2 * x2
    x5 = 13 * sigma * x1 / (72 * x4) + sigma - x1 / (12 * x3)
    x6 = q * x1
    x7 = Omega * x4
    x8 = x6 / (12 * x7)
    # Outputs
    out[..., 0, 0].real = x0
    out[..., 0, 0].imag = x5
    out[..., 0, 1].imag = -x8
    out[..., 1, 0].imag = x8
    out[..., 1, 1].real = x0
    out[..., 1, 1].imag = -x5


def _characteristic_coefficients(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = sigma * sigma
    x1 = q * q
    x2 = x1 * x1
    x3 = mu * mu
    x4 = x1 * x2
    x5 = Omega * Omega
    x6 = x5 * x5
    x7 = x6 * x6
    x8 = x5 * x7
    x9 = x5 * x6
    x10 = Omega * x5
    x11 = x10 * x6
    # Outputs
    c1_1 = 2 * mu
    c1_0 = (
        13 * x0 * x1 / (36 * x6) + 169 * x0 * x2 / (5184 * x7) + x0 + x2 / (144 * x9) + x3
        - sigma * x1 / (6 * x10) - 13 * sigma * x2 / (432 * x11) - x4 / (144 * x8)
    )
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_x, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = x0 * x0
    x2 = q * q
    x3 = q * x2
    x4 = Omega * x1
    # Outputs
    out[..., 0] = (
        A_x * (1j * (sigma * x1 + 13 * sigma * x2 / 72 - Omega * x2 / 12) - mu * x1) / x1
        - 1j * x3 * np.conj(A_x) / (12 * x4)
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
    Order 3 leaves out terms of the edges from ε^4 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero;
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
