"""Criteria: the polynomials in a detuning that are positive exactly where a factor is unstable.

Each factor of the characteristic polynomial is judged by itself. A conservative factor, real in Λ
with Γ = iΛ, is unstable exactly where two of its Λ become complex: for degrees two and three where
its discriminant in Γ is positive. A quadratic factor with damping, Γ² + bΓ + c, is unstable where

    b_r < 0   or   c_i² − b_r² c_r − b_r b_i c_i > 0,   b = b_r + i b_i, c = c_r + i c_i,

the conditions of Bilharz (1944) for complex coefficients; see F. R. Gantmacher, *The Theory of
Matrices* (1959), chapter on the Routh–Hurwitz problem. Where all dampers are zero, b_r and, as a
rule, the second expression vanish, and the discriminant decides. Higher degrees: see `hurwitz`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from .dominance import Domain, never_positive, without
from .edges import EdgeSeries, edge_series, weighted_parts
from .expressions import FieldSymbols
from .factoring import MonicFactor
from .field import Coefficient, split_generator
from .hurwitz import damped_conditions, halves, is_even, neutral_conditions

__all__ = ["Criteria", "FactorVerdict", "Judge"]

Polynomial = tuple[Coefficient, ...]
"""In the detuning, lowest power first."""

HIGHEST = 5
"""Degree in Γ up to which criteria are written down, in Γ² where a conservative factor is even."""

LONGEST = 60
"""Terms of a factor up to which they are: determinants of longer ones fill pages."""


@dataclass(frozen=True)
class Criteria:
    """What tells, at numbers, where a factor is unstable.

    Attributes
    ----------
    polynomials : tuple of tuple of Coefficient
        Polynomials in the detuning, lowest power first: unstable where one of them is positive.
    damping : tuple of Coefficient
        The damping on the whole, b_r, where it may vanish identically; empty where not.
    undamped : tuple of tuple of Coefficient
        The polynomials that count as well where the damping vanishes identically.
    """

    polynomials: tuple[Polynomial, ...]
    damping: Polynomial = ()
    undamped: tuple[Polynomial, ...] = ()


@dataclass(frozen=True)
class FactorVerdict:
    """What is known of one factor of the characteristic polynomial.

    Attributes
    ----------
    factor : MonicFactor
    kind : str
        ``"neutral"``, ``"damped"``, ``"conservative"``, ``"dissipative"`` or ``"unjudged"``.
    criterion : tuple of Coefficient
        The polynomial in the detuning whose roots are the edges, lowest power first, without
        factors that are never negative; empty where there is none.
    unstable : bool or None
        Whether it can be unstable for some detuning; None where that depends on the parameters,
        or is not known. False only where it is proved: for all values in the domain that is
        declared of the parameters, or for all that are small enough, whatever their ratios.
    statement : str
        Why, with places ``{0}``, ``{1}`` for the expressions.
    expressions : tuple of sympy.Expr
    edges : EdgeSeries or None
        The edges of the unstable interval, where they have a closed form.
    criteria : Criteria or None
        The full criteria; None for a factor without.
    """

    factor: MonicFactor
    kind: str
    criterion: Polynomial
    unstable: bool | None
    statement: str
    expressions: tuple[sp.Expr, ...] = ()
    edges: EdgeSeries | None = None
    criteria: Criteria | None = None

    @property
    def reason(self) -> str:
        """Why, as text."""
        return self.statement.format(*self.expressions)

    @property
    def reason_latex(self) -> str:
        """Why, as text with LaTeX formulas."""
        return self.statement.format(*(f"${sp.latex(e)}$" for e in self.expressions))


@dataclass(frozen=True)
class Judge:
    """What is needed to judge a factor.

    Attributes
    ----------
    symbols : FieldSymbols
    domain : Domain
        What is declared of the parameters.
    weights : mapping
        Order in ε of every small generator and of every detuning.
    detuning : str or None
        The one that is varied.
    order : int
        Of the expansion.
    """

    symbols: FieldSymbols
    domain: Domain
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
        length = sum(len(p) for c in factor.coefficients for p in c.num.values())
        halved = degree // 2 if conservative and is_even(factor.coefficients) else degree
        if halved > HIGHEST or length > LONGEST:
            statement = f"a factor of degree {degree} in Gamma has no closed-form criterion here"
            return FactorVerdict(factor, "unjudged", (), None, statement)
        return self._higher(factor, conservative)

    def _leading(self, c: Coefficient) -> Coefficient:
        """The part of lowest order in ε: it sets the sign as ε → 0."""
        parts = weighted_parts(c, self.weights)
        return parts[min(parts)] if parts else c

    def _never(self, criterion: Polynomial) -> bool:
        return never_positive(criterion, self.detuning, self.weights, self.order, self.domain)

    def _by_detuning(self, c: Coefficient) -> Polynomial:
        if self.detuning is None:
            return (c,)
        parts = split_generator(c, self.detuning)
        return tuple(parts.get(k, c.field.zero) for k in range(max(parts, default=0) + 1))

    def _edges(self, criterion: Polynomial) -> EdgeSeries | None:
        """The edges as series; None also where to leading order there are none."""
        if self.detuning is None:
            return None
        edges = edge_series(criterion, self.detuning, self.weights, self.order)
        if edges is None or self.domain.sign(edges.radicand) == -1:
            return None
        return edges

    # -- linear factors ------------------------------------------------------------------

    def _linear(self, factor: MonicFactor) -> FactorVerdict:
        damping = _real(factor.coefficients[0])
        if not damping:
            return FactorVerdict(factor, "neutral", (), False, "one mode turns without growing")
        statement, shown = "one mode decays at the rate {0}", self.symbols(damping)
        criterion = self._by_detuning(-damping)
        unstable: bool | None = None
        if self._never(criterion):
            unstable = False
        elif self.domain.sign(self._leading(damping)) == -1:
            unstable = True
            statement, shown = "one mode grows at the rate {0}", self.symbols(-damping)
        criteria = Criteria((criterion,))
        return FactorVerdict(factor, "damped", (), unstable, statement, (shown,), criteria=criteria)

    # -- conservative factors ------------------------------------------------------------

    def _conservative(self, factor: MonicFactor) -> FactorVerdict:
        discriminant = _discriminant(factor)
        shown: tuple[sp.Expr, ...] = (self._shown(factor),)
        name = f"the discriminant of {self._name(factor, discriminant)}"
        if not discriminant:
            statement = f"{name} vanishes identically"
            return FactorVerdict(factor, "conservative", (), False, statement, shown)
        criterion = self._by_detuning(discriminant)
        edges = None
        unstable: bool | None = None
        if self._never(criterion):
            unstable = False
            where = " at every detuning, the modes only exchange energy"
            statement = f"{name} is negative{where if len(criterion) > 1 else ''}"
        elif (edges := self._edges(criterion)) is not None:
            statement = f"{name} is positive in an interval of the detuning"
            if self.domain.sign(edges.radicand) == 1:
                unstable = True
            else:
                statement += " if {1} > 0"
                shown = (*shown, self.symbols(edges.radicand))
        elif len(criterion) == 1 and self.domain.sign(self._leading(criterion[0])) == 1:
            unstable = True
            statement = f"{name} is positive"
        else:
            degree = f", of degree {len(criterion) - 1}," if len(criterion) > 1 else ""
            statement = f"the sign of {name}{degree} decides"
        return FactorVerdict(
            factor,
            "conservative",
            criterion,
            unstable,
            statement,
            shown,
            edges,
            Criteria((criterion,)),
        )

    # -- factors with damping ------------------------------------------------------------

    def _dissipative(self, factor: MonicFactor) -> FactorVerdict:
        c, b, _ = factor.coefficients
        br, bi, cr, ci = _real(b), _imaginary(b), _real(c), _imaginary(c)
        whole = ci * ci - br * br * cr - br * bi * ci
        divided = self._without_common_damping(whole)
        criterion = self._by_detuning(divided)
        criteria = self._criteria(br, whole, divided, _real(b * b - c.scale(4)))
        shown: tuple[sp.Expr, ...] = (self._shown(factor),)
        if br and self.domain.sign(self._leading(br)) == -1:
            statement = "{0} has negative damping on the whole"
            return FactorVerdict(
                factor, "dissipative", (), True, statement, shown, criteria=criteria
            )
        statement, edges = f"{self._name(factor, divided)} is damped", None
        unstable: bool | None = None
        needed = (criterion, *criteria.polynomials[1:], *criteria.undamped)
        if all(self._never(p) for p in needed if p):
            unstable = False
        elif self._far_from_resonance(criterion) == 1:
            unstable = True
            statement += " on the whole, but one of its modes grows far from resonance"
        elif (edges := self._edges(criterion)) is not None:
            unstable = True if self.domain.sign(edges.radicand) == 1 else None
            statement += ", and unstable near resonance if {1} > 0"
            shown = (*shown, self.symbols(edges.radicand))
        elif len(criterion) == 1 and self.domain.sign(self._leading(divided)) == 1:
            unstable = True
        else:
            statement += ", and whether enough depends on the parameters"
        return FactorVerdict(
            factor, "dissipative", criterion, unstable, statement, shown, edges, criteria
        )

    # -- factors of a higher degree ------------------------------------------------------

    def _higher(self, factor: MonicFactor, conservative: bool) -> FactorVerdict:
        """By the minors of a Bezoutian, or by Liénard and Chipart: see `hurwitz`."""
        criteria, deciding = self._inequalities(factor, conservative)
        criterion = self._by_detuning(deciding)
        kind = "conservative" if conservative else "dissipative"
        shown: tuple[sp.Expr, ...] = (self._shown(factor),)
        unstable, edges = None, None
        damping = _real(factor.coefficients[-2])
        if all(self._never(p) for p in (*criteria.polynomials, *criteria.undamped)):
            unstable = False
            statement = "{0} has neutral modes" if conservative else "{0} is damped"
        elif not conservative and damping and self.domain.sign(self._leading(damping)) == -1:
            unstable, statement = True, "{0} has negative damping on the whole"
        else:
            found = [self._edges(p) for p in (*criteria.polynomials[:-1], criterion)]
            if any(e is not None and self.domain.sign(e.radicand) == 1 for e in found):
                unstable = True
            edges = found[0] if len(found) == 1 else None  # with several it is a union of zones
            name = "subdiscriminants" if conservative else "Hurwitz determinants"
            if conservative and is_even(factor.coefficients):
                name = "coefficients and of the discriminant in Gamma^2"
            statement = f"the signs of the {name} of {{0}} decide"
        return FactorVerdict(factor, kind, criterion, unstable, statement, shown, edges, criteria)

    def _inequalities(
        self, factor: MonicFactor, conservative: bool
    ) -> tuple[Criteria, Coefficient]:
        """The criteria, and the last polynomial of them, divided by common damping."""
        if conservative:
            conditions = neutral_conditions(factor.coefficients)
            polynomials = tuple(self._by_detuning(-c) for c in conditions)
            return Criteria(polynomials), -conditions[-1]
        conditions = damped_conditions(factor.coefficients)
        deciding = self._without_common_damping(-conditions[-1])
        # Those that are never negative say nothing.
        open_ = [c for c in conditions[:-1] if self.domain.sign(c) not in (0, 1)]
        polynomials = tuple(self._by_detuning(-c) for c in (*open_, conditions[-1]))
        _, dampers = halves(factor.coefficients)
        whole = dampers[-1]
        zero = self._may_vanish(whole)
        if any(without(v, zero) for v in dampers):
            return Criteria(polynomials), deciding
        still = tuple(without(c, zero) for c in factor.coefficients)
        # Dampers of one sign vanish where their sum does.
        telling = (whole,) if self.domain.sign(whole) else tuple(filter(None, dampers))
        damping = tuple(x for v in telling for x in self._by_detuning(v))
        undamped = tuple(self._by_detuning(-c) for c in neutral_conditions(still))
        return Criteria(polynomials, damping, undamped), deciding

    def _criteria(
        self, br: Coefficient, whole: Coefficient, divided: Coefficient, discriminant: Coefficient
    ) -> Criteria:
        """The criteria of a quadratic factor, also for dampers that are zero."""
        damped = self._by_detuning(divided)
        feeding: tuple[Polynomial, ...] = ()
        if self.domain.sign(br) not in (0, 1):
            feeding = (self._by_detuning(-br),)
        zero = self._may_vanish(br)
        if without(br, zero):
            return Criteria((damped, *feeding))
        if not feeding:
            discriminant = without(discriminant, zero)
            if _proportional(without(divided, zero), discriminant):
                return Criteria((damped, *feeding))
        undamped = self._by_detuning(discriminant)
        return Criteria((self._by_detuning(whole), *feeding), self._by_detuning(br), (undamped,))

    def _may_vanish(self, br: Coefficient) -> frozenset[str]:
        """The small parameters in the damping that may be zero."""
        field = br.field
        pairs = (zip(field.names, p.degrees(), strict=True) for p in br.num.values())
        used = {n for own in pairs for n, d in own if d}
        certain = self.domain.positive | self.domain.negative
        return frozenset(n for n in used if self.weights.get(n) and n not in certain)

    def _without_common_damping(self, value: Coefficient) -> Coefficient:
        """A criterion without factors that are never negative: dampers may then be zero."""
        if set(value.num) != {0}:
            return value
        field = value.field
        for p, e in value.num[0].factor()[1]:
            whole = self.domain.sign(field.polynomial(p)) == 1
            known = {n for n, k in zip(field.names, p.degrees(), strict=True) if k}
            if known & set(self.weights) - {self.detuning} and self.detuning not in known:
                power = int(e) if whole else int(e) - int(e) % 2
                value = value * field.reciprocal(p**power)
        return value

    def _far_from_resonance(self, criterion: Polynomial) -> int | None:
        """The sign of the leading part of what is quadratic in the detuning."""
        if len(criterion) < 3:
            return None
        return self.domain.sign(self._leading(criterion[2]))

    def _name(self, factor: MonicFactor, value: Coefficient) -> str:
        """How a factor is called: by its leading order, unless the argument lies beyond that."""
        parts = self._by_detuning(self._leading(value))
        beyond = len(parts) > 1 and not any(parts[:-1])
        return f"a factor of degree {factor.degree} in Gamma" if beyond else "{0}"

    def _shown(self, factor: MonicFactor) -> sp.Expr:
        """The factor to leading order, which carries the argument."""
        gamma = sp.Symbol("Gamma")
        leading = (self.symbols(self._leading(c)) for c in factor.coefficients)
        return sp.Add(*(c * gamma**k for k, c in enumerate(leading)))


def _proportional(one: Coefficient, other: Coefficient) -> bool:
    """Whether one is a positive number times the other."""
    if set(one.num) != {0} or set(other.num) != {0}:
        return False
    quotient = one.num[0].leading_coefficient() / other.num[0].leading_coefficient()
    ratio = Fraction(int(quotient.p), int(quotient.q))
    return ratio > 0 and not one - other.scale(ratio)


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
