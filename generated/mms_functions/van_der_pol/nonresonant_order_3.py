# Emitted by mmsgen 0.1.0 from derivations/van_der_pol.py: change that, not this file.
# Made from sha256 bfc855128668fec65a1f3d8c8a9a50a085dbb50ff53e9d6de793e47f5ac83d8c
# Operations for each point: slow_flow 33
"""van_der_pol: no resonance, order 3.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 3 in ε, of u. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 3
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
ORDER = 3

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "mu": ("positive", "1", "strength of the self-excitation; time and displacement scaled to one"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_u, mu):
    # Intermediates
    x0 = np.conj(A_u)
    x1 = mu * mu
    x2 = x0 * x0
    x3 = x0 * x2
    x4 = A_u * A_u
    x5 = x4 * x4
    x6 = mu * x1
    x7 = A_u * x4
    # Outputs
    out[..., 0] = (
        A_u * mu * (1 / 2 - 1 / 8 * 1j * mu) + mu * x0 * x4 * (1 / 2 * 1j * mu - 1 / 4 * x1 - 1 / 2)
        + x1 * x2 * x7 * (35 / 64 * mu - 7 / 16 * 1j) - 37 / 128 * x3 * x5 * x6
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(amplitudes: ArrayLike, /, *, mu: ArrayLike) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    mu : array_like
        Strength of the self-excitation; time and displacement scaled to one, > 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, mu=mu)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
