"""Limit cycles of slow flows against quasi-periodic motions of the exact equations."""

from __future__ import annotations

from functools import cache, wraps
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from systems import Omega, d, equations, k, mu, omega, oscillator, t, x, y

import mmsgen as mg
from mmsgen.loading import load
from mmsgen.motion import first_order_system
from mmsgen.steady_fits import steady_fits

DRIFTING = {"omega": 1.0, "mu": 1.0, "k": 1.2, "sigma": 0.8}
START = [0.8 + 0.3j]


@cache
def pulled(order: int) -> mg.Expansion:
    """Van der Pol's oscillator, driven, Ω = ω + εσ."""
    left = -mu * (1 - x**2) * d(x) - k * sp.cos(Omega * t)
    return oscillator(left).scale({mu: 1, k: 1}).expand(order, {Omega: omega})


def test_an_oscillator_that_is_not_locked() -> None:
    case = pulled(2)
    steady = mg.Steady(DRIFTING, START, cycle=True)
    own = SimpleNamespace(slow_flow=load(case).slow_flow)
    fits = steady_fits(case, own, steady, [2.0**-j for j in range(5, 9)])
    # Fitted to errors with one correction term, whose neglected successor moves the exponent by
    # less than 0.05 (see `certificate.TOLERANCE`).
    assert {fit.quantity: fit.exponent for fit in fits} == {
        "limit cycle": pytest.approx(2, abs=0.05),
        "frequency of the limit cycle": pytest.approx(3, abs=0.05),
    }
    assert all(fit.passed for fit in fits)


def test_a_torus_of_two_oscillators_that_know_nothing_of_each_other() -> None:
    # Van der Pol's oscillator keeps its own period, which the search for a periodic orbit finds,
    # and y is a linear response of amplitude 1/|4 − Ω² + 0.2iΩ|.
    own = d(x, 2) - mu * (1 - x**2) * d(x) + x
    eom = equations([own, d(y, 2) + d(y) / 5 + 4 * y - sp.cos(Omega * t)], [x, y])
    cycle = mg.orbits.find(
        mg.orbits.problem(equations([own], [x]), {"mu": 0.3}), [2.0, 0.0], 2 * np.pi
    )
    turns, fast = 2 * np.pi * np.arange(33) / 33, 1.7
    problem = mg.orbits.problem(eom, {"mu": 0.3, "Omega": fast})
    still = np.zeros(33)
    guess = np.stack([2 * np.cos(turns), 1 + still, -2 * np.sin(turns), still])
    found = mg.orbits.torus(problem, guess, 1.0)
    wanted = 2 * np.pi / cycle.period
    assert found.frequency == pytest.approx(wanted, abs=1e-10)  # the tolerance of `find`
    response = 1 / (4 - fast**2 + 0.2j * fast)
    # Its state at phase zero is the same everywhere: to the tolerance of both integrations, 1e-13,
    # which one period adds up.
    assert np.abs(found.states[1] - response.real).max() < 1e-11
    assert np.abs(found.states[3] + fast * response.imag).max() < 1e-11
    # A line of the motion is a harmonic of the cycle.
    assert found.lines(2)[0, 1] == pytest.approx(cycle.amplitude() / 2, abs=1e-9)


def test_an_exact_motion_stays_on_the_torus() -> None:
    eom = pulled(1).weak.scaled.eom
    values = {"omega": 1.0, "mu": 0.1, "k": 0.12, "Omega": 1.08}
    problem = mg.orbits.problem(eom, values)
    turns = 2 * np.pi * np.arange(33) / 33
    guess = np.stack([0.7 + 1.5 * np.cos(turns), -1.5 * np.sin(turns)])
    found = mg.orbits.torus(problem, guess, -0.07)
    m, period = found.states.shape[1], 2 * np.pi / 1.08
    times = period * np.arange(41)
    path = solve_ivp(
        first_order_system(eom, values),
        (0, times[-1]),
        found.states[:, 0],
        "DOP853",
        times,
        rtol=1e-12,
        atol=1e-13,
    )
    series = np.fft.fft(found.states, axis=1) / m
    waves = np.exp(1j * np.multiply.outer(np.fft.fftfreq(m, 1 / m), found.frequency * times))
    # 250 rad at 1e-12 in each, and the error of the torus
    assert np.abs((series @ waves).real - path.y).max() < 1e-9 + 10 * found.error


def test_what_cannot_be_certified_is_said() -> None:
    case, own = pulled(1), load(pulled(1))
    cycle = mg.Steady(DRIFTING, START, cycle=True)

    @wraps(own.slow_flow)
    def wrong(b: Any, **values: float) -> Any:
        return own.slow_flow(b, **values) + 1e-6 * np.asarray(b)

    with pytest.raises(mg.CertificateError, match="not the one of which"):
        steady_fits(case, SimpleNamespace(slow_flow=wrong), cycle, [0.1])
    with pytest.raises(mg.CertificateError, match="comes to rest"):
        steady_fits(case, own, mg.Steady({**DRIFTING, "sigma": 0.1}, START, cycle=True), [0.1])
    with pytest.raises(mg.MmsgenError, match="no bifurcation"):
        mg.Steady(DRIFTING, START, "Hopf", cycle=True)
    free = oscillator(-mu * (1 - x**2) * d(x)).scale({mu: 1}).expand(1)
    place = mg.Steady({"mu": 1.0, "omega": 1.0}, [1.0], cycle=True)
    with pytest.raises(mg.CertificateError, match="free motions"):
        steady_fits(free, load(free), place, [0.1])
    problem = mg.orbits.problem(
        case.weak.scaled.eom, {"omega": 1.0, "mu": 1.0, "k": 1.2, "Omega": 1.8}
    )
    for guess, message in [
        (np.zeros((2, 8)), "m odd"),
        (np.zeros((2, 9)), "a point"),
        (np.full((2, 9), np.nan), "finite"),
    ]:
        with pytest.raises(mg.OrbitError, match=message):
            mg.orbits.torus(problem, guess, 0.1)
    still = mg.orbits.problem(free.weak.scaled.eom, {"mu": 1.0, "omega": 1.0})
    with pytest.raises(mg.OrbitError, match="excitation"):
        mg.orbits.torus(still, np.zeros((2, 9)), 0.1)
