"""What a nonlinear slow flow answers: equilibria, their stability, response and backbone."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any, cast, overload

import sympy as sp

from .equilibria import certified_equilibria, equilibria
from .errors import ExpansionError, MmsgenError
from .free_motion import FreePart, free_part, normal_modes
from .frequency_response import frequency_response
from .response_relation import OneAmplitude, one_amplitude
from .runtime._records import Backbone, Equilibria, Response
from .two_amplitudes import TwoAmplitudes, two_amplitudes

if TYPE_CHECKING:
    from .amplitude_flow import AmplitudeFlow
    from .slowflow import SlowFlow

__all__ = ["NonlinearAnswers"]


class NonlinearAnswers:
    """The part of `SlowFlow` that is of use for nonlinear slow flows alone."""

    if TYPE_CHECKING:

        @property
        def table(self) -> AmplitudeFlow:
            """Of the slow flow."""
            ...

        def _with_detunings(self, values: Mapping[Any, Any]) -> dict[str, Any]:
            """Of the slow flow."""
            ...

    def equilibria(self, values: Mapping[Any, Any]) -> Equilibria:
        """All equilibria of the autonomous slow flow, and how fast disturbances of each grow.

        Their amplitudes are those of the slow flow as it stands, all orders together.

        Parameters
        ----------
        values : mapping
            As for `growth_rate`; arrays broadcast.

        Returns
        -------
        Equilibria
            ``amplitudes`` (complex, shape (..., k, n)), ``drift``, ``growth``, ``modulus`` and
            ``stable``; NaN after the last equilibrium of a point. Circles of equilibria, of one
            amplitude also those that are there at these numbers only, as without force and
            damping, are listed by one point each, in increasing order of |B|; a point where
            equilibria fill curves for another reason, or all the plane, has none but NaN.

        Raises
        ------
        ExpansionError
            If no frame makes the slow flow autonomous.
        MmsgenError
            As for `growth_rate`; or if equilibria fill curves, as those of undamped free
            oscillators do, for which `backbone` is the answer; or if all terms of some amplitudes
            vanish. At a few points of many NaN is the answer there.
        """
        return equilibria(self.table, self._with_detunings(values))

    def certified(self, values: Mapping[Any, Any], found: Equilibria) -> Any:
        """Which equilibria are proved: there is exactly one close by, by Kantorovich's theorem.

        Rounding is bounded, so that it is part of the proof. At folds and other bifurcations, where
        the Jacobian is singular, and close to them nothing can be proved.

        Parameters
        ----------
        values : mapping
            As for `equilibria`.
        found : Equilibria
            At these values.

        Returns
        -------
        numpy.ndarray of bool
            Shape (..., k); False where there is no equilibrium.

        Raises
        ------
        ExpansionError
            If no frame makes the slow flow autonomous.
        MmsgenError
            As for `growth_rate`; if the equilibria are of another slow flow or of other shapes.

        References
        ----------
        L. V. Kantorovich, *Functional analysis and applied mathematics* (1948), on Newton's method.
        """
        return certified_equilibria(self.table, self._with_detunings(values), found)

    def frequency_response(self, values: Mapping[Any, Any], over: Any = None) -> Response:
        """All equilibria along one parameter: branches through folds, stability, bifurcations.

        Parameters
        ----------
        values : mapping
            As for `growth_rate`, all of them numbers but one, which is an array of one dimension.
        over : symbol or str, optional
            The parameter that varies; by default the one whose value is an array. A frequency that
            a detuning follows from is as good as the detuning.

        Returns
        -------
        Response
            ``branches``, at the given values in order along each curve and at its folds, and
            ``bifurcations``: saddle-nodes, pitchforks, transcritical and Hopf points.

        Raises
        ------
        ExpansionError
            If no frame makes the slow flow autonomous.
        MmsgenError
            As for `equilibria`; or if not exactly one value is an array of one dimension.
        """
        return frequency_response(self.table, self._with_detunings, values, over)

    # -- formulas ------------------------------------------------------

    @cached_property
    def _one_amplitude(self) -> OneAmplitude:
        return one_amplitude(cast("SlowFlow", self))

    def response_relation(
        self, of: sp.Expr | None = None, values: Mapping[Any, Any] | None = None
    ) -> sp.Expr:
        """The polynomial in a and the parameters that vanishes at equilibria with a > 0.

        The phases are eliminated exactly, and of two amplitudes the other one; powers of a, factors
        of the parameters alone and factors that have one sign are left out, repeated ones kept
        once. With one amplitude at order one it vanishes at equilibria and nowhere else. Where the
        phase occurs with several harmonics, as it does at higher orders, it vanishes at every
        equilibrium, and possibly also at isolated amplitudes without one: those at which two phases
        coincide that are not real. With two amplitudes it vanishes at all equilibria at which
        neither is zero, complex ones included, and at no others.

        Parameters
        ----------
        of : sympy.Expr, optional
            Of two coordinates the one whose amplitude stays.
        values : mapping, optional
            Of two amplitudes: rational numbers for some of the parameters and detunings; decimal
            fractions count as what is written.

        Returns
        -------
        sympy.Expr
            In a = 2|B|, for a free self-excited oscillator as well; what it has is then a circle.

        Raises
        ------
        ExpansionError
            If there are more than two amplitudes; if no frame makes the slow flow autonomous; if
            equilibria fill a curve; if constant phases cannot be turned away; of two amplitudes if
            the relation would have too many terms, as of the resonance 1:1 with all its parameters:
            values for some of them, or `amplitude_relations`, help.
        MmsgenError
            If `of` is no coordinate; if a value is no rational number, or of no parameter.
        """
        coordinates = cast("SlowFlow", self).case.coordinates
        if len(coordinates) == 1 and of in (None, *coordinates):
            found = self._one_amplitude.relation
            return found if values is None else found.subs(dict(values))
        own = self._two_amplitudes(values)
        return own.relation(self._place(of))

    def amplitude_relations(
        self, values: Mapping[Any, Any] | None = None
    ) -> tuple[sp.Expr, sp.Expr]:
        """Two polynomials in both amplitudes that vanish at equilibria where neither is zero.

        Both phases, and the rate of a drift, are eliminated exactly, with factors left out as in
        `response_relation`. Often one of them contains one amplitude alone, or both at low powers.

        Parameters
        ----------
        values : mapping, optional
            As for `response_relation`.

        Returns
        -------
        tuple of sympy.Expr
            The shorter one first.

        Raises
        ------
        ExpansionError, MmsgenError
            As for `response_relation`.
        """
        return self._two_amplitudes(values).relations

    def _two_amplitudes(self, values: Mapping[Any, Any] | None) -> TwoAmplitudes:
        return two_amplitudes(cast("SlowFlow", self), values)

    def _place(self, of: Any) -> int:
        """The number of a coordinate whose amplitude is meant."""
        coordinates = cast("SlowFlow", self).case.coordinates
        if of is None and len(coordinates) == 1:
            return 0
        if of not in coordinates:
            names = ", ".join(map(str, coordinates))
            raise MmsgenError(f"of is the coordinate whose amplitude is meant, one of {names}")
        return list(coordinates).index(of)

    @overload
    def backbone(self) -> dict[sp.Symbol, sp.Expr]: ...

    @overload
    def backbone(
        self, values: Mapping[Any, Any], amplitude: Any, of: sp.Expr | None = None
    ) -> Backbone: ...

    def backbone(
        self, values: Mapping[Any, Any] | None = None, amplitude: Any = None, of: Any = None
    ) -> dict[sp.Symbol, sp.Expr] | Backbone:
        """The backbone curve of one amplitude, or the free motions of several at numbers.

        The curve is where the phase stands still by the terms alone that do not depend on it, those
        of resonant forces left out. With several amplitudes it consists of the normal modes: the
        periodic motions that are left without forces and without damping, families of which the
        amplitude of one coordinate picks single ones. They are as complete as `equilibria`.

        Parameters
        ----------
        values : mapping, optional
            As for `growth_rate`, without the detunings of forces; arrays broadcast.
        amplitude : array_like, optional
            a of one coordinate, not negative.
        of : sympy.Expr, optional
            That coordinate; by default the only one.

        Returns
        -------
        dict
            Without values, for one amplitude: {detuning: expression in a}; for a free oscillator
            {γ: dγ/dt as an expression in a}, the shift of its frequency.
        Backbone
            With values: ``amplitudes`` (complex, shape (..., k, n)), ``shift`` of the frequency of
            each coordinate, ``detuning`` of a force at that frequency, ``growth``, ``modulus`` and
            ``stable``; NaN after the last motion of a point, and where the amplitude is zero.
            Motions in which coordinates swing at frequencies of their own, without a resonance
            between them, are left out.

        Raises
        ------
        ExpansionError
            As for `response_relation`; or if the detuning does not follow from a linear equation;
            of several amplitudes if no values are given.
        MmsgenError
            If a value is missing; if `of` is no coordinate; if energy is not conserved without
            the damping of single amplitudes, as where damping couples phases.
        """
        coordinates = cast("SlowFlow", self).case.coordinates
        if values is None and len(coordinates) > 1:
            raise ExpansionError(
                "several amplitudes have no single backbone curve; .backbone needs values and an "
                "amplitude, and then lists all free motions in which one coordinate has that"
            )
        if values is None:
            return dict(self._one_amplitude.backbone)
        place = self._place(of)
        return normal_modes(self._free, self._with_detunings(values), amplitude, place)

    @cached_property
    def _free(self) -> FreePart:
        return free_part(cast("SlowFlow", self))

    def bifurcation_equations(self) -> dict[str, tuple[sp.Expr, ...]]:
        """Equations that hold where equilibria of one amplitude bifurcate.

        Returns
        -------
        dict
            Kind → expressions in a and the parameters that vanish there together:

            "saddle-node"
                The response relation and its derivative by a.
            "pitchfork"
                The determinant of the Jacobian at a = 0, where that is an equilibrium.
            "Hopf"
                The response relation and the trace of the Jacobian, as it is there; the
                determinant has to be positive. Left out where three or more harmonics of the phase
                are in the way. For a free oscillator the growth rate at a = 0 instead.
            "Hopf of zero"
                The trace at a = 0, where that is an equilibrium of an oscillator that is not free.

            Kinds that cannot occur, as expressions of one sign show, are missing.

        Raises
        ------
        ExpansionError
            As for `response_relation`.
        """
        return dict(self._one_amplitude.bifurcations)
