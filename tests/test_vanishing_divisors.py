"""Emitted functions where a divisor vanishes: NaN in whatever shape the numbers come, no error."""

from __future__ import annotations

import inspect
import re
import warnings
from collections.abc import Iterator
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import sympy as sp
from entries import EMITTED, emitted
from systems import Omega, omega_1, omega_2, pair, t, x, y

FILES = sorted(p for p in EMITTED.glob("*/*_order_*.py"))
NAMES = [f"{p.parent.name}/{p.stem}" for p in FILES]
LEADING = {"t": 1.0, "amplitude": 0.5}
"""By name, without the underscore that a name has beside a parameter of the same name."""


def functions_of(module: ModuleType) -> dict[str, tuple[Any, list[str], list[str]]]:
    """Name → function, its positional arguments, its parameters."""
    found = {}
    for name in module.__all__:
        function = getattr(module, name)
        if not inspect.isfunction(function) or name == "frequency_response":
            continue
        items = inspect.signature(function).parameters.values()
        first = [p.name for p in items if p.kind is p.POSITIONAL_ONLY]
        named = [p.name for p in items if p.name in module.PARAMETERS]
        found[name] = function, first, named
    return found


def divisors_of(module: ModuleType) -> list[sp.Expr]:
    """Those that the module names at its head."""
    named = re.search(r"a case of its own: (.*?)\.\n", module.__doc__, re.DOTALL)
    if named is None:
        return []
    local = {name: sp.Symbol(name) for name in module.PARAMETERS}
    return [sp.sympify(text, locals=local) for text in named[1].split(",")]


def vanishing(module: ModuleType, divisor: sp.Expr) -> dict[str, float]:
    """Values at which a divisor is zero to the last bit: a few binary digits each."""
    values = {
        name: (2 * k + 17) / (8.0 if domain == "positive" else 64.0)
        for k, (name, (domain, *_)) in enumerate(module.PARAMETERS.items())
    }
    for symbol in sorted(divisor.free_symbols, key=str):
        (root,) = sp.solve(divisor, symbol)
        number = float(root.subs(values))
        if number > 0.0:
            return values | {str(symbol): number}
    raise AssertionError(f"{divisor} does not vanish")


def leaves(result: Any) -> Iterator[np.ndarray]:
    """All arrays of a result."""
    if isinstance(result, dict):
        result = tuple(result.values())
    if isinstance(result, tuple):
        for part in result:
            yield from leaves(part)
    else:
        yield np.asarray(result)


def called(module: ModuleType, name: str, values: dict[str, Any]) -> list[np.ndarray]:
    function, first, named = functions_of(module)[name]
    state = np.full(len(module.COORDINATES), 0.1)
    given = {**LEADING, "amplitudes": state + 0.05j, "q": state, "v": state}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", "outside of the validity", UserWarning)
        result = function(*(given[n.rstrip("_")] for n in first), **{n: values[n] for n in named})
    return list(leaves(result))


CASES = [(name, k) for name in NAMES for k in range(len(divisors_of(emitted(*name.split("/")))))]


@pytest.mark.parametrize(("name", "number"), CASES)
def test_scalars_and_arrays_give_the_same(name: str, number: int) -> None:
    module = emitted(*name.split("/"))
    divisor = divisors_of(module)[number]
    values = vanishing(module, divisor)
    lost = set()
    for function, (_, _, named) in functions_of(module).items():
        plain = called(module, function, values)
        several = called(module, function, {n: np.full(2, x) for n, x in values.items()})
        mixed = called(module, function, values | {named[-1]: np.full(2, values[named[-1]])})
        for one, two, three in zip(plain, several, mixed, strict=True):
            np.testing.assert_array_equal(two, np.broadcast_to(one, two.shape))
            np.testing.assert_array_equal(three, two)
            if not np.isfinite(one).all():
                lost.add(function)
            if function in ("backbone", "growth_rate", "evolution", "jacobian", "stability"):
                assert not np.isinf(one).any(), function
    assert lost, f"{divisor} is in no formula"


@pytest.mark.parametrize(("name", "number"), CASES)
def test_what_stays_finite_does_not_contain_the_divisor(name: str, number: int) -> None:
    module = emitted(*name.split("/"))
    divisor = divisors_of(module)[number]
    values = vanishing(module, divisor)
    symbol = str(sorted(divisor.free_symbols, key=str)[0])
    formulas = {"growth_rate", "boundaries"} | (
        {"backbone"} if len(module.COORDINATES) == 1 else set()
    )
    for function in formulas & set(module.__all__):
        there = np.array(called(module, function, values))
        if not np.isfinite(there).all():
            continue
        # A divisor of 1e-9 would show as 1e9; all else hardly moves.
        for step in (1e-9, -1e-9):
            near = called(module, function, values | {symbol: values[symbol] * (1 + step)})
            np.testing.assert_allclose(near, there, rtol=1e-6)


@pytest.mark.parametrize("shape", [(), (1,), (3,)])
@pytest.mark.filterwarnings("error")
def test_the_engine_says_the_same(shape: tuple[int, ...]) -> None:
    f11, f12, f21, f22 = sp.symbols("f_11 f_12 f_21 f_22", real=True)
    c = 2 * sp.cos(Omega * t)
    eom = pair(c * (f11 * x + f12 * y), c * (f21 * x + f22 * y))
    scaled = eom.scale(dict.fromkeys((f11, f12, f21, f22), 1))
    flow = scaled.expand(2, {Omega: omega_1 + omega_2}).slow_flow
    values = dict.fromkeys(("omega_1", "omega_2", "f_11", "f_12", "f_21", "f_22"), 1.0)
    values["sigma"] = np.full(shape, 1.0)
    assert np.isnan(flow.growth_rate(values)).all()
    assert np.isnan(flow.boundaries(values)).all()
    assert np.isnan(flow.evolution(values, [0.1, 0.2], 1.0)).all()
    assert np.isnan(flow.beating(values, [0.1, 0.2]).largest).all()
