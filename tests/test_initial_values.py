"""Linear slow flows from given initial amplitudes: exponentials, evolution, beating."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
import scipy
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from systems import A, B, Omega, duffing, kappa, linear_rotor, mathieu, omega, pair, x, y

from mmsgen.errors import ExpansionError, MmsgenError
from mmsgen.runtime._beating import beat
from mmsgen.runtime._evolution import exponential

UNIT = 2.0**-52
BOTH = (((0, 0), (1, 0)),)
"""Two amplitudes in one block."""


# --- the exponential ------------------------------------------------------------------------------


def bound(matrix: Any, time: Any) -> Any:
    """What rounding makes of e^{St}: the entries are off by a few u, and e^{‖S‖t} carries it on."""
    size = np.linalg.norm(matrix) * abs(time)
    return 64 * len(matrix) * UNIT * (1 + size) * np.exp(size)


@given(st.integers(0, 10**6), st.integers(1, 6), st.floats(-2.0, 2.0))
@settings(max_examples=40, deadline=None)
def test_exponential_against_scipy(seed: int, n: int, time: float) -> None:
    rng = np.random.default_rng(seed)
    matrix = rng.normal(size=(n, n)) + 1j * rng.normal(size=(n, n))
    ours, other = exponential(matrix, time), scipy.linalg.expm(matrix * time)
    assert np.abs(ours - other).max() <= 2 * bound(matrix, time)


@pytest.mark.parametrize("n", [2, 3, 5])
def test_exponential_of_a_defective_matrix(n: int) -> None:
    rate, time = -0.3 + 2.0j, 1.7
    matrix = rate * np.eye(n) + np.eye(n, k=1)
    exact = sum(
        np.exp(rate * time) * time**k / float(sp.factorial(k)) * np.eye(n, k=k) for k in range(n)
    )
    assert np.abs(exponential(matrix, time) - exact).max() <= bound(matrix, time)
    # Beside it, where two eigenvectors are nearly parallel, the exponential hardly moves.
    near = matrix.copy()
    near[-1, 0] = 1e-15
    moved = exponential(near, time) - exact
    assert np.abs(moved).max() <= bound(matrix, time) + 1e-15 * np.exp(3 * time)


def test_exponentials_at_many_times_are_those_at_each() -> None:
    rng = np.random.default_rng(3)
    matrix = 1j * rng.normal(size=(4, 4))
    times = np.linspace(-30.0, 30.0, 5001)
    many = exponential(matrix, times)
    for k in (0, 17, 2500, 5000):
        assert np.array_equal(many[k], exponential(matrix, times[k]))
    # Forwards and back again: e^{St} e^{−St} = 1.
    size = np.abs(many).max() ** 2 * np.linalg.norm(matrix) * 30.0
    assert np.abs(many[0] @ many[-1] - np.eye(4)).max() <= 1e3 * UNIT * size


def test_exponential_where_decay_leaves_the_range() -> None:
    fast = np.array([[-1000.0, 1.0], [0.0, -1.0]], dtype=complex)
    assert np.allclose(exponential(fast, 2.0)[1, 1], np.exp(-2.0), rtol=8 * UNIT)
    nothing = np.array([[np.nan, 0.0, 0.0]] * 3, dtype=complex)
    assert np.isnan(exponential(nothing, 1.0)).all()


# --- slow flows -----------------------------------------------------------------------------------


@cache
def exchange() -> Any:
    """Two equal oscillators, weakly coupled (reference.md): √(ω² ± εκ)."""
    eom = pair(kappa * y, kappa * x).reparametrise(
        {s: omega for s in sp.symbols("omega_1 omega_2", positive=True)}
    )
    return eom.scale({kappa: 1}).expand(1).slow_flow


@cache
def rotor() -> Any:
    scaled = linear_rotor(3).scale({s: 1 for s in sp.symbols("r_m r_b", positive=True)})
    omega_x, omega_phi = sp.symbols("omega_x omega_phi", positive=True)
    return scaled.expand(1, {Omega: omega_x - omega_phi}).slow_flow


def test_beating_of_two_equal_oscillators() -> None:
    flow = exchange()
    (formula,) = flow.beating_formulas()
    assert formula.period == 2 * sp.pi * omega / kappa
    assert formula.largest[A].subs({A: 1, B: 0}) == formula.largest[B].subs({A: 1, B: 0}) == 1
    values = {"omega": 2.0, "kappa": np.array([0.2, 0.1, 0.05])}
    found = flow.beating(values, [0.3, 0.0])
    # All of the energy passes over: |B_y| reaches |B_x(0)|.
    assert np.allclose(found.largest, 0.3, rtol=16 * UNIT)
    assert (found.margin == 0).all()
    # reference.md: the exact frequencies are √(ω² ± κ), the error of order 1 is of relative ε².
    exact = 2 * np.pi / (np.sqrt(4 + values["kappa"]) - np.sqrt(4 - values["kappa"]))
    errors = np.abs(found.period[:, 0] / exact - 1)
    # What follows is smaller by ε² = κ²/ω⁴ < 3e-3.
    assert np.log2(errors[:-1] / errors[1:]) == pytest.approx(2.0, abs=0.01)


def test_formula_and_number() -> None:
    flow = exchange()
    (formula,) = flow.beating_formulas()
    start = {A: 0.3 + 0.1j, B: -0.2 + 0.5j}
    numbers = {omega: sp.Integer(2), kappa: sp.Rational(1, 5)}
    found = flow.beating({"omega": 2.0, "kappa": 0.2}, list(start.values()))
    for k, a in enumerate(start):
        largest = formula.largest[a].subs({**numbers, **start})
        assert float(largest) == pytest.approx(found.largest[k], rel=32 * UNIT)
    assert float(formula.period.subs(numbers)) == pytest.approx(found.period[0], rel=32 * UNIT)


def test_evolution_against_time_integration_of_the_slow_flow() -> None:
    flow = rotor()
    names = [p.name for p in flow.linear.parameters]
    values = {n: {"sigma": 0.4, "omega_phi": 11.0}.get(n, 0.9) for n in names}
    n = len(flow.case.coordinates)
    start = np.exp(1j * np.arange(n)) / np.arange(1, n + 1)
    times = np.linspace(0.0, 12.0, 7)
    numbers = {p.symbol: values[p.name] for p in flow.linear.parameters}
    slopes = [r.subs(numbers) for r in flow.autonomous.values()]
    rates = sp.lambdify([flow.case.amplitudes], slopes, "numpy")
    solution = scipy.integrate.solve_ivp(
        lambda _, b: np.array(rates(b)), (0, 12), start, "DOP853", times, rtol=1e-12, atol=1e-13
    )
    # The integrator keeps 1e-12 in each of some hundred steps.
    assert np.abs(flow.evolution(values, start, times) - solution.y.T).max() < 1e-9


def test_an_amplitude_and_its_own_conjugate() -> None:
    """Mathieu's equation within its zone: growth and decay, not beating."""
    flow = mathieu().expand(1, {Omega: 2 * omega}).slow_flow
    assert {j for block in flow.linear.blocks for j, _ in block.nodes} == {0}
    values = {"omega": 1.0, "alpha": 0.1, "sigma": np.array([0.0, 0.3])}
    found = flow.beating(values, [1.0])
    assert np.isinf(found.largest[0, 0])
    # At σ = 0: B' = iα B̄/(2ω); real and imaginary part by the sum and difference of e^{±αt/2}.
    times = np.linspace(-20.0, 20.0, 9)
    grown = flow.evolution({**values, "sigma": 0.0}, [1.0], times)
    exact = np.cosh(0.05 * times) + 1j * np.sinh(0.05 * times)
    assert np.allclose(grown[:, 0], exact, rtol=32 * UNIT)
    # Outside, Γ² = α²/4ω² − σ²/4, and |B|² lies between 1 and its value half a period on.
    frequency = np.sqrt(0.15**2 - 0.05**2)
    assert found.period[1, 0] == pytest.approx(np.pi / frequency, rel=64 * UNIT)
    times = np.linspace(0.0, found.period[1, 0], 100001)
    seen = np.abs(flow.evolution({**values, "sigma": 0.3}, [1.0], times)).max()
    assert found.largest[1, 0] == pytest.approx(seen, rel=1e-8)


