"""Motions from given initial conditions: to amplitudes, along the slow flow, and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from systems import Omega, alpha, d, equations, kappa, mu, omega, oscillator, pair, t, x, y

import mmsgen as mg
from mmsgen.equations import EquationsOfMotion
from mmsgen.errors import MmsgenError
from mmsgen.expansion import Expansion

F = sp.Symbol("F", positive=True)
HARD = oscillator(alpha * x**3 + 2 * mu * d(x) - F * sp.cos(Omega * t + sp.Rational(1, 3)))
"""Driven at a third of its own frequency: the harmonic of order zero is as large as the motion."""
TWO = pair(2 * mu * d(x) + alpha * x * y, 2 * mu * d(y) + alpha * x**2 - kappa * sp.cos(Omega * t))
COUPLED = equations(
    [2 * d(x, 2) + d(y, 2) + 3 * x + y + alpha * x**3, d(x, 2) + 3 * d(y, 2) + x + 5 * y],
    [x, y],
)
"""In its modes: coordinates are sums of amplitudes."""
ROUGH = oscillator(mu * sp.Abs(d(x)) * d(x))

omega_1, omega_2 = sp.symbols("omega_1 omega_2", positive=True)


def hard(order: int) -> tuple[EquationsOfMotion, Expansion, Any]:
    case = HARD.scale({alpha: 1, mu: 1}).expand(order, {3 * Omega: omega})

    def values(e: float) -> tuple[dict[str, float], dict[str, float]]:
        own = {"omega": 1.3, "alpha": 0.7 * e, "mu": 0.2 * e, "F": 0.8, "sigma": 0.4 * e}
        exact = {k: v for k, v in own.items() if k != "sigma"}
        return own, {**exact, "Omega": (own["omega"] + own["sigma"]) / 3}

    return HARD, case, values


def two(order: int) -> tuple[EquationsOfMotion, Expansion, Any]:
    scaled = TWO.scale({alpha: 1, mu: 1, kappa: 1})
    case = scaled.expand(order, {omega_2: 2 * omega_1, Omega: omega_2})

    def values(e: float) -> tuple[dict[str, float], dict[str, float]]:
        small = {"alpha": 0.5 * e, "mu": 0.2 * e, "kappa": 0.6 * e}
        own = {"omega_1": 1.1, **small, "sigma_1": 0.3 * e, "sigma_2": -0.2 * e}
        second = 2 * own["omega_1"] + own["sigma_1"]
        drive = second + own["sigma_2"]
        return own, {"omega_1": 1.1, "omega_2": second, "Omega": drive, **small}

    return TWO, case, values


def coupled(order: int) -> tuple[EquationsOfMotion, Expansion, Any]:
    case = COUPLED.scale({alpha: 1}).expand(order, resonance=None)

    def values(e: float) -> tuple[dict[str, float], dict[str, float]]:
        exact = {"alpha": 0.7 * e}
        own = {p.name: v for p in case.parameters if (v := known(case, exact).get(p.name))}
        return own, exact

    return COUPLED, case, values


def known(case: Expansion, values: Mapping[str, float]) -> dict[str, float]:
    return {k: float(v) for k, v in case.weak.scaled.numbers(values).items()}


def rough(order: int) -> tuple[EquationsOfMotion, Expansion, Any]:
    case = ROUGH.scale({mu: 1}).expand(order, resonance=None)

    def values(e: float) -> tuple[dict[str, float], dict[str, float]]:
        own = {"omega": 1.3, "mu": 0.5 * e}
        return own, own

    return ROUGH, case, values


SYSTEMS = [(hard, 1), (hard, 2), (two, 1), (two, 2), (coupled, 1), (coupled, 2)]
TIMES = np.linspace(-1.5, 2.5, 41)


def distance(system: Any, order: int, epsilon: float) -> float:
    """Between the motion by the slow flow and the exact one, from the same state."""
    eom, case, values = system(order)
    own, exact = values(epsilon)
    n = len(case.coordinates)
    q, v = np.array([0.7, -0.4])[:n], np.array([0.3, 0.5])[:n]
    flow = case.slow_flow
    start = flow.initial_amplitudes(own, q, v)
    made = flow.response(own, flow.evolution(own, start, TIMES), TIMES)
    reference, _ = mg.time_integration(eom, exact, q, v, TIMES)
    return float(np.abs(made - reference).max())


@pytest.mark.filterwarnings("ignore:outside of the validity:UserWarning")
@pytest.mark.parametrize(("system", "order"), SYSTEMS)
def test_motion_from_a_state_is_off_by_one_power_more_than_the_order(
    system: Any, order: int
) -> None:
    """Over a fixed time the omitted terms of slow flow and harmonics are of order ε^{N+1}."""
    errors = [distance(system, order, e) for e in (1 / 32, 1 / 64)]
    # The next term shifts the exponent by a few ε.
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order + 1, abs=0.2)


def test_motion_with_a_force_that_is_not_smooth() -> None:
    """Its harmonics of order one are not known, so that the error is of their order."""
    errors = [distance(rough, 1, e) for e in (1 / 32, 1 / 64)]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(1, abs=0.2)


# --- there and back -------------------------------------------------------------------------------


@given(st.integers(0, 10**6))
@settings(max_examples=25, deadline=None)
def test_amplitudes_of_a_motion_at_its_start_are_those_it_was_made_of(seed: int) -> None:
    numbers = np.random.default_rng(seed)
    _, case, values = two(1)
    own, _ = values(0.1)
    flow = case.slow_flow
    b = numbers.normal(size=(3, 2)) + 1j * numbers.normal(size=(3, 2))
    h, q, v = 1e-3, [], []
    for start in b:
        times = h * np.arange(-3, 4)
        motion = flow.response(own, flow.evolution(own, start, times), times)
        q.append(motion[3])
        v.append(np.array([-1, 9, -45, 0, 45, -9, 1]) @ motion / (60 * h))
    found = flow.initial_amplitudes(own, np.array(q), np.array(v))
    # The difference quotient errs by h⁶ times the seventh derivative over 140, which is at most
    # 2·7.5⁷ = 3e6 (amplitudes of 3 at frequencies of 2.5), and by rounding over h.
    assert np.abs(found - b).max() < h**6 * 3e6 / 140 + 2e-15 / h


def test_arrays_are_as_each_of_their_points() -> None:
    _, case, values = hard(2)
    flow = case.slow_flow
    own = {**values(0.1)[0], "sigma": np.array([[0.02], [0.04]])}
    q, v = np.array([[0.1], [0.5], [-0.3]]), np.array([0.2])
    whole = flow.initial_amplitudes(own, q, v)
    assert whole.shape == (2, 3, 1)
    for j in range(2):
        for k in range(3):
            one = flow.initial_amplitudes({**own, "sigma": own["sigma"][j, 0]}, q[k], v)
            assert np.abs(one - whole[j, k]).max() < 1e-14
    assert flow.initial_amplitudes(own, np.zeros((0, 1, 1, 1)), v).shape == (0, 2, 1, 1)


def test_times_in_any_order_and_at_the_start() -> None:
    _, case, values = two(1)
    own, flow = values(0.1)[0], case.slow_flow
    start = [0.3 + 0.1j, -0.2j]
    times = np.array([[3.0, 0.0], [-2.0, 1.0]])
    found = flow.evolution(own, start, times)
    assert found.shape == (2, 2, 2)
    for place in np.ndindex(2, 2):
        one = flow.evolution(own, start, times[place])
        # Two integrations with other steps, each to 1e-11.
        assert np.abs(found[place] - one).max() < 1e-10
    assert np.array_equal(found[0, 1], np.array(start))


# --- no plain answer ------------------------------------------------------------------------------


def test_far_outside_of_the_scaling_there_is_nothing() -> None:
    """What order one adds is then several times the motion, and the paths from order zero end."""
    _, case, values = hard(1)
    own = {**values(1.0)[0], "alpha": 20.0}
    found = case.slow_flow.initial_amplitudes(own, [[0.01], [0.3], [1.0]], [0.0])
    assert np.isnan(found).all()


@pytest.mark.filterwarnings("ignore:outside of the validity:UserWarning")
def test_what_is_found_far_away_is_a_solution() -> None:
    """Newton's method alone would jump to others."""
    _, case, values = hard(1)
    own, q = values(1.0)[0], np.linspace(0.01, 12.0, 60)[:, None]
    found = case.slow_flow.initial_amplitudes(own, q, [0.0])
    known = np.isfinite(found[:, 0])
    assert 10 < known.sum() < 60
    back = case.slow_flow.response(own, found[known], 0.0)
    # Newton's last step, and the cube of an amplitude of ten.
    assert np.abs(back - q[known]).max() < 1e-9
    # One curve: each is near the one before it.
    first = int(np.argmin(known))
    assert np.abs(np.diff(found[:first, 0])).max() < 0.5


