"""Fits of steady motions for certificates: amplitudes, stability, bifurcations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .certificate import Fit, fit_exponent
from .errors import CertificateError, OrbitError
from .motion import reconstruction
from .sampling import scaled_values
from .steady import (
    Steady,
    SteadyState,
    amplitude_gap,
    exact_orbit,
    exponent_gap,
    steady_state,
)
from .steady_agreement import demand_bifurcation, demand_steady_agreement
from .steady_bifurcations import (
    exact_bifurcation,
    flow_power,
    frequency_gap,
    slow_bifurcation,
)
from .steady_cycles import EPSILONS as CYCLE_EPSILONS
from .steady_cycles import cycle_gaps

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["steady_fits"]

EPSILONS = tuple(2.0**-k for k in range(4, 13))
"""The default range of ε: at its end Newton's method still sees damping of order ε."""

LARGER_EPSILONS = tuple(2.0 ** (-k / 2) for k in range(3, 15))
"""Where an error of high order is soon below what doubles resolve, or damping is."""

AMPLITUDE_LIMIT = 1e-8
"""Errors of amplitudes, over the largest, from which they take part: at the smallest ε an orbit is
known to some 1e-10, as the damping that determines it is of order ε.
"""

CYCLE_LIMIT = 1e-7
"""Errors of a limit cycle's lines, over the largest, from which they take part."""

LIMIT = 1e-10
"""Errors of exponents and bifurcations, over the largest frequency, from which they take part."""


def steady_fits(
    case: Expansion, module: Any, steady: Steady, epsilons: Sequence[float] | None = None
) -> list[Fit]:
    """Fit the errors of one steady motion over ε.

    Parameters
    ----------
    case : Expansion
    module : module
        The emitted functions.
    steady : Steady
    epsilons : sequence of float, optional
        By default `EPSILONS`, or `LARGER_EPSILONS` where errors are too small.

    Returns
    -------
    list of Fit
        ``"equilibrium amplitudes"``, ``"stability"`` and, of a free motion, ``"frequency"``; or
        the place of the bifurcation under its name, and ``"frequency of the Hopf point"``; or
        ``"limit cycle"`` and ``"frequency of the limit cycle"``.

    Raises
    ------
    CertificateError
        If there is no such motion, or too few errors are resolved.
    """
    values = {name: float(v) for name, v in case.numbers(steady.values).items()}
    if len(steady.amplitudes) != len(case.coordinates):
        raise CertificateError(
            f"a steady motion has {len(case.coordinates)} amplitudes, got {len(steady.amplitudes)}"
        )
    compare = _bifurcation if steady.bifurcation else _equilibrium
    if steady.cycle:
        compare, epsilons = _cycle, epsilons or CYCLE_EPSILONS
    try:
        if epsilons is not None:
            fits = compare(case, module, values, steady, epsilons)
        else:
            try:
                fits = compare(case, module, values, steady, EPSILONS)
            except (CertificateError, OrbitError):
                fits = compare(case, module, values, steady, LARGER_EPSILONS)
    except OrbitError as error:
        raise CertificateError(f"the steady motion: {error}") from error
    place = tuple(sorted(values.items()))
    near = tuple(complex(b) for b in steady.amplitudes)
    return [replace(fit, place=place, near=near) for fit in fits]


def _weights(case: Expansion) -> Any:
    return np.array([float(w) for w in case.weak.scaled.amplitude])


def _equilibrium(
    case: Expansion,
    module: Any,
    values: Mapping[str, float],
    steady: Steady,
    epsilons: Sequence[float],
) -> list[Fit]:
    """Amplitudes and stability of an equilibrium, from the smallest ε on."""
    weights, guess = _weights(case), np.asarray(steady.amplitudes, dtype=complex)
    sizes, rates, speeds, ordered = [], [], [], sorted(epsilons)
    top = 0.0
    for epsilon in ordered:
        slow, exact = scaled_values(case, values, epsilon)
        power = epsilon**weights
        state = steady_state(case, module, slow, exact, power * guess)
        guess = state.amplitudes / power
        if epsilon == ordered[0]:
            demand_steady_agreement(case, module, state)
        orbit = exact_orbit(case, state)
        sizes.append(amplitude_gap(case, state, orbit, power))
        rates.append(exponent_gap(case, state, orbit))
        if orbit.problem.base is None:
            speed, _ = state.frequency(None)
            exact_speed = 2 * np.pi / orbit.period
            error = exact_speed * orbit.period_error / orbit.period
            speeds.append((abs(speed - exact_speed), error))
        top = max(top, float(np.abs(state.rates).max()))
    size = float(np.abs(guess).max())
    found = [("stability", case.order + 1, rates, LIMIT * top)]
    if size > 0:
        found.insert(0, ("equilibrium amplitudes", case.order, sizes, AMPLITUDE_LIMIT * size))
    if speeds:
        found.append(("frequency", case.order + 1, speeds, LIMIT * top))
    return [
        fit_exponent(quantity, theory, ordered, *zip(*pairs, strict=True), limit=limit)
        for quantity, theory, pairs, limit in found
    ]


