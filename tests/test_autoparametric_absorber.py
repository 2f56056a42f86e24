"""The pendulum absorber: what is emitted against the printed formulas of saturation."""

from __future__ import annotations

import math
from cmath import exp

import numpy as np
import pytest
from entries import certificates, demand_fits, demand_notebook, emitted

NAME = "autoparametric_absorber"
CASE = "omega_x_is_two_omega_p_and_Omega_is_omega_x"


@pytest.mark.pinned
def test_the_notebook_of_the_absorber() -> None:
    demand_notebook(NAME)


def test_certificates_of_the_absorber() -> None:
    found = certificates(NAME)
    assert sorted(found) == [f"{CASE}_order_{n}" for n in (1, 2)]
    for data in found.values():
        # generic values: no error term vanishes, and the next one is small beside it
        demand_fits(data, 0.1, points=["pitchfork", "saddle-node"])


@pytest.mark.parametrize("force", [0.02, 0.2])
def test_the_mass_is_held_whatever_the_force(force: float) -> None:
    """At perfect tuning a_x = Lμ_p/ω_p and a_θ² = (f − 4μ_xμ_p)/(rω_p²) are at rest."""
    values = {"L": 1.7, "r": 0.3, "omega_p": 0.9, "mu_x": 0.03, "mu_p": 0.02}
    a_x = values["L"] * values["mu_p"] / values["omega_p"]
    swing = (force - 4 * values["mu_x"] * values["mu_p"]) / values["r"]
    a_theta = math.sqrt(swing) / values["omega_p"]
    # the mass lags the force by a quarter; the pendulum so that it takes energy from the mass
    b = [a_x / 2 * exp(-0.5j * math.pi), a_theta / 2 * exp(0.5j * math.pi)]
    case = emitted(NAME, f"{CASE}_order_1")
    rest = [
        np.abs(case.slow_flow([b[0], turn * b[1]], f=force, sigma_1=0.0, sigma_2=0.0, **values))
        for turn in (1, exp(0.25j * math.pi), exp(0.5j * math.pi), exp(0.75j * math.pi))
    ]
    # one of the four phases, to rounding of numbers of order 0.1
    assert sorted(r.max() < 1e-15 for r in rest) == [False, False, False, True]
