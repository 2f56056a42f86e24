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

from .errors import ExpansionError
from .expressions import FieldSymbols
from .factoring import MonicFactor
from .field import Coefficient, sign, split_generator
from .numeric import evaluate
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
    reason : str
        Why.
    """

    factor: MonicFactor
    kind: str
    criterion: tuple[Coefficient, ...]
    unstable: bool | None
    reason: str


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
        wanted = [v for v in self.verdicts if v.unstable is not False] or list(self.verdicts)
        return "; ".join(dict.fromkeys(v.reason for v in wanted))

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
        """Both edges of the unstable interval in closed form; empty where there is none."""
        if self.critical is None:
            return ()
        criterion = [self.symbols(c) for c in self.critical.criterion]
        if len(criterion) != 3:
            raise ExpansionError(
                f"the boundary is a polynomial of degree {len(criterion) - 1} in the detuning: "
                "it has no closed form that is worth reading; use boundaries(values)"
            )
        p0, p1, p2 = self.critical.criterion
        inside = p1 * p1 - (p0 * p2).scale(4)
        root, centre = sp.sqrt(self.symbols(inside)), -self.symbols(p1)
        double = 2 * self.symbols(p2)  # p2 < 0: the criterion is positive between the roots
        return (centre + root) / double, (centre - root) / double

    def boundaries(self, values: Mapping[Any, Any]) -> Any:
        """Both edges for numbers; NaN where there is no unstable interval."""
        numbers = dict(values)
        if self.critical is None:
            shapes = [np.shape(v) for v in numbers.values()]
            return np.full((*np.broadcast_shapes(*shapes), 2), np.nan)
        expressions = [self.symbols(c) for c in self.critical.criterion]
        coefficients = evaluate(expressions, self.parameters, numbers)
        return unstable_zone([np.real(c) for c in coefficients])


def stability(
    factors: Sequence[MonicFactor],
    symbols: FieldSymbols,
    parameters: Sequence[Parameter],
    detunings: Sequence[sp.Symbol],
) -> Stability:
    """Judge every factor of a characteristic polynomial.

    Parameters
    ----------
    factors : sequence of MonicFactor
    symbols : FieldSymbols
    parameters : sequence of Parameter
    detunings : sequence of sympy.Symbol
        The first is varied; without any, the criterion is a constant.
    """
    positive = frozenset(p.name for p in parameters if p.symbol.is_positive)
    detuning = detunings[0] if detunings else None
    verdicts = tuple(_judge(f, symbols, positive, detuning) for f in factors)
    return Stability(verdicts, symbols, tuple(parameters), detuning)


def _real(c: Coefficient) -> Coefficient:
    return (c + c.conjugate()).scale(Fraction(1, 2))


def _imaginary(c: Coefficient) -> Coefficient:
    return (c - c.conjugate()).times_i(-1).scale(Fraction(1, 2))


def _judge(
    factor: MonicFactor,
    symbols: FieldSymbols,
    positive: frozenset[str],
    detuning: sp.Symbol | None,
) -> FactorVerdict:
    degree = factor.degree
    conservative = all(
        not _imaginary(c.times_i(k - degree)) for k, c in enumerate(factor.coefficients)
    )
    if degree == 1:
        return _judge_linear(factor, symbols, positive)
    if conservative and degree <= 3:
        return _judge_conservative(factor, symbols, positive, detuning)
    if degree == 2:
        return _judge_dissipative(factor, symbols, detuning)
    reason = f"a factor of degree {degree} in Gamma has no closed-form criterion here"
    return FactorVerdict(factor, "unjudged", (), None, reason)


def _judge_linear(
    factor: MonicFactor, symbols: FieldSymbols, positive: frozenset[str]
) -> FactorVerdict:
    damping = _real(factor.coefficients[0])
    if not damping:
        return FactorVerdict(factor, "neutral", (), False, "one mode turns without growing")
    s = sign(damping, positive)
    unstable = None if s is None else s < 0
    reason = f"one mode decays at the rate {symbols(damping)}"
    return FactorVerdict(factor, "damped", (), unstable, reason)


def _by_detuning(c: Coefficient, detuning: sp.Symbol | None) -> tuple[Coefficient, ...]:
    if detuning is None or str(detuning.name) not in c.field.names:
        return (c,)
    parts = split_generator(c, str(detuning.name))
    return tuple(parts.get(k, c.field.zero) for k in range(max(parts, default=0) + 1))


def _judge_conservative(
    factor: MonicFactor,
    symbols: FieldSymbols,
    positive: frozenset[str],
    detuning: sp.Symbol | None,
) -> FactorVerdict:
    discriminant = _discriminant(factor)
    criterion = _by_detuning(discriminant, detuning)
    name = "the discriminant of " + _shown(factor, symbols)
    if not discriminant:
        return FactorVerdict(factor, "conservative", (), False, f"{name} vanishes identically")
    if len(criterion) == 3 and sign(criterion[2], frozenset(positive)) == -1:
        p0, p1, p2 = criterion
        inside = p1 * p1 - (p0 * p2).scale(4)
        s = sign(inside, positive)
        if s == -1:
            reason = f"{name} is negative for every detuning: the two modes exchange energy"
        elif s == 1:
            reason = f"{name} is positive in an interval of the detuning: the two modes feed it"
        else:
            reason = f"{name} is positive in an interval of the detuning if {symbols(inside)} > 0"
        return FactorVerdict(
            factor, "conservative", criterion, None if s is None else s > 0, reason
        )
    return FactorVerdict(
        factor, "conservative", criterion, None, f"{name} decides, of degree {len(criterion) - 1}"
    )


def _judge_dissipative(
    factor: MonicFactor, symbols: FieldSymbols, detuning: sp.Symbol | None
) -> FactorVerdict:
    c, b, _ = factor.coefficients
    br, bi, cr, ci = _real(b), _imaginary(b), _real(c), _imaginary(c)
    criterion = ci * ci - br * br * cr - br * bi * ci
    reason = f"{_shown(factor, symbols)} is unstable where {symbols(criterion)} > 0"
    return FactorVerdict(factor, "dissipative", _by_detuning(criterion, detuning), None, reason)


def _shown(factor: MonicFactor, symbols: FieldSymbols) -> str:
    gamma = sp.Symbol("Gamma")
    return str(sp.Add(*(symbols(c) * gamma**k for k, c in enumerate(factor.coefficients))))


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
