"""Branches of equilibria along a parameter: every point, folds, pitchforks, Hopf points."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp
from flow_tables import DAMPED, FORCE_1, ONE_TO_THREE, QUADRATIC, table
from systems import Omega, alpha, d, equations, kappa, mu, omega_1, t, x

from mmsgen.errors import MmsgenError
from mmsgen.runtime._branches import response_of
from mmsgen.runtime._flow import Flow, rates, spectrum
from mmsgen.runtime._many_amplitudes import equilibria_of_many
from mmsgen.runtime._one_amplitude import equilibria_of_one
from mmsgen.runtime._points import NEUTRAL
from mmsgen.runtime._records import Response

Coefficients = Callable[[Any], np.ndarray]


def of_one(*terms: tuple[int, int], symmetries: tuple[tuple[int, ...], ...] = ()) -> Flow:
    """A flow of one amplitude from the exponents of B and B̄."""
    return Flow(1, tuple((0, (r, s, 0)) for r, s in terms), symmetries)


def columns(*parts: Any) -> np.ndarray:
    return np.stack(np.broadcast_arrays(*(np.asarray(c, dtype=complex) for c in parts)), axis=-1)


def kinds(response: Response) -> list[str]:
    return [b.kind for b in response.bifurcations]


def check_every_point(flow: Flow, coefficients: Coefficients, response: Response) -> None:
    """All points are equilibria to rounding, their growth that of the Jacobian.

    Rates are sums of some terms with roundings of 1e-16 each, and Newton's method leaves what
    the last step of 1e-9 has for its square.
    """
    for branch in response.branches:
        c = coefficients(branch.parameter)
        turn = branch.drift @ np.array(flow.symmetries).reshape(-1, flow.n)
        left = rates(flow, c, branch.amplitudes) - 1j * turn * branch.amplitudes
        size = rates(flow, np.abs(c), np.abs(branch.amplitudes)).real
        assert np.all(np.abs(left) <= 1e-13 * (size.max() + np.abs(turn).max(initial=0.0)))
        drift = branch.drift if flow.symmetries else None
        exact = spectrum(flow, c, branch.amplitudes, drift)[:, 0].real
        # At folds eigenvalues have errors of the square root of the rounding.
        assert branch.growth == pytest.approx(exact, abs=1e-6)


def check_complete(
    flow: Flow, coefficients: Coefficients, response: Response, p: np.ndarray
) -> None:
    """At some of the values the branches together have all equilibria, of images one each."""
    solve = equilibria_of_one if flow.n == 1 else equilibria_of_many
    for value in p:
        every = solve(flow, coefficients(np.array([value])))
        found = [b.modulus[b.parameter == value] for b in response.branches]
        own = np.concatenate(found)
        expected = every.modulus[0, : every.number[0]]
        gap = np.abs(own[:, None] - expected).max(axis=-1)
        # Equilibria here are apart by more than 1e-3; images have the same moduli to rounding.
        assert np.all(gap.min(axis=0) < 1e-9)
        assert np.all(gap.min(axis=1) < 1e-9)
        assert len(np.unique(np.argmin(gap, axis=0))) == len(own)


# --- one amplitude --------------------------------------------------------------------------------


def duffing(s: Any) -> np.ndarray:
    """B' = −(0.05 + iσ)B + (3/8)i·4|B|²B·¼ − 0.1i, that is [μ² + (σ − 3a²/32)²]a² = 0.04."""
    return columns(-0.1j, -0.05 - 1j * np.asarray(s), 0.375j)


def test_folds_of_duffing() -> None:
    """They are zeros of the discriminant of the response relation, a cubic in a².

    Double roots by a formula in doubles: the discriminant is accurate to 1e-16 of its terms, so
    σ to about 1e-12.
    """
    flow = of_one((0, 0), (1, 0), (2, 1))
    p = np.linspace(-0.3, 1.7, 301)
    response = response_of(flow, duffing, p, "sigma")
    check_every_point(flow, duffing, response)
    check_complete(flow, duffing, response, p[::60])
    s, z = sp.symbols("s z")
    relation = (sp.Rational(1, 400) + (s - 3 * z / 32) ** 2) * z - sp.Rational(1, 25)
    roots = sp.Poly(sp.discriminant(relation, z), s).nroots(n=30)
    folds = sorted(float(sp.re(r)) for r in roots if abs(sp.im(r)) < 1e-20)
    assert kinds(response) == ["saddle-node"] * 2
    assert [b.parameter for b in response.bifurcations] == pytest.approx(folds, abs=1e-11)
    (branch,) = response.branches
    # One branch: all values once, those between the folds three times, and the folds.
    inside = np.sum((p > folds[0]) & (p < folds[1]))
    assert len(branch.parameter) == len(p) + 2 * inside + 2
    turns = np.flatnonzero(np.diff(np.sign(np.diff(branch.parameter)))) + 1
    assert branch.parameter[turns] == pytest.approx(folds[::-1], abs=1e-11)
    assert branch.stable.sum() == len(p) + inside
    assert response.name == "sigma"


