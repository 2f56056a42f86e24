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
        scaled, order = setting.case.weak.scaled, setting.case.order
        key = id(scaled), order
        if setting.case.relations and key not in tables:
            try:
                tables[key] = tuple(scaled.resonances(order))
            except MmsgenError:  # the system has no non-resonant case, so no table
                tables[key] = ()
        kinds, coordinates = [], set()
        for relation in setting.case.relations:
            found = next((r for r in tables[key] if _same(relation, r.relation)), None)
            kinds.append("as given" if found is None else found.kind)
            coordinates |= set(setting.coordinates if found is None else found.coordinates)
        chosen = tuple(q for q in setting.coordinates if q in coordinates)
        result[setting.name] = (
            " and ".join(kinds) or "nonresonant",
            chosen if kinds else setting.coordinates,
        )
    return result


def _same(relation: Relation, other: sp.Eq) -> bool:
    """Whether two relations are multiples of each other."""
    ratio = sp.cancel((relation.lhs - relation.rhs) / (other.lhs - other.rhs))
    return bool(ratio.is_Rational)
