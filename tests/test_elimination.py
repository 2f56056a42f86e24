"""The phase of one amplitude eliminated: what the relation in the modulus is made of."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from flow_tables import shaped

from mmsgen.runtime._elimination import relation, resultant, structure_of


@pytest.mark.parametrize("name", ["order three", "three orders"])
def test_powers_that_cancel_are_left_out_of_the_relation(name: str) -> None:
    """Of small Gaussian integers no rounding is left: what is not zero for any of them is there."""
    flow, random = shaped(name), np.random.default_rng(3)
    structure = structure_of(flow, (True,) * len(flow.terms))
    real, imag = random.integers(-2, 3, (2, 50, len(flow.terms)))
    c = real + 1j * imag
    exact = relation(structure, c)
    assert {e for e, x in exact.items() if x.any()} == set(exact)
    f: list[Any] = [{} for _ in range(structure.degree + 1)]
    for i, h, power in structure.terms:
        f[h][power] = f[h].get(power, 0) + c[:, i]
    whole = resultant(f)
    assert {e for e, x in whole.items() if x.any()} == set(exact)
    assert set(whole) > set(exact)
