"""The emitted `response`: coordinates at times, with all their harmonics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce
from operator import mul
from typing import Any

import mpmath
import sympy as sp

from ..errors import EmissionError
from ..ir import compute_ir, fresh
from ..parameters import Parameter
from ..symbols import coordinate_name
from ..uniform import UniformMotion, UniformTerm, uniform_motion
from .exact import exact
from .kernels import AMPLITUDES, TIME, Constant, EmittedFunction, Kernel, Option, Reference, called
from .naming import check_parameter_names
from .numpy_target import wrapped
from .options import gradient_option, wanted
from .rounding import UNIT, Rounded, rounded
from .setting import Setting, values_of

__all__ = ["motion_function", "motion_parameters"]


def motion_parameters(setting: Setting, motion: UniformMotion) -> tuple[Parameter, ...]:
    """Those of the slow flow, then what the harmonics depend on besides."""
    present: set[sp.Symbol] = set().union(*(term.coefficient.free_symbols for term in motion.terms))
    present |= set().union(*(f.free_symbols for f in motion.frequencies))
    known = {p.symbol for p in setting.parameters}
    others = tuple(p for p in setting.case.parameters if p.symbol in present - known)
    missing = present - known - {p.symbol for p in others}
    if missing:
        raise EmissionError(
            f"{setting.name}: the harmonics contain {', '.join(sorted(map(str, missing)))}, which "
            "is not a parameter: declare it as a parameter of the model"
        )
    check_parameter_names(p.name for p in others)
    return (*setting.parameters, *others)


def motion_function(setting: Setting, slow: tuple[str, str] | None) -> EmittedFunction:
    """The function `response` of a case.

    Parameters
    ----------
    setting : Setting
    slow : (str, str), optional
        The names of the constant that holds the terms of a nonlinear slow flow, and of the kernel
        of its coefficients.
    """
    motion = uniform_motion(setting.case)
    arguments = motion_parameters(setting, motion)
    names = [p.name for p in arguments]
    kernel, numbered = _kernel(setting, motion, arguments)
    t, amplitudes = fresh("t", names), fresh("amplitudes", names)
    order, drift = fresh("order", names), fresh("drift", names)
    gradient = gradient_option(names)
    free = () if slow is None else setting.flow.table.flow.symmetries
    top = max(term.order for term in motion.terms)
    options = (_order_option(order, top), *((_drift_option(drift, len(free)),) if free else ()))
    items = ["{_MOTION}", "{_motion}", "{arguments}", t, amplitudes, f"order={order}"]
    items += [f"drift={drift}"] if free else []
    if slow is not None:
        items.append(f"slow=({{{slow[0]}}}, {{{slow[1]}}}, {len(setting.parameters)})")
    items.append(wanted(names, gradient, "names="))
    n = motion.n

    def reference(point: Mapping[str, Any]) -> Reference:
        own = values_of(point, arguments)
        values, errors = _values(motion, kernel, numbered, own, point[TIME], point[AMPLITUDES])
        return Reference(own, (n,), values, errors, tuple(point[AMPLITUDES]), {"time": point[TIME]})

    return EmittedFunction(
        name="response",
        arguments=arguments,
        body=called("{response_at}", items),
        returns="Any",
        summary="Coordinates at times: the uniform approximation with all its harmonics.",
        description=_description(setting, bool(free)),
        result=f"Shape (..., {n}), in the order {', '.join(_coordinates(setting))}; with gradient "
        "this and name -> array.",
        reference=reference,
        kernels=(kernel,),
        uses=("response_at",),
        leading=(
            (t, "Times, s; they broadcast with the other arguments."),
            (amplitudes, f"Shape (..., {n}), in the order of COORDINATES; NaN gives NaN."),
        ),
        options=(*options, gradient),
        constants=(_constant(motion),),
        kind="float64",
    )


def _coordinates(setting: Setting) -> tuple[str, ...]:
    return tuple(coordinate_name(q) for q in setting.case.weak.scaled.eom.coordinates)


def _order_option(name: str, top: int) -> Option:
    return Option(
        name,
        "int | None",
        "None",
        "int, optional",
        f"The highest power of ε of the harmonics that are summed, 0 to {top}; all by default.",
    )


def _drift_option(name: str, count: int) -> Option:
    return Option(
        name,
        "ArrayLike | None",
        "None",
        "array_like, optional",
        f"Of an equilibrium that drifts, shape (..., {count}), rad/s: as `equilibria` gives it.",
    )


def _description(setting: Setting, drifts: bool) -> str:
    still = setting.flow.frame is not None
    text = (
        "Amplitudes in the frame A_j = B_j exp(i λ_j t), λ in FRAME, at the times given: constant "
        "ones at an equilibrium, or a solution of slow_flow."
        if still
        else "Amplitudes A_j at the times given: a solution of slow_flow."
    )
    if drifts:
        text += " With a drift, constant ones turn along the symmetries of the slow flow."
    return (
        f"{text} NaN where a harmonic resonates itself. Derivatives are taken with these fixed. "
        f"Over times of order 1/ε the error is O(ε^{setting.case.order}). A UserWarning says how "
        "much is left out where that is more than a tenth of the motion, estimated from the "
        "harmonics of each order beside those of order zero"
        + (", and from the terms of the slow flow." if not setting.linear else ".")
    )


# --- the table and its coefficients ---------------------------------------------------------------


def _constant(motion: UniformMotion) -> Constant:
    rows = [f"({t.order}, {t.coordinate}, {t.exponents}, {t.harmonics})" for t in motion.terms]
    inner = "\n".join(wrapped(rows, 8))
    items = (f"{motion.n}", f"(\n{inner}\n    )", f"{len(motion.frequencies) - motion.n}")
    return Constant("_MOTION", "Motion", items, "harmonics: order, coordinate, powers, multiples")


def _kernel(
    setting: Setting, motion: UniformMotion, arguments: Sequence[Parameter]
) -> tuple[Kernel, str]:
    """The kernel that fills the coefficients, then the frequencies; and how it calls its output."""
    out = fresh("out", [p.name for p in arguments])
    formulas = [*(term.coefficient for term in motion.terms), *motion.frequencies]
    outputs = {f"{out}[..., {m}]": e for m, e in enumerate(formulas) if e != 0}
    ir = compute_ir(f"{setting.name}.response", [p.symbol for p in arguments], outputs)
    return Kernel("_motion", ir, leading=(out,)), out


def _values(
    motion: UniformMotion,
    kernel: Kernel,
    out: str,
    own: Mapping[str, Any],
    t: Any,
    amplitudes: Sequence[Any],
) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    """The coordinates at a point to the working precision, and what rounding makes of them."""
    inner = rounded(kernel.ir, own)
    rates = [exact(f, own) for f in motion.frequencies]
    bounds = [mpmath.mpf(0)] * motion.n
    values = [mpmath.mpf(0)] * motion.n
    for m, term in enumerate(motion.terms):
        c = exact(term.coefficient, own)
        monomial = _monomial(term, amplitudes)
        theta = mpmath.fdot(_multiples(term), rates)
        values[term.coordinate] += mpmath.re(c * monomial * mpmath.expj(theta * t))
        bounds[term.coordinate] += _bound(motion, term, m, inner, out, t, amplitudes)
    # The sum itself: as many additions as terms, none larger than the sum of their moduli.
    return tuple(values), tuple(b * (1 + len(motion.terms) * UNIT) for b in bounds)


def _monomial(term: UniformTerm, amplitudes: Sequence[Any]) -> Any:
    parts = []
    for k, b in enumerate(amplitudes):
        r, s, power = term.exponents[3 * k : 3 * k + 3]
        parts.append(b**r * mpmath.conj(b) ** s * abs(b) ** power)
    return mpmath.fprod(parts)


def _multiples(term: UniformTerm) -> list[int]:
    pairs = zip(term.exponents[::3], term.exponents[1::3], strict=True)
    return [*(r - s for r, s in pairs), *term.harmonics]


def _bound(
    motion: UniformMotion,
    term: UniformTerm,
    m: int,
    inner: Mapping[str, Rounded],
    out: str,
    t: Any,
    amplitudes: Sequence[Any],
) -> Any:
    """What rounding makes of one term, with the additions that it takes part in."""
    zero = Rounded(mpmath.mpf(0), mpmath.mpf(0))
    time = Rounded(mpmath.mpf(t), mpmath.mpf(0))
    turns = []
    for k in range(len(motion.frequencies)):
        angle = inner.get(f"{out}[..., {len(motion.terms) + k}]", zero) * time
        turns.append(Rounded(mpmath.expj(angle.value), angle.error + 4 * UNIT))
    factors = [inner.get(f"{out}[..., {m}]", zero)]
    for k, b in enumerate(amplitudes):
        moving = Rounded(mpmath.mpc(b), mpmath.mpf(0)) * turns[k]
        factors += [moving] * sum(term.exponents[3 * k : 3 * k + 3])
    for h, turn in zip(term.harmonics, turns[motion.n :], strict=True):
        factors += [turn] * abs(h)
    product = reduce(mul, factors)
    return product.error + len(motion.terms) * UNIT * abs(product.value)
