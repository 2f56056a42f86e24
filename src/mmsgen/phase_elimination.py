"""Polynomials in two amplitudes that are left of a slow flow without its phases, exactly.

Divided by e^{iγ_j}, the equations are Laurent polynomials in e^{iγ_1} and e^{iγ_2} whose
coefficients are polynomials in a_1 and a_2. The phases enter them through two unit numbers at most:
u, of the resonance between the two, and w, of a force, and w with the powers 0 and 1 alone,

    F_j = P_j(u) + w Q_j(u).

Then D = P_1Q_2 − P_2Q_1 is free of w, and so is |P_j|² − |Q_j|² with ū = 1/u. The conjugate of D
and these are polynomials in u alone; resultants leave polynomials in the two amplitudes. Where
motions drift along a symmetry, real parts and the difference of the two rates take the place of D.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import reduce
from math import gcd, log10
from typing import TYPE_CHECKING, Any

import flint
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpz

from .errors import ExpansionError
from .exact_polynomials import Exact
from .field import Coefficient

if TYPE_CHECKING:
    from .slowflow import SlowFlow

__all__ = ["Algebra", "Equation", "check_size", "equations", "without_phases"]

LARGEST = (9.0, 9.0)
"""As for `check_size`: beyond, what is left of the phases is too long to go on with."""

Laurent = dict[int, fmpq_mpoly]
"""Power of u → polynomial in the parameters, a_1, a_2 and i."""


class Algebra:
    """Polynomials in the generators of a field, a_1, a_2, i and u.

    Parameters
    ----------
    flow : SlowFlow
    fixed : mapping
        Generator → its value.
    """

    def __init__(self, flow: SlowFlow, fixed: Mapping[str, Fraction]) -> None:
        self.field = flow.case.weak.ring.field
        self.m = len(self.field.names)
        names = (*(f"g{k}" for k in range(self.m)), "a1", "a2", "i", "u")
        self.ctx = fmpq_mpoly_ctx.get(names, flint.Ordering.degrevlex)
        self.one = self.ctx.constant(1)
        *self.gens, self.a1, self.a2, self.i, self.u = self.ctx.gens()
        self.fixed: dict[str | int, int | fmpz | fmpq] = {
            f"g{self.field.names.index(name)}": fmpq(value.numerator, value.denominator)
            for name, value in fixed.items()
        }

    def reduced(self, p: fmpq_mpoly) -> fmpq_mpoly:
        """With i² = −1."""
        place = self.m + 2
        terms: dict[tuple[int, ...], fmpq] = {}
        for monomial, c in p.to_dict().items():
            e = list(map(int, monomial))
            turns, e[place] = e[place] // 2, e[place] % 2
            key = tuple(e)
            terms[key] = terms.get(key, fmpq(0)) + (-c if turns % 2 else c)
        return self.ctx.from_dict(terms)

    def product(self, *factors: fmpq_mpoly) -> fmpq_mpoly:
        """The product, i² = −1."""
        return reduce(lambda p, q: self.reduced(p * q), factors)

    def conjugate(self, p: fmpq_mpoly) -> fmpq_mpoly:
        """With −i for i."""
        place = self.m + 2
        terms = {tuple(map(int, e)): (-c if e[place] % 2 else c) for e, c in p.to_dict().items()}
        return self.ctx.from_dict(terms)

    def real(self, p: fmpq_mpoly) -> fmpq_mpoly:
        """The real part."""
        return (p + self.conjugate(p)) / 2

    def imag(self, p: fmpq_mpoly) -> fmpq_mpoly:
        """The imaginary part."""
        return self.reduced((p - self.conjugate(p)) * self.i) / -2

    def whole(self, p: Mapping[tuple[int, ...], Any]) -> fmpq_mpoly:
        """From a polynomial of the field, the values put in."""
        tail = (0,) * 4
        q = self.ctx.from_dict({(*map(int, e), *tail): c for e, c in p.items()})
        return q.subs(self.fixed) if self.fixed else q

    def squares(self, p: Laurent) -> Laurent:
        """P(u) P̄(1/u)."""
        return self.times(p, self.turned(p))

    def turned(self, p: Laurent) -> Laurent:
        """P̄(1/u), the conjugate where u is of modulus one."""
        return {-k: self.conjugate(c) for k, c in p.items()}

    def times(self, p: Laurent, q: Laurent) -> Laurent:
        """The product."""
        out: Laurent = {}
        for k, x in p.items():
            for n, y in q.items():
                out[k + n] = out.get(k + n, self.ctx.constant(0)) + self.product(x, y)
        return {k: c for k, c in out.items() if c}

    def resultant(self, p: Laurent, q: Laurent) -> fmpq_mpoly:
        """The resultant by u, where neither power of u is negative after a shift."""
        whole = []
        for f in (p, q):
            low = min(f)
            total = self.ctx.constant(0)
            for k, c in f.items():
                total += c * self.u ** (k - low)
            whole.append(total)
        check_size(whole[0], whole[1], self.m + 3, LARGEST)
        return self.reduced(whole[0].resultant(whole[1], "u"))

    def at_root(self, lead: Laurent, p: Laurent) -> fmpq_mpoly:
        """P(u) where lead = b + c u vanishes and ū = 1/u, times a power of |c|²."""
        b, c = (lead[k] for k in sorted(lead))
        ahead, size = self.product(-b, self.conjugate(c)), self.product(c, self.conjugate(c))
        most = max(map(abs, p))
        total = self.ctx.constant(0)
        for k, value in p.items():
            turn = ahead if k > 0 else self.conjugate(ahead)
            total += self.product(value, *[turn] * abs(k), *[size] * (most - abs(k)))
        return total


def check_size(p: fmpq_mpoly, q: fmpq_mpoly, place: int, most: tuple[float, float]) -> None:
    """Refuse resultants that would take minutes, or all the memory.

    Parameters
    ----------
    p, q : fmpq_mpoly
    place : int
        Of the variable that is eliminated.
    most : (float, float)
        Decimal logarithms: of the products of terms in the determinant, and of the monomials that
        its degrees allow. Not both may be exceeded.
    """
    reach, other = ([int(d) for d in f.degrees()] for f in (p, q))
    m, n = reach[place], other[place]
    products = n * log10(len(p)) + m * log10(len(q))
    pairs = enumerate(zip(reach, other, strict=True))
    box = sum(log10(1 + n * x + m * y) for k, (x, y) in pairs if k != place)
    if products > most[0] and box > most[1]:
        raise ExpansionError(
            "this relation would have too many terms: give values for more of the parameters, "
            "response_relation(of, {parameter: number, …}), or use .amplitude_relations, which "
            "leaves both amplitudes, or .equilibria"
        )


def _plus(p: Laurent, q: Laurent, sign: int = 1) -> Laurent:
    out = dict(p)
    for k, c in q.items():
        out[k] = out[k] + sign * c if k in out else sign * c
    return {k: c for k, c in out.items() if c}


Vector = tuple[int, int]
Equation = dict[Vector, fmpq_mpoly]
"""Harmonics of (γ_1, γ_2) → polynomial, of e^{−iγ_j} dB_j/dt."""


def equations(flow: SlowFlow, algebra: Algebra) -> tuple[Equation, Equation]:
    """Both equations with a common denominator left out."""
    case, ring = flow.case, flow.case.weak.ring
    found: list[tuple[int, Vector, Vector, Coefficient]] = []
    for j in (0, 1):
        flow.frame_rate(j)
        assert flow.frame is not None
        form = {str(s.name): c for s, c in flow.frame[j].items()}
        frame = ring.field.polynomial(ring.field.linear(form)).times_i(-1)
        if frame:
            found.append((j, (0, 0), (int(j == 0), int(j == 1)), frame))
        for key, c in flow.rates[j].items():
            if case.phase_key(key):
                raise ExpansionError(
                    "constant phases are in the way of an exact elimination: write their cosines "
                    "and sines as parameters, or use .equilibria"
                )
            r, s, p, q, *_ = ring.packing.exponents(key)
            m, n = ring.moduli(key)
            turn = (r - s - (j == 0), p - q - (j == 1))
            found.append((j, turn, (r + s + m, p + q + n), c))
    parts = [
        (j, turn, power, i, part)
        for j, turn, power, c in found
        for i, part in enumerate((Exact(c).real.value, Exact(c).imag.value))
        if part
    ]
    den: dict[int, int] = {}
    for *_, part in parts:
        for d, e in part.den.items():
            den[d] = max(e, den.get(d, 0))
    out: tuple[Equation, Equation] = ({}, {})
    for j, turn, power, i, part in parts:
        whole = part
        for d, e in den.items():
            factor = ring.field.divisors[d] ** (e - part.den.get(d, 0))
            whole = whole.times(ring.field.polynomial(factor))
        if whole.num.keys() - {0}:
            raise ExpansionError("this slow flow has irrational coefficients: use .equilibria")
        value = algebra.whole(whole.num[0].to_dict()) * algebra.i**i
        value *= algebra.a1 ** power[0] * algebra.a2 ** power[1] * fmpq(1, 2 ** sum(power))
        out[j][turn] = out[j].get(turn, algebra.ctx.constant(0)) + value
    return out


def _lines(turns: Sequence[Vector]) -> tuple[Vector, Vector | None]:
    """The harmonic of u, and one of w where there is such."""
    known = sorted({h for h in turns if any(h)})
    if not known:
        return (0, 0), None
    gaps = {(a[0] - b[0], a[1] - b[1]) for a in (*known, (0, 0)) for b in (*known, (0, 0))} - {
        (0, 0)
    }
    best: tuple[int, Vector, Vector | None] | None = None
    for gap in sorted(gaps):
        common = gcd(*gap)
        d = (gap[0] // common, gap[1] // common)
        level = {h: d[1] * h[0] - d[0] * h[1] for h in known}
        if len(set(level.values()) - {0}) > 1:
            continue
        place = 0 if d[0] else 1
        first = next((h for h in known if level[h]), None)
        steps = [
            (h[place] - (first[place] if level[h] and first else 0)) // d[place] for h in known
        ]
        size = gcd(*steps) or 1
        span = max(map(abs, steps)) // size
        if best is None or span < best[0]:
            best = span, (d[0] * size, d[1] * size), first
    if best is None:
        raise ExpansionError(
            "three independent phases are in the way of an exact elimination: use .equilibria"
        )
    return best[1], best[2]


def split(equation: Equation, u: Vector, w: Vector | None) -> tuple[Laurent, Laurent]:
    """P and Q of F = P(u) + w Q(u)."""
    p: Laurent = {}
    q: Laurent = {}
    place = 0 if u[0] else 1
    for h, c in equation.items():
        aside = u[1] * h[0] - u[0] * h[1]
        own = h if not aside or w is None else (h[0] - w[0], h[1] - w[1])
        k = own[place] // u[place] if any(u) else 0
        (q if aside else p)[k] = c
    return p, q


def _real(algebra: Algebra, p: Laurent) -> Laurent:
    """Twice the real part where u is of modulus one."""
    return _plus(p, algebra.turned(p))


def _imag(algebra: Algebra, p: Laurent) -> Laurent:
    """Minus twice the imaginary part."""
    own = _plus(p, algebra.turned(p), -1)
    return {k: algebra.reduced(c * algebra.i) for k, c in own.items()}


def constraints(
    algebra: Algebra, pair: tuple[Equation, Equation], symmetries: Sequence[Sequence[int]]
) -> tuple[list[Laurent], list[Laurent]]:
    """Complex polynomials in u, and those that are real where u has modulus one."""
    u, w = _lines([*pair[0], *pair[1]])
    (p1, q1), (p2, q2) = (split(e, u, w) for e in pair)
    if not symmetries:
        if not (q1 or q2):
            return [p1, p2], []
        first = (p1, q1) if q1 else (p2, q2)
        crossed = _plus(algebra.times(p1, q2), algebra.times(p2, q1), -1)
        free = crossed if q1 and q2 else (p2 if q1 else p1)
        return [free], [_plus(algebra.squares(first[0]), algebra.squares(first[1]), -1)]
    parts = [p1, p2]
    if len(symmetries) == 2:
        return [], [_real(algebra, p1), _real(algebra, p2)]
    (k,) = symmetries
    still = [p for p, turn in zip(parts, k, strict=True) if not turn]
    moving = [_real(algebra, p) for p, turn in zip(parts, k, strict=True) if turn]
    if not still:
        # γ_j' = Im F_j/|B_j|
        ahead = {n: c * algebra.a2 * k[1] for n, c in _imag(algebra, p1).items()}
        behind = {n: c * algebra.a1 * k[0] for n, c in _imag(algebra, p2).items()}
        moving.append(_plus(ahead, behind, -1))
    return still, moving


def without_phases(
    algebra: Algebra, pair: tuple[Equation, Equation], symmetries: Sequence[Sequence[int]]
) -> list[fmpq_mpoly]:
    """Polynomials in both amplitudes that vanish at equilibria."""
    turning, still = constraints(algebra, pair, symmetries)
    found: list[fmpq_mpoly] = []

    def add(p: fmpq_mpoly) -> None:
        found.extend(x for x in (algebra.real(p), algebra.imag(p)) if x)

    for p in [*turning, *still]:
        if set(p) <= {0}:
            add(p.get(0, algebra.ctx.constant(0)))
    turning = [p for p in turning if set(p) - {0}]
    still = [p for p in still if set(p) - {0}]
    if turning:
        lead = turning[0]
        add(algebra.resultant(lead, algebra.turned(lead)))
        others = [*turning[1:], *still]
    elif still:
        still.sort(key=lambda p: (max(p), sum(map(len, p.values()))))
        lead, *others = still
    else:
        others = []
    for p in others:
        if turning and max(lead) - min(lead) == 1:
            add(algebra.at_root(lead, p))
        else:
            add(algebra.resultant(lead, p))
    return found
