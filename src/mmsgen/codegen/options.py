"""Keywords that several emitted functions have besides their parameters."""

from __future__ import annotations

from collections.abc import Sequence

from ..ir import fresh
from .kernels import Option

__all__ = ["gradient_option", "names_tuple"]


def gradient_option(names: Sequence[str]) -> Option:
    """The keyword `gradient` of a function with these parameters."""
    return Option(
        fresh("gradient", names),
        "bool",
        "False",
        "bool, optional",
        "Whether the derivatives by every parameter are returned as well, as name -> derivative.",
    )


def names_tuple(names: Sequence[str]) -> str:
    """Names as a tuple in Python text."""
    inner = ", ".join(f'"{name}"' for name in names)
    return f"({inner}{',' if len(names) == 1 else ''})"
