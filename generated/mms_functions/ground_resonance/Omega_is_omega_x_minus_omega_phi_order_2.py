# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 ff9a30e819594884fcb32615c7aba448336480b261008557fdbf35d2976d6ec0
# Operations for each point: growth_rate 73, slow_flow_matrix 89, characteristic_coefficients 109,
# slow_flow 158
"""ground_resonance: Omega = omega_x - omega_phi + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

It cannot be unstable: the discriminant of Gamma**2 - I*Gamma*sigma +
omega_x**3*r_b*r_m/(4*omega_phi) is negative at every detuning, the modes only exchange energy; one
mode turns without growing.

No number, NaN for growth rates and edges, where a divisor vanishes, which is a further resonance
and a case of its own: -2*omega_phi + omega_x + omega_y, -2*omega_phi + omega_x - omega_y,
-omega_phi + omega_x, omega_x - omega_y.

Source: Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003
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
    "slow_flow",
    "slow_flow_matrix",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ("Omega = omega_x - omega_phi + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = -omega_phi + omega_x + sigma"),
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
    "phi_1": {"sigma": -1},
    "phi_2": {"sigma": -1},
    "phi_3": {"sigma": -1},
    "phi_4": {"sigma": -1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x", "A_phi_1", "A_phi_2", "A_phi_3", "A_phi_4", "A_y")


# --- formulas -------------------------------------------------------------------------------------


def _growth_rate(sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = omega_x * omega_x
    x1 = omega_x * x0
    x2 = x1 / omega_phi
    x3 = r_b * r_m
    x4 = omega_phi * omega_phi
    x5 = x0 / x4
    x6 = omega_x + omega_y
    x7 = 1 / 2 * x2
    x8 = omega_x - omega_y
    x9 = omega_x - omega_phi
    x10 = 6 * omega_phi
    x11 = sigma * sigma
    x12 = x0 * x0
    x13 = x9 * x9
    x14 = x6 * x6
    x15 = x8 * x8
    x16 = x4 * x4
    x17 = r_b * r_b
    x18 = r_m * r_m
    x19 = omega_y * omega_y
    x20 = 2 * x19
    x21 = omega_phi * omega_x * x20 + 6 * x0 * x4 + x12 - x0 * x19 - x1 * x10 - x20 * x4
    x22 = x21 * x21
    # Outputs
    discriminant_1 = (
        r_b * r_m * sigma * (-1 / 4 * x5 * (omega_x * x10 + x0 - 8 * x4) / x9 - x7 / x8 - x7 / x6)
        - 3 / 4 * x11 * x3 * x5 - x11 - 1 / 64 * x12 * x17 * x18 * x22 / (x13 * x14 * x15 * x16)
        - x2 * x3
    )
    return growing(discriminant_1)


def _slow_flow_matrix(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = -omega_x
    x1 = omega_phi + x0
    x2 = -1 / x1
    x3 = 2 * omega_phi
    x4 = r_b * r_m
    x5 = 1 / omega_phi
    x6 = omega_x * omega_x
    x7 = x5 * x6
    x8 = 1 / 4 * omega_x * r_m + 3 / 8 * r_m * sigma
    x9 = -x8
    x10 = omega_phi * omega_phi
    x11 = 1 / x10
    x12 = 1 / 8 * r_b * sigma * x11 * x6 + 1 / 4 * r_b * x7
    x13 = -x12
    x14 = omega_x * x6
    x15 = omega_phi * x10
    x16 = omega_y * omega_y
    x17 = (
        1 / 4 * omega_phi * x16 + 19 / 32 * omega_phi * x6 + 31 / 32 * x15 - 33 / 32 * omega_x * x10
        - 1 / 16 * x14
    )
    x18 = 1 / 32 * x2
    x19 = 1 / (omega_x - omega_y)
    x20 = 1 / 16 * x5
    x21 = omega_y * x16
    x22 = x20 * x21
    x23 = 1 / (-omega_y - x0 - x3)
    x24 = omega_x + omega_y
    x25 = x21 / x24
    x26 = 1 / (x24 - x3)
    x27 = x10 * x18 + x20 * x25 + x22 * x26 - x19 * x22 - x22 * x23
    x28 = sigma + x4 * (x11 * x17 - x27)
    x29 = x25 * x26
    x30 = x19 * x21 * x23
    x31 = x1 + 1 / 8 * x30 + 3 / 32 * x7 - x18 * x6 - 1 / 8 * x29
    x32 = x31 * x4
    x33 = x4 * (x27 - x11 * x17)
    x34 = -x31 * x4
    # Outputs
    out[..., 0, 0].imag = 1 / 8 * x2 * x4 * x7 * (3 * omega_x - x3)
    out[..., 0, 1].real = x8
    out[..., 0, 2].imag = x8
    out[..., 0, 3].real = x9
    out[..., 0, 4].imag = x9
    out[..., 1, 0].real = x13
    out[..., 1, 1].imag = x28
    out[..., 1, 2].real = x32
    out[..., 1, 3].imag = x33
    out[..., 1, 4].real = x34
    out[..., 2, 0].imag = x12
    out[..., 2, 1].real = x34
    out[..., 2, 2].imag = x28
    out[..., 2, 3].real = x32
    out[..., 2, 4].imag = x33
    out[..., 3, 0].real = x12
    out[..., 3, 1].imag = x33
    out[..., 3, 2].real = x34
    out[..., 3, 3].imag = x28
    out[..., 3, 4].real = x32
    out[..., 4, 0].imag = x13
    out[..., 4, 1].real = x32
    out[..., 4, 2].imag = x33
    out[..., 4, 3].real = x34
    out[..., 4, 4].imag = x28
    out[..., 5, 5].imag = x4 * (1 / 2 * x29 + 1 / 2 * x30)


def _characteristic_coefficients(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = -sigma
    x1 = omega_x + omega_y
    x2 = 1 / x1
    x3 = 1 / 4 / omega_phi
    x4 = omega_x * omega_x
    x5 = omega_x * x4
    x6 = x3 * x5
    x7 = 1 / (omega_x - omega_y)
    x8 = omega_phi * omega_phi
    x9 = 1 / x8
    x10 = -omega_x
    x11 = 1 / (-omega_phi - x10)
    x12 = omega_phi * omega_x
    x13 = r_b * r_m
    x14 = x4 * x9
    x15 = 1 / 8 * x11
    x16 = 2 * omega_phi
    x17 = omega_phi * x4
    x18 = omega_phi * x8
    x19 = omega_y * omega_y
    x20 = sigma * sigma
    x21 = x4 * x4
    x22 = r_b * r_b
    x23 = r_m * r_m
    x24 = 1 / (x1 - x16)
    x25 = omega_y * x19
    x26 = x25 * x3
    x27 = 1 / (-omega_y - x10 - x16)
    x28 = 1 / 2 * x25
    # Outputs
    c1_1 = 1j * (x0 + x13 * (1 / 8 * x11 * x4 * x9 * (x4 + 6 * x8 - 8 * x12) - x2 * x6 - x6 * x7))
    c1_0 = (
        sigma * x13 * x14 * x15 * (x4 - x12 - x8) + 1 / 64 * x11 * x2 * x21 * x22 * x23 * x7 * (3
        * omega_x - x16) * (4 * omega_phi * x19 + x5 - omega_x * x19 - 8 * x17) / x18
        + 3 / 16 * x13 * x14 * x20 + x13 * x6
    )
    c2_0 = -1j * sigma
    c3_0 = (
        1j * (x0 + x13 * (x15 * x8 + x24 * x26 + x9 * (33 / 8 * omega_x * x8 + 1 / 8 * x5 - 1 / 2
        * omega_phi * x19 - 11 / 8 * x17 - 31 / 8 * x18) - x26 * x27))
    )
    c4_0 = 1j * x13 * (-x2 * x24 * x28 - x27 * x28 * x7)
    multiply_out(out, ((c1_1, c1_0), 1), ((c2_0,), 2), ((c3_0,), 1), ((c4_0,), 1))


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, sigma, r_m, r_b, omega_x, omega_y, omega_phi,
):
    # Intermediates
    x0 = 1 / 8 * r_m * (2 * omega_x + 3 * sigma)
    x1 = 1j * x0
    x2 = -omega_x
    x3 = -omega_phi - x2
    x4 = 1 / x3
    x5 = 2 * omega_phi
    x6 = 1 / omega_phi
    x7 = r_b * r_m
    x8 = omega_x * omega_x
    x9 = x7 * x8
    x10 = 1 / 8 * A_x
    x11 = omega_x + omega_y
    x12 = 1 / (x11 - x5)
    x13 = omega_y * omega_y
    x14 = omega_y * x13
    x15 = x14 / x11
    x16 = x12 * x15
    x17 = 1j * x7
    x18 = 1 / 2 * x17
    x19 = 1 / (-omega_y - x2 - x5)
    x20 = 1 / (omega_x - omega_y)
    x21 = 1j * sigma
    x22 = omega_phi * omega_phi
    x23 = 1 / x22
    x24 = r_b * x10 * x23 * x8 * (sigma + x5)
    x25 = 1 / 32 * x4
    x26 = (
        1 / 8 * x16 * x7 + x25 * x9 + x3 * x7 - 1 / 8 * r_b * r_m * x14 * x19 * x20
        - 3 / 32 * r_b * r_m * x6 * x8
    )
    x27 = -x26
    x28 = 1 / 16 * x17 * x6
    x29 = omega_phi * x22
    x30 = omega_x * x8
    x31 = (
        x12 * x14 * x28 + x15 * x28 + x17 * x22 * x25 + 1 / 32 * x17 * x23 * (33 * omega_x * x22 + 2
        * x30 - 8 * omega_phi * x13 - 19 * omega_phi * x8 - 31 * x29)
        - 1 / 16 * 1j * r_b * r_m * x14 * x19 * x6 - 1 / 16 * 1j * r_b * r_m * x14 * x20 * x6
    )
    x32 = -x31
    x33 = 1j * x24
    # Outputs
    out[..., 0] = (
        A_phi_1 * x0 + A_phi_2 * x1 + 1j * x10 * x4 * x6 * x9 * (3 * omega_x - x5) - A_phi_3 * x0
        - A_phi_4 * x1
    )
    out[..., 1] = A_y * (x14 * x18 * x19 * x20 + x16 * x18)
    out[..., 2] = (
        A_phi_1 * x21 + A_phi_1 * x32 + A_phi_2 * x27 + A_phi_3 * x31 + A_phi_4 * x26 - x24
    )
    out[..., 3] = (
        A_phi_1 * x26 + A_phi_2 * x21 + A_phi_2 * x32 + A_phi_3 * x27 + A_phi_4 * x31 + x33
    )
    out[..., 4] = (
        A_phi_1 * x31 + A_phi_2 * x26 + A_phi_3 * x21 + A_phi_3 * x32 + A_phi_4 * x27 + x24
    )
    out[..., 5] = (
        A_phi_1 * x27 + A_phi_2 * x31 + A_phi_3 * x26 + A_phi_4 * x21 + A_phi_4 * x32 - x33
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
        Detuning, Omega = -omega_phi + omega_x + sigma, rad/s, real.
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

    This case cannot be unstable for any detuning: NaN everywhere.

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
    return evaluate_pair(no_edges, arguments)


def critical_speeds(
    *, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike, r_a: ArrayLike,
    omega_b: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable zone in the detuned frequency: there is none.

    This case cannot be unstable for any detuning: NaN everywhere.

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
        NaN, float64, in the shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y, r_a=r_a, omega_b=omega_b,
    )
    return evaluate_pair(no_edges, arguments)


def slow_flow_matrix(
    *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = -omega_phi + omega_x + sigma, rad/s, real.
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
        Detuning, Omega = -omega_phi + omega_x + sigma, rad/s, real.
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
        Detuning, Omega = -omega_phi + omega_x + sigma, rad/s, real.
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
