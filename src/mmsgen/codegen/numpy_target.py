"""The target NumPy: expressions and kernels as Python text."""

from __future__ import annotations

import re
from collections.abc import Mapping

import sympy as sp

from ..errors import EmissionError
from ..ir import fresh
from .kernels import RUNTIME, Kernel

__all__ = ["LINE_LENGTH", "expression_text", "filled", "kernel_text"]

LINE_LENGTH = 100

# What holds an operand and its operator together when a line is broken.
_GLUE = "\N{NO-BREAK SPACE}"

_SUM, _PRODUCT, _ATOM = 1, 2, 3

_FUNCTIONS = {sp.conjugate: "np.conj", sp.exp: "np.exp", sp.Abs: "np.abs"}


def expression_text(expression: sp.Expr, names: Mapping[sp.Symbol, str], level: int = 0) -> str:
    """An expression as Python code in which powers are ±1, 1/2 or squares of symbols.

    Parameters
    ----------
    expression : sympy.Expr
    names : mapping
        Symbol → the local name.
    level : int
        Precedence of what stands around it.

    Raises
    ------
    EmissionError
        If it contains a function that has no counterpart.
    """
    text, own = _text(expression, names)
    return f"({text})" if own < level else text


def _text(e: sp.Expr, names: Mapping[sp.Symbol, str]) -> tuple[str, int]:
    if e.is_Symbol:
        return names[e], _ATOM
    if e.is_Integer:
        return str(e), _ATOM if e >= 0 else _SUM
    if e.is_Rational:
        return f"{e.p}{_GLUE}/{_GLUE}{e.q}", _PRODUCT if e >= 0 else _SUM
    if e is sp.I:
        return "1j", _ATOM
    if e.is_Add:
        return _sum(e, names), _SUM
    if e.is_Mul:
        return _product(e, names)
    if e.is_Pow:
        return _power(e, names)
    if e.is_number and e.is_real:
        return repr(float(e.evalf(30))), _ATOM
    for kind, function in _FUNCTIONS.items():
        if isinstance(e, kind):
            return f"{function}({expression_text(e.args[0], names)})", _ATOM
    raise EmissionError(
        f"{e} contains {e.func.__name__}, which emitted code does not know: replace it by a "
        "parameter with a definition"
    )


def _sum(e: sp.Expr, names: Mapping[sp.Symbol, str]) -> str:
    terms = [(t.as_coeff_Mul()[0].is_negative, t) for t in e.as_ordered_terms()]
    terms.sort(key=lambda term: bool(term[0]))  # a leading minus would be an operation
    text = ""
    for negative, term in terms:
        inner = expression_text(-term if negative and text else term, names, bool(text) * _PRODUCT)
        joint = f" {'-' if negative else '+'}{_GLUE}" if text else ""
        text += joint + inner.replace(" ", _GLUE) if text else inner
    return text


def _product(e: sp.Expr, names: Mapping[sp.Symbol, str]) -> tuple[str, int]:
    number, rest = e.as_coeff_Mul()
    if number.is_negative:
        inner = expression_text(sp.Mul(-number, rest), names, _PRODUCT)
        return f"-{inner}", _SUM
    above, below = [], []
    dyadic = number.q & (number.q - 1) == 0
    if number != 1 and dyadic and number.q > 1:
        # Python folds the exact quotient of two numbers when it compiles.
        above.append(f"{number.p}{_GLUE}/{_GLUE}{number.q}")
    elif number.p != 1:
        above.append(str(number.p))
    if not dyadic:
        below.append(str(number.q))
    for factor in rest.as_ordered_factors():
        base, exponent = factor.as_base_exp()
        if exponent.is_Rational and exponent < 0:
            below.append(expression_text(sp.Pow(base, -exponent, evaluate=False), names, _ATOM))
        else:
            above.append(expression_text(factor, names, _PRODUCT))
    text = f" *{_GLUE}".join(above) if above else "1"
    if len(below) == 1:
        text += f" /{_GLUE}{below[0]}"
    elif below:
        text += f" /{_GLUE}(" + f" *{_GLUE}".join(below) + ")"
    return text, _PRODUCT