@pytest.mark.parametrize(
    ("q", "v", "match"),
    [
        ([1.0, 2.0], [0.0], r"q must have the shape \(\.\.\., 1\)"),
        ([1.0], 0.0, r"v must have the shape"),
        ([np.nan], [0.0], "q must be real and finite"),
        ([1j], [0.0], "q must be real and finite"),
        ([[1.0], [2.0]], [[1.0], [2.0], [3.0]], "do not broadcast"),
        ([1.0], np.ma.masked_invalid([np.nan]), "v has masked values"),
    ],
)
def test_states_that_are_none_are_refused(q: Any, v: Any, match: str) -> None:
    _, case, values = hard(1)
    with pytest.raises(MmsgenError, match=match):
        case.slow_flow.initial_amplitudes(values(0.1)[0], q, v)


def test_what_cannot_be_integrated_is_refused() -> None:
    _, case, values = hard(1)
    flow, own = case.slow_flow, values(0.1)[0]
    with pytest.raises(MmsgenError, match="one start with one set of values"):
        flow.evolution(own, [[0.1], [0.2]], 1.0)
    with pytest.raises(MmsgenError, match="one start with one set of values"):
        flow.evolution({**own, "sigma": np.zeros(2)}, [0.1], 1.0)
    with pytest.raises(MmsgenError, match="no value is given for sigma"):
        flow.response({k: v for k, v in own.items() if k != "sigma"}, [0.1], 1.0)
    wild = oscillator(-mu * d(x) ** 3).scale({mu: 1}).expand(1, resonance=None).slow_flow
    with pytest.raises(MmsgenError, match="grow beyond all bounds"):
        wild.evolution({"omega": 1.0, "mu": 1.0}, [1.0], 10.0)


