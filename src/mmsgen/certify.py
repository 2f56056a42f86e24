"""`certify`: the emitted functions of a case against Floquet theory of the exact equations.

With every small parameter p of order k replaced by ε^k p, every detuning σ by εσ and everything
else fixed, the characteristic exponents that follow from a slow flow of order N differ from the
exact ones by O(ε^{N+1}), and so do the edges of a zone of instability. The errors are computed for
a range of ε, an exponent is fitted, and it is compared with the theory's: a wrong coefficient at
any order ≤ N lowers it, the more clearly the smaller ε is. Errors that the reference cannot resolve
take no part in the fit. The functions that are not fitted must agree with those that are.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.optimize import linear_sum_assignment

from . import floquet
from .certificate import SMALLEST, Certificate, Fit, Zone, fit_exponent, title
from .consistency import arguments_of, demand_agreement, demand_speed_on_edge
from .errors import CertificateError, FloquetError, MmsgenError, UnresolvedError
from .loading import load
from .motion import RTOL, exact_motion, first_order_system, reconstruction, slow_motion
from .numeric import Evaluator
from .sampling import scaled_values
from .steady import Steady
from .steady_fits import steady_fits

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["EDGE_EPSILONS", "EPSILONS", "Steady", "certify", "scaled_values"]

EPSILONS = tuple(2.0**-k for k in range(3, 15))
"""The default range of ε: so small at its end that an error of a thousandth in a coefficient of the
first order, cε/1000, is larger there than what order 1 leaves, about cε².
"""

EDGE_EPSILONS = EPSILONS[:6]
"""For the edges of a zone, which become ill-conditioned as it closes."""

LARGER_EPSILONS = tuple(2.0 ** (-k / 4) for k in range(4, 20))
"""Where an error of high order, or of weak coupling, is soon below what doubles resolve."""

MOTION_EPSILONS = EPSILONS[1:6]
"""For motions, which beat, and come into their asymptotic range later than exponents do."""

SCAN = 20
"""Points of the scan for a zone: a third of a cell away from the edges that are expected."""

REFERENCE = 4e-14
"""Error wanted of Floquet's exponents, over the largest frequency."""

LIMIT, EDGE_LIMIT = 4e-11, 4e-10
"""Errors of exponents and of edges, over the largest frequency, from which they take part.

Well above the reference's own errors, so that no last bit decides which ones do.
"""

VISIBLE = 10.0
"""Growth at the middle of a zone from which Floquet cannot miss it, in its thresholds."""


