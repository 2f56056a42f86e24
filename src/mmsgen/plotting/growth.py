"""Growth rates over a parameter, and how errors fall with ε."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .style import COLOURS, MARKERS, line_style, on_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..certificate import Certificate

__all__ = ["convergence", "growth_rates"]


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
        axes.plot(speeds, values, lw=1.6, label=label, **line_style(k))
    x, y = reference
    axes.plot(x, y, "o", ms=3.2, mfc="none", mec="black", mew=0.7, label="Floquet")
    axes.set(xlabel=xlabel, ylabel="growth rate (1/s)")
    axes.set_xlim(float(np.min(speeds)), float(np.max(speeds)))
    axes.set_ylim(bottom=0)
    axes.legend(frameon=False, fontsize="small")
    return axes


def convergence(
    certificates: Sequence[Certificate],
    labels: Sequence[str] | None = None,
    *,
    quantity: str = "characteristic exponents",
    axes: Axes | None = None,
) -> Axes:
    """Error against ε in logarithmic scales, with the slope that the theory demands.

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
    axes = on_axes(axes, (5.6, 4.2))
    orders = sorted({c.order for c in certificates})
    for k, c in enumerate(certificates):
        label = labels[k] if labels else f"{c.relation}, order {c.order}"
        for fit in c.fits:
            if fit.quantity != quantity:
                continue
            e = np.array(fit.epsilons)[list(fit.resolved)]
            x = np.array(fit.errors)[list(fit.resolved)]
            colour = COLOURS[orders.index(c.order) % len(COLOURS)]
            axes.loglog(
                e,
                x,
                MARKERS[k % len(MARKERS)],
                ms=4,
                mfc="none",
                color=colour,
                label=f"{label}: {fit.exponent:.2f}",
            )
            axes.loglog(e, x[-1] * (e / e[-1]) ** fit.theory, lw=0.8, color=colour)
    unit = "" if quantity.startswith("motions") else " (1/s)"
    axes.set(xlabel="ε", ylabel=f"error of the {quantity}{unit}")
    low, high = axes.get_xlim()
    if high < 50 * low:  # too few decades to be labelled
        axes.set_xscale("log", base=2)
    axes.legend(frameon=False, fontsize="x-small")
    return axes
