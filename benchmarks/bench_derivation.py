"""How long derivations take: from the Lagrangian, and from the scaled equations on.

A case is taken to its end: solvability conditions as expressions, slow flow, characteristic
polynomial, verdict and boundary. Records cache what they have derived, so every round begins with
new equations of motion.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "derivations"))
import rotor

SUMS_AND_DIFFERENCES = [
    {rotor.Omega: sign_fuselage * fuselage + sign_blade * rotor.omega_phi}
    for fuselage in (rotor.omega_x, rotor.omega_y)
    for sign_fuselage, sign_blade in ((1, 1), (1, -1), (-1, 1))
]


def rotor_equations(N_b: int = 4) -> mg.EquationsOfMotion:
    model = rotor.helicopter(N_b)
    eom = rotor.undamped(rotor.isotropic(model.equations_of_motion())).linearise()
    return rotor.at_speed(rotor.in_ratios(eom))


def solve(eom: mg.EquationsOfMotion, relation: dict[Any, Any], order: int) -> Any:
    fresh = mg.EquationsOfMotion(eom.equations, eom.coordinates, eom.parameters)
    case = fresh.scale({rotor.r_m: 1, rotor.r_b: 1}).expand(order, relation)
    flow = case.slow_flow
    return case.solvability, flow.stability.reason, flow.boundary()


def solve_all(eom: mg.EquationsOfMotion, order: int) -> list[Any]:
    return [solve(eom, relation, order) for relation in SUMS_AND_DIFFERENCES]


def test_rotor_equations_from_the_lagrangian(benchmark: Any) -> None:
    assert len(benchmark(rotor_equations).equations) == 6


@pytest.mark.parametrize("order", [1, 2])
def test_rotor_all_cases(benchmark: Any, order: int) -> None:
    eom = rotor_equations()
    results = benchmark(solve_all, eom, order)
    assert sum(bool(edges) for _, _, edges in results) == 2


@pytest.mark.parametrize("order", [1, 2])
def test_rotor_all_cases_from_the_lagrangian(benchmark: Any, order: int) -> None:
    results = benchmark(lambda: solve_all(rotor_equations(), order))
    assert sum(bool(edges) for _, _, edges in results) == 2


def test_rotor_order_4(benchmark: Any) -> None:
    eom = rotor_equations()

    def run() -> Any:
        fresh = mg.EquationsOfMotion(eom.equations, eom.coordinates, eom.parameters)
        scaled = fresh.scale({rotor.r_m: 1, rotor.r_b: 1})
        case = scaled.expand(4, {rotor.Omega: rotor.omega_x + rotor.omega_phi})
        return case.solvability, case.slow_flow.matrix

    conditions, _ = benchmark(run)
    assert len(conditions) == 4


def test_duffing_order_5(benchmark: Any) -> None:
    t = dynamicsymbols._t
    q = dynamicsymbols("q")
    omega, alpha = sp.symbols("omega alpha", positive=True)
    potential = omega**2 * q**2 / 2 + alpha * q**4 / 4
    model = mg.Model(q.diff(t) ** 2 / 2 - potential, [q], [omega, alpha])
    eom = model.equations_of_motion()

    def run() -> Any:
        fresh = mg.EquationsOfMotion(eom.equations, eom.coordinates, eom.parameters)
        return fresh.scale({alpha: 1}).expand(5).solvability

    assert len(benchmark(run)) == 5
