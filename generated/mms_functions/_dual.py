"""Derivatives of emitted formulas by their parameters: forward differentiation, exact to rounding.

A `Dual` carries a value and its slopes by each parameter through every operation of a formula, so
that each formula is written once, and its derivatives cannot disagree with it. No step is chosen
and nothing cancels: the slopes are as good as those of a formula written out.

References
----------
A. Griewank and A. Walther, *Evaluating Derivatives* (2008), chapter 3.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Dual", "array_slopes", "boundaries_at", "real_at", "zone_slopes"]

Kernel = Callable[..., Any]


class Dual(np.lib.mixins.NDArrayOperatorsMixin):
    """Numbers with their slopes.

    Attributes
    ----------
    value : numpy.ndarray
        Of a shape that broadcasts to that of all points.
    slopes : numpy.ndarray
        One more axis in front, which counts the parameters; as many axes as there are in all.
    """

    def __init__(self, value: Any, slopes: Any) -> None:
        self.value = np.asarray(value)
        self.slopes = slopes

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        """NumPy's functions on duals: values as usual, slopes by the rule of the function."""
        if method != "__call__" or options:
            return NotImplemented
        values = [x.value if isinstance(x, Dual) else x for x in inputs]
        value = ufunc(*values)
        if ufunc is np.isfinite:
            return value
        if ufunc in _LINEAR:
            parts = [x.slopes if isinstance(x, Dual) else 0.0 for x in inputs]
            return Dual(value, ufunc(*parts))
        rule = _RULES.get(ufunc)
        if rule is None:
            return NotImplemented
        factors = rule(value, *values)
        parts = [f * x.slopes for f, x in zip(factors, inputs, strict=True) if isinstance(x, Dual)]
        return Dual(value, sum(parts[1:], parts[0]))

    def __array_function__(self, function: Any, _: Any, inputs: Any, options: Any) -> Any:
        """`numpy.where`, the one other function that formulas call."""
        if function is not np.where or options:
            return NotImplemented
        condition, *chosen = inputs
        values = (x.value if isinstance(x, Dual) else x for x in chosen)
        slopes = (x.slopes if isinstance(x, Dual) else 0.0 for x in chosen)
        return Dual(np.where(condition, *values), np.where(condition, *slopes))


_LINEAR = (np.add, np.subtract, np.negative, np.positive, np.conjugate)

#: function -> (value, *arguments) -> derivative by each argument; ``np.abs`` of real numbers only
_RULES: dict[Any, Callable[..., tuple[Any, ...]]] = {
    np.multiply: lambda _, a, b: (b, a),
    np.divide: lambda value, _, b: (1.0 / np.asarray(b), -value / b),
    np.sqrt: lambda value, _: (0.5 / value,),
    np.exp: lambda value, _: (value,),
    np.absolute: lambda _, a: (np.sign(a),),
}


class _Out:
    """What a kernel fills: values and slopes of each entry."""

    def __init__(self, shape: tuple[int, ...], trailing: tuple[int, ...], count: int) -> None:
        self.value = np.zeros((*shape, *trailing), dtype=np.complex128)
        self.slopes = np.zeros((count, *shape, *trailing), dtype=np.complex128)

    def __setitem__(self, index: Any, item: Any) -> None:
        if isinstance(item, Dual):
            self.value[index], self.slopes[index] = item.value, item.slopes
        else:
            self.value[index] = item


def _duals(arguments: Sequence[NDArray[Any]]) -> tuple[tuple[int, ...], list[Dual]]:
    shape = np.broadcast_shapes(*(a.shape for a in arguments))
    unit = np.eye(len(arguments)).reshape(-1, len(arguments), *(1 for _ in shape))
    return shape, [Dual(a, unit[k]) for k, a in enumerate(arguments)]


