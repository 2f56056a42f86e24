"""`crossing`: where a multiplier of a family of orbits crosses the unit circle, near a guess."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..errors import OrbitError
from .fields import Problem
from .finding import TOLERANCE, Guess, find
from .records import PeriodicOrbit
from .specials import ON_CIRCLE, Special

__all__ = ["crossing"]

STEPS = 20
"""Steps of the secant method at most; five are usual."""

FIRST_STEP = 1e-3
"""Change of the parameter from which the first slope is taken, in its unit."""

LEVEL = 1e-13
"""Change of the parameter, in its unit, that is rounding."""


def crossing(
    problem: Problem,
    guess: Guess,
    multiplier: complex,
    parameter: Any,
    unit: float,
    *,
    period: float | None = None,
    periods: int = 1,
    tolerance: float = TOLERANCE,
) -> Special:
    """Locate where one multiplier of a family of periodic orbits crosses the unit circle.

    The family must go on through that point, as it does where a period doubles, where a pair of
    multipliers crosses, and where orbits lose a symmetry that those of the family have.

    Parameters
    ----------
    problem : Problem
        At a value of the parameter near the point.
    guess : callable, array_like or PeriodicOrbit
        As for `find`: the orbit there, roughly.
    multiplier : complex
        The one that crosses, roughly.
    parameter : str or sympy.Symbol
        The one that varies.
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
        ``"Neimark-Sacker"``, or with a real multiplier ``"period doubling"`` or ``"branch point"``.

    Raises
    ------
    OrbitError
        If there is none near the guess.
    """
    name = parameter if isinstance(parameter, str) else str(getattr(parameter, "name", parameter))
    problem.require(name)
    first = problem.values[name]

    def at(value: float, near: Guess, own: complex) -> tuple[PeriodicOrbit, complex, float, float]:
        """The orbit, its multiplier nearest to one, the growth rate of this and its error."""
        known = period if not isinstance(near, PeriodicOrbit) else None
        orbit = find(problem.at(name, value), near, known, periods=periods, tolerance=tolerance)
        j = int(np.argmin(np.abs(orbit.multipliers - own)))
        found = complex(orbit.multipliers[j])
        growth = float(np.log(abs(found))) / orbit.period
        return orbit, found, growth, float(orbit.multiplier_errors[j]) / orbit.period

    orbit, own, growth, error = at(first, guess, multiplier)
    here, there = first, first + FIRST_STEP * unit
    for _ in range(STEPS):
        orbit, own, new, error = at(there, orbit, own)
        if new == growth:
            break
        slope = (new - growth) / (there - here)
        step = float(np.clip(-new / slope, -unit, unit))
        if abs(step) < LEVEL * unit or abs(new) <= error:
            return Special(_kind(own), there, (error + abs(new)) / abs(slope), orbit)
        here, there, growth = there, there + step, new
    raise OrbitError(f"no multiplier is found to cross the unit circle near {name} = {first:.6g}")


def _kind(multiplier: complex) -> str:
    """What happens where a multiplier crosses."""
    if abs(multiplier.imag) > ON_CIRCLE:
        return "Neimark-Sacker"
    return "period doubling" if multiplier.real < 0 else "branch point"
