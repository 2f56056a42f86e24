"""Matrices of linear slow flows in blocks, against SymPy's determinant and NumPy's eigenvalues."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from systems import (
    Omega,
    alpha,
    beta,
    coupled_mathieu,
    d,
    equations,
    kappa,
    linear_rotor,
    mathieu,
    mu,
    omega_1,
    omega_2,
    pair,
    same,
    sigma,
    t,
    w,
    x,
    y,
    z,
)

from mmsgen.slowflow import SlowFlow

Gamma = sp.Symbol("Gamma")
w_x, w_phi = sp.symbols("omega_x omega_phi", positive=True)


def ring() -> SlowFlow:
    """Four equal oscillators in a ring, damped, excited at the sum of two frequencies."""
    q = (x, y, z, w)
    c = 2 * beta * sp.cos(Omega * t)
    left = [
        d(v, 2) + omega_1**2 * v + alpha * (v - q[(j + 1) % 4]) + kappa * d(q[j - 1])
        for j, v in enumerate(q)
    ]
    left[0] += c * q[1]
    scaled = equations(left, q).scale({alpha: 1, beta: 1, kappa: 1})
    return scaled.expand(1, {Omega: 2 * omega_1}).slow_flow


FLOWS = {
    "mathieu": lambda: mathieu().expand(2, {Omega: 2 * mathieu().frequencies[0]}).slow_flow,
    "coupled": lambda: coupled_mathieu().expand(2, {Omega: omega_1 + omega_2}).slow_flow,
    "damped": lambda: (
        pair(mu * d(x) + 2 * alpha * sp.cos(Omega * t) * y, 2 * beta * sp.cos(Omega * t) * x)
        .scale({mu: 1, alpha: 1, beta: 1})
        .expand(1, {Omega: omega_2 - omega_1})
        .slow_flow
    ),
    "rotor": lambda: (
        linear_rotor(3).scale({"r_m": 1, "r_b": 1}).expand(1, {Omega: w_x + w_phi}).slow_flow
    ),
    "ring": ring,
}


def point(flow: SlowFlow, seed: int) -> dict[sp.Symbol, sp.Expr]:
    """Exact rational values for all parameters."""
    random = np.random.default_rng(seed)
    return {p.symbol: sp.Rational(int(random.integers(1, 40)), 13) for p in flow.case.parameters}


@pytest.mark.parametrize("name", FLOWS)
def test_characteristic_polynomial_is_the_determinant(name: str) -> None:
    """det(Γ − S) by SymPy at exact points: P(Γ) is a polynomial of the degree of S."""
    flow = FLOWS[name]()
    polynomial = flow.characteristic_polynomial(Gamma)
    for seed in (1, 2):
        values = point(flow, seed)
        matrix = sp.Matrix(flow.matrix.subs(values)).applyfunc(sp.nsimplify)
        whole = matrix.charpoly(Gamma).as_expr()
        gap = sp.Poly(sp.expand(whole - polynomial.subs(values), complex=False), Gamma)
        # Roots of unity such as e^{2πi/3} leave radicals: compared in 50 digits.
        assert all(abs(sp.N(c, 50)) < sp.Float("1e-40") for c in gap.all_coeffs())


@pytest.mark.parametrize("name", FLOWS)
def test_the_matrix_is_the_slow_flow(name: str) -> None:
    """S times the variables is dB/dt, conjugated where a variable is: 50 digits at exact points."""
    flow = FLOWS[name]()
    rates = flow.matrix * sp.Matrix(flow.variables)
    numbers = point(flow, 3)
    sizes = {a: sp.Rational(j + 2, 3) + sp.I / (j + 3) for j, a in enumerate(flow.case.amplitudes)}
    for rate, variable in zip(rates, flow.variables, strict=True):
        bare = sp.conjugate(variable) if variable.is_Function else variable
        expected = flow.autonomous[bare].subs(numbers).subs(sizes)
        if bare != variable:
            expected = sp.conjugate(expected)
        assert abs(sp.N(rate.subs(numbers).subs(sizes) - expected, 50, maxn=500)) < sp.Float(
            "1e-40"
        )


@pytest.mark.parametrize("name", FLOWS)
def test_blocks_are_closed_and_disjoint(name: str) -> None:
    """Every amplitude is in exactly one block, itself or conjugated; blocks cannot be split."""
    flow = FLOWS[name]()
    nodes = [node for block in flow.linear.blocks for node in block.nodes]
    assert len(nodes) == len(set(nodes))
    assert {j for j, _ in nodes} == set(range(len(flow.case.amplitudes)))
    for block in flow.linear.blocks:
        size = len(block.nodes)
        reach = np.eye(size, dtype=bool)
        links = np.array([[bool(c) for c in row] for row in block.entries])
        for _ in range(size):
            reach = reach | (reach.astype(int) @ (links | links.T).astype(int) > 0)
        assert reach.all()
        mirrored = {(j, 1 - b) for j, b in block.nodes}
        assert mirrored == set(block.nodes) or not mirrored & set(block.nodes)


@pytest.mark.parametrize("name", FLOWS)
def test_growth_rate_is_the_largest_eigenvalue(name: str) -> None:
    """Against the whole matrix, one point at a time.

    Matrices of size 4 and entries of size 1: 1e-12, and its square root where modes collide.
    """
    flow = FLOWS[name]()
    random = np.random.default_rng(7)
    names = [p.name for p in flow.case.parameters]
    table = {n: random.uniform(0.1, 1.0, 6) for n in names}
    detuned = {r.lhs.name for r in flow.case.relations}
    rates = flow.growth_rate({n: v for n, v in table.items() if n not in detuned})
    whole = sp.lambdify([p.symbol for p in flow.case.parameters], flow.matrix, "numpy")
    for j in range(6):
        matrix = np.array(whole(*(table[n][j] for n in names)), dtype=complex)
        assert rates[j] == pytest.approx(np.linalg.eigvals(matrix).real.max(), abs=1e-7)


def test_factors_multiply_to_the_polynomial() -> None:
    for name in FLOWS:
        flow = FLOWS[name]()
        degree = sum(f.degree * f.multiplicity for f in flow.linear.factors)
        assert degree == len(flow.variables) == flow.matrix.rows


def test_the_ring_by_hand() -> None:
    """Waves of equal oscillators in a ring: without excitation A_m' = (iα(1 − u) − κωū …)A_m/2ω.

    A wave x_j = A u^j with u⁴ = 1 has α(1 − u) and the velocity κ iω u^{-1}: the rate is
    i(α(1 − u) + iκω/u)/(2ω).
    """
    q = (x, y, z, w)
    left = [
        d(v, 2) + omega_1**2 * v + alpha * (v - q[(j + 1) % 4]) + kappa * d(q[j - 1])
        for j, v in enumerate(q)
    ]
    flow = equations(left, q).scale({alpha: 1, kappa: 1}).expand(1).slow_flow
    product = sp.Integer(1)
    for u in (1, sp.I, -1, -sp.I):
        rate = sp.I * (alpha * (1 - u) + sp.I * kappa * omega_1 / u) / (2 * omega_1)
        product *= Gamma - rate
    assert same(flow.characteristic_polynomial(Gamma), sp.expand(product))


def test_a_case_without_coupling() -> None:
    """Nothing of order 1: every amplitude a block of its own, and no parameter occurs."""
    flow = pair(alpha * y, alpha * x).scale({alpha: 1}).expand(1).slow_flow
    assert flow.matrix == sp.zeros(2, 2)
    assert len(flow.linear.blocks) == 2 and flow.linear.parameters == ()
    assert flow.characteristic_polynomial(Gamma) == Gamma**2
    assert flow.growth_rate({"sigma": 0.0} if sigma in flow.linear.parameters else {}) == 0.0
