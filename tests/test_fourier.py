"""Periodic coefficients with Fourier coefficients as parameters."""

from __future__ import annotations

import pytest
import sympy as sp
from systems import A, Ac, Omega, d, omega, same, sigma, t, x

import mmsgen as mg


def hill(harmonics: int, *, sines: bool = True) -> tuple[mg.ScaledSystem, mg.FourierSeries]:
    """x'' + (ω² + p(t))x = 0."""
    series = mg.fourier_series("p", Omega, harmonics, sines=sines, unit="rad^2/s^2")
    left = d(x, 2) + (omega**2 + series.expression) * x
    own = [mg.Parameter(omega, "rad/s"), mg.Parameter(Omega, "rad/s")]
    model = mg.Model.from_equations([left], [x], [*own, *series.parameters])
    return model.equations_of_motion().scale(series.orders()), series


def test_hills_equation_at_every_harmonic() -> None:
    """nΩ = 2ω + σ: D1A = i(c_n − i s_n)Āe^{iσt}/(4ω), the growth at σ = 0 is |c_n + i s_n|/(4ω)."""
    scaled, _ = hill(3)
    for n in (1, 2, 3):
        case = scaled.expand(1, {n * Omega: 2 * omega})
        c, s = sp.symbols(f"p_c{n} p_s{n}", real=True)
        expected = sp.I * (c - sp.I * s) * Ac * sp.exp(sp.I * sigma * t) / (4 * omega)
        assert same(case.solvability[1][A], expected)
        values = {"omega": 1.3, "p_c1": 0.1, "p_s1": 0.2, "p_c2": 0.3, "p_s2": -0.1}
        values |= {"p_c3": 0.05, "p_s3": 0.02, "sigma": 0.0}
        growth = abs(values[f"p_c{n}"] + 1j * values[f"p_s{n}"]) / (4 * 1.3)
        assert case.slow_flow.growth_rate(values) == pytest.approx(growth, rel=1e-13)


def test_names_units_and_orders() -> None:
    scaled, series = hill(2, sines=False)
    assert [p.name for p in series.parameters] == ["p_c1", "p_c2"]
    assert {p.unit for p in series.parameters} == {"rad^2/s^2"}
    assert series.orders(2) == {p.symbol: 2 for p in series.parameters}
    kinds = {str(r.relation.rhs): r.kind for r in scaled.resonances(1)}
    assert kinds == {"2*omega": "principal parametric", "omega": "parametric 1:1"}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("p", Omega, 0), "1 or more harmonics, got 0"),
        (("p", Omega, sp.oo), "does not end"),
        (("2p", Omega, 1), "identifier"),
        (("p", sp.Integer(2), 1), "expression in a symbol"),
        (("p", "Omega", 1), "expression in a symbol"),
        (("p", Omega * t, 1), "depends on time"),
    ],
)
def test_what_is_no_finite_series(arguments: tuple, message: str) -> None:
    with pytest.raises(mg.ModelError, match=message):
        mg.fourier_series(*arguments)
