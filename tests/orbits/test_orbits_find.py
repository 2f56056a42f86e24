"""Periodic orbits against exact periods, known multipliers and time integration."""

from __future__ import annotations

import numpy as np
import pytest
from orbit_systems import duffing, free_duffing, mathieu_duffing, pendulum_on_cart, van_der_pol
from scipy.integrate import solve_ivp
from scipy.special import ellipk

import mmsgen as mg
from mmsgen.floquet.collocation import gauss_table
from mmsgen.motion import first_order_system
from mmsgen.orbits.collocation import Setting, newton
from mmsgen.orbits.curves import sampled, scale_of
from mmsgen.orbits.records import PeriodicOrbit

FORCED = {"mu": 0.05, "alpha": 0.1, "K": 0.3, "Omega": 1.1}


def forced_orbit(tolerance: float = 1e-10) -> mg.orbits.PeriodicOrbit:
    problem = mg.orbits.problem(duffing(), FORCED)
    return mg.orbits.find(problem, lambda s: [2 * np.cos(1.1 * s - 0.8)], tolerance=tolerance)


def cycle(strength: float) -> mg.orbits.PeriodicOrbit:
    problem = mg.orbits.problem(van_der_pol(), {"mu": strength})
    guess, period = mg.orbits.settle(problem, [2.0, 0.0], 8 / strength)
    return mg.orbits.find(problem, guess, period)


@pytest.mark.parametrize("size", [0.3, 2.0])
def test_free_duffing_has_the_elliptic_period(size: float) -> None:
    # Nayfeh & Mook (1979), ch. 2: T = 4K(m)/√(1 + αa²), m = αa²/(2(1 + αa²)), a the largest
    # displacement. The system is conservative: every orbit is one of a family.
    problem = mg.orbits.problem(free_duffing(), {"alpha": 0.7})
    omega = np.sqrt(1 + 0.75 * 0.7 * size**2)
    orbit = mg.orbits.find(
        problem,
        lambda s: [size * np.cos(omega * s), -omega * size * np.sin(omega * s)],
        2 * np.pi / omega,
        isolated=False,
    )
    # the largest displacement, from the energy, which is the same at all times
    q, v = orbit.states
    energy = v**2 / 2 + q**2 / 2 + 0.7 * q**4 / 4
    assert np.ptp(energy) < 1e-9
    y = np.sqrt(1 + 4 * 0.7 * energy.mean()) - 1  # αa²
    assert y == pytest.approx(0.7 * size**2, rel=0.1)
    # An error e of the states is one of e in y, and of as much in the period.
    exact = 4 * ellipk(y / (2 * (1 + y))) / np.sqrt(1 + y)
    assert abs(orbit.period - exact) < 10 * orbit.error.max() + orbit.period_error
    assert orbit.period_error < 1e-9
    assert orbit.verdict != "unstable"


def test_van_der_pol_against_the_series() -> None:
    # Andersen & Geer (1982): ω = 1 − μ²/16 + 17μ⁴/3072 + 35μ⁶/884736 − …; what follows is of the
    # order μ⁸/1000, the amplitude of the fundamental 2 + μ²/64 + O(μ⁴).
    strength = 0.1
    orbit = cycle(strength)
    series = 1 - strength**2 / 16 + 17 * strength**4 / 3072 + 35 * strength**6 / 884736
    assert abs(2 * np.pi / orbit.period - series) < strength**8 / 100
    assert abs(orbit.amplitude() - 2 - strength**2 / 64) < strength**4
    assert orbit.verdict == "stable"
    assert orbit.stable
    # Liouville: the product of both multipliers, the trivial one among them, is
    # exp ∮ μ(1 − u²) dt, the integral by the trapezoidal rule, exact for smooth periodic functions.
    damping = strength * (1 - orbit.states[0] ** 2)
    expected = np.exp(damping.mean() * orbit.period)
    assert abs(orbit.multipliers[1].real - expected) < 1e-9
    assert orbit.multipliers[0] == 1


