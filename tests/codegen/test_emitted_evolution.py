"""Emitted `evolution` and `beating`: against the engine, themselves, and bad input."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from codegen_systems import emitted

UNIT = 2.0**-52
NAMES = ("stable", "rotor2", "mathieu", "lossy", "pair")


def point(name: str, k: int = 1) -> tuple[Any, dict[str, float]]:
    """The stored amplitudes and arguments of one of the systems."""
    stored = emitted(name).reference["functions"]["evolution"][k]
    return np.array([complex(*pair) for pair in stored["amplitudes"]]), stored["arguments"]


@pytest.mark.parametrize("name", NAMES)
def test_the_flow_is_what_the_slow_flow_says(name: str) -> None:
    """dB/dt at t = 0, and one time after another: e^{S(s + t)} = e^{Ss} e^{St}."""
    module = emitted(name).module
    start, arguments = point(name)
    size = np.linalg.norm(module.slow_flow_matrix(**arguments)) + 1.0
    h = 1e-4 / size
    ahead, behind = module.evolution([h, -h], start, **arguments)
    rate = module.slow_flow(start, **arguments)
    # A difference of second order: (hS)²/6 of ‖S‖, and rounding over h.
    assert np.abs((ahead - behind) / (2 * h) - rate).max() < size * 3e-8 * np.abs(start).max()
    there = module.evolution(0.7, start, **arguments)
    twice = module.evolution(0.5, there, **arguments)
    whole = module.evolution(1.2, start, **arguments)
    bound = 1e3 * UNIT * np.exp(1.2 * size) * np.abs(start).max()
    assert np.abs(twice - whole).max() <= bound
    assert np.array_equal(module.evolution(0.0, start, **arguments), start)


@pytest.mark.parametrize("name", NAMES)
def test_the_same_as_the_engine(name: str) -> None:
    one = emitted(name)
    start, arguments = point(name)
    flow = one.case.slow_flow
    times = np.linspace(-1.0, 2.0, 5)
    ours, other = one.module.evolution(times, start, **arguments), None
    other = flow.evolution(arguments, start, times)
    size = np.linalg.norm(one.module.slow_flow_matrix(**arguments)) + 1.0
    assert np.abs(ours - other).max() <= 1e3 * UNIT * np.exp(2 * size) * np.abs(start).max()
    found, reference = one.module.beating(start, **arguments), flow.beating(arguments, start)
    for got, wanted in zip(found, reference, strict=True):
        # Both from eigenvalues; near their margins these are good to the root of 1e-16.
        np.testing.assert_allclose(got, wanted, rtol=1e-6, atol=1e-12, equal_nan=True)


def test_all_shapes_broadcast() -> None:
    module = emitted("stable").module
    start, arguments = point("stable")
    first = next(iter(arguments))
    many = {**arguments, first: arguments[first] * np.array([1.0, 1.1, 1.2])[:, None]}
    times = np.linspace(0.0, 3.0, 4)
    together = module.evolution(times, start, **many)
    assert together.shape == (3, 4, 6)
    for i in range(3):
        for k in range(4):
            own = {**arguments, first: float(many[first][i, 0])}
            alone = module.evolution(times[k], start, **own)
            assert np.allclose(together[i, k], alone, rtol=1e-13, atol=1e-14)
    found = module.beating(np.stack([start, 2 * start])[:, None], **{**many, first: many[first].T})
    assert [part.shape for part in found] == [(2, 3, 6)] * 3
    # A linear flow: twice the start, twice the largest amplitude, after the same period.
    assert np.allclose(found.largest[1], 2 * found.largest[0], rtol=1e-12)
    assert np.allclose(found.period[0], found.period[1], rtol=1e-12, equal_nan=True)
    assert module.evolution(np.empty((0,)), start, **arguments).shape == (0, 6)
    assert module.beating(np.empty((0, 6)), **arguments).largest.shape == (0, 6)


def test_what_is_refused() -> None:
    module = emitted("stable").module
    start, arguments = point("stable")
    with pytest.raises(ValueError, match="the times must be finite"):
        module.evolution(np.nan, start, **arguments)
    with pytest.raises(ValueError, match="the times must be real numbers"):
        module.evolution("now", start, **arguments)
    with pytest.raises(ValueError, match=r"amplitudes must have the shape \(\.\.\., 6\)"):
        module.beating(start[:3], **arguments)
    with pytest.raises(ValueError, match=r"do not broadcast together: times: \(2,\), .*\(3,\)"):
        module.evolution([0.0, 1.0], np.stack([start] * 3), **arguments)
    with pytest.raises(ValueError, match="omega_x must be positive"):
        module.beating(start, **{**arguments, "omega_x": -1.0})


def test_where_a_divisor_vanishes() -> None:
    """No slow flow there, so no motion: NaN, not an exception."""
    module = emitted("rotor2").module
    start, arguments = point("rotor2")
    other = {**arguments, "omega_y": arguments["omega_x"]}
    assert not np.isfinite(module.slow_flow_matrix(**other)).all()
    moved, found = module.evolution(1.0, start, **other), module.beating(start, **other)
    assert np.isnan(moved[0]) and np.isnan(found.largest[0]) and np.isnan(found.period[0])
    # Beside points at which there is one, nothing changes.
    both = {**arguments, "omega_y": np.array([other["omega_y"], arguments["omega_y"]])}
    moved = module.evolution(1.0, start, **both)
    assert np.array_equal(moved[1], module.evolution(1.0, start, **arguments))
    assert np.isnan(moved[0, 0])
