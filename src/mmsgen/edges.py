"""Roots of a polynomial in the detuning, order by order in ε and exactly.

A criterion E(σ) = Σ ε^k E_k(σ) whose leading part is quadratic in σ has, for each of its two simple
roots, one series σ = εσ_1 + ε²σ_2 + …. With √D the root of the leading discriminant, every term is
of the form a + b√D with a and b in the coefficient field: exact arithmetic in that extension.
Where the leading part has a double root, the coupling being of a higher order, the detuning is
counted from that root and one order later (Newton's polygon).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import fmpq

from .field import Coefficient, ParameterField

__all__ = ["EdgeSeries", "by_weight", "edge_series", "shifted", "weighted_parts"]


def weighted_parts(c: Coefficient, weights: Mapping[str, int]) -> dict[int, Coefficient]:
    """A coefficient by its order in ε: total weight of a monomial → the terms of that weight.

    No divisor may contain a generator with a weight.
    """
    field = c.field
    vector = [weights.get(name, 0) for name in field.names]
    parts: dict[int, dict[int, dict[tuple[int, ...], fmpq]]] = {}
    for k, p in c.num.items():
        for monomial, value in p.to_dict().items():
            e = tuple(map(int, monomial))
            order = sum(a * b for a, b in zip(e, vector, strict=True))
            parts.setdefault(order, {}).setdefault(k, {})[e] = value
    return {
        order: field.cancel(
            Coefficient(field, {k: field.ctx.from_dict(t) for k, t in num.items()}, c.den)
        )
        for order, num in sorted(parts.items())
    }


@dataclass(frozen=True)
class Surd:
    """a + b√D."""

    a: Coefficient
    b: Coefficient
    radicand: Coefficient

    def __add__(self, other: Surd) -> Surd:
        return Surd(self.a + other.a, self.b + other.b, self.radicand)

    def __mul__(self, other: Surd) -> Surd:
        a = self.a * other.a + self.b * other.b * self.radicand
        return Surd(a, self.a * other.b + self.b * other.a, self.radicand)

    def scale(self, c: Coefficient) -> Surd:
        """The product with an element of the field."""
        return Surd(self.a * c, self.b * c, self.radicand)


@dataclass(frozen=True)
class EdgeSeries:
    """Both edges of a zone: σ = Σ_p (a_p ± b_p √D).

    Attributes
    ----------
    rational, radical : tuple of Coefficient
        a_p and b_p for p = 1, 2, …; the first b_p that is not zero is positive where the zone
        exists.
    radicand : Coefficient
        D, positive exactly where the zone exists to leading order.
    """

    rational: tuple[Coefficient, ...]
    radical: tuple[Coefficient, ...]
    radicand: Coefficient


def edge_series(
    criterion: Sequence[Coefficient], detuning: str, weights: Mapping[str, int], order: int
) -> EdgeSeries | None:
    """The edges of the interval on which a criterion is positive.

    Parameters
    ----------
    criterion : sequence of Coefficient
        A polynomial in the detuning, lowest power first.
    detuning : str
    weights : mapping
        Order in ε of each small generator and of each detuning.
    order : int
        Number of terms.

    Returns
    -------
    EdgeSeries or None
        None where the leading part is not quadratic in the detuning, is positive outside of its
        roots, or the two edges are the same through the order.
    """
    field = criterion[0].field
    centre: list[Coefficient] = []
    for start in range(weights[detuning], order + 1):
        parts = by_weight(criterion, weights, start)
        lowest = min(parts, default=0)
        lead = parts.get(lowest, {})
        if max(lead, default=0) != 2:
            return None
        p0, p1, p2 = (lead.get(k, field.zero) for k in range(3))
        radicand = p1 * p1 - (p0 * p2).scale(4)
        if radicand:
            levels = [parts.get(lowest + k, {}) for k in range(order + 1 - start)]
            tail = _newton(field, levels, (p1, p2, radicand))
            nothing = (field.zero,) * len(centre)
            return EdgeSeries((*centre, *tail.rational), (*nothing, *tail.radical), radicand)
        root = -(p1 * p2.inverse()).scale(Fraction(1, 2))
        centre.append(root)
        criterion = shifted(criterion, root)
    return None


def by_weight(
    criterion: Sequence[Coefficient], weights: Mapping[str, int], start: int
) -> dict[int, dict[int, Coefficient]]:
    """Order in ε → power of the detuning → coefficient, for a detuning of order `start`."""
    parts: dict[int, dict[int, Coefficient]] = {}
    for power, c in enumerate(criterion):
        for weight, part in weighted_parts(c, weights).items():
            parts.setdefault(weight + power * start, {})[power] = part
    return parts


def shifted(criterion: Sequence[Coefficient], root: Coefficient) -> tuple[Coefficient, ...]:
    """The criterion in the detuning counted from `root`, by Horner's scheme."""
    result = list(criterion)
    for lowest in range(len(result) - 1):
        for k in range(len(result) - 2, lowest - 1, -1):
            result[k] = result[k] + result[k + 1] * root
    return tuple(result)


def _newton(
    field: ParameterField,
    levels: list[dict[int, Coefficient]],
    lead: tuple[Coefficient, Coefficient, Coefficient],
) -> EdgeSeries:
    """Solve E = 0 for σ_1, σ_2, … one order at a time; E_lead'(σ_1) = ∓√D."""
    p1, p2, radicand = lead
    half = p2.inverse().scale(Fraction(1, 2))
    # With p2 < 0 the criterion is positive between its roots, and −1/(2 p2) is positive.
    sigma = [Surd(-(p1 * half), -half, radicand)]
    # E_lead'(σ_1) = 2 p2 σ_1 + p1 = −√D for the upper sign, so 1/E_lead' = −√D/D.
    inverse_slope = Surd(field.zero, -radicand.inverse(), radicand)
    for p in range(1, len(levels)):
        rest = _coefficient_at(field, levels, sigma, p, radicand)
        correction = rest * inverse_slope
        sigma.append(Surd(-correction.a, -correction.b, radicand))
    return EdgeSeries(tuple(s.a for s in sigma), tuple(s.b for s in sigma), radicand)


def _coefficient_at(
    field: ParameterField,
    levels: list[dict[int, Coefficient]],
    sigma: list[Surd],
    order: int,
    radicand: Coefficient,
) -> Surd:
    """The ε^order part of E(σ_1 + εσ_2 + …) with the terms known so far."""
    one = Surd(field.one, field.zero, radicand)
    zero = Surd(field.zero, field.zero, radicand)
    highest = max((k for level in levels for k in level), default=0)
    power = [one, *(zero for _ in range(order))]
    total = zero
    for k in range(highest + 1):
        for r, level in enumerate(levels[: order + 1]):
            if k in level:
                total = total + power[order - r].scale(level[k])
        power = [
            _sum([power[i] * sigma[m - i] for i in range(m + 1) if m - i < len(sigma)], zero)
            for m in range(order + 1)
        ]
    return total


def _sum(terms: Sequence[Surd], zero: Surd) -> Surd:
    total = zero
    for term in terms:
        total = total + term
    return total
