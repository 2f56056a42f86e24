"""Keywords that several emitted functions have besides their parameters."""

from __future__ import annotations

from collections.abc import Sequence

from ..ir import fresh
from .kernels import Option
from .numpy_target import LINE_LENGTH, wrapped

__all__ = ["gradient_option", "wanted"]


def gradient_option(names: Sequence[str]) -> Option:
    """The keyword `gradient` of a function with these parameters."""
    return Option(
        fresh("gradient", names),
        "bool",
        "False",
        "bool, optional",
        "Whether the derivatives by every parameter are returned as well, as name -> derivative.",
    )


def wanted(names: Sequence[str], gradient: Option | None = None, head: str = "") -> str:
    """Names, of those where derivatives are wanted, as an argument in Python text.

    Parameters
    ----------
    names : sequence of str
        Of the parameters.
    gradient : Option, optional
        Without it the names come always.
    head : str
        What stands before it, such as ``names=``.
    """
    texts = [f'"{name}"' for name in names]
    choice = ("", "") if gradient is None else (f"if {gradient.name}", "else ()")
    line = f"{head}({', '.join(texts)}{',' if len(texts) == 1 else ''}) {' '.join(choice)}".rstrip()
    if len(line) + 9 <= LINE_LENGTH:
        return line
    rows = "\n".join(wrapped(texts, 12))
    return f"{head}(\n{rows}\n        )" + "".join(f"\n        {part}" for part in choice if part)
