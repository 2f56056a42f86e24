# Emitted by mmsgen 0.1.0 from derivations/centrifugal_pendulum.py: change that, not this file.
"""centrifugal_pendulum: 2 cases by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import centrifugal_pendulum
    centrifugal_pendulum.nu_is_omega_p_order_2

Source: Newland, J. Engineering for Industry 86 (1964) 257-263
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "nu_is_omega_p_order_2",
    "nu_is_omega_p_order_4",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "nu_is_omega_p_order_2": {
        "relation": "nu = omega_p + sigma",
        "kind": "primary",
        "order": 2,
        "coordinates": ("phi",),
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
    "nu_is_omega_p_order_4": {
        "relation": "nu = omega_p + sigma",
        "kind": "primary",
        "order": 4,
        "coordinates": ("phi",),
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
