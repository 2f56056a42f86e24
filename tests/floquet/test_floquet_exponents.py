"""Exponents, multipliers and monodromy matrices against exact results."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from floquet_systems import TIME, distance_modulo, linear, mathieu, rotating
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from scipy.special import mathieu_a, mathieu_b

from mmsgen import floquet

ENTRY = st.floats(-0.9, 0.9)


def test_mathieu_transition_curves() -> None:
    # scipy's characteristic values are good to 3e-15 relative.
    q = 1.0
    known = [mathieu_a(0, q), mathieu_b(1, q), mathieu_a(1, q), mathieu_b(2, q), mathieu_a(2, q)]
    result = floquet.boundary(mathieu(), {"q": q, "c": 0}, "a", (-1, 5), points=61)
    assert np.all(np.abs(result.value - known) <= result.error + 2e-14)
    assert np.all(result.error < 1e-9)
    assert result.zones[0][0] == -1  # unstable below a0: cut at the end of the interval


def test_largest_growth_of_the_principal_resonance() -> None:
    # x'' + (1 + 2ε cos Ωt)x = 0 at Ω = 2: ε/2 - 15ε³/256 + O(ε⁵); in Mathieu's form a = 1 and
    # q = -ε. Halving ε must divide the remainder by 2⁵.
    epsilon = np.array([0.2, 0.1, 0.05])
    rate = floquet.growth_rate(mathieu(), {"a": 1, "q": -epsilon, "c": 0})
    remainder = rate.value - (epsilon / 2 - 15 * epsilon**3 / 256)
    ratio = remainder[:-1] / remainder[1:]
    # 32 up to the next term, O(ε²) relative, which halves twice.
    assert_allclose(ratio, 32, rtol=0.05)
    assert abs(ratio[1] - 32) < abs(ratio[0] - 32)


@given(
    st.lists(ENTRY, min_size=12, max_size=12),
    st.floats(0.5, 4.0),
)
def test_rotating_constant_system(entries: list[float], speed: float) -> None:
    # Exponents of the periodic system = eigenvalues of the constant one, modulo iΩ, to within the
    # estimate. Diagonals keep M₀ regular.
    numbers = np.array(entries).reshape(3, 2, 2)
    numbers[0] = numbers[0] / 2 + np.eye(2)
    numbers[2] += 2 * np.eye(2)
    symbols = [sp.Matrix(2, 2, sp.symbols(f"{name}1:5", real=True)) for name in ("m", "c", "k")]
    omega = sp.Symbol("Omega", positive=True)
    system = rotating(*symbols, omega)
    values = {str(s): v for m, n in zip(symbols, numbers, strict=True) for s, v in zip(m, n.flat)}
    result = floquet.exponents(system, {**values, "Omega": speed})
    inverse = np.linalg.inv(numbers[0])
    first_order = np.block(
        [[np.zeros((2, 2)), np.eye(2)], [-inverse @ numbers[2], -inverse @ numbers[1]]]
    )
    exact = np.linalg.eigvals(first_order)
    # The exact eigenvalues are rounded too, by their condition: the constant system knows it.
    constant = floquet.exponents(linear(*(sp.Matrix(n) for n in numbers)), {})
    distance = distance_modulo(result.value, exact, speed)
    assert distance.max() <= result.error.max() + constant.error.max()
    assert distance_modulo(constant.value, exact, 1e9).max() <= 2 * constant.error.max()


def test_liouville() -> None:
    # det Φ(T) = exp(-∫ tr M⁻¹C): the trapezoidal rule is exact to rounding for periodic functions.
    g, c = sp.symbols("g c", positive=True)
    wave = sp.cos(TIME)
    mass = sp.Matrix([[2 + wave, g * sp.sin(TIME)], [g * sp.sin(2 * TIME), 1]])
    damping = sp.Matrix([[c * (1 + wave**2), 1], [wave, c]])
    stiffness = sp.Matrix([[3, wave], [0, 2 + sp.sin(TIME)]])
    values = {"g": 0.3, "c": 0.1}
    result = floquet.monodromy(linear(mass, damping, stiffness), values)
    time = np.arange(256) * 2 * np.pi / 256
    numeric = sp.lambdify([TIME, g, c], [mass, damping])
    pairs = [numeric(at, values["g"], values["c"]) for at in time]
    integral = 2 * np.pi * np.mean([np.trace(np.linalg.solve(m, d)) for m, d in pairs])
    # d(det)/det = tr(Φ⁻¹ δΦ)
    slack = (np.abs(np.linalg.inv(result.value)) @ result.error).trace()
    determinant = np.linalg.det(result.value)
    assert abs(determinant / np.exp(-integral) - 1) <= slack + 1e-13
    assert slack < 1e-7


def test_meissner_trace() -> None:
    # A stiffness that jumps is beyond the error theory of smooth coefficients, except where the
    # jumps fall between steps, which the estimate finds by itself (multiples of 4 steps).
    jump = sp.sign(sp.cos(TIME))
    d, e = sp.symbols("d e", positive=True)
    result = floquet.monodromy(linear(1, 0, d + e * jump), {"d": 0.3, "e": 0.1})
    error = np.trace(result.error)
    assert abs(np.trace(result.value) + 2.0471272457476071472) <= error
    assert error < 1e-11


def test_constant_coefficients_need_no_period() -> None:
    k, c = sp.symbols("k c", nonnegative=True)
    system = linear(1, 2 * c, k)
    result = floquet.exponents(system, {"k": [4, 9], "c": 0.5})
    assert result.period is None
    exact = -0.5 + np.array([[-1j, 1j]]) * np.sqrt(np.array([[3.75], [8.75]]))
    assert np.all(np.abs(result.value - exact) <= result.error + 1e-15)
    assert np.all(result.error < 1e-13)
    with pytest.raises(floquet_error(), match="pass period="):
        floquet.multipliers(system, {"k": 4, "c": 0.5})
    found = floquet.multipliers(system, {"k": 4, "c": 0.5}, period=2.0)
    # Sorted by angle: that of exp(2λ) is beyond π, so the pair changes places.
    assert np.all(np.abs(found.value - np.exp(2 * exact[0, ::-1])) <= found.error + 1e-15)
    matrix = floquet.monodromy(system, {"k": 4, "c": 0.5}, period=2.0)
    value = np.linalg.eigvals(matrix.value)
    assert distance_modulo(value, found.value, 1e9).max() < 1e-12


def floquet_error() -> type[Exception]:
    from mmsgen.errors import FloquetError

    return FloquetError


def test_vanishing_modulation_is_the_constant_system() -> None:
    result = floquet.exponents(mathieu(), {"a": 2.0, "q": 0.0, "c": 0.1})
    constant = -0.1 + 1j * np.sqrt(2.0 - 0.01)
    exact = [constant, constant.conjugate()]
    assert distance_modulo(result.value, exact, 2.0).max() <= result.error.max()
    assert result.error.max() < 1e-12


def test_shapes_and_conversions() -> None:
    a = np.array([0.5, 1.0, 3.0])
    grid = floquet.growth_rate(mathieu(), {"a": a[:, None], "q": [0.1, 0.2], "c": 0})
    assert grid.value.shape == grid.error.shape == grid.verdict.shape == (3, 2)
    one = floquet.growth_rate(mathieu(), {"a": 1.0, "q": 0.2, "c": 0})
    assert one.value.shape == () and float(one) == one.value
    # Another step count than in a batch may be chosen for the point: equal within the errors.
    assert abs(np.asarray(grid)[1, 1] - float(one)) <= grid.error[1, 1] + one.error
    empty = floquet.growth_rate(mathieu(), {"a": np.empty((0, 4)), "q": 0, "c": 0})
    assert empty.value.shape == empty.verdict.shape == (0, 4)
    assert floquet.multipliers(mathieu(), {"a": [], "q": 0, "c": 0}).value.shape == (0, 2)
    assert floquet.monodromy(mathieu(), {"a": a, "q": 0, "c": 0}).value.shape == (3, 2, 2)


def test_results_do_not_depend_on_the_number_of_threads() -> None:
    values = {"a": np.linspace(-0.5, 4, 700), "q": 0.5, "c": 0}
    one = floquet.growth_rate(mathieu(), values, workers=1)
    two = floquet.growth_rate(mathieu(), values, workers=2)
    assert np.array_equal(one.value, two.value)
    assert np.array_equal(one.error, two.error)
    assert np.array_equal(one.verdict, two.verdict)


def test_chart_and_interruption() -> None:
    a, q = np.linspace(0.5, 1.5, 60), np.linspace(0, 0.5, 50)
    seen: list[tuple[int, int]] = []
    full = floquet.chart(
        mathieu(), {"c": 0}, {"a": a}, {"q": q}, progress=lambda *done: seen.append(done)
    )
    assert full.complete and full.growth.shape == (50, 60)
    assert seen[-1] == (3000, 3000)
    row = floquet.growth_rate(mathieu(), {"a": a, "q": q[20], "c": 0})
    assert np.all(np.abs(full.growth.value[20] - row.value) <= full.growth.error[20] + row.error)
    part = floquet.chart(
        mathieu(), {"c": 0}, {"a": a}, {"q": q}, progress=lambda done, total: False
    )
    assert not part.complete and part.computed.any()
    assert set(part.growth.verdict[~part.computed]) == {"undecided"}


def test_boundary_where_damping_turns_into_growth() -> None:
    # c is Mathieu's damping: p(t) = e^{-ct} w(t) has growth rate γ(a - c²) - c, so the zone begins
    # where the undamped growth at a - c² equals c. One root is checked against that.
    damping = 0.05
    result = floquet.boundary(mathieu(), {"q": 0.3, "c": damping}, "a", (0.5, 1.5), points=31)
    assert result.value.size == 2 and np.all(result.error < 1e-9)
    undamped = floquet.growth_rate(mathieu(), {"a": result.value - damping**2, "q": 0.3, "c": 0})
    # The growth rate changes by less than its slope, about 1/(2·c) · distance, here ≤ 10 · error.
    assert np.all(np.abs(undamped.value - damping) <= 10 * result.error + undamped.error)


def test_boundary_at_a_given_growth_rate() -> None:
    result = floquet.boundary(
        mathieu(), {"q": 0.3, "c": 0}, "a", (0.5, 1.5), points=31, threshold=0.1
    )
    rate = floquet.growth_rate(mathieu(), {"a": result.value, "q": 0.3, "c": 0})
    assert result.value.size == 2
    # Slopes dγ/da are below 1/γ·q/2 here.
    assert np.all(np.abs(rate.value - 0.1) <= 10 * result.error + rate.error)


def test_boundary_of_a_constant_system() -> None:
    # q'' + [[1, b], [-b, 4]] q = 0: λ² from (λ² + 1)(λ² + 4) + b² = 0, which turns complex at
    # b = 3/2 (flutter), and stays so.
    b = sp.Symbol("b", real=True)
    system = linear(sp.eye(2), sp.zeros(2), sp.Matrix([[1, b], [-b, 4]]))
    result = floquet.boundary(system, {}, b, (0, 4), points=30)
    assert result.value.size == 1 and result.error[0] < 1e-9
    assert abs(result.value[0] - 1.5) <= result.error[0] + 1e-15
    assert result.zones == ((result.value[0], 4.0),)
