# Emitted by mmsgen 0.1.0 from derivations/helmholtz_duffing_forced.py: change that, not this file.
"""helmholtz_duffing_forced: 4 cases by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import helmholtz_duffing_forced
    helmholtz_duffing_forced.two_Omega_is_omega_0_order_1

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 4
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "Omega_is_two_omega_0_order_1",
    "Omega_is_two_omega_0_order_2",
    "two_Omega_is_omega_0_order_1",
    "two_Omega_is_omega_0_order_2",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "two_Omega_is_omega_0_order_1": {
        "relation": "2*Omega = omega_0 + sigma",
        "kind": "superharmonic 2",
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
    "two_Omega_is_omega_0_order_2": {
        "relation": "2*Omega = omega_0 + sigma",
        "kind": "superharmonic 2",
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
    "Omega_is_two_omega_0_order_1": {
        "relation": "Omega = 2*omega_0 + sigma",
        "kind": "subharmonic 1/2",
        "order": 1,
        "coordinates": ("u",),
        "unstable": None,
        "reason": (
            "Gamma**2 + 2*Gamma*mu + (-K**2*alpha_2**2/36 + mu**2*omega_0**6 + "
            "omega_0**6*sigma**2/4)/omega_0**6 is damped, and unstable near resonance if "
            "-4*(-K*alpha_2 + 6*mu*omega_0**3)*(K*alpha_2 + 6*mu*omega_0**3)/(9*omega_0**6) > 0"
        ),
        "functions": (
            "growth_rate",
            "boundaries",
            "critical_speeds",
            "slow_flow_matrix",
            "characteristic_coefficients",
            "slow_flow",
            "evolution",
            "beating",
            "response",
            "initial_amplitudes",
        ),
    },
    "Omega_is_two_omega_0_order_2": {
        "relation": "Omega = 2*omega_0 + sigma",
        "kind": "subharmonic 1/2",
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
}


def __getattr__(name: str) -> ModuleType:
    if name in CASES:
        from importlib import import_module

        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"{__name__} has no case {name!r}; it has {', '.join(CASES)}")


def __dir__() -> list[str]:
    return ["CASES", *CASES]
