"""Exponents of a chunk of points, refined until the wanted quantity is known well enough."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from .perturbation import Complexes, eigenvalues_with_error
from .points import Floats
from .problem import Problem
from .propagation import EPS, ROUNDING, Propagation, propagate, scan_coefficients, two_norm

__all__ = ["Spectrum", "constant_spectrum", "monodromy_chunk", "periodic_spectrum"]


@dataclass(frozen=True)
class Spectrum:
    """Multipliers or eigenvalues of some points.

    Parameters
    ----------
    value : numpy.ndarray of complex, shape (points, 2n)
        Multipliers, or eigenvalues in s⁻¹ for constant coefficients.
    radius : numpy.ndarray, shape (points, 2n)
        Error bounds of `value`.
    real : numpy.ndarray, shape (points, 2n)
        Real parts of the exponents, s⁻¹.
    below, above : numpy.ndarray, shape (points, 2n)
        How far the real parts may be below and above, s⁻¹.
    """

    value: Complexes
    radius: Floats
    real: Floats
    below: Floats
    above: Floats

    @property
    def growth(self) -> Floats:
        """Largest real part, shape (points,)."""
        return np.asarray(self.real.max(axis=1))

    @property
    def growth_error(self) -> Floats:
        """Bound of the error of `growth`: strongly damped exponents do not matter for it."""
        with np.errstate(all="ignore"):
            upper = (self.real + self.above).max(axis=1) - self.growth
            lower = self.growth - (self.real - self.below).max(axis=1)
            error = np.maximum(upper, lower)
        return np.where(np.isfinite(error) & np.isfinite(self.growth), error, np.inf)


def monodromy_chunk(
    problem: Problem, part: npt.NDArray[np.intp] | slice, target: Floats
) -> Propagation:
    """Monodromy matrices of some points, to a truncation error `target`."""
    arrays = problem.points.take(part)
    return propagate(
        problem.system,
        arrays,
        problem.periods[part],
        target,
        problem.table,
        problem.options.max_steps,
    )


def periodic_spectrum(
    problem: Problem, part: slice, *, of_exponents: bool, growth_only: bool = False
) -> Spectrum:
    """Multipliers of some points, with the steps that the tolerance asks for.

    The first try allows the matrix a hundredth of the tolerance. Points whose multipliers are too
    badly conditioned for that are computed again, down to rounding.

    Parameters
    ----------
    problem : Problem
        The points.
    part : slice
        Which of them.
    of_exponents : bool
        The tolerance is meant for exponents, in s⁻¹, and not for multipliers.
    growth_only : bool
        Only the error of the growth rate has to meet the tolerance.

    Returns
    -------
    Spectrum
        With errors, whether the tolerance was met or not.
    """
    period = problem.periods[part]
    tolerance = problem.options.tolerance
    relative = np.minimum(tolerance * period, 0.1) if of_exponents else tolerance + 0 * period
    first = monodromy_chunk(problem, part, np.minimum(0.01 * relative, 1e-6))
    enough = np.maximum(relative, np.minimum(problem.options.enough * period, 0.1))
    spectrum = _multipliers(first, period, enough)
    if growth_only:
        error = spectrum.growth_error
        missed = ~(error <= tolerance)
    else:
        error = np.maximum(spectrum.below, spectrum.above) if of_exponents else spectrum.radius
        missed = ~np.asarray((error <= tolerance).all(axis=1))
    missed &= first.truncation > first.rounding
    missed &= first.steps > 0
    again = np.arange(period.size)[missed]
    if again.size == 0:
        return spectrum
    index = np.arange(problem.points.count)[part][again]
    second = monodromy_chunk(problem, index, np.zeros(again.size))
    better = _multipliers(second, period[again], enough[again])
    for old, new in zip(_fields(spectrum), _fields(better), strict=True):
        old[again] = new
    return spectrum


def _fields(spectrum: Spectrum) -> tuple[npt.NDArray[np.inexact], ...]:
    return spectrum.value, spectrum.radius, spectrum.real, spectrum.below, spectrum.above


def _multipliers(state: Propagation, period: Floats, relative: Floats) -> Spectrum:
    value, radius = eigenvalues_with_error(state.matrix, state.error, relative)
    with np.errstate(all="ignore"):
        modulus = np.abs(value)
        share = radius / modulus
        length = period[:, None]
        real = np.log(modulus) / length
        above = np.where(np.isfinite(share), np.log1p(share), np.inf) / length
        below = np.where(share < 1, -np.log1p(-np.minimum(share, 1)), np.inf) / length
        # A multiplier that underflows or vanishes has no lower bound, but a firm upper one.
        tiny = modulus == 0
        real = np.where(tiny, np.log(np.finfo(float).tiny) / length, real)
        above = np.where(tiny, np.log(np.maximum(radius, 1e-300)) / length - real, above)
    return Spectrum(value, radius, real, below, np.maximum(above, 0.0))


def constant_spectrum(problem: Problem, part: slice) -> Spectrum:
    """Eigenvalues of the first-order form of equations with constant M, C and K."""
    arrays = problem.points.take(part)
    count = len(range(*part.indices(problem.points.count)))
    unit = np.full(count, 2 * np.pi)  # θ = t: nothing to be scaled
    scan = scan_coefficients(problem.system, arrays, unit)
    matrix = scan.matrix[0]
    # Solving with M costs cond(M) roundings, the eigenvalue algorithm a few |A| eps of its own.
    with np.errstate(all="ignore"):
        error = ROUNDING * EPS * (1 + scan.condition) * two_norm(matrix)
        relative = np.full(count, problem.options.tolerance)
    value, radius = eigenvalues_with_error(matrix, error, relative, absolute=True)
    return Spectrum(value, radius, value.real.copy(), radius, radius)
