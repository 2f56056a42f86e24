"""Orders in ε and the leading-order system: what is accepted, and what is refused with advice."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from systems import (
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
    p,
    pair,
    same,
    sigma,
    t,
    theta,
    x,
    y,
)

from mmsgen.equations import EquationsOfMotion
from mmsgen.errors import MmsgenError, ScalingError
from mmsgen.parameters import Parameter
from mmsgen.symbols import time_scale

real = sp.Symbol("omega", real=True)

LEADING = [
    (oscillator(alpha * x**3, sp.Integer(0)), {alpha: 1}, r"x\(t\).*no stiffness"),
    (equations([d(x, 2) - omega**2 * x], [x]), {}, r"x\(t\).*does not oscillate.*-omega\*\*2 < 0"),
    (oscillator(mu * d(x)), {}, r"x\(t\).*damped.*scale the damping"),
    (oscillator(alpha), {}, "constant force.*shift the coordinates"),
    (oscillator(alpha * x**3), {}, r"nonlinear, x\(t\)\*\*3"),
    (oscillator(alpha * x * d(x, 2)), {}, "nonlinear.*give the amplitude an order"),
    (oscillator(alpha * sp.cos(Omega * t) * x), {}, "time-dependent coefficient of x"),
    (pair(k * y, -k * x), {}, "x and y are coupled .*not symmetric.*feeds or takes energy"),
    (pair(k * y, sp.Integer(0)), {}, "x and y are coupled .*not symmetric"),
    (pair(k * d(y), k * d(x)), {}, r"x and y are coupled .*not skew \(gyroscopic\)"),
    (pair(k * d(y, 2), 2 * k * d(x)), {}, "x and y are coupled"),
    (equations([p * d(x, 2) + omega**2 * x], [x]), {p: 1}, "no inertia"),
    (oscillator(0), {omega: 1}, "no stiffness"),
    (oscillator(f * sp.cos(Omega * t)), {Omega: 1}, "frequency Omega has an order"),
    (oscillator(f * sp.cos(Omega * t + p)), {p: 1}, "constant phase p contains a small parameter"),
    (oscillator(f * sp.cos(Omega * t + omega)), {}, "constant phase omega contains a frequency"),
    (equations([d(x, 2) + real**2 * x], [x]), {}, "omega must be declared positive"),
    (oscillator(sp.sqrt(Omega) * sp.cos(Omega * t)), {}, "fractional power of the frequency Omega"),
    (oscillator(0, omega_1 - omega_2), {}, "undecided sign"),
    (oscillator(alpha / p * x**3), {p: 1}, r"x\(t\)\*\*3 with the coefficient .* order ε\^\(-1\)"),
    (oscillator(alpha / (p + kappa) * x**3), {p: 1, kappa: 1}, r"order ε\^\(-1\)"),
]


@pytest.mark.parametrize(("eom", "orders", "message"), LEADING, ids=lambda v: str(v)[:30])
def test_leading_order_refusals(eom: EquationsOfMotion, orders: dict, message: str) -> None:
    with pytest.raises(ScalingError, match=message):
        eom.scale(orders)


@pytest.mark.parametrize("stiffness", [k, k / p, k + kappa, 2 * k**2, sp.Integer(2)], ids=str)
def test_stiffness_that_is_no_square_is_named(stiffness: sp.Expr) -> None:
    """By the program, ω_x = √(K0/M0), as if the user had named it."""
    eom = equations([3 * d(x, 2) + 3 * stiffness * x + 3 * alpha * x**3], [x])
    scaled = eom.scale({alpha: 1})
    (name,) = scaled.frequencies
    assert name.name == "omega_x" and name.is_positive
    (own,) = (p for p in scaled.parameters if p.symbol == name)
    assert same(own.definition**2, stiffness)
    ((a, rate),) = scaled.expand(order=1).solvability[1].items()
    assert same(rate, 3 * sp.I * alpha * a**2 * sp.conjugate(a) / (2 * name))
    if stiffness.free_symbols:
        (old, *_) = sorted(stiffness.free_symbols, key=str)
        w_x = sp.Symbol("omega_x", positive=True)
        (value, *_) = sp.solve(stiffness - w_x**2, old)
        named = eom.reparametrise({old: value}, [Parameter(w_x)])
        ((a, rate),) = named.scale({alpha: 1}).expand(order=1).solvability[1].items()
        assert same(rate, 3 * sp.I * alpha * a**2 * sp.conjugate(a) / (2 * w_x))


@pytest.mark.parametrize(
    ("frequency", "shown"),
    [
        (sp.Rational(3, 2) * omega, {"omega": Fraction(3, 2)}),
        (sp.Integer(2), {"1": Fraction(2)}),
        (omega_1 + 2 * omega_2, {"omega_1": Fraction(1), "omega_2": Fraction(2)}),
        (omega + sp.Rational(1, 3), {"omega": Fraction(1), "1": Fraction(1, 3)}),
    ],
    ids=str,
)
def test_frequencies_are_linear_forms(frequency: sp.Expr, shown: dict) -> None:
    assert oscillator(alpha * x**3, frequency).scale({alpha: 1}).natural_frequencies == (shown,)


def test_inertia_is_divided_out() -> None:
    """m q'' + m ω² q + εα q³: D1A = 3iα A²Ā/(2mω)."""
    m = sp.Symbol("m", positive=True)
    scaled = equations([m * d(x, 2) + m * omega**2 * x + alpha * x**3], [x]).scale({alpha: 1})
    case = scaled.expand(order=1)
    ((a, rate),) = case.solvability[1].items()
    assert same(rate, 3 * sp.I * alpha * a**2 * sp.conjugate(a) / (2 * m * omega))


def test_roots_of_small_parameters() -> None:
    """√α of order 1 when α is of order 2; an odd order of α leaves no whole order for it."""
    eom = oscillator(sp.sqrt(alpha) * x**3)
    by_root = eom.scale({alpha: 2}).expand(order=2).solvability
    plain = duffing().expand(order=2).solvability
    for q in (1, 2):
        for a, rate in by_root[q].items():
            assert same(rate, plain[q][a].subs(alpha, sp.sqrt(alpha)))
    with pytest.raises(ScalingError, match=r"alpha\*\*\(1/2\).*multiple of 2"):
        eom.scale({alpha: 1})


def test_amplitude_and_parameter_scale_the_same_thing() -> None:
    """α q³ with εα, or with an amplitude of ε^{1/2}: one slow flow."""
    eom = oscillator(alpha * x**3)
    half = eom.scale({}, amplitude=sp.Rational(1, 2)).expand(order=3).solvability
    whole = eom.scale({alpha: 1}).expand(order=3).solvability
    assert half == whole
    with pytest.raises(ScalingError, match="fractional order"):
        oscillator(alpha * x**2).scale({}, amplitude=sp.Rational(1, 2)).expand(order=1)


ORDERS = [
    ({kappa: 1}, "kappa is not a parameter"),
    ({"kappa": 1}, "kappa is not a parameter"),
    ({x: 1}, "amplitudes are scaled by amplitude"),
    ({alpha: 1, "alpha": 1}, "alpha is scaled twice"),
    *(
        ({alpha: v}, "order of alpha must be a whole number")
        for v in (
            -1,
            0.5,
            1.0,
            True,
            None,
            "1",
            "one",
            float("nan"),
            float("inf"),
            k,
            [1],
            sp.Rational(1, 2),
        )
    ),
    ([alpha], "as a mapping"),
    (None, "as a mapping"),
    (alpha, "as a mapping"),
]


@pytest.mark.parametrize(("orders", "message"), ORDERS, ids=str)
def test_orders_that_are_none(orders: object, message: str) -> None:
    with pytest.raises(ScalingError, match=message):
        oscillator(alpha * x**3).scale(orders)


@pytest.mark.parametrize("order", [1, np.int64(1), sp.Integer(1)])
def test_whole_numbers_of_any_type(order: object) -> None:
    scaled = oscillator(alpha * x**3).scale({alpha: order})
    assert scaled.orders == ((alpha, 1),)
    assert scaled.expand(order=order).order == 1


@pytest.mark.parametrize(
    "amplitude", [-1, 0.5, None, "1", "__import__('os')", float("nan"), k, [1], {"x": 1}, {}, sp.oo]
)
def test_amplitudes_that_have_no_order(amplitude: object) -> None:
    with pytest.raises(ScalingError, match="amplitude"):
        oscillator(alpha * x**3).scale({alpha: 1}, amplitude=amplitude)


@pytest.mark.parametrize("order", [0, -1, 1.0, 1.5, None, "1", True, k, float("nan")])
def test_orders_of_an_expansion(order: object) -> None:
    with pytest.raises(ScalingError, match="order of an expansion must be a whole number >= 1"):
        mathieu().expand(order=order)
    with pytest.raises(ScalingError, match="order of an expansion must be a whole number >= 1"):
        mathieu().resonances(order=order)


@pytest.mark.parametrize("name", ["A_x", "a_x", "gamma_x", "u_x", "v_x"])
def test_parameters_are_not_taken_for_amplitudes(name: str) -> None:
    """The modulus of x is called a_x: a parameter of that name would be the same symbol."""
    clash = sp.Symbol(name, nonnegative=True)
    with pytest.raises(ScalingError, match=f"parameter {name} has the name of an amplitude"):
        oscillator(alpha * clash * x**3).scale({alpha: 1})


@pytest.mark.parametrize("name", ["ε", "epsilon", "E", "pi", "zeta", "g0", "λ", "sqrt", "I", "T_0"])
def test_names_that_the_engine_uses_itself(name: str) -> None:
    """A parameter may have any name: the flow is Duffing's, with that name in it."""
    (symbol,) = sp.symbols([name], positive=True)
    scaled = oscillator(symbol * sp.pi * x**3).scale({symbol: 1})
    for q in (1, 2):
        ((a, rate),) = scaled.expand(order=2).solvability[q].items()
        reference = duffing().expand(order=2).solvability[q][a]
        assert same(rate, reference.subs(alpha, sp.pi * symbol))


