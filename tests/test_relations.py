"""Resonance relations: read, solved together, or refused with a reason."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp
from systems import (
    Omega,
    Omega_2,
    alpha,
    coupled_mathieu,
    mathieu,
    omega,
    omega_1,
    omega_2,
    oscillator,
    p,
    pair,
    same,
    sigma,
    sigma_1,
    sigma_2,
    t,
    x,
    y,
)

from mmsgen.errors import ResonanceError
from mmsgen.relations import solve_relations

F = Fraction
SYMBOLS = (omega_1, omega_2, Omega, Omega_2)


def solved(resonance: object) -> dict[str, tuple[dict, dict]]:
    """Resonant values and detunings by name."""
    _, detuned = solve_relations(resonance, SYMBOLS, frozenset())
    return {n: (dict(v.resonant), dict(v.detuning)) for n, v in detuned.items()}


def test_single_relations() -> None:
    assert solved(None) == solved({}) == {}
    assert solved({Omega: omega_1 + omega_2}) == {
        "Omega": ({"omega_1": F(1), "omega_2": F(1)}, {"sigma": F(1)})
    }
    assert solved({2 * Omega: omega_1 - omega_2}) == {
        "Omega": ({"omega_1": F(1, 2), "omega_2": F(-1, 2)}, {"sigma": F(1, 2)})
    }
    assert solved({Omega: 3 * omega_1 / 2 + 1}) == {
        "Omega": ({"omega_1": F(3, 2), "1": F(1)}, {"sigma": F(1)})
    }
    assert solved({Omega: 2}) == {"Omega": ({"1": F(2)}, {"sigma": F(1)})}


@pytest.mark.parametrize("turned", [False, True])
def test_relations_that_refer_to_each_other(turned: bool) -> None:
    """Ω = ω_1 + ω_2 + σ and ω_2 = 2ω_1 + σ': solved for Ω and ω_2 in any order."""
    items = [(Omega, omega_1 + omega_2), (omega_2, 2 * omega_1)]
    one, two = ("sigma_2", "sigma_1") if turned else ("sigma_1", "sigma_2")
    assert solved(dict(reversed(items) if turned else items)) == {
        "Omega": ({"omega_1": F(3)}, {one: F(1), two: F(1)}),
        "omega_2": ({"omega_1": F(2)}, {two: F(1)}),
    }


def test_solutions_satisfy_the_relations() -> None:
    """Put back in, each relation reads lhs − rhs = σ_i: three at once, two of them implicit."""
    relations = {2 * Omega: omega_1 + Omega_2, Omega_2: omega_2 + Omega / 3, omega_1: 2 * omega_2}
    read, detuned = solve_relations(relations, SYMBOLS, frozenset())
    names = {s.name: s for s in (*SYMBOLS, *(r.detuning for r in read))}
    values = {
        names[n]: sum(
            sp.Rational(c.numerator, c.denominator) * names.get(m, 1)
            for m, c in (*v.resonant.items(), *v.detuning.items())
        )
        for n, v in detuned.items()
    }
    for relation in read:
        gap = (relation.lhs - relation.rhs).subs(values, simultaneous=True)
        assert sp.expand(gap - relation.detuning) == 0


REFUSED = [
    ({"Omega": omega_1}, "'Omega', which is no expression"),
    ({Omega: "omega_1 + omega_2"}, "text is not evaluated"),
    ({Omega: None}, "None, which is no expression"),
    ({Omega: [omega_1]}, "no expression"),
    ({Omega: sp.Eq(omega_1, omega_2)}, "no expression"),
    ([Omega], "as a mapping"),
    ((Omega, omega_1), "as a mapping"),
    (Omega, "as a mapping"),
    (sp.Eq(Omega, omega_1), "as a mapping"),
    ({Omega: 2.0 * omega_1}, "rational combination"),
    ({Omega: sp.sqrt(2) * omega_1}, "rational combination"),
    ({Omega: omega_1 * omega_2}, r"offending part: omega_1\*omega_2"),
    ({Omega: sp.I * omega_1}, "rational combination"),
    ({Omega: x}, r"offending part: x\(t\)"),
    ({Omega: sp.oo}, "rational combination"),
    ({Omega: sp.nan}, "rational combination"),
    ({Omega: p}, "p in the relation is no frequency.*omega_1, omega_2, Omega"),
    ({p: omega_1}, "p in the relation is no frequency"),
    ({Omega: sp.Symbol("omega_1")}, "another symbol than the omega_1"),
    ({2: omega_1}, "leaves no frequency to detune"),
    ({Omega + omega_1: omega_2}, "leaves no frequency to detune"),
    ({Omega: Omega}, "leaves no frequency to detune"),
    ({Omega: 0}, "not positive"),
    ({Omega: -omega_1}, "Omega = -1.omega_1 on resonance, which is not positive"),
    ({Omega: omega_1, 2 * Omega: omega_2}, "already fixed"),
    ({Omega: omega_1, omega_1: Omega}, "contradicts the others or follows"),
    ({Omega: omega_1 + omega_2, omega_1: Omega + omega_2}, "contradict|not positive"),
    ({omega_1: omega_2, omega_2: 2 * omega_1}, "not positive"),
    ({omega_1: 2 * omega_2 + Omega, omega_2: omega_1 + Omega}, "not positive"),
]


