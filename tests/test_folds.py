"""Folds about which the parameter changes little: both sides apart, also between close values."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from flow_tables import table

from mmsgen.runtime._branches import response_of
from mmsgen.runtime._flow import Flow, rates, spectrum
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


MU, ONE, TWO, FORCE = 0.01, 0.05j, 0.01875j, -0.005j


def between_pitchforks() -> tuple[Flow, Callable[[Any], Any]]:
    """1:2 driven at the higher frequency, and its coefficients over the detuning."""
    flow = table(
        [(0, 1, 0, 0, 0), (1, 0, 0, 1, 0), (0, 0, 1, 1, 0), (1, 2, 0, 0, 0), (1,) + (0,) * 4]
    )

    def coefficients(sigma):
        unit = np.ones(len(sigma))
        slow, fast = -MU - 0.5j * sigma, -MU - 1j * sigma
        by_term = {
            (0, (1, 0, 0, 0, 0, 0)): slow,
            (1, (0, 0, 0, 1, 0, 0)): fast,
            (0, (0, 1, 0, 1, 0, 0)): ONE * unit,
            (1, (2, 0, 0, 0, 0, 0)): TWO * unit,
            (1, (0,) * 6): FORCE * unit,
        }
        return np.stack([by_term[term] for term in flow.terms], axis=-1)

    return flow, coefficients


def test_a_fold_between_pitchforks() -> None:
    """1:2 driven at the higher frequency, c_1 and c_2 the couplings and g = |c_1| times the force.

    Where B_1 is not at rest, B_2 follows from its equation up to the phase, and the other one
    leaves |(μ + iσ)(μ + iσ/2) − c_1 c_2 |B_1|²| = g: quadratic in |B_1|², and double where the
    imaginary part is g, 3μ|σ|/2 = g.
    """
    flow, coefficients = between_pitchforks()
    response = response_of(flow, coefficients, np.linspace(-0.05, 0.05, 2500))
    along_both_sides(response, flow, coefficients)
    kinds = [b.kind for b in response.bifurcations]
    assert kinds == ["saddle-node", "pitchfork", "pitchfork", "saddle-node"]
    edge = abs(ONE * FORCE) / (1.5 * MU)
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


def driven(s):
    """B' = −(0.05 + iσ)B + 0.375iB²B̄·4 − 0.025i."""
    one = np.ones(len(s))
    return np.stack([-0.025j * one, -0.025 - 1j * s, 1.5j * one], axis=-1)


DRIVEN = Flow(1, ((0, (0, 0, 0)), (0, (1, 0, 0)), (0, (2, 1, 0))))


def same_answer(flow: Flow, coefficients, p, width: float) -> Response:
    """Bifurcations put among the given values leave kinds, their places, and the branches alike."""
    before = response_of(flow, coefficients, p)
    own = [b.parameter for b in before.bifurcations]
    for more in (own, [x * (1 + 1e-15) for x in own], [x - 1e-13 * width for x in own]):
        after = response_of(flow, coefficients, np.union1d(p, more))
        assert [b.kind for b in after.bifurcations] == [b.kind for b in before.bifurcations]
        # Both are extrema along the curve to rounding, and products of eigenvalues below 1e-11.
        again = [b.parameter for b in after.bifurcations]
        assert again == pytest.approx(own, abs=1e-10 * width)
        assert len(after.branches) == len(before.branches)
        for branch in after.branches:
            c = coefficients(branch.parameter)
            left = rates(flow, c, branch.amplitudes)
            # A fold that is 2e-13 of the range from a given value is taken to be there.
            snapped = 2e-13 * width * np.abs(branch.amplitudes).max()
            assert np.abs(left).max() < 1e-12 * np.abs(c).max() + snapped
    return before


def test_a_fold_at_a_given_value() -> None:
    fold = 0.18239577211812104
    response = response_of(DRIVEN, driven, [-0.3, 0.1, fold, 0.2, 0.6])
    assert [b.kind for b in response.bifurcations] == ["saddle-node"]
    assert response.bifurcations[0].parameter == pytest.approx(fold, abs=1e-14)
    assert len(response.branches) == 2
    for count, value in ((1, 0.1), (3, 0.2)):
        assert sum(np.sum(b.parameter == value) for b in response.branches) == count


