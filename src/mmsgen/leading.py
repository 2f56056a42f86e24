"""The leading order: what the equations hold at order zero, or a refusal that says why.

At order zero the equations must read M0 q'' + G0 q' + K0 q = (hard forcing). The frequency of a
single oscillator, ω = √(K0/M0), is a linear form in frequency symbols or a rational number where it
can be, so that frequencies can be compared exactly; every other frequency gets a name (`modes`).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp
from flint import fmpq_mpoly
from flint.utils.flint_exceptions import DomainError

from .errors import ScalingError
from .expressions import FieldSymbols
from .field import Coefficient, ParameterField
from .grading import Grading
from .symbols import coordinate_name
from .taylor import Polynomial, Taylor

__all__ = [
    "Entries",
    "GradedTerm",
    "LeadingPart",
    "LinearForm",
    "at_leading_order",
    "frequency_form",
    "graded_terms",
    "in_field",
    "leading_inertias",
    "leading_part",
    "no_inertia",
]

Entries = dict[tuple[int, int], Coefficient]
"""(row, column) → non-zero entry of a matrix."""

LinearForm = dict[str, Fraction]
"""Name of a frequency symbol, or ``"1"`` → rational coefficient."""


@dataclass(frozen=True)
class GradedTerm:
    """One term of one equation: ε^order · coefficient · monomial in (q, q', q'', z)."""

    order: int
    key: int
    coefficient: Coefficient


def graded_terms(
    taylor: Taylor, polynomial: Polynomial, grading: Grading, equation: int
) -> list[GradedTerm]:
    """The terms of one equation, each split by its order in ε.

    The equation is divided by the order of the amplitude of its own coordinate.

    Raises
    ------
    ScalingError
        If a term is of a negative or fractional order.
    """
    own = taylor.weights[equation]
    terms = []
    for key, c in polynomial.items():
        shift = taylor.weight(key) - own
        for k, part in grading(c).items():
            order = k + shift
            if order > grading.order:
                continue
            where = f"in the equation of {taylor.coordinates[equation]}, {taylor.show(key)}"
            if order.denominator != 1:
                raise ScalingError(
                    f"{where} is of the fractional order ε^({order}): choose amplitude orders so "
                    "that all exponents are whole numbers"
                )
            if order < 0:
                coefficient = FieldSymbols(c.field, {})(c)
                raise ScalingError(
                    f"{where} with the coefficient {coefficient} is of order ε^({order}), larger "
                    "than the leading order, and cannot be expanded: give a "
                    "parameter in its coefficient a higher order, or the amplitude a lower one"
                )
            terms.append(GradedTerm(int(order), key, part))
    return terms


def at_leading_order(c: Coefficient, small: Collection[str]) -> Coefficient:
    """A coefficient with all small generators zero."""
    images = [0 * g if name in small else g for name, g in c.field.gens.items()]
    return _image(c, c.field, images)


def in_field(c: Coefficient, target: ParameterField) -> Coefficient:
    """A coefficient in another field, which has all generators that occur in it."""
    missing = target.ctx.constant(0)
    return _image(c, target, [target.gens.get(name, missing) for name in c.field.names])


def _image(c: Coefficient, target: ParameterField, images: list[fmpq_mpoly]) -> Coefficient:
    num = {k: p.compose(*images, ctx=target.ctx) for k, p in c.num.items()}
    result = Coefficient(target, {k: p for k, p in num.items() if p}, {})
    for m, e in c.den.items():
        divisor = c.field.divisors[m].compose(*images, ctx=target.ctx)
        result = result * target.reciprocal(divisor) ** e
    return result


@dataclass(frozen=True)
class LeadingPart:
    """M0 q'' + G0 q' + K0 q, what the equations hold at leading order besides forcing.

    Attributes
    ----------
    stiffness, gyroscopic, inertia : dict
        (equation, coordinate) → non-zero coefficient.
    """

    stiffness: Entries
    gyroscopic: Entries
    inertia: Entries

    def keys(self, taylor: Taylor) -> dict[tuple[int, int], Coefficient]:
        """(equation, packed monomial) → coefficient."""
        n = len(taylor.coordinates)
        return {
            (j, taylor.packing.unit[d * n + i]): c
            for d, entries in enumerate((self.stiffness, self.gyroscopic, self.inertia))
            for (j, i), c in entries.items()
        }


def leading_part(taylor: Taylor, equations: Sequence[Sequence[GradedTerm]]) -> LeadingPart:
    """The linear part of order zero of all equations.

    Raises
    ------
    ScalingError
        If an equation is damped, parametrically excited or nonlinear at leading order, or the
        origin is no equilibrium.
    """
    n = len(taylor.coordinates)
    parts: tuple[Entries, Entries, Entries] = ({}, {}, {})
    for j, terms in enumerate(equations):
        for term in terms:
            if term.order or not term.coefficient:
                continue
            place = _linear_place(taylor, term.key, j)
            if place is not None:
                kind, i = divmod(place, n)
                parts[kind][j, i] = term.coefficient
    return LeadingPart(*parts)


def leading_inertias(
    taylor: Taylor, equations: Sequence[Sequence[GradedTerm]], plain: Sequence[bool]
) -> tuple[Coefficient | None, ...]:
    """Inertias M0 of the plain oscillators, whose frequencies are known from before the detuning.

    Parameters
    ----------
    plain : sequence of bool
        For each equation, whether it is an oscillator of its own in the user's symbols; of the
        others no linear part of order zero is left.

    Raises
    ------
    ScalingError
        As for `leading_part`, or if an equation is coupled or loses its inertia on the resonance.
    """
    part = leading_part(taylor, equations)
    for (j, i), _ in (*part.stiffness.items(), *part.gyroscopic.items(), *part.inertia.items()):
        if i != j or not plain[j]:
            raise ScalingError(
                f"the equation of {taylor.coordinates[j]} at leading order is coupled to "
                f"{coordinate_name(taylor.coordinates[i])} on the resonance only: scale the "
                "coupling parameter"
            )
    inertias: list[Coefficient | None] = []
    for j, own in enumerate(plain):
        if own and (j, j) not in part.inertia:
            raise no_inertia(taylor.coordinates[j])
        inertias.append(part.inertia[j, j] if own else None)
    return tuple(inertias)


def no_inertia(q: sp.Expr) -> ScalingError:
    """The error for an equation in which nothing oscillates."""
    return ScalingError(
        f"the equation of {q} at leading order has no inertia {q}'': nothing oscillates"
    )


def _linear_place(taylor: Taylor, key: int, j: int) -> int | None:
    """The variable of a linear leading-order term, None for forcing; anything else is refused."""
    n = len(taylor.coordinates)
    support = taylor.packing.support(key)
    dynamic = [(i, e) for i, e in support if i < taylor.dynamic]
    where = f"the equation of {taylor.coordinates[j]} at leading order"
    shown = taylor.show(key)
    if not dynamic:
        if not support:
            raise ScalingError(
                f"{where} has a constant force: the origin is no equilibrium; shift the "
                "coordinates to it"
            )
        return None
    if len(support) > len(dynamic):
        raise ScalingError(
            f"{where} has the time-dependent coefficient of {shown}: scale the parameter in front "
            "of it with an order of 1 or more"
        )
    if sum(e for _, e in dynamic) > 1 or any(i >= 3 * n for i, _ in dynamic):
        raise ScalingError(
            f"{where} is nonlinear, {shown}: scale its parameter, or give the amplitude an order"
        )
    ((i, _),) = dynamic
    if i == n + j:
        raise ScalingError(
            f"{where} is damped, {shown}: it does not oscillate freely; scale the damping with an "
            "order of 1 or more"
        )
    return i


def frequency_form(
    q: sp.Expr, mass: Coefficient | None, stiffness: Coefficient | None, field: ParameterField
) -> tuple[LinearForm | None, Coefficient]:
    """ω = √(K0/M0) of a single oscillator as a linear form in frequency symbols.

    Returns
    -------
    form : dict or None
        None where the frequency is no linear form with positive coefficients, and needs a name.
    ratio : Coefficient
        K0/M0.

    Raises
    ------
    ScalingError
        If it does not oscillate.
    """
    where = f"the equation of {q} at leading order"
    if not mass:
        raise no_inertia(q)
    if not stiffness:
        raise ScalingError(
            f"{where} has no stiffness, so {q} does not oscillate: leave its stiffness at order 0"
        )
    ratio = stiffness * mass.inverse()
    shown = FieldSymbols(ratio.field, {})(ratio)
    if set(ratio.num) != {0}:
        raise ScalingError(f"{where} has the complex stiffness {shown}")
    if _square_root(-ratio, field) is not None:
        raise ScalingError(f"{where} does not oscillate: its stiffness over inertia is {shown} < 0")
    root = _square_root(ratio, field)
    if root is None:
        return None, ratio
    form = _linear(root, field)
    if form is not None and any(c < 0 for c in form.values()):
        raise ScalingError(
            f"{where} has the frequency ±({FieldSymbols(field, {}).polynomial(root)}) of undecided "
            "sign: name it by one symbol (reparametrise)"
        )
    return form, ratio


def _linear(root: fmpq_mpoly, field: ParameterField) -> LinearForm | None:
    """A polynomial as a linear form, positive where it has one sign; None where it is none."""
    form: LinearForm = {}
    for monomial, c in root.to_dict().items():
        names = [n for n, e in zip(field.names, monomial, strict=True) for _ in range(int(e))]
        if len(names) > 1:
            return None
        form[names[0] if names else "1"] = Fraction(int(c.p), int(c.q))
    if all(c < 0 for c in form.values()):
        form = {name: -c for name, c in form.items()}
    return form


def _square_root(ratio: Coefficient, field: ParameterField) -> fmpq_mpoly | None:
    if ratio.den:
        return None
    try:
        return ratio.num[0].sqrt()
    except (DomainError, ValueError):
        return None
