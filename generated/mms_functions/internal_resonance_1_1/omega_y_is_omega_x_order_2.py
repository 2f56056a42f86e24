# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_1.py: change that, not this file.
# Made from sha256 1b04841742ecf85e5cb9ae12cc3aca38ef428e67562985fa236e5f3575157c18
# Operations for each point: slow_flow 40
"""internal_resonance_1_1: omega_y = omega_x + sigma, order 2.

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
RELATIONS: tuple[str, ...] = ("omega_y = omega_x + sigma",)

#: the highest power of ε
ORDER = 2

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
    x0 = np.conj(A_y)
    x1 = L * L
    x2 = 1 / x1
    x3 = np.conj(A_x)
    x4 = 1j * omega_x * x2
    x5 = x3 * x4
    x6 = A_x * A_x
    x7 = A_y * A_y
    x8 = x0 * x4
    # Outputs
    out[..., 0] = (
        1 / 2 * 1j * A_x * A_y * omega_x * x0 * x2 - A_x * mu - 1 / 4 * x5 * x6 - 3 / 4 * x5 * x7
    )
    out[..., 1] = (
        1 / 2 * 1j * A_x * A_y * omega_x * x2 * x3 + A_y * (1j * sigma - mu) - 3 / 4 * x6 * x8
        - 1 / 4 * x7 * x8
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
