# Emitted by mmsgen 0.1.0 from derivations/duffing.py: change that, not this file.
"""duffing: 4 cases by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import duffing
    duffing.nonresonant_order_1

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 2
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "nonresonant_order_1",
    "nonresonant_order_2",
    "nonresonant_order_3",
    "nonresonant_order_4",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "nonresonant_order_1": {
        "relation": "no resonance",
        "kind": "nonresonant",
        "order": 1,
        "coordinates": ("u",),
        "unstable": None,
        "reason": "the slow flow is nonlinear or forced: its equilibria decide",
        "functions": (
            "slow_flow",
            "equilibria",
            "frequency_response",
            "backbone",
            "jacobian",
            "stability",
            "response",
            "initial_amplitudes",
        ),
    },
    "nonresonant_order_2": {
        "relation": "no resonance",
        "kind": "nonresonant",
        "order": 2,
        "coordinates": ("u",),
        "unstable": None,
        "reason": "the slow flow is nonlinear or forced: its equilibria decide",
        "functions": (
            "slow_flow",
            "equilibria",
            "frequency_response",
            "backbone",
            "jacobian",
            "stability",
            "response",
            "initial_amplitudes",
        ),
    },
    "nonresonant_order_3": {
        "relation": "no resonance",
        "kind": "nonresonant",
        "order": 3,
        "coordinates": ("u",),
        "unstable": None,
        "reason": "the slow flow is nonlinear or forced: its equilibria decide",
        "functions": (
            "slow_flow",
            "equilibria",
            "frequency_response",
            "backbone",
            "jacobian",
            "stability",
            "response",
            "initial_amplitudes",
        ),
    },
    "nonresonant_order_4": {
        "relation": "no resonance",
        "kind": "nonresonant",
        "order": 4,
        "coordinates": ("u",),
        "unstable": None,
        "reason": "the slow flow is nonlinear or forced: its equilibria decide",
        "functions": (
            "slow_flow",
            "equilibria",
            "frequency_response",
            "backbone",
            "jacobian",
            "stability",
            "response",
            "initial_amplitudes",
        ),
    },
}


def __getattr__(name: str) -> ModuleType:
    if name in CASES:
        from importlib import import_module

        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"{__name__} has no case {name!r}; it has {', '.join(CASES)}")


def __dir__() -> list[str]:
    return ["CASES", *CASES]
