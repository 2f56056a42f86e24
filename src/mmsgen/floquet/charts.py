"""`chart`: growth rates over a plane of two parameters."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import FloquetError
from ..parameters import by_key
from .exponents import Period, growth
from .points import Floats, Values
from .problem import Options, prepare
from .records import GrowthRate, Verdict
from .system import LinearEquations

__all__ = ["Chart", "chart"]

BLOCK = 2048
"""Points between two calls of the progress callback: about half a second of a 12-state rotor."""


@dataclass(frozen=True, eq=False)
class Chart:
    """Growth rates on a grid.

    Parameters
    ----------
    x_name, y_name : str
        The two parameters.
    x, y : numpy.ndarray, shape (nx,) and (ny,)
        Their values.
    growth : GrowthRate
        Values, errors and verdicts, shape (ny, nx) as ``matplotlib.pcolormesh`` wants it. Points
        that were not computed are undecided, with infinite error.
    computed : numpy.ndarray of bool, shape (ny, nx)
        Which points were computed: all, unless the callback stopped the chart.
    """

    x_name: str
    y_name: str
    x: Floats
    y: Floats
    growth: GrowthRate
    computed: npt.NDArray[np.bool_]

    @property
    def complete(self) -> bool:
        """Whether every point was computed."""
        return bool(self.computed.all())


def chart(
    eom: LinearEquations,
    values: Values,
    x: Mapping[Any, npt.ArrayLike],
    y: Mapping[Any, npt.ArrayLike],
    *,
    progress: Callable[[int, int], object] | None = None,
    period: Period = None,
    tolerance: float = 1e-9,
    threshold: float | None = None,
    max_steps: int = 4096,
    workers: int | None = None,
) -> Chart:
    """Growth rates over two parameters.

    Parameters
    ----------
    eom : EquationsOfMotion
        Linear equations.
    values : mapping of symbol or name to scalar
        The other parameters.
    x, y : mapping of one symbol or name to a 1-D array
        The axes, as ``x={Omega: speeds}``.
    progress : callable, optional
        Called as ``progress(done, total)`` after each block of points. If it returns False the
        chart is returned as far as it has come.
    period, tolerance, threshold, max_steps, workers
        See `growth_rate`; `period` may not be an array.

    Returns
    -------
    Chart
        The grid.

    Raises
    ------
    FloquetError
        If an axis is not one parameter with a 1-D array, the same parameter is given twice, or
        for the reasons that `growth_rate` has.
    """
    x_name, x_values = _axis("x", x)
    y_name, y_values = _axis("y", y)
    others = dict(by_key(values))
    for name in (x_name, y_name):
        if name in others or x_name == y_name:
            raise FloquetError(f"{name!r} is given twice: each parameter is an axis or a value")
    shape = (y_values.size, x_values.size)
    grid_x, grid_y = (g.ravel() for g in np.meshgrid(x_values, y_values))
    total = grid_x.size
    value, error = np.full(total, np.nan), np.full(total, np.inf)
    level = np.full(total, np.nan)
    verdict = np.full(total, Verdict.UNDECIDED.value, dtype="<U9")
    computed = np.zeros(total, dtype=bool)
    options = Options(tolerance, max_steps, workers)
    for start in range(0, total, BLOCK):
        part = slice(start, min(start + BLOCK, total))
        point = {**others, x_name: grid_x[part], y_name: grid_y[part]}
        result = growth(prepare(eom, point, period, options), threshold)
        value[part], error[part] = result.value, result.error
        verdict[part], level[part] = result.verdict, result.threshold
        computed[part] = True
        if progress is not None and progress(part.stop, total) is False:
            break
    rates = GrowthRate(
        value.reshape(shape), error.reshape(shape), verdict.reshape(shape), level.reshape(shape)
    )
    return Chart(x_name, y_name, x_values, y_values, rates, computed.reshape(shape))


def _axis(which: str, axis: Mapping[Any, npt.ArrayLike]) -> tuple[str, Floats]:
    """Name and values of an axis."""
    if not isinstance(axis, Mapping) or len(axis) != 1:
        raise FloquetError(f"{which} must map one parameter to its values, got {axis!r}")
    ((key, raw),) = axis.items()
    name = str(getattr(key, "name", key))
    try:
        array = np.asarray(raw, dtype=np.float64)
    except (TypeError, ValueError):
        raise FloquetError(f"the values of {name!r} on axis {which} are not real numbers") from None
    if array.ndim != 1:
        raise FloquetError(f"the values of {name!r} on axis {which} must be a 1-D array")
    return name, array