# --- the unexpanded equations in time -------------------------------------------------------------


def test_time_integration_of_a_linear_oscillator_is_its_cosine() -> None:
    eom = oscillator(sp.Integer(0))
    times = np.array([[0.0, -3.0], [7.0, 2.0]])
    q, v = mg.time_integration(eom, {omega: 2.0}, [0.3], [0.8], times)
    # Local errors of 1e-12 of each of a few dozen steps.
    exact = 0.3 * np.cos(2 * times) + 0.4 * np.sin(2 * times)
    assert np.abs(q[..., 0] - exact).max() < 1e-10
    assert np.abs(v[..., 0] - (0.8 * np.cos(2 * times) - 0.6 * np.sin(2 * times))).max() < 1e-10


@pytest.mark.parametrize(
    ("change", "match"),
    [
        ({"q": [1.0, 2.0]}, r"q must have the shape \(1,\)"),
        ({"v": [np.inf]}, "v must be real and finite"),
        ({"times": [np.nan]}, "times must be finite"),
        ({"values": {"omega": 1.0}}, "no value is given for alpha"),
        ({"values": {"omega": [1.0, 2.0], "alpha": 1.0}}, "omega must be one number here"),
        ({"values": {"omega": 1.0, "alpha": 1.0, "beta": 2.0}}, "beta is not a parameter"),
    ],
)
def test_time_integration_refuses(change: dict[str, Any], match: str) -> None:
    given: dict[str, Any] = {"values": {"omega": 1.0, "alpha": 1.0}, "q": [0.1], "v": [0.0]}
    with pytest.raises(MmsgenError, match=match):
        mg.time_integration(oscillator(alpha * x**3), **{"times": [1.0], **given, **change})


def test_time_integration_of_what_runs_away_says_so() -> None:
    with pytest.raises(MmsgenError, match=r"cannot be integrated to t = 50 s.*beyond all bounds"):
        mg.time_integration(
            oscillator(-alpha * x**3), {"omega": 1.0, "alpha": 1.0}, [2.0], [1.0], 50.0
        )
