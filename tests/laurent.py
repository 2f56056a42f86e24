"""Laurent polynomials as plain dictionaries, for the second method; nothing of the engine in it."""

from __future__ import annotations

from collections.abc import Sequence
from operator import add
from typing import Any

import sympy as sp

Key = tuple[Any, ...]
Poly = dict[Key, Any]
"""Exponents of all variables → Gaussian rational."""

Graded = list[Poly]
"""By order in ε."""


def gaussian(number: Any) -> Any:
    return sp.QQ_I.from_sympy(sp.sympify(number))


ONE, IOTA, HALF = gaussian(1), gaussian(sp.I), gaussian(sp.Rational(1, 2))


def plus(*polynomials: Poly) -> Poly:
    out: Poly = {}
    for p in polynomials:
        for k, c in p.items():
            out[k] = out[k] + c if k in out else c
    return {k: c for k, c in out.items() if c}


def times(p: Poly, q: Poly) -> Poly:
    out: Poly = {}
    for k, c in p.items():
        for m, e in q.items():
            key = tuple(map(add, k, m))
            out[key] = out[key] + c * e if key in out else c * e
    return {k: c for k, c in out.items() if c}


def multiple(p: Poly, factor: Any) -> Poly:
    return {k: c * factor for k, c in p.items()}


def sums(*series: Graded) -> Graded:
    return [plus(*parts) for parts in zip(*series, strict=True)]


def products(p: Graded, q: Graded) -> Graded:
    """Truncated at the order of both."""
    return [plus(*(times(p[s], q[n - s]) for s in range(n + 1) if p[s])) for n in range(len(p))]


class Space:
    """The variables: a_r, ā_r in turn, phasors z, parameters, and reciprocals as they come up."""

    SPARE = 60

    def __init__(self, modes: int, phasors: Sequence[sp.Symbol], parameters: Sequence[sp.Symbol]):
        self.modes, self.dynamic = modes, 2 * modes + len(phasors)
        state = [sp.Symbol(f"{c}_{r}") for r in range(modes) for c in ("a", "abar")]
        self.names: list[sp.Expr] = [*state, *phasors, *parameters]
        self.fixed = len(self.names)
        self.size = self.fixed + self.SPARE
        self.place = {s: i for i, s in enumerate(self.names)}
        self.inverses: dict[sp.Expr, Poly] = {}
        self.ring = sp.ring(list(parameters), sp.QQ_I)[0]

    def unit(self, i: int | None = None, e: Any = 1) -> Key:
        """The exponents of one variable to a power, or of 1."""
        return tuple(e if k == i else 0 for k in range(self.size))

    def reciprocal(self, base: sp.Expr) -> int:
        """The variable that stands for 1/base."""
        name = sp.Pow(base, -1)
        if name not in self.place:
            self.place[name] = len(self.names)
            self.names.append(name)
            assert len(self.names) <= self.size
        return self.place[name]

    def poly(self, expression: sp.Expr) -> Poly:
        """A sum of products of powers of variables, and of negative powers of sums."""
        parts = []
        for term in sp.Add.make_args(sp.expand(expression)):
            c, rest = term.as_independent(*term.free_symbols, as_Add=False)
            product = {self.unit(): gaussian(c)}
            for base, e in rest.as_powers_dict().items():
                if base in self.place:
                    product = times(product, {self.unit(self.place[base], int(e)): ONE})
                elif base not in (0, 1):
                    assert e.is_Integer and e < 0, term
                    for _ in range(-e):
                        product = times(product, self.inverse(base))
            parts.append(product)
        return plus(*parts)

    def inverse(self, base: sp.Expr) -> Poly:
        if base not in self.inverses:
            lower, upper = map(sp.expand, sp.fraction(sp.cancel(base)))
            inverse = self.poly(upper if lower.is_Add else upper / lower)
            if lower.is_Add:
                inverse = times(inverse, {self.unit(self.reciprocal(lower)): ONE})
            self.inverses[base] = inverse
        return self.inverses[base]

    def divided(self, p: Poly, form: sp.Expr) -> Poly:
        """A polynomial over a linear form in frequencies."""
        content, primitive = form.as_content_primitive()
        if primitive.could_extract_minus_sign():
            content, primitive = -content, -primitive
        return times(p, multiple(self.inverse(primitive), gaussian(1 / content)))

    def bar(self, p: Poly) -> Poly:
        """The complex conjugate."""
        n, d = 2 * self.modes, self.dynamic
        return {
            (*(k[i ^ 1] for i in range(n)), *(-e for e in k[n:d]), *k[d:]): sp.QQ_I(c.x, -c.y)
            for k, c in p.items()
        }

    def derivative(self, p: Poly, i: int) -> Poly:
        return {(*k[:i], k[i] - 1, *k[i + 1 :]): c * k[i] for k, c in p.items() if k[i]}

    def expression(self, p: Poly) -> sp.Expr:
        return sp.Add(
            *(
                sp.QQ_I.to_sympy(c) * sp.Mul(*(b**e for b, e in zip(self.names, k) if e))
                for k, c in p.items()
            )
        )

    def equal(self, p: Poly, other: sp.Expr) -> bool:
        """Whether a polynomial in the parameters is the expression: both multiplied out."""
        ring, d, fixed = self.ring, self.dynamic, self.fixed
        upper, lower = map(ring.from_expr, sp.fraction(sp.together(other)))
        least = [min((k[i] for k in p), default=0) for i in range(d, fixed)]
        most = [max((k[i] for k in p), default=0) for i in range(fixed, len(self.names))]
        groups: dict[Key, dict[Key, Any]] = {}
        for k, c in p.items():
            shifted = tuple(e - low for e, low in zip(k[d:fixed], least, strict=True))
            groups.setdefault(k[fixed : len(self.names)], {})[shifted] = c
        forms = [ring.from_expr(1 / b) for b in self.names[fixed:]]
        left = ring.zero
        for powers, group in groups.items():
            part = ring.from_dict(group)
            for form, high, e in zip(forms, most, powers, strict=True):
                part = part * form ** (high - e)
            left += part
        for x, low in zip(ring.gens, least, strict=True):
            left, upper = left * x ** max(low, 0), upper * x ** max(-low, 0)
        for form, high in zip(forms, most, strict=True):
            upper = upper * form**high
        return left * lower == upper
