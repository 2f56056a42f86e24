# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 db8f74572a7af0413d875ac885abcc1b59feb9cc9c19011503e36d45498aa91c
# Operations for each point: growth_rate 75, boundaries 82, detuning 8, slow_flow_matrix 90,
# characteristic_coefficients 110, slow_flow 155, motion 129
"""ground_resonance: Omega = omega_x + omega_phi + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

It can be unstable: the discriminant of Gamma**2 - I*Gamma*sigma - omega_x**3*r_b*r_m/(4*omega_phi)
is positive in an interval of the detuning.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: 2*omega_phi + omega_x - omega_y, omega_x - omega_y.

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


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    6,
    (
        ((0, 0), (2, 1), (3, 1), (4, 1), (5, 1)), ((1, 0),),
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
        (1, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
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
        (2, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
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
        (2, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
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
        (2, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
    ),
    1,
)


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


def _motion(out, sigma, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = 1 / omega_phi
    x1 = 2 * omega_phi + omega_x
    x2 = x1 * x1
    x3 = r_m * x2
    x4 = omega_phi + omega_x
    x5 = 1 / x4
    x6 = 1 / 4 * x5
    x7 = x0 * x3 * x6
    x8 = 1j * x7
    x9 = omega_x * omega_x
    x10 = r_m * x9
    x11 = omega_x + omega_y
    x12 = 1 / x11
    x13 = -omega_y
    x14 = omega_x + x13
    x15 = 1 / x14
    x16 = x12 * x15
    x17 = x10 * x16
    x18 = 1j * x17
    x19 = omega_y + x1
    x20 = 1 / x19
    x21 = x1 + x13
    x22 = 1 / x21
    x23 = x20 * x22
    x24 = x23 * x3
    x25 = 1j * x24
    x26 = omega_y * omega_y
    x27 = r_b * x26
    x28 = x15 * x22 * x27
    x29 = x12 * x20 * x27
    x30 = omega_x * r_b
    x31 = x30 * x6
    x32 = 1j * x31
    x33 = 1j * x28
    x34 = 1j * x29
    x35 = x4 * x4
    x36 = 1 / x35
    x37 = 1 / 8 * sigma
    x38 = omega_phi * omega_phi
    x39 = x1 * x10 * x36 * x37 / x38
    x40 = 1j * x39
    x41 = x11 * x11
    x42 = 1 / x41
    x43 = x14 * x14
    x44 = 1 / x43
    x45 = x42 * x44
    x46 = 1j * x45
    x47 = x26 * x26
    x48 = omega_y * x47
    x49 = 2 * omega_x
    x50 = x26 * x49
    x51 = r_m * sigma
    x52 = x45 * x50 * x51
    x53 = 1j * x52
    x54 = x19 * x19
    x55 = 1 / x54
    x56 = x21 * x21
    x57 = 2 / x56
    x58 = x1 * x26 * x51 * x55 * x57
    x59 = 1j * x58
    x60 = r_m * x16
    x61 = 1j * x60
    x62 = omega_x * x9
    x63 = 2 * x62
    x64 = r_m * x0
    x65 = 1 / 32 * x30 * x36 * (3 * omega_phi * x26 + omega_phi * x9 + x50 + x63)
    x66 = x61 * x65
    x67 = r_b * x36
    x68 = x1 * x2
    x69 = 1 / 32 * x11 * x14 * x23 * x64 * x67 * x68
    x70 = 1j * x69
    x71 = x60 * x65
    x72 = -x71
    x73 = -x66
    x74 = -x70
    x75 = -x69
    x76 = sigma * x27
    x77 = x44 * x57 * x76 * (x13 + x4)
    x78 = 2 * x42 * x55 * x76 * (omega_y + x4)
    x79 = x37 * x67 * (omega_phi + x49)
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
    out[..., 6] = -x7
    out[..., 7] = x8
    out[..., 8] = x7
    out[..., 9] = -x8
    out[..., 10] = -x18
    out[..., 11] = x25
    out[..., 12] = x17
    out[..., 13] = x24
    out[..., 14] = x18
    out[..., 15] = -x25
    out[..., 16] = -x17
    out[..., 17] = -x24
    out[..., 18] = -x28
    out[..., 19] = -x29
    out[..., 20] = -x32
    out[..., 21] = x33
    out[..., 22] = -x34
    out[..., 23] = x31
    out[..., 24] = x28
    out[..., 25] = x29
    out[..., 26] = x32
    out[..., 27] = -x33
    out[..., 28] = x34
    out[..., 29] = -x31
    out[..., 30] = x39
    out[..., 31] = -x40
    out[..., 32] = -x39
    out[..., 33] = x40
    out[..., 34] = -8 * r_b * r_m * x23 * x4 * x46 * x48
    out[..., 35] = x53
    out[..., 36] = -x59
    out[..., 37] = -x52
    out[..., 38] = -x58
    out[..., 39] = -x53
    out[..., 40] = x59
    out[..., 41] = x52
    out[..., 42] = x58
    out[..., 43] = 1 / 2 * r_b * x5 * x61 * x62 - x27 * x46 * x63 * x64
    out[..., 44] = x66
    out[..., 45] = x70
    out[..., 46] = x72
    out[..., 47] = x69
    out[..., 48] = x73
    out[..., 49] = x74
    out[..., 50] = x71
    out[..., 51] = x75
    out[..., 52] = x77
    out[..., 53] = x78
    out[..., 54] = x80
    out[..., 55] = x71
    out[..., 56] = x75
    out[..., 57] = x66
    out[..., 58] = x70
    out[..., 59] = x72
    out[..., 60] = x69
    out[..., 61] = x73
    out[..., 62] = x74
    out[..., 63] = -x81
    out[..., 64] = x82
    out[..., 65] = -x79
    out[..., 66] = x73
    out[..., 67] = x74
    out[..., 68] = x71
    out[..., 69] = x75
    out[..., 70] = x66
    out[..., 71] = x70
    out[..., 72] = x72
    out[..., 73] = x69
    out[..., 74] = -x77
    out[..., 75] = -x78
    out[..., 76] = -x80
    out[..., 77] = x72
    out[..., 78] = x69
    out[..., 79] = x73
    out[..., 80] = x74
    out[..., 81] = x71
    out[..., 82] = x75
    out[..., 83] = x66
    out[..., 84] = x70
    out[..., 85] = x81
    out[..., 86] = -x82
    out[..., 87] = x79
    out[..., 88] = omega_x
    out[..., 89] = omega_y
    out[..., 90] = x83
    out[..., 91] = x83
    out[..., 92] = x83
    out[..., 93] = x83
    out[..., 94] = sigma + x4


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
