"""Expressions at numbers: the values that a user passes, checked and broadcast."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from decimal import Decimal
from functools import lru_cache
from numbers import Real
from typing import Any

import numpy as np
import sympy as sp

from .errors import MmsgenError
from .parameters import Parameter, by_key, by_name
from .runtime._runtime import refuse_masked

__all__ = ["Evaluator", "compiled", "finite_amplitudes", "named_values", "real_numbers"]

LONGEST = 200
"""Terms of a sum in compiled code."""


def real_numbers(name: str, value: Any) -> Any:
    """A value as an array of floats: Python's numbers, NumPy's and SymPy's.

    Parameters
    ----------
    name : str
        Of the parameter.
    value : array_like
        Fractions, decimals and exact numbers of SymPy among them.

    Raises
    ------
    MmsgenError
        If a number is not real and finite, or none at all.
    """
    try:
        refuse_masked(name, value)
    except ValueError as error:
        raise MmsgenError(str(error)) from None
    try:
        number = np.asarray(value)
    except ValueError:
        number = np.asarray(None)  # ragged
    if number.dtype == object:
        floats = [_real(name, x) for x in number.ravel()]
        number = np.array(floats, dtype=float).reshape(number.shape)
    if number.dtype.kind not in "iuf" or not np.all(np.isfinite(number)):
        raise MmsgenError(f"the value of {name} must be real and finite, got {value!r}")
    return number.astype(float)


def finite_amplitudes(amplitudes: Any) -> Any:
    """Amplitudes B_j as complex numbers.

    Raises
    ------
    MmsgenError
        If one is no finite number.
    """
    try:
        refuse_masked("the array of amplitudes", amplitudes)
        b = np.asarray(amplitudes)
    except ValueError as error:
        raise MmsgenError(f"amplitudes must be finite complex numbers: {error}") from None
    if b.dtype.kind not in "iufc" or not np.isfinite(b).all():
        raise MmsgenError(f"amplitudes must be finite complex numbers, got {amplitudes!r}")
    return b.astype(complex)


def _real(name: str, value: Any) -> float:
    """One number that NumPy does not know; NaN if it is none."""
    if isinstance(value, sp.Basic) and value.free_symbols:
        raise MmsgenError(
            f"the value of {name} must be a number, got the expression {value}: put numbers in for "
            f"{', '.join(sorted(map(str, value.free_symbols)))}"
        )
    known = isinstance(value, Real | Decimal) and not isinstance(value, bool)
    if not known and not (isinstance(value, sp.Expr) and value.is_extended_real):
        return np.nan
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        return np.nan


def named_values(parameters: Sequence[Parameter], values: Mapping[Any, Any]) -> dict[str, Any]:
    """Values by parameter name, those of parameters with a definition filled in.

    Parameters
    ----------
    parameters : sequence of Parameter
    values : mapping
        Symbol or name → number or array.

    Returns
    -------
    dict
        Name → float array, for every parameter that is given or follows from its definition.

    Raises
    ------
    MmsgenError
        If the values are no mapping; if one is given for an unknown parameter, twice, is not a
        finite real number or has a sign that its symbol excludes; or if their shapes do not
        broadcast.
    """
    known = by_name(parameters)
    table: dict[str, Any] = {}
    for name, value in by_key(values):
        if name not in known:
            raise MmsgenError(f"{name} is not a parameter here; known are {', '.join(known)}")
        table[name] = real_numbers(name, value)
        _check_domain(known[name], table[name])
    _check_shapes(table)
    pending = {p.name: p.definition for p in parameters if p.definition and p.name not in table}
    while pending:
        ready = {n: d for n, d in pending.items() if {str(s) for s in d.free_symbols} <= set(table)}
        if not ready:
            break
        for name, definition in ready.items():
            symbols = tuple(sorted(definition.free_symbols, key=str))
            with np.errstate(all="ignore"):
                (number,) = compiled(symbols, (definition,))(*(table[str(s)] for s in symbols))
            table[name] = np.asarray(number, dtype=float)
            if not np.all(np.isfinite(table[name])):
                raise MmsgenError(f"{name} = {definition} has no real value at these numbers")
            del pending[name]
    return table


@lru_cache(maxsize=256)
def compiled(
    symbols: tuple[sp.Symbol, ...], expressions: tuple[sp.Expr, ...]
) -> Callable[..., list[Any]]:
    """A NumPy function of the symbols that returns the expressions' values.

    Compiling takes milliseconds, and the same few expressions come at every call.
    """
    function: Callable[..., list[Any]] = sp.lambdify(
        symbols, list(expressions), "numpy", cse=_common_parts, dummify=True
    )
    return function


def _common_parts(
    expressions: list[sp.Expr],
) -> tuple[list[tuple[sp.Symbol, sp.Expr]], list[sp.Expr]]:
    """Common subexpressions, and long sums in parts: Python nests a sum as deep as it is long."""
    replacements, reduced = sp.cse(expressions)
    parts: list[tuple[sp.Symbol, sp.Expr]] = []

    def split(sum_: sp.Expr) -> sp.Expr:
        terms = list(sum_.args)
        while len(terms) > LONGEST:
            chunk, terms = terms[:LONGEST], terms[LONGEST:]
            name = sp.Dummy("part")
            parts.append((name, sp.Add(*chunk)))
            terms.append(name)
        return sp.Add(*terms)

    def short(expression: sp.Expr) -> sp.Expr:
        return expression.replace(lambda e: e.is_Add and len(e.args) > LONGEST, split)

    for name, expression in replacements:
        own = short(expression)
        parts.append((name, own))
    return parts, [short(e) for e in reduced]


def _check_domain(parameter: Parameter, number: Any) -> None:
    """The sign that is declared of the symbol."""
    symbol = parameter.symbol
    for declared, wrong, text in (
        (symbol.is_positive, number <= 0.0, "positive"),
        (symbol.is_negative, number >= 0.0, "negative"),
        (symbol.is_nonnegative, number < 0.0, "zero or positive"),
        (symbol.is_nonpositive, number > 0.0, "zero or negative"),
    ):
        if declared and np.any(wrong):
            value = np.ravel(number)[np.argmax(np.ravel(wrong))]
            raise MmsgenError(f"{parameter.name} must be {text}, got {float(value)!r}")


def _check_shapes(table: Mapping[str, Any]) -> None:
    try:
        np.broadcast_shapes(*(v.shape for v in table.values()))
    except ValueError:
        shown = ", ".join(f"{name} {v.shape}" for name, v in table.items() if v.ndim)
        raise MmsgenError(f"the shapes of the values do not broadcast: {shown}") from None


class Evaluator:
    """Expressions in parameters, compiled once for numbers.

    Parameters
    ----------
    expressions : sequence of sympy.Expr
    parameters : sequence of Parameter
        Those that may occur.
    """

    def __init__(self, expressions: Sequence[sp.Expr], parameters: Sequence[Parameter]) -> None:
        self.parameters = tuple(parameters)
        present = set().union(*(e.free_symbols for e in expressions))
        self.needed = tuple(p for p in parameters if p.symbol in present)
        self._function = compiled(tuple(p.symbol for p in self.needed), tuple(expressions))

    def __call__(self, values: Mapping[Any, Any]) -> list[Any]:
        """Evaluate the expressions at numbers or arrays that broadcast.

        Parameters
        ----------
        values : mapping
            Symbol or name → number or array.

        Raises
        ------
        MmsgenError
            If a parameter that occurs has no value, or as for `named_values`.
        """
        table = named_values(self.parameters, values)
        missing = [p.name for p in self.needed if p.name not in table]
        if missing:
            raise MmsgenError(f"no value is given for {', '.join(missing)}")
        with np.errstate(all="ignore"):  # where a divisor vanishes, the result is not finite
            found = self._function(*(table[p.name] for p in self.needed))
        return [np.asarray(x) for x in found]

    def plain(self, arguments: Sequence[Any]) -> list[Any]:
        """The values from those of `needed`, in its order, without any check."""
        return self._function(*arguments)
