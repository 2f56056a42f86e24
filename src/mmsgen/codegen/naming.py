"""Names of emitted modules, deterministic identifiers made from resonance relations."""

from __future__ import annotations

import keyword
import unicodedata
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

import sympy as sp

from ..errors import EmissionError

if TYPE_CHECKING:
    from ..expansion import Expansion
    from ..relations import Relation

__all__ = ["case_name", "check_module_name", "check_parameter_names", "relation_text"]

_WORDS = ("", "", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


def case_name(case: Expansion) -> str:
    """The module name of a case, such as ``Omega_is_omega_x_plus_omega_phi_order_1``."""
    frequencies = case.weak.scaled.frequencies
    relations = "_and_".join(
        f"{_side(r.lhs, frequencies)}_is_{_side(r.rhs, frequencies)}" for r in case.relations
    )
    return f"{relations or 'nonresonant'}_order_{case.order}"


def relation_text(relation: Relation, frequencies: Sequence[sp.Symbol]) -> str:
    """A relation with its detuning, its terms in the order of the coordinates."""
    terms = [*_terms(relation.rhs, frequencies), (Fraction(1), str(relation.detuning.name))]
    right = "".join(_signed(c, name, first=k == 0) for k, (c, name) in enumerate(terms))
    ((c, name),) = _terms(relation.lhs, frequencies)
    return f"{_signed(c, name, first=True)} = {right}"


def _signed(c: Fraction, name: str, *, first: bool) -> str:
    sign = ("-" if c < 0 else "") if first else (" - " if c < 0 else " + ")
    size = abs(c)
    if not name:
        return f"{sign}{size}"
    return f"{sign}{name}" if size == 1 else f"{sign}{size}*{name}"


def _terms(side: sp.Expr, frequencies: Sequence[sp.Symbol]) -> list[tuple[Fraction, str]]:
    """(coefficient, name), positive terms first, each in the order of the frequencies."""
    known = sp.Poly(side, *frequencies)
    terms = []
    for symbol in (*frequencies, sp.Integer(1)):
        c = known.coeff_monomial(symbol)
        if c != 0:
            terms.append((Fraction(int(c.p), int(c.q)), "" if symbol == 1 else str(symbol.name)))
    return sorted(terms, key=lambda term: term[0] < 0)


def _side(side: sp.Expr, frequencies: Sequence[sp.Symbol]) -> str:
    parts = []
    for k, (c, name) in enumerate(_terms(side, frequencies)):
        joint = ("minus_" if c < 0 else "") if k == 0 else ("_minus_" if c < 0 else "_plus_")
        parts.append(joint + _multiple(abs(c), _identifier(name)))
    return "".join(parts)


def _multiple(c: Fraction, name: str) -> str:
    p = c.numerator
    word = _WORDS[p] if p < len(_WORDS) else f"times_{p}"
    if not name:
        word = word or "one"
    over = f"over_{c.denominator}" if c.denominator > 1 else ""
    return "_".join(part for part in (word, name, over) if part)


def _identifier(name: str) -> str:
    """Letters, digits and underscores of a name."""
    normal = unicodedata.normalize("NFKC", name)
    return "".join(ch if ("_" + ch).isidentifier() else "_" for ch in normal)


def check_module_name(name: str, what: str) -> None:
    """Refuse a package or model name that cannot be imported.

    Raises
    ------
    EmissionError
    """
    usable = isinstance(name, str) and name.isidentifier() and not keyword.iskeyword(name)
    if not usable or name.startswith("_"):
        raise EmissionError(
            f"the {what} name {name!r} cannot be imported: use letters, digits and underscores, "
            "beginning with a letter"
        )


def check_parameter_names(names: Iterable[str]) -> None:
    """Refuse parameters that cannot be keyword arguments.

    Raises
    ------
    EmissionError
    """
    for name in names:
        plain = name.isidentifier() and name == unicodedata.normalize("NFKC", name)
        if not plain or keyword.iskeyword(name):
            raise EmissionError(
                f"the parameter {name!r} cannot be a keyword argument of an emitted function: "
                "rename its symbol with letters, digits and underscores, and no Python keyword"
            )
