# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_1.py: change that, not this file.
# Made from sha256 c462f156971cfefa500f93cadcdbae21a24dbf5c96cd2c3e86a35134c096491c
# Operations for each point: slow_flow 131
"""internal_resonance_1_1: omega_y = omega_x + sigma, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of x, y. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Miles, Quarterly of Applied Mathematics 20 (1962) 21-32
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

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
    "slow_flow",
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
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
    "y": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


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
