"""Which equations have a state whose stability is asked for, and coefficients that jump."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

from mmsgen import floquet
from mmsgen.equations import EquationsOfMotion
from mmsgen.errors import FloquetError
from mmsgen.model import Model

t = dynamicsymbols._t
q = dynamicsymbols("q")
omega, Omega, alpha, F = sp.symbols("omega Omega alpha F", positive=True)
d, e = sp.symbols("d e", real=True)


def equations(*terms: sp.Expr) -> EquationsOfMotion:
    side = sp.Add(q.diff(t, 2), *terms)
    parameters = sorted(side.free_symbols - {t}, key=str)
    return Model.from_equations([side], [q], parameters).equations_of_motion()


FORCE = F * sp.cos(Omega * t)


@pytest.mark.parametrize("function", [floquet.growth_rate, floquet.multipliers, floquet.exponents])
def test_rest_that_is_no_solution_is_refused(function: object) -> None:
    values = {"omega": 1, "alpha": 1, "F": 10, "Omega": 2}
    driven = equations(omega**2 * q, alpha * q**3, -FORCE)
    with pytest.raises(FloquetError, match=r"F\*cos.* acts on q.*alpha\*q\(t\)\*\*3"):
        function(driven, values, period=1.0)


def test_forced_linear_and_free_nonlinear_equations_are_allowed() -> None:
    linear = equations(omega**2 * (1 + e * sp.cos(Omega * t)) * q, -FORCE)
    assert floquet.growth_rate(linear, {"omega": 1, "e": 0.2, "Omega": 2, "F": 10}).value > 0.04
    free = equations(omega**2 * q, alpha * q**3)
    assert floquet.growth_rate(free, {"omega": 1, "alpha": 1}).verdict == "stable"


def meissner_trace(mean: float, change: float) -> float:
    """Two half periods of constant stiffness, in closed form."""
    first, second = np.sqrt(mean + change), np.sqrt(mean - change)
    ratio = first / second + second / first
    products = [f(first * np.pi) * f(second * np.pi) for f in (np.cos, np.sin)]
    return float(2 * products[0] - ratio * products[1])


SWITCHES = {
    "sign": sp.sign(sp.cos(t)),
    "heaviside": 2 * sp.Heaviside(sp.sin(t), 0) - 1,
    "piecewise": sp.Piecewise((1, sp.cos(t) > 0), (-1, True)),
    "modulo": sp.Piecewise((1, sp.Mod(t, 2 * sp.pi) < sp.pi), (-1, True)),
}


@pytest.mark.parametrize("name", SWITCHES)
def test_meissner(name: str) -> None:
    system = equations((d + e * SWITCHES[name]) * q)
    period = 2 * np.pi if name == "modulo" else None
    values = {"d": np.array([0.3, 2.0, 1.1]), "e": np.array([0.1, 0.5, 0.2])}
    result = floquet.monodromy(system, values, period=period)
    trace = np.trace(result.value, axis1=1, axis2=2)
    expected = [meissner_trace(*pair) for pair in zip(values["d"], values["e"], strict=True)]
    # Two entries make the trace; 1e-14 is the rounding of the closed form.
    assert np.all(np.abs(trace - expected) <= 2 * result.error[:, 0, 0] + 1e-14)
    assert np.all(result.error < 1e-9)
    # 40 digits of the closed form, at the first point.
    assert trace[0] == pytest.approx(-2.0471272457476071472, abs=1e-13)
    verdict = floquet.growth_rate(system, values, period=period).verdict
    assert verdict[0] == "unstable"


def test_jumps_that_no_step_meets_leave_the_question_open() -> None:
    # One jump is close behind the last node of a step, where no stage value tells of it.
    shift = sp.Rational(1, 1000)
    system = equations((d + e * sp.sign(sp.cos(t + shift))) * q)
    result = floquet.growth_rate(system, {"d": 0.3, "e": 0.1}, max_steps=4)
    assert np.isinf(result.error)
    assert result.verdict == "undecided"


@pytest.mark.parametrize(
    ("call", "named"),
    [
        (lambda: floquet.growth_rate(3, {}), "3"),
        (lambda: floquet.growth_rate(equations(omega**2 * q), {"omega": "1"}), "'1'"),
        (lambda: floquet.growth_rate(equations(omega**2 * q), {"omega": 1}, workers="2"), "'2'"),
        (lambda: floquet.growth_rate(equations(omega**2 * q), {"omega": 1}, tolerance="x"), "'x'"),
        (lambda: floquet.growth_rate(equations(omega**2 * q), {"omega": 1}, max_steps=2.5), "2.5"),
    ],
)
def test_arguments_of_the_wrong_kind_are_named(call: object, named: str) -> None:
    with pytest.raises(FloquetError, match=named):
        call()
