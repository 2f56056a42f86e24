# Emitted by mmsgen 0.1.0 from derivations/mathieu.py: change that, not this file.
# Made from sha256 f9826836b47138014a5a041480d59178aa04f8df2dc692b362a81ca2d3050e34
# Operations for each point: growth_rate 0, slow_flow_matrix 60, characteristic_coefficients 62,
# slow_flow 118
"""mathieu: no resonance, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of x. Results are written at ε = 1.

It cannot be unstable: one mode decays at the rate mu.

No number, NaN for growth rates and edges, where a divisor vanishes, which is a further resonance
and a case of its own: -Omega + 2*omega, -Omega + omega.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; NIST DLMF, section 28.6
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

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
    "boundaries",
    "characteristic_coefficients",
    "critical_speeds",
    "growth_rate",
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


# --- functions ------------------------------------------------------------------------------------


def growth_rate(*, omega: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike) -> Any:
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

    Returns
    -------
    float64
        In 1/s, float64, in the shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega=omega, Omega=Omega, q=q, mu=mu)
    return evaluate(_growth_rate, arguments)


def boundaries(
    *, omega: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> tuple[Any, Any]:
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
    arguments = checked(PARAMETERS, omega=omega, Omega=Omega, q=q, mu=mu)
    return evaluate_pair(no_edges, arguments)


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
