"""Emitted functions: points per second on arrays, one call on scalars, and the cost of importing.

Run with ``make bench``. The arrays hold ten million points of their own for every argument, so that
nothing is saved by broadcasting; eigenproblems and implicit equations get fewer points. Beside each
time stands the number of points per second.
"""

from __future__ import annotations

import inspect
import os
import subprocess
import sys
import time
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
import pytest
import rotor as model

from mmsgen.codegen import case_name, generate, render
from mmsgen.loading import load_files

RELATIONS: dict[str, Any] = {
    "sum": {model.Omega: model.omega_x + model.omega_phi},
    "both": {model.Omega: model.omega_x + model.omega_phi, model.omega_y: model.omega_x},
}
VALUES = {
    "r_m": 1 / 38,
    "r_b": 0.174,
    "r_a": 0.1865,
    "omega_x": 18.85,
    "omega_y": 25.13,
    "omega_phi": 11.0,
    "omega_b": 9.42,
    "sigma": 0.3,
    "sigma_1": 0.3,
    "sigma_2": 0.1,
}
MILLION = 1_000_000


@pytest.fixture(scope="module")
def scaled() -> Any:
    eom = model.helicopter(4).equations_of_motion().linearise()
    eom = model.at_speed(model.in_ratios(model.undamped(model.isotropic(eom))))
    return eom.scale({model.r_m: 1, model.r_b: 1})


@pytest.fixture(scope="module")
def modules(scaled: Any) -> dict[tuple[str, int], Any]:
    cases = {
        (name, order): scaled.expand(order=order, resonance=relation)
        for name, relation in RELATIONS.items()
        for order in (1, 2)
    }
    loaded = load_files(render(cases.values()), [case_name(c) for c in cases.values()])
    return {key: loaded[case_name(case)] for key, case in cases.items()}


def arrays(function: Any, points: int) -> dict[str, Any]:
    """A generic value of its own for each argument at every point."""
    rng = np.random.default_rng(1)
    names = [name for name in inspect.signature(function).parameters if name in VALUES]
    return {name: VALUES[name] * (1 + 0.01 * rng.random(points)) for name in names}


@pytest.mark.parametrize(
    ("case", "order", "name", "points"),
    [
        ("sum", 1, "boundaries", 10 * MILLION),
        ("sum", 2, "boundaries", 10 * MILLION),
        ("sum", 1, "growth_rate", 10 * MILLION),
        ("sum", 2, "growth_rate", 10 * MILLION),
        ("sum", 1, "critical_speeds", MILLION // 10),
        ("sum", 2, "critical_speeds", MILLION // 10),
        ("sum", 2, "slow_flow_matrix", MILLION // 4),
        ("sum", 2, "characteristic_coefficients", MILLION // 4),
        ("both", 1, "growth_rate", MILLION // 4),
        ("both", 2, "growth_rate", MILLION // 4),
        ("both", 1, "boundaries", MILLION // 10),
        ("both", 1, "critical_speeds", MILLION // 200),
    ],
)
def test_points_per_second(
    benchmark: Any, modules: Any, case: str, order: int, name: str, points: int
) -> None:
    function = getattr(modules[case, order], name)
    values = arrays(function, points)
    benchmark.pedantic(function, kwargs=values, rounds=5, warmup_rounds=1)
    benchmark.extra_info["points_per_second"] = points / benchmark.stats.stats.median
    rate = points / benchmark.stats.stats.median
    print(f"\n{name}, {case}, order {order}: {rate:.3g} points per second")


def test_growth_rate_against_the_eigenvalues_alone(benchmark: Any, modules: Any) -> None:
    """What LAPACK takes for the same companion matrices, without anything around it."""
    function = modules["both", 1].growth_rate
    points = MILLION // 4
    values = arrays(function, points)
    companions = np.zeros((points, 3, 3))
    companions[:, 1:, :-1] = np.eye(2)
    companions[:, :, -1] = np.random.default_rng(2).normal(size=(points, 3))
    alone = []
    for _ in range(5):
        start = time.perf_counter()
        np.linalg.eigvals(companions)
        alone.append(time.perf_counter() - start)
    benchmark.pedantic(function, kwargs=values, rounds=5, warmup_rounds=1)
    ratio = benchmark.stats.stats.median / median(alone)
    print(f"\ngrowth_rate takes {ratio:.2f} times as long as numpy.linalg.eigvals alone")


@pytest.mark.parametrize("name", ["boundaries", "growth_rate", "critical_speeds", "slow_flow"])
def test_one_point(benchmark: Any, modules: Any, name: str) -> None:
    function = getattr(modules["sum", 1], name)
    leading = [np.ones(6)] if name == "slow_flow" else []
    names = [n for n in inspect.signature(function).parameters if n in VALUES]
    benchmark(function, *leading, **{n: VALUES[n] for n in names})


def test_import(benchmark: Any, scaled: Any, tmp_path: Path) -> None:
    """`import mms_functions.ground_resonance` and one case, beyond NumPy's own import."""
    cases = [scaled.expand(order=1, resonance=r) for r in (*RELATIONS.values(), None)]
    generate(cases, directory=tmp_path)
    path = os.pathsep.join([str(tmp_path), os.environ.get("PYTHONPATH", "")])
    code = (
        "import time, numpy\n"
        "start = time.perf_counter()\n"
        "import mms_functions.ground_resonance\n"
        "middle = time.perf_counter()\n"
        f"import mms_functions.ground_resonance.{case_name(cases[0])}\n"
        "print(middle - start, time.perf_counter() - middle)"
    )

    def run() -> tuple[float, ...]:
        done = subprocess.run(
            [sys.executable, "-c", code],
            env={**os.environ, "PYTHONPATH": path},
            capture_output=True,
            text=True,
            check=True,
        )
        return tuple(map(float, done.stdout.split()))

    run()  # compiles
    times = [run() for _ in range(11)]
    table, case = (1e3 * median(t[k] for t in times) for k in (0, 1))
    print(f"\nbeyond NumPy: {table:.2f} ms for the table of cases, {case:.2f} ms for a case")
    benchmark.pedantic(run, rounds=3)
