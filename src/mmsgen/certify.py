"""`certify`: the emitted functions of a case against Floquet theory of the exact equations.

With every small parameter p of order k replaced by ε^k p, every detuning σ by εσ and everything
else fixed, the characteristic exponents that follow from a slow flow of order N differ from the
exact ones by O(ε^{N+1}), and so do the edges of a zone of instability. The errors are computed for
a range of ε, an exponent is fitted, and it is compared with the theory's: a wrong coefficient at
any order ≤ N lowers it. Errors that the reference cannot resolve take no part in the fit.
"""

from __future__ import annotations

import inspect
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.optimize import linear_sum_assignment

from . import floquet
from .certificate import Certificate, Fit, Zone, fit_exponent
from .errors import CertificateError
from .loading import load
from .motion import RTOL, exact_motion, first_order_system, reconstruction, slow_motion
from .numeric import Evaluator, named_values

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["EPSILONS", "certify", "scaled_values"]

EPSILONS = tuple(2.0**-k for k in range(3, 9))
"""The default range of ε: a factor of 32, over which orders N and N + 1 part by that factor."""

REFERENCE = 1e-12
"""Error wanted of Floquet's exponents, s⁻¹."""


def certify(
    case: Expansion,
    values: Mapping[Any, Any],
    *,
    functions: Any = None,
    epsilons: Sequence[float] = EPSILONS,
    numbers: Mapping[Any, Any] | None = None,
    amplitudes: Sequence[complex] | None = None,
    span: float = 1.0,
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
    epsilons : sequence of float
        Values of ε, descending.
    numbers : mapping, optional
        Values of the independent parameters at which, at ε = 1, the critical speeds are set beside
        Floquet's; for a case that can be unstable.
    amplitudes : sequence of complex, optional
        Starting values of B_j at ε = 1, for a slow flow that is nonlinear or forced.
    span : float
        Time over which motions are compared, in s, at ε = 1; it grows like 1/ε.

    Returns
    -------
    Certificate

    Raises
    ------
    CertificateError
        If fewer than four errors are resolved by the reference, so that nothing can be fitted.
    MmsgenError
        If a value is missing, unknown or unusable.
    """
    module = load(case) if functions is None else functions
    table = named_values(case.parameters, values)
    floats = {name: float(v) for name, v in table.items()}
    if not case.slow_flow.is_linear:
        # Motions beat, and come into their asymptotic range later than exponents do.
        smaller = epsilons if epsilons is not EPSILONS else EPSILONS[1:]
        fit = _motion_fit(case, module, floats, smaller, amplitudes, span)
        return Certificate.of_case(case, floats, (fit,))
    fits = [_exponent_fit(case, module, floats, epsilons)]
    if _has_zone(case, module, floats):
        fits.append(_edge_fit(case, module, floats, epsilons))
    zones = (_zone_at(case, module, numbers),) if numbers and len(fits) > 1 else ()
    return Certificate.of_case(case, floats, tuple(fits), zones)


def _has_zone(case: Expansion, module: Any, values: Mapping[str, float]) -> bool:
    """Whether the emitted functions give a zone of finite width at the values."""
    if not case.relations or not hasattr(module, "boundaries"):
        return False
    slow, _ = scaled_values(case, values, 1.0)
    edges = module.boundaries(**_arguments(module.boundaries, slow))
    return bool(np.all(np.isfinite(edges)))


def scaled_values(
    case: Expansion, values: Mapping[str, float], epsilon: float
) -> tuple[dict[str, float], dict[str, float]]:
    """Values at ε: those of the slow flow's parameters, and those of the exact equations.

    Parameters
    ----------
    case : Expansion
    values : mapping
        Name → number at ε = 1.
    epsilon : float
    """
    orders = {str(s.name): order for s, order in case.weak.scaled.orders}
    sigmas = {str(r.detuning.name) for r in case.relations}
    slow = {
        name: v * epsilon ** (1 if name in sigmas else orders.get(name, 0))
        for name, v in values.items()
        if name not in case.weak.detuned
    }
    exact = {name: v for name, v in slow.items() if name not in sigmas}
    for name, detuned in case.weak.detuned.items():
        parts = {**detuned.resonant, **detuned.detuning}
        missing = [k for k in parts if k != "1" and k not in slow]
        if missing:
            raise CertificateError(f"a value of {missing[0]} is needed to certify {name}")
        exact[name] = sum(float(c) * (1.0 if k == "1" else slow[k]) for k, c in parts.items())
    return slow, exact


def _arguments(function: Any, values: Mapping[str, float]) -> dict[str, float]:
    """The values that an emitted function takes."""
    names = list(inspect.signature(function).parameters)
    missing = [n for n in names if n not in values]
    if missing:
        raise CertificateError(f"no value is given for {', '.join(missing)}")
    return {n: values[n] for n in names}


def predicted_exponents(case: Expansion, module: Any, slow: Mapping[str, float]) -> Any:
    """Characteristic exponents from the emitted slow-flow matrix, one per state.

    An eigenvalue Γ of a block that holds A_j belongs to e^{(i(ω_j + λ_j) + Γ)t}; modulo the
    excitation frequency all amplitudes of a block give the same.
    """
    matrix = module.slow_flow_matrix(**_arguments(module.slow_flow_matrix, slow))
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
    errors, floors = [], []
    eom = case.weak.scaled.eom
    for epsilon in epsilons:
        slow, exact = scaled_values(case, values, epsilon)
        predicted = predicted_exponents(case, module, slow)
        given = {p.name: exact[p.name] for p in eom.parameters if p.name in exact}
        reference = floquet.exponents(eom, given, tolerance=REFERENCE)
        period = 1.0 if reference.period is None else float(reference.period)
        # Exponents are defined modulo 2πi/T; their multipliers are compared instead.
        distance = np.abs(
            np.exp(predicted * period)[:, None] - np.exp(reference.value * period)[None, :]
        )
        rows, columns = linear_sum_assignment(distance)
        errors.append(float(distance[rows, columns].max()) / period)
        floors.append(float(np.max(reference.error)))
    return fit_exponent("characteristic exponents", case.order + 1, epsilons, errors, floors)


def _edge_fit(
    case: Expansion, module: Any, values: Mapping[str, float], epsilons: Sequence[float]
) -> Fit:
    """The larger distance between predicted and exact edges of the zone, for each ε."""
    relation = case.relations[0]
    (pivot,) = relation.lhs.free_symbols
    eom = case.weak.scaled.eom
    sigma = str(relation.detuning.name)
    errors, floors = [], []
    for epsilon in epsilons:
        slow, exact = scaled_values(case, values, epsilon)
        arguments = _arguments(module.boundaries, slow)
        lower, upper = (float(e) for e in module.boundaries(**arguments))
        slope = float(case.weak.detuned[str(pivot.name)].detuning[sigma])
        centre = exact[str(pivot.name)] - slope * slow[sigma]
        edges = sorted((centre + slope * lower, centre + slope * upper))
        width = edges[1] - edges[0]
        given = {p.name: exact[p.name] for p in eom.parameters if p.name in exact}
        given.pop(str(pivot.name))
        found = floquet.boundary(eom, given, pivot, (edges[0] - width, edges[1] + width), points=61)
        zone = _zone(found, sum(edges) / 2)
        errors.append(max(abs(a - b) for a, b in zip(edges, zone[0], strict=True)))
        floors.append(zone[1])
    return fit_exponent("edges of the zone", case.order + 1, epsilons, errors, floors)


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
            f"a nonlinear slow flow is certified by motions: give {len(case.coordinates)} "
            "starting amplitudes"
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
        own = _arguments(module.slow_flow, {**slow, "amplitudes": 0.0})
        own.pop("amplitudes", None)
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
    return fit_exponent(quantity, case.order, epsilons, errors, floors)


def _zone_at(case: Expansion, module: Any, numbers: Mapping[Any, Any]) -> Zone:
    """Critical speeds at numbers, and Floquet's."""
    (pivot,) = case.relations[0].lhs.free_symbols
    table = {str(getattr(k, "name", k)): float(v) for k, v in numbers.items()}
    arguments = _arguments(module.critical_speeds, table)
    emitted = tuple(float(e) for e in module.critical_speeds(**arguments))
    width = emitted[1] - emitted[0]
    eom = case.weak.scaled.eom
    known = {p.name: p for p in eom.parameters}
    given = {n: v for n, v in table.items() if n in known and n != pivot.name}
    given = {n: v for n, v in given.items() if known[n].definition is None}
    interval = (emitted[0] - width, emitted[1] + width)
    found = floquet.boundary(eom, given, pivot, interval, points=401)
    exact, error = _zone(found, sum(emitted) / 2)
    return Zone(
        str(pivot.name), known[str(pivot.name)].unit, (emitted[0], emitted[1]), exact, error
    )


def _zone(found: floquet.Boundary, centre: float) -> tuple[tuple[float, float], float]:
    """The zone of Floquet's that holds a point, and the error of its edges."""
    for low, high in found.zones:
        if low <= centre <= high:
            return (float(low), float(high)), float(np.max(found.error))
    raise CertificateError(
        f"Floquet finds no zone of instability about {centre:.6g}, where the case claims one"
    )
