"""Families of periodic orbits: folds and bifurcations against what is known of them."""

from __future__ import annotations

import numpy as np
import pytest
from orbit_systems import duffing, equations, mathieu_duffing, mu, t, u, van_der_pol

import mmsgen as mg


def forced(values: dict[str, float]) -> mg.orbits.PeriodicOrbit:
    problem = mg.orbits.problem(duffing(), values)
    k, speed = values["K"], values["Omega"]
    guess = k / (1 - speed**2 + 2j * values["mu"] * speed)
    return mg.orbits.find(problem, lambda s: [(guess * np.exp(1j * speed * s)).real])


def slow_folds(epsilon: float) -> np.ndarray:
    """Frequencies of the folds of (μ² + (σ − 3αa²/8)²)a² = k²/4, to order 1."""
    damping, bend, half = 0.1, 3 * 1.0 / 8, 0.8 / 2
    # σ = bx ± √(h²/x − μ²), x = a²; dσ/dx = 0 on the upper sign alone: 2b x²√(…) = h², squared.
    x = np.roots([-4 * bend**2 * damping**2, 4 * bend**2 * half**2, 0, 0, -(half**4)])
    x = x[(abs(x.imag) < 1e-12) & (x.real > 0)].real
    return np.sort(1 + epsilon * (bend * x + np.sqrt(half**2 / x - damping**2)))


def test_folds_of_the_forced_oscillator_approach_those_of_order_one() -> None:
    errors = []
    for epsilon in (1 / 256, 1 / 512):
        values = {"mu": 0.1 * epsilon, "alpha": epsilon, "K": 0.8 * epsilon}
        orbit = forced({**values, "Omega": 1 - 2 * epsilon})
        path = mg.orbits.follow(orbit.problem, orbit, "Omega", 1 + 8 * epsilon)
        assert path.reason == "reached"
        assert path.values[-1] == 1 + 8 * epsilon
        assert [s.kind for s in path.specials] == ["fold", "fold"]
        exact = np.sort([s.value for s in path.folds])
        assert max(s.error for s in path.folds) < 1e-10
        errors.append(np.abs(exact - slow_folds(epsilon)))
        # stable before, unstable between, stable after
        changes = [a != b for a, b in zip(path.verdicts, path.verdicts[1:], strict=False)]
        assert sum(changes) == 2
        assert path.verdicts[0] == path.verdicts[-1] == "stable"
    ratios = np.array(errors[:-1]) / errors[1:]
    # What order 1 leaves is ε² (1 + O(ε)); the O(ε), of some 30 ε, takes 0.15 off.
    assert ratios == pytest.approx(4, abs=0.3)


def test_at_a_fold_a_multiplier_is_one() -> None:
    orbit = forced({"mu": 0.05, "alpha": 0.1, "K": 0.3, "Omega": 0.9})
    path = mg.orbits.follow(orbit.problem, orbit, "Omega", (0.9, 1.5))
    for special in path.folds:
        # A fold that is located to e has its multiplier to √e; here e is some 1e-12.
        assert np.abs(special.orbit.multipliers - 1).min() < 1e-5
        assert special.orbit.problem.values["Omega"] == special.value


def test_a_fold_is_found_from_a_guess() -> None:
    # What the path finds, from a rough guess by the slow flow: fundamental and phase alone.
    values = {"mu": 0.05, "alpha": 0.1, "K": 0.3, "Omega": 0.9}
    orbit = forced(values)
    for known in mg.orbits.follow(orbit.problem, orbit, "Omega", 1.5).folds:
        (c,) = known.orbit.harmonics([1])[:1, 0]
        speed = known.value + 0.01
        found = mg.orbits.fold(
            orbit.problem.at("Omega", speed),
            lambda s, c=c, w=speed: [1.9 * (c * np.exp(1j * w * s)).real],
            lambda s, c=c, w=speed: [(c * np.exp(1j * w * s)).real],
            "Omega",
            0.2,
        )
        assert abs(found.value - known.value) < 1e-10 + known.error + found.error


def test_neimark_sacker_where_the_damping_vanishes() -> None:
    # Liouville: the product of a complex pair is e^{-2μT}, which is 1 at μ = 0 and nowhere else.
    orbit = forced({"mu": 0.05, "alpha": 0.1, "K": 0.2, "Omega": 0.6})
    path = mg.orbits.follow(orbit.problem, orbit, "mu", -0.05)
    (special,) = path.specials
    assert special.kind == "Neimark-Sacker"
    assert abs(special.value) < 1e-11
    assert path.verdicts[0] == "stable"
    assert path.verdicts[-1] == "unstable"


