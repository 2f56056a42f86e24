"""Emitted functions of nonlinear slow flows: equilibria, stability, and how both move."""

from __future__ import annotations

import ast
from typing import Any

import mpmath
import numpy as np
import pytest
from codegen_systems import stored
from nonlinear_systems import CASES, ISOLATED, NUMBERS, functions, nonlinear, points, values

# --- reference values -----------------------------------------------------------------------------


@pytest.mark.parametrize("name", CASES)
def test_within_the_bound_of_the_running_error_analysis(name: str) -> None:
    functions_seen = set()
    with mpmath.workdps(30):
        for function, arguments, result, exact, errors in stored(nonlinear(name)):
            functions_seen.add(function)
            for got, value, error in zip(result, exact, errors, strict=True):
                if mpmath.isnan(value):
                    assert np.isnan(got)
                    continue
                off = abs(mpmath.mpmathify(got) - value)
                assert off <= error, (function, arguments, got)
    assert {"slow_flow", "response", "jacobian", "stability"} <= functions_seen
    assert ("equilibria" in functions_seen) == (name in ISOLATED)


# --- stability ------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [n for n in CASES if n not in ("free1", "free2", "free3")])
def test_the_jacobian_is_the_derivative_of_the_slow_flow(name: str) -> None:
    """In a frame that turns at the drift, where there is a symmetry."""
    module, given = functions(name), values(name, "jacobian")
    b = points(name)
    flow = module._FLOW
    rates = module.slow_flow(b, **given)
    turn = np.zeros(b.shape)
    if flow.symmetries:
        (k,) = np.array(flow.symmetries)
        weight = (k**2 * np.abs(b) ** 2).sum(-1)
        turn = ((k * b.conj() * rates).imag.sum(-1) / weight)[:, None] * k
    h = 1e-5
    found = module.jacobian(b, **given)
    for column in range(2 * b.shape[-1]):
        step = np.zeros(b.shape[-1], dtype=complex)
        step[column // 2] = h / 2 * (1j if column % 2 else 1)

        def moved(c: Any) -> Any:
            return module.slow_flow(c, **given) - 1j * turn * c

        slope = 2 * (moved(b + step) - moved(b - step)) / (2 * h)
        wanted = np.stack([slope.real, slope.imag], -1).reshape(len(b), -1)
        # h² of the third derivatives, which are below 10, and 1e-16/h of rounding.
        assert found[..., column] == pytest.approx(wanted, abs=2e-9)


@pytest.mark.parametrize("name", ISOLATED)
def test_stability_at_equilibria_is_what_they_say(name: str) -> None:
    module, given = functions(name), values(name)
    found = module.equilibria(**given)
    eigenvalues = module.stability(found.amplitudes, **given)
    assert eigenvalues.shape == (*found.growth.shape, 2 * len(module.COORDINATES))
    size = np.nanmax(np.abs(eigenvalues))
    # Eigenvalues of a matrix of this size, and the square root of the precision near a double one.
    assert eigenvalues[..., 0].real == pytest.approx(found.growth, abs=1e-7 * size, nan_ok=True)


def test_what_is_missing_is_missing() -> None:
    module, given = functions("primary1"), values("primary1")
    b = np.array([[np.nan], [0.3]])
    assert np.isnan(module.stability(b, **given)).tolist() == [[True, True], [False, False]]
    assert np.isnan(module.jacobian(b, **given)).all(axis=(-2, -1)).tolist() == [True, False]
    with pytest.raises(ValueError, match="amplitudes must be finite"):
        module.stability([np.inf], **given)
    with pytest.raises(ValueError, match="shapes that do not broadcast together: amplitudes"):
        module.jacobian(np.ones((3, 1)), **{**given, "mu": np.ones(2)})
    with pytest.raises(ValueError, match="mu must be finite and not negative"):
        module.stability(b, **{**given, "mu": -1.0})


# --- equilibria -----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ISOLATED)
def test_equilibria_stay_at_rest_or_drift(name: str) -> None:
    module, given = functions(name), values(name)
    found = module.equilibria(**given)
    rates = module.slow_flow(found.amplitudes, **given)
    symmetries = np.array(module._FLOW.symmetries).reshape(-1, len(module.COORDINATES))
    drift = 1j * (found.drift @ symmetries) * found.amplitudes
    # A few roundings of terms that are below one.
    assert np.abs(rates - drift).max() < 1e-14
    engine = nonlinear(name).case.slow_flow.equilibria(given)
    assert found.amplitudes == pytest.approx(engine.amplitudes, rel=1e-12, abs=1e-12)


def test_primary_resonance_in_print() -> None:
    """Nayfeh and Mook (1979), chapter 4: [μ² + (σ − 3αa²/8ω)²]a² = k²/4ω²."""
    given = {**values("primary1"), "sigma": np.linspace(-0.4, 0.6, 9)}
    found = functions("primary1").equilibria(**given)
    a, sigma = found.modulus[..., 0], given["sigma"][:, None]
    shift = 3 * NUMBERS["alpha"] * a**2 / (8 * NUMBERS["omega"])
    left = (NUMBERS["mu"] ** 2 + (sigma - shift) ** 2) * a**2
    right = NUMBERS["k"] ** 2 / (4 * NUMBERS["omega"] ** 2)
    there = np.isfinite(a)
    assert set(there.sum(axis=1)) == {1, 3}
    # Where (σ − shift)² is a small difference, rounding of a grows by shift/|σ − shift| < 10³.
    assert left[there] == pytest.approx(np.full(there.sum(), right), rel=1e-12)


def test_subharmonic_resonance_in_print() -> None:
    found = functions("sub").equilibria(sigma=6.0, omega=1.0, alpha=1.0, mu=0.05, K=8.0)
    sizes = np.unique(np.round(found.modulus[:, 0], 8))
    assert sizes.tolist() == [0.0, 1.39465604, 2.39198687]
    assert len(found.modulus) == 7  # zero, and three phases of each
    assert found.stable[np.round(found.modulus[:, 0], 8) == 2.39198687].all()


def test_infinitely_many_equilibria_are_told() -> None:
    with pytest.raises(ValueError, match="not isolated"):
        functions("free2").equilibria(alpha=0.1, omega=1.0)


def test_a_linear_oscillator_driven_in_resonance_without_damping_has_no_equilibrium() -> None:
    """|B| = k/(4ωμ) otherwise, a formula that is k/0 there."""
    driven, mu = functions("driven").equilibria, np.array([0.0, 0.1])
    found, slopes = driven(sigma=0.0, k=0.2, mu=mu, omega=1.0, gradient=True)
    assert found.number.tolist() == [0, 1]
    assert np.isnan(found.amplitudes[0]).all()
    assert np.isnan(slopes["k"].amplitudes[0]).all()
    b = found.amplitudes[1, 0, 0]
    assert abs(b) == pytest.approx(0.2 / 0.4, rel=1e-14)
    assert slopes["k"].amplitudes[1, 0, 0] == pytest.approx(b / 0.2, rel=1e-13)
    none = driven(sigma=0.0, k=0.2, mu=0.0, omega=1.0)
    assert none.amplitudes.shape == (0, 1)


# --- the text -------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["primary2", "pol", "two"])
def test_the_table_in_the_text_is_that_of_the_engine(name: str) -> None:
    module = functions(name)
    assert module._FLOW == nonlinear(name).case.slow_flow.table.flow
    tree = ast.parse(nonlinear(name).text)
    assert ast.get_docstring(tree)


def test_what_there_is() -> None:
    everywhere = {"slow_flow", "response", "equilibria", "frequency_response", "jacobian"}
    everywhere.add("stability")
    for name in CASES:
        assert everywhere <= set(functions(name).__all__)


# --- backbones ------------------------------------------------------------------------------------


def test_backbones_in_print() -> None:
    a = np.array([0.0, 0.5, 1.0])
    given = {"alpha": 0.3, "omega": 1.3}
    y = 0.3 * a**2 / 1.3**2
    # Duffing's equation: ω(1 + 3y/8 − 15y²/256), of which the shift is given.
    found = functions("free2").backbone(a, **given)
    assert found == pytest.approx(1.3 * (3 * y / 8 - 15 * y**2 / 256), rel=1e-14)
    # Primary resonance: the detuning is that shift.
    found = functions("primary1").backbone(a, **given, k=0.1, mu=0.1)
    assert found == pytest.approx(1.3 * 3 * y / 8, rel=1e-14)
    # Van der Pol's, on its limit cycle a = 2: −μ²/16 at ω = 1.
    assert functions("pol").backbone(2.0, mu=0.2, omega=1.0) == pytest.approx(-0.04 / 16, rel=1e-14)


def test_normal_modes() -> None:
    """At the detuning that is given they are at rest in slow_flow, but for the force.

    So they are in the engine, whose flow without forces and damping the function has.
    """
    given = {"alpha": 0.3, "omega_1": 1.1, "sigma_1": 0.05}
    rest = {"k": 0.2, "mu": 0.0, "nu": 0.0}
    module, a = functions("two"), np.array([[0.2], [0.7]])
    found = module.backbone(a, **given, **rest, of="u")
    assert found.amplitudes.shape == (2, 1, 2, 2)
    assert np.all(found.number == 2)
    assert found.modulus[..., 0] == pytest.approx(np.broadcast_to(a[..., None], (2, 1, 2)))
    given["sigma_2"] = found.detuning
    force = module.slow_flow([0.0, 0.0], **given, **rest)
    left = module.slow_flow(found.amplitudes, **given, **rest) - force
    # Sums of a few terms below one.
    assert np.abs(left).max() < 1e-14
    # Shifts from ω_1 and 2ω_1: w is twice as fast as u.
    assert 2 * found.shift[..., 0] == pytest.approx(found.shift[..., 1], abs=1e-13)
    damped = nonlinear("two").case.slow_flow.backbone(
        {"alpha": 0.3, "omega_1": 1.1, "sigma_1": 0.05, "nu": 0.1, "mu": 0.2, "k": 0.2},
        a,
        nonlinear("two").case.coordinates[0],
    )
    for mine, other in zip(found, damped, strict=True):
        assert mine == pytest.approx(other, abs=1e-13)
    with pytest.raises(ValueError, match="of must be one of u, w, got 'v'"):
        module.backbone(0.2, alpha=0.3, omega_1=1.1, sigma_1=0.05, **rest, of="v")


def test_a_backbone_goes_through_the_drift_of_free_motions() -> None:
    """dγ/dt of slow_flow at every amplitude, the other way to compute it."""
    given, b = {"alpha": 0.3, "omega": 1.3}, np.array([[0.1], [0.4 - 0.3j]])
    rate = (functions("free3").slow_flow(b, **given) / (1j * b)).real[:, 0]
    found = functions("free3").backbone(2 * np.abs(b[:, 0]), **given)
    assert found == pytest.approx(rate, rel=1e-13)


def test_derivatives_of_a_backbone() -> None:
    a, alpha, omega = np.array([0.3, 0.9]), 0.4, 1.3
    value, slopes = functions("free2").backbone(a, alpha=alpha, omega=omega, gradient=True)
    assert value.shape == (2,)
    y = a**2 / omega
    by_alpha = 3 * y / 8 - 30 * alpha * y**2 / omega / 256
    by_omega = -3 * alpha * y / omega / 8 + 45 * alpha**2 * y**2 / omega**2 / 256
    assert slopes["alpha"] == pytest.approx(by_alpha, rel=1e-14)
    assert slopes["omega"] == pytest.approx(by_omega, rel=1e-14)


@pytest.mark.parametrize("amplitude", [-0.1, np.nan, np.inf, 1j, "1", [0.1, -0.2]])
def test_what_is_no_amplitude(amplitude: Any) -> None:
    with pytest.raises(ValueError, match="the amplitude must be finite and not negative"):
        functions("free1").backbone(amplitude, alpha=0.3, omega=1.3)


def test_backbone_shapes() -> None:
    backbone = functions("free1").backbone
    assert backbone(np.zeros(3), alpha=np.ones((2, 1)), omega=1.0).shape == (2, 3)
    with pytest.raises(ValueError, match=r"do not broadcast together: the amplitude \(3,\)"):
        backbone(np.zeros(3), alpha=np.ones(2), omega=1.0)
