"""`Resonance`: an integer relation between frequencies, found from the divisors of an expansion.

Without any relation imposed, the linear factors ω_j ± ν that divide the particular solutions are
the list of possible resonances. A factor that positive frequencies can annul is a candidate. Its
coupling survives if some monomial that is divided by it keeps a coefficient which does not vanish
on the relation; it can vanish because contributions cancel (sums over identical oscillators) or
through a factor of the coefficient.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd, lcm
from typing import Any

import numpy as np
import sympy as sp

from .errors import MmsgenError
from .expressions import FieldSymbols, rational
from .field import Coefficient, ParameterField
from .nonsmooth import check_enumerable
from .numeric import named_values
from .resonance_kind import kind_of
from .series import Form
from .solver import Solver
from .symbols import coordinate_name
from .tables import ResonanceTable
from .weak import WeakSystem

__all__ = ["Resonance", "enumerate_resonances"]


@dataclass(frozen=True)
class Resonance:
    """A resonance that a system can have.

    Attributes
    ----------
    relation : sympy.Eq
        k·(detuned frequency) = linear form in the others.
    kind : str
        Primary, superharmonic, subharmonic, principal parametric, parametric, sum combination,
        difference combination or internal.
    order : int
        The power of ε at which it first appears.
    coordinates : tuple of str
        The coordinates whose equations or amplitudes take part.
    coupled : bool
        Whether the coupling survives on the relation.
    reason : str
        Why the coupling vanishes; empty where it survives.
    """

    relation: sp.Eq
    kind: str
    order: int
    coordinates: tuple[str, ...]
    coupled: bool
    reason: str

    @property
    def mapping(self) -> dict[sp.Expr, sp.Expr]:
        """The relation as `ScaledSystem.expand` takes it."""
        return {self.relation.lhs: self.relation.rhs}

    def distance(self, values: Mapping[Any, Any], parameters: Any) -> float:
        """Distance from resonance in Hz, |lhs − rhs|/2π, at numbers.

        Raises
        ------
        MmsgenError
            If a frequency has no value, or an array of values.
        """
        table = named_values(parameters, values)
        symbols = sorted(self.relation.free_symbols, key=str)
        missing = [str(s) for s in symbols if str(s) not in table]
        if missing:
            raise MmsgenError(
                f"no value is given for {', '.join(missing)}, so the distance from "
                f"{self.relation.lhs} = {self.relation.rhs} is unknown"
            )
        arrays = [str(s) for s in symbols if np.ndim(table[str(s)])]
        if arrays:
            raise MmsgenError(f"resonances are ranked at one point: {arrays[0]} must be a number")
        gap = (self.relation.lhs - self.relation.rhs).subs(
            {s: sp.Float(float(table[str(s)])) for s in symbols}
        )
        return float(abs(gap) / (2 * np.pi))


@dataclass
class _Candidate:
    """What has been seen of one relation."""

    order: int
    coordinates: dict[str, None] = field(default_factory=dict)
    signatures: list[tuple[int, tuple[int, ...]]] = field(default_factory=list)
    survives: bool = False
    reasons: dict[str, None] = field(default_factory=dict)


Relations = dict[Form, _Candidate]


def enumerate_resonances(weak: WeakSystem) -> ResonanceTable:
    """Find every resonance through the order of a system without relations.

    Parameters
    ----------
    weak : WeakSystem
        Made without resonance relations.
    """
    solver = Solver(weak)
    found: Relations = {}
    solver.solve_order_zero()
    check_enumerable(solver)
    for j, forcing in enumerate(weak.forcing):
        for key, c in forcing.items():
            _record(solver, found, 0, j, key, c)
    for p in range(1, weak.order + 1):
        solver.solve_order(p)
        for j, equation in enumerate(solver.equations[p - 1]):
            for key, c in equation.known.items():
                _record(solver, found, p, j, key, c)
            for key in equation.cancelled:
                _record(solver, found, p, j, key, None)
    symbols = [s for s in weak.scaled.frequencies]
    resonances = tuple(
        _resonance(weak, form, candidate, symbols) for form, candidate in found.items()
    )
    ordered = sorted(
        resonances, key=lambda r: (not r.coupled, r.order, _position(r.relation, symbols))
    )
    return ResonanceTable(ordered, tuple(weak.scaled.parameters), complete=weak.scaled.numbers)


def _position(relation: sp.Eq, symbols: list[sp.Symbol]) -> tuple[Any, ...]:
    difference = sp.expand(relation.lhs - relation.rhs)
    return tuple(difference.coeff(s) == 0 for s in symbols), str(relation)


def _record(
    solver: Solver, found: Relations, p: int, j: int, key: int, c: Coefficient | None
) -> None:
    """Enter the candidates that one monomial of one equation gives."""
    ring = solver.ring
    nu, omega = ring.frequency(key), ring.amplitude_frequencies[j]
    if nu == omega or nu == tuple(-x for x in omega):
        return
    for sign in (1, -1):
        form = _normalised(tuple(a - sign * b for a, b in zip(omega, nu, strict=True)))
        if form is None:
            continue
        candidate = found.setdefault(form, _Candidate(order=p))
        survives, reason = _survival(solver, form, c)
        if survives and not candidate.survives:
            candidate.survives, candidate.order = True, p
            candidate.coordinates.clear()
            candidate.signatures.clear()
        elif survives != candidate.survives:
            continue
        exponents = ring.packing.exponents(key)
        names = [coordinate_name(q) for q in solver.weak.scaled.coordinates]
        candidate.coordinates[names[j]] = None
        for i in range(ring.n):
            if exponents[2 * i] or exponents[2 * i + 1]:
                candidate.coordinates[names[i]] = None
        candidate.signatures.append((j, exponents))
        if reason:
            candidate.reasons[reason] = None


def _normalised(form: Form) -> Form | None:
    """The primitive form of a relation that positive frequencies can satisfy; else None.

    The last frequency symbol that takes part, an excitation where there is one, is positive.
    """
    if not (any(c > 0 for c in form) and any(c < 0 for c in form)):
        return None
    if sum(1 for c in form[:-1] if c) == 0:
        return None
    scale = Fraction(
        lcm(*(c.denominator for c in form if c)), gcd(*(c.numerator for c in form if c))
    )
    lead = next(c for c in reversed(form[:-1]) if c)
    factor = scale if lead > 0 else -scale
    return tuple(c * factor for c in form)


def _survival(solver: Solver, form: Form, c: Coefficient | None) -> tuple[bool, str]:
    """Whether a coefficient is non-zero on the relation, and why not."""
    if c is None:
        return False, "its contributions cancel in the sum over the coordinates"
    ring = solver.ring
    index = max(i for i, x in enumerate(form[:-1]) if x)
    value = ring.form_polynomial(
        tuple(Fraction(0) if i == index else -x / form[index] for i, x in enumerate(form))
    )
    name = ring.basis[index]
    if any(_on_relation(ring.field, p, name, value) for p in c.num.values()):
        return True, ""
    factor = _vanishing_factor(solver, c, name, value)
    return False, f"its coefficient has the factor {factor}, which vanishes on the relation"


def _on_relation(field_: ParameterField, p: Any, name: str, value: Any) -> Any:
    images = [value if n == name else g for n, g in field_.gens.items()]
    return p.compose(*images, ctx=field_.ctx)


def _vanishing_factor(solver: Solver, c: Coefficient, name: str, value: Any) -> sp.Expr:
    """The factor of a coefficient that vanishes on the relation."""
    field_ = solver.ring.field
    common = None
    for p in c.num.values():
        common = p if common is None else common.gcd(p)
    assert common is not None
    table = {p.name: p.symbol for p in solver.weak.scaled.parameters}
    symbols = FieldSymbols(field_, table)
    for p, e in common.factor()[1]:
        if not _on_relation(field_, p, name, value):
            return symbols.polynomial(p) ** int(e)
    return symbols(c)


def _resonance(
    weak: WeakSystem, form: Form, candidate: _Candidate, symbols: list[sp.Symbol]
) -> Resonance:
    *coefficients, constant = form
    index = max(i for i, c in enumerate(coefficients) if c)
    lhs = rational(coefficients[index]) * symbols[index]
    rhs = sp.Add(
        *(-rational(c) * s for c, s in zip(coefficients[:index], symbols[:index], strict=True)),
        -rational(constant),
    )
    reason = "" if candidate.survives else "; ".join(candidate.reasons)
    names = [coordinate_name(q) for q in weak.scaled.coordinates]
    return Resonance(
        sp.Eq(lhs, rhs, evaluate=False),
        kind_of(weak, form, candidate.signatures),
        candidate.order,
        tuple(n for n in names if n in candidate.coordinates),
        candidate.survives,
        reason,
    )
