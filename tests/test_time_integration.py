"""Modulated solutions against time integration of the unexpanded equations.

The error over times of order 1/ε is of order ε^N for an expansion of order N, the motion being
reconstructed through q_0 … q_{N−1} and the amplitudes from D_1 … D_N: what is left out of dA/dt,
ε^{N+1}, adds up over 1/ε. So halving ε divides the error by 2^N, times a factor 1 + O(ε).
"""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from systems import (
    Omega,
    alpha,
    beta,
    d,
    equations,
    f,
    kappa,
    mu,
    omega_1,
    omega_2,
    t,
    theta,
    x,
    y,
)

from mmsgen.expansion import Expansion
from mmsgen.scaling import ScaledSystem
from mmsgen.symbols import time_scale

END = 1.5
"""Slow time εt at which the comparison ends."""


def nonlinear_pair() -> tuple[ScaledSystem, dict[sp.Expr, sp.Expr], dict[sp.Symbol, float]]:
    """Internal resonance 2:1 with quadratic and cubic terms, damping, primary forcing."""
    left = [
        d(x, 2)
        + omega_1**2 * x
        + alpha * x * y
        + mu * d(x)
        + kappa * x**3
        - f * sp.cos(Omega * t + theta),
        d(y, 2) + omega_2**2 * y + beta * x**2 + mu * d(y) + beta * d(x) * y,
    ]
    scaled = equations(left, (x, y)).scale({alpha: 1, beta: 1, mu: 1, kappa: 1, f: 1})
    values = {alpha: 1.1, beta: 0.7, mu: 0.2, kappa: 0.5, f: 0.8, theta: 0.6, omega_1: 1.0}
    return scaled, {Omega: omega_1, omega_2: 2 * omega_1}, values


def parametric_pair() -> tuple[ScaledSystem, dict[sp.Expr, sp.Expr], dict[sp.Symbol, float]]:
    """Sum combination through displacement, velocity and acceleration; inertia that moves."""
    c, s = sp.cos(Omega * t), sp.sin(Omega * t + theta)
    left = [
        d(x, 2) * (1 + kappa * x) + omega_1**2 * x + alpha * c * y + beta * s * d(y, 2),
        d(y, 2) + omega_2**2 * y + alpha * c * d(x) + mu * d(y) + f * x**2 * y,
    ]
    scaled = equations(left, (x, y)).scale({alpha: 1, beta: 1, mu: 1, kappa: 1, f: 1})
    values = {alpha: 0.9, beta: 0.3, mu: 0.1, kappa: 0.4, f: 0.6, theta: 0.4}
    return scaled, {Omega: omega_1 + omega_2}, {**values, omega_1: 1.0, omega_2: 1.6}


DETUNINGS = (0.3, -0.2)
START = (0.4 + 0.2j, -0.3 + 0.25j)


def numbers(case: Expansion, values: dict[sp.Symbol, float], e: float) -> dict[sp.Symbol, float]:
    """All values at one ε: small ones and detunings times ε, resonant frequencies exactly."""
    small = {s for s, order in case.weak.scaled.orders if order}
    result = {s: v * e if s in small else v for s, v in values.items()}
    for relation, size in zip(case.relations, DETUNINGS, strict=False):
        result[relation.detuning] = e * size
    for _ in case.relations:  # one relation may refer to another
        for relation in case.relations:
            (pivot,) = relation.lhs.free_symbols
            value = (relation.rhs + relation.detuning).subs(result)
            if not value.free_symbols:
                result[pivot] = float(value)
    return result


def motion(case: Expansion, order: int) -> list[sp.Expr]:
    """q_j and then q_j' from the expansion, in A, its conjugate and t."""
    rates = case.slow_flow.complex
    bars = {sp.conjugate(a): sp.Symbol(f"{a}_bar") for a in case.amplitudes}
    positions, velocities = [], []
    for q in case.coordinates:
        total = sp.Add(*(case.particular(p)[q] for p in range(order)))
        total = total.subs(time_scale(0), t).subs(bars)
        rate = total.diff(t)
        for a, bar in zip(case.amplitudes, bars.values(), strict=True):
            swapped = sp.conjugate(rates[a]).subs(bars)
            rate += total.diff(a) * rates[a].subs(bars) + total.diff(bar) * swapped
        positions.append(total)
        velocities.append(rate)
    return [*positions, *velocities]


