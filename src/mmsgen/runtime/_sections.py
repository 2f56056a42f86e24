"""Values of a parameter at which all equilibria are computed; curves are followed between them.

None of the equilibria there is singular, as far as that can be avoided: at a fold two of them are
one, and which curve leads where is lost. So these values are not always given ones.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._flow import Flow, jacobian, spectrum
from ._isolas import touching
from ._many_amplitudes import equilibria_of_many
from ._one_amplitude import equilibria_of_one
from ._pairs import meetings
from ._records import Equilibria

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

__all__ = ["sections_of"]

SECTIONS = 48
"""Values of the parameter at which all equilibria of several amplitudes are computed, at first."""

SECTIONS_OF_ONE, LOOKED_AT = 40, 2048
"""The same for one amplitude, and at how many values there its equilibria are counted."""

FEWEST, FEWEST_OF_ONE = 24, 513
"""Where fewer values are given, as many more between them: curves are not followed far."""

MOST_MORE = 60
"""Most sections that are put where closed branches are."""

REGULAR = 1e-4
"""An eigenvalue that is smaller than the others by this is nearly zero: 1e-8 from a fold."""

DOUBLE = 1e-6
"""Below this, two equilibria are one to the rounding."""

ASIDE, BEYOND = 0.382, 1e-3
"""How far a section moves: of the way to the next value; at the ends, of the range."""


FURTHER = (0.0, 0.1, 0.4)
"""The same where it has to go further: of the way from there to the next section."""


def sections_of(
    flow: Flow, numbers: Callable[[Any], NDArray[np.complex128]], p: NDArray[np.float64]
) -> tuple[NDArray[np.float64], Equilibria]:
    """Values, ascending, and all equilibria there.

    Parameters
    ----------
    flow : Flow
    numbers : callable
        p → coefficients, shape (K,) → (K, terms).
    p : numpy.ndarray
        Given values, ascending. The first and the last section may be beyond them.
    """
    if len(p) == 1:
        return p, _solved(flow, numbers(p))
    values = _base(flow, numbers, p)
    sections, found, fixed = (_of_one if flow.n == 1 else _of_many)(flow, numbers, values, p)
    first = sections.copy()
    bad = np.flatnonzero(_singular(flow, _extended(numbers, p, sections), found))
    bad = bad[~np.isin(sections[bad], fixed)]  # on small closed branches all is nearly singular
    for further in FURTHER:
        if not len(bad):
            break
        for k in bad:
            if k in (0, len(first) - 1):
                reach = (p[-1] - p[0]) * BEYOND * (-1.0 if k == 0 else 1.0)
                sections[k] = first[k] + reach * (1.0 + 10.0 * further)
            else:
                after = values[np.searchsorted(values, first[k], side="right")]
                after += further * (first[k + 1] - after)
                sections[k] = first[k] + ASIDE * (after - first[k])
        c = _extended(numbers, p, sections[bad])
        more = _solved(flow, c)
        rest = np.setdiff1d(np.arange(len(sections)), bad)
        order = np.argsort(np.concatenate((rest, bad)))
        found = _picked(_together(_picked(found, rest), more), order)
        bad = bad[_singular(flow, c, more)]
    sections, order = np.unique(sections, return_index=True)
    return sections, _picked(found, order)


def _base(
    flow: Flow, numbers: Callable[[Any], NDArray[np.complex128]], p: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The given values, or some of them where they are many, and others where they are few."""
    fewest = FEWEST_OF_ONE if flow.n == 1 else FEWEST
    if len(p) >= fewest:
        return p[_spread(len(p), LOOKED_AT)] if flow.n == 1 else p
    more = np.linspace(p[0], p[-1], fewest)[1:-1]
    return np.union1d(p, more[np.isfinite(numbers(more)).all(axis=-1)])


def _of_one(
    flow: Flow,
    numbers: Callable[[Any], NDArray[np.complex128]],
    p: NDArray[np.float64],
    given: NDArray[np.float64],
) -> tuple[NDArray[np.float64], Equilibria, NDArray[np.float64]]:
    """Sections, equilibria there, and those of the sections that must stay where they are."""
    c = numbers(p)
    every = _solved(flow, c)
    number, singular = every.number, _singular(flow, c, every)
    chosen = _spread(len(p), SECTIONS_OF_ONE)
    # A closed branch shows in the number of equilibria: one section at least for each number.
    stops = np.concatenate(([0], np.flatnonzero(np.diff(number)) + 1, [len(p)]))
    first, last = stops[:-1], stops[1:] - 1
    regular = chosen[~singular[chosen]]
    empty = np.searchsorted(regular, first) == np.searchsorted(regular, last, side="right")
    # More than on either side: at a single fold there is the mean of both.
    empty &= number[first] >= number[np.maximum(first - 1, 0)]
    empty &= number[first] >= number[np.minimum(last + 1, len(p) - 1)]
    empty &= (last > first) | ~_singular(flow, c[first], _picked(every, first), DOUBLE)
    middle = 0.5 * (p[first] + p[last])[empty & (number[first] > 0)]
    fixed = np.concatenate((middle[:MOST_MORE], touching(flow, numbers, p)[:MOST_MORE]))
    fixed = _snapped(fixed, given)
    if not len(fixed):
        return p[chosen], _picked(every, chosen), fixed
    at, order = np.unique(np.concatenate((p[chosen], fixed)), return_index=True)
    found = _together(_picked(every, chosen), _solved(flow, numbers(fixed)))
    return at, _picked(found, order), fixed


