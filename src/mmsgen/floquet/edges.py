"""`boundary`: the edges of the unstable zones along one parameter.

A scan finds where the growth rate crosses a level; repeated subdivision of each crossing into 16
parts, all crossings at once, finds it to the last digits. In an undamped system the growth rate
is zero outside a zone and goes like the square root of the distance inside: the level must be
above the noise of colliding multipliers, and the edge, where growth begins, is found from the
crossings of four levels. Inside, the parameter is a smooth function of the growth rate,
p = p₀ + a g + b g² + …, with a = 0 at the edge of an undamped system and a ≠ 0 where damping turns
into growth, so one extrapolation to g = 0 serves both.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import FloquetError
from .exponents import Period, growth
from .points import Floats, Values
from .problem import Options, prepare
from .records import GrowthRate
from .system import LinearEquations

__all__ = ["Boundary", "boundary"]

PARTS = 16
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
    name = str(getattr(parameter, "name", parameter))
    others = {str(getattr(key, "name", key)): value for key, value in values.items()}
    low, high = _interval(interval)
    if points < 3:
        raise FloquetError(f"a scan needs at least 3 points, got {points!r}")
    if name in others:
        raise FloquetError(f"{name!r} is varied over the interval: take it out of `values`")
    if any(np.ndim(value) for value in others.values()):
        raise FloquetError("boundary varies one parameter: the other values must be scalars")
    options = Options(tolerance, max_steps, workers)

    def rate(at: Floats) -> GrowthRate:
        # Against the level of growth sought, a thousandth of it is small.
        rough = replace(options, enough=1e-3 * level if extrapolate else 0.0)
        problem = prepare(eom, {**others, name: at.ravel()}, period, rough)
        return growth(problem, None)

    grid = np.linspace(low, high, points)
    problem = prepare(eom, {**others, name: grid}, period, options)
    scan = growth(problem, None)
    extrapolate = threshold is None
    if threshold is None:
        level = LEVEL * _frequency(problem.period, scan)
    else:
        level = float(threshold)
    # Noise must not make zones: without a threshold of the user's, growth must be certain.
    margin = scan.error if extrapolate else np.zeros(points)
    unstable = scan.value - margin > level
    change = np.flatnonzero(unstable[1:] != unstable[:-1])
    edges, errors = np.empty(0), np.empty(0)
    if change.size:
        inside = np.where(unstable[change], grid[change], grid[change + 1])
        outside = np.where(unstable[change], grid[change + 1], grid[change])
        edges, errors = _locate(rate, outside, inside, level, extrapolate)
    return Boundary(name, edges, errors, _zones(edges, unstable, low, high), level, grid, scan)


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
    rate: Callable[[Floats], GrowthRate],
    outside: Floats,
    inside: Floats,
    level: float,
    extrapolate: bool,
) -> tuple[Floats, Floats]:
    """Edges between pairs of points, and their errors."""
    count = LEVELS if extrapolate else 1
    levels = level * np.arange(1.0, count + 1)
    crossing, width, noise = _cross(rate, outside, inside, levels)
    if not extrapolate:
        return crossing[0], width[0] + noise[0]
    first, second, third, fourth = crossing
    edges = 3 * first - 3 * second + third
    # The next difference is what the quadratic left out; the crossings enter with 3 + 3 + 1.
    errors = np.abs(fourth - 3 * third + 3 * second - first) + 7 * (width + noise).max(axis=0)
    # A zone whose scanned point grows by less than the highest level is known to the scan only.
    weak = ~np.isfinite(edges)
    edges = np.where(weak, np.where(np.isfinite(first), first, (inside + outside) / 2), edges)
    return edges, np.where(weak, np.abs(inside - outside), errors)


def _cross(
    rate: Callable[[Floats], GrowthRate], outside: Floats, inside: Floats, levels: Floats
) -> tuple[Floats, Floats, Floats]:
    """Where the growth rate crosses each level between each pair: (value, width, error by noise).

    All have the shape (levels, pairs), NaN where the inner point does not reach the level.
    """
    shape = (levels.size, outside.size)
    level = np.broadcast_to(levels[:, None], shape)
    ends = rate(np.stack([outside, inside]))
    # A bracket is (parameter, growth, error) at its lower and at its higher end.
    low = np.stack([np.broadcast_to(x[0], shape) for x in (outside[None], ends.value, ends.error)])
    high = np.stack([np.broadcast_to(x[-1], shape) for x in (inside[None], ends.value, ends.error)])
    reached = high[1] > level
    active = reached.copy()
    while active.any():
        low[:, active], high[:, active] = _subdivide(
            rate, low[:, active], high[:, active], level[active]
        )
        width = np.abs(high[0] - low[0])
        digits = 2 * np.spacing(np.maximum(np.abs(low[0]), np.abs(high[0])))
        # Once the growth across the bracket is noise, subdividing it further says nothing.
        active = reached & (width > digits) & (high[1] - low[1] > high[2])
    width = np.abs(high[0] - low[0])
    middle = np.where(reached, (low[0] + high[0]) / 2, np.nan)
    rise = np.maximum(high[1] - low[1], 0.0)
    # The error of the growth rate, divided by the slope, moves the crossing.
    noise = np.where(rise > high[2], width * high[2] / np.where(rise > 0, rise, 1.0), width)
    return middle, width, noise


def _subdivide(
    rate: Callable[[Floats], GrowthRate], low: Floats, high: Floats, level: Floats
) -> tuple[Floats, Floats]:
    """One of the 16 parts of each bracket: the outermost in which the level is crossed."""
    at = low[0][:, None] + (high[0] - low[0])[:, None] * (np.arange(1, PARTS) / PARTS)
    result = rate(at)
    inner = np.stack([at, result.value.reshape(at.shape), result.error.reshape(at.shape)])
    nodes = np.concatenate([low[:, :, None], inner, high[:, :, None]], axis=2)
    first = (nodes[1, :, 1:] > level[:, None]).argmax(axis=1)
    row = np.arange(first.size)
    return nodes[:, row, first], nodes[:, row, first + 1]


def _zones(
    edges: Floats, unstable: npt.NDArray[np.bool_], low: float, high: float
) -> tuple[tuple[float, float], ...]:
    """Pairs of edges, with the ends of the interval where a zone is cut."""
    ends = [*([low] if unstable[0] else []), *edges.tolist(), *([high] if unstable[-1] else [])]
    return tuple(zip(ends[::2], ends[1::2], strict=True))
