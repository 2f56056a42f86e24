"""Floquet: points per second for the 12-state rotor, and the ratio to scipy's solve_ivp.

Run with ``make bench``. The points lie between 1 and 8 Hz, where the rotor has wide and narrow
zones; times contain step control, eigenvalues and error bounds. `solve_ivp` integrates the matrix
equation Φ' = A(t)Φ point by point with DOP853 at a tolerance that gives a similar error (both
errors are printed), M(t) inverted at each stage as a user would write it.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from statistics import median

import numpy as np
import pytest
import rotor as model
from scipy.integrate import solve_ivp

from mmsgen import floquet
from mmsgen.equations import EquationsOfMotion

HERTZ = 2 * np.pi
POINTS = 2048


@pytest.fixture(scope="module")
def rotor() -> EquationsOfMotion:
    equations = model.helicopter(4).equations_of_motion().linearise()
    return model.in_ratios(model.undamped(model.isotropic(equations)))


def speeds(points: int = POINTS) -> np.ndarray:
    return HERTZ * np.linspace(1, 8, points)


def test_growth_rates(benchmark: Callable, rotor: EquationsOfMotion) -> None:
    values = {**model.paper_values(rotor), "Omega": speeds()}
    floquet.growth_rate(rotor, values)  # compiled once
    result = benchmark(floquet.growth_rate, rotor, values)
    benchmark.extra_info["points_per_second"] = POINTS / benchmark.stats.stats.median
    benchmark.extra_info["largest_error"] = float(result.error.max())
    assert np.all(result.error < 1e-9)


def test_growth_rates_one_thread(benchmark: Callable, rotor: EquationsOfMotion) -> None:
    values = {**model.paper_values(rotor), "Omega": speeds()}
    floquet.growth_rate(rotor, values, workers=1)
    benchmark(floquet.growth_rate, rotor, values, workers=1)
    benchmark.extra_info["points_per_second"] = POINTS / benchmark.stats.stats.median


def test_boundary(benchmark: Callable, rotor: EquationsOfMotion) -> None:
    values = model.paper_values(rotor)
    interval = (4 * HERTZ, 7 * HERTZ)
    result = benchmark(floquet.boundary, rotor, values, "Omega", interval, points=201)
    assert result.value.size == 4


def by_solve_ivp(rotor: EquationsOfMotion, speed: float) -> np.ndarray:
    """Φ(T) by integrating the matrix equation of one point."""
    import sympy as sp

    values = {**model.paper_values(rotor), "Omega": speed}
    symbols = {p.symbol: values[p.name] for p in rotor.parameters}
    matrices = [matrix.subs(symbols) for matrix in (rotor.M, rotor.C, rotor.K)]
    evaluate = sp.lambdify(rotor.time, matrices, modules="numpy", cse=True)
    size = rotor.M.shape[0]

    def rate(at: float, flat: np.ndarray) -> np.ndarray:
        mass, damping, stiffness = evaluate(at)
        state = flat.reshape(2 * size, 2 * size)
        force = damping @ state[size:] + stiffness @ state[:size]
        return np.concatenate([state[size:], -np.linalg.solve(mass, force)]).ravel()

    start = time.perf_counter()
    result = solve_ivp(
        rate, (0, HERTZ / speed), np.eye(2 * size).ravel(), method="DOP853", rtol=1e-10, atol=1e-12
    )
    by_solve_ivp.seconds = time.perf_counter() - start  # type: ignore[attr-defined]
    return result.y[:, -1].reshape(2 * size, 2 * size)


def test_ratio_to_solve_ivp(benchmark: Callable, rotor: EquationsOfMotion) -> None:
    # Both in the same run, on the same points: a few of them for solve_ivp, whose compilation of
    # the right-hand side is not counted.
    values = model.paper_values(rotor)
    few = speeds(9)
    many = {**values, "Omega": speeds()}
    floquet.growth_rate(rotor, many)
    seconds, errors = [], []
    exact = floquet.monodromy(rotor, {**values, "Omega": few}, tolerance=1e-15)
    for place, speed in enumerate(few):
        matrix = by_solve_ivp(rotor, float(speed))
        seconds.append(by_solve_ivp.seconds)  # type: ignore[attr-defined]
        errors.append(np.abs(matrix - exact.value[place]).max())
    ours = floquet.monodromy(rotor, {**values, "Omega": few})
    benchmark(floquet.growth_rate, rotor, many)
    per_point = benchmark.stats.stats.median / POINTS
    ratio = sum(seconds) / len(seconds) / per_point
    benchmark.extra_info.update(
        points_per_second=1 / per_point,
        solve_ivp_points_per_second=len(seconds) / sum(seconds),
        ratio=ratio,
        median_ratio=median(seconds) / per_point,
        solve_ivp_error=float(max(errors)),
        error=float(np.abs(ours.value - exact.value).max()),
    )
    print(
        f"\nFloquet {1 / per_point:.0f} points/s, solve_ivp {len(seconds) / sum(seconds):.1f}: "
        f"ratio {ratio:.0f}; errors {benchmark.extra_info['error']:.0e} and {max(errors):.0e}"
    )
