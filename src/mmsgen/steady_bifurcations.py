"""Bifurcations of a slow flow's equilibria beside those of periodic orbits of the exact equations.

A bifurcation in a detuning σ is a regular solution of an enlarged system, F = 0 and F_B v = iωv
with |v| fixed, in which σ is one more unknown:

| slow flow | F = 0 | v | exact periodic orbits |
|---|---|---|---|
| saddle-node | of all amplitudes | real, ω = 0 | fold |
| pitchfork | of those that move before it | real, ω = 0, of the others | a multiplier is ±1 |
| Hopf | of all amplitudes | complex | a pair of multipliers has modulus 1 |

All parts of that system are of size ε like F itself, and what a slow flow of order N omits is
ε^{N+1}: σ, which is of size ε too, and ω err by O(ε^{N+1}).

Sources: Moore & Spence, *SIAM J. Numer. Anal.* 17 (1980) 567 (saddle-nodes); Werner & Spence, ibid.
21 (1984) 388 (pitchforks, by the symmetry that they break); Griewank & Reddien, *IMA J. Numer.
Anal.* 3 (1983) 295 (Hopf points).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy  # loads its subpackages when they are first used

from . import orbits
from .consistency import arguments_of
from .errors import CertificateError
from .runtime._flow import jacobian
from .sampling import scaled_values
from .steady import SteadyState, exact_problem, pairs, predicted_multipliers

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = [
    "SlowBifurcation",
    "exact_bifurcation",
    "flow_power",
    "frequency_gap",
    "slow_bifurcation",
]

SHIFT = 1e-4
"""Step along the family at a fold, over the amplitudes; only its direction is used."""

SOLVED = 1e-11
"""What rounding leaves of the enlarged system, whose parts are of size one."""


@dataclass(frozen=True, eq=False)
class SlowBifurcation:
    """A bifurcation of equilibria in a detuning.

    Attributes
    ----------
    kind : str
    values : dict
        Of the slow flow, with the detuning of the bifurcation.
    amplitudes : numpy.ndarray of complex, shape (n,)
    direction : numpy.ndarray of complex, shape (n,)
        Along which equilibria meet at a saddle-node, or a pitchfork's new ones appear.
    unit : float
        Size of the Jacobian in 1/s, by which changes of the detuning are measured.
    """

    kind: str
    values: dict[str, float]
    amplitudes: Any
    direction: Any
    unit: float


class _Enlarged:
    """F = 0, F_B v = iωv, (guess of v)·v = 1 in units in which all of it is of size one.

    The unknowns are x of the amplitudes that move, v (its real and then its imaginary part), ω and
    the detuning.
    """

    def __init__(self, case: Expansion, module: Any, values: Mapping[str, float], sigma: str):
        self.table, self.module = case.slow_flow.table, module
        self.values, self.sigma = values, sigma
        self.n = self.table.flow.n

    def prepare(self, kind: str, start: Any) -> Any:
        """Choose the unknowns; their starting values."""
        whole = self.matrix(self.values, start)
        self.size = float(np.abs(start).max()) or 1.0
        self.unit = float(np.abs(whole).max())
        moving = np.ones(self.n, dtype=bool) if kind != "pitchfork" else np.abs(start) > 0
        self.moving = np.repeat(moving, 2)
        self.disturbed = ~self.moving if kind == "pitchfork" else np.ones(2 * self.n, dtype=bool)
        self.turning = kind == "Hopf"
        block = whole[np.ix_(self.disturbed, self.disturbed)] / self.unit
        rates, vectors = np.linalg.eig(block)
        if self.turning:
            near = np.where(rates.imag > 0, np.abs(rates.real), np.inf)
        else:
            near = np.abs(rates)
        j = int(np.argmin(near))
        if not np.isfinite(near[j]):
            raise CertificateError("no pair of eigenvalues is complex near this Hopf point")
        own = vectors[:, j] / np.linalg.norm(vectors[:, j])
        if not self.turning:
            *_, rows = np.linalg.svd(block)
            own = rows[-1]
        self.heading = own
        x = pairs(2 * start)[self.moving] / self.size
        level = [self.values[self.sigma] / self.unit]
        if not self.turning:
            return np.concatenate([x, own, level])
        return np.concatenate([x, own.real, own.imag, [rates[j].imag], level])

    def split(self, z: Any) -> tuple[Any, Any, float, float]:
        """x and v of all amplitudes, ω and σ."""
        count, d = int(self.moving.sum()), int(self.disturbed.sum())
        x, v = np.zeros(2 * self.n), np.zeros(2 * self.n, dtype=complex)
        x[self.moving] = z[:count] * self.size
        v[self.disturbed] = z[count : count + d]
        if self.turning:
            v[self.disturbed] += 1j * z[count + d : count + 2 * d]
        omega = float(z[-2]) * self.unit if self.turning else 0.0
        return x, v, omega, float(z[-1]) * self.unit

    def at(self, level: float) -> dict[str, float]:
        """The values at a detuning."""
        return {**self.values, self.sigma: level}

    def matrix(self, values: Mapping[str, float], b: Any) -> Any:
        """F_B, the emitted one if there is one."""
        own = getattr(self.module, "jacobian", None)
        if own is None:
            return jacobian(self.table.flow, self.table.numbers(values), b)
        return own(b, **arguments_of(own, values))

    def __call__(self, z: Any) -> Any:
        """What is left of the equations."""
        x, v, omega, level = self.split(z)
        b, known = (x[::2] + 1j * x[1::2]) / 2, self.at(level)
        gap = pairs(2 * self.module.slow_flow(b, **arguments_of(self.module.slow_flow, known)))
        matrix = self.matrix(known, b)
        moved = ((matrix @ v - 1j * omega * v) / self.unit)[self.disturbed]
        norm = self.heading.conj() @ v[self.disturbed] - 1
        parts = [gap[self.moving] / (self.unit * self.size), moved.real, [norm.real]]
        if self.turning:
            parts += [moved.imag, [norm.imag]]
        return np.concatenate(parts)


def slow_bifurcation(
    case: Expansion, module: Any, values: Mapping[str, float], kind: str, sigma: str, guess: Any
) -> SlowBifurcation:
    """A bifurcation of the emitted slow flow in a detuning, near a guess.

    Parameters
    ----------
    case : Expansion
    module : module
        The emitted functions.
    values : mapping
        Of the slow flow; that of the detuning is a guess.
    kind : str
        ``"saddle-node"``, ``"pitchfork"`` or ``"Hopf"``.
    sigma : str
        The detuning.
    guess : array_like of complex, shape (n,)
        The amplitudes there.

    Raises
    ------
    CertificateError
        If none is found, or the slow flow has a symmetry.
    """
    if case.slow_flow.table.flow.symmetries:
        raise CertificateError(f"a {kind} of free motions is not certified")
    start = np.array(guess, dtype=complex)
    if kind == "pitchfork" and np.abs(start).all():
        raise CertificateError(
            "a pitchfork is certified where amplitudes appear: give zero for these"
        )
    system = _Enlarged(case, module, values, sigma)
    found = scipy.optimize.root(system, system.prepare(kind, start), tol=1e-14)
    if not np.abs(found.fun).max() <= SOLVED:
        raise CertificateError(f"no {kind} is found near {sigma} = {values[sigma]:g}")
    x, v, _, level = system.split(found.x)
    b, way = ((y[::2] + 1j * y[1::2]) / 2 for y in (x, v.real))
    return SlowBifurcation(kind, system.at(level), b, way * system.size, system.unit)


def flow_power(
    case: Expansion,
    values: Mapping[str, float],
    sigma: str,
    weights: Any,
    guess: Any,
    epsilon: float,
) -> int:
    """The power of ε with which the slow flow falls, but for a detuning: that of its first order.

    Parameters
    ----------
    case : Expansion
    values : mapping
        At ε = 1.
    sigma : str
        The detuning.
    weights : numpy.ndarray, shape (n,)
        Order of each coordinate.
    guess : numpy.ndarray of complex, shape (n,)
        Amplitudes at ε = 1.
    epsilon : float
        A small one.
    """
    table, sizes = case.slow_flow.table, []
    for small in (epsilon, 2 * epsilon):
        slow, _ = scaled_values(case, {**values, sigma: 0.0}, small)
        own = jacobian(table.flow, table.numbers(slow), small**weights * guess)
        sizes.append(float(np.abs(own).max()))
    return max(1, round(np.log2(sizes[1] / sizes[0]))) if sizes[0] > 0 else 1


def exact_bifurcation(
    case: Expansion, state: SteadyState, slow: SlowBifurcation, pivot: str
) -> orbits.Special:
    """The bifurcation of exact periodic orbits near one of the slow flow.

    Parameters
    ----------
    case : Expansion
    state : SteadyState
        At the bifurcation.
    slow : SlowBifurcation
    pivot : str
        The frequency that is detuned.

    Raises
    ------
    OrbitError
        If none is found.
    """
    problem = exact_problem(case, state.exact)
    frequency, periods = state.frequency(problem.base)
    period = None if problem.base is not None else 2 * np.pi / frequency
    if slow.kind != "saddle-node":
        critical = _critical(case, state)
        return orbits.crossing(
            problem, state.motion, critical, pivot, slow.unit, period=period, periods=periods
        )

    def along(times: Any) -> Any:
        shifted = state.amplitudes + SHIFT * slow.direction
        return state.motion(times, shifted) - state.motion(times)

    return orbits.fold(
        problem, state.motion, along, pivot, slow.unit, period=period, periods=periods
    )


def _critical(case: Expansion, state: SteadyState) -> complex:
    """The multiplier that the slow flow predicts on the unit circle."""
    frequency, _ = state.frequency(exact_problem(case, state.exact).base)
    own = predicted_multipliers(case, state, 2 * np.pi / frequency)
    return complex(own[np.argmin(np.abs(np.log(np.abs(own))))])


def frequency_gap(
    case: Expansion, state: SteadyState, special: orbits.Special
) -> tuple[float, float]:
    """Distance of the frequencies with which disturbances turn at a Hopf point, and its floor.

    Modulo the frequency of the motion, in rad/s.
    """
    critical, exact = _critical(case, state), special.orbit.multipliers
    j = int(np.argmin(np.abs(exact - critical)))
    angle = float(np.angle(exact[j] / critical))
    period = special.orbit.period
    return abs(angle) / period, float(special.orbit.multiplier_errors[j]) / period
