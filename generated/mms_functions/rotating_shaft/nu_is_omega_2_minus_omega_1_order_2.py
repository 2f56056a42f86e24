# Emitted by mmsgen 0.1.0 from derivations/rotating_shaft.py: change that, not this file.
# Made from sha256 13fa2d9ac97e04c7f6ad9bd355c8d17ab3bab94a29715da2dc296c55c297c3dd
# Operations for each point: growth_rate 126, slow_flow_matrix 62, characteristic_coefficients 154,
# slow_flow 76, motion 608, leading 9
"""rotating_shaft: nu = omega_2 - omega_1 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of eta_1, eta_2. Results are written at ε = 1.

It cannot be unstable: the discriminant of Gamma**2 + I*Gamma*sigma +
Phi_alpha_1**2*Phi_alpha_2**2*kappa**2/(16*omega_1*omega_2) is negative at every detuning, the modes
only exchange energy.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: 3*omega_1 - omega_2, omega_1 - 3*omega_2, omega_1 - omega_2.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; gyroscopic modes after
Meirovitch, AIAA Journal 12 (1974)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._eigenmodes import modal_values
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
    "modes",
    "response",
    "slow_flow",
    "slow_flow_matrix",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ("nu = omega_2 - omega_1 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("eta_1", "eta_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, nu = -omega_1 + omega_2 + sigma"),
    "kappa": ("positive", "N m/rad", "amplitude of its modulation in one direction"),
    "omega_1": ("positive", "rad/s", "natural frequency 1, of alpha, beta"),
    "omega_2": ("positive", "rad/s", "natural frequency 2, of alpha, beta"),
    "Phi_alpha_1": ("real", "1", "component alpha of mode 1"),
    "Phi_alpha_2": ("real", "1", "component alpha of mode 2"),
    "Theta_beta_1": ("real", "1", "component beta of mode 1, in quadrature"),
    "Theta_beta_2": ("real", "1", "component beta of mode 2, in quadrature"),
    "I_t": ("positive", "kg m^2", "inertia about a diameter"),
    "I_p": ("positive", "kg m^2", "inertia about the axis of rotation"),
    "Omega_s": ("positive", "rad/s", "speed of rotation"),
    "k": ("positive", "N m/rad", "stiffness against tilting"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "eta_1": {},
    "eta_2": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_eta_1", "A_eta_2")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    2,
    (
        ((0, 0), (1, 0)),
    ),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (0, 0, 0, 1, 0, 0), (0,)), (0, 0, (1, 0, 0, 0, 0, 0), (0,)),
        (0, 1, (0, 0, 0, 1, 0, 0), (0,)), (0, 1, (1, 0, 0, 0, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 1, 0, 0), (-1,)), (1, 0, (0, 0, 0, 1, 0, 0), (1,)),
        (1, 0, (1, 0, 0, 0, 0, 0), (-1,)), (1, 0, (1, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 1, 0, 0), (-1,)), (1, 1, (0, 0, 0, 1, 0, 0), (1,)),
        (1, 1, (1, 0, 0, 0, 0, 0), (-1,)), (1, 1, (1, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 1, 0, 0), (-2,)), (2, 0, (0, 0, 0, 1, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 1, 0, 0), (0,)), (2, 0, (0, 0, 0, 1, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 1, 0, 0), (2,)), (2, 0, (1, 0, 0, 0, 0, 0), (-2,)),
        (2, 0, (1, 0, 0, 0, 0, 0), (-1,)), (2, 0, (1, 0, 0, 0, 0, 0), (0,)),
        (2, 0, (1, 0, 0, 0, 0, 0), (1,)), (2, 0, (1, 0, 0, 0, 0, 0), (2,)),
        (2, 1, (0, 0, 0, 1, 0, 0), (-2,)), (2, 1, (0, 0, 0, 1, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 1, 0, 0), (0,)), (2, 1, (0, 0, 0, 1, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 1, 0, 0), (2,)), (2, 1, (1, 0, 0, 0, 0, 0), (-2,)),
        (2, 1, (1, 0, 0, 0, 0, 0), (-1,)), (2, 1, (1, 0, 0, 0, 0, 0), (0,)),
        (2, 1, (1, 0, 0, 0, 0, 0), (1,)), (2, 1, (1, 0, 0, 0, 0, 0), (2,)),
    ),
    1,
)


def _growth_rate(sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = 1 / omega_2
    x1 = Phi_alpha_1 * Phi_alpha_1
    x2 = Phi_alpha_2 * Phi_alpha_2
    x3 = x1 * x2
    x4 = omega_1 * omega_1
    x5 = 1 / x4
    x6 = omega_1 - 3 * omega_2
    x7 = -omega_2
    x8 = 3 * omega_1 + x7
    x9 = 1 / 8 * x5
    x10 = omega_1 + x7
    x11 = 2 * Phi_alpha_2
    x12 = omega_1 + omega_2
    x13 = sigma * sigma
    x14 = kappa * kappa
    x15 = omega_2 * omega_2
    x16 = x2 * x2
    x17 = x1 * x1
    x18 = x4 * x4
    x19 = x15 * x15
    x20 = x6 * x6
    x21 = x8 * x8
    x22 = x10 * x10
    x23 = x12 * x12
    x24 = x14 * x14
    x25 = omega_1 * x19
    x26 = omega_2 * x18
    x27 = 3 * x3
    x28 = omega_2 * x15
    x29 = x28 * x4
    x30 = omega_1 * x4
    x31 = x15 * x30
    x32 = 10 * x3
    x33 = omega_1 * x18
    x34 = omega_2 * x19
    x35 = (
        12 * x16 * x26 + 4 * x16 * x29 + 12 * x17 * x25 + 4 * x17 * x31 + x25 * x32 + x26 * x32
        - 16 * x16 * x31 - 16 * x17 * x29 - x27 * x29 - x27 * x31 - x27 * x33 - x27 * x34
    )
    x36 = x35 * x35
    # Outputs
    discriminant_1 = (
        sigma * x14 * (9 / 8 * x16 * x5 / x6 + x17 * x9 / x8
        + x9 * (Phi_alpha_1 - Phi_alpha_2) * (Phi_alpha_1 + Phi_alpha_2) * (x1 + x2) / x12
        - x0 * x2 * x9 * (Phi_alpha_1 - x11) * (Phi_alpha_1 + x11) - x3 * x9 / x10)
        + 1 / 16 * x1 * x13 * x14 * x2 * x5 / x15 - x13
        - 1 / 256 * x24 * x36 / (x18 * x19 * x20 * x21 * x22 * x23)
        - 1 / 4 * x0 * x14 * x3 / omega_1
    )
    return growing(discriminant_1)


def _slow_flow_matrix(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = 1 / 16 / (omega_1 + omega_2)
    x1 = omega_1 * omega_1
    x2 = 1 / x1
    x3 = Phi_alpha_1 * Phi_alpha_1
    x4 = x3 * x3
    x5 = x2 * x4
    x6 = 1 / omega_2
    x7 = Phi_alpha_2 * Phi_alpha_2
    x8 = 1 / 32 * x3 * x7
    x9 = -omega_2
    x10 = 1 / (omega_1 + x9)
    x11 = kappa * kappa
    x12 = 1 / omega_1
    x13 = Phi_alpha_1 * Phi_alpha_2 * kappa
    x14 = 1 / 4 * x13
    x15 = 1 / 8 * sigma * x13
    x16 = omega_2 * omega_2
    x17 = 1 / x16
    x18 = x17 * x8
    x19 = x7 * x7
    # Outputs
    out[..., 0, 0].imag = (
        x11 * (1 / 32 * x10 * x2 * x3 * x7 - x0 * x5 - x2 * x6 * x8
        - 1 / 16 * x5 / (3 * omega_1 + x9))
    )
    out[..., 0, 1].imag = x12 * x14 + x15 * x2
    out[..., 1, 0].imag = x14 * x6 - x15 * x17
    out[..., 1, 1].imag = (
        x11 * (1 / 16 * x17 * x19 / (omega_1 - 3 * omega_2) - x0 * x17 * x19 - x10 * x18
        - x12 * x18) - sigma
    )


def _characteristic_coefficients(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = omega_1 * x0
    x2 = omega_2 * x1
    x3 = omega_2 * omega_2
    x4 = omega_2 * x3
    x5 = Phi_alpha_2 * Phi_alpha_2
    x6 = x4 * x5
    x7 = omega_1 * x6
    x8 = Phi_alpha_1 * Phi_alpha_1
    x9 = 1 / 4 * x8
    x10 = x2 * x5
    x11 = x0 * x3 * x5
    x12 = -omega_2
    x13 = 1 / (3 * omega_1 + x12)
    x14 = x13 / (omega_1 - 3 * omega_2)
    x15 = omega_1 + omega_2
    x16 = 1 / (x0 * x3)
    x17 = x16 / x15
    x18 = kappa * kappa
    x19 = x8 * x8
    x20 = x5 * x5
    x21 = x0 * x0
    x22 = x3 * x3
    x23 = x18 * x8
    x24 = omega_1 + x12
    x25 = x4 * x8
    x26 = 8 * omega_1
    x27 = x3 * x8
    x28 = omega_2 * x0
    x29 = x3 * x5
    x30 = x28 * x5
    x31 = sigma * sigma
    x32 = x15 * x15
    x33 = x24 * x24
    x34 = x18 * x18
    # Outputs
    c1_1 = (
        1j * (sigma + x14 * x17 * x18 * (1 / 4 * x0 * x19 * x3 + 1 / 4 * x0 * x20 * x3 + 3 / 16
        * x21 * x5 * x8 + 3 / 16 * x22 * x5 * x8 - 3 / 4 * omega_1 * x19 * x4 - x10 * x9 - 7 / 8
        * x11 * x8 - 3 / 4 * x2 * x20 - x7 * x9))
    )
    c1_0 = (
        1 / 16 * x18 * x5 * x8 / (omega_1 * omega_2) - 1 / 32 * sigma * x13 * x17 * x23 * (8 * x0
        * x3 * x8 + 3 * x21 * x5 + x22 * x5 - x10 - 6 * x11 - x25 * x26 - x7) / x24
        - 1 / 64 * x16 * x23 * x31 * x5 - 1 / 1024 * x14 * x34 * x5 * x8 * (2 * x1 * x8 + 3 * x25
        + x26 * x29 - 4 * omega_1 * x27 - 5 * x28 * x8 - 8 * x30) * (3 * x1 * x5 + 8 * x28 * x8 + 2
        * x6 - 5 * omega_1 * x29 - x26 * x27 - 4 * x30) / (x1 * x32 * x33 * x4)
    )
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_eta_1, A_eta_2, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = 1j * A_eta_2
    x3 = 1 / 8 * Phi_alpha_1 * Phi_alpha_2 * kappa
    x4 = kappa * kappa
    x5 = 1j * x4
    x6 = 1 / 16 * x5
    x7 = x6 / (omega_1 + omega_2)
    x8 = Phi_alpha_1 * Phi_alpha_1
    x9 = x8 * x8
    x10 = x1 * x9
    x11 = Phi_alpha_2 * Phi_alpha_2
    x12 = 1 / 32 * x11 * x5 * x8
    x13 = -omega_2
    x14 = 1 / (omega_1 + x13)
    x15 = omega_2 * omega_2
    x16 = 1 / x15
    x17 = x12 * x16
    x18 = x11 * x11
    # Outputs
    out[..., 0] = (
        A_eta_1 * (1 / 32 * 1j * x1 * x11 * x14 * x4 * x8 - x10 * x6 / (3 * omega_1 + x13)
        - x10 * x7 - x1 * x12 / omega_2) + x1 * x2 * x3 * (2 * omega_1 + sigma)
    )
    out[..., 1] = (
        1j * A_eta_1 * x16 * x3 * (2 * omega_2 - sigma) + A_eta_2 * (1 / 16 * 1j * x16 * x18 * x4
        / (omega_1 - 3 * omega_2) - x14 * x17 - x16 * x18 * x7 - x17 / omega_1) - sigma * x2
    )


def _motion(
    out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2, Theta_beta_1, Theta_beta_2,
):
    # Intermediates
    x0 = 2 * Phi_alpha_2
    x1 = 2 * Phi_alpha_1
    x2 = 2 * 1j
    x3 = omega_1 + omega_2
    x4 = 1 / x3
    x5 = -omega_2
    x6 = omega_1 + x5
    x7 = kappa / x6
    x8 = x4 * x7
    x9 = Phi_alpha_2 * Phi_alpha_2
    x10 = Phi_alpha_2 * x9
    x11 = 1 / 4 * x7
    x12 = 1 / omega_2
    x13 = 3 * omega_2
    x14 = -x13
    x15 = omega_1 + x14
    x16 = 1 / x15
    x17 = x12 * x16
    x18 = Phi_alpha_1 * Phi_alpha_1
    x19 = x13 * x18
    x20 = omega_2 * x9
    x21 = 4 * x20
    x22 = Phi_alpha_2 * (omega_1 * x18 - x19 - x21)
    x23 = 1 / omega_1
    x24 = 3 * omega_1
    x25 = x24 + x5
    x26 = 1 / x25
    x27 = x23 * x26
    x28 = omega_1 * x18
    x29 = x24 * x9 + 4 * x28
    x30 = Phi_alpha_1 * (x29 - x20)
    x31 = Phi_alpha_1 * x18
    x32 = omega_1 * omega_1
    x33 = 1 / x32
    x34 = Phi_alpha_1 * Theta_beta_1
    x35 = omega_2 * omega_2
    x36 = omega_2 * x35
    x37 = x34 * x36
    x38 = Theta_beta_2 * x0
    x39 = omega_1 * x32
    x40 = x38 * x39
    x41 = x32 * x34
    x42 = Phi_alpha_2 * x12
    x43 = 1 / 2 * 1j
    x44 = x43 * x8
    x45 = kappa * x43
    x46 = 1j * x11
    x47 = Phi_alpha_2 * Theta_beta_2
    x48 = Phi_alpha_1 * x23
    x49 = Theta_beta_1 * x1
    x50 = 1 / x35
    x51 = x36 * x49
    x52 = x39 * x47
    x53 = x35 * x47
    x54 = x18 * x9
    x55 = x35 * x35
    x56 = x54 * x55
    x57 = x32 * x32
    x58 = x54 * x57
    x59 = x32 * x35
    x60 = 4 * x59
    x61 = x18 * x32
    x62 = x35 * x9
    x63 = 13 * x61 * x62
    x64 = x6 * x6
    x65 = 1 / x64
    x66 = Phi_alpha_2 * x65
    x67 = x25 * x25
    x68 = 1 / x67
    x69 = 1 / x39
    x70 = kappa * kappa
    x71 = x69 * x70
    x72 = 1 / 32 * x4
    x73 = x68 * x71 * x72
    x74 = x18 * x18
    x75 = x9 * x9
    x76 = 2 * omega_1
    x77 = x3 * x3
    x78 = x65 / x77
    x79 = kappa * sigma
    x80 = x78 * x79
    x81 = x18 * x39
    x82 = 12 * x18
    x83 = x28 * x35
    x84 = 2 * omega_2
    x85 = 8 * omega_1
    x86 = x20 * x32
    x87 = 1 / 8 * x70 * x78
    x88 = -x84
    x89 = omega_1 + x88
    x90 = x18 * x35
    x91 = x15 * x15
    x92 = 1 / x91
    x93 = 1 / 8 * x79
    x94 = x50 * x66 * x92 * x93
    x95 = 8 * omega_2
    x96 = x12 / 96
    x97 = x65 * x70
    x98 = x92 * x97
    x99 = x22 * x98 / x89
    x100 = x23 / 96
    x101 = x5 + x76
    x102 = x30 * x68 * x97 / x101
    x103 = x32 * x9
    x104 = Phi_alpha_1 * x33 * x65 * x68 * x93
    x105 = x36 * x9
    x106 = 12 * x9
    x107 = omega_1 * x36
    x108 = 16 * x75
    x109 = 1 / x36
    x110 = x109 * x72 * x98
    x111 = Theta_beta_2 * x10
    x112 = omega_1 * x57
    x113 = x111 * x112
    x114 = omega_2 * x55
    x115 = x114 * x47
    x116 = x112 * x47
    x117 = x116 * x18
    x118 = Theta_beta_1 * x31
    x119 = x118 * x55
    x120 = omega_2 * x57
    x121 = x34 * x57
    x122 = x121 * x20
    x123 = x47 * x55
    x124 = x123 * x28
    x125 = x47 * x57
    x126 = x32 * x36
    x127 = x118 * x126
    x128 = x35 * x39
    x129 = 8 * x118
    x130 = x111 * x126
    x131 = x111 * x128
    x132 = x105 * x41
    x133 = x34 * x39
    x134 = x133 * x62
    x135 = x36 * x47
    x136 = x135 * x61
    x137 = x53 * x81
    x138 = 1j * x42
    x139 = x114 * x34
    x140 = 1 / 4 * x80
    x141 = 8 * x32
    x142 = x111 * x55
    x143 = x36 * x39
    x144 = 2 * x143
    x145 = 8 * x111
    x146 = x114 * x118
    x147 = x139 * x9
    x148 = omega_1 * x147
    x149 = x125 * x90
    x150 = omega_2 * x117
    x151 = x34 * x55
    x152 = x103 * x151
    x153 = x35 * x57
    x154 = x145 * x153 - x119 * x141
    x155 = 1j * x109
    x156 = 1 / 16 * x78
    x157 = x35 * x55
    x158 = x32 * x57
    x159 = x35 * x41
    x160 = x32 * x53
    x161 = omega_1 * omega_2
    x162 = x161 * x34
    x163 = x161 * x47
    x164 = x34 * x35
    x165 = x32 * x47
    x166 = 1j * x50
    x167 = x112 * x34 * x9
    x168 = omega_2 + sigma
    # Outputs
    out[..., 0] = x0
    out[..., 1] = x1
    out[..., 2] = Theta_beta_2 * x2
    out[..., 3] = Theta_beta_1 * x2
    out[..., 4] = x10 * x8
    out[..., 5] = -x11 * x17 * x22
    out[..., 6] = x11 * x27 * x30
    out[..., 7] = -x31 * x8
    out[..., 8] = x33 * x42 * x44 * (omega_2 * x41 + x40 - x37)
    out[..., 9] = (
        1 / 2 * 1j * Phi_alpha_1 * Phi_alpha_2 * Theta_beta_1 * kappa * x12 * x23
        - Theta_beta_2 * x17 * x45 * x9 - x42 * x46 * (x34 + x38)
    )
    out[..., 10] = Theta_beta_1 * x18 * x27 * x45 + x12 * x45 * x47 * x48 + x46 * x48 * (x47 + x49)
    out[..., 11] = -x44 * x48 * x50 * (omega_1 * x53 + x51 - x52)
    out[..., 12] = (
        -x66 * x73 * (7 * omega_1 * x18 * x36 * x9 + 13 * omega_2 * x18 * x39 * x9
        + 16 * omega_2 * x39 * x74 + 24 * omega_2 * x39 * x75 + 32 * x57 * x74 - x56
        - 36 * x57 * x75 - 30 * x58 - 16 * x59 * x74 - x60 * x75 - x63)
    )
    out[..., 13] = x10 * x76 * x80
    out[..., 14] = (
        Phi_alpha_2 * x17 * x18 * x23 * x87 * (x36 * x82 + x62 * x85 + x81 - x61 * x84 - 7 * x83
        - 8 * x86)
    )
    out[..., 15] = x89 * x94 * (x61 + 16 * x62 + 9 * x90 - 6 * omega_2 * x28)
    out[..., 16] = -x96 * x99 * (x29 - x18 * x95 - 9 * x20)
    out[..., 17] = x100 * x102 * (9 * x28 + x85 * x9 - x19 - x21)
    out[..., 18] = x101 * x104 * (9 * x103 + 16 * x61 + x62 - 6 * omega_1 * x20)
    out[..., 19] = (
        -Phi_alpha_1 * x12 * x27 * x87 * x9 * (x105 + x106 * x39 + x61 * x95 - x62 * x76 - 8 * x83
        - 7 * x86)
    )
    out[..., 20] = -x31 * x80 * x84
    out[..., 21] = (
        Phi_alpha_1 * x110 * (x108 * x59 + 36 * x55 * x74 + 30 * x56 + x58 + x60 * x74 + x63
        - 13 * x105 * x28 - x107 * x108 - 24 * x107 * x74 - 7 * x20 * x81 - 32 * x55 * x75)
    )
    out[..., 22] = (
        -x138 * x65 * x73 * (84 * x111 * x120 + x115 * x18 + 18 * x117 + 40 * x118 * x120
        + x119 * x85 + x128 * x129 + 4 * x130 + 80 * x134 + 15 * x136 - omega_2 * x125 * x82
        - 72 * x113 - 96 * x122 - 7 * x124 - 24 * x127 - 32 * x131 - 16 * x132 - 7 * x137)
    )
    out[..., 23] = (
        x138 * x140 * x69 * (omega_2 * x121 + 4 * x116 + x139 + 4 * x35 * x52 - x32 * x51)
    )
    out[..., 24] = (
        -Phi_alpha_2 * x155 * x156 * x16 * x33 * x70 * (10 * omega_1 * x146 + x118 * x144
        + 4 * x123 * x61 + 8 * x135 * x81 + x143 * x145 + 16 * x152 + x154 + x158 * x18 * x38
        - x113 * x95 - 3 * x115 * x28 - 12 * x118 * x157 - x141 * x142 - 16 * x148 - 6 * x149
        - 5 * x150)
    )
    out[..., 25] = (
        -1j * x23 * x94 * (40 * x107 * x47 + x121 + 18 * x151 + 23 * x159 + x52 * x95
        - 30 * omega_1 * x37 - x133 * x95 - 32 * x160)
    )
    out[..., 26] = x100 * x166 * x99 * (x14 + x76) * (4 * x162 + 3 * x165 - 9 * x163 - 8 * x164)
    out[..., 27] = 1j * x102 * x33 * x96 * (x24 + x88) * (9 * x162 + 8 * x165 - 4 * x163 - 3 * x164)
    out[..., 28] = (
        1j * x104 * x12 * (40 * omega_2 * x34 * x39 + x123 + 18 * x125 + 23 * x160 + x37 * x85
        - 30 * omega_2 * x52 - x135 * x85 - 32 * x159)
    )
    out[..., 29] = (
        -Phi_alpha_1 * x156 * x166 * x26 * x71 * (12 * x111 * x158 + x129 * x153 + x13 * x167
        + x146 * x85 + 5 * x148 + 16 * x150 + 6 * x152 + x154 - 10 * omega_2 * x113
        - 8 * x105 * x133 - x111 * x144 - 4 * x121 * x62 - x129 * x143 - 16 * x149
        - x157 * x49 * x9)
    )
    out[..., 30] = (
        -x140 * x155 * x48 * (omega_1 * x123 + x116 + 4 * x139 + 4 * x32 * x37 - x35 * x40)
    )
    out[..., 31] = (
        -1j * x110 * x48 * (84 * omega_1 * x119 + 40 * omega_1 * x142 + x111 * x57 * x95
        + 4 * x118 * x128 + 8 * x130 + 15 * x134 + 80 * x136 + 18 * x147 + x167
        - omega_1 * x106 * x151 - 7 * x122 - 96 * x124 - 32 * x127 - 24 * x131 - 7 * x132
        - 16 * x137 - 72 * x146)
    )
    out[..., 32] = omega_1
    out[..., 33] = x168
    out[..., 34] = x168 - omega_1


def _leading(out, I_t, I_p, Omega_s, k):
    # Intermediates
    x0 = I_p * Omega_s
    x1 = k * k
    x2 = I_p * I_p
    x3 = Omega_s * Omega_s
    x4 = I_t * I_t
    # Outputs
    out[..., 0] = I_t
    out[..., 3] = I_t
    out[..., 5] = -x0
    out[..., 6] = x0
    out[..., 8] = k
    out[..., 11] = k
    out[..., 12] = x1
    out[..., 13] = -2 * I_t * k - x2 * x3
    out[..., 14] = x4


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Amplitudes grow like exp(Γ t). Where the discriminant of the quadratic in Γ is positive, the
    rate is half its root; elsewhere both modes are neutral and the rate is exactly 0.0.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.
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
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("sigma", "kappa", "omega_1", "omega_2", "Phi_alpha_1", "Phi_alpha_2") if gradient else (),
    )


def boundaries(
    *, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike,
    Phi_alpha_2: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable interval of sigma.

    This case cannot be unstable for any detuning: NaN everywhere.

    Parameters
    ----------
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.
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
        PARAMETERS, kappa=kappa, omega_1=omega_1, omega_2=omega_2, Phi_alpha_1=Phi_alpha_1,
        Phi_alpha_2=Phi_alpha_2,
    )
    return boundaries_at(
        evaluate_pair,
        no_edges,
        arguments,
        ("kappa", "omega_1", "omega_2", "Phi_alpha_1", "Phi_alpha_2") if gradient else (),
    )


def critical_speeds(
    *, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike,
    Phi_alpha_2: ArrayLike,
) -> tuple[Any, Any]:
    """Both edges of the unstable zone in the detuned frequency: there is none.

    This case cannot be unstable for any detuning: NaN everywhere.

    Parameters
    ----------
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

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
        PARAMETERS, kappa=kappa, omega_1=omega_1, omega_2=omega_2, Phi_alpha_1=Phi_alpha_1,
        Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_pair(no_edges, arguments)