@pytest.mark.parametrize("at_end", [0, -1])
def test_a_fold_at_the_first_or_the_last_value(at_end: int) -> None:
    """It is one then as well, and the sheets meet there."""
    p = np.linspace(-0.3, 1.9, 60)
    folds = [b.parameter for b in response_of(DRIVEN, driven, p).bifurcations]
    p = np.append(p[p < folds[-1]], folds[-1]) if at_end else np.append(p[p > folds[0]], folds[0])
    response = response_of(DRIVEN, driven, p)
    assert [b.parameter for b in response.bifurcations] == pytest.approx(folds, abs=1e-14)
    (branch,) = response.branches
    assert p.min() <= branch.parameter.min() < branch.parameter.max() <= p.max()


@pytest.mark.parametrize("seed", range(6))
def test_random_folds_among_the_values(seed: int) -> None:
    numbers = np.random.default_rng(seed)
    force, damping, cubic = numbers.uniform(0.04, 0.08), numbers.uniform(0.02, 0.04), 1.5

    def coefficients(s):
        one = np.ones(len(s))
        return np.stack([-1j * force * one, -damping - 1j * s, 1j * cubic * one], axis=-1)

    peak = cubic * (force / damping) ** 2
    p = np.linspace(-0.2 * peak, 1.2 * peak, int(numbers.integers(20, 400)))
    response = same_answer(DRIVEN, coefficients, p, 1.4 * peak)
    assert [b.kind for b in response.bifurcations] == ["saddle-node"] * 2


def folds_of(force: float, damping: float, cubic: float) -> list[float]:
    """Where s(ρ) = cρ + √(f²/ρ − μ²) has its extrema: 4c²ρ³(f² − μ²ρ) = f⁴."""
    roots = np.roots([damping**2, -(force**2), 0.0, 0.0, force**4 / (4 * cubic**2)])
    rho = roots[(np.abs(roots.imag) < 1e-6 * np.abs(roots)) & (roots.real > 0)].real
    return sorted(cubic * rho + np.sqrt(np.maximum(force**2 / rho - damping**2, 0.0)))


@pytest.mark.parametrize("sharp", [1e2, 1e3, 1e4, 1e5])
@pytest.mark.parametrize("count", [63, 377])
def test_sheets_of_sharp_peaks(sharp: float, count: int) -> None:
    """The peak is `sharp` half-widths from zero: one branch, two folds, whatever is given.

    Lengths along the curve are over the amplitudes there, which grow a hundredfold.
    """
    force, cubic = 0.05, 1.5
    damping = (cubic * force**2 / sharp) ** (1 / 3)

    def coefficients(s):
        one = np.ones(len(s))
        return np.stack([-1j * force * one, -damping - 1j * s, 1j * cubic * one], axis=-1)

    peak = cubic * (force / damping) ** 2
    p = np.linspace(-0.2 * peak, 1.2 * peak, count)
    response = same_answer(DRIVEN, coefficients, p, 1.4 * peak)
    assert [b.kind for b in response.bifurcations] == ["saddle-node"] * 2
    # The upper one is 1/(8·sharp) of a half-width from the peak: a double root in doubles.
    exact = pytest.approx(folds_of(force, damping, cubic), abs=1e-7 * peak)
    assert [b.parameter for b in response.bifurcations] == exact
    (branch,) = response.branches
    inner = p[(p > response.bifurcations[0].parameter) & (p < response.bifurcations[1].parameter)]
    assert all(np.sum(branch.parameter == x) == (3 if x in inner else 1) for x in p)


def symmetric_pair() -> tuple[Flow, Callable[[Any], Any]]:
    """Two alike Duffing oscillators, coupled and driven alike."""
    first = [(0, 0, 0, 0, 0, 0), (0, 0, 0, 1, 0, 0), (1, 0, 0, 0, 0, 0), (2, 1, 0, 0, 0, 0)]
    second = [e[3:] + e[:3] for e in first]
    flow = Flow(2, (*((0, e) for e in first), *((1, e) for e in second)))

    def coefficients(s):
        one = np.ones(len(s))
        own = [-0.05j * one, -0.04j * one, -0.02 + 0.04j - 1j * s, 1.5j * one]
        return np.stack([*own, *own], axis=-1)

    return flow, coefficients


