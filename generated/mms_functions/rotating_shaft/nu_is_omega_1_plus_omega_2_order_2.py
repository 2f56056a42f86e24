# Emitted by mmsgen 0.1.0 from derivations/rotating_shaft.py: change that, not this file.
# Made from sha256 1c9d5183ddcb1cb5b53488b2a9d288f9475282d1736cd90d10000b5235c5b5d8
# Operations for each point: growth_rate 126, boundaries 120, resonance 1, slow_flow_matrix 68,
# characteristic_coefficients 147, slow_flow 79, motion 622, leading 9
"""rotating_shaft: nu = omega_1 + omega_2 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of eta_1, eta_2. Results are written at ε = 1.

It can be unstable: the discriminant of Gamma**2 - I*Gamma*sigma -
Phi_alpha_1**2*Phi_alpha_2**2*kappa**2/(16*omega_1*omega_2) is positive in an interval of the
detuning.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: omega_1 - omega_2.

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
RELATIONS: tuple[str, ...] = ("nu = omega_1 + omega_2 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("eta_1", "eta_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, nu = omega_1 + omega_2 + sigma"),
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
VARIABLES: tuple[str, ...] = ("A_eta_1", "conj(A_eta_2)")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    2,
    (
        ((0, 0), (1, 1)),
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
    x4 = kappa * kappa
    x5 = x3 * x4
    x6 = omega_1 * omega_1
    x7 = 1 / x6
    x8 = 3 * omega_1 + omega_2
    x9 = 1 / 8 * x7
    x10 = omega_1 + 3 * omega_2
    x11 = omega_1 + omega_2
    x12 = 2 * Phi_alpha_2
    x13 = omega_1 - omega_2
    x14 = sigma * sigma
    x15 = omega_2 * omega_2
    x16 = x1 * x1
    x17 = x2 * x2
    x18 = x6 * x6
    x19 = x15 * x15
    x20 = x8 * x8
    x21 = x10 * x10
    x22 = x11 * x11
    x23 = x13 * x13
    x24 = x4 * x4
    x25 = omega_1 * x19
    x26 = omega_2 * x18
    x27 = 3 * x3
    x28 = omega_2 * x15
    x29 = x28 * x6
    x30 = omega_1 * x6
    x31 = x15 * x30
    x32 = 10 * x3
    x33 = omega_2 * x19
    x34 = omega_1 * x18
    x35 = (
        12 * x16 * x25 + 16 * x16 * x29 + 4 * x16 * x31 + x25 * x32 + x27 * x29 + x27 * x33
        - 12 * x17 * x26 - 4 * x17 * x29 - 16 * x17 * x31 - x26 * x32 - x27 * x31 - x27 * x34
    )
    x36 = x35 * x35
    # Outputs
    discriminant_1 = (
        sigma * x4 * (1 / 8 * x1 * x2 * x7 / x11
        - x0 * x2 * x9 * (Phi_alpha_1 - x12) * (Phi_alpha_1 + x12) - x16 * x9 / x8
        - x9 * (Phi_alpha_1 - Phi_alpha_2) * (Phi_alpha_1 + Phi_alpha_2) * (x1 + x2) / x13
        - 9 / 8 * x17 * x7 / x10) + 1 / 16 * x14 * x5 * x7 / x15 + 1 / 4 * x0 * x5 / omega_1 - x14
        - 1 / 256 * x24 * x36 / (x18 * x19 * x20 * x21 * x22 * x23)
    )
    return growing(discriminant_1)


def _boundaries(kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = 1 / omega_2
    x1 = Phi_alpha_1 * Phi_alpha_1
    x2 = Phi_alpha_2 * Phi_alpha_2
    x3 = x1 * x2
    x4 = kappa * kappa
    x5 = x3 * x4
    x6 = omega_1 * omega_1
    x7 = x6 * x6
    x8 = omega_2 * omega_2
    x9 = x8 * x8
    x10 = omega_1 + 3 * omega_2
    x11 = x10 * x10
    x12 = 3 * omega_1 + omega_2
    x13 = x12 * x12
    x14 = omega_1 + omega_2
    x15 = x14 * x14
    x16 = omega_1 - omega_2
    x17 = x16 * x16
    x18 = x4 * x4
    x19 = omega_1 * x9
    x20 = omega_2 * x7
    x21 = 3 * x3
    x22 = omega_2 * x8
    x23 = x22 * x6
    x24 = omega_1 * x6
    x25 = x24 * x8
    x26 = 10 * x3
    x27 = x1 * x1
    x28 = x2 * x2
    x29 = omega_2 * x9
    x30 = omega_1 * x7
    x31 = (
        x19 * x26 + 12 * x19 * x27 + x21 * x23 + x21 * x29 + 16 * x23 * x27 + 4 * x25 * x27
        - x20 * x26 - 12 * x20 * x28 - x21 * x25 - x21 * x30 - 4 * x23 * x28 - 16 * x25 * x28
    )
    x32 = x31 * x31
    x33 = 1 / x6
    x34 = 1 / 8 * x33
    x35 = 2 * Phi_alpha_2
    # Outputs
    p0 = 1 / 4 * x0 * x5 / omega_1 - 1 / 256 * x18 * x32 / (x11 * x13 * x15 * x17 * x7 * x9)
    p1 = (
        x4 * (1 / 8 * x1 * x2 * x33 / x14
        - x0 * x2 * x34 * (Phi_alpha_1 - x35) * (Phi_alpha_1 + x35)
        - x34 * (Phi_alpha_1 - Phi_alpha_2) * (Phi_alpha_1 + Phi_alpha_2) * (x1 + x2) / x16
        - x27 * x34 / x12 - 9 / 8 * x28 * x33 / x10)
    )
    p2 = 1 / 16 * x33 * x5 / x8 - 1
    return zone((p0, p1, p2))


def _resonance(kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    centre = omega_1 + omega_2
    return centre, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2


def _slow_flow_matrix(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = 1 / omega_2
    x3 = 1 / 16 / (omega_1 - omega_2)
    x4 = Phi_alpha_1 * Phi_alpha_1
    x5 = x4 * x4
    x6 = x1 * x5
    x7 = 1 / (omega_1 + omega_2)
    x8 = kappa * kappa
    x9 = Phi_alpha_2 * Phi_alpha_2
    x10 = 1 / omega_1
    x11 = Phi_alpha_1 * Phi_alpha_2 * kappa
    x12 = 1 / 4 * x11
    x13 = omega_2 * omega_2
    x14 = 1 / x13
    x15 = 1 / 32 * x14 * x4 * x9
    x16 = x9 * x9
    # Outputs
    out[..., 0, 0].imag = (
        x8 * (1 / 32 * x1 * x2 * x4 * x9 + 1 / 32 * x1 * x4 * x7 * x9 - x3 * x6
        - 1 / 16 * x6 / (3 * omega_1 + omega_2))
    )
    out[..., 0, 1].imag = x10 * x12 - 1 / 8 * sigma * x1 * x11
    out[..., 1, 0].imag = 1 / 8 * Phi_alpha_1 * Phi_alpha_2 * kappa * sigma * x14 - x12 * x2
    out[..., 1, 1].imag = (
        sigma + x8 * (1 / 16 * x14 * x16 / (omega_1 + 3 * omega_2) - x10 * x15 - x14 * x16 * x3
        - x15 * x7)
    )


def _characteristic_coefficients(out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = omega_1 * x0
    x2 = omega_2 * x1
    x3 = Phi_alpha_1 * Phi_alpha_1
    x4 = 3 / 16 * x3
    x5 = Phi_alpha_2 * Phi_alpha_2
    x6 = omega_2 * omega_2
    x7 = x6 * x6
    x8 = x5 * x7
    x9 = x0 * x6
    x10 = 1 / 4 * x9
    x11 = omega_2 * x6
    x12 = x11 * x5
    x13 = omega_1 * x12
    x14 = 1 / 4 * x3
    x15 = x2 * x5
    x16 = x5 * x9
    x17 = 1 / (3 * omega_1 + omega_2)
    x18 = x17 / (omega_1 + 3 * omega_2)
    x19 = omega_1 - omega_2
    x20 = 1 / x19
    x21 = 1 / x0
    x22 = 1 / x6
    x23 = x21 * x22
    x24 = kappa * kappa
    x25 = x3 * x3
    x26 = x5 * x5
    x27 = x0 * x0
    x28 = x24 * x3 * x5
    x29 = omega_1 + omega_2
    x30 = 3 * x5
    x31 = x11 * x3
    x32 = 8 * omega_1
    x33 = 8 * x3
    x34 = omega_1 * x6
    x35 = omega_2 * x0
    x36 = x32 * x6
    x37 = x35 * x5
    x38 = sigma * sigma
    x39 = x19 * x19
    x40 = x29 * x29
    x41 = x24 * x24
    # Outputs
    c1_1 = (
        1j * (x18 * x20 * x23 * x24 * (3 / 4 * omega_1 * x11 * x25 + x10 * x25 + x10 * x26
        + x13 * x14 + x14 * x15 + 3 / 4 * x2 * x26 + x27 * x4 * x5 + x4 * x8 - 7 / 8 * x16 * x3)
        - sigma)
    )
    c1_0 = (
        1 / 32 * sigma * x17 * x20 * x21 * x22 * x24 * x3 * (x13 + x15 + x27 * x30 + x31 * x32
        + x33 * x9 + x8 - 6 * x16) / x29 - 1 / 64 * x23 * x28 * x38 - 1 / 1024 * x18 * x3 * x41 * x5
        * (2 * x1 * x3 + 5 * x3 * x35 + x36 * x5 + 8 * x37 - 4 * x3 * x34 - 3 * x31) * (2 * x12 + x3
        * x36 + x33 * x35 + 5 * x34 * x5 - x1 * x30 - 4 * x37) / (x1 * x11 * x39 * x40)
        - 1 / 16 * x28 / (omega_1 * omega_2)
    )
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_eta_1, A_eta_2, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = -sigma
    x3 = 1 / 8 * 1j * Phi_alpha_1 * Phi_alpha_2 * kappa
    x4 = kappa * kappa
    x5 = 1j * x4
    x6 = 1 / 16 * x5
    x7 = x6 / (omega_1 - omega_2)
    x8 = Phi_alpha_1 * Phi_alpha_1
    x9 = x8 * x8
    x10 = x1 * x9
    x11 = 1 / (omega_1 + omega_2)
    x12 = Phi_alpha_2 * Phi_alpha_2
    x13 = omega_2 * omega_2
    x14 = 1 / x13
    x15 = 1 / 32 * x12 * x14 * x5 * x8
    x16 = x12 * x12
    x17 = x14 * x16
    # Outputs
    out[..., 0] = (
        A_eta_1 * (1 / 32 * 1j * x1 * x11 * x12 * x4 * x8
        + 1 / 32 * 1j * x1 * x12 * x4 * x8 / omega_2 - x10 * x6 / (3 * omega_1 + omega_2)
        - x10 * x7) + x1 * x3 * (2 * omega_1 + x2) * np.conj(A_eta_2)
    )
    out[..., 1] = (
        A_eta_2 * (x11 * x15 + x17 * x7 + x15 / omega_1 - x17 * x6 / (omega_1 + 3 * omega_2))
        + x14 * x3 * (2 * omega_2 + x2) * np.conj(A_eta_1) - 1j * A_eta_2 * sigma
    )


def _motion(
    out, sigma, kappa, omega_1, omega_2, Phi_alpha_1, Phi_alpha_2, Theta_beta_1, Theta_beta_2,
):
    # Intermediates
    x0 = 2 * Phi_alpha_2
    x1 = 2 * Phi_alpha_1
    x2 = 2 * 1j
    x3 = omega_1 - omega_2
    x4 = 1 / x3
    x5 = omega_1 + omega_2
    x6 = kappa / x5
    x7 = x4 * x6
    x8 = Phi_alpha_2 * Phi_alpha_2
    x9 = Phi_alpha_2 * x8
    x10 = 1 / 4 * x6
    x11 = 1 / omega_2
    x12 = 3 * omega_2
    x13 = omega_1 + x12
    x14 = 1 / x13
    x15 = x11 * x14
    x16 = Phi_alpha_1 * Phi_alpha_1
    x17 = omega_1 * x16
    x18 = omega_2 * x8
    x19 = x12 * x16 + 4 * x18
    x20 = Phi_alpha_2 * (x17 + x19)
    x21 = Phi_alpha_1 * x16
    x22 = 1 / omega_1
    x23 = 3 * omega_1
    x24 = omega_2 + x23
    x25 = 1 / x24
    x26 = x22 * x25
    x27 = 4 * x17 + x23 * x8
    x28 = Phi_alpha_1 * (x18 + x27)
    x29 = omega_1 * omega_1
    x30 = 1 / x29
    x31 = Phi_alpha_1 * Theta_beta_1
    x32 = omega_2 * omega_2
    x33 = omega_2 * x32
    x34 = x31 * x33
    x35 = Theta_beta_2 * x0
    x36 = omega_1 * x29
    x37 = x35 * x36
    x38 = x29 * x31
    x39 = Phi_alpha_2 * x11
    x40 = 1 / 2 * 1j
    x41 = x40 * x7
    x42 = kappa * x40
    x43 = 1j * x10
    x44 = 1 / x32
    x45 = Theta_beta_1 * x1
    x46 = x33 * x45
    x47 = Phi_alpha_2 * Theta_beta_2
    x48 = x36 * x47
    x49 = x32 * x47
    x50 = Phi_alpha_1 * x22
    x51 = omega_2 * x36
    x52 = x16 * x16
    x53 = 16 * x52
    x54 = x16 * x8
    x55 = x32 * x32
    x56 = x54 * x55
    x57 = x29 * x29
    x58 = x54 * x57
    x59 = x29 * x32
    x60 = 4 * x59
    x61 = x33 * x8
    x62 = x17 * x61
    x63 = x16 * x36
    x64 = x18 * x63
    x65 = x16 * x29
    x66 = x32 * x8
    x67 = 13 * x65 * x66
    x68 = x5 * x5
    x69 = 1 / x68
    x70 = Phi_alpha_2 * x69
    x71 = x24 * x24
    x72 = 1 / x71
    x73 = 1 / x36
    x74 = kappa * kappa
    x75 = x73 * x74
    x76 = 1 / 32 * x4
    x77 = x72 * x75 * x76
    x78 = x8 * x8
    x79 = 2 * omega_1
    x80 = x3 * x3
    x81 = x69 / x80
    x82 = kappa * sigma
    x83 = x81 * x82
    x84 = x17 * x32
    x85 = 2 * omega_2
    x86 = 8 * omega_1
    x87 = x18 * x29
    x88 = x22 * x74
    x89 = 1 / 8 * x81
    x90 = omega_1 + x85
    x91 = x16 * x32
    x92 = 1 / 8 * x82
    x93 = x13 * x13
    x94 = 1 / x93
    x95 = x44 * x94
    x96 = x70 * x92 * x95
    x97 = 8 * omega_2
    x98 = x11 * x74
    x99 = x69 / 96
    x100 = x98 * x99
    x101 = x20 / x90
    x102 = omega_1 * x33
    x103 = 16 * x78
    x104 = Phi_alpha_1 * x69
    x105 = 1 / x33
    x106 = x105 * x74
    x107 = x106 * x76 * x94
    x108 = 12 * x8
    x109 = omega_2 + x79
    x110 = x29 * x8
    x111 = x30 * x72
    x112 = x104 * x111 * x92
    x113 = x28 / x109
    x114 = x88 * x99
    x115 = Theta_beta_2 * x9
    x116 = omega_1 * x57
    x117 = x115 * x116
    x118 = omega_2 * x55
    x119 = x118 * x47
    x120 = Theta_beta_1 * x21
    x121 = x120 * x55
    x122 = x31 * x57
    x123 = x122 * x18
    x124 = x47 * x55
    x125 = x124 * x17
    x126 = x29 * x33
    x127 = x120 * x126
    x128 = x32 * x36
    x129 = x120 * x128
    x130 = x115 * x126
    x131 = x115 * x128
    x132 = x38 * x61
    x133 = x31 * x36
    x134 = x133 * x66
    x135 = x33 * x47
    x136 = x135 * x65
    x137 = x49 * x63
    x138 = 1j * x39
    x139 = x118 * x31
    x140 = x116 * x47
    x141 = 1 / 4 * x83
    x142 = 8 * x115
    x143 = x33 * x36
    x144 = 2 * x143
    x145 = x118 * x120
    x146 = x139 * x8
    x147 = omega_1 * x146
    x148 = x31 * x55
    x149 = x47 * x57
    x150 = 8 * x121 * x29 + x142 * x32 * x57
    x151 = 1 / 16 * 1j * x81
    x152 = x32 * x55
    x153 = x29 * x57
    x154 = x32 * x38
    x155 = x29 * x49
    x156 = omega_1 * omega_2
    x157 = 4 * x156
    x158 = 9 * x156
    x159 = x31 * x32
    x160 = x29 * x47
    x161 = x116 * x31 * x8
    x162 = 1j * x50
    # Outputs
    out[..., 0] = x0
    out[..., 1] = x1
    out[..., 2] = Theta_beta_2 * x2
    out[..., 3] = Theta_beta_1 * x2
    out[..., 4] = x7 * x9
    out[..., 5] = x10 * x15 * x20
    out[..., 6] = -x21 * x7
    out[..., 7] = x10 * x26 * x28
    out[..., 8] = -x30 * x39 * x41 * (omega_2 * x38 + x37 - x34)
    out[..., 9] = Theta_beta_2 * x15 * x42 * x8 + x22 * x31 * x39 * x42 - x39 * x43 * (x31 - x35)
    out[..., 10] = x41 * x44 * x50 * (omega_1 * x49 + x46 - x48)
    out[..., 11] = Theta_beta_1 * x16 * x26 * x42 + x11 * x42 * x47 * x50 + x43 * x50 * (x45 - x47)
    out[..., 12] = (
        -x70 * x77 * (32 * x52 * x57 - x51 * x53 - 24 * x51 * x78 - x53 * x59 - x56 - 36 * x57 * x78
        - 30 * x58 - x60 * x78 - 7 * x62 - 13 * x64 - x67)
    )
    out[..., 13] = -x79 * x83 * x9
    out[..., 14] = (
        -Phi_alpha_2 * x15 * x16 * x88 * x89 * (x63 + x65 * x85 + x66 * x86 + 8 * x87
        - 12 * x16 * x33 - 7 * x84)
    )
    out[..., 15] = -x90 * x96 * (6 * omega_2 * x17 + x65 + 16 * x66 + 9 * x91)
    out[..., 16] = x100 * x101 * x94 * (x16 * x97 + 9 * x18 + x27)
    out[..., 17] = (
        -x104 * x107 * (x102 * x103 + 24 * x102 * x52 + x103 * x59 + 36 * x52 * x55 + x52 * x60
        + 30 * x56 + x58 + 13 * x62 + 7 * x64 + x67 - 32 * x55 * x78)
    )
    out[..., 18] = -x21 * x83 * x85
    out[..., 19] = (
        -Phi_alpha_1 * x26 * x8 * x89 * x98 * (x61 + x65 * x97 + x66 * x79 + 8 * x84 - x108 * x36
        - 7 * x87)
    )
    out[..., 20] = -x109 * x112 * (6 * omega_1 * x18 + 9 * x110 + 16 * x65 + x66)
    out[..., 21] = x113 * x114 * x72 * (9 * x17 + x19 + x8 * x86)
    out[..., 22] = (
        x138 * x69 * x77 * (12 * Phi_alpha_2 * Theta_beta_2 * omega_2 * x16 * x57
        + 18 * Phi_alpha_2 * Theta_beta_2 * x116 * x16 + 40 * Theta_beta_1 * omega_2 * x21 * x57
        - 84 * omega_2 * x115 * x57 - 72 * x117 - x119 * x16 - x121 * x86 - 96 * x123 - 7 * x125
        - 24 * x127 - 8 * x129 - 4 * x130 - 32 * x131 - 16 * x132 - 80 * x134 - 15 * x136
        - 7 * x137)
    )
    out[..., 23] = (
        x138 * x141 * x73 * (omega_2 * x122 + x139 + 4 * x140 + 4 * x32 * x48 - x29 * x46)
    )
    out[..., 24] = (
        Phi_alpha_2 * x106 * x14 * x151 * x30 * (10 * omega_1 * x145 + 5 * omega_2 * x140 * x16
        + x117 * x97 + 3 * x119 * x17 + x120 * x144 + 12 * x120 * x152 + 4 * x124 * x65 + x150
        + x153 * x16 * x35 - 16 * x110 * x148 - 8 * x135 * x63 - x142 * x143 - x142 * x29 * x55
        - 16 * x147 - 6 * x149 * x91)
    )
    out[..., 25] = (
        -1j * x22 * x96 * (30 * omega_1 * x34 + 40 * x102 * x47 + x122 + x133 * x97 + 18 * x148
        + 23 * x154 + 32 * x155 + x48 * x97)
    )
    out[..., 26] = (
        1j * x101 * x114 * x95 * (x12 + x79) * (x157 * x31 + x158 * x47 + 8 * x159 + 3 * x160)
    )
    out[..., 27] = (
        x107 * x162 * x69 * (84 * omega_1 * x121 + x115 * x57 * x97 + 7 * x123 + 96 * x125
        + 32 * x127 + 4 * x129 + 8 * x130 + 24 * x131 + 7 * x132 + 15 * x134 + 80 * x136 + 16 * x137
        + 72 * x145 + x161 - omega_1 * x108 * x148 - 40 * omega_1 * x115 * x55 - 18 * x146)
    )
    out[..., 28] = (
        x105 * x141 * x162 * (omega_1 * x124 + 4 * x139 + x140 + 4 * x29 * x34 - x32 * x37)
    )
    out[..., 29] = (
        -Phi_alpha_1 * x151 * x25 * x44 * x75 * (6 * Phi_alpha_1 * Theta_beta_1 * x29 * x55 * x8
        + 8 * Phi_alpha_1 * Theta_beta_1 * x33 * x36 * x8
        + 16 * Phi_alpha_2 * Theta_beta_2 * omega_2 * x116 * x16
        + 16 * Phi_alpha_2 * Theta_beta_2 * x16 * x32 * x57 + 8 * Theta_beta_1 * x21 * x32 * x57
        + 8 * Theta_beta_1 * x21 * x33 * x36 - 10 * omega_2 * x117 - x115 * x144 - 12 * x115 * x153
        - x12 * x161 - 4 * x122 * x66 - x145 * x86 - 5 * x147 - x150 - x152 * x45 * x8)
    )
    out[..., 30] = (
        -1j * x11 * x112 * (30 * omega_2 * x48 + x124 + x135 * x86 + 18 * x149 + 32 * x154
        + 23 * x155 + 40 * x31 * x51 + x34 * x86)
    )
    out[..., 31] = (
        1j * x100 * x111 * x113 * (x23 + x85) * (x157 * x47 + x158 * x31 + 3 * x159 + 8 * x160)
    )
    out[..., 32] = omega_1
    out[..., 33] = omega_2 + sigma
    out[..., 34] = sigma + x5


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
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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

    Where nu = omega_1 + omega_2 + sigma lies on an edge of `boundaries`.

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
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, nu = omega_1 + omega_2 + sigma, rad/s, real.
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
