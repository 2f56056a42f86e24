"""`follow`: a family of periodic orbits along a parameter, through folds.

A step goes along the tangent of the family, and Newton's method comes back to it at right angles to
that tangent, the parameter being one of its unknowns (Keller's pseudo-arclength continuation). At a
fold the parameter turns round, which is nothing special for such a step.

Sources: Keller, in *Applications of Bifurcation Theory* (1977) 359; Seydel, *Practical Bifurcation
and Stability Analysis* (1994), ch. 4 and 5.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from numbers import Real
from typing import Any

import numpy as np

from ..errors import OrbitError
from ..floquet.points import Floats
from .collocation import Setting, linearise
from .curves import REST, Curve, scale_of
from .finding import TOLERANCE, Resolved, resolved
from .records import PeriodicOrbit
from .specials import Special, located, tests

__all__ = ["Path", "Point", "follow"]

BENDING = 0.9
"""Cosine between neighbouring tangents below which a step is repeated at half the length."""

STRAIGHT = 0.98
"""Cosine above which the next step is longer."""

LONGER = 1.6

COARSE = 1e-5
"""Error of the states, over their size, from which an orbit does not count as found."""

SHORTEST = 1e-3
"""Shortest step, over the first one."""

FAINT = 1e-3
"""Size of a motion, over the largest on its path, below which steps are measured by that one: so
that a forced motion passes through rest. An autonomous one has no phase there, and the path ends.
"""


@dataclass(frozen=True, eq=False)
class Point:
    """One orbit of a family, with the tangent of the family there.

    Attributes
    ----------
    solved : Resolved
    tangent : Curve
        Of unit length.
    """

    solved: Resolved
    tangent: Curve

    @property
    def value(self) -> float:
        """Of the parameter."""
        return self.solved.curve.value


@dataclass(frozen=True, eq=False)
class Path:
    """A family of periodic orbits, in the order along it.

    Attributes
    ----------
    parameter : str
    orbits : tuple of PeriodicOrbit
    values : numpy.ndarray, shape (m,)
        Of the parameter, for each orbit.
    specials : tuple of Special
        Folds and bifurcations on the way.
    reason : str
        Why it ends: ``"reached"`` the value asked for, ``"left"`` the range at its other end,
        ``"closed"`` upon itself, ``"interrupted"``, ``"points"`` are as many as were allowed,
        ``"long"``, because the period became as long as was allowed (as it does near a homoclinic
        orbit), ``"rest"``, because the motion of an autonomous system shrinks to a point, which has
        no period, or ``"stuck"``, because no step is short enough or no mesh fine enough.
    """

    parameter: str
    orbits: tuple[PeriodicOrbit, ...]
    values: Floats
    specials: tuple[Special, ...]
    reason: str

    @property
    def folds(self) -> tuple[Special, ...]:
        """The folds among the specials."""
        return tuple(s for s in self.specials if s.kind == "fold")

    @property
    def growth(self) -> Floats:
        """Largest real part of the exponents of each orbit, 1/s."""
        return np.array([o.growth for o in self.orbits])

    @property
    def verdicts(self) -> tuple[str, ...]:
        """The verdict on each orbit."""
        return tuple(o.verdict for o in self.orbits)

    def amplitude(self, coordinate: int = 0, number: int = 1) -> Floats:
        """Amplitude of one harmonic of one state, for each orbit."""
        return np.array([o.amplitude(coordinate, number) for o in self.orbits])


@dataclass
class _Walk:
    """What the loop of `follow` carries along."""

    setting: Setting
    low: float
    high: float
    tolerance: float
    points: list[Point]
    specials: list[Special]

    @property
    def faint(self) -> bool:
        """Whether an autonomous motion has shrunk to a point, compared with what it was."""
        own = scale_of(self.points[-1].solved.curve)
        return self.setting.free and bool((own <= self.setting.scale).all())

    def note(self, new: Point) -> None:
        """Take a point; the setting's scale is the least that steps are measured by."""
        self.points.append(new)
        least = np.maximum(self.setting.scale, FAINT * extent_of(new))
        self.setting = replace(self.setting, scale=least)

    def step(self, length: float) -> Point | None:
        """The next point, or None where the step is too long."""
        last = self.points[-1]
        try:
            new = corrected(self.setting, last, length, self.tolerance)
        except OrbitError:
            return None
        setting = new.solved.setting
        if new.solved.gap > COARSE:
            return None
        bent = cosine(setting, last.tangent, new.tangent)
        away = moved_by(setting, last.solved.curve, new.solved.curve)
        return new if bent > BENDING and away < 1.5 * length else None

    def look(self, new: Point, length: float) -> None:
        """Note what lies between the last point and a new one."""
        last = self.points[-1]

        def between(share: float) -> Point:
            return corrected(self.setting, last, share, self.tolerance)

        self.specials += located(between, tests(last), tests(new), length)


