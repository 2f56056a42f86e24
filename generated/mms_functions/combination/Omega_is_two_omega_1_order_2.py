# Emitted by mmsgen 0.1.0 from derivations/combination.py: change that, not this file.
# Made from sha256 8c007ea85b35d93e951f77bba8e1f23a6b0c9409ce91c16ca04f9fbdaf5f355c
# Operations for each point: growth_rate 81, boundaries 73, resonance 1, slow_flow_matrix 49,
# characteristic_coefficients 84, slow_flow 67, motion 178
"""combination: Omega = 2*omega_1 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y. Results are written at ε = 1.

It can be unstable: the discriminant of Gamma**2 + (-f_11 + omega_1*sigma)*(f_11 +
omega_1*sigma)/(4*omega_1**2) is positive in an interval of the detuning.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: 3*omega_1 - omega_2, omega_1 - omega_2.

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._beating import Beating, beating_at
from .._dual import boundaries_at, real_at
from .._edges import explicit_edges, zone
from .._evolution import Linear, evolution_at
from .._growth import growing
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
RELATIONS: tuple[str, ...] = ("Omega = 2*omega_1 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = 2*omega_1 + sigma"),
    "omega_1": ("positive", "rad/s", "natural frequency of the first mode"),
    "omega_2": ("positive", "rad/s", "natural frequency of the second mode"),
    "f_11": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_12": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_21": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_22": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {"sigma": 1 / 2},
    "y": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x", "conj(A_x)", "A_y")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    2,
    (
        ((0, 0), (0, 1)), ((1, 0),),
    ),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (1, 0, 0, 0, 0, 0), (0,)), (0, 1, (0, 0, 0, 1, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 1, 0, 0), (-1,)), (1, 0, (0, 0, 0, 1, 0, 0), (1,)),
        (1, 0, (1, 0, 0, 0, 0, 0), (1,)), (1, 1, (0, 0, 0, 1, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 1, 0, 0), (1,)), (1, 1, (1, 0, 0, 0, 0, 0), (-1,)),
        (1, 1, (1, 0, 0, 0, 0, 0), (1,)), (2, 0, (0, 0, 0, 1, 0, 0), (-2,)),
        (2, 0, (0, 0, 0, 1, 0, 0), (-1,)), (2, 0, (0, 0, 0, 1, 0, 0), (0,)),
        (2, 0, (0, 0, 0, 1, 0, 0), (1,)), (2, 0, (0, 0, 0, 1, 0, 0), (2,)),
        (2, 0, (1, 0, 0, 0, 0, 0), (-2,)), (2, 0, (1, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (1, 0, 0, 0, 0, 0), (2,)), (2, 1, (0, 0, 0, 1, 0, 0), (-2,)),
        (2, 1, (0, 0, 0, 1, 0, 0), (-1,)), (2, 1, (0, 0, 0, 1, 0, 0), (1,)),
        (2, 1, (0, 0, 0, 1, 0, 0), (2,)), (2, 1, (1, 0, 0, 0, 0, 0), (-2,)),
        (2, 1, (1, 0, 0, 0, 0, 0), (-1,)), (2, 1, (1, 0, 0, 0, 0, 0), (0,)),
        (2, 1, (1, 0, 0, 0, 0, 0), (1,)), (2, 1, (1, 0, 0, 0, 0, 0), (2,)),
    ),
    1,
)


def _growth_rate(sigma, omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = x0 * x0
    x3 = 1 / x2
    x4 = omega_1 + omega_2
    x5 = 1 / x4
    x6 = -omega_2
    x7 = omega_1 + x6
    x8 = 1 / x7
    x9 = 3 * omega_1
    x10 = omega_2 + x9
    x11 = 1 / x10
    x12 = x6 + x9
    x13 = 1 / x12
    x14 = sigma * sigma
    x15 = f_11 * f_11
    x16 = omega_2 * omega_2
    x17 = x15 * x15
    x18 = x0 * x2
    x19 = omega_1 * x0
    x20 = x10 * x10
    x21 = x12 * x12
    x22 = x4 * x4
    x23 = x7 * x7
    x24 = f_12 * f_12
    x25 = f_21 * f_21
    x26 = 5 * x0 - x16
    x27 = x26 * x26
    # Outputs
    discriminant_1 = (
        f_12 * f_21 * x11 * x13 * x15 * x3 * x5 * x8 * (3 / 2 * x16 - 15 / 2 * x0)
        + f_12 * f_21 * sigma * x11 * x13 * x5 * x8 * (20 * x0 - 4 * x16) / omega_1 + x1 * x15
        + 1 / 4 * x14 * x15 * x3 - 1 / 4 * sigma * x15 / x19
        - 4 * x1 * x24 * x25 * x27 / (x20 * x21 * x22 * x23) - x14 - 9 / 64 * x17 / x18
    )
    return growing(discriminant_1)


def _boundaries(omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = x0 * x0
    x3 = 1 / x2
    x4 = omega_1 + omega_2
    x5 = 1 / x4
    x6 = -omega_2
    x7 = omega_1 + x6
    x8 = 1 / x7
    x9 = 3 * omega_1
    x10 = omega_2 + x9
    x11 = 1 / x10
    x12 = x6 + x9
    x13 = 1 / x12
    x14 = f_11 * f_11
    x15 = omega_2 * omega_2
    x16 = x14 * x14
    x17 = x0 * x2
    x18 = x10 * x10
    x19 = x12 * x12
    x20 = x4 * x4
    x21 = x7 * x7
    x22 = f_12 * f_12
    x23 = f_21 * f_21
    x24 = 5 * x0 - x15
    x25 = x24 * x24
    x26 = 1 / 4 * x14
    x27 = omega_1 * x0
    # Outputs
    p0 = (
        f_12 * f_21 * x11 * x13 * x14 * x3 * x5 * x8 * (3 / 2 * x15 - 15 / 2 * x0) + x1 * x14
        - 4 * x1 * x22 * x23 * x25 / (x18 * x19 * x20 * x21) - 9 / 64 * x16 / x17
    )
    p1 = f_12 * f_21 * x11 * x13 * x5 * x8 * (20 * x0 - 4 * x15) / omega_1 - x26 / x27
    p2 = x26 * x3 - 1
    return zone((p0, p1, p2))


def _resonance(omega_1, omega_2, f_11, f_12, f_21, f_22):
    centre = 2 * omega_1
    return centre, omega_1, omega_2, f_11, f_12, f_21, f_22


def _slow_flow_matrix(out, sigma, omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = 1 / 2 * sigma
    x1 = f_11 * f_11
    x2 = omega_1 * omega_1
    x3 = omega_1 * x2
    x4 = 3 / 16 * x1 / x3
    x5 = omega_2 * omega_2
    x6 = 5 * x2 - x5
    x7 = 1 / omega_1
    x8 = -omega_2
    x9 = 1 / ((omega_1 + omega_2) * (omega_1 + x8))
    x10 = 3 * omega_1
    x11 = f_12 * f_21 / ((omega_2 + x10) * (x10 + x8))
    x12 = x11 * x7 * x9
    x13 = 1 / 2 * f_11 * x7 - 1 / 4 * f_11 * sigma / x2
    x14 = x9 / omega_2
    x15 = f_22 * f_22
    # Outputs
    out[..., 0, 0].imag = x12 * x6 + x4 - x0
    out[..., 0, 1].imag = x13
    out[..., 1, 0].imag = -x13
    out[..., 1, 1].imag = x0 - x12 * x6 - x4
    out[..., 2, 2].imag = x11 * x14 * (3 * x2 + x5) + 1 / 4 * x14 * x15


def _characteristic_coefficients(out, sigma, omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = omega_1 * omega_1
    x1 = 1 / x0
    x2 = f_11 * f_11
    x3 = 1 / 16 * x2
    x4 = x0 * x0
    x5 = 1 / x4
    x6 = omega_2 * omega_2
    x7 = 5 * x0 - x6
    x8 = omega_1 + omega_2
    x9 = -omega_2
    x10 = omega_1 + x9
    x11 = 1 / (x10 * x8)
    x12 = 3 * omega_1
    x13 = omega_2 + x12
    x14 = x12 + x9
    x15 = f_12 * f_21 / (x13 * x14)
    x16 = x11 * x15
    x17 = sigma * sigma
    x18 = x2 * x2
    x19 = x0 * x4
    x20 = omega_1 * x0
    x21 = x10 * x10
    x22 = x13 * x13
    x23 = x14 * x14
    x24 = x7 * x7
    x25 = x8 * x8
    x26 = f_12 * f_12
    x27 = f_21 * f_21
    x28 = x11 / omega_2
    x29 = f_22 * f_22
    # Outputs
    c1_0 = (
        sigma * x3 / x20 + x1 * x24 * x26 * x27 / (x21 * x22 * x23 * x25)
        + x16 * x2 * x5 * (15 / 8 * x0 - 3 / 8 * x6) + 1 / 4 * x17 + 9 / 256 * x18 / x19
        - 1 / 4 * x1 * x2 - x17 * x3 * x5 - sigma * x16 * x7 / omega_1
    )
    c2_0 = 1j * (x15 * x28 * (-3 * x0 - x6) - 1 / 4 * x28 * x29)
    multiply_out(out, ((0.0, c1_0), 1), ((c2_0,), 1))


def _slow_flow(out, A_x, A_y, sigma, omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = 1j * A_x
    x1 = f_12 * f_21
    x2 = omega_2 * omega_2
    x3 = x1 * x2
    x4 = -omega_2
    x5 = 3 * omega_1
    x6 = 1 / ((omega_1 + omega_2) * (omega_1 + x4) * (omega_2 + x5) * (x4 + x5))
    x7 = omega_1 * omega_1
    x8 = x7 * x7
    x9 = f_11 * f_11
    x10 = omega_1 * x7
    x11 = x2 * x2
    x12 = f_22 * f_22
    # Outputs
    out[..., 0] = (
        1 / 4 * 1j * f_11 * (2 * omega_1 - sigma) * np.conj(A_x) / x7 + x0 * x6 * (5 * x1 * x8 + 3
        / 16 * x11 * x9 + 27 / 16 * x8 * x9 - 15 / 8 * x2 * x7 * x9 - x3 * x7) / x10
        - 1 / 2 * sigma * x0
    )
    out[..., 1] = 1j * A_y * x6 * (3 * x1 * x7 + 9 / 4 * x12 * x7 + x3 - 1 / 4 * x12 * x2) / omega_2


def _motion(out, sigma, omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = 2 * f_12
    x1 = -omega_2
    x2 = omega_1 + x1
    x3 = 1 / x2
    x4 = 3 * omega_1
    x5 = x1 + x4
    x6 = 1 / x5
    x7 = x3 * x6
    x8 = omega_1 + omega_2
    x9 = 1 / x8
    x10 = omega_2 + x4
    x11 = 1 / x10
    x12 = x11 * x9
    x13 = omega_1 * omega_1
    x14 = 1 / x13
    x15 = 1 / 4 * x14
    x16 = 1 / 2 / omega_1
    x17 = f_22 * x16
    x18 = 2 * f_21
    x19 = x3 * x9
    x20 = x18 * x19
    x21 = x11 * x6
    x22 = x5 * x5
    x23 = 1 / x22
    x24 = 5 * omega_1
    x25 = 1 / (x1 + x24)
    x26 = f_22 * omega_2
    x27 = 4 * omega_1
    x28 = f_11 * x27 + f_22 * x4
    x29 = 2 * omega_1
    x30 = x1 + x29
    x31 = x2 * x2
    x32 = 1 / x31
    x33 = f_12 * x32
    x34 = sigma * x23
    x35 = f_11 * x13
    x36 = omega_2 * omega_2
    x37 = f_11 * x36
    x38 = f_22 * x13
    x39 = 9 * x38
    x40 = f_22 * x36
    x41 = x8 * x8
    x42 = 1 / x41
    x43 = x21 * x42
    x44 = x10 * x10
    x45 = 1 / x44
    x46 = f_12 * x45
    x47 = omega_2 + x29
    x48 = sigma * x42
    x49 = x47 * x48
    x50 = 1 / (omega_2 + x24)
    x51 = f_12 * f_21 * x13
    x52 = f_11 * f_11
    x53 = 3 / 64 * x52
    x54 = x13 * x53
    x55 = x13 * x13
    x56 = 2 / x55
    x57 = omega_1 * x13
    x58 = f_22 * f_22
    x59 = 1 / 32 * omega_2 * x58
    x60 = f_21 * omega_1
    x61 = 1 / 8 * f_12 * x60 + 3 / 32 * omega_1 * x58
    x62 = 2 * x14
    x63 = f_22 * x15
    x64 = f_21 * x32
    x65 = x36 * x36
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = x0 * x7
    out[..., 3] = x0 * x12
    out[..., 4] = f_11 * x15
    out[..., 5] = x17 * x3
    out[..., 6] = x17 * x9
    out[..., 7] = x20
    out[..., 8] = x18 * x21
    out[..., 9] = f_12 * x16 * x23 * x25 * x3 * (x28 - x26)
    out[..., 10] = -4 * x30 * x33 * x34
    out[..., 11] = -x33 * x43 * (12 * x35 + 4 * x37 + x39 - x40)
    out[..., 12] = -4 * x46 * x49
    out[..., 13] = x16 * x46 * x50 * x9 * (x26 + x28)
    out[..., 14] = x19 * x56 * (x36 * x53 + 1 / 8 * x51 - x54)
    out[..., 15] = -3 / 16 * f_11 * sigma / x57
    out[..., 16] = x21 * x56 * (x51 / 24 + x54 - x36 * x52 / 192)
    out[..., 17] = x62 * x7 * (x61 - x59) / x30
    out[..., 18] = -sigma * x30 * x32 * x63
    out[..., 19] = -x49 * x63
    out[..., 20] = x12 * x62 * (x59 + x61) / x47
    out[..., 21] = -x20 * x23 * x45 * (3 * x35 + x40 - 3 * x37 - x39)
    out[..., 22] = -x27 * x48 * x64
    out[..., 23] = (
        x15 * x43 * x64 * (81 * f_11 * x55 + f_11 * x65 + 80 * f_22 * x55 - 18 * x13 * x37
        - 16 * x13 * x40)
    )
    out[..., 24] = -12 * x34 * x45 * x60
    out[..., 25] = f_21 * x15 * x21 * x25 * x50 * (9 * x35 + 8 * x38 - x37)
    out[..., 26] = omega_1 + 1 / 2 * sigma
    out[..., 27] = omega_2
    out[..., 28] = sigma + x29


# --- functions ------------------------------------------------------------------------------------


def growth_rate(
    *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, f_11: ArrayLike, f_12: ArrayLike,
    f_21: ArrayLike, f_22: ArrayLike, gradient: bool = False,
) -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Amplitudes grow like exp(Γ t). Where the discriminant of the quadratic in Γ is positive, the
    rate is half its root; elsewhere both modes are neutral and the rate is exactly 0.0.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = 2*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
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
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21,
        f_22=f_22,
    )
    return real_at(
        evaluate,
        _growth_rate,
        arguments,
        ("sigma", "omega_1", "omega_2", "f_11", "f_12", "f_21", "f_22") if gradient else (),
    )


def boundaries(
    *, omega_1: ArrayLike, omega_2: ArrayLike, f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
    f_22: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable interval of sigma.

    The interval of sigma in which growth_rate is positive: where one of the polynomials with the
    coefficients in `_boundaries` (lowest power first) is. Infinite where the interval has no end.
    Order 2 leaves out terms of the edges from ε^3 on; by as much differs the formula of
    SlowFlow.boundary(), which is expanded in ε. Of several intervals the one nearest to zero;
    SlowFlow.zones() gives all of them.

    Parameters
    ----------
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
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
    arguments = checked(
        PARAMETERS, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21, f_22=f_22,
    )
    return boundaries_at(
        evaluate_pair,
        _boundaries,
        arguments,
        ("omega_1", "omega_2", "f_11", "f_12", "f_21", "f_22") if gradient else (),
    )


def critical_speeds(
    *, omega_1: ArrayLike, omega_2: ArrayLike, f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike,
    f_22: ArrayLike, gradient: bool = False,
) -> Any:
    """Both edges of the unstable zone in Omega.

    Where Omega = 2*omega_1 + sigma lies on an edge of `boundaries`.

    Parameters
    ----------
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
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
    arguments = checked(
        PARAMETERS, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21, f_22=f_22,
    )
    return explicit_edges(
        _resonance,
        _boundaries,
        1,
        arguments,
        ("omega_1", "omega_2", "f_11", "f_12", "f_21", "f_22") if gradient else (),
    )


