"""No equilibrium of two amplitudes is lost, whatever the sizes of the parameters and the units."""

from __future__ import annotations

import numpy as np
import pytest
from flow_tables import DAMPED, FORCE_1, FORCE_2, ONE_TO_THREE, QUADRATIC, saturating, table

from mmsgen.runtime._charts import chart
from mmsgen.runtime._flow import Flow, jacobian
from mmsgen.runtime._many_amplitudes import equilibria_of_many
from mmsgen.runtime._planes import elsewhere
from mmsgen.runtime._systems import equilibrium_system, patterns, scaled

FORCED = {
    "1:2 first": table([*DAMPED, *QUADRATIC, FORCE_1]),
    "1:2 second": table([*DAMPED, *QUADRATIC, FORCE_2]),
    "1:3 first": table([*DAMPED, *ONE_TO_THREE, FORCE_1]),
    "1:3 second": table([*DAMPED, *ONE_TO_THREE, FORCE_2]),
}


def drawn(flow: Flow, decades: float, count: int, seed: int) -> np.ndarray:
    """Coefficients of damped, forced oscillators, each size anywhere in so many decades.

    Springs neither feed nor damp Σ ν_j |B_j|²: their coefficients are imaginary, and those of
    B̄_1^k B_2 and B_1^(k+1) have one sign. Far out the damping leads inwards.
    """
    random = np.random.default_rng(seed)
    size = 10.0 ** random.uniform(-decades, decades, (2, count, len(flow.terms)))
    sign = random.choice([-1.0, 1.0], (count, len(flow.terms)))
    coupling = random.choice([-1.0, 1.0], count)
    c = 1j * sign * size[0]
    for m, (j, e) in enumerate(flow.terms):
        harmonics = e[0] - e[1], e[3] - e[4]
        if sum(e) == 1:
            c[:, m] -= size[1, :, m]
        elif sum(e) and harmonics != ((1, 0), (0, 1))[j]:
            c[:, m] = 1j * coupling * size[0, :, m]
    return c


@pytest.mark.parametrize("name", FORCED)
@pytest.mark.parametrize("decades", [3.0, 6.0])
def test_indices_add_up_to_one(name: str, decades: float) -> None:
    """Poincaré and Hopf: where all motions lead inwards the signs of det J have the sum one."""
    flow = FORCED[name]
    c = drawn(flow, decades, 20, 3)
    found = equilibria_of_many(flow, c)
    there = np.isfinite(found.growth)
    matrices = jacobian(flow, c[:, None, :], found.amplitudes)
    matrices = np.where(there[..., None, None], matrices, np.eye(4))
    sign = np.linalg.slogdet(matrices)[0]
    assert np.where(there, sign, 0.0).sum(axis=1).tolist() == [1.0] * len(c)


@pytest.mark.parametrize("name", FORCED)
def test_any_units(name: str) -> None:
    """Time in units of T, amplitudes in units a_j of their own: the same motions.

    Newton's method leaves relative errors of 1e-16 times the condition, below 1e8 here.
    """
    flow = FORCED[name]
    c = drawn(flow, 1.5, 6, 5)
    found = equilibria_of_many(flow, c)
    for time, unit in ((1e-12, (1.0, 1.0)), (1e12, (1e-6, 1e6)), (1e6, (1e9, 1e9))):
        power = [
            np.prod(np.array(unit) ** -np.array([sum(e[:3]), sum(e[3:])])) * unit[j]
            for j, e in flow.terms
        ]
        other = equilibria_of_many(flow, c * time * np.array(power))
        assert np.isfinite(other.growth).sum(axis=1).tolist() == (
            np.isfinite(found.growth).sum(axis=1).tolist()
        )
        for one, two in zip(found.amplitudes, other.amplitudes / np.array(unit), strict=True):
            one, two = (x[np.isfinite(x).all(axis=1)] for x in (one, two))
            gap = np.abs(one[:, None] - two) / np.abs(one[:, None] + (one[:, None] == 0))
            assert gap.max(axis=2).min(axis=1) == pytest.approx(0.0, abs=1e-8)


