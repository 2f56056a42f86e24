# Emitted by mmsgen 0.1.0 from derivations/pendulum.py: change that, not this file.
"""pendulum: 4 cases by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import pendulum
    pendulum.Omega_is_two_omega_order_1

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapters 4 and 5
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "Omega_is_omega_order_2",
    "Omega_is_omega_order_3",
    "Omega_is_two_omega_order_1",
    "Omega_is_two_omega_order_2",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "Omega_is_two_omega_order_1": {
        "relation": "Omega = 2*omega + sigma",
        "kind": "principal parametric",
        "order": 1,
        "coordinates": ("theta",),
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
    "Omega_is_two_omega_order_2": {
        "relation": "Omega = 2*omega + sigma",
        "kind": "principal parametric",
        "order": 2,
        "coordinates": ("theta",),
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
    "Omega_is_omega_order_2": {
        "relation": "Omega = omega + sigma",
        "kind": "primary",
        "order": 2,
        "coordinates": ("theta",),
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
    "Omega_is_omega_order_3": {
        "relation": "Omega = omega + sigma",
        "kind": "primary",
        "order": 3,
        "coordinates": ("theta",),
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
