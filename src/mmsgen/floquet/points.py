"""`Points`: the numeric values of the parameters, checked, broadcast and flattened."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
import sympy as sp

from ..errors import FloquetError
from ..parameters import Parameter

__all__ = ["Floats", "Points", "Values", "make_points"]

Floats: TypeAlias = npt.NDArray[np.float64]
Values: TypeAlias = Mapping[Any, Any]


@dataclass(frozen=True)
class Points:
    """Parameter points in a row.

    Parameters
    ----------
    shape : tuple of int
        The batch shape that results take.
    arrays : dict of str to numpy.ndarray
        Flat float64 values, shape (number of points,), by parameter name. Arrays that were
        given as scalars are broadcast views.
    """

    shape: tuple[int, ...]
    arrays: dict[str, Floats]

    @property
    def count(self) -> int:
        """Number of points in the batch."""
        return int(np.prod(self.shape, dtype=np.int64))

    def take(self, index: npt.NDArray[np.intp] | slice) -> dict[str, Floats]:
        """The values at some of the points."""
        return {name: array[index] for name, array in self.arrays.items()}


def make_points(
    values: Values,
    parameters: Iterable[Parameter],
    known: Iterable[sp.Symbol],
    extra: Mapping[str, Floats] | None = None,
) -> Points:
    """Check values and broadcast them to a batch.

    Parameters
    ----------
    values : mapping of symbol or name to scalar or array
        Numbers for the parameters.
    parameters : iterable of Parameter
        The declared parameters.
    known : iterable of sympy.Symbol
        Further symbols that occur in the equations.
    extra : mapping of str to numpy.ndarray, optional
        Further arrays to be broadcast with the values, already checked.

    Returns
    -------
    Points
        All given values, flat.

    Raises
    ------
    FloquetError
        For an unknown or doubly given name, a value that is not a finite real number or
        contradicts the symbol's assumptions, or shapes that do not broadcast.
    """
    symbols = {p.name: p.symbol for p in parameters}
    symbols.update({str(s.name): s for s in known})
    arrays: dict[str, Floats] = {}
    for key, value in values.items():
        name = str(key.name) if isinstance(key, sp.Symbol) else str(key)
        if name not in symbols:
            raise FloquetError(
                f"unknown parameter {name!r}: the system has {', '.join(sorted(symbols)) or 'none'}"
            )
        if name in arrays:
            raise FloquetError(f"{name!r} is given twice, by symbol and by name: drop one")
        arrays[name] = _checked(name, value, symbols[name])
    arrays.update(extra or {})
    try:
        shape = np.broadcast_shapes(*(a.shape for a in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name}: {a.shape}" for name, a in arrays.items())
        raise FloquetError(f"the values do not broadcast to one batch: {shapes}") from None
    # A zero-dimensional value stays one number for all points: nothing is copied per point.
    flat = {name: np.broadcast_to(a, shape).reshape(-1) for name, a in arrays.items()}
    return Points(shape=shape, arrays=flat)


def _checked(name: str, value: object, symbol: sp.Symbol) -> Floats:
    """`value` as float64, or an error that names the symbol."""
    try:
        raw = np.asarray(value)
        if raw.dtype.kind in "USb":  # NumPy would read the text "1" as a number
            raise TypeError
        if raw.dtype == object:
            if any(isinstance(x, bool) for x in raw.ravel()):
                raise TypeError
            raw = np.array([float(x) for x in raw.ravel()]).reshape(raw.shape)
        if np.iscomplexobj(raw):
            raise TypeError
        array = raw.astype(np.float64)
    except (TypeError, ValueError, OverflowError):
        raise FloquetError(
            f"the value of {name!r} is not a real number or an array of them: {value!r}"
        ) from None
    if not np.all(np.isfinite(array)):
        raise FloquetError(f"the value of {name!r} contains NaN or infinity")
    if symbol.is_nonnegative and np.any(array < 0):
        raise FloquetError(
            f"{name!r} is declared {'positive' if symbol.is_positive else 'nonnegative'} but has "
            f"the value {float(array.min())!r}"
        )
    if symbol.is_nonpositive and np.any(array > 0):
        raise FloquetError(f"{name!r} is declared negative but has a positive value")
    return array
