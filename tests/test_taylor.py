"""Truncated polynomials of expressions, against SymPy's series and against numbers."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from systems import Omega, alpha, d, f, k, kappa, omega, p, t, theta, x, y

from mmsgen.alphabet import survey
from mmsgen.errors import ScalingError
from mmsgen.expressions import FieldSymbols
from mmsgen.taylor import Taylor

PARAMETERS = [omega, Omega, alpha, f, k, kappa, p, theta]
MOTION = [q.diff(t, n) if n else q for n in range(3) for q in (x, y)]
LIMIT = 5


def taylor_of(expression: sp.Expr, limit: int = LIMIT, weight: int = 1) -> Taylor:
    """An evaluator for one expression."""
    alphabet = survey([expression], t, PARAMETERS, frozenset(MOTION))
    return Taylor(alphabet, (x, y), (Fraction(weight),) * 2, Fraction(limit))


def back(taylor: Taylor, expression: sp.Expr) -> sp.Expr:
    """The polynomial of an expression, again as an expression."""
    alphabet = taylor.alphabet
    table = {s.name: s ** sp.Rational(1, alphabet.roots.get(s.name, 1)) for s in PARAMETERS}
    show = FieldSymbols(alphabet.field, table)
    total = sp.Integer(0)
    for key, c in taylor(expression).items():
        exponents = taylor.packing.exponents(key)
        factors = [q**e for q, e in zip(MOTION, exponents, strict=False)]
        turn = sum(
            e * phasor.angle * (t if phasor.moving else 1)
            for e, phasor in zip(exponents[taylor.dynamic :], alphabet.phasors, strict=True)
        )
        total += show(c) * sp.Mul(*factors) * sp.exp(sp.I * turn)
    return total


EXPRESSIONS = [
    x**3 * y - 2 * d(x, 2) * y / 3,
    sp.sin(x),
    sp.cos(x + y),
    sp.sin(Omega * t + x),
    sp.cos(Omega * t + theta + 2 * x - y),
    sp.cos(Omega * t) * sp.sin(2 * Omega * t / 3 + theta / 2),
    sp.sin(Omega * t) ** 3 * x,
    sp.cos(Omega * t + sp.pi / 3) * x,
    sp.cos(Omega * t + 2 * sp.pi / 5) * sp.sqrt(5) * x,
    sp.tan(x),
    sp.tan(x + sp.pi / 3) + sp.sqrt(3),
    sp.sqrt(1 + x),
    sp.sqrt(1 - x * y + x**2),
    1 / (1 + x),
    1 / (2 + x * d(y)) ** 2,
    sp.sqrt(2 + x),
    1 / sp.sqrt(3 - x),
    sp.exp(x) * sp.sinh(y),
    sp.log(1 + x * y + y),
    sp.atan(x) + sp.asin(y) + sp.acos(x),
    sp.atan(1 + x),
    sp.cosh(x) / (1 + y),
    sp.sqrt(k) * x + k ** sp.Rational(3, 2) * y,
    sp.cbrt(k) * x / sp.sqrt(kappa),
    alpha / (kappa + alpha) * x**2,
    x / (kappa + alpha * y),
    sp.sqrt(kappa**2 + 2 * kappa * alpha + alpha**2) * x,
    sp.sqrt((kappa + alpha) ** 2 + y),
    sp.sqrt(sp.Rational(8, 27)) * x,
    sp.pi * x + sp.E * y * sp.sqrt(6),
    (x + y) ** 4 * sp.cos(t) * sp.cos(3 * t / 2),
    sp.cos(sp.sin(x) + Omega * t),
    (sp.cos(theta) * d(x) + sp.sin(theta) * d(y)) ** 2,
    sp.cos(theta * alpha) * sp.sin(theta) * x,
    1 / sp.cos(x),
    sp.cot(x + sp.pi / 4) + sp.csc(y + sp.pi / 2),
    sp.sin(x) * sp.cos(y) / (1 + d(x) ** 2),
]
"""Trigonometric functions of coordinate plus phase, radicals, quotients, constants."""


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_against_sympy(expression: sp.Expr) -> None:
    """The same truncated expansion from SymPy: q → εq, differentiate, set ε to zero, one at a time.

    Compared as numbers in 40 digits at a point where every size is of order 1: 5 derivatives of
    functions whose coefficients are below 1e3 leave the rounding far under 1e-30.
    """
    mpmath.mp.dps = 60
    eps = sp.Symbol("eps", positive=True)
    plain = {q: sp.Symbol(f"m{i}") for i, q in enumerate(MOTION)}
    ordered = sorted(
        plain.items(), key=lambda item: -item[0].args[1][1] if item[0].is_Derivative else 0
    )
    numbers = {m: sp.Rational(i + 2, 7 + 2 * i) for i, m in enumerate(plain.values())}
    numbers |= {s: sp.Rational(3 * i + 4, 5 + 2 * i) for i, s in enumerate([*PARAMETERS, t])}
    taylor = taylor_of(expression)
    mine = back(taylor, expression).subs(ordered).subs(numbers)
    function = expression.subs(ordered).subs({m: eps * m for m in plain.values()}).subs(numbers)
    reference = sp.Integer(0)
    for n in range(LIMIT + 1):
        reference += function.subs(eps, 0) / sp.factorial(n)
        function = function.diff(eps)
    assert abs(sp.N(mine - reference, 40, maxn=400)) < sp.Float("1e-30")


def test_products_are_truncated_by_weight() -> None:
    """Weights beyond the limit are dropped, weights within are all there."""
    expression = sp.exp(x) * sp.exp(y)
    for limit in range(5):
        taylor = taylor_of(expression, limit)
        degrees = {taylor.degree(key) for key in taylor(expression)}
        assert degrees == set(range(limit + 1))
        assert len(taylor(expression)) == (limit + 1) * (limit + 2) // 2


def test_weight_zero_keeps_every_power() -> None:
    """Without an order of the amplitude a polynomial is exact, whatever its degree."""
    expression = (1 + x) ** 7
    taylor = taylor_of(expression, 0, weight=0)
    assert len(taylor(expression)) == 8
    with pytest.raises(ScalingError, match=r"sin\(x\(t\)\) is not a polynomial"):
        taylor_of(sp.sin(x), 0, weight=0)(sp.sin(x))
    with pytest.raises(ScalingError, match="linearise"):
        taylor_of(1 / (1 + x), 0, weight=0)(1 / (1 + x))


def test_trigonometric_identities_are_exact() -> None:
    """What is zero for a reason that takes an identity has no terms at all."""
    third = 2 * sp.pi / 3
    zeros = [
        sp.cos(Omega * t) ** 2 * x + sp.sin(Omega * t) ** 2 * x - x,
        sum(sp.cos(Omega * t + third * n) for n in range(3)) * x,
        sp.cos(theta) ** 2 * x + sp.sin(theta) ** 2 * x - x,
        sp.sin(2 * theta) * x - 2 * sp.sin(theta) * sp.cos(theta) * x,
        sp.sin(x + y) - sp.sin(x) * sp.cos(y) - sp.cos(x) * sp.sin(y),
        sp.sqrt(6) * x - sp.sqrt(2) * sp.sqrt(3) * x,
        sp.cos(Omega * t + sp.pi / 3) * x
        - sp.cos(Omega * t) / 2 * x
        + sp.sin(Omega * t) * sp.sqrt(3) / 2 * x,
        (sp.sqrt(1 + x) ** 2 - 1 - x),
        x / (1 + y) * (1 + y) - x,
        x / (alpha - kappa) - x / (alpha + kappa) - 2 * kappa * x / (alpha**2 - kappa**2),
    ]
    for zero in zeros:
        unevaluated = sp.Add(*sp.Add.make_args(zero), evaluate=False)
        assert taylor_of(unevaluated)(unevaluated) == {}, zero
        assert taylor_of(unevaluated + x**2)(unevaluated + x**2) != {}


n = sp.Symbol("n", integer=True, positive=True)
undeclared = sp.Symbol("c")
unknown = sp.Function("g")
plain = sp.Symbol("p", real=True)

REFUSALS = [
    (sp.Float("0.5") * x, r"0\.5\d* is a float.*Rational"),
    (sp.Abs(x * y), r"Abs\(x\(t\)\*y\(t\)\) is not smooth"),
    (sp.Abs(x + y), r"Abs\(x\(t\) \+ y\(t\)\) is not smooth"),
    (sp.sign(x.diff(t, 2)), "is not smooth"),
    (sp.Max(x, 0), r"Max\(0, x\(t\)\)"),
    (sp.Piecewise((x, x > 0), (0, True)), "Piecewise"),
    (1 / x, r"1/x\(t\) is singular"),
    (sp.sqrt(x), r"sqrt\(x\(t\)\) is singular"),
    (sp.sqrt(x - 2), r"sqrt\(x\(t\) - 2\)"),
    (x ** sp.Rational(3, 2), r"x\(t\)\*\*\(3/2\) is singular"),
    (sp.log(x), r"log\(x\(t\)\)"),
    (sp.cot(x), r"cot\(x\(t\)\) is singular"),
    (x**k, r"x\(t\)\*\*k: the exponent"),
    (2**k * x, r"2\*\*k: the exponent"),
    (sp.cos(t**2), r"t\*\*2 is not a rational combination"),
    (t * x, "t stands outside"),
    (sp.cos(x * t), "t stands outside"),
    (sp.exp(t) * x, r"t stands outside|exp\(t\) depends on time"),
    (sp.cos(n * Omega * t), r"Omega\*n\*t is not a rational combination"),
    (sp.cos(Omega**2 * t), r"Omega\*\*2\*t is not"),
    (sp.cos(sp.Float("1.5") * t), r"1\.5\d*: write it as a Rational"),
    (sp.cos(sp.sqrt(2) * t), r"sqrt\(2\)\*t is not"),
    (1 / (2 + sp.cos(t)), r"1/\(cos\(t\) \+ 2\) has a time or phase in a denominator"),
    (1 / (2 + sp.cos(theta)), "name a constant factor as a parameter"),
    (sp.sqrt(2 + sp.cos(Omega * t)), "time or phase in a denominator or radical"),
    (sp.tan(Omega * t) * x, r"tan\(Omega\*t\) depends on time"),
    (sp.exp(sp.cos(Omega * t)) * x, "its Fourier series does not terminate"),
    (undeclared * x, r"c is not a declared parameter: add Parameter\(c\)"),
    (unknown(x), r"g\(x\(t\)\) has no Taylor expansion"),
    (sp.besselj(1, x), r"besselj\(1, x\(t\)\)"),
    (sp.exp(k) * x, r"exp\(k\).*name it as a parameter"),
    (sp.tan(k) * x, r"tan\(k\).*name it as a parameter"),
    (sp.log(2 + x), r"log\(2\).*name it as a parameter"),
    (sp.root(2, 3) * x, r"2\*\*\(1/3\)"),
    (sp.sqrt(k + kappa) * x, r"sqrt\(k \+ kappa\)"),
    (sp.sqrt(k**2 - 2 * k * kappa + kappa**2) * x, "of known sign"),
    (sp.sqrt(theta) * x, "declare theta positive"),
]


@pytest.mark.parametrize(("expression", "message"), REFUSALS, ids=lambda v: str(v)[:40])
def test_refusals_name_the_offender(expression: sp.Expr, message: str) -> None:
    with pytest.raises(ScalingError, match=message):
        taylor_of(expression)(expression)


def test_a_radical_of_undecided_sign_is_not_guessed() -> None:
    """√((κ − k)²) is κ − k or k − κ; √((κ + k)²) is κ + k for positive parameters."""
    square = sp.sqrt(kappa**2 + 2 * k * kappa + k**2)
    assert sp.expand(back(taylor_of(square), square) - kappa - k) == 0
    real = sp.sqrt(theta**2 + 2 * theta * k + k**2)
    with pytest.raises(ScalingError, match="of known sign"):
        taylor_of(real)(real)


def test_constants_are_not_confused_with_parameters() -> None:
    """A parameter called E or pi is another thing than the number."""
    young = sp.Symbol("E", positive=True)
    expression = young * sp.E * x - young**2 * x
    alphabet = survey([expression], t, [young], frozenset(MOTION))
    taylor = Taylor(alphabet, (x, y), (Fraction(1),) * 2, Fraction(1))
    (c,) = taylor(expression).values()
    assert FieldSymbols(alphabet.field, {"E": young})(c).free_symbols == {young}
    assert sp.expand(FieldSymbols(alphabet.field, {"E": young})(c) - young * (sp.E - young)) == 0
