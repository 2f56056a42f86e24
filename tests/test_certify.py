"""Certificates: right cases hold with the exponent N + 1, wrong functions do not."""

from __future__ import annotations

import functools
from collections.abc import Callable
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import rotor
import sympy as sp
from certify_systems import (
    COARSE,
    DIFFERENCE,
    MATHIEU,
    PAIR,
    PRINCIPAL,
    STRONG,
    SUM,
    Omega,
    f,
    kappa,
    mathieu,
    mu,
    omega,
    omega_1,
    omega_2,
    pair,
    system,
)
from systems import d, linear_rotor, t, x, y

import mmsgen as mg
from mmsgen.certify import EDGE_EPSILONS, EPSILONS, predicted_exponents, scaled_values
from mmsgen.expansion import Expansion
from mmsgen.loading import load
from mmsgen.scaling import ScaledSystem


@cache
def sum_case(order: int = 1) -> tuple[Expansion, Any]:
    case = pair().expand(order, SUM)
    return case, load(case)


# --- right cases ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("scaled", "relation", "order", "values", "epsilons", "zone"),
    [
        (mathieu, PRINCIPAL, 1, MATHIEU, None, True),
        (mathieu, PRINCIPAL, 2, MATHIEU, None, True),
        pytest.param(mathieu, PRINCIPAL, 3, STRONG, COARSE, True, marks=pytest.mark.slow),
        (mathieu, None, 1, {**MATHIEU, "Omega": 3.3}, None, False),
        (mathieu, None, 3, {**STRONG, "Omega": 3.3}, COARSE, False),
        (pair, SUM, 1, PAIR, None, True),
        pytest.param(pair, SUM, 2, PAIR, None, True, marks=pytest.mark.slow),
        pytest.param(pair, SUM, 3, PAIR, COARSE, True, marks=pytest.mark.slow),
        (pair, DIFFERENCE, 1, PAIR, None, False),
        (pair, DIFFERENCE, 2, PAIR, None, False),
        (pair, DIFFERENCE, 3, PAIR, None, False),
    ],
)
def test_right_cases_hold_with_the_exponent_of_their_order(
    scaled: Callable[[], ScaledSystem],
    relation: dict | None,
    order: int,
    values: dict,
    epsilons: tuple[float, ...] | None,
    zone: bool,
) -> None:
    values = values if relation else {k: v for k, v in values.items() if k != "sigma"}
    certificate = mg.certify(scaled().expand(order, relation), values, epsilons=epsilons)
    certificate.demand()
    quantities = ["characteristic exponents", *(["edges of the zone"] if zone else [])]
    assert [fit.quantity for fit in certificate.fits] == quantities
    for fit in certificate.fits:
        assert fit.theory == order + 1
        # generic values, so that no error term vanishes; the fit itself errs by the third term of
        # the error, as for TOLERANCE
        assert abs(fit.exponent - (order + 1)) < 0.1


def test_principal_resonance_of_second_order() -> None:
    """Ω = ω, a zone that opens like ε², from damping of order ε²."""
    case = mathieu(2).expand(2, {Omega: omega})
    values = {"omega": 2.3, "f": 5.9, "mu": 0.02, "sigma": 0.31}
    certificate = mg.certify(case, values, epsilons=COARSE)
    assert certificate.passed
    assert len(certificate.fits) == 2


def test_zones_that_growth_cannot_show_take_no_part() -> None:
    """At small ε this zone grows by less than Floquet's threshold: no error, and no failure."""
    case = mathieu(2).expand(2, {Omega: omega})
    values = {"omega": 2.3, "f": 5.9, "mu": 0.02, "sigma": 0.31}
    epsilons = [*COARSE, 2.0**-12]
    edges = mg.certify(case, values, epsilons=epsilons).fits[1]
    assert edges.resolved[-1] is False
    assert np.isnan(edges.errors[-1])


