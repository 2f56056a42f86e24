"""Constants with radicals, sines and cosines: one normal form, and whether one is exactly zero.

An expression in parameters is written over generators: its symbols, one pair C, S for every angle
with S² = 1 − C², and one y for every radical with y^q = r. They form a tower of simple algebraic
extensions of the rational functions, in which division with remainder gives one form to each
number (Geddes, Czapor and Labahn, *Algorithms for Computer Algebra*, 1992, chapter 2).

A normal form that is zero proves that the expression is zero. One that is not zero proves that it
is not only if its norm, the product over all branches of the radicals, is not zero either; where
both fail, the answer is "undecided".
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

import sympy as sp
from sympy.polys.polyerrors import NotInvertible

from .parameters import Parameter
from .terms import ratio

__all__ = ["Algebra", "Root", "quotients"]

_QUOTIENTS = {
    sp.tan: lambda a: sp.sin(a) / sp.cos(a),
    sp.cot: lambda a: sp.cos(a) / sp.sin(a),
    sp.sec: lambda a: 1 / sp.cos(a),
    sp.csc: lambda a: 1 / sp.sin(a),
}


@dataclass(frozen=True)
class Root:
    """A generator y with y^degree = value, a rational function of the generators before it."""

    symbol: sp.Symbol
    degree: int
    value: sp.Expr


class Algebra:
    """The tower of extensions in which a set of constants lies.

    Parameters
    ----------
    names : sequence of Parameter
        Those with a definition name a cosine, a sine, another function or a radical: their
        symbols serve as its generator. Definitions that are rational are left alone.
    expressions : iterable of sympy.Expr
        The constants.

    Attributes
    ----------
    roots : list of Root
        The extensions, each over those before it.
    written : dict
        Generator without a name → the function or radical that it stands for.
    """

    def __init__(self, names: Sequence[Parameter], expressions: Iterable[sp.Expr]) -> None:
        self.roots: list[Root] = []
        self.written: dict[sp.Symbol, sp.Expr] = {}
        self.unsure = False
        self._functions: dict[sp.Expr, sp.Expr] = {}
        self._radicals: dict[sp.Expr, tuple[sp.Symbol, int]] = {}
        plain = [quotients(e) for e in expressions]
        self._named = {p.definition: p.symbol for p in names if p.definition is not None}
        self._steps = _steps([*plain, *self._named])
        for definition, symbol in self._named.items():
            self._adopt(symbol, definition)
        self._values = {e: self._rational(p) for e, p in zip(expressions, plain, strict=True)}

    # -- generators ----------------------------------------------------------------------

    def _adopt(self, symbol: sp.Symbol, definition: sp.Expr) -> None:
        """Make the symbol of a name a generator."""
        if isinstance(definition, sp.Function):
            if isinstance(definition, sp.cos | sp.sin):
                self._angle(definition.args[0])
            else:
                self._functions.setdefault(definition, symbol)
            return
        exponents = [e for e in definition.as_powers_dict().values() if e.is_Rational]
        degree = lcm(*(int(e.q) for e in exponents))
        if degree > 1:
            value = ratio(self._rational(sp.expand_power_base(definition**degree)))
            self.roots.append(Root(symbol, degree, value))
            if definition.is_Pow and definition.exp == sp.Rational(1, degree):
                self._radicals[value] = (symbol, degree)

    def _angle(self, unit: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """The cosine and the sine of an angle of which others are whole multiples."""
        functions = sp.cos(unit), sp.sin(unit)
        if functions[0] in self._functions:
            return self._functions[functions[0]], self._functions[functions[1]]
        if not any(isinstance(f, sp.cos | sp.sin) for f in functions):
            pair = tuple(self._rational(f) for f in functions)  # of an inverse function
        else:
            order = list(self._named)
            rank = [order.index(f) if f in self._named else len(order) for f in functions]
            pair = tuple(self._generator(f) for f in functions)
            first, second = pair if rank[0] <= rank[1] else pair[::-1]
            self.roots.append(Root(second, 2, 1 - first**2))
            self.unsure |= bool(unit.atoms(sp.Function))
        self._functions.update(zip(functions, pair, strict=True))
        return pair[0], pair[1]

    def _generator(self, function: sp.Expr) -> sp.Symbol:
        symbol = self._named.get(function)
        if symbol is None:
            symbol = sp.Dummy(str(function), real=True)
            self.written[symbol] = function
        return symbol

    def _rotated(self, function: sp.Expr) -> sp.Expr:
        """A sine or cosine of a sum in the generators of its terms."""
        cosine, sine = sp.S.One, sp.S.Zero
        for term in sp.Add.make_args(sp.expand(function.args[0])):
            number, base = term.as_coeff_Mul()
            if base == sp.pi or not number.is_Rational:
                c, s = (self._rational(self._opaque(f)) for f in (sp.cos(term), sp.sin(term)))
            else:
                step = self._steps[base]
                n = int(number / sp.Rational(step.numerator, step.denominator))
                first, second = self._angle(number / n * base)
                size = abs(n)
                c = sp.chebyshevt(size, first)
                s = sp.sign(n) * second * sp.chebyshevu(size - 1, first)
            cosine, sine = sp.expand(cosine * c - sine * s), sp.expand(sine * c + cosine * s)
        return cosine if isinstance(function, sp.cos) else sine

    def _opaque(self, expr: sp.Expr) -> sp.Expr:
        """Values such as cos(π/7), whose algebraic relations are not known here."""
        table = {f: self._unknown(f) for f in _ordered(expr.atoms(sp.cos, sp.sin))}
        return expr.xreplace(table)

    def _unknown(self, function: sp.Expr) -> sp.Expr:
        if function not in self._functions:
            self._functions[function] = self._generator(function)
            self.unsure = True
        return self._functions[function]

    def _rational(self, expr: sp.Expr) -> sp.Expr:
        """An expression as a rational function of generators."""
        table: dict[sp.Expr, sp.Expr] = {}
        for f in _ordered(_outermost(expr)):
            turning = isinstance(f, sp.cos | sp.sin) and f not in self._functions
            table[f] = self._rotated(f) if turning else self._unknown(f)
        expr = expr.xreplace(table)
        while radicals := [p for p in _ordered(expr.atoms(sp.Pow)) if _innermost(p)]:
            expr = expr.xreplace({p: self._radical(p) for p in radicals})
        return expr

    def _radical(self, power: sp.Pow) -> sp.Expr:
        outside, value = _positive_part(ratio(power.base))
        degree = int(power.exp.q)
        if outside != 1:
            return self._rational(outside**power.exp * value**power.exp)
        known, size = self._radicals.get(value, (None, 0))
        if known is None or size % degree:
            if known is not None:
                self.unsure = True  # two radicals of one base are not independent
            known, size = sp.Dummy(str(power), real=True), degree
            self.roots.append(Root(known, degree, value))
            self._radicals[value] = (known, degree)
            self.written[known] = sp.Pow(self.shown(value), sp.Rational(1, degree))
        return known ** (power.exp * size)

    # -- results -------------------------------------------------------------------------

    def shown(self, expr: sp.Expr) -> sp.Expr:
        """An expression in generators with those that have no name written out."""
        for symbol in reversed(self.written):
            expr = expr.xreplace({symbol: self.written[symbol]})
        return expr

    def reduced(self, expr: sp.Expr) -> sp.Expr:
        """The normal form of one of the expressions, in generators.

        Raises
        ------
        ZeroDivisionError
            If a denominator is zero in this algebra.
        """
        return self._reduced(expr, free=True)

    def _reduced(self, expr: sp.Expr, free: bool) -> sp.Expr:
        value = self._values[expr]
        for root in reversed(self.roots):
            value = _reduced(value, root, free)
        value = sp.cancel(value)
        if value.has(sp.zoo, sp.nan):
            raise ZeroDivisionError("a denominator is zero")
        return value

    def vanishes(self, expr: sp.Expr) -> bool | None:
        """Whether one of the expressions is zero for all parameters; None where undecided."""
        try:
            value = self._reduced(expr, free=False)  # for zero, the numerator is enough
        except ZeroDivisionError:
            return None
        if value == 0:
            return True
        # Where the norm is not zero at one point, in rational numbers, it is not zero.
        roots = {root.symbol for root in self.roots}
        free = _ordered(
            {s for e in (value, *(r.value for r in self.roots)) for s in e.free_symbols} - roots
        )
        point = {s: sp.Rational(sp.prime(40 + j), 101) for j, s in enumerate(free)}
        norm = sp.fraction(sp.together(value.xreplace(point)))[0]
        for root in reversed(self.roots):
            if norm.has(root.symbol):
                over, under = sp.fraction(sp.together(root.value.xreplace(point)))
                relation = under * root.symbol**root.degree - over
                norm = sp.resultant(norm, relation, root.symbol)
        return None if self.unsure or sp.expand(norm) == 0 else False


def _ordered(expressions: Iterable[sp.Basic]) -> list[sp.Expr]:
    """Sort a set into an order that does not depend on hashes."""
    return sorted(expressions, key=sp.default_sort_key)


def _outermost(expr: sp.Expr) -> set[sp.Expr]:
    """Functions, and powers with other than rational exponents, that stand in no other one."""
    if isinstance(expr, sp.Function) or (isinstance(expr, sp.Pow) and not expr.exp.is_Rational):
        return {expr}
    return {f for arg in expr.args for f in _outermost(arg)}


def quotients(expr: sp.Expr) -> sp.Expr:
    """Write tangents and their relatives in sines and cosines."""
    for function, quotient in _QUOTIENTS.items():
        expr = expr.replace(function, quotient)
    return expr


def _innermost(power: sp.Pow) -> bool:
    nested = any(p.exp.is_Rational and not p.exp.is_Integer for p in power.base.atoms(sp.Pow))
    return bool(power.exp.is_Rational and not power.exp.is_Integer and not nested)


def _positive_part(value: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Split a rational function into its positive numbers and symbols, and the rest."""
    outside = sp.S.One
    if value.is_Atom:
        return outside, value
    for part, sign in zip(sp.fraction(value), (1, -1), strict=True):
        number, rest = sp.expand(part).as_content_primitive()
        common = sp.gcd_terms(rest).as_powers_dict().items()
        symbols = (b**e for b, e in common if b.is_Symbol and b.is_positive)
        outside *= sp.Mul(number, *symbols) ** sign
    return outside, ratio(value / outside)


