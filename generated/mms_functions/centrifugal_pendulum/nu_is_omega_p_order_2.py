# Emitted by mmsgen 0.1.0 from derivations/centrifugal_pendulum.py: change that, not this file.
# Made from sha256 d504bde0944606699ee24dc964eed0c0fdb5816f66518f657c1d8e119b233297
# Operations for each point: slow_flow 36, coefficients 27, backbone 15, motion 44
"""centrifugal_pendulum: nu = omega_p + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of psi, phi. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: -omega_p + omega_r.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Newland, J. Engineering for Industry 86 (1964) 257-263
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._flow import Flow
from .._initial import initial_at
from .._many_amplitudes import equilibria_of_many
from .._modes import modes_at
from .._motion import Motion, response_at
from .._nonlinear import equilibria_at, jacobian_at, response_along, stability_at
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


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    2,
    (
        (0, (1, 0, 0, 0, 0, 0)), (1, (0, 0, 0, 0, 0, 0)), (1, (0, 0, 0, 1, 0, 0)),
        (1, (0, 0, 0, 2, 1, 0)),
    ),
    ((1, 0),),
)

#: terms of free motions without damping
_FREE = Flow(
    2,
    (
        (0, (1, 0, 0, 0, 0, 0)), (1, (0, 0, 0, 1, 0, 0)), (1, (0, 0, 0, 2, 1, 0)),
    ),
    ((1, 0), (0, 1)),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (1, 0, 0, 0, 0, 0), (0,)), (0, 1, (0, 0, 0, 1, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 0, 0, 0), (1,)), (1, 0, (0, 0, 0, 1, 0, 0), (0,)),
        (1, 1, (1, 0, 0, 0, 0, 0), (0,)), (2, 0, (0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 2, 0, 0), (0,)), (2, 1, (0, 0, 0, 3, 0, 0), (0,)),
        (2, 1, (1, 0, 0, 0, 1, 0), (0,)), (2, 1, (1, 0, 0, 1, 0, 0), (0,)),
    ),
    1,
)


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


def _coefficients(out, sigma, omega_r, omega_p, n, b, mu, tau):
    # Intermediates
    x0 = omega_p + omega_r
    x1 = 1 / x0
    x2 = omega_r - omega_p
    x3 = 1 / x2
    x4 = x1 * x3
    x5 = 1 / 2 * 1j * b
    x6 = omega_p * omega_p
    x7 = 1 / 4 * 1j * omega_p
    x8 = n * n
    x9 = omega_p * x6
    # Outputs
    out[..., 0] = omega_r * x4 * x5 * x6
    out[..., 1] = -tau * x4 * x7 * (x8 + 1)
    out[..., 2] = x1 * x3 * (-mu * x0 * x2 - x5 * x9) - 1j * sigma
    out[..., 3] = -x7


def _backbone(out, omega_r, omega_p, n, b, mu, tau):
    # Intermediates
    x0 = 1 / 2 * 1j * b / ((omega_r - omega_p) * (omega_p + omega_r))
    x1 = omega_p * omega_p
    x2 = omega_p * x1
    # Outputs
    out[..., 0] = omega_r * x0 * x1
    out[..., 1] = -x0 * x2
    out[..., 2] = -1 / 4 * 1j * omega_p


def _motion(out, sigma, omega_r, omega_p, n, b, mu, tau):
    # Intermediates
    x0 = omega_p + omega_r
    x1 = -omega_r
    x2 = -omega_p - x1
    x3 = 1 / (x0 * x2)
    x4 = n * n
    x5 = x4 + 1
    x6 = 2 * x3
    x7 = omega_p * omega_p
    x8 = b * x7
    x9 = omega_r * omega_r
    x10 = 2 * omega_p
    x11 = x0 * x0
    x12 = x2 * x2
    x13 = 1 / (-x1 - x10)
    x14 = 1 / (omega_r + x10)
    x15 = x5 * x5
    x16 = 4 * 1j * n * omega_p
    x17 = omega_p + sigma
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = tau * x3
    out[..., 3] = x6 * x8 / x5
    out[..., 4] = -x5 * x6 * x9
    out[..., 5] = sigma * tau * x10 / (x11 * x12)
    out[..., 6] = 4 * 1j * n * x13 * x14 * x8 / x15
    out[..., 7] = -1 / 24
    out[..., 8] = x13 * x16
    out[..., 9] = x14 * x16
    out[..., 10] = omega_r
    out[..., 11] = x17
    out[..., 12] = x17


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


def equilibria(
    *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike, n: ArrayLike, b: ArrayLike,
    mu: ArrayLike, tau: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN. B_j exp(i k_j θ) moves along a circle of
    further ones for k = (1, 0); of each circle one point is given, and the rate at which it drifts,
    B_j exp(i k_j ρ t).

    Parameters
    ----------
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
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Equilibria
        The arrays amplitudes (..., count, 2), drift (..., count, 1) in rad/s and growth (...,
        count) in 1/s, which is negative where an equilibrium is stable. With gradient also name ->
        derivatives of amplitudes, drift and growth, NaN where equilibria meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return equilibria_at(
        equilibria_of_many,
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega_r", "omega_p", "n", "b", "mu", "tau") if gradient else (),
    )


def frequency_response(
    *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike, n: ArrayLike, b: ArrayLike,
    mu: ArrayLike, tau: ArrayLike, over: str = "sigma", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
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
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega_r", "omega_p", "n", "b", "mu", "tau"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, omega_r: ArrayLike, omega_p: ArrayLike, n: ArrayLike, b: ArrayLike,
    mu: ArrayLike, tau: ArrayLike, of: str = "psi",
) -> Any:
    """Free motions without damping in which one coordinate has a given amplitude.

    All periodic ones: normal modes, whose frequencies over the amplitude are the backbone curves of
    the responses. Forces and damping are left out.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
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
    of : str, optional
        That coordinate.

    Returns
    -------
    Backbone
        The arrays amplitudes (..., count, 2), shift (..., count, 2) of the frequency of each
        coordinate in rad/s, detuning (..., count) of a force at that frequency in rad/s, and growth
        (..., count) in 1/s, zero where a motion is stable; NaN where there are fewer.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau)
    return modes_at(_FREE, (0.0, 1.0), _backbone, arguments, amplitude, COORDINATES, of)


