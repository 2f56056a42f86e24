"""Stability boundaries and growth rates against published curves and exact eigenvalues."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.special import mathieu_a, mathieu_b
from systems import (
    Omega,
    alpha,
    beta,
    coupled_mathieu,
    d,
    duffing,
    equations,
    f,
    kappa,
    mathieu,
    mu,
    omega,
    omega_1,
    omega_2,
    oscillator,
    pair,
    same,
    sigma,
    t,
    x,
    y,
)

from mmsgen.errors import ExpansionError
from mmsgen.slowflow import SlowFlow

f12, f21 = sp.symbols("f_12 f_21", positive=True)
Gamma = sp.Symbol("Gamma")


def through(expression: sp.Expr, order: int) -> sp.Expr:
    """A polynomial in α without its powers beyond the order."""
    terms = sp.expand(expression)
    return sp.Add(*(terms.coeff(alpha, n) * alpha**n for n in range(order + 1)))


# --- Mathieu --------------------------------------------------------------------------------------


def test_mathieu_in_detuning_form() -> None:
    """x'' + (1 + 2ε cos Ωt)x: Ω = 2 ± ε − ε²/8; Ω = 1 − 5ε²/6 and 1 + ε²/6. DLMF 28.6, inverted."""
    low, high = (
        e.subs(omega, 1) for e in mathieu().expand(2, {Omega: 2 * omega}).slow_flow.boundary()
    )
    assert same(low, -alpha - alpha**2 / 8)
    assert same(high, alpha - alpha**2 / 8)
    low, high = (e.subs(omega, 1) for e in mathieu().expand(2, {Omega: omega}).slow_flow.boundary())
    assert same(low, -5 * alpha**2 / 6)
    assert same(high, alpha**2 / 6)


# DLMF 28.6.2 to 28.6.6, q for α; w'' + (a − 2q cos 2z)w.
CHARACTERISTIC = {
    1: (
        1 - alpha - alpha**2 / 8 + alpha**3 / 64 - alpha**4 / 1536,
        1 + alpha - alpha**2 / 8 - alpha**3 / 64 - alpha**4 / 1536,
    ),
    2: (
        4 - alpha**2 / 12 + 5 * alpha**4 / 13824,
        4 + 5 * alpha**2 / 12 - 763 * alpha**4 / 13824,
    ),
}


@pytest.mark.parametrize("n", [1, 2])
def test_characteristic_values_of_mathieus_equation(n: int) -> None:
    """b_n and a_n through q⁴ from ω = n + σ: a = ω² at the edges."""
    scaled = oscillator(-2 * alpha * sp.cos(2 * t) * x).scale({alpha: 1})
    edges = scaled.expand(4, {omega: n}).slow_flow.boundary()
    for edge, exact in zip(edges, CHARACTERISTIC[n], strict=True):
        assert through((n + edge) ** 2, 4) == sp.expand(exact)


@pytest.mark.parametrize(("n", "order"), [(1, 3), (2, 3), (3, 3), (3, 5), (1, 5)])
def test_boundaries_against_scipy(n: int, order: int) -> None:
    """Zones 1 to 3; the error falls like q^{order+1}: from q = 0.2 to 0.1 by 2^{order+1}.

    scipy's values are good to 3e-15, the differences are above 1e-8; the next order shifts the
    exponent by less than 0.5 at these q. The zone of n = 3 has a width of order q³.
    """
    scaled = oscillator(-2 * alpha * sp.cos(2 * t) * x).scale({alpha: 1})
    flow = scaled.expand(order, {omega: n}).slow_flow
    low, high = (sp.lambdify(alpha, e) for e in flow.boundary())
    for edge, exact in ((low, mathieu_b), (high, mathieu_a)):
        errors = [abs((n + edge(q)) ** 2 - exact(n, q)) for q in (0.2, 0.1)]
        assert np.log2(errors[0] / errors[1]) > order + 0.5
        assert errors[1] > 1e-12


def test_largest_growth_of_mathieus_equation() -> None:
    """ε/2 − 15ε³/256 at Ω = 2, from order 3, and ε/2 − 14ε³/256 at the best Ω, 2 − ε²/8.

    The second was confirmed with Floquet exponents to 14 digits: at ε = 0.1 the coefficient of
    ε³/256 in the largest growth is −13.987, at ε = 0.2 it is −13.945; at Ω = 2, −14.958.
    """
    flow = mathieu().expand(3, {Omega: 2 * omega}).slow_flow
    polynomial = sp.Poly(flow.characteristic_polynomial(Gamma).subs(omega, 1), Gamma)
    one, none, square = polynomial.all_coeffs()
    assert (one, none) == (1, 0)
    still = sp.series(sp.sqrt(-square.subs(sigma, 0)), alpha, 0, 4).removeO()
    assert sp.expand(still - alpha / 2 + 15 * alpha**3 / 256) == 0
    centre, b = sp.symbols("centre b")
    trial = b * alpha**2 + centre * alpha**3
    slope = through((-square).diff(sigma).subs(sigma, trial), 3)
    assert slope.coeff(alpha, 0) == slope.coeff(alpha, 1) == 0
    (best,) = sp.solve([slope.coeff(alpha, 2), slope.coeff(alpha, 3)], [b, centre], dict=True)
    largest = sp.series(sp.sqrt(through((-square).subs(sigma, trial.subs(best)), 4)), alpha, 0, 4)
    assert best[b] == -sp.Rational(1, 8)
    assert sp.expand(largest.removeO() - alpha / 2 + 14 * alpha**3 / 256) == 0


def test_growth_rate_is_the_root_of_the_polynomial() -> None:
    """Numbers against the closed form √(α²/4ω² − σ²/4) of order 1, inside and outside."""
    flow = mathieu().expand(1, {Omega: 2 * omega}).slow_flow
    detunings = np.linspace(-0.3, 0.3, 25)
    rates = flow.growth_rate({"alpha": 0.2, "omega": 1.3, "sigma": detunings})
    inside = (0.2 / 1.3) ** 2 / 4 - detunings**2 / 4
    # Eigenvalues of a 2 × 2 matrix of size 0.1: √(1e-16)·0.1 where two of them collide.
    assert np.allclose(rates, np.sqrt(np.maximum(inside, 0)), atol=1e-9)
    assert same(
        flow.characteristic_polynomial(Gamma),
        Gamma**2 + sigma**2 / 4 - alpha**2 / (4 * omega**2),
    )


def test_damped_mathieu() -> None:
    """δ = 1 ± ε√(1 − 4k²) − ε²/8 with c = εk: the damped principal zone."""
    k = sp.Symbol("k", positive=True)
    eom = oscillator(2 * mu * d(x) + 2 * alpha * sp.cos(2 * t) * x)
    flow = eom.scale({alpha: 1, mu: 1}).expand(2, {omega: 1}).slow_flow
    low, high = flow.boundary()
    for sign, edge in ((-1, low), (1, high)):
        expected = 1 + sign * alpha * sp.sqrt(1 - 4 * k**2) - alpha**2 / 8
        numbers = {k: sp.Rational(3, 10), alpha: sp.Rational(1, 7)}
        value = (1 + edge).subs(mu, k * alpha).subs(k, numbers[k]) ** 2
        series = sp.series(sp.expand(value), alpha, 0, 3).removeO()
        assert sp.simplify(series - expected.subs(k, numbers[k])) == 0
    verdict = flow.stability
    assert verdict.unstable is None and "> 0" in verdict.reason
    assert np.isnan(flow.boundaries({"alpha": 0.1, "mu": 0.2})).all()
    assert flow.boundaries({"alpha": 0.1, "mu": 0.01})[1] > 0


# --- combination resonances -----------------------------------------------------------------------


def test_sum_combination() -> None:
    """σ = ±√(f_12 f_21/(ω_1 ω_2)): Nayfeh and Mook (1979), chapter 5."""
    flow = coupled_mathieu().expand(1, {Omega: omega_1 + omega_2}).slow_flow
    low, high = flow.boundary()
    half = sp.sqrt(f12 * f21 / (omega_1 * omega_2))
    assert sp.simplify(high - half) == 0 and sp.simplify(low + half) == 0
    assert flow.stability.unstable is True


@pytest.mark.parametrize("relation", [omega_2 - omega_1, omega_1 - omega_2], ids=str)
def test_difference_combination(relation: sp.Expr) -> None:
    """Stable with couplings of one sign, whatever their size; unstable with opposite signs."""
    flow = coupled_mathieu().expand(1, {Omega: relation}).slow_flow
    assert flow.stability.unstable is False
    assert flow.boundary() == ()
    assert "exchange energy" in flow.stability.reason
    numbers = {"f_12": 0.3, "f_21": 2.0, "omega_1": 1.0, "omega_2": 2.0}
    assert np.isnan(flow.boundaries({**numbers, "f_12": np.ones(3)})).all()
    rates = flow.growth_rate({**numbers, "sigma": np.linspace(-1, 1, 9)})
    assert np.all(rates < 1e-14)  # eigenvalues of a 2 × 2 matrix of size 1
    c = 2 * sp.cos(Omega * t)
    opposite = pair(c * f12 * y, -c * f21 * x).scale({f12: 1, f21: 1})
    flow = opposite.expand(1, {Omega: relation}).slow_flow
    low, high = flow.boundary()
    assert sp.simplify(high**2 - f12 * f21 / (omega_1 * omega_2)) == 0
    assert flow.stability.unstable is True and low == -high


def test_sign_of_the_coupling_decides() -> None:
    """With a real coupling of unknown sign the verdict is open, and says on what it depends."""
    free = sp.Symbol("g", real=True)
    c = 2 * sp.cos(Omega * t)
    flow = (
        pair(c * f12 * y, c * free * x)
        .scale({f12: 1, free: 1})
        .expand(1, {Omega: omega_1 + omega_2})
        .slow_flow
    )
    assert flow.stability.unstable is None
    assert "g" in flow.stability.reason and "> 0" in flow.stability.reason
    numbers = {"f_12": 0.1, "omega_1": 1.0, "omega_2": 2.0}
    zones = flow.boundaries({**numbers, "g": np.array([0.2, -0.2])})
    assert zones[0, 1] == pytest.approx(0.1, rel=1e-12) and np.isnan(zones[1]).all()


def damped_pair(d_1: sp.Expr, d_2: sp.Expr, order: int = 1) -> SlowFlow:
    """Two damped coordinates at the sum combination resonance."""
    c = 2 * alpha * sp.cos(Omega * t)
    eom = pair(2 * d_1 * d(x) + c * y, 2 * d_2 * d(y) + beta * c / alpha * x)
    orders = {p.symbol: 1 for p in eom.parameters if p.symbol not in (omega_1, omega_2, Omega)}
    return eom.scale(orders).expand(order, {Omega: omega_1 + omega_2}).slow_flow


@pytest.mark.parametrize("order", [1, 2])
def test_damped_criterion_against_eigenvalues(order: int) -> None:
    """Inside of the zone the largest eigenvalue is positive, outside negative, at the edge zero.

    Widths and dampings of size 0.01 to 0.1: eigenvalues of 2 × 2 matrices are good to 1e-16, and
    1e-9 of a width moves the growth rate by more than 1e-13.
    """
    flow = damped_pair(*sp.symbols("d_1 d_2", positive=True), order)
    random = np.random.default_rng(3)
    size = 200
    numbers = {n: 0.1 * random.uniform(0.2, 1, size) for n in ("alpha", "beta")}
    numbers |= {n: 0.02 * random.uniform(0.2, 1, size) for n in ("d_1", "d_2")}
    numbers |= {"omega_1": random.uniform(0.5, 1, size), "omega_2": random.uniform(1.5, 2, size)}
    zones = flow.boundaries(numbers)
    found = ~np.isnan(zones[:, 0])
    assert 20 < found.sum() < size
    low, high = zones.T
    width = high - low
    for fraction, sign in ((-0.01, -1), (0.01, 1), (0.5, 1), (0.99, 1), (1.01, -1)):
        rates = flow.growth_rate({**numbers, "sigma": np.where(found, low + fraction * width, 0.0)})
        assert np.all(sign * rates[found] > 1e-9)
    edge = flow.growth_rate({**numbers, "sigma": np.where(found, high, 0.0)})
    assert np.all(np.abs(edge[found]) < 1e-11)
    assert np.all(edge[~found] < 0)


DAMPERS = sp.symbols("d_1 d_2", positive=True)
SIGNS = {
    "both": (DAMPERS[0], DAMPERS[1], None),
    "one feeds, damped on the whole": (-DAMPERS[0], 3 * DAMPERS[0], True),
    "both feed": (-DAMPERS[0], -DAMPERS[1], True),
    "one without": (DAMPERS[0], sp.Integer(0), True),
    "one feeds alone": (-DAMPERS[0], sp.Integer(0), True),
}


@pytest.mark.parametrize("name", SIGNS)
def test_negative_damping_is_not_overlooked(name: str) -> None:
    """The verdict against the largest growth over a range of detunings."""
    d_1, d_2, unstable = SIGNS[name]
    flow = damped_pair(d_1, d_2)
    assert flow.stability.unstable is unstable
    numbers = {
        "alpha": 0.01,
        "beta": 0.01,
        "d_1": 0.02,
        "d_2": 0.03,
        "omega_1": 1.0,
        "omega_2": 2.0,
    }
    needed = {str(p.name) for p in flow.case.parameters}
    values = {n: v for n, v in numbers.items() if n in needed}
    growth = flow.growth_rate({**values, "sigma": np.linspace(-0.5, 0.5, 101)}).max()
    if unstable:
        assert growth > 1e-8
        with pytest.raises(ExpansionError, match=r"growth_rate"):
            flow.boundary()
    else:
        assert len(flow.boundary()) == 2
        assert growth < 0


def test_dampers_that_may_be_zero() -> None:
    """μ ≥ 0: an idle damped mode cannot grow, so the boundary of the other one is found."""
    free = sp.Symbol("mu_0", nonnegative=True)
    c = 2 * sp.cos(Omega * t)
    eom = pair(free * d(x) + c * alpha * x, free * d(y))
    flow = eom.scale({free: 1, alpha: 1}).expand(1, {Omega: 2 * omega_1}).slow_flow
    verdicts = {v.kind: v.unstable for v in flow.stability.verdicts}
    assert verdicts == {"damped": False, "dissipative": None}
    assert len(flow.boundary()) == 2
    zone = flow.boundaries({"mu_0": 0.0, "alpha": 0.1, "omega_1": 2.0})
    assert zone == pytest.approx([-0.05, 0.05], rel=1e-12)


def test_neutral_and_damped_cases() -> None:
    """Without resonance: modes turn, decay or grow, and there is no boundary."""
    free = pair(alpha * y, alpha * x).scale({alpha: 1}).expand(2).slow_flow
    assert free.stability.unstable is False and free.boundary() == ()
    assert "turns without growing" in free.stability.reason
    damped = oscillator(2 * mu * d(x)).scale({mu: 1}).expand(2).slow_flow
    assert damped.stability.unstable is False and "decays" in damped.stability.reason
    fed = oscillator(-2 * mu * d(x)).scale({mu: 1}).expand(2).slow_flow
    assert fed.stability.unstable is True and "grows" in fed.stability.reason
    assert fed.growth_rate({"mu": 0.1, "omega": 1.0}) == pytest.approx(0.1, rel=1e-14)
    with pytest.raises(ExpansionError, match="no single boundary"):
        fed.boundary()


# --- equilibria of nonlinear slow flows -----------------------------------------------------------


def eliminated(flow: SlowFlow, multiple: int) -> tuple[sp.Expr, sp.Symbol]:
    """cos²(mγ) + sin²(mγ) − 1 at an equilibrium: the frequency response equation in a."""
    (a, radial), (angle, turning) = flow.polar.items()
    c, s = sp.symbols("c s")
    known = {sp.cos(multiple * angle): c, sp.sin(multiple * angle): s}
    equations = [sp.expand(e).subs(known) for e in (radial, turning)]
    assert not any(e.has(angle) for e in equations)
    (solution,) = sp.solve(equations, [c, s], dict=True)
    return sp.together(solution[c] ** 2 + solution[s] ** 2 - 1), a


def test_mathieu_duffing_equilibria() -> None:
    """a² = 4(σ ± √(f² − 4μ²))/(3α), ω = 1: (3αa²/4 − σ)² = f² − 4μ²."""
    eom = oscillator(2 * mu * d(x) + 2 * f * sp.cos(Omega * t) * x + alpha * x**3, sp.Integer(1))
    flow = eom.scale({mu: 1, f: 1, alpha: 1}).expand(1, {Omega: 2}).slow_flow
    response, a = eliminated(flow, 2)
    expected = ((3 * alpha * a**2 / 4 - sigma) ** 2 + 4 * mu**2 - f**2) / f**2
    assert same(response, expected)


def test_parametrically_excited_van_der_pol() -> None:
    """a² = 4(1 + √(f² − σ²)), ω = 1, with μ for the strength of the self-excitation."""
    eom = oscillator(-mu * (1 - x**2) * d(x) + 2 * f * sp.cos(Omega * t) * x, sp.Integer(1))
    flow = eom.scale({mu: 1, f: 1}).expand(1, {Omega: 2}).slow_flow
    response, a = eliminated(flow, 2)
    expected = ((mu * (a**2 / 4 - 1)) ** 2 - f**2 + sigma**2) / f**2
    assert same(response, expected)


def test_primary_response_of_duffing() -> None:
    """[μ² + (σ − 3αa²/8ω)²]a² = k²/4ω²: Nayfeh and Mook (1979), chapter 4."""
    eom = oscillator(2 * mu * d(x) + alpha * x**3 - kappa * sp.cos(Omega * t))
    flow = eom.scale({mu: 1, alpha: 1, kappa: 1}).expand(1, {Omega: omega}).slow_flow
    response, a = eliminated(flow, 1)
    left = (mu**2 + (sigma - 3 * alpha * a**2 / (8 * omega)) ** 2) * a**2
    assert same(response, 4 * omega**2 * left / kappa**2 - 1)


def hard_forced(relation: dict) -> SlowFlow:
    eom = oscillator(2 * mu * d(x) + alpha * x**3 - kappa * sp.cos(Omega * t))
    return eom.scale({mu: 1, alpha: 1}).expand(1, relation).slow_flow


def test_superharmonic_response() -> None:
    """[μ² + (σ − 3αΛ²/ω − 3αa²/8ω)²]a² = α²Λ⁶/ω², Λ = K/(2(ω² − Ω²)) at resonance."""
    size = sp.Rational(9, 16) * kappa / omega**2
    response, a = eliminated(hard_forced({3 * Omega: omega}), 1)
    shift = sigma - 3 * alpha * size**2 / omega - 3 * alpha * a**2 / (8 * omega)
    left = (mu**2 + shift**2) * a**2
    assert same(response, left * omega**2 / (alpha**2 * size**6) - 1)


def test_subharmonic_response() -> None:
    """9μ² + (σ − 9αΛ²/ω − 9αa²/8ω)² = 81α²Λ²a²/(16ω²), and the two amplitudes of the reference."""
    size = -kappa / (16 * omega**2)
    response, a = eliminated(hard_forced({Omega: 3 * omega}), 3)
    shift = sigma - 9 * alpha * size**2 / omega - 9 * alpha * a**2 / (8 * omega)
    left = 9 * mu**2 + shift**2
    assert same(response, left * 16 * omega**2 / (81 * alpha**2 * size**2 * a**2) - 1)
    values = {omega: 1, alpha: 1, mu: sp.Rational(1, 20), kappa: 8, sigma: 6}
    numerator = sp.Poly(sp.numer(sp.together(response.subs(values))), a)
    roots = sorted({abs(complex(r)) for r in numerator.nroots(30) if abs(sp.im(r)) < 1e-20})
    # Nine digits are printed.
    assert roots == pytest.approx([1.39465604, 2.39198687], abs=5e-9)


# --- refusals -------------------------------------------------------------------------------------


def test_no_boundary_of_a_nonlinear_flow() -> None:
    flow = duffing().expand(1).slow_flow
    for attempt in (flow.boundary, lambda: flow.boundaries({}), lambda: flow.growth_rate({})):
        with pytest.raises(ExpansionError, match="nonlinear or forced"):
            attempt()


def test_upright_pendulum_is_refused_with_a_reason() -> None:
    """Kapitza's pendulum: its stiffness is negative at leading order, nothing oscillates there."""
    z = sp.Symbol("z", positive=True)
    terms = -(omega**2) * sp.sin(x) + z * Omega**2 * sp.cos(Omega * t) * sp.sin(x)
    with pytest.raises(ValueError, match=r"x\(t\).*does not oscillate.*-omega\*\*2 < 0"):
        equations([d(x, 2) + terms], [x]).scale({z: 1}, amplitude=1)


def test_values_broadcast_together() -> None:
    """Also those that a result does not depend on."""
    flow = coupled_mathieu().expand(1, {Omega: omega_1 + omega_2}).slow_flow
    numbers = {
        "f_12": 0.1,
        "f_21": 0.1,
        "omega_1": 1.0,
        "omega_2": np.ones((3, 1)),
        "sigma": np.zeros(4),
    }
    assert flow.growth_rate(numbers).shape == (3, 4)
    assert flow.boundaries({**numbers, "omega_2": 2.0, "f_12": np.ones(5), "sigma": 0.0}).shape == (
        5,
        2,
    )
    assert isinstance(flow.growth_rate({**numbers, "omega_2": 2.0, "sigma": 0.0}), float)
