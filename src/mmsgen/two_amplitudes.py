"""Two amplitudes: relations without phases, and one of each amplitude alone, as exact formulas.

`phase_elimination` leaves two polynomials in both amplitudes; their resultant leaves one in one
amplitude. Resultants have factors too many. Which ones belong to equilibria the complex solutions
at random parameters tell, all of which are known (`runtime._many_amplitudes`): each factor either
vanishes at some of them to rounding or is far from zero at all.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy as sp
from flint import fmpq_mpoly

from .errors import ExpansionError, MmsgenError
from .exact_polynomials import primitive
from .parameters import by_key
from .phase_elimination import Algebra, check_size, equations, without_phases
from .runtime._many_amplitudes import ends
from .runtime._starts import generic_solutions
from .runtime._systems import equilibrium_system, patterns, scaled
from .symbols import modulus

if TYPE_CHECKING:
    from .slowflow import SlowFlow

__all__ = ["TwoAmplitudes", "two_amplitudes"]

SAMPLES = 2
VANISHES = 1e-11
"""A polynomial over the sum of its terms' moduli, at a solution that Newton's method has found: far
above rounding, and far below what is met elsewhere, 1e-8 at the least."""
LARGEST = (12.0, 6.5)
"""As for `check_size`: up to there resultants take some ten seconds at most."""

_NONE = (
    "no isolated motion of this slow flow has both amplitudes; where nothing damps or forces them "
    "they fill curves, which .backbone has"
)


@dataclass(frozen=True)
class TwoAmplitudes:
    """Exact relations of a slow flow of two amplitudes, for motions of both.

    Attributes
    ----------
    flow : SlowFlow
    fixed : tuple of (str, Fraction)
        Generators of the coefficient field that have values.
    """

    flow: SlowFlow
    fixed: tuple[tuple[str, Fraction], ...]

    @cached_property
    def _algebra(self) -> Algebra:
        return Algebra(self.flow, dict(self.fixed))

    @cached_property
    def _points(self) -> list[tuple[list[float], Any]]:
        """Random generators, and a_1² and a_2² of all complex equilibria there."""
        choice, found = random.Random(7), []
        case, table = self.flow.case, self.flow.table
        field, fixed = case.weak.ring.field, dict(self.fixed)
        shown = [case.symbols.polynomial(field.gens[name]) for name in field.names]
        for _ in range(SAMPLES):
            values = {p.symbol: choice.uniform(0.4, 1.6) for p in case.parameters}
            for name, expression in zip(field.names, shown, strict=True):
                if name in fixed:
                    (symbol,) = expression.free_symbols
                    root = sp.solve(expression - sp.Rational(fixed[name]), symbol)
                    values[symbol] = float(max(root))
            # What is no parameter, such as ε, does not occur.
            numbers = [
                float(e.subs(values)) if e.free_symbols <= values.keys() else 0.0 for e in shown
            ]
            c = table.numbers({s.name: v for s, v in values.items()})
            found.append((numbers, _complex_squares(table.flow, c)))
            if not found[-1][1].shape[1]:
                raise ExpansionError(_NONE)
        return found

    def _values(self, p: fmpq_mpoly, place: int) -> Any:
        """A polynomial at the equilibria of a sample, relative to the sum of its terms."""
        numbers, squares = self._points[place]
        monomials = np.array([[int(x) for x in e] for e in p.monoms()], dtype=float)
        c = np.array([int(x.p) / int(x.q) for x in p.coeffs()])
        m = len(numbers)
        c = c * np.prod(np.array(numbers) ** monomials[:, :m], axis=1)
        best = np.full(squares.shape[1], np.inf)
        for signs in product((1.0, -1.0), repeat=2):
            a = np.sqrt(squares) * np.array(signs)[:, None]
            terms = c[:, None] * a[0] ** monomials[:, m, None] * a[1] ** monomials[:, m + 1, None]
            value = np.abs(terms.sum(axis=0)) / np.abs(terms).sum(axis=0)
            best = np.minimum(best, value)
        return best

    def _own(self, p: fmpq_mpoly) -> fmpq_mpoly:
        """The factors that vanish at equilibria, each of them once."""
        found = self._algebra.one
        left = [np.ones(squares.shape[1], dtype=bool) for _, squares in self._points]
        for factor, _ in sorted(p.factor()[1], key=lambda f: len(f[0])):
            if not any(int(d) for d in factor.degrees()[-4:-2]):
                continue
            zero = [self._values(factor, k) < VANISHES for k in range(SAMPLES)]
            if all((z & x).any() for z, x in zip(zero, left, strict=True)):
                found *= primitive(factor)
                left = [x & ~z for x, z in zip(left, zero, strict=True)]
        if any(x.any() for x in left):
            raise ExpansionError("the elimination has lost equilibria: use .equilibria")
        return found

    @cached_property
    def _pair(self) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        algebra, symmetries = self._algebra, self.flow.table.flow.symmetries
        found = without_phases(algebra, equations(self.flow, algebra), symmetries)
        kept: list[fmpq_mpoly] = []
        for p in sorted(found, key=len):
            own = self._own(p)
            if own not in kept:
                kept.append(own)
        if len(kept) < 2:
            raise ExpansionError(_NONE)
        return kept[0], kept[1]

    @cached_property
    def relations(self) -> tuple[sp.Expr, sp.Expr]:
        """See `NonlinearAnswers.amplitude_relations`."""
        first, second = self._pair
        return self._shown(first), self._shown(second)

    def relation(self, of: int) -> sp.Expr:
        """See `NonlinearAnswers.response_relation`."""
        algebra, place = self._algebra, self._algebra.m + 1 - of
        name = ("a2", "a1")[of]
        p, q = self._pair
        for own in (p, q):
            if not own.degrees()[place]:
                return self._shown(own)
        if all(int(e[place]) % 2 == 0 for f in (p, q) for e in f.monoms()):
            p, q = (_halved(algebra, f, place) for f in (p, q))
        check_size(p, q, place, LARGEST)
        return self._shown(self._own(p.resultant(q, name)))

    def _shown(self, p: fmpq_mpoly) -> sp.Expr:
        case, m = self.flow.case, self._algebra.m
        a1, a2 = (modulus(q) for q in case.coordinates)
        by_power: dict[tuple[int, int], dict[tuple[int, ...], Any]] = {}
        for monomial, c in p.to_dict().items():
            e = tuple(map(int, monomial))
            by_power.setdefault((e[m], e[m + 1]), {})[e[:m]] = c
        ctx = case.symbols.field.ctx
        return sp.Add(
            *(
                sp.Mul(case.symbols.factored(ctx.from_dict(terms)), a1**j, a2**k)
                for (j, k), terms in sorted(by_power.items())
            )
        )


def _halved(algebra: Algebra, p: fmpq_mpoly, place: int) -> fmpq_mpoly:
    """In the square of one of the variables."""
    return algebra.ctx.from_dict(
        {
            tuple(int(x) // (2 if k == place else 1) for k, x in enumerate(e)): c
            for e, c in p.to_dict().items()
        }
    )


def _complex_squares(flow: Any, c: Any) -> Any:
    """a_j² = 4 B_j B̄_j of all complex equilibria with both amplitudes, shape (2, count)."""
    system = equilibrium_system(flow, (0, 1))
    base, start = generic_solutions(system.terms, system.d, system.logs)
    target, scales = scaled(system, np.asarray(c)[None])
    z, _, _ = ends(system, base, start, target)
    z = z[:, np.isfinite(z).all(axis=0)]
    ones = np.ones(z.shape[1], dtype=complex)
    pairs = [(z[b], z[w] if w >= 0 else ones) for b, w, _ in system.places]
    return np.array([4 * b * w * s**2 for (b, w), s in zip(pairs, scales[:2, 0], strict=True)])


def two_amplitudes(flow: SlowFlow, values: Mapping[Any, Any] | None) -> TwoAmplitudes:
    """Prepare the elimination, with values for some of the parameters.

    Raises
    ------
    ExpansionError
        If there are not two amplitudes, no frame makes the slow flow autonomous, or no motion has
        both amplitudes.
    MmsgenError
        If a value is not a rational number, or of no parameter.
    """
    case = flow.case
    if len(case.coordinates) != 2:
        raise ExpansionError(
            "phases are eliminated of one and two amplitudes; this slow flow has "
            f"{len(case.coordinates)}: use .equilibria, or .cartesian and .jacobian"
        )
    if (0, 1) not in patterns(flow.table.flow):
        raise ExpansionError(_NONE)
    given = _rational(values or {}, [p.symbol for p in case.parameters])
    field, fixed = case.weak.ring.field, []
    for name in field.names:
        shown = case.symbols.polynomial(field.gens[name])
        if shown.free_symbols and shown.free_symbols <= given.keys():
            number = shown.subs(given)
            if not number.is_Rational:
                raise MmsgenError(f"{shown} must be rational, which {number} is not")
            fixed.append((name, Fraction(int(number.p), int(number.q))))
    return TwoAmplitudes(flow, tuple(fixed))


def _rational(values: Mapping[Any, Any], known: Iterable[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """Values by symbol, decimal fractions as they are written."""
    table, found = {s.name: s for s in known}, {}
    for name, value in by_key(values):
        if name not in table:
            raise MmsgenError(f"{name} is none of the parameters {', '.join(table)}")
        number = sp.Rational(str(value)) if isinstance(value, float) else sp.sympify(value)
        if not getattr(number, "is_Rational", False):
            raise MmsgenError(f"{name} must be a rational number here, got {value!r}")
        found[table[name]] = number
    return found