def test_only_the_fuselage_has_two_frequencies() -> None:
    flow = rotor()
    (formula,) = flow.beating_formulas()
    fuselage = flow.case.amplitudes[0]
    assert list(formula.largest) == [fuselage]
    names = [p.name for p in flow.linear.parameters]
    values = {n: {"sigma": 0.4, "omega_phi": 11.0}.get(n, 0.9) for n in names}
    start = [0.2, 0.0, 0.4, 0.1j, -0.3][: len(flow.case.coordinates)]
    found = flow.beating(values, start)
    table = {s: values[s.name] for s in formula.period.free_symbols}
    assert float(formula.period.subs(table)) == pytest.approx(found.period[0], rel=64 * UNIT)
    table |= dict(zip(flow.case.amplitudes, start, strict=True))
    top = complex(formula.largest[fuselage].subs(table))
    assert top == pytest.approx(found.largest[0], rel=64 * UNIT)
    # Over ten beats on 2000 times each the top is met within (2π/2000)²/8 of itself.
    times = np.linspace(0.0, 10 * found.period[0], 20001)
    seen = np.abs(flow.evolution(values, start, times)).max(axis=0)
    assert found.largest[0] * (1 - 2e-6) < seen[0] < found.largest[0] * (1 + 1e-12)
    assert (seen <= found.largest * (1 + 1e-12)).all()
    assert np.isnan(found.period[2:]).all()


# --- the largest amplitude, in general ------------------------------------------------------------


def largest(matrix: Any, start: Any) -> Any:
    plain = np.array(matrix, dtype=complex)
    return beat(plain, np.zeros_like(plain), BOTH, np.array(start, dtype=complex))


