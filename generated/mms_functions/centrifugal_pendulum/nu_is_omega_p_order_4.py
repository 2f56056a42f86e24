# Emitted by mmsgen 0.1.0 from derivations/centrifugal_pendulum.py: change that, not this file.
# Made from sha256 68127e5459076cb414c5c3f7c86986cc01796b3b5596c5d1c4a50362612cd263
# Operations for each point: slow_flow 272, coefficients 248, backbone 166, motion 391
"""centrifugal_pendulum: nu = omega_p + sigma, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of psi, phi. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: -2*omega_p + omega_r, -omega_p + omega_r.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Newland, J. Engineering for Industry 86 (1964) 257-263
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
RELATIONS: tuple[str, ...] = ("nu = omega_p + sigma",)

#: the highest power of ε
ORDER = 4

#: the coordinates, in the order of amplitudes
COORDINATES = ("psi", "phi")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, nu = omega_p + sigma"),
    "omega_r": ("positive", "rad/s", "frequency of the rotor on its spring, without pendulum"),
    "omega_p": ("positive", "rad/s", "frequency of the pendulum on a uniform rotor, n Ω"),
    "n": ("positive", "1", "order of tuning, the root of R/ρ"),
    "b": ("positive", "1", "ratio of inertias, m (R + ρ)²/J"),
    "mu": ("nonnegative", "1/s", "damping of the pendulum"),
    "tau": ("nonnegative", "1/s^2", "torque over the inertia of the rotor, T/J"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "psi": {},
    "phi": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    2,
    (
        (0, (1, 0, 0, 0, 0, 0)), (0, (1, 0, 0, 1, 1, 0)), (1, (0, 0, 0, 0, 0, 0)),
        (1, (0, 0, 0, 1, 0, 0)), (1, (0, 0, 0, 1, 1, 0)), (1, (0, 0, 0, 2, 0, 0)),
        (1, (0, 0, 0, 2, 1, 0)), (1, (0, 0, 0, 3, 2, 0)), (1, (1, 1, 0, 1, 0, 0)),
    ),
    ((1, 0),),
)

#: terms of free motions without damping
_FREE = Flow(
    2,
    (
        (0, (1, 0, 0, 0, 0, 0)), (0, (1, 0, 0, 1, 1, 0)), (1, (0, 0, 0, 1, 0, 0)),
        (1, (0, 0, 0, 2, 1, 0)), (1, (0, 0, 0, 3, 2, 0)), (1, (1, 1, 0, 1, 0, 0)),
    ),
    ((1, 0), (0, 1)),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (1, 0, 0, 0, 0, 0), (0,)), (0, 1, (0, 0, 0, 1, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 0, 0, 0), (1,)), (1, 0, (0, 0, 0, 1, 0, 0), (0,)),
        (1, 1, (1, 0, 0, 0, 0, 0), (0,)), (2, 0, (0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 2, 0, 0), (0,)), (2, 1, (0, 0, 0, 3, 0, 0), (0,)),
        (2, 1, (1, 0, 0, 0, 1, 0), (0,)), (2, 1, (1, 0, 0, 1, 0, 0), (0,)),
        (3, 0, (0, 0, 0, 0, 0, 0), (1,)), (3, 0, (0, 0, 0, 1, 0, 0), (0,)),
        (3, 0, (0, 0, 0, 2, 1, 0), (0,)), (3, 0, (0, 0, 0, 3, 0, 0), (0,)),
        (3, 0, (1, 0, 0, 0, 1, 0), (0,)), (3, 0, (1, 0, 0, 1, 0, 0), (0,)),
        (3, 1, (0, 0, 0, 1, 0, 0), (-1,)), (3, 1, (0, 0, 0, 1, 0, 0), (1,)),
        (3, 1, (0, 0, 0, 2, 0, 0), (0,)), (3, 1, (1, 0, 0, 0, 0, 0), (0,)),
        (3, 1, (1, 0, 0, 0, 2, 0), (0,)), (3, 1, (1, 0, 0, 1, 1, 0), (0,)),
        (3, 1, (1, 0, 0, 2, 0, 0), (0,)), (3, 1, (2, 0, 0, 0, 0, 0), (0,)),
        (4, 0, (0, 0, 0, 0, 0, 0), (1,)), (4, 0, (0, 0, 0, 1, 0, 0), (-1,)),
        (4, 0, (0, 0, 0, 1, 0, 0), (1,)), (4, 0, (0, 0, 0, 1, 1, 0), (0,)),
        (4, 0, (0, 0, 0, 2, 0, 0), (0,)), (4, 0, (0, 0, 0, 3, 1, 0), (0,)),
        (4, 0, (0, 0, 0, 4, 0, 0), (0,)), (4, 0, (1, 0, 0, 0, 2, 0), (0,)),
        (4, 0, (1, 0, 0, 2, 0, 0), (0,)), (4, 0, (2, 0, 0, 0, 0, 0), (0,)),
        (4, 1, (0, 0, 0, 1, 0, 0), (-1,)), (4, 1, (0, 0, 0, 1, 0, 0), (1,)),
        (4, 1, (0, 0, 0, 2, 0, 0), (1,)), (4, 1, (0, 0, 0, 3, 0, 0), (0,)),
        (4, 1, (0, 0, 0, 4, 1, 0), (0,)), (4, 1, (0, 0, 0, 5, 0, 0), (0,)),
        (4, 1, (1, 0, 0, 0, 0, 0), (-1,)), (4, 1, (1, 0, 0, 0, 0, 0), (1,)),
        (4, 1, (1, 0, 0, 0, 1, 0), (0,)), (4, 1, (1, 0, 0, 0, 3, 0), (0,)),
        (4, 1, (1, 0, 0, 1, 0, 0), (0,)), (4, 1, (1, 0, 0, 1, 2, 0), (0,)),
        (4, 1, (1, 0, 0, 2, 1, 0), (0,)), (4, 1, (1, 0, 0, 3, 0, 0), (0,)),
        (4, 1, (2, 0, 0, 0, 1, 0), (0,)), (4, 1, (2, 0, 0, 1, 0, 0), (0,)),
    ),
    1,
)


def _slow_flow(out, A_psi, A_phi, sigma, omega_r, omega_p, n, b, mu, tau):
    # Intermediates
    x0 = omega_p + omega_r
    x1 = x0 * x0
    x2 = x0 * x1
    x3 = 1 / x2
    x4 = -omega_r
    x5 = -omega_p - x4
    x6 = x5 * x5
    x7 = x5 * x6
    x8 = 1 / x7
    x9 = mu * x0 * x5
    x10 = omega_p * omega_p
    x11 = x10 * x10
    x12 = 4 * x11
    x13 = b * x11
    x14 = omega_r * omega_r
    x15 = x10 * x14
    x16 = 1 / 2 * b
    x17 = np.conj(A_phi)
    x18 = 2 * omega_p
    x19 = -x18 - x4
    x20 = omega_r + x18
    x21 = 1 / (x1 * x19 * x20 * x6)
    x22 = n * n
    x23 = x22 + 1
    x24 = x23 * x23
    x25 = x17 * x21 / x24
    x26 = x11 * x22
    x27 = 4 * x22
    x28 = 1j * A_phi
    x29 = x14 * x14
    x30 = x22 * x22
    x31 = (
        A_psi * x28 * (x10 * x14 + 4 * x11 * x30 + 2 * x29 * x30 - x12 - x15 * x27 - 9 * x15 * x30
        - 2 * x26)
    )
    x32 = omega_r * x14
    x33 = 1j * omega_p
    x34 = tau / (x0 * x5)
    x35 = 1 / omega_p
    x36 = 1 / 2 * x29
    x37 = mu * x1 * x6
    x38 = x10 * x29
    x39 = sigma * sigma
    x40 = 1 / 16 * x39
    x41 = x3 * x35 * x8
    x42 = mu * mu
    x43 = 1 / 2 * x42
    x44 = x10 * x11
    x45 = b * x44
    x46 = 3 / 2 * x42
    x47 = x11 * x14
    x48 = 8 * x44
    x49 = x14 * x29
    x50 = 2 * x49
    x51 = 18 * x47
    x52 = b * x38
    x53 = x13 * x14
    x54 = x10 * x29 * x30
    x55 = A_phi * A_phi
    x56 = x11 * x11
    x57 = b * b
    x58 = x17 * x17
    x59 = A_phi * x55
    x60 = omega_p * x11
    x61 = omega_p * x10
    # Outputs
    out[..., 0] = (
        A_psi * b * omega_r * x3 * x8 * (-1 / 8 * 1j * x10 * (b * x15 + 3 * x13 + 8 * x15 - x12
        - 4 * x29) - x32 * x9) - x16 * x25 * x31 * x32
    )
    out[..., 1] = (
        A_phi * x41 * (omega_p * x9 * (2 * b * x10 * x14 + 2 * x10 * x14 - x11 - x13 - x29) + 1j
        * (3 / 8 * x14 * x44 * x57 + x14 * x45 + x38 * x46 + x43 * x44 + 1 / 8 * x56 * x57 - x13
        * x36 - x16 * x56 - x43 * x49 - x46 * x47))
        + 1 / 16 * omega_p * x17 * x28 * x34 * (3 * x22 - 1) + tau * x23 * x41 * (1 / 8 * omega_p
        * x37 + 1j * (3 / 16 * b * x11 * x14 + 1 / 16 * b * x44 + 1 / 4 * sigma * x14 * x61 + 1 / 8
        * sigma * x60 + 1 / 2 * x11 * x14 - 3 / 8 * omega_p * sigma * x29 - x11 * x40 - 7 / 8 * x15
        * x39 - x29 * x40 - 1 / 4 * x38 - 1 / 4 * x44)) + x25 * x55 * (1 / 8 * 1j * omega_p * (b
        * x22 * x48 + 11 * b * x54 + 24 * x22 * x38 + 16 * x22 * x44 + 36 * x30 * x45 + x30 * x48
        + 12 * x38 + 4 * x45 + x48 + 3 * x52 + 12 * x54 - 36 * x14 * x26 - 18 * x22 * x52 - 2 * x22
        * x53 - x27 * x49 - x30 * x50 - x30 * x51 - 53 * x30 * x53 - x50 - x51 - 13 * x53) - 1 / 4
        * x19 * x20 * x24 * x37) + 1 / 32 * x33 * x34 * x55 * (5 * x22 + 1)
        + 1 / 64 * x33 * x58 * x59 - sigma * x28 - x21 * x31 * x35 * x36 * np.conj(A_psi)
    )


def _coefficients(out, sigma, omega_r, omega_p, n, b, mu, tau):
    # Intermediates
    x0 = omega_p + omega_r
    x1 = -omega_r
    x2 = -omega_p - x1
    x3 = mu * x0 * x2
    x4 = omega_p * omega_p
    x5 = x4 * x4
    x6 = 4 * x5
    x7 = b * x5
    x8 = omega_r * omega_r
    x9 = x4 * x8
    x10 = x0 * x0
    x11 = x0 * x10
    x12 = 1 / x11
    x13 = x2 * x2
    x14 = x13 * x2
    x15 = 1 / x14
    x16 = x12 * x15
    x17 = omega_r * x8
    x18 = x8 * x8
    x19 = 1 / 2 * b
    x20 = 2 * omega_p
    x21 = -x1 - x20
    x22 = omega_r + x20
    x23 = 1 / (x10 * x13 * x21 * x22)
    x24 = n * n
    x25 = x24 + 1
    x26 = x25 * x25
    x27 = x23 / x26
    x28 = x24 * x5
    x29 = 4 * x24
    x30 = x24 * x24
    x31 = 1j * (2 * x18 * x30 + 4 * x30 * x5 + x4 * x8 - 2 * x28 - x29 * x9 - 9 * x30 * x9 - x6)
    x32 = mu * x10 * x13
    x33 = x18 * x4
    x34 = sigma * sigma
    x35 = 1 / 16 * x34
    x36 = 1 / omega_p
    x37 = x4 * x5
    x38 = omega_p * x5
    x39 = omega_p * x4
    x40 = mu * mu
    x41 = 1 / 2 * x40
    x42 = b * x37
    x43 = 1 / 2 * x18
    x44 = 3 / 2 * x40
    x45 = x5 * x8
    x46 = x5 * x5
    x47 = b * b
    x48 = x18 * x8
    x49 = 1j * omega_p
    x50 = tau * x49 / (x0 * x2)
    x51 = 8 * x37
    x52 = 2 * x48
    x53 = 18 * x45
    x54 = b * x33
    x55 = x7 * x8
    x56 = x18 * x30 * x4
    # Outputs
    out[..., 0] = (
        b * omega_r * x16 * (-x17 * x3
        - 1 / 8 * 1j * x4 * (b * x9 + 3 * x7 + 8 * x9 - 4 * x18 - x6))
    )
    out[..., 1] = -x17 * x19 * x27 * x31
    out[..., 2] = (
        tau * x16 * x25 * x36 * (1 / 8 * omega_p * x32 + 1j * (1 / 16 * b * x37 + 3 / 16 * b * x5
        * x8 + 1 / 8 * sigma * x38 + 1 / 4 * sigma * x39 * x8 + 1 / 2 * x5 * x8 - 3 / 8 * omega_p
        * sigma * x18 - x18 * x35 - 1 / 4 * x33 - 7 / 8 * x34 * x9 - x35 * x5 - 1 / 4 * x37))
    )
    out[..., 3] = (
        x12 * x15 * x36 * (omega_p * x3 * (2 * b * x4 * x8 + 2 * x4 * x8 - x18 - x5 - x7) + 1j
        * (x33 * x44 + x37 * x41 + 3 / 8 * x37 * x47 * x8 + x42 * x8 + 1 / 8 * x46 * x47 - x19 * x46
        - x41 * x48 - x43 * x7 - x44 * x45)) - 1j * sigma
    )
    out[..., 4] = 1 / 16 * x50 * (3 * x24 - 1)
    out[..., 5] = 1 / 32 * x50 * (5 * x24 + 1)
    out[..., 6] = (
        x27 * (1 / 8 * 1j * omega_p * (b * x24 * x51 + 11 * b * x56 + 24 * x24 * x33
        + 16 * x24 * x37 + 36 * x30 * x42 + x30 * x51 + 12 * x33 + 4 * x42 + x51 + 3 * x54
        + 12 * x56 - 18 * x24 * x54 - 2 * x24 * x55 - 36 * x28 * x8 - x29 * x48 - x30 * x52
        - x30 * x53 - 53 * x30 * x55 - x52 - x53 - 13 * x55) - 1 / 4 * x21 * x22 * x26 * x32)
    )
    out[..., 7] = 1 / 64 * x49
    out[..., 8] = -x23 * x31 * x36 * x43


def _backbone(out, omega_r, omega_p, n, b, mu, tau):
    # Intermediates
    x0 = omega_p * omega_p
    x1 = x0 * x0
    x2 = 4 * x1
    x3 = b * x1
    x4 = omega_r * omega_r
    x5 = x0 * x4
    x6 = omega_p + omega_r
    x7 = x6 * x6
    x8 = x6 * x7
    x9 = -omega_r
    x10 = -omega_p - x9
    x11 = x10 * x10
    x12 = x10 * x11
    x13 = 1 / (x12 * x8)
    x14 = x4 * x4
    x15 = n * n
    x16 = x1 * x15
    x17 = 4 * x15
    x18 = x15 * x15
    x19 = x0 * x4 + 4 * x1 * x18 + 2 * x14 * x18 - 2 * x16 - x17 * x5 - 9 * x18 * x5 - x2
    x20 = 1 / 2 * b
    x21 = 2 * omega_p
    x22 = 1 / (x11 * x7 * (omega_r + x21) * (-x21 - x9))
    x23 = x15 + 1
    x24 = x23 * x23
    x25 = x22 / x24
    x26 = omega_r * x4
    x27 = mu * mu
    x28 = 1 / 2 * x27
    x29 = x0 * x1
    x30 = b * x29
    x31 = 1 / 2 * x14
    x32 = x0 * x14
    x33 = 3 / 2 * x27
    x34 = x1 * x4
    x35 = 1j / omega_p
    x36 = x1 * x1
    x37 = b * b
    x38 = x14 * x4
    x39 = 8 * x29
    x40 = 2 * x38
    x41 = 18 * x34
    x42 = b * x32
    x43 = x3 * x4
    x44 = x0 * x14 * x18
    x45 = 1j * omega_p
    # Outputs
    out[..., 0] = -1 / 8 * 1j * b * omega_r * x0 * x13 * (b * x5 + 3 * x3 + 8 * x5 - 4 * x14 - x2)
    out[..., 1] = -1j * x19 * x20 * x25 * x26
    out[..., 2] = (
        x13 * x35 * (x28 * x29 + 3 / 8 * x29 * x37 * x4 + x30 * x4 + x32 * x33 + 1 / 8 * x36 * x37
        - x20 * x36 - x28 * x38 - x3 * x31 - x33 * x34)
    )
    out[..., 3] = (
        1 / 8 * x25 * x45 * (b * x15 * x39 + 11 * b * x44 + 16 * x15 * x29 + 24 * x15 * x32
        + 36 * x18 * x30 + x18 * x39 + 4 * x30 + 12 * x32 + x39 + 3 * x42 + 12 * x44
        - 18 * x15 * x42 - 2 * x15 * x43 - 36 * x16 * x4 - x17 * x38 - x18 * x40 - x18 * x41
        - 53 * x18 * x43 - x40 - x41 - 13 * x43)
    )
    out[..., 4] = 1 / 64 * x45
    out[..., 5] = -x19 * x22 * x31 * x35


def _motion(out, sigma, omega_r, omega_p, n, b, mu, tau):
    # Intermediates
    x0 = omega_p + omega_r
    x1 = 1 / x0
    x2 = -omega_r
    x3 = -omega_p - x2
    x4 = 1 / x3
    x5 = x1 * x4
    x6 = tau * x5
    x7 = n * n
    x8 = x7 + 1
    x9 = 1 / x8
    x10 = omega_p * omega_p
    x11 = b * x10
    x12 = x11 * x9
    x13 = x12 * x5
    x14 = omega_r * omega_r
    x15 = 2 * x14
    x16 = x5 * x8
    x17 = x3 * x3
    x18 = 1 / x17
    x19 = x0 * x0
    x20 = 1 / x19
    x21 = x18 * x20
    x22 = 2 * omega_p
    x23 = sigma * tau * x22
    x24 = x8 * x8
    x25 = 1 / x24
    x26 = x11 * x25
    x27 = -x2 - x22
    x28 = 1 / x27
    x29 = omega_r + x22
    x30 = 1 / x29
    x31 = 1j * n
    x32 = x30 * x31
    x33 = 4 * x28 * x32
    x34 = 4 * omega_p
    x35 = x31 * x34
    x36 = x0 * x19
    x37 = 1 / x36
    x38 = x17 * x3
    x39 = 1 / x38
    x40 = x37 * x39
    x41 = x10 * x10
    x42 = sigma * sigma
    x43 = b * x22
    x44 = omega_p * x41
    x45 = x10 * x7
    x46 = x14 * x7
    x47 = 3 * omega_p
    x48 = 1 / (-x2 - x47)
    x49 = 1 / (omega_r + x47)
    x50 = 9 * x7 + 1
    x51 = x49 * x50
    x52 = omega_p * omega_r
    x53 = x10 + x14
    x54 = x53 - x52
    x55 = 1 / (2 * omega_r - omega_p)
    x56 = 1j * b
    x57 = x55 * x56
    x58 = n * x34
    x59 = x58 * x9
    x60 = x52 + x53
    x61 = 2 * omega_r
    x62 = 1 / (omega_p + x61)
    x63 = x56 * x62
    x64 = x31 * x6
    x65 = 1j * mu
    x66 = x0 * x3
    x67 = x10 + x46
    x68 = x18 * x67
    x69 = x1 * x48
    x70 = x4 * x49
    x71 = omega_r * x14
    x72 = x19 * x19
    x73 = x17 * x17
    x74 = 1 / x14
    x75 = x12 * x64
    x76 = x27 * x27
    x77 = 1 / x76
    x78 = x29 * x29
    x79 = 1 / x78
    x80 = -5 * x14
    x81 = b * x25
    x82 = 4 * x10
    x83 = n * x77
    x84 = omega_p * x10
    x85 = x31 * x79
    x86 = 1 / (omega_r + x34)
    x87 = x31 / (-x2 - x34)
    x88 = x71 * x84
    x89 = 4 * x88
    x90 = omega_r * x44
    x91 = 44 * x7 * x90
    x92 = x7 * x7
    x93 = 28 * x88 * x92
    x94 = x14 * x14
    x95 = omega_r * x94
    x96 = omega_p * x95
    x97 = 12 * x92
    x98 = x96 * x97
    x99 = x14 * x41
    x100 = 4 * x99
    x101 = x10 * x94
    x102 = x14 * x94
    x103 = 2 * x102
    x104 = x10 * x41
    x105 = x104 * x7
    x106 = x100 + 27 * x101 * x92 + x101 + x103 * x92 + 24 * x105 + 22 * x41 * x46 + x97 * x99
    x107 = 1 / omega_p
    x108 = 1 / 4 * x107 * x81
    x109 = x21 * x57
    x110 = 2 * x20
    x111 = tau * x110 * x18
    x112 = sigma * x107 * x31
    x113 = 5 / 128 * x7 - 3 / 128
    x114 = 1 / 2 * x7
    x115 = b * omega_p
    x116 = x114 * x115 * x25
    x117 = x115 * x9
    x118 = x113 * x117
    x119 = 9 / 128 * x117
    x120 = x111 * x8 * x84 / omega_r
    x121 = 2 * x104
    x122 = 7 * x88 + 8 * x96 - 7 * x90
    x123 = 6 * x52
    x124 = 8 * x10 + 3 * x14
    x125 = 1 / 4 * omega_p
    x126 = omega_r * x22
    x127 = 1 / 4 * x88
    x128 = x7 * x88
    x129 = x7 * x96
    x130 = 1 / 2 * x92 * x96
    x131 = x114 * x90
    x132 = 1 / 4 * x92
    x133 = x132 * x88
    x134 = (
        1 / 8 * x101 + x102 * x114 + x102 * x132 + x105 + 1 / 2 * x45 * x94
        - 1 / 8 * x10 * x92 * x94 - 7 / 4 * x14 * x41 * x7
    )
    x135 = omega_p + sigma
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = x6
    out[..., 3] = 2 * x13
    out[..., 4] = -x15 * x16
    out[..., 5] = x21 * x23
    out[..., 6] = x26 * x33
    out[..., 7] = -1 / 24
    out[..., 8] = x28 * x35
    out[..., 9] = x30 * x35
    out[..., 10] = -tau * x40 * (b * x41 - 3 * x10 * x42 - x14 * x42)
    out[..., 11] = x40 * x43 * x9 * (2 * 1j * mu * x0 * x14 * x3 - b * x44)
    out[..., 12] = -x21 * x26 * (x14 + 2 * x46 - x45)
    out[..., 13] = -3 / 8 * x26 * x48 * x51
    out[..., 14] = x1 * x28 * x54 * x57 * x59
    out[..., 15] = x30 * x4 * x59 * x60 * x63
    out[..., 16] = 2 * x64
    out[..., 17] = 2 * x64 / 3
    out[..., 18] = -x13 * x14 * x33
    out[..., 19] = x15 * x40 * x8 * (b * x41 - x61 * x65 * x66)
    out[..., 20] = x14 * x68 * x69
    out[..., 21] = x15 * x20 * x68
    out[..., 22] = x14 * x20 * x67 * x70
    out[..., 23] = -x16 * x35 * x55 * x62 * x71
    out[..., 24] = -x23 * x53 * (x11 - 2 * x42) / (x72 * x73)
    out[..., 25] = x74 * x75
    out[..., 26] = x75 * x77 * x79 * (-44 * x10 - x80) / 3
    out[..., 27] = -mu * x58 * x74 * x81
    out[..., 28] = (
        x25 * x43 * x5 * x79 * x83 * (-2 * mu * x66 * (x14 + x82) - x56 * x84 * (12 * x10 + x14))
    )
    out[..., 29] = -1 / 2 * x26 * x77 * x85 * (-x80 - x82)
    out[..., 30] = -x26 * x86 * x87
    out[..., 31] = x108 * x39 * x69 * (x106 - x89 - x91 - x93 - x98)
    out[..., 32] = -x108 * x37 * x70 * (x106 + x89 + x91 + x93 + x98)
    out[..., 33] = -n * x109 * x62 * x89
    out[..., 34] = x111 * x112 * x53
    out[..., 35] = -2 * tau * x112 * x21 * (x14 - 7 * x10) / 9
    out[..., 36] = x113 * x6
    out[..., 37] = (
        1 / 16 * x107 * x65 + x116 * x30 + x118 * x4 + x119 * x48 * x50 - x1 * x118 - x116 * x28
        - x119 * x51
    )
    out[..., 38] = -1 / 128
    out[..., 39] = 1 / 640
    out[..., 40] = -x120 * x31 * x54 * x77
    out[..., 41] = -x120 * x60 * x85
    out[..., 42] = -x109 * x22 * x83 * (14 * x10 * x94 + 2 * x102 - x100 - x121 - x122)
    out[..., 43] = -x125 * x77 * x87 * (x124 - x123)
    out[..., 44] = -n * x21 * x22 * x63 * x79 * (14 * x101 + x103 + x122 - x100 - x121)
    out[..., 45] = -x0 * x126 * x32 * x77
    out[..., 46] = -x126 * x28 * x3 * x85
    out[..., 47] = -x125 * x85 * x86 * (x123 + x124)
    out[..., 48] = x110 * x28 * x39 * (x127 + x129 + x130 + x131 - x128 - x133 - x134)
    out[..., 49] = 2 * x18 * x30 * x37 * (x128 + x133 - x127 - x129 - x130 - x131 - x134)
    out[..., 50] = omega_r
    out[..., 51] = x135
    out[..., 52] = x135


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike,
    n: ArrayLike, b: ArrayLike, mu: ArrayLike, tau: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, nu = omega_p + sigma, rad/s, real.
    omega_r : array_like
        Frequency of the rotor on its spring, without pendulum, rad/s, > 0.
    omega_p : array_like
        Frequency of the pendulum on a uniform rotor, n Ω, rad/s, > 0.
    n : array_like
        Order of tuning, the root of R/ρ, > 0.
    b : array_like
        Ratio of inertias, m (R + ρ)²/J, > 0.
    mu : array_like
        Damping of the pendulum, 1/s, >= 0.
    tau : array_like
        Torque over the inertia of the rotor, T/J, 1/s^2, >= 0.

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
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))


def equilibria(
    *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike, n: ArrayLike, b: ArrayLike,
    mu: ArrayLike, tau: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN. B_j exp(i k_j θ) moves along a circle of
    further ones for k = (1, 0); of each circle one point is given, and the rate at which it drifts,
    B_j exp(i k_j ρ t).

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = omega_p + sigma, rad/s, real.
    omega_r : array_like
        Frequency of the rotor on its spring, without pendulum, rad/s, > 0.
    omega_p : array_like
        Frequency of the pendulum on a uniform rotor, n Ω, rad/s, > 0.
    n : array_like
        Order of tuning, the root of R/ρ, > 0.
    b : array_like
        Ratio of inertias, m (R + ρ)²/J, > 0.
    mu : array_like
        Damping of the pendulum, 1/s, >= 0.
    tau : array_like
        Torque over the inertia of the rotor, T/J, 1/s^2, >= 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Equilibria
        The arrays amplitudes (..., count, 2), drift (..., count, 1) in rad/s and growth (...,
        count) in 1/s, which is negative where an equilibrium is stable. With gradient also name ->
        derivatives of amplitudes, drift and growth, NaN where equilibria meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return equilibria_at(
        equilibria_of_many,
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega_r", "omega_p", "n", "b", "mu", "tau") if gradient else (),
    )


def frequency_response(
    *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike, n: ArrayLike, b: ArrayLike,
    mu: ArrayLike, tau: ArrayLike, over: str = "sigma", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma : array_like
        Detuning, nu = omega_p + sigma, rad/s, real.
    omega_r : array_like
        Frequency of the rotor on its spring, without pendulum, rad/s, > 0.
    omega_p : array_like
        Frequency of the pendulum on a uniform rotor, n Ω, rad/s, > 0.
    n : array_like
        Order of tuning, the root of R/ρ, > 0.
    b : array_like
        Ratio of inertias, m (R + ρ)²/J, > 0.
    mu : array_like
        Damping of the pendulum, 1/s, >= 0.
    tau : array_like
        Torque over the inertia of the rotor, T/J, 1/s^2, >= 0.
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
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega_r", "omega_p", "n", "b", "mu", "tau"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, omega_r: ArrayLike, omega_p: ArrayLike, n: ArrayLike, b: ArrayLike,
    mu: ArrayLike, tau: ArrayLike, of: str = "psi",
) -> Any:
    """Free motions without damping in which one coordinate has a given amplitude.

    All periodic ones: normal modes, whose frequencies over the amplitude are the backbone curves of
    the responses. Forces and damping are left out.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    omega_r : array_like
        Frequency of the rotor on its spring, without pendulum, rad/s, > 0.
    omega_p : array_like
        Frequency of the pendulum on a uniform rotor, n Ω, rad/s, > 0.
    n : array_like
        Order of tuning, the root of R/ρ, > 0.
    b : array_like
        Ratio of inertias, m (R + ρ)²/J, > 0.
    mu : array_like
        Damping of the pendulum, 1/s, >= 0.
    tau : array_like
        Torque over the inertia of the rotor, T/J, 1/s^2, >= 0.
    of : str, optional
        That coordinate.

    Returns
    -------
    Backbone
        The arrays amplitudes (..., count, 2), shift (..., count, 2) of the frequency of each
        coordinate in rad/s, detuning (..., count) of a force at that frequency in rad/s, and growth
        (..., count) in 1/s, zero where a motion is stable; NaN where there are fewer.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau)
    return modes_at(_FREE, (0.0, 1.0), _backbone, arguments, amplitude, COORDINATES, of)


