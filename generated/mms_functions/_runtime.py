"""What all emitted modules share: checked arguments, evaluation in blocks.

NumPy is all that is needed.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "checked",
    "checked_amplitudes",
    "companion_roots",
    "defined",
    "evaluate",
    "evaluate_array",
    "evaluate_pair",
    "multiply_out",
    "no_edges",
    "refuse_masked",
    "stacked",
]

Kernel = Callable[..., Any]

# Points that are evaluated together. Their intermediates stay in the second-level cache, and are so
# small that the allocator keeps the memory instead of returning it to the system after each block,
# which costs more than the arithmetic.
BLOCK = 2048

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


def refuse_masked(name: str, value: Any) -> None:
    """Refuse values that are masked: an array without its mask would show what is beneath.

    A masked array in which nothing is masked passes.

    Raises
    ------
    ValueError
        Naming the argument.
    """
    masked = sys.modules.get("numpy.ma")  # which NumPy loads late; without it there are none
    parts = value if isinstance(value, list | tuple) else (value,)
    if masked and any(isinstance(v, masked.MaskedArray) and masked.is_masked(v) for v in parts):
        raise ValueError(f"{name} has masked values: leave these points out")


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
        refuse_masked(name, value)
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
    try:
        np.broadcast_shapes(*(array.shape for array in arrays))
    except ValueError:
        shapes = ", ".join(f"{name}: {a.shape}" for name, a in zip(values, arrays, strict=True))
        raise ValueError(f"shapes that do not broadcast together: {shapes}") from None
    return arrays


def checked_amplitudes(
    amplitudes: ArrayLike, count: int, *, missing: bool = False
) -> list[NDArray[np.complex128]]:
    """Amplitudes, shape (..., count), as one complex128 array for each coordinate.

    Parameters
    ----------
    amplitudes : array_like
    count : int
    missing : bool
        Whether NaN stands for an amplitude that is missing.

    Raises
    ------
    ValueError
        If the last axis has another length, or a value is not a finite number.
    """
    refuse_masked("the array of amplitudes", amplitudes)
    array = np.asarray(amplitudes)
    if array.dtype.kind not in "iufc":
        raise ValueError(f"amplitudes must be complex numbers, got {amplitudes!r}")
    if array.ndim == 0 or array.shape[-1] != count:
        raise ValueError(
            f"amplitudes must have the shape (..., {count}), one for each coordinate in the order "
            f"of COORDINATES, got {array.shape}"
        )
    array = array.astype(np.complex128, copy=False)
    if not (np.isfinite(array) | (np.isnan(array) & missing)).all():
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
    # Scalars become arrays: a kernel would make numbers of Python's of them, 1j * x, and these
    # raise where a divisor vanishes.
    arguments = [a if a.ndim else a.reshape(1) for a in arguments]
    outs = outs if shape else [out[np.newaxis] for out in outs]
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


# --- polynomials and matrices ---------------------------------------------------------------------


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


def stacked(entries: Sequence[Any]) -> NDArray[Any]:
    """Numbers and arrays that broadcast, as one array with the entries along its last axis."""
    return np.stack(np.broadcast_arrays(*entries), axis=-1)


def companion_roots(table: NDArray[np.float64]) -> NDArray[np.complex128]:
    """Roots of real monic polynomials, NaN where a coefficient is not finite."""
    n = table.shape[-1]
    finite = np.isfinite(table).all(axis=-1, keepdims=True)
    matrices = np.zeros((*table.shape, n))
    matrices[..., 1:, :-1] = np.eye(n - 1)
    matrices[..., :, -1] = -np.where(finite, table, 0.0)
    roots = np.linalg.eigvals(matrices).astype(np.complex128, copy=False)
    return np.where(finite, roots, complex(np.nan, np.nan))
