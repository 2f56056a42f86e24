"""`born`: the small cycle beside an equilibrium of an autonomous system that loses its stability.

At a Hopf point a pair of eigenvalues ±iω crosses the imaginary axis, and cycles of frequency ω grow
out of the equilibrium like the square root of the distance. For a cycle of given size the parameter
is an unknown, so that it does not matter on which side of the point the cycles are.

Source: Kuznetsov, *Elements of Applied Bifurcation Theory* (2004), ch. 3 and 10.2.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import scipy  # loads its subpackages when they are first used

from ..errors import OrbitError
from ..floquet.points import Floats
from .collocation import Setting
from .curves import sampled, table_for
from .fields import Problem
from .finding import FIRST, TOLERANCE, resolved
from .following import unit_of
from .records import PeriodicOrbit

__all__ = ["born"]

NEAR = 1e-2
"""Largest real part of the pair, over its frequency, at what counts as a Hopf point's guess."""


def born(
    problem: Problem,
    point: Any,
    parameter: Any,
    *,
    size: float = 1e-2,
    unit: float = 1.0,
    tolerance: float = TOLERANCE,
) -> PeriodicOrbit:
    """Find a small cycle near a Hopf point.

    Parameters
    ----------
    problem : Problem
        Autonomous, at the parameter's value at the Hopf point.
    point : array_like, shape (d,)
        The equilibrium there.
    parameter : str or sympy.Symbol
        The one that is unknown: the cycle's problem has its value.
    size : float
        Of the cycle, over the equilibrium's norm (absolute at the origin).
    unit : float
        By which changes of the parameter are measured.
    tolerance : float
        As for `find`.

    Returns
    -------
    PeriodicOrbit

    Raises
    ------
    OrbitError
        If the point is no equilibrium, or no pair of eigenvalues is near the imaginary axis.
    """
    name = parameter if isinstance(parameter, str) else str(getattr(parameter, "name", parameter))
    problem.require(name)
    if problem.base is not None:
        raise OrbitError("a Hopf point is one of an autonomous system")
    x = _equilibrium(problem, np.asarray(point, dtype=float))
    values, vectors = np.linalg.eig(_at(problem, x)[1])
    pairs = np.flatnonzero(values.imag > 0)
    if not len(pairs):
        raise OrbitError("no pair of complex eigenvalues: this is no Hopf point")
    own = pairs[np.argmin(np.abs(values[pairs].real) / values[pairs].imag)]
    omega = float(values[own].imag)
    if abs(values[own].real) > NEAR * omega:
        raise OrbitError(
            f"the eigenvalues nearest to the imaginary axis are {values[own]:.3g}: this is no "
            "Hopf point"
        )
    wave = vectors[:, own] / np.linalg.norm(vectors[:, own])
    reach = size * (float(np.linalg.norm(x)) or 1.0)

    def swing(phase: Any) -> Floats:
        return np.asarray(reach * np.multiply.outer(np.exp(1j * phase), wave).real)

    table = table_for(problem.size)
    start = sampled(lambda phase: x + swing(phase), FIRST, table, omega, problem.values[name])
    way = replace(sampled(swing, FIRST, table, 0.0), frequency=0.0)
    scale = np.full(problem.size, reach)
    setting = Setting(problem, 1, scale, name, None, unit)
    setting = replace(setting, tangent=unit_of(setting, way))
    return resolved(setting, start, tolerance).orbit()


def _at(problem: Problem, x: Floats) -> tuple[Floats, Floats]:
    """Rates and Jacobian at one state."""
    rates, jacobians = problem.rates(np.zeros(1), x[:, None])
    return rates[0], jacobians[0]


def _equilibrium(problem: Problem, guess: Floats) -> Floats:
    """The equilibrium near a guess."""
    if guess.shape != (problem.size,) or not np.isfinite(guess).all():
        raise OrbitError(f"the point must be one state of {problem.size} numbers")

    def both(x: Floats) -> tuple[Floats, Floats]:
        return _at(problem, x)

    found = scipy.optimize.root(both, guess, jac=True, tol=1e-13)
    size = float(np.linalg.norm(_at(problem, found.x)[1])) * (1 + float(np.linalg.norm(guess)))
    if np.abs(found.fun).max() > 1e-9 * size:
        raise OrbitError("the point is no equilibrium, and there is none near it")
    return np.asarray(found.x)
