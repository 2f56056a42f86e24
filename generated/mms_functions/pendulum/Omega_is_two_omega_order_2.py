# Emitted by mmsgen 0.1.0 from derivations/pendulum.py: change that, not this file.
# Made from sha256 44ef3107447cbc5992f0b2c4c1d8998f2ec494c6f874ed5052b2dddf2f077155
# Operations for each point: slow_flow 46, coefficients 27, backbone 18, motion 16
"""pendulum: Omega = 2*omega + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of theta. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapters 4 and 5
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


def _coefficients(out, sigma, omega, z, mu):
    # Intermediates
    x0 = 1 / 2 * 1j
    x1 = mu * mu
    x2 = z * z
    x3 = omega * omega
    x4 = 1j * omega
    x5 = x4 * z
    # Outputs
    out[..., 0] = -x0 * z * (2 * omega + sigma)
    out[..., 1] = (1j * (3 / 4 * x2 * x3 - 1 / 2 * x1) - mu * omega) / omega - sigma * x0
    out[..., 2] = 7 / 16 * x5
    out[..., 3] = -1 / 4 * mu - 1 / 4 * x4
    out[..., 4] = 5 / 16 * x5
    out[..., 5] = 1 / 64 * x4


def _backbone(a_theta, omega, z, mu):
    # Intermediates
    x0 = mu * mu
    x1 = z * z
    x2 = omega * omega
    x3 = a_theta * a_theta
    x4 = x3 * x3
    # Outputs
    rate = 1 / 512 * omega * x4 + 1 / 2 * (3 * x1 * x2 - 2 * x0) / omega - 1 / 8 * omega * x3
    return rate


def _motion(out, sigma, omega, z, mu):
    # Intermediates
    x0 = z * z
    x1 = 1 / omega
    x2 = 1 / 8 * z
    # Outputs
    out[..., 0] = 2
    out[..., 1] = -1 / 2 * z
    out[..., 2] = -1 / 24
    out[..., 3] = -3 / 8 * x0
    out[..., 4] = -sigma * x1 * x2
    out[..., 5] = x0 / 24
    out[..., 6] = x2
    out[..., 7] = 1 / 16 * 1j * mu * x1
    out[..., 8] = z / 24
    out[..., 9] = -1 / 128
    out[..., 10] = 1 / 640
    out[..., 11] = omega + 1 / 2 * sigma
    out[..., 12] = 2 * omega + sigma


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


def equilibria(
    *, sigma: ArrayLike, omega: ArrayLike, z: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = 2*omega + sigma, rad/s, real.
    omega : array_like
        Natural frequency, root of g/l, rad/s, > 0.
    z : array_like
        Amplitude of the support up and down, over l, >= 0.
    mu : array_like
        Damping, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, z=z, mu=mu)
    return equilibria_at(
        equilibria_of_one,
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega", "z", "mu") if gradient else (),
    )


def frequency_response(
    *, sigma: ArrayLike, omega: ArrayLike, z: ArrayLike, mu: ArrayLike, over: str = "sigma",
    gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = 2*omega + sigma, rad/s, real.
    omega : array_like
        Natural frequency, root of g/l, rad/s, > 0.
    z : array_like
        Amplitude of the support up and down, over l, >= 0.
    mu : array_like
        Damping, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, z=z, mu=mu)
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega", "z", "mu"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, omega: ArrayLike, z: ArrayLike, mu: ArrayLike,
    gradient: bool = False,
) -> Any:
    """The detuning sigma on the backbone curve.

    Where the conservative part of the slow flow that no phase enters is at rest; free motions
    without damping lie on it, and the responses of weakly damped ones close by.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    omega : array_like
        Natural frequency, root of g/l, rad/s, > 0.
    z : array_like
        Amplitude of the support up and down, over l, >= 0.
    mu : array_like
        Damping, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, omega=omega, z=z, mu=mu)
    return backbone_at(
        _backbone,
        amplitude,
        arguments,
        ("omega", "z", "mu") if gradient else (),
    )


def jacobian(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega: ArrayLike, z: ArrayLike, mu: ArrayLike,
    gradient: bool = False,
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
        Natural frequency, root of g/l, rad/s, > 0.
    z : array_like
        Amplitude of the support up and down, over l, >= 0.
    mu : array_like
        Damping, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, z=z, mu=mu)
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega", "z", "mu") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega: ArrayLike, z: ArrayLike, mu: ArrayLike,
    gradient: bool = False,
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
        Natural frequency, root of g/l, rad/s, > 0.
    z : array_like
        Amplitude of the support up and down, over l, >= 0.
    mu : array_like
        Damping, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, z=z, mu=mu)
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega", "z", "mu") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega: ArrayLike, z: ArrayLike,
    mu: ArrayLike, order: int | None = None, gradient: bool = False,
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
        Natural frequency, root of g/l, rad/s, > 0.
    z : array_like
        Amplitude of the support up and down, over l, >= 0.
    mu : array_like
        Damping, 1/s, >= 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 1), in the order theta; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, z=z, mu=mu)
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        slow=(_FLOW, _coefficients, 4),
        names=("sigma", "omega", "z", "mu") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, omega: ArrayLike, z: ArrayLike,
    mu: ArrayLike,
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
        Natural frequency, root of g/l, rad/s, > 0.
    z : array_like
        Amplitude of the support up and down, over l, >= 0.
    mu : array_like
        Damping, 1/s, >= 0.

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
    arguments = checked(PARAMETERS, sigma=sigma, omega=omega, z=z, mu=mu)
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 4, False))
