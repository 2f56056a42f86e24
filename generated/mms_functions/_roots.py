"""Positive roots of real polynomials, many polynomials at once.

A root is positive and real or it is not, and no threshold on imaginary parts can tell the two
apart near a double root. So nothing complex occurs here. Between two neighbouring zeros of its
derivative a polynomial is monotonic: a change of sign there is one root, bracketed, which Newton's
method finds with bisection as a safeguard. The zeros of the derivative come from its own derivative
in the same way, down to the linear one. The number of changes of sign among Bernstein coefficients
bounds the number of roots on an interval from above (Descartes' rule on (0, 1)), so most
polynomials need no derivatives at all: without a change there is no root, with one there is one.

The half-line is cut into (0, s] and (s, ∞), the latter being (0, 1/s) of the reversed polynomial,
with s the geometric mean of all roots' moduli: a leading coefficient that vanishes, or nearly so,
sends a root to infinity and does no harm.

Sources: Mourrain, Rouillier and Roy (2005) on Bernstein coefficients and Descartes' rule.
"""

from __future__ import annotations

from math import comb
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["near_roots", "positive_roots"]

EPS = 2.0**-52

# Roots that are smaller than this, or larger than its reciprocal, in units of the geometric mean
# of all roots' moduli, are taken for zero or infinite.
SMALLEST = 2.0**-1000

# How often an interval is halved to separate its roots; what is left then is near a double root.
HALVINGS = 12

# Bernstein coefficients may be zero if they are smaller than this, compared with the sum of the
# absolute values that they are made of.
DOUBT = 1e-14

# A step of Newton's method that is relatively smaller than this is the last one: the next would be
# of the size of its square.
SETTLED = 1e-8

# Newton's method alone for so many steps, then every other step halves the bracket; the latter
# suffices, in their logarithms first, from `SMALLEST` to the last bit.
PATIENCE, LONGEST = 12, 160


def positive_roots(coefficients: Any) -> NDArray[np.float64]:
    """All positive roots of real polynomials, each of them once.

    Parameters
    ----------
    coefficients : array_like
        Shape (..., d + 1), lowest power first. Coefficients at either end may vanish.

    Returns
    -------
    numpy.ndarray
        Shape (..., d), increasing, filled up with NaN. A root of even multiplicity is found where
        the polynomial's smallest value vanishes within its rounding error; then the root is good to
        the square root of the precision, as any root is that is nearly double. All NaN where a
        coefficient is not finite, and for the polynomial that is zero.
    """
    return near_roots(coefficients, 0.0)[0]


