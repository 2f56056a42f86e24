# Emitted by mmsgen 0.1.0 from derivations/van_der_pol.py: change that, not this file.
# Made from sha256 3c4947125128b7da1a25e3ae0a4f5ed29e1f2eb921f4994762fd95f72c27b815
# Operations for each point: slow_flow 48
"""van_der_pol: no resonance, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of u. Results are written at ε = 1.

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
ORDER = 4

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
    x1 = 1j * mu
    x2 = mu * mu
    x3 = A_u * A_u
    x4 = x0 * x0
    x5 = A_u * x3
    x6 = x0 * x4
    x7 = x3 * x3
    x8 = mu * x2
    x9 = x4 * x4
    x10 = A_u * x7
    x11 = x2 * x2
    # Outputs
    out[..., 0] = (
        A_u * mu * (1 / 2 - 1 / 128 * x1 * (x2 + 16))
        + mu * x0 * x3 * (-1 / 16 * x1 * (x2 - 8) - 1 / 4 * x2 - 1 / 2)
        + 497 * 1j * x10 * x11 * x9 / 3072
        + x2 * x4 * x5 * (35 / 64 * mu + 1j * (85 / 256 * x2 - 7 / 16))
        + x6 * x7 * x8 * (-211 / 512 * x1 - 37 / 128)
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
