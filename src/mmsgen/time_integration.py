"""Time integration of the unexpanded equations: the reference for motions that are not periodic."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import MmsgenError
from .integration import RunAway, solution_at
from .motion import ATOL, RTOL, first_order_system
from .numeric import named_values
from .runtime._evolution import checked_times
from .runtime._runtime import refuse_masked

if TYPE_CHECKING:
    from .equations import EquationsOfMotion

__all__ = ["time_integration"]


def time_integration(
    eom: EquationsOfMotion, values: Mapping[Any, Any], q: Any, v: Any, times: Any
) -> tuple[Any, Any]:
    """Coordinates and velocities of the exact equations at times, from those at t = 0.

    All terms of the equations are kept, and nothing of the expansion enters. The method is that of
    Dormand and Prince, order 8, with local errors of 1e-12.

    Parameters
    ----------
    eom : EquationsOfMotion
    values : mapping
        Symbol or name → number.
    q, v : array_like
        Coordinates and velocities at t = 0, shape (n,).
    times : array_like
        t in s, of any shape, order and sign.

    Returns
    -------
    q, v : numpy.ndarray
        Shape (*times.shape, n).

    Raises
    ------
    MmsgenError
        If a value, a coordinate or a time is missing or unusable.
    CertificateError
        If accelerations enter other than linearly, or do not follow from the equations.
    """
    numbers = {name: _number(name, x) for name, x in named_values(eom.parameters, values).items()}
    present = set().union(*(e.free_symbols for e in eom.equations))
    missing = [p.name for p in eom.parameters if p.symbol in present and p.name not in numbers]
    if missing:
        raise MmsgenError(f"no value is given for {', '.join(missing)}")
    n = len(eom.coordinates)
    start = np.concatenate([_checked("q", q, n), _checked("v", v, n)])
    try:
        t = checked_times(times)
    except ValueError as error:
        raise MmsgenError(str(error)) from None
    scale = float(np.abs(start).max()) or 1.0
    try:
        found = solution_at(first_order_system(eom, numbers), start, t, RTOL, ATOL * scale)
    except RunAway as error:
        raise MmsgenError(
            f"the equations cannot be integrated to t = {error.time:g} s: {error.reason}; the "
            "motion may grow beyond all bounds"
        ) from None
    return found[..., :n], found[..., n:]


def _number(name: str, value: Any) -> float:
    if np.ndim(value):
        raise MmsgenError(f"{name} must be one number here, got an array of shape {value.shape}")
    return float(value)


def _checked(name: str, value: Any, n: int) -> Any:
    try:
        refuse_masked(name, value)
        array = np.asarray(value)
    except ValueError as error:
        raise MmsgenError(str(error)) from None
    if array.dtype.kind not in "iuf" or not np.isfinite(array).all():
        raise MmsgenError(f"{name} must be real and finite, got {value!r}")
    if array.shape != (n,):
        raise MmsgenError(
            f"{name} must have the shape ({n},), one for each coordinate, got {array.shape}"
        )
    return array.astype(float)
