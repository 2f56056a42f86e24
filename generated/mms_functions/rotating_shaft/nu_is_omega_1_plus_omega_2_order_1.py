# Emitted by mmsgen 0.1.0 from derivations/rotating_shaft.py: change that, not this file.
# Made from sha256 277240c07a16822bf0c8b3f5a985ea8afbffa84d1943de97160a4a1660ffe79c
# Operations for each point: growth_rate 12, boundaries 10, resonance 1, slow_flow_matrix 7,
# characteristic_coefficients 11, slow_flow 19, motion 103, leading 9
"""rotating_shaft: nu = omega_1 + omega_2 + sigma, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of eta_1, eta_2. Results are written at ε = 1.

It can be unstable: the discriminant of Gamma**2 - I*Gamma*sigma -
Phi_alpha_1**2*Phi_alpha_2**2*kappa**2/(16*omega_1*omega_2) is positive in an interval of the
detuning.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; gyroscopic modes after
Meirovitch, AIAA Journal 12 (1974)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._edges import explicit_edges
from .._eigenmodes import modal_values
from .._evolution import Linear, evolution_at
from .._growth import growing
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
    "modes",
    "response",
    "slow_flow",
    "slow_flow_matrix",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ("nu = omega_1 + omega_2 + sigma",)

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("eta_1", "eta_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, nu = omega_1 + omega_2 + sigma"),
    "kappa": ("positive", "N m/rad", "amplitude of its modulation in one direction"),
    "omega_1": ("positive", "rad/s", "natural frequency 1, of alpha, beta"),
    "omega_2": ("positive", "rad/s", "natural frequency 2, of alpha, beta"),
    "Phi_alpha_1": ("real", "1", "component alpha of mode 1"),
    "Phi_alpha_2": ("real", "1", "component alpha of mode 2"),
    "Theta_beta_1": ("real", "1", "component beta of mode 1, in quadrature"),
    "Theta_beta_2": ("real", "1", "component beta of mode 2, in quadrature"),
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
VARIABLES: tuple[str, ...] = ("A_eta_1", "conj(A_eta_2)")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    2,
    (
        ((0, 0), (1, 1)),
    ),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (0, 0, 0, 1, 0, 0), (0,)), (0, 0, (1, 0, 0, 0, 0, 0), (0,)),
        (0, 1, (0, 0, 0, 1, 0, 0), (0,)), (0, 1, (1, 0, 0, 0, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 1, 0, 0), (-1,)), (1, 0, (0, 0, 0, 1, 0, 0), (1,)),
        (1, 0, (1, 0, 0, 0, 0, 0), (-1,)), (1, 0, (1, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 1, 0, 0), (-1,)), (1, 1, (0, 0, 0, 1, 0, 0), (1,)),
        (1, 1, (1, 0, 0, 0, 0, 0), (-1,)), (1, 1, (1, 0, 0, 0, 0, 0), (1,)),
    ),
    1,
)


def _growth_rate(sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = sigma * sigma
    x1 = Phi_alpha_1 * Phi_alpha_1
    x2 = Phi_alpha_2 * Phi_alpha_2
    x3 = kappa * kappa
    # Outputs
    discriminant_1 = 1 / 4 * x1 * x2 * x3 / (omega_1 * omega_2) - x0
    return growing(discriminant_1)


def _boundaries(kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = np.sqrt(1 / (omega_1 * omega_2))
    x1 = 1 / 2 * kappa * x0 * np.abs(Phi_alpha_1) * np.abs(Phi_alpha_2)
    # Outputs
    lower = -x1
    upper = x1
    return lower, upper


def _resonance(kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    centre = omega_1 + omega_2
    return centre, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2


def _slow_flow_matrix(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = 1 / 4 * Phi_alpha_1 * Phi_alpha_2 * kappa
    # Outputs
    out[..., 0, 1].imag = x0 / omega_1
    out[..., 1, 0].imag = -x0 / omega_2
    out[..., 1, 1].imag = sigma


def _characteristic_coefficients(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = Phi_alpha_1 * Phi_alpha_1
    x1 = Phi_alpha_2 * Phi_alpha_2
    x2 = kappa * kappa
    # Outputs
    c1_1 = -1j * sigma
    c1_0 = -1 / 16 * x0 * x1 * x2 / (omega_1 * omega_2)
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_eta_1, A_eta_2, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    out[..., 0] = 1 / 4 * 1j * Phi_alpha_1 * Phi_alpha_2 * kappa * np.conj(A_eta_2) / omega_1
    out[..., 1] = (
        1 / 4 * 1j * Phi_alpha_1 * Phi_alpha_2 * kappa * np.conj(A_eta_1) / omega_2
        - 1j * A_eta_2 * sigma
    )


def _motion(
    out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2, Theta_beta_1, Theta_beta_2,
):
    # Intermediates
    x0 = 2 * Phi_alpha_2
    x1 = 2 * Phi_alpha_1
    x2 = 2 * 1j
    x3 = omega_1 + omega_2
    x4 = kappa / x3
    x5 = x4 / (omega_1 - omega_2)
    x6 = Phi_alpha_2 * Phi_alpha_2
    x7 = Phi_alpha_2 * x6
    x8 = Phi_alpha_1 * Phi_alpha_1
    x9 = omega_1 * x8
    x10 = 3 * omega_2
    x11 = omega_2 * x6
    x12 = 1 / omega_2
    x13 = x12 / (omega_1 + x10)
    x14 = 1 / 4 * x4
    x15 = Phi_alpha_2 * x14
    x16 = Phi_alpha_1 * x8
    x17 = 3 * omega_1
    x18 = 1 / omega_1
    x19 = x18 / (omega_2 + x17)
    x20 = Phi_alpha_1 * x14
    x21 = Phi_alpha_1 * Theta_beta_1
    x22 = Theta_beta_2 * x0
    x23 = Phi_alpha_2 * x12
    x24 = 1 / 2 * 1j
    x25 = x24 * x5
    x26 = omega_1 * omega_1
    x27 = omega_2 * omega_2
    x28 = omega_2 * x27
    x29 = omega_1 * x26
    x30 = kappa * x24
    x31 = x18 * x30
    x32 = Theta_beta_1 * x1
    x33 = Phi_alpha_2 * Theta_beta_2
    # Outputs
    out[..., 0] = x0
    out[..., 1] = x1
    out[..., 2] = Theta_beta_2 * x2
    out[..., 3] = Theta_beta_1 * x2
    out[..., 4] = x5 * x7
    out[..., 5] = x13 * x15 * (x10 * x8 + 4 * x11 + x9)
    out[..., 6] = -x16 * x5
    out[..., 7] = x19 * x20 * (x11 + x17 * x6 + 4 * x9)
    out[..., 8] = -x23 * x25 * (omega_2 * x21 * x26 + x22 * x29 - x21 * x28) / x26
    out[..., 9] = Theta_beta_2 * x13 * x30 * x6 + x21 * x23 * x31 - 1j * x12 * x15 * (x21 - x22)
    out[..., 10] = Phi_alpha_1 * x18 * x25 * (omega_1 * x27 * x33 + x28 * x32 - x29 * x33) / x27
    out[..., 11] = (
        Phi_alpha_1 * x12 * x31 * x33 + Theta_beta_1 * x19 * x30 * x8 + 1j * x18 * x20 * (x32 - x33)
    )
    out[..., 12] = omega_1
    out[..., 13] = omega_2 + sigma
    out[..., 14] = sigma + x3


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
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Amplitudes grow like exp(Γ t). Where the discriminant of the quadratic in Γ is positive, the
    rate is half its root; elsewhere both modes are neutral and the rate is exactly 0.0.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("sigma", "kappa", "omega_1", "omega_2", "Phi_alpha_1", "Phi_alpha_2") if gradient else (),
    )


def boundaries(
    *, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike,
    Phi_alpha_2: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable interval of sigma.

    In closed form: the roots of a quadratic in it, between which growth_rate is positive. Order 1
    leaves out terms of the edges from ε^2 on; by as much differs the formula of
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
    arguments = checked(
        PARAMETERS, kappa=kappa, omega_1=omega_1, omega_2=omega_2, Phi_alpha_1=Phi_alpha_1,
        Phi_alpha_2=Phi_alpha_2,
    )
    return boundaries_at(
        evaluate_pair,
        _boundaries,
        arguments,
        ("kappa", "omega_1", "omega_2", "Phi_alpha_1", "Phi_alpha_2") if gradient else (),
    )


def critical_speeds(
    *, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike,
    Phi_alpha_2: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable zone in nu.

    Where nu = omega_1 + omega_2 + sigma lies on an edge of `boundaries`.

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
    arguments = checked(
        PARAMETERS, kappa=kappa, omega_1=omega_1, omega_2=omega_2, Phi_alpha_1=Phi_alpha_1,
        Phi_alpha_2=Phi_alpha_2,
    )
    return explicit_edges(
        _resonance,
        _boundaries,
        1,
        arguments,
        ("kappa", "omega_1", "omega_2", "Phi_alpha_1", "Phi_alpha_2") if gradient else (),
    )


def slow_flow_matrix(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, kappa: ArrayLike,
    omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
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
        Those at t = 0, shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
        Shape (..., 2), complex128, in the unit of the amplitudes.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike,
    omega_2: ArrayLike, Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> Beating:
    """How amplitudes beat: period and largest modulus, from those at t = 0.

    Closed forms where no mode decays: the sum of the moduli of the parts in each eigenvalue, which
    is the least upper bound of |B_j| unless three or more frequencies are commensurable. Else a
    maximum that is searched for in time.

    Parameters
    ----------
    amplitudes : array_like
        Those at t = 0, shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
    Beating
        period (s), largest, margin, each of shape (..., 2). The period is NaN unless exactly two
        frequencies take part; largest is infinite where the amplitude grows without bound; margin
        is how much too small it may be, 0 for closed forms.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, kappa: ArrayLike,
    omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
    Theta_beta_1: ArrayLike, Theta_beta_2: ArrayLike, order: int | None = None,
    gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. NaN where a harmonic resonates itself. Derivatives
    are taken with these fixed. Over times of order 1/ε the error is O(ε^1). A UserWarning says how
    much is left out where that is more than a tenth of the motion, estimated from the harmonics of
    each order beside those of order zero.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
    Theta_beta_1 : array_like
        Component beta of mode 1, in quadrature, real.
    Theta_beta_2 : array_like
        Component beta of mode 2, in quadrature, real.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 1; all by default.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2), in the order alpha, beta; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2, Theta_beta_1=Theta_beta_1,
        Theta_beta_2=Theta_beta_2,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=(
            "sigma", "kappa", "omega_1", "omega_2", "Phi_alpha_1", "Phi_alpha_2", "Theta_beta_1",
            "Theta_beta_2",
        )
        if gradient
        else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike,
    omega_2: ArrayLike, Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike, Theta_beta_1: ArrayLike,
    Theta_beta_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at t = 0 of the motion with given coordinates and velocities there.

    The solution of response(0, amplitudes) = q, and of its derivative along slow_flow = v, that
    goes over into that of order zero as the small parameters go to zero.

    Parameters
    ----------
    q : array_like
        Coordinates at t = 0, shape (..., 2), in the order of COORDINATES.
    v : array_like
        Velocities at t = 0, shape (..., 2), per second.
    sigma : array_like
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
    Theta_beta_1 : array_like
        Component beta of mode 1, in quadrature, real.
    Theta_beta_2 : array_like
        Component beta of mode 2, in quadrature, real.

    Returns
    -------
    complex128
        Shape (..., 2), complex128; NaN where there is none near that of order zero, as far outside
        of the scaling, or where a harmonic resonates itself.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2, Theta_beta_1=Theta_beta_1,
        Theta_beta_2=Theta_beta_2,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 6, False))


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
