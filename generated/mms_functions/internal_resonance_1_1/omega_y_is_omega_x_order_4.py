# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_1.py: change that, not this file.
# Made from sha256 5d1ed0fe6602cde986d8f0880cea45c7200c61dd9c45aaaa6d923c0f2971b262
# Operations for each point: slow_flow 131, coefficients 68, backbone 46, motion 98
"""internal_resonance_1_1: omega_y = omega_x + sigma, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of x, y. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Miles, Quarterly of Applied Mathematics 20 (1962) 21-32
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
RELATIONS: tuple[str, ...] = ("omega_y = omega_x + sigma",)

#: the highest power of ε
ORDER = 4

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, omega_y = omega_x + sigma"),
    "L": ("positive", "m", "length"),
    "omega_x": ("positive", "rad/s", "frequency of small swings along x"),
    "mu": ("nonnegative", "1/s", "damping"),
    "f": ("nonnegative", "1/s^2", "acceleration of the pivot over the length"),
    "Omega": ("positive", "rad/s", "frequency of the pivot"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
    "y": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    2,
    (
        (0, (0, 1, 0, 2, 0, 0)), (0, (0, 1, 0, 3, 1, 0)), (0, (1, 0, 0, 0, 0, 0)),
        (0, (1, 0, 0, 1, 1, 0)), (0, (1, 0, 0, 2, 2, 0)), (0, (1, 2, 0, 2, 0, 0)),
        (0, (2, 1, 0, 0, 0, 0)), (0, (2, 1, 0, 1, 1, 0)), (0, (3, 0, 0, 0, 2, 0)),
        (0, (3, 2, 0, 0, 0, 0)), (1, (0, 0, 0, 1, 0, 0)), (1, (0, 0, 0, 2, 1, 0)),
        (1, (0, 0, 0, 3, 2, 0)), (1, (0, 2, 0, 3, 0, 0)), (1, (1, 1, 0, 1, 0, 0)),
        (1, (1, 1, 0, 2, 1, 0)), (1, (2, 0, 0, 0, 1, 0)), (1, (2, 0, 0, 1, 2, 0)),
        (1, (2, 2, 0, 1, 0, 0)), (1, (3, 1, 0, 0, 1, 0)),
    ),
    ((1, 1),),
)

#: terms of free motions without damping
_FREE = Flow(
    2,
    (
        (0, (0, 1, 0, 2, 0, 0)), (0, (0, 1, 0, 3, 1, 0)), (0, (1, 0, 0, 0, 0, 0)),
        (0, (1, 0, 0, 1, 1, 0)), (0, (1, 0, 0, 2, 2, 0)), (0, (1, 2, 0, 2, 0, 0)),
        (0, (2, 1, 0, 0, 0, 0)), (0, (2, 1, 0, 1, 1, 0)), (0, (3, 0, 0, 0, 2, 0)),
        (0, (3, 2, 0, 0, 0, 0)), (1, (0, 0, 0, 1, 0, 0)), (1, (0, 0, 0, 2, 1, 0)),
        (1, (0, 0, 0, 3, 2, 0)), (1, (0, 2, 0, 3, 0, 0)), (1, (1, 1, 0, 1, 0, 0)),
        (1, (1, 1, 0, 2, 1, 0)), (1, (2, 0, 0, 0, 1, 0)), (1, (2, 0, 0, 1, 2, 0)),
        (1, (2, 2, 0, 1, 0, 0)), (1, (3, 1, 0, 0, 1, 0)),
    ),
    ((1, 1),),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (1, 0, 0, 0, 0, 0), (0,)), (0, 1, (0, 0, 0, 1, 0, 0), (0,)),
        (2, 0, (0, 0, 0, 0, 0, 0), (1,)), (2, 0, (1, 0, 0, 2, 0, 0), (0,)),
        (2, 0, (3, 0, 0, 0, 0, 0), (0,)), (2, 1, (0, 0, 0, 3, 0, 0), (0,)),
        (2, 1, (2, 0, 0, 1, 0, 0), (0,)), (3, 0, (1, 0, 0, 2, 0, 0), (0,)),
        (3, 1, (0, 0, 0, 3, 0, 0), (0,)), (3, 1, (2, 0, 0, 1, 0, 0), (0,)),
        (4, 0, (0, 0, 0, 0, 0, 0), (1,)), (4, 0, (0, 0, 0, 1, 1, 0), (1,)),
        (4, 0, (0, 0, 0, 2, 0, 0), (-1,)), (4, 0, (0, 0, 0, 2, 0, 0), (1,)),
        (4, 0, (1, 0, 0, 0, 4, 0), (0,)), (4, 0, (1, 0, 0, 2, 0, 0), (0,)),
        (4, 0, (1, 0, 0, 3, 1, 0), (0,)), (4, 0, (1, 0, 0, 4, 0, 0), (0,)),
        (4, 0, (1, 1, 0, 0, 0, 0), (1,)), (4, 0, (2, 0, 0, 0, 0, 0), (-1,)),
        (4, 0, (2, 0, 0, 0, 0, 0), (1,)), (4, 0, (2, 1, 0, 2, 0, 0), (0,)),
        (4, 0, (3, 0, 0, 0, 0, 0), (0,)), (4, 0, (3, 0, 0, 1, 1, 0), (0,)),
        (4, 0, (3, 0, 0, 2, 0, 0), (0,)), (4, 0, (4, 1, 0, 0, 0, 0), (0,)),
        (4, 0, (5, 0, 0, 0, 0, 0), (0,)), (4, 1, (0, 0, 0, 3, 0, 0), (0,)),
        (4, 1, (0, 0, 0, 4, 1, 0), (0,)), (4, 1, (0, 0, 0, 5, 0, 0), (0,)),
        (4, 1, (1, 0, 0, 0, 1, 0), (-1,)), (4, 1, (1, 0, 0, 0, 1, 0), (1,)),
        (4, 1, (1, 0, 0, 1, 0, 0), (-1,)), (4, 1, (1, 0, 0, 1, 0, 0), (1,)),
        (4, 1, (1, 1, 0, 3, 0, 0), (0,)), (4, 1, (2, 0, 0, 1, 0, 0), (0,)),
        (4, 1, (2, 0, 0, 2, 1, 0), (0,)), (4, 1, (2, 0, 0, 3, 0, 0), (0,)),
        (4, 1, (3, 1, 0, 1, 0, 0), (0,)), (4, 1, (4, 0, 0, 0, 1, 0), (0,)),
        (4, 1, (4, 0, 0, 1, 0, 0), (0,)),
    ),
    1,
)


def _slow_flow(out, A_x, A_y, sigma, L, omega_x, mu):
    # Intermediates
    x0 = 1 / omega_x
    x1 = 1 / 2 * mu
    x2 = np.conj(A_x)
    x3 = 1j * omega_x
    x4 = L * L
    x5 = x4 * x4
    x6 = x3 / x5
    x7 = A_x * A_x
    x8 = A_x * x7
    x9 = x6 * x8
    x10 = A_y * A_y
    x11 = A_y * x10
    x12 = x11 * x6
    x13 = np.conj(A_y)
    x14 = x13 * x2
    x15 = 21 / 32 * x14
    x16 = 55 / 64 * x6
    x17 = A_x * x10
    x18 = 27 / 64 * x6
    x19 = A_y * x7
    x20 = 19 / 32 * x14 * x6
    x21 = 1 / x4
    x22 = x13 * x21
    x23 = 3 / 4 * mu
    x24 = x21 * x7
    x25 = mu * omega_x
    x26 = omega_x * sigma
    x27 = x0 * x10
    x28 = x2 * x21
    x29 = x2 * x2
    x30 = x13 * x13
    x31 = omega_x * omega_x
    x32 = sigma * sigma
    x33 = A_y * x0
    x34 = mu * mu
    # Outputs
    out[..., 0] = (
        A_x * A_y * x22 * (x1 + 1 / 2 * x3) + A_x * mu * x0 * (-omega_x - 1j * x1) + x17 * x18 * x30
        + x19 * x20 + x2 * x24 * (x23 - 1 / 4 * x3)
        + x27 * x28 * (1 / 4 * x25 + 1j * (1 / 4 * x32 - 5 / 4 * x26 - 3 / 4 * x31)) - x12 * x15
        - x16 * x17 * x29 - 15 / 64 * x29 * x9 - 13 / 64 * x30 * x9
    )
    out[..., 1] = (
        A_x * x28 * x33 * (omega_x * x1 + 1j * (1 / 2 * x31 + 1 / 2 * x32 - 1 / 2 * x26))
        + x13 * x24 * (1 / 4 * mu - 3 / 4 * x3) + x17 * x20 + x18 * x19 * x29
        + x22 * x27 * (omega_x * x23 + 1j * (3 / 4 * x32 - 7 / 4 * x26 - 1 / 4 * x31))
        + x33 * (1j * (omega_x * sigma - 1 / 2 * x34) - x25) - 13 / 64 * x12 * x29
        - 15 / 64 * x12 * x30 - x15 * x9 - x16 * x19 * x30
    )


def _coefficients(out, sigma, L, omega_x, mu):
    # Intermediates
    x0 = mu * omega_x
    x1 = omega_x * sigma
    x2 = L * L
    x3 = 1 / x2
    x4 = 1 / omega_x
    x5 = x3 * x4
    x6 = omega_x * omega_x
    x7 = sigma * sigma
    x8 = 1j * omega_x
    x9 = x2 * x2
    x10 = x8 / x9
    x11 = -21 / 32 * x10
    x12 = 1 / 2 * mu
    x13 = 27 / 64 * x10
    x14 = -55 / 64 * x10
    x15 = 3 / 4 * mu
    x16 = 19 / 32 * x10
    x17 = -13 / 64 * x10
    x18 = -15 / 64 * x10
    x19 = mu * mu
    # Outputs
    out[..., 0] = x5 * (1 / 4 * x0 + 1j * (1 / 4 * x7 - 5 / 4 * x1 - 3 / 4 * x6))
    out[..., 1] = x11
    out[..., 2] = mu * x4 * (-omega_x - 1j * x12)
    out[..., 3] = x3 * (x12 + 1 / 2 * x8)
    out[..., 4] = x13
    out[..., 5] = x14
    out[..., 6] = x3 * (x15 - 1 / 4 * x8)
    out[..., 7] = x16
    out[..., 8] = x17
    out[..., 9] = x18
    out[..., 10] = x4 * (1j * (omega_x * sigma - 1 / 2 * x19) - x0)
    out[..., 11] = x5 * (omega_x * x15 + 1j * (3 / 4 * x7 - 7 / 4 * x1 - 1 / 4 * x6))
    out[..., 12] = x18
    out[..., 13] = x17
    out[..., 14] = x5 * (omega_x * x12 + 1j * (1 / 2 * x6 + 1 / 2 * x7 - 1 / 2 * x1))
    out[..., 15] = x16
    out[..., 16] = x3 * (1 / 4 * mu - 3 / 4 * x8)
    out[..., 17] = x14
    out[..., 18] = x13
    out[..., 19] = x11


def _backbone(out, sigma, L, omega_x, mu):
    # Intermediates
    x0 = omega_x * sigma
    x1 = L * L
    x2 = 1 / x1
    x3 = 1j / omega_x
    x4 = x2 * x3
    x5 = omega_x * omega_x
    x6 = sigma * sigma
    x7 = 1j * omega_x
    x8 = x1 * x1
    x9 = x7 / x8
    x10 = -21 / 32 * x9
    x11 = mu * mu
    x12 = 1 / 2 * x11
    x13 = x2 * x7
    x14 = 27 / 64 * x9
    x15 = -55 / 64 * x9
    x16 = 19 / 32 * x9
    x17 = -13 / 64 * x9
    x18 = -15 / 64 * x9
    # Outputs
    out[..., 0] = x4 * (1 / 4 * x6 - 5 / 4 * x0 - 3 / 4 * x5)
    out[..., 1] = x10
    out[..., 2] = -x12 * x3
    out[..., 3] = 1 / 2 * x13
    out[..., 4] = x14
    out[..., 5] = x15
    out[..., 6] = -1 / 4 * x13
    out[..., 7] = x16
    out[..., 8] = x17
    out[..., 9] = x18
    out[..., 10] = x3 * (omega_x * sigma - x12)
    out[..., 11] = x4 * (3 / 4 * x6 - 7 / 4 * x0 - 1 / 4 * x5)
    out[..., 12] = x18
    out[..., 13] = x17
    out[..., 14] = x4 * (1 / 2 * x5 + 1 / 2 * x6 - 1 / 2 * x0)
    out[..., 15] = x16
    out[..., 16] = -3 / 4 * x13
    out[..., 17] = x15
    out[..., 18] = x14
    out[..., 19] = x10


def _motion(out, sigma, L, omega_x, mu, f, Omega):
    # Intermediates
    x0 = omega_x - Omega
    x1 = 1 / x0
    x2 = Omega + omega_x
    x3 = f / x2
    x4 = L * L
    x5 = 1 / x4
    x6 = -3 / 8 * x5
    x7 = x5 / omega_x
    x8 = sigma * x7
    x9 = x0 * x0
    x10 = 1 / x9
    x11 = 1j * mu
    x12 = x2 * x2
    x13 = f / x12
    x14 = 1 / L
    x15 = x10 * x14
    x16 = omega_x * omega_x
    x17 = x15 * x16
    x18 = x3 / (3 * omega_x - Omega)
    x19 = x1 * x13 * x14 / (Omega + 3 * omega_x)
    x20 = x4 * x4
    x21 = 1 / x20
    x22 = -21 / 128 * x21
    x23 = 1 / 32 * omega_x * x11
    x24 = 2 * x5 / x16
    x25 = sigma * sigma
    x26 = -9 / 32 * x21
    x27 = 5 / 128 * x21
    x28 = Omega * Omega
    x29 = 2 * x28
    x30 = x13 * x15
    x31 = 4 * Omega * omega_x
    x32 = 3 * x16 + x29
    x33 = x15 * x18
    x34 = -39 / 64 * x21
    x35 = 5 / 64 * x21
    x36 = -57 / 128 * x21
    x37 = 2 * omega_x - Omega
    x38 = Omega * x30
    x39 = Omega + 2 * omega_x
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = L * x1 * x3
    out[..., 3] = x6
    out[..., 4] = x6
    out[..., 5] = x6
    out[..., 6] = x6
    out[..., 7] = -7 / 16 * x8
    out[..., 8] = -1 / 4 * x8
    out[..., 9] = 3 / 16 * x8
    out[..., 10] = -2 * L * Omega * x10 * x11 * x13
    out[..., 11] = -x13 * x17
    out[..., 12] = -3 / 2 * x17 * x18
    out[..., 13] = -3 / 2 * x16 * x19
    out[..., 14] = x22
    out[..., 15] = x24 * (x23 + 11 / 64 * x25)
    out[..., 16] = x26
    out[..., 17] = x27
    out[..., 18] = -x30 * (x16 - x29)
    out[..., 19] = -1 / 2 * x33 * (x32 - x31)
    out[..., 20] = -1 / 2 * x19 * (x31 + x32)
    out[..., 21] = x34
    out[..., 22] = 1 / 16 * x11 * x7
    out[..., 23] = x26
    out[..., 24] = x35
    out[..., 25] = x36
    out[..., 26] = x27
    out[..., 27] = x24 * (x23 + 3 / 16 * x25)
    out[..., 28] = x36
    out[..., 29] = x27
    out[..., 30] = -x37 * x38
    out[..., 31] = x38 * x39
    out[..., 32] = Omega * x33 * x37
    out[..., 33] = -Omega * x19 * x39
    out[..., 34] = x26
    out[..., 35] = x24 * (x23 - 3 / 64 * x25)
    out[..., 36] = x34
    out[..., 37] = x35
    out[..., 38] = x26
    out[..., 39] = x22
    out[..., 40] = x27
    out[..., 41] = omega_x
    out[..., 42] = omega_x
    out[..., 43] = Omega


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, L: ArrayLike, omega_x: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 2), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, L=L, omega_x=omega_x, mu=mu)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))


def equilibria(
    *, sigma: ArrayLike, L: ArrayLike, omega_x: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN. B_j exp(i k_j θ) moves along a circle of
    further ones for k = (1, 1); of each circle one point is given, and the rate at which it drifts,
    B_j exp(i k_j ρ t).

    Parameters
    ----------
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, L=L, omega_x=omega_x, mu=mu)
    return equilibria_at(
        equilibria_of_many,
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "L", "omega_x", "mu") if gradient else (),
    )


def frequency_response(
    *, sigma: ArrayLike, L: ArrayLike, omega_x: ArrayLike, mu: ArrayLike, over: str = "sigma",
    gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, L=L, omega_x=omega_x, mu=mu)
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "L", "omega_x", "mu"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, sigma: ArrayLike, L: ArrayLike, omega_x: ArrayLike, mu: ArrayLike,
    of: str = "x",
) -> Any:
    """Free motions without damping in which one coordinate has a given amplitude.

    All periodic ones: normal modes, whose frequencies over the amplitude are the backbone curves of
    the responses. Forces and damping are left out.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    sigma : array_like
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, L=L, omega_x=omega_x, mu=mu)
    return modes_at(_FREE, (), _backbone, arguments, amplitude, COORDINATES, of)


