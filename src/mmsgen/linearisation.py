"""First-order Taylor coefficients of equations of motion about rest at the origin."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from .errors import ModelError
from .terms import assemble, collect, motion

__all__ = ["LinearPart", "linear_part"]

# they have no Taylor expansion where their argument changes sign; functions of time alone may
_NOT_SMOOTH = (sp.Abs, sp.sign, sp.Piecewise, sp.Heaviside, sp.Min, sp.Max, sp.floor, sp.ceiling)


@dataclass(frozen=True)
class LinearPart:
    """M q'' + C q' + K q = f: the linear part of the equations of motion.

    Parameters
    ----------
    M, C, K : sympy.ImmutableDenseMatrix
        n × n, functions of time and the parameters.
    f : sympy.ImmutableDenseMatrix
        n × 1, a function of time without a constant part.
    """

    M: sp.ImmutableDenseMatrix
    C: sp.ImmutableDenseMatrix
    K: sp.ImmutableDenseMatrix
    f: sp.ImmutableDenseMatrix


class _State:
    """Plain symbols in place of coordinates, velocities and accelerations."""

    def __init__(self, coordinates: Sequence[sp.Expr], time: sp.Symbol) -> None:
        self.symbols: dict[sp.Symbol, tuple[int, int]] = {}  # symbol: (order, coordinate)
        self.plain: dict[sp.Expr, sp.Symbol] = {}
        for j, q in enumerate(coordinates):
            for order, function in enumerate(motion(q, time)):
                symbol = sp.Symbol(f"state {order} {j}")
                self.symbols[symbol] = (order, j)
                self.plain[function] = symbol
        self.rest = dict.fromkeys(self.symbols, sp.S.Zero)


def linear_part(
    equations: Sequence[sp.Expr], coordinates: Sequence[sp.Expr], time: sp.Symbol
) -> LinearPart:
    """Linearise about q = q' = q'' = 0.

    Parameters
    ----------
    equations : sequence of sympy.Expr
        Left-hand sides, each = 0.
    coordinates : sequence of sympy.Expr
        The functions of time q_j(t).
    time : sympy.Symbol
        The time.

    Raises
    ------
    ModelError
        If the origin is no equilibrium (a constant force remains there), if an equation has no
        Taylor expansion about it, or if the mass matrix is singular for all parameters.
    """
    n = len(coordinates)
    state = _State(coordinates, time)
    matrices = [sp.zeros(n, n) for _ in range(3)]
    force = sp.zeros(n, 1)
    for row, equation in enumerate(equations):
        entries: dict[tuple[int, int] | None, list[sp.Expr]] = {}
        for basis, coefficient in collect(equation, time).items():
            for place, slope in _slopes(basis, state, coordinates[row]):
                entries.setdefault(place, []).append(coefficient * slope)
        for place, parts in entries.items():
            terms = collect(sp.Add(*parts), time)
            if place is None:
                _check_equilibrium(terms, coordinates[row])
                force[row] = -assemble(terms)
            else:
                order, column = place
                matrices[order][row, column] = assemble(terms)
    _check_mass_matrix(matrices[2], coordinates)
    stiffness, damping, mass = (sp.ImmutableDenseMatrix(m) for m in matrices)
    return LinearPart(mass, damping, stiffness, sp.ImmutableDenseMatrix(force))


def _slopes(
    basis: sp.Expr, state: _State, q: sp.Expr
) -> list[tuple[tuple[int, int] | None, sp.Expr]]:
    """Find the value at rest (place None) and the nonzero first derivatives of a basis function."""
    plain = basis.xreplace(state.plain)
    present = [s for s in state.symbols if s in plain.free_symbols]
    if not present:
        return [(None, plain)]
    if _vanishes_twice(plain, state):
        return []
    if any(f.free_symbols & set(present) for f in plain.atoms(*_NOT_SMOOTH)):
        raise ModelError(
            f"the equation of {q} contains {basis}, which has no Taylor expansion about rest: "
            "linearisation needs smooth functions"
        )
    explicit = [f.as_base_exp() for f in sp.Mul.make_args(plain)]
    powers = {s: e for s, e in explicit if s in state.symbols}
    if all(e.is_Integer and e.is_positive for e in powers.values()) and sum(powers.values()) > 1:
        if not _finite(sp.Mul(*(b**e for b, e in explicit if b not in powers)), state):
            raise _singular(basis, q)
        return []
    result: list[tuple[tuple[int, int] | None, sp.Expr]] = [(None, plain.xreplace(state.rest))]
    result += [(state.symbols[s], plain.diff(s).xreplace(state.rest)) for s in present]
    if any(value.has(sp.nan, sp.zoo, sp.oo, -sp.oo) for _, value in result):
        raise _singular(basis, q)
    return [(place, value) for place, value in result if value != 0]


def _vanishes_twice(plain: sp.Expr, state: _State) -> bool:
    """Whether a product of powers, moduli and signs has no slope at rest, as |v| v has none.

    Its degree is above 1, and what is not a power of a modulus or sign is bounded there.
    """
    degree = 0
    for factor in sp.Mul.make_args(plain):
        base, exponent = factor.as_base_exp()
        inner = base.args[0] if isinstance(base, sp.Abs | sp.sign) else base
        if inner not in state.symbols:
            if factor.free_symbols & set(state.symbols):
                return False
            continue
        if not (exponent.is_Integer and exponent.is_positive):
            return False
        degree += 0 if isinstance(base, sp.sign) else int(exponent)
    return degree > 1


def _finite(expr: sp.Expr, state: _State) -> bool:
    return not expr.xreplace(state.rest).has(sp.nan, sp.zoo, sp.oo, -sp.oo)


def _singular(basis: sp.Expr, q: sp.Expr) -> ModelError:
    return ModelError(
        f"the equation of {q} contains {basis}, which is singular at rest: measure the "
        "coordinate from its equilibrium"
    )


def _check_equilibrium(terms: dict[sp.Expr, sp.Expr], q: sp.Expr) -> None:
    constant = terms.get(sp.S.One, sp.S.Zero)
    if constant != 0:
        raise ModelError(
            f"the origin is no equilibrium: in the equation of {q} the constant force "
            f"{-constant} remains at rest. Measure the coordinates from their equilibrium"
        )


def _check_mass_matrix(mass: sp.Matrix, coordinates: Sequence[sp.Expr]) -> None:
    """Refuse a mass matrix without full rank, whatever the parameters.

    Its rank is that of an exact rational matrix, in which every symbol and every function stands
    for an arbitrary number of its own.
    """
    values: dict[sp.Expr, sp.Rational] = {}
    for entry in mass:
        atoms = entry.atoms(sp.Function) | {p for p in entry.atoms(sp.Pow) if not p.exp.is_Integer}
        for atom in sorted(atoms, key=sp.default_sort_key):
            values.setdefault(atom, sp.Rational(sp.prime(len(values) + 40), 101))
        for symbol in sorted(entry.free_symbols, key=sp.default_sort_key):
            values.setdefault(symbol, sp.Rational(sp.prime(len(values) + 40), 103))
    numbers = mass.xreplace(values)
    if all(entry.is_Rational for entry in numbers) and numbers.rank() < mass.rows:
        listed = ", ".join(map(str, coordinates))
        raise ModelError(
            f"the mass matrix of ({listed}) is singular: the accelerations are not independent. "
            "Eliminate a coordinate, or give it inertia of its own"
        )
