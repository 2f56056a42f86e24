# Emitted by mmsgen 0.1.0 from derivations/rotating_shaft.py: change that, not this file.
# Made from sha256 631fa5cf9753e0b3a8edab34216905adfcc388a22e92ca8053c24dbaffe1995b
# Operations for each point: growth_rate 126, slow_flow_matrix 62, characteristic_coefficients 154,
# slow_flow 76, leading 9
"""rotating_shaft: nu = omega_2 - omega_1 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of eta_1, eta_2. Results are written at ε = 1.

It cannot be unstable: the discriminant of Gamma**2 + I*Gamma*sigma +
Phi_alpha_1**2*Phi_alpha_2**2*kappa**2/(16*omega_1*omega_2) is negative at every detuning, the modes
only exchange energy.

No number, NaN for growth rates and edges, where a divisor vanishes, which is a further resonance
and a case of its own: 3*omega_1 - omega_2, omega_1 - 3*omega_2, omega_1 - omega_2.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; gyroscopic modes after
Meirovitch, AIAA Journal 12 (1974)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._eigenmodes import modal_values
from .._runtime import (
    checked,
    checked_amplitudes,
    evaluate,
    evaluate_array,
    evaluate_pair,
    growing,
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
    "modes",
    "slow_flow",
    "slow_flow_matrix",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ("nu = omega_2 - omega_1 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("eta_1", "eta_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, nu = -omega_1 + omega_2 + sigma"),
    "kappa": ("positive", "N m/rad", "amplitude of its modulation in one direction"),
    "omega_1": ("positive", "rad/s", "natural frequency 1, of alpha, beta"),
    "omega_2": ("positive", "rad/s", "natural frequency 2, of alpha, beta"),
    "Phi_alpha_1": ("real", "1", "component alpha of mode 1"),
    "Phi_alpha_2": ("real", "1", "component alpha of mode 2"),
    "I_t": ("positive", "kg m^2", "inertia about a diameter"),
    "I_p": ("positive", "kg m^2", "inertia about the axis of rotation"),
    "Omega_s": ("positive", "rad/s", "speed of rotation"),
    "k": ("positive", "N m/rad", "stiffness against tilting"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "eta_1": {},
    "eta_2": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_eta_1", "A_eta_2")


# --- formulas -------------------------------------------------------------------------------------


def _growth_rate(sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = 1 / omega_2
    x1 = Phi_alpha_1 * Phi_alpha_1
    x2 = Phi_alpha_2 * Phi_alpha_2
    x3 = x1 * x2
    x4 = omega_1 * omega_1
    x5 = 1 / x4
    x6 = omega_1 - 3 * omega_2
    x7 = -omega_2
    x8 = 3 * omega_1 + x7
    x9 = 1 / 8 * x5
    x10 = omega_1 + x7
    x11 = 2 * Phi_alpha_2
    x12 = omega_1 + omega_2
    x13 = sigma * sigma
    x14 = kappa * kappa
    x15 = omega_2 * omega_2
    x16 = x2 * x2
    x17 = x1 * x1
    x18 = x4 * x4
    x19 = x15 * x15
    x20 = x6 * x6
    x21 = x8 * x8
    x22 = x10 * x10
    x23 = x12 * x12
    x24 = x14 * x14
    x25 = omega_1 * x19
    x26 = omega_2 * x18
    x27 = 3 * x3
    x28 = omega_2 * x15
    x29 = x28 * x4
    x30 = omega_1 * x4
    x31 = x15 * x30
    x32 = 10 * x3
    x33 = omega_1 * x18
    x34 = omega_2 * x19
    x35 = (
        12 * x16 * x26 + 4 * x16 * x29 + 12 * x17 * x25 + 4 * x17 * x31 + x25 * x32 + x26 * x32
        - 16 * x16 * x31 - 16 * x17 * x29 - x27 * x29 - x27 * x31 - x27 * x33 - x27 * x34
    )
    x36 = x35 * x35
    # Outputs
    discriminant_1 = (
        sigma * x14 * (9 / 8 * x16 * x5 / x6 + x17 * x9 / x8
        + x9 * (Phi_alpha_1 - Phi_alpha_2) * (Phi_alpha_1 + Phi_alpha_2) * (x1 + x2) / x12
        - x0 * x2 * x9 * (Phi_alpha_1 - x11) * (Phi_alpha_1 + x11) - x3 * x9 / x10)
        + 1 / 16 * x1 * x13 * x14 * x2 * x5 / x15 - x13
        - 1 / 256 * x24 * x36 / (x18 * x19 * x20 * x21 * x22 * x23)
        - 1 / 4 * x0 * x14 * x3 / omega_1
    )
    return growing(discriminant_1)


def _slow_flow_matrix(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = 1 / 16 / (omega_1 + omega_2)
    x1 = omega_1 * omega_1
    x2 = 1 / x1
    x3 = Phi_alpha_1 * Phi_alpha_1
    x4 = x3 * x3
    x5 = x2 * x4
    x6 = 1 / omega_2
    x7 = Phi_alpha_2 * Phi_alpha_2
    x8 = 1 / 32 * x3 * x7
    x9 = -omega_2
    x10 = 1 / (omega_1 + x9)
    x11 = kappa * kappa
    x12 = 1 / omega_1
    x13 = Phi_alpha_1 * Phi_alpha_2 * kappa
    x14 = 1 / 4 * x13
    x15 = 1 / 8 * sigma * x13
    x16 = omega_2 * omega_2
    x17 = 1 / x16
    x18 = x17 * x8
    x19 = x7 * x7
    # Outputs
    out[..., 0, 0].imag = (
        x11 * (1 / 32 * x10 * x2 * x3 * x7 - x0 * x5 - x2 * x6 * x8
        - 1 / 16 * x5 / (3 * omega_1 + x9))
    )
    out[..., 0, 1].imag = x12 * x14 + x15 * x2
    out[..., 1, 0].imag = x14 * x6 - x15 * x17
    out[..., 1, 1].imag = (
        x11 * (1 / 16 * x17 * x19 / (omega_1 - 3 * omega_2) - x0 * x17 * x19 - x10 * x18
        - x12 * x18) - sigma
    )


def _characteristic_coefficients(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = omega_1 * x0
    x2 = omega_2 * x1
    x3 = omega_2 * omega_2
    x4 = omega_2 * x3
    x5 = Phi_alpha_2 * Phi_alpha_2
    x6 = x4 * x5
    x7 = omega_1 * x6
    x8 = Phi_alpha_1 * Phi_alpha_1
    x9 = 1 / 4 * x8
    x10 = x2 * x5
    x11 = x0 * x3 * x5
    x12 = -omega_2
    x13 = 1 / (3 * omega_1 + x12)
    x14 = x13 / (omega_1 - 3 * omega_2)
    x15 = omega_1 + omega_2
    x16 = 1 / (x0 * x3)
    x17 = x16 / x15
    x18 = kappa * kappa
    x19 = x8 * x8
    x20 = x5 * x5
    x21 = x0 * x0
    x22 = x3 * x3
    x23 = x18 * x8
    x24 = omega_1 + x12
    x25 = x4 * x8
    x26 = 8 * omega_1
    x27 = x3 * x8
    x28 = omega_2 * x0
    x29 = x3 * x5
    x30 = x28 * x5
    x31 = sigma * sigma
    x32 = x15 * x15
    x33 = x24 * x24
    x34 = x18 * x18
    # Outputs
    c1_1 = (
        1j * (sigma + x14 * x17 * x18 * (1 / 4 * x0 * x19 * x3 + 1 / 4 * x0 * x20 * x3 + 3 / 16
        * x21 * x5 * x8 + 3 / 16 * x22 * x5 * x8 - 3 / 4 * omega_1 * x19 * x4 - x10 * x9 - 7 / 8
        * x11 * x8 - 3 / 4 * x2 * x20 - x7 * x9))
    )
    c1_0 = (
        1 / 16 * x18 * x5 * x8 / (omega_1 * omega_2) - 1 / 32 * sigma * x13 * x17 * x23 * (8 * x0
        * x3 * x8 + 3 * x21 * x5 + x22 * x5 - x10 - 6 * x11 - x25 * x26 - x7) / x24
        - 1 / 64 * x16 * x23 * x31 * x5 - 1 / 1024 * x14 * x34 * x5 * x8 * (2 * x1 * x8 + 3 * x25
        + x26 * x29 - 4 * omega_1 * x27 - 5 * x28 * x8 - 8 * x30) * (3 * x1 * x5 + 8 * x28 * x8 + 2
        * x6 - 5 * omega_1 * x29 - x26 * x27 - 4 * x30) / (x1 * x32 * x33 * x4)
    )
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_eta_1, A_eta_2, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = 1j * A_eta_2
    x3 = 1 / 8 * Phi_alpha_1 * Phi_alpha_2 * kappa
    x4 = kappa * kappa
    x5 = 1j * x4
    x6 = 1 / 16 * x5
    x7 = x6 / (omega_1 + omega_2)
    x8 = Phi_alpha_1 * Phi_alpha_1
    x9 = x8 * x8
    x10 = x1 * x9
    x11 = Phi_alpha_2 * Phi_alpha_2
    x12 = 1 / 32 * x11 * x5 * x8
    x13 = -omega_2
    x14 = 1 / (omega_1 + x13)
    x15 = omega_2 * omega_2
    x16 = 1 / x15
    x17 = x12 * x16
    x18 = x11 * x11
    # Outputs
    out[..., 0] = (
        A_eta_1 * (1 / 32 * 1j * x1 * x11 * x14 * x4 * x8 - x10 * x6 / (3 * omega_1 + x13)
        - x10 * x7 - x1 * x12 / omega_2) + x1 * x2 * x3 * (2 * omega_1 + sigma)
    )
    out[..., 1] = (
        1j * A_eta_1 * x16 * x3 * (2 * omega_2 - sigma) + A_eta_2 * (1 / 16 * 1j * x16 * x18 * x4
        / (omega_1 - 3 * omega_2) - x14 * x17 - x16 * x18 * x7 - x17 / omega_1) - sigma * x2
    )


def _leading(out, I_t, I_p, Omega_s, k):
    # Intermediates
    x0 = I_p * Omega_s
    x1 = k * k
    x2 = I_p * I_p
    x3 = Omega_s * Omega_s
    x4 = I_t * I_t
    # Outputs
    out[..., 0] = I_t
    out[..., 3] = I_t
    out[..., 5] = -x0
    out[..., 6] = x0
    out[..., 8] = k
    out[..., 11] = k
    out[..., 12] = x1
    out[..., 13] = -2 * I_t * k - x2 * x3
    out[..., 14] = x4


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Amplitudes grow like exp(Γ t). Where the discriminant of the quadratic in Γ is positive, the
    rate is half its root; elsewhere both modes are neutral and the rate is exactly 0.0.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

    Returns
    -------
    float64
        In 1/s, float64, in the shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate(_growth_rate, arguments)


def boundaries(
    *, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike,
    Phi_alpha_2: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable interval of sigma.

    This case cannot be unstable for any detuning: NaN everywhere.

    Parameters
    ----------
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

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
    arguments = checked(
        PARAMETERS, kappa=kappa, omega_1=omega_1, omega_2=omega_2, Phi_alpha_1=Phi_alpha_1,
        Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_pair(no_edges, arguments)


def critical_speeds(
    *, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike,
    Phi_alpha_2: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable zone in the detuned frequency: there is none.

    This case cannot be unstable for any detuning: NaN everywhere.

    Parameters
    ----------
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

    Returns
    -------
    lower, upper : float64
        NaN, float64, in the shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, kappa=kappa, omega_1=omega_1, omega_2=omega_2, Phi_alpha_1=Phi_alpha_1,
        Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_pair(no_edges, arguments)


def slow_flow_matrix(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

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
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (2, 2))


def characteristic_coefficients(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

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
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (3,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike,
    omega_2: ArrayLike, Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

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
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))


def modes(*, I_t: ArrayLike, I_p: ArrayLike, Omega_s: ArrayLike, k: ArrayLike) -> dict[str, Any]:
    """Natural frequencies and mode shapes, as keywords for the other functions.

    Of M0 q'' + G0 q' + K0 q = 0, the leading order. The shape φ = Φ + iΘ of a mode is scaled by
    φᴴ(2ω M0 - iG0)φ = 2ω, which is Φᵀ M0 Φ = 1 without gyroscopic terms; its largest component is
    positive, or i times positive.

    Parameters
    ----------
    I_t : array_like
        Inertia about a diameter, kg m^2, > 0.
    I_p : array_like
        Inertia about the axis of rotation, kg m^2, > 0.
    Omega_s : array_like
        Speed of rotation, rad/s, > 0.
    k : array_like
        Stiffness against tilting, N m/rad, > 0.

    Returns
    -------
    float64
        Name -> float64, in the shape to which the arguments broadcast; NaN where M0 or K0 is not
        positive definite.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, I_t=I_t, I_p=I_p, Omega_s=Omega_s, k=k)
    return modal_values(
        evaluate_array(_leading, arguments, (15,)).real,
        (
            (
                2,
                (False, True),
                ((2, 1),),
                (("omega_1", 1.0), ("omega_2", 1.0)),
                (("Phi_alpha_1", 0, 0, False), ("Phi_alpha_2", 0, 1, False)),
            ),
        ),
    )