def jacobian(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, L: ArrayLike, omega_x: ArrayLike, mu: ArrayLike,
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
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, L=L, omega_x=omega_x, mu=mu)
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "L", "omega_x", "mu") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, L: ArrayLike, omega_x: ArrayLike, mu: ArrayLike,
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
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, L=L, omega_x=omega_x, mu=mu)
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "L", "omega_x", "mu") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, L: ArrayLike, omega_x: ArrayLike,
    mu: ArrayLike, f: ArrayLike, Omega: ArrayLike, order: int | None = None,
    drift: ArrayLike | None = None, gradient: bool = False,
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
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
    f : array_like
        Acceleration of the pivot over the length, 1/s^2, >= 0.
    Omega : array_like
        Frequency of the pivot, rad/s, > 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 4; all by default.
    drift : array_like, optional
        Of an equilibrium that drifts, shape (..., 1), rad/s: as `equilibria` gives it.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2), in the order x, y; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, L=L, omega_x=omega_x, mu=mu, f=f, Omega=Omega)
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        drift=drift,
        slow=(_FLOW, _coefficients, 4),
        names=("sigma", "L", "omega_x", "mu", "f", "Omega") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, L: ArrayLike, omega_x: ArrayLike,
    mu: ArrayLike, f: ArrayLike, Omega: ArrayLike,
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
        Detuning, omega_y = omega_x + sigma, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
    f : array_like
        Acceleration of the pivot over the length, 1/s^2, >= 0.
    Omega : array_like
        Frequency of the pivot, rad/s, > 0.

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
    arguments = checked(PARAMETERS, sigma=sigma, L=L, omega_x=omega_x, mu=mu, f=f, Omega=Omega)
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 4, False))
