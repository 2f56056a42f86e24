"""`WeakSystem`: oscillators η_j'' + ω_j² η_j + Σ_s ε^s F_{j,s}(q, q', q'', z) = 0, ready to expand.

Each F_{j,s} is a finite sum of products of coordinates and their derivatives, with coefficients
that are series in the phasors z alone. Where the leading order is coupled, the η_j are modal
coordinates (`modes`) and the q_j sums of them; otherwise η_j is q_j.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from .errors import ResonanceError
from .field import Coefficient
from .grading import Detuned, Graded, Grading
from .leading import GradedTerm, LinearForm, in_field, leading_inertias
from .nonsmooth import not_smooth
from .relations import Relation
from .series import Form, HarmonicRing, Series
from .symbols import coordinate_name
from .taylor import Taylor

if TYPE_CHECKING:
    from .scaling import ScaledSystem

__all__ = ["Factors", "WeakSystem", "weak_system"]

Factors = tuple[int, ...]
"""A product of variables, each d·n + j for the d-th derivative of coordinate j, ascending.

With d = 3 and 4 for the signs of coordinate and velocity j.
"""


@dataclass(frozen=True)
class WeakSystem:
    """The truncated equations of one resonance case.

    Attributes
    ----------
    scaled : ScaledSystem
        What it was made from.
    order : int
        Highest order kept.
    relations : tuple of Relation
    ring : HarmonicRing
        Frequencies are linear forms in the symbols left after the relations.
    forces : tuple of dict
        For each equation: product of variables → order in ε → series in the phasors.
    forcing : tuple of Series
        The forcing of order zero (hard forcing), for each equation.
    rates : dict
        Index of a phasor → D1 z / z = iσ.
    free_frequency : tuple of LinearForm
        For each variable a_j, then each phasor: its frequency before the relations are imposed.
    detuned : mapping
        Each frequency symbol that a relation has eliminated: its resonant value and detuning.
    """

    scaled: ScaledSystem
    order: int
    relations: tuple[Relation, ...]
    ring: HarmonicRing
    forces: tuple[dict[Factors, dict[int, Series]], ...]
    forcing: tuple[Series, ...]
    rates: dict[int, Coefficient]
    free_frequency: tuple[LinearForm, ...]
    detuned: Mapping[str, Detuned]
    basis: ModalBasis | None = None


@dataclass(frozen=True)
class ModalBasis:
    """Coordinates as sums of modes, in the coefficient field of a weak system.

    Attributes
    ----------
    shapes : tuple
        For each coordinate (mode, Φ, Θ): q = Σ (Φ η + Θ s).
    projections : tuple
        For each mode (equation, Φ·d, Θ·d): the part of F that drives it.
    frequencies, inverses : tuple of dict
        Order in ε → coefficient of ω and 1/ω of each mode, which a detuning makes series.
    squares : tuple of dict
        Order in ε ≥ 1 → coefficient of ω², where it does not stand among the forces.
    gyroscopic : bool
        Whether any Θ is there.
    """

    shapes: tuple[tuple[tuple[int, Coefficient, Coefficient], ...], ...]
    projections: tuple[tuple[tuple[int, Coefficient, Coefficient], ...], ...]
    frequencies: tuple[Graded, ...]
    squares: tuple[Graded, ...]
    inverses: tuple[Graded, ...]
    gyroscopic: bool


def _detuned_form(form: LinearForm, detuned: Mapping[str, Detuned]) -> LinearForm:
    """A linear form on resonance."""
    result: LinearForm = {}
    for name, c in form.items():
        value = detuned[name].resonant if name in detuned else {name: Fraction(1)}
        for k, v in value.items():
            result[k] = result.get(k, Fraction(0)) + c * v
    return {k: c for k, c in result.items() if c}


def weak_system(
    scaled: ScaledSystem,
    taylor: Taylor,
    equations: Sequence[Sequence[GradedTerm]],
    grading: Grading,
    relations: tuple[Relation, ...],
    detuned: Mapping[str, Detuned],
) -> WeakSystem:
    """Divide each equation by its inertia and sort its terms.

    Raises
    ------
    ScalingError
        As for `leading_inertias`.
    ResonanceError
        If the relations leave a frequency that is not positive.
    """
    natural = [_detuned_form(form, detuned) for form in scaled.natural_frequencies]
    inertias = _inertias(scaled, taylor, equations, grading)
    phasors = [
        {str(p.base) if p.base == 1 else str(p.base.name): p.step} if p.moving else {}
        for p in scaled.alphabet.phasors
    ]
    resonant = [_detuned_form(form, detuned) for form in phasors]
    for form in (*natural, *(f for f, p in zip(resonant, phasors, strict=True) if p)):
        if not any(c > 0 for c in form.values()):
            raise ResonanceError("the relations leave a frequency that is not positive")
    names = [str(s.name) for s in scaled.frequencies if s.name not in detuned]

    def as_form(form: LinearForm) -> Form:
        return (*(form.get(b, Fraction(0)) for b in names), form.get("1", Fraction(0)))

    ring = HarmonicRing(
        grading.field,
        names,
        [as_form(f) for f in natural],
        [as_form(f) for f in resonant],
        moduli=scaled.alphabet.kinked,
    )
    forces, forcing = [], []
    for j, terms in enumerate(equations):
        force, hard = _sort(taylor, terms, ring, inertias[j].inverse(), j, grading.order)
        forces.append(force)
        forcing.append(hard)
    basis = _modal_basis(scaled, ring, grading, forces)
    rates = {}
    for m, form in enumerate(phasors):
        rate = {
            k: c * v
            for name, c in form.items()
            if name in detuned
            for k, v in detuned[name].detuning.items()
        }
        if any(rate.values()):
            rates[m] = grading.field.polynomial(grading.field.linear(rate)).times_i()
    return WeakSystem(
        scaled,
        grading.order,
        relations,
        ring,
        tuple(forces),
        tuple(forcing),
        rates,
        (*scaled.natural_frequencies, *phasors),
        dict(detuned),
        basis,
    )


def _inertias(
    scaled: ScaledSystem,
    taylor: Taylor,
    equations: Sequence[Sequence[GradedTerm]],
    grading: Grading,
) -> list[Coefficient]:
    """What each equation is divided by: its inertia, or 1 where modes see to that."""
    modes = scaled.modes
    coupled = {j for component in modes.components for j in component.members}
    plain = leading_inertias(taylor, equations, [not named for named in modes.named])
    result = []
    for j, own in enumerate(plain):
        if own is not None:
            result.append(own)
        elif j in coupled:
            result.append(grading.field.one)
        else:
            result.append(_fixed(scaled, modes.part.inertia[j, j], grading))
    return result


def _fixed(scaled: ScaledSystem, c: Coefficient, grading: Grading) -> Coefficient:
    """A coefficient of the leading order, which a detuning may not change."""
    graded = grading(in_field(c, scaled.alphabet.field))
    if set(graded) != {0}:
        raise ResonanceError(
            "a frequency that the relations detune stands in the inertia of an oscillator whose "
            "frequency has no symbol of its own: name that frequency (reparametrise)"
        )
    return graded[0]


def _modal_basis(
    scaled: ScaledSystem,
    ring: HarmonicRing,
    grading: Grading,
    forces: list[dict[Factors, dict[int, Series]]],
) -> ModalBasis | None:
    """The sums of modes, or None; detuned frequencies with a name enter the forces if they can."""
    modes, source, one, zero = scaled.modes, scaled.alphabet.field, ring.field.one, ring.field.zero
    coupled = {j for component in modes.components for j in component.members}
    omegas = [_series(scaled, form) for form in scaled.natural_frequencies]
    squares: list[Graded] = [{} for _ in omegas]
    for j, named in enumerate(modes.named):
        if not named:
            continue
        square = grading(omegas[j] * omegas[j])
        later = {order: c for order, c in square.items() if order}
        if j in coupled:
            squares[j] = later
            continue
        for order, c in later.items():
            by_order = forces[j].setdefault((j,), {})
            by_order[order] = ring.add(by_order.get(order, {}), {0: c})
    if not coupled:
        return None

    def value(name: str | None) -> Coefficient:
        return zero if name is None else grading(source.generator(name))[0]

    shapes = tuple(
        tuple((r, value(re) if j in coupled else one, value(im)) for r, re, im in parts)
        for j, parts in enumerate(modes.shapes)
    )
    factors = [one] * len(shapes)
    for component in modes.components:
        for j, d in zip(component.members, component.multipliers, strict=True):
            factors[j] = _fixed(scaled, d, grading)
    projections: list[list[tuple[int, Coefficient, Coefficient]]] = [[] for _ in shapes]
    for j, parts in enumerate(shapes):
        for r, real, imaginary in parts:
            projections[r].append((j, factors[j] * real, factors[j] * imaginary))
    return ModalBasis(
        shapes,
        tuple(map(tuple, projections)),
        tuple(grading(omega) for omega in omegas),
        tuple(squares),
        tuple(grading(omega.inverse()) for omega in omegas),
        any(imaginary for parts in shapes for *_, imaginary in parts),
    )


def _series(scaled: ScaledSystem, form: LinearForm) -> Coefficient:
    """A frequency as a coefficient, before it is detuned."""
    source = scaled.alphabet.field
    symbols = {name: c for name, c in form.items() if name != "1"}
    return source.polynomial(source.linear(symbols, form.get("1", Fraction(0))))


def _sort(
    taylor: Taylor,
    terms: Sequence[GradedTerm],
    ring: HarmonicRing,
    over_inertia: Coefficient,
    j: int,
    highest: int,
) -> tuple[dict[Factors, dict[int, Series]], Series]:
    """The terms of one equation by product of variables and order, without q_j'' + ω_j² q_j."""
    n = len(taylor.coordinates)
    force: dict[Factors, dict[int, Series]] = {}
    hard: Series = {}
    leading = (taylor.packing.unit[j], taylor.packing.unit[2 * n + j])
    for term in terms:
        exponents = taylor.packing.exponents(term.key)
        z = ring.z(exponents[taylor.dynamic :])
        c = term.coefficient * over_inertia
        if term.order == 0:
            if term.key not in leading:
                hard[z] = c
            continue
        factors = tuple(i for i in range(taylor.dynamic) for _ in range(exponents[i]))
        if factors and factors[-1] >= 3 * n and term.order < highest:
            raise not_smooth(taylor.show(term.key), coordinate_name(taylor.coordinates[j]), highest)
        force.setdefault(factors, {}).setdefault(term.order, {})[z] = c
    return force, hard
