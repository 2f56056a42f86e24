"""A derivation as a readable document: formulas that print as LaTeX in a notebook, else as text.

The functions here only arrange what the records hold; nothing is derived in this module.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy as sp

from .expressions import series_expression
from .hierarchy import hierarchy, indexed
from .lines import pieces, sum_lines, wrapped
from .symbols import coordinate_name
from .tables import relation_latex

if TYPE_CHECKING:
    from .certificate import Certificate
    from .equations import EquationsOfMotion
    from .expansion import Expansion
    from .factoring import MonicFactor
    from .parameters import Parameter
    from .scaling import ScaledSystem

__all__ = [
    "Formula",
    "Table",
    "boundary",
    "case_title",
    "certificate_table",
    "equations",
    "expression",
    "modes",
    "modulation",
    "orders",
    "parameter_table",
    "particular",
    "polynomial",
    "secular",
    "solvability",
    "verdict",
    "zone_table",
]


@dataclass(frozen=True)
class Formula:
    """Lines of LaTeX, aligned at their relation sign."""

    lines: tuple[str, ...]

    def _repr_latex_(self) -> str:
        body = " \\\\\n".join(self.lines)
        return f"$\\displaystyle \\begin{{aligned}}\n{body}\n\\end{{aligned}}$"

    def __str__(self) -> str:
        return "\n".join(line.replace("&", "") for line in self.lines)

    __repr__ = __str__


def _cell(text: str) -> str:
    """A cell in Markdown, where a pair of asterisks is emphasis; formulas stay as they are."""
    return text.replace("*", r"\*") if text.count("*") > 1 and "$" not in text else text


@dataclass(frozen=True)
class Table:
    """A table for a notebook, or as tab-separated text."""

    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    def _repr_markdown_(self) -> str:
        lines = ["| " + " | ".join(self.headings) + " |", "|" + "---|" * len(self.headings)]
        lines += ["| " + " | ".join(map(_cell, row)) + " |" for row in self.rows]
        return "\n".join(lines)

    def __str__(self) -> str:
        return "\n".join("\t".join(row) for row in (self.headings, *self.rows))

    __repr__ = __str__


@dataclass(frozen=True)
class Statement:
    """A sentence in Markdown."""

    text: str

    def _repr_markdown_(self) -> str:
        return self.text

    def __str__(self) -> str:
        return self.text

    __repr__ = __str__


def _aligned(pairs: Iterable[tuple[str, sp.Expr]]) -> Formula:
    return Formula(tuple(line for left, right in pairs for line in sum_lines(left, right)))


def parameter_table(parameters: Sequence[Parameter]) -> Table:
    """Symbols, units, meanings and definitions of parameters."""
    rows = tuple(
        (
            f"${sp.latex(p.symbol)}$",
            p.unit,
            p.meaning + (f", ${sp.latex(p.definition)}$" if p.definition is not None else ""),
        )
        for p in parameters
    )
    return Table(("symbol", "unit", "meaning"), rows)


def equations(eom: EquationsOfMotion, only: Sequence[sp.Expr] | None = None) -> Formula:
    """The equations of motion, expression = 0, one for each coordinate."""
    pairs = dict(zip(eom.coordinates, eom.equations, strict=True))
    chosen = pairs if only is None else {q: pairs[q] for q in only}
    lines: list[str] = []
    for expression in chosen.values():
        parts = pieces(expression)
        first, *others = wrapped([parts[0].removeprefix("+ "), *parts[1:]])
        lines += [f"&{first}", *(f"&\\quad {line}" for line in others)]
        lines[-1] = f"{lines[-1]} = 0"
    return Formula(tuple(lines))


def expression(left: str, value: sp.Expr) -> Formula:
    """A formula left = value over as many lines as it needs."""
    return Formula(tuple(sum_lines(left, value)))


def verdict(case: Expansion) -> Statement:
    """Whether a case can be unstable, and why."""
    stability = case.slow_flow.stability
    words = {
        True: "This case can be unstable",
        False: "This case is never unstable",
        None: "Whether this case is unstable depends on the parameters",
    }
    return Statement(f"**{words[stability.unstable]}**: {stability.reason_latex}.")


def orders(scaled: ScaledSystem, order: int, only: Sequence[sp.Expr] | None = None) -> Formula:
    """The order-ε^p equations in operator form."""
    found = hierarchy(scaled, order)
    chosen = found if only is None else {q: found[q] for q in only}
    lines: list[str] = []
    for left, terms in chosen.values():
        parts = [f"- {t[1:].lstrip()}" if t[0] == "-" else f"+ {t}" for t in terms] or ["0"]
        first, *others = wrapped([parts[0].removeprefix("+ "), *parts[1:]])
        lines += [f"{left} &= {first}", *(f"&\\quad {line}" for line in others)]
    return Formula(tuple(lines))


def modes(scaled: ScaledSystem) -> Formula:
    """Coupled coordinates as sums of modes, and how their shapes are scaled."""
    symbols = {p.name: p.symbol for p in scaled.parameters}
    lines: list[str] = []
    for component in scaled.modes.components:
        for j in component.members:
            terms = []
            for r, real, imaginary in scaled.modes.shapes[j]:
                eta = sp.Symbol(coordinate_name(scaled.coordinates[r]))
                companion = sp.Symbol(eta.name.replace("eta", "s", 1))
                terms += [symbols[real] * eta] if real else []
                terms += [symbols[imaginary] * companion] if imaginary else []
            name = sp.latex(sp.Symbol(coordinate_name(scaled.eom.coordinates[j])))
            lines += sum_lines(name, sp.Add(*terms))
        shown = [sp.latex(matrix) for matrix in component.matrices]
        if component.gyroscopic:
            inner = f"2 \\omega {shown[0]} - i {shown[1]}"
            lines.append(f"2 \\omega &= \\varphi^H \\left({inner}\\right)\\varphi")
        else:
            lines.append(f"1 &= \\Phi^T {shown[0]} \\Phi")
    return Formula(tuple(lines))


def particular(case: Expansion, order: int, only: Sequence[sp.Expr] | None = None) -> Formula:
    """The particular solutions q_{j,p}; of terms that are conjugate to each other, one."""
    ring = case.weak.ring
    lines: list[str] = []
    for j, q in enumerate(case.coordinates):
        if only is not None and q not in only:
            continue
        series = case.solver.eta[order][j]
        half = {key: c for key, c in series.items() if key >= ring.conjugate_key(key)}
        shown = series_expression(ring, half, case.symbols, case.fast_monomial)
        lines += sum_lines(indexed(sp.latex(sp.Symbol(coordinate_name(q))), order), shown)
        if len(half) < len(series):
            lines[-1] += " + \\mathrm{c.c.}"
    return Formula(tuple(lines))


def secular(case: Expansion, order: int, only: Sequence[sp.Expr] | None = None) -> Formula:
    """The condition that no secular term is left, 2iω_j D_p A_j + (secular terms) = 0."""
    ring = case.weak.ring
    lines: list[str] = []
    for j, (q, terms) in enumerate(case.secular_terms(order).items()):
        if only is not None and q not in only:
            continue
        omega = case.symbols.polynomial(ring.form_polynomial(ring.amplitude_frequencies[j]))
        head = f"2 i {sp.latex(omega)} D_{{{order}}} {sp.latex(case.amplitudes[j])}"
        if terms == 0:
            lines.append(f"{head} &= 0")
            continue
        lines += sum_lines(head, terms, "")
        lines[-1] += " = 0"
    return Formula(tuple(lines))


def solvability(case: Expansion, order: int, only: Sequence[sp.Expr] | None = None) -> Formula:
    """The solvability conditions D_p A_j at one order."""
    pairs = []
    for j, (a, expression) in enumerate(case.solvability[order].items()):
        if only is None or case.coordinates[j] in only:
            pairs.append((f"D_{{{order}}} {sp.latex(a)}", expression))
    return _aligned(pairs)


def modulation(case: Expansion) -> Formula:
    """The slow flow in polar form, da_j/dt and dγ_j/dt, in the frame that makes it autonomous."""
    return _aligned(
        (rf"\frac{{\mathrm{{d}} {sp.latex(x)}}}{{\mathrm{{d}} t}}", sp.expand(rate))
        for x, rate in case.slow_flow.polar.items()
    )


def polynomial(case: Expansion) -> Formula:
    """The characteristic polynomial of the slow flow, by factors."""
    gamma = sp.Symbol("Gamma")
    lines: list[str] = []
    for factor in sorted(
        case.slow_flow.linear.factors, key=lambda f: (f.degree, any(f.coefficients[:-1]))
    ):
        power = "" if factor.multiplicity == 1 else f"^{{{factor.multiplicity}}}"
        head = r"\quad \cdot " if lines else r"P(\Gamma) = "
        if not any(factor.coefficients[:-1]):
            lines.append(f"&{head}{sp.latex(gamma ** (factor.degree * factor.multiplicity))}")
            continue
        text = wrapped(_powers(case, factor, gamma))
        lines.append(f"&{head}\\Bigl[ {text[0].removeprefix('+ ')}")
        lines += [f"&\\qquad {t}" for t in text[1:]]
        lines[-1] += f" \\Bigr]{power}"
    return Formula(tuple(lines))


def _powers(case: Expansion, factor: MonicFactor, gamma: sp.Symbol) -> list[str]:
    """The terms of a factor, highest power of Γ first."""
    parts = [f"+ {sp.latex(gamma**factor.degree)}"]
    for k in range(factor.degree - 1, -1, -1):
        if not factor.coefficients[k]:
            continue
        inner = pieces(case.symbols(factor.coefficients[k]))
        if k and len(inner) > 1:
            inner[0] = f"+ \\Bigl( {inner[0].removeprefix('+ ')}"
            inner[-1] += " \\Bigr)"
        if k:
            inner[-1] += f" {sp.latex(gamma**k)}"
        parts += inner
    return parts


def boundary(case: Expansion) -> Formula:
    """Both edges of the unstable interval, or the statement that there is none."""
    edges = case.slow_flow.boundary()
    if not edges:
        return Formula((r"&\text{no detuning is unstable}",))
    sigma = sp.latex(case.relations[0].detuning)
    return _aligned(((f"{sigma}_{{-}}", edges[0]), (f"{sigma}_{{+}}", edges[1])))


def case_title(case: Expansion) -> str:
    """The relations of a case with their detunings, as LaTeX."""
    if not case.relations:
        return "no resonance"
    return ",\\; ".join(
        f"{relation_latex(r.equation, case.parameters)} + \\varepsilon {sp.latex(r.detuning)}"
        for r in case.relations
    )


def certificate_table(certificates: Iterable[Certificate]) -> Table:
    """Fitted exponents beside the theory's, a row for each quantity of each case."""
    rows = [
        (c.relation, str(c.order), f.quantity, str(f.theory), f"{f.exponent:.2f}", _word(f.passed))
        for c in certificates
        for f in c.fits
    ]
    return Table(("case", "order", "error of", "theory", "fitted", "holds"), tuple(rows))


def _word(holds: bool) -> str:
    return "yes" if holds else "NO"


def zone_table(
    certificates: Iterable[Certificate], factor: float = 1.0, unit: str = "rad/s"
) -> Table:
    """Edges of the zones at the user's numbers, from the emitted functions and from Floquet.

    Parameters
    ----------
    certificates : iterable of Certificate
    factor : float
        From the unit of the record to `unit`.
    unit : str
    """
    rows = []
    for c in certificates:
        for z in c.zones:
            edges = [f"{factor * x:.5f}" for x in (*z.emitted, *z.exact)]
            gaps = [f"{factor * (a - b):+.5f}" for a, b in zip(z.emitted, z.exact, strict=True)]
            rows.append((c.relation, str(c.order), *edges, ", ".join(gaps)))
    head = (f"lower ({unit})", f"upper ({unit})", "Floquet, lower", "Floquet, upper", "difference")
    return Table(("case", "order", *head), tuple(rows))
