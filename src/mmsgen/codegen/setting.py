"""`Setting`: a case as code generation sees it: its parameters in order, its formulas by size."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import sympy as sp
from flint import fmpq

from ..errors import EmissionError, ExpansionError
from ..expansion import Expansion
from ..field import Coefficient
from ..linear_flow import LinearFlow
from ..parameters import Parameter
from ..slowflow import SlowFlow
from ..symbols import coordinate_name
from .naming import case_name, check_parameter_names, relation_text

__all__ = ["Setting"]


@dataclass(frozen=True)
class Setting:
    """A case and what its emitted functions have in common.

    Attributes
    ----------
    case : Expansion
    """

    case: Expansion

    @cached_property
    def name(self) -> str:
        """The module name."""
        return case_name(self.case)

    @property
    def flow(self) -> SlowFlow:
        """The slow flow."""
        return self.case.slow_flow

    @cached_property
    def linear(self) -> LinearFlow | None:
        """The matrix form; None for a slow flow that has none."""
        if not self.flow.is_linear or self.flow.frame is None:
            return None
        return self.flow.linear

    @cached_property
    def relations(self) -> tuple[str, ...]:
        """The relations with their detunings, as text."""
        frequencies = self.case.weak.scaled.frequencies
        return tuple(relation_text(r, frequencies) for r in self.case.relations)

    @cached_property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        return tuple(coordinate_name(q) for q in self.case.coordinates)

    @cached_property
    def rates(self) -> dict[sp.Symbol, sp.Expr]:
        """The right-hand sides that are emitted: autonomous where there is a frame."""
        return self.flow.complex if self.flow.frame is None else self.flow.autonomous

    @cached_property
    def detunings(self) -> tuple[Parameter, ...]:
        """One for each relation, that of the first one first."""
        symbols = [r.detuning for r in self.case.relations]
        return tuple(p for s in symbols for p in self.case.parameters if p.symbol == s)

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """Detunings, then the parameters that the slow flow depends on.

        Raises
        ------
        EmissionError
            If one of them cannot be a keyword argument.
        """
        present = set().union(*(rate.free_symbols for rate in self.rates.values()))
        others = [p for p in self.case.parameters if p not in self.detunings]
        used = (*self.detunings, *(p for p in others if p.symbol in present))
        missing = present - {p.symbol for p in used} - set(self.case.amplitudes) - {self.time}
        if missing:
            raise EmissionError(
                f"{self.name}: the slow flow contains {', '.join(sorted(map(str, missing)))}, "
                f"which is not among its parameters {', '.join(p.name for p in used)}: declare it "
                "as a parameter of the model"
            )
        check_parameter_names(p.name for p in used)
        return used

    @property
    def time(self) -> sp.Symbol:
        """The time in the equations."""
        return self.case.weak.scaled.eom.time

    @cached_property
    def small(self) -> tuple[str, ...]:
        """Names of what is of order one or more in ε: detunings and small parameters."""
        scaled = [str(s.name) for s, order in self.case.weak.scaled.orders if order]
        names = [*(p.name for p in self.detunings), *scaled]
        return tuple(n for n in names if n in self.case.weak.ring.field.names)

    @cached_property
    def _parts(self) -> dict[int, tuple[Coefficient, tuple[sp.Expr, sp.Expr]]]:
        return {}

    def parts(self, c: Coefficient) -> tuple[sp.Expr, sp.Expr]:
        """Real and imaginary part of a coefficient, a polynomial in what is small.

        Each power of the small quantities keeps the divisors that it needs and no others. Over one
        denominator, σ alone would have to come out of a difference of high powers.
        """
        if id(c) not in self._parts:  # kept beside its parts, so that the identity stays its own
            self._parts[id(c)] = c, self._split(c)
        return self._parts[id(c)][1]

    def shown(self, c: Coefficient) -> sp.Expr:
        """A coefficient as one expression."""
        re, im = self.parts(c)
        return re + sp.I * im

    def _split(self, c: Coefficient) -> tuple[sp.Expr, sp.Expr]:
        field = c.field
        places = [field.names.index(n) for n in self.small]
        groups: dict[tuple[int, ...], dict[int, dict[tuple[int, ...], fmpq]]] = {}
        for k, p in c.num.items():
            for monomial, value in p.to_dict().items():
                bare = list(map(int, monomial))
                key = tuple(bare[i] for i in places)
                for i in places:
                    bare[i] = 0
                groups.setdefault(key, {}).setdefault(k, {})[tuple(bare)] = value
        real, imaginary = [], []
        for key in sorted(groups):
            num = {k: field.ctx.from_dict(terms) for k, terms in groups[key].items()}
            factor = sp.Mul(*(self._small(n) ** e for n, e in zip(self.small, key, strict=True)))
            re, im = self.case.symbols.real_imaginary(field.cancel(Coefficient(field, num, c.den)))
            real.append(factor * re)
            imaginary.append(factor * im)
        return sp.Add(*real), sp.Add(*imaginary)

    def _small(self, name: str) -> sp.Expr:
        return self.case.symbols.polynomial(self.case.weak.ring.field.gens[name])

    @cached_property
    def unstable(self) -> bool | None:
        """Whether the case can be unstable; None where that depends, or is not linear."""
        return None if self.linear is None else self.linear.stability.unstable

    @cached_property
    def reason(self) -> str:
        """Why it can or cannot be unstable."""
        if self.linear is None:
            return "the slow flow is nonlinear or forced: its equilibria decide"
        return self.linear.stability.reason

    @cached_property
    def no_boundary(self) -> str:
        """Why the case has no functions for its boundaries; empty where it has them."""
        if self.linear is None:
            return "the slow flow is nonlinear or forced"
        try:
            self.linear.stability.criteria
        except ExpansionError as error:
            return str(error)
        return ""

    @property
    def moving_modes(self) -> bool:
        """Whether mode shapes depend on the frequency that is detuned."""
        if not self.case.relations:
            return False
        needed = set().union(*(e.free_symbols for e in self.case.weak.scaled.modes.entries))
        return bool(self.case.relations[0].lhs.free_symbols & needed)

    @cached_property
    def edges(self) -> tuple[sp.Expr, ...] | None:
        """Both edges in closed form; empty where there are none, None where there is no form.

        The roots of a criterion that is a parabola open downwards for all parameters.
        """
        assert self.linear is not None
        stability = self.linear.stability
        if not stability.criteria:
            return ()
        only = stability.criteria[0]
        if len(stability.criteria) > 1 or len(only.polynomials) > 1 or only.undamped:
            return None
        (parabola,) = only.polynomials
        if len(parabola) != 3 or stability.domain.strict_sign(parabola[2]) != -1:
            return None
        p0, p1, p2 = parabola
        bend = -self.parts(p2)[0]
        centre = self.parts(p1)[0] / (2 * bend)
        series = None if stability.critical is None else stability.critical.edges
        if series is not None and series.radical[0]:
            root = sp.sqrt(centre**2 + self.parts(p0)[0] / bend)
        else:  # a zone that is narrow beside the shift of its centre, which would cancel
            root = sp.sqrt(self.parts(p1 * p1 - (p0 * p2).scale(4))[0]) / (2 * bend)
        return centre - root, centre + root

    @cached_property
    def criteria(self) -> tuple[tuple[tuple[sp.Expr, ...], ...], ...]:
        """Polynomials in the first detuning, lowest power first: one is positive in a zone.

        Each one by itself, or after another: it then counts where that vanishes identically.
        """
        assert self.linear is not None
        items: list[tuple[tuple[Coefficient, ...], ...]] = []
        for c in self.linear.stability.criteria:
            items += [(p,) for p in c.polynomials]
            items += [(c.damping, p) for p in c.undamped]
        return tuple(tuple(tuple(self.parts(x)[0] for x in p) for p in i) for i in items)

    @cached_property
    def reach(self) -> sp.Expr:
        """How far from the resonance a zone may begin; infinite where that is not known."""
        assert self.linear is not None
        return self.linear.stability.farthest

    @property
    def _coefficients(self) -> Iterator[Coefficient]:
        """All coefficients of the slow flow."""
        if self.linear is None:
            return (c for series in self.flow.rates for c in series.values())
        return (c for b in self.linear.blocks for row in b.entries for c in row)

    @cached_property
    def poles(self) -> tuple[str, ...]:
        """Divisors that can vanish: further resonances, on which the formulas do not hold."""
        field = self.case.weak.ring.field
        positive = {p.name for p in self.case.parameters if p.symbol.is_positive}
        indices = {m for c in self._coefficients for m in c.den}
        found = []
        for m in sorted(indices):
            divisor = field.divisors[m]
            used = {n for n, d in zip(field.names, divisor.degrees(), strict=True) if d}
            if not used <= positive or len({q > 0 for q in divisor.coeffs()}) > 1:
                shown = self.case.symbols.polynomial(divisor)
                found += [str(shown)] if shown.free_symbols else []  # π is a generator too
        return tuple(sorted(found))


def values_of(point: Mapping[str, object], parameters: Sequence[Parameter]) -> dict[str, object]:
    """The values of parameters at a point."""
    return {p.name: point[p.name] for p in parameters}
