"""Emitted functions of nonlinear slow flows on 10,000 points, run with ``make bench``.

A frequency response with all branches and their stability is to take less than 0.1 s for one
amplitude and less than 2 s for two.
"""

from __future__ import annotations

from importlib import import_module
from inspect import signature
from typing import Any

import numpy as np
import pytest

DUFFING = {"omega_0": 1.0, "alpha": 0.1, "mu": 0.02, "K": 0.05}
PAIR = {
    "omega_1": 1.0,
    "mu_1": 0.02,
    "mu_2": 0.02,
    "alpha_1": 0.3,
    "alpha_2": 0.3,
    "F_1": 0.1,
    "F_2": 0.1,
    "sigma_1": 0.01,
}
COUNT = 10_000
CASES = {
    "one amplitude, order 1": ("duffing_forced.Omega_is_omega_0_order_1", DUFFING, "sigma"),
    "one amplitude, order 2": ("duffing_forced.Omega_is_omega_0_order_2", DUFFING, "sigma"),
    "two amplitudes, order 1": (
        "internal_resonance_1_2.omega_2_is_two_omega_1_and_Omega_is_omega_2_order_1",
        PAIR,
        "sigma_2",
    ),
}


def module(case: str) -> tuple[Any, dict[str, float], str]:
    path, values, over = CASES[case]
    found = import_module(f"mms_functions.{path}")
    return found, values, over


def own(function: Any, values: dict[str, Any]) -> dict[str, Any]:
    """What a function takes of the values."""
    names = signature(function).parameters
    return {n: v for n, v in values.items() if n in names}


@pytest.mark.parametrize("case", CASES)
def test_frequency_response(benchmark: Any, case: str) -> None:
    functions, values, over = module(case)
    given = {**values, over: np.linspace(-0.1, 0.15, COUNT), "over": over}
    function = functions.frequency_response
    benchmark.pedantic(function, kwargs=own(function, given), rounds=5, warmup_rounds=1)


@pytest.mark.parametrize("gradient", [False, True])
@pytest.mark.parametrize("case", [name for name in CASES if name.startswith("one")])
def test_equilibria(benchmark: Any, case: str, gradient: bool) -> None:
    functions, values, over = module(case)
    given = {**values, over: np.linspace(-0.1, 0.15, COUNT), "gradient": gradient}
    function = functions.equilibria
    benchmark.pedantic(function, kwargs=own(function, given), rounds=5, warmup_rounds=1)


@pytest.mark.parametrize("case", CASES)
def test_response(benchmark: Any, case: str) -> None:
    functions, values, over = module(case)
    b = np.full(len(functions.COORDINATES), 0.1)
    t = np.linspace(0.0, 100.0, COUNT)
    function = functions.response
    benchmark(function, t, b, **own(function, {**values, over: 0.05}))
