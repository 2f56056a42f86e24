"""Free motion of a rotor that is stable: the notebook, and what it rests on."""

from __future__ import annotations

import numpy as np
import pytest
import rotor
from entries import ROOT, demand_notebook

import mmsgen as mg

NAME = "ground_resonance_response"
SHOWN = ("x_minus_omega_phi", "y_minus_omega_phi", "phi_minus_omega_x", "phi_minus_omega_y")


@pytest.mark.pinned
def test_the_notebook_is_that_of_the_script() -> None:
    demand_notebook(NAME)


def test_a_figure_for_each_case() -> None:
    for case in SHOWN:
        assert (ROOT / "docs" / "figures" / f"ground_resonance_free_omega_{case}.png").is_file()


def test_beats_of_the_exact_equations() -> None:
    """The exact frequencies of the isotropic rotor, by Floquet theory, tell the exact period.

    At exact resonance a change of sign of ε exchanges both frequencies, so that their difference is
    odd in ε: order 1 leaves out ε³ of it, and so does order 2, a relative ε².
    """
    alike = rotor.undamped(rotor.isotropic(rotor.helicopter(4).equations_of_motion()))
    eom = rotor.at_speed(rotor.in_ratios(alike.linearise()))
    scaled = eom.scale({rotor.r_m: 1, rotor.r_b: 1})
    relation = {rotor.Omega: rotor.omega_x - rotor.omega_phi}
    values = {**rotor.paper_values(eom), "omega_phi": 9.5}
    values["Omega"] = values["omega_x"] - values["omega_phi"]
    flows = [scaled.expand(order, relation).slow_flow for order in (1, 2)]
    errors: dict[int, list[float]] = {1: [], 2: []}
    for halvings in (2, 3, 4):
        small = {**values, "r_m": values["r_m"] / 2**halvings, "r_b": values["r_b"] / 2**halvings}
        turns = np.asarray(mg.floquet.multipliers(eom, small).value)
        # In the fuselage's frame both frequencies lie beside ω_x, at ±√R/2.
        angles = np.angle(turns * np.exp(-1j * values["omega_x"] * 2 * np.pi / values["Omega"]))
        rates = angles * values["Omega"] / (2 * np.pi)
        for flow in flows:
            known = {p.name for p in flow.case.parameters}
            own = {k: v for k, v in small.items() if k in known}
            frequency = 2 * np.pi / flow.beating(own, np.eye(6)[0]).period[0]
            above = rates[np.argmin(np.abs(rates - frequency / 2))]
            below = rates[np.argmin(np.abs(rates + frequency / 2))]
            errors[flow.case.order].append(abs((above - below) / frequency - 1))
    for own_errors in errors.values():
        slopes = np.log2(np.array(own_errors[:-1]) / own_errors[1:])
        # What follows is smaller by ε², 1e-3 of it here.
        assert slopes == pytest.approx(2.0, abs=0.01)
