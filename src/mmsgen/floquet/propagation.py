"""Monodromy matrices with error estimates: step control, point by point.

Every point gets its own number of steps. It is guessed from the size of the coefficients,
calibrated on a few points of the chunk, and accepted or raised by the estimate of the error
alone (`collocation.truncation`); only the points that miss their target are computed again.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from ..errors import FloquetError
from .collocation import GaussTable, stage_norms, step_matrices, truncation
from .points import Floats
from .system import PeriodicSystem

__all__ = ["Propagation", "balance", "propagate", "scan_coefficients"]

EPS = float(np.finfo(np.float64).eps)
BLOCK = 200_000
"""Numbers in the collocation matrices of one LAPACK call: they fit a second-level cache."""
LADDER = tuple(sorted({m << k for m in (4, 5, 6, 7) for k in range(16)} | {1, 2, 3}))
"""Numbers of steps that are used: few enough that points form groups, at most a third apart."""
ROUNDING = 4.0
"""Rounding error of a step in units of eps·cond(M)·(|step matrix| + |stage values|), the latter as
the sum of their Legendre coefficients: a step that is long for the fastest motion has stages far
larger than its end. See the tests, which compare with collocations of other stages and steps."""


@dataclass(frozen=True)
class Propagation:
    """Monodromy matrices of a chunk of points.

    Parameters
    ----------
    matrix : numpy.ndarray, shape (points, 2n, 2n)
        Φ(T) in the balanced state x_i/scale_i, derivatives with respect to θ = 2πt/T.
    truncation, rounding : numpy.ndarray, shape (points,)
        The two parts of the estimated error of `matrix` in the 2-norm.
    scale : numpy.ndarray, shape (points, 2n)
        Powers of two.
    steps : numpy.ndarray of int, shape (points,)
        Steps per period.
    """

    matrix: Floats
    truncation: Floats
    rounding: Floats
    scale: Floats
    steps: npt.NDArray[np.int64]

    @property
    def error(self) -> Floats:
        """Estimated error in the 2-norm, inf where the estimate is not to be trusted."""
        total = self.truncation + self.rounding
        size = two_norm(self.matrix)
        # Beyond a tenth of the matrix itself the Legendre tail has not begun to fall.
        known = np.isfinite(total) & np.isfinite(size) & (total < 0.1 * size)
        return np.where(known, total, np.inf)


@dataclass(frozen=True)
class Scan:
    """What the coefficients at a few times say about each point.

    Parameters
    ----------
    scale : numpy.ndarray, shape (points, 2n)
        Units that balance the first-order form, powers of two.
    rate : numpy.ndarray, shape (points,)
        Norm of the balanced first-order matrix: radians of the fastest motion per radian of θ.
    condition : numpy.ndarray, shape (points,)
        Skeel's condition number of M, largest over the times looked at.
    matrix : numpy.ndarray, shape (times, points, 2n, 2n)
        Balanced first-order matrices.
    """

    scale: Floats
    rate: Floats
    condition: Floats
    matrix: Floats = field(repr=False)


def two_norm(matrix: Floats) -> Floats:
    """Upper bound √(‖·‖₁‖·‖∞) of the 2-norm, of each matrix of a stack."""
    size = np.abs(matrix)
    with np.errstate(over="ignore", invalid="ignore"):
        bound = np.sqrt(size.sum(axis=-1).max(axis=-1)) * np.sqrt(size.sum(axis=-2).max(axis=-1))
    return np.asarray(bound)


def balance(weight: Floats) -> Floats:
    """Diagonal scaling that evens out row and column norms (Osborne), as powers of two.

    Parameters
    ----------
    weight : numpy.ndarray, shape (points, N, N)
        Absolute values of a matrix.

    Returns
    -------
    numpy.ndarray, shape (points, N)
        d such that the rows and columns of D⁻¹ weight D have similar sums.
    """
    weight = weight.copy()
    index = np.arange(weight.shape[-1])
    weight[:, index, index] = 0.0
    scale = np.ones(weight.shape[:2])
    for _ in range(12):
        scaled = weight * scale[:, None, :] / scale[:, :, None]
        row, column = scaled.sum(axis=2), scaled.sum(axis=1)
        usable = (row > 0) & (column > 0) & np.isfinite(row) & np.isfinite(column)
        # The fourth root, half of Osborne's step: all components move at the same time.
        ratio = np.divide(row, column, out=np.ones_like(row), where=usable) ** 0.25
        scale = np.clip(scale * ratio, 1e-60, 1e60)
    return np.asarray(2.0 ** np.round(np.log2(scale)))


def scan_coefficients(system: PeriodicSystem, arrays: dict[str, Floats], period: Floats) -> Scan:
    """Look at M, C and K at a few times: units, rates, and whether M can be inverted.

    Raises
    ------
    FloquetError
        If M is singular, to within rounding, at one of the times.
    """
    # Golden-section phases hit no symmetry of the coefficients; constants need one time only.
    count = 5 if system.time_varying else 1
    phase = 2 * np.pi * np.mod(0.1 + 0.6180339887498949 * np.arange(count), 1.0)
    data = system.coefficients(phase, arrays, period)
    mass = data[..., 0]
    check_mass(mass)
    size = system.size
    points = period.size
    with np.errstate(all="ignore"):
        finite = np.asarray(np.isfinite(data).all(axis=(0, 2, 3, 4)))
        identity = np.eye(size)
        safe = np.where(finite[None, :, None, None], mass, identity)
        inverse = np.linalg.inv(safe)
        first_order = np.zeros((count, points, 2 * size, 2 * size))
        first_order[..., :size, size:] = identity
        first_order[..., size:, :size] = -inverse @ data[..., 2]
        first_order[..., size:, size:] = -inverse @ data[..., 1]
        first_order[:, ~finite] = np.nan
        skeel = (np.abs(inverse) @ np.abs(safe)).sum(axis=-1).max(axis=(0, 2))
        mean = np.abs(np.where(finite[:, None, None], first_order, 0.0)).mean(axis=0)
        scale = balance(mean)
        balanced = first_order * (scale[:, None, :] / scale[:, :, None])
        rate = two_norm(balanced).max(axis=0)
    return Scan(scale, rate, np.where(finite, skeel, np.inf), balanced)


def check_mass(mass: Floats) -> None:
    """Raise FloquetError where M is singular: |det M| against Hadamard's bound."""
    with np.errstate(all="ignore"):
        rows = np.sqrt((mass**2).sum(axis=-1))
        scaled = np.where(rows[..., None] > 0, mass / rows[..., None], 0.0)
        finite = np.asarray(np.isfinite(scaled).all(axis=(-1, -2)))
        scaled = np.where(finite[..., None, None], scaled, np.eye(mass.shape[-1]))
        singular = np.abs(np.linalg.det(scaled)) < 1e-13
    if np.any(singular):
        empty = np.argwhere(rows == 0)
        detail = f" (row {int(empty[0][-1]) + 1} is zero)" if empty.size else ""
        raise FloquetError(
            f"the mass matrix M(t) is singular at some time or point{detail}: a coordinate "
            "without inertia must be eliminated, and parameters must keep M regular"
        )


