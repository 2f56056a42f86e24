"""Limit cycles of a slow flow against time integration and the theory of the Hopf point."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from systems import (
    Omega,
    alpha,
    beta,
    d,
    k,
    kappa,
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
from mmsgen.limit_cycles import LimitCycles, keeps_volumes
from mmsgen.runtime._flow import jacobian, rates, spectrum
from mmsgen.runtime._records import Bifurcation

VALUES = {"mu": 0.05, "k": 0.9, "alpha": 0.8, "beta": 0.8, "omega_1": 1.0, "sigma_1": 0.4}
OVER = "sigma_2"


@cache
def flow() -> mg.SlowFlow:
    """1:2 internal resonance with the higher mode driven (Nayfeh & Mook, 1979, ch. 6)."""
    scaled = pair(
        2 * mu * d(x) + alpha * x * y, 2 * mu * d(y) + beta * x**2 - k * sp.cos(Omega * t)
    ).scale({alpha: 1, beta: 1, mu: 1, k: 1})
    return scaled.expand(1, {omega_2: 2 * omega_1, Omega: omega_2}).slow_flow


def both_moving(detuning: float) -> tuple[float, np.ndarray]:
    """Largest growth rate and amplitudes of the less stable equilibrium of both modes."""
    found = flow().equilibria({**VALUES, OVER: detuning})
    growth = np.where(found.modulus[..., 0] > 1e-6, found.growth, -np.inf)
    return growth.max(), found.amplitudes[int(growth.argmax())]


@cache
def hopf() -> Bifurcation:
    """Where the growth rate changes its sign, the pair being complex."""
    value = brentq(lambda s: both_moving(s)[0], -0.17, -0.145, xtol=1e-13)
    table, b = flow().table, both_moving(value)[1]
    numbers = table.numbers({**VALUES, OVER: value})
    frequency = float(np.abs(spectrum(table.flow, numbers, b)[0].imag))
    return Bifurcation("Hopf", value, b, np.zeros(0), frequency)


def test_cycles_grow_out_of_a_hopf_point() -> None:
    point = hopf()
    family = flow().limit_cycles(VALUES, point, OVER, (-0.2, -0.15), largest=0.02)
    assert family.path.reason == "reached"
    first = family.cycles[0]
    # The frequency of a small cycle is that of the point, up to the square of its size, 1e-2.
    assert first.frequency == pytest.approx(point.frequency, rel=1e-3)
    # Its size is that of the square root of the distance: where the amplitude doubles, the
    # distance is four times as large, up to a relative change of the order of the distance.
    sizes = np.array([np.ptp(c.modulus[0]) for c in family.cycles])
    assert (np.diff(sizes) > 0).all()
    small = sizes < 0.15
    assert small.sum() >= 3
    slope = np.polyfit(
        np.log(sizes[small]), np.log(np.abs(family.values[small] - point.parameter)), 1
    )[0]
    assert slope == pytest.approx(2, abs=0.05)
    assert {c.verdict for c in family.cycles[1:]} == {"stable"}


def test_a_motion_ends_on_the_cycle() -> None:
    values = {**VALUES, OVER: -0.15}
    start = 1.05 * both_moving(-0.15)[1]
    cycle = flow().limit_cycle(values, start)
    # A second method: the slow flow's own table, integrated until transients are gone.
    table = flow().table
    numbers = table.numbers(values)

    def derivative(_: float, b: np.ndarray) -> np.ndarray:
        return rates(table.flow, numbers, b)

    begin = cycle.amplitudes(0.0)
    path = solve_ivp(
        derivative, (0, cycle.period), begin, "DOP853", cycle.orbit.times, rtol=1e-12, atol=1e-13
    )
    # a hundred steps at 1e-12, which a stable cycle does not enlarge much
    assert np.abs(path.y - cycle.amplitudes(cycle.orbit.times)).max() < 1e-9
    sizes = 2 * np.abs(path.y)
    assert cycle.modulus == pytest.approx(np.stack([sizes.min(1), sizes.max(1)], 1), abs=1e-9)
    assert cycle.verdict == "stable"
    # Liouville: their product is e^{T div}, and the divergence of a quadratic coupling is zero.
    divergence = [np.trace(jacobian(table.flow, numbers, b)) for b in path.y.T]
    assert np.ptp(divergence) < 1e-15
    product = np.exp(cycle.period * divergence[0])
    # The errors of four multipliers, each of them at most one in modulus, add up.
    assert abs(np.prod(cycle.multipliers) - product) < cycle.orbit.multiplier_errors.sum()


def test_what_has_no_cycle_says_so() -> None:
    with pytest.raises(mg.OrbitError, match="comes to rest"):
        flow().limit_cycle({**VALUES, OVER: -0.2}, 1.01 * both_moving(-0.2)[1], time=2000.0)
    wrong = hopf()._replace(kind="saddle-node")
    with pytest.raises(mg.OrbitError, match="not at a saddle-node"):
        flow().limit_cycles(VALUES, wrong, OVER, (-0.2, -0.1))
    forced = oscillator(alpha * x**3 - k * sp.cos(Omega * t)).scale({alpha: 1, k: 1})
    with pytest.raises(mg.OrbitError, match="1 amplitudes are needed"):
        forced.expand(1, {Omega: omega}).slow_flow.limit_cycle(
            {"omega": 1.0, "alpha": 1.0, "k": 1.0, "sigma": 0.1}, [0.1, 0.2]
        )


@cache
def coupled() -> mg.SlowFlow:
    """Two van der Pol oscillators with a weak spring between them, 1:1."""
    first = -mu * (1 - x**2) * d(x) + kappa * (x - y)
    second = -mu * (1 - y**2) * d(y) + kappa * (y - x)
    scaled = pair(first, second).scale({mu: 1, kappa: 1})
    return scaled.expand(1, {omega_2: omega_1}).slow_flow


def test_beats_of_oscillators_that_are_not_locked() -> None:
    # The slow flow is the same when both phases are shifted alike. Without coupling the phase
    # difference turns at σ; a spring κ shifts both frequencies by κ/2 and changes the difference
    # by O(κ²) alone.
    flow, errors = coupled(), []
    assert flow.table.flow.symmetries
    for spring in (0.02, 0.01):
        values = {"mu": 0.2, "kappa": spring, "omega_1": 1.0, "sigma": 0.3}
        cycle = flow.limit_cycle(values, [1.0, 0.8j])
        assert cycle.verdict == "stable"
        errors.append(abs(cycle.frequency - 0.3))
        assert cycle.drift[0] == pytest.approx(spring / 2, abs=10 * spring**2)
    assert errors[0] / errors[1] == pytest.approx(4, abs=0.4)
    # A second method: the whole slow flow, integrated over a period, turns the amplitudes by the
    # drift and brings them back otherwise.
    table = flow.table
    numbers = table.numbers(values)
    path = solve_ivp(
        lambda _, b: rates(table.flow, numbers, b),
        (0, cycle.period),
        cycle.amplitudes(0.0),
        "DOP853",
        rtol=1e-12,
        atol=1e-13,
    )
    (k,) = np.array(table.flow.symmetries)
    turned = cycle.amplitudes(0.0) * np.exp(1j * k * cycle.drift[0] * cycle.period)
    assert np.abs(path.y[:, -1] - turned).max() < 1e-9
    with pytest.raises(mg.OrbitError, match="begin where they are not zero"):
        flow.limit_cycle(values, [0.0, 1.0])


def test_conservative_flows_have_families() -> None:
    undamped = oscillator(alpha * x**3 - k * sp.cos(Omega * t)).scale({alpha: 1, k: 1})
    slow = undamped.expand(1, {Omega: omega}).slow_flow
    with pytest.raises(mg.OrbitError, match="ones come in families"):
        slow.limit_cycle({"omega": 1.0, "alpha": 1.0, "k": 0.1, "sigma": 0.3}, [0.3])
    # two amplitudes, where only the numbers say so
    assert keeps_volumes(flow(), {**VALUES, "mu": 0.0})
    assert not keeps_volumes(flow(), VALUES)


def test_cycles_show_what_they_are() -> None:
    values = {"mu": 0.2, "kappa": 0.02, "omega_1": 1.0, "sigma": 0.3}
    cycle = coupled().limit_cycle(values, [1.0, 0.8j])
    (low, high), _ = cycle.modulus
    text = repr(cycle)
    assert f"period={cycle.period:.6g} s" in text and "stable" in text
    assert f"{low:.6g} … {high:.6g}" in text
    path = mg.orbits.follow(cycle.orbit.problem, cycle.orbit, "kappa", 0.021)
    family = LimitCycles(path, cycle.form)
    count = len(path.orbits)
    assert repr(family) == f"LimitCycles({count} cycles, kappa=0.02 … 0.021, ends: reached)"