def follow(
    problem: Any,
    orbit: PeriodicOrbit,
    parameter: Any,
    until: float | tuple[float, float],
    step: float = 0.05,
    *,
    largest: float = 0.2,
    points: int = 400,
    longest: float = np.inf,
    tolerance: float = TOLERANCE,
    progress: Callable[[PeriodicOrbit, float], Any] | None = None,
) -> Path:
    """Follow a periodic orbit along one parameter.

    Parameters
    ----------
    problem : Problem
        That of the orbit.
    orbit : PeriodicOrbit
        To begin with.
    parameter : str or sympy.Symbol
        What is varied.
    until : float or tuple of float
        Its last value; or the two ends of the range that the path may not leave, the one that it
        heads for at first being the first.
    step, largest : float
        First and largest step, where the range and the size of the motion are 1. The direction is
        that of `until`.
    points : int
        Orbits at most, the one to begin with among them; at least two.
    longest : float
        Period in s after which the path ends.
    tolerance : float
        As for `find`.
    progress : callable, optional
        Called with every orbit and its value. An interrupt (Ctrl-C) ends the path with what has
        been found, and so does a return value that is False.

    Returns
    -------
    Path

    Raises
    ------
    OrbitError
        If the parameter is unknown, the orbit is no solution of the problem, or an option is not a
        positive number.
    """
    _checked(points, step=step, largest=largest, longest=longest, tolerance=tolerance)
    name = parameter if isinstance(parameter, str) else str(getattr(parameter, "name", parameter))
    problem.require(name)
    start = problem.values[name]
    low, high, sign = _range(start, until)
    walk = _begun(problem, orbit, name, (low, high), sign, tolerance)
    orbits = [walk.points[0].solved.orbit()]
    length, reason = step, ""
    try:
        while len(walk.points) < points:
            new = walk.step(length)
            if new is None:
                length /= 2
                if length < SHORTEST * step:
                    reason = "stuck"
                    break
                continue
            walk.look(new, length)
            outside = not low <= new.value <= high
            if outside:
                end = high if new.value > high else low
                new = _ending(walk, new, end)
                reason = "reached" if end != start else "left"
            walk.note(new)
            orbits.append(new.solved.orbit())
            told = progress(orbits[-1], new.value) if progress else None
            reason = reason if outside else _stop(walk, length, told, longest)
            if reason:
                break
            length = _next(walk, length, largest)
    except KeyboardInterrupt:
        reason = "interrupted"
    found = len(orbits)
    values = np.array([p.value for p in walk.points[:found]])
    return Path(name, tuple(orbits), values, tuple(walk.specials), reason or "points")


def _checked(points: Any, **positive: Any) -> None:
    """Refuse options with which no step is made."""
    for name, value in positive.items():
        number = isinstance(value, Real) and not isinstance(value, bool)
        # the period alone may be without limit
        if not (number and value > 0 and (value < np.inf or name == "longest")):
            raise OrbitError(
                f"{name} must be a positive number, got {value!r}"
                + ("; the direction is that of until" if name == "step" else "")
            )
    if not (isinstance(points, int | np.integer) and points >= 2):
        raise OrbitError(
            "points, the largest number of orbits with the first among them, must be a whole "
            f"number, at least 2, got {points!r}"
        )


def extent_of(point: Point) -> Floats:
    """The size of each state, zeros for rest."""
    curve = point.solved.curve
    return scale_of(curve) if np.abs(curve.states).max() > REST else np.zeros(curve.states.shape[2])


def _stop(walk: _Walk, length: float, told: Any, longest: float) -> str:
    """Why the path ends here, empty where it goes on."""
    if told is False:
        return "interrupted"
    if 2 * np.pi / walk.points[-1].solved.curve.frequency > longest:
        return "long"
    if walk.faint:
        return "rest"
    return "closed" if _closed(walk, length) else ""


def _range(start: float, until: float | tuple[float, float]) -> tuple[float, float, float]:
    """Low and high end, and the direction in which to begin."""
    ends = [float(x) for x in np.ravel(np.asarray(until, dtype=float))]
    if len(ends) not in (1, 2) or not np.isfinite(ends).all():
        raise OrbitError(f"until must be a number or a range of two, got {until!r}")
    if len(ends) == 1:
        ends.append(start)
    low, high = min(ends), max(ends)
    if not (low < high and low <= start <= high):
        raise OrbitError(
            f"the orbit has the value {start:.6g}, which must be in the range {low:.6g} … "
            f"{high:.6g} and not all of it"
        )
    target = ends[0] if ends[0] != start else ends[1]
    return low, high, 1.0 if target > start else -1.0


