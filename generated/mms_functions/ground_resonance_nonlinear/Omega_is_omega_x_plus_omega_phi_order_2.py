# Emitted by mmsgen 0.1.0 from derivations/ground_resonance_nonlinear.py: change that, not this
# file.
# Made from sha256 fee810ee4c1ee5b505c854ef7ad608b28bf4eb9b1b69a4dedfa2ab26041b384f
# Operations for each point: slow_flow 104, coefficients 33, backbone 16, motion 2
"""ground_resonance_nonlinear: Omega = omega_x + omega_phi + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

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
RELATIONS: tuple[str, ...] = ("Omega = omega_x + omega_phi + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega_phi + omega_x + sigma"),
    "r_m": ("positive", "m", "static moment of a blade over the mass of the helicopter"),
    "r_b": ("positive", "1/m", "static moment of a blade over its inertia about the hinge"),
    "r_a": ("positive", "1", "lag frequency per rotor speed of a blade without lag spring"),
    "omega_x": ("positive", "rad/s", "longitudinal frequency of the fuselage"),
    "mu_x": ("nonnegative", "1/s", "longitudinal damping rate of the fuselage"),
    "mu_y": ("nonnegative", "1/s", "lateral damping rate of the fuselage"),
    "mu_b": ("nonnegative", "1/s", "lag damping rate of a blade"),
    "kappa": ("real", "1/s^2", "cubic lag stiffness of a blade over its inertia"),
    "mu_2": ("nonnegative", "1", "lag damping by the square of the velocity over the inertia"),
    "mu_3": ("nonnegative", "s", "lag damping by the cube of the velocity over the inertia"),
    "omega_phi": ("positive", "rad/s", "lag frequency of a blade at speed"),
    "omega_y": ("positive", "rad/s", "lateral frequency of the fuselage"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
    "y": {},
    "phi_1": {"sigma": 1},
    "phi_2": {"sigma": 1},
    "phi_3": {"sigma": 1},
    "phi_4": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    6,
    (
        (0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0)),
        (0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0)),
        (0, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0)),
        (0, (0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (0, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (1, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0, 0, 0, 0)),
        (3, (0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0)),
        (4, (0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 0)),
        (5, (0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
    ),
    ((0, 1, 0, 0, 0, 0), (-1, 0, 1, 1, 1, 1)),
)

#: terms of free motions without damping
_FREE = Flow(
    6,
    (
        (0, (1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (1, (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0)),
        (3, (0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)),
        (4, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0)),
        (5, (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 0)),
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
    ),
    1,
)


def _slow_flow(
    out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4, sigma, r_m, r_b, r_a, omega_x, mu_x, mu_y,
    mu_b, kappa, mu_2, mu_3, omega_phi,
):
    # Intermediates
    x0 = np.conj(A_phi_1)
    x1 = np.conj(A_phi_3)
    x2 = 1 / 4 * omega_x * r_m
    x3 = np.conj(A_phi_2)
    x4 = np.conj(A_phi_4)
    x5 = 1j * sigma
    x6 = 8 * mu_2 * omega_phi / (3 * 3.141592653589793)
    x7 = 1 / omega_phi
    x8 = omega_x * omega_x
    x9 = 1 / 4 * r_b * x7 * x8 * np.conj(A_x)
    x10 = r_a * r_a
    x11 = 1 / 4 * x10
    x12 = omega_phi * omega_phi
    x13 = omega_phi * x12
    x14 = (
        1j * (3 / 2 * kappa - 1 / 2 * omega_phi * omega_x * x10 - x11 * x12 - x11 * x8)
        - 3 / 2 * mu_3 * x13
    )
    x15 = A_phi_1 * A_phi_1
    x16 = 1j * x9
    x17 = A_phi_2 * A_phi_2
    x18 = A_phi_3 * A_phi_3
    x19 = A_phi_4 * A_phi_4
    # Outputs
    out[..., 0] = (
        1 / 4 * omega_x * r_m * x0 + 1 / 4 * 1j * omega_x * r_m * x3 - A_x * mu_x - x1 * x2
        - 1j * x2 * x4
    )
    out[..., 1] = -A_y * mu_y
    out[..., 2] = (
        x0 * x14 * x15 * x7 + x9 - A_phi_1 * mu_b - A_phi_1 * x5 - A_phi_1 * x6 * np.abs(A_phi_1)
    )
    out[..., 3] = (
        x14 * x17 * x3 * x7 + x16 - A_phi_2 * mu_b - A_phi_2 * x5 - A_phi_2 * x6 * np.abs(A_phi_2)
    )
    out[..., 4] = (
        x1 * x14 * x18 * x7 - A_phi_3 * mu_b - A_phi_3 * x5 - A_phi_3 * x6 * np.abs(A_phi_3) - x9
    )
    out[..., 5] = (
        x14 * x19 * x4 * x7 - A_phi_4 * mu_b - A_phi_4 * x5 - A_phi_4 * x6 * np.abs(A_phi_4) - x16
    )


def _coefficients(
    out, sigma, r_m, r_b, r_a, omega_x, mu_x, mu_y, mu_b, kappa, mu_2, mu_3, omega_phi,
):
    # Intermediates
    x0 = 1 / 4 * omega_x * r_m
    x1 = 1j * x0
    x2 = -mu_b - 1j * sigma
    x3 = -8 * mu_2 * omega_phi / (3 * 3.141592653589793)
    x4 = 1 / omega_phi
    x5 = r_a * r_a
    x6 = 1 / 4 * x5
    x7 = omega_x * omega_x
    x8 = omega_phi * omega_phi
    x9 = omega_phi * x8
    x10 = (
        x4 * (1j * (3 / 2 * kappa - 1 / 2 * omega_phi * omega_x * x5 - x6 * x7 - x6 * x8)
        - 3 / 2 * mu_3 * x9)
    )
    x11 = 1 / 4 * r_b * x4 * x7
    x12 = 1j * x11
    # Outputs
    out[..., 0] = -x1
    out[..., 1] = -x0
    out[..., 2] = x1
    out[..., 3] = x0
    out[..., 4] = -mu_x
    out[..., 5] = -mu_y
    out[..., 6] = x2
    out[..., 7] = x3
    out[..., 8] = x10
    out[..., 9] = x11
    out[..., 10] = x2
    out[..., 11] = x3
    out[..., 12] = x10
    out[..., 13] = x12
    out[..., 14] = x2
    out[..., 15] = x3
    out[..., 16] = x10
    out[..., 17] = -x11
    out[..., 18] = x2
    out[..., 19] = x3
    out[..., 20] = x10
    out[..., 21] = -x12


def _backbone(out, r_m, r_b, r_a, omega_x, mu_x, mu_y, mu_b, kappa, mu_2, mu_3, omega_phi):
    # Intermediates
    x0 = r_a * r_a
    x1 = 1 / 4 * x0
    x2 = omega_phi * omega_phi
    x3 = omega_x * omega_x
    x4 = 1j * (3 / 2 * kappa - 1 / 2 * omega_phi * omega_x * x0 - x1 * x2 - x1 * x3) / omega_phi
    # Outputs
    out[..., 3] = x4
    out[..., 5] = x4
    out[..., 7] = x4
    out[..., 9] = x4


def _motion(
    out, sigma, r_m, r_b, r_a, omega_x, mu_x, mu_y, mu_b, kappa, mu_2, mu_3, omega_phi, omega_y,
):
    # Intermediates
    x0 = omega_phi + sigma
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = 2
    out[..., 3] = 2
    out[..., 4] = 2
    out[..., 5] = 2
    out[..., 6] = omega_x
    out[..., 7] = omega_y
    out[..., 8] = x0
    out[..., 9] = x0
    out[..., 10] = x0
    out[..., 11] = x0
    out[..., 12] = omega_x + x0


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike,
    omega_x: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, kappa: ArrayLike,
    mu_2: ArrayLike, mu_3: ArrayLike, omega_phi: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = omega_phi + omega_x + sigma, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
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
    kappa : array_like
        Cubic lag stiffness of a blade over its inertia, 1/s^2, real.
    mu_2 : array_like
        Lag damping by the square of the velocity over the inertia, >= 0.
    mu_3 : array_like
        Lag damping by the cube of the velocity over the inertia, s, >= 0.
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
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, r_a=r_a, omega_x=omega_x, mu_x=mu_x, mu_y=mu_y,
        mu_b=mu_b, kappa=kappa, mu_2=mu_2, mu_3=mu_3, omega_phi=omega_phi,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 6), *arguments], (6,))


def equilibria(
    *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike,
    mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, kappa: ArrayLike, mu_2: ArrayLike,
    mu_3: ArrayLike, omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN. B_j exp(i k_j θ) moves along a circle of
    further ones for k = (0, 1, 0, 0, 0, 0), (-1, 0, 1, 1, 1, 1); of each circle one point is given,
    and the rate at which it drifts, B_j exp(i k_j ρ t).

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_phi + omega_x + sigma, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
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
    kappa : array_like
        Cubic lag stiffness of a blade over its inertia, 1/s^2, real.
    mu_2 : array_like
        Lag damping by the square of the velocity over the inertia, >= 0.
    mu_3 : array_like
        Lag damping by the cube of the velocity over the inertia, s, >= 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Equilibria
        The arrays amplitudes (..., count, 6), drift (..., count, 2) in rad/s and growth (...,
        count) in 1/s, which is negative where an equilibrium is stable. With gradient also name ->
        derivatives of amplitudes, drift and growth, NaN where equilibria meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, r_a=r_a, omega_x=omega_x, mu_x=mu_x, mu_y=mu_y,
        mu_b=mu_b, kappa=kappa, mu_2=mu_2, mu_3=mu_3, omega_phi=omega_phi,
    )
    return equilibria_at(
        equilibria_of_many,
        _FLOW,
        _coefficients,
        arguments,
        (
            "sigma", "r_m", "r_b", "r_a", "omega_x", "mu_x", "mu_y", "mu_b", "kappa", "mu_2",
            "mu_3", "omega_phi",
        )
        if gradient
        else (),
    )


def frequency_response(
    *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike,
    mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, kappa: ArrayLike, mu_2: ArrayLike,
    mu_3: ArrayLike, omega_phi: ArrayLike, over: str = "sigma", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_phi + omega_x + sigma, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
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
    kappa : array_like
        Cubic lag stiffness of a blade over its inertia, 1/s^2, real.
    mu_2 : array_like
        Lag damping by the square of the velocity over the inertia, >= 0.
    mu_3 : array_like
        Lag damping by the cube of the velocity over the inertia, s, >= 0.
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
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, r_a=r_a, omega_x=omega_x, mu_x=mu_x, mu_y=mu_y,
        mu_b=mu_b, kappa=kappa, mu_2=mu_2, mu_3=mu_3, omega_phi=omega_phi,
    )
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        (
            "sigma", "r_m", "r_b", "r_a", "omega_x", "mu_x", "mu_y", "mu_b", "kappa", "mu_2",
            "mu_3", "omega_phi",
        ),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike, omega_x: ArrayLike,
    mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, kappa: ArrayLike, mu_2: ArrayLike,
    mu_3: ArrayLike, omega_phi: ArrayLike, of: str = "x",
) -> Any:
    """Free motions without damping in which one coordinate has a given amplitude.

    All periodic ones: normal modes, whose frequencies over the amplitude are the backbone curves of
    the responses. Forces and damping are left out.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
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
    kappa : array_like
        Cubic lag stiffness of a blade over its inertia, 1/s^2, real.
    mu_2 : array_like
        Lag damping by the square of the velocity over the inertia, >= 0.
    mu_3 : array_like
        Lag damping by the cube of the velocity over the inertia, s, >= 0.
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
        PARAMETERS, r_m=r_m, r_b=r_b, r_a=r_a, omega_x=omega_x, mu_x=mu_x, mu_y=mu_y, mu_b=mu_b,
        kappa=kappa, mu_2=mu_2, mu_3=mu_3, omega_phi=omega_phi,
    )
    return modes_at(
        _FREE,
        (0.0, 0.0, 1.0, 1.0, 1.0, 1.0),
        _backbone,
        arguments,
        amplitude,
        COORDINATES,
        of,
    )


