"""Mathieu's equation: what is emitted against eigenvalues, and against power series in print."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp
from entries import certificates, demand_notebook, emitted
from scipy.special import mathieu_a, mathieu_b
from systems import Omega, d, equations, mu, omega, oscillator, t, x

q = sp.Symbol("q", positive=True)
MODULES = {1: "omega_is_Omega_over_2", 2: "omega_is_Omega", 3: "omega_is_three_Omega_over_2"}


@pytest.mark.pinned
def test_the_notebook_of_mathieus_equation() -> None:
    demand_notebook("mathieu")


def test_certificates_of_mathieus_equation() -> None:
    found = certificates("mathieu")
    tongues = {(n, order) for n in MODULES for order in (1, 2, 4) if order >= n} - {(3, 4)}
    names = {f"{MODULES[n]}_order_{order}" for n, order in tongues | {(3, 3), (3, 4)}}
    assert set(found) == names | {"nonresonant_order_4"}
    for name, data in found.items():
        even = name.startswith(("omega_is_Omega_order", "nonresonant"))
        for fit in data["fits"]:
            assert fit["theory"] == data["order"] + 1
            # one more where the next term vanishes; narrow zones are fitted from four points
            more = even and (fit["quantity"] == "edges of the zone" or "none" in data["relation"])
            # and at order 4 of the second they are where the term after that still counts
            above = 0.6 if even and data["order"] == 4 else 0.2
            assert -0.2 < float(fit["fitted"]) - fit["theory"] - more < above


@pytest.mark.parametrize(
    ("n", "order", "power"),
    [(1, 1, 2), (1, 2, 3), (1, 4, 5), (2, 2, 4), (2, 4, 6), (3, 3, 4), (3, 4, 5)],
)
@pytest.mark.parametrize("eigenvalue", [mathieu_a, mathieu_b])
def test_edges_against_eigenvalues(
    n: int, order: int, power: int, eigenvalue: Callable[..., Any]
) -> None:
    """Without damping, at Ω = 2, (n + σ)² is the eigenvalue but for O(q^power)."""
    depths = np.array([0.2, 0.1])
    edges = emitted("mathieu", f"{MODULES[n]}_order_{order}").boundaries(
        Omega=2.0, q=depths, mu=0.0
    )
    gap = (n + edges[eigenvalue is mathieu_a]) ** 2 - eigenvalue(n, depths)
    # the next but one term is at most q times the next, which makes 0.14 of a power here
    assert np.log2(gap[0] / gap[1]) == pytest.approx(power, abs=0.15)


@pytest.mark.parametrize("rate", [0.1, 0.3])
def test_first_tongue_with_damping(rate: float) -> None:
    """δ = 1 ± ε√(1 − 4k²) − ε²/8, μ = εk, q = ε; Nayfeh and Mook (1979), chapter 5."""
    module = emitted("mathieu", "omega_is_Omega_over_2_order_2")
    gaps = []
    for depth in (0.02, 0.01):
        edges = module.boundaries(Omega=2.0, q=depth, mu=depth * rate)
        printed = [1 + sign * depth * np.sqrt(1 - 4 * rate**2) - depth**2 / 8 for sign in (-1, 1)]
        gaps.append((1 + np.array(edges)) ** 2 - printed)
    # equal but for terms of order 3, of which the next is smaller by ε
    np.testing.assert_allclose(np.log2(gaps[0] / gaps[1]), 3, atol=0.05)


def test_second_tongue_opens_at_its_threshold() -> None:
    module = emitted("mathieu", "omega_is_Omega_order_2")
    below, above = (module.boundaries(Omega=2.0, q=0.4, mu=m) for m in (0.0101, 0.0099))
    # q²/(2Ω³) = 0.01
    assert np.all(np.isnan(below))
    assert above[0] < above[1]


def test_the_curve_around_zero_at_order_six() -> None:
    """DLMF 28.6.14 and 28.6.1, one order further than the notebook goes."""
    left = d(x, 2) + (omega**2 - 2 * q * sp.cos(2 * t)) * x
    case = equations([left], [x]).scale({q: 1}).expand(6)
    (a,) = case.amplitudes
    rate = sum(case.solvability[p][a] for p in (2, 4, 6))
    nu = omega + sp.expand(rate / (sp.I * a))
    z = sp.Symbol("z")
    series = z + q**2 / (2 * (z - 1)) + (5 * z + 7) * q**4 / (32 * (z - 1) ** 3 * (z - 4))
    series += (9 * z**2 + 58 * z + 29) * q**6 / (64 * (z - 1) ** 5 * (z - 4) * (z - 9))
    square = sp.expand(nu**2)
    for value in (sp.Rational(1, 3), sp.Rational(7, 5)):
        there = sum(square.coeff(q, k).subs(omega, value) * q**k for k in (0, 2, 4, 6))
        composed = sp.series(series.subs(z, there), q, 0, 8).removeO()
        assert sp.expand(composed) == value**2
    assert series.subs(z, 0).coeff(q, 6) == -sp.Rational(29, 2304)
    assert Omega not in case.weak.scaled.frequencies


def test_reason_of_a_zone_that_opens_beyond_the_leading_order() -> None:
    """Γ² + σ²/4 has no positive discriminant: the coupling is of order 2."""
    plain = oscillator(2 * q * sp.cos(Omega * t) * x).scale({q: 1})
    first = plain.expand(2, {Omega: 2 * omega}).slow_flow.stability
    second = plain.expand(2, {Omega: omega}).slow_flow.stability
    word = "is positive in an interval of the detuning"
    assert first.reason.startswith("the discriminant of Gamma**2 + ")
    assert second.reason == f"the discriminant of a factor of degree 2 in Gamma {word}"
    lossy = oscillator(2 * mu * d(x) + 2 * q * sp.cos(Omega * t) * x).scale({q: 1, mu: 2})
    damped = lossy.expand(2, {Omega: omega}).slow_flow.stability
    assert damped.reason.startswith("a factor of degree 2 in Gamma is damped, and unstable near ")
