"""Self-excited oscillators: what is emitted against printed and exact limit cycles."""

from __future__ import annotations

import numpy as np
import pytest
from entries import HOPF, certificates, demand_notebook, emitted
from scipy.optimize import brentq


@pytest.mark.pinned
@pytest.mark.parametrize(
    "name", ["van_der_pol", "van_der_pol_forced", "rayleigh", "rayleigh_forced"]
)
def test_notebooks(name: str) -> None:
    demand_notebook(name)


@pytest.mark.parametrize(
    ("name", "number"),
    [("van_der_pol", 4), ("van_der_pol_forced", 4), ("rayleigh", 3), ("rayleigh_forced", 4)],
)
def test_certificates(name: str, number: int) -> None:
    found = certificates(name)
    assert len(found) == number
    for data in found.values():
        motions, *steady = data["fits"]
        assert motions["theory"] == data["order"]
        # at ε = 1/16 and less; the next but one term shifts the exponent by no more
        assert -0.1 < float(motions["fitted"]) - motions["theory"] < 0.25
        # at ε = 1/16 and less, or fitted with a further term: see `certificate.TOLERANCE`; where
        # odd powers vanish an exponent may be higher by one
        assert steady
        for fit in steady:
            assert -0.05 < float(fit["fitted"]) - fit["theory"] < 1.1


def test_what_is_certified_of_steady_motions() -> None:
    cycle = {"equilibrium amplitudes", "stability", "frequency"}
    locked = {"equilibrium amplitudes", "stability", "saddle-node", *HOPF}
    torus = {"limit cycle", "frequency of the limit cycle"}
    for name, tail, quantities in [
        ("van_der_pol", "nonresonant", cycle),
        ("rayleigh", "nonresonant", cycle),
        ("van_der_pol_forced", "Omega_is_omega_0", locked | torus),
        ("rayleigh_forced", "Omega_is_omega_0", locked),
        ("van_der_pol_forced", "nonresonant", {"stability"}),
        ("rayleigh_forced", "nonresonant", {"stability"}),
    ]:
        for module, data in certificates(name).items():
            if module.startswith(tail):
                assert {fit["quantity"] for fit in data["fits"][1:]} == quantities


# --- free -----------------------------------------------------------------------------------------

# Andersen and Geer, SIAM J. Appl. Math. 42 (1982): ω = 1 − μ²/16 + 17μ⁴/3072 + 35μ⁶/884736 − …
SERIES = {0: 1.0, 2: -1 / 16, 4: 17 / 3072, 6: 35 / 884736}


@pytest.mark.parametrize("order", [2, 3, 4])
def test_limit_cycle_of_van_der_pol(order: int) -> None:
    """The emitted slow flow at rest in its amplitude, at a strength where the series differ."""
    case = emitted("van_der_pol", f"nonresonant_order_{order}")
    mu = 0.1

    def rate(a: float) -> complex:
        return complex(case.slow_flow([a / 2], mu=mu)[0] / (a / 2))

    a = brentq(lambda a: rate(a).real, 1.5, 2.5, xtol=1e-14)
    if order > 2:
        # printed 2 + μ²/64; μ⁴ comes next, with a coefficient below 1/100
        assert a - 2 == pytest.approx(mu**2 / 64, abs=mu**4 / 100)
    printed = sum(c * mu**n for n, c in SERIES.items() if n <= order)
    # order 2 and 3 omit D_4 but take a = 2 + O(μ²) into D_2, whose slope there is not zero
    left = 1 + rate(a).imag - printed
    assert abs(left) < (1e-2 * mu**4 if order < 4 else 1e-3 * mu**6)


def test_limit_cycle_of_rayleigh() -> None:
    """Its velocity is van der Pol's motion: one frequency, and ωa is the other's amplitude."""
    case = emitted("rayleigh", "nonresonant_order_4")
    mu = 0.1

    def rate(a: float) -> complex:
        return complex(case.slow_flow([a / 2], mu=mu, omega_0=1.0)[0] / (a / 2))

    a = brentq(lambda a: rate(a).real, 1.5, 2.5, xtol=1e-14)
    omega = 1 + rate(a).imag
    # order 4 leaves μ⁶ in the frequency, μ⁴ in the amplitude
    assert abs(omega - (1 - mu**2 / 16 + 17 * mu**4 / 3072)) < 1e-2 * mu**6
    assert omega * a - 2 == pytest.approx(mu**2 / 64, abs=mu**4 / 50)


