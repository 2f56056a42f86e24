# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_3.py: change that, not this file.
# Made from sha256 ef0a0b3670b1c741c84398d63b30f5e28179fb3b7ff4a6d330eb2b7523060a9b
# Operations for each point: slow_flow 237, coefficients 175, backbone 147, motion 500
"""internal_resonance_1_3: omega_2 = 3*omega_1 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of u_1, u_2. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 6
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
RELATIONS: tuple[str, ...] = ("omega_2 = 3*omega_1 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u_1", "u_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, omega_2 = 3*omega_1 + sigma"),
    "omega_1": ("positive", "rad/s", "natural frequency of the slower oscillator"),
    "mu_1": ("nonnegative", "1/s", "damping of the slower oscillator"),
    "mu_2": ("nonnegative", "1/s", "damping of the faster oscillator"),
    "alpha_1": ("real", "1/(m^2 s^2)", "cubic term 1"),
    "alpha_2": ("real", "1/(m^2 s^2)", "cubic term 2"),
    "alpha_3": ("real", "1/(m^2 s^2)", "cubic term 3"),
    "alpha_4": ("real", "1/(m^2 s^2)", "cubic term 4"),
    "alpha_5": ("real", "1/(m^2 s^2)", "cubic term 5"),
    "alpha_6": ("real", "1/(m^2 s^2)", "cubic term 6"),
    "alpha_7": ("real", "1/(m^2 s^2)", "cubic term 7"),
    "alpha_8": ("real", "1/(m^2 s^2)", "cubic term 8"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u_1": {},
    "u_2": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    2,
    (
        (0, (0, 2, 0, 1, 0, 0)), (0, (0, 2, 0, 2, 1, 0)), (0, (1, 0, 0, 0, 0, 0)),
        (0, (1, 0, 0, 1, 1, 0)), (0, (1, 0, 0, 2, 2, 0)), (0, (1, 3, 0, 1, 0, 0)),
        (0, (2, 1, 0, 0, 0, 0)), (0, (2, 1, 0, 1, 1, 0)), (0, (3, 2, 0, 0, 0, 0)),
        (0, (4, 0, 0, 0, 1, 0)), (1, (0, 0, 0, 1, 0, 0)), (1, (0, 0, 0, 2, 1, 0)),
        (1, (0, 0, 0, 3, 2, 0)), (1, (0, 3, 0, 2, 0, 0)), (1, (1, 1, 0, 1, 0, 0)),
        (1, (1, 1, 0, 2, 1, 0)), (1, (2, 2, 0, 1, 0, 0)), (1, (3, 0, 0, 0, 0, 0)),
        (1, (3, 0, 0, 1, 1, 0)), (1, (4, 1, 0, 0, 0, 0)),
    ),
    ((1, 3),),
)

#: terms of free motions without damping
_FREE = Flow(
    2,
    (
        (0, (0, 2, 0, 1, 0, 0)), (0, (0, 2, 0, 2, 1, 0)), (0, (1, 0, 0, 0, 0, 0)),
        (0, (1, 0, 0, 1, 1, 0)), (0, (1, 0, 0, 2, 2, 0)), (0, (1, 3, 0, 1, 0, 0)),
        (0, (2, 1, 0, 0, 0, 0)), (0, (2, 1, 0, 1, 1, 0)), (0, (3, 2, 0, 0, 0, 0)),
        (0, (4, 0, 0, 0, 1, 0)), (1, (0, 0, 0, 1, 0, 0)), (1, (0, 0, 0, 2, 1, 0)),
        (1, (0, 0, 0, 3, 2, 0)), (1, (0, 3, 0, 2, 0, 0)), (1, (1, 1, 0, 1, 0, 0)),
        (1, (1, 1, 0, 2, 1, 0)), (1, (2, 2, 0, 1, 0, 0)), (1, (3, 0, 0, 0, 0, 0)),
        (1, (3, 0, 0, 1, 1, 0)), (1, (4, 1, 0, 0, 0, 0)),
    ),
    ((1, 3),),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (1, 0, 0, 0, 0, 0), ()), (0, 1, (0, 0, 0, 1, 0, 0), ()),
        (1, 0, (0, 0, 0, 2, 1, 0), ()), (1, 0, (0, 0, 0, 3, 0, 0), ()),
        (1, 0, (1, 0, 0, 0, 2, 0), ()), (1, 0, (1, 0, 0, 2, 0, 0), ()),
        (1, 0, (1, 1, 0, 1, 0, 0), ()), (1, 0, (2, 0, 0, 1, 0, 0), ()),
        (1, 0, (3, 0, 0, 0, 0, 0), ()), (1, 1, (0, 0, 0, 3, 0, 0), ()),
        (1, 1, (1, 0, 0, 0, 2, 0), ()), (1, 1, (1, 0, 0, 1, 1, 0), ()),
        (1, 1, (1, 0, 0, 2, 0, 0), ()), (1, 1, (2, 0, 0, 0, 1, 0), ()),
        (1, 1, (2, 0, 0, 1, 0, 0), ()), (1, 1, (2, 1, 0, 0, 0, 0), ()),
        (2, 0, (0, 0, 0, 2, 1, 0), ()), (2, 0, (0, 0, 0, 3, 0, 0), ()),
        (2, 0, (0, 0, 0, 3, 2, 0), ()), (2, 0, (0, 0, 0, 4, 1, 0), ()),
        (2, 0, (0, 0, 0, 5, 0, 0), ()), (2, 0, (1, 0, 0, 0, 2, 0), ()),
        (2, 0, (1, 0, 0, 0, 4, 0), ()), (2, 0, (1, 0, 0, 1, 3, 0), ()),
        (2, 0, (1, 0, 0, 2, 0, 0), ()), (2, 0, (1, 0, 0, 3, 1, 0), ()),
        (2, 0, (1, 0, 0, 4, 0, 0), ()), (2, 0, (1, 1, 0, 1, 0, 0), ()),
        (2, 0, (1, 1, 0, 2, 1, 0), ()), (2, 0, (1, 1, 0, 3, 0, 0), ()),
        (2, 0, (2, 0, 0, 0, 3, 0), ()), (2, 0, (2, 0, 0, 1, 0, 0), ()),
        (2, 0, (2, 0, 0, 2, 1, 0), ()), (2, 0, (2, 0, 0, 3, 0, 0), ()),
        (2, 0, (2, 1, 0, 0, 2, 0), ()), (2, 0, (2, 1, 0, 2, 0, 0), ()),
        (2, 0, (2, 2, 0, 1, 0, 0), ()), (2, 0, (3, 0, 0, 0, 0, 0), ()),
        (2, 0, (3, 0, 0, 0, 2, 0), ()), (2, 0, (3, 0, 0, 1, 1, 0), ()),
        (2, 0, (3, 0, 0, 2, 0, 0), ()), (2, 0, (3, 1, 0, 1, 0, 0), ()),
        (2, 0, (4, 0, 0, 1, 0, 0), ()), (2, 0, (4, 1, 0, 0, 0, 0), ()),
        (2, 0, (5, 0, 0, 0, 0, 0), ()), (2, 1, (0, 0, 0, 3, 0, 0), ()),
        (2, 1, (0, 0, 0, 4, 1, 0), ()), (2, 1, (0, 0, 0, 5, 0, 0), ()),
        (2, 1, (1, 0, 0, 0, 2, 0), ()), (2, 1, (1, 0, 0, 0, 4, 0), ()),
        (2, 1, (1, 0, 0, 1, 1, 0), ()), (2, 1, (1, 0, 0, 1, 3, 0), ()),
        (2, 1, (1, 0, 0, 2, 0, 0), ()), (2, 1, (1, 0, 0, 2, 2, 0), ()),
        (2, 1, (1, 0, 0, 3, 1, 0), ()), (2, 1, (1, 0, 0, 4, 0, 0), ()),
        (2, 1, (1, 1, 0, 3, 0, 0), ()), (2, 1, (2, 0, 0, 0, 1, 0), ()),
        (2, 1, (2, 0, 0, 0, 3, 0), ()), (2, 1, (2, 0, 0, 1, 0, 0), ()),
        (2, 1, (2, 0, 0, 1, 2, 0), ()), (2, 1, (2, 0, 0, 2, 1, 0), ()),
        (2, 1, (2, 0, 0, 3, 0, 0), ()), (2, 1, (2, 1, 0, 0, 0, 0), ()),
        (2, 1, (2, 1, 0, 0, 2, 0), ()), (2, 1, (2, 1, 0, 1, 1, 0), ()),
        (2, 1, (2, 1, 0, 2, 0, 0), ()), (2, 1, (3, 0, 0, 2, 0, 0), ()),
        (2, 1, (3, 1, 0, 0, 1, 0), ()), (2, 1, (3, 1, 0, 1, 0, 0), ()),
        (2, 1, (3, 2, 0, 0, 0, 0), ()), (2, 1, (4, 0, 0, 0, 1, 0), ()),
        (2, 1, (4, 0, 0, 1, 0, 0), ()), (2, 1, (5, 0, 0, 0, 0, 0), ()),
    ),
    0,
)


def _slow_flow(
    out, A_u_1, A_u_2, sigma, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4, alpha_5,
    alpha_6, alpha_7, alpha_8,
):
    # Intermediates
    x0 = 1 / omega_1
    x1 = np.conj(A_u_2)
    x2 = 1j * omega_1
    x3 = omega_1 * omega_1
    x4 = 1 / x3
    x5 = A_u_2 * x4
    x6 = A_u_1 * x5
    x7 = np.conj(A_u_1)
    x8 = A_u_1 * A_u_1
    x9 = x7 * x8
    x10 = omega_1 * x3
    x11 = 1j / x10
    x12 = x7 * x7
    x13 = x11 * x12
    x14 = -1 / 2 * alpha_1 * alpha_2
    x15 = alpha_2 * alpha_6
    x16 = alpha_3 * alpha_5
    x17 = x16 / 12
    x18 = x1 * x11
    x19 = x12 * x7
    x20 = x11 * x19
    x21 = 1 / 2 * omega_1
    x22 = alpha_4 * alpha_7
    x23 = x1 * x1
    x24 = x11 * x23
    x25 = A_u_2 * A_u_2
    x26 = A_u_1 * x25
    x27 = 1 / 8 * alpha_2
    x28 = x1 * x25
    x29 = 1 / 16 * alpha_6
    x30 = alpha_4 * alpha_5
    x31 = A_u_2 * x18
    x32 = A_u_1 * x8
    x33 = x8 * x8
    x34 = alpha_1 * alpha_1
    x35 = alpha_3 * alpha_3
    x36 = alpha_2 * alpha_2
    x37 = alpha_6 * x7
    x38 = alpha_5 * alpha_8
    x39 = mu_2 * mu_2
    x40 = A_u_2 * x25
    x41 = alpha_8 * alpha_8
    x42 = alpha_6 * alpha_6
    x43 = alpha_7 * alpha_7
    # Outputs
    out[..., 0] = (
        A_u_1 * A_u_2 * x20 * (-x14 - 5 * x15 / 24 - 7 * x16 / 24)
        + A_u_1 * mu_1 * x0 * (-1 / 2 * 1j * mu_1 - omega_1)
        + alpha_1 * x4 * x9 * (-3 / 2 * mu_1 - 3 / 2 * x2)
        + alpha_2 * x12 * x5 * (1j * (1 / 4 * sigma - x21) - 1 / 4 * mu_1 - 1 / 4 * mu_2)
        + alpha_3 * x1 * x6 * (-mu_2 - x2) + x13 * x28 * (9 / 16 * alpha_1 * alpha_4 + 5 / 16
        * alpha_2 * alpha_3 - 3 / 16 * alpha_3 * alpha_7 - 9 / 32 * alpha_4 * alpha_6 - alpha_8
        * x27) + x13 * x32 * (-29 * alpha_2 * alpha_5 / 48 - 15 / 16 * x34)
        + x18 * x33 * (-x14 - 1 / 16 * x15 - x17)
        + x24 * x26 * (3 / 4 * alpha_2 * alpha_4 - 99 * x22 / 160 - 15 / 32 * x35) + x31 * x9 * (19
        * x36 / 24 - 3 / 2 * alpha_1 * alpha_3 - 3 / 8 * alpha_2 * alpha_7 - alpha_3 * x29 - 9 / 8
        * x30)
    )
    out[..., 1] = (
        A_u_2 * x0 * (1j * (omega_1 * sigma - x39 / 6) - mu_2 * omega_1) + A_u_2 * x13 * x8 * (11
        * alpha_2 * alpha_5 / 48 - 1 / 4 * alpha_5 * alpha_7 - 25 * x42 / 864)
        + alpha_5 * x32 * x4 * (mu_2 / 36 + 1j * (sigma / 36 - omega_1 / 6) - mu_1 / 12)
        + alpha_8 * x28 * x4 * (1j * (sigma / 6 - x21) - mu_2 / 6) + x18 * x26 * x7 * (alpha_3
        * alpha_6 / 48 + alpha_7 * x27 + 3 / 8 * x30 - alpha_6 * alpha_8 / 18 - 11 * x43 / 80) + x20
        * x25 * (alpha_1 * alpha_7 / 48 + x16 / 48 + x38 / 72 - 1 / 32 * alpha_6 * alpha_7 - x15
        / 36) + x24 * x40 * (91 * x22 / 480 - 5 * x41 / 144) + x31 * x32 * (alpha_1 * alpha_7 / 24
        + alpha_2 * alpha_6 / 24 - alpha_7 * x29 - x17 - x38 / 36)
        + x37 * x6 * (1j * (sigma / 9 - omega_1 / 3) - mu_1 / 9)
        - 31 * alpha_5 * x11 * x33 * x37 / 432
    )


def _coefficients(
    out, sigma, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4, alpha_5, alpha_6, alpha_7,
    alpha_8,
):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = 1 / 2 * omega_1
    x3 = 1 / 8 * alpha_2
    x4 = omega_1 * x0
    x5 = 1j / x4
    x6 = 1 / omega_1
    x7 = 1j * omega_1
    x8 = alpha_4 * alpha_7
    x9 = alpha_3 * alpha_3
    x10 = -1 / 2 * alpha_1 * alpha_2
    x11 = alpha_2 * alpha_6
    x12 = alpha_3 * alpha_5
    x13 = alpha_3 * alpha_6
    x14 = alpha_4 * alpha_5
    x15 = alpha_2 * alpha_2
    x16 = alpha_1 * alpha_1
    x17 = x12 / 12
    x18 = mu_2 * mu_2
    x19 = alpha_8 * alpha_8
    x20 = alpha_5 * alpha_8
    x21 = alpha_6 * alpha_7
    x22 = alpha_7 * alpha_7
    x23 = alpha_6 * alpha_6
    # Outputs
    out[..., 0] = alpha_2 * x1 * (1j * (1 / 4 * sigma - x2) - 1 / 4 * mu_1 - 1 / 4 * mu_2)
    out[..., 1] = (
        x5 * (9 / 16 * alpha_1 * alpha_4 + 5 / 16 * alpha_2 * alpha_3 - 3 / 16 * alpha_3 * alpha_7
        - 9 / 32 * alpha_4 * alpha_6 - alpha_8 * x3)
    )
    out[..., 2] = mu_1 * x6 * (-1 / 2 * 1j * mu_1 - omega_1)
    out[..., 3] = alpha_3 * x1 * (-mu_2 - x7)
    out[..., 4] = x5 * (3 / 4 * alpha_2 * alpha_4 - 99 * x8 / 160 - 15 / 32 * x9)
    out[..., 5] = x5 * (-x10 - 5 * x11 / 24 - 7 * x12 / 24)
    out[..., 6] = alpha_1 * x1 * (-3 / 2 * mu_1 - 3 / 2 * x7)
    out[..., 7] = (
        x5 * (19 * x15 / 24 - 3 / 2 * alpha_1 * alpha_3 - 3 / 8 * alpha_2 * alpha_7 - 1 / 16 * x13
        - 9 / 8 * x14)
    )
    out[..., 8] = x5 * (-29 * alpha_2 * alpha_5 / 48 - 15 / 16 * x16)
    out[..., 9] = x5 * (-x10 - 1 / 16 * x11 - x17)
    out[..., 10] = x6 * (1j * (omega_1 * sigma - x18 / 6) - mu_2 * omega_1)
    out[..., 11] = alpha_8 * x1 * (1j * (sigma / 6 - x2) - mu_2 / 6)
    out[..., 12] = x5 * (91 * x8 / 480 - 5 * x19 / 144)
    out[..., 13] = x5 * (alpha_1 * alpha_7 / 48 + x12 / 48 + x20 / 72 - x11 / 36 - 1 / 32 * x21)
    out[..., 14] = alpha_6 * x1 * (1j * (sigma / 9 - omega_1 / 3) - mu_1 / 9)
    out[..., 15] = (
        x5 * (alpha_7 * x3 + x13 / 48 + 3 / 8 * x14 - alpha_6 * alpha_8 / 18 - 11 * x22 / 80)
    )
    out[..., 16] = x5 * (11 * alpha_2 * alpha_5 / 48 - 1 / 4 * alpha_5 * alpha_7 - 25 * x23 / 864)
    out[..., 17] = alpha_5 * x1 * (mu_2 / 36 + 1j * (sigma / 36 - omega_1 / 6) - mu_1 / 12)
    out[..., 18] = (
        x5 * (alpha_1 * alpha_7 / 24 + alpha_2 * alpha_6 / 24 - x17 - x20 / 36 - 1 / 16 * x21)
    )
    out[..., 19] = -31 * alpha_5 * alpha_6 * x5 / 432


def _backbone(
    out, sigma, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4, alpha_5, alpha_6, alpha_7,
    alpha_8,
):
    # Intermediates
    x0 = -sigma
    x1 = omega_1 * omega_1
    x2 = 1j / x1
    x3 = 1 / 8 * alpha_2
    x4 = omega_1 * x1
    x5 = 1j / x4
    x6 = 1j / omega_1
    x7 = mu_1 * mu_1
    x8 = alpha_4 * alpha_7
    x9 = alpha_3 * alpha_3
    x10 = -1 / 2 * alpha_1 * alpha_2
    x11 = alpha_2 * alpha_6
    x12 = alpha_3 * alpha_5
    x13 = 3 / 2 * alpha_1
    x14 = alpha_3 * alpha_6
    x15 = alpha_4 * alpha_5
    x16 = alpha_2 * alpha_2
    x17 = alpha_1 * alpha_1
    x18 = x12 / 12
    x19 = mu_2 * mu_2
    x20 = x2 * (3 * omega_1 + x0)
    x21 = alpha_8 * alpha_8
    x22 = alpha_5 * alpha_8
    x23 = alpha_6 * alpha_7
    x24 = alpha_7 * alpha_7
    x25 = alpha_6 * alpha_6
    # Outputs
    out[..., 0] = -1 / 4 * alpha_2 * x2 * (2 * omega_1 + x0)
    out[..., 1] = (
        x5 * (9 / 16 * alpha_1 * alpha_4 + 5 / 16 * alpha_2 * alpha_3 - 3 / 16 * alpha_3 * alpha_7
        - 9 / 32 * alpha_4 * alpha_6 - alpha_8 * x3)
    )
    out[..., 2] = -1 / 2 * x6 * x7
    out[..., 3] = -alpha_3 * x6
    out[..., 4] = x5 * (3 / 4 * alpha_2 * alpha_4 - 99 * x8 / 160 - 15 / 32 * x9)
    out[..., 5] = x5 * (-x10 - 5 * x11 / 24 - 7 * x12 / 24)
    out[..., 6] = -x13 * x6
    out[..., 7] = (
        x5 * (19 * x16 / 24 - 3 / 8 * alpha_2 * alpha_7 - alpha_3 * x13 - 1 / 16 * x14
        - 9 / 8 * x15)
    )
    out[..., 8] = x5 * (-29 * alpha_2 * alpha_5 / 48 - 15 / 16 * x17)
    out[..., 9] = x5 * (-x10 - 1 / 16 * x11 - x18)
    out[..., 10] = x6 * (omega_1 * sigma - x19 / 6)
    out[..., 11] = -alpha_8 * x20 / 6
    out[..., 12] = x5 * (91 * x8 / 480 - 5 * x21 / 144)
    out[..., 13] = x5 * (alpha_1 * alpha_7 / 48 + x12 / 48 + x22 / 72 - x11 / 36 - 1 / 32 * x23)
    out[..., 14] = -alpha_6 * x20 / 9
    out[..., 15] = (
        x5 * (alpha_7 * x3 + x14 / 48 + 3 / 8 * x15 - alpha_6 * alpha_8 / 18 - 11 * x24 / 80)
    )
    out[..., 16] = x5 * (11 * alpha_2 * alpha_5 / 48 - 1 / 4 * alpha_5 * alpha_7 - 25 * x25 / 864)
    out[..., 17] = -alpha_5 * x2 * (6 * omega_1 + x0) / 36
    out[..., 18] = (
        x5 * (alpha_1 * alpha_7 / 24 + alpha_2 * alpha_6 / 24 - x18 - x22 / 36 - 1 / 16 * x23)
    )
    out[..., 19] = -31 * alpha_5 * alpha_6 * x5 / 432


def _motion(
    out, sigma, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4, alpha_5, alpha_6, alpha_7,
    alpha_8,
):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = alpha_4 * x1
    x3 = alpha_3 * x1
    x4 = alpha_2 * x1
    x5 = 1 / 4 * x1
    x6 = alpha_7 * x1
    x7 = 9 / 32 * sigma
    x8 = 9 / 32 * mu_1
    x9 = omega_1 * x0
    x10 = 1 / x9
    x11 = 2 * x10
    x12 = alpha_4 * x11
    x13 = x0 * x0
    x14 = 1 / x13
    x15 = alpha_4 * x14
    x16 = 1j * mu_2
    x17 = alpha_3 * x11
    x18 = alpha_2 * alpha_4
    x19 = alpha_3 * alpha_8
    x20 = alpha_4 * alpha_7
    x21 = 2 * x14
    x22 = alpha_3 * alpha_3
    x23 = 3 / 16 * sigma
    x24 = alpha_2 * x11
    x25 = alpha_2 * alpha_8
    x26 = alpha_3 * alpha_7
    x27 = alpha_4 * alpha_6
    x28 = alpha_1 * alpha_4
    x29 = alpha_2 * alpha_3
    x30 = alpha_1 * alpha_3
    x31 = alpha_2 * alpha_7
    x32 = alpha_3 * alpha_6
    x33 = alpha_4 * alpha_5
    x34 = 3 / 64 * x33
    x35 = alpha_2 * alpha_2
    x36 = alpha_2 * alpha_6
    x37 = alpha_3 * alpha_5
    x38 = 1j * mu_1
    x39 = alpha_2 * alpha_5
    x40 = alpha_1 * alpha_1
    x41 = alpha_8 * alpha_8
    x42 = alpha_7 * x11
    x43 = alpha_7 * alpha_8
    x44 = 1 / 16 * mu_1
    x45 = alpha_6 * alpha_8
    x46 = alpha_7 * alpha_7
    x47 = alpha_6 * x11
    x48 = alpha_5 * alpha_8
    x49 = alpha_6 * alpha_7
    x50 = alpha_1 * alpha_7
    x51 = alpha_1 * alpha_6
    x52 = alpha_5 * alpha_7
    x53 = alpha_6 * alpha_6
    x54 = 18 * alpha_1
    x55 = alpha_5 * x14
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = -3 / 4 * x2
    out[..., 3] = -x2 / 40
    out[..., 4] = -x3 / 12
    out[..., 5] = -x3 / 24
    out[..., 6] = -1 / 2 * x4
    out[..., 7] = -x4 / 12
    out[..., 8] = -alpha_1 * x5
    out[..., 9] = -alpha_8 * x1 / 36
    out[..., 10] = -1 / 8 * x6
    out[..., 11] = 1 / 2 * x6
    out[..., 12] = -x6 / 20
    out[..., 13] = alpha_6 * x5
    out[..., 14] = -1 / 8 * alpha_6 * x1
    out[..., 15] = 3 / 4 * alpha_5 * x1
    out[..., 16] = x12 * (x7 + 1j * (27 / 32 * mu_2 - x8))
    out[..., 17] = x12 * (27 * sigma / 3200 + 1j * (27 * mu_2 / 3200 - 9 * mu_1 / 3200))
    out[..., 18] = 13 * x15 * (21 * alpha_3 - 20 * alpha_8) / 960
    out[..., 19] = x15 * (96 * alpha_3 - 61 * alpha_8) / 9600
    out[..., 20] = x15 * (3 * alpha_3 + 10 * alpha_8) / 26880
    out[..., 21] = x17 * (5 * sigma / 144 - 5 * x16 / 144)
    out[..., 22] = x21 * (x18 / 4800 + x19 / 4320 + x20 / 640 + x22 / 2880)
    out[..., 23] = x21 * (31 * x18 / 960 + x22 / 48 - 7 * x19 / 432 - 1 / 64 * x20)
    out[..., 24] = x17 * (7 * sigma / 576 + 7 * x16 / 576)
    out[..., 25] = x21 * (31 * alpha_2 * alpha_4 / 1920 - 19 * x19 / 3456 - x20 / 80 - x22 / 192)
    out[..., 26] = x21 * (x18 / 6720 + x19 / 6048 + x20 / 2240 + x22 / 8064)
    out[..., 27] = x24 * (x23 + 1j * (3 / 16 * mu_1 + 3 / 16 * mu_2))
    out[..., 28] = (
        x21 * (9 / 32 * alpha_1 * alpha_4 + 7 / 64 * alpha_2 * alpha_3 - 3 / 32 * x25
        - 33 * x26 / 320 - 3 / 32 * x27)
    )
    out[..., 29] = (
        x21 * (x25 / 2880 + 7 * x26 / 3200 + 3 * x28 / 3200 + 3 * x29 / 640 - 9 * x27 / 3200)
    )
    out[..., 30] = x21 * (x25 / 3456 + x26 / 384 + x28 / 1280 - 1 / 128 * x27 - x29 / 768)
    out[..., 31] = x24 * (5 * sigma / 288 + 1j * (5 * mu_1 / 288 + 5 * mu_2 / 288))
    out[..., 32] = x21 * (3 / 64 * alpha_1 * alpha_4 - 5 * x25 / 576 - 3 * x26 / 160 - x29 / 48)
    out[..., 33] = x21 * (x25 / 8640 + x26 / 2400 + x27 / 640 + x28 / 3200 + x29 / 1440)
    out[..., 34] = x21 * (5 / 128 * x30 + x31 / 160 + x35 / 288 - 19 * x32 / 864 - x34)
    out[..., 35] = (
        x21 * (3 * alpha_2 * alpha_7 / 1280 + 7 * x35 / 576 - 1 / 256 * x30 - 5 * x32 / 3456
        - 3 / 128 * x33)
    )
    out[..., 36] = x21 * (1 / 16 * alpha_1 * alpha_2 - 9 / 128 * x36 - 3 / 16 * x37)
    out[..., 37] = 3 / 8 * alpha_1 * x10 * x38
    out[..., 38] = x21 * (1 / 32 * x30 + 1 / 128 * x31 + x34 - 1 / 32 * x32 - 3 / 32 * x35)
    out[..., 39] = x21 * (5 * x35 / 48 - 1 / 4 * x30 - 1 / 32 * x31 - 1 / 64 * x32 - 3 / 32 * x33)
    out[..., 40] = x21 * (3 * x30 / 1280 + x31 / 3200 + x32 / 640 + x35 / 960 - 9 * x33 / 6400)
    out[..., 41] = x21 * (-x36 / 1728 - x37 / 27)
    out[..., 42] = x21 * (1 / 128 * alpha_1 * alpha_2 + x36 / 768 - 7 * x37 / 3456)
    out[..., 43] = x21 * (-5 / 64 * x39 - 21 / 64 * x40)
    out[..., 44] = x21 * (1 / 64 * x40 - 5 * x39 / 1728)
    out[..., 45] = alpha_8 * x11 * (sigma / 108 + x16 / 144)
    out[..., 46] = x21 * (x20 / 180 - 7 * x41 / 1728)
    out[..., 47] = x21 * (x20 / 17280 + x41 / 5184)
    out[..., 48] = x42 * (7 / 128 * sigma + 1j * (-5 / 128 * mu_1 - 5 / 128 * mu_2))
    out[..., 49] = x21 * (x26 / 2688 + x27 / 4480 + 31 * x43 / 16128)
    out[..., 50] = x42 * (1j * (1 / 16 * mu_2 + x44) - x23)
    out[..., 51] = x21 * (17 * x26 / 384 + 31 * x27 / 640 - 35 * x43 / 576)
    out[..., 52] = x42 * (11 * sigma / 800 + 1j * (7 * mu_1 / 800 + 7 * mu_2 / 800))
    out[..., 53] = x21 * (99 * alpha_7 * alpha_8 / 640 - 9 / 128 * x26 - 3 / 16 * x27)
    out[..., 54] = x21 * (31 * alpha_4 * alpha_6 / 1600 - 37 * x26 / 4800 - 83 * x43 / 3600)
    out[..., 55] = x21 * (x26 / 7680 + x27 / 6400 + 37 * x43 / 57600)
    out[..., 56] = x21 * (x31 / 288 + x32 / 576 + x33 / 960 + 7 * x46 / 2880 - x45 / 324)
    out[..., 57] = x47 * (-1 / 16 * sigma - 1j * x44)
    out[..., 58] = x21 * (x32 / 480 + 3 * x33 / 3200 + x46 / 320 - 7 * x31 / 1600 - 13 * x45 / 1440)
    out[..., 59] = x47 * (1 / 64 * sigma + 5 / 64 * x38)
    out[..., 60] = (
        x21 * (5 * x32 / 96 + 7 / 128 * x45 + 3 / 64 * x46 - 7 * x31 / 192 - 9 / 64 * x33)
    )
    out[..., 61] = (
        x21 * (19 * alpha_2 * alpha_7 / 768 + 9 / 128 * alpha_4 * alpha_5 - 29 * x32 / 384
        - 5 / 256 * x45 - 9 * x46 / 320)
    )
    out[..., 62] = x21 * (x31 / 2688 + x32 / 2688 + 3 * x33 / 8960 + 29 * x45 / 16128 + x46 / 2240)
    out[..., 63] = alpha_5 * x11 * (1j * (x8 - 3 / 32 * mu_2) - x7)
    out[..., 64] = (
        x21 * (15 / 256 * alpha_1 * alpha_7 + 5 / 256 * alpha_3 * alpha_5 - 1 / 128 * x36
        - 9 / 128 * x48 - 31 * x49 / 960)
    )
    out[..., 65] = (
        x21 * (9 / 32 * alpha_5 * alpha_8 + 7 / 64 * alpha_6 * alpha_7 - 5 * x36 / 48 - 3 / 32 * x37
        - 3 / 32 * x50)
    )
    out[..., 66] = x21 * (7 * x36 / 480 + x37 / 160 + x49 / 9600 - 9 * x48 / 320 - 21 * x50 / 1600)
    out[..., 67] = x21 * (x36 / 864 + x37 / 1152 + x49 / 480 + x50 / 576 - x48 / 576)
    out[..., 68] = x21 * (1 / 16 * x51 + 5 * x52 / 48 + x53 / 48 - 3 / 16 * x39)
    out[..., 69] = x21 * (1 / 16 * alpha_2 * alpha_5 - 13 / 128 * x51 - 23 * x52 / 384 - x53 / 192)
    out[..., 70] = -x55 * (x54 - 13 * alpha_6) / 48
    out[..., 71] = x21 * (3 / 64 * alpha_2 * alpha_5 + 1 / 64 * x53 - 1 / 32 * x51 - x52 / 96)
    out[..., 72] = x21 * (x39 / 320 + x51 / 160 + x53 / 640 - 7 * x52 / 2400)
    out[..., 73] = x55 * (x54 - 5 * alpha_6) / 384
    out[..., 74] = omega_1
    out[..., 75] = 3 * omega_1


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike,
    mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike, alpha_4: ArrayLike,
    alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike, alpha_8: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, omega_2 = 3*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Cubic term 1, 1/(m^2 s^2), real.
    alpha_2 : array_like
        Cubic term 2, 1/(m^2 s^2), real.
    alpha_3 : array_like
        Cubic term 3, 1/(m^2 s^2), real.
    alpha_4 : array_like
        Cubic term 4, 1/(m^2 s^2), real.
    alpha_5 : array_like
        Cubic term 5, 1/(m^2 s^2), real.
    alpha_6 : array_like
        Cubic term 6, 1/(m^2 s^2), real.
    alpha_7 : array_like
        Cubic term 7, 1/(m^2 s^2), real.
    alpha_8 : array_like
        Cubic term 8, 1/(m^2 s^2), real.

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
        PARAMETERS, sigma=sigma, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2, alpha_1=alpha_1,
        alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5, alpha_6=alpha_6,
        alpha_7=alpha_7, alpha_8=alpha_8,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))


def equilibria(
    *, sigma: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike,
    alpha_2: ArrayLike, alpha_3: ArrayLike, alpha_4: ArrayLike, alpha_5: ArrayLike,
    alpha_6: ArrayLike, alpha_7: ArrayLike, alpha_8: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN. B_j exp(i k_j θ) moves along a circle of
    further ones for k = (1, 3); of each circle one point is given, and the rate at which it drifts,
    B_j exp(i k_j ρ t).

    Parameters
    ----------
    sigma : array_like
        Detuning, omega_2 = 3*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Cubic term 1, 1/(m^2 s^2), real.
    alpha_2 : array_like
        Cubic term 2, 1/(m^2 s^2), real.
    alpha_3 : array_like
        Cubic term 3, 1/(m^2 s^2), real.
    alpha_4 : array_like
        Cubic term 4, 1/(m^2 s^2), real.
    alpha_5 : array_like
        Cubic term 5, 1/(m^2 s^2), real.
    alpha_6 : array_like
        Cubic term 6, 1/(m^2 s^2), real.
    alpha_7 : array_like
        Cubic term 7, 1/(m^2 s^2), real.
    alpha_8 : array_like
        Cubic term 8, 1/(m^2 s^2), real.
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
        PARAMETERS, sigma=sigma, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2, alpha_1=alpha_1,
        alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5, alpha_6=alpha_6,
        alpha_7=alpha_7, alpha_8=alpha_8,
    )
    return equilibria_at(
        equilibria_of_many,
        _FLOW,
        _coefficients,
        arguments,
        (
            "sigma", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "alpha_3", "alpha_4",
            "alpha_5", "alpha_6", "alpha_7", "alpha_8",
        )
        if gradient
        else (),
    )


def frequency_response(
    *, sigma: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike,
    alpha_2: ArrayLike, alpha_3: ArrayLike, alpha_4: ArrayLike, alpha_5: ArrayLike,
    alpha_6: ArrayLike, alpha_7: ArrayLike, alpha_8: ArrayLike, over: str = "sigma",
    gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega_2 = 3*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Cubic term 1, 1/(m^2 s^2), real.
    alpha_2 : array_like
        Cubic term 2, 1/(m^2 s^2), real.
    alpha_3 : array_like
        Cubic term 3, 1/(m^2 s^2), real.
    alpha_4 : array_like
        Cubic term 4, 1/(m^2 s^2), real.
    alpha_5 : array_like
        Cubic term 5, 1/(m^2 s^2), real.
    alpha_6 : array_like
        Cubic term 6, 1/(m^2 s^2), real.
    alpha_7 : array_like
        Cubic term 7, 1/(m^2 s^2), real.
    alpha_8 : array_like
        Cubic term 8, 1/(m^2 s^2), real.
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
        PARAMETERS, sigma=sigma, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2, alpha_1=alpha_1,
        alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5, alpha_6=alpha_6,
        alpha_7=alpha_7, alpha_8=alpha_8,
    )
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        (
            "sigma", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "alpha_3", "alpha_4",
            "alpha_5", "alpha_6", "alpha_7", "alpha_8",
        ),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike,
    mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike, alpha_4: ArrayLike,
    alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike, alpha_8: ArrayLike, of: str = "u_1",
) -> Any:
    """Free motions without damping in which one coordinate has a given amplitude.

    All periodic ones: normal modes, whose frequencies over the amplitude are the backbone curves of
    the responses. Forces and damping are left out.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    sigma : array_like
        Detuning, omega_2 = 3*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Cubic term 1, 1/(m^2 s^2), real.
    alpha_2 : array_like
        Cubic term 2, 1/(m^2 s^2), real.
    alpha_3 : array_like
        Cubic term 3, 1/(m^2 s^2), real.
    alpha_4 : array_like
        Cubic term 4, 1/(m^2 s^2), real.
    alpha_5 : array_like
        Cubic term 5, 1/(m^2 s^2), real.
    alpha_6 : array_like
        Cubic term 6, 1/(m^2 s^2), real.
    alpha_7 : array_like
        Cubic term 7, 1/(m^2 s^2), real.
    alpha_8 : array_like
        Cubic term 8, 1/(m^2 s^2), real.
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
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2, alpha_1=alpha_1,
        alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5, alpha_6=alpha_6,
        alpha_7=alpha_7, alpha_8=alpha_8,
    )
    return modes_at(_FREE, (), _backbone, arguments, amplitude, COORDINATES, of)


