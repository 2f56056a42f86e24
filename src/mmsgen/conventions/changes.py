"""Slow flows in other amplitudes: near-identity changes, factors, first-order variables."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import sympy as sp

from ..errors import ConventionError
from ..validation import TIME
from .graded import Amplitudes, conjugated, exact, tidy
from .motions import natural_frequencies

if TYPE_CHECKING:
    from ..expansion import Expansion

__all__ = [
    "Change",
    "Flow",
    "autonomous",
    "changed",
    "first_order_variables",
    "followed_by",
    "inverse",
    "rescaled",
]

Flow = dict[int, dict[sp.Symbol, sp.Expr]]
"""Order p → {A: D_p A}."""

Change = dict[int, dict[sp.Symbol, sp.Expr]]
"""Order p ≥ 1 → {A: h_p}, for A = B + Σ ε^p h_p(B, B̄), written with A for B."""


def autonomous(case: Expansion) -> Flow:
    """The slow flow of a case by orders, in the frame A = B e^{iλt} that makes it autonomous.

    Parameters
    ----------
    case : Expansion

    Returns
    -------
    dict
        {p: {A: part of dB/dt}} with A written for B; −iλA stands at order 1.

    Raises
    ------
    ExpansionError
        If there is no such frame.
    """
    still = {TIME: sp.S.Zero}
    flow = {p: {a: e.xreplace(still) for a, e in g.items()} for p, g in case.solvability.items()}
    for j, a in enumerate(case.amplitudes):
        flow[1][a] -= sp.I * case.slow_flow.frame_rate(j) * a
    return flow


def changed(flow: Mapping[int, Mapping[sp.Symbol, sp.Expr]], change: Mapping[int, Any]) -> Flow:
    """The slow flow of other amplitudes, A = B + Σ ε^p h_p(B, B̄, t).

    Another choice of the homogeneous parts of q_1, q_2, … is of this kind: the part h_p e^{iωt} of
    q_p goes into A. Truncated at the order of the flow, to which the h_p below it contribute:
    B'_p = [g(B + Σ ε^k h_k)]_p − Σ_{k<p} (∂h_k/∂B B'_{p−k} + c.c.) − ∂h_{p−1}/∂t.

    Parameters
    ----------
    flow : mapping
        {p: {A: D_p A}}.
    change : mapping
        {p: {A: h_p}} for p ≥ 1, in the amplitudes and their conjugates; amplitudes that are not
        named keep their meaning. Time occurs as e^{iσt} with detunings σ only.

    Returns
    -------
    dict
        {p: {A: D_p B}} with A written for B.

    Raises
    ------
    ConventionError
        If an amplitude is unknown, or an expression is inexact or holds time otherwise.
    """
    state = Amplitudes(flow)
    g, h = state.read(flow, "the slow flow"), state.read(change, "the change of amplitudes")
    order = max(g)
    through = state.mapped(g, state.series(h), order)
    rates: list[dict[sp.Symbol, sp.Expr]] = [dict.fromkeys(state.variables, sp.S.Zero)]
    for p in range(1, order + 1):
        rates.append({})
        for a in state.amplitudes:
            value = through[p].get(a, sp.S.Zero)
            for k in range(1, p):
                part = h.get(k, {}).get(a, sp.S.Zero)
                moves = (part.diff(v) * rates[p - k][v] for v in state.variables)
                value -= sp.Add(*moves)
            value -= h.get(p - 1, {}).get(a, sp.S.Zero).diff(TIME)
            rates[p][a] = tidy(value, state.variables)
        rates[p].update(state.bars(rates[p]))
    return state.written({p: rates[p] for p in range(1, order + 1)})


def inverse(change: Mapping[int, Any], order: int | None = None) -> Change:
    """The change back: B = A + Σ ε^p m_p(A, Ā) for A = B + Σ ε^p h_p(B, B̄).

    Parameters
    ----------
    change : mapping
        {p: {A: h_p}}.
    order : int, optional
        Of the result; by default the highest order of `change`.

    Raises
    ------
    ConventionError
        As for `changed`.
    """
    state = Amplitudes(change)
    h = state.read(change, "the change of amplitudes")
    order = max(h) if order is None else order
    result: dict[int, dict[sp.Symbol, sp.Expr]] = {}
    for p in range(1, order + 1):
        # m_p = −[h(A + m)]_p needs the m below p only.
        value = state.mapped(h, state.series(result), p)[p]
        result[p] = {a: tidy(-value.get(a, sp.S.Zero), state.variables) for a in state.amplitudes}
        result[p].update(state.bars(result[p]))
    return state.written(result)


def followed_by(first: Mapping[int, Any], second: Mapping[int, Any]) -> Change:
    """Two changes as one: A = B + Σ ε^p first_p(B), then B = C + Σ ε^p second_p(C).

    Truncated at the higher of both orders: an order that is missing in one of them is zero.

    Raises
    ------
    ConventionError
        As for `changed`.
    """
    state = Amplitudes(first, second)
    where = "the change of amplitudes"
    h, m = state.read(first, where), state.read(second, where)
    order = max(*h, *m)
    through = state.mapped(h, state.series(m), order)
    return state.written(
        {
            p: {
                a: tidy(
                    m.get(p, {}).get(a, sp.S.Zero) + through[p].get(a, sp.S.Zero), state.variables
                )
                for a in state.amplitudes
            }
            for p in range(1, order + 1)
        }
    )


def rescaled(
    flow: Mapping[int, Mapping[sp.Symbol, sp.Expr]],
    factor: sp.Expr | int | Mapping[sp.Symbol, sp.Expr | int],
    conjugate: bool = False,
) -> Flow:
    """The slow flow of B with A = factor·B, or A = factor·B̄.

    Half amplitudes: q = ½B e^{iωt} + c.c. has the factor ½; so A = (a/2) e^{iβ} there becomes
    B = a e^{iβ}. Sines: q = a sin(ωt + β) has −i/2. Exponents of the other sign,
    q = B e^{−iωt} + c.c., have B = Ā.

    Parameters
    ----------
    flow : mapping
        {p: {A: D_p A}}.
    factor : expression, or mapping of amplitude to such
        Exact and not zero.
    conjugate : bool
        True for A = factor·B̄.

    Raises
    ------
    ConventionError
        If a factor is inexact, zero or missing.
    """
    state = Amplitudes(flow)
    g = state.read(flow, "the slow flow")
    factors = factor if isinstance(factor, Mapping) else dict.fromkeys(state.amplitudes, factor)
    table: dict[sp.Expr, sp.Expr] = {}
    numbers = {}
    for a in state.amplitudes:
        if a not in factors:
            raise ConventionError(f"no factor is given for the amplitude {a}")
        numbers[a] = exact(factors[a], f"the factor of {a}")
        if numbers[a].is_zero or numbers[a].free_symbols & {TIME, *state.pairs}:
            raise ConventionError(f"the factor of {a} is {numbers[a]}: a constant, not zero")
        bar = state.pairs[a]
        table[a] = numbers[a] * (bar if conjugate else a)
        table[bar] = conjugated(table[a], state.pairs)
    result: dict[int, dict[sp.Symbol, sp.Expr]] = {}
    for p, rates in g.items():
        result[p] = {}
        for a in state.amplitudes:
            rate = rates.get(a, sp.S.Zero).xreplace(table) / numbers[a]
            rate = conjugated(rate, state.pairs) if conjugate else rate
            result[p][a] = tidy(rate, state.variables)
    return state.written(result)


def first_order_variables(case: Expansion) -> Change:
    """The change to the amplitudes of first-order complex variables, for `changed`.

    Averaging, normal forms and Nayfeh's complex-valued form start from z = (q − iq'/ω)/2. The whole
    fundamental of z is B = A − (i/(2ω)) dA/dt, since that of q' is iωA + dA/dt.

    Parameters
    ----------
    case : Expansion
        Without a detuned natural frequency.

    Returns
    -------
    dict
        {p: {A: h_p}}, A = B + Σ ε^p h_p.
    """
    there: Change = {}
    frequencies = natural_frequencies(case)
    for p, rates in case.solvability.items():
        if p < max(case.order, 2):
            there[p] = {
                a: -sp.I * rates[a] / (2 * w)
                for a, w in zip(case.amplitudes, frequencies, strict=True)
            }
    return inverse(there)
