"""`AmplitudeFlow`: an autonomous slow flow as a table of terms, for all that takes numbers.

What is fixed, exponents and symmetries, stands apart from the coefficients, which depend on the
parameters. Engine and emitted code evaluate it by the same functions, those of `mmsgen.runtime`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from .numeric import Evaluator
from .parameters import Parameter
from .runtime._flow import Flow

if TYPE_CHECKING:
    from .slowflow import SlowFlow

__all__ = ["AmplitudeFlow", "amplitude_flow", "symmetries"]


@dataclass(frozen=True)
class AmplitudeFlow:
    """The terms of an autonomous slow flow and their coefficients.

    Attributes
    ----------
    flow : Flow
        Exponents and symmetries.
    coefficients : tuple of sympy.Expr
        One for each term, complex, in the parameters.
    parameters : tuple of Parameter
        Those that may occur.
    """

    flow: Flow
    coefficients: tuple[sp.Expr, ...]
    parameters: tuple[Parameter, ...]

    @cached_property
    def _evaluator(self) -> Evaluator:
        return Evaluator(self.coefficients, self.parameters)

    def numbers(self, values: Mapping[str, Any]) -> Any:
        """The coefficients at numbers or arrays that broadcast, shape (..., terms).

        Raises
        ------
        MmsgenError
            As for `Evaluator`.
        """
        found = [np.asarray(c, dtype=complex) for c in self._evaluator(values)]
        return np.stack(np.broadcast_arrays(*found), axis=-1) if found else np.zeros(0, complex)


def amplitude_flow(slow: SlowFlow) -> AmplitudeFlow:
    """The table of a slow flow in its autonomous frame.

    Raises
    ------
    ExpansionError
        If no frame makes it autonomous.
    """
    case, ring = slow.case, slow.case.weak.ring
    n = ring.n
    table: dict[tuple[int, tuple[int, ...]], list[sp.Expr]] = {}
    for j in range(n):
        turn = slow.frame_rate(j)
        if turn != 0:
            own = tuple(int(k == j and i == 0) for k in range(n) for i in range(3))
            table.setdefault((j, own), []).append(-sp.I * turn)
        for key in sorted(slow.rates[j]):
            e, moduli = ring.packing.exponents(key), ring.moduli(key)
            exponents = tuple(x for k in range(n) for x in (e[2 * k], e[2 * k + 1], moduli[k]))
            turned = sp.exp(sp.I * case.constant_phase(key))
            value = case.symbols(slow.rates[j][key]) * turned
            table.setdefault((j, exponents), []).append(value)
    terms = tuple(sorted(table))
    coefficients = tuple(sp.Add(*table[term]) for term in terms)
    return AmplitudeFlow(Flow(n, terms, symmetries(n, terms)), coefficients, case.parameters)


def symmetries(
    n: int, terms: tuple[tuple[int, tuple[int, ...]], ...]
) -> tuple[tuple[int, ...], ...]:
    """Independent integer vectors k with Σ k_l (r_l − s_l) = k_j for every term of equation j."""
    rows = {tuple(e[3 * k] - e[3 * k + 1] - (k == j) for k in range(n)) for j, e in terms} - {
        (0,) * n
    }
    if not rows:
        return tuple(tuple(int(k == j) for k in range(n)) for j in range(n))
    kernel = sp.Matrix(sorted(rows)).nullspace()
    found = []
    for vector in kernel:
        whole = vector * sp.ilcm(*(x.q for x in vector))
        common = sp.igcd(*whole)
        found.append(tuple(int(x / common) for x in whole))
    return tuple(found)
