"""Growth rates over a parameter, and how errors fall with ε."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from .style import COLOURS, MARKERS, line_style, on_axes, show_zero, with_legend

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..certificate import Certificate

__all__ = ["convergence", "growth_rates"]

_ERRORS = {
    "characteristic exponents": "characteristic exponents (1/s)",
    "stability": "exponents of disturbances (1/s)",
    "edges of the zone": "edges of the zone (rad/s)",
    "frequency": "frequency (rad/s)",
    "frequency of the Hopf point": "frequency of the Hopf point (rad/s)",
}
"""What the errors of fits are of, where that has the same unit in every case."""


def growth_rates(
    speeds: Any,
    reference: tuple[Any, Any],
    curves: Mapping[str, Any],
    zones: Sequence[tuple[float, float]] = (),
    *,
    xlabel: str = "rotor speed (Hz)",
    axes: Axes | None = None,
) -> Axes:
    """Growth rate over a parameter: reference as points, expansions as lines, zones shaded.

    Parameters
    ----------
    speeds : array_like, shape (n,)
        Abscissae of the lines.
    reference : (array_like, array_like)
        Abscissae and growth rates (1/s) of the reference.
    curves : mapping
        Label → growth rate in 1/s, shape (n,).
    zones : sequence of (float, float)
        Intervals to shade.
    xlabel : str
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.
    """
    axes = on_axes(axes, (7.0, 3.6))
    for k, (low, high) in enumerate(zones):
        label = "unstable (Floquet)" if k == 0 else None
        axes.axvspan(low, high, color="0.9", lw=0, label=label)
    for k, (label, values) in enumerate(curves.items()):
        axes.plot(speeds, values, label=label, **line_style(k))
    x, y = reference
    axes.plot(x, y, "o", ms=3.2, mfc="none", mec="black", mew=0.7, label="Floquet")
    axes.set(xlabel=xlabel, ylabel="growth rate (1/s)")
    axes.set_xlim(float(np.min(speeds)), float(np.max(speeds)))
    show_zero(axes)
    return with_legend(axes)


def convergence(
    certificates: Sequence[Certificate],
    labels: Sequence[str] | None = None,
    *,
    quantity: str = "characteristic exponents",
    axes: Axes | None = None,
) -> Axes:
    """Error against ε in logarithmic scales, with the slope that the theory demands.

    The legend tells the exponent that is fitted to the points.

    Parameters
    ----------
    certificates : sequence of Certificate
    labels : sequence of str, optional
        By default the relation and the order.
    quantity : str
        Which of the fits to draw.
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.
    """
    from matplotlib.lines import Line2D

    axes = on_axes(axes, (4.8, 4.0))
    for k, c in enumerate(certificates):
        label = labels[k] if labels else f"{_mathtext(c.relation)}, order {c.order}"
        colour = COLOURS[(c.order - 1) % len(COLOURS)]
        style: dict[str, Any] = {"ms": 4.5, "mfc": "none", "color": colour}
        for fit in c.fits:
            if fit.quantity != quantity:
                continue
            e = np.array(fit.epsilons)[list(fit.resolved)]
            x = np.array(fit.errors)[list(fit.resolved)]
            text = rf"{label}: $\varepsilon^{{{fit.exponent:.2f}}}$"
            axes.loglog(e, x, MARKERS[k % len(MARKERS)], label=text, **style)
            axes.loglog(e, x[-1] * (e / e[-1]) ** fit.theory, lw=0.9, color=colour)
    axes.set(xlabel="ε", ylabel=f"error of the {_ERRORS.get(quantity, quantity)}")
    low, high = axes.get_xlim()
    if high < 50 * low:  # too few decades to be labelled
        axes.set_xscale("log", base=2)
    handles = axes.get_legend_handles_labels()[0]
    if handles:
        slope = Line2D([], [], lw=0.9, color="black", label="exponent of the theory")
        # Above the axes, which the lines cross.
        place: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "ncols": 2}
        axes.legend(handles=[*handles, slope], frameon=False, fontsize="small", **place)
    return axes


def _mathtext(relation: str) -> str:
    """A resonance relation as Matplotlib typesets it."""
    if "=" not in relation:
        return "non-resonant"
    names = re.sub(r"[^\W\d]\w*", lambda name: sp.latex(sp.Symbol(name[0])), relation)
    return f"${names.replace('*', ' ')}$"
