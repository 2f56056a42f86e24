"""Edges that have no closed form: roots of polynomials, and of implicit equations."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._dual import Dual, boundaries_at, real_at, zone_slopes
from ._runtime import companion_roots, evaluate_pair, stacked

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["explicit_edges", "implicit_edges", "zone"]

Kernel = Callable[..., Any]

# Points that are solved together: every one of them is looked at on a whole grid of frequencies.
BLOCK = 1024

EPS = 2.0**-52

# --- the unstable interval of a detuning ----------------------------------------------------------


def zone(*criteria: Any, reach: Any = np.inf) -> tuple[Any, Any]:
    """Ends of the interval nearest to zero on which one of several real polynomials is positive.

    Parameters
    ----------
    *criteria : tuple of array_like
        Coefficients of a polynomial, lowest power first; or a pair of polynomials, the second of
        which counts where the first one vanishes identically.
    reach : array_like
        How far the interval may be from zero.

    Returns
    -------
    lower, upper : numpy.ndarray
        Infinite where the interval has no end, NaN where there is none.
    """
    plain = [_where_first_vanishes(*c) if isinstance(c[0], tuple) else c for c in criteria]
    if any(isinstance(c, Dual) for polynomial in plain for c in polynomial):
        first, second = zone_slopes(zone(*_values(criteria), reach=_values(reach)), plain)
        return first, second
    numbers = [reach, *(c for polynomial in plain for c in polynomial)]
    table = stacked([np.asarray(c, dtype=np.float64) for c in numbers])
    shape, flat = table.shape[:-1], table.reshape(-1, table.shape[-1])
    ends = np.full((len(flat), 2), np.nan)
    rows = np.flatnonzero(np.isfinite(flat[:, 1:]).all(axis=-1))
    limit, values = flat[rows, 0], flat[rows, 1:]
    if len(plain) == 1 and len(plain[0]) > 2:
        ends[rows], done = _concave(values, limit)
        rows, limit, values = rows[~done], limit[~done], values[~done]
    if len(rows):
        places = np.cumsum([len(polynomial) for polynomial in plain])[:-1]
        ends[rows] = _intervals(np.split(values, places, axis=1), limit)
    gap = np.maximum(np.maximum(ends[:, 0], -ends[:, 1]), 0.0)
    ends[~(gap <= flat[:, 0])] = np.nan
    return ends[:, 0].reshape(shape), ends[:, 1].reshape(shape)


def _values(numbers: Any) -> Any:
    """Numbers without their slopes."""
    if isinstance(numbers, tuple):
        return tuple(map(_values, numbers))
    return numbers.value if isinstance(numbers, Dual) else numbers


def _where_first_vanishes(first: Sequence[Any], second: Sequence[Any]) -> list[Any]:
    """The second polynomial, zero where the first one is not."""
    other = np.any(np.broadcast_arrays(*(np.asarray(_values(c)) != 0.0 for c in first)), axis=0)
    return [np.where(other, 0.0, c) for c in second]


def _horner(table: NDArray[np.float64], x: NDArray[np.float64]) -> Any:
    """Polynomials, one for each row, and their derivatives at the points of the row."""
    value = np.zeros_like(x) + table[:, -1:]
    slope = np.zeros_like(x)
    for k in range(table.shape[1] - 2, -1, -1):
        slope = slope * x + value
        value = value * x + table[:, k : k + 1]
    return value, slope


def _concave(
    table: NDArray[np.float64], reach: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """The interval of polynomials that are concave as far as `reach`, and where they are.

    There is one maximum then; from where a parabola through it would end, Newton's method cannot
    miss the ends.
    """
    degree = table.shape[1] - 1
    powers = np.arange(degree + 1.0)
    second = (table * powers * (powers - 1.0))[:, 2:]
    rest = np.abs(second[:, 1:])
    powered = np.where(rest == 0.0, 0.0, rest * reach[:, None] ** powers[1 : degree - 1])
    bent = powered.sum(axis=-1) < -second[:, 0]
    inside = np.where(rest.any(axis=-1), reach, np.inf)
    first = (table * powers)[:, 1:]
    top = np.where(bent, -table[:, 1] / np.where(bent, 2.0 * table[:, 2], 1.0), 0.0)[:, None]
    for _ in range(6 if degree > 2 else 0):
        slope, curvature = _horner(first, top)
        top = np.where(bent[:, None], top - slope / curvature, 0.0)
    height, slope = _horner(table, top)
    # How much higher the maximum can be than where Newton's method stopped.
    more = slope * slope / np.where(bent, -second[:, 0] - powered.sum(axis=-1), 1.0)[:, None]
    half = np.sqrt(np.maximum(height, 0.0) / np.where(bent, -second[:, 0] / 2.0, 1.0)[:, None])
    ends = np.concatenate((top - half, top + half), axis=-1)
    step = np.zeros_like(ends)
    for _ in range(30):
        value, slope = _horner(table, ends)
        step = np.where(slope == 0.0, 0.0, value / np.where(slope == 0.0, 1.0, slope))
        closer = (height > 0.0) & (np.abs(step) > 2.0 * EPS * np.abs(ends))
        if not closer.any():
            break
        ends = np.where(closer, ends - step, ends)
    settled = (np.abs(step) <= 1e-9 * half).all(axis=-1) & (np.abs(ends).max(axis=-1) <= inside)
    none = (height + more)[:, 0] <= 0.0
    settled &= (height[:, 0] > 0.0) & (ends[:, 0] < top[:, 0]) & (top[:, 0] < ends[:, 1])
    ends[none] = np.nan
    return ends, bent & (np.abs(top[:, 0]) <= inside) & (none | settled)


def _breaks(table: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points between which polynomials keep their signs: real parts of all roots, then infinity.

    Those of complex pairs do no harm, and whether two roots that nearly coincide are real is
    left to the signs.
    """
    breaks = np.full((len(table), table.shape[1] - 1), np.inf)
    highest = table.shape[1] - 1 - np.argmax(table[:, ::-1] != 0.0, axis=-1)
    highest[~table.any(axis=-1)] = 0
    for degree in map(int, np.unique(highest)):
        rows = highest == degree
        if not degree:
            continue
        own = table[rows, : degree + 1]
        roots = companion_roots(own[:, :-1] / own[:, -1:])
        inner = roots.real.copy()
        for _ in range(2):  # Newton's steps take out the error of the companion matrix
            value, slope = _horner(own, inner)
            better = inner - value / np.where(slope == 0.0, np.inf, slope)
            closer = (np.abs(_horner(own, better)[0]) < np.abs(value)) & (roots.imag == 0.0)
            inner = np.where(closer, better, inner)
        breaks[rows, :degree] = np.where(np.isfinite(inner), inner, np.inf)
    return breaks


