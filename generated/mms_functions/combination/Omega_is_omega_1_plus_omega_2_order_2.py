# Emitted by mmsgen 0.1.0 from derivations/combination.py: change that, not this file.
# Made from sha256 248b66009265222a583c0edf2397e8ed80d25ae800c61aff0b0cbc1528235b93
# Operations for each point: growth_rate 118, boundaries 98, resonance 1, slow_flow_matrix 54,
# characteristic_coefficients 91, slow_flow 71, motion 198
"""combination: Omega = omega_1 + omega_2 + sigma, order 2.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 2 in ε, of x, y. Results are written at ε = 1.

Stability depends: the discriminant of Gamma**2 - I*Gamma*sigma - f_12*f_21/(4*omega_1*omega_2) is
positive in an interval of the detuning if 4*f_12*f_21/(omega_1*omega_2) > 0.

NaN comes from formulas in which a divisor vanishes: growth rates, edges, equilibria, stability. One
that does not contain it stays finite there; but it is a further resonance, which this case knows
nothing of, and a case of its own: omega_1 - omega_2.

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
RELATIONS: tuple[str, ...] = ("Omega = omega_1 + omega_2 + sigma",)

#: the highest power of ε
ORDER = 2

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y")

#: name -> (domain, unit, meaning)
PARAMETERS = {
    "sigma": ("real", "rad/s", "detuning, Omega = omega_1 + omega_2 + sigma"),
    "omega_1": ("positive", "rad/s", "natural frequency of the first mode"),
    "omega_2": ("positive", "rad/s", "natural frequency of the second mode"),
    "f_11": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_12": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_21": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
    "f_22": ("real", "rad^2/s^2", "half the modulation of a stiffness"),
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
    "y": {"sigma": 1},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x", "conj(A_y)")


# --- formulas -------------------------------------------------------------------------------------


#: amplitudes (j, 0) and conjugates (j, 1) that move together
_BLOCKS = Linear(
    2,
    (
        ((0, 0), (1, 1)),
    ),
)

#: harmonics: order, coordinate, powers, multiples
_MOTION = Motion(
    2,
    (
        (0, 0, (1, 0, 0, 0, 0, 0), (0,)), (0, 1, (0, 0, 0, 1, 0, 0), (0,)),
        (1, 0, (0, 0, 0, 1, 0, 0), (1,)), (1, 0, (1, 0, 0, 0, 0, 0), (-1,)),
        (1, 0, (1, 0, 0, 0, 0, 0), (1,)), (1, 1, (0, 0, 0, 1, 0, 0), (-1,)),
        (1, 1, (0, 0, 0, 1, 0, 0), (1,)), (1, 1, (1, 0, 0, 0, 0, 0), (1,)),
        (2, 0, (0, 0, 0, 1, 0, 0), (-2,)), (2, 0, (0, 0, 0, 1, 0, 0), (0,)),
        (2, 0, (0, 0, 0, 1, 0, 0), (1,)), (2, 0, (0, 0, 0, 1, 0, 0), (2,)),
        (2, 0, (1, 0, 0, 0, 0, 0), (-2,)), (2, 0, (1, 0, 0, 0, 0, 0), (-1,)),
        (2, 0, (1, 0, 0, 0, 0, 0), (1,)), (2, 0, (1, 0, 0, 0, 0, 0), (2,)),
        (2, 1, (0, 0, 0, 1, 0, 0), (-2,)), (2, 1, (0, 0, 0, 1, 0, 0), (-1,)),
        (2, 1, (0, 0, 0, 1, 0, 0), (1,)), (2, 1, (0, 0, 0, 1, 0, 0), (2,)),
        (2, 1, (1, 0, 0, 0, 0, 0), (-2,)), (2, 1, (1, 0, 0, 0, 0, 0), (0,)),
        (2, 1, (1, 0, 0, 0, 0, 0), (1,)), (2, 1, (1, 0, 0, 0, 0, 0), (2,)),
    ),
    1,
)


def _growth_rate(sigma, omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = 1 / omega_1
    x1 = 1 / omega_2
    x2 = omega_1 * omega_1
    x3 = 1 / x2
    x4 = omega_2 * omega_2
    x5 = 1 / x4
    x6 = omega_1 + omega_2
    x7 = 1 / x6
    x8 = omega_1 - omega_2
    x9 = x8 * x8
    x10 = 1 / x9
    x11 = 1 / x8
    x12 = 3 * omega_1 + omega_2
    x13 = 1 / x12
    x14 = omega_1 + 3 * omega_2
    x15 = 1 / x14
    x16 = omega_1 * omega_2
    x17 = 1 / 2 * x16 + 1 / 2 * x2 + 1 / 2 * x4
    x18 = sigma * sigma
    x19 = f_11 * f_11
    x20 = f_22 * f_22
    x21 = x12 * x12
    x22 = x19 * x19
    x23 = x14 * x14
    x24 = x20 * x20
    x25 = x6 * x6
    x26 = f_12 * f_12
    x27 = f_21 * f_21
    x28 = x2 * x2
    x29 = x4 * x4
    x30 = x16 + x2 + x4
    x31 = x30 * x30
    x32 = omega_1 * x2
    x33 = omega_2 * x4
    # Outputs
    discriminant_1 = (
        f_12 * f_21 * x0 * x1 + f_12 * f_21 * x11 * x13 * x17 * x19 * x5 * x7 / x32
        + 1 / 4 * f_12 * f_21 * x18 * x3 * x5 + 2 * sigma * x1 * x11 * x15 * x20
        + 2 * x0 * x1 * x10 * x13 * x15 * x19 * x20 - 1 / 2 * f_12 * f_21 * sigma * x0 * x1 * x7
        - f_12 * f_21 * x11 * x15 * x17 * x20 * x3 * x7 / x33 - 2 * sigma * x0 * x11 * x13 * x19
        - x10 * x24 * x5 / x23 - x10 * x22 * x3 / x21 - x18
        - 1 / 16 * x26 * x27 * x31 / (x25 * x28 * x29)
    )
    return growing(discriminant_1)


def _boundaries(omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = f_12 * f_21
    x1 = 1 / omega_1
    x2 = 1 / omega_2
    x3 = x1 * x2
    x4 = x0 * x3
    x5 = omega_1 * omega_1
    x6 = 1 / x5
    x7 = omega_1 - omega_2
    x8 = x7 * x7
    x9 = 1 / x8
    x10 = omega_2 * omega_2
    x11 = 1 / x10
    x12 = 3 * omega_1 + omega_2
    x13 = f_11 * f_11
    x14 = x13 / x12
    x15 = omega_1 + 3 * omega_2
    x16 = 1 / x15
    x17 = f_22 * f_22
    x18 = x16 * x17
    x19 = omega_1 * omega_2
    x20 = 1 / 2 * x10 + 1 / 2 * x19 + 1 / 2 * x5
    x21 = x0 * x11
    x22 = 1 / x7
    x23 = omega_1 + omega_2
    x24 = 1 / x23
    x25 = x22 * x24
    x26 = x15 * x15
    x27 = x17 * x17
    x28 = x12 * x12
    x29 = x13 * x13
    x30 = omega_1 * x5
    x31 = omega_2 * x10
    x32 = x23 * x23
    x33 = f_12 * f_12
    x34 = f_21 * f_21
    x35 = x5 * x5
    x36 = x10 * x10
    x37 = x10 + x19 + x5
    x38 = x37 * x37
    # Outputs
    p0 = (
        2 * x14 * x18 * x3 * x9 + x14 * x20 * x21 * x25 / x30 + x4 - x0 * x18 * x20 * x25 * x6 / x31
        - x11 * x27 * x9 / x26 - 1 / 16 * x33 * x34 * x38 / (x32 * x35 * x36) - x29 * x6 * x9 / x28
    )
    p1 = 2 * x16 * x17 * x2 * x22 - 2 * x1 * x14 * x22 - 1 / 2 * x24 * x4
    p2 = 1 / 4 * x21 * x6 - 1
    return zone((p0, p1, p2))


def _resonance(omega_1, omega_2, f_11, f_12, f_21, f_22):
    centre = omega_1 + omega_2
    return centre, omega_1, omega_2, f_11, f_12, f_21, f_22


def _slow_flow_matrix(out, sigma, omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = 1 / omega_1
    x1 = 1 / (omega_1 - omega_2)
    x2 = omega_1 * omega_1
    x3 = 1 / x2
    x4 = 1 / omega_2
    x5 = 1 / (omega_1 + omega_2)
    x6 = f_11 * f_11
    x7 = f_12 * x0
    x8 = omega_2 * omega_2
    x9 = 1 / x8
    x10 = f_22 * f_22
    # Outputs
    out[..., 0, 0].imag = (
        f_12 * f_21 * x3 * x4 * x5 * (1 / 8 * omega_1 + 1 / 4 * omega_2)
        - x0 * x1 * x6 / (3 * omega_1 + omega_2)
    )
    out[..., 0, 1].imag = 1 / 2 * x7 - 1 / 4 * f_12 * sigma * x3
    out[..., 1, 0].imag = 1 / 4 * f_21 * sigma * x9 - 1 / 2 * f_21 * x4
    out[..., 1, 1].imag = (
        f_21 * x5 * x7 * x9 * (-1 / 4 * omega_1 - 1 / 8 * omega_2) + sigma
        - x1 * x10 * x4 / (omega_1 + 3 * omega_2)
    )


def _characteristic_coefficients(out, sigma, omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = 1 / 4 * omega_1
    x1 = 1 / 4 * omega_2
    x2 = f_12 * f_21
    x3 = omega_1 * omega_1
    x4 = omega_2 * omega_2
    x5 = x2 / (x3 * x4)
    x6 = omega_1 - omega_2
    x7 = 1 / x6
    x8 = 1 / omega_1
    x9 = 1 / (3 * omega_1 + omega_2)
    x10 = f_11 * f_11
    x11 = x10 * x8 * x9
    x12 = x11 * x7
    x13 = 1 / omega_2
    x14 = 1 / (omega_1 + 3 * omega_2)
    x15 = f_22 * f_22
    x16 = x13 * x14 * x15
    x17 = 1 / 8 * omega_2
    x18 = omega_1 + omega_2
    x19 = x5 / x18
    x20 = x19 * x7
    x21 = sigma * sigma
    x22 = x6 * x6
    x23 = x18 * x18
    x24 = f_12 * f_12
    x25 = f_21 * f_21
    x26 = omega_1 * x3
    x27 = omega_2 * x4
    # Outputs
    c1_1 = 1j * (x12 + x16 * x7 + x5 * (x0 - x1) - sigma)
    c1_0 = (
        sigma * x12 + sigma * x19 * (omega_1 * x17 + 1 / 8 * x3 - 1 / 8 * x4)
        + x10 * x20 * x9 * (-x0 - x17) + x14 * x15 * x20 * (1 / 8 * omega_1 + x1)
        + 1 / 64 * x24 * x25 * (omega_1 + 2 * omega_2) * (2 * omega_1 + omega_2) / (x23 * x26 * x27)
        - x11 * x16 / x22 - 1 / 4 * x13 * x2 * x8 - 1 / 16 * x21 * x5
    )
    multiply_out(out, ((c1_1, c1_0), 1))


def _slow_flow(out, A_x, A_y, sigma, omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = -sigma
    x1 = 1 / 4 * 1j
    x2 = omega_1 * omega_1
    x3 = 1 / x2
    x4 = 1 / (omega_1 + omega_2)
    x5 = x1 / (omega_1 - omega_2)
    x6 = f_11 * f_11
    x7 = x3 * x6
    x8 = omega_2 * omega_2
    x9 = 1 / x8
    x10 = 1 / 8 * 1j * f_12 * f_21 * x9
    x11 = f_22 * f_22
    x12 = x11 * x9
    # Outputs
    out[..., 0] = (
        A_x * (1 / 8 * 1j * f_12 * f_21 * x3 * x4 + 1 / 8 * 1j * f_12 * f_21 * x3 / omega_2
        - x1 * x7 / (3 * omega_1 + omega_2) - x5 * x7)
        + f_12 * x1 * x3 * (2 * omega_1 + x0) * np.conj(A_y)
    )
    out[..., 1] = (
        A_y * (x10 * x4 + x12 * x5 + x10 / omega_1 - x1 * x12 / (omega_1 + 3 * omega_2))
        + f_21 * x1 * x9 * (2 * omega_2 + x0) * np.conj(A_x) - 1j * A_y * sigma
    )


def _motion(out, sigma, omega_1, omega_2, f_11, f_12, f_21, f_22):
    # Intermediates
    x0 = omega_1 + omega_2
    x1 = 1 / x0
    x2 = 1 / 2 * x1
    x3 = 1 / omega_2
    x4 = f_12 * x3
    x5 = omega_1 - omega_2
    x6 = 1 / x5
    x7 = 2 * f_11 * x1
    x8 = 3 * omega_1
    x9 = omega_2 + x8
    x10 = 1 / x9
    x11 = 2 * f_22
    x12 = x1 * x11
    x13 = 3 * omega_2
    x14 = omega_1 + x13
    x15 = 1 / x14
    x16 = 1 / omega_1
    x17 = f_21 * x16
    x18 = x9 * x9
    x19 = 1 / x18
    x20 = omega_2 * omega_2
    x21 = f_11 * x20
    x22 = omega_1 * omega_1
    x23 = f_22 * x22
    x24 = f_11 * omega_1
    x25 = f_22 * omega_2
    x26 = omega_1 * x25 + omega_2 * x24
    x27 = x0 * x0
    x28 = 1 / x27
    x29 = 2 * x28
    x30 = x29 * x6
    x31 = omega_1 * x21
    x32 = 2 * omega_2
    x33 = f_11 * x22
    x34 = f_22 * x20
    x35 = omega_2 * x23
    x36 = x5 * x5
    x37 = 1 / x36
    x38 = 1 / 2 * x28 * x37
    x39 = omega_1 * x22
    x40 = omega_2 * x20
    x41 = omega_1 + x32
    x42 = sigma * x28
    x43 = x41 * x42
    x44 = x14 * x14
    x45 = 1 / x44
    x46 = x28 / 6
    x47 = f_12 * f_21
    x48 = 1 / 16 * x47
    x49 = omega_2 * x48
    x50 = omega_1 * x49
    x51 = f_11 * f_11
    x52 = 1 / 4 * x51
    x53 = 4 * f_11 * x42
    x54 = 2 * omega_1
    x55 = omega_2 + x54
    x56 = 3 / 16 * x47
    x57 = f_22 * f_22
    x58 = 1 / 4 * x57
    x59 = 4 * f_22
    # Outputs
    out[..., 0] = 2
    out[..., 1] = 2
    out[..., 2] = x2 * x4
    out[..., 3] = -x6 * x7
    out[..., 4] = x10 * x7
    out[..., 5] = x12 * x6
    out[..., 6] = x12 * x15
    out[..., 7] = x17 * x2
    out[..., 8] = -f_12 * x16 * x19 * x30 * (2 * f_11 * x22 - x21 - 3 * x23 - x26)
    out[..., 9] = (
        -x15 * x16 * x38 * x4 * (f_11 * x39 + 8 * omega_1 * x34 + x32 * x33 + 8 * x35
        - 12 * f_11 * x40 - 7 * x31)
    )
    out[..., 10] = -1 / 4 * f_12 * x43 / x20
    out[..., 11] = x4 * x45 * x46 * (f_11 * x13 + x24 + 4 * x25)
    out[..., 12] = x30 * (1 / 8 * f_12 * f_21 * x20 - x20 * x52 - x22 * x48 - x50) / x40
    out[..., 13] = -omega_2 * x37 * x53
    out[..., 14] = -x19 * x53 * x55
    out[..., 15] = x10 * x16 * x29 * (omega_1 * x52 + omega_1 * x56 + x49) / x55
    out[..., 16] = x30 * (x20 * x48 + x22 * x58 + x50 - 1 / 8 * x22 * x47) / x39
    out[..., 17] = -omega_1 * x37 * x42 * x59
    out[..., 18] = -x43 * x45 * x59
    out[..., 19] = x15 * x29 * x3 * (omega_1 * x48 + omega_2 * x56 + omega_2 * x58) / x41
    out[..., 20] = -f_21 * x3 * x30 * x45 * (3 * x21 + x23 + x26 - x11 * x20)
    out[..., 21] = (
        -x10 * x17 * x3 * x38 * (f_22 * x40 + 8 * omega_2 * x33 + 8 * x31 + x34 * x54
        - 12 * f_22 * x39 - 7 * x35)
    )
    out[..., 22] = -1 / 4 * f_21 * x42 * x55 / x22
    out[..., 23] = x17 * x19 * x46 * (f_22 * x8 + 4 * x24 + x25)
    out[..., 24] = omega_1
    out[..., 25] = omega_2 + sigma
    out[..., 26] = sigma + x0


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
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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

    Where Omega = omega_1 + omega_2 + sigma lies on an edge of `boundaries`.

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
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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
        Shape (..., 2, 2), complex128, in 1/s.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21,
        f_22=f_22,
    )
    return evaluate_array(_slow_flow_matrix, arguments, (2, 2))


def characteristic_coefficients(
    *, sigma: ArrayLike, omega_1: ArrayLike, omega_2: ArrayLike, f_11: ArrayLike, f_12: ArrayLike,
    f_21: ArrayLike, f_22: ArrayLike,
) -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Parameters
    ----------
    sigma : array_like
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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
        Shape (..., 3), complex128, highest power of Γ first, beginning with 1.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(
        PARAMETERS, sigma=sigma, omega_1=omega_1, omega_2=omega_2, f_11=f_11, f_12=f_12, f_21=f_21,
        f_22=f_22,
    )
    return evaluate_array(_characteristic_coefficients, arguments, (3,))


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
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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
        Detuning, Omega = omega_1 + omega_2 + sigma, rad/s, real.
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
