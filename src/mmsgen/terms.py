"""Sums of terms: multiplied out, trigonometric products reduced, like terms collected.

An expression of a model is a sum of terms *coefficient × basis function*. The coefficient is
made of parameters alone; the basis function holds everything that changes with time: the
coordinates, their derivatives, and explicit functions of time. Three rules bring an expression
into this form, all of them exact:

- products are multiplied out;
- a product of sines and cosines becomes a sum of single sines and cosines, so that
  cos² + sin² = 1 and its relatives hold by the addition of like terms;
- a sum of equal oscillations at different static phases is dropped when it vanishes, as the
  sum over equally spaced blade azimuths does. The phases are roots of unity, and the sum is
  reduced modulo the cyclotomic polynomial.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from math import lcm

import sympy as sp
from sympy.core.function import AppliedUndef

__all__ = ["assemble", "collect", "expanded", "motion", "ratio", "same", "shortened"]

# multiplied out, and nothing else: powers and logarithms stay as the user wrote them
_HINTS = {"power_base": False, "power_exp": False, "log": False, "basic": False}
_HALF = sp.Rational(1, 2)


@lru_cache(maxsize=1024)
def motion(q: sp.Expr, time: sp.Symbol) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Position, velocity and acceleration: q, q', q''. Kept, since SymPy makes them slowly."""
    return q, q.diff(time), q.diff(time, 2)


@lru_cache(maxsize=1024)
def expanded(expr: sp.Expr) -> sp.Expr:
    """Multiply out, and write products of sines and cosines as sums.

    Parameters
    ----------
    expr : sympy.Expr
        Any expression; functions other than sine and cosine are carried along unchanged.

    Returns
    -------
    sympy.Expr
        Equal to `expr`: a sum of terms with at most one sine or cosine each.
    """
    terms: list[sp.Expr] = []
    for term in _multiplied_out(expr):
        for part in _single_trigonometric(term):
            # values such as cos(2π/5) bring sums of radicals into products
            terms.extend([part] if part is term else _multiplied_out(part))
    return _without_vanishing_phases(sp.Add(*terms))


def _multiplied_out(expr: sp.Expr) -> list[sp.Expr]:
    """Terms of the expanded sum; only those products are touched that contain sums."""
    terms: list[sp.Expr] = []
    for term in sp.Add.make_args(expr):
        if any(_holds_a_sum(factor) for factor in sp.Mul.make_args(term)):
            terms.extend(sp.Add.make_args(sp.expand(term, **_HINTS)))
        else:
            terms.append(term)
    return terms


def _holds_a_sum(factor: sp.Expr) -> bool:
    """Whether a factor is a sum or a power of one, or a function of an unexpanded argument."""
    if isinstance(factor, sp.Pow):
        return not factor.base.is_Atom and not isinstance(factor.base, sp.Function)
    if isinstance(factor, sp.cos | sp.sin):
        parts = sp.Add.make_args(factor.args[0])
        return any(isinstance(f, sp.Add) for part in parts for f in sp.Mul.make_args(part))
    return bool(factor.args) and not isinstance(factor, sp.Derivative | AppliedUndef)


def _single_trigonometric(term: sp.Expr) -> list[sp.Expr]:
    """One product as a list of terms with at most one sine or cosine each."""
    rest: list[sp.Expr] = []
    functions: list[sp.Expr] = []
    for factor in sp.Mul.make_args(term):
        if isinstance(factor, sp.cos | sp.sin):
            functions.append(factor)
        elif (
            isinstance(factor, sp.Pow)
            and isinstance(factor.base, sp.cos | sp.sin)
            and factor.exp.is_Integer
            and factor.exp.is_positive
        ):
            functions.extend([factor.base] * int(factor.exp))
        else:
            rest.append(factor)
    if len(functions) < 2:
        return [term]
    total = functions[0]
    for function in functions[1:]:
        total = sp.Add(*(_product(part, function) for part in sp.Add.make_args(total)))
    factor = sp.Mul(*rest)
    return [factor * part for part in sp.Add.make_args(total)]


def _product(left: sp.Expr, right: sp.Expr) -> sp.Expr:
    """Write (number × sine or cosine) × (sine or cosine) as a sum of single ones."""
    number, left = left.as_coeff_Mul()
    number *= _HALF
    if not isinstance(left, sp.cos | sp.sin):  # the partial product has become a plain number
        return 2 * number * left * right
    a, b = left.args[0], right.args[0]
    difference, total = sp.expand(a - b, **_HINTS), sp.expand(a + b, **_HINTS)
    if isinstance(left, sp.cos) and isinstance(right, sp.cos):
        return number * sp.cos(difference) + number * sp.cos(total)
    if isinstance(left, sp.sin) and isinstance(right, sp.sin):
        return number * sp.cos(difference) - number * sp.cos(total)
    if isinstance(left, sp.sin):
        return number * sp.sin(total) + number * sp.sin(difference)
    return number * sp.sin(total) - number * sp.sin(difference)


def _without_vanishing_phases(expr: sp.Expr) -> sp.Expr:
    """Drop sums Σ c_k cos(θ + π r_k), all with the same θ and factor, that are exactly zero."""
    groups: dict[tuple[sp.Expr, sp.Expr], list[tuple[sp.Expr, sp.Rational, sp.Rational]]] = {}
    for term in sp.Add.make_args(expr):
        number, rest, function = _split_oscillation(term)
        if function is None:
            continue
        theta, phase, sign = _angle_and_phase(function)
        groups.setdefault((rest, theta), []).append((term, number * sign, phase))
    vanishing = [
        term
        for members in groups.values()
        if len(members) > 1 and _phases_cancel([(c, r) for _, c, r in members])
        for term, _, _ in members
    ]
    return expr - sp.Add(*vanishing) if vanishing else expr