def test_a_parameter_named_sigma_is_refused_where_a_detuning_is() -> None:
    scaled = oscillator(2 * sigma * sp.cos(Omega * t) * x).scale({sigma: 1})
    scaled.expand(order=1)
    with pytest.raises(MmsgenError, match="sigma has the name of a detuning"):
        scaled.expand(order=1, resonance={Omega: 2 * omega})


def test_hard_and_soft_forcing() -> None:
    """f cos Ωt at order 0 shifts q_0; at order 1 it is a small response. Both drop out of D1A."""
    eom = oscillator(alpha * x**3 + f * sp.cos(Omega * t + theta))
    hard = eom.scale({alpha: 1}).expand(order=1)
    soft = eom.scale({alpha: 1, f: 1}).expand(order=2)
    (rate,) = hard.solvability[1].values()
    Lambda = f / (2 * (omega**2 - Omega**2))
    ((a, _),) = hard.solvability[1].items()
    shift = 3 * sp.I * alpha * a * (a * sp.conjugate(a) + 2 * Lambda**2) / (2 * omega)
    assert same(rate, shift)
    assert same(soft.solvability[1][a], 3 * sp.I * alpha * a**2 * sp.conjugate(a) / (2 * omega))
    (motion,) = hard.particular(0).values()
    (known,) = hard.known_terms(1).values()
    fast = sp.exp(sp.I * Omega * time_scale(0))
    assert same(sp.expand(motion).coeff(fast), -Lambda * sp.exp(sp.I * theta))
    assert same(sp.expand(known).coeff(fast**3), -alpha * Lambda**3 * sp.exp(3 * sp.I * theta))


def test_beta_is_not_needed() -> None:
    """Parameters that are not scaled stay of order 0."""
    scaled = oscillator(alpha * x**3 + alpha * beta * x**5).scale({alpha: 1})
    assert scaled.generator_orders == {"alpha": 1}
