"""What all emitted modules share: checked arguments, evaluation in blocks, roots.

NumPy is all that is needed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "checked",
    "checked_amplitudes",
    "conservative_growth",
    "defined",
    "evaluate",
    "evaluate_array",
    "evaluate_pair",
    "explicit_edges",
    "growing",
    "implicit_edges",
    "largest",
    "matrix_growth",
    "multiply_out",
    "no_edges",
    "quadratic_growth",
    "zone",
]

Kernel = Callable[..., Any]

# Points that are evaluated together: their intermediates stay in the second-level cache.
BLOCK = 32768

# Points that are solved together: every one of them is looked at on a whole grid of speeds.
ROOT_BLOCK = 1024

EPS = float(np.finfo(np.float64).eps)

# --- arguments ------------------------------------------------------------------------------------

DOMAINS = {
    "positive": "positive and finite",
    "nonnegative": "finite and not negative",
    "negative": "negative and finite",
    "real": "finite",
}


def _inside(array: NDArray[np.float64], domain: str) -> NDArray[np.bool_]:
    """Which values lie in the domain; False for NaN."""
    finite = np.isfinite(array)
    if domain == "positive":
        return finite & (array > 0)
    if domain == "nonnegative":
        return finite & (array >= 0)
    if domain == "negative":
        return finite & (array < 0)
    return finite


def _within(low: float, high: float, domain: str) -> bool:
    """Whether the ends of an array lie in the domain: a NaN anywhere is a NaN at both."""
    if domain == "positive":
        return low > 0.0 and high < np.inf
    if domain == "nonnegative":
        return low >= 0.0 and high < np.inf
    if domain == "negative":
        return low > -np.inf and high < 0.0
    return low > -np.inf and high < np.inf


def checked(
    parameters: Mapping[str, tuple[str, str, str]], /, **values: ArrayLike
) -> list[NDArray[np.float64]]:
    """Values as float64 arrays, each of them in its domain.

    Parameters
    ----------
    parameters : mapping
        Name → (domain, unit, meaning).
    **values : array_like

    Raises
    ------
    ValueError
        Naming the parameter, what is required of it, and the value that is not so.
    """
    arrays = []
    for name, value in values.items():
        domain = parameters[name][0]
        try:
            array = np.asarray(value)
        except ValueError as error:
            raise ValueError(f"{name} must be a number or an array: {error}") from None
        if array.dtype.kind not in "iuf":
            raise ValueError(f"{name} must be real and {DOMAINS[domain]}, got {value!r}")
        array = array.astype(np.float64, copy=False)
        if array.size and not _within(float(array.min()), float(array.max()), domain):
            flat = array.ravel()
            k = int(np.argmin(_inside(flat, domain)))
            where = f" at index {k}" if flat.size > 1 else ""
            raise ValueError(f"{name} must be {DOMAINS[domain]}, got {flat[k]!r}{where}")
        arrays.append(array)
    return arrays


def checked_amplitudes(amplitudes: ArrayLike, count: int) -> list[NDArray[np.complex128]]:
    """Amplitudes, shape (..., count), as one complex128 array for each coordinate.

    Raises
    ------
    ValueError
        If the last axis has another length, or a value is not a finite number.
    """
    array = np.asarray(amplitudes)
    if array.dtype.kind not in "iufc":
        raise ValueError(f"amplitudes must be complex numbers, got {amplitudes!r}")
    if array.ndim == 0 or array.shape[-1] != count:
        raise ValueError(
            f"amplitudes must have the shape (..., {count}), one for each coordinate in the order "
            f"of COORDINATES, got {array.shape}"
        )
    array = array.astype(np.complex128, copy=False)
    if not np.isfinite(array).all():
        raise ValueError("amplitudes must be finite")
    return [array[..., j] for j in range(count)]


# --- evaluation -----------------------------------------------------------------------------------


def _pieces(shape: tuple[int, ...], block: int) -> Iterator[tuple[slice, ...]]:
    """Index tuples that cut an array of this shape into pieces of about `block` elements."""
    if not shape:
        yield ()
        return
    inner = int(np.prod(shape[1:], dtype=np.int64))
    rows = max(1, block // max(1, inner))
    for start in range(0, shape[0], rows):
        first = slice(start, min(start + rows, shape[0]))
        if inner <= block:
            yield (first, *(slice(None) for _ in shape[1:]))
        else:
            yield from ((first, *rest) for rest in _pieces(shape[1:], block))


def _cut(array: NDArray[Any], piece: tuple[slice, ...]) -> NDArray[Any]:
    """The part of an argument that belongs to a piece; axes of length one serve every piece."""
    own = piece[len(piece) - array.ndim :]
    return array[tuple(s if n > 1 else slice(None) for s, n in zip(own, array.shape, strict=True))]


def _run(
    arguments: Sequence[NDArray[Any]],
    outs: Sequence[NDArray[Any]],
    fill: Callable[[Sequence[NDArray[Any]], Sequence[NDArray[Any]]], None],
    shape: tuple[int, ...],
) -> None:
    size = int(np.prod(shape, dtype=np.int64))
    with np.errstate(all="ignore"):
        if size <= BLOCK:
            if size:
                fill(arguments, outs)
            return
        for piece in _pieces(shape, BLOCK):
            fill([_cut(a, piece) for a in arguments], [out[piece] for out in outs])


def evaluate(kernel: Kernel, arguments: Sequence[NDArray[np.float64]]) -> Any:
    """One real number for each point, in the shape to which the arguments broadcast."""
    shape = np.broadcast_shapes(*(a.shape for a in arguments))
    out = np.empty(shape)

    def fill(inputs: Sequence[NDArray[Any]], outs: Sequence[NDArray[Any]]) -> None:
        outs[0][...] = kernel(*inputs)

    _run(arguments, (out,), fill, shape)
    return out[()]


def evaluate_pair(kernel: Kernel, arguments: Sequence[NDArray[np.float64]]) -> tuple[Any, Any]:
    """Two real numbers for each point."""
    shape = np.broadcast_shapes(*(a.shape for a in arguments))
    lower, upper = np.empty(shape), np.empty(shape)

    def fill(inputs: Sequence[NDArray[Any]], outs: Sequence[NDArray[Any]]) -> None:
        outs[0][...], outs[1][...] = kernel(*inputs)

    _run(arguments, (lower, upper), fill, shape)
    return lower[()], upper[()]


def evaluate_array(
    kernel: Kernel, arguments: Sequence[NDArray[Any]], trailing: tuple[int, ...]
) -> NDArray[np.complex128]:
    """A complex array of the shape `trailing` for each point; the kernel fills its first argument.

    The array is zero where the kernel assigns nothing.
    """
    shape = np.broadcast_shapes(*(a.shape for a in arguments))
    out = np.zeros((*shape, *trailing), dtype=np.complex128)

    def fill(inputs: Sequence[NDArray[Any]], outs: Sequence[NDArray[Any]]) -> None:
        kernel(outs[0], *inputs)

    _run(arguments, (out,), fill, shape)
    return out


def defined(lower: Any, upper: Any) -> tuple[Any, Any]:
    """NaN for both edges where a divisor in their formula vanishes."""
    finite = np.isfinite(lower) & np.isfinite(upper)
    return np.where(finite, lower, np.nan), np.where(finite, upper, np.nan)


def no_edges(*arguments: Any) -> tuple[float, float]:
    """NaN for both edges: there is no zone."""
    return np.nan, np.nan


# --- growth rates ---------------------------------------------------------------------------------


def largest(*rates: Any) -> Any:
    """The largest of several growth rates; NaN where one of them is."""
    result = rates[0]
    for rate in rates[1:]:
        result = np.maximum(result, rate)
    return result


def growing(discriminant: Any) -> Any:
    """Growth rate of a quadratic whose modes are neutral unless its discriminant is positive."""
    rate = 0.5 * np.sqrt(np.maximum(discriminant, 0.0))
    return np.where(np.isfinite(discriminant), rate, np.nan)


def quadratic_growth(b: Any, c: Any) -> Any:
    """Largest real part of the roots of Γ² + bΓ + c."""
    b, c = np.asarray(b, dtype=np.complex128), np.asarray(c, dtype=np.complex128)
    root = np.sqrt(b * b - 4.0 * c)
    # The root of larger modulus by a sum without cancellation, the other from their product.
    root = np.where((b.conj() * root).real < 0.0, -root, root)
    q = -0.5 * (b + root)
    other = np.where(q == 0.0, 0.0, c / np.where(q == 0.0, 1.0, q))
    rate = np.maximum(q.real, other.real)
    return np.where(np.isfinite(b) & np.isfinite(c), rate, np.nan)


def conservative_growth(*coefficients: Any) -> Any:
    """Largest imaginary part of the roots of a real monic polynomial, lowest power first.

    Real roots come out exactly real from the eigenvalues of a real matrix, so that neutral modes
    give exactly 0.0.
    """
    return np.abs(_roots(_table(coefficients)).imag).max(axis=-1)


def matrix_growth(rows: Sequence[Sequence[Any]]) -> Any:
    """Largest real part of the eigenvalues of a square matrix."""
    n = len(rows)
    table = _table([entry for row in rows for entry in row])
    matrices = table.reshape(*table.shape[:-1], n, n)
    finite = np.isfinite(table).all(axis=-1)
    values = np.linalg.eigvals(np.where(finite[..., None, None], matrices, 0.0))
    return np.where(finite, values.real.max(axis=-1), np.nan)


def multiply_out(out: NDArray[np.complex128], *factors: tuple[Sequence[Any], int]) -> None:
    """Multiply monic polynomials, coefficients highest power first, and their multiplicities."""
    out[...] = 0.0
    out[..., 0] = 1.0
    degree = 0
    for coefficients, multiplicity in factors:
        for _ in range(multiplicity):
            before = out[..., : degree + 1].copy()
            for k, c in enumerate(coefficients, 1):
                out[..., k : k + degree + 1] += np.asarray(c)[..., None] * before
            degree += len(coefficients)


def _table(entries: Sequence[Any]) -> NDArray[Any]:
    """Numbers and arrays that broadcast, as one array with the entries along its last axis."""
    return np.stack(np.broadcast_arrays(*entries), axis=-1)


def _roots(table: NDArray[np.float64]) -> NDArray[np.complex128]:
    """Roots of real monic polynomials, NaN where a coefficient is not finite."""
    n = table.shape[-1]
    finite = np.isfinite(table).all(axis=-1, keepdims=True)
    matrices = np.zeros((*table.shape, n))
    matrices[..., 1:, :-1] = np.eye(n - 1)
    matrices[..., :, -1] = -np.where(finite, table, 0.0)
    roots = np.linalg.eigvals(matrices).astype(np.complex128, copy=False)
    return np.where(finite, roots, complex(np.nan, np.nan))


# --- the unstable interval of a detuning ----------------------------------------------------------


def zone(*coefficients: Any) -> tuple[Any, Any]:
    """Ends of the interval nearest to zero on which a real polynomial is positive.

    Parameters
    ----------
    *coefficients : array_like
        Lowest power first.

    Returns
    -------
    lower, upper : numpy.ndarray
        Infinite where the interval has no end, NaN where there is none.
    """
    table = _table([np.asarray(c, dtype=np.float64) for c in coefficients])
    shape, flat = table.shape[:-1], table.reshape(-1, table.shape[-1])
    ends = np.full((len(flat), 2), np.nan)
    finite = np.isfinite(flat).all(axis=-1)
    highest = flat.shape[-1] - 1 - np.argmax(flat[:, ::-1] != 0.0, axis=-1)
    for degree in np.unique(highest[finite]):
        rows = finite & (highest == degree)
        ends[rows] = _intervals(flat[rows, : int(degree) + 1])
    return ends[:, 0].reshape(shape), ends[:, 1].reshape(shape)


def _horner(table: NDArray[np.float64], x: NDArray[np.float64]) -> Any:
    """Polynomials, one for each row, and their derivatives at the points of the row."""
    value = np.zeros_like(x) + table[:, -1:]
    slope = np.zeros_like(x)
    for k in range(table.shape[1] - 2, -1, -1):
        slope = slope * x + value
        value = value * x + table[:, k : k + 1]
    return value, slope


def _intervals(table: NDArray[np.float64]) -> NDArray[np.float64]:
    """As `zone`, for polynomials of one degree."""
    count, degree = len(table), table.shape[1] - 1
    inner = np.empty((count, 0))
    if degree:
        roots = _roots(table[:, :-1] / table[:, -1:])
        inner = np.sort(np.where(roots.imag == 0.0, roots.real, np.nan), axis=-1)
        for _ in range(2):  # Newton's steps take out the error of the companion matrix
            value, slope = _horner(table, inner)
            step = value / np.where(slope == 0.0, np.inf, slope)
            better = np.abs(_horner(table, inner - step)[0]) < np.abs(value)
            inner = np.where(better, inner - step, inner)
        inner = np.where(np.isnan(inner), np.inf, np.sort(inner, axis=-1))
    low = np.concatenate((np.full((count, 1), -np.inf), inner), axis=-1)
    high = np.concatenate((inner, np.full((count, 1), np.inf)), axis=-1)
    middle = np.where(
        np.isinf(low),
        np.where(np.isinf(high), 0.0, high - 1.0 - np.abs(high)),
        np.where(np.isinf(high), low + 1.0 + np.abs(low), 0.5 * low + 0.5 * high),
    )
    middle = np.where(np.isfinite(middle), middle, 0.0)
    positive = (high > low) & (_horner(table, middle)[0] > 0.0)
    gap = np.where(positive, np.maximum(np.maximum(low, -high), 0.0), np.inf)
    best = np.argmin(gap, axis=-1)[:, None]
    found = np.take_along_axis(positive, best, axis=-1)
    ends = np.concatenate([np.take_along_axis(e, best, axis=-1) for e in (low, high)], axis=-1)
    return np.where(found, ends, np.nan)


# --- the unstable interval of a frequency ---------------------------------------------------------


def explicit_edges(
    resonance: Kernel, boundaries: Kernel, multiple: float, arguments: Sequence[NDArray[np.float64]]
) -> tuple[Any, Any]:
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
    """

    def kernel(*inputs: Any) -> tuple[Any, Any]:
        centre, *rest = resonance(*inputs)
        lower, upper = boundaries(*rest)
        return _positive(centre + lower / multiple), _positive(centre + upper / multiple)

    return evaluate_pair(kernel, arguments)


