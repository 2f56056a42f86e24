"""A derivation as a readable document: formulas that print as LaTeX in a notebook, else as text.

The functions here only arrange what the records hold; nothing is derived in this module.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy as sp

from .hierarchy import hierarchy
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
    "modulation",
    "orders",
    "parameter_table",
    "polynomial",
    "secular",
    "solvability",
    "verdict",
    "zone_table",
]

LINE = 56
"""Width of a line in characters as they are seen."""

_FRACTION = re.compile(r"\\frac\{([^{}]*)\}\{([^{}]*)\}")
_UNSEEN = re.compile(
    r"\\(?:left|right|Bigl|Bigr|overline|displaystyle|sqrt|quad|cdot|frac)\b|[{}_^&\\ ]"
)
_COMMAND = re.compile(r"\\[A-Za-z]+")


def _width(text: str) -> int:
    """How many characters of LaTeX are seen, a fraction counting as its longer half."""
    text = _COMMAND.sub(
        lambda m: m[0] if _UNSEEN.fullmatch(m[0]) else ("sin" if m[0] in _WORDS else "x"), text
    )
    previous = ""
    while previous != text:
        previous = text
        text = _FRACTION.sub(lambda m: " " + max(m[1], m[2], key=_seen), text)
        text = re.sub(r"([_^])\{([^{}]*)\}", lambda m: m[2][: (len(m[2]) + 1) // 2], text)
        # The space keeps a command before the brace apart from what was in it.
        text = re.sub(r"(?<!\})\{([^{}]*)\}(?!\{)", r" \1", text)
    return _seen(text)


def _seen(text: str) -> int:
    return len(_UNSEEN.sub("", text))


_WORDS = ("\\sin", "\\cos")


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


def _merged_roots(term: sp.Expr) -> sp.Expr:
    """A product with all its square roots under one, as far as that changes no sign."""
    inside, outside = [], []
    for factor in sp.Mul.make_args(term):
        base, exponent = factor.as_base_exp()
        if factor != sp.I and exponent.is_Rational and exponent.q == 2 and base.is_nonnegative:
            inside.append(base ** (2 * exponent))
        else:
            outside.append(factor)
    if not inside:
        return term
    root = sp.Pow(sp.Mul(*inside), sp.S.Half, evaluate=False)
    return sp.Mul(*outside, root, evaluate=False) if outside else root


def _signed(term: sp.Expr) -> str:
    """A term of a sum, with its sign in front."""
    negative = term.could_extract_minus_sign()
    return f"{'-' if negative else '+'} {sp.latex(_merged_roots(-term if negative else term))}"


def _pieces(expression: sp.Expr) -> list[str]:
    """A sum in pieces that may stand on lines of their own; long brackets are opened."""
    pieces = []
    for term in expression.as_ordered_terms():
        sums = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.Add) and len(f.args) > 2]
        if len(sums) != 1 or _width(sp.latex(term)) < LINE:
            pieces.append(_signed(term))
            continue
        rest = term / sums[0]
        inner = _pieces(sums[0])
        inner[0] = inner[0][2:] if inner[0].startswith("+") else inner[0]
        pieces.append(f"{_signed(rest)} \\Bigl( {inner[0]}")
        pieces += inner[1:]
        pieces[-1] += " \\Bigr)"
    return pieces


def _sum(left: str, expression: sp.Expr, relation: str = "=") -> list[str]:
    """A sum over several aligned lines."""
    pieces = _pieces(expression)
    if relation and pieces[0].startswith("+"):
        pieces[0] = pieces[0][2:]
    first, *others = _wrapped(pieces)
    return [f"{left} &{relation} {first}", *(f"&\\quad {line}" for line in others)]


def _aligned(pairs: Iterable[tuple[str, sp.Expr]]) -> Formula:
    return Formula(tuple(line for left, right in pairs for line in _sum(left, right)))


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
        pieces = _pieces(expression)
        first, *others = _wrapped([pieces[0].removeprefix("+ "), *pieces[1:]])
        lines += [f"&{first}", *(f"&\\quad {line}" for line in others)]
        lines[-1] = f"{lines[-1]} = 0"
    return Formula(tuple(lines))


def expression(left: str, value: sp.Expr) -> Formula:
    """A formula left = value over as many lines as it needs."""
    return Formula(tuple(_sum(left, value)))


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
        pieces = [f"- {t[1:].lstrip()}" if t[0] == "-" else f"+ {t}" for t in terms] or ["0"]
        first, *others = _wrapped([pieces[0].removeprefix("+ "), *pieces[1:]])
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
            lines += _sum(name, sp.Add(*terms))
        shown = [sp.latex(matrix) for matrix in component.matrices]
        if component.gyroscopic:
            inner = f"2 \\omega {shown[0]} - i {shown[1]}"
            lines.append(f"2 \\omega &= \\varphi^H \\left({inner}\\right)\\varphi")
        else:
            lines.append(f"1 &= \\Phi^T {shown[0]} \\Phi")
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
        lines += _sum(head, terms, "")
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
        text = _wrapped(_powers(case, factor, gamma))
        lines.append(f"&{head}\\Bigl[ {text[0].removeprefix('+ ')}")
        lines += [f"&\\qquad {t}" for t in text[1:]]
        lines[-1] += f" \\Bigr]{power}"
    return Formula(tuple(lines))


def _powers(case: Expansion, factor: MonicFactor, gamma: sp.Symbol) -> list[str]:
    """The terms of a factor, highest power of Γ first."""
    pieces = [f"+ {sp.latex(gamma**factor.degree)}"]
    for k in range(factor.degree - 1, -1, -1):
        if not factor.coefficients[k]:
            continue
        inner = _pieces(case.symbols(factor.coefficients[k]))
        if k and len(inner) > 1:
            inner[0] = f"+ \\Bigl( {inner[0].removeprefix('+ ')}"
            inner[-1] += " \\Bigr)"
        if k:
            inner[-1] += f" {sp.latex(gamma**k)}"
        pieces += inner
    return pieces


def _wrapped(pieces: Sequence[str]) -> list[str]:
    """Pieces joined to lines."""
    lines, used = [pieces[0]], _width(pieces[0])
    for piece in pieces[1:]:
        width = _width(piece)
        if used + width > LINE:
            lines.append(piece)
            used = width
        else:
            lines[-1] += f" {piece}"
            used += width
    return lines


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
