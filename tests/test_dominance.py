"""Proofs that a polynomial is nowhere positive, against values of it."""

from __future__ import annotations

import itertools
from fractions import Fraction

import pytest
from flint import fmpq

from mmsgen.dominance import Domain, never_positive
from mmsgen.field import Coefficient, ParameterField

FIELD = ParameterField(("a", "b", "g", "n", "w", "v", "p", "s"))
a, b, g, n, w, v, p, s = (FIELD.generator(name) for name in FIELD.names)
DOMAIN = Domain(frozenset("wv"), frozenset("abwv"), frozenset("n"))
WEIGHTS = {"a": 1, "b": 1, "g": 1, "n": 1, "s": 1}

PROVED = {
    "all terms": (-a * b, FIELD.zero, -a),
    "a square": (-(a * a), a.scale(2), -FIELD.one),
    "negative generators": (a * n, FIELD.zero, n),
    "corrections of any sign": (-a * b + a * b * g, a * b * g, -FIELD.one + g, a),
    "centre off zero": (-a * b - b**4, (b * b).scale(2), -FIELD.one),
    "shapes of modes": (-a * b * p * p + a * b * b * p**3, FIELD.zero, -FIELD.one),
    "constant": (-a * b + a * b * b,),
    "zero": (FIELD.zero,),
}
OPEN = {
    "a coupling of higher order": (-(a * a) + b**4, FIELD.zero, -FIELD.one),
    "another ratio": (-(a * a) + a * b, FIELD.zero, -FIELD.one),
    "a real generator": (-(a * g), FIELD.zero, -FIELD.one),
    "frequencies": (-(a * a) * (w - v), FIELD.zero, -FIELD.one),
    "a square that vanishes": (-((a - b) ** 2) + a**3, FIELD.zero, -FIELD.one),
    "frequencies that cancel": (-((w - v) ** 2) * a * a + a**3, FIELD.zero, -FIELD.one),
    "far from resonance": (-a, FIELD.zero, b),
    "a shape that vanishes": (-a * b * p * p + a * b * b * p, FIELD.zero, -FIELD.one),
    "positive": (a, FIELD.zero, -FIELD.one),
    "odd": (-a, FIELD.one, FIELD.zero, -FIELD.one),
}


def value(c: Coefficient, numbers: dict[str, Fraction]) -> Fraction:
    if not c.num:
        return Fraction(0)
    arguments = [fmpq(x.numerator, x.denominator) for x in numbers.values()]
    q = c.num[0](*arguments)
    return Fraction(int(q.p), int(q.q))


def largest(criterion: tuple[Coefficient, ...]) -> Fraction:
    """The largest value over small quantities of very different ratios, zero included."""
    small = [Fraction(0), Fraction(1, 10**6), Fraction(1, 10**3), Fraction(1, 50)]
    best = Fraction(-1)
    for x, y, z, detuning in itertools.product(small, small, small, [-1, 0, 1]):
        for width in small[1:]:
            for speed in (Fraction(2), Fraction(3)):
                point = (x, y, z, -x - 1, speed, Fraction(3), y - z, Fraction(0))
                numbers = dict(zip(FIELD.names, point, strict=True))
                at = detuning * width
                parts = (value(c, numbers) * at**k for k, c in enumerate(criterion))
                best = max(best, sum(parts, Fraction(0)))
    return best


@pytest.mark.parametrize("name", PROVED)
def test_what_is_proved_holds(name: str) -> None:
    assert never_positive(PROVED[name], "s", WEIGHTS, 3, DOMAIN)
    assert largest(PROVED[name]) <= 0


@pytest.mark.parametrize("name", OPEN)
def test_what_may_be_positive_is_not_proved(name: str) -> None:
    assert not never_positive(OPEN[name], "s", WEIGHTS, 3, DOMAIN)


@pytest.mark.parametrize("name", ["a coupling of higher order", "another ratio", "positive"])
def test_some_of_them_are_positive(name: str) -> None:
    assert largest(OPEN[name]) > 0
