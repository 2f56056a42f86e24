"""Error estimates against recomputation with more steps, over many random systems.

The mass matrix comes near to singular within the period, so that Legendre series converge slowly
and no faster the further one goes: estimates that count on acceleration are too small there.
"""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from floquet_systems import TIME, linear
from scipy.optimize import linear_sum_assignment

from mmsgen import floquet
from mmsgen.floquet.collocation import gauss_table
from mmsgen.floquet.points import make_points
from mmsgen.floquet.propagation import propagate
from mmsgen.floquet.system import compile_system

a, b, c, d, g = sp.symbols("a b c d g", real=True)
SPEED = sp.Symbol("Omega", positive=True)
PHASE = SPEED * TIME

SYSTEMS = {
    "mass": linear(1 + b * sp.cos(PHASE), c, a),
    "stiffness": linear(1, c, a + d / (1 + b * sp.cos(PHASE))),
    "coupled": linear(
        sp.diag(1 + b * sp.cos(PHASE), 1),
        sp.Matrix([[c, g], [-g, c * sp.cos(PHASE)]]),
        sp.Matrix([[a, d * sp.sin(2 * PHASE)], [d * sp.cos(3 * PHASE), a + 1]]),
    ),
}


def random_values(name: str, seed: int, count: int) -> dict[str, np.ndarray]:
    """Points whose smallest mass, or stiffness, is between a tenth and all of its mean."""
    rng = np.random.default_rng(seed)
    values = {
        "a": rng.uniform(-2, 30, count),
        "b": rng.uniform(-0.9, 0.9, count),
        "c": rng.uniform(-0.3, 0.6, count),
        "d": rng.uniform(-10, 10, count),
        "g": rng.uniform(-3, 3, count),
        "Omega": 10 ** rng.uniform(-0.7, 1.2, count),
    }
    names = {p.name for p in SYSTEMS[name].parameters}
    return {key: value for key, value in values.items() if key in names}


@pytest.mark.parametrize("stages", [11, 16])
@pytest.mark.parametrize("name", SYSTEMS)
def test_estimate_of_the_matrix_holds_near_a_singularity(name: str, stages: int) -> None:
    system, values = SYSTEMS[name], random_values(name, 3, 400)
    compiled = compile_system(system, frozenset(values), None, False)
    arrays = make_points(values, system.parameters, []).arrays
    period = compiled.period(arrays, 400)

    def run(target: float, stages: int):
        return propagate(compiled, arrays, period, np.full(400, target), gauss_table(stages), 4096)

    exact = run(0.0, 14)
    for target in (1e-3, 1e-6, 1e-9):
        result = run(target, stages)
        true = np.linalg.norm(result.matrix - exact.matrix, 2, axis=(1, 2))
        assert np.all(true <= result.error + exact.error)


@pytest.mark.parametrize("name", SYSTEMS)
def test_growth_rates_and_multipliers_are_within_their_errors(name: str) -> None:
    values = random_values(name, 1, 1000)
    exact = floquet.growth_rate(SYSTEMS[name], values, tolerance=1e-13)
    for tolerance in (1e-5, 1e-9):
        result = floquet.growth_rate(SYSTEMS[name], values, tolerance=tolerance)
        assert np.all(np.abs(result.value - exact.value) <= result.error + exact.error)
    rough = floquet.multipliers(SYSTEMS[name], values)
    fine = floquet.multipliers(SYSTEMS[name], values, tolerance=1e-13)
    for k in range(1000):
        gap = np.abs(rough.value[k][:, None] - fine.value[k])
        row, column = linear_sum_assignment(gap)
        assert np.all(gap[row, column] <= rough.error[k][row] + fine.error[k][column])
