"""`Model`: coordinates, parameters, Lagrangian, dissipation and forces of a system.

Source: Lagrange's equations of the second kind with Rayleigh's dissipation function, as in
Goldstein, *Classical Mechanics*, chapter 1.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

import sympy as sp

from .equations import EquationsOfMotion
from .errors import ModelError
from .parameters import Parameter
from .terms import assemble, collect, expanded, motion
from .validation import (
    TIME,
    as_expression,
    as_parameters,
    check_accelerations,
    check_content,
    check_coordinates,
    check_definitions,
)

__all__ = ["Model"]


@dataclass(frozen=True)
class Model:
    """A mechanical system, given by its Lagrangian or by its equations.

    Parameters
    ----------
    lagrangian : sympy.Expr
        L(q, q', t): kinetic minus potential energy. Nothing needs to be small or linear.
    coordinates : sequence of sympy.Expr
        Functions of time, made by ``sympy.physics.mechanics.dynamicsymbols``.
    parameters : sequence of Parameter or sympy.Symbol
        Everything else that occurs. A bare symbol becomes a parameter without unit or meaning.
    dissipation : sympy.Expr
        Rayleigh's function R(q, q', t): the generalised force is −∂R/∂q'.
    forces : mapping of coordinate to sympy.Expr
        Further generalised forces, added to the right-hand side of a coordinate's equation.
    equations : tuple of sympy.Expr, optional
        Set by `from_equations` instead of a Lagrangian.

    Raises
    ------
    ModelError
        If something is undeclared, declared twice, inexact or not a function of time, or if a
        coordinate has no kinetic energy. The message names it and the remedy.
    """

    lagrangian: sp.Expr | None
    coordinates: Sequence[sp.Expr]
    parameters: Sequence[Parameter]
    dissipation: sp.Expr = sp.S.Zero
    forces: Mapping[sp.Expr, sp.Expr] = field(default_factory=dict, hash=False)
    equations: tuple[sp.Expr, ...] | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        if not _is_list(self.coordinates):
            raise ModelError(f"coordinates must be a list, got {self.coordinates!r}")
        _set(self, "coordinates", tuple(self.coordinates))
        _set(self, "parameters", as_parameters(self.parameters))
        check_coordinates(self.coordinates, self.parameters)
        check_definitions(self.parameters)
        if self.equations is not None:
            self._check_equations(self.equations)
        else:
            self._check_lagrangian()

    def _check_lagrangian(self) -> None:
        lagrangian = _written_out(as_expression(self.lagrangian, "the Lagrangian"))
        dissipation = _written_out(as_expression(self.dissipation, "the dissipation function"))
        check_content(lagrangian, "the Lagrangian", self.coordinates, self.parameters, 1)
        check_content(dissipation, "the dissipation function", self.coordinates, self.parameters, 1)
        forces: dict[sp.Expr, sp.Expr] = {}
        if not isinstance(self.forces, Mapping):
            raise ModelError(f"forces must be a mapping {{coordinate: force}}, got {self.forces!r}")
        for q, force in self.forces.items():
            if q not in self.coordinates:
                known = ", ".join(map(str, self.coordinates))
                raise ModelError(f"a force acts on {q}, which is no coordinate: use one of {known}")
            where = f"the force on {q}"
            forces[q] = _written_out(as_expression(force, where))
            check_content(forces[q], where, self.coordinates, self.parameters, 2)
        _set(self, "lagrangian", lagrangian)
        _set(self, "dissipation", dissipation)
        _set(self, "forces", MappingProxyType(forces))
        _check_kinetic_energy(lagrangian, self.coordinates)

    def _check_equations(self, equations: tuple[sp.Expr, ...]) -> None:
        if self.lagrangian is not None or self.dissipation != 0 or self.forces:
            raise ModelError("give either a Lagrangian or equations, not both")
        if len(equations) != len(self.coordinates):
            raise ModelError(
                f"{len(equations)} equations for {len(self.coordinates)} coordinates: "
                "give one equation for each coordinate"
            )
        for number, equation in enumerate(equations, start=1):
            check_content(equation, f"equation {number}", self.coordinates, self.parameters, 2)
        check_accelerations(equations, self.coordinates)

    @classmethod
    def from_equations(
        cls,
        equations: Sequence[sp.Expr | sp.Eq],
        coordinates: Sequence[sp.Expr],
        parameters: Sequence[Parameter | sp.Symbol],
    ) -> Model:
        """Make a model from its equations of motion.

        Parameters
        ----------
        equations : sequence of sympy.Expr or sympy.Eq
            One for each coordinate, of second order; an expression means expression = 0.
        coordinates, parameters
            As for a `Model`.

        Raises
        ------
        ModelError
            As for a `Model`; also if the number of equations is not that of the coordinates, or
            one has no second derivative.
        """
        if not _is_list(equations):
            raise ModelError(f"equations must be a list, got {equations!r}")
        parts = []
        for number, equation in enumerate(equations, start=1):
            where = f"equation {number}"
            if isinstance(equation, sp.Eq):
                left = as_expression(equation.lhs, where)
                equation = left - as_expression(equation.rhs, where)
            parts.append(_written_out(as_expression(equation, where)))
        return cls(None, coordinates, as_parameters(parameters), equations=tuple(parts))

    def equations_of_motion(self) -> EquationsOfMotion:
        """Derive the exact equations, d/dt ∂L/∂q' − ∂L/∂q + ∂R/∂q' − F = 0 for every coordinate.

        Products are multiplied out, and products of sines and cosines are written as sums, so
        that terms which cancel do cancel. Nothing is neglected.

        Returns
        -------
        EquationsOfMotion
            With the parameters that occur in the equations.
        """
        if self.equations is not None:
            sides = list(self.equations)
        else:
            assert self.lagrangian is not None
            resisting = _velocity_gradient(self.dissipation, self.coordinates)
            sides = [
                inertial + resistance - self.forces.get(q, sp.S.Zero)
                for q, inertial, resistance in zip(
                    self.coordinates,
                    _lagrange(self.lagrangian, self.coordinates),
                    resisting,
                    strict=True,
                )
            ]
        exact = [assemble(collect(side, TIME)) for side in sides]
        return EquationsOfMotion.with_occurring(exact, self.coordinates, self.parameters)

    def _repr_latex_(self) -> str:
        from sympy.physics.vector.printing import vlatex

        if self.lagrangian is not None:
            return rf"$\displaystyle L = {vlatex(self.lagrangian)}$"
        return str(self.equations_of_motion()._repr_latex_())


def _set(record: Model, name: str, value: object) -> None:
    """Normalise a field of a frozen record while it is being built."""
    object.__setattr__(record, name, value)


def _is_list(value: object) -> bool:
    """Whether a value is a sequence of expressions rather than one expression, text or nothing."""
    return isinstance(value, Iterable) and not isinstance(value, sp.Basic | str)


def _written_out(expr: sp.Expr) -> sp.Expr:
    """Carry out derivatives of expressions that SymPy holds unevaluated, such as d(q²)/dt."""
    if any(not d.expr.is_Function for d in expr.atoms(sp.Derivative)):
        return expr.doit()
    return expr


def _plain_velocities(coordinates: Sequence[sp.Expr]) -> dict[sp.Expr, sp.Symbol]:
    """Symbols in place of velocities: SymPy differentiates by them much faster."""
    return {motion(q, TIME)[1]: sp.Symbol(f"velocity {j}") for j, q in enumerate(coordinates)}


def _velocity_gradient(expr: sp.Expr, coordinates: Sequence[sp.Expr]) -> list[sp.Expr]:
    """∂/∂q' for every coordinate."""
    plain = _plain_velocities(coordinates)
    if expr.has(sp.Abs, sp.sign):  # SymPy needs to know that what they are taken of is real
        plain = {velocity: sp.Symbol(s.name, real=True) for velocity, s in plain.items()}
    back = {symbol: velocity for velocity, symbol in plain.items()}
    there = expr.xreplace(plain)
    return [_with_moduli(there.diff(symbol)).xreplace(back) for symbol in plain.values()]


