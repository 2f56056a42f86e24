"""Limit cycles of slow flows: quasi-periodic motions of the system itself.

The amplitudes then go round a closed curve, slowly, while the coordinates oscillate: the motion has
the cycle's frequency beside those of the oscillations. Cycles are periodic orbits of the Cartesian
slow flow, found and followed by `mmsgen.orbits`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from . import orbits
from .errors import OrbitError
from .runtime._records import Bifurcation

if TYPE_CHECKING:
    from .slowflow import SlowFlow

__all__ = ["LimitCycle", "LimitCycles", "limit_cycle", "limit_cycles"]

TURNS = 60
"""Turns of the fastest disturbance after which transients are expected to be gone."""

LONGEST = 5.0
"""Period, over that at the Hopf point, at which a family of cycles is taken to end: it does so at
a homoclinic orbit, where the period grows beyond all bounds.
"""


@dataclass(frozen=True, eq=False)
class LimitCycle:
    """A limit cycle of a slow flow.

    Attributes
    ----------
    orbit : PeriodicOrbit
        Of the Cartesian slow flow, states u_1, v_1, u_2, … with B_j = (u_j + i v_j)/2; with
        multipliers, error estimates and a verdict.
    """

    orbit: orbits.PeriodicOrbit = field(repr=False)

    @property
    def period(self) -> float:
        """In s."""
        return self.orbit.period

    @property
    def frequency(self) -> float:
        """In rad/s, by which the lines of the motion's spectrum are apart."""
        return 2 * np.pi / self.orbit.period

    @property
    def verdict(self) -> str:
        """``"stable"``, ``"unstable"`` or ``"undecided"``."""
        return self.orbit.verdict

    def amplitudes(self, times: Any) -> Any:
        """B_j at times, shape (n, …), in the autonomous frame."""
        states = self.orbit(times)
        return (states[::2] + 1j * states[1::2]) / 2

    @property
    def modulus(self) -> Any:
        """Smallest and largest a_j = 2|B_j| over one period, shape (n, 2).

        Among 128 times, so that an extreme is good to the square of a 128th of the period.
        """
        sizes = np.hypot(self.orbit.states[::2], self.orbit.states[1::2])
        return np.stack([sizes.min(axis=1), sizes.max(axis=1)], axis=1)


@dataclass(frozen=True, eq=False)
class LimitCycles:
    """A family of limit cycles along a parameter.

    Attributes
    ----------
    path : Path
        The family of orbits, with its folds and bifurcations.
    """

    path: orbits.Path = field(repr=False)

    @property
    def values(self) -> Any:
        """Of the parameter, shape (m,)."""
        return self.path.values

    @property
    def cycles(self) -> tuple[LimitCycle, ...]:
        """The cycles, in the order along the family."""
        return tuple(LimitCycle(o) for o in self.path.orbits)


def problem_of(slow: SlowFlow, values: Mapping[str, Any]) -> orbits.Autonomous:
    """The Cartesian slow flow at numbers.

    Raises
    ------
    OrbitError
        If the slow flow has a symmetry, along which cycles would drift.
    ExpansionError
        If no frame makes it autonomous.
    """
    if slow.table.flow.symmetries:
        raise OrbitError(
            "this slow flow is the same in every phase of its amplitudes, along which a cycle "
            "drifts: limit cycles are found for slow flows without such a symmetry"
        )
    rates = slow.cartesian
    occurring = set().union(*(e.free_symbols for e in rates.values()))
    needed = [p for p in slow.case.parameters if p.symbol in occurring]
    given = {p.name: values[p.name] for p in needed if p.name in values}
    return orbits.autonomous(rates, given, needed)


def _states(slow: SlowFlow, amplitudes: Any) -> Any:
    """u_1, v_1, … of amplitudes."""
    b = np.atleast_1d(np.asarray(amplitudes, dtype=complex))
    if b.shape != (len(slow.case.coordinates),):
        raise OrbitError(f"{len(slow.case.coordinates)} amplitudes are needed, got {b.shape}")
    return np.stack([2 * b.real, 2 * b.imag], axis=1).ravel()


def limit_cycle(
    slow: SlowFlow, values: Mapping[str, Any], start: Sequence[complex], time: float | None
) -> LimitCycle:
    """The limit cycle that a motion of the slow flow ends on, see `SlowFlow.limit_cycle`."""
    problem, state = problem_of(slow, values), _states(slow, start)
    if time is None:
        rates = np.linalg.eigvals(problem.rates(np.zeros(1), state[:, None])[1][0])
        time = TURNS * 2 * np.pi / float(np.abs(rates).max())
    return LimitCycle(orbits.find(problem, *orbits.settle(problem, state, time)))


def limit_cycles(
    slow: SlowFlow,
    values: Mapping[str, Any],
    hopf: Bifurcation,
    over: str,
    ends: tuple[float, float],
    **options: Any,
) -> LimitCycles:
    """Limit cycles from a Hopf point on, see `SlowFlow.limit_cycles`."""
    low, high = min(ends), max(ends)
    if hopf.kind != "Hopf":
        raise OrbitError(f"limit cycles begin at a Hopf point, not at a {hopf.kind}")
    if not low < hopf.parameter < high:
        raise OrbitError(f"the Hopf point, at {hopf.parameter:.6g}, is not in the range")
    problem = problem_of(slow, {**values, over: hopf.parameter})
    state = _states(slow, hopf.amplitudes)
    first = orbits.born(problem, state, over, unit=high - low)
    # Cycles grow away from the point: on which side of it they are is theirs to say.
    value = first.problem.values[over]
    ahead = (high, low) if value > hopf.parameter else (low, high)
    own = {"longest": LONGEST * first.period, **options}
    return LimitCycles(orbits.follow(first.problem, first, over, ahead, **own))
