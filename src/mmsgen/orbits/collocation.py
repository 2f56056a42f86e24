"""Closed curves by Gauss-Legendre collocation on intervals, and Newton's method for them.

Along the phase φ of an orbit, 0 … 2π in N intervals of length h, the unknowns are the states y_n at
the intervals' beginnings and the slopes K at s Gauss nodes in each:

    K_i = f(φ_i, Y_i; p)/ω,  Y_i = y_n + h Σ_j A_ij K_j,  y_{n+1} = y_n + h Σ_j b_j K_j,  y_N = y_0.

The slopes are eliminated interval by interval, all of them at once. What is left is cyclic, with
the transition matrices of the variational equations as its blocks, so that the monodromy matrix
comes with every step. Further unknowns are the frequency ω of an autonomous system, with the
condition that a step has no part along the flow, and a parameter, with the condition that a step
has no part along a tangent. At the intervals' ends the error is of order h^{2s}.

Sources: Ascher, Mattheij & Russell, *Numerical Solution of Boundary Value Problems for Ordinary
Differential Equations* (1988), ch. 5; Doedel, Keller & Kernévez, *Int. J. Bifurcation and Chaos* 1
(1991) 493 and 745 (phase condition, pseudo-arclength).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import scipy  # loads its subpackages when they are first used

from ..errors import OrbitError
from ..floquet.points import Floats
from .curves import Curve
from .fields import Problem

__all__ = ["Linearised", "Setting", "linearise", "newton"]

STEPS = 25
"""Newton steps at most; five are usual."""

REACH = 0.5
"""Largest step, over the size of the motion: near folds Newton's own ones lead astray."""

CLOSE = 1e-8
"""From a step of this size, over that of the motion, one more reaches rounding."""

NOISE = 1e-12
"""A step that is this small is rounding already."""

FAMILY = 1e-7
"""Singular values below this, over the largest, belong to the direction of a family."""

SPARSE = 300
"""Unknowns from which a sparse solver is faster: few blocks of the matrix are not zero."""


@dataclass(frozen=True, eq=False)
class Setting:
    """What is unknown besides the curve.

    Attributes
    ----------
    problem : Problem
    periods : int
        Of the excitation, in one of the orbit.
    scale : numpy.ndarray, shape (d,)
        Size of each state.
    parameter : str or None
        The one that is unknown as well.
    tangent : Curve or None
        To which steps are orthogonal, where a parameter is unknown.
    unit : float
        By which changes of the parameter are measured.
    isolated : bool
        False for a family of orbits, as of a conservative system: then steps are the shortest.
    """

    problem: Problem
    periods: int
    scale: Floats
    parameter: str | None = None
    tangent: Curve | None = None
    unit: float = 1.0
    isolated: bool = True

    @property
    def free(self) -> bool:
        """Whether the frequency is unknown."""
        return self.problem.base is None

    def of(self, value: float) -> Problem:
        """The problem with the value of a curve."""
        return self.problem if self.parameter is None else self.problem.at(self.parameter, value)

    def product(self, a: Curve, b: Curve) -> float:
        """Inner product of two changes, free of units."""
        own = a.integral(b.states / self.scale**2)
        total = np.trace(np.atleast_2d(own)) / len(self.scale) + a.value * b.value / self.unit**2
        return float(total)


@dataclass(frozen=True, eq=False)
class Linearised:
    """Newton's equations about a curve, the slopes eliminated.

    Attributes
    ----------
    inner, nodes : numpy.ndarray, shape (N, s, d, d + e + 1)
        Changes of slopes and of states at the nodes, for each unit of y_n, of the e further
        unknowns, and of the defects.
    transitions : numpy.ndarray, shape (N, d, d)
    matrix : numpy.ndarray, shape (Nd + e, Nd + e)
    right : numpy.ndarray, shape (Nd + e,)
    """

    inner: Floats
    nodes: Floats
    transitions: Floats
    matrix: Floats
    right: Floats
    extras: tuple[bool, bool]
    isolated: bool = True

    @property
    def monodromy(self) -> Floats:
        """Φ, the product of the transition matrices."""
        result: Any = np.eye(self.transitions.shape[1])
        with np.errstate(all="ignore"):
            for part in self.transitions:
                result = part @ result
        return np.asarray(result, dtype=float)

    def change(self, right: Floats | None = None) -> Curve:
        """The step of Newton's method, or that of another right-hand side without defects."""
        count, _, d, _ = self.inner.shape
        solution: Any
        try:
            own = self.right if right is None else right
            if self.isolated and len(own) > SPARSE:
                factors = scipy.sparse.linalg.splu(scipy.sparse.csc_matrix(self.matrix))
                solution = factors.solve(own)
            elif self.isolated:
                solution = np.linalg.solve(self.matrix, own)
            else:
                solution = np.linalg.lstsq(self.matrix, own, rcond=FAMILY)[0]
        except (np.linalg.LinAlgError, RuntimeError):
            raise OrbitError(
                "the equations of the periodic orbit are singular: orbits are not isolated here, "
                "as in a conservative system: try isolated=False"
            ) from None
        states, extra = solution[: count * d].reshape(count, d), solution[count * d :]
        known = np.concatenate([extra, [float(right is None)]])
        each = np.concatenate([states, np.broadcast_to(known, (count, len(known)))], axis=1)
        rest = list(extra)
        frequency = float(rest.pop(0)) if self.extras[0] else 0.0
        value = float(rest.pop(0)) if self.extras[1] else 0.0
        slopes = np.einsum("nidc,nc->nid", self.inner, each)
        return Curve(np.array(states, dtype=np.float64), slopes, frequency, value)