def _split_oscillation(term: sp.Expr) -> tuple[sp.Rational, sp.Expr, sp.Expr | None]:
    """Rational number, other factors, and the only sine or cosine of a term (None: no such)."""
    number: sp.Rational = sp.S.One
    rest: list[sp.Expr] = []
    function: sp.Expr | None = None
    for factor in sp.Mul.make_args(term):
        if factor.is_Rational:
            number *= factor
        elif function is None and isinstance(factor, sp.cos | sp.sin):
            function = factor
        else:
            rest.append(factor)
    return number, sp.Mul(*rest), function


def _angle_and_phase(function: sp.Expr) -> tuple[sp.Expr, sp.Rational, int]:
    """θ, r and s = ±1 such that the function is s·cos(θ + π r), θ without a static phase."""
    static: sp.Rational = sp.S.Zero
    rest: list[sp.Expr] = []
    for part in sp.Add.make_args(function.args[0]):
        multiple = part / sp.pi
        if multiple.is_Rational:
            static += multiple
        else:
            rest.append(part)
    theta = sp.Add(*rest)
    sign = 1
    if theta.could_extract_minus_sign():  # cos(−θ + p) = cos(θ − p), sin(−θ + p) = −sin(θ − p)
        theta, static = -theta, -static
        sign = -1 if isinstance(function, sp.sin) else 1
    if isinstance(function, sp.sin):  # sin α = cos(α − π/2)
        static -= _HALF
    return theta, static, sign


def _phases_cancel(members: Iterable[tuple[sp.Rational, sp.Rational]]) -> bool:
    """Whether Σ c e^{iπr} over the pairs (c, r) is zero: divisible by the cyclotomic polynomial."""
    pairs = list(members)
    half_turns = lcm(*(int(r.q) for _, r in pairs))
    order = 2 * half_turns  # every phase is a power of e^{2πi/order}
    powers: dict[int, sp.Rational] = {}
    for number, r in pairs:
        power = int(r * half_turns) % order
        powers[power] = powers.get(power, sp.S.Zero) + number
    z = sp.Symbol("z")
    total = sp.Poly({(p,): c for p, c in powers.items()} or {(0,): 0}, z, domain="QQ")
    return bool(total.rem(_cyclotomic(order)).is_zero)


@lru_cache(maxsize=64)
def _cyclotomic(order: int) -> sp.Poly:
    """Return the minimal polynomial of e^{2πi/order}."""
    z = sp.Symbol("z")
    return sp.Poly(sp.cyclotomic_poly(order, z), z, domain="QQ")


def collect(expr: sp.Expr, time: sp.Symbol) -> dict[sp.Expr, sp.Expr]:
    """Basis functions with their coefficients.

    Parameters
    ----------
    expr : sympy.Expr
        Any expression.
    time : sympy.Symbol
        What depends on it belongs to the basis functions.

    Returns
    -------
    dict[Expr, Expr]
        {basis function: coefficient}, in the canonical order of the expanded sum. The basis
        function 1 carries what is constant.
    """
    gathered: dict[sp.Expr, list[sp.Expr]] = {}
    for term in sp.Add.make_args(expanded(expr)):
        coefficient: list[sp.Expr] = []
        basis: list[sp.Expr] = []
        for factor in sp.Mul.make_args(term):
            (basis if time in factor.free_symbols else coefficient).append(factor)
        gathered.setdefault(sp.Mul(*basis), []).append(sp.Mul(*coefficient))
    totals = {basis: sp.Add(*parts) for basis, parts in gathered.items()}
    return {basis: total for basis, total in totals.items() if total != 0}


def assemble(terms: dict[sp.Expr, sp.Expr]) -> sp.Expr:
    """Sum coefficient × basis function: the inverse of `collect`."""
    return sp.Add(*(coefficient * basis for basis, coefficient in terms.items()))


def ratio(expr: sp.Expr) -> sp.Expr:
    """Bring a coefficient to one fraction in lowest terms, by exact rational algebra.

    Radicals count as independent quantities whose radicand is brought to lowest terms first,
    so √(ω² − r² + r²) is ω for a positive ω.
    """
    if expr.is_Atom:
        return expr
    radicals = {
        power: sp.Pow(sp.factor(ratio(power.base)), power.exp)
        for power in _ordered(expr.atoms(sp.Pow))
        if power.exp.is_Rational and not power.exp.is_Integer and not power.base.is_number
    }
    return sp.cancel(expr.xreplace(radicals) if radicals else expr)


def _ordered(expressions: Iterable[sp.Basic]) -> list[sp.Basic]:
    """Sort a set into an order that does not depend on hashes."""
    return sorted(expressions, key=sp.default_sort_key)


def same(left: sp.Expr, right: sp.Expr) -> bool:
    """Whether two coefficients are equal, proven by exact rational algebra.

    False means that they differ or that this algebra cannot prove them equal.
    """
    return bool(left == right or ratio(left - right) == 0)


def shortened(expr: sp.Expr, longest: int = 200) -> str:
    """An expression as text for a message."""
    text = str(expr)
    return text if len(text) <= longest else text[:longest] + " …"
