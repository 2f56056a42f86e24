# Emitted by mmsgen 0.1.0 from derivations/mathieu_duffing.py: change that, not this file.
# Made from sha256 e7338a4e0074f6d34716c5544c837d9a29e1919166265e26b283ab06148c6a8b
# Operations for each point: slow_flow 74
"""mathieu_duffing: Omega = 2*omega + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of u. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5
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
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = 2*omega + sigma"),
    "omega": ("positive", "rad/s", "natural frequency"),
    "f": ("real", "rad^2/s^2", "half the modulation of the stiffness"),
    "alpha": ("real", "1/(m^2 s^2)", "cubic stiffness over the mass"),
    "mu": ("real", "1/s", "damping; negative where the oscillator excites itself"),
    "eta": ("real", "1/(m^2 s)", "damping that grows with the displacement"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {"sigma": 1 / 2},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


def _slow_flow(out, A_u, sigma, omega, f, alpha, mu, eta):
    # Intermediates
    x0 = 1 / 2 * 1j
    x1 = np.conj(A_u)
    x2 = omega * omega
    x3 = x1 / x2
    x4 = 1j * alpha
    x5 = eta * omega
    x6 = omega * x2
    x7 = 1 / x6
    x8 = A_u * A_u
    x9 = A_u * x8
    x10 = x7 * x9
    x11 = A_u * x7
    x12 = 1 / 2 * x2
    x13 = x1 * x1
    x14 = f * f
    x15 = mu * mu
    x16 = alpha * alpha
    x17 = eta * eta
    # Outputs
    out[..., 0] = (
        f * x10 * (7 / 16 * x4 + 1 / 16 * x5) + f * x11 * x13 * (-3 / 16 * x4 - 3 / 16 * x5)
        + 1 / 4 * 1j * f * x3 * (2 * omega - sigma)
        + x10 * x13 * (1 / 2 * alpha * x5 + 1j * (-15 / 16 * x16 - 7 / 16 * x17 * x2))
        + x11 * (1j * (3 / 16 * x14 - x12 * x15) - mu * x6)
        + x3 * x8 * (3 / 2 * alpha * mu - eta * x12 - omega * x0 * (2 * eta * mu - 3 * alpha))
        - A_u * sigma * x0
    )


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega: ArrayLike, f: ArrayLike, alpha: ArrayLike,
    mu: ArrayLike, eta: ArrayLike,
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
        Natural frequency, rad/s, > 0.
    f : array_like
        Half the modulation of the stiffness, rad^2/s^2, real.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.
    mu : array_like
        Damping; negative where the oscillator excites itself, 1/s, real.
    eta : array_like
        Damping that grows with the displacement, 1/(m^2 s), real.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, f=f, alpha=alpha, mu=mu, eta=eta)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))
