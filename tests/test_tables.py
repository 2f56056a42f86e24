"""The table of resonances as text, LaTeX and HTML, and ranked by distance."""

from __future__ import annotations

import math
from html.parser import HTMLParser

import pytest
import sympy as sp
from systems import Omega, coupled_mathieu, linear_rotor, mathieu, omega, oscillator, t, x

from mmsgen.errors import MmsgenError
from mmsgen.parameters import Parameter
from mmsgen.tables import ResonanceTable, relation_latex, relation_text

PAPER = {"omega_x": 6 * math.pi, "omega_y": 8 * math.pi, "omega_phi": 11.0, "Omega": 30.0}


def rotor_table(order: int = 2) -> ResonanceTable:
    return linear_rotor(4).scale({"r_m": 1, "r_b": 1}).resonances(order=order)


def test_text() -> None:
    lines = str(mathieu().resonances(order=2)).splitlines()
    assert lines[0].split() == ["relation", "kind", "order", "coordinates", "coupling"]
    assert set(lines[1]) == {"-"}
    assert lines[2].split() == ["Omega", "=", "2*omega", "principal", "parametric", "1", "x", "yes"]
    assert lines[3].split() == ["Omega", "=", "omega", "parametric", "1:1", "2", "x", "yes"]
    assert repr(mathieu().resonances(order=2)).splitlines() == lines


def test_reasons_are_shown() -> None:
    text = str(rotor_table())
    assert text.count("cancel in the sum over the coordinates") == 5
    assert text.count("vanishes on the relation") == 1
    coupled = rotor_table().coupled
    assert isinstance(coupled, ResonanceTable)
    assert len(coupled) == 7 and "no:" not in str(coupled)
    uncoupled_first = [r.coupled for r in rotor_table()]
    assert uncoupled_first == sorted(uncoupled_first, reverse=True)


def test_positive_terms_come_first() -> None:
    a, b = sp.symbols("a b", positive=True)
    difference = sp.Eq(Omega, b - a, evaluate=False)
    assert relation_text(difference) == "Omega = b - a"
    assert relation_latex(difference) == r"\Omega = b - a"
    declared = [Parameter(b), Parameter(a)]
    assert relation_text(sp.Eq(Omega, a + b, evaluate=False), declared) == "Omega = b + a"


def test_latex() -> None:
    latex = rotor_table().to_latex()
    assert latex.startswith(r"\begin{tabular}{lllll}") and latex.endswith(r"\end{tabular}")
    assert r"$\Omega = \omega_{\phi} + \omega_{x}$" in latex
    assert r"phi\_1" in latex
    body = latex.splitlines()[1:-1]
    assert all(line.count("&") == 4 for line in body)
    outside = "".join(latex.split("$")[::2])
    assert "_" not in outside.replace(r"\_", "")
    assert "^" not in outside.replace(r"\^", "")


class Counter(HTMLParser):
    """Counts the rows and cells."""

    def __init__(self) -> None:
        super().__init__()
        self.seen: list[str] = []

    def handle_starttag(self, tag: str, attrs: list) -> None:
        self.seen.append(tag)


def test_html() -> None:
    parser = Counter()
    parser.feed(rotor_table()._repr_html_())
    assert parser.seen.count("tr") == 1 + len(rotor_table())
    assert parser.seen.count("td") == 5 * len(rotor_table())
    name = sp.Symbol("ω", positive=True)
    other = oscillator(2 * name * sp.cos(Omega * t) * x).scale({name: 1})
    assert "<td>" in other.resonances(order=1)._repr_html_()


def test_ranking_by_hand() -> None:
    """Distances |lhs − rhs|/2π of the six of order 1 at the paper's numbers, Ω = 30 rad/s."""
    ranked = rotor_table(order=1).rank(PAPER)
    w_x, w_y, w_phi, speed = PAPER.values()
    by_hand = sorted(
        abs(speed - form) / (2 * math.pi)
        for own in (w_x, w_y)
        for form in (own + w_phi, own - w_phi, w_phi - own)
    )
    # Four operations in doubles each.
    assert [ranked.distances[i] for i in range(6)] == pytest.approx(by_hand, rel=1e-13)
    assert ranked[0].relation.rhs == sum(sp.symbols("omega_x omega_phi", positive=True))
    assert ranked.headings[-1] == "distance (Hz)"
    assert str(ranked).splitlines()[2].split()[-1] == f"{by_hand[0]:.4g}"
    assert set(ranked) == set(rotor_table(order=1))
    assert not rotor_table().distances


def test_ranking_fills_in_definitions() -> None:
    """A frequency with a definition need not be given."""
    spring = sp.Symbol("c", positive=True)
    eom = oscillator(2 * spring * sp.cos(Omega * t) * x)
    defined = [Parameter(omega, definition=sp.sqrt(4 + spring)), *eom.parameters]
    named = {p.name: p for p in reversed(defined)}
    eom = type(eom)(eom.equations, eom.coordinates, tuple(named.values()))
    table = eom.scale({spring: 1}).resonances(order=1)
    ranked = table.rank({"c": 5.0, "Omega": 4.0})
    assert ranked.distances[0] == pytest.approx(2 / (2 * math.pi), rel=1e-14)


def test_ranking_needs_numbers() -> None:
    table = coupled_mathieu().resonances(order=1)
    with pytest.raises(MmsgenError, match="no value is given for omega_2"):
        table.rank({"omega_1": 1.0, "Omega": 2.0})
    with pytest.raises(MmsgenError, match="omega_3 is not a parameter"):
        table.rank({"omega_3": 1.0})


def test_an_empty_table() -> None:
    empty = ResonanceTable(())
    assert len(str(empty).splitlines()) == 2
    assert empty.to_latex().count("&") == 4
    assert len(empty.rank({})) == 0
