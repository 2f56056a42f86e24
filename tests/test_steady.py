"""Steady motions against periodic orbits of the unexpanded equations: the exponents of theory."""

from __future__ import annotations

import json
from functools import cache, wraps
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import sympy as sp
from systems import (
    Omega,
    alpha,
    beta,
    d,
    f,
    k,
    mu,
    omega,
    omega_1,
    omega_2,
    oscillator,
    pair,
    t,
    x,
    y,
)

import mmsgen as mg
from mmsgen.certificate import Certificate
from mmsgen.keeping import kept
from mmsgen.loading import load
from mmsgen.steady import steady_state
from mmsgen.steady_fits import steady_fits

PRIMARY = mg.Steady({"omega": 1.1, "alpha": 0.8, "mu": 0.3, "k": 1.6, "sigma": 0.2}, [0.5 - 0.2j])
FOLD = mg.Steady(
    {"omega": 1.0, "alpha": 1.0, "mu": 0.1, "k": 0.8, "sigma": 0.75},
    [0.4 - 0.08j],
    "saddle-node",
)


@cache
def forced(order: int) -> mg.Expansion:
    """x'' + 2εμx' + ω²x + εαx³ = εk cos Ωt, Ω = ω + εσ."""
    left = 2 * mu * d(x) + alpha * x**3 - k * sp.cos(Omega * t)
    return oscillator(left).scale({mu: 1, alpha: 1, k: 1}).expand(order, {Omega: omega})


@cache
def emitted(order: int) -> Any:
    """Its functions."""
    return load(forced(order))


def exponents(case: mg.Expansion, steady: mg.Steady, module: Any = None) -> dict[str, float]:
    fits = steady_fits(case, module or load(case), steady)
    return {fit.quantity: fit.exponent for fit in fits}


# Fitted to six errors with one correction term, whose neglected successor moves the exponent by
# less than 0.05 (see `certificate.TOLERANCE`).


@pytest.mark.parametrize("order", [1, 2])
def test_primary_resonance(order: int) -> None:
    found = exponents(forced(order), PRIMARY, emitted(order))
    assert found["equilibrium amplitudes"] == pytest.approx(order, abs=0.05)
    assert found["stability"] == pytest.approx(order + 1, abs=0.05)


@pytest.mark.parametrize("order", [1, 2])
def test_saddle_node(order: int) -> None:
    assert exponents(forced(order), FOLD, emitted(order)) == {
        "saddle-node": pytest.approx(order + 1, abs=0.05),
    }


def test_subharmonic_of_a_hard_force() -> None:
    left = 2 * mu * d(x) + alpha * x**3 - k * sp.cos(Omega * t)
    case = oscillator(left).scale({mu: 1, alpha: 1}).expand(2, {Omega: 3 * omega})
    values = {"omega": 1.0, "alpha": 1.0, "mu": 0.05, "k": 8.0, "sigma": 6.0}
    found = exponents(case, mg.Steady(values, [1.2 * np.exp(1j * np.pi / 3)]))
    assert found["equilibrium amplitudes"] == pytest.approx(2, abs=0.05)
    assert found["stability"] == pytest.approx(3, abs=0.05)


def test_limit_cycle_with_its_frequency() -> None:
    # Odd powers of μ vanish in the frequency (Andersen & Geer, 1982): order 2 errs by ε⁴ there,
    # where the theory demands ε³ at least.
    case = oscillator(-mu * (1 - x**2) * d(x), sp.Integer(1)).scale({mu: 1}).expand(2)
    found = exponents(case, mg.Steady({"mu": 1.0}, [1.0]))
    assert found["equilibrium amplitudes"] == pytest.approx(2, abs=0.05)
    assert found["stability"] == pytest.approx(3, abs=0.05)
    assert found["frequency"] == pytest.approx(4, abs=0.05)


@pytest.mark.parametrize("start", [[0.0, 0.3], [0.5 + 0.2j, 0.1 + 0.1j]])
def test_two_amplitudes_one_of_them_at_rest_or_not(start: list[complex]) -> None:
    # 1:2 internal resonance, the higher mode driven: below the threshold it alone moves.
    scaled = pair(
        2 * mu * d(x) + alpha * x * y, 2 * mu * d(y) + beta * x**2 - k * sp.cos(Omega * t)
    ).scale({alpha: 1, beta: 1, mu: 1, k: 1})
    case = scaled.expand(2, {omega_2: 2 * omega_1, Omega: omega_2})
    first, second = (str(r.detuning) for r in case.relations)
    values = {"mu": 0.1, "k": 0.9, "alpha": 0.8, "beta": 0.8, "omega_1": 1.0}
    found = exponents(case, mg.Steady({**values, first: 0.15, second: 0.1}, start))
    assert found["equilibrium amplitudes"] == pytest.approx(2, abs=0.05)
    assert found["stability"] == pytest.approx(3, abs=0.05)


