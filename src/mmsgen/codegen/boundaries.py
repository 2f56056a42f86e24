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
from .kernels import EmittedFunction, Kernel, Reference, called
from .options import gradient_option, wanted
from .rounding import UNIT, Rounded, rounded
from .setting import Setting, values_of

__all__ = [
    "boundary_function",
    "boundary_kernel",
    "boundary_parameters",
    "boundary_values",
    "edge_values",
]

EDGES = ("lower", "upper")


def boundary_parameters(setting: Setting) -> tuple[Parameter, ...]:
    """All parameters but the first detuning."""
    return setting.parameters[1:] if setting.detunings else setting.parameters


def boundary_kernel(setting: Setting) -> Kernel | None:
    """The formula of both edges; None for a case that cannot be unstable."""
    arguments = [p.symbol for p in boundary_parameters(setting)]
    title = f"{setting.name}.boundaries"
    if not setting.criteria:
        return None
    outputs = _outputs(setting)
    ir = compute_ir(title, arguments, outputs)
    if setting.edges and not setting.poles:
        return Kernel("_boundaries", ir, (("return ", tuple(outputs)),))
    if setting.edges:
        return Kernel("_boundaries", ir, (("return defined", tuple(outputs)),), uses=("defined",))
    keys = iter(outputs)
    items = []
    for item in setting.criteria:
        texts = [_tuple([next(keys) for _ in polynomial]) for polynomial in item]
        items.append(texts[0] if len(texts) == 1 else _tuple(texts))
    items += [f"reach={key}" for key in keys]
    return Kernel("_boundaries", ir, (("return zone", tuple(items)),), uses=("zone",))


def _tuple(items: list[str]) -> str:
    return f"({items[0]},)" if len(items) == 1 else f"({', '.join(items)})"


def _outputs(setting: Setting) -> dict[str, sp.Expr]:
    """What the kernel computes: both edges, or the coefficients of the criteria; and the reach."""
    names = [p.name for p in boundary_parameters(setting)]
    outputs: dict[str, sp.Expr] = {}
    if setting.edges:
        outputs = {fresh(n, names): e for n, e in zip(EDGES, setting.edges, strict=True)}
    else:
        for i, item in enumerate(setting.criteria):
            for stem, polynomial in zip(("damping", "p")[-len(item) :], item, strict=True):
                number = f"{i + 1}_" if len(setting.criteria) > 1 else ""
                for k, e in enumerate(polynomial):
                    outputs[fresh(f"{stem}{number}{k}", names)] = e
    if setting.reach.is_finite:
        outputs[fresh("reach", names)] = setting.reach
    return outputs


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
    names = [p.name for p in arguments]
    gradient = gradient_option(names)
    items = ["{evaluate_pair}", f"{{{name}}}", "{arguments}"]
    items.append(wanted(names, gradient) if names else "()")
    return EmittedFunction(
        name="boundaries",
        arguments=arguments,
        body=called("{boundaries_at}", items),
        returns="Any",
        summary=f"Both edges of the unstable interval of {detuning}.",
        description=_description(setting, kernel),
        result=(
            "lower, upper: in rad/s, float64, in the shape to which the arguments broadcast; NaN "
            "where there is no unstable interval. With gradient this pair and name -> pair."
        ),
        reference=reference,
        kernels=kernels,
        uses=("boundaries_at", "evaluate_pair", *(("no_edges",) if kernel is None else ())),
        options=(gradient,) if names else (),
    )


def _description(setting: Setting, kernel: Kernel | None) -> str:
    if kernel is None:
        return "This case cannot be unstable for any detuning: NaN everywhere."
    detuning = setting.detunings[0].name if setting.detunings else "a detuning"
    if setting.edges:
        text = (
            "In closed form: the roots of a quadratic in it, between which growth_rate is positive."
        )
    else:
        text = (
            f"The interval of {detuning} in which growth_rate is positive: where one of the "
            "polynomials with the coefficients in `_boundaries` (lowest power first) is. Infinite "
            "where the interval has no end."
        )
    power = setting.case.order + 1
    text += (
        f" Order {setting.case.order} leaves out terms of the edges from ε^{power} on; by as much "
        "differs the formula of SlowFlow.boundary(), which is expanded in ε."
    )
    if setting.reach.is_finite:
        text += (
            " Of several intervals the one nearest to zero, and none that begins farther from it "
            f"than {setting.reach}, half of the frequencies that resonate; SlowFlow.zones() gives "
            "all of them."
        )
    else:
        text += " Of several intervals the one nearest to zero; SlowFlow.zones() gives all of them."
    return text


