"""Edges of zones: formula, numbers, emitted code and the growth rate must tell the same story."""

from __future__ import annotations

import inspect
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from systems import Omega, d, omega, omega_1, omega_2, oscillator, pair, t, x, y

from mmsgen.errors import ExpansionError, MmsgenError
from mmsgen.loading import load

delta = sp.Symbol("delta", positive=True)
c, c_1, c_2 = sp.symbols("c c_1 c_2", nonnegative=True)
f_11, f_12, f_21 = sp.symbols("f_11 f_12 f_21", positive=True)
swing = 2 * sp.cos(Omega * t)

RELATIONS: dict[str, Any] = {
    "principal": {Omega: 2 * omega},
    "fundamental": {Omega: omega},
    "sum": {Omega: omega_1 + omega_2},
    "difference": {Omega: omega_2 - omega_1},
    "first": {Omega: 2 * omega_1},
}


@cache
def solved(name: str, order: int, damping: int = 1) -> Any:
    """A damped Mathieu equation, or two of them coupled, with dampers that may be zero."""
    if name in ("principal", "fundamental"):
        eom = oscillator(2 * c * d(x) + delta * swing * x)
        return eom.scale({delta: 1, c: damping}).expand(order, RELATIONS[name])
    eom = pair(
        2 * c_1 * d(x) + swing * (f_11 * x + f_12 * y),
        2 * c_2 * d(y) + swing * f_21 * x,
    )
    orders = dict.fromkeys((f_11, f_12, f_21, c_1, c_2), 1)
    return eom.scale(orders).expand(order, RELATIONS[name])


@cache
def module_of(name: str, order: int) -> Any:
    return load(solved(name, order))


def emitted(name: str, order: int, function: str, values: dict[str, Any]) -> Any:
    call = getattr(module_of(name, order), function)
    kinds = inspect.signature(call).parameters.values()
    return call(**{p.name: values[p.name] for p in kinds if p.default is p.empty})


# --- what was said to be stable for ever ----------------------------------------------------------


@pytest.mark.parametrize("order", [2, 3])
def test_a_coupling_of_higher_order_may_exceed_a_damper_of_lower_order(order: int) -> None:
    """Ω = ω: the coupling is of order δ². A damper of order 1 does not rule the zone out."""
    flow = solved("fundamental", order).slow_flow
    assert flow.stability.unstable is None
    for damper in (0.0, 0.0035):
        values = {"omega": 1.0, "delta": 0.1, "c": damper}
        edges = np.array(emitted("fundamental", order, "boundaries", values))
        assert edges == pytest.approx(flow.boundaries(values), rel=1e-12)
        speeds = emitted("fundamental", order, "critical_speeds", values)
        assert speeds == pytest.approx(1 + edges, rel=1e-14)
        assert edges[0] < -0.006 and 0.0 < edges[1]
    values["c"] = 0.3
    assert np.isnan(flow.boundaries(values)).all()
    with pytest.raises(ExpansionError, match=r"boundaries\(values\)"):
        flow.boundary()


def test_never_is_said_where_it_is_proved() -> None:
    for order in (1, 2):
        flow = solved("difference", order).slow_flow
        assert flow.stability.unstable is False and flow.boundary() == ()
    one = oscillator(2 * c * d(x)).scale({c: 1}).expand(2).slow_flow
    assert one.stability.unstable is False


def test_a_reason_with_a_damper_of_second_order_holds_the_coupling() -> None:
    flow = solved("fundamental", 2, 2).slow_flow
    assert "delta" in flow.stability.reason.split("near resonance if")[1]
    assert len(flow.boundary()) == 2


# --- dampers that are zero ------------------------------------------------------------------------

PAIR = {"omega_1": 1.0, "omega_2": 1.7, "f_11": 0.03, "f_12": 0.08, "f_21": 0.05}