def jacobian(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike,
    n: ArrayLike, b: ArrayLike, mu: ArrayLike, tau: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`, turned along its symmetries so that the amplitudes given drift as
    little as they can; an equilibrium then is at rest.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, nu = omega_p + sigma, rad/s, real.
    omega_r : array_like
        Frequency of the rotor on its spring, without pendulum, rad/s, > 0.
    omega_p : array_like
        Frequency of the pendulum on a uniform rotor, n Ω, rad/s, > 0.
    n : array_like
        Order of tuning, the root of R/ρ, > 0.
    b : array_like
        Ratio of inertias, m (R + ρ)²/J, > 0.
    mu : array_like
        Damping of the pendulum, 1/s, >= 0.
    tau : array_like
        Torque over the inertia of the rotor, T/J, 1/s^2, >= 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 4, 4), in 1/s, rows and columns u_1, v_1, u_2, …; with gradient this and name ->
        derivatives, the amplitudes fixed.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega_r", "omega_p", "n", "b", "mu", "tau") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike,
    n: ArrayLike, b: ArrayLike, mu: ArrayLike, tau: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t). Each symmetry that moves the point has
    a zero, which is left out.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, nu = omega_p + sigma, rad/s, real.
    omega_r : array_like
        Frequency of the rotor on its spring, without pendulum, rad/s, > 0.
    omega_p : array_like
        Frequency of the pendulum on a uniform rotor, n Ω, rad/s, > 0.
    n : array_like
        Order of tuning, the root of R/ρ, > 0.
    b : array_like
        Ratio of inertias, m (R + ρ)²/J, > 0.
    mu : array_like
        Damping of the pendulum, 1/s, >= 0.
    tau : array_like
        Torque over the inertia of the rotor, T/J, 1/s^2, >= 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    complex128
        Shape (..., 4), in 1/s; NaN at the end for those that are left out; with gradient this and
        name -> derivatives, the amplitudes fixed; NaN where eigenvalues meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega_r", "omega_p", "n", "b", "mu", "tau") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_r: ArrayLike,
    omega_p: ArrayLike, n: ArrayLike, b: ArrayLike, mu: ArrayLike, tau: ArrayLike,
    order: int | None = None, drift: ArrayLike | None = None, gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. With a drift, constant ones turn along the
    symmetries of the slow flow. NaN where a harmonic resonates itself. Derivatives are taken with
    these fixed. Over times of order 1/ε the error is O(ε^4). A UserWarning says how much is left
    out where that is more than a tenth of the motion, estimated from the harmonics of each order
    beside those of order zero, and from the terms of the slow flow.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, nu = omega_p + sigma, rad/s, real.
    omega_r : array_like
        Frequency of the rotor on its spring, without pendulum, rad/s, > 0.
    omega_p : array_like
        Frequency of the pendulum on a uniform rotor, n Ω, rad/s, > 0.
    n : array_like
        Order of tuning, the root of R/ρ, > 0.
    b : array_like
        Ratio of inertias, m (R + ρ)²/J, > 0.
    mu : array_like
        Damping of the pendulum, 1/s, >= 0.
    tau : array_like
        Torque over the inertia of the rotor, T/J, 1/s^2, >= 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 4; all by default.
    drift : array_like, optional
        Of an equilibrium that drifts, shape (..., 1), rad/s: as `equilibria` gives it.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2), in the order psi, phi; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        drift=drift,
        slow=(_FLOW, _coefficients, 7),
        names=("sigma", "omega_r", "omega_p", "n", "b", "mu", "tau") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike,
    n: ArrayLike, b: ArrayLike, mu: ArrayLike, tau: ArrayLike,
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
        Detuning, nu = omega_p + sigma, rad/s, real.
    omega_r : array_like
        Frequency of the rotor on its spring, without pendulum, rad/s, > 0.
    omega_p : array_like
        Frequency of the pendulum on a uniform rotor, n Ω, rad/s, > 0.
    n : array_like
        Order of tuning, the root of R/ρ, > 0.
    b : array_like
        Ratio of inertias, m (R + ρ)²/J, > 0.
    mu : array_like
        Damping of the pendulum, 1/s, >= 0.
    tau : array_like
        Torque over the inertia of the rotor, T/J, 1/s^2, >= 0.

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
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 7, False))
