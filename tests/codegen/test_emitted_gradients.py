"""Derivatives by the parameters: equilibria, their stability, branches and bifurcations."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from nonlinear_systems import CASES, ISOLATED, NUMBERS, functions, points, values

from mmsgen.runtime._flow import Flow
from mmsgen.runtime._slopes import eigenvalue_slopes

# --- equilibria --------------------------------------------------------------------------------


def differences(function: Callable[[float], Any], at: float) -> tuple[Any, float]:
    """Central differences of the fourth order of some arrays, and their step."""
    h = 1e-4 * abs(at)
    sampled = [function(at + k * h) for k in (-2, -1, 1, 2)]
    found = [(x - 8 * y + 8 * z - w) / (12 * h) for x, y, z, w in zip(*sampled, strict=True)]
    return found, h


@pytest.mark.parametrize("name", ISOLATED)
def test_derivatives_of_equilibria(name: str) -> None:
    module, given = functions(name), values(name)
    found, slopes = module.equilibria(**given, gradient=True)
    assert list(slopes) == list(given)
    scale = 1.0 + np.abs(found.amplitudes).max()
    for parameter, number in given.items():
        wanted, h = differences(lambda x: module.equilibria(**{**given, parameter: x}), number)
        for own, other in zip(slopes[parameter], wanted, strict=True):
            assert own.shape == other.shape
            # h⁴ of a fifth derivative that may be 10⁶ times as large near a fold; 1e-15/h.
            assert own == pytest.approx(other, rel=1e-7, abs=1e-10 * scale / h * 1e-4)


def test_derivatives_are_those_of_the_relation_in_print() -> None:
    """a(σ) on [μ² + (σ − ca²)²]a² = K²: da/dσ = (ca² − σ)a/(μ² + (σ − ca²)(σ − 3ca²))."""
    given = {**values("primary1"), "sigma": np.array([-0.3, 0.21, 0.5])}
    found, slopes = functions("primary1").equilibria(**given, gradient=True)
    b, a = found.amplitudes[..., 0], found.modulus[..., 0]
    slope = 4 * (b.conj() * slopes["sigma"].amplitudes[..., 0]).real / a
    mu, sigma = NUMBERS["mu"], given["sigma"][:, None]
    shift = 3 * NUMBERS["alpha"] * a**2 / (8 * NUMBERS["omega"])
    wanted = (shift - sigma) * a / (mu**2 + (sigma - shift) * (sigma - 3 * shift))
    # Cancellation in the denominator, 10³ at most.
    assert slope == pytest.approx(wanted, rel=1e-11, nan_ok=True)


def test_where_equilibria_meet_there_is_no_derivative() -> None:
    """Parametric excitation without damping: zero changes its stability at σ = k/ω."""
    given = {"sigma": [0.5, 0.75], "omega": 1.0, "alpha": 0.3, "k": 0.5, "mu": 0.0}
    found, slopes = functions("swing").equilibria(**given, gradient=True)
    at_rest = slopes["sigma"].amplitudes[:, 0, 0]
    assert (found.amplitudes[:, 0, 0] == 0.0).all()
    assert np.isnan(at_rest[0])
    assert at_rest[1] == 0.0


def at_bifurcation(
    name: str, over: str, where: Any, kind: str, **more: float
) -> tuple[Any, Any, Any]:
    """A bifurcation, the equilibria there, and how they move."""
    given = {**values(name), **more}
    response = functions(name).frequency_response(**{**given, over: where}, over=over)
    point = next(b for b in response.bifurcations if b.kind == kind)
    found, slopes = functions(name).equilibria(**{**given, over: point.parameter}, gradient=True)
    return point, found, slopes


def nearest(point: Any, found: Any) -> Any:
    """The equilibria at a bifurcation: within the square root of the precision of it."""
    away = np.abs(np.abs(found.amplitudes) - np.abs(point.amplitudes)).max(axis=-1)
    return away < 1e-6 * np.abs(point.amplitudes).max()


@pytest.mark.parametrize("name", ["primary1", "primary2", "two"])
def test_at_a_fold_derivatives_are_missing_and_elsewhere_they_are_there(name: str) -> None:
    over = "sigma_2" if name == "two" else "sigma"
    point, found, slopes = at_bifurcation(name, over, np.linspace(-0.2, 1.0, 41), "saddle-node")
    at_fold = nearest(point, found)
    assert 0 < at_fold.sum() < len(at_fold) == found.number
    for own in slopes.values():
        assert np.isnan(own.amplitudes[at_fold]).all()
        assert np.isfinite(own.amplitudes[~at_fold]).all()
    # Close by, the two move apart like the square root of the distance.
    sizes = []
    for distance in (1e-8, 4e-8):
        for side in (-1, 1):
            given = {**values(name), over: point.parameter + side * distance}
            there, moving = functions(name).equilibria(**given, gradient=True)
            assert np.isfinite(moving[over].amplitudes[np.isfinite(there.growth)]).all()
            if there.number > (~at_fold).sum():
                sizes.append(np.abs(moving[over].amplitudes).max())
    # Corrections are of the order of the root of the distance.
    assert sizes[0] / sizes[1] == pytest.approx(2.0, rel=2e-2)


def test_derivatives_at_a_hopf_point_are_there() -> None:
    """The Jacobian is regular there, though the growth rate is zero."""
    more = {"k": 0.5, "mu": 0.01, "nu": 0.01, "sigma_1": 0.05}
    point, found, slopes = at_bifurcation(
        "two", "sigma_2", np.linspace(-0.6, 0.6, 61), "Hopf", **more
    )
    own = nearest(point, found)
    # Located to 1e-10 of the range.
    assert found.growth[own] == pytest.approx(np.zeros(own.sum()), abs=1e-9)
    assert np.isfinite(slopes["sigma_2"].amplitudes[own]).all()


# --- at given amplitudes --------------------------------------------------------------------------


@pytest.mark.parametrize("function", ["jacobian", "stability"])
@pytest.mark.parametrize("name", [n for n in CASES if not n.startswith("free")])
def test_derivatives_at_given_amplitudes(name: str, function: str) -> None:
    given, at = values(name, function), getattr(functions(name), function)
    b = np.vstack([points(name), np.full(len(functions(name).COORDINATES), np.nan)])
    found, slopes = at(b, **given, gradient=True)
    assert found == pytest.approx(at(b, **given), rel=1e-12, abs=1e-12, nan_ok=True)
    assert list(slopes) == list(given)
    for parameter, number in given.items():
        (wanted,), h = differences(lambda x: [at(b, **{**given, parameter: x})], number)
        # As above.
        assert slopes[parameter].shape == wanted.shape
        assert slopes[parameter] == pytest.approx(wanted, rel=1e-7, abs=1e-13 / h, nan_ok=True)


def test_where_eigenvalues_meet_there_is_no_derivative() -> None:
    """Without damping the phase of a free motion goes with its circle, and its radius stays."""
    given = {"alpha": 0.3, "omega": 1.3}
    module = functions("free1")
    values, slopes = module.stability([0.5], **given, gradient=True)
    assert values[0] == slopes["alpha"][0] == 0.0
    assert np.isnan([values[1], slopes["alpha"][1]]).all()
    assert np.isfinite(module.jacobian([0.5], **given, gradient=True)[1]["alpha"]).all()
    # At rest nothing goes round, and both have one real part.
    matrices = np.array([[1.0, 2.0], [0.0, 1.0]])
    flow = Flow(1, ((0, (1, 0, 0)),))
    change = np.ones((1, 2, 2))
    slopes = eigenvalue_slopes(flow, matrices, change, np.array([0.5]), held=True)[1]
    assert np.isnan(slopes).all()


def test_parameters_broadcast_with_amplitudes() -> None:
    given = {**values("primary1"), "mu": np.array([0.01, 0.02, 0.03])}
    for function, shape in (("jacobian", (2, 3, 2, 2)), ("stability", (2, 3, 2))):
        at = getattr(functions("primary1"), function)
        slopes = at(points("primary1")[:, None], **given, gradient=True)[1]
        assert {x.shape for x in slopes.values()} == {shape}
        alone = at(points("primary1")[1], **{**given, "mu": 0.02}, gradient=True)[1]
        for parameter, slope in slopes.items():
            assert slope[1, 1] == pytest.approx(alone[parameter], rel=1e-13)


# --- along a parameter ----------------------------------------------------------------------------


def test_a_response_moves_like_its_equilibria() -> None:
    given = {**values("primary1"), "sigma": np.linspace(-0.2, 1.0, 25)}
    plain = functions("primary1").frequency_response(**given)
    found, slopes = functions("primary1").frequency_response(**given, gradient=True)
    assert list(slopes) == list(values("primary1"))
    assert len(found.branches) == len(plain.branches)
    for k, branch in enumerate(found.branches):
        at = {**given, "sigma": branch.parameter}
        each, moving = functions("primary1").equilibria(**at, gradient=True)
        nearest = np.abs(np.abs(each.amplitudes - branch.amplitudes[:, None])[..., 0])
        row, place = np.arange(len(nearest)), np.nanargmin(nearest, axis=1)
        for parameter, own in moving.items():
            branches = slopes[parameter].branches[k]
            for one, other in zip(branches, own, strict=True):
                if not one.size:  # no drift
                    continue
                known = np.isfinite(one) & np.isfinite(other[row, place])
                assert known.mean() > 0.9  # missing at the folds
                # Roundings of the amplitudes, 1e-15, over the smallest eigenvalue, 1e-3, squared.
                assert one[known] == pytest.approx(other[row, place][known], rel=1e-7, abs=1e-9)


LOOSE = {"k": 0.5, "mu": 0.01, "nu": 0.01, "sigma_1": 0.05}


@pytest.mark.parametrize(
    ("name", "over", "more", "kinds"),
    [
        ("primary1", "sigma", {}, {"saddle-node"}),
        ("primary1", "k", {"sigma": 0.3}, {"saddle-node"}),
        ("swing", "sigma", {}, {"pitchfork"}),
        ("two", "sigma_2", LOOSE, {"saddle-node", "pitchfork", "Hopf"}),
    ],
)
def test_how_bifurcations_move(name: str, over: str, more: Any, kinds: set[str]) -> None:
    respond, given = functions(name).frequency_response, {**values(name), **more}
    given[over] = np.linspace(0.01, 0.7, 36) if over == "k" else np.linspace(-0.6, 0.9, 61)
    found, slopes = respond(**given, over=over, gradient=True)
    assert {b.kind for b in found.bifurcations} == kinds
    assert np.isnan(slopes[over].bifurcations).all()
    for parameter in ({"k", "mu", "sigma_1"} if name == "two" else set(given)) - {over}:

        def places(x: float, parameter: str = parameter) -> Any:
            again = respond(**{**given, parameter: x}, over=over)
            return [np.array([b.parameter for b in again.bifurcations])]

        h = 1e-3 * abs(given[parameter])
        lower, upper = (places(given[parameter] + k * h)[0] for k in (-1, 1))
        wanted = (upper - lower) / (2 * h)
        # h² of a third derivative, up to 10³ times as large; places to 1e-10 over h.
        assert slopes[parameter].bifurcations == pytest.approx(wanted, rel=1e-3, abs=1e-9 / h)


def test_pitchforks_move_as_in_print() -> None:
    """σ² = (k/ω)² − 4μ²."""
    given = {"alpha": 0.3, "k": 0.25, "mu": 0.05, "omega": 1.2, "sigma": np.linspace(-0.5, 0.5, 31)}
    found, slopes = functions("swing").frequency_response(**given, gradient=True)
    sigma = np.array([b.parameter for b in found.bifurcations])
    exact = {"alpha": 0.0, "k": 0.25 / 1.2**2, "mu": -0.2, "omega": -(0.25**2) / 1.2**3}
    for parameter, above in exact.items():
        # The place is known to 1e-10 of the range.
        assert slopes[parameter].bifurcations == pytest.approx(above / sigma, rel=1e-8, abs=1e-12)
