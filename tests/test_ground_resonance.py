"""Ground resonance through the engine: the polynomial, the verdicts, the thresholds."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
import rotor
import sympy as sp
from scipy.optimize import brentq
from systems import Omega, linear_rotor, same, sigma, sigma_1, sigma_2, x, y

from mmsgen.equations import EquationsOfMotion
from mmsgen.errors import ExpansionError
from mmsgen.parameters import Parameter
from mmsgen.slowflow import SlowFlow

r_m, r_b, w_x, w_y, w_phi = sp.symbols("r_m r_b omega_x omega_y omega_phi", positive=True)
Gamma = sp.Symbol("Gamma")
SUM_X = {Omega: w_x + w_phi}
BLADES = [2, 3, 4, 5]


@cache
def by_hand(n: int) -> EquationsOfMotion:
    return linear_rotor(n)


@cache
def from_the_model(n: int) -> EquationsOfMotion:
    """The nonlinear model, linearised, isotropic, in ratios, at the blades' frequency at speed."""
    eom = rotor.undamped(rotor.helicopter(n).equations_of_motion().linearise())
    return rotor.at_speed(rotor.in_ratios(rotor.isotropic(eom)))


def flow_of(eom: EquationsOfMotion, order: int, relations: dict | None) -> SlowFlow:
    small = {r_m: 1, r_b: 1}
    return eom.scale(small).expand(order, relations).slow_flow


def unstable_factor(n: int) -> sp.Expr:
    """Γ² − iσΓ − N r_m r_b ω_x³/(16 ω_φ): section 4 of the design."""
    return Gamma**2 - sp.I * sigma * Gamma - n * r_m * r_b * w_x**3 / (16 * w_phi)


@pytest.mark.parametrize("n", BLADES)
@pytest.mark.parametrize("source", [by_hand, from_the_model])
def test_polynomial_of_order_one(n: int, source: Callable[[int], EquationsOfMotion]) -> None:
    """The factor, the idle modes, and nothing else; for N = 2 the same, as the issue's text has it.

    The multiplicities add to the number of amplitudes: support x and y, N blades.
    """
    flow = flow_of(source(n), 1, SUM_X)
    polynomial = flow.characteristic_polynomial(Gamma)
    factors = dict(p.as_base_exp() for p in sp.Mul.make_args(polynomial))
    wanted = [f for f in factors if same(f, unstable_factor(n))]
    assert len(wanted) == 1 and factors[wanted[0]] == 1
    assert sum(sp.degree(f, Gamma) * e for f, e in factors.items()) == n + 2
    assert (
        sp.cancel(polynomial / unstable_factor(n) / (Gamma * (Gamma - sp.I * sigma) ** (n - 1)))
        == 1
    )


@pytest.mark.parametrize("n", BLADES)
def test_zone_of_order_one(n: int) -> None:
    """|σ| < ½√(N r_m r_b ω_x³/ω_φ), and the case is unstable for that reason."""
    flow = flow_of(by_hand(n), 1, SUM_X)
    low, high = flow.boundary()
    assert same(high**2, n * r_m * r_b * w_x**3 / (4 * w_phi))
    assert same(low + high, sp.Integer(0))
    numbers = {r_m: 0.1, r_b: 0.2, w_x: 1.1, w_phi: 0.7}
    assert float(high.subs(numbers)) > 0
    assert flow.stability.unstable is True
    assert "positive in an interval of the detuning" in flow.stability.reason
    zone = flow.boundaries({str(s): v for s, v in numbers.items()})
    assert zone == pytest.approx([float(e.subs(numbers)) for e in (low, high)], rel=1e-12)


