"""Non-smooth forces: their average in closed form beside quadrature, formulas and the motion."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from systems import (
    A,
    Bc,
    Omega,
    alpha,
    beta,
    d,
    equations,
    kappa,
    mu,
    omega,
    omega_1,
    omega_2,
    oscillator,
    pair,
    sigma,
    t,
    x,
    y,
)

import mmsgen as mg
from mmsgen.errors import ExpansionError, MmsgenError, ResonanceError, ScalingError
from mmsgen.hierarchy import hierarchy
from mmsgen.nonsmooth import harmonic
from mmsgen.runtime._flow import rates
from mmsgen.scaling import ScaledSystem
from mmsgen.slowflow import SlowFlow
from mmsgen.symbols import modulus, phase

v, w = d(x), d(y)
a, gamma = modulus(x), phase(x)
DRAG = v * sp.Abs(v)


@given(st.integers(0, 12), st.integers(-15, 15))
def test_harmonics_of_a_power_with_a_sign(power: int, m: int) -> None:
    """By quadrature, over the two halves of the turn on which the integrand is smooth.

    Its size is 2^p, and 30 digits are asked of the quadrature.
    """
    with mpmath.workdps(30):

        def integrand(psi: mpmath.mpf) -> mpmath.mpf:
            c = mpmath.cos(psi)
            return (2 * c) ** power * mpmath.sign(c) * mpmath.cos(m * psi)

        quarter = mpmath.pi / 2
        whole = mpmath.quad(integrand, [-quarter, 0, quarter, 2 * quarter, 3 * quarter]) / 2
        value = harmonic(power, m)
        assert abs(whole - mpmath.mpf(value.numerator) / value.denominator) < 1e-25 * 2**power


def test_parity_of_harmonics() -> None:
    assert harmonic(2, 1) == Fraction(16, 3)  # the 8/(3π) of quadratic damping, a = 2|A|
    assert harmonic(0, 1) == 2 and harmonic(2, 0) == harmonic(1, 1) == 0


# -- formulas ------------------------------------------------------------------------------------


def first_order(force: sp.Expr) -> SlowFlow:
    """Of x'' + ω²x + force = 0."""
    small = dict.fromkeys(force.free_symbols - {t, Omega}, 1)
    return oscillator(force).scale(small).expand(1).slow_flow


@pytest.mark.parametrize(
    ("force", "rate", "turn"),
    [
        # Nayfeh and Mook (1979), sections 3.3.2 and 3.3.3: quadratic damping, Coulomb's friction
        (beta * DRAG, -4 * beta * omega * a**2 / (3 * sp.pi), 0),
        (beta * sp.sign(v), -2 * beta / (sp.pi * omega), 0),
        # a spring of the force |x|x, and damping by |x|x'
        (beta * x * sp.Abs(x), 0, 4 * beta * a / (3 * sp.pi * omega)),
        (beta * v * sp.Abs(x), -2 * beta * a**2 / (3 * sp.pi), 0),
        # |v|³v and, smooth although written with a modulus, v|v|²
        (beta * v * sp.Abs(v) ** 3, -16 * beta * omega**3 * a**4 / (15 * sp.pi), 0),
        (beta * v * sp.Abs(v) ** 2, -3 * beta * omega**2 * a**3 / 8, 0),
        (beta * x * sp.sign(x) ** 2, 0, beta / (2 * omega)),
    ],
)
def test_one_coordinate(force: sp.Expr, rate: sp.Expr, turn: sp.Expr) -> None:
    flow = first_order(force).polar
    assert sp.expand(flow[a] - rate) == 0 and sp.expand(flow[gamma] - turn) == 0


def test_forms_of_one_flow_agree() -> None:
    """Complex, Cartesian and the table of terms, at numbers: a few roundings of 1e-16."""
    flow = first_order(beta * DRAG + alpha * x**3 - mu * v)
    values = {"omega": 1.3, "alpha": 0.7, "beta": 0.4, "mu": 0.3}
    b = 0.4 - 0.7j
    numbers = {s: values[str(s)] for s in (omega, alpha, beta, mu)}
    from_complex = complex(flow.complex[A].subs({**numbers, A: b}))
    numbers |= dict(zip(flow.cartesian, (2 * b.real, 2 * b.imag), strict=True))
    real, imaginary = (complex(e.subs(numbers)) for e in flow.cartesian.values())
    from_table = rates(flow.table.flow, flow.table.numbers(values), np.array([b]))[0]
    assert (real + 1j * imaginary) / 2 == pytest.approx(from_complex, abs=1e-14)
    assert from_table == pytest.approx(from_complex, abs=1e-14)
    assert not flow.is_linear and flow.table.flow.terms == (
        (0, (1, 0, 0)),
        (0, (1, 0, 1)),
        (0, (2, 1, 0)),
    )


def average(
    force: sp.Expr, j: int, frequencies: dict[sp.Symbol, sp.Rational], b: list[complex]
) -> complex:
    """D_1 A_j of q_j'' + ω_j²q_j + force = 0, as the mean of i F e^{−iω_j t}/(2ω_j), by quadrature.

    All frequencies are whole, so that 2π is a period; the mean is taken between the kinks.
    """
    f1, f2 = (frequencies[s] for s in (omega_1, omega_2))
    motions = {}
    for q, amplitude, f in zip((x, y), b, (f1, f2), strict=True):
        z = sp.Float(amplitude.real, 30) + sp.I * sp.Float(amplitude.imag, 30)
        size, angle = sp.Abs(z).evalf(30), sp.arg(z).evalf(30)
        motions[d(q)] = -2 * f * size * sp.sin(f * t + angle)
        motions[q] = 2 * size * sp.cos(f * t + angle)
    there = force.xreplace(motions).subs(frequencies)
    function = sp.lambdify(t, there, "mpmath")
    own = int((f1, f2)[j])
    kinks = {mpmath.mpf(0), 2 * mpmath.pi}
    for f, amplitude in zip((f1, f2), b, strict=True):
        for k in range(4 * int(f)):  # zeros of the coordinate and of its velocity
            root = (k * mpmath.pi / 2 - mpmath.arg(mpmath.mpmathify(amplitude))) / int(f)
            kinks.add(root - 2 * mpmath.pi * mpmath.floor(root / (2 * mpmath.pi)))
    turn = mpmath.quad(lambda s: function(s) * mpmath.expj(-own * s), sorted(kinks))
    return complex(1j * turn / (2 * mpmath.pi) / (2 * own))


CROSSED = [
    # 1:1 and 1:3 by another coordinate's overtones, products with phasors, mixed factors
    (beta * w * sp.Abs(w), {omega_2: omega_1}, {omega_1: 2, omega_2: 2}),
    (beta * y * sp.Abs(y), {omega_1: 3 * omega_2}, {omega_1: 3, omega_2: 1}),
    (beta * x * sp.Abs(w), {omega_1: 2 * omega_2}, {omega_1: 2, omega_2: 1}),
    (beta * v * y * sp.sign(w), {omega_1: 3 * omega_2}, {omega_1: 3, omega_2: 1}),
    (beta * DRAG * sp.cos(Omega * t + 1), {Omega: 2 * omega_1}, {omega_1: 1, omega_2: 3, Omega: 2}),
    (
        beta * sp.Abs(x) * sp.cos(Omega * t),
        {Omega: 3 * omega_1},
        {omega_1: 2, omega_2: 1, Omega: 6},
    ),
    (
        beta * y * sp.sign(v) * sp.cos(Omega * t),
        {Omega: omega_2},
        {omega_1: 2, omega_2: 3, Omega: 3},
    ),
]


@pytest.mark.parametrize(("force", "relation", "numbers"), CROSSED, ids=lambda v: str(v)[:30])
def test_averages_by_quadrature(force: sp.Expr, relation: dict, numbers: dict) -> None:
    """Exact resonance, random amplitudes; 15 digits are asked of the quadrature, 1e-11 are left."""
    flow = pair(force, 0 * y).scale({beta: 1}).expand(1, relation).slow_flow
    values = {**{s: sp.Integer(n) for s, n in numbers.items()}, beta: sp.Integer(1)}
    b = [0.31 - 0.47j, -0.53 + 0.22j]
    exact = average(force, 0, values, b)
    at_rest, in_y = (e.subs(sigma, 0) for e in flow.complex.values())
    found = at_rest.subs({**values, A: b[0], sp.conjugate(Bc): b[1], beta: 1})
    assert complex(found.evalf()) == pytest.approx(exact, abs=1e-11)
    assert abs(exact) > 1e-3
    assert in_y == 0


def test_moduli_have_one_form() -> None:
    """x²|x|x̄… : products of a and ā beside |a| are powers of |a|, so that equal terms cancel."""
    left = beta * (x**2 * sp.Abs(x) * v - x * v * sp.Abs(x) * x)
    assert first_order(left + mu * v).complex[A] == -mu * A / 2
    rate = first_order(beta * x**2 * sp.Abs(x) * v).complex[A]
    assert rate.atoms(sp.conjugate) == set() and sp.degree(rate.subs(sp.Abs(A), a), a) == 3


# -- what else is made of it ---------------------------------------------------------------------


def test_order_of_appearance() -> None:
    """A weaker force takes part at its own order, as the last one, and resonates there alike."""
    later = oscillator(beta * DRAG + alpha * x**3).scale({alpha: 1, beta: 2}).expand(2)
    assert later.solvability[2][A].coeff(beta) == first_order(beta * DRAG).complex[A].coeff(beta)
    by_size = oscillator(beta * DRAG + alpha * x**3).scale({beta: 1}, amplitude=1).expand(2)
    assert by_size.solvability[1][A] == 0
    assert by_size.slow_flow.complex[A].coeff(beta) == later.solvability[2][A].coeff(beta)


def test_dissipation_function() -> None:
    model = mg.Model(
        v**2 / 2 - omega**2 * x**2 / 2,
        [x],
        [mg.Parameter(omega), mg.Parameter(beta)],
        dissipation=beta * sp.Abs(v) ** 3 / 3,
    )
    assert model.equations_of_motion().equations == (d(x, 2) + omega**2 * x + beta * DRAG,)


def test_hierarchy_shows_moduli() -> None:
    ((_, terms),) = hierarchy(alone(beta * DRAG), 1).values()
    assert terms[1] == r"- \beta \left(D_{0} x_{0}\right) \left|D_{0} x_{0}\right|"
    ((_, terms),) = hierarchy(oscillator(beta * sp.sign(x)).scale({beta: 1}), 1).values()
    assert terms[1] == r"- \beta \operatorname{sgn}\left(x_{0}\right)"


def test_resonances_of_a_damper_of_one_coordinate() -> None:
    drag = pair(beta * DRAG + kappa * sp.cos(Omega * t), alpha * w * sp.Abs(w))
    (found,) = drag.scale({beta: 1, alpha: 1, kappa: 1}).resonances(1)
    assert found.mapping == {Omega: omega_1}


def alone(force: sp.Expr) -> ScaledSystem:
    return oscillator(force).scale({beta: 1})


def two(force: sp.Expr) -> ScaledSystem:
    return pair(force, 0 * y).scale({beta: 1})


def coupled() -> ScaledSystem:
    left = [
        d(x, 2) + omega_1**2 * x + kappa * y + beta * DRAG,
        d(y, 2) + omega_2**2 * y + kappa * x,
    ]
    return equations(left, [x, y]).scale({beta: 1})


@pytest.mark.parametrize(
    ("make", "error", "words"),
    [
        (lambda: alone(beta * DRAG).expand(2), ExpansionError, "infinitely many harmonics"),
        (lambda: oscillator(beta * DRAG).scale({}).expand(1), ScalingError, "is nonlinear"),
        (lambda: oscillator(beta * sp.sign(v)).scale({}).expand(1), ScalingError, "is nonlinear"),
        (
            lambda: alone(beta * DRAG - kappa * sp.cos(Omega * t)).expand(1),
            ExpansionError,
            "as it is forced",
        ),
        (lambda: coupled().expand(1), ExpansionError, "as it is coupled to others"),
        (lambda: two(beta * v * sp.Abs(v * w)).expand(1), ScalingError, "is not smooth"),
        (lambda: two(beta * sp.Abs(v) * sp.Abs(w)).expand(1), ExpansionError, "and in y at once"),
        (lambda: two(beta * sp.Abs(w)).resonances(1), ResonanceError, "infinitely many harmonics"),
        (lambda: alone(beta * DRAG).expand(1).residual(), ExpansionError, "infinite sum"),
        (lambda: alone(beta * DRAG).expand(1).known_terms(1), ExpansionError, "infinite sum"),
        (
            lambda: alone(beta * sp.Abs(v) ** sp.Rational(1, 2)).expand(1),
            ScalingError,
            "not analytic",
        ),
    ],
)
def test_refusals(make: Callable[[], Any], error: type[MmsgenError], words: str) -> None:
    with pytest.raises(error, match=words):
        make()


def test_limit_cycle_of_negative_damping_with_drag() -> None:
    """μ a/2 = 4βω a²/(3π): what drives and what brakes are equal at a = 3πμ/(8βω)."""
    flow = first_order(beta * DRAG - mu * v)
    values = {"omega": 1.7, "beta": 0.4, "mu": 0.3}
    rest, cycle = flow.equilibria(values).modulus[:, 0]
    # A root of a quadratic with coefficients of size 1, polished: a few roundings of 1e-16.
    assert rest == 0 and cycle == pytest.approx(3 * np.pi * 0.3 / (8 * 0.4 * 1.7), rel=1e-14)
    assert list(flow.equilibria(values).stable) == [False, True]


def test_drag_under_a_force() -> None:
    """(σ a)² + (4βω a²/3π)² = (κ/2ω)², at any detuning."""
    left = beta * DRAG - kappa * sp.cos(Omega * t)
    scaled = oscillator(left).scale({beta: 1, kappa: 1})
    flow = scaled.expand(1, {Omega: omega}).slow_flow
    relation = (sigma * a) ** 2 + (4 * beta * omega * a**2 / (3 * sp.pi)) ** 2
    relation -= (kappa / (2 * omega)) ** 2
    ratio = sp.cancel(flow.response_relation() / relation)
    assert ratio != 0 and not ratio.has(a, sigma, kappa)


def test_certificate_of_a_damped_oscillator() -> None:
    """Emitted functions and the motion of the unexpanded equation: off by ε at times of 1/ε."""
    left = beta * DRAG + alpha * x**3 - mu * v
    case = oscillator(left).scale({alpha: 1, beta: 1, mu: 1}).expand(1)
    values = {"omega": 1.3, "alpha": 0.7, "beta": 0.6, "mu": 0.5}
    certificate = mg.certify(case, values, amplitudes=[0.3 + 0.2j], span=2.0)
    assert certificate.passed
