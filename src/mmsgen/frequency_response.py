"""Equilibria of a slow flow along one of its parameters."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from .amplitude_flow import AmplitudeFlow
from .errors import MmsgenError
from .numeric import real_numbers
from .parameters import by_key
from .runtime._branches import response_of
from .runtime._records import Response

__all__ = ["frequency_response"]


def _name(symbol: Any) -> str:
    return symbol if isinstance(symbol, str) else str(getattr(symbol, "name", symbol))


def _varied(given: Mapping[str, Any], over: Any) -> str:
    """The parameter that varies: the only one whose value is an array."""
    arrays = [name for name, value in given.items() if np.ndim(value)]
    if over is None:
        if len(arrays) != 1:
            text = ", ".join(arrays) if arrays else "none is"
            raise MmsgenError(
                f"exactly one parameter has to be an array, the one that varies: {text}"
            )
        return arrays[0]
    name = _name(over)
    if name not in given:
        raise MmsgenError(f"no value is given for {name}, which is to vary")
    others = [x for x in arrays if x != name]
    if others:
        raise MmsgenError(f"only {name} varies, so {', '.join(others)} must be a number")
    return name


def frequency_response(
    table: AmplitudeFlow,
    complete: Callable[[Mapping[Any, Any]], dict[str, Any]],
    values: Mapping[Any, Any],
    over: Any,
) -> Response:
    """All equilibria along one parameter, with their bifurcations.

    Parameters
    ----------
    table : AmplitudeFlow
    complete : callable
        Values → values with the detunings that follow from frequencies, checked.
    values : mapping
        Symbol or name → number, and an array of one dimension for the parameter that varies.
    over : symbol, str or None
        That one.

    Raises
    ------
    MmsgenError
        If another parameter is an array, or none is; as `AmplitudeFlow.numbers`; if the equilibria
        are not isolated.
    """
    given = {name: real_numbers(name, value) for name, value in by_key(values)}
    name = _varied(given, over)
    if np.ndim(given[name]) != 1 or not np.size(given[name]):
        raise MmsgenError(f"{name} varies, so its value must be an array of one dimension")
    complete(given)  # everything is checked here, with the names that the user knows

    def coefficients(numbers: Any) -> Any:
        return table.numbers(complete({**given, name: numbers}))

    try:
        return response_of(table.flow, coefficients, np.asarray(given[name]), name)
    except MmsgenError:
        raise
    except ValueError as error:
        raise MmsgenError(str(error)) from None
