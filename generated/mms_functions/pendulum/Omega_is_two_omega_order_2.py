# Emitted by mmsgen 0.1.0 from derivations/pendulum.py: change that, not this file.
# Made from sha256 ec0b68f6e47469f3572e2408d1d53bf3472e45d36b20a7edeb500437618fbcd9
# Operations for each point: slow_flow 46
"""pendulum: Omega = 2*omega + sigma, order 2.

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
RELATIONS: tuple[str, ...] = ("Omega = 2*omega + sigma",)

#: the highest power of ε
ORDER = 2

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
    x0 = 1 / 2 * 1j
    x1 = 1j * omega
    x2 = A_theta * A_theta
    x3 = A_theta * x2
    x4 = x1 * x3
    x5 = np.conj(A_theta)
    x6 = x5 * x5
    x7 = mu * mu
    x8 = z * z
    x9 = omega * omega
    # Outputs
    out[..., 0] = (
        7 / 16 * A_theta * x1 * x6 * z
        + A_theta * (1j * (3 / 4 * x8 * x9 - 1 / 2 * x7) - mu * omega) / omega
        + x2 * x5 * (-1 / 4 * mu - 1 / 4 * x1) + 1 / 64 * x4 * x6 + 5 / 16 * x4 * z
        - A_theta * sigma * x0 - x0 * x5 * z * (2 * omega + sigma)
    )


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
