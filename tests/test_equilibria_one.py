"""Equilibria of one amplitude: against published relations, and against Newton's method at random.

Published results: Nayfeh and Mook, Nonlinear Oscillations (1979), chapters 4 and 5.
"""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from flow_tables import SHAPES, shaped
from hypothesis import given
from hypothesis import strategies as st
from systems import Omega, alpha, d, duffing, equations, f, k, mu, omega, t, van_der_pol, x

from mmsgen.errors import MmsgenError
from mmsgen.runtime._flow import Flow, rates, spectrum, wirtinger
from mmsgen.runtime._one_amplitude import equilibria_of_one
from mmsgen.runtime._records import Equilibria
from mmsgen.slowflow import SlowFlow

EPS = 2.0**-52

DUFFING = d(x, 2) + omega**2 * x + 2 * mu * d(x) + alpha * x**3


def forced(order: int, resonance: dict[sp.Expr, sp.Expr], weak: bool) -> SlowFlow:
    scales = {alpha: 1, mu: 1, **({k: 1} if weak else {})}
    return (
        equations([DUFFING - k * sp.cos(Omega * t)], [x])
        .scale(scales)
        .expand(order, resonance)
        .slow_flow
    )


def parametric(left: sp.Expr, order: int = 1) -> SlowFlow:
    left = d(x, 2) + (1 + 2 * f * sp.cos(Omega * t)) * x + left
    scales = {s: 1 for s in (alpha, mu, f) if left.has(s)}
    return equations([left], [x]).scale(scales).expand(order, {Omega: 2}).slow_flow


def row(found: Equilibria, index: int = 0) -> np.ndarray:
    """The amplitudes 2|B| of one point, without the padding."""
    sizes = found.modulus.reshape(-1, found.modulus.shape[-2])[index]
    return sizes[np.isfinite(sizes)]


# --- published relations --------------------------------------------------------------------------


def test_primary_resonance_is_the_cubic_of_the_textbook() -> None:
    """[μ² + (σ − 3αa²/8ω)²]a² = k²/4ω², its roots by NumPy: some roundings, 1e-12."""
    flow = forced(1, {Omega: omega}, weak=True)
    sigma = np.linspace(-0.5, 1.5, 41)
    values = {"omega": 1.3, "alpha": 0.4, "mu": 0.03, "k": 0.2}
    found = flow.equilibria({**values, "sigma": sigma})
    assert set(np.isfinite(found.growth).sum(axis=-1)) == {1, 3}
    for j, s in enumerate(sigma):
        g = 3 * 0.4 / (8 * 1.3)
        squares = np.roots([g * g, -2 * g * s, s * s + 0.03**2, -(0.2**2) / (4 * 1.3**2)])
        real = np.sort(squares.real[np.abs(squares.imag) < 1e-9])
        assert row(found, j) == pytest.approx(np.sqrt(real), rel=1e-12)
        # The upper and the lower branch are stable, the middle one is not.
        stable = found.stable[j][: len(real)]
        assert list(stable) == [i != 1 for i in range(len(real))]


def test_subharmonic_of_order_three() -> None:
    """Numbers of the published relation; three phases each, a third of a turn apart."""
    flow = forced(1, {Omega: 3 * omega}, weak=False)
    found = flow.equilibria({"omega": 1, "alpha": 1, "mu": 0.05, "k": 8, "sigma": 6})
    assert row(found) == pytest.approx([0, *3 * [1.39465604], *3 * [2.39198687]], abs=1e-8)
    assert list(found.stable) == [True, False, False, False, True, True, True]
    for three in (found.amplitudes[1:4, 0], found.amplitudes[4:, 0]):
        turns = three / three[0]
        # Roundings of complex numbers of modulus one.
        assert turns == pytest.approx(np.exp(2j * np.pi * np.arange(3) / 3), abs=1e-14)
        assert 0 <= np.angle(three[0]) < 2 * np.pi / 3


@pytest.mark.parametrize("sigma", [-0.7, -0.3, 0.2, 0.9])
def test_mathieu_duffing(sigma: float) -> None:
    """a² = 4(σ ± √(f² − 4μ²))/3α, two phases each; zero is unstable where σ² < f² − 4μ²."""
    values = {"alpha": 0.5, "mu": 0.1, "f": 0.6, "sigma": sigma}
    found = parametric(2 * mu * d(x) + alpha * x**3).equilibria(values)
    root = np.sqrt(0.6**2 - 4 * 0.1**2)
    squares = [4 * (sigma + s * root) / 1.5 for s in (-1, 1)]
    expected = [0.0, *(np.sqrt(q) for q in squares if q > 0 for _ in range(2))]
    assert row(found) == pytest.approx(expected, rel=1e-13)
    assert bool(found.growth[0] > 0) == (sigma**2 < root**2)


