"""The Duffing family: what is emitted against exact motions and printed formulas."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from entries import certificates, demand_notebook, emitted
from systems import Omega, beta, d, f, mu, omega, oscillator, t, x

import mmsgen as mg
from mmsgen.certify import scaled_values


@pytest.mark.pinned
@pytest.mark.parametrize(
    "name", ["duffing", "helmholtz_duffing", "duffing_forced", "helmholtz_duffing_forced"]
)
def test_notebooks(name: str) -> None:
    demand_notebook(name)


def test_certificates_of_the_free_oscillator() -> None:
    found = certificates("duffing")
    assert sorted(found) == [f"nonresonant_order_{n}" for n in (1, 2, 3, 4)]
    for data in found.values():
        (fit,) = data["fits"]
        assert fit["theory"] == data["order"]
        # ten per cent of the next term, at y = 5ε
        assert 0 < float(fit["fitted"]) - fit["theory"] < 0.2


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_frequency_against_the_elliptic_integral(order: int) -> None:
    """The error of the frequency at equal fundamental is c y^{N+1}, with the next coefficient.

    y = αa²/ω_0². At y = 1/70 the term after the next changes the ratio by less than 5 %; the error
    of order 4 is 1.6e-13, rounding 2e-16.
    """
    m = mp.mpf(1) / 140  # of the exact motion cn(·|m)
    big_y = 2 * m / (1 - 2 * m)
    quarter, nome = mp.ellipk(m), mp.qfrom(m=m)
    share = 2 * mp.pi / (mp.sqrt(m) * quarter) * mp.sqrt(nome) / (1 + nome)
    y = share**2 * big_y
    exact = float(mp.pi * mp.sqrt(1 + big_y) / (2 * quarter))
    omega_0, alpha = 1.7, 0.9
    a = float(mp.sqrt(y * omega_0**2 / alpha))
    case = emitted("duffing", f"nonresonant_order_{order}")
    rate = case.slow_flow([a / 2], omega_0=omega_0, alpha=alpha)[0] / (a / 2)
    assert rate.real == 0
    error = 1 + rate.imag / omega_0 - exact
    following = {1: -15 / 256, 2: 123 / 8192, 3: -921 / 262144, 4: 579 / 2097152}[order]
    assert -error / (following * float(y) ** (order + 1)) == pytest.approx(1, abs=0.05)


def test_emitted_backbones_in_print() -> None:
    """Nayfeh and Mook, chapters 2 and 4; rounding of a few dozen operations."""
    a = np.array([0.0, 0.3, 0.7])
    case = emitted("duffing", "nonresonant_order_4")
    y = 0.9 * a**2 / 1.7**2
    series = 3 * y / 8 - 15 * y**2 / 256 + 123 * y**3 / 8192 - 921 * y**4 / 262144
    assert case.backbone(a, omega_0=1.7, alpha=0.9) == pytest.approx(1.7 * series, rel=1e-13)
    case = emitted("helmholtz_duffing", "nonresonant_order_2")
    printed = (9 * -0.4 * 1.7**2 - 10 * 0.9**2) * a**2 / (24 * 1.7**3)
    found = case.backbone(a, omega_0=1.7, alpha_2=0.9, alpha_3=-0.4)
    assert found == pytest.approx(printed, rel=1e-13)
    case = emitted("duffing_forced", "Omega_is_three_omega_0_order_1")
    drift = -8.0 / (16 * 1.7**2)  # Λ
    printed = 9 * 0.9 * (drift**2 + a**2 / 8) / 1.7
    numbers = {"omega_0": 1.7, "alpha": 0.9, "K": 8.0}
    assert case.backbone(a, mu=0.1, **numbers) == pytest.approx(printed, rel=1e-13)


def test_certificates_of_the_other_oscillators() -> None:
    found = certificates("helmholtz_duffing")
    assert sorted(found) == ["nonresonant_order_2", "nonresonant_order_4"]
    found |= (forced := certificates("duffing_forced"))
    found |= (quadratic := certificates("helmholtz_duffing_forced"))
    assert len(forced) == 6 and len(quadratic) == 4
    for data in found.values():
        first, *steady = data["fits"]
        for fit in data["fits"]:
            better = fit["quantity"] in ("stability", "saddle-node")
            assert fit["theory"] == data["order"] + better
            assert abs(float(fit["fitted"]) - fit["theory"]) < 0.1
        assert first["quantity"] == "motions at times of order 1/ε"
        assert bool(steady) == (data in [*forced.values(), *quadratic.values()])
    for data in forced.values():
        kinds = [fit["quantity"] for fit in data["fits"][1:]]
        assert kinds == ["equilibrium amplitudes", "stability", "saddle-node"]


def test_quadratic_and_cubic_stiffness_in_print() -> None:
    """Nayfeh and Mook, chapter 2: Δω = (9α_3 ω_0² − 10α_2²)a²/(24ω_0³)."""
    values = {"omega_0": 1.7, "alpha_2": 0.9, "alpha_3": -0.4}
    case = emitted("helmholtz_duffing", "nonresonant_order_2")
    a = 0.37
    shift = case.slow_flow([a / 2], **values)[0] / (a / 2)
    printed = (9 * -0.4 * 1.7**2 - 10 * 0.9**2) * a**2 / (24 * 1.7**3)
    assert shift.real == 0
    assert shift.imag == pytest.approx(printed, rel=1e-14)  # rounding of a dozen operations


# --- forced ---------------------------------------------------------------------------------------

# Amplitudes of the subharmonic of order 1/3 at ω_0 = α = 1, μ = 0.05, K = 8, σ = 6, computed from
# the printed relation of Nayfeh and Mook, chapter 4, outside this program.
NUMBERS = {"omega_0": 1.0, "alpha": 1.0, "mu": 0.05, "K": 8.0, "sigma": 6.0}


@pytest.mark.parametrize("a", [2.39198687, 1.39465604])
def test_the_subharmonic_rests_at_the_printed_amplitudes(a: float) -> None:
    case = emitted("duffing_forced", "Omega_is_three_omega_0_order_1")
    # the phase from dγ/dt and da/dt = 0, with Λ = −K/16: |dB/dt| must vanish for one of them
    phases = np.linspace(0, 2 * np.pi / 3, 200001)
    rates = np.abs(case.slow_flow((a / 2 * np.exp(1j * phases))[:, None], **NUMBERS)[:, 0])
    # the grid of phases leaves 1e-5 of slopes of order one
    assert rates.min() < 3e-5
    others = np.abs(case.slow_flow((1.01 * a / 2 * np.exp(1j * phases))[:, None], **NUMBERS))
    assert others.min() > 1e-3


def test_the_printed_peaks_of_the_driven_oscillator() -> None:
    """At the peak the force only balances damping: a = K/2μω_0, or αΛ³/μω_0."""
    values = {"omega_0": 1.3, "alpha": 0.7, "mu": 0.11, "K": 0.6}
    a = 0.6 / (2 * 0.11 * 1.3)
    backbone = 3 * 0.7 * a**2 / (8 * 1.3)
    primary = emitted("duffing_forced", "Omega_is_omega_0_order_1")
    # sin γ = −1
    rate = primary.slow_flow([-1j * a / 2], sigma=backbone, **values)
    assert abs(rate[0]) < 1e-14
    drift = 9 * 0.6 / (16 * 1.3**2)  # Λ at Ω = ω_0/3
    a = 0.7 * drift**3 / (0.11 * 1.3)
    backbone = 3 * 0.7 * (drift**2 + a**2 / 8) / 1.3
    superharmonic = emitted("duffing_forced", "three_Omega_is_omega_0_order_1")
    rate = superharmonic.slow_flow([1j * a / 2], sigma=backbone, **values)
    assert abs(rate[0]) < 1e-14  # rounding


def test_printed_relations_of_the_quadratic_term() -> None:
    """Nayfeh and Mook, chapter 4: a = α_2Λ²/(ω_0√(μ² + σ²)), and |σ| < 2√(α_2²Λ²/ω_0² − μ²)."""
    values = {"omega_0": 1.3, "alpha_2": 0.9, "mu": 0.03, "K": 1.1}
    drift = 2 * 1.1 / (3 * 1.3**2)  # Λ at Ω = ω_0/2
    a = 0.9 * drift**2 / (1.3 * np.hypot(0.03, 0.2))
    case = emitted("helmholtz_duffing_forced", "two_Omega_is_omega_0_order_1")
    angle = np.arctan2(0.03, 0.2)  # α_2Λ² e^{−iγ}/ω_0 = a(σ − iμ)
    rate = case.slow_flow([a / 2 * np.exp(1j * angle)], sigma=0.2, **values)
    assert abs(rate[0]) < 1e-14  # rounding
    case = emitted("helmholtz_duffing_forced", "Omega_is_two_omega_0_order_1")
    drift = 1.1 / (6 * 1.3**2)
    edge = 2 * np.sqrt((0.9 * drift / 1.3) ** 2 - 0.03**2)
    np.testing.assert_allclose(case.boundaries(**values), [-edge, edge], rtol=1e-13)


@pytest.mark.parametrize("order", [1, 2])
def test_growth_of_the_subharmonic_about_the_exact_motion(order: int) -> None:
    """Halving ε divides the error of the growth rate by 2^{N+1}, up to a tenth of that."""
    left = beta * x**2 + 2 * mu * d(x) - f * sp.cos(Omega * t)
    scaled = oscillator(left).scale({beta: 1, mu: 1})
    case = scaled.expand(order, {Omega: 2 * omega})
    values = {"omega": 1.0, "beta": 2.9, "mu": 0.05, "f": 1.3, "sigma": 0.2}
    errors = []
    for epsilon in (1 / 128, 1 / 256):
        slow, exact = scaled_values(case, values, epsilon)
        near = mg.orbit_near(case, slow, [0.0])
        # it has the force's period, and no harmonic at half of the force's frequency
        assert near.orbit.period == pytest.approx(2 * np.pi / exact["Omega"], rel=1e-12)
        assert near.amplitudes == [0.0]
        predicted = case.slow_flow.equilibria(slow).growth[0]
        errors.append(abs(predicted - near.orbit.growth))
    assert errors[0] / errors[1] == pytest.approx(2 ** (order + 1), rel=0.1)
