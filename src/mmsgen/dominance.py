"""Signs that are proved on the whole domain of the parameters, zero included where it is allowed.

A criterion may be a polynomial in a detuning and in quantities that are small. That it is never
positive is proved in one of two ways: every term, or the quadratic as a whole, has the sign for all
values; or some of the terms have it, and each other term is one of them times something small. The
second holds for all quantities that are small enough, *whatever their ratios*. That the terms of
lowest order have the sign is not enough: with x = ε², −x² + ε³ is positive.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import fmpq

from .edges import by_weight, shifted
from .field import Coefficient, sign

__all__ = ["Domain", "never_positive", "without"]


@dataclass(frozen=True)
class Domain:
    """What is declared of the generators of a coefficient field.

    Attributes
    ----------
    positive, nonnegative, negative : frozenset of str
        Names; those that are positive are among those that are not negative.
    """

    positive: frozenset[str]
    nonnegative: frozenset[str]
    negative: frozenset[str]

    def sign(self, c: Coefficient) -> int | None:
        """1 if a coefficient is never negative, −1 if it is never positive, None if unknown."""
        if not c.num:
            return 0
        field = c.field
        above = Coefficient(field, _mirrored(c, self.negative).num, {})
        top = sign(above, self.nonnegative | self.negative)
        below = sign(Coefficient(field, field.one.num, c.den), self.positive)
        return None if top is None or below is None else top * below

    def strict_sign(self, c: Coefficient) -> int | None:
        """The sign of a coefficient that vanishes nowhere; None if it may vanish.

        Where a divisor vanishes nothing is defined: only its sign counts.
        """
        if set(c.num) != {0}:
            return None
        polynomial = c.num[0]
        factors = [p for p, _ in polynomial.factor()[1]]
        for p in factors:
            used = {n for n, d in zip(c.field.names, p.degrees(), strict=True) if d}
            if not used <= self.positive or len({q > 0 for q in p.coeffs()}) > 1:
                return None
        return sign(c, self.positive)


def _mirrored(c: Coefficient, names: frozenset[str]) -> Coefficient:
    """The numerator with the sign of some generators changed."""
    places = [i for i, n in enumerate(c.field.names) if n in names]
    if not places:
        return c
    num = {}
    for k, p in c.num.items():
        terms = {}
        for monomial, value in p.to_dict().items():
            odd = sum(int(monomial[i]) for i in places) % 2
            terms[monomial] = -value if odd else value
        num[k] = c.field.ctx.from_dict(terms)
    return Coefficient(c.field, num, c.den)


def without(c: Coefficient, names: frozenset[str]) -> Coefficient:
    """A coefficient where some generators are zero; none of them may be in a divisor."""
    places = [i for i, n in enumerate(c.field.names) if n in names]
    num = {}
    for k, p in c.num.items():
        terms = {m: v for m, v in p.to_dict().items() if not any(m[i] for i in places)}
        if terms:
            num[k] = c.field.ctx.from_dict(terms)
    return c.field.cancel(Coefficient(c.field, num, c.den))


def never_positive(
    criterion: Sequence[Coefficient],
    detuning: str | None,
    weights: Mapping[str, int],
    order: int,
    domain: Domain,
) -> bool:
    """Whether it is proved that a polynomial in the detuning is positive nowhere.

    Parameters
    ----------
    criterion : sequence of Coefficient
        Lowest power first.
    detuning : str or None
    weights : mapping
        Order in ε of each small generator and of each detuning.
    order : int
        Of the expansion.
    domain : Domain

    Returns
    -------
    bool
        False where that is not so, or not found out.
    """
    signs = [domain.sign(c) for c in criterion]
    if all(s == 0 if k % 2 else s in (0, -1) for k, s in enumerate(signs)):
        return True
    if len(criterion) == 3 and signs[0] in (0, -1) and signs[2] in (0, -1):
        p0, p1, p2 = criterion
        if domain.sign((p0 * p2).scale(4) - p1 * p1) in (0, 1):
            return True
    names = criterion[0].field.names
    small = {n: w for n, w in weights.items() if w and n in names and n != detuning}
    # What may vanish for another reason, such as an entry of a mode shape.
    small |= {n: 0 for n in names if n not in {*domain.positive, *weights, detuning}}
    if any(_divided_by(c, small) for c in criterion):
        return False
    if len(criterion) == 3:
        p0, p1, p2 = criterion
        if all(_dominated((c,), small, 1, domain) for c in (p0, p2, p1 * p1 - (p0 * p2).scale(4))):
            return True
    start = 1 if detuning is None else weights[detuning]
    while start <= order + 1:
        parts = by_weight(criterion, small, start)
        lead = parts[min(parts)]
        if _dominated(criterion, small, start, domain):
            return True
        if max(lead) != 2:
            return False
        if 1 not in lead:
            start += 1
            continue
        root = -(lead[1] * lead[2].inverse()).scale(Fraction(1, 2))
        if _divided_by(root, small):
            return False
        criterion = shifted(criterion, root)
    return False


def _divided_by(c: Coefficient, small: Mapping[str, int]) -> bool:
    """Whether something small stands in a denominator."""
    places = [c.field.names.index(n) for n in small]
    return any(c.field.divisors[m].degrees()[i] for m in c.den for i in places)


def _dominated(
    criterion: Sequence[Coefficient], small: Mapping[str, int], start: int, domain: Domain
) -> bool:
    """Whether the terms of lowest order are negative and each other one is a multiple of one."""
    terms: dict[tuple[int, ...], Coefficient] = {}
    for power, c in enumerate(criterion):
        for exponents, part in _monomials(c, tuple(small)).items():
            terms[power, *exponents] = part
    weights = (start, *small.values())
    orders = {e: sum(a * w for a, w in zip(e, weights, strict=True)) for e in terms}
    negative = {e for e, c in terms.items() if _is_negative(e, c, tuple(small), domain)}

    def smaller(e: tuple[int, ...]) -> bool:
        """Whether a term is a negative one times something small."""
        return any(
            orders[e] > orders[f] and all(a >= b for a, b in zip(e, f, strict=True))
            for f in negative
        )

    return all(e in negative or smaller(e) for e in terms)


def _is_negative(
    exponents: tuple[int, ...], c: Coefficient, small: tuple[str, ...], domain: Domain
) -> bool:
    """Whether a monomial is nowhere positive, and zero only where something small in it is."""
    turn = 1
    for name, exponent in zip(("", *small), exponents, strict=True):
        if exponent % 2 and name not in domain.nonnegative | domain.negative:
            return False
        turn *= -1 if exponent % 2 and name in domain.negative else 1
    return domain.strict_sign(c) == -turn


def _monomials(c: Coefficient, small: tuple[str, ...]) -> dict[tuple[int, ...], Coefficient]:
    """Exponents of what is small → the coefficient of that monomial."""
    field = c.field
    places = [field.names.index(n) for n in small]
    groups: dict[tuple[int, ...], dict[int, dict[tuple[int, ...], fmpq]]] = {}
    for k, p in c.num.items():
        for monomial, value in p.to_dict().items():
            bare = list(map(int, monomial))
            key = tuple(bare[i] for i in places)
            for i in places:
                bare[i] = 0
            groups.setdefault(key, {}).setdefault(k, {})[tuple(bare)] = value
    return {
        key: field.cancel(
            Coefficient(field, {k: field.ctx.from_dict(t) for k, t in parts.items()}, c.den)
        )
        for key, parts in groups.items()
    }
