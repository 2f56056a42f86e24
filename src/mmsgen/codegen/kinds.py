"""What kind of resonance a case is, looked up in the table of its system's resonances."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import sympy as sp

from ..errors import MmsgenError
from .setting import Setting

if TYPE_CHECKING:
    from ..relations import Relation
    from ..resonance import Resonance

__all__ = ["kinds_of"]


def kinds_of(settings: Sequence[Setting]) -> dict[str, tuple[str, tuple[str, ...]]]:
    """The kind of each case and the coordinates that its resonances couple, by case name."""
    tables: dict[tuple[int, int], tuple[Resonance, ...]] = {}
    result = {}
    for setting in settings:
        found = [_found(setting, relation, tables) for relation in setting.case.relations]
        names = [r.kind if r is not None else "as given" for r in found]
        coupled = {q for r in found for q in (setting.coordinates if r is None else r.coordinates)}
        chosen = tuple(q for q in setting.coordinates if q in coupled or not found)
        result[setting.name] = " and ".join(names) or "nonresonant", chosen
    return result


def _found(
    setting: Setting, relation: Relation, tables: dict[tuple[int, int], tuple[Resonance, ...]]
) -> Resonance | None:
    """A relation in the table to order two, where most appear, or to the order of the case."""
    scaled = setting.case.weak.scaled
    for order in dict.fromkeys((2, max(2, setting.case.order))):
        key = id(scaled), order
        if key not in tables:
            try:
                tables[key] = tuple(scaled.resonances(order))
            except MmsgenError:  # the system has no non-resonant case, so no table
                tables[key] = ()
        for resonance in tables[key]:
            if _same(relation, resonance.relation):
                return resonance
    return None


def _same(relation: Relation, other: sp.Eq) -> bool:
    """Whether two relations are multiples of each other."""
    ratio = sp.cancel((relation.lhs - relation.rhs) / (other.lhs - other.rhs))
    return bool(ratio.is_Rational)
