"""Forces in the equations of small coordinates: their order counts from the coordinate's."""

from __future__ import annotations

import pytest
import sympy as sp
from systems import A, Omega, alpha, d, f, mu, omega, oscillator, pair, same, sigma, t, x, y


@pytest.mark.parametrize("order", [2, 3])
def test_small_coordinate_with_a_smaller_force(order: int) -> None:
    """x = εx̃ turns α, ε²μ, ε³f into ε²α, ε²μ, ε²f: one problem, one slow flow."""
    eom = oscillator(2 * mu * d(x) + alpha * x**3 - f * sp.cos(Omega * t))
    small = eom.scale({mu: 2, f: 3}, amplitude=1).expand(order, {Omega: omega})
    plain = eom.scale({alpha: 2, mu: 2, f: 2}).expand(order, {Omega: omega})
    for p in range(1, order + 1):
        assert same(small.solvability[p][A], plain.solvability[p][A])
    drive = -sp.I * f * sp.exp(sp.I * sigma * t) / (4 * omega)
    assert same(small.solvability[2][A].subs({alpha: 0, mu: 0}), drive)


def test_denominators_are_expanded_as_far_as_the_force_needs() -> None:
    """A force ε³f/(1 + εμ) of order 2 has a part −ε⁴μf of order 3."""
    eom = oscillator(-f / (1 + mu) * sp.cos(Omega * t))
    small = eom.scale({mu: 1, f: 3}, amplitude=1).expand(3, {Omega: omega})
    third = sp.expand(small.solvability[3][A]).coeff(mu)
    assert same(third, sp.I * f * sp.exp(sp.I * sigma * t) / (4 * omega))


def test_force_on_one_of_two_small_coordinates() -> None:
    omega_1, omega_2 = sp.symbols("omega_1 omega_2", positive=True)
    eom = pair(alpha * x * y, alpha * x**2 - f * sp.cos(Omega * t))
    case = eom.scale({f: 2}, amplitude=1).expand(1, {omega_2: 2 * omega_1, Omega: 2 * omega_1})
    rate = case.solvability[1][case.amplitudes[1]]
    assert rate.coeff(f) != 0
