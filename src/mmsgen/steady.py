"""Steady motions of a slow flow beside periodic orbits of the unexpanded equations.

With small parameters and detunings as powers of ε, an equilibrium B of a slow flow of order N
solves Σ_{p≤N} ε^p R_p(B) = 0; what is omitted, ε^{N+1} R_{N+1}, moves it by ε^{N+1} over the
Jacobian, which is of order ε: by O(ε^N), where that Jacobian is regular. The eigenvalues of the
Jacobian itself, a sum of ε^p ∂R_p, then err by ε^{N+1} from what is omitted and by ε·ε^N from where
it is taken: O(ε^{N+1}).
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
from .errors import CertificateError, MmsgenError
from .motion import Reconstruction, reconstruction
from .runtime._flow import jacobian

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["KINDS", "Steady", "SteadyState", "exact_orbit", "steady_state"]

KINDS = ("saddle-node", "pitchfork", "Hopf")
"""Bifurcations whose places are certified."""

STEPS = 60
"""Newton steps at most; from a guess within a tenth, six are usual."""

RANK = 1e-9
"""Singular values below this, over the largest, belong to directions of a symmetry."""

DENOMINATOR = 24
"""Largest denominator of a ratio of frequencies in a periodic motion."""

COMMENSURATE = 1e-9
"""How well two frequencies must be of a rational ratio."""


@dataclass(frozen=True)
class Steady:
    """Which steady motion of a case to certify, and where.

    Attributes
    ----------
    values : mapping
        Symbol or name → number at ε = 1, of the parameters and detunings of the slow flow.
    amplitudes : sequence of complex
        B_j at ε = 1, near the equilibrium or the bifurcation of order 1. At a pitchfork those that
        appear there are zero.
    bifurcation : str
        ``"saddle-node"``, ``"pitchfork"`` or ``"Hopf"`` where one is meant: the value of the
        detuning is then a guess.
    over : str or sympy.Symbol
        That detuning; by default the first one.
    cycle : bool
        Whether the limit cycle is meant on which a motion of the slow flow from these amplitudes
        ends, and the quasi-periodic motion that it stands for.

    Raises
    ------
    MmsgenError
        If there is no bifurcation of that name.
    """

    values: Mapping[Any, float]
    amplitudes: Sequence[complex]
    bifurcation: str = ""
    over: Any = ""
    cycle: bool = False

    def __post_init__(self) -> None:
        if self.bifurcation and self.bifurcation not in KINDS:
            raise MmsgenError(
                f"the bifurcation must be one of {', '.join(KINDS)}, got {self.bifurcation!r}"
            )
        if self.bifurcation and self.cycle:
            raise MmsgenError("a limit cycle is no bifurcation: ask for one of both")


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
        by_drift = [pairs(-2j * k * b) for k in symmetries]
        full = np.column_stack([matrix, *by_drift])
        step = np.linalg.lstsq(full, -pairs(2 * gap), rcond=RANK)[0]
        change = (step[: 2 * flow.n : 2] + 1j * step[1 : 2 * flow.n : 2]) / 2
        share = min(1.0, 0.5 * scale / (np.abs(change).max() or 1.0))
        b, drift = b + share * change, drift + share * step[2 * flow.n :]
        if np.abs(change).max() < 1e-13 * scale:
            shape = reconstruction(case, values)
            own = np.where(np.abs(b) < 1e-12 * scale, 0.0, b)
            return SteadyState(own, drift @ symmetries, values, exact, shape, drift)
    raise CertificateError(f"no equilibrium of the slow flow is found near {list(guess)}")


def pairs(column: Any) -> Any:
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


def predicted_multipliers(case: Expansion, state: SteadyState, period: float) -> Any:
    """Multipliers that the slow flow predicts, shape (2n,).

    Over one period of the motion the amplitudes are turned by their own frequencies and changed
    by e^{JT}; that product has them.
    """
    table = case.slow_flow.table
    plain = jacobian(table.flow, table.numbers(state.values), state.amplitudes)
    n = len(state.amplitudes)
    for j in range(n):
        block = slice(2 * j, 2 * j + 2)
        plain[block, block] -= state.turning[j] * np.array([[0.0, -1.0], [1.0, 0.0]])
    turned = scipy.linalg.expm(plain * period)
    for j, angle in enumerate(state.rates * period):
        c, s = np.cos(angle), np.sin(angle)
        turned[2 * j : 2 * j + 2] = np.array([[c, -s], [s, c]]) @ turned[2 * j : 2 * j + 2]
    return np.linalg.eigvals(turned)


def exponent_gap(case: Expansion, state: SteadyState, orbit: orbits.PeriodicOrbit) -> Any:
    """Largest distance of multipliers over the period, in 1/s, and its floor."""
    period = orbit.period
    predicted = predicted_multipliers(case, state, period)
    distance = np.abs(predicted[:, None] - orbit.multipliers[None, :])
    rows, columns = scipy.optimize.linear_sum_assignment(distance)
    floor = float(orbit.multiplier_errors.max()) / period
    return float(distance[rows, columns].max()) / period, floor
