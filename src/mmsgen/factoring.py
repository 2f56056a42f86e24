"""Characteristic polynomials, factored exactly.

A monic polynomial P(Γ) with coefficients in a `ParameterField` becomes real under Γ = iΛ and a
change p → i^{x_p} p of some of the parameters, where such a change exists: that is so whenever
reversing time changes only the sign of the damping. The real polynomial is factored over ℚ, and
the change is undone. By Gauss's lemma the monic factors have coefficients in the same field.
Where no such change exists the polynomial is left whole.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import flint
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from .field import Coefficient, ParameterField

__all__ = ["MonicFactor", "factor_monic"]


@dataclass(frozen=True)
class MonicFactor:
    """A monic factor of a characteristic polynomial.

    Attributes
    ----------
    coefficients : tuple of Coefficient
        Coefficient of Γ^k at index k; the last is 1.
    multiplicity : int
    """

    coefficients: tuple[Coefficient, ...]
    multiplicity: int

    @property
    def degree(self) -> int:
        """Degree in Γ."""
        return len(self.coefficients) - 1


def factor_monic(coefficients: Sequence[Coefficient]) -> tuple[MonicFactor, ...]:
    """Factor a monic polynomial over the rationals.

    Parameters
    ----------
    coefficients : sequence of Coefficient
        Lowest power first; the last is 1.

    Returns
    -------
    tuple of MonicFactor
        Sorted by degree, higher first; the polynomial itself where it stays whole.
    """
    degree = len(coefficients) - 1
    whole = (MonicFactor(tuple(coefficients), 1),)
    if degree == 1:
        return whole
    field = coefficients[0].field
    numerators = _numerators(field, coefficients)
    parity = _real_change(field, numerators)
    if parity is None:
        return whole
    polynomial = _real_polynomial(field, numerators, parity)
    _, factors = polynomial.factor()
    result = []
    for factor, multiplicity in factors:
        parts = _back(field, factor, parity)
        if len(parts) > 1:
            lead = parts[-1].inverse()
            monic = tuple(c * lead for c in parts)
            result.append(MonicFactor(monic, int(multiplicity)))
    result.sort(key=lambda f: (-f.degree, repr(f.coefficients)))
    return tuple(result)


def _numerators(field: ParameterField, coefficients: Sequence[Coefficient]) -> list[Coefficient]:
    """The coefficients times their least common denominator."""
    den: dict[int, int] = {}
    for c in coefficients:
        for m, e in c.den.items():
            den[m] = max(e, den.get(m, 0))
    factor = field.one
    for m, e in sorted(den.items()):
        factor = factor * field.polynomial(field.divisors[m] ** e)
    return [c * factor for c in coefficients]


def _real_change(field: ParameterField, numerators: Sequence[Coefficient]) -> list[int] | None:
    """x_p in {0, 1} such that p → i^{x_p} p and Γ → iΛ make the polynomial real; else None.

    Solved over GF(2): each monomial i^b Π p^{e_p} Γ^k needs b + k − n + Σ e_p x_p even, up to one
    parity common to all.
    """
    i_power = field.roots.i
    degree, size = len(numerators) - 1, len(field.names)
    rows: set[tuple[int, ...]] = set()
    for k, c in enumerate(numerators):
        for power, p in c.num.items():
            if power not in (0, i_power):
                return None
            b = (power == i_power) + k - degree
            for monomial in p.monoms():
                rows.add((*(int(e) % 2 for e in monomial), 1, b % 2))
    pivots: dict[int, tuple[int, ...]] = {}
    for row in sorted(rows):
        current = row
        for column, pivot in sorted(pivots.items()):
            if current[column]:
                current = tuple((a + b) % 2 for a, b in zip(current, pivot, strict=True))
        lead = next((i for i, a in enumerate(current) if a), None)
        if lead is None:
            continue
        if lead == size + 1:
            return None
        pivots = {
            c: tuple((a + b) % 2 for a, b in zip(r, current, strict=True)) if r[lead] else r
            for c, r in pivots.items()
        }
        pivots[lead] = current
    return [pivots[p][-1] if p in pivots else 0 for p in range(size)]


def _real_polynomial(
    field: ParameterField, numerators: Sequence[Coefficient], parity: list[int]
) -> fmpq_mpoly:
    """The real polynomial in the parameters and Λ, up to a common power of i."""
    names = (*(f"g{i}" for i in range(len(field.names))), "g_lambda")
    ctx = fmpq_mpoly_ctx.get(names, flint.Ordering.degrevlex)
    terms: dict[tuple[int, ...], fmpq] = {}
    base: int | None = None
    for k, c in enumerate(numerators):
        for power, p in c.num.items():
            for monomial, value in p.to_dict().items():
                e = tuple(map(int, monomial))
                turn = (
                    (power == field.roots.i)
                    + k
                    + sum(a * b for a, b in zip(e, parity, strict=True))
                )
                base = turn if base is None else base
                sign = 1 if (turn - base) % 4 == 0 else -1
                terms[*e, k] = value * sign
    return ctx.from_dict(terms)


def _back(field: ParameterField, factor: fmpq_mpoly, parity: list[int]) -> list[Coefficient]:
    """A real factor as a polynomial in Γ: Λ = −iΓ and p → i^{−x_p} p."""
    parts: dict[int, list[Coefficient]] = {}
    for monomial, value in factor.to_dict().items():
        *exponents, k = map(int, monomial)
        p = field.ctx.from_dict({tuple(exponents): value})
        turn = -k - sum(a * b for a, b in zip(exponents, parity, strict=True))
        parts.setdefault(k, []).append(field.polynomial(p).times_i(turn))
    return [field.sum(parts.get(k, ())) for k in range(max(parts) + 1)]
