"""Coordinates measured from an equilibrium: q = q_e + (new) q, under the same symbol.

That the point is an equilibrium is proven before anything else is done. Sines and cosines of it,
and radicals, are brought into one normal form, rational in the symbols that name them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

import sympy as sp
from sympy.core.function import AppliedUndef

from .algebraic import Algebra, quotients
from .equilibrium import Equilibrium, at_rest, check_finite, neglected
from .errors import EquilibriumError
from .parameters import Parameter
from .reparametrisation import known_symbol, reparametrised
from .terms import assemble, collect, shortened
from .validation import TIME, as_expression, as_parameters, check_coordinates

if TYPE_CHECKING:
    from .equations import EquationsOfMotion

__all__ = ["about"]


def about(
    eom: EquationsOfMotion,
    equilibrium: Equilibrium | Mapping[sp.Expr, sp.Expr | int],
    eliminate: Mapping[sp.Symbol | str, sp.Expr | int],
    parameters: Iterable[Parameter | sp.Symbol],
    neglecting: Iterable[sp.Symbol | str],
) -> tuple[list[sp.Expr], list[Parameter]]:
    """Measure the coordinates from an equilibrium.

    Parameters
    ----------
    eom : EquationsOfMotion
    equilibrium, eliminate, parameters, neglecting
        As for `EquationsOfMotion.about`.

    Returns
    -------
    equations : list of sympy.Expr
    parameters : list of Parameter
        All that are known, whether they occur or not.

    Raises
    ------
    EquilibriumError, ModelError
        As for `EquationsOfMotion.about`.
    """
    values = _values(eom, equilibrium)
    if not isinstance(eliminate, Mapping):
        raise EquilibriumError(
            f"eliminate is written as a mapping parameter -> expression, got {eliminate!r}"
        )
    without = neglected(eom, neglecting)
    given = as_parameters(parameters)
    known = {p.name: p for p in eom.parameters}
    gone = {known_symbol(key, known) for key in eliminate}
    named = [p for p in given if _is_name(p, gone)]
    plain = [Parameter(p.symbol, p.unit, p.meaning) if p in named else p for p in given]
    replaced = {
        known_symbol(k, known): as_expression(v, f"the expression for {k}")
        for k, v in eliminate.items()
    }
    algebra = Algebra(named, replaced.values())
    try:
        replaced = {k: algebra.shown(algebra.reduced(v)) for k, v in replaced.items()}
    except ZeroDivisionError:
        raise EquilibriumError("a denominator in eliminate={...} is zero") from None
    equations, declared = list(eom.equations), list(_merged(eom.parameters, plain))
    if replaced:
        equations, declared = reparametrised(eom, replaced, plain, ())
    used = {s for v in (*values.values(), *(p.definition for p in named)) for s in v.free_symbols}
    strangers = used - {p.symbol for p in declared}
    declared += [Parameter(s) for s in sorted(strangers, key=sp.default_sort_key)]
    definitions = {p.symbol: p for p in named}
    declared = [definitions.get(p.symbol, p) for p in declared]
    check_coordinates(eom.coordinates, declared)
    shift = _Shift({q: v.xreplace(replaced) for q, v in values.items()}, named)
    result = []
    for q, equation in zip(eom.coordinates, equations, strict=True):
        moved = shift(equation)
        _check_static(
            at_rest(moved, eom, dict.fromkeys(eom.coordinates, sp.S.Zero)), q, shift, without
        )
        result.append(shift.tidied(moved))
    return result, declared


def _merged(old: Iterable[Parameter], new: Iterable[Parameter]) -> tuple[Parameter, ...]:
    table = {p.name: p for p in new}
    return as_parameters([*(table.pop(p.name, p) for p in old), *table.values()])


def _values(
    eom: EquationsOfMotion, equilibrium: Equilibrium | Mapping[sp.Expr, sp.Expr | int]
) -> dict[sp.Expr, sp.Expr]:
    if isinstance(equilibrium, Equilibrium):
        equilibrium = equilibrium.values
    if not isinstance(equilibrium, Mapping):
        raise EquilibriumError(
            f"an equilibrium is written as a mapping coordinate -> value, got {equilibrium!r}"
        )
    values = {}
    for q, value in equilibrium.items():
        if q not in eom.coordinates:
            known = ", ".join(map(str, eom.coordinates))
            raise EquilibriumError(f"{q} is no coordinate: an equilibrium has values of {known}")
        values[q] = as_expression(value, f"the equilibrium of {q}")
        if values[q].has(AppliedUndef, sp.Derivative) or TIME in values[q].free_symbols:
            raise EquilibriumError(
                f"the equilibrium of {q} is {value}, which is not constant: write it in parameters"
            )
    return values


def _is_name(parameter: Parameter, gone: set[sp.Symbol]) -> bool:
    """Whether a parameter stands for a function or radical of those that remain."""
    definition = parameter.definition
    if definition is None or definition.free_symbols & gone:
        return False
    powers = definition.as_powers_dict().items()
    if isinstance(definition, sp.Function) or any(not e.is_Integer for _, e in powers):
        return True
    raise EquilibriumError(
        f"{parameter.symbol} = {definition} is neither a function nor a radical of parameters that "
        "remain: bring it in by eliminate={old parameter: expression with it}"
    )


class _Shift:
    """Coordinates measured from an equilibrium, in expressions."""

    def __init__(self, values: Mapping[sp.Expr, sp.Expr], named: list[Parameter]) -> None:
        self.values = {q: v for q, v in values.items() if v != 0}
        self.named = named
        self._constants: dict[sp.Symbol, sp.Expr] = {}  # sines and cosines at the equilibrium
        self._angles: set[sp.Expr] = set()

    def _moves(self, node: sp.Basic) -> bool:
        if node in self.values:
            return True
        return not isinstance(node, sp.Derivative) and any(self._moves(a) for a in node.args)

    def __call__(self, node: sp.Expr) -> sp.Expr:
        """Replace q by q_e + q; sines and cosines of q_e are split off."""
        if node in self.values:
            return self.values[node] + node
        if not self._moves(node):
            return node
        if (written := quotients(node)) != node:
            return self(written)
        args = [self(arg) for arg in node.args]
        if isinstance(node, sp.cos | sp.sin):
            return self._split(node, sp.expand(args[0]))
        if isinstance(node, sp.Pow) and not (node.exp.is_Integer and node.exp > 0):
            args[0] = self.tidied(args[0])
        elif isinstance(node, sp.Function):
            args = [self.tidied(arg) for arg in args]
        result: sp.Expr = node.func(*args)
        return result

    def _split(self, node: sp.Expr, angle: sp.Expr) -> sp.Expr:
        """The sine or cosine of a sum of a constant angle and the rest."""

        def constant(expr: sp.Expr) -> sp.Expr:
            terms = sp.Add.make_args(sp.expand(expr))
            return sp.Add(*(term for term in terms if TIME not in term.free_symbols))

        fixed = constant(angle) - constant(node.args[0])
        rest = angle - fixed
        self._angles |= {term.as_coeff_Mul()[1] for term in sp.Add.make_args(fixed)}
        c, s = self._constant(sp.cos(fixed)), self._constant(sp.sin(fixed))
        if isinstance(node, sp.cos):
            return c * sp.cos(rest) - s * sp.sin(rest)
        return s * sp.cos(rest) + c * sp.sin(rest)

    def _constant(self, value: sp.Expr) -> sp.Expr:
        """A symbol in place of a constant, so that it is not multiplied into other sines."""
        if value.is_Rational:
            return value
        for symbol, known in self._constants.items():
            if known == value:
                return symbol
        symbol = sp.Dummy(str(value), real=True)
        self._constants[symbol] = value
        return symbol

    def written(self, coefficient: sp.Expr) -> sp.Expr:
        """A coefficient with the constants in their places."""
        return coefficient.xreplace(self._constants)

    def tidied(self, expr: sp.Expr) -> sp.Expr:
        """Like terms collected, each coefficient in normal form and rational in the names."""
        terms = {b: self.written(c) for b, c in collect(expr, TIME).items()}
        algebra = Algebra(self.named, terms.values())
        for function in algebra.written.values():
            if isinstance(function, sp.cos | sp.sin) and function.args[0].has(*self._angles):
                raise EquilibriumError(
                    f"the equations about the equilibrium contain {function}: give it a name, by "
                    f"parameters=[Parameter(symbol, '1', meaning, definition={function})], so "
                    "that coefficients are rational in the parameters"
                )
        try:
            normal = {b: algebra.shown(algebra.reduced(c)) for b, c in terms.items()}
        except ZeroDivisionError:
            raise EquilibriumError(
                f"a denominator of {shortened(expr)} is zero at the equilibrium: the equations "
                "have no expansion there"
            ) from None
        return assemble({b: c for b, c in normal.items() if c != 0})


def _check_static(
    side: sp.Expr, q: sp.Expr, shift: _Shift, without: Mapping[sp.Symbol, sp.Expr]
) -> None:
    """Refuse a point that is no equilibrium, or that is not known to be one."""
    check_finite(side, q)
    constant = collect(side, TIME).get(sp.S.One, sp.S.Zero)
    force = shift.written(constant).xreplace(dict(without))
    check_finite(force, q)
    verdict = Algebra(shift.named, [force]).vanishes(force)
    if verdict:
        return
    point = ", ".join(f"{p} = {v}" for p, v in shift.values.items()) or "the origin"
    if verdict is None:
        raise EquilibriumError(
            f"whether {point} is an equilibrium cannot be decided exactly: in the equation of {q} "
            f"it must be zero that {shortened(force)}. Give the equilibrium a symbol, and eliminate"
            " a parameter by its equation: about({q: q_0}, eliminate={parameter: expression})"
        )
    raise EquilibriumError(
        f"{point} is no equilibrium: in the equation of {q} the force {shortened(-force)} remains "
        "at rest. .equilibria() looks for one; a small constant force is named in neglecting=[...]"
    )