def edge_values(setting: Setting, arguments: Mapping[str, Any]) -> tuple[Any, Any]:
    """Both edges from the symbolic result, to the working precision of mpmath."""
    if setting.edges:
        lower, upper = (exact(edge, arguments) for edge in setting.edges)
        return lower, upper
    lower, upper, _ = _zone(_polynomials_at(setting, arguments), _reach_at(setting, arguments))
    return lower, upper


def boundary_values(
    setting: Setting, kernel: Kernel | None, arguments: Mapping[str, Any]
) -> tuple[Rounded, Rounded]:
    """Both edges, with bounds of the error in double precision.

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
    if setting.edges:
        lower, upper = map(Rounded, edge_values(setting, arguments), errors)
        return lower, upper
    polynomials = _polynomials_at(setting, arguments)
    low, high, breaks = _zone(polynomials, _reach_at(setting, arguments))
    counted = iter(errors)
    own: list[list[Any]] = []
    for item in setting.criteria:
        own += [[next(counted) for _ in polynomial] for polynomial in item][-1:]
    ends = []
    for x in (low, high):
        # The polynomial that has its root there.
        k = next((k for k, roots in enumerate(breaks) if x in roots), None)
        error = mpmath.mpf(0) if k is None else _end_error(polynomials[k], own[k], x)
        ends.append(Rounded(x, error))
    return ends[0], ends[1]


def _reach_at(setting: Setting, arguments: Mapping[str, Any]) -> Any:
    return exact(setting.reach, arguments) if setting.reach.is_finite else mpmath.inf


def _polynomials_at(setting: Setting, arguments: Mapping[str, Any]) -> list[list[Any]]:
    """The polynomials that count, at numbers, zero where another one decides."""
    result = []
    for item in setting.criteria:
        *first, values = ([exact(c, arguments) for c in polynomial] for polynomial in item)
        result.append([mpmath.mpf(0)] * len(values) if any(map(any, first)) else values)
    return result


def _zone(polynomials: list[list[Any]], reach: Any) -> tuple[Any, Any, list[list[Any]]]:
    """The interval nearest to zero in which a polynomial is positive, and where each has roots."""
    if not all(mpmath.isfinite(c) for p in polynomials for c in p):
        return mpmath.nan, mpmath.nan, []
    breaks = [_breaks(p) for p in polynomials]
    ends = [-mpmath.inf, *sorted({x for roots in breaks for x in roots}), mpmath.inf]
    zones: list[tuple[Any, Any]] = []
    for low, high in pairwise(ends):
        inside = _between(low, high)
        if any(mpmath.polyval(p[::-1], inside) > 0 for p in polynomials):
            if zones and zones[-1][1] == low:
                zones[-1] = zones[-1][0], high
            else:
                zones.append((low, high))

    def gap(zone: tuple[Any, Any]) -> Any:
        return max(zone[0], -zone[1], mpmath.mpf(0))

    zones = [zone for zone in zones if gap(zone) <= reach]
    return (*min(zones, key=gap, default=(mpmath.nan, mpmath.nan)), breaks)


def _breaks(polynomial: list[Any]) -> list[Any]:
    """Real parts of all roots: those of complex pairs separate nothing."""
    values = list(polynomial)
    while values and not values[-1]:
        values.pop()
    if len(values) < 2:
        return []
    roots = mpmath.polyroots(values[::-1], maxsteps=500, extraprec=200)
    return [mpmath.re(z) for z in roots]


def _between(low: Any, high: Any) -> Any:
    if mpmath.isinf(low):
        return mpmath.mpf(0) if mpmath.isinf(high) else high - 1 - abs(high)
    return low + 1 + abs(low) if mpmath.isinf(high) else (low + high) / 2


def _end_error(values: list[Any], errors: list[Any], x: Any) -> Any:
    """What errors of the coefficients, and Newton's last step, make of a root."""
    slope = abs(mpmath.fsum(k * c * x ** (k - 1) for k, c in enumerate(values) if k))
    own = mpmath.fsum(error * abs(x) ** k for k, error in enumerate(errors))
    steps = 2 * len(values) * UNIT * mpmath.fsum(abs(c * x**k) for k, c in enumerate(values))
    return (own + steps) / slope + 2 * UNIT * abs(x)
