"""Equilibria of a slow flow at numbers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .amplitude_flow import AmplitudeFlow
from .errors import ExpansionError, MmsgenError
from .runtime._one_amplitude import equilibria_of_one
from .runtime._records import Equilibria

__all__ = ["equilibria"]


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
        If a value is missing; if the equilibria are not isolated, as those of an undamped free
        oscillator.
    """
    if table.flow.n > 1:
        raise ExpansionError("equilibria of more than one amplitude are not implemented")
    try:
        return equilibria_of_one(table.flow, table.numbers(values))
    except MmsgenError:
        raise
    except ValueError as error:
        raise MmsgenError(str(error)) from None