def near_roots(coefficients: Any, loose: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positive roots, and places that may turn out to be roots once the rounding is gone.

    Parameters
    ----------
    coefficients : array_like
        As for `positive_roots`.
    loose : float
        Extrema whose value is smaller than this, compared with the sum of the absolute values of
        all terms, are reported beside the roots.

    Returns
    -------
    roots : numpy.ndarray
        As for `positive_roots`.
    extrema : numpy.ndarray
        Shape (..., d + 1), in no order, filled up with NaN; roots that are extrema are here, too.
    """
    table = np.asarray(coefficients, dtype=np.float64)
    lead, degree = table.shape[:-1], table.shape[-1] - 1
    flat = table.reshape(-1, degree + 1)
    roots, extrema = np.full((len(flat), degree), np.nan), np.full((len(flat), degree + 1), np.nan)
    rows = np.flatnonzero(np.isfinite(flat).all(axis=-1) & (np.count_nonzero(flat, axis=-1) > 1))
    if len(rows):
        scaled, exponent = _scaled(flat[rows])
        scale = np.ldexp(1.0, exponent)
        both = np.concatenate((scaled, scaled[:, ::-1]))
        found, near = _on_unit_interval(both, loose)
        one, near_one = _at_one(scaled, loose)
        for out, (row, x), end in ((roots, found, one), (extrema, near, near_one)):
            beyond = row >= len(rows)
            row, x = row - len(rows) * beyond, np.where(beyond, 1.0 / x, x)
            # A root at the cut belongs to neither side alone.
            row = np.concatenate((row, np.flatnonzero(end)))
            x = np.concatenate((x, np.ones(np.count_nonzero(end))))
            _fill(out, rows[row], x * scale[row])
    return roots.reshape(*lead, degree), extrema.reshape(*lead, degree + 1)


def _fill(out: NDArray[np.float64], row: NDArray[np.int64], x: NDArray[np.float64]) -> None:
    """Put values into their rows, in increasing order."""
    order = np.lexsort((x, row))
    row = row[order]
    number = np.bincount(row, minlength=len(out))
    place = np.arange(len(row)) - (np.cumsum(number) - number)[row]
    fits = place < out.shape[1]
    out[row[fits], place[fits]] = x[order][fits]


def _scaled(table: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Polynomials in x/2^e with the largest coefficient near one, and e; powers of two alone."""
    mantissa, exponents = np.frexp(table)
    nonzero = table != 0.0
    degree = table.shape[1] - 1
    lowest = np.argmax(nonzero, axis=-1)
    highest = degree - np.argmax(nonzero[:, ::-1], axis=-1)
    rows = np.arange(len(table))
    fall = exponents[rows, lowest] - exponents[rows, highest]
    e = np.floor(fall / np.maximum(highest - lowest, 1) + 0.5).astype(np.int64)
    powers = exponents + e[:, None] * np.arange(degree + 1)
    powers -= np.where(nonzero, powers, np.iinfo(np.int64).min // 2).max(axis=-1)[:, None]
    powers = np.maximum(powers, -2000).astype(np.int32)
    return np.ldexp(mantissa, powers), e


def _at_one(
    table: NDArray[np.float64], loose: float
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Whether 1 is a root within rounding, and whether it nearly is one."""
    value, size = np.abs(table.sum(axis=-1)), np.abs(table).sum(axis=-1)
    zero = value <= _noise(table.shape[1]) * size
    return zero, zero | (value <= loose * size)


def _noise(terms: int) -> float:
    """Rounding error of a polynomial, relative to the sum of its terms' absolute values.

    Two roundings a step of Horner's scheme, and each coefficient may be off by a few.
    """
    return (2.0 * terms + 6.0) * EPS / 2.0


def _bernstein(table: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bernstein coefficients on (0, 1), b_j = Σ_k C(j, k) a_k / C(d, k), one row for each j."""
    degree = table.shape[1] - 1
    b = table.T / np.array([[float(comb(degree, k))] for k in range(degree + 1)])
    for i in range(1, degree + 1):  # Pascal's triangle
        b[i:] += b[i - 1 : -1].copy()
    return b


def _halved(b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bernstein coefficients on the left halves, then on the right halves: de Casteljau."""
    degree, count = len(b) - 1, b.shape[1]
    out = np.empty((degree + 1, 2 * count))
    out[0, :count], out[degree, count:] = b[0], b[-1]
    for k in range(1, degree + 1):
        b = b[:-1] + b[1:]
        b *= 0.5
        out[k, :count], out[degree - k, count:] = b[0], b[-1]
    return out


Flat = tuple["NDArray[np.int64]", "NDArray[np.float64]"]
"""Rows and values."""


def _on_unit_interval(table: NDArray[np.float64], loose: float) -> tuple[Flat, Flat]:
    """Roots in (0, 1) and extrema near zero."""
    row, low, high, start, sign, hard = _isolated(table)
    x = _newton(_columns(table)[:, row], low, high, start, sign)
    hard_roots, hard_extrema = _by_derivatives(table[hard], loose)
    n, place = np.nonzero(np.isfinite(hard_roots))
    more, at = np.nonzero(np.isfinite(hard_extrema))
    roots = np.concatenate((row, hard[n])), np.concatenate((x, hard_roots[n, place]))
    return roots, (hard[more], hard_extrema[more, at])


def _isolated(table: NDArray[np.float64]) -> tuple[Any, ...]:
    """Brackets of single roots in (0, 1), and the rows for which there are none.

    Returns
    -------
    row, low, high, start, sign : numpy.ndarray
        For each bracket its row, ends, a first guess, and the sign at the lower end.
    hard : numpy.ndarray
        Rows whose roots halving an interval some times did not separate, if they have any.
    """
    degree = table.shape[1] - 1
    b, row = _bernstein(table), np.arange(len(table))  # a column for each interval
    size = _bernstein(np.abs(table))  # what the coefficients are sums of
    low, width, found = np.zeros(len(row)), 1.0, []
    for level in range(HALVINGS + 1):
        negative = b < 0.0
        change = negative[1:] != negative[:-1]
        number = change.sum(axis=0, dtype=np.int8)
        # Coefficients that may be zero hide changes of sign.
        number[(np.abs(b) <= DOUBT * size).any(axis=0)] = 2
        single = np.flatnonzero(number == 1)
        k = np.argmax(change[:, single], axis=0)
        left, right = b[k, single], b[k + 1, single]
        guess = low[single] + width * (k + left / (left - right)) / degree
        sign = np.where(negative[0, single], -1.0, 1.0)
        found.append((row[single], low[single], low[single] + width, guess, sign))
        many = number > 1
        row, low, b, size = row[many], low[many], b[:, many], size[:, many]
        if level == HALVINGS or not len(row):
            break
        width *= 0.5
        b, size = _halved(b), _halved(size)
        row, low = np.concatenate((row, row)), np.concatenate((low, low + width))
    hard = np.unique(row)
    parts = [np.concatenate(p) for p in zip(*found, strict=True)]
    easy = np.ones(len(table), dtype=bool)
    easy[hard] = False
    keep = easy[parts[0]]
    return *(p[keep] for p in parts), hard


def _by_derivatives(
    table: NDArray[np.float64], loose: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Roots in (0, 1) and extrema near zero, both padded with NaN, without any isolation."""
    breaks = last = np.zeros((len(table), 0))
    near = np.zeros(breaks.shape, dtype=bool)
    for k in range(table.shape[1] - 2, -1, -1):
        found, near = _between(_columns(_derivative(table, k)), breaks, 0.0 if k else loose)
        breaks, last = np.where(np.isnan(found), 1.0, found), breaks
    roots = np.where(breaks < 1.0, breaks, np.nan)
    return roots, np.where(near & (last < 1.0), last, np.nan)


def _derivative(table: NDArray[np.float64], k: int) -> NDArray[np.float64]:
    """The derivative of order k, over k!."""
    degree = table.shape[1] - 1
    return table[:, k:] * np.array([float(comb(j, k)) for j in range(k, degree + 1)])


def _columns(table: NDArray[np.float64]) -> NDArray[np.float64]:
    """One contiguous array for each coefficient."""
    return np.ascontiguousarray(table.T)


def _horner(columns: Any, x: NDArray[np.float64]) -> Any:
    value = np.zeros_like(x) + columns[-1]
    for c in columns[-2::-1]:
        value *= x
        value += c
    return value


def _between(
    columns: NDArray[np.float64], breaks: NDArray[np.float64], loose: float
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Roots in (0, 1) of polynomials that are monotonic between the breaks.

    Parameters
    ----------
    columns : numpy.ndarray
        Shape (d + 1, rows).
    breaks : numpy.ndarray
        Shape (rows, d - 1), increasing, filled up with ones.
    loose : float
        As for `near_roots`.

    Returns
    -------
    roots : numpy.ndarray
        Shape (rows, d), increasing, NaN at the end; breaks that are roots among them.
    near : numpy.ndarray
        Which of the breaks are almost roots.
    """
    rows, inner = breaks.shape
    spread = columns[:, :, None]
    value = _horner(spread, breaks)
    size = _horner(np.abs(spread), breaks)
    zero = np.abs(value) <= _noise(len(columns)) * size
    near = zero | (np.abs(value) <= loose * size)
    points = np.concatenate((np.zeros((rows, 1)), breaks, np.ones((rows, 1))), axis=-1)
    sign = np.zeros((rows, inner + 2))
    # At zero the sign of the lowest coefficient that does not vanish, at one that of the sum.
    first = np.argmax(columns != 0.0, axis=0)
    sign[:, 0] = np.sign(columns[first, np.arange(rows)])
    total = columns.sum(axis=0)
    sure = np.abs(total) > _noise(len(columns)) * np.abs(columns).sum(axis=0)
    sign[:, 1:-1] = np.where(zero, 0.0, np.sign(value))
    sign[:, -1] = np.where(sure, np.sign(total), 0.0)
    row, place = np.nonzero(sign[:, :-1] * sign[:, 1:] < 0.0)
    roots = np.full((rows, inner + 1), np.nan)
    low, high = points[row, place], points[row, place + 1]
    start = np.where(low < 0.125 * high, 0.5 * high, 0.5 * (low + high))
    roots[row, place] = _newton(columns[:, row], low, high, start, sign[row, place])
    # A break that is a root takes the place of the interval on its left, which has no other;
    # next to each other they are the same root, of a higher multiplicity.
    again = np.zeros_like(zero)
    again[:, 1:] = zero[:, 1:] & zero[:, :-1]
    r, p = np.nonzero(zero & ~again & (breaks < 1.0))
    roots[r, p] = breaks[r, p]
    return np.sort(roots, axis=-1), near


def _newton(
    columns: NDArray[np.float64],
    low: NDArray[np.float64],
    high: NDArray[np.float64],
    start: NDArray[np.float64],
    sign: NDArray[np.float64],
) -> NDArray[np.float64]:
    """The root in each bracket; `sign` is that of the polynomial at its lower end."""
    low = np.maximum(low, SMALLEST)
    x = np.minimum(np.maximum(start, low), high)
    out, place = np.empty(len(x)), np.arange(len(x))
    coefficients = columns * sign  # positive at the lower end
    with np.errstate(all="ignore"):
        for count in range(LONGEST):
            value, slope = _with_slope(coefficients, x)
            above = value < 0.0
            high = np.where(above, x, high)
            low = np.where(above, low, x)
            step = value / slope
            new = x - step
            going = ~(np.abs(step) <= SETTLED * x)
            beyond = ~((new >= low) & (new <= high))  # NaN as well
            if count >= PATIENCE and count % 2:
                beyond[:] = True  # far from a root Newton's method may be slower than halving
            beyond &= going
            if beyond.any():
                mean = np.sqrt(low) * np.sqrt(high)
                middle = np.where(high > 8.0 * low, mean, 0.5 * (low + high))
                new = np.where(beyond, middle, new)
            x = new
            left = np.count_nonzero(going)
            if not left:
                break
            if 2 * left < len(x):
                out[place] = x
                place, x, low, high = place[going], x[going], low[going], high[going]
                coefficients = coefficients[:, going]
    out[place] = x
    return out


def _with_slope(columns: NDArray[np.float64], x: NDArray[np.float64]) -> Any:
    """Values and derivatives by Horner's scheme."""
    value = columns[-1] * x + columns[-2]
    slope = columns[-1].copy()
    for c in columns[-3::-1]:
        slope *= x
        slope += value
        value *= x
        value += c
    return value, slope
