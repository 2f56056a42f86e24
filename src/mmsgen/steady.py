"""Steady motions of a slow flow beside periodic orbits of the unexpanded equations.

With small parameters and detunings as powers of ε, an equilibrium B of a slow flow of order N
solves Σ_{p≤N} ε^p R_p(B) = 0; what is omitted, ε^{N+1} R_{N+1}, moves it by ε^{N+1} over the
Jacobian, which is of order ε: by O(ε^N), where that Jacobian is regular. The eigenvalues of the
Jacobian itself, a sum of ε^p ∂R_p, then err by ε^{N+1} from what is omitted and by ε·ε^N from where
it is taken: O(ε^{N+1}). A saddle-node is regular in the enlarged system F = 0, F_B v = 0 with the
detuning as one more unknown, of size ε like F itself, and errs there by O(ε^{N+1}).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd, lcm
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy  # loads its subpackages when they are first used

from . import orbits
from .consistency import arguments_of
from .errors import CertificateError
from .motion import Reconstruction, reconstruction
from .runtime._flow import jacobian

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["Steady", "SteadyState", "exact_fold", "exact_orbit", "slow_fold", "steady_state"]

STEPS = 60
"""Newton steps at most; from a guess within a tenth, six are usual."""

RANK = 1e-9
"""Singular values below this, over the largest, belong to directions of a symmetry."""

DENOMINATOR = 24
"""Largest denominator of a ratio of frequencies in a periodic motion."""

COMMENSURATE = 1e-9
"""How well two frequencies must be of a rational ratio."""

SHIFT = 1e-4
"""Step along the family at a fold, over the amplitudes; only its direction is used."""


@dataclass(frozen=True)
class Steady:
    """Which steady motion of a case to certify, and where.

    Attributes
    ----------
    values : mapping
        Symbol or name → number at ε = 1, of the parameters and detunings of the slow flow.
    amplitudes : sequence of complex
        B_j at ε = 1, near the equilibrium or the saddle-node of order 1.
    fold : bool
        Whether a saddle-node is meant: the value of the first detuning is then a guess.
    """

    values: Mapping[Any, float]
    amplitudes: Sequence[complex]
    fold: bool = False


@dataclass(frozen=True, eq=False)
class SteadyState:
    """An equilibrium of a slow flow at numbers, as a periodic motion.

    Attributes
    ----------
    amplitudes : numpy.ndarray of complex, shape (n,)
        B_j.
    turning : numpy.ndarray, shape (n,)
        Rate at which each drifts along the symmetries, rad/s.
    values : mapping
        Of the slow flow.
    exact : mapping
        Of the unexpanded equations.
    shape : Reconstruction
        Coordinates and velocities from the amplitudes.
    drift : numpy.ndarray, shape (symmetries,)
        Rates along the symmetries, of which `turning` consists.
    """

    amplitudes: Any
    turning: Any
    values: Mapping[str, float]
    exact: Mapping[str, float]
    shape: Reconstruction = field(repr=False)
    drift: Any = ()

    @property
    def rates(self) -> Any:
        """Frequencies of the amplitudes' own harmonics, drift included, shape (n,)."""
        return self.shape.rates[: len(self.amplitudes)] + self.turning

    def motion(self, times: Any, amplitudes: Any = None) -> Any:
        """States (2n, times)."""
        b = self.amplitudes if amplitudes is None else amplitudes
        t = np.asarray(times, dtype=float)
        return self.shape(t, b[:, None] * np.exp(1j * np.multiply.outer(self.turning, t)))

    def frequency(self, base: float | None) -> tuple[float, int]:
        """Frequency of the motion, and how many periods of the excitation it takes.

        Parameters
        ----------
        base : float or None
            Frequency of the excitation in rad/s.

        Raises
        ------
        CertificateError
            If frequencies are not of rational ratios, so that the motion is not periodic.
        """
        active = np.abs(self.rates[np.abs(self.amplitudes) > 0])
        if base is None and not len(active):
            raise CertificateError("this equilibrium is a state of rest, not a periodic motion")
        unit = float(active[0]) if base is None else base
        ratios = [Fraction(float(r) / unit).limit_denominator(DENOMINATOR) for r in active]
        for rate, ratio in zip(active, ratios, strict=True):
            if abs(float(ratio) - rate / unit) > COMMENSURATE or not ratio:
                raise CertificateError(
                    f"the steady motion is not periodic: {rate:.9g} and {unit:.9g} rad/s have no "
                    "simple ratio"
                )
        periods = lcm(*(r.denominator for r in ratios))
        if base is not None:
            return base / periods, periods
        whole = gcd(*(int(r * periods) for r in ratios))
        return unit * whole / periods, 1


