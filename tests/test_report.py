"""Formulas as they are printed: read back, they mean what the records hold."""

from __future__ import annotations

import re
from functools import cache

import pytest
import rotor
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from latex_values import balanced, value
from systems import Omega, alpha, beta, d, f, linear_rotor, mu, omega, oscillator, t, x, y

import mmsgen as mg
from mmsgen import report
from mmsgen.certificate import Certificate, Fit, Zone
from mmsgen.expansion import Expansion
from mmsgen.lines import LINE, merged_roots, width
from mmsgen.report import Formula, Statement, Table

NUMBERS = [0.71, 1.13, 0.37, 1.9, 0.53, 2.3, 0.83, 1.7, 0.29, 1.31, 3.1, 0.61, 1.49, 2.7, 0.47]


@cache
def rotor_case(order: int, n: int = 3) -> Expansion:
    eom = linear_rotor(n)
    s = {p.name: p.symbol for p in eom.parameters}
    scaled = eom.scale({"r_m": 1, "r_b": 1})
    return scaled.expand(order, {s["Omega"]: s["omega_x"] + s["omega_phi"]})


def numbers_of(case: Expansion) -> tuple[dict[sp.Expr, complex], dict[str, complex]]:
    """Numbers for all symbols, and the same by their LaTeX, conjugates included."""
    table: dict[sp.Expr, complex] = {t: 0.4}
    for k, p in enumerate(case.parameters):
        table[p.symbol] = NUMBERS[k]
    for k, a in enumerate(case.amplitudes):
        table[a] = NUMBERS[k] + 1j * NUMBERS[-k - 1]
    printed = {sp.latex(s): v for s, v in table.items()}
    for a in case.amplitudes:
        printed[rf"\overline{{{sp.latex(a)}}}"] = complex(table[a]).conjugate()
    return table, printed


def statements(formula: Formula) -> list[tuple[str, str]]:
    """(left, right) of each formula of several lines, every line checked for its braces."""
    assert balanced(formula._repr_latex_())
    found: list[list[str]] = []
    for line in formula.lines:
        assert balanced(line, whole=False), line
        assert line.count("&") == 1
        if "&=" in line:
            found.append(line.split("&="))
        else:
            found[-1][1] += line.replace("&", " ")
    return [(left.strip(), right) for left, right in found]


def agree(text: str, expression: sp.Expr, case: Expansion) -> None:
    table, printed = numbers_of(case)
    wanted = complex(expression.subs(table).evalf())
    # sums of a hundred terms of order one in doubles
    assert abs(value(text, printed) - wanted) < 1e-11 * max(1.0, abs(wanted))


# --- formulas of cases ----------------------------------------------------------------------------


@pytest.mark.parametrize("order", [1, 2])
def test_solvability_conditions(order: int) -> None:
    case = rotor_case(2)
    found = statements(report.solvability(case, order))
    assert len(found) == len(case.amplitudes)
    for (left, right), (a, expression) in zip(found, case.solvability[order].items(), strict=True):
        assert left == f"D_{{{order}}} {sp.latex(a)}"
        agree(right, expression, case)
    only = statements(report.solvability(case, order, only=[y]))
    assert [left for left, _ in only] == [rf"D_{{{order}}} A_{{y}}"]


def test_modulation_equations_in_polar_form() -> None:
    eom = oscillator(alpha * x**3 + 2 * mu * d(x) - f * sp.cos(Omega * t))
    case = eom.scale({alpha: 1, mu: 1, f: 1}).expand(2, {Omega: omega})
    found = statements(report.modulation(case))
    polar = case.slow_flow.polar
    assert [left for left, _ in found] == [
        rf"\frac{{\mathrm{{d}} {name}}}{{\mathrm{{d}} t}}" for name in ("a_{x}", r"\gamma_{x}")
    ]
    table, printed = numbers_of(case)
    for k, symbol in enumerate(polar):
        table[symbol] = printed[sp.latex(symbol)] = NUMBERS[-k - 1]
    for (_, right), expression in zip(found, polar.values(), strict=True):
        wanted = complex(expression.subs(table).evalf())
        # a dozen terms of order one in doubles
        assert abs(value(right, printed) - wanted) < 1e-12


