"""SymPy expressions at numbers, to the working precision of mpmath."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath
import sympy as sp

from ..errors import EmissionError

__all__ = ["exact"]


def exact(expression: sp.Expr, values: Mapping[str, Any]) -> Any:
    """Evaluate an expression as it stands.

    Parameters
    ----------
    expression : sympy.Expr
    values : mapping
        Name of a symbol → mpmath number.
    """
    return _value(expression, values, {})


def _value(expression: sp.Expr, values: Mapping[str, Any], known: dict[sp.Expr, Any]) -> Any:
    if expression.is_Symbol:
        return values[expression.name]
    if expression not in known:
        known[expression] = _computed(expression, values, known)
    return known[expression]


def _computed(expression: sp.Expr, values: Mapping[str, Any], known: dict[sp.Expr, Any]) -> Any:
    if expression.is_Rational:
        return mpmath.mpf(int(expression.p)) / int(expression.q)
    if expression is sp.I:
        return mpmath.mpc(0, 1)
    if expression.is_number and not expression.args:
        return mpmath.mpmathify(expression.evalf(mpmath.mp.dps + 5))
    inner = [_value(a, values, known) for a in expression.args]
    if expression.is_Add:
        return mpmath.fsum(inner)
    if expression.is_Mul:
        return mpmath.fprod(inner)
    if expression.is_Pow:
        negative = not isinstance(inner[0], mpmath.mpc) and inner[0] < 0
        if negative and not expression.exp.is_Integer:
            return mpmath.nan
        return inner[0] ** (int(expression.exp) if expression.exp.is_Integer else inner[1])
    for kind, function in _FUNCTIONS.items():
        if isinstance(expression, kind):
            return function(inner[0])
    raise EmissionError(f"{expression.func} cannot be evaluated: {expression}")


_FUNCTIONS = {
    sp.Abs: abs,
    sp.conjugate: mpmath.conj,
    sp.exp: mpmath.exp,
    sp.cos: mpmath.cos,
    sp.sin: mpmath.sin,
    sp.re: mpmath.re,
    sp.im: mpmath.im,
}
