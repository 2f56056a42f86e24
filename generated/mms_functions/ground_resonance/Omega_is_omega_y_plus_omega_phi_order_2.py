# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 7b6de661544a24d2d0d8bfff2e469467a5f0c50a17cef80f329953ec59143cc7
# Operations for each point: growth_rate 77, boundaries 84, detuning 8, slow_flow_matrix 91,
# characteristic_coefficients 111, slow_flow 161, motion 129
"""ground_resonance: Omega = omega_y + omega_phi + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

It can be unstable: the discriminant of Gamma**2 - I*Gamma*sigma - omega_y**3*r_b*r_m/(4*omega_phi)
is positive in an interval of the detuning.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: -2*omega_phi + omega_x - omega_y, omega_x - omega_y.

Source: Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._edges import implicit_edges
from .._evolution import Linear, evolution_at
from .._growth import growing
from .._initial import initial_at
from .._motion import Motion, response_at
from .._runtime import (
    checked,
    checked_amplitudes,
    defined,
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
RELATIONS: tuple[str, ...] = ("Omega = omega_y + omega_phi + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega_phi + omega_y + sigma"),
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
    "A_x", "A_y", "conj(A_phi_1)", "conj(A_phi_2)", "conj(A_phi_3)", "conj(A_phi_4)",
)


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    6,
    (
        ((0, 0),), ((1, 0), (2, 1), (3, 1), (4, 1), (5, 1)),
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
    x2 = omega_phi * omega_phi
    x3 = x1 / x2
    x4 = omega_x + omega_y
    x5 = omega_x - omega_y
    x6 = omega_phi + omega_y
    x7 = 6 * omega_phi
    x8 = sigma * sigma
    x9 = omega_y * x1
    x10 = x1 * x1
    x11 = x4 * x4
    x12 = x5 * x5
    x13 = x6 * x6
    x14 = x2 * x2
    x15 = r_b * r_b
    x16 = r_m * r_m
    x17 = omega_x * omega_x
    x18 = 2 * x17
    x19 = omega_phi * omega_y * x18 + x1 * x17 + x18 * x2 - 6 * x1 * x2 - x10 - x7 * x9
    x20 = x19 * x19
    # Outputs
    discriminant_1 = (
        r_b * r_m * sigma * (1 / 2 * x0 * x9 / x4 - 1 / 2 * x0 * x9 / x5
        - 1 / 4 * x3 * (x1 - omega_y * x7 - 8 * x2) / x6) + r_b * r_m * x0 * x9
        - 3 / 4 * r_b * r_m * x3 * x8 - 1 / 64 * x10 * x15 * x16 * x20 / (x11 * x12 * x13 * x14)
        - x8
    )
    return growing(discriminant_1)


def _boundaries(r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = r_b * r_m
    x1 = omega_y * omega_y
    x2 = omega_phi * omega_phi
    x3 = x1 / x2
    x4 = x0 * x3
    x5 = 3 / 2 * x4 + 2
    x6 = 1 / omega_phi
    x7 = omega_x + omega_y
    x8 = omega_x - omega_y
    x9 = omega_y * x1
    x10 = x6 * x9
    x11 = omega_phi + omega_y
    x12 = 6 * omega_phi
    x13 = 1 / 2 * x6 * x9 / x7 - 1 / 2 * x10 / x8 - 1 / 4 * x3 * (x1 - omega_y * x12 - 8 * x2) / x11
    x14 = x0 * x13 / x5
    x15 = r_b * r_b
    x16 = r_m * r_m
    x17 = x15 * x16
    x18 = x1 * x1
    x19 = x11 * x11
    x20 = x7 * x7
    x21 = x8 * x8
    x22 = x2 * x2
    x23 = omega_x * omega_x
    x24 = 2 * x23
    x25 = omega_phi * omega_y * x24 + x1 * x23 + x2 * x24 - 6 * x1 * x2 - x12 * x9 - x18
    x26 = x25 * x25
    x27 = x13 * x13
    x28 = x5 * x5
    x29 = (
        np.sqrt(x17 * x27 / x28
        + (x0 * x10 - 1 / 64 * x17 * x18 * x26 / (x19 * x20 * x21 * x22)) / (3 / 4 * x4 + 1))
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
    sigma_at_speed = Omega - omega_y - x3
    omega_phi_at_speed = x3
    return sigma_at_speed, r_m, r_b, omega_x, omega_y, omega_phi_at_speed


def _slow_flow_matrix(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = omega_x * omega_x
    x1 = omega_x * x0
    x2 = 1 / 2 * x1
    x3 = omega_x + omega_y
    x4 = 1 / x3
    x5 = 2 * omega_phi
    x6 = 1 / (x3 + x5)
    x7 = x4 * x6
    x8 = 1 / (omega_x - omega_y)
    x9 = 1 / (omega_x - omega_y - x5)
    x10 = r_b * r_m
    x11 = omega_phi + omega_y
    x12 = 1 / x11
    x13 = 1 / omega_phi
    x14 = omega_y * omega_y
    x15 = x13 * x14
    x16 = 1 / 4 * omega_y * r_m + 3 / 8 * r_m * sigma
    x17 = -x16
    x18 = omega_phi * omega_phi
    x19 = 1 / x18
    x20 = 1 / 4 * r_b * x15 - 1 / 8 * r_b * sigma * x14 * x19
    x21 = omega_y * x14
    x22 = omega_phi * x18
    x23 = (
        1 / 4 * omega_phi * x0 + 19 / 32 * omega_phi * x14 + 33 / 32 * omega_y * x18 + 1 / 16 * x21
        + 31 / 32 * x22
    )
    x24 = 1 / 32 * x12
    x25 = 1 / 16 * x1 * x13
    x26 = x25 * x4 + x25 * x6 + x25 * x8 + x25 * x9 - x18 * x24
    x27 = sigma + x10 * (x26 - x19 * x23)
    x28 = 1 / 8 * x1 * x7 + x11 + x14 * x24 + 3 / 32 * x15 - 1 / 8 * x1 * x8 * x9
    x29 = -x10 * x28
    x30 = x10 * (x19 * x23 - x26)
    x31 = x10 * x28
    x32 = -x20
    # Outputs
    out[..., 0, 0].imag = x10 * (x2 * x7 + x2 * x8 * x9)
    out[..., 1, 1].imag = -1 / 8 * x10 * x12 * x15 * (3 * omega_y + x5)
    out[..., 1, 2].imag = x17
    out[..., 1, 3].real = x16
    out[..., 1, 4].imag = x16
    out[..., 1, 5].real = x17
    out[..., 2, 1].imag = x20
    out[..., 2, 2].imag = x27
    out[..., 2, 3].real = x29
    out[..., 2, 4].imag = x30
    out[..., 2, 5].real = x31
    out[..., 3, 1].real = x20
    out[..., 3, 2].real = x31
    out[..., 3, 3].imag = x27
    out[..., 3, 4].real = x29
    out[..., 3, 5].imag = x30
    out[..., 4, 1].imag = x32
    out[..., 4, 2].imag = x30
    out[..., 4, 3].real = x31
    out[..., 4, 4].imag = x27
    out[..., 4, 5].real = x29
    out[..., 5, 1].real = x32
    out[..., 5, 2].real = x29
    out[..., 5, 3].imag = x30
    out[..., 5, 4].real = x31
    out[..., 5, 5].imag = x27


def _characteristic_coefficients(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = omega_x + omega_y
    x1 = 1 / x0
    x2 = 2 * omega_phi
    x3 = 1 / (x0 + x2)
    x4 = omega_x * omega_x
    x5 = omega_x * x4
    x6 = 1 / 2 * x5
    x7 = 1 / (omega_x - omega_y)
    x8 = 1 / (omega_x - omega_y - x2)
    x9 = r_b * r_m
    x10 = -sigma
    x11 = 1 / 4 / omega_phi
    x12 = omega_y * omega_y
    x13 = omega_y * x12
    x14 = x11 * x13
    x15 = omega_phi * omega_y
    x16 = 1 / (omega_phi + omega_y)
    x17 = 1 / 8 * x16
    x18 = omega_phi * omega_phi
    x19 = 1 / x18
    x20 = omega_phi * x4
    x21 = omega_phi * x12
    x22 = omega_phi * x18
    x23 = sigma * sigma
    x24 = x12 * x12
    x25 = r_b * r_b
    x26 = r_m * r_m
    x27 = x11 * x5
    # Outputs
    c1_0 = 1j * x9 * (-x1 * x3 * x6 - x6 * x7 * x8)
    c2_1 = 1j * (x10 + x9 * (x1 * x14 + x12 * x17 * x19 * (x12 + 8 * x15 + 6 * x18) - x14 * x7))
    c2_0 = (
        1 / 8 * r_b * r_m * sigma * x12 * x16 * x19 * (x12 + x15 - x18)
        + 3 / 16 * r_b * r_m * x12 * x19 * x23 - 1 / 64 * x1 * x16 * x24 * x25 * x26 * x7 * (3
        * omega_y + x2) * (omega_y * x4 + 4 * x20 - x13 - 8 * x21) / x22 - x14 * x9
    )
    c3_0 = -1j * sigma
    c4_0 = (
        1j * (x10 + x9 * (x17 * x18 + x19 * (33 / 8 * omega_y * x18 + 1 / 8 * x13 + 1 / 2 * x20 + 11
        / 8 * x21 + 31 / 8 * x22) - x27 * x3 - x27 * x8))
    )
    multiply_out(out, ((c1_0,), 1), ((c2_1, c2_0), 1), ((c3_0,), 2), ((c4_0,), 1))


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, sigma, r_m, r_b, omega_x, omega_y, omega_phi,
):
    # Intermediates
    x0 = 2 * omega_phi
    x1 = omega_x + omega_y
    x2 = 1 / (x0 + x1)
    x3 = omega_x * omega_x
    x4 = omega_x * x3
    x5 = x4 / x1
    x6 = x2 * x5
    x7 = r_b * r_m
    x8 = 1j * x7
    x9 = 1 / 2 * x8
    x10 = 1 / (omega_x - omega_y - x0)
    x11 = 1 / (omega_x - omega_y)
    x12 = x11 * x4
    x13 = 2 * omega_y + 3 * sigma
    x14 = 1 / 8 * r_m * x13
    x15 = omega_phi + omega_y
    x16 = 1 / x15
    x17 = 1 / omega_phi
    x18 = omega_y * omega_y
    x19 = x18 * x7
    x20 = x17 * x19
    x21 = 1j * sigma
    x22 = omega_phi * omega_phi
    x23 = 1 / x22
    x24 = 1 / 8 * r_b * x18 * x23 * (x0 - sigma) * np.conj(A_y)
    x25 = 1j * x24
    x26 = (
        x15 * x7 + 1 / 32 * x16 * x19 + 3 / 32 * x20 + 1 / 8 * x6 * x7
        - 1 / 8 * r_b * r_m * x10 * x11 * x4
    )
    x27 = -x26
    x28 = 1 / 16 * x17 * x8
    x29 = x28 * x4
    x30 = omega_y * x18
    x31 = omega_phi * x22
    x32 = (
        x10 * x29 + x12 * x28 + x2 * x29 + x28 * x5 - 1 / 32 * 1j * r_b * r_m * x16 * x22 - 1 / 32
        * 1j * r_b * r_m * x23 * (19 * omega_phi * x18 + 8 * omega_phi * x3 + 33 * omega_y * x22 + 2
        * x30 + 31 * x31)
    )
    x33 = -x32
    # Outputs
    out[..., 0] = A_x * (x10 * x12 * x9 + x6 * x9)
    out[..., 1] = (
        1 / 8 * r_m * x13 * np.conj(A_phi_2) + 1 / 8 * 1j * r_m * x13 * np.conj(A_phi_3)
        - 1 / 8 * 1j * A_y * x16 * x20 * (3 * omega_y + x0) - 1j * x14 * np.conj(A_phi_1)
        - x14 * np.conj(A_phi_4)
    )
    out[..., 2] = (
        A_phi_1 * x33 + A_phi_2 * x27 + A_phi_3 * x32 + A_phi_4 * x26 - A_phi_1 * x21 - x25
    )
    out[..., 3] = (
        A_phi_1 * x26 + A_phi_2 * x33 + A_phi_3 * x27 + A_phi_4 * x32 + x24 - A_phi_2 * x21
    )
    out[..., 4] = (
        A_phi_1 * x32 + A_phi_2 * x26 + A_phi_3 * x33 + A_phi_4 * x27 + x25 - A_phi_3 * x21
    )
    out[..., 5] = (
        A_phi_1 * x27 + A_phi_2 * x32 + A_phi_3 * x26 + A_phi_4 * x33 - A_phi_4 * x21 - x24
    )


def _motion(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = omega_y * omega_y
    x1 = r_m * x0
    x2 = omega_x + omega_y
    x3 = 1 / x2
    x4 = omega_x - omega_y
    x5 = 1 / x4
    x6 = x3 * x5
    x7 = x1 * x6
    x8 = 2 * omega_phi
    x9 = omega_y + x8
    x10 = x9 * x9
    x11 = r_m * x10
    x12 = x2 + x8
    x13 = 1 / x12
    x14 = -omega_x
    x15 = -x14 - x9
    x16 = 1 / x15
    x17 = x13 * x16
    x18 = x11 * x17
    x19 = 1j * x7
    x20 = 1j * x18
    x21 = 1 / omega_phi
    x22 = omega_phi + omega_y
    x23 = 1 / x22
    x24 = 1 / 4 * x23
    x25 = x11 * x21 * x24
    x26 = 1j * x25
    x27 = omega_y * r_b
    x28 = x24 * x27
    x29 = omega_x * omega_x
    x30 = r_b * x29
    x31 = x16 * x30 * x5
    x32 = 1j * x31
    x33 = x13 * x3 * x30
    x34 = 1j * x33
    x35 = 1j * x28
    x36 = 2 * omega_y
    x37 = x29 * x36
    x38 = r_m * sigma
    x39 = x2 * x2
    x40 = 1 / x39
    x41 = x4 * x4
    x42 = 1 / x41
    x43 = x40 * x42
    x44 = x37 * x38 * x43
    x45 = x12 * x12
    x46 = 1 / x45
    x47 = x15 * x15
    x48 = 2 / x47
    x49 = x29 * x38 * x46 * x48 * x9
    x50 = 1j * x44
    x51 = 1j * x49
    x52 = r_m * x6
    x53 = 1j * x52
    x54 = omega_y * x0
    x55 = 2 * x54
    x56 = r_m * x21
    x57 = 1j * x43
    x58 = x22 * x22
    x59 = 1 / x58
    x60 = 1 / 8 * sigma
    x61 = omega_phi * omega_phi
    x62 = x1 * x59 * x60 * x9 / x61
    x63 = 1j * x62
    x64 = x29 * x29
    x65 = omega_x * x64
    x66 = 1 / 32 * x27 * x59 * (omega_phi * x0 + 3 * omega_phi * x29 + x37 + x55)
    x67 = x53 * x66
    x68 = r_b * x59
    x69 = x10 * x9
    x70 = 1 / 32 * x17 * x2 * x4 * x56 * x68 * x69
    x71 = 1j * x70
    x72 = -x71
    x73 = x52 * x66
    x74 = -x73
    x75 = -x70
    x76 = -x67
    x77 = x60 * x68 * (omega_phi + x36)
    x78 = sigma * x30
    x79 = x42 * x48 * x78 * (-x14 - x22)
    x80 = 1j * x79
    x81 = 2 * x40 * x46 * x78 * (omega_phi + x2)
    x82 = 1j * x81
    x83 = 1j * x77
    x84 = omega_phi + sigma
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = x7
    out[..., 7] = x18
    out[..., 8] = x19
    out[..., 9] = -x20
    out[..., 10] = -x7
    out[..., 11] = -x18
    out[..., 12] = -x19
    out[..., 13] = x20
    out[..., 14] = x26
    out[..., 15] = x25
    out[..., 16] = -x26
    out[..., 17] = -x25
    out[..., 18] = -x28
    out[..., 19] = x32
    out[..., 20] = -x34
    out[..., 21] = -x35
    out[..., 22] = x31
    out[..., 23] = x33
    out[..., 24] = x28
    out[..., 25] = -x32
    out[..., 26] = x34
    out[..., 27] = x35
    out[..., 28] = -x31
    out[..., 29] = -x33
    out[..., 30] = x44
    out[..., 31] = x49
    out[..., 32] = x50
    out[..., 33] = -x51
    out[..., 34] = -x44
    out[..., 35] = -x49
    out[..., 36] = -x50
    out[..., 37] = x51
    out[..., 38] = 1 / 2 * r_b * x23 * x53 * x54 + x30 * x55 * x56 * x57
    out[..., 39] = -x63
    out[..., 40] = -x62
    out[..., 41] = x63
    out[..., 42] = x62
    out[..., 43] = -8 * r_b * r_m * x17 * x22 * x57 * x65
    out[..., 44] = x67
    out[..., 45] = x72
    out[..., 46] = x74
    out[..., 47] = x75
    out[..., 48] = x76
    out[..., 49] = x71
    out[..., 50] = x73
    out[..., 51] = x70
    out[..., 52] = x77
    out[..., 53] = x80
    out[..., 54] = x82
    out[..., 55] = x73
    out[..., 56] = x70
    out[..., 57] = x67
    out[..., 58] = x72
    out[..., 59] = x74
    out[..., 60] = x75
    out[..., 61] = x76
    out[..., 62] = x71
    out[..., 63] = x83
    out[..., 64] = x79
    out[..., 65] = -x81
    out[..., 66] = x76
    out[..., 67] = x71
    out[..., 68] = x73
    out[..., 69] = x70
    out[..., 70] = x67
    out[..., 71] = x72
    out[..., 72] = x74
    out[..., 73] = x75
    out[..., 74] = -x77
    out[..., 75] = -x80
    out[..., 76] = -x82
    out[..., 77] = x74
    out[..., 78] = x75
    out[..., 79] = x76
    out[..., 80] = x71
    out[..., 81] = x73
    out[..., 82] = x70
    out[..., 83] = x67
    out[..., 84] = x72
    out[..., 85] = -x83
    out[..., 86] = -x79
    out[..., 87] = x81
    out[..., 88] = omega_x
    out[..., 89] = omega_y
    out[..., 90] = x84
    out[..., 91] = x84
    out[..., 92] = x84
    out[..., 93] = x84
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
        Detuning, Omega = omega_phi + omega_y + sigma, rad/s, real.
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
        _boundaries,
        arguments,
        ("r_m", "r_b", "omega_x", "omega_y", "omega_phi") if gradient else (),
    )


def critical_speeds(
    *, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike, r_a: ArrayLike,
    omega_b: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable zone in Omega.

    Where Omega = omega_y + omega_phi + sigma lies on an edge of `boundaries`. With omega_phi =
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
    *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_phi + omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_phi + omega_y + sigma, rad/s, real.
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
