"""Equilibria of a slow flow at numbers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from .amplitude_flow import AmplitudeFlow
from .errors import MmsgenError
from .runtime._certificates import certified
from .runtime._many_amplitudes import equilibria_of_many
from .runtime._one_amplitude import equilibria_of_one
from .runtime._records import Equilibria

__all__ = ["certified_equilibria", "equilibria"]


def equilibria(table: AmplitudeFlow, values: Mapping[str, Any]) -> Equilibria:
    """All equilibria of a slow flow, with their growth rates.

    Parameters
    ----------
    table : AmplitudeFlow
    values : mapping
        Name → number or array, all broadcasting; for every parameter of the slow flow.

    Returns
    -------
    Equilibria
        In the frame that makes the slow flow autonomous.

    Raises
    ------
    MmsgenError
        If a value is missing; if equilibria fill curves, as those of undamped free oscillators do;
        if some of several amplitudes can have any value.
    """
    solver = equilibria_of_one if table.flow.n == 1 else equilibria_of_many
    try:
        return solver(table.flow, table.numbers(values))
    except MmsgenError:
        raise
    except ValueError as error:
        raise MmsgenError(str(error)) from None


def certified_equilibria(table: AmplitudeFlow, values: Mapping[str, Any], found: Equilibria) -> Any:
    """Which equilibria are proved; see `SlowFlow.certified`."""
    c, flow = table.numbers(values), table.flow
    shape = np.shape(found.amplitudes)
    if len(shape) < 2 or shape[-1] != flow.n or shape[:-2] != c.shape[:-1]:
        raise MmsgenError(
            f"equilibria of the shape {shape} do not belong to these values: expected "
            f"{(*c.shape[:-1], 'k', flow.n)}".replace("'", "")
        )
    return certified(flow, c, found)