def jacobian(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike,
    n: ArrayLike, b: ArrayLike, mu: ArrayLike, tau: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`, turned along its symmetries so that the amplitudes given drift as
    little as they can; an equilibrium then is at rest.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
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
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 4, 4), in 1/s, rows and columns u_1, v_1, u_2, …; with gradient this and name ->
        derivatives, the amplitudes fixed.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega_r", "omega_p", "n", "b", "mu", "tau") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike,
    n: ArrayLike, b: ArrayLike, mu: ArrayLike, tau: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t). Each symmetry that moves the point has
    a zero, which is left out.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
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
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    complex128
        Shape (..., 4), in 1/s; NaN at the end for those that are left out; with gradient this and
        name -> derivatives, the amplitudes fixed; NaN where eigenvalues meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega_r", "omega_p", "n", "b", "mu", "tau") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_r: ArrayLike,
    omega_p: ArrayLike, n: ArrayLike, b: ArrayLike, mu: ArrayLike, tau: ArrayLike,
    order: int | None = None, drift: ArrayLike | None = None, gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. With a drift, constant ones turn along the
    symmetries of the slow flow. NaN where a harmonic resonates itself. Derivatives are taken with
    these fixed. Over times of order 1/ε the error is O(ε^2). A UserWarning says how much is left
    out where that is more than a tenth of the motion, estimated from the harmonics of each order
    beside those of order zero, and from the terms of the slow flow.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
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
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
    drift : array_like, optional
        Of an equilibrium that drifts, shape (..., 1), rad/s: as `equilibria` gives it.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2), in the order psi, phi; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        drift=drift,
        slow=(_FLOW, _coefficients, 7),
        names=("sigma", "omega_r", "omega_p", "n", "b", "mu", "tau") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, omega_r: ArrayLike, omega_p: ArrayLike,
    n: ArrayLike, b: ArrayLike, mu: ArrayLike, tau: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at t = 0 of the motion with given coordinates and velocities there.

    The solution of response(0, amplitudes) = q, and of its derivative along slow_flow = v, that
    goes over into that of order zero as the small parameters go to zero.

    Parameters
    ----------
    q : array_like
        Coordinates at t = 0, shape (..., 2), in the order of COORDINATES.
    v : array_like
        Velocities at t = 0, shape (..., 2), per second.
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
        Shape (..., 2), complex128; NaN where there is none near that of order zero, as far outside
        of the scaling, or where a harmonic resonates itself.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_r=omega_r, omega_p=omega_p, n=n, b=b, mu=mu, tau=tau,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 7, False))
