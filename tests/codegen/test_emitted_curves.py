"""The emitted `frequency_response`: points on branches, bifurcations in print, its arguments."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from nonlinear_systems import functions

DUFFING = {"alpha": 0.3, "k": 0.25, "mu": 0.03, "omega": 1.3}
TWO = {"sigma_1": 0.03, "alpha": 0.3, "k": 0.25, "mu": 0.03, "nu": 0.05, "omega_1": 1.1}


def response(name: str, **arguments: Any) -> Any:
    return functions(name).frequency_response(**arguments)


def demand_at_rest(name: str, found: Any, **fixed: Any) -> None:
    """Every point of every branch is an equilibrium, and as stable as it says."""
    module = functions(name)
    for branch in found.branches:
        given = {**fixed, found.name: branch.parameter}
        symmetries = np.array(module._FLOW.symmetries).reshape(-1, len(module.COORDINATES))
        turning = 1j * (branch.drift @ symmetries) * branch.amplitudes
        rates = module.slow_flow(branch.amplitudes, **given)
        # A few roundings of terms below one.
        assert np.abs(rates - turning).max() < 1e-13
        eigenvalues = module.stability(branch.amplitudes, **given)
        # The square root of the precision where two eigenvalues meet.
        assert branch.growth == pytest.approx(eigenvalues[:, 0].real, abs=1e-7)


def test_folds_of_the_primary_resonance() -> None:
    """[μ² + (σ − ca²)²]a² = K² is a cubic in a²: folds are where its discriminant vanishes."""
    sigma = np.linspace(-0.2, 1.0, 41)
    found = response("primary1", sigma=sigma, **DUFFING)
    assert found.name == "sigma"
    c = 3 * DUFFING["alpha"] / (8 * DUFFING["omega"])
    force = DUFFING["k"] ** 2 / (4 * DUFFING["omega"] ** 2)
    mu = DUFFING["mu"]
    # In y = ca²: y³ − 2σy² + (μ² + σ²)y − cK², with its discriminant as a polynomial in σ.
    s = np.polynomial.Polynomial([0, 1])
    b, d, e = -2 * s, s**2 + mu**2, -c * force
    discriminant = 18 * b * d * e - 4 * b**3 * e + b**2 * d**2 - 4 * d**3 - 27 * e**2
    roots = discriminant.roots()
    wanted = np.sort(roots[np.abs(roots.imag) < 1e-9].real)
    wanted = wanted[(wanted > sigma[0]) & (wanted < sigma[-1])]
    assert len(wanted) == 2
    kinds = [b.kind for b in found.bifurcations]
    assert kinds == ["saddle-node", "saddle-node"]
    places = [b.parameter for b in found.bifurcations]
    # Roots of a polynomial of the fifth degree whose coefficients span four decades.
    assert places == pytest.approx(wanted, abs=1e-8)
    demand_at_rest("primary1", found, **DUFFING)


def test_pitchforks_of_parametric_excitation() -> None:
    """Nayfeh and Mook (1979), chapter 5: the rest is unstable for σ² < (k/ω)² − 4μ²."""
    given = {"alpha": 0.3, "k": 0.25, "mu": 0.05, "omega": 1.0}
    found = response("swing", sigma=np.linspace(-0.5, 0.5, 31), **given)
    places = [b.parameter for b in found.bifurcations if b.kind == "pitchfork"]
    edge = (0.25**2 - 4 * 0.05**2) ** 0.5
    # Located to 1e-10 of the range.
    assert places == pytest.approx([-edge, edge], abs=1e-9)
    demand_at_rest("swing", found, **given)


def test_over_any_parameter() -> None:
    """Along the force at a fixed detuning: the same equilibria as one by one."""
    force = np.linspace(0.01, 0.7, 25)
    given = {**DUFFING, "sigma": 0.3}
    del given["k"]
    found = response("primary1", k=force, over="k", **given)
    assert found.name == "k"
    assert len(found.bifurcations) == 2
    demand_at_rest("primary1", found, **given)
    alone = functions("primary1").equilibria(k=force, **given)
    for k, value in enumerate(force):
        near = [b.modulus[b.parameter == value] for b in found.branches]
        sizes = np.sort(np.concatenate(near).ravel())
        wanted = alone.modulus[k][np.isfinite(alone.modulus[k])]
        assert sizes == pytest.approx(np.sort(wanted), rel=1e-10)


def test_two_amplitudes() -> None:
    found = response("two", sigma_2=np.linspace(-0.2, 0.2, 41), over="sigma_2", **TWO)
    assert found.name == "sigma_2"
    assert {b.kind for b in found.bifurcations} >= {"pitchfork"}
    demand_at_rest("two", found, **TWO)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"sigma": 0.1}, "sigma, which varies, must be an array of one dimension, got the shape"),
        ({"sigma": np.zeros((2, 2))}, "must be an array of one dimension"),
        ({"sigma": [0.1, np.nan]}, "sigma must be finite"),
        ({"sigma": [0.1], "over": "tau"}, "over must be one of sigma, alpha, k, mu, omega"),
        ({"sigma": [0.1], "over": None}, "over must be one of"),
        ({"sigma": [0.1, 0.2], "over": "mu"}, "mu, which varies"),
        ({"sigma": [0.1, 0.2], "k": [0.1, 0.2]}, "only sigma may be an array"),
    ],
)
def test_what_varies(arguments: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        response("primary1", **{**DUFFING, **arguments})


def test_nothing_to_follow() -> None:
    found = response("primary1", sigma=np.zeros(0), **DUFFING)
    assert (found.branches, found.bifurcations) == ((), ())
    single = response("primary1", sigma=[0.1], **{**DUFFING, "mu": [0.03]})
    assert sum(len(b.parameter) for b in single.branches) == 1
    with pytest.raises(ValueError, match="not isolated"):
        functions("free2").frequency_response(alpha=[0.1, 0.2], omega=1.0)
