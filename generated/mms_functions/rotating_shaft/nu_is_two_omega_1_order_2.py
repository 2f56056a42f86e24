# Emitted by mmsgen 0.1.0 from derivations/rotating_shaft.py: change that, not this file.
# Made from sha256 565c07a4778ec2c12ee9634c10d07e8266e4d3032f866e70c3cd963d9521fc81
# Operations for each point: growth_rate 83, boundaries 77, resonance 1, slow_flow_matrix 66,
# characteristic_coefficients 98, slow_flow 73, leading 9
"""rotating_shaft: nu = 2*omega_1 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of eta_1, eta_2. Results are written at ε = 1.

It can be unstable: the discriminant of Gamma**2 - (Phi_alpha_1**2*kappa -
2*omega_1*sigma)*(Phi_alpha_1**2*kappa + 2*omega_1*sigma)/(16*omega_1**2) is positive in an interval
of the detuning.

No number, NaN for growth rates and edges, where a divisor vanishes, which is a further resonance
and a case of its own: 3*omega_1 - omega_2, omega_1 - omega_2.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; gyroscopic modes after
Meirovitch, AIAA Journal 12 (1974)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._edges import explicit_edges, zone
from .._eigenmodes import modal_values
from .._runtime import (
    checked,
    checked_amplitudes,
    evaluate,
    evaluate_array,
    evaluate_pair,
    growing,
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
    "boundaries",
    "characteristic_coefficients",
    "critical_speeds",
    "growth_rate",
    "modes",
    "slow_flow",
    "slow_flow_matrix",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ("nu = 2*omega_1 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("eta_1", "eta_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, nu = 2*omega_1 + sigma"),
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
    "eta_1": {"sigma": 1 / 2},
    "eta_2": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_eta_1", "conj(A_eta_1)", "A_eta_2")


# --- formulas -------------------------------------------------------------------------------------


def _growth_rate(sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = omega_1 + omega_2
    x1 = -omega_2
    x2 = omega_1 + x1
    x3 = 3 * omega_1
    x4 = omega_2 + x3
    x5 = x1 + x3
    x6 = Phi_alpha_1 * Phi_alpha_1
    x7 = omega_2 * omega_2
    x8 = x7 * x7
    x9 = x6 * x8
    x10 = omega_1 * omega_1
    x11 = x10 * x10
    x12 = x11 * x6
    x13 = Phi_alpha_2 * Phi_alpha_2
    x14 = 80 * x11 * x13
    x15 = x10 * x7
    x16 = x15 * x6
    x17 = 16 * x13 * x15
    x18 = sigma * sigma
    x19 = x6 * x6
    x20 = kappa * kappa
    x21 = x4 * x4
    x22 = x5 * x5
    x23 = x0 * x0
    x24 = x2 * x2
    x25 = x20 * x20
    x26 = x10 * x11
    x27 = 27 * x12 + x14 + 3 * x9 - 30 * x16 - x17
    x28 = x27 * x27
    x29 = omega_1 * x10
    # Outputs
    discriminant_1 = (
        1 / 16 * x18 * x19 * x20 / x11 + 1 / 4 * x19 * x20 / x10 - 1 / 16 * sigma * x20 * x6 * (9
        * x12 + x17 + x9 - x14 - 10 * x16) / (x0 * x2 * x29 * x4 * x5) - x18
        - 1 / 1024 * x19 * x25 * x28 / (x21 * x22 * x23 * x24 * x26)
    )
    return growing(discriminant_1)


def _boundaries(kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = Phi_alpha_1 * Phi_alpha_1
    x1 = x0 * x0
    x2 = kappa * kappa
    x3 = omega_1 * omega_1
    x4 = omega_1 + omega_2
    x5 = x4 * x4
    x6 = -omega_2
    x7 = omega_1 + x6
    x8 = x7 * x7
    x9 = 3 * omega_1
    x10 = omega_2 + x9
    x11 = x10 * x10
    x12 = x6 + x9
    x13 = x12 * x12
    x14 = x2 * x2
    x15 = x3 * x3
    x16 = x15 * x3
    x17 = x0 * x15
    x18 = omega_2 * omega_2
    x19 = x18 * x18
    x20 = x0 * x19
    x21 = Phi_alpha_2 * Phi_alpha_2
    x22 = 80 * x15 * x21
    x23 = x18 * x3
    x24 = x0 * x23
    x25 = 16 * x21 * x23
    x26 = 27 * x17 + 3 * x20 + x22 - 30 * x24 - x25
    x27 = x26 * x26
    x28 = omega_1 * x3
    # Outputs
    p0 = 1 / 4 * x1 * x2 / x3 - 1 / 1024 * x1 * x14 * x27 / (x11 * x13 * x16 * x5 * x8)
    p1 = -1 / 16 * x0 * x2 * (9 * x17 + x20 + x25 - x22 - 10 * x24) / (x10 * x12 * x28 * x4 * x7)
    p2 = 1 / 16 * x1 * x2 / x15 - 1
    return zone((p0, p1, p2))


def _resonance(kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    centre = 2 * omega_1
    return centre, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2


def _slow_flow_matrix(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = Phi_alpha_1 * Phi_alpha_1
    x1 = omega_2 * omega_2
    x2 = x0 * x1
    x3 = Phi_alpha_2 * Phi_alpha_2
    x4 = x1 * x3
    x5 = -omega_2
    x6 = 3 * omega_1
    x7 = kappa * kappa
    x8 = x7 / ((omega_1 + omega_2) * (omega_1 + x5) * (omega_2 + x6) * (x5 + x6))
    x9 = omega_1 * omega_1
    x10 = x9 * x9
    x11 = omega_1 * x9
    x12 = x1 * x1
    x13 = (
        1 / 64 * x0 * x8 * (27 * x0 * x10 + 3 * x0 * x12 + 80 * x10 * x3 - 30 * x2 * x9
        - 16 * x4 * x9) / x11 - 1 / 2 * sigma
    )
    x14 = kappa * x0
    x15 = 1 / 4 * x14 / omega_1 - 1 / 8 * sigma * x14 / x9
    # Outputs
    out[..., 0, 0].imag = x13
    out[..., 0, 1].imag = x15
    out[..., 1, 0].imag = -x15
    out[..., 1, 1].imag = -x13
    out[..., 2, 2].imag = 1 / 16 * x3 * x8 * (12 * x0 * x9 + 4 * x2 + 9 * x3 * x9 - x4) / omega_2


def _characteristic_coefficients(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = Phi_alpha_1 * Phi_alpha_1
    x1 = x0 * x0
    x2 = kappa * kappa
    x3 = x1 * x2
    x4 = omega_2 * omega_2
    x5 = x4 * x4
    x6 = x0 * x5
    x7 = omega_1 * omega_1
    x8 = x7 * x7
    x9 = x0 * x8
    x10 = Phi_alpha_2 * Phi_alpha_2
    x11 = 80 * x10 * x8
    x12 = x0 * x4
    x13 = x12 * x7
    x14 = x10 * x4
    x15 = 16 * x14 * x7
    x16 = omega_1 + omega_2
    x17 = -omega_2
    x18 = omega_1 + x17
    x19 = 3 * omega_1
    x20 = omega_2 + x19
    x21 = x17 + x19
    x22 = x2 / (x16 * x18 * x20 * x21)
    x23 = sigma * sigma
    x24 = omega_1 * x7
    x25 = x16 * x16
    x26 = x18 * x18
    x27 = x20 * x20
    x28 = x21 * x21
    x29 = x2 * x2
    x30 = x7 * x8
    x31 = x11 + 3 * x6 + 27 * x9 - 30 * x13 - x15
    x32 = x31 * x31
    # Outputs
    c1_0 = (
        1 / 64 * sigma * x0 * x22 * (x15 + x6 + 9 * x9 - x11 - 10 * x13) / x24
        + 1 / 4096 * x1 * x29 * x32 / (x25 * x26 * x27 * x28 * x30) + 1 / 4 * x23
        - 1 / 64 * x23 * x3 / x8 - 1 / 16 * x3 / x7
    )
    c2_0 = -1 / 16 * 1j * x10 * x22 * (12 * x0 * x7 + 9 * x10 * x7 + 4 * x12 - x14) / omega_2
    multiply_out(out, ((0.0, c1_0), 1), ((c2_0,), 1))


def _slow_flow(out, A_eta_1, A_eta_2, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = 1j * A_eta_1
    x1 = Phi_alpha_1 * Phi_alpha_1
    x2 = omega_2 * omega_2
    x3 = x1 * x2
    x4 = Phi_alpha_2 * Phi_alpha_2
    x5 = x2 * x4
    x6 = -omega_2
    x7 = 3 * omega_1
    x8 = kappa * kappa
    x9 = x8 / ((omega_1 + omega_2) * (omega_1 + x6) * (omega_2 + x7) * (x6 + x7))
    x10 = omega_1 * omega_1
    x11 = x10 * x10
    x12 = omega_1 * x10
    x13 = x2 * x2
    # Outputs
    out[..., 0] = (
        1 / 8 * 1j * kappa * x1 * (2 * omega_1 - sigma) * np.conj(A_eta_1) / x10 + 1 / 64 * x0 * x1
        * x9 * (27 * x1 * x11 + 3 * x1 * x13 + 80 * x11 * x4 - 30 * x10 * x3 - 16 * x10 * x5) / x12
        - 1 / 2 * sigma * x0
    )
    out[..., 1] = (
        1 / 16 * 1j * A_eta_2 * x4 * x9 * (12 * x1 * x10 + 9 * x10 * x4 + 4 * x3 - x5) / omega_2
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
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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

    The interval of sigma in which growth_rate is positive: where one of the polynomials with the
    coefficients in `_boundaries` (lowest power first) is. Infinite where the interval has no end.
    Order 2 leaves out terms of the edges from ε^3 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero;
    SlowFlow.zones() gives all of them.

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
    return evaluate_pair(_boundaries, arguments)


def critical_speeds(
    *, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike,
    Phi_alpha_2: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable zone in nu.

    Where nu = 2*omega_1 + sigma lies on an edge of `boundaries`.

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
        In rad/s, float64, in the shape to which the arguments broadcast; NaN where there is no such
        edge.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, kappa=kappa, omega_1=omega_1, omega_2=omega_2, Phi_alpha_1=Phi_alpha_1,
        Phi_alpha_2=Phi_alpha_2,
    )
    return explicit_edges(_resonance, _boundaries, 1, arguments)


def slow_flow_matrix(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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
        Shape (..., 3, 3), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (3, 3))


def characteristic_coefficients(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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
        Shape (..., 4), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (4,))


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
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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
