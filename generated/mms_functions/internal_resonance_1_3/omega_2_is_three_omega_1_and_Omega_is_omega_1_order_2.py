# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_3.py: change that, not this file.
# Made from sha256 bf017d00bc6543b4ba467876296d0308f97aad0db3870e32860542919dfa4f6c
# Operations for each point: slow_flow 298, coefficients 221, backbone 147, motion 575
"""internal_resonance_1_3: omega_2 = 3*omega_1 + sigma_1 and Omega = omega_1 + sigma_2, order 2.

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
RELATIONS: tuple[str, ...] = ("omega_2 = 3*omega_1 + sigma_1", "Omega = omega_1 + sigma_2")

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u_1", "u_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma_1": ("real", "rad/s", "detuning, omega_2 = 3*omega_1 + sigma_1"),
    "sigma_2": ("real", "rad/s", "detuning, Omega = omega_1 + sigma_2"),
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
    "u_1": {"sigma_2": 1},
    "u_2": {"sigma_2": 3},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    2,
    (
        (0, (0, 0, 0, 0, 0, 0)), (0, (0, 0, 0, 1, 1, 0)), (0, (0, 1, 0, 1, 0, 0)),
        (0, (0, 2, 0, 1, 0, 0)), (0, (0, 2, 0, 2, 1, 0)), (0, (1, 0, 0, 0, 0, 0)),
        (0, (1, 0, 0, 1, 1, 0)), (0, (1, 0, 0, 2, 2, 0)), (0, (1, 1, 0, 0, 0, 0)),
        (0, (1, 3, 0, 1, 0, 0)), (0, (2, 0, 0, 0, 0, 0)), (0, (2, 1, 0, 0, 0, 0)),
        (0, (2, 1, 0, 1, 1, 0)), (0, (3, 2, 0, 0, 0, 0)), (0, (4, 0, 0, 0, 1, 0)),
        (1, (0, 0, 0, 1, 0, 0)), (1, (0, 0, 0, 2, 1, 0)), (1, (0, 0, 0, 3, 2, 0)),
        (1, (0, 1, 0, 1, 0, 0)), (1, (0, 3, 0, 2, 0, 0)), (1, (1, 0, 0, 1, 0, 0)),
        (1, (1, 1, 0, 1, 0, 0)), (1, (1, 1, 0, 2, 1, 0)), (1, (2, 0, 0, 0, 0, 0)),
        (1, (2, 2, 0, 1, 0, 0)), (1, (3, 0, 0, 0, 0, 0)), (1, (3, 0, 0, 1, 1, 0)),
        (1, (4, 1, 0, 0, 0, 0)),
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
        (1, 0, (0, 0, 0, 2, 1, 0), (0,)), (1, 0, (0, 0, 0, 3, 0, 0), (0,)),
        (1, 0, (1, 0, 0, 0, 2, 0), (0,)), (1, 0, (1, 0, 0, 2, 0, 0), (0,)),
        (1, 0, (1, 1, 0, 1, 0, 0), (0,)), (1, 0, (2, 0, 0, 1, 0, 0), (0,)),
        (1, 0, (3, 0, 0, 0, 0, 0), (0,)), (1, 1, (0, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 3, 0, 0), (0,)), (1, 1, (1, 0, 0, 0, 2, 0), (0,)),
        (1, 1, (1, 0, 0, 1, 1, 0), (0,)), (1, 1, (1, 0, 0, 2, 0, 0), (0,)),
        (1, 1, (2, 0, 0, 0, 1, 0), (0,)), (1, 1, (2, 0, 0, 1, 0, 0), (0,)),
        (1, 1, (2, 1, 0, 0, 0, 0), (0,)), (2, 0, (0, 0, 0, 2, 0, 0), (-1,)),
        (2, 0, (0, 0, 0, 2, 0, 0), (1,)), (2, 0, (0, 0, 0, 2, 1, 0), (0,)),
        (2, 0, (0, 0, 0, 3, 0, 0), (0,)), (2, 0, (0, 0, 0, 3, 2, 0), (0,)),
        (2, 0, (0, 0, 0, 4, 1, 0), (0,)), (2, 0, (0, 0, 0, 5, 0, 0), (0,)),
        (2, 0, (1, 0, 0, 0, 1, 0), (-1,)), (2, 0, (1, 0, 0, 0, 2, 0), (0,)),
        (2, 0, (1, 0, 0, 0, 4, 0), (0,)), (2, 0, (1, 0, 0, 1, 0, 0), (-1,)),
        (2, 0, (1, 0, 0, 1, 0, 0), (1,)), (2, 0, (1, 0, 0, 1, 3, 0), (0,)),
        (2, 0, (1, 0, 0, 2, 0, 0), (0,)), (2, 0, (1, 0, 0, 3, 1, 0), (0,)),
        (2, 0, (1, 0, 0, 4, 0, 0), (0,)), (2, 0, (1, 1, 0, 1, 0, 0), (0,)),
        (2, 0, (1, 1, 0, 2, 1, 0), (0,)), (2, 0, (1, 1, 0, 3, 0, 0), (0,)),
        (2, 0, (2, 0, 0, 0, 0, 0), (1,)), (2, 0, (2, 0, 0, 0, 3, 0), (0,)),
        (2, 0, (2, 0, 0, 1, 0, 0), (0,)), (2, 0, (2, 0, 0, 2, 1, 0), (0,)),
        (2, 0, (2, 0, 0, 3, 0, 0), (0,)), (2, 0, (2, 1, 0, 0, 2, 0), (0,)),
        (2, 0, (2, 1, 0, 2, 0, 0), (0,)), (2, 0, (2, 2, 0, 1, 0, 0), (0,)),
        (2, 0, (3, 0, 0, 0, 0, 0), (0,)), (2, 0, (3, 0, 0, 0, 2, 0), (0,)),
        (2, 0, (3, 0, 0, 1, 1, 0), (0,)), (2, 0, (3, 0, 0, 2, 0, 0), (0,)),
        (2, 0, (3, 1, 0, 1, 0, 0), (0,)), (2, 0, (4, 0, 0, 1, 0, 0), (0,)),
        (2, 0, (4, 1, 0, 0, 0, 0), (0,)), (2, 0, (5, 0, 0, 0, 0, 0), (0,)),
        (2, 1, (0, 0, 0, 0, 0, 0), (1,)), (2, 1, (0, 0, 0, 1, 1, 0), (1,)),
        (2, 1, (0, 0, 0, 2, 0, 0), (-1,)), (2, 1, (0, 0, 0, 2, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 3, 0, 0), (0,)), (2, 1, (0, 0, 0, 4, 1, 0), (0,)),
        (2, 1, (0, 0, 0, 5, 0, 0), (0,)), (2, 1, (1, 0, 0, 0, 1, 0), (1,)),
        (2, 1, (1, 0, 0, 0, 2, 0), (0,)), (2, 1, (1, 0, 0, 0, 4, 0), (0,)),
        (2, 1, (1, 0, 0, 1, 0, 0), (1,)), (2, 1, (1, 0, 0, 1, 1, 0), (0,)),
        (2, 1, (1, 0, 0, 1, 3, 0), (0,)), (2, 1, (1, 0, 0, 2, 0, 0), (0,)),
        (2, 1, (1, 0, 0, 2, 2, 0), (0,)), (2, 1, (1, 0, 0, 3, 1, 0), (0,)),
        (2, 1, (1, 0, 0, 4, 0, 0), (0,)), (2, 1, (1, 1, 0, 0, 0, 0), (1,)),
        (2, 1, (1, 1, 0, 3, 0, 0), (0,)), (2, 1, (2, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (2, 0, 0, 0, 1, 0), (0,)), (2, 1, (2, 0, 0, 0, 3, 0), (0,)),
        (2, 1, (2, 0, 0, 1, 0, 0), (0,)), (2, 1, (2, 0, 0, 1, 2, 0), (0,)),
        (2, 1, (2, 0, 0, 2, 1, 0), (0,)), (2, 1, (2, 0, 0, 3, 0, 0), (0,)),
        (2, 1, (2, 1, 0, 0, 0, 0), (0,)), (2, 1, (2, 1, 0, 0, 2, 0), (0,)),
        (2, 1, (2, 1, 0, 1, 1, 0), (0,)), (2, 1, (2, 1, 0, 2, 0, 0), (0,)),
        (2, 1, (3, 0, 0, 2, 0, 0), (0,)), (2, 1, (3, 1, 0, 0, 1, 0), (0,)),
        (2, 1, (3, 1, 0, 1, 0, 0), (0,)), (2, 1, (3, 2, 0, 0, 0, 0), (0,)),
        (2, 1, (4, 0, 0, 0, 1, 0), (0,)), (2, 1, (4, 0, 0, 1, 0, 0), (0,)),
        (2, 1, (5, 0, 0, 0, 0, 0), (0,)),
    ),
    1,
)


def _slow_flow(
    out, A_u_1, A_u_2, sigma_1, sigma_2, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4,
    alpha_5, alpha_6, alpha_7, alpha_8, F_1, F_2,
):
    # Intermediates
    x0 = 1j * sigma_2
    x1 = 1 / omega_1
    x2 = F_1 * alpha_1
    x3 = F_2 * alpha_2
    x4 = omega_1 * omega_1
    x5 = omega_1 * x4
    x6 = 1j / x5
    x7 = A_u_1 * A_u_1
    x8 = x6 * x7
    x9 = np.conj(A_u_1)
    x10 = x6 * x9
    x11 = A_u_1 * x10
    x12 = 1 / 8 * F_1
    x13 = 1 / 16 * alpha_3
    x14 = A_u_2 * x10
    x15 = np.conj(A_u_2)
    x16 = x15 * x6
    x17 = A_u_2 * x16
    x18 = 1j * omega_1
    x19 = 1 / x4
    x20 = A_u_2 * x19
    x21 = A_u_1 * x20
    x22 = -1 / 2 * alpha_1 * alpha_2
    x23 = alpha_2 * alpha_6
    x24 = alpha_3 * alpha_5
    x25 = x24 / 12
    x26 = A_u_1 * x6
    x27 = A_u_2 * x26
    x28 = 1 / 2 * omega_1
    x29 = alpha_4 * alpha_7
    x30 = 1 / 8 * alpha_2
    x31 = alpha_4 * alpha_5
    x32 = A_u_2 * x8
    x33 = A_u_1 * x7
    x34 = x9 * x9
    x35 = x7 * x7
    x36 = x34 * x9
    x37 = A_u_2 * A_u_2
    x38 = x15 * x15
    x39 = alpha_2 * alpha_2
    x40 = alpha_1 * alpha_1
    x41 = alpha_3 * alpha_3
    x42 = F_1 * alpha_6 / 72
    x43 = alpha_7 / 48
    x44 = F_2 * x43
    x45 = x15 * x37
    x46 = alpha_5 * alpha_8
    x47 = alpha_6 * alpha_7
    x48 = mu_2 * mu_2
    x49 = alpha_6 * alpha_6
    x50 = alpha_7 * alpha_7
    x51 = A_u_2 * x37
    x52 = alpha_8 * alpha_8
    # Outputs
    out[..., 0] = (
        A_u_1 * mu_1 * x1 * (-1 / 2 * 1j * mu_1 - omega_1)
        + F_1 * x19 * (1 / 8 * mu_1 + 1j * (1 / 8 * sigma_2 - 1 / 4 * omega_1))
        + alpha_1 * x19 * x7 * x9 * (-3 / 2 * mu_1 - 3 / 2 * x18)
        + alpha_2 * x20 * x34 * (1j * (1 / 4 * sigma_1 - x28) - 1 / 4 * mu_1 - 1 / 4 * mu_2)
        + alpha_3 * x15 * x21 * (-mu_2 - x18) + x11 * (-3 / 8 * x2 - 1 / 16 * x3)
        + x14 * (alpha_2 * x12 - F_2 * x13) + x15 * x32 * x9 * (19 * x39 / 24 - 3 / 2 * alpha_1
        * alpha_3 - 3 / 8 * alpha_2 * alpha_7 - alpha_6 * x13 - 9 / 8 * x31) + x16 * x34 * x37 * (9
        / 16 * alpha_1 * alpha_4 + 5 / 16 * alpha_2 * alpha_3 - 3 / 16 * alpha_3 * alpha_7 - 9 / 32
        * alpha_4 * alpha_6 - alpha_8 * x30) + x16 * x35 * (-x22 - 1 / 16 * x23 - x25)
        + x17 * (-3 / 16 * F_2 * alpha_4 - alpha_3 * x12)
        + x26 * x37 * x38 * (3 / 4 * alpha_2 * alpha_4 - 99 * x29 / 160 - 15 / 32 * x41)
        + x27 * x36 * (-x22 - 5 * x23 / 24 - 7 * x24 / 24)
        + x33 * x34 * x6 * (-29 * alpha_2 * alpha_5 / 48 - 15 / 16 * x40)
        + x8 * (3 / 16 * x2 - 1 / 32 * x3) - A_u_1 * x0
    )
    out[..., 1] = (
        A_u_2 * x1 * (1j * (omega_1 * sigma_1 - x48 / 6) - mu_2 * omega_1)
        + alpha_5 * x19 * x33 * (mu_2 / 36 + 1j * (sigma_1 / 36 - omega_1 / 6) - mu_1 / 12)
        + alpha_6 * x21 * x9 * (1j * (sigma_1 / 9 - omega_1 / 3) - mu_1 / 9)
        + alpha_8 * x19 * x45 * (1j * (sigma_1 / 6 - x28) - mu_2 / 6) + x11 * x45 * (alpha_3
        * alpha_6 / 48 + alpha_7 * x30 + 3 / 8 * x31 - alpha_6 * alpha_8 / 18 - 11 * x50 / 80)
        + x14 * (-x42 - x44) + x17 * x33 * (alpha_1 * alpha_7 / 24 + alpha_2 * alpha_6 / 24 - x25
        - x46 / 36 - 1 / 16 * x47) + x27 * (x42 - x44)
        + x32 * x34 * (11 * alpha_2 * alpha_5 / 48 - 1 / 4 * alpha_5 * alpha_7 - 25 * x49 / 864)
        + x36 * x37 * x6 * (alpha_1 * x43 + x24 / 48 + x46 / 72 - x23 / 36 - 1 / 32 * x47)
        + x38 * x51 * x6 * (91 * x29 / 480 - 5 * x52 / 144)
        + x8 * (-F_1 * alpha_5 / 48 - F_2 * alpha_6 / 96) - 3 * A_u_2 * x0
        - 31 * alpha_5 * alpha_6 * x10 * x35 / 432
    )


def _coefficients(
    out, sigma_1, sigma_2, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4, alpha_5,
    alpha_6, alpha_7, alpha_8, F_1, F_2,
):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = 1 / 8 * F_1
    x3 = omega_1 * x0
    x4 = 1j / x3
    x5 = 1 / 16 * F_2
    x6 = 1 / 2 * omega_1
    x7 = 1 / 8 * alpha_2
    x8 = 1j * sigma_2
    x9 = 1 / omega_1
    x10 = 1j * omega_1
    x11 = alpha_4 * alpha_7
    x12 = alpha_3 * alpha_3
    x13 = F_1 * alpha_1
    x14 = -1 / 2 * alpha_1 * alpha_2
    x15 = alpha_2 * alpha_6
    x16 = alpha_3 * alpha_5
    x17 = alpha_3 * alpha_6
    x18 = alpha_4 * alpha_5
    x19 = alpha_2 * alpha_2
    x20 = alpha_1 * alpha_1
    x21 = x16 / 12
    x22 = mu_2 * mu_2
    x23 = alpha_8 * alpha_8
    x24 = F_1 * alpha_6 / 72
    x25 = alpha_7 / 48
    x26 = F_2 * x25
    x27 = alpha_5 * alpha_8
    x28 = alpha_6 * alpha_7
    x29 = alpha_7 * alpha_7
    x30 = alpha_6 * alpha_6
    # Outputs
    out[..., 0] = F_1 * x1 * (1 / 8 * mu_1 + 1j * (1 / 8 * sigma_2 - 1 / 4 * omega_1))
    out[..., 1] = x4 * (-3 / 16 * F_2 * alpha_4 - alpha_3 * x2)
    out[..., 2] = x4 * (alpha_2 * x2 - alpha_3 * x5)
    out[..., 3] = alpha_2 * x1 * (1j * (1 / 4 * sigma_1 - x6) - 1 / 4 * mu_1 - 1 / 4 * mu_2)
    out[..., 4] = (
        x4 * (9 / 16 * alpha_1 * alpha_4 + 5 / 16 * alpha_2 * alpha_3 - 3 / 16 * alpha_3 * alpha_7
        - 9 / 32 * alpha_4 * alpha_6 - alpha_8 * x7)
    )
    out[..., 5] = mu_1 * x9 * (-1 / 2 * 1j * mu_1 - omega_1) - x8
    out[..., 6] = alpha_3 * x1 * (-mu_2 - x10)
    out[..., 7] = x4 * (3 / 4 * alpha_2 * alpha_4 - 99 * x11 / 160 - 15 / 32 * x12)
    out[..., 8] = x4 * (-alpha_2 * x5 - 3 / 8 * x13)
    out[..., 9] = x4 * (-x14 - 5 * x15 / 24 - 7 * x16 / 24)
    out[..., 10] = x4 * (3 / 16 * x13 - 1 / 32 * F_2 * alpha_2)
    out[..., 11] = alpha_1 * x1 * (-3 / 2 * mu_1 - 3 / 2 * x10)
    out[..., 12] = (
        x4 * (19 * x19 / 24 - 3 / 2 * alpha_1 * alpha_3 - 3 / 8 * alpha_2 * alpha_7 - 1 / 16 * x17
        - 9 / 8 * x18)
    )
    out[..., 13] = x4 * (-29 * alpha_2 * alpha_5 / 48 - 15 / 16 * x20)
    out[..., 14] = x4 * (-x14 - 1 / 16 * x15 - x21)
    out[..., 15] = x9 * (1j * (omega_1 * sigma_1 - x22 / 6) - mu_2 * omega_1) - 3 * x8
    out[..., 16] = alpha_8 * x1 * (1j * (sigma_1 / 6 - x6) - mu_2 / 6)
    out[..., 17] = x4 * (91 * x11 / 480 - 5 * x23 / 144)
    out[..., 18] = x4 * (-x24 - x26)
    out[..., 19] = x4 * (alpha_1 * x25 + x16 / 48 + x27 / 72 - x15 / 36 - 1 / 32 * x28)
    out[..., 20] = x4 * (x24 - x26)
    out[..., 21] = alpha_6 * x1 * (1j * (sigma_1 / 9 - omega_1 / 3) - mu_1 / 9)
    out[..., 22] = (
        x4 * (alpha_7 * x7 + x17 / 48 + 3 / 8 * x18 - alpha_6 * alpha_8 / 18 - 11 * x29 / 80)
    )
    out[..., 23] = x4 * (-F_1 * alpha_5 / 48 - F_2 * alpha_6 / 96)
    out[..., 24] = x4 * (11 * alpha_2 * alpha_5 / 48 - 1 / 4 * alpha_5 * alpha_7 - 25 * x30 / 864)
    out[..., 25] = alpha_5 * x1 * (mu_2 / 36 + 1j * (sigma_1 / 36 - omega_1 / 6) - mu_1 / 12)
    out[..., 26] = (
        x4 * (alpha_1 * alpha_7 / 24 + alpha_2 * alpha_6 / 24 - x21 - x27 / 36 - 1 / 16 * x28)
    )
    out[..., 27] = -31 * alpha_5 * alpha_6 * x4 / 432


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
    out[..., 10] = x6 * (omega_1 * sigma_1 - x19 / 6)
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
    out, sigma_1, sigma_2, omega_1, mu_1, mu_2, alpha_1, alpha_2, alpha_3, alpha_4, alpha_5,
    alpha_6, alpha_7, alpha_8, F_1, F_2,
):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = alpha_4 * x1
    x3 = alpha_3 * x1
    x4 = alpha_2 * x1
    x5 = 1 / 4 * x1
    x6 = 1 / 8 * x1
    x7 = alpha_7 * x1
    x8 = F_1 * alpha_3
    x9 = F_2 * alpha_4
    x10 = x0 * x0
    x11 = 1 / x10
    x12 = 2 * x11
    x13 = 9 / 32 * sigma_1
    x14 = 9 / 32 * mu_1
    x15 = omega_1 * x0
    x16 = 1 / x15
    x17 = 2 * x16
    x18 = alpha_4 * x17
    x19 = alpha_4 * x11
    x20 = F_1 * alpha_2
    x21 = 3 / 64 * x20
    x22 = F_2 * alpha_3
    x23 = 1 / 64 * x22
    x24 = 1j * mu_2
    x25 = alpha_3 * x17
    x26 = alpha_2 * alpha_4
    x27 = alpha_3 * alpha_8
    x28 = alpha_4 * alpha_7
    x29 = alpha_3 * alpha_3
    x30 = 3 / 16 * sigma_1
    x31 = alpha_2 * x17
    x32 = alpha_2 * alpha_8
    x33 = alpha_3 * alpha_7
    x34 = alpha_4 * alpha_6
    x35 = alpha_1 * alpha_4
    x36 = alpha_2 * alpha_3
    x37 = 1 / 128 * alpha_2
    x38 = alpha_1 * alpha_3
    x39 = alpha_2 * alpha_7
    x40 = alpha_3 * alpha_6
    x41 = alpha_4 * alpha_5
    x42 = 3 / 64 * x41
    x43 = alpha_2 * alpha_2
    x44 = alpha_2 * alpha_6
    x45 = alpha_3 * alpha_5
    x46 = 1j * mu_1
    x47 = alpha_2 * alpha_5
    x48 = alpha_1 * alpha_1
    x49 = F_1 * alpha_7
    x50 = F_2 * alpha_8
    x51 = alpha_8 * alpha_8
    x52 = F_1 * alpha_6
    x53 = F_2 * alpha_7
    x54 = alpha_7 * x17
    x55 = alpha_7 * alpha_8
    x56 = 1 / 16 * mu_1
    x57 = F_1 * alpha_5
    x58 = alpha_6 * alpha_8
    x59 = alpha_7 * alpha_7
    x60 = alpha_6 * x17
    x61 = alpha_5 * alpha_8
    x62 = alpha_6 * alpha_7
    x63 = alpha_1 * alpha_7
    x64 = alpha_5 * alpha_7
    x65 = alpha_6 * alpha_6
    x66 = alpha_1 * alpha_6
    x67 = 18 * alpha_1
    x68 = alpha_5 * x11
    x69 = omega_1 + sigma_2
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
    out[..., 9] = F_2 * x6
    out[..., 10] = -alpha_8 * x1 / 36
    out[..., 11] = -alpha_7 * x6
    out[..., 12] = 1 / 2 * x7
    out[..., 13] = -x7 / 20
    out[..., 14] = alpha_6 * x5
    out[..., 15] = -alpha_6 * x6
    out[..., 16] = 3 / 4 * alpha_5 * x1
    out[..., 17] = x12 * (5 * x8 / 1152 - 1 / 128 * x9)
    out[..., 18] = x12 * (-7 * x8 / 4608 - 1 / 256 * x9)
    out[..., 19] = x18 * (x13 + 1j * (27 / 32 * mu_2 - x14))
    out[..., 20] = x18 * (27 * sigma_1 / 3200 + 1j * (27 * mu_2 / 3200 - 9 * mu_1 / 3200))
    out[..., 21] = 13 * x19 * (21 * alpha_3 - 20 * alpha_8) / 960
    out[..., 22] = x19 * (96 * alpha_3 - 61 * alpha_8) / 9600
    out[..., 23] = x19 * (3 * alpha_3 + 10 * alpha_8) / 26880
    out[..., 24] = x12 * (-x21 - x23)
    out[..., 25] = x25 * (5 * sigma_1 / 144 - 5 * x24 / 144)
    out[..., 26] = x12 * (x26 / 4800 + x27 / 4320 + x28 / 640 + x29 / 2880)
    out[..., 27] = x12 * (x21 - x23)
    out[..., 28] = x12 * (-5 * x20 / 576 - x22 / 192)
    out[..., 29] = x12 * (31 * x26 / 960 + x29 / 48 - 7 * x27 / 432 - 1 / 64 * x28)
    out[..., 30] = x25 * (7 * sigma_1 / 576 + 7 * x24 / 576)
    out[..., 31] = x12 * (31 * alpha_2 * alpha_4 / 1920 - 19 * x27 / 3456 - x28 / 80 - x29 / 192)
    out[..., 32] = x12 * (x26 / 6720 + x27 / 6048 + x28 / 2240 + x29 / 8064)
    out[..., 33] = x31 * (x30 + 1j * (3 / 16 * mu_1 + 3 / 16 * mu_2))
    out[..., 34] = (
        x12 * (9 / 32 * alpha_1 * alpha_4 + 7 / 64 * alpha_2 * alpha_3 - 3 / 32 * x32
        - 33 * x33 / 320 - 3 / 32 * x34)
    )
    out[..., 35] = (
        x12 * (x32 / 2880 + 7 * x33 / 3200 + 3 * x35 / 3200 + 3 * x36 / 640 - 9 * x34 / 3200)
    )
    out[..., 36] = x12 * (-9 / 128 * F_1 * alpha_1 - F_2 * x37)
    out[..., 37] = x12 * (x32 / 3456 + x33 / 384 + x35 / 1280 - 1 / 128 * x34 - x36 / 768)
    out[..., 38] = x31 * (5 * sigma_1 / 288 + 1j * (5 * mu_1 / 288 + 5 * mu_2 / 288))
    out[..., 39] = x12 * (3 / 64 * alpha_1 * alpha_4 - 5 * x32 / 576 - 3 * x33 / 160 - x36 / 48)
    out[..., 40] = x12 * (x32 / 8640 + x33 / 2400 + x34 / 640 + x35 / 3200 + x36 / 1440)
    out[..., 41] = x12 * (5 / 128 * x38 + x39 / 160 + x43 / 288 - 19 * x40 / 864 - x42)
    out[..., 42] = (
        x12 * (3 * alpha_2 * alpha_7 / 1280 + 7 * x43 / 576 - 1 / 256 * x38 - 5 * x40 / 3456
        - 3 / 128 * x41)
    )
    out[..., 43] = x12 * (1 / 16 * alpha_1 * alpha_2 - 9 / 128 * x44 - 3 / 16 * x45)
    out[..., 44] = 3 / 8 * alpha_1 * x16 * x46
    out[..., 45] = x12 * (alpha_7 * x37 + 1 / 32 * x38 + x42 - 1 / 32 * x40 - 3 / 32 * x43)
    out[..., 46] = x12 * (5 * x43 / 48 - 1 / 4 * x38 - 1 / 32 * x39 - 1 / 64 * x40 - 3 / 32 * x41)
    out[..., 47] = x12 * (3 * x38 / 1280 + x39 / 3200 + x40 / 640 + x43 / 960 - 9 * x41 / 6400)
    out[..., 48] = x12 * (-x44 / 1728 - x45 / 27)
    out[..., 49] = x12 * (alpha_1 * x37 + x44 / 768 - 7 * x45 / 3456)
    out[..., 50] = x12 * (-5 / 64 * x47 - 21 / 64 * x48)
    out[..., 51] = x12 * (1 / 64 * x48 - 5 * x47 / 1728)
    out[..., 52] = F_2 * x17 * (1 / 64 * sigma_2 - 3 / 64 * sigma_1 - 1 / 64 * x24)
    out[..., 53] = x12 * (3 / 64 * F_2 * alpha_8 - 1 / 64 * x49)
    out[..., 54] = x12 * (5 / 512 * x49 - 3 / 256 * x50)
    out[..., 55] = x12 * (-7 * x49 / 3200 - 3 * x50 / 640)
    out[..., 56] = alpha_8 * x17 * (sigma_1 / 108 + x24 / 144)
    out[..., 57] = x12 * (x28 / 180 - 7 * x51 / 1728)
    out[..., 58] = x12 * (x28 / 17280 + x51 / 5184)
    out[..., 59] = x12 * (1 / 64 * x52 + 1 / 64 * x53)
    out[..., 60] = x54 * (7 / 128 * sigma_1 + 1j * (-5 / 128 * mu_1 - 5 / 128 * mu_2))
    out[..., 61] = x12 * (x33 / 2688 + x34 / 4480 + 31 * x55 / 16128)
    out[..., 62] = x12 * (-5 / 256 * x52 - 1 / 128 * x53)
    out[..., 63] = x54 * (1j * (1 / 16 * mu_2 + x56) - x30)
    out[..., 64] = x12 * (17 * x33 / 384 + 31 * x34 / 640 - 35 * x55 / 576)
    out[..., 65] = x54 * (11 * sigma_1 / 800 + 1j * (7 * mu_1 / 800 + 7 * mu_2 / 800))
    out[..., 66] = x12 * (99 * alpha_7 * alpha_8 / 640 - 9 / 128 * x33 - 3 / 16 * x34)
    out[..., 67] = x12 * (31 * alpha_4 * alpha_6 / 1600 - 37 * x33 / 4800 - 83 * x55 / 3600)
    out[..., 68] = x12 * (x33 / 7680 + x34 / 6400 + 37 * x55 / 57600)
    out[..., 69] = x12 * (1 / 64 * F_2 * alpha_6 - 3 / 64 * x57)
    out[..., 70] = x12 * (x39 / 288 + x40 / 576 + x41 / 960 + 7 * x59 / 2880 - x58 / 324)
    out[..., 71] = x12 * (1 / 128 * F_2 * alpha_6 + 3 / 128 * x57)
    out[..., 72] = x60 * (-1 / 16 * sigma_1 - 1j * x56)
    out[..., 73] = x12 * (x40 / 480 + 3 * x41 / 3200 + x59 / 320 - 7 * x39 / 1600 - 13 * x58 / 1440)
    out[..., 74] = x60 * (1 / 64 * sigma_1 + 5 / 64 * x46)
    out[..., 75] = (
        x12 * (5 * x40 / 96 + 7 / 128 * x58 + 3 / 64 * x59 - 7 * x39 / 192 - 9 / 64 * x41)
    )
    out[..., 76] = (
        x12 * (19 * alpha_2 * alpha_7 / 768 + 9 / 128 * alpha_4 * alpha_5 - 29 * x40 / 384
        - 5 / 256 * x58 - 9 * x59 / 320)
    )
    out[..., 77] = x12 * (x39 / 2688 + x40 / 2688 + 3 * x41 / 8960 + 29 * x58 / 16128 + x59 / 2240)
    out[..., 78] = alpha_5 * x17 * (1j * (x14 - 3 / 32 * mu_2) - x13)
    out[..., 79] = (
        x12 * (15 / 256 * alpha_1 * alpha_7 + 5 / 256 * alpha_3 * alpha_5 - alpha_6 * x37
        - 9 / 128 * x61 - 31 * x62 / 960)
    )
    out[..., 80] = (
        x12 * (9 / 32 * alpha_5 * alpha_8 + 7 / 64 * alpha_6 * alpha_7 - 5 * x44 / 48 - 3 / 32 * x45
        - 3 / 32 * x63)
    )
    out[..., 81] = x12 * (7 * x44 / 480 + x45 / 160 + x62 / 9600 - 9 * x61 / 320 - 21 * x63 / 1600)
    out[..., 82] = x12 * (x44 / 864 + x45 / 1152 + x62 / 480 + x63 / 576 - x61 / 576)
    out[..., 83] = x12 * (1 / 16 * alpha_1 * alpha_6 + 5 * x64 / 48 + x65 / 48 - 3 / 16 * x47)
    out[..., 84] = x12 * (1 / 16 * alpha_2 * alpha_5 - 23 * x64 / 384 - x65 / 192 - 13 / 128 * x66)
    out[..., 85] = -x68 * (x67 - 13 * alpha_6) / 48
    out[..., 86] = x12 * (3 / 64 * alpha_2 * alpha_5 + 1 / 64 * x65 - x64 / 96 - 1 / 32 * x66)
    out[..., 87] = x12 * (x47 / 320 + x65 / 640 + x66 / 160 - 7 * x64 / 2400)
    out[..., 88] = x68 * (x67 - 5 * alpha_6) / 384
    out[..., 89] = x69
    out[..., 90] = 3 * omega_1 + 3 * sigma_2
    out[..., 91] = x69


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
        Detuning, Omega = omega_1 + sigma_2, rad/s, real.
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
        Detuning, Omega = omega_1 + sigma_2, rad/s, real.
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
        Detuning, Omega = omega_1 + sigma_2, rad/s, real.
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
    return modes_at(_FREE, (1.0, 3.0), _backbone, arguments, amplitude, COORDINATES, of)


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
        Detuning, Omega = omega_1 + sigma_2, rad/s, real.
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
        Detuning, Omega = omega_1 + sigma_2, rad/s, real.
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
        Detuning, Omega = omega_1 + sigma_2, rad/s, real.
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
        Detuning, Omega = omega_1 + sigma_2, rad/s, real.
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
