# Emitted by mmsgen 0.1.0 from derivations/autoparametric_absorber.py: change that, not this file.
# Made from sha256 392a63a44e6a9d4da3dbab6b8b2dc318c04fd596f137ead4f43b312ff0df65d1
# Operations for each point: slow_flow 87, coefficients 63, backbone 36, motion 27
"""autoparametric_absorber: omega_x = 2*omega_p + sigma_1 and Omega = omega_x + sigma_2, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, theta. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Haxton and Barr, J. Engineering for Industry 94 (1972) 119-125
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
RELATIONS: tuple[str, ...] = ("omega_x = 2*omega_p + sigma_1", "Omega = omega_x + sigma_2")

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "theta")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma_1": ("real", "rad/s", "detuning, omega_x = 2*omega_p + sigma_1"),
    "sigma_2": ("real", "rad/s", "detuning, Omega = omega_x + sigma_2"),
    "L": ("positive", "m", "length of the pendulum"),
    "omega_p": ("positive", "rad/s", "natural frequency of the pendulum"),
    "r": ("positive", "1", "mass of the bob over both masses, m/(M + m)"),
    "mu_x": ("nonnegative", "1/s", "damping of the mass"),
    "mu_p": ("nonnegative", "1/s", "damping of the pendulum"),
    "f": ("nonnegative", "1/s^2", "force over both masses and the length, F/((M + m) L)"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {"sigma_1": 1, "sigma_2": 1},
    "theta": {"sigma_1": 1 / 2, "sigma_2": 1 / 2},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    2,
    (
        (0, (0, 0, 0, 0, 0, 0)), (0, (0, 0, 0, 2, 0, 0)), (0, (1, 0, 0, 0, 0, 0)),
        (0, (1, 0, 0, 1, 1, 0)), (1, (0, 0, 0, 0, 1, 0)), (1, (0, 0, 0, 1, 0, 0)),
        (1, (0, 0, 0, 2, 1, 0)), (1, (1, 0, 0, 0, 1, 0)), (1, (1, 1, 0, 1, 0, 0)),
    ),
    (),
)

#: terms of free motions without damping
_FREE = Flow(
    2,
    (
        (0, (0, 0, 0, 2, 0, 0)), (0, (1, 0, 0, 0, 0, 0)), (0, (1, 0, 0, 1, 1, 0)),
        (1, (0, 0, 0, 1, 0, 0)), (1, (0, 0, 0, 2, 1, 0)), (1, (1, 0, 0, 0, 1, 0)),
        (1, (1, 1, 0, 1, 0, 0)),
    ),
    ((2, 1),),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (1, 0, 0, 0, 0, 0), (0,)), (0, 1, (0, 0, 0, 1, 0, 0), (0,)),
        (1, 1, (1, 0, 0, 1, 0, 0), (0,)), (2, 0, (1, 0, 0, 2, 0, 0), (0,)),
        (2, 1, (0, 0, 0, 1, 0, 0), (1,)), (2, 1, (0, 0, 0, 3, 0, 0), (0,)),
        (2, 1, (1, 0, 0, 1, 0, 0), (0,)), (2, 1, (2, 0, 0, 0, 1, 0), (0,)),
        (2, 1, (2, 0, 0, 1, 0, 0), (0,)),
    ),
    1,
)


def _slow_flow(out, A_x, A_theta, sigma_1, sigma_2, L, omega_p, r, mu_x, mu_p, f):
    # Intermediates
    x0 = 1j * A_x
    x1 = np.conj(A_theta)
    x2 = 2 * omega_p
    x3 = A_theta * x0
    x4 = 1 / omega_p
    x5 = A_theta * A_theta
    x6 = mu_x * mu_x
    x7 = omega_p * omega_p
    x8 = 1j * x1
    x9 = L * L
    # Outputs
    out[..., 0] = (
        A_x * x4 * (1j * (omega_p * sigma_1 - 1 / 4 * x6) - mu_x * omega_p) + L * f * (1 / 32 * mu_x
        + 1j * (1 / 16 * sigma_1 + 1 / 32 * sigma_2 - 1 / 8 * omega_p)) / x7
        + L * r * x5 * (3 / 4 * mu_p + 1 / 8 * mu_x + 1j * (1 / 8 * sigma_1 - 1 / 2 * omega_p))
        + r * x1 * x2 * x3 - x0 * (sigma_1 + sigma_2)
    )
    out[..., 1] = (
        A_theta * mu_p * x4 * (-1 / 2 * 1j * mu_p - omega_p)
        + A_x * x1 * (mu_x + 1j * (-sigma_1 - x2)) / L + 1 / 8 * f * x4 * x8
        + 3 * omega_p * x3 * np.conj(A_x) / x9 + 1 / 4 * omega_p * x5 * x8 * (2 * r - 1)
        - 1j * A_theta * (1 / 2 * sigma_1 + 1 / 2 * sigma_2)
    )


def _coefficients(out, sigma_1, sigma_2, L, omega_p, r, mu_x, mu_p, f):
    # Intermediates
    x0 = omega_p * omega_p
    x1 = 1 / omega_p
    x2 = mu_x * mu_x
    x3 = 2 * r
    x4 = 1j * omega_p
    x5 = L * L
    # Outputs
    out[..., 0] = (
        L * f * (1 / 32 * mu_x + 1j * (1 / 16 * sigma_1 + 1 / 32 * sigma_2 - 1 / 8 * omega_p)) / x0
    )
    out[..., 1] = L * r * (3 / 4 * mu_p + 1 / 8 * mu_x + 1j * (1 / 8 * sigma_1 - 1 / 2 * omega_p))
    out[..., 2] = (
        x1 * (1j * (omega_p * sigma_1 - 1 / 4 * x2) - mu_x * omega_p) - 1j * (sigma_1 + sigma_2)
    )
    out[..., 3] = x3 * x4
    out[..., 4] = 1 / 8 * 1j * f * x1
    out[..., 5] = (
        mu_p * x1 * (-1 / 2 * 1j * mu_p - omega_p) - 1j * (1 / 2 * sigma_1 + 1 / 2 * sigma_2)
    )
    out[..., 6] = 1 / 4 * x4 * (x3 - 1)
    out[..., 7] = (mu_x + 1j * (-2 * omega_p - sigma_1)) / L
    out[..., 8] = 3 * x4 / x5


def _backbone(out, sigma_1, L, omega_p, r, mu_x, mu_p, f):
    # Intermediates
    x0 = 1j * sigma_1
    x1 = 1 / omega_p
    x2 = mu_x * mu_x
    x3 = 2 * r
    x4 = 1j * omega_p
    x5 = mu_p * mu_p
    x6 = L * L
    # Outputs
    out[..., 0] = -1 / 8 * 1j * L * r * (4 * omega_p - sigma_1)
    out[..., 1] = 1j * x1 * (omega_p * sigma_1 - 1 / 4 * x2) - x0
    out[..., 2] = x3 * x4
    out[..., 3] = -1 / 2 * x0 - 1 / 2 * 1j * x1 * x5
    out[..., 4] = 1 / 4 * x4 * (x3 - 1)
    out[..., 5] = 1j * (-2 * omega_p - sigma_1) / L
    out[..., 6] = 3 * x4 / x6
    out[..., 7] = sigma_1
    out[..., 8] = 1 / 2 * sigma_1


def _motion(out, sigma_1, sigma_2, L, omega_p, r, mu_x, mu_p, f):
    # Intermediates
    x0 = 1 / L
    x1 = omega_p * omega_p
    x2 = L * L
    x3 = 1 / x2
    x4 = 2 * omega_p + sigma_1 + sigma_2
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = -x0
    out[..., 3] = 4 * r / 3
    out[..., 4] = 1 / 32 * f / x1
    out[..., 5] = 1 / 8 * r - 1 / 24
    out[..., 6] = 2 * x0 * (-1 / 8 * 1j * mu_x - 1 / 8 * sigma_1) / omega_p
    out[..., 7] = -3 / 2 * x3
    out[..., 8] = x3 / 6
    out[..., 9] = x4
    out[..., 10] = omega_p + 1 / 2 * sigma_1 + 1 / 2 * sigma_2
    out[..., 11] = x4


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_p: ArrayLike, r: ArrayLike, mu_x: ArrayLike, mu_p: ArrayLike, f: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma_1 : array_like
        Detuning, omega_x = 2*omega_p + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length of the pendulum, m, > 0.
    omega_p : array_like
        Natural frequency of the pendulum, rad/s, > 0.
    r : array_like
        Mass of the bob over both masses, m/(M + m), > 0.
    mu_x : array_like
        Damping of the mass, 1/s, >= 0.
    mu_p : array_like
        Damping of the pendulum, 1/s, >= 0.
    f : array_like
        Force over both masses and the length, F/((M + m) L), 1/s^2, >= 0.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_p=omega_p, r=r, mu_x=mu_x,
        mu_p=mu_p, f=f,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))


def equilibria(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike, omega_p: ArrayLike, r: ArrayLike,
    mu_x: ArrayLike, mu_p: ArrayLike, f: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, omega_x = 2*omega_p + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length of the pendulum, m, > 0.
    omega_p : array_like
        Natural frequency of the pendulum, rad/s, > 0.
    r : array_like
        Mass of the bob over both masses, m/(M + m), > 0.
    mu_x : array_like
        Damping of the mass, 1/s, >= 0.
    mu_p : array_like
        Damping of the pendulum, 1/s, >= 0.
    f : array_like
        Force over both masses and the length, F/((M + m) L), 1/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_p=omega_p, r=r, mu_x=mu_x,
        mu_p=mu_p, f=f,
    )
    return equilibria_at(
        equilibria_of_many,
        _FLOW,
        _coefficients,
        arguments,
        ("sigma_1", "sigma_2", "L", "omega_p", "r", "mu_x", "mu_p", "f") if gradient else (),
    )


def frequency_response(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike, omega_p: ArrayLike, r: ArrayLike,
    mu_x: ArrayLike, mu_p: ArrayLike, f: ArrayLike, over: str = "sigma_1", gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, omega_x = 2*omega_p + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length of the pendulum, m, > 0.
    omega_p : array_like
        Natural frequency of the pendulum, rad/s, > 0.
    r : array_like
        Mass of the bob over both masses, m/(M + m), > 0.
    mu_x : array_like
        Damping of the mass, 1/s, >= 0.
    mu_p : array_like
        Damping of the pendulum, 1/s, >= 0.
    f : array_like
        Force over both masses and the length, F/((M + m) L), 1/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_p=omega_p, r=r, mu_x=mu_x,
        mu_p=mu_p, f=f,
    )
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("sigma_1", "sigma_2", "L", "omega_p", "r", "mu_x", "mu_p", "f"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, sigma_1: ArrayLike, L: ArrayLike, omega_p: ArrayLike, r: ArrayLike,
    mu_x: ArrayLike, mu_p: ArrayLike, f: ArrayLike, of: str = "x",
) -> Any:
    """Free motions without damping in which one coordinate has a given amplitude.

    All periodic ones: normal modes, whose frequencies over the amplitude are the backbone curves of
    the responses. Forces and damping are left out.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    sigma_1 : array_like
        Detuning, omega_x = 2*omega_p + sigma_1, rad/s, real.
    L : array_like
        Length of the pendulum, m, > 0.
    omega_p : array_like
        Natural frequency of the pendulum, rad/s, > 0.
    r : array_like
        Mass of the bob over both masses, m/(M + m), > 0.
    mu_x : array_like
        Damping of the mass, 1/s, >= 0.
    mu_p : array_like
        Damping of the pendulum, 1/s, >= 0.
    f : array_like
        Force over both masses and the length, F/((M + m) L), 1/s^2, >= 0.
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
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, L=L, omega_p=omega_p, r=r, mu_x=mu_x, mu_p=mu_p, f=f,
    )
    return modes_at(_FREE, (1.0, 0.5), _backbone, arguments, amplitude, COORDINATES, of)


