# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 f04832a403244425b501981cd5c6c6be98e4f2383ddca4f7d3468ba9cbc287c6
# Operations for each point: growth_rate 12, boundaries 53, detuning 9, slow_flow_matrix 7,
# characteristic_coefficients 15, slow_flow 46, motion 16
"""ground_resonance: Omega = omega_x + omega_phi + sigma_1 and omega_y = omega_x + sigma_2, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

Stability depends: the sign of the discriminant of Gamma**3 + I*Gamma**2*(-sigma_1 - sigma_2) +
Gamma*(-omega_phi*sigma_1*sigma_2 - omega_x**3*r_b*r_m/2)/omega_phi +
I*omega_x**3*r_b*r_m*sigma_2/(4*omega_phi), of degree 4, decides.

Source: Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._edges import implicit_edges, zone
from .._evolution import Linear, evolution_at
from .._growth import conservative_growth
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
    "response",
    "slow_flow",
    "slow_flow_matrix",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = (
    "Omega = omega_x + omega_phi + sigma_1", "omega_y = omega_x + sigma_2",
)

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma_1": ("real", "rad/s", "detuning, Omega = omega_phi + omega_x + sigma_1"),
    "sigma_2": ("real", "rad/s", "detuning, omega_y = omega_x + sigma_2"),
    "r_m": ("positive", "m", "static moment of a blade over the mass of the helicopter"),
    "r_b": ("positive", "1/m", "static moment of a blade over its inertia about the hinge"),
    "omega_x": ("positive", "rad/s", "longitudinal frequency of the fuselage"),
    "omega_phi": ("positive", "rad/s", "lag frequency of a blade at speed"),
    "omega_y": ("positive", "rad/s", "lateral frequency of the fuselage"),
    "r_a": ("positive", "1", "lag frequency per rotor speed of a blade without lag spring"),
    "omega_b": ("positive", "rad/s", "lag frequency of a blade at rest"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
    "y": {},
    "phi_1": {"sigma_1": 1},
    "phi_2": {"sigma_1": 1},
    "phi_3": {"sigma_1": 1},
    "phi_4": {"sigma_1": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = (
    "A_x", "A_y", "conj(A_phi_1)", "conj(A_phi_2)", "conj(A_phi_3)", "conj(A_phi_4)",
)


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    6,
    (
        ((0, 0), (1, 0), (2, 1), (3, 1), (4, 1), (5, 1)),
    ),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    6,
    (
        (0, 0, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (0, 1, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (0, 2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (0, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (0, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (0,)),
        (0, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
    ),
    1,
)


def _growth_rate(sigma_1, sigma_2, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = omega_x * omega_x
    x1 = omega_x * x0
    x2 = r_b * r_m * x1 / omega_phi
    # Outputs
    coefficient_1 = -1 / 4 * sigma_2 * x2
    coefficient_2 = sigma_1 * sigma_2 + 1 / 2 * x2
    coefficient_3 = -sigma_1 - sigma_2
    return conservative_growth(coefficient_1, coefficient_2, coefficient_3)


def _boundaries(sigma_2, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = 1 / omega_phi
    x1 = omega_x * omega_x
    x2 = omega_x * x1
    x3 = r_b * r_m * x0 * x2
    x4 = omega_phi * omega_phi
    x5 = 1 / x4
    x6 = x1 * x1
    x7 = x1 * x6
    x8 = r_b * r_b
    x9 = r_m * r_m
    x10 = x5 * x7 * x8 * x9
    x11 = sigma_2 * sigma_2
    x12 = x11 * x11
    x13 = omega_phi * x4
    x14 = x6 * x6
    x15 = omega_x * x14
    x16 = r_b * x8
    x17 = r_m * x9
    x18 = sigma_2 * x11
    # Outputs
    p0 = x12 * x3 + 1 / 2 * x15 * x16 * x17 / x13 - 13 / 16 * x10 * x11
    p1 = 1 / 4 * sigma_2 * x5 * x7 * x8 * x9 - 5 / 2 * x18 * x3
    p2 = 5 / 2 * r_b * r_m * x0 * x11 * x2 - 1 / 4 * x10 - x12
    p3 = 2 * x18
    p4 = -x11
    reach = 1 / 2 * omega_phi + 1 / 2 * omega_x
    return zone((p0, p1, p2, p3, p4), reach=reach)


def _detuning(Omega, r_m, r_b, omega_x, omega_y, r_a, omega_b):
    # Intermediates
    x0 = omega_b * omega_b
    x1 = Omega * Omega
    x2 = r_a * r_a
    x3 = np.sqrt(x0 + x1 * x2)
    # Outputs
    sigma_1_at_speed = Omega - omega_x - x3
    sigma_2_at_speed = omega_y - omega_x
    omega_phi_at_speed = x3
    return sigma_1_at_speed, sigma_2_at_speed, r_m, r_b, omega_x, omega_phi_at_speed


def _slow_flow_matrix(out, sigma_1, sigma_2, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = 1 / 4 * omega_x * r_m
    x1 = -x0
    x2 = omega_x * omega_x
    x3 = 1 / 4 * r_b * x2 / omega_phi
    x4 = -x3
    # Outputs
    out[..., 0, 2].real = x0
    out[..., 0, 3].imag = x0
    out[..., 0, 4].real = x1
    out[..., 0, 5].imag = x1
    out[..., 1, 1].imag = sigma_2
    out[..., 1, 2].imag = x1
    out[..., 1, 3].real = x0
    out[..., 1, 4].imag = x0
    out[..., 1, 5].real = x1
    out[..., 2, 0].real = x3
    out[..., 2, 1].imag = x3
    out[..., 2, 2].imag = sigma_1
    out[..., 3, 0].imag = x4
    out[..., 3, 1].real = x3
    out[..., 3, 3].imag = sigma_1
    out[..., 4, 0].real = x4
    out[..., 4, 1].imag = x4
    out[..., 4, 4].imag = sigma_1
    out[..., 5, 0].imag = x3
    out[..., 5, 1].real = x4
    out[..., 5, 5].imag = sigma_1


def _characteristic_coefficients(out, sigma_1, sigma_2, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = omega_x * omega_x
    x1 = omega_x * x0
    x2 = r_b * r_m * x1 / omega_phi
    # Outputs
    c1_2 = 1j * (-sigma_1 - sigma_2)
    c1_1 = -sigma_1 * sigma_2 - 1 / 2 * x2
    c1_0 = 1 / 4 * 1j * sigma_2 * x2
    c2_0 = -1j * sigma_1
    multiply_out(out, ((c1_2, c1_1, c1_0), 1), ((c2_0,), 3))


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, sigma_1, sigma_2, r_m, r_b, omega_x,
    omega_phi,
):
    # Intermediates
    x0 = 1 / 4 * omega_x * r_m
    x1 = x0 * np.conj(A_phi_1)
    x2 = x0 * np.conj(A_phi_3)
    x3 = x0 * np.conj(A_phi_2)
    x4 = x0 * np.conj(A_phi_4)
    x5 = 1j * sigma_1
    x6 = omega_x * omega_x
    x7 = 1 / 4 * r_b * x6 / omega_phi
    x8 = x7 * np.conj(A_x)
    x9 = x7 * np.conj(A_y)
    x10 = 1j * x9
    x11 = 1j * x8 + x9
    # Outputs
    out[..., 0] = x1 + 1j * x3 - x2 - 1j * x4
    out[..., 1] = 1j * A_y * sigma_2 + 1j * x2 + x3 - 1j * x1 - x4
    out[..., 2] = x8 - A_phi_1 * x5 - x10
    out[..., 3] = x11 - A_phi_2 * x5
    out[..., 4] = x10 - A_phi_3 * x5 - x8
    out[..., 5] = -A_phi_4 * x5 - x11


def _motion(out, sigma_1, sigma_2, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = omega_phi + omega_x
    x1 = 1 / 4 / x0
    x2 = 2 * omega_phi + omega_x
    x3 = x2 * x2
    x4 = r_m * x1 * x3 / omega_phi
    x5 = -x4
    x6 = 1j * x4
    x7 = -x6
    x8 = omega_x * r_b * x1
    x9 = -x8
    x10 = 1j * x8
    x11 = -x10
    x12 = omega_phi + sigma_1
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = x5
    out[..., 7] = x6
    out[..., 8] = x4
    out[..., 9] = x7
    out[..., 10] = x6
    out[..., 11] = x4
    out[..., 12] = x7
    out[..., 13] = x5
    out[..., 14] = x9
    out[..., 15] = x11
    out[..., 16] = x11
    out[..., 17] = x8
    out[..., 18] = x8
    out[..., 19] = x10
    out[..., 20] = x10
    out[..., 21] = x9
    out[..., 22] = omega_x
    out[..., 23] = omega_x
    out[..., 24] = x12
    out[..., 25] = x12
    out[..., 26] = x12
    out[..., 27] = x12
    out[..., 28] = sigma_1 + x0


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike,
    omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    The polynomial of the undamped modes is real in Λ, Γ = iΛ; the eigenvalues of its companion
    matrix are exactly real where the modes are neutral, so that the rate is exactly 0.0 there.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, Omega = omega_phi + omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_y = omega_x + sigma_2, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("sigma_1", "sigma_2", "r_m", "r_b", "omega_x", "omega_phi") if gradient else (),
    )


def boundaries(
    *, sigma_2: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_phi: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Both edges of the unstable interval of sigma_1.

    The interval of sigma_1 in which growth_rate is positive: where one of the polynomials with the
    coefficients in `_boundaries` (lowest power first) is. Infinite where the interval has no end.
    Order 1 leaves out terms of the edges from ε^2 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero, and
    none that begins farther from it than omega_phi/2 + omega_x/2, half of the frequencies that
    resonate; SlowFlow.zones() gives all of them.

    Parameters
    ----------
    sigma_2 : array_like
        Detuning, omega_y = omega_x + sigma_2, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
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
        PARAMETERS, sigma_2=sigma_2, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_phi=omega_phi,
    )
    return boundaries_at(
        evaluate_pair,
        _boundaries,
        arguments,
        ("sigma_2", "r_m", "r_b", "omega_x", "omega_phi") if gradient else (),
    )


def critical_speeds(
    *, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike, r_a: ArrayLike,
    omega_b: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable zone in Omega.

    Where Omega = omega_x + omega_phi + sigma_1 lies on an edge of `boundaries`. With omega_phi =
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
        PARAMETERS, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y, r_a=r_a, omega_b=omega_b,
    )
    return implicit_edges(
        _detuning,
        _boundaries,
        arguments,
        ("r_m", "r_b", "omega_x", "omega_y", "r_a", "omega_b") if gradient else (),
    )


def slow_flow_matrix(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike,
    omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, Omega = omega_phi + omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_y = omega_x + sigma_2, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (6, 6))


def characteristic_coefficients(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike,
    omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, Omega = omega_phi + omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_y = omega_x + sigma_2, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (7,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, r_m: ArrayLike,
    r_b: ArrayLike, omega_x: ArrayLike, omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES.
    sigma_1 : array_like
        Detuning, Omega = omega_phi + omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_y = omega_x + sigma_2, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 6), *arguments], (6,))


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike,
    r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_phi: ArrayLike,
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
        Those at t = 0, shape (..., 6), in the order of COORDINATES.
    sigma_1 : array_like
        Detuning, Omega = omega_phi + omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_y = omega_x + sigma_2, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.

    Returns
    -------
    complex128
        Shape (..., 6), complex128, in the unit of the amplitudes.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, r_m: ArrayLike,
    r_b: ArrayLike, omega_x: ArrayLike, omega_phi: ArrayLike,
) -> Beating:
    """How amplitudes beat: period and largest modulus, from those at t = 0.

    Closed forms where no mode decays: the sum of the moduli of the parts in each eigenvalue, which
    is the least upper bound of |B_j| unless three or more frequencies are commensurable. Else a
    maximum that is searched for in time.

    Parameters
    ----------
    amplitudes : array_like
        Those at t = 0, shape (..., 6), in the order of COORDINATES.
    sigma_1 : array_like
        Detuning, Omega = omega_phi + omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_y = omega_x + sigma_2, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.

    Returns
    -------
    Beating
        period (s), largest, margin, each of shape (..., 6). The period is NaN unless exactly two
        frequencies take part; largest is infinite where the amplitude grows without bound; margin
        is how much too small it may be, 0 for closed forms.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike,
    r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_phi: ArrayLike,
    order: int | None = None, gradient: bool = False,
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
        Shape (..., 6), in the order of COORDINATES; NaN gives NaN.
    sigma_1 : array_like
        Detuning, Omega = omega_phi + omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_y = omega_x + sigma_2, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 1; all by default.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 6), in the order x, y, phi_1, phi_2, phi_3, phi_4; with gradient this and name
        -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=("sigma_1", "sigma_2", "r_m", "r_b", "omega_x", "omega_phi") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, r_m: ArrayLike,
    r_b: ArrayLike, omega_x: ArrayLike, omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at t = 0 of the motion with given coordinates and velocities there.

    The solution of response(0, amplitudes) = q, and of its derivative along slow_flow = v, that
    goes over into that of order zero as the small parameters go to zero.

    Parameters
    ----------
    q : array_like
        Coordinates at t = 0, shape (..., 6), in the order of COORDINATES.
    v : array_like
        Velocities at t = 0, shape (..., 6), per second.
    sigma_1 : array_like
        Detuning, Omega = omega_phi + omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, omega_y = omega_x + sigma_2, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.

    Returns
    -------
    complex128
        Shape (..., 6), complex128; NaN where there is none near that of order zero, as far outside
        of the scaling, or where a harmonic resonates itself.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 6, False))
