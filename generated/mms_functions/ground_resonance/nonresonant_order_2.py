# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 05ee6773aa1e23b66bce083433a5f02d000e89e1c63728b45328bca9442055a0
# Operations for each point: growth_rate 0, slow_flow_matrix 92, characteristic_coefficients 96,
# slow_flow 155, motion 114
"""ground_resonance: no resonance, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

It cannot be unstable: one mode turns without growing.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: Omega + omega_phi - omega_x, Omega + omega_phi - omega_y, Omega -
omega_phi + omega_x, Omega - omega_phi + omega_y, Omega - omega_phi - omega_x, Omega - omega_phi -
omega_y.

Source: Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._evolution import Linear, evolution_at
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
RELATIONS: tuple[str, ...] = ()

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "Omega": ("positive", "rad/s", "rotor speed"),
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
        ((0, 0),), ((1, 0),), ((2, 0), (3, 0), (4, 0), (5, 0)),
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
        (2, 0, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 1, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 3, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 4, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-2,)),
        (2, 5, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (2,)),
    ),
    1,
)


def _growth_rate(Omega, r_m, r_b, omega_x, omega_y, omega_phi):
    return 0.0


def _slow_flow_matrix(out, Omega, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = -omega_phi
    x1 = Omega + omega_x
    x2 = 1 / (x0 + x1)
    x3 = Omega - omega_x
    x4 = 1 / (omega_phi + x3)
    x5 = 1 / (omega_phi + x1)
    x6 = omega_phi - Omega
    x7 = 1 / (-omega_x - x6)
    x8 = Omega * Omega
    x9 = omega_phi * omega_phi
    x10 = x8 - x9
    x11 = r_b * r_m
    x12 = omega_x * omega_x
    x13 = omega_x * x12
    x14 = Omega + omega_y
    x15 = 1 / (x0 + x14)
    x16 = Omega - omega_y
    x17 = 1 / (omega_phi + x16)
    x18 = 1 / (omega_phi + x14)
    x19 = 1 / (-omega_y - x6)
    x20 = omega_y * omega_y
    x21 = omega_y * x20
    x22 = 1 / x1
    x23 = 1 / 16 * x13
    x24 = x22 * x23
    x25 = x2 * x24
    x26 = 1 / x14
    x27 = 1 / 16 * x21
    x28 = x26 * x27
    x29 = x15 * x28
    x30 = 1 / x3
    x31 = x23 * x30
    x32 = x31 * x7
    x33 = 1 / x16
    x34 = x27 * x33
    x35 = x19 * x34
    x36 = x18 * x28 + x24 * x5 - x17 * x34 - x31 * x4
    x37 = x8 * x8
    x38 = (
        1 / 2 * omega_phi + x32 + x35 + x36
        + 1 / 4 * x22 * x26 * x30 * x33 * x37 * (2 * x8 - x12 - x20) / omega_phi - x25 - x29
    )
    x39 = x11 * x38
    x40 = Omega + x25 + x29 + x36 - x32 - x35
    x41 = -x11 * x40
    x42 = -x11 * x38
    x43 = x11 * x40
    # Outputs
    out[..., 0, 0].imag = x11 * x13 * x2 * x4 * x5 * x7 * (x10 + x12)
    out[..., 1, 1].imag = x11 * x15 * x17 * x18 * x19 * x21 * (x10 + x20)
    out[..., 2, 2].imag = x39
    out[..., 2, 3].real = x41
    out[..., 2, 4].imag = x42
    out[..., 2, 5].real = x43
    out[..., 3, 2].real = x43
    out[..., 3, 3].imag = x39
    out[..., 3, 4].real = x41
    out[..., 3, 5].imag = x42
    out[..., 4, 2].imag = x42
    out[..., 4, 3].real = x43
    out[..., 4, 4].imag = x39
    out[..., 4, 5].real = x41
    out[..., 5, 2].real = x41
    out[..., 5, 3].imag = x42
    out[..., 5, 4].real = x43
    out[..., 5, 5].imag = x39


def _characteristic_coefficients(out, Omega, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = omega_phi - Omega
    x1 = 1 / (-omega_x - x0)
    x2 = -omega_phi
    x3 = Omega + omega_x
    x4 = 1 / (x2 + x3)
    x5 = 1 / (omega_phi + x3)
    x6 = Omega - omega_x
    x7 = 1 / (omega_phi + x6)
    x8 = Omega * Omega
    x9 = omega_phi * omega_phi
    x10 = x8 - x9
    x11 = 1j * r_b * r_m
    x12 = omega_x * omega_x
    x13 = omega_x * x12
    x14 = 1 / (-omega_y - x0)
    x15 = Omega + omega_y
    x16 = 1 / (x15 + x2)
    x17 = 1 / (omega_phi + x15)
    x18 = Omega - omega_y
    x19 = 1 / (omega_phi + x18)
    x20 = omega_y * omega_y
    x21 = omega_y * x20
    x22 = 2 * Omega
    x23 = 1 / x3
    x24 = 1 / x15
    x25 = 1 / x6
    x26 = 1 / 4 * x13
    x27 = 1 / x18
    x28 = 1 / 4 * x21
    x29 = x8 * x8
    x30 = omega_phi + 1 / 2 * x23 * x24 * x25 * x27 * x29 * (2 * x8 - x12 - x20) / omega_phi
    # Outputs
    c1_0 = -x1 * x11 * x13 * x4 * x5 * x7 * (x10 + x12)
    c2_0 = -x11 * x14 * x16 * x17 * x19 * x21 * (x10 + x20)
    c3_0 = (
        x11 * (1 / 4 * x13 * x23 * x4 + 1 / 4 * x16 * x21 * x24 + x22 - x1 * x25 * x26
        - x14 * x27 * x28 - x30)
    )
    c4_0 = (
        x11 * (1 / 4 * x13 * x25 * x7 + 1 / 4 * x19 * x21 * x27 - x17 * x24 * x28 - x22
        - x23 * x26 * x5 - x30)
    )
    multiply_out(out, ((c1_0,), 1), ((c2_0,), 1), ((c3_0,), 1), ((c4_0,), 1), ((0.0,), 2))


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, Omega, r_m, r_b, omega_x, omega_y, omega_phi,
):
    # Intermediates
    x0 = -omega_phi
    x1 = Omega + omega_x
    x2 = 1 / (x0 + x1)
    x3 = Omega - omega_x
    x4 = 1 / (omega_phi + x3)
    x5 = omega_phi - Omega
    x6 = 1 / (-omega_x - x5)
    x7 = Omega * Omega
    x8 = omega_phi * omega_phi
    x9 = x7 - x8
    x10 = r_b * r_m
    x11 = 1j * x10
    x12 = omega_x * omega_x
    x13 = omega_x * x12
    x14 = x13 / (omega_phi + x1)
    x15 = Omega + omega_y
    x16 = 1 / (omega_phi + x15)
    x17 = 1 / (x0 + x15)
    x18 = Omega - omega_y
    x19 = 1 / (omega_phi + x18)
    x20 = 1 / (-omega_y - x5)
    x21 = omega_y * omega_y
    x22 = omega_y * x21
    x23 = 1 / x1
    x24 = 1 / 16 * x10
    x25 = x23 * x24
    x26 = 1 / x15
    x27 = x22 * x24 * x26
    x28 = x13 * x2
    x29 = 1 / x3
    x30 = 1 / x18
    x31 = (
        Omega * x10 + x14 * x25 + x16 * x27 + x17 * x27 + x25 * x28
        - 1 / 16 * r_b * r_m * x13 * x29 * x4 - 1 / 16 * r_b * r_m * x13 * x29 * x6
        - 1 / 16 * r_b * r_m * x19 * x22 * x30 - 1 / 16 * r_b * r_m * x20 * x22 * x30
    )
    x32 = -x31
    x33 = 1 / 16 * x11
    x34 = x23 * x33
    x35 = x22 * x33
    x36 = x26 * x35
    x37 = x13 * x29 * x33
    x38 = x30 * x35
    x39 = x7 * x7
    x40 = (
        1 / 2 * omega_phi * x11 + x14 * x34 + x16 * x36 + x20 * x38 + x37 * x6
        + 1 / 4 * x11 * x23 * x26 * x29 * x30 * x39 * (2 * x7 - x12 - x21) / omega_phi - x17 * x36
        - x19 * x38 - x28 * x34 - x37 * x4
    )
    x41 = -x40
    # Outputs
    out[..., 0] = A_x * x11 * x14 * x2 * x4 * x6 * (x12 + x9)
    out[..., 1] = A_y * x11 * x16 * x17 * x19 * x20 * x22 * (x21 + x9)
    out[..., 2] = A_phi_1 * x40 + A_phi_2 * x32 + A_phi_3 * x41 + A_phi_4 * x31
    out[..., 3] = A_phi_1 * x31 + A_phi_2 * x40 + A_phi_3 * x32 + A_phi_4 * x41
    out[..., 4] = A_phi_1 * x41 + A_phi_2 * x31 + A_phi_3 * x40 + A_phi_4 * x32
    out[..., 5] = A_phi_1 * x32 + A_phi_2 * x41 + A_phi_3 * x31 + A_phi_4 * x40


def _motion(out, Omega, r_m, r_b, omega_x, omega_y, omega_phi):
    # Intermediates
    x0 = Omega - omega_phi
    x1 = x0 * x0
    x2 = r_m * x1
    x3 = 1 / (omega_x + x0)
    x4 = omega_phi - Omega
    x5 = 1 / (-omega_x - x4)
    x6 = x3 * x5
    x7 = x2 * x6
    x8 = Omega + omega_phi
    x9 = x8 * x8
    x10 = r_m * x9
    x11 = 1 / (omega_x + x8)
    x12 = 1 / (x8 - omega_x)
    x13 = x11 * x12
    x14 = x10 * x13
    x15 = 1j * x7
    x16 = 1j * x14
    x17 = 1 / (omega_y + x0)
    x18 = 1 / (-omega_y - x4)
    x19 = x17 * x18
    x20 = x19 * x2
    x21 = 1j * x20
    x22 = 1 / (omega_y + x8)
    x23 = -omega_y
    x24 = 1 / (x23 + x8)
    x25 = x22 * x24
    x26 = x10 * x25
    x27 = 1j * x26
    x28 = omega_y * omega_y
    x29 = r_b * x28
    x30 = x18 * x29
    x31 = x24 * x30
    x32 = x17 * x29
    x33 = x22 * x32
    x34 = omega_x * omega_x
    x35 = r_b * x34
    x36 = x35 * x5
    x37 = x12 * x36
    x38 = 1j * x37
    x39 = x3 * x35
    x40 = x11 * x39
    x41 = 1j * x40
    x42 = 1j * x31
    x43 = 1j * x33
    x44 = 8 * 1j * Omega * r_b * r_m / ((omega_x + omega_y) * (omega_x + x23))
    x45 = x28 * x28
    x46 = omega_y * x45
    x47 = x34 * x34
    x48 = omega_x * x47
    x49 = 1 / Omega
    x50 = 1 / 16 * r_m * x49
    x51 = x39 * x50
    x52 = x36 * x50
    x53 = (
        1j * x51 + 1j * x52 - 1 / 16 * 1j * r_b * r_m * x17 * x28 * x49
        - 1 / 16 * 1j * r_b * r_m * x18 * x28 * x49
    )
    x54 = -x53
    x55 = x35 * x50
    x56 = x11 * x55
    x57 = x29 * x50
    x58 = x22 * x57
    x59 = x12 * x55
    x60 = x24 * x57
    x61 = 1j * x56 + 1j * x59 - 1j * x58 - 1j * x60
    x62 = x51 + x52 - x30 * x50 - x32 * x50
    x63 = x56 + x59 - x58 - x60
    x64 = -x61
    x65 = -x62
    x66 = -x63
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = -x7
    out[..., 7] = -x14
    out[..., 8] = -x15
    out[..., 9] = x16
    out[..., 10] = x7
    out[..., 11] = x14
    out[..., 12] = x15
    out[..., 13] = -x16
    out[..., 14] = -x21
    out[..., 15] = x27
    out[..., 16] = x20
    out[..., 17] = x26
    out[..., 18] = x21
    out[..., 19] = -x27
    out[..., 20] = -x20
    out[..., 21] = -x26
    out[..., 22] = -x31
    out[..., 23] = -x33
    out[..., 24] = x38
    out[..., 25] = -x41
    out[..., 26] = x42
    out[..., 27] = -x43
    out[..., 28] = x37
    out[..., 29] = x40
    out[..., 30] = x31
    out[..., 31] = x33
    out[..., 32] = -x38
    out[..., 33] = x41
    out[..., 34] = -x42
    out[..., 35] = x43
    out[..., 36] = -x37
    out[..., 37] = -x40
    out[..., 38] = -x19 * x25 * x44 * x46
    out[..., 39] = -x13 * x44 * x48 * x6
    out[..., 40] = x54
    out[..., 41] = x61
    out[..., 42] = x62
    out[..., 43] = x63
    out[..., 44] = x53
    out[..., 45] = x64
    out[..., 46] = x65
    out[..., 47] = x66
    out[..., 48] = x65
    out[..., 49] = x66
    out[..., 50] = x54
    out[..., 51] = x61
    out[..., 52] = x62
    out[..., 53] = x63
    out[..., 54] = x53
    out[..., 55] = x64
    out[..., 56] = x53
    out[..., 57] = x64
    out[..., 58] = x65
    out[..., 59] = x66
    out[..., 60] = x54
    out[..., 61] = x61
    out[..., 62] = x62
    out[..., 63] = x63
    out[..., 64] = x62
    out[..., 65] = x63
    out[..., 66] = x53
    out[..., 67] = x64
    out[..., 68] = x65
    out[..., 69] = x66
    out[..., 70] = x54
    out[..., 71] = x61
    out[..., 72] = omega_x
    out[..., 73] = omega_y
    out[..., 74] = omega_phi
    out[..., 75] = omega_phi
    out[..., 76] = omega_phi
    out[..., 77] = omega_phi
    out[..., 78] = Omega


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Modes that turn without growing give exactly 0.0.

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
        PARAMETERS, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("Omega", "r_m", "r_b", "omega_x", "omega_y", "omega_phi") if gradient else (),
    )


def boundaries(
    *, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable interval of a detuning.

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
        PARAMETERS, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return boundaries_at(
        evaluate_pair,
        no_edges,
        arguments,
        ("Omega", "r_m", "r_b", "omega_x", "omega_y", "omega_phi") if gradient else (),
    )


def critical_speeds(
    *, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike, r_a: ArrayLike,
    omega_b: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable zone in the detuned frequency: there is none.

    Without a resonance relation no frequency is detuned: NaN everywhere.

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
    *, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

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
        PARAMETERS, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (6, 6))


def characteristic_coefficients(
    *, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, omega_x: ArrayLike, omega_y: ArrayLike,
    omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

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
        PARAMETERS, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (7,))


def slow_flow(
    amplitudes: ArrayLike, /, *, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
    omega_x: ArrayLike, omega_y: ArrayLike, omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES.
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 6), *arguments], (6,))


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
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
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
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
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
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
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=("Omega", "r_m", "r_b", "omega_x", "omega_y", "omega_phi") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, Omega: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
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
    Omega : array_like
        Rotor speed, rad/s, > 0.
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
        PARAMETERS, Omega=Omega, r_m=r_m, r_b=r_b, omega_x=omega_x, omega_y=omega_y,
        omega_phi=omega_phi,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 6, False))
