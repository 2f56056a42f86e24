"""Coupled leading orders: against modal coordinates by hand, eigenvalues and Floquet theory."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from systems import Omega, alpha, beta, d, equations, f, k, kappa, p, same, t, x, y, z

import mmsgen as mg
from mmsgen.errors import ScalingError
from mmsgen.loading import load
from mmsgen.runtime._eigenmodes import eigenmodes, modal_values, real_roots
from mmsgen.sampling import scaled_values
from mmsgen.scaling import ScaledSystem

m, m_2, G = sp.symbols("m m_2 G", positive=True)
PAIR = {"k": 3.0, "kappa": 1.3, "m": 1.1, "m_2": 1.7, "f": 0.9, "sigma": 0.21}
SHAFT = {"k": 3.0, "kappa": 1.3, "G": 0.4, "f": 0.9, "alpha": 0.3, "sigma": 0.21}


def masses(first: sp.Expr = 0, second: sp.Expr = 0, heavier: sp.Expr = m_2) -> ScaledSystem:
    """Two masses on springs k, joined by a spring κ; f and α are small."""
    left = [
        m * d(x, 2) + k * x + kappa * (x - y) + first,
        heavier * d(y, 2) + k * y + kappa * (y - x) + second,
    ]
    eom = equations(left, [x, y])
    small = {s: 1 for s in (f, alpha) if s in {q.symbol for q in eom.parameters}}
    return eom.scale(small)


def shaft(first: sp.Expr, second: sp.Expr) -> ScaledSystem:
    """A whirling shaft: gyroscopic terms ±G, stiffness k and κ; f and α are small."""
    left = [d(x, 2) + G * d(y) + k * x + first, d(y, 2) - G * d(x) + kappa * y + second]
    eom = equations(left, [x, y])
    small = {s: 1 for s in (f, alpha, beta) if s in {q.symbol for q in eom.parameters}}
    return eom.scale(small)


# --- numbers --------------------------------------------------------------------------------------


def random_matrices(n: int, count: int = 5) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    rng = np.random.default_rng(n)
    a, b, c = rng.standard_normal((3, count, n, n))
    unit = np.eye(n)
    return (
        a @ a.transpose(0, 2, 1) + unit,
        c - c.transpose(0, 2, 1),
        b @ b.transpose(0, 2, 1) + unit,
    )


@pytest.mark.parametrize("n", [1, 2, 3, 5])
def test_eigenmodes_of_symmetric_matrices(n: int) -> None:
    inertia, _, stiffness = random_matrices(n)
    omega, shapes = eigenmodes(inertia, None, stiffness)
    for j in range(len(inertia)):
        squares = scipy.linalg.eigh(stiffness[j], inertia[j], eigvals_only=True)
        # LAPACK is backward stable: a few hundred units of the norms at these sizes
        np.testing.assert_allclose(omega[j] ** 2, squares, rtol=1e-11)
        np.testing.assert_allclose(shapes[j].imag, 0, atol=1e-12)
        product = shapes[j].T @ inertia[j] @ shapes[j]
        np.testing.assert_allclose(product, np.eye(n), atol=1e-11)


@pytest.mark.parametrize("n", [2, 3, 4])
def test_eigenmodes_of_gyroscopic_matrices(n: int) -> None:
    inertia, gyroscopic, stiffness = random_matrices(n)
    omega, shapes = eigenmodes(inertia, gyroscopic, stiffness)
    for j in range(len(inertia)):
        solved = np.linalg.solve(inertia[j], np.hstack([stiffness[j], gyroscopic[j]]))
        companion = np.block([[np.zeros((n, n)), np.eye(n)], [-solved]])
        exact = np.sort(np.linalg.eigvals(companion).imag)[n:]
        np.testing.assert_allclose(omega[j], exact, rtol=1e-10)
        for r in range(n):
            w, phi = omega[j, r], shapes[j, :, r]
            left = (stiffness[j] + 1j * w * gyroscopic[j] - w**2 * inertia[j]) @ phi
            np.testing.assert_allclose(left, 0, atol=1e-10 * w**2)
            norm = phi.conj() @ (2 * w * inertia[j] - 1j * gyroscopic[j]) @ phi
            np.testing.assert_allclose(norm, 2 * w, rtol=1e-11)


def test_shapes_in_quadrature_are_real_and_imaginary() -> None:
    turn, stiffness = np.array([[0.0, 0.7], [-0.7, 0.0]]), np.diag([2.0, 3.0])
    omega, shapes = eigenmodes(np.eye(2), turn, stiffness, (False, True))
    plain, _ = eigenmodes(np.eye(2), turn, stiffness)
    np.testing.assert_allclose(omega, plain, rtol=1e-13)
    np.testing.assert_array_equal(shapes[0].imag, 0.0)
    np.testing.assert_array_equal(shapes[1].real, 0.0)
    # equal stiffness: forward and backward whirl, each an exact circle
    _, circles = eigenmodes(np.eye(2), turn, 2 * np.eye(2), (False, True))
    np.testing.assert_allclose(np.abs(circles[0]), np.abs(circles[1]), rtol=1e-13)


def test_matrices_that_are_not_definite_give_nothing() -> None:
    inertia = np.stack([np.eye(2), np.eye(2), np.diag([1.0, -1.0])])
    stiffness = np.stack([np.eye(2), np.diag([1.0, 0.0]), np.eye(2)])
    omega, shapes = eigenmodes(inertia, None, stiffness)
    assert np.isfinite(omega).all(axis=1).tolist() == [True, False, False]
    assert np.isfinite(shapes).all(axis=(1, 2)).tolist() == [True, False, False]


def test_roots_of_polynomials() -> None:
    np.testing.assert_allclose(real_roots([[6, -5, 1], [-8, 2, 1]]), [[2, 3], [-4, 2]], rtol=1e-14)


# --- symmetric ------------------------------------------------------------------------------------


def test_equal_masses_as_in_modal_coordinates_by_hand() -> None:
    """x, y = (η_1 ± η_2)/√(2m), ω_1² = k/m, ω_2² = (k + 2κ)/m; F = (αx³, 0) acts on both alike."""
    scaled = masses(first=alpha * x**3, heavier=m)
    omega_1, omega_2 = scaled.frequencies
    known = {q.symbol: q.definition for q in scaled.parameters if q.definition is not None}
    assert same(known[omega_1] ** 2, k / m) and same(known[omega_2] ** 2, (k + 2 * kappa) / m)
    unit = 1 / sp.sqrt(2 * m)
    signs = {"Phi_x_1": 1, "Phi_x_2": 1, "Phi_y_1": 1, "Phi_y_2": -1}
    shapes = {q.symbol: signs[q.name] * unit for q in scaled.parameters if q.name in signs}

    cube = alpha * (unit * (x + y)) ** 3 * unit
    by_hand = equations(
        [d(x, 2) + omega_1**2 * x + cube, d(y, 2) + omega_2**2 * y + cube], [x, y]
    ).scale({alpha: 1})
    for order in (1, 2):
        own, other = scaled.expand(order), by_hand.expand(order)
        names = dict(zip(own.amplitudes, other.amplitudes, strict=True))
        for a, rate in own.solvability[order].items():
            mine = rate.xreplace(shapes).xreplace(names)
            assert same(mine, other.solvability[order][names[a]])


def test_multiplied_equations_are_the_same_system() -> None:
    """What makes M0 and K0 symmetric is found: equations over their own inertia, say."""
    plain = masses(first=f * sp.cos(Omega * t) * x)
    left = [plain.eom.equations[0] / m, sp.expand(plain.eom.equations[1] / m_2)]
    divided = equations(left, [x, y]).scale({f: 1})
    relation = {Omega: 2 * plain.frequencies[0]}
    values = {**PAIR, "sigma": 0.01}
    rates = []
    for scaled in (plain, divided):
        rates.append(scaled.expand(2, relation).slow_flow.growth_rate(values))
    # Shapes scale with the multipliers; growth does not.
    assert rates[0] > 0.01 and rates[0] == pytest.approx(rates[1], rel=1e-12)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("signs", [(1, 1), (-1, 1), (2, 0)], ids=str)
def test_parametric_certificates(order: int, signs: tuple[int, int]) -> None:
    scaled = masses(first=f * sp.cos(Omega * t) * x)
    omega_1, omega_2, _ = scaled.frequencies
    case = scaled.expand(order, {Omega: signs[0] * omega_1 + signs[1] * omega_2})
    certificate = mg.certify(case, PAIR)
    assert certificate.passed
    assert certificate.fits[0].exponent == pytest.approx(order + 1, abs=0.05)
    assert len(certificate.fits) == (1 if signs[0] < 0 else 2)


def test_a_ring_of_masses_has_a_repeated_frequency() -> None:
    """ω² = k/m once and (k + 3κ)/m twice."""
    ring = [
        m * d(a, 2) + k * a + kappa * (2 * a - b - c)
        for a, b, c in ((x, y, z), (y, z, x), (z, x, y))
    ]
    ring[0] += f * sp.cos(Omega * t) * x
    scaled = equations(ring, [x, y, z]).scale({f: 1})
    assert [str(s) for s in scaled.frequencies] == ["omega_1", "omega_2", "Omega"]
    assert scaled.natural_frequencies[1] == scaled.natural_frequencies[2]
    omega_1, omega_2, _ = scaled.frequencies
    values = {name: PAIR[name] for name in ("k", "kappa", "m", "f", "sigma")}
    for relation in ({Omega: omega_1 + omega_2}, {Omega: 2 * omega_2}):
        case = scaled.expand(1, relation)
        assert not any(case.residual().values())
        certificate = mg.certify(case, values)
        assert certificate.fits[0].exponent == pytest.approx(2, abs=0.05)


def test_frequencies_that_are_numbers_or_symbols_stay_so() -> None:
    left = [2 * d(x, 2) + 5 * x - 3 * y, 2 * d(y, 2) + 5 * y - 3 * x + f * x**2]
    numeric = equations(left, [x, y]).scale({f: 1})
    assert numeric.natural_frequencies == ({"1": 1}, {"1": 2})
    assert any(r.kind.startswith("internal") for r in masses(first=alpha * x**2).resonances(1))
    # 1:2 exactly, so that quadratic terms resonate without being told
    terms = numeric.expand(1).solvability[1].values()
    assert all(term != 0 for term in terms)


def test_internal_resonance_of_modes() -> None:
    """ω_2 = 2ω_1 of two masses, quadratic: the springs are tuned to it for every ε."""
    left = [
        m * d(x, 2) + k * x + kappa * (x - y) + alpha * x**2,
        m_2 * d(y, 2) + p * y + kappa * (y - x),
    ]
    scaled = equations(left, [x, y]).scale({alpha: 1})
    omega_1, omega_2 = scaled.frequencies
    values = {"k": 1.1, "p": 5.2, "kappa": 0.7, "m": 1.3, "m_2": 1.9, "alpha": 0.8, "sigma": 0.3}
    for order in (1, 2):
        case = scaled.expand(order, {omega_2: 2 * omega_1})
        assert not any(case.residual().values())
        slow, exact = scaled_values(case, values, 0.125)
        numbers = scaled.numbers({n: v for n, v in exact.items() if not n.startswith("omega")})
        gap = numbers["omega_2"] - 2 * numbers["omega_1"]
        # Newton's method ends at rounding
        assert gap == pytest.approx(0.3 / 8, abs=1e-12) and slow["sigma"] == 0.3 / 8
        certificate = mg.certify(case, values, amplitudes=[0.4 + 0.1j, 0.3 - 0.2j], span=2.0)
        assert certificate.fits[0].exponent == pytest.approx(order, abs=0.15)


# --- gyroscopic -----------------------------------------------------------------------------------


def test_gyroscopic_residual_is_zero() -> None:
    scaled = shaft(alpha * x**3 + f * sp.cos(Omega * t) * d(y, 2), beta * x**2 * d(y))
    omega_1, omega_2, _ = scaled.frequencies
    for relation in (None, {Omega: omega_1 + omega_2}, {omega_2: 3 * omega_1}):
        case = scaled.expand(2, relation)
        assert not any(case.residual().values())


def test_gyroscopic_frequencies_against_eigenvalues() -> None:
    """ε added to the stiffness of x moves the frequencies; orders 1 to 4 leave ε^{N+1}."""
    values = {"k": 3.0, "kappa": 1.3, "G": 0.4}

    def exact(e: float) -> np.ndarray:
        turn = np.array([[0, values["G"]], [-values["G"], 0]])
        stiffness = np.diag([values["k"] + e, values["kappa"]])
        companion = np.block([[np.zeros((2, 2)), np.eye(2)], [-stiffness, -turn]])
        return np.sort(np.linalg.eigvals(companion).imag)[2:]

    scaled = shaft(alpha * x, sp.Integer(0))
    for order in (1, 2, 3, 4):
        flow = scaled.expand(order).slow_flow
        errors = []
        for e in (0.4, 0.2, 0.1):
            numbers = flow.case.numbers({**values, "alpha": e})
            own = {q.symbol: numbers[q.name] for q in flow.case.parameters if q.name in numbers}
            shift = [complex(flow.matrix[j, j].subs(own)).imag for j in (0, 1)]
            found = np.array([numbers["omega_1"] + shift[0], numbers["omega_2"] + shift[1]])
            errors.append(np.abs(found - exact(e)).max())
        for large, small in pairwise(errors):
            assert np.log2(large / small) == pytest.approx(order + 1, abs=0.45)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("signs", [(1, 1), (-1, 1)], ids=str)
def test_gyroscopic_certificates(order: int, signs: tuple[int, int]) -> None:
    c = sp.cos(Omega * t)
    scaled = shaft(f * c * x + alpha * d(x), f * c * y + alpha * d(x, 2))
    omega_1, omega_2, _ = scaled.frequencies
    case = scaled.expand(order, {Omega: signs[0] * omega_1 + signs[1] * omega_2})
    certificate = mg.certify(case, SHAFT)
    assert certificate.fits[0].exponent == pytest.approx(order + 1, abs=0.05)


def test_gyroscopic_motions() -> None:
    scaled = shaft(alpha * x**3, beta * x * y * d(y))
    case = scaled.expand(2)
    values = {**{name: SHAFT[name] for name in ("k", "kappa", "G", "alpha")}, "beta": 0.4}
    certificate = mg.certify(case, values, amplitudes=[0.6 + 0.1j, 0.4 - 0.2j], span=4.0)
    assert certificate.fits[0].exponent == pytest.approx(2, abs=0.15)


def test_modes_in_quadrature_have_one_name_for_each_component() -> None:
    names = [q.name for q in shaft(alpha * x, sp.Integer(0)).parameters]
    assert names[-6:] == [
        *("omega_1", "omega_2", "Phi_x_1", "Phi_x_2", "Theta_y_1", "Theta_y_2"),
    ]


# --- emitted --------------------------------------------------------------------------------------


def test_emitted_modes_are_the_keywords_of_the_other_functions() -> None:
    scaled = masses(first=f * sp.cos(Omega * t) * x)
    omega_1, omega_2 = scaled.frequencies[:2]
    case = scaled.expand(1, {Omega: omega_1 + omega_2})
    module = load(case)
    own = {name: np.array([1.0, 1.2]) * PAIR[name] for name in ("k", "kappa", "m", "m_2")}
    modes = module.modes(**own)
    low, high = module.boundaries(f=0.3, **modes)
    np.testing.assert_allclose(
        np.stack([low, high], axis=-1),
        case.slow_flow.boundaries({**own, "f": 0.3}),
        rtol=1e-12,
    )
    rates = module.growth_rate(sigma=0.001, f=0.3, **modes)
    assert rates.shape == (2,) and (rates > 0).all()
    assert set(modes) == {"omega_1", "omega_2", "Phi_x_1", "Phi_x_2"}


def test_layouts_number_modes_by_factor() -> None:
    """Two factors of degree one, the frequency of the first the higher."""
    entries = [1, 0, 0, 1, 0, 0, 0, 0, 9, 0, 0, 4, -9, 1, -4, 1]
    layout = (2, None, ((1, 1), (1, 1)), (("a", 1.0), ("b", 2.0)), (("c", 0, 0, False),))
    found = modal_values(entries, (layout,))
    assert found["a"] == pytest.approx(3) and found["b"] == pytest.approx(1)
    assert found["c"] == pytest.approx(1)


# --- refusals -------------------------------------------------------------------------------------


def test_a_rigid_body_mode_is_refused() -> None:
    left = [m * d(x, 2) + kappa * (x - y), m_2 * d(y, 2) + kappa * (y - x) + alpha * x**3]
    with pytest.raises(ScalingError, match="x, y has a rigid-body mode"):
        equations(left, [x, y]).scale({alpha: 1})


def test_amplitudes_of_coupled_coordinates_have_one_order() -> None:
    left = [d(x, 2) + k * x + kappa * y + alpha * x**3, d(y, 2) + p * y + kappa * x]
    with pytest.raises(ScalingError, match=r"order ε|need the same order"):
        equations(left, [x, y]).scale({}, amplitude={x: 1, y: 2})


def test_values_without_oscillation() -> None:
    case = shaft(alpha * x, sp.Integer(0)).expand(1)
    flow = case.slow_flow
    with pytest.raises(mg.MmsgenError, match=r"no real value|positive definite"):
        equations([d(x, 2) + k * x + kappa * y, d(y, 2) + k * y + kappa * x], [x, y]).scale(
            {}
        ).numbers({"k": 1.0, "kappa": 2.0})
    assert flow.growth_rate({"k": 1.0, "kappa": 2.0, "G": 0.1, "alpha": 0.1}) == pytest.approx(0)


def test_names_that_are_taken() -> None:
    omega_1 = sp.Symbol("omega_1", positive=True)
    left = [d(x, 2) + k * x + kappa * y + omega_1 * x**3, d(y, 2) + k * y + kappa * x]
    scaled = equations(left, [x, y]).scale({omega_1: 1})
    assert [str(s) for s in scaled.frequencies] == ["omega_mode_1", "omega_2"]