@given(st.integers(0, 10**6))
@settings(max_examples=25, deadline=None)
def test_decaying_amplitudes_reach_what_is_said(seed: int) -> None:
    rng = np.random.default_rng(seed)
    matrix = rng.normal(size=(2, 2)) + 1j * rng.normal(size=(2, 2))
    matrix -= (np.linalg.eigvals(matrix).real.max() + rng.uniform(0.05, 0.5)) * np.eye(2)
    start = rng.normal(size=2) + 1j * rng.normal(size=2)
    found = largest(matrix, start)
    times = np.linspace(0.0, 40.0, 4001)
    seen = np.abs(exponential(matrix, times) @ start[:, None])[..., 0].max(axis=0)
    assert (seen <= (found.largest + found.margin) * (1 + 1e-12)).all()
    # The samples here are (h²/8)·max|d²|x|²/dt²| short of the top, of which ‖S‖ gives the bound.
    bend = 4 * np.linalg.norm(matrix, 2) ** 2 * np.abs(seen).max() ** 2 * 4
    short = bend * (times[1] - times[0]) ** 2 / 8 / np.maximum(seen, 1e-3)
    assert (seen >= found.largest - short).all()


def test_growth_is_unbounded() -> None:
    found = largest([[0.2j, 3.0], [2.0, 0.2j]], [1.0, 0.0])
    assert np.isinf(found.largest).all() and np.isnan(found.period).all()
    # A defective pair of neutral modes grows like t, but not the amplitude that drives the other.
    found = largest([[0.2j, 3.0], [0.0, 0.2j]], [1.0, 0.5])
    assert np.isinf(found.largest[0]) and found.largest[1] == pytest.approx(0.5)


def test_a_defective_pair_that_decays() -> None:
    # x_1 = (1 + 3·½·t) e^{−t/10}: largest where 1.5 − (1 + 1.5t)/10 = 0, t = 28/3.
    found = largest([[-0.1, 3.0], [0.0, -0.1]], [1.0, 0.5])
    exact = 15 * np.exp(-28 / 30)
    assert found.largest[0] <= exact * (1 + 1e-12)
    assert exact <= found.largest[0] + found.margin[0]
    assert found.margin[0] < 0.05 * exact


def test_modes_that_stay_beside_modes_that_decay() -> None:
    # x_1 = e^{it}·1 + e^{−t}: falls from 2 towards 1; started with −1 it comes up to 1 or more.
    matrix = [[1j, 0.0], [0.0, -1.0]]
    found = largest(matrix, [1.0, -1.0])
    assert found.largest.tolist() == [1.0, 1.0]
    turned = np.array([[1.0, 1.0], [0.0, 1.0]])
    found = largest(turned @ np.array(matrix) @ np.linalg.inv(turned), [0.0, -1.0])
    times = np.linspace(0.0, 40.0, 40001)
    exact = np.abs(np.exp(1j * times) - np.exp(-times)).max()
    assert found.largest[0] == pytest.approx(exact, abs=1e-6)
    assert found.margin[0] < 1e-3


def test_the_margin_covers_what_the_samples_miss() -> None:
    """Three modes, one of them 3·10⁴ times as fast as the others beat: its peaks fall between."""
    turned = np.array([[1.0, 1.0, 1.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]])
    rates = np.array([-1e-3, -1e-3 + 0.01j, -1e-3 + 300.1j])
    matrix = turned * rates @ np.linalg.inv(turned)
    start = turned @ np.array([1.0, 1.0, -2.0])
    blocks = (((0, 0), (1, 0), (2, 0)),)
    found = beat(matrix, np.zeros((3, 3), complex), blocks, start.astype(complex))
    # All in phase within the first turn of the fast one: 4 but for a decay of 1e-5.
    times = np.linspace(0.0, 0.05, 5001)
    seen = np.abs(np.exp(np.outer(times, rates)) @ [1.0, 1.0, -2.0]).max()
    assert found.largest[0] < seen * (1 - 1e-5) < found.largest[0] + found.margin[0]


def test_nothing_moves() -> None:
    found = largest(np.zeros((2, 2)), [0.0, 0.4])
    assert found.largest.tolist() == [0.0, 0.4] and np.isnan(found.period).all()


# --- bad input ------------------------------------------------------------------------------------


def test_what_is_refused() -> None:
    flow, values = exchange(), {"omega": 2.0, "kappa": 0.1}
    with pytest.raises(MmsgenError, match=r"shape \(\.\.\., 2\)"):
        flow.evolution(values, [1.0], 0.0)
    with pytest.raises(MmsgenError, match="times must be finite"):
        flow.evolution(values, [1.0, 0.0], np.inf)
    with pytest.raises(MmsgenError, match="times must be real"):
        flow.evolution(values, [1.0, 0.0], 1j)
    with pytest.raises(MmsgenError, match="amplitudes must be finite"):
        flow.beating(values, [np.nan, 0.0])
    with pytest.raises(MmsgenError, match="no value is given for kappa"):
        flow.beating({"omega": 2.0}, [1.0, 0.0])
    with pytest.raises(ExpansionError, match="nonlinear"):
        duffing().expand(1).slow_flow.beating({"omega": 1.0, "alpha": 0.1}, [1.0])
