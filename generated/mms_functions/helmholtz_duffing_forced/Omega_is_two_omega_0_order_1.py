# Emitted by mmsgen 0.1.0 from derivations/helmholtz_duffing_forced.py: change that, not this file.
# Made from sha256 112a3a7a2cb90a953a635fcdfdc2b042560e4c59932253761f6df3129d05ae10
# Operations for each point: growth_rate 15, boundaries 13, resonance 1, slow_flow_matrix 7,
# characteristic_coefficients 15, slow_flow 15, motion 32
"""helmholtz_duffing_forced: Omega = 2*omega_0 + sigma, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of u. Results are written at ε = 1.

Stability depends: Gamma**2 + 2*Gamma*mu + (-K**2*alpha_2**2/36 + mu**2*omega_0**6 +
omega_0**6*sigma**2/4)/omega_0**6 is damped, and unstable near resonance if -4*(-K*alpha_2 +
6*mu*omega_0**3)*(K*alpha_2 + 6*mu*omega_0**3)/(9*omega_0**6) > 0.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 4
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._edges import explicit_edges
from .._evolution import Linear, evolution_at
from .._growth import quadratic_growth
from .._initial import initial_at
from .._motion import Motion, response_at
from .._runtime import (
    checked,
    checked_amplitudes,
    evaluate,
    evaluate_array,
    evaluate_pair,
    multiply_out,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "COORDINATES",
    "FRAME",
    "ORDER",
    "PARAMETERS",
    "RELATIONS",
    "VARIABLES",
    "beating",
    "boundaries",
    "characteristic_coefficients",
    "critical_speeds",
    "evolution",
    "growth_rate",
    "initial_amplitudes",
    "response",
    "slow_flow",
    "slow_flow_matrix",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ("Omega = 2*omega_0 + sigma",)

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("u",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = 2*omega_0 + sigma"),
    "omega_0": ("positive", "rad/s", "frequency of small oscillations"),
    "alpha_2": ("positive", "1/(m s^2)", "quadratic stiffness over the mass"),
    "mu": ("positive", "1/s", "half the damping over the mass"),
    "K": ("positive", "m/s^2", "amplitude of the force over the mass"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "u": {"sigma": 1 / 2},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_u", "conj(A_u)")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    1,
    (
        ((0, 0), (0, 1)),
    ),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    1,
    (
        (0, 0, (0, 0, 0), (1,)), (0, 0, (1, 0, 0), (0,)), (1, 0, (0, 0, 0), (0,)),
        (1, 0, (0, 0, 0), (1,)), (1, 0, (0, 0, 0), (2,)), (1, 0, (1, 0, 0), (1,)),
        (1, 0, (1, 1, 0), (0,)), (1, 0, (2, 0, 0), (0,)),
    ),
    1,
)


def _growth_rate(sigma, omega_0, alpha_2, mu, K):
    # Intermediates
    x0 = mu * mu
    x1 = sigma * sigma
    x2 = K * K
    x3 = alpha_2 * alpha_2
    x4 = omega_0 * omega_0
    x5 = x4 * x4
    x6 = x4 * x5
    # Outputs
    b_1 = 2 * mu
    c_1 = x0 + 1 / 4 * x1 - x2 * x3 / (36 * x6)
    return quadratic_growth(b_1, c_1)


def _boundaries(omega_0, alpha_2, mu, K):
    # Intermediates
    x0 = mu * mu
    x1 = K * K
    x2 = alpha_2 * alpha_2
    x3 = omega_0 * omega_0
    x4 = x3 * x3
    x5 = x3 * x4
    x6 = np.sqrt(x1 * x2 / (9 * x5) - 4 * x0)
    # Outputs
    lower = -x6
    upper = x6
    return lower, upper


def _resonance(omega_0, alpha_2, mu, K):
    centre = 2 * omega_0
    return centre, omega_0, alpha_2, mu, K


def _slow_flow_matrix(out, sigma, omega_0, alpha_2, mu, K):
    # Intermediates
    x0 = -mu
    x1 = 1 / 2 * sigma
    x2 = omega_0 * omega_0
    x3 = omega_0 * x2
    x4 = K * alpha_2 / (6 * x3)
    # Outputs
    out[..., 0, 0].real = x0
    out[..., 0, 0].imag = -x1
    out[..., 0, 1].imag = -x4
    out[..., 1, 0].imag = x4
    out[..., 1, 1].real = x0
    out[..., 1, 1].imag = x1


def _characteristic_coefficients(out, sigma, omega_0, alpha_2, mu, K):
    # Intermediates
    x0 = mu * mu
    x1 = sigma * sigma
    x2 = K * K
    x3 = alpha_2 * alpha_2
    x4 = omega_0 * omega_0
    x5 = x4 * x4
    x6 = x4 * x5
    # Outputs
    c1_1 = 2 * mu
    c1_0 = x0 + 1 / 4 * x1 - x2 * x3 / (36 * x6)
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_u, sigma, omega_0, alpha_2, mu, K):
    # Intermediates
    x0 = omega_0 * omega_0
    x1 = omega_0 * x0
    # Outputs
    out[..., 0] = -A_u * mu - 1 / 2 * 1j * A_u * sigma - 1j * K * alpha_2 * np.conj(A_u) / (6 * x1)


def _motion(out, sigma, omega_0, alpha_2, mu, K):
    # Intermediates
    x0 = omega_0 * omega_0
    x1 = 1 / x0
    x2 = K * K
    x3 = x0 * x0
    x4 = x0 * x3
    x5 = alpha_2 * x2 / x4
    x6 = omega_0 * x0
    x7 = alpha_2 * x1
    # Outputs
    out[..., 0] = -K * x1 / 3
    out[..., 1] = 2
    out[..., 2] = -x5 / 18
    out[..., 3] = 2 * K * (2 * sigma / 9 - 2 * 1j * mu / 9) / x6
    out[..., 4] = x5 / 270
    out[..., 5] = -K * alpha_2 / (12 * x3)
    out[..., 6] = -2 * x7
    out[..., 7] = 2 * x7 / 3
    out[..., 8] = omega_0 + 1 / 2 * sigma
    out[..., 9] = 2 * omega_0 + sigma


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike, mu: ArrayLike, K: ArrayLike,
    gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    The larger real part of the roots of Γ² + bΓ + c, each of them found without cancellation.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = 2*omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        In 1/s, float64, in the shape to which the arguments broadcast; with gradient this and name
        -> derivative, 0.0 where modes are neutral and NaN where they meet, as at edges.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, mu=mu, K=K)
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("sigma", "omega_0", "alpha_2", "mu", "K") if gradient else (),
    )


def boundaries(
    *, omega_0: ArrayLike, alpha_2: ArrayLike, mu: ArrayLike, K: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable interval of sigma.

    In closed form: the roots of a quadratic in it, between which growth_rate is positive. Order 1
    leaves out terms of the edges from ε^2 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero;
    SlowFlow.zones() gives all of them.

    Parameters
    ----------
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    lower, upper : float64
        In rad/s, float64, in the shape to which the arguments broadcast; NaN where there is no
        unstable interval. With gradient this pair and name -> pair.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha_2=alpha_2, mu=mu, K=K)
    return boundaries_at(
        evaluate_pair,
        _boundaries,
        arguments,
        ("omega_0", "alpha_2", "mu", "K") if gradient else (),
    )


def critical_speeds(
    *, omega_0: ArrayLike, alpha_2: ArrayLike, mu: ArrayLike, K: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable zone in Omega.

    Where Omega = 2*omega_0 + sigma lies on an edge of `boundaries`.

    Parameters
    ----------
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    lower, upper : float64
        In rad/s, float64, in the shape to which the arguments broadcast; NaN where there is no such
        edge. With gradient this pair and name -> pair.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, omega_0=omega_0, alpha_2=alpha_2, mu=mu, K=K)
    return explicit_edges(
        _resonance,
        _boundaries,
        1,
        arguments,
        ("omega_0", "alpha_2", "mu", "K") if gradient else (),
    )


def slow_flow_matrix(
    *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike, mu: ArrayLike, K: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = 2*omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.

    Returns
    -------
    complex128
        Shape (..., 2, 2), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, mu=mu, K=K)
    return evaluate_array(_slow_flow_matrix, arguments, (2, 2))


def characteristic_coefficients(
    *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike, mu: ArrayLike, K: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = 2*omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.

    Returns
    -------
    complex128
        Shape (..., 3), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, mu=mu, K=K)
    return evaluate_array(_characteristic_coefficients, arguments, (3,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike,
    mu: ArrayLike, K: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = 2*omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, mu=mu, K=K)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike,
    alpha_2: ArrayLike, mu: ArrayLike, K: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at any time from those at t = 0.

    The matrix exponential of the slow flow, in the frame A_j = B_j exp(i λ_j t), λ in FRAME: a
    closed form for blocks of one and two variables, scaling and squaring for larger ones; no
    eigenvectors, so that double eigenvalues do no harm.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Those at t = 0, shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = 2*omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, mu=mu, K=K)
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike,
    mu: ArrayLike, K: ArrayLike,
) -> Beating:
    """How amplitudes beat: period and largest modulus, from those at t = 0.

    Closed forms where no mode decays: the sum of the moduli of the parts in each eigenvalue, which
    is the least upper bound of |B_j| unless three or more frequencies are commensurable. Else a
    maximum that is searched for in time.

    Parameters
    ----------
    amplitudes : array_like
        Those at t = 0, shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = 2*omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.

    Returns
    -------
    Beating
        period (s), largest, margin, each of shape (..., 1). The period is NaN unless exactly two
        frequencies take part; largest is infinite where the amplitude grows without bound; margin
        is how much too small it may be, 0 for closed forms.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, mu=mu, K=K)
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike,
    alpha_2: ArrayLike, mu: ArrayLike, K: ArrayLike, order: int | None = None,
    gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. NaN where a harmonic resonates itself. Derivatives
    are taken with these fixed. Over times of order 1/ε the error is O(ε^1). A UserWarning says how
    much is left out where that is more than a tenth of the motion, estimated from the harmonics of
    each order beside those of order zero.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, Omega = 2*omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
    mu : array_like
        Half the damping over the mass, 1/s, > 0.
    K : array_like
        Amplitude of the force over the mass, m/s^2, > 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 1; all by default.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, mu=mu, K=K)
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=("sigma", "omega_0", "alpha_2", "mu", "K") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, omega_0: ArrayLike, alpha_2: ArrayLike,
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
        Detuning, Omega = 2*omega_0 + sigma, rad/s, real.
    omega_0 : array_like
        Frequency of small oscillations, rad/s, > 0.
    alpha_2 : array_like
        Quadratic stiffness over the mass, 1/(m s^2), > 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, omega_0=omega_0, alpha_2=alpha_2, mu=mu, K=K)
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 5, False))
