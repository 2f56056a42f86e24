# Emitted by mmsgen 0.1.0 from derivations/pendulum.py: change that, not this file.
# Made from sha256 6dc5f49e9f985ba0deaf3f01f13e3abfa4e4f36bb9c030ded8cabbb0784b6c57
# Operations for each point: slow_flow 14
"""pendulum: Omega = 2*omega + sigma, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of theta. Results are written at ε = 1.

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
RELATIONS: tuple[str, ...] = ("Omega = 2*omega + sigma",)

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("theta",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = 2*omega + sigma"),
    "omega": ("positive", "rad/s", "natural frequency, root of g/l"),
    "z": ("nonnegative", "1", "amplitude of the support up and down, over l"),
    "mu": ("nonnegative", "1/s", "damping"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "theta": {"sigma": 1 / 2},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_theta, sigma, omega, z, mu):
    # Intermediates
    x0 = 1j * omega * np.conj(A_theta)
    x1 = A_theta * A_theta
    # Outputs
    out[..., 0] = -A_theta * mu - 1 / 2 * 1j * A_theta * sigma - 1 / 4 * x0 * x1 - x0 * z


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega: ArrayLike, z: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = 2*omega + sigma, rad/s, real.
    omega : array_like
        Natural frequency, root of g/l, rad/s, > 0.
    z : array_like
        Amplitude of the support up and down, over l, >= 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, z=z, mu=mu)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
