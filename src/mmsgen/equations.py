"""`EquationsOfMotion`: the exact equations, linear or not, in any set of parameters."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import sympy as sp

from .equilibrium import Equilibrium, equilibria
from .errors import ModelError
from .linearisation import LinearPart, linear_part
from .parameters import Parameter
from .reparametrisation import reparametrised
from .shifting import about
from .terms import assemble, collect, motion
from .validation import (
    TIME,
    as_expression,
    as_parameters,
    check_accelerations,
    check_content,
    check_coordinates,
    check_definitions,
)

if TYPE_CHECKING:
    from .scaling import ScaledSystem

__all__ = ["EquationsOfMotion"]


@dataclass(frozen=True)
class EquationsOfMotion:
    """Equations of motion, exact: nothing is neglected unless `linearise` was called.

    Parameters
    ----------
    equations : tuple of sympy.Expr
        Left-hand sides; equation j belongs to coordinate j and reads expression = 0. They contain
        the coordinates, their first and second derivatives, the parameters and time.
    coordinates : tuple of sympy.Expr
        The functions q_j(t).
    parameters : tuple of Parameter
        Those that occur in the equations, then those that only definitions need.

    Raises
    ------
    ModelError
        If the numbers of equations and coordinates differ, something is undeclared or inexact,
        or a coordinate has no acceleration.
    """

    equations: tuple[sp.Expr, ...]
    coordinates: tuple[sp.Expr, ...]
    parameters: tuple[Parameter, ...]

    def __post_init__(self) -> None:
        for name in ("equations", "coordinates"):
            object.__setattr__(self, name, tuple(getattr(self, name)))
        object.__setattr__(self, "parameters", as_parameters(self.parameters))
        check_coordinates(self.coordinates, self.parameters)
        check_definitions(self.parameters)
        if len(self.equations) != len(self.coordinates):
            raise ModelError(
                f"{len(self.equations)} equations for {len(self.coordinates)} coordinates: "
                "give one equation for each coordinate"
            )
        for q, equation in zip(self.coordinates, self.equations, strict=True):
            where = f"the equation of {q}"
            as_expression(equation, where)
            check_content(equation, where, self.coordinates, self.parameters, highest=2)
        check_accelerations(self.equations, self.coordinates)

    @classmethod
    def with_occurring(
        cls,
        equations: Iterable[sp.Expr],
        coordinates: Sequence[sp.Expr],
        parameters: Sequence[Parameter],
    ) -> EquationsOfMotion:
        """Build the record from more parameters than occur, in an order that stays.

        Parameters
        ----------
        equations, coordinates
            As for the record.
        parameters : sequence of Parameter
            Those that occur nowhere are left out, and those that only the definitions of others
            contain come last.

        Returns
        -------
        EquationsOfMotion
        """
        equations = tuple(equations)
        occurring = {s for equation in equations for s in equation.free_symbols}
        needed, new = set(occurring), set(occurring)
        definitions = {p.symbol: p.definition for p in parameters if p.definition is not None}
        while new:
            new = {s for d in new if d in definitions for s in definitions[d].free_symbols} - needed
            needed |= new
        first = [p for p in parameters if p.symbol in occurring]
        last = [p for p in parameters if p.symbol in needed - occurring]
        return cls(equations, tuple(coordinates), (*first, *last))

    @property
    def time(self) -> sp.Symbol:
        """The time, ``sympy.physics.mechanics.dynamicsymbols._t``."""
        return TIME

    @cached_property
    def _linear(self) -> LinearPart:
        return linear_part(self.equations, self.coordinates, TIME)

    @property
    def M(self) -> sp.ImmutableDenseMatrix:
        """Mass matrix of the linear part, n × n: M q'' + C q' + K q = f."""
        return self._linear.M

    @property
    def C(self) -> sp.ImmutableDenseMatrix:
        """Damping and gyroscopic matrix of the linear part, n × n."""
        return self._linear.C

    @property
    def K(self) -> sp.ImmutableDenseMatrix:
        """Stiffness matrix of the linear part, n × n."""
        return self._linear.K

    @property
    def f(self) -> sp.ImmutableDenseMatrix:
        """Force on the system at rest, n × 1, a function of time without a constant part."""
        return self._linear.f

    def linearise(self) -> EquationsOfMotion:
        """Linear equations about rest at the origin.

        Returns
        -------
        EquationsOfMotion
            M q'' + C q' + K q − f = 0. A force that varies with time is kept.

        Raises
        ------
        ModelError
            If the origin is no equilibrium, naming the equation and the force that remains, or if
            an equation cannot be expanded there.
        """
        equations = [self._linear_side(row) for row in range(len(self.coordinates))]
        return self.with_occurring(equations, self.coordinates, self.parameters)

    def _linear_side(self, row: int) -> sp.Expr:
        """One row of M q'' + C q' + K q − f, with like terms collected."""
        terms = collect(-self.f[row], TIME)
        for column, q in enumerate(self.coordinates):
            for matrix, function in zip((self.K, self.C, self.M), motion(q, TIME), strict=True):
                for basis, coefficient in collect(matrix[row, column], TIME).items():
                    terms[basis * function] = coefficient
        return assemble(terms)

    def reparametrise(
        self,
        mapping: Mapping[sp.Symbol | str, sp.Expr | int],
        parameters: Iterable[Parameter | sp.Symbol] = (),
        eliminate: Iterable[sp.Symbol | str] = (),
    ) -> EquationsOfMotion:
        """Write the equations in other parameters, with a proof that the old ones are gone.

        All replacements are made at once. Then each equation is divided by the coefficient of its
        own acceleration, where that is constant in time, and every coefficient is brought to
        lowest terms by exact rational algebra.

        Parameters
        ----------
        mapping : mapping of symbol or name to expression
            Old parameter: its expression in the new and the remaining ones. Zero drops a term.
        parameters : sequence of Parameter or sympy.Symbol
            The new parameters. A `definition` is checked to be the inverse of `mapping`. Symbols
            that are not given here are declared without unit and meaning.
        eliminate : sequence of symbols or names
            Further parameters that must cancel, although `mapping` does not replace them: what is
            left of the units of mass and length once everything is written in ratios.

        Returns
        -------
        EquationsOfMotion
            Without the old parameters in its equations; those that a definition needs stay among
            its `parameters`, behind the others.

        Raises
        ------
        ModelError
            If an old parameter survives (naming it and the equation), is unknown, or if a
            definition contradicts the mapping.
        """
        equations, declared = reparametrised(self, mapping, parameters, eliminate)
        return self.with_occurring(equations, self.coordinates, declared)

    def equilibria(self, neglecting: Iterable[sp.Symbol | str] = ()) -> tuple[Equilibrium, ...]:
        """Find equilibria in closed form.

        Parameters
        ----------
        neglecting : iterable of symbols or names
            Parameters that are zero for it: those of the excitation, and small ones.

        Returns
        -------
        tuple of Equilibrium
            Those that were found, each with its check; of angles within one turn. Points that are
            not real, or are shown to be no equilibrium, are left out.

        Raises
        ------
        EquilibriumError
            If the static equations depend on time, are not solved in closed form, have no real
            solution, or leave a coordinate free.
        """
        return equilibria(self, neglecting)

    def about(
        self,
        equilibrium: Equilibrium | Mapping[sp.Expr, sp.Expr | int],
        *,
        eliminate: Mapping[sp.Symbol | str, sp.Expr | int] | None = None,
        parameters: Iterable[Parameter | sp.Symbol] = (),
        neglecting: Iterable[sp.Symbol | str] = (),
    ) -> EquationsOfMotion:
        """Measure the coordinates from an equilibrium, q = q_e + (new) q, under the same symbol.

        That the static equations vanish there is proven by exact algebra. Every coefficient of the
        result has one normal form, in which names of radicals, sines and cosines stand for these.

        Parameters
        ----------
        equilibrium : Equilibrium or mapping of coordinate to expression
            Constant values in parameters, old or new; coordinates that are not named stay.
        eliminate : mapping of symbol or name to expression
            Parameters written in others at the same time, as by `reparametrise`. Where q_e is a
            symbol of its own, its equation is solved for one parameter here: so every coefficient
            stays rational, as in ``about({x: x_0}, eliminate={alpha: k / x_0**2})``.
        parameters : sequence of Parameter or sympy.Symbol
            New parameters. A `definition` by a function or radical makes a parameter its name:
            sin(theta_0) and cos(theta_0) have to be named, so that coefficients are rational.
        neglecting : iterable of symbols or names
            Small parameters whose constant forces may remain at rest.

        Returns
        -------
        EquationsOfMotion

        Raises
        ------
        EquilibriumError
            If the point is no equilibrium, naming the equation and the force that remains; if that
            cannot be decided exactly; or if a sine or cosine has no name.
        ModelError
            As for `reparametrise`.
        """
        equations, declared = about(self, equilibrium, eliminate or {}, parameters, neglecting)
        return self.with_occurring(equations, self.coordinates, declared)

    def scale(
        self,
        orders: Mapping[sp.Symbol | str, int],
        amplitude: int | sp.Rational | Mapping[sp.Expr, int | sp.Rational] = 0,
    ) -> ScaledSystem:
        """Say what is small: each parameter's and the motion's order in ε.

        Parameters
        ----------
        orders : mapping of parameter to int
            The power of ε that each small parameter carries.
        amplitude : int, Rational or mapping of coordinate to such
            The power of ε that the coordinates carry.

        Returns
        -------
        ScaledSystem
            The equations as truncated polynomials, ready to be expanded.

        Raises
        ------
        ScalingError
            If a parameter is unknown, or the leading order does not oscillate.
        """
        from .scaling import scale

        return scale(self, orders, amplitude)

    def _repr_latex_(self) -> str:
        from sympy.physics.vector.printing import vlatex

        rows = r" \\ ".join(f"{vlatex(equation)} &= 0" for equation in self.equations)
        return rf"$\displaystyle \begin{{aligned}} {rows} \end{{aligned}}$"
