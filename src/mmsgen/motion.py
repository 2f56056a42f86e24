"""Motions of the unexpanded equations beside those of a slow flow, for certificates.

A motion of the slow flow is put back into coordinates, q_j = Σ_{p<N} q_{j,p}, and the exact
equations are integrated from the same state. Over a time of order 1/ε a slow flow of order N
leaves an error of ε^{N+1}·(1/ε), and so does the omitted q_{j,N}: together O(ε^N), relative to the
amplitude.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy  # loads its subpackages when they are first used
import sympy as sp

from .errors import CertificateError
from .integration import RunAway, solution_at
from .numeric import Evaluator
from .series import Series

if TYPE_CHECKING:
    from .equations import EquationsOfMotion
    from .expansion import Expansion

__all__ = ["Reconstruction", "exact_motion", "first_order_system", "reconstruction", "slow_motion"]

RTOL, ATOL = 1e-12, 1e-14
"""Tolerances of both integrations, relative and over the amplitude."""


@dataclass(frozen=True)
class Reconstruction:
    """Coordinates and velocities from amplitudes, at given parameters.

    Attributes
    ----------
    terms : tuple
        For q_1 … q_n, then q_1' … q_n': coefficients (m,) and exponents (m, 2n + phasors).
    rates : numpy.ndarray
        Frequency of each phase factor: ω_j + λ_j of the amplitudes, then Ω of the phasors, rad/s.
    angles : numpy.ndarray
        Constant phase of each of these, rad.
    """

    terms: tuple[tuple[Any, Any], ...]
    rates: Any
    angles: Any

    def __call__(self, t: Any, amplitudes: Any) -> Any:
        """States (2n, times) from amplitudes (n, times) in the autonomous frame."""
        turn = np.exp(1j * (np.multiply.outer(self.rates, t) + self.angles[:, None]))
        n = amplitudes.shape[0]
        a = amplitudes * turn[:n]
        variables = np.concatenate([np.stack([a, a.conj()], axis=1).reshape(2 * n, -1), turn[n:]])
        return np.stack(
            [
                (c[:, None] * np.prod(variables[None] ** e[:, :, None], axis=1)).sum(axis=0).real
                if len(c)
                else np.zeros(len(t))
                for c, e in self.terms
            ]
        )


def reconstruction(case: Expansion, values: Mapping[str, float]) -> Reconstruction:
    """Prepare the expansion of the coordinates, through order N − 1, at parameters.

    Parameters
    ----------
    case : Expansion
    values : mapping
        Name → number, of the slow flow's parameters and detunings.
    """
    ring, solver = case.weak.ring, case.solver
    parts: list[Series] = []
    for stack in (solver.q, solver.v):
        for j in range(ring.n):
            parts.append(ring.add(*(stack[p][j] for p in range(case.order))))
    expressions = [case.symbols(c) for part in parts for c in part.values()]
    numbers = iter(Evaluator(expressions, case.parameters)(values))
    terms = []
    for part in parts:
        c = np.array([complex(next(numbers)) for _ in part])
        # Up to order N − 1 there are no moduli: they come with the last order.
        width = 2 * ring.n + ring.m
        e = np.array([ring.packing.exponents(key)[:width] for key in part], dtype=float)
        terms.append((c, e))
    fast = [
        *(
            case.symbols.polynomial(ring.form_polynomial(f)) + case.slow_flow.frame_rate(j)
            for j, f in enumerate(ring.amplitude_frequencies)
        ),
        *(
            case.symbols.polynomial(ring.form_polynomial(ring.frequency(ring.z(unit))))
            + case.detuning_phase(ring.z(unit))
            for unit in np.eye(ring.m, dtype=int).tolist()
        ),
    ]
    constant = [
        *(sp.Integer(0) for _ in range(ring.n)),
        *(case.constant_phase(ring.z(unit)) for unit in np.eye(ring.m, dtype=int).tolist()),
    ]
    evaluated = Evaluator([*map(sp.sympify, fast), *map(sp.sympify, constant)], case.parameters)(
        values
    )
    numbers_ = np.array([complex(x).real for x in evaluated])
    return Reconstruction(tuple(terms), numbers_[: len(fast)], numbers_[len(fast) :])


@lru_cache(maxsize=8)
def _compiled(
    eom: EquationsOfMotion, names: tuple[str, ...]
) -> tuple[Callable[..., Any], Callable[..., Any], bool]:
    """Mass matrix and right-hand sides as functions of t, q, q' and numbers, on plain numbers.

    The third is whether the mass matrix changes in time or with the state.
    """
    t, n = eom.time, len(eom.coordinates)
    q = [sp.Dummy(f"q{j}") for j in range(n)]
    v = [sp.Dummy(f"v{j}") for j in range(n)]
    w = [sp.Dummy(f"w{j}") for j in range(n)]
    table: dict[sp.Expr, sp.Expr] = {}
    for order, places in ((2, w), (1, v), (0, q)):
        for x, place in zip(eom.coordinates, places, strict=True):
            table[x.diff(t, order) if order else x] = place
    plain = [e.subs(table) for e in eom.equations]
    mass = sp.Matrix([[e.diff(a) for a in w] for e in plain])
    if mass.free_symbols & set(w):
        raise CertificateError("the accelerations enter nonlinearly: no time integration here")
    rest = [e.subs(dict.fromkeys(w, 0)) for e in plain]
    symbols = [p.symbol for p in eom.parameters if p.name in names]
    # Plain numbers: several times faster here than arrays of one.
    entries = sp.lambdify([t, q, v, symbols], list(mass), "math", cse=True)
    right = sp.lambdify([t, q, v, symbols], [-e for e in rest], "math", cse=True)
    return entries, right, bool(mass.free_symbols & {t, *q, *v})


def first_order_system(
    eom: EquationsOfMotion, values: Mapping[str, float]
) -> Callable[[float, Any], Any]:
    """The exact equations as d(q, q')/dt = f(t, (q, q')).

    Raises
    ------
    CertificateError
        If accelerations enter other than linearly.
    """
    n, names = len(eom.coordinates), tuple(p.name for p in eom.parameters if p.name in values)
    entries, right, moving = _compiled(eom, names)
    numbers = [values[name] for name in names]
    if moving:
        solve = scipy.linalg.lapack.dgesv  # for two by two, the checks around it take longest

        def derivative(time: float, state: Any) -> Any:
            s = state.tolist()
            matrix = np.array(entries(time, s[:n], s[n:], numbers), dtype=float).reshape(n, n)
            force = right(time, s[:n], s[n:], numbers)
            *_, acceleration, singular = solve(matrix, force)
            if singular:
                raise CertificateError("the accelerations do not follow from the equations")
            return np.concatenate([state[n:], acceleration])

    else:
        zeros = [0.0] * n
        matrix = np.array(entries(0.0, zeros, zeros, numbers), dtype=float).reshape(n, n)
        inverse = np.linalg.inv(matrix)

        def derivative(time: float, state: Any) -> Any:
            s = state.tolist()
            force = np.array(right(time, s[:n], s[n:], numbers))
            return np.concatenate([state[n:], inverse @ force])

    return derivative


def exact_motion(
    derivative: Callable[[float, Any], Any], start: Any, times: Any, scale: float
) -> Any:
    """States (2n, times) of the exact equations from a state at t = 0."""
    try:
        return solution_at(derivative, start, times, RTOL, ATOL * scale).T
    except RunAway as error:
        raise CertificateError(f"the exact equations cannot be integrated: {error}") from error


def slow_motion(module: Any, start: Any, times: Any, arguments: Mapping[str, float]) -> Any:
    """Amplitudes (n, times) of an emitted slow flow, in its autonomous frame."""

    def derivative(_: float, b: Any) -> Any:
        return module.slow_flow(b, **arguments)

    scale, own = float(np.max(np.abs(start))), np.asarray(start, dtype=complex)
    try:
        return solution_at(derivative, own, times, RTOL, ATOL * scale).T
    except RunAway as error:
        raise CertificateError(f"the slow flow cannot be integrated: {error}") from error