def test_van_der_pol_closes_under_time_integration() -> None:
    # A second method: DOP853 from a state of the orbit comes back to it after the period. Its
    # error is a few hundred times the tolerance of one step over some 200 steps.
    orbit = cycle(1.0)
    start, end = orbit.states[:, 0], orbit.period
    derivative = first_order_system(van_der_pol(), {"mu": 1.0})
    path = solve_ivp(derivative, (0, end), start, "DOP853", rtol=1e-13, atol=1e-13)
    assert np.abs(path.y[:, -1] - start).max() < 1e-10
    # known to many digits, from Taylor series in multiple precision
    assert abs(orbit.period - 6.66328685932313) < 1e-11


def test_moving_mass_matrix_against_time_integration() -> None:
    values = {"mu": 0.1, "K": 0.4, "Omega": 1.3}
    problem = mg.orbits.problem(pendulum_on_cart(), values)
    derivative = first_order_system(pendulum_on_cart(), values)
    # transients decay like e^{-0.1 t}: what is left is a guess only
    end = 40 * 2 * np.pi / 1.3
    start = solve_ivp(derivative, (0, end), [0.1, 0, 0.1, 0], "DOP853", rtol=1e-6).y[:, -1]
    orbit = mg.orbits.find(problem, start)
    path = solve_ivp(
        derivative, (0, orbit.period), orbit(0.0), "DOP853", orbit.times, rtol=1e-13, atol=1e-13
    )
    assert np.abs(path.y - orbit.states).max() < 1e-9
    assert orbit.error.max() < 1e-9
    assert np.ptp(orbit.states[1]) > 0.2  # a motion that is not small
    # Liouville, the trace of the vector field by differences of the time integrator's own
    step, trace = 1e-6, 0.0
    for time, state in zip(orbit.times, orbit.states.T, strict=True):
        for j in range(4):
            shift = step * np.eye(4)[j]
            ahead, behind = (derivative(time, state + s * shift)[j] for s in (1, -1))
            trace += (ahead - behind) / (2 * step) * orbit.period / len(orbit.times)
    # differences are good to about step², 1e-11, and rounding over the step, 1e-10
    assert abs(np.prod(orbit.multipliers) - np.exp(trace)) < 1e-7
    assert orbit.verdict == "stable"


def test_multipliers_at_rest_are_those_of_floquet() -> None:
    values = {"mu": 0.02, "f": 0.2, "Omega": 2.1, "alpha": 0.3}
    problem = mg.orbits.problem(mathieu_duffing(), values)
    orbit = mg.orbits.find(problem, np.zeros((2, 5)))
    known = mg.floquet.multipliers(mathieu_duffing(), values)
    own = np.sort_complex(orbit.multipliers)
    assert np.abs(own - np.sort_complex(known.value)).max() < known.error.max() + 1e-12
    assert orbit.verdict == mg.floquet.growth_rate(mathieu_duffing(), values).verdict == "unstable"
    # What rounding leaves of rest is rest as well.
    again = mg.orbits.find(problem, 1e-17 * np.ones((2, 5)))
    assert np.abs(again.multipliers - orbit.multipliers).max() < 1e-12
    path = mg.orbits.follow(problem, again, "Omega", 2.15)
    assert path.reason == "reached"


def test_linear_damping_gives_the_product_of_multipliers() -> None:
    orbit = forced_orbit()
    assert abs(np.prod(orbit.multipliers) - np.exp(-0.1 * orbit.period)) < 1e-12


def test_error_estimates_hold_and_follow_the_tolerance() -> None:
    exact = forced_orbit(1e-12)
    for tolerance in (1e-3, 1e-6, 1e-9):
        orbit = forced_orbit(tolerance)
        gap = np.abs(orbit.states - exact.states).max(axis=1)
        assert (gap <= orbit.error + exact.error).all()
        assert (orbit.error <= 2 * tolerance * np.abs(orbit.states).max(axis=1)).all()


