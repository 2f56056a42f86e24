"""Equilibria of two and more amplitudes at special parameters, where generic counts do not hold."""

from __future__ import annotations

import numpy as np
import pytest
from flow_tables import DAMPED, FORCE_1, saturating, table

from mmsgen.runtime._flow import Flow
from mmsgen.runtime._many_amplitudes import equilibria_of_many

# B_1' = (−m + iσ)B_1 + iκB_2 + iγ|B_1|²B_1 + iF and B_2' = iσ_2 B_2 + iκB_1: an undamped absorber.
ABSORBER = table([*DAMPED, (0, 2, 1, 0, 0), (0, 0, 0, 1, 0), (1, 1, 0, 0, 0), FORCE_1])


def absorber(sigma_2: float) -> np.ndarray:
    return np.array([-0.01 + 0.02j, 1j * sigma_2, 0.3j, 0.1j, 0.1j, 0.05j])


@pytest.mark.parametrize(
    ("sigma_1", "sigma_2", "mu_2"),
    [(0.0, 0.0, 0.0), (0.1, -0.1, 0.0), (0.0, 0.0, 0.03), (0.1, -0.1 + 1e-15, 0.03)],
)
def test_an_undamped_first_amplitude(sigma_1: float, sigma_2: float, mu_2: float) -> None:
    """0 = B_1(−i(σ_1 + σ_2)/2) − ½iB_2 B̄_1 and 0 = −¼iB_1² − ⅛iF − (μ_2 + iσ_2)B_2.

    At σ_2 = −σ_1 the first gives B_2 = 0, the second B_1² = −F/2. Near that |B_2| = |σ_1 + σ_2|
    while B_1² moves by 4|σ_2 B_2| < 1e-15.
    """
    flow, c = saturating(sigma_1, sigma_2, 0.05, 0.0, mu_2)
    found = equilibria_of_many(flow, c).amplitudes
    pair = found[np.abs(found[:, 0]) > 0.0]
    # Some roundings of 2⁻⁵³, relative; of B_2 that is zero exactly, no more than the input.
    assert pair[:, 0].imag ** 2 == pytest.approx([0.025, 0.025], rel=1e-14)
    assert pair[:, 0].imag.sum() == pytest.approx(0.0, abs=1e-15)
    assert np.abs(pair[:, 0].real) == pytest.approx([0.0, 0.0], abs=1e-14)
    assert np.abs(pair[:, 1]) == pytest.approx(2 * [abs(sigma_1 + sigma_2)], rel=1e-9, abs=0.0)
    resting = found[np.abs(found[:, 0]) == 0.0]
    linear = mu_2 + 1j * sigma_2
    assert len(resting) == (linear != 0.0)
    if linear:
        assert resting[:, 1] == pytest.approx([-0.125j * 0.05 / linear], rel=1e-14)


def test_antiresonance() -> None:
    """A tuned absorber, σ_2 = 0: B_1 = 0 and B_2 = −F/κ. Beside that B_1 = −σ_2 B_2/κ."""
    found = equilibria_of_many(ABSORBER, [absorber(0.0), absorber(1e-6)]).amplitudes
    assert found.shape == (2, 1, 2)
    assert found[0, 0, 0] == 0.0
    assert found[0, 0, 1] == pytest.approx(-0.5, rel=1e-14)
    assert found[1, 0, 0] == pytest.approx(-1e-5 * found[1, 0, 1], rel=1e-12)


def test_antiresonance_beside_a_circle() -> None:
    """The same with a third amplitude, B_3' = (μ + iν)B_3 − B_3|B_3|²: |B_3|² = μ, drift ν."""
    plain = tuple((j, (*e, 0, 0, 0)) for j, e in ABSORBER.terms)
    own = ((2, (0,) * 6 + (1, 0, 0)), (2, (0,) * 6 + (2, 1, 0)))
    flow = Flow(3, (*plain, *own), ((0, 0, 1),))
    c = np.concatenate((absorber(0.0), [0.04 + 0.3j, -1.0]))
    found = equilibria_of_many(flow, c)
    assert found.amplitudes == pytest.approx(np.array([[0, -0.5, 0], [0, -0.5, 0.2]]), abs=1e-14)
    assert found.amplitudes[:, 0].tolist() == [0, 0]
    assert found.drift[1] == pytest.approx([0.3], abs=1e-14)


def test_amplitudes_that_can_have_any_value() -> None:
    """Without any term that moves B_2 alone, B_1 = 0 leaves B_2 as it is."""
    flow, c = saturating(0.1, 0.0, 0.0, 0.02, 0.0)
    for parameters in (0 * c, c):
        with pytest.raises(ValueError, match="not isolated"):
            equilibria_of_many(flow, parameters)
    other = saturating(0.1, 0.0, 0.0)[1]
    found = equilibria_of_many(flow, [c, other, 0 * c])
    assert found.number.tolist() == [0, 1, 0]
    assert found.amplitudes[1].tolist() == [[0, 0]]
    assert np.isnan(found.amplitudes[[0, 2]]).all()


@pytest.mark.parametrize("off", [0.0, 1e-14, -1e-13, 1e-12, 1e-9])
def test_cusps(off: float) -> None:
    """(−c/2 − iσ + iγx)B + F = 0, x = |B|²: at σ = √3c/2, γx = 2σ/3 the three roots are one.

    With ξ = γx, ξ((c/2)² + (σ − ξ)²) = γ|F|² is (ξ − ξ_0)³ = 2·off·ξ_0((c/2)² + (σ − ξ_0)²)
    = 2·off·ξ_0³ there; so |B| = B_0(1 + (2·off)^⅓/2) to within (2·off)^⅔. Rounding moves a triple
    root by (some 2⁻⁵³)^⅓ = 1e-5.
    """
    numbers = np.random.default_rng(1)
    flow = table([*DAMPED, (0, 2, 1, 0, 0), (1, 0, 0, 2, 1), FORCE_1])
    c, gamma, phase = (numbers.uniform(*x, 40) for x in ((0.01, 1), (0.1, 3), (0, 6)))
    sigma = np.sqrt(0.75) * c
    x = 2 * sigma / 3 / gamma
    force = np.sqrt(x * (c**2 / 4 + (sigma - gamma * x) ** 2)) * (1 + off) * np.exp(1j * phase)
    one = np.ones(40)
    parameters = np.stack([-c / 2 - 1j * sigma, -0.3 * one, 1j * gamma, 1j * one, force], -1)
    found = equilibria_of_many(flow, parameters)
    assert found.number.tolist() == [1] * 40
    expected = np.sqrt(x) * (1 + np.cbrt(2 * off) / 2)
    error = 2e-5 + np.cbrt(2 * off) ** 2
    assert np.abs(found.amplitudes[:, 0, 0]) == pytest.approx(expected, rel=error)
    assert (found.amplitudes[:, 0, 1] == 0.0).all()
