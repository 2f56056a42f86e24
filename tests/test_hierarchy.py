"""The order-ε^p equations as papers print them."""

from __future__ import annotations

from fractions import Fraction
from itertools import count

import pytest
import sympy as sp
from latex_values import value
from systems import (
    Omega,
    alpha,
    beta,
    d,
    equations,
    f,
    kappa,
    linear_rotor,
    mu,
    omega,
    oscillator,
    pair,
    t,
    theta,
    x,
    y,
)

from mmsgen import report
from mmsgen.hierarchy import hierarchy
from mmsgen.scaling import ScaledSystem
from mmsgen.symbols import epsilon

COS = r"\cos{\left(\Omega T_{0} \right)}"
SIN = r"\sin{\left(\Omega T_{0} \right)}"


def squeezed(terms: list[str]) -> list[str]:
    return ["".join(term.split()) for term in terms]


def duffing() -> ScaledSystem:
    """Quadratic term of order 1; damping, cubic term and forcing of order 2."""
    terms = 2 * mu * d(x) + alpha * x**3 + beta * x**2 - f * sp.cos(Omega * t)
    return oscillator(terms).scale({mu: 2, alpha: 2, beta: 1, f: 2})


def test_a_frequency_of_one_is_not_written() -> None:
    eom = oscillator(alpha * x**3, sp.Integer(1))
    assert hierarchy(eom.scale({alpha: 1}), 0)[x][0] == "D_0^2 x_{0} + x_{0}"


def test_forced_damped_duffing_by_hand() -> None:
    found = {p: hierarchy(duffing(), p)[x] for p in range(3)}
    assert [left for left, _ in found.values()] == [
        rf"D_0^2 x_{{{p}}} + \omega^{{2}} x_{{{p}}}" for p in range(3)
    ]
    assert found[0][1] == []
    assert sorted(squeezed(found[1][1])) == sorted(
        squeezed([r"-2 D_{0} D_{1} x_{0}", r"-\beta x_{0}^{2}"])
    )
    # D² = D_0² + 2εD_0D_1 + ε²(D_1² + 2D_0D_2), x² = x_0² + 2εx_0x_1
    assert sorted(squeezed(found[2][1])) == sorted(
        squeezed(
            [
                r"-2 D_{0} D_{1} x_{1}",
                r"-D_{1}^2 x_{0}",
                r"-2 D_{0} D_{2} x_{0}",
                r"-2 \mu D_{0} x_{0}",
                r"-\alpha x_{0}^{3}",
                r"-2 \beta x_{0} x_{1}",
                rf"f {COS}",
            ]
        )
    )


def test_rotor_by_hand() -> None:
    """Two blades, half a turn apart: x'' + ω_x² x = r_m Σ (φ_k sin ζ_k)''."""
    found = hierarchy(linear_rotor(2).scale({"r_m": 1, "r_b": 1}), 1)
    by_name = {str(q.func): terms for q, (_, terms) in found.items()}
    in_x = [r"-2 D_{0} D_{1} x_{0}"]
    for k, sign, opposite in ((1, "", "-"), (2, "-", "")):
        in_x += [
            rf"{sign} r_{{m}} {SIN} D_{{0}}^2 \phi_{{{k},0}}",
            rf"{sign} 2 \Omega r_{{m}} {COS} D_{{0}} \phi_{{{k},0}}",
            rf"{opposite} \Omega^{{2}} r_{{m}} {SIN} \phi_{{{k},0}}",
        ]
    assert sorted(squeezed(by_name["x"])) == sorted(squeezed(in_x))
    # φ'' + ω_φ² φ = −r_b (y'' cos ζ − x'' sin ζ)
    assert sorted(squeezed(by_name["phi_1"])) == sorted(
        squeezed(
            [
                r"-2 D_{0} D_{1} \phi_{1,0}",
                rf"-r_{{b}} {COS} D_{{0}}^2 y_{{0}}",
                rf"r_{{b}} {SIN} D_{{0}}^2 x_{{0}}",
            ]
        )
    )


def test_hard_forcing_stands_at_order_zero() -> None:
    scaled = oscillator(alpha * x**3 - f * sp.cos(Omega * t + theta)).scale({alpha: 1})
    ((_, terms),) = hierarchy(scaled, 0).values()
    assert len(terms) == 1
    numbers = {"f": 0.7, r"\Omega": 1.3, "T_{0}": 0.4, r"\theta": 0.2}
    expected = complex(0.7 * sp.cos(1.3 * 0.4 + 0.2))
    # a handful of operations in doubles
    assert abs(value(terms[0], numbers) - expected) < 1e-14


