"""`WeakSystem`: oscillators q_j'' + ω_j² q_j + Σ_s ε^s F_{j,s}(q, q', q'', z) = 0, ready to expand.

Each F_{j,s} is a finite sum of products of coordinates and their derivatives, with coefficients
that are series in the phasors z alone.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from .errors import ResonanceError
from .field import Coefficient
from .grading import Detuned, Grading
from .leading import GradedTerm, LinearForm, leading_inertias
from .relations import Relation
from .series import Form, HarmonicRing, Series
from .taylor import Taylor

if TYPE_CHECKING:
    from .scaling import ScaledSystem

__all__ = ["Factors", "WeakSystem", "weak_system"]

Factors = tuple[int, ...]
"""A product of variables, each d·n + j for the d-th derivative of coordinate j, ascending."""


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
    inertias = leading_inertias(taylor, equations, grading.field)
    phasors = [
        {str(p.base) if p.base == 1 else str(p.base.name): p.step} if p.moving else {}
        for p in scaled.alphabet.phasors
    ]
    resonant = [_detuned_form(form, detuned) for form in phasors]
    for form in (*natural, *(f for f, p in zip(resonant, phasors, strict=True) if p)):
        if not any(c > 0 for c in form.values()):
            raise ResonanceError("the relations leave a frequency that is not positive")
    basis = [str(s.name) for s in scaled.frequencies if s.name not in detuned]

    def as_form(form: LinearForm) -> Form:
        return (*(form.get(b, Fraction(0)) for b in basis), form.get("1", Fraction(0)))

    ring = HarmonicRing(
        grading.field, basis, [as_form(f) for f in natural], [as_form(f) for f in resonant]
    )
    forces, forcing = [], []
    for j, terms in enumerate(equations):
        force, hard = _sort(taylor, terms, ring, inertias[j].inverse(), j)
        forces.append(force)
        forcing.append(hard)
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
    )


def _sort(
    taylor: Taylor,
    terms: Sequence[GradedTerm],
    ring: HarmonicRing,
    over_inertia: Coefficient,
    j: int,
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
        force.setdefault(factors, {}).setdefault(term.order, {})[z] = c
    return force, hard
