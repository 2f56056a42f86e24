"""`PeriodicSystem`: M, C and K as NumPy functions of phase and parameters.

The exact symbolic matrices are compiled once, with common subexpressions shared, and then
evaluated at many times for many parameter points in one call. Time is replaced by the phase
θ = 2πt/T: then cos Ωt is cos θ, the same for all points, and is computed once for the batch.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations, pairwise
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt
import sympy as sp
from sympy.core.relational import Relational

from ..errors import FloquetError
from ..parameters import Parameter
from .period import Periodicity, find_periodicity
from .points import Floats

__all__ = ["LinearEquations", "PeriodicSystem", "check_rest", "compile_system"]


INSIDE = 1e-9
"""How far inside a step its ends are looked at, in steps: beyond the rounding of the phase."""


class LinearEquations(Protocol):
    """What is needed of the equations of motion: M q'' + C q' + K q = f and its symbols."""

    @property
    def M(self) -> sp.ImmutableDenseMatrix: ...  # noqa: D102
    @property
    def C(self) -> sp.ImmutableDenseMatrix: ...  # noqa: D102
    @property
    def K(self) -> sp.ImmutableDenseMatrix: ...  # noqa: D102
    @property
    def time(self) -> sp.Symbol: ...  # noqa: D102
    @property
    def parameters(self) -> tuple[Parameter, ...]: ...  # noqa: D102


@dataclass(frozen=True)
class PeriodicSystem:
    """Compiled M, C and K.

    Parameters
    ----------
    size : int
        Number of coordinates n.
    symbols : tuple of sympy.Symbol
        The parameters that need a value, sorted by name.
    time_varying : bool
        False when M, C and K are constant.
    harmonic : int
        Highest multiple of the base frequency in the coefficients; 1 when the period is given.
    entries : tuple of tuple of (int, int, int)
        Where each compiled entry goes: (0 for M, 1 for C, 2 for K; row; column).
    function : callable
        (θ, T, *parameters) -> the entries.
    period_function : callable or None
        (*parameters) -> T; None when the period is given as a number or not needed.
    base : str
        The base frequency in print, for messages.
    switches : callable or None
        (θ, T, *parameters) -> functions at whose zeros the entries, or their slopes, jump.
    """

    size: int
    symbols: tuple[sp.Symbol, ...]
    time_varying: bool
    harmonic: int
    entries: tuple[tuple[tuple[int, int, int], ...], ...]
    function: Callable[..., Sequence[Any]]
    period_function: Callable[..., Any] | None
    base: str
    switches: Callable[..., Sequence[Any]] | None = None

    def require(self, arrays: dict[str, Floats]) -> None:
        """Raise FloquetError if a parameter has no value."""
        missing = [str(s) for s in self.symbols if s.name not in arrays]
        if missing:
            raise FloquetError(f"no value for {', '.join(missing)}: add it to `values`")

    def period(self, arrays: dict[str, Floats], count: int) -> Floats:
        """The period at each point, shape (count,), in seconds.

        Raises
        ------
        FloquetError
            If it is not finite and positive, as when the frequency is zero.
        """
        if self.period_function is None:
            raise FloquetError("the equations do not contain time: pass period= to get multipliers")
        with np.errstate(all="ignore"):
            raw = self.period_function(*(arrays[s.name] for s in self.symbols))
            period = np.abs(np.broadcast_to(np.asarray(raw, dtype=np.float64), (count,)))
        if not np.all(np.isfinite(period) & (period > 0)):
            raise FloquetError(
                f"the period 2π/({self.base}) is not finite and positive at every point: "
                "the frequency must not be zero"
            )
        return period

    def coefficients(self, phase: Floats, arrays: dict[str, Floats], period: Floats) -> Floats:
        """M, C and K at some phases of some points, in units of the phase.

        Parameters
        ----------
        phase : numpy.ndarray, shape (nodes,)
            θ = 2πt/T.
        arrays : dict of str to numpy.ndarray, shape (points,)
            Parameter values.
        period : numpy.ndarray, shape (points,)
            T.

        Returns
        -------
        numpy.ndarray, shape (nodes, points, n, n, 3)
            The last axis holds M, C·(T/2π) and K·(T/2π)²: with them, primes are derivatives
            with respect to θ.
        """
        count = period.size
        columns = [arrays[s.name] for s in self.symbols]
        with np.errstate(all="ignore"):
            results = self.function(phase[:, None], period, *columns)
        out = np.zeros((phase.size, count, self.size, self.size, 3))
        unit = period / (2 * np.pi)
        powers = (None, unit, unit**2)
        for value, places in zip(results, self.entries, strict=True):
            number = _real(value)
            for kind, row, column in places:
                power = powers[kind]
                out[:, :, row, column, kind] = number if power is None else number * power
        return out

    def jumps(
        self,
        begin: npt.NDArray[np.int64],
        step: float,
        nodes: Floats,
        arrays: dict[str, Floats],
        period: Floats,
    ) -> npt.NDArray[np.bool_]:
        """Which steps have a switch within them, and not at their ends, shape (steps, points).

        The nodes of a step do not see what happens between the last of them and its end, so the
        switches themselves are looked at: just inside the ends, and at the nodes.
        """
        if self.switches is None:
            return np.zeros((begin.size, period.size), dtype=np.bool_)
        at = np.concatenate([[INSIDE], nodes, [1 - INSIDE]])
        phase = (step * (at[:, None] + begin)).ravel()
        columns = [arrays[s.name] for s in self.symbols]
        with np.errstate(all="ignore"):
            values = self.switches(phase[:, None], period, *columns)
        shape = (phase.size, period.size)
        signs = [np.sign(np.broadcast_to(_real(v), shape)) for v in values]
        stacked = np.stack(signs).reshape(len(signs), at.size, begin.size, period.size)
        return np.asarray((stacked != stacked[:, :1]).any(axis=(0, 1)))