def _power(e: sp.Expr, names: Mapping[sp.Symbol, str]) -> tuple[str, int]:
    base, exponent = e.args
    if exponent == 1:
        return _text(base, names)
    if exponent == 2:
        inner = expression_text(base, names, _ATOM)
        return f"{inner}{_GLUE}*{_GLUE}{inner}", _PRODUCT
    if exponent == sp.Rational(1, 2):
        return f"np.sqrt({expression_text(base, names)})", _ATOM
    if exponent in (-1, sp.Rational(-1, 2)):
        below = expression_text(sp.Pow(base, -exponent, evaluate=False), names, _ATOM)
        return f"1{_GLUE}/{_GLUE}{below}", _PRODUCT
    if exponent.is_Integer and base.is_number:
        return str(sp.Integer(base) ** exponent), _ATOM
    raise EmissionError(f"the power {e} cannot be emitted: only square roots and whole powers are")


def filled(head: str, text: str, indent: int) -> list[str]:
    """A statement, in parentheses and broken before operators where it is too long for a line."""
    pad = " " * indent
    whole = f"{pad}{head}{text}"
    if len(whole) <= LINE_LENGTH:
        return [whole.replace(_GLUE, " ")]
    inner = " " * (indent + 4)
    lines, current = [f"{pad}{head}("], inner
    for word in _breakable(text, LINE_LENGTH - len(inner)):
        longer = current + (" " if current.strip() else "") + word
        if len(longer) > LINE_LENGTH and current.strip():
            lines.append(current)
            longer = inner + word
        current = longer
    return [line.replace(_GLUE, " ") for line in (*lines, current, f"{pad})")]


def _breakable(text: str, room: int) -> list[str]:
    """The pieces between which a line may be broken: terms, or operands of those too long."""
    pieces = []
    for word in text.split(" "):
        if len(word) <= room:
            pieces.append(word)
        else:
            pieces += re.split(rf"{_GLUE}(?=[-+*/]{_GLUE})", word)
    return pieces


def kernel_text(kernel: Kernel, name: str) -> str:
    """A kernel as a private function.

    Parameters
    ----------
    kernel : Kernel
    name : str
        Under which it is known at module level.
    """
    ir = kernel.ir
    taken = {"np", "out", *RUNTIME, *kernel.leading}
    taken.update(key for key, _ in ir.outputs if key.isidentifier())
    names: dict[sp.Symbol, str] = {}
    given = {s.name for s in ir.arguments}
    for symbol in ir.arguments:
        clash = symbol.name in taken
        names[symbol] = fresh(symbol.name + "_", given | taken) if clash else symbol.name
        taken.add(names[symbol])
    for symbol, _ in ir.intermediates:
        names[symbol] = fresh(symbol.name, taken)
        taken.add(names[symbol])
    arguments = [*kernel.leading, *(names[s] for s in ir.arguments)]
    lines = _definition(name, arguments)
    if ir.intermediates:
        lines.append("    # Intermediates")
    for symbol, expression in ir.intermediates:
        lines += filled(f"{names[symbol]} = ", expression_text(expression, names), 4)
    if ir.outputs and ir.intermediates:
        lines.append("    # Outputs")
    for key, expression in ir.outputs:
        lines += filled(f"{key} = ", expression_text(expression, names), 4)
    local = {s.name: names[s] for s in ir.arguments}
    for head, items in kernel.closing:
        lines += _statement(head, [item.format_map(local) for item in items])
    if not ir.outputs and not kernel.closing:
        lines.append("    return")
    return "\n".join(lines) + "\n"


def _definition(name: str, arguments: list[str]) -> list[str]:
    line = f"def {name}({', '.join(arguments)}):"
    if len(line) <= LINE_LENGTH:
        return [line]
    return [f"def {name}(", *wrapped(arguments, 4), "):"]


def wrapped(items: list[str], indent: int) -> list[str]:
    """Items separated by commas, as many on a line as fit."""
    pad = " " * indent
    lines, current = [], pad
    for item in items:
        longer = f"{current}{' ' if current.strip() else ''}{item},"
        if len(longer) > LINE_LENGTH and current.strip():
            lines.append(current)
            longer = f"{pad}{item},"
        current = longer
    return [*lines, current]


def _statement(head: str, items: list[str]) -> list[str]:
    """A call, or a bare tuple, broken after commas where it is too long."""
    inner = ", ".join(items)
    whole = f"    {head}{inner}" if head.endswith(" ") else f"    {head}({inner})"
    if len(whole) <= LINE_LENGTH:
        return [whole]
    return [f"    {head}(", *wrapped(items, 8), "    )"]
