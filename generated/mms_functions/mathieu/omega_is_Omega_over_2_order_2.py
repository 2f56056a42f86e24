# Emitted by mmsgen 0.1.0 from derivations/mathieu.py: change that, not this file.
# Made from sha256 b69dbd3cc6f081a2c22ce18f485cb0869797a739af3c7f5aeb1585d9e44d1b81
# Operations for each point: growth_rate 34, boundaries 35, resonance 1, slow_flow_matrix 12,
# characteristic_coefficients 34, slow_flow 21
"""mathieu: omega = 1/2*Omega + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x. Results are written at ε = 1.

Stability depends: Gamma**2 + 2*Gamma*mu + (Omega**2*mu**2 + Omega**2*sigma**2 - q**2)/Omega**2 is
damped, and unstable near resonance if -64*(Omega*mu - q)*(Omega*mu + q)/Omega**2 > 0.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; NIST DLMF, section 28.6
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
RELATIONS: tuple[str, ...] = ("omega = 1/2*Omega + sigma",)

#: the highest power of ε
ORDER = 2

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


def _growth_rate(sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = 1 / x0
    x2 = q * q
    x3 = 3 * x2
    x4 = mu * mu
    x5 = sigma * sigma
    x6 = x4 * x4
    x7 = x2 * x2
    x8 = x0 * x0
    x9 = x0 * x8
    x10 = Omega * x0
    # Outputs
    b_1 = 2 * mu
    c_1 = (
        sigma * x3 / x10 + x1 * x6 + x4 + x5 + 9 / 4 * x7 / x9 - x1 * x2 - x3 * x4 / x8
        - 2 * sigma * x4 / Omega
    )
    return quadratic_growth(b_1, c_1)


def _boundaries(Omega, q, mu):
    # Intermediates
    x0 = 1 / Omega
    x1 = q * q
    x2 = Omega * Omega
    x3 = Omega * x2
    x4 = 3 / 2 * x1 / x3
    x5 = 1 / x2
    x6 = mu * mu
    x7 = x0 * x6 - x4
    x8 = x7 * x7
    x9 = x6 * x6
    x10 = x1 * x1
    x11 = x2 * x2
    x12 = x11 * x2
    x13 = np.sqrt(x1 * x5 + 3 * x1 * x6 / x11 + x8 - 9 / 4 * x10 / x12 - x5 * x9 - x6)
    # Outputs
    lower = x0 * x6 - x13 - x4
    upper = x13 + x7
    return lower, upper


def _resonance(Omega, q, mu):
    centre = 1 / 2 * Omega
    return centre, Omega, q, mu


def _slow_flow_matrix(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = -mu
    x1 = 1 / Omega
    x2 = mu * mu
    x3 = q * q
    x4 = Omega * Omega
    x5 = Omega * x4
    x6 = sigma + 3 / 2 * x3 / x5 - x1 * x2
    x7 = q * x1
    # Outputs
    out[..., 0, 0].real = x0
    out[..., 0, 0].imag = x6
    out[..., 0, 1].imag = -x7
    out[..., 1, 0].imag = x7
    out[..., 1, 1].real = x0
    out[..., 1, 1].imag = -x6


def _characteristic_coefficients(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = 1 / x0
    x2 = q * q
    x3 = 3 * x2
    x4 = mu * mu
    x5 = sigma * sigma
    x6 = x4 * x4
    x7 = x2 * x2
    x8 = x0 * x0
    x9 = x0 * x8
    x10 = Omega * x0
    # Outputs
    c1_1 = 2 * mu
    c1_0 = (
        sigma * x3 / x10 + x1 * x6 + x4 + x5 + 9 / 4 * x7 / x9 - x1 * x2 - x3 * x4 / x8
        - 2 * sigma * x4 / Omega
    )
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_x, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = Omega * x0
    x2 = q * q
    x3 = mu * mu
    # Outputs
    out[..., 0] = (
        A_x * (1j * (sigma * x1 + 3 / 2 * x2 - x0 * x3) - mu * x1) / x1
        - 1j * q * np.conj(A_x) / Omega
    )


# --- functions ------------------------------------------------------------------------------------


def growth_rate(*, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike) -> Any:
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

    In closed form: the roots of a quadratic in it, between which growth_rate is positive. Order 2
    leaves out terms of the edges from ε^3 on; by as much differs the formula of
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

    Where omega = 1/2*Omega + sigma lies on an edge of `boundaries`.

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
