"""All equilibria of two amplitudes: how many there are, which, and that none is missing."""

from __future__ import annotations

import random
from itertools import combinations

import numpy as np
import pytest
import sympy as sp
from flow_tables import (
    CUBIC,
    DAMPED,
    FORCE_1,
    FORCE_2,
    ONE_TO_ONE,
    ONE_TO_THREE,
    QUADRATIC,
    saturating,
    table,
)
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from scipy.spatial import ConvexHull

from mmsgen.runtime._bounds import least_count
from mmsgen.runtime._certificates import certified
from mmsgen.runtime._charts import chart, equations, unpack
from mmsgen.runtime._flow import Flow, rates
from mmsgen.runtime._many_amplitudes import equilibria_of_many, generic_counts
from mmsgen.runtime._systems import System, equilibrium_system, patterns

FLOWS = {
    "1:2 free": table([*DAMPED, *QUADRATIC], ((1, 2),)),
    "1:2 first forced": table([*DAMPED, *QUADRATIC, FORCE_1]),
    "1:2 second forced": table([*DAMPED, *QUADRATIC, FORCE_2]),
    "1:3 free": table([*DAMPED, *ONE_TO_THREE], ((1, 3),)),
    "1:3 first forced": table([*DAMPED, *ONE_TO_THREE, FORCE_1]),
    "1:3 second forced": table([*DAMPED, *ONE_TO_THREE, FORCE_2]),
    "non-resonant, forced": table([*DAMPED, *CUBIC, FORCE_1], ((0, 1),)),
}
# (of the first alone, of the second alone, of both): from the mixed volume and from Gröbner bases,
# both of which are computed below.
COUNTS = {
    "1:2 free": (None, 0, 2),
    "1:2 first forced": (None, None, 3),
    "1:2 second forced": (None, 1, 4),
    "1:3 free": (None, 1, 5),
    "1:3 first forced": (None, None, 9),
    "1:3 second forced": (None, 3, 18),
    "non-resonant, forced": (3, None, 3),
}

# --- how many -------------------------------------------------------------------------------------


def mixed_volume(system: System) -> float:
    """Of the Newton polytopes: inclusion and exclusion over the volumes of their sums."""
    d, total = system.d, 0.0
    supports = [np.array([e for row, e in system.terms if row == i]) for i in range(d)]
    for size in range(1, d + 1):
        for chosen in combinations(supports, size):
            points = np.zeros((1, d), dtype=int)
            for support in chosen:
                points = np.unique((points[:, None] + support).reshape(-1, d), axis=0)
            if np.linalg.matrix_rank(points - points[0]) == d:
                total += (-1) ** (d - size) * ConvexHull(points).volume
    return total


def dimension(system: System, prime: int = 32003) -> int:
    """Of the quotient by the ideal of the equations with random coefficients modulo a prime.

    No unknown being zero is one more equation, 1 = w·z_1⋯z_d. The monomials that no leading
    monomial divides are a basis.
    """
    choice = random.Random(4)
    z, w = sp.symbols(f"z:{system.d}"), sp.Symbol("w")
    equations = [1 - w * sp.prod(z)] + [sp.S(0)] * system.d
    for row, e in system.terms:
        monomial = sp.prod(x**k for x, k in zip(z, e, strict=True))
        equations[row + 1] += choice.randrange(1, prime) * monomial
    basis = sp.groebner(equations, w, *z, order="grevlex", modulus=prime)
    leading = [sp.Poly(g, w, *z, modulus=prime).monoms(order="grevlex")[0] for g in basis.exprs]
    todo = {(0,) * (system.d + 1)}
    found: set[tuple[int, ...]] = set()
    while todo:
        e = todo.pop()
        if e not in found and not any(np.all(np.greater_equal(e, m)) for m in leading):
            found.add(e)
            todo |= {tuple(x + (i == k) for i, x in enumerate(e)) for k in range(len(e))}
    return len(found)


