"""Blade dampers that are not linear: the notebook, and the limit cycles in closed form."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
import rotor
import sympy as sp
from entries import certificates, demand_notebook, emitted

from mmsgen.runtime._flow import rates, spectrum
from mmsgen.slowflow import SlowFlow

NAME = "ground_resonance_nonlinear"
CASE = "Omega_is_omega_x_plus_omega_phi_order_2"
VALUES = {
    **{n: rotor.PAPER_VALUES[n] for n in ("r_m", "r_b", "r_a", "omega_x", "omega_y")},
    **{"omega_phi": 11.0, "mu_x": 0.5, "mu_y": 0.4, "mu_b": 0.3},
    **{"mu_2": 0.5, "mu_3": 0.1, "kappa": 90.0},
}


def slow_flow(blades: int) -> SlowFlow:
    model = rotor.with_nonlinear_hinges(rotor.helicopter(blades))
    eom = rotor.at_speed(rotor.in_ratios(rotor.isotropic(model.equations_of_motion())))
    orders = {**dict.fromkeys(["r_m", "r_b", "mu_x", "mu_y", "mu_b"], 2), "mu_2": 1}
    scaled = eom.scale(orders, amplitude=1)
    return scaled.expand(2, {rotor.Omega: rotor.omega_x + rotor.omega_phi}).slow_flow


@pytest.mark.pinned
def test_the_notebook_is_that_of_the_script() -> None:
    demand_notebook(NAME)


def test_certificate() -> None:
    (found,) = certificates(NAME).values()
    assert [fit["theory"] for fit in found["fits"]] == [2]


@pytest.mark.parametrize("blades", [3, 5])
def test_limit_cycles_are_waves_round_the_rotor(blades: int) -> None:
    """σ = w ± (μ_x + h)√(g²/μ_x h − 1), put into the whole slow flow of another rotor."""
    flow, v = slow_flow(blades), VALUES
    size, omega = 0.13, v["omega_phi"]
    h = v["mu_b"] + 4 * v["mu_2"] * omega * size / (3 * np.pi)
    h += 3 * v["mu_3"] * omega**2 * size**2 / 8
    softening = v["r_a"] ** 2 * (v["omega_x"] + omega) ** 2 / 6
    w = 3 * (v["kappa"] - softening) * size**2 / (8 * omega)
    coupling = blades * v["r_m"] * v["r_b"] * v["omega_x"] ** 3 / (16 * omega)
    for sign in (-1, 1):
        gap = sign * (v["mu_x"] + h) * np.sqrt(coupling / (v["mu_x"] * h) - 1)
        drift = v["mu_x"] * gap / (v["mu_x"] + h)
        body = blades * v["r_m"] * v["omega_x"] / 4 * size / 2 / (v["mu_x"] + 1j * drift)
        turns = np.exp(2j * np.pi * np.arange(blades) / blades)
        b = np.array([body, 0, *(size / 2 * turns)])
        c = flow.table.numbers({**v, "sigma": w + gap})
        along = np.array([1, 0, *[-1] * blades])
        # Rates are of size 0.1, and a dozen operations round each to 1e-16.
        assert rates(flow.table.flow, c, b) == pytest.approx(1j * drift * along * b, abs=1e-14)
        assert spectrum(flow.table.flow, c, b, [0, -drift])[0].real < 0


def test_emitted_damping_by_quadrature() -> None:
    """All blades turn alike: the mean of the moment over one period, beside the emitted rates.

    Quadrature between the kinks gives all 15 digits; rates of size 1 are rounded to 1e-15.
    """
    case = emitted(NAME, CASE)
    alone = {**VALUES, "mu_b": 0.0, "mu_x": 0.0, "mu_y": 0.0, "r_m": 1e-30, "r_b": 1e-30}
    del alone["omega_y"]  # no damping or force of this direction has it
    size, omega = 0.4, VALUES["omega_phi"]
    rate = case.slow_flow([0, 0, *[size / 2] * 4], **alone, sigma=0.0)[2:]
    speed = VALUES["omega_x"] + omega

    def moment(psi: mpmath.mpf) -> mpmath.mpf:
        angle, velocity = size * mpmath.cos(psi), -size * omega * mpmath.sin(psi)
        damping = VALUES["mu_2"] * velocity * abs(velocity) + VALUES["mu_3"] * velocity**3
        return damping + (VALUES["kappa"] - (VALUES["r_a"] * speed) ** 2 / 6) * angle**3

    half = [0, mpmath.pi / 2, mpmath.pi, 3 * mpmath.pi / 2, 2 * mpmath.pi]
    mean = mpmath.quad(lambda psi: moment(psi) * mpmath.expj(-psi), half) / (2 * mpmath.pi)
    assert rate == pytest.approx(np.full(4, complex(1j * mean / (2 * omega))), rel=1e-13)


def test_moments_of_the_hinges() -> None:
    """Over the inertia: κφ³ + μ_2 φ'|φ'| + μ_3 φ'³, and nothing else is new."""
    model = rotor.helicopter(3)
    plain, more = (
        rotor.in_ratios(rotor.isotropic(m.equations_of_motion()))
        for m in (model, rotor.with_nonlinear_hinges(model))
    )
    for q, old, new in zip(plain.coordinates, plain.equations, more.equations, strict=True):
        v = q.diff(rotor.time)
        moment = rotor.kappa * q**3 + rotor.mu_2 * v * sp.Abs(v) + rotor.mu_3 * v**3
        assert sp.expand(new - old - (moment if "phi" in str(q) else 0)) == 0