def steady_state(
    case: Expansion,
    module: Any,
    values: Mapping[str, float],
    exact: Mapping[str, float],
    guess: Any,
) -> SteadyState:
    """The equilibrium of the emitted slow flow near a guess, by Newton's method.

    Parameters
    ----------
    case : Expansion
    module : module
        The emitted functions.
    values, exact : mapping
        As `scaled_values` gives them.
    guess : array_like of complex, shape (n,)

    Raises
    ------
    CertificateError
        If there is none near the guess.
    """
    table = case.slow_flow.table
    flow, coefficients = table.flow, table.numbers(values)
    symmetries = np.array(flow.symmetries, dtype=float).reshape(-1, flow.n)
    arguments = arguments_of(module.slow_flow, values)
    b = np.array(guess, dtype=complex)
    drift = np.zeros(len(symmetries))
    scale = float(np.abs(b).max()) or 1.0
    for _ in range(STEPS):
        turn = drift @ symmetries
        gap = module.slow_flow(b, **arguments) - 1j * turn * b
        matrix = jacobian(flow, coefficients, b, drift)
        by_drift = [_pairs(-2j * k * b) for k in symmetries]
        full = np.column_stack([matrix, *by_drift])
        step = np.linalg.lstsq(full, -_pairs(2 * gap), rcond=RANK)[0]
        change = (step[: 2 * flow.n : 2] + 1j * step[1 : 2 * flow.n : 2]) / 2
        share = min(1.0, 0.5 * scale / (np.abs(change).max() or 1.0))
        b, drift = b + share * change, drift + share * step[2 * flow.n :]
        if np.abs(change).max() < 1e-13 * scale:
            shape = reconstruction(case, values)
            own = np.where(np.abs(b) < 1e-12 * scale, 0.0, b)
            return SteadyState(own, drift @ symmetries, values, exact, shape, drift)
    raise CertificateError(f"no equilibrium of the slow flow is found near {list(guess)}")


def _pairs(column: Any) -> Any:
    """Real and imaginary parts in turn."""
    return np.stack([column.real, column.imag], axis=-1).ravel()


def exact_problem(case: Expansion, exact: Mapping[str, float]) -> orbits.Mechanical:
    """The unexpanded equations at numbers."""
    eom = case.weak.scaled.eom
    return orbits.problem(eom, {p.name: exact[p.name] for p in eom.parameters if p.name in exact})


def exact_orbit(case: Expansion, state: SteadyState) -> orbits.PeriodicOrbit:
    """The periodic orbit of the unexpanded equations near an equilibrium.

    Raises
    ------
    CertificateError
        If the motion is not periodic.
    OrbitError
        If no orbit is found.
    """
    problem = exact_problem(case, state.exact)
    frequency, periods = state.frequency(problem.base)
    period = None if problem.base is not None else 2 * np.pi / frequency
    return orbits.find(problem, state.motion, period, periods=periods)


def amplitude_gap(
    case: Expansion, state: SteadyState, orbit: orbits.PeriodicOrbit, power: Any
) -> Any:
    """Largest difference of harmonics' amplitudes, in units of the coordinates, and its floor.

    Of every coordinate those harmonics are compared that are an amplitude's own; of the motion
    that is made of the equilibrium, and of the exact orbit.

    Parameters
    ----------
    power : numpy.ndarray, shape (n,)
        ε to the order of each coordinate.
    """
    n = len(state.amplitudes)
    active = np.abs(state.amplitudes) > 0
    frequency, _ = state.frequency(orbit.problem.base)
    numbers = np.unique(np.rint(np.abs(state.rates[active]) / frequency).astype(int))
    count = 8 * (int(numbers.max(initial=1)) + 8)
    times = 2 * np.pi / frequency * np.arange(count) / count
    own = 2 * np.abs(np.fft.rfft(state.motion(times)[:n], axis=1))[:, numbers] / count
    exact = 2 * np.abs(orbit.harmonics(numbers)[:n])
    gap = np.abs(own - exact).max(axis=1, initial=0.0) / power
    return float(gap.max()), float((2 * orbit.error[:n] / power).max())


