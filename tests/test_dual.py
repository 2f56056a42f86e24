"""Forward differentiation of formulas: against derivatives written out, and what it refuses."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mmsgen.runtime._dual import Dual, array_slopes, boundaries_at, real_at
from mmsgen.runtime._edges import zone
from mmsgen.runtime._runtime import evaluate, evaluate_pair

number = st.floats(0.25, 4.0)


def plain(kernel: Any, arguments: Any) -> Any:
    return kernel(*arguments)


@given(number, number)
def test_every_operation(a: float, b: float) -> None:
    """The kernel's derivatives by hand; the terms are of size 10, and there are ten of them."""

    def kernel(out: Any, x: Any, y: Any) -> None:
        out[..., 0] = x * y - 3 / x + x / y - (-x) + 2 * x - y / 2 + 1
        out[..., 1] = np.sqrt(x * y) + np.exp(-x) - np.abs(-y) + +x
        out[..., 2] = np.conj((1 + 2j) * x) * (y - 1j * x)
        out[..., 3] = 7

    values, slopes = array_slopes(kernel, [np.asarray(a), np.asarray(b)], 4)
    expected: Any = np.zeros(4, dtype=complex)
    kernel(expected, a, b)
    assert values == pytest.approx(expected, rel=1e-14)
    root = np.sqrt(a * b)
    by_a = [
        b + 3 / a**2 + 1 / b + 1 + 2,
        b / (2 * root) - np.exp(-a) + 1,
        (1 - 2j) * (b - 1j * a) - 1j * (1 - 2j) * a,
        0,
    ]
    by_b = [a - a / b**2 - 0.5, a / (2 * root) - 1, (1 - 2j) * a, 0]
    assert slopes == pytest.approx(np.array([by_a, by_b]), rel=1e-13, abs=1e-13)


def test_shapes_broadcast() -> None:
    def kernel(out: Any, x: Any, y: Any) -> None:
        out[..., 0] = x * y

    x, y = np.arange(1.0, 4.0), np.array([[2.0], [5.0]])
    values, slopes = array_slopes(kernel, [x, y], 1)
    assert values.shape == (2, 3, 1)
    assert slopes.shape == (2, 2, 3, 1)
    assert (slopes[0, ..., 0] == np.broadcast_to(y, (2, 3))).all()
    assert (slopes[1, ..., 0] == np.broadcast_to(x, (2, 3))).all()
    empty, none = array_slopes(kernel, [np.zeros(0), np.ones(1)], 1)
    assert empty.shape == (0, 1)
    assert none.shape == (2, 0, 1)


def test_only_the_named_arguments() -> None:
    arguments = [np.asarray(2.0), np.asarray(3.0)]
    value, slopes = real_at(evaluate, lambda x, y: x * x * y, arguments, ("y",))
    assert value == 12.0
    assert slopes == {"y": 4.0}
    assert real_at(evaluate, lambda x, y: x * y, arguments, ()) == 6.0
    assert real_at(evaluate, lambda x, y: 0.0, arguments, ("y",)) == (0.0, {"y": 0.0})


def test_no_value_no_slope() -> None:
    arguments = [np.array([-1.0, 4.0])]
    value, slopes = real_at(evaluate, np.sqrt, arguments, ("x",))
    assert np.isnan(value[0]) and np.isnan(slopes["x"][0])
    assert (value[1], slopes["x"][1]) == (2.0, 0.25)


def test_edges_of_a_zone_move_like_the_roots() -> None:
    """p (σ − x)(y − σ): the edges are x and y, whatever p."""
    arguments = [np.asarray(v) for v in (-1.0, 2.0, 3.0)]

    def kernel(x: Any, y: Any, p: Any) -> Any:
        return zone((-p * x * y, p * (x + y), -p))

    (lower, upper), slopes = boundaries_at(evaluate_pair, kernel, arguments, ("x", "y", "p"))
    assert (lower, upper) == pytest.approx((-1.0, 2.0))
    found = np.array([slopes[n] for n in "xyp"])
    # Roots are off by a few roundings, and slopes with them.
    assert found == pytest.approx(np.array([[1, 0], [0, 1], [0, 0]]), abs=1e-14)


def test_of_several_criteria_the_one_that_vanishes_counts() -> None:
    """Two parabolas, positive in (−x, x) and in (y − 3, y): together in (−x, y)."""
    arguments = [np.asarray(v) for v in (1.0, 2.5)]

    def kernel(x: Any, y: Any) -> Any:
        return zone((x * x, 0.0, -1.0), (-y * (y - 3.0), 2.0 * y - 3.0, -1.0), reach=9.0)

    pair, slopes = boundaries_at(evaluate_pair, kernel, arguments, ("x", "y"))
    assert pair == pytest.approx((-1.0, 2.5))
    assert slopes["x"] == pytest.approx((-1.0, 0.0), abs=1e-14)
    assert slopes["y"] == pytest.approx((0.0, 1.0), abs=1e-14)


def test_a_polynomial_that_does_not_count_is_left_out() -> None:
    """Beside damping that does not vanish the undamped criterion says nothing."""
    arguments = [np.array([1.0, 0.0]), np.asarray(2.0)]

    def kernel(damping: Any, x: Any) -> Any:
        return zone((x - damping, 0.0, -1.0), ((damping,), (4.0 * x, 0.0, -1.0)))

    (_, upper), slopes = boundaries_at(evaluate_pair, kernel, arguments, ("damping", "x"))
    # √(x − d) with damping, √(4x) without.
    assert upper == pytest.approx([1.0, np.sqrt(8.0)])
    assert slopes["x"][1] == pytest.approx([0.5, 2 / np.sqrt(8.0)])
    assert slopes["damping"][1] == pytest.approx([-0.5, 0.0], abs=1e-14)


def test_no_edge_no_slope() -> None:
    pair, slopes = boundaries_at(
        evaluate_pair, lambda x: zone((-x, 0.0, -1.0)), [np.array([1.0, 2.0])], ("x",)
    )
    assert np.isnan(pair).all()
    assert np.isnan(slopes["x"]).all()


def test_other_functions_are_refused() -> None:
    x = Dual(np.asarray(1.0), np.ones(1))
    with pytest.raises(TypeError):
        np.sin(x)
    with pytest.raises(TypeError):
        np.concatenate([x, x])
