# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
# Made from sha256 5a1ca4ecd41920df511dd13159259af03be57b8795e4b262cc5d9431171f27b7
# Operations for each point: growth_rate 0, slow_flow_matrix 0, characteristic_coefficients 0,
# slow_flow 0
"""ground_resonance: no resonance, order 1.

Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method of multiple
scales through order 1 in ε, of x, y, phi_1, phi_2, phi_3, phi_4. Results are written at ε = 1.

It cannot be unstable: one mode turns without growing.

Source: Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._runtime import (
    checked,
    checked_amplitudes,
    evaluate,
    evaluate_array,
    evaluate_pair,
    multiply_out,
    no_edges,
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
    "boundaries",
    "characteristic_coefficients",
    "critical_speeds",
    "growth_rate",
    "slow_flow",
    "slow_flow_matrix",
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = ()

#: the highest power of ε
ORDER = 1

#: the coordinates, in the order of amplitudes
COORDINATES = ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4")

#: name -> (domain, unit, meaning)
PARAMETERS = {

}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = {
    "x": {},
    "y": {},
    "phi_1": {},
    "phi_2": {},
    "phi_3": {},
    "phi_4": {},
}

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = ("A_x", "A_y", "A_phi_1", "A_phi_2", "A_phi_3", "A_phi_4")


# --- formulas -------------------------------------------------------------------------------------


def _growth_rate():
    return 0.0


def _slow_flow_matrix(out):
    return


def _characteristic_coefficients(out):
    multiply_out(out, ((0.0,), 1), ((0.0,), 1), ((0.0,), 1), ((0.0,), 1), ((0.0,), 1), ((0.0,), 1))


def _slow_flow(out, A_x, A_y, A_phi_1, A_phi_2, A_phi_3, A_phi_4):
    return


# --- functions ------------------------------------------------------------------------------------


def growth_rate() -> Any:
    """Growth rate of the fastest mode: the largest real part of Γ.

    Modes that turn without growing give exactly 0.0.

    Returns
    -------
    float64
        In 1/s, float64, in the shape to which the arguments broadcast.
    """
    arguments = checked(PARAMETERS)
    return evaluate(_growth_rate, arguments)


def boundaries() -> tuple[Any, Any]:
    """Both edges of the unstable interval of a detuning.

    This case cannot be unstable for any detuning: NaN everywhere.

    Returns
    -------
    lower, upper : float64
        In rad/s, float64, in the shape to which the arguments broadcast; NaN where there is no
        unstable interval.
    """
    arguments = checked(PARAMETERS)
    return evaluate_pair(no_edges, arguments)


def critical_speeds() -> tuple[Any, Any]:
    """Both edges of the unstable zone in the detuned frequency: there is none.

    Without a resonance relation no frequency is detuned: NaN everywhere.

    Returns
    -------
    lower, upper : float64
        NaN, float64, in the shape to which the arguments broadcast.
    """
    arguments = checked(PARAMETERS)
    return evaluate_pair(no_edges, arguments)


def slow_flow_matrix() -> NDArray[np.complex128]:
    """The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.

    Rows and columns in the order of VARIABLES.

    Returns
    -------
    complex128
        Shape (..., 6, 6), complex128, in 1/s.
    """
    arguments = checked(PARAMETERS)
    return evaluate_array(_slow_flow_matrix, arguments, (6, 6))


def characteristic_coefficients() -> NDArray[np.complex128]:
    """Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).

    The product of its factors over the rationals.

    Returns
    -------
    complex128
        Shape (..., 7), complex128, highest power of Γ first, beginning with 1.
    """
    arguments = checked(PARAMETERS)
    return evaluate_array(_characteristic_coefficients, arguments, (7,))


def slow_flow(amplitudes: ArrayLike, /) -> NDArray[np.complex128]:
    """Right-hand side of the modulation equations: the time derivative of amplitudes.

    In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME.

    Parameters
    ----------
    amplitudes : array_like
        Shape (..., 6), in the order of COORDINATES.

    Returns
    -------
    complex128
        Shape (..., 6), complex128, in the unit of the amplitudes per second.

    Raises
    ------
    ValueError
        If a value is not a finite real number in the domain given above; it is named.
    """
    arguments = checked(PARAMETERS)
    return evaluate_array(_slow_flow, [*checked_amplitudes(amplitudes, 6), *arguments], (6,))
