"""`LinearFlow`: a linear slow flow as matrices, in blocks that do not touch each other.

The amplitudes A_j and their conjugates are split into the smallest sets closed under the flow, one
of each conjugate pair of sets being kept. The characteristic polynomial of a block comes from the
Faddeev–Leverrier recursion, which needs ring operations alone, and is factored over the rationals.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from .boundary import Stability, stability
from .errors import ExpansionError
from .factoring import MonicFactor, factor_monic
from .field import Coefficient
from .numeric import Evaluator
from .parameters import Parameter

if TYPE_CHECKING:
    from .slowflow import SlowFlow

__all__ = ["Block", "LinearFlow", "linear_flow"]

Node = tuple[int, int]
"""(coordinate index, 0 for A_j or 1 for its conjugate)."""


@dataclass(frozen=True)
class Block:
    """A set of amplitudes closed under the slow flow.

    Attributes
    ----------
    nodes : tuple of Node
    entries : tuple of tuple of Coefficient
        The square matrix of the block, for amplitudes turned back by `phases`.
    phases : tuple of int
        For each node the constant phase factor that it is turned by, as a packed monomial; 0
        where the equations hold no symbolic phase.
    """

    nodes: tuple[Node, ...]
    entries: tuple[tuple[Coefficient, ...], ...]
    phases: tuple[int, ...]

    @cached_property
    def polynomial(self) -> tuple[Coefficient, ...]:
        """Characteristic polynomial, coefficient of Γ^k at index k; the last is 1."""
        return _characteristic(self.entries)

    @cached_property
    def factors(self) -> tuple[MonicFactor, ...]:
        """The monic factors of the characteristic polynomial over the rationals."""
        return factor_monic(self.polynomial)


@dataclass(frozen=True)
class LinearFlow:
    """The matrix form of a linear slow flow.

    Attributes
    ----------
    flow : SlowFlow
    blocks : tuple of Block
    """

    flow: SlowFlow
    blocks: tuple[Block, ...]

    @cached_property
    def variables(self) -> tuple[sp.Expr, ...]:
        """Amplitudes in the order of `matrix`."""
        amplitudes = self.flow.case.amplitudes
        return tuple(
            sp.conjugate(amplitudes[j]) if barred else amplitudes[j]
            for block in self.blocks
            for j, barred in block.nodes
        )

    @cached_property
    def matrix(self) -> sp.ImmutableDenseMatrix:
        """The block-diagonal matrix of the slow flow."""
        case = self.flow.case

        def shown(c: Coefficient, row: int, column: int) -> sp.Expr:
            return case.symbols(c) * sp.exp(sp.I * case.constant_phase(row - column))

        parts = [
            sp.Matrix(
                [
                    [shown(c, p, q) for c, q in zip(row, block.phases, strict=True)]
                    for row, p in zip(block.entries, block.phases, strict=True)
                ]
            )
            for block in self.blocks
        ]
        return sp.ImmutableDenseMatrix(sp.diag(*parts))

    @property
    def factors(self) -> tuple[MonicFactor, ...]:
        """The factors of all blocks."""
        return tuple(f for block in self.blocks for f in block.factors)

    def characteristic_polynomial(self, gamma: sp.Symbol) -> sp.Expr:
        """The product of all factors."""
        show = self.flow.case.symbols
        return sp.Mul(
            *(
                sp.Add(*(show(c) * gamma**k for k, c in enumerate(f.coefficients)))
                ** f.multiplicity
                for f in self.factors
            )
        )

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters that the matrix depends on, detunings last."""
        present = self.matrix.free_symbols
        return tuple(p for p in self.flow.case.parameters if p.symbol in present)

    @cached_property
    def stability(self) -> Stability:
        """Whether the flow can be unstable, why, and where."""
        case = self.flow.case
        sigmas = tuple(r.detuning for r in case.relations)
        weights = {**case.weak.scaled.generator_orders, **{str(s.name): 1 for s in sigmas}}
        return stability(
            self.factors,
            case.symbols,
            case.parameters,
            sigmas,
            weights,
            case.order,
            self._reach(),
        )

    def _reach(self) -> sp.Expr:
        """Half of the frequencies that resonate, where the slow flow holds them.

        Farther away a polynomial in the detuning that is cut after a few powers means nothing.
        """
        relations = self.flow.case.relations
        if not relations:
            return sp.oo
        terms = sp.Add.make_args(sp.expand(relations[0].rhs))
        half = sp.Add(*(abs(t.as_coeff_Mul()[0]) * t.as_coeff_Mul()[1] for t in terms)) / 2
        known = half.free_symbols <= self.matrix.free_symbols
        return half if known and half.is_positive else sp.oo

    @cached_property
    def _entries(self) -> Evaluator:
        """The entries of all blocks, row by row."""
        show = self.flow.case.symbols
        flat = [show(c) for block in self.blocks for row in block.entries for c in row]
        return Evaluator(flat, self.flow.case.parameters)

    def growth_rate(self, values: Mapping[Any, Any]) -> Any:
        """Largest real part of the eigenvalues of the matrix."""
        numbers = np.broadcast_arrays(*self._entries(values))
        rates, start = [], 0
        for block in self.blocks:
            n = len(block.nodes)
            flat = np.stack(numbers[start : start + n * n], axis=-1)
            matrix = flat.reshape(*flat.shape[:-1], n, n).astype(complex)
            finite = np.asarray(np.isfinite(matrix).all(axis=(-2, -1)))
            found = np.linalg.eigvals(np.where(finite[..., None, None], matrix, 0.0))
            rates.append(np.where(finite, found.real.max(axis=-1), np.nan))
            start += n * n
        given = (np.shape(v) for v in values.values())
        return np.broadcast_to(
            np.max(np.broadcast_arrays(*rates), axis=0), np.broadcast_shapes(*given)
        )[()]


