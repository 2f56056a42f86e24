"""Derivatives of emitted boundaries, growth rates and critical speeds by every parameter."""

from __future__ import annotations

from functools import cache
from typing import Any

import mpmath
import numpy as np
import pytest
from codegen_systems import PAPER, emitted

from mmsgen.codegen import emitted_functions
from mmsgen.codegen.kernels import EmittedFunction
from mmsgen.codegen.setting import Setting

# Closed forms, a polynomial of a higher degree, polynomials one after another, no zone.
ZONES = ("damped", "pair", "numeric", "coupled", "lossy", "stable")


@cache
def function_of(name: str, function: str) -> EmittedFunction:
    functions = emitted_functions(Setting(emitted(name).case))
    return next(f for f in functions if f.name == function)


def exact_slopes(
    name: str, point: dict[str, Any], parameter: str, function: str = "boundaries"
) -> Any:
    """Differences in 40 digits: a step of 1e-14, squared, leaves ten digits and more.

    The values come from the symbolic criterion, or from the characteristic polynomial, not from
    emitted code.
    """
    boundaries = function_of(name, function)
    assert boundaries.reference is not None
    with mpmath.workdps(40):
        h = mpmath.mpf("1e-14") * abs(point[parameter])
        up, down = (
            boundaries.reference({**point, parameter: point[parameter] + s * h}).values
            for s in (1, -1)
        )
        return [float((a - b) / (2 * h)) for a, b in zip(up, down, strict=True)]


@pytest.mark.parametrize("name", ZONES)
def test_edges_move_as_in_many_digits(name: str) -> None:
    one = emitted(name)
    for stored in one.reference["functions"]["boundaries"][:1]:
        given = stored["arguments"]
        pair, slopes = one.module.boundaries(**given, gradient=True)
        assert list(slopes) == list(given)
        plain = one.module.boundaries(**given)
        assert np.array_equal(pair, plain, equal_nan=True)
        for parameter, own in slopes.items():
            if np.isnan(plain).all():
                assert np.isnan(own).all()
                continue
            point = {n: mpmath.mpf(v) for n, v in given.items()}
            wanted = exact_slopes(name, point, parameter)
            # Rounding of some dozen operations, in units of edge over parameter.
            size = np.abs(wanted).max() + np.abs(plain).max() / abs(given[parameter])
            assert np.abs(np.array(own) - wanted).max() < 1e-12 * size, parameter


def test_shapes_and_missing_edges() -> None:
    """An edge √(f² − 4μ²)/(2ω) of the damped equation of Mathieu, which is not there beyond."""
    module = emitted("damped").module
    f, mu = np.array([0.1, 0.2]), np.array([[0.04], [0.06]])
    (lower, upper), slopes = module.boundaries(omega=1.0, f=f, mu=mu, gradient=True)
    assert slopes["f"][1].shape == (2, 2)
    there = np.isfinite(upper)
    assert there.tolist() == [[True, True], [False, True]]
    for edges in slopes.values():
        assert (np.isfinite(edges[0]) == there).all()
        assert (np.isfinite(edges[1]) == there).all()
    # σ = ±√(f² − 4ω²μ²)/ω: its derivative by f is f/(ω²σ).
    with np.errstate(invalid="ignore"):
        assert slopes["f"][1] == pytest.approx(f / upper, rel=1e-13, nan_ok=True)
        assert slopes["mu"][0] == pytest.approx(-4 * mu / lower, rel=1e-13, nan_ok=True)


# Discriminants, damped quadratics, a conservative polynomial, matrices, nothing but neutral modes.
RATES = ("rotor2", "damped", "pair", "coupled", "lossy", "lossy_both", "stable", "numeric")


@pytest.mark.parametrize("name", RATES)
def test_growth_rates_move_as_in_many_digits(name: str) -> None:
    one = emitted(name)
    for stored in one.reference["functions"]["growth_rate"]:
        given = stored["arguments"]
        rate, slopes = one.module.growth_rate(**given, gradient=True)
        assert rate == pytest.approx(one.module.growth_rate(**given), rel=1e-12, abs=1e-14)
        assert list(slopes) == list(given)
        point = {n: mpmath.mpf(v) for n, v in given.items()}
        for parameter, own in slopes.items():
            (wanted,) = exact_slopes(name, point, parameter, "growth_rate")
            # Roundings of frequencies up to 50 and of what their eigenvalues lose.
            assert own == pytest.approx(wanted, rel=1e-10, abs=1e-12), parameter


def test_growth_rates_of_many_points() -> None:
    """Γ = √(f² − σ²ω²)/2ω − μ of the damped equation of Mathieu."""
    sigma, f = np.linspace(-0.3, 0.3, 7), np.array([[0.1], [0.2]])
    given = {"sigma": sigma, "omega": 1.0, "f": f, "mu": 0.02}
    rate, slopes = emitted("damped").module.growth_rate(**given, gradient=True)
    assert {x.shape for x in slopes.values()} == {rate.shape} == {(2, 7)}
    inside = np.abs(sigma) < f * (1 - 1e-12)
    edge = np.abs(np.abs(sigma) - f) < 1e-12
    assert edge.sum() == 4
    with np.errstate(divide="ignore", invalid="ignore"):
        wanted = np.where(inside, f / np.sqrt(f**2 - sigma**2) / 2, 0.0)
    assert slopes["f"][~edge] == pytest.approx(wanted[~edge], rel=1e-12)
    assert slopes["mu"][~edge] == pytest.approx(np.full((~edge).sum(), -1.0), rel=1e-14)


MORE = {**PAPER, "mu_1": 0.05, "mu_2": 0.05, "mu": 0.05, "omega": 3.0, "f": 0.5, "omega_y": 30.0}


@pytest.mark.parametrize("name", ["rotor", "rotor2", "damped", "lossy", "numeric"])
def test_critical_speeds_move_as_in_many_digits(name: str) -> None:
    speeds = emitted(name).module.critical_speeds
    given = {p.name: MORE[p.name] for p in function_of(name, "critical_speeds").arguments}
    plain = speeds(**given)
    assert np.isfinite(plain).all()
    pair, slopes = speeds(**given, gradient=True)
    assert pair == plain
    assert list(slopes) == list(given)
    point = {n: mpmath.mpf(v) for n, v in given.items()}
    for parameter, own in slopes.items():
        wanted = exact_slopes(name, point, parameter, "critical_speeds")
        # The speed is known to a rounding, and enters the slopes once.
        size = np.abs(wanted).max() + np.abs(plain).max() / abs(given[parameter])
        assert np.abs(np.array(own) - wanted).max() < 1e-11 * size, parameter


def test_without_critical_speeds_there_are_no_slopes() -> None:
    given = {n: PAPER[n] for n in ("r_m", "r_b", "omega_x", "r_a", "omega_b")}
    pair, slopes = emitted("rotor").module.critical_speeds(
        **{**given, "r_a": [0.2, 1.5]}, gradient=True
    )
    for edges in (pair, *slopes.values()):
        assert np.isfinite(edges).tolist() == [[True, False]] * 2
