"""The emitted `slow_flow_matrix` and `characteristic_coefficients`."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from typing import Any

import mpmath
import sympy as sp

from ..field import Coefficient
from ..ir import IR, compute_ir, fresh
from .exact import exact
from .kernels import EmittedFunction, Kernel, Reference
from .rounding import Rounded, rounded
from .setting import Setting, values_of

__all__ = ["characteristic_function", "matrix_function"]


def matrix_function(setting: Setting) -> EmittedFunction:
    """The function `slow_flow_matrix` of a case with a linear slow flow."""
    linear = setting.linear
    assert linear is not None
    symbols = [p.symbol for p in setting.parameters]
    out = fresh("out", [p.name for p in setting.parameters])
    outputs: dict[str, sp.Expr] = {}
    entries: dict[tuple[int, int], Coefficient] = {}
    n = 0
    for block in linear.blocks:
        size = range(len(block.nodes))
        entries |= {(n + i, n + j): block.entries[i][j] for i, j in product(size, repeat=2)}
        n += len(block.nodes)
    for (i, j), c in entries.items():
        for part, value in zip(("real", "imag"), setting.parts(c), strict=True):
            if value != 0:
                outputs[f"{out}[..., {i}, {j}].{part}"] = value
    ir = compute_ir(f"{setting.name}.slow_flow_matrix", symbols, outputs)

    def reference(point: Mapping[str, Any]) -> Reference:
        arguments = values_of(point, setting.parameters)
        inner = rounded(ir, arguments)
        values, errors = [], []
        for i, j in product(range(n), repeat=2):
            values.append(
                exact(setting.shown(entries[i, j]), arguments) if (i, j) in entries else 0
            )
            parts = (inner.get(f"{out}[..., {i}, {j}].{part}") for part in ("real", "imag"))
            errors.append(mpmath.fsum(p.error for p in parts if p is not None))
        return Reference(arguments, (n, n), tuple(values), tuple(errors))

    return EmittedFunction(
        name="slow_flow_matrix",
        arguments=setting.parameters,
        body=f"{{evaluate_array}}({{_slow_flow_matrix}}, {{arguments}}, ({n}, {n}))",
        returns="NDArray[np.complex128]",
        summary="The matrix S of the slow flow dB/dt = S B in the frame that makes it autonomous.",
        description="Rows and columns in the order of VARIABLES.",
        result=f"Shape (..., {n}, {n}), complex128, in 1/s.",
        reference=reference,
        kernels=(Kernel("_slow_flow_matrix", ir, leading=(out,)),),
        uses=("evaluate_array",),
    )


def characteristic_function(setting: Setting) -> EmittedFunction:
    """The function `characteristic_coefficients` of a case with a linear slow flow."""
    linear = setting.linear
    assert linear is not None
    names = [p.name for p in setting.parameters]
    out = fresh("out", names)
    outputs: dict[str, sp.Expr] = {}
    factors, plan = [], []
    for number, factor in enumerate(linear.factors, 1):
        texts, keys = [], []
        for k in range(factor.degree - 1, -1, -1):
            re, im = setting.parts(factor.coefficients[k])
            if re == 0 and im == 0:
                texts.append("0.0")
                keys.append("")
                continue
            keys.append(fresh(f"c{number}_{k}", names))
            outputs[keys[-1]] = re + sp.I * im
            texts.append(keys[-1])
        inner = f"({texts[0]},)" if len(texts) == 1 else f"({', '.join(texts)})"
        factors.append(f"({inner}, {factor.multiplicity})")
        plan.append((keys, factor.multiplicity))
    n = sum(len(keys) * multiplicity for keys, multiplicity in plan)
    symbols = [p.symbol for p in setting.parameters]
    ir = compute_ir(f"{setting.name}.characteristic_coefficients", symbols, outputs)
    closing = (("multiply_out", (out, *factors)),)
    kernel = Kernel("_characteristic_coefficients", ir, closing, (out,), ("multiply_out",))

    def reference(point: Mapping[str, Any]) -> Reference:
        arguments = values_of(point, setting.parameters)
        return _reference(setting, ir, plan, arguments)

    return EmittedFunction(
        name="characteristic_coefficients",
        arguments=setting.parameters,
        body=f"{{evaluate_array}}({{_characteristic_coefficients}}, {{arguments}}, ({n + 1},))",
        returns="NDArray[np.complex128]",
        summary="Coefficients of the characteristic polynomial P(Γ) = det(Γ - S).",
        description="The product of its factors over the rationals.",
        result=f"Shape (..., {n + 1}), complex128, highest power of Γ first, beginning with 1.",
        reference=reference,
        kernels=(kernel,),
        uses=("evaluate_array",),
    )


def _reference(
    setting: Setting, ir: IR, plan: list[tuple[list[str], int]], arguments: Mapping[str, Any]
) -> Reference:
    assert setting.linear is not None
    one, zero = (Rounded(mpmath.mpf(c), mpmath.mpf(0)) for c in (1, 0))
    inner = rounded(ir, arguments)
    bounds, values = [one], [mpmath.mpc(1)]
    for (keys, multiplicity), factor in zip(plan, setting.linear.factors, strict=True):
        rough = [one, *(inner[key] if key else zero for key in keys)]
        fine = [exact(setting.shown(c), arguments) for c in reversed(factor.coefficients)]
        for _ in range(multiplicity):
            bounds, values = _product(bounds, rough, zero), _product(values, fine, mpmath.mpc(0))
    return Reference(arguments, (len(values),), tuple(values), tuple(b.error for b in bounds))


def _product(left: list[Any], right: list[Any], zero: Any) -> list[Any]:
    result = [zero] * (len(left) + len(right) - 1)
    for i, a in enumerate(left):
        for j, b in enumerate(right):
            result[i + j] = result[i + j] + a * b
    return result
