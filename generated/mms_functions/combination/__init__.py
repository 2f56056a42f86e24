# Emitted by mmsgen 0.1.0 from derivations/combination.py: change that, not this file.
"""combination: 6 cases by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import combination
    combination.Omega_is_omega_1_plus_omega_2_order_1

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "Omega_is_omega_1_plus_omega_2_order_1",
    "Omega_is_omega_1_plus_omega_2_order_2",
    "Omega_is_omega_2_minus_omega_1_order_1",
    "Omega_is_omega_2_minus_omega_1_order_2",
    "Omega_is_two_omega_1_and_omega_2_is_three_omega_1_order_1",
    "Omega_is_two_omega_1_order_2",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "Omega_is_omega_1_plus_omega_2_order_1": {
        "relation": "Omega = omega_1 + omega_2 + sigma",
        "kind": "sum combination",
        "order": 1,
        "coordinates": ("x", "y"),
        "unstable": None,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma - f_12*f_21/(4*omega_1*omega_2) is "
            "positive in an interval of the detuning if 4*f_12*f_21/(omega_1*omega_2) > 0"
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
    "Omega_is_omega_1_plus_omega_2_order_2": {
        "relation": "Omega = omega_1 + omega_2 + sigma",
        "kind": "sum combination",
        "order": 2,
        "coordinates": ("x", "y"),
        "unstable": None,
        "reason": (
            "the discriminant of Gamma**2 - I*Gamma*sigma - f_12*f_21/(4*omega_1*omega_2) is "
            "positive in an interval of the detuning if 4*f_12*f_21/(omega_1*omega_2) > 0"
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
    "Omega_is_omega_2_minus_omega_1_order_1": {
        "relation": "Omega = omega_2 - omega_1 + sigma",
        "kind": "difference combination",
        "order": 1,
        "coordinates": ("x", "y"),
        "unstable": None,
        "reason": (
            "the discriminant of Gamma**2 + I*Gamma*sigma + f_12*f_21/(4*omega_1*omega_2) is "
            "positive in an interval of the detuning if -4*f_12*f_21/(omega_1*omega_2) > 0"
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
    "Omega_is_omega_2_minus_omega_1_order_2": {
        "relation": "Omega = omega_2 - omega_1 + sigma",
        "kind": "difference combination",
        "order": 2,
        "coordinates": ("x", "y"),
        "unstable": None,
        "reason": (
            "the discriminant of Gamma**2 + I*Gamma*sigma + f_12*f_21/(4*omega_1*omega_2) is "
            "positive in an interval of the detuning if -4*f_12*f_21/(omega_1*omega_2) > 0"
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
    "Omega_is_two_omega_1_order_2": {
        "relation": "Omega = 2*omega_1 + sigma",
        "kind": "principal parametric",
        "order": 2,
        "coordinates": ("x",),
        "unstable": True,
        "reason": (
            "the discriminant of Gamma**2 + (-f_11 + omega_1*sigma)*(f_11 + "
            "omega_1*sigma)/(4*omega_1**2) is positive in an interval of the detuning"
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
    "Omega_is_two_omega_1_and_omega_2_is_three_omega_1_order_1": {
        "relation": "Omega = 2*omega_1 + sigma_1 and omega_2 = 3*omega_1 + sigma_2",
        "kind": "principal parametric and as given",
        "order": 1,
        "coordinates": ("x", "y"),
        "unstable": None,
        "reason": (
            "the signs of the coefficients and of the discriminant in Gamma^2 of Gamma**4 + "
            "Gamma**2*(-f_11**2/4 + f_12*f_21/6 + 5*omega_1**2*sigma_1**2/2 - "
            "3*omega_1**2*sigma_1*sigma_2 + omega_1**2*sigma_2**2)/omega_1**2 + "
            "(-9*f_11*omega_1*sigma_1 + 6*f_11*omega_1*sigma_2 - f_12*f_21 + "
            "9*omega_1**2*sigma_1**2 - 6*omega_1**2*sigma_1*sigma_2)*(9*f_11*omega_1*sigma_1 - "
            "6*f_11*omega_1*sigma_2 - f_12*f_21 + …"
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
}


def __getattr__(name: str) -> ModuleType:
    if name in CASES:
        from importlib import import_module

        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"{__name__} has no case {name!r}; it has {', '.join(CASES)}")


def __dir__() -> list[str]:
    return ["CASES", *CASES]
