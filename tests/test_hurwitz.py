"""Inequalities for the place of roots, against roots, published conditions and whole rotors."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from systems import Omega, alpha, d, kappa, omega_1, omega_2, pair, t, x, y

from mmsgen import criteria as criteria_module
from mmsgen.codegen import case_name, render
from mmsgen.field import Coefficient, ParameterField, sign
from mmsgen.hurwitz import (
    _bezoutian,
    _minors,
    damped_conditions,
    halves,
    neutral_conditions,
)
from mmsgen.loading import load_files
from mmsgen.slowflow import SlowFlow

FIELD = ParameterField(("a", "b", "c", "d", "p", "q"))
INTEGERS = st.integers(-6, 6)


def gaussian(x: int, y: int = 0) -> Coefficient:
    one = FIELD.rational(Fraction(x))
    return one + FIELD.rational(Fraction(y)).times_i()


def signs(conditions: tuple[Coefficient, ...]) -> list[int | None]:
    return [sign(c, frozenset()) if c.num else 0 for c in conditions]


def monic(roots: list[tuple[int, int]]) -> list[Coefficient]:
    """The polynomial with these roots."""
    exact = [FIELD.one]
    for root in roots:
        longer = zip([FIELD.zero, *exact], [*exact, FIELD.zero], strict=True)
        exact = [high - gaussian(*root) * low for high, low in longer]
    return exact


@given(st.lists(st.tuples(INTEGERS, INTEGERS), min_size=1, max_size=5))
def test_complex_polynomials_of_given_roots(roots: list[tuple[int, int]]) -> None:
    exact = monic(roots)
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
    even = n == 4 and lower[0] == lower[2] == 0
    assert len(found) == (1 if n == 3 else 3 if even else n - 1)


@given(st.lists(st.integers(-9, 9), min_size=2, max_size=3))
def test_even_polynomials(lower: list[int]) -> None:
    """R(Γ²) has imaginary roots alone where those of R are negative."""
    roots = np.roots([1, *lower])
    gaps = np.abs(roots[:, None] - roots) + 10 * np.eye(len(roots))
    assume(gaps.min() > 1e-2 and np.abs(roots).min() > 1e-2)
    exact = [gaussian(x) for x in reversed(lower)] + [FIELD.one]
    full = [c for pair in zip(exact, [FIELD.zero] * 4, strict=False) for c in pair][:-1]
    neutral = bool(((np.abs(roots.imag) < 1e-6) & (roots.real < 0)).all())
    found = neutral_conditions(full)
    assert all(s == 1 for s in signs(found)) is neutral
    # Of half the degree each: the coefficients, and the discriminant.
    assert len(found) == len(lower) + 1


def test_conditions_of_an_even_quartic() -> None:
    b, c = FIELD.generator("b"), FIELD.generator("c")
    none = FIELD.zero
    assert neutral_conditions((c, none, b, none, FIELD.one)) == (c, b, b * b - c.scale(4))


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
    rng = np.random.default_rng(n)
    both = set()
    for lower in rng.integers(-1, 7, size=(60, n)).tolist():
        exact = [gaussian(x) for x in lower] + [FIELD.one]
        u, v = halves(exact)
        hermite = all(s == 1 for s in signs(_minors(_bezoutian(v, u))))
        assert hermite is all(s == 1 for s in signs(damped_conditions(exact)))
        both.add(hermite)
    assert both == {True, False}


# --- slow flows -----------------------------------------------------------------------------------


def flow_of(name: str) -> SlowFlow:
    """Two oscillators of nearly the same frequency, coupled, pumped, with dampers."""
    m1, m2 = sp.symbols("mu_1 mu_2", nonnegative=True)
    coupled = kappa * y, kappa * x
    pumped = 2 * alpha * sp.cos(Omega * t) * x
    first = coupled[0] + 2 * m1 * d(x) + (pumped if name != "whirl" else 0)
    second = coupled[1] + 2 * m2 * d(y)
    if name == "undamped":
        first, second = first.subs(m1, 0), second.subs(m2, 0)
    if name == "one damper":
        second = second.subs(m2, 0)
    small = {alpha: 1, kappa: 1, m1: 1, m2: 1}
    eom = pair(first, second)
    known = {p.symbol for p in eom.parameters}
    scaled = eom.scale({s: o for s, o in small.items() if s in known})
    w1, w2 = sp.symbols("omega_1 omega_2", positive=True)
    return scaled.expand(1, {Omega: 2 * w1, w2: w1}).slow_flow


@pytest.mark.parametrize("name", ["undamped", "one damper", "damped"])
def test_zones_of_a_quartic_are_where_the_growth_rate_is_positive(name: str) -> None:
    flow = flow_of(name)
    (verdict,) = flow.stability.verdicts
    assert verdict.factor.degree == 4
    assert verdict.kind == ("conservative" if name == "undamped" else "dissipative")
    assert verdict.criteria is not None
    # A real polynomial: half of the determinants, and of the coefficients.
    rng = np.random.default_rng(2)
    sigma = np.linspace(-1.5, 1.5, 3001)
    widths = []
    for _ in range(12):
        values = {
            "omega_1": 2.0,
            "alpha": rng.uniform(0.2, 1.0),
            "kappa": rng.uniform(0.0, 1.0),
            "mu_1": rng.choice([0.0, 0.02, 0.1]),
            "mu_2": rng.choice([0.0, 0.05]),
            "sigma_2": rng.uniform(-0.3, 0.3),
        }
        values = {n: v for n, v in values.items() if n in {p.name for p in flow.case.parameters}}
        zones = flow.zones(values)
        growth = flow.growth_rate({**values, "sigma_1": sigma})
        inside = ((zones[:, :1] < sigma) & (sigma < zones[:, 1:])).any(axis=0)
        # Eigenvalues on the axis, and double ones, are good to the root of 1e-16 times their size.
        assert np.array_equal(growth > 1e-7, inside), values
        widths.append(inside.sum())
    assert max(widths) > 0 and min(widths) < len(sigma)


def test_the_same_edges_in_the_emitted_module() -> None:
    flow = flow_of("one damper")
    files = render(flow.case, model="quartic")
    (module,) = load_files(files, [case_name(flow.case)]).values()
    values = {"omega_1": 2.0, "alpha": 0.6, "kappa": 0.4, "mu_1": 0.05, "sigma_2": 0.1}
    ours, emitted = flow.boundaries(values), module.boundaries(**values)
    # Roots of polynomials of degree eight, whose coefficients are off by some units.
    assert ours == pytest.approx(emitted, rel=1e-10)
    step = 1e-6 * (ours[1] - ours[0])
    for edge, inward in zip(ours, (step, -step), strict=True):
        assert module.growth_rate(**values, sigma_1=edge + inward) > 0
        assert module.growth_rate(**values, sigma_1=edge - inward) < 1e-9


def test_long_factors_are_left_alone() -> None:
    """Determinants of a factor of many terms fill pages: numbers alone tell there."""
    flow = flow_of("damped")
    criteria_module.LONGEST, before = 5, criteria_module.LONGEST
    try:
        verdicts = flow_of("damped").stability.verdicts
    finally:
        criteria_module.LONGEST = before
    assert [v.kind for v in verdicts] == ["unjudged"]
    assert "no closed-form criterion" in verdicts[0].reason
    assert flow.stability.verdicts[0].kind == "dissipative"


def test_zones_of_two_coincident_parametric_resonances() -> None:
    """A biquadratic factor whose coefficient of Γ² changes its sign inside of zones.

    Inside of every edge the modes grow, outside of it they do not: eigenvalues of the slow flow.
    """
    f = dict(zip(("11", "12", "21", "22"), sp.symbols("f_11 f_12 f_21 f_22", real=True)))
    drive = 2 * sp.cos(Omega * t)
    eom = pair(drive * (f["11"] * x + f["12"] * y), drive * (f["21"] * x + f["22"] * y))
    scaled = eom.scale(dict.fromkeys(f.values(), 1))
    flow = scaled.expand(1, {Omega: 2 * omega_1, omega_2: 3 * omega_1}).slow_flow
    rng = np.random.default_rng(5)
    base = dict(zip(("f_11", "f_12", "f_21"), rng.normal(scale=0.3, size=(3, 200)), strict=True))
    base |= {"omega_1": rng.uniform(0.5, 2.0, 200), "sigma_2": rng.normal(scale=0.1, size=200)}
    edges = flow.boundaries(base)
    known = np.isfinite(edges).all(axis=-1)
    assert known.sum() > 150
    width = np.where(known, edges[:, 1] - edges[:, 0], 1.0)
    # Across 1e-7 of a zone growth rises to 3e-4 of it; eigenvalues that meet are rounded to 1e-8.
    for edge, inwards in ((edges[:, 0], 1e-7 * width), (edges[:, 1], -1e-7 * width)):
        start = np.where(known, edge, 0.0)
        out, inside = (flow.growth_rate({**base, "sigma_1": start + s * inwards}) for s in (-1, 1))
        assert (out[known] <= 1e-7 * width[known]).all()
        assert (inside[known] > 1e-5 * width[known]).all()
