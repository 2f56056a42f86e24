"""`Expansion`: a solved case and its formulas.

The recursion itself is in `solver`; here its particular solutions, secular terms and solvability
conditions become SymPy expressions in the user's symbols.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import sympy as sp

from .errors import ExpansionError, ResonanceError
from .expressions import FieldSymbols, rational, series_expression
from .nonsmooth import check_finite
from .parameters import Parameter
from .relations import Relation
from .residual import residual_series
from .slowflow import SlowFlow, slow_flow
from .solver import Solver
from .symbols import amplitude, coordinate_name, epsilon, time_scale
from .weak import WeakSystem

__all__ = ["Expansion", "expand"]


@dataclass(frozen=True)
class Expansion:
    """A solved case: the solvability conditions D_p A_j for one set of resonance relations.

    Attributes
    ----------
    weak : WeakSystem
        The scaled equations with the relations imposed.
    solver : Solver
        Particular solutions and solvability conditions in the sparse algebra.
    """

    weak: WeakSystem
    solver: Solver

    def __repr__(self) -> str:
        relations = ", ".join(f"{r.lhs} = {r.rhs} + {r.detuning}" for r in self.relations)
        names = ", ".join(coordinate_name(q) for q in self.coordinates)
        return f"Expansion({relations or 'no resonance'}; order {self.order}; {names})"

    @property
    def order(self) -> int:
        """Highest power of ε in the solvability conditions."""
        return self.weak.order

    @property
    def relations(self) -> tuple[Relation, ...]:
        """The resonance relations of the case, with their detunings."""
        return self.weak.relations

    @property
    def coordinates(self) -> tuple[sp.Expr, ...]:
        """q_j(t), or modal coordinates η_j(t) where the leading order couples the q_j."""
        return tuple(self.weak.scaled.coordinates)

    @property
    def amplitudes(self) -> tuple[sp.Symbol, ...]:
        """A_j, in the order of the coordinates."""
        return tuple(amplitude(q) for q in self.coordinates)

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters of the equations and of their modes, then one for each detuning."""
        sigmas = (
            Parameter(r.detuning, "rad/s", f"detuning, {r.lhs} = {r.rhs} + {r.detuning}")
            for r in self.relations
        )
        return (*self.weak.scaled.parameters, *sigmas)

    def numbers(self, values: Mapping[Any, Any]) -> dict[str, Any]:
        """Values by name, with those that follow; see `ScaledSystem.numbers`."""
        scaled = self.weak.scaled
        return scaled.numbers(values, self.parameters[len(scaled.parameters) :])

    @cached_property
    def symbols(self) -> FieldSymbols:
        """The coefficient field in the user's symbols."""
        roots = self.weak.scaled.alphabet.roots
        table = {p.name: p.symbol ** sp.Rational(1, roots.get(p.name, 1)) for p in self.parameters}
        return FieldSymbols(self.weak.ring.field, table)

    def detuning_phase(self, key: int) -> sp.Expr:
        """The slow phase of the phasors in a monomial, over t; constant phases included over 1."""
        moving = sp.Integer(0)
        for m, k in enumerate(self.weak.ring.phasors(key)):
            if k and m in self.weak.rates:
                moving += k * self.symbols(self.weak.rates[m].times_i(-1))
        return moving

    def phase_key(self, key: int) -> int:
        """The constant phases of a monomial as a monomial of their own."""
        ring, phasors = self.weak.ring, self.weak.scaled.alphabet.phasors
        pairs = zip(phasors, ring.phasors(key), strict=True)
        return ring.z(0 if p.moving else k for p, k in pairs)

    def constant_phase(self, key: int) -> sp.Expr:
        """The constant phases in a monomial."""
        ring, phasors = self.weak.ring, self.weak.scaled.alphabet.phasors
        pairs = zip(phasors, ring.phasors(key), strict=True)
        return sp.Add(*(k * p.angle for p, k in pairs if k and not p.moving))

    def amplitude_monomial(self, key: int) -> sp.Expr:
        """The amplitudes of a monomial, with their conjugates and moduli."""
        exponents = self.weak.ring.packing.exponents(key)
        factors = [
            (sp.conjugate(a) if i else a) ** exponents[2 * j + i]
            for j, a in enumerate(self.amplitudes)
            for i in (0, 1)
        ]
        sizes = zip(self.amplitudes, self.weak.ring.moduli(key), strict=True)
        return sp.Mul(*factors, *(sp.Abs(a) ** t for a, t in sizes))

    def slow_monomial(self, key: int) -> sp.Expr:
        """A monomial without its fast phase: amplitudes and e^{iσt}."""
        time = self.weak.scaled.eom.time
        angle = self.detuning_phase(key) * time + self.constant_phase(key)
        return self.amplitude_monomial(key) * sp.exp(sp.I * angle)

    def fast_monomial(self, key: int) -> sp.Expr:
        """A monomial with its fast phase e^{iνT0} at exact resonance."""
        ring = self.weak.ring
        frequency = self.symbols.polynomial(ring.form_polynomial(ring.frequency(key)))
        return self.slow_monomial(key) * sp.exp(sp.I * frequency * time_scale(0))

    @cached_property
    def solvability(self) -> dict[int, dict[sp.Symbol, sp.Expr]]:
        """D_p A_j for p = 1 … order: {p: {A_j: expression}}."""
        return {
            p: {
                a: series_expression(
                    self.weak.ring, self.solver.g[p][j], self.symbols, self.slow_monomial
                )
                for j, a in enumerate(self.amplitudes)
            }
            for p in range(1, self.order + 1)
        }

    def particular(self, p: int) -> dict[sp.Expr, sp.Expr]:
        """The particular solutions q_{j,p}, 0 ≤ p < order, as {q_j: expression in T_0}."""
        if not 0 <= p < self.order:
            raise ExpansionError(f"particular solutions exist for orders 0 to {self.order - 1}")
        return {
            q: series_expression(
                self.weak.ring, self.solver.eta[p][j], self.symbols, self.fast_monomial
            )
            for j, q in enumerate(self.coordinates)
        }

    def known_terms(self, p: int) -> dict[sp.Expr, sp.Expr]:
        """What is known at order p, 1 ≤ p ≤ order: all of equation j but D0²q + ω²q + 2D0D_p q0.

        Raises
        ------
        ExpansionError
            At the order of a non-smooth force, which is an infinite sum of harmonics.
        """
        if p == self.order:
            check_finite(self.weak, "what is known")
        equations = self.solver.equations[p - 1]
        return {
            q: series_expression(
                self.weak.ring, equations[j].known, self.symbols, self.fast_monomial
            )
            for j, q in enumerate(self.coordinates)
        }

    def secular_terms(self, p: int) -> dict[sp.Expr, sp.Expr]:
        """The secular part of `known_terms`, over e^{iω_j T0}."""
        equations = self.solver.equations[p - 1]
        return {
            q: series_expression(
                self.weak.ring, equations[j].secular, self.symbols, self.slow_monomial
            )
            for j, q in enumerate(self.coordinates)
        }

    def residual(self) -> dict[sp.Expr, sp.Expr]:
        """What is left of each equation when the expansion is put back in, through ε^order.

        Returns
        -------
        dict
            {q_j: expression}; every one is exactly zero for a correct expansion.

        Raises
        ------
        ExpansionError
            If there is a non-smooth force, whose particular solution is an infinite sum.
        """
        check_finite(self.weak, "the particular solution")
        solver = Solver(self.weak)
        solver.solve_order_zero()
        for p in range(1, self.order + 1):
            solver.solve_order(p)
        return {
            q: sp.Add(
                *(
                    epsilon**p
                    * series_expression(self.weak.ring, part, self.symbols, self.fast_monomial)
                    for p, part in enumerate(parts)
                )
            )
            for q, parts in zip(self.coordinates, residual_series(self.weak, solver), strict=True)
        }

    @cached_property
    def slow_flow(self) -> SlowFlow:
        """The modulation equations dA_j/dt = Σ_p D_p A_j."""
        return slow_flow(self)


