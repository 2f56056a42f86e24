"""Closed branches that lie between the values at which all equilibria are computed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from mmsgen.runtime._branches import response_of
from mmsgen.runtime._flow import Flow

ALONE = Flow(1, ((0, (0, 0, 0)), (0, (1, 0, 0)), (0, (2, 1, 0)), (0, (3, 2, 0))))
DAMPING = np.poly1d([1.0, -1.0, 0.27])  # of ρ = |B|²: small about ρ = 1/2
STIFFNESS = 0.7


def lowest() -> tuple[float, float]:
    """ρ and f² at the least of ρ d(ρ)²: with σ = cρ the least force of a large amplitude."""
    slope = DAMPING + 2 * np.poly1d([1, 0]) * DAMPING.deriv()
    rho = max(slope.roots.real)
    return rho, rho * DAMPING(rho) ** 2


def alone(force: float) -> Callable[[Any], Any]:
    """B' = −(d(|B|²) + iσ)B + ic|B|²B − if, so that ρ(d(ρ)² + (σ − cρ)²) = f²."""

    def coefficients(s):
        one = np.ones(len(s))
        d = DAMPING.coeffs
        own = [-1j * force * one, -d[2] - 1j * s, (-d[1] + 1j * STIFFNESS) * one, -d[0] * one]
        return np.stack(own, axis=-1)

    return coefficients


@pytest.mark.parametrize("count", [30, 4000])
@pytest.mark.parametrize("above", [1e-2, 1e-6])
def test_a_small_isola_over_the_detuning(count: int, above: float) -> None:
    """Its width goes like the root of how far f² is above the least; 1/20 of a step at last."""
    rho, least = lowest()
    response = response_of(
        ALONE, alone((least * (1 + above)) ** 0.5), np.linspace(-0.97, 2.05, count)
    )
    folds = [b for b in response.bifurcations if b.kind == "saddle-node"]
    assert len(folds) == 2
    assert len(response.branches) == 2
    # Least of ½h δρ² + ρ(δσ − cδρ)² over δρ, with h the second derivative of ρd²: that is all of f²
    # above the least. Cubic terms are smaller by δρ/ρ, a tenth of the root of `above`.
    bend = (np.poly1d([1, 0]) * DAMPING**2).deriv(2)(rho) / 2
    half = (least * above * (1 / rho + STIFFNESS**2 / bend)) ** 0.5
    expected = [STIFFNESS * rho - half, STIFFNESS * rho + half]
    assert [b.parameter for b in folds] == pytest.approx(expected, abs=above**0.5 * half)


def test_no_isola_below_the_least_force() -> None:
    _, least = lowest()
    response = response_of(ALONE, alone((least * (1 - 1e-6)) ** 0.5), np.linspace(-1, 2, 500))
    assert response.bifurcations == ()
    assert len(response.branches) == 1


@pytest.mark.parametrize("above", [1e-2, 1e-5, 1e-8])
def test_a_small_isola_over_the_force(above: float) -> None:
    """The subharmonic of order one third of Duffing's oscillator, Λ its forced amplitude.

    μ² + (σ − 3αΛ² − cρ)² = c²Λ²ρ with c = 3α/2, quadratic in ρ: both roots are one where
    (12αc − c²)Λ⁴ − 4cσΛ² + 4μ² = 0, which needs σ > μ√(12αc − c²)/c.
    """
    flow = Flow(1, ((0, (1, 0, 0)), (0, (2, 1, 0)), (0, (0, 2, 0))))
    alpha, mu = 0.3, 0.02
    c = 1.5 * alpha
    top = 12 * alpha * c - c * c
    sigma = mu * top**0.5 / c * (1 + above)

    def coefficients(force):
        one = np.ones(len(force))
        linear = -mu - 1j * (sigma - 3 * alpha * force**2)
        return np.stack([linear, 1j * c * one, 1j * c * force], axis=-1)

    response = response_of(flow, coefficients, np.linspace(0.013, 1.04, 700))
    folds = [b.parameter for b in response.bifurcations if b.kind == "saddle-node"]
    # Of two roots that are close the differences have 1e-16 of the squares.
    expected = np.sort(np.roots([top, -4 * c * sigma, 4 * mu**2]) ** 0.5)
    assert folds == pytest.approx(expected, abs=1e-11)
    assert len(response.branches) == 2


