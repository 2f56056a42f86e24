# Emitted by mmsgen 0.1.0 from derivations/mathieu.py: change that, not this file.
# Made from sha256 6d07f3bb7dfff007244a94cc3a76d2bcdba6301ef030bafbaabd8e8cb9161405
# Operations for each point: growth_rate 34, boundaries 35, resonance 1, slow_flow_matrix 12,
# characteristic_coefficients 34, slow_flow 21, motion 14
"""mathieu: omega = 1/2*Omega + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x. Results are written at ε = 1.

Stability depends: Gamma**2 + 2*Gamma*mu + (Omega**2*mu**2 + Omega**2*sigma**2 - q**2)/Omega**2 is
damped, and unstable near resonance if -64*(Omega*mu - q)*(Omega*mu + q)/Omega**2 > 0.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; NIST DLMF, section 28.6
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
RELATIONS: tuple[str, ...] = ("omega = 1/2*Omega + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x",)

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, omega = Omega/2 + sigma"),
    "Omega": ("positive", "rad/s", "frequency of the modulation"),
    "q": ("nonnegative", "rad^2/s^2", "half the modulation of the stiffness"),
    "mu": ("nonnegative", "1/s", "rate at which free oscillations decay"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x", "conj(A_x)")


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
        (0, 0, (1, 0, 0), (0,)), (1, 0, (1, 0, 0), (1,)), (2, 0, (1, 0, 0), (-2,)),
        (2, 0, (1, 0, 0), (1,)), (2, 0, (1, 0, 0), (2,)),
    ),
    1,
)


def _growth_rate(sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = 1 / x0
    x2 = q * q
    x3 = 3 * x2
    x4 = mu * mu
    x5 = sigma * sigma
    x6 = x4 * x4
    x7 = x2 * x2
    x8 = x0 * x0
    x9 = x0 * x8
    x10 = Omega * x0
    # Outputs
    b_1 = 2 * mu
    c_1 = (
        sigma * x3 / x10 + x1 * x6 + x4 + x5 + 9 / 4 * x7 / x9 - x1 * x2 - x3 * x4 / x8
        - 2 * sigma * x4 / Omega
    )
    return quadratic_growth(b_1, c_1)


def _boundaries(Omega, q, mu):
    # Intermediates
    x0 = 1 / Omega
    x1 = q * q
    x2 = Omega * Omega
    x3 = Omega * x2
    x4 = 3 / 2 * x1 / x3
    x5 = 1 / x2
    x6 = mu * mu
    x7 = x0 * x6 - x4
    x8 = x7 * x7
    x9 = x6 * x6
    x10 = x1 * x1
    x11 = x2 * x2
    x12 = x11 * x2
    x13 = np.sqrt(x1 * x5 + 3 * x1 * x6 / x11 + x8 - 9 / 4 * x10 / x12 - x5 * x9 - x6)
    # Outputs
    lower = x0 * x6 - x13 - x4
    upper = x13 + x7
    return lower, upper


def _resonance(Omega, q, mu):
    centre = 1 / 2 * Omega
    return centre, Omega, q, mu


def _slow_flow_matrix(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = -mu
    x1 = 1 / Omega
    x2 = mu * mu
    x3 = q * q
    x4 = Omega * Omega
    x5 = Omega * x4
    x6 = sigma + 3 / 2 * x3 / x5 - x1 * x2
    x7 = q * x1
    # Outputs
    out[..., 0, 0].real = x0
    out[..., 0, 0].imag = x6
    out[..., 0, 1].imag = -x7
    out[..., 1, 0].imag = x7
    out[..., 1, 1].real = x0
    out[..., 1, 1].imag = -x6


def _characteristic_coefficients(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = 1 / x0
    x2 = q * q
    x3 = 3 * x2
    x4 = mu * mu
    x5 = sigma * sigma
    x6 = x4 * x4
    x7 = x2 * x2
    x8 = x0 * x0
    x9 = x0 * x8
    x10 = Omega * x0
    # Outputs
    c1_1 = 2 * mu
    c1_0 = (
        sigma * x3 / x10 + x1 * x6 + x4 + x5 + 9 / 4 * x7 / x9 - x1 * x2 - x3 * x4 / x8
        - 2 * sigma * x4 / Omega
    )
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_x, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = Omega * x0
    x2 = q * q
    x3 = mu * mu
    # Outputs
    out[..., 0] = (
        A_x * (1j * (sigma * x1 + 3 / 2 * x2 - x0 * x3) - mu * x1) / x1
        - 1j * q * np.conj(A_x) / Omega
    )


def _motion(out, sigma, Omega, q, mu):
    # Intermediates
    x0 = Omega * Omega
    x1 = q * q
    x2 = x0 * x0
    x3 = x1 / x2
    x4 = Omega * x0
    # Outputs
    out[..., 0] = 2
    out[..., 1] = -q / x0
    out[..., 2] = -3 / 2 * x3
    out[..., 3] = q * sigma / x4
    out[..., 4] = x3 / 6
    out[..., 5] = 1 / 2 * Omega
    out[..., 6] = Omega


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    The larger real part of the roots of Γ² + bΓ + c, each of them found without cancellation.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega = Omega/2 + sigma, rad/s, real.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("sigma", "Omega", "q", "mu") if gradient else (),
    )


def boundaries(*, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike, gradient: bool = False) -> Any:
    """Both edges of the unstable interval of sigma.

    In closed form: the roots of a quadratic in it, between which growth_rate is positive. Order 2
    leaves out terms of the edges from ε^3 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero;
    SlowFlow.zones() gives all of them.

    Parameters
    ----------
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, Omega=Omega, q=q, mu=mu)
    return boundaries_at(
        evaluate_pair,
        _boundaries,
        arguments,
        ("Omega", "q", "mu") if gradient else (),
    )


