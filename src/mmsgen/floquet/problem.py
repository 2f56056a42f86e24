"""`Problem`: equations, values, period and options, checked and ready to be computed in chunks."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from concurrent.futures import FIRST_EXCEPTION, ThreadPoolExecutor, wait
from dataclasses import dataclass
from numbers import Integral, Real

import numpy as np
import numpy.typing as npt
import sympy as sp

from ..errors import FloquetError
from .collocation import GaussTable, gauss_table
from .points import Floats, Points, Values, make_points
from .system import LinearEquations, PeriodicSystem, check_rest, compile_system

__all__ = ["Options", "Problem", "prepare", "run_chunks"]

CHUNK = 256
"""Points in one unit of work of a thread: the same however many threads there are, so that
results do not depend on the machine's number of cores."""
PERIOD_KEY = " period"  # no symbol of a model has this name


@dataclass(frozen=True)
class Options:
    """Numerical options, common to all functions.

    Parameters
    ----------
    tolerance : float
        Error wanted of the returned value, in its own unit. Steps are refined until the estimate
        is below it or rounding is reached, whichever comes first.
    max_steps : int
        Most collocation steps per period. A point that would need more keeps its last estimate
        of the error, inf if that says nothing.
    workers : int, optional
        Threads; by default as many as there are cores for this process.
    enough : float
        An exponent known to this, in s⁻¹, is not looked at more closely, even if the tolerance is
        smaller: sharpening the bounds of colliding multipliers takes a millisecond each.
    """

    tolerance: float = 1e-9
    max_steps: int = 4096
    workers: int | None = None
    enough: float = 0.0

    def __post_init__(self) -> None:
        if not (isinstance(self.tolerance, Real) and 0 < self.tolerance < np.inf):
            raise FloquetError(f"tolerance must be a positive number, got {self.tolerance!r}")
        if isinstance(self.max_steps, bool) or not isinstance(self.max_steps, Integral):
            raise FloquetError(f"max_steps must be a whole number, got {self.max_steps!r}")
        if self.max_steps < 1:
            raise FloquetError(f"max_steps must be at least 1, got {self.max_steps!r}")
        if self.workers is not None and not (
            isinstance(self.workers, Integral) and self.workers >= 1
        ):
            raise FloquetError(
                f"workers must be a whole number, at least 1, or None: got {self.workers!r}"
            )


