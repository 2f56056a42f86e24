# Emitted by mmsgen 0.1.0 from derivations/autoparametric_absorber.py: change that, not this file.
# Made from sha256 5df8cfc8b27e1bd2becbb89a26ef2fb5d8d9ecfe6e6e7d786e000fc0ef5cc6e5
# Operations for each point: slow_flow 87
"""autoparametric_absorber: omega_x = 2*omega_p + sigma_1 and Omega = omega_x + sigma_2, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, theta. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Haxton and Barr, J. Engineering for Industry 94 (1972) 119-125
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
RELATIONS: tuple[str, ...] = ("omega_x = 2*omega_p + sigma_1", "Omega = omega_x + sigma_2")

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "theta")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma_1": ("real", "rad/s", "detuning, omega_x = 2*omega_p + sigma_1"),
    "sigma_2": ("real", "rad/s", "detuning, Omega = omega_x + sigma_2"),
    "L": ("positive", "m", "length of the pendulum"),
    "omega_p": ("positive", "rad/s", "natural frequency of the pendulum"),
    "r": ("positive", "1", "mass of the bob over both masses, m/(M + m)"),
    "mu_x": ("nonnegative", "1/s", "damping of the mass"),
    "mu_p": ("nonnegative", "1/s", "damping of the pendulum"),
    "f": ("nonnegative", "1/s^2", "force over both masses and the length, F/((M + m) L)"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {"sigma_1": 1, "sigma_2": 1},
    "theta": {"sigma_1": 1 / 2, "sigma_2": 1 / 2},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_x, A_theta, sigma_1, sigma_2, L, omega_p, r, mu_x, mu_p, f):
    # Intermediates
    x0 = 1j * A_x
    x1 = np.conj(A_theta)
    x2 = 2 * omega_p
    x3 = A_theta * x0
    x4 = 1 / omega_p
    x5 = A_theta * A_theta
    x6 = mu_x * mu_x
    x7 = omega_p * omega_p
    x8 = 1j * x1
    x9 = L * L
    # Outputs
    out[..., 0] = (
        A_x * x4 * (1j * (omega_p * sigma_1 - 1 / 4 * x6) - mu_x * omega_p) + L * f * (1 / 32 * mu_x
        + 1j * (1 / 16 * sigma_1 + 1 / 32 * sigma_2 - 1 / 8 * omega_p)) / x7
        + L * r * x5 * (3 / 4 * mu_p + 1 / 8 * mu_x + 1j * (1 / 8 * sigma_1 - 1 / 2 * omega_p))
        + r * x1 * x2 * x3 - x0 * (sigma_1 + sigma_2)
    )
    out[..., 1] = (
        A_theta * mu_p * x4 * (-1 / 2 * 1j * mu_p - omega_p)
        + A_x * x1 * (mu_x + 1j * (-sigma_1 - x2)) / L + 1 / 8 * f * x4 * x8
        + 3 * omega_p * x3 * np.conj(A_x) / x9 + 1 / 4 * omega_p * x5 * x8 * (2 * r - 1)
        - 1j * A_theta * (1 / 2 * sigma_1 + 1 / 2 * sigma_2)
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_p: ArrayLike, r: ArrayLike, mu_x: ArrayLike, mu_p: ArrayLike, f: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma_1 : array_like
        Detuning, omega_x = 2*omega_p + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length of the pendulum, m, > 0.
    omega_p : array_like
        Natural frequency of the pendulum, rad/s, > 0.
    r : array_like
        Mass of the bob over both masses, m/(M + m), > 0.
    mu_x : array_like
        Damping of the mass, 1/s, >= 0.
    mu_p : array_like
        Damping of the pendulum, 1/s, >= 0.
    f : array_like
        Force over both masses and the length, F/((M + m) L), 1/s^2, >= 0.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_p=omega_p, r=r, mu_x=mu_x,
        mu_p=mu_p, f=f,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))