@pytest.mark.parametrize(("n", "order"), [(3, 2), (4, 2), (5, 2), (3, 3)])
def test_closed_form_of_higher_order_against_its_polynomial(n: int, order: int) -> None:
    """The edges re-expanded in ε are the roots of the discriminant up to ε^{order+1}."""
    flow = flow_of(by_hand(n), order, SUM_X)
    edges = sp.lambdify([r_m, r_b, w_x, w_phi, w_y], flow.boundary(), "numpy")
    errors = []
    for e in (0.02, 0.01):
        numbers = {"r_m": e, "r_b": 1.3 * e, "omega_x": 1.2, "omega_phi": 0.7, "omega_y": 1.9}
        roots = flow.boundaries(numbers)
        errors.append(np.abs(np.array(edges(*numbers.values())) - roots).max())
    # Errors of 1e-8 and more, roots good to 1e-13; the next order shifts the exponent by ε.
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order + 1, abs=0.1)


@pytest.mark.parametrize(
    ("n", "order"),
    [(3, 1), (4, 1), (5, 1), (3, 2), (4, 2), pytest.param(5, 2, marks=pytest.mark.slow)],
)
@pytest.mark.parametrize("relation", [w_x - w_phi, w_phi - w_x, w_y - w_phi, w_phi - w_y], ids=str)
def test_differences_are_never_unstable(n: int, order: int, relation: sp.Expr) -> None:
    flow = flow_of(by_hand(n), order, {Omega: relation})
    assert flow.stability.unstable is False
    assert "exchange energy" in flow.stability.reason
    assert flow.boundary() == ()
    values = {"r_m": 0.1, "r_b": 0.2, "omega_x": 1.0, "omega_y": 1.4, "omega_phi": 0.6}
    # Eigenvalues of matrices of size 1, distinct or of full multiplicity.
    assert np.all(flow.growth_rate({**values, "sigma": np.linspace(-0.5, 0.5, 21)}) < 1e-9)
    assert np.isnan(flow.boundaries(values)).all()


@pytest.mark.parametrize("n", [2, 3, 4, 5])
def test_without_resonance_all_is_neutral(n: int) -> None:
    flow = flow_of(by_hand(n), 2, None)
    assert flow.stability.unstable is False
    assert flow.boundary() == ()
    assert (
        "turns without growing" in flow.stability.reason or "discriminant" in flow.stability.reason
    )
    values = {
        "r_m": 0.1,
        "r_b": 0.2,
        "omega_x": 1.0,
        "omega_y": 1.5,
        "omega_phi": 0.65,
        "Omega": 2.9,
    }
    assert flow.growth_rate(values) < 1e-9


@pytest.mark.parametrize("n", [3, 4, 5])
def test_isotropic_support(n: int) -> None:
    """ω_y = ω_x from the start, and by a second relation with σ_2 = 0: one polynomial.

    Coleman's whirl: both supports take part, so the half-width is √2 that of one support.
    """
    equal = by_hand(n).reparametrise({w_y: w_x})
    first = flow_of(equal, 1, SUM_X)
    both = flow_of(by_hand(n), 1, {Omega: w_x + w_phi, w_y: w_x})
    turned = both.characteristic_polynomial(Gamma).subs({sigma_2: 0, sigma_1: sigma})
    assert same(first.characteristic_polynomial(Gamma), turned)
    doubled = Gamma**2 - sp.I * sigma * Gamma - 2 * n * r_m * r_b * w_x**3 / (16 * w_phi)
    assert sp.cancel(turned / doubled).is_polynomial(Gamma)
    _, high = first.boundary()
    assert same(high**2, 2 * n * r_m * r_b * w_x**3 / (4 * w_phi))
    assert [r.detuning for r in both.case.relations] == [sigma_1, sigma_2]
    with pytest.raises(ExpansionError, match=r"growth_rate|boundaries"):
        both.boundary()


