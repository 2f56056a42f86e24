"""Resonance relations as the user writes them, solved for the frequencies that they detune.

A relation {kΩ: form} means kΩ = form + εσ. Several relations are solved one after the other in
exact rational arithmetic, so that each eliminates one frequency symbol of its own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from .alphabet import fraction
from .errors import ResonanceError
from .grading import Detuned
from .symbols import detuning

__all__ = ["Relation", "solve_relations"]

LinearForm = dict[str, Fraction]


@dataclass(frozen=True)
class Relation:
    """One resonance relation, lhs = rhs + ε·detuning.

    Attributes
    ----------
    lhs, rhs : sympy.Expr
        A multiple of one frequency symbol, and a linear form in the others.
    detuning : sympy.Symbol
        In the unit of the frequencies.
    """

    lhs: sp.Expr
    rhs: sp.Expr
    detuning: sp.Symbol

    @property
    def equation(self) -> sp.Eq:
        """lhs = rhs, at exact resonance."""
        return sp.Eq(self.lhs, self.rhs, evaluate=False)


def _expression(side: object) -> sp.Expr:
    """One side of a relation; text is refused, because SymPy would execute it."""
    try:
        expression = sp.sympify(side, strict=True)
    except sp.SympifyError:
        expression = None
    if not isinstance(expression, sp.Expr):
        raise ResonanceError(
            f"a relation contains {side!r}, which is no expression: write frequency symbols and "
            "numbers like {Omega: omega_1 + omega_2}; text is not evaluated"
        )
    return expression


def _pairs(resonance: object) -> list[tuple[sp.Expr, sp.Expr]]:
    """Both sides of every relation."""
    if resonance is None:
        return []
    if not isinstance(resonance, Mapping):
        raise ResonanceError(
            f"relations are written as a mapping like {{Omega: omega_1 + omega_2}}, got "
            f"{resonance!r}; a Resonance of a table has it as .mapping"
        )
    return [(_expression(lhs), _expression(rhs)) for lhs, rhs in resonance.items()]


def _linear_form(expression: sp.Expr, frequencies: Sequence[sp.Symbol]) -> LinearForm:
    form: LinearForm = {}
    for term, c in sp.expand(expression).as_coefficients_dict().items():
        if not c.is_Rational or not (term == 1 or term.is_Symbol):
            raise ResonanceError(
                f"{expression} is not a rational combination of frequencies (offending part: "
                f"{c * term}); write relations like {{Omega: omega_1 + omega_2}}"
            )
        if term != 1 and term not in frequencies:
            known = ", ".join(str(f) for f in frequencies) or "none"
            if str(term) in known.split(", "):
                raise ResonanceError(
                    f"{term} in the relation is another symbol than the {term} of the equations, "
                    "which is positive: use one and the same symbol object"
                )
            raise ResonanceError(
                f"{term} in the relation is no frequency of this system; its frequencies: {known}"
            )
        form["1" if term == 1 else str(term.name)] = fraction(c)
    return {name: c for name, c in form.items() if c}


def _substitute(form: LinearForm, name: str, value: LinearForm) -> LinearForm:
    """`form` with the symbol `name` replaced."""
    factor = form.get(name)
    if factor is None:
        return form
    result = {k: c for k, c in form.items() if k != name}
    for k, c in value.items():
        result[k] = result.get(k, Fraction(0)) + factor * c
    return {k: c for k, c in result.items() if c}


def solve_relations(
    resonance: Mapping[sp.Expr, sp.Expr] | None,
    frequencies: Sequence[sp.Symbol],
    taken: frozenset[str],
) -> tuple[tuple[Relation, ...], dict[str, Detuned]]:
    """Read and solve a set of simultaneous resonance relations.

    Parameters
    ----------
    resonance : mapping or None
        ``{Omega: omega_1 + omega_2, ...}``; the left side a multiple of one frequency symbol.
    frequencies : sequence of sympy.Symbol
        The frequency symbols of the system.
    taken : frozenset of str
        Names of parameters, which a detuning may not have.

    Returns
    -------
    relations : tuple of Relation
    detuned : dict
        For every eliminated frequency symbol its resonant value and its detuning.

    Raises
    ------
    ResonanceError
        If a relation names what is no frequency, contradicts another, follows from the others, or
        leaves no frequency to detune.
    """
    pairs = _pairs(resonance)
    relations: list[Relation] = []
    solved: dict[str, LinearForm] = {}
    for index, (lhs, rhs) in enumerate(pairs):
        sigma = detuning(index, len(pairs))
        if sigma.name in taken:
            raise ResonanceError(f"the parameter {sigma} has the name of a detuning: rename it")
        pivot, value = _solved(lhs, rhs, sigma, frequencies, solved)
        solved = {name: _substitute(form, pivot, value) for name, form in solved.items()}
        solved[pivot] = value
        relations.append(Relation(lhs, rhs, sigma))
    sigmas = [str(r.detuning.name) for r in relations]
    detuned = {
        name: Detuned(
            {k: c for k, c in form.items() if k not in sigmas},
            {k: c for k, c in form.items() if k in sigmas},
        )
        for name, form in solved.items()
    }
    for name, fixed in detuned.items():
        if not any(c > 0 for c in fixed.resonant.values()):
            raise ResonanceError(
                f"the relations leave {name} = {_show(fixed.resonant)} on resonance, which is not "
                "positive: they contradict each other"
            )
    return tuple(relations), detuned


def _solved(
    lhs: sp.Expr,
    rhs: sp.Expr,
    sigma: sp.Symbol,
    frequencies: Sequence[sp.Symbol],
    known: Mapping[str, LinearForm],
) -> tuple[str, LinearForm]:
    """The frequency that a relation detunes, and its value, those of other relations put in."""
    left_form = _linear_form(lhs, frequencies)
    if len(left_form) != 1 or "1" in left_form:
        raise ResonanceError(
            f"the left side {lhs} of a relation must be a multiple of the one frequency symbol "
            "that is detuned; it leaves no frequency to detune"
        )
    ((pivot, factor),) = left_form.items()
    if pivot in known:
        raise ResonanceError(
            f"{pivot} is already fixed by another relation: write the second one for another "
            "frequency"
        )
    difference = dict(_linear_form(rhs, frequencies))
    difference[pivot] = difference.get(pivot, Fraction(0)) - factor
    difference[sigma.name] = Fraction(1)
    for name, value in known.items():
        difference = _substitute(difference, name, value)
    slope = difference.pop(pivot, Fraction(0))
    if not slope:
        raise ResonanceError(
            f"the relation {lhs} = {rhs} contradicts the others or follows from them, and "
            f"leaves no frequency to detune"
        )
    return pivot, {name: -c / slope for name, c in difference.items() if c}


def _show(form: Mapping[str, Fraction]) -> str:
    return " + ".join(f"{c}*{name}" for name, c in form.items()) or "0"
