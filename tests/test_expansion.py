"""Solvability conditions against published and exactly solvable cases."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from systems import (
    A,
    Ac,
    B,
    Omega,
    alpha,
    beta,
    d,
    duffing,
    equations,
    f,
    k,
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
    van_der_pol,
    x,
    y,
)

from mmsgen.errors import ExpansionError
from mmsgen.symbols import epsilon, time_scale

I = sp.I  # noqa: E741


def rate(scaled: object, order: int, resonance: object = None) -> dict[int, dict]:
    """D_p A_j by order."""
    return scaled.expand(order=order, resonance=resonance).solvability


# --- Duffing --------------------------------------------------------------------------------------


def test_duffing_to_order_three() -> None:
    """Section 4 of the design; Nayfeh and Mook (1979), chapter 2, with A the fundamental."""
    flow = rate(duffing(), 3)
    assert same(flow[1][A], 3 * I * alpha * A**2 * Ac / (2 * omega))
    assert same(flow[2][A], -15 * I * alpha**2 * A**3 * Ac**2 / (16 * omega**3))
    assert same(flow[3][A], 123 * I * alpha**3 * A**4 * Ac**3 / (128 * omega**5))


def exact_backbone(count: int) -> list[mpmath.mpf]:
    """Coefficients of ω in powers of y = εa², from the solution in elliptic functions.

    u'' + u + εu³ = 0 has u = X cn(νt, m) with Y = εX², ν² = 1 + Y and m = Y/(2(1 + Y)). Its
    frequency is πν/(2K), and the fundamental of cn is 2π√q/(√m K (1 + q)) (DLMF 22.11.2). Both are
    analytic in Y around zero, nearest singularity at Y = −1: their Taylor coefficients are Fourier
    coefficients on a circle of radius 1/4, with an aliasing error of 4^-128.
    """
    points, radius = 128, mpmath.mpf(1) / 4

    def taylor(function: object) -> list[mpmath.mpf]:
        values = [
            function(radius * mpmath.expjpi(mpmath.mpf(2 * j) / points)) for j in range(points)
        ]
        return [
            mpmath.fsum(
                v * mpmath.expjpi(-mpmath.mpf(2 * j * n) / points) for j, v in enumerate(values)
            ).real
            / points
            / radius**n
            for n in range(count + 1)
        ]

    def frequency(size: mpmath.mpc) -> mpmath.mpc:
        return mpmath.pi * mpmath.sqrt(1 + size) / (2 * mpmath.ellipk(size / (2 * (1 + size))))

    def fundamental(size: mpmath.mpc) -> mpmath.mpc:
        m = size / (2 * (1 + size))
        nome = mpmath.qfrom(m=m)
        ratio = 2 * mpmath.pi * mpmath.sqrt(nome / m) / (mpmath.ellipk(m) * (1 + nome))
        return size * ratio**2

    by_size, sizes = taylor(frequency), taylor(fundamental)
    # ω = Σ w_n y^n with y = Σ s_k Y^k: compare powers of Y, one after the other.
    powers = [[mpmath.mpf(1)] + [mpmath.mpf(0)] * count]
    for _ in range(count):
        last = powers[-1]
        powers.append(
            [mpmath.fsum(last[i] * sizes[n - i] for i in range(n + 1)) for n in range(count + 1)]
        )
    result: list[mpmath.mpf] = []
    for n in range(count + 1):
        known = mpmath.fsum(w * powers[i][n] for i, w in enumerate(result))
        result.append((by_size[n] - known) / powers[n][n])
    return result


def test_duffing_backbone_to_order_five() -> None:
    """ω = 1 + 3y/8 − 15y²/256 + …: every coefficient against the elliptic integral.

    Tolerance: 40 digits, and a triangular solve whose numbers grow by less than 4^5.
    """
    mpmath.mp.dps = 40
    exact = exact_backbone(5)
    assert abs(exact[1] - mpmath.mpf(3) / 8) < mpmath.mpf("1e-30")
    flow = rate(duffing(), 5)
    for p in range(1, 6):
        number = flow[p][A].subs({omega: 1, alpha: 1}) / (I * A ** (p + 1) * Ac**p) / 4**p
        (value,) = [sp.nsimplify(sp.cancel(number))]
        assert value.is_Rational
        assert abs(mpmath.mpf(int(value.p)) / int(value.q) - exact[p]) < mpmath.mpf("1e-30")


def test_duffing_scales_with_its_frequency() -> None:
    """By the units of α and ω, D_pA goes like ω (α|A|²/ω²)^p."""
    flow = rate(duffing(), 5)
    for p, rates in flow.items():
        assert same(rates[A].subs(omega, 1) * omega ** (1 - 2 * p), rates[A])


# --- other oscillators of one coordinate ----------------------------------------------------------


def test_van_der_pol() -> None:
    """Section 4 of the design."""
    flow = rate(van_der_pol(), 2)
    assert same(flow[1][A], mu * (A - A**2 * Ac) / 2)
    expected = I * mu**2 * (-7 * A**3 * Ac**2 / 16 + A**2 * Ac / 2 - A / 8)
    assert same(flow[2][A], expected)


def test_limit_cycle_of_van_der_pol() -> None:
    """ω = 1 − μ²/16 + 17μ⁴/3072, a = 2 + μ²/64 for the fundamental.

    The frequency: Andersen and Geer, SIAM J. Appl. Math. 42 (1982), 678-693. Nothing is dropped but
    powers of μ beyond what order 4 determines.
    """
    polar = van_der_pol().expand(order=4).slow_flow.polar
    (a, growth), (_, turn) = polar.items()
    r1, r2, r3 = sp.symbols("r1 r2 r3")
    radius = 2 + r1 * mu + r2 * mu**2 + r3 * mu**3
    series = sp.series(sp.expand(growth.subs(a, radius) / mu), mu, 0, 4).removeO()
    (root,) = sp.solve([sp.expand(series).coeff(mu, n) for n in (1, 2, 3)], [r1, r2, r3], dict=True)
    assert sp.expand(series).coeff(mu, 0) == 0
    assert (root[r1], root[r2], root[r3]) == (0, sp.Rational(1, 64), 0)
    frequency = sp.series(sp.expand(turn.subs(a, radius.subs(root))), mu, 0, 5).removeO()
    assert sp.expand(frequency + mu**2 / 16 - 17 * mu**4 / 3072) == 0


def test_quadratic_and_cubic() -> None:
    """ω_0 + ε²(9α₃ω_0² − 10α₂²)a²/(24ω_0³): Nayfeh and Mook (1979), section 2.3."""
    eom = oscillator(alpha * x**2 + beta * x**3)
    flow = rate(eom.scale({alpha: 1, beta: 2}), 2)
    assert flow[1][A] == 0
    coefficient = (9 * beta * omega**2 - 10 * alpha**2) / (24 * omega**3) * 4
    assert same(flow[2][A], I * coefficient * A**2 * Ac)
    by_amplitude = rate(eom.scale({}, amplitude=1), 2)
    assert by_amplitude == flow


def test_pendulum() -> None:
    """θ'' + ω² sin θ: with θ of order ε, ω(1 − a²/16) and the order-4 coefficient of the period.

    Exact: ω_θ = πω/(2K(sin²(X/2))) = ω(1 − X²/16 + X⁴/3072 + …) in the largest angle X, and the
    fundamental is a = X + X³/192 + … (from the Fourier series of the elliptic amplitude), so in a
    the coefficient of a⁴ is 1/3072 + 2/(16·192) = 1/1024.
    """
    eom = equations([d(x, 2) + omega**2 * sp.sin(x)], [x])
    flow = rate(eom.scale({}, amplitude=1), 4)
    assert same(flow[2][A], -I * omega * A**2 * Ac / 4)
    assert same(flow[4][A], I * omega * A**3 * Ac**2 / 64)
    assert flow[1][A] == flow[3][A] == 0


def test_linear_damping_exactly() -> None:
    """x'' + 2μx' + ω²x: A = e^{(−μ + i(√(ω²−μ²) − ω))t} exactly, order by order."""
    flow = rate(oscillator(2 * mu * d(x)).scale({mu: 1}), 6)
    exact = sp.series(-mu + I * (sp.sqrt(1 - mu**2) - 1), mu, 0, 7).removeO()
    for p in range(1, 7):
        expected = sp.expand(exact).coeff(mu, p) * mu**p * omega ** (1 - p)
        assert same(flow[p][A], A * expected)


