"""Orders in ε: a coefficient in the user's parameters as a power series in ε.

Small parameters p are replaced by ε^k p, and a resonant frequency strictly by its resonant value
plus εσ; everything is then re-expanded in ε, denominators included, so that each order has exactly
one form.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import fmpq, fmpq_mpoly

from .errors import ScalingError
from .field import Coefficient, ParameterField

__all__ = ["Detuned", "Graded", "Grading"]

EPSILON = "<ε>"
"""No identifier, so that no parameter can have this name."""

Graded = dict[int, Coefficient]
"""Order in ε → non-zero coefficient."""


@dataclass(frozen=True)
class Detuned:
    """A frequency symbol at its resonant value: resonant + ε·detuning.

    Attributes
    ----------
    resonant : dict
        Coefficients over the remaining frequency symbols; ``"1"`` for the constant.
    detuning : dict
        Coefficients over the detuning symbols.
    """

    resonant: Mapping[str, Fraction]
    detuning: Mapping[str, Fraction]


class Grading:
    """The map from a field of parameters into power series in ε.

    Parameters
    ----------
    source : ParameterField
    orders : mapping
        Generator name → order in ε.
    detuned : mapping
        Frequency symbols replaced by their resonant value.
    detunings : sequence of str
        Names of the detuning symbols.
    order : int
        Highest order kept.

    Attributes
    ----------
    field : ParameterField
        The target: remaining parameters and detunings; ε itself never occurs in its elements.
    """

    def __init__(
        self,
        source: ParameterField,
        orders: Mapping[str, int],
        detuned: Mapping[str, Detuned] | None = None,
        detunings: Sequence[str] = (),
        order: int = 0,
    ) -> None:
        detuned = detuned or {}
        self.source, self.order = source, order
        kept = [name for name in source.names if name not in detuned]
        self.field = ParameterField([*kept, *detunings, EPSILON], source.roots.n)
        self._eps = self.field.names.index(EPSILON)
        gens = self.field.gens
        self._images = []
        for name in source.names:
            if name in detuned:
                self._images.append(self._resonant_value(detuned[name]))
            else:
                self._images.append(gens[name] * gens[EPSILON] ** orders.get(name, 0))
        self._divisors: dict[int, tuple[int, dict[int, fmpq_mpoly]]] = {}
        self._inverses: dict[int, list[Coefficient]] = {}

    def _resonant_value(self, value: Detuned) -> fmpq_mpoly:
        symbols = {name: c for name, c in value.resonant.items() if name != "1"}
        p = self.field.linear(symbols, value.resonant.get("1", Fraction(0)))
        return p + self.field.gens[EPSILON] * self.field.linear(value.detuning)

    def __call__(self, c: Coefficient) -> Graded:
        """The power series of a coefficient, up to the highest order kept.

        The orders of a small coefficient count from its own: in the equation of a coordinate of
        order 1, a force of order 3 is a term of order 2.
        """
        series: dict[int, list[Coefficient]] = {}
        for k, p in c.num.items():
            for order, q in self._split(p).items():
                series.setdefault(order, []).append(self.field.rotate(self.field.polynomial(q), k))
        graded = {order: self.field.sum(terms) for order, terms in series.items()}
        graded = {order: x for order, x in graded.items() if x}
        divisors = [m for m, e in sorted(c.den.items()) for _ in range(e)]
        shift = sum(self._parts(m)[0] for m in divisors)
        limit = self.order + max(shift, min(graded, default=0))
        for m in divisors:
            graded = self._multiply(graded, self._inverse(m, limit), limit)
        return {k - shift: x for k, x in sorted(graded.items()) if x and k <= limit}

    def _split(self, p: fmpq_mpoly) -> dict[int, fmpq_mpoly]:
        """A polynomial of the source as {order: polynomial of the target}."""
        image = p.compose(*self._images, ctx=self.field.ctx)
        parts: dict[int, dict[tuple[int, ...], fmpq]] = {}
        for monomial, c in image.to_dict().items():
            bare = list(monomial)
            order, bare[self._eps] = int(monomial[self._eps]), 0
            parts.setdefault(order, {})[tuple(bare)] = c
        return {order: self.field.ctx.from_dict(terms) for order, terms in sorted(parts.items())}

    def _parts(self, divisor: int) -> tuple[int, dict[int, fmpq_mpoly]]:
        """A divisor as ε^shift times a polynomial in ε with a non-zero constant part."""
        if divisor not in self._divisors:
            parts = self._split(self.source.divisors[divisor])
            if not parts:
                raise ScalingError(
                    f"the denominator {self.source.divisors[divisor]} vanishes on the resonance"
                )
            shift = min(parts)
            self._divisors[divisor] = shift, {k - shift: p for k, p in parts.items()}
        return self._divisors[divisor]

    def _inverse(self, divisor: int, limit: int) -> list[Coefficient]:
        """1/L without its power of ε, as a power series up to ε^limit."""
        _, parts = self._parts(divisor)
        inverse = self._inverses.setdefault(divisor, [self.field.reciprocal(parts[0])])
        for k in range(len(inverse), limit + 1):
            terms = (
                self.field.polynomial(p).times(inverse[k - i])
                for i, p in parts.items()
                if 1 <= i <= k
            )
            inverse.append(-(inverse[0] * self.field.sum(terms)))
        return inverse

    def _multiply(self, graded: Graded, inverse: list[Coefficient], limit: int) -> Graded:
        bins: dict[int, list[Coefficient]] = {}
        for order, c in graded.items():
            for k, d in enumerate(inverse[: max(0, limit - order + 1)]):
                bins.setdefault(order + k, []).append(c.times(d))
        return {order: self.field.sum(terms) for order, terms in bins.items()}
