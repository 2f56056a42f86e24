"""Equilibria of a slow flow at numbers: `equilibria`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from .runtime._one_amplitude import equilibria_of_one
from .runtime._records import Equilibria

if TYPE_CHECKING:
    from .slowflow import SlowFlow

__all__ = ["equilibria"]


def equilibria(slow: SlowFlow, values: Mapping[Any, Any]) -> Equilibria:
    """All equilibria of a slow flow, with their growth rates.

    Parameters
    ----------
    slow : SlowFlow
    values : mapping
        Symbol or name → number or array, all broadcasting; for every parameter of the slow flow. A
        detuning follows from the frequencies of its relation where it is not given itself.

    Returns
    -------
    Equilibria
        In the frame that makes the slow flow autonomous.

    Raises
    ------
    ExpansionError
        If no frame makes the slow flow autonomous.
    MmsgenError
        As for `SlowFlow.growth_rate`; or if the equilibria are not isolated, as those of an
        undamped free oscillator.
    """
    table = slow.table
    coefficients = table.numbers(slow.with_detunings(values))
    try:
        if table.flow.n == 1:
            return equilibria_of_one(table.flow, coefficients)
        from .runtime._many_amplitudes import equilibria_of_many

        return equilibria_of_many(table.flow, coefficients)
    except ValueError as error:
        raise MmsgenError(str(error)) from None