def _positive(frequency: Any) -> Any:
    return np.where(np.asarray(frequency) > 0.0, frequency, np.nan)


def implicit_edges(
    detuning: Kernel, boundaries: Kernel, arguments: Sequence[NDArray[np.float64]]
) -> tuple[Any, Any]:
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
    arguments : sequence of numpy.ndarray
    """
    shape = np.broadcast_shapes(*(a.shape for a in arguments))
    size = int(np.prod(shape, dtype=np.int64))
    flat = [a.reshape(()) if a.size == 1 else np.broadcast_to(a, shape).ravel() for a in arguments]
    edges = np.full((2, size), np.nan)
    with np.errstate(all="ignore"):
        for start in range(0, size, ROOT_BLOCK):
            part = slice(start, min(start + ROOT_BLOCK, size))
            inputs = [a if a.ndim == 0 else a[part] for a in flat]
            edges[:, part] = _edges(detuning, boundaries, inputs, part.stop - part.start)
    return edges[0].reshape(shape)[()], edges[1].reshape(shape)[()]


# The grid on which a frequency without detuning is looked for, in units of its estimate.
_GRID = np.concatenate(([0.0], np.geomspace(1e-3, 1e3, 146)))

# Steps from there towards an edge, in units of the step of Newton's method.
_STEPS = np.array([0.0, 0.5, 0.8, 0.95, 1.0, 1.05, 1.2, 1.5, 2.0, 3.0, 5.0, 9.0, 17.0, 33.0, 65.0])


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

    centre = _first_root(free, estimate[:, None] * _GRID, estimate)
    result = np.full((2, count), np.nan)
    for edge in (0, 1):

        def gap(rows: NDArray[np.int64], frequency: NDArray[np.float64], edge: int = edge) -> Any:
            sigma, *rest = at(rows, frequency)
            return sigma - boundaries(*rest)[edge]

        step = 1e-6 * centre
        start = gap(everywhere, centre)
        slope = (gap(everywhere, centre + step) - start) / step
        grid = centre[:, None] - (start / slope)[:, None] * _STEPS
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
