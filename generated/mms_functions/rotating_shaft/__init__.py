# Emitted by mmsgen 0.1.0 from derivations/rotating_shaft.py: change that, not this file.
"""rotating_shaft: 8 cases by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import rotating_shaft
    rotating_shaft.nu_is_omega_1_plus_omega_2_order_1

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; gyroscopic modes after
Meirovitch, AIAA Journal 12 (1974)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "nu_is_omega_1_plus_omega_2_order_1",
    "nu_is_omega_1_plus_omega_2_order_2",
    "nu_is_omega_2_minus_omega_1_order_1",
    "nu_is_omega_2_minus_omega_1_order_2",
    "nu_is_two_omega_1_order_1",
    "nu_is_two_omega_1_order_2",
    "nu_is_two_omega_2_order_1",
    "nu_is_two_omega_2_order_2",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "nu_is_omega_1_plus_omega_2_order_1": {
        "relation": "nu = omega_1 + omega_2 + sigma",
        "kind": "sum combination",
        "order": 1,
        "coordinates": ("eta_1", "eta_2"),
        "unstable": True,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma - "
            "Phi_alpha_1**2*Phi_alpha_2**2*kappa**2/(16*omega_1*omega_2) is positive in an "
            "interval of the detuning"
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
            "modes",
        ),
    },
    "nu_is_omega_1_plus_omega_2_order_2": {
        "relation": "nu = omega_1 + omega_2 + sigma",
        "kind": "sum combination",
        "order": 2,
        "coordinates": ("eta_1", "eta_2"),
        "unstable": True,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma - "
            "Phi_alpha_1**2*Phi_alpha_2**2*kappa**2/(16*omega_1*omega_2) is positive in an "
            "interval of the detuning"
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
            "modes",
        ),
    },
    "nu_is_two_omega_1_order_1": {
        "relation": "nu = 2*omega_1 + sigma",
        "kind": "principal parametric",
        "order": 1,
        "coordinates": ("eta_1",),
        "unstable": True,
        "reason": (
            "the discriminant of Gamma**2 - (Phi_alpha_1**2*kappa - "
            "2*omega_1*sigma)*(Phi_alpha_1**2*kappa + 2*omega_1*sigma)/(16*omega_1**2) is "
            "positive in an interval of the detuning"
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
            "modes",
        ),
    },
    "nu_is_two_omega_1_order_2": {
        "relation": "nu = 2*omega_1 + sigma",
        "kind": "principal parametric",
        "order": 2,
        "coordinates": ("eta_1",),
        "unstable": True,
        "reason": (
            "the discriminant of Gamma**2 - (Phi_alpha_1**2*kappa - "
            "2*omega_1*sigma)*(Phi_alpha_1**2*kappa + 2*omega_1*sigma)/(16*omega_1**2) is "
            "positive in an interval of the detuning"
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
            "modes",
        ),
    },
    "nu_is_two_omega_2_order_1": {
        "relation": "nu = 2*omega_2 + sigma",
        "kind": "principal parametric",
        "order": 1,
        "coordinates": ("eta_2",),
        "unstable": True,
        "reason": (
            "the discriminant of Gamma**2 - (Phi_alpha_2**2*kappa - "
            "2*omega_2*sigma)*(Phi_alpha_2**2*kappa + 2*omega_2*sigma)/(16*omega_2**2) is "
            "positive in an interval of the detuning"
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
            "modes",
        ),
    },
    "nu_is_two_omega_2_order_2": {
        "relation": "nu = 2*omega_2 + sigma",
        "kind": "principal parametric",
        "order": 2,
        "coordinates": ("eta_2",),
        "unstable": True,
        "reason": (
            "the discriminant of Gamma**2 - (Phi_alpha_2**2*kappa - "
            "2*omega_2*sigma)*(Phi_alpha_2**2*kappa + 2*omega_2*sigma)/(16*omega_2**2) is "
            "positive in an interval of the detuning"
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
            "modes",
        ),
    },
    "nu_is_omega_2_minus_omega_1_order_1": {
        "relation": "nu = omega_2 - omega_1 + sigma",
        "kind": "difference combination",
        "order": 1,
        "coordinates": ("eta_1", "eta_2"),
        "unstable": False,
        "reason": (
            "the discriminant of Gamma**2 + I*Gamma*sigma + "
            "Phi_alpha_1**2*Phi_alpha_2**2*kappa**2/(16*omega_1*omega_2) is negative at every "
            "detuning, the modes only exchange energy"
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
            "modes",
        ),
    },
    "nu_is_omega_2_minus_omega_1_order_2": {
        "relation": "nu = omega_2 - omega_1 + sigma",
        "kind": "difference combination",
        "order": 2,
        "coordinates": ("eta_1", "eta_2"),
        "unstable": False,
        "reason": (
            "the discriminant of Gamma**2 + I*Gamma*sigma + "
            "Phi_alpha_1**2*Phi_alpha_2**2*kappa**2/(16*omega_1*omega_2) is negative at every "
            "detuning, the modes only exchange energy"
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
            "modes",
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