def test_self_excited_without_any_relation() -> None:
    left = d(x, 2) - 2 * mu * d(x) + omega**2 * x
    case = system([left], [x], {mu: 1}).expand(2)
    certificate = mg.certify(case, {"omega": 2.3, "mu": 1.1}, epsilons=COARSE)
    assert certificate.relation == "none"
    # λ = μ ± i√(ω² − μ²): the expansion ends at μ²/2ω, its next term is of order 4
    assert certificate.fits[0].exponent == pytest.approx(4, abs=0.1)
    assert certificate.passed


def test_order_1_in_the_middle_of_the_zone_is_off_by_a_cube() -> None:
    """Ω = ω_x + ω_φ exactly, ω_φ = 11 rad/s, at the numbers of the paper.

    The expected figures are those of the design; they were found by a program without expansions.
    """
    eom = linear_rotor(4)
    r_m, r_b, w_x, w_phi = (
        next(p.symbol for p in eom.parameters if p.name == n)
        for n in ("r_m", "r_b", "omega_x", "omega_phi")
    )
    (speed,) = (p.symbol for p in eom.parameters if p.name == "Omega")
    flow = eom.scale({r_m: 1, r_b: 1}).expand(1, {speed: w_x + w_phi}).slow_flow
    paper = {n: rotor.PAPER_VALUES[n] for n in ("r_m", "r_b", "omega_x", "omega_y")}
    paper["omega_phi"] = 11.0
    differences = []
    for epsilon in (1, 1 / 2, 1 / 4, 1 / 8):
        values = {**paper, "r_m": paper["r_m"] * epsilon, "r_b": paper["r_b"] * epsilon}
        growth = float(flow.growth_rate({**values, "sigma": 0.0}))
        exact = mg.floquet.growth_rate(eom, {**values, "Omega": paper["omega_x"] + 11.0})
        # the reference is known far better than the two digits compared
        assert exact.error < 1e-8
        differences.append(f"{abs(growth - float(exact)):.1e}")
    assert differences == ["9.4e-03", "1.2e-03", "1.6e-04", "2.0e-05"]


# --- wrong functions ------------------------------------------------------------------------------


def changed(module: Any, **functions: Any) -> SimpleNamespace:
    """A module with some functions replaced; None takes one out."""
    table = {**vars(module), **functions}
    return SimpleNamespace(**{name: v for name, v in table.items() if v is not None})


def multiplied(function: Callable[..., Any], change: Callable[[Any], Any]) -> Callable[..., Any]:
    @functools.wraps(function)
    def wrapped(*args: Any, **kwargs: Any) -> Any:
        return change(function(*args, **kwargs))

    return wrapped


def entry(i: int, j: int, factor: complex) -> Callable[[Any], Any]:
    def change(matrix: Any) -> Any:
        result = np.array(matrix)
        assert result[..., i, j] != 0
        result[..., i, j] *= factor
        return result

    return change


@pytest.mark.parametrize("factor", [1.01, 0.99, -1])
@pytest.mark.parametrize(("i", "j"), [(0, 1), (1, 0), (1, 1)])
def test_a_wrong_coefficient_fails(i: int, j: int, factor: float) -> None:
    case, module = sum_case()
    wrong = multiplied(module.slow_flow_matrix, entry(i, j, factor))
    # without boundaries, to see the exponents alone
    wrong_module = changed(module, slow_flow_matrix=wrong, boundaries=None)
    certificate = mg.certify(case, PAIR, functions=wrong_module)
    assert not certificate.passed
    fit = certificate.fits[0]
    assert certificate.failure == (
        "characteristic exponents of Omega = omega_1 + omega_2 at order 1: the error falls like "
        f"ε^{fit.exponent:.2f}, the theory demands ε^2"
    )
    with pytest.raises(mg.CertificateError, match="characteristic exponents of Omega = omega_1"):
        certificate.demand()
    assert "FAILS" in str(certificate)


