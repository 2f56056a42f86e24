"""Figures: Matplotlib axes that a user can restyle. Needs the extra ``plot``.

Colours are those of Okabe and Ito (2008), which stay apart for colour-blind readers; lines differ
in dash as well, so that they stay apart in print.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .certificate import Certificate

__all__ = ["convergence", "growth_rates"]

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
DASHES: tuple[Any, ...] = ("-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)))
MARKERS = ("o", "s", "^", "D", "v", "x")


def _axes(axes: Axes | None, size: tuple[float, float]) -> Axes:
    if axes is not None:
        return axes
    import matplotlib.pyplot as plt

    return plt.subplots(figsize=size, layout="constrained")[1]


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
    axes = _axes(axes, (7.0, 3.6))
    for k, (low, high) in enumerate(zones):
        label = "unstable (Floquet)" if k == 0 else None
        axes.axvspan(low, high, color="0.9", lw=0, label=label)
    for k, (label, values) in enumerate(curves.items()):
        style = {"color": COLOURS[k % len(COLOURS)], "ls": DASHES[k % len(DASHES)]}
        axes.plot(speeds, values, lw=1.6, label=label, **style)
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
    axes = _axes(axes, (5.6, 4.2))
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
