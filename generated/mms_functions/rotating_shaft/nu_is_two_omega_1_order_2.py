# Emitted by mmsgen 0.1.0 from derivations/rotating_shaft.py: change that, not this file.
# Made from sha256 90ee93569e9f0593daa2dedca14d95ed6aa3b81877ad6a43d8fe5a487f96e5d6
# Operations for each point: growth_rate 83, boundaries 77, resonance 1, slow_flow_matrix 66,
# characteristic_coefficients 98, slow_flow 73, motion 459, leading 9
"""rotating_shaft: nu = 2*omega_1 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of eta_1, eta_2. Results are written at ε = 1.

It can be unstable: the discriminant of Gamma**2 - (Phi_alpha_1**2*kappa -
2*omega_1*sigma)*(Phi_alpha_1**2*kappa + 2*omega_1*sigma)/(16*omega_1**2) is positive in an interval
of the detuning.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: 3*omega_1 - omega_2, omega_1 - omega_2.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; gyroscopic modes after
Meirovitch, AIAA Journal 12 (1974)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._edges import explicit_edges, zone
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
RELATIONS: tuple[str, ...] = ("nu = 2*omega_1 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("eta_1", "eta_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, nu = 2*omega_1 + sigma"),
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
    "eta_1": {"sigma": 1 / 2},
    "eta_2": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_eta_1", "conj(A_eta_1)", "A_eta_2")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    2,
    (
        ((0, 0), (0, 1)), ((1, 0),),
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
    x0 = omega_1 + omega_2
    x1 = -omega_2
    x2 = omega_1 + x1
    x3 = 3 * omega_1
    x4 = omega_2 + x3
    x5 = x1 + x3
    x6 = Phi_alpha_1 * Phi_alpha_1
    x7 = omega_2 * omega_2
    x8 = x7 * x7
    x9 = x6 * x8
    x10 = omega_1 * omega_1
    x11 = x10 * x10
    x12 = x11 * x6
    x13 = Phi_alpha_2 * Phi_alpha_2
    x14 = 80 * x11 * x13
    x15 = x10 * x7
    x16 = x15 * x6
    x17 = 16 * x13 * x15
    x18 = sigma * sigma
    x19 = x6 * x6
    x20 = kappa * kappa
    x21 = x4 * x4
    x22 = x5 * x5
    x23 = x0 * x0
    x24 = x2 * x2
    x25 = x20 * x20
    x26 = x10 * x11
    x27 = 27 * x12 + x14 + 3 * x9 - 30 * x16 - x17
    x28 = x27 * x27
    x29 = omega_1 * x10
    # Outputs
    discriminant_1 = (
        1 / 16 * x18 * x19 * x20 / x11 + 1 / 4 * x19 * x20 / x10 - 1 / 16 * sigma * x20 * x6 * (9
        * x12 + x17 + x9 - x14 - 10 * x16) / (x0 * x2 * x29 * x4 * x5) - x18
        - 1 / 1024 * x19 * x25 * x28 / (x21 * x22 * x23 * x24 * x26)
    )
    return growing(discriminant_1)


def _boundaries(kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = Phi_alpha_1 * Phi_alpha_1
    x1 = x0 * x0
    x2 = kappa * kappa
    x3 = omega_1 * omega_1
    x4 = omega_1 + omega_2
    x5 = x4 * x4
    x6 = -omega_2
    x7 = omega_1 + x6
    x8 = x7 * x7
    x9 = 3 * omega_1
    x10 = omega_2 + x9
    x11 = x10 * x10
    x12 = x6 + x9
    x13 = x12 * x12
    x14 = x2 * x2
    x15 = x3 * x3
    x16 = x15 * x3
    x17 = x0 * x15
    x18 = omega_2 * omega_2
    x19 = x18 * x18
    x20 = x0 * x19
    x21 = Phi_alpha_2 * Phi_alpha_2
    x22 = 80 * x15 * x21
    x23 = x18 * x3
    x24 = x0 * x23
    x25 = 16 * x21 * x23
    x26 = 27 * x17 + 3 * x20 + x22 - 30 * x24 - x25
    x27 = x26 * x26
    x28 = omega_1 * x3
    # Outputs
    p0 = 1 / 4 * x1 * x2 / x3 - 1 / 1024 * x1 * x14 * x27 / (x11 * x13 * x16 * x5 * x8)
    p1 = -1 / 16 * x0 * x2 * (9 * x17 + x20 + x25 - x22 - 10 * x24) / (x10 * x12 * x28 * x4 * x7)
    p2 = 1 / 16 * x1 * x2 / x15 - 1
    return zone((p0, p1, p2))


def _resonance(kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    centre = 2 * omega_1
    return centre, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2


def _slow_flow_matrix(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = Phi_alpha_1 * Phi_alpha_1
    x1 = omega_2 * omega_2
    x2 = x0 * x1
    x3 = Phi_alpha_2 * Phi_alpha_2
    x4 = x1 * x3
    x5 = -omega_2
    x6 = 3 * omega_1
    x7 = kappa * kappa
    x8 = x7 / ((omega_1 + omega_2) * (omega_1 + x5) * (omega_2 + x6) * (x5 + x6))
    x9 = omega_1 * omega_1
    x10 = x9 * x9
    x11 = omega_1 * x9
    x12 = x1 * x1
    x13 = (
        1 / 64 * x0 * x8 * (27 * x0 * x10 + 3 * x0 * x12 + 80 * x10 * x3 - 30 * x2 * x9
        - 16 * x4 * x9) / x11 - 1 / 2 * sigma
    )
    x14 = kappa * x0
    x15 = 1 / 4 * x14 / omega_1 - 1 / 8 * sigma * x14 / x9
    # Outputs
    out[..., 0, 0].imag = x13
    out[..., 0, 1].imag = x15
    out[..., 1, 0].imag = -x15
    out[..., 1, 1].imag = -x13
    out[..., 2, 2].imag = 1 / 16 * x3 * x8 * (12 * x0 * x9 + 4 * x2 + 9 * x3 * x9 - x4) / omega_2


def _characteristic_coefficients(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = Phi_alpha_1 * Phi_alpha_1
    x1 = x0 * x0
    x2 = kappa * kappa
    x3 = x1 * x2
    x4 = omega_2 * omega_2
    x5 = x4 * x4
    x6 = x0 * x5
    x7 = omega_1 * omega_1
    x8 = x7 * x7
    x9 = x0 * x8
    x10 = Phi_alpha_2 * Phi_alpha_2
    x11 = 80 * x10 * x8
    x12 = x0 * x4
    x13 = x12 * x7
    x14 = x10 * x4
    x15 = 16 * x14 * x7
    x16 = omega_1 + omega_2
    x17 = -omega_2
    x18 = omega_1 + x17
    x19 = 3 * omega_1
    x20 = omega_2 + x19
    x21 = x17 + x19
    x22 = x2 / (x16 * x18 * x20 * x21)
    x23 = sigma * sigma
    x24 = omega_1 * x7
    x25 = x16 * x16
    x26 = x18 * x18
    x27 = x20 * x20
    x28 = x21 * x21
    x29 = x2 * x2
    x30 = x7 * x8
    x31 = x11 + 3 * x6 + 27 * x9 - 30 * x13 - x15
    x32 = x31 * x31
    # Outputs
    c1_0 = (
        1 / 64 * sigma * x0 * x22 * (x15 + x6 + 9 * x9 - x11 - 10 * x13) / x24
        + 1 / 4096 * x1 * x29 * x32 / (x25 * x26 * x27 * x28 * x30) + 1 / 4 * x23
        - 1 / 64 * x23 * x3 / x8 - 1 / 16 * x3 / x7
    )
    c2_0 = -1 / 16 * 1j * x10 * x22 * (12 * x0 * x7 + 9 * x10 * x7 + 4 * x12 - x14) / omega_2
    multiply_out(out, ((0.0, c1_0), 1), ((c2_0,), 1))


def _slow_flow(out, A_eta_1, A_eta_2, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = 1j * A_eta_1
    x1 = Phi_alpha_1 * Phi_alpha_1
    x2 = omega_2 * omega_2
    x3 = x1 * x2
    x4 = Phi_alpha_2 * Phi_alpha_2
    x5 = x2 * x4
    x6 = -omega_2
    x7 = 3 * omega_1
    x8 = kappa * kappa
    x9 = x8 / ((omega_1 + omega_2) * (omega_1 + x6) * (omega_2 + x7) * (x6 + x7))
    x10 = omega_1 * omega_1
    x11 = x10 * x10
    x12 = omega_1 * x10
    x13 = x2 * x2
    # Outputs
    out[..., 0] = (
        1 / 8 * 1j * kappa * x1 * (2 * omega_1 - sigma) * np.conj(A_eta_1) / x10 + 1 / 64 * x0 * x1
        * x9 * (27 * x1 * x11 + 3 * x1 * x13 + 80 * x11 * x4 - 30 * x10 * x3 - 16 * x10 * x5) / x12
        - 1 / 2 * sigma * x0
    )
    out[..., 1] = (
        1 / 16 * 1j * A_eta_2 * x4 * x9 * (12 * x1 * x10 + 9 * x10 * x4 + 4 * x3 - x5) / omega_2
    )


def _motion(
    out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2, Theta_beta_1, Theta_beta_2,
):
    # Intermediates
    x0 = 2 * Phi_alpha_2
    x1 = 2 * Phi_alpha_1
    x2 = 2 * 1j
    x3 = 3 * omega_1
    x4 = -omega_2
    x5 = x3 + x4
    x6 = 1 / x5
    x7 = Phi_alpha_2 * Phi_alpha_2
    x8 = omega_2 * x7
    x9 = 4 * omega_1
    x10 = Phi_alpha_1 * Phi_alpha_1
    x11 = x10 * x9 + x3 * x7
    x12 = x11 - x8
    x13 = omega_1 + x4
    x14 = 1 / x13
    x15 = kappa * x14
    x16 = 1 / omega_1
    x17 = Phi_alpha_2 * x16
    x18 = 1 / 4 * x17
    x19 = x15 * x18
    x20 = omega_2 + x3
    x21 = 1 / x20
    x22 = kappa * x21
    x23 = omega_1 + omega_2
    x24 = 1 / x23
    x25 = x24 * (x11 + x8)
    x26 = Phi_alpha_1 * x7
    x27 = x15 * x24
    x28 = omega_1 * omega_1
    x29 = x10 * x28
    x30 = omega_2 * omega_2
    x31 = x10 * x30
    x32 = -x31
    x33 = x28 * x7
    x34 = 8 * x33
    x35 = 9 * x29 + x32 + x34
    x36 = 1 / 8 * x6
    x37 = 1 / x28
    x38 = Phi_alpha_1 * x37
    x39 = x22 * x38
    x40 = 1j * kappa
    x41 = 1 / 2 * x40
    x42 = 1 / omega_2
    x43 = Theta_beta_2 * x16 * x41 * x42 * x7
    x44 = Phi_alpha_1 * Theta_beta_1
    x45 = x17 * x44
    x46 = Phi_alpha_2 * Theta_beta_2
    x47 = Theta_beta_1 * x1
    x48 = 1 / 2 * 1j
    x49 = omega_2 * x30
    x50 = x44 * x49
    x51 = -x50
    x52 = omega_2 * x44
    x53 = x28 * x52
    x54 = omega_1 * x28
    x55 = x46 * x54
    x56 = 1j * x42
    x57 = x56 * x6
    x58 = 8 * omega_1
    x59 = omega_2 * x58
    x60 = x10 * x59
    x61 = x58 * x8
    x62 = x30 * x7
    x63 = 16 * x29 + x62
    x64 = 15 * x33 + x63
    x65 = 2 * omega_1
    x66 = x4 + x65
    x67 = 5 * omega_1
    x68 = 1 / (x4 + x67)
    x69 = x5 * x5
    x70 = 1 / x69
    x71 = x14 * x70
    x72 = Phi_alpha_2 * x37
    x73 = 1 / 64 * x72
    x74 = kappa * kappa
    x75 = x12 * x68 * x71 * x73 * x74 / x66
    x76 = 6 * omega_1 * x8
    x77 = 9 * x33
    x78 = x63 + x77
    x79 = kappa * sigma
    x80 = x70 * x79
    x81 = x13 * x13
    x82 = 1 / x81
    x83 = 1 / 8 * x72
    x84 = x82 * x83
    x85 = 12 * x29 + 4 * x31 + x77 - x62
    x86 = x23 * x23
    x87 = 1 / x86
    x88 = x82 * x87
    x89 = 1 / 4 * x88
    x90 = x21 * x74
    x91 = x6 * x90
    x92 = omega_2 + x65
    x93 = x20 * x20
    x94 = 1 / x93
    x95 = x83 * x87 * x94
    x96 = 1 / (omega_2 + x67)
    x97 = x74 * x94
    x98 = x25 * x73 * x96 * x97 / x92
    x99 = x30 * x30
    x100 = x10 * x99
    x101 = x28 * x28
    x102 = x101 * x7
    x103 = Phi_alpha_1 / x101
    x104 = 1 / 128 * x103 * x24 * x71 * x97
    x105 = x10 * x10
    x106 = x101 * x28
    x107 = x7 * x7
    x108 = x30 * x99
    x109 = 81 * x10 * x101 + x100 - 18 * x28 * x31
    x110 = Phi_alpha_1 / x54
    x111 = x110 * x94
    x112 = 24 * x33
    x113 = x103 * x35 * x68 * x96
    x114 = x30 * x44
    x115 = 8 * x114
    x116 = x46 * x59
    x117 = x30 * x46
    x118 = 16 * omega_1 * x52 + x117 + 15 * x28 * x46
    x119 = 32 * x114 * x28
    x120 = 30 * omega_2 * x55
    x121 = x46 * x49 * x58
    x122 = 18 * x101 * x46 + 23 * x117 * x28 + x46 * x99 + x50 * x58 + 40 * x52 * x54
    x123 = sigma * x40 * x42
    x124 = x123 * x70
    x125 = x47 * x49
    x126 = x88 * x90
    x127 = Phi_alpha_1 * x10
    x128 = Theta_beta_1 * x127
    x129 = x49 * x99
    x130 = x128 * x129
    x131 = Phi_alpha_2 * x7
    x132 = Theta_beta_2 * x131
    x133 = x101 * x54
    x134 = x132 * x133
    x135 = x106 * x44 * x8
    x136 = x101 * x128 * x49
    x137 = omega_2 * x99
    x138 = x137 * x44
    x139 = x100 * x55
    x140 = omega_1 * x101
    x141 = x140 * x46
    x142 = x141 * x31
    x143 = x101 * x52
    x144 = x117 * x54
    # Outputs
    out[..., 0] = x0
    out[..., 1] = x1
    out[..., 2] = Theta_beta_2 * x2
    out[..., 3] = Theta_beta_1 * x2
    out[..., 4] = x12 * x19 * x6
    out[..., 5] = x18 * x22 * x25
    out[..., 6] = x26 * x27
    out[..., 7] = x35 * x36 * x39
    out[..., 8] = -1j * x19 * (x46 + x47) - x41 * x45 * x6 - x43
    out[..., 9] = x18 * x24 * x40 * (x47 - x46) + x22 * x45 * x48 + x43
    out[..., 10] = -x27 * x38 * x42 * x48 * (Theta_beta_2 * x0 * x54 + x51 + x53)
    out[..., 11] = 3 / 8 * x39 * x57 * (x51 + 9 * x53 + 8 * x55)
    out[..., 12] = x75 * (x64 - x60 - x61)
    out[..., 13] = -x66 * x80 * x84 * (x78 - x76)
    out[..., 14] = -Phi_alpha_2 * x10 * x85 * x89 * x91
    out[..., 15] = -x79 * x92 * x95 * (x76 + x78)
    out[..., 16] = x98 * (x60 + x61 + x64)
    out[..., 17] = (
        -x104 * (64 * x101 * x107 * x30 + 243 * x105 * x106 + 57 * x105 * x28 * x99
        - 456 * x10 * x106 * x7 - x100 * x34 - 297 * x101 * x105 * x30 - 48 * x102 * x31
        - 3 * x105 * x108 - 576 * x106 * x107)
    )
    out[..., 18] = -omega_1 * x1 * x7 * x79 * x88
    out[..., 19] = 1 / 16 * x26 * x37 * x88 * x91 * (80 * x102 + x109 - 16 * x28 * x62)
    out[..., 20] = -3 / 32 * x111 * x80 * (64 * x102 + x109)
    out[..., 21] = x113 * x91 * (x112 + 25 * x29 + x32) / 384
    out[..., 22] = -x56 * x75 * (x4 + x9) * (x118 - x115 - x116)
    out[..., 23] = x124 * x84 * (x122 - x119 - x120 - x121)
    out[..., 24] = -1j * x126 * x17 * x36 * x85 * (omega_1 * x117 + x125 - x55) / x30
    out[..., 25] = -x123 * x95 * (x119 + x120 + x121 + x122)
    out[..., 26] = x56 * x98 * (omega_2 + x9) * (x115 + x116 + x118)
    out[..., 27] = (
        x104 * x56 * (432 * Phi_alpha_1 * Theta_beta_1 * x101 * x49 * x7
        + 288 * Phi_alpha_2 * Theta_beta_2 * x10 * x133 + 405 * Theta_beta_1 * omega_2 * x106 * x127
        + 95 * Theta_beta_1 * x127 * x137 * x28 + 192 * Theta_beta_2 * x131 * x140 * x30
        - x112 * x138 - 5 * x130 - 1728 * x134 - 1944 * x135 - 495 * x136 - 32 * x139 - 256 * x142)
    )
    out[..., 28] = x110 * x123 * x89 * (x138 + 4 * x141 + x143 + 4 * x144 - x125 * x28)
    out[..., 29] = (
        1 / 32 * x103 * x126 * x57 * (27 * omega_2 * x106 * x128 + 90 * x10 * x133 * x46
        + 33 * x128 * x137 * x28 + 160 * x134 + 80 * x135 + 16 * x138 * x33 + 44 * x142
        - 96 * x102 * x50 - 3 * x130 - 32 * x132 * x140 * x30 - 57 * x136 - 6 * x139)
    )
    out[..., 30] = (
        -1 / 32 * x111 * x124 * (5 * x138 + 288 * x141 + 405 * x143 + 32 * x144 - 90 * x28 * x50)
    )
    out[..., 31] = 5 * x113 * x57 * x90 * (x51 + 25 * x53 + 24 * x55) / 384
    out[..., 32] = omega_1 + 1 / 2 * sigma
    out[..., 33] = omega_2
    out[..., 34] = sigma + x65


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
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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

    The interval of sigma in which growth_rate is positive: where one of the polynomials with the
    coefficients in `_boundaries` (lowest power first) is. Infinite where the interval has no end.
    Order 2 leaves out terms of the edges from ε^3 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero;
    SlowFlow.zones() gives all of them.

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
        _boundaries,
        arguments,
        ("kappa", "omega_1", "omega_2", "Phi_alpha_1", "Phi_alpha_2") if gradient else (),
    )


def critical_speeds(
    *, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, Phi_alpha_1: ArrayLike,
    Phi_alpha_2: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable zone in nu.

    Where nu = 2*omega_1 + sigma lies on an edge of `boundaries`.

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
        In rad/s, float64, in the shape to which the arguments broadcast; NaN where there is no such
        edge. With gradient this pair and name -> pair.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, kappa=kappa, omega_1=omega_1, omega_2=omega_2, Phi_alpha_1=Phi_alpha_1,
        Phi_alpha_2=Phi_alpha_2,
    )
    return explicit_edges(
        _resonance,
        _boundaries,
        1,
        arguments,
        ("kappa", "omega_1", "omega_2", "Phi_alpha_1", "Phi_alpha_2") if gradient else (),
    )


def slow_flow_matrix(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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
        Shape (..., 3, 3), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (3, 3))


def characteristic_coefficients(
    *, sigma: ArrayLike, kappa: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    Phi_alpha_1: ArrayLike, Phi_alpha_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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
        Shape (..., 4), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, kappa=kappa, omega_1=omega_1, omega_2=omega_2,
        Phi_alpha_1=Phi_alpha_1, Phi_alpha_2=Phi_alpha_2,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (4,))


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
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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
        Detuning, nu = 2*omega_1 + sigma, rad/s, real.
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