@pytest.mark.parametrize("name", FLOWS)
def test_counts(name: str) -> None:
    """Followed paths, Bernstein's theorem and Gröbner bases agree on the number of solutions."""
    flow = FLOWS[name]
    counts = generic_counts(flow)
    expected = dict(zip([(0,), (1,), (0, 1)], COUNTS[name], strict=True))
    assert {k: v for k, v in counts.items() if k} == {
        k: v for k, v in expected.items() if v is not None
    }
    for active in counts:
        if active:
            system = equilibrium_system(flow, active)
            # The volume comes from floating-point determinants of small integers.
            assert mixed_volume(system) == pytest.approx(counts[active], abs=1e-9)
            assert dimension(system) == counts[active]


def test_one_to_one_has_fifteen() -> None:
    flow = table([*DAMPED, *CUBIC, *ONE_TO_ONE, FORCE_1])
    assert generic_counts(flow) == {(0, 1): 15}
    # Floating-point determinants of small integers.
    assert mixed_volume(equilibrium_system(flow, (0, 1))) == pytest.approx(15, abs=1e-9)


def test_patterns_are_invariant() -> None:
    assert patterns(FLOWS["1:2 free"]) == ((), (1,), (0, 1))
    assert patterns(FLOWS["1:2 first forced"]) == ((0, 1),)
    assert patterns(FLOWS["1:2 second forced"]) == ((1,), (0, 1))


# --- which ----------------------------------------------------------------------------------------


def test_saturation() -> None:
    """Nayfeh and Mook, chapter 6: a_2 does not depend on the force, a_1 by a quadratic equation.

    Rates are sums of a few terms of size 0.1 with roundings of 1e-16, and the Jacobian's
    condition is below 1e3: 1e-12 is generous.
    """
    mu_1, mu_2, sigma_1, sigma_2 = 0.02, 0.03, 0.05, -0.03
    forces = np.array([0.01, 0.05, 0.1, 0.2, 0.4])
    flow, _ = saturating(sigma_1, sigma_2, 0.0)
    c = np.array([saturating(sigma_1, sigma_2, f)[1] for f in forces])
    found = equilibria_of_many(flow, c)
    linear = forces / (4 * np.hypot(mu_2, sigma_2))
    saturated = 2 * np.hypot(2 * mu_1, sigma_1 + sigma_2)
    # The first equation gives e^{2iγ_1} in terms of B_2; in the second one it leaves
    # |P + |B_1|²| = F/2.
    product = 8 * (mu_1 + 0.5j * (sigma_1 + sigma_2)) * (mu_2 + 1j * sigma_2)
    for k, force in enumerate(forces):
        own = found.modulus[k, : found.number[k]]
        idle = own[:, 0] == 0.0
        assert own[idle, 1] == pytest.approx([linear[k]], rel=1e-12)
        roots = np.roots([1.0, 2 * product.real, abs(product) ** 2 - (force / 2) ** 2])
        exact = [2 * np.sqrt(r.real) for r in roots if r.imag == 0 and r.real > 0]
        # Two points, B_1 and −B_1, for each amplitude.
        assert sorted(own[~idle, 0]) == pytest.approx(sorted(exact * 2), rel=1e-11)
        assert own[~idle, 1] == pytest.approx(np.full(2 * len(exact), saturated), rel=1e-11)
    assert found.number.tolist() == [1, 3, 3, 3, 3]


