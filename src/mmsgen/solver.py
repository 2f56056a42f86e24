"""The recursion of the method: known terms, secular terms and particular solutions, order by order.

At order p equation j reads

    (D0² + ω_j²) η_{j,p} + 2 D0 D_p η_{j,0} + [all that is known] = 0,

η_j being q_j itself unless the leading order couples it to others (`modes`). A known
monomial of frequency ω_j is secular and is the solvability condition,
D_p a_j = i·coefficient/(2ω_j); any other, of frequency ν, gives the particular solution
−coefficient/((ω_j − ν)(ω_j + ν)). Particular solutions carry no homogeneous part, so A_j is the
whole fundamental harmonic of coordinate j, and dA_j/dt = Σ_p ε^p D_p A_j.

References
----------
A. H. Nayfeh, *Introduction to Perturbation Techniques* (1981), chapters on the method of multiple
scales; A. H. Nayfeh and D. T. Mook, *Nonlinear Oscillations* (1979), chapters 2, 4 and 5.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from .errors import ExpansionError
from .field import Coefficient
from .modal import ModalState
from .nonsmooth import averaged
from .series import Form, HarmonicRing, Series
from .weak import Factors, WeakSystem

__all__ = ["OrderEquation", "Solver"]


@dataclass(frozen=True)
class OrderEquation:
    """What one equation gives at one order.

    Attributes
    ----------
    known : Series
        The known part of the equation at this order.
    secular : Series
        Its secular terms, of frequency ω_j.
    cancelled : tuple of int
        Monomials whose contributions cancel each other exactly.
    """

    known: Series
    secular: Series
    cancelled: tuple[int, ...]


class Solver:
    """The state of an expansion: q, q', q'' and D_p a_j for every order solved so far.

    Parameters
    ----------
    weak : WeakSystem

    Attributes
    ----------
    q, v, w : list
        Coordinates, velocities and accelerations by order.
    eta, eta_v, eta_w : list
        The same of the modes: the same lists where no coordinates are coupled.
    g : list
        D_p a_j by order p and mode.
    """

    def __init__(self, weak: WeakSystem) -> None:
        self.weak = weak
        self.ring: HarmonicRing = weak.ring
        self.n = weak.ring.n
        self.q: list[list[Series]] = []
        self.v: list[list[Series]] = []
        self.w: list[list[Series]] = []
        self.modal = None if weak.basis is None else ModalState(weak.ring, weak.basis)
        self.eta, self.eta_v, self.eta_w = (
            (self.q, self.v, self.w)
            if self.modal is None
            else (self.modal.eta, self.modal.eta_v, self.modal.eta_w)
        )
        self.g: list[list[Series]] = []
        self.equations: list[list[OrderEquation]] = []
        self._products: dict[tuple[Factors, int], Series] = {}
        self._divisors: dict[tuple[int, Form], Coefficient] = {}

    # -- building blocks -----------------------------------------------------------------

    def _variable(self, index: int, order: int) -> Series:
        derivative, j = divmod(index, self.n)
        return (self.q, self.v, self.w)[derivative][order][j]

    def product(self, factors: Factors, order: int) -> Series:
        """The ε^order part of a product of variables."""
        if not factors:
            return {0: self.ring.field.one} if order == 0 else {}
        if len(factors) == 1:
            return self._variable(factors[0], order)
        known = self._products.get((factors, order))
        if known is None:
            head, last = factors[:-1], factors[-1]
            terms = (
                term
                for r in range(order + 1)
                for term in self.ring.product_terms(
                    self.product(head, r), self._variable(last, order - r)
                )
            )
            known = self._products[factors, order] = self.ring.collect(terms)
        return known

    def _force_terms(self, j: int, order: int) -> Iterable[tuple[int, Coefficient]]:
        for factors, by_order in self.weak.forces[j].items():
            if factors and factors[-1] >= 3 * self.n:
                yield from averaged(self, j, factors, by_order.get(order, {}))
                continue
            for s, coefficient in by_order.items():
                if s <= order:
                    yield from self.ring.product_terms(
                        coefficient, self.product(factors, order - s)
                    )

    def _derivation(
        self, f: Series, p: int, images: list[Series]
    ) -> Iterable[tuple[int, Coefficient]]:
        return self.ring.derivation(f, images, self.weak.rates if p == 1 else {})

    def _divisor(self, j: int, form: Form) -> Coefficient:
        """−1/((ω_j − ν)(ω_j + ν))."""
        known = self._divisors.get((j, form))
        if known is None:
            ring, omega = self.ring, self.ring.amplitude_frequencies[j]
            minus = ring.form_polynomial(tuple(a - b for a, b in zip(omega, form, strict=True)))
            plus = ring.form_polynomial(tuple(a + b for a, b in zip(omega, form, strict=True)))
            known = -(ring.field.reciprocal(minus) * ring.field.reciprocal(plus))
            self._divisors[j, form] = known
        return known

    # -- orders --------------------------------------------------------------------------

    def solve_order_zero(self) -> None:
        """η_{j,0} = a_j + ā_j + the response to hard forcing."""
        ring, one = self.ring, self.ring.field.one
        forcing = self._on_modes(self.weak.forcing, 0)
        eta = []
        for j in range(self.n):
            response = {}
            for key, c in forcing[j].items():
                if self._is_fundamental(j, key):
                    raise ExpansionError(
                        f"hard forcing drives {self.weak.scaled.coordinates[j]} at its natural "
                        "frequency: scale the forcing with an order of 1 or more"
                    )
                response[key] = c * self._divisor(j, ring.frequency(key))
            eta.append({ring.a(j): one, ring.abar(j): one, **response})
        self.eta.append(eta)
        self.eta_v.append([ring.d0(f) for f in eta])
        self.eta_w.append([ring.d0(f) for f in self.eta_v[0]])
        self.g.append([{} for _ in eta])
        self._complete_coordinates(0)

    def _on_modes(self, forces: Sequence[Series], p: int) -> list[Series]:
        """What drives each mode at order p, and what a detuning leaves of its stiffness."""
        if self.modal is None:
            return list(forces)
        direct = self.modal.project(forces)
        return [
            self.ring.collect(self.modal.known(r, p, direct[r], self._known_derivative))
            for r in range(self.n)
        ]

    def _known_derivative(
        self, stack: Sequence[Series], p: int
    ) -> Iterable[tuple[int, Coefficient]]:
        """The ε^p part of a time derivative, as far as D_p a is not in it."""
        nothing: list[Series] = [{} for _ in range(self.n)]
        images = [*self.g, nothing]
        yield from self.ring.d0(stack[p]).items()
        for r in range(1, p + 1):
            yield from self._derivation(stack[p - r], r, images[r])

    def _complete_coordinates(self, p: int) -> None:
        """q, q' and q'' from the modes at order p."""
        if self.modal is None:
            return
        q, v = self.modal.coordinates(p)
        self.q.append(q)
        self.v.append(v)
        self.w.append(
            [
                self.ring.collect(self._known_derivative([x[k] for x in self.v], p))
                for k in range(self.n)
            ]
        )

    def _is_fundamental(self, j: int, key: int) -> bool:
        form = self.ring.frequency(key)
        omega = self.ring.amplitude_frequencies[j]
        return form == omega or form == tuple(-c for c in omega)

    def known_kinematics(self, j: int, p: int) -> tuple[Series, Series]:
        """η_j' and η_j'' at order p without η_{j,p} and D_p a."""
        ring = self.ring
        nothing: list[Series] = [{} for _ in range(self.n)]
        images = [*self.g, nothing]
        v = ring.collect(
            t for r in range(1, p + 1) for t in self._derivation(self.eta[p - r][j], r, images[r])
        )
        w = ring.collect(
            (
                *ring.d0(v).items(),
                *(
                    t
                    for r in range(1, p + 1)
                    for t in self._derivation(self.eta_v[p - r][j], r, images[r])
                ),
            )
        )
        return v, w

    def solve_order(self, p: int, *, particular: bool = True) -> None:
        """Solve all equations at order p: secular terms first, then particular solutions."""
        known = [self.known_kinematics(j, p) for j in range(self.n)]
        if self.modal is None:
            forces = [self._force_terms(j, p) for j in range(self.n)]
        else:
            own = [self.ring.collect(self._force_terms(j, p)) for j in range(self.n)]
            forces = [f.items() for f in self._on_modes(own, p)]
        equations = [self._order_equation(j, known[j][1], forces[j]) for j in range(self.n)]
        self.equations.append(equations)
        half_i = self.ring.field.rational(Fraction(1, 2)).times_i()
        self.g.append(
            [
                self.ring.scale(e.secular, half_i * self._over_frequency(j))
                for j, e in enumerate(equations)
            ]
        )
        if particular:
            self._complete(p, known, equations)

    def _over_frequency(self, j: int) -> Coefficient:
        ring = self.ring
        return ring.field.reciprocal(ring.form_polynomial(ring.amplitude_frequencies[j]))

    def _order_equation(
        self, j: int, w: Series, forces: Iterable[tuple[int, Coefficient]]
    ) -> OrderEquation:
        bins: dict[int, list[Coefficient]] = {}
        for key, c in (*w.items(), *forces):
            bins.setdefault(key, []).append(c)
        known, cancelled = {}, []
        for key, terms in bins.items():
            total = self.ring.field.sum(terms)
            if total:
                known[key] = total
            else:
                cancelled.append(key)
        omega = self.ring.amplitude_frequencies[j]
        secular = {k: c for k, c in known.items() if self.ring.frequency(k) == omega}
        return OrderEquation(known, secular, tuple(cancelled))

    def particular(self, j: int, equation: OrderEquation) -> Series:
        """The particular solution of equation j at one order, without its fundamental harmonic."""
        return {
            key: c * self._divisor(j, self.ring.frequency(key))
            for key, c in equation.known.items()
            if not self._is_fundamental(j, key)
        }

    def _complete(
        self, p: int, known: list[tuple[Series, Series]], equations: list[OrderEquation]
    ) -> None:
        """η, η' and η'' at order p from the particular solutions and D_p a."""
        ring = self.ring
        eta, eta_v, eta_w = [], [], []
        for j, equation in enumerate(equations):
            part = self.particular(j, equation)
            fresh = ring.collect(ring.derivation(self.eta[0][j], self.g[p], {}))
            vp = ring.add(ring.d0(part), fresh)
            late = ring.collect(ring.derivation(self.eta_v[0][j], self.g[p], {}))
            eta.append(part)
            eta_v.append(ring.add(known[j][0], vp))
            eta_w.append(ring.add(known[j][1], ring.d0(vp), late))
        self.eta.append(eta)
        self.eta_v.append(eta_v)
        self.eta_w.append(eta_w)
        self._complete_coordinates(p)
