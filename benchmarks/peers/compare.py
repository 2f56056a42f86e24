"""The results of the peers against ours, exactly, after conversion of conventions.

oscilate writes x = a cos((r_j/r) Ωt − β) + …, with r_j and r the ratios of the natural and of the
excitation frequency to the reference, so that A_j = (a_j/2) e^{i(r_j σt/r − β_j)}. In its complex
form a is no longer the amplitude of the fundamental of x but of that of (x − ix'/ω)/2.
asymptotics writes u = A cos ωt + B sin ωt + …, so that A_u = (A − iB)/2, and gives the frequency
over the initial displacement.
"""

from __future__ import annotations

import json
from random import Random
from typing import Any

import autonomous
import mpmath
import sympy as sp
from measure import BUILD, OSCILATE
from peer_systems import SYSTEMS, System, sigma, t
from sympy.parsing.sympy_parser import parse_expr
from with_mmsgen import Omega, expand, expand_autonomous, frequency, u

import mmsgen as mg
from mmsgen.symbols import amplitude, modulus

e, turn = sp.symbols("e turn", positive=True)
"""Marks orders; e^{iσt/6}."""

PARTS = 6
"""All detunings turn by whole multiples of σ/6."""


def reported(example: str, tool: str) -> dict[str, Any]:
    """What a peer reported in its first run."""
    path = BUILD / f"{example}-{tool}-0.json"
    report: dict[str, Any] = json.loads(path.read_text("utf-8"))
    return report


def read(text: str, *known: sp.Symbol) -> sp.Expr:
    """An expression from the text that a peer's process printed."""
    return parse_expr(text, {s.name: s for s in known})


def without_exponentials(expression: sp.Expr, phases: dict[sp.Symbol, sp.Symbol]) -> sp.Expr:
    """Polynomials in e^{iβ_j} and e^{iσt/6} for sines, cosines and exponentials."""

    def monomial(argument: sp.Expr) -> sp.Expr:
        angle = sp.expand(argument / sp.I)
        powers = [z ** angle.coeff(beta) for beta, z in phases.items()]
        powers.append(turn ** (PARTS * angle.coeff(t).coeff(sigma)))
        return sp.Mul(*powers)

    return expression.rewrite(sp.exp).replace(sp.exp, monomial)


def in_orders(expression: sp.Expr, system: System) -> sp.Expr:
    """Every small parameter and the detuning multiplied by its power of ε."""
    orders = {s: e**p * s for s, p in system.small.items() if p}
    return expression.subs({**orders, sigma: e * sigma}, simultaneous=True)


def lowest_order(difference: sp.Expr) -> float:
    """The lowest power of ε in a rational function; infinite for zero."""
    top, bottom = sp.fraction(sp.cancel(sp.together(difference)))
    if top == 0:
        return float("inf")
    low, high = (min(m for (m,) in sp.Poly(part, e).monoms()) for part in (top, bottom))
    return low - high


class Rotated:
    """Our slow flow in the variables of oscilate."""

    def __init__(self, system: System) -> None:
        self.system, self.case = system, expand(system)
        n = len(system.equations)
        self.a = [sp.Symbol(f"a_{j}", positive=True) for j in range(n)]
        self.beta = [sp.Symbol(f"beta_{j}", real=True) for j in range(n)]
        self.z = [sp.Symbol(f"z_{j}", positive=True) for j in range(n)]
        self.ratio = [sp.Rational(r) / system.ratio for r in system.ratios]
        self.phasors = [turn ** (PARTS * r) / z for r, z in zip(self.ratio, self.z, strict=True)]

    @property
    def phases(self) -> dict[sp.Symbol, sp.Symbol]:
        return dict(zip(self.beta, self.z, strict=True))

    def rename(self, expression: sp.Expr) -> sp.Expr:
        """Our detunings by their names in the system."""
        relations = self.case.relations
        names = {r.detuning: sigma if r.lhs == Omega else self.detuning(r.lhs) for r in relations}
        return expression.subs(names, simultaneous=True)

    def detuning(self, natural: sp.Symbol) -> sp.Expr:
        return self.system.detunings[list(self.system.natural).index(natural)]

    def ours(self, j: int, amplitudes: list[sp.Expr], bars: list[sp.Expr]) -> sp.Expr:
        """dA_j/dt with the amplitudes put in, and the frequency detuned from a number."""
        own = self.case.amplitudes
        rate = self.case.slow_flow.complex[own[j]]
        if not self.system.reference.is_Symbol:  # e^{iω_0 t} here, e^{it} there
            natural, delta = self.system.natural[j], self.system.detunings[j]
            rate = rate.subs(natural, self.system.reference + delta) + sp.I * delta * own[j]
        rate = without_exponentials(self.rename(rate), {})
        table = {sp.conjugate(a): b for a, b in zip(own, bars, strict=True)}
        return rate.subs(table).subs(dict(zip(own, amplitudes, strict=True)))

    def theirs(self, j: int, rates: dict[str, str]) -> sp.Expr:
        """dA_j/dt of the peer."""
        known = [*self.a, *self.beta, *self.system.small, *self.symbols]
        radial, angular = (
            without_exponentials(read(rates[name], *known), self.phases)
            for name in (f"da_{j}", f"a_{j} dbeta_{j}")
        )
        turning = self.ratio[j] * sigma * self.a[j] - angular
        return (radial + sp.I * turning) / 2 * self.phasors[j]

    @property
    def symbols(self) -> set[sp.Symbol]:
        everything = [*self.system.equations, *self.system.forcing, self.system.force]
        return set().union(*(sp.sympify(x).free_symbols for x in everything)) | {sigma}

    def polar(self) -> tuple[list[sp.Expr], list[sp.Expr]]:
        """A_j and its conjugate in a_j, e^{iβ_j} and e^{iσt}."""
        forward = [a * p / 2 for a, p in zip(self.a, self.phasors, strict=True)]
        back = [a / p / 2 for a, p in zip(self.a, self.phasors, strict=True)]
        return forward, back


