"""Packed exponents, against plain tuples."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mmsgen.monomials import Packing

exponents = st.lists(st.integers(-1000, 1000), min_size=4, max_size=4)


@given(exponents)
def test_packing_round_trip(e: list[int]) -> None:
    packing = Packing(4)
    key = packing.pack(e)
    assert packing.exponents(key) == tuple(e)
    assert packing.pack(dict(enumerate(e))) == key
    assert packing.support(key) == tuple((i, c) for i, c in enumerate(e) if c)
    assert key == sum(c * u for c, u in zip(e, packing.unit, strict=True))


@given(exponents, exponents)
def test_adding_keys_multiplies_monomials(e: list[int], g: list[int]) -> None:
    packing = Packing(4)
    product = packing.exponents(packing.pack(e) + packing.pack(g))
    assert product == tuple(a + b for a, b in zip(e, g, strict=True))


@given(exponents, exponents)
def test_different_monomials_have_different_keys(e: list[int], g: list[int]) -> None:
    packing = Packing(4)
    assert (packing.pack(e) == packing.pack(g)) == (e == g)


@pytest.mark.parametrize("exponent", [1 << 18, -(1 << 18), 10**9])
def test_exponents_that_do_not_fit_are_refused(exponent: int) -> None:
    """Beyond a quarter of the base a product of two could no longer be told apart."""
    with pytest.raises(OverflowError, match="variable 1"):
        Packing(3).pack([0, exponent, 0])
