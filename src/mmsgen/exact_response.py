"""Periodic orbits of the unexpanded equations where a slow flow has its equilibria.

An equilibrium stands for a periodic motion. The motion that the expansion makes of it is where the
search for the exact one begins; nothing else of the expansion enters.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import orbits
from .errors import MmsgenError, OrbitError
from .motion import reconstruction
from .numeric import finite_amplitudes, real_numbers
from .parameters import by_key
from .runtime._records import Branch, Response
from .sampling import scaled_values
from .steady import SteadyState, exact_orbit

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .expansion import Expansion

__all__ = ["ExactPoint", "OrbitNear", "orbit_near", "orbits_along"]

ELSEWHERE = 0.5
"""Relative change of the amplitudes from which a periodic orbit is another one than was meant."""

WHOLE = 1e-6
"""How far from a whole number the turns of an amplitude in one period may be by rounding."""


@dataclass(frozen=True, eq=False)
class OrbitNear:
    """A periodic orbit of the exact equations near an equilibrium of a slow flow.

    Attributes
    ----------
    orbit : PeriodicOrbit
        With its multipliers and errors.
    amplitudes : numpy.ndarray, shape (n,)
        Of each coordinate, its harmonic at the frequency of its own amplitude: what a_j = 2|B_j|
        approximates; zero where the orbit has no such harmonic.
    stable : bool
        Whether the verdict on the orbit is "stable".
    """

    orbit: orbits.PeriodicOrbit
    amplitudes: NDArray[np.float64]
    stable: bool


class ExactPoint(NamedTuple):
    """A periodic orbit as a point beside a response.

    Attributes
    ----------
    parameter : float
        Value of the parameter that varies.
    amplitudes : numpy.ndarray, shape (n,)
    stable : bool
    """

    parameter: float
    amplitudes: NDArray[np.float64]
    stable: bool


def orbit_near(
    case: Expansion, values: Mapping[Any, Any], amplitudes: Any, drift: Any = ()
) -> OrbitNear:
    """The periodic orbit of the unexpanded equations near an equilibrium.

    Parameters
    ----------
    case : Expansion
    values : mapping
        Symbol or name → number, of the slow flow's parameters and detunings.
    amplitudes : array_like of complex, shape (n,)
        B_j of the equilibrium; its motion is the first guess.
    drift : array_like, shape (g,)
        Rate along each symmetry in rad/s, as in `Equilibria`; at rest by default.

    Returns
    -------
    OrbitNear

    Raises
    ------
    OrbitError
        If none is found there, or orbits are not isolated.
    CertificateError
        If the motion is not periodic, as where frequencies have no simple ratio.
    MmsgenError
        If there is not one amplitude for each coordinate; for wrong values.
    """
    b = finite_amplitudes(amplitudes)
    if b.shape != (len(case.coordinates),):
        raise MmsgenError(
            f"{len(case.coordinates)} amplitudes are needed, got an array of shape {b.shape}"
        )
    known = case.slow_flow._with_detunings(values)
    for name, v in known.items():
        if np.ndim(v):
            raise MmsgenError(f"{name} must be one number here, got an array of shape {v.shape}")
    slow, exact = scaled_values(case, {n: float(v) for n, v in known.items()}, 1.0)
    flow = case.slow_flow.table.flow
    symmetries = np.array(flow.symmetries, dtype=float).reshape(-1, flow.n)
    rates = np.zeros(len(symmetries))
    if np.size(drift):
        rates = np.asarray(drift, dtype=float)
    state = SteadyState(b, rates @ symmetries, slow, exact, reconstruction(case, slow))
    orbit = exact_orbit(case, state)
    # The orbit's own frequency may be far from that of the slow flow, whose ratios are exact.
    turns = np.abs(state.rates) / state.frequency(orbit.problem.base)[0]
    # A coordinate at rest may have a frequency that the motion of the others does not have.
    numbers = [round(x) if abs(x - round(x)) < WHOLE else None for x in turns]
    own = np.array([0.0 if k is None else orbit.amplitude(j, k) for j, k in enumerate(numbers)])
    return OrbitNear(orbit, own, orbit.verdict == "stable")


def orbits_along(
    case: Expansion,
    values: Mapping[Any, Any],
    response: Response,
    count: int = 20,
    *,
    largest: Any = np.inf,
) -> tuple[ExactPoint, ...]:
    """Periodic orbits of the unexpanded equations along the branches of a response.

    They are spread evenly over the length of the curves, stable and unstable ones alike. States of
    rest are passed over. So is a place where no orbit is found, or one of other amplitudes than
    half or one and a half of those expected, as happens close to a saddle-node, beyond which the
    exact equations may have none.

    Parameters
    ----------
    case : Expansion
    values : mapping
        As for `frequency_response`; what they hold for the parameter that varies is not used.
    response : Response
        Of the slow flow of this case.
    count : int
        How many, about.
    largest : array_like, shape (n,)
        Real amplitudes above which a slow flow is not to be believed; equilibria out there are
        passed over.

    Returns
    -------
    tuple of ExactPoint
        In the order along the branches; `plotting.frequency_response` takes them as ``points``.
    """
    found = []
    numbers = {name: real_numbers(name, v) for name, v in by_key(values)}
    given = {name: v for name, v in numbers.items() if v.ndim == 0}
    for branch, places in zip(response.branches, _places(response, count, largest), strict=True):
        for k in places:
            here = float(branch.parameter[k])
            own = {**given, response.name: here}
            try:
                near = orbit_near(case, own, branch.amplitudes[k], branch.drift[k])
            except OrbitError:
                continue
            expected = branch.modulus[k]
            if np.abs(near.amplitudes - expected).max() < ELSEWHERE * expected.max():
                found.append(ExactPoint(here, near.amplitudes, near.stable))
    return tuple(found)


def _places(response: Response, count: int, largest: Any) -> list[NDArray[np.int64]]:
    """For each branch the points that lie evenly along the curves, `count` on all of them."""
    if not isinstance(count, int) or count < 1:
        raise MmsgenError(f"count must be a whole number, at least 1, got {count!r}")
    branches = response.branches
    shown = [_shown(b, largest) for b in branches]
    lengths = _lengths(branches, shown)
    total = sum(own[-1] for own in lengths)
    places = []
    for use, own in zip(shown, lengths, strict=True):
        at = np.flatnonzero(use)
        number = max(1, round(count * own[-1] / total)) if len(at) and total > 0 else len(at[:1])
        # in the middle of as many equal pieces, so that no two branches meet in a point
        wanted = own[-1] * (np.arange(number) + 0.5) / max(number, 1)
        nearest = np.minimum(np.searchsorted(own[at], wanted), len(at) - 1)
        places.append(np.unique(at[nearest]))
    return places


def _shown(branch: Branch, largest: Any) -> NDArray[np.bool_]:
    """Where there is a motion, and not too large a one."""
    moving = (branch.modulus > 0).any(axis=1)
    return np.asarray(moving & (branch.modulus <= largest).all(axis=1))


def _lengths(
    branches: Sequence[Branch], shown: Sequence[NDArray[np.bool_]]
) -> list[NDArray[np.float64]]:
    """Length along each branch, in units of the extent of all; what is not shown adds none."""
    if not any(use.any() for use in shown):
        return [np.zeros(len(use)) for use in shown]
    pairs = list(zip(branches, shown, strict=True))
    parameters = np.concatenate([b.parameter[use] for b, use in pairs])
    top = np.concatenate([b.modulus[use] for b, use in pairs]).max(axis=0)
    width, top = np.ptp(parameters) or 1.0, np.where(top > 0, top, 1.0)
    lengths = []
    for branch, use in pairs:
        across = np.diff(branch.parameter) / width
        up = np.diff(branch.modulus, axis=0) / top
        steps = np.hypot(across, np.linalg.norm(up, axis=1))
        own = np.where(use[1:] & use[:-1], steps, 0.0)
        lengths.append(np.concatenate([[0.0], np.cumsum(own)]))
    return lengths
