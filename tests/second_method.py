"""A second method: averaging of any order by Lie series, simple, with nothing of the engine in it.

Variation of parameters makes a first-order system of the exact equations. With the modes φ of order
zero (φ = 1 for an oscillator that is coupled to no other) and the motion H(z) that hard forcing
makes,

    q_j = Σ_r (φ_jr a_r + c.c.) + H_j,    q_j' = Σ_r (iω_r φ_jr a_r + c.c.) + D0 H_j

defines the amplitudes a_r, which contain the fast phase; then a_r' = iω_r a_r + … small holds
exactly. Changes of variables exp(ε^p L_χ), one for each order, free it of all terms that do not
commute with the fast rotation (Krylov, Bogoliubov and Mitropolsky; Hori). What commutes is left
free by that; a second change at each order makes a_r the whole fundamental of η_r = a_r + ā_r, and
with that the result is unique and can be compared term by term. There is one time only;
accelerations on the right are replaced by what the system gives for them.

What is taken from a case are the exact equations, the orders in ε, the relations with the names
of their detunings, and the names of modes. See Sanders, Verhulst and Murdock, *Averaging
Methods in Nonlinear Dynamical Systems* (2007), chapters 2, 3 and 9 to 11.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from laurent import (
    HALF,
    IOTA,
    ONE,
    Graded,
    Key,
    Poly,
    Space,
    gaussian,
    multiple,
    plus,
    products,
    sums,
    times,
)

EPS = sp.Symbol("eps", positive=True)
Vector = tuple[Any, ...]


def taylor(expression: sp.Expr, order: int) -> sp.Expr:
    """Every function of ε as a polynomial in ε."""

    def expands(e: sp.Expr) -> bool:
        plain = e.is_Pow and e.exp.is_Integer and e.exp.is_positive
        return e.has(EPS) and e != EPS and (e.is_Function or (e.is_Pow and not plain))

    def polynomial(e: sp.Expr) -> sp.Expr:
        parts = []
        for n in range(order + 1):
            parts.append(sp.expand(e.subs(EPS, 0)) * EPS**n / sp.factorial(n))
            e = e.diff(EPS)
        return sp.Add(*parts)

    return sp.expand(expression.replace(expands, polynomial))


class Statement:
    """The scaled problem: forces by order, hard forcing, frequencies, modes.

    ε is the `step`-th power of the bookkeeping symbol, so that every order is a whole number.
    """

    def __init__(self, case: Any, order: int):
        scaled = case.weak.scaled
        self.eom = scaled.eom
        self.step = int(sp.ilcm(1, *(w.denominator for w in scaled.amplitude)))
        self.weights = [int(w * self.step) for w in scaled.amplitude]
        self.order = order * self.step
        self.n = len(self.eom.coordinates)
        self.x, self.v, self.w = (
            [sp.Symbol(f"{letter}_{j}", real=True) for j in range(self.n)] for letter in "xvw"
        )
        self.phasors: dict[sp.Expr, sp.Symbol] = {}
        small = {p: EPS ** (self.step * k) * p for p, k in scaled.orders}
        plain = [self.without_time(e).subs(small, simultaneous=True) for e in self.eom.equations]
        self.impose(case.relations)
        self.leading(scaled.modes, plain)
        found = set().union(*(e.free_symbols for e in (*plain, *self.shapes.values())))
        found = found.union(*(e.free_symbols for e in (*self.omegas, *self.detuned.values())))
        found = found.union(*(e.free_symbols for e in self.phasors))
        found -= {EPS, *self.x, *self.v, *self.w, *self.phasors.values()}
        self.space = Space(self.n, list(self.phasors.values()), sorted(found, key=str))
        self.tune()
        self.forces(plain)

    def without_time(self, equation: sp.Expr) -> sp.Expr:
        """Coordinates as symbols with their orders, e^{iΩt} as z."""
        time = self.eom.time
        for symbols, k in ((self.w, 2), (self.v, 1), (self.x, 0)):
            for q, s, weight in zip(self.eom.coordinates, symbols, self.weights, strict=True):
                equation = equation.subs(q.diff(time, k) if k else q, EPS**weight * s)

        def split(f: sp.Expr) -> sp.Expr:
            phase, rest = sp.expand(f.args[0]).as_independent(*self.x, as_Add=True)
            wave = sp.Integer(1)
            for base, c in phase.as_coefficients_dict().items():
                speed = base / time
                if speed.has(time):
                    wave *= sp.exp(sp.I * c * base)
                else:
                    wave *= self.phasors.setdefault(speed, sp.Symbol(f"z_{speed}")) ** c
            cosine, sine = (wave + 1 / wave) / 2, (wave - 1 / wave) / (2 * sp.I)
            if f.func is sp.cos:
                return cosine * sp.cos(rest) - sine * sp.sin(rest)
            return sine * sp.cos(rest) + cosine * sp.sin(rest)

        def waves(f: sp.Expr) -> bool:
            return isinstance(f, sp.cos | sp.sin) and f.has(time)

        equation = equation.replace(waves, split)
        assert not equation.has(time)
        return equation

    def impose(self, relations: Any) -> None:
        """{eliminated frequency: resonant value + ε detuning}."""
        unknowns = [next(iter(r.lhs.free_symbols)) for r in relations]
        system = [r.lhs - r.rhs - EPS**self.step * r.detuning for r in relations]
        self.detuned = sp.solve(system, unknowns) if unknowns else {}
        assert len(self.detuned) == len(unknowns)

    def leading(self, modes: Any, equations: list[sp.Expr]) -> None:
        """Inertias, frequencies before they are detuned, and φ."""
        self.named = modes.named
        symbols = {p.name: p.symbol for p in modes.parameters}
        coupled = {j for c in modes.components for j in c.members}
        self.shapes = {(j, j): sp.Integer(1) for j in range(self.n) if j not in coupled}
        self.inertias, self.omegas = [], []
        for j, equation in enumerate(equations):
            start = taylor(equation, self.weights[j]).coeff(EPS, self.weights[j])
            m, k = (start.coeff(s) for s in (self.w[j], self.x[j]))
            self.inertias.append(sp.Integer(1) if j in coupled else m)
            if modes.named[j]:
                ((name, c),) = modes.frequencies[j].items()
                self.omegas.append(symbols[name] * sp.Rational(c))
            else:
                self.omegas.append(sp.sqrt(sp.factor(sp.cancel(k / m))))
            for r, real, imaginary in modes.shapes[j] if j in coupled else ():
                parts = [symbols[s] if s else sp.Integer(0) for s in (real, imaginary)]
                self.shapes[j, r] = parts[0] + sp.I * parts[1]

    def tune(self) -> None:
        """Frequencies on resonance, as vectors; what the detunings add to those of z.

        A named frequency is detuned itself; any other by its stiffness, which is among the forces.
        """
        exact = {s: e.subs(EPS, 0) for s, e in self.detuned.items()}
        self.tuned = [
            w.subs(self.detuned if named else exact, simultaneous=True)
            for w, named in zip(self.omegas, self.named, strict=True)
        ]
        self.omegas = [sp.expand(w.subs(exact, simultaneous=True)) for w in self.omegas]
        speeds = [sp.expand(sp.sympify(s).subs(self.detuned)) for s in self.phasors]
        self.rates = [self.space.poly(s.coeff(EPS, self.step)) for s in speeds]
        forms = [f for w in self.omegas for f in (w, -w)] + [s.subs(EPS, 0) for s in speeds]
        self.basis = sorted(set().union(*(f.free_symbols for f in forms)), key=str)
        self.forms = [self.vector(f) for f in forms]
        self.known: dict[Key, Vector] = {}

    def vector(self, form: sp.Expr) -> Vector:
        constant = form.as_independent(*self.basis, as_Add=True)[0]
        return (*(form.coeff(b) for b in self.basis), constant)

    def frequency(self, key: Key) -> Vector:
        """ν of a monomial, exactly, in the independent frequencies."""
        dynamic = key[: self.space.dynamic]
        if dynamic not in self.known:
            self.known[dynamic] = tuple(
                sum(e * c for e, c in zip(dynamic, column, strict=True) if e)
                for column in zip(*self.forms, strict=True)
            )
        return self.known[dynamic]

    def form(self, vector: Vector) -> sp.Expr:
        return sp.Add(*(c * b for c, b in zip(vector, (*self.basis, 1), strict=True)))

    def forces(self, equations: list[sp.Expr]) -> None:
        """Terms by order and powers of x, v, w; hard forcing; each equation over its inertia."""
        moving = [*self.x, *self.v, *self.w]
        self.F: list[list[tuple[int, Key, Poly]]] = []
        self.hard: list[Poly] = []
        for equation, start, inertia in zip(equations, self.weights, self.inertias, strict=True):
            e = taylor(equation.subs(self.detuned, simultaneous=True), start + self.order)
            found: dict[tuple[int, Key], list[sp.Expr]] = {}
            for term in sp.Add.make_args(e):
                c, variables = term.as_independent(EPS, *moving, as_Add=False)
                powers = variables.as_powers_dict()
                key = tuple(int(powers.get(m, 0)) for m in moving)
                found.setdefault((int(powers.get(EPS, 0)) - start, key), []).append(c)
            exact = inertia.subs({s: e.subs(EPS, 0) for s, e in self.detuned.items()})
            sorted_terms = {
                place: self.space.poly(sp.Add(*parts) / exact)
                for place, parts in found.items()
                if place[0] <= self.order
            }
            assert all(s >= 0 or not p for (s, _), p in sorted_terms.items())
            self.F.append([(s, key, p) for (s, key), p in sorted_terms.items() if s > 0])
            self.hard.append(sorted_terms.get((0, (0,) * len(moving)), {}))


class Averaging(Statement):
    """The slow flow of a case: a_r' − iω_r a_r, order by order.

    Without `fundamental`, another normal form: what commutes with the rotation is left as it is.
    """

    def __init__(self, case: Any, order: int, fundamental: bool = True):
        super().__init__(case, order)
        self.field = self.first_order()
        for p in range(1, self.order + 1):
            self.remove_fast(p)
            if fundamental:
                self.make_whole(p)
        self.rates_of = [[row[p * self.step] for row in self.field] for p in range(1, order + 1)]

    def series(self, p: Poly, order: int = 0) -> Graded:
        return [p if s == order else {} for s in range(self.order + 1)]

    def turned(self, p: Poly) -> Poly:
        """D0 of a polynomial: iν times each monomial."""
        parts = (
            times({k: c * IOTA}, self.space.poly(self.form(self.frequency(k))))
            for k, c in p.items()
        )
        return plus(*parts)

    def drift(self, p: Poly) -> Poly:
        """What the detunings add to the derivative of a polynomial, over ε."""
        first = 2 * self.n
        parts = [{k: c * k[first + m] * IOTA for k, c in p.items()} for m in range(len(self.rates))]
        return plus(*(times(rate, q) for rate, q in zip(self.rates, parts, strict=True)))

    def along_motion(self, j: int, motion: list[Graded]) -> Graded:
        """F_j at x, v, w."""
        total = self.series({})
        for s, key, c in self.F[j]:
            product = self.series(c, s)
            for i, e in enumerate(key):
                for _ in range(e):
                    product = products(product, motion[i])
            total = sums(total, product)
        return total

    def forced(self, j: int) -> Poly:
        """H_j = Σ hard/(ν² − ω_j²) z^m."""
        assert not self.hard[j] or self.shapes.get((j, j)) == 1, "hard forcing of coupled modes"
        parts = []
        for k, c in self.hard[j].items():
            nu = self.form(self.frequency(k))
            part = self.space.divided({k: -c}, self.omegas[j] - nu)
            parts.append(self.space.divided(part, self.omegas[j] + nu))
        return plus(*parts)

    def graded(self, expression: sp.Expr) -> Graded:
        parts = taylor(expression, self.order)
        return [self.space.poly(parts.coeff(EPS, s)) for s in range(self.order + 1)]

    def first_order(self) -> list[Graded]:
        """a_r' − iω_r a_r = −½ (D1 H)_r + (i/2ω_r) Σ_j φ̄_jr (F_j + (D1 D0 H)_j); sets η.

        A detuned named frequency adds i(ω_r − its resonant value)a_r.
        """
        space, n = self.space, self.n
        own = [self.series({space.unit(2 * r): ONE}) for r in range(n)]
        phi = {jr: space.poly(e) for jr, e in self.shapes.items()}
        H = [self.forced(j) for j in range(n)]
        K = [self.turned(p) for p in H]

        def spun(omegas: list[sp.Expr], rows: list[Graded]) -> list[Graded]:
            pairs = zip((self.graded(sp.I * w) for w in omegas), rows, strict=True)
            return [products(w, row) for w, row in pairs]

        def real(j: int, rows: list[Graded]) -> Graded:
            """Σ_r φ_jr row_r + c.c."""
            parts = [[times(p, g) for g in rows[r]] for (k, r), p in phi.items() if k == j]
            total = sums(*parts)
            return sums(total, [space.bar(g) for g in total])

        x = [sums(real(j, own), self.series(H[j])) for j in range(n)]
        v = [sums(real(j, spun(self.tuned, own)), self.series(K[j])) for j in range(n)]
        resonant = spun(self.omegas, own)
        gaps = [w - on for w, on in zip(self.tuned, self.omegas, strict=True)]
        rest = spun(gaps, own)
        late = [self.series(self.drift(p), self.step) for p in (*H, *K)]
        for _ in range(self.order):  # one order of the accelerations more each time
            pull = spun(self.tuned, [sums(a, b) for a, b in zip(resonant, rest, strict=True)])
            start = [sums(self.series(self.turned(K[j])), late[n + j]) for j in range(n)]
            w = [sums(start[j], real(j, pull)) for j in range(n)]
            push = [sums(self.along_motion(j, [*x, *v, *w]), late[n + j]) for j in range(n)]
            rest = spun(gaps, own)
            for r in range(n):
                over = self.graded(sp.I / (2 * self.tuned[r]))
                rest[r] = sums(rest[r], [multiple(g, -HALF) for g in late[r]])
                for (j, mode), p in phi.items():
                    if mode == r:
                        row = [times(space.bar(p), g) for g in push[j]]
                        rest[r] = sums(rest[r], products(over, row))
        self.eta = [sums(a, [space.bar(g) for g in a], self.series(h)) for a, h in zip(own, H)]
        return rest

    def along(self, change: list[Poly], p: Poly) -> Poly:
        """L_χ p, χ given for a_r; for ā_r by conjugation."""
        parts = []
        for r, chi in enumerate(change):
            if chi:
                parts.append(times(chi, self.space.derivative(p, 2 * r)))
                parts.append(times(self.space.bar(chi), self.space.derivative(p, 2 * r + 1)))
        return plus(*parts)

    def bracket(self, change: list[Poly], p: int, field: list[Graded]) -> list[Graded]:
        """[ε^p L_χ, X] without the part of X that is of order zero."""
        out = [self.series({}) for _ in field]
        for s in range(1, self.order - p + 1):
            row = [g[s] for g in field]
            for r, chi in enumerate(change):
                back = self.along(row, chi)
                if s == self.step and field is self.field:
                    back = plus(back, self.drift(chi))
                out[r][p + s] = plus(self.along(change, row[r]), multiple(back, -ONE))
        return out

    def transform(self, change: list[Poly], p: int, removed: list[Poly]) -> None:
        """exp(ε^p L_χ) of the field and of η; −`removed` is [L_χ, order zero of the field]."""
        if not any(change):
            return
        term, n = self.bracket(change, p, self.field), 1
        for row, part in zip(term, removed, strict=True):
            row[p] = plus(row[p], multiple(part, -ONE))
        field = self.field
        while any(any(row) for row in term):
            field, n = [sums(a, b) for a, b in zip(field, term, strict=True)], n + 1
            share = gaussian(sp.Rational(1, n))
            term = [[multiple(g, share) for g in row] for row in self.bracket(change, p, term)]
        self.field = field
        term, n = self.eta, 1
        while any(any(row) for row in term):
            kept = [row[: self.order + 1 - p] for row in term]
            share = gaussian(sp.Rational(1, n))
            moved = [[multiple(self.along(change, g), share) for g in row] for row in kept]
            term, n = [[*[{}] * p, *row] for row in moved], n + 1
            self.eta = [sums(a, b) for a, b in zip(self.eta, term, strict=True)]

    def remove_fast(self, p: int) -> None:
        """Terms of order p that do not commute with the rotation."""
        change, removed = [], []
        for r, row in enumerate(self.field):
            gone, chi = {}, []
            for k, c in row[p].items():
                gap = tuple(
                    nu - w for nu, w in zip(self.frequency(k), self.forms[2 * r], strict=True)
                )
                if any(gap):
                    gone[k] = c
                    chi.append(self.space.divided({k: c * -IOTA}, self.form(gap)))
            change.append(plus(*chi))
            removed.append(gone)
        self.transform(change, p, removed)

    def make_whole(self, p: int) -> None:
        """a_r the whole fundamental of η_r through order p."""
        change = [
            {k: -c for k, c in row[p].items() if self.frequency(k) == self.forms[2 * r]}
            for r, row in enumerate(self.eta)
        ]
        self.transform(change, p, [{}] * self.n)