@pytest.mark.parametrize("name", FORCED)
def test_scales_in_any_units(name: str) -> None:
    """Neither the sizes nor the numbers of the scaled system depend on units; none is large."""
    flow = FORCED[name]
    system = equilibrium_system(flow, patterns(flow)[-1])
    c = drawn(flow, 6.0, 20, 7)
    target = scaled(system, c)[0]
    # 11 terms in an equation at most; a few more for the squares.
    assert np.abs(target).max() < 20.0
    unit = 1e12 * np.array([1e7 ** (1 - sum(e)) for _, e in flow.terms])
    # Newton's method for the scales stops at 1e-4, which leaves the square of that.
    assert np.abs(scaled(system, c * unit)[0] / target - 1.0).max() < 1e-5


@pytest.mark.parametrize("force", 10.0 ** np.arange(-2.0, -17.0, -2.0))
def test_a_weak_force(force: float) -> None:
    """B_1 = F/(μ_1 + iσ_1), B_2 = −ic B_1³/(μ_2 + iσ_2), which is far smaller, but for F²."""
    flow, rate, slow = FORCED["1:3 first"], 0.02 + 0.3j, 0.02 + 0.85j
    c = np.array([-1e-2j if sum(e) == 3 else 0.0 for _, e in flow.terms])
    for j, e, value in ((0, 0, -rate), (1, 3, -slow)):
        c[flow.terms.index((j, tuple(int(k == e) for k in range(6))))] = value
    c[flow.terms.index((0, (0,) * 6))] = force * 0.1
    found = equilibria_of_many(flow, c)
    first = 0.1 * force / rate
    assert found.amplitudes.shape == (1, 2)
    expected = [first, -1e-2j * first**3 / slow]
    # The cubic terms change B by the part |B|²/30 of it.
    assert found.amplitudes[0] == pytest.approx(expected, rel=max(force**2, 1e-13), abs=0.0)


@pytest.mark.parametrize("alpha", [1.0, 0.3, 3.0])
def test_weak_damping(alpha: float) -> None:
    """Two coupled oscillators of van der Pol, μ(1 − u²)u': the motions of μ → 0, up to O(μ)."""
    first, second = (1, 0, 0, 0, 0, 0), (0, 0, 0, 1, 0, 0)
    own = (2, 1, 0, 0, 0, 0), (0, 0, 0, 2, 1, 0)
    terms = ((0, second), (0, first), (0, own[0]), (1, second), (1, own[1]), (1, first))
    flow, damping = Flow(2, terms, ((1, 1),)), 10.0 ** -np.arange(2.0, 10.0)
    c = [
        [-0.05j, 0.5 * mu + 0.05j, 1.5j * alpha - 0.5 * mu, 0.75 * mu + 0.1j, -1.5 * mu, -0.05j]
        for mu in damping
    ]
    found = equilibria_of_many(flow, np.array(c))
    assert np.isfinite(found.growth).sum(axis=1).tolist() == [3] * 8
    # Rounding errors over μ are left of the weakest damping.
    for modulus, mu in zip(found.modulus, damping, strict=True):
        assert modulus == pytest.approx(found.modulus[-1], rel=max(50.0 * mu, 1e-5))


def test_amplitudes_that_vanish() -> None:
    """B_1 ~ 0 beside B_2 is none of both; B_2 that B_1³ moves is, however small."""
    flow, c = saturating(0.1, 0.2, 0.3)
    second, unit = c[flow.terms.index((1, (0,) * 6))], np.ones((1, 2))
    rest = -second / c[flow.terms.index((1, (0, 0, 0, 1, 0, 0)))]
    place = chart(flow, (0, 1))
    nothing = np.zeros((1, 0))
    assert elsewhere(place, c[None], np.array([[1e-15, rest]]), nothing, unit).tolist() == [True]
    driven = FORCED["1:3 first"]
    c = drawn(driven, 0.1, 1, 1)
    linear = [c[0, driven.terms.index((0, e))] for e in ((0,) * 6, (1, 0, 0, 0, 0, 0))]
    point = np.array([[-linear[0] / linear[1], 1e-15]])
    assert elsewhere(chart(driven, (0, 1)), c, point, nothing, unit).tolist() == [False]
