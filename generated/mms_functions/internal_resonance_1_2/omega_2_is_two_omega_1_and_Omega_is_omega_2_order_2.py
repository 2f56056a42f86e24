# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_2.py: change that, not this file.
# Made from sha256 7bb8a5a060ff4be4da28561be79615c21ec3ff7613d1dcda28688b691cb5f7ef
# Operations for each point: slow_flow 84, coefficients 63, backbone 38, motion 53
"""internal_resonance_1_2: omega_2 = 2*omega_1 + sigma_1 and Omega = omega_2 + sigma_2, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of u_1, u_2. Results are written at ε = 1.

Stability depends: the slow flow is nonlinear or forced: its equilibria decide.

No boundaries are emitted: the slow flow is nonlinear or forced.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 6
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
RELATIONS: tuple[str, ...] = ("omega_2 = 2*omega_1 + sigma_1", "Omega = omega_2 + sigma_2")

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("u_1", "u_2")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma_1": ("real", "rad/s", "detuning, omega_2 = 2*omega_1 + sigma_1"),
    "sigma_2": ("real", "rad/s", "detuning, Omega = omega_2 + sigma_2"),
    "omega_1": ("positive", "rad/s", "natural frequency of the slower oscillator"),
    "mu_1": ("nonnegative", "1/s", "damping of the slower oscillator"),
    "mu_2": ("nonnegative", "1/s", "damping of the faster oscillator"),
    "alpha_1": ("positive", "1/(m s^2)", "coupling in the first equation"),
    "alpha_2": ("positive", "1/(m s^2)", "coupling in the second equation"),
    "F_2": ("nonnegative", "m/s^2", "force on the faster oscillator, over its mass"),
    "F_1": ("nonnegative", "m/s^2", "force on the slower oscillator, over its mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u_1": {"sigma_1": 1 / 2, "sigma_2": 1 / 2},
    "u_2": {"sigma_1": 1, "sigma_2": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ()


# --- formulas -------------------------------------------------------------------------------------


#: terms of the slow flow: equation, powers of B, B̄, |B|
_FLOW = Flow(
    2,
    (
        (0, (0, 1, 0, 0, 0, 0)), (0, (0, 1, 0, 1, 0, 0)), (0, (1, 0, 0, 0, 0, 0)),
        (0, (1, 0, 0, 1, 1, 0)), (0, (2, 1, 0, 0, 0, 0)), (1, (0, 0, 0, 0, 0, 0)),
        (1, (0, 0, 0, 1, 0, 0)), (1, (2, 0, 0, 0, 0, 0)),
    ),
    (),
)

#: terms of free motions without damping
_FREE = Flow(
    2,
    (
        (0, (0, 1, 0, 1, 0, 0)), (0, (1, 0, 0, 0, 0, 0)), (0, (1, 0, 0, 1, 1, 0)),
        (0, (2, 1, 0, 0, 0, 0)), (1, (0, 0, 0, 1, 0, 0)), (1, (2, 0, 0, 0, 0, 0)),
    ),
    ((1, 2),),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (1, 0, 0, 0, 0, 0), (0,)), (0, 1, (0, 0, 0, 1, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 0, 0, 0), (1,)), (1, 0, (1, 0, 0, 1, 0, 0), (0,)),
        (1, 1, (1, 1, 0, 0, 0, 0), (0,)), (2, 0, (0, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 1, 0, 0), (-1,)), (2, 0, (0, 0, 0, 1, 0, 0), (1,)),
        (2, 0, (1, 0, 0, 0, 0, 0), (1,)), (2, 0, (1, 0, 0, 0, 2, 0), (0,)),
        (2, 0, (1, 0, 0, 1, 0, 0), (0,)), (2, 0, (1, 0, 0, 2, 0, 0), (0,)),
        (2, 0, (3, 0, 0, 0, 0, 0), (0,)), (2, 1, (1, 0, 0, 0, 0, 0), (-1,)),
        (2, 1, (1, 0, 0, 0, 0, 0), (1,)), (2, 1, (1, 1, 0, 0, 0, 0), (0,)),
        (2, 1, (2, 0, 0, 1, 0, 0), (0,)),
    ),
    1,
)


def _slow_flow(out, A_u_1, A_u_2, sigma_1, sigma_2, omega_1, mu_1, mu_2, alpha_1, alpha_2, F_2):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = omega_1 * x0
    x2 = 1 / x1
    x3 = np.conj(A_u_1)
    x4 = 1j * alpha_1 * x2 * x3
    x5 = A_u_1 * A_u_1
    x6 = alpha_2 * x5
    x7 = 1 / omega_1
    x8 = 1 / x0
    x9 = alpha_1 * alpha_1
    x10 = mu_2 * mu_2
    # Outputs
    out[..., 0] = (
        3 / 16 * 1j * A_u_1 * A_u_2 * x2 * x9 * np.conj(A_u_2)
        + A_u_1 * mu_1 * x7 * (-1 / 2 * 1j * mu_1 - omega_1)
        + A_u_2 * alpha_1 * x3 * x8 * (1j * (1 / 4 * sigma_1 - 1 / 2 * omega_1) - 1 / 4 * mu_2)
        - 1j * A_u_1 * (1 / 2 * sigma_1 + 1 / 2 * sigma_2) - 1 / 32 * F_2 * x4 - 5 / 16 * x4 * x6
    )
    out[..., 1] = (
        A_u_2 * x7 * (1j * (omega_1 * sigma_1 - 1 / 4 * x10) - mu_2 * omega_1)
        + F_2 * x8 * (1 / 32 * mu_2 + 1j * (1 / 16 * sigma_1 + 1 / 32 * sigma_2 - 1 / 8 * omega_1))
        + x6 * x8 * (1 / 16 * mu_2 + 1j * (1 / 16 * sigma_1 - 1 / 4 * omega_1) - 1 / 8 * mu_1)
        - 1j * A_u_2 * (sigma_1 + sigma_2)
    )


def _coefficients(out, sigma_1, sigma_2, omega_1, mu_1, mu_2, alpha_1, alpha_2, F_2):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = omega_1 * x0
    x2 = 1j / x1
    x3 = alpha_1 * x2
    x4 = 1 / x0
    x5 = 1 / omega_1
    x6 = alpha_1 * alpha_1
    x7 = mu_2 * mu_2
    # Outputs
    out[..., 0] = -1 / 32 * F_2 * x3
    out[..., 1] = alpha_1 * x4 * (1j * (1 / 4 * sigma_1 - 1 / 2 * omega_1) - 1 / 4 * mu_2)
    out[..., 2] = (
        mu_1 * x5 * (-1 / 2 * 1j * mu_1 - omega_1) - 1j * (1 / 2 * sigma_1 + 1 / 2 * sigma_2)
    )
    out[..., 3] = 3 / 16 * x2 * x6
    out[..., 4] = -5 / 16 * alpha_2 * x3
    out[..., 5] = (
        F_2 * x4 * (1 / 32 * mu_2 + 1j * (1 / 16 * sigma_1 + 1 / 32 * sigma_2 - 1 / 8 * omega_1))
    )
    out[..., 6] = (
        x5 * (1j * (omega_1 * sigma_1 - 1 / 4 * x7) - mu_2 * omega_1) - 1j * (sigma_1 + sigma_2)
    )
    out[..., 7] = (
        alpha_2 * x4 * (1 / 16 * mu_2 + 1j * (1 / 16 * sigma_1 - 1 / 4 * omega_1) - 1 / 8 * mu_1)
    )


def _backbone(out, sigma_1, omega_1, mu_1, mu_2, alpha_1, alpha_2, F_2):
    # Intermediates
    x0 = -sigma_1
    x1 = omega_1 * omega_1
    x2 = 1j / x1
    x3 = 1j * sigma_1
    x4 = 1 / omega_1
    x5 = mu_1 * mu_1
    x6 = omega_1 * x1
    x7 = 1j / x6
    x8 = alpha_1 * alpha_1
    x9 = mu_2 * mu_2
    # Outputs
    out[..., 0] = -1 / 4 * alpha_1 * x2 * (2 * omega_1 + x0)
    out[..., 1] = -1 / 2 * x3 - 1 / 2 * 1j * x4 * x5
    out[..., 2] = 3 / 16 * x7 * x8
    out[..., 3] = -5 / 16 * alpha_1 * alpha_2 * x7
    out[..., 4] = 1j * x4 * (omega_1 * sigma_1 - 1 / 4 * x9) - x3
    out[..., 5] = -1 / 16 * alpha_2 * x2 * (4 * omega_1 + x0)
    out[..., 6] = 1 / 2 * sigma_1
    out[..., 7] = sigma_1


def _motion(out, sigma_1, sigma_2, omega_1, mu_1, mu_2, alpha_1, alpha_2, F_2, F_1):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = F_1 / 3
    x3 = omega_1 * x0
    x4 = 1 / x3
    x5 = 2 * x4
    x6 = x0 * x0
    x7 = 1 / x6
    x8 = alpha_1 * x7
    x9 = alpha_1 * alpha_1
    x10 = x7 * x9
    x11 = alpha_2 * x8
    x12 = F_1 * alpha_2 * x7
    x13 = 1 / 2 * sigma_1
    x14 = 2 * omega_1 + sigma_1 + sigma_2
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = -x1 * x2
    out[..., 3] = -1 / 4 * alpha_1 * x1
    out[..., 4] = 1 / 2 * alpha_2 * x1
    out[..., 5] = F_1 * x5 * (2 * sigma_1 / 9 + 2 * sigma_2 / 9 - 2 * 1j * mu_1 / 9)
    out[..., 6] = -x2 * x8
    out[..., 7] = F_1 * x8 / 45
    out[..., 8] = -3 / 128 * F_2 * x8
    out[..., 9] = -3 / 32 * x10
    out[..., 10] = alpha_1 * x5 * (3 / 32 * 1j * mu_2 + 3 / 32 * sigma_1)
    out[..., 11] = x10 / 96
    out[..., 12] = -3 / 64 * x11
    out[..., 13] = -2 * x12 / 9
    out[..., 14] = 2 * x12 / 15
    out[..., 15] = -alpha_2 * x13 * x4
    out[..., 16] = x11 / 24
    out[..., 17] = omega_1 + 1 / 2 * sigma_2 + x13
    out[..., 18] = x14
    out[..., 19] = x14


# --- functions ------------------------------------------------------------------------------------


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, F_2: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma_1 : array_like
        Detuning, omega_2 = 2*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Coupling in the first equation, 1/(m s^2), > 0.
    alpha_2 : array_like
        Coupling in the second equation, 1/(m s^2), > 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, F_2=F_2,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))


def equilibria(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike, mu_2: ArrayLike,
    alpha_1: ArrayLike, alpha_2: ArrayLike, F_2: ArrayLike, gradient: bool = False,
) -> Any:
    """All equilibria of the slow flow, with their stability.

    Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many as
    there are, those that are missing at a point NaN.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, omega_2 = 2*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Coupling in the first equation, 1/(m s^2), > 0.
    alpha_2 : array_like
        Coupling in the second equation, 1/(m s^2), > 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, F_2=F_2,
    )
    return equilibria_at(
        equilibria_of_many,
        _FLOW,
        _coefficients,
        arguments,
        (
            "sigma_1", "sigma_2", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "F_2",
        )
        if gradient
        else (),
    )


