# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 d52448678a6534e516d0c2f8643ae0fcddc3d6dd09214c77372769db615d37dc
# Operations for each point: growth_rate 149, boundaries 1014, detuning 9, slow_flow_matrix 69,
# characteristic_coefficients 161, slow_flow 162, motion 53
"""ground_resonance: Omega = omega_x + omega_phi + sigma_1 and omega_y = omega_x + sigma_2, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

Stability depends: the sign of the discriminant of Gamma**3 + I*Gamma**2*(-sigma_1 - sigma_2) +
Gamma*(-omega_phi*sigma_1*sigma_2 - omega_x**3*r_b*r_m/2)/omega_phi +
I*omega_x**3*r_b*r_m*sigma_2/(4*omega_phi), of degree 6, decides.

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
ORDER = 2

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
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (2, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
    ),
    1,
)


def _growth_rate(sigma_1, sigma_2, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = 1 / omega_phi
    x1 = r_b * r_m
    x2 = omega_x * omega_x
    x3 = omega_x * x2
    x4 = x0 * x1 * x3
    x5 = omega_phi * omega_phi
    x6 = 1 / x5
    x7 = 1 / (omega_phi + omega_x)
    x8 = 1 / 8 * x7
    x9 = r_b * r_b
    x10 = r_m * r_m
    x11 = x10 * x9
    x12 = 4 * omega_phi + omega_x
    x13 = omega_phi * x5
    x14 = x7 / x13
    x15 = x12 * x14
    x16 = 1 / 16 * x6
    x17 = sigma_1 * sigma_2
    x18 = x17 * (3 * omega_phi + omega_x)
    x19 = x11 * x3
    x20 = omega_phi * omega_x
    x21 = x2 + x20 - x5
    x22 = 3 * x2
    x23 = x2 * x2
    x24 = x11 * x14 * x23
    x25 = sigma_1 * sigma_1
    x26 = omega_x * x23
    x27 = sigma_2 * sigma_2
    x28 = x2 * x23
    x29 = r_b * x9
    x30 = r_m * x10
    x31 = x1 * x2
    x32 = omega_x * x1
    x33 = x31 * x6
    # Outputs
    coefficient_1 = (
        1 / 8 * r_b * r_m * sigma_1 * sigma_2 * x2 * x21 * x6 * x7
        + 3 / 16 * r_b * r_m * sigma_2 * x2 * x25 * x6 + 1 / 16 * sigma_1 * x10 * x26 * x6 * x7 * x9
        + 3 / 32 * x10 * x23 * x25 * x6 * x7 * x9
        - 1 / 32 * sigma_2 * x24 * (15 * x20 + x22 + 11 * x5) - 1 / 4 * sigma_2 * x4
        - x0 * x11 * x26 * x8 - 1 / 128 * x15 * x19 * x27 * (2 * omega_phi + 3 * omega_x)
        - 3 / 64 * x15 * x28 * x29 * x30 - x16 * x18 * x19 * x7
    )
    coefficient_2 = (
        x17 + 1 / 4 * x18 * x32 * x6 + 1 / 16 * x24 * (14 * x20 + x22 + 5 * x5) + 1 / 2 * x4
        - 1 / 4 * sigma_1 * x21 * x33 * x7 - sigma_2 * x33 * x8 * (x2 + 9 * x20 + 7 * x5)
        - x12 * x16 * x27 * x32 - 3 / 8 * x25 * x31 * x6
    )
    coefficient_3 = 1 / 4 * r_b * r_m * x2 * x6 * x7 * (x2 + 8 * x20 + 6 * x5) - sigma_1 - sigma_2
    return conservative_growth(coefficient_1, coefficient_2, coefficient_3)


def _boundaries(sigma_2, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = 1 / omega_phi
    x1 = omega_phi * omega_phi
    x2 = omega_phi * x1
    x3 = 1 / x2
    x4 = r_b * r_b
    x5 = r_m * r_m
    x6 = x4 * x5
    x7 = omega_x * omega_x
    x8 = x7 * x7
    x9 = x7 * x8
    x10 = x6 * x9
    x11 = 1 / x1
    x12 = sigma_2 * sigma_2
    x13 = x11 * x12
    x14 = 4 * omega_phi
    x15 = omega_x + x14
    x16 = x1 * x1
    x17 = x1 * x16
    x18 = 1 / x17
    x19 = r_b * x4
    x20 = r_m * x5
    x21 = x19 * x20
    x22 = x18 * x21
    x23 = omega_x * x7
    x24 = x22 * x23
    x25 = 1 / x16
    x26 = x25 * x6
    x27 = x26 * x7
    x28 = 1 / 256 * x27
    x29 = omega_phi + omega_x
    x30 = 1 / x29
    x31 = omega_phi * omega_x
    x32 = 3 * omega_x
    x33 = omega_phi * x32
    x34 = -x7
    x35 = omega_x * x8
    x36 = x3 * x35 * x6
    x37 = x30 * x36
    x38 = 3 * x1
    x39 = x33 + x38 + x7
    x40 = x12 * x12
    x41 = sigma_2 * x40
    x42 = x15 * x41
    x43 = x29 * x29
    x44 = 1 / x43
    x45 = x14 + x32
    x46 = x45 * x45
    x47 = 1 / 4096 * x46
    x48 = 12 * x1
    x49 = x15 * x15
    x50 = x41 * x49
    x51 = x22 * x30
    x52 = 1 / 1024 * x51 * x8
    x53 = 1 / 64 * x44
    x54 = -x8
    x55 = omega_phi * x23
    x56 = omega_x * x2
    x57 = x1 * x7
    x58 = x4 * x4
    x59 = x5 * x5
    x60 = x58 * x59
    x61 = x60 * (-159 * x16 - x54 - 20 * x55 - 276 * x56 - 146 * x57)
    x62 = 28 * x55
    x63 = 181 * x57 + x62
    x64 = x26 * x8
    x65 = omega_phi * x16
    x66 = 1 / x65
    x67 = 27 * x55
    x68 = 1 / 256 * x44
    x69 = sigma_2 * x12
    x70 = x68 * x69
    x71 = 5 * x8
    x72 = -2 * x8
    x73 = x22 * x35
    x74 = x15 * x40
    x75 = 4 * x8
    x76 = x16 * x16
    x77 = 1 / x76
    x78 = x44 * x60 * x9
    x79 = x77 * x78
    x80 = -x9
    x81 = omega_phi * x35
    x82 = omega_x * x65
    x83 = x1 * x8
    x84 = x2 * x23
    x85 = x16 * x7
    x86 = x8 * x8
    x87 = omega_x * x86
    x88 = x16 * x2
    x89 = x87 / x88
    x90 = x29 * x43
    x91 = 1 / x90
    x92 = x60 * x91
    x93 = x12 * x77
    x94 = r_b * x58
    x95 = r_m * x59
    x96 = x94 * x95
    x97 = x43 * x43
    x98 = 1 / x97
    x99 = x87 * x98
    x100 = 1 / 256 * x98
    x101 = 2 * omega_phi
    x102 = -x101 * x23 - 39 * x16 - x54 - 66 * x56 - 32 * x57
    x103 = 5 * omega_x
    x104 = omega_phi * x103
    x105 = 5 * x1 + x104 + x7
    x106 = x105 * x45 * x96
    x107 = x102 * x106
    x108 = 2 * x9
    x109 = x23 * x8
    x110 = x109 * x77
    x111 = x110 * x92
    x112 = omega_x * x88
    x113 = 72 * x1
    x114 = x2 * x35
    x115 = x16 * x8
    x116 = x23 * x65
    x117 = x17 * x7
    x118 = x77 * x86
    x119 = x118 * x60
    x120 = 1 / 1024 * x12
    x121 = omega_x * x16
    x122 = x2 * x7
    x123 = omega_phi * x76
    x124 = 1 / x123
    x125 = x7 * x86
    x126 = x106 * x124 * x125 * x98
    x127 = x12 * x40
    x128 = x15 * x49
    x129 = x23 * x86
    x130 = x105 * x105
    x131 = x1 * x76
    x132 = x8 * x86
    x133 = x4 * x58
    x134 = x5 * x59
    x135 = x23 * x69
    x136 = r_b * r_m
    x137 = 1 / 4 * x11
    x138 = x10 * x137
    x139 = x11 * x136
    x140 = omega_x * x139
    x141 = 3 * omega_phi
    x142 = omega_x + x141
    x143 = 9 * omega_x
    x144 = 1 / 128 * x27
    x145 = x30 * (omega_x - omega_phi) * (x103 + x141)
    x146 = 9 * x1
    x147 = x30 * x7
    x148 = omega_phi * x7
    x149 = omega_x * x1
    x150 = x23 * x40
    x151 = x26 * x30
    x152 = -4 * x8
    x153 = x44 * x64
    x154 = 1 / 32 * x153
    x155 = omega_phi * x8
    x156 = x1 * x23
    x157 = 13 * omega_phi
    x158 = 201 * x17
    x159 = x92 * (x158 + 515 * x82 + 361 * x85 + x9 - x157 * x35 - 79 * x83 - 14 * x84)
    x160 = x22 * x9
    x161 = x160 * x91
    x162 = sigma_2 * x142
    x163 = omega_phi * x9
    x164 = omega_x * x17
    x165 = x1 * x35
    x166 = x2 * x8
    x167 = x16 * x23
    x168 = x65 * x7
    x169 = x100 * x119
    x170 = 7 * x1
    x171 = 60 * x31
    x172 = x22 * (x113 + x171 + 11 * x7)
    x173 = -x152 - 32 * x16 - 75 * x56 - 73 * x57 - x67
    x174 = 12 * omega_phi
    x175 = 1 / 2 * omega_x
    x176 = x30 * (x1 + x31 + x7)
    x177 = x13 * x136
    x178 = x12 * x8
    x179 = x44 * x61
    # Outputs
    p0 = (
        r_b * r_m * x0 * x23 * x40
        + 1 / 16 * sigma_2 * x19 * x20 * x25 * x30 * x86 * (33 * x1 + 34 * x31 + 5 * x7) + 1 / 64
        * x109 * x12 * x19 * x20 * x44 * x66 * (103 * x16 + 156 * x56 + 87 * x57 + x62 + x71)
        + 1 / 2 * x19 * x20 * x3 * x87 - 1 / 1024 * sigma_2 * x126 * (7 * omega_phi * x8 + x35 - 167
        * x121 - 87 * x122 - x23 * x38 - 93 * x65) - 1 / 128 * sigma_2 * x89 * x92 * (-753 * x17
        - x80 - 7 * x81 - 2095 * x82 - 193 * x83 - 1010 * x84 - 2171 * x85) - 13 / 16 * x10 * x13
        - x100 * x107 * x129 * x77 - 1 / 2048 * x111 * x15 * x69 * (x108 + 138 * x17 + 47 * x81
        + 545 * x82 + 278 * x83 + 699 * x84 + 874 * x85) - x119 * x120 * x98 * (x86 - 5808 * x112
        - x113 * x9 - 640 * x114 - 2901 * x115 - 6992 * x116 - 8980 * x117 - 1487 * x76)
        - x125 * x18 * x53 * x61 - 1 / 1024 * x127 * x128 * x24 - x127 * x28 * x49
        - x130 * x132 * x133 * x134 * x44 * x47 / x131
        - x15 * x47 * x93 * x96 * x99 * (57 * x16 + 35 * x55 + 123 * x56 + 98 * x57 + x71)
        - x21 * x66 * x70 * x9 * (x67 + 10 * x8 - 300 * x16 - 430 * x56 - 129 * x57)
        - 1 / 64 * x23 * x26 * x30 * x39 * x42 - 1 / 16 * x37 * x69 * (-13 * x1 - x33 - x34)
        - 1 / 16384 * x40 * x49 * x79 * (228 * x16 + 372 * x56 + x63 + x75)
        - x40 * x53 * x64 * (-127 * x16 - x54 - 280 * x56 - x63) - 1 / 512 * x44 * x73 * x74 * (-29
        * omega_phi * x23 - 122 * x16 - 279 * x56 - 183 * x57 - x72)
        - x50 * x52 * (11 * x31 + x48 + 4 * x7)
    )
    p1 = (
        sigma_2 * x138 + sigma_2 * x169 * (15486 * x112 + 932 * x114 + 6309 * x115 + 17198 * x116
        + 23230 * x117 + 4075 * x76 + x86 - x1 * x108 - x109 * x14) + x111 * x120 * (2 * x109 + 133
        * x163 + 28274 * x164 + 1490 * x165 + 7713 * x166 + 22090 * x167 + 34957 * x168 + 9084
        * x88) + 1 / 8 * x12 * x37 * (2 * x7 - 45 * x1 - 35 * x31)
        + 1 / 512 * x126 * (229 * x121 + 105 * x122 + x146 * x23 + x155 + x35 + 141 * x65)
        + 1 / 8 * x140 * x42
        + 1 / 1024 * x142 * x15 * x69 * x79 * (6 * x16 - x157 * x23 - 21 * x56 - 40 * x57 - x72)
        + 3 / 256 * x142 * x24 * x50 + x144 * x42 * (32 * omega_phi + x143)
        + x154 * x69 * (-180 * x16 - 65 * x55 - 459 * x56 - 344 * x57 - x72) + 1 / 64 * x159 * x89
        + x52 * x74 * (283 * x148 + 994 * x149 + 888 * x2 + 22 * x23)
        + x70 * x73 * (9 * x35 - 1763 * x121 - 1916 * x122 - 47 * x155 - 695 * x156 - 448 * x65) - 1
        / 16 * sigma_2 * x109 * x21 * x44 * x66 * (9 * omega_phi * x23 - x152 - 86 * x16 - 171 * x56
        - 79 * x57) - 5 / 2 * x0 * x135 * x136 - 1 / 512 * x107 * x124 * x162 * x99 - 1 / 128 * x12
        * x161 * (2 * x9 - 288 * x17 - 28 * x81 - 656 * x82 - 195 * x83 - 446 * x84 - 651 * x85)
        - x136 * x137 * x147 * x40 * (-x146 - 7 * x31 - x34) - 1 / 8 * x145 * x21 * x25 * x86
        - 1 / 64 * x150 * x151 * (x23 - 66 * x148 - 355 * x149 - 336 * x2)
    )
    p2 = (
        5 / 2 * r_b * r_m * x0 * x12 * x23
        + 3 / 4 * r_b * r_m * x11 * x30 * x69 * x7 * (-x104 - x170 - x34) + 1 / 512 * sigma_2 * x109
        * x58 * x59 * x77 * x91 * (7 * x109 + 4725 * x164 + 107 * x168 + 2412 * x88 - 61 * x163
        - 1051 * x165 - 4034 * x166 - 5237 * x167) + 1 / 64 * sigma_2 * x18 * x19 * x20 * x9 * x91
        * (3 * x9 - x158 - 67 * x81 - 741 * x82 - 592 * x83 - 1349 * x84 - 1370 * x85)
        + 3 / 1024 * x102 * x105 * x124 * x125 * x45 * x94 * x95 * x98
        + 1 / 16 * x109 * x173 * x19 * x20 * x44 * x66 + 1 / 1024 * x18 * x19 * x20 * x30 * x69 * x8
        * (22 * x8 - 9216 * x16 - 653 * x55 - 13896 * x56 - 5822 * x57) + 1 / 64 * x23 * x25 * x30
        * x4 * x5 * x69 * (29 * x23 - 152 * x148 - 1059 * x149 - 948 * x2)
        - 3 / 8 * sigma_2 * x37 * x39
        - x12 * x154 * (182 * x16 + 175 * x56 + x75 - 85 * x55 - 92 * x57) - x12 * x68 * x73 * (1849
        * x121 + 673 * x122 + 137 * x155 + 44 * x156 + 43 * x35 + 1100 * x65) - x138
        - 7 / 4 * x140 * x40 * (omega_x + x101) - 3 / 512 * x15 * x150 * x172 - x169 * (118 * x1
        * x9 + 4380 * x112 + 1638 * x114 + 5823 * x115 + 9774 * x116 + 8878 * x117 + 961 * x76 + x86
        - x109 * x174) - x28 * x40 * (1120 * x1 + 928 * x31 + 163 * x7) - x40 - 1 / 2048 * x78 * x93
        * (14 * x9 - 11448 * x17 - 127 * x81 - 27432 * x82 - 2332 * x83 - 11199 * x84 - 25266 * x85)
    )
    p3 = (
        1 / 8 * sigma_2 * x153 * (-x143 * x2 - 2 * x16 - x170 * x7 - x54) + sigma_2 * x53 * x73
        * (20 * x35 - 772 * x121 - 1101 * x122 - x141 * x8 - 545 * x156 - 192 * x65)
        + 3 / 256 * x110 * x162 * x179 + 1 / 64 * x135 * x142 * x22 * (36 * x1 + x171 + 13 * x7)
        + x139 * x175 * x69 * (8 * omega_x + x157) + x144 * x69 * (768 * x1 + 1036 * x31 + 249 * x7)
        + 1 / 4 * x176 * x36 + 2 * x69 - 3 / 256 * x118 * x159
        - 1 / 32 * x12 * x151 * x23 * (19 * x23 - 127 * x148 - 398 * x149 - 228 * x2)
        - 1 / 2 * x147 * x177 * (-10 * x31 - x34 - x48)
        - 1 / 32 * x161 * (-27 * x17 - x80 - 37 * x81 - 57 * x82 - 86 * x83 - 75 * x84 - 58 * x85)
        - 1 / 512 * x178 * x51 * (571 * omega_phi * x23 + 152 * x8 - 432 * x16 - 1692 * x56 - 408
        * x57)
    )
    p4 = (
        3 / 256 * sigma_2 * x18 * x19 * x20 * x30 * x35 * (206 * x148 + 27 * x149 + 55 * x23
        - 72 * x2) + 1 / 32 * sigma_2 * x23 * x25 * x30 * x4 * x5 * (43 * x148 + 43 * x149 + 12 * x2
        + 13 * x23) - 1 / 8 * omega_x * x177 * (19 * omega_x + x174) - 9 / 1024 * x118 * x179
        - x12 * x28 * (144 * x1 + 936 * x31 + 409 * x7) - x12
        - 1 / 16 * x153 * (x16 - x14 * x23 - x146 * x7 - x54 - 4 * x56) - 3 / 64 * x160 * x173 * x44
        - 9 / 256 * x172 * x178
    )
    p5 = (
        27 / 64 * sigma_2 * x142 * x18 * x19 * x20 * x35
        + 3 / 64 * sigma_2 * x23 * x25 * x4 * x5 * (7 * omega_x + x174) - 9 / 128 * x145 * x160
        - 3 / 16 * x176 * x64
    )
    p6 = -27 / 128 * x160 - 9 / 64 * x64
    reach = 1 / 2 * omega_phi + x175
    return zone((p0, p1, p2, p3, p4, p5, p6), reach=reach)


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
    x0 = 3 * omega_x
    x1 = 1 / omega_phi
    x2 = omega_x * omega_x
    x3 = r_b * x2
    x4 = x1 * x3
    x5 = r_m / (omega_phi + omega_x)
    x6 = 1 / 8 * x4 * x5
    x7 = -x6 * (2 * omega_phi + x0)
    x8 = 4 * omega_phi
    x9 = x6 * (x0 + x8)
    x10 = 1 / 4 * omega_x * r_m + 3 / 8 * r_m * sigma_1
    x11 = -x10
    x12 = x10 - 1 / 8 * r_m * sigma_2
    x13 = -x12
    x14 = omega_phi * omega_phi
    x15 = 1 / x14
    x16 = 1 / 4 * x4 - 1 / 8 * sigma_1 * x15 * x3
    x17 = r_b * x15
    x18 = 1 / 8 * omega_x * sigma_2 * x17 * (omega_x + x8) + x16
    x19 = 2 * omega_x
    x20 = omega_x * x2
    x21 = omega_phi * x14
    x22 = x14 * x14
    x23 = x2 * x2
    x24 = 13 / 16 * omega_phi * x20 + 7 / 4 * x14 * x2 + x19 * x21 + x22 + 1 / 8 * x23
    x25 = x17 * x5
    x26 = sigma_1 - x24 * x25
    x27 = 5 / 4 * omega_phi * x2 + x14 * x19 + 3 / 16 * x20 + x21
    x28 = r_b * x1 * x5
    x29 = -x27 * x28
    x30 = x24 * x25
    x31 = x27 * x28
    x32 = -x16
    x33 = -x18
    # Outputs
    out[..., 0, 0].imag = x7
    out[..., 0, 1].real = x9
    out[..., 0, 2].real = x10
    out[..., 0, 3].imag = x10
    out[..., 0, 4].real = x11
    out[..., 0, 5].imag = x11
    out[..., 1, 0].real = -x9
    out[..., 1, 1].imag = sigma_2 + x7
    out[..., 1, 2].imag = x13
    out[..., 1, 3].real = x12
    out[..., 1, 4].imag = x12
    out[..., 1, 5].real = x13
    out[..., 2, 0].real = x16
    out[..., 2, 1].imag = x18
    out[..., 2, 2].imag = x26
    out[..., 2, 3].real = x29
    out[..., 2, 4].imag = x30
    out[..., 2, 5].real = x31
    out[..., 3, 0].imag = x32
    out[..., 3, 1].real = x18
    out[..., 3, 2].real = x31
    out[..., 3, 3].imag = x26
    out[..., 3, 4].real = x29
    out[..., 3, 5].imag = x30
    out[..., 4, 0].real = x32
    out[..., 4, 1].imag = x33
    out[..., 4, 2].imag = x30
    out[..., 4, 3].real = x31
    out[..., 4, 4].imag = x26
    out[..., 4, 5].real = x29
    out[..., 5, 0].imag = x16
    out[..., 5, 1].real = x33
    out[..., 5, 2].real = x29
    out[..., 5, 3].imag = x30
    out[..., 5, 4].real = x31
    out[..., 5, 5].imag = x26


def _characteristic_coefficients(out, sigma_1, sigma_2, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = omega_phi * omega_phi
    x1 = 1 / x0
    x2 = 1 / (omega_phi + omega_x)
    x3 = omega_phi * omega_x
    x4 = omega_x * omega_x
    x5 = sigma_1 * sigma_2
    x6 = 1 / omega_phi
    x7 = r_b * r_m
    x8 = omega_x * x4
    x9 = x6 * x7 * x8
    x10 = x1 * x7
    x11 = x5 * (3 * omega_phi + omega_x)
    x12 = 4 * omega_phi + omega_x
    x13 = x3 + x4 - x0
    x14 = 3 * x4
    x15 = 1 / 16 * x2
    x16 = omega_phi * x0
    x17 = 1 / x16
    x18 = r_b * r_b
    x19 = r_m * r_m
    x20 = x18 * x19
    x21 = x4 * x4
    x22 = x20 * x21
    x23 = x17 * x22
    x24 = sigma_1 * sigma_1
    x25 = sigma_2 * sigma_2
    x26 = x10 * x4
    x27 = 1 / 8 * x2
    x28 = omega_x * x21
    x29 = x20 * x28
    x30 = x1 * x15
    x31 = x17 * x2
    x32 = x20 * x8
    x33 = 2 * omega_phi
    x34 = x21 * x4
    x35 = r_b * x18
    x36 = r_m * x19
    x37 = omega_x + x33
    x38 = x37 * x37
    x39 = x38 * x38
    # Outputs
    c1_2 = 1j * (1 / 4 * r_b * r_m * x1 * x2 * x4 * (6 * x0 + 8 * x3 + x4) - sigma_1 - sigma_2)
    c1_1 = (
        1 / 16 * omega_x * r_b * r_m * x1 * x12 * x25
        + 1 / 4 * r_b * r_m * sigma_1 * x1 * x13 * x2 * x4
        + 1 / 8 * r_b * r_m * sigma_2 * x1 * x2 * x4 * (7 * x0 + 9 * x3 + x4)
        + 3 / 8 * r_b * r_m * x1 * x24 * x4 - 1 / 4 * omega_x * x10 * x11
        - x15 * x23 * (5 * x0 + x14 + 14 * x3) - x5 - 1 / 2 * x9
    )
    c1_0 = (
        1j * (1 / 32 * sigma_2 * x2 * x23 * (11 * x0 + x14 + 15 * x3) + 1 / 4 * sigma_2 * x9
        + x11 * x30 * x32 + 1 / 128 * x12 * x25 * x31 * x32 * (3 * omega_x + x33)
        + 3 / 64 * x12 * x31 * x34 * x35 * x36 + x27 * x29 * x6 - sigma_1 * x29 * x30
        - 3 / 16 * sigma_2 * x24 * x26 - 3 / 32 * x1 * x2 * x22 * x24 - x13 * x26 * x27 * x5)
    )
    c2_0 = -1j * sigma_1
    c3_0 = 1j * (1 / 4 * r_b * r_m * x1 * x2 * x39 - sigma_1)
    multiply_out(out, ((c1_2, c1_1, c1_0), 1), ((c2_0,), 2), ((c3_0,), 1))


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, sigma_1, sigma_2, r_m, r_b, omega_x,
    omega_phi,
):
    # Intermediates
    x0 = np.conj(A_phi_1)
    x1 = 2 * omega_x
    x2 = 3 * sigma_1 + x1
    x3 = np.conj(A_phi_3)
    x4 = 1 / 8 * r_m
    x5 = x2 * x4
    x6 = np.conj(A_phi_2)
    x7 = np.conj(A_phi_4)
    x8 = 1 / omega_phi
    x9 = 1 / (omega_phi + omega_x)
    x10 = 3 * omega_x
    x11 = 4 * omega_phi
    x12 = x10 + x11
    x13 = 2 * omega_phi
    x14 = omega_x * omega_x
    x15 = r_b * x14
    x16 = 1j * x15
    x17 = x4 * x9
    x18 = x16 * x17
    x19 = x2 - sigma_2
    x20 = x19 * x4
    x21 = r_m * x8
    x22 = 1j * sigma_1
    x23 = omega_phi * omega_phi
    x24 = 1 / x23
    x25 = 1 / 8 * x24
    x26 = x25 * (x13 - sigma_1) * np.conj(A_x)
    x27 = x15 * x26
    x28 = (
        omega_x * r_b * x25 * (omega_phi * x1 + omega_x * sigma_2 + sigma_2 * x11
        - omega_x * sigma_1) * np.conj(A_y)
    )
    x29 = 1j * x28
    x30 = 1 / 16 * r_b * x9
    x31 = A_phi_2 * x30
    x32 = 32 * omega_x
    x33 = omega_phi * x23
    x34 = omega_x * x14
    x35 = x21 * (20 * omega_phi * x14 + x23 * x32 + 16 * x33 + 3 * x34)
    x36 = x31 * x35
    x37 = x30 * x35
    x38 = A_phi_4 * x37
    x39 = x14 * x14
    x40 = x23 * x23
    x41 = 1j * r_m * x24 * (13 * omega_phi * x34 + 28 * x14 * x23 + x32 * x33 + 2 * x39 + 16 * x40)
    x42 = x30 * x41
    x43 = A_phi_1 * x42
    x44 = A_phi_3 * x42
    x45 = A_phi_1 * x37 + x16 * x26 + x28 + x31 * x41 - A_phi_3 * x37 - A_phi_4 * x42
    # Outputs
    out[..., 0] = (
        1 / 8 * A_y * r_b * r_m * x12 * x14 * x8 * x9 + 1 / 8 * r_m * x0 * x2
        + 1 / 8 * 1j * r_m * x2 * x6 - A_x * x18 * x8 * (x10 + x13) - x3 * x5 - 1j * x5 * x7
    )
    out[..., 1] = (
        A_y * (1j * sigma_2 + x18 - 3 / 8 * x16 * x21) + 1 / 8 * 1j * r_m * x19 * x3
        + 1 / 8 * r_m * x19 * x6 - A_x * x12 * x15 * x17 * x8 - 1j * x0 * x20 - x20 * x7
    )
    out[..., 2] = x27 + x38 + x43 - A_phi_1 * x22 - x29 - x36 - x44
    out[..., 3] = x45 - A_phi_2 * x22
    out[..., 4] = x29 + x36 + x44 - A_phi_3 * x22 - x27 - x38 - x43
    out[..., 5] = -A_phi_4 * x22 - x45


def _motion(out, sigma_1, sigma_2, r_m, r_b, omega_x, omega_phi):
    # Intermediates
    x0 = omega_phi + omega_x
    x1 = 1 / 4 / x0
    x2 = 2 * omega_phi
    x3 = omega_x + x2
    x4 = x3 * x3
    x5 = r_m * x1 * x4 / omega_phi
    x6 = -x5
    x7 = 1j * x5
    x8 = -x7
    x9 = omega_x * r_b * x1
    x10 = -x9
    x11 = 1j * x9
    x12 = -x11
    x13 = x0 * x0
    x14 = 1 / 8 / x13
    x15 = omega_phi * omega_phi
    x16 = r_m * x14 * x3 / x15
    x17 = omega_x * omega_x
    x18 = sigma_1 * x16 * x17
    x19 = 1j * x18
    x20 = omega_x * sigma_2
    x21 = omega_x * x16 * (omega_x * sigma_1 - sigma_2 * x2 - x20)
    x22 = 1j * x21
    x23 = r_b * x14
    x24 = x23 * (omega_phi * sigma_1 + 2 * omega_x * sigma_1 - 3 * omega_phi * sigma_2 - 2 * x20)
    x25 = sigma_1 * x23 * (omega_phi + 2 * omega_x)
    x26 = 1j * x25
    x27 = 1j * x24
    x28 = omega_phi + sigma_1
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = x6
    out[..., 7] = x7
    out[..., 8] = x5
    out[..., 9] = x8
    out[..., 10] = x7
    out[..., 11] = x5
    out[..., 12] = x8
    out[..., 13] = x6
    out[..., 14] = x10
    out[..., 15] = x12
    out[..., 16] = x12
    out[..., 17] = x9
    out[..., 18] = x9
    out[..., 19] = x11
    out[..., 20] = x11
    out[..., 21] = x10
    out[..., 22] = x18
    out[..., 23] = -x19
    out[..., 24] = -x18
    out[..., 25] = x19
    out[..., 26] = -x22
    out[..., 27] = -x21
    out[..., 28] = x22
    out[..., 29] = x21
    out[..., 30] = x24
    out[..., 31] = x26
    out[..., 32] = x27
    out[..., 33] = -x25
    out[..., 34] = -x24
    out[..., 35] = -x26
    out[..., 36] = -x27
    out[..., 37] = x25
    out[..., 38] = omega_x
    out[..., 39] = omega_x
    out[..., 40] = x28
    out[..., 41] = x28
    out[..., 42] = x28
    out[..., 43] = x28
    out[..., 44] = sigma_1 + x0


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
    Order 2 leaves out terms of the edges from ε^3 on; by as much differs the formula of
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
    are taken with these fixed. Over times of order 1/ε the error is O(ε^2). A UserWarning says how
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
