"""Random systems: the expansion, put back into its equations, leaves nothing."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from systems import (
    Omega,
    Omega_2,
    alpha,
    beta,
    d,
    equations,
    f,
    k,
    kappa,
    omega_1,
    omega_2,
    omega_3,
    same,
    t,
    theta,
    w,
    x,
    y,
    z,
)

from mmsgen.errors import MmsgenError
from mmsgen.expansion import Expansion
from mmsgen.scaling import ScaledSystem
from mmsgen.series import HarmonicRing
from mmsgen.solver import Solver

COORDINATES = (x, y, z, w)
NATURAL = (omega_1, omega_2, omega_3, sp.Symbol("omega_4", positive=True))
EXCITATION = (Omega, Omega_2)
STRENGTHS = (alpha, beta, kappa, f)
JOINTS = {"stiffness": (0, 1), "gyroscopic": (1, -1), "inertia": (2, 1)}
"""What couples the first two coordinates at leading order: derivative and sign on the way back."""


@st.composite
def systems(draw: st.DrawFn) -> tuple[ScaledSystem, int, dict[sp.Expr, sp.Expr]]:
    """Two to four coordinates, sparse polynomial terms in all derivatives, one or two excitations.

    The leading order may couple two of them, by stiffness, inertia or gyroscopic terms.
    Coordinates may share a frequency. With an amplitude of order 1, the quadratic terms are of
    order 1 by themselves and forcing has to be of order 2.
    """
    size = draw(st.integers(2, 4))
    weight = draw(st.sampled_from([0, 0, 1]))
    order = draw(st.sampled_from([1, 1, 2, 2, 3])) if size == 2 else draw(st.sampled_from([1, 2]))
    joint = draw(st.sampled_from([None, None, *JOINTS]))
    order = order if joint is None else min(order, 2)
    q = COORDINATES[:size]
    natural = [draw(st.sampled_from(NATURAL[: j + 1])) for j in range(size)]
    drives = EXCITATION[: draw(st.integers(1, 2))]
    variables = [v.diff(t, n) if n else v for n in range(3) for v in q]
    left = [v.diff(t, 2) + n**2 * v for v, n in zip(q, natural, strict=True)]
    if joint is not None:
        derivative, sign = JOINTS[joint]
        left[0] += k * (q[1].diff(t, derivative) if derivative else q[1])
        left[1] += sign * k * (q[0].diff(t, derivative) if derivative else q[0])
    for _ in range(draw(st.integers(1, 4 if order < 3 else 2))):
        j = draw(st.integers(0, size - 1))
        term = draw(st.sampled_from(STRENGTHS)) * sp.Rational(draw(st.integers(1, 5)), 2)
        term *= sp.Integer(-1) ** draw(st.integers(0, 1))
        degree = draw(st.integers(0, 3 if order < 3 else 2))
        for _ in range(degree):
            term *= draw(st.sampled_from(variables))
        if degree == 0 or draw(st.booleans()):
            angle = draw(st.integers(1, 2)) * draw(st.sampled_from(drives)) * t
            angle += draw(st.sampled_from([0, 0, sp.pi / 3, 2 * sp.pi / 5, theta]))
            term *= sp.cos(angle)
        left[j] += term
    eom = equations(left, q)
    known = {p.symbol for p in eom.parameters}
    orders = {s: 1 + weight for s in STRENGTHS if s in known}
    scaled = eom.scale(orders, amplitude=weight)
    symbols = list(scaled.frequencies)
    relations: dict[sp.Expr, sp.Expr] = {}
    table = list(scaled.resonances(order).coupled)
    for _ in range(draw(st.sampled_from([0, 1, 1, 2, 3])) if table else 0):
        relation = draw(st.sampled_from(table)).relation
        form = relation.lhs - relation.rhs
        pivots = [s for s in symbols if s in form.free_symbols and s not in relations]
        if pivots:
            pivot = draw(st.sampled_from(pivots))
            c = form.coeff(pivot)
            relations[pivot] = sp.expand(pivot - form / c)
    return scaled, order, relations


def expansion(case: tuple) -> Expansion | None:
    """The expansion of a random case; None where the engine says why there is none."""
    scaled, order, relations = case
    try:
        return scaled.expand(order, relations)
    except MmsgenError as refusal:
        assert len(str(refusal)) > 30
        return None


@settings(suppress_health_check=list(HealthCheck))
@given(systems())
def test_the_residual_vanishes(case: tuple) -> None:
    result = expansion(case)
    if result is not None:
        assert all(r == 0 for r in result.residual().values())


def resonant(order: int = 2) -> Expansion:
    """A case in which everything occurs: two relations, damping, nonlinear and parametric terms."""
    left = [
        d(x, 2) + omega_1**2 * x + alpha * x * y + beta * d(x) * d(y, 2) - f * sp.cos(Omega * t),
        d(y, 2) + omega_2**2 * y + alpha * x**2 + kappa * sp.cos(Omega * t + theta) * x * y,
    ]
    scaled = equations(left, (x, y)).scale({f: 1, alpha: 1, beta: 1, kappa: 1})
    return scaled.expand(order, {Omega: omega_1, omega_2: 2 * omega_1})


def test_a_rich_case() -> None:
    case = resonant(3)
    assert all(e != 0 for p in (1, 2, 3) for e in case.solvability[p].values())
    assert all(r == 0 for r in case.residual().values())


Breakage = Callable[[pytest.MonkeyPatch], None]


def wrong_half(patch: pytest.MonkeyPatch) -> None:
    """D_p a_j twice too large."""
    right = Solver._over_frequency
    patch.setattr(Solver, "_over_frequency", lambda s, j: right(s, j).scale(2))


def wrong_sign(patch: pytest.MonkeyPatch) -> None:
    """Particular solutions with the opposite sign."""
    right = Solver._divisor
    patch.setattr(Solver, "_divisor", lambda s, j, form: -right(s, j, form))


def wrong_divisor(patch: pytest.MonkeyPatch) -> None:
    """Particular solutions with the divisors of the other coordinate."""
    right = Solver._divisor

    def other(solver: Solver, j: int, form: tuple) -> object:
        return right(solver, (j + 1) % solver.n, form)

    patch.setattr(Solver, "_divisor", other)


def wrong_kinematics(patch: pytest.MonkeyPatch) -> None:
    """Derivatives of the amplitudes of other coordinates left out: 2 D0 D1 q_1 incomplete."""
    right = HarmonicRing.derivation

    def first_only(ring: HarmonicRing, f_: dict, images: list, rates: dict) -> object:
        return right(ring, f_, [images[0], *({} for _ in images[1:])], rates)

    def kinematics(solver: Solver, j: int, p: int) -> object:
        with pytest.MonkeyPatch.context() as inner:
            inner.setattr(HarmonicRing, "derivation", first_only)
            return known(solver, j, p)

    known = Solver.known_kinematics
    patch.setattr(Solver, "known_kinematics", kinematics)


def forgotten_force(patch: pytest.MonkeyPatch) -> None:
    """One term of the forces left out."""
    right = Solver._force_terms
    patch.setattr(Solver, "_force_terms", lambda s, j, p: list(right(s, j, p))[1:])


def forgotten_detuning(patch: pytest.MonkeyPatch) -> None:
    """D1 z = iσz left out in the recursion."""
    right = Solver._derivation

    def still(solver: Solver, f_: dict, p: int, images: list) -> object:
        return solver.ring.derivation(f_, images, {})

    assert right is not still
    patch.setattr(Solver, "_derivation", still)


@pytest.mark.parametrize(
    ("breakage", "first"),
    [
        (wrong_half, 1),
        (wrong_sign, 2),
        (wrong_divisor, 2),
        (wrong_kinematics, 2),
        (forgotten_force, 1),
        (forgotten_detuning, 2),
    ],
    ids=lambda v: getattr(v, "__name__", v),
)
def test_a_broken_solver_leaves_a_residual(
    breakage: Breakage, first: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The residual is no tautology: each of these errors shows, at the order where it enters."""
    case = resonant(2)
    breakage(monkeypatch)
    e = sp.Symbol("epsilon", positive=True)
    broken = case.residual()
    assert any(r != 0 for r in broken.values())
    present = {p for r, p in product(broken.values(), range(3)) if sp.expand(r).coeff(e, p) != 0}
    assert min(present) <= first


def test_expansions_of_a_sum_of_systems() -> None:
    """Two systems that do not touch: the expansion of both is the two expansions."""
    left = [
        d(x, 2) + omega_1**2 * x + alpha * x**3 + beta * d(x),
        d(y, 2) + omega_2**2 * y + kappa * y**2 + f * sp.cos(Omega * t) * y,
    ]
    orders = {alpha: 1, beta: 1, kappa: 1, f: 1}
    both = equations(left, (x, y)).scale(orders).expand(2, {Omega: 2 * omega_2})
    alone_x = equations(left[:1], (x,)).scale({alpha: 1, beta: 1}).expand(2)
    alone_y = equations(left[1:], (y,)).scale({kappa: 1, f: 1}).expand(2, {Omega: 2 * omega_2})
    for p in (1, 2):
        merged = {**alone_x.solvability[p], **alone_y.solvability[p]}
        assert all(same(both.solvability[p][a], e) for a, e in merged.items())
