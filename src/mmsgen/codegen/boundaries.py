"""The emitted `boundaries`: both edges of the unstable interval of the first detuning."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import mpmath
import sympy as sp

from ..ir import compute_ir, fresh
from ..parameters import Parameter
from .exact import exact
from .kernels import EmittedFunction, Kernel, Reference
from .rounding import UNIT, Rounded, rounded
from .setting import Setting, values_of

__all__ = [
    "boundary_function",
    "boundary_kernel",
    "boundary_parameters",
    "boundary_values",
    "distance_to_edge",
]

EDGES = ("lower", "upper")


def boundary_parameters(setting: Setting) -> tuple[Parameter, ...]:
    """All parameters but the first detuning."""
    return setting.parameters[1:] if setting.detunings else setting.parameters


def boundary_kernel(setting: Setting) -> Kernel | None:
    """The formula of both edges; None for a case that cannot be unstable."""
    arguments = [p.symbol for p in boundary_parameters(setting)]
    names = [s.name for s in arguments]
    title = f"{setting.name}.boundaries"
    edges = setting.edges
    if edges == ():
        return None
    if edges is not None:
        keys = [fresh(edge, names) for edge in EDGES]
        ir = compute_ir(title, arguments, dict(zip(keys, edges, strict=True)))
        if setting.poles:
            return Kernel("_boundaries", ir, (("return defined", tuple(keys)),), uses=("defined",))
        return Kernel("_boundaries", ir, (("return ", tuple(keys)),))
    criterion = setting.criterion
    keys = [fresh(f"p{k}", names) for k in range(len(criterion))]
    ir = compute_ir(title, arguments, dict(zip(keys, criterion, strict=True)))
    return Kernel("_boundaries", ir, (("return zone", tuple(keys)),), uses=("zone",))


def boundary_function(setting: Setting) -> EmittedFunction:
    """The function `boundaries` of a case with a linear slow flow."""
    kernel = boundary_kernel(setting)
    arguments = boundary_parameters(setting)

    def reference(point: Mapping[str, Any]) -> Reference:
        own = values_of(point, arguments)
        pair = boundary_values(setting, kernel, own)
        return Reference(own, (2,), tuple(v.value for v in pair), tuple(v.error for v in pair))

    detuning = setting.detunings[0].name if setting.detunings else "a detuning"
    kernels = () if kernel is None else (kernel,)
    name = "no_edges" if kernel is None else "_boundaries"
    return EmittedFunction(
        name="boundaries",
        arguments=arguments,
        body=f"{{evaluate_pair}}({{{name}}}, {{arguments}})",
        returns="tuple[Any, Any]",
        summary=f"Both edges of the unstable interval of {detuning}.",
        description=_description(setting, kernel),
        result=(
            "lower, upper: in rad/s, float64, in the shape to which the arguments broadcast; NaN "
            "where there is no unstable interval."
        ),
        reference=reference,
        kernels=kernels,
        uses=("evaluate_pair", *(("no_edges",) if kernel is None else ())),
    )


def _description(setting: Setting, kernel: Kernel | None) -> str:
    if kernel is None:
        return "This case cannot be unstable for any detuning: NaN everywhere."
    if setting.edges is None:
        return (
            "The interval nearest to zero in which the polynomial with the coefficients p0, p1, … "
            "(lowest power first) is positive; infinite where the interval has no end."
        )
    text = "In closed form, expanded in the small parameters to the order of this case."
    powers = {power for edge in setting.edges for power in edge.atoms(sp.Pow)}
    below = {s for power in powers if power.exp.is_negative for s in power.base.free_symbols}
    vanishing = [p.name for p in setting.parameters if p.symbol in below and _may_vanish(p)]
    if vanishing:
        text += (
            f" No finite number where {' or '.join(vanishing)} is zero: what damping does as it "
            "vanishes depends on its distribution. Emit the undamped case for that."
        )
    return text


def _may_vanish(parameter: Parameter) -> bool:
    return not (parameter.symbol.is_positive or parameter.symbol.is_negative)


def boundary_values(
    setting: Setting, kernel: Kernel | None, arguments: Mapping[str, Any]
) -> tuple[Rounded, Rounded]:
    """Both edges from the symbolic result, with bounds of the error in double precision.

    Parameters
    ----------
    setting : Setting
    kernel : Kernel or None
        From `boundary_kernel`, for the bounds; None for a case without edges.
    arguments : mapping
        Name → number.
    """
    if kernel is None:
        nothing = Rounded(mpmath.nan, mpmath.mpf(0))
        return nothing, nothing
    errors = [own.error for own in rounded(kernel.ir, arguments).values()]
    edges = setting.edges
    if edges:
        values = [exact(edge, arguments) for edge in edges]
        lower, upper = map(Rounded, values, errors)
        return lower, upper
    return _zone(list(map(Rounded, _criterion_at(setting, arguments), errors)))


def _criterion_at(setting: Setting, arguments: Mapping[str, Any]) -> list[Any]:
    return [exact(c, arguments) for c in setting.criterion]


def distance_to_edge(setting: Setting, sigma: Any, arguments: Mapping[str, Any], edge: int) -> Any:
    """Zero exactly where the detuning is on an edge: its distance, or the criterion there.

    Parameters
    ----------
    setting : Setting
    sigma : mpmath.mpf
        The first detuning.
    arguments : mapping
        Those of `boundaries`.
    edge : int
        0 for the lower one, 1 for the upper one; a criterion does not tell them apart.
    """
    edges = setting.edges
    if edges:
        return sigma - exact(edges[edge], arguments)
    return mpmath.polyval(_criterion_at(setting, arguments)[::-1], sigma)


def _zone(polynomial: list[Rounded]) -> tuple[Rounded, Rounded]:
    """The interval nearest to zero in which a polynomial is positive."""
    values = [c.value for c in polynomial]
    roots = mpmath.polyroots(values[::-1], maxsteps=200, extraprec=200)
    noise = mpmath.mpf(10) ** (8 - mpmath.mp.dps) * max(map(abs, roots), default=mpmath.mpf(0))
    real = sorted(mpmath.re(z) for z in roots if abs(mpmath.im(z)) < noise)
    ends = [-mpmath.inf, *real, mpmath.inf]
    best = (mpmath.nan, mpmath.nan)
    distance = mpmath.inf
    for low, high in pairwise(ends):
        inside = _between(low, high)
        gap = max(low, -high, mpmath.mpf(0))
        if mpmath.polyval(values[::-1], inside) > 0 and gap < distance:
            best, distance = (low, high), gap
    lower, upper = (Rounded(x, _end_error(polynomial, x)) for x in best)
    return lower, upper


def _between(low: Any, high: Any) -> Any:
    if mpmath.isinf(low):
        return mpmath.mpf(0) if mpmath.isinf(high) else high - 1 - abs(high)
    return low + 1 + abs(low) if mpmath.isinf(high) else (low + high) / 2


def _end_error(polynomial: list[Rounded], x: Any) -> Any:
    """What errors of the coefficients, and Newton's last step, make of a root."""
    if not mpmath.isfinite(x):
        return mpmath.mpf(0)
    values = [c.value for c in polynomial]
    slope = abs(mpmath.fsum(k * c * x ** (k - 1) for k, c in enumerate(values) if k))
    own = mpmath.fsum(c.error * abs(x) ** k for k, c in enumerate(polynomial))
    steps = 2 * len(values) * UNIT * mpmath.fsum(abs(c * x**k) for k, c in enumerate(values))
    return (own + steps) / slope + 2 * UNIT * abs(x)