def certify(
    case: Expansion,
    values: Mapping[Any, Any],
    *,
    functions: Any = None,
    epsilons: Sequence[float] | None = None,
    numbers: Mapping[Any, Any] | None = None,
    amplitudes: Sequence[complex] | None = None,
    span: float = 1.0,
    steady: Sequence[Steady] = (),
) -> Certificate:
    """Compare the emitted functions of a case with Floquet theory as ε → 0.

    Parameters
    ----------
    case : Expansion
        With a linear slow flow.
    values : mapping
        Symbol or name → number at ε = 1, for every parameter of the linear equations that no
        relation eliminates, and for every detuning. Choose generic ones: at special values an
        error term may vanish.
    functions : module, optional
        The emitted module; by default rendered and loaded from the case.
    epsilons : sequence of float, optional
        Values of ε > 0; by default `EPSILONS`, for the edges of a zone `EDGE_EPSILONS`, for motions
        `MOTION_EPSILONS`, and `LARGER_EPSILONS` where errors are too small to be resolved.
    numbers : mapping, optional
        Values of the independent parameters at which, at ε = 1, the critical speeds are set beside
        Floquet's; for a case that can be unstable.
    amplitudes : sequence of complex, optional
        Starting values of B_j at ε = 1, where the slow flow is nonlinear or the system is forced.
    span : float
        Time over which motions are compared, in s, at ε = 1; it grows like 1/ε.
    steady : sequence of Steady, optional
        Equilibria, bifurcations in a detuning and limit cycles, to be compared with exact motions.

    Returns
    -------
    Certificate

    Raises
    ------
    CertificateError
        If fewer than four errors are resolved by the reference, so that nothing can be fitted, or
        the emitted functions contradict each other; the message names the case.
    MmsgenError
        If a value is unknown or unusable.
    """
    floats = _scalars(case.numbers(values))
    for epsilon in () if epsilons is None else epsilons:
        if not 0 < epsilon < np.inf:
            raise MmsgenError(f"ε must be positive and finite to certify, got {epsilon!r}")
    module = load(case) if functions is None else functions
    zones: tuple[Zone, ...] = ()
    try:
        # A forced system has no rest whose exponents Floquet could give.
        linear = case.slow_flow.is_linear
        if not linear or any(case.weak.scaled.eom.f):
            steps = MOTION_EPSILONS if epsilons is None else epsilons
            fits = [_motion_fit(case, module, floats, steps, amplitudes, span)]
        else:
            fits = [_resolved(_exponent_fit, case, module, floats, epsilons or EPSILONS, epsilons)]
            if _has_zone(case, module, floats):
                steps = epsilons or EDGE_EPSILONS
                fits.append(_resolved(_edge_fit, case, module, floats, steps, epsilons))
        for own in steady:
            fits += steady_fits(case, module, own, epsilons)
        if linear and all(f.passed for f in fits):
            demand_agreement(case, module, scaled_values(case, floats, 1.0)[0])
        if numbers and any(f.quantity == "edges of the zone" for f in fits):
            zones = _zones_at(case, module, numbers)
    except (CertificateError, FloquetError) as error:
        name = title(case) if case.relations else "without resonance"
        raise CertificateError(f"{name} at order {case.order}: {error}") from error
    return Certificate.of_case(case, floats, tuple(fits), zones)


def _resolved(
    fit: Callable[..., Fit],
    case: Expansion,
    module: Any,
    values: Mapping[str, float],
    steps: Sequence[float],
    chosen: Sequence[float] | None,
) -> Fit:
    """A fit, with larger ε where the user has chosen none and too few errors are resolved."""
    try:
        return fit(case, module, values, steps)
    except UnresolvedError:
        if chosen is not None:
            raise
    try:
        return fit(case, module, values, LARGER_EPSILONS)
    except UnresolvedError:
        return fit(case, module, values, [4 * e for e in LARGER_EPSILONS])


def _scalars(table: Mapping[str, Any]) -> dict[str, float]:
    for name, value in table.items():
        if np.ndim(value):
            raise MmsgenError(f"the value of {name} must be one number to certify, got {value!r}")
    return {name: float(value) for name, value in table.items()}


def _has_zone(case: Expansion, module: Any, values: Mapping[str, float]) -> bool:
    """Whether edges are emitted, and the slow flow has a zone as ε → 0.

    A damper of a lower order than the coupling closes it there.
    """
    if not case.relations or not hasattr(module, "boundaries"):
        return False
    slow = [scaled_values(case, values, e)[0] for e in (EDGE_EPSILONS[0], EDGE_EPSILONS[-1])]
    return all(bool(np.all(np.isfinite(case.slow_flow.boundaries(v)))) for v in slow)


def predicted_exponents(case: Expansion, module: Any, slow: Mapping[str, float]) -> Any:
    """Characteristic exponents from the emitted slow-flow matrix, one per state.

    An eigenvalue Γ of a block that holds A_j belongs to e^{(i(ω_j + λ_j) + Γ)t}; modulo the
    excitation frequency all amplitudes of a block give the same.
    """
    matrix = module.slow_flow_matrix(**arguments_of(module.slow_flow_matrix, slow))
    if not np.all(np.isfinite(matrix)):
        raise CertificateError("slow_flow_matrix has entries that are no numbers")
    flow = case.slow_flow
    ring = case.weak.ring
    offsets = Evaluator(
        [
            case.symbols.polynomial(ring.form_polynomial(f)) + flow.frame_rate(j)
            for j, f in enumerate(ring.amplitude_frequencies)
        ],
        case.parameters,
    )(slow)
    result, start = [], 0
    for block in flow.linear.blocks:
        n = len(block.nodes)
        part = matrix[start : start + n, start : start + n]
        j, barred = block.nodes[0]
        turn = (-1j if barred else 1j) * complex(offsets[j]).real
        own = np.linalg.eigvals(part) + turn
        result.append(own)
        if not _self_conjugate(block.nodes):
            result.append(own.conj())
        start += n
    return np.concatenate(result)


