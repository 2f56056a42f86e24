# Emitted by mmsgen 0.1.0 from derivations/rotating_shaft.py: change that, not this file.
# Made from sha256 47d338b357b2702ddf6a5a1761715b551b04f06c084a32108d2902219ce11176
# Operations for each point: growth_rate 88, boundaries 82, resonance 1, slow_flow_matrix 68,
# characteristic_coefficients 104, slow_flow 75, motion 463, leading 9
"""rotating_shaft: nu = 2*omega_2 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of eta_1, eta_2. Results are written at ε = 1.

It can be unstable: the discriminant of Gamma**2 - (Phi_alpha_2**2*kappa -
2*omega_2*sigma)*(Phi_alpha_2**2*kappa + 2*omega_2*sigma)/(16*omega_2**2) is positive in an interval
of the detuning.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: omega_1 - 3*omega_2, omega_1 - omega_2.

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
RELATIONS: tuple[str, ...] = ("nu = 2*omega_2 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("eta_1", "eta_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, nu = 2*omega_2 + sigma"),
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
    "eta_2": {"sigma": 1 / 2},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_eta_1", "A_eta_2", "conj(A_eta_2)")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    2,
    (
        ((0, 0),), ((1, 0), (1, 1)),
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
    x1 = 3 * omega_2
    x2 = omega_1 - x1
    x3 = omega_1 - omega_2
    x4 = omega_1 + x1
    x5 = Phi_alpha_2 * Phi_alpha_2
    x6 = omega_1 * omega_1
    x7 = x6 * x6
    x8 = x5 * x7
    x9 = omega_2 * omega_2
    x10 = x9 * x9
    x11 = Phi_alpha_1 * Phi_alpha_1
    x12 = 80 * x10 * x11
    x13 = x10 * x5
    x14 = x6 * x9
    x15 = sigma * sigma
    x16 = x5 * x5
    x17 = kappa * kappa
    x18 = x4 * x4
    x19 = x0 * x0
    x20 = x2 * x2
    x21 = x3 * x3
    x22 = x17 * x17
    x23 = x10 * x9
    x24 = 16 * x11 * x6 * x9 + 30 * x5 * x6 * x9 - x12 - 27 * x13 - 3 * x8
    x25 = x24 * x24
    x26 = omega_2 * x9
    # Outputs
    discriminant_1 = (
        1 / 4 * x16 * x17 / x9 + 1 / 16 * x15 * x16 * x17 / x10 - 1 / 16 * sigma * x17 * x5 * (16
        * x11 * x14 + 9 * x13 + x8 - x12 - 10 * x14 * x5) / (x0 * x2 * x26 * x3 * x4) - x15
        - 1 / 1024 * x16 * x22 * x25 / (x18 * x19 * x20 * x21 * x23)
    )
    return growing(discriminant_1)


def _boundaries(kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = Phi_alpha_2 * Phi_alpha_2
    x1 = x0 * x0
    x2 = kappa * kappa
    x3 = omega_2 * omega_2
    x4 = omega_1 + omega_2
    x5 = x4 * x4
    x6 = 3 * omega_2
    x7 = omega_1 - x6
    x8 = x7 * x7
    x9 = omega_1 - omega_2
    x10 = x9 * x9
    x11 = omega_1 + x6
    x12 = x11 * x11
    x13 = x2 * x2
    x14 = x3 * x3
    x15 = x14 * x3
    x16 = Phi_alpha_1 * Phi_alpha_1
    x17 = 80 * x14 * x16
    x18 = omega_1 * omega_1
    x19 = x18 * x18
    x20 = x0 * x19
    x21 = x0 * x14
    x22 = 30 * x0 * x18 * x3 + 16 * x16 * x18 * x3 - x17 - 3 * x20 - 27 * x21
    x23 = x22 * x22
    x24 = x18 * x3
    x25 = omega_2 * x3
    # Outputs
    p0 = 1 / 4 * x1 * x2 / x3 - 1 / 1024 * x1 * x13 * x23 / (x10 * x12 * x15 * x5 * x8)
    p1 = (
        -1 / 16 * x0 * x2 * (16 * x16 * x24 + x20 + 9 * x21 - 10 * x0 * x24 - x17) / (x11 * x25 * x4
        * x7 * x9)
    )
    p2 = 1 / 16 * x1 * x2 / x14 - 1
    return zone((p0, p1, p2))


def _resonance(kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    centre = 2 * omega_2
    return centre, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2


def _slow_flow_matrix(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = 3 * omega_2
    x1 = kappa * kappa
    x2 = x1 / ((omega_1 - omega_2) * (omega_1 + omega_2) * (omega_1 - x0) * (omega_1 + x0))
    x3 = Phi_alpha_1 * Phi_alpha_1
    x4 = omega_1 * omega_1
    x5 = omega_2 * omega_2
    x6 = Phi_alpha_2 * Phi_alpha_2
    x7 = x5 * x5
    x8 = omega_2 * x5
    x9 = x4 * x4
    x10 = (
        1 / 2 * sigma + 1 / 64 * x2 * x6 * (16 * x3 * x4 * x5 + 30 * x4 * x5 * x6 - 80 * x3 * x7
        - 27 * x6 * x7 - 3 * x6 * x9) / x8
    )
    x11 = kappa * x6
    x12 = 1 / 4 * x11 / omega_2 - 1 / 8 * sigma * x11 / x5
    # Outputs
    out[..., 0, 0].imag = (
        -1 / 16 * x2 * x3 * (x3 * x4 - 9 * x3 * x5 - 4 * x4 * x6 - 12 * x5 * x6) / omega_1
    )
    out[..., 1, 1].imag = -x10
    out[..., 1, 2].imag = x12
    out[..., 2, 1].imag = -x12
    out[..., 2, 2].imag = x10


def _characteristic_coefficients(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = omega_2 * omega_2
    x1 = Phi_alpha_2 * Phi_alpha_2
    x2 = x0 * x1
    x3 = omega_1 + omega_2
    x4 = omega_1 - omega_2
    x5 = 3 * omega_2
    x6 = omega_1 - x5
    x7 = omega_1 + x5
    x8 = kappa * kappa
    x9 = x8 / (x3 * x4 * x6 * x7)
    x10 = Phi_alpha_1 * Phi_alpha_1
    x11 = omega_1 * omega_1
    x12 = x1 * x1
    x13 = x12 * x8
    x14 = x11 * x11
    x15 = x1 * x14
    x16 = x0 * x0
    x17 = 80 * x10 * x16
    x18 = x1 * x16
    x19 = sigma * sigma
    x20 = omega_2 * x0
    x21 = x7 * x7
    x22 = x3 * x3
    x23 = x4 * x4
    x24 = x6 * x6
    x25 = x8 * x8
    x26 = x0 * x16
    x27 = 30 * x0 * x1 * x11 + 16 * x0 * x10 * x11 - 3 * x15 - x17 - 27 * x18
    x28 = x27 * x27
    # Outputs
    c1_0 = 1 / 16 * 1j * x10 * x9 * (x10 * x11 - 9 * x0 * x10 - 4 * x1 * x11 - 12 * x2) / omega_1
    c2_0 = (
        1 / 64 * sigma * x1 * x9 * (16 * x0 * x10 * x11 + x15 + 9 * x18 - 10 * x11 * x2 - x17) / x20
        + 1 / 4096 * x12 * x25 * x28 / (x21 * x22 * x23 * x24 * x26) + 1 / 4 * x19
        - 1 / 64 * x13 * x19 / x16 - 1 / 16 * x13 / x0
    )
    multiply_out(out, ((c1_0,), 1), ((0.0, c2_0), 1))


def _slow_flow(out, A_eta_1, A_eta_2, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = 3 * omega_2
    x1 = kappa * kappa
    x2 = x1 / ((omega_1 - omega_2) * (omega_1 + omega_2) * (omega_1 - x0) * (omega_1 + x0))
    x3 = Phi_alpha_1 * Phi_alpha_1
    x4 = omega_1 * omega_1
    x5 = omega_2 * omega_2
    x6 = Phi_alpha_2 * Phi_alpha_2
    x7 = 1j * A_eta_2
    x8 = x5 * x5
    x9 = omega_2 * x5
    x10 = x4 * x4
    # Outputs
    out[..., 0] = (
        -1 / 16 * 1j * A_eta_1 * x2 * x3 * (x3 * x4 - 9 * x3 * x5 - 4 * x4 * x6 - 12 * x5 * x6)
        / omega_1
    )
    out[..., 1] = (
        1 / 8 * 1j * kappa * x6 * (2 * omega_2 - sigma) * np.conj(A_eta_2) / x5 - 1 / 2 * sigma * x7
        - 1 / 64 * x2 * x6 * x7 * (16 * x3 * x4 * x5 + 30 * x4 * x5 * x6 - 3 * x10 * x6 - 80 * x3
        * x8 - 27 * x6 * x8) / x9
    )


def _motion(
    out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2, Theta_beta_1, Theta_beta_2,
):
    # Intermediates
    x0 = 2 * Phi_alpha_2
    x1 = 2 * Phi_alpha_1
    x2 = 2 * 1j
    x3 = Phi_alpha_2 * kappa
    x4 = omega_1 + omega_2
    x5 = 1 / x4
    x6 = omega_1 - omega_2
    x7 = 1 / x6
    x8 = x5 * x7
    x9 = x3 * x8
    x10 = Phi_alpha_1 * Phi_alpha_1
    x11 = omega_2 * omega_2
    x12 = 1 / x11
    x13 = 1 / 8 * x12
    x14 = x10 * x11
    x15 = 8 * x14
    x16 = Phi_alpha_2 * Phi_alpha_2
    x17 = omega_1 * omega_1
    x18 = x16 * x17
    x19 = -x18
    x20 = x11 * x16
    x21 = 3 * omega_2
    x22 = omega_1 - x21
    x23 = 1 / x22
    x24 = omega_1 + x21
    x25 = 1 / x24
    x26 = x23 * x25
    x27 = x26 * (x15 + x19 + 9 * x20)
    x28 = 4 * omega_2
    x29 = x10 * x21 + x16 * x28
    x30 = x7 * (omega_1 * x10 - x29)
    x31 = 1 / omega_2
    x32 = kappa * x31
    x33 = 1 / 4 * Phi_alpha_1
    x34 = x32 * x33
    x35 = omega_1 * x10
    x36 = x29 + x35
    x37 = x34 * x5
    x38 = Phi_alpha_2 * Theta_beta_2
    x39 = omega_1 * x17
    x40 = x38 * x39
    x41 = -x40
    x42 = omega_1 * x38
    x43 = x11 * x42
    x44 = 1j / omega_1
    x45 = x12 * x44
    x46 = omega_2 * x11
    x47 = Phi_alpha_1 * Theta_beta_1
    x48 = x46 * x47
    x49 = 1 / 2 * x32
    x50 = Theta_beta_1 * x10 * x44 * x49
    x51 = 1j * Phi_alpha_1
    x52 = x38 * x49 * x51
    x53 = Theta_beta_2 * x0
    x54 = x11 * x11
    x55 = x10 * x54
    x56 = x17 * x17
    x57 = x16 * x56
    x58 = x22 * x22
    x59 = 1 / x58
    x60 = x24 * x24
    x61 = 1 / x60
    x62 = x59 * x61
    x63 = kappa * kappa
    x64 = Phi_alpha_2 * x63
    x65 = x64 / x54
    x66 = 1 / 128 * x62 * x65 * x8
    x67 = x10 * x10
    x68 = x11 * x54
    x69 = x16 * x16
    x70 = x17 * x56
    x71 = kappa * sigma
    x72 = x4 * x4
    x73 = 1 / x72
    x74 = x6 * x6
    x75 = 1 / x74
    x76 = x73 * x75
    x77 = x10 * x76
    x78 = 81 * x16 * x54 + x57 - 18 * x11 * x18
    x79 = sigma * x3 / x46
    x80 = x62 * x79
    x81 = 24 * x14
    x82 = 5 * omega_2
    x83 = 1 / (omega_1 - x82)
    x84 = 1 / (omega_1 + x82)
    x85 = x27 * x65 * x83 * x84
    x86 = 8 * omega_2
    x87 = x35 * x86
    x88 = omega_1 * x86
    x89 = x16 * x88
    x90 = x10 * x17 + 16 * x20
    x91 = 15 * x14 + x90
    x92 = 1 / 64 * x63
    x93 = x12 * x92
    x94 = 2 * omega_2
    x95 = omega_1 - x94
    x96 = Phi_alpha_1 * x59
    x97 = x30 * x83 * x96 / x95
    x98 = 6 * omega_2 * x35
    x99 = 9 * x14
    x100 = x90 + x99
    x101 = x13 * x71
    x102 = x101 * x75 * x96
    x103 = x26 * x76
    x104 = x103 * x63 * (x10 * x17 - 4 * x18 - 12 * x20 - x99)
    x105 = omega_1 + x94
    x106 = Phi_alpha_1 * x61
    x107 = x101 * x106 * x73
    x108 = x106 * x36 * x5 * x84 / x105
    x109 = x46 * x54
    x110 = Phi_alpha_1 * x10
    x111 = Theta_beta_1 * x109 * x110
    x112 = Phi_alpha_2 * x16
    x113 = Theta_beta_2 * x112
    x114 = x35 * x38 * x68
    x115 = omega_2 * x54
    x116 = x115 * x47
    x117 = x116 * x18
    x118 = omega_1 * x56
    x119 = x118 * x38
    x120 = x39 * x56
    x121 = x42 * x54
    x122 = x17 * x47
    x123 = x122 * x46
    x124 = x39 * x53
    x125 = 1 / 32 * x44
    x126 = x17 * x38
    x127 = 8 * x126
    x128 = x47 * x88
    x129 = 16 * omega_2 * x42 + 15 * x11 * x47 + x122
    x130 = x45 * x92
    x131 = 32 * x11 * x126
    x132 = 30 * omega_1 * x48
    x133 = x39 * x47 * x86
    x134 = 23 * x11 * x122 + x40 * x86 + 40 * x42 * x46 + 18 * x47 * x54 + x47 * x56
    # Outputs
    out[..., 0] = x0
    out[..., 1] = x1
    out[..., 2] = Theta_beta_2 * x2
    out[..., 3] = Theta_beta_1 * x2
    out[..., 4] = -x10 * x9
    out[..., 5] = -x13 * x27 * x3
    out[..., 6] = -x23 * x30 * x34
    out[..., 7] = x25 * x36 * x37
    out[..., 8] = 1 / 2 * x45 * x9 * (Theta_beta_1 * x1 * x46 + x41 + x43)
    out[..., 9] = -3 / 8 * x26 * x3 * x45 * (x41 + 9 * x43 + 8 * x48)
    out[..., 10] = x23 * x52 + 1j * x34 * x7 * (x47 + x53) - x50
    out[..., 11] = x25 * x52 + x50 - 1j * x37 * (x47 - x53)
    out[..., 12] = (
        x66 * (57 * x11 * x56 * x69 + 64 * x17 * x54 * x67 + 243 * x68 * x69 - 456 * x10 * x16 * x68
        - x15 * x57 - 297 * x17 * x54 * x69 - 48 * x18 * x55 - 576 * x67 * x68 - 3 * x69 * x70)
    )
    out[..., 13] = -omega_2 * x0 * x71 * x77
    out[..., 14] = 1 / 16 * x12 * x26 * x64 * x77 * (16 * x10 * x11 * x17 - 80 * x55 - x78)
    out[..., 15] = -3 / 32 * x80 * (64 * x55 + x78)
    out[..., 16] = x85 * (x19 + 25 * x20 + x81) / 384
    out[..., 17] = x93 * x97 * (x91 - x87 - x89)
    out[..., 18] = x102 * x95 * (x100 - x98)
    out[..., 19] = -x104 * x16 * x33
    out[..., 20] = -x105 * x107 * (x100 + x98)
    out[..., 21] = x108 * x93 * (x87 + x89 + x91)
    out[..., 22] = (
        -x44 * x66 * (288 * Phi_alpha_1 * Theta_beta_1 * x109 * x16
        + 432 * Phi_alpha_2 * Theta_beta_2 * x10 * x39 * x54
        + 192 * Theta_beta_1 * x110 * x115 * x17 + 405 * Theta_beta_2 * omega_1 * x112 * x68
        + 95 * Theta_beta_2 * x11 * x112 * x118 - 1728 * x111 - 5 * x113 * x120
        - 495 * x113 * x39 * x54 - 1944 * x114 - 256 * x117 - x119 * x81 - 32 * x48 * x57)
    )
    out[..., 23] = 1 / 4 * x44 * x76 * x79 * (4 * x116 + x119 + x121 + 4 * x123 - x11 * x124)
    out[..., 24] = (
        x103 * x125 * x65 * (6 * Phi_alpha_1 * Theta_beta_1 * x16 * x46 * x56
        + 96 * Phi_alpha_2 * Theta_beta_2 * x10 * x39 * x54 + 32 * Theta_beta_1 * x110 * x115 * x17
        + 3 * Theta_beta_2 * x112 * x120 + 57 * Theta_beta_2 * x112 * x39 * x54
        - 27 * omega_1 * x113 * x68 - 90 * x109 * x16 * x47 - 33 * x11 * x113 * x118 - 160 * x111
        - 80 * x114 - 44 * x117 - 16 * x119 * x14)
    )
    out[..., 25] = -x125 * x80 * (288 * x116 + 5 * x119 + 405 * x121 + 32 * x123 - 90 * x11 * x40)
    out[..., 26] = 5 * x44 * x85 * (x41 + 25 * x43 + 24 * x48) / 384
    out[..., 27] = x130 * x97 * (omega_1 - x28) * (x129 - x127 - x128)
    out[..., 28] = x102 * x44 * (x134 - x131 - x132 - x133)
    out[..., 29] = -1 / 8 * x104 * x31 * x51 * (omega_2 * x122 + x124 - x48) / x17
    out[..., 30] = -x107 * x44 * (x131 + x132 + x133 + x134)
    out[..., 31] = x108 * x130 * (omega_1 + x28) * (x127 + x128 + x129)
    out[..., 32] = omega_1
    out[..., 33] = omega_2 + 1 / 2 * sigma
    out[..., 34] = sigma + x94


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
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
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

    Where nu = 2*omega_2 + sigma lies on an edge of `boundaries`.

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
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
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
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
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
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
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
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
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
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
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
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
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
        Detuning, nu = 2*omega_2 + sigma, rad/s, real.
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
