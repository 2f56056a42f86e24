"""Exact formulas for one amplitude: against published ones, other eliminations, and numbers.

Published results: Nayfeh and Mook, Nonlinear Oscillations (1979), chapters 2, 4 and 5.
"""

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
    duffing,
    equations,
    f,
    k,
    mu,
    omega,
    omega_1,
    omega_2,
    oscillator,
    sigma,
    t,
    theta,
    van_der_pol,
    x,
)

from mmsgen.errors import ExpansionError
from mmsgen.runtime._flow import spectrum
from mmsgen.slowflow import SlowFlow
from mmsgen.symbols import modulus, phase

a = modulus(x)
DUFFING = d(x, 2) + omega**2 * x + 2 * mu * d(x) + alpha * x**3


def forced(order: int, resonance: dict[sp.Expr, sp.Expr], weak: bool) -> SlowFlow:
    scales = {alpha: 1, mu: 1, **({k: 1} if weak else {})}
    left = DUFFING - k * sp.cos(Omega * t)
    return equations([left], [x]).scale(scales).expand(order, resonance).slow_flow


def parametric(left: sp.Expr, order: int = 1) -> SlowFlow:
    left = d(x, 2) + (1 + 2 * f * sp.cos(Omega * t)) * x + left
    scales = {s: 1 for s in (alpha, mu, f) if left.has(s)}
    return equations([left], [x]).scale(scales).expand(order, {Omega: 2}).slow_flow


def driven_van_der_pol(order: int) -> SlowFlow:
    left = d(x, 2) + x - mu * (1 - x**2) * d(x) + alpha * x**3 - k * sp.cos(Omega * t)
    scaled = equations([left], [x]).scale({alpha: 1, mu: 1, k: 1})
    return scaled.expand(order, {Omega: 1}).slow_flow


def proportional(found: sp.Expr, published: sp.Expr) -> bool:
    """Whether a published relation is the one found, times a factor without a and σ."""
    ratio = sp.cancel(sp.together(published) / found)
    return ratio != 0 and not ratio.has(a) and not ratio.has(sigma)


# --- published relations --------------------------------------------------------------------------


def test_primary_resonance() -> None:
    published = (mu**2 + (sigma - 3 * alpha * a**2 / (8 * omega)) ** 2) * a**2 - k**2 / (
        4 * omega**2
    )
    flow = forced(1, {Omega: omega}, weak=True)
    assert proportional(flow.response_relation(), published)
    assert flow.backbone() == {sigma: 3 * alpha * a**2 / (8 * omega)}


def test_superharmonic_resonance() -> None:
    size = k / (2 * (omega**2 - omega**2 / 9))
    inner = sigma - 3 * alpha * size**2 / omega - 3 * alpha * a**2 / (8 * omega)
    flow = forced(1, {3 * Omega: omega}, weak=False)
    published = (mu**2 + inner**2) * a**2 - alpha**2 * size**6 / omega**2
    assert proportional(flow.response_relation(), published)
    assert sp.expand(flow.backbone()[sigma] - (sigma - inner)) == 0


def test_subharmonic_resonance() -> None:
    size = k / (2 * (omega**2 - 9 * omega**2))
    inner = sigma - 9 * alpha * size**2 / omega - 9 * alpha * a**2 / (8 * omega)
    flow = forced(1, {Omega: 3 * omega}, weak=False)
    published = 9 * mu**2 + inner**2 - 81 * alpha**2 * size**2 * a**2 / (16 * omega**2)
    assert proportional(flow.response_relation(), published)
    assert sp.expand(flow.backbone()[sigma] - (sigma - inner)) == 0
    assert set(flow.bifurcation_equations()) == {"saddle-node"}


def test_parametric_resonances() -> None:
    flow = parametric(2 * mu * d(x) + alpha * x**3)
    published = (a**2 - 4 * sigma / (3 * alpha)) ** 2 - 16 * (f**2 - 4 * mu**2) / (9 * alpha**2)
    assert proportional(flow.response_relation(), published)
    (rest,) = flow.bifurcation_equations()["pitchfork"]
    assert proportional(rest, sigma**2 - f**2 + 4 * mu**2)
    cycle = parametric(-mu * (1 - x**2) * d(x)).response_relation().subs(mu, 1)
    assert proportional(cycle, (a**2 / 4 - 1) ** 2 - (f**2 - sigma**2))


