"""The slow flow as a table of terms: against its symbolic forms, and its derivatives."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from systems import Omega, alpha, beta, d, equations, kappa, mu, omega_1, omega_2, t, x, y

from mmsgen.runtime._flow import Flow, jacobian, rates, spectrum
from mmsgen.slowflow import SlowFlow

VALUES = {"omega_1": 1.3, "omega_2": 2.1, "alpha": 0.3, "beta": 0.7, "mu": 0.11, "kappa": 0.4}


def driven() -> SlowFlow:
    left = d(x, 2) + omega_1**2 * x + alpha * x**3 + mu * d(x) - kappa * sp.cos(Omega * t + 1)
    scaled = equations([left], [x]).scale({alpha: 1, mu: 1, kappa: 1})
    return scaled.expand(2, {Omega: omega_1}).slow_flow


def coupled() -> SlowFlow:
    left = [
        d(x, 2) + omega_1**2 * x + alpha * x * y + mu * d(x),
        d(y, 2) + omega_2**2 * y + beta * x**2 + mu * d(y),
    ]
    scaled = equations(left, [x, y]).scale({alpha: 1, beta: 1, mu: 1})
    return scaled.expand(2, {omega_2: 2 * omega_1}).slow_flow


@pytest.mark.parametrize("flow", [driven(), coupled()], ids=["driven", "coupled"])
def test_rates_and_jacobian_are_those_of_the_cartesian_form(flow: SlowFlow) -> None:
    case, table = flow.case, flow.table
    names = [p.name for p in case.parameters]
    values = {n: v for n, v in {**VALUES, "sigma": 0.2}.items() if n in names}
    random = np.random.default_rng(3)
    point = random.normal(size=2 * len(case.amplitudes))
    b = (point[0::2] + 1j * point[1::2]) / 2
    numbers = {s: v for s, v in zip(flow.cartesian, point, strict=True)}
    numbers |= {p.symbol: values.get(p.name, 0) for p in case.parameters}
    exact = np.array([complex(e.subs(numbers)).real for e in flow.cartesian.values()])
    c = table.numbers(values)
    found = 2 * rates(table.flow, c, b)
    # A dozen terms of size 1: a few roundings of 1e-16 each.
    assert np.ravel(np.stack([found.real, found.imag], -1)) == pytest.approx(exact, abs=1e-14)
    matrix = np.array(flow.jacobian.subs(numbers), dtype=complex).real
    assert jacobian(table.flow, c, b) == pytest.approx(matrix, abs=1e-14)


def test_symmetries() -> None:
    assert driven().table.flow.symmetries == ()
    assert coupled().table.flow.symmetries == ((1, 2),)


def test_moduli_and_their_derivatives() -> None:
    """c |B| B and c |B|³ B̄ beside central differences: their error is h² and 1e-16/h, h = 1e-5."""
    flow = Flow(1, ((0, (1, 0, 1)), (0, (0, 1, 3))))
    c, b, h = np.array([0.3 - 0.2j, 0.5j]), np.array([0.4 - 0.7j]), 1e-5
    matrix = jacobian(flow, c, b)
    for k, step in enumerate((h / 2, 1j * h / 2)):
        slope = (rates(flow, c, b + step) - rates(flow, c, b - step))[0] / h
        assert matrix[0, k] + 1j * matrix[1, k] == pytest.approx(slope, abs=1e-9)
    assert np.all(jacobian(flow, c, [0.0]) == 0.0)


def test_spectrum_leaves_out_what_a_symmetry_makes_zero() -> None:
    """B' = B − B|B|²·(1 + i): the circle |B| = 1 turns at −1; its other eigenvalue is −2."""
    flow = Flow(1, ((0, (1, 0, 0)), (0, (2, 1, 0))), ((1,),))
    values = spectrum(flow, np.array([1.0, -1.0 - 1.0j]), np.array([1.0]), np.array([-1.0]))
    assert values[0] == pytest.approx(-2.0, abs=1e-12)
    assert np.isnan(values[1])
    at_rest = spectrum(flow, np.array([1.0, -1.0 - 1.0j]), np.array([0.0]), np.array([0.0]))
    assert at_rest == pytest.approx([1.0, 1.0])


def test_arrays_broadcast() -> None:
    table = driven().table
    values = {n: v for n, v in VALUES.items() if n in {p.name for p in table.parameters}}
    c = table.numbers({**values, "sigma": np.linspace(0, 1, 5)})
    b = np.full((3, 5, 1), 0.2j)
    assert rates(table.flow, c, b).shape == (3, 5, 1)
    assert jacobian(table.flow, c, b).shape == (3, 5, 2, 2)
    assert spectrum(table.flow, c, b).shape == (3, 5, 2)
