"""The text of a model's `__init__`: the table of its cases, which are imported when used."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from string import Template

from .._version import __version__
from .case_module import fill
from .docstrings import origin
from .kernels import EmittedFunction
from .setting import Setting

__all__ = ["PACKAGE_TEXT", "model_text"]

PACKAGE_TEXT = '''\
"""Functions emitted by mmsgen: a subpackage for each model, in it a module for each case.

Importing needs NumPy alone.
"""
'''

_MODEL = Template('''\
$origin
"""$model: $count by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from $package import $model
    $model.$first
$source"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
$exported
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
$cases
}


def __getattr__(name: str) -> ModuleType:
    if name in CASES:
        from importlib import import_module

        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"{__name__} has no case {name!r}; it has {', '.join(CASES)}")


def __dir__() -> list[str]:
    return ["CASES", *CASES]
''')

_REASON = 400


def model_text(
    cases: Sequence[tuple[Setting, Sequence[EmittedFunction]]],
    kinds: Mapping[str, tuple[str, tuple[str, ...]]],
    package: str,
    model: str,
    derivation: str,
    source: str,
) -> str:
    """The text of `<model>/__init__.py`."""
    entries = [(setting.name, setting, functions) for setting, functions in cases]
    first = entries[0][0]
    exported = ["CASES", *sorted(name for name, _, _ in entries)]
    note = f"\n{textwrap.fill('Source: ' + source, 100)}\n" if source else ""
    count = f"{len(entries)} case{'' if len(entries) == 1 else 's'}"
    keys = {
        "origin": origin(__version__, derivation),
        "model": model,
        "package": package,
        "count": count,
        "first": first,
        "source": note.replace("\\", "\\\\").replace('"""', "'''"),
        "exported": "\n".join(f"    {_quoted(name)}," for name in exported),
        "cases": "\n".join(_entry(name, setting, fs, kinds[name]) for name, setting, fs in entries),
    }
    return fill(_MODEL, keys)


def _entry(
    name: str,
    setting: Setting,
    functions: Sequence[EmittedFunction],
    kind: tuple[str, tuple[str, ...]],
) -> str:
    rows = [
        ("relation", _words(" and ".join(setting.relations) or "no resonance")),
        ("kind", _quoted(kind[0])),
        ("order", str(setting.case.order)),
        ("coordinates", _strings(kind[1])),
        ("unstable", str(setting.unstable)),
        ("reason", _words(setting.reason)),
        ("functions", _strings([f.name for f in functions])),
    ]
    inner = "\n".join(f"        {_quoted(key)}: {text}," for key, text in rows)
    return f"    {_quoted(name)}: {{\n{inner}\n    }},"


def _strings(items: Sequence[str]) -> str:
    texts = [_quoted(item) for item in items]
    line = f"({', '.join(texts)}{',' if len(texts) == 1 else ''})"
    if len(line) <= 74:
        return line
    return "(\n" + "\n".join(f"            {text}," for text in texts) + "\n        )"


def _words(text: str) -> str:
    """A string, in several pieces where it is long; very long formulas are cut."""
    if len(text) > _REASON:
        text = text[:_REASON].rsplit(" ", 1)[0] + " …"
    pieces = textwrap.wrap(text, 84, drop_whitespace=False, break_on_hyphens=False)
    if len(pieces) == 1:
        pieces = [text]
    if len(pieces) == 1 and len(text) <= 76:
        return _quoted(text)
    return "(\n" + "\n".join(f"            {_quoted(piece)}" for piece in pieces) + "\n        )"


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", " ") + '"'
