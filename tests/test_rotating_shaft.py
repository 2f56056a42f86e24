"""A rotor with gyroscopic terms: emitted modes and edges against circles of whirl."""

from __future__ import annotations

import numpy as np
import pytest
from entries import certificates, demand_notebook, emitted

ROTOR = {
    "I_t": 1.3,
    "I_p": np.array([0.2, 0.9, 2.4]),
    "Omega_s": np.array([[2.1], [5.0]]),
    "k": 5.2,
}


@pytest.mark.pinned
def test_the_notebook_of_the_rotating_shaft() -> None:
    demand_notebook("rotating_shaft")


def test_certificates_of_the_rotating_shaft() -> None:
    found = certificates("rotating_shaft")
    assert len(found) == 8
    for data in found.values():
        assert data["passed"]
        for fit in data["fits"]:
            assert abs(float(fit["fitted"]) - (data["order"] + 1)) < 0.1


def test_whirl_frequencies() -> None:
    """I_t ω² ∓ I_pΩ_s ω − k = 0: forward and backward whirl."""
    modes = emitted("rotating_shaft", "nu_is_omega_1_plus_omega_2_order_1").modes(**ROTOR)
    turn = ROTOR["I_p"] * ROTOR["Omega_s"] / 1.3
    root = np.sqrt(turn**2 + 4 * 5.2 / 1.3)
    # backward stable eigenvalues of a matrix of four rows
    np.testing.assert_allclose(modes["omega_1"], (root - turn) / 2, rtol=1e-12)
    np.testing.assert_allclose(modes["omega_2"], (root + turn) / 2, rtol=1e-12)


def test_half_width_of_the_sum_combination() -> None:
    """κ/(2I_t(ω_1 + ω_2)), from the normalisation of circular modes."""
    case = emitted("rotating_shaft", "nu_is_omega_1_plus_omega_2_order_1")
    modes = case.modes(**ROTOR)
    low, high = case.boundaries(kappa=0.9, **modes)
    half = 0.9 / (2 * 1.3 * (modes["omega_1"] + modes["omega_2"]))
    np.testing.assert_allclose(high, half, rtol=1e-11)
    np.testing.assert_allclose(low, -half, rtol=1e-11)
