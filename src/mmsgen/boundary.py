"""`Stability`: whether a linear slow flow can be unstable, why, and between which detunings.

Two descriptions of the edges of a zone differ by O(ε^{N+1}), what order N leaves out: the *formula*
is the root of the criterion re-expanded in ε and cut after ε^N; the *numbers* are the roots of the
criterion as it stands, so that they are where the growth rate begins.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp

from .alphabet import CONSTANT_NAMES
from .criteria import Criteria, FactorVerdict, Judge
from .dominance import Domain
from .errors import ExpansionError, MmsgenError
from .expressions import FieldSymbols
from .factoring import MonicFactor
from .field import Coefficient
from .numeric import Evaluator, named_values
from .parameters import Parameter
from .zones import positive_zones, unstable_zone

__all__ = ["FactorVerdict", "Stability", "stability"]


@dataclass(frozen=True)
class Stability:
    """Verdicts on all factors, and the boundary that follows.

    Attributes
    ----------
    verdicts : tuple of FactorVerdict
    symbols : FieldSymbols
    parameters : tuple of Parameter
    detuning : sympy.Symbol or None
        The detuning that is varied: that of the first relation.
    domain : Domain
        What is declared of the parameters.
    reach : sympy.Expr
        Half of the frequencies that resonate; infinite where the slow flow does not hold them.
    """

    verdicts: tuple[FactorVerdict, ...]
    symbols: FieldSymbols
    parameters: tuple[Parameter, ...]
    detuning: sp.Symbol | None
    domain: Domain
    reach: sp.Expr = sp.oo

    @property
    def unstable(self) -> bool | None:
        """True if the case can be unstable, None if that depends on the parameters."""
        answers = [v.unstable for v in self.verdicts]
        if True in answers:
            return True
        return None if None in answers else False

    @property
    def reason(self) -> str:
        """Why the case can or cannot be unstable."""
        return "; ".join(dict.fromkeys(v.reason for v in self._telling))

    @property
    def reason_latex(self) -> str:
        """Why the case can or cannot be unstable, with LaTeX formulas."""
        return "; ".join(dict.fromkeys(v.reason_latex for v in self._telling))

    @property
    def _telling(self) -> list[FactorVerdict]:
        """The factors that can be unstable, or all, those of higher degree first."""
        telling = [v for v in self.verdicts if v.unstable is not False] or list(self.verdicts)
        return sorted(telling, key=lambda v: -v.factor.degree)

    @cached_property
    def critical(self) -> FactorVerdict | None:
        """The factor that sets the boundary; None where no factor can be unstable.

        Raises
        ------
        ExpansionError
            If more than one factor can be unstable, or the factor has no criterion.
        """
        if self.unstable is False:
            return None
        wanted = [v for v in self.verdicts if v.unstable is not False]
        judged = [v for v in wanted if v.criterion]
        if len(wanted) != 1 or not judged:
            raise ExpansionError(
                f"{len(wanted)} factors of the characteristic polynomial can be unstable, "
                f"{len(judged)} of them with a criterion in closed form: there is no single "
                "boundary; use growth_rate"
            )
        return judged[0]

    def boundary(self) -> tuple[sp.Expr, ...]:
        """Both edges of the unstable interval in closed form; empty where there is none.

        The roots of the criterion, re-expanded in ε and kept through the order N of the expansion:
        they differ from `boundaries` by O(ε^{N+1}).

        Raises
        ------
        ExpansionError
            If the criterion is not quadratic in the detuning to leading order, or has no real root
            there.
        """
        if self.critical is None:
            return ()
        edges = self.critical.edges
        if edges is None:
            degree = len(self.critical.criterion) - 1
            raise ExpansionError(
                f"no interval of the detuning has edges in closed form: the criterion is a "
                f"polynomial of degree {degree} in it, and {self.critical.reason}; use "
                "boundaries(values) or growth_rate(values), or count the dampers at a higher order"
            )
        root = sp.sqrt(self.symbols(edges.radicand))
        centre = sp.Add(*(self.symbols(a) for a in edges.rational))
        half = sp.Add(*(self.symbols(b) * root for b in edges.radical))
        return centre - half, centre + half

    @cached_property
    def criteria(self) -> tuple[Criteria, ...]:
        """The criteria of all factors that can be unstable.

        Raises
        ------
        ExpansionError
            If one of them has none.
        """
        wanted = [v for v in self.verdicts if v.unstable is not False]
        for v in wanted:
            if v.criteria is None:
                raise ExpansionError(f"{v.reason}: there is no boundary; use growth_rate")
        return tuple(v.criteria for v in wanted if v.criteria is not None)

    @cached_property
    def farthest(self) -> sp.Expr:
        """How far from the resonance a zone may begin; infinite for criteria that are parabolas.

        Those of a higher degree have roots far away that mean nothing.
        """
        polynomials = (p for c in self.criteria for p in (*c.polynomials, *c.undamped))
        return self.reach if any(len(p) > 3 for p in polynomials) else sp.oo

    def boundaries(self, values: Mapping[Any, Any]) -> Any:
        """Both edges for numbers; NaN where there is no unstable interval.

        Of the intervals in which a criterion is positive, that nearest to the resonance; none that
        begins farther away than `farthest`.
        """
        shape, polynomials, reach = self._numbers(values)
        zones = unstable_zone(*polynomials, reach=reach) if polynomials else np.nan
        return np.broadcast_to(zones, (*shape, 2)).copy()

    def zones(self, values: Mapping[Any, Any]) -> Any:
        """All unstable intervals for numbers, shape (count, 2), in ascending order."""
        shape, polynomials, reach = self._numbers(values)
        if shape:
            raise MmsgenError(f"zones takes one number for each parameter, got the shape {shape}")
        table = [[float(c) for c in p] for p in polynomials]
        found = positive_zones(table, float(reach))
        return np.array(found, dtype=float).reshape(-1, 2)

    def _numbers(self, values: Mapping[Any, Any]) -> tuple[Any, list[list[Any]], Any]:
        """Shape of the values, all polynomials at numbers, and the reach."""
        numbers = named_values(self.parameters, values)
        shape = np.broadcast_shapes(*(v.shape for v in numbers.values()))
        if not self.criteria:
            return shape, [], np.inf
        with np.errstate(divide="ignore", invalid="ignore"):
            reach, *flat = (np.real(v) for v in self._evaluator(numbers))
        rest = iter(flat)

        def taken(polynomial: Sequence[Coefficient]) -> list[Any]:
            return [next(rest) for _ in polynomial]

        polynomials = []
        for c in self.criteria:
            polynomials += [taken(p) for p in c.polynomials]
            if c.undamped:
                damped = np.any(np.broadcast_arrays(*taken(c.damping)), axis=0)
                for p in c.undamped:
                    polynomials.append([np.where(damped, 0.0, d) for d in taken(p)])
        return shape, polynomials, reach

    @cached_property
    def _evaluator(self) -> Evaluator:
        flat = [
            x for c in self.criteria for p in (*c.polynomials, c.damping, *c.undamped) for x in p
        ]
        return Evaluator([self.reach, *(self.symbols(x) for x in flat)], self.parameters)


def stability(
    factors: Sequence[MonicFactor],
    symbols: FieldSymbols,
    parameters: Sequence[Parameter],
    detunings: Sequence[sp.Symbol],
    weights: Mapping[str, int],
    order: int,
    reach: sp.Expr = sp.oo,
) -> Stability:
    """Judge every factor of a characteristic polynomial.

    Parameters
    ----------
    factors : sequence of MonicFactor
    symbols : FieldSymbols
    parameters : sequence of Parameter
    detunings : sequence of sympy.Symbol
        The first is varied; without any, the criterion is a constant.
    weights : mapping
        Order in ε of every small generator and detuning.
    order : int
        Order of the expansion.
    reach : sympy.Expr
        How far a zone may begin from the resonance.
    """
    constants = frozenset(CONSTANT_NAMES)
    domain = Domain(
        constants | {p.name for p in parameters if p.symbol.is_positive},
        constants | {p.name for p in parameters if p.symbol.is_nonnegative},
        frozenset(p.name for p in parameters if p.symbol.is_negative),
    )
    detuning = detunings[0] if detunings else None
    name = None if detuning is None else str(detuning.name)
    judge = Judge(symbols, domain, weights, name, order)
    verdicts = tuple(judge.verdict(f) for f in factors)
    return Stability(verdicts, symbols, tuple(parameters), detuning, domain, reach)
