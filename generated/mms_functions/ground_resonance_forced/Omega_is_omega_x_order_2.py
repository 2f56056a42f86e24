# Emitted by mmsgen 0.1.0 from derivations/ground_resonance_forced.py: change that, not this file.
# Made from sha256 0ab8513d36dcbe5253a2127f8edd90439b12c039ca88990175f0c5a9a230114d
# Operations for each point: slow_flow 326, coefficients 284, backbone 223, motion 522
"""ground_resonance_forced: Omega = omega_x + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: -omega_phi + 2*omega_x, -omega_phi + omega_x + omega_y,
-omega_phi + omega_x - omega_y, omega_phi + omega_x - omega_y.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._flow import Flow
from .._initial import initial_at
from .._many_amplitudes import equilibria_of_many
from .._modes import modes_at
from .._motion import Motion, response_at
from .._nonlinear import equilibria_at, jacobian_at, response_along, stability_at
from .._runtime import checked, checked_amplitudes, evaluate_array

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "COORDINATES",
    "FRAME",
    "ORDER",
    "PARAMETERS",
    "RELATIONS",
    "VARIABLES",
    "backbone",
    "equilibria",
    "frequency_response",
    "initial_amplitudes",
    "jacobian",
    "response",
    "slow_flow",
    "stability",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ("Omega = omega_x + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega_x + sigma"),
    "e_1": ("real", "1", "what blade 1 is heavier by, over the mass of a blade"),
    "e_2": ("real", "1", "what blade 2 is heavier by, over the mass of a blade"),
    "e_3": ("real", "1", "what blade 3 is heavier by, over the mass of a blade"),
    "e_4": ("real", "1", "what blade 4 is heavier by, over the mass of a blade"),
    "r_m": ("positive", "m", "static moment of a blade over the mass of the helicopter"),
    "r_b": ("positive", "1/m", "static moment of a blade over its inertia about the hinge"),
    "r_a": ("positive", "1", "lag frequency per rotor speed of a blade without lag spring"),
    "omega_x": ("positive", "rad/s", "longitudinal frequency of the fuselage"),
    "omega_y": ("positive", "rad/s", "lateral frequency of the fuselage"),
    "mu_x": ("nonnegative", "1/s", "longitudinal damping rate of the fuselage"),
    "mu_y": ("nonnegative", "1/s", "lateral damping rate of the fuselage"),
    "mu_b": ("nonnegative", "1/s", "lag damping rate of a blade"),
    "r_h": ("positive", "1", "eccentricity of a hinge over the distance from it to the centre"),
    "omega_phi": ("positive", "rad/s", "lag frequency of a blade at speed"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {"sigma": 1},
    "y": {},
    "phi_1": {},
    "phi_2": {},
    "phi_3": {},
    "phi_4": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    6,
    (
        (0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (0, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (1, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
    ),
    ((0, 1, 0, 0, 0, 0), (0, 0, 1, 1, 1, 1)),
)

#: terms of free motions without damping
_FREE = Flow(
    6,
    (
        (0, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (1, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
    ),
    ((1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0), (0, 0, 1, 1, 1, 1)),
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
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
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
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
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
        (2, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
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
        (2, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
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
        (2, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
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
        (2, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
    ),
    1,
)


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, sigma, e_1, e_2, e_3, e_4, r_m, r_b, r_a,
    omega_x, omega_y, mu_x, mu_y, mu_b, r_h, omega_phi,
):
    # Intermediates
    x0 = 1 / 8 * mu_x
    x1 = 1 / 4 * omega_x
    x2 = 3 / 8 * sigma
    x3 = omega_phi * omega_phi
    x4 = 1 / x3
    x5 = omega_phi + 2 * omega_x
    x6 = 1 / x5
    x7 = 2 * omega_x - omega_phi
    x8 = 1 / x7
    x9 = omega_x * x3
    x10 = r_b * r_m
    x11 = x3 * x3
    x12 = 1 / 2 * x11
    x13 = x10 * x3
    x14 = omega_x * omega_x
    x15 = x14 * x3
    x16 = mu_x * mu_x
    x17 = x14 * x14
    x18 = x14 * x17
    x19 = 1 / 2 * 1j
    x20 = omega_x + omega_y
    x21 = 1 / (omega_phi + x20)
    x22 = 1 / 4 * 1j
    x23 = omega_y * omega_y
    x24 = omega_y * x23
    x25 = x10 * x24
    x26 = x22 * x25
    x27 = 1 / x20
    x28 = x26 * x27
    x29 = 1 / (x20 - omega_phi)
    x30 = omega_x - omega_y
    x31 = 1 / x30
    x32 = 1 / (omega_phi + x30)
    x33 = x25 * x32
    x34 = 1 / (omega_x - omega_phi - omega_y)
    x35 = x31 * x34
    x36 = 1 / 128 * x13
    x37 = x36 * x6
    x38 = x36 * x8
    x39 = 1 / omega_phi
    x40 = 1 / 16 * x39
    x41 = x25 * x40
    x42 = x29 * x41
    x43 = x33 * x40
    x44 = 1 / 32 * x10
    x45 = (
        omega_x * x4 * x44 * (4 * x14 + 33 * x3) + x37 + x38 + x42 + x43
        - 1 / 16 * r_b * r_m * x21 * x24 * x39 - 1 / 16 * r_b * r_m * x24 * x34 * x39
    )
    x46 = -x45
    x47 = 1j * x14
    x48 = 1 / 16 * 1j * x25
    x49 = (
        1 / 32 * 1j * r_b * r_m * x14 * x8 + 1 / 16 * 1j * r_b * r_m * x24 * x27 * x29
        + 1 / 16 * 1j * r_b * r_m * x24 * x31 * x32 - omega_phi * x10 * x19
        - x10 * x27 * x31 * x40 * x47 * (11 * x14 - 7 * x23) - x21 * x27 * x48 - x35 * x48
        - x44 * x47 * x6
    )
    x50 = omega_phi * x3
    x51 = 1 / x50
    x52 = mu_b * x50
    x53 = 3 / 8 * x11
    x54 = r_a * r_a
    x55 = x54 * x54
    x56 = 1 / 8 * x17 * x55
    x57 = e_1 * x54
    x58 = 1 / 2 * x3
    x59 = x14 * x58
    x60 = 1 / 4 * x15 * x54
    x61 = sigma * x9
    x62 = mu_b * mu_b
    x63 = 31 / 64 * x10 * x11 + 11 / 16 * x10 * x15 + 1 / 4 * x13 * x23 - x58 * x62
    x64 = 1j * x34 * x41 + 1j * x37 + 1j * x43 - 1j * x21 * x41 - 1j * x38 - 1j * x42
    x65 = e_1 * e_1
    x66 = e_2 * x54
    x67 = e_2 * e_2
    x68 = e_3 * x54
    x69 = e_3 * e_3
    x70 = e_4 * x54
    x71 = e_4 * e_4
    # Outputs
    out[..., 0] = (
        A_x * x4 * x6 * x8 * (1j * (x12 * x16 + x13 * x17 - 2 * x10 * x18 - 2 * x15 * x16)
        - mu_x * x5 * x7 * x9) / omega_x + r_m * (r_h + 1) * (e_1 * x0 + e_2 * x1 + e_2 * x2 + 1j
        * (1 / 8 * e_2 * mu_x + 1 / 4 * e_3 * omega_x + 3 / 8 * e_3 * sigma - e_1 * x1 - e_1 * x2
        - e_4 * x0) - e_3 * x0 - e_4 * x1 - e_4 * x2) - 1j * A_x * sigma
    )
    out[..., 1] = (
        A_y * (mu_y * (-mu_y * x19 - omega_y) / omega_y + x21 * x28 + x22 * x31 * x33 + x26 * x35
        + x28 * x29)
    )
    out[..., 2] = (
        A_phi_1 * (x51 * (x52 * (e_1 - 1)
        + 1j * (x53 * x65 + x57 * x59 + x57 * x61 + x63 - e_1 * x12 - x56 * x65 - x60 * x65)) + x64)
        + A_phi_2 * x46 + A_phi_3 * x49 + A_phi_4 * x45
    )
    out[..., 3] = (
        A_phi_1 * x45 + A_phi_2 * (x51 * (x52 * (e_2 - 1) + 1j * (x53 * x67 + x59 * x66 + x61 * x66
        + x63 - e_2 * x12 - x56 * x67 - x60 * x67)) + x64) + A_phi_3 * x46 + A_phi_4 * x49
    )
    out[..., 4] = (
        A_phi_1 * x49 + A_phi_2 * x45 + A_phi_3 * (x51 * (x52 * (e_3 - 1) + 1j * (x53 * x69 + x59
        * x68 + x61 * x68 + x63 - e_3 * x12 - x56 * x69 - x60 * x69)) + x64) + A_phi_4 * x46
    )
    out[..., 5] = (
        A_phi_1 * x46 + A_phi_2 * x49 + A_phi_3 * x45 + A_phi_4 * (x51 * (x52 * (e_4 - 1) + 1j
        * (x53 * x71 + x59 * x70 + x61 * x70 + x63 - e_4 * x12 - x56 * x71 - x60 * x71)) + x64)
    )


def _coefficients(
    out, sigma, e_1, e_2, e_3, e_4, r_m, r_b, r_a, omega_x, omega_y, mu_x, mu_y, mu_b, r_h,
    omega_phi,
):
    # Intermediates
    x0 = 1 / 8 * mu_x
    x1 = 1 / 4 * omega_x
    x2 = 3 / 8 * sigma
    x3 = omega_phi * omega_phi
    x4 = 1 / x3
    x5 = omega_phi + 2 * omega_x
    x6 = 1 / x5
    x7 = 2 * omega_x - omega_phi
    x8 = 1 / x7
    x9 = omega_x * x3
    x10 = r_b * r_m
    x11 = x3 * x3
    x12 = 1 / 2 * x11
    x13 = x10 * x3
    x14 = omega_x * omega_x
    x15 = x14 * x3
    x16 = mu_x * mu_x
    x17 = x14 * x14
    x18 = x14 * x17
    x19 = 1 / 2 * 1j
    x20 = omega_y * omega_y
    x21 = omega_y * x20
    x22 = x10 * x21
    x23 = omega_x + omega_y
    x24 = x22 / (omega_phi + x23)
    x25 = 1 / x23
    x26 = 1 / 4 * 1j
    x27 = x25 * x26
    x28 = 1 / (x23 - omega_phi)
    x29 = omega_x - omega_y
    x30 = 1 / (omega_phi + x29)
    x31 = 1 / x29
    x32 = x22 * x31
    x33 = x26 * x32
    x34 = 1 / (omega_x - omega_phi - omega_y)
    x35 = 1 / 128 * x13
    x36 = x35 * x6
    x37 = x35 * x8
    x38 = 1 / 16 / omega_phi
    x39 = x24 * x38
    x40 = x22 * x38
    x41 = x28 * x40
    x42 = x30 * x40
    x43 = 1 / 32 * x10
    x44 = x34 * x40
    x45 = omega_x * x4 * x43 * (4 * x14 + 33 * x3) + x36 + x37 + x41 + x42 - x39 - x44
    x46 = 1j * x14
    x47 = 1 / 16 * 1j
    x48 = (
        1 / 32 * 1j * r_b * r_m * x14 * x8 + 1 / 16 * 1j * r_b * r_m * x21 * x25 * x28
        + 1 / 16 * 1j * r_b * r_m * x21 * x30 * x31 - omega_phi * x10 * x19
        - x10 * x25 * x31 * x38 * x46 * (11 * x14 - 7 * x20) - x24 * x25 * x47 - x32 * x34 * x47
        - x43 * x46 * x6
    )
    x49 = -x45
    x50 = omega_phi * x3
    x51 = 1 / x50
    x52 = mu_b * x50
    x53 = 3 / 8 * x11
    x54 = r_a * r_a
    x55 = x54 * x54
    x56 = 1 / 8 * x17 * x55
    x57 = e_1 * x54
    x58 = 1 / 2 * x3
    x59 = x14 * x58
    x60 = 1 / 4 * x15 * x54
    x61 = sigma * x9
    x62 = mu_b * mu_b
    x63 = 31 / 64 * x10 * x11 + 11 / 16 * x10 * x15 + 1 / 4 * x13 * x20 - x58 * x62
    x64 = 1j * x36 + 1j * x42 + 1j * x44 - 1j * x37 - 1j * x39 - 1j * x41
    x65 = e_1 * e_1
    x66 = e_2 * x54
    x67 = e_2 * e_2
    x68 = e_3 * x54
    x69 = e_3 * e_3
    x70 = e_4 * x54
    x71 = e_4 * e_4
    # Outputs
    out[..., 0] = (
        r_m * (r_h + 1) * (e_1 * x0 + e_2 * x1 + e_2 * x2 + 1j * (1 / 8 * e_2 * mu_x + 1 / 4 * e_3
        * omega_x + 3 / 8 * e_3 * sigma - e_1 * x1 - e_1 * x2 - e_4 * x0) - e_3 * x0 - e_4 * x1
        - e_4 * x2)
    )
    out[..., 1] = (
        x4 * x6 * x8 * (1j * (x12 * x16 + x13 * x17 - 2 * x10 * x18 - 2 * x15 * x16)
        - mu_x * x5 * x7 * x9) / omega_x - 1j * sigma
    )
    out[..., 2] = (
        mu_y * (-mu_y * x19 - omega_y) / omega_y + x22 * x27 * x28 + x24 * x27 + x30 * x33
        + x33 * x34
    )
    out[..., 3] = x45
    out[..., 4] = x48
    out[..., 5] = x49
    out[..., 6] = (
        x51 * (x52 * (e_1 - 1)
        + 1j * (x53 * x65 + x57 * x59 + x57 * x61 + x63 - e_1 * x12 - x56 * x65 - x60 * x65)) + x64
    )
    out[..., 7] = x48
    out[..., 8] = x49
    out[..., 9] = (
        x51 * (x52 * (e_2 - 1)
        + 1j * (x53 * x67 + x59 * x66 + x61 * x66 + x63 - e_2 * x12 - x56 * x67 - x60 * x67)) + x64
    )
    out[..., 10] = x45
    out[..., 11] = x49
    out[..., 12] = (
        x51 * (x52 * (e_3 - 1)
        + 1j * (x53 * x69 + x59 * x68 + x61 * x68 + x63 - e_3 * x12 - x56 * x69 - x60 * x69)) + x64
    )
    out[..., 13] = x45
    out[..., 14] = x48
    out[..., 15] = (
        x51 * (x52 * (e_4 - 1)
        + 1j * (x53 * x71 + x59 * x70 + x61 * x70 + x63 - e_4 * x12 - x56 * x71 - x60 * x71)) + x64
    )
    out[..., 16] = x45
    out[..., 17] = x48
    out[..., 18] = x49


def _backbone(
    out, sigma, e_1, e_2, e_3, e_4, r_m, r_b, r_a, omega_x, omega_y, mu_x, mu_y, mu_b, r_h,
    omega_phi,
):
    # Intermediates
    x0 = omega_phi * omega_phi
    x1 = 1 / x0
    x2 = 1 / (omega_phi + 2 * omega_x)
    x3 = 1 / (2 * omega_x - omega_phi)
    x4 = r_b * r_m
    x5 = x0 * x0
    x6 = 1 / 2 * x5
    x7 = x0 * x4
    x8 = omega_x * omega_x
    x9 = x0 * x8
    x10 = mu_x * mu_x
    x11 = x8 * x8
    x12 = x11 * x8
    x13 = omega_x + omega_y
    x14 = 1 / (omega_phi + x13)
    x15 = 1 / x13
    x16 = omega_y * omega_y
    x17 = omega_y * x16
    x18 = x17 * x4
    x19 = 1 / 4 * x18
    x20 = x15 * x19
    x21 = 1 / (x13 - omega_phi)
    x22 = omega_x - omega_y
    x23 = 1 / (omega_phi + x22)
    x24 = 1 / x22
    x25 = x19 * x24
    x26 = 1 / (omega_x - omega_phi - omega_y)
    x27 = mu_y * mu_y
    x28 = 1 / 128 * x7
    x29 = x28 * x3
    x30 = 1 / omega_phi
    x31 = 1 / 16 * x18
    x32 = x30 * x31
    x33 = x26 * x32
    x34 = x21 * x32
    x35 = 1 / 32 * x4
    x36 = x2 * x28 + x23 * x32 - x14 * x32
    x37 = omega_x * x1 * x35 * (33 * x0 + 4 * x8) + x29 + x34 + x36 - x33
    x38 = (
        1j * (1 / 16 * r_b * r_m * x15 * x17 * x21 + 1 / 16 * r_b * r_m * x17 * x23 * x24
        + 1 / 32 * r_b * r_m * x3 * x8 - 1 / 2 * omega_phi * x4 - x14 * x15 * x31
        - 1 / 16 * x15 * x24 * x30 * x4 * x8 * (11 * x8 - 7 * x16) - x2 * x35 * x8
        - x24 * x26 * x31)
    )
    x39 = -x37
    x40 = omega_phi * x0
    x41 = 1 / x40
    x42 = 3 / 8 * x5
    x43 = r_a * r_a
    x44 = x43 * x43
    x45 = 1 / 8 * x11 * x44
    x46 = e_1 * x43
    x47 = 1 / 2 * x0
    x48 = x47 * x8
    x49 = 1 / 4 * x43 * x9
    x50 = omega_x * sigma * x0
    x51 = mu_b * mu_b
    x52 = 1 / 4 * x16 * x7 + 31 / 64 * x4 * x5 + 11 / 16 * x4 * x9 - x47 * x51
    x53 = x33 + x36 - x29 - x34
    x54 = e_1 * e_1
    x55 = e_2 * x43
    x56 = e_2 * e_2
    x57 = e_3 * x43
    x58 = e_3 * e_3
    x59 = e_4 * x43
    x60 = e_4 * e_4
    # Outputs
    out[..., 0] = (
        1j * x1 * x2 * x3 * (x10 * x6 + x11 * x7 - 2 * x10 * x9 - 2 * x12 * x4) / omega_x
        - 1j * sigma
    )
    out[..., 1] = 1j * (x14 * x20 + x20 * x21 + x23 * x25 + x25 * x26 - 1 / 2 * x27 / omega_y)
    out[..., 2] = x37
    out[..., 3] = x38
    out[..., 4] = x39
    out[..., 5] = (
        1j * (x41 * (x42 * x54 + x46 * x48 + x46 * x50 + x52 - e_1 * x6 - x45 * x54 - x49 * x54)
        + x53)
    )
    out[..., 6] = x38
    out[..., 7] = x39
    out[..., 8] = (
        1j * (x41 * (x42 * x56 + x48 * x55 + x50 * x55 + x52 - e_2 * x6 - x45 * x56 - x49 * x56)
        + x53)
    )
    out[..., 9] = x37
    out[..., 10] = x39
    out[..., 11] = (
        1j * (x41 * (x42 * x58 + x48 * x57 + x50 * x57 + x52 - e_3 * x6 - x45 * x58 - x49 * x58)
        + x53)
    )
    out[..., 12] = x37
    out[..., 13] = x38
    out[..., 14] = (
        1j * (x41 * (x42 * x60 + x48 * x59 + x50 * x59 + x52 - e_4 * x6 - x45 * x60 - x49 * x60)
        + x53)
    )
    out[..., 15] = x37
    out[..., 16] = x38
    out[..., 17] = x39
    out[..., 18] = sigma


def _motion(
    out, sigma, e_1, e_2, e_3, e_4, r_m, r_b, r_a, omega_x, omega_y, mu_x, mu_y, mu_b, r_h,
    omega_phi,
):
    # Intermediates
    x0 = 2 * omega_x - omega_phi
    x1 = 1 / x0
    x2 = r_m / omega_phi
    x3 = omega_phi - omega_x
    x4 = -x3
    x5 = x4 * x4
    x6 = x1 * x2 * x5
    x7 = 2 * omega_x
    x8 = omega_phi + x7
    x9 = 1 / x8
    x10 = omega_phi + omega_x
    x11 = x10 * x10
    x12 = x11 * x2 * x9
    x13 = 1j * x6
    x14 = 1j * x12
    x15 = 1 / 2 * e_2
    x16 = 1 / 2 * e_4
    x17 = 1 / 2 * e_1
    x18 = 1 / 2 * e_3
    x19 = x17 - x18
    x20 = x16 + 1j * x19 - x15
    x21 = omega_x * omega_x
    x22 = 2 * x21
    x23 = r_h + 1
    x24 = r_m * x23
    x25 = omega_x + omega_y
    x26 = -omega_y
    x27 = omega_x + x26
    x28 = 1 / (x25 * x27)
    x29 = x24 * x28
    x30 = -omega_y - x3
    x31 = 1 / x30
    x32 = x25 - omega_phi
    x33 = 1 / x32
    x34 = r_m * x33
    x35 = x31 * x34
    x36 = x35 * x5
    x37 = 1j * x36
    x38 = x10 + x26
    x39 = 1 / x38
    x40 = omega_y + x10
    x41 = 1 / x40
    x42 = r_m * x41
    x43 = x11 * x39 * x42
    x44 = 1j * x43
    x45 = omega_y * omega_y
    x46 = r_b * x45
    x47 = x31 * x46
    x48 = x39 * x47
    x49 = x33 * x41 * x46
    x50 = omega_phi * omega_phi
    x51 = 1 / x50
    x52 = r_b * x21
    x53 = x51 * x52
    x54 = 1j * x53
    x55 = x1 * x9
    x56 = x52 * x55
    x57 = 1j * x56
    x58 = 1j * x48
    x59 = 1j * x49
    x60 = omega_phi * x50
    x61 = 3 / 2 * omega_x * x60
    x62 = e_4 * x61
    x63 = -x62
    x64 = omega_phi * sigma
    x65 = x21 * x64
    x66 = mu_b * x21
    x67 = omega_phi * x7
    x68 = mu_x * x67
    x69 = mu_x * x50
    x70 = -x69
    x71 = omega_phi * (mu_x * x21 - x66 - x68 - x70)
    x72 = x65 + 1j * x71
    x73 = x21 * x21
    x74 = r_a * r_a
    x75 = x73 * x74
    x76 = e_4 * x50
    x77 = 3 / 2 * x21
    x78 = x50 * x50
    x79 = x16 * x78 + x76 * x77
    x80 = x79 - x16 * x75
    x81 = 1 / x60
    x82 = 2 * x4
    x83 = x0 * x0
    x84 = 1 / x83
    x85 = r_m * x84
    x86 = x81 * x82 * x85
    x87 = -x65
    x88 = mu_x * x21
    x89 = omega_phi * (x68 + x69 + x88 - x66)
    x90 = x87 + 1j * x89
    x91 = x8 * x8
    x92 = 1 / x91
    x93 = 2 * x10
    x94 = r_m * x81 * x92 * x93
    x95 = e_3 * x61
    x96 = -x95
    x97 = e_3 * x50
    x98 = x18 * x78 + x77 * x97
    x99 = x98 - x18 * x75
    x100 = e_2 * x61
    x101 = -x100
    x102 = e_2 * x50
    x103 = x102 * x77 + x15 * x78
    x104 = x103 - x15 * x75
    x105 = e_1 * x61
    x106 = -x105
    x107 = e_1 * x50
    x108 = x107 * x77 + x17 * x78
    x109 = x108 - 1 / 2 * e_1 * x73 * x74
    x110 = omega_x * r_b
    x111 = 8 * 1j * x28
    x112 = x45 * x45
    x113 = omega_y * x112
    x114 = sigma * x45
    x115 = mu_y * x21
    x116 = x25 * x25
    x117 = x27 * x27
    x118 = -x115
    x119 = mu_y * x67
    x120 = mu_b * x45
    x121 = mu_y * x50
    x122 = x120 - x121
    x123 = omega_phi * (-x118 - x119 - x122)
    x124 = x45 * x64
    x125 = omega_x * x21
    x126 = omega_phi * x125
    x127 = x126 * x16
    x128 = x16 * x45
    x129 = omega_phi * omega_x
    x130 = x128 * x129
    x131 = x21 * x74
    x132 = x79 - x128 * x131
    x133 = x30 * x30
    x134 = 1 / x133
    x135 = x32 * x32
    x136 = 1 / x135
    x137 = x134 * x136 * x2 * x82
    x138 = x121 - x120
    x139 = omega_phi * (x115 + x119 + x138)
    x140 = -x124
    x141 = x38 * x38
    x142 = 1 / x141
    x143 = x40 * x40
    x144 = 1 / x143
    x145 = x142 * x144 * x2 * x93
    x146 = x18 * x45
    x147 = x129 * x146
    x148 = x98 - x131 * x146
    x149 = 1j * x123 + x124
    x150 = 1j * x139 + x140
    x151 = x126 * x15
    x152 = x129 * x15 * x45
    x153 = x103 - 1 / 2 * e_2 * x21 * x45 * x74
    x154 = x126 * x17
    x155 = x17 * x45
    x156 = x108 - x131 * x155
    x157 = x21 * x73
    x158 = 1 / 2 * x29 * x53 * (x22 - x45)
    x159 = x158 * (e_2 - e_4)
    x160 = x15 - x16
    x161 = x23 * x28 * x52 * x85 * x92 * (x22 * x45 + 2 * x73 - x45 * x50)
    x162 = 1 / 16 * x110
    x163 = x162 * x2
    x164 = 1j * x163
    x165 = r_m * x162
    x166 = 1 / 16 / omega_x
    x167 = x166 * x46
    x168 = x167 * x34
    x169 = r_m * x166 * x47
    x170 = x164 + 1j * x168 + 1j * x169 - 1j * x1 * x165
    x171 = x165 * x9
    x172 = x167 * x42
    x173 = r_m * x167 * x39
    x174 = x164 + 1j * x171 - 1j * x172 - 1j * x173
    x175 = x163 + x168 + x169 - 1 / 16 * omega_x * r_b * r_m * x1
    x176 = -x175
    x177 = x163 + x171 - x172 - x173
    x178 = -x170
    x179 = -x174
    x180 = -x177
    x181 = 2 * omega_y
    x182 = sigma * x181
    x183 = -x182
    x184 = sigma * x7
    x185 = x107 - e_1 * x21 * x74
    x186 = x184 + x185
    x187 = 1 / 2 * omega_y
    x188 = omega_x * omega_y
    x189 = mu_b * x188 + mu_y * x188
    x190 = x118 + x138 + x189
    x191 = r_b * x181
    x192 = x134 * x142 * x191
    x193 = x115 + x122 + x189
    x194 = x136 * x144 * x191
    x195 = omega_x * (omega_x * r_a - omega_phi) * (omega_phi + omega_x * r_a)
    x196 = 1j * x195
    x197 = r_b * x7
    x198 = x197 / x78
    x199 = 4 * omega_x * sigma
    x200 = 1 / 2 * omega_x
    x201 = 2 * x66 + x70 + 2 * x88
    x202 = x197 * x84 * x92
    x203 = x158 * (e_1 - e_3)
    x204 = x102 - e_2 * x21 * x74
    x205 = x184 + x204
    x206 = 1j * x187
    x207 = -1j * x69
    x208 = x97 - e_3 * x21 * x74
    x209 = x184 + x208
    x210 = x76 - e_4 * x21 * x74
    x211 = x184 + x210
    x212 = omega_x + sigma
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = x6
    out[..., 7] = -x12
    out[..., 8] = x13
    out[..., 9] = x14
    out[..., 10] = -x6
    out[..., 11] = x12
    out[..., 12] = -x13
    out[..., 13] = -x14
    out[..., 14] = x20 * x22 * x29
    out[..., 15] = -x37
    out[..., 16] = x44
    out[..., 17] = x36
    out[..., 18] = x43
    out[..., 19] = x37
    out[..., 20] = -x44
    out[..., 21] = -x36
    out[..., 22] = -x43
    out[..., 23] = -x48
    out[..., 24] = -x49
    out[..., 25] = -x54
    out[..., 26] = -x57
    out[..., 27] = x58
    out[..., 28] = -x59
    out[..., 29] = -x53
    out[..., 30] = x56
    out[..., 31] = x48
    out[..., 32] = x49
    out[..., 33] = x54
    out[..., 34] = x57
    out[..., 35] = -x58
    out[..., 36] = x59
    out[..., 37] = x53
    out[..., 38] = -x56
    out[..., 39] = x86 * (x63 + x72 + x80)
    out[..., 40] = x94 * (-x62 - x80 - x90)
    out[..., 41] = x86 * (1j * (x65 + x96 + x99) - x71)
    out[..., 42] = x94 * (1j * (x87 + x95 + x99) - x89)
    out[..., 43] = x86 * (-x101 - x104 - x72)
    out[..., 44] = x94 * (x100 + x104 + x90)
    out[..., 45] = x86 * (x71 + 1j * (-x106 - x109 - x65))
    out[..., 46] = x94 * (x89 + 1j * (-x105 - x109 - x87))
    out[..., 47] = -x110 * x111 * x113 * x35 * x39 * x41
    out[..., 48] = (
        x24 * x7 * (e_2 * x114 + e_3 * x115
        + 1j * (e_3 * sigma * x45 + e_4 * mu_y * x21 - e_1 * x114 - e_2 * x115) - e_1 * x115
        - e_4 * x114) / (x116 * x117)
    )
    out[..., 49] = x137 * (1j * (x124 + x130 + x132 + x63 - x127) - x123)
    out[..., 50] = x145 * (1j * (x127 + x132 + x140 + x62 - x130) - x139)
    out[..., 51] = x137 * (1 / 2 * e_3 * omega_phi * x125 - x147 - x148 - x149 - x96)
    out[..., 52] = x145 * (x126 * x18 + x148 + x150 + x95 - x147)
    out[..., 53] = x137 * (x123 + 1j * (x151 - x101 - x124 - x152 - x153))
    out[..., 54] = x145 * (x139 + 1j * (x152 - x100 - x140 - x151 - x153))
    out[..., 55] = x137 * (x106 + x129 * x155 + x149 + x156 - x154)
    out[..., 56] = x145 * (1 / 2 * e_1 * omega_phi * omega_x * x45 - x105 - x150 - x154 - x156)
    out[..., 57] = r_b * r_m * x111 * x157 * x51 * x55
    out[..., 58] = -x159
    out[..., 59] = x161 * (x160 - 1j * x19)
    out[..., 60] = x170
    out[..., 61] = x174
    out[..., 62] = x176
    out[..., 63] = x177
    out[..., 64] = x178
    out[..., 65] = x179
    out[..., 66] = x175
    out[..., 67] = x180
    out[..., 68] = x192 * (1j * x190 - x187 * (-x183 - x186))
    out[..., 69] = x194 * (-x187 * (-x182 - x186) - 1j * x193)
    out[..., 70] = x198 * (x17 * x196 + x69)
    out[..., 71] = x202 * (x201 - 1j * x200 * (-x185 - x199))
    out[..., 72] = x203
    out[..., 73] = x161 * (1j * x160 + x19)
    out[..., 74] = x175
    out[..., 75] = x180
    out[..., 76] = x170
    out[..., 77] = x174
    out[..., 78] = x176
    out[..., 79] = x177
    out[..., 80] = x178
    out[..., 81] = x179
    out[..., 82] = x192 * (x190 + x206 * (-x183 - x205))
    out[..., 83] = x194 * (x193 - x206 * (-x182 - x205))
    out[..., 84] = x198 * (x15 * x195 + x207)
    out[..., 85] = x202 * (x200 * (-x199 - x204) + 1j * x201)
    out[..., 86] = x159
    out[..., 87] = x161 * x20
    out[..., 88] = x178
    out[..., 89] = x179
    out[..., 90] = x175
    out[..., 91] = x180
    out[..., 92] = x170
    out[..., 93] = x174
    out[..., 94] = x176
    out[..., 95] = x177
    out[..., 96] = x192 * (x187 * (-x183 - x209) - 1j * x190)
    out[..., 97] = x194 * (x187 * (-x182 - x209) + 1j * x193)
    out[..., 98] = x198 * (-x18 * x196 - x69)
    out[..., 99] = x202 * (1 / 2 * 1j * omega_x * (-x199 - x208) - x201)
    out[..., 100] = -x203
    out[..., 101] = x161 * (x18 - 1j * x160 - x17)
    out[..., 102] = x176
    out[..., 103] = x177
    out[..., 104] = x178
    out[..., 105] = x179
    out[..., 106] = x175
    out[..., 107] = x180
    out[..., 108] = x170
    out[..., 109] = x174
    out[..., 110] = x192 * (-x190 - x206 * (-x183 - x211))
    out[..., 111] = x194 * (1 / 2 * 1j * omega_y * (-x182 - x211) - x193)
    out[..., 112] = x198 * (-x16 * x195 - x207)
    out[..., 113] = x202 * (-x200 * (-x199 - x210) - 1j * x201)
    out[..., 114] = x212
    out[..., 115] = omega_y
    out[..., 116] = omega_phi
    out[..., 117] = omega_phi
    out[..., 118] = omega_phi
    out[..., 119] = omega_phi
    out[..., 120] = x212


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike,
    e_4: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike,
    omega_y: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, r_h: ArrayLike,
    omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
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
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_b=r_b, r_a=r_a,
        omega_x=omega_x, omega_y=omega_y, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h,
        omega_phi=omega_phi,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 6), *arguments], (6,))


def equilibria(
    *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike, e_4: ArrayLike,
    r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, r_h: ArrayLike, omega_phi: ArrayLike,
    gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN. B_j exp(i k_j θ) moves along a circle of
    further ones for k = (0, 1, 0, 0, 0, 0), (0, 0, 1, 1, 1, 1); of each circle one point is given,
    and the rate at which it drifts, B_j exp(i k_j ρ t).

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Equilibria
        The arrays amplitudes (..., count, 6), drift (..., count, 2) in rad/s and growth (...,
        count) in 1/s, which is negative where an equilibrium is stable. With gradient also name ->
        derivatives of amplitudes, drift and growth, NaN where equilibria meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_b=r_b, r_a=r_a,
        omega_x=omega_x, omega_y=omega_y, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h,
        omega_phi=omega_phi,
    )
    return equilibria_at(
        equilibria_of_many,
        _FLOW,
        _coefficients,
        arguments,
        (
            "sigma", "e_1", "e_2", "e_3", "e_4", "r_m", "r_b", "r_a", "omega_x", "omega_y", "mu_x",
            "mu_y", "mu_b", "r_h", "omega_phi",
        )
        if gradient
        else (),
    )


def frequency_response(
    *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike, e_4: ArrayLike,
    r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, r_h: ArrayLike, omega_phi: ArrayLike,
    over: str = "sigma", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    over : str, optional
        Name of the one that varies.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Response
        Its name, branches (parameter, amplitudes, drift, growth) and bifurcations (saddle-nodes,
        pitchforks, transcritical and Hopf points). With gradient also name -> derivatives of the
        branches (amplitudes, drift, growth; NaN where they meet) and of the values at which the
        bifurcations lie.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_b=r_b, r_a=r_a,
        omega_x=omega_x, omega_y=omega_y, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h,
        omega_phi=omega_phi,
    )
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        (
            "sigma", "e_1", "e_2", "e_3", "e_4", "r_m", "r_b", "r_a", "omega_x", "omega_y", "mu_x",
            "mu_y", "mu_b", "r_h", "omega_phi",
        ),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike,
    e_4: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike,
    omega_y: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, r_h: ArrayLike,
    omega_phi: ArrayLike, of: str = "x",
) -> Any:
    """Free motions without damping in which one coordinate has a given amplitude.

    All periodic ones: normal modes, whose frequencies over the amplitude are the backbone curves of
    the responses. Forces and damping are left out.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    of : str, optional
        That coordinate.

    Returns
    -------
    Backbone
        The arrays amplitudes (..., count, 6), shift (..., count, 6) of the frequency of each
        coordinate in rad/s, detuning (..., count) of a force at that frequency in rad/s, and growth
        (..., count) in 1/s, zero where a motion is stable; NaN where there are fewer.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_b=r_b, r_a=r_a,
        omega_x=omega_x, omega_y=omega_y, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h,
        omega_phi=omega_phi,
    )
    return modes_at(_FREE, (), _backbone, arguments, amplitude, COORDINATES, of)


