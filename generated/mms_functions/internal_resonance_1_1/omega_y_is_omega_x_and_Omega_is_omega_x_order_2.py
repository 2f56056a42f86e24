# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_1.py: change that, not this file.
# Made from sha256 a384859d7c97dfb11c9bff4ecfeb07206aba51ced70d18d2336894641f199165
# Operations for each point: slow_flow 52
"""internal_resonance_1_1: omega_y = omega_x + sigma_1 and Omega = omega_x + sigma_2, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y. Results are written at ε = 1.

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
RELATIONS: tuple[str, ...] = ("omega_y = omega_x + sigma_1", "Omega = omega_x + sigma_2")

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma_1": ("real", "rad/s", "detuning, omega_y = omega_x + sigma_1"),
    "sigma_2": ("real", "rad/s", "detuning, Omega = omega_x + sigma_2"),
    "L": ("positive", "m", "length"),
    "omega_x": ("positive", "rad/s", "frequency of small swings along x"),
    "mu": ("nonnegative", "1/s", "damping"),
    "f": ("nonnegative", "1/s^2", "acceleration of the pivot over the length"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {"sigma_2": 1},
    "y": {"sigma_2": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_x, A_y, sigma_1, sigma_2, L, omega_x, mu, f):
    # Intermediates
    x0 = 1j * sigma_2
    x1 = 1 / 4 * 1j
    x2 = np.conj(A_y)
    x3 = L * L
    x4 = 1 / x3
    x5 = np.conj(A_x)
    x6 = omega_x * x4 * x5
    x7 = 3 / 4 * 1j
    x8 = A_x * A_x
    x9 = A_y * A_y
    x10 = omega_x * x2 * x4
    # Outputs
    out[..., 0] = (
        1 / 2 * 1j * A_x * A_y * omega_x * x2 * x4 - A_x * mu - A_x * x0 - L * f * x1 / omega_x
        - x1 * x6 * x8 - x6 * x7 * x9
    )
    out[..., 1] = (
        1 / 2 * 1j * A_x * A_y * omega_x * x4 * x5 + A_y * (1j * sigma_1 - mu) - A_y * x0
        - x1 * x10 * x9 - x10 * x7 * x8
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_x: ArrayLike, mu: ArrayLike, f: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma_1 : array_like
        Detuning, omega_y = omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
    f : array_like
        Acceleration of the pivot over the length, 1/s^2, >= 0.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_x=omega_x, mu=mu, f=f,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))
