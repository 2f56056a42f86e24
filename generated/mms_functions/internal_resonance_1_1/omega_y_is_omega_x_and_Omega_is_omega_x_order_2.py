# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_1.py: change that, not this file.
# Made from sha256 3f3fbaaba6dd0dae2525694d45c2ef18ea02d6877146fcc7c2156b44feb04971
# Operations for each point: slow_flow 52, coefficients 16, backbone 8, motion 4
"""internal_resonance_1_1: omega_y = omega_x + sigma_1 and Omega = omega_x + sigma_2, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Miles, Quarterly of Applied Mathematics 20 (1962) 21-32
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
RELATIONS: tuple[str, ...] = ("omega_y = omega_x + sigma_1", "Omega = omega_x + sigma_2")

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma_1": ("real", "rad/s", "detuning, omega_y = omega_x + sigma_1"),
    "sigma_2": ("real", "rad/s", "detuning, Omega = omega_x + sigma_2"),
    "L": ("positive", "m", "length"),
    "omega_x": ("positive", "rad/s", "frequency of small swings along x"),
    "mu": ("nonnegative", "1/s", "damping"),
    "f": ("nonnegative", "1/s^2", "acceleration of the pivot over the length"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {"sigma_2": 1},
    "y": {"sigma_2": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    2,
    (
        (0, (0, 0, 0, 0, 0, 0)), (0, (0, 1, 0, 2, 0, 0)), (0, (1, 0, 0, 0, 0, 0)),
        (0, (1, 0, 0, 1, 1, 0)), (0, (2, 1, 0, 0, 0, 0)), (1, (0, 0, 0, 1, 0, 0)),
        (1, (0, 0, 0, 2, 1, 0)), (1, (1, 1, 0, 1, 0, 0)), (1, (2, 0, 0, 0, 1, 0)),
    ),
    (),
)

#: terms of free motions without damping
_FREE = Flow(
    2,
    (
        (0, (0, 1, 0, 2, 0, 0)), (0, (1, 0, 0, 0, 0, 0)), (0, (1, 0, 0, 1, 1, 0)),
        (0, (2, 1, 0, 0, 0, 0)), (1, (0, 0, 0, 1, 0, 0)), (1, (0, 0, 0, 2, 1, 0)),
        (1, (1, 1, 0, 1, 0, 0)), (1, (2, 0, 0, 0, 1, 0)),
    ),
    ((1, 1),),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (1, 0, 0, 0, 0, 0), (0,)), (0, 1, (0, 0, 0, 1, 0, 0), (0,)),
        (2, 0, (1, 0, 0, 2, 0, 0), (0,)), (2, 0, (3, 0, 0, 0, 0, 0), (0,)),
        (2, 1, (0, 0, 0, 3, 0, 0), (0,)), (2, 1, (2, 0, 0, 1, 0, 0), (0,)),
    ),
    1,
)


def _slow_flow(out, A_x, A_y, sigma_1, sigma_2, L, omega_x, mu, f):
    # Intermediates
    x0 = 1j * sigma_2
    x1 = 1 / 4 * 1j
    x2 = np.conj(A_y)
    x3 = L * L
    x4 = 1 / x3
    x5 = np.conj(A_x)
    x6 = omega_x * x4 * x5
    x7 = 3 / 4 * 1j
    x8 = A_x * A_x
    x9 = A_y * A_y
    x10 = omega_x * x2 * x4
    # Outputs
    out[..., 0] = (
        1 / 2 * 1j * A_x * A_y * omega_x * x2 * x4 - A_x * mu - A_x * x0 - L * f * x1 / omega_x
        - x1 * x6 * x8 - x6 * x7 * x9
    )
    out[..., 1] = (
        1 / 2 * 1j * A_x * A_y * omega_x * x4 * x5 + A_y * (1j * sigma_1 - mu) - A_y * x0
        - x1 * x10 * x9 - x10 * x7 * x8
    )


def _coefficients(out, sigma_1, sigma_2, L, omega_x, mu, f):
    # Intermediates
    x0 = L * L
    x1 = 1j * omega_x / x0
    x2 = -3 / 4 * x1
    x3 = mu + 1j * sigma_2
    x4 = 1 / 2 * x1
    x5 = -1 / 4 * x1
    # Outputs
    out[..., 0] = -1 / 4 * 1j * L * f / omega_x
    out[..., 1] = x2
    out[..., 2] = -x3
    out[..., 3] = x4
    out[..., 4] = x5
    out[..., 5] = 1j * sigma_1 - x3
    out[..., 6] = x5
    out[..., 7] = x4
    out[..., 8] = x2


def _backbone(out, sigma_1, L, omega_x, mu, f):
    # Intermediates
    x0 = L * L
    x1 = 1j * omega_x / x0
    x2 = -3 / 4 * x1
    x3 = 1 / 2 * x1
    x4 = -1 / 4 * x1
    # Outputs
    out[..., 0] = x2
    out[..., 2] = x3
    out[..., 3] = x4
    out[..., 4] = 1j * sigma_1
    out[..., 5] = x4
    out[..., 6] = x3
    out[..., 7] = x2


def _motion(out, sigma_1, sigma_2, L, omega_x, mu, f):
    # Intermediates
    x0 = L * L
    x1 = -3 / 8 / x0
    x2 = omega_x + sigma_2
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = x1
    out[..., 3] = x1
    out[..., 4] = x1
    out[..., 5] = x1
    out[..., 6] = x2
    out[..., 7] = x2
    out[..., 8] = x2


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_x: ArrayLike, mu: ArrayLike, f: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma_1 : array_like
        Detuning, omega_y = omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
    f : array_like
        Acceleration of the pivot over the length, 1/s^2, >= 0.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_x=omega_x, mu=mu, f=f,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))


def equilibria(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike, omega_x: ArrayLike, mu: ArrayLike,
    f: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, omega_y = omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
    f : array_like
        Acceleration of the pivot over the length, 1/s^2, >= 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    Equilibria
        The arrays amplitudes (..., count, 2), drift (..., count, 0) in rad/s and growth (...,
        count) in 1/s, which is negative where an equilibrium is stable. With gradient also name ->
        derivatives of amplitudes, drift and growth, NaN where equilibria meet.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_x=omega_x, mu=mu, f=f,
    )
    return equilibria_at(
        equilibria_of_many,
        _FLOW,
        _coefficients,
        arguments,
        ("sigma_1", "sigma_2", "L", "omega_x", "mu", "f") if gradient else (),
    )


def frequency_response(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike, omega_x: ArrayLike, mu: ArrayLike,
    f: ArrayLike, over: str = "sigma_1", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, omega_y = omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
    f : array_like
        Acceleration of the pivot over the length, 1/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_x=omega_x, mu=mu, f=f,
    )
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("sigma_1", "sigma_2", "L", "omega_x", "mu", "f"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, sigma_1: ArrayLike, L: ArrayLike, omega_x: ArrayLike, mu: ArrayLike,
    f: ArrayLike, of: str = "x",
) -> Any:
    """Free motions without damping in which one coordinate has a given amplitude.

    All periodic ones: normal modes, whose frequencies over the amplitude are the backbone curves of
    the responses. Forces and damping are left out.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    sigma_1 : array_like
        Detuning, omega_y = omega_x + sigma_1, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
    f : array_like
        Acceleration of the pivot over the length, 1/s^2, >= 0.
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
    arguments = checked(PARAMETERS, sigma_1=sigma_1, L=L, omega_x=omega_x, mu=mu, f=f)
    return modes_at(_FREE, (1.0, 1.0), _backbone, arguments, amplitude, COORDINATES, of)


