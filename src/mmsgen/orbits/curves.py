"""Closed curves as piecewise polynomials of the phase, on equal intervals with Gauss nodes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from ..floquet.collocation import GaussTable, gauss_table
from ..floquet.points import Floats

__all__ = ["Curve", "sampled", "scale_of", "table_for"]

REST = 1e-12
"""States below this, in their units, are what rounding leaves of rest."""

SMALL = 1e-3
"""States that are smaller than this, over the largest, are measured by it."""


def table_for(size: int) -> GaussTable:
    """The Gauss method for d states: many stages, while the matrices stay small."""
    return gauss_table(min(12, max(7, 48 // size)))


@dataclass(frozen=True, eq=False)
class Curve:
    """A closed curve, or a change of one.

    Attributes
    ----------
    starts : numpy.ndarray, shape (N, d)
    slopes : numpy.ndarray, shape (N, s, d)
        dy/dφ at the nodes.
    frequency : float
        ω in rad/s.
    value : float
        Of the parameter that is followed.
    """

    starts: Floats
    slopes: Floats
    frequency: float
    value: float = 0.0

    @property
    def intervals(self) -> int:
        """N."""
        return len(self.starts)

    @property
    def length(self) -> float:
        """h in rad."""
        return 2 * np.pi / self.intervals

    @property
    def table(self) -> GaussTable:
        """The Gauss method."""
        return gauss_table(self.slopes.shape[1])

    @cached_property
    def states(self) -> Floats:
        """Y at the nodes, shape (N, s, d)."""
        inner = np.einsum("ij,njd->nid", self.table.matrix, self.slopes)
        return np.asarray(self.starts[:, None] + self.length * inner)

    @property
    def phases(self) -> Floats:
        """φ at the nodes, shape (N, s)."""
        own = self.length * self.table.nodes
        return np.asarray(self.length * np.arange(self.intervals)[:, None] + own)

    def at(self, phases: Any) -> Floats:
        """States at phases, shape (m, d)."""
        return self._interpolated(phases)[0]

    def _interpolated(self, phases: Any) -> tuple[Floats, Floats]:
        """States and slopes, from the Legendre series of the slopes."""
        return self._combined(*_series(self.table.stages, self.intervals, phases))

    def _combined(self, cell: Any, integral: Floats, values: Floats) -> tuple[Floats, Floats]:
        series = np.einsum("li,nid->nld", self.table.legendre, self.slopes)[cell]
        states = self.starts[cell] + self.length * (integral[:, None] @ series)[:, 0]
        return states, (values[:, None] @ series)[:, 0]

    def refined(self, intervals: int) -> Curve:
        """The same curve on another number of intervals."""
        if intervals == self.intervals:
            return self
        s = self.table.stages
        mesh, nodes = _meshes(s, self.intervals, intervals)
        starts, slopes = self._combined(*mesh)[0], self._combined(*nodes)[1]
        slopes = slopes.reshape(intervals, s, -1)
        return Curve(starts, slopes, self.frequency, self.value)

    def moved(self, change: Curve, share: float = 1.0) -> Curve:
        """The curve with a multiple of a change added."""
        return Curve(
            self.starts + share * change.starts,
            self.slopes + share * change.slopes,
            float(self.frequency + share * change.frequency),
            float(self.value + share * change.value),
        )

    def integral(self, weights: Floats) -> Floats:
        """Mean over the phase of the states times weights (N, s, …), shape (d, …)."""
        own = self.length / (2 * np.pi) * self.table.weights
        return np.asarray(np.einsum("i,nid,ni...->d...", own, self.states, weights))


def _series(stages: int, intervals: int, phases: Any) -> tuple[Any, Floats, Floats]:
    """At phases: the interval, and Legendre polynomials of the place in it, integrated and not."""
    place = np.mod(phases, 2 * np.pi) * (intervals / (2 * np.pi))
    cell = np.minimum(place.astype(int), intervals - 1)
    x = 2 * (place - cell) - 1
    values = np.polynomial.legendre.legvander(x, stages)
    integral = np.empty((len(x), stages))
    integral[:, 0] = (x + 1) / 2
    degree = np.arange(1, stages)
    integral[:, 1:] = (values[:, degree + 1] - values[:, degree - 1]) / (2 * (2 * degree + 1))
    return cell, integral, values[:, :stages]


@lru_cache(maxsize=64)
def _meshes(stages: int, old: int, new: int) -> tuple[Any, Any]:
    """`_series` at the beginnings and at the nodes of other intervals."""
    h = 2 * np.pi / new
    mesh = h * np.arange(new)
    nodes = mesh[:, None] + h * gauss_table(stages).nodes
    return _series(stages, old, mesh), _series(stages, old, nodes.ravel())


def sampled(
    function: Callable[[Any], Floats],
    intervals: int,
    table: GaussTable,
    frequency: float,
    value: float = 0.0,
) -> Curve:
    """A curve from a function of the phase, (m,) → (m, d)."""
    h = 2 * np.pi / intervals
    mesh = h * np.arange(intervals)
    nodes = mesh[:, None] + h * table.nodes
    starts = function(mesh)
    inner = function(nodes.ravel()).reshape(*nodes.shape, -1)
    slopes = np.einsum("ij,njd->nid", _inverse(table.stages), inner - starts[:, None]) / h
    return Curve(starts, slopes, frequency, value)


@lru_cache(maxsize=8)
def _inverse(stages: int) -> Floats:
    """A⁻¹ of the Gauss method."""
    return np.asarray(np.linalg.inv(gauss_table(stages).matrix), dtype=float)


def scale_of(curve: Curve) -> Floats:
    """The size of each state; a state at rest is measured by the largest, and rest by 1."""
    size = np.abs(curve.states).max(axis=(0, 1))
    largest = float(size.max())
    return np.maximum(size, SMALL * largest) if largest > REST else np.ones_like(size)
