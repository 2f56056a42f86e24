"""Sums of terms: trigonometric reduction, vanishing phases and fractions, all exact."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from sympy.physics.mechanics import dynamicsymbols

from mmsgen.terms import assemble, collect, expanded, ratio, same

t = dynamicsymbols._t
u, v = sp.symbols("u v", real=True)
a, b, k = sp.symbols("a b k", positive=True)
q = dynamicsymbols("q")

angles = st.builds(
    lambda i, j, n: i * u + j * v + n * sp.pi / 14,
    st.integers(-2, 2),
    st.integers(-2, 2),
    st.integers(-14, 14),
)
factors = st.tuples(st.sampled_from([sp.sin, sp.cos]), angles, st.integers(1, 2))
products = st.lists(factors, min_size=1, max_size=2)


def by_euler(expr: sp.Expr) -> sp.Poly:
    """The independent algebra: Laurent polynomials in e^{iu}, e^{iv} and s = e^{iπ/14}.

    Exact, and without any addition theorem: s is reduced modulo its minimal polynomial.
    """
    x, y, s = sp.symbols("x y s")

    def exponential(function: sp.Expr) -> sp.Expr:
        angle = sp.expand(function.args[0])
        n = angle.subs({u: 0, v: 0}) * 14 / sp.pi
        e = x ** angle.coeff(u) * y ** angle.coeff(v)
        forward, backward = e * s ** (n % 28), s ** (-n % 28) / e
        if isinstance(function, sp.cos):
            return (forward + backward) / 2
        return (forward - backward) * s**21 / 2  # 1/i = i³, i = s⁷

    polynomial = expr.replace(lambda f: isinstance(f, sp.sin | sp.cos), exponential)
    raised = sp.Poly(sp.expand(polynomial * x**12 * y**12), s, x, y, a)
    return raised.rem(sp.Poly(sp.cyclotomic_poly(28, s), s, x, y, a))


@given(products)
def test_products_of_sines_and_cosines(product: list) -> None:
    expr = (1 + a) * sp.Mul(*(f(angle) ** power for f, angle, power in product))
    result = expanded(expr)
    assert by_euler(expr - result).is_zero
    for term in sp.Add.make_args(result):
        functions = [f for f in sp.Mul.make_args(term) if f.has(sp.sin, sp.cos)]
        assert len(functions) < 2
        assert not any(f.is_Pow for f in functions)


def test_pythagoras_holds_by_itself() -> None:
    x, y = a * sp.cos(u) + b * sp.cos(u + v), a * sp.sin(u) + b * sp.sin(u + v)
    assert expanded(x**2 + y**2) == a**2 + b**2 + 2 * a * b * sp.cos(v)
    assert expanded(sp.sin(u) ** 2 + sp.cos(u) ** 2) == 1
    assert expanded(sp.cos((a + b) * t)) == sp.cos(a * t + b * t)


@pytest.mark.parametrize("N", range(2, 14))
def test_equally_spaced_phases_cancel(N: int) -> None:
    terms = [k * sp.cos(a * t + 2 * sp.pi * j / N + v) for j in range(N)]
    assert expanded(sp.Add(*terms)) == 0
    assert expanded(sp.Add(*terms[1:])) != 0
    assert expanded(sp.Add(*terms) + k * terms[0]) == k * terms[0]
    sines = [sp.sin(-a * t + 2 * sp.pi * j / N) for j in range(N)]
    assert expanded(sp.Add(*sines)) == 0
    # of u − v SymPy prefers now one sign, now the other, depending on the phase
    shifted = [sp.sin(u - v + sp.pi / 9 - 2 * sp.pi * j / N) for j in range(N)]
    assert expanded(sp.Add(*shifted)) == 0


@given(
    st.lists(
        st.tuples(st.integers(-5, 5).filter(bool), st.integers(-12, 11)), min_size=3, max_size=8
    )
)
def test_vanishing_is_decided_exactly(members: list[tuple[int, int]]) -> None:
    expr = sp.Add(*(c * sp.cos(u - v + sp.pi * sp.Rational(n, 12)) for c, n in members))
    with mpmath.workdps(50):
        value = abs(mpmath.fsum(c * mpmath.expjpi(mpmath.mpf(n) / 12) for c, n in members))
    # an algebraic integer of degree φ(24) = 8 whose conjugates are at most 40: its norm is at
    # least 1, so it is zero or larger than 40⁻⁷ ≈ 6e-12
    assert (expanded(expr) == 0) == (value < 1e-12)


def test_collect_separates_parameters_from_functions_of_time() -> None:
    expr = (a + b) * q.diff(t) * sp.cos(k * t) ** 2 + sp.sin(k) * q + a
    terms = collect(expr, t)
    assert terms == {
        sp.S.One: a,
        q: sp.sin(k),
        q.diff(t): a / 2 + b / 2,
        q.diff(t) * sp.cos(2 * k * t): a / 2 + b / 2,
    }
    assert expanded(assemble(terms) - expr) == 0


def test_ratio_brings_to_lowest_terms() -> None:
    assert ratio((a**2 - b**2) / (a * k - b * k)) == (a + b) / k
    assert ratio(sp.sqrt(a**2 - b**2 + b * (b + k) - b * k)) == a
    assert ratio(sp.sqrt((a**2 + 2 * a * b + b**2) / k**2)) == (a + b) / k
    assert same(1 / (a - b) - 1 / (a + b), 2 * b / (a**2 - b**2))
    assert not same(1 / (a - b), 1 / (a + b))
