"""Series of the edges, against roots in high precision and by hand."""

from __future__ import annotations

import itertools
from fractions import Fraction

import mpmath
import pytest
from flint import fmpq

from mmsgen.edges import EdgeSeries, edge_series, weighted_parts
from mmsgen.field import Coefficient, ParameterField

WEIGHTS = {"a": 1, "b": 1, "s": 1}


def field() -> ParameterField:
    return ParameterField(("a", "b", "w", "s"))


def value(c: Coefficient, numbers: dict[str, Fraction]) -> mpmath.mpf:
    """A real coefficient at rational numbers."""
    arguments = [fmpq(numbers[n].numerator, numbers[n].denominator) for n in c.field.names]
    if not c.num:
        return mpmath.mpf(0)
    total = c.num[0](*arguments)
    for m, e in c.den.items():
        total /= c.field.divisors[m](*arguments) ** e
    return mpmath.mpf(int(total.p)) / int(total.q)


def edges_at(series: EdgeSeries, numbers: dict[str, Fraction]) -> tuple[mpmath.mpf, mpmath.mpf]:
    """Lower and upper edge."""
    root = mpmath.sqrt(value(series.radicand, numbers))
    centre = mpmath.fsum(value(c, numbers) for c in series.rational)
    half = mpmath.fsum(value(c, numbers) * root for c in series.radical)
    return centre - half, centre + half


def criteria() -> dict[str, tuple[Coefficient, ...]]:
    """Polynomials in the detuning s with the small a, b and the frequency w."""
    f = field()
    a, b, w = (f.generator(n) for n in "abw")
    over_w = w.inverse()
    two, three = f.rational(2), f.rational(3)
    tangle = a * b * over_w + a * a * three * over_w * over_w
    return {
        "symmetric": (a * b, f.zero, -f.one),
        "shifted": (a * a * two - b * b, a + b, -f.one),
        "higher orders": (
            a * b + a * a * b * over_w + tangle * a * b * over_w,
            a * over_w * b - b * b * over_w,
            -f.one + a * over_w,
            -over_w * three + a * over_w * over_w,
            over_w * over_w * two,
        ),
        "with frequencies": (
            a * b * (w + f.one) + a * b * b,
            (a - b) * two,
            -w * w - f.one + b * b,
            over_w,
        ),
        "double root": (
            a**4 * over_w * over_w - (a * a * over_w - b * b) ** 2 + a**5,
            (a * a * over_w - b * b) * two,
            -f.one,
            over_w * a,
        ),
        "double root off zero": (
            -a * a + a**4,
            a * two + a * a * a,
            -f.one + a * a,
        ),
        "third order zone": (a**6 - (a * a * over_w) ** 2, a * a * over_w * two, -f.one),
    }


@pytest.mark.parametrize("order", [1, 2, 3, 4])
@pytest.mark.parametrize("name", criteria())
def test_the_error_has_the_order(name: str, order: int) -> None:
    """Through order N the error against the root in 60 digits falls like ε^{N+1}.

    From ε = 2^-10 on, the next term is 1e-3 of the first one left out: the exponent of two halvings
    lies within 0.02 above N + 0.98; it may be larger where a term happens to vanish.
    """
    mpmath.mp.dps = 60
    criterion = criteria()[name]
    series = edge_series(criterion, "s", WEIGHTS, order)
    late = {"double root": 2, "double root off zero": 2, "third order zone": 3}
    if order < late.get(name, 1):
        assert series is None
        return
    assert series is not None
    errors = []
    for halving in (10, 12):
        e = Fraction(1, 2**halving)
        numbers = {"a": e * Fraction(7, 5), "b": e * Fraction(4, 5), "w": Fraction(3, 2)}
        numbers["s"] = Fraction(0)
        polynomial = [value(c, numbers) for c in reversed(criterion)]
        while not polynomial[0]:
            polynomial.pop(0)
        roots = mpmath.polyroots(polynomial, maxsteps=500, extraprec=300)
        near = sorted((r.real for r in roots if abs(r.imag) < mpmath.mpf("1e-40")), key=abs)[:2]
        pairs = zip(edges_at(series, numbers), sorted(near), strict=True)
        errors.append([abs(edge - root) for edge, root in pairs])
    for coarse, fine in zip(*errors, strict=True):
        if coarse < mpmath.mpf("1e-45"):
            continue  # exact through this order
        assert mpmath.log(coarse / fine, 2) / 2 > order + mpmath.mpf("0.98")


@pytest.mark.parametrize("name", criteria())
def test_the_criterion_is_positive_between_the_edges(name: str) -> None:
    """The first half-width is positive, and E > 0 at the centre."""
    mpmath.mp.dps = 60
    criterion = criteria()[name]
    series = edge_series(criterion, "s", WEIGHTS, 4)
    assert series is not None
    e = Fraction(1, 2**12)
    numbers = {"a": e * Fraction(7, 5), "b": e * Fraction(4, 5), "w": Fraction(3, 2)}
    numbers["s"] = Fraction(0)
    low, high = edges_at(series, numbers)
    assert low < high

    def criterion_at(s: mpmath.mpf) -> mpmath.mpf:
        return mpmath.fsum(value(c, numbers) * s**k for k, c in enumerate(criterion))

    assert criterion_at((low + high) / 2) > 0
    width = high - low
    assert criterion_at(low - width / 4) < 0 and criterion_at(high + width / 4) < 0


def test_no_series() -> None:
    """Not quadratic to leading order, or edges that coincide."""
    f = field()
    a, b = f.generator("a"), f.generator("b")
    none = [
        (a,),
        (a, f.one),
        (a * b, f.zero, f.zero, f.one),
        (f.zero, f.zero, -f.one),
        (-(a * a), a.scale(2), -f.one),
        (f.zero, f.zero, f.zero, f.one),
        (f.zero,),
    ]
    for criterion in none:
        assert edge_series(criterion, "s", WEIGHTS, 4) is None


def test_terms_by_hand() -> None:
    """E = ab + a²b − (1 − a)s²: s = ±√(ab)(1 + a + …), as √((1 + a)/(1 − a)) says."""
    f = field()
    a, b = f.generator("a"), f.generator("b")
    series = edge_series((a * b + a * a * b, f.zero, a - f.one), "s", WEIGHTS, 3)
    assert series is not None
    assert series.radicand == (a * b).scale(4)
    assert not any(series.rational)
    # Halves, because √D = 2√(ab); the series of √((1+a)/(1−a)) is 1 + a + a²/2 + ….
    assert list(series.radical) == [
        f.rational(Fraction(1, 2)),
        a.scale(Fraction(1, 2)),
        (a * a).scale(Fraction(1, 4)),
    ]


def test_weights_of_monomials() -> None:
    f = field()
    a, b, w = (f.generator(n) for n in "abw")
    c = (a * b + a * a * a + w) * w.inverse()
    parts = weighted_parts(c, {"a": 1, "b": 2})
    assert parts == {0: f.one, 3: a * (b + a * a) * w.inverse()}
    assert f.sum(parts.values()) == c
    assert weighted_parts(f.zero, WEIGHTS) == {}
    assert all(p.field is f for p in parts.values())
    assert list(itertools.chain(parts)) == sorted(parts)