def test_three_amplitudes() -> None:
    """Ω ≈ ω_1 + ω_2 with the sum driven by a third mode: its amplitude saturates.

    B_1' = −m_1 B_1 + i p B̄_2 B_3 and the like give m_1 m̄_2 = p q |B_3|², however large the force.
    The symmetry (1, −1, 0) drifts.
    """
    exponents = [
        (0, (1, 0, 0, 0, 0, 0)),
        (1, (0, 0, 1, 0, 0, 0)),
        (2, (0, 0, 0, 0, 1, 0)),
        (0, (0, 0, 0, 1, 1, 0)),
        (1, (0, 1, 0, 0, 1, 0)),
        (2, (1, 0, 1, 0, 0, 0)),
        (2, (0, 0, 0, 0, 0, 0)),
    ]
    terms = tuple(
        (j, tuple(x for r, s in zip(e[::2], e[1::2], strict=True) for x in (r, s, 0)))
        for j, e in exponents
    )
    flow = Flow(3, terms, ((1, -1, 0),))
    assert generic_counts(flow) == {(2,): 1, (0, 1, 2): 4}
    # Floating-point determinants of small integers.
    assert mixed_volume(equilibrium_system(flow, (0, 1, 2))) == pytest.approx(4, abs=1e-9)
    forces = np.array([0.002, 0.05, 0.1])
    c = np.array([[-0.02, -0.03, -0.05 - 0.1j, -0.5j, -0.4j, -0.3j, -1j * f] for f in forces])
    found = equilibria_of_many(flow, c)
    assert np.all(certified(flow, c, found).sum(axis=-1) == found.number)
    both = found.modulus[:, :, 0] > 0.0
    assert both.sum(axis=-1).tolist() == [0, 1, 1]
    # Newton's method at conditions below 1e3.
    saturated = 2 * np.sqrt(0.02 * 0.03 / (0.5 * 0.4))
    assert found.modulus[both, 2] == pytest.approx(saturated, rel=1e-12)
    assert found.drift[both] == pytest.approx(0.0, abs=1e-13)


def van_der_pol_pair() -> tuple[Flow, np.ndarray]:
    """B_j' = (1 + i d_j)B_j − (1 + i j)B_j|B_j|² − κB_j|B_l|², κ = ½: four equilibria."""
    flow = table([*DAMPED, *CUBIC], ((1, 0), (0, 1)))
    return flow, np.array([1 + 0.3j, 1 - 0.2j, -1 - 1j, -0.5, -0.5, -1 - 2j])


def test_two_symmetries() -> None:
    flow, c = van_der_pol_pair()
    found = equilibria_of_many(flow, c)
    third = np.sqrt(1 / 1.5)
    exact = [[0, 0], [0, 1], [third, third], [1, 0]]
    assert found.number == 4
    # Moduli from Newton's method at conditions of a few units.
    ordered = sorted(map(tuple, found.amplitudes.real))
    assert np.array(ordered) == pytest.approx(np.array(exact), abs=1e-13)
    assert np.all(found.amplitudes.imag == 0.0)
    both = found.drift[3]
    assert both == pytest.approx([0.3 - 1 / 1.5, -0.2 - 2 / 1.5], abs=1e-13)
    assert np.all(certified(flow, c, found))
    wrong = found._replace(amplitudes=found.amplitudes * (1 + 1e-3))
    assert certified(flow, c, wrong).tolist() == [True, False, False, False]
    # Of the moduli the Jacobian at the last one is −(4/3)·[[1, ½], [½, 1]].
    assert found.growth[3] == pytest.approx(-2 / 3, abs=1e-12)


def test_a_point_of_each_circle() -> None:
    """1:2 with the fast one excited; a turn by π of the slow one leaves the fast one as it is.

    So where the fast one comes first, its phase leaves two points of each circle to choose from.
    """
    slow_first = table([*DAMPED, *QUADRATIC], ((1, 2),))
    fast_first = table(
        [(0, 1, 0, 0, 0), (1, 0, 0, 1, 0), (0, 0, 0, 2, 0), (1, 1, 0, 0, 1)], ((2, 1),)
    )
    slow, fast, one, two = -0.1, 0.05 + 0.2j, 0.5j, 0.25j
    found = equilibria_of_many(slow_first, [slow, fast, one, two])
    swapped = equilibria_of_many(fast_first, [fast, slow, two, one])
    assert found.number == swapped.number == 2
    # Newton's method at conditions of some hundreds.
    assert swapped.modulus[:, ::-1] == pytest.approx(found.modulus, abs=1e-12)
    assert swapped.drift == pytest.approx(found.drift, abs=1e-12)
    assert swapped.growth == pytest.approx(found.growth, abs=1e-12)
    mirrored = equilibria_of_many(fast_first, np.conj([fast, slow, two, one]))
    for b in (swapped.amplitudes[1], mirrored.amplitudes[1]):
        assert b[0].imag == 0.0 < b[0].real
        assert 0.0 <= np.angle(b[1]) < np.pi


