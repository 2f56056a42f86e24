"""Polynomials in one amplitude with exact coefficients: what is essential of them, and how to show.

`Exact` gives coefficients of a `ParameterField` the operations that `runtime._elimination` asks of
its numbers, so that one elimination serves formulas and arrays.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import gcd, lcm
from typing import Any

import flint
import sympy as sp
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from .errors import ExpansionError
from .expressions import FieldSymbols
from .field import Coefficient

__all__ = ["AmplitudePolynomials", "Exact", "primitive"]


class Exact:
    """An exact complex coefficient with the operations of a complex number.

    Parameters
    ----------
    value : Coefficient
    """

    __slots__ = ("value",)

    def __init__(self, value: Coefficient) -> None:
        self.value = value

    def __bool__(self) -> bool:
        return bool(self.value)

    def __add__(self, other: Exact) -> Exact:
        return Exact(self.value + other.value)

    def __radd__(self, zero: float) -> Exact:
        assert zero == 0.0
        return self

    def __mul__(self, other: Exact) -> Exact:
        return Exact(self.value * other.value)

    def __rmul__(self, number: float) -> Exact:
        return self.scaled(Fraction(number))

    def scaled(self, number: Fraction) -> Exact:
        """The product with a rational number."""
        return Exact(self.value.scale(number))

    def conj(self) -> Exact:
        """The complex conjugate."""
        return Exact(self.value.conjugate())

    @property
    def real(self) -> Exact:
        """The real part."""
        return Exact((self.value + self.value.conjugate()).scale(Fraction(1, 2)))

    @property
    def imag(self) -> Exact:
        """The imaginary part."""
        return Exact((self.value - self.value.conjugate()).scale(Fraction(1, 2)).times_i(-1))


class AmplitudePolynomials:
    """Real polynomials in an amplitude a > 0 and the generators of a field.

    Parameters
    ----------
    symbols : FieldSymbols
        How the generators are shown.
    amplitude : sympy.Symbol
    """

    def __init__(self, symbols: FieldSymbols, amplitude: sp.Symbol) -> None:
        self.symbols, self.amplitude = symbols, amplitude
        names = tuple(f"g{k}" for k in range(len(symbols.field.names) + 1))
        self.ctx = fmpq_mpoly_ctx.get(names, flint.Ordering.degrevlex)
        shown = [symbols.polynomial(symbols.field.gens[n]) for n in symbols.field.names]
        self._positive = [bool(g.is_positive) for g in shown] + [True]

    def polynomial(self, powers: Mapping[int, Any]) -> fmpq_mpoly:
        """A polynomial without denominators from {power of a: real `Exact`}.

        Raises
        ------
        ExpansionError
            If coefficients hold irrational constants.
        """
        den: dict[int, int] = {}
        for c in powers.values():
            for m, e in c.value.den.items():
                den[m] = max(e, den.get(m, 0))
        field = self.symbols.field
        terms: dict[tuple[int, ...], Any] = {}
        for power, c in powers.items():
            numerator = c.value
            for m, e in den.items():
                left = e - c.value.den.get(m, 0)
                numerator = numerator.times(field.polynomial(field.divisors[m] ** left))
            if numerator.num.keys() - {0}:
                raise ExpansionError(
                    "this relation has irrational coefficients, from phases that are fractions of "
                    "a turn: write their cosines and sines as parameters"
                )
            for monomial, value in numerator.num.get(0, field.ctx.constant(0)).to_dict().items():
                terms[(*map(int, monomial), power)] = value
        return self.ctx.from_dict(terms)

    def essential(self, p: fmpq_mpoly) -> fmpq_mpoly:
        """The factors that can vanish for a > 0, each of them once; 1 where there are none.

        Factors that do not contain a stay: they are conditions on the parameters alone.
        """
        _, factors = p.factor()
        result = self.ctx.constant(1)
        for factor, _ in factors:
            if not self._definite(factor):
                result *= primitive(factor)
        return result

    def with_amplitude(self, p: fmpq_mpoly) -> fmpq_mpoly:
        """The factors of an essential part that contain a."""
        result = self.ctx.constant(1)
        for factor, _ in p.factor()[1]:
            if factor.degrees()[-1]:
                result *= primitive(factor)
        return result

    def _definite(self, p: fmpq_mpoly) -> bool:
        """Whether all terms have one sign, one of them without a zero."""
        signs = {c > 0 for c in p.coeffs()}
        odd = [
            any(e % 2 and not s for e, s in zip(map(int, m), self._positive, strict=True))
            for m in p.monoms()
        ]
        sure = [
            all(s or not e for e, s in zip(map(int, m), self._positive, strict=True))
            for m in p.monoms()
        ]
        return len(signs) == 1 and not any(odd) and any(sure)

    def slope(self, p: fmpq_mpoly) -> fmpq_mpoly:
        """The derivative by a."""
        return p.derivative(len(self._positive) - 1)

    def shown(self, p: fmpq_mpoly) -> sp.Expr:
        """A polynomial in powers of a, or as the product of its factors where it has several."""
        content, factors = p.factor()
        number = sp.Rational(int(content.p), int(content.q))
        parts = [self._powers(f) ** int(e) for f, e in sorted(factors, key=lambda f: str(f[0]))]
        return sp.Mul(number, *parts)

    def _powers(self, p: fmpq_mpoly) -> sp.Expr:
        by_power: dict[int, dict[tuple[int, ...], Any]] = {}
        for monomial, c in p.to_dict().items():
            *rest, power = map(int, monomial)
            by_power.setdefault(power, {})[tuple(rest)] = c
        ctx = self.symbols.field.ctx
        return sp.Add(
            *(
                sp.Mul(self.symbols.factored(ctx.from_dict(terms)), self.amplitude**power)
                for power, terms in sorted(by_power.items())
            )
        )


def primitive(p: fmpq_mpoly) -> fmpq_mpoly:
    """The polynomial with whole coefficients without a common divisor, the first one positive."""
    coefficients = p.coeffs()
    common = gcd(*(int(c.p) for c in coefficients))
    scale = fmpq(lcm(*(int(c.q) for c in coefficients)), common)
    return p * (scale if coefficients[0] > 0 else -scale)
