"""Responses of two coupled coordinates, one panel for each, beside exact periodic orbits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

import mmsgen as mg
from mmsgen import Expansion, plotting


def used(case: Expansion, values: Mapping[str, Any]) -> dict[str, Any]:
    """Those values that are of parameters of a case."""
    names = {p.name for p in case.parameters}
    return {name: value for name, value in values.items() if name in names}


def responses(cases: Mapping[int, Expansion], values: Mapping[str, Any]) -> dict[int, Any]:
    """All equilibria of each order along the value that is an array."""
    return {n: c.slow_flow.frequency_response(used(c, values)) for n, c in cases.items()}


def bifurcations(
    case: Expansion, values: Mapping[str, Any], kinds: Sequence[str]
) -> list[mg.Steady]:
    """The first bifurcation of each kind along the detuning that is an array, to be certified."""
    (over,) = (name for name, value in values.items() if np.ndim(value))
    found = case.slow_flow.frequency_response(used(case, values)).bifurcations
    first = {kind: next(b for b in found if b.kind == kind) for kind in kinds}
    return [
        mg.Steady(
            {**used(case, values), over: round(b.parameter, 4)},
            list(b.amplitudes.round(4)),
            kind,
            over,
        )
        for kind, b in first.items()
    ]


def only(response: Any, j: int) -> Any:
    """What a response says of one coordinate."""
    return response._replace(
        branches=tuple(b._replace(amplitudes=b.amplitudes[:, [j]]) for b in response.branches),
        bifurcations=tuple(b._replace(amplitudes=b.amplitudes[[j]]) for b in response.bifurcations),
    )


def drawn(
    cases: Mapping[int, Expansion],
    values: Mapping[str, Any],
    xlabel: str,
    ylabels: Sequence[str],
    count: int = 16,
    scale: float = 1.0,
    largest: Any = np.inf,
) -> Any:
    """A figure: amplitudes of each order as lines, periodic orbits as points.

    Parameters
    ----------
    cases : mapping
        Order → case; the orbits begin from the last one.
    values : mapping
        Name → number, and an array for the parameter that varies.
    xlabel : str
    ylabels : sequence of str
        One for each coordinate.
    count : int
        Orbits, about.
    scale : float
        Of the parameter, in the figure.
    largest : array_like
        Amplitudes above which no orbits are sought.
    """
    found = responses(cases, values)
    last = max(cases)
    points = mg.orbits_along(
        cases[last], used(cases[last], values), found[last], count, largest=largest
    )
    shape = {"figsize": (4.2 * len(ylabels), 4.0), "layout": "constrained"}
    figure, panels = plt.subplots(1, len(ylabels), **shape)
    for j, axes in enumerate(panels):
        own = [(x, a[j : j + 1], stable) for x, a, stable in points]
        for order, response in found.items():
            plotting.frequency_response(
                only(response, j),
                [f"order {order}"],
                points=own if order == last else (),
                scale=scale,
                colour=order - 1,
                xlabel=xlabel,
                ylabel=ylabels[j],
                axes=axes,
            )
        axes.margins(x=0)
    plotting.shared_legend(panels)
    return figure
