# Emitted by mmsgen 0.1.0 from derivations/mathieu_duffing.py: change that, not this file.
# Made from sha256 c19959226a0c5dbfc123fb71ffe9292eb82d94281f1e441a37b1dcdfee033089
# Operations for each point: slow_flow 74, coefficients 57, backbone 32, motion 58
"""mathieu_duffing: Omega = 2*omega + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of u. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._flow import Flow
from .._initial import initial_at
from .._motion import Motion, response_at
from .._nonlinear import backbone_at, equilibria_at, jacobian_at, response_along, stability_at
from .._one_amplitude import equilibria_of_one
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
    "backbone",
    "equilibria",
    "frequency_response",
    "initial_amplitudes",
    "jacobian",
    "response",
    "slow_flow",
    "stability",
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


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    1,
    (
        (0, (0, 1, 0)), (0, (1, 0, 0)), (0, (1, 2, 0)), (0, (2, 1, 0)), (0, (3, 0, 0)),
        (0, (3, 2, 0)),
    ),
    (),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    1,
    (
        (0, 0, (1, 0, 0), (0,)), (1, 0, (1, 0, 0), (1,)), (1, 0, (3, 0, 0), (0,)),
        (2, 0, (1, 0, 0), (-2,)), (2, 0, (1, 0, 0), (1,)), (2, 0, (1, 0, 0), (2,)),
        (2, 0, (2, 1, 0), (1,)), (2, 0, (3, 0, 0), (0,)), (2, 0, (3, 0, 0), (1,)),
        (2, 0, (4, 1, 0), (0,)), (2, 0, (5, 0, 0), (0,)),
    ),
    1,
)


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


def _coefficients(out, sigma, omega, f, alpha, mu, eta):
    # Intermediates
    x0 = omega * omega
    x1 = 1 / x0
    x2 = 1 / 2 * 1j
    x3 = omega * x0
    x4 = 1 / x3
    x5 = 1 / 2 * x0
    x6 = f * f
    x7 = mu * mu
    x8 = 1j * alpha
    x9 = eta * omega
    x10 = f * x4
    x11 = alpha * alpha
    x12 = eta * eta
    # Outputs
    out[..., 0] = 1 / 4 * 1j * f * x1 * (2 * omega - sigma)
    out[..., 1] = x4 * (1j * (3 / 16 * x6 - x5 * x7) - mu * x3) - sigma * x2
    out[..., 2] = x10 * (-3 / 16 * x8 - 3 / 16 * x9)
    out[..., 3] = x1 * (3 / 2 * alpha * mu - eta * x5 - omega * x2 * (2 * eta * mu - 3 * alpha))
    out[..., 4] = x10 * (7 / 16 * x8 + 1 / 16 * x9)
    out[..., 5] = x4 * (1 / 2 * alpha * x9 + 1j * (-7 / 16 * x0 * x12 - 15 / 16 * x11))


def _backbone(a_u, omega, f, alpha, mu, eta):
    # Intermediates
    x0 = omega * omega
    x1 = omega * x0
    x2 = 1 / x1
    x3 = f * f
    x4 = mu * mu
    x5 = a_u * a_u
    x6 = x5 * x5
    x7 = alpha * alpha
    x8 = eta * eta
    # Outputs
    rate = (
        1 / 8 * x2 * (3 * x3 - 8 * x0 * x4) + 1 / 4 * x5 * (3 * alpha - 2 * eta * mu) / omega
        - 1 / 128 * x2 * x6 * (7 * x0 * x8 + 15 * x7)
    )
    return rate


def _motion(out, sigma, omega, f, alpha, mu, eta):
    # Intermediates
    x0 = omega * omega
    x1 = 1 / x0
    x2 = eta * omega
    x3 = 1j * x2
    x4 = x0 * x0
    x5 = 1 / x4
    x6 = f * f
    x7 = x5 * x6
    x8 = omega * x0
    x9 = 1 / x8
    x10 = 3 / 16 * alpha
    x11 = 1 / 32 * x3
    x12 = 2 * x5
    x13 = f * x12
    x14 = 1j * x10
    x15 = eta * eta
    x16 = x0 * x15
    x17 = alpha * alpha
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 1 / 4 * f * x1
    out[..., 2] = 2 * x1 * (1 / 8 * alpha + 1 / 8 * x3)
    out[..., 3] = -3 / 32 * x7
    out[..., 4] = -3 / 16 * f * sigma * x9
    out[..., 5] = x7 / 96
    out[..., 6] = x13 * (-x10 - x11)
    out[..., 7] = 2 * mu * x9 * (1 / 16 * eta * omega - x14)
    out[..., 8] = x13 * (alpha / 48 + x11)
    out[..., 9] = x12 * (-x14 * x2 - 1 / 64 * x16 - 21 / 64 * x17)
    out[..., 10] = x12 * (alpha * x3 / 24 + 1 / 64 * x17 - 5 * x16 / 192)
    out[..., 11] = omega + 1 / 2 * sigma
    out[..., 12] = 2 * omega + sigma


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


def equilibria(
    *, sigma: ArrayLike, omega: ArrayLike, f: ArrayLike, alpha: ArrayLike, mu: ArrayLike,
    eta: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN.

    Parameters
    ----------
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
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Equilibria
        The arrays amplitudes (..., count, 1), drift (..., count, 0) in rad/s and growth (...,
        count) in 1/s, which is negative where an equilibrium is stable. With gradient also name ->
        derivatives of amplitudes, drift and growth, NaN where equilibria meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, f=f, alpha=alpha, mu=mu, eta=eta)
    return equilibria_at(
        equilibria_of_one,
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega", "f", "alpha", "mu", "eta") if gradient else (),
    )


def frequency_response(
    *, sigma: ArrayLike, omega: ArrayLike, f: ArrayLike, alpha: ArrayLike, mu: ArrayLike,
    eta: ArrayLike, over: str = "sigma", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
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
    over : str, optional
        Name of the one that varies.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Response
        Its name, branches (parameter, amplitudes, drift, growth) and bifurcations (saddle-nodes,
        pitchforks, transcritical and Hopf points). With gradient also name -> derivatives of the
        branches (amplitudes, drift, growth; NaN where they meet) and of the values at which the
        bifurcations lie.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, f=f, alpha=alpha, mu=mu, eta=eta)
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega", "f", "alpha", "mu", "eta"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, omega: ArrayLike, f: ArrayLike, alpha: ArrayLike, mu: ArrayLike,
    eta: ArrayLike, gradient: bool = False,
) -> Any:
    """The detuning sigma on the backbone curve.

    Where the conservative part of the slow flow that no phase enters is at rest; free motions
    without damping lie on it, and the responses of weakly damped ones close by.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
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
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        In rad/s, float64; with gradient this and name -> derivative.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega=omega, f=f, alpha=alpha, mu=mu, eta=eta)
    return backbone_at(
        _backbone,
        amplitude,
        arguments,
        ("omega", "f", "alpha", "mu", "eta") if gradient else (),
    )