def slow_flow_matrix(
    *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, f_11: ArrayLike, f_12: ArrayLike,
    f_21: ArrayLike, f_22: ArrayLike,
) -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = 2*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    complex128
        Shape (..., 3, 3), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21,
        f_22=f_22,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (3, 3))


def characteristic_coefficients(
    *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, f_11: ArrayLike, f_12: ArrayLike,
    f_21: ArrayLike, f_22: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = 2*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    complex128
        Shape (..., 4), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21,
        f_22=f_22,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (4,))


def slow_flow(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike, f_22: ArrayLike,
) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = 2*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

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
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21,
        f_22=f_22,
    )
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 2), *arguments], (2,))


def evolution(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike,
    omega_2: ArrayLike, f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike, f_22: ArrayLike,
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
        Those at t = 0, shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = 2*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    complex128
        Shape (..., 2), complex128, in the unit of the amplitudes.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21,
        f_22=f_22,
    )
    return evolution_at(_BLOCKS, _slow_flow, arguments, t, amplitudes)


def beating(
    amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike, f_22: ArrayLike,
) -> Beating:
    """How amplitudes beat: period and largest modulus, from those at t = 0.

    Closed forms where no mode decays: the sum of the moduli of the parts in each eigenvalue, which
    is the least upper bound of |B_j| unless three or more frequencies are commensurable. Else a
    maximum that is searched for in time.

    Parameters
    ----------
    amplitudes : array_like
        Those at t = 0, shape (..., 2), in the order of COORDINATES.
    sigma : array_like
        Detuning, Omega = 2*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

    Returns
    -------
    Beating
        period (s), largest, margin, each of shape (..., 2). The period is NaN unless exactly two
        frequencies take part; largest is infinite where the amplitude grows without bound; margin
        is how much too small it may be, 0 for closed forms.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21,
        f_22=f_22,
    )
    return beating_at(_BLOCKS, _slow_flow, arguments, amplitudes)


def response(
    t: ArrayLike, amplitudes: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike,
    omega_2: ArrayLike, f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike, f_22: ArrayLike,
    order: int | None = None, gradient: bool = False,
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
        Shape (..., 2), in the order of COORDINATES; NaN gives NaN.
    sigma : array_like
        Detuning, Omega = 2*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
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
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21,
        f_22=f_22,
    )
    return response_at(
        _MOTION,
        _motion,
        arguments,
        t,
        amplitudes,
        order=order,
        names=("sigma", "omega_1", "omega_2", "f_11", "f_12", "f_21", "f_22") if gradient else (),
    )


def initial_amplitudes(
    q: ArrayLike, v: ArrayLike, /, *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike,
    f_11: ArrayLike, f_12: ArrayLike, f_21: ArrayLike, f_22: ArrayLike,
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
    sigma : array_like
        Detuning, Omega = 2*omega_1 + sigma, rad/s, real.
    omega_1 : array_like
        Natural frequency of the first mode, rad/s, > 0.
    omega_2 : array_like
        Natural frequency of the second mode, rad/s, > 0.
    f_11 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_12 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_21 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.
    f_22 : array_like
        Half the modulation of a stiffness, rad^2/s^2, real.

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
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21,
        f_22=f_22,
    )
    return initial_at(_MOTION, _motion, arguments, q, v, (_slow_flow, 7, False))
