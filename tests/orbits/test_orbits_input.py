"""What is refused, and how it is said."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from orbit_systems import K, Omega, alpha, duffing, equations, free_duffing, t, u, van_der_pol, w

import mmsgen as mg

FORCED = {"mu": 0.05, "alpha": 0.1, "K": 0.3, "Omega": 1.1}


def test_problems_say_what_is_wrong() -> None:
    with pytest.raises(mg.OrbitError, match="no value is given for K, Omega"):
        mg.orbits.problem(duffing(), {"mu": 0.1, "alpha": 0.1})
    with pytest.raises(mg.MmsgenError, match="omega is not a parameter"):
        mg.orbits.problem(duffing(), {**FORCED, "omega": 1.0})
    with pytest.raises(mg.OrbitError, match="must be one number"):
        mg.orbits.problem(duffing(), {**FORCED, "K": [0.1, 0.2]})
    with pytest.raises(mg.OrbitError, match="enter nonlinearly"):
        mg.orbits.problem(equations([u.diff(t, 2) + u.diff(t, 2) ** 3 + u], [u]), {})
    with pytest.raises(mg.OrbitError, match="frequency of the excitation must be positive"):
        mg.orbits.problem(duffing(), {**FORCED, "Omega": -1.0})
    both = equations([u.diff(t, 2) + u - K * sp.cos(Omega * t) - alpha * sp.cos(t)], [u])
    with pytest.raises(mg.OrbitError, match="pass period="):
        mg.orbits.problem(both, {"K": 0.1, "Omega": 2.5, "alpha": 0.1})
    with pytest.raises(mg.OrbitError, match="leave period= out"):
        mg.orbits.problem(free_duffing(), {"alpha": 0.1}, period=1.0)
    with pytest.raises(mg.OrbitError, match="no value is given for mu"):
        mg.orbits.autonomous({sp.Symbol("v"): sp.Symbol("mu") * sp.Symbol("v")}, {})


def test_a_period_that_only_numbers_have() -> None:
    # cos t and cos(5t/2) repeat together after 4π. Where the period is a number, the frequency
    # that it was made for cannot be followed, other parameters can.
    left = u.diff(t, 2) + u.diff(t) + u - K * sp.cos(Omega * t) - alpha * sp.cos(t)
    values = {"K": 0.4, "Omega": 2.5, "alpha": 0.3}
    problem = mg.orbits.problem(equations([left], [u]), values, period=4 * np.pi)
    orbit = mg.orbits.find(problem, np.zeros((2, 5)))
    # linear: the amplitude of each harmonic is known
    for number, force in ((2, 0.3), (5, 0.4)):
        speed = number / 2
        exact = force / abs(1 - speed**2 + 1j * speed)
        assert abs(orbit.amplitude(0, number) - exact) < 10 * orbit.error[0]
    path = mg.orbits.follow(problem, orbit, K, 0.8)
    assert path.orbits[-1].amplitude(0, 5) == pytest.approx(2 * orbit.amplitude(0, 5), abs=1e-9)
    with pytest.raises(mg.OrbitError, match="changes the period"):
        mg.orbits.follow(problem, orbit, Omega, 3.0)


def test_guesses_are_checked() -> None:
    problem = mg.orbits.problem(duffing(), FORCED)
    cycle = mg.orbits.problem(van_der_pol(), {"mu": 1.0})
    with pytest.raises(mg.OrbitError, match="a problem is needed"):
        mg.orbits.find(duffing(), np.zeros((2, 5)))
    with pytest.raises(mg.OrbitError, match="shape"):
        mg.orbits.find(problem, np.zeros((3, 5)))
    with pytest.raises(mg.OrbitError, match="finite"):
        mg.orbits.find(problem, np.full((2, 5), np.nan))
    with pytest.raises(mg.OrbitError, match="shape"):
        mg.orbits.find(problem, lambda s: np.zeros((3, len(s))))
    with pytest.raises(mg.OrbitError, match="whole number"):
        mg.orbits.find(problem, np.zeros((2, 5)), periods=0)
    with pytest.raises(mg.OrbitError, match="give periods="):
        mg.orbits.find(problem, np.zeros((2, 5)), 1.0)
    with pytest.raises(mg.OrbitError, match="positive guess of the period"):
        mg.orbits.find(cycle, np.ones((2, 5)))
    with pytest.raises(mg.OrbitError, match="no periods of it"):
        mg.orbits.find(cycle, np.ones((2, 5)), 6.0, periods=2)
    with pytest.raises(mg.OrbitError, match="the period is known"):
        mg.orbits.settle(problem, [0.0, 0.0], 10.0)
    with pytest.raises(mg.OrbitError, match="comes to rest"):
        mg.orbits.settle(cycle, [0.0, 0.0], 10.0)
    with pytest.raises(mg.OrbitError, match="does not come back"):
        mg.orbits.settle(cycle, [2.0, 0.0], 1.0)


def test_where_there_is_no_orbit_it_is_said() -> None:
    # u'' + u + αu³ = 0 conserves energy: orbits are not isolated, and Newton's method wanders.
    problem = mg.orbits.problem(free_duffing(), {"alpha": 0.5})
    samples = np.stack([np.cos(np.linspace(0, 6, 9)), -np.sin(np.linspace(0, 6, 9))])
    orbit = mg.orbits.find(problem, samples, 6.0, isolated=False)
    assert orbit.verdict != "unstable"
    # a constant force without stiffness drives the mass away
    runaway = equations([u.diff(t, 2) + w.diff(t) - 1, w.diff(t, 2) + w - sp.cos(t)], [u, w])
    with pytest.raises(mg.OrbitError, match=r"singular|no periodic orbit"):
        mg.orbits.find(mg.orbits.problem(runaway, {}), np.ones((4, 5)))


def test_ranges_and_parameters_are_checked() -> None:
    problem = mg.orbits.problem(duffing(), FORCED)
    orbit = mg.orbits.find(problem, lambda s: [2 * np.cos(1.1 * s - 0.8)])
    with pytest.raises(mg.OrbitError, match="beta is not a parameter"):
        mg.orbits.follow(problem, orbit, "beta", 1.0)
    with pytest.raises(mg.OrbitError, match="must be in the range"):
        mg.orbits.follow(problem, orbit, "Omega", (2.0, 3.0))
    with pytest.raises(mg.OrbitError, match="a number or a range"):
        mg.orbits.follow(problem, orbit, "Omega", (1.0, 2.0, 3.0))  # type: ignore[arg-type]
    with pytest.raises(mg.OrbitError, match="no fold"):
        easy = problem.at("alpha", 1e-3)
        mg.orbits.fold(easy, orbit, lambda s: [np.cos(1.1 * s)], "Omega", 0.1)


@pytest.mark.parametrize(
    ("option", "message"),
    [
        ({"step": 0.0}, "step must be a positive number, got 0.0; the direction"),
        ({"step": -0.1}, "step must be a positive number, got -0.1; the direction"),
        ({"step": np.nan}, "step must be a positive number"),
        ({"largest": 0}, "largest must be a positive number, got 0"),
        ({"longest": -1.0}, "longest must be a positive number"),
        ({"tolerance": 0.0}, "tolerance must be a positive number"),
        ({"points": 0}, "points, .* whole number, at least 2, got 0"),
        ({"points": 2.5}, "points, .* whole number, at least 2, got 2.5"),
    ],
)
def test_options_with_which_no_step_is_made(option: dict[str, float], message: str) -> None:
    problem = mg.orbits.problem(duffing(), FORCED)
    orbit = mg.orbits.find(problem, np.zeros((2, 5)))
    with pytest.raises(mg.OrbitError, match=message):
        mg.orbits.follow(problem, orbit, "K", 0.4, **option)


def test_a_guess_that_is_no_number_is_called_so() -> None:
    problem = mg.orbits.problem(duffing(), FORCED)
    for guess in ([np.nan, 0.0], np.full((3, 5), np.inf), lambda s: np.full((2, len(s)), np.nan)):
        with pytest.raises(mg.OrbitError, match="must be finite: it holds NaN"):
            mg.orbits.find(problem, guess)
    with pytest.raises(mg.OrbitError, match="tolerance must be a positive number"):
        mg.orbits.find(problem, np.zeros((2, 5)), tolerance=0.0)