def _with_moduli(expr: sp.Expr) -> sp.Expr:
    """Write x sgn x as |x|, as it comes from differentiating powers of |x|."""
    for function in sorted(expr.atoms(sp.sign), key=sp.default_sort_key):
        x = function.args[0]
        terms = sp.Add.make_args(sp.expand(expr))
        written = ((term, term.xreplace({function: sp.Abs(x) / x})) for term in terms)
        expr = sp.Add(*(old if new.has(1 / x) else new for old, new in written))
    return expr


def _check_kinetic_energy(lagrangian: sp.Expr, coordinates: Sequence[sp.Expr]) -> None:
    """Every velocity occurs at least to the second degree, alone or with another one."""
    plain = _plain_velocities(coordinates)
    bases = [basis.xreplace(plain) for basis in collect(lagrangian, TIME)]
    for q, velocity in zip(coordinates, plain.values(), strict=True):
        if not any(_curved(basis, velocity, plain.values()) for basis in bases):
            raise ModelError(
                f"the coordinate {q} has no kinetic energy: its velocity does not occur squared "
                "in the Lagrangian. Give it inertia, or eliminate it"
            )


def _curved(basis: sp.Expr, velocity: sp.Symbol, velocities: Iterable[sp.Symbol]) -> bool:
    """Whether the slope in one velocity depends on some velocity."""
    if velocity not in basis.free_symbols:
        return False
    return not basis.diff(velocity).free_symbols.isdisjoint(velocities)


