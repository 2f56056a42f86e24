"""`ResonanceTable`: a tuple of resonances that prints itself as text, LaTeX and HTML."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

import sympy as sp

from .parameters import Parameter

if TYPE_CHECKING:
    from .resonance import Resonance

__all__ = ["ResonanceTable", "relation_latex", "relation_text"]

HEADINGS = ("relation", "kind", "order", "coordinates", "coupling")


class ResonanceTable(tuple["Resonance", ...]):
    """Resonances, the coupled ones first, by order.

    Parameters
    ----------
    resonances : iterable of Resonance
    parameters : tuple of Parameter
        The parameters of the equations, for `rank`.
    distances : mapping, optional
        Distance of each resonance in Hz, where ranked.
    complete : callable, optional
        Values → values of all frequencies, where those of modes are among them.
    """

    parameters: tuple[Parameter, ...]
    distances: Mapping[int, float]
    complete: Callable[[Mapping[Any, Any]], Mapping[str, Any]] | None

    def __new__(
        cls,
        resonances: Iterable[Resonance],
        parameters: tuple[Parameter, ...] = (),
        distances: Mapping[int, float] | None = None,
        complete: Callable[[Mapping[Any, Any]], Mapping[str, Any]] | None = None,
    ) -> ResonanceTable:
        """Make a table of resonances."""
        table = super().__new__(cls, tuple(resonances))
        table.parameters = parameters
        table.distances = dict(distances or {})
        table.complete = complete
        return table

    @property
    def coupled(self) -> ResonanceTable:
        """Only the resonances whose coupling survives."""
        return ResonanceTable(
            (r for r in self if r.coupled), self.parameters, complete=self.complete
        )

    def rank(self, values: Mapping[Any, Any]) -> ResonanceTable:
        """The same resonances by their distance |lhs − rhs|/2π in Hz, nearest first.

        Parameters
        ----------
        values : mapping
            Symbol or name → number in rad/s, for every frequency; those that have a definition
            follow from it.
        """
        if self.complete is not None:
            values = self.complete(values)
        pairs = [(r.distance(values, self.parameters), i, r) for i, r in enumerate(self)]
        pairs.sort(key=lambda item: item[:2])
        distances = {i: d for i, (d, _, _) in enumerate(pairs)}
        return ResonanceTable((r for _, _, r in pairs), self.parameters, distances, self.complete)

    def _rows(self) -> list[tuple[sp.Eq, list[str]]]:
        rows = []
        for i, r in enumerate(self):
            cells = [
                r.kind,
                str(r.order),
                ", ".join(r.coordinates),
                "yes" if r.coupled else f"no: {r.reason}",
            ]
            if self.distances:
                cells.append(f"{self.distances[i]:.4g}")
            rows.append((r.relation, cells))
        return rows

    @property
    def headings(self) -> tuple[str, ...]:
        """The column headings."""
        return (*HEADINGS, "distance (Hz)") if self.distances else HEADINGS

    def __str__(self) -> str:
        lines = [list(self.headings)]
        lines += [[relation_text(e, self.parameters), *cells] for e, cells in self._rows()]
        widths = [max(len(line[c]) for line in lines) for c in range(len(self.headings))]
        text = [
            "  ".join(cell.ljust(w) for cell, w in zip(line, widths, strict=True)).rstrip()
            for line in lines
        ]
        return "\n".join((text[0], "-" * len(text[0]), *text[1:]))

    __repr__ = __str__

    def to_latex(self) -> str:
        """The table as a LaTeX tabular."""
        rows = [
            " & ".join((f"${relation_latex(e, self.parameters)}$", *map(_latex_text, cells)))
            for e, cells in self._rows()
        ]
        body = " \\\\\n".join((" & ".join(self.headings), *rows))
        columns = "l" * len(self.headings)
        return f"\\begin{{tabular}}{{{columns}}}\n{body} \\\\\n\\end{{tabular}}"

    def _repr_html_(self) -> str:
        head = "".join(f"<th>{escape(h)}</th>" for h in self.headings)
        rows = "".join(
            f"<tr><td>${relation_latex(e, self.parameters)}$</td>"
            + "".join(f"<td>{escape(c)}</td>" for c in cells)
            + "</tr>"
            for e, cells in self._rows()
        )
        return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"


def relation_text(relation: sp.Eq, parameters: Sequence[Parameter] = ()) -> str:
    """A relation as text, positive terms first, in the order of the parameters."""
    return f"{relation.lhs} = {_ordered(relation.rhs, parameters, str)}"


def relation_latex(relation: sp.Eq, parameters: Sequence[Parameter] = ()) -> str:
    """A relation as LaTeX, positive terms first, in the order of the parameters."""
    return f"{sp.latex(relation.lhs)} = {_ordered(relation.rhs, parameters, sp.latex)}"


def _ordered(
    expression: sp.Expr, parameters: Sequence[Parameter], show: Callable[[sp.Expr], str]
) -> str:
    rank = {p.symbol: k for k, p in enumerate(parameters)}

    def position(term: sp.Expr) -> tuple[bool, int]:
        known = [rank[s] for s in term.free_symbols if s in rank]
        return term.could_extract_minus_sign(), min(known, default=len(rank))

    terms = sorted(sp.Add.make_args(expression), key=position)
    text = show(terms[0])
    for term in terms[1:]:
        negative = term.could_extract_minus_sign()
        text += f" - {show(-term)}" if negative else f" + {show(term)}"
    return text


def _latex_text(text: str) -> str:
    """Text with the characters that LaTeX takes as commands written out."""
    table = {"_": "\\_", "&": "\\&", "%": "\\%", "#": "\\#", "*": "$\\cdot$", "^": "\\^{}"}
    return "".join(table.get(c, c) for c in text)
