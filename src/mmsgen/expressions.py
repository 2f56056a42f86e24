"""From the exact algebra to SymPy: factored numerators over named divisors, term by term."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

import sympy as sp
from flint import fmpq_mpoly

from .alphabet import CONSTANT_NAMES
from .field import Coefficient, ParameterField
from .partial_fractions import partial_fractions
from .series import HarmonicRing, Series

__all__ = ["FieldSymbols", "rational", "series_expression"]


def rational(value: Fraction) -> sp.Rational:
    """A Fraction as a SymPy rational."""
    return sp.Rational(value.numerator, value.denominator)


class FieldSymbols:
    """Coefficients of a field as SymPy expressions.

    Parameters
    ----------
    field : ParameterField
    symbols : mapping
        Generator name → the SymPy expression that it stands for; constants are known.
    """

    def __init__(self, field: ParameterField, symbols: Mapping[str, sp.Expr]) -> None:
        self.field = field
        self._shown: dict[int, tuple[Coefficient, sp.Expr]] = {}
        known = {**CONSTANT_NAMES, **symbols}
        self._gens = [known.get(name, sp.Symbol(name, real=True)) for name in field.names]

    def polynomial(self, p: fmpq_mpoly) -> sp.Expr:
        """A polynomial, expanded."""
        terms = []
        for monomial, c in zip(p.monoms(), p.coeffs(), strict=True):
            powers = [g**e for g, e in zip(self._gens, map(int, monomial), strict=True) if e]
            terms.append(sp.Mul(sp.Rational(int(c.p), int(c.q)), *powers))
        return sp.Add(*terms)

    def factored(self, p: fmpq_mpoly) -> sp.Expr:
        """A polynomial as a product of its irreducible factors."""
        if len(p) == 1:
            return self.polynomial(p)
        content, factors = p.factor()
        number = sp.Rational(int(content.p), int(content.q))
        return sp.Mul(number, *(self.polynomial(f) ** int(e) for f, e in factors))

    def root_of_unity(self, k: int) -> sp.Expr:
        """ζ^k."""
        return sp.exp(2 * sp.pi * sp.I * sp.Rational(k, self.field.roots.n))

    def __call__(self, c: Coefficient) -> sp.Expr:
        """A coefficient as a sum over its divisors where that is shorter, else as one fraction."""
        # Coefficients are immutable; one that is kept beside its expression keeps its identity.
        known = self._shown.get(id(c))
        if known is None:
            expression = sp.Add(*(self._fraction(part) for part in partial_fractions(c)))
            known = self._shown[id(c)] = (c, expression)
        return known[1]

    def _fraction(self, c: Coefficient) -> sp.Expr:
        """A coefficient as one fraction, its numerator factored and its divisors kept apart."""
        if not c.num:
            return sp.Integer(0)
        (_, common), *others = sorted(c.num.items())
        if not others:
            ((k, p),) = c.num.items()
            head = self.factored(p) * self.root_of_unity(k)
        else:
            for _, p in others:
                common = common.gcd(p)
            inner = sp.Add(
                *(self.root_of_unity(k) * self.factored(p / common) for k, p in c.num.items())
            )
            head = sp.Mul(self.factored(common), inner)
        divisors = (
            self.polynomial(self.field.divisors[m]) ** (-e) for m, e in sorted(c.den.items())
        )
        return sp.Mul(head, *divisors)

    def real_imaginary(self, c: Coefficient) -> tuple[sp.Expr, sp.Expr]:
        """Real and imaginary part of a coefficient; the generators are real."""
        n = self.field.roots.n
        parts: list[dict[sp.Expr, list[Coefficient]]] = [{}, {}]
        for k, p in c.num.items():
            angle = 2 * sp.pi * sp.Rational(k, n)
            alone = self.field.cancel(Coefficient(self.field, {0: p}, c.den))
            for part, number in zip(parts, (sp.cos(angle), sp.sin(angle)), strict=True):
                if number != 0:
                    part.setdefault(number, []).append(alone)
        real, imaginary = (
            sp.Add(*(number * self(self.field.sum(cs)) for number, cs in part.items()))
            for part in parts
        )
        return real, imaginary


def series_expression(
    ring: HarmonicRing,
    series: Series,
    coefficient: Callable[[Coefficient], sp.Expr],
    monomial: Callable[[int], sp.Expr],
) -> sp.Expr:
    """A series as a SymPy sum, terms in the order of their packed exponents."""
    return sp.Add(*(coefficient(series[key]) * monomial(key) for key in sorted(series)))