@pytest.mark.parametrize("name", ["van_der_pol", "rayleigh"])
def test_emitted_limit_cycles(name: str) -> None:
    """Found without a guess, stable, with the printed frequency as their drift."""
    case = emitted(name, "nonresonant_order_4")
    mu = 0.1
    further = {"omega_0": 1.0} if name == "rayleigh" else {}
    found = case.equilibria(mu=mu, **further)
    assert found.stable.tolist() == [False, True]
    omega = 1 + found.drift[1, 0]
    assert abs(omega - (1 - mu**2 / 16 + 17 * mu**4 / 3072)) < 1e-2 * mu**6  # as above
    velocity = omega * found.modulus[1, 0] if name == "rayleigh" else found.modulus[1, 0]
    assert velocity - 2 == pytest.approx(mu**2 / 64, abs=mu**4 / 50)


# --- driven ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["van_der_pol_forced", "rayleigh_forced"])
def test_locked_motions_in_print(name: str) -> None:
    """ρ(1 − ρ)² + 4σ²ρ = K²/4: Nayfeh and Mook, chapter 4, for Rayleigh's oscillator.

    In units of the self-excitation; ρ = ω_0²a²/4, for van der Pol's a²/4 and K/ω_0 for K.
    """
    case = emitted(name, "Omega_is_omega_0_order_1")
    omega_0, mu, sigma, rho = 1.3, 0.7, 0.2, 1.1
    unit = omega_0 if name == "van_der_pol_forced" else 1.0
    force = 2 * np.sqrt(rho * (1 - rho) ** 2 + 4 * sigma**2 * rho)
    a = 2 * np.sqrt(rho) * unit / omega_0
    # sin γ and cos γ from both rates at rest, in the same units
    angle = np.arctan2(2 * (1 - rho), -4 * sigma)
    values = {"omega_0": omega_0, "mu": mu, "K": mu * unit * force, "sigma": mu * sigma}
    assert abs(case.slow_flow([a / 2 * np.exp(1j * angle)], **values)[0]) < 1e-14  # rounding


@pytest.mark.parametrize("name", ["van_der_pol_forced", "rayleigh_forced"])
def test_where_locking_is_lost(name: str) -> None:
    """Saddle-nodes where 1 − 4ρ + 3ρ² + 4σ² = 0, Hopf points where ρ = 1/2, printed as above."""
    case = emitted(name, "Omega_is_omega_0_order_1")
    values = {"omega_0": 1.0, "mu": 0.2, "sigma": np.linspace(-0.25, 0.25, 101)}
    for force, kind in ((0.1, "saddle-node"), (0.3, "Hopf")):
        response = case.frequency_response(**values, K=force)
        left, right = response.bifurcations
        assert {left.kind, right.kind} == {kind}
        assert left.parameter == pytest.approx(-right.parameter, rel=1e-9)  # located to 1e-10
        rho, sigma = left.modulus[0] ** 2 / 4, left.parameter / 0.2
        assert 4 * (rho * (1 - rho) ** 2 + 4 * sigma**2 * rho) == pytest.approx((force / 0.2) ** 2)
        # at a fold the amplitude is known to the root of that
        if kind == "Hopf":
            assert rho == pytest.approx(0.5, abs=1e-8)
        else:
            assert 1 - 4 * rho + 3 * rho**2 + 4 * sigma**2 == pytest.approx(0, abs=1e-5)


@pytest.mark.parametrize(("name", "power"), [("van_der_pol_forced", 0), ("rayleigh_forced", 2)])
def test_quenching(name: str, power: int) -> None:
    """η = 1 − Ω^p K²/2(ω_0² − Ω²)² is the growth that is left of small oscillations, over μ/2."""
    case = emitted(name, "nonresonant_order_1")
    for force in (0.5, 6.1):
        eta = 1 - 2.3**power * force**2 / (2 * (1.3**2 - 2.3**2) ** 2)
        values = {"omega_0": 1.3, "mu": 0.7, "Omega": 2.3, "K": force}
        small = 1e-9
        growth = case.slow_flow([small], **values)[0] / small
        assert growth == pytest.approx(0.35 * eta, rel=1e-13)  # rounding
        assert (eta < 0) is (force > 6)
