# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_3.py: change that, not this file.
# Made from sha256 5a0e5188f4fba3da64d941ea155a445a27044f9713ccdc8740ef2548a4590bd2
# Operations for each point: slow_flow 297, coefficients 223, backbone 153, motion 580
"""internal_resonance_1_3: omega_2 = 3*omega_1 + sigma_1 and Omega = omega_2 + sigma_2, order 2.

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
RELATIONS: tuple[str, ...] = ("omega_2 = 3*omega_1 + sigma_1", "Omega = omega_2 + sigma_2")

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u_1", "u_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma_1": ("real", "rad/s", "detuning, omega_2 = 3*omega_1 + sigma_1"),
    "sigma_2": ("real", "rad/s", "detuning, Omega = omega_2 + sigma_2"),
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
    "F_1": ("nonnegative", "m/s^2", "force on the slower oscillator, over its mass"),
    "F_2": ("nonnegative", "m/s^2", "force on the faster oscillator, over its mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u_1": {"sigma_1": 1 / 3, "sigma_2": 1 / 3},
    "u_2": {"sigma_1": 1, "sigma_2": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    2,
    (
        (0, (0, 2, 0, 0, 0, 0)), (0, (0, 2, 0, 1, 0, 0)), (0, (0, 2, 0, 2, 1, 0)),
        (0, (1, 0, 0, 0, 0, 0)), (0, (1, 0, 0, 0, 1, 0)), (0, (1, 0, 0, 1, 0, 0)),
        (0, (1, 0, 0, 1, 1, 0)), (0, (1, 0, 0, 2, 2, 0)), (0, (1, 3, 0, 1, 0, 0)),
        (0, (2, 1, 0, 0, 0, 0)), (0, (2, 1, 0, 1, 1, 0)), (0, (3, 2, 0, 0, 0, 0)),
        (0, (4, 0, 0, 0, 1, 0)), (1, (0, 0, 0, 0, 0, 0)), (1, (0, 0, 0, 1, 0, 0)),
        (1, (0, 0, 0, 1, 1, 0)), (1, (0, 0, 0, 2, 0, 0)), (1, (0, 0, 0, 2, 1, 0)),
        (1, (0, 0, 0, 3, 2, 0)), (1, (0, 3, 0, 2, 0, 0)), (1, (1, 1, 0, 0, 0, 0)),
        (1, (1, 1, 0, 1, 0, 0)), (1, (1, 1, 0, 2, 1, 0)), (1, (2, 2, 0, 1, 0, 0)),
        (1, (3, 0, 0, 0, 0, 0)), (1, (3, 0, 0, 1, 1, 0)), (1, (4, 1, 0, 0, 0, 0)),
    ),
    (),
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
        (0, 0, (1, 0, 0, 0, 0, 0), (0,)), (0, 1, (0, 0, 0, 1, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 0, 0, 0), (1,)), (1, 0, (0, 0, 0, 2, 1, 0), (0,)),
        (1, 0, (0, 0, 0, 3, 0, 0), (0,)), (1, 0, (1, 0, 0, 0, 2, 0), (0,)),
        (1, 0, (1, 0, 0, 2, 0, 0), (0,)), (1, 0, (1, 1, 0, 1, 0, 0), (0,)),
        (1, 0, (2, 0, 0, 1, 0, 0), (0,)), (1, 0, (3, 0, 0, 0, 0, 0), (0,)),
        (1, 1, (0, 0, 0, 3, 0, 0), (0,)), (1, 1, (1, 0, 0, 0, 2, 0), (0,)),
        (1, 1, (1, 0, 0, 1, 1, 0), (0,)), (1, 1, (1, 0, 0, 2, 0, 0), (0,)),
        (1, 1, (2, 0, 0, 0, 1, 0), (0,)), (1, 1, (2, 0, 0, 1, 0, 0), (0,)),
        (1, 1, (2, 1, 0, 0, 0, 0), (0,)), (2, 0, (0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 1, 1, 0), (1,)), (2, 0, (0, 0, 0, 2, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 2, 0, 0), (1,)), (2, 0, (0, 0, 0, 2, 1, 0), (0,)),
        (2, 0, (0, 0, 0, 3, 0, 0), (0,)), (2, 0, (0, 0, 0, 3, 2, 0), (0,)),
        (2, 0, (0, 0, 0, 4, 1, 0), (0,)), (2, 0, (0, 0, 0, 5, 0, 0), (0,)),
        (2, 0, (1, 0, 0, 0, 1, 0), (-1,)), (2, 0, (1, 0, 0, 0, 2, 0), (0,)),
        (2, 0, (1, 0, 0, 0, 4, 0), (0,)), (2, 0, (1, 0, 0, 1, 0, 0), (1,)),
        (2, 0, (1, 0, 0, 1, 3, 0), (0,)), (2, 0, (1, 0, 0, 2, 0, 0), (0,)),
        (2, 0, (1, 0, 0, 3, 1, 0), (0,)), (2, 0, (1, 0, 0, 4, 0, 0), (0,)),
        (2, 0, (1, 1, 0, 0, 0, 0), (1,)), (2, 0, (1, 1, 0, 1, 0, 0), (0,)),
        (2, 0, (1, 1, 0, 2, 1, 0), (0,)), (2, 0, (1, 1, 0, 3, 0, 0), (0,)),
        (2, 0, (2, 0, 0, 0, 0, 0), (1,)), (2, 0, (2, 0, 0, 0, 3, 0), (0,)),
        (2, 0, (2, 0, 0, 1, 0, 0), (0,)), (2, 0, (2, 0, 0, 2, 1, 0), (0,)),
        (2, 0, (2, 0, 0, 3, 0, 0), (0,)), (2, 0, (2, 1, 0, 0, 2, 0), (0,)),
        (2, 0, (2, 1, 0, 2, 0, 0), (0,)), (2, 0, (2, 2, 0, 1, 0, 0), (0,)),
        (2, 0, (3, 0, 0, 0, 0, 0), (0,)), (2, 0, (3, 0, 0, 0, 2, 0), (0,)),
        (2, 0, (3, 0, 0, 1, 1, 0), (0,)), (2, 0, (3, 0, 0, 2, 0, 0), (0,)),
        (2, 0, (3, 1, 0, 1, 0, 0), (0,)), (2, 0, (4, 0, 0, 1, 0, 0), (0,)),
        (2, 0, (4, 1, 0, 0, 0, 0), (0,)), (2, 0, (5, 0, 0, 0, 0, 0), (0,)),
        (2, 1, (0, 0, 0, 2, 0, 0), (1,)), (2, 1, (0, 0, 0, 3, 0, 0), (0,)),
        (2, 1, (0, 0, 0, 4, 1, 0), (0,)), (2, 1, (0, 0, 0, 5, 0, 0), (0,)),
        (2, 1, (1, 0, 0, 0, 1, 0), (-1,)), (2, 1, (1, 0, 0, 0, 1, 0), (1,)),
        (2, 1, (1, 0, 0, 0, 2, 0), (0,)), (2, 1, (1, 0, 0, 0, 4, 0), (0,)),
        (2, 1, (1, 0, 0, 1, 0, 0), (-1,)), (2, 1, (1, 0, 0, 1, 0, 0), (1,)),
        (2, 1, (1, 0, 0, 1, 1, 0), (0,)), (2, 1, (1, 0, 0, 1, 3, 0), (0,)),
        (2, 1, (1, 0, 0, 2, 0, 0), (0,)), (2, 1, (1, 0, 0, 2, 2, 0), (0,)),
        (2, 1, (1, 0, 0, 3, 1, 0), (0,)), (2, 1, (1, 0, 0, 4, 0, 0), (0,)),
        (2, 1, (1, 1, 0, 3, 0, 0), (0,)), (2, 1, (2, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (2, 0, 0, 0, 0, 0), (1,)), (2, 1, (2, 0, 0, 0, 1, 0), (0,)),
        (2, 1, (2, 0, 0, 0, 3, 0), (0,)), (2, 1, (2, 0, 0, 1, 0, 0), (0,)),
        (2, 1, (2, 0, 0, 1, 2, 0), (0,)), (2, 1, (2, 0, 0, 2, 1, 0), (0,)),
        (2, 1, (2, 0, 0, 3, 0, 0), (0,)), (2, 1, (2, 1, 0, 0, 0, 0), (0,)),
        (2, 1, (2, 1, 0, 0, 2, 0), (0,)), (2, 1, (2, 1, 0, 1, 1, 0), (0,)),
        (2, 1, (2, 1, 0, 2, 0, 0), (0,)), (2, 1, (3, 0, 0, 2, 0, 0), (0,)),
        (2, 1, (3, 1, 0, 0, 1, 0), (0,)), (2, 1, (3, 1, 0, 1, 0, 0), (0,)),
        (2, 1, (3, 2, 0, 0, 0, 0), (0,)), (2, 1, (4, 0, 0, 0, 1, 0), (0,)),
        (2, 1, (4, 0, 0, 1, 0, 0), (0,)), (2, 1, (5, 0, 0, 0, 0, 0), (0,)),
    ),
    1,
)


def _slow_flow(
    out, A_u_1, A_u_2, sigma_1, sigma_2, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4,
    alpha_5, alpha_6, alpha_7, alpha_8, F_1, F_2,
):
    # Intermediates
    x0 = 1j * A_u_1
    x1 = 1 / omega_1
    x2 = 1 / 16 * alpha_2
    x3 = F_1 * x2
    x4 = F_2 * alpha_3 / 24
    x5 = omega_1 * omega_1
    x6 = omega_1 * x5
    x7 = 1 / x6
    x8 = x0 * x7
    x9 = A_u_2 * x8
    x10 = np.conj(A_u_2)
    x11 = x10 * x8
    x12 = 1j * omega_1
    x13 = 1 / x5
    x14 = A_u_2 * x13
    x15 = A_u_1 * x14
    x16 = 1j * x7
    x17 = np.conj(A_u_1)
    x18 = x17 * x17
    x19 = x16 * x18
    x20 = A_u_1 * A_u_1
    x21 = x17 * x20
    x22 = -1 / 2 * alpha_1 * alpha_2
    x23 = alpha_3 * alpha_5
    x24 = x23 / 12
    x25 = x20 * x20
    x26 = x16 * x25
    x27 = alpha_2 * alpha_6
    x28 = 1 / 2 * omega_1
    x29 = alpha_4 * alpha_7
    x30 = 1 / 8 * alpha_2
    x31 = A_u_2 * A_u_2
    x32 = x10 * x31
    x33 = 1 / 16 * alpha_6
    x34 = alpha_4 * alpha_5
    x35 = 1j * A_u_2
    x36 = x35 * x7
    x37 = x10 * x36
    x38 = A_u_1 * x20
    x39 = x17 * x18
    x40 = x10 * x10
    x41 = alpha_1 * alpha_1
    x42 = alpha_2 * alpha_2
    x43 = alpha_3 * alpha_3
    x44 = alpha_6 * x17
    x45 = F_1 * alpha_7
    x46 = F_2 * alpha_8
    x47 = x16 * x31
    x48 = alpha_5 * alpha_8
    x49 = mu_2 * mu_2
    x50 = alpha_7 * alpha_7
    x51 = alpha_6 * alpha_6
    x52 = A_u_2 * x31
    x53 = alpha_8 * alpha_8
    # Outputs
    out[..., 0] = (
        A_u_1 * mu_1 * x1 * (-1 / 2 * 1j * mu_1 - omega_1)
        + alpha_1 * x13 * x21 * (-3 / 2 * mu_1 - 3 / 2 * x12)
        + alpha_2 * x14 * x18 * (1j * (1 / 4 * sigma_1 - x28) - 1 / 4 * mu_1 - 1 / 4 * mu_2)
        + alpha_3 * x10 * x15 * (-mu_2 - x12) + x10 * x26 * (-alpha_6 * x2 - x22 - x24)
        + x11 * (x3 - x4) + x19 * x32 * (9 / 16 * alpha_1 * alpha_4 + 5 / 16 * alpha_2 * alpha_3 - 3
        / 16 * alpha_3 * alpha_7 - 9 / 32 * alpha_4 * alpha_6 - alpha_8 * x30)
        + x19 * x38 * (-29 * alpha_2 * alpha_5 / 48 - 15 / 16 * x41)
        + x19 * (3 / 32 * F_1 * alpha_1 - F_2 * alpha_2 / 48) + x21 * x37 * (19 * x42 / 24 - 3 / 2
        * alpha_1 * alpha_3 - 3 / 8 * alpha_2 * alpha_7 - alpha_3 * x33 - 9 / 8 * x34)
        + x31 * x40 * x8 * (3 / 4 * alpha_2 * alpha_4 - 99 * x29 / 160 - 15 / 32 * x43)
        + x39 * x9 * (-x22 - 7 * x23 / 24 - 5 * x27 / 24) + x9 * (x3 + x4)
        - x0 * (sigma_1 / 3 + sigma_2 / 3)
    )
    out[..., 1] = (
        A_u_2 * x1 * (1j * (omega_1 * sigma_1 - x49 / 6) - mu_2 * omega_1)
        + F_2 * x13 * (mu_2 / 72 + 1j * (sigma_1 / 36 + sigma_2 / 72 - omega_1 / 12))
        + alpha_5 * x13 * x38 * (mu_2 / 36 + 1j * (sigma_1 / 36 - omega_1 / 6) - mu_1 / 12)
        + alpha_8 * x13 * x32 * (1j * (sigma_1 / 6 - x28) - mu_2 / 6) + x11 * x17 * x31 * (alpha_3
        * alpha_6 / 48 + alpha_7 * x30 + 3 / 8 * x34 - alpha_6 * alpha_8 / 18 - 11 * x50 / 80)
        + x15 * x44 * (1j * (sigma_1 / 9 - omega_1 / 3) - mu_1 / 9)
        + x16 * x40 * x52 * (91 * x29 / 480 - 5 * x53 / 144)
        + x17 * x8 * (1 / 16 * F_1 * alpha_5 - F_2 * alpha_6 / 216) + x18 * x20 * x36 * (11
        * alpha_2 * alpha_5 / 48 - 1 / 4 * alpha_5 * alpha_7 - 25 * x51 / 864) + x37 * x38
        * (alpha_1 * alpha_7 / 24 + alpha_2 * alpha_6 / 24 - alpha_7 * x33 - x24 - x48 / 36)
        + x37 * (x45 / 48 - x46 / 72) + x39 * x47 * (alpha_1 * alpha_7 / 48 + x23 / 48 + x48 / 72
        - 1 / 32 * alpha_6 * alpha_7 - x27 / 36) + x47 * (x45 / 96 + x46 / 144)
        - 31 * alpha_5 * x26 * x44 / 432 - x35 * (sigma_1 + sigma_2)
    )


def _coefficients(
    out, sigma_1, sigma_2, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4, alpha_5,
    alpha_6, alpha_7, alpha_8, F_1, F_2,
):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = omega_1 * x0
    x2 = 1j / x1
    x3 = 1 / x0
    x4 = 1 / 2 * omega_1
    x5 = 1 / 8 * alpha_2
    x6 = 1 / omega_1
    x7 = 1 / 16 * alpha_2
    x8 = F_1 * x7
    x9 = F_2 * alpha_3 / 24
    x10 = 1j * omega_1
    x11 = alpha_4 * alpha_7
    x12 = alpha_3 * alpha_3
    x13 = -1 / 2 * alpha_1 * alpha_2
    x14 = alpha_2 * alpha_6
    x15 = alpha_3 * alpha_5
    x16 = alpha_3 * alpha_6
    x17 = alpha_4 * alpha_5
    x18 = alpha_2 * alpha_2
    x19 = alpha_1 * alpha_1
    x20 = x15 / 12
    x21 = mu_2 * mu_2
    x22 = F_1 * alpha_7
    x23 = F_2 * alpha_8
    x24 = alpha_8 * alpha_8
    x25 = alpha_5 * alpha_8
    x26 = alpha_6 * alpha_7
    x27 = alpha_7 * alpha_7
    x28 = alpha_6 * alpha_6
    # Outputs
    out[..., 0] = x2 * (3 / 32 * F_1 * alpha_1 - F_2 * alpha_2 / 48)
    out[..., 1] = alpha_2 * x3 * (1j * (1 / 4 * sigma_1 - x4) - 1 / 4 * mu_1 - 1 / 4 * mu_2)
    out[..., 2] = (
        x2 * (9 / 16 * alpha_1 * alpha_4 + 5 / 16 * alpha_2 * alpha_3 - 3 / 16 * alpha_3 * alpha_7
        - 9 / 32 * alpha_4 * alpha_6 - alpha_8 * x5)
    )
    out[..., 3] = mu_1 * x6 * (-1 / 2 * 1j * mu_1 - omega_1) - 1j * (sigma_1 / 3 + sigma_2 / 3)
    out[..., 4] = x2 * (x8 - x9)
    out[..., 5] = x2 * (x8 + x9)
    out[..., 6] = alpha_3 * x3 * (-mu_2 - x10)
    out[..., 7] = x2 * (3 / 4 * alpha_2 * alpha_4 - 99 * x11 / 160 - 15 / 32 * x12)
    out[..., 8] = x2 * (-x13 - 5 * x14 / 24 - 7 * x15 / 24)
    out[..., 9] = alpha_1 * x3 * (-3 / 2 * mu_1 - 3 / 2 * x10)
    out[..., 10] = (
        x2 * (19 * x18 / 24 - 3 / 2 * alpha_1 * alpha_3 - 3 / 8 * alpha_2 * alpha_7 - 1 / 16 * x16
        - 9 / 8 * x17)
    )
    out[..., 11] = x2 * (-29 * alpha_2 * alpha_5 / 48 - 15 / 16 * x19)
    out[..., 12] = x2 * (-alpha_6 * x7 - x13 - x20)
    out[..., 13] = F_2 * x3 * (mu_2 / 72 + 1j * (sigma_1 / 36 + sigma_2 / 72 - omega_1 / 12))
    out[..., 14] = (
        x6 * (1j * (omega_1 * sigma_1 - x21 / 6) - mu_2 * omega_1) - 1j * (sigma_1 + sigma_2)
    )
    out[..., 15] = x2 * (x22 / 48 - x23 / 72)
    out[..., 16] = x2 * (x22 / 96 + x23 / 144)
    out[..., 17] = alpha_8 * x3 * (1j * (sigma_1 / 6 - x4) - mu_2 / 6)
    out[..., 18] = x2 * (91 * x11 / 480 - 5 * x24 / 144)
    out[..., 19] = x2 * (alpha_1 * alpha_7 / 48 + x15 / 48 + x25 / 72 - x14 / 36 - 1 / 32 * x26)
    out[..., 20] = x2 * (1 / 16 * F_1 * alpha_5 - F_2 * alpha_6 / 216)
    out[..., 21] = alpha_6 * x3 * (1j * (sigma_1 / 9 - omega_1 / 3) - mu_1 / 9)
    out[..., 22] = (
        x2 * (alpha_7 * x5 + x16 / 48 + 3 / 8 * x17 - alpha_6 * alpha_8 / 18 - 11 * x27 / 80)
    )
    out[..., 23] = x2 * (11 * alpha_2 * alpha_5 / 48 - 1 / 4 * alpha_5 * alpha_7 - 25 * x28 / 864)
    out[..., 24] = alpha_5 * x3 * (mu_2 / 36 + 1j * (sigma_1 / 36 - omega_1 / 6) - mu_1 / 12)
    out[..., 25] = (
        x2 * (alpha_1 * alpha_7 / 24 + alpha_2 * alpha_6 / 24 - x20 - x25 / 36 - 1 / 16 * x26)
    )
    out[..., 26] = -31 * alpha_5 * alpha_6 * x2 / 432


def _backbone(
    out, sigma_1, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4, alpha_5, alpha_6,
    alpha_7, alpha_8, F_1, F_2,
):
    # Intermediates
    x0 = -sigma_1
    x1 = omega_1 * omega_1
    x2 = 1j / x1
    x3 = 1 / 8 * alpha_2
    x4 = omega_1 * x1
    x5 = 1j / x4
    x6 = 1j * sigma_1
    x7 = 1 / omega_1
    x8 = 1j * x7
    x9 = mu_1 * mu_1
    x10 = alpha_4 * alpha_7
    x11 = alpha_3 * alpha_3
    x12 = -1 / 2 * alpha_1 * alpha_2
    x13 = alpha_2 * alpha_6
    x14 = alpha_3 * alpha_5
    x15 = 3 / 2 * alpha_1
    x16 = alpha_3 * alpha_6
    x17 = alpha_4 * alpha_5
    x18 = alpha_2 * alpha_2
    x19 = alpha_1 * alpha_1
    x20 = x14 / 12
    x21 = mu_2 * mu_2
    x22 = x2 * (3 * omega_1 + x0)
    x23 = alpha_8 * alpha_8
    x24 = alpha_5 * alpha_8
    x25 = alpha_6 * alpha_7
    x26 = alpha_7 * alpha_7
    x27 = alpha_6 * alpha_6
    # Outputs
    out[..., 0] = -1 / 4 * alpha_2 * x2 * (2 * omega_1 + x0)
    out[..., 1] = (
        x5 * (9 / 16 * alpha_1 * alpha_4 + 5 / 16 * alpha_2 * alpha_3 - 3 / 16 * alpha_3 * alpha_7
        - 9 / 32 * alpha_4 * alpha_6 - alpha_8 * x3)
    )
    out[..., 2] = -x6 / 3 - 1 / 2 * x8 * x9
    out[..., 3] = -alpha_3 * x8
    out[..., 4] = x5 * (3 / 4 * alpha_2 * alpha_4 - 99 * x10 / 160 - 15 / 32 * x11)
    out[..., 5] = x5 * (-x12 - 5 * x13 / 24 - 7 * x14 / 24)
    out[..., 6] = -x15 * x8
    out[..., 7] = (
        x5 * (19 * x18 / 24 - 3 / 8 * alpha_2 * alpha_7 - alpha_3 * x15 - 1 / 16 * x16
        - 9 / 8 * x17)
    )
    out[..., 8] = x5 * (-29 * alpha_2 * alpha_5 / 48 - 15 / 16 * x19)
    out[..., 9] = x5 * (-x12 - 1 / 16 * x13 - x20)
    out[..., 10] = 1j * x7 * (omega_1 * sigma_1 - x21 / 6) - x6
    out[..., 11] = -alpha_8 * x22 / 6
    out[..., 12] = x5 * (91 * x10 / 480 - 5 * x23 / 144)
    out[..., 13] = x5 * (alpha_1 * alpha_7 / 48 + x14 / 48 + x24 / 72 - x13 / 36 - 1 / 32 * x25)
    out[..., 14] = -alpha_6 * x22 / 9
    out[..., 15] = (
        x5 * (alpha_7 * x3 + x16 / 48 + 3 / 8 * x17 - alpha_6 * alpha_8 / 18 - 11 * x26 / 80)
    )
    out[..., 16] = x5 * (11 * alpha_2 * alpha_5 / 48 - 1 / 4 * alpha_5 * alpha_7 - 25 * x27 / 864)
    out[..., 17] = -alpha_5 * x2 * (6 * omega_1 + x0) / 36
    out[..., 18] = (
        x5 * (alpha_1 * alpha_7 / 24 + alpha_2 * alpha_6 / 24 - x20 - x24 / 36 - 1 / 16 * x25)
    )
    out[..., 19] = -31 * alpha_5 * alpha_6 * x5 / 432
    out[..., 20] = sigma_1 / 3
    out[..., 21] = sigma_1


def _motion(
    out, sigma_1, sigma_2, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4, alpha_5,
    alpha_6, alpha_7, alpha_8, F_1, F_2,
):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = 1 / 8 * x1
    x3 = alpha_4 * x1
    x4 = alpha_3 * x1
    x5 = alpha_2 * x1
    x6 = 1 / 4 * x1
    x7 = alpha_7 * x1
    x8 = 1j * mu_1
    x9 = omega_1 * x0
    x10 = 1 / x9
    x11 = 2 * x10
    x12 = F_1 * alpha_3
    x13 = F_2 * alpha_4
    x14 = x0 * x0
    x15 = 1 / x14
    x16 = 2 * x15
    x17 = 9 / 32 * sigma_1
    x18 = 9 / 32 * mu_1
    x19 = alpha_4 * x11
    x20 = alpha_4 * x15
    x21 = F_1 * alpha_2
    x22 = F_2 * alpha_3
    x23 = 1j * mu_2
    x24 = alpha_3 * x11
    x25 = alpha_2 * alpha_4
    x26 = alpha_3 * alpha_8
    x27 = alpha_4 * alpha_7
    x28 = alpha_3 * alpha_3
    x29 = F_1 * alpha_1
    x30 = F_2 * alpha_2
    x31 = 3 / 16 * sigma_1
    x32 = alpha_2 * x11
    x33 = alpha_2 * alpha_8
    x34 = alpha_3 * alpha_7
    x35 = alpha_4 * alpha_6
    x36 = alpha_1 * alpha_4
    x37 = alpha_2 * alpha_3
    x38 = alpha_1 * alpha_3
    x39 = alpha_2 * alpha_7
    x40 = alpha_3 * alpha_6
    x41 = alpha_4 * alpha_5
    x42 = 3 / 64 * x41
    x43 = alpha_2 * alpha_2
    x44 = alpha_2 * alpha_6
    x45 = alpha_3 * alpha_5
    x46 = alpha_2 * alpha_5
    x47 = alpha_1 * alpha_1
    x48 = alpha_8 * alpha_8
    x49 = F_1 * alpha_6
    x50 = F_2 * alpha_7
    x51 = 1 / 64 * x49
    x52 = x50 / 192
    x53 = alpha_7 * x11
    x54 = alpha_7 * alpha_8
    x55 = 1 / 16 * mu_1
    x56 = alpha_6 * alpha_8
    x57 = alpha_7 * alpha_7
    x58 = F_1 * alpha_5
    x59 = F_2 * alpha_6
    x60 = alpha_6 * x11
    x61 = alpha_5 * alpha_8
    x62 = alpha_6 * alpha_7
    x63 = alpha_1 * alpha_7
    x64 = alpha_1 * alpha_6
    x65 = alpha_5 * alpha_7
    x66 = alpha_6 * alpha_6
    x67 = 18 * alpha_1
    x68 = alpha_5 * x15
    x69 = 3 * omega_1 + sigma_1 + sigma_2
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = -F_1 * x2
    out[..., 3] = -3 / 4 * x3
    out[..., 4] = -x3 / 40
    out[..., 5] = -x4 / 12
    out[..., 6] = -x4 / 24
    out[..., 7] = -1 / 2 * x5
    out[..., 8] = -x5 / 12
    out[..., 9] = -alpha_1 * x6
    out[..., 10] = -alpha_8 * x1 / 36
    out[..., 11] = -alpha_7 * x2
    out[..., 12] = 1 / 2 * x7
    out[..., 13] = -x7 / 20
    out[..., 14] = alpha_6 * x6
    out[..., 15] = -alpha_6 * x2
    out[..., 16] = 3 / 4 * alpha_5 * x1
    out[..., 17] = F_1 * x11 * (3 / 64 * sigma_1 + 3 / 64 * sigma_2 - 3 / 64 * x8)
    out[..., 18] = x16 * (1 / 64 * x12 - 3 / 64 * x13)
    out[..., 19] = x16 * (1 / 128 * x12 + 3 / 128 * x13)
    out[..., 20] = x16 * (x12 / 1280 - 9 * x13 / 12800)
    out[..., 21] = x19 * (x17 + 1j * (27 / 32 * mu_2 - x18))
    out[..., 22] = x19 * (27 * sigma_1 / 3200 + 1j * (27 * mu_2 / 3200 - 9 * mu_1 / 3200))
    out[..., 23] = 13 * x20 * (21 * alpha_3 - 20 * alpha_8) / 960
    out[..., 24] = x20 * (96 * alpha_3 - 61 * alpha_8) / 9600
    out[..., 25] = x20 * (3 * alpha_3 + 10 * alpha_8) / 26880
    out[..., 26] = x16 * (x21 / 192 - 5 * x22 / 1728)
    out[..., 27] = x24 * (5 * sigma_1 / 144 - 5 * x23 / 144)
    out[..., 28] = x16 * (x25 / 4800 + x26 / 4320 + x27 / 640 + x28 / 2880)
    out[..., 29] = x16 * (x21 / 384 - 7 * x22 / 6912)
    out[..., 30] = x16 * (31 * x25 / 960 + x28 / 48 - 7 * x26 / 432 - 1 / 64 * x27)
    out[..., 31] = x24 * (7 * sigma_1 / 576 + 7 * x23 / 576)
    out[..., 32] = x16 * (31 * alpha_2 * alpha_4 / 1920 - 19 * x26 / 3456 - x27 / 80 - x28 / 192)
    out[..., 33] = x16 * (x25 / 6720 + x26 / 6048 + x27 / 2240 + x28 / 8064)
    out[..., 34] = x16 * (3 / 64 * x29 - 1 / 64 * x30)
    out[..., 35] = x32 * (x31 + 1j * (3 / 16 * mu_1 + 3 / 16 * mu_2))
    out[..., 36] = (
        x16 * (9 / 32 * alpha_1 * alpha_4 + 7 / 64 * alpha_2 * alpha_3 - 3 / 32 * x33
        - 33 * x34 / 320 - 3 / 32 * x35)
    )
    out[..., 37] = (
        x16 * (x33 / 2880 + 7 * x34 / 3200 + 3 * x36 / 3200 + 3 * x37 / 640 - 9 * x35 / 3200)
    )
    out[..., 38] = x16 * (1 / 128 * x29 - 5 * x30 / 3456)
    out[..., 39] = x16 * (x33 / 3456 + x34 / 384 + x36 / 1280 - 1 / 128 * x35 - x37 / 768)
    out[..., 40] = x32 * (5 * sigma_1 / 288 + 1j * (5 * mu_1 / 288 + 5 * mu_2 / 288))
    out[..., 41] = x16 * (3 / 64 * alpha_1 * alpha_4 - 5 * x33 / 576 - 3 * x34 / 160 - x37 / 48)
    out[..., 42] = x16 * (x33 / 8640 + x34 / 2400 + x35 / 640 + x36 / 3200 + x37 / 1440)
    out[..., 43] = x16 * (5 / 128 * x38 + x39 / 160 + x43 / 288 - 19 * x40 / 864 - x42)
    out[..., 44] = (
        x16 * (3 * alpha_2 * alpha_7 / 1280 + 7 * x43 / 576 - 1 / 256 * x38 - 5 * x40 / 3456
        - 3 / 128 * x41)
    )
    out[..., 45] = x16 * (1 / 16 * alpha_1 * alpha_2 - 9 / 128 * x44 - 3 / 16 * x45)
    out[..., 46] = 3 / 8 * alpha_1 * x10 * x8
    out[..., 47] = x16 * (1 / 32 * x38 + 1 / 128 * x39 + x42 - 1 / 32 * x40 - 3 / 32 * x43)
    out[..., 48] = x16 * (5 * x43 / 48 - 1 / 4 * x38 - 1 / 32 * x39 - 1 / 64 * x40 - 3 / 32 * x41)
    out[..., 49] = x16 * (3 * x38 / 1280 + x39 / 3200 + x40 / 640 + x43 / 960 - 9 * x41 / 6400)
    out[..., 50] = x16 * (-x44 / 1728 - x45 / 27)
    out[..., 51] = x16 * (1 / 128 * alpha_1 * alpha_2 + x44 / 768 - 7 * x45 / 3456)
    out[..., 52] = x16 * (-5 / 64 * x46 - 21 / 64 * x47)
    out[..., 53] = x16 * (1 / 64 * x47 - 5 * x46 / 1728)
    out[..., 54] = x16 * (F_1 * alpha_7 / 1152 - F_2 * alpha_8 / 1152)
    out[..., 55] = alpha_8 * x11 * (sigma_1 / 108 + x23 / 144)
    out[..., 56] = x16 * (x27 / 180 - 7 * x48 / 1728)
    out[..., 57] = x16 * (x27 / 17280 + x48 / 5184)
    out[..., 58] = x16 * (1 / 128 * x49 - 5 * x50 / 768)
    out[..., 59] = x16 * (-x51 - x52)
    out[..., 60] = x53 * (7 / 128 * sigma_1 + 1j * (-5 / 128 * mu_1 - 5 / 128 * mu_2))
    out[..., 61] = x16 * (x34 / 2688 + x35 / 4480 + 31 * x54 / 16128)
    out[..., 62] = x16 * (x52 - x51)
    out[..., 63] = x16 * (x49 / 320 - 7 * x50 / 4800)
    out[..., 64] = x53 * (1j * (1 / 16 * mu_2 + x55) - x31)
    out[..., 65] = x16 * (17 * x34 / 384 + 31 * x35 / 640 - 35 * x54 / 576)
    out[..., 66] = x53 * (11 * sigma_1 / 800 + 1j * (7 * mu_1 / 800 + 7 * mu_2 / 800))
    out[..., 67] = x16 * (99 * alpha_7 * alpha_8 / 640 - 9 / 128 * x34 - 3 / 16 * x35)
    out[..., 68] = x16 * (31 * alpha_4 * alpha_6 / 1600 - 37 * x34 / 4800 - 83 * x54 / 3600)
    out[..., 69] = x16 * (x34 / 7680 + x35 / 6400 + 37 * x54 / 57600)
    out[..., 70] = x16 * (x39 / 288 + x40 / 576 + x41 / 960 + 7 * x57 / 2880 - x56 / 324)
    out[..., 71] = x16 * (-3 / 128 * x58 - x59 / 384)
    out[..., 72] = x16 * (3 / 256 * x58 - 5 * x59 / 1536)
    out[..., 73] = x60 * (-1 / 16 * sigma_1 - 1j * x55)
    out[..., 74] = x16 * (x40 / 480 + 3 * x41 / 3200 + x57 / 320 - 7 * x39 / 1600 - 13 * x56 / 1440)
    out[..., 75] = x60 * (1 / 64 * sigma_1 + 5 / 64 * x8)
    out[..., 76] = (
        x16 * (5 * x40 / 96 + 7 / 128 * x56 + 3 / 64 * x57 - 7 * x39 / 192 - 9 / 64 * x41)
    )
    out[..., 77] = (
        x16 * (19 * alpha_2 * alpha_7 / 768 + 9 / 128 * alpha_4 * alpha_5 - 29 * x40 / 384
        - 5 / 256 * x56 - 9 * x57 / 320)
    )
    out[..., 78] = x16 * (x39 / 2688 + x40 / 2688 + 3 * x41 / 8960 + 29 * x56 / 16128 + x57 / 2240)
    out[..., 79] = alpha_5 * x11 * (1j * (x18 - 3 / 32 * mu_2) - x17)
    out[..., 80] = (
        x16 * (15 / 256 * alpha_1 * alpha_7 + 5 / 256 * alpha_3 * alpha_5 - 1 / 128 * x44
        - 9 / 128 * x61 - 31 * x62 / 960)
    )
    out[..., 81] = (
        x16 * (9 / 32 * alpha_5 * alpha_8 + 7 / 64 * alpha_6 * alpha_7 - 5 * x44 / 48 - 3 / 32 * x45
        - 3 / 32 * x63)
    )
    out[..., 82] = x16 * (7 * x44 / 480 + x45 / 160 + x62 / 9600 - 9 * x61 / 320 - 21 * x63 / 1600)
    out[..., 83] = x16 * (x44 / 864 + x45 / 1152 + x62 / 480 + x63 / 576 - x61 / 576)
    out[..., 84] = x16 * (1 / 16 * x64 + 5 * x65 / 48 + x66 / 48 - 3 / 16 * x46)
    out[..., 85] = x16 * (1 / 16 * alpha_2 * alpha_5 - 13 / 128 * x64 - 23 * x65 / 384 - x66 / 192)
    out[..., 86] = -x68 * (x67 - 13 * alpha_6) / 48
    out[..., 87] = x16 * (3 / 64 * alpha_2 * alpha_5 + 1 / 64 * x66 - 1 / 32 * x64 - x65 / 96)
    out[..., 88] = x16 * (x46 / 320 + x64 / 160 + x66 / 640 - 7 * x65 / 2400)
    out[..., 89] = x68 * (x67 - 5 * alpha_6) / 384
    out[..., 90] = omega_1 + sigma_1 / 3 + sigma_2 / 3
    out[..., 91] = x69
    out[..., 92] = x69


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike,
    alpha_4: ArrayLike, alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike,
    alpha_8: ArrayLike, F_1: ArrayLike, F_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma_1 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
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
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5,
        alpha_6=alpha_6, alpha_7=alpha_7, alpha_8=alpha_8, F_1=F_1, F_2=F_2,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))


def equilibria(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike, mu_2: ArrayLike,
    alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike, alpha_4: ArrayLike,
    alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike, alpha_8: ArrayLike, F_1: ArrayLike,
    F_2: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
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
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Equilibria
        The arrays amplitudes (..., count, 2), drift (..., count, 0) in rad/s and growth (...,
        count) in 1/s, which is negative where an equilibrium is stable. With gradient also name ->
        derivatives of amplitudes, drift and growth, NaN where equilibria meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5,
        alpha_6=alpha_6, alpha_7=alpha_7, alpha_8=alpha_8, F_1=F_1, F_2=F_2,
    )
    return equilibria_at(
        equilibria_of_many,
        _FLOW,
        _coefficients,
        arguments,
        (
            "sigma_1", "sigma_2", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "alpha_3",
            "alpha_4", "alpha_5", "alpha_6", "alpha_7", "alpha_8", "F_1", "F_2",
        )
        if gradient
        else (),
    )


def frequency_response(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike, mu_2: ArrayLike,
    alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike, alpha_4: ArrayLike,
    alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike, alpha_8: ArrayLike, F_1: ArrayLike,
    F_2: ArrayLike, over: str = "sigma_1", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
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
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5,
        alpha_6=alpha_6, alpha_7=alpha_7, alpha_8=alpha_8, F_1=F_1, F_2=F_2,
    )
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        (
            "sigma_1", "sigma_2", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "alpha_3",
            "alpha_4", "alpha_5", "alpha_6", "alpha_7", "alpha_8", "F_1", "F_2",
        ),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, sigma_1: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike,
    mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike, alpha_4: ArrayLike,
    alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike, alpha_8: ArrayLike, F_1: ArrayLike,
    F_2: ArrayLike, of: str = "u_1",
) -> Any:
    """Free motions without damping in which one coordinate has a given amplitude.

    All periodic ones: normal modes, whose frequencies over the amplitude are the backbone curves of
    the responses. Forces and damping are left out.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    sigma_1 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_1, rad/s, real.
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
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2, alpha_1=alpha_1,
        alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5, alpha_6=alpha_6,
        alpha_7=alpha_7, alpha_8=alpha_8, F_1=F_1, F_2=F_2,
    )
    return modes_at(
        _FREE,
        (0.3333333333333333, 1.0),
        _backbone,
        arguments,
        amplitude,
        COORDINATES,
        of,
    )