@pytest.mark.parametrize(("i", "j"), [(0, 1), (2, 0), (3, 3)])
def test_a_hundredth_of_one_coefficient_of_one_blade_is_seen(i: int, j: int) -> None:
    """Other exponents err far more: only ε small enough tells the orders apart."""
    case, module = rotor_case()
    wrong = multiplied(module.slow_flow_matrix, entry(i, j, 1.01))
    wrong_module = changed(module, slow_flow_matrix=wrong, boundaries=None)
    assert not mg.certify(case, ROTOR, functions=wrong_module).passed
    right = changed(module, boundaries=None)
    assert mg.certify(case, ROTOR, functions=right).passed


@cache
def rotor_case() -> tuple[Expansion, Any]:
    eom = linear_rotor(4)
    s = {p.name: p.symbol for p in eom.parameters}
    scaled = eom.scale({"r_m": 1, "r_b": 1})
    case = scaled.expand(1, {s["Omega"]: s["omega_x"] + s["omega_phi"]})
    return case, load(case)


ROTOR = {
    **{"r_m": 0.05, "r_b": 0.3, "omega_x": 18.7, "omega_y": 25.9, "omega_phi": 11.3},
    "sigma": 0.31,
}


@pytest.mark.parametrize(
    "change",
    [lambda e: (e[0], 1.001 * e[1]), lambda e: (e[0] - 1e-3, e[1]), lambda e: (e[0], e[1] + 1e-3)],
)
def test_wrong_edges_fail(change: Callable[[Any], Any]) -> None:
    case, module = sum_case()
    wrong = changed(module, boundaries=multiplied(module.boundaries, change))
    certificate = mg.certify(case, PAIR, functions=wrong)
    assert [fit.passed for fit in certificate.fits] == [True, False]
    assert certificate.failure.startswith(
        "edges of the zone of Omega = omega_1 + omega_2 at order 1: the error falls like ε^"
    )


@pytest.mark.parametrize(
    ("name", "change", "message"),
    [
        ("growth_rate", lambda g: 1.001 * g, "growth_rate is off the eigenvalues"),
        ("growth_rate", lambda g: np.nan * g, "growth_rate is off the eigenvalues"),
        ("characteristic_coefficients", lambda c: c * [1, 1, 1.0001, 1, 1], "characteristic_coef"),
        ("slow_flow", lambda s: s * [1, 1.0001], "slow_flow is not slow_flow_matrix times"),
        ("slow_flow", np.conj, "slow_flow is not slow_flow_matrix times"),
        ("slow_flow_matrix", lambda m: m * np.nan, "no numbers"),
    ],
)
def test_functions_that_contradict_the_certified_ones(
    name: str, change: Callable[[Any], Any], message: str
) -> None:
    case, module = sum_case()
    n = module.characteristic_coefficients(**{k: PAIR[k] for k in PAIR if k != "f"}).size
    if name == "characteristic_coefficients":
        change = functools.partial(lambda c, k: c * (1 + 1e-4 * (np.arange(k) == k - 1)), k=n)
    wrong = changed(module, boundaries=None, **{name: multiplied(getattr(module, name), change)})
    with np.errstate(invalid="ignore"), pytest.raises(mg.CertificateError, match=message) as info:
        mg.certify(case, PAIR, functions=wrong)
    assert str(info.value).startswith("Omega = omega_1 + omega_2 at order 1: ")


def test_edges_that_are_lost_or_turned_round() -> None:
    case, module = sum_case()
    for change in (lambda e: (np.nan, np.nan), lambda e: e[::-1], lambda e: (e[0], e[0])):
        wrong = changed(module, boundaries=multiplied(module.boundaries, change))
        with pytest.raises(mg.CertificateError, match="boundaries gives no interval"):
            mg.certify(case, PAIR, functions=wrong)


