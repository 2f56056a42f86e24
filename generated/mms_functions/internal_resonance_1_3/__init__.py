# Emitted by mmsgen 0.1.0 from derivations/internal_resonance_1_3.py: change that, not this file.
"""internal_resonance_1_3: 5 cases by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import internal_resonance_1_3
    internal_resonance_1_3.omega_2_is_three_omega_1_order_2

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 6
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "omega_2_is_three_omega_1_and_Omega_is_omega_1_order_1",
    "omega_2_is_three_omega_1_and_Omega_is_omega_1_order_2",
    "omega_2_is_three_omega_1_and_Omega_is_omega_2_order_1",
    "omega_2_is_three_omega_1_and_Omega_is_omega_2_order_2",
    "omega_2_is_three_omega_1_order_2",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "omega_2_is_three_omega_1_order_2": {
        "relation": "omega_2 = 3*omega_1 + sigma",
        "kind": "internal 3:1",
        "order": 2,
        "coordinates": ("u_1", "u_2"),
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
    "omega_2_is_three_omega_1_and_Omega_is_omega_2_order_1": {
        "relation": "omega_2 = 3*omega_1 + sigma_1 and Omega = omega_2 + sigma_2",
        "kind": "internal 3:1 and primary",
        "order": 1,
        "coordinates": ("u_1", "u_2"),
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
    "omega_2_is_three_omega_1_and_Omega_is_omega_2_order_2": {
        "relation": "omega_2 = 3*omega_1 + sigma_1 and Omega = omega_2 + sigma_2",
        "kind": "internal 3:1 and primary",
        "order": 2,
        "coordinates": ("u_1", "u_2"),
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
    "omega_2_is_three_omega_1_and_Omega_is_omega_1_order_1": {
        "relation": "omega_2 = 3*omega_1 + sigma_1 and Omega = omega_1 + sigma_2",
        "kind": "internal 3:1 and primary",
        "order": 1,
        "coordinates": ("u_1", "u_2"),
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
    "omega_2_is_three_omega_1_and_Omega_is_omega_1_order_2": {
        "relation": "omega_2 = 3*omega_1 + sigma_1 and Omega = omega_1 + sigma_2",
        "kind": "internal 3:1 and primary",
        "order": 2,
        "coordinates": ("u_1", "u_2"),
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