def critical_speeds(
    *, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable zone in omega.

    Where omega = 1/2*Omega + sigma lies on an edge of `boundaries`.

    Parameters
    ----------
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.
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
    arguments = checked(PARAMETERS, Omega=Omega, q=q, mu=mu)
    return explicit_edges(
        _resonance,
        _boundaries,
        1,
        arguments,
        ("Omega", "q", "mu") if gradient else (),
    )


def slow_flow_matrix(
    *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega = Omega/2 + sigma, rad/s, real.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 2, 2), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return evaluate_array(_slow_flow_matrix, arguments, (2, 2))


def characteristic_coefficients(
    *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, omega = Omega/2 + sigma, rad/s, real.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 3), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return evaluate_array(_characteristic_coefficients, arguments, (3,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES.
    sigma : array_like
        Detuning, omega = Omega/2 + sigma, rad/s, real.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 1), *arguments], (1,))


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike,
    mu: ArrayLike,
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
        Detuning, omega = Omega/2 + sigma, rad/s, real.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

    Returns
    -------
    complex128
        Shape (..., 1), complex128, in the unit of the amplitudes.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike, mu: ArrayLike,
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
        Detuning, omega = Omega/2 + sigma, rad/s, real.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

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
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike,
    mu: ArrayLike, order: int | None = None, gradient: bool = False,
) -> Any:
    """Coordinates at times: the uniform approximation with all its harmonics.

    Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant ones at
    an equilibrium, or a solution of slow_flow. NaN where a harmonic resonates itself. Derivatives
    are taken with these fixed. Over times of order 1/ε the error is O(ε^2). A UserWarning says how
    much is left out where that is more than a tenth of the motion, estimated from the harmonics of
    each order beside those of order zero.

    Parameters
    ----------
    t : array_like
        Times, s; they broadcast with the other arguments.
    amplitudes : array_like
        Shape (..., 1), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, omega = Omega/2 + sigma, rad/s, real.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.
    order : int, optional
        The highest power of ε of the harmonics that are summed, 0 to 2; all by default.
    gradient : bool, optional
        Whether the derivatives by every parameter are returned as well, as name -> derivative.

    Returns
    -------
    float64
        Shape (..., 1), in the order x; with gradient this and name -> array.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=("sigma", "Omega", "q", "mu") if gradient else (),
    )


def initial_amplitudes(
    q_: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, Omega: ArrayLike, q: ArrayLike,
    mu: ArrayLike,
) -> NDArray[np.complex128]:
    """Amplitudes at t = 0 of the motion with given coordinates and velocities there.

    The solution of response(0, amplitudes) = q, and of its derivative along slow_flow = v, that
    goes over into that of order zero as the small parameters go to zero.

    Parameters
    ----------
    q_ : array_like
        Coordinates at t = 0, shape (..., 1), in the order of COORDINATES.
    v : array_like
        Velocities at t = 0, shape (..., 1), per second.
    sigma : array_like
        Detuning, omega = Omega/2 + sigma, rad/s, real.
    Omega : array_like
        Frequency of the modulation, rad/s, > 0.
    q : array_like
        Half the modulation of the stiffness, rad^2/s^2, >= 0.
    mu : array_like
        Rate at which free oscillations decay, 1/s, >= 0.

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
    arguments = checked(PARAMETERS, sigma=sigma, Omega=Omega, q=q, mu=mu)
    return initial_at(_MOTION, _motion, arguments, q_, v, (_slow_flow, 4, False))
