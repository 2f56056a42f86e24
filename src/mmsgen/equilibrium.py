"""`Equilibrium`: a point at which a system stays at rest, found in closed form and checked.

At an equilibrium the equations hold with q constant, once the parameters that excite the system
are zero.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy as sp

from .algebraic import Algebra
from .errors import EquilibriumError
from .reparametrisation import known_symbol
from .terms import motion
from .validation import TIME, names

if TYPE_CHECKING:
    from .equations import EquationsOfMotion

__all__ = ["Equilibrium", "at_rest", "check_finite", "equilibria", "neglected"]

_NOT_FINITE = (sp.nan, sp.zoo, sp.oo, -sp.oo)


@dataclass(frozen=True)
class Equilibrium:
    """A point at which a system stays at rest.

    Attributes
    ----------
    values : mapping of coordinate to sympy.Expr
        q_e in closed form.
    static : tuple of sympy.Expr
        The static equations with these values inserted, as they stand.
    proven : bool
        True where exact algebra shows that they are all zero; False where that is undecided.
    stiffness : sympy.ImmutableDenseMatrix
        Derivatives of the static equations by the coordinates, at the equilibrium.
    """

    values: Mapping[sp.Expr, sp.Expr]
    static: tuple[sp.Expr, ...]
    proven: bool
    stiffness: sp.ImmutableDenseMatrix

    def _repr_latex_(self) -> str:
        from sympy.physics.vector.printing import vlatex

        rows = [f"{vlatex(q)} &= {vlatex(value)}" for q, value in self.values.items()]
        lines = r" \\ ".join([*rows, f"K &= {vlatex(self.stiffness)}"])
        return rf"$\displaystyle \begin{{aligned}} {lines} \end{{aligned}}$"


def equilibria(
    eom: EquationsOfMotion, neglecting: Iterable[sp.Symbol | str] = ()
) -> tuple[Equilibrium, ...]:
    """Find equilibria in closed form.

    Parameters
    ----------
    eom : EquationsOfMotion
    neglecting : iterable of symbols or names
        As for `EquationsOfMotion.equilibria`.

    Raises
    ------
    EquilibriumError
        As for `EquationsOfMotion.equilibria`.
    """
    without = neglected(eom, neglecting)
    unknowns = {q: sp.Dummy(str(q.func), real=True) for q in eom.coordinates}
    sides = [at_rest(equation, eom, unknowns).xreplace(without) for equation in eom.equations]
    for q, side in zip(eom.coordinates, sides, strict=True):
        check_finite(side, q)
        if TIME in side.free_symbols:
            acting = side.free_symbols - set(unknowns.values()) - {TIME}
            raise EquilibriumError(
                f"at rest the equation of {q} still depends on time: name the parameters of the "
                f"excitation in neglecting=[...]; in it are {names(acting) or 'none'}"
            )
    found: dict[tuple[sp.Expr, ...], Equilibrium] = {}
    for solution in _solutions(sides, list(unknowns.values()), eom):
        values = tuple(solution[u] for u in unknowns.values())
        if any(v.is_real is False or v.has(sp.I) for v in values):
            continue
        for candidate in (tuple(map(_within_one_turn, values)), values):
            point = dict(zip(unknowns.values(), candidate, strict=True))
            if record := _record(point, unknowns, sides):
                found[candidate] = record
                break
    if not found:
        shown = ", ".join(f"{s} = 0" for s in sides)
        raise EquilibriumError(
            f"the static equations {shown} have no real solution in closed form that was found. "
            "Where there is one, give it a symbol, and eliminate a parameter by its equation: "
            "about({q: q_0}, eliminate={parameter: expression in q_0})"
        )
    return tuple(found[v] for v in sorted(found, key=lambda v: [sp.default_sort_key(e) for e in v]))


def _solutions(
    sides: list[sp.Expr], unknowns: list[sp.Symbol], eom: EquationsOfMotion
) -> list[dict[sp.Symbol, sp.Expr]]:
    factored = [_factored(s, unknowns) for s in sides if s != 0]
    try:
        solutions = sp.solve(factored, unknowns, dict=True) if factored else [{}]
    except NotImplementedError:
        return []
    for solution in solutions:
        loose = [
            q
            for q, u in zip(eom.coordinates, unknowns, strict=True)
            if u not in solution or solution[u].free_symbols & set(unknowns)
        ]
        if loose:
            raise EquilibriumError(
                f"the equilibria are not isolated: {names(loose)} may have any value, so nothing "
                "restores it"
            )
    return list(solutions)


def _factored(side: sp.Expr, unknowns: list[sp.Symbol]) -> sp.Expr:
    """A side as a product where it is one: sin θ (g − RΩ² cos θ) is zero at π too."""
    product = sp.factor(sp.expand_trig(side))
    moving = [f for f in sp.Mul.make_args(product) if f.free_symbols & set(unknowns)]
    return product if len(moving) > 1 else side


def _within_one_turn(value: sp.Expr) -> sp.Expr:
    """An angle from −π, left out, to π."""
    turns = sp.expand(value).coeff(sp.pi) / 2
    if not turns.is_Rational:
        return value
    return sp.expand(value) - 2 * sp.pi * sp.ceiling(turns - sp.Rational(1, 2))


def _record(
    values: dict[sp.Symbol, sp.Expr], unknowns: Mapping[sp.Expr, sp.Symbol], sides: list[sp.Expr]
) -> Equilibrium | None:
    """A candidate with its check; None where it is proven to be no equilibrium."""
    static = [s.xreplace(values) for s in sides]
    if any(s.has(*_NOT_FINITE) for s in static):
        return None
    algebra = Algebra((), static)
    verdicts = [algebra.vanishes(s) for s in static]
    if False in verdicts:
        return None
    slopes = [s.diff(u).xreplace(values) for s in sides for u in unknowns.values()]
    algebra = Algebra((), slopes)
    try:
        entries = [algebra.shown(algebra.reduced(e)) for e in slopes]
    except ZeroDivisionError:
        return None
    stiffness = sp.ImmutableDenseMatrix(len(sides), len(sides), entries)
    points = {q: values[u] for q, u in unknowns.items()}
    return Equilibrium(points, tuple(static), None not in verdicts, stiffness)


def neglected(
    eom: EquationsOfMotion, neglecting: Iterable[sp.Symbol | str]
) -> dict[sp.Symbol, sp.Expr]:
    """Zero for each parameter that is neglected.

    Raises
    ------
    ModelError
        If one is unknown.
    """
    if isinstance(neglecting, str | sp.Basic):
        raise EquilibriumError(f"neglecting must be a list of parameters, got {neglecting!r}")
    known = {p.name: p for p in eom.parameters}
    return {known_symbol(key, known): sp.S.Zero for key in neglecting}


def at_rest(expr: sp.Expr, eom: EquationsOfMotion, positions: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    """An expression without motion at the given positions."""
    rates = {f: sp.S.Zero for q in eom.coordinates for f in motion(q, TIME)[1:]}
    return expr.xreplace(rates).xreplace(dict(positions))


def check_finite(side: sp.Expr, q: sp.Expr) -> None:
    """Refuse a static equation that is singular.

    Raises
    ------
    EquilibriumError
        Naming the coordinate.
    """
    if side.has(*_NOT_FINITE):
        raise EquilibriumError(
            f"the equation of {q} is singular there: it has no expansion, and it is no equilibrium"
        )
