"""Sums over divisors: exactly the coefficient, and never longer."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mmsgen.field import Coefficient, ParameterField
from mmsgen.partial_fractions import partial_fractions

NAMES = ["a", "b", "x", "y"]
DIVISORS = [
    {"x": 1},
    {"x": 1, "y": 1},
    {"x": 1, "y": -1},
    {"x": 2, "y": 1},
    {"x": 1, "a": 3},
    {"y": 1},
    {"y": 1, "b": -2},
]
small = st.integers(-3, 3)
monomials = st.tuples(*[st.integers(0, 2)] * len(NAMES))
sums = st.dictionaries(monomials, small.filter(bool), min_size=1, max_size=4)
chosen = st.lists(st.sampled_from(range(len(DIVISORS))), max_size=4)


def field() -> ParameterField:
    return ParameterField(NAMES, 4)


def polynomial(f: ParameterField, terms: dict[tuple[int, ...], int]) -> Coefficient:
    total = f.zero
    for exponents, c in terms.items():
        term = f.one.scale(Fraction(c))
        for name, e in zip(NAMES, exponents, strict=True):
            for _ in range(e):
                term = term * f.polynomial(f.gens[name])
        total = total + term
    return total


def over(f: ParameterField, c: Coefficient, divisors: list[int]) -> Coefficient:
    for k in divisors:
        form = {name: Fraction(v) for name, v in DIVISORS[k].items()}
        c = c * f.reciprocal(f.linear(form))
    return c


def size(terms: tuple[Coefficient, ...]) -> int:
    return sum(len(p) for t in terms for p in t.num.values())


@given(sums, sums, chosen)
def test_adds_up_and_is_never_longer(
    real: dict[tuple[int, ...], int], imaginary: dict[tuple[int, ...], int], divisors: list[int]
) -> None:
    f = field()
    c = over(f, polynomial(f, real) + polynomial(f, imaginary).times_i(), divisors)
    terms = partial_fractions(c)
    assert not f.sum((c, *(-t for t in terms)))
    assert size(terms) <= size((c,))
    assert all(terms) or not c


@given(st.lists(small.filter(bool), min_size=2, max_size=4), st.permutations(range(4)))
def test_a_sum_of_residues_is_found_again(residues: list[int], order: list[int]) -> None:
    """Several divisors in x multiplied out are longer than one number over each of them."""
    f = field()
    parts = [over(f, f.one.scale(Fraction(r)), [k]) for r, k in zip(residues, order, strict=False)]
    c = f.sum(parts)
    terms = partial_fractions(c)
    assert not f.sum((c, *(-t for t in terms)))
    assert size(terms) <= min(size((c,)), max(size(tuple(parts)), 1))


def test_by_hand() -> None:
    """(a(x − y) + b(x + y))/((x + y)(x − y)) = a/(x + y) + b/(x − y), two monomials, not four."""
    f = field()
    a, b = (f.polynomial(f.gens[n]) for n in "ab")
    parts = [over(f, a, [1]), over(f, b, [2])]
    terms = partial_fractions(f.sum(parts))
    assert len(terms) == 2
    assert all(any(not t - p for p in parts) for t in terms)


@pytest.mark.parametrize("divisors", [[], [0], [1, 1], [0, 0, 2]])
def test_left_alone_where_there_is_nothing_to_split(divisors: list[int]) -> None:
    f = field()
    c = over(f, f.one, divisors)
    assert partial_fractions(c) == (c,)


def test_zero() -> None:
    f = field()
    assert not f.sum(partial_fractions(f.zero))
