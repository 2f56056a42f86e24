"""The leading-order oscillators: one natural frequency per coordinate, or a refusal that says why.

At order zero every equation must read M0 q_j'' + K0 q_j = (hard forcing), with ω_j = √(K0/M0) a
linear form in frequency symbols or a rational number, so that frequencies can be compared exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
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

__all__ = ["GradedTerm", "LinearForm", "graded_terms", "leading_inertias", "leading_order"]

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


def leading_order(
    taylor: Taylor, equations: Sequence[Sequence[GradedTerm]], field: ParameterField
) -> tuple[tuple[Coefficient, ...], tuple[LinearForm, ...]]:
    """Inertias M0 and natural frequencies ω_j of the leading-order oscillators.

    Raises
    ------
    ScalingError
        If an equation does not oscillate at leading order, is coupled, damped, parametrically
        excited or nonlinear there, or has a frequency that is no linear form in symbols.
    """
    inertias, frequencies = [], []
    for j, terms in enumerate(equations):
        mass, stiffness = _own_terms(taylor, terms, field, j)
        inertias.append(mass)
        frequencies.append(_frequency(taylor.coordinates[j], mass, stiffness, field))
    return tuple(inertias), tuple(frequencies)


def leading_inertias(
    taylor: Taylor, equations: Sequence[Sequence[GradedTerm]], field: ParameterField
) -> tuple[Coefficient, ...]:
    """Inertias M0 alone, for equations whose frequencies are known from before the detuning.

    Raises
    ------
    ScalingError
        If an equation is coupled, damped, parametrically excited or nonlinear at leading order, or
        loses its inertia on the resonance.
    """
    inertias = []
    for j, terms in enumerate(equations):
        mass, _ = _own_terms(taylor, terms, field, j)
        if not mass:
            raise _no_inertia(taylor.coordinates[j])
        inertias.append(mass)
    return tuple(inertias)


def _own_terms(
    taylor: Taylor, terms: Sequence[GradedTerm], field: ParameterField, j: int
) -> tuple[Coefficient, Coefficient]:
    """M0 and K0 of equation j, which may hold nothing else at leading order but forcing."""
    mass, stiffness = field.zero, field.zero
    for term in terms:
        if term.order:
            continue
        if term.key == taylor.packing.unit[j]:
            stiffness = term.coefficient
        elif term.key == taylor.packing.unit[2 * len(taylor.coordinates) + j]:
            mass = term.coefficient
        else:
            _check_other(taylor, term.key, j)
    return mass, stiffness


def _no_inertia(q: sp.Expr) -> ScalingError:
    return ScalingError(
        f"the equation of {q} at leading order has no inertia {q}'': nothing oscillates"
    )


def _check_other(taylor: Taylor, key: int, j: int) -> None:
    """Refuse a leading-order term that is neither own inertia, own stiffness nor forcing."""
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
        return
    if len(support) > len(dynamic):
        raise ScalingError(
            f"{where} has the time-dependent coefficient of {shown}: scale the parameter in front "
            "of it with an order of 1 or more"
        )
    if sum(e for _, e in dynamic) > 1:
        raise ScalingError(
            f"{where} is nonlinear, {shown}: scale its parameter, or give the amplitude an order"
        )
    ((i, _),) = dynamic
    kind, other = divmod(i, n)
    if kind == 1 and other == j:
        raise ScalingError(
            f"{where} is damped, {shown}: it does not oscillate freely; scale the damping with an "
            "order of 1 or more"
        )
    raise ScalingError(
        f"{where} is coupled to {coordinate_name(taylor.coordinates[other])} by {shown}: only a "
        "diagonal leading-order part is supported; scale the coupling parameter, or transform to "
        "modal coordinates first"
    )


def _frequency(
    q: sp.Expr, mass: Coefficient, stiffness: Coefficient, field: ParameterField
) -> LinearForm:
    """ω = √(K0/M0) as a linear form in frequency symbols."""
    where = f"the equation of {q} at leading order"
    if not mass:
        raise _no_inertia(q)
    if not stiffness:
        raise ScalingError(
            f"{where} has no stiffness, so {q} does not oscillate: leave its stiffness at order 0"
        )
    ratio = stiffness * mass.inverse()
    if set(ratio.num) != {0}:
        raise ScalingError(f"{where} has the complex stiffness {_plain(ratio)}")
    root = _square_root(ratio, field)
    if root is None:
        if _square_root(-ratio, field) is not None:
            raise ScalingError(
                f"{where} does not oscillate: its stiffness over inertia is {_plain(ratio)} < 0"
            )
        raise ScalingError(
            f"{where} has the squared frequency {_plain(ratio)}, which is not the square of a "
            f"frequency symbol: name the frequency, for example by reparametrise with a new symbol "
            f"omega_{coordinate_name(q)} such that omega_{coordinate_name(q)}**2 = {_plain(ratio)}"
        )
    form: LinearForm = {}
    shown = FieldSymbols(field, {}).polynomial(root)
    for monomial, c in root.to_dict().items():
        names = [n for n, e in zip(field.names, monomial, strict=True) for _ in range(int(e))]
        if len(names) > 1:
            raise ScalingError(
                f"{where} has the frequency {shown}: name it by one symbol (reparametrise)"
            )
        form[names[0] if names else "1"] = Fraction(int(c.p), int(c.q))
    if all(c < 0 for c in form.values()):
        form = {name: -c for name, c in form.items()}
    if any(c < 0 for c in form.values()):
        raise ScalingError(
            f"{where} has the frequency ±({shown}) of undecided sign: name it by one symbol"
        )
    return form


def _square_root(ratio: Coefficient, field: ParameterField) -> fmpq_mpoly | None:
    if ratio.den:
        return None
    try:
        return ratio.num[0].sqrt()
    except (DomainError, ValueError):
        return None


def _plain(ratio: Coefficient) -> str:
    return str(FieldSymbols(ratio.field, {})(ratio))
