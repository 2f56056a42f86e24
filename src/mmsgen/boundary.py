"""`Stability`: whether a linear slow flow can be unstable, why, and between which detunings.

Each factor of the characteristic polynomial is judged by itself. A conservative factor, real in Λ
with Γ = iΛ, is unstable exactly where two of its Λ become complex: for degrees two and three where
its discriminant in Γ is positive. A quadratic factor with damping, Γ² + bΓ + c, is unstable where

    b_r < 0   or   b_r² c_r + b_r b_i c_i − c_i² < 0,   b = b_r + i b_i, c = c_r + i c_i,

the conditions of Bilharz (1944) for complex coefficients; see F. R. Gantmacher, *The Theory of
Matrices* (1959), chapter on the Routh–Hurwitz problem.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp

from .alphabet import CONSTANT_NAMES
from .edges import EdgeSeries, edge_series, weighted_parts
from .errors import ExpansionError
from .expressions import FieldSymbols
from .factoring import MonicFactor
from .field import Coefficient, sign, split_generator
from .numeric import Evaluator, named_values
from .parameters import Parameter
from .zones import unstable_zone

__all__ = ["FactorVerdict", "Stability", "stability"]


@dataclass(frozen=True)
class FactorVerdict:
    """What is known of one factor of the characteristic polynomial.

    Attributes
    ----------
    factor : MonicFactor
    kind : str
        ``"neutral"``, ``"damped"``, ``"conservative"``, ``"dissipative"`` or ``"unjudged"``.
    criterion : tuple of Coefficient
        A polynomial in the detuning, lowest power first, positive exactly where the factor is
        unstable (for a dissipative factor with positive damping); empty where there is none.
    unstable : bool or None
        Whether it can be unstable for some detuning; None where that depends on the parameters.
    statement : str
        Why, with places ``{0}``, ``{1}`` for the expressions.
    expressions : tuple of sympy.Expr
    edges : EdgeSeries or None
        The edges of the unstable interval, where they have a closed form.
    """

    factor: MonicFactor
    kind: str
    criterion: tuple[Coefficient, ...]
    unstable: bool | None
    statement: str
    expressions: tuple[sp.Expr, ...] = ()
    edges: EdgeSeries | None = None

    @property
    def reason(self) -> str:
        """Why, as text."""
        return self.statement.format(*self.expressions)

    @property
    def reason_latex(self) -> str:
        """Why, as text with LaTeX formulas."""
        return self.statement.format(*(f"${sp.latex(e)}$" for e in self.expressions))


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
    """

    verdicts: tuple[FactorVerdict, ...]
    symbols: FieldSymbols
    parameters: tuple[Parameter, ...]
    detuning: sp.Symbol | None

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

        The roots of the criterion, re-expanded in ε and kept through the order of the expansion.

        Raises
        ------
        ExpansionError
            If the criterion is not quadratic in the detuning to leading order.
        """
        if self.critical is None:
            return ()
        edges = self.critical.edges
        if edges is None:
            degree = len(self.critical.criterion) - 1
            raise ExpansionError(
                f"no interval of the detuning has edges in closed form: the criterion is a "
                f"polynomial of degree {degree} in it, and {self.critical.reason}; use "
                "boundaries(values) or growth_rate(values)"
            )
        root = sp.sqrt(self.symbols(edges.radicand))
        centre = sp.Add(*(self.symbols(a) for a in edges.rational))
        half = sp.Add(*(self.symbols(b) * root for b in edges.radical))
        return centre - half, centre + half

    def boundaries(self, values: Mapping[Any, Any]) -> Any:
        """Both edges for numbers; NaN where there is no unstable interval."""
        numbers = named_values(self.parameters, values)
        shape = np.broadcast_shapes(*(v.shape for v in numbers.values()))
        if self.critical is None:
            return np.full((*shape, 2), np.nan)
        with np.errstate(divide="ignore", invalid="ignore"):
            zones = unstable_zone([np.real(c) for c in self._criterion(numbers)])
        return np.broadcast_to(zones, (*shape, 2)).copy()

    @cached_property
    def _criterion(self) -> Evaluator:
        assert self.critical is not None
        expressions = [self.symbols(c) for c in self.critical.criterion]
        return Evaluator(expressions, self.parameters)


@dataclass(frozen=True)
class _Judge:
    """What is needed to judge a factor."""

    symbols: FieldSymbols
    positive: frozenset[str]
    nonnegative: frozenset[str]
    weights: Mapping[str, int]
    detuning: str | None
    order: int

    def verdict(self, factor: MonicFactor) -> FactorVerdict:
        """The verdict on one factor."""
        degree = factor.degree
        conservative = all(
            not _imaginary(c.times_i(k - degree)) for k, c in enumerate(factor.coefficients)
        )
        if degree == 1:
            return self._linear(factor)
        if conservative and degree <= 3:
            return self._conservative(factor)
        if degree == 2:
            return self._dissipative(factor)
        statement = f"a factor of degree {degree} in Gamma has no closed-form criterion here"
        return FactorVerdict(factor, "unjudged", (), None, statement)

    def _leading(self, c: Coefficient) -> Coefficient:
        """The part of lowest order in ε: it sets the sign as ε → 0."""
        parts = weighted_parts(c, self.weights)
        return parts[min(parts)] if parts else c

    def _linear(self, factor: MonicFactor) -> FactorVerdict:
        damping = _real(factor.coefficients[0])
        if not damping:
            return FactorVerdict(factor, "neutral", (), False, "one mode turns without growing")
        s = sign(self._leading(damping), self.nonnegative)
        statement, shown = "one mode decays at the rate {0}", self.symbols(damping)
        if s == -1:
            statement, shown = "one mode grows at the rate {0}", self.symbols(-damping)
        unstable = None if s is None else s < 0
        return FactorVerdict(factor, "damped", (), unstable, statement, (shown,))

    def _by_detuning(self, c: Coefficient) -> tuple[Coefficient, ...]:
        if self.detuning is None:
            return (c,)
        parts = split_generator(c, self.detuning)
        return tuple(parts.get(k, c.field.zero) for k in range(max(parts, default=0) + 1))

    def _edges(self, criterion: tuple[Coefficient, ...]) -> EdgeSeries | None:
        if self.detuning is None:
            return None
        return edge_series(criterion, self.detuning, self.weights, self.order)

    def _conservative(self, factor: MonicFactor) -> FactorVerdict:
        discriminant = _discriminant(factor)
        name = f"the discriminant of {self._name(factor, discriminant)}"
        shown: tuple[sp.Expr, ...] = (self._shown(factor),)
        if not discriminant:
            return FactorVerdict(
                factor, "conservative", (), False, f"{name} vanishes identically", shown
            )
        criterion = self._by_detuning(discriminant)
        edges = self._edges(criterion)
        if edges is None:
            return self._constant(factor, criterion)
        s = sign(edges.radicand, self.positive)
        if s == -1:
            statement = f"{name} is negative at every detuning, the modes only exchange energy"
            return FactorVerdict(factor, "conservative", criterion, False, statement, shown)
        statement = f"{name} is positive in an interval of the detuning"
        if s is None:
            statement += " if {1} > 0"
            shown = (*shown, self.symbols(edges.radicand))
        return FactorVerdict(
            factor, "conservative", criterion, None if s is None else True, statement, shown, edges
        )

    def _constant(self, factor: MonicFactor, criterion: tuple[Coefficient, ...]) -> FactorVerdict:
        """A criterion that is not quadratic in the detuning to leading order."""
        degree, shown = len(criterion) - 1, (self._shown(factor),)
        if degree:
            statement = f"the sign of the discriminant of {{0}}, of degree {degree}, decides"
            return FactorVerdict(factor, "conservative", criterion, None, statement, shown)
        s = sign(self._leading(criterion[0]), self.positive)
        word = {None: "decides", 1: "is positive", -1: "is negative"}[s]
        unstable = None if s is None else s > 0
        statement = f"the discriminant of {{0}} {word}"
        return FactorVerdict(factor, "conservative", criterion, unstable, statement, shown)

    def _dissipative(self, factor: MonicFactor) -> FactorVerdict:
        c, b, _ = factor.coefficients
        br, bi, cr, ci = _real(b), _imaginary(b), _real(c), _imaginary(c)
        shown = [self._shown(factor)]
        if br and sign(self._leading(br), self.nonnegative) == -1:
            statement = "{0} has negative damping on the whole"
            return FactorVerdict(factor, "dissipative", (), True, statement, tuple(shown))
        value = self._without_common_damping(ci * ci - br * br * cr - br * bi * ci)
        criterion = self._by_detuning(value)
        statement = f"{self._name(factor, value)} is damped"
        if self._far_from_resonance(criterion) == 1:
            statement += " on the whole, but one of its modes grows far from resonance"
            return FactorVerdict(factor, "dissipative", criterion, True, statement, tuple(shown))
        edges, s = self._edges(criterion), None
        if edges is not None:
            s = sign(edges.radicand, self.positive)
            statement += ", and unstable near resonance if {1} > 0"
            shown.append(self.symbols(edges.radicand))
        elif len(criterion) == 1:
            s = sign(self._leading(value), self.positive)
        unstable = None if s is None else s > 0
        return FactorVerdict(
            factor, "dissipative", criterion, unstable, statement, tuple(shown), edges
        )

    def _without_common_damping(self, value: Coefficient) -> Coefficient:
        """A criterion without factors that are never negative: dampers may then be zero."""
        if set(value.num) != {0}:
            return value
        field = value.field
        for p, e in value.num[0].factor()[1]:
            whole = sign(field.polynomial(p), self.nonnegative) == 1
            known = {n for n, k in zip(field.names, p.degrees(), strict=True) if k}
            if known & set(self.weights) - {self.detuning} and self.detuning not in known:
                power = int(e) if whole else int(e) - int(e) % 2
                value = value * field.reciprocal(p**power)
        return value

    def _far_from_resonance(self, criterion: tuple[Coefficient, ...]) -> int | None:
        """The sign of the leading part of what is quadratic in the detuning."""
        if len(criterion) < 3:
            return None
        return sign(self._leading(criterion[2]), self.nonnegative)

    def _name(self, factor: MonicFactor, value: Coefficient) -> str:
        """How a factor is called: by its leading order, unless the argument lies beyond that."""
        parts = self._by_detuning(self._leading(value))
        beyond = len(parts) > 1 and not any(parts[:-1])
        return f"a factor of degree {factor.degree} in Gamma" if beyond else "{0}"

    def _shown(self, factor: MonicFactor) -> sp.Expr:
        """The factor to leading order, which carries the argument."""
        gamma = sp.Symbol("Gamma")
        terms = (
            self.symbols(self._leading(c)) * gamma**k for k, c in enumerate(factor.coefficients)
        )
        return sp.Add(*terms)


def stability(
    factors: Sequence[MonicFactor],
    symbols: FieldSymbols,
    parameters: Sequence[Parameter],
    detunings: Sequence[sp.Symbol],
    weights: Mapping[str, int],
    order: int,
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
    """
    constants = frozenset(CONSTANT_NAMES)
    positive = constants | {p.name for p in parameters if p.symbol.is_positive}
    nonnegative = constants | {p.name for p in parameters if p.symbol.is_nonnegative}
    detuning = detunings[0] if detunings else None
    name = None if detuning is None else str(detuning.name)
    judge = _Judge(symbols, positive, nonnegative, weights, name, order)
    verdicts = tuple(judge.verdict(f) for f in factors)
    return Stability(verdicts, symbols, tuple(parameters), detuning)


def _real(c: Coefficient) -> Coefficient:
    return (c + c.conjugate()).scale(Fraction(1, 2))


def _imaginary(c: Coefficient) -> Coefficient:
    return (c - c.conjugate()).times_i(-1).scale(Fraction(1, 2))


def _discriminant(factor: MonicFactor) -> Coefficient:
    """Discriminant in Γ of a monic polynomial of degree two or three."""
    if factor.degree == 2:
        c, b, _ = factor.coefficients
        return b * b - c.scale(4)
    d, c, b, _ = factor.coefficients
    return (
        (b * c * d).scale(18)
        - (b * b * b * d).scale(4)
        + b * b * c * c
        - (c * c * c).scale(4)
        - (d * d).scale(27)
    )
