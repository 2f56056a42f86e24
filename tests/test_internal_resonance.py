"""Two coordinates in internal resonance: emitted functions against printed formulas."""

from __future__ import annotations

import math
from cmath import exp

import numpy as np
import pytest
from entries import HOPF, certificates, demand_fits, demand_notebook, emitted

ROUNDING = 1e-14
"""A dozen operations on numbers of order one."""

QUADRATIC, INTERNAL = "internal_resonance_1_2", "omega_2_is_two_omega_1"
CUBIC, SPHERICAL = "internal_resonance_1_3", "internal_resonance_1_1"


@pytest.mark.pinned
@pytest.mark.parametrize("name", [SPHERICAL, QUADRATIC, CUBIC])
def test_the_notebooks_of_internal_resonance(name: str) -> None:
    demand_notebook(name)


@pytest.mark.parametrize(("name", "cases"), [(SPHERICAL, 3), (QUADRATIC, 6), (CUBIC, 5)])
def test_certificates_of_internal_resonance(name: str, cases: int) -> None:
    found = certificates(name)
    assert len(found) == cases
    even = name == SPHERICAL  # x → −x, y → −y
    points = {
        (SPHERICAL, "omega_x"): ["pitchfork"],
        (QUADRATIC, "omega_1"): ["saddle-node", *HOPF],
        (QUADRATIC, "omega_2"): ["saddle-node", "pitchfork"],
        (CUBIC, "omega_1"): ["saddle-node"],
        (CUBIC, "omega_2"): ["saddle-node"],
    }
    for module, data in found.items():
        # generic values: no error term vanishes, and the next one is small beside it
        force = module.partition("Omega_is_")[2]
        own = points[name, force.partition("_order")[0]] if force else ()
        demand_fits(data, 0.1, steady=bool(force), even=even, points=own)


def test_saturation() -> None:
    """N&M, chapter 6: a_2 without a force in it, and a_1 from the quadratic equation."""
    w1, m1, m2, c1, c2, s1, s2, force = 0.9, 0.03, 0.02, 0.4, 0.7, 0.05, -0.02, 0.4
    a2 = 2 * w1 / c1 * math.hypot(2 * m1, s1 + s2)
    factor = 2 * w1 * 2 * w1 / (c1 * c2)
    g1 = factor * (2 * m1 * m2 - s2 * (s1 + s2))
    g2 = factor * (2 * m1 * s2 + m2 * (s1 + s2))
    a1 = 2 * math.sqrt(-g1 + math.sqrt((force / (2 * c2)) ** 2 - g2**2))
    # phases from the two conditions of the first equation, then of the second
    difference = math.atan2(-m1, -(s1 + s2) / 2)
    sine = (a1**2 * c2 * math.sin(difference) / (8 * w1) - a2 * m2) * 4 * w1 / force
    cosine = (-(a1**2) * c2 * math.cos(difference) / (8 * w1) - a2 * s2) * 4 * w1 / force
    second = math.atan2(sine, cosine)
    first = (difference + second) / 2
    b = np.array([a1 / 2 * exp(1j * first), a2 / 2 * exp(1j * second)])
    case = emitted(QUADRATIC, f"{INTERNAL}_and_Omega_is_omega_2_order_1")
    values = {"omega_1": w1, "mu_1": m1, "mu_2": m2, "alpha_1": c1, "alpha_2": c2}
    values |= {"F_2": force, "sigma_1": s1, "sigma_2": s2}
    assert np.abs(case.slow_flow(b, **values)).max() < ROUNDING
    assert np.abs(case.slow_flow(1.001 * b, **values)).max() > 1e-6


def test_energy_of_the_free_exchange() -> None:
    """a_1² + ν a_2² is constant without damping, ν = α_1 ω_2/(α_2 ω_1), and falls with it."""
    case = emitted(QUADRATIC, f"{INTERNAL}_order_1")
    b = np.array([0.3 - 0.2j, 0.1 + 0.4j])
    values = {"omega_1": 0.9, "alpha_1": 0.4, "alpha_2": 0.7, "sigma": 0.3}
    weights = np.array([1.0, 2 * 0.4 / 0.7])
    free = case.slow_flow(b, mu_1=0.0, mu_2=0.0, **values)
    assert abs(np.sum(weights * (b.conj() * free).real)) < ROUNDING
    damped = case.slow_flow(b, mu_1=0.05, mu_2=0.05, **values)
    loss = -0.05 * np.sum(weights * np.abs(b) ** 2)
    assert np.sum(weights * (b.conj() * damped).real) == pytest.approx(loss, rel=ROUNDING)