def test_pitchforks_of_mathieu_and_duffing() -> None:
    """Where the trivial solution changes its stability, σ² = f² − 4μ² (here f = 0.2, μ = 0.05).

    And a² = 4(σ ± √(f² − 4μ²))/(3α) along the branches that begin there.
    """

    def coefficients(s: Any) -> np.ndarray:
        # B' = −μB − iσB/2 + (i/2)f B̄ + (3/2)iα B|B|², B = a/2·e^{iγ}
        return columns(0.1j, -0.05 - 0.5j * np.asarray(s), 1.5j * 0.5)

    flow = of_one((0, 1), (1, 0), (2, 1))
    p = np.linspace(-0.5, 0.5, 401)
    response = response_of(flow, coefficients, p)
    check_every_point(flow, coefficients, response)
    check_complete(flow, coefficients, response, p[::80])
    assert kinds(response) == ["pitchfork", "pitchfork"]
    edge = np.sqrt(0.2**2 - 4 * 0.05**2)
    assert [b.parameter for b in response.bifurcations] == pytest.approx([-edge, edge], abs=1e-14)
    trivial, stable, unstable = response.branches
    assert np.all(trivial.amplitudes == 0.0)
    assert trivial.parameter.tolist() == p.tolist()
    for branch, sign in ((stable, 1), (unstable, -1)):
        assert branch.parameter[0] == pytest.approx(-sign * edge, abs=1e-14)
        exact = 4 * (branch.parameter[1:] + sign * edge) / (3 * 0.5)
        # a² of size 1 from a condition of 1/(distance from the pitchfork) < 1e4.
        assert branch.modulus[1:, 0] ** 2 == pytest.approx(exact, abs=1e-11)
    assert np.all(stable.growth[1:] < 0)
    assert np.all(unstable.growth[1:] > 0)


def test_subharmonic_shows_one_of_three_phases() -> None:
    """N&M, chapter 4: [μ² + (σ − αa²)²] = β²a² has its fold where the discriminant vanishes."""

    def coefficients(s: Any) -> np.ndarray:
        return columns(0.3j, -0.05 - 1j * np.asarray(s), 0.4j)

    flow = of_one((0, 2), (1, 0), (2, 1))
    p = np.linspace(-0.3, 0.5, 201)
    response = response_of(flow, coefficients, p)
    check_every_point(flow, coefficients, response)
    check_complete(flow, coefficients, response, p[::40])
    assert len(response.branches) == 2
    # With x = |B|²: (0.4x − σ)² + μ² = 0.09x. Its discriminant in x is linear in σ.
    fold = (0.05**2 - 0.09**2 / (4 * 0.16)) / (0.09 / 0.4)
    assert kinds(response) == ["saddle-node"]
    assert response.bifurcations[0].parameter == pytest.approx(fold, abs=1e-13)


def test_limit_cycle_from_a_hopf_point() -> None:
    """van der Pol: B' = (m + 0.1i)B − (½ + 0.2i)B|B|², |B|² = 2m, drift 0.1 − 0.4m."""

    def coefficients(m: Any) -> np.ndarray:
        return columns(np.asarray(m) + 0.1j, -0.5 - 0.2j)

    flow = of_one((1, 0), (2, 1), symmetries=((1,),))
    p = np.linspace(-1, 1, 41)
    response = response_of(flow, coefficients, p)
    check_every_point(flow, coefficients, response)
    (hopf,) = response.bifurcations
    assert hopf.kind == "Hopf"
    assert hopf.parameter == pytest.approx(0.0, abs=1e-15)
    assert hopf.frequency == pytest.approx(0.1, abs=1e-15)
    _, cycle = response.branches
    assert cycle.parameter[0] == hopf.parameter
    m = cycle.parameter[1:]
    assert np.abs(cycle.amplitudes[1:, 0]) ** 2 == pytest.approx(2 * m, abs=1e-13)
    assert cycle.drift[1:, 0] == pytest.approx(0.1 - 0.4 * m, abs=1e-13)
    assert cycle.growth[1:] == pytest.approx(-2 * m, abs=1e-13)


