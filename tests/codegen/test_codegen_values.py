"""Emitted functions against 50-digit references, the engine's eigenvalues, and known results."""

from __future__ import annotations

import re
from collections.abc import Mapping
from inspect import signature
from typing import Any

import mpmath
import numpy as np
import pytest
from codegen_systems import CASES, PAPER, calls, emitted

from mmsgen.loading import load_files

LINEAR = [name for name in CASES if name != "duffing"]


def exceeding(name: str) -> list[str]:
    """Stored points at which an emitted function is further off than its error bound."""
    found = []
    for function, arguments, result, values, errors in calls(name):
        assert len(result) == len(values)
        for got, value, error in zip(result, values, errors, strict=True):
            if mpmath.isnan(value):
                if not np.isnan(got):
                    found.append(f"{function} {arguments}: {got}, not NaN")
            elif not abs(mpmath.mpmathify(got) - value) <= error:
                found.append(f"{function} {arguments}: {got}, not {value} within {error}")
    return found


@pytest.mark.parametrize("name", CASES)
def test_within_the_bound_of_the_running_error_analysis(name: str) -> None:
    # The bound is that of rounding every operation of the emitted formula once.
    with mpmath.workdps(30):
        assert not exceeding(name)


@pytest.mark.parametrize("name", LINEAR)
def test_formulas_do_not_cancel(name: str) -> None:
    # At generic points edges and growth rates must come out to a few units in the last place:
    # beyond 32 of them the emitted formula would be one that loses digits.
    wanted = ["growth_rate", "boundaries", "critical_speeds"]
    if "The eigenvalues of a block" in emitted(name).module.growth_rate.__doc__:
        # These are good to the norm of the matrix, beside which a growth rate may be small.
        wanted.remove("growth_rate")
    with mpmath.workdps(30):
        for function, arguments, result, values, _ in calls(name):
            if function not in wanted:
                continue
            for got, value in zip(result, values, strict=True):
                if mpmath.isfinite(value) and value:
                    units = abs(mpmath.mpmathify(got) - value) / abs(value) * 2**53
                    assert units < 32, (function, arguments, float(units))


def test_a_wrong_coefficient_exceeds_the_bound() -> None:
    one = emitted("rotor")
    wrong = one.text.replace("1 / 4 * omega_x", "1.0000000000000004 / 4 * omega_x")
    assert wrong != one.text
    name = one.module.__name__.rsplit(".", 1)[-1]
    files = {k: wrong if k.endswith(f"{name}.py") else v for k, v in one.files.items()}
    module = load_files(files, [name])[name]
    point = one.reference["functions"]["slow_flow_matrix"][0]
    got = np.ravel(module.slow_flow_matrix(**point["arguments"]))
    off = [
        abs(
            mpmath.mpc(g) - mpmath.mpc(*v) if isinstance(v, list) else mpmath.mpc(g) - mpmath.mpf(v)
        )
        > mpmath.mpf(e)
        for g, v, e in zip(got, point["values"], point["errors"], strict=True)
    ]
    assert any(off)


@pytest.mark.parametrize("name", LINEAR)
def test_growth_rate_against_eigenvalues_of_the_engine(name: str) -> None:
    one = emitted(name)
    for point in one.reference["functions"]["growth_rate"]:
        own = one.module.growth_rate(**point["arguments"])
        matrix = one.module.slow_flow_matrix(**point["arguments"])
        other = float(one.case.slow_flow.growth_rate(point["arguments"]))
        # A backward stable eigensolver is off by u‖S‖ times the condition of the eigenvectors,
        # which at these points is below 100.
        assert abs(own - other) < 100 * 2**-52 * np.linalg.norm(matrix) + 1e-300


@pytest.mark.parametrize("name", LINEAR)
def test_matrix_and_polynomial_belong_together(name: str) -> None:
    module = emitted(name).module
    point = emitted(name).reference["functions"]["slow_flow_matrix"][0]["arguments"]
    matrix = module.slow_flow_matrix(**point)
    n = len(matrix)
    # np.poly goes through eigenvalues, exact for a matrix that is off by a few n u‖S‖, and so do
    # its coefficients: those of (Γ + ‖S‖)^n bound what that makes of them.
    bound = np.poly(np.full(n, -np.linalg.norm(matrix))) * 32 * n * 2**-52
    difference = np.abs(module.characteristic_coefficients(**point) - np.poly(matrix))
    assert (difference <= bound).all()


