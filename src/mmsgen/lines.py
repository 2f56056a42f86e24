"""Long formulas over several lines of LaTeX, broken where they may be."""

from __future__ import annotations

import re
from collections.abc import Sequence

import sympy as sp

__all__ = ["merged_roots", "pieces", "sum_lines", "width", "wrapped"]

LINE = 56
"""Width of a line in characters as they are seen."""

_FRACTION = re.compile(r"\\frac\{([^{}]*)\}\{([^{}]*)\}")
_UNSEEN = re.compile(
    r"\\(?:left|right|Bigl|Bigr|overline|displaystyle|sqrt|quad|cdot|frac)\b|[{}_^&\\ ]"
)
_COMMAND = re.compile(r"\\[A-Za-z]+")


def width(text: str) -> int:
    """How many characters of LaTeX are seen, a fraction counting as its longer half."""
    text = _COMMAND.sub(
        lambda m: m[0] if _UNSEEN.fullmatch(m[0]) else ("sin" if m[0] in _WORDS else "x"), text
    )
    previous = ""
    while previous != text:
        previous = text
        text = _FRACTION.sub(lambda m: " " + max(m[1], m[2], key=_seen), text)
        text = re.sub(r"([_^])\{([^{}]*)\}", lambda m: m[2][: (len(m[2]) + 1) // 2], text)
        # The space keeps a command before the brace apart from what was in it.
        text = re.sub(r"(?<!\})\{([^{}]*)\}(?!\{)", r" \1", text)
    return _seen(text)


def _seen(text: str) -> int:
    return len(_UNSEEN.sub("", text))


_WORDS = ("\\sin", "\\cos")


def merged_roots(term: sp.Expr) -> sp.Expr:
    """A product with all its square roots under one, as far as that changes no sign."""
    inside, outside = [], []
    for factor in sp.Mul.make_args(term):
        base, exponent = factor.as_base_exp()
        if factor != sp.I and exponent.is_Rational and exponent.q == 2 and base.is_nonnegative:
            inside.append(base ** (2 * exponent))
        else:
            outside.append(factor)
    if not inside:
        return term
    root = sp.Pow(sp.Mul(*inside), sp.S.Half, evaluate=False)
    return sp.Mul(*outside, root, evaluate=False) if outside else root


def _signed(term: sp.Expr) -> str:
    """A term of a sum, with its sign in front."""
    negative = term.could_extract_minus_sign()
    return f"{'-' if negative else '+'} {sp.latex(merged_roots(-term if negative else term))}"


def pieces(expression: sp.Expr) -> list[str]:
    """A sum in pieces that may stand on lines of their own; long brackets are opened."""
    found = []
    for term in expression.as_ordered_terms():
        sums = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.Add) and len(f.args) > 2]
        if len(sums) != 1 or width(sp.latex(term)) < LINE:
            found.append(_signed(term))
            continue
        rest = term / sums[0]
        inner = pieces(sums[0])
        inner[0] = inner[0][2:] if inner[0].startswith("+") else inner[0]
        found.append(f"{_signed(rest)} \\Bigl( {inner[0]}")
        found += inner[1:]
        found[-1] += " \\Bigr)"
    return found


def sum_lines(left: str, expression: sp.Expr, relation: str = "=") -> list[str]:
    """A sum over several aligned lines."""
    parts = pieces(expression)
    if relation and parts[0].startswith("+"):
        parts[0] = parts[0][2:]
    first, *others = wrapped(parts)
    return [f"{left} &{relation} {first}", *(f"&\\quad {line}" for line in others)]


def wrapped(parts: Sequence[str]) -> list[str]:
    """Pieces joined to lines."""
    lines, used = [parts[0]], width(parts[0])
    for part in parts[1:]:
        own = width(part)
        if used + own > LINE:
            lines.append(part)
            used = own
        else:
            lines[-1] += f" {part}"
            used += own
    return lines
