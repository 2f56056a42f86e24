"""Derivatives of emitted boundaries by every parameter."""

from __future__ import annotations

from functools import cache
from typing import Any

import mpmath
import numpy as np
import pytest
from codegen_systems import emitted

from mmsgen.codegen import emitted_functions
from mmsgen.codegen.kernels import EmittedFunction
from mmsgen.codegen.setting import Setting

# Closed forms, a polynomial of a higher degree, polynomials one after another, no zone.
ZONES = ("damped", "pair", "numeric", "coupled", "lossy", "stable")


@cache
def boundaries_of(name: str) -> EmittedFunction:
    functions = emitted_functions(Setting(emitted(name).case))
    return next(f for f in functions if f.name == "boundaries")


def exact_slopes(name: str, point: dict[str, Any], parameter: str) -> Any:
    """Differences of the edges in 40 digits: a step of 1e-14, squared, leaves ten digits and more.

    The edges come from the symbolic criterion, not from emitted code.
    """
    boundaries = boundaries_of(name)
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
