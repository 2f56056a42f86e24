"""`PeriodicOrbit`: one orbit with multipliers, error estimates and a verdict."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from ..floquet.perturbation import Complexes, eigenvalues_with_error
from ..floquet.points import Floats
from ..floquet.records import judge
from .collocation import Linearised
from .curves import Curve
from .fields import Problem

__all__ = ["PeriodicOrbit", "orbit_of", "transverse"]

SAMPLES = 128
"""Equidistant times over one period at which an orbit is tabulated."""

EPS = float(np.finfo(float).eps)

RESOLUTION = 1e-9
"""Growth that counts as none, over the frequency of the orbit."""


@dataclass(frozen=True, eq=False)
class PeriodicOrbit:
    """A periodic solution of the exact equations.

    Attributes
    ----------
    times : numpy.ndarray, shape (m,)
        Equidistant over one period from 0, in s.
    states : numpy.ndarray, shape (d, m)
        Of a mechanical system (q, q').
    period : float
        T in s.
    period_error : float
        Estimated error of T; 0 where it is given.
    multipliers : numpy.ndarray of complex, shape (d,)
        Of the variational equations over T, the largest first. An autonomous system has one that
        is 1, which comes first here and takes no part in the verdict.
    multiplier_errors : numpy.ndarray, shape (d,)
        Radius about each value.
    growth, growth_error : float
        Largest real part of the exponents in s⁻¹, and its error.
    verdict : str
        ``"stable"``, ``"unstable"`` or ``"undecided"``, as in `mmsgen.floquet`.
    error : numpy.ndarray, shape (d,)
        Estimated error of each state, in its unit, at any time.
    problem : Problem
        With the values.
    periods : int
        Periods of the excitation in T.
    curve : Curve
        The collocation solution.
    monodromy : numpy.ndarray, shape (d, d)
    """

    times: Floats
    states: Floats
    period: float
    period_error: float
    multipliers: Complexes
    multiplier_errors: Floats
    growth: float
    growth_error: float
    verdict: str
    error: Floats
    problem: Problem = field(repr=False)
    periods: int = field(repr=False)
    curve: Curve = field(repr=False)
    monodromy: Floats = field(repr=False)

    def __call__(self, times: npt.ArrayLike) -> Floats:
        """States at any times, shape (d, …)."""
        t = np.asarray(times, dtype=float)
        states = self.curve.at(np.ravel(t) * (2 * np.pi / self.period))
        return np.moveaxis(states, 0, -1).reshape(-1, *t.shape)

    @property
    def exponents(self) -> Complexes:
        """Characteristic exponents ln(multiplier)/T in s⁻¹, modulo 2πi/T."""
        with np.errstate(divide="ignore"):
            return np.asarray(np.log(self.multipliers) / self.period)

    @property
    def stable(self) -> bool | None:
        """The verdict as a truth value; None where it is undecided."""
        return {"stable": True, "unstable": False}.get(self.verdict)

    def harmonics(self, number: int | npt.ArrayLike) -> Complexes:
        """Complex Fourier coefficients, y = Σ_k c_k e^{ikωt}, ω = 2π/T.

        Parameters
        ----------
        number : int or array_like of int
            k.

        Returns
        -------
        numpy.ndarray of complex
            Shape (d,) + that of `number`.
        """
        k = np.asarray(number)
        phase = np.exp(-1j * np.multiply.outer(self.curve.phases, k))
        return np.asarray(self.curve.integral(phase))

    def amplitude(self, coordinate: int = 0, number: int = 1) -> float:
        """The amplitude 2|c_k| of one harmonic of one state."""
        return float(2 * np.abs(self.harmonics(number)[coordinate]))


def transverse(problem: Problem, curve: Curve, monodromy: Floats, scale: Floats) -> Floats:
    """The monodromy matrix in balanced units; of an autonomous system, across the orbit.

    The direction of the flow is an eigenvector of multiplier 1. In an orthonormal basis that
    begins with it the matrix is block triangular, and the other multipliers are those of the
    remaining block.
    """
    balanced = monodromy * (scale[None, :] / scale[:, None])
    if problem.base is not None:
        return np.asarray(balanced)
    along = problem.rates(np.zeros(1), curve.starts[:1].T)[0][0] / scale
    basis, _ = np.linalg.qr(np.column_stack([along, np.eye(len(along))]))
    return np.asarray(basis[:, 1:].T @ balanced @ basis[:, 1:])


def orbit_of(
    problem: Problem,
    periods: int,
    curve: Curve,
    pair: tuple[Linearised, Linearised],
    scale: Floats,
    errors: tuple[Floats, float],
) -> PeriodicOrbit:
    """Put together what is known of a solution.

    Parameters
    ----------
    problem, periods, curve
        Of the solution.
    pair : tuple of Linearised
        Of a coarser solution and of this one: their monodromy matrices' difference is the error.
    scale : numpy.ndarray, shape (d,)
    errors : tuple
        Of the states (d,) and of the period.
    """
    coarse, fine = (transverse(problem, curve, x.monodromy, scale) for x in pair)
    parts = pair[1].transitions * (scale[None, :] / scale[:, None])
    rounding = EPS * float(np.linalg.norm(parts, axis=(1, 2)).sum()) * float(np.linalg.norm(fine))
    # The states' error moves the matrix as well: in both solutions by different amounts.
    gap = float(np.linalg.norm(fine - coarse, 2)) + 4 * rounding
    period = 2 * np.pi / curve.frequency
    value, radius = eigenvalues_with_error(fine[None], np.array([gap]), np.array([1e-12]))
    order = np.argsort(-np.abs(value[0]), kind="stable")
    value, radius = value[0, order], radius[0, order]
    growth, below, above = _growth(value, radius, period)
    # A multiplier near zero has no lower bound, and needs none to be called stable.
    verdict, _ = judge(
        np.array(growth),
        np.array(above if growth < 0 else below),
        np.array(RESOLUTION * curve.frequency),
        None,
    )
    growth_error = max(below, above)
    if problem.base is None:
        value, radius = np.append(1.0 + 0j, value), np.append(0.0, radius)
    phases = np.asarray(2 * np.pi / SAMPLES * np.arange(SAMPLES), dtype=float)
    times, states = phases / curve.frequency, curve.at(phases).T
    return PeriodicOrbit(
        times,
        states,
        period,
        errors[1],
        value,
        radius,
        growth,
        growth_error,
        str(verdict),
        errors[0],
        problem,
        periods,
        curve,
        pair[1].monodromy,
    )


def _growth(value: Complexes, radius: Floats, period: float) -> tuple[float, float, float]:
    """Largest real part of the exponents, and how far it may be below and above."""
    if not len(value):
        return -np.inf, 0.0, 0.0
    sizes = np.abs(value)
    with np.errstate(divide="ignore", invalid="ignore"):
        growth = float(np.log(sizes.max()) / period)
        above = float(np.log((sizes + radius).max()) / period) - growth
        below = growth - float(np.log(max((sizes - radius).max(), 0.0)) / period)
    below, above = (x if np.isfinite(x) else np.inf for x in (below, above))
    return growth, below, above
