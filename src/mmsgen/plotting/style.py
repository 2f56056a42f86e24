"""Colours, dashes and markers that stay apart, and new axes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["COLOURS", "DASHES", "MARKERS", "line_style", "on_axes", "with_legend"]

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
DASHES: tuple[Any, ...] = ("-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)))
MARKERS = ("o", "s", "^", "D", "v", "x")


def line_style(k: int) -> dict[str, Any]:
    """Colour and dash of line k."""
    return {"color": COLOURS[k % len(COLOURS)], "ls": DASHES[k % len(DASHES)]}


def on_axes(axes: Axes | None, size: tuple[float, float]) -> Axes:
    """The axes given, or new ones of a size in inches."""
    if axes is not None:
        return axes
    import matplotlib.pyplot as plt

    return plt.subplots(figsize=size, layout="constrained")[1]


def with_legend(axes: Axes, *further: Any, **options: Any) -> Axes:
    """A legend of what has a label, and of further artists; none where nothing has."""
    handles = [*further, *axes.get_legend_handles_labels()[0]]
    if handles:
        axes.legend(handles=handles, frameon=False, fontsize="small", **options)
    return axes
