"""Reference values beside each case: 50 digits, from the symbolic result, not from emitted code."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import mpmath

from .._version import __version__
from .case_module import digest_of
from .kernels import EmittedFunction, Reference
from .modal import mode_points
from .points import points_of, speed_points_of
from .setting import Setting

__all__ = ["DIGITS", "STORED", "reference_text"]

#: decimal digits of the computation
DIGITS = 50

#: decimal digits that are stored
STORED = 25


def reference_text(setting: Setting, functions: Sequence[EmittedFunction]) -> str:
    """The JSON file of a case.

    For each function a list of points: ``time`` or ``amplitude``, and ``amplitudes``, where it
    takes them; ``arguments``;
    ``shape``; ``values``, real ones as decimal strings and complex ones as pairs of them, flat, the
    last axis fastest; ``errors``, bounds of the absolute error that the emitted formula makes in
    double precision, and of what is cut off. Those of ``equilibria`` are all amplitudes, whose
    shape is given, then all drifts, then the growth rates; points are left out at which there are
    infinitely many.
    """
    table: dict[str, list[dict[str, Any]]] = {}
    with mpmath.workdps(DIGITS):
        points = points_of(setting, functions)
        for function in functions:
            if function.reference is None:
                continue
            own = points
            if function.name == "critical_speeds":
                own = speed_points_of(setting, function)
            elif function.name == "modes":
                own = mode_points(function, len(points))
            found = [function.reference(point) for point in own]
            entries = [_entry(reference) for reference in found if reference is not None]
            if entries:
                table[function.name] = entries
    content = {
        "case": setting.name,
        "mmsgen": __version__,
        "sha256": digest_of(functions),
        "digits": STORED,
        "functions": table,
    }
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def _entry(reference: Reference) -> dict[str, Any]:
    amplitudes = {"amplitudes": [_argument(a) for a in reference.amplitudes]}
    return {
        **{name: _argument(value) for name, value in reference.first.items()},
        **(amplitudes if reference.amplitudes else {}),
        "arguments": {name: _argument(value) for name, value in reference.arguments.items()},
        "shape": list(reference.shape),
        "values": [_decimal(value) for value in reference.values],
        "errors": [
            mpmath.nstr(_upward(error + abs(value) * mpmath.mpf(10) ** (1 - STORED)), 2)
            if mpmath.isfinite(value)
            else "0.0"
            for value, error in zip(reference.values, reference.errors, strict=True)
        ],
    }


def _argument(value: Any) -> Any:
    if isinstance(value, mpmath.mpc):
        return [float(value.real), float(value.imag)]
    return float(value)


def _decimal(value: Any) -> Any:
    if isinstance(value, mpmath.mpc):
        return [_decimal(value.real), _decimal(value.imag)]
    return mpmath.nstr(mpmath.mpf(value), STORED)


def _upward(error: Any) -> Any:
    """A bound that is still one after rounding to two digits."""
    return mpmath.mpf(error) * mpmath.mpf("1.06")