def pitchforks_of_the_pair() -> list[float]:
    """In phase B solves Duffing's equation; a disturbance out of phase is neutral there.

    It obeys b' = (−μ + i(2k − σ) + 2icρ)b + icB²b̄, so that it is neutral where
    μ² + (2k − σ + 2cρ)² = c²ρ²: with σ = cρ ± √(f²/ρ − μ²), polynomials in ρ once it is squared.
    """
    mu, k, c, f = 0.02, 0.04, 1.5, 0.05
    found = []
    for sign in (1.0, -1.0):
        rho = np.linspace(1e-4, f**2 / mu**2 - 1e-9, 400_001)
        root = np.sqrt(f**2 / rho - mu**2)
        value = mu**2 + (2 * k + c * rho - sign * root) ** 2 - (c * rho) ** 2
        change = np.flatnonzero(value[1:] * value[:-1] < 0)
        at = rho[change] - value[change] * np.diff(rho)[change] / np.diff(value)[change]
        found += list(c * at + sign * np.sqrt(f**2 / at - mu**2))
    return sorted(found)


def test_curves_that_cross_each_other() -> None:
    """A pair that is symmetric: branches out of phase leave the other at pitchforks."""
    flow, coefficients = symmetric_pair()
    p = np.linspace(-1.0, 10.0, 60)
    before = response_of(flow, coefficients, p)
    own = [b.parameter for b in before.bifurcations]
    after = response_of(flow, coefficients, np.union1d(p, own))
    assert [b.kind for b in after.bifurcations] == [b.kind for b in before.bifurcations]
    assert len(after.branches) == len(before.branches) == 2
    for response in (before, after):
        forks = [b for b in response.bifurcations if b.kind == "pitchfork"]
        # Linear interpolation on 4·10^5 values: errors of 1e-9 of the range.
        assert [b.parameter for b in forks] == pytest.approx(pitchforks_of_the_pair(), abs=1e-7)
        for b in forks:
            # Along the null vector: the rounding over the smallest singular value that counts.
            assert b.amplitudes[0] == pytest.approx(b.amplitudes[1], abs=1e-7)


@pytest.mark.parametrize("count", [9, 80])
def test_pitchforks_among_the_values(count: int) -> None:
    """Mathieu and Duffing, where σ² = f² − 4μ²."""
    flow = Flow(1, ((0, (0, 1, 0)), (0, (1, 0, 0)), (0, (2, 1, 0))))

    def coefficients(s):
        one = np.ones(len(s))
        return np.stack([0.1j * one, -0.05 - 0.5j * s, 0.75j * one], axis=-1)

    response = same_answer(flow, coefficients, np.linspace(-0.5, 0.5, count), 1.0)
    assert [b.kind for b in response.bifurcations] == ["pitchfork"] * 2
    edge = np.sqrt(0.2**2 - 4 * 0.05**2)
    exact = response_of(flow, coefficients, [-0.5, -edge, 0.0, edge, 0.4])
    assert [b.kind for b in exact.bifurcations] == ["pitchfork"] * 2
    assert len(exact.branches) == 3


def test_bifurcations_of_two_amplitudes_among_the_values() -> None:
    """1:2 driven at the higher frequency as above: folds and pitchforks; sampled coarsely."""
    flow, coefficients = between_pitchforks()
    response = same_answer(flow, coefficients, np.linspace(-0.05, 0.05, 30), 0.1)
    kinds = [b.kind for b in response.bifurcations]
    assert kinds == ["saddle-node", "pitchfork", "pitchfork", "saddle-node"]


@pytest.mark.parametrize("count", [2, 12, 101, 301])
def test_a_hopf_point_between_few_values(count: int) -> None:
    """Two alike Duffing oscillators, coupled, the first driven: whatever values are given.

    It is close to a fold, and only 1001 given values and more have one between the two. Each
    point is one by its own spectrum.
    """
    first = [(0, 0, 0, 0, 0, 0), (0, 0, 0, 1, 0, 0), (1, 0, 0, 0, 0, 0), (2, 1, 0, 0, 0, 0)]
    second = [e[3:] + e[:3] for e in first[1:]]
    flow = Flow(2, (*((0, e) for e in first), *((1, e) for e in second)))

    def coefficients(s):
        one = np.ones(len(s))
        own = [-0.05j * one, -0.025 + 0.05j - 1j * s, 1.5j * one]
        return np.stack([-0.025j * one, *own, *own], axis=-1)

    response = response_of(flow, coefficients, np.linspace(-0.3, 0.6, count))
    found = [b for b in response.bifurcations if b.kind == "Hopf"]
    assert len(found) == 3
    assert any(b.parameter == pytest.approx(0.158724, abs=1e-6) for b in found)
    for b in found:
        values = spectrum(flow, coefficients(np.array([b.parameter]))[0], b.amplitudes)
        pairs = np.abs(values[:, None] + values)[np.triu_indices(4, 1)]
        assert pairs.min() < 1e-11 * np.abs(values).max()