@pytest.mark.parametrize("order", [1, 2])
def test_without_dampers_the_edges_are_those_of_the_undamped_case(order: int) -> None:
    eom = pair(swing * (f_11 * x + f_12 * y), swing * f_21 * x)
    bare = eom.scale(dict.fromkeys((f_11, f_12, f_21), 1)).expand(order, RELATIONS["sum"])
    expected = bare.slow_flow.boundaries(PAIR)
    values = {**PAIR, "c_1": 0.0, "c_2": 0.0}
    # Polynomials of the second degree with numbers of size 0.1 and roots of that size.
    assert solved("sum", order).slow_flow.boundaries(values) == pytest.approx(expected, rel=1e-13)
    edges = emitted("sum", order, "boundaries", values)
    assert edges == pytest.approx(expected, rel=1e-13)


def test_one_damper_alone_destabilises_at_every_detuning() -> None:
    """Order 1: Γ² + (c₁ − iσ)Γ − iσc₁ − K with c₁ > 0 has a growing root for every σ."""
    for damped in ("c_1", "c_2"):
        values = {**PAIR, "c_1": 0.0, "c_2": 0.0, damped: 0.02}
        assert emitted("sum", 1, "boundaries", values) == (-np.inf, np.inf)
        assert solved("sum", 1).slow_flow.boundaries(values).tolist() == [-np.inf, np.inf]
        sigma = np.array([-10.0, -0.1, 0.0, 0.1, 10.0])
        assert (emitted("sum", 1, "growth_rate", {**values, "sigma": sigma}) > 0).all()
        assert np.isnan(emitted("sum", 1, "critical_speeds", values)).all()


@pytest.mark.parametrize("sign", ["nonnegative", "negative", "positive"])
def test_differences_with_couplings_of_one_sign(sign: str) -> None:
    """f_12 f_21 ≥ 0 whatever their own sign: no zone, and no edges that are imaginary."""
    f, g = sp.symbols("f g", **{sign: True})
    case = pair(swing * f * y, swing * g * x).scale({f: 1, g: 1}).expand(1, RELATIONS["difference"])
    assert case.slow_flow.stability.unstable is False
    assert case.slow_flow.boundary() == ()
    size = -0.1 if sign == "negative" else 0.1
    lower, upper = load(case).boundaries(f=size, g=size, omega_1=1.0, omega_2=1.7)
    assert np.isnan(lower) and np.isnan(upper)


# --- one definition -------------------------------------------------------------------------------

CASES = [
    ("principal", 1),
    ("principal", 2),
    ("principal", 3),
    ("fundamental", 2),
    ("sum", 1),
    ("sum", 2),
    ("first", 1),
    ("first", 2),
]


def _random_values(name: str, random: np.random.Generator) -> dict[str, float]:
    def damper() -> float:
        return float(random.choice([0.0, 0.002, 0.02]) * random.uniform(0.2, 1.0))

    if name in ("principal", "fundamental"):
        return {
            "omega": random.uniform(0.8, 1.5),
            "delta": random.uniform(0.02, 0.2),
            "c": damper(),
        }
    size = {n: random.uniform(0.02, 0.15) for n in ("f_11", "f_12", "f_21")}
    frequencies = {"omega_1": random.uniform(0.8, 1.2), "omega_2": random.uniform(1.6, 1.9)}
    return {**size, **frequencies, "c_1": damper(), "c_2": damper()}


@pytest.mark.parametrize(("name", "order"), CASES)
def test_all_routes_agree_with_the_growth_rate(name: str, order: int) -> None:
    """Zones of `zones`, the nearest of which are those of both `boundaries`, against signs.

    The growth rate is sampled on a grid as far as zones count; points closer to an edge than 1e-6
    are left out, where it is below 1e-12 either way. Rounding makes 1e-16 of neutral modes.
    """
    random = np.random.default_rng(order)
    flow = solved(name, order).slow_flow
    found = 0
    for _ in range(40):
        values = _random_values(name, random)
        zones = flow.zones(values)
        edges = flow.boundaries(values)
        # Roots of polynomials of size 1, a thousandth of that apart at least, polished.
        assert emitted(name, order, "boundaries", values) == pytest.approx(
            edges, rel=1e-9, abs=1e-12, nan_ok=True
        )
        gaps = [max(low, -high, 0.0) for low, high in zones]
        nearest = zones[int(np.argmin(gaps))] if len(zones) else np.full(2, np.nan)
        assert np.array_equal(nearest, edges, equal_nan=True)
        found += len(zones) > 0
        sigma = np.linspace(-0.45, 0.45, 3001) * values.get("omega", values.get("omega_1"))
        rate = emitted(name, order, "growth_rate", {**values, "sigma": sigma})
        inside = np.zeros(len(sigma), dtype=bool)
        near = np.zeros(len(sigma), dtype=bool)
        for low, high in zones:
            inside |= (low < sigma) & (sigma < high)
            near |= (np.abs(sigma - low) < 1e-6) | (np.abs(sigma - high) < 1e-6)
        assert (rate[inside & ~near] > 1e-13).all()
        assert (rate[~inside & ~near] < 1e-13).all()
    assert found > 5


