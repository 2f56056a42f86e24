# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 3d84bf09d87ac4e2ff9edaf1f17c3e112366ca03fbe6f79918d49a713729f82b
# Operations for each point: growth_rate 75, slow_flow_matrix 88, characteristic_coefficients 105,
# slow_flow 147, motion 134
"""ground_resonance: Omega = omega_y - omega_phi + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

It cannot be unstable: the discriminant of Gamma**2 - I*Gamma*sigma +
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
RELATIONS: tuple[str, ...] = ("Omega = omega_y - omega_phi + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = -omega_phi + omega_y + sigma"),
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
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
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
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
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
        (2, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
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
        (2, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
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
        (2, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
    ),
    1,
)


def _growth_rate(sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = 1 / omega_phi
    x1 = omega_y * omega_y
    x2 = omega_y * x1
    x3 = x0 * x2
    x4 = r_b * r_m
    x5 = omega_phi * omega_phi
    x6 = x1 / x5
    x7 = omega_x + omega_y
    x8 = -omega_y
    x9 = omega_x + x8
    x10 = -omega_phi - x8
    x11 = 6 * omega_phi
    x12 = sigma * sigma
    x13 = x1 * x1
    x14 = x9 * x9
    x15 = x10 * x10
    x16 = x7 * x7
    x17 = x5 * x5
    x18 = r_b * r_b
    x19 = r_m * r_m
    x20 = omega_x * omega_x
    x21 = 2 * x20
    x22 = x1 * x20 + x11 * x2 + x21 * x5 - omega_phi * omega_y * x21 - 6 * x1 * x5 - x13
    x23 = x22 * x22
    # Outputs
    discriminant_1 = (
        r_b * r_m * sigma * (1 / 2 * x0 * x2 / x9 - 1 / 2 * x3 / x7
        - 1 / 4 * x6 * (omega_y * x11 + x1 - 8 * x5) / x10) - 3 / 4 * x12 * x4 * x6 - x12
        - 1 / 64 * x13 * x18 * x19 * x23 / (x14 * x15 * x16 * x17) - x3 * x4
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
    x7 = x4 * x6
    x8 = -omega_y
    x9 = omega_x + x8
    x10 = 1 / x9
    x11 = 1 / (x5 + x9)
    x12 = x10 * x11
    x13 = r_b * r_m
    x14 = omega_phi + x8
    x15 = -1 / x14
    x16 = 1 / omega_phi
    x17 = omega_y * omega_y
    x18 = x16 * x17
    x19 = 1 / 4 * omega_y * r_m + 3 / 8 * r_m * sigma
    x20 = -x19
    x21 = omega_phi * omega_phi
    x22 = 1 / x21
    x23 = 1 / 8 * r_b * sigma * x17 * x22 + 1 / 4 * r_b * x18
    x24 = -x23
    x25 = omega_y * x17
    x26 = omega_phi * x21
    x27 = (
        1 / 4 * omega_phi * x0 + 19 / 32 * omega_phi * x17 + 31 / 32 * x26 - 33 / 32 * omega_y * x21
        - 1 / 16 * x25
    )
    x28 = 1 / 32 * x15
    x29 = 1 / 16 * x1 * x16
    x30 = x10 * x29 + x11 * x29 + x21 * x28 + x29 * x4 + x29 * x6
    x31 = sigma + x13 * (x22 * x27 - x30)
    x32 = 1 / 8 * x1
    x33 = x12 * x32 + x14 + 3 / 32 * x18 - x17 * x28 - x32 * x7
    x34 = x13 * x33
    x35 = x13 * (x30 - x22 * x27)
    x36 = -x13 * x33
    # Outputs
    out[..., 0, 0].imag = x13 * (x12 * x2 + x2 * x7)
    out[..., 1, 1].imag = 1 / 8 * x13 * x15 * x18 * (3 * omega_y - x5)
    out[..., 1, 2].imag = x20
    out[..., 1, 3].real = x19
    out[..., 1, 4].imag = x19
    out[..., 1, 5].real = x20
    out[..., 2, 1].imag = x24
    out[..., 2, 2].imag = x31
    out[..., 2, 3].real = x34
    out[..., 2, 4].imag = x35
    out[..., 2, 5].real = x36
    out[..., 3, 1].real = x24
    out[..., 3, 2].real = x36
    out[..., 3, 3].imag = x31
    out[..., 3, 4].real = x34
    out[..., 3, 5].imag = x35
    out[..., 4, 1].imag = x23
    out[..., 4, 2].imag = x35
    out[..., 4, 3].real = x36
    out[..., 4, 4].imag = x31
    out[..., 4, 5].real = x34
    out[..., 5, 1].real = x23
    out[..., 5, 2].real = x34
    out[..., 5, 3].imag = x35
    out[..., 5, 4].real = x36
    out[..., 5, 5].imag = x31


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
    x12 = -sigma
    x13 = 1 / 4 / omega_phi
    x14 = omega_y * omega_y
    x15 = omega_y * x14
    x16 = x13 * x15
    x17 = omega_phi * omega_y
    x18 = 1 / (-omega_phi - x7)
    x19 = 1 / 8 * x18
    x20 = omega_phi * omega_phi
    x21 = 1 / x20
    x22 = x14 * x21
    x23 = x19 * x22
    x24 = omega_phi * x4
    x25 = omega_phi * x20
    x26 = sigma * sigma
    x27 = x14 * x14
    x28 = r_b * r_b
    x29 = r_m * r_m
    x30 = x13 * x5
    # Outputs
    c1_0 = 1j * x11 * (-x1 * x3 * x6 - x10 * x6 * x9)
    c2_1 = 1j * (x11 * (x16 * x9 + x23 * (x14 + 6 * x20 - 8 * x17) - x1 * x16) + x12)
    c2_0 = (
        sigma * x11 * x23 * (x14 - x17 - x20) + 1 / 64 * x1 * x18 * x27 * x28 * x29 * x9 * (3
        * omega_y - x2) * (8 * omega_phi * x14 + omega_y * x4 - x15 - 4 * x24) / x25 + x11 * x16
        + 3 / 16 * x11 * x22 * x26
    )
    c3_0 = -1j * sigma
    c4_0 = (
        1j * (x11 * (x10 * x30 + x19 * x20 + x21 * (33 / 8 * omega_y * x20 + 1 / 8 * x15 - 11 / 8
        * omega_phi * x14 - 1 / 2 * x24 - 31 / 8 * x25) + x3 * x30) + x12)
    )
    multiply_out(out, ((c1_0,), 1), ((c2_1, c2_0), 1), ((c3_0,), 2), ((c4_0,), 1))


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
    x13 = 1 / x11
    x14 = x13 * x4
    x15 = 1 / 8 * r_m * (2 * omega_y + 3 * sigma)
    x16 = 1j * x15
    x17 = -omega_phi - x10
    x18 = 1 / x17
    x19 = 1 / omega_phi
    x20 = omega_y * omega_y
    x21 = x20 * x7
    x22 = 1 / 8 * A_y
    x23 = 1j * sigma
    x24 = omega_phi * omega_phi
    x25 = 1 / x24
    x26 = r_b * x20 * x22 * x25 * (sigma + x0)
    x27 = 1j * x26
    x28 = 1 / 32 * x18
    x29 = (
        x17 * x7 + x21 * x28 + 1 / 8 * x6 * x7 - 1 / 8 * r_b * r_m * x12 * x13 * x4
        - 3 / 32 * r_b * r_m * x19 * x20
    )
    x30 = -x29
    x31 = 1 / 16 * x19 * x8
    x32 = x31 * x4
    x33 = omega_phi * x24
    x34 = omega_y * x20
    x35 = (
        x12 * x32 + x14 * x31 + x2 * x32 + x24 * x28 * x8 + 1 / 32 * x25 * x8 * (33 * omega_y * x24
        + 2 * x34 - 19 * omega_phi * x20 - 8 * omega_phi * x3 - 31 * x33) + x31 * x5
    )
    x36 = -x35
    # Outputs
    out[..., 0] = A_x * (x12 * x14 * x9 + x6 * x9)
    out[..., 1] = (
        A_phi_2 * x15 + A_phi_3 * x16 + 1j * x18 * x19 * x21 * x22 * (3 * omega_y - x0)
        - A_phi_1 * x16 - A_phi_4 * x15
    )
    out[..., 2] = (
        A_phi_1 * x23 + A_phi_1 * x36 + A_phi_2 * x30 + A_phi_3 * x35 + A_phi_4 * x29 - x27
    )
    out[..., 3] = (
        A_phi_1 * x29 + A_phi_2 * x23 + A_phi_2 * x36 + A_phi_3 * x30 + A_phi_4 * x35 - x26
    )
    out[..., 4] = (
        A_phi_1 * x35 + A_phi_2 * x29 + A_phi_3 * x23 + A_phi_3 * x36 + A_phi_4 * x30 + x27
    )
    out[..., 5] = (
        A_phi_1 * x30 + A_phi_2 * x35 + A_phi_3 * x29 + A_phi_4 * x23 + A_phi_4 * x36 + x26
    )


def _motion(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = 2 * omega_phi
    x1 = -omega_y
    x2 = x0 + x1
    x3 = -x2
    x4 = x3 * x3
    x5 = r_m * x4
    x6 = omega_x + omega_y
    x7 = x6 - x0
    x8 = 1 / x7
    x9 = omega_x + x2
    x10 = 1 / x9
    x11 = x10 * x8
    x12 = x11 * x5
    x13 = omega_y * omega_y
    x14 = r_m * x13
    x15 = 1 / x6
    x16 = omega_x + x1
    x17 = 1 / x16
    x18 = x15 * x17
    x19 = x14 * x18
    x20 = 1j * x12
    x21 = 1j * x19
    x22 = 1 / omega_phi
    x23 = -omega_phi - x1
    x24 = 1 / x23
    x25 = 1 / 4 * x24
    x26 = x22 * x25 * x5
    x27 = 1j * x26
    x28 = omega_y * r_b
    x29 = x25 * x28
    x30 = omega_x * omega_x
    x31 = r_b * x30
    x32 = x10 * x17 * x31
    x33 = 1j * x32
    x34 = x15 * x31 * x8
    x35 = 1j * x34
    x36 = 1j * x29
    x37 = x7 * x7
    x38 = 1 / x37
    x39 = r_m * sigma
    x40 = x9 * x9
    x41 = 2 / x40
    x42 = x3 * x30 * x38 * x39 * x41
    x43 = x6 * x6
    x44 = 1 / x43
    x45 = x16 * x16
    x46 = 1 / x45
    x47 = x44 * x46
    x48 = 2 * omega_y * x30 * x39 * x47
    x49 = 1j * x42
    x50 = 1j * x48
    x51 = r_m * x22
    x52 = 1j * x47
    x53 = r_m * x18
    x54 = 1j * x53
    x55 = omega_y * x13
    x56 = x23 * x23
    x57 = 1 / x56
    x58 = 1 / 8 * sigma
    x59 = omega_phi * omega_phi
    x60 = x14 * x3 * x57 * x58 / x59
    x61 = 1j * x60
    x62 = x30 * x30
    x63 = omega_x * x62
    x64 = r_b * x57
    x65 = x3 * x4
    x66 = 1 / 32 * x11 * x16 * x51 * x6 * x64 * x65
    x67 = 1j * x66
    x68 = -x67
    x69 = 1 / 32 * x28 * x57 * (2 * omega_y * x30 + 2 * x55 - omega_phi * x13 - 3 * omega_phi * x30)
    x70 = x54 * x69
    x71 = -x70
    x72 = x53 * x69
    x73 = -x72
    x74 = -x66
    x75 = x58 * x64 * (2 * omega_y - omega_phi)
    x76 = sigma * x31
    x77 = x41 * x46 * x76 * (omega_phi + x16)
    x78 = 1j * x77
    x79 = -omega_phi
    x80 = 2 * x38 * x44 * x76 * (x6 + x79)
    x81 = 1j * x80
    x82 = 1j * x75
    x83 = omega_phi - sigma
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = x12
    out[..., 7] = x19
    out[..., 8] = x20
    out[..., 9] = -x21
    out[..., 10] = -x12
    out[..., 11] = -x19
    out[..., 12] = -x20
    out[..., 13] = x21
    out[..., 14] = x27
    out[..., 15] = -x26
    out[..., 16] = -x27
    out[..., 17] = x26
    out[..., 18] = -x29
    out[..., 19] = x33
    out[..., 20] = -x35
    out[..., 21] = -x36
    out[..., 22] = x32
    out[..., 23] = x34
    out[..., 24] = x29
    out[..., 25] = -x33
    out[..., 26] = x35
    out[..., 27] = x36
    out[..., 28] = -x32
    out[..., 29] = -x34
    out[..., 30] = x42
    out[..., 31] = x48
    out[..., 32] = x49
    out[..., 33] = -x50
    out[..., 34] = -x42
    out[..., 35] = -x48
    out[..., 36] = -x49
    out[..., 37] = x50
    out[..., 38] = 1 / 2 * r_b * x24 * x54 * x55 - 2 * x31 * x51 * x52 * x55
    out[..., 39] = x61
    out[..., 40] = -x60
    out[..., 41] = -x61
    out[..., 42] = x60
    out[..., 43] = -8 * r_b * r_m * x11 * x23 * x52 * x63
    out[..., 44] = x68
    out[..., 45] = x71
    out[..., 46] = x66
    out[..., 47] = x73
    out[..., 48] = x67
    out[..., 49] = x70
    out[..., 50] = x74
    out[..., 51] = x72
    out[..., 52] = x75
    out[..., 53] = x78
    out[..., 54] = x81
    out[..., 55] = x74
    out[..., 56] = x72
    out[..., 57] = x68
    out[..., 58] = x71
    out[..., 59] = x66
    out[..., 60] = x73
    out[..., 61] = x67
    out[..., 62] = x70
    out[..., 63] = x82
    out[..., 64] = x77
    out[..., 65] = -x80
    out[..., 66] = x67
    out[..., 67] = x70
    out[..., 68] = x74
    out[..., 69] = x72
    out[..., 70] = x68
    out[..., 71] = x71
    out[..., 72] = x66
    out[..., 73] = x73
    out[..., 74] = -x75
    out[..., 75] = -x78
    out[..., 76] = -x81
    out[..., 77] = x66
    out[..., 78] = x73
    out[..., 79] = x67
    out[..., 80] = x70
    out[..., 81] = x74
    out[..., 82] = x72
    out[..., 83] = x68
    out[..., 84] = x71
    out[..., 85] = -x82
    out[..., 86] = -x77
    out[..., 87] = x80
    out[..., 88] = omega_x
    out[..., 89] = omega_y
    out[..., 90] = x83
    out[..., 91] = x83
    out[..., 92] = x83
    out[..., 93] = x83
    out[..., 94] = omega_y + sigma + x79


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
        Detuning, Omega = -omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = -omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = -omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = -omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = -omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = -omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = -omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = -omega_phi + omega_y + sigma, rad/s, real.
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
