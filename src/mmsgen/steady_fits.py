"""Fits of steady motions for certificates: amplitudes, stability, saddle-nodes."""

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
    exact_fold,
    exact_orbit,
    exponent_gap,
    slow_fold,
    steady_state,
)
from .steady_agreement import demand_saddle_node, demand_steady_agreement

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["steady_fits"]

EPSILONS = tuple(2.0**-k for k in range(4, 13))
"""The default range of ε: at its end Newton's method still sees damping of order ε."""

LARGER_EPSILONS = tuple(2.0 ** (-k / 2) for k in range(3, 15))
"""Where an error of high order is soon below what doubles resolve."""

AMPLITUDE_LIMIT = 1e-8
"""Errors of amplitudes, over the largest, from which they take part: at the smallest ε an orbit is
known to some 1e-10, as the damping that determines it is of order ε.
"""

LIMIT = 1e-10
"""Errors of exponents and folds, over the largest frequency, from which they take part."""


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
        ``"saddle-node"``.

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
    compare = _fold if steady.fold else _equilibrium
    try:
        if epsilons is not None:
            fits = compare(case, module, values, steady, epsilons)
        else:
            try:
                fits = compare(case, module, values, steady, EPSILONS)
            except CertificateError:
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


def _fold(
    case: Expansion,
    module: Any,
    values: Mapping[str, float],
    steady: Steady,
    epsilons: Sequence[float],
) -> list[Fit]:
    """Where a saddle-node is in the frequency that is detuned."""
    if not case.relations or len(case.relations[0].lhs.free_symbols) != 1:
        raise CertificateError("a saddle-node needs a relation with a detuning")
    (pivot,) = case.relations[0].lhs.free_symbols
    if str(pivot.name) not in {p.name for p in case.weak.scaled.eom.parameters}:
        raise CertificateError(
            f"{pivot} follows from other parameters: its saddle-nodes are not certified"
        )
    sigma = str(case.relations[0].detuning.name)
    weights, guess = _weights(case), np.asarray(steady.amplitudes, dtype=complex)
    own, errors, floors, ordered = dict(values), [], [], sorted(epsilons)
    top = 0.0
    for epsilon in ordered:
        slow, _ = scaled_values(case, own, epsilon)
        power = epsilon**weights
        found, b, direction = slow_fold(case, module, slow, power * guess)
        if epsilon == ordered[0]:
            demand_saddle_node(case, module, found, b)
        own[sigma], guess = found[sigma] / epsilon, b / power
        slow, exact = scaled_values(case, own, epsilon)
        state = SteadyState(b, np.zeros(len(b)), slow, exact, reconstruction(case, slow))
        special = exact_fold(case, state, direction, abs(slow[sigma]) or epsilon)
        errors.append(abs(special.value - exact[str(pivot.name)]))
        floors.append(special.error)
        top = max(top, float(np.abs(state.rates).max()))
    return [fit_exponent("saddle-node", case.order + 1, ordered, errors, floors, limit=LIMIT * top)]
