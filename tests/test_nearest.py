"""The resonance nearest to numbers."""

from __future__ import annotations

from math import pi

import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg

t = dynamicsymbols._t
x, y = dynamicsymbols("x y")
omega_1, omega_2, Omega, delta = sp.symbols("omega_1 omega_2 Omega delta", positive=True)


def parametric() -> mg.ScaledSystem:
    coupling = delta * sp.cos(Omega * t)
    model = mg.Model.from_equations(
        [
            x.diff(t, 2) + omega_1**2 * x + coupling * y,
            y.diff(t, 2) + omega_2**2 * y + coupling * x,
        ],
        [x, y],
        [omega_1, omega_2, Omega, delta],
    )
    return model.equations_of_motion().scale({delta: 1})


@pytest.mark.parametrize(
    ("speed", "relation"),
    [(5.1, {Omega: omega_1 + omega_2}), (0.9, {Omega: omega_2 - omega_1})],
)
def test_nearest_is_the_first_of_the_ranking(
    speed: float, relation: dict[sp.Symbol, sp.Expr]
) -> None:
    values = {omega_1: 2.0, omega_2: 3.0, Omega: speed}
    case = parametric().expand(1, "nearest", values=values)
    assert {r.lhs: r.rhs for r in case.relations} == relation
    expected = parametric().expand(1, relation)
    assert case.solvability == expected.solvability
    table = parametric().resonances(1).coupled.rank(values)
    assert table.distances[0] == pytest.approx(0.1 / (2 * pi), rel=1e-12)  # rounding of doubles


def test_refusals_name_what_is_missing() -> None:
    scaled = parametric()
    with pytest.raises(mg.ResonanceError, match="values"):
        scaled.expand(1, "nearest")
    with pytest.raises(mg.ResonanceError, match="closest"):
        scaled.expand(1, "closest", values={omega_1: 1.0})
    with pytest.raises(mg.ResonanceError, match="nearest"):
        scaled.expand(1, {Omega: omega_1 + omega_2}, values={omega_1: 1.0})
    free = mg.Model(x.diff(t) ** 2 / 2 - omega_1**2 * x**2 / 2, [x], [omega_1])
    with pytest.raises(mg.ResonanceError, match="no resonance"):
        free.equations_of_motion().scale({}).expand(1, "nearest", values={omega_1: 1.0})