def _intervals(
    tables: Sequence[NDArray[np.float64]], reach: NDArray[np.float64]
) -> NDArray[np.float64]:
    """As `zone`, from the roots of all polynomials, one table for each of them."""
    count = len(reach)
    inner = np.sort(np.concatenate([_breaks(t) for t in tables], axis=-1), axis=-1)
    low = np.concatenate((np.full((count, 1), -np.inf), inner), axis=-1)
    high = np.concatenate((inner, np.full((count, 1), np.inf)), axis=-1)
    middle = np.where(
        np.isinf(low),
        np.where(np.isinf(high), 0.0, high - 1.0 - np.abs(high)),
        np.where(np.isinf(high), low + 1.0 + np.abs(low), 0.5 * low + 0.5 * high),
    )
    middle = np.where(np.isfinite(middle), middle, 0.0)
    positive = np.any([_horner(t, middle)[0] > 0.0 for t in tables], axis=0) & (low < np.inf)
    # Neighbours that are positive are one interval: its ends are those of the first and the last.
    width = positive.shape[1]
    before = np.concatenate((np.zeros((count, 1), dtype=bool), positive[:, :-1]), axis=-1)
    after = np.concatenate((positive[:, 1:], np.zeros((count, 1), dtype=bool)), axis=-1)
    place = np.arange(width)
    first = np.maximum.accumulate(np.where(positive & ~before, place, 0), axis=-1)
    last = np.minimum.accumulate(np.where(positive & ~after, place, width - 1)[:, ::-1], axis=-1)[
        :, ::-1
    ]
    low, high = np.take_along_axis(low, first, -1), np.take_along_axis(high, last, -1)
    gap = np.maximum(np.maximum(low, -high), 0.0)
    gap = np.where(positive & (high > low), gap, np.inf)
    best = np.argmin(gap, axis=-1)[:, None]
    ends = np.concatenate([np.take_along_axis(e, best, axis=-1) for e in (low, high)], axis=-1)
    return np.where(np.take_along_axis(gap, best, axis=-1) < np.inf, ends, np.nan)


