"""Stability along curves of equilibria, and the points at which it changes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._charts import equations, unpack
from ._curves import Curve
from ._flow import Flow, jacobian, spectrum, wirtinger
from ._records import Bifurcation

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Points", "bifurcations", "points_of"]

NEUTRAL = 1e-11
"""An eigenvalue, or a sum of two, that is smaller than the others by this is zero."""

SINGULAR = 1e-9
"""Singular values of a Jacobian below this, over the largest, are zero."""

LOCATED = 1e-14
"""The same for the place of a bifurcation, where its sign is looked for to the last digits."""


class Points(NamedTuple):
    """Equilibria with their stability.

    Attributes
    ----------
    parameter, amplitudes, drift, growth : numpy.ndarray
        As in `Branch`.
    x : numpy.ndarray
        Real unknowns of the chart.
    steady : numpy.ndarray
        Product of the eigenvalues; zero where it is not known to differ from zero.
    swinging : numpy.ndarray
        Product of the sums of any two of them (Orlando's formula: the Hurwitz determinant).
    fold : numpy.ndarray
        Whether the parameter turns there.
    given : numpy.ndarray
        Whether it is at a given value; all others are there to see bifurcations between these.
    """

    parameter: NDArray[np.float64]
    amplitudes: NDArray[np.complex128]
    drift: NDArray[np.float64]
    growth: NDArray[np.float64]
    x: NDArray[np.float64]
    steady: NDArray[np.float64]
    swinging: NDArray[np.float64]
    fold: NDArray[np.bool_]
    given: NDArray[np.bool_]

    def pick(self, rows: Any) -> Points:
        """Some of them."""
        parts: list[Any] = [part[rows] for part in self]
        return Points(*parts)


def points_of(
    flow: Flow,
    curve: Curve,
    p: NDArray[np.float64],
    x: NDArray[np.float64],
    fold: NDArray[np.bool_],
    given: NDArray[np.bool_],
    neutral: float = NEUTRAL,
) -> Points:
    """Amplitudes and eigenvalues at points of a curve."""
    place = curve.place
    b, rate = unpack(place, x)
    whole = np.zeros((len(p), flow.n), dtype=np.complex128)
    whole[:, list(place.active)] = b
    drift = np.zeros((len(p), len(flow.symmetries)))
    if place.drifts:
        drift = rate @ np.array(place.mixing)
    c = curve.coefficients(p)
    if flow.n == 1:
        growth, steady, swinging = _planar(flow, c, whole, drift, neutral)
    else:
        values = spectrum(flow, c, whole, drift if len(flow.symmetries) else None)
        growth = values[:, 0].real
        steady, swinging = _products(values, neutral)
    # At a fold an eigenvalue is zero; the square root of the rounding is left of it.
    growth[fold & (np.abs(growth) <= 1e-6 * np.abs(growth).max(initial=0.0))] = 0.0
    return Points(p, whole, drift, growth, x, steady, swinging, fold, given)


def _planar(
    flow: Flow, c: NDArray[Any], b: NDArray[Any], drift: NDArray[Any], neutral: float
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Growth, product and sum of the eigenvalues of one amplitude."""
    j = jacobian(flow, c, b, drift if len(flow.symmetries) else None)
    half = 0.5 * (j[:, 0, 0] + j[:, 1, 1])
    product = j[:, 0, 0] * j[:, 1, 1] - j[:, 0, 1] * j[:, 1, 0]
    size = np.abs(j).max(axis=(1, 2))
    swinging = np.where(np.abs(half) > neutral * size, half, 0.0)
    if flow.symmetries:
        turned = b[:, 0] != 0.0
        growth = np.where(turned, 2.0 * half, half)
        return growth, np.where(turned, swinging, 0.0), np.where(turned, 0.0, swinging)
    root = np.sqrt(np.maximum(half * half - product, 0.0))
    with np.errstate(all="ignore"):
        # Without cancellation where the product is small.
        growth = np.where((half < 0.0) & (root > 0.0), product / (half - root), half + root)
    return growth, np.where(np.abs(product) > neutral * size**2, product, 0.0), swinging


def _products(values: NDArray[np.complex128], neutral: float) -> tuple[NDArray[Any], NDArray[Any]]:
    """The product of the eigenvalues, and that of the sums of pairs; NaN ones left out."""
    there = np.isfinite(values)
    size = np.where(there, np.abs(values), 0.0).max(axis=1, initial=0.0)
    size = np.where(size > 0.0, size, 1.0)
    own = np.where(there, values / size[:, None], 1.0)
    steady = np.prod(own, axis=1).real
    steady[np.abs(own).min(axis=1, initial=1.0) < neutral] = 0.0
    first, second = np.triu_indices(values.shape[1], 1)
    sums = np.where(there[:, first] & there[:, second], own[:, first] + own[:, second], 1.0)
    swinging = np.prod(sums, axis=1).real
    swinging[np.abs(sums).min(axis=1, initial=1.0) < neutral] = 0.0
    return steady, swinging


# --- bifurcations ---------------------------------------------------------------------------------


class _Mark(NamedTuple):
    """A bifurcation, how well its place is known, and whether a curve turns there.

    The smaller the rank the better.
    """

    point: Bifurcation
    rank: int
    turns: bool = False


def bifurcations(
    branches: list[tuple[Flow, Curve, Points]], size: float, width: float
) -> tuple[Bifurcation, ...]:
    """All bifurcations of some branches, each of them once.

    Parameters
    ----------
    branches : list of (Flow, Curve, Points)
    size : float
        Of the amplitudes altogether.
    width : float
        Range of the parameter.
    """
    marks: list[_Mark] = []
    for flow, curve, points in branches:
        for k in np.flatnonzero(points.fold):
            marks.append(_at_fold(flow, curve, points, int(k)))
        marks += [m for m in _crossings(flow, curve, points, size) if m is not None]
    marks.sort(key=lambda m: (m.rank, m.point.parameter))
    kept: list[Bifurcation] = []
    for mark in marks:
        b = mark.point
        same = [k for k, other in enumerate(kept) if _same(b, other, size, width)]
        if not same:
            kept.append(b)
        elif mark.turns and kept[same[0]].kind == "transcritical":
            # One curve turns where it meets another: whatever the curvature there seems to be.
            kept[same[0]] = kept[same[0]]._replace(kind="pitchfork")
    return tuple(
        sorted(kept, key=lambda b: (b.parameter, b.kind, float(np.abs(b.amplitudes).sum())))
    )


def _same(b: Bifurcation, other: Bifurcation, size: float, width: float) -> bool:
    """Whether two are one, both of them Hopf points or neither."""
    near = abs(b.parameter - other.parameter) < 1e-6 * width
    gap = np.abs(np.abs(b.amplitudes) - np.abs(other.amplitudes)).max()
    # Along a pitchfork amplitudes go like the square root of the distance.
    return bool(near and gap < 3e-3 * size and (b.kind == "Hopf") == (other.kind == "Hopf"))


def _at_fold(flow: Flow, curve: Curve, points: Points, k: int) -> _Mark:
    """A saddle-node; or a pitchfork, on the branch that turns back there."""
    here = points.pick(slice(k, k + 1))
    c, _ = curve.at(here.parameter)
    _, matrices = equations(curve.place, c, *unpack(curve.place, here.x))
    kind = "pitchfork"
    size = float(np.nanmax(np.abs(points.amplitudes), initial=0.0))
    if _turns(curve, here, np.linalg.svd(matrices[0])[0][:, -1], size):
        kind = "saddle-node"
    p = float(here.parameter[0])
    point = Bifurcation(kind, p, here.amplitudes[0], here.drift[0], 0.0)
    return _Mark(point, 2, True)


def _turns(curve: Curve, here: Points, left: NDArray[np.float64], size: float) -> bool:
    """Whether p leads across the range of a singular Jacobian, whose left null vector is given.

    Then one curve only passes there, and turns.
    """
    b, rate = unpack(curve.place, here.x)
    c, slope = curve.at(here.parameter)
    by = equations(curve.place, slope, b, np.zeros_like(rate))[0][0]
    # At zero amplitudes nothing but rounding may be left of it.
    least = 1e-7 * np.abs(equations(curve.place, c, b, rate)[1]).max() * size
    across = np.abs(left @ by)
    return bool(across > 1e-6 * np.linalg.norm(by) and across * (curve.high - curve.low) > least)


def _crossings(flow: Flow, curve: Curve, points: Points, size: float) -> list[_Mark | None]:
    """Places where a product changes its sign between two points without a fold between them."""
    found: list[_Mark | None] = []
    folds = np.cumsum(points.fold)
    for which, test in enumerate((points.steady, points.swinging)):
        sure = np.flatnonzero((test != 0.0) & ~points.fold & np.isfinite(test))
        first, last = sure[:-1], sure[1:]
        change = np.sign(test[first]) * np.sign(test[last]) < 0.0
        change &= (folds[first] == folds[last]) & (last - first <= 3)
        for a, b in zip(first[change], last[change], strict=True):
            place = _located(flow, curve, points, int(a), int(b), which)
            if place is not None:
                if which:
                    found.append(_at_hopf(flow, curve, place, points, size))
                else:
                    found.append(_at_branching(flow, curve, place, size))
    return found


def _located(flow: Flow, curve: Curve, points: Points, a: int, b: int, which: int) -> Points | None:
    """The point between two neighbours where a product vanishes: false position, Illinois."""

    def at(p: float, x: NDArray[np.float64]) -> Points:
        c = curve.coefficients(np.array([p]))[:, list(curve.place.columns)]
        x = x[None]
        with np.errstate(all="ignore"):
            for _ in range(6 if x.shape[1] else 0):
                f, matrices = equations(curve.place, c, *unpack(curve.place, x))
                if not np.isfinite(matrices).all():
                    break
                # Nothing but rounding would lead along the null vector of a singular one.
                step = (np.linalg.pinv(matrices, rcond=SINGULAR) @ f[..., None])[..., 0]
                x = x - step
                if np.abs(step).max() <= 1e-15 * np.abs(x).max():
                    break
        no = np.zeros(1, bool)
        return points_of(flow, curve, np.array([p]), x, no, no, LOCATED)

    def value(points: Points) -> float:
        return float((points.steady, points.swinging)[which][0])

    ends = [points.pick(slice(k, k + 1)) for k in (a, b)]
    values = [value(e) for e in ends]
    best = ends[0]
    kept = -1
    for _ in range(60):
        p = [float(e.parameter[0]) for e in ends]
        if abs(p[1] - p[0]) <= 4e-16 * max(abs(p[0]), abs(p[1])):
            break
        share = values[0] / (values[0] - values[1])
        if not 0.0 < share < 1.0:
            share = 0.5
        best = at(
            p[0] + share * (p[1] - p[0]), ends[0].x[0] + share * (ends[1].x[0] - ends[0].x[0])
        )
        now = value(best)
        if now == 0.0 or not np.isfinite(now):
            break
        side = 0 if now * values[0] > 0.0 else 1
        if side == kept:
            values[1 - side] *= 0.5
        ends[side], values[side], kept = best, now, side
    return best if np.isfinite(best.parameter).all() else None


def _at_hopf(flow: Flow, curve: Curve, place: Points, along: Points, size: float) -> _Mark | None:
    """A Hopf point, unless the two eigenvalues are real and opposite."""
    c = curve.coefficients(place.parameter)
    values = spectrum(flow, c, place.amplitudes, place.drift if flow.symmetries else None)[0]
    values = values[np.isfinite(values)]
    first, second = np.triu_indices(len(values), 1)
    k = int(np.argmin(np.abs(values[first] + values[second])))
    # All eigenvalues may vanish: then only the rounding is left of what is summed up elsewhere.
    every = np.abs(curve.coefficients(along.parameter)), np.abs(along.amplitudes)
    made_of = float(np.nanmax(np.abs(wirtinger(flow, *every))))
    one, scale = values[first[k]], max(1e-6 * np.abs(values).max(), 1e-12 * made_of)
    if abs(one.imag) < scale:
        if abs(one.real) > scale:
            return None
        if not flow.symmetries:  # two eigenvalues vanish together, as B → B e^{2πi/3} makes them
            return _at_branching(flow, curve, place, size)
    frequency = float(abs(one.imag))
    point = Bifurcation(
        "Hopf", float(place.parameter[0]), place.amplitudes[0], place.drift[0], frequency
    )
    return _Mark(point, 0)


def _at_branching(flow: Flow, curve: Curve, place: Points, size: float) -> _Mark | None:
    """A pitchfork or a transcritical point, by the curvature of the flow along the null vector."""
    active = list(curve.place.active)
    idle = [k for k in range(flow.n) if k not in active]
    c = curve.coefficients(place.parameter)
    drift = place.drift if flow.symmetries else None

    def whole(b: NDArray[Any]) -> NDArray[np.float64]:
        return jacobian(flow, c, b, drift)[0]

    def inner(b: NDArray[Any]) -> NDArray[np.float64]:
        own = b[:, active]
        rate = unpack(curve.place, place.x)[1]
        return equations(curve.place, c[:, list(curve.place.columns)], own, rate)[1][0]

    j = whole(place.amplitudes)
    rows = [i for k in idle for i in (2 * k, 2 * k + 1)]
    outer = j[np.ix_(rows, rows)]
    scale = np.abs(j).max()
    lost = np.linalg.svd(outer)[1][-1] if rows else np.inf
    kept = np.linalg.svd(inner(place.amplitudes))[1][-1] if active else np.inf
    if lost <= kept:
        left, right = np.zeros(len(j)), np.zeros(len(j))
        u, _, v = np.linalg.svd(outer)
        left[rows], right[rows] = u[:, -1], v[-1]
        if active:
            others = [i for k in active for i in (2 * k, 2 * k + 1)]
            block = j[np.ix_(others, others)]
            right[others] = -np.linalg.lstsq(block, j[np.ix_(others, rows)] @ v[-1], rcond=None)[0]
        derivative: Callable[[NDArray[Any]], NDArray[np.float64]] = whole
        step = (right[0::2] + 1j * right[1::2]) / 2.0
    else:
        u, _, v = np.linalg.svd(inner(place.amplitudes))
        left, right, derivative = u[:, -1], v[-1].copy(), inner
        if _turns(curve, place, left, size):
            return None  # a fold, which its turn tells: the two points are of different sheets
        direction = right.copy()
        for pivot in curve.place.pivots:
            direction[2 * pivot + 1] = 0.0
        step = np.zeros(flow.n, dtype=np.complex128)
        step[active] = (direction[0::2] + 1j * direction[1::2]) / 2.0
    h = 1e-3 * size
    bend = (
        derivative(place.amplitudes + h * step) - derivative(place.amplitudes - h * step)
    ) @ right
    bend /= 2.0 * h
    # Of an even flow the curvature vanishes up to the rounding of the difference.
    flat = abs(left @ bend) < 1e-6 * max(float(np.linalg.norm(bend)), scale / size)
    kind = "pitchfork" if flat else "transcritical"
    point = Bifurcation(kind, float(place.parameter[0]), place.amplitudes[0], place.drift[0], 0.0)
    return _Mark(point, 1)
