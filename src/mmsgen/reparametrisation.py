"""Equations in other parameters: substitution, division, cancellation, and the proof of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

import sympy as sp

from .errors import ModelError
from .parameters import Parameter
from .terms import assemble, collect, motion, ratio, same, shortened
from .validation import as_expression, as_parameters, names

if TYPE_CHECKING:
    from .equations import EquationsOfMotion

__all__ = ["known_symbol", "reparametrised"]


def reparametrised(
    eom: EquationsOfMotion,
    mapping: Mapping[sp.Symbol | str, sp.Expr | int],
    parameters: Iterable[Parameter | sp.Symbol],
    eliminate: Iterable[sp.Symbol | str],
) -> tuple[list[sp.Expr], list[Parameter]]:
    """Equations in new parameters, each divided by the coefficient of its own acceleration.

    Parameters
    ----------
    eom : EquationsOfMotion
        The equations in the old parameters.
    mapping, parameters, eliminate
        As for `EquationsOfMotion.reparametrise`.

    Returns
    -------
    equations : list of sympy.Expr
        In canonical form: one fraction in lowest terms before every basis function.
    parameters : list of Parameter
        All that are known, whether they occur or not.

    Raises
    ------
    ModelError
        If an old parameter is unknown or survives, or a definition contradicts the mapping.
    """
    known = {p.name: p for p in eom.parameters}
    replaced: dict[sp.Symbol, sp.Expr] = {}
    for key, value in mapping.items():
        old = known_symbol(key, known)
        if old in replaced:
            raise ModelError(f"{old} is replaced twice: once as a symbol, once by name")
        replaced[old] = as_expression(value, f"the expression for {old}")
        if eom.time in replaced[old].free_symbols:
            raise ModelError(f"the expression for {old} depends on time: a parameter is constant")
    gone = set(replaced) | {known_symbol(key, known) for key in eliminate}
    # a symbol may be given a new meaning, such as k → k/m: then it is old and new at once
    gone -= {s for value in replaced.values() for s in value.free_symbols} & set(replaced)
    new = as_parameters(parameters)
    _check_consistent(replaced, new, eom)
    declared = _declared(eom, replaced, new)

    ratios: dict[sp.Expr, sp.Expr] = {}
    equations = []
    for q, equation in zip(eom.coordinates, eom.equations, strict=True):
        terms = collect(equation.xreplace(replaced), eom.time)
        inertia = _inertia(terms, q, eom.coordinates, eom.time)
        for basis, coefficient in terms.items():
            quotient = coefficient / inertia
            if quotient not in ratios:
                ratios[quotient] = ratio(quotient)
            terms[basis] = ratios[quotient]
        left = assemble({basis: c for basis, c in terms.items() if c != 0})
        survivors = gone & left.free_symbols
        if survivors:
            raise ModelError(
                f"{names(survivors)} did not cancel from the equation of {q}: it still reads "
                f"{shortened(left)} = 0. Replace what is left, or keep the parameter"
            )
        equations.append(left)
    return equations, declared


def known_symbol(key: sp.Symbol | str, known: dict[str, Parameter]) -> sp.Symbol:
    """The symbol of a parameter given as a symbol or by name.

    Raises
    ------
    ModelError
        If there is none, or one with other assumptions.
    """
    name = key if isinstance(key, str) else getattr(key, "name", str(key))
    if name not in known or (isinstance(key, sp.Basic) and key != known[name].symbol):
        raise ModelError(
            f"{key} is no parameter of these equations: they have {', '.join(known) or 'none'}"
        )
    return known[name].symbol


def _declared(
    eom: EquationsOfMotion, replaced: dict[sp.Symbol, sp.Expr], new: tuple[Parameter, ...]
) -> list[Parameter]:
    """Old parameters, then the new ones as given, then the undeclared ones by name."""
    given = {p.name: p for p in new}
    result = [given.pop(p.name, p) for p in eom.parameters]
    result += given.values()
    used = {s for value in replaced.values() for s in value.free_symbols}
    # symbols that only differ in their assumptions are caught as two parameters with one name
    undeclared = used - {p.symbol for p in result}
    result += [Parameter(s) for s in sorted(undeclared, key=sp.default_sort_key)]
    as_parameters(result)
    fresh = {p.symbol for p in new}
    return [p if p.symbol in fresh else _redefined(p, replaced) for p in result]


def _redefined(parameter: Parameter, replaced: dict[sp.Symbol, sp.Expr]) -> Parameter:
    """Write the definition of a parameter from an earlier step in the new parameters."""
    if parameter.definition is None or parameter.definition.free_symbols.isdisjoint(replaced):
        return parameter
    definition = ratio(parameter.definition.xreplace(replaced))
    return Parameter(parameter.symbol, parameter.unit, parameter.meaning, definition)


def _check_consistent(
    replaced: dict[sp.Symbol, sp.Expr], new: tuple[Parameter, ...], eom: EquationsOfMotion
) -> None:
    """Definitions and mapping are inverse to each other, in both directions."""
    earlier = {p.symbol: p.definition for p in eom.parameters}
    defined = {p.symbol: p.definition for p in new if p.definition is not None}
    for symbol, definition in defined.items():
        if symbol in earlier:
            if definition != earlier[symbol]:
                raise ModelError(f"{symbol} is in use already: define a symbol with a new name")
            continue
        result = _in_old_terms(definition, defined).xreplace(replaced)
        if not same(result, symbol):
            raise ModelError(
                f"the definition {symbol} = {definition} is not the inverse of the mapping, with "
                f"which it becomes {ratio(result)}: correct one of the two"
            )
    for old, value in replaced.items():
        back = _in_old_terms(value, defined)
        closed = back.free_symbols <= set(earlier)
        if closed and not value.free_symbols.isdisjoint(defined) and not same(back, old):
            raise ModelError(
                f"{old} is replaced by {value}, which by definition is {ratio(back)} and not "
                f"{old}: correct one of the two"
            )


def _in_old_terms(expr: sp.Expr, defined: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Replace defined symbols, also within definitions, as deep as there are definitions."""
    for _ in defined:
        expr = expr.xreplace(defined)
    return expr


def _inertia(
    terms: dict[sp.Expr, sp.Expr], q: sp.Expr, coordinates: tuple[sp.Expr, ...], time: sp.Symbol
) -> sp.Expr:
    """Coefficient of an equation's own acceleration at rest; 1 where it is no constant."""
    acceleration = motion(q, time)[2]
    plain = sp.Symbol("acceleration")
    rest = {function: sp.S.Zero for c in coordinates for function in motion(c, time)}
    rest[acceleration] = plain
    total = sp.S.Zero
    for basis, coefficient in terms.items():
        if acceleration == basis:
            total += coefficient
        elif basis.has(acceleration):
            slope = basis.xreplace(rest).diff(plain).xreplace({plain: sp.S.Zero})
            total += coefficient * slope
    total = ratio(total)
    varies = time in total.free_symbols or total.has(sp.nan, sp.zoo, sp.oo, -sp.oo)
    return sp.S.One if varies or total == 0 else total