# --- the unstable interval of a frequency ---------------------------------------------------------


def explicit_edges(
    resonance: Kernel,
    boundaries: Kernel,
    multiple: float,
    arguments: Sequence[NDArray[np.float64]],
    names: Sequence[str] = (),
) -> Any:
    """Edges in a frequency on which nothing else depends.

    Parameters
    ----------
    resonance : callable
        Arguments → the frequency without detuning, then the arguments of `boundaries`.
    boundaries : callable
        Its arguments → both edges in the detuning.
    multiple : float
        k, where k·frequency = … + detuning.
    arguments : sequence of numpy.ndarray
    names : sequence of str
        Of the arguments; empty where no derivatives are wanted.

    Returns
    -------
    tuple, or (tuple, dict)
        (lower, upper), or this and name → (slope of lower, slope of upper).
    """

    def kernel(*inputs: Any) -> tuple[Any, Any]:
        centre, *rest = resonance(*inputs)
        lower, upper = boundaries(*rest)
        return _positive(centre + lower / multiple), _positive(centre + upper / multiple)

    return boundaries_at(evaluate_pair, kernel, arguments, names)


def _positive(frequency: Any) -> Any:
    value = np.asarray(_values(frequency))
    return np.where((value > 0.0) & np.isfinite(value), frequency, np.nan)


def implicit_edges(
    detuning: Kernel,
    boundaries: Kernel,
    arguments: Sequence[NDArray[np.float64]],
    names: Sequence[str] = (),
) -> Any:
    """Edges in a frequency on which parameters depend, to full double precision.

    First the frequency without detuning, its smallest positive value, looked for from a
    thousandth to a thousand times what it would be if nothing depended on it; then, starting
    there, the nearest frequency at which the detuning is that of the edge. NaN where either does
    not exist, and where a solution is not confirmed by the equation.

    Parameters
    ----------
    detuning : callable
        Frequency, arguments → the detuning, then the arguments of `boundaries`.
    boundaries : callable
        Its arguments → both edges in the detuning.
    arguments, names
        As for `explicit_edges`.

    Returns
    -------
    tuple, or (tuple, dict)
        As from `explicit_edges`.
    """
    shape = np.broadcast_shapes(*(a.shape for a in arguments))
    size = int(np.prod(shape, dtype=np.int64))
    flat = [a.reshape(()) if a.size == 1 else np.broadcast_to(a, shape).ravel() for a in arguments]
    edges = np.full((2, size), np.nan)
    with np.errstate(all="ignore"):
        for start in range(0, size, BLOCK):
            part = slice(start, min(start + BLOCK, size))
            inputs = [a if a.ndim == 0 else a[part] for a in flat]
            edges[:, part] = _edges(detuning, boundaries, inputs, part.stop - part.start)
    pair = edges[0].reshape(shape)[()], edges[1].reshape(shape)[()]
    if not names:
        return pair
    moved = []
    for edge, frequency in enumerate(pair):

        def gap(unknown: Any, *inputs: Any, edge: int = edge) -> Any:
            sigma, *rest = detuning(unknown, *inputs)
            return sigma - boundaries(*rest)[edge]

        every = ["", *names]
        slopes = real_at(lambda *_: 0.0, gap, [np.asarray(frequency), *arguments], every)[1]
        with np.errstate(all="ignore"):
            moved.append({name: -slopes[name] / slopes[""] for name in names})
    return pair, {name: (moved[0][name], moved[1][name]) for name in names}


# Steps from the frequency without detuning towards an edge, in units of Newton's step.
_STEPS = (0.0, 0.5, 0.8, 0.95, 1.0, 1.05, 1.2, 1.5, 2.0, 3.0, 5.0, 9.0, 17.0, 33.0, 65.0)


