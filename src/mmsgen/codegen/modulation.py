"""The emitted `slow_flow`: the right-hand side of the modulation equations, linear or not."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from ..ir import compute_ir, fresh
from ..parameters import Parameter
from .exact import exact
from .kernels import AMPLITUDES, EmittedFunction, Kernel, Reference
from .rounding import rounded
from .setting import Setting, values_of

__all__ = ["modulation_function"]


def modulation_function(setting: Setting) -> EmittedFunction:
    """The function `slow_flow` of a case."""
    case = setting.case
    still = setting.flow.frame is not None
    arguments = setting.parameters
    if not still:
        arguments = (*arguments, Parameter(setting.time, "s", "time"))
    names = [p.name for p in arguments]
    out = fresh("out", names)
    columns, outputs = _columns(setting, names, out)
    symbols = [*columns.values(), *(p.symbol for p in arguments)]
    ir = compute_ir(f"{setting.name}.slow_flow", symbols, outputs)
    n = len(case.amplitudes)
    amplitudes = fresh("amplitudes", names)

    def reference(point: Mapping[str, Any]) -> Reference:
        own = values_of(point, arguments)
        given = dict(zip((a.name for a in case.amplitudes), point[AMPLITUDES], strict=True))
        inner = rounded(ir, {**own, **_for_columns(columns, given)})
        values = [exact(rate, {**own, **given}) for rate in setting.rates.values()]
        errors = [inner[key].error if key in inner else 0 for key in _keys(out, n)]
        return Reference(own, (n,), tuple(values), tuple(errors), tuple(given.values()))

    frame = (
        "In the frame A_j = B_j exp(i λ_j t) that makes the slow flow autonomous, λ in FRAME."
        if still
        else "No frame makes this slow flow autonomous: these are dA/dt at the time given."
    )
    inputs = f"{{checked_amplitudes}}({amplitudes}, {n})"
    return EmittedFunction(
        name="slow_flow",
        arguments=arguments,
        body=f"{{evaluate_array}}({{_slow_flow}}, [*{inputs}, *{{arguments}}], ({n},))",
        returns="NDArray[np.complex128]",
        summary="Right-hand side of the modulation equations: the time derivative of amplitudes.",
        description=frame,
        result=f"Shape (..., {n}), complex128, in the unit of the amplitudes per second.",
        reference=reference,
        kernels=(Kernel("_slow_flow", ir, leading=(out,)),),
        uses=("checked_amplitudes", "evaluate_array"),
        leading=((amplitudes, f"Shape (..., {n}), in the order of COORDINATES."),),
    )


def _keys(out: str, n: int) -> list[str]:
    return [f"{out}[..., {j}]" for j in range(n)]


def _columns(
    setting: Setting, names: list[str], out: str
) -> tuple[dict[sp.Symbol, sp.Symbol], dict[str, sp.Expr]]:
    """A symbol of its own for each amplitude, and the outputs in terms of these."""
    columns = {
        a: sp.Symbol(fresh(a.name, [*names, out]), complex=True) for a in setting.case.amplitudes
    }
    outputs = {}
    for key, rate in zip(_keys(out, len(columns)), setting.rates.values(), strict=True):
        if rate != 0:
            outputs[key] = rate.xreplace(columns)
    return columns, outputs


def _for_columns(
    columns: Mapping[sp.Symbol, sp.Symbol], given: Mapping[str, Any]
) -> dict[str, Any]:
    return {column.name: given[a.name] for a, column in columns.items()}