@pytest.mark.parametrize("power", [2, 3])
def test_stiffness_in_every_derivative(power: int) -> None:
    """(1 + εα)x'' + (ω² + εβ)x: the frequency √((ω²+β)/(1+α)) to any order."""
    orders = {alpha: 1, beta: power - 1}
    flow = rate(oscillator(alpha * d(x, 2) + beta * x).scale(orders), 4)
    e = sp.Symbol("e", positive=True)
    exact = sp.sqrt((omega**2 + beta * e ** (power - 1)) / (1 + alpha * e)) - omega
    expansion = sp.expand(sp.series(exact, e, 0, 5).removeO())
    for p in range(1, 5):
        assert same(flow[p][A], I * A * expansion.coeff(e, p))


# --- two coordinates ------------------------------------------------------------------------------


def test_weakly_coupled_equal_oscillators() -> None:
    """x'' + ω²x + εκy, y'' + ω²y + εκx: the exact frequencies √(ω² ± κ) to order 4."""
    eom = equations(
        [d(x, 2) + omega**2 * x + kappa * y, d(y, 2) + omega**2 * y + kappa * x], [x, y]
    )
    flow = rate(eom.scale({kappa: 1}), 4)
    assert same(flow[1][A], I * kappa * B / (2 * omega))
    assert same(flow[2][A], -I * kappa**2 * A / (8 * omega**3))
    e = sp.Symbol("e", positive=True)
    exact = sp.expand(sp.series(sp.sqrt(omega**2 + kappa * e) - omega, e, 0, 5).removeO())
    for p in range(1, 5):
        expected = I * exact.coeff(e, p) * (B if p % 2 else A)
        assert same(flow[p][A], expected)
        assert same(flow[p][B], expected.subs({A: B, B: A}, simultaneous=True))