@dataclass(frozen=True)
class Problem:
    """What is to be computed.

    Parameters
    ----------
    system : PeriodicSystem
        Compiled M, C and K.
    points : Points
        Parameter values.
    period : numpy.ndarray or None, shape (points,)
        T; None for constant coefficients when no period was given.
    options : Options
        Numerical options.
    """

    system: PeriodicSystem
    points: Points
    period: Floats | None
    options: Options

    @property
    def table(self) -> GaussTable:
        """The collocation method: many stages, while the matrices stay small (width 72)."""
        return gauss_table(min(16, max(8, 72 // self.system.size)))

    @property
    def periods(self) -> Floats:
        """T, or an error that asks for it."""
        if self.period is None:
            raise FloquetError(
                "M, C and K are constant, so there is no period of their own: pass period="
            )
        return self.period


def prepare(
    eom: LinearEquations,
    values: Values,
    period: sp.Expr | npt.ArrayLike | None,
    options: Options,
) -> Problem:
    """Check everything and compile the equations.

    Parameters
    ----------
    eom : LinearEquations
        The linear equations of motion.
    values : mapping of symbol or name to scalar or array
        Parameter values, which broadcast together.
    period : sympy.Expr or array_like, optional
        T as an expression in the parameters or as numbers in s; by default it is found.
    options : Options
        Numerical options.

    Returns
    -------
    Problem
        Ready for `run_chunks`.

    Raises
    ------
    FloquetError
        For missing, unknown or unusable values, for coefficients without a common period, and
        for nonlinear equations in which a force acts at rest.
    """
    if not all(hasattr(eom, name) for name in ("M", "C", "K", "parameters")):
        raise FloquetError(
            f"the first argument must be equations of motion, got {eom!r}: pass what "
            "model.equations_of_motion() returns"
        )
    check_rest(eom)
    if not isinstance(values, Mapping):
        raise FloquetError(f"values must be a mapping of symbols to numbers, got {values!r}")
    symbolic = period if isinstance(period, sp.Basic) else None
    numeric = None if symbolic is not None or period is None else _positive(period)
    names = frozenset(str(getattr(key, "name", key)) for key in values)
    system = compile_system(eom, names, symbolic, numeric is not None)
    extra = {} if numeric is None else {PERIOD_KEY: numeric}
    points = make_points(values, eom.parameters, _known(eom), extra)
    arrays = points.arrays
    system.require(arrays)
    lengths: Floats | None = None
    if numeric is not None:
        lengths = arrays[PERIOD_KEY]
    elif system.time_varying or symbolic is not None:
        lengths = system.period(arrays, points.count)
    problem = Problem(system, points, lengths, options)
    if period is not None and system.time_varying and points.count:
        _check_period(problem)
    return problem


def _known(eom: LinearEquations) -> set[sp.Symbol]:
    """Symbols of the equations, declared as parameters or not."""
    found: set[sp.Symbol] = set()
    for matrix in (eom.M, eom.C, eom.K, getattr(eom, "f", None)):
        found |= getattr(matrix, "free_symbols", set())
    return found - {eom.time}


def _positive(period: object) -> Floats:
    """A numeric period, checked."""
    try:
        array = np.asarray(period, dtype=np.float64)
    except (TypeError, ValueError):
        raise FloquetError(f"period must be numbers or a sympy expression: {period!r}") from None
    if not np.all(np.isfinite(array) & (array > 0)):
        raise FloquetError("period must be finite and positive")
    return array


def _check_period(problem: Problem) -> None:
    """Raise FloquetError if M, C or K do not repeat after the period that was given."""
    phase = 2 * np.pi * np.mod(0.1 + 0.6180339887498949 * np.arange(7), 1.0)
    arrays, period = problem.points.arrays, problem.periods
    first = problem.system.coefficients(phase, arrays, period)
    second = problem.system.coefficients(phase + 2 * np.pi, arrays, period)
    size = np.max(np.abs(first), axis=(0, 2, 3), keepdims=True)
    # A period of ten digits is taken as meant; a wrong one differs in the first few.
    wrong = np.abs(first - second) > 1e-9 * size
    if np.any(wrong):
        raise FloquetError("M, C and K do not repeat after the given period: check period=")


def run_chunks(problem: Problem, job: Callable[[slice], None]) -> None:
    """Call `job` for slices that together cover all points, on several threads.

    LAPACK lets go of the interpreter, so threads suffice. Where the collocation matrices have
    more than 100 rows OpenBLAS runs threads of its own (measured), and a second layer would only
    fight with them.

    Parameters
    ----------
    problem : Problem
        The points and the number of threads.
    job : callable
        Fills its slice of the result.
    """
    count, workers = problem.points.count, problem.options.workers
    width = problem.table.stages * problem.system.size
    chunk = min(CHUNK, max(32, -(-count // 2)))
    slices = [slice(start, min(start + chunk, count)) for start in range(0, count, chunk)]
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    threads = min(workers or cores or 1, len(slices))
    if threads <= 1 or width > 100:
        for part in slices:
            job(part)
        return
    pool = ThreadPoolExecutor(threads)
    try:
        futures = [pool.submit(job, part) for part in slices]
        wait(futures, return_when=FIRST_EXCEPTION)
        for future in futures:
            if future.done():
                future.result()
    finally:
        # On an error or an interrupt the chunks that have not begun are dropped.
        pool.shutdown(wait=True, cancel_futures=True)
