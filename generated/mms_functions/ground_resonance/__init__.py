# Emitted by mmsgen 0.1.0 from derivations/ground_resonance.py: change that, not this file.
"""ground_resonance: 17 cases by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import ground_resonance
    ground_resonance.Omega_is_omega_x_plus_omega_phi_order_1

Source: Sanches, Michon, Berlioz and Alazard (2014), doi 10.1016/j.ijnonlinmec.2014.04.003
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "Omega_is_omega_phi_minus_omega_x_order_1",
    "Omega_is_omega_phi_minus_omega_x_order_2",
    "Omega_is_omega_phi_minus_omega_y_order_1",
    "Omega_is_omega_phi_minus_omega_y_order_2",
    "Omega_is_omega_x_minus_omega_phi_order_1",
    "Omega_is_omega_x_minus_omega_phi_order_2",
    "Omega_is_omega_x_plus_omega_phi_and_omega_y_is_omega_x_order_1",
    "Omega_is_omega_x_plus_omega_phi_and_omega_y_is_omega_x_order_2",
    "Omega_is_omega_x_plus_omega_phi_order_1",
    "Omega_is_omega_x_plus_omega_phi_order_2",
    "Omega_is_omega_y_minus_omega_phi_order_1",
    "Omega_is_omega_y_minus_omega_phi_order_2",
    "Omega_is_omega_y_plus_omega_phi_order_1",
    "Omega_is_omega_y_plus_omega_phi_order_2",
    "nonresonant_order_1",
    "nonresonant_order_2",
    "omega_y_is_omega_x_order_2",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "Omega_is_omega_x_plus_omega_phi_order_1": {
        "relation": "Omega = omega_x + omega_phi + sigma",
        "kind": "sum combination",
        "order": 1,
        "coordinates": ("x", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": True,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma - omega_x**3*r_b*r_m/(4*omega_phi) is "
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
        ),
    },
    "Omega_is_omega_x_plus_omega_phi_order_2": {
        "relation": "Omega = omega_x + omega_phi + sigma",
        "kind": "sum combination",
        "order": 2,
        "coordinates": ("x", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": True,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma - omega_x**3*r_b*r_m/(4*omega_phi) is "
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
        ),
    },
    "Omega_is_omega_y_plus_omega_phi_order_1": {
        "relation": "Omega = omega_y + omega_phi + sigma",
        "kind": "sum combination",
        "order": 1,
        "coordinates": ("y", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": True,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma - omega_y**3*r_b*r_m/(4*omega_phi) is "
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
        ),
    },
    "Omega_is_omega_y_plus_omega_phi_order_2": {
        "relation": "Omega = omega_y + omega_phi + sigma",
        "kind": "sum combination",
        "order": 2,
        "coordinates": ("y", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": True,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma - omega_y**3*r_b*r_m/(4*omega_phi) is "
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
        ),
    },
    "Omega_is_omega_x_minus_omega_phi_order_1": {
        "relation": "Omega = omega_x - omega_phi + sigma",
        "kind": "difference combination",
        "order": 1,
        "coordinates": ("x", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": False,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma + omega_x**3*r_b*r_m/(4*omega_phi) is "
            "negative at every detuning, the modes only exchange energy; one mode turns without "
            "growing"
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
    "Omega_is_omega_x_minus_omega_phi_order_2": {
        "relation": "Omega = omega_x - omega_phi + sigma",
        "kind": "difference combination",
        "order": 2,
        "coordinates": ("x", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": False,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma + omega_x**3*r_b*r_m/(4*omega_phi) is "
            "negative at every detuning, the modes only exchange energy; one mode turns without "
            "growing"
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
    "Omega_is_omega_y_minus_omega_phi_order_1": {
        "relation": "Omega = omega_y - omega_phi + sigma",
        "kind": "difference combination",
        "order": 1,
        "coordinates": ("y", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": False,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma + omega_y**3*r_b*r_m/(4*omega_phi) is "
            "negative at every detuning, the modes only exchange energy; one mode turns without "
            "growing"
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
    "Omega_is_omega_y_minus_omega_phi_order_2": {
        "relation": "Omega = omega_y - omega_phi + sigma",
        "kind": "difference combination",
        "order": 2,
        "coordinates": ("y", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": False,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma + omega_y**3*r_b*r_m/(4*omega_phi) is "
            "negative at every detuning, the modes only exchange energy; one mode turns without "
            "growing"
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
    "Omega_is_omega_phi_minus_omega_x_order_1": {
        "relation": "Omega = omega_phi - omega_x + sigma",
        "kind": "difference combination",
        "order": 1,
        "coordinates": ("x", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": False,
        "reason": (
            "the discriminant of Gamma**2 + I*Gamma*sigma + omega_x**3*r_b*r_m/(4*omega_phi) is "
            "negative at every detuning, the modes only exchange energy; one mode turns without "
            "growing"
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
    "Omega_is_omega_phi_minus_omega_x_order_2": {
        "relation": "Omega = omega_phi - omega_x + sigma",
        "kind": "difference combination",
        "order": 2,
        "coordinates": ("x", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": False,
        "reason": (
            "the discriminant of Gamma**2 + I*Gamma*sigma + omega_x**3*r_b*r_m/(4*omega_phi) is "
            "negative at every detuning, the modes only exchange energy; one mode turns without "
            "growing"
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
    "Omega_is_omega_phi_minus_omega_y_order_1": {
        "relation": "Omega = omega_phi - omega_y + sigma",
        "kind": "difference combination",
        "order": 1,
        "coordinates": ("y", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": False,
        "reason": (
            "the discriminant of Gamma**2 + I*Gamma*sigma + omega_y**3*r_b*r_m/(4*omega_phi) is "
            "negative at every detuning, the modes only exchange energy; one mode turns without "
            "growing"
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
    "Omega_is_omega_phi_minus_omega_y_order_2": {
        "relation": "Omega = omega_phi - omega_y + sigma",
        "kind": "difference combination",
        "order": 2,
        "coordinates": ("y", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": False,
        "reason": (
            "the discriminant of Gamma**2 + I*Gamma*sigma + omega_y**3*r_b*r_m/(4*omega_phi) is "
            "negative at every detuning, the modes only exchange energy; one mode turns without "
            "growing"
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
    "Omega_is_omega_x_plus_omega_phi_and_omega_y_is_omega_x_order_1": {
        "relation": "Omega = omega_x + omega_phi + sigma_1 and omega_y = omega_x + sigma_2",
        "kind": "sum combination and internal 1:1",
        "order": 1,
        "coordinates": ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": None,
        "reason": (
            "the sign of the discriminant of Gamma**3 + I*Gamma**2*(-sigma_1 - sigma_2) + "
            "Gamma*(-omega_phi*sigma_1*sigma_2 - omega_x**3*r_b*r_m/2)/omega_phi + "
            "I*omega_x**3*r_b*r_m*sigma_2/(4*omega_phi), of degree 4, decides"
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
    "Omega_is_omega_x_plus_omega_phi_and_omega_y_is_omega_x_order_2": {
        "relation": "Omega = omega_x + omega_phi + sigma_1 and omega_y = omega_x + sigma_2",
        "kind": "sum combination and internal 1:1",
        "order": 2,
        "coordinates": ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": None,
        "reason": (
            "the sign of the discriminant of Gamma**3 + I*Gamma**2*(-sigma_1 - sigma_2) + "
            "Gamma*(-omega_phi*sigma_1*sigma_2 - omega_x**3*r_b*r_m/2)/omega_phi + "
            "I*omega_x**3*r_b*r_m*sigma_2/(4*omega_phi), of degree 6, decides"
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
    "omega_y_is_omega_x_order_2": {
        "relation": "omega_y = omega_x + sigma",
        "kind": "internal 1:1",
        "order": 2,
        "coordinates": ("x", "y"),
        "unstable": False,
        "reason": (
            "the discriminant of a factor of degree 2 in Gamma is negative at every detuning, the"
            " modes only exchange energy; one mode turns without growing"
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
    "nonresonant_order_1": {
        "relation": "no resonance",
        "kind": "nonresonant",
        "order": 1,
        "coordinates": ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": False,
        "reason": "one mode turns without growing",
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
    "nonresonant_order_2": {
        "relation": "no resonance",
        "kind": "nonresonant",
        "order": 2,
        "coordinates": ("x", "y", "phi_1", "phi_2", "phi_3", "phi_4"),
        "unstable": False,
        "reason": "one mode turns without growing",
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
}


def __getattr__(name: str) -> ModuleType:
    if name in CASES:
        from importlib import import_module

        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"{__name__} has no case {name!r}; it has {', '.join(CASES)}")


def __dir__() -> list[str]:
    return ["CASES", *CASES]
