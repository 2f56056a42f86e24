"""Linear slow flows from given initial amplitudes: numbers by the shared functions, and formulas.

Of an amplitude x_j that obeys one quadratic factor Γ² + bΓ + c of the characteristic polynomial,
row j of S² + bS + c being zero, only two frequencies are seen. Without damping, R = 4c − b² > 0,

    x_j(t) = e^{−bt/2} (p e^{i√R t/2} + q e^{−i√R t/2}),
    p, q = x_j(0)/2 ∓ i (ẋ_j(0) + b x_j(0)/2)/√R,

so that its modulus repeats after 2π/√R, and is at most |p| + |q|.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
import sympy as sp

from .amplitude_flow import AmplitudeFlow
from .errors import MmsgenError
from .field import Coefficient
from .linear_flow import Block, LinearFlow
from .runtime._beating import Beating, beat
from .runtime._evolution import Blocks, checked_times, demand_common_shape, evolve
from .runtime._flow import wirtinger
from .runtime._runtime import checked_amplitudes

__all__ = ["BeatingFormula", "beating", "beating_formulas", "evolution"]


@dataclass(frozen=True)
class BeatingFormula:
    """How amplitudes beat in which two frequencies are seen, as formulas.

    Attributes
    ----------
    radicand : sympy.Expr
        R: they beat where it is positive; where it is negative, they grow.
    period : sympy.Expr
        2π/√R in s, after which their moduli repeat.
    largest : mapping
        A_j → the largest |B_j(t)|, from the amplitudes at t = 0, for which A_j stands.
    """

    radicand: sp.Expr
    period: sp.Expr
    largest: Mapping[sp.Symbol, sp.Expr]


def _blocks(linear: LinearFlow) -> Blocks:
    return tuple(block.nodes for block in linear.blocks)


def _numbers(
    table: AmplitudeFlow, values: Mapping[str, Any], amplitudes: Any
) -> tuple[Any, Any, Any]:
    """Both parts of the flow, and the amplitudes, checked."""
    n = table.flow.n
    try:
        start = np.stack(checked_amplitudes(amplitudes, n), axis=-1)
    except ValueError as error:
        raise MmsgenError(str(error)) from None
    # A linear flow is its own derivative, taken anywhere.
    with np.errstate(all="ignore"):
        return *wirtinger(table.flow, table.numbers(values), np.zeros(n)), start


def evolution(
    linear: LinearFlow, table: AmplitudeFlow, values: Mapping[str, Any], amplitudes: Any, times: Any
) -> Any:
    """Amplitudes at times, in the autonomous frame; see `SlowFlow.evolution`."""
    plain, barred, start = _numbers(table, values, amplitudes)
    try:
        t = checked_times(times)
        demand_common_shape(plain, start, t)
    except ValueError as error:
        raise MmsgenError(str(error)) from None
    return evolve(plain, barred, _blocks(linear), t, start)


def beating(
    linear: LinearFlow, table: AmplitudeFlow, values: Mapping[str, Any], amplitudes: Any
) -> Beating:
    """Period and largest amplitudes; see `SlowFlow.beating`."""
    plain, barred, start = _numbers(table, values, amplitudes)
    try:
        demand_common_shape(plain, start)
    except ValueError as error:
        raise MmsgenError(str(error)) from None
    return beat(plain, barred, _blocks(linear), start)


def beating_formulas(linear: LinearFlow) -> tuple[BeatingFormula, ...]:
    """One formula for each pair of frequencies; see `SlowFlow.beating_formulas`."""
    found: list[BeatingFormula] = []
    case, start = linear.flow.case, 0
    for block in linear.blocks:
        own = slice(start, start + len(block.nodes))
        start = own.stop
        variables = sp.Matrix(linear.variables[own])
        slopes = linear.matrix[own, own] * variables
        for c, b in _quadratics(block):
            radicand = case.symbols(c.scale(4) - b * b)
            largest: dict[sp.Symbol, sp.Expr] = {}
            for k, (j, _) in enumerate(block.nodes):
                if radicand == 0 or case.amplitudes[j] in largest or not _obeys(block, k, b, c):
                    continue
                half = variables[k] / 2
                turned = sp.I * (slopes[k] + case.symbols(b) * half) / sp.sqrt(radicand)
                largest[case.amplitudes[j]] = sp.Abs(half - turned) + sp.Abs(half + turned)
            if largest:
                period = 2 * sp.pi / sp.sqrt(radicand)
                found.append(BeatingFormula(radicand, period, largest))
    return tuple(found)


def _quadratics(block: Block) -> Iterator[tuple[Coefficient, Coefficient]]:
    """c and b of every Γ² + bΓ + c that is real in Λ, Γ = iΛ: factors, and products of two."""
    found = [f.coefficients[:2] for f in block.factors if f.degree == 2]
    single = [f.coefficients[0] for f in block.factors if f.degree == 1]
    found += [(g * h, g + h) for g, h in combinations(single, 2)]
    for c, b in found:
        if not (b + b.conjugate()) and not (c - c.conjugate()):
            yield c, b


def _obeys(block: Block, k: int, b: Coefficient, c: Coefficient) -> bool:
    """Whether row k of S² + bS + c is zero."""
    row, size = block.entries[k], range(len(block.nodes))
    for column in size:
        terms = [row[m].times(block.entries[m][column]) for m in size]
        terms.append(row[column].times(b))
        if column == k:
            terms.append(c)
        if c.field.sum(terms):
            return False
    return True
