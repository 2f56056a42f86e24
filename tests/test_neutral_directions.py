"""Eigenvalues at circles of equilibria: the neutral ones are taken out, and spoil no other."""

from __future__ import annotations

import numpy as np
import pytest

from mmsgen.runtime._flow import Flow, spectrum
from mmsgen.runtime._many_amplitudes import equilibria_of_many
from mmsgen.runtime._nonlinear import stability_at
from mmsgen.runtime._one_amplitude import equilibria_of_one

EPS = 2.0**-52

ONE = Flow(1, ((0, (1, 0, 0)), (0, (2, 1, 0))), ((1,),))
TWO = Flow(
    2,
    (
        (0, (1, 0, 0, 0, 0, 0)),
        (0, (2, 1, 0, 0, 0, 0)),
        (0, (1, 0, 0, 1, 1, 0)),
        (1, (0, 0, 0, 1, 0, 0)),
        (1, (0, 0, 0, 2, 1, 0)),
        (1, (1, 1, 0, 1, 0, 0)),
    ),
    ((1, 0), (0, 1)),
)


def one(damping: float, twist: float) -> np.ndarray:
    """dB/dt = μ(1 − |B|²)B + iγ|B|²B: the circle |B| = 1, on which disturbances decay as e^{−2μt}.

    How fast it turns depends on its radius, by 2γ: the zero of the circle and −2μ nearly share
    their eigenvector.
    """
    return np.array([damping, -damping + 1j * twist])


def two(first: float, second: float, twist: float) -> np.ndarray:
    """Two of them whose radii turn each other: −2μ_1 and −2μ_2."""
    turn = 1j * twist
    return np.array([first, -first + turn, 0.7 * turn, second, -second + 0.4 * turn, -turn])


@pytest.mark.parametrize("damping", [1e-2, 1e-5, 1e-8])
@pytest.mark.parametrize("angle", [0.0, 0.7, 2.9])
def test_one_circle(damping: float, angle: float) -> None:
    twist = 1e3
    values = spectrum(ONE, one(damping, twist), [np.exp(1j * angle)], [twist])
    # Entries of the size of the twist are off by a rounding each, and so is the direction.
    assert abs(values[0] + 2 * damping) <= 32 * EPS * twist
    assert np.isnan(values[1])


@pytest.mark.parametrize(("first", "second"), [(1e-2, 2e-2), (1e-6, 3e-5), (1e-9, 1e-3)])
@pytest.mark.parametrize("size", [1.0, 1e-3])
def test_two_circles(first: float, second: float, size: float) -> None:
    twist = 1e3
    c = two(first, second, twist)
    c[[2, 4, 5]] /= [size**2, size**2, 1.0]  # the second amplitude in other units
    b = np.array([np.exp(0.7j), size * np.exp(-1.9j)])
    values = spectrum(TWO, c, b, [1.7 * twist, -0.6 * twist])
    assert np.isnan(values[2:]).all()
    # With the second amplitude in small units entries grow as the ratio.
    off = np.sort(values[:2].real) - np.sort([-2 * first, -2 * second])
    assert np.abs(off).max() <= 64 * EPS * twist / size


def test_two_symmetries_of_one_large_amplitude() -> None:
    # i(B_1, 0, B_3) and i(0, B_2, B_3) are all but parallel where B_3 is large.
    terms = tuple(
        (j, tuple(x for m in range(3) for x in (int(m == j) + (m == k), int(m == k), 0)))
        for j in range(3)
        for k in (-1, 0, 1, 2)
    )
    flow = Flow(3, terms, ((1, 0, 1), (0, 1, 1)))
    b = np.array([1e-6 * np.exp(0.3j), 2e-6 * np.exp(1.3j), np.exp(-2.1j)])
    # Each radius damped by itself, |B_j| constant at c_j0 = −c_jj |B_j|².
    rates = np.array([1e-3, 2e-3, 3e-3])
    c = np.zeros((3, 4), dtype=complex)
    c[:, 0], c[range(3), range(1, 4)] = rates, -rates / np.abs(b) ** 2
    values = spectrum(flow, c.ravel(), b, [0.0, 0.0])
    # Of three phases two are moved by symmetries, one is neutral by itself.
    expected = [0.0, *sorted(-2 * rates, reverse=True)]
    np.testing.assert_allclose(values[:4].real, expected, rtol=1e-12, atol=1e-15)
    assert np.isnan(values[4:]).all()


def test_a_symmetry_that_moves_nothing_takes_nothing_away() -> None:
    c = two(1e-3, 2e-3, 1.0)
    values = spectrum(TWO, c, [1.0, 0.0], [1.0, 0.0])
    # The second amplitude grows as e^{μ_2 t}, and turns by itself.
    np.testing.assert_allclose(values[:3].real, [2e-3, 2e-3, -2e-3], atol=16 * EPS)
    np.testing.assert_allclose(abs(values[:2].imag), 1.0, atol=16 * EPS)
    assert np.isnan(values[3])
    at_rest = spectrum(TWO, c, [0.0, 0.0], [0.0, 0.0])
    np.testing.assert_allclose(at_rest, [2e-3, 2e-3, 1e-3, 1e-3], atol=16 * EPS)


def test_growth_and_stability_are_one_number() -> None:
    def kernel(values: np.ndarray):
        def fill(out: np.ndarray, _: np.ndarray) -> None:
            out[...] = values

        return fill

    twist, origin = 1e3, [np.zeros(())]
    c = one(1e-6, twist)
    growth = equilibria_of_one(ONE, c)
    values = stability_at(ONE, kernel(c), origin, growth.amplitudes[1])
    assert abs(growth.growth[1] - values[0].real) <= 32 * EPS * twist
    c = two(1e-3, 2e-3, twist)
    found = equilibria_of_many(TWO, c)
    for k in range(found.number):
        values = stability_at(TWO, kernel(c), origin, found.amplitudes[k])
        assert abs(found.growth[k] - np.nanmax(values.real)) <= 64 * EPS * twist
    assert found.number == 4
