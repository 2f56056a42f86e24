"""Error estimates that hold, verdicts that follow from them, and the order of the method."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from floquet_systems import TIME, isotropic, linear, mathieu, rotor
from scipy.special import mathieu_a

from mmsgen import floquet
from mmsgen.floquet.collocation import gauss_table, step_matrices
from mmsgen.floquet.perturbation import eigenvalues_with_error
from mmsgen.floquet.points import make_points
from mmsgen.floquet.propagation import propagate
from mmsgen.floquet.records import judge
from mmsgen.floquet.system import compile_system


def product(system, values, steps: int, stages: int) -> np.ndarray:
    """Monodromy matrix of one point with a fixed number of steps, in units of the phase."""
    compiled = compile_system(system, frozenset(values), None, False)
    arrays = make_points(values, system.parameters, []).arrays
    table, step = gauss_table(stages), 2 * np.pi / steps
    phase = step * (table.nodes[:, None] + np.arange(steps)).ravel()
    data = compiled.coefficients(phase, arrays, compiled.period(arrays, 1))
    size = compiled.size
    data = data.reshape(stages, steps, size, size, 3)
    result = np.eye(2 * size)
    for matrix in step_matrices(data, step, table)[0]:
        result = matrix @ result
    return result


def test_order_of_convergence() -> None:
    # s = 5 stages: order 10. The error regressed on the step, where it is above rounding.
    values = {"a": 3.0, "q": 1.0, "c": 0.1}
    exact = product(mathieu(), values, 40, 12)
    steps = np.array([3, 4, 5, 6, 8])
    error = [np.linalg.norm(product(mathieu(), values, n, 5) - exact) for n in steps]
    assert min(error) > 1e-12
    order = -np.polyfit(np.log(steps), np.log(error), 1)[0]
    assert order == pytest.approx(10, abs=0.5)


def test_undamped_steps_are_symplectic() -> None:
    # Mass 1 and a symmetric stiffness: Φ keeps the symplectic form, at any step size, to rounding.
    stiffness = sp.Matrix([[3 + sp.cos(TIME), sp.sin(TIME)], [sp.sin(TIME), 2]])
    system = linear(sp.eye(2), sp.zeros(2), stiffness)
    phi = product(system, {}, 2, 5)
    form = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.eye(2), np.zeros((2, 2))]])
    assert np.abs(phi.T @ form @ phi - form).max() < 1e-13


def random_system(seed: int, *, damped: bool) -> object:
    """Three coordinates, M, C and K each with two harmonics of different strength."""
    rng = np.random.default_rng(seed)

    def wave(size: float) -> sp.Matrix:
        parts = [sp.Matrix(np.round(rng.normal(size=(3, 3)), 3)) * size for _ in range(2)]
        return parts[0] * sp.cos(TIME) + parts[1] * sp.sin(2 * TIME)

    mass = sp.eye(3) + wave(0.05)
    damping = (sp.Matrix(np.round(rng.normal(size=(3, 3)), 3)) + wave(0.5)) * (0.3 if damped else 0)
    stiffness = sp.diag(*np.round(rng.uniform(0.5, 40, 3), 3).tolist()) + wave(1.0)
    return linear(mass, damping, stiffness)


@pytest.mark.parametrize("stages", [8, 10, 12, 16])
@pytest.mark.parametrize("seed", range(6))
def test_error_estimate_of_the_matrix_holds(seed: int, stages: int) -> None:
    system = random_system(seed, damped=seed % 2 == 0)
    compiled = compile_system(system, frozenset(), None, False)
    period = np.array([2 * np.pi])

    def run(target: float, stages: int, max_steps: int = 4096):
        return propagate(compiled, {}, period, np.array([target]), gauss_table(stages), max_steps)

    # The same method of another order, to rounding: its error is below 1e-3 of what is compared.
    exact = run(0.0, 14)
    for target in (1e-3, 1e-6, 1e-9, 0.0):
        result = run(target, stages)
        true = np.linalg.norm(result.matrix[0] - exact.matrix[0], 2)
        assert true <= result.error[0] + exact.rounding[0]
        assert result.truncation[0] <= max(target, result.rounding[0])


@pytest.mark.parametrize("seed", range(6))
def test_error_estimate_of_the_matrix_is_not_idle(seed: int) -> None:
    # An estimate that is always huge would hold too: here it is within a factor of 1e7 where
    # truncation rules, which for a method of order 20 is a little more than twice the steps.
    compiled = compile_system(random_system(seed, damped=True), frozenset(), None, False)
    period = np.array([2 * np.pi])
    exact = propagate(compiled, {}, period, np.zeros(1), gauss_table(14), 4096)
    result = propagate(compiled, {}, period, np.array([1e-5]), gauss_table(10), 4096)
    true = np.linalg.norm(result.matrix[0] - exact.matrix[0], 2)
    assert result.error[0] <= 1e7 * true


def test_square_root_law_at_a_transition_curve() -> None:
    # On the curve the multipliers form a Jordan block: the growth rate is 0 and cannot be known
    # better than to √E, which the error must say, and no verdict of growth may come of it.
    q = np.linspace(0.5, 3, 11)
    result = floquet.growth_rate(mathieu(), {"a": mathieu_a(1, q), "q": q, "c": 0})
    assert np.all(result.value <= result.error)
    assert np.all(result.error < 1e-5)
    assert result.error.max() > 1e-10
    assert "unstable" not in result.verdict


def test_repeated_semisimple_multipliers_cost_no_precision() -> None:
    # Three equal oscillators: triple multipliers, but no Jordan block.
    a, q = sp.symbols("a q", real=True)
    stiffness = (a - 2 * q * sp.cos(2 * TIME)) * sp.eye(3)
    result = floquet.growth_rate(
        linear(sp.eye(3), sp.zeros(3), stiffness), {"a": [1.0, 2.5], "q": 0.2}
    )
    single = floquet.growth_rate(mathieu(), {"a": [1.0, 2.5], "q": 0.2, "c": 0})
    assert np.all(np.abs(result.value - single.value) <= result.error + single.error)
    assert np.all(result.error < 1e-9)
    assert result.verdict.tolist() == ["unstable", "stable"]


def test_coupled_equal_multipliers_cost_no_precision() -> None:
    # The same three oscillators in other coordinates, so that LAPACK does not see them apart.
    turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    mixed = turn @ np.diag([1.0, 2.0, 3.0])
    other = sp.Matrix(mixed)
    mass = other.T * other
    stiffness = mass * (2.5 - 0.4 * sp.cos(2 * TIME))
    result = floquet.growth_rate(linear(mass, sp.zeros(3), stiffness), {})
    assert result.error < 1e-9
    assert result.verdict == "stable"


@pytest.mark.parametrize("kind", ["simple", "near", "jordan", "semisimple", "triple"])
def test_eigenvalue_bounds_hold_for_random_changes(kind: str) -> None:
    rng = np.random.default_rng(7)
    blocks = {
        "simple": np.diag([1.0, 0.5, -0.3, 2.0]),
        "near": np.array([[1, 1, 0, 0], [0, 1 + 1e-5, 0, 0], [0, 0, -1, 0], [0, 0, 0, 2.0]]),
        "jordan": np.array([[1, 1, 0, 0], [0, 1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 2.0]]),
        "semisimple": np.diag([1.0, 1.0, -1.0, 2.0]),
        "triple": np.array([[1, 1, 0, 0], [0, 1, 1, 0], [0, 0, 1, 0], [0, 0, 0, 2.0]]),
    }
    basis = np.eye(4) + 0.3 * rng.normal(size=(4, 4))
    exact = np.sort_complex(np.linalg.eigvals(blocks[kind]))
    matrix = basis @ blocks[kind] @ np.linalg.inv(basis)
    exact = np.diag(blocks[kind]).astype(complex)
    for size in (1e-6, 1e-9, 1e-12):
        for _ in range(10):
            change = rng.normal(size=(4, 4))
            change *= size / np.linalg.norm(change, 2)
            value, radius = eigenvalues_with_error(
                (matrix + change)[None], np.array([1.01 * size + 1e-15]), np.zeros(1)
            )
            gap = np.abs(exact[:, None] - value)
            # Each exact value is in a disc, each disc holds one: 1e-14 for rounding in `matrix`.
            slack = 1e-7 if kind == "triple" and size < 1e-10 else 1e-14
            assert np.all((gap <= radius + slack).any(axis=0))
            assert np.all((gap <= radius + slack).any(axis=1))
    # Sharpness at the smallest change: cluster of size m costs the m-th root.
    power = {"simple": 1, "near": 2, "jordan": 2, "semisimple": 1, "triple": 3}[kind]
    assert radius.max() <= 200 * size ** (1 / power)


def test_verdicts() -> None:
    value = np.array([-1.0, 1e-16, 1e-12, 1e-6, 1e-6, np.nan])
    error = np.array([1e-9, 1e-13, 1e-13, 1e-5, 1e-7, np.inf])
    verdict, _ = judge(value, error, np.full(6, 1e-8), None)
    assert verdict.tolist() == [
        "stable", "stable", "unstable", "undecided", "unstable", "undecided"
    ]  # fmt: skip
    verdict, level = judge(np.array([0.5, 0.02, 0.9]), np.array([0.1, 0.1, 0.1]), error[:3], 0.5)
    assert verdict.tolist() == ["undecided", "stable", "unstable"]
    assert level.tolist() == [0.5] * 3


def test_what_is_not_resolved_is_undecided() -> None:
    values = {"a": [1.0, 1e10], "q": 0.2, "c": 0}
    result = floquet.growth_rate(mathieu(), values, max_steps=8)
    assert result.verdict.tolist() == ["unstable", "undecided"]
    assert np.isinf(result.error[1])
    huge = floquet.growth_rate(mathieu(), {"a": -1e200, "q": 0.2, "c": 0}, max_steps=8)
    assert np.isinf(huge.error) and huge.verdict == "undecided"
    # Growth beyond the range of doubles over one period.
    steep = floquet.growth_rate(mathieu(), {"a": -1e6, "q": 0.2, "c": 0}, max_steps=2048)
    assert steep.verdict != "stable"


def test_threshold_argument() -> None:
    values = isotropic(Omega=2 * np.pi * np.array([4.4505, 4.7435]))
    plain = floquet.growth_rate(rotor(), values)
    assert plain.verdict.tolist() == ["unstable", "unstable"]
    relaxed = floquet.growth_rate(rotor(), values, threshold=0.5)
    assert relaxed.verdict.tolist() == ["stable", "unstable"]
    assert np.array_equal(plain.value, relaxed.value)


def test_cluster_bound_where_the_estimate_exceeds_the_rounding() -> None:
    # A Jordan block known to 1e-10 but computed to 1e-16: its multipliers are 1e-8 apart and
    # κ is 1e8, so discs of radius N κ E = 4e-2 would say nothing. The square root of E does.
    block = np.array([[1, 1, 0, 0], [0, 1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 2.0]])
    basis = np.eye(4) + 0.2 * np.random.default_rng(3).normal(size=(4, 4))
    matrix = basis @ block @ np.linalg.inv(basis)
    error = 1e-10
    value, radius = eigenvalues_with_error(matrix[None], np.array([error]), np.zeros(1))
    # Coupling and projector of this basis are of size 1: a few times √(2E).
    assert radius.max() < 10 * np.sqrt(2 * error)
    change = np.zeros((4, 4))
    change[1, 0] = error
    moved = np.linalg.eigvals(basis @ (block + change / 4) @ np.linalg.inv(basis))
    assert np.abs(np.subtract.outer(moved, value[0])).min(axis=1).max() <= radius.max()