def test_free_oscillators() -> None:
    """Shifts of the frequency: −15/256 for Duffing; 2 and 2 + μ²/64, −μ²/16 for van der Pol."""
    y = alpha * a**2 / omega**2
    shift = duffing().expand(2).slow_flow.backbone()[phase(x)]
    assert sp.expand(shift - omega * (3 * y / 8 - 15 * y**2 / 256)) == 0
    quadratic = oscillator(alpha * x**2 + beta * x**3).scale({alpha: 1, beta: 2}).expand(2)
    published = (9 * beta * omega**2 - 10 * alpha**2) * a**2 / (24 * omega**3)
    assert sp.expand(quadratic.slow_flow.backbone()[phase(x)] - published) == 0
    cycle = van_der_pol().expand(2).slow_flow
    assert cycle.response_relation() == a - 2
    assert sp.expand(cycle.backbone()[phase(x)].subs(a, 2) + mu**2 / 16) == 0
    third = van_der_pol().expand(3).slow_flow.response_relation()
    expanded = sp.series(third.subs(a, 2 + mu**2 / 64), mu, 0, 4).removeO()
    assert expanded == 0


# --- other eliminations ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    "flow",
    [
        forced(2, {Omega: omega}, weak=True),
        forced(2, {Omega: 3 * omega}, weak=False),
        parametric(2 * mu * d(x) + alpha * x**3, 2),
        forced(3, {Omega: omega}, weak=True),
    ],
    ids=["primary", "subharmonic", "parametric", "order three"],
)
def test_the_relation_divides_the_resultant(flow: SlowFlow) -> None:
    """That of SymPy for E = e^{iγ} in the complex form and its conjugate, at exact numbers.

    Its square-free part without a power of a is the relation: degrees are compared as well.
    """
    case = flow.case
    numbers = {p.symbol: sp.Rational(3 + 2 * j, 7 + j) for j, p in enumerate(case.parameters)}
    (b,) = case.amplitudes
    e, r = sp.symbols("E r", positive=True)
    plain = sp.expand(
        flow.autonomous[b].subs(numbers).subs(sp.conjugate(b), r / e).subs(b, r * e) * e**8
    )
    bar = sp.expand(plain.xreplace({sp.I: -sp.I}).subs(e, 1 / e) * e**16)
    both = []
    for form in (plain, bar):
        polynomial = sp.Poly(form, e, r, domain="QQ_I")
        lowest = min(m[0] for m in polynomial.monoms())
        both.append(polynomial.exquo(sp.Poly(e**lowest, e, r, domain="QQ_I")))
    eliminated = sp.Poly(both[0].resultant(both[1]).as_expr(), r, domain="QQ_I").monic()
    real = sp.Poly([sp.Rational(c) for c in eliminated.all_coeffs()], r)
    radical = sp.sqf_part(real.as_expr())
    relation = sp.Poly(flow.response_relation().subs(numbers).subs(a, 2 * r), r)
    quotient, rest = sp.div(sp.Poly(radical, r), relation)
    assert rest.is_zero
    assert quotient.degree() == 0 or quotient.monic().as_expr() == r


@pytest.mark.parametrize("order", [1, 2, 3])
def test_equilibria_satisfy_the_relation(order: int) -> None:
    """Rounding of the amplitudes, 1e-12, times the relation's slope."""
    flow = forced(order, {Omega: omega}, weak=True)
    values = {omega: 1.0, alpha: 0.4, mu: 0.03, k: 0.2}
    relation = flow.response_relation().subs(values)
    found = flow.equilibria({**values, sigma: np.linspace(0.1, 0.5, 7)})
    value, slope = (sp.lambdify((a, sigma), e) for e in (relation, sp.diff(relation, a)))
    sizes, sigmas = np.broadcast_arrays(found.modulus[..., 0], np.linspace(0.1, 0.5, 7)[:, None])
    some = np.isfinite(sizes)
    left = value(sizes[some], sigmas[some]) / slope(sizes[some], sigmas[some])
    assert np.abs(left).max() < 1e-11


# --- bifurcations ---------------------------------------------------------------------------------


