"""The period of M(t), C(t) and K(t), found in the symbols and never in numbers.

Time may occur in the argument of a sine, a cosine or another periodic function, and in
exp(iωt). The frequencies found must be rational multiples of one of them, as expressions in
the parameters: then 2π over their greatest common divisor is a period (not always the
shortest: cos²Ωt counts as Ω, and a multiple of a period is as good).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import reduce

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from ..errors import FloquetError

__all__ = ["Periodicity", "find_periodicity"]


@dataclass(frozen=True)
class Periodicity:
    """How time enters the equations.

    Parameters
    ----------
    base : sympy.Expr
        Angular frequency of which all frequencies are integer multiples; the period is 2π/base.
    arguments : tuple of (sympy.Expr, sympy.Expr, sympy.Expr)
        For each argument that contains time: the argument, its multiple r of the base and its
        phase φ, so that argument = r·(base·t) + φ.
    """

    base: sp.Expr
    arguments: tuple[tuple[sp.Expr, sp.Expr, sp.Expr], ...]

    @property
    def highest(self) -> int:
        """Largest integer multiple of the base that multiplies time."""
        return max(int(abs(ratio)) for _, ratio, _ in self.arguments)

    def in_phase(self, expression: sp.Expr, phase: sp.Symbol) -> sp.Expr:
        """`expression` with base·t written as `phase`, so that no parameter multiplies time."""
        return expression.xreplace(
            {
                argument: _imaginary_factor(argument) * (ratio * phase + shift)
                for argument, ratio, shift in self.arguments
            }
        )


def find_periodicity(expressions: Iterable[sp.Expr], time: sp.Symbol) -> Periodicity | None:
    """Find the common base frequency of all expressions.

    Parameters
    ----------
    expressions : iterable of sympy.Expr
        Entries of M, C and K.
    time : sympy.Symbol
        The time symbol.

    Returns
    -------
    Periodicity or None
        None when time occurs nowhere.

    Raises
    ------
    FloquetError
        If time occurs outside periodic functions, or the frequencies are not rational multiples
        of one another as expressions in the parameters.
    """
    found: dict[sp.Expr, tuple[sp.Expr, sp.Expr]] = {}
    for expression in expressions:
        _collect(expression, time, found)
    if not found:
        return None
    reference = next(iter(found.values()))[0]
    ratios = {}
    for argument, (frequency, _) in found.items():
        ratio = sp.cancel(sp.together(frequency / reference))
        if not ratio.is_Rational:
            names = sorted({str(w) for w, _ in found.values()})
            raise FloquetError(
                f"the frequencies {', '.join(names)} are not rational multiples of one of them, "
                "so no common period can be read off: pass period= (a number, an array or an "
                "expression in the parameters), or express one frequency by the other with "
                "reparametrise"
            )
        ratios[argument] = ratio
    divisor = reduce(_gcd, (abs(ratio) for ratio in ratios.values()))
    base = reference * divisor
    if base.could_extract_minus_sign():
        base, divisor = -base, -divisor
    return Periodicity(
        base=base,
        arguments=tuple(
            (argument, ratios[argument] / divisor, phase) for argument, (_, phase) in found.items()
        ),
    )


def _gcd(left: sp.Rational, right: sp.Rational) -> sp.Rational:
    """Greatest common divisor of two positive rationals."""
    return sp.Rational(sp.igcd(left.p * right.q, right.p * left.q), left.q * right.q)


def _imaginary_factor(argument: sp.Expr) -> sp.Expr:
    """I for an argument of exp(iωt), 1 for the real argument of a sine or cosine."""
    return sp.I if argument.has(sp.I) else sp.S.One


def _collect(
    expression: sp.Expr, time: sp.Symbol, found: dict[sp.Expr, tuple[sp.Expr, sp.Expr]]
) -> None:
    """Add every argument that contains `time` to `found`, with its frequency and phase."""
    if not expression.has(time):
        return
    if isinstance(expression, (TrigonometricFunction, sp.exp)):
        argument = expression.args[0]
        linear = _linear(argument, time)
        if linear is not None:
            frequency, phase = linear
            if isinstance(expression, sp.exp):
                frequency, phase = _exact(frequency / sp.I), phase / sp.I
                if frequency.has(sp.I) or phase.has(sp.I):
                    raise FloquetError(
                        f"{expression} is not periodic in {time}: Floquet theory needs "
                        "coefficients that repeat"
                    )
            found.setdefault(argument, (frequency, phase))
            return
    if not expression.args or isinstance(expression, sp.Derivative):
        raise FloquetError(
            f"time occurs outside sin, cos and exp(i ω {time}) in {expression}: the coefficients "
            "are not periodic, or the equations are not linearised"
        )
    if isinstance(expression, sp.core.function.AppliedUndef):
        raise FloquetError(
            f"{expression} is an unknown function of time in M, C or K: linearise the equations "
            "(eom.linearise()), or give the function explicitly"
        )
    for part in expression.args:
        _collect(part, time, found)


def _linear(argument: sp.Expr, time: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """(ω, φ) if the argument is ω·t + φ with both free of time, else None."""
    expanded = sp.expand(argument)
    frequency = expanded.coeff(time, 1)
    phase = expanded.coeff(time, 0)
    if frequency.has(time) or phase.has(time) or frequency == 0:
        return None
    if sp.expand(expanded - frequency * time - phase) != 0:
        return None
    return _exact(frequency), phase


def _exact(frequency: sp.Expr) -> sp.Expr:
    """Floats in a frequency as the binary fractions that they are, so that ratios are exact."""
    return frequency.xreplace({x: sp.Rational(x) for x in frequency.atoms(sp.Float)})