def linearise(setting: Setting, curve: Curve) -> Linearised:
    """Newton's equations at a curve."""
    table, h = curve.table, curve.length
    count, s, d = curve.slopes.shape
    own = setting.of(curve.value)
    phase, states = setting.periods * curve.phases.ravel(), curve.states.reshape(-1, d).T
    if not (np.isfinite(states).all() and np.isfinite(curve.frequency) and curve.frequency > 0):
        raise OrbitError("no periodic orbit is found near the guess: Newton's method diverges")
    rates, jacobians = own.rates(phase, states)
    omega = curve.frequency if setting.free else _frequency(own, setting.periods)
    f = (rates / omega).reshape(count, s, d)
    jacobian = (jacobians / omega).reshape(count, s, d, d)
    columns = []
    if setting.free:
        columns.append(-f / omega)
    if setting.parameter is not None:
        slope = own.slope(setting.parameter, phase, states).reshape(count, s, d) / omega
        if not setting.free:
            slope = slope - f * own.base_slope(setting.parameter) / (setting.periods * omega)
        columns.append(slope)
    columns.append(f - curve.slopes)
    right = np.concatenate([jacobian, *(c[..., None] for c in columns)], axis=3)
    local = -h * table.matrix[None, :, None, :, None] * jacobian[:, :, :, None, :]
    local = local.reshape(count, s * d, s * d)
    local[:, range(s * d), range(s * d)] += 1.0
    inner = np.linalg.solve(local, right.reshape(count, s * d, -1)).reshape(right.shape)
    nodes = h * np.einsum("ij,njdc->nidc", table.matrix, inner)
    nodes[..., range(d), range(d)] += 1.0
    ends = h * np.einsum("i,nidc->ndc", table.weights, inner)
    ends[:, range(d), range(d)] += 1.0
    gap = curve.starts + h * np.einsum("i,nid->nd", table.weights, curve.slopes)
    ends[..., -1] += gap - np.roll(curve.starts, -1, axis=0)
    # A change of y_n counts once in y_n + h Σ b K, which the transition matrix holds already.
    matrix, rhs = _cyclic(ends, len(columns) - 1)
    rows = _conditions(setting, curve)
    for row, (weights, extra) in enumerate(rows):
        place = count * d + row
        by = np.einsum("nid,nidc->nc", weights, nodes)
        matrix[place, : count * d] = by[:, :d].ravel()
        matrix[place, count * d :] = by[:, d:-1].sum(axis=0) + extra
        rhs[place] = -by[:, -1].sum()
    extras = (setting.free, setting.parameter is not None)
    return Linearised(inner, nodes, ends[..., :d], matrix, rhs, extras, setting.isolated)


def _frequency(problem: Problem, periods: int) -> float:
    base = problem.base
    if base is None or not base > 0:
        raise OrbitError(f"the frequency of the excitation must stay positive, it became {base}")
    return base / periods


def _cyclic(ends: Floats, extras: int) -> tuple[Floats, Floats]:
    """The rows δy_{n+1} − Φ_n δy_n − E δz = gap; those of the conditions are left zero."""
    count, d = ends.shape[:2]
    size = count * d
    matrix, right = np.zeros((size + extras, size + extras)), np.zeros(size + extras)
    blocks = matrix[:size, :size].reshape(count, d, count, d)
    cells = np.arange(count)
    blocks[cells, :, cells, :] -= ends[..., :d]
    blocks[cells, :, (cells + 1) % count, :] += np.eye(d)
    matrix[:size, size:] = -ends[..., d:-1].reshape(size, extras)
    right[:size] = ends[..., -1].ravel()
    return matrix, right


def _conditions(setting: Setting, curve: Curve) -> list[tuple[Floats, Floats]]:
    """For each further unknown: weights of the states at the nodes, and of the unknowns."""
    extras = int(setting.free) + int(setting.parameter is not None)
    measure = curve.length / (2 * np.pi) * curve.table.weights[None, :, None] / setting.scale**2
    rows = []
    if setting.free:
        rows.append((measure * curve.slopes, np.zeros(extras)))
    if setting.tangent is not None:
        tangent = setting.tangent
        own = np.zeros(extras)
        own[-1] = tangent.value / setting.unit**2
        rows.append((measure * tangent.states / len(setting.scale), own))
    return rows


def newton(setting: Setting, curve: Curve) -> tuple[Curve, Linearised, float]:
    """Newton's method from a guess.

    Returns
    -------
    curve : Curve
    linearised : Linearised
        Where the last step began: for its transition matrices.
    noise : float
        Size of the last step, over that of the motion: what rounding makes of the equations.

    Raises
    ------
    OrbitError
        If it does not converge.
    """
    if not setting.free:
        curve = replace(curve, frequency=_frequency(setting.of(curve.value), setting.periods))
    close, size = False, np.inf
    for _ in range(STEPS):
        linearised = linearise(setting, curve)
        step = linearised.change()
        size = float(np.abs(step.states / setting.scale).max())
        size = max(size, abs(step.frequency) / curve.frequency, abs(step.value) / setting.unit)
        curve = curve.moved(step, min(1.0, REACH / size) if size > 0 else 1.0)
        if not setting.free:
            curve = replace(curve, frequency=_frequency(setting.of(curve.value), setting.periods))
        if size < NOISE or (close and size < CLOSE):
            return curve, linearised, size
        close = size < CLOSE
    raise OrbitError(
        f"no periodic orbit is found near the guess: after {STEPS} Newton steps the last one is "
        f"still {size:.1e} of the motion"
    )