def _switches(entries: Sequence[sp.Expr], time: sp.Symbol) -> list[sp.Expr]:
    """Functions of time that are zero where an entry is not smooth."""
    found: list[sp.Expr] = []
    for entry in entries:
        for part in sp.preorder_traversal(entry):
            if not part.has(time):
                continue
            if isinstance(part, sp.Abs | sp.sign | sp.Heaviside):
                found.append(part.args[0])
            elif isinstance(part, Relational):
                found.append(part.lhs - part.rhs)
            elif isinstance(part, sp.Min | sp.Max):
                found += [left - right for left, right in combinations(part.args, 2)]
            elif isinstance(part, sp.floor | sp.ceiling | sp.frac):
                found.append(sp.sin(sp.pi * part.args[0]))
            elif isinstance(part, sp.Mod):
                found.append(sp.sin(sp.pi * part.args[0] / part.args[1]))
    return list(dict.fromkeys(found))


def check_rest(eom: LinearEquations) -> None:
    """Refuse nonlinear equations in which a force acts at rest.

    M, C and K of nonlinear equations are linearised about rest, q = 0: with a force f(t) there,
    rest is no solution, and its stability has no meaning. Linear equations may have any force:
    it drops out of the difference of two motions.

    Raises
    ------
    FloquetError
        Naming the equation, the force and a nonlinear term.
    """
    force, equations = getattr(eom, "f", None), getattr(eom, "equations", None)
    if force is None or equations is None or not any(force):
        return
    coordinates = tuple(getattr(eom, "coordinates", ()))
    found = _nonlinear_term(tuple(equations), coordinates, eom.time)
    if found is not None:
        row = next(k for k, entry in enumerate(force) if entry != 0)
        number, term = found
        raise FloquetError(
            f"rest is no solution of these nonlinear equations: the force {force[row]} acts on "
            f"{coordinates[row]}, and the equation of {coordinates[number]} contains {term}. "
            "Floquet theory needs a motion to linearise about: linearise the equations about one, "
            "or take the force out to get the stability of rest"
        )


@lru_cache(maxsize=32)
def _nonlinear_term(
    equations: tuple[sp.Expr, ...], coordinates: tuple[sp.Expr, ...], time: sp.Symbol
) -> tuple[int, sp.Expr] | None:
    """The first equation with a term that is not linear in the motion, and the term."""
    motion = {sp.diff(q, time, order): sp.Dummy() for q in coordinates for order in (2, 1, 0)}
    state = set(motion.values())
    for number, equation in enumerate(equations):
        for term in sp.Add.make_args(sp.expand(equation)):
            plain = term.xreplace(motion)
            if any(plain.diff(s).free_symbols & state for s in plain.free_symbols & state):
                return number, term
    return None


def compile_system(
    eom: LinearEquations, given: frozenset[str], period: sp.Expr | None, numeric_period: bool
) -> PeriodicSystem:
    """Compile the equations of motion.

    Parameters
    ----------
    eom : LinearEquations
        The linear equations; f(t) does not matter for stability.
    given : frozenset of str
        Names that have a value: a parameter with a definition uses it unless it is among them.
    period : sympy.Expr, optional
        The period as an expression in the parameters.
    numeric_period : bool
        The period comes as a number: do not look for it.

    Returns
    -------
    PeriodicSystem
        The compiled matrices.

    Raises
    ------
    FloquetError
        If the matrices are not square and equal in size, contain coordinates, or have no
        common period that can be found.
    """
    return _compile(
        sp.ImmutableDenseMatrix(eom.M),
        sp.ImmutableDenseMatrix(eom.C),
        sp.ImmutableDenseMatrix(eom.K),
        eom.time,
        tuple(
            (p.symbol, sp.sympify(p.definition))
            for p in eom.parameters
            if p.definition is not None and p.name not in given
        ),
        None if period is None else sp.sympify(period),
        numeric_period,
    )