def frequency_response(
    *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike, mu_2: ArrayLike,
    alpha_1: ArrayLike, alpha_2: ArrayLike, F_2: ArrayLike, over: str = "sigma_1",
    gradient: bool = False,
) -> Any:
    """All equilibria along one parameter, as branches with their bifurcations.

    One parameter is an array of one dimension, the others are numbers. Each branch has its points
    in their order along the curve, through folds.

    Parameters
    ----------
    sigma_1 : array_like
        Detuning, omega_2 = 2*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Coupling in the first equation, 1/(m s^2), > 0.
    alpha_2 : array_like
        Coupling in the second equation, 1/(m s^2), > 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, F_2=F_2,
    )
    return response_along(
        _FLOW,
        _coefficients,
        arguments,
        ("sigma_1", "sigma_2", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "F_2"),
        over,
        gradient,
    )


def backbone(
    amplitude: ArrayLike, /, *, sigma_1: ArrayLike, omega_1: ArrayLike, mu_1: ArrayLike,
    mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, F_2: ArrayLike, of: str = "u_1",
) -> Any:
    """Free motions without damping in which one coordinate has a given amplitude.

    All periodic ones: normal modes, whose frequencies over the amplitude are the backbone curves of
    the responses. Forces and damping are left out.

    Parameters
    ----------
    amplitude : array_like
        a = 2|B|, the amplitude of the fundamental harmonic, >= 0.
    sigma_1 : array_like
        Detuning, omega_2 = 2*omega_1 + sigma_1, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Coupling in the first equation, 1/(m s^2), > 0.
    alpha_2 : array_like
        Coupling in the second equation, 1/(m s^2), > 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2, alpha_1=alpha_1,
        alpha_2=alpha_2, F_2=F_2,
    )
    return modes_at(_FREE, (0.5, 1.0), _backbone, arguments, amplitude, COORDINATES, of)


