"""Docstrings of emitted modules and functions, in NumPy's style."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable

from ..parameters import Parameter
from .kernels import EmittedFunction
from .numpy_target import LINE_LENGTH
from .setting import Setting

__all__ = ["function_docstring", "module_docstring", "origin", "paragraph"]

_DOMAIN = {"positive": "> 0", "nonnegative": ">= 0", "negative": "< 0", "real": "real"}


def domain_of(parameter: Parameter) -> str:
    """The domain that a symbol's assumptions give."""
    if parameter.symbol.is_positive:
        return "positive"
    if parameter.symbol.is_nonnegative:
        return "nonnegative"
    return "negative" if parameter.symbol.is_negative else "real"


def paragraph(text: str, indent: int, hanging: int = 0) -> str:
    """Text filled to the line length."""
    pad = " " * indent
    # Backslashes and quotes of a user's meaning must not end or change the docstring.
    plain = text.replace("\\", "\\\\").replace('"""', "'''")
    return textwrap.fill(
        plain,
        LINE_LENGTH,
        initial_indent=pad,
        subsequent_indent=pad + " " * hanging,
        break_long_words=False,
        break_on_hyphens=False,
    )


def origin(version: str, derivation: str) -> str:
    """The first comment of a file, in as many lines as it needs."""
    return textwrap.fill(
        f"Emitted by mmsgen {version} from {derivation}: change that, not this file.",
        LINE_LENGTH,
        initial_indent="# ",
        subsequent_indent="# ",
        break_long_words=False,
        break_on_hyphens=False,
    )


def _short(text: str, limit: int = 600) -> str:
    """A text that may contain a whole polynomial, cut where it becomes unreadable."""
    return text if len(text) <= limit else text[:limit].rsplit(" ", 1)[0] + " …"


def module_docstring(setting: Setting, model: str, source: str) -> str:
    """What the module is, of which relation and order, from where."""
    relations = " and ".join(setting.relations) or "no resonance"
    parts = [
        _title(f"{model}: {relations}, order {setting.case.order}."),
        paragraph(
            "Modulation of the amplitudes A_j in q_j = A_j exp(i ω_j t) + c.c. + …, by the method "
            f"of multiple scales through order {setting.case.order} in ε, of "
            f"{', '.join(setting.coordinates)}. Results are written at ε = 1.",
            0,
        ),
        paragraph(_verdict(setting), 0),
    ]
    if setting.poles:
        parts.append(
            paragraph(
                "NaN comes from formulas in which a divisor vanishes: growth rates, edges, "
                "equilibria, stability. One that does not contain it stays finite there; but it is "
                "a further resonance, which this case knows nothing of, and a case of its own: "
                f"{', '.join(setting.poles)}.",
                0,
            )
        )
    if setting.no_boundary:
        parts.append(paragraph(f"No boundaries are emitted: {_short(setting.no_boundary)}.", 0))
    if source:
        parts.append(paragraph(f"Source: {source}", 0))
    return "\n\n".join(parts) + "\n"


def _title(text: str) -> str:
    lines = paragraph(text, 0).split("\n")
    if len(lines[0]) > LINE_LENGTH - 3:
        lines[0] = lines[0][: LINE_LENGTH - 4] + "…"
    return lines[0] if len(lines) == 1 else lines[0] + "\n\n" + "\n".join(lines[1:])


def _verdict(setting: Setting) -> str:
    words = {True: "It can be unstable", False: "It cannot be unstable", None: "Stability depends"}
    return f"{words[setting.unstable]}: {_short(setting.reason)}."


def function_docstring(function: EmittedFunction, setting: Setting) -> str:
    """Summary, formula's meaning, parameters with units, result, errors."""
    lines = [f'    """{function.summary}', ""]
    if function.description:
        lines += [paragraph(function.description, 4), ""]
    if function.leading or function.arguments or function.options:
        lines += ["    Parameters", "    ----------"]
    for name, meaning in function.leading:
        lines += [f"    {name} : array_like", paragraph(meaning, 8)]
    for parameter in function.arguments:
        lines += [f"    {parameter.name} : array_like", paragraph(_about(parameter), 8)]
    for option in function.options:
        lines += [f"    {option.name} : {option.kind}", paragraph(option.meaning, 8)]
    if lines[-1]:
        lines.append("")
    lines += ["    Returns", "    -------", *_result(function)]
    if function.leading or function.arguments:
        lines += ["", "    Raises", "    ------", "    ValueError", paragraph(_RAISES, 8)]
    return "\n".join((*lines, '    """'))


_RAISES = "If a value is not a finite real number in the domain given above; it is named."


def _about(parameter: Parameter) -> str:
    unit = "" if parameter.unit == "1" else f", {parameter.unit}"
    meaning = parameter.meaning or "parameter of the model"
    return f"{meaning[0].upper()}{meaning[1:]}{unit}, {_DOMAIN[domain_of(parameter)]}."


def _result(function: EmittedFunction) -> Iterable[str]:
    if function.result.startswith("lower, upper: "):
        text = function.result.removeprefix("lower, upper: ")
        return ["    lower, upper : float64", paragraph(text[0].upper() + text[1:], 8)]
    kind = function.kind or ("complex128" if "complex" in function.returns else "float64")
    return [f"    {kind}", paragraph(function.result, 8)]
