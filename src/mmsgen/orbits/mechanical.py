"""Equations of motion at numbers, as a vector field.

They are taken as they stand: accelerations may be multiplied by a mass matrix that changes in time
and with the state. From F(t, q, q', q''; p) = 0, linear in q'',

    q'' = −M⁻¹ F(t, q, q', 0),   ∂q''/∂x = −M⁻¹ ∂F/∂x  at that q'',  x = q, q', p.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from ..errors import FloquetError, OrbitError
from ..floquet.period import Periodicity, find_periodicity
from ..floquet.points import Floats
from ..numeric import named_values
from ..parameters import by_key
from .fields import Problem, lambdified, table

if TYPE_CHECKING:
    from ..equations import EquationsOfMotion

__all__ = ["Mechanical", "problem"]

PERIOD = " period"  # no symbol of a model has this name


@dataclass(frozen=True, eq=False)
class _Compiled:
    """Lambdified equations; the symbols of derivatives are kept for one more of them."""

    names: tuple[str, ...]
    symbols: tuple[sp.Symbol, ...]
    places: tuple[Any, ...]
    equations: tuple[sp.Expr, ...]
    acceleration: Callable[..., list[Any]]
    slopes: Callable[..., list[Any]]
    base: sp.Expr | None
    frequencies: frozenset[str]


@dataclass(frozen=True, eq=False)
class Mechanical(Problem):
    """Second-order equations of motion at numbers; the state is (q, q')."""

    compiled: _Compiled

    @property
    def _numbers(self) -> list[float]:
        return [self.values[name] for name in self.compiled.names]

    @property
    def base(self) -> float | None:
        """See `Problem`."""
        if PERIOD in self.values:
            return 2 * np.pi / self.values[PERIOD]
        if self.compiled.base is None:
            return None
        return float(_number(self.compiled.base, self.compiled.symbols)(*self._numbers))

    def base_slope(self, name: str) -> float:
        """See `Problem`."""
        own = self.compiled
        if PERIOD in self.values or own.base is None:
            if PERIOD in self.values and name in own.frequencies:
                raise OrbitError(
                    f"{name} changes the period, which was given as a number: leave period= out, "
                    "or follow another parameter"
                )
            return 0.0
        return float(_base_slope(own, name)(*self._numbers))

    def _solved(self, phase: Floats, states: Floats) -> tuple[Floats, Floats]:
        """Inverse mass matrices (m, n, n) and accelerations (m, n)."""
        n = self.coordinates
        entries = self.compiled.acceleration(
            phase, list(states[:n]), list(states[n:]), self._numbers
        )
        parts = table(entries, states.shape[1])
        mass = parts[: n * n].T.reshape(-1, n, n)
        try:
            inverse = np.linalg.inv(mass)
        except np.linalg.LinAlgError:
            raise OrbitError(
                "the mass matrix becomes singular on the way: the accelerations do not follow "
                "from the equations there"
            ) from None
        acceleration = -(inverse @ parts[n * n :].T[:, :, None])[:, :, 0]
        return np.asarray(inverse, dtype=float), acceleration

    def rates(self, phase: Floats, states: Floats) -> tuple[Floats, Floats]:
        """See `Problem`."""
        n, m = self.coordinates, states.shape[1]
        inverse, w = self._solved(phase, states)
        entries = self.compiled.slopes(
            phase, list(states[:n]), list(states[n:]), list(w.T), self._numbers
        )
        parts = table(entries, m).T.reshape(m, n, 2 * n)
        jacobian = np.zeros((m, 2 * n, 2 * n))
        jacobian[:, range(n), range(n, 2 * n)] = 1.0
        jacobian[:, n:] = -(inverse @ parts)
        return np.concatenate([states[n:].T, w], axis=1), jacobian

    def slope(self, name: str, phase: Floats, states: Floats) -> Floats:
        """See `Problem`."""
        n, m = self.coordinates, states.shape[1]
        inverse, w = self._solved(phase, states)
        function = _slope(self.compiled, name)
        entries = function(phase, list(states[:n]), list(states[n:]), list(w.T), self._numbers)
        right = table(entries, m).T
        return np.concatenate([np.zeros((m, n)), -(inverse @ right[:, :, None])[:, :, 0]], axis=1)


def problem(
    eom: EquationsOfMotion, values: Mapping[Any, Any], *, period: float | None = None
) -> Mechanical:
    """The exact equations of motion at numbers.

    Parameters
    ----------
    eom : EquationsOfMotion
    values : mapping
        Symbol or name → number, for every parameter that occurs. One with a definition follows
        from the others, and with them when one is varied, unless its own value is given.
    period : float, optional
        Period of the excitation in s. By default it is read off the equations; necessary where
        their frequencies are multiples of one another by their numbers alone.

    Returns
    -------
    Mechanical

    Raises
    ------
    OrbitError
        If a value is missing, accelerations enter other than linearly, or no period can be read
        off.
    MmsgenError
        If a value is unknown or unusable.
    """
    given = {name for name, _ in by_key(values)}
    known = named_values(eom.parameters, values)
    for name, value in known.items():
        if np.ndim(value):
            raise OrbitError(f"the value of {name} must be one number, got {value!r}")
    if period is not None and not (np.isfinite(period) and period > 0):
        raise OrbitError(f"the period must be positive, got {period!r}")
    compiled = _compile(eom, frozenset(given), period is not None)
    if period is not None:
        known[PERIOD] = period
    missing = [name for name in compiled.names if name not in known]
    if missing:
        raise OrbitError(f"no value is given for {', '.join(missing)}")
    numbers = {name: float(known[name]) for name in compiled.names}
    n = len(eom.coordinates)
    own = Mechanical(2 * n, n, numbers, compiled)
    if own.base is not None and not own.base > 0:
        raise OrbitError("the frequency of the excitation must be positive")
    return own


@lru_cache(maxsize=16)
def _compile(eom: EquationsOfMotion, given: frozenset[str], timed: bool) -> _Compiled:
    """Compile M, F and ∂F/∂(q, q'); definitions are inserted for what is not given."""
    n, time = len(eom.coordinates), eom.time
    phase = sp.Dummy("phase", real=True)
    q, v, w = ([sp.Dummy(f"{c}{j}", real=True) for j in range(n)] for c in "qvw")
    names: dict[sp.Expr, sp.Expr] = {}
    for order, places in ((2, w), (1, v), (0, q)):
        for x, place in zip(eom.coordinates, places, strict=True):
            names[x.diff(time, order) if order else x] = place
    definitions = {
        p.symbol: sp.sympify(p.definition)
        for p in eom.parameters
        if p.definition is not None and p.name not in given
    }
    plain = [_inserted(sp.sympify(e).subs(names), definitions) for e in eom.equations]
    base, frequencies = None, _in_time(plain, time)
    length = sp.Symbol(PERIOD, positive=True)
    if timed:
        if frequencies is None:
            raise OrbitError("nothing in these equations depends on time: leave period= out")
        plain = [e.subs(time, phase * length / (2 * sp.pi)) for e in plain]
    else:
        periodicity = _periodicity(plain, time)
        if periodicity is not None:
            base = periodicity.base
            plain = [periodicity.in_phase(e, phase) for e in plain]
    mass = [e.diff(a) for e in plain for a in w]
    if any(set(w) & e.free_symbols for e in mass):
        raise OrbitError("the accelerations enter nonlinearly: they cannot be solved for")
    rest = [e.subs(dict.fromkeys(w, 0)) for e in plain]
    slopes = [e.diff(x) for e in plain for x in (*q, *v)]
    occurring = set().union(*(e.free_symbols for e in plain))
    occurring |= base.free_symbols if base is not None else set()
    symbols = [p.symbol for p in eom.parameters if p.symbol in occurring]
    symbols += [length] if timed else []
    return _Compiled(
        tuple(str(s.name) for s in symbols),
        tuple(symbols),
        (phase, q, v, w),
        tuple(plain),
        lambdified([phase, q, v, symbols], [*mass, *rest]),
        lambdified([phase, q, v, w, symbols], slopes),
        base,
        frequencies or frozenset(),
    )


def _periodicity(expressions: Sequence[sp.Expr], time: sp.Symbol) -> Periodicity | None:
    """The common frequency of the excitation, or an error that asks for the period."""
    try:
        return find_periodicity(expressions, time)
    except FloquetError as error:
        raise OrbitError(f"no period can be read off the equations: {error}") from error


def _in_time(expressions: Sequence[sp.Expr], time: sp.Symbol) -> frozenset[str] | None:
    """Names of the parameters that stand with time in one argument; None where time is absent."""
    if not any(e.has(time) for e in expressions):
        return None
    parts = {a for e in expressions for f in e.atoms(sp.Function) for a in f.args if a.has(time)}
    symbols = {s for a in parts for s in a.free_symbols} - {time}
    return frozenset(str(s) for s in symbols)


def _inserted(expression: sp.Expr, definitions: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    for _ in range(len(definitions)):
        if not expression.free_symbols & set(definitions):
            break
        expression = expression.subs(definitions)
    return expression


@lru_cache(maxsize=64)
def _slope(compiled: _Compiled, name: str) -> Callable[..., list[Any]]:
    """∂F/∂p for one parameter."""
    symbol = compiled.symbols[compiled.names.index(name)]
    phase, q, v, w = compiled.places
    return lambdified(
        [phase, q, v, w, list(compiled.symbols)], [e.diff(symbol) for e in compiled.equations]
    )


@lru_cache(maxsize=64)
def _base_slope(compiled: _Compiled, name: str) -> Callable[..., Any]:
    """dΩ/dp for one parameter."""
    symbol = compiled.symbols[compiled.names.index(name)]
    base = sp.S.Zero if compiled.base is None else compiled.base
    return _number(base.diff(symbol), compiled.symbols)


@lru_cache(maxsize=256)
def _number(expression: sp.Expr, symbols: tuple[sp.Symbol, ...]) -> Callable[..., Any]:
    function: Callable[..., Any] = sp.lambdify(symbols, expression, "math")
    return function
