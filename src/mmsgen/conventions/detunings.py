"""Detunings and other symbols as series in ε."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import sympy as sp

from ..errors import ConventionError
from .graded import Amplitudes, Graded, composed, exact, graded, tidy

if TYPE_CHECKING:
    from ..expansion import Expansion

__all__ = ["detuned", "substituted"]


def substituted(series: Mapping[int, Any], values: Mapping[sp.Symbol, Any]) -> dict[int, Any]:
    """A slow flow or series in which symbols have become series in ε, truncated at its order.

    Parameters
    ----------
    series : mapping
        {p: expression} or {p: {A: expression}}.
    values : mapping
        Symbol → an expression that is exact, or a series {p: expression} that is known through its
        highest order. All are inserted at once.

    Raises
    ------
    ConventionError
        If a series is not known to the order that is needed, or has no expansion.
    """
    if not isinstance(values, Mapping) or not all(isinstance(s, sp.Symbol) for s in values):
        raise ConventionError(f"values are written as a mapping symbol -> series, got {values!r}")
    nested = bool(series) and all(isinstance(v, Mapping) for v in series.values())
    if not nested:
        plain = {p: {None: c} for p, c in graded(series, "the series").items()}
        return {p: c[None] for p, c in _inserted(plain, values, ()).items()}
    state = Amplitudes(series)
    if among := [s for s in values if s in state.pairs]:
        raise ConventionError(f"{among[0]} is an amplitude: it is replaced by changed or rescaled")
    read = state.read(series, "the slow flow")
    parts = {p: {a: g[a] for a in state.amplitudes if a in g} for p, g in read.items()}
    return state.written(_inserted(parts, values, state.variables))


def detuned(
    case: Expansion, symbol: sp.Symbol, detuning: sp.Symbol, exponent: int = 2
) -> dict[sp.Symbol, Graded]:
    """Another detuning of a resonance, ω^n = ω_res^n + ε·detuning, for `substituted`.

    Here kΩ = Ω_res + εσ. With the excitation's frequency as `symbol` and n = 2 the result is for
    Ω² = Ω_res² + ε·detuning; with a natural frequency, for ω² = ω_res² + ε·detuning, where ω_res is
    the value at which the resonance holds exactly, such as Ω/2 (the form in which Mathieu's
    equation is tabulated, DLMF 28). σ follows from ω − ω_res = Σ_p binom(1/n, p) ω_res^{1−np} ε^p.

    Parameters
    ----------
    case : Expansion
    symbol : sympy.Symbol
        A frequency of just one relation of the case.
    detuning : sympy.Symbol
        The new one; in its sign too.
    exponent : int
        n, 1 or 2 as a rule.

    Returns
    -------
    dict
        {σ: series, symbol: series}.

    Raises
    ------
    ConventionError
        If the symbol is in no relation, or in several.
    """
    relations = [r for r in case.relations if symbol in (r.lhs - r.rhs).free_symbols]
    if len(relations) != 1:
        count = "several relations" if relations else "no relation"
        raise ConventionError(f"{symbol} is in {count} of this case: it cannot be detuned alone")
    if exact(exponent, "the exponent").is_Integer is not True or exponent < 1:
        raise ConventionError(f"the exponent must be a whole number >= 1, got {exponent!r}")
    gap = sp.expand(relations[0].lhs - relations[0].rhs)
    slope = gap.coeff(symbol)
    resonant = sp.cancel(symbol - gap / slope)

    def part(p: int) -> sp.Expr:
        number = sp.binomial(sp.Rational(1, exponent), p)
        return number * detuning**p * resonant ** (1 - exponent * p)

    parts = {p: part(p) for p in range(1, case.order + 2)}
    sigma = {p - 1: slope * c for p, c in parts.items()}
    return {relations[0].detuning: sigma, symbol: {0: resonant, **parts}}


def _inserted(
    parts: Mapping[int, Mapping[Any, sp.Expr]],
    values: Mapping[sp.Symbol, Any],
    variables: tuple[sp.Symbol, ...],
) -> dict[int, dict[Any, sp.Expr]]:
    """Series in place of symbols, collected by orders."""
    order = max(parts)
    table = {
        s: graded(v, f"the series for {s}")
        if isinstance(v, Mapping)
        else {0: exact(v, f"the expression for {s}")}
        for s, v in values.items()
    }
    for s, v in values.items():
        first = [p for p, part in parts.items() if any(s in e.free_symbols for e in part.values())]
        needed = order - min(first, default=order)
        if isinstance(v, Mapping) and max(table[s]) < needed:
            raise ConventionError(
                f"the series for {s} is known to order {max(table[s])}, and order {needed} is "
                "needed: give more terms, or zeros where it ends"
            )
    totals: dict[int, dict[Any, list[sp.Expr]]] = {p: {} for p in range(min(parts), order + 1)}
    for p, part in parts.items():
        for a, expr in part.items():
            for k, c in enumerate(composed(expr, table, order - p)):
                totals[p + k].setdefault(a, []).append(c)
    return {
        p: {a: tidy(sp.Add(*cs), variables) for a, cs in part.items()} for p, part in totals.items()
    }
