# Emitted by mmsgen 0.1.0 from derivations/centrifugal_pendulum.py: change that, not this file.
# Made from sha256 7d61cdab944b2f66c75e39f00c16bf082a64330ca2abbcd799e885ea1ea32793
# Operations for each point: slow_flow 272
"""centrifugal_pendulum: nu = omega_p + sigma, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of psi, phi. Results are written at ε = 1.

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
ORDER = 4

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
    x0 = omega_p + omega_r
    x1 = x0 * x0
    x2 = x0 * x1
    x3 = 1 / x2
    x4 = -omega_r
    x5 = -omega_p - x4
    x6 = x5 * x5
    x7 = x5 * x6
    x8 = 1 / x7
    x9 = mu * x0 * x5
    x10 = omega_p * omega_p
    x11 = x10 * x10
    x12 = 4 * x11
    x13 = b * x11
    x14 = omega_r * omega_r
    x15 = x10 * x14
    x16 = 1 / 2 * b
    x17 = np.conj(A_phi)
    x18 = 2 * omega_p
    x19 = -x18 - x4
    x20 = omega_r + x18
    x21 = 1 / (x1 * x19 * x20 * x6)
    x22 = n * n
    x23 = x22 + 1
    x24 = x23 * x23
    x25 = x17 * x21 / x24
    x26 = x11 * x22
    x27 = 4 * x22
    x28 = 1j * A_phi
    x29 = x14 * x14
    x30 = x22 * x22
    x31 = (
        A_psi * x28 * (x10 * x14 + 4 * x11 * x30 + 2 * x29 * x30 - x12 - x15 * x27 - 9 * x15 * x30
        - 2 * x26)
    )
    x32 = omega_r * x14
    x33 = 1j * omega_p
    x34 = tau / (x0 * x5)
    x35 = 1 / omega_p
    x36 = 1 / 2 * x29
    x37 = mu * x1 * x6
    x38 = x10 * x29
    x39 = sigma * sigma
    x40 = 1 / 16 * x39
    x41 = x3 * x35 * x8
    x42 = mu * mu
    x43 = 1 / 2 * x42
    x44 = x10 * x11
    x45 = b * x44
    x46 = 3 / 2 * x42
    x47 = x11 * x14
    x48 = 8 * x44
    x49 = x14 * x29
    x50 = 2 * x49
    x51 = 18 * x47
    x52 = b * x38
    x53 = x13 * x14
    x54 = x10 * x29 * x30
    x55 = A_phi * A_phi
    x56 = x11 * x11
    x57 = b * b
    x58 = x17 * x17
    x59 = A_phi * x55
    x60 = omega_p * x11
    x61 = omega_p * x10
    # Outputs
    out[..., 0] = (
        A_psi * b * omega_r * x3 * x8 * (-1 / 8 * 1j * x10 * (b * x15 + 3 * x13 + 8 * x15 - x12
        - 4 * x29) - x32 * x9) - x16 * x25 * x31 * x32
    )
    out[..., 1] = (
        A_phi * x41 * (omega_p * x9 * (2 * b * x10 * x14 + 2 * x10 * x14 - x11 - x13 - x29) + 1j
        * (3 / 8 * x14 * x44 * x57 + x14 * x45 + x38 * x46 + x43 * x44 + 1 / 8 * x56 * x57 - x13
        * x36 - x16 * x56 - x43 * x49 - x46 * x47))
        + 1 / 16 * omega_p * x17 * x28 * x34 * (3 * x22 - 1) + tau * x23 * x41 * (1 / 8 * omega_p
        * x37 + 1j * (3 / 16 * b * x11 * x14 + 1 / 16 * b * x44 + 1 / 4 * sigma * x14 * x61 + 1 / 8
        * sigma * x60 + 1 / 2 * x11 * x14 - 3 / 8 * omega_p * sigma * x29 - x11 * x40 - 7 / 8 * x15
        * x39 - x29 * x40 - 1 / 4 * x38 - 1 / 4 * x44)) + x25 * x55 * (1 / 8 * 1j * omega_p * (b
        * x22 * x48 + 11 * b * x54 + 24 * x22 * x38 + 16 * x22 * x44 + 36 * x30 * x45 + x30 * x48
        + 12 * x38 + 4 * x45 + x48 + 3 * x52 + 12 * x54 - 36 * x14 * x26 - 18 * x22 * x52 - 2 * x22
        * x53 - x27 * x49 - x30 * x50 - x30 * x51 - 53 * x30 * x53 - x50 - x51 - 13 * x53) - 1 / 4
        * x19 * x20 * x24 * x37) + 1 / 32 * x33 * x34 * x55 * (5 * x22 + 1)
        + 1 / 64 * x33 * x58 * x59 - sigma * x28 - x21 * x31 * x35 * x36 * np.conj(A_psi)
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
