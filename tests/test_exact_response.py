"""Periodic orbits beside equilibria: against closed forms, and where they are taken."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from systems import Omega, alpha, d, f, k, mu, omega, oscillator, t, x

import mmsgen as mg
from mmsgen.runtime._records import Branch, Response

VALUES = {"omega": 1.3, "mu": 0.05, "k": 0.2, "alpha": 0.3}
SIGMAS = np.linspace(-0.2, 0.3, 41)


@cache
def forced() -> mg.Expansion:
    left = 2 * mu * d(x) + alpha * x**3 - k * sp.cos(Omega * t)
    return oscillator(left).scale({mu: 1, alpha: 1, k: 1}).expand(2, {Omega: omega})


def curve(case: mg.Expansion, values: dict[str, float], which: int = 0) -> Branch:
    """One equilibrium of each point as a branch: the smallest, or another one by size."""
    found = case.slow_flow.equilibria({**values, "sigma": SIGMAS})
    return Branch(SIGMAS, found.amplitudes[:, which], found.drift[:, which], found.growth[:, which])


def test_a_linear_oscillator_has_the_amplitude_in_closed_form() -> None:
    left = 2 * mu * d(x) - k * sp.cos(Omega * t)
    case = oscillator(left).scale({mu: 1, k: 1}).expand(1, {Omega: omega})
    values = {"omega": 1.3, "mu": 0.05, "k": 0.2, "sigma": 0.04}
    near = mg.orbit_near(case, values, [0.3 - 0.2j])
    size = 0.2 / np.hypot(1.3**2 - 1.34**2, 2 * 0.05 * 1.34)
    # the orbit is known to 1e-10 of its size
    assert near.amplitudes == pytest.approx([size], rel=1e-9)
    assert near.stable
    assert near.orbit.period == pytest.approx(2 * np.pi / 1.34, rel=1e-14)


def test_a_limit_cycle_turns_with_its_drift() -> None:
    case = oscillator(-mu * (1 - x**2) * d(x), sp.Integer(1)).scale({mu: 1}).expand(2)
    found = case.slow_flow.equilibria({"mu": 0.1})
    b, drift = found.amplitudes[1], found.drift[1]
    near = mg.orbit_near(case, {"mu": 0.1}, b, drift)
    # Andersen & Geer (1982): ω = 1 − μ²/16 + O(μ⁴/180), the fundamental 2 + μ²/64 + O(μ⁴)
    assert abs(2 * np.pi / near.orbit.period - 1 + 0.1**2 / 16) < 0.1**4 / 100
    assert abs(near.amplitudes[0] - 2 - 0.1**2 / 64) < 0.1**4
    assert near.stable


def test_a_limit_cycle_far_from_small_parameters_is_one_all_the_same() -> None:
    left = -mu * (d(x) - d(x) ** 3 / 3)
    case = oscillator(left, sp.Integer(1)).scale({mu: 1}).expand(4)
    found = case.slow_flow.equilibria({"mu": 2.0})
    near = mg.orbit_near(case, {"mu": 2.0}, found.amplitudes[1], found.drift[1])
    # The slow flow's frequency is less than half of the exact one here.
    assert 1 + found.drift[1, 0] < np.pi / near.orbit.period
    assert near.amplitudes == [near.orbit.amplitude(0, 1)]


def test_a_superharmonic_is_told_by_the_harmonic_of_its_own() -> None:
    left = 2 * mu * d(x) + alpha * x**2 - f * sp.cos(Omega * t)
    case = oscillator(left).scale({mu: 1, alpha: 1}).expand(2, {2 * Omega: omega})
    values = {"omega": 1.0, "alpha": 0.02, "mu": 0.02, "f": 0.8, "sigma": 0.01}
    found = case.slow_flow.equilibria(values)
    near = mg.orbit_near(case, values, found.amplitudes[0])
    assert near.amplitudes == [near.orbit.amplitude(0, 2)]
    # printed: a = αΛ²/(ω√(μ² + σ²)), Λ = 2f/3ω², off by O(ε) of it, ε = 0.04 = α/ω times f
    printed = 0.02 * (2 * 0.8 / 3) ** 2 / np.hypot(0.02, 0.01)
    assert near.amplitudes == pytest.approx([printed], rel=0.08)


def test_points_lie_evenly_on_all_branches_but_not_at_rest() -> None:
    case, values = forced(), {**VALUES, "k": 0.05}
    branch = curve(case, values)
    rest = Branch(SIGMAS, np.zeros((41, 1), complex), branch.drift, -np.ones(41))
    points = mg.orbits_along(case, values, Response("sigma", (rest, branch), ()), 9)
    assert len(points) == 9
    assert all(p.stable for p in points)
    top = branch.modulus.max()
    steps = [
        np.hypot((q.parameter - p.parameter) / 0.5, (q.amplitudes - p.amplitudes)[0] / top)
        for p, q in pairwise(points)
    ]
    # the points of the branch are 1/40 apart in the parameter and at most 0.15 along it
    assert max(steps) < 2 * min(steps) + 0.15
    # from one end to the other: half a step, of 1.8/9 at most, is left on either side
    assert points[0].parameter < SIGMAS[0] + 0.1 and points[-1].parameter > SIGMAS[-1] - 0.1
    for parameter, (a,), _ in points:
        own = np.interp(parameter, SIGMAS, branch.modulus[:, 0])
        # order 2 errs by some ε² of a, ε = 0.1
        assert a == pytest.approx(own, rel=0.03)


def test_large_amplitudes_and_other_orbits_are_passed_over() -> None:
    case = forced()
    branch = curve(case, VALUES)
    whole = Response("sigma", (branch,), ())
    below = mg.orbits_along(case, VALUES, whole, 5, largest=0.5)
    assert below
    expected = SIGMAS[branch.modulus[:, 0] <= 0.5]
    assert all(p.parameter in expected for p in below)
    assert mg.orbits_along(case, VALUES, whole, 5, largest=1e-3) == ()
    # A branch that is a tenth in size leads to orbits that are not meant.
    wrong = branch._replace(amplitudes=0.1 * branch.amplitudes)
    assert mg.orbits_along(case, VALUES, Response("sigma", (wrong,), ()), 5) == ()
    assert mg.orbits_along(case, VALUES, Response("sigma", (), ()), 5) == ()


def test_unstable_orbits_are_told_and_another_parameter_may_vary() -> None:
    case = forced()
    values = {**VALUES, "k": 0.1, "mu": 0.02, "sigma": 0.1}
    found = case.slow_flow.equilibria(values)
    assert found.number == 3
    forces = np.array([0.1])
    branches = tuple(
        Branch(forces, found.amplitudes[j : j + 1], found.drift[j : j + 1], found.growth[j : j + 1])
        for j in range(3)
    )
    points = mg.orbits_along(case, values, Response("k", branches, ()), 3)
    assert [p.stable for p in points] == [True, False, True]
    assert [p.parameter for p in points] == [0.1] * 3


def test_bad_input_is_said() -> None:
    case = forced()
    with pytest.raises(mg.MmsgenError, match="1 amplitudes are needed"):
        mg.orbit_near(case, {**VALUES, "sigma": 0.1}, [0.1, 0.2])
    with pytest.raises(mg.MmsgenError, match="count must be"):
        mg.orbits_along(case, VALUES, Response("sigma", (), ()), 0)
    with pytest.raises(mg.MmsgenError, match="needed"):
        mg.orbit_near(case, {"sigma": 0.1}, [0.1])
