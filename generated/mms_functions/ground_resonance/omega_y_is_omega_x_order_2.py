# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 d50074172c69f002876beacea543b061c00f705a00fa8294621451a98d23fc24
# Operations for each point: growth_rate 31, slow_flow_matrix 63, characteristic_coefficients 47,
# slow_flow 105, motion 62
"""ground_resonance: omega_y = omega_x + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

It cannot be unstable: the discriminant of a factor of degree 2 in Gamma is negative at every
detuning, the modes only exchange energy; one mode turns without growing.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: Omega + omega_phi - omega_x, Omega - omega_phi + omega_x, Omega -
omega_phi - omega_x.

Source: Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
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
RELATIONS: tuple[str, ...] = ("omega_y = omega_x + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, omega_y = omega_x + sigma"),
    "Omega": ("positive", "rad/s", "rotor speed"),
    "r_m": ("positive", "m", "static moment of a blade over the mass of the helicopter"),
    "r_b": ("positive", "1/m", "static moment of a blade over its inertia about the hinge"),
    "omega_x": ("positive", "rad/s", "longitudinal frequency of the fuselage"),
    "omega_phi": ("positive", "rad/s", "lag frequency of a blade at speed"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
    "y": {},
    "phi_1": {},
    "phi_2": {},
    "phi_3": {},
    "phi_4": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x", "A_y", "A_phi_1", "A_phi_2", "A_phi_3", "A_phi_4")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    6,
    (
        ((0, 0), (1, 0)), ((2, 0), (3, 0), (4, 0), (5, 0)),
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
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
    ),
    1,
)


def _growth_rate(sigma, Omega, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = sigma * sigma
    x1 = Omega * Omega
    x2 = omega_x * omega_x
    x3 = x2 * x2
    x4 = x3 * x3
    x5 = r_b * r_b
    x6 = r_m * r_m
    x7 = Omega + omega_phi
    x8 = omega_x + x7
    x9 = x8 * x8
    x10 = x7 - omega_x
    x11 = x10 * x10
    x12 = Omega + omega_x - omega_phi
    x13 = x12 * x12
    x14 = Omega - omega_phi - omega_x
    x15 = x14 * x14
    # Outputs
    discriminant_1 = -x0 - 16 * x1 * x4 * x5 * x6 / (x11 * x13 * x15 * x9)
    return growing(discriminant_1)


def _slow_flow_matrix(out, sigma, Omega, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = Omega + omega_x
    x1 = 1 / (x0 - omega_phi)
    x2 = Omega - omega_x
    x3 = 1 / (omega_phi + x2)
    x4 = 1 / (omega_phi + x0)
    x5 = 1 / (Omega - omega_phi - omega_x)
    x6 = r_b * r_m
    x7 = x1 * x3 * x4 * x5 * x6
    x8 = omega_x * omega_x
    x9 = omega_x * x8
    x10 = Omega * Omega
    x11 = omega_phi * omega_phi
    x12 = x7 * x9 * (x10 + x8 - x11)
    x13 = Omega * x7
    x14 = x8 * x8
    x15 = 2 * x13 * x14
    x16 = 1 / x0
    x17 = 1 / 8 * x9
    x18 = x16 * x17
    x19 = 1 / x2
    x20 = x17 * x19
    x21 = x10 * x10
    x22 = (
        1 / 2 * omega_phi + x18 * x4 + x20 * x5 + 1 / 2 * x16 * x19 * x21 / omega_phi - x1 * x18
        - x20 * x3
    )
    x23 = x22 * x6
    x24 = 2 * x10
    x25 = x11 * x11
    x26 = x13 * (x21 + x25 - x11 * x24 - 2 * x11 * x8 - x24 * x8)
    x27 = -x26
    x28 = -x22 * x6
    # Outputs
    out[..., 0, 0].imag = x12
    out[..., 0, 1].real = -x15
    out[..., 1, 0].real = x15
    out[..., 1, 1].imag = sigma + x12
    out[..., 2, 2].imag = x23
    out[..., 2, 3].real = x27
    out[..., 2, 4].imag = x28
    out[..., 2, 5].real = x26
    out[..., 3, 2].real = x26
    out[..., 3, 3].imag = x23
    out[..., 3, 4].real = x27
    out[..., 3, 5].imag = x28
    out[..., 4, 2].imag = x28
    out[..., 4, 3].real = x26
    out[..., 4, 4].imag = x23
    out[..., 4, 5].real = x27
    out[..., 5, 2].real = x27
    out[..., 5, 3].imag = x28
    out[..., 5, 4].real = x26
    out[..., 5, 5].imag = x23


def _characteristic_coefficients(out, sigma, Omega, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = Omega - omega_phi
    x1 = 1 / ((omega_x + x0) * (Omega - omega_phi - omega_x))
    x2 = Omega + omega_phi
    x3 = 1 / ((x2 - omega_x) * (omega_x + x2))
    x4 = x1 * x3
    x5 = r_b * r_m
    x6 = omega_x * omega_x
    x7 = omega_x * x6
    x8 = Omega * Omega
    x9 = omega_phi * omega_phi
    x10 = x4 * x5 * x7 * (x6 + x8 - x9)
    x11 = x6 * x6
    x12 = x11 * x6
    x13 = r_b * r_b
    x14 = r_m * r_m
    x15 = 1j * x5 / omega_phi
    x16 = x0 * x0
    x17 = x16 * x16
    x18 = x2 * x2
    x19 = x18 * x18
    # Outputs
    c1_1 = 1j * (-sigma - 2 * x10)
    c1_0 = -sigma * x10 - x12 * x13 * x14 * x4
    c2_0 = -x1 * x15 * x17
    c3_0 = -x15 * x19 * x3
    multiply_out(out, ((c1_1, c1_0), 1), ((c2_0,), 1), ((c3_0,), 1), ((0.0,), 2))


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, sigma, Omega, r_m, r_b, omega_x, omega_phi,
):
    # Intermediates
    x0 = Omega + omega_x
    x1 = 1 / (omega_phi + x0)
    x2 = 1 / (x0 - omega_phi)
    x3 = Omega - omega_x
    x4 = 1 / (omega_phi + x3)
    x5 = 1 / (Omega - omega_phi - omega_x)
    x6 = x1 * x2 * x4 * x5
    x7 = r_b * r_m
    x8 = Omega * x6 * x7
    x9 = omega_x * omega_x
    x10 = x9 * x9
    x11 = 2 * x10 * x8
    x12 = 1j * x7
    x13 = omega_x * x9
    x14 = x12 * x13
    x15 = Omega * Omega
    x16 = omega_phi * omega_phi
    x17 = 1 / x0
    x18 = 1 / 4 * x14
    x19 = x17 * x18
    x20 = 1 / x3
    x21 = x18 * x20
    x22 = 2 * x15
    x23 = x15 * x15
    x24 = x16 * x16
    x25 = x8 * (x23 + x24 - x16 * x22 - 2 * x16 * x9 - x22 * x9)
    x26 = A_phi_4 * x25
    x27 = A_phi_2 * x25
    x28 = 1 / 2 * x12
    x29 = 1 / 8 * x14
    x30 = x17 * x29
    x31 = x20 * x29
    x32 = (
        omega_phi * x28 + x1 * x30 + x31 * x5 + x17 * x20 * x23 * x28 / omega_phi - x2 * x30
        - x31 * x4
    )
    x33 = -x32
    x34 = A_phi_1 * x25
    x35 = A_phi_3 * x25
    # Outputs
    out[..., 0] = A_x * x14 * x6 * (x15 + x9 - x16) - A_y * x11
    out[..., 1] = A_x * x11 + A_y * (1j * sigma + x1 * x19 + x19 * x2 + x21 * x4 + x21 * x5)
    out[..., 2] = A_phi_1 * x32 + A_phi_3 * x33 + x26 - x27
    out[..., 3] = A_phi_2 * x32 + A_phi_4 * x33 + x34 - x35
    out[..., 4] = A_phi_1 * x33 + A_phi_3 * x32 + x27 - x26
    out[..., 5] = A_phi_2 * x33 + A_phi_4 * x32 + x35 - x34


def _motion(out, sigma, Omega, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = Omega - omega_phi
    x1 = omega_x + x0
    x2 = 1 / x1
    x3 = Omega - omega_phi - omega_x
    x4 = 1 / x3
    x5 = x0 * x0
    x6 = r_m * x5
    x7 = x2 * x4 * x6
    x8 = -x7
    x9 = Omega + omega_phi
    x10 = omega_x + x9
    x11 = 1 / x10
    x12 = x9 - omega_x
    x13 = 1 / x12
    x14 = x9 * x9
    x15 = r_m * x14
    x16 = x11 * x13 * x15
    x17 = -x16
    x18 = 1j * x7
    x19 = -x18
    x20 = 1j * x16
    x21 = -x20
    x22 = omega_x * omega_x
    x23 = r_b * x22
    x24 = x13 * x23 * x4
    x25 = -x24
    x26 = x11 * x2 * x23
    x27 = -x26
    x28 = 1j * x24
    x29 = 1j * x26
    x30 = -x29
    x31 = -x28
    x32 = x1 * x1
    x33 = 1 / x32
    x34 = 2 * omega_x * sigma
    x35 = x3 * x3
    x36 = x34 / x35
    x37 = x33 * x36 * x6
    x38 = 1j * x37
    x39 = x12 * x12
    x40 = 1 / x39
    x41 = x10 * x10
    x42 = x34 / x41
    x43 = x15 * x40 * x42
    x44 = 1j * x43
    x45 = Omega * omega_x
    x46 = omega_phi * omega_phi
    x47 = Omega * Omega
    x48 = r_b * x36 * x40 * (x47 - x45 - x46)
    x49 = r_b * x33 * x42 * (x45 + x47 - x46)
    x50 = 1j * x48
    x51 = 1j * x49
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = x8
    out[..., 7] = x17
    out[..., 8] = x19
    out[..., 9] = x20
    out[..., 10] = x7
    out[..., 11] = x16
    out[..., 12] = x18
    out[..., 13] = x21
    out[..., 14] = x19
    out[..., 15] = x20
    out[..., 16] = x7
    out[..., 17] = x16
    out[..., 18] = x18
    out[..., 19] = x21
    out[..., 20] = x8
    out[..., 21] = x17
    out[..., 22] = x25
    out[..., 23] = x27
    out[..., 24] = x28
    out[..., 25] = x30
    out[..., 26] = x28
    out[..., 27] = x30
    out[..., 28] = x24
    out[..., 29] = x26
    out[..., 30] = x24
    out[..., 31] = x26
    out[..., 32] = x31
    out[..., 33] = x29
    out[..., 34] = x31
    out[..., 35] = x29
    out[..., 36] = x25
    out[..., 37] = x27
    out[..., 38] = -x38
    out[..., 39] = x44
    out[..., 40] = x37
    out[..., 41] = x43
    out[..., 42] = x38
    out[..., 43] = -x44
    out[..., 44] = -x37
    out[..., 45] = -x43
    out[..., 46] = -x48
    out[..., 47] = -x49
    out[..., 48] = x50
    out[..., 49] = -x51
    out[..., 50] = x48
    out[..., 51] = x49
    out[..., 52] = -x50
    out[..., 53] = x51
    out[..., 54] = omega_x
    out[..., 55] = omega_x
    out[..., 56] = omega_phi
    out[..., 57] = omega_phi
    out[..., 58] = omega_phi
    out[..., 59] = omega_phi
    out[..., 60] = Omega


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike,
    omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Amplitudes grow like exp(Γ t). Where the discriminant of the quadratic in Γ is positive, the
    rate is half its root; elsewhere both modes are neutral and the rate is exactly 0.0.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("sigma", "Omega", "r_m", "r_b", "omega_x", "omega_phi") if gradient else (),
    )


def boundaries(
    *, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_phi: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Both edges of the unstable interval of sigma.

    This case cannot be unstable for any detuning: NaN everywhere.

    Parameters
    ----------
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_phi=omega_phi,
    )
    return boundaries_at(
        evaluate_pair,
        no_edges,
        arguments,
        ("Omega", "r_m", "r_b", "omega_x", "omega_phi") if gradient else (),
    )


def critical_speeds(
    *, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_phi: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable zone in the detuned frequency: there is none.

    This case cannot be unstable for any detuning: NaN everywhere.

    Parameters
    ----------
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
    lower, upper : float64
        NaN, float64, in the shape to which the arguments broadcast.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_phi=omega_phi,
    )
    return evaluate_pair(no_edges, arguments)


def slow_flow_matrix(
    *, sigma: ArrayLike, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike,
    omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (6, 6))


def characteristic_coefficients(
    *, sigma: ArrayLike, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike,
    omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (7,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
    omega_x: ArrayLike, omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES.
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 6), *arguments], (6,))


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, r_m: ArrayLike,
    r_b: ArrayLike, omega_x: ArrayLike, omega_phi: ArrayLike,
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
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
    omega_x: ArrayLike, omega_phi: ArrayLike,
) -> Beating:
    """How amplitudes beat: period and largest modulus, from those at t = 0.

    Closed forms where no mode decays: the sum of the moduli of the parts in each eigenvalue, which
    is the least upper bound of |B_j| unless three or more frequencies are commensurable. Else a
    maximum that is searched for in time.

    Parameters
    ----------
    amplitudes : array_like
        Those at t = 0, shape (..., 6), in the order of COORDINATES.
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, r_m: ArrayLike,
    r_b: ArrayLike, omega_x: ArrayLike, omega_phi: ArrayLike, order: int | None = None,
    gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. NaN where a harmonic resonates itself. Derivatives
    are taken with these fixed. Over times of order 1/ε the error is O(ε^2). A UserWarning says how
    much is left out where that is more than a tenth of the motion, estimated from the harmonics of
    each order beside those of order zero.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    Omega : array_like
        Rotor speed, rad/s, > 0.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
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
        PARAMETERS, sigma=sigma, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=("sigma", "Omega", "r_m", "r_b", "omega_x", "omega_phi") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, r_m: ArrayLike,
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
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x,
        omega_phi=omega_phi,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 6, False))
