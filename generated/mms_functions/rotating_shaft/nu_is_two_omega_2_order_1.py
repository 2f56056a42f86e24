# Emitted by mmsgen 0.1.0 from derivations/rotating_shaft.py: change that, not this file.
# Made from sha256 408115b93202d03f692e1a6c8905337f02902bceba3dc5390480f586d892e239
# Operations for each point: growth_rate 10, boundaries 5, resonance 1, slow_flow_matrix 6,
# characteristic_coefficients 11, slow_flow 12, leading 9
"""rotating_shaft: nu = 2*omega_2 + sigma, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of eta_1, eta_2. Results are written at ε = 1.

It can be unstable: the discriminant of Gamma**2 - (Phi_alpha_2**2*kappa -
2*omega_2*sigma)*(Phi_alpha_2**2*kappa + 2*omega_2*sigma)/(16*omega_2**2) is positive in an interval
of the detuning.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; gyroscopic modes after
Meirovitch, AIAA Journal 12 (1974)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._edges import explicit_edges
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
RELATIONS: tuple[str, ...] = ("nu = 2*omega_2 + sigma",)

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("eta_1", "eta_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, nu = 2*omega_2 + sigma"),
    "kappa": ("positive", "N m/rad", "amplitude of its modulation in one direction"),
    "omega_2": ("positive", "rad/s", "natural frequency 2, of alpha, beta"),
    "Phi_alpha_2": ("real", "1", "component alpha of mode 2"),
    "I_t": ("positive", "kg m^2", "inertia about a diameter"),
    "I_p": ("positive", "kg m^2", "inertia about the axis of rotation"),
    "Omega_s": ("positive", "rad/s", "speed of rotation"),
    "k": ("positive", "N m/rad", "stiffness against tilting"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "eta_1": {},
    "eta_2": {"sigma": 1 / 2},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_eta_1", "A_eta_2", "conj(A_eta_2)")


# --- formulas -------------------------------------------------------------------------------------


def _growth_rate(sigma, kappa, omega_2, Phi_alpha_2):
    # Intermediates
    x0 = sigma * sigma
    x1 = Phi_alpha_2 * Phi_alpha_2
    x2 = x1 * x1
    x3 = kappa * kappa
    x4 = omega_2 * omega_2
    # Outputs
    discriminant_1 = 1 / 4 * x2 * x3 / x4 - x0
    return growing(discriminant_1)


def _boundaries(kappa, omega_2, Phi_alpha_2):
    # Intermediates
    x0 = Phi_alpha_2 * Phi_alpha_2
    x1 = 1 / 2 * kappa * x0 / omega_2
    # Outputs
    lower = -x1
    upper = x1
    return lower, upper


def _resonance(kappa, omega_2, Phi_alpha_2):
    centre = 2 * omega_2
    return centre, kappa, omega_2, Phi_alpha_2


def _slow_flow_matrix(out, sigma, kappa, omega_2, Phi_alpha_2):
    # Intermediates
    x0 = 1 / 2 * sigma
    x1 = Phi_alpha_2 * Phi_alpha_2
    x2 = 1 / 4 * kappa * x1 / omega_2
    # Outputs
    out[..., 1, 1].imag = -x0
    out[..., 1, 2].imag = x2
    out[..., 2, 1].imag = -x2
    out[..., 2, 2].imag = x0


def _characteristic_coefficients(out, sigma, kappa, omega_2, Phi_alpha_2):
    # Intermediates
    x0 = sigma * sigma
    x1 = Phi_alpha_2 * Phi_alpha_2
    x2 = x1 * x1
    x3 = kappa * kappa
    x4 = omega_2 * omega_2
    # Outputs
    c2_0 = 1 / 4 * x0 - 1 / 16 * x2 * x3 / x4
    multiply_out(out, ((0.0,), 1), ((0.0, c2_0), 1))


def _slow_flow(out, A_eta_1, A_eta_2, sigma, kappa, omega_2, Phi_alpha_2):
    # Intermediates
    x0 = Phi_alpha_2 * Phi_alpha_2
    # Outputs
    out[..., 1] = (
        1 / 4 * 1j * kappa * x0 * np.conj(A_eta_2) / omega_2 - 1 / 2 * 1j * A_eta_2 * sigma
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
    *, sigma: ArrayLike, kappa: ArrayLike, omega_2: ArrayLike, Phi_alpha_2: ArrayLike,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Amplitudes grow like exp(Γ t). Where the discriminant of the quadratic in Γ is positive, the
    rate is half its root; elsewhere both modes are neutral and the rate is exactly 0.0.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, kappa=kappa, omega_2=omega_2, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate(_growth_rate, arguments)


def boundaries(*, kappa: ArrayLike, omega_2: ArrayLike, Phi_alpha_2: ArrayLike) -> tuple[Any, Any]:
    """Both edges of the unstable interval of sigma.

    In closed form: the roots of a quadratic in it, between which growth_rate is positive. Order 1
    leaves out terms of the edges from ε^2 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero;
    SlowFlow.zones() gives all of them.

    Parameters
    ----------
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
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
    arguments = checked(PARAMETERS, kappa=kappa, omega_2=omega_2, Phi_alpha_2=Phi_alpha_2)
    return evaluate_pair(_boundaries, arguments)


def critical_speeds(
    *, kappa: ArrayLike, omega_2: ArrayLike, Phi_alpha_2: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable zone in nu.

    Where nu = 2*omega_2 + sigma lies on an edge of `boundaries`.

    Parameters
    ----------
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
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
    arguments = checked(PARAMETERS, kappa=kappa, omega_2=omega_2, Phi_alpha_2=Phi_alpha_2)
    return explicit_edges(_resonance, _boundaries, 1, arguments)


def slow_flow_matrix(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_2: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, kappa=kappa, omega_2=omega_2, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (3, 3))


def characteristic_coefficients(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_2: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, kappa=kappa, omega_2=omega_2, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (4,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, kappa: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, kappa=kappa, omega_2=omega_2, Phi_alpha_2=Phi_alpha_2,
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
                (("", 1.0), ("omega_2", 1.0)),
                (("Phi_alpha_2", 0, 1, False),),
            ),
        ),
    )
