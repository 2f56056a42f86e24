"""`find`: the periodic orbit near a guess, refined until two resolutions agree."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from numbers import Real
from typing import Any, TypeAlias

import numpy as np
import scipy  # loads its subpackages when they are first used

from ..errors import OrbitError
from ..floquet.points import Floats
from .collocation import Linearised, Setting, newton
from .curves import Curve, sampled, scale_of, table_for
from .fields import Problem
from .records import PeriodicOrbit, orbit_of

__all__ = ["Guess", "Resolved", "curve_of", "find", "resolved", "settle"]

Guess: TypeAlias = Callable[[Floats], Any] | PeriodicOrbit | Any

FIRST = 8
"""Intervals of the first resolution."""

LAST = 256
"""Intervals at most."""

TOLERANCE = 1e-10

RTOL = 1e-6
"""Tolerance of integrations, which only make guesses."""

STILL = 1e-4
"""Rates below this, over those of a motion of that size, are what integration leaves of rest."""

NEAR = 0.2
"""A motion has come back where it is this near, over its extent."""

AGREE = 0.5
"""Where two differences do not fall by this much they are rounding."""


@dataclass(frozen=True, eq=False)
class Resolved:
    """A solution on two resolutions.

    Attributes
    ----------
    setting : Setting
    curve : Curve
        The finer one.
    pair : tuple of Linearised
    errors : tuple
        Of the states (d,), and of the frequency, relative.
    value_error : float
        Of the parameter that is followed.
    gap : float
        Largest error of a state, over its size.
    """

    setting: Setting
    curve: Curve
    pair: tuple[Linearised, Linearised]
    errors: tuple[Floats, float]
    value_error: float
    gap: float

    def orbit(self) -> PeriodicOrbit:
        """The record of it."""
        own = self.setting.of(self.curve.value)
        period = 2 * np.pi / self.curve.frequency
        errors = self.errors[0], self.errors[1] * period if self.setting.free else 0.0
        return orbit_of(
            own, self.setting.periods, self.curve, self.pair, self.setting.scale, errors
        )


def resolved(setting: Setting, guess: Curve, tolerance: float = TOLERANCE) -> Resolved:
    """Solve on finer and finer intervals until two solutions agree to the tolerance.

    Their difference, at all times, is the error of the coarser one; that of the finer one, which
    is returned, is smaller.

    Raises
    ------
    OrbitError
        If Newton's method does not converge.
    """
    coarse, first, noise = newton(_on(setting, guess.intervals), guess)
    last = np.inf
    while True:
        own = _on(setting, 2 * coarse.intervals)
        fine, second, noise = newton(own, coarse.refined(2 * coarse.intervals))
        difference = np.abs(fine.states - coarse.refined(fine.intervals).states).max(axis=(0, 1))
        gap = float((difference / setting.scale).max())
        turn = abs(fine.frequency / coarse.frequency - 1)
        if max(gap, turn) <= tolerance or gap > AGREE * last < 1e-6 or 2 * fine.intervals > LAST:
            break
        coarse, first, last = fine, second, gap
    # The last step of Newton's method is rounding, as the inverse of the equations enlarges it.
    states = difference + 4 * noise * setting.scale
    errors = states, turn + 4 * noise
    value_error = abs(fine.value - coarse.value) + 4 * noise * setting.unit
    return Resolved(own, fine, (first, second), errors, value_error, gap + 4 * noise)


def _on(setting: Setting, intervals: int) -> Setting:
    """The setting with its tangent on a number of intervals."""
    if setting.tangent is None or setting.tangent.intervals == intervals:
        return setting
    return replace(setting, tangent=setting.tangent.refined(intervals))


def find(
    problem: Problem,
    guess: Guess,
    period: float | None = None,
    *,
    periods: int = 1,
    tolerance: float = TOLERANCE,
    isolated: bool = True,
) -> PeriodicOrbit:
    """Find the periodic orbit near a guess.

    Parameters
    ----------
    problem : Problem
        From `problem` or `autonomous`.
    guess : callable, array_like or PeriodicOrbit
        A function of times (m,) that returns states (d, m), or coordinates alone (n, m); states
        (d, m) at equidistant times over one period, m odd or even; one state (d,), from which the
        equations are integrated over a period; or an orbit.
    period : float, optional
        Of an autonomous system: a guess of T in s. Not needed with an orbit. With an excitation it
        follows from the equations.
    periods : int
        Periods of the excitation in one of the orbit: 3 for a subharmonic of order 1/3.
    tolerance : float
        Difference of two resolutions, over the size of each state, from which the finer one is
        taken. The errors that were reached stand in the result.
    isolated : bool
        False where orbits come in families, as in a conservative system: the member nearest to the
        guess is found then.

    Returns
    -------
    PeriodicOrbit

    Raises
    ------
    OrbitError
        If none is found, or orbits are not isolated, as in a conservative system.
    """
    if not (isinstance(tolerance, Real) and 0 < tolerance < np.inf):
        raise OrbitError(f"tolerance must be a positive number, got {tolerance!r}")
    start = curve_of(problem, guess, period, periods)
    last: OrbitError | None = None
    for _ in range(3):
        try:
            setting = Setting(problem, periods, scale_of(start), isolated=isolated)
            return resolved(setting, start, tolerance).orbit()
        except OrbitError as error:
            last = error
            start = start.refined(2 * start.intervals)
    raise last if last is not None else OrbitError("no periodic orbit is found")


def curve_of(problem: Problem, guess: Guess, period: float | None, periods: int) -> Curve:
    """The guess on the first resolution, see `find`."""
    if not isinstance(problem, Problem):
        raise OrbitError(
            f"a problem is needed, got {problem!r}: mg.orbits.problem(eom, values) makes one"
        )
    if not (isinstance(periods, int) and periods >= 1):
        raise OrbitError(f"periods must be a whole number, at least 1, got {periods!r}")
    return _start(problem, guess, _frequency(problem, guess, period, periods))


def _frequency(problem: Problem, guess: Guess, period: float | None, periods: int) -> float:
    base = problem.base
    if base is not None:
        if not base > 0:
            raise OrbitError(f"the frequency of the excitation must be positive, got {base}")
        own = base / periods
        if period is not None and abs(period * own / (2 * np.pi) - 1) > 1e-9:
            raise OrbitError(
                f"the excitation repeats after {2 * np.pi / base:.6g} s, not {period:.6g} s: "
                "leave the period out, or give periods=, how many of them the orbit takes"
            )
        return own
    if periods != 1:
        raise OrbitError("without an excitation there are no periods of it to be counted")
    if isinstance(guess, PeriodicOrbit) and period is None:
        period = guess.period
    if period is None or not (np.isfinite(period) and period > 0):
        raise OrbitError(f"an autonomous system needs a positive guess of the period, got {period}")
    return 2 * np.pi / period


def _start(problem: Problem, guess: Guess, frequency: float) -> Curve:
    """The guess on the first resolution."""
    table = table_for(problem.size)
    if isinstance(guess, PeriodicOrbit):
        if guess.problem.size != problem.size:
            raise OrbitError("the orbit to begin with is one of another system")
        own = guess.curve.refined(max(FIRST, guess.curve.intervals // 2))
        return replace(own, frequency=frequency)
    if callable(guess):
        function = _states_of(problem, guess, frequency)
    else:
        function = _interpolated(problem, np.asarray(guess, dtype=float), frequency)
    return sampled(function, FIRST, table, frequency)


def _states_of(
    problem: Problem, guess: Callable[[Floats], Any], frequency: float
) -> Callable[[Floats], Floats]:
    """States by phase from a function of time; velocities as differences where it gives none."""
    n, d = problem.coordinates, problem.size

    def function(phase: Floats) -> Floats:
        t = phase / frequency
        states = np.atleast_2d(np.asarray(guess(t), dtype=float))
        if states.shape == (n, len(t)) and n < d:
            step = 1e-5 / frequency
            ahead, behind = (np.atleast_2d(guess(t + x)) for x in (step, -step))
            states = np.concatenate([states, (ahead - behind) / (2 * step)])
        if states.shape != (d, len(t)):
            raise OrbitError(
                f"the guess must give states of shape ({d}, times), got {states.shape}"
            )
        _finite(states)
        return states.T

    return function


def _interpolated(
    problem: Problem, samples: Floats, frequency: float
) -> Callable[[Floats], Floats]:
    """States by phase from equidistant ones, by their trigonometric polynomial."""
    d = problem.size
    _finite(samples)
    if samples.shape == (d,):
        period = 2 * np.pi / frequency
        times = np.linspace(0.0, period, 65)[:-1]
        samples = _integrated(problem, samples, times, times[-1])
    if samples.ndim != 2 or len(samples) != d or samples.shape[1] < 3:
        raise OrbitError(
            f"the guess must hold {d} states at three or more times, got shape {samples.shape}"
        )
    m = samples.shape[1]
    series = np.fft.rfft(samples, axis=1) / m
    weights = np.full(series.shape[1], 2.0)
    weights[0] = 1.0
    if m % 2 == 0:
        weights[-1] = 1.0
    numbers = np.arange(series.shape[1])

    def function(phase: Floats) -> Floats:
        waves = np.exp(1j * np.multiply.outer(phase, numbers)) * weights
        return np.asarray((waves @ series.T).real)

    return function


def _finite(states: Floats) -> None:
    """Refuse a guess with NaN or infinity among its states."""
    if not np.isfinite(states).all():
        raise OrbitError("the guess must be finite: it holds NaN or infinity")


def _integrated(problem: Problem, start: Floats, times: Any, end: float) -> Floats:
    """States (d, m) of the equations from a state at t = 0."""
    solution = scipy.integrate.solve_ivp(
        _derivative(problem), (0.0, end), start, "DOP853", times, rtol=RTOL, atol=RTOL
    )
    if not solution.success:
        raise OrbitError(f"the equations cannot be integrated: {solution.message}")
    return np.asarray(solution.y)


def _derivative(problem: Problem) -> Callable[[float, Floats], Floats]:
    """The equations as SciPy wants them."""
    base = problem.base or 0.0

    def derivative(t: float, y: Floats) -> Floats:
        return problem.rates(np.array([base * t]), y[:, None])[0][0]

    return derivative


def settle(problem: Problem, start: Any, time: float) -> tuple[Floats, float]:
    """A guess of an attracting orbit of an autonomous system, by integration.

    Parameters
    ----------
    problem : Problem
        Autonomous.
    start : array_like, shape (d,)
    time : float
        After which transients are expected to be gone, in s.

    Returns
    -------
    states : numpy.ndarray, shape (d, m)
        Over one period.
    period : float

    Raises
    ------
    OrbitError
        If the motion does not come back to where it is after that time.
    """
    if problem.base is not None:
        raise OrbitError("with an excitation the period is known: use find")
    y = np.asarray(start, dtype=float)
    if y.shape != (problem.size,) or not np.isfinite(y).all():
        raise OrbitError(f"the start must be one state of {problem.size} numbers")
    here = _integrated(problem, y, np.array([time]), time)[:, -1]
    rates, jacobians = problem.rates(np.zeros(1), here[:, None])
    along, speed = rates[0], float(np.linalg.norm(jacobians[0], 2))
    if not np.linalg.norm(along) > STILL * speed * np.linalg.norm(here):
        raise OrbitError("the motion comes to rest: there is no cycle to be found from here")
    period = _return_time(problem, here, along, time)
    even = period / 128 * np.arange(128)
    return _integrated(problem, here, even, even[-1]), period


def _return_time(problem: Problem, here: Floats, along: Floats, time: float) -> float:
    """When the motion crosses the plane across it again, near where it began."""
    solver = scipy.integrate.DOP853(_derivative(problem), 0.0, here, time, rtol=RTOL, atol=RTOL)
    side, size = 0.0, 0.0

    def crossing(t: float) -> float:
        return float(along @ (piece(t) - here))

    while solver.status == "running":
        solver.step()
        gap = float(np.linalg.norm(solver.y - here))
        size, last, side = max(size, gap), side, float(along @ (solver.y - here))
        if last < 0 <= side:
            piece = solver.dense_output()
            found = float(scipy.optimize.brentq(crossing, solver.t_old, solver.t))
            if np.linalg.norm(piece(found) - here) < NEAR * size:
                return found
    raise OrbitError(
        "the motion does not come back to where it is after that time: give a longer one, or "
        "another start"
    )