def array_slopes(
    kernel: Kernel, arguments: Sequence[NDArray[Any]], size: int
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """What a kernel fills its first argument with, and the derivatives by the other arguments.

    Parameters
    ----------
    kernel : callable
    arguments : sequence of numpy.ndarray
        Real, of shapes that broadcast.
    size : int
        Length of the last axis that the kernel fills.

    Returns
    -------
    values : numpy.ndarray
        Shape (..., size).
    slopes : numpy.ndarray
        Shape (parameters, ..., size).
    """
    shape, inputs = _duals(arguments)
    out = _Out(shape, (size,), len(arguments))
    with np.errstate(all="ignore"):
        kernel(out, *inputs)
    return out.value, out.slopes


def real_at(
    evaluated: Callable[..., Any], kernel: Kernel, arguments: Sequence[NDArray[Any]], names: Any
) -> Any:
    """One real number for each point; with names also its derivatives.

    Parameters
    ----------
    evaluated : callable
        What evaluates the kernel block by block.
    kernel : callable
        Returns its value.
    arguments : sequence of numpy.ndarray
        Those without a name come first.
    names : tuple of str
        Of the last arguments; empty where no derivatives are wanted.

    Returns
    -------
    numpy.ndarray, or (numpy.ndarray, dict)
    """
    value = evaluated(kernel, arguments)
    if not names:
        return value
    shape, inputs = _duals(arguments)
    with np.errstate(all="ignore"):
        found = _defined(kernel(*inputs), value, (len(inputs), *shape))
    return value, _named(names, found)


def boundaries_at(
    evaluated: Callable[..., Any], kernel: Kernel, arguments: Sequence[NDArray[Any]], names: Any
) -> Any:
    """Two real numbers for each point; with names also their derivatives.

    Parameters
    ----------
    evaluated, kernel, arguments, names
        As for `real_at`; the kernel returns a pair.

    Returns
    -------
    tuple, or (tuple, dict)
        (lower, upper), or this and name → (slope of lower, slope of upper).
    """
    pair = evaluated(kernel, arguments)
    if not names:
        return pair
    shape, inputs = _duals(arguments)
    whole = (len(inputs), *shape)
    with np.errstate(all="ignore"):
        found = [_defined(d, v, whole) for d, v in zip(kernel(*inputs), pair, strict=True)]
    lower, upper = (_named(names, part) for part in found)
    return pair, {name: (lower[name], upper[name]) for name in names}


def _defined(dual: Any, value: Any, shape: tuple[int, ...]) -> Any:
    """Slopes in the shape of all points, NaN where there is no finite value."""
    slopes = np.broadcast_to(dual.slopes if isinstance(dual, Dual) else 0.0, shape)
    return np.where(np.isfinite(value), slopes, np.nan)


def _named(names: Sequence[str], slopes: Any) -> dict[str, Any]:
    """The last slopes by name."""
    return dict(zip(names, (s[()] for s in slopes[-len(names) :]), strict=True))


def zone_slopes(edges: Sequence[Any], criteria: Sequence[Sequence[Any]]) -> tuple[Dual, ...]:
    """Edges of a zone with their slopes, −∂_p C/∂_σ C of the criterion C that vanishes there.

    Parameters
    ----------
    edges : sequence of numpy.ndarray
    criteria : sequence
        The coefficients of each polynomial in σ, lowest power first, duals among them.
    """
    found = []
    for edge in edges:
        x = np.where(np.isfinite(edge), edge, 0.0)
        best, slopes = np.full(x.shape, np.inf), None
        for polynomial in criteria:
            own = [c if isinstance(c, Dual) else Dual(c, 0.0) for c in polynomial]
            terms = [c.value * x**k for k, c in enumerate(own)]
            size = sum(map(np.abs, terms))
            gap = np.abs(sum(terms)) / np.where(size > 0.0, size, np.nan)
            rate = sum(k * c.value * x ** (k - 1) for k, c in enumerate(own) if k)
            own_slopes = -sum(c.slopes * x**k for k, c in enumerate(own)) / rate
            nearer = gap < best
            best = np.where(nearer, gap, best)
            slopes = own_slopes if slopes is None else np.where(nearer, own_slopes, slopes)
        found.append(Dual(edge, slopes))
    return tuple(found)
