"""Parametrically excited nonlinear oscillators: emitted slow flows against formulas in print."""

from __future__ import annotations

import numpy as np
import pytest
from entries import certificates, demand_notebook, emitted
from scipy.optimize import fsolve
from sympy import cos
from systems import Omega, alpha, d, equations, f, mu, omega, t, x

import mmsgen as mg

HARD = {"omega": 1.0, "f": 0.8, "alpha": 0.7, "mu": 0.2, "eta": 0.0, "sigma": 0.5}
CAUGHT = {"omega": 1.0, "f": 0.6, "alpha": 0.0, "mu": -0.5, "eta": 1.0, "sigma": 0.25}


@pytest.mark.pinned
def test_the_notebook_of_parametric_excitation() -> None:
    demand_notebook("mathieu_duffing")


def test_certificates_of_parametric_excitation() -> None:
    found = certificates("mathieu_duffing")
    assert sorted(found) == [f"Omega_is_two_omega_order_{n}" for n in (1, 2)]
    for data in found.values():
        quantities = [fit["quantity"] for fit in data["fits"][1:]]
        assert quantities == ["equilibrium amplitudes", "stability", "pitchfork", "saddle-node"]
        assert data["fits"][0]["theory"] == data["order"]
        for fit in data["fits"]:
            # generic values, so that no error term vanishes
            assert abs(float(fit["fitted"]) - fit["theory"]) < 0.2


def steady(order: int, values: dict[str, float], guess: complex) -> complex:
    """2B where the emitted slow flow stands still."""
    case = emitted("mathieu_duffing", f"Omega_is_two_omega_order_{order}")

    def rate(z: np.ndarray) -> list[float]:
        value = case.slow_flow([complex(*z) / 2], **values)[0]
        return [value.real, value.imag]

    root, *_ = fsolve(rate, [guess.real, guess.imag], xtol=1e-12, full_output=True)
    assert np.abs(rate(root)).max() < 1e-12
    return complex(*root)


@pytest.mark.parametrize(
    ("values", "square"),
    [
        (HARD, 4 * (0.5 + np.sqrt(0.8**2 - 4 * 0.2**2)) / (3 * 0.7)),
        ({**HARD, "sigma": 1.1}, 4 * (1.1 + np.sqrt(0.8**2 - 4 * 0.2**2)) / (3 * 0.7)),
        ({**HARD, "alpha": -0.7, "sigma": -0.5}, 4 * (0.5 + np.sqrt(0.48)) / (3 * 0.7)),
        (CAUGHT, 4 * (1 + np.sqrt(0.6**2 - 0.25**2))),
        ({**CAUGHT, "sigma": -0.5}, 4 * (1 + np.sqrt(0.6**2 - 0.5**2))),
    ],
)
def test_steady_amplitudes_in_print(values: dict[str, float], square: float) -> None:
    """Nayfeh and Mook (1979), chapter 5; the phase is found from several guesses."""
    guesses = np.sqrt(square) * np.exp(1j * np.linspace(0, np.pi, 12))
    roots = [abs(steady(1, values, z)) ** 2 for z in guesses]
    # a root found to the root of rounding, at least; the others are rest or the unstable motion
    assert min(abs(root / square - 1) for root in roots) < 1e-10


def test_rest_is_unstable_between_the_printed_bounds() -> None:
    case = emitted("mathieu_duffing", "Omega_is_two_omega_order_1")

    def growth(sigma: float) -> float:
        values = {**HARD, "sigma": sigma}
        # linear in B and its conjugate, so two directions give the matrix; 1e-9 squares away
        small = 1e-9
        columns = [case.slow_flow([small * z], **values)[0] / small for z in (1, 1j)]
        matrix = [[c.real for c in columns], [c.imag for c in columns]]
        return float(np.linalg.eigvals(matrix).real.max())

    edge = np.sqrt(0.8**2 - 4 * 0.2**2)
    for sigma in (edge, -edge):
        assert growth(0.999 * sigma) > 1e-4
        assert growth(1.001 * sigma) < -1e-4


def test_order_2_against_exact_periodic_motions() -> None:
    """The amplitude of the fundamental, with an error of order ε²."""
    left = d(x, 2) + 2 * mu * d(x) + alpha * x**3
    eom = equations([left + (omega**2 + 2 * f * cos(Omega * t)) * x], [x])
    first = max((steady(1, HARD, z) for z in (1.3, 1 + 1j, 1.3j)), key=abs)
    errors = []
    for epsilon in (0.04, 0.02):
        small = {k: v if k == "omega" else epsilon * v for k, v in HARD.items()}
        start = steady(2, small, first)
        half = 1 + small["sigma"] / 2
        known = {k: small[k] for k in ("omega", "f", "alpha", "mu")} | {"Omega": 2 * half}
        problem = mg.orbits.problem(eom, known)
        found = mg.orbits.find(problem, [start.real, -half * start.imag], periods=2)
        assert found.stable
        errors.append(abs(start) - found.amplitude())
    # a term of the next order besides, of which ε is the factor
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.2)


@pytest.mark.parametrize("order", [1, 2])
def test_emitted_response_begins_at_the_boundaries_of_rest(order: int) -> None:
    """Pitchforks: order 1 at σ² = f² − 4μ², order 2 where Floquet's zone ends but for ε³."""
    case = emitted("mathieu_duffing", f"Omega_is_two_omega_order_{order}")
    values = {"omega": 1.0, "f": 0.1, "alpha": 0.2, "mu": 0.02, "eta": 0.0}
    response = case.frequency_response(**values, sigma=np.linspace(-0.12, 0.12, 121))
    found = [b.parameter for b in response.bifurcations if b.kind == "pitchfork"]
    half = np.sqrt(0.1**2 - 4 * 0.02**2)
    if order == 1:
        assert found == pytest.approx([-half, half], rel=1e-8)  # located to 1e-10
    else:
        left = 2 * mu * d(x) + (omega**2 + 2 * f * cos(Omega * t)) * x
        known = {"omega": 1.0, "f": 0.1, "mu": 0.02}
        zone = mg.floquet.boundary(equations([left + d(x, 2)], [x]), known, Omega, (1.85, 2.15))
        # f, μ and σ are below 0.1; the coefficients of the next order are below one
        assert found == pytest.approx(np.array(zone.zones[0]) - 2, abs=0.1**3)