@pytest.mark.parametrize("split", [-0.2, -0.01, 0.03, 0.3])
def test_supports_of_nearly_one_frequency(split: float) -> None:
    """ω_y = ω_x + σ_2: a cubic factor, whose discriminant is the criterion in σ_1.

    Inside of the zone nearest to zero the growth is positive, beside it and at its edges not: by
    more than 1e-3 a hundredth of the width inside, where it goes like the square root of the
    distance, and less than √1e-16 of the size outside.
    """
    flow = flow_of(by_hand(3), 1, {Omega: w_x + w_phi, w_y: w_x})
    cubic = [v for v in flow.stability.verdicts if v.factor.degree == 3]
    assert len(cubic) == 1 and cubic[0].kind == "conservative"
    numbers = {"r_m": 0.1, "r_b": 0.2, "omega_x": 1.0, "omega_phi": 0.6, "sigma_2": split}
    low, high = flow.boundaries(numbers)
    width = high - low
    assert width > 0.05
    for place, unstable in ((-0.01, False), (0.01, True), (0.5, True), (0.99, True), (1.01, False)):
        rate = flow.growth_rate({**numbers, "sigma_1": low + place * width})
        assert rate > 1e-3 if unstable else rate < 1e-7


def test_coordinates_in_any_order() -> None:
    """Another first coordinate is at rest in the frame then; growth and edges are the same."""
    eom = by_hand(3)
    turned = EquationsOfMotion(
        tuple(reversed(eom.equations)), tuple(reversed(eom.coordinates)), eom.parameters
    )
    one, two = (flow_of(e, 2, SUM_X) for e in (eom, turned))
    assert one.frame[::-1] != two.frame
    numbers = {"r_m": 0.1, "r_b": 0.2, "omega_x": 1.0, "omega_y": 1.4, "omega_phi": 0.6}
    detunings = {**numbers, "sigma": np.linspace(-0.3, 0.3, 13)}
    # Eigenvalues of matrices of size 1 beside colliding ones: the square root of 1e-16.
    assert np.allclose(one.growth_rate(detunings), two.growth_rate(detunings), atol=1e-7)
    assert one.growth_rate(detunings).max() > 0.05
    assert one.boundaries(numbers) == pytest.approx(two.boundaries(numbers), rel=1e-10)
    assert turned.coordinates[-2:] == (y, x)


# --- numbers --------------------------------------------------------------------------------------

# Section 5 of the design: where the growth rate reaches 0.02 s^-1, in Hz.
THRESHOLDS = {
    1: (4.4455, 5.0339),
    2: (4.4486, 5.0341),
    3: (4.4508, 5.0327),
    4: (4.4502, 5.0322),
}


@pytest.mark.parametrize(
    "order",
    [1, 2, pytest.param(3, marks=pytest.mark.slow), pytest.param(4, marks=pytest.mark.slow)],
)
@pytest.mark.parametrize("source", [by_hand, from_the_model])
def test_thresholds(order: int, source: Callable[[int], EquationsOfMotion]) -> None:
    """Four digits are printed: half a unit of the last one, with the blade frequency at speed."""
    flow = flow_of(source(4), order, SUM_X)
    values = {
        n: v for n, v in rotor.PAPER_VALUES.items() if n in ("r_m", "r_b", "omega_x", "omega_y")
    }
    stiffness, centrifugal = rotor.PAPER_VALUES["omega_b"], rotor.PAPER_VALUES["r_a"]

    def excess(hertz: float) -> float:
        speed = 2 * np.pi * hertz
        lag = np.sqrt(stiffness**2 + (centrifugal * speed) ** 2)
        gap = speed - values["omega_x"] - lag
        return float(flow.growth_rate({**values, "omega_phi": lag, "sigma": gap})) - 0.02

    low, high = (brentq(excess, *bracket, xtol=1e-10) for bracket in ((4.3, 4.7), (4.8, 5.2)))
    assert (low, high) == pytest.approx(THRESHOLDS[order], abs=5e-5)


