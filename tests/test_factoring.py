"""Characteristic polynomials split exactly, against products made on purpose."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mmsgen.factoring import factor_monic
from mmsgen.field import Coefficient, ParameterField

Monic = tuple[Coefficient, ...]


def product(polynomials: Sequence[Monic]) -> Monic:
    """The product of polynomials, lowest power first."""
    field = polynomials[0][0].field
    result: list[Coefficient] = [field.one]
    for p in polynomials:
        longer = [field.zero] * (len(result) + len(p) - 1)
        for i, c in enumerate(result):
            for k, e in enumerate(p):
                longer[i + k] = longer[i + k] + c * e
        result = longer
    return tuple(result)


def expanded(factors: Sequence) -> Monic:
    return product([f.coefficients for f in factors for _ in range(f.multiplicity)])


def library(field: ParameterField) -> list[Monic]:
    """Irreducible factors of slow flows: turning modes, pairs, damped pairs, triples."""
    a, b, s, w = (field.generator(n) for n in "absw")
    i_s, one, two = s.times_i(), field.one, field.rational(2)
    over_w = w.inverse()
    return [
        (field.zero, one),
        (-i_s, one),
        (a * b * over_w, -i_s, one),
        (-(a * b), i_s * two, one),
        (s * s - a * a, field.zero, one),
        (a * over_w - b.times_i() * two, one),
        (a * b - (a * s).times_i(), a + b - i_s, one),
        ((a * a * b).times_i() * over_w, -(a * b), i_s, one),
        (-(w * w + a).times_i(), field.zero, field.zero, one),
    ]


@given(st.lists(st.integers(0, 8), min_size=1, max_size=4), st.sampled_from([4, 12, 20]))
def test_products_are_taken_apart(chosen: list[int], order: int) -> None:
    """The factors multiply to the polynomial exactly, are monic, and are as many as went in.

    Damped factors beside others need one change of variables p → i^x p that makes all of them real;
    damping a and b both appear with it, so that it exists for the library as a whole.
    """
    field = ParameterField(("a", "b", "s", "w"), order)
    pieces = [library(field)[k] for k in chosen]
    whole = product(pieces)
    factors = factor_monic(whole)
    assert expanded(factors) == whole
    assert all(f.coefficients[-1] == field.one for f in factors)
    degrees = [f.degree for f in factors]
    assert degrees == sorted(degrees, reverse=True)
    conservative = {0, 1, 2, 3, 4}
    if set(chosen) <= conservative:
        assert sum(f.multiplicity for f in factors) >= len(chosen)
        assert {c: chosen.count(k) for k in chosen for c in [repr(pieces[chosen.index(k)])]} == {
            repr(f.coefficients): f.multiplicity for f in factors
        }


def test_growth_and_decay_stay_together() -> None:
    """Γ² − a² is real in Λ = Γ/i and has no real root there: one factor, judged as a whole."""
    field = ParameterField(("a",))
    a = field.generator("a")
    whole = (-(a * a), field.zero, field.one)
    (factor,) = factor_monic(whole)
    assert factor.coefficients == whole


def test_what_cannot_be_made_real_is_left_whole() -> None:
    """Γ² − a(1 + i): no change p → i^x p makes 1 + i real."""
    field = ParameterField(("a",))
    a = field.generator("a")
    whole = (-(a + a.times_i()), field.zero, field.one)
    (factor,) = factor_monic(whole)
    assert factor.coefficients == whole and factor.multiplicity == 1


@pytest.mark.parametrize("order", [8, 12, 20])
def test_irrational_coefficients(order: int) -> None:
    """Coefficients with √2, √3 or √5 are left whole, exactly."""
    field = ParameterField(("a",), order)
    a = field.generator("a")
    surd = field.rotate(a, 1) + field.rotate(a, -1)
    whole = product([(surd, field.one), (-surd, field.one)])
    assert expanded(factor_monic(whole)) == whole
