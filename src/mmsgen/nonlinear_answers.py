"""What a nonlinear slow flow answers: equilibria, their stability, response and backbone."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from .equilibria import equilibria
from .runtime._records import Equilibria

if TYPE_CHECKING:
    from .amplitude_flow import AmplitudeFlow

__all__ = ["NonlinearAnswers"]


class NonlinearAnswers:
    """The part of `SlowFlow` that is of use for nonlinear slow flows alone."""

    if TYPE_CHECKING:

        @property
        def table(self) -> AmplitudeFlow:
            """Of the slow flow."""
            ...

        def _with_detunings(self, values: Mapping[Any, Any]) -> dict[str, Any]:
            """Of the slow flow."""
            ...

    def equilibria(self, values: Mapping[Any, Any]) -> Equilibria:
        """All equilibria of the autonomous slow flow, and how fast disturbances of each grow.

        Their amplitudes are those of the slow flow as it stands, all orders together.

        Parameters
        ----------
        values : mapping
            As for `growth_rate`; arrays broadcast.

        Returns
        -------
        Equilibria
            ``amplitudes`` (complex, shape (..., k, n)), ``drift``, ``growth``, ``modulus`` and
            ``stable``; NaN after the last equilibrium of a point.

        Raises
        ------
        ExpansionError
            If no frame makes the slow flow autonomous.
        MmsgenError
            As for `growth_rate`; or if the equilibria are not isolated, as those of an undamped
            free oscillator, for which `backbone` is the answer.
        """
        return equilibria(self.table, self._with_detunings(values))