def _lagrange(lagrangian: sp.Expr, coordinates: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Left-hand sides d/dt ∂L/∂q' − ∂L/∂q, from SymPy's `LagrangesMethod`.

    Lagrange's equations are linear in the Lagrangian, and its terms repeat: the blades of a rotor
    differ by the names of their coordinates and by static phases. So `LagrangesMethod` gets every
    distinct term once, in standard coordinates and with a symbol for the phase, and its equations
    are summed with the terms' coefficients.
    """
    from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols  # loads slowly

    standard = dynamicsymbols(f"standard_1:{len(coordinates) + 1}")
    phase = sp.Symbol("static phase", real=True)
    known: dict[sp.Expr, list[sp.Expr]] = {}
    sides: list[list[sp.Expr]] = [[] for _ in coordinates]
    for basis, coefficient in collect(lagrangian, TIME).items():
        functions = basis.atoms(sp.Function)
        present = [j for j, q in enumerate(coordinates) if q in functions]
        if not present:  # a function of time alone moves nothing
            continue
        there = _renaming([coordinates[j] for j in present], standard)
        back = {new: old for old, new in there.items()}
        term, back[phase] = _with_free_phase(basis.xreplace(there), phase)
        if term not in known:
            method = LagrangesMethod(term, standard[: len(present)])
            known[term] = [expanded(e) for e in method.form_lagranges_equations()]
        for j, side in zip(present, known[term], strict=True):
            sides[j].append(coefficient * side.xreplace(back))
    return [sp.Add(*parts) for parts in sides]


def _with_free_phase(term: sp.Expr, phase: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """Put a symbol in place of the static phase of a term's sine or cosine; the phase itself."""
    for function in sp.Mul.make_args(term):
        if isinstance(function, sp.cos | sp.sin):
            angle = function.args[0]
            static = sp.Add(*(p for p in sp.Add.make_args(angle) if (p / sp.pi).is_Rational))
            free = function.func(angle - static + phase)
            return term.xreplace({function: free}), static
    return term, sp.S.Zero


def _renaming(old: Iterable[sp.Expr], new: Iterable[sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    """Coordinates, velocities and accelerations, in one simultaneous renaming."""
    pairs: dict[sp.Expr, sp.Expr] = {}
    for q, s in zip(old, new, strict=False):
        pairs.update(zip(motion(q, TIME), motion(s, TIME), strict=True))
    return pairs
