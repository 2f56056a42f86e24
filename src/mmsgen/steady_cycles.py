"""Limit cycles of a slow flow beside quasi-periodic motions of the unexpanded equations.

On a limit cycle the amplitudes go round with a frequency ω of the size ε of the slow flow itself.
What order N omits, ε^{N+1}, changes ω by O(ε^{N+1}), and the cycle, where it is hyperbolic, by that
over the rates of order ε with which disturbances of it die out or grow: by O(ε^N). Seen once in
every period of the excitation the motion is a closed curve, of which the sizes of the Fourier
coefficients are compared.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import orbits
from .consistency import arguments_of
from .errors import CertificateError, OrbitError
from .limit_cycles import LimitCycle, problem_of
from .motion import reconstruction
from .runtime._flow import rates
from .sampling import scaled_values
from .steady import SteadyState, exact_problem

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["EPSILONS", "cycle_gaps"]

EPSILONS = tuple(2.0**-k for k in range(4, 10))
"""The default range of ε; a torus takes as long as a hundred periodic orbits."""

POINTS = 33
"""Of the curve with which the search begins."""

ROUNDING = 1e-10
"""Of a few hundred operations, relative: a thousand times less than digits compared."""


def cycle_gaps(
    case: Expansion,
    module: Any,
    values: Mapping[str, float],
    start: Any,
    weights: Any,
    epsilons: Sequence[float],
) -> tuple[list[tuple[float, float]], list[tuple[float, float]], float]:
    """Errors of a limit cycle's lines and of its frequency over ε, each with its floor.

    Parameters
    ----------
    case : Expansion
    module : module
        The emitted functions.
    values : mapping
        At ε = 1.
    start : numpy.ndarray of complex, shape (n,)
        Amplitudes at ε = 1 from which a motion ends on the cycle.
    weights : numpy.ndarray, shape (n,)
        Order of each coordinate.
    epsilons : sequence of float

    Returns
    -------
    lines : list of (float, float)
        In units of the coordinates.
    frequencies : list of (float, float)
        In rad/s.
    size : float
        The largest line at ε = 1.

    Raises
    ------
    CertificateError
        If the slow flow has a symmetry, or the emitted one is another.
    OrbitError
        If there is no cycle, or no quasi-periodic motion near it.
    """
    if case.slow_flow.table.flow.symmetries:
        raise CertificateError("limit cycles of free motions are not certified")
    lines, frequencies, size, n = [], [], 0.0, len(start)
    cycle, last = None, 1.0
    for epsilon in epsilons:
        slow, exact = scaled_values(case, values, epsilon)
        power = epsilon**weights
        cycle = _near(case, slow, cycle, epsilon / last, weights)
        cycle = cycle or case.slow_flow.limit_cycle(slow, power * start)
        last = epsilon
        found, seen = _exact(case, module, cycle, slow, exact)
        series = np.abs(np.fft.rfft(seen[:n], axis=1)) / POINTS
        gap = np.abs(found.lines(series.shape[1])[:n] - series).max(axis=1) / power
        lines.append((float(2 * gap.max()), float((2 * found.error / power).max())))
        own = found.frequency_error + cycle.frequency * cycle.orbit.period_error / cycle.period
        frequencies.append((abs(found.frequency - cycle.frequency), own))
        size = max(size, float((2 * series.max(axis=1) / power).max()))
    return lines, frequencies, size


def _near(
    case: Expansion, slow: Mapping[str, float], cycle: LimitCycle | None, ratio: float, weights: Any
) -> LimitCycle | None:
    """The cycle at another ε, whose time is slower by the ratio; None where it is not found so."""
    if cycle is None:
        return None
    problem = problem_of(case.slow_flow, cycle.form, slow)
    sizes = ratio ** np.array([weights[j] for j, _ in cycle.form.places])
    guess = sizes[:, None] * cycle.orbit.states
    try:
        return LimitCycle(orbits.find(problem, guess, cycle.period / ratio), cycle.form)
    except OrbitError:
        return None


def _exact(
    case: Expansion,
    module: Any,
    cycle: LimitCycle,
    slow: Mapping[str, float],
    exact: Mapping[str, float],
) -> tuple[orbits.Torus, Any]:
    """The quasi-periodic motion near a cycle, and the states that the cycle has there."""
    times = cycle.period / POINTS * np.arange(POINTS)
    amplitudes = cycle.amplitudes(times)
    _demand_emitted(case, module, slow, amplitudes[:, 0])
    shape = reconstruction(case, slow)
    state = SteadyState(amplitudes[:, 0], np.zeros(len(amplitudes)), slow, exact, shape)
    problem = exact_problem(case, state.exact)
    if problem.base is None:
        raise CertificateError("limit cycles of free motions are not certified")
    _, periods = state.frequency(problem.base)
    # After whole periods all phases but that of the cycle are what they were at first.
    seen = shape(np.zeros(POINTS), amplitudes)
    return orbits.torus(problem, seen, cycle.frequency, periods=periods), seen


def _demand_emitted(case: Expansion, module: Any, slow: Mapping[str, float], b: Any) -> None:
    """Raise if the emitted slow flow is not the one that has the cycle."""
    table = case.slow_flow.table
    wanted = rates(table.flow, table.numbers(slow), b)
    own = module.slow_flow(b, **arguments_of(module.slow_flow, slow))
    if not np.abs(own - wanted).max() <= ROUNDING * np.abs(wanted).max():
        raise CertificateError("slow_flow is not the one of which the limit cycle is")
