"""Folds about which the parameter changes little: both sides apart, also between close values."""

from __future__ import annotations

import numpy as np
import pytest
from flow_tables import table

from mmsgen.runtime._branches import response_of
from mmsgen.runtime._flow import Flow, rates
from mmsgen.runtime._points import NEUTRAL
from mmsgen.runtime._records import Response


def along_both_sides(response: Response, flow: Flow, coefficients) -> None:
    """Points are equilibria, and moduli change by less than the root of the steps of p.

    At a fold a change of the parameter by δ moves them by C √δ; here C is below 30.
    """
    for branch in response.branches:
        left = rates(flow, coefficients(branch.parameter), branch.amplitudes)
        assert np.abs(left).max() < 1e-14  # sums of some terms below 0.1
        steps = np.abs(np.diff(branch.parameter))
        moved = np.abs(np.diff(branch.modulus, axis=0)).max(axis=1)
        assert np.all(moved <= 30 * np.sqrt(np.maximum(steps, 1e-12)))


@pytest.mark.parametrize("count", [501, 2000, 10_000])
def test_both_folds_of_a_driven_oscillator(count: int) -> None:
    """B' = −(μ + iσ)B + 3iα/2ω B²B̄ − iK/4ω: the lower fold is flat in σ.

    Exact: the folds are double roots ρ = |B|² of ρ(μ² + (σ − cρ)²) = f².
    """
    flow = Flow(1, ((0, (0, 0, 0)), (0, (1, 0, 0)), (0, (2, 1, 0))))

    def coefficients(sigma):
        one = np.ones(len(sigma))
        return np.stack([-0.025j * one, -0.02 - 1j * sigma, 0.075j * one], axis=-1)

    response = response_of(flow, coefficients, np.linspace(-0.1, 0.4, count))
    along_both_sides(response, flow, coefficients)
    assert [b.kind for b in response.bifurcations] == ["saddle-node"] * 2
    mu, c, f = 0.02, 0.075, 0.025
    for point in response.bifurcations:
        rho, sigma = abs(point.amplitudes[0]) ** 2, point.parameter
        # The rounding of the rates, 1e-17 of 1e-2, moves the double root by its square root.
        assert rho * (mu**2 + (sigma - c * rho) ** 2) == pytest.approx(f**2, rel=1e-11)
        slope = mu**2 + (sigma - c * rho) * (sigma - 3 * c * rho)
        assert slope == pytest.approx(0.0, abs=1e-7 * mu**2 * 3)


def test_a_fold_between_pitchforks() -> None:
    """1:2 driven at the higher frequency, c_1 and c_2 the couplings and g = |c_1| times the force.

    Where B_1 is not at rest, B_2 follows from its equation up to the phase, and the other one
    leaves |(μ + iσ)(μ + iσ/2) − c_1 c_2 |B_1|²| = g: quadratic in |B_1|², and double where the
    imaginary part is g, 3μ|σ|/2 = g.
    """
    flow = table(
        [(0, 1, 0, 0, 0), (1, 0, 0, 1, 0), (0, 0, 1, 1, 0), (1, 2, 0, 0, 0), (1,) + (0,) * 4]
    )
    mu, one, two, force = 0.01, 0.05j, 0.01875j, -0.005j

    def coefficients(sigma):
        unit = np.ones(len(sigma))
        slow, fast = -mu - 0.5j * sigma, -mu - 1j * sigma
        by_term = {
            (0, (1, 0, 0, 0, 0, 0)): slow,
            (1, (0, 0, 0, 1, 0, 0)): fast,
            (0, (0, 1, 0, 1, 0, 0)): one * unit,
            (1, (2, 0, 0, 0, 0, 0)): two * unit,
            (1, (0,) * 6): force * unit,
        }
        return np.stack([by_term[term] for term in flow.terms], axis=-1)

    response = response_of(flow, coefficients, np.linspace(-0.05, 0.05, 2500))
    along_both_sides(response, flow, coefficients)
    kinds = [b.kind for b in response.bifurcations]
    assert kinds == ["saddle-node", "pitchfork", "pitchfork", "saddle-node"]
    edge = abs(one * force) / (1.5 * mu)
    ends = [response.bifurcations[k].parameter for k in (0, 3)]
    assert ends == pytest.approx([-edge, edge], rel=1e-12)


@pytest.mark.parametrize("turn", [0.0, 0.3, 7.7])
def test_a_circle_is_born_whatever_its_drift(turn: float) -> None:
    """B' = (μ/2 − μs²/4 + iτ)B − ½μB²B̄: the circle vanishes at s = √2, and growth with it."""
    flow = Flow(1, ((0, (1, 0, 0)), (0, (2, 1, 0))), ((1,),))

    def coefficients(s):
        return np.stack([0.1 - 0.05 * s * s + 1j * turn, np.full(len(s), -0.1)], axis=-1)

    for top in np.linspace(1.5, 1.9, 7):
        response = response_of(flow, coefficients, np.linspace(0.01, top, 400))
        (hopf,) = response.bifurcations
        assert hopf.kind == "Hopf"
        # Re λ has the slope −0.14, is zero below NEUTRAL of |λ|, and has a rounding of 1e-17.
        assert hopf.parameter == pytest.approx(2**0.5, abs=1e-14 + NEUTRAL * turn / 0.14)
