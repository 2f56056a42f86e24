# Emitted by mmsgen 0.1.0 from derivations/van_der_pol_forced.py: change that, not this file.
# Made from sha256 5b8a24a0083d047852725c6059f1fa08d0f628e85a07afaec9a484d0c384f3a1
# Operations for each point: slow_flow 134, coefficients 123, backbone 107, motion 508
"""van_der_pol_forced: no resonance, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of u. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: -Omega + 3*omega_0, -Omega + omega_0.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 4
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._flow import Flow
from .._initial import initial_at
from .._motion import Motion, response_at
from .._nonlinear import backbone_at, equilibria_at, jacobian_at, response_along, stability_at
from .._one_amplitude import equilibria_of_one
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
RELATIONS: tuple[str, ...] = ()

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "omega_0": ("positive", "rad/s", "natural frequency"),
    "Omega": ("positive", "rad/s", "frequency of the force"),
    "mu": ("positive", "1/s", "strength of the self-excitation, which turns at 1 m"),
    "K": ("positive", "m/s^2", "amplitude of the force over the mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    1,
    (
        (0, (1, 0, 0)), (0, (2, 1, 0)), (0, (3, 2, 0)),
    ),
    ((1,),),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    1,
    (
        (0, 0, (0, 0, 0), (1,)), (0, 0, (1, 0, 0), (0,)), (1, 0, (0, 0, 0), (1,)),
        (1, 0, (0, 0, 0), (3,)), (1, 0, (1, 0, 0), (-2,)), (1, 0, (1, 0, 0), (2,)),
        (1, 0, (1, 1, 0), (1,)), (1, 0, (2, 0, 0), (-1,)), (1, 0, (2, 0, 0), (1,)),
        (1, 0, (3, 0, 0), (0,)), (2, 0, (0, 0, 0), (1,)), (2, 0, (0, 0, 0), (3,)),
        (2, 0, (0, 0, 0), (5,)), (2, 0, (1, 0, 0), (-4,)), (2, 0, (1, 0, 0), (-2,)),
        (2, 0, (1, 0, 0), (2,)), (2, 0, (1, 0, 0), (4,)), (2, 0, (1, 1, 0), (1,)),
        (2, 0, (1, 1, 0), (3,)), (2, 0, (2, 0, 0), (-3,)), (2, 0, (2, 0, 0), (-1,)),
        (2, 0, (2, 0, 0), (1,)), (2, 0, (2, 0, 0), (3,)), (2, 0, (2, 1, 0), (-2,)),
        (2, 0, (2, 1, 0), (2,)), (2, 0, (2, 2, 0), (1,)), (2, 0, (3, 0, 0), (-2,)),
        (2, 0, (3, 0, 0), (0,)), (2, 0, (3, 0, 0), (2,)), (2, 0, (3, 1, 0), (-1,)),
        (2, 0, (3, 1, 0), (1,)), (2, 0, (4, 0, 0), (-1,)), (2, 0, (4, 0, 0), (1,)),
        (2, 0, (4, 1, 0), (0,)), (2, 0, (5, 0, 0), (0,)),
    ),
    1,
)


def _slow_flow(out, A_u, omega_0, Omega, mu, K):
    # Intermediates
    x0 = 1 / omega_0
    x1 = np.conj(A_u)
    x2 = Omega + 3 * omega_0
    x3 = 3 * omega_0 - Omega
    x4 = Omega * Omega
    x5 = x4 * x4
    x6 = K * K
    x7 = x5 * x6
    x8 = omega_0 * omega_0
    x9 = 24 * x8
    x10 = 1j * mu
    x11 = mu * x0
    x12 = Omega + omega_0
    x13 = x12 * x12
    x14 = x12 * x13
    x15 = omega_0 - Omega
    x16 = x15 * x15
    x17 = x15 * x16
    x18 = x5 * x5
    x19 = x8 * x8
    x20 = x19 * x19
    x21 = x19 * x8
    x22 = x4 * x5
    x23 = x6 * x6
    x24 = x13 * x13
    x25 = x12 * x24
    x26 = x16 * x16
    x27 = x15 * x26
    x28 = x18 * x4
    x29 = x20 * x8
    x30 = x1 * x1
    x31 = A_u * A_u
    x32 = A_u * x31
    x33 = mu * mu
    # Outputs
    out[..., 0] = (
        A_u * x11 * (1 / 4 * omega_0 * x14 * x17 * (2 * x19 + 2 * x5 - 4 * x4 * x8 - x6) - 1 / 64
        * x10 * (40 * x18 * x8 + 24 * x19 * x4 * x6 + 80 * x21 * x5 + 8 * x22 * x6 + 3 * x23 * x8
        + 8 * x29 - 80 * x19 * x22 - 40 * x20 * x4 - 8 * x21 * x6 - 2 * x23 * x4 - 8 * x28 - x7
        * x9)) / (x25 * x27) + x1 * x11 * x31 * (1 / 4 * x10 * (2 * x18 + 60 * x19 * x5 + 18 * x20
        + 14 * x4 * x6 * x8 - 21 * x19 * x6 - 56 * x21 * x4 - x22 * x9 - x7) - 1 / 2 * omega_0 * x14
        * x17 * x2 * x3) / (x14 * x17 * x2 * x3) - 7 / 16 * 1j * x0 * x30 * x32 * x33
    )


def _coefficients(out, omega_0, Omega, mu, K):
    # Intermediates
    x0 = K * K
    x1 = Omega * Omega
    x2 = x1 * x1
    x3 = x0 * x2
    x4 = omega_0 * omega_0
    x5 = 24 * x4
    x6 = 1j * mu
    x7 = 1 / omega_0
    x8 = mu * x7
    x9 = Omega + omega_0
    x10 = x9 * x9
    x11 = x10 * x9
    x12 = omega_0 - Omega
    x13 = x12 * x12
    x14 = x12 * x13
    x15 = x4 * x4
    x16 = x1 * x2
    x17 = x15 * x4
    x18 = x0 * x0
    x19 = x15 * x15
    x20 = x2 * x2
    x21 = x10 * x10
    x22 = x21 * x9
    x23 = x13 * x13
    x24 = x12 * x23
    x25 = x1 * x20
    x26 = x19 * x4
    x27 = Omega + 3 * omega_0
    x28 = 3 * omega_0 - Omega
    x29 = mu * mu
    # Outputs
    out[..., 0] = (
        x8 * (1 / 4 * omega_0 * x11 * x14 * (2 * x15 + 2 * x2 - x0 - 4 * x1 * x4) - 1 / 64 * x6
        * (24 * x0 * x1 * x15 + 8 * x0 * x16 + 80 * x17 * x2 + 3 * x18 * x4 + 40 * x20 * x4 + 8
        * x26 - 8 * x0 * x17 - 2 * x1 * x18 - 40 * x1 * x19 - 80 * x15 * x16 - 8 * x25 - x3 * x5))
        / (x22 * x24)
    )
    out[..., 1] = (
        x8 * (1 / 4 * x6 * (14 * x0 * x1 * x4 + 60 * x15 * x2 + 18 * x19 + 2 * x20 - 21 * x0 * x15
        - 56 * x1 * x17 - x16 * x5 - x3) - 1 / 2 * omega_0 * x11 * x14 * x27 * x28) / (x11 * x14
        * x27 * x28)
    )
    out[..., 2] = -7 / 16 * 1j * x29 * x7


def _backbone(a_u, omega_0, Omega, mu, K):
    # Intermediates
    x0 = 1 / omega_0
    x1 = mu * mu
    x2 = x0 * x1
    x3 = Omega * Omega
    x4 = x3 * x3
    x5 = K * K
    x6 = x4 * x5
    x7 = omega_0 * omega_0
    x8 = 24 * x7
    x9 = x4 * x4
    x10 = x7 * x7
    x11 = x10 * x10
    x12 = x10 * x7
    x13 = x3 * x4
    x14 = x5 * x5
    x15 = a_u * a_u
    x16 = x15 * x15
    x17 = Omega + omega_0
    x18 = x17 * x17
    x19 = x18 * x18
    x20 = x17 * x19
    x21 = omega_0 - Omega
    x22 = x21 * x21
    x23 = x22 * x22
    x24 = x21 * x23
    x25 = x3 * x9
    x26 = x11 * x7
    x27 = x17 * x18
    x28 = x21 * x22
    # Outputs
    rate = (
        1 / 16 * x0 * x1 * x15 * (60 * x10 * x4 + 18 * x11 + 14 * x3 * x5 * x7 + 2 * x9
        - 21 * x10 * x5 - 56 * x12 * x3 - x13 * x8 - x6) / (x27 * x28 * (3 * omega_0 - Omega)
        * (Omega + 3 * omega_0)) - 7 / 256 * x16 * x2 - 1 / 64 * x2 * (24 * x10 * x3 * x5 + 80 * x12
        * x4 + 8 * x13 * x5 + 3 * x14 * x7 + 8 * x26 + 40 * x7 * x9 - 80 * x10 * x13 - 40 * x11 * x3
        - 8 * x12 * x5 - 2 * x14 * x3 - 8 * x25 - x6 * x8) / (x20 * x24)
    )
    return rate


def _motion(out, omega_0, Omega, mu, K):
    # Intermediates
    x0 = -omega_0
    x1 = -Omega - x0
    x2 = 1 / x1
    x3 = Omega + omega_0
    x4 = K / x3
    x5 = x3 * x3
    x6 = x5 * x5
    x7 = 1 / x6
    x8 = x1 * x1
    x9 = x8 * x8
    x10 = 1 / x9
    x11 = Omega * Omega
    x12 = 2 * x11
    x13 = omega_0 * omega_0
    x14 = 2 * x13
    x15 = 1j * mu
    x16 = 1 / 4 * Omega * x15
    x17 = x1 * x8
    x18 = 1 / x17
    x19 = x3 * x5
    x20 = 1 / x19
    x21 = x18 * x20
    x22 = 3 * Omega
    x23 = -x0 - x22
    x24 = 1 / x23
    x25 = omega_0 + x22
    x26 = 1 / x25
    x27 = x24 * x26
    x28 = K * K
    x29 = K * x28
    x30 = 1 / x5
    x31 = 2 * Omega
    x32 = -x0 - x31
    x33 = x18 * x28
    x34 = 1 / Omega
    x35 = 1 / 8 * x34
    x36 = omega_0 + x31
    x37 = 1 / x8
    x38 = x15 * x37
    x39 = x20 * x28
    x40 = K * x30
    x41 = -3 * omega_0
    x42 = -Omega - x41
    x43 = 1 / x42
    x44 = -2 * omega_0
    x45 = -Omega - x44
    x46 = 3 * omega_0
    x47 = Omega + x46
    x48 = 1 / x47
    x49 = 2 * omega_0
    x50 = Omega + x49
    x51 = 1 / omega_0
    x52 = 1 / 4 * x51
    x53 = x11 * x11
    x54 = x28 * x53
    x55 = mu * mu
    x56 = K * x55
    x57 = x11 * x27
    x58 = x11 * x53
    x59 = x13 * x13
    x60 = x13 * x59
    x61 = x28 * x28
    x62 = x59 * x59
    x63 = x53 * x53
    x64 = x17 * x9
    x65 = x19 * x6
    x66 = x11 * x63
    x67 = x13 * x62
    x68 = x5 * x6
    x69 = 1 / x68
    x70 = 8 * x60
    x71 = x11 * x28
    x72 = x13 * x28
    x73 = x11 * x59
    x74 = x13 * x53
    x75 = x25 * x25
    x76 = 1 / x75
    x77 = x23 * x23
    x78 = x29 / x77
    x79 = x76 * x78
    x80 = x8 * x9
    x81 = x55 / x80
    x82 = 5 * Omega
    x83 = x3 * x6
    x84 = 1 / x83
    x85 = x1 * x9
    x86 = 1 / x85
    x87 = x84 * x86
    x88 = K * x61
    x89 = 4 * Omega
    x90 = omega_0 * x11
    x91 = 17 * x90
    x92 = Omega * x11
    x93 = 26 * x92 - Omega * x14
    x94 = x55 * x7
    x95 = x27 * x86
    x96 = 1 / x11
    x97 = 1 / 256 * x61 * x96
    x98 = omega_0 * x13
    x99 = Omega * x53
    x100 = 152 * x98 * x99
    x101 = 8 * Omega
    x102 = x59 * x98
    x103 = x101 * x102
    x104 = x53 * x92
    x105 = 72 * omega_0 * x104
    x106 = omega_0 * x59
    x107 = 88 * x106 * x92
    x108 = omega_0 * x92
    x109 = 20 * x108 * x28
    x110 = x28 * x98
    x111 = x110 * x89
    x112 = x11 * x60
    x113 = x13 * x58
    x114 = (
        40 * x112 + 360 * x113 + x28 * x59 + 49 * x54 - 18 * x11 * x13 * x28 - 236 * x53 * x59
        - 2 * x62 - 162 * x63
    )
    x115 = x27 * x84
    x116 = x28 * x34
    x117 = 1 / 32 * x116
    x118 = x10 * x55
    x119 = 38 * x53
    x120 = x11 * x13
    x121 = 15 * x120
    x122 = -x121
    x123 = 107 * x108
    x124 = Omega * x98
    x125 = 11 * x124
    x126 = -3 * x59
    x127 = x119 + 29 * x120 + x126
    x128 = x34 * x55 / 24
    x129 = x42 * x42
    x130 = 1 / x129
    x131 = 2 * x28 * x92
    x132 = 88 * x13 * x99
    x133 = 16 * omega_0 * x58 + omega_0 * x71 + 112 * x106 * x11 + 18 * x110 - 128 * x53 * x98
    x134 = x20 * x48 * x56
    x135 = x47 * x47
    x136 = 1 / x135
    x137 = x43 * x56
    x138 = x137 * x18
    x139 = 85 * x108
    x140 = 18 * x124
    x141 = x121 + x126 + 29 * x53
    x142 = 1 / 16 * x96
    x143 = x118 * x43
    x144 = x48 * x94
    x145 = x21 * x48
    x146 = -6 * x98
    x147 = Omega * x13
    x148 = 49 * x147 + x92
    x149 = 1 / 64 * x116 * x51
    x150 = x55 / x13
    x151 = 1 / 32 * x150
    x152 = 6 * x98
    x153 = 14 * x90
    x154 = 15 * x147 + x92
    x155 = x30 * x52
    x156 = x37 * x52
    x157 = omega_0 * x101
    x158 = x11 + 11 * x13
    # Outputs
    out[..., 0] = x2 * x4
    out[..., 1] = 2
    out[..., 2] = K * x10 * x16 * x7 * (2 * x13 - K - x12) * (K + x14 - x12)
    out[..., 3] = -x16 * x21 * x27 * x29
    out[..., 4] = -x15 * x30 * x32 * x33 * x35
    out[..., 5] = x35 * x36 * x38 * x39
    out[..., 6] = -x31 * x38 * x40
    out[..., 7] = x38 * x4 * x43 * x45
    out[..., 8] = x15 * x2 * x40 * x48 * x50
    out[..., 9] = x15 * x52
    out[..., 10] = (
        -1 / 8 * x56 * x57 * (44 * x11 * x28 * x59 + x13 * x61 + 296 * x13 * x63 + 36 * x28 * x58
        + 336 * x53 * x60 + 8 * x67 - 5 * x11 * x61 - 104 * x11 * x62 - 76 * x13 * x54
        - 4 * x28 * x60 - 464 * x58 * x59 - 72 * x66) / (x64 * x65)
    )
    out[..., 11] = (
        3 / 16 * x11 * x69 * x79 * x81 * (x70 + 11 * x71 + 88 * x74 - 40 * x58 - 3 * x72 - 56 * x73)
    )
    out[..., 12] = -5 / 16 * x55 * x57 * x87 * x88 / ((omega_0 + x82) * (-x0 - x82))
    out[..., 13] = -x94 * x95 * x97 * (-x0 - x89) * (x93 + x98 - x91) / x32
    out[..., 14] = -x115 * x117 * x81 * (x100 + x103 + x109 - x105 - x107 - x111 - x114)
    out[..., 15] = x117 * x55 * x69 * x95 * (x105 + x107 + x111 - x100 - x103 - x109 - x114)
    out[..., 16] = -x115 * x118 * x97 * (omega_0 + x89) * (x98 - x91 - x93) / x36
    out[..., 17] = -1 / 4 * x56 * x87 * (x12 * x28 + x70 + 24 * x74 - 8 * x58 - 5 * x72 - 24 * x73)
    out[..., 18] = 3 / 4 * x118 * x7 * x79 * (x119 + x122 + x59)
    out[..., 19] = x128 * x20 * x26 * x43 * x78 * x86 * (-x22 - x44) * (x123 - x125 - x127)
    out[..., 20] = (
        -x10 * x130 * x134 * x35 * (39 * Omega * x13 * x28 + 24 * Omega * x60 + 8 * x104
        + 56 * x59 * x92 - x131 - x132 - x133)
    )
    out[..., 21] = (
        -x136 * x138 * x35 * x7 * (24 * Omega * x60 + 39 * Omega * x72 + 8 * x104 + x133
        + 56 * x59 * x92 - x131 - x132)
    )
    out[..., 22] = -x128 * x18 * x24 * x29 * x48 * x76 * x84 * (x22 + x49) * (x125 - x123 - x127)
    out[..., 23] = -x142 * x143 * x39 * (x139 - x140 - x141)
    out[..., 24] = -x142 * x144 * x33 * (x140 - x139 - x141)
    out[..., 25] = 2 * x137 * x145 * (x122 + 2 * x53 + 9 * x59)
    out[..., 26] = x143 * x149 * x30 * (-x31 - x41) * (24 * omega_0 * x11 - x146 - x148) / x45
    out[..., 27] = (
        -x145 * x151 * x43 * (135 * x28 * x59 + 60 * x53 * x59 + 18 * x62 + 2 * x63 - 38 * x11 * x72
        - 56 * x112 - 24 * x113 - x54)
    )
    out[..., 28] = -x144 * x149 * x37 * (x31 + x46) * (x148 + x152 + 24 * x90) / x50
    out[..., 29] = -x138 * x155 * (x152 + x154 - x153)
    out[..., 30] = -x134 * x156 * (-x146 - x153 - x154)
    out[..., 31] = (
        -x130 * x156 * x4 * x55 * (4 * omega_0 - Omega) * (x158 - x157) / (5 * omega_0 - Omega)
    )
    out[..., 32] = (
        -x136 * x155 * x2 * x56 * (Omega + 4 * omega_0) * (x157 + x158) / (Omega + 5 * omega_0)
    )
    out[..., 33] = -x151
    out[..., 34] = -5 * x150 / 96
    out[..., 35] = omega_0
    out[..., 36] = Omega


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, Omega: ArrayLike, mu: ArrayLike, K: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the force, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, Omega=Omega, mu=mu, K=K)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))


def equilibria(
    *, omega_0: ArrayLike, Omega: ArrayLike, mu: ArrayLike, K: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN. B_j exp(i k_j θ) moves along a circle of
    further ones for k = (1,); of each circle one point is given, and the rate at which it drifts,
    B_j exp(i k_j ρ t).

    Parameters
    ----------
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the force, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Equilibria
        The arrays amplitudes (..., count, 1), drift (..., count, 1) in rad/s and growth (...,
        count) in 1/s, which is negative where an equilibrium is stable. With gradient also name ->
        derivatives of amplitudes, drift and growth, NaN where equilibria meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, Omega=Omega, mu=mu, K=K)
    return equilibria_at(
        equilibria_of_one,
        _FLOW,
        _coefficients,
        arguments,
        ("omega_0", "Omega", "mu", "K") if gradient else (),
    )


def frequency_response(
    *, omega_0: ArrayLike, Omega: ArrayLike, mu: ArrayLike, K: ArrayLike, over: str = "omega_0",
    gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the force, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, Omega=Omega, mu=mu, K=K)
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("omega_0", "Omega", "mu", "K"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, omega_0: ArrayLike, Omega: ArrayLike, mu: ArrayLike, K: ArrayLike,
    gradient: bool = False,
) -> Any:
    """The shift of the frequency on the backbone curve.

    Where the conservative part of the slow flow that no phase enters is at rest; free motions
    without damping lie on it, and the responses of weakly damped ones close by.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the force, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        In rad/s, float64; with gradient this and name -> derivative.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, Omega=Omega, mu=mu, K=K)
    return backbone_at(
        _backbone,
        amplitude,
        arguments,
        ("omega_0", "Omega", "mu", "K") if gradient else (),
    )