@lru_cache(maxsize=32)
def _compile(
    mass: sp.ImmutableDenseMatrix,
    damping: sp.ImmutableDenseMatrix,
    stiffness: sp.ImmutableDenseMatrix,
    time: sp.Symbol,
    definitions: tuple[tuple[sp.Symbol, sp.Expr], ...],
    period: sp.Expr | None,
    numeric_period: bool,
) -> PeriodicSystem:
    size = mass.shape[0]
    if size == 0 or any(m.shape != (size, size) for m in (mass, damping, stiffness)):
        raise FloquetError("M, C and K must be square, of one size and not empty")
    places: dict[sp.Expr, list[tuple[int, int, int]]] = {}
    for kind, matrix in enumerate((mass, damping, stiffness)):
        for row in range(size):
            for column in range(size):
                entry = _expand(matrix[row, column], definitions)
                if entry != 0:
                    places.setdefault(entry, []).append((kind, row, column))
    entries = list(places)
    phase, unit = sp.Dummy("theta", real=True), sp.Dummy("T", positive=True)
    time_varying = any(entry.has(time) for entry in entries)
    periodicity = None
    if time_varying and period is None and not numeric_period:
        periodicity = find_periodicity(entries, time)
    length = _length(period, periodicity, definitions)
    if periodicity is not None:
        rewritten = [periodicity.in_phase(entry, phase) for entry in entries]
    else:
        rewritten = [entry.xreplace({time: phase * unit / (2 * sp.pi)}) for entry in entries]
    switches = _switches(rewritten, phase)
    symbols = _symbols([*entries, *([] if length is None else [length])], time)
    return PeriodicSystem(
        size=size,
        symbols=symbols,
        time_varying=time_varying,
        harmonic=1 if periodicity is None else periodicity.highest,
        entries=tuple(tuple(p) for p in places.values()),
        function=sp.lambdify([phase, unit, *symbols], rewritten, modules="numpy", cse=True),
        period_function=None if length is None else sp.lambdify(symbols, length, modules="numpy"),
        base="given period" if periodicity is None else str(periodicity.base),
        switches=sp.lambdify([phase, unit, *symbols], switches, modules="numpy", cse=True)
        if switches
        else None,
    )


def _length(
    period: sp.Expr | None,
    periodicity: Periodicity | None,
    definitions: tuple[tuple[sp.Symbol, sp.Expr], ...],
) -> sp.Expr | None:
    """The period as an expression in the parameters, if there is one."""
    if period is not None:
        return _expand(period, definitions)
    return None if periodicity is None else 2 * sp.pi / periodicity.base


def _expand(expression: sp.Expr, definitions: tuple[tuple[sp.Symbol, sp.Expr], ...]) -> sp.Expr:
    """Insert definitions, which may use one another."""
    table = dict(definitions)
    for _ in range(len(definitions) + 1):
        if not expression.free_symbols & set(table):
            return expression
        expression = expression.xreplace(table)
    names = ", ".join(sorted(str(s) for s in expression.free_symbols & set(table)))
    raise FloquetError(f"the definitions of {names} refer to each other in a circle")


def _symbols(expressions: Sequence[sp.Expr], time: sp.Symbol) -> tuple[sp.Symbol, ...]:
    """The parameters in `expressions`, by name; no two may share one."""
    found: set[sp.Symbol] = set()
    for expression in expressions:
        unknown = sorted(str(f) for f in expression.atoms(sp.core.function.AppliedUndef))
        if unknown:
            raise FloquetError(
                f"M, C or K contains {', '.join(unknown)}: linearise the equations "
                "(eom.linearise()) before Floquet theory"
            )
        found |= expression.free_symbols
    found.discard(time)
    symbols = tuple(sorted(found, key=lambda s: str(s.name)))
    for left, right in pairwise(symbols):
        if left.name == right.name:
            raise FloquetError(f"two different symbols are called {left.name!r}: rename one")
    return symbols


def _real(value: object) -> Floats:
    """A compiled entry as real numbers."""
    number = np.asarray(value)
    if np.iscomplexobj(number):
        # Rounding in sums of exp(±iωt) leaves an imaginary part of a few units in the last place.
        scale = np.max(np.abs(number), initial=0.0)
        if np.max(np.abs(number.imag), initial=0.0) > 1e-12 * scale:
            raise FloquetError("an entry of M, C or K is complex: the equations must be real")
        number = number.real
    return number.astype(np.float64)