def jacobian(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_x: ArrayLike, mu: ArrayLike, f: ArrayLike, gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma_1 : array_like
        Detuning, omega_y = omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
    f : array_like
        Acceleration of the pivot over the length, 1/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_x=omega_x, mu=mu, f=f,
    )
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma_1", "sigma_2", "L", "omega_x", "mu", "f") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_x: ArrayLike, mu: ArrayLike, f: ArrayLike, gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t).

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma_1 : array_like
        Detuning, omega_y = omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
    f : array_like
        Acceleration of the pivot over the length, 1/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_x=omega_x, mu=mu, f=f,
    )
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma_1", "sigma_2", "L", "omega_x", "mu", "f") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_x: ArrayLike, mu: ArrayLike, f: ArrayLike, order: int | None = None,
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
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma_1 : array_like
        Detuning, omega_y = omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
    f : array_like
        Acceleration of the pivot over the length, 1/s^2, >= 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2), in the order x, y; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_x=omega_x, mu=mu, f=f,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        slow=(_FLOW, _coefficients, 6),
        names=("sigma_1", "sigma_2", "L", "omega_x", "mu", "f") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_x: ArrayLike, mu: ArrayLike, f: ArrayLike,
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
    sigma_1 : array_like
        Detuning, omega_y = omega_x + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length, m, > 0.
    omega_x : array_like
        Frequency of small swings along x, rad/s, > 0.
    mu : array_like
        Damping, 1/s, >= 0.
    f : array_like
        Acceleration of the pivot over the length, 1/s^2, >= 0.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_x=omega_x, mu=mu, f=f,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 6, False))