def test_parametrically_excited_van_der_pol() -> None:
    """a² = 4(1 + √(f² − σ²)), at ε = 1 with μ = 1; stable."""
    found = parametric(-mu * (1 - x**2) * d(x)).equilibria({"mu": 1, "f": 0.5, "sigma": 0.3})
    largest = row(found)[-2:]
    assert largest == pytest.approx(2 * [np.sqrt(4 * (1 + np.sqrt(0.25 - 0.09)))], rel=1e-13)
    assert found.stable[-1]


def test_limit_cycle_of_van_der_pol() -> None:
    """a = 2 + μ²/64 and ω = 1 − μ²/16: at order 3 the next terms are of order μ⁴.

    So half of μ makes the distance sixteen times smaller; 1e-14 of rounding beside 1e-7.
    """
    flow = van_der_pol().expand(3).slow_flow
    size = np.array([0.2, 0.1])
    found = flow.equilibria({"mu": size})
    amplitude = found.modulus[:, 1, 0] - 2 - size**2 / 64
    shift = found.drift[:, 1, 0] + size**2 / 16
    assert amplitude[0] / amplitude[1] == pytest.approx(16, rel=0.1)
    assert shift[0] / shift[1] == pytest.approx(16, rel=0.1)
    assert found.growth[:, 0] == pytest.approx(size / 2, rel=1e-12)
    assert found.growth[:, 1] == pytest.approx(-size, rel=0.1)


# --- completeness ---------------------------------------------------------------------------------