def test_printed_modulation_of_three_to_one() -> None:
    """N&M, chapter 6: rates of amplitudes and phases of the driven system, at numbers."""
    w1, m1, m2, s1, s2, f1 = 0.9, 0.03, 0.02, 0.05, -0.02, 0.4
    c = dict(enumerate((0.3, -0.5, 0.7, 1.1, -0.2, 0.6, 0.4, -0.9), start=1))
    a1, a2, g1, g2 = 0.7, 0.4, 0.3, 1.9
    gamma, slow, fast = g2 - 3 * g1, 8 * w1, 24 * w1
    radial_1 = c[2] * a1**2 * a2 * math.sin(gamma) / slow - m1 * a1 - f1 * math.sin(g1) / (2 * w1)
    turning_1 = -(3 * c[1] * a1**3 + 2 * c[3] * a1 * a2**2) / slow
    turning_1 -= c[2] * a1**2 * a2 * math.cos(gamma) / slow + f1 * math.cos(g1) / (2 * w1) + s2 * a1
    radial_2 = -c[5] * a1**3 * math.sin(gamma) / fast - m2 * a2
    turning_2 = -(3 * c[8] * a2**3 + 2 * c[6] * a1**2 * a2 + c[5] * a1**3 * math.cos(gamma)) / fast
    turning_2 += (s1 - 3 * s2) * a2
    wanted = [
        exp(1j * g1) * complex(radial_1, turning_1) / 2,
        exp(1j * g2) * complex(radial_2, turning_2) / 2,
    ]
    case = emitted(CUBIC, "omega_2_is_three_omega_1_and_Omega_is_omega_1_order_1")
    values = {f"alpha_{k}": x for k, x in c.items() if k not in (4, 7)}
    values |= {"omega_1": w1, "mu_1": m1, "mu_2": m2, "F_1": f1, "sigma_1": s1, "sigma_2": s2}
    b = [a1 / 2 * exp(1j * g1), a2 / 2 * exp(1j * g2)]
    np.testing.assert_allclose(case.slow_flow(b, **values), wanted, rtol=ROUNDING)


def test_an_ellipse_turns_as_airy_says() -> None:
    """The rate 3ωab/8L² of the axes, from the rates of the two circular motions in the ellipse."""
    a, b, length, omega = 0.3, 0.1, 1.7, 2.3
    case = emitted(SPHERICAL, "omega_y_is_omega_x_order_2")
    rates = case.slow_flow([a / 2, -0.5j * b], omega_x=omega, L=length, mu=0.0, sigma=0.0)
    # x + iy = R e^{iωt} + conj(Q) e^{-iωt}: the axes turn with half the difference of the phases
    forward, back = a / 2 + b / 2, a / 2 - b / 2
    turns = [(rates[0] + 1j * rates[1]) / forward, (rates[0] - 1j * rates[1]) / back]
    assert np.abs(np.real(turns)).max() < ROUNDING
    wanted = 3 * omega * a * b / (8 * length**2)
    assert (turns[0] - turns[1]).imag / 2 == pytest.approx(wanted, rel=100 * ROUNDING)


@pytest.mark.parametrize(("order", "following"), [(2, 5 / 32), (4, 15 / 128)])
def test_the_conical_pendulum_has_its_exact_frequency(order: int, following: float) -> None:
    """ω(1 − a²/L²)^{-1/4}; what an order leaves is the next term of the series."""
    a, length, omega = 0.1, 1.7, 2.3
    case = emitted(SPHERICAL, f"omega_y_is_omega_x_order_{order}")
    rates = case.slow_flow([a / 2, -0.5j * a], omega_x=omega, L=length, mu=0.0, sigma=0.0)
    small = (a / length) ** 2
    error = omega * (1 - small) ** -0.25 - omega - rates[0].imag / (a / 2)
    # the term after the next one is smaller by a²/L²
    assert error / (omega * following * small ** (order / 2 + 1)) == pytest.approx(1, abs=0.01)


@pytest.mark.parametrize(("number", "stable"), [(0.74, False), (0.78, True)])
def test_a_shaken_pendulum_leaves_the_plane_below_the_bound_of_miles(
    number: float, stable: bool
) -> None:
    """ν = 0.757, on the swing in phase with the force, undamped; L = ω = 1."""
    force = 0.02
    detuning = number / 2 * force ** (2 / 3)
    roots = np.roots([1 / 16, 0, detuning, -force / 2])
    (swing,) = roots[np.abs(roots.imag) < 1e-12].real
    case = emitted(SPHERICAL, "omega_y_is_omega_x_and_Omega_is_omega_x_order_2")
    values = {"omega_x": 1.0, "L": 1.0, "mu": 0.0, "f": force, "sigma_1": 0.0, "sigma_2": detuning}
    assert np.abs(case.slow_flow([-swing / 2, 0], **values)).max() < ROUNDING
    aside = [case.slow_flow([-swing / 2, 1e-7 * turn], **values)[1] / 1e-7 for turn in (1, 1j)]
    determinant = aside[0].real * aside[1].imag - aside[0].imag * aside[1].real
    assert bool(determinant > 0) is stable
