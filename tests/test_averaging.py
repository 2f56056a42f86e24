"""A second method: averaging to second order, derived here with SymPy alone, slow and simple.

Krylov, Bogoliubov and Mitropolsky: with q = Ae^{iωt} + c.c. and q' = iωAe^{iωt} + c.c. exactly, the
equation q'' + ω²q + εF = 0 is A' = iεFe^{−iωt}/(2ω) = εf(A, t). The near-identity transformation
A = B + εg with g the integral of f without its mean gives

    B' = ε⟨f⟩ + ε²⟨f' g⟩,

the bar of f and all coordinates included in f'. The fundamental of q is not B: the conjugate part
of g adds to it, B + εh with h the component of ḡ at e^{2iωt}. In the fundamental, the rate of order
two is ⟨f'g⟩ + h'⟨f⟩ − ⟨f⟩'h. See Sanders, Verhulst and Murdock, *Averaging Methods in Nonlinear
Dynamical Systems* (2007), chapters 2 and 3. Frequencies are whole numbers here, so that everything
is a Laurent polynomial in z = e^{it} and every resonance holds exactly.
"""

from __future__ import annotations

from collections.abc import Sequence

import pytest
import sympy as sp
from systems import B, alpha, beta, d, equations, f, kappa, mu, same, t, x, y

from mmsgen.symbols import amplitude

Laurent = dict[int, sp.Expr]
Z = sp.Symbol("z")
COORDINATES = (x, y)


def laurent(expression: sp.Expr) -> Laurent:
    """The coefficients of the powers of z."""
    powers: Laurent = {}
    for term in sp.Add.make_args(sp.expand(expression)):
        c, z_part = term.as_independent(Z)
        power = int(sp.Poly(z_part * Z**60, Z).degree()) - 60
        powers[power] = powers.get(power, sp.Integer(0)) + c
    return {n: sp.expand(c) for n, c in powers.items()}


def total(parts: Laurent) -> sp.Expr:
    return sp.Add(*(c * Z**n for n, c in parts.items()))


def averaged(forces: Sequence[sp.Expr], frequencies: Sequence[int]) -> list[list[sp.Expr]]:
    """Rates of order one and two of (A_1, Ā_1, A_2, Ā_2, …), the fundamentals."""
    size = len(forces)
    state = [s for j in range(size) for s in sp.symbols(f"b{j} c{j}")]
    motion: dict[sp.Expr, sp.Expr] = {}
    for j, n in enumerate(frequencies):
        forward, back = state[2 * j] * Z**n, state[2 * j + 1] * Z**-n
        motion[d(COORDINATES[j])] = sp.I * n * (forward - back)
        motion[COORDINATES[j]] = forward + back
    rates: list[Laurent] = []
    for force, n in zip(forces, frequencies, strict=True):
        exponential = force.rewrite(sp.exp).replace(
            lambda e: isinstance(e, sp.exp), lambda e: Z ** int(e.args[0] / (sp.I * t))
        )
        plain = exponential.subs(list(motion.items()))
        rates.append(laurent(sp.I * plain * Z**-n / (2 * n)))
        rates.append(laurent(-sp.I * plain * Z**n / (2 * n)))
    mean = [r.get(0, sp.Integer(0)) for r in rates]
    wave = [{n: c / (sp.I * n) for n, c in r.items() if n} for r in rates]

    def mixed(functions: Sequence[sp.Expr], shifts: Sequence[sp.Expr]) -> list[sp.Expr]:
        """Σ_j ∂function/∂state_j · shift_j."""
        return [
            sp.expand(sum(g.diff(s) * v for s, v in zip(state, shifts, strict=True)))
            for g in functions
        ]

    products = mixed([total(r) for r in rates], [total(g) for g in wave])
    second = [laurent(e).get(0, sp.Integer(0)) for e in products]
    fundamental = []
    for j, n in enumerate(frequencies):
        fundamental.append(wave[2 * j + 1].get(2 * n, sp.Integer(0)))
        fundamental.append(wave[2 * j].get(-2 * n, sp.Integer(0)))
    there, back_again = mixed(fundamental, mean), mixed(mean, fundamental)
    corrected = [a + b - c for a, b, c in zip(second, there, back_again, strict=True)]
    names = {
        s: value
        for j in range(size)
        for s, value in zip(
            state[2 * j : 2 * j + 2],
            (amplitude(COORDINATES[j]), sp.conjugate(amplitude(COORDINATES[j]))),
            strict=True,
        )
    }
    return [[sp.expand(e.subs(names)) for e in row] for row in (mean, corrected)]