def jacobian(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike,
    e_4: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike,
    omega_y: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, r_h: ArrayLike,
    omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`, turned along its symmetries so that the amplitudes given drift as
    little as they can; an equilibrium then is at rest.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 12, 12), in 1/s, rows and columns u_1, v_1, u_2, …; with gradient this and name
        -> derivatives, the amplitudes fixed.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_b=r_b, r_a=r_a,
        omega_x=omega_x, omega_y=omega_y, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h,
        omega_phi=omega_phi,
    )
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma", "e_1", "e_2", "e_3", "e_4", "r_m", "r_b", "r_a", "omega_x", "omega_y", "mu_x",
            "mu_y", "mu_b", "r_h", "omega_phi",
        )
        if gradient
        else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike,
    e_4: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike,
    omega_y: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, r_h: ArrayLike,
    omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t). Each symmetry that moves the point has
    a zero, which is left out.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    complex128
        Shape (..., 12), in 1/s; NaN at the end for those that are left out; with gradient this and
        name -> derivatives, the amplitudes fixed; NaN where eigenvalues meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_b=r_b, r_a=r_a,
        omega_x=omega_x, omega_y=omega_y, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h,
        omega_phi=omega_phi,
    )
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma", "e_1", "e_2", "e_3", "e_4", "r_m", "r_b", "r_a", "omega_x", "omega_y", "mu_x",
            "mu_y", "mu_b", "r_h", "omega_phi",
        )
        if gradient
        else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike,
    e_3: ArrayLike, e_4: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike,
    omega_x: ArrayLike, omega_y: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike,
    r_h: ArrayLike, omega_phi: ArrayLike, order: int | None = None, drift: ArrayLike | None = None,
    gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. With a drift, constant ones turn along the
    symmetries of the slow flow. NaN where a harmonic resonates itself. Derivatives are taken with
    these fixed. Over times of order 1/ε the error is O(ε^2). A UserWarning says how much is left
    out where that is more than a tenth of the motion, estimated from the harmonics of each order
    beside those of order zero, and from the terms of the slow flow.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
    drift : array_like, optional
        Of an equilibrium that drifts, shape (..., 2), rad/s: as `equilibria` gives it.
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
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_b=r_b, r_a=r_a,
        omega_x=omega_x, omega_y=omega_y, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h,
        omega_phi=omega_phi,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        drift=drift,
        slow=(_FLOW, _coefficients, 15),
        names=(
            "sigma", "e_1", "e_2", "e_3", "e_4", "r_m", "r_b", "r_a", "omega_x", "omega_y", "mu_x",
            "mu_y", "mu_b", "r_h", "omega_phi",
        )
        if gradient
        else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike,
    e_3: ArrayLike, e_4: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike,
    omega_x: ArrayLike, omega_y: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike,
    r_h: ArrayLike, omega_phi: ArrayLike,
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
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
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
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_b=r_b, r_a=r_a,
        omega_x=omega_x, omega_y=omega_y, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h,
        omega_phi=omega_phi,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 15, False))
