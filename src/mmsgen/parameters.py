"""`Parameter`: a symbol of the model with its unit, its meaning and its domain."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp

from .errors import MmsgenError, ModelError

__all__ = ["Parameter", "by_key", "by_name"]


@dataclass(frozen=True)
class Parameter:
    """A parameter of a model.

    Parameters
    ----------
    symbol : sympy.Symbol
        Carries the domain in its assumptions: ``positive``, ``nonnegative`` or ``real``.
    unit : str
        SI unit, ``"1"`` for a ratio.
    meaning : str
        One phrase for tables and docstrings.
    definition : sympy.Expr, optional
        The symbol in terms of other parameters, where it stands for an expression, such as a
        frequency that depends on the rotor speed.

    Raises
    ------
    ModelError
        If `symbol` is not a symbol, unit or meaning is no text, the definition is no expression,
        or it contains the symbol itself.
    """

    symbol: sp.Symbol
    unit: str = "1"
    meaning: str = ""
    definition: sp.Expr | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.symbol, sp.Symbol):
            raise ModelError(
                f"a parameter needs a sympy.Symbol, got {self.symbol!r}: "
                "declare it with sympy.Symbol(name, positive=True) or real=True"
            )
        for what, text in (("unit", self.unit), ("meaning", self.meaning)):
            if not isinstance(text, str):
                raise ModelError(
                    f"the {what} of {self.symbol} must be text, got {text!r}: "
                    'Parameter(symbol, "rad/s", "rotor speed")'
                )
        if self.definition is not None and not isinstance(self.definition, sp.Expr):
            raise ModelError(
                f"the definition of {self.symbol} must be a SymPy expression, "
                f"got {self.definition!r}"
            )
        if self.definition is not None and self.definition.has(self.symbol):
            raise ModelError(f"the definition of {self.symbol} contains {self.symbol} itself")

    @property
    def name(self) -> str:
        """The symbol's name: the keyword under which emitted functions take its value."""
        return str(self.symbol.name)


def by_name(parameters: Iterable[Parameter]) -> dict[str, Parameter]:
    """Parameters keyed by name, in their order.

    Raises
    ------
    ModelError
        If two parameters share a name.
    """
    table: dict[str, Parameter] = {}
    for parameter in parameters:
        if parameter.name in table:
            raise ModelError(f"two parameters are called {parameter.name!r}: rename one of them")
        table[parameter.name] = parameter
    return table


def by_key(values: Mapping[Any, Any]) -> list[tuple[str, Any]]:
    """The pairs of name and value that a user passes.

    Parameters
    ----------
    values : mapping
        Symbol or name → anything.

    Raises
    ------
    MmsgenError
        If it is no mapping, or a name occurs twice.
    """
    if not isinstance(values, Mapping):
        raise MmsgenError(
            "values must be a mapping, {symbol or name: number or array}, got "
            f"{type(values).__name__} {str(values)[:40]}"
        )
    found = [(str(getattr(key, "name", key)), value) for key, value in values.items()]
    names = [name for name, _ in found]
    for name in names:
        if names.count(name) > 1:
            raise MmsgenError(f"a value for {name} is given twice, by symbol and by name")
    return found