c1, c2, c3, s2 = sp.cos(t), sp.cos(2 * t), sp.cos(3 * t), sp.sin(2 * t)
SYSTEMS = {
    "duffing and quadratic": ([alpha * x**3 + beta * x**2], (1,)),
    "van der pol": ([-mu * (1 - x**2) * d(x)], (1,)),
    "rayleigh with quadratic": ([mu * d(x) ** 3 - mu * d(x) + beta * x**2], (1,)),
    "nonlinear products": ([alpha * x * d(x) + beta * x**2 * d(x) + kappa * d(x) ** 2], (2,)),
    "primary, soft": ([alpha * x**3 + mu * d(x) - f * c1], (1,)),
    "primary with quadratic": ([beta * x**2 - f * c1 + kappa * sp.sin(t) * x], (1,)),
    "principal parametric": ([2 * alpha * c2 * x], (1,)),
    "parametric one to one": ([2 * alpha * c1 * x + 2 * mu * d(x)], (1,)),
    "parametric three": ([alpha * c3 * x + beta * x**2 + mu * s2 * d(x)], (1,)),
    "mathieu and duffing": ([2 * f * c2 * x + alpha * x**3 + mu * d(x)], (1,)),
    "equal, coupled": ([kappa * y + alpha * x**3, kappa * x + mu * d(y)], (1, 1)),
    "equal, through velocities": ([alpha * x * d(y), beta * y**2 - kappa * d(x)], (1, 1)),
    "two to one": ([alpha * x * y + mu * d(x), alpha * x**2 / 2 + kappa * y * d(y)], (1, 2)),
    "two to one, driven": (
        [mu * d(x) - alpha * x * y, kappa * d(y) - beta * x**2 - f * c2],
        (1, 2),
    ),
    "two to one, the slower one driven": (
        [-alpha * x * y - f * c1, mu * d(y) - beta * x**2],
        (1, 2),
    ),
    "three to one, driven": (
        [mu * d(x) - alpha * x**2 * y - beta * x * y**2, -kappa * x**3 - beta * y**3 - f * c3],
        (1, 3),
    ),
    "three to one": ([alpha * x**2 * y + beta * y**2, alpha * x**3 + kappa * x * y], (1, 3)),
    "sum combination": ([2 * alpha * c3 * y + beta * x**2, 2 * kappa * c3 * x], (1, 2)),
    "difference combination": ([2 * alpha * c1 * y, 2 * kappa * c1 * x + mu * d(y)], (2, 3)),
}


@pytest.mark.parametrize("name", SYSTEMS)
def test_both_methods_give_one_slow_flow(name: str) -> None:
    """Orders one and two, exactly, term by term."""
    forces, frequencies = SYSTEMS[name]
    left = [
        d(q, 2) + n**2 * q + force
        for q, n, force in zip(COORDINATES, frequencies, forces, strict=False)
    ]
    eom = equations(left, COORDINATES[: len(left)])
    case = eom.scale({p.symbol: 1 for p in eom.parameters}).expand(order=2)
    first, second = averaged(forces, frequencies)
    assert any(second)
    for j, a in enumerate(case.amplitudes):
        assert same(case.solvability[1][a], first[2 * j])
        assert same(case.solvability[2][a], second[2 * j])


def test_the_second_method_is_a_test() -> None:
    """Without the change to the fundamental it gives another, equally right, normal form."""
    (first, _), (second, _) = averaged([-mu * (1 - x**2) * d(x)], (1,))
    a = amplitude(x)
    assert same(first, mu * (a - a**2 * sp.conjugate(a)) / 2)
    assert same(sp.expand(second).coeff(a, 1).coeff(sp.conjugate(a), 0), -sp.I * mu**2 / 8)
    assert not second.has(B)