def test_the_formula_differs_by_the_order_that_is_left_out() -> None:
    """Order 2: the difference between formula and numbers falls like ε³."""
    flow = solved("principal", 2).slow_flow
    edges = sp.lambdify([omega, delta, c], flow.boundary())
    gaps = []
    for size in (1 / 16, 1 / 32, 1 / 64):
        numbers = flow.boundaries({"omega": 1.0, "delta": size, "c": 0.2 * size})
        gaps.append(np.abs(np.array(edges(1.0, size, 0.2 * size)) - numbers).max())
    # The next order shifts the exponent by ε at most.
    assert np.log2(gaps[1] / gaps[2]) == pytest.approx(3, abs=0.1)
    assert np.log2(gaps[0] / gaps[1]) == pytest.approx(3, abs=0.1)


def test_zones_far_from_resonance_do_not_count() -> None:
    """Order 3, c = 0.051 > δ/2ω: a root at σ = −38 of a polynomial cut after σ⁴ is no edge."""
    values = {"omega": 1.0, "delta": 0.1, "c": 0.051}
    assert np.isnan(solved("principal", 3).slow_flow.boundaries(values)).all()
    assert np.isnan(emitted("principal", 3, "boundaries", values)).all()
    assert not len(solved("principal", 3).slow_flow.zones(values))


def test_two_factors_that_can_be_unstable() -> None:
    """Equal oscillators with excitations of their own: the wider zone, and a damped linear mode."""
    g = sp.Symbol("g", positive=True)
    eom = pair(swing * delta * x, swing * g * y + (omega_1**2 - omega_2**2) * y)
    case = eom.scale({delta: 1, g: 1}).expand(1, {Omega: 2 * omega_1})
    flow = case.slow_flow
    with pytest.raises(ExpansionError, match="no single boundary"):
        flow.boundary()
    for size in (0.05, 0.2):
        values = {"omega_1": 1.3, "delta": 0.1, "g": size}
        half = max(0.1, size) / 1.3
        assert flow.boundaries(values) == pytest.approx([-half, half], rel=1e-12)
        edges = load(case).boundaries(**values)
        assert edges == pytest.approx((-half, half), rel=1e-12)


# --- values ---------------------------------------------------------------------------------------


def test_values_out_of_their_domain_are_named() -> None:
    flow = solved("principal", 2).slow_flow
    good = {"omega": 1.0, "delta": 0.1, "c": 0.0, "sigma": 0.0}
    for name, value, text in (
        ("omega", -1.0, "omega must be positive"),
        ("delta", [0.1, 0.0], "delta must be positive"),
        ("c", -1e-3, "c must be zero or positive"),
    ):
        for function in (flow.growth_rate, flow.boundaries):
            with pytest.raises(MmsgenError, match=text):
                function({**good, name: value})


def test_a_detuning_that_contradicts_the_frequencies_is_refused() -> None:
    flow = solved("principal", 2).slow_flow
    good = {"omega": 1.0, "delta": 0.1, "c": 0.0}
    with pytest.raises(MmsgenError, match="sigma contradicts Omega, omega"):
        flow.growth_rate({**good, "sigma": 0.0, "Omega": 50.0})
    both = flow.growth_rate({**good, "sigma": 0.02, "Omega": 2.02})
    assert both == flow.growth_rate({**good, "sigma": 0.02})