@pytest.mark.parametrize("name", LINEAR)
def test_slow_flow_is_the_matrix_at_work(name: str) -> None:
    module = emitted(name).module
    point = emitted(name).reference["functions"]["slow_flow_matrix"][1]["arguments"]
    n = len(module.COORDINATES)
    amplitudes = np.exp(1j * np.arange(n)) * np.arange(1, n + 1)
    rates = module.slow_flow(amplitudes, **point)
    by_name = {f"A_{q}": k for k, q in enumerate(module.COORDINATES)}

    def in_order(values: Any) -> Any:
        picked = []
        for variable in module.VARIABLES:
            barred = variable.startswith("conj(")
            value = values[by_name[variable.removeprefix("conj(").removesuffix(")")]]
            picked.append(value.conjugate() if barred else value)
        return np.array(picked)

    matrix = module.slow_flow_matrix(**point)
    left, right = in_order(rates), matrix @ in_order(amplitudes)
    # Two ways to add up at most n products: n roundings of the sum of moduli each.
    size = np.abs(matrix) @ np.abs(in_order(amplitudes))
    assert (np.abs(left - right) <= 8 * n * 2**-52 * size + 1e-300).all()


@pytest.mark.parametrize("name", ["rotor", "fundamental", "damped", "pair"])
def test_boundaries_against_the_closed_form(name: str) -> None:
    """At order 1 nothing is left out of the formula."""
    one = emitted(name)
    edges = tuple(one.case.slow_flow.boundary())
    if one.case.order > 1:
        pytest.skip("the formula is re-expanded")
    for point in one.reference["functions"]["boundaries"]:
        own = one.module.boundaries(**point["arguments"])
        table = {s: point["arguments"][s.name] for e in edges for s in e.free_symbols}
        with mpmath.workdps(40):
            exact = [e.subs(table).evalf(30) for e in edges]
        for got, value in zip(own, exact, strict=True):
            assert abs(got - float(value)) <= 64 * 2**-53 * abs(float(value))


def exact_growth(case: Any, values: Mapping[str, Any]) -> Any:
    """The largest real part of Γ in the working precision of mpmath, factor by factor."""
    rates = []
    for factor in case.slow_flow.linear.factors:
        shown = [case.symbols(c) for c in factor.coefficients]
        numbers = [e.subs({s: values[s.name] for s in e.free_symbols}) for e in shown]
        roots = mpmath.polyroots(
            [mpmath.mpmathify(n.evalf(mpmath.mp.dps)) for n in numbers[::-1]], extraprec=200
        )
        rates += [mpmath.re(z) for z in roots]
    return max(rates)


@pytest.mark.parametrize("name", ["rotor2", "mathieu", "fundamental", "damped", "pair", "coupled"])
def test_growth_begins_at_the_emitted_edges_in_high_precision(name: str) -> None:
    """A part in 10¹² of the width inside of an edge there is growth, as far outside there is none.

    Neutral modes come out of polynomials in 40 digits with less than 1e-20.
    """
    one = emitted(name)
    first = str(one.case.relations[0].detuning.name)
    point = one.reference["functions"]["boundaries"][0]["arguments"]
    lower, upper = map(mpmath.mpf, one.module.boundaries(**point))
    with mpmath.workdps(40):
        step = (upper - lower) * mpmath.mpf("1e-12")
        for edge, inward in ((lower, step), (upper, -step)):
            assert exact_growth(one.case, {**point, first: edge + inward}) > 1e-20
            assert exact_growth(one.case, {**point, first: edge - inward}) < 1e-20


def test_boundaries_from_a_polynomial_against_the_engine() -> None:
    one = emitted("coupled")
    for point in one.reference["functions"]["boundaries"]:
        own = np.array(one.module.boundaries(**point["arguments"]))
        other = one.case.slow_flow.boundaries(point["arguments"])
        # The engine's come unpolished from companion matrices: 1e-12 of the largest root.
        assert np.abs(own - other).max() < 1e-12 * np.abs(own).max() * 100


def test_of_two_zones_the_one_nearest_to_resonance() -> None:
    """Two directions of the fuselage, 3 rad/s apart, each with a zone of its own."""
    one = emitted("coupled")
    values = {"sigma_2": 3.0, "r_m": 1 / 38, "r_b": 0.174, "omega_x": 6 * np.pi, "omega_phi": 11.0}
    zones = one.case.slow_flow.zones(values)
    assert len(zones) == 2 and (zones[:, 0] < zones[:, 1]).all() and zones[0, 1] < zones[1, 0]
    assert one.module.boundaries(**values) == pytest.approx(zones[0], rel=1e-12)
    sigma = np.linspace(-15, 25, 4001)
    growing = one.module.growth_rate(**values, sigma_1=sigma) > 0
    inside = ((zones[:, :1] < sigma) & (sigma < zones[:, 1:])).any(axis=0)
    assert np.array_equal(growing, inside)


@pytest.mark.parametrize("name", ["rotor", "rotor2", "mathieu", "damped", "pair", "coupled"])
def test_growth_begins_at_the_edges(name: str) -> None:
    one = emitted(name)
    point = one.reference["functions"]["boundaries"][0]["arguments"]
    lower, upper = one.module.boundaries(**point)
    first = one.module.RELATIONS[0].rsplit(" ", 1)[-1]
    # Far above the rounding errors of an edge, and of the growth rate's square.
    width = (upper - lower) * 1e-6
    inside = one.module.growth_rate(**{first: np.array([lower + width, upper - width])}, **point)
    outside = one.module.growth_rate(**{first: np.array([lower - width, upper + width])}, **point)
    assert (inside > 0).all()
    assert (outside <= 0).all()


