"""Resonances found from the divisors, against lists known for each system."""

from __future__ import annotations

import itertools

import pytest
import sympy as sp
from systems import (
    Omega,
    Omega_2,
    alpha,
    beta,
    coupled_mathieu,
    d,
    f,
    k,
    kappa,
    linear_rotor,
    mathieu,
    omega,
    omega_1,
    omega_2,
    oscillator,
    pair,
    t,
    x,
    y,
)

from mmsgen.errors import MmsgenError, ResonanceError
from mmsgen.resonance import Resonance
from mmsgen.scaling import ScaledSystem
from mmsgen.tables import ResonanceTable, relation_text

w_x, w_y, w_phi = sp.symbols("omega_x omega_y omega_phi", positive=True)


def found(table: ResonanceTable) -> dict[tuple[sp.Expr, sp.Expr], Resonance]:
    return {(r.relation.lhs, r.relation.rhs): r for r in table}


def kinds(scaled: ScaledSystem, order: int) -> dict[str, tuple[str, int]]:
    """Relation → kind and order, of the coupled ones."""
    table = scaled.resonances(order).coupled
    return {relation_text(r.relation, table.parameters): (r.kind, r.order) for r in table}


ROTOR_FIRST = {(Omega, own + w_phi): "sum combination" for own in (w_x, w_y)} | {
    (Omega, form): "difference combination"
    for own in (w_x, w_y)
    for form in (own - w_phi, w_phi - own)
}


@pytest.mark.parametrize("n", [2, 3, 4, 5])
def test_rotor_order_one_has_six_relations(n: int) -> None:
    """The issue's list, and nothing else; with the coordinates that take part."""
    table = found(linear_rotor(n).scale({"r_m": 1, "r_b": 1}).resonances(order=1))
    assert {relation: r.kind for relation, r in table.items()} == ROTOR_FIRST
    blades = tuple(f"phi_{j + 1}" for j in range(n))
    for (_, rhs), r in table.items():
        assert r.order == 1 and r.coupled and not r.reason
        assert r.coordinates == ("x" if rhs.has(w_x) else "y", *blades)


@pytest.mark.parametrize("n", [2, 3, 4, 5])
def test_rotor_order_two(n: int) -> None:
    """Through the blades the supports act on each other with e^{±2iΩt}: 2Ω = ω_i ± ω_j, Ω = ω_i.

    The sum Σ_k e^{4πik/N} over the blades is zero for N ≥ 3 and two for N = 2: only the rotor of
    two blades has the parametric ones. A blade's own, Ω = ω_φ, has the coefficient of −Ω² + 2Ωω_φ −
    ω_φ² = −(Ω − ω_φ)² twice, so it vanishes there.
    """
    table = found(linear_rotor(n).scale({"r_m": 1, "r_b": 1}).resonances(order=2))
    second = {relation: r for relation, r in table.items() if r.order == 2}
    assert {relation: r.kind for relation, r in table.items() if r.order == 1} == ROTOR_FIRST
    parametric = {
        (2 * Omega, w_x + w_y): "sum combination",
        (2 * Omega, w_x - w_y): "difference combination",
        (2 * Omega, w_y - w_x): "difference combination",
        (Omega, w_x): "parametric 1:1",
        (Omega, w_y): "parametric 1:1",
        (Omega, w_phi): "parametric 1:1",
    }
    assert {relation: r.kind for relation, r in second.items()} == {
        **parametric,
        (w_y, w_x): "internal 1:1",
    }
    for relation in parametric:
        r = second[relation]
        expected = "cancel in the sum" if relation[1] != w_phi else r"(Omega - omega_phi)**4"
        assert r.coupled == (n == 2 and relation[1] != w_phi)
        assert (expected in r.reason) == (not r.coupled)
    assert second[w_y, w_x].coupled


def test_lists_of_single_oscillators() -> None:
    """Nayfeh and Mook (1979), chapters 4 and 5, name these."""
    eom = oscillator(alpha * x**3 - k * sp.cos(Omega * t))
    assert kinds(eom.scale({alpha: 1}), 1) == {
        "Omega = omega": ("primary", 0),
        "3*Omega = omega": ("superharmonic 3", 1),
        "Omega = 3*omega": ("subharmonic 1/3", 1),
    }
    assert kinds(eom.scale({alpha: 1, k: 1}), 2) == {
        "Omega = omega": ("primary", 1),
        "Omega = 3*omega": ("subharmonic 1/3", 2),
    }
    quadratic = oscillator(beta * x**2 - k * sp.cos(Omega * t)).scale({beta: 1})
    assert kinds(quadratic, 1) == {
        "Omega = omega": ("primary", 0),
        "2*Omega = omega": ("superharmonic 2", 1),
        "Omega = 2*omega": ("subharmonic 1/2", 1),
    }
    assert kinds(mathieu(), 3) == {
        "Omega = 2*omega": ("principal parametric", 1),
        "Omega = omega": ("parametric 1:1", 2),
        "3*Omega = 2*omega": ("parametric 2:3", 3),
    }
    assert kinds(oscillator(alpha * x**3).scale({alpha: 1}), 4) == {}


