# Emitted by mmsgen 0.1.0 from derivations/helmholtz_duffing_forced.py: change that, not this file.
# Made from sha256 e3ad2c1e5b8923039c49ec80eb2bc4cdbcfced55819fdd8de88e69277fe7417e
# Operations for each point: slow_flow 49, coefficients 41, backbone 29, motion 115
"""helmholtz_duffing_forced: 2*Omega = omega_0 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of u. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 4
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
RELATIONS: tuple[str, ...] = ("2*Omega = omega_0 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, 2*Omega = omega_0 + sigma"),
    "omega_0": ("positive", "rad/s", "frequency of small oscillations"),
    "alpha_2": ("positive", "1/(m s^2)", "quadratic stiffness over the mass"),
    "alpha_3": ("real", "1/(m^2 s^2)", "cubic stiffness over the mass"),
    "mu": ("positive", "1/s", "half the damping over the mass"),
    "K": ("positive", "m/s^2", "amplitude of the force over the mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    1,
    (
        (0, (0, 0, 0)), (0, (1, 0, 0)), (0, (2, 1, 0)),
    ),
    (),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    1,
    (
        (0, 0, (0, 0, 0), (1,)), (0, 0, (1, 0, 0), (0,)), (1, 0, (0, 0, 0), (0,)),
        (1, 0, (0, 0, 0), (1,)), (1, 0, (1, 0, 0), (-1,)), (1, 0, (1, 0, 0), (1,)),
        (1, 0, (1, 1, 0), (0,)), (1, 0, (2, 0, 0), (0,)), (2, 0, (0, 0, 0), (0,)),
        (2, 0, (0, 0, 0), (1,)), (2, 0, (0, 0, 0), (3,)), (2, 0, (1, 0, 0), (-2,)),
        (2, 0, (1, 0, 0), (-1,)), (2, 0, (1, 0, 0), (1,)), (2, 0, (1, 0, 0), (2,)),
        (2, 0, (1, 1, 0), (1,)), (2, 0, (2, 0, 0), (-1,)), (2, 0, (2, 0, 0), (0,)),
        (2, 0, (2, 0, 0), (1,)), (2, 0, (3, 0, 0), (0,)),
    ),
    1,
)


def _slow_flow(out, A_u, sigma, omega_0, alpha_2, alpha_3, mu, K):
    # Intermediates
    x0 = K * K
    x1 = omega_0 * omega_0
    x2 = x1 * x1
    x3 = x1 * x2
    x4 = alpha_2 * alpha_2
    x5 = omega_0 * x1
    x6 = x2 * x5
    x7 = mu * mu
    x8 = A_u * A_u
    # Outputs
    out[..., 0] = (
        A_u * (1j * (4 * alpha_3 * x0 * x1 / 3 - 184 * x0 * x4 / 135 - 1 / 2 * x3 * x7) - mu * x6)
        / x6 + alpha_2 * x0 * (13 * mu / 27 + 1j * (2 * omega_0 / 9 + 5 * sigma / 27)) / x3
        + 1j * x8 * (3 / 2 * alpha_3 * x1 - 5 * x4 / 3) * np.conj(A_u) / x5 - 1j * A_u * sigma
    )


def _coefficients(out, sigma, omega_0, alpha_2, alpha_3, mu, K):
    # Intermediates
    x0 = K * K
    x1 = omega_0 * omega_0
    x2 = x1 * x1
    x3 = x1 * x2
    x4 = omega_0 * x1
    x5 = x2 * x4
    x6 = alpha_2 * alpha_2
    x7 = mu * mu
    # Outputs
    out[..., 0] = alpha_2 * x0 * (13 * mu / 27 + 1j * (2 * omega_0 / 9 + 5 * sigma / 27)) / x3
    out[..., 1] = (
        (1j * (4 * alpha_3 * x0 * x1 / 3 - 184 * x0 * x6 / 135 - 1 / 2 * x3 * x7) - mu * x5) / x5
        - 1j * sigma
    )
    out[..., 2] = 1j * (3 / 2 * alpha_3 * x1 - 5 * x6 / 3) / x4


def _backbone(a_u, omega_0, alpha_2, alpha_3, mu, K):
    # Intermediates
    x0 = omega_0 * omega_0
    x1 = alpha_3 * x0
    x2 = alpha_2 * alpha_2
    x3 = K * K
    x4 = omega_0 * x0
    x5 = x0 * x0
    x6 = x4 * x5
    x7 = mu * mu
    x8 = x0 * x5
    x9 = a_u * a_u
    # Outputs
    rate = (
        -(368 * x2 * x3 + 135 * x7 * x8 - 360 * x1 * x3) / (270 * x6)
        - x9 * (10 * x2 - 9 * x1) / (24 * x4)
    )
    return rate


def _motion(out, sigma, omega_0, alpha_2, alpha_3, mu, K):
    # Intermediates
    x0 = omega_0 * omega_0
    x1 = 1 / x0
    x2 = x0 * x0
    x3 = x0 * x2
    x4 = 1 / x3
    x5 = K * K
    x6 = alpha_2 * x5
    x7 = omega_0 * x0
    x8 = 1 / x7
    x9 = 1j * mu
    x10 = 8 * x9 / 9
    x11 = 2 * K
    x12 = 1 / x2
    x13 = K * alpha_2
    x14 = x12 * x13
    x15 = alpha_2 * x1
    x16 = x2 * x7
    x17 = x2 * x2
    x18 = x0 * x17
    x19 = 1 / x18
    x20 = alpha_3 * x0
    x21 = alpha_2 * alpha_2
    x22 = mu * mu
    x23 = sigma * sigma
    x24 = K * x5
    x25 = -9 * alpha_3 * x0
    x26 = x5 / x17
    x27 = omega_0 * x2
    x28 = 1 / x27
    x29 = 45 * x20
    x30 = K * x4
    # Outputs
    out[..., 0] = 4 * K * x1 / 3
    out[..., 1] = 2
    out[..., 2] = -8 * x4 * x6 / 9
    out[..., 3] = x11 * x8 * (4 * sigma / 9 - x10)
    out[..., 4] = -32 * x14 / 9
    out[..., 5] = 32 * x14 / 15
    out[..., 6] = -2 * x15
    out[..., 7] = 2 * x15 / 3
    out[..., 8] = -32 * sigma * x6 / (27 * x16)
    out[..., 9] = (
        x11 * x19 * (256 * x21 * x5 / 243 + 14 * x23 * x3 / 27 - 56 * sigma * x3 * x9 / 27
        - 32 * x20 * x5 / 27 - 32 * x22 * x3 / 27)
    )
    out[..., 10] = 64 * x19 * x24 * (5 * alpha_3 * x0 - 12 * x21) / 675
    out[..., 11] = -8 * x26 * (-16 * x21 - x25) / 27
    out[..., 12] = -128 * x13 * x28 * x9 / 27
    out[..., 13] = alpha_2 * x11 * x28 * (-128 * sigma / 225 - 64 * x9 / 45)
    out[..., 14] = 8 * x26 * (28 * x21 + x29) / 405
    out[..., 15] = -32 * x30 * (45 * alpha_3 * x0 - 46 * x21) / 135
    out[..., 16] = 16 * x30 * (-14 * x21 - x25) / 45
    out[..., 17] = -alpha_2 * x10 * x8
    out[..., 18] = 16 * x30 * (58 * x21 + x29) / 945
    out[..., 19] = 2 * x12 * (1 / 8 * x20 + x21 / 12)
    out[..., 20] = omega_0 + sigma
    out[..., 21] = 1 / 2 * omega_0 + 1 / 2 * sigma


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike,
    alpha_3: ArrayLike, mu: ArrayLike, K: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, 2*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    alpha_3 : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, alpha_3=alpha_3, mu=mu, K=K,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))


def equilibria(
    *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike, mu: ArrayLike,
    K: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN.

    Parameters
    ----------
    sigma : array_like
        Detuning, 2*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    alpha_3 : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
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
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, alpha_3=alpha_3, mu=mu, K=K,
    )
    return equilibria_at(
        equilibria_of_one,
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega_0", "alpha_2", "alpha_3", "mu", "K") if gradient else (),
    )


def frequency_response(
    *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike, mu: ArrayLike,
    K: ArrayLike, over: str = "sigma", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma : array_like
        Detuning, 2*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    alpha_3 : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
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
        PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, alpha_3=alpha_3, mu=mu, K=K,
    )
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega_0", "alpha_2", "alpha_3", "mu", "K"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, omega_0: ArrayLike, alpha_2: ArrayLike, alpha_3: ArrayLike,
    mu: ArrayLike, K: ArrayLike, gradient: bool = False,
) -> Any:
    """The detuning sigma on the backbone curve.

    Where the conservative part of the slow flow that no phase enters is at rest; free motions
    without damping lie on it, and the responses of weakly damped ones close by.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    alpha_3 : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha_2=alpha_2, alpha_3=alpha_3, mu=mu, K=K)
    return backbone_at(
        _backbone,
        amplitude,
        arguments,
        ("omega_0", "alpha_2", "alpha_3", "mu", "K") if gradient else (),
    )


def jacobian(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike,
    alpha_3: ArrayLike, mu: ArrayLike, K: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, 2*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    alpha_3 : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
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
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, alpha_3=alpha_3, mu=mu, K=K,
    )
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega_0", "alpha_2", "alpha_3", "mu", "K") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike,
    alpha_3: ArrayLike, mu: ArrayLike, K: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t).

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, 2*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    alpha_3 : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
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
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, alpha_3=alpha_3, mu=mu, K=K,
    )
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega_0", "alpha_2", "alpha_3", "mu", "K") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike,
    alpha_2: ArrayLike, alpha_3: ArrayLike, mu: ArrayLike, K: ArrayLike, order: int | None = None,
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
        Detuning, 2*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    alpha_3 : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
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
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, alpha_3=alpha_3, mu=mu, K=K,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        slow=(_FLOW, _coefficients, 6),
        names=("sigma", "omega_0", "alpha_2", "alpha_3", "mu", "K") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike,
    alpha_3: ArrayLike, mu: ArrayLike, K: ArrayLike,
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
        Detuning, 2*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    alpha_3 : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), real.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.

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
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, alpha_3=alpha_3, mu=mu, K=K,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 6, False))
