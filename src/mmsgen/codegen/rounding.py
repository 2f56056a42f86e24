"""Rounding errors of emitted code, bounded from its formulas: running error analysis.

An expression is evaluated at high precision together with a bound of the error that the same
expression makes in double precision, every operation being rounded once (IEEE 754; u = 2⁻⁵³). The
bound is of first order in u; N. J. Higham, *Accuracy and Stability of Numerical Algorithms* (2002),
section 3.3. What a test demands of emitted code comes from here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import reduce
from operator import mul
from typing import Any

import mpmath
import sympy as sp

from ..errors import EmissionError
from ..ir import IR

__all__ = ["UNIT", "Rounded", "rounded"]

UNIT = mpmath.mpf(2) ** -53


@dataclass(frozen=True)
class Rounded:
    """A value and the bound of the error that double precision makes in it.

    Attributes
    ----------
    value : mpmath.mpf or mpmath.mpc
    error : mpmath.mpf
    """

    value: Any
    error: Any

    def __add__(self, other: Rounded) -> Rounded:
        value = self.value + other.value
        return Rounded(value, self.error + other.error + UNIT * abs(value))

    def __mul__(self, other: Rounded) -> Rounded:
        value = self.value * other.value
        own = abs(self.value) * other.error + abs(other.value) * self.error
        # Four products and two sums make a complex product: |error| ≤ √8 u |value|.
        unit = UNIT * (3 if isinstance(value, mpmath.mpc) else 1)
        return Rounded(value, own + self.error * other.error + unit * abs(value))

    def inverse(self) -> Rounded:
        """1/x, rounded once."""
        value = 1 / self.value
        return Rounded(value, self.error * abs(value) ** 2 + UNIT * abs(value))

    def root(self) -> Rounded:
        """√x, rounded once; exact NaN below zero."""
        if self.value < 0:
            return Rounded(mpmath.nan, mpmath.mpf(0))
        value = mpmath.sqrt(self.value)
        own = self.error / (2 * value) if value else mpmath.sqrt(self.error)
        return Rounded(value, own + UNIT * value)


def rounded(ir: IR, values: Mapping[str, Any]) -> dict[str, Rounded]:
    """Evaluate a function at the working precision of mpmath, with error bounds.

    Parameters
    ----------
    ir : IR
    values : mapping
        Argument name → number that a double holds exactly, or a `Rounded`.

    Returns
    -------
    dict
        Output name → value and bound.
    """
    known: dict[sp.Symbol, Rounded] = {}
    for symbol in ir.arguments:
        value = values[symbol.name]
        if not isinstance(value, Rounded):
            value = Rounded(mpmath.mpmathify(value), mpmath.mpf(0))
        known[symbol] = value
    for symbol, expression in ir.intermediates:
        known[symbol] = _evaluate(expression, known)
    return {name: _evaluate(expression, known) for name, expression in ir.outputs}


def _evaluate(expression: sp.Expr, known: Mapping[sp.Symbol, Rounded]) -> Rounded:
    if expression.is_Symbol:
        return known[expression]
    if expression.is_Rational:
        value = mpmath.mpf(int(expression.p)) / int(expression.q)
        exact = value == float(value)
        return Rounded(value, mpmath.mpf(0) if exact else UNIT * abs(value))
    if expression is sp.I:
        return Rounded(mpmath.mpc(0, 1), mpmath.mpf(0))
    inner = [_evaluate(a, known) for a in expression.args]
    if expression.is_Add:
        # In whichever order they are added: no partial sum exceeds the sum of the moduli.
        size = mpmath.fsum(abs(x.value) for x in inner)
        error = mpmath.fsum(x.error for x in inner) + (len(inner) - 1) * UNIT * size
        return Rounded(mpmath.fsum(x.value for x in inner), error)
    if expression.is_Mul:
        return reduce(mul, inner)
    if expression.is_Pow:
        return _power(inner[0], expression.exp)
    if isinstance(expression, sp.Abs):
        size = abs(inner[0].value)
        unit = 2 * UNIT if isinstance(inner[0].value, mpmath.mpc) else 0  # that of hypot
        return Rounded(size, inner[0].error + unit * size)
    if isinstance(expression, sp.conjugate):
        return Rounded(mpmath.conj(inner[0].value), inner[0].error)
    if expression.is_number:
        value = mpmath.mpmathify(expression.evalf(mpmath.mp.dps))
        return Rounded(value, UNIT * abs(value))
    if isinstance(expression, sp.exp):
        value = mpmath.exp(inner[0].value)
        return Rounded(value, abs(value) * (inner[0].error + 4 * UNIT))
    raise EmissionError(f"{expression.func} cannot be emitted: {expression}")


def _power(base: Rounded, exponent: sp.Expr) -> Rounded:
    if exponent == 2:
        return base * base
    if exponent == -1:
        return base.inverse()
    if exponent == sp.Rational(1, 2):
        return base.root()
    if exponent == sp.Rational(-1, 2):
        return base.root().inverse()
    if exponent.is_Integer and exponent > 0:
        result = base
        for _ in range(int(exponent) - 1):
            result = result * base
        return result
    raise EmissionError(f"a power {exponent} cannot be emitted")