def test_numeric_frequencies() -> None:
    """ω is free while cos 2t is given, or the other way around."""
    numeric = oscillator(2 * alpha * sp.cos(2 * t) * x).scale({alpha: 1})
    assert kinds(numeric, 2) == {
        "omega = 1": ("principal parametric", 1),
        "omega = 2": ("parametric 1:1", 2),
    }
    given = oscillator(2 * alpha * sp.cos(Omega * t) * x, sp.Integer(1)).scale({alpha: 1})
    assert kinds(given, 2) == {
        "Omega = 2": ("principal parametric", 1),
        "Omega = 1": ("parametric 1:1", 2),
    }


def test_two_coordinates() -> None:
    assert kinds(coupled_mathieu(), 1) == {
        "Omega = omega_1 + omega_2": ("sum combination", 1),
        "Omega = omega_2 - omega_1": ("difference combination", 1),
        "Omega = omega_1 - omega_2": ("difference combination", 1),
    }
    internal = pair(alpha * x * y, alpha * x**2).scale({alpha: 1})
    assert kinds(internal, 1) == {"omega_2 = 2*omega_1": ("internal 2:1", 1)}


def test_several_excitations() -> None:
    terms = alpha * x**2 - k * sp.cos(Omega * t) - f * sp.cos(Omega_2 * t)
    table = kinds(oscillator(terms).scale({alpha: 1}), 1)
    for sign, lhs in ((1, "Omega_2 = omega - Omega"), (-1, "Omega_2 = Omega + omega")):
        assert table[lhs] == ("combination of excitations", 1), sign
    assert table["Omega_2 = omega"] == table["Omega = omega"] == ("primary", 0)


def test_coupling_that_a_factor_annuls() -> None:
    """x' and ωx beside each other at Ω = 2ω: β(cos Ωt x' − (Ω/2) sin Ωt x) is e^{iΩt}-free there.

    The part of e^{iΩt}ā is (β/2)(−iω + iΩ/2), zero on resonance.
    """
    term = beta * (sp.cos(Omega * t) * d(x) - Omega / 2 * sp.sin(Omega * t) * x)
    table = found(oscillator(term).scale({beta: 1}).resonances(order=1))
    r = table[Omega, 2 * omega]
    assert not r.coupled
    assert "Omega - 2*omega" in r.reason and "vanishes on the relation" in r.reason
    with pytest.raises(ResonanceError, match="does not have this resonance"):
        oscillator(term).scale({beta: 1}).expand(1, r.mapping)


SYSTEMS = {
    "rotor of two blades": lambda: linear_rotor(2).scale({"r_m": 1, "r_b": 1}),
    "rotor of three blades": lambda: linear_rotor(3).scale({"r_m": 1, "r_b": 1}),
    "mathieu": mathieu,
    "coupled": coupled_mathieu,
    "nonlinear": lambda: pair(
        alpha * x * y + f * sp.cos(Omega * t), beta * x * d(x) + kappa * sp.cos(Omega * t) * x
    ).scale({alpha: 1, beta: 1, f: 1, kappa: 1}),
}


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_table_and_the_expansion_agree(name: str) -> None:
    """Every coupled entry can be expanded at its order, and none that is not coupled can.

    Integer relations beside the table, with coefficients up to 3, are refused.
    """
    scaled = SYSTEMS[name]()
    table = scaled.resonances(order=2)
    for r in table:
        if r.coupled:
            assert scaled.expand(max(r.order, 1), r.mapping).relations
            if r.order == 2:
                with pytest.raises(ResonanceError, match="does not have"):
                    scaled.expand(1, r.mapping)
        else:
            with pytest.raises(ResonanceError, match="does not have"):
                scaled.expand(2, r.mapping)
    known = {sp.expand(r.relation.lhs - r.relation.rhs) for r in table}
    symbols = scaled.frequencies
    for lhs, a, b in itertools.product((1, 2, 3), (-1, 0, 1, 2), (0, 1, 3)):
        form = lhs * symbols[-1] - a * symbols[0] - (b * symbols[1] if len(symbols) > 2 else 0)
        ratios = {sp.cancel(form / other) for other in known}
        if any(ratio.is_Rational for ratio in ratios):
            continue
        with pytest.raises(ResonanceError):
            scaled.expand(1, {lhs * symbols[-1]: lhs * symbols[-1] - form})


def test_a_resonance_knows_its_distance() -> None:
    (first, *_) = mathieu().resonances(order=1)
    assert first.distance({"omega": 3.0, "Omega": 7.0}, mathieu().eom.parameters) == pytest.approx(
        1 / (2 * sp.pi.evalf()),
        rel=1e-14,  # three operations in doubles
    )
    with pytest.raises(MmsgenError, match="no value is given for Omega"):
        first.distance({"omega": 3.0}, mathieu().eom.parameters)
    with pytest.raises(MmsgenError, match="Omega must be a number"):
        first.distance({"omega": 3.0, "Omega": [1.0, 2.0]}, mathieu().eom.parameters)
    assert y not in mathieu().eom.coordinates
    assert omega_1 not in first.relation.free_symbols | {omega_2}


@pytest.mark.parametrize("natural", [sp.Integer(2), sp.Rational(1, 2), sp.Integer(1)])
def test_kinds_count_in_a_numeric_natural_frequency(natural: sp.Rational) -> None:
    given = oscillator(2 * alpha * sp.cos(Omega * t) * x, natural).scale({alpha: 1})
    assert sorted(kinds(given, 2).values()) == [
        ("parametric 1:1", 2),
        ("principal parametric", 1),
    ]
