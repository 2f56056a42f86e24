"""Motions in time with their envelopes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import MmsgenError
from .style import COLOURS, DASHES, on_axes, with_legend

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["time_response"]


def time_response(
    times: Any,
    signals: Mapping[str, Any],
    envelopes: Mapping[str, Any] | None = None,
    *,
    xlabel: str = "t (s)",
    ylabel: str = "",
    axes: Axes | None = None,
) -> Axes:
    """Signals over time, one beside the other, and envelopes ±a(t) around them.

    The first signal is a broad light line, so that those that agree with it are seen upon it.

    Parameters
    ----------
    times : array_like, shape (m,)
        t in s.
    signals : mapping
        Label → values, shape (m,): the exact motion first, then those of slow flows.
    envelopes : mapping, optional
        Label → real amplitude a(t), shape (m,) or a number; drawn as +a and −a.
    xlabel, ylabel : str
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.

    Raises
    ------
    MmsgenError
        If a signal or an envelope has another shape than the times, naming it.
    """
    t = np.asarray(times, dtype=float)
    if t.ndim != 1 or not t.size:
        raise MmsgenError(f"the times must be an array of shape (m,), got {t.shape}")
    for label, values in signals.items():
        _same_length(f"signal {label!r}", values, t, ())
    for label, values in (envelopes or {}).items():
        _same_length(f"envelope {label!r}", values, t, ((), (1,)))
    axes = on_axes(axes, (7.0, 2.8))
    for k, (label, values) in enumerate(signals.items()):
        colour, width = ("0.72", 2.4) if k == 0 else (COLOURS[(k - 1) % len(COLOURS)], 0.9)
        axes.plot(t, values, label=label, color=colour, lw=width)
    for k, (label, values) in enumerate((envelopes or {}).items()):
        a = np.broadcast_to(np.asarray(values, dtype=float), t.shape)
        # A single line there and back, so that it has one entry in the legend.
        both = np.concatenate([a, [np.nan], -a])
        there = np.concatenate([t, [np.nan], t])
        axes.plot(there, both, label=label, color="black", ls=DASHES[(k + 1) % 5], lw=1.1)
    axes.set(xlabel=xlabel, ylabel=ylabel)
    axes.set_xlim(float(t.min()), float(t.max()))
    # Above the axes, which a motion fills.
    return with_legend(axes, ncols=4, loc="lower right", bbox_to_anchor=(1.0, 1.0))


def _same_length(name: str, values: Any, times: Any, others: tuple[tuple[int, ...], ...]) -> None:
    """Refuse values that do not belong to the times."""
    shape = np.shape(values)
    if shape != times.shape and shape not in others:
        raise MmsgenError(f"the {name} has the shape {shape}, the times have {times.shape}")
