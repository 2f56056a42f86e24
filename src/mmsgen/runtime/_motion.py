"""Coordinates from amplitudes: the uniform approximation with all its harmonics, in batches.

    q_j(t) = Re Σ_m c_m Π_k B_k^{r_k} B̄_k^{s_k} |B_k|^{t_k} e^{iθ_m t},
    θ_m = Σ_k (r_k − s_k)(ω_k + λ_k) + Σ_l h_l Ω_l

with terms that are fixed, and coefficients c_m and frequencies that depend on the parameters.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._dual import array_slopes
from ._flow import Flow, _product
from ._runtime import checked_amplitudes, evaluate_array, refuse_masked

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Motion", "multiples", "response_at"]

Kernel = Callable[..., Any]

LIMIT = 0.1
"""What may be left out, over the motion, before a user is warned."""


class Motion(NamedTuple):
    """The fixed part of a uniform approximation.

    Attributes
    ----------
    n : int
        Number of coordinates.
    terms : tuple
        (order, coordinate, (r_1, s_1, t_1, …), (h_1, …)).
    phasors : int
        Number of excitations' frequencies.
    """

    n: int
    terms: tuple[tuple[int, int, tuple[int, ...], tuple[int, ...]], ...]
    phasors: int = 0

    @property
    def order(self) -> int:
        """The highest order of a term."""
        return max((term[0] for term in self.terms), default=0)


class Slow(NamedTuple):
    """The slow flow behind the amplitudes: for their drift, and to judge what is small.

    Attributes
    ----------
    flow : Flow
    kernel : callable
        Fills the coefficients of its terms.
    taken : int
        How many of the arguments, the first ones, it takes.
    """

    flow: Flow
    kernel: Kernel
    taken: int


def response_at(
    motion: Motion,
    kernel: Kernel,
    arguments: Sequence[NDArray[np.float64]],
    t: ArrayLike,
    amplitudes: ArrayLike,
    *,
    order: int | None = None,
    drift: ArrayLike | None = None,
    slow: tuple[Flow, Kernel, int] | None = None,
    names: Sequence[str] = (),
) -> Any:
    """Coordinates at times.

    Parameters
    ----------
    motion : Motion
    kernel : callable
        Fills the coefficients of all terms, then the frequencies.
    arguments : sequence of numpy.ndarray
        What it takes.
    t : array_like
    amplitudes : array_like
        Shape (..., n); NaN gives NaN.
    order : int, optional
        The highest order of the terms that are summed; all of them by default.
    drift : array_like, optional
        Shape (..., symmetries): the amplitudes turn, B_j e^{i k_j ρ t}.
    slow : tuple, optional
        As for `Slow`.
    names : sequence of str
        Of the arguments, where derivatives by them are wanted.

    Returns
    -------
    numpy.ndarray, or (numpy.ndarray, dict)
        Shape (..., n); NaN where a coefficient is not finite, whether its term is summed or not.

    Raises
    ------
    ValueError
        If an argument is not as it should be, or the shapes do not broadcast.
    """
    behind = None if slow is None else Slow(*slow)
    times = _checked_times(t)
    columns = checked_amplitudes(amplitudes, motion.n, missing=True)
    highest = _checked_order(order, motion)
    size = len(motion.terms) + motion.n + motion.phasors
    slopes: Any = ()
    if names:
        table, slopes = array_slopes(kernel, arguments, size)
    else:
        table = evaluate_array(kernel, arguments, (size,))
    moving = columns if drift is None else _drifted(columns, times, drift, behind)
    _demand_common_shape(times, moving[0], table[..., 0])
    with np.errstate(all="ignore"):
        found, derivatives = _sum(motion, table, slopes, times, moving, highest)
        groups = _groups(motion, table, highest)
        if behind is not None:
            groups.append((1, _slowness(behind, arguments, table, motion)))
        small = _small(motion, groups, table, columns, highest)
    _warn(small, highest)
    return (found, dict(zip(names, derivatives, strict=True))) if names else found


def _warn(small: float, highest: int) -> None:
    """Tell who calls an emitted function where what is left out is not small."""
    with np.errstate(over="ignore"):
        estimate = np.float64(small) ** (highest + 1)  # infinite where a float would raise
    if estimate > LIMIT:
        warnings.warn(
            f"outside of the validity of the scaling: what counts as small amounts to {small:.2g} "
            f"here, so that the terms beyond order {highest} are estimated at {estimate:.2g} of "
            "the motion",
            UserWarning,
            stacklevel=4,
        )


# --- the sum over all terms -----------------------------------------------------------------------


def _sum(
    motion: Motion, table: Any, slopes: Any, times: Any, columns: Sequence[Any], highest: int
) -> tuple[Any, Any]:
    """Coordinates and their derivatives."""
    n, count = motion.n, len(motion.terms)
    rates = [table[..., count + k].real for k in range(n + motion.phasors)]
    turns = [np.exp(1j * rate * times) for rate in rates]
    moving = [b * turn for b, turn in zip(columns, turns, strict=False)]
    shape = np.broadcast_shapes(*(x.shape for x in (*turns, *moving)))
    out = np.where(_known(table, shape)[..., None], np.zeros(n), np.nan)
    derivatives = np.zeros((len(slopes), *shape, n))
    for m, (order, j, exponents, harmonics) in enumerate(motion.terms):
        if order > highest:
            continue
        value = _product(moving, exponents) * _product(turns[n:], _triples(harmonics))
        part = table[..., m] * value
        out[..., j] += part.real
        for derivative, slope in zip(derivatives, slopes, strict=True):
            angle = slope[..., count:].real @ multiples(exponents, harmonics)
            derivative[..., j] += (value * slope[..., m] + 1j * angle * times * part).real
    return out, derivatives


def _known(table: Any, shape: tuple[int, ...]) -> NDArray[np.bool_]:
    """Where all coefficients are finite."""
    return np.broadcast_to(np.isfinite(table).all(axis=-1), shape)


def _triples(harmonics: tuple[int, ...]) -> tuple[int, ...]:
    """Powers of e^{iΩt} as those of a number and of its conjugate."""
    return tuple(x for h in harmonics for x in (max(h, 0), max(-h, 0), 0))


def multiples(exponents: tuple[int, ...], harmonics: tuple[int, ...]) -> NDArray[np.float64]:
    """The multiples of all frequencies in θ_m."""
    own = [r - s for r, s in zip(exponents[::3], exponents[1::3], strict=True)]
    return np.array([*own, *harmonics], dtype=np.float64)


def _drifted(columns: Sequence[Any], times: Any, drift: ArrayLike, slow: Slow | None) -> list[Any]:
    """Amplitudes on their way along the symmetries."""
    symmetries = () if slow is None else slow.flow.symmetries
    refuse_masked("drift", drift)
    rates = np.asarray(drift)
    if rates.dtype.kind not in "iuf" or rates.ndim == 0 or rates.shape[-1] != len(symmetries):
        raise ValueError(
            f"drift must be real, of the shape (..., {len(symmetries)}), one rate for each "
            f"symmetry of the slow flow, got {drift!r}"
        )
    if np.isinf(rates).any():
        raise ValueError("drift must be finite")
    turned = []
    for j, b in enumerate(columns):
        rate = rates @ np.array([k[j] for k in symmetries], dtype=np.float64)
        turned.append(b * np.exp(1j * rate * times))
    return turned


# --- validity -------------------------------------------------------------------------------------
#
# What counts as small is a matrix R of numbers that are not negative: R_jk |B_k| is the part of
# coordinate j that one order makes of amplitude k. Its spectral radius is the ratio of that order
# to the motion if there is one coordinate only; of several it does not depend on their units, nor
# on how large one of them happens to be beside the others.

Group = list[tuple[int, tuple[int, ...], Any]]
"""Terms: coordinate, (r_1, s_1, t_1, …), modulus of the coefficient."""

# Stands for an amplitude that is zero: what is linear in it counts all the same.
TINY = 1e-100


def _groups(motion: Motion, table: Any, highest: int) -> list[tuple[int, Group]]:
    """The harmonics of each order from one on."""
    found: dict[int, Group] = {k: [] for k in range(1, highest + 1)}
    for m, (order, j, exponents, _) in enumerate(motion.terms):
        if order in found:
            found[order].append((j, exponents, np.abs(table[..., m])))
    return list(found.items())


def _slowness(
    slow: Slow, arguments: Sequence[NDArray[np.float64]], table: Any, motion: Motion
) -> Group:
    """The terms of the slow flow over the frequencies.

    Forces have no part in it: from rest amplitudes grow by as much as they are large.
    """
    c = evaluate_array(slow.kernel, arguments[: slow.taken], (len(slow.flow.terms),))
    fast = [np.abs(table[..., len(motion.terms) + j].real) for j in range(motion.n)]
    return [
        (j, exponents, np.abs(c[..., m]) / fast[j])
        for m, (j, exponents) in enumerate(slow.flow.terms)
        if any(exponents)
    ]


def _small(
    motion: Motion,
    groups: Sequence[tuple[int, Group]],
    table: Any,
    columns: Sequence[NDArray[np.complex128]],
    highest: int,
) -> float:
    """What is small: the largest k-th root of what order k makes of the motion."""
    n, moduli = motion.n, [np.abs(b) for b in columns]
    sizes = [np.where(size == 0.0, TINY, size) for size in moduli]
    shape = np.broadcast_shapes(sizes[0].shape, table.shape[:-1])
    # What the excitation alone makes of a coordinate at order zero, where it is not weak.
    driven = [np.zeros(table.shape[:-1]) for _ in range(n)]
    for m, (order, j, exponents, _) in enumerate(motion.terms):
        if not order and not any(exponents):
            driven[j] = driven[j] + np.abs(table[..., m])
    worst = 0.0
    for k, group in groups:
        matrices = np.zeros((*shape, n, n))
        for j, exponents, c in group:
            powers = [sum(exponents[3 * i : 3 * i + 3]) for i in range(n)]
            if not any(powers):
                alone = np.where(driven[j] > 0.0, c / driven[j], 0.0)
                matrices[..., j, j] += np.where(np.isinf(c), np.inf, alone)
            for i, power in enumerate(powers):
                if power:
                    rest = [q - (i == place) for place, q in enumerate(powers)]
                    product = c * (power / sum(powers))
                    for size, q in zip(sizes, rest, strict=True):
                        product = product * size**q if q else product
                    matrices[..., j, i] += product
        enough = LIMIT ** (k / (highest + 1))
        worst = max(worst, _radius(matrices.reshape(-1, n, n), enough) ** (1 / k))
    return worst


def _radius(matrices: NDArray[np.float64], enough: float) -> float:
    """The largest spectral radius of matrices, NaN left out; a bound of it below `enough`."""
    matrices = np.where(np.isnan(matrices), 0.0, matrices)
    if not matrices.size or np.isinf(matrices).any():
        return np.inf if matrices.size else 0.0
    # That of matrices that are not negative grows with each of their entries.
    bound = float(np.abs(np.linalg.eigvals(matrices.max(axis=0))).max())
    if bound <= enough or len(matrices) == 1:
        return bound
    return float(np.abs(np.linalg.eigvals(matrices)).max())


# --- arguments ------------------------------------------------------------------------------------


def _checked_times(t: ArrayLike) -> NDArray[np.float64]:
    refuse_masked("the array of times", t)
    times = np.asarray(t)
    if times.dtype.kind not in "iuf" or not np.isfinite(times).all():
        raise ValueError(f"the time must be real and finite, got {t!r}")
    return times.astype(np.float64, copy=False)


def _checked_order(order: int | None, motion: Motion) -> int:
    if order is None:
        return motion.order
    if isinstance(order, bool) or not isinstance(order, int | np.integer):
        raise ValueError(f"order must be a whole number, got {order!r}")
    if not 0 <= order <= motion.order:
        raise ValueError(f"order must be from 0 to {motion.order}, got {order!r}")
    return int(order)


def _demand_common_shape(times: Any, column: Any, coefficient: Any) -> None:
    try:
        np.broadcast_shapes(times.shape, column.shape, coefficient.shape)
    except ValueError:
        raise ValueError(
            f"shapes that do not broadcast together: the time {times.shape}, amplitudes "
            f"{column.shape} without their last axis, parameters {coefficient.shape}"
        ) from None
