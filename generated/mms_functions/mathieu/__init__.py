# Emitted by mmsgen 0.1.0 from derivations/mathieu.py: change that, not this file.
"""mathieu: 8 cases by the method of multiple scales.

CASES says what there is; a case is imported when it is used:

    from mms_functions import mathieu
    mathieu.omega_is_Omega_over_2_order_1

Source: Nayfeh and Mook, Nonlinear Oscillations (1979), chapter 5; NIST DLMF, section 28.6
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

__all__ = [
    "CASES",
    "nonresonant_order_4",
    "omega_is_Omega_order_2",
    "omega_is_Omega_order_4",
    "omega_is_Omega_over_2_order_1",
    "omega_is_Omega_over_2_order_2",
    "omega_is_Omega_over_2_order_4",
    "omega_is_three_Omega_over_2_order_3",
    "omega_is_three_Omega_over_2_order_4",
]

#: module name -> relation, kind, order, coordinates that it couples, whether the case can be
#: unstable (None: that depends on the parameters), why, and the functions of the module
CASES: dict[str, dict[str, Any]] = {
    "omega_is_Omega_over_2_order_1": {
        "relation": "omega = 1/2*Omega + sigma",
        "kind": "principal parametric",
        "order": 1,
        "coordinates": ("x",),
        "unstable": None,
        "reason": (
            "Gamma**2 + 2*Gamma*mu + (Omega**2*mu**2 + Omega**2*sigma**2 - q**2)/Omega**2 is "
            "damped, and unstable near resonance if -64*(Omega*mu - q)*(Omega*mu + q)/Omega**2 > "
            "0"
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
    "omega_is_Omega_over_2_order_2": {
        "relation": "omega = 1/2*Omega + sigma",
        "kind": "principal parametric",
        "order": 2,
        "coordinates": ("x",),
        "unstable": None,
        "reason": (
            "Gamma**2 + 2*Gamma*mu + (Omega**2*mu**2 + Omega**2*sigma**2 - q**2)/Omega**2 is "
            "damped, and unstable near resonance if -64*(Omega*mu - q)*(Omega*mu + q)/Omega**2 > "
            "0"
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
    "omega_is_Omega_over_2_order_4": {
        "relation": "omega = 1/2*Omega + sigma",
        "kind": "principal parametric",
        "order": 4,
        "coordinates": ("x",),
        "unstable": None,
        "reason": (
            "Gamma**2 + 2*Gamma*mu + (Omega**2*mu**2 + Omega**2*sigma**2 - q**2)/Omega**2 is "
            "damped, and unstable near resonance if -64*(Omega*mu - q)*(Omega*mu + q)/Omega**2 > "
            "0"
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
    "omega_is_Omega_order_2": {
        "relation": "omega = Omega + sigma",
        "kind": "parametric 1:1",
        "order": 2,
        "coordinates": ("x",),
        "unstable": None,
        "reason": (
            "a factor of degree 2 in Gamma is damped, and unstable near resonance if "
            "-16*(2*Omega**3*mu - q**2)*(2*Omega**3*mu + q**2)/Omega**6 > 0"
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
    "omega_is_Omega_order_4": {
        "relation": "omega = Omega + sigma",
        "kind": "parametric 1:1",
        "order": 4,
        "coordinates": ("x",),
        "unstable": None,
        "reason": (
            "a factor of degree 2 in Gamma is damped, and unstable near resonance if "
            "-16*(2*Omega**3*mu - q**2)*(2*Omega**3*mu + q**2)/Omega**6 > 0"
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
    "omega_is_three_Omega_over_2_order_3": {
        "relation": "omega = 3/2*Omega + sigma",
        "kind": "parametric 2:3",
        "order": 3,
        "coordinates": ("x",),
        "unstable": None,
        "reason": (
            "a factor of degree 2 in Gamma is damped, and unstable near resonance if "
            "-4*(12*Omega**5*mu - q**3)*(12*Omega**5*mu + q**3)/(9*Omega**10) > 0"
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
    "omega_is_three_Omega_over_2_order_4": {
        "relation": "omega = 3/2*Omega + sigma",
        "kind": "parametric 2:3",
        "order": 4,
        "coordinates": ("x",),
        "unstable": None,
        "reason": (
            "a factor of degree 2 in Gamma is damped, and unstable near resonance if "
            "-4*(12*Omega**5*mu - q**3)*(12*Omega**5*mu + q**3)/(9*Omega**10) > 0"
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
    "nonresonant_order_4": {
        "relation": "no resonance",
        "kind": "nonresonant",
        "order": 4,
        "coordinates": ("x",),
        "unstable": False,
        "reason": "one mode decays at the rate mu",
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
