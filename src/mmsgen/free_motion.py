"""`FreePart`: a slow flow without the forces and the damping, for its normal modes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from .amplitude_flow import AmplitudeFlow, symmetries
from .errors import MmsgenError
from .numeric import Evaluator
from .runtime._flow import Flow
from .runtime._modes import in_the_open, modes_of
from .runtime._nonlinear import checked_amplitude
from .runtime._records import Backbone

if TYPE_CHECKING:
    from .slowflow import SlowFlow

__all__ = ["FreePart", "free_part", "normal_modes"]


@dataclass(frozen=True)
class FreePart:
    """The terms of a slow flow that no force brings in, in a frame that no force turns.

    Attributes
    ----------
    table : AmplitudeFlow
        Without damping, and without the detunings of forces.
    frame : tuple of sympy.Expr
        Rates λ_j at which the frame turns.
    forced : tuple of sympy.Symbol
        Detunings of forces.
    pull : tuple of sympy.Rational
        dλ_j by the one detuning of a force; none where there is no such detuning, or several.
    """

    table: AmplitudeFlow
    frame: tuple[sp.Expr, ...]
    forced: tuple[sp.Symbol, ...]
    pull: tuple[sp.Rational, ...]


def free_part(slow: SlowFlow) -> FreePart:
    """Leave out the terms of forces and the damping.

    Of a coefficient the imaginary part stays: the other is that of damping, and of its products
    with what is conservative. A real coefficient of a term that phases enter stays too; it may be
    gyroscopic.

    Raises
    ------
    ExpansionError
        If no frame makes the slow flow autonomous.
    """
    case, ring = slow.case, slow.case.weak.ring
    n, own = ring.n, ring.amplitude_frequencies
    frame = [slow.frame_rate(j) for j in range(n)]
    found: dict[tuple[int, tuple[int, ...]], list[sp.Expr]] = {}
    for j in range(n):
        for key in sorted(slow.rates[j]):
            e, moduli = ring.packing.exponents(key), ring.moduli(key)
            turns = [e[2 * k] - e[2 * k + 1] - (k == j) for k in range(n)]
            forms = zip(*(tuple(t * x for x in w) for t, w in zip(turns, own, strict=True)))
            if any(sum(form) for form in forms):
                continue  # a force makes up for the difference
            powers = tuple(x for k in range(n) for x in (e[2 * k], e[2 * k + 1], moduli[k]))
            real, imaginary = case.symbols.real_imaginary(slow.rates[j][key])
            if any(turns) and imaginary == 0:
                value = real * sp.exp(sp.I * case.constant_phase(key))
            else:
                value = sp.I * imaginary * sp.exp(sp.I * case.constant_phase(key))
            if value != 0:
                found.setdefault((j, powers), []).append(value)
    invariant = symmetries(n, tuple(sorted(found)))
    inside = set().union(*(x.free_symbols for parts in found.values() for x in parts))
    forced, pull = _forces(slow, frame, invariant, inside)
    still = dict.fromkeys(forced, sp.Integer(0))
    for j in range(n):
        plain = (j, tuple(int(k == 3 * j) for k in range(3 * n)))
        found.setdefault(plain, []).append(-sp.I * frame[j].xreplace(still))
    terms = tuple(sorted(found))
    coefficients = tuple(sp.Add(*found[term]) for term in terms)
    table = AmplitudeFlow(Flow(n, terms, invariant), coefficients, case.parameters)
    return FreePart(table, tuple(x.xreplace(still) for x in frame), forced, pull)


def _forces(
    slow: SlowFlow,
    frame: list[sp.Expr],
    invariant: tuple[tuple[int, ...], ...],
    inside: set[sp.Symbol],
) -> tuple[tuple[sp.Symbol, ...], tuple[sp.Rational, ...]]:
    """Detunings that do nothing to free motions but turn the frame along their symmetries."""
    forced, pulls = [], []
    known = sp.Matrix(len(invariant), len(frame), [x for k in invariant for x in k])
    for relation in slow.case.relations:
        pull = [x.coeff(relation.detuning) for x in frame]
        if relation.detuning in inside or not any(pull):
            continue
        if known.rank() == known.col_join(sp.Matrix([pull])).rank():
            forced.append(relation.detuning)
            pulls.append(tuple(pull))
    return tuple(forced), pulls[0] if len(pulls) == 1 else ()


def normal_modes(free: FreePart, values: Mapping[str, Any], amplitude: Any, of: int) -> Backbone:
    """Free motions in which one amplitude is given, at numbers.

    Parameters
    ----------
    free : FreePart
    values : mapping
        Name → number or array, all broadcasting.
    amplitude : array_like
    of : int
        Which amplitude that is.

    Raises
    ------
    MmsgenError
        If a value is missing, the amplitude is not a finite number, or negative, or energy is not
        conserved.
    """
    frame = Evaluator(free.frame, free.table.parameters)
    try:
        c = free.table.numbers(values)
        a = checked_amplitude(amplitude, (c.shape[:-1],))
        found = modes_of(free.table.flow, c, a, of)
    except MmsgenError:
        raise
    except ValueError as error:
        raise MmsgenError(str(error)) from None
    pull = np.array([float(x) for x in free.pull])
    turn = np.stack(np.broadcast_arrays(*frame(values)), axis=-1)[..., None, :]
    return in_the_open(found, turn, pull)
