"""Expressions as truncated polynomials in q, q', q'' with phasors, exactly.

`Taylor` walks a SymPy expression once and evaluates it in the sparse algebra over the variables
q_1 … q_n, q_1' … q_n', q_1'' … q_n'', z_1 … z_m. Analytic functions are expanded about q = 0 to
the weight asked for; where nothing may be truncated, a function of q that is not a polynomial is
refused. Where |·| or sgn of coordinates or velocities occurs, the signs of q_1 … q_n and of
q_1' … q_n' are variables too, before z_1: |q| is q·sgn q, and the square of a sign is 1.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import factorial

import sympy as sp

from .alphabet import KINKED, PERIODIC, Alphabet, fraction, phase_terms
from .cyclotomic import gauss_sum
from .errors import ScalingError
from .field import Coefficient, sign
from .monomials import Packing

__all__ = ["Polynomial", "Taylor"]

Polynomial = dict[int, Coefficient]
"""Packed exponents of (q, q', q'', z) → coefficient."""

ANALYTIC = (
    *(sp.exp, sp.log, sp.tan, sp.cot, sp.sec, sp.csc, sp.asin, sp.acos, sp.atan),
    *(sp.sinh, sp.cosh, sp.tanh, sp.coth, sp.sech, sp.asinh, sp.acosh, sp.atanh),
)


@dataclass
class Taylor:
    """Evaluate expressions in the truncated polynomial algebra.

    Parameters
    ----------
    alphabet : Alphabet
    coordinates : sequence
        q_j(t), applied functions of time.
    weights : sequence of Fraction
        Order in ε of the amplitude of each coordinate.
    limit : Fraction
        Terms of a larger total weight are dropped; they are beyond the order asked for.
    """

    alphabet: Alphabet
    coordinates: Sequence[sp.Expr]
    weights: Sequence[Fraction]
    limit: Fraction
    _memo: dict[sp.Expr, Polynomial] = field(default_factory=dict)

    def __post_init__(self) -> None:
        n = len(self.coordinates)
        self.dynamic = (5 if self.alphabet.kinked else 3) * n
        self.packing = Packing(self.dynamic + len(self.alphabet.phasors))
        time = self.alphabet.time
        self._variables: dict[sp.Expr, int] = {}
        for order in range(3):
            for j, q in enumerate(self.coordinates):
                self._variables[q.diff(time, order) if order else q] = order * n + j
        self.moving_parts = frozenset(self._variables)
        self._weight: dict[int, Fraction] = {}
        self._phasor = {
            (p.moving, p.base): (self.dynamic + m, p.step)
            for m, p in enumerate(self.alphabet.phasors)
        }

    # -- monomials -----------------------------------------------------------------------

    def variable(self, node: sp.Expr) -> int:
        """The index of a coordinate or of its derivative."""
        return self._variables[node]

    def weight(self, key: int) -> Fraction:
        """Order in ε of the amplitudes in a monomial."""
        w = self._weight.get(key)
        if w is None:
            n = len(self.coordinates)
            pairs = self.packing.support(key)
            w = sum((e * self.weights[i % n] for i, e in pairs if i < 3 * n), Fraction(0))
            self._weight[key] = w
        return w

    def degree(self, key: int) -> int:
        """Degree of a monomial in q, q' and q''."""
        return sum(e for i, e in self.packing.support(key) if i < 3 * len(self.coordinates))

    def show(self, key: int) -> str:
        """A monomial in the user's symbols, for messages."""
        e = self.packing.exponents(key)
        n = len(self.coordinates)
        parts = [q ** e[i] for q, i in self._variables.items()]
        for q, i in self._variables.items() if self.alphabet.kinked else ():
            if i < 2 * n and e[3 * n + i]:
                parts[i] = sp.Abs(q) * q ** (e[i] - 1) if e[i] else sp.sign(q)
        phase = sum(
            p.angle * e[self.dynamic + m] * (self.alphabet.time if p.moving else 1)
            for m, p in enumerate(self.alphabet.phasors)
        )
        return str(sp.Mul(*parts) * sp.exp(sp.I * phase))

    # -- algebra -------------------------------------------------------------------------

    def _sum(self, parts: Sequence[Polynomial]) -> Polynomial:
        bins: dict[int, list[Coefficient]] = {}
        for part in parts:
            for key, c in part.items():
                bins.setdefault(key, []).append(c)
        sums = ((k, self.alphabet.field.sum(cs)) for k, cs in bins.items())
        return {k: c for k, c in sums if c.num}

    def _product(self, f: Polynomial, g: Polynomial) -> Polynomial:
        bins: dict[int, list[Coefficient]] = {}
        for k, c in f.items():
            for m, d in g.items():
                if self.weight(k) + self.weight(m) <= self.limit:
                    bins.setdefault(self._reduced(k + m), []).append(c.times(d))
        sums = ((k, self.alphabet.field.sum(cs)) for k, cs in bins.items())
        return {k: c for k, c in sums if c.num}

    def _reduced(self, key: int) -> int:
        """A monomial with the squares of signs written as 1."""
        if self.alphabet.kinked:
            e = self.packing.exponents(key)
            for i in range(3 * len(self.coordinates), self.dynamic):
                if e[i] > 1:
                    key -= self.packing.unit[i] * (e[i] - e[i] % 2)
        return key

    def _scaled(self, f: Polynomial, c: Coefficient) -> Polynomial:
        return {k: d * c for k, d in f.items()}

    def _conjugate(self, f: Polynomial) -> Polynomial:
        result = {}
        for key, c in f.items():
            e = self.packing.exponents(key)
            flipped = (*e[: self.dynamic], *(-k for k in e[self.dynamic :]))
            result[self.packing.pack(flipped)] = c.conjugate()
        return result

    def _series(
        self, u: Polynomial, coefficient: Callable[[int], Coefficient], node: sp.Expr
    ) -> Polynomial:
        """Σ_k coefficient(k) u^k; u must gain weight with every power."""
        if any(self.weight(key) <= 0 for key in u):
            raise ScalingError(
                f"{node} is not a polynomial in the coordinates and cannot be expanded: give the "
                "amplitude an order (amplitude=1 or more), or linearise the equations first"
            )
        field_ = self.alphabet.field
        total, power, k = [{0: coefficient(0)} if coefficient(0) else {}], {0: field_.one}, 0
        while power:
            k, power = k + 1, self._product(power, u)
            if power and (c := coefficient(k)):
                total.append(self._scaled(power, c))
        return self._sum(total)

    # -- expressions ---------------------------------------------------------------------

    def __call__(self, node: sp.Expr) -> Polynomial:
        """The polynomial of an expression.

        Raises
        ------
        ScalingError
            If it has no exact expansion; the message names the offending part.
        """
        known = self._memo.get(node)
        if known is None:
            known = self._memo[node] = self._evaluate(node)
        return known

    def _evaluate(self, node: sp.Expr) -> Polynomial:
        field_ = self.alphabet.field
        if node.is_Rational:
            return {0: field_.rational(fraction(node))} if node != 0 else {}
        if node in self._variables:
            key = self.packing.unit[self._variables[node]]
            return {key: field_.one} if self.weight(key) <= self.limit else {}
        if node is sp.I:
            return {0: field_.one.times_i()}
        if node.is_Symbol or isinstance(node, sp.NumberSymbol):
            return {0: self._generator(node, Fraction(1))}
        if node.is_Add:
            return self._sum([self(arg) for arg in node.args])
        if node.is_Mul:
            result = {0: field_.one}
            for arg in node.args:
                result = self._product(result, self(arg))
            return result
        if isinstance(node, sp.exp) and not node.args[0].has(sp.I):
            return self._analytic(node)
        if node.is_Pow:
            return self._power(node)
        if isinstance(node, PERIODIC):
            return self._periodic(node)
        if isinstance(node, ANALYTIC):
            return self._analytic(node)
        if isinstance(node, KINKED):
            return self._kinked(node)
        raise ScalingError(self._refusal(node))

    def _refusal(self, node: sp.Expr) -> str:
        if node.is_Float:
            return f"the number {node} is a float: write it as a Rational, results are exact"
        if node == self.alphabet.time:
            return f"{node} stands outside of cos, sin and exp: coefficients must be periodic"
        return f"{node} has no Taylor expansion about the equilibrium that is known here"

    def _endless(self, node: sp.Expr) -> str:
        return f"{node} depends on time: its Fourier series does not terminate"

    def _generator(self, symbol: sp.Expr, exponent: Fraction) -> Coefficient:
        name = str(symbol.name) if symbol.is_Symbol else f"<{symbol}>"
        field_ = self.alphabet.field
        if name not in field_.gens:
            if symbol == self.alphabet.time:
                raise ScalingError(self._refusal(symbol))
            raise ScalingError(f"{symbol} is not a declared parameter: add Parameter({symbol})")
        if exponent.denominator % 2 == 0 and not symbol.is_nonnegative:
            raise ScalingError(
                f"{symbol ** sp.Rational(exponent)} is real for {symbol} >= 0 only: declare "
                f"{symbol} positive or nonnegative"
            )
        power = exponent * self.alphabet.roots.get(name, 1)
        return field_.generator(name) ** int(power)

    def _power(self, node: sp.Pow) -> Polynomial:
        base, exponent = node.base, node.exp
        if not exponent.is_Rational:
            raise ScalingError(f"{node}: the exponent must be a rational number")
        r = fraction(exponent)
        if base.is_Symbol:
            return {0: self._generator(base, r)}
        b = self(base)
        if r.denominator == 1 and r > 0:
            result = b
            for _ in range(int(r) - 1):
                result = self._product(result, b)
            return result
        constant = b.get(0)
        if constant is None:
            raise ScalingError(
                f"{node} is singular or not analytic at the equilibrium: it cannot be expanded"
            )
        if any(key and not self.degree(key) for key in b):
            raise ScalingError(
                f"{node} has a time or phase in a denominator or radical: not a finite Fourier "
                "series; name a constant factor as a parameter of its own"
            )
        root = constant if r.denominator == 1 else self._root(constant, r.denominator, node)
        head = root**r.numerator
        u = self._scaled({k: c for k, c in b.items() if k}, constant.inverse())
        if not u:
            return {0: head}
        binomial = _binomials(r)
        return self._scaled(
            self._series(u, lambda k: field_rational(self, binomial(k)), node), head
        )

    def _root(self, c: Coefficient, q: int, node: sp.Expr) -> Coefficient:
        """The positive square root of a square; anything else is refused."""
        field_ = self.alphabet.field
        refusal = ScalingError(
            f"the radical {node} is no rational function of the parameters, of known sign: name it "
            "as a parameter of its own (reparametrise, or Parameter(..., definition=...))"
        )
        if q != 2 or set(c.num) != {0} or any(e % 2 for e in c.den.values()):
            raise refusal
        content, factors = c.num[0].factor()
        number = Fraction(int(content.p), int(content.q))
        if number <= 0 or any(e % 2 for _, e in factors):
            raise refusal
        root = field_.one
        for factor, e in factors:
            root = root * field_.polynomial(factor ** (e // 2))
        for m, e in c.den.items():
            root = root * field_.reciprocal(field_.divisors[m] ** (e // 2))
        direction = sign(root, self.alphabet.positive)
        if direction is None:
            raise refusal
        return self._number_root(number, refusal).scale(direction) * root

    def _number_root(self, number: Fraction, refusal: ScalingError) -> Coefficient:
        """The square root of a positive rational number."""
        field_ = self.alphabet.field
        radicand = number.numerator * number.denominator
        squarefree = int(sp.ntheory.factor_.core(radicand))
        outside = sp.integer_nthroot(radicand // squarefree, 2)[0]
        root = field_.one.scale(Fraction(int(outside), number.denominator))
        if squarefree == 1:
            return root
        n, terms = gauss_sum(squarefree)
        if field_.roots.n % n:
            raise refusal
        surd = field_.sum(field_.root_of_unity(Fraction(k, n)).scale(s) for k, s in terms.items())
        return root * surd

    def _phase(self, angle: sp.Expr, node: sp.Expr) -> Polynomial:
        """exp(i·angle)."""
        field_ = self.alphabet.field
        frequencies, phases, turn, rest = phase_terms(angle, self.alphabet.time, self.moving_parts)
        exponents: dict[int, int] = {}
        for moving, parts in ((True, frequencies), (False, phases)):
            for base, coefficient in parts:
                index, step = self._phasor[moving, base]
                exponents[index] = exponents.get(index, 0) + int(coefficient / step)
        head = {self.packing.pack(exponents): field_.root_of_unity(turn)}
        if rest == 0:
            return head
        iu = {key: c.times_i() for key, c in self(rest).items()}
        series = self._series(iu, lambda k: field_rational(self, Fraction(1, factorial(k))), node)
        return self._product(head, series)

    def _periodic(self, node: sp.Expr) -> Polynomial:
        field_ = self.alphabet.field
        if isinstance(node, sp.exp):
            return self._phase(node.args[0] / sp.I, node)
        if not isinstance(node, (sp.cos, sp.sin)):
            if phase_terms(node.args[0], self.alphabet.time, self.moving_parts)[0]:
                raise ScalingError(self._endless(node))
            return self._analytic(node)
        e = self._phase(node.args[0], node)
        conjugate = self._conjugate(e)
        half = field_.rational(Fraction(1, 2))
        if isinstance(node, sp.cos):
            return self._sum([self._scaled(e, half), self._scaled(conjugate, half)])
        return self._sum(
            [self._scaled(e, half.times_i(-1)), self._scaled(conjugate, half.times_i(1))]
        )

    def _kinked(self, node: sp.Expr) -> Polynomial:
        """|c x| = |c| x sgn x and sgn(c x) = sgn c · sgn x; x a coordinate or velocity."""
        argument, n = self(node.args[0]), len(self.coordinates)
        refusal = ScalingError(
            f"{node} is not smooth: known here are the modulus and the sign of one coordinate, or "
            "of one velocity, times a factor of known sign"
        )
        if len(argument) != 1:
            raise refusal
        ((key, c),) = argument.items()
        direction, support = sign(c, self.alphabet.positive), self.packing.support(key)
        if not direction or len(support) > 1 or any(i >= 2 * n or e > 1 for i, e in support):
            raise refusal
        turned = key + sum(self.packing.unit[3 * n + i] for i, _ in support)
        size = {turned: c.scale(direction)}
        if isinstance(node, sp.Abs):
            return size
        return {turned - key: self.alphabet.field.one.scale(direction)}

    def _analytic(self, node: sp.Expr) -> Polynomial:
        """f(c + u) from the derivatives of f at the constant c."""
        argument = self(node.args[0])
        if any(key and not self.degree(key) for key in argument):
            raise ScalingError(self._endless(node))
        at_rest = node.args[0].subs({q: 0 for q in reversed(list(self._variables))}).doit()
        x = sp.Dummy("x", real=True)
        derivatives = [node.func(x)]

        def coefficient(k: int) -> Coefficient:
            while len(derivatives) <= k:
                derivatives.append(derivatives[-1].diff(x))
            value = derivatives[k].subs(x, at_rest)
            if value.has(sp.zoo, sp.oo, -sp.oo, sp.nan):
                raise ScalingError(f"{node} is singular at the equilibrium: it cannot be expanded")
            if value.atoms(*ANALYTIC, sp.Abs):
                raise ScalingError(
                    f"{node} cannot be expanded exactly: its expansion about the equilibrium holds "
                    f"{value}, which is no rational function of the parameters; name it as a "
                    "parameter of its own"
                )
            return self(value).get(0, self.alphabet.field.zero).scale(Fraction(1, factorial(k)))

        return self._series({k: c for k, c in argument.items() if k}, coefficient, node)


def field_rational(taylor: Taylor, value: Fraction) -> Coefficient:
    """A rational number in the field of an evaluator."""
    return taylor.alphabet.field.rational(value)


def _binomials(r: Fraction) -> Callable[[int], Fraction]:
    """The generalised binomial coefficients of exponent r."""

    def binomial(k: int) -> Fraction:
        value = Fraction(1)
        for i in range(k):
            value = value * (r - i) / (i + 1)
        return value

    return binomial
