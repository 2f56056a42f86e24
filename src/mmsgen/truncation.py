"""How far to expand in the amplitudes, so that nothing of the order asked for is left out.

Terms are dropped by their degree in the amplitudes, but a small parameter in a denominator lowers
the order in ε of a coefficient: sin(q)/p with q and p of order ε has ε^0, ε^2, …, not ε^1, ε^3.
For a slope s in (0, 1] this module bounds

    (order in ε) ≥ s·(weight of the amplitudes) + c

over all terms of an expression, dropped ones included; weights up to (order − c)/s then suffice.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction

import sympy as sp

from .alphabet import KINKED, PERIODIC, fraction
from .errors import ScalingError
from .field import Coefficient
from .taylor import ANALYTIC, Taylor

__all__ = ["valuation", "weight_limit"]

_SLOPES = tuple(Fraction(1, k) for k in range(1, 9))


def valuation(c: Coefficient, orders: Mapping[str, int]) -> int:
    """The order in ε of a non-zero coefficient, before any resonance is imposed."""
    vector = [orders.get(name, 0) for name in c.field.names]

    def lowest(monomials: Iterable[tuple[int, ...]]) -> int:
        return min(sum(int(a) * b for a, b in zip(m, vector, strict=True)) for m in monomials)

    top = min(lowest(p.monoms()) for p in c.num.values())
    return top - sum(e * lowest(c.field.divisors[m].monoms()) for m, e in c.den.items())


def weight_limit(
    taylor: Taylor, equations: Iterable[sp.Expr], orders: Mapping[str, int], order: Fraction
) -> Fraction:
    """The weight in the amplitudes beyond which every term is of a larger order than asked for.

    Parameters
    ----------
    taylor : Taylor
        Evaluates the constants; its own limit does not matter.
    equations : iterable of sympy.Expr
    orders : mapping
        Generator name → order in ε.
    order : Fraction
        The highest order in ε wanted, amplitudes included.

    Raises
    ------
    ScalingError
        If a small parameter in a denominator leaves no expansion.
    """
    limit = order
    for equation in equations:
        offender: sp.Expr = equation
        for slope in _SLOPES:
            bound = _Bound(taylor, orders, slope)
            try:
                limit = max(limit, (order - bound(equation)) / slope)
                break
            except _TooSteep as error:
                offender = error.node
        else:
            raise ScalingError(
                f"{offender} has a small parameter in a denominator and cannot be expanded: its "
                "terms do not fall in order; give the amplitude a higher order, or the parameter "
                "a lower one"
            )
    return limit


class _TooSteep(Exception):
    def __init__(self, node: sp.Expr) -> None:
        super().__init__(node)
        self.node = node


class _Bound:
    """A lower bound of (order in ε) − slope·(weight) over all terms of an expression."""

    def __init__(self, taylor: Taylor, orders: Mapping[str, int], slope: Fraction) -> None:
        self.taylor, self.orders, self.slope = taylor, orders, slope
        self.known: dict[sp.Expr, Fraction] = {}

    def __call__(self, node: sp.Expr) -> Fraction:
        if node not in self.known:
            self.known[node] = self._evaluate(node)
        return self.known[node]

    def _evaluate(self, node: sp.Expr) -> Fraction:
        if node in self.taylor.moving_parts:
            key = self.taylor.packing.unit[self.taylor.variable(node)]
            return (1 - self.slope) * self.taylor.weight(key)
        if node.is_Add:
            return min(self(a) for a in node.args)
        if node.is_Mul:
            return sum((self(a) for a in node.args), Fraction(0))
        if not node.atoms(sp.Function, sp.Derivative) & self.taylor.moving_parts:
            constants = self.taylor(node).values()
            return Fraction(min((valuation(c, self.orders) for c in constants), default=0))
        if node.is_Pow:
            return self._power(node)
        if isinstance(node, KINKED):
            return self(node.args[0]) if isinstance(node, sp.Abs) else Fraction(0)
        if not isinstance(node, (*PERIODIC, *ANALYTIC)):
            return Fraction(0)  # refused by `Taylor`, which names it
        for argument in node.args:
            moving = sp.expand(argument)
            terms = [
                term
                for term in sp.Add.make_args(moving)
                if term.atoms(sp.Function, sp.Derivative) & self.taylor.moving_parts
            ]
            if any(self(term) < 0 for term in terms):
                raise _TooSteep(node)
        return Fraction(0)

    def _power(self, node: sp.Pow) -> Fraction:
        base, exponent = node.base, node.exp
        if exponent.is_Integer and exponent > 0:
            return int(exponent) * self(base)
        constant = self.taylor(base).get(0)
        if constant is None or not exponent.is_Rational:
            return Fraction(0)  # refused by `Taylor`, which names it
        head = valuation(constant, self.orders)
        if self(base) < head:
            raise _TooSteep(node)
        return fraction(exponent) * head