def jacobian(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_p: ArrayLike, r: ArrayLike, mu_x: ArrayLike, mu_p: ArrayLike, f: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma_1 : array_like
        Detuning, omega_x = 2*omega_p + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length of the pendulum, m, > 0.
    omega_p : array_like
        Natural frequency of the pendulum, rad/s, > 0.
    r : array_like
        Mass of the bob over both masses, m/(M + m), > 0.
    mu_x : array_like
        Damping of the mass, 1/s, >= 0.
    mu_p : array_like
        Damping of the pendulum, 1/s, >= 0.
    f : array_like
        Force over both masses and the length, F/((M + m) L), 1/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_p=omega_p, r=r, mu_x=mu_x,
        mu_p=mu_p, f=f,
    )
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma_1", "sigma_2", "L", "omega_p", "r", "mu_x", "mu_p", "f") if gradient else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_p: ArrayLike, r: ArrayLike, mu_x: ArrayLike, mu_p: ArrayLike, f: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t).

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma_1 : array_like
        Detuning, omega_x = 2*omega_p + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length of the pendulum, m, > 0.
    omega_p : array_like
        Natural frequency of the pendulum, rad/s, > 0.
    r : array_like
        Mass of the bob over both masses, m/(M + m), > 0.
    mu_x : array_like
        Damping of the mass, 1/s, >= 0.
    mu_p : array_like
        Damping of the pendulum, 1/s, >= 0.
    f : array_like
        Force over both masses and the length, F/((M + m) L), 1/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_p=omega_p, r=r, mu_x=mu_x,
        mu_p=mu_p, f=f,
    )
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        ("sigma_1", "sigma_2", "L", "omega_p", "r", "mu_x", "mu_p", "f") if gradient else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_p: ArrayLike, r: ArrayLike, mu_x: ArrayLike, mu_p: ArrayLike, f: ArrayLike,
    order: int | None = None, gradient: bool = False,
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
        Detuning, omega_x = 2*omega_p + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length of the pendulum, m, > 0.
    omega_p : array_like
        Natural frequency of the pendulum, rad/s, > 0.
    r : array_like
        Mass of the bob over both masses, m/(M + m), > 0.
    mu_x : array_like
        Damping of the mass, 1/s, >= 0.
    mu_p : array_like
        Damping of the pendulum, 1/s, >= 0.
    f : array_like
        Force over both masses and the length, F/((M + m) L), 1/s^2, >= 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2), in the order x, theta; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_p=omega_p, r=r, mu_x=mu_x,
        mu_p=mu_p, f=f,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        slow=(_FLOW, _coefficients, 8),
        names=("sigma_1", "sigma_2", "L", "omega_p", "r", "mu_x", "mu_p", "f") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, L: ArrayLike,
    omega_p: ArrayLike, r: ArrayLike, mu_x: ArrayLike, mu_p: ArrayLike, f: ArrayLike,
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
        Detuning, omega_x = 2*omega_p + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_x + sigma_2, rad/s, real.
    L : array_like
        Length of the pendulum, m, > 0.
    omega_p : array_like
        Natural frequency of the pendulum, rad/s, > 0.
    r : array_like
        Mass of the bob over both masses, m/(M + m), > 0.
    mu_x : array_like
        Damping of the mass, 1/s, >= 0.
    mu_p : array_like
        Damping of the pendulum, 1/s, >= 0.
    f : array_like
        Force over both masses and the length, F/((M + m) L), 1/s^2, >= 0.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, L=L, omega_p=omega_p, r=r, mu_x=mu_x,
        mu_p=mu_p, f=f,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 8, False))