@pytest.mark.parametrize(("resonance", "message"), REFUSED, ids=lambda v: str(v)[:40])
def test_refusals(resonance: object, message: str) -> None:
    with pytest.raises(ResonanceError, match=message):
        solve_relations(resonance, SYMBOLS, frozenset())


def test_text_is_never_executed(tmp_path) -> None:
    """SymPy executes the strings that it turns into expressions; none may reach it."""
    target = tmp_path / "trace"
    code = f"__import__('pathlib').Path({str(target)!r}).touch()"
    for resonance in ({code: omega}, {Omega: code}, code):
        with pytest.raises(ResonanceError):
            mathieu().expand(order=1, resonance=resonance)
    with pytest.raises(ValueError, match="amplitude"):
        oscillator(alpha * x**3).scale({alpha: 1}, amplitude=code)
    with pytest.raises(ValueError, match="order of alpha"):
        oscillator(alpha * x**3).scale({alpha: code})
    assert not target.exists()


def test_detunings_may_not_have_the_name_of_a_parameter() -> None:
    with pytest.raises(ResonanceError, match="sigma has the name of a detuning"):
        solve_relations({Omega: omega_1}, SYMBOLS, frozenset({"sigma"}))
    two = {Omega: omega_1, Omega_2: omega_2}
    with pytest.raises(ResonanceError, match="sigma_2 has the name of a detuning"):
        solve_relations(two, SYMBOLS, frozenset({"sigma_2"}))
    solve_relations(two, SYMBOLS, frozenset({"sigma"}))


def test_relations_that_the_system_does_not_have() -> None:
    scaled = mathieu()
    for idle in ({Omega: omega / 2}, {Omega: 3 * omega}, {Omega: 5 * omega / 7}):
        with pytest.raises(ResonanceError, match=r"no term.*does not have this resonance"):
            scaled.expand(order=1, resonance=idle)
    with pytest.raises(ResonanceError, match="Omega = omega:"):
        scaled.expand(order=1, resonance={Omega: omega})
    assert scaled.expand(order=2, resonance={Omega: omega}).relations


def test_one_idle_relation_among_two() -> None:
    with pytest.raises(ResonanceError, match=r"omega_2 = 5\*omega_1"):
        coupled_mathieu().expand(
            order=1, resonance={Omega: omega_1 + omega_2, omega_2: 5 * omega_1}
        )


@pytest.mark.parametrize("order", [1, 2])
def test_the_same_relation_solved_for_any_of_its_frequencies(order: int) -> None:
    """Ω = ω_1 + ω_2 + σ is ω_2 = Ω − ω_1 − σ: each way around, one and the same growth rate.

    The expansions keep different frequencies, so that they differ by what the order leaves out:
    f = 10⁻³ and σ of that size leave a relative error of about (10⁻³)^order; 10 times that.
    """
    scaled = coupled_mathieu()
    base = {"omega_1": 1.0, "omega_2": 1.7, "f_12": 1e-3, "f_21": 1.3e-3, "sigma": 2e-4}
    first = scaled.expand(order, {Omega: omega_1 + omega_2}).slow_flow.growth_rate(base)
    turned = {**base, "Omega": 2.7002, "sigma": -2e-4}
    for name, relation in (
        ("omega_2", {omega_2: Omega - omega_1}),
        ("omega_1", {omega_1: Omega - omega_2}),
    ):
        values = {n: v for n, v in turned.items() if n != name}
        rate = scaled.expand(order, relation).slow_flow.growth_rate(values)
        assert abs(rate - first) < 10 * first * 1e-3**order
    assert first > 4e-4


def test_detuned_natural_frequency() -> None:
    """{ω: Ω/2} detunes the stiffness, ω² = (Ω/2 + εσ)²; D1A = iσA + iα Ā/Ω by hand."""
    ((a, rate),) = mathieu().expand(1, {omega: Omega / 2}).solvability[1].items()
    assert same(rate, sp.I * sigma * a + sp.I * alpha * sp.conjugate(a) / Omega)


def test_two_detunings_of_one_coordinate() -> None:
    """Each relation has a σ of its own: Ω = 2ω_1 + σ_1 and ω_2 = ω_1 + σ_2."""
    scaled = pair(2 * alpha * sp.cos(Omega * t) * x + alpha * y, alpha * x).scale({alpha: 1})
    case = scaled.expand(1, {Omega: 2 * omega_1, omega_2: omega_1})
    assert [r.detuning for r in case.relations] == [sigma_1, sigma_2]
    a, b = case.amplitudes
    rates = case.solvability[1]
    turned = sp.exp(sp.I * sigma_1 * t)
    expected = sp.I * alpha * (sp.conjugate(a) * turned + b) / (2 * omega_1)
    assert same(rates[a], expected)
    assert same(rates[b], sp.I * sigma_2 * b + sp.I * alpha * a / (2 * omega_1))
    assert y in case.coordinates