def oscilate_gaps(name: str, report: dict[str, Any]) -> list[float]:
    """The lowest order in ε of each difference between dA_j/dt here and there."""
    system = SYSTEMS[name]()
    rotated = Rotated(system)
    forward, back = rotated.polar()
    gaps = []
    for j in range(len(system.equations)):
        there = rotated.theirs(j, report["rates"])
        if system.complex_form:
            gap = complex_form_gap(rotated, there, report["fundamentals"][j])
        else:
            gap = in_orders(there - rotated.ours(j, forward, back), system)
        gaps.append(lowest_order(gap))
    return gaps


def complex_form_gap(rotated: Rotated, there: sp.Expr, fundamental: str) -> sp.Expr:
    """d/dt of the fundamental h(A, Ā) of x by the peer's rates, minus our rate at h(A, Ā).

    Through the order of the example, at random rational values of all symbols but ε: a difference
    that is not zero is so almost everywhere. e^{iβ} and e^{iσt/6} count as free symbols, whose
    conjugates are their inverses.
    """
    system, order = rotated.system, rotated.system.order
    forward, bar = sp.Symbol("A_0"), sp.Symbol("Abar_0")
    h = sp.expand(without_exponentials(read(fundamental, forward, bar, *rotated.symbols, t), {}))
    swap = {forward: bar, bar: forward, sp.I: -sp.I, turn: 1 / turn}
    h_bar = h.subs(swap, simultaneous=True)
    conjugate = {rotated.z[0]: 1 / rotated.z[0], turn: 1 / turn, sp.I: -sp.I}
    there_bar = there.subs(conjugate, simultaneous=True)
    (a,), (b,) = rotated.polar()
    random = Random(1)
    free = [*sorted(rotated.symbols, key=str), *rotated.a, *rotated.z, turn]
    numbers = {s: sp.Rational(random.randint(1, 99), random.randint(1, 99)) for s in free}

    def at_numbers(expression: sp.Expr) -> sp.Poly:
        inner = in_orders(expression, system).subs(numbers)
        return sp.Poly(inner, e, domain="QQ_I").rem(sp.Poly(e ** (order + 1), e))

    def at_amplitudes(expression: sp.Expr, values: tuple[sp.Poly, sp.Poly]) -> sp.Poly:
        inner = sp.expand(in_orders(expression, system).subs(numbers))
        total = sp.Poly(0, e, domain="QQ_I")
        for (power, barred, small), c in sp.Poly(inner, forward, bar, e).terms():
            part = sp.Poly(c * e**small, e, domain="QQ_I")
            for value in [values[0]] * power + [values[1]] * barred:
                part = (part * value).rem(sp.Poly(e ** (order + 1), e))
            total += part
        return total.rem(sp.Poly(e ** (order + 1), e))

    own = at_numbers(a), at_numbers(b)
    moved = at_amplitudes(h.diff(forward), own) * at_numbers(there)
    moved += at_amplitudes(h.diff(bar), own) * at_numbers(there_bar)
    moved += at_amplitudes(h.diff(turn) * turn * sp.I * sigma / PARTS, own)
    image = at_amplitudes(h, own), at_amplitudes(h_bar, own)
    gap = moved - at_amplitudes(rotated.ours(0, [forward], [bar]), image)
    return gap.rem(sp.Poly(e ** (order + 1), e)).as_expr()