def exponent_gap(case: Expansion, state: SteadyState, orbit: orbits.PeriodicOrbit) -> Any:
    """Largest distance of multipliers over the period, in 1/s, and its floor.

    Over one period of the motion the amplitudes are turned by their own frequencies and changed
    by e^{JT}; that product has the multipliers that the slow flow predicts.
    """
    table = case.slow_flow.table
    plain = jacobian(table.flow, table.numbers(state.values), state.amplitudes)
    n, period = len(state.amplitudes), orbit.period
    for j in range(n):
        block = slice(2 * j, 2 * j + 2)
        plain[block, block] -= state.turning[j] * np.array([[0.0, -1.0], [1.0, 0.0]])
    turned = scipy.linalg.expm(plain * period)
    for j, angle in enumerate(state.rates * period):
        c, s = np.cos(angle), np.sin(angle)
        turned[2 * j : 2 * j + 2] = np.array([[c, -s], [s, c]]) @ turned[2 * j : 2 * j + 2]
    predicted = np.linalg.eigvals(turned)
    distance = np.abs(predicted[:, None] - orbit.multipliers[None, :])
    rows, columns = scipy.optimize.linear_sum_assignment(distance)
    floor = float(orbit.multiplier_errors.max()) / period
    return float(distance[rows, columns].max()) / period, floor


def slow_fold(
    case: Expansion, module: Any, values: Mapping[str, float], guess: Any
) -> tuple[dict[str, float], Any, Any]:
    """A saddle-node of the emitted slow flow in its first detuning, near a guess.

    Solves F = 0, F_x v = 0, (guess of v)·v = 1 in the Cartesian amplitudes x, v and the detuning.

    Returns
    -------
    values : dict
        With the detuning of the saddle-node.
    amplitudes : numpy.ndarray of complex, shape (n,)
    direction : numpy.ndarray of complex, shape (n,)
        Along which two equilibria meet there.

    Raises
    ------
    CertificateError
        If none is found, or the slow flow has a symmetry.
    """
    table, sigma = case.slow_flow.table, str(case.relations[0].detuning.name)
    flow = table.flow
    if flow.symmetries:
        raise CertificateError("saddle-nodes of free motions are not certified")
    start = np.array(guess, dtype=complex)
    size, unit = float(np.abs(start).max()), abs(values[sigma]) or 1.0

    def at(level: float) -> dict[str, float]:
        return {**values, sigma: level * unit}

    def matrix(level: float, b: Any) -> Any:
        return jacobian(flow, table.numbers(at(level)), b) / unit

    def split(z: Any) -> tuple[Any, Any, float]:
        both = (z[:-1:2] + 1j * z[1:-1:2]) / 2
        return both[: flow.n] * size, both[flow.n :], float(z[-1])

    first = values[sigma] / unit
    *_, rows = np.linalg.svd(matrix(first, start))
    heading = rows[-1]

    def equations(z: Any) -> Any:
        b, v, level = split(z)
        gap = module.slow_flow(b, **arguments_of(module.slow_flow, at(level)))
        direction = _pairs(2 * v)
        return np.concatenate(
            [
                _pairs(2 * gap) / (unit * size),
                matrix(level, b) @ direction,
                [heading @ direction - 1],
            ]
        )

    z = np.concatenate([_pairs(2 * start) / size, heading, [first]])
    found = scipy.optimize.root(equations, z, tol=1e-14)
    if np.abs(found.fun).max() > 1e-11:
        raise CertificateError(f"no saddle-node is found near {sigma} = {values[sigma]:g}")
    b, v, level = split(found.x)
    return at(level), b, v * size


def exact_fold(case: Expansion, state: SteadyState, direction: Any, unit: float) -> orbits.Special:
    """The fold of exact periodic orbits near a saddle-node.

    Parameters
    ----------
    case : Expansion
    state : SteadyState
        At the saddle-node.
    direction : numpy.ndarray of complex, shape (n,)
    unit : float
        Size of the detuning.
    """
    problem = exact_problem(case, state.exact)
    (pivot,) = case.relations[0].lhs.free_symbols
    frequency, periods = state.frequency(problem.base)
    period = None if problem.base is not None else 2 * np.pi / frequency

    def along(times: Any) -> Any:
        return state.motion(times, state.amplitudes + SHIFT * direction) - state.motion(times)

    return orbits.fold(
        problem, state.motion, along, str(pivot.name), unit, period=period, periods=periods
    )