# --- two amplitudes -------------------------------------------------------------------------------


def saturation(s: Any) -> np.ndarray:
    """1:2, the second driven; over σ_2, at σ_1 = 0.05, μ = (0.02, 0.03), F = 0.1."""
    s = np.asarray(s)
    return columns(-0.02 - 0.5j * (0.05 + s), -0.03 - 1j * s, -0.5j, -0.25j, -0.0125j)


def test_saturation_along_the_detuning() -> None:
    """|P + |B_1|²| = F/2 with P = 8(μ_1 + i(σ_1 + σ_2)/2)(μ_2 + iσ_2), Nayfeh and Mook, chapter 6.

    Pitchforks of the linear solution at |P| = F/2, folds at |Im P| = F/2 with Re P < 0.
    """
    flow = table([*DAMPED, *QUADRATIC, (1, 0, 0, 0, 0)])
    p = np.linspace(-0.3, 0.3, 241)
    response = response_of(flow, saturation, p)
    check_every_point(flow, saturation, response)
    check_complete(flow, saturation, response, p[::60])
    s = np.poly1d([1.0, 0.0])
    gamma, delta = (0.02, 0.5 * (s + 0.05)), (0.03, s)
    real = 8 * (gamma[0] * delta[0] - gamma[1] * delta[1])
    imaginary = 8 * (gamma[0] * delta[1] + gamma[1] * delta[0])
    folds = [r.real for f in (0.05, -0.05) for r in (imaginary - f).roots if real(r.real) < 0]
    forks = [r.real for r in (real**2 + imaginary**2 - 0.05**2).roots if abs(r.imag) < 1e-12]
    found = {
        k: [b.parameter for b in response.bifurcations if b.kind == k] for k in kinds(response)
    }
    # Roots of polynomials with coefficients of size 1 in doubles.
    assert found["saddle-node"] == pytest.approx(sorted(folds), abs=1e-12)
    assert found["pitchfork"] == pytest.approx(sorted(forks), abs=1e-12)
    saturated = 2 * np.hypot(0.04, 0.05 + response.branches[1].parameter)
    assert response.branches[1].modulus[:, 1] == pytest.approx(saturated, rel=1e-9)
    assert np.all(response.branches[0].amplitudes[:, 0] == 0.0)


def first_driven(s: Any) -> np.ndarray:
    """1:2, the first driven, Ω = ω_1 + σ, no mistuning; N&M, chapter 6."""
    s = np.asarray(s)
    return columns(-0.02 - 1j * s, -0.03 - 2j * s, -0.5j, -0.25j, -0.02j)


def test_hopf_points_of_two_amplitudes() -> None:
    """Two eigenvalues cross the imaginary axis there, with the frequency that is stated.

    The response is even in σ: so are the points. Eigenvalues of size 0.1 of a 4 × 4 matrix.
    """
    flow = table([*DAMPED, *QUADRATIC, FORCE_1])
    p = np.linspace(-0.3, 0.3, 241)
    response = response_of(flow, first_driven, p)
    check_every_point(flow, first_driven, response)
    check_complete(flow, first_driven, response, p[::48])
    hopf = [b for b in response.bifurcations if b.kind == "Hopf"]
    assert len(hopf) == 2
    assert hopf[0].parameter == pytest.approx(-hopf[1].parameter, abs=1e-12)
    for h in hopf:
        c = first_driven(h.parameter)
        values = spectrum(flow, c, h.amplitudes)
        assert np.abs(rates(flow, c, h.amplitudes)).max() < 1e-15
        assert values[:2].real == pytest.approx(0.0, abs=1e-13)
        assert np.abs(values[:2].imag) == pytest.approx([h.frequency] * 2, abs=1e-13)
    # Between them all equilibria at the peak are unstable: the amplitudes are modulated.
    (branch,) = response.branches
    inside = np.abs(branch.parameter) < hopf[1].parameter
    assert np.all(branch.growth[inside] > 0)
    folds = [b.parameter for b in response.bifurcations if b.kind == "saddle-node"]
    assert folds == pytest.approx([-f for f in reversed(folds)], abs=1e-12)


