"""Motions of exact equations and of slow flows: exponents of their distance, and refusals."""

from __future__ import annotations

from functools import cache, wraps
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import sympy as sp
from systems import Omega, alpha, beta, d, equations, f, mu, omega, oscillator, t, x, y

import mmsgen as mg
from mmsgen.expansion import Expansion
from mmsgen.loading import load
from mmsgen.motion import exact_motion, first_order_system

COSINE = f * sp.cos(Omega * t)
NUMBERS = {"omega": 1.3, "alpha": 0.7, "mu": 0.11, "f": 1.9, "sigma": 0.53}
START, SPAN = [0.6 + 0.3j], 1.5


@cache
def duffing_case(order: int) -> Expansion:
    """Cubic and driven hard, far below the natural frequency."""
    eom = oscillator(alpha * x**3 + 2 * mu * d(x) - COSINE)
    return eom.scale({alpha: 1, mu: 1}).expand(order, {3 * Omega: omega})


@cache
def quadratic_case(order: int) -> Expansion:
    """Quadratic and driven hard at twice the natural frequency: linear slow flow at order 1."""
    eom = oscillator(alpha * x**2 + 2 * mu * d(x) - COSINE)
    return eom.scale({alpha: 1, mu: 1}).expand(order, {Omega: 2 * omega})


def certificate(case: Expansion, **options: Any) -> mg.Certificate:
    return mg.certify(case, NUMBERS, amplitudes=START, span=SPAN, **options)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("case", [duffing_case, quadratic_case])
def test_motions_part_with_the_power_of_the_order(case: Any, order: int) -> None:
    (fit,) = certificate(case(order)).fits
    assert fit.quantity.startswith("motions")
    assert fit.theory == order
    # generic values; the third term of the error shifts the exponent by less than this
    assert fit.exponent == pytest.approx(order, abs=0.1)


@pytest.mark.parametrize("order", [1, 2])
def test_a_thousandth_too_much_of_one_term_shows(order: int) -> None:
    case = duffing_case(order)
    good = load(case)

    @wraps(good.slow_flow)
    def slow_flow(b: Any, *, alpha: float, **others: float) -> Any:
        return good.slow_flow(b, alpha=1.001 * alpha, **others)

    wrong = certificate(case, functions=SimpleNamespace(slow_flow=slow_flow))
    assert wrong.passed is (order == 1)  # there the error that is left is far larger than this


def test_a_forced_system_with_a_linear_slow_flow_needs_motions() -> None:
    """Floquet theory of the linear part knows nothing of the modulation by the response."""
    case = quadratic_case(1)
    assert case.slow_flow.is_linear
    with pytest.raises(mg.CertificateError, match="or a forced system, is certified by motions"):
        mg.certify(case, NUMBERS)


def test_what_is_not_fitted_must_agree_in_a_forced_system_too() -> None:
    case = quadratic_case(1)
    good = load(case)
    wrong = {n: getattr(good, n) for n in ("slow_flow", "slow_flow_matrix", "boundaries")}
    wrong["growth_rate"] = wraps(good.growth_rate)(lambda **v: good.growth_rate(**v) + 1.0)
    with pytest.raises(mg.CertificateError, match="growth_rate is off"):
        certificate(case, functions=SimpleNamespace(**wrong))


def test_accelerations_by_hand() -> None:
    """A mass that moves with the state, and one that does not, against the solved equations."""
    left = [d(x, 2) * (1 + x**2) + alpha * d(y, 2) + d(x) ** 2, d(y, 2) + beta * x - sp.cos(t)]
    values = {"alpha": 0.3, "beta": 0.7}
    state = np.array([0.5, -0.2, 1.1, 0.4])
    second = np.cos(0.9) - 0.7 * 0.5
    first = (-(1.1**2) - 0.3 * second) / (1 + 0.5**2)
    moving = first_order_system(equations(left, [x, y]), values)
    # rounding of a dozen operations
    np.testing.assert_allclose(moving(0.9, state), [1.1, 0.4, first, second], rtol=1e-14)
    left[0] = 2 * d(x, 2) + alpha * d(y, 2) + d(x) ** 2
    constant = first_order_system(equations(left, [x, y]), values)
    first = (-(1.1**2) - 0.3 * second) / 2
    np.testing.assert_allclose(constant(0.9, state), [1.1, 0.4, first, second], rtol=1e-14)


def test_motions_that_run_away_are_refused() -> None:
    derivative = first_order_system(oscillator(-alpha * x**3), {"omega": 1.0, "alpha": 1.0})
    with pytest.raises(mg.CertificateError, match="cannot be integrated"):
        exact_motion(derivative, np.array([2.0, 1.0]), np.linspace(0, 50, 5), 1.0)


def test_accelerations_that_enter_as_squares_are_refused() -> None:
    with pytest.raises(mg.CertificateError, match="accelerations enter nonlinearly"):
        first_order_system(oscillator(alpha * d(x, 2) ** 2), {"omega": 1.0, "alpha": 1.0})


def test_accelerations_that_do_not_follow_are_refused() -> None:
    """Both equations hold the same combination of accelerations."""
    left = [(1 + x**2) * (d(x, 2) + d(y, 2)) + alpha * x, d(x, 2) + d(y, 2) + beta * y]
    derivative = first_order_system(equations(left, [x, y]), {"alpha": 0.3, "beta": 0.7})
    with pytest.raises(mg.CertificateError, match="do not follow from the equations"):
        derivative(0.0, np.array([0.5, -0.2, 1.1, 0.4]))
