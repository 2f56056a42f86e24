# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 b748e110beeb8ee28d6804eb38423c57c856420808ec25314e5f0fe3584276db
# Operations for each point: growth_rate 73, slow_flow_matrix 92, characteristic_coefficients 109,
# slow_flow 151, motion 133
"""ground_resonance: Omega = omega_phi - omega_x + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

It cannot be unstable: the discriminant of Gamma**2 + I*Gamma*sigma +
omega_x**3*r_b*r_m/(4*omega_phi) is negative at every detuning, the modes only exchange energy; one
mode turns without growing.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: -2*omega_phi + omega_x + omega_y, -2*omega_phi + omega_x -
omega_y, -omega_phi + omega_x, omega_x - omega_y.

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


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    6,
    (
        ((0, 0), (2, 0), (3, 0), (4, 0), (5, 0)), ((1, 0),),
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
        (1, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
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
        (2, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
    ),
    1,
)


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


def _motion(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = 1 / omega_phi
    x1 = 2 * omega_phi
    x2 = -omega_x
    x3 = x1 + x2
    x4 = -x3
    x5 = x4 * x4
    x6 = r_m * x5
    x7 = omega_phi + x2
    x8 = -x7
    x9 = 1 / x8
    x10 = 1 / 4 * x9
    x11 = x0 * x10 * x6
    x12 = 1j * x11
    x13 = omega_x * omega_x
    x14 = r_m * x13
    x15 = omega_x + omega_y
    x16 = 1 / x15
    x17 = omega_x - omega_y
    x18 = 1 / x17
    x19 = x16 * x18
    x20 = x14 * x19
    x21 = 1j * x20
    x22 = x15 - x1
    x23 = 1 / x22
    x24 = -omega_y - x3
    x25 = 1 / x24
    x26 = x23 * x25
    x27 = x26 * x6
    x28 = 1j * x27
    x29 = omega_y * omega_y
    x30 = r_b * x29
    x31 = x16 * x23 * x30
    x32 = x18 * x25 * x30
    x33 = omega_x * r_b
    x34 = x10 * x33
    x35 = 1j * x34
    x36 = 1j * x31
    x37 = 1j * x32
    x38 = x8 * x8
    x39 = 1 / x38
    x40 = 1 / 8 * sigma
    x41 = omega_phi * omega_phi
    x42 = x14 * x39 * x4 * x40 / x41
    x43 = 1j * x42
    x44 = x15 * x15
    x45 = 1 / x44
    x46 = x17 * x17
    x47 = 1 / x46
    x48 = x45 * x47
    x49 = 1j * x48
    x50 = x29 * x29
    x51 = omega_y * x50
    x52 = r_m * sigma
    x53 = 2 * omega_x * x29 * x48 * x52
    x54 = 1j * x53
    x55 = x24 * x24
    x56 = 1 / x55
    x57 = x22 * x22
    x58 = 2 / x57
    x59 = x29 * x4 * x52 * x56 * x58
    x60 = 1j * x59
    x61 = r_m * x0
    x62 = r_m * x19
    x63 = 1j * x62
    x64 = omega_x * x13
    x65 = 1 / 32 * x33 * x39 * (2 * omega_x * x29 + 2 * x64 - omega_phi * x13 - 3 * omega_phi * x29)
    x66 = x63 * x65
    x67 = r_b * x39
    x68 = x4 * x5
    x69 = 1 / 32 * x15 * x17 * x26 * x61 * x67 * x68
    x70 = 1j * x69
    x71 = -x70
    x72 = x62 * x65
    x73 = -x72
    x74 = -x69
    x75 = -x66
    x76 = sigma * x30
    x77 = x45 * x58 * x76 * (x15 - omega_phi)
    x78 = 2 * x47 * x56 * x76 * (-omega_y - x7)
    x79 = x40 * x67 * (2 * omega_x - omega_phi)
    x80 = 1j * x79
    x81 = 1j * x77
    x82 = 1j * x78
    x83 = omega_phi + sigma
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = x11
    out[..., 7] = -x12
    out[..., 8] = -x11
    out[..., 9] = x12
    out[..., 10] = -x21
    out[..., 11] = x28
    out[..., 12] = x20
    out[..., 13] = x27
    out[..., 14] = x21
    out[..., 15] = -x28
    out[..., 16] = -x20
    out[..., 17] = -x27
    out[..., 18] = -x31
    out[..., 19] = -x32
    out[..., 20] = x35
    out[..., 21] = x36
    out[..., 22] = -x37
    out[..., 23] = x34
    out[..., 24] = x31
    out[..., 25] = x32
    out[..., 26] = -x35
    out[..., 27] = -x36
    out[..., 28] = x37
    out[..., 29] = -x34
    out[..., 30] = -x42
    out[..., 31] = x43
    out[..., 32] = x42
    out[..., 33] = -x43
    out[..., 34] = 8 * r_b * r_m * x26 * x49 * x51 * x8
    out[..., 35] = -x54
    out[..., 36] = x60
    out[..., 37] = x53
    out[..., 38] = x59
    out[..., 39] = x54
    out[..., 40] = -x60
    out[..., 41] = -x53
    out[..., 42] = -x59
    out[..., 43] = -1 / 2 * r_b * x63 * x64 * x9 - 2 * x30 * x49 * x61 * x64
    out[..., 44] = x66
    out[..., 45] = x71
    out[..., 46] = x73
    out[..., 47] = x74
    out[..., 48] = x75
    out[..., 49] = x70
    out[..., 50] = x72
    out[..., 51] = x69
    out[..., 52] = -x77
    out[..., 53] = -x78
    out[..., 54] = x80
    out[..., 55] = x72
    out[..., 56] = x69
    out[..., 57] = x66
    out[..., 58] = x71
    out[..., 59] = x73
    out[..., 60] = x74
    out[..., 61] = x75
    out[..., 62] = x70
    out[..., 63] = x81
    out[..., 64] = -x82
    out[..., 65] = x79
    out[..., 66] = x75
    out[..., 67] = x70
    out[..., 68] = x72
    out[..., 69] = x69
    out[..., 70] = x66
    out[..., 71] = x71
    out[..., 72] = x73
    out[..., 73] = x74
    out[..., 74] = x77
    out[..., 75] = x78
    out[..., 76] = -x80
    out[..., 77] = x73
    out[..., 78] = x74
    out[..., 79] = x75
    out[..., 80] = x70
    out[..., 81] = x72
    out[..., 82] = x69
    out[..., 83] = x66
    out[..., 84] = x71
    out[..., 85] = -x81
    out[..., 86] = x82
    out[..., 87] = -x79
    out[..., 88] = omega_x
    out[..., 89] = omega_y
    out[..., 90] = x83
    out[..., 91] = x83
    out[..., 92] = x83
    out[..., 93] = x83
    out[..., 94] = sigma + x7


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