def test_drifting_branches_of_two_amplitudes() -> None:
    """1:3 with the first self-excited: circles of equilibria, their folds and Hopf points."""

    def coefficients(s: Any) -> np.ndarray:
        s = np.asarray(s)
        cubic = (-0.5 - 0.3j, 0.2j, 0.3j, -0.6 - 0.1j, 0.2j, 0.15j)
        return columns(0.3 + 0.1j, 0.2 + 1j * s, *cubic)

    flow = table([*DAMPED, *ONE_TO_THREE], ((1, 3),))
    p = np.linspace(-1, 1, 161)
    response = response_of(flow, coefficients, p)
    check_every_point(flow, coefficients, response)
    check_complete(flow, coefficients, response, p[::40])
    for b in response.bifurcations:
        c = coefficients(b.parameter)
        values = spectrum(flow, c, b.amplitudes, b.drift)[:3]
        if b.kind == "Hopf":
            assert np.abs(values.real).min() < NEUTRAL * np.abs(values).max()
        else:
            # Beside the zero of the symmetry a second one: their errors are the square root of
            # the rounding. The number of equilibria changes by two within 2e-9.
            assert np.abs(values).min() < 1e-6
            beside = coefficients(b.parameter + np.array([-1e-9, 1e-9]))
            assert abs(np.diff(equilibria_of_many(flow, beside).number)) == 2
    assert kinds(response) == ["Hopf", "saddle-node", "Hopf", "saddle-node"]


