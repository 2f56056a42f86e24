"""Generic points for reference values: exact in double precision, the same on every machine."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice, permutations
from typing import Any

import mpmath

from ..parameters import Parameter
from .boundaries import boundary_parameters, boundary_values
from .docstrings import domain_of
from .kernels import AMPLITUDES, TIME, EmittedFunction, Kernel
from .setting import Setting, values_of

__all__ = ["points_of", "speed_points_of"]

COUNT = 3

_FREQUENCIES = (19, 27, 37, 51, 71, 97, 131, 173, 229, 307)
_INSIDE = (mpmath.mpf(5) / 16, mpmath.mpf(11) / 16, mpmath.mpf(21) / 16)


def _frequency_values(count: int, i: int) -> Iterator[tuple[Any, ...]]:
    """Ways to give distinct values to frequencies, in a fixed order."""
    base = [_FREQUENCIES[k % 10] + 310 * (k // 10) for k in range(count)]
    for chosen in islice(permutations(base), 120):
        yield tuple((mpmath.mpf(value) + i * (k % 3 + 1) / 4) / 8 for k, value in enumerate(chosen))


def _other_value(parameter: Parameter, k: int, i: int, order: int) -> Any:
    size = mpmath.mpf(2 * (k % 8) + 5 + i) / 32
    domain = domain_of(parameter)
    if domain == "nonnegative":  # damping, which could suppress the instability
        size /= 32
    if order:
        size = (size / 2) ** order if order == 1 else size**order / 2**order
    size = mpmath.mpf(mpmath.nint(size * 2**30)) / 2**30
    return -size if domain == "negative" else size


def _assignments(
    setting: Setting, parameters: Sequence[Parameter], i: int
) -> Iterator[dict[str, Any]]:
    scaled = setting.case.weak.scaled
    orders = {str(s.name): order for s, order in scaled.orders}
    known = {str(s.name) for s in scaled.frequencies}
    # What a frequency is made of is one itself if it has the unit of one and is not small.
    units = {p.unit for p in parameters if p.name in known} - {"1"}
    frequencies = [
        p
        for p in parameters
        if p.name in known
        or (p.unit in units and not orders.get(p.name) and domain_of(p) == "positive")
    ]
    others = [p for p in parameters if p not in frequencies]
    fixed = {p.name: _other_value(p, k, i, orders.get(p.name, 0)) for k, p in enumerate(others)}
    for values in _frequency_values(len(frequencies), i):
        yield fixed | {p.name: v for p, v in zip(frequencies, values, strict=True)}


def points_of(setting: Setting, functions: Sequence[EmittedFunction]) -> list[dict[str, Any]]:
    """Values of all parameters and amplitudes, inside and outside of the unstable interval."""
    kernel = next((k for f in functions if f.name == "boundaries" for k in f.kernels), None)
    known = {p.name for p in setting.parameters}
    more = {
        p.name: p
        for f in functions
        if f.name == "response"
        for p in f.arguments
        if p.name not in known
    }
    points = []
    for i in range(COUNT):
        point = _point(setting, kernel, i)
        point |= _further(setting, tuple(more.values()), i)
        points.append(point)
    return points


def _further(setting: Setting, parameters: Sequence[Parameter], i: int) -> dict[str, Any]:
    """Values of what only harmonics depend on, frequencies away from the others, and a time."""
    chosen = {p.name: (mpmath.mpf(419 + 58 * k) + i) / 8 for k, p in enumerate(parameters)}
    frequencies = {str(s.name) for s in setting.case.weak.scaled.frequencies}
    orders = {str(s.name): order for s, order in setting.case.weak.scaled.orders}
    for k, p in enumerate(parameters):
        if p.name not in frequencies:
            chosen[p.name] = _other_value(p, k, i, orders.get(p.name, 0))
    return {**chosen, TIME: mpmath.mpf(5 + 6 * i) / 16}


def _point(setting: Setting, kernel: Kernel | None, i: int) -> dict[str, Any]:
    plain = [p for p in setting.parameters if p not in setting.detunings]
    first: dict[str, Any] | None = None
    for values in _assignments(setting, plain, i):
        values |= {
            p.name: mpmath.mpf((-1) ** i * (2 * k + 3)) / 64
            for k, p in enumerate(setting.detunings)
        }
        values[AMPLITUDES] = _amplitudes(setting, i)
        if setting.flow.frame is None:
            values[str(setting.time.name)] = mpmath.mpf(i + 1)
        first = first or values
        if not _sensible(setting, values):
            continue
        if kernel is None:
            return values
        edges = boundary_values(setting, kernel, values_of(values, boundary_parameters(setting)))
        lower, upper = (edge.value for edge in edges)
        if mpmath.isfinite(lower) and mpmath.isfinite(upper) and lower < upper:
            sigma = lower + (upper - lower) * _INSIDE[i]
            values[setting.detunings[0].name] = mpmath.nint(sigma * 2**24) / 2**24
            return values
    assert first is not None
    return first


def _sensible(setting: Setting, values: dict[str, Any]) -> bool:
    """Resonant frequencies are positive."""
    for relation in setting.case.relations:
        symbols = relation.rhs.free_symbols
        if all(s.name in values for s in symbols):
            if relation.rhs.subs({s: values[s.name] for s in symbols}) <= 0:
                return False
    return True


def _amplitudes(setting: Setting, i: int) -> list[Any]:
    return [
        mpmath.mpc(mpmath.mpf(2 * k + 3 - i) / 8, mpmath.mpf((-1) ** k * (5 + i)) / 16)
        for k in range(len(setting.coordinates))
    ]


def speed_points_of(setting: Setting, function: EmittedFunction) -> list[dict[str, Any]]:
    """Points at which `critical_speeds` has both edges, where there are such points."""
    points = []
    for i in range(COUNT):
        first: dict[str, Any] | None = None
        chosen: dict[str, Any] | None = None
        for values in islice(_assignments(setting, function.arguments, i), 24):
            first = first or values
            if not function.kernels or function.reference is None:
                break
            found = function.reference(values)
            if found is not None and all(mpmath.isfinite(v) for v in found.values):
                chosen = values
                break
        point = chosen or first
        assert point is not None
        points.append(point)
    return points
