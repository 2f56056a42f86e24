"""The text of a case module: header, constants, kernels, functions."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping, Sequence
from fractions import Fraction
from hashlib import sha256
from string import Template

from .._version import __version__
from ..errors import EmissionError
from ..ir import fresh
from ..parameters import Parameter
from .docstrings import domain_of, function_docstring, module_docstring, origin
from .kernels import RUNTIME, Constant, EmittedFunction, Kernel
from .numpy_target import LINE_LENGTH, kernel_text, wrapped
from .setting import Setting

__all__ = ["case_text", "digest_of", "fill"]

_MODULE = Template('''\
$origin
# Made from sha256 $digest
$operations
"""$docstring"""

from __future__ import annotations

from typing import $typing

import numpy as np

$imports

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
$exported
]

#: the resonance relations, with their detunings
RELATIONS: tuple[str, ...] = $relations

#: the highest power of ε
ORDER = $order

#: the coordinates, in the order of amplitudes
COORDINATES = $coordinates

#: name -> (domain, unit, meaning)
PARAMETERS = {
$parameters
}

#: λ_j of A_j = B_j exp(i λ_j t), as coordinate -> {detuning: coefficient}
FRAME: dict[str, dict[str, float]] | None = $frame

#: rows and columns of the slow-flow matrix; conj(A) is the complex conjugate of A
VARIABLES: tuple[str, ...] = $variables
$aliases

# --- formulas -------------------------------------------------------------------------------------

$constants

$kernels

# --- functions ------------------------------------------------------------------------------------


$functions''')


def fill(template: Template, keys: dict[str, str]) -> str:
    """Fill in a template; it and the keys must name the same things.

    Raises
    ------
    EmissionError
        If a key is missing or not wanted.
    """
    wanted = set(template.get_identifiers())
    if wanted != set(keys):
        raise EmissionError(
            f"a template wants {sorted(wanted - set(keys))} and was given "
            f"{sorted(set(keys) - wanted)} besides"
        )
    return template.substitute(keys)


def digest_of(functions: Sequence[EmittedFunction]) -> str:
    """SHA-256 of the formulas of all functions, as mathematics."""
    kernels = (kernel for function in functions for kernel in function.kernels)
    return sha256("\n".join(kernel.ir.canonical for kernel in kernels).encode()).hexdigest()


def case_text(
    setting: Setting,
    functions: Sequence[EmittedFunction],
    model: str,
    derivation: str,
    source: str,
) -> str:
    """The text of a case module."""
    kernels = [kernel for function in functions for kernel in function.kernels]
    names = _module_names(setting, functions, kernels)
    counts = ", ".join(f"{k.name.lstrip('_')} {k.ir.operations}" for k in kernels)
    constants = [constant for function in functions for constant in function.constants]
    calls = {"checked", *(name for f in functions for name in f.uses)}
    calls |= {constant.function for constant in constants}
    formulas = {name for k in kernels for name in k.uses}
    exported = sorted((*_CONSTANTS, *(f.name for f in functions)), key=_all_order)
    aliases = ""
    if names["PARAMETERS"] != "PARAMETERS":
        aliases = f"\n{names['PARAMETERS']} = PARAMETERS\n"
    keys = {
        "origin": origin(__version__, derivation),
        "digest": digest_of(functions),
        "operations": textwrap.fill(
            f"Operations for each point: {counts}",
            LINE_LENGTH,
            initial_indent="# ",
            subsequent_indent="# ",
        ),
        "docstring": module_docstring(setting, model, source),
        "typing": "TYPE_CHECKING" + (", Any" if any(map(_untyped, functions)) else ""),
        "imports": _imports(calls, formulas, names),
        "exported": "\n".join(f'    "{name}",' for name in exported),
        "relations": _tuple_text(setting.relations, "RELATIONS: tuple[str, ...] = "),
        "order": str(setting.case.order),
        "coordinates": _tuple_text(setting.coordinates, "COORDINATES = "),
        "parameters": _parameters_text(functions),
        "frame": _frame_text(setting),
        "variables": _tuple_text(_variables(setting), "VARIABLES: tuple[str, ...] = "),
        "aliases": aliases,
        "constants": "".join(_constant_text(c, names) for c in constants),
        "kernels": "\n\n".join(kernel_text(k, names[k.name]) for k in kernels),
        "functions": "\n\n".join(_function_text(f, setting, names) for f in functions),
    }
    return fill(_MODULE, keys)


_CONSTANTS = ("COORDINATES", "FRAME", "ORDER", "PARAMETERS", "RELATIONS", "VARIABLES")


def _untyped(function: EmittedFunction) -> bool:
    return "Any" in function.returns or any("Any" in o.annotation for o in function.options)


def _all_order(name: str) -> tuple[int, str]:
    return (0 if name.isupper() else 1, name)


def _module_names(
    setting: Setting, functions: Sequence[EmittedFunction], kernels: Sequence[Kernel]
) -> dict[str, str]:
    """Names at module level, none of them that of an argument, which would hide it."""
    arguments = {p.name for f in functions for p in f.arguments}
    arguments |= {o.name for f in functions for o in f.options}
    wanted = ["PARAMETERS", "checked", *(name for f in functions for name in f.uses)]
    wanted += [k.name for k in kernels]
    wanted += [name for f in functions for c in f.constants for name in (c.name, c.function)]
    return {name: fresh(name, arguments) for name in dict.fromkeys(wanted)}


def _imports(calls: set[str], formulas: set[str], names: dict[str, str]) -> str:
    """What functions call, under a name that no argument hides, and what formulas call."""
    plain = sorted(formulas | {name for name in calls if names[name] == name})
    statements = []
    for module in sorted(set(RUNTIME.values())):
        own = [name for name in plain if RUNTIME[name] == module]
        aliases = [n for n in calls if names[n] != n and RUNTIME[n] == module]
        lines = [_import(module, own)] if own else []
        lines += [f"from ..{module} import {name} as {names[name]}" for name in aliases]
        statements += sorted(lines, key=lambda text: re.findall(r"\w+", text)[3])
    return "\n".join(statements)


def _import(module: str, names: list[str]) -> str:
    line = f"from ..{module} import {', '.join(names)}"
    if len(line) <= LINE_LENGTH:
        return line
    inner = "\n".join(f"    {name}," for name in names)
    return f"from ..{module} import (\n{inner}\n)"


def _tuple_text(items: Sequence[str], head: str) -> str:
    texts = [_quoted(item) for item in items]
    line = f"({', '.join(texts)}{',' if len(texts) == 1 else ''})"
    if len(head) + len(line) <= LINE_LENGTH:
        return line
    return "(\n" + "\n".join(wrapped(texts, 4)) + "\n)"


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", " ") + '"'


def _parameters_text(functions: Sequence[EmittedFunction]) -> str:
    table: dict[str, Parameter] = {}
    for function in functions:
        for parameter in function.arguments:
            table.setdefault(parameter.name, parameter)
    lines = []
    for name, parameter in table.items():
        parts = [_quoted(t) for t in (domain_of(parameter), parameter.unit, parameter.meaning)]
        line = f"    {_quoted(name)}: ({', '.join(parts)}),"
        if len(line) > LINE_LENGTH:
            inner = "\n".join(f"        {part}," for part in parts)
            line = f"    {_quoted(name)}: (\n{inner}\n    ),"
        lines.append(line)
    return "\n".join(lines)


def _number(c: Fraction) -> str:
    return str(c.numerator) if c.denominator == 1 else f"{c.numerator} / {c.denominator}"


def _frame_text(setting: Setting) -> str:
    if setting.flow.frame is None:
        return "None"
    lines = []
    for name, rates in zip(setting.coordinates, setting.flow.frame, strict=True):
        inner = ", ".join(f"{_quoted(str(s.name))}: {_number(c)}" for s, c in rates.items())
        lines.append(f"    {_quoted(name)}: {{{inner}}},")
    return "{\n" + "\n".join(lines) + "\n}"


def _variables(setting: Setting) -> tuple[str, ...]:
    if setting.linear is None:
        return ()
    texts = []
    for variable in setting.linear.variables:
        barred = not variable.is_Symbol
        name = variable.args[0].name if barred else variable.name
        texts.append(f"conj({name})" if barred else name)
    return tuple(texts)


def _constant_text(constant: Constant, names: Mapping[str, str]) -> str:
    items = "\n".join(f"    {item}," for item in constant.items)
    head = f"{names[constant.name]} = {names[constant.function]}("
    return f"\n#: {constant.meaning}\n{head}\n{items}\n)\n"


def _function_text(function: EmittedFunction, setting: Setting, names: dict[str, str]) -> str:
    leading = [f"{name}: ArrayLike" for name, _ in function.leading]
    if function.leading:
        leading.append("/")
    keywords = [f"{p.name}: ArrayLike" for p in function.arguments]
    keywords += [f"{o.name}: {o.annotation} = {o.default}" for o in function.options]
    signature = [*leading, *(["*", *keywords] if keywords else [])]
    head = f"def {function.name}({', '.join(signature)}) -> {function.returns}:"
    if len(head) > LINE_LENGTH:
        rows = "\n".join(wrapped(signature, 4))
        head = f"def {function.name}(\n{rows}\n) -> {function.returns}:"
    docstring = function_docstring(function, setting)
    passed = [names["PARAMETERS"], *(f"{p.name}={p.name}" for p in function.arguments)]
    call = f"{names['checked']}({', '.join(passed)})"
    taken = {p.name for p in function.arguments} | set(names.values())
    taken |= {o.name for o in function.options}
    local = fresh("arguments", taken | {name for name, _ in function.leading})
    lines = [f"    {local} = {call}"]
    if len(lines[0]) > LINE_LENGTH:
        lines = [f"    {local} = {names['checked']}(", *wrapped(passed, 8), "    )"]
    body = function.body.format_map({**names, "arguments": local})
    lines.append(f"    return {body}")
    return head + "\n" + docstring + "\n" + "\n".join(lines) + "\n"
