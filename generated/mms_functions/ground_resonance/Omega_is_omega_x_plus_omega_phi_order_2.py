# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 487f41f989c793d6208c93f25693eb11263c88d11961f887698a0f7cd0e99e68
# Operations for each point: growth_rate 75, boundaries 82, detuning 8, slow_flow_matrix 90,
# characteristic_coefficients 110, slow_flow 155
"""ground_resonance: Omega = omega_x + omega_phi + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

It can be unstable: the discriminant of Gamma**2 - I*Gamma*sigma - omega_x**3*r_b*r_m/(4*omega_phi)
is positive in an interval of the detuning.

No number, NaN for growth rates and edges, where a divisor vanishes, which is a further resonance
and a case of its own: 2*omega_phi + omega_x - omega_y, omega_x - omega_y.

Source: Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._edges import implicit_edges
from .._runtime import (
    checked,
    checked_amplitudes,
    defined,
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
    "slow_flow",
    "slow_flow_matrix",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ("Omega = omega_x + omega_phi + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega_phi + omega_x + sigma"),
    "r_m": ("positive", "m", "static moment of a blade over the mass of the helicopter"),
    "r_b": ("positive", "1/m", "static moment of a blade over its inertia about the hinge"),
    "omega_x": ("positive", "rad/s", "longitudinal frequency of the fuselage"),
    "omega_y": ("positive", "rad/s", "lateral frequency of the fuselage"),
    "omega_phi": ("positive", "rad/s", "lag frequency of a blade at speed"),
    "r_a": ("positive", "1", "lag frequency per rotor speed of a blade without lag spring"),
    "omega_b": ("positive", "rad/s", "lag frequency of a blade at rest"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
    "y": {},
    "phi_1": {"sigma": 1},
    "phi_2": {"sigma": 1},
    "phi_3": {"sigma": 1},
    "phi_4": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = (
    "A_x", "conj(A_phi_1)", "conj(A_phi_2)", "conj(A_phi_3)", "conj(A_phi_4)", "A_y",
)


# --- formulas -------------------------------------------------------------------------------------


def _growth_rate(sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = 1 / omega_phi
    x1 = omega_x * omega_x
    x2 = omega_phi * omega_phi
    x3 = x1 / x2
    x4 = omega_x + omega_y
    x5 = omega_x * x1
    x6 = 1 / 2 * x0 * x5
    x7 = omega_x - omega_y
    x8 = omega_phi + omega_x
    x9 = 6 * omega_phi
    x10 = sigma * sigma
    x11 = x1 * x1
    x12 = x4 * x4
    x13 = x7 * x7
    x14 = x8 * x8
    x15 = x2 * x2
    x16 = r_b * r_b
    x17 = r_m * r_m
    x18 = omega_y * omega_y
    x19 = 2 * x18
    x20 = 6 * x1 * x2 + x11 + x5 * x9 - omega_phi * omega_x * x19 - x1 * x18 - x19 * x2
    x21 = x20 * x20
    # Outputs
    discriminant_1 = (
        r_b * r_m * sigma * (x6 / x7 + x6 / x4 - 1 / 4 * x3 * (x1 - omega_x * x9 - 8 * x2) / x8)
        + r_b * r_m * x0 * x5 - 3 / 4 * r_b * r_m * x10 * x3 - x10
        - 1 / 64 * x11 * x16 * x17 * x21 / (x12 * x13 * x14 * x15)
    )
    return growing(discriminant_1)


def _boundaries(r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = r_b * r_m
    x1 = omega_x * omega_x
    x2 = omega_phi * omega_phi
    x3 = x1 / x2
    x4 = x0 * x3
    x5 = 3 / 2 * x4 + 2
    x6 = omega_x + omega_y
    x7 = omega_x * x1
    x8 = x7 / omega_phi
    x9 = 1 / 2 * x8
    x10 = omega_x - omega_y
    x11 = omega_phi + omega_x
    x12 = 6 * omega_phi
    x13 = x9 / x6 + x9 / x10 - 1 / 4 * x3 * (x1 - omega_x * x12 - 8 * x2) / x11
    x14 = x0 * x13 / x5
    x15 = r_b * r_b
    x16 = r_m * r_m
    x17 = x15 * x16
    x18 = x1 * x1
    x19 = x10 * x10
    x20 = x11 * x11
    x21 = x6 * x6
    x22 = x2 * x2
    x23 = omega_y * omega_y
    x24 = 2 * x23
    x25 = 6 * x1 * x2 + x12 * x7 + x18 - omega_phi * omega_x * x24 - x1 * x23 - x2 * x24
    x26 = x25 * x25
    x27 = x13 * x13
    x28 = x5 * x5
    x29 = (
        np.sqrt(x17 * x27 / x28
        + (x0 * x8 - 1 / 64 * x17 * x18 * x26 / (x19 * x20 * x21 * x22)) / (3 / 4 * x4 + 1))
    )
    # Outputs
    lower = x14 - x29
    upper = x14 + x29
    return defined(lower, upper)


def _detuning(Omega, r_m, r_b, omega_x, omega_y, r_a, omega_b):
    # Intermediates
    x0 = omega_b * omega_b
    x1 = Omega * Omega
    x2 = r_a * r_a
    x3 = np.sqrt(x0 + x1 * x2)
    # Outputs
    sigma_at_speed = Omega - omega_x - x3
    omega_phi_at_speed = x3
    return sigma_at_speed, r_m, r_b, omega_x, omega_y, omega_phi_at_speed


def _slow_flow_matrix(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = omega_phi + omega_x
    x1 = 1 / x0
    x2 = 2 * omega_phi
    x3 = r_b * r_m
    x4 = 1 / omega_phi
    x5 = omega_x * omega_x
    x6 = x4 * x5
    x7 = 1 / 4 * omega_x * r_m + 3 / 8 * r_m * sigma
    x8 = -x7
    x9 = omega_phi * omega_phi
    x10 = 1 / x9
    x11 = 1 / 4 * r_b * x6 - 1 / 8 * r_b * sigma * x10 * x5
    x12 = omega_x * x5
    x13 = omega_phi * x9
    x14 = omega_y * omega_y
    x15 = (
        1 / 4 * omega_phi * x14 + 19 / 32 * omega_phi * x5 + 33 / 32 * omega_x * x9 + 1 / 16 * x12
        + 31 / 32 * x13
    )
    x16 = 1 / 32 * x1
    x17 = omega_x + omega_y
    x18 = 1 / x17
    x19 = 1 / 16 * x4
    x20 = omega_y * x14
    x21 = x19 * x20
    x22 = 1 / (x17 + x2)
    x23 = omega_x - omega_y
    x24 = 1 / x23
    x25 = x20 * x24
    x26 = 1 / (x2 + x23)
    x27 = x16 * x9 + x19 * x25 + x21 * x26 - x18 * x21 - x21 * x22
    x28 = sigma + x3 * (-x10 * x15 - x27)
    x29 = x18 * x20 * x22
    x30 = x0 + x16 * x5 + 1 / 8 * x29 + 3 / 32 * x6 - 1 / 8 * x20 * x24 * x26
    x31 = -x3 * x30
    x32 = x3 * (x10 * x15 + x27)
    x33 = x3 * x30
    x34 = -x11
    # Outputs
    out[..., 0, 0].imag = -1 / 8 * x1 * x3 * x6 * (3 * omega_x + x2)
    out[..., 0, 1].real = x7
    out[..., 0, 2].imag = x7
    out[..., 0, 3].real = x8
    out[..., 0, 4].imag = x8
    out[..., 1, 0].real = x11
    out[..., 1, 1].imag = x28
    out[..., 1, 2].real = x31
    out[..., 1, 3].imag = x32
    out[..., 1, 4].real = x33
    out[..., 2, 0].imag = x34
    out[..., 2, 1].real = x33
    out[..., 2, 2].imag = x28
    out[..., 2, 3].real = x31
    out[..., 2, 4].imag = x32
    out[..., 3, 0].real = x34
    out[..., 3, 1].imag = x32
    out[..., 3, 2].real = x33
    out[..., 3, 3].imag = x28
    out[..., 3, 4].real = x31
    out[..., 4, 0].imag = x11
    out[..., 4, 1].real = x31
    out[..., 4, 2].imag = x32
    out[..., 4, 3].real = x33
    out[..., 4, 4].imag = x28
    out[..., 5, 5].imag = x3 * (1 / 2 * x25 * x26 + 1 / 2 * x29)


def _characteristic_coefficients(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = -sigma
    x1 = omega_x + omega_y
    x2 = 1 / x1
    x3 = 1 / 4 / omega_phi
    x4 = omega_x * omega_x
    x5 = omega_x * x4
    x6 = x3 * x5
    x7 = omega_x - omega_y
    x8 = 1 / x7
    x9 = omega_phi * omega_x
    x10 = 1 / (omega_phi + omega_x)
    x11 = 1 / 8 * x10
    x12 = omega_phi * omega_phi
    x13 = 1 / x12
    x14 = r_b * r_m
    x15 = 2 * omega_phi
    x16 = omega_phi * x4
    x17 = omega_y * omega_y
    x18 = omega_phi * x17
    x19 = omega_phi * x12
    x20 = sigma * sigma
    x21 = x4 * x4
    x22 = r_b * r_b
    x23 = r_m * r_m
    x24 = 1 / (x1 + x15)
    x25 = omega_y * x17
    x26 = x25 * x3
    x27 = 1 / (x15 + x7)
    x28 = 1 / 2 * x25
    # Outputs
    c1_1 = 1j * (x0 + x14 * (x11 * x13 * x4 * (6 * x12 + x4 + 8 * x9) + x2 * x6 + x6 * x8))
    c1_0 = (
        1 / 8 * r_b * r_m * sigma * x10 * x13 * x4 * (x4 + x9 - x12)
        + 3 / 16 * r_b * r_m * x13 * x20 * x4 - 1 / 64 * x10 * x2 * x21 * x22 * x23 * x8 * (3
        * omega_x + x15) * (8 * x16 + x5 - omega_x * x17 - 4 * x18) / x19 - x14 * x6
    )
    c2_0 = -1j * sigma
    c3_0 = (
        1j * (x0 + x14 * (x11 * x12 + x13 * (33 / 8 * omega_x * x12 + 11 / 8 * x16 + 1 / 2 * x18
        + 31 / 8 * x19 + 1 / 8 * x5) + x26 * x27 - x24 * x26))
    )
    c4_0 = 1j * x14 * (-x2 * x24 * x28 - x27 * x28 * x8)
    multiply_out(out, ((c1_1, c1_0), 1), ((c2_0,), 2), ((c3_0,), 1), ((c4_0,), 1))


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, sigma, r_m, r_b, omega_x, omega_y, omega_phi,
):
    # Intermediates
    x0 = 2 * omega_x + 3 * sigma
    x1 = 1 / 8 * r_m * x0
    x2 = omega_phi + omega_x
    x3 = 1 / x2
    x4 = 2 * omega_phi
    x5 = 1 / omega_phi
    x6 = r_b * r_m
    x7 = omega_x * omega_x
    x8 = x6 * x7
    x9 = x5 * x8
    x10 = omega_x + omega_y
    x11 = 1 / (x10 + x4)
    x12 = omega_y * omega_y
    x13 = omega_y * x12
    x14 = x13 / x10
    x15 = x11 * x14
    x16 = 1j * x6
    x17 = 1 / 2 * x16
    x18 = omega_x - omega_y
    x19 = 1 / (x18 + x4)
    x20 = 1 / x18
    x21 = x13 * x20
    x22 = 1j * sigma
    x23 = omega_phi * omega_phi
    x24 = 1 / x23
    x25 = 1 / 8 * r_b * x24 * x7 * (x4 - sigma) * np.conj(A_x)
    x26 = 1 / 32 * x3
    x27 = 1 / 8 * x15 * x6 + x2 * x6 + x26 * x8 + 3 / 32 * x9 - 1 / 8 * r_b * r_m * x13 * x19 * x20
    x28 = -x27
    x29 = 1 / 16 * x16 * x5
    x30 = x13 * x29
    x31 = omega_x * x7
    x32 = omega_phi * x23
    x33 = (
        x16 * x23 * x26 + 1 / 32 * x16 * x24 * (8 * omega_phi * x12 + 19 * omega_phi * x7 + 33
        * omega_x * x23 + 2 * x31 + 31 * x32) + x19 * x30 + x21 * x29 - x11 * x30 - x14 * x29
    )
    x34 = -x33
    x35 = 1j * x25
    # Outputs
    out[..., 0] = (
        1 / 8 * r_m * x0 * np.conj(A_phi_1) + 1 / 8 * 1j * r_m * x0 * np.conj(A_phi_2)
        - 1 / 8 * 1j * A_x * x3 * x9 * (3 * omega_x + x4) - x1 * np.conj(A_phi_3)
        - 1j * x1 * np.conj(A_phi_4)
    )
    out[..., 1] = A_y * (x15 * x17 + x17 * x19 * x21)
    out[..., 2] = (
        A_phi_1 * x33 + A_phi_2 * x28 + A_phi_3 * x34 + A_phi_4 * x27 + x25 - A_phi_1 * x22
    )
    out[..., 3] = (
        A_phi_1 * x27 + A_phi_2 * x33 + A_phi_3 * x28 + A_phi_4 * x34 + x35 - A_phi_2 * x22
    )
    out[..., 4] = (
        A_phi_1 * x34 + A_phi_2 * x27 + A_phi_3 * x33 + A_phi_4 * x28 - A_phi_3 * x22 - x25
    )
    out[..., 5] = (
        A_phi_1 * x28 + A_phi_2 * x34 + A_phi_3 * x27 + A_phi_4 * x33 - A_phi_4 * x22 - x35
    )


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    omega_phi: ArrayLike,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Amplitudes grow like exp(Γ t). Where the discriminant of the quadratic in Γ is positive, the
    rate is half its root; elsewhere both modes are neutral and the rate is exactly 0.0.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_phi + omega_x + sigma, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.

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
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return evaluate(_growth_rate, arguments)


def boundaries(
    *, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike, omega_phi: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable interval of sigma.

    In closed form: the roots of a quadratic in it, between which growth_rate is positive. Order 2
    leaves out terms of the edges from ε^3 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero;
    SlowFlow.zones() gives all of them.

    Parameters
    ----------
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.

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
        PARAMETERS, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y, omega_phi=omega_phi,
    )
    return evaluate_pair(_boundaries, arguments)


def critical_speeds(
    *, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike, r_a: ArrayLike,
    omega_b: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable zone in Omega.

    Where Omega = omega_x + omega_phi + sigma lies on an edge of `boundaries`. With omega_phi =
    sqrt(Omega**2*r_a**2 + omega_b**2) this is an equation for Omega, solved to full double
    precision. Where it has several roots: first Omega without detuning is found, the smallest
    positive one (two that are closer than ten per cent may be passed over), then the nearest to
    that on the side of the edge.

    Parameters
    ----------
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_b : array_like
        Lag frequency of a blade at rest, rad/s, > 0.

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
        PARAMETERS, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y, r_a=r_a, omega_b=omega_b,
    )
    return implicit_edges(_detuning, _boundaries, arguments)


def slow_flow_matrix(
    *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_phi + omega_x + sigma, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.

    Returns
    -------
    complex128
        Shape (..., 6, 6), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (6, 6))


def characteristic_coefficients(
    *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_phi + omega_x + sigma, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.

    Returns
    -------
    complex128
        Shape (..., 7), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (7,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
    omega_x: ArrayLike, omega_y: ArrayLike, omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = omega_phi + omega_x + sigma, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.

    Returns
    -------
    complex128
        Shape (..., 6), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 6), *arguments], (6,))