def solved(equations: tuple[sp.Expr, ...], values: dict, start: tuple[float, float]) -> np.ndarray:
    """σ and a at which two equations hold, by Newton's method in 30 digits."""
    numbers = {s: sp.Float(str(v), 30) for s, v in values.items()}
    numeric = [e.subs(numbers) for e in equations]
    return np.array(sp.nsolve(numeric, (sigma, a), start, prec=30), dtype=float).ravel()


def near(flow: SlowFlow, values: dict, point: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """B of the equilibrium at σ whose amplitude is nearest to a, and its Jacobian's eigenvalues."""
    numbers = {str(s): float(v) for s, v in values.items()} | {"sigma": point[0]}
    found = flow.equilibria(numbers)
    b = found.amplitudes[np.nanargmin(np.abs(found.modulus[:, 0] - point[1]))]
    return b, spectrum(flow.table.flow, flow.table.numbers(numbers), b)


@pytest.mark.parametrize("order", [1, 2])
def test_saddle_nodes(order: int) -> None:
    """Where they are, an eigenvalue vanishes, up to the square root of the rounding."""
    flow = forced(order, {Omega: omega}, weak=True)
    values = {omega: 1, alpha: 0.4, mu: 0.03, k: 0.2}
    point = solved(flow.bifurcation_equations()["saddle-node"], values, (0.23, 0.72))
    b, rates = near(flow, values, point)
    assert 2 * abs(b[0]) == pytest.approx(point[1], rel=1e-6)
    assert abs(rates[0]) < 1e-6 and rates[1].real < -0.05
    # On either side of the fold there are two equilibria more or less.
    numbers = {str(s): float(v) for s, v in values.items()}
    counts = flow.equilibria({**numbers, "sigma": point[0] * np.array([1 - 1e-6, 1 + 1e-6])}).number
    assert abs(int(counts[1]) - int(counts[0])) == 2


@pytest.mark.parametrize("order", [1, 2])
def test_hopf_points(order: int) -> None:
    """A driven van der Pol oscillator loses its lock: a pair of eigenvalues on the axis, 1e-10.

    At order two the trace depends on the phase, which is eliminated there.
    """
    flow = driven_van_der_pol(order)
    values = {mu: 0.1, k: 0.2, alpha: 0.05}
    point = solved(flow.bifurcation_equations()["Hopf"], values, (-0.03, 1.41))
    b, rates = near(flow, values, point)
    assert 2 * abs(b[0]) == pytest.approx(point[1], rel=1e-10)
    assert abs(rates.real).max() < 1e-10 and rates[0].imag > 0.01


def test_kinds_that_cannot_occur_are_missing() -> None:
    damped = forced(1, {Omega: omega}, weak=True).bifurcation_equations()
    assert set(damped) == {"saddle-node"}
    assert van_der_pol().expand(1).slow_flow.bifurcation_equations() == {}
    negative = sp.Symbol("delta", real=True)
    left = d(x, 2) + x + negative * d(x) + mu * x**2 * d(x)
    free = equations([left], [x]).scale({negative: 1, mu: 1}).expand(1).slow_flow
    # With a sign that is open, zero gives birth to a limit cycle at δ = 0.
    assert free.bifurcation_equations() == {"Hopf": (negative,)}


# --- what is refused ------------------------------------------------------------------------------


def test_a_constant_phase_of_the_force_is_turned_away() -> None:
    left = DUFFING - k * sp.cos(Omega * t + theta)
    scaled = equations([left], [x]).scale({alpha: 1, mu: 1, k: 1})
    for order in (1, 2):
        turned = scaled.expand(order, {Omega: omega}).slow_flow.response_relation()
        assert turned == forced(order, {Omega: omega}, weak=True).response_relation()


def test_refused() -> None:
    with pytest.raises(ExpansionError, match="fill a curve"):
        duffing().expand(1).slow_flow.response_relation()
    with pytest.raises(ExpansionError, match="needs values and an amplitude"):
        coupled_mathieu().expand(1, {Omega: omega_1 + omega_2}).slow_flow.backbone()
    two = [DUFFING - k * sp.cos(Omega * t) - beta * sp.cos(Omega * t / 3 + theta)]
    flow = equations(two, [x]).scale({alpha: 1, mu: 1, k: 1}).expand(1, {Omega: omega}).slow_flow
    with pytest.raises(ExpansionError, match="constant phases"):
        flow.response_relation()
