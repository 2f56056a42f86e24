"""Records of what is emitted: `Kernel`, a formula, and `EmittedFunction`, what a user calls."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .. import runtime
from ..ir import IR
from ..parameters import Parameter

__all__ = [
    "AMPLITUDES",
    "RUNTIME",
    "SHARED",
    "TIME",
    "Constant",
    "EmittedFunction",
    "Kernel",
    "Option",
    "Reference",
    "Statement",
    "called",
]

#: what emitted modules may use of the code that they share: name -> module
RUNTIME = {
    **dict.fromkeys(("explicit_edges", "implicit_edges", "zone"), "_edges"),
    **dict.fromkeys(("boundaries_at", "real_at"), "_dual"),
    **dict.fromkeys(
        ("conservative_growth", "growing", "largest", "matrix_growth", "quadratic_growth"),
        "_growth",
    ),
    **dict.fromkeys(("Beating", "beating_at"), "_beating"),
    **dict.fromkeys(("Linear", "evolution_at"), "_evolution"),
    "modal_values": "_eigenmodes",
    "Flow": "_flow",
    **dict.fromkeys(("Motion", "response_at"), "_motion"),
    "initial_at": "_initial",
    **dict.fromkeys(
        ("backbone_at", "equilibria_at", "jacobian_at", "response_along", "stability_at"),
        "_nonlinear",
    ),
    "equilibria_of_one": "_one_amplitude",
    "modes_at": "_modes",
    "equilibria_of_many": "_many_amplitudes",
    **dict.fromkeys(
        (
            "checked",
            "checked_amplitudes",
            "defined",
            "evaluate",
            "evaluate_array",
            "evaluate_pair",
            "multiply_out",
            "no_edges",
        ),
        "_runtime",
    ),
}


#: modules of `mmsgen.runtime` that every emitted package holds
SHARED = tuple(sorted(path.stem for path in Path(runtime.__file__).parent.glob("_[!_]*.py")))

#: where a point holds the amplitudes, and the time: no parameter can have these names
AMPLITUDES, TIME = "(amplitudes)", "(time)"


Statement = tuple[str, tuple[str, ...]]
"""``("return f", ("a", "b"))`` for ``return f(a, b)``, ``("return ", …)`` for a bare tuple.

A local name in braces stands for what an argument of that name is called in the kernel.
"""


@dataclass(frozen=True)
class Kernel:
    """A formula without checks, evaluated by an emitted function block by block.

    Attributes
    ----------
    name : str
    ir : IR
        Its outputs are named by what stands left of the assignment.
    closing : tuple of Statement
        What is done with the outputs; empty where they are assigned in place.
    leading : tuple of str
        Arguments before those of the IR.
    uses : tuple of str
        Functions of the runtime that it calls.
    """

    name: str
    ir: IR
    closing: tuple[Statement, ...] = ()
    leading: tuple[str, ...] = ()
    uses: tuple[str, ...] = ()


@dataclass(frozen=True)
class Constant:
    """What a module holds besides its formulas.

    Attributes
    ----------
    name : str
    function : str
        Of the runtime, which makes it.
    items : tuple of str
        Its arguments, as Python text.
    meaning : str
        A comment.
    """

    name: str
    function: str
    items: tuple[str, ...]
    meaning: str


@dataclass(frozen=True)
class Option:
    """A keyword of an emitted function that is no parameter.

    Attributes
    ----------
    name, annotation, default, kind, meaning : str
        `kind` is what the docstring says of its type.
    """

    name: str
    annotation: str
    default: str
    kind: str
    meaning: str


@dataclass(frozen=True)
class Reference:
    """Reference values at one point, each with the error that double precision may make.

    Attributes
    ----------
    arguments : mapping
        Keyword → number that a double holds exactly.
    shape : tuple of int
        Of the values; the last axis of `values` counts fastest.
    values, errors : tuple
        Of mpmath numbers.
    amplitudes : tuple
        Those that the function takes before its keywords.
    first : mapping
        What it takes before these: "time" or "amplitude" → number.
    """

    arguments: Mapping[str, Any]
    shape: tuple[int, ...]
    values: tuple[Any, ...]
    errors: tuple[Any, ...]
    amplitudes: tuple[Any, ...] = ()
    first: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class EmittedFunction:
    """A function that a user calls.

    Attributes
    ----------
    name : str
    arguments : tuple of Parameter
    body : str
        The return statement, in which ``{name}`` stands for a name at module level and
        ``{arguments}`` for the checked arguments.
    returns : str
        Annotation of the result.
    summary, description, result : str
        For the docstring: one line, further paragraphs, the section on what is returned.
    kernels : tuple of Kernel
        Those that belong to this function.
    uses : tuple of str
        Functions of the runtime that the body calls.
    leading : tuple of (name, description)
        Arguments before the keywords.
    reference : callable or None
        Point → `Reference`, or None where there is no answer.
    options : tuple of Option
        Further keywords, after the parameters.
    constants : tuple of Constant
        Those that belong to this function.
    kind : str
        What the docstring says of the type of the result; by default that of the numbers.
    """

    name: str
    arguments: tuple[Parameter, ...]
    body: str
    returns: str
    summary: str
    description: str
    result: str
    reference: Callable[[Mapping[str, Any]], Reference | None] | None = field(compare=False)
    kernels: tuple[Kernel, ...] = ()
    uses: tuple[str, ...] = ()
    leading: tuple[tuple[str, str], ...] = ()
    options: tuple[Option, ...] = ()
    constants: tuple[Constant, ...] = ()
    kind: str = ""


def called(head: str, items: Sequence[str]) -> str:
    """A call after a return statement, its arguments a line each where they are too long for one.

    Braces stand for names, as in `EmittedFunction.body`.
    """
    line = f"{head}({', '.join(items)})"
    if len(line) <= 86 and "\n" not in line:
        return line
    inner = "".join(f"        {item},\n" for item in items)
    return f"{head}(\n{inner}    )"
