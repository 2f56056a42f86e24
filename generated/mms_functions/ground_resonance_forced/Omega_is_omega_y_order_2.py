# Emitted by mmsgen 0.1.0 from derivations/ground_resonance_forced.py: change that, not this file.
# Made from sha256 f735638471da1c219fe26b12c48ed7bbbcea7074e0f2305796bc4d5873d77e09
# Operations for each point: slow_flow 330, coefficients 288, backbone 223, motion 525
"""ground_resonance_forced: Omega = omega_y + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: -omega_phi + 2*omega_y, -omega_phi + omega_x + omega_y,
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
RELATIONS: tuple[str, ...] = ("Omega = omega_y + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega_y + sigma"),
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
    "x": {},
    "y": {"sigma": 1},
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
        (0, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
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
    ((1, 0, 0, 0, 0, 0), (0, 0, 1, 1, 1, 1)),
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
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
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
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
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
    x0 = 1 / 2 * 1j
    x1 = omega_x + omega_y
    x2 = 1 / (omega_phi + x1)
    x3 = 1 / 4 * 1j
    x4 = r_b * r_m
    x5 = omega_x * omega_x
    x6 = omega_x * x5
    x7 = x4 * x6
    x8 = x3 * x7
    x9 = 1 / x1
    x10 = x8 * x9
    x11 = 1 / (x1 - omega_phi)
    x12 = omega_x - omega_y
    x13 = 1 / x12
    x14 = x7 / (omega_phi + x12)
    x15 = x13 * x14
    x16 = 1 / (omega_x - omega_phi - omega_y)
    x17 = 1 / 4 * omega_y
    x18 = 3 / 8 * sigma
    x19 = 1 / 8 * mu_y
    x20 = omega_phi * omega_phi
    x21 = 1 / x20
    x22 = omega_phi + 2 * omega_y
    x23 = 1 / x22
    x24 = 2 * omega_y - omega_phi
    x25 = 1 / x24
    x26 = omega_y * x20
    x27 = x20 * x20
    x28 = 1 / 2 * x27
    x29 = x20 * x4
    x30 = omega_y * omega_y
    x31 = x20 * x30
    x32 = mu_y * mu_y
    x33 = x30 * x30
    x34 = x30 * x33
    x35 = 1 / 128 * x29
    x36 = x25 * x35
    x37 = 1 / omega_phi
    x38 = 1 / 16 * x37
    x39 = x38 * x7
    x40 = x11 * x39
    x41 = x14 * x38
    x42 = 1 / 32 * x4
    x43 = (
        omega_y * x21 * x42 * (33 * x20 + 4 * x30) + x23 * x35 + x36 + x40 + x41
        - 1 / 16 * r_b * r_m * x16 * x37 * x6 - 1 / 16 * r_b * r_m * x2 * x37 * x6
    )
    x44 = -x43
    x45 = 1j * x30
    x46 = 1 / 16 * 1j
    x47 = (
        1 / 16 * 1j * r_b * r_m * x11 * x6 * x9 + 1 / 16 * 1j * r_b * r_m * x13 * x16 * x6
        + 1 / 32 * 1j * r_b * r_m * x25 * x30 - omega_phi * x0 * x4
        - x13 * x38 * x4 * x45 * x9 * (7 * x5 - 11 * x30) - x15 * x46 - x2 * x46 * x7 * x9
        - x23 * x42 * x45
    )
    x48 = omega_phi * x20
    x49 = 1 / x48
    x50 = mu_b * x48
    x51 = 3 / 8 * x27
    x52 = r_a * r_a
    x53 = x52 * x52
    x54 = 1 / 8 * x33 * x53
    x55 = e_1 * x52
    x56 = 1 / 2 * x20
    x57 = x30 * x56
    x58 = 1 / 4 * x31 * x52
    x59 = sigma * x26
    x60 = mu_b * mu_b
    x61 = 31 / 64 * x27 * x4 + 1 / 4 * x29 * x5 + 11 / 16 * x31 * x4 - x56 * x60
    x62 = (
        1j * x16 * x39 + 1j * x2 * x39 + 1j * x36 + 1j * x40 + 1j * x41
        - 1 / 128 * 1j * r_b * r_m * x20 * x23
    )
    x63 = e_1 * e_1
    x64 = e_2 * x52
    x65 = e_2 * e_2
    x66 = e_3 * x52
    x67 = e_3 * e_3
    x68 = e_4 * x52
    x69 = e_4 * e_4
    # Outputs
    out[..., 0] = (
        A_x * (mu_x * (-mu_x * x0 - omega_x) / omega_x + x10 * x11 + x10 * x2 + x13 * x16 * x8
        + x15 * x3)
    )
    out[..., 1] = (
        A_y * x21 * x23 * x25 * (1j * (x28 * x32 + x29 * x33 - 2 * x31 * x32 - 2 * x34 * x4)
        - mu_y * x22 * x24 * x26) / omega_y + r_m * (r_h + 1) * (e_2 * x19 + e_3 * x17 + e_3 * x18
        + 1j * (1 / 8 * e_3 * mu_y + 1 / 4 * e_4 * omega_y + 3 / 8 * e_4 * sigma - e_1 * x19 - e_2
        * x17 - e_2 * x18) - e_1 * x17 - e_1 * x18 - e_4 * x19) - 1j * A_y * sigma
    )
    out[..., 2] = (
        A_phi_1 * (x49 * (x50 * (e_1 - 1)
        + 1j * (x51 * x63 + x55 * x57 + x55 * x59 + x61 - e_1 * x28 - x54 * x63 - x58 * x63)) - x62)
        + A_phi_2 * x44 + A_phi_3 * x47 + A_phi_4 * x43
    )
    out[..., 3] = (
        A_phi_1 * x43 + A_phi_2 * (x49 * (x50 * (e_2 - 1) + 1j * (x51 * x65 + x57 * x64 + x59 * x64
        + x61 - e_2 * x28 - x54 * x65 - x58 * x65)) - x62) + A_phi_3 * x44 + A_phi_4 * x47
    )
    out[..., 4] = (
        A_phi_1 * x47 + A_phi_2 * x43 + A_phi_3 * (x49 * (x50 * (e_3 - 1) + 1j * (x51 * x67 + x57
        * x66 + x59 * x66 + x61 - e_3 * x28 - x54 * x67 - x58 * x67)) - x62) + A_phi_4 * x44
    )
    out[..., 5] = (
        A_phi_1 * x44 + A_phi_2 * x47 + A_phi_3 * x43 + A_phi_4 * (x49 * (x50 * (e_4 - 1) + 1j
        * (x51 * x69 + x57 * x68 + x59 * x68 + x61 - e_4 * x28 - x54 * x69 - x58 * x69)) - x62)
    )


def _coefficients(
    out, sigma, e_1, e_2, e_3, e_4, r_m, r_b, r_a, omega_x, omega_y, mu_x, mu_y, mu_b, r_h,
    omega_phi,
):
    # Intermediates
    x0 = 1 / 2 * 1j
    x1 = r_b * r_m
    x2 = omega_x * omega_x
    x3 = omega_x * x2
    x4 = x1 * x3
    x5 = omega_x + omega_y
    x6 = x4 / (omega_phi + x5)
    x7 = 1 / x5
    x8 = 1 / 4 * 1j
    x9 = x7 * x8
    x10 = 1 / (x5 - omega_phi)
    x11 = omega_x - omega_y
    x12 = 1 / (omega_phi + x11)
    x13 = 1 / x11
    x14 = x13 * x4
    x15 = x14 * x8
    x16 = 1 / (omega_x - omega_phi - omega_y)
    x17 = 1 / 4 * omega_y
    x18 = 3 / 8 * sigma
    x19 = 1 / 8 * mu_y
    x20 = omega_phi * omega_phi
    x21 = 1 / x20
    x22 = omega_phi + 2 * omega_y
    x23 = 1 / x22
    x24 = 2 * omega_y - omega_phi
    x25 = 1 / x24
    x26 = omega_y * x20
    x27 = x20 * x20
    x28 = 1 / 2 * x27
    x29 = x1 * x20
    x30 = omega_y * omega_y
    x31 = x20 * x30
    x32 = mu_y * mu_y
    x33 = x30 * x30
    x34 = x30 * x33
    x35 = 1 / 128 * x29
    x36 = x25 * x35
    x37 = 1 / 16 / omega_phi
    x38 = x37 * x6
    x39 = x37 * x4
    x40 = x10 * x39
    x41 = x12 * x39
    x42 = 1 / 32 * x1
    x43 = x16 * x39
    x44 = omega_y * x21 * x42 * (33 * x20 + 4 * x30) + x23 * x35 + x36 + x40 + x41 - x38 - x43
    x45 = 1j * x30
    x46 = 1 / 16 * 1j
    x47 = (
        1 / 16 * 1j * r_b * r_m * x10 * x3 * x7 + 1 / 16 * 1j * r_b * r_m * x13 * x16 * x3
        + 1 / 32 * 1j * r_b * r_m * x25 * x30 - omega_phi * x0 * x1
        - x1 * x13 * x37 * x45 * x7 * (7 * x2 - 11 * x30) - x12 * x14 * x46 - x23 * x42 * x45
        - x46 * x6 * x7
    )
    x48 = -x44
    x49 = omega_phi * x20
    x50 = 1 / x49
    x51 = mu_b * x49
    x52 = 3 / 8 * x27
    x53 = r_a * r_a
    x54 = x53 * x53
    x55 = 1 / 8 * x33 * x54
    x56 = e_1 * x53
    x57 = 1 / 2 * x20
    x58 = x30 * x57
    x59 = 1 / 4 * x31 * x53
    x60 = sigma * x26
    x61 = mu_b * mu_b
    x62 = 31 / 64 * x1 * x27 + 11 / 16 * x1 * x31 + 1 / 4 * x2 * x29 - x57 * x61
    x63 = (
        1j * x36 + 1j * x38 + 1j * x40 + 1j * x41 + 1j * x43 - 1 / 128 * 1j * r_b * r_m * x20 * x23
    )
    x64 = e_1 * e_1
    x65 = e_2 * x53
    x66 = e_2 * e_2
    x67 = e_3 * x53
    x68 = e_3 * e_3
    x69 = e_4 * x53
    x70 = e_4 * e_4
    # Outputs
    out[..., 0] = (
        mu_x * (-mu_x * x0 - omega_x) / omega_x + x10 * x4 * x9 + x12 * x15 + x15 * x16 + x6 * x9
    )
    out[..., 1] = (
        r_m * (r_h + 1) * (e_2 * x19 + e_3 * x17 + e_3 * x18 + 1j * (1 / 8 * e_3 * mu_y + 1 / 4
        * e_4 * omega_y + 3 / 8 * e_4 * sigma - e_1 * x19 - e_2 * x17 - e_2 * x18) - e_1 * x17
        - e_1 * x18 - e_4 * x19)
    )
    out[..., 2] = (
        x21 * x23 * x25 * (1j * (x28 * x32 + x29 * x33 - 2 * x1 * x34 - 2 * x31 * x32)
        - mu_y * x22 * x24 * x26) / omega_y - 1j * sigma
    )
    out[..., 3] = x44
    out[..., 4] = x47
    out[..., 5] = x48
    out[..., 6] = (
        x50 * (x51 * (e_1 - 1)
        + 1j * (x52 * x64 + x56 * x58 + x56 * x60 + x62 - e_1 * x28 - x55 * x64 - x59 * x64)) - x63
    )
    out[..., 7] = x47
    out[..., 8] = x48
    out[..., 9] = (
        x50 * (x51 * (e_2 - 1)
        + 1j * (x52 * x66 + x58 * x65 + x60 * x65 + x62 - e_2 * x28 - x55 * x66 - x59 * x66)) - x63
    )
    out[..., 10] = x44
    out[..., 11] = x48
    out[..., 12] = (
        x50 * (x51 * (e_3 - 1)
        + 1j * (x52 * x68 + x58 * x67 + x60 * x67 + x62 - e_3 * x28 - x55 * x68 - x59 * x68)) - x63
    )
    out[..., 13] = x44
    out[..., 14] = x47
    out[..., 15] = (
        x50 * (x51 * (e_4 - 1)
        + 1j * (x52 * x70 + x58 * x69 + x60 * x69 + x62 - e_4 * x28 - x55 * x70 - x59 * x70)) - x63
    )
    out[..., 16] = x44
    out[..., 17] = x47
    out[..., 18] = x48


def _backbone(
    out, sigma, e_1, e_2, e_3, e_4, r_m, r_b, r_a, omega_x, omega_y, mu_x, mu_y, mu_b, r_h,
    omega_phi,
):
    # Intermediates
    x0 = omega_x + omega_y
    x1 = 1 / (omega_phi + x0)
    x2 = 1 / x0
    x3 = r_b * r_m
    x4 = omega_x * omega_x
    x5 = omega_x * x4
    x6 = x3 * x5
    x7 = 1 / 4 * x6
    x8 = x2 * x7
    x9 = 1 / (x0 - omega_phi)
    x10 = omega_x - omega_y
    x11 = 1 / (omega_phi + x10)
    x12 = 1 / x10
    x13 = x12 * x7
    x14 = 1 / (omega_x - omega_phi - omega_y)
    x15 = mu_x * mu_x
    x16 = omega_phi * omega_phi
    x17 = 1 / x16
    x18 = 1 / (omega_phi + 2 * omega_y)
    x19 = 1 / (2 * omega_y - omega_phi)
    x20 = x16 * x16
    x21 = 1 / 2 * x20
    x22 = x16 * x3
    x23 = omega_y * omega_y
    x24 = x16 * x23
    x25 = mu_y * mu_y
    x26 = x23 * x23
    x27 = x23 * x26
    x28 = 1 / 128 * x22
    x29 = x18 * x28
    x30 = 1 / omega_phi
    x31 = 1 / 16 * x6
    x32 = x30 * x31
    x33 = x1 * x32
    x34 = x14 * x32
    x35 = 1 / 32 * x3
    x36 = x11 * x32 + x19 * x28 + x32 * x9
    x37 = omega_y * x17 * x35 * (33 * x16 + 4 * x23) + x29 + x36 - x33 - x34
    x38 = (
        1j * (1 / 16 * r_b * r_m * x12 * x14 * x5 + 1 / 32 * r_b * r_m * x19 * x23
        + 1 / 16 * r_b * r_m * x2 * x5 * x9 - 1 / 2 * omega_phi * x3 - x1 * x2 * x31
        - x11 * x12 * x31 - 1 / 16 * x12 * x2 * x23 * x3 * x30 * (7 * x4 - 11 * x23)
        - x18 * x23 * x35)
    )
    x39 = -x37
    x40 = omega_phi * x16
    x41 = 1 / x40
    x42 = 3 / 8 * x20
    x43 = r_a * r_a
    x44 = x43 * x43
    x45 = 1 / 8 * x26 * x44
    x46 = e_1 * x43
    x47 = 1 / 2 * x16
    x48 = x23 * x47
    x49 = 1 / 4 * x24 * x43
    x50 = omega_y * sigma * x16
    x51 = mu_b * mu_b
    x52 = 31 / 64 * x20 * x3 + 1 / 4 * x22 * x4 + 11 / 16 * x24 * x3 - x47 * x51
    x53 = x33 + x34 + x36 - x29
    x54 = e_1 * e_1
    x55 = e_2 * x43
    x56 = e_2 * e_2
    x57 = e_3 * x43
    x58 = e_3 * e_3
    x59 = e_4 * x43
    x60 = e_4 * e_4
    # Outputs
    out[..., 0] = 1j * (x1 * x8 + x11 * x13 + x13 * x14 + x8 * x9 - 1 / 2 * x15 / omega_x)
    out[..., 1] = (
        1j * x17 * x18 * x19 * (x21 * x25 + x22 * x26 - 2 * x24 * x25 - 2 * x27 * x3) / omega_y
        - 1j * sigma
    )
    out[..., 2] = x37
    out[..., 3] = x38
    out[..., 4] = x39
    out[..., 5] = (
        1j * (x41 * (x42 * x54 + x46 * x48 + x46 * x50 + x52 - e_1 * x21 - x45 * x54 - x49 * x54)
        - x53)
    )
    out[..., 6] = x38
    out[..., 7] = x39
    out[..., 8] = (
        1j * (x41 * (x42 * x56 + x48 * x55 + x50 * x55 + x52 - e_2 * x21 - x45 * x56 - x49 * x56)
        - x53)
    )
    out[..., 9] = x37
    out[..., 10] = x39
    out[..., 11] = (
        1j * (x41 * (x42 * x58 + x48 * x57 + x50 * x57 + x52 - e_3 * x21 - x45 * x58 - x49 * x58)
        - x53)
    )
    out[..., 12] = x37
    out[..., 13] = x38
    out[..., 14] = (
        1j * (x41 * (x42 * x60 + x48 * x59 + x50 * x59 + x52 - e_4 * x21 - x45 * x60 - x49 * x60)
        - x53)
    )
    out[..., 15] = x37
    out[..., 16] = x38
    out[..., 17] = x39
    out[..., 19] = sigma


def _motion(
    out, sigma, e_1, e_2, e_3, e_4, r_m, r_b, r_a, omega_x, omega_y, mu_x, mu_y, mu_b, r_h,
    omega_phi,
):
    # Intermediates
    x0 = omega_y * omega_y
    x1 = 2 * x0
    x2 = 1 / 2 * e_2
    x3 = 1 / 2 * e_4
    x4 = x2 - x3
    x5 = 1 / 2 * e_1
    x6 = 1 / 2 * e_3
    x7 = x5 - x6
    x8 = r_m * (r_h + 1)
    x9 = omega_x + omega_y
    x10 = -omega_y
    x11 = omega_x + x10
    x12 = 1 / (x11 * x9)
    x13 = x12 * x8
    x14 = x13 * (1j * x4 + x7)
    x15 = -omega_phi - x10
    x16 = x15 * x15
    x17 = r_m * x16
    x18 = omega_phi + x11
    x19 = 1 / x18
    x20 = x9 - omega_phi
    x21 = 1 / x20
    x22 = x19 * x21
    x23 = x17 * x22
    x24 = omega_phi + omega_y
    x25 = x24 * x24
    x26 = r_m * x25
    x27 = omega_phi + x9
    x28 = 1 / x27
    x29 = omega_x - x24
    x30 = 1 / x29
    x31 = x28 * x30
    x32 = x26 * x31
    x33 = 1j * x23
    x34 = 1j * x32
    x35 = 1 / omega_phi
    x36 = 2 * omega_y - omega_phi
    x37 = 1 / x36
    x38 = x17 * x35 * x37
    x39 = 1j * x38
    x40 = 2 * omega_y
    x41 = omega_phi + x40
    x42 = 1 / x41
    x43 = x26 * x35 * x42
    x44 = 1j * x43
    x45 = omega_phi * omega_phi
    x46 = 1 / x45
    x47 = r_b * x0
    x48 = x46 * x47
    x49 = x37 * x42
    x50 = x47 * x49
    x51 = omega_x * omega_x
    x52 = r_b * x51
    x53 = x19 * x52
    x54 = x30 * x53
    x55 = 1j * x54
    x56 = x21 * x52
    x57 = x28 * x56
    x58 = 1j * x57
    x59 = 1j * x48
    x60 = 1j * x50
    x61 = sigma * x51
    x62 = mu_x * x0
    x63 = x11 * x11
    x64 = x9 * x9
    x65 = omega_phi * x45
    x66 = 3 / 2 * omega_y * x65
    x67 = e_4 * x66
    x68 = -x67
    x69 = omega_y * x0
    x70 = omega_phi * x69
    x71 = x3 * x70
    x72 = x3 * x51
    x73 = omega_phi * omega_y
    x74 = r_a * r_a
    x75 = x0 * x74
    x76 = e_4 * x45
    x77 = 3 / 2 * x0
    x78 = x45 * x45
    x79 = x3 * x78 + x76 * x77
    x80 = x79 - x72 * x75
    x81 = omega_phi * x61
    x82 = -x62
    x83 = omega_phi * x40
    x84 = mu_x * x83
    x85 = mu_b * x51
    x86 = mu_x * x45
    x87 = x85 - x86
    x88 = omega_phi * (-x82 - x84 - x87)
    x89 = x81 + 1j * x88
    x90 = x18 * x18
    x91 = 1 / x90
    x92 = x20 * x20
    x93 = 1 / x92
    x94 = 2 * r_m
    x95 = x35 * x94
    x96 = x15 * x91 * x93 * x95
    x97 = -x81
    x98 = x86 - x85
    x99 = omega_phi * (x62 + x84 + x98)
    x100 = x97 + 1j * x99
    x101 = x29 * x29
    x102 = 1 / x101
    x103 = x27 * x27
    x104 = 1 / x103
    x105 = x102 * x104 * x24 * x95
    x106 = e_3 * x66
    x107 = -x106
    x108 = x6 * x70
    x109 = x51 * x6
    x110 = x109 * x73
    x111 = e_3 * x45
    x112 = x111 * x77 + x6 * x78
    x113 = x112 - x109 * x75
    x114 = e_2 * x66
    x115 = -x114
    x116 = x2 * x51
    x117 = x116 * x73
    x118 = e_2 * x45
    x119 = x118 * x77 + x2 * x78
    x120 = x119 - x116 * x75
    x121 = e_1 * x66
    x122 = -x121
    x123 = x5 * x70
    x124 = x5 * x51 * x73
    x125 = e_1 * x45
    x126 = x125 * x77 + x5 * x78
    x127 = x126 - 1 / 2 * e_1 * x0 * x51 * x74
    x128 = 8 * 1j * r_m * x12
    x129 = x0 * x0
    x130 = x0 * x129
    x131 = mu_b * x0
    x132 = mu_y * x83
    x133 = mu_y * x45
    x134 = -x133
    x135 = omega_phi * (mu_y * x0 - x131 - x132 - x134)
    x136 = omega_phi * sigma * x0
    x137 = x129 * x74
    x138 = x79 - x137 * x3
    x139 = x36 * x36
    x140 = 1 / x139
    x141 = x94 / x65
    x142 = x140 * x141 * x15
    x143 = mu_y * x0
    x144 = omega_phi * (x132 + x133 + x143 - x131)
    x145 = -x136
    x146 = x41 * x41
    x147 = 1 / x146
    x148 = x141 * x147 * x24
    x149 = 1j * x135 + x136
    x150 = x112 - x137 * x6
    x151 = 1j * x144 + x145
    x152 = x119 - 1 / 2 * e_2 * x129 * x74
    x153 = x126 - x137 * x5
    x154 = omega_y * r_b
    x155 = x51 * x51
    x156 = omega_x * x155
    x157 = 1 / 2 * x13 * x48 * (x51 - x1)
    x158 = x157 * (e_2 - e_4)
    x159 = x140 * x147
    x160 = x159 * x47 * (x1 * x51 + 2 * x129 - x45 * x51)
    x161 = x13 * x160
    x162 = 1 / 16 * r_m
    x163 = x154 * x162
    x164 = x163 * x35
    x165 = 1j * x164
    x166 = x163 * x37
    x167 = 1 / omega_y
    x168 = x162 * x167
    x169 = x168 * x53
    x170 = 1j * x166 + 1j * x169 - x165 - 1j * x168 * x56
    x171 = x163 * x42
    x172 = x168 * x30 * x52
    x173 = x165 + 1j * x171 + 1j * x172 - 1 / 16 * 1j * r_b * r_m * x167 * x28 * x51
    x174 = -x173
    x175 = x166 + x169 - 1 / 16 * r_b * r_m * x167 * x21 * x51 - x164
    x176 = -x175
    x177 = x164 + x171 + x172 - 1 / 16 * r_b * r_m * x167 * x28 * x51
    x178 = -x177
    x179 = -x170
    x180 = -1j * x133
    x181 = omega_y * (omega_y * r_a - omega_phi) * (omega_phi + omega_y * r_a)
    x182 = r_b * x40
    x183 = x182 / x78
    x184 = 2 * x131 + x134 + 2 * x143
    x185 = 4 * omega_y * sigma
    x186 = x125 - e_1 * x0 * x74
    x187 = 1 / 2 * omega_y
    x188 = x159 * x182
    x189 = 2 * omega_x
    x190 = sigma * x189
    x191 = -x190
    x192 = sigma * x40
    x193 = x186 + x192
    x194 = 1 / 2 * omega_x
    x195 = 1j * x194
    x196 = omega_x * omega_y
    x197 = mu_b * x196 + mu_x * x196
    x198 = x197 + x82 + x98
    x199 = r_b * x189
    x200 = x102 * x199 * x91
    x201 = x197 + x62 + x87
    x202 = x104 * x199 * x93
    x203 = x157 * (e_1 - e_3)
    x204 = 1j * x181
    x205 = x118 - e_2 * x0 * x74
    x206 = x192 + x205
    x207 = x111 - e_3 * x0 * x74
    x208 = x192 + x207
    x209 = x76 - e_4 * x0 * x74
    x210 = x192 + x209
    x211 = omega_y + sigma
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = x1 * x14
    out[..., 7] = x23
    out[..., 8] = x32
    out[..., 9] = x33
    out[..., 10] = -x34
    out[..., 11] = -x23
    out[..., 12] = -x32
    out[..., 13] = -x33
    out[..., 14] = x34
    out[..., 15] = x39
    out[..., 16] = x44
    out[..., 17] = -x38
    out[..., 18] = x43
    out[..., 19] = -x39
    out[..., 20] = -x44
    out[..., 21] = x38
    out[..., 22] = -x43
    out[..., 23] = x48
    out[..., 24] = -x50
    out[..., 25] = x55
    out[..., 26] = -x58
    out[..., 27] = -x59
    out[..., 28] = -x60
    out[..., 29] = x54
    out[..., 30] = x57
    out[..., 31] = -x48
    out[..., 32] = x50
    out[..., 33] = -x55
    out[..., 34] = x58
    out[..., 35] = x59
    out[..., 36] = x60
    out[..., 37] = -x54
    out[..., 38] = -x57
    out[..., 39] = (
        x40 * x8 * (e_1 * x61 + e_2 * x62
        + 1j * (e_2 * sigma * x51 + e_3 * mu_x * x0 - e_1 * x62 - e_4 * x61) - e_3 * x61
        - e_4 * x62) / (x63 * x64)
    )
    out[..., 40] = x96 * (x68 + x72 * x73 + x80 + x89 - x71)
    out[..., 41] = x105 * (1 / 2 * e_4 * omega_phi * omega_y * x51 - x100 - x67 - x71 - x80)
    out[..., 42] = x96 * (1j * (x107 + x110 + x113 + x81 - x108) - x88)
    out[..., 43] = x105 * (1j * (x106 + x108 + x113 + x97 - x110) - x99)
    out[..., 44] = x96 * (1 / 2 * e_2 * omega_phi * x69 - x115 - x117 - x120 - x89)
    out[..., 45] = x105 * (x100 + x114 + x120 + x2 * x70 - x117)
    out[..., 46] = x96 * (x88 + 1j * (x123 - x122 - x124 - x127 - x81))
    out[..., 47] = x105 * (x99 + 1j * (x124 - x121 - x123 - x127 - x97))
    out[..., 48] = r_b * x128 * x130 * x46 * x49
    out[..., 49] = x142 * (1j * (x136 + x138 + x68) - x135)
    out[..., 50] = x148 * (1j * (x138 + x145 + x67) - x144)
    out[..., 51] = x142 * (-x107 - x149 - x150)
    out[..., 52] = x148 * (x106 + x150 + x151)
    out[..., 53] = x142 * (x135 + 1j * (-x115 - x136 - x152))
    out[..., 54] = x148 * (x144 + 1j * (-x114 - x145 - x152))
    out[..., 55] = x142 * (x122 + x149 + x153)
    out[..., 56] = x148 * (-x121 - x151 - x153)
    out[..., 57] = -x128 * x154 * x156 * x22 * x31
    out[..., 58] = -x158
    out[..., 59] = x161 * (x4 - 1j * x7)
    out[..., 60] = x170
    out[..., 61] = x174
    out[..., 62] = x176
    out[..., 63] = x178
    out[..., 64] = x179
    out[..., 65] = x173
    out[..., 66] = x175
    out[..., 67] = x177
    out[..., 68] = x183 * (-x180 - x181 * x5)
    out[..., 69] = x188 * (-1j * x184 - x187 * (-x185 - x186))
    out[..., 70] = x200 * (x195 * (-x191 - x193) + x198)
    out[..., 71] = x202 * (x201 - x195 * (-x190 - x193))
    out[..., 72] = x203
    out[..., 73] = x14 * x160
    out[..., 74] = x175
    out[..., 75] = x177
    out[..., 76] = x170
    out[..., 77] = x174
    out[..., 78] = x176
    out[..., 79] = x178
    out[..., 80] = x179
    out[..., 81] = x173
    out[..., 82] = x183 * (x133 + x2 * x204)
    out[..., 83] = x188 * (x184 - 1j * x187 * (-x185 - x205))
    out[..., 84] = x200 * (x194 * (-x191 - x206) - 1j * x198)
    out[..., 85] = x202 * (x194 * (-x190 - x206) + 1j * x201)
    out[..., 86] = x158
    out[..., 87] = x161 * (x3 + 1j * x7 - x2)
    out[..., 88] = x179
    out[..., 89] = x173
    out[..., 90] = x175
    out[..., 91] = x177
    out[..., 92] = x170
    out[..., 93] = x174
    out[..., 94] = x176
    out[..., 95] = x178
    out[..., 96] = x183 * (x180 + x181 * x6)
    out[..., 97] = x188 * (1j * x184 + x187 * (-x185 - x207))
    out[..., 98] = x200 * (-x195 * (-x191 - x208) - x198)
    out[..., 99] = x202 * (1 / 2 * 1j * omega_x * (-x190 - x208) - x201)
    out[..., 100] = -x203
    out[..., 101] = x161 * (x6 - 1j * x4 - x5)
    out[..., 102] = x176
    out[..., 103] = x178
    out[..., 104] = x179
    out[..., 105] = x173
    out[..., 106] = x175
    out[..., 107] = x177
    out[..., 108] = x170
    out[..., 109] = x174
    out[..., 110] = x183 * (-x133 - x204 * x3)
    out[..., 111] = x188 * (1 / 2 * 1j * omega_y * (-x185 - x209) - x184)
    out[..., 112] = x200 * (1j * x198 - x194 * (-x191 - x210))
    out[..., 113] = x202 * (-x194 * (-x190 - x210) - 1j * x201)
    out[..., 114] = omega_x
    out[..., 115] = x211
    out[..., 116] = omega_phi
    out[..., 117] = omega_phi
    out[..., 118] = omega_phi
    out[..., 119] = omega_phi
    out[..., 120] = x211


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
        Detuning, Omega = omega_y + sigma, rad/s, real.
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
    further ones for k = (1, 0, 0, 0, 0, 0), (0, 0, 1, 1, 1, 1); of each circle one point is given,
    and the rate at which it drifts, B_j exp(i k_j ρ t).

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_y + sigma, rad/s, real.
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
        Detuning, Omega = omega_y + sigma, rad/s, real.
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
