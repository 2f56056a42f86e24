"""Growth rates, exponents, multipliers and monodromy matrices: the public functions."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt
import sympy as sp

from ..errors import FloquetError
from .points import Floats, Values
from .problem import Options, Problem, prepare, run_chunks
from .records import Exponents, GrowthRate, Monodromy, Multipliers, judge
from .spectrum import Spectrum, constant_spectrum, monodromy_chunk, periodic_spectrum
from .system import LinearEquations

__all__ = ["exponents", "growth", "growth_rate", "monodromy", "multipliers"]

Period: TypeAlias = sp.Expr | npt.ArrayLike | None


def growth_rate(
    eom: LinearEquations,
    values: Values,
    *,
    period: Period = None,
    tolerance: float = 1e-9,
    threshold: npt.ArrayLike | None = None,
    max_steps: int = 4096,
    workers: int | None = None,
) -> GrowthRate:
    """Growth rate of the fastest growing motion, max Re λ.

    Parameters
    ----------
    eom : EquationsOfMotion
        Linear equations M(t)q'' + C(t)q' + K(t)q = f(t); f does not matter. Nonlinear ones are
        linearised about rest, q = 0, which must be a solution: no force may act there.
    values : mapping of symbol or name to scalar or array
        Parameter values, which broadcast together to the batch. A parameter with a definition
        is computed from the others unless its value is given.
    period : sympy.Expr or array_like, optional
        T in s, as numbers or as an expression in the parameters. By default it is read off the
        equations.
    tolerance : float
        Error wanted of the growth rate, in s⁻¹; reached unless rounding is in the way.
    threshold : array_like, optional
        Growth rate in s⁻¹ from which a point is called unstable; see `records.judge` for
        what stable means without one. The resolution is then the larger of ten tolerances and
        1e-9 of the parametric frequency 2π/T (of the largest frequency, if nothing varies).
    max_steps : int
        Most collocation steps per period.
    workers : int, optional
        Threads, by default one per core.

    Returns
    -------
    GrowthRate
        Value, error and verdict, in the batch shape; ``float(result)`` for a single point.

    Raises
    ------
    FloquetError
        For missing, unknown or unusable values, coefficients without a common period, a
        singular mass matrix, or nonlinear equations with a force at rest.
    """
    problem = prepare(eom, values, period, Options(tolerance, max_steps, workers))
    return growth(problem, threshold)


def growth(problem: Problem, threshold: npt.ArrayLike | None) -> GrowthRate:
    """`growth_rate` of a prepared problem."""
    count, shape = problem.points.count, problem.points.shape
    value, error = np.empty(count), np.empty(count)
    frequency = np.empty(count)

    def job(part: slice) -> None:
        spectrum = _spectrum(problem, part, of_exponents=True, growth_only=True)
        value[part], error[part] = spectrum.growth, spectrum.growth_error
        if problem.system.time_varying:
            frequency[part] = 2 * np.pi / problem.periods[part]
        else:
            frequency[part] = np.abs(spectrum.value).max(axis=1, initial=0.0)

    run_chunks(problem, job)
    resolution = np.maximum(10 * problem.options.tolerance, 1e-9 * np.nan_to_num(frequency))
    level = _threshold(threshold, shape)
    verdict, used = judge(
        value.reshape(shape), error.reshape(shape), resolution.reshape(shape), level
    )
    return GrowthRate(value.reshape(shape), error.reshape(shape), verdict, used)


def exponents(
    eom: LinearEquations,
    values: Values,
    *,
    period: Period = None,
    tolerance: float = 1e-9,
    max_steps: int = 4096,
    workers: int | None = None,
) -> Exponents:
    """Characteristic exponents λ = ln(μ)/T, defined modulo 2πi/T.

    For constant coefficients they are the eigenvalues themselves and no period is needed.
    Parameters and errors raised: see `growth_rate`; `tolerance` is in s⁻¹.

    Returns
    -------
    Exponents
        Value and error, shape batch + (2n,).
    """
    problem = prepare(eom, values, period, Options(tolerance, max_steps, workers))
    count, width = problem.points.count, 2 * problem.system.size
    value = np.empty((count, width), dtype=np.complex128)
    error = np.empty((count, width))

    def job(part: slice) -> None:
        spectrum = _spectrum(problem, part, of_exponents=True, growth_only=False)
        found, bound = spectrum.value, np.maximum(spectrum.below, spectrum.above)
        if problem.system.time_varying:
            with np.errstate(all="ignore"):
                angle = np.angle(spectrum.value) / problem.periods[part][:, None]
            found = spectrum.real + 1j * angle
        order = np.lexsort((found.real, found.imag), axis=1)
        value[part] = np.take_along_axis(found, order, axis=1)
        error[part] = np.take_along_axis(bound, order, axis=1)

    run_chunks(problem, job)
    shape = problem.points.shape
    lengths = problem.period if problem.system.time_varying else None
    return Exponents(
        value.reshape(*shape, width),
        error.reshape(*shape, width),
        None if lengths is None else lengths.reshape(shape).copy(),
    )


def multipliers(
    eom: LinearEquations,
    values: Values,
    *,
    period: Period = None,
    tolerance: float = 1e-9,
    max_steps: int = 4096,
    workers: int | None = None,
) -> Multipliers:
    """Characteristic multipliers, the eigenvalues of the monodromy matrix.

    Parameters and errors raised: see `growth_rate`; `tolerance` is that of a multiplier. Constant
    coefficients need `period`.

    Returns
    -------
    Multipliers
        Value and error, shape batch + (2n,).
    """
    problem = prepare(eom, values, period, Options(tolerance, max_steps, workers))
    lengths = problem.periods
    count, width = problem.points.count, 2 * problem.system.size
    value = np.empty((count, width), dtype=np.complex128)
    error = np.empty((count, width))

    def job(part: slice) -> None:
        spectrum = _spectrum(problem, part, of_exponents=False, growth_only=False)
        found, bound = spectrum.value, spectrum.radius
        if not problem.system.time_varying:
            with np.errstate(all="ignore"):
                length = lengths[part][:, None]
                found = np.exp(found * length)
                bound = np.abs(found) * np.expm1(bound * length)
        order = np.lexsort((np.abs(found), np.angle(found)), axis=1)
        value[part] = np.take_along_axis(found, order, axis=1)
        error[part] = np.take_along_axis(bound, order, axis=1)

    run_chunks(problem, job)
    shape = problem.points.shape
    return Multipliers(
        value.reshape(*shape, width),
        error.reshape(*shape, width),
        lengths.reshape(shape).copy(),
    )


def monodromy(
    eom: LinearEquations,
    values: Values,
    *,
    period: Period = None,
    tolerance: float = 1e-9,
    max_steps: int = 4096,
    workers: int | None = None,
) -> Monodromy:
    """Monodromy matrices: (q, dq/dt) at t = 0 to (q, dq/dt) at t = T.

    Parameters and errors raised: see `growth_rate`; `tolerance` is that of the matrix in the
    2-norm, in units that balance it. Constant coefficients need `period`.

    Returns
    -------
    Monodromy
        Value and error, shape batch + (2n, 2n), with period and number of steps.
    """
    problem = prepare(eom, values, period, Options(tolerance, max_steps, workers))
    lengths = problem.periods
    count, size = problem.points.count, problem.system.size
    value = np.empty((count, 2 * size, 2 * size))
    error = np.empty_like(value)
    steps = np.empty(count, dtype=np.int64)

    def job(part: slice) -> None:
        length = lengths[part]
        state = monodromy_chunk(problem, part, np.full(length.size, tolerance))
        unit = state.scale.copy()
        unit[:, size:] *= (2 * np.pi / length)[:, None]  # derivatives by t instead of θ
        ratio = unit[:, :, None] / unit[:, None, :]
        value[part] = state.matrix * ratio
        error[part] = state.error[:, None, None] * ratio
        steps[part] = state.steps

    run_chunks(problem, job)
    shape = problem.points.shape
    return Monodromy(
        value.reshape(*shape, 2 * size, 2 * size),
        error.reshape(*shape, 2 * size, 2 * size),
        lengths.reshape(shape).copy(),
        steps.reshape(shape),
    )


def _spectrum(problem: Problem, part: slice, *, of_exponents: bool, growth_only: bool) -> Spectrum:
    """Multipliers if the coefficients vary in time, eigenvalues if they do not."""
    if problem.system.time_varying:
        return periodic_spectrum(problem, part, of_exponents=of_exponents, growth_only=growth_only)
    return constant_spectrum(problem, part)


def _threshold(threshold: npt.ArrayLike | None, shape: tuple[int, ...]) -> Floats | None:
    """The user's threshold in the batch shape."""
    if threshold is None:
        return None
    try:
        level = np.broadcast_to(np.asarray(threshold, dtype=np.float64), shape)
    except (TypeError, ValueError):
        raise FloquetError(
            f"threshold must be a number or an array that broadcasts to {shape}: {threshold!r}"
        ) from None
    if np.any(np.isnan(level)):
        raise FloquetError("threshold contains NaN")
    return level