def test_rounding_is_part_of_the_error() -> None:
    # Two ways to one orbit, on different meshes, differ by rounding alone, which the equations of
    # a weakly damped motion enlarge a thousandfold.
    values = {"mu": 2e-4, "alpha": 1e-3, "K": 1e-3, "Omega": 1.002}
    problem = mg.orbits.problem(duffing(), values)
    first = mg.orbits.find(problem, lambda s: [2 * np.cos(1.002 * s)], tolerance=1e-12)
    finer = PeriodicOrbit(**{**vars(first), "curve": first.curve.refined(80)})
    again = mg.orbits.find(problem, finer, tolerance=1e-12)
    assert first.curve.intervals != again.curve.intervals
    gap = np.abs(first.states - again.states).max(axis=1)
    assert (gap > 1e-15).all()
    assert (gap <= first.error + again.error).all()
    assert (first.error < 1e-9).all()


def test_order_of_convergence() -> None:
    # Five stages: the period is good to order 2s = 10, so that half the length of the intervals
    # leaves 2⁻¹⁰ of the error, where that is above rounding; a little less, as higher terms fall
    # faster.
    reference = cycle(0.5)
    exact = mg.orbits.find(reference.problem, reference, tolerance=1e-13)
    errors = []
    for count in (10, 20, 12, 24):
        guess = sampled(exact.curve.at, count, gauss_table(5), exact.curve.frequency)
        curve, _, _ = newton(Setting(exact.problem, 1, scale_of(guess)), guess)
        errors.append(abs(2 * np.pi / curve.frequency - exact.period))
    assert min(errors) > 10 * exact.period_error
    for coarse, fine in (errors[:2], errors[2:]):
        assert 9.5 < np.log2(coarse / fine) < 11.5


def test_harmonics_are_those_of_the_samples() -> None:
    orbit = forced_orbit()
    samples = np.fft.rfft(orbit.states, axis=1) / orbit.states.shape[1]
    # 128 samples alias harmonic 125 onto 3, which is far below rounding here
    assert np.abs(orbit.harmonics([0, 1, 3]) - samples[:, [0, 1, 3]]).max() < 1e-11
    assert orbit.amplitude(0, 3) == pytest.approx(2 * abs(samples[0, 3]), rel=1e-9)
    assert np.abs(orbit(orbit.times) - orbit.states).max() < 1e-12


def test_subharmonic_amplitudes_approach_the_published_ones() -> None:
    # Nayfeh & Mook (1979), ch. 4: ω₀ = α = 1, μ = 0.05, K = 8, σ = 6 have a = 2.39198687 (stable)
    # and 1.39465604 (unstable), with an error of O(ε): halving ε halves it.
    triple = -8 / 16
    for size, verdict in ((2.39198687, "stable"), (1.39465604, "unstable")):
        errors = []
        for epsilon in (1 / 64, 1 / 128, 1 / 256):
            speed = 3 + 6 * epsilon
            values = {"mu": 0.05 * epsilon, "alpha": epsilon, "K": 8.0, "Omega": speed}
            problem = mg.orbits.problem(duffing(), values)
            # da/dt = dγ/dt = 0 of the slow flow, for 3γ
            s = 9 * 0.05 / (-9 * triple / 4 * size)
            c = (6 - 9 * triple**2 - 9 * size**2 / 8) / (9 * triple / 4 * size)
            turn = np.arctan2(s, c) / 3
            force = 8.0 / (1 - speed**2)
            orbit = mg.orbits.find(
                problem,
                lambda x, v=speed, a=size, g=turn, k=force: [
                    a * np.cos(v * x / 3 + g) + k * np.cos(v * x)
                ],
                periods=3,
            )
            assert orbit.verdict == verdict
            errors.append(abs(orbit.amplitude() - size))
        ratios = np.array(errors[:-1]) / errors[1:]
        # 2 (1 + O(ε)); the next term, of some 10 ε, is 0.1 here
        assert ratios == pytest.approx(2, abs=0.2)
