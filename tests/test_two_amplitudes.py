"""Relations of two amplitudes: phases and one amplitude eliminated exactly."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg
from mmsgen.errors import ExpansionError, MmsgenError
from mmsgen.slowflow import SlowFlow
from mmsgen.symbols import modulus

t = dynamicsymbols._t
x, y = dynamicsymbols("x y")
omega_1, omega_2, Omega = sp.symbols("omega_1 omega_2 Omega", positive=True)
mu_1, mu_2 = sp.symbols("mu_1 mu_2", nonnegative=True)
F_1, F_2, kappa = sp.symbols("F_1 F_2 kappa", real=True)
al = sp.symbols("alpha_1:9", real=True)
a_x, a_y = modulus(x), modulus(y)

COUPLINGS = {
    "1:2": (al[0] * x * y, al[1] * x**2),
    "1:3": (al[0] * x**3 + al[1] * x**2 * y, al[2] * x**3 + al[3] * y**3),
    "1:1": (al[0] * x**3 + kappa * y, al[1] * y**3 + kappa * x),
    "1:1 all": tuple(
        sum(c * x**k * y ** (3 - k) for k, c in enumerate(al[i : i + 4])) for i in (0, 4)
    ),
}


@cache
def flow(name: str, force: int | None) -> SlowFlow:
    """Two oscillators, damped, with a force near the frequency of one of them, or none."""
    couplings = COUPLINGS[name]
    forces = [F_1 if force == 1 else 0, F_2 if force == 2 else 0]
    equations = [
        q.diff(t, 2) + w**2 * q + 2 * mu * q.diff(t) - c - f * sp.cos(Omega * t)
        for q, w, mu, c, f in zip(
            (x, y), (omega_1, omega_2), (mu_1, mu_2), couplings, forces, strict=True
        )
    ]
    own = sum(sp.Add(*c.free_symbols) for c in couplings).free_symbols - {t}
    small = [mu_1, mu_2, *sorted(own, key=str), *(f for f in forces if f != 0)]
    parameters = [omega_1, omega_2, *small, *([Omega] if force else [])]
    relations: dict[sp.Expr, sp.Expr] = {omega_2: int(name[2]) * omega_1}
    if force:
        relations[Omega] = (omega_1, omega_2)[force - 1]
    model = mg.Model.from_equations(equations, [x, y], parameters)
    scaled = model.equations_of_motion().scale(dict.fromkeys(small, 1))
    return scaled.expand(1, relations).slow_flow


# --- formulas -------------------------------------------------------------------------------------


def test_saturation() -> None:
    """Nayfeh and Mook (1979), chapter 6: a_2 does not depend on the force, a_1 does.

    a_2² = (2ω_1/α_1)²(4μ_1² + (σ_1 + σ_2)²). With e^{2iγ_1} from the first equation the second one
    leaves |P + α_1α_2 a_1²/4|² = (α_1F/2)², P = 8ω_1²(μ_1 + i(σ_1 + σ_2)/2)(μ_2 + iσ_2).
    """
    slow = flow("1:2", 2)
    sigma_1, sigma_2 = (r.detuning for r in slow.case.relations)
    wanted = al[0] ** 2 * a_y**2 - 4 * omega_1**2 * (4 * mu_1**2 + (sigma_1 + sigma_2) ** 2)
    assert sp.expand(slow.response_relation(y) + wanted) == 0
    product = 8 * omega_1**2 * (mu_1 + sp.I * (sigma_1 + sigma_2) / 2) * (mu_2 + sp.I * sigma_2)
    real, imaginary = sp.expand(product).as_real_imag()
    wanted = (real + al[0] * al[1] * a_x**2 / 4) ** 2 + imaginary**2 - (al[0] * F_2 / 2) ** 2
    found = slow.response_relation(x)
    assert sp.expand(found - 16 * wanted) == 0
    first, second = slow.amplitude_relations()
    assert first.free_symbols.isdisjoint({a_x})
    assert second.has(a_x, a_y)


def test_the_slow_one_driven() -> None:
    """The cubic equation in a_1² of the book, by hand: B_2 = dB_1²/(μ_2 + iν), ν = 2σ_2 − σ_1."""
    slow = flow("1:2", 1)
    sigma_1, sigma_2 = (r.detuning for r in slow.case.relations)
    nu = 2 * sigma_2 - sigma_1
    # In units of e^{iγ_1}: (μ_1 + iσ_2)a_1 + α_1α_2 a_1³/(32ω_1²(μ_2 + iν)) = F/(2ω_1) up to phase.
    below = mu_2**2 + nu**2
    real = mu_1 * below + al[0] * al[1] * a_x**2 * mu_2 / (32 * omega_1**2)
    imaginary = sigma_2 * below - al[0] * al[1] * a_x**2 * nu / (32 * omega_1**2)
    wanted = a_x**2 * (real**2 + imaginary**2) - (F_1 * below / (2 * omega_1)) ** 2
    found = slow.response_relation(x)
    quotient = sp.cancel(wanted / found)
    assert quotient.free_symbols.isdisjoint({a_x, F_1, mu_1})


# --- solutions that are known by construction ----------------------------------------------------

CASES = [("1:2", 1, 3, 3), ("1:2", 2, 2, 1), ("1:3", 1, 9, 9), ("1:3", 2, 6, 6), ("1:1", 1, 9, 9)]


def solved(slow: SlowFlow, bars: dict[sp.Expr, sp.Expr], unknown: list[sp.Symbol]) -> sp.Dict:
    """Rational parameters with which given amplitudes are an equilibrium."""
    point: dict[sp.Expr, sp.Expr] = {}
    for k, p in enumerate(slow.case.parameters):
        if p.symbol not in unknown:
            point[p.symbol] = sp.Rational(k + 2, k + 3)
    free = {u: sp.Dummy(u.name, real=True) for u in unknown}
    parts: list[sp.Expr] = []
    for rate in slow.autonomous.values():
        value = rate.subs(bars).subs(point)
        re, im = sp.expand(value.subs(free)).as_real_imag()
        parts += [re, im]
    answer = sp.solve(parts, list(free.values()), dict=True)[0]
    return sp.Dict({**point, **{u: answer[d] for u, d in free.items()}})


@pytest.mark.parametrize(("name", "force", "degree_x", "degree_y"), CASES)
def test_equilibria_by_construction(name: str, force: int, degree_x: int, degree_y: int) -> None:
    """Amplitudes are chosen and the parameters solved for: all relations vanish exactly.

    Their degrees are the numbers of complex equilibria, mirror images counted once.
    """
    slow = flow(name, force)
    sigma = [r.detuning for r in slow.case.relations]
    unknown = [mu_1, mu_2, *sigma]
    b = [sp.Rational(3, 4) + sp.I * sp.Rational(2, 5), sp.Rational(-1, 3) + sp.I]
    bars = {sp.conjugate(a): sp.conjugate(z) for a, z in zip(slow.case.amplitudes, b, strict=True)}
    bars |= dict(zip(slow.case.amplitudes, b, strict=True))
    point = dict(solved(slow, bars, unknown))
    squares = {a_x**2: 4 * abs(b[0]) ** 2, a_y**2: 4 * abs(b[1]) ** 2}
    wanted = (a_x, degree_x), (a_y, degree_y)
    relations = [slow.response_relation(q) for q in (x, y)]
    for relation, (a, degree) in zip(relations, wanted, strict=True):
        whole = sp.Poly(relation.xreplace(point), a)
        assert whole.degree() == 2 * degree
        assert whole.eval(sp.sqrt(squares[a**2])) == 0
    for relation in slow.amplitude_relations():
        own = relation.xreplace(point).subs(
            {a: sp.sqrt(s) for a, s in ((a_x, squares[a_x**2]), (a_y, squares[a_y**2]))}
        )
        assert sp.expand(own) == 0


def test_free_motions() -> None:
    """With a self-excited second oscillator: |B_1|, |B_2| and the drift of its circle."""
    slow = flow("1:2", None)
    (sigma,) = (r.detuning for r in slow.case.relations)
    total = 2 * mu_1 + mu_2
    wanted = a_y**2 * al[0] ** 2 * total**2 - 16 * mu_1**2 * omega_1**2 * (total**2 + sigma**2)
    assert sp.expand(slow.response_relation(y) + wanted) == 0


# --- with values ----------------------------------------------------------------------------------


def test_one_to_one_with_values() -> None:
    """Amplitudes of equilibria are roots of the relation, one by one."""
    slow = flow("1:1 all", 1)
    sigma, other = (r.detuning for r in slow.case.relations)
    values = {omega_1: 1, mu_1: 0.02, mu_2: 0.03, sigma: -0.05, other: 0.1}
    values |= dict(zip(al, (0.5, 0.3, 0.2, 0.4, 0.3, 0.2, 0.1, 0.6), strict=True))
    relation = slow.response_relation(x, values)
    assert relation.free_symbols == {a_x, F_1}
    assert sp.degree(relation, a_x) == 2 * 15
    found = slow.equilibria({s.name: v for s, v in values.items()} | {"F_1": 0.2})
    exact = sp.Poly(relation.subs({F_1: sp.Rational(1, 5)}), a_x)
    roots = np.array([float(r.evalf(20)) for r in exact.real_roots() if r > 0])
    gaps = np.abs(roots[:, None] - found.modulus[:, 0])
    # Newton's method at conditions of some hundreds.
    assert gaps.min(axis=0).max() < 1e-11
    assert found.number > 1


def test_what_is_refused() -> None:
    slow = flow("1:2", 2)
    with pytest.raises(ExpansionError, match="give values for more of the parameters"):
        flow("1:1 all", 1).response_relation(x)
    with pytest.raises(MmsgenError, match="of is the coordinate whose amplitude is meant"):
        slow.response_relation()
    with pytest.raises(MmsgenError, match="none of the parameters"):
        slow.response_relation(x, {"nu": 1})
    with pytest.raises(MmsgenError, match="rational number"):
        slow.response_relation(x, {mu_1: sp.sqrt(2)})
    with pytest.raises(ExpansionError, match="fill curves"):
        flow("1:2", None).response_relation(x, {mu_1: 0, mu_2: 0})