def _edges(
    detuning: Kernel, boundaries: Kernel, inputs: Sequence[NDArray[np.float64]], count: int
) -> NDArray[np.float64]:
    """Both edges for one block of points."""

    def at(rows: NDArray[np.int64], frequency: NDArray[np.float64]) -> list[Any]:
        column = (slice(None), *(None,) * (frequency.ndim - 1))
        return list(detuning(frequency, *(a if a.ndim == 0 else a[rows][column] for a in inputs)))

    everywhere = np.arange(count)
    estimate = np.abs(np.broadcast_to(at(everywhere, np.zeros(count))[0], (count,)))
    estimate = np.where(np.isfinite(estimate) & (estimate > 0.0), estimate, 1.0)

    def free(rows: NDArray[np.int64], frequency: NDArray[np.float64]) -> Any:
        return at(rows, frequency)[0]

    ratios = np.concatenate(([0.0], np.geomspace(1e-3, 1e3, 146)))
    centre = _first_root(free, estimate[:, None] * ratios, estimate)
    result = np.full((2, count), np.nan)
    for edge in (0, 1):

        def gap(rows: NDArray[np.int64], frequency: NDArray[np.float64], edge: int = edge) -> Any:
            sigma, *rest = at(rows, frequency)
            return sigma - boundaries(*rest)[edge]

        step = 1e-6 * centre
        start = gap(everywhere, centre)
        slope = (gap(everywhere, centre + step) - start) / step
        grid = centre[:, None] - (start / slope)[:, None] * np.array(_STEPS)
        grid = np.where(grid > 0.0, grid, np.nan)
        result[edge] = _first_root(gap, grid, np.abs(slope) * centre)
    return result


def _first_root(
    function: Callable[[NDArray[np.int64], NDArray[np.float64]], Any],
    grid: NDArray[np.float64],
    size: NDArray[np.float64],
) -> NDArray[np.float64]:
    """The root behind the first change of sign along each row of a grid.

    Parameters
    ----------
    function : callable
        Row indices, points (one or several for each row) → values.
    grid : numpy.ndarray
        Shape (rows, points).
    size : numpy.ndarray
        What the values are made of, by which their rounding errors are judged.
    """
    count = len(grid)
    rows = np.arange(count)
    values = np.broadcast_to(function(rows, grid), grid.shape)
    sign = np.sign(values)
    change = (sign[:, :-1] * sign[:, 1:] < 0.0) | (sign[:, :-1] == 0.0)
    found = change.any(axis=-1)
    k = np.argmax(change, axis=-1)
    roots = np.full(count, np.nan)
    exact = found & (sign[rows, k] == 0.0)
    roots[exact] = grid[rows, k][exact]
    rows = rows[found & ~exact]
    k = k[rows]
    a, b, fa, fb = grid[rows, k], grid[rows, k + 1], values[rows, k], values[rows, k + 1]
    x, fx = _bracketed(function, rows, a, b, fa, fb)
    # At a pole or a jump the sign changes too, but the values do not become small.
    small = np.maximum(1e-6 * np.maximum(np.abs(fa), np.abs(fb)), 64.0 * EPS * size[rows])
    roots[rows] = np.where((np.abs(fx) <= small) & (x > 0.0), x, np.nan)
    return roots


def _bracketed(
    function: Callable[[NDArray[np.int64], NDArray[np.float64]], Any],
    rows: NDArray[np.int64],
    a: NDArray[np.float64],
    b: NDArray[np.float64],
    fa: NDArray[np.float64],
    fb: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Roots between a and b, where the function has opposite signs.

    T. R. Chandrupatla, "A new hybrid quadratic/bisection algorithm for finding the zero of a
    nonlinear function without using derivatives", Advances in Engineering Software 28 (1997).
    """
    best, value = np.where(np.abs(fa) < np.abs(fb), a, b), np.minimum(np.abs(fa), np.abs(fb))
    active = np.arange(len(rows))
    c, fc, t = a.copy(), fa.copy(), np.full(len(rows), 0.5)
    for _ in range(200):
        if not len(active):
            break
        x = a + t * (b - a)
        fx = np.broadcast_to(function(rows[active], x), x.shape)
        same = np.sign(fx) == np.sign(fa)
        c, fc = np.where(same, a, b), np.where(same, fa, fb)
        b, fb = np.where(same, b, a), np.where(same, fb, fa)
        a, fa = x, fx
        closer = np.abs(fa) < np.abs(fb)
        best[active], value[active] = np.where(closer, a, b), np.where(closer, fa, fb)
        least = 2.0 * EPS * np.abs(best[active]) / np.abs(b - a)
        going = (least <= 0.5) & (value[active] != 0.0)
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        inverse = (phi * phi < xi) & ((1.0 - phi) * (1.0 - phi) < 1.0 - xi)
        quadratic = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * (
            fb / (fc - fb)
        )
        t = np.clip(np.where(inverse & np.isfinite(quadratic), quadratic, 0.5), least, 1.0 - least)
        active = active[going]
        a, b, c, t, fa, fb, fc = (v[going] for v in (a, b, c, t, fa, fb, fc))
    value[active] = np.inf  # not converged
    return best, value
