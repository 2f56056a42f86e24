# Emitted by mmsgen 0.1.0 from derivations/ground_resonance_nonlinear.py: change that, not this
# file.
"""ground_resonance_nonlinear: 1 case by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import ground_resonance_nonlinear
    ground_resonance_nonlinear.Omega_is_omega_x_plus_omega_phi_order_2

Source: Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "Omega_is_omega_x_plus_omega_phi_order_2",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "Omega_is_omega_x_plus_omega_phi_order_2": {
        "relation": "Omega = omega_x + omega_phi + sigma",
        "kind": "sum combination",
        "order": 2,
        "coordinates": ("x", "phi_1", "phi_2", "phi_3", "phi_4"),
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