@pytest.mark.parametrize("order", [1, 2])
def test_secular_terms(order: int) -> None:
    """2iω_j D_p A_j + (secular terms) = 0, with D_p A_j as in the solvability condition."""
    case = rotor_case(2)
    lines = list(report.secular(case, order).lines)
    assert balanced(" ".join(lines))
    text = " ".join(lines).replace("&=", "&").replace("&", " ")
    equations = [e for e in text.split("= 0") if e.strip()]
    if len(equations) != len(case.amplitudes):
        # an equation without secular terms has its sign of equality in the middle
        text = " ".join(lines).replace("&= 0", "= 0").replace("&", " ")
        equations = [e for e in text.split("= 0") if e.strip()]
    table, printed = numbers_of(case)
    for equation, (a, condition) in zip(equations, case.solvability[order].items(), strict=True):
        own = {**printed, f"D_{{{order}}}": complex(condition.subs(table).evalf()) / table[a]}
        assert abs(value(equation, own)) < 1e-11
        assert f"D_{{{order}}} {sp.latex(a)}" in equation


@pytest.mark.parametrize(("order", "n"), [(1, 3), (2, 3), (2, 2)])
def test_characteristic_polynomial(order: int, n: int) -> None:
    case = rotor_case(order, n)
    ((left, right),) = statements(
        Formula(
            tuple(
                re.sub(r"^&(P\(\\Gamma\)) = ", r"\1 &= ", s) for s in report.polynomial(case).lines
            )
        )
    )
    assert left == r"P(\Gamma)"
    gamma = sp.Symbol("Gamma")
    table, printed = numbers_of(case)
    at = 0.3 + 0.8j
    wanted = complex(case.slow_flow.characteristic_polynomial(gamma).subs({**table, gamma: at}))
    right = right.replace("[", "(").replace("]", ")")
    assert abs(value(right, {**printed, r"\Gamma": at}) - wanted) < 1e-11 * max(1, abs(wanted))


@pytest.mark.parametrize("order", [1, 2])
def test_boundary(order: int) -> None:
    case = rotor_case(order)
    found = statements(report.boundary(case))
    assert [left for left, _ in found] == [r"\sigma_{-}", r"\sigma_{+}"]
    for (_, right), edge in zip(found, case.slow_flow.boundary(), strict=True):
        agree(right, edge, case)
    half = found[1][1]
    assert half.count(r"\sqrt") == 1


def test_cases_without_a_boundary() -> None:
    eom = linear_rotor(3)
    s = {p.name: p.symbol for p in eom.parameters}
    case = eom.scale({"r_m": 1, "r_b": 1}).expand(1, {s["Omega"]: s["omega_x"] - s["omega_phi"]})
    assert str(report.boundary(case)) == r"\text{no detuning is unstable}"
    assert str(report.verdict(case)).startswith("**This case is never unstable**: ")
    assert str(report.verdict(rotor_case(1))).startswith("**This case can be unstable**: the disc")
    assert report.case_title(case) == (r"\Omega = \omega_{x} - \omega_{\phi} + \varepsilon \sigma")


def test_a_verdict_that_depends_on_the_parameters() -> None:
    damped = oscillator(2 * mu * d(x) + f * sp.cos(Omega * t) * x).scale({mu: 1, f: 1})
    case = damped.expand(1, {Omega: 2 * omega})
    assert case.slow_flow.stability.unstable is None
    text = str(report.verdict(case))
    assert text.startswith("**Whether this case is unstable depends on the parameters**: ")
    assert text.count("$") % 2 == 0
    assert all(balanced(part) for part in text.split("$")[1::2])


def test_titles() -> None:
    assert report.case_title(linear_rotor(2).scale({"r_m": 1, "r_b": 1}).expand(1)) == (
        "no resonance"
    )
    eom = linear_rotor(3)
    s = {p.name: p.symbol for p in eom.parameters}
    both = {s["Omega"]: s["omega_x"] + s["omega_phi"], s["omega_y"]: s["omega_x"]}
    case = eom.scale({"r_m": 1, "r_b": 1}).expand(1, both)
    assert report.case_title(case) == (
        r"\Omega = \omega_{\phi} + \omega_{x} + \varepsilon \sigma_{1},\; "
        r"\omega_{y} = \omega_{x} + \varepsilon \sigma_{2}"
    )


# --- equations and expressions --------------------------------------------------------------------

FUNCTION = r"((?:\\[a-z]+|[a-z])(?:_\{\d\})?)(\^\{2\})?\{\\left\(t \\right\)\}"


def without_functions(text: str) -> str:
    """φ(t), its powers and derivatives as symbols."""
    text = re.sub(r"\\frac\{d\^\{2\}\}\{d t\^\{2\}\} " + FUNCTION, r"\\ddot{\1}", text)
    text = re.sub(r"\\frac\{d\}\{d t\} " + FUNCTION, r"\\dot{\1}", text)
    text = re.sub(FUNCTION, r"\\overline{\1}\2", text)
    return text.replace(r"\ddot{", r"\overline{d").replace(r"\dot{", r"\overline{v")


