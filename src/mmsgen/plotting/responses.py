"""Equilibria along a parameter: branches, their stability and bifurcations, and backbones."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import MmsgenError
from .style import COLOURS, MARKERS, WIDTHS, on_axes, show_zero, with_legend

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..runtime._records import Branch, Response

__all__ = ["backbone", "frequency_response"]

_KINDS = {"saddle-node": "D", "pitchfork": "P", "transcritical": "X", "Hopf": "*"}
"""Markers of bifurcations, none of which is one of orbits."""
_SIZES = {"D": 5.0, "P": 6.5, "X": 6.5, "*": 9.0}


def frequency_response(
    response: Response,
    names: Sequence[str] | None = None,
    *,
    points: Sequence[tuple[Any, Any, Any]] = (),
    scale: float = 1.0,
    colour: int = 0,
    xlabel: str | None = None,
    ylabel: str = "amplitude",
    axes: Axes | None = None,
) -> Axes:
    """Amplitudes of all equilibria over a parameter, a colour and width for each coordinate.

    Stable branches are solid, unstable ones dashed. Bifurcations have markers by their kind.
    Responses of several orders share axes if each begins with a colour of its own.

    Parameters
    ----------
    response : Response
    names : sequence of str, optional
        Those of the coordinates, for the legend; None leaves a coordinate out. By default a_1, ….
    points : sequence of (parameter, amplitudes, stable)
        Exact periodic orbits: real amplitudes of the coordinates, shape (n,), filled where the
        orbit is stable, open where not.
    scale : float
        Factor of the parameter.
    colour : int
        Place of the first coordinate's colour and width in `COLOURS` and `WIDTHS`.
    xlabel : str, optional
        By default the name of the parameter.
    ylabel : str
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.

    Raises
    ------
    MmsgenError
        If there is not one name for each coordinate.
    """
    axes = on_axes(axes, (4.8, 3.6))
    count = _coordinates(response, points)
    labels: list[str | None] = [f"a_{j + 1}" for j in range(count)] if names is None else [*names]
    if len(labels) != count:
        raise MmsgenError(f"{len(labels)} names are given for {count} coordinates")
    drawn = [j for j in range(count) if labels[j] is not None]
    for j in drawn:
        for stable, dash in ((True, "-"), (False, "--")):
            x, y = _pieces(response.branches, j, stable)
            if len(x):
                which = "" if stable else ", unstable"
                place, label = colour + j, f"{labels[j]}{which}"
                (line,) = axes.plot(scale * x, y, label=label, ls=dash)
                line.set(color=COLOURS[place % len(COLOURS)], lw=WIDTHS[place % len(WIDTHS)])
    _bifurcations(axes, response, drawn, scale)
    _orbits(axes, points, drawn, scale)
    axes.set(xlabel=xlabel or response.name, ylabel=ylabel)
    show_zero(axes)
    return with_legend(axes)


def _bifurcations(axes: Axes, response: Response, drawn: Sequence[int], scale: float) -> None:
    """Markers where branches begin, meet or change, each kind once in the legend."""
    known = axes.get_legend_handles_labels()[1]
    for kind, marker in _KINDS.items():
        own = [b for b in response.bifurcations if b.kind == kind]
        if own:
            x = np.repeat([scale * b.parameter for b in own], len(drawn))
            y = np.array([b.modulus[drawn] for b in own]).ravel()
            style: dict[str, Any] = {"mfc": "white", "mec": "black", "mew": 0.9}
            label = None if kind in known else kind
            axes.plot(x, y, marker, ms=_SIZES[marker], ls="", zorder=4, label=label, **style)


def _coordinates(response: Response, points: Sequence[tuple[Any, Any, Any]]) -> int:
    """How many coordinates there are."""
    for branch in response.branches:
        return int(branch.amplitudes.shape[1])
    return len(np.atleast_1d(points[0][1])) if points else 0


def _pieces(branches: Sequence[Branch], j: int, stable: bool) -> tuple[Any, Any]:
    """All stretches of one stability, separated by NaN; each goes on to where it changes."""
    xs: list[Any] = []
    ys: list[Any] = []
    for branch in branches:
        own = branch.stable == stable
        # A segment belongs to the stability of its first point, so that no gap is left.
        shown = own | np.r_[False, own[:-1]]
        if not own.any():
            continue
        xs += [np.where(shown, branch.parameter, np.nan), [np.nan]]
        ys += [np.where(shown, branch.modulus[:, j], np.nan), [np.nan]]
    if not xs:
        return np.empty(0), np.empty(0)
    return np.concatenate(xs)[:-1], np.concatenate(ys)[:-1]


def _orbits(
    axes: Axes, points: Sequence[tuple[Any, Any, Any]], drawn: Sequence[int], scale: float
) -> None:
    """Exact periodic orbits as points."""
    for k, j in enumerate(drawn):
        for stable in (True, False):
            own = [(x, np.atleast_1d(a)[j]) for x, a, s in points if bool(s) == stable]
            if not own:
                continue
            which = "stable" if stable else "unstable"
            label = f"periodic orbits, {which}" if k == 0 else None
            x, y = np.array(own, dtype=float).T
            style: dict[str, Any] = {"ls": "", "mec": "black", "mew": 0.7, "zorder": 3}
            style["mfc"] = "black" if stable else "none"
            axes.plot(scale * x, y, MARKERS[j % len(MARKERS)], ms=3.4, label=label, **style)


def backbone(
    curves: Mapping[str, tuple[Any, Any]],
    reference: tuple[Any, Any] | None = None,
    *,
    xlabel: str = "detuning (rad/s)",
    ylabel: str = "amplitude",
    axes: Axes | None = None,
) -> Axes:
    """Backbone curves: the frequency or detuning of free vibration, beside its amplitude.

    They are thin and black, so that they can be drawn into a frequency response.

    Parameters
    ----------
    curves : mapping
        Label → detunings or frequencies, and amplitudes.
    reference : (array_like, array_like), optional
        The same of exact periodic motions, drawn as points.
    xlabel, ylabel : str
        Left alone on axes that have labels.
    axes : matplotlib.axes.Axes, optional
        Where to draw; a new figure by default.
    """
    axes = on_axes(axes, (4.8, 3.6))
    dashes: tuple[Any, ...] = ((0, (6, 2, 1, 2)), (0, (2, 2)), (0, (6, 2)), "-")
    for k, (label, (x, y)) in enumerate(curves.items()):
        axes.plot(x, y, lw=1.0, color="black", ls=dashes[k % len(dashes)], label=label)
    if reference is not None:
        x, y = reference
        style: dict[str, Any] = {"mfc": "none", "mec": "black", "mew": 0.7}
        axes.plot(x, y, "o", ms=3.2, label="periodic motions", **style)
    axes.set_xlabel(axes.get_xlabel() or xlabel)
    axes.set_ylabel(axes.get_ylabel() or ylabel)
    return with_legend(axes)
