"""Multiple scales and averaging give one slow flow, exactly: each entry of the catalogue, and more.

Both methods define the amplitude as the whole fundamental, and with that every coefficient of every
order is determined. They are compared monomial by monomial, as rational functions multiplied out.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest
import sympy as sp
from certify_systems import f_12, f_21
from entries import ROOT, cases_of
from laurent import IOTA, Key, Poly, plus
from second_method import Averaging
from systems import (
    Omega,
    Omega_2,
    alpha,
    beta,
    d,
    equations,
    f,
    k,
    kappa,
    mu,
    omega,
    omega_1,
    omega_2,
    p,
    t,
    x,
    y,
)

from mmsgen.symbols import amplitude

CATALOGUE = sorted(
    path.stem
    for path in (ROOT / "derivations").glob("*.py")
    if path.read_text("utf-8").startswith("# %%") and "mg.Emission(" in path.read_text("utf-8")
)
# Entries with long cases, and how many of these to do every day.
LONG = {"ground_resonance": 1, "ground_resonance_forced": 0}


def coefficients(averaging: Averaging, rate: Poly) -> dict[Key, Poly]:
    """By powers of A and Ā, and the slow phase over t."""
    space, n, d = averaging.space, 2 * averaging.n, averaging.space.dynamic
    out: dict[Key, Poly] = {}
    for key, c in rate.items():
        wave = (*key[:d], *(0,) * (len(key) - d))
        drift = averaging.drift({wave: -IOTA})
        angle = space.expression({(*(0,) * d, *m[d:]): e for m, e in drift.items()})
        name, rest = (key[:n], sp.expand(angle)), {(*(0,) * d, *key[d:]): c}
        out[name] = plus(out.get(name, {}), rest)
    return out


def printed(case: Any, rate: sp.Expr) -> dict[Key, sp.Expr]:
    """The same of a solvability condition."""
    time = case.weak.scaled.eom.time
    state = [s for a in case.amplitudes for s in (a, sp.conjugate(a))]
    out: dict[Key, sp.Expr] = {}
    for term in sp.Add.make_args(rate):
        c, rest = term.as_independent(*state, *term.atoms(sp.exp), as_Add=False)
        powers = rest.as_powers_dict()
        angle = sp.expand(powers.get(sp.E, 0) / (sp.I * time))
        name = (tuple(int(powers.get(s, 0)) for s in state), angle)
        out[name] = out.get(name, sp.Integer(0)) + c
    return out


def disagreements(case: Any, averaging: Averaging) -> list[tuple[int, sp.Symbol, Key]]:
    """(order, amplitude, monomial) where the two methods differ."""
    found = []
    for order, row in enumerate(averaging.rates_of, start=1):
        for own, a in zip(row, case.amplitudes, strict=True):
            ours = coefficients(averaging, own)
            theirs = printed(case, case.solvability[order][a])
            for name in [*ours, *(m for m in theirs if m not in ours)]:
                other = theirs.get(name, sp.Integer(0))
                if not averaging.space.equal(ours.get(name, {}), other):
                    found.append((order, a, name))
    return found


def highest(cases: Iterable[Any]) -> list[Any]:
    """One case for each set of relations: that of the highest order, which contains the others."""
    best: dict[Any, Any] = {}
    for case in cases:
        key = id(case.weak.scaled), case.relations
        if key not in best or case.order > best[key].order:
            best[key] = case
    return list(best.values())


def smooth_part(case: Any) -> Any:
    """The case without its non-smooth forces, whose average this second method does not know.

    They only add terms with moduli of amplitudes, at the highest order.
    """
    scaled, order = case.weak.scaled, case.order
    if not scaled.alphabet.kinked:
        return case

    def smooth(e: sp.Expr) -> sp.Expr:
        return sp.Add(*(t for t in sp.Add.make_args(e) if not t.has(sp.Abs, sp.sign)))

    eom = scaled.eom.with_occurring(
        map(smooth, scaled.eom.equations), scaled.eom.coordinates, scaled.eom.parameters
    )
    orders = {s: k for s, k in scaled.orders if s in {p.symbol for p in eom.parameters}}
    weights = dict(zip(eom.coordinates, scaled.amplitude, strict=True))
    rest = eom.scale(orders, weights).expand(order, {r.lhs: r.rhs for r in case.relations})
    for a, rate in case.solvability[order].items():
        assert smooth(sp.expand(rate)) == sp.expand(rest.solvability[order][a])
    return rest


def demand_agreement(case: Any) -> None:
    case = smooth_part(case)
    averaging = Averaging(case, case.order)
    assert any(any(row) for row in averaging.rates_of)
    assert not disagreements(case, averaging)


@pytest.mark.parametrize("name", CATALOGUE)
def test_both_methods_agree_on_the_catalogue(name: str) -> None:
    cases = highest(cases_of(name))
    for case in cases[: LONG.get(name)]:
        demand_agreement(case)


@pytest.mark.slow
@pytest.mark.parametrize("name", LONG)
def test_both_methods_agree_on_every_long_case(name: str) -> None:
    for case in highest(cases_of(name))[LONG[name] :]:
        demand_agreement(case)


# -- what the catalogue has not ------------------------------------------------------------


def linear(q: sp.Expr, frequency: sp.Expr) -> sp.Expr:
    return d(q, 2) + frequency**2 * q


one, two, three = sp.cos(t), sp.cos(2 * t), sp.cos(3 * t)
beat = sp.cos(Omega * t) + sp.cos(Omega_2 * t)
quarter, turned = sp.cos(Omega * t), sp.cos(Omega * t + sp.pi / 2)
X1, Y1, Y2, Y3 = linear(x, 1), linear(y, 1), linear(y, 2), linear(y, 3)
X, P, Q = linear(x, omega), linear(x, omega_1), linear(y, omega_2)

FREQUENCIES = {omega, omega_1, omega_2, Omega, Omega_2}

# left sides, orders in ε, amplitudes, relations, order; without orders, all but frequencies are
# of order 1
SYSTEMS: dict[str, tuple[Any, ...]] = {
    "van der pol": ([X1 - mu * (1 - x**2) * d(x)], {}, 0, None, 3),
    "rayleigh with quadratic": ([X1 + mu * d(x) ** 3 - mu * d(x) + beta * x**2], {}, 0, None, 2),
    "products": (
        [linear(x, 2) + alpha * x * d(x) + beta * x**2 * d(x) + kappa * d(x) ** 2], {}, 0, None, 3,
    ),
    "parametric three": ([X1 + alpha * three * x + mu * two * d(x)], {}, 0, None, 3),
    "primary with quadratic": (
        [X1 + beta * x**2 - f * one + kappa * sp.sin(t) * x], {}, 0, None, 2,
    ),
    "equal, coupled": (
        [X1 + kappa * y + alpha * x**3, Y1 + kappa * x + mu * d(y)], {}, 0, None, 2,
    ),
    "equal, through velocities": (
        [X1 + alpha * x * d(y), Y1 + beta * y**2 - kappa * d(x)], {}, 0, None, 2,
    ),
    "two to one": (
        [X1 + alpha * x * y + mu * d(x), Y2 + alpha * x**2 / 2 + kappa * y * d(y)], {}, 0, None, 2,
    ),
    "three to one": (
        [X1 + alpha * x**2 * y + beta * y**2, Y3 + alpha * x**3 + kappa * x * y], {}, 0, None, 2,
    ),
    "difference, whole numbers": (
        [linear(x, 2) + 2 * f_12 * one * y, Y3 + 2 * f_21 * one * x + mu * d(y)], {}, 0, None, 2,
    ),
    "half order": ([X + alpha * x**3 + mu * d(x)], {mu: 1}, sp.Rational(1, 2), None, 2),
    "accelerations": (
        [X * (1 + kappa * quarter) + kappa * x * (x * d(x, 2) + d(x) ** 2) + alpha * x**3],
        {}, 0, {Omega: 2 * omega}, 3,
    ),
    "coupled accelerations": (
        [P + kappa * quarter * d(y, 2) + mu * x**2 * d(x, 2), Q + kappa * turned * d(x, 2)],
        {}, 0, {Omega: omega_1 + omega_2}, 2,
    ),
    "expandable": (
        [d(x, 2) + omega**2 * sp.tan(x) / (1 + alpha * x) + mu * d(x) * sp.exp(x)],
        {mu: 1}, 1, None, 3,
    ),
    "hard and soft, two frequencies": (
        [X + alpha * x**3 + mu * d(x) - f * quarter - kappa * sp.cos(Omega_2 * t)],
        {alpha: 1, mu: 2, kappa: 1}, 0, {Omega: omega / 3, Omega_2: omega}, 2,
    ),
    "hard, quasi-periodic, quadratic": (
        [X + alpha * x**2 + mu * d(x) ** 2 - f * beat],
        {alpha: 1, mu: 1}, 0, {Omega_2: omega - Omega}, 2,
    ),
    "hard on two": (
        [P + alpha * x * y - f * quarter, Q + beta * x * d(x) + mu * d(y, 2) * x],
        {alpha: 1, beta: 1, mu: 1}, 0, {Omega: omega_1 + omega_2}, 2,
    ),
    "coupled modes": (
        [
            2 * d(x, 2) + kappa * d(y, 2) + p * x - beta * y + alpha * x**3,
            d(y, 2) + kappa * d(x, 2) + k * y - beta * x + mu * d(y) * y,
        ],
        {alpha: 1, mu: 1}, 0, None, 2,
    ),
    "coupled modes, one to two": (
        [d(x, 2) + p * x - beta * y + alpha * x**2, d(y, 2) + k * y - beta * x + mu * d(x, 2) * y],
        {alpha: 1, mu: 1}, 0, {omega_2: 2 * omega_1}, 2,
    ),
    "gyroscopic, driven": (
        [
            d(x, 2) - beta * d(y) + p * x + alpha * x**3 - f * quarter,
            d(y, 2) + beta * d(x) + k * y + mu * (d(y) + d(x, 2)),
        ],
        {alpha: 1, mu: 1, f: 1}, 0, {Omega: omega_2}, 2,
    ),
    "gyroscopic, one to one": (
        [
            d(x, 2) - beta * d(y) + p * x + alpha * quarter * d(y, 2),
            d(y, 2) + beta * d(x) + k * y + mu * x**2,
        ],
        {alpha: 1, mu: 1}, 0, {Omega: omega_2 - omega_1, omega_2: 2 * omega_1}, 2,
    ),
}  # fmt: skip


def system(name: str) -> Any:
    left, orders, weight, relations, order = SYSTEMS[name]
    eom = equations(left, [x, y][: len(left)])
    every = {p.symbol: 1 for p in eom.parameters if p.symbol not in FREQUENCIES}
    return eom.scale(orders or every, amplitude=weight).expand(order, relations)


@pytest.mark.parametrize("name", SYSTEMS)
def test_both_methods_give_one_slow_flow(name: str) -> None:
    demand_agreement(system(name))


# -- the comparison is a test --------------------------------------------------------------


def test_without_the_change_to_the_fundamental_it_is_another_normal_form() -> None:
    case = system("van der pol")
    other = Averaging(case, 2, fundamental=False)
    a = amplitude(x)
    assert {(order, name) for order, name, _ in disagreements(case, other)} == {(2, a)}
    linear_term = coefficients(other, other.rates_of[1][0])[(1, 0), sp.Integer(0)]
    assert other.space.expression(linear_term) == -sp.I * mu**2 / 8


@pytest.mark.parametrize("order", [1, 2])
def test_one_wrong_coefficient_is_found(order: int) -> None:
    case = system("coupled accelerations")
    averaging = Averaging(case, 2)
    row = averaging.rates_of[order - 1][1]
    key = next(iter(row))
    row[key] *= 2
    assert len(disagreements(case, averaging)) == 1
