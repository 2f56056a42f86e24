"""Numbers into expressions: checked, broadcast, definitions filled in."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from systems import alpha, k, omega

from mmsgen.errors import MmsgenError
from mmsgen.numeric import Evaluator, named_values
from mmsgen.parameters import Parameter

PARAMETERS = (
    Parameter(alpha),
    Parameter(omega, definition=sp.sqrt(k)),
    Parameter(k, definition=4 * alpha),
)


def test_values_by_name_or_symbol() -> None:
    table = named_values(PARAMETERS, {alpha: 2, "omega": 3.0, "k": np.float32(0.5)})
    assert table == {"alpha": 2.0, "omega": 3.0, "k": 0.5}


def test_definitions_follow_one_another() -> None:
    """ω = √k and k = 4α from α alone; a value given wins over a definition."""
    table = named_values(PARAMETERS, {"alpha": np.array([1.0, 4.0])})
    assert table["omega"].tolist() == [2.0, 4.0]
    assert named_values(PARAMETERS, {"alpha": 1.0, "k": 9.0})["omega"] == 3.0
    assert named_values(PARAMETERS, {}) == {}


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"beta": 1.0}, "beta is not a parameter here; known are alpha, omega, k"),
        ({"alpha": 1.0, alpha: 1.0}, "alpha is given twice"),
        ({"alpha": float("nan")}, "alpha must be real and finite"),
        ({"alpha": float("inf")}, "alpha must be real and finite"),
        ({"alpha": [1.0, float("nan")]}, "alpha must be real and finite"),
        ({"alpha": 1j}, "alpha must be real and finite"),
        ({"alpha": "1"}, "alpha must be real and finite"),
        ({"alpha": None}, "alpha must be real and finite"),
        ({"alpha": True}, "alpha must be real and finite"),
        ({3: 1.0}, "3 is not a parameter"),
    ],
    ids=str,
)
def test_values_that_are_refused(values: dict, message: str) -> None:
    with pytest.raises(MmsgenError, match=message):
        named_values(PARAMETERS, values)


def test_evaluation() -> None:
    evaluate = Evaluator([alpha + k, sp.I * alpha, sp.Integer(7)], PARAMETERS)
    assert [p.name for p in evaluate.needed] == ["alpha", "k"]
    total, turned, constant = evaluate({"alpha": [1.0, 2.0], "k": [[1.0], [3.0]]})
    assert total.tolist() == [[2.0, 3.0], [4.0, 5.0]]
    assert turned.tolist() == [1j, 2j]
    assert constant == 7
    with pytest.raises(MmsgenError, match="no value is given for alpha, k"):
        evaluate({})


@pytest.mark.parametrize("name", ["sqrt", "exp", "pi", "E", "I", "sin", "numpy", "ω", "λ"])
def test_names_that_numpy_has(name: str) -> None:
    """A parameter may be called like a function of the printed code."""
    (symbol,) = sp.symbols([name], positive=True)
    expression = sp.sqrt(alpha) * sp.pi * sp.exp(alpha) * symbol + sp.sin(alpha)
    evaluate = Evaluator([expression], [Parameter(alpha), Parameter(symbol)])
    (value,) = evaluate({"alpha": 0.3, name: 2.0})
    expected = np.sqrt(0.3) * np.pi * np.exp(0.3) * 2.0 + np.sin(0.3)
    assert value == pytest.approx(expected, rel=1e-14)  # a handful of operations in doubles
