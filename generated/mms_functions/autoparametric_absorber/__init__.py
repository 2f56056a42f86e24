# Emitted by mmsgen 0.1.0 from derivations/autoparametric_absorber.py: change that, not this file.
"""autoparametric_absorber: 2 cases by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import autoparametric_absorber
    autoparametric_absorber.omega_x_is_two_omega_p_and_Omega_is_omega_x_order_1

Source: Haxton and Barr, J. Engineering for Industry 94 (1972) 119-125
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "omega_x_is_two_omega_p_and_Omega_is_omega_x_order_1",
    "omega_x_is_two_omega_p_and_Omega_is_omega_x_order_2",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "omega_x_is_two_omega_p_and_Omega_is_omega_x_order_1": {
        "relation": "omega_x = 2*omega_p + sigma_1 and Omega = omega_x + sigma_2",
        "kind": "internal 2:1 and primary",
        "order": 1,
        "coordinates": ("x", "theta"),
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
    "omega_x_is_two_omega_p_and_Omega_is_omega_x_order_2": {
        "relation": "omega_x = 2*omega_p + sigma_1 and Omega = omega_x + sigma_2",
        "kind": "internal 2:1 and primary",
        "order": 2,
        "coordinates": ("x", "theta"),
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
