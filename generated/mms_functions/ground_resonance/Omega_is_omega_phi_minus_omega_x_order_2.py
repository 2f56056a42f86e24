# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 b663d62df2299be3ba4850484ab484d0b77a8bdd5a63decfce4973fab3bba8ee
# Operations for each point: growth_rate 73, slow_flow_matrix 92, characteristic_coefficients 109,
# slow_flow 151
"""ground_resonance: Omega = omega_phi - omega_x + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

It cannot be unstable: the discriminant of Gamma**2 + I*Gamma*sigma +
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
RELATIONS: tuple[str, ...] = ("Omega = omega_phi - omega_x + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega_phi - omega_x + sigma"),
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
        r_b * r_m * sigma * (1 / 4 * x5 * (omega_x * x10 + x0 - 8 * x4) / x9 + x7 / x8 + x7 / x6)
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
    x8 = 1 / 4 * omega_x * r_m - 3 / 8 * r_m * sigma
    x9 = -x8
    x10 = omega_phi * omega_phi
    x11 = 1 / x10
    x12 = 1 / 4 * r_b * x7 - 1 / 8 * r_b * sigma * x11 * x6
    x13 = omega_x * x6
    x14 = omega_phi * x10
    x15 = omega_y * omega_y
    x16 = (
        1 / 4 * omega_phi * x15 + 19 / 32 * omega_phi * x6 + 31 / 32 * x14 - 33 / 32 * omega_x * x10
        - 1 / 16 * x13
    )
    x17 = 1 / (omega_x - omega_y)
    x18 = 1 / 16 * x5
    x19 = omega_y * x15
    x20 = x18 * x19
    x21 = 1 / (-omega_y - x0 - x3)
    x22 = omega_x + omega_y
    x23 = 1 / x22
    x24 = x19 * x23
    x25 = 1 / (x22 - x3)
    x26 = 1 / 32 * x10 * x2 + x18 * x24 + x20 * x25 - x17 * x20 - x20 * x21
    x27 = x4 * (x11 * x16 - x26) - sigma
    x28 = x17 * x19 * x21
    x29 = x1 + 1 / 8 * x28 + 3 / 32 * x7 - 1 / 8 * x19 * x23 * x25 - 1 / 32 * x2 * x6
    x30 = -x29 * x4
    x31 = x4 * (x26 - x11 * x16)
    x32 = x29 * x4
    x33 = -x12
    # Outputs
    out[..., 0, 0].imag = 1 / 8 * x2 * x4 * x7 * (3 * omega_x - x3)
    out[..., 0, 1].real = x9
    out[..., 0, 2].imag = x8
    out[..., 0, 3].real = x8
    out[..., 0, 4].imag = x9
    out[..., 1, 0].real = x12
    out[..., 1, 1].imag = x27
    out[..., 1, 2].real = x30
    out[..., 1, 3].imag = x31
    out[..., 1, 4].real = x32
    out[..., 2, 0].imag = x12
    out[..., 2, 1].real = x32
    out[..., 2, 2].imag = x27
    out[..., 2, 3].real = x30
    out[..., 2, 4].imag = x31
    out[..., 3, 0].real = x33
    out[..., 3, 1].imag = x31
    out[..., 3, 2].real = x32
    out[..., 3, 3].imag = x27
    out[..., 3, 4].real = x30
    out[..., 4, 0].imag = x33
    out[..., 4, 1].real = x30
    out[..., 4, 2].imag = x31
    out[..., 4, 3].real = x32
    out[..., 4, 4].imag = x27
    out[..., 5, 5].imag = x4 * (1 / 2 * x24 * x25 + 1 / 2 * x28)


def _characteristic_coefficients(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = omega_x + omega_y
    x1 = 1 / x0
    x2 = 1 / 4 / omega_phi
    x3 = omega_x * omega_x
    x4 = omega_x * x3
    x5 = x2 * x4
    x6 = 1 / (omega_x - omega_y)
    x7 = omega_phi * omega_phi
    x8 = 1 / x7
    x9 = -omega_x
    x10 = 1 / (-omega_phi - x9)
    x11 = omega_phi * omega_x
    x12 = r_b * r_m
    x13 = x3 * x8
    x14 = 1 / 8 * x10
    x15 = 2 * omega_phi
    x16 = omega_phi * x3
    x17 = omega_phi * x7
    x18 = omega_y * omega_y
    x19 = sigma * sigma
    x20 = x3 * x3
    x21 = r_b * r_b
    x22 = r_m * r_m
    x23 = 1 / (x0 - x15)
    x24 = omega_y * x18
    x25 = x2 * x24
    x26 = 1 / (-omega_y - x15 - x9)
    x27 = 1 / 2 * x24
    # Outputs
    c1_1 = (
        1j * (sigma + x12 * (1 / 8 * x10 * x3 * x8 * (x3 + 6 * x7 - 8 * x11) - x1 * x5 - x5 * x6))
    )
    c1_0 = (
        1 / 64 * x1 * x10 * x20 * x21 * x22 * x6 * (3 * omega_x - x15) * (4 * omega_phi * x18 + x4
        - omega_x * x18 - 8 * x16) / x17 + 3 / 16 * x12 * x13 * x19 + x12 * x5
        - sigma * x12 * x13 * x14 * (x3 - x11 - x7)
    )
    c2_0 = (
        1j * (sigma + x12 * (x14 * x7 + x23 * x25 + x8 * (33 / 8 * omega_x * x7 + 1 / 8 * x4 - 1 / 2
        * omega_phi * x18 - 11 / 8 * x16 - 31 / 8 * x17) - x25 * x26))
    )
    c3_0 = 1j * sigma
    c4_0 = 1j * x12 * (-x1 * x23 * x27 - x26 * x27 * x6)
    multiply_out(out, ((c1_1, c1_0), 1), ((c2_0,), 1), ((c3_0,), 2), ((c4_0,), 1))


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, sigma, r_m, r_b, omega_x, omega_y, omega_phi,
):
    # Intermediates
    x0 = 1 / 8 * r_m * (2 * omega_x - 3 * sigma)
    x1 = 1j * x0
    x2 = -omega_x
    x3 = -omega_phi - x2
    x4 = 1 / x3
    x5 = 2 * omega_phi
    x6 = 1 / omega_phi
    x7 = r_b * r_m
    x8 = omega_x * omega_x
    x9 = x7 * x8
    x10 = x6 * x9
    x11 = 1 / 8 * A_x
    x12 = omega_x + omega_y
    x13 = 1 / (x12 - x5)
    x14 = omega_y * omega_y
    x15 = omega_y * x14
    x16 = x15 / x12
    x17 = x13 * x16
    x18 = 1j * x7
    x19 = 1 / 2 * x18
    x20 = 1 / (-omega_y - x2 - x5)
    x21 = 1 / (omega_x - omega_y)
    x22 = x15 * x20 * x21
    x23 = 1j * sigma
    x24 = omega_phi * omega_phi
    x25 = 1 / x24
    x26 = r_b * x11 * x25 * x8 * (x5 - sigma)
    x27 = 1 / 32 * x4
    x28 = 1 / 8 * x7
    x29 = x17 * x28 + x27 * x9 + x3 * x7 - 3 / 32 * x10 - x22 * x28
    x30 = -x29
    x31 = 1 / 16 * x18 * x6
    x32 = omega_phi * x24
    x33 = omega_x * x8
    x34 = (
        x13 * x15 * x31 + x16 * x31 + x18 * x24 * x27 + 1 / 32 * x18 * x25 * (33 * omega_x * x24 + 2
        * x33 - 8 * omega_phi * x14 - 19 * omega_phi * x8 - 31 * x32)
        - 1 / 16 * 1j * r_b * r_m * x15 * x20 * x6 - 1 / 16 * 1j * r_b * r_m * x15 * x21 * x6
    )
    x35 = -x34
    x36 = 1j * x26
    # Outputs
    out[..., 0] = (
        A_phi_2 * x1 + A_phi_3 * x0 + 1j * x10 * x11 * x4 * (3 * omega_x - x5) - A_phi_1 * x0
        - A_phi_4 * x1
    )
    out[..., 1] = A_y * (x17 * x19 + x19 * x22)
    out[..., 2] = (
        A_phi_1 * x35 + A_phi_2 * x29 + A_phi_3 * x34 + A_phi_4 * x30 + x26 - A_phi_1 * x23
    )
    out[..., 3] = (
        A_phi_1 * x30 + A_phi_2 * x35 + A_phi_3 * x29 + A_phi_4 * x34 + x36 - A_phi_2 * x23
    )
    out[..., 4] = (
        A_phi_1 * x34 + A_phi_2 * x30 + A_phi_3 * x35 + A_phi_4 * x29 - A_phi_3 * x23 - x26
    )
    out[..., 5] = (
        A_phi_1 * x29 + A_phi_2 * x34 + A_phi_3 * x30 + A_phi_4 * x35 - A_phi_4 * x23 - x36
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
        Detuning, Omega = omega_phi - omega_x + sigma, rad/s, real.
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
        Detuning, Omega = omega_phi - omega_x + sigma, rad/s, real.
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
        Detuning, Omega = omega_phi - omega_x + sigma, rad/s, real.
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
        Detuning, Omega = omega_phi - omega_x + sigma, rad/s, real.
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
