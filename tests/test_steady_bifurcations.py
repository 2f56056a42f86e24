"""Bifurcations of slow flows against those of exact periodic orbits: the exponents of theory."""

from __future__ import annotations

from functools import cache, wraps
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import sympy as sp
from systems import (
    Omega,
    alpha,
    beta,
    d,
    equations,
    f,
    k,
    mu,
    omega,
    omega_1,
    omega_2,
    oscillator,
    pair,
    t,
    x,
    y,
)

import mmsgen as mg
from mmsgen.loading import load
from mmsgen.steady_fits import steady_fits

# Fitted to six errors with one correction term, whose neglected successor moves the exponent by
# less than 0.05 (see `certificate.TOLERANCE`).
NEAR = 0.05

PUMPED = {"mu": 0.1, "f": 0.7, "alpha": 0.8, "omega": 1.0}
REST = mg.Steady({**PUMPED, "sigma": 0.65}, [0.0], "pitchfork")
DRIVEN = {"mu": 0.1, "k": 0.9, "alpha": 0.8, "beta": 0.8, "omega_1": 1.0, "sigma_1": 0.15}
ONSET = mg.Steady({**DRIVEN, "sigma_2": 0.2}, [0.0, -0.45 - 0.23j], "pitchfork", "sigma_2")
MEET = mg.Steady({**DRIVEN, "sigma_2": -0.35}, [0.4 + 0.4j, 0.25 - 0.25j], "saddle-node", "sigma_2")
FREED = mg.Steady({"omega": 1.0, "mu": 1.0, "k": 1.6, "sigma": -0.51}, [0.63 + 0.31j], "Hopf")


@cache
def pumped(order: int) -> mg.Expansion:
    """Mathieu–Duffing, Ω = 2ω + εσ."""
    left = 2 * mu * d(x) + 2 * f * sp.cos(Omega * t) * x + alpha * x**3
    return oscillator(left).scale({mu: 1, f: 1, alpha: 1}).expand(order, {Omega: 2 * omega})


@cache
def driven(order: int) -> mg.Expansion:
    """1:2 internal resonance, the faster oscillator driven (Nayfeh & Mook, 1979, ch. 6)."""
    scaled = pair(
        2 * mu * d(x) + alpha * x * y, 2 * mu * d(y) + beta * x**2 - k * sp.cos(Omega * t)
    ).scale({alpha: 1, beta: 1, mu: 1, k: 1})
    return scaled.expand(order, {omega_2: 2 * omega_1, Omega: omega_2})


@cache
def pulled(order: int) -> mg.Expansion:
    """Van der Pol's oscillator, driven, Ω = ω + εσ."""
    left = -mu * (1 - x**2) * d(x) - k * sp.cos(Omega * t)
    return oscillator(left).scale({mu: 1, k: 1}).expand(order, {Omega: omega})


def exponents(case: mg.Expansion, steady: mg.Steady, module: Any = None) -> dict[str, float]:
    if module is None:
        whole = load(case)
        module = SimpleNamespace(slow_flow=whole.slow_flow, jacobian=whole.jacobian)
    fits = steady_fits(case, module, steady)
    return {fit.quantity: fit.exponent for fit in fits}


def test_rest_gives_way_to_an_oscillation() -> None:
    assert exponents(pumped(2), REST) == {"pitchfork": pytest.approx(3, abs=NEAR)}


def test_the_crossing_is_an_edge_of_floquets_zone() -> None:
    values = {"mu": 0.05, "f": 0.2, "omega": 1.0}
    eom = equations([d(x, 2) + 2 * mu * d(x) + (omega**2 + 2 * f * sp.cos(Omega * t)) * x], [x])
    zone = mg.floquet.boundary(eom, values, Omega, (1.7, 2.3))
    for edge in zone.zones[0]:
        problem = mg.orbits.problem(eom, {**values, "Omega": round(edge, 2)})
        found = mg.orbits.crossing(problem, lambda t: np.zeros((2, len(t))), -1.0, Omega, 0.1)
        assert found.kind == "period doubling"
        assert abs(found.value - edge) <= found.error + zone.error.max()
        assert found.error < 1e-11  # some roundings of 1e-16, over a slope of order one


@pytest.mark.parametrize(("steady", "kind"), [(ONSET, "pitchfork"), (MEET, "saddle-node")])
def test_two_amplitudes(steady: mg.Steady, kind: str) -> None:
    assert exponents(driven(2), steady) == {kind: pytest.approx(3, abs=NEAR)}


def test_a_locked_oscillator_is_set_free() -> None:
    found = exponents(pulled(1), FREED)
    assert found["Hopf"] == pytest.approx(2, abs=NEAR)
    assert found["frequency of the Hopf point"] == pytest.approx(2, abs=NEAR)


