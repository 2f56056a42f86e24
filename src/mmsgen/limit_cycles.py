"""Limit cycles of slow flows: quasi-periodic motions of the system itself.

The amplitudes then go round a closed curve, slowly, while the coordinates oscillate: the motion has
the cycle's frequency beside those of the oscillations. Cycles are periodic orbits of the Cartesian
slow flow, found and followed by `mmsgen.orbits`.

Where the slow flow is the same in every phase, B_j → B_j e^{i k_j θ}, a cycle may drift along that
symmetry, and need not close. It is found in a frame that turns with one amplitude, which is real
there: in it B_j is C_j, dC_j/dt = F_j(C) − i k_j ρ C_j, and the rate ρ follows from the amplitude
that has to stay real.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from numbers import Real
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp

from . import orbits
from .errors import OrbitError
from .numeric import finite_amplitudes
from .runtime._records import Bifurcation

if TYPE_CHECKING:
    from .slowflow import SlowFlow

__all__ = ["LimitCycle", "LimitCycles", "limit_cycle", "limit_cycles"]

SMALL = 1e-9
"""Amplitude, over the largest, that has no phase to turn with."""

TURNS = 60
"""Turns of the fastest disturbance after which transients are expected to be gone."""

LONGEST = 5.0
"""Period, over that at the Hopf point, at which a family of cycles is taken to end: it does so at
a homoclinic orbit, where the period grows beyond all bounds.
"""


@dataclass(frozen=True, eq=False)
class Form:
    """A slow flow in real states, turned so that no symmetry is left.

    Attributes
    ----------
    rates : mapping
        State → its rate.
    places : tuple of (int, int)
        For each state, its coordinate, and 0 for the real part of the amplitude, 1 for the other.
    count : int
        Number n of amplitudes.
    drifts : tuple of sympy.Expr
        The rate along each symmetry at which the frame turns.
    symmetries : tuple of tuple of int
    reference : tuple of int
        The amplitudes that are real, one for each symmetry.
    """

    rates: Mapping[sp.Symbol, sp.Expr]
    places: tuple[tuple[int, int], ...]
    count: int
    drifts: tuple[sp.Expr, ...]
    symmetries: tuple[tuple[int, ...], ...]
    reference: tuple[int, ...]

    def states(self, amplitudes: Any) -> Any:
        """The real states of amplitudes B_j.

        Raises
        ------
        OrbitError
            If there are not as many as coordinates, or one that the frame turns with is zero.
        MmsgenError
            If they are no finite numbers.
        """
        b = np.atleast_1d(finite_amplitudes(amplitudes))
        if b.shape != (self.count,):
            raise OrbitError(f"{self.count} amplitudes are needed, got an array of {b.shape}")
        if self.reference:
            own = b[list(self.reference)]
            if not np.abs(own).min() > SMALL * np.abs(b).max():
                raise OrbitError(
                    f"the frame turns with the amplitudes number {list(self.reference)}: begin "
                    "where they are not zero"
                )
            k = np.array(self.symmetries, dtype=float)
            angle = np.linalg.solve(k[:, list(self.reference)].T, -np.angle(own))
            b = b * np.exp(1j * (angle @ k))
        parts = 2 * np.stack([b.real, b.imag])
        return np.array([parts[i, j] for j, i in self.places])

    def amplitudes(self, states: Any) -> Any:
        """B_j of states (d, …), shape (n, …)."""
        b = np.zeros((self.count, *states.shape[1:]), dtype=complex)
        for row, (j, i) in zip(states, self.places, strict=True):
            b[j] += row * (0.5j if i else 0.5)
        return b


def form_of(slow: SlowFlow) -> Form:
    """The Cartesian slow flow without its symmetries.

    Raises
    ------
    ExpansionError
        If no frame makes it autonomous.
    """
    symmetries, whole = slow.table.flow.symmetries, slow.cartesian
    k = sp.Matrix(symmetries) if symmetries else sp.zeros(0, slow.table.flow.n)
    _, reference = k.rref()
    names = list(whole)
    at_rest = {names[2 * j + 1]: sp.S.Zero for j in reference}
    speeds = [whole[name].subs(at_rest) for name in names]
    turning = sp.Matrix([speeds[2 * j + 1] / names[2 * j] for j in reference])
    drifts = k[:, list(reference)].T.LUsolve(turning) if reference else sp.zeros(0, 1)
    rates, places = {}, []
    for place, name in enumerate(names):
        j, imaginary = divmod(place, 2)
        if name in at_rest:
            continue
        turn = sum((k[s, j] * drifts[s] for s in range(k.rows)), sp.S.Zero)
        other = names[place - 1] if imaginary else -at_rest.get(names[place + 1], names[place + 1])
        rates[name] = speeds[place] - turn * other
        places.append((j, imaginary))
    count = slow.table.flow.n
    return Form(rates, tuple(places), count, tuple(drifts), symmetries, tuple(reference))


@dataclass(frozen=True, eq=False, repr=False)
class LimitCycle:
    """A limit cycle of a slow flow.

    Attributes
    ----------
    orbit : PeriodicOrbit
        Of the slow flow in real states, u_1, v_1, u_2, … with B_j = (u_j + i v_j)/2, those left
        out that the frame keeps at zero; with multipliers, error estimates and a verdict.
    form : Form
        Of the slow flow.
    """

    orbit: orbits.PeriodicOrbit = field(repr=False)
    form: Form = field(repr=False)

    def __repr__(self) -> str:
        sizes = ", ".join(f"{low:.6g} … {high:.6g}" for low, high in self.modulus)
        return f"LimitCycle(period={self.period:.6g} s, a_j={sizes}, {self.verdict})"

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

    @property
    def multipliers(self) -> Any:
        """By which disturbances are multiplied in one period, complex; one of them is 1."""
        return self.orbit.multipliers

    def amplitudes(self, times: Any) -> Any:
        """B_j at times, shape (n, …), in the autonomous frame.

        With a symmetry, in the frame that turns with the first amplitude that it moves: this one
        is real.
        """
        return self.form.amplitudes(self.orbit(times))

    @property
    def modulus(self) -> Any:
        """Smallest and largest a_j = 2|B_j| over one period, shape (n, 2).

        Among 128 times, so that an extreme is good to the square of a 128th of the period.
        """
        sizes = 2 * np.abs(self.form.amplitudes(self.orbit.states))
        return np.stack([sizes.min(axis=1), sizes.max(axis=1)], axis=1)

    @property
    def drift(self) -> Any:
        """Mean rate along each symmetry in rad/s, shape (symmetries,)."""
        values = self.orbit.problem.values
        found = []
        for rate in self.form.drifts:
            known = rate.subs({s: values[str(s)] for s in rate.free_symbols if str(s) in values})
            function = sp.lambdify([list(self.form.rates)], known, "numpy")
            over = function(list(self.orbit.states))
            # equidistant times: the mean is good to all orders
            found.append(float(np.mean(np.broadcast_to(over, self.orbit.times.shape))))
        return np.array(found)


@dataclass(frozen=True, eq=False, repr=False)
class LimitCycles:
    """A family of limit cycles along a parameter.

    Attributes
    ----------
    path : Path
        The family of orbits, with its folds and bifurcations.
    form : Form
        Of the slow flow.
    """

    path: orbits.Path = field(repr=False)
    form: Form = field(repr=False)

    def __repr__(self) -> str:
        name, values = self.path.parameter, self.values
        across = f"{name}={values[0]:.6g} … {values[-1]:.6g}"
        return f"LimitCycles({len(values)} cycles, {across}, ends: {self.path.reason})"

    @property
    def values(self) -> Any:
        """Of the parameter, shape (m,)."""
        return self.path.values

    @property
    def cycles(self) -> tuple[LimitCycle, ...]:
        """The cycles, in the order along the family."""
        return tuple(LimitCycle(o, self.form) for o in self.path.orbits)


def problem_of(slow: SlowFlow, form: Form, values: Mapping[str, Any]) -> orbits.Autonomous:
    """The slow flow in real states at numbers."""
    occurring = set().union(*(e.free_symbols for e in form.rates.values()))
    needed = [p for p in slow.case.parameters if p.symbol in occurring]
    given = {p.name: values[p.name] for p in needed if p.name in values}
    return orbits.autonomous(form.rates, given, needed)


def keeps_volumes(slow: SlowFlow, values: Mapping[str, float]) -> bool:
    """Whether the divergence of the slow flow is zero at all amplitudes, so nothing attracts.

    Source: Arnold, *Mathematical Methods of Classical Mechanics* (1989), § 16 (Liouville).
    """
    whole = slow.cartesian
    divergence = sp.Add(*(rate.diff(state) for state, rate in whole.items()))
    own = divergence.free_symbols - set(whole)
    # exact numbers, so that a sum of them that is zero is 0
    known = {s: sp.Rational(values[str(s.name)]) for s in own if str(s.name) in values}
    return bool(sp.expand(divergence.subs(known)) == 0)


def limit_cycle(
    slow: SlowFlow, values: Mapping[str, Any], start: Sequence[complex], time: float | None
) -> LimitCycle:
    """The limit cycle that a motion of the slow flow ends on, see `SlowFlow.limit_cycle`."""
    form = form_of(slow)
    problem, state = problem_of(slow, form, values), form.states(start)
    if keeps_volumes(slow, problem.values):
        raise OrbitError(
            "with these numbers the slow flow is conservative, its divergence being zero: no "
            "motion ends on a limit cycle, since periodic ones come in families, each with the "
            "size that it began with; mg.orbits.find(…, isolated=False) finds one of them"
        )
    if time is not None and not (isinstance(time, Real) and 0 < time < np.inf):
        raise OrbitError(f"the time must be a positive number, got {time!r}")
    if time is None:
        rates = np.linalg.eigvals(problem.rates(np.zeros(1), state[:, None])[1][0])
        time = TURNS * 2 * np.pi / float(np.abs(rates).max())
    return LimitCycle(orbits.find(problem, *orbits.settle(problem, state, time)), form)


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
    form = form_of(slow)
    problem = problem_of(slow, form, {**values, over: hopf.parameter})
    state = form.states(hopf.amplitudes)
    first = orbits.born(problem, state, over, unit=high - low)
    # Cycles grow away from the point: on which side of it they are is theirs to say.
    value = first.problem.values[over]
    ahead = (high, low) if value > hopf.parameter else (low, high)
    own = {"longest": LONGEST * first.period, **options}
    return LimitCycles(orbits.follow(first.problem, first, over, ahead, **own), form)
