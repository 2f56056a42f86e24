"""Amplitudes from a state: the uniform approximation and its velocity at t = 0, solved for them.

    q(B) = Re Σ_m c_m s^p M_m(B),    q'(B) = Re Σ_m c_m s^p [iθ'_m M_m + s dM_m/dt],

with M_m = Π B_k^{r_k} B̄_k^{s_k} |B_k|^{t_k}, p the order of the term, dM_m/dt along the slow flow,
and s = 1. For s = 0 both are linear in the amplitudes. Newton's method begins with that solution;
where its steps do not shrink at once, s goes from 0 to 1 in small stages. So it comes to the
amplitudes that go over into those of order zero as ε → 0, or to none.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._flow import _factor, _product
from ._motion import Motion, multiples
from ._runtime import evaluate_array, refuse_masked

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["initial_at"]

Kernel = Callable[..., Any]

STEPS = 12
"""Of Newton's method at most: steps that halve, then their squares, come to rounding in ten."""

SHRINK = 0.5
"""What a step may be over the one before it: half of Kantorovich's bound, so that the solution is
the one of the starting point."""

STAGES = 16
"""From order zero to all orders, where one is too far."""

DIFFERENCE = 1e-6
"""Step of the differences in Newton's matrix, over the amplitudes: its errors of 1e-9 to 1e-6 slow
the last steps down a little, and do not show in the result."""

CLOSE = 1e-10
"""The last step, over the amplitudes: the error behind it is DIFFERENCE times that."""


def initial_at(
    motion: Motion,
    kernel: Kernel,
    arguments: Sequence[NDArray[np.float64]],
    q: ArrayLike,
    v: ArrayLike,
    slow: tuple[Kernel, int, bool],
) -> NDArray[np.complex128]:
    """Amplitudes at t = 0 of a motion with given coordinates and velocities.

    Parameters
    ----------
    motion : Motion
    kernel : callable
        Fills the coefficients of all terms, then the frequencies.
    arguments : sequence of numpy.ndarray
        What it takes.
    q, v : array_like
        Shape (..., n): coordinates and their velocities at t = 0.
    slow : (callable, int, bool)
        The kernel of the right-hand side of the slow flow, how many of the arguments, the first
        ones, it takes after the amplitudes, and whether it takes the time after them.

    Returns
    -------
    numpy.ndarray of complex128
        Shape (..., n); NaN where Newton's method does not converge, as far outside of the scaling,
        or where a coefficient is not finite.

    Raises
    ------
    ValueError
        If q or v is not as it should be, or the shapes do not broadcast.
    """
    n, count = motion.n, len(motion.terms)
    position, velocity = _checked("q", q, n), _checked("v", v, n)
    table = evaluate_array(kernel, arguments, (count + n + motion.phasors,))
    shape = _common_shape(position, velocity, table)
    taken = [np.broadcast_to(a, shape).reshape(-1) for a in arguments[: slow[1]]]
    if slow[2]:
        taken.append(np.zeros(1))
    table = np.broadcast_to(table, (*shape, table.shape[-1])).reshape(-1, table.shape[-1])
    wanted = np.concatenate(
        [np.broadcast_to(x, (*shape, n)).reshape(-1, n) for x in (position, velocity)], axis=1
    )
    with np.errstate(all="ignore"):
        # Velocities over a frequency have the unit of coordinates.
        speed = np.abs(table[:, count : count + n].real).max(axis=1, keepdims=True, initial=0.0)
        weight = np.where(np.arange(2 * n) < n, 1.0, 1.0 / np.where(speed > 0.0, speed, 1.0))

        def left(b: NDArray[Any], k: NDArray[np.int64], share: float) -> NDArray[np.float64]:
            rate = np.zeros_like(b)
            if share:
                own = [a[k] if a.size > 1 else a for a in taken]
                rate = share * evaluate_array(slow[0], [*b.T, *own], (n,))
            return (_state(motion, table[k], b, rate, share) - wanted[k]) * weight[k]

        size = np.abs(wanted * weight).max(axis=1, initial=0.0)
        start = _solved(left, np.zeros((len(table), n), dtype=np.complex128), size, 0.0)
        b = _solved(left, start, size, 1.0)
        far = np.flatnonzero(np.isnan(b).any(axis=1) & np.isfinite(start).all(axis=1))
        if len(far):
            b[far] = _in_stages(left, start, size, far)
    b[~np.isfinite(table).all(axis=1)] = np.nan
    return b.reshape(*shape, n)