def _self_conjugate(nodes: Sequence[tuple[int, int]]) -> bool:
    return any((j, 1 - b) in nodes for j, b in nodes)


def _exponent_fit(
    case: Expansion, module: Any, values: Mapping[str, float], epsilons: Sequence[float]
) -> Fit:
    """The largest distance between predicted and exact exponents, for each ε."""
    errors, floors, scale = [], [], 0.0
    eom = case.weak.scaled.eom
    for epsilon in epsilons:
        slow, exact = scaled_values(case, values, epsilon)
        predicted = predicted_exponents(case, module, slow)
        given = {p.name: exact[p.name] for p in eom.parameters if p.name in exact}
        scale = scale or float(np.abs(predicted).max())
        reference = floquet.exponents(eom, given, tolerance=REFERENCE * scale)
        period = 1.0 if reference.period is None else float(reference.period)
        if not np.all(np.isfinite(reference.value)):
            errors.append(np.nan)
            floors.append(np.inf)
            continue
        # Exponents are defined modulo 2πi/T; their multipliers are compared instead.
        distance = np.abs(
            np.exp(predicted * period)[:, None] - np.exp(reference.value * period)[None, :]
        )
        rows, columns = linear_sum_assignment(distance)
        errors.append(float(distance[rows, columns].max()) / period)
        floors.append(float(np.max(reference.error)))
    return fit_exponent(
        "characteristic exponents", case.order + 1, epsilons, errors, floors, limit=LIMIT * scale
    )


def _edge_fit(
    case: Expansion, module: Any, values: Mapping[str, float], epsilons: Sequence[float]
) -> Fit:
    """The larger distance between predicted and exact edges of the zone, for each ε."""
    relation = case.relations[0]
    (pivot,) = relation.lhs.free_symbols
    eom = case.weak.scaled.eom
    sigma = str(relation.detuning.name)
    errors, floors, cut, scale = [], [], [], 0.0
    for epsilon in epsilons:
        slow, exact = scaled_values(case, values, epsilon)
        scale = scale or float(np.abs(predicted_exponents(case, module, slow)).max())
        arguments = arguments_of(module.boundaries, slow)
        lower, upper = (float(e) for e in module.boundaries(**arguments))
        if not lower < upper:
            raise CertificateError(f"boundaries gives no interval at ε = {epsilon:g}")
        slope = float(case.weak.detuned[str(pivot.name)].detuning[sigma])
        centre = exact[str(pivot.name)] - slope * slow[sigma]
        edges = sorted((centre + slope * lower, centre + slope * upper))
        width = edges[1] - edges[0]
        given = {p.name: exact[p.name] for p in eom.parameters if p.name in exact}
        given.pop(str(pivot.name))
        interval = (edges[0] - width, edges[1] + width)
        found = floquet.boundary(eom, given, pivot, interval, points=SCAN)
        inside = {**slow, sigma: (lower + upper) / 2}
        growth = module.growth_rate(**arguments_of(module.growth_rate, inside))
        if not found.zones and 0 < growth < VISIBLE * found.threshold:
            errors.append(np.nan)
            floors.append(np.inf)
            cut.append(False)
            continue
        zone = _zone(found, sum(edges) / 2)
        errors.append(max(abs(a - b) for a, b in zip(edges, zone[0], strict=True)))
        floors.append(zone[1])
        cut.append(zone[0][0] == interval[0] or zone[0][1] == interval[1])
    if not all(cut):
        # What reaches the end of the interval has no edge there. Where all do, the errors are at
        # least these, and tell that the zone is far too narrow.
        floors = [np.inf if beyond else own for own, beyond in zip(floors, cut, strict=True)]
    return fit_exponent(
        "edges of the zone", case.order + 1, epsilons, errors, floors, limit=EDGE_LIMIT * scale
    )