def test_coupling_through_inertia_and_gyroscopic_terms() -> None:
    """Exact frequencies of x'' + ω_1²x + κy'' …, of order κ², from the quartic itself."""
    for coupling in ((kappa * d(y, 2), kappa * d(x, 2)), (-kappa * d(y), kappa * d(x))):
        flow = rate(pair(*coupling).scale({kappa: 1}), 4)
        v = sp.Symbol("v")
        entries = [[0, 0], [0, 0]]
        for i, terms in enumerate(coupling):
            for j, q in enumerate((x, y)):
                in_frequency = terms.subs(d(q, 2), -(v**2)).subs(d(q), I * v)
                entries[i][j] = 0 if i == j else in_frequency
        quartic = (omega_1**2 - v**2) * (omega_2**2 - v**2) - entries[0][1] * entries[1][0]
        e, c2, c4 = sp.symbols("e c2 c4")
        trial = omega_1 + c2 * e**2 + c4 * e**4
        gap = sp.expand(quartic.subs(kappa, kappa * e).subs(v, trial))
        (second,) = sp.solve(gap.coeff(e, 2), c2)
        (fourth,) = sp.solve(gap.coeff(e, 4).subs(c2, second), c4)
        assert flow[1][A] == flow[3][A] == 0
        assert same(flow[2][A], I * second * A)
        assert same(flow[4][A], I * fourth * A)


def test_internal_resonance_two_to_one() -> None:
    """x'' + ω_1²x = −2αxy, y'' + ω_2²y = −αx²: Nayfeh and Mook (1979), section 6.5."""
    scaled = pair(2 * alpha * x * y, alpha * x**2).scale({alpha: 1})
    flow = rate(scaled, 1, {omega_2: 2 * omega_1})[1]
    assert same(flow[A], I * alpha * B * Ac / omega_1)
    assert same(flow[B], I * sigma * B + I * alpha * A**2 / (4 * omega_1))


# --- excitation -----------------------------------------------------------------------------------


def test_primary_resonance_of_duffing() -> None:
    """Nayfeh and Mook (1979), section 4.1.1: 2i ω_0(A' + μA) + 3αA²Ā − (k/2)e^{iσt} = 0."""
    eom = oscillator(2 * mu * d(x) + alpha * x**3 - k * sp.cos(Omega * t))
    flow = rate(eom.scale({mu: 1, alpha: 1, k: 1}), 1, {Omega: omega})[1]
    expected = -mu * A + 3 * I * alpha * A**2 * Ac / (2 * omega)
    expected += -I * k * sp.exp(I * sigma * t) / (4 * omega)
    assert same(flow[A], expected)


def test_superharmonic_resonance() -> None:
    """Section 4.1.3 there, 3Ω = ω_0 + εσ, with q_0 = A e^{iω_0t} + Λ e^{iΩt} + c.c.

    2iω_0(A' + μA) + 6αAΛ² + 3αA²Ā + αΛ³e^{iσt} = 0, Λ at the resonant Ω = (ω_0 + σ)/3, which is the
    strict replacement at this order: Λ = K/(2(ω_0² − ω_0²/9)).
    """
    eom = oscillator(2 * mu * d(x) + alpha * x**3 - k * sp.cos(Omega * t))
    flow = rate(eom.scale({mu: 1, alpha: 1}), 1, {3 * Omega: omega})[1]
    size = k / (2 * (omega**2 - omega**2 / 9))
    terms = (
        6 * alpha * A * size**2 + 3 * alpha * A**2 * Ac + alpha * size**3 * sp.exp(I * sigma * t)
    )
    assert same(flow[A], -mu * A + I * terms / (2 * omega))


def test_subharmonic_resonance() -> None:
    """Section 4.1.4 there, Ω = 3ω_0 + εσ: the last term is 3αĀ²Λe^{iσt}."""
    eom = oscillator(2 * mu * d(x) + alpha * x**3 - k * sp.cos(Omega * t))
    flow = rate(eom.scale({mu: 1, alpha: 1}), 1, {Omega: 3 * omega})[1]
    size = k / (2 * (omega**2 - 9 * omega**2))
    terms = 6 * alpha * A * size**2 + 3 * alpha * A**2 * Ac
    terms += 3 * alpha * Ac**2 * size * sp.exp(I * sigma * t)
    assert same(flow[A], -mu * A + I * terms / (2 * omega))


