"""The uniform approximation of a case at numbers, by the functions that emitted code shares."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import MmsgenError
from .integration import RunAway, solution_at
from .numeric import Evaluator
from .runtime._evolution import checked_times
from .runtime._flow import Flow, rates
from .runtime._initial import initial_at
from .runtime._motion import Motion, response_at
from .runtime._runtime import checked_amplitudes
from .uniform import uniform_motion

if TYPE_CHECKING:
    from .amplitude_flow import AmplitudeFlow
    from .slowflow import SlowFlow

__all__ = ["UniformNumbers", "integrated", "uniform_numbers"]

RTOL, ATOL = 1e-11, 1e-13
"""Of the time integration of slow flows, relative and over the amplitudes at the start."""


@dataclass(frozen=True, eq=False)
class UniformNumbers:
    """Coefficients of the uniform approximation and of the slow flow, ready for numbers.

    Attributes
    ----------
    motion : Motion
    coefficients, rates : Evaluator
        Of the harmonics and frequencies; of the slow flow's right-hand side.
    flow : Flow
    rigid : bool
        Whether the slow flow is linear: its terms then say nothing of what is small.
    """

    motion: Motion
    coefficients: Evaluator
    rates: Evaluator
    flow: Flow
    rigid: bool

    def initial(self, values: Mapping[str, Any], q: Any, v: Any) -> Any:
        """See `SlowFlow.initial_amplitudes`."""
        arguments, fill, right = self._kernels(values)

        def slow(out: Any, *columns: Any) -> None:
            n = self.flow.n
            b = np.stack(np.broadcast_arrays(*columns[:n]), axis=-1)
            c = np.zeros((*out.shape[:-1], len(self.flow.terms)), dtype=complex)
            right(c, *columns[n:])
            out[...] = rates(self.flow, c, b)

        try:
            return initial_at(self.motion, fill, arguments, q, v, (slow, len(arguments), False))
        except MmsgenError:
            raise
        except ValueError as error:
            raise MmsgenError(str(error)) from None

    def response(
        self, values: Mapping[str, Any], amplitudes: Any, times: Any, **options: Any
    ) -> Any:
        """See `SlowFlow.response`."""
        arguments, fill, right = self._kernels(values)
        slow = None if self.rigid else (self.flow, right, len(arguments))
        try:
            return response_at(
                self.motion, fill, arguments, times, amplitudes, slow=slow, **options
            )
        except MmsgenError:
            raise
        except ValueError as error:
            raise MmsgenError(str(error)) from None

    def _kernels(self, values: Mapping[str, Any]) -> tuple[list[Any], Any, Any]:
        """The values that are needed, in one order, and both kernels as functions of them."""
        names = sorted({p.name for e in (self.coefficients, self.rates) for p in e.needed})
        missing = [name for name in names if name not in values]
        if missing:
            raise MmsgenError(f"no value is given for {', '.join(missing)}")

        def filling(evaluator: Evaluator) -> Any:
            def kernel(out: Any, *arguments: Any) -> None:
                own = dict(zip(names, arguments, strict=True))
                numbers = evaluator.plain([own[p.name] for p in evaluator.needed])
                for m, number in enumerate(numbers):
                    out[..., m] = number

            return kernel

        arguments = [np.asarray(values[name], dtype=float) for name in names]
        return arguments, filling(self.coefficients), filling(self.rates)


def uniform_numbers(flow: SlowFlow) -> UniformNumbers:
    """Prepare the uniform approximation of a case.

    Raises
    ------
    ExpansionError
        If no frame makes the slow flow autonomous.
    """
    table, motion = flow.table, uniform_motion(flow.case)
    terms = tuple((t.order, t.coordinate, t.exponents, t.harmonics) for t in motion.terms)
    formulas = [*(t.coefficient for t in motion.terms), *motion.frequencies]
    return UniformNumbers(
        Motion(motion.n, terms, len(motion.frequencies) - motion.n),
        Evaluator(formulas, flow.case.parameters),
        Evaluator(table.coefficients, flow.case.parameters),
        table.flow,
        flow.is_linear,
    )


def integrated(table: AmplitudeFlow, values: Mapping[str, Any], start: Any, times: Any) -> Any:
    """Amplitudes of a nonlinear or driven slow flow at times, by integration from t = 0.

    Raises
    ------
    MmsgenError
        If a value or an amplitude is missing or of another shape than one number, or the amplitudes
        grow beyond all bounds within the time.
    """
    n = table.flow.n
    c = table.numbers(values)
    try:
        b = np.stack(checked_amplitudes(start, n), axis=-1)
        t = checked_times(times)
    except ValueError as error:
        raise MmsgenError(str(error)) from None
    if b.ndim > 1 or c.ndim > 1:
        raise MmsgenError(
            "a nonlinear slow flow is integrated from one start with one set of values: pass "
            f"amplitudes of the shape ({n},) and numbers, and call it for each of several"
        )
    scale = float(np.abs(b).max()) or 1.0
    try:
        return solution_at(lambda _, x: rates(table.flow, c, x), b, t, RTOL, ATOL * scale)
    except RunAway as error:
        raise MmsgenError(
            f"the amplitudes cannot be followed to t = {error.time:g} s: they grow beyond all "
            "bounds, or far too fast for a slow flow"
        ) from None
