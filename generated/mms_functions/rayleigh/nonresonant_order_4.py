# Emitted by mmsgen 0.1.0 from derivations/rayleigh.py: change that, not this file.
# Made from sha256 9f8ea8200ac35cb9381eea15a5df3ea6e83c9c5e20d072ba7ac9a7665f6f95c2
# Operations for each point: slow_flow 57, coefficients 36, backbone 31, motion 38
"""rayleigh: no resonance, order 4.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 4 in ε, of u. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 3
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
RELATIONS: tuple[str, ...] = ()

#: the highest power of ε
ORDER = 4

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "omega_0": ("positive", "rad/s", "natural frequency"),
    "mu": ("positive", "1/s", "strength of the self-excitation, which turns at 1 m/s"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    1,
    (
        (0, (1, 0, 0)), (0, (2, 1, 0)), (0, (3, 2, 0)), (0, (4, 3, 0)), (0, (5, 4, 0)),
    ),
    ((1,),),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    1,
    (
        (0, 0, (1, 0, 0), ()), (1, 0, (3, 0, 0), ()), (2, 0, (3, 0, 0), ()), (2, 0, (4, 1, 0), ()),
        (2, 0, (5, 0, 0), ()), (3, 0, (3, 0, 0), ()), (3, 0, (4, 1, 0), ()), (3, 0, (5, 0, 0), ()),
        (3, 0, (5, 2, 0), ()), (3, 0, (6, 1, 0), ()), (3, 0, (7, 0, 0), ()), (4, 0, (3, 0, 0), ()),
        (4, 0, (4, 1, 0), ()), (4, 0, (5, 0, 0), ()), (4, 0, (5, 2, 0), ()), (4, 0, (6, 1, 0), ()),
        (4, 0, (6, 3, 0), ()), (4, 0, (7, 0, 0), ()), (4, 0, (7, 2, 0), ()), (4, 0, (8, 1, 0), ()),
        (4, 0, (9, 0, 0), ()),
    ),
    0,
)


def _slow_flow(out, A_u, omega_0, mu):
    # Intermediates
    x0 = np.conj(A_u)
    x1 = 1j * mu
    x2 = omega_0 * omega_0
    x3 = omega_0 * x2
    x4 = mu * mu
    x5 = A_u * A_u
    x6 = x0 * x0
    x7 = x0 * x6
    x8 = x5 * x5
    x9 = mu * x4
    x10 = A_u * x5
    x11 = x6 * x6
    x12 = A_u * x8
    x13 = x4 * x4
    x14 = x2 * x2
    x15 = omega_0 * x14
    # Outputs
    out[..., 0] = (
        A_u * mu * (1 / 2 * x3 - 1 / 128 * x1 * (16 * x2 + x4)) / x3
        + omega_0 * x10 * x4 * x6 * (11 / 64 * mu * omega_0 + 1j * (1 / 16 * x2 + 13 / 256 * x4))
        + 65 * 1j * x11 * x12 * x13 * x15 / 3072
        + x3 * x7 * x8 * x9 * (-13 / 128 * omega_0 - 39 / 512 * x1) - 1 / 2 * mu * x0 * x2 * x5
    )


def _coefficients(out, omega_0, mu):
    # Intermediates
    x0 = 1j * mu
    x1 = omega_0 * omega_0
    x2 = omega_0 * x1
    x3 = mu * mu
    x4 = mu * x3
    x5 = x3 * x3
    x6 = x1 * x1
    x7 = omega_0 * x6
    # Outputs
    out[..., 0] = mu * (1 / 2 * x2 - 1 / 128 * x0 * (16 * x1 + x3)) / x2
    out[..., 1] = -1 / 2 * mu * x1
    out[..., 2] = omega_0 * x3 * (11 / 64 * mu * omega_0 + 1j * (1 / 16 * x1 + 13 / 256 * x3))
    out[..., 3] = x2 * x4 * (-13 / 128 * omega_0 - 39 / 512 * x0)
    out[..., 4] = 65 * 1j * x5 * x7 / 3072


def _backbone(a_u, omega_0, mu):
    # Intermediates
    x0 = omega_0 * omega_0
    x1 = 16 * x0
    x2 = mu * mu
    x3 = x2 * x2
    x4 = omega_0 * x0
    x5 = a_u * a_u
    x6 = x5 * x5
    x7 = x5 * x6
    x8 = x6 * x6
    x9 = x0 * x0
    x10 = omega_0 * x9
    # Outputs
    rate = (
        1 / 4096 * omega_0 * x2 * x6 * (x1 + 13 * x2) + 65 * x10 * x3 * x8 / 786432
        - 1 / 128 * x2 * (x1 + x2) / x4 - 39 / 32768 * x3 * x4 * x7
    )
    return rate


def _motion(out, omega_0, mu):
    # Intermediates
    x0 = 1j * omega_0
    x1 = mu * mu
    x2 = omega_0 * omega_0
    x3 = x1 * x2
    x4 = mu * x1
    x5 = 1j * x4
    x6 = x0 * x4
    x7 = omega_0 * x2
    x8 = x5 * x7
    x9 = x1 * x1
    x10 = x2 * x9
    x11 = x2 * x2
    x12 = x11 * x9
    # Outputs
    out[..., 0] = 2
    out[..., 1] = -mu * x0 / 12
    out[..., 2] = -1 / 16 * x1
    out[..., 3] = 3 / 32 * x3
    out[..., 4] = -x3 / 96
    out[..., 5] = 1 / 64 * x5 / omega_0
    out[..., 6] = 7 / 128 * x6
    out[..., 7] = 17 * x6 / 1152
    out[..., 8] = -37 * x8 / 768
    out[..., 9] = -17 * x8 / 768
    out[..., 10] = x8 / 576
    out[..., 11] = -x9 / (768 * x2)
    out[..., 12] = -27 / 512 * x9
    out[..., 13] = 121 * x9 / 13824
    out[..., 14] = 667 * x10 / 9216
    out[..., 15] = -41 * x10 / 9216
    out[..., 16] = -239 * x12 / 6144
    out[..., 17] = 199 * x10 / 55296
    out[..., 18] = 115 * x12 / 55296
    out[..., 19] = -595 * x12 / 110592
    out[..., 20] = 61 * x12 / 184320
    out[..., 21] = omega_0


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, mu=mu)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))


def equilibria(*, omega_0: ArrayLike, mu: ArrayLike, gradient: bool = False) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN. B_j exp(i k_j θ) moves along a circle of
    further ones for k = (1,); of each circle one point is given, and the rate at which it drifts,
    B_j exp(i k_j ρ t).

    Parameters
    ----------
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Equilibria
        The arrays amplitudes (..., count, 1), drift (..., count, 1) in rad/s and growth (...,
        count) in 1/s, which is negative where an equilibrium is stable. With gradient also name ->
        derivatives of amplitudes, drift and growth, NaN where equilibria meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, mu=mu)
    return equilibria_at(
        equilibria_of_one,
        _FLOW,
        _coefficients,
        arguments,
        ("omega_0", "mu") if gradient else (),
    )


def frequency_response(
    *, omega_0: ArrayLike, mu: ArrayLike, over: str = "omega_0", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, mu=mu)
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("omega_0", "mu"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, omega_0: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """The shift of the frequency on the backbone curve.

    Where the conservative part of the slow flow that no phase enters is at rest; free motions
    without damping lie on it, and the responses of weakly damped ones close by.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, mu=mu)
    return backbone_at(
        _backbone,
        amplitude,
        arguments,
        ("omega_0", "mu") if gradient else (),
    )