def asymptotics_gaps(name: str, report: dict[str, Any]) -> list[float]:
    """The lowest order in ε of the differences from what asymptotics reports."""
    example = autonomous.EXAMPLES[name]
    case = expand_autonomous(example)
    eps = case.weak.scaled.eom.parameters[0].symbol
    if example.strained:
        there = read(report["rates"]["frequency"], eps)
        return [lowest_order((there - strained_frequency(case)).subs(eps, e))]
    cosine, sine = sp.symbols("A B", real=True)
    rates = {
        key: text.replace("A(T_1)", "A").replace("B(T_1)", "B")
        for key, text in report["rates"].items()
    }
    there = read(rates["A"], cosine, sine) - sp.I * read(rates["B"], cosine, sine)
    own = amplitude(u)
    rate = case.slow_flow.complex[own].subs(eps, 1)
    table = {sp.conjugate(own): (cosine + sp.I * sine) / 2, own: (cosine - sp.I * sine) / 2}
    here = rate.subs(sp.conjugate(own), table[sp.conjugate(own)]).subs(own, table[own])
    return [lowest_order(e * sp.expand(there - 2 * here))]


def strained_frequency(case: mg.Expansion) -> sp.Expr:
    """The frequency over the initial displacement 1, as a polynomial in ε."""
    eps = case.weak.scaled.eom.parameters[0].symbol
    own, a = amplitude(u), modulus(u)
    displacement = sp.S.Zero
    for p in range(case.order):
        part = case.particular(p)[u]
        part = part.subs({own: a / 2}).replace(sp.exp, lambda _: sp.S.One)
        displacement += part
    start = sp.S.One
    for _ in range(case.order):  # a = 1 + (a − displacement), by iteration in powers of ε
        start = truncated(1 + (a - displacement).subs(a, start), eps, case.order - 1)
    return truncated(frequency(case).subs(a, start), eps, case.order)


def truncated(expression: sp.Expr, eps: sp.Symbol, order: int) -> sp.Expr:
    expanded = sp.expand(expression)
    return sp.Add(*(expanded.coeff(eps, k) * eps**k for k in range(order + 1)))


def exact_gap() -> str:
    """Frequencies of u'' + 4u + εu³ = 0 from u(0) = 1 and rest, beside the exact one, as a table.

    Exactly, ω = 2 · π√(1 + y)/(2K(m)) with y = ε/4, m = y/(2(1 + y)) and the elliptic integral K.
    """
    name = "strained_cubic_at_two"
    case = expand_autonomous(autonomous.EXAMPLES[name])
    eps = case.weak.scaled.eom.parameters[0].symbol
    there = read(reported(name, "asymptotics")["rates"]["frequency"], eps)
    formulas = (strained_frequency(case), there)
    rows = ["| ε | exact ω | error of mmsgen | error of asymptotics |", "|---|---|---|---|"]
    for k in range(3, 7):
        small = sp.Rational(1, 2**k)
        y = mpmath.mpf(1) / (4 * 2**k)
        exact = mpmath.pi * mpmath.sqrt(1 + y) / mpmath.ellipk(y / (2 * (1 + y)))
        errors = (float(abs(sp.Float(exact, 20) - w.subs(eps, small))) for w in formulas)
        shown = " | ".join(f"{error:.2e}" for error in errors)
        rows.append(f"| {small} | {mpmath.nstr(exact, 10)} | {shown} |")
    here, there = (sp.sstr(w, order="rev-lex") for w in formulas)
    return "\n".join([f"mmsgen gives ω = {here}, asymptotics ω = {there}:", "", *rows])


def gaps(example: str, report: dict[str, Any]) -> tuple[int, list[float]]:
    """Order of an example, and the lowest order in ε of each difference."""
    if example in OSCILATE:
        return SYSTEMS[example]().order, oscilate_gaps(example, report)
    return autonomous.EXAMPLES[example].order, asymptotics_gaps(example, report)


def main() -> None:
    for path in sorted(BUILD.glob("*-0.json")):
        example, tool, _ = path.stem.rsplit("-", 2)
        report = reported(example, tool)
        if "rates" in report:
            order, found = gaps(example, report)
            print(f"{example:24s} order {order}: differences of order {found}", flush=True)


if __name__ == "__main__":
    main()
