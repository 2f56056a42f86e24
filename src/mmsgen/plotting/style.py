"""Colours, dashes, widths and markers that stay apart; new axes and legends."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..errors import MmsgenError

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = [
    "COLOURS",
    "DASHES",
    "MARKERS",
    "WIDTHS",
    "line_style",
    "on_axes",
    "shared_legend",
    "show_zero",
    "with_legend",
]

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
DASHES: tuple[Any, ...] = ("-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)))
WIDTHS = (2.4, 1.4, 1.0, 1.4)
"""In points. Lines are seen upon the broad first one, and apart from it in grey."""
MARKERS = ("o", "s", "^", "v", "<", ">")


def line_style(k: int) -> dict[str, Any]:
    """Colour, dash and width of line k."""
    places = {"color": COLOURS, "ls": DASHES, "lw": WIDTHS}
    return {name: choice[k % len(choice)] for name, choice in places.items()}


def on_axes(axes: Axes | None, size: tuple[float, float]) -> Axes:
    """The axes given, or new ones of a size in inches."""
    if axes is not None:
        return axes
    import matplotlib.pyplot as plt

    return plt.subplots(figsize=size, layout="constrained")[1]


def with_legend(axes: Axes, **options: Any) -> Axes:
    """A legend of what has a label, lines first, then markers; none where nothing has."""
    handles = sorted(axes.get_legend_handles_labels()[0], key=_is_marker)
    if handles:
        axes.legend(handles=handles, frameon=False, fontsize="small", **options)
    return axes


def show_zero(axes: Axes) -> None:
    """Let the ordinates reach from zero on, and go on growing with what is drawn."""
    axes.update_datalim([(0.0, 0.0)], updatex=False)
    axes.autoscale_view()


def shared_legend(panels: Sequence[Axes], columns: int = 4, **options: Any) -> Any:
    """One legend below the panels of a figure, in place of those that they have of their own.

    Lines come first, then markers; what several panels have in common is there once.

    Parameters
    ----------
    panels : sequence of matplotlib.axes.Axes
        Of one figure, whose layout should be ``"constrained"``.
    columns : int
        Of the legend.
    **options
        Of `matplotlib.figure.Figure.legend`.

    Returns
    -------
    matplotlib.legend.Legend

    Raises
    ------
    MmsgenError
        If there are no panels.
    """
    if not len(panels):
        raise MmsgenError("a shared legend needs at least one panel")
    entries: dict[str, Any] = {}
    for axes in panels:
        for handle in axes.get_legend_handles_labels()[0]:
            entries.setdefault(str(handle.get_label()), handle)
        own = axes.get_legend()
        if own is not None:
            own.remove()
    ordered = sorted(entries.values(), key=_is_marker)
    chosen = {"loc": "outside lower center", "frameon": False, "fontsize": "small", **options}
    return panels[0].figure.legend(handles=ordered, ncols=columns, **chosen)


def _is_marker(artist: Any) -> bool:
    """Whether points alone stand for it."""
    style = getattr(artist, "get_linestyle", lambda: "-")()
    return style in ("None", "none", "", " ")