def test_principal_parametric_resonance() -> None:
    """x'' + (ω² + 2εα cos Ωt)x, Ω = 2ω + εσ: D1A = iαĀe^{iσt}/(2ω); second order by hand.

    q_1 = −(α/((3ω)² − ω²))(−1)… e^{3iωt}: its product with e^{−iΩt} gives α²A/(8ω²), and
    D1(D1A) = (iσ/2ω)iαĀe^{iσt} + α²A/(4ω²).
    """
    flow = rate(mathieu(), 2, {Omega: 2 * omega})
    turned = sp.exp(I * sigma * t)
    first = I * alpha * Ac * turned / (2 * omega)
    assert same(flow[1][A], first)
    # 2iω D2A + D1²A + 2i·(…) + [α e^{-iΩt} q_1] = 0 with q_1 = αA e^{i(Ω+ω)t}/(8ω²)
    twice = I * alpha / (2 * omega) * turned * (I * sigma * Ac + sp.conjugate(first).doit())
    twice = twice.subs(sp.conjugate(turned), 1 / turned)
    known = sp.expand(twice + alpha**2 * A / (8 * omega**2))
    assert same(flow[2][A], sp.expand(I * known / (2 * omega)))


def test_velocity_and_acceleration_excitation() -> None:
    """2εα cos Ωt times x, x' or x'': D1A at Ω = 2ω + σ differs by −iω and −ω², as ā does."""
    for order, factor in ((0, 1), (1, -I * omega), (2, -(omega**2))):
        scaled = oscillator(
            2 * alpha * sp.cos(Omega * t) * d(x, order)
            if order
            else 2 * alpha * sp.cos(Omega * t) * x
        )
        flow = rate(scaled.scale({alpha: 1}), 1, {Omega: 2 * omega})[1]
        assert same(flow[A], I * factor * alpha * Ac * sp.exp(I * sigma * t) / (2 * omega))


# --- what an expansion says of itself -------------------------------------------------------------


def test_particular_solutions() -> None:
    """Duffing: q_0 = Ae + c.c., q_1 = αA³e^{3iωT0}/(8ω²) + c.c., without a fundamental part."""
    case = duffing().expand(order=2)
    fast = sp.exp(I * omega * time_scale(0))
    (q0,), (q1,) = case.particular(0).values(), case.particular(1).values()
    assert same(q0, A * fast + Ac / fast)
    assert same(q1, alpha * (A**3 * fast**3 + Ac**3 / fast**3) / (8 * omega**2))
    for p in (-1, 2, 5):
        with pytest.raises(ExpansionError, match="orders 0 to 1"):
            case.particular(p)


def test_secular_terms_are_the_solvability_condition() -> None:
    """2iω D_pA + secular = 0 at every order, and the secular terms are part of what is known."""
    case = duffing().expand(order=3)
    for p in (1, 2, 3):
        (secular,), (known,) = case.secular_terms(p).values(), case.known_terms(p).values()
        assert same(2 * I * omega * case.solvability[p][A] + secular, sp.Integer(0))
        fundamental = sp.expand(known).coeff(sp.exp(I * omega * time_scale(0)))
        assert same(fundamental, secular)


def test_hard_forcing_at_resonance_is_refused() -> None:
    scaled = oscillator(alpha * x**3 + f * sp.cos(Omega * t)).scale({alpha: 1})
    with pytest.raises(
        ExpansionError, match=r"hard forcing drives x\(t\) at its natural frequency"
    ):
        scaled.expand(order=1, resonance={Omega: omega})
    numeric = oscillator(alpha * x**3 + f * sp.cos(2 * t), sp.Integer(2)).scale({alpha: 1})
    with pytest.raises(ExpansionError, match="hard forcing"):
        numeric.expand(order=1)


def test_epsilon_marks_orders_only() -> None:
    """A result holds no ε: it is written at ε = 1."""
    case = duffing().expand(order=2)
    assert not any(e.has(epsilon) for flow in case.solvability.values() for e in flow.values())
    assert set(case.slow_flow.complex) == {A}
    assert same(case.slow_flow.complex[A], case.solvability[1][A] + case.solvability[2][A])


def test_cases_name_themselves_briefly() -> None:
    case = mathieu().expand(1, {Omega: 2 * mathieu().frequencies[0]})
    assert repr(case) == "Expansion(Omega = 2*omega + sigma; order 1; x)"
    assert repr(case.slow_flow) == f"SlowFlow({case!r})"
    assert "no resonance" in repr(mathieu().expand(2))
