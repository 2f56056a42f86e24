# Emitted by mmsgen 0.1.0 from derivations/helmholtz_duffing.py: change that, not this file.
# Made from sha256 fdf7679f0b87b2c8e62129d6130606211cd47218aaefbf9ed0836a24daaf93f2
# Operations for each point: slow_flow 34
"""helmholtz_duffing: no resonance, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of u. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 2
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
RELATIONS: tuple[str, ...] = ()

#: the highest power of ε
ORDER = 4

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "omega_0": ("positive", "rad/s", "frequency of small oscillations"),
    "alpha_2": ("real", "1/(m s^2)", "quadratic stiffness over the mass"),
    "alpha_3": ("real", "1/(m^2 s^2)", "cubic stiffness over the mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_u, omega_0, alpha_2, alpha_3):
    # Intermediates
    x0 = np.conj(A_u)
    x1 = alpha_2 * alpha_2
    x2 = omega_0 * omega_0
    x3 = A_u * A_u
    x4 = omega_0 * x2
    x5 = x0 * x0
    x6 = A_u * x3
    x7 = x2 * x2
    x8 = x4 * x7
    x9 = x1 * x1
    x10 = alpha_3 * alpha_3
    # Outputs
    out[..., 0] = (
        1j * x0 * x3 * (3 / 2 * alpha_3 * x2 - 5 * x1 / 3) / x4
        + 1j * x5 * x6 * (173 * alpha_3 * x1 * x2 / 12 - 15 / 16 * x10 * x7 - 485 * x9 / 108) / x8
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), real.
    alpha_3 : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha_2=alpha_2, alpha_3=alpha_3)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
