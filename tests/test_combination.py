"""Combination resonances: emitted edges against formulas in print, and with damping."""

from __future__ import annotations

import numpy as np
import pytest
from certify_systems import Omega, kappa, omega_1, omega_2
from entries import certificates, demand_notebook, emitted
from sympy import cos, symbols
from systems import d, equations, t, x, y

import mmsgen as mg

PAIR = {"omega_1": 1.3, "omega_2": 2.9, "f_11": 0.17, "f_22": -0.23}
MODULES = ("Omega_is_omega_1_plus_omega_2", "Omega_is_omega_2_minus_omega_1")


@pytest.mark.pinned
def test_the_notebook_of_combination_resonances() -> None:
    demand_notebook("combination")


def test_certificates_of_combination_resonances() -> None:
    found = certificates("combination")
    assert set(found) == {
        *(f"{module}_order_{order}" for module in MODULES for order in (1, 2)),
        "Omega_is_two_omega_1_order_2",
        "Omega_is_two_omega_1_and_omega_2_is_three_omega_1_order_1",
    }
    for data in found.values():
        for fit in data["fits"]:
            assert fit["theory"] == data["order"] + 1
            # generic values, so that no error term vanishes
            assert abs(float(fit["fitted"]) - fit["theory"]) < 0.1


@pytest.mark.parametrize(("module", "sign"), list(zip(MODULES, (1, -1), strict=True)))
def test_edges_in_print(module: str, sign: int) -> None:
    """Nayfeh and Mook (1979), chapter 5."""
    case = emitted("combination", f"{module}_order_1")
    f_12, f_21 = np.array([0.3, -0.3, 0.7]), np.array([0.5, 0.5, 0.1])
    with np.errstate(invalid="ignore"):
        half = np.sqrt(sign * f_12 * f_21 / (PAIR["omega_1"] * PAIR["omega_2"]))
    names = {"omega_1": PAIR["omega_1"], "omega_2": PAIR["omega_2"]}
    edges = case.boundaries(**names, f_12=f_12, f_21=f_21)
    # rounding of a few operations; no zone where the root is not real
    np.testing.assert_allclose(edges, (-half, half), rtol=1e-14)


@pytest.mark.parametrize(("module", "sign"), list(zip(MODULES, (1, -1), strict=True)))
def test_order_2_against_exponents_of_the_exact_equations(module: str, sign: int) -> None:
    """The centre of the zone, found by bisection on Floquet's growth, but for O(ε³)."""
    f_11, f_12, f_21, f_22 = symbols("f_11 f_12 f_21 f_22", real=True)
    c = 2 * cos(Omega * t)
    left = [
        d(x, 2) + omega_1**2 * x + c * (f_11 * x + f_12 * y),
        d(y, 2) + omega_2**2 * y + c * (f_21 * x + f_22 * y),
    ]
    eom = equations(left, [x, y])
    gaps = []
    for epsilon in (0.2, 0.1):
        values = {k: v if "omega" in k else epsilon * v for k, v in PAIR.items()}
        values |= {"f_12": 0.5 * epsilon, "f_21": sign * 0.4 * epsilon}
        edges = np.array(emitted("combination", f"{module}_order_2").boundaries(**values))
        centre = values["omega_2"] + sign * values["omega_1"] + edges
        width = float(np.ptp(edges))
        found = mg.floquet.boundary(
            eom, values, Omega, (centre[0] - width, centre[1] + width), points=20
        )
        gaps.append(np.abs(centre - found.zones[0]).max())
    # the next term is smaller by ε; an error of order 2 would give the power 2
    assert np.log2(gaps[0] / gaps[1]) > 2.8


def test_a_little_damping_of_one_mode_widens_the_zone() -> None:
    left = [
        d(x, 2) + 2 * kappa * d(x) + x,
        d(y, 2) + 2 * kappa * d(y) / 9 + 4 * y,
    ]
    c = 2 * cos(Omega * t) / 10
    eom = equations([left[0] + c * y, left[1] + c * x], [x, y])
    found = mg.floquet.boundary(eom, {"kappa": 0.009}, Omega, (2.8, 3.2), points=41)
    ((low, high),) = found.zones
    # σ² = (μ_1 + μ_2)²/(4 μ_1 μ_2) (f²/ω_1ω_2 − 4 μ_1 μ_2), an error of order ε² in relation
    expected = 0.01 * np.sqrt((0.01 / 2) / (4 * 9e-6) - 1)
    assert (high - low) / 2 == pytest.approx(expected, rel=0.02)
    assert (high - low) / 2 > 1.5 * 0.1 / np.sqrt(2)
