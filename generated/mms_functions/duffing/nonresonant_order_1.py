# Emitted by mmsgen 0.1.0 from derivations/duffing.py: change that, not this file.
# Made from sha256 c8df3e27478ab7952d9088b9fa15eaae5b6aec9b0f8afb45c7671752b05e3386
# Operations for each point: slow_flow 8, coefficients 4, backbone 5, motion 4
"""duffing: no resonance, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of u. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 2
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
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "omega_0": ("positive", "rad/s", "frequency of small oscillations"),
    "alpha": ("positive", "1/(m^2 s^2)", "cubic stiffness over the mass"),
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
        (0, (2, 1, 0)),
    ),
    ((1,),),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    1,
    (
        (0, 0, (1, 0, 0), ()), (1, 0, (3, 0, 0), ()),
    ),
    0,
)


def _slow_flow(out, A_u, omega_0, alpha):
    # Intermediates
    x0 = A_u * A_u
    # Outputs
    out[..., 0] = 3 / 2 * 1j * alpha * x0 * np.conj(A_u) / omega_0


def _coefficients(out, omega_0, alpha):
    out[..., 0] = 3 / 2 * 1j * alpha / omega_0


def _backbone(a_u, omega_0, alpha):
    # Intermediates
    x0 = a_u * a_u
    # Outputs
    rate = 3 / 8 * alpha * x0 / omega_0
    return rate


def _motion(out, omega_0, alpha):
    # Intermediates
    x0 = omega_0 * omega_0
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 1 / 4 * alpha / x0
    out[..., 2] = omega_0


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, alpha: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha=alpha)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))


def equilibria(*, omega_0: ArrayLike, alpha: ArrayLike, gradient: bool = False) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN. B_j exp(i k_j θ) moves along a circle of
    further ones for k = (1,); of each circle one point is given, and the rate at which it drifts,
    B_j exp(i k_j ρ t).

    Parameters
    ----------
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha=alpha)
    return equilibria_at(
        equilibria_of_one,
        _FLOW,
        _coefficients,
        arguments,
        ("omega_0", "alpha") if gradient else (),
    )


def frequency_response(
    *, omega_0: ArrayLike, alpha: ArrayLike, over: str = "omega_0", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha=alpha)
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("omega_0", "alpha"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, omega_0: ArrayLike, alpha: ArrayLike, gradient: bool = False,
) -> Any:
    """The shift of the frequency on the backbone curve.

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
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha=alpha)
    return backbone_at(
        _backbone,
        amplitude,
        arguments,
        ("omega_0", "alpha") if gradient else (),
    )


def jacobian(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, alpha: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`, turned along its symmetries so that the amplitudes given drift as
    little as they can; an equilibrium then is at rest.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha=alpha)
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("omega_0", "alpha") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, omega_0: ArrayLike, alpha: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t). Each symmetry that moves the point has
    a zero, which is left out.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha=alpha)
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("omega_0", "alpha") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, omega_0: ArrayLike, alpha: ArrayLike,
    order: int | None = None, drift: ArrayLike | None = None, gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. With a drift, constant ones turn along the
    symmetries of the slow flow. NaN where a harmonic resonates itself. Derivatives are taken with
    these fixed. Over times of order 1/ε the error is O(ε^1). A UserWarning says how much is left
    out where that is more than a tenth of the motion, estimated from the harmonics of each order
    beside those of order zero, and from the terms of the slow flow.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 1; all by default.
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
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha=alpha)
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        drift=drift,
        slow=(_FLOW, _coefficients, 2),
        names=("omega_0", "alpha") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, omega_0: ArrayLike, alpha: ArrayLike,
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
        Frequency of small oscillations, rad/s, > 0.
    alpha : array_like
        Cubic stiffness over the mass, 1/(m^2 s^2), > 0.

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
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha=alpha)
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 2, False))
