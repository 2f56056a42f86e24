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
    coordinates = [[solver.q[p][j] for p in range(top + 1)] for j in range(ring.n)]
    velocities = [_derivative(weak, solver, q) for q in coordinates]
    accelerations = [_derivative(weak, solver, v) for v in velocities]
    variables = [*coordinates, *velocities, *accelerations]
    residuals = []
    for j in range(ring.n):
        omega = ring.form_polynomial(ring.amplitude_frequencies[j])
        stiffness = ring.field.polynomial(omega * omega)
        total = [
            ring.add(accelerations[j][p], ring.scale(coordinates[j][p], stiffness))
            for p in range(top + 1)
        ]
        total[0] = ring.add(total[0], weak.forcing[j])
        for factors, by_order in weak.forces[j].items():
            product: PowerSeries = [{0: ring.field.one}, *({} for _ in range(top))]
            for index in factors:
                product = _multiply(ring, product, variables[index])
            coefficient = [by_order.get(p, {}) for p in range(top + 1)]
            term = _multiply(ring, product, coefficient)
            total = [ring.add(a, b) for a, b in zip(total, term, strict=True)]
        residuals.append(total)
    return residuals


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