SYSTEMS = {
    "powers": (
        oscillator(kappa * x * d(x) ** 2 + alpha * x**3 * d(x, 2) + beta * d(x) ** 3),
        {kappa: 1, alpha: 1, beta: 2},
    ),
    "products": (
        pair(alpha * x * y + beta * d(x) * d(y) * y, beta * x**2 * d(y, 2) + mu * d(x)),
        {alpha: 1, beta: 1, mu: 1},
    ),
    "parametric": (
        oscillator(alpha * sp.cos(Omega * t) * x * d(x, 2) + f * sp.sin(Omega * t + theta)),
        {alpha: 1, f: 1},
    ),
    "inertia": (
        equations([(1 + alpha * x) * d(x, 2) + omega**2 * x + mu * d(x) ** 2 * x], [x]),
        {alpha: 1, mu: 2},
    ),
}


@pytest.mark.parametrize("order", [1, 2, 3, 4])
@pytest.mark.parametrize("name", list(SYSTEMS))
def test_terms_have_the_right_multiplicity(name: str, order: int) -> None:
    """Every function of time has the factor e^{s_0T_0 + s_1T_1 + …}: D_a then is the number s_a.

    So d/dt is the number S = Σ ε^a s_a, and with q = Σ ε^k q_k the equations themselves, expanded
    in ε in exact numbers, say what the printed terms must add up to.
    """
    eom, orders = SYSTEMS[name]
    scaled = eom.scale(orders)
    primes = count(3)
    s = [Fraction(next(primes), 7) for _ in range(order + 1)]
    q = {c: [Fraction(next(primes), 11) for _ in range(order + 1)] for c in eom.coordinates}
    numbers = {symbol: Fraction(next(primes), 13) for symbol in (p.symbol for p in eom.parameters)}
    printed = {f"D_{{{a}}}": complex(v) for a, v in enumerate(s)} | {"D_0": complex(s[0])}
    for c, values in q.items():
        printed |= {f"{c.func}_{{{k}}}": complex(v) for k, v in enumerate(values)}
    printed |= {sp.latex(symbol): complex(v) for symbol, v in numbers.items()}
    now = Fraction(2, 5)
    printed["T_{0}"] = complex(now)

    rate = sum(epsilon**a * sp.Rational(v) for a, v in enumerate(s))
    small = dict(scaled.orders)
    replaced = {}
    for c, values in q.items():
        series = sum(epsilon**k * sp.Rational(v) for k, v in enumerate(values))
        for n in (2, 1, 0):
            replaced[c.diff(t, n) if n else c] = rate**n * series
    exact = {v: epsilon ** small.get(v, 0) * sp.Rational(n) for v, n in numbers.items()}
    for j, (left, terms) in enumerate(hierarchy(scaled, order).values()):
        whole = eom.equations[j].xreplace(replaced).xreplace(exact).subs(t, sp.Rational(now))
        expected = complex(sp.expand(whole).coeff(epsilon, order))
        right = sum(value(term, printed) for term in terms)
        # sums of at most a hundred terms of size 1e2, in doubles
        assert abs(value(left, printed) - right - expected) < 1e-10 * max(1.0, abs(expected))


def test_formulas_of_orders() -> None:
    text = str(report.orders(duffing(), 1))
    assert "".join(text.split()) == "".join(
        r"D_0^2 x_{1} + \omega^{2} x_{1} = - 2 D_{0} D_{1} x_{0} - \beta x_{0}^{2}".split()
    )
    both = pair(alpha * y, alpha * x).scale({alpha: 1})
    assert str(report.orders(both, 0)).count("= 0") == 2
    assert "x_{" not in str(report.orders(both, 0, only=[y]))


def test_coupled_coordinates_keep_their_matrices() -> None:
    """m x'' + Gy' + (k + κ)x − κy + f cos(Ωt) x = 0 and its neighbour, order by order."""
    m, G, k = sp.symbols("m G k", positive=True)
    left = [
        m * d(x, 2) + G * d(y) + (k + kappa) * x - kappa * y + f * sp.cos(Omega * t) * x,
        d(y, 2) - G * d(x) + k * y - kappa * x,
    ]
    scaled = equations(left, [x, y]).scale({f: 1})
    found = hierarchy(scaled, 1)
    assert found[x][0] == (
        r"m D_0^2 x_{1} + G D_0 y_{1} + \left(k + \kappa\right) x_{1} - \kappa y_{1}"
    )
    assert squeezed(found[x][1]) == squeezed(
        ["-2 m D_{0} D_{1} x_{0}", "-G D_{1} y_{0}", rf"-f {COS} x_{{0}}"]
    )
    assert squeezed(found[y][1]) == squeezed(["-2 D_{0} D_{1} y_{0}", "G D_{1} x_{0}"])
    shown = report.modes(scaled)._repr_latex_()
    # every K0 couples and G0 does as well: no coordinate is in quadrature with the other
    assert r"x &= \Phi_{x 1} \eta_{1} + \Phi_{x 2} \eta_{2} + \Theta_{x 1} s_{1}" in shown