def jacobian(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`, turned along its symmetries so that the amplitudes given drift as
    little as they can; an equilibrium then is at rest.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, mu=mu)
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("omega_0", "mu") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t). Each symmetry that moves the point has
    a zero, which is left out.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, mu=mu)
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("omega_0", "mu") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, omega_0: ArrayLike, mu: ArrayLike,
    order: int | None = None, drift: ArrayLike | None = None, gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. With a drift, constant ones turn along the
    symmetries of the slow flow. NaN where a harmonic resonates itself. Derivatives are taken with
    these fixed. Over times of order 1/ε the error is O(ε^4). A UserWarning says how much is left
    out where that is more than a tenth of the motion, estimated from the harmonics of each order
    beside those of order zero, and from the terms of the slow flow.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 4; all by default.
    drift : array_like, optional
        Of an equilibrium that drifts, shape (..., 1), rad/s: as `equilibria` gives it.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, mu=mu)
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        drift=drift,
        slow=(_FLOW, _coefficients, 2),
        names=("omega_0", "mu") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, omega_0: ArrayLike, mu: ArrayLike,
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
    omega_0 : array_like
        Natural frequency, rad/s, > 0.
    mu : array_like
        Strength of the self-excitation, which turns at 1 m/s, 1/s, > 0.

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
    arguments = checked(PARAMETERS, omega_0=omega_0, mu=mu)
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 2, False))