def jacobian(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, F_2: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.

    In the frame of `slow_flow`.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma_1 : array_like
        Detuning, omega_2 = 2*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Coupling in the first equation, 1/(m s^2), > 0.
    alpha_2 : array_like
        Coupling in the second equation, 1/(m s^2), > 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, F_2=F_2,
    )
    return jacobian_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma_1", "sigma_2", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "F_2",
        )
        if gradient
        else (),
    )


def stability(
    amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, F_2: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Eigenvalues Γ of the Jacobian, the largest real part first.

    Small disturbances of an equilibrium grow like exp(Γ t).

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma_1 : array_like
        Detuning, omega_2 = 2*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Coupling in the first equation, 1/(m s^2), > 0.
    alpha_2 : array_like
        Coupling in the second equation, 1/(m s^2), > 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, F_2=F_2,
    )
    return stability_at(
        _FLOW,
        _coefficients,
        arguments,
        amplitudes,
        (
            "sigma_1", "sigma_2", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "F_2",
        )
        if gradient
        else (),
    )


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike,
    omega_1: ArrayLike, mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike,
    F_2: ArrayLike, F_1: ArrayLike, order: int | None = None, gradient: bool = False,
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
        Detuning, omega_2 = 2*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Coupling in the first equation, 1/(m s^2), > 0.
    alpha_2 : array_like
        Coupling in the second equation, 1/(m s^2), > 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 2), in the order u_1, u_2; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, F_2=F_2, F_1=F_1,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        slow=(_FLOW, _coefficients, 8),
        names=(
            "sigma_1", "sigma_2", "omega_1", "mu_1", "mu_2", "alpha_1", "alpha_2", "F_2", "F_1",
        )
        if gradient
        else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma_1: ArrayLike, sigma_2: ArrayLike, omega_1: ArrayLike,
    mu_1: ArrayLike, mu_2: ArrayLike, alpha_1: ArrayLike, alpha_2: ArrayLike, F_2: ArrayLike,
    F_1: ArrayLike,
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
        Detuning, omega_2 = 2*omega_1 + sigma_1, rad/s, real.
    sigma_2 : array_like
        Detuning, Omega = omega_2 + sigma_2, rad/s, real.
    omega_1 : array_like
        Natural frequency of the slower oscillator, rad/s, > 0.
    mu_1 : array_like
        Damping of the slower oscillator, 1/s, >= 0.
    mu_2 : array_like
        Damping of the faster oscillator, 1/s, >= 0.
    alpha_1 : array_like
        Coupling in the first equation, 1/(m s^2), > 0.
    alpha_2 : array_like
        Coupling in the second equation, 1/(m s^2), > 0.
    F_2 : array_like
        Force on the faster oscillator, over its mass, m/s^2, >= 0.
    F_1 : array_like
        Force on the slower oscillator, over its mass, m/s^2, >= 0.

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
        PARAMETERS, sigma_1=sigma_1, sigma_2=sigma_2, omega_1=omega_1, mu_1=mu_1, mu_2=mu_2,
        alpha_1=alpha_1, alpha_2=alpha_2, F_2=F_2, F_1=F_1,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 8, False))