def test_transcritical_point() -> None:
    """u' = su − u² and v' = −v, B = (u + iv)/2: at s = 0 two branches exchange their stability."""

    def coefficients(s: Any) -> np.ndarray:
        s = np.asarray(s)
        return columns((s - 1) / 2, (s + 1) / 2, -0.5, -1.0, -0.5)

    flow = of_one((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
    response = response_of(flow, coefficients, np.linspace(-0.5, 0.75, 100))
    check_every_point(flow, coefficients, response)
    assert kinds(response) == ["transcritical"]
    assert response.bifurcations[0].parameter == pytest.approx(0.0, abs=1e-14)


def test_a_closed_branch_between_two_sections() -> None:
    """Mathieu–Duffing with a force f(s) that exceeds 2μ for a moment: a² of both signs of the root.

    They meet where f = 2μ, at s = ±w√(ln 1.1); with w = 0.0123 seven of 2001 values lie between.
    """

    def coefficients(s: Any) -> np.ndarray:
        f = 0.11 * np.exp(-((np.asarray(s) / 0.0123) ** 2))
        return columns(0.5j * f, -0.05 - 0.25j, 0.75j)

    flow = of_one((0, 1), (1, 0), (2, 1))
    p = np.linspace(-1, 1, 2001)
    response = response_of(flow, coefficients, p)
    check_every_point(flow, coefficients, response)
    _, closed = response.branches
    end = 0.0123 * np.sqrt(np.log(1.1))
    # From the equation s² = …: p is as good as the rounding over its slope there, 1e-14.
    assert [b.parameter for b in response.bifurcations] == pytest.approx([-end, end], abs=1e-13)
    assert kinds(response) == ["saddle-node"] * 2
    # The first point is the last one as well.
    assert len(closed.parameter) == 2 * 7 + 2 + 1
    assert closed.parameter[0] == closed.parameter[-1]
    assert closed.amplitudes[0] == pytest.approx(closed.amplitudes[-1], abs=1e-14)


def test_two_opposite_real_eigenvalues_are_no_hopf_point() -> None:
    """B' = sB + B̄/2 + 0.1: the eigenvalues are s ± ½, a saddle between −½ and ½."""

    def coefficients(s: Any) -> np.ndarray:
        return columns(0.1, 0.5, np.asarray(s))

    flow = of_one((0, 0), (0, 1), (1, 0))
    response = response_of(flow, coefficients, np.linspace(-0.3, 0.3, 62))
    check_every_point(flow, coefficients, response)
    assert response.bifurcations == ()


def test_a_fold_just_outside_is_none() -> None:
    """The curve leaves the range, turns, and comes back within one step of those who follow it."""
    flow = of_one((0, 0), (1, 0), (2, 1))
    fold = response_of(flow, duffing, np.linspace(-0.3, 1.7, 301)).bifurcations[1].parameter
    for gap in (1e-5, 1e-3, 1e-2):
        p = np.linspace(-0.3, fold - gap, 201)
        response = response_of(flow, duffing, p)
        assert kinds(response) == ["saddle-node"]
        assert len(response.branches) == 2
        check_complete(flow, duffing, response, p[[0, 150, 195, 199, 200]])


@pytest.mark.parametrize("seed", range(8))
def test_random_responses_are_complete(seed: int) -> None:
    """At every value as many points as there are equilibria; with the seeds, folds and Hopf points.

    Saddle-nodes change the number of equilibria by two, and it changes nowhere else.
    """
    numbers = np.random.default_rng(seed)
    terms = {(1, 0), (2, 1), (0, 0)}
    terms |= {tuple(map(int, numbers.integers(0, 3, 2))) for _ in range(2)}
    flow = of_one(*sorted(terms))
    start, way = (numbers.normal(size=(2, len(terms), 2)) @ [1, 1j] for _ in range(2))
    start, way = start[0], way[1]

    def coefficients(s: Any) -> np.ndarray:
        return start + np.asarray(s)[..., None] * way

    p = np.linspace(-0.5, 0.5, 257)
    response = response_of(flow, coefficients, p)
    check_every_point(flow, coefficients, response)
    every = equilibria_of_one(flow, coefficients(p))
    values = np.concatenate([b.parameter for b in response.branches])
    assert [np.sum(values == x) for x in p] == every.number.tolist()
    folds = [b.parameter for b in response.bifurcations if b.kind == "saddle-node"]
    inside = np.histogram(folds, bins=p)[0]
    assert np.all(np.abs(np.diff(every.number)) <= 2 * inside)


# --- arguments ------------------------------------------------------------------------------------


def test_few_values() -> None:
    flow = of_one((0, 0), (1, 0), (2, 1))
    assert response_of(flow, duffing, []).branches == ()
    one = response_of(flow, duffing, [0.4])
    assert [len(b.parameter) for b in one.branches] == [1, 1, 1]
    two = response_of(flow, duffing, [0.4, 0.3, 0.4])
    assert sorted(v for b in two.branches for v in b.parameter) == [0.3] * 3 + [0.4] * 3
    with pytest.raises(ValueError, match="one-dimensional array"):
        response_of(flow, duffing, [[0.1, 0.2]])


def test_frequency_response_of_a_slow_flow() -> None:
    """Over a frequency from which the detuning follows, and over the detuning: the same."""
    left = [d(x, 2) + omega_1**2 * x + alpha * x**3 + mu * d(x) - kappa * sp.cos(Omega * t)]
    scaled = equations(left, [x]).scale({alpha: 1, mu: 1, kappa: 1})
    flow = scaled.expand(1, {Omega: omega_1}).slow_flow
    values = {"omega_1": 2.0, "alpha": 0.6, "mu": 0.1, "kappa": 0.3}
    sigma = np.linspace(-0.1, 0.3, 81)
    by_frequency = flow.frequency_response({**values, Omega: 2.0 + sigma})
    by_detuning = flow.frequency_response({**values, "sigma": sigma}, over="sigma")
    assert by_frequency.name == "Omega"
    assert [b.kind for b in by_frequency.bifurcations] == ["saddle-node"] * 2
    for a, b in zip(by_frequency.bifurcations, by_detuning.bifurcations, strict=True):
        assert a.parameter - 2.0 == pytest.approx(b.parameter, abs=1e-13)
    force = {"kappa": np.linspace(0, 1, 41)[1:], "sigma": 0.1}
    assert flow.frequency_response({**values, **force}).name == "kappa"
    with pytest.raises(MmsgenError, match="exactly one parameter has to be an array"):
        flow.frequency_response({**values, "sigma": 0.1})
    with pytest.raises(MmsgenError, match="only sigma varies, so mu must be a number"):
        flow.frequency_response({**values, "sigma": sigma, "mu": sigma}, over="sigma")
    with pytest.raises(MmsgenError, match="no value is given for beta"):
        flow.frequency_response({**values, "sigma": sigma}, over="beta")
    with pytest.raises(MmsgenError, match="array of one dimension"):
        flow.frequency_response({**values, "sigma": 0.1}, over="sigma")