def _begun(
    problem: Any,
    orbit: PeriodicOrbit,
    name: str,
    ends: tuple[float, float],
    sign: float,
    tolerance: float,
) -> _Walk:
    """The first point, with its tangent in the direction asked for."""
    start = problem.values[name]
    guess = replace(orbit.curve.refined(max(8, orbit.curve.intervals // 2)), value=start)
    fixed = resolved(Setting(problem, orbit.periods, scale_of(guess)), guess, tolerance)
    zero = np.zeros_like(fixed.curve.starts), np.zeros_like(fixed.curve.slopes)
    unit = ends[1] - ends[0]
    setting = replace(
        fixed.setting, parameter=name, unit=unit, tangent=Curve(*zero, 0.0, sign * unit)
    )
    curve = replace(fixed.curve, value=start)
    tangent = tangent_of(setting, curve)
    solved = replace(fixed, setting=replace(setting, tangent=tangent), curve=curve)
    walk = _Walk(replace(setting, scale=np.zeros_like(setting.scale)), *ends, tolerance, [], [])
    walk.note(Point(solved, tangent))
    return walk


def tangent_of(setting: Setting, curve: Curve) -> Curve:
    """The unit tangent of the family at a solution, on the side of the setting's."""
    linearised = linearise(setting, curve)
    right = np.zeros_like(linearised.right)
    right[-1] = 1.0
    return unit_of(setting, linearised.change(right))


def unit_of(setting: Setting, change: Curve) -> Curve:
    """A change of unit length."""
    zero = change.moved(change, -1.0)
    return zero.moved(change, 1.0 / np.sqrt(setting.product(change, change)))


def cosine(setting: Setting, a: Curve, b: Curve) -> float:
    """Cosine of the angle between two changes, the first on other intervals perhaps."""
    first = a.refined(b.intervals)
    size = setting.product(first, first) * setting.product(b, b)
    return setting.product(first, b) / float(np.sqrt(size))


def corrected(setting: Setting, last: Point, length: float, tolerance: float) -> Point:
    """The orbit at a distance along the tangent of the last one.

    Distances are measured by the motion, and no less than by the scale of the setting.
    """
    base = last.solved.curve
    scale = np.maximum(scale_of(base), setting.scale)
    own = replace(setting, scale=scale)
    tangent = unit_of(own, last.tangent)
    half = max(8, base.intervals // 2)
    guess = base.moved(tangent, length).refined(half)
    solved = resolved(replace(own, tangent=tangent.refined(half)), guess, tolerance)
    return Point(solved, tangent_of(solved.setting, solved.curve))


def moved_by(setting: Setting, a: Curve, b: Curve) -> float:
    """Distance of two curves."""
    change = b.moved(a.refined(b.intervals), -1.0)
    return float(np.sqrt(setting.product(change, change)))


def _next(walk: _Walk, length: float, largest: float) -> float:
    """The length of the next step."""
    new, old = walk.points[-1], walk.points[-2]
    bent = cosine(new.solved.setting, old.tangent, new.tangent)
    return min(largest, LONGER * length) if bent > STRAIGHT else length


def _ending(walk: _Walk, beyond: Point, end: float) -> Point:
    """The orbit at the end of the range, between the last one and one beyond."""
    last = walk.points[-1]
    first, second = last.solved.curve.refined(beyond.solved.curve.intervals), beyond.solved.curve
    share = (end - first.value) / (second.value - first.value)
    guess = replace(first.moved(second.moved(first, -1.0), share), value=end)
    own = beyond.solved.setting
    fixed = replace(own, problem=own.of(end), parameter=None, tangent=None)
    coarse = guess.refined(max(8, guess.intervals // 2))
    solved = resolved(fixed, coarse, walk.tolerance)
    solved = replace(solved, setting=replace(own, tangent=None), value_error=0.0)
    solved = replace(solved, curve=replace(solved.curve, value=end))
    return Point(solved, beyond.tangent)


def _closed(walk: _Walk, length: float) -> bool:
    """Whether the path has come back to its beginning."""
    if len(walk.points) < 4:
        return False
    first, last = walk.points[0].solved, walk.points[-1].solved
    if moved_by(last.setting, first.curve, last.curve) > length:
        return False
    return cosine(last.setting, walk.points[0].tangent, walk.points[-1].tangent) > 0
