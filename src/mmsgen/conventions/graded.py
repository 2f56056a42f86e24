"""Truncated series in ε with SymPy coefficients: {order: expression}, and how they compose."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from operator import index
from typing import Any

import sympy as sp

from ..errors import ConventionError
from ..terms import ratio
from ..validation import TIME

__all__ = ["Amplitudes", "Graded", "composed", "conjugated", "exact", "graded", "tidy"]

Graded = dict[int, sp.Expr]
"""Order in ε → coefficient."""

_NOT_FINITE = (sp.nan, sp.zoo, sp.oo, -sp.oo)


def exact(value: object, where: str) -> sp.Expr:
    """A finite expression without floating-point numbers.

    Raises
    ------
    ConventionError
        If it is anything else, or text.
    """
    try:
        expr = sp.sympify(value, strict=True)
    except sp.SympifyError:
        expr = None
    if not isinstance(expr, sp.Expr) or expr.has(sp.Float, *_NOT_FINITE):
        raise ConventionError(f"{where} must be an exact, finite expression, got {value!r}")
    return expr


def graded(series: object, where: str, least: int = 0) -> Graded:
    """Check a series {order: expression}.

    Raises
    ------
    ConventionError
        If it is no mapping, or an order is no whole number ≥ `least`.
    """
    if not isinstance(series, Mapping) or not series:
        raise ConventionError(f"{where} must be a mapping order -> expression, got {series!r}")
    result: Graded = {}
    for key, value in series.items():
        try:
            order = least - 1 if isinstance(key, bool) else index(key)
        except TypeError:
            order = least - 1
        if order < least:
            raise ConventionError(f"{where} has the order {key!r}: whole numbers >= {least} only")
        result[order] = exact(value, f"{where} at order {order}")
    return dict(sorted(result.items()))


def conjugated(expr: sp.Expr, pairs: Mapping[sp.Symbol, sp.Symbol]) -> sp.Expr:
    """The complex conjugate of an expression whose other symbols are real.

    Parameters
    ----------
    expr : sympy.Expr
    pairs : mapping
        Amplitude → the symbol that stands for its conjugate.
    """
    return expr.xreplace({sp.I: -sp.I, **pairs, **{bar: a for a, bar in pairs.items()}})


def composed(expr: sp.Expr, values: Mapping[sp.Symbol, Graded], order: int) -> list[sp.Expr]:
    """Coefficients of ε^0 … ε^order after symbols have become series in ε.

    Raises
    ------
    ConventionError
        If there is no expansion.
    """
    present = [s for s in values if s in expr.free_symbols]
    if expr.is_polynomial(*present):
        return _composed_polynomial(expr, {s: values[s] for s in present}, order)
    marker = sp.Dummy("epsilon")
    table = {
        s: sp.Add(*(marker**p * c for p, c in values[s].items() if p <= order)) for s in present
    }
    rest, result = expr.xreplace(table), []
    for p in range(order + 1):
        value = rest.xreplace({marker: sp.S.Zero})
        if value.has(*_NOT_FINITE):
            raise ConventionError(f"{expr} has no expansion where {', '.join(map(str, values))} do")
        result.append(value / sp.factorial(p))
        rest = rest.diff(marker)
    return result


def _composed_polynomial(
    expr: sp.Expr, values: Mapping[sp.Symbol, Graded], order: int
) -> list[sp.Expr]:
    """The same for a polynomial, by truncated products."""
    powers = {}
    for s, series in values.items():
        base = [sp.expand(series.get(p, sp.S.Zero)) for p in range(order + 1)]
        powers[s] = [[sp.S.One] + [sp.S.Zero] * order, base]
    total: list[list[sp.Expr]] = [[] for _ in range(order + 1)]
    terms = sp.Poly(expr, *values).terms() if values else [((), expr)]
    for exponents, coefficient in terms:
        part = [coefficient] + [sp.S.Zero] * order
        for s, e in zip(values, exponents, strict=True):
            while len(powers[s]) <= e:
                powers[s].append(_product(powers[s][-1], powers[s][1]))
            part = _product(part, powers[s][e]) if e else part
        for p, c in enumerate(part):
            total[p].append(c)
    return [sp.Add(*cs) for cs in total]


def _product(f: list[sp.Expr], g: list[sp.Expr]) -> list[sp.Expr]:
    return [sp.expand(sp.Add(*(f[k] * g[p - k] for k in range(p + 1)))) for p in range(len(f))]


def tidy(expr: sp.Expr, variables: Iterable[sp.Expr]) -> sp.Expr:
    """A polynomial in the variables and in e^{iσt}, each coefficient in lowest terms."""
    generators = set(variables) | {TIME}
    totals: dict[sp.Expr, list[sp.Expr]] = {}
    for term in sp.Add.make_args(sp.expand(expr)):
        number, basis = sp.S.One, sp.S.One
        for factor in sp.Mul.make_args(term):
            if factor.free_symbols & generators:
                basis *= factor
            else:
                number *= factor
        totals.setdefault(basis, []).append(number)
    return sp.Add(*(_lowest(sp.Add(*parts)) * basis for basis, parts in totals.items()))


def _lowest(number: sp.Expr) -> sp.Expr:
    """A coefficient as real and imaginary fraction in lowest terms."""
    unit = sp.Dummy("i")
    parts = sp.Add.make_args(sp.expand(number.xreplace({sp.I: unit})))
    real = sp.Add(*(p.xreplace({unit: sp.I}) for p in parts if not p.has(unit)))
    rest = sp.Add(*(p / unit for p in parts if p.has(unit)))
    return ratio(real) + sp.I * ratio(rest.xreplace({unit: sp.I}))


class Amplitudes:
    """Amplitudes with symbols for their conjugates, by which one can differentiate.

    Parameters
    ----------
    tables : mapping
        {p: {A: expression}}: where the amplitudes are found.
    """

    def __init__(self, *tables: Mapping[int, Any]) -> None:
        found: dict[sp.Symbol, None] = {}
        for table in tables:
            _check_orders(table)
            for part in table.values():
                found.update(dict.fromkeys(part))
        self.amplitudes = tuple(found)
        self.pairs = {a: sp.Dummy(f"{a}_bar") for a in found}
        self.variables = (*self.pairs, *self.pairs.values())

    def read(self, table: Mapping[int, Any], where: str) -> dict[int, dict[sp.Symbol, sp.Expr]]:
        """Check a table, and add the conjugate equations.

        Raises
        ------
        ConventionError
            Naming the amplitude or expression that does not belong.
        """
        _check_orders(table)
        bars = {sp.conjugate(a): bar for a, bar in self.pairs.items()}
        result = {}
        for p, part in table.items():
            read = {}
            for a, value in part.items():
                if a not in self.pairs:
                    known = ", ".join(map(str, self.amplitudes))
                    raise ConventionError(f"{where} names {a}, no amplitude here: use {known}")
                read[a] = exact(value, f"{where} of {a} at order {p}").xreplace(bars)
                turns = {e: sp.Dummy() for e in read[a].atoms(sp.exp) if e.has(sp.I)}
                if TIME in read[a].xreplace(turns).free_symbols:
                    raise ConventionError(f"{where} of {a} holds time other than in exp(I*sigma*t)")
                if strange := sorted(read[a].atoms(sp.conjugate), key=sp.default_sort_key):
                    raise ConventionError(
                        f"{where} of {a} holds {strange[0]}: all but amplitudes must be real"
                    )
            result[int(p)] = {**read, **self.bars(read)}
        return dict(sorted(result.items()))

    def bars(self, rates: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
        """The conjugate equations."""
        return {
            self.pairs[a]: conjugated(e, self.pairs) for a, e in rates.items() if a in self.pairs
        }

    def series(self, change: Mapping[int, Mapping[sp.Symbol, sp.Expr]]) -> dict[sp.Symbol, Graded]:
        """Every amplitude and conjugate as a series that begins with itself."""
        return {v: {0: v, **{p: h[v] for p, h in change.items() if v in h}} for v in self.variables}

    def mapped(
        self,
        table: Mapping[int, Mapping[sp.Symbol, sp.Expr]],
        values: Mapping[sp.Symbol, Graded],
        order: int,
    ) -> list[dict[sp.Symbol, sp.Expr]]:
        """Σ ε^p table_p with series in place of symbols: its parts of order 0 … `order`."""
        totals: list[dict[sp.Symbol, sp.Expr]] = [{} for _ in range(order + 1)]
        for p, part in table.items():
            for a in self.amplitudes:
                if p <= order and a in part:
                    for k, c in enumerate(composed(part[a], values, order - p)):
                        totals[p + k][a] = totals[p + k].get(a, sp.S.Zero) + c
        return totals

    def written(
        self, table: Mapping[int, Mapping[sp.Symbol, sp.Expr]]
    ) -> dict[int, dict[sp.Symbol, sp.Expr]]:
        """A table with conjugates in place of their symbols."""
        back = {bar: sp.conjugate(a) for a, bar in self.pairs.items()}
        return {
            p: {a: e.xreplace(back) for a, e in part.items() if a in self.pairs}
            for p, part in table.items()
        }


def _check_orders(table: object) -> None:
    if not isinstance(table, Mapping):
        raise ConventionError(f"a mapping order -> {{amplitude: expression}} is needed: {table!r}")
    graded(dict.fromkeys(table, 0), "a slow flow or change of amplitudes", least=1)
    for p, part in table.items():
        if not isinstance(part, Mapping) or not all(isinstance(a, sp.Symbol) for a in part):
            raise ConventionError(
                f"at order {p} a mapping amplitude -> expression is needed, got {part!r}"
            )