@pytest.mark.parametrize("linear", [True, False])
def test_equations_of_motion(linear: bool) -> None:
    eom = rotor.undamped(rotor.isotropic(rotor.helicopter(3).equations_of_motion()))
    eom = eom.linearise() if linear else eom
    formula = report.equations(eom)
    assert all(balanced(line, whole=False) for line in formula.lines)
    text = " ".join(formula.lines).replace("&", " ")
    printed_equations = text.split("= 0")[:-1]
    assert len(printed_equations) == len(eom.equations)
    table: dict[sp.Expr, float] = {}
    numbers = iter(NUMBERS * 3)
    printed: dict[str, float] = {"t": 0.4}
    for p in eom.parameters:
        table[p.symbol] = printed[sp.latex(p.symbol)] = next(numbers)
    for q in eom.coordinates:
        name = sp.latex(sp.Symbol(str(q.func)))
        for n, letter in ((2, "d"), (1, "v"), (0, "")):
            own = name if letter == "" else letter + name
            table[q.diff(t, n) if n else q] = printed[rf"\overline{{{own}}}"] = next(numbers)
    for shown, equation in zip(printed_equations, eom.equations, strict=True):
        wanted = complex(equation.xreplace(table).subs(t, 0.4).evalf())
        text = without_functions(shown)
        text = re.sub(r"overline\{([dv])\\phi", r"overline{\1phi", text)
        own = {k.replace(r"d\phi", "dphi").replace(r"v\phi", "vphi"): v for k, v in printed.items()}
        # a sum of twenty terms of size at most a hundred
        assert abs(value(text, own) - wanted) < 1e-10 * max(1.0, abs(wanted))
    (only,) = " ".join(report.equations(eom, only=[y]).lines).split("= 0")[:-1]
    assert only.strip() == printed_equations[1].strip().removeprefix("&") or "y" in only


def test_expression() -> None:
    u, v = sp.symbols("u v", positive=True)
    found = report.expression("L", u**2 / 3 - sp.sqrt(u) * sp.sqrt(v) + 2)
    assert str(found) == r"L = - \sqrt{u v} + \frac{u^{2}}{3} + 2"
    assert found._repr_latex_() == (
        "$\\displaystyle \\begin{aligned}\n"
        r"L &= - \sqrt{u v} + \frac{u^{2}}{3} + 2"
        "\n\\end{aligned}$"
    )
    assert str(report.expression("L", sp.Integer(0))) == "L = 0"
    assert str(report.expression("L", -u)) == "L = - u"


symbols = sp.symbols("u v w_1", positive=True)
terms = st.tuples(
    st.integers(-9, 9).filter(bool),
    st.lists(st.sampled_from(symbols), min_size=1, max_size=3),
    st.sampled_from([1, 2, -1, -2, sp.Rational(1, 2), -sp.Rational(3, 2)]),
)


@given(st.lists(terms, min_size=1, max_size=12), st.sampled_from([0, 1, 3]))
def test_long_sums_on_several_lines_are_the_sum(
    parts: list[tuple[int, list[sp.Symbol], sp.Rational]], nested: int
) -> None:
    expression = sp.Add(*(c * sp.Mul(*factors) ** e for c, factors, e in parts))
    if nested:
        # a bracket too long for a line is opened over several
        expression = symbols[0] / 7 * expression + nested * sp.I * symbols[1]
    formula = report.expression("L", expression)
    ((left, right),) = statements(formula)
    assert left == "L"
    table = dict(zip(symbols, (0.7, 1.3, 2.1), strict=True))
    wanted = complex(expression.subs(table).evalf())
    printed = {sp.latex(s): v for s, v in table.items()}
    # twelve terms of size at most 1e4
    assert abs(value(right, printed) - wanted) < 1e-10 * max(1.0, abs(wanted))


@pytest.mark.parametrize("signs", [(1, 1), (1, -1), (-1, 1), (-1, -1)])
def test_roots_are_put_together_only_where_no_sign_can_change(signs: tuple[int, int]) -> None:
    u, v = sp.symbols("u v", real=True)
    p = sp.Symbol("p", positive=True)
    product = sp.sqrt(u) * sp.sqrt(v) * sp.sqrt(p) / sp.sqrt(p + 1)
    at = {u: sp.Integer(2 * signs[0]), v: sp.Integer(3 * signs[1]), p: sp.Integer(5)}
    shown = merged_roots(product).subs(at)
    assert sp.expand(shown.doit() ** 2 - product.subs(at) ** 2) == 0
    assert abs(complex(shown.evalf()) - complex(product.subs(at).evalf())) < 1e-14
    assert "sqrt{\\frac{p}{p + 1}}" in sp.latex(merged_roots(product)).replace(" p", "p", 0)