def slow_flow_matrix(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

    Returns
    -------
    complex128
        Shape (..., 2, 2), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (2, 2))


def characteristic_coefficients(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

    Returns
    -------
    complex128
        Shape (..., 3), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (3,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike,
    omega_2: ArrayLike, Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

    Returns
    -------
    complex128
        Shape (..., 2), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, kappa: ArrayLike,
    omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
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
        Those at t = 0, shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

    Returns
    -------
    complex128
        Shape (..., 2), complex128, in the unit of the amplitudes.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike,
    omega_2: ArrayLike, Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> Beating:
    """How amplitudes beat: period and largest modulus, from those at t = 0.

    Closed forms where no mode decays: the sum of the moduli of the parts in each eigenvalue, which
    is the least upper bound of |B_j| unless three or more frequencies are commensurable. Else a
    maximum that is searched for in time.

    Parameters
    ----------
    amplitudes : array_like
        Those at t = 0, shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.

    Returns
    -------
    Beating
        period (s), largest, margin, each of shape (..., 2). The period is NaN unless exactly two
        frequencies take part; largest is infinite where the amplitude grows without bound; margin
        is how much too small it may be, 0 for closed forms.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, kappa: ArrayLike,
    omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
    Theta_beta_1: ArrayLike, Theta_beta_2: ArrayLike, order: int | None = None,
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
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.
    Theta_beta_1 : array_like
        Component beta of mode 1, in quadrature, real.
    Theta_beta_2 : array_like
        Component beta of mode 2, in quadrature, real.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2), in the order alpha, beta; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2, Theta_beta_1=Theta_beta_1,
        Theta_beta_2=Theta_beta_2,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=(
            "sigma", "kappa", "omega_1", "omega_2", "Phi_alpha_1", "Phi_alpha_2", "Theta_beta_1",
            "Theta_beta_2",
        )
        if gradient
        else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike,
    omega_2: ArrayLike, Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike, Theta_beta_1: ArrayLike,
    Theta_beta_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at t = 0 of the motion with given coordinates and velocities there.

    The solution of response(0, amplitudes) = q, and of its derivative along slow_flow = v, that
    goes over into that of order zero as the small parameters go to zero.

    Parameters
    ----------
    q : array_like
        Coordinates at t = 0, shape (..., 2), in the order of COORDINATES.
    v : array_like
        Velocities at t = 0, shape (..., 2), per second.
    sigma : array_like
        Detuning, nu = -omega_1 + omega_2 + sigma, rad/s, real.
    kappa : array_like
        Amplitude of its modulation in one direction, N m/rad, > 0.
    omega_1 : array_like
        Natural frequency 1, of alpha, beta, rad/s, > 0.
    omega_2 : array_like
        Natural frequency 2, of alpha, beta, rad/s, > 0.
    Phi_alpha_1 : array_like
        Component alpha of mode 1, real.
    Phi_alpha_2 : array_like
        Component alpha of mode 2, real.
    Theta_beta_1 : array_like
        Component beta of mode 1, in quadrature, real.
    Theta_beta_2 : array_like
        Component beta of mode 2, in quadrature, real.

    Returns
    -------
    complex128
        Shape (..., 2), complex128; NaN where there is none near that of order zero, as far outside
        of the scaling, or where a harmonic resonates itself.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2, Theta_beta_1=Theta_beta_1,
        Theta_beta_2=Theta_beta_2,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 6, False))


def modes(*, I_t: ArrayLike, I_p: ArrayLike, Omega_s: ArrayLike, k: ArrayLike) -> dict[str, Any]:
    """Natural frequencies and mode shapes, as keywords for the other functions.

    Of M0 q'' + G0 q' + K0 q = 0, the leading order. The shape φ = Φ + iΘ of a mode is scaled by
    φᴴ(2ω M0 - iG0)φ = 2ω, which is Φᵀ M0 Φ = 1 without gyroscopic terms; its largest component is
    positive, or i times positive.

    Parameters
    ----------
    I_t : array_like
        Inertia about a diameter, kg m^2, > 0.
    I_p : array_like
        Inertia about the axis of rotation, kg m^2, > 0.
    Omega_s : array_like
        Speed of rotation, rad/s, > 0.
    k : array_like
        Stiffness against tilting, N m/rad, > 0.

    Returns
    -------
    float64
        Name -> float64, in the shape to which the arguments broadcast; NaN where M0 or K0 is not
        positive definite.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, I_t=I_t, I_p=I_p, Omega_s=Omega_s, k=k)
    return modal_values(
        evaluate_array(_leading, arguments, (15,)).real,
        (
            (
                2,
                (False, True),
                ((2, 1),),
                (("omega_1", 1.0), ("omega_2", 1.0)),
                (("Phi_alpha_1", 0, 0, False), ("Phi_alpha_2", 0, 1, False)),
            ),
        ),
    )
