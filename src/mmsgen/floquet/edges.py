"""`boundary`: the edges of the unstable zones along one parameter.

A scan finds where the growth rate crosses a level; a bracketing root finder, all crossings at
once, finds it to the last digits. In an undamped system the growth rate
is zero outside a zone and goes like the square root of the distance inside: the level must be
above the noise of colliding multipliers, and the edge, where growth begins, is found from the
crossings of four levels. Inside, the parameter is a smooth function of the growth rate,
p = p₀ + a g + b g² + …, with a = 0 at the edge of an undamped system and a ≠ 0 where damping turns
into growth, so one extrapolation to g = 0 serves both.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from ..errors import FloquetError
from ..parameters import by_key
from .exponents import Period, growth
from .points import Floats, Values
from .problem import Options, prepare
from .records import GrowthRate
from .system import LinearEquations

__all__ = ["Boundary", "boundary"]

Rate: TypeAlias = Callable[[Floats], GrowthRate]

LEVELS = 4
# Growth that counts, in units of the parametric frequency: well above the noise of colliding
# multipliers (1e-8 of it in doubles), and so low that the extrapolation has little to do.
LEVEL = 1e-6


@dataclass(frozen=True, eq=False)
class Boundary:
    """Edges of the unstable zones along one parameter.

    Parameters
    ----------
    parameter : str
        Its name.
    value, error : numpy.ndarray, shape (edges,)
        Edges in ascending order, with their estimated errors.
    zones : tuple of (float, float)
        The unstable zones; one that reaches an end of the interval is cut there.
    threshold : float
        Growth rate in s⁻¹ above which a scanned point counts as unstable.
    scan_values : numpy.ndarray, shape (points,)
        The scanned parameter values.
    scan : GrowthRate
        Growth rates at them.
    """

    parameter: str
    value: Floats
    error: Floats
    zones: tuple[tuple[float, float], ...]
    threshold: float
    scan_values: Floats
    scan: GrowthRate

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        """The edges alone, for NumPy."""
        return np.array(self.value, dtype=dtype, copy=copy)


def boundary(
    eom: LinearEquations,
    values: Values,
    parameter: Any,
    interval: tuple[float, float],
    *,
    threshold: float | None = None,
    points: int = 1001,
    period: Period = None,
    tolerance: float = 1e-9,
    max_steps: int = 4096,
    workers: int | None = None,
) -> Boundary:
    """Find the edges of the unstable zones.

    Parameters
    ----------
    eom : EquationsOfMotion
        Linear equations.
    values : mapping of symbol or name to scalar
        The other parameters.
    parameter : sympy.Symbol or str
        The parameter to vary.
    interval : (float, float)
        Where to look.
    threshold : float, optional
        Growth rate in s⁻¹ that makes the edge. By default the edge is where growth begins.
    points : int
        Points of the scan: zones narrower than their distance can be missed.
    period, tolerance, max_steps, workers
        See `growth_rate`; `period` may not be an array.

    Returns
    -------
    Boundary
        All edges found, with their errors.

    Raises
    ------
    FloquetError
        If the interval is not two finite ascending numbers, `points` is below 3, another value
        is an array, or for the reasons that `growth_rate` has.
    """
    low, high = _interval(interval)
    name, others = _fixed(values, parameter, points)
    options = Options(tolerance, max_steps, workers)

    def rate(at: Floats) -> GrowthRate:
        # Against the level of growth sought, a thousandth of it is small.
        rough = replace(options, enough=1e-3 * level if extrapolate else 0.0)
        return growth(prepare(eom, {**others, name: at}, period, rough), None)

    grid = np.linspace(low, high, points)
    problem = prepare(eom, {**others, name: grid}, period, options)
    scan = growth(problem, None)
    extrapolate = threshold is None
    smallest = LEVEL * _frequency(problem.period, scan)
    level = smallest if threshold is None else float(threshold)
    # Near a threshold of the user's, a second level is there to tell the slope.
    step = smallest if extrapolate else 1e-3 * max(abs(level), smallest)
    # Noise must not make zones: without a threshold of the user's, growth must be certain.
    margin = scan.error if extrapolate else np.zeros(points)
    unstable = scan.value - margin > level
    change = np.flatnonzero(unstable[1:] != unstable[:-1])
    edges, errors = np.empty(0), np.empty(0)
    if change.size:
        inside = np.where(unstable[change], grid[change], grid[change + 1])
        outside = np.where(unstable[change], grid[change + 1], grid[change])
        edges, errors = _locate(rate, outside, inside, level, step, extrapolate)
    return Boundary(name, edges, errors, _zones(edges, unstable, low, high), level, grid, scan)


def _fixed(values: Values, parameter: Any, points: int) -> tuple[str, dict[str, Any]]:
    """The name of the parameter that is varied, and the values of the others."""
    name = str(getattr(parameter, "name", parameter))
    others = dict(by_key(values))
    if points < 3:
        raise FloquetError(f"a scan needs at least 3 points, got {points!r}")
    if name in others:
        raise FloquetError(f"{name!r} is varied over the interval: take it out of `values`")
    if any(np.ndim(np.array(value, dtype=object)) for value in others.values()):
        raise FloquetError("boundary varies one parameter: the other values must be scalars")
    return name, others


def _interval(interval: tuple[float, float]) -> tuple[float, float]:
    try:
        low, high = (float(end) for end in interval)
    except (TypeError, ValueError):
        raise FloquetError(f"interval must be two numbers, got {interval!r}") from None
    if not (np.isfinite(low) and np.isfinite(high) and low < high):
        raise FloquetError(f"interval must be finite and ascending, got {interval!r}")
    return low, high


def _frequency(period: Floats | None, scan: GrowthRate) -> float:
    """Scale of growth rates: 2π/T, or a thousand times the resolution where there is no T."""
    if period is not None:
        return float(np.median(2 * np.pi / period))
    return float(np.median(scan.threshold)) * 1e3 / LEVEL


def _locate(
    rate: Rate, outside: Floats, inside: Floats, level: float, step: float, extrapolate: bool
) -> tuple[Floats, Floats]:
    """Edges between pairs of points, and their errors."""
    levels: Floats = level + step * np.arange(float(LEVELS if extrapolate else 2))
    crossing, noise = _cross(rate, outside, inside, levels)
    first, noises = crossing[0], noise.max(axis=0)
    if extrapolate:
        second, third, fourth = crossing[1:]
        edges = 3 * first - 3 * second + third
        # The next difference is what the quadratic left out; the crossings enter with 3 + 3 + 1.
        errors = np.abs(fourth - 3 * third + 3 * second - first) + 7 * noises
    else:
        edges, errors = first, noises
    # A zone whose scanned point grows by less than the highest level is known to the scan only.
    weak = ~np.isfinite(errors)
    edges = np.where(weak, np.where(np.isfinite(first), first, (inside + outside) / 2), edges)
    return edges, np.where(weak, np.abs(inside - outside), errors)


def _cross(rate: Rate, outside: Floats, inside: Floats, levels: Floats) -> tuple[Floats, Floats]:
    """Where the growth rate crosses each level between each pair, and the error by its noise.

    Both have the shape (levels, pairs), NaN where the inner point does not reach the level.
    """
    from scipy.optimize.elementwise import find_root  # loads slowly

    def excess(at: Floats, level: Floats) -> Floats:
        growth = rate(at)
        # The square goes like the distance from the edge; with the sign it stays monotonic.
        gap = growth.value * np.abs(growth.value) - level * np.abs(level)
        # A level that is met to within the noise is met.
        return np.where(np.abs(growth.value - level) <= growth.error, 0.0, gap)

    ends = np.minimum(outside, inside), np.maximum(outside, inside)
    digits = 4 * np.finfo(np.float64).eps
    with np.errstate(all="ignore"):
        found = find_root(
            excess, ends, args=(levels[:, None],), tolerances={"xatol": 0.0, "xrtol": digits}
        )
    crossing = np.where(found.success, found.x, np.nan)
    reached = np.isfinite(crossing)
    error = np.full(crossing.shape, np.nan)
    error[reached] = rate(crossing[reached]).error
    # The error of the growth rate, divided by the slope, moves the crossing.
    slope = np.gradient(crossing, levels, axis=0)
    return crossing, np.abs(slope) * error + digits * np.abs(crossing)


def _zones(
    edges: Floats, unstable: npt.NDArray[np.bool_], low: float, high: float
) -> tuple[tuple[float, float], ...]:
    """Pairs of edges, with the ends of the interval where a zone is cut."""
    ends = [*([low] if unstable[0] else []), *edges.tolist(), *([high] if unstable[-1] else [])]
    return tuple(zip(ends[::2], ends[1::2], strict=True))
