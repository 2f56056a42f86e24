"""Normal modes: free motions of several amplitudes without damping, one of them given."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import sympy as sp
from flow_tables import CUBIC, DAMPED, ONE_TO_THREE, QUADRATIC, table
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen import Expansion
from mmsgen.errors import ExpansionError, MmsgenError
from mmsgen.runtime._flow import rates
from mmsgen.runtime._many_amplitudes import equilibria_of_many
from mmsgen.runtime._modes import modes_of

t = dynamicsymbols._t
x, y = dynamicsymbols("x y")
omega, Omega = sp.symbols("omega Omega", positive=True)
mu, F = sp.symbols("mu F", nonnegative=True)
kappa, alpha = sp.symbols("kappa alpha", real=True)
PAIR = mg.Model.from_equations(
    [
        q.diff(t, 2) + 2 * mu * q.diff(t) + omega**2 * q + alpha * q**3 + kappa * (q - p) - force
        for q, p, force in ((x, y, F * sp.cos(Omega * t)), (y, x, 0))
    ],
    [x, y],
    [omega, mu, alpha, kappa, F, Omega],
).equations_of_motion()


@cache
def pair(order: int, forced: bool = False) -> Expansion:
    """Two equal oscillators with cubic springs, coupled weakly."""
    if forced:
        return PAIR.scale({mu: 1, alpha: 1, kappa: 1, F: 1}).expand(order, {Omega: omega})
    return PAIR.reparametrise({F: 0}).scale({mu: 1, alpha: 1, kappa: 1}).expand(order)


# --- closed forms ---------------------------------------------------------------------------------


def test_two_equal_oscillators() -> None:
    """B_1' = i(g|B_1|²B_1 + kB_2) and the same with 1 and 2 changed.

    In phase and in antiphase |B_1| = |B_2|; localised where B_1B_2 = k/g, which the motion in phase
    gives birth to at g|B|² = k. Disturbances of that grow like λ² = 4k(g|B|² − k), those of the
    localised ones do not.
    """
    k, g, half = 0.2, 0.8, np.array([0.2, 0.45, 0.55, 1.0])
    flow = table(
        [(0, 1, 0, 0, 0), (0, 0, 0, 1, 0), (1, 0, 0, 1, 0), (1, 1, 0, 0, 0), *CUBIC[:1], CUBIC[3]],
        ((1, 1),),
    )
    c = np.zeros(len(flow.terms), dtype=complex)
    for (j, e), value in zip(flow.terms, [-0.1, 1j * k, -0.3, 1j * k, 1j * g, 1j * g], strict=True):
        c[flow.terms.index((j, e))] = value
    found = modes_of(flow, c, 2 * half, 0)
    assert found.number.tolist() == [3] * 4  # the damping is left out
    for i, b in enumerate(half):
        wanted = [b, -b, k / g / b]
        # Newton's method at conditions of a few units.
        assert np.abs(found.amplitudes[i].imag).max() < 1e-12
        assert sorted(found.amplitudes[i, :, 1].real) == pytest.approx(sorted(wanted), abs=1e-12)
        places = [int(np.argmin(np.abs(found.amplitudes[i, :, 1] - w))) for w in wanted]
        for other, m in zip(wanted, places, strict=True):
            assert found.shift[i, m] == pytest.approx([g * b**2 + k * other / b] * 2, abs=1e-12)
        growth = np.sqrt(max(0.0, 4 * k * (g * b**2 - k)))
        assert found.growth[i, places] == pytest.approx([growth, 0.0, 0.0], abs=1e-9)
        assert found.stable[i, places].tolist() == [bool(g * b**2 < k), True, True]


def test_one_to_two() -> None:
    """B_1' = ic B̄_1B_2, B_2' = i(σB_2 + dB_1²): coupled motions have 2cB_2² = σB_2 + dB_1².

    The fast one alone, at the rate σ, is unstable where |c B_2| > σ/2: λ² = c²|B_2|² − σ²/4.
    """
    sigma, c, d = 0.2, -0.5, -0.25
    flow = table([*DAMPED, *QUADRATIC], ((1, 2),))
    found = modes_of(flow, [0.0, 1j * sigma, 1j * c, 1j * d], [0.2, 0.6, 0.0], 0)
    for i, half in enumerate((0.1, 0.3)):
        exact = np.roots([2 * c, -sigma, -d * half**2])
        # Newton's method at conditions of some ten.
        assert found.amplitudes[i, :, 1] == pytest.approx(exact[np.argsort(np.abs(exact))])
        assert found.shift[i] == pytest.approx(
            np.outer(c * found.amplitudes[i, :, 1].real, [1, 2]), abs=1e-12
        )
    assert found.number.tolist() == [2, 2, 0]
    fast = modes_of(flow, [0.0, 1j * sigma, 1j * c, 1j * d], [0.3, 0.5], 1)
    assert fast.amplitudes[:, 0, 0].tolist() == [0, 0]
    assert np.isnan(fast.shift[:, 0, 0]).all()
    assert fast.shift[:, 0, 1] == pytest.approx(sigma)
    unstable = np.sqrt(c**2 * 0.25**2 - sigma**2 / 4)
    assert fast.growth[:, 0] == pytest.approx([0.0, unstable], abs=1e-9)


def test_one_to_three() -> None:
    """Real amplitudes satisfy a cubic equation: three times the one rate is the other one."""
    flow = table([*DAMPED, *ONE_TO_THREE], ((1, 3),))
    sigma, (p, q, r, s), (c, d), b = 0.1, (0.5, 0.3, 0.4, -0.2), (0.6, 0.2), 0.7
    rate = [0.0, sigma, p, q, r, s, c, d]
    found = modes_of(flow, 1j * np.array(rate), 2 * b, 0)
    # 3(p b² + q B² + c b B) B = σB + r b²B + s B³ + d b³
    roots = np.roots([3 * q - s, 3 * c * b, 3 * p * b**2 - sigma - r * b**2, -d * b**3])
    exact = sorted(z.real for z in roots if z.imag == 0.0)
    # Newton's method at conditions of some ten.
    assert sorted(found.amplitudes[:, 1].real) == pytest.approx(exact, abs=1e-12)
    assert np.abs(found.amplitudes.imag).max() < 1e-12


# --- of a model -----------------------------------------------------------------------------------

VALUES = {"omega": 1.0, "mu": 0.0, "alpha": 0.4, "kappa": 0.1}


def test_localised_motions_beside_exact_orbits() -> None:
    """At the amplitude of the exact orbit frequency and other amplitude are off by O(ε^{N+1})."""
    errors = np.zeros((2, 2, 2))
    for i, epsilon in enumerate((1.0, 0.5)):
        values = VALUES | {"alpha": 0.4 * epsilon, "kappa": 0.1 * epsilon}
        start = pair(1).slow_flow.backbone(values, 1.0, x)
        m = int(np.argmin(start.modulus[:, 1]))
        b, shift = start.amplitudes[m].real, start.shift[m, 0]
        problem = mg.orbits.problem(PAIR.reparametrise({F: 0}), values)
        orbit = mg.orbits.find(
            problem,
            lambda s, b=b, rate=1.0 + shift: np.outer(2 * b, np.cos(rate * s)),
            2 * np.pi / (1.0 + shift),
            isolated=False,
        )
        first = 2 * np.abs(orbit.harmonics(1))[:2]
        for n, order in enumerate((1, 2)):
            found = pair(order).slow_flow.backbone(values, first[0], x)
            m = int(np.argmin(np.abs(found.modulus[:, 1] - first[1])))
            errors[n, i, 0] = 1.0 + found.shift[m, 0] - 2 * np.pi / orbit.period
            errors[n, i, 1] = found.modulus[m, 1] - first[1]
    # What the amplitude follows from is of order ε. The next terms of the series change the powers
    # by some tenths at these numbers.
    powers = np.log2(np.abs(errors[:, 0] / errors[:, 1]))
    assert powers == pytest.approx(np.array([[2, 1], [3, 2]]), abs=0.3)


def test_the_detuning_of_a_force() -> None:
    """Where the frequency of a force has that detuning, the free motion is at rest."""
    flow = pair(1, forced=True).slow_flow
    found = flow.backbone(VALUES | {"mu": 0.03}, [0.5, 1.2], x)
    assert found.detuning == pytest.approx(found.shift[..., 0])
    for i in range(2):
        for m in range(3):
            values = {**VALUES, "F": 0.0, "sigma": found.detuning[i, m]}
            c = flow.table.numbers(values)
            # Sums of a few terms below one.
            assert np.abs(rates(flow.table.flow, c, found.amplitudes[i, m])).max() < 1e-14
    free = pair(1).slow_flow.backbone(VALUES, [0.5, 1.2], x)
    assert free.amplitudes == pytest.approx(found.amplitudes)
    assert np.isnan(free.detuning).all()


def test_one_amplitude_is_the_formula() -> None:
    flow = pair(3).slow_flow
    assert flow.backbone(VALUES | {"kappa": 0.0}, 0.0, x).number == 0
    q = dynamicsymbols("q")
    eom = mg.Model.from_equations(
        [q.diff(t, 2) + 2 * mu * q.diff(t) + omega**2 * q + alpha * q**3 - F * sp.cos(Omega * t)],
        [q],
        [omega, mu, alpha, F, Omega],
    ).equations_of_motion()
    case = eom.scale({mu: 1, alpha: 1, F: 1}).expand(1, {Omega: omega})
    ((sigma, formula),) = case.slow_flow.backbone().items()
    found = case.slow_flow.backbone({"omega": 1.0, "alpha": 0.4, "mu": 0.1}, [0.3, 0.9])
    a = next(iter(formula.free_symbols - {omega, alpha}))
    exact = [float(formula.subs({omega: 1, alpha: 0.4, a: v})) for v in (0.3, 0.9)]
    assert str(sigma) == "sigma"
    assert found.detuning[:, 0] == pytest.approx(exact, rel=1e-13)  # a few roundings


def test_what_is_refused() -> None:
    flow = pair(1).slow_flow
    with pytest.raises(MmsgenError, match="coordinate whose amplitude is meant, one of"):
        flow.backbone(VALUES, 1.0)
    with pytest.raises(MmsgenError, match="amplitude must be finite and not negative"):
        flow.backbone(VALUES, -1.0, x)
    with pytest.raises(MmsgenError, match="no value is given for alpha"):
        flow.backbone({"omega": 1.0, "kappa": 0.1}, 1.0, x)
    with pytest.raises(ExpansionError, match="values and an amplitude"):
        flow.backbone()
    # A damper between the two: real coefficients of terms that phases enter.
    damper = table([*DAMPED, (0, 0, 0, 1, 0), (1, 1, 0, 0, 0), *CUBIC[:1]], ((1, 1),))
    with pytest.raises(ValueError, match="lose or gain energy"):
        modes_of(damper, [-0.1, -0.1, 0.1, 0.1, 0.5j], 1.0, 0)


# --- families among equilibria --------------------------------------------------------------------


def test_families_are_refused() -> None:
    """Undamped free motions fill curves; at single points of an array they make these NaN."""
    flow = table([*DAMPED, *QUADRATIC], ((1, 2),))
    free, driven = [0.1j, 0.2j, -0.5j, -0.25j], [0.1j - 0.1, 0.2j + 0.1, -0.5j, -0.25j]
    with pytest.raises(ValueError, match="fill curves"):
        equilibria_of_many(flow, free)
    found = equilibria_of_many(flow, [free, driven])
    assert found.number.tolist() == [0, 2]
    assert equilibria_of_many(flow, driven).amplitudes == pytest.approx(found.amplitudes[1])
    for order in (1, 2):
        with pytest.raises(MmsgenError, match="fill curves"):
            pair(order).slow_flow.equilibria(VALUES)
    damped = pair(1).slow_flow.equilibria(VALUES | {"mu": 1e-9})
    assert damped.number == 1


def test_a_second_amplitude_that_nothing_damps() -> None:
    """It may have any size; listed is where it rests. So it is without a force on the first."""
    flow = table([*DAMPED, *CUBIC, (0, 0, 0, 0, 0)], ((0, 1),))
    undamped = np.array([0.1j - 0.1, 0.2j, 1j, 0.3j, 0.4j, 0.5j, 0.1])
    found = equilibria_of_many(flow, undamped)
    damped = equilibria_of_many(flow, undamped - [0, 0.1, 0, 0, 0, 0, 0])
    assert found.number == damped.number == 1
    assert found.amplitudes == pytest.approx(damped.amplitudes, abs=1e-14)
    assert found.amplitudes[0, 1] == 0.0
    assert found.growth == pytest.approx(0.0, abs=1e-14)
    free = table([*DAMPED, *CUBIC], ((1, 0), (0, 1)))
    assert equilibria_of_many(free, undamped[:-1]).number == 1
    with pytest.raises(ValueError, match="fill curves"):
        equilibria_of_many(free, 1j * undamped[:-1].imag)


@pytest.mark.parametrize(("detuning", "fills"), [(0.1, False), (1.0, True)])
def test_sum_resonance(detuning: float, fills: bool) -> None:
    """B_1' = i(δB_1 + ½B̄_2), and with 1 and 2 changed: |B_1|² − |B_2|² stays.

    Where |δ| < ½ nothing but zero is at rest, and unstable; else every solution is bounded, and has
    any size.
    """
    flow = table([*DAMPED, (0, 0, 0, 0, 1), (1, 0, 1, 0, 0)], ((1, -1),))
    c = [1j * detuning, 1j * detuning, 0.5j, 0.5j]
    if fills:
        with pytest.raises(ValueError, match="fill curves"):
            equilibria_of_many(flow, c)
    else:
        found = equilibria_of_many(flow, c)
        assert found.number == 1
        assert found.growth == pytest.approx(np.sqrt(0.25 - detuning**2), rel=1e-14)