def _snapped(at: NDArray[np.float64], given: NDArray[np.float64]) -> NDArray[np.float64]:
    """The given values in place of those that differ from them by rounding."""
    after = np.clip(np.searchsorted(given, at), 1, len(given) - 1)
    near = np.where(at - given[after - 1] < given[after] - at, given[after - 1], given[after])
    return np.where(np.abs(near - at) < 1e-9 * (given[-1] - given[0]), near, at)


def _of_many(
    flow: Flow,
    numbers: Callable[[Any], NDArray[np.complex128]],
    p: NDArray[np.float64],
    given: NDArray[np.float64],
) -> tuple[NDArray[np.float64], Equilibria, NDArray[np.float64]]:
    # A double equilibrium may not be found, so that none of them is looked at where one was given.
    at = p.copy()
    at[1:-1] += ASIDE * np.diff(p)[1:]
    chosen = _spread(len(p), SECTIONS)
    found = _solved(flow, numbers(at[chosen]))
    change = np.diff(found.number) != 0
    middle = np.setdiff1d((chosen[:-1] + chosen[1:])[change] // 2, chosen)
    if len(middle):
        found = _together(found, _solved(flow, numbers(at[middle])))
        chosen = np.concatenate((chosen, middle))
        order = np.argsort(chosen)
        chosen, found = chosen[order], _picked(found, order)
    sections = at[chosen]
    between = _snapped(meetings(flow, numbers, sections)[:MOST_MORE], given)
    if not len(between):
        return sections, found, between
    sections, order = np.unique(np.concatenate((sections, between)), return_index=True)
    found = _together(found, _solved(flow, numbers(between)))
    return sections, _picked(found, order), between


def _solved(flow: Flow, c: NDArray[np.complex128]) -> Equilibria:
    if flow.n == 1:
        return equilibria_of_one(flow, c, circles=False)
    return equilibria_of_many(flow, c)


def _singular(
    flow: Flow, c: NDArray[Any], found: Equilibria, least: float = REGULAR
) -> NDArray[np.bool_]:
    """Whether an eigenvalue of one of the equilibria is nearly zero, but for the symmetries."""
    c = c[:, None, :]
    drift = found.drift if flow.symmetries else None
    there = np.isfinite(found.amplitudes).all(axis=-1)
    if flow.n == 1:
        j = jacobian(flow, c, found.amplitudes, drift)
        size = np.abs(j).max(axis=(-1, -2))
        if flow.symmetries:
            ratio = np.abs(j[..., 0, 0] + j[..., 1, 1]) / size
        else:
            ratio = np.abs(j[..., 0, 0] * j[..., 1, 1] - j[..., 0, 1] * j[..., 1, 0]) / size**2
    else:
        sizes = np.abs(spectrum(flow, c, found.amplitudes, drift))
        sizes = np.where(np.isfinite(sizes), sizes, np.nan)
        ratio = np.nanmin(np.append(sizes, np.full((*sizes.shape[:-1], 1), np.inf), -1), -1)
        ratio /= np.nanmax(np.append(sizes, np.zeros((*sizes.shape[:-1], 1)), -1), -1)
    singular: NDArray[np.bool_] = (there & ~(ratio > least)).any(axis=-1)
    return singular


def _extended(
    numbers: Callable[[Any], NDArray[np.complex128]],
    p: NDArray[np.float64],
    at: NDArray[np.float64],
) -> NDArray[np.complex128]:
    """Coefficients, which go on as straight lines beyond the values."""
    inside = np.clip(at, p[0], p[-1])
    back = inside + 1e-6 * (p[-1] - p[0]) * np.where(at > inside, -1.0, 1.0)
    c = numbers(inside)
    if np.array_equal(inside, at):
        return c
    slope = (numbers(np.clip(back, p[0], p[-1])) - c) / (back - inside)[:, None]
    return c + np.where(at == inside, 0.0, at - inside)[:, None] * slope


def _spread(size: int, count: int) -> NDArray[np.int64]:
    """At most `count` places among `size`, the first and the last with them."""
    return np.unique(np.linspace(0, size - 1, count).round().astype(np.int64))


def _together(one: Equilibria, other: Equilibria) -> Equilibria:
    width = max(one.amplitudes.shape[1], other.amplitudes.shape[1])
    pairs = zip(one, other, strict=True)
    parts: list[Any] = [np.concatenate((_wide(a, width), _wide(b, width))) for a, b in pairs]
    return Equilibria(*parts)


def _picked(found: Equilibria, rows: NDArray[np.int64]) -> Equilibria:
    parts: list[Any] = [part[rows] for part in found]
    return Equilibria(*parts)


def _wide(part: NDArray[Any], width: int) -> NDArray[Any]:
    """Filled up with NaN along the second axis."""
    missing = [(0, 0), (0, width - part.shape[1])] + [(0, 0)] * (part.ndim - 2)
    return np.pad(part, missing, constant_values=np.nan)