def test_a_zone_where_there_is_none() -> None:
    case, module = sum_case()
    far = multiplied(module.boundaries, lambda e: (e[0] + 1, e[1] + 1))
    with pytest.raises(mg.CertificateError, match="Floquet finds no zone of instability about"):
        mg.certify(case, PAIR, functions=changed(module, boundaries=far))


def test_a_zone_too_narrow_by_far() -> None:
    """The true zone then reaches over both ends of where it is looked for."""
    case, module = sum_case()
    tiny = multiplied(module.boundaries, lambda e: (e[0] / 9, e[1] / 9))
    certificate = mg.certify(case, PAIR, functions=changed(module, boundaries=tiny))
    assert certificate.fits[1].exponent == pytest.approx(1, abs=0.2)
    assert not certificate.passed


def test_zones_at_numbers() -> None:
    case, module = sum_case()
    numbers = {k: v for k, v in PAIR.items() if k != "sigma"} | {"f_12": 0.2, "f_21": 0.1}
    certificate = mg.certify(case, PAIR, functions=module, numbers=numbers)
    (zone,) = certificate.zones
    assert zone.symbol == "Omega"
    # an error of order ε² beside a width of order ε; coefficients of order one
    half = (zone.exact[1] - zone.exact[0]) / 2
    assert 0.01 < half < 0.1
    for mine, exact in zip(zone.emitted, zone.exact, strict=True):
        assert 1e-5 < abs(mine - exact) < half**2 * 60
    wrong = multiplied(module.critical_speeds, lambda e: (e[0], e[1] * (1 + 1e-6)))
    with pytest.raises(mg.CertificateError, match="critical_speeds gives Omega = "):
        mg.certify(case, PAIR, functions=changed(module, critical_speeds=wrong), numbers=numbers)
    lost = multiplied(module.critical_speeds, lambda e: (np.nan, np.nan))
    without = mg.certify(
        case, PAIR, functions=changed(module, critical_speeds=lost), numbers=numbers
    )
    assert without.zones == ()


# --- values ---------------------------------------------------------------------------------------


def test_scaled_values_of_a_detuned_excitation() -> None:
    case, _ = sum_case()
    slow, exact = scaled_values(case, PAIR, 0.5)
    assert slow == {
        **{"omega_1": 1.7, "omega_2": 3.1, "f": 0.415, "f_12": 0.95, "f_21": 0.65},
        "sigma": 0.065,
    }
    # Ω = ω_1 + ω_2 + εσ
    assert exact.pop("Omega") == pytest.approx(4.865, rel=1e-15)
    assert exact == {k: v for k, v in slow.items() if k != "sigma"}


def test_scaled_values_with_several_relations_and_a_natural_frequency() -> None:
    c = 2 * sp.cos(Omega * t)
    left = [
        d(x, 2) + omega_1**2 * x + c * f * y + kappa * y,
        d(y, 2) + omega_2**2 * y + c * f * x + kappa * x,
    ]
    scaled = system(left, [x, y], {f: 1, kappa: 2})
    case = scaled.expand(2, {2 * Omega: 4 * omega_1, omega_2: omega_1})
    values = {"omega_1": 3.0, "f": 0.8, "kappa": 0.4, "sigma_1": 0.6, "sigma_2": -0.2}
    slow, exact = scaled_values(case, values, 0.5)
    assert slow == {"omega_1": 3.0, "f": 0.4, "kappa": 0.1, "sigma_1": 0.3, "sigma_2": -0.1}
    # 2Ω = 4ω_1 + εσ_1, ω_2 = ω_1 + εσ_2
    assert exact == pytest.approx(
        {"omega_1": 3.0, "f": 0.4, "kappa": 0.1, "Omega": 6.15, "omega_2": 2.9}, rel=1e-15
    )
    for name in ("sigma_1", "sigma_2", "omega_1"):
        without = {k: v for k, v in values.items() if k != name}
        with pytest.raises(mg.CertificateError, match=f"a value of {name} is needed"):
            scaled_values(case, without, 0.5)


