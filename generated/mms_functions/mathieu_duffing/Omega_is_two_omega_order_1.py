# Emitted by mmsgen 0.1.0 from derivations/mathieu_duffing.py: change that, not this file.
# Made from sha256 b9164ff20bf3e85272ef40f1a8ff7234c8ece9deb235666988569fba715a1efc
# Operations for each point: slow_flow 20
"""mathieu_duffing: Omega = 2*omega + sigma, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of u. Results are written at ε = 1.

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
ORDER = 1

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
    x1 = np.conj(A_u) / omega
    x2 = A_u * A_u
    # Outputs
    out[..., 0] = (
        f * x0 * x1 + x1 * x2 * (3 / 2 * 1j * alpha - 1 / 2 * eta * omega) - A_u * mu
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