def jacobian(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike,
    mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike, alpha_4: ArrayLike,
    alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike, alpha_8: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`, turned along its symmetries so that the amplitudes given drift as
    little as they can; an equilibrium then is at rest.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, omega_2 = 3*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Cubic term 1, 1/(m^2 s^2), real.
    alpha_2 : array_like
        Cubic term 2, 1/(m^2 s^2), real.
    alpha_3 : array_like
        Cubic term 3, 1/(m^2 s^2), real.
    alpha_4 : array_like
        Cubic term 4, 1/(m^2 s^2), real.
    alpha_5 : array_like
        Cubic term 5, 1/(m^2 s^2), real.
    alpha_6 : array_like
        Cubic term 6, 1/(m^2 s^2), real.
    alpha_7 : array_like
        Cubic term 7, 1/(m^2 s^2), real.
    alpha_8 : array_like
        Cubic term 8, 1/(m^2 s^2), real.
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
        PARAMETERS, sigma=sigma, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2, alpha_1=alpha_1,
        alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5, alpha_6=alpha_6,
        alpha_7=alpha_7, alpha_8=alpha_8,
    )
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "alpha_3", "alpha_4",
            "alpha_5", "alpha_6", "alpha_7", "alpha_8",
        )
        if gradient
        else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike,
    mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike, alpha_4: ArrayLike,
    alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike, alpha_8: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t). Each symmetry that moves the point has
    a zero, which is left out.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, omega_2 = 3*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Cubic term 1, 1/(m^2 s^2), real.
    alpha_2 : array_like
        Cubic term 2, 1/(m^2 s^2), real.
    alpha_3 : array_like
        Cubic term 3, 1/(m^2 s^2), real.
    alpha_4 : array_like
        Cubic term 4, 1/(m^2 s^2), real.
    alpha_5 : array_like
        Cubic term 5, 1/(m^2 s^2), real.
    alpha_6 : array_like
        Cubic term 6, 1/(m^2 s^2), real.
    alpha_7 : array_like
        Cubic term 7, 1/(m^2 s^2), real.
    alpha_8 : array_like
        Cubic term 8, 1/(m^2 s^2), real.
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
        PARAMETERS, sigma=sigma, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2, alpha_1=alpha_1,
        alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5, alpha_6=alpha_6,
        alpha_7=alpha_7, alpha_8=alpha_8,
    )
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "alpha_3", "alpha_4",
            "alpha_5", "alpha_6", "alpha_7", "alpha_8",
        )
        if gradient
        else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike,
    mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike,
    alpha_4: ArrayLike, alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike,
    alpha_8: ArrayLike, order: int | None = None, drift: ArrayLike | None = None,
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
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, omega_2 = 3*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Cubic term 1, 1/(m^2 s^2), real.
    alpha_2 : array_like
        Cubic term 2, 1/(m^2 s^2), real.
    alpha_3 : array_like
        Cubic term 3, 1/(m^2 s^2), real.
    alpha_4 : array_like
        Cubic term 4, 1/(m^2 s^2), real.
    alpha_5 : array_like
        Cubic term 5, 1/(m^2 s^2), real.
    alpha_6 : array_like
        Cubic term 6, 1/(m^2 s^2), real.
    alpha_7 : array_like
        Cubic term 7, 1/(m^2 s^2), real.
    alpha_8 : array_like
        Cubic term 8, 1/(m^2 s^2), real.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
    drift : array_like, optional
        Of an equilibrium that drifts, shape (..., 1), rad/s: as `equilibria` gives it.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2), in the order u_1, u_2; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2, alpha_1=alpha_1,
        alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5, alpha_6=alpha_6,
        alpha_7=alpha_7, alpha_8=alpha_8,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        drift=drift,
        slow=(_FLOW, _coefficients, 12),
        names=(
            "sigma", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "alpha_3", "alpha_4",
            "alpha_5", "alpha_6", "alpha_7", "alpha_8",
        )
        if gradient
        else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike,
    mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike, alpha_4: ArrayLike,
    alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike, alpha_8: ArrayLike,
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
        Detuning, omega_2 = 3*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Cubic term 1, 1/(m^2 s^2), real.
    alpha_2 : array_like
        Cubic term 2, 1/(m^2 s^2), real.
    alpha_3 : array_like
        Cubic term 3, 1/(m^2 s^2), real.
    alpha_4 : array_like
        Cubic term 4, 1/(m^2 s^2), real.
    alpha_5 : array_like
        Cubic term 5, 1/(m^2 s^2), real.
    alpha_6 : array_like
        Cubic term 6, 1/(m^2 s^2), real.
    alpha_7 : array_like
        Cubic term 7, 1/(m^2 s^2), real.
    alpha_8 : array_like
        Cubic term 8, 1/(m^2 s^2), real.

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
        PARAMETERS, sigma=sigma, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2, alpha_1=alpha_1,
        alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5, alpha_6=alpha_6,
        alpha_7=alpha_7, alpha_8=alpha_8,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 12, False))
