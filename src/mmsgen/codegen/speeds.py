"""The emitted `critical_speeds`: both edges in the frequency that the first relation detunes.

Parameters that depend on this frequency by their definition are replaced by it, so that the edges
are the roots of k·Ω = form(Ω) + σ_edge(Ω). Detunings of further relations follow from the
frequencies.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath
import sympy as sp

from ..errors import EmissionError
from ..ir import compute_ir, fresh
from ..parameters import Parameter
from .boundaries import boundary_parameters
from .kernels import EmittedFunction, Kernel, Reference, called
from .naming import check_parameter_names
from .options import gradient_option, wanted
from .setting import Setting, values_of
from .speed_values import speed_values

__all__ = ["speed_function"]


@dataclass(frozen=True)
class _Implicit:
    """The relations as functions of the detuned frequency.

    Attributes
    ----------
    setting : Setting
    """

    setting: Setting

    @cached_property
    def unknowns(self) -> tuple[sp.Symbol, ...]:
        """The detuned frequency; without a relation the frequencies of excitations."""
        relations = self.setting.case.relations
        if relations:
            return tuple(relations[0].lhs.free_symbols)
        phasors = self.setting.case.weak.scaled.alphabet.phasors
        return tuple(p.base for p in phasors if p.moving and p.base.is_Symbol)

    def resolve(self, expression: sp.Expr) -> sp.Expr:
        """An expression with everything replaced that depends on the detuned frequency."""
        while True:
            table = {
                p.symbol: p.definition
                for p in self.setting.case.parameters
                if p.symbol in expression.free_symbols and self._depends(p, frozenset())
            }
            if not table:
                return expression
            expression = expression.xreplace(table)

    def _depends(self, parameter: Parameter, above: frozenset[str]) -> bool:
        if parameter.definition is None or parameter.symbol in self.unknowns:
            return False
        if parameter.name in above:
            raise EmissionError(f"the definition of {parameter.name} leads back to itself")
        symbols = parameter.definition.free_symbols
        if symbols & set(self.unknowns):
            return True
        inner = (p for p in self.setting.case.parameters if p.symbol in symbols)
        return any(self._depends(p, above | {parameter.name}) for p in inner)

    @cached_property
    def outputs(self) -> dict[str, sp.Expr]:
        """The first detuning, then the arguments of `boundaries`."""
        relations = self.setting.case.relations
        sigmas = {r.detuning: self.resolve(r.lhs - r.rhs) for r in relations}
        rest = {
            p.name: sigmas.get(p.symbol, self.resolve(p.symbol))
            for p in boundary_parameters(self.setting)
        }
        first = {p.name: sigmas[p.symbol] for p in self.setting.detunings[:1]}
        return {**first, **rest}

    @cached_property
    def arguments(self) -> tuple[Parameter, ...]:
        """The parameters that do not depend on the detuned frequency."""
        symbols = set().union(*(e.free_symbols for e in self.outputs.values()))
        symbols -= set(self.unknowns)
        known = {p.symbol: p for p in self.setting.case.parameters}
        others = sorted(symbols - set(known), key=lambda s: str(s.name))
        found = [p for s, p in known.items() if s in symbols] + [Parameter(s) for s in others]
        check_parameter_names(p.name for p in found)
        return tuple(found)

    @cached_property
    def multiple(self) -> sp.Rational | None:
        """k in k·Ω, if Ω occurs nowhere else; None if it does."""
        (unknown,) = self.unknowns
        sigma, *rest = self.outputs.values()
        slope = sigma.diff(unknown)
        if slope.free_symbols or any(unknown in e.free_symbols for e in rest):
            return None
        return slope


def speed_function(setting: Setting, kernel: Kernel | None) -> EmittedFunction:
    """The function `critical_speeds` of a case with a linear slow flow.

    Parameters
    ----------
    setting : Setting
    kernel : Kernel or None
        That of `boundaries`; None for a case that cannot be unstable.
    """
    implicit = _Implicit(setting)
    if kernel is None or not setting.detunings:
        return _without_edges(setting, implicit)
    (unknown,) = implicit.unknowns
    explicit = implicit.multiple is not None
    own = _resonance_kernel(implicit, unknown) if explicit else _detuning_kernel(implicit, unknown)
    name = str(unknown.name)
    solver = "explicit_edges" if explicit else "implicit_edges"
    names = [p.name for p in implicit.arguments]
    gradient = gradient_option(names)
    items = [f"{{{own.name}}}", "{_boundaries}", *([str(implicit.multiple)] * explicit)]
    items += ["{arguments}", wanted(names, gradient) if names else "()"]

    cache: dict[tuple[Any, ...], Reference] = {}

    def reference(point: Mapping[str, Any]) -> Reference:
        arguments = values_of(point, implicit.arguments)
        key = tuple(arguments.values())
        if key not in cache:
            pair = speed_values(setting, implicit.outputs, unknown, own.ir, kernel, arguments)
            values, errors = tuple(v.value for v in pair), tuple(v.error for v in pair)
            cache[key] = Reference(arguments, (2,), values, errors)
        return cache[key]

    return EmittedFunction(
        name="critical_speeds",
        arguments=implicit.arguments,
        body=called(f"{{{solver}}}", items),
        returns="Any",
        summary=f"Both edges of the unstable zone in {name}.",
        description=_explained(implicit, name, explicit=explicit),
        result=(
            "lower, upper: in rad/s, float64, in the shape to which the arguments broadcast; NaN "
            "where there is no such edge. With gradient this pair and name -> pair."
        ),
        reference=reference,
        kernels=(own,),
        uses=(solver,),
        options=(gradient,) if names else (),
    )


def _explained(implicit: _Implicit, name: str, *, explicit: bool) -> str:
    text = f"Where {implicit.setting.relations[0]} lies on an edge of `boundaries`."
    if explicit:
        return text
    dependent = [
        f"{p.name} = {p.definition}"
        for p in implicit.setting.case.parameters
        if p in implicit.setting.parameters and implicit.resolve(p.symbol) != p.symbol
    ]
    return (
        f"{text} With {', '.join(dependent)} this is an equation for {name}, solved to full double "
        f"precision. Where it has several roots: first {name} without detuning is found, the "
        "smallest positive one (two that are closer than ten per cent may be passed over), then "
        "the nearest to that on the side of the edge."
    )


def _without_edges(setting: Setting, implicit: _Implicit) -> EmittedFunction:
    def reference(point: Mapping[str, Any]) -> Reference:
        arguments = values_of(point, implicit.arguments)
        return Reference(arguments, (2,), (mpmath.nan,) * 2, (mpmath.mpf(0),) * 2)

    return EmittedFunction(
        name="critical_speeds",
        arguments=implicit.arguments,
        body="{evaluate_pair}({no_edges}, {arguments})",
        returns="tuple[Any, Any]",
        summary="Both edges of the unstable zone in the detuned frequency: there is none.",
        description=(
            "This case cannot be unstable for any detuning: NaN everywhere."
            if setting.detunings
            else "Without a resonance relation no frequency is detuned: NaN everywhere."
        ),
        result="lower, upper: NaN, float64, in the shape to which the arguments broadcast.",
        reference=reference,
        uses=("evaluate_pair", "no_edges"),
    )


def _detuning_kernel(implicit: _Implicit, unknown: sp.Symbol) -> Kernel:
    names = [p.name for p in implicit.arguments]
    argument = sp.Symbol(fresh(str(unknown.name), names), positive=True)
    symbols = [argument, *(p.symbol for p in implicit.arguments)]
    keys = [fresh(f"{name}_at_speed", [*names, argument.name]) for name in implicit.outputs]
    outputs = {
        key: e.xreplace({unknown: argument})
        for key, e in zip(keys, implicit.outputs.values(), strict=True)
    }
    return _returning("_detuning", implicit, symbols, outputs)


def _resonance_kernel(implicit: _Implicit, unknown: sp.Symbol) -> Kernel:
    names = [p.name for p in implicit.arguments]
    sigma, *rest = implicit.outputs.values()
    keys = [fresh("centre", names), *(fresh(f"{p.name}_", names) for p in _rest(implicit))]
    centre = -sigma.xreplace({unknown: sp.Integer(0)}) / implicit.multiple
    symbols = [p.symbol for p in implicit.arguments]
    outputs = dict(zip(keys, (centre, *rest), strict=True))
    return _returning("_resonance", implicit, symbols, outputs)


def _rest(implicit: _Implicit) -> tuple[Parameter, ...]:
    return boundary_parameters(implicit.setting)


def _returning(
    name: str, implicit: _Implicit, symbols: list[sp.Symbol], outputs: dict[str, sp.Expr]
) -> Kernel:
    """A kernel that returns its outputs, those that are arguments or numbers as they stand."""
    named = {key: e for key, e in outputs.items() if e.args}
    ir = compute_ir(f"{implicit.setting.name}.{name}", symbols, named)
    values = [
        key if key in named else f"{{{e.name}}}" if e.is_Symbol else str(e)
        for key, e in outputs.items()
    ]
    return Kernel(name, ir, (("return ", tuple(values)),))