def test_the_crossing_of_a_pair_is_what_continuation_finds() -> None:
    case = pulled(1)
    eom = case.weak.scaled.eom
    problem = mg.orbits.problem(eom, {"omega": 1.0, "mu": 0.1, "k": 0.16, "Omega": 0.97})
    orbit = mg.orbits.find(problem, [2.0, 0.0])
    path = mg.orbits.follow(problem, orbit, "Omega", 0.92)
    (point,) = path.specials
    j = int(np.abs(np.abs(point.orbit.multipliers) - 1).argmin())
    start = problem.at("Omega", point.value + 0.004)
    found = mg.orbits.crossing(start, orbit, point.orbit.multipliers[j], "Omega", 0.1)
    assert found.kind == point.kind == "Neimark-Sacker"
    # located to 1e-11 of a step, and steps are below the unit
    assert abs(found.value - point.value) < 1e-11


def test_a_broken_symmetry_of_two_equal_oscillators() -> None:
    # With y at rest x is a driven oscillator; xy² and x²y let y grow: a multiplier of 1. All
    # terms are of order 1, and the flow is the same under y → −y.
    scaled = pair(
        2 * mu * d(x) + alpha * x * y**2 - k * sp.cos(Omega * t), 2 * mu * d(y) + alpha * y * x**2
    ).scale({mu: 1, alpha: 1, k: 1})
    case = scaled.expand(1, {omega_2: omega_1, Omega: omega_1})
    values = {"mu": 0.1, "k": 0.9, "alpha": 0.8, "omega_1": 1.0, "sigma_1": 0.1}
    found = case.slow_flow.frequency_response({**values, "sigma_2": np.linspace(-1, 1, 81)})
    point = next(b for b in found.bifurcations if b.kind == "pitchfork")
    place = {**values, "sigma_2": round(point.parameter, 3)}
    steady = mg.Steady(place, list(point.amplitudes), "pitchfork", "sigma_2")
    assert exponents(case, steady) == {"pitchfork": pytest.approx(2, abs=NEAR)}


def test_a_wrong_coefficient_does_not_pass() -> None:
    # Damping that is wrong by a term of order 2 moves the point by ε², where order 2 leaves ε³.
    case, own = pumped(2), load(pumped(2))

    def wrong(name: str) -> Any:
        @wraps(getattr(own, name))
        def function(b: Any, **values: float) -> Any:
            right = getattr(own, name)(b, **values)
            more = np.asarray(b) if name == "slow_flow" else np.eye(2)
            return right - values["mu"] ** 2 * more

        return function

    emitted = SimpleNamespace(slow_flow=wrong("slow_flow"), jacobian=wrong("jacobian"))
    assert exponents(case, REST, emitted)["pitchfork"] < 2.5
    # The others must find the point of these.
    emitted.frequency_response = own.frequency_response
    with pytest.raises(mg.CertificateError, match="finds no pitchfork"):
        exponents(case, REST, emitted)


def test_what_cannot_be_certified_is_said() -> None:
    with pytest.raises(mg.MmsgenError, match="one of saddle-node, pitchfork, Hopf"):
        mg.Steady({}, [0.0], "fold")
    case, module = driven(1), load(driven(1))

    def refused(b: list[complex], kind: str, over: str = "sigma_2", **values: float) -> str:
        place = {**ONSET.values, **values}
        with pytest.raises(mg.CertificateError) as error:
            steady_fits(case, module, mg.Steady(place, b, kind, over), [0.01])
        return str(error.value)

    assert "give zero" in refused([0.1, 0.2], "pitchfork")
    assert "no detuning: choose one of sigma_1, sigma_2" in refused([0, 0.2], "pitchfork", "mu")
    assert "no pitchfork is found" in refused([0, 0.4], "pitchfork", mu=3.0)
    free = oscillator(-mu * (1 - x**2) * d(x)).scale({mu: 1}).expand(1)
    with pytest.raises(mg.CertificateError, match="needs a relation"):
        steady_fits(free, load(free), mg.Steady({"mu": 1.0, "omega": 1.0}, [1.0], "Hopf"))
    # A multiplier of a locked oscillator far from its edges, in steps that are far too small.
    problem = mg.orbits.problem(
        pulled(1).weak.scaled.eom, {"omega": 1.0, "mu": 0.1, "k": 0.16, "Omega": 1.0}
    )
    with pytest.raises(mg.OrbitError, match="no multiplier"):
        mg.orbits.crossing(problem, [2.0, 0.0], 0.7, "k", 1e-6)
