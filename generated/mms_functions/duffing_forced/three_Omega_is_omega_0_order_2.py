# Emitted by mmsgen 0.1.0 from derivations/duffing_forced.py: change that, not this file.
# Made from sha256 7476a3ecbf703b41f735fd198edaab0d6f8cb8ce2d70dfa6a4e5cb8d37e3806f
# Operations for each point: slow_flow 89, coefficients 70, backbone 45, motion 136
"""duffing_forced: 3*Omega = omega_0 + sigma, order 2.

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
RELATIONS: tuple[str, ...] = ("3*Omega = omega_0 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, 3*Omega = omega_0 + sigma"),
    "omega_0": ("positive", "rad/s", "frequency of small oscillations"),
    "alpha": ("positive", "1/(m^2 s^2)", "cubic stiffness over the mass"),
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
        (0, (0, 0, 0)), (0, (1, 0, 0)), (0, (1, 1, 0)), (0, (2, 0, 0)), (0, (2, 1, 0)),
        (0, (3, 2, 0)),
    ),
    (),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    1,
    (
        (0, 0, (0, 0, 0), (1,)), (0, 0, (1, 0, 0), (0,)), (1, 0, (0, 0, 0), (1,)),
        (1, 0, (1, 0, 0), (-2,)), (1, 0, (1, 0, 0), (2,)), (1, 0, (1, 1, 0), (1,)),
        (1, 0, (2, 0, 0), (-1,)), (1, 0, (2, 0, 0), (1,)), (1, 0, (3, 0, 0), (0,)),
        (2, 0, (0, 0, 0), (1,)), (2, 0, (0, 0, 0), (5,)), (2, 0, (1, 0, 0), (-4,)),
        (2, 0, (1, 0, 0), (-2,)), (2, 0, (1, 0, 0), (2,)), (2, 0, (1, 0, 0), (4,)),
        (2, 0, (1, 1, 0), (1,)), (2, 0, (2, 0, 0), (-1,)), (2, 0, (2, 0, 0), (1,)),
        (2, 0, (2, 0, 0), (3,)), (2, 0, (2, 1, 0), (-2,)), (2, 0, (2, 1, 0), (2,)),
        (2, 0, (2, 2, 0), (1,)), (2, 0, (3, 0, 0), (-2,)), (2, 0, (3, 0, 0), (0,)),
        (2, 0, (3, 0, 0), (2,)), (2, 0, (3, 1, 0), (-1,)), (2, 0, (3, 1, 0), (1,)),
        (2, 0, (4, 0, 0), (-1,)), (2, 0, (4, 0, 0), (1,)), (2, 0, (4, 1, 0), (0,)),
        (2, 0, (5, 0, 0), (0,)),
    ),
    1,
)


def _slow_flow(out, A_u, sigma, omega_0, alpha, mu, K):
    # Intermediates
    x0 = 1j * A_u
    x1 = alpha * alpha
    x2 = 1j * x1
    x3 = K * K
    x4 = K * x3
    x5 = omega_0 * omega_0
    x6 = x5 * x5
    x7 = x6 * x6
    x8 = omega_0 * x7
    x9 = x4 / x8
    x10 = np.conj(A_u)
    x11 = omega_0 * x6
    x12 = mu * x11
    x13 = alpha * x3
    x14 = A_u * A_u
    x15 = x5 * x6
    x16 = omega_0 * x5
    x17 = x16 * x7
    x18 = x3 * x3
    x19 = mu * mu
    x20 = x5 * x7
    x21 = x11 * x7
    x22 = x10 * x10
    x23 = A_u * x14
    x24 = x16 * x6
    # Outputs
    out[..., 0] = (
        A_u * (1j * (243 / 512 * alpha * sigma * x11 * x3 + 243 / 256 * alpha * x15 * x3
        - 5727753 / 2097152 * x1 * x18 - 1 / 2 * x19 * x20) - mu * x17) / x17
        + alpha * x10 * x14 * (3 / 2 * x12 + 1j * (3 / 2 * x15 - 245673 * x13 / 20480)) / x24
        + alpha * x4 * (5103 / 32768 * x12 + 1j * (729 / 32768 * sigma * x11 + 729 / 8192 * x15
        - 5491557 / 16777216 * x13)) / x21 - sigma * x0 - 185895 / 65536 * x0 * x1 * x10 * x9
        - 168399 / 131072 * x14 * x2 * x9 - 15 / 16 * x2 * x22 * x23 / x16
    )


def _coefficients(out, sigma, omega_0, alpha, mu, K):
    # Intermediates
    x0 = omega_0 * omega_0
    x1 = x0 * x0
    x2 = omega_0 * x1
    x3 = mu * x2
    x4 = K * K
    x5 = alpha * x4
    x6 = K * x4
    x7 = x0 * x1
    x8 = x1 * x1
    x9 = x2 * x8
    x10 = omega_0 * x0
    x11 = x10 * x8
    x12 = alpha * alpha
    x13 = x4 * x4
    x14 = mu * mu
    x15 = x0 * x8
    x16 = 1j * x12
    x17 = omega_0 * x8
    x18 = x16 * x6 / x17
    x19 = x1 * x10
    # Outputs
    out[..., 0] = (
        alpha * x6 * (5103 / 32768 * x3
        + 1j * (729 / 32768 * sigma * x2 + 729 / 8192 * x7 - 5491557 / 16777216 * x5)) / x9
    )
    out[..., 1] = (
        (1j * (243 / 512 * alpha * sigma * x2 * x4 + 243 / 256 * alpha * x4 * x7
        - 5727753 / 2097152 * x12 * x13 - 1 / 2 * x14 * x15) - mu * x11) / x11 - 1j * sigma
    )
    out[..., 2] = -185895 / 65536 * x18
    out[..., 3] = -168399 / 131072 * x18
    out[..., 4] = alpha * (3 / 2 * x3 + 1j * (3 / 2 * x7 - 245673 * x5 / 20480)) / x19
    out[..., 5] = -15 / 16 * x16 / x10


def _backbone(a_u, omega_0, alpha, mu, K):
    # Intermediates
    x0 = K * K
    x1 = alpha * x0
    x2 = omega_0 * omega_0
    x3 = x2 * x2
    x4 = x2 * x3
    x5 = 1 / (243 * x1 - 512 * x4)
    x6 = alpha * alpha
    x7 = omega_0 * x3
    x8 = mu * mu
    x9 = x3 * x3
    x10 = x2 * x9
    x11 = x0 * x0
    x12 = a_u * a_u
    x13 = x12 * x12
    x14 = omega_0 * x2
    # Outputs
    rate = (
        3 * alpha * x12 * x5 * (81891 * x1 - 10240 * x4) / (160 * omega_0)
        + 30 * x13 * x14 * x5 * x6
        + 1 / 4096 * x5 * (1048576 * x10 * x8 + 5727753 * x11 * x6 - 1990656 * x1 * x4) / x7
    )
    return rate


def _motion(out, sigma, omega_0, alpha, mu, K):
    # Intermediates
    x0 = omega_0 * omega_0
    x1 = 1 / x0
    x2 = x0 * x0
    x3 = x2 * x2
    x4 = 1 / x3
    x5 = K * K
    x6 = alpha * x5
    x7 = 19683 / 32768 * x6
    x8 = omega_0 * x2
    x9 = 1j * mu * x8
    x10 = 2 * K
    x11 = x0 * x2
    x12 = 1 / x11
    x13 = x12 * x6
    x14 = 1 / x2
    x15 = K * alpha
    x16 = x14 * x15
    x17 = x11 * x3
    x18 = 1 / x17
    x19 = sigma * x8
    x20 = x5 * x5
    x21 = alpha * alpha
    x22 = x0 * x3
    x23 = mu * mu
    x24 = sigma * sigma
    x25 = K * x20
    x26 = x2 * x3
    x27 = 1 / x26
    x28 = x20 * x21 * x27
    x29 = 2 * x27 * x6
    x30 = 1 / x22
    x31 = alpha * x10 * x30
    x32 = K * x5
    x33 = x21 * x4 * x5
    x34 = K * x12 * x21
    x35 = x14 * x21
    # Outputs
    out[..., 0] = 9 / 8 * K * x1
    out[..., 1] = 2
    out[..., 2] = x10 * x4 * (9 / 64 * sigma * x8 - x7 - 27 / 64 * x9)
    out[..., 3] = -2187 / 1024 * x13
    out[..., 4] = 2187 / 2048 * x13
    out[..., 5] = -243 / 32 * x16
    out[..., 6] = 243 / 128 * x16
    out[..., 7] = 243 * x16 / 320
    out[..., 8] = 1 / 4 * alpha * x1
    out[..., 9] = (
        x10 * x18 * (62178597 / 33554432 * x20 * x21 + 27 / 256 * x22 * x24 - x19 * x7
        - 81 / 256 * x22 * x23 - 81 / 65536 * x9 * (512 * sigma * x8 - 729 * x6))
    )
    out[..., 10] = -23914845 / 134217728 * x18 * x21 * x25
    out[..., 11] = 3720087 / 2097152 * x28
    out[..., 12] = x29 * (531441 / 131072 * x6 - 6561 / 4096 * x9)
    out[..., 13] = x29 * (-6561 / 16384 * x19 - 15411789 / 8388608 * x6 - 6561 / 8192 * x9)
    out[..., 14] = 9034497 * x28 / 104857600
    out[..., 15] = -243 / 131072 * x15 * x30 * (2048 * sigma * x8 - 19683 * x6)
    out[..., 16] = x31 * (1701 / 2048 * sigma * x8 - 13640319 * x6 / 2621440 - 2187 / 2048 * x9)
    out[..., 17] = x31 * (-243 * x19 / 6400 - 5137263 * x6 / 13107200 - 2187 * x9 / 3200)
    out[..., 18] = 321489 * x21 * x30 * x32 / 655360
    out[..., 19] = 492075 / 16384 * x33
    out[..., 20] = -2617839 * x33 / 163840
    out[..., 21] = 216513 * x34 / 5120
    out[..., 22] = 2187 * x33 / 40960
    out[..., 23] = 2 * alpha * x4 * (26487 * x6 / 81920 - 3 / 16 * x9)
    out[..., 24] = 553311 * x33 / 1146880
    out[..., 25] = -8505 / 512 * x34
    out[..., 26] = -20169 * x34 / 3200
    out[..., 27] = 7533 * x34 / 14336
    out[..., 28] = 8991 * x34 / 51200
    out[..., 29] = -21 / 32 * x35
    out[..., 30] = 1 / 32 * x35
    out[..., 31] = omega_0 + sigma
    out[..., 32] = omega_0 / 3 + sigma / 3


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha: ArrayLike,
    mu: ArrayLike, K: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, 3*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha=alpha, mu=mu, K=K)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))


def equilibria(
    *, sigma: ArrayLike, omega_0: ArrayLike, alpha: ArrayLike, mu: ArrayLike, K: ArrayLike,
    gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN.

    Parameters
    ----------
    sigma : array_like
        Detuning, 3*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha=alpha, mu=mu, K=K)
    return equilibria_at(
        equilibria_of_one,
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega_0", "alpha", "mu", "K") if gradient else (),
    )


def frequency_response(
    *, sigma: ArrayLike, omega_0: ArrayLike, alpha: ArrayLike, mu: ArrayLike, K: ArrayLike,
    over: str = "sigma", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma : array_like
        Detuning, 3*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha=alpha, mu=mu, K=K)
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("sigma", "omega_0", "alpha", "mu", "K"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, omega_0: ArrayLike, alpha: ArrayLike, mu: ArrayLike, K: ArrayLike,
    gradient: bool = False,
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
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha=alpha, mu=mu, K=K)
    return backbone_at(
        _backbone,
        amplitude,
        arguments,
        ("omega_0", "alpha", "mu", "K") if gradient else (),
    )


def jacobian(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha: ArrayLike,
    mu: ArrayLike, K: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, 3*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha=alpha, mu=mu, K=K)
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega_0", "alpha", "mu", "K") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha: ArrayLike,
    mu: ArrayLike, K: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t).

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, 3*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha=alpha, mu=mu, K=K)
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma", "omega_0", "alpha", "mu", "K") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike,
    alpha: ArrayLike, mu: ArrayLike, K: ArrayLike, order: int | None = None, gradient: bool = False,
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
        Detuning, 3*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha=alpha, mu=mu, K=K)
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        slow=(_FLOW, _coefficients, 5),
        names=("sigma", "omega_0", "alpha", "mu", "K") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha: ArrayLike,
    mu: ArrayLike, K: ArrayLike,
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
        Detuning, 3*Omega = omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha=alpha, mu=mu, K=K)
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 5, False))
