"""The motion as a uniform approximation: coordinates from amplitudes, with all their harmonics.

    q_j(t) = Re Σ_m c_m Π_k B_k^{r_k} B̄_k^{s_k} e^{iθ_m t},
    θ_m = Σ_k (r_k − s_k)(ω_k + λ_k) + Σ_l h_l Ω_l,

the sum over the terms of all particular solutions q_{j,p}, 0 ≤ p ≤ N: those that the recursion uses
and, of the last order, those that follow from what is known there. Of two terms that are conjugate
to each other one is kept, with twice its coefficient. A slow flow of order N leaves an error of
O(ε^N) over times of order 1/ε, in the phases above all; the harmonics of order N are what a steady
motion needs besides.

References
----------
A. H. Nayfeh, *Introduction to Perturbation Techniques* (1981), chapters 4 to 6.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy as sp

from .errors import ExpansionError
from .nonsmooth import check_finite
from .series import Series
from .solver import Solver

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["UniformMotion", "UniformTerm", "uniform_motion"]


@dataclass(frozen=True)
class UniformTerm:
    """One harmonic of one coordinate.

    Attributes
    ----------
    order : int
        Power of ε at which it appears.
    coordinate : int
    exponents : tuple of int
        r_1, s_1, t_1, r_2, … of B, B̄ and |B|.
    harmonics : tuple of int
        Multiples of the excitations' frequencies.
    coefficient : sympy.Expr
        Complex; constant phases of excitations are in it.
    """

    order: int
    coordinate: int
    exponents: tuple[int, ...]
    harmonics: tuple[int, ...]
    coefficient: sp.Expr


@dataclass(frozen=True)
class UniformMotion:
    """The coordinates of a case as functions of its amplitudes and of the time.

    Attributes
    ----------
    n : int
        Number of coordinates.
    terms : tuple of UniformTerm
        By order, coordinate and exponents.
    frequencies : tuple of sympy.Expr
        ω_j + λ_j of the amplitudes, B_j being at rest in the autonomous frame, or ω_j where there
        is no such frame; then those of the excitations.
    """

    n: int
    terms: tuple[UniformTerm, ...]
    frequencies: tuple[sp.Expr, ...]


def coordinate_series(case: Expansion) -> list[list[Series]]:
    """q_{j,p} by order p = 0 … N and coordinate j; of non-smooth forces without the last order."""
    solver = case.solver
    try:
        check_finite(case.weak, "the particular solution")
    except ExpansionError:
        return solver.q[: case.order]
    if solver.modal is None:
        last = [solver.particular(j, e) for j, e in enumerate(solver.equations[-1])]
        return [*solver.q[: case.order], last]
    again = Solver(case.weak)  # where modes are coupled, their velocities are needed as well
    again.solve_order_zero()
    for p in range(1, case.order + 1):
        again.solve_order(p)
    return again.q


def uniform_motion(case: Expansion) -> UniformMotion:
    """Collect the harmonics of all coordinates.

    Parameters
    ----------
    case : Expansion
    """
    ring, phasors = case.weak.ring, case.weak.scaled.alphabet.phasors
    n = ring.n
    moving = [m for m, p in enumerate(phasors) if p.moving]
    terms = []
    for order, parts in enumerate(coordinate_series(case)):
        for j, series in enumerate(parts):
            table: dict[tuple[tuple[int, ...], tuple[int, ...]], list[sp.Expr]] = {}
            for key in sorted(series):
                e, moduli, turns = ring.packing.exponents(key), ring.moduli(key), ring.phasors(key)
                exponents = tuple(x for k in range(n) for x in (e[2 * k], e[2 * k + 1], moduli[k]))
                harmonics = tuple(turns[m] for m in moving)
                mirrored = _mirrored(exponents, harmonics)
                if (exponents, harmonics) < mirrored:
                    continue
                twice = 1 if (exponents, harmonics) == mirrored else 2
                turned = twice * sp.exp(sp.I * case.constant_phase(key))
                value = case.symbols(series[key]) * turned
                table.setdefault((exponents, harmonics), []).append(value)
            terms += [UniformTerm(order, j, *key, sp.Add(*table[key])) for key in sorted(table)]
    return UniformMotion(n, tuple(terms), _frequencies(case, moving))


def _mirrored(
    exponents: tuple[int, ...], harmonics: tuple[int, ...]
) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """The exponents of the complex conjugate."""
    triples = (exponents[k : k + 3] for k in range(0, len(exponents), 3))
    swapped = tuple(x for r, s, t in triples for x in (s, r, t))
    return swapped, tuple(-h for h in harmonics)


def _frequencies(case: Expansion, moving: list[int]) -> tuple[sp.Expr, ...]:
    ring, flow = case.weak.ring, case.slow_flow
    found = []
    for j, form in enumerate(ring.amplitude_frequencies):
        own = case.symbols.polynomial(ring.form_polynomial(form))
        found.append(own if flow.frame is None else own + flow.frame_rate(j))
    for m in moving:
        key = ring.z(int(k == m) for k in range(ring.m))
        own = case.symbols.polynomial(ring.form_polynomial(ring.frequency(key)))
        found.append(own + case.detuning_phase(key))
    return tuple(found)
