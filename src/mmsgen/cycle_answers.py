"""What a nonlinear slow flow answers beyond equilibria: its limit cycles."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from .parameters import by_key
from .runtime._records import Bifurcation

if TYPE_CHECKING:
    from .limit_cycles import LimitCycle, LimitCycles
    from .slowflow import SlowFlow

__all__ = ["CycleAnswers"]


class CycleAnswers:
    """The part of `SlowFlow` that finds and follows limit cycles."""

    if TYPE_CHECKING:

        def _with_detunings(self, values: Mapping[Any, Any]) -> dict[str, Any]:
            """Of the slow flow."""
            ...

    def limit_cycle(
        self, values: Mapping[Any, Any], start: Sequence[complex], *, time: float | None = None
    ) -> LimitCycle:
        """The limit cycle of the slow flow that a motion from given amplitudes ends on.

        The system itself then moves quasi-periodically. Where the slow flow is the same in every
        phase of its amplitudes, the cycle is one in a frame that turns with the first of them.

        Parameters
        ----------
        values : mapping
            As for `growth_rate`, numbers alone.
        start : sequence of complex
            B_j, in the autonomous frame.
        time : float, optional
            After which transients are expected to be gone, in s; by default sixty periods of the
            fastest disturbance at the start.

        Returns
        -------
        LimitCycle
            Its period, multipliers, verdict, and amplitudes at any time.

        Raises
        ------
        OrbitError
            If the motion comes to rest or does not repeat, or the slow flow is conservative with
            these numbers: its divergence is zero, and orbits come in families.
        MmsgenError
            As for `growth_rate`.
        """
        from .limit_cycles import limit_cycle

        return limit_cycle(cast("SlowFlow", self), self._with_detunings(values), start, time)

    def limit_cycles(
        self,
        values: Mapping[Any, Any],
        hopf: Bifurcation,
        over: Any,
        ends: tuple[float, float],
        **options: Any,
    ) -> LimitCycles:
        """Limit cycles of the slow flow from a Hopf point on, along one parameter.

        Parameters
        ----------
        values : mapping
            As for `growth_rate`, numbers alone; that of the parameter which varies is ignored.
        hopf : Bifurcation
            As `frequency_response` finds it.
        over : str or sympy.Symbol
            The parameter that varies.
        ends : tuple of float
            Its range.
        **options
            As for `mmsgen.orbits.follow`.

        Returns
        -------
        LimitCycles

        Raises
        ------
        OrbitError
            If there is no such point or no cycle near it.
        """
        from .limit_cycles import limit_cycles

        name = over if isinstance(over, str) else str(getattr(over, "name", over))
        others = {key: v for key, v in by_key(values) if key != name}
        known = self._with_detunings({**others, name: hopf.parameter})
        return limit_cycles(cast("SlowFlow", self), known, hopf, name, ends, **options)