def test_derivatives_by_the_rate_of_drift() -> None:
    """Central differences of quadratic functions are exact but for their roundings, 1e-16/h."""
    flow = table([*DAMPED, *QUADRATIC], ((1, 2),))
    place, h = chart(flow, (0, 1)), 1e-3
    c = np.array([[-0.1, 0.05 + 0.2j, 0.5j, -0.25j]])
    x = np.array([[0.7, 0.3, -0.4, 0.9]])
    _, matrix = equations(place, c, *unpack(place, x))
    for k, step in enumerate(h * np.eye(4)):
        sides = [equations(place, c, *unpack(place, x + s * step))[0][0] for s in (1, -1)]
        assert matrix[0, :, k] == pytest.approx((sides[0] - sides[1]) / (2 * h), abs=1e-12)


def test_odd_powers_of_a_modulus() -> None:
    """B' = −½B|B| + 2: the only equilibrium is B = 2. A second amplitude decays."""
    flow = Flow(2, ((0, (1, 0, 1, 0, 0, 0)), (0, (0,) * 6), (1, (0, 0, 0, 1, 0, 0))), ((0, 1),))
    found = equilibria_of_many(flow, [-0.5, 2.0, -1.0])
    assert found.amplitudes == pytest.approx(np.array([[2.0, 0.0]]), abs=1e-14)


def test_double_root_counts_once() -> None:
    """At F = 2|Im P|, P = 8(μ_1 + iσ/2)(μ_2 + iσ_2), the two quadratic roots coincide.

    Roots that differ by the square root of roundings, 1e-8, are one.
    """
    mu_1, mu_2, sigma_1, sigma_2 = 0.02, 0.03, 0.4, 0.2
    product = 8 * (mu_1 + 0.5j * (sigma_1 + sigma_2)) * (mu_2 + 1j * sigma_2)
    assert product.real < 0
    flow, c = saturating(sigma_1, sigma_2, 2 * abs(product.imag))
    found = equilibria_of_many(flow, c)
    # At a double root nothing can be proved.
    assert certified(flow, c, found).tolist() == (found.modulus[:, 0] == 0).tolist()
    pair = found.modulus[found.modulus[:, 0] > 0]
    assert pair[:, 0] == pytest.approx(2 * [2 * np.sqrt(-product.real)], rel=1e-6)


def test_no_finite_coefficient() -> None:
    flow, c = saturating(0.0, 0.0, 0.1)
    found = equilibria_of_many(flow, np.stack([c, np.full(5, np.nan)]))
    assert found.number.tolist() == [3, 0]
    assert equilibria_of_many(flow, np.zeros((0, 5))).amplitudes.shape == (0, 0, 2)
    assert equilibria_of_many(flow, np.tile(c, (2, 3, 1))).amplitudes.shape == (2, 3, 3, 2)


def test_a_force_that_vanishes() -> None:
    flow, c = saturating(0.05, -0.03, 0.2)
    resting = c.copy()
    resting[flow.terms.index((1, (0,) * 6))] = 0.0
    found = equilibria_of_many(flow, np.stack([c, resting]))
    assert found.number.tolist() == [3, 1]
    assert found.amplitudes[1, 0].tolist() == [0, 0]
    assert found.growth[1, 0] == pytest.approx(-0.02, abs=1e-15)  # exact but for a rounding


# --- none is missing ------------------------------------------------------------------------------


def random_flow(choice: random.Random) -> Flow:
    """Two amplitudes, cubic at most."""
    terms = {(0, 1, 0, 0, 0), (0, 2, 1, 0, 0), (1, 0, 0, 1, 0), (1, 0, 0, 2, 1)}
    terms.add((choice.randrange(2), 0, 0, 0, 0))
    for _ in range(4):
        e = [0, 0, 0, 0]
        for _ in range(choice.randint(1, 3)):
            e[choice.randrange(4)] += 1
        terms.add((choice.randrange(2), *e))
    return table(sorted(terms))