def test_scaled_values_of_relations_to_a_number() -> None:
    left = d(x, 2) + (4 + f * sp.cos(Omega * t)) * x
    case = system([left], [x], {f: 1}).expand(1, {Omega: sp.Integer(4)})
    assert scaled_values(case, {"f": 1.0, "sigma": 2.0}, 0.25)[1] == {"f": 0.25, "Omega": 4.5}


@pytest.mark.parametrize(
    ("values", "error", "message"),
    [
        ({k: v for k, v in PAIR.items() if k != "sigma"}, mg.CertificateError, "sigma"),
        ({k: v for k, v in PAIR.items() if k != "f_12"}, mg.CertificateError, "f_12"),
        ({k: v for k, v in PAIR.items() if k != "f"}, mg.CertificateError, "no value for f"),
        ({**PAIR, "gamma": 1.0}, mg.MmsgenError, "gamma is not a parameter"),
        ({**PAIR, "f": np.array([1.0, 2.0])}, mg.MmsgenError, "f must be one number"),
        ({**PAIR, "f": np.nan}, mg.MmsgenError, "f must be real and finite"),
    ],
)
def test_values_that_cannot_be_used(values: dict, error: type[Exception], message: str) -> None:
    case, module = sum_case()
    with pytest.raises(error, match=message):
        mg.certify(case, values, functions=changed(module, boundaries=None))


@pytest.mark.parametrize("epsilons", [(0.5, 0.0), (-0.1,), (np.inf,), (np.nan,)])
def test_epsilons_that_cannot_be_used(epsilons: tuple[float, ...]) -> None:
    case, module = sum_case()
    with pytest.raises(mg.MmsgenError, match="ε must be positive"):
        mg.certify(case, PAIR, functions=module, epsilons=epsilons)


def test_too_few_resolved_errors_are_no_certificate() -> None:
    case, module = sum_case()
    with pytest.raises(mg.CertificateError, match="order 1: only 3 of 3 errors of the character"):
        mg.certify(case, PAIR, functions=changed(module, boundaries=None), epsilons=EPSILONS[:3])
    # nothing interacts: the expansion is exact, and there is no error to fit
    weak = {**PAIR, "f": 1e-9, "f_12": 1e-9, "f_21": 1e-9}
    with pytest.raises(mg.CertificateError, match="only 0 of 16 errors"):
        mg.certify(case, weak, functions=changed(module, boundaries=None))


def test_the_unit_of_time_does_not_matter() -> None:
    """The same oscillators, a thousand times slower: the same exponent, errors a thousandth."""
    case, module = sum_case()
    module = changed(module, boundaries=None)
    slow = {k: v * (1e-6 if k.startswith("f") else 1e-3) for k, v in PAIR.items()}
    usual, slower = (mg.certify(case, v, functions=module).fits[0] for v in (PAIR, slow))
    assert slower.resolved == usual.resolved
    # both errors are known to the reference's relative 4e-14 over at least 30 times LIMIT, 4e-11
    kept = [k for k, ok in enumerate(usual.resolved) if ok]
    ratio = [slower.errors[k] / usual.errors[k] for k in kept]
    np.testing.assert_allclose(ratio, 1e-3, rtol=1e-3)


def test_predicted_exponents_are_all_of_them() -> None:
    case, module = sum_case()
    slow, exact = scaled_values(case, PAIR, 1e-6)
    exponents = predicted_exponents(case, module, slow)
    # at ε → 0 the free oscillators are left, modulo the frequency of the excitation
    turned = np.sort(np.mod(exponents.imag, exact["Omega"]))
    free = np.mod([1.7, -1.7, 3.1, -3.1], exact["Omega"])
    np.testing.assert_allclose(turned, np.sort(free), atol=1e-5)  # ε times rates of order one


def test_default_ranges() -> None:
    assert EPSILONS == tuple(sorted(EPSILONS, reverse=True))
    assert set(EDGE_EPSILONS) < set(EPSILONS)