def _motion_fit(
    case: Expansion,
    module: Any,
    values: Mapping[str, float],
    epsilons: Sequence[float],
    amplitudes: Sequence[complex] | None,
    span: float,
) -> Fit:
    """The largest distance between reconstructed and exact motions at times of order 1/ε."""
    if amplitudes is None or len(amplitudes) != len(case.coordinates):
        raise CertificateError(
            "a nonlinear slow flow, or a forced system, is certified by motions: give "
            f"{len(case.coordinates)} starting amplitudes"
        )
    weights = np.array([float(w) for w in case.weak.scaled.amplitude])
    eom = case.weak.scaled.eom
    n, errors, floors = len(weights), [], []
    for epsilon in epsilons:
        slow, exact = scaled_values(case, values, epsilon)
        shape = reconstruction(case, slow)
        end = span / epsilon
        # The last five periods of the slowest oscillation: the maximum then hides no phase.
        window = 10 * np.pi / np.min(np.abs(shape.rates[:n]))
        times = np.concatenate([[0.0], np.linspace(end, end + window, 200)])
        start = epsilon**weights * np.asarray(amplitudes, dtype=complex)
        own = arguments_of(module.slow_flow, slow)
        motion = slow_motion(module, start, times, own)
        states = shape(times, motion)
        known = {p.name: exact[p.name] for p in eom.parameters if p.name in exact}
        derivative = first_order_system(eom, known)
        reference = exact_motion(derivative, states[:, 0], times, float(np.abs(start).max()))
        gap = np.abs(states[:n] - reference[:n])[:, 1:].max(axis=1)
        errors.append(float(np.max(gap / epsilon**weights)))
        # An integration errs by its tolerance in every radian, and phases add that up.
        floors.append(RTOL * end * float(np.max(np.abs(shape.rates))))
    quantity = "motions at times of order 1/ε"
    limit = SMALLEST * float(np.abs(amplitudes).max())
    return fit_exponent(quantity, case.order, epsilons, errors, floors, limit=limit)


def _zones_at(case: Expansion, module: Any, numbers: Mapping[Any, Any]) -> tuple[Zone, ...]:
    """Critical speeds at numbers, and Floquet's; none where there is no zone."""
    if not hasattr(module, "critical_speeds"):
        return ()
    (pivot,) = case.relations[0].lhs.free_symbols
    table = {str(getattr(k, "name", k)): float(v) for k, v in numbers.items()}
    arguments = arguments_of(module.critical_speeds, table)
    emitted = tuple(float(e) for e in module.critical_speeds(**arguments))
    if not np.all(np.isfinite(emitted)):
        return ()
    width = emitted[1] - emitted[0]
    if not width > 0:
        raise CertificateError(f"critical_speeds gives no interval: {emitted[0]} … {emitted[1]}")
    eom = case.weak.scaled.eom
    known = {p.name: p for p in eom.parameters}
    given = {n: v for n, v in table.items() if n in known and n != pivot.name}
    given = {n: v for n, v in given.items() if known[n].definition is None}
    demand_speed_on_edge(case, module, given, str(pivot.name), emitted)
    interval = (emitted[0] - width, emitted[1] + width)
    found = floquet.boundary(eom, given, pivot, interval, points=401)
    exact, error = _zone(found, sum(emitted) / 2)
    unit = known[str(pivot.name)].unit
    return (Zone(str(pivot.name), unit, (emitted[0], emitted[1]), exact, error),)


def _zone(found: floquet.Boundary, centre: float) -> tuple[tuple[float, float], float]:
    """The zone of Floquet's that holds a point, and the error of its edges."""
    for low, high in found.zones:
        if low <= centre <= high:
            return (float(low), float(high)), float(np.max(found.error, initial=0.0))
    raise CertificateError(
        f"Floquet finds no zone of instability about {centre:.6g}, where the case claims one"
    )