def by_newton(flow: Flow, c: np.ndarray, numbers: np.random.Generator) -> np.ndarray:
    """Equilibria that Newton's method finds from random points, differences for derivatives.

    Complex steps would need an analytic function: central differences with h = 1e-6 and the last
    steps good to 1e-9 suffice to tell equilibria from each other.
    """
    x = numbers.normal(size=(200, 4)) * np.exp(numbers.normal(size=(200, 1)))

    def f(x: np.ndarray) -> np.ndarray:
        r = rates(flow, c, x[..., 0::2] + 1j * x[..., 1::2])
        return np.stack([r.real, r.imag], -1).reshape(*x.shape)

    with np.errstate(all="ignore"):
        for _ in range(40):
            h = 1e-6 * np.eye(4)
            matrix = (f(x[:, None] + h) - f(x[:, None] - h)).swapaxes(1, 2) / 2e-6
            singular = ~(np.abs(np.linalg.det(matrix)) > 1e-12)
            matrix[singular] = np.eye(4)
            x = x - np.linalg.solve(matrix, f(x)[..., None])[..., 0]
        good = (np.abs(f(x)).max(axis=1) < 1e-9) & (np.abs(x).max(axis=1) < 1e3)
    return x[good, 0::2] + 1j * x[good, 1::2]


@settings(max_examples=3, deadline=None, derandomize=True, phases=[Phase.generate])
@given(st.integers(0, 10**6))
def test_a_second_method_finds_nothing_new(seed: int) -> None:
    flow = random_flow(random.Random(seed))
    numbers = np.random.default_rng(seed)
    c = numbers.normal(size=(3, len(flow.terms))) + 1j * numbers.normal(size=(3, len(flow.terms)))
    found = equilibria_of_many(flow, c)
    for k in range(3):
        own = found.amplitudes[k, : found.number[k]]
        size = np.abs(own).max(axis=-1)
        # Residuals are roundings of terms of third degree.
        assert np.all(np.abs(rates(flow, c[k], own)).max(axis=-1) < 1e-13 * (1 + size) ** 3)
        for b in by_newton(flow, c[k], numbers):
            assert np.abs(own - b).max(axis=-1).min() < 1e-5
        # Forced, the index of all equilibria together is ±1: their number is odd.
        assert found.number[k] % 2 == 1
    # Random coefficients are far from folds.
    assert certified(flow, c, found).sum() == found.number.sum()


# --- too many -------------------------------------------------------------------------------------


def chain(n: int, forced: bool) -> Flow:
    """Equal oscillators in a row, cubic springs, linear couplings between neighbours."""
    terms = [(0, ((0,) * 3 * n))] if forced else []
    for j in range(n):
        one = np.eye(3 * n, dtype=int)
        powers = [one[3 * k] for k in (j - 1, j, j + 1) if 0 <= k < n]
        powers.append(2 * one[3 * j] + one[3 * j + 1])
        terms += [(j, tuple(map(int, e))) for e in powers]
    return Flow(n, tuple(sorted(terms)), () if forced else ((1,) * n,))


@pytest.mark.parametrize("forced", [True, False])
def test_a_lower_bound_for_the_number(forced: bool) -> None:
    """The bound holds where paths count them; six amplitudes are refused without any path."""
    flow = chain(2, forced)
    (count,) = (n for active, n in generic_counts(flow).items() if active == (0, 1))
    assert 0 < least_count(equilibrium_system(flow, (0, 1))) <= count
    flow = chain(3, forced)
    least = least_count(equilibrium_system(flow, (0, 1, 2)))
    # One amplitude after the other: three of each that a force moves; of two free ones six.
    assert least == (27 if forced else 18)
    with pytest.raises(ValueError, match="complex equilibria"):
        equilibria_of_many(chain(6, forced), np.ones(len(chain(6, forced).terms)))
