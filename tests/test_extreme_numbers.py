"""Numbers at the ends of the range of doubles: answers scale, and NumPy warns of nothing."""

from __future__ import annotations

import warnings
from collections.abc import Iterator

import numpy as np
import pytest
from entries import emitted
from systems import Omega, coupled_mathieu, omega_1, omega_2

from mmsgen.runtime._beating import beat

SIZES = (1e-300, 1e-160, 1e160, 1e300)
PAIR = {"omega_1": 1.0, "omega_2": 2.5, "f_11": 0.1, "f_12": 0.2, "f_21": 0.3, "f_22": 0.1}


@pytest.fixture(autouse=True)
def silence() -> Iterator[None]:
    """Every warning but that of the scaling is an error."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", "outside of the validity", UserWarning)
        yield


# Neutral, damped, growing; one eigenvalue twice, with one eigenvector and damped; three rates.
MATRICES = [
    np.array([[0.3j, 0.5j], [0.7j, -0.4j]]),
    np.array([[0.3j - 0.1, 0.5j], [0.7j, -0.4j - 0.2]]),
    np.array([[0.3j, 0.5], [0.7, -0.4j]]),
    np.array([[0.3j - 0.1, 0.5], [0.0, 0.3j - 0.1]]),
    np.array([[0.3j - 0.1, 0.5j, 0.1j], [0.7j, -0.4j - 0.2, 0.2j], [0.1j, 0.2j, -0.05]]),
]


@pytest.mark.parametrize("matrix", MATRICES)
@pytest.mark.parametrize("power", [-900, -300, 300, 900])
def test_beating_scales_to_the_last_bit(matrix: np.ndarray, power: int) -> None:
    n = len(matrix)
    blocks = (tuple((j, 0) for j in range(n)),)
    start, barred = np.arange(1.0, n + 1) * (1.0 + 0.5j), np.zeros_like(matrix)
    plain = beat(matrix, barred, blocks, start)
    # A power of two changes no digit, neither of rates nor of amplitudes.
    unit = 2.0**power
    faster = beat(matrix * unit, barred, blocks, start)
    np.testing.assert_array_equal(faster.period * unit, plain.period)
    np.testing.assert_array_equal(faster.largest, plain.largest)
    np.testing.assert_array_equal(faster.margin, plain.margin)
    larger = beat(matrix, barred, blocks, start * unit)
    np.testing.assert_array_equal(larger.period, plain.period)
    np.testing.assert_array_equal(larger.largest, plain.largest * unit)
    np.testing.assert_array_equal(larger.margin, plain.margin * unit)


@pytest.mark.parametrize("size", SIZES)
def test_emitted_beating(size: float) -> None:
    case = emitted("combination", "Omega_is_omega_1_plus_omega_2_order_2")
    small = case.beating([1e-3, 2e-3j], sigma=0.1, **PAIR)
    large = case.beating(np.array([1e-3, 2e-3j]) * size, sigma=0.1, **PAIR)
    # Of some hundred operations, each off by one rounding.
    np.testing.assert_allclose(large.period, small.period, rtol=1e-13)
    np.testing.assert_allclose(large.largest / size, small.largest, rtol=1e-13)
    for name in ("sigma", *PAIR):
        values = {"sigma": 0.1, **PAIR, name: size}
        found = case.beating([1e-3, 2e-3j], **values)
        assert not (found.largest < 0.999e-3).any()  # not less than at t = 0
        case.evolution(1.0, [1e-3, 2e-3j], **values)


@pytest.mark.parametrize("size", SIZES)
def test_beating_of_the_engine(size: float) -> None:
    flow = coupled_mathieu().expand(1, {Omega: omega_1 + omega_2}).slow_flow
    values = {"omega_1": 1.0, "omega_2": 2.5, "f_12": 0.2, "f_21": 0.3, "sigma": 0.1}
    found = flow.beating(values, [size, 2.0 * size])
    assert not (found.largest < 0.999 * size).any()
    for name in ("f_12", "sigma"):
        found = flow.beating(values | {name: size}, [1.0, 2.0])
        assert not (found.largest < 0.999).any()


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("gradient", [False, True])
def test_emitted_response(size: float, gradient: bool) -> None:
    case = emitted("duffing_forced", "Omega_is_omega_0_order_2")
    values = {"sigma": 0.1, "omega_0": 1.0, "alpha": 0.1, "mu": 0.05, "K": 0.1}
    for name in values:
        x = case.response(1.0, [0.1 + 0.2j], **values | {name: size}, gradient=gradient)
        assert np.shape(x[0] if gradient else x) == (1,)
    case.response(1.0, [(0.1 + 0.2j) * size], **values, gradient=gradient)
    case.response(size, [0.1 + 0.2j], **values, gradient=gradient)


@pytest.mark.parametrize("size", SIZES)
def test_emitted_modes(size: float) -> None:
    case = emitted("rotating_shaft", "nu_is_omega_1_plus_omega_2_order_1")
    usual = {"I_t": 1.0, "I_p": 1.5, "Omega_s": 0.7, "k": 2.0}
    for name in usual:
        found = case.modes(**usual | {name: size})
        assert not np.isinf([*found.values()]).any()