def newton(flow: Flow, c: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Solutions that Newton's method finds from the given points, with the slow flow as it is."""
    for _ in range(50):
        value = rates(flow, c, b[:, None])[:, 0]
        plain, barred = (m[:, 0, 0] for m in wirtinger(flow, c, b[:, None]))
        with np.errstate(all="ignore"):
            step = (barred * value.conj() - plain.conj() * value) / (
                np.abs(plain) ** 2 - np.abs(barred) ** 2
            )
        step = np.where(np.isfinite(step), step, 0.0)
        b = b + step
    left = np.abs(rates(flow, c, b[:, None])[:, 0])
    return b[(left < 1e-11) & (np.abs(step) < 1e-9 * np.abs(b))]


@given(st.sampled_from(sorted(SHAPES)), st.integers(0, 10**6), st.booleans())
def test_newton_from_anywhere_finds_nothing_new(name: str, seed: int, conservative: bool) -> None:
    """Random coefficients, real parts left out for half of them: phases then come in pairs."""
    flow, random = shaped(name), np.random.default_rng(seed)
    size = len(flow.terms)
    c = 1j * random.normal(size=size) + (0 if conservative else random.normal(size=size))
    found = equilibria_of_one(flow, c)
    listed = found.amplitudes[np.isfinite(found.growth), 0]
    apart = np.abs(listed[:, None] - listed) + np.diag(np.full(len(listed), np.inf))
    assert (apart > 1e-8 * np.abs(listed)).all()  # none is there twice
    starts = np.exp(random.normal(size=400) + 2j * np.pi * random.random(400))
    seen = newton(flow, c, starts)
    for b in seen[np.abs(seen) < 1e3]:
        # Newton's last step was below 1e-9.
        assert np.abs(listed - b).min() <= 1e-8 * np.abs(b)
    for b, growth in zip(listed, found.growth, strict=False):
        terms = sum(abs(x) * abs(b) ** sum(e) for x, (_, e) in zip(c, flow.terms, strict=True))
        assert np.abs(rates(flow, c, [b])[0]) <= 1e-13 * terms
        # The square root of a rounding, where two eigenvalues nearly coincide.
        scale = np.abs(wirtinger(flow, c, [b])).sum()
        assert growth == pytest.approx(spectrum(flow, c, [b])[0].real, abs=1e-7 * scale)


# --- folds and degenerate points ------------------------------------------------------------------


def fold(shift: float) -> Equilibria:
    """The primary resonance at a detuning beside the exact upper fold of an undamped oscillator.

    (σ − g a²)² a² = h² has its double root at g a² = σ/3, σ³ = 27 g h²/4: one of three equilibria
    on the lower side is left. Here g = 3/8, h = 1/2, so that σ³ = 81/128.
    """
    sigma = (81 / 128) ** (1 / 3) * (1 + shift)
    flow = Flow(1, ((0, (0, 0, 0)), (0, (1, 0, 0)), (0, (2, 1, 0))))
    return equilibria_of_one(flow, np.array([-0.25j, -1j * sigma, 1.5j]))


def test_fold() -> None:
    assert row(fold(-1e-9)).size == 1
    assert row(fold(1e-9)).size == 3
    double = row(fold(0.0))
    assert double.size == 2
    # The double root is good to the square root of the rounding.
    assert double[0] == pytest.approx(np.sqrt((81 / 128) ** (1 / 3) / 3 / (3 / 8)), rel=1e-7)
    growth = fold(0.0).growth
    assert growth[0] == pytest.approx(0.0, abs=1e-3)
    # The other one is a centre: neutral, not stable.
    assert growth[1] == 0.0 and not fold(0.0).stable[1]


def test_nothing_jumps_near_a_fold() -> None:
    """Relative distances from the fold down to some roundings: one or two, then three."""
    for distance in np.logspace(-3, -15, 40):
        assert row(fold(distance)).size in ((3,) if distance > 1e-13 else (2, 3))
        assert row(fold(-distance)).size in ((1,) if distance > 1e-13 else (1, 2))


@pytest.mark.parametrize("seed", range(8))
def test_cusp(seed: int) -> None:
    """B (p + q|B|²) = −g with |B|²|p + q|B|²|² − |g|² = |q|²(|B|² − x)³: one triple root.

    Both sides of the first equation are some dozen roundings wide, 64 ε at most of the sum of the
    terms' absolute values, at most six times |g|: |B|² − x is below x (2·6·64 ε)^{1/3} = 6e-5 x.
    """
    random = np.random.default_rng(seed)
    flow = Flow(1, ((0, (0, 0, 0)), (0, (1, 0, 0)), (0, (2, 1, 0))))
    q = random.normal(size=25) + 1j * random.normal(size=25)
    x = 10 ** random.uniform(-2, 2, 25)
    p = q * x * (-1.5 + 0.5j * np.sqrt(3) * random.choice([-1, 1], 25))
    g = np.abs(q) * x**1.5 * np.exp(2j * np.pi * random.random(25))
    found = equilibria_of_one(flow, np.stack((g, p, q), axis=-1))
    assert found.number.tolist() == 25 * [1]
    assert np.abs(found.amplitudes[:, 0, 0]) ** 2 == pytest.approx(x, rel=6e-5)


@pytest.mark.parametrize("distance", np.logspace(-3, -15, 13))
def test_between_the_folds_of_a_cusp(distance: float) -> None:
    """y³ − 3D²y/4 = 0 with y = |B|² − x: three roots x and x ± D√(3/4), if rounding allows them.

    The triple root is about 1e-5 wide.
    """
    d = 0.75 * distance**2
    # |B|²|p + |B|²|² = g² + (|B|² − 1)³ − d (|B|² − 1): g² = 1 − d, 2 Re p = −3, |p|² = 3 − d.
    flow = Flow(1, ((0, (0, 0, 0)), (0, (1, 0, 0)), (0, (2, 1, 0))))
    c = np.array([np.sqrt(1 - d), -1.5 + 1j * np.sqrt(3 - d - 2.25), 1.0])
    found = equilibria_of_one(flow, c)
    squares = np.abs(found.amplitudes[:, 0]) ** 2
    if distance > 1e-4:
        # Roundings 64 ε over the slope D².
        side = np.sqrt(d)
        assert squares == pytest.approx([1 - side, 1.0, 1 + side], abs=100 * EPS / d)
    elif distance < 1e-6:
        assert len(squares) == 1


def test_circles_without_force_and_damping() -> None:
    """The backbone a² = 8σω/3α; both are listed, neutral. With damping nothing but rest is left."""
    damping, force = sp.symbols("mu k", real=True)
    left = d(x, 2) + omega**2 * x + 2 * damping * d(x) + alpha * x**3 - force * sp.cos(Omega * t)
    system = equations([left], [x]).scale({alpha: 1, damping: 1, force: 1})
    flow = system.expand(1, {Omega: omega}).slow_flow
    values = {"omega": 1.0, "alpha": 1.0, "k": 0.0, "sigma": 0.3}
    found = flow.equilibria({**values, "mu": np.array([0.0, 0.1])})
    # Some roundings of a polynomial with two terms.
    assert row(found) == pytest.approx([0.0, np.sqrt(0.8)], rel=1e-14)
    assert found.amplitudes[0, 1, 0].real > 0.0 and found.growth[0, 1] == 0.0
    assert row(found, 1).tolist() == [0.0]
    assert row(flow.equilibria({**values, "mu": 0.0, "sigma": -0.3})).tolist() == [0.0]
    response = flow.frequency_response({**values, "mu": 0.0, "sigma": np.linspace(-0.2, 0.3, 6)})
    assert [b.modulus.max() for b in response.branches] == [0.0]


def test_circles_that_happen_to_be_at_rest() -> None:
    """A van der Pol oscillator with a cubic spring and no force: a = 2 turns at 3αa²/8 − σ."""
    flow = Flow(1, ((0, (0, 0, 0)), (0, (1, 0, 0)), (0, (2, 1, 0))))
    sigma = np.array([0.0, 0.45, 0.46])
    cubic = np.array([0.0, 0.3, 0.3])
    c = np.stack((0 * sigma, 0.05 - 1j * sigma, -0.05 + 1.5j * cubic), axis=-1)
    found = equilibria_of_one(flow, c)
    assert found.number.tolist() == [2, 2, 1]
    assert found.modulus[:2, 1, 0] == pytest.approx(2.0, rel=1e-14)
    # d(ȧ)/da = −μ at a = 2, μ = 1/10; 1/20 at rest.
    assert found.growth[:2] == pytest.approx(np.array([[0.05, -0.1]] * 2), rel=1e-13)
    assert equilibria_of_one(flow, c, circles=False).number.tolist() == [1, 1, 1]


def test_a_circle_of_different_stability_is_a_curve() -> None:
    """dB/dt = B̄ (1 − |B|²): the disturbances' growth depends on the phase."""
    flow = Flow(1, ((0, (0, 1, 0)), (0, (1, 2, 0))))
    with pytest.raises(ValueError, match="not isolated"):
        equilibria_of_one(flow, np.array([1.0, -1.0]))
    assert equilibria_of_one(flow, np.array([[1.0, -1.0], [1.0, 1.0]])).number.tolist() == [0, 1]


@pytest.mark.parametrize("name", sorted(SHAPES))
@pytest.mark.parametrize(("size", "rate"), [(-90, 0), (90, 0), (0, -300), (0, 300), (40, 260)])
def test_units_do_not_matter(name: str, size: int, rate: int) -> None:
    """B = 2^size β and t = 2^-rate τ take c to c 2^{rate + size(1 − power)}, exactly.

    Newton's method leaves roundings in ln r and the phase, and eigenvalues some of the largest.
    """
    flow, random = shaped(name), np.random.default_rng(7)
    c = random.normal(size=(6, len(flow.terms))) + 1j * random.normal(size=(6, len(flow.terms)))
    plain = equilibria_of_one(flow, c)
    powers = np.array([sum(e) for _, e in flow.terms])
    other = equilibria_of_one(flow, c * 2.0 ** (rate + size * (1 - powers)))
    assert other.number.tolist() == plain.number.tolist()
    b = other.amplitudes * 2.0**-size
    assert b == pytest.approx(plain.amplitudes, rel=1e-11, nan_ok=True)
    assert other.growth * 2.0**-rate == pytest.approx(plain.growth, rel=1e-9, nan_ok=True)


def test_tiny_and_huge_parameters() -> None:
    """Duffing's equation, a = k/2ω|iμ − σ| for a tiny force, (4k/3α)^{1/3} for a huge one."""
    flow = forced(1, {Omega: omega}, weak=True)
    values = {"omega": 1.0, "alpha": 1.0, "mu": 0.05, "sigma": 0.3, "k": np.array([1e-80, 1e100])}
    found = flow.equilibria(values)
    # The roundings of both formulas; what they leave out is far smaller.
    sizes = [1e-80 / (2 * np.hypot(0.05, 0.3)), (4e100 / 3) ** (1 / 3)]
    assert found.modulus[:, 0, 0] == pytest.approx(sizes, rel=1e-14, abs=0.0)
    assert found.growth[0, 0] == pytest.approx(-0.05, rel=1e-13)
    assert row(flow.equilibria({**values, "alpha": 1e-80, "k": 0.1})) == pytest.approx(
        0.1 / (2 * np.hypot(0.05, 0.3)), rel=1e-14
    )
    with pytest.raises(MmsgenError, match="orders of magnitude"):
        flow.equilibria({**values, "k": 1e-300})
    several = flow.equilibria({**values, "k": np.array([1e-300, 0.1])})
    assert several.number[0] == 0 < several.number[1]
    # A term that is tiny beside one of the same power does no harm: rest is unstable without it.
    mathieu = Flow(1, ((0, (0, 1, 0)), (0, (1, 0, 0)), (0, (2, 1, 0))))
    assert equilibria_of_one(mathieu, np.array([1e-300, 0.1 - 0.2j, 1.5j])).number == 1


def test_everything_vanishes() -> None:
    flow = Flow(1, ((0, (0, 0, 0)), (0, (1, 0, 0)), (0, (2, 1, 0))))
    with pytest.raises(ValueError, match="not isolated"):
        equilibria_of_one(flow, np.zeros(3))
    assert equilibria_of_one(flow, np.diag([0.0, 1.0, 1.0])).number.tolist() == [0, 1, 1]


def test_no_equilibrium() -> None:
    """dB/dt = 1 + |B|²."""
    flow = Flow(1, ((0, (0, 0, 0)), (0, (1, 1, 0))))
    found = equilibria_of_one(flow, np.array([[1.0, 1.0], [2.0, 1.0]]))
    assert found.amplitudes.shape == (2, 0, 1) and found.growth.shape == (2, 0)


def test_a_free_undamped_oscillator_is_refused() -> None:
    with pytest.raises(MmsgenError, match=r"not isolated.*backbone"):
        duffing().expand(2).slow_flow.equilibria({"omega": 1.0, "alpha": 0.3})


def test_degenerate_points_of_a_batch_are_nan() -> None:
    """Van der Pol at μ = 0 among others; nothing is said there."""
    found = van_der_pol().expand(1).slow_flow.equilibria({"mu": np.array([0.1, 1e-300, 0.2])})
    assert np.isfinite(found.growth).all()
    flow = van_der_pol().expand(1).slow_flow.table.flow
    c = np.array([[0.1, -0.1], [0.0, 0.0], [np.nan, 1.0], [0.3, -0.3]])
    found = equilibria_of_one(flow, c)
    assert np.isnan(found.growth[1:3]).all() and np.isfinite(found.growth[[0, 3]]).all()
    assert found.number.tolist() == [2, 0, 0, 2]


def test_a_line_of_equilibria_is_refused() -> None:
    """The linear Mathieu equation on its boundary: σ = f without damping."""
    flow = Flow(1, ((0, (0, 1, 0)), (0, (1, 0, 0))))
    with pytest.raises(ValueError, match="not isolated"):
        equilibria_of_one(flow, np.array([0.25j, -0.25j]))
    beside = equilibria_of_one(flow, np.array([[0.25j, -0.25j], [0.25j, -0.2j]]))
    assert beside.number.tolist() == [0, 1]


def test_forces_that_vanish_at_some_points() -> None:
    """Without its force the oscillator rests, at every order of the elimination."""
    for order in (1, 2):
        flow = forced(order, {Omega: omega}, weak=True).table.flow
        c = np.array([[1j if e[0] == e[1] == 0 else -0.1 - 0.2j * sum(e) for _, e in flow.terms]])
        still = c.copy()
        for m, (_, e) in enumerate(flow.terms):
            if (e[0] - e[1] - 1) != 0:
                still[:, m] = 0.0
        found = equilibria_of_one(flow, np.concatenate((c, still)))
        assert found.number[1] == 1 and found.amplitudes[1, 0, 0] == 0.0
        assert found.number[0] >= 1 and np.abs(found.amplitudes[0, 0, 0]) > 0.0


def test_batches_are_their_points_one_by_one() -> None:
    """More points than a block, in a shape of their own: bit by bit the same."""
    flow = forced(2, {Omega: omega}, weak=True)
    sigma = np.linspace(-0.4, 1.2, 3000).reshape(3, 1000)
    values = {"omega": 1.0, "alpha": 0.4, "mu": 0.03, "k": 0.2}
    found = flow.equilibria({**values, "sigma": sigma})
    assert found.amplitudes.shape[:2] == (3, 1000)
    for index in ((0, 0), (1, 500), (2, 999)):
        alone = flow.equilibria({**values, "sigma": sigma[index]})
        count = alone.growth.size
        # Vectorised products round in another order.
        assert found.modulus[index][:count] == pytest.approx(alone.modulus, rel=1e-12)
        assert np.isnan(found.growth[index][count:]).all()


def test_detuning_follows_from_the_frequencies() -> None:
    flow = forced(1, {Omega: omega}, weak=True)
    values = {"omega": 1.0, "alpha": 0.4, "mu": 0.03, "k": 0.2}
    one = flow.equilibria({**values, "sigma": 0.25})
    other = flow.equilibria({**values, "Omega": 1.25})
    assert np.array_equal(one.amplitudes, other.amplitudes)
    with pytest.raises(MmsgenError, match="no value is given for k"):
        flow.equilibria({"omega": 1.0, "alpha": 0.4, "mu": 0.03, "sigma": 0.1})