def _bifurcation(
    case: Expansion,
    module: Any,
    values: Mapping[str, float],
    steady: Steady,
    epsilons: Sequence[float],
) -> list[Fit]:
    """Where a bifurcation is in the frequency that is detuned, and the frequency of a Hopf one."""
    kind, (sigma, pivot) = steady.bifurcation, _detuned(case, steady)
    weights, guess = _weights(case), np.asarray(steady.amplitudes, dtype=complex)
    own, places, turns, ordered, top = dict(values), [], [], sorted(epsilons), 0.0
    more = flow_power(case, values, sigma, weights, guess, ordered[0]) - 1
    last = 1.0
    for epsilon in ordered:
        # The detuning is as large as the rest of the flow, which order 1 may be missing in.
        own[sigma] *= (epsilon / last) ** more
        last = epsilon
        slow, _ = scaled_values(case, own, epsilon)
        power = epsilon**weights
        found = slow_bifurcation(case, module, slow, kind, sigma, power * guess)
        if epsilon == ordered[0]:
            demand_bifurcation(case, module, found, sigma)
        own[sigma], guess = found.values[sigma] / epsilon, found.amplitudes / power
        slow, exact = scaled_values(case, own, epsilon)
        b = found.amplitudes
        state = SteadyState(b, np.zeros(len(b)), slow, exact, reconstruction(case, slow))
        special = exact_bifurcation(case, state, found, pivot)
        places.append((abs(special.value - exact[pivot]), special.error))
        if kind == "Hopf":
            turns.append(frequency_gap(case, state, special))
        top = max(top, float(np.abs(state.rates).max()))
    quantities = {kind: places, "frequency of the Hopf point": turns}
    return [
        fit_exponent(name, case.order + 1, ordered, *zip(*pairs, strict=True), limit=LIMIT * top)
        for name, pairs in quantities.items()
        if pairs
    ]


def _cycle(
    case: Expansion,
    module: Any,
    values: Mapping[str, float],
    steady: Steady,
    epsilons: Sequence[float],
) -> list[Fit]:
    """The lines and the frequency of a limit cycle."""
    start, ordered = np.asarray(steady.amplitudes, dtype=complex), sorted(epsilons)
    lines, speeds, size = cycle_gaps(case, module, values, start, _weights(case), ordered)
    found = [
        ("limit cycle", case.order, lines, CYCLE_LIMIT * size),
        ("frequency of the limit cycle", case.order + 1, speeds, LIMIT),
    ]
    return [
        fit_exponent(quantity, theory, ordered, *zip(*pairs, strict=True), limit=limit)
        for quantity, theory, pairs, limit in found
    ]


def _detuned(case: Expansion, steady: Steady) -> tuple[str, str]:
    """The detuning in which a bifurcation is sought, and the frequency that it detunes."""
    known = {str(r.detuning.name): r for r in case.relations if len(r.lhs.free_symbols) == 1}
    if not known:
        raise CertificateError(f"a {steady.bifurcation} needs a relation with a detuning")
    sigma = str(getattr(steady.over, "name", steady.over)) or next(iter(known))
    if sigma not in known:
        raise CertificateError(f"{sigma} is no detuning: choose one of {', '.join(known)}")
    (pivot,) = known[sigma].lhs.free_symbols
    if str(pivot.name) not in {p.name for p in case.weak.scaled.eom.parameters}:
        raise CertificateError(
            f"{pivot} follows from other parameters: bifurcations in it are not certified"
        )
    return sigma, str(pivot.name)