COUPLED = Flow(
    2,
    (
        *((j, (*e, 0, 0, 0)) for j, e in ALONE.terms),
        (0, (0, 0, 0, 1, 0, 0)),
        (1, (0, 0, 0, 1, 0, 0)),
        (1, (1, 0, 0, 0, 0, 0)),
    ),
)
COUPLING, DAMPER = 0.05, 0.05


def beside(s: Any) -> Any:
    """What B_2 = −ikB_1/(μ_2 + i(s − d)) is divided by: its rate of decay and its detuning."""
    return DAMPER + 1j * (s - 0.8)


def coupled(force: float) -> Callable[[Any], Any]:
    """Coefficients of both oscillators."""

    def coefficients(s):
        one = np.ones(len(s))
        linear = np.stack([-1j * COUPLING * one, -beside(s), -1j * COUPLING * one], axis=-1)
        return np.concatenate((alone(force)(s), linear), axis=-1)

    return coefficients


@pytest.mark.parametrize("count", [20, 86, 400])
def test_a_thin_isola(count: int) -> None:
    """Self-excited and driven weakly: ρ((μ − νρ)² + (σ − cρ)²) = f², two roots 2e-4 of ρ apart.

    σ(ρ) = cρ ± √(f²/ρ − (μ − νρ)²) has its extrema where (2ν(μ − νρ)ρ² − f²)² is
    4c²ρ³(f² − ρ(μ − νρ)²).
    """
    mu, nu, c, f = 0.0188, 0.017, -1.836, 0.000207
    flow = Flow(1, ((0, (0, 0, 0)), (0, (1, 0, 0)), (0, (2, 1, 0))))

    def coefficients(s):
        one = np.ones(len(s))
        return np.stack([-1j * f * one, mu - 1j * s, (-nu + 1j * c) * one], axis=-1)

    rho, gain = np.poly1d([1, 0]), np.poly1d([-nu, mu])
    ends = 4 * c**2 * (f**2 * rho**3 - rho**4 * gain**2) - (2 * nu * gain * rho**2 - f**2) ** 2
    at = [r.real for r in ends.roots if abs(r.imag) < 1e-9 and r.real > 0.5]
    sides = [np.sign(c * (f**2 / r**2 - 2 * nu * gain(r))) for r in at]
    expected = [
        c * r + side * np.sqrt(f**2 / r - gain(r) ** 2) for r, side in zip(at, sides, strict=True)
    ]
    p = np.linspace(-8.2, 4.1, count)
    response = response_of(flow, coefficients, p)
    folds = [b.parameter for b in response.bifurcations]
    # Roots of a polynomial that are 0.02 apart, their rounding twice under a root of 1e-4.
    assert folds == pytest.approx(sorted(expected), abs=1e-8)
    again = response_of(flow, coefficients, np.union1d(p, folds))
    assert [b.parameter for b in again.bifurcations] == pytest.approx(folds, abs=1e-10)
    assert len(response.branches) == len(again.branches) == 2


@pytest.mark.parametrize("above", [0.07, 0.0583])
@pytest.mark.parametrize("count", [40, 600])
def test_a_small_isola_of_two_amplitudes(count: int, above: float) -> None:
    """A linear oscillator beside it: eliminated, it changes the linear coefficient, exactly.

    The least force of large amplitudes has `above` = 0.058146 then; the second isola is 1/50 of
    the distance between two values at which all equilibria are computed.
    """
    force = (lowest()[1] * (1 + above)) ** 0.5

    def one(s):
        c = alone(force)(s)
        c[:, 1] -= COUPLING**2 / beside(s)
        return c

    exact = response_of(ALONE, one, np.linspace(0.2, 0.5, 400)).bifurcations
    response = response_of(COUPLED, coupled(force), np.linspace(-0.97, 2.05, count))
    folds = [b.parameter for b in response.bifurcations if b.kind == "saddle-node"]
    expected = [b.parameter for b in exact if b.kind == "saddle-node"]
    assert len(expected) == 2
    assert folds == pytest.approx(expected, abs=1e-11)  # extrema along curves, to rounding
    assert len(response.branches) == 2


def test_pairs_of_complex_equilibria_that_do_not_meet() -> None:
    """Below the least force they come close and part again."""
    force = (lowest()[1] * 1.058) ** 0.5

    response = response_of(COUPLED, coupled(force), np.linspace(-0.97, 2.05, 200))
    assert response.bifurcations == ()
    assert len(response.branches) == 1