def test_width_counts_what_is_seen() -> None:
    assert width("a + b") == 3
    assert width(r"\frac{a + b}{c}") == 3
    assert width(r"\frac{a}{b + c + d}") == 5
    assert width(r"\omega_{\phi}") == 2
    assert width(r"\Bigl( \sin{\left(t \right)} \Bigr)") == 8
    assert width(r"\overline{A_{x}}") == width("A_{x}")


def test_orders_fit_their_lines() -> None:
    scaled = oscillator(alpha * x**3 + beta * x**2 * d(x)).scale({alpha: 1, beta: 1})
    for order in range(4):
        lines = report.orders(scaled, order).lines
        assert all(balanced(line) for line in lines)
        # a single piece may be longer than a line, several together are not
        assert all(width(line) < 2 * LINE for line in lines)


# --- tables and sentences -------------------------------------------------------------------------


def test_parameter_table() -> None:
    eom = rotor.at_speed(
        rotor.in_ratios(rotor.isotropic(rotor.helicopter(2).equations_of_motion()).linearise())
    )
    table = report.parameter_table(eom.parameters)
    assert table.headings == ("symbol", "unit", "meaning")
    assert len(table.rows) == len(eom.parameters)
    (lag,) = (row for row in table.rows if row[0] == r"$\omega_{\phi}$")
    assert lag[1] == "rad/s"
    assert lag[2].startswith("lag frequency of a blade at speed, $\\sqrt{")
    assert table._repr_markdown_().splitlines()[:2] == [
        "| symbol | unit | meaning |",
        "|---|---|---|",
    ]
    assert len({line.count("|") for line in table._repr_markdown_().splitlines()}) == 1


def test_products_in_a_table_are_no_emphasis() -> None:
    relations = ("Omega = 2*x, y = 3*x", "Omega = 2*x", "$a*b*c$")
    table = Table(("case",) * 3, (relations,))
    row = table._repr_markdown_().splitlines()[-1]
    assert row == r"| Omega = 2\*x, y = 3\*x | Omega = 2*x | $a*b*c$ |"
    assert str(table).splitlines()[-1] == "\t".join(relations)


def test_table_and_statement() -> None:
    table = Table(("a", "b"), (("1", "2"), ("3", "4")))
    assert str(table) == repr(table) == "a\tb\n1\t2\n3\t4"
    assert table._repr_markdown_() == "| a | b |\n|---|---|\n| 1 | 2 |\n| 3 | 4 |"
    sentence = Statement("**So** it is.")
    assert sentence._repr_markdown_() == str(sentence) == repr(sentence) == "**So** it is."


def test_tables_of_certificates() -> None:
    fits = tuple(
        Fit("edges of the zone", 2, (0.1,), (0.1,), (1e-9,), exponent) for exponent in (2.004, 1.1)
    )
    zone = Zone("Omega", "rad/s", (2.0, 4.0), (1.0, 5.0), 1e-9)
    record = Certificate("Omega = 2*omega", 1, (), fits, (zone,))
    table = report.certificate_table([record])
    assert table.rows == (
        ("Omega = 2*omega", "1", "edges of the zone", "2", "2.00", "yes"),
        ("Omega = 2*omega", "1", "edges of the zone", "2", "1.10", "NO"),
    )
    zones = report.zone_table([record, record], factor=0.5, unit="Hz")
    assert zones.headings[2] == "lower (Hz)"
    row = ("Omega = 2*omega", "1", "1.00000", "2.00000", "0.50000", "2.50000")
    assert zones.rows == ((*row, "+0.50000, -0.50000"),) * 2


def test_everything_of_a_case_is_printable_in_a_notebook() -> None:
    case = rotor_case(1)
    for shown in (report.secular(case, 1), report.polynomial(case), report.boundary(case)):
        assert balanced(shown._repr_latex_())
        assert "&" not in str(shown)
        assert repr(shown) == str(shown)
    assert isinstance(case.slow_flow, mg.SlowFlow)


def test_particular_solutions_show_one_of_each_conjugate_pair() -> None:
    """x'' + ω²x + εαx² = 0: x_1 = −2αAĀ/ω² + αA²e^{2iωT0}/(3ω²) + c.c."""
    case = oscillator(alpha * x**2).scale({alpha: 1}).expand(2)
    (line,) = report.particular(case, 1).lines
    assert line.startswith("x_{1} &= ") and line.endswith(r" + \mathrm{c.c.}")
    assert line.count("e^{") == 1
    assert r"\frac{2 A_{x} \alpha \overline{A_{x}}}{\omega^{2}}" in line
