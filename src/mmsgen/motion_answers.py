"""From a state to amplitudes and back: what a slow flow of any kind says of motions in time."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any, cast

from .uniform_numbers import UniformNumbers, uniform_numbers

if TYPE_CHECKING:
    from .slowflow import SlowFlow

__all__ = ["MotionAnswers"]


class MotionAnswers:
    """The part of `SlowFlow` that takes states to amplitudes and amplitudes to states."""

    if TYPE_CHECKING:

        def _with_detunings(self, values: Mapping[Any, Any]) -> dict[str, Any]:
            """Of the slow flow."""
            ...

    @cached_property
    def _uniform(self) -> UniformNumbers:
        return uniform_numbers(cast("SlowFlow", self))

    def initial_amplitudes(self, values: Mapping[Any, Any], q: Any, v: Any) -> Any:
        """Amplitudes at t = 0 of the motion that has given coordinates and velocities there.

        The uniform approximation with all its harmonics, and its derivative along the slow flow,
        are solved for the amplitudes by Newton's method, from the solution of order zero. Of
        several solutions it is the one that goes over into that as ε → 0.

        Parameters
        ----------
        values : mapping
            As for `growth_rate`; arrays broadcast.
        q, v : array_like
            Coordinates and velocities at t = 0, shape (..., n), in the order of the coordinates.

        Returns
        -------
        numpy.ndarray
            A_j(0) = B_j(0), shape (..., n), complex128; NaN where there are none near those of
            order zero, as far outside of the scaling.

        Raises
        ------
        MmsgenError
            As for `growth_rate`; if q or v is not real and finite, or of another shape.
        """
        return self._uniform.initial(self._with_detunings(values), q, v)

    def response(
        self,
        values: Mapping[Any, Any],
        amplitudes: Any,
        times: Any,
        *,
        order: int | None = None,
        drift: Any = None,
    ) -> Any:
        """Coordinates at times: the uniform approximation with all its harmonics.

        Parameters
        ----------
        values : mapping
            As for `growth_rate`; arrays broadcast with the times.
        amplitudes : array_like
            B_j at these times, shape (..., n): constant at an equilibrium, or from `evolution`.
        times : array_like
            t in s; they broadcast with the leading axes of the amplitudes.
        order : int, optional
            The highest power of ε of the harmonics that are summed; all of them by default.
        drift : array_like, optional
            Of an equilibrium that drifts, shape (..., symmetries), rad/s, as in `Equilibria`.

        Returns
        -------
        numpy.ndarray
            Shape (..., n). A UserWarning says how much is left out where that is estimated at more
            than a tenth of the motion.

        Raises
        ------
        MmsgenError
            As for `growth_rate`; if an argument is not as it should be.
        """
        given = self._with_detunings(values)
        return self._uniform.response(given, amplitudes, times, order=order, drift=drift)
