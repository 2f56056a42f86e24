# Emitted by mmsgen 0.1.0 from derivations/centrifugal_pendulum.py: change that, not this file.
# Made from sha256 8bf2194aebd2e14f9df6c16cf9974893073818261be90fad8d17889658b4a5b9
# Operations for each point: slow_flow 36
"""centrifugal_pendulum: nu = omega_p + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of psi, phi. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Newland, J. Engineering for Industry 86 (1964) 257-263
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
RELATIONS: tuple[str, ...] = ("nu = omega_p + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("psi", "phi")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, nu = omega_p + sigma"),
    "omega_r": ("positive", "rad/s", "frequency of the rotor on its spring, without pendulum"),
    "omega_p": ("positive", "rad/s", "frequency of the pendulum on a uniform rotor, n Ω"),
    "n": ("positive", "1", "order of tuning, the root of R/ρ"),
    "b": ("positive", "1", "ratio of inertias, m (R + ρ)²/J"),
    "mu": ("nonnegative", "1/s", "damping of the pendulum"),
    "tau": ("nonnegative", "1/s^2", "torque over the inertia of the rotor, T/J"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "psi": {},
    "phi": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_psi, A_phi, sigma, omega_r, omega_p, n, b, mu, tau):
    # Intermediates
    x0 = 1 / 2 * 1j * b
    x1 = omega_p + omega_r
    x2 = 1 / x1
    x3 = omega_r - omega_p
    x4 = 1 / x3
    x5 = x2 * x4
    x6 = omega_p * omega_p
    x7 = 1 / 4 * 1j * omega_p
    x8 = A_phi * A_phi
    x9 = omega_p * x6
    x10 = n * n
    # Outputs
    out[..., 0] = A_psi * omega_r * x0 * x5 * x6
    out[..., 1] = (
        A_phi * x2 * x4 * (-mu * x1 * x3 - x0 * x9) - 1j * A_phi * sigma - tau * x5 * x7 * (x10 + 1)
        - x7 * x8 * np.conj(A_phi)
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike,
    n: ArrayLike, b: ArrayLike, mu: ArrayLike, tau: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, nu = omega_p + sigma, rad/s, real.
    omega_r : array_like
        Frequency of the rotor on its spring, without pendulum, rad/s, > 0.
    omega_p : array_like
        Frequency of the pendulum on a uniform rotor, n Ω, rad/s, > 0.
    n : array_like
        Order of tuning, the root of R/ρ, > 0.
    b : array_like
        Ratio of inertias, m (R + ρ)²/J, > 0.
    mu : array_like
        Damping of the pendulum, 1/s, >= 0.
    tau : array_like
        Torque over the inertia of the rotor, T/J, 1/s^2, >= 0.

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
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))