def test_detuning_follows_from_the_frequencies() -> None:
    """σ = Ω − ω_x − ω_φ, and ω_φ from ω_b and Ω, where they are not given themselves."""
    flow = flow_of(from_the_model(4), 2, SUM_X)
    values = rotor.paper_values(from_the_model(4))
    speeds = np.linspace(27.0, 33.0, 7)
    lag = np.sqrt(values["omega_b"] ** 2 + values["r_a"] ** 2 * speeds**2)
    direct = {n: values[n] for n in ("r_m", "r_b", "omega_x", "omega_y")}
    explicit = flow.growth_rate(
        {**direct, "omega_phi": lag, "sigma": speeds - direct["omega_x"] - lag}
    )
    implicit = flow.growth_rate({**values, "Omega": speeds})
    # The detunings differ by rounding, 1e-14; beside the edges its square root reaches the rate.
    assert np.allclose(implicit, explicit, atol=1e-6)
    assert (explicit > 0.1).any() and (explicit < 1e-6).any()


def test_a_damped_rotor_has_a_boundary() -> None:
    """Dampers that may be zero leave one factor that can be unstable, and its zone.

    Against the growth rate: positive inside, negative outside, by more than rounding.
    """
    eom = rotor.at_speed(
        rotor.in_ratios(rotor.isotropic(rotor.helicopter(4).equations_of_motion().linearise()))
    )
    names = {p.name: p.symbol for p in eom.parameters}
    small = {names[n]: 1 for n in ("r_m", "r_b", "mu_x", "mu_y", "mu_b")}
    flow = eom.scale(small).expand(1, SUM_X).slow_flow
    assert flow.stability.unstable is None
    values = {n: v for n, v in rotor.paper_values(eom).items() if n not in ("omega_b", "r_a")}
    values |= {"omega_phi": 11.0, "mu_x": 0.3, "mu_y": 0.2, "mu_b": 0.4}
    needed = {p.name for p in flow.case.parameters}
    values = {n: v for n, v in values.items() if n in needed}
    low, high = flow.boundaries(values)
    for detuning, sign in ((low - 0.01, -1), (low + 0.01, 1), (high - 0.01, 1), (high + 0.01, -1)):
        assert sign * flow.growth_rate({**values, "sigma": detuning}) > 1e-6
    assert len(flow.boundary()) == 2


PROGRAM = """
import sympy as sp
import systems
w_x, w_phi = sp.symbols("omega_x omega_phi", positive=True)
for n in (3,):
    scaled = systems.linear_rotor(n).scale({"r_m": 1, "r_b": 1})
    case = scaled.expand(2, {systems.Omega: w_x + w_phi})
    flow = case.slow_flow
    for rates in case.solvability.values():
        print([sp.srepr(e) for e in rates.values()])
    print(sp.srepr(flow.matrix), sp.srepr(flow.characteristic_polynomial(sp.Symbol("Gamma"))))
    print([sp.srepr(e) for e in flow.boundary()], flow.stability.reason)
    print(scaled.resonances(2), scaled.resonances(2).to_latex())
"""


def test_results_do_not_depend_on_the_hash_seed() -> None:
    """The same expressions, term by term, from processes with other hash seeds."""
    paths = os.pathsep.join(p for p in (os.path.dirname(__file__), *sys.path) if p)
    outputs = set()
    for seed in ("0", "4242"):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": paths}
        run = subprocess.run(
            [sys.executable, "-c", PROGRAM], env=environment, capture_output=True, check=True
        )
        outputs.add(run.stdout)
    assert len(outputs) == 1
    assert b"Symbol" in outputs.pop()


def test_parameters_of_a_flow() -> None:
    """The matrix names what it depends on; detunings come last."""
    flow = flow_of(by_hand(4), 1, SUM_X)
    assert [p.name for p in flow.linear.parameters] == [
        "omega_phi",
        "omega_x",
        "r_b",
        "r_m",
        "sigma",
    ]
    assert all(isinstance(p, Parameter) for p in flow.linear.parameters)
