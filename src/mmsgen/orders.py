"""Orders in ε as a user gives them, checked."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from operator import index
from typing import TYPE_CHECKING, Any

import sympy as sp

from .errors import ScalingError
from .symbols import amplitude as amplitude_of
from .symbols import coordinate_name, imaginary_part, modulus, phase, real_part

if TYPE_CHECKING:
    from .equations import EquationsOfMotion

__all__ = ["amplitude_orders", "check_names", "is_coordinate", "whole"]


def whole(value: object, what: str, least: int) -> int:
    """A whole number, of whatever type."""
    try:
        number = least - 1 if isinstance(value, bool) else index(value)  # type: ignore[arg-type]
    except TypeError:
        number = least - 1
    if number < least:
        raise ScalingError(f"{what} must be a whole number >= {least}, got {value!r}")
    return number


def check_names(eom: EquationsOfMotion, known: Mapping[str, sp.Symbol]) -> None:
    """Amplitudes and phases are symbols too, which no parameter may be confused with."""
    for q in eom.coordinates:
        for made in (amplitude_of, modulus, phase, real_part, imaginary_part):
            name = str(made(q).name)
            if name in known:
                raise ScalingError(
                    f"the parameter {name} has the name of an amplitude or phase of {q} in the "
                    "slow flow: rename the parameter"
                )


def is_coordinate(eom: EquationsOfMotion, key: object) -> bool:
    """Whether a key that should be a parameter is a coordinate or the name of one."""
    return any(key == q or str(key) == coordinate_name(q) for q in eom.coordinates)


def _amplitude_order(q: sp.Expr, value: object) -> Fraction:
    try:
        order = sp.sympify(value, strict=True)
    except sp.SympifyError:
        order = sp.nan
    if not isinstance(order, sp.Rational) or order < 0:
        raise ScalingError(
            f"the order of the amplitude of {q} must be a rational number >= 0, got {value!r}"
        )
    return Fraction(int(order.p), int(order.q))


def amplitude_orders(
    eom: EquationsOfMotion, amplitude: int | sp.Rational | Mapping[sp.Expr, Any]
) -> tuple[Fraction, ...]:
    """The order of every coordinate's amplitude, from one for all or one for each."""
    if not isinstance(amplitude, Mapping):
        return tuple(_amplitude_order(q, amplitude) for q in eom.coordinates)
    for key in amplitude:
        if key not in eom.coordinates:
            raise ScalingError(f"{key} is not a coordinate, so its amplitude cannot be scaled")
    missing = [str(q) for q in eom.coordinates if q not in amplitude]
    if missing:
        raise ScalingError(f"no amplitude order is given for {', '.join(missing)}")
    return tuple(_amplitude_order(q, amplitude[q]) for q in eom.coordinates)
