# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 bbe4c81ec25bdd665ea42dc9b245b5644dea00b121d8b4b8306848969a550899
# Operations for each point: growth_rate 73, slow_flow_matrix 91, characteristic_coefficients 105,
# slow_flow 140, motion 137
"""ground_resonance: Omega = omega_phi - omega_y + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

It cannot be unstable: the discriminant of Gamma**2 + I*Gamma*sigma +
omega_y**3*r_b*r_m/(4*omega_phi) is negative at every detuning, the modes only exchange energy; one
mode turns without growing.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: -2*omega_phi + omega_x + omega_y, -omega_phi + omega_y,
2*omega_phi + omega_x - omega_y, omega_x - omega_y.

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
RELATIONS: tuple[str, ...] = ("Omega = omega_phi - omega_y + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega_phi - omega_y + sigma"),
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
VARIABLES: tuple[str, ...] = ("A_x", "A_y", "A_phi_1", "A_phi_2", "A_phi_3", "A_phi_4")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    6,
    (
        ((0, 0),), ((1, 0), (2, 0), (3, 0), (4, 0), (5, 0)),
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
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
    ),
    1,
)


def _growth_rate(sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = omega_y * omega_y
    x1 = omega_y * x0
    x2 = x1 / omega_phi
    x3 = r_b * r_m
    x4 = omega_phi * omega_phi
    x5 = x0 / x4
    x6 = omega_x + omega_y
    x7 = 1 / 2 * x2
    x8 = -omega_y
    x9 = omega_x + x8
    x10 = -omega_phi - x8
    x11 = 6 * omega_phi
    x12 = sigma * sigma
    x13 = x0 * x0
    x14 = x9 * x9
    x15 = x10 * x10
    x16 = x6 * x6
    x17 = x4 * x4
    x18 = r_b * r_b
    x19 = r_m * r_m
    x20 = omega_x * omega_x
    x21 = 2 * x20
    x22 = x0 * x20 + x1 * x11 + x21 * x4 - omega_phi * omega_y * x21 - 6 * x0 * x4 - x13
    x23 = x22 * x22
    # Outputs
    discriminant_1 = (
        r_b * r_m * sigma * (x7 / x6 + 1 / 4 * x5 * (omega_y * x11 + x0 - 8 * x4) / x10 - x7 / x9)
        - 3 / 4 * x12 * x3 * x5 - x12 - 1 / 64 * x13 * x18 * x19 * x23 / (x14 * x15 * x16 * x17)
        - x2 * x3
    )
    return growing(discriminant_1)


def _slow_flow_matrix(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = omega_x * omega_x
    x1 = omega_x * x0
    x2 = 1 / 2 * x1
    x3 = omega_x + omega_y
    x4 = 1 / x3
    x5 = 2 * omega_phi
    x6 = 1 / (x3 - x5)
    x7 = -omega_y
    x8 = omega_x + x7
    x9 = 1 / x8
    x10 = 1 / (x5 + x8)
    x11 = x10 * x9
    x12 = r_b * r_m
    x13 = omega_phi + x7
    x14 = -1 / x13
    x15 = 1 / omega_phi
    x16 = omega_y * omega_y
    x17 = x15 * x16
    x18 = 1 / 4 * omega_y * r_m - 3 / 8 * r_m * sigma
    x19 = -x18
    x20 = omega_phi * omega_phi
    x21 = 1 / x20
    x22 = 1 / 4 * r_b * x17 - 1 / 8 * r_b * sigma * x16 * x21
    x23 = -x22
    x24 = omega_y * x16
    x25 = omega_phi * x20
    x26 = (
        1 / 4 * omega_phi * x0 + 19 / 32 * omega_phi * x16 + 31 / 32 * x25 - 33 / 32 * omega_y * x20
        - 1 / 16 * x24
    )
    x27 = 1 / 16 * x1 * x15
    x28 = x10 * x27 + 1 / 32 * x14 * x20 + x27 * x4 + x27 * x6 + x27 * x9
    x29 = x12 * (x21 * x26 - x28) - sigma
    x30 = 1 / 8 * x1 * x11 + x13 + 3 / 32 * x17 - 1 / 8 * x1 * x4 * x6 - 1 / 32 * x14 * x16
    x31 = -x12 * x30
    x32 = x12 * (x28 - x21 * x26)
    x33 = x12 * x30
    # Outputs
    out[..., 0, 0].imag = x12 * (x11 * x2 + x2 * x4 * x6)
    out[..., 1, 1].imag = 1 / 8 * x12 * x14 * x17 * (3 * omega_y - x5)
    out[..., 1, 2].imag = x19
    out[..., 1, 3].real = x19
    out[..., 1, 4].imag = x18
    out[..., 1, 5].real = x18
    out[..., 2, 1].imag = x23
    out[..., 2, 2].imag = x29
    out[..., 2, 3].real = x31
    out[..., 2, 4].imag = x32
    out[..., 2, 5].real = x33
    out[..., 3, 1].real = x22
    out[..., 3, 2].real = x33
    out[..., 3, 3].imag = x29
    out[..., 3, 4].real = x31
    out[..., 3, 5].imag = x32
    out[..., 4, 1].imag = x22
    out[..., 4, 2].imag = x32
    out[..., 4, 3].real = x33
    out[..., 4, 4].imag = x29
    out[..., 4, 5].real = x31
    out[..., 5, 1].real = x23
    out[..., 5, 2].real = x31
    out[..., 5, 3].imag = x32
    out[..., 5, 4].real = x33
    out[..., 5, 5].imag = x29


def _characteristic_coefficients(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = omega_x + omega_y
    x1 = 1 / x0
    x2 = 2 * omega_phi
    x3 = 1 / (x0 - x2)
    x4 = omega_x * omega_x
    x5 = omega_x * x4
    x6 = 1 / 2 * x5
    x7 = -omega_y
    x8 = omega_x + x7
    x9 = 1 / x8
    x10 = 1 / (x2 + x8)
    x11 = r_b * r_m
    x12 = 1 / 4 / omega_phi
    x13 = omega_y * omega_y
    x14 = omega_y * x13
    x15 = x12 * x14
    x16 = omega_phi * omega_y
    x17 = 1 / (-omega_phi - x7)
    x18 = 1 / 8 * x17
    x19 = omega_phi * omega_phi
    x20 = 1 / x19
    x21 = x13 * x20
    x22 = x18 * x21
    x23 = omega_phi * x4
    x24 = omega_phi * x19
    x25 = sigma * sigma
    x26 = x13 * x13
    x27 = r_b * r_b
    x28 = r_m * r_m
    x29 = x12 * x5
    # Outputs
    c1_0 = 1j * x11 * (-x1 * x3 * x6 - x10 * x6 * x9)
    c2_1 = 1j * (sigma + x11 * (x15 * x9 + x22 * (x13 + 6 * x19 - 8 * x16) - x1 * x15))
    c2_0 = (
        1 / 64 * x1 * x17 * x26 * x27 * x28 * x9 * (3 * omega_y - x2) * (8 * omega_phi * x13
        + omega_y * x4 - x14 - 4 * x23) / x24 + x11 * x15 + 3 / 16 * x11 * x21 * x25
        - sigma * x11 * x22 * (x13 - x16 - x19)
    )
    c3_0 = (
        1j * (sigma + x11 * (x10 * x29 + x18 * x19 + x20 * (33 / 8 * omega_y * x19 + 1 / 8 * x14
        - 11 / 8 * omega_phi * x13 - 1 / 2 * x23 - 31 / 8 * x24) + x29 * x3))
    )
    c4_0 = 1j * sigma
    multiply_out(out, ((c1_0,), 1), ((c2_1, c2_0), 1), ((c3_0,), 1), ((c4_0,), 2))


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, sigma, r_m, r_b, omega_x, omega_y, omega_phi,
):
    # Intermediates
    x0 = 2 * omega_phi
    x1 = omega_x + omega_y
    x2 = 1 / (x1 - x0)
    x3 = omega_x * omega_x
    x4 = omega_x * x3
    x5 = x4 / x1
    x6 = x2 * x5
    x7 = r_b * r_m
    x8 = 1j * x7
    x9 = 1 / 2 * x8
    x10 = -omega_y
    x11 = omega_x + x10
    x12 = 1 / (x0 + x11)
    x13 = x4 / x11
    x14 = x12 * x13
    x15 = 1 / 8 * r_m * (2 * omega_y - 3 * sigma)
    x16 = 1j * x15
    x17 = -omega_phi - x10
    x18 = 1 / x17
    x19 = 1 / omega_phi
    x20 = omega_y * omega_y
    x21 = x20 * x7
    x22 = x19 * x21
    x23 = 1 / 8 * A_y
    x24 = 1j * sigma
    x25 = omega_phi * omega_phi
    x26 = 1 / x25
    x27 = r_b * x20 * x23 * x26 * (x0 - sigma)
    x28 = 1j * x27
    x29 = 1 / 32 * x18
    x30 = 1 / 8 * x7
    x31 = x17 * x7 + x21 * x29 + x30 * x6 - x14 * x30 - 3 / 32 * x22
    x32 = -x31
    x33 = 1 / 16 * x19 * x8
    x34 = x33 * x4
    x35 = omega_phi * x25
    x36 = omega_y * x20
    x37 = (
        x12 * x34 + x13 * x33 + x2 * x34 + x25 * x29 * x8 + 1 / 32 * x26 * x8 * (33 * omega_y * x25
        + 2 * x36 - 19 * omega_phi * x20 - 8 * omega_phi * x3 - 31 * x35) + x33 * x5
    )
    x38 = -x37
    # Outputs
    out[..., 0] = A_x * (x14 * x9 + x6 * x9)
    out[..., 1] = (
        A_phi_3 * x16 + A_phi_4 * x15 + 1j * x18 * x22 * x23 * (3 * omega_y - x0) - A_phi_1 * x16
        - A_phi_2 * x15
    )
    out[..., 2] = (
        A_phi_1 * x38 + A_phi_2 * x31 + A_phi_3 * x37 + A_phi_4 * x32 - A_phi_1 * x24 - x28
    )
    out[..., 3] = (
        A_phi_1 * x32 + A_phi_2 * x38 + A_phi_3 * x31 + A_phi_4 * x37 + x27 - A_phi_2 * x24
    )
    out[..., 4] = (
        A_phi_1 * x37 + A_phi_2 * x32 + A_phi_3 * x38 + A_phi_4 * x31 + x28 - A_phi_3 * x24
    )
    out[..., 5] = (
        A_phi_1 * x31 + A_phi_2 * x37 + A_phi_3 * x32 + A_phi_4 * x38 - A_phi_4 * x24 - x27
    )


def _motion(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = omega_y * omega_y
    x1 = r_m * x0
    x2 = omega_x + omega_y
    x3 = 1 / x2
    x4 = -omega_y
    x5 = omega_x + x4
    x6 = 1 / x5
    x7 = x3 * x6
    x8 = x1 * x7
    x9 = 2 * omega_phi
    x10 = -x4 - x9
    x11 = x10 * x10
    x12 = r_m * x11
    x13 = x2 - x9
    x14 = 1 / x13
    x15 = x5 + x9
    x16 = 1 / x15
    x17 = x14 * x16
    x18 = x12 * x17
    x19 = 1j * x8
    x20 = 1j * x18
    x21 = 1 / omega_phi
    x22 = omega_phi + x4
    x23 = -x22
    x24 = 1 / x23
    x25 = 1 / 4 * x24
    x26 = x12 * x21 * x25
    x27 = 1j * x26
    x28 = omega_y * r_b
    x29 = x25 * x28
    x30 = omega_x * omega_x
    x31 = r_b * x30
    x32 = x14 * x3 * x31
    x33 = 1j * x32
    x34 = x16 * x31 * x6
    x35 = 1j * x34
    x36 = 1j * x29
    x37 = r_m * sigma
    x38 = x2 * x2
    x39 = 1 / x38
    x40 = x5 * x5
    x41 = 1 / x40
    x42 = x39 * x41
    x43 = 2 * omega_y * x30 * x37 * x42
    x44 = x15 * x15
    x45 = 1 / x44
    x46 = x13 * x13
    x47 = 2 / x46
    x48 = x10 * x30 * x37 * x45 * x47
    x49 = 1j * x43
    x50 = 1j * x48
    x51 = r_m * x7
    x52 = 1j * x51
    x53 = omega_y * x0
    x54 = x23 * x23
    x55 = 1 / x54
    x56 = 1 / 8 * sigma
    x57 = omega_phi * omega_phi
    x58 = x1 * x10 * x55 * x56 / x57
    x59 = 1j * x58
    x60 = x30 * x30
    x61 = omega_x * x60
    x62 = 1 / 32 * x28 * x55 * (2 * omega_y * x30 + 2 * x53 - omega_phi * x0 - 3 * omega_phi * x30)
    x63 = x52 * x62
    x64 = r_b * x55
    x65 = x10 * x11
    x66 = 1 / 32 * r_m * x17 * x2 * x21 * x5 * x64 * x65
    x67 = 1j * x66
    x68 = x51 * x62
    x69 = -x68
    x70 = -x63
    x71 = -x67
    x72 = -x66
    x73 = x56 * x64 * (2 * omega_y - omega_phi)
    x74 = sigma * x31
    x75 = x39 * x47 * x74 * (x2 - omega_phi)
    x76 = 1j * x75
    x77 = 2 * x41 * x45 * x74 * (omega_phi + x5)
    x78 = 1j * x77
    x79 = 1j * x73
    x80 = omega_phi + sigma
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = x8
    out[..., 7] = x18
    out[..., 8] = x19
    out[..., 9] = -x20
    out[..., 10] = -x8
    out[..., 11] = -x18
    out[..., 12] = -x19
    out[..., 13] = x20
    out[..., 14] = -x27
    out[..., 15] = -x26
    out[..., 16] = x27
    out[..., 17] = x26
    out[..., 18] = -x29
    out[..., 19] = x33
    out[..., 20] = -x35
    out[..., 21] = x36
    out[..., 22] = x32
    out[..., 23] = x34
    out[..., 24] = x29
    out[..., 25] = -x33
    out[..., 26] = x35
    out[..., 27] = -x36
    out[..., 28] = -x32
    out[..., 29] = -x34
    out[..., 30] = -x43
    out[..., 31] = -x48
    out[..., 32] = -x49
    out[..., 33] = x50
    out[..., 34] = x43
    out[..., 35] = x48
    out[..., 36] = x49
    out[..., 37] = -x50
    out[..., 38] = 2 * 1j * r_b * r_m * x21 * x30 * x39 * x41 * x53 - 1 / 2 * r_b * x24 * x52 * x53
    out[..., 39] = x59
    out[..., 40] = x58
    out[..., 41] = -x59
    out[..., 42] = -x58
    out[..., 43] = 8 * 1j * r_b * r_m * x17 * x23 * x42 * x61
    out[..., 44] = x63
    out[..., 45] = x67
    out[..., 46] = x69
    out[..., 47] = x66
    out[..., 48] = x70
    out[..., 49] = x71
    out[..., 50] = x68
    out[..., 51] = x72
    out[..., 52] = -x73
    out[..., 53] = x76
    out[..., 54] = x78
    out[..., 55] = x68
    out[..., 56] = x72
    out[..., 57] = x63
    out[..., 58] = x67
    out[..., 59] = x69
    out[..., 60] = x66
    out[..., 61] = x70
    out[..., 62] = x71
    out[..., 63] = x79
    out[..., 64] = x75
    out[..., 65] = -x77
    out[..., 66] = x70
    out[..., 67] = x71
    out[..., 68] = x68
    out[..., 69] = x72
    out[..., 70] = x63
    out[..., 71] = x67
    out[..., 72] = x69
    out[..., 73] = x66
    out[..., 74] = x73
    out[..., 75] = -x76
    out[..., 76] = -x78
    out[..., 77] = x69
    out[..., 78] = x66
    out[..., 79] = x70
    out[..., 80] = x71
    out[..., 81] = x68
    out[..., 82] = x72
    out[..., 83] = x63
    out[..., 84] = x67
    out[..., 85] = -x79
    out[..., 86] = -x75
    out[..., 87] = x77
    out[..., 88] = omega_x
    out[..., 89] = omega_y
    out[..., 90] = x80
    out[..., 91] = x80
    out[..., 92] = x80
    out[..., 93] = x80
    out[..., 94] = sigma + x22


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Amplitudes grow like exp(Γ t). Where the discriminant of the quadratic in Γ is positive, the
    rate is half its root; elsewhere both modes are neutral and the rate is exactly 0.0.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_phi - omega_y + sigma, rad/s, real.
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
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("sigma", "r_m", "r_b", "omega_x", "omega_y", "omega_phi") if gradient else (),
    )


def boundaries(
    *, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike, omega_phi: ArrayLike,
    gradient: bool = False,
) -> Any:
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
        PARAMETERS, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y, omega_phi=omega_phi,
    )
    return boundaries_at(
        evaluate_pair,
        no_edges,
        arguments,
        ("r_m", "r_b", "omega_x", "omega_y", "omega_phi") if gradient else (),
    )


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
        Detuning, Omega = omega_phi - omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_phi - omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_phi - omega_y + sigma, rad/s, real.
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


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
    omega_x: ArrayLike, omega_y: ArrayLike, omega_phi: ArrayLike,
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
        Detuning, Omega = omega_phi - omega_y + sigma, rad/s, real.
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
        Shape (..., 6), complex128, in the unit of the amplitudes.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
    omega_x: ArrayLike, omega_y: ArrayLike, omega_phi: ArrayLike,
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
        Detuning, Omega = omega_phi - omega_y + sigma, rad/s, real.
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
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
    omega_x: ArrayLike, omega_y: ArrayLike, omega_phi: ArrayLike, order: int | None = None,
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
        Detuning, Omega = omega_phi - omega_y + sigma, rad/s, real.
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
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=("sigma", "r_m", "r_b", "omega_x", "omega_y", "omega_phi") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
    omega_x: ArrayLike, omega_y: ArrayLike, omega_phi: ArrayLike,
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
        Detuning, Omega = omega_phi - omega_y + sigma, rad/s, real.
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
        Shape (..., 6), complex128; NaN where there is none near that of order zero, as far outside
        of the scaling, or where a harmonic resonates itself.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 6, False))
