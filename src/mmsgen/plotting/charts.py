"""Stability charts in two parameters."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import MmsgenError
from .style import line_style, on_axes, with_legend

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..floquet import Chart

__all__ = ["stability_chart"]


def stability_chart(
    chart: Chart,
    boundaries: Mapping[str, tuple[Any, Any]],
    *,
    scale: tuple[float, float] = (1.0, 1.0),
    xlabel: str | None = None,
    ylabel: str | None = None,
    axes: Axes | None = None,
) -> Axes:
    """Boundaries of several orders over the growth rates of Floquet theory in a plane.

    Where Floquet theory finds growth the plane is shaded, the darker the faster it grows; where it
    cannot tell, points are dotted.

    Parameters
    ----------
    chart : Chart
        From `mmsgen.floquet.chart`.
    boundaries : mapping
        Label → abscissae and ordinates of its curves. One of the two has the shape (m,), the other
        (m,) or (m, curves): both edges of a zone over the other parameter have the shape (m, 2).
        NaN where there is none.
    scale : (float, float)
        Factors of both parameters, as 1/2π for a speed in Hz.
    xlabel, ylabel : str, optional
        By default the names of the parameters.
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.

    Raises
    ------
    MmsgenError
        If the arrays of a boundary do not belong together.
    """
    axes = on_axes(axes, (4.8, 3.6))
    x, y = scale[0] * chart.x, scale[1] * chart.y
    unstable = chart.growth.verdict == "unstable"
    rates = np.ma.masked_array(chart.growth.value, ~unstable)
    top = float(rates.max()) if unstable.any() else 1.0
    # Half of the range of greys: lines must stand out from the darkest.
    axes.pcolormesh(
        x,
        y,
        rates,
        cmap="Greys",
        vmin=-0.3 * top,
        vmax=2.0 * top,
        shading="nearest",
        rasterized=True,
    )
    if unstable.any():  # what stands for the shading in a legend
        axes.fill([], [], facecolor="0.75", label="unstable (Floquet)")
    unknown = chart.computed & (chart.growth.verdict == "undecided")
    if unknown.any():
        rows, columns = np.nonzero(unknown)
        axes.plot(x[columns], y[rows], ",", color="black", label="undecided (Floquet)")
    for k, (label, (across, along)) in enumerate(boundaries.items()):
        _curves(axes, label, scale[0] * np.asarray(across), scale[1] * np.asarray(along), k)
    axes.set(xlabel=xlabel or chart.x_name, ylabel=ylabel or chart.y_name)
    axes.set_xlim(float(x.min()), float(x.max()))
    axes.set_ylim(float(y.min()), float(y.max()))
    # Above the axes, which the zones fill.
    return with_legend(axes, ncols=4, loc="lower right", bbox_to_anchor=(1.0, 1.0))


def _curves(axes: Axes, label: str, x: Any, y: Any, k: int) -> None:
    """All curves of one label, of which the first alone is in the legend."""
    shapes = {x.shape[0] if x.ndim else -1, y.shape[0] if y.ndim else -2}
    if len(shapes) != 1 or {x.ndim, y.ndim} - {1, 2} or x.ndim == y.ndim == 2:
        raise MmsgenError(
            f"the boundary {label!r} needs arrays of the shapes (m,) and (m,) or (m, curves), "
            f"got {x.shape} and {y.shape}"
        )
    lines = axes.plot(x, y, **line_style(k))
    lines[0].set_label(label)