def _steps(expressions: Sequence[sp.Expr]) -> dict[sp.Expr, Fraction]:
    """For every angle the largest step of which all that occur are whole multiples."""
    steps: dict[sp.Expr, Fraction] = {}
    for function in {f for e in expressions for f in e.atoms(sp.cos, sp.sin)}:
        for term in sp.Add.make_args(sp.expand(function.args[0])):
            number, base = term.as_coeff_Mul()
            if number.is_Rational:
                least = Fraction(int(isinstance(base, sp.asin | sp.acos | sp.atan)))
                old, new = steps.get(base, least), Fraction(int(number.p), int(number.q))
                over = gcd(old.numerator * new.denominator, new.numerator * old.denominator)
                steps[base] = Fraction(over, old.denominator * new.denominator)
    return steps


def _reduced(value: sp.Expr, root: Root, free: bool) -> sp.Expr:
    """Lower the powers of one root below its degree, and free the denominator of it if asked to."""
    y = root.symbol
    if not value.has(y):
        return value
    relation = sp.Poly(y**root.degree - root.value, y, field=True)
    over, under = (
        sp.Poly(part, y, domain=relation.domain.unify(sp.Poly(part, y, field=True).domain))
        for part in sp.fraction(sp.cancel(value))
    )
    under = under.rem(relation)
    if under.is_zero:
        raise ZeroDivisionError(f"a denominator is zero because of {y}")
    if free and under.degree() > 0:
        try:
            over, under = over * under.invert(relation), sp.Poly(1, y)
        except NotInvertible:
            raise ZeroDivisionError(f"a denominator may be zero because of {y}") from None
    return sp.cancel(over.rem(relation).as_expr() / under.as_expr())
