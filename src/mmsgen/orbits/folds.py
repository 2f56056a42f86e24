"""`fold`: where a family of periodic orbits turns round in a parameter, from a guess near it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from ..errors import OrbitError
from .collocation import Setting
from .curves import Curve, scale_of
from .fields import Problem
from .finding import TOLERANCE, Guess, curve_of, resolved
from .following import Point, corrected, tangent_of, unit_of
from .specials import Special

__all__ = ["fold"]

STEPS = 20
"""Steps of the secant method at most; five are usual."""

FIRST_STEP = 0.01
"""Along the family, where the size of the motion and the unit of the parameter are 1."""

LEVEL = 1e-9
"""The tangent's part along the parameter that counts as none; the value errs by its square."""


def fold(
    problem: Problem,
    guess: Guess,
    along: Guess,
    parameter: Any,
    unit: float,
    *,
    period: float | None = None,
    periods: int = 1,
    tolerance: float = TOLERANCE,
) -> Special:
    """Locate a fold of a family of periodic orbits near a guess.

    Parameters
    ----------
    problem : Problem
        At a value of the parameter near the fold, where there need not be an orbit.
    guess : callable or array_like
        As for `find`: the orbit at the fold, roughly.
    along : callable or array_like
        Likewise: how the orbits of the family differ there, of any size.
    parameter : str or sympy.Symbol
        The one that turns round.
    unit : float
        By which its changes are measured, such as the width of the resonance.
    period : float, optional
        Of an autonomous system, roughly.
    periods : int
        Of the excitation, in one of the orbit.
    tolerance : float
        As for `find`.

    Returns
    -------
    Special

    Raises
    ------
    OrbitError
        If there is none near the guess.
    """
    name = parameter if isinstance(parameter, str) else str(getattr(parameter, "name", parameter))
    problem.require(name)
    start = replace(curve_of(problem, guess, period, periods), value=problem.values[name])
    way = replace(curve_of(problem, along, period, periods), frequency=0.0)
    setting = Setting(problem, periods, scale_of(start), name, None, unit)
    setting = replace(setting, tangent=unit_of(setting, way))
    try:
        found = _turning(setting, start, tolerance)
    except OrbitError:
        found = None
    if found is None:
        raise OrbitError(f"no fold in {name} is found near {problem.values[name]:.6g}")
    return found


def _turning(setting: Setting, start: Curve, tolerance: float) -> Special | None:
    """Where the tangent has no part along the parameter, by the secant method."""
    unit = setting.unit
    first = resolved(setting, start, tolerance)
    last = Point(first, tangent_of(first.setting, first.curve))
    point, here, level = last, 0.0, last.tangent.value / unit
    there = FIRST_STEP
    free = replace(setting, scale=np.zeros_like(setting.scale))  # measured by the motion alone
    for _ in range(STEPS):
        if abs(level) < LEVEL:
            orbit = point.solved.orbit()
            return Special("fold", point.value, point.solved.value_error, orbit)
        point = corrected(free, last, there, tolerance)
        new = point.tangent.value / unit
        if new == level:
            break
        step = -new * (there - here) / (new - level)
        here, there, level = there, there + float(np.clip(step, -1.0, 1.0)), new
    return None
