# Emitted by mmsgen 0.1.0 from derivations/pendulum.py: change that, not this file.
# Made from sha256 3bbf5059f38750e77a1911b34fa000dca327219762eb1cc99c4ac18c579d17b6
# Operations for each point: slow_flow 13
"""pendulum: Omega = omega + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of theta. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapters 4 and 5
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
RELATIONS: tuple[str, ...] = ("Omega = omega + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("theta",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega + sigma"),
    "omega": ("positive", "rad/s", "natural frequency, root of g/l"),
    "h": ("nonnegative", "1", "amplitude of the support to and fro, over l"),
    "mu": ("nonnegative", "1/s", "damping"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "theta": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_theta, sigma, omega, h, mu):
    # Intermediates
    x0 = 1 / 4 * 1j * omega
    x1 = A_theta * A_theta
    # Outputs
    out[..., 0] = -A_theta * mu - 1j * A_theta * sigma - h * x0 - x0 * x1 * np.conj(A_theta)


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega: ArrayLike, h: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = omega + sigma, rad/s, real.
    omega : array_like
        Natural frequency, root of g/l, rad/s, > 0.
    h : array_like
        Amplitude of the support to and fro, over l, >= 0.
    mu : array_like
        Damping, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, h=h, mu=mu)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
