"""Between coordinates and modes, order by order: projections of forces, sums of modes.

The formulas stand in `modes`. F is the sum of all forces of an equation, hard forcing included; a
detuned frequency ω is a series in ε, so that every product with it is a sum over orders.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

from .field import Coefficient
from .grading import Graded
from .series import HarmonicRing, Series
from .weak import ModalBasis

__all__ = ["ModalState"]

Terms = Iterable[tuple[int, Coefficient]]
Stack = list[list[Series]]
"""[order][coordinate or mode]."""

Derivative = Callable[[Sequence[Series], int], Terms]
"""Series by order and an order p → the ε^p part of the time derivative."""


@dataclass
class ModalState:
    """What is known of the modes so far.

    Attributes
    ----------
    ring : HarmonicRing
    basis : ModalBasis
    eta, eta_v, eta_w : list
        η, η' and η'' by order and mode.
    quadrature : list
        ΣΘF by order and mode.
    """

    ring: HarmonicRing
    basis: ModalBasis
    eta: Stack = field(default_factory=list)
    eta_v: Stack = field(default_factory=list)
    eta_w: Stack = field(default_factory=list)
    quadrature: Stack = field(default_factory=list)

    def project(self, forces: Sequence[Series]) -> list[Series]:
        """ΣΦF of every mode at one order; keeps ΣΘF."""
        ring = self.ring
        direct, turned = [], []
        for parts in self.basis.projections:
            direct.append(ring.add(*(ring.scale(forces[k], real) for k, real, _ in parts if real)))
            turned.append(ring.add(*(ring.scale(forces[k], im) for k, _, im in parts if im)))
        self.quadrature.append(turned)
        return direct

    def known(self, r: int, p: int, direct: Series, derivative: Derivative) -> Terms:
        """The forces on mode r at order p: ΣΦF − (ΣΘF)'/ω, and what a detuning of ω leaves."""
        yield from direct.items()
        for s, c in self.basis.squares[r].items():
            if s <= p:
                yield from self.ring.scale(self.eta[p - s][r], c).items()
        if not self.basis.gyroscopic:
            return
        turned = [stack[r] for stack in self.quadrature]
        for s, c in self.basis.inverses[r].items():
            if s <= p and any(turned):
                rate = self.ring.collect(derivative(turned, p - s))
                yield from self.ring.scale(rate, -c).items()

    def coordinates(self, p: int) -> tuple[list[Series], list[Series]]:
        """q and q' at order p, once η and η' are known there."""
        ring, basis = self.ring, self.basis
        companions = [self._companion(r, p) for r in range(ring.n)] if basis.gyroscopic else []
        q, v = [], []
        for parts in basis.shapes:
            place: list[Series] = []
            speed: list[Series] = []
            for r, real, imaginary in parts:
                if real:
                    place.append(ring.scale(self.eta[p][r], real))
                if imaginary:
                    place.append(ring.scale(companions[r][p], imaginary))
                    own = self._times(basis.frequencies[r], [x[r] for x in self.eta], p)
                    speed.append(ring.scale(own, -imaginary))
                if real and basis.gyroscopic:
                    own = self._times(basis.frequencies[r], companions[r], p)
                    speed.append(ring.scale(own, real))
                elif real:
                    speed.append(ring.scale(self.eta_v[p][r], real))
            q.append(ring.add(*place))
            v.append(ring.add(*speed))
        return q, v

    def _companion(self, r: int, p: int) -> list[Series]:
        """s = (η' − ΣΘF/ω)/ω at orders 0 … p."""
        inverse = self.basis.inverses[r]
        turned = [stack[r] for stack in self.quadrature]
        rest = [
            self.ring.add(
                self.eta_v[k][r],
                self.ring.scale(self._times(inverse, turned, k), self.ring.field.rational(-1)),
            )
            for k in range(p + 1)
        ]
        return [self._times(inverse, rest, k) for k in range(p + 1)]

    def _times(self, c: Graded, stack: Sequence[Series], p: int) -> Series:
        """The ε^p part of a product."""
        return self.ring.add(*(self.ring.scale(stack[p - s], x) for s, x in c.items() if s <= p))