def jacobian(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega: ArrayLike, f: ArrayLike, alpha: ArrayLike,
    mu: ArrayLike, eta: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
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
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2, 2), in 1/s, rows and columns u_1, v_1, u_2, …; with gradient this and name ->
        derivatives, the amplitudes fixed.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, f=f, alpha=alpha, mu=mu, eta=eta)
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega", "f", "alpha", "mu", "eta") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega: ArrayLike, f: ArrayLike, alpha: ArrayLike,
    mu: ArrayLike, eta: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t).

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
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
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    complex128
        Shape (..., 2), in 1/s; NaN at the end for those that are left out; with gradient this and
        name -> derivatives, the amplitudes fixed; NaN where eigenvalues meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, f=f, alpha=alpha, mu=mu, eta=eta)
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega", "f", "alpha", "mu", "eta") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega: ArrayLike, f: ArrayLike,
    alpha: ArrayLike, mu: ArrayLike, eta: ArrayLike, order: int | None = None,
    gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. NaN where a harmonic resonates itself. Derivatives
    are taken with these fixed. Over times of order 1/ε the error is O(ε^2). A UserWarning says how
    much is left out where that is more than a tenth of the motion, estimated from the harmonics of
    each order beside those of order zero, and from the terms of the slow flow.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
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
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 1), in the order u; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, f=f, alpha=alpha, mu=mu, eta=eta)
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        slow=(_FLOW, _coefficients, 6),
        names=("sigma", "omega", "f", "alpha", "mu", "eta") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, omega: ArrayLike, f: ArrayLike,
    alpha: ArrayLike, mu: ArrayLike, eta: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at t = 0 of the motion with given coordinates and velocities there.

    The solution of response(0, amplitudes) = q, and of its derivative along slow_flow = v, that
    goes over into that of order zero as the small parameters go to zero.

    Parameters
    ----------
    q : array_like
        Coordinates at t = 0, shape (..., 1), in the order of COORDINATES.
    v : array_like
        Velocities at t = 0, shape (..., 1), per second.
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
        Shape (..., 1), complex128; NaN where there is none near that of order zero, as far outside
        of the scaling, or where a harmonic resonates itself.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, f=f, alpha=alpha, mu=mu, eta=eta)
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 6, False))