def expand(weak: WeakSystem) -> Expansion:
    """Expand a weak system through its order.

    Raises
    ------
    ExpansionError
        If hard forcing drives a coordinate at its natural frequency, or no term of the equations
        is of an order that is asked for.
    ResonanceError
        If a relation makes no term resonate up to the order.
    """
    if not any(weak.forces):
        raise ExpansionError(
            f"no term of the equations is of an order from 1 to {weak.order} in ε, so that nothing "
            "is left to expand: scale a parameter or the amplitudes, or ask for a higher order"
        )
    solver = Solver(weak)
    solver.solve_order_zero()
    for p in range(1, weak.order + 1):
        solver.solve_order(p, particular=p < weak.order)
    _check_relations(solver)
    return Expansion(weak, solver)


def _check_relations(solver: Solver) -> None:
    """Every relation must make some secular term resonate that did not do so without it."""
    weak = solver.weak
    if not weak.relations:
        return
    names = [str(s.name) for s in weak.scaled.frequencies] + ["1"]

    def vector(form: dict[str, Fraction]) -> list[Fraction]:
        return [form.get(name, Fraction(0)) for name in names]

    unknowns = (*weak.scaled.frequencies, 1)
    imposed = sp.Matrix(
        [
            [sp.Poly(r.lhs - r.rhs, *weak.scaled.frequencies).coeff_monomial(s) for s in unknowns]
            for r in weak.relations
        ]
    )
    rows = set()
    for equations in solver.equations:
        for j, equation in enumerate(equations):
            for key in equation.secular:
                rows.add(tuple(_free_difference(weak, key, j, vector)))
    used = [
        sp.Matrix(imposed.T).gauss_jordan_solve(sp.Matrix([rational(c) for c in row]))[0]
        for row in sorted(rows)
        if any(row)
    ]
    idle = [r for i, r in enumerate(weak.relations) if not any(u[i] for u in used)]
    if idle:
        r = idle[0]
        raise ResonanceError(
            f"no term up to order {weak.order} resonates because of {r.lhs} = {r.rhs}: the system "
            f"does not have this resonance; .resonances(order={weak.order}) lists those it has"
        )


def _free_difference(
    weak: WeakSystem, key: int, j: int, vector: Callable[[dict[str, Fraction]], list[Fraction]]
) -> list[Fraction]:
    """Frequency of a monomial minus ω_j, before the relations are imposed."""
    n = weak.ring.n
    exponents = weak.ring.packing.exponents(key)
    total = [-c for c in vector(weak.free_frequency[j])]
    for i, e in enumerate(exponents):
        if not e or i >= 2 * n + weak.ring.m:  # a modulus does not turn
            continue
        form = weak.free_frequency[i // 2 if i < 2 * n else n + i - 2 * n]
        sign = -1 if i < 2 * n and i % 2 else 1
        total = [t + sign * e * c for t, c in zip(total, vector(form), strict=True)]
    return total
