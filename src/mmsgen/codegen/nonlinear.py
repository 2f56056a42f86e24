"""The emitted functions of nonlinear slow flows: stability, equilibria and their curves.

All of them share the table of the slow flow's terms, and the kernel that evaluates their
coefficients.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from ..errors import ExpansionError
from ..free_motion import free_part
from ..ir import compute_ir, fresh
from ..runtime._flow import Flow
from .curves import backbone_function, response_function
from .kernels import AMPLITUDES, Constant, EmittedFunction, Kernel, Option, Reference, called
from .nonlinear_values import (
    MOST,
    ExactFlow,
    Formulas,
    eigenvalues,
    equilibrium_values,
    jacobian_values,
)
from .numpy_target import LINE_LENGTH, wrapped
from .options import gradient_option, wanted
from .setting import Setting, values_of

__all__ = ["COEFFICIENTS", "TABLE", "flow_functions"]

TABLE, COEFFICIENTS = "_FLOW", "_coefficients"
"""Names of the table and of the kernel in emitted modules."""


def flow_functions(setting: Setting) -> tuple[EmittedFunction, ...]:
    """What is emitted for an autonomous nonlinear slow flow besides its right-hand side."""
    kernel, out = _kernel(setting)
    formulas = Formulas(setting, kernel, out)
    first, *others = (
        _equilibria_function(setting, formulas),
        _jacobian_function(setting, formulas),
        _stability_function(setting, formulas),
    )
    curves = (
        response_function(setting, TABLE, COEFFICIENTS),
        backbone_function(setting),
        _modes_function(setting),
    )
    held = replace(first, kernels=(kernel,), constants=(_constant(setting.flow.table.flow, TABLE),))
    return (held, *(f for f in curves if f is not None), *others)


def _kernel(setting: Setting) -> tuple[Kernel, str]:
    """The kernel of all coefficients, and how it calls its output."""
    out = fresh("out", [p.name for p in setting.parameters])
    table = setting.flow.table
    outputs = {f"{out}[..., {m}]": c for m, c in enumerate(table.coefficients) if c != 0}
    symbols = [p.symbol for p in setting.parameters]
    ir = compute_ir(f"{setting.name}.coefficients", symbols, outputs)
    return Kernel(COEFFICIENTS, ir, leading=(out,)), out


def _constant(
    flow: Flow, name: str, comment: str = "terms of the slow flow: equation, powers of B, B̄, |B|"
) -> Constant:
    n, terms, symmetries = flow
    inner = "\n".join(wrapped([str(term) for term in terms], 8))
    circles = str(symmetries)
    if len(circles) > LINE_LENGTH - 5:
        circles = "(\n" + "\n".join(wrapped([str(k) for k in symmetries], 8)) + "\n    )"
    items = (str(n), f"(\n{inner}\n    )", circles)
    return Constant(name, "Flow", items, comment)


def _leading(setting: Setting) -> tuple[tuple[str, str], ...]:
    n = len(setting.coordinates)
    name = fresh("amplitudes", [p.name for p in setting.parameters])
    return ((name, f"Shape (..., {n}), in the order of COORDINATES; NaN gives NaN."),)


def _equilibria_function(setting: Setting, formulas: Formulas) -> EmittedFunction:
    names, n = [p.name for p in setting.parameters], len(setting.coordinates)
    gradient = gradient_option(names)
    solver = "equilibria_of_one" if n == 1 else "equilibria_of_many"
    items = [f"{{{solver}}}", f"{{{TABLE}}}", f"{{{COEFFICIENTS}}}", "{arguments}"]
    items.append(wanted(names, gradient))
    symmetries = setting.flow.table.flow.symmetries
    text = (
        "Amplitudes B_j = (a_j/2) exp(iγ_j) that stay at rest in the frame of `slow_flow`, as many "
        "as there are, those that are missing at a point NaN."
    )
    if symmetries:
        text += (
            " B_j exp(i k_j θ) moves along a circle of further ones for k = "
            f"{', '.join(map(str, symmetries))}; of each circle one point is given, and the rate "
            "at which it drifts, B_j exp(i k_j ρ t)."
        )

    def reference(point: Mapping[str, Any]) -> Reference | None:
        own = values_of(point, setting.parameters)
        found = equilibrium_values(ExactFlow(formulas, own))
        return None if found is None else Reference(own, *found)

    return EmittedFunction(
        name="equilibria",
        arguments=setting.parameters,
        body=called("{equilibria_at}", items),
        returns="Any",
        summary="All equilibria of the slow flow, with their stability.",
        description=text,
        result=(
            f"The arrays amplitudes (..., count, {n}), drift (..., count, {len(symmetries)}) in "
            "rad/s and growth (..., count) in 1/s, which is negative where an equilibrium is "
            "stable. With gradient also name -> derivatives of amplitudes, drift and growth, NaN "
            "where equilibria meet."
        ),
        reference=reference if n <= MOST else None,
        uses=("equilibria_at", solver),
        options=(gradient,),
        kind="Equilibria",
    )


def _modes_function(setting: Setting) -> EmittedFunction | None:
    """The function `backbone` of a case with several amplitudes; None where there is none."""
    if len(setting.coordinates) == 1:
        return None
    try:
        free = free_part(setting.flow)
    except ExpansionError:
        return None
    arguments = tuple(p for p in setting.parameters if p.symbol not in free.forced)
    names, n, flow = [p.name for p in arguments], len(setting.coordinates), free.table.flow
    out = fresh("out", names)
    values = (*free.table.coefficients, *free.frame)
    outputs = {f"{out}[..., {m}]": c for m, c in enumerate(values) if c != 0}
    ir = compute_ir(f"{setting.name}.backbone", [p.symbol for p in arguments], outputs)
    leading, of = fresh("amplitude", names), fresh("of", names)
    pull = f"({', '.join(str(float(x)) for x in free.pull)})"
    items = ["{_FREE}", pull, "{_backbone}", "{arguments}", leading, "COORDINATES", of]
    first = setting.coordinates[0]
    return EmittedFunction(
        name="backbone",
        arguments=arguments,
        body=called("{modes_at}", items),
        returns="Any",
        summary="Free motions without damping in which one coordinate has a given amplitude.",
        description=(
            "All periodic ones: normal modes, whose frequencies over the amplitude are the "
            "backbone curves of the responses. Forces and damping are left out."
        ),
        result=(
            f"The arrays amplitudes (..., count, {n}), shift (..., count, {n}) of the frequency "
            "of each coordinate in rad/s, detuning (..., count) of a force at that frequency in "
            "rad/s, and growth (..., count) in 1/s, zero where a motion is stable; NaN where there "
            "are fewer."
        ),
        reference=None,
        kernels=(Kernel("_backbone", ir, leading=(out,)),),
        constants=(_constant(flow, "_FREE", "terms of free motions without damping"),),
        uses=("modes_at",),
        leading=((leading, "a = 2|B|, the amplitude of the fundamental harmonic, >= 0."),),
        options=(Option(of, "str", f'"{first}"', "str, optional", "That coordinate."),),
        kind="Backbone",
    )


def _at_amplitudes(setting: Setting, amplitudes: str) -> tuple[list[str], tuple[Option, ...]]:
    """What a function of given amplitudes is made of, and its keywords."""
    names = [p.name for p in setting.parameters]
    items = [f"{{{TABLE}}}", f"{{{COEFFICIENTS}}}", "{arguments}", amplitudes]
    if not names:
        return items, ()
    gradient = gradient_option(names)
    return [*items, wanted(names, gradient)], (gradient,)


_FIXED = "; with gradient this and name -> derivatives, the amplitudes fixed."


def _jacobian_function(setting: Setting, formulas: Formulas) -> EmittedFunction:
    n, leading = len(setting.coordinates), _leading(setting)
    items, options = _at_amplitudes(setting, leading[0][0])
    free = bool(setting.flow.table.flow.symmetries)

    def reference(point: Mapping[str, Any]) -> Reference:
        own, given = values_of(point, setting.parameters), tuple(point[AMPLITUDES])
        values, errors = jacobian_values(ExactFlow(formulas, own), given)
        return Reference(own, (2 * n, 2 * n), values, errors, given)

    return EmittedFunction(
        name="jacobian",
        arguments=setting.parameters,
        body=called("{jacobian_at}", items),
        returns="Any",
        summary="Derivatives of the Cartesian slow flow, B_j = (u_j + i v_j)/2.",
        description="In the frame of `slow_flow`" + (_DRIFTING if free else "") + ".",
        result=f"Shape (..., {2 * n}, {2 * n}), in 1/s, rows and columns u_1, v_1, u_2, …"
        + (_FIXED if options else "."),
        reference=reference,
        uses=("jacobian_at",),
        leading=leading,
        options=options,
        kind="float64",
    )


_DRIFTING = (
    ", turned along its symmetries so that the amplitudes given drift as little as they can; an "
    "equilibrium then is at rest"
)


def _stability_function(setting: Setting, formulas: Formulas) -> EmittedFunction:
    n, leading = len(setting.coordinates), _leading(setting)
    items, options = _at_amplitudes(setting, leading[0][0])
    text = "Small disturbances of an equilibrium grow like exp(Γ t)."
    if setting.flow.table.flow.symmetries:
        text += " Each symmetry that moves the point has a zero, which is left out."

    def reference(point: Mapping[str, Any]) -> Reference | None:
        own, given = values_of(point, setting.parameters), tuple(point[AMPLITUDES])
        found = eigenvalues(ExactFlow(formulas, own), given)
        return None if found is None else Reference(own, (2 * n,), *found, given)

    return EmittedFunction(
        name="stability",
        arguments=setting.parameters,
        body=called("{stability_at}", items),
        returns="Any",
        summary="Eigenvalues Γ of the Jacobian, the largest real part first.",
        description=text,
        result=f"Shape (..., {2 * n}), in 1/s; NaN at the end for those that are left out"
        + (
            _FIXED.replace("amplitudes fixed", "amplitudes fixed; NaN where eigenvalues meet")
            if options
            else "."
        ),
        reference=reference,
        uses=("stability_at",),
        leading=leading,
        options=options,
        kind="complex128",
    )