def test_ground_resonance_by_hand() -> None:
    # design, section 4: |σ| < ½ √(N_b r_m r_b ω_x³/ω_φ), of which the mode of the fuselage in one
    # direction has the half of N_b in its matrix: √(r_m r_b ω_x³/ω_φ) for N_b = 4.
    module = emitted("rotor").module
    values = {"r_m": 1 / 38, "r_b": 0.174, "omega_x": 18.85, "omega_phi": 11.0}
    edge = (values["r_m"] * values["r_b"] * values["omega_x"] ** 3 / values["omega_phi"]) ** 0.5
    assert module.boundaries(**values) == pytest.approx((-edge, edge), rel=8 * 2**-53)
    assert module.growth_rate(sigma=0.0, **values) == pytest.approx(edge / 2, rel=8 * 2**-53)


def crossing(module: Any, values: Mapping[str, float], start: float, end: float) -> float:
    """The speed in Hz at which the growth rate reaches 0.02 s⁻¹, by bisection."""

    def above(speed: float) -> bool:
        lag = np.hypot(values["omega_b"], values["r_a"] * speed)
        names = set(signature(module.growth_rate).parameters) & set(values)
        own = {n: values[n] for n in names}
        sigma = speed - values["omega_x"] - lag
        return bool(module.growth_rate(sigma=sigma, omega_phi=lag, **own) > 0.02)

    a, b = 2 * np.pi * start, 2 * np.pi * end
    assert above(a) != above(b)
    for _ in range(50):
        middle = (a + b) / 2
        a, b = (middle, b) if above(middle) == above(a) else (a, middle)
    return float(a / (2 * np.pi))


@pytest.mark.parametrize(
    ("name", "lower", "upper"), [("rotor", 4.4455, 5.0339), ("rotor2", 4.4486, 5.0341)]
)
def test_published_zone_of_ground_resonance(name: str, lower: float, upper: float) -> None:
    # design, section 5, given to four decimals.
    module = emitted(name).module
    assert crossing(module, PAPER, 4.2, 4.7) == pytest.approx(lower, abs=5.1e-5)
    assert crossing(module, PAPER, 4.7, 5.3) == pytest.approx(upper, abs=5.1e-5)


def test_principal_parametric_resonance_of_mathieu() -> None:
    # reference.md: x'' + (1 + 2ε cos Ωt) x = 0, Ω = 2 ± ε − ε²/8; order 2 leaves out ε³.
    module = emitted("numeric").module
    errors = [
        abs(module.boundaries(f=f)[k] - ((2 * k - 1) * f - f**2 / 8))
        for k in (0, 1)
        for f in (1 / 128, 1 / 256)
    ]
    # From one to the next the following term, of a relative size of ε, shifts the exponent by ε.
    assert np.log2(errors[0] / errors[1]) == pytest.approx(3, abs=0.05)
    assert np.log2(errors[2] / errors[3]) == pytest.approx(3, abs=0.05)
    lower, upper = module.boundaries(f=0.125)
    assert module.critical_speeds(f=0.125) == pytest.approx((2 + lower, 2 + upper), rel=2**-52)


def test_neutral_modes_are_exactly_neutral() -> None:
    for name in ("rotor", "rotor2", "coupled", "mathieu"):
        one = emitted(name)
        point = dict(one.reference["functions"]["growth_rate"][0]["arguments"])
        first = one.module.RELATIONS[0].rsplit(" ", 1)[-1]
        far = one.module.growth_rate(**{**point, first: np.linspace(3, 4, 50)})
        assert (far == 0.0).all(), name
    assert emitted("stable").module.growth_rate(
        sigma=[0.1, -2.0], r_m=0.03, r_b=0.2, omega_x=3.0, omega_phi=7.0
    ).tolist() == [0.0, 0.0]


def test_zone_does_not_exist_where_damping_is_too_strong() -> None:
    module = emitted("damped").module
    lower, upper = module.boundaries(omega=1.0, f=0.1, mu=[0.04, 0.06])
    # reference.md: δ = 1 ± ε√(1 − 4k²): there is a zone for μ < f/(2ω) alone.
    assert np.isfinite([lower[0], upper[0]]).all()
    assert np.isnan([lower[1], upper[1]]).all()


def test_emitted_text_holds_no_float_with_lost_digits() -> None:
    # Decimal literals come from irrational constants alone, and these are written in full.
    for name in ("rotor2", "five", "pair"):
        code = emitted(name).text.split("# --- formulas")[1].split("# --- functions")[0]
        for literal in re.findall(r"(?<![\w.])\d+\.\d+", code):
            assert literal == "0.0" or repr(float(literal)) == literal