def linear_flow(flow: SlowFlow) -> LinearFlow:
    """Split a linear autonomous slow flow into blocks.

    Raises
    ------
    ExpansionError
        If the growth depends on a symbolic constant phase.
    """
    entries, turns = _entries(flow)
    blocks = []
    for nodes in _components(flow.case.weak.ring.n, entries):
        zero = flow.case.weak.ring.field.zero
        rows = tuple(tuple(entries.get((a, b), zero) for b in nodes) for a in nodes)
        blocks.append(Block(nodes, rows, _node_phases(flow, nodes, turns)))
    return LinearFlow(flow, tuple(blocks))


def _node_phases(
    flow: SlowFlow, nodes: tuple[Node, ...], turns: Mapping[tuple[Node, Node], int]
) -> tuple[int, ...]:
    """Turn each amplitude of a block by a constant phase so that its matrix is free of them."""
    phases = {nodes[0]: 0}
    pending = dict(turns)
    while len(phases) < len(nodes):
        for (row, column), turn in pending.items():
            if row in phases and column not in phases:
                phases[column] = phases[row] - turn
            elif column in phases and row not in phases:
                phases[row] = phases[column] + turn
    for (row, column), turn in turns.items():
        if row in phases and turn != phases[row] - phases[column]:
            raise _phase_error(flow, turn - phases[row] + phases[column])
    return tuple(phases[node] for node in nodes)


def _phase_error(flow: SlowFlow, key: int) -> ExpansionError:
    angle = flow.case.constant_phase(key)
    return ExpansionError(
        f"the stability depends on the constant phase {angle}, and the matrix has no rational "
        f"form: write the cosine and the sine of that phase as two parameters, or use .cartesian "
        "and .jacobian"
    )


def _entries(
    flow: SlowFlow,
) -> tuple[dict[tuple[Node, Node], Coefficient], dict[tuple[Node, Node], int]]:
    """d(node)/dt = Σ entries[node, other]·e^{i·phase}·other, and the phase monomials."""
    case, ring = flow.case, flow.case.weak.ring
    field = ring.field
    terms: dict[tuple[Node, Node], list[Coefficient]] = {}
    turns: dict[tuple[Node, Node], int] = {}
    for j, series in enumerate(flow.rates):
        for key, c in series.items():
            exponents = ring.packing.exponents(key)[: 2 * ring.n]
            i, barred = divmod(exponents.index(1), 2)
            turn = case.phase_key(key)
            if turns.setdefault(((j, 0), (i, barred)), turn) != turn:
                raise _phase_error(flow, turn - turns[(j, 0), (i, barred)])
            turns[(j, 1), (i, 1 - barred)] = -turn
            terms.setdefault(((j, 0), (i, barred)), []).append(c)
            terms.setdefault(((j, 1), (i, 1 - barred)), []).append(c.conjugate())
        assert flow.frame is not None
        form = {str(s.name): c for s, c in flow.frame[j].items()}
        frame = field.polynomial(field.linear(form)).times_i()
        if frame:
            for b, rate in ((0, -frame), (1, frame)):
                node = (j, b)
                if turns.setdefault((node, node), 0):
                    raise _phase_error(flow, turns[node, node])
                terms.setdefault((node, node), []).append(rate)
    sums = ((pair, field.sum(cs)) for pair, cs in terms.items())
    entries = {pair: c for pair, c in sums if c}
    return entries, {pair: turn for pair, turn in turns.items() if pair in entries}


def _components(n: int, entries: Mapping[tuple[Node, Node], Coefficient]) -> list[tuple[Node, ...]]:
    """Connected sets of nodes, one of each conjugate pair, in coordinate order."""
    leader: dict[Node, Node] = {(j, b): (j, b) for j in range(n) for b in (0, 1)}

    def find(node: Node) -> Node:
        while leader[node] != node:
            node = leader[node]
        return node

    for a, b in entries:
        leader[find(a)] = find(b)
    taken: set[Node] = set()
    components = []
    for j in range(n):
        if (j, 0) in taken or (j, 1) in taken:
            continue
        nodes = tuple(sorted(m for m in leader if find(m) == find((j, 0))))
        taken.update(nodes)
        components.append(nodes)
    return components


def _characteristic(rows: tuple[tuple[Coefficient, ...], ...]) -> tuple[Coefficient, ...]:
    """Coefficients of det(Γ − S), lowest power first, by Faddeev and Leverrier."""
    n = len(rows)
    field = rows[0][0].field
    identity = [[field.one if i == j else field.zero for j in range(n)] for i in range(n)]
    coefficients, auxiliary = [field.one], identity
    for k in range(1, n + 1):
        product = [
            [field.sum(rows[i][m].times(auxiliary[m][j]) for m in range(n)) for j in range(n)]
            for i in range(n)
        ]
        c = field.sum(product[i][i] for i in range(n)).scale(Fraction(-1, k))
        coefficients.append(c)
        auxiliary = [
            [product[i][j] + c if i == j else product[i][j] for j in range(n)] for i in range(n)
        ]
    return tuple(reversed(coefficients))
