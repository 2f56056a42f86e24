"""Vector fields at numbers, with the derivatives that Newton's method needs.

Time enters as the phase φ of what excites the system, so that equations with a frequency among
their parameters keep their period, 2π, when that frequency is changed.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, Self

import numpy as np
import sympy as sp

from ..errors import OrbitError
from ..floquet.points import Floats
from ..numeric import named_values
from ..parameters import Parameter

__all__ = ["Autonomous", "Problem", "autonomous", "lambdified", "table"]


@dataclass(frozen=True, eq=False)
class Problem(ABC):
    """dy/dt = f(φ, y; p) at numbers, 2π-periodic in the phase φ.

    Attributes
    ----------
    size : int
        Number d of states.
    coordinates : int
        How many of them, the first ones, are coordinates; velocities follow.
    values : dict
        Name → number, of all parameters.
    """

    size: int
    coordinates: int
    values: Mapping[str, float]

    @property
    @abstractmethod
    def base(self) -> float | None:
        """Angular frequency dφ/dt of the excitation in rad/s; None without one."""

    @abstractmethod
    def rates(self, phase: Floats, states: Floats) -> tuple[Floats, Floats]:
        """Rates f, shape (m, d), and their Jacobians, shape (m, d, d).

        Parameters
        ----------
        phase : numpy.ndarray, shape (m,)
            In rad.
        states : numpy.ndarray, shape (d, m)
        """

    @abstractmethod
    def slope(self, name: str, phase: Floats, states: Floats) -> Floats:
        """Derivatives of the rates by one parameter, shape (m, d)."""

    @abstractmethod
    def base_slope(self, name: str) -> float:
        """Derivative of `base` by one parameter."""

    def at(self, name: str, value: float) -> Self:
        """The same problem with another value of one parameter."""
        return replace(self, values={**self.values, name: float(value)})

    def require(self, name: str) -> None:
        """Raise unless a parameter has a value here.

        Raises
        ------
        OrbitError
            If there is no such parameter.
        """
        if name not in self.values:
            known = ", ".join(n for n in self.values if not n.startswith(" "))
            raise OrbitError(f"{name} is not a parameter of this problem; they are {known}")


def lambdified(arguments: list[Any], expressions: list[sp.Expr]) -> Callable[..., list[Any]]:
    """A NumPy function of symbols and lists of symbols."""
    function: Callable[..., list[Any]] = sp.lambdify(arguments, expressions, "numpy", cse=True)
    return function


def table(entries: Sequence[Any], width: int) -> Floats:
    """Entries, numbers or arrays, as rows of one array."""
    rows = np.empty((len(entries), width))
    for row, entry in zip(rows, entries, strict=True):
        row[:] = entry
    return rows


@dataclass(frozen=True, eq=False)
class Autonomous(Problem):
    """First-order equations without time, from expressions."""

    states: tuple[sp.Symbol, ...]
    expressions: tuple[sp.Expr, ...]
    symbols: tuple[sp.Symbol, ...]
    function: Callable[..., list[Any]]

    @property
    def base(self) -> float | None:
        """See `Problem`."""
        return None

    def base_slope(self, name: str) -> float:
        """See `Problem`."""
        self.require(name)
        return 0.0

    def _evaluated(self, function: Callable[..., list[Any]], states: Floats) -> Floats:
        numbers = [self.values[str(s.name)] for s in self.symbols]
        return table(function(list(states), numbers), states.shape[1]).T

    def rates(self, phase: Floats, states: Floats) -> tuple[Floats, Floats]:
        """See `Problem`."""
        parts = self._evaluated(self.function, states)
        d, m = self.size, states.shape[1]
        return parts[:, :d], parts[:, d:].reshape(m, d, d)

    def slope(self, name: str, phase: Floats, states: Floats) -> Floats:
        """See `Problem`."""
        self.require(name)
        symbol = next(s for s in self.symbols if str(s.name) == name)
        slopes = tuple(e.diff(symbol) for e in self.expressions)
        return self._evaluated(_of_states(self.states, self.symbols, slopes), states)


@lru_cache(maxsize=64)
def _of_states(
    states: tuple[sp.Symbol, ...], symbols: tuple[sp.Symbol, ...], parts: tuple[sp.Expr, ...]
) -> Callable[..., list[Any]]:
    return lambdified([list(states), list(symbols)], list(parts))


def autonomous(
    rates: Mapping[sp.Symbol, sp.Expr],
    values: Mapping[Any, Any],
    parameters: Sequence[Parameter] | None = None,
) -> Autonomous:
    """First-order equations without explicit time at numbers, such as a Cartesian slow flow.

    Parameters
    ----------
    rates : mapping
        State → dy/dt, an expression in the states and parameters.
    values : mapping
        Symbol or name → number, for every parameter that occurs.
    parameters : sequence of Parameter, optional
        Against which the values are checked; by default all symbols that are no states.

    Returns
    -------
    Autonomous

    Raises
    ------
    OrbitError
        If a value is missing.
    """
    states, expressions = tuple(rates), tuple(map(sp.sympify, rates.values()))
    occurring = set().union(*(e.free_symbols for e in expressions)) - set(states)
    known = parameters or [Parameter(s) for s in sorted(occurring, key=str)]
    given = named_values(known, values)
    symbols = tuple(p.symbol for p in known if p.symbol in occurring)
    foreign = occurring - set(symbols)
    missing = [str(s) for s in (*symbols, *sorted(foreign, key=str)) if str(s) not in given]
    if missing or foreign:
        raise OrbitError(f"no value is given for {', '.join(missing)}")
    slopes = tuple(e.diff(y) for e in expressions for y in states)
    d = len(states)
    numbers = {str(s.name): float(given[str(s.name)]) for s in symbols}
    function = _of_states(states, symbols, (*expressions, *slopes))
    return Autonomous(d, d, numbers, states, expressions, symbols, function)