def propagate(
    system: PeriodicSystem,
    arrays: dict[str, Floats],
    period: Floats,
    target: Floats,
    table: GaussTable,
    max_steps: int,
) -> Propagation:
    """Compute the monodromy matrix of each point to its target.

    Parameters
    ----------
    system : PeriodicSystem
        The equations.
    arrays : dict of str to numpy.ndarray, shape (points,)
        Parameter values.
    period : numpy.ndarray, shape (points,)
        T.
    target : numpy.ndarray, shape (points,)
        Wanted truncation error; below the rounding error it is taken as reached.
    table : GaussTable
        The method.
    max_steps : int
        Points that would need more steps keep the estimate of their last try.

    Returns
    -------
    Propagation
        Matrices and estimates, whether the targets were met or not.

    Raises
    ------
    FloquetError
        If M is singular.
    """
    scan = scan_coefficients(system, arrays, period)
    ladder = np.array([n for n in LADDER if n <= max_steps])
    width = 2 * system.size
    state = Propagation(
        matrix=np.full((period.size, width, width), np.nan),
        truncation=np.full(period.size, np.inf),
        rounding=np.full(period.size, np.inf),
        scale=scan.scale,
        steps=np.zeros(period.size, dtype=np.int64),
    )
    usable = np.flatnonzero(np.isfinite(scan.rate) & np.isfinite(scan.condition))
    demand = scan.rate + system.harmonic
    pilots = usable[:: max(1, usable.size // 8)]
    per_step = 0.4 * table.stages  # radians a step can take at first sight; the pilots correct it
    work = _Work(system, arrays, period, scan, target, table, ladder)
    work.refine(state, pilots, _rung(ladder, demand[pilots] / per_step))
    if pilots.size:
        needed = work.needed(state, pilots) / demand[pilots]
        rest = np.setdiff1d(usable, pilots)
        work.refine(state, rest, _rung(ladder, np.quantile(needed, 0.9) * demand[rest]))
    _explain(work, np.flatnonzero(np.isinf(state.error) & np.isfinite(scan.rate)))
    return state


def _explain(work: _Work, failed: npt.NDArray[np.intp]) -> None:
    """Raise FloquetError if points failed because M becomes singular within the period."""
    for point in failed[:64]:
        arrays = {name: array[point : point + 1] for name, array in work.arrays.items()}
        phase = np.linspace(0, 2 * np.pi, 256, endpoint=False)
        mass = work.system.coefficients(phase, arrays, work.period[point : point + 1])[..., 0]
        check_mass(mass)
        with np.errstate(all="ignore"):
            sign = np.sign(np.linalg.det(mass))
        if (sign > 0).any() and (sign < 0).any():
            raise FloquetError(
                "the mass matrix M(t) is singular at some time of the period: its determinant "
                "changes sign, and the accelerations become infinite"
            )


def _rung(ladder: npt.NDArray[np.int64], steps: Floats) -> npt.NDArray[np.int64]:
    """The smallest rungs that are at least `steps`, or the last one."""
    place = np.searchsorted(ladder, np.nan_to_num(steps, nan=np.inf, posinf=1e18))
    return ladder[np.minimum(place, ladder.size - 1)]


@dataclass(frozen=True)
class _Work:
    """What stays the same while the numbers of steps are being raised."""

    system: PeriodicSystem
    arrays: dict[str, Floats]
    period: Floats
    scan: Scan
    target: Floats
    table: GaussTable
    ladder: npt.NDArray[np.int64]

    @property
    def cells(self) -> int:
        """Steps to be solved in one call."""
        return min(512, max(8, BLOCK // (self.table.stages * self.system.size) ** 2))

    def needed(self, state: Propagation, index: npt.NDArray[np.intp]) -> Floats:
        """Steps at which the target would be met, by the order 2s of the method."""
        goal = np.maximum(self.target[index], state.rounding[index])
        with np.errstate(all="ignore"):
            factor = (state.truncation[index] / goal) ** (0.5 / self.table.stages)
        return np.asarray(state.steps[index] * np.where(np.isfinite(factor), factor, 4.0))

    def refine(
        self, state: Propagation, index: npt.NDArray[np.intp], steps: npt.NDArray[np.int64]
    ) -> None:
        """Fill `state` at `index`, beginning with `steps` and raising them where it must be."""
        while index.size:
            for count in np.unique(steps):
                self._group(state, index[steps == count], int(count))
            missed = state.truncation[index] > np.maximum(self.target[index], state.rounding[index])
            missed |= ~np.isfinite(state.truncation[index])
            missed &= steps < self.ladder[-1]
            index, steps = index[missed], steps[missed]
            wanted = np.clip(1.05 * self.needed(state, index), steps + 1, 4 * steps)
            steps = _rung(self.ladder, wanted)

    def _group(self, state: Propagation, index: npt.NDArray[np.intp], count: int) -> None:
        """All points with the same number of steps, a cache-sized block at a time."""
        block = max(1, self.cells // count)
        for start in range(0, index.size, block):
            part = index[start : start + block]
            matrix, cut, rounding = self._points(part, count)
            state.matrix[part], state.truncation[part] = matrix, cut
            state.rounding[part], state.steps[part] = rounding, count

    def _points(self, part: npt.NDArray[np.intp], count: int) -> tuple[Floats, Floats, Floats]:
        """Monodromy matrices of a few points with `count` steps."""
        arrays = {name: array[part] for name, array in self.arrays.items()}
        period, scale = self.period[part], self.scan.scale[part]
        step = 2 * np.pi / count
        width = scale.shape[1]
        transition = np.empty((count, part.size, width, width))
        cut, stage = np.empty((2, count, part.size))
        batch = max(1, self.cells // part.size)
        for start in range(0, count, batch):
            stop = min(count, start + batch)
            begin = np.arange(start, stop)
            phase = step * (self.table.nodes[:, None] + begin).ravel()
            data = self.system.coefficients(phase, arrays, period)
            size = data.shape[2]
            cells = begin.size * part.size
            data = data.reshape(self.table.stages, cells, size, size, 3)
            units = np.tile(scale, (begin.size, 1))
            with np.errstate(all="ignore"):
                try:
                    matrix, series = step_matrices(data, step, self.table)
                    norms = stage_norms(series, step, units)
                except np.linalg.LinAlgError:
                    matrix = np.full((cells, width, width), np.nan)
                    norms = np.full((self.table.stages, cells), np.inf)
                matrix *= units[:, None, :] / units[:, :, None]
                cut[start:stop] = truncation(norms).reshape(-1, part.size)
            # No estimate holds for a step within which a coefficient jumps.
            jumps = self.system.jumps(begin, step, self.table.nodes, arrays, period)
            cut[start:stop][jumps] = np.inf
            stage[start:stop] = norms.sum(axis=0).reshape(-1, part.size)
            transition[start:stop] = matrix.reshape(-1, part.size, width, width)
        with np.errstate(all="ignore"):
            return _product(transition, cut, stage, self.scan.condition[part])


def _product(
    transition: Floats, cut: Floats, stage: Floats, condition: Floats
) -> tuple[Floats, Floats, Floats]:
    """Multiply the steps of each point and carry their errors to the end of the period.

    The error of a product is Σ_k (later steps)·error_k·(earlier steps), to first order: norms of
    the partial products themselves are used, not products of norms, which would grow with the
    number of steps.
    """
    count = transition.shape[0]
    later = np.empty((count, transition.shape[1]))
    later[-1] = 1.0
    partial = transition[-1]
    for k in range(count - 2, -1, -1):
        later[k] = two_norm(partial)
        partial = partial @ transition[k]
    earlier = np.empty_like(later)
    earlier[0] = 1.0
    head = transition[0]
    for k in range(1, count):
        earlier[k] = two_norm(head)
        head = transition[k] @ head
    spread = later * earlier
    rounding = ROUNDING * EPS * condition * ((spread * (two_norm(transition) + stage)).sum(axis=0))
    rounding += ROUNDING * EPS * two_norm(head)
    cut_total = (spread * cut).sum(axis=0)
    bad = ~np.isfinite(head).all(axis=(1, 2))
    return (
        head,
        np.where(bad | ~np.isfinite(cut_total), np.inf, cut_total),
        np.where(bad | ~np.isfinite(rounding), np.inf, rounding),
    )
