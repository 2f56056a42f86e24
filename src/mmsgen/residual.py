"""The residual: the original equations with the expansion put back in, which must vanish.

Nothing of the recursion is used again but its results: the series q_j = Σ ε^p q_{j,p} is
differentiated as a whole with d/dt = D0 + εD1 + … and substituted into the scaled equations, term
by term and with plain products. Every coefficient of ε^0 … ε^N must be zero identically.
"""

from __future__ import annotations

from collections.abc import Sequence

from .series import HarmonicRing, Series
from .solver import Solver
from .weak import WeakSystem

__all__ = ["residual_series"]

PowerSeries = list[Series]
"""Series by order in ε."""


def residual_series(weak: WeakSystem, solver: Solver) -> list[PowerSeries]:
    """The residual of every equation, by order in ε.

    Parameters
    ----------
    weak : WeakSystem
    solver : Solver
        Solved through the order of the system, particular solutions included.

    Returns
    -------
    list of list of Series
        ``[equation][order]``; all empty for a correct expansion.
    """
    ring, top = weak.ring, weak.order
    modes = [[solver.eta[p][j] for p in range(top + 1)] for j in range(ring.n)]
    forces = _forces(weak, solver)
    if solver.modal is not None:
        forces = [_on_mode(weak, solver, forces, r) for r in range(ring.n)]
    residuals = []
    for j in range(ring.n):
        acceleration = _derivative(weak, solver, _derivative(weak, solver, modes[j]))
        omega = ring.form_polynomial(ring.amplitude_frequencies[j])
        stiffness = ring.field.polynomial(omega * omega)
        total = [
            ring.add(acceleration[p], ring.scale(modes[j][p], stiffness), forces[j][p])
            for p in range(top + 1)
        ]
        residuals.append(total)
    return residuals


def _forces(weak: WeakSystem, solver: Solver) -> list[PowerSeries]:
    """F of every equation, the coordinates put in."""
    ring, top = weak.ring, weak.order
    coordinates = [[solver.q[p][j] for p in range(top + 1)] for j in range(ring.n)]
    velocities = [_derivative(weak, solver, q) for q in coordinates]
    if weak.basis is not None and weak.basis.gyroscopic:
        # The same, by identities between all modes that no single coefficient knows of.
        velocities = [[solver.v[p][j] for p in range(top + 1)] for j in range(ring.n)]
    accelerations = [_derivative(weak, solver, v) for v in velocities]
    variables = [*coordinates, *velocities, *accelerations]
    result = []
    for j in range(ring.n):
        total: PowerSeries = [weak.forcing[j], *({} for _ in range(top))]
        for factors, by_order in weak.forces[j].items():
            product: PowerSeries = [{0: ring.field.one}, *({} for _ in range(top))]
            for index in factors:
                product = _multiply(ring, product, variables[index])
            coefficient = [by_order.get(p, {}) for p in range(top + 1)]
            term = _multiply(ring, product, coefficient)
            total = [ring.add(a, b) for a, b in zip(total, term, strict=True)]
        result.append(total)
    return result


def _on_mode(weak: WeakSystem, solver: Solver, forces: list[PowerSeries], r: int) -> PowerSeries:
    """ΣΦF − (ΣΘF)'/ω of one mode, and what a detuning leaves of its stiffness."""
    ring, basis, orders = weak.ring, weak.basis, range(weak.order + 1)
    assert basis is not None
    parts = basis.projections[r]
    direct = [ring.add(*(ring.scale(forces[k][p], c) for k, c, _ in parts)) for p in orders]
    turned = [ring.add(*(ring.scale(forces[k][p], c) for k, _, c in parts)) for p in orders]
    rate = _derivative(weak, solver, turned)
    over = [{0: -basis.inverses[r][p]} if p in basis.inverses[r] else {} for p in orders]
    square = [{0: basis.squares[r][p]} if p in basis.squares[r] else {} for p in orders]
    eta = [solver.eta[p][r] for p in orders]
    products = zip(direct, _multiply(ring, rate, over), _multiply(ring, eta, square), strict=True)
    return [ring.add(*terms) for terms in products]


def _derivative(weak: WeakSystem, solver: Solver, f: Sequence[Series]) -> PowerSeries:
    """D f with D = D0 + εD1 + ε²D2 + …."""
    ring = weak.ring
    result: PowerSeries = [ring.d0(part) for part in f]
    for p in range(len(f)):
        for r in range(1, p + 1):
            rates = weak.rates if r == 1 else {}
            turned = ring.collect(ring.derivation(f[p - r], solver.g[r], rates))
            result[p] = ring.add(result[p], turned)
    return result


def _multiply(ring: HarmonicRing, f: PowerSeries, g: Sequence[Series]) -> PowerSeries:
    result: PowerSeries = []
    for p in range(len(f)):
        terms = (t for r in range(p + 1) for t in ring.product_terms(f[r], g[p - r]))
        result.append(ring.collect(terms))
    return result