def jacobian(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, Omega: ArrayLike, mu: ArrayLike, K: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`, turned along its symmetries so that the amplitudes given drift as
    little as they can; an equilibrium then is at rest.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the force, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2, 2), in 1/s, rows and columns u_1, v_1, u_2, …; with gradient this and name ->
        derivatives, the amplitudes fixed.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, Omega=Omega, mu=mu, K=K)
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("omega_0", "Omega", "mu", "K") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, Omega: ArrayLike, mu: ArrayLike, K: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t). Each symmetry that moves the point has
    a zero, which is left out.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the force, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    complex128
        Shape (..., 2), in 1/s; NaN at the end for those that are left out; with gradient this and
        name -> derivatives, the amplitudes fixed; NaN where eigenvalues meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, Omega=Omega, mu=mu, K=K)
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("omega_0", "Omega", "mu", "K") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, omega_0: ArrayLike, Omega: ArrayLike, mu: ArrayLike,
    K: ArrayLike, order: int | None = None, drift: ArrayLike | None = None, gradient: bool = False,
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
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the force, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
    drift : array_like, optional
        Of an equilibrium that drifts, shape (..., 1), rad/s: as `equilibria` gives it.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 1), in the order u; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, Omega=Omega, mu=mu, K=K)
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        drift=drift,
        slow=(_FLOW, _coefficients, 4),
        names=("omega_0", "Omega", "mu", "K") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, omega_0: ArrayLike, Omega: ArrayLike, mu: ArrayLike,
    K: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at t = 0 of the motion with given coordinates and velocities there.

    The solution of response(0, amplitudes) = q, and of its derivative along slow_flow = v, that
    goes over into that of order zero as the small parameters go to zero.

    Parameters
    ----------
    q : array_like
        Coordinates at t = 0, shape (..., 1), in the order of COORDINATES.
    v : array_like
        Velocities at t = 0, shape (..., 1), per second.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    Omega : array_like
        Frequency of the force, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128; NaN where there is none near that of order zero, as far outside
        of the scaling, or where a harmonic resonates itself.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, Omega=Omega, mu=mu, K=K)
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 4, False))
