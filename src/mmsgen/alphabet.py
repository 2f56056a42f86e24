"""What an expression is made of: generators of the coefficient field, phasors, roots of unity.

A first walk over the equations finds every frequency and static phase inside a trigonometric
function or exponential, and every radical, so that `taylor` can then work in one exact algebra.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd, lcm

import sympy as sp

from .cyclotomic import gauss_sum
from .errors import ScalingError
from .field import ParameterField

__all__ = ["CONSTANT_NAMES", "Alphabet", "Phasor", "fraction", "phase_terms", "survey"]

PERIODIC = (sp.cos, sp.sin, sp.exp, sp.tan, sp.cot, sp.sec, sp.csc)
CONSTANTS = (sp.pi, sp.E, sp.EulerGamma, sp.GoldenRatio, sp.Catalan)
CONSTANT_NAMES = {f"<{c}>": c for c in CONSTANTS}
"""Generator name of each constant: no identifier, so that no parameter can have it."""

KINKED = (sp.Abs, sp.sign)

INVERSE = (sp.asin, sp.acos, sp.atan)
"""Their values are multiples of π."""


@dataclass(frozen=True)
class Phasor:
    """z = exp(i·step·base·t), or exp(i·step·base) for a constant phase.

    Attributes
    ----------
    base : sympy.Expr
        A frequency symbol or 1; for a constant phase any product of parameters.
    step : Fraction
        The largest step of which all frequencies over `base` are integer multiples.
    moving : bool
        True where the phase grows with time.
    """

    base: sp.Expr
    step: Fraction
    moving: bool

    @property
    def angle(self) -> sp.Expr:
        """The phase, over t where it moves."""
        return sp.Rational(self.step.numerator, self.step.denominator) * self.base


@dataclass(frozen=True)
class Alphabet:
    """The algebra in which a set of equations can be written exactly.

    Attributes
    ----------
    time : sympy.Symbol
    symbols : tuple of sympy.Symbol
        The parameters, in their declared order.
    field : ParameterField
        One generator per parameter (or per root of it that occurs) and per constant such as π.
    roots : dict
        Parameter name → q where the generator stands for its q-th root.
    phasors : tuple of Phasor
        Moving ones first.
    kinked : bool
        True where |·| or sgn of coordinates or velocities occurs.
    """

    time: sp.Symbol
    symbols: tuple[sp.Symbol, ...]
    field: ParameterField
    roots: dict[str, int]
    phasors: tuple[Phasor, ...]
    kinked: bool = False

    @property
    def positive(self) -> frozenset[str]:
        """The generators that are known to be positive."""
        return frozenset((*CONSTANT_NAMES, *(s.name for s in self.symbols if s.is_positive)))


@dataclass
class _Findings:
    steps: dict[tuple[bool, sp.Expr], Fraction] = field(default_factory=dict)
    order: int = 4
    roots: dict[str, int] = field(default_factory=dict)
    constants: set[sp.Expr] = field(default_factory=set)
    kinked: bool = False

    def step(self, moving: bool, base: sp.Expr, coefficient: Fraction) -> None:
        old = self.steps.get((moving, base), Fraction(0))
        self.steps[moving, base] = _fraction_gcd(old, coefficient)


def fraction(number: sp.Expr) -> Fraction:
    """A SymPy rational as a Fraction."""
    return Fraction(int(number.p), int(number.q))


def _fraction_gcd(a: Fraction, b: Fraction) -> Fraction:
    return Fraction(
        gcd(a.numerator * b.denominator, b.numerator * a.denominator),
        a.denominator * b.denominator,
    )


def phase_terms(
    angle: sp.Expr, time: sp.Symbol, moving_parts: frozenset[sp.Expr]
) -> tuple[list[tuple[sp.Expr, Fraction]], list[tuple[sp.Expr, Fraction]], Fraction, sp.Expr]:
    """Split the argument of a periodic function.

    Parameters
    ----------
    angle : sympy.Expr
        A real phase.
    time : sympy.Symbol
    moving_parts : frozenset
        The coordinates and their derivatives.

    Returns
    -------
    frequencies, phases : list of (base, coefficient)
        The parts linear in time and the constant parts.
    turn : Fraction
        The rational multiple of 2π.
    rest : sympy.Expr
        The terms with coordinates.

    Raises
    ------
    ScalingError
        If time enters other than linearly, or a frequency is no rational combination of symbols.
    """
    frequencies, phases, rest = [], [], []
    turn = Fraction(0)
    for term in sp.Add.make_args(sp.expand(angle)):
        coefficient, base = term.as_coeff_Mul()
        if term.atoms(sp.Function, sp.Derivative) & moving_parts:
            rest.append(term)
            continue
        if not coefficient.is_Rational:
            raise ScalingError(
                f"the phase {angle} contains the number {coefficient}: write it as a Rational "
                "or name it as a parameter"
            )
        if base == sp.pi:
            turn += fraction(coefficient) / 2
        elif base.has(time):
            frequency = sp.cancel(base / time)
            if frequency.has(time) or not (frequency.is_Symbol or frequency == 1):
                raise ScalingError(
                    f"the phase {angle} is not a rational combination of frequency symbols "
                    f"times {time} (offending part: {term}): name the frequency by one symbol"
                )
            frequencies.append((frequency, fraction(coefficient)))
        elif term != 0:
            phases.append((base, fraction(coefficient)))
    return frequencies, phases, turn, sp.Add(*rest)


def survey(
    expressions: Iterable[sp.Expr],
    time: sp.Symbol,
    symbols: Sequence[sp.Symbol],
    moving_parts: frozenset[sp.Expr],
) -> Alphabet:
    """Find the algebra for a set of expressions.

    Parameters
    ----------
    expressions : iterable of sympy.Expr
    time : sympy.Symbol
    symbols : sequence of sympy.Symbol
        The declared parameters.
    moving_parts : frozenset
        The coordinates and their derivatives.

    Raises
    ------
    ScalingError
        As for `phase_terms`.
    """
    found = _Findings()
    seen: set[sp.Expr] = set()
    for expression in expressions:
        for node in sp.preorder_traversal(expression):
            if node not in seen:
                seen.add(node)
                _inspect(node, time, moving_parts, found)
    names = [str(s.name) for s in symbols]
    names += [name for name, c in CONSTANT_NAMES.items() if c in found.constants]
    phasors = [
        Phasor(base, step, moving)
        for (moving, base), step in sorted(
            found.steps.items(), key=lambda item: (not item[0][0], _rank(item[0][1], symbols))
        )
        if step
    ]
    numbers = ParameterField(names, found.order)
    return Alphabet(time, tuple(symbols), numbers, found.roots, tuple(phasors), found.kinked)


def _rank(base: sp.Expr, symbols: Sequence[sp.Symbol]) -> tuple[int, str]:
    return (symbols.index(base) if base in symbols else len(symbols), sp.srepr(base))


def _inspect(
    node: sp.Basic, time: sp.Symbol, moving_parts: frozenset[sp.Expr], found: _Findings
) -> None:
    if isinstance(node, PERIODIC) and not (isinstance(node, sp.exp) and not node.args[0].has(sp.I)):
        angle = node.args[0] / sp.I if isinstance(node, sp.exp) else node.args[0]
        frequencies, phases, turn, _ = phase_terms(angle, time, moving_parts)
        for base, coefficient in frequencies:
            found.step(True, base, coefficient)
        for base, coefficient in phases:
            found.step(False, base, coefficient)
        found.order = lcm(found.order, turn.denominator)
    elif isinstance(node, sp.Pow) and node.exp.is_Rational and not node.exp.is_Integer:
        if node.base.is_Symbol:
            name = str(node.base.name)
            found.roots[name] = lcm(found.roots.get(name, 1), int(node.exp.q))
        elif node.exp.q == 2:
            at_rest = node.base.xreplace(dict.fromkeys(moving_parts, sp.Integer(0)))
            content = sp.Abs(at_rest.as_content_primitive()[0])
            squarefree = int(sp.ntheory.factor_.core(int(content.p * content.q)))
            if squarefree > 1:
                found.order = lcm(found.order, gauss_sum(squarefree)[0])
    elif node in CONSTANTS:
        found.constants.add(node)
    elif isinstance(node, INVERSE):
        found.constants.add(sp.pi)
    elif isinstance(node, KINKED) and node.atoms(sp.Function, sp.Derivative) & moving_parts:
        found.constants.add(sp.pi)  # their averages hold it
        found.kinked = True
