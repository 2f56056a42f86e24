# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_1.py: change that, not this file.
"""internal_resonance_1_1: 3 cases by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import internal_resonance_1_1
    internal_resonance_1_1.omega_y_is_omega_x_order_2

Source: Miles, Quarterly of Applied Mathematics 20 (1962) 21-32
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "omega_y_is_omega_x_and_Omega_is_omega_x_order_2",
    "omega_y_is_omega_x_order_2",
    "omega_y_is_omega_x_order_4",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "omega_y_is_omega_x_order_2": {
        "relation": "omega_y = omega_x + sigma",
        "kind": "internal 1:1",
        "order": 2,
        "coordinates": ("x", "y"),
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
    "omega_y_is_omega_x_order_4": {
        "relation": "omega_y = omega_x + sigma",
        "kind": "internal 1:1",
        "order": 4,
        "coordinates": ("x", "y"),
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
    "omega_y_is_omega_x_and_Omega_is_omega_x_order_2": {
        "relation": "omega_y = omega_x + sigma_1 and Omega = omega_x + sigma_2",
        "kind": "internal 1:1 and primary",
        "order": 2,
        "coordinates": ("x", "y"),
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
