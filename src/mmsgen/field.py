"""The coefficients: rational functions of real parameters over a cyclotomic field, exactly.

A coefficient is a numerator over named divisors,

    c = Σ_k N_k ζ^k / Π_m L_m^{e_m},

with N_k sparse polynomials over ℚ, ζ a root of unity (`cyclotomic`) and L_m irreducible primitive
polynomials over ℚ, each registered once by its field and never multiplied out. No L_m divides all
N_k: that makes the form canonical, so that a coefficient is zero exactly when it has no numerator.

Why it is canonical: if N/(L_1^e1 …) = N'/(L_1^f1 …) with e1 > f1, then L_1 divides N_k·(other
L)^… for every k; L_1 is prime in ℚ[parameters] and none of the other divisors, so it divides every
N_k, a contradiction. Adding therefore needs trial divisions by the named divisors and no gcd.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import Any

import flint
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from flint.utils.flint_exceptions import DomainError

from .cyclotomic import Cyclotomic, cyclotomic

__all__ = ["Coefficient", "ParameterField"]

Numerator = dict[int, fmpq_mpoly]
Denominator = dict[int, int]


class Coefficient:
    """An element of a `ParameterField`, in canonical form; treat it as immutable.

    Attributes
    ----------
    field : ParameterField
    num : dict
        Power of ζ → non-zero polynomial; empty for zero.
    den : dict
        Index of a divisor of the field → its positive exponent.
    """

    __slots__ = ("den", "field", "num")

    def __init__(self, field: ParameterField, num: Numerator, den: Denominator) -> None:
        self.field, self.num, self.den = field, num, den

    def __bool__(self) -> bool:
        return bool(self.num)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Coefficient):
            return NotImplemented
        return self.field is other.field and self.den == other.den and self.num == other.num

    __hash__ = None  # type: ignore[assignment]

    def __add__(self, other: Coefficient) -> Coefficient:
        return self.field.sum((self, other))

    def __sub__(self, other: Coefficient) -> Coefficient:
        return self.field.sum((self, -other))

    def __neg__(self) -> Coefficient:
        return Coefficient(self.field, {k: -p for k, p in self.num.items()}, self.den)

    def __mul__(self, other: Coefficient) -> Coefficient:
        return self.field.cancel(self.times(other))

    def __pow__(self, exponent: int) -> Coefficient:
        base = self if exponent >= 0 else self.inverse()
        result = self.field.one
        for _ in range(abs(exponent)):
            result = result * base
        return result

    def __repr__(self) -> str:
        top = " + ".join(f"({p})*zeta^{k}" if k else f"({p})" for k, p in sorted(self.num.items()))
        low = "".join(f"/({self.field.divisors[m]})^{e}" for m, e in sorted(self.den.items()))
        return (top or "0") + low

    def times(self, other: Coefficient) -> Coefficient:
        """The product without the trial divisions: for terms on their way into a sum."""
        field = self.field
        if not self.num or not other.num:
            return field.zero
        if len(self.num) == len(other.num) == 1:
            ((k, p),) = self.num.items()
            ((m, q),) = other.num.items()
            pq = p * q
            num = {b: pq if c == 1 else c * pq for b, c in field.roots.power(k + m)}
        else:
            num = {}
            for k, p in self.num.items():
                for m, q in other.num.items():
                    pq = p * q
                    for b, c in field.roots.power(k + m):
                        term = pq if c == 1 else c * pq
                        num[b] = num[b] + term if b in num else term
            num = {b: p for b, p in num.items() if p}
        if not other.den:
            return Coefficient(field, num, self.den)
        den = dict(self.den)
        for m, e in other.den.items():
            den[m] = den.get(m, 0) + e
        return Coefficient(field, num, den)

    def scale(self, factor: Fraction | int) -> Coefficient:
        """The product with a rational number."""
        if not factor:
            return self.field.zero
        q = fmpq(factor.numerator, factor.denominator)
        return Coefficient(self.field, {k: q * p for k, p in self.num.items()}, self.den)

    def times_i(self, power: int = 1) -> Coefficient:
        """The product with i^power."""
        return self.field.rotate(self, power * self.field.roots.i)

    def conjugate(self) -> Coefficient:
        """The complex conjugate: all parameters are real."""
        return self.galois(-1)

    def galois(self, a: int) -> Coefficient:
        """The image under ζ → ζ^a."""
        if all(k == 0 for k in self.num):
            return self
        num: Numerator = {}
        for k, p in self.num.items():
            for b, c in self.field.roots.power(a * k):
                num[b] = num[b] + c * p if b in num else c * p
        return Coefficient(self.field, {b: p for b, p in num.items() if p}, self.den)

    def inverse(self) -> Coefficient:
        """The reciprocal.

        Raises
        ------
        ZeroDivisionError
            If the coefficient is zero.
        """
        field = self.field
        if not self.num:
            raise ZeroDivisionError("the reciprocal of a zero coefficient")
        numerator = Coefficient(field, self.num, {})
        if len(self.num) == 1:
            ((k, norm),) = self.num.items()
            result = field.rotate(field.one, -k)
        else:
            result = field.one
            for a in field.roots.units()[1:]:
                result = result.times(numerator.galois(a))
            norm = result.times(numerator).num[0]
        content, den = field.factor(norm)
        result = Coefficient(field, result.num, den).scale(1 / content)
        for m, e in self.den.items():
            result = result.times(field.polynomial(field.divisors[m] ** e))
        return field.cancel(result)


class ParameterField:
    """Rational functions of named real generators over ℚ(ζ).

    Parameters
    ----------
    names : sequence of str
        The generators, in their order.
    order : int
        Order n of ζ, a multiple of 4; 4 gives the Gaussian rationals.

    Attributes
    ----------
    divisors : list
        The irreducible polynomials met so far as factors of denominators.
    """

    def __init__(self, names: Sequence[str], order: int = 4) -> None:
        self.names = tuple(names)
        self.roots: Cyclotomic = cyclotomic(order)
        ascii_names = tuple(f"g{i}" for i in range(len(self.names)))
        self.ctx = fmpq_mpoly_ctx.get(ascii_names, flint.Ordering.degrevlex)
        self.gens: dict[str, fmpq_mpoly] = dict(zip(self.names, self.ctx.gens(), strict=True))
        self.divisors: list[fmpq_mpoly] = []
        self._divisor_index: dict[tuple[Any, ...], int] = {}
        self.zero = Coefficient(self, {}, {})
        self.one = Coefficient(self, {0: self.ctx.constant(1)}, {})

    # -- building elements ---------------------------------------------------------------

    def rational(self, value: Fraction | int) -> Coefficient:
        """A rational number as a coefficient."""
        return self.one.scale(Fraction(value))

    def polynomial(self, p: fmpq_mpoly) -> Coefficient:
        """A polynomial over ℚ as a coefficient."""
        return Coefficient(self, {0: p} if p else {}, {})

    def generator(self, name: str) -> Coefficient:
        """A generator as a coefficient."""
        return self.polynomial(self.gens[name])

    def root_of_unity(self, turn: Fraction) -> Coefficient:
        """e^{2πi·turn}; the denominator of `turn` must divide the order of ζ."""
        k = turn * self.roots.n
        if k.denominator != 1:
            raise ValueError(f"exp(2*pi*i*{turn}) is no power of exp(2*pi*i/{self.roots.n})")
        return self.rotate(self.one, int(k))

    def linear(self, form: Mapping[str, Fraction], constant: Fraction | int = 0) -> fmpq_mpoly:
        """The polynomial constant + Σ form[name]·name."""
        p = self.ctx.constant(fmpq(constant.numerator, constant.denominator))
        for name, c in form.items():
            p += fmpq(c.numerator, c.denominator) * self.gens[name]
        return p

    def rotate(self, c: Coefficient, k: int) -> Coefficient:
        """The product with ζ^k."""
        if not k % self.roots.n:
            return c
        num: Numerator = {}
        for m, p in c.num.items():
            for b, s in self.roots.power(k + m):
                num[b] = num[b] + s * p if b in num else s * p
        return Coefficient(self, {b: p for b, p in num.items() if p}, c.den)

    # -- arithmetic ----------------------------------------------------------------------

    def sum(self, terms: Iterable[Coefficient]) -> Coefficient:
        """The sum of any number of terms, brought to canonical form once."""
        groups: dict[tuple[tuple[int, int], ...], tuple[Denominator, Numerator]] = {}
        for c in terms:
            if not c.num:
                continue
            key = tuple(sorted(c.den.items()))
            group = groups.get(key)
            if group is None:
                groups[key] = (c.den, dict(c.num))
                continue
            num = group[1]
            for k, p in c.num.items():
                num[k] = num[k] + p if k in num else p
        if not groups:
            return self.zero
        if len(groups) == 1:
            ((den, num),) = groups.values()
        else:
            den = {}
            for part, _ in groups.values():
                for m, e in part.items():
                    den[m] = max(e, den.get(m, 0))
            num = {}
            for part, numerator in groups.values():
                factor = self._product({m: e - part.get(m, 0) for m, e in den.items()})
                for k, p in numerator.items():
                    term = p if factor is None else p * factor
                    num[k] = num[k] + term if k in num else term
        return self.cancel(Coefficient(self, {k: p for k, p in num.items() if p}, den))

    def _product(self, exponents: Denominator) -> fmpq_mpoly | None:
        """Π L_m^e over the non-zero exponents; None for the empty product."""
        result = None
        for m, e in exponents.items():
            if e:
                power = self.divisors[m] if e == 1 else self.divisors[m] ** e
                result = power if result is None else result * power
        return result

    def cancel(self, c: Coefficient) -> Coefficient:
        """The canonical form: every divisor that divides the whole numerator is taken out."""
        if not c.den:
            return c
        if not c.num:
            return self.zero
        num, den, changed = c.num, dict(c.den), False
        for m, e in c.den.items():
            divisor, left = self.divisors[m], e
            while left:
                try:
                    num = {k: p / divisor for k, p in num.items()}
                except DomainError:
                    break
                left, changed = left - 1, True
            if left:
                den[m] = left
            else:
                del den[m]
        return Coefficient(self, num, den) if changed else c

    def reciprocal(self, p: fmpq_mpoly) -> Coefficient:
        """1/p for a non-zero polynomial, its irreducible factors becoming named divisors."""
        content, den = self.factor(p)
        return Coefficient(self, self.one.num, den).scale(1 / content)

    def factor(self, p: fmpq_mpoly) -> tuple[Fraction, Denominator]:
        """A polynomial as a rational number times powers of named divisors."""
        if not p:
            raise ZeroDivisionError("the reciprocal of a zero polynomial")
        if p.is_constant():
            return _fraction(p.leading_coefficient()), {}
        if p.total_degree() == 1:
            content, factors = fmpq(1), [(p, 1)]
        else:
            content, factors = p.factor()
        number = _fraction(content)
        den: Denominator = {}
        for factor, e in factors:
            c, primitive = _primitive(factor)
            number *= c**e
            index = self._register(primitive)
            den[index] = den.get(index, 0) + int(e)
        return number, den

    def _register(self, primitive: fmpq_mpoly) -> int:
        key = tuple(zip(primitive.monoms(), primitive.coeffs(), strict=True))
        if key not in self._divisor_index:
            self._divisor_index[key] = len(self.divisors)
            self.divisors.append(primitive)
        return self._divisor_index[key]


def _fraction(q: fmpq) -> Fraction:
    return Fraction(int(q.p), int(q.q))


def _primitive(p: fmpq_mpoly) -> tuple[Fraction, fmpq_mpoly]:
    """Content and primitive part over ℤ with a positive leading coefficient."""
    coefficients = [_fraction(c) for c in p.coeffs()]
    content = Fraction(
        gcd(*(c.numerator for c in coefficients)), lcm(*(c.denominator for c in coefficients))
    )
    if coefficients[0] < 0:
        content = -content
    return content, p * fmpq(content.denominator, content.numerator)


def split_generator(c: Coefficient, name: str) -> dict[int, Coefficient]:
    """A coefficient as a polynomial in one generator: power → coefficient without it.

    Raises
    ------
    ValueError
        If a divisor of the coefficient contains the generator.
    """
    field = c.field
    index = field.names.index(name)
    if any(field.divisors[m].degrees()[index] for m in c.den):
        raise ValueError(f"{name} occurs in a denominator")
    parts: dict[int, Numerator] = {}
    for k, p in c.num.items():
        powers: dict[int, dict[tuple[int, ...], fmpq]] = {}
        for monomial, value in p.to_dict().items():
            bare = list(map(int, monomial))
            power, bare[index] = bare[index], 0
            powers.setdefault(power, {})[tuple(bare)] = value
        for power, terms in powers.items():
            parts.setdefault(power, {})[k] = field.ctx.from_dict(terms)
    return {
        power: field.cancel(Coefficient(field, num, c.den)) for power, num in sorted(parts.items())
    }


def sign(c: Coefficient, positive: frozenset[str]) -> int | None:
    """The sign of a real coefficient for all values of its generators, if it has one.

    Parameters
    ----------
    c : Coefficient
    positive : frozenset of str
        Generators known to be positive.

    Returns
    -------
    int or None
        −1, 0 or 1; None where the sign depends on the values, or is not found this way: each
        irreducible factor is asked whether all its coefficients have one sign.
    """
    if not c.num:
        return 0
    if set(c.num) != {0}:
        return None
    field = c.field
    content, factors = c.num[0].factor()
    result = 1 if content > 0 else -1
    for p, e in (*factors, *((field.divisors[m], e) for m, e in c.den.items())):
        if e % 2 == 0:
            continue
        used = {n for n, d in zip(field.names, p.degrees(), strict=True) if d}
        signs = {q > 0 for q in p.coeffs()}
        if not used <= positive or len(signs) > 1:
            return None
        result *= 1 if signs.pop() else -1
    return result