def _state(
    motion: Motion, table: NDArray[Any], b: NDArray[Any], rate: NDArray[Any], share: float
) -> NDArray[np.float64]:
    """Coordinates and velocities at t = 0, shape (K, 2n), with s = share."""
    n, count = motion.n, len(motion.terms)
    columns, slopes = list(b.T), list(rate.T)
    out = np.zeros((len(b), 2 * n))
    for m, (order, j, exponents, harmonics) in enumerate(motion.terms):
        if order and not share:
            continue
        value = share**order * _product(columns, exponents)
        turn = table[:, count:].real @ multiples(exponents, harmonics)
        change = 1j * turn * value + share**order * _along(columns, slopes, exponents)
        out[:, j] += (table[:, m] * value).real
        out[:, n + j] += (table[:, m] * change).real
    return out


def _along(columns: list[Any], slopes: list[Any], exponents: tuple[int, ...]) -> Any:
    """The derivative of a monomial along the slow flow."""
    total: Any = 0.0
    for k, (b, slope) in enumerate(zip(columns, slopes, strict=True)):
        r, s, t = exponents[3 * k : 3 * k + 3]
        own: Any = 0.0
        if r:
            own = own + r * _factor(b, r - 1, s, t) * slope
        if s:
            own = own + s * _factor(b, r, s - 1, t) * slope.conj()
        if t:
            own = own + t * _factor(b, r, s, t - 2) * (b.conj() * slope).real
        if r or s or t:
            total = total + own * _product(columns, exponents, skip=k)
    return total


Residual = Callable[["NDArray[Any]", "NDArray[np.int64]", float], "NDArray[np.float64]"]


def _in_stages(
    left: Residual,
    start: NDArray[np.complex128],
    size: NDArray[np.float64],
    points: NDArray[np.int64],
) -> NDArray[np.complex128]:
    """The solutions at some points, followed from order zero."""

    def own(b: NDArray[Any], k: NDArray[np.int64], share: float) -> NDArray[np.float64]:
        return left(b, points[k], share)

    b = start[points]
    for stage in range(1, STAGES + 1):
        b = _solved(own, b, size[points], stage / STAGES)
    return b


def _solved(
    left: Residual, b: NDArray[np.complex128], size: NDArray[np.float64], share: float
) -> NDArray[np.complex128]:
    """Newton's method for all points together; NaN where it does not converge from there."""
    from ._paths import solve  # only now: the module is imported with every case

    n = b.shape[1]
    b, done = b.copy(), np.zeros(len(b), dtype=bool)
    before = np.full(len(b), np.inf)
    todo = np.flatnonzero(np.isfinite(b).all(axis=1))
    for _ in range(STEPS):
        if not len(todo):
            break
        rest = left(b[todo], todo, share)
        reach = np.maximum(np.abs(b[todo]).max(axis=1, initial=0.0), size[todo])
        reach = np.where(reach > 0.0, reach, np.abs(rest).max(axis=1, initial=0.0))
        h = DIFFERENCE * np.where(reach > 0.0, reach, 1.0)[:, None]
        columns = []
        for unit in (1.0, 1j):
            for j in range(n):
                moved = b[todo] + unit * h * (np.arange(n) == j)
                columns.append((left(moved, todo, share) - rest) / h)
        matrix = np.stack(columns, axis=-1)
        finite = np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(rest).all(axis=1)
        usable = np.asarray(finite)
        matrix[~usable] = np.eye(2 * n)
        step = solve(matrix, np.where(usable[:, None], rest, np.nan)[..., None])[..., 0]
        b[todo] -= step[:, :n] + 1j * step[:, n:]
        length = np.abs(step).max(axis=1, initial=0.0)
        done[todo] = length <= CLOSE * reach
        usable &= ~done[todo] & (length <= SHRINK * before[todo])
        before[todo] = length
        todo = todo[usable]
    b[~done] = np.nan
    return b


# --- arguments ------------------------------------------------------------------------------------


def _checked(name: str, value: ArrayLike, n: int) -> NDArray[np.float64]:
    refuse_masked(name, value)
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{name} must be an array of numbers: {error}") from None
    if array.dtype.kind not in "iuf" or not np.isfinite(array).all():
        raise ValueError(f"{name} must be real and finite, got {value!r}")
    if array.ndim == 0 or array.shape[-1] != n:
        raise ValueError(
            f"{name} must have the shape (..., {n}), one for each coordinate in the order of "
            f"COORDINATES, got {array.shape}"
        )
    return array.astype(np.float64, copy=False)


def _common_shape(q: Any, v: Any, table: Any) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(q.shape[:-1], v.shape[:-1], table.shape[:-1])
    except ValueError:
        raise ValueError(
            f"shapes that do not broadcast together: q {q.shape}, v {v.shape} without their last "
            f"axes, parameters {table.shape[:-1]}"
        ) from None
