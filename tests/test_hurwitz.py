"""Inequalities for the place of roots, against roots, published conditions and whole rotors."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from mmsgen.field import Coefficient, ParameterField, sign
from mmsgen.hurwitz import damped_conditions, halves, neutral_conditions

FIELD = ParameterField(("a", "b", "c", "d", "p", "q"))
INTEGERS = st.integers(-6, 6)


def gaussian(x: int, y: int = 0) -> Coefficient:
    one = FIELD.rational(Fraction(x))
    return one + FIELD.rational(Fraction(y)).times_i()


def signs(conditions: tuple[Coefficient, ...]) -> list[int | None]:
    return [sign(c, frozenset()) if c.num else 0 for c in conditions]


def monic(roots: list[tuple[int, int]]) -> tuple[list[Coefficient], np.ndarray]:
    """The polynomial with these roots, exactly and in doubles."""
    exact, rough = [FIELD.one], np.array([1.0 + 0j])
    for x, y in roots:
        shifted = [FIELD.zero, *exact]
        exact = [s - gaussian(x, y) * e for s, e in zip(shifted, [*exact, FIELD.zero], strict=True)]
        rough = np.polymul(rough, [1.0, -(x + 1j * y)])
    return exact, rough


@given(st.lists(st.tuples(INTEGERS, INTEGERS), min_size=1, max_size=5))
def test_complex_polynomials_of_given_roots(roots: list[tuple[int, int]]) -> None:
    exact, _ = monic(roots)
    found = signs(damped_conditions(exact))
    damped = all(x < 0 for x, _ in roots)
    assert all(s == 1 for s in found) is damped
    if all(not (c - c.conjugate()) for c in exact):
        return
    # The last of the nested minors vanishes where a root, or its mirror image, meets another.
    meeting = any((x, y) == (-v, w) for x, y in roots for v, w in roots)
    assert (found[-1] == 0) is meeting


@given(st.lists(st.integers(-9, 9), min_size=1, max_size=6))
def test_real_polynomials(lower: list[int]) -> None:
    roots = np.roots([1, *lower])
    # Companion eigenvalues of such polynomials are good to 1e-3 even where six of them meet.
    assume(np.abs(roots.real).min() > 1e-2)
    exact = [gaussian(x) for x in reversed(lower)] + [FIELD.one]
    found = signs(damped_conditions(exact))
    assert all(s == 1 for s in found) is bool((roots.real < 0).all())
    # Half of the determinants and half of the coefficients.
    n = len(lower)
    assert len(found) == n // 2 + (n + 1) // 2


@given(st.lists(st.integers(-9, 9), min_size=3, max_size=5))
def test_conservative_polynomials(lower: list[int]) -> None:
    roots = np.roots([1, *lower])
    gaps = np.abs(roots[:, None] - roots) + 10 * np.eye(len(roots))
    assume(gaps.min() > 1e-2)
    n = len(lower)
    turned = [gaussian(x).times_i(n - k) for k, x in enumerate(reversed(lower))] + [FIELD.one]
    _, v = halves(turned)
    assert not any(v)
    found = signs(neutral_conditions(turned))
    assert all(s == 1 for s in found) is bool((np.abs(roots.imag) < 1e-6).all())
    assert len(found) == (1 if n == 3 else n - 1)


def test_routh_hurwitz_of_a_cubic_and_a_quartic() -> None:
    a, b, c, d = (FIELD.generator(n) for n in "abcd")
    # Γ³ + aΓ² + bΓ + c: c > 0, b > 0 and ab − c > 0 (Routh 1877).
    assert damped_conditions((c, b, a, FIELD.one)) == (c, a, a * b - c)
    # Γ⁴ + aΓ³ + bΓ² + cΓ + d: d > 0, b > 0, a > 0, abc − c² − a²d > 0.
    found = damped_conditions((d, c, b, a, FIELD.one))
    assert found == (d, b, a, a * b * c - c * c - a * a * d)


def test_bilharz_of_a_complex_quadratic() -> None:
    """The conditions of section `criteria`: b_r > 0 and b_r² c_r + b_r b_i c_i − c_i² > 0."""
    br, bi, cr, ci = (FIELD.generator(n) for n in "abcd")
    found = damped_conditions((cr + ci.times_i(), br + bi.times_i(), FIELD.one))
    assert found == (br, br * br * cr + br * bi * ci - ci * ci)


def test_discriminant_of_a_cubic() -> None:
    p, q = FIELD.generator("p"), FIELD.generator("q")
    # Λ³ + pΛ + q with Γ = iΛ: −4p³ − 27q² > 0, up to a positive factor.
    (found,) = neutral_conditions((q.times_i(3), p.times_i(2), FIELD.zero, FIELD.one))
    other = -(p * p * p).scale(Fraction(4)) - (q * q).scale(Fraction(27))
    assert found == other


@pytest.mark.parametrize("n", [3, 4])
def test_real_polynomials_obey_the_complex_conditions_as_well(n: int) -> None:
    """Liénard and Chipart, and Hermite: two forms of one truth, at points on both sides."""
    from mmsgen.hurwitz import _bezoutian, _minors

    rng = np.random.default_rng(n)
    both = set()
    for lower in rng.integers(-1, 7, size=(60, n)).tolist():
        exact = [gaussian(x) for x in lower] + [FIELD.one]
        u, v = halves(exact)
        hermite = all(s == 1 for s in signs(_minors(_bezoutian(v, u))))
        assert hermite is all(s == 1 for s in signs(damped_conditions(exact)))
        both.add(hermite)
    assert both == {True, False}