def jacobian(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike,
    alpha_4: ArrayLike, alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike,
    alpha_8: ArrayLike, F_1: ArrayLike, F_2: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma_1 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
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
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5,
        alpha_6=alpha_6, alpha_7=alpha_7, alpha_8=alpha_8, F_1=F_1, F_2=F_2,
    )
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma_1", "sigma_2", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "alpha_3",
            "alpha_4", "alpha_5", "alpha_6", "alpha_7", "alpha_8", "F_1", "F_2",
        )
        if gradient
        else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike,
    alpha_4: ArrayLike, alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike,
    alpha_8: ArrayLike, F_1: ArrayLike, F_2: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t).

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma_1 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
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
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5,
        alpha_6=alpha_6, alpha_7=alpha_7, alpha_8=alpha_8, F_1=F_1, F_2=F_2,
    )
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma_1", "sigma_2", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "alpha_3",
            "alpha_4", "alpha_5", "alpha_6", "alpha_7", "alpha_8", "F_1", "F_2",
        )
        if gradient
        else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike,
    omega_1: ArrayLike, mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike,
    alpha_3: ArrayLike, alpha_4: ArrayLike, alpha_5: ArrayLike, alpha_6: ArrayLike,
    alpha_7: ArrayLike, alpha_8: ArrayLike, F_1: ArrayLike, F_2: ArrayLike,
    order: int | None = None, gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. NaN where a harmonic resonates itself. Derivatives
    are taken with these fixed. Over times of order 1/ε the error is O(ε^2). A UserWarning says how
    much is left out where that is more than a tenth of the motion, estimated from the harmonics of
    each order beside those of order zero, and from the terms of the slow flow.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma_1 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
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
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5,
        alpha_6=alpha_6, alpha_7=alpha_7, alpha_8=alpha_8, F_1=F_1, F_2=F_2,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        slow=(_FLOW, _coefficients, 15),
        names=(
            "sigma_1", "sigma_2", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "alpha_3",
            "alpha_4", "alpha_5", "alpha_6", "alpha_7", "alpha_8", "F_1", "F_2",
        )
        if gradient
        else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike,
    alpha_4: ArrayLike, alpha_5: ArrayLike, alpha_6: ArrayLike, alpha_7: ArrayLike,
    alpha_8: ArrayLike, F_1: ArrayLike, F_2: ArrayLike,
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
    sigma_1 : array_like
        Detuning, omega_2 = 3*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
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
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, alpha_4=alpha_4, alpha_5=alpha_5,
        alpha_6=alpha_6, alpha_7=alpha_7, alpha_8=alpha_8, F_1=F_1, F_2=F_2,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 15, False))
