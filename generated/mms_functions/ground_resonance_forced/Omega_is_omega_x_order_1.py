# Emitted by mmsgen 0.1.0 from derivations/ground_resonance_forced.py: change that, not this file.
# Made from sha256 e03892f2f20ea52fe504f0cdc5f513cd35747375a75a4d415337c63c8074c726
# Operations for each point: slow_flow 43, coefficients 35, backbone 13, motion 71
"""ground_resonance_forced: Omega = omega_x + sigma, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003
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
RELATIONS: tuple[str, ...] = ("Omega = omega_x + sigma",)

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega_x + sigma"),
    "e_1": ("real", "1", "what blade 1 is heavier by, over the mass of a blade"),
    "e_2": ("real", "1", "what blade 2 is heavier by, over the mass of a blade"),
    "e_3": ("real", "1", "what blade 3 is heavier by, over the mass of a blade"),
    "e_4": ("real", "1", "what blade 4 is heavier by, over the mass of a blade"),
    "r_m": ("positive", "m", "static moment of a blade over the mass of the helicopter"),
    "r_a": ("positive", "1", "lag frequency per rotor speed of a blade without lag spring"),
    "omega_x": ("positive", "rad/s", "longitudinal frequency of the fuselage"),
    "mu_x": ("nonnegative", "1/s", "longitudinal damping rate of the fuselage"),
    "mu_y": ("nonnegative", "1/s", "lateral damping rate of the fuselage"),
    "mu_b": ("nonnegative", "1/s", "lag damping rate of a blade"),
    "r_h": ("positive", "1", "eccentricity of a hinge over the distance from it to the centre"),
    "omega_phi": ("positive", "rad/s", "lag frequency of a blade at speed"),
    "r_b": ("positive", "1/m", "static moment of a blade over its inertia about the hinge"),
    "omega_y": ("positive", "rad/s", "lateral frequency of the fuselage"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {"sigma": 1},
    "y": {},
    "phi_1": {},
    "phi_2": {},
    "phi_3": {},
    "phi_4": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    6,
    (
        (0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (0, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (1, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
    ),
    (
        (0, 1, 0, 0, 0, 0), (0, 0, 1, 0, 0, 0), (0, 0, 0, 1, 0, 0), (0, 0, 0, 0, 1, 0),
        (0, 0, 0, 0, 0, 1),
    ),
)

#: terms of free motions without damping
_FREE = Flow(
    6,
    (
        (0, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (1, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
    ),
    (
        (1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0), (0, 0, 1, 0, 0, 0), (0, 0, 0, 1, 0, 0),
        (0, 0, 0, 0, 1, 0), (0, 0, 0, 0, 0, 1),
    ),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    6,
    (
        (0, 0, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (0, 1, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (0, 2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (0, 3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (0,)),
        (0, 4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (0,)),
        (0, 5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 0, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 2, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 2, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 3, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 3, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 4, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 4, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 5, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
        (1, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (-1,)),
        (1, 5, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), (1,)),
    ),
    1,
)


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, sigma, e_1, e_2, e_3, e_4, r_m, r_a, omega_x,
    mu_x, mu_y, mu_b, r_h, omega_phi,
):
    # Intermediates
    x0 = 1 / omega_phi
    x1 = -mu_b * omega_phi
    x2 = 1 / 2 * 1j * (omega_x * r_a - omega_phi) * (omega_phi + omega_x * r_a)
    # Outputs
    out[..., 0] = (
        omega_x * r_m * (r_h + 1) * (1 / 4 * e_2 + 1j * (1 / 4 * e_3 - 1 / 4 * e_1) - 1 / 4 * e_4)
        - A_x * mu_x - 1j * A_x * sigma
    )
    out[..., 1] = -A_y * mu_y
    out[..., 2] = A_phi_1 * x0 * (e_1 * x2 + x1)
    out[..., 3] = A_phi_2 * x0 * (e_2 * x2 + x1)
    out[..., 4] = A_phi_3 * x0 * (e_3 * x2 + x1)
    out[..., 5] = A_phi_4 * x0 * (e_4 * x2 + x1)


def _coefficients(
    out, sigma, e_1, e_2, e_3, e_4, r_m, r_a, omega_x, mu_x, mu_y, mu_b, r_h, omega_phi,
):
    # Intermediates
    x0 = 1 / omega_phi
    x1 = -mu_b * omega_phi
    x2 = 1 / 2 * 1j * (omega_x * r_a - omega_phi) * (omega_phi + omega_x * r_a)
    # Outputs
    out[..., 0] = (
        omega_x * r_m * (r_h + 1) * (1 / 4 * e_2 + 1j * (1 / 4 * e_3 - 1 / 4 * e_1) - 1 / 4 * e_4)
    )
    out[..., 1] = -mu_x - 1j * sigma
    out[..., 2] = -mu_y
    out[..., 3] = x0 * (e_1 * x2 + x1)
    out[..., 4] = x0 * (e_2 * x2 + x1)
    out[..., 5] = x0 * (e_3 * x2 + x1)
    out[..., 6] = x0 * (e_4 * x2 + x1)


def _backbone(out, e_1, e_2, e_3, e_4, r_m, r_a, omega_x, mu_x, mu_y, mu_b, r_h, omega_phi):
    # Intermediates
    x0 = 1 / 2 * 1j * (omega_x * r_a - omega_phi) * (omega_phi + omega_x * r_a) / omega_phi
    # Outputs
    out[..., 2] = e_1 * x0
    out[..., 3] = e_2 * x0
    out[..., 4] = e_3 * x0
    out[..., 5] = e_4 * x0


def _motion(
    out, sigma, e_1, e_2, e_3, e_4, r_m, r_a, omega_x, mu_x, mu_y, mu_b, r_h, omega_phi, r_b,
    omega_y,
):
    # Intermediates
    x0 = 1 / (2 * omega_x - omega_phi)
    x1 = r_m / omega_phi
    x2 = omega_phi - omega_x
    x3 = x2 * x2
    x4 = x0 * x1 * x3
    x5 = 1 / (omega_phi + 2 * omega_x)
    x6 = omega_phi + omega_x
    x7 = x6 * x6
    x8 = x1 * x5 * x7
    x9 = 1j * x4
    x10 = 1j * x8
    x11 = omega_x + omega_y
    x12 = -omega_y
    x13 = omega_x * omega_x
    x14 = 1 / (x11 - omega_phi)
    x15 = 1 / (-omega_y - x2)
    x16 = r_m * x14 * x15 * x3
    x17 = 1j * x16
    x18 = 1 / (omega_y + x6)
    x19 = 1 / (x12 + x6)
    x20 = r_m * x18 * x19 * x7
    x21 = 1j * x20
    x22 = omega_y * omega_y
    x23 = r_b * x22
    x24 = x15 * x19 * x23
    x25 = x14 * x18 * x23
    x26 = r_b * x13
    x27 = omega_phi * omega_phi
    x28 = x26 / x27
    x29 = 1j * x28
    x30 = x0 * x26 * x5
    x31 = 1j * x30
    x32 = 1j * x24
    x33 = 1j * x25
    x34 = omega_x + sigma
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = x4
    out[..., 7] = -x8
    out[..., 8] = x9
    out[..., 9] = x10
    out[..., 10] = -x4
    out[..., 11] = x8
    out[..., 12] = -x9
    out[..., 13] = -x10
    out[..., 14] = (
        2 * r_m * x13 * (r_h + 1) * (1 / 2 * e_4 + 1j * (1 / 2 * e_1 - 1 / 2 * e_3) - 1 / 2 * e_2)
        / (x11 * (omega_x + x12))
    )
    out[..., 15] = -x17
    out[..., 16] = x21
    out[..., 17] = x16
    out[..., 18] = x20
    out[..., 19] = x17
    out[..., 20] = -x21
    out[..., 21] = -x16
    out[..., 22] = -x20
    out[..., 23] = -x24
    out[..., 24] = -x25
    out[..., 25] = -x29
    out[..., 26] = -x31
    out[..., 27] = x32
    out[..., 28] = -x33
    out[..., 29] = -x28
    out[..., 30] = x30
    out[..., 31] = x24
    out[..., 32] = x25
    out[..., 33] = x29
    out[..., 34] = x31
    out[..., 35] = -x32
    out[..., 36] = x33
    out[..., 37] = x28
    out[..., 38] = -x30
    out[..., 39] = x34
    out[..., 40] = omega_y
    out[..., 41] = omega_phi
    out[..., 42] = omega_phi
    out[..., 43] = omega_phi
    out[..., 44] = omega_phi
    out[..., 45] = x34


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike,
    e_4: ArrayLike, r_m: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike, mu_x: ArrayLike,
    mu_y: ArrayLike, mu_b: ArrayLike, r_h: ArrayLike, omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.

    Returns
    -------
    complex128
        Shape (..., 6), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_a=r_a,
        omega_x=omega_x, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h, omega_phi=omega_phi,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 6), *arguments], (6,))


def equilibria(
    *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike, e_4: ArrayLike,
    r_m: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike,
    mu_b: ArrayLike, r_h: ArrayLike, omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN. B_j exp(i k_j θ) moves along a circle of
    further ones for k = (0, 1, 0, 0, 0, 0), (0, 0, 1, 0, 0, 0), (0, 0, 0, 1, 0, 0), (0, 0, 0, 0, 1,
    0), (0, 0, 0, 0, 0, 1); of each circle one point is given, and the rate at which it drifts, B_j
    exp(i k_j ρ t).

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Equilibria
        The arrays amplitudes (..., count, 6), drift (..., count, 5) in rad/s and growth (...,
        count) in 1/s, which is negative where an equilibrium is stable. With gradient also name ->
        derivatives of amplitudes, drift and growth, NaN where equilibria meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_a=r_a,
        omega_x=omega_x, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h, omega_phi=omega_phi,
    )
    return equilibria_at(
        equilibria_of_many,
        _FLOW,
        _coefficients,
        arguments,
        (
            "sigma", "e_1", "e_2", "e_3", "e_4", "r_m", "r_a", "omega_x", "mu_x", "mu_y", "mu_b",
            "r_h", "omega_phi",
        )
        if gradient
        else (),
    )


def frequency_response(
    *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike, e_4: ArrayLike,
    r_m: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike,
    mu_b: ArrayLike, r_h: ArrayLike, omega_phi: ArrayLike, over: str = "sigma",
    gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_a=r_a,
        omega_x=omega_x, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h, omega_phi=omega_phi,
    )
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        (
            "sigma", "e_1", "e_2", "e_3", "e_4", "r_m", "r_a", "omega_x", "mu_x", "mu_y", "mu_b",
            "r_h", "omega_phi",
        ),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike, e_4: ArrayLike,
    r_m: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike,
    mu_b: ArrayLike, r_h: ArrayLike, omega_phi: ArrayLike, of: str = "x",
) -> Any:
    """Free motions without damping in which one coordinate has a given amplitude.

    All periodic ones: normal modes, whose frequencies over the amplitude are the backbone curves of
    the responses. Forces and damping are left out.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    of : str, optional
        That coordinate.

    Returns
    -------
    Backbone
        The arrays amplitudes (..., count, 6), shift (..., count, 6) of the frequency of each
        coordinate in rad/s, detuning (..., count) of a force at that frequency in rad/s, and growth
        (..., count) in 1/s, zero where a motion is stable; NaN where there are fewer.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_a=r_a, omega_x=omega_x,
        mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h, omega_phi=omega_phi,
    )
    return modes_at(
        _FREE,
        (1.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        _backbone,
        arguments,
        amplitude,
        COORDINATES,
        of,
    )


def jacobian(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike,
    e_4: ArrayLike, r_m: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike, mu_x: ArrayLike,
    mu_y: ArrayLike, mu_b: ArrayLike, r_h: ArrayLike, omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`, turned along its symmetries so that the amplitudes given drift as
    little as they can; an equilibrium then is at rest.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 12, 12), in 1/s, rows and columns u_1, v_1, u_2, …; with gradient this and name
        -> derivatives, the amplitudes fixed.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_a=r_a,
        omega_x=omega_x, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h, omega_phi=omega_phi,
    )
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma", "e_1", "e_2", "e_3", "e_4", "r_m", "r_a", "omega_x", "mu_x", "mu_y", "mu_b",
            "r_h", "omega_phi",
        )
        if gradient
        else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike, e_3: ArrayLike,
    e_4: ArrayLike, r_m: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike, mu_x: ArrayLike,
    mu_y: ArrayLike, mu_b: ArrayLike, r_h: ArrayLike, omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t). Each symmetry that moves the point has
    a zero, which is left out.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    complex128
        Shape (..., 12), in 1/s; NaN at the end for those that are left out; with gradient this and
        name -> derivatives, the amplitudes fixed; NaN where eigenvalues meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_a=r_a,
        omega_x=omega_x, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h, omega_phi=omega_phi,
    )
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma", "e_1", "e_2", "e_3", "e_4", "r_m", "r_a", "omega_x", "mu_x", "mu_y", "mu_b",
            "r_h", "omega_phi",
        )
        if gradient
        else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike,
    e_3: ArrayLike, e_4: ArrayLike, r_m: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike,
    mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, r_h: ArrayLike, omega_phi: ArrayLike,
    r_b: ArrayLike, omega_y: ArrayLike, order: int | None = None, drift: ArrayLike | None = None,
    gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. With a drift, constant ones turn along the
    symmetries of the slow flow. NaN where a harmonic resonates itself. Derivatives are taken with
    these fixed. Over times of order 1/ε the error is O(ε^1). A UserWarning says how much is left
    out where that is more than a tenth of the motion, estimated from the harmonics of each order
    beside those of order zero, and from the terms of the slow flow.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 1; all by default.
    drift : array_like, optional
        Of an equilibrium that drifts, shape (..., 5), rad/s: as `equilibria` gives it.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 6), in the order x, y, phi_1, phi_2, phi_3, phi_4; with gradient this and name
        -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_a=r_a,
        omega_x=omega_x, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h, omega_phi=omega_phi, r_b=r_b,
        omega_y=omega_y,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        drift=drift,
        slow=(_FLOW, _coefficients, 13),
        names=(
            "sigma", "e_1", "e_2", "e_3", "e_4", "r_m", "r_a", "omega_x", "mu_x", "mu_y", "mu_b",
            "r_h", "omega_phi", "r_b", "omega_y",
        )
        if gradient
        else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, e_1: ArrayLike, e_2: ArrayLike,
    e_3: ArrayLike, e_4: ArrayLike, r_m: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike,
    mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, r_h: ArrayLike, omega_phi: ArrayLike,
    r_b: ArrayLike, omega_y: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at t = 0 of the motion with given coordinates and velocities there.

    The solution of response(0, amplitudes) = q, and of its derivative along slow_flow = v, that
    goes over into that of order zero as the small parameters go to zero.

    Parameters
    ----------
    q : array_like
        Coordinates at t = 0, shape (..., 6), in the order of COORDINATES.
    v : array_like
        Velocities at t = 0, shape (..., 6), per second.
    sigma : array_like
        Detuning, Omega = omega_x + sigma, rad/s, real.
    e_1 : array_like
        What blade 1 is heavier by, over the mass of a blade, real.
    e_2 : array_like
        What blade 2 is heavier by, over the mass of a blade, real.
    e_3 : array_like
        What blade 3 is heavier by, over the mass of a blade, real.
    e_4 : array_like
        What blade 4 is heavier by, over the mass of a blade, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_a : array_like
        Lag frequency per rotor speed of a blade without lag spring, > 0.
    omega_x : array_like
        Longitudinal frequency of the fuselage, rad/s, > 0.
    mu_x : array_like
        Longitudinal damping rate of the fuselage, 1/s, >= 0.
    mu_y : array_like
        Lateral damping rate of the fuselage, 1/s, >= 0.
    mu_b : array_like
        Lag damping rate of a blade, 1/s, >= 0.
    r_h : array_like
        Eccentricity of a hinge over the distance from it to the centre, > 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.

    Returns
    -------
    complex128
        Shape (..., 6), complex128; NaN where there is none near that of order zero, as far outside
        of the scaling, or where a harmonic resonates itself.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, e_1=e_1, e_2=e_2, e_3=e_3, e_4=e_4, r_m=r_m, r_a=r_a,
        omega_x=omega_x, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b, r_h=r_h, omega_phi=omega_phi, r_b=r_b,
        omega_y=omega_y,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 13, False))