def test_saddle_node_of_two_amplitudes() -> None:
    scaled = pair(
        2 * mu * d(x) + alpha * x * y, 2 * mu * d(y) + beta * x**2 - k * sp.cos(Omega * t)
    ).scale({alpha: 1, beta: 1, mu: 1, k: 1})
    case = scaled.expand(1, {Omega: 2 * omega_1, omega_2: 2 * omega_1})
    first, second = (str(r.detuning) for r in case.relations)
    values = {"mu": 0.05, "k": 0.9, "alpha": 0.8, "beta": 0.8, "omega_1": 1.0}
    steady = mg.Steady(
        {**values, first: -0.46, second: 0.2}, [0.98 + 0.98j, 0.13 - 0.58j], "saddle-node"
    )
    assert exponents(case, steady) == {"saddle-node": pytest.approx(2, abs=0.05)}


def test_rest_has_stability_alone() -> None:
    left = 2 * mu * d(x) + 2 * f * sp.cos(Omega * t) * x + alpha * x**3
    case = oscillator(left).scale({mu: 1, f: 1, alpha: 1}).expand(1, {Omega: 2 * omega})
    values = {"mu": 0.1, "f": 0.7, "alpha": 0.8, "omega": 1.0, "sigma": 0.5}
    assert exponents(case, mg.Steady(values, [0.0])) == {"stability": pytest.approx(2, abs=0.05)}


def test_a_wrong_coefficient_of_order_two_does_not_pass() -> None:
    # A term α²A³Ā² of order 2 that does not belong there moves amplitudes by O(ε), however small.
    case, own = forced(2), emitted(2)

    @wraps(own.slow_flow)
    def wrong(b: np.ndarray, **values: float) -> np.ndarray:
        return own.slow_flow(b, **values) + 1e-2j * values["alpha"] ** 2 * b**3 * b.conj() ** 2

    found = exponents(case, PRIMARY, SimpleNamespace(slow_flow=wrong))
    assert found["equilibrium amplitudes"] < 1.5


def test_certificates_hold_steady_motions_when_asked_to(tmp_path) -> None:
    case = forced(1)
    options = {"amplitudes": [0.5 + 0.4j], "epsilons": [2.0**-j for j in range(4, 9)]}
    plain = mg.certify(case, PRIMARY.values, functions=emitted(1), **options)
    full = mg.certify(case, PRIMARY.values, functions=emitted(1), steady=[PRIMARY, FOLD], **options)
    assert full.fits[0] == plain.fits[0]
    names = [fit.quantity for fit in full.fits[1:]]
    assert names == ["equilibrium amplitudes", "stability", "saddle-node"]
    assert full.passed
    # without steady motions the text is what it was
    data, own = json.loads(plain.to_json()), json.loads(full.to_json())
    assert set(data["fits"][0]) == {"quantity", "theory", "fitted", "passed", "points"}
    assert own["fits"][0] == data["fits"][0]
    assert own["fits"][1]["values"]["sigma"] == "0.2"
    assert own["fits"][1]["amplitudes"] == ["0.5-0.2i"]
    # a certificate that is kept comes back as it was
    first = kept(tmp_path, "key", lambda: full)
    again = kept(tmp_path, "key", lambda: pytest.fail("made twice"))
    assert isinstance(again, Certificate)
    assert first == again == full


def test_no_equilibrium_and_wrong_shapes_are_said(monkeypatch) -> None:
    case = forced(1)
    with pytest.raises(mg.CertificateError, match="1 amplitudes, got 2"):
        steady_fits(case, emitted(1), mg.Steady(PRIMARY.values, [0.1, 0.2]))
    with pytest.raises(mg.CertificateError, match="no saddle-node"):
        steady_fits(
            case,
            emitted(1),
            mg.Steady({**FOLD.values, "mu": 2.0}, [0.1], "saddle-node"),
        )
    slow = {**PRIMARY.values, "Omega": 1.3}
    state = steady_state(case, emitted(1), slow, slow, [0.5])
    assert abs(emitted(1).slow_flow(state.amplitudes, **PRIMARY.values)[0]) < 1e-14


@pytest.mark.parametrize(
    ("name", "steady", "message"),
    [
        ("jacobian", PRIMARY, "jacobian is not the derivative"),
        ("stability", PRIMARY, "stability is not what follows"),
        ("equilibria", PRIMARY, "equilibria does not list"),
        ("response", PRIMARY, "response is not the sum"),
        ("frequency_response", FOLD, "frequency_response finds no saddle-node"),
    ],
)
def test_emitted_functions_that_contradict_each_other(
    name: str, steady: mg.Steady, message: str
) -> None:
    # One function takes a damping that is a tenth larger than the others': of the response, a
    # frequency, on which its harmonics depend.
    case, own = forced(1), emitted(1)
    other = "omega" if name == "response" else "mu"

    @wraps(getattr(own, name))
    def wrong(*leading: object, **values: float) -> object:
        return getattr(own, name)(*leading, **{**values, other: 1.1 * values[other]})

    functions = {f: getattr(own, f) for f in own.__all__ if callable(getattr(own, f))}
    with pytest.raises(mg.CertificateError, match=message):
        steady_fits(case, SimpleNamespace(**{**functions, name: wrong}), steady)