@pytest.mark.parametrize(("periods", "kind"), [(1, "period doubling"), (2, "branch point")])
def test_the_rest_of_a_parametric_oscillator_loses_stability(periods: int, kind: str) -> None:
    # At the edges of the principal zone a multiplier is −1 after one period, 1 after two. Floquet
    # theory of the linear equations gives the edges by another method.
    values = {"mu": 0.02, "f": 0.1, "alpha": 0.3}
    known = mg.floquet.boundary(mathieu_duffing(), values, "Omega", (1.8, 2.2), points=41)
    problem = mg.orbits.problem(mathieu_duffing(), {**values, "Omega": 1.8})
    rest = mg.orbits.find(problem, np.zeros((2, 3)), periods=periods)
    path = mg.orbits.follow(problem, rest, "Omega", 2.2)
    assert [s.kind for s in path.specials] == [kind, kind]
    edges = [s.value for s in path.specials]
    assert edges == pytest.approx(known.zones[0], abs=1e-8 + float(np.max(known.error)))


def test_cycles_are_followed_with_their_period() -> None:
    # Two ways to μ = 1 agree.
    problem = mg.orbits.problem(van_der_pol(), {"mu": 0.5})
    guess, period = mg.orbits.settle(problem, [2.0, 0.0], 20.0)
    path = mg.orbits.follow(problem, mg.orbits.find(problem, guess, period), "mu", 1.0)
    other = problem.at("mu", 1.0)
    direct = mg.orbits.find(other, *mg.orbits.settle(other, [2.0, 0.0], 20.0))
    last = path.orbits[-1]
    assert abs(last.period - direct.period) < 10 * (last.period_error + direct.period_error)
    assert not path.specials


def test_a_path_ends_early_when_asked_to() -> None:
    orbit = forced({"mu": 0.05, "alpha": 0.1, "K": 0.3, "Omega": 0.5})
    seen: list[float] = []

    def told(_: mg.orbits.PeriodicOrbit, value: float) -> bool:
        seen.append(value)
        return len(seen) < 3

    path = mg.orbits.follow(orbit.problem, orbit, "Omega", 2.0, progress=told)
    assert path.reason == "interrupted"
    assert seen == list(path.values[1:])

    def interrupted(_: mg.orbits.PeriodicOrbit, value: float) -> None:
        raise KeyboardInterrupt

    path = mg.orbits.follow(orbit.problem, orbit, "Omega", 2.0, progress=interrupted)
    assert (path.reason, len(path.orbits)) == ("interrupted", 2)
    path = mg.orbits.follow(orbit.problem, orbit, "Omega", 2.0, points=4)
    assert (path.reason, len(path.orbits)) == ("points", 4)


def test_an_isola_closes() -> None:
    # The subharmonic of order 1/3 of a damped system exists in an interval of the frequency: its
    # amplitudes form a closed curve (Nayfeh & Mook, 1979, ch. 4).
    values = {"mu": 0.03, "alpha": 0.05, "K": 8.0, "Omega": 3.5}
    problem = mg.orbits.problem(duffing(), values)
    force = 8 / (1 - 3.5**2)
    starts = (
        lambda s, g=g: [3.3 * np.cos(3.5 * s / 3 + g) + force * np.cos(3.5 * s)]
        for g in np.linspace(0, 2 * np.pi, 7)
    )
    for start in starts:
        try:
            orbit = mg.orbits.find(problem, start, periods=3)
        except mg.OrbitError:
            continue
        if orbit.amplitude() > 0.5:
            break
    path = mg.orbits.follow(problem, orbit, "Omega", (3.0, 8.0))
    assert path.reason == "closed"
    assert len(path.folds) == 2


def test_a_forced_motion_is_followed_through_rest() -> None:
    # −K is K half a period later: the path beyond rest is the one before it, and has no specials.
    orbit = forced({"mu": 0.05, "alpha": 0.1, "K": 0.05, "Omega": 1.1})
    path = mg.orbits.follow(orbit.problem, orbit, "K", -0.05)
    assert (path.reason, path.specials) == ("reached", ())
    first, last = path.orbits[0], path.orbits[-1]
    half = np.asarray(first(first.times + first.period / 2))
    assert np.abs(last.states - half).max() < 2 * (first.error + last.error).max()
    # Steps go on where the motion is small: none of the many that a step measured by a vanishing
    # motion would take. Orbits shrink by some 0.7 a step to a thousandth, and grow again.
    sizes = path.amplitude()
    assert 0 < sizes.min() < 1e-3 * sizes.max()
    assert len(path.orbits) < 2 * np.log(1e-3) / np.log(0.7) + 40


def test_a_family_that_shrinks_to_a_point_says_so() -> None:
    # u'' − (μ − u²)u' + u = 0: the cycle, of amplitude 2√μ(1 + O(μ)), begins at μ = 0.
    left = u.diff(t, 2) - (mu - u**2) * u.diff(t) + u
    problem = mg.orbits.problem(equations([left], [u]), {"mu": 0.1})
    orbit = mg.orbits.find(problem, lambda s: [0.6 * np.cos(s)], 6.28)
    path = mg.orbits.follow(problem, orbit, "mu", -0.1)
    assert path.reason == "rest"
    assert path.orbits[-1].amplitude() < 1e-3 * orbit.amplitude()
    # the last value is that of the amplitude, up to the errors of the states, 1e-10 of 0.6
    assert path.values[-1] == pytest.approx((path.orbits[-1].amplitude() / 2) ** 2, rel=1e-4)
