# Emitted by mmsgen 0.1.0 from derivations/rayleigh_forced.py: change that, not this file.
# Made from sha256 8dca0bd40da18dfc2919b503ae644a3f6e17bd0b570310000aed42a7ca7d4977
# Operations for each point: slow_flow 121, coefficients 110, backbone 96, motion 464
"""rayleigh_forced: no resonance, order 2.

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
    "mu": ("positive", "1/s", "strength of the self-excitation, which turns at 1 m/s"),
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
    x0 = np.conj(A_u)
    x1 = Omega + 3 * omega_0
    x2 = 3 * omega_0 - Omega
    x3 = Omega * Omega
    x4 = K * K
    x5 = x3 * x4
    x6 = 1j * mu
    x7 = omega_0 * omega_0
    x8 = Omega + omega_0
    x9 = x8 * x8
    x10 = x8 * x9
    x11 = omega_0 - Omega
    x12 = x11 * x11
    x13 = x11 * x12
    x14 = x3 * x3
    x15 = x7 * x7
    x16 = x14 * x14
    x17 = x4 * x4
    x18 = x14 * x3
    x19 = x15 * x7
    x20 = x0 * x0
    x21 = A_u * A_u
    x22 = A_u * x21
    x23 = mu * mu
    x24 = omega_0 * x7
    x25 = x9 * x9
    x26 = x25 * x8
    x27 = x12 * x12
    x28 = x11 * x27
    x29 = x16 * x3
    x30 = x15 * x15
    x31 = x30 * x7
    # Outputs
    out[..., 0] = (
        A_u * mu * (1 / 4 * omega_0 * x10 * x13 * (2 * x14 + 2 * x15 - 4 * x3 * x7 - x5) - 1 / 64
        * x6 * (24 * x14 * x15 * x4 + 3 * x14 * x17 * x7 + 80 * x14 * x19 + 8 * x16 * x4 + 40 * x16
        * x7 + 8 * x31 - 80 * x15 * x18 - 2 * x17 * x18 - 24 * x18 * x4 * x7 - 8 * x19 * x5 - 8
        * x29 - 40 * x3 * x30)) / (omega_0 * x26 * x28) + mu * x0 * x21 * x7 * (-omega_0 * x5 * x6
        * (3 * x7 - x3) - 1 / 2 * x1 * x10 * x13 * x2) / (x1 * x10 * x13 * x2)
        + 1 / 16 * 1j * x20 * x22 * x23 * x24
    )


def _coefficients(out, omega_0, Omega, mu, K):
    # Intermediates
    x0 = Omega * Omega
    x1 = K * K
    x2 = x0 * x1
    x3 = 1j * mu
    x4 = Omega + omega_0
    x5 = x4 * x4
    x6 = x4 * x5
    x7 = omega_0 - Omega
    x8 = x7 * x7
    x9 = x7 * x8
    x10 = x0 * x0
    x11 = omega_0 * omega_0
    x12 = x11 * x11
    x13 = x10 * x10
    x14 = x1 * x1
    x15 = x0 * x10
    x16 = x11 * x12
    x17 = x5 * x5
    x18 = x17 * x4
    x19 = x8 * x8
    x20 = x19 * x7
    x21 = x0 * x13
    x22 = x12 * x12
    x23 = x11 * x22
    x24 = Omega + 3 * omega_0
    x25 = 3 * omega_0 - Omega
    x26 = mu * mu
    x27 = omega_0 * x11
    # Outputs
    out[..., 0] = (
        mu * (1 / 4 * omega_0 * x6 * x9 * (2 * x10 + 2 * x12 - 4 * x0 * x11 - x2) - 1 / 64 * x3
        * (24 * x1 * x10 * x12 + 8 * x1 * x13 + 3 * x10 * x11 * x14 + 80 * x10 * x16 + 40 * x11
        * x13 + 8 * x23 - 40 * x0 * x22 - 24 * x1 * x11 * x15 - 80 * x12 * x15 - 2 * x14 * x15 - 8
        * x16 * x2 - 8 * x21)) / (omega_0 * x18 * x20)
    )
    out[..., 1] = (
        mu * x11 * (-omega_0 * x2 * x3 * (3 * x11 - x0) - 1 / 2 * x24 * x25 * x6 * x9) / (x24 * x25
        * x6 * x9)
    )
    out[..., 2] = 1 / 16 * 1j * x26 * x27


def _backbone(a_u, omega_0, Omega, mu, K):
    # Intermediates
    x0 = mu * mu
    x1 = omega_0 * omega_0
    x2 = omega_0 * x1
    x3 = Omega * Omega
    x4 = K * K
    x5 = x3 * x3
    x6 = x5 * x5
    x7 = x4 * x4
    x8 = x3 * x5
    x9 = x1 * x1
    x10 = x1 * x9
    x11 = a_u * a_u
    x12 = x11 * x11
    x13 = Omega + omega_0
    x14 = x13 * x13
    x15 = x14 * x14
    x16 = x13 * x15
    x17 = omega_0 - Omega
    x18 = x17 * x17
    x19 = x18 * x18
    x20 = x17 * x19
    x21 = x3 * x6
    x22 = x9 * x9
    x23 = x1 * x22
    x24 = x13 * x14
    x25 = x17 * x18
    # Outputs
    rate = (
        1 / 256 * x0 * x12 * x2 - 1 / 4 * x0 * x11 * x2 * x3 * x4 * (3 * x1 - x3) / (x24 * x25 * (3
        * omega_0 - Omega) * (Omega + 3 * omega_0)) - 1 / 64 * x0 * (3 * x1 * x5 * x7 + 40 * x1 * x6
        + 80 * x10 * x5 + 8 * x23 + 24 * x4 * x5 * x9 + 8 * x4 * x6 - 24 * x1 * x4 * x8 - 8 * x10
        * x3 * x4 - 8 * x21 - 40 * x22 * x3 - 2 * x7 * x8 - 80 * x8 * x9) / (omega_0 * x16 * x20)
    )
    return rate


def _motion(out, omega_0, Omega, mu, K):
    # Intermediates
    x0 = Omega + omega_0
    x1 = 1 / x0
    x2 = -omega_0
    x3 = -Omega - x2
    x4 = 1 / x3
    x5 = K * Omega
    x6 = Omega * Omega
    x7 = 2 * x6
    x8 = omega_0 * omega_0
    x9 = 2 * x8
    x10 = 1j * mu
    x11 = x10 * x5
    x12 = x3 * x3
    x13 = x12 * x12
    x14 = 1 / x13
    x15 = x0 * x0
    x16 = x15 * x15
    x17 = 1 / x16
    x18 = x14 * x17
    x19 = x0 * x15
    x20 = 1 / x19
    x21 = x12 * x3
    x22 = 1 / x21
    x23 = 3 * Omega
    x24 = -x2 - x23
    x25 = 1 / x24
    x26 = omega_0 + x23
    x27 = 1 / x26
    x28 = x25 * x27
    x29 = Omega * x6
    x30 = K * K
    x31 = K * x30
    x32 = 1 / x15
    x33 = x22 * x32
    x34 = omega_0 * x10
    x35 = Omega * x30
    x36 = 1 / 8 * x34 * x35
    x37 = 1 / x12
    x38 = x20 * x37
    x39 = x11 * x37
    x40 = 3 * omega_0 - Omega
    x41 = 1 / x40
    x42 = Omega + 3 * omega_0
    x43 = 1 / x42
    x44 = x32 * x4
    x45 = x8 * x8
    x46 = x45 * x8
    x47 = x46 * x6
    x48 = 4 * x30
    x49 = x6 * x6
    x50 = x49 * x6
    x51 = x30 * x50
    x52 = mu * mu
    x53 = x28 * x52
    x54 = x49 * x49
    x55 = x30 * x30
    x56 = x45 * x45
    x57 = x16 * x19
    x58 = x13 * x21
    x59 = x54 * x6
    x60 = x56 * x8
    x61 = x15 * x16
    x62 = 1 / x61
    x63 = x12 * x13
    x64 = 1 / x63
    x65 = x30 * x49
    x66 = x45 * x6
    x67 = x49 * x8
    x68 = x6 * x8
    x69 = x31 * x52
    x70 = x24 * x24
    x71 = 1 / x70
    x72 = x26 * x26
    x73 = 1 / x72
    x74 = x71 * x73
    x75 = 5 * Omega
    x76 = x0 * x16
    x77 = 1 / x76
    x78 = x13 * x3
    x79 = 1 / x78
    x80 = x77 * x79
    x81 = K * x55
    x82 = 2 * Omega
    x83 = 17 * omega_0
    x84 = x6 * x83
    x85 = 26 * x29 - Omega * x9
    x86 = omega_0 * x6
    x87 = 1 / 256 * x53 * x55 * x86
    x88 = omega_0 * x8
    x89 = Omega * x49
    x90 = 152 * x88 * x89
    x91 = 8 * Omega
    x92 = x45 * x88
    x93 = x91 * x92
    x94 = x29 * x49
    x95 = 72 * omega_0 * x94
    x96 = omega_0 * x45
    x97 = 88 * x29 * x96
    x98 = 20 * omega_0 * x30 * x89
    x99 = x29 * x88
    x100 = x48 * x99
    x101 = -60 * x45 * x49
    x102 = 24 * x46
    x103 = x50 * x8
    x104 = x30 * x66
    x105 = x101 + x102 * x6 + 56 * x103 + x104 + 9 * x51 - 10 * x30 * x49 * x8 - 18 * x54 - 2 * x56
    x106 = 1 / 32 * x52
    x107 = x106 * x28 * x35
    x108 = 1 / 4 * x68 * x69
    x109 = 38 * x49
    x110 = 107 * omega_0 * x29
    x111 = Omega * x88
    x112 = 11 * x111
    x113 = -3 * x45
    x114 = x109 + x113 + 29 * x68
    x115 = x20 * x41
    x116 = x68 * x69 / 24
    x117 = x40 * x40
    x118 = 1 / x117
    x119 = 8 * x50
    x120 = 88 * x66
    x121 = 33 * x68
    x122 = x121 * x30
    x123 = 2 * omega_0
    x124 = 32 * Omega * x96 + 9 * x111 * x30 + x123 * x29 * x30 - 32 * x99
    x125 = x5 * x52
    x126 = x125 * x43
    x127 = 1 / 8 * omega_0
    x128 = x42 * x42
    x129 = 1 / x128
    x130 = x125 * x41
    x131 = x22 * x43
    x132 = x29 * x83
    x133 = 12 * x111
    x134 = x113 + x121 + x49
    x135 = x14 * x30
    x136 = x52 * x8
    x137 = 1 / 16 * x136
    x138 = x17 * x30
    x139 = -5 * x8
    x140 = x115 * x131
    x141 = Omega * x8
    x142 = 49 * x141 + x29
    x143 = 1 / 64 * x141 * x52
    x144 = omega_0 * x91
    x145 = 5 * x6
    x146 = 1 / 4 * x88
    x147 = x6 + 11 * x8
    x148 = x125 * x146
    # Outputs
    out[..., 0] = K * x1 * x4
    out[..., 1] = 2
    out[..., 2] = 1 / 4 * x11 * x18 * (2 * x8 - x5 - x7) * (x5 + x9 - x7)
    out[..., 3] = x10 * x20 * x22 * x28 * x29 * x31 / 12
    out[..., 4] = x33 * x36
    out[..., 5] = -x36 * x38
    out[..., 6] = -x32 * x39 * x9
    out[..., 7] = x1 * x39 * x41 * x8
    out[..., 8] = -x11 * x43 * x44 * x8
    out[..., 9] = -x34 / 12
    out[..., 10] = (
        -1 / 8 * K * x53 * x6 * (44 * x30 * x45 * x49 + 36 * x30 * x54 + 336 * x46 * x49
        + x49 * x55 * x8 + 296 * x54 * x8 + 8 * x60 - 464 * x45 * x50 - x47 * x48 - 5 * x50 * x55
        - 76 * x51 * x8 - 104 * x56 * x6 - 72 * x59) / (x57 * x58)
    )
    out[..., 11] = (
        -1 / 16 * x49 * x62 * x64 * x69 * x74 * (8 * x46 + 11 * x65 + 88 * x67 - 3 * x30 * x68
        - 40 * x50 - 56 * x66)
    )
    out[..., 12] = -1 / 16 * x50 * x53 * x80 * x81 / ((omega_0 + x75) * (-x2 - x75))
    out[..., 13] = -x17 * x79 * x87 * (x85 + x88 - x84) / (-x2 - x82)
    out[..., 14] = x107 * x64 * x77 * (x90 + x93 + x98 - x100 - x105 - x95 - x97)
    out[..., 15] = -x107 * x62 * x79 * (x100 + x95 + x97 - x105 - x90 - x93 - x98)
    out[..., 16] = -x14 * x77 * x87 * (x88 - x84 - x85) / (omega_0 + x82)
    out[..., 17] = x108 * x80 * (x7 + x8)
    out[..., 18] = -x108 * x18 * x74 * (x109 + x45 - 15 * x68)
    out[..., 19] = -x115 * x116 * x27 * x71 * x79 * (x110 - x112 - x114)
    out[..., 20] = (
        x118 * x126 * x127 * x14 * x20 * (x102 + x124 + 4 * x65 + 72 * x67 - x119 - x120 - x122)
    )
    out[..., 21] = (
        -x127 * x129 * x130 * x17 * x22 * (4 * x30 * x49 + 24 * x46 + 72 * x49 * x8 - x119 - x120
        - x122 - x124)
    )
    out[..., 22] = -x116 * x131 * x25 * x73 * x77 * (x112 - x110 - x114)
    out[..., 23] = x115 * x135 * x137 * (x132 - x133 - x134)
    out[..., 24] = x131 * x137 * x138 * (x133 - x132 - x134)
    out[..., 25] = -K * x140 * x45 * x52 * x7 * (-x139 - x6)
    out[..., 26] = (
        x135 * x143 * x32 * x41 * (24 * omega_0 * x6 + 6 * x88 - x142) / (2 * omega_0 - Omega)
    )
    out[..., 27] = (
        -x106 * x140 * (26 * x30 * x49 * x8 + 2 * x54 + 18 * x56 - x101 - 24 * x103 - 57 * x104
        - 56 * x47 - x51)
    )
    out[..., 28] = -x138 * x143 * x37 * x43 * (x142 + 24 * x86 + 6 * x88) / (Omega + x123)
    out[..., 29] = -x130 * x146 * x33 * (x144 + 5 * x8 - x145)
    out[..., 30] = x126 * x146 * x38 * (-x139 - x144 - x145)
    out[..., 31] = x1 * x118 * x148 * x37 * (x147 - x144) / (5 * omega_0 - Omega)
    out[..., 32] = -x129 * x148 * x44 * (x144 + x147) / (Omega + 5 * omega_0)
    out[..., 33] = 3 / 32 * x136
    out[..., 34] = -x136 / 96
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
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
