"""The emitted `frequency_response` and `backbone`: equilibria as curves."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath
import sympy as sp

from ..errors import ExpansionError
from ..ir import compute_ir, fresh
from ..parameters import Parameter
from ..symbols import modulus
from .exact import exact
from .kernels import AMPLITUDES, EmittedFunction, Kernel, Option, Reference, called
from .options import gradient_option, wanted
from .rounding import rounded
from .setting import Setting, values_of

__all__ = ["backbone_function", "response_function"]


def response_function(setting: Setting, table: str, coefficients: str) -> EmittedFunction | None:
    """The function `frequency_response`; None where there is no parameter to vary.

    Parameters
    ----------
    setting : Setting
    table, coefficients : str
        Names of the constant with the slow flow's terms, and of the kernel of their coefficients.
    """
    if not setting.parameters:
        return None
    names = [p.name for p in setting.parameters]
    over, gradient = fresh("over", names), gradient_option(names)
    items = [f"{{{table}}}", f"{{{coefficients}}}", "{arguments}"]
    items += [wanted(names), over, gradient.name]
    return EmittedFunction(
        name="frequency_response",
        arguments=setting.parameters,
        body=called("{response_along}", items),
        returns="Any",
        summary="All equilibria along one parameter, as branches with their bifurcations.",
        description=(
            "One parameter is an array of one dimension, the others are numbers. Each branch has "
            "its points in their order along the curve, through folds."
        ),
        result=(
            "Its name, branches (parameter, amplitudes, drift, growth) and bifurcations "
            "(saddle-nodes, pitchforks, transcritical and Hopf points). With gradient also name -> "
            "derivatives of the branches (amplitudes, drift, growth; NaN where they meet) and of "
            "the values at which the bifurcations lie."
        ),
        reference=None,
        uses=("response_along",),
        options=(
            Option(over, "str", f'"{names[0]}"', "str, optional", "Name of the one that varies."),
            gradient,
        ),
        kind="Response",
    )


def backbone_function(setting: Setting) -> EmittedFunction | None:
    """The function `backbone` of a case with one amplitude; None where there is no such curve."""
    if len(setting.coordinates) != 1:
        return None
    try:
        found = setting.flow.backbone()
    except ExpansionError:
        return None
    if len(found) != 1:
        return None
    ((unknown, formula),) = found.items()
    detunings = [p for p in setting.detunings if p.symbol == unknown]
    arguments = tuple(p for p in setting.parameters if p not in detunings)
    kernel, amplitude, out = _kernel(setting, formula, arguments)
    names = [p.name for p in arguments]
    leading, gradient = fresh("amplitude", names), gradient_option(names)
    items = ["{_backbone}", leading, "{arguments}", wanted(names, gradient) if names else "()"]

    def reference(point: Mapping[str, Any]) -> Reference:
        own, a = values_of(point, arguments), 2 * abs(point[AMPLITUDES][0].real)
        value = exact(formula, {**own, str(modulus(setting.case.coordinates[0]).name): a})
        bound = rounded(kernel.ir, {**own, amplitude: a})[out].error
        return Reference(own, (), (value,), (bound,), first={"amplitude": mpmath.mpf(a)})

    what = f"The detuning {detunings[0].name}" if detunings else "The shift of the frequency"
    return EmittedFunction(
        name="backbone",
        arguments=arguments,
        body=called("{backbone_at}", items),
        returns="Any",
        summary=f"{what} on the backbone curve.",
        description=(
            "Where the conservative part of the slow flow that no phase enters is at rest; free "
            "motions without damping lie on it, and the responses of weakly damped ones close by."
        ),
        result="In rad/s, float64; with gradient this and name -> derivative.",
        reference=reference,
        kernels=(kernel,),
        uses=("backbone_at",),
        leading=((leading, "a = 2|B|, the amplitude of the fundamental harmonic, >= 0."),),
        options=(gradient,) if names else (),
    )


def _kernel(
    setting: Setting, formula: sp.Expr, arguments: tuple[Parameter, ...]
) -> tuple[Kernel, str, str]:
    """The kernel, and what the amplitude and the output are called in it."""
    names = [p.name for p in arguments]
    own = modulus(setting.case.coordinates[0])
    amplitude = sp.Symbol(fresh(str(own.name), names), nonnegative=True)
    out = fresh("rate", [*names, amplitude.name])
    symbols = [amplitude, *(p.symbol for p in arguments)]
    outputs = {out: formula.xreplace({own: amplitude})}
    ir = compute_ir(f"{setting.name}.backbone", symbols, outputs)
    return Kernel("_backbone", ir, (("return ", (out,)),)), str(amplitude.name), out
