"""Reference values of `critical_speeds`: the implicit equation solved in high precision."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mpmath
import sympy as sp

from ..ir import IR
from .boundaries import boundary_values, edge_values
from .exact import exact
from .kernels import Kernel
from .rounding import UNIT, Rounded, rounded
from .setting import Setting

__all__ = ["speed_values"]


def speed_values(
    setting: Setting,
    outputs: Mapping[str, sp.Expr],
    unknown: sp.Symbol,
    ir: IR,
    boundary: Kernel,
    arguments: Mapping[str, Any],
) -> tuple[Rounded, Rounded]:
    """Both edges in the detuned frequency, with bounds of the error in double precision.

    Parameters
    ----------
    setting : Setting
    outputs : mapping
        The first detuning and then the arguments of `boundaries`, as functions of the frequency.
    unknown : sympy.Symbol
        The frequency.
    ir : IR
        What the emitted code evaluates for them: for the bounds alone.
    boundary : Kernel
    arguments : mapping
        Name → number.
    """
    sigma, *rest = outputs

    def at(speed: Any) -> dict[str, Any]:
        values = {**arguments, unknown.name: speed}
        return {name: exact(e, values) for name, e in outputs.items()}

    nothing = Rounded(mpmath.nan, mpmath.mpf(0))
    centre = _smallest_root(lambda speed: exact(outputs[sigma], {**arguments, unknown.name: speed}))
    if centre is None:
        return nothing, nothing
    found = at(centre)
    edges = boundary_values(setting, boundary, {name: found[name] for name in rest})
    slope = _slope(lambda speed: at(speed)[sigma], centre)
    result = []
    for k, edge in enumerate(edges):
        if not mpmath.isfinite(edge.value):
            result.append(nothing)
            continue
        first = centre + edge.value / slope
        second = first + (first - centre) / 1024
        root = mpmath.findroot(
            lambda speed, k=k: _gap(setting, at(speed), k),
            (first, second),
            solver="secant",
            verify=False,
        )
        result.append(_bounded(setting, ir, boundary, at, arguments, root, k))
    return result[0], result[1]


def _bounded(
    setting: Setting,
    ir: IR,
    boundary: Kernel,
    at: Callable[[Any], dict[str, Any]],
    arguments: Mapping[str, Any],
    root: Any,
    k: int,
) -> Rounded:
    """A root with the bound of its error; NaN where it is not one, or not positive."""
    (_, first), *rest = at(root).items()
    edge = boundary_values(setting, boundary, dict(rest))[k]
    tolerance = mpmath.mpf(10) ** (10 - mpmath.mp.dps) * abs(root)
    if not (root > 0 and abs(edge.value - first) < tolerance):
        return Rounded(mpmath.nan, mpmath.mpf(0))
    # How the gap between detuning and edge depends on the frequency.
    total = _slope(lambda x: _gap(setting, at(x), k), root)
    slope = abs(total)
    names = {} if len(ir.arguments) == len(arguments) else {ir.arguments[0].name: root}
    inner = rounded(ir, {**arguments, **names})
    # An error of the frequencies goes into the detuning as it is, and through the boundary, which
    # depends on them more weakly, at most once more.
    own = 2 * mpmath.fsum(r.error for r in inner.values())
    size = own + edge.error + UNIT * (abs(first) + abs(root))
    return Rounded(root, size / slope + 2 * UNIT * abs(root))


def _gap(setting: Setting, outputs: dict[str, Any], k: int) -> Any:
    (_, sigma), *rest = outputs.items()
    return sigma - edge_values(setting, dict(rest))[k]


def _slope(function: Callable[[Any], Any], x: Any) -> Any:
    """A derivative to a third of the digits, which bounds and first steps need."""
    h = abs(x) * mpmath.mpf(10) ** (-mpmath.mp.dps // 3)
    return (function(x + h) - function(x - h)) / (2 * h)


def _smallest_root(function: Callable[[Any], Any]) -> Any:
    """The smallest positive root, by the change of sign."""
    scale = abs(function(mpmath.mpf(0))) or mpmath.mpf(1)
    x = scale / 512
    value = function(x)
    for _ in range(72):
        following = x * mpmath.mpf("1.189")
        other = function(following)
        if value * other <= 0:
            return mpmath.findroot(function, (x, following), solver="anderson")
        x, value = following, other
    return None