def error(setup: tuple, order: int, e: float) -> float:
    """The largest difference in displacement at 4000 times up to END/ε, 8 and more a period."""
    scaled, relations, values = setup
    case = scaled.expand(order, relations)
    table = numbers(case, values, e)
    amplitudes = case.amplitudes
    bars = [sp.Symbol(f"{a}_bar") for a in amplitudes]
    names = [t, *amplitudes, *bars]
    rates = sp.lambdify([t, *amplitudes], [r.subs(table) for r in case.slow_flow.complex.values()])
    shape = sp.lambdify(names, [m.subs(table) for m in motion(case, order)])
    end = END / e
    times = np.linspace(end / 4000, end, 4000)

    def slow(when: float, a: np.ndarray) -> np.ndarray:
        return np.array(rates(when, *a))

    options = {"rtol": 1e-11, "atol": 1e-13, "method": "DOP853"}
    modulated = solve_ivp(slow, (0, end), np.array(START), t_eval=times, **options).y

    def reconstructed(when: float, a: np.ndarray) -> np.ndarray:
        return np.real(np.array(shape(when, *a, *np.conj(a))))

    eom = scaled.eom
    size = len(eom.coordinates)
    accelerations = [q.diff(t, 2) for q in eom.coordinates]
    marks = sp.symbols(f"w0:{size}")
    exact = [
        m.subs(dict(zip(accelerations, marks, strict=True))).subs(table) for m in eom.equations
    ]
    matrix, right = sp.linear_eq_to_matrix(exact, marks)
    state = [v for n in (1, 0) for v in [q.diff(t, n) if n else q for q in eom.coordinates]]
    plain = dict(zip(state, sp.symbols(f"p0:{2 * size}"), strict=True))
    replaced = [part.subs(plain) for part in (matrix, right)]
    position = [plain[q] for q in eom.coordinates]
    velocity = [plain[q.diff(t)] for q in eom.coordinates]
    mass, force = (sp.lambdify([t, *position, *velocity], part, "numpy") for part in replaced)

    def unexpanded(when: float, s: np.ndarray) -> np.ndarray:
        return np.concatenate((s[size:], np.linalg.solve(mass(when, *s), force(when, *s)).ravel()))

    first = reconstructed(0.0, np.array(START))
    true = solve_ivp(unexpanded, (0, end), first, t_eval=times, **options).y
    guess = np.real(np.array(shape(times, *modulated, *np.conj(modulated))))
    assert np.abs(modulated).max() > 0.3 and np.ptp(np.abs(modulated[0])) > 0.02
    return float(np.abs(true[:size] - guess[:size]).max())


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize(
    "setup", [nonlinear_pair, pytest.param(parametric_pair, marks=pytest.mark.slow)]
)
def test_the_error_falls_like_a_power(setup: object, order: int) -> None:
    """From ε = 1/64 to 1/128 by 2^N: the exponent within 0.05 of N.

    The quotient of the errors is 2^N (1 + cε), with c the ratio of the first two terms left out,
    of size 1 for parameters of size 1: log2 of it is off by 0.02 at c = 2. Integration errors are
    below 1e-9, the smallest difference is 8e-6.
    """
    coarse, fine = (error(setup(), order, e) for e in (1 / 64, 1 / 128))
    assert fine > 5e-6
    assert np.log2(coarse / fine) == pytest.approx(order, abs=0.05)


def test_a_wrong_coefficient_would_show(monkeypatch: pytest.MonkeyPatch) -> None:
    """With D_2 left out the error of order 2 falls like ε only."""
    right = Expansion.solvability.func

    def without_second(case: Expansion) -> dict:
        full = right(case)
        return {p: rates if p < 2 else dict.fromkeys(rates, sp.S.Zero) for p, rates in full.items()}

    monkeypatch.setattr(Expansion, "solvability", property(without_second))
    coarse, fine = (error(nonlinear_pair(), 2, e) for e in (1 / 64, 1 / 128))
    assert np.log2(coarse / fine) == pytest.approx(1, abs=0.1)