def jacobian(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike,
    omega_x: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, kappa: ArrayLike,
    mu_2: ArrayLike, mu_3: ArrayLike, omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`, turned along its symmetries so that the amplitudes given drift as
    little as they can; an equilibrium then is at rest.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, Omega = omega_phi + omega_x + sigma, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
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
    kappa : array_like
        Cubic lag stiffness of a blade over its inertia, 1/s^2, real.
    mu_2 : array_like
        Lag damping by the square of the velocity over the inertia, >= 0.
    mu_3 : array_like
        Lag damping by the cube of the velocity over the inertia, s, >= 0.
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
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, r_a=r_a, omega_x=omega_x, mu_x=mu_x, mu_y=mu_y,
        mu_b=mu_b, kappa=kappa, mu_2=mu_2, mu_3=mu_3, omega_phi=omega_phi,
    )
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma", "r_m", "r_b", "r_a", "omega_x", "mu_x", "mu_y", "mu_b", "kappa", "mu_2",
            "mu_3", "omega_phi",
        )
        if gradient
        else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike, r_a: ArrayLike,
    omega_x: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike, kappa: ArrayLike,
    mu_2: ArrayLike, mu_3: ArrayLike, omega_phi: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t). Each symmetry that moves the point has
    a zero, which is left out.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, Omega = omega_phi + omega_x + sigma, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
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
    kappa : array_like
        Cubic lag stiffness of a blade over its inertia, 1/s^2, real.
    mu_2 : array_like
        Lag damping by the square of the velocity over the inertia, >= 0.
    mu_3 : array_like
        Lag damping by the cube of the velocity over the inertia, s, >= 0.
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
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, r_a=r_a, omega_x=omega_x, mu_x=mu_x, mu_y=mu_y,
        mu_b=mu_b, kappa=kappa, mu_2=mu_2, mu_3=mu_3, omega_phi=omega_phi,
    )
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma", "r_m", "r_b", "r_a", "omega_x", "mu_x", "mu_y", "mu_b", "kappa", "mu_2",
            "mu_3", "omega_phi",
        )
        if gradient
        else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
    r_a: ArrayLike, omega_x: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike,
    kappa: ArrayLike, mu_2: ArrayLike, mu_3: ArrayLike, omega_phi: ArrayLike, omega_y: ArrayLike,
    order: int | None = None, drift: ArrayLike | None = None, gradient: bool = False,
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
        Shape (..., 6), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, Omega = omega_phi + omega_x + sigma, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
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
    kappa : array_like
        Cubic lag stiffness of a blade over its inertia, 1/s^2, real.
    mu_2 : array_like
        Lag damping by the square of the velocity over the inertia, >= 0.
    mu_3 : array_like
        Lag damping by the cube of the velocity over the inertia, s, >= 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
    omega_y : array_like
        Lateral frequency of the fuselage, rad/s, > 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 0; all by default.
    drift : array_like, optional
        Of an equilibrium that drifts, shape (..., 2), rad/s: as `equilibria` gives it.
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
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, r_a=r_a, omega_x=omega_x, mu_x=mu_x, mu_y=mu_y,
        mu_b=mu_b, kappa=kappa, mu_2=mu_2, mu_3=mu_3, omega_phi=omega_phi, omega_y=omega_y,
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
            "sigma", "r_m", "r_b", "r_a", "omega_x", "mu_x", "mu_y", "mu_b", "kappa", "mu_2",
            "mu_3", "omega_phi", "omega_y",
        )
        if gradient
        else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, r_m: ArrayLike, r_b: ArrayLike,
    r_a: ArrayLike, omega_x: ArrayLike, mu_x: ArrayLike, mu_y: ArrayLike, mu_b: ArrayLike,
    kappa: ArrayLike, mu_2: ArrayLike, mu_3: ArrayLike, omega_phi: ArrayLike, omega_y: ArrayLike,
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
        Detuning, Omega = omega_phi + omega_x + sigma, rad/s, real.
    r_m : array_like
        Static moment of a blade over the mass of the helicopter, m, > 0.
    r_b : array_like
        Static moment of a blade over its inertia about the hinge, 1/m, > 0.
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
    kappa : array_like
        Cubic lag stiffness of a blade over its inertia, 1/s^2, real.
    mu_2 : array_like
        Lag damping by the square of the velocity over the inertia, >= 0.
    mu_3 : array_like
        Lag damping by the cube of the velocity over the inertia, s, >= 0.
    omega_phi : array_like
        Lag frequency of a blade at speed, rad/s, > 0.
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
        PARAMETERS, sigma=sigma, r_m=r_m, r_b=r_b, r_a=r_a, omega_x=omega_x, mu_x=mu_x, mu_y=mu_y,
        mu_b=mu_b, kappa=kappa, mu_2=mu_2, mu_3=mu_3, omega_phi=omega_phi, omega_y=omega_y,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 12, False))
