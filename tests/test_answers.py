"""What ``docs/answers.md`` says of equilibria where there is no plain answer."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen.runtime._records import Equilibria

VALUES = {"omega": 1.0, "a3": 0.1, "c": 0.02, "F": 0.05, "sigma": 0.1}


@cache
def forced() -> mg.SlowFlow:
    """u'' + 2cu' + ω²u + a₃u³ = F cos Ωt, whose small parameters may vanish."""
    t, u = dynamicsymbols._t, dynamicsymbols("u")
    omega, Omega = sp.symbols("omega Omega", positive=True)
    a3, c, F = sp.symbols("a3 c F", real=True)
    left = u.diff(t, 2) + 2 * c * u.diff(t) + omega**2 * u + a3 * u**3 - F * sp.cos(Omega * t)
    parameters = [mg.Parameter(s) for s in (omega, Omega, a3, c, F)]
    eom = mg.Model.from_equations([left], [u], parameters).equations_of_motion()
    return eom.scale({a3: 1, c: 1, F: 1}).expand(1, {Omega: omega}).slow_flow


def at(**values: object) -> Equilibria:
    return forced().equilibria({**VALUES, **values})


def test_a_circle_at_these_numbers_only_is_there_once() -> None:
    # 3a₃a²/8 = σω
    found = at(F=0.0, c=0.0)
    assert found.number == 2
    assert found.modulus[1, 0] == pytest.approx(np.sqrt(8 / 3), rel=1e-14)
    assert found.amplitudes[1, 0].imag == 0.0


def test_no_equilibrium_and_infinitely_many() -> None:
    undamped = {"a3": 0.0, "c": 0.0}
    none = at(**undamped, sigma=0.0)
    assert none.number == 0
    assert not none.stable.any()
    some = at(**undamped, sigma=np.array([0.0, 0.1]))
    assert list(some.number) == [0, 1]
    with pytest.raises(mg.MmsgenError, match="not isolated"):
        at(**undamped, F=0.0, sigma=0.0)
    partly = at(**undamped, F=0.0, sigma=np.array([0.0, 0.1]))
    assert np.isnan(partly.amplitudes[0]).all()
    assert partly.number[1] == 1


def test_a_double_root_is_there_once() -> None:
    response = forced().frequency_response({**VALUES, "sigma": np.linspace(-0.1, 0.6, 101)})
    folds = [b.parameter for b in response.bifurcations]
    assert len(folds) == 2
    found = at(sigma=np.array(folds))
    assert list(found.number) == [2, 2]
    # A distance δ from a fold leaves a growth rate of √(δ r), r the rates of the slow flow, some
    # 0.1/s. Folds are located to 1e-10 of the range, 0.7/s: 2.6e-6.
    assert (np.nanmin(np.abs(found.growth), axis=-1) < 5e-6).all()


def test_what_is_proved_of_the_equilibria() -> None:
    values = {**VALUES, "sigma": np.array([-0.1, 0.05, 0.4])}
    found, flow = forced().equilibria(values), forced()
    proved = flow.certified(values, found)
    assert found.number.max() == 3
    assert np.array_equal(proved, np.isfinite(found.growth))
    wrong = found._replace(amplitudes=1.1 * found.amplitudes)  # η is a tenth, proofs need less
    assert not flow.certified(values, wrong).any()
    with pytest.raises(mg.MmsgenError, match=r"\(3, 3, 1\) do not belong to these values"):
        flow.certified(VALUES, found)
