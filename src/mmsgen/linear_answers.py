"""What a linear slow flow answers: matrix, stability, boundaries, growth, motion from a start."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import sympy as sp

from .errors import ExpansionError, MmsgenError
from .initial_values import BeatingFormula, beating, beating_formulas, evolution
from .linear_flow import LinearFlow, linear_flow
from .numeric import compiled
from .parameters import by_key
from .runtime._beating import Beating
from .series import Series
from .uniform_numbers import integrated

if TYPE_CHECKING:
    from .amplitude_flow import AmplitudeFlow
    from .boundary import Stability
    from .expansion import Expansion
    from .slowflow import SlowFlow

__all__ = ["LinearAnswers"]

_ROUNDING = 1e-9
"""How far a detuning may be from what follows from the frequencies, over their sum."""


class LinearAnswers:
    """The part of `SlowFlow` that linear slow flows alone have.

    Attributes
    ----------
    case : Expansion
    rates : tuple of Series
    """

    if TYPE_CHECKING:

        @property
        def case(self) -> Expansion:
            """Of the slow flow."""
            ...

        @property
        def rates(self) -> tuple[Series, ...]:
            """Of the slow flow."""
            ...

        @property
        def table(self) -> AmplitudeFlow:
            """Of the slow flow."""
            ...

        def frame_rate(self, j: int) -> sp.Expr:
            """Of the slow flow."""
            ...

    @property
    def is_linear(self) -> bool:
        """True where every term holds exactly one amplitude."""
        ring = self.case.weak.ring
        keys = [key for rates in self.rates for key in rates]
        degrees = (sum(ring.packing.exponents(key)[: 2 * ring.n]) for key in keys)
        return all(d == 1 for d in degrees) and not any(any(ring.moduli(key)) for key in keys)

    @cached_property
    def linear(self) -> LinearFlow:
        """The matrix form of a linear slow flow, in its independent blocks.

        Raises
        ------
        ExpansionError
            If the slow flow is nonlinear, forced, or not autonomous in any frame.
        """
        if not self.is_linear:
            raise ExpansionError(
                "this slow flow is nonlinear or forced, so it has no matrix: use .cartesian and "
                ".jacobian"
            )
        self.frame_rate(0)
        return linear_flow(cast("SlowFlow", self))

    @property
    def matrix(self) -> sp.ImmutableDenseMatrix:
        """S with dB/dt = S B, over `variables`, in the autonomous frame; block-diagonal."""
        return self.linear.matrix

    @property
    def variables(self) -> tuple[sp.Expr, ...]:
        """The amplitudes, conjugated where the blocks need it, in the order of `matrix`."""
        return self.linear.variables

    def characteristic_polynomial(self, gamma: sp.Symbol) -> sp.Expr:
        """P(Γ) = det(Γ − S) as the product of its factors over the rationals.

        Parameters
        ----------
        gamma : sympy.Symbol
            Γ; amplitudes grow like e^{Γt}.
        """
        return self.linear.characteristic_polynomial(gamma)

    @cached_property
    def stability(self) -> Stability:
        """Whether the case can be unstable, why, and where."""
        return self.linear.stability

    def boundary(self) -> tuple[sp.Expr, ...]:
        """The edges of the unstable interval of the detuning as a formula, lower one first.

        Re-expanded in ε and cut after ε^N, N being the order of the case, so that each order has
        one form. It differs from `boundaries`, which takes the slow flow as it stands, by
        O(ε^{N+1}): that is what either of them differs from the truth by.

        Empty where the case has no unstable interval. Roots of negative numbers come out complex:
        at those values there is none.

        Raises
        ------
        ExpansionError
            If there is no closed form.
        """
        return self.stability.boundary()

    def growth_rate(self, values: Mapping[Any, Any]) -> Any:
        """Largest real part of Γ, in 1/s, for numbers or arrays that broadcast.

        An eigenvalue of the slow flow as it stands, all orders together; its error is O(ε^{N+1}).

        Parameters
        ----------
        values : mapping
            Symbol or name → value, for every parameter of the slow flow. A detuning follows from
            the frequencies of its relation where it is not given itself.

        Raises
        ------
        MmsgenError
            If a value is unknown, missing or out of the domain of its symbol, or a detuning
            contradicts the frequencies.
        """
        return self.linear.growth_rate(self._with_detunings(values))

    def _with_detunings(self, values: Mapping[Any, Any]) -> dict[str, Any]:
        """Values with σ = lhs − rhs of its relation where that can be told."""
        table = self.case.numbers(values)
        given = {name for name, _ in by_key(values)}
        for r in self.case.relations:
            symbols = tuple(sorted((r.lhs - r.rhs).free_symbols, key=str))
            names = [str(s.name) for s in symbols]
            if not all(n in table for n in names):
                continue
            (gap,) = compiled(symbols, (r.lhs - r.rhs,))(*(table[n] for n in names))
            name = str(r.detuning.name)
            if name in given and given.issuperset(names):
                size = sum(np.abs(table[n]) for n in names)
                if np.any(np.abs(table[name] - gap) > _ROUNDING * size):
                    raise MmsgenError(
                        f"{name} contradicts {', '.join(names)}: {name} = {r.lhs} - ({r.rhs}); "
                        "give the one or the other"
                    )
            table.setdefault(name, gap)
        return table

    def boundaries(self, values: Mapping[Any, Any]) -> Any:
        """Both edges of the unstable interval in the first detuning; NaN where there is none.

        Between them `growth_rate` is positive: they are the roots of a polynomial criterion of the
        slow flow as it stands, not re-expanded in ε, and differ from the formula of `boundary` by
        O(ε^{N+1}). The emitted `boundaries` and `critical_speeds` give the same. Where there are
        several intervals, `zones` lists them; this is the one nearest to the resonance, σ = 0.
        Where the criterion is of a higher degree than two in σ, none counts that begins farther
        away than half of the frequencies that resonate: out there a polynomial that is cut after
        a few powers means nothing.

        Parameters
        ----------
        values : mapping
            Symbol or name → value, for every parameter of the slow flow but the first detuning,
            which is ignored. Further detunings may follow from their frequencies.

        Returns
        -------
        numpy.ndarray
            Shape (..., 2), lower edge first, in the unit of the detuning; infinite where the
            interval has no end.

        Raises
        ------
        ExpansionError
            If there is no criterion.
        MmsgenError
            As for `growth_rate`.
        """
        return self.stability.boundaries(self._without_first(values))

    def zones(self, values: Mapping[Any, Any]) -> Any:
        """All unstable intervals of the first detuning at one point, in ascending order.

        Parameters
        ----------
        values : mapping
            As for `boundaries`, numbers alone.

        Returns
        -------
        numpy.ndarray
            Shape (count, 2).
        """
        return self.stability.zones(self._without_first(values))

    def _without_first(self, values: Mapping[Any, Any]) -> dict[str, Any]:
        """Values with the detunings after the first one, which is what is looked for."""
        first = {str(r.detuning.name) for r in self.case.relations[:1]}
        others = {name: v for name, v in by_key(values) if name not in first}
        table = self._with_detunings(others)
        return {name: v for name, v in table.items() if name not in first}

    # -- from given initial amplitudes ---------------------------------------------------

    def evolution(self, values: Mapping[Any, Any], amplitudes: Any, times: Any) -> Any:
        """Amplitudes B_j(t) from those at t = 0, in the autonomous frame.

        Of a linear slow flow by the matrix exponential: a closed form for blocks of one and two
        variables, scaling and squaring for larger ones, without eigenvectors, so that double
        eigenvalues do no harm. Of a nonlinear or driven one by integration in time (Dormand and
        Prince, order 8, relative tolerance 1e-11), for one start and one set of values.

        Parameters
        ----------
        values : mapping
            As for `growth_rate`.
        amplitudes : array_like
            B_j(0) = A_j(0), shape (..., n), in the order of the coordinates.
        times : array_like
            t in s, of either sign; broadcasts with the values and the leading axes of the
            amplitudes: one axis of times for one set of values.

        Returns
        -------
        numpy.ndarray
            Shape (..., n), complex128.

        Raises
        ------
        ExpansionError
            If the slow flow is not autonomous in any frame.
        MmsgenError
            As for `growth_rate`; if an amplitude or a time is not a finite number; if the
            amplitudes of a nonlinear slow flow grow beyond all bounds, or several starts or sets
            of values are given for one.
        """
        if not self.is_linear:
            return integrated(self.table, self._with_detunings(values), amplitudes, times)
        return evolution(self.linear, self.table, self._with_detunings(values), amplitudes, times)

    def beating(self, values: Mapping[Any, Any], amplitudes: Any) -> Beating:
        """How the amplitudes of a linear slow flow beat: period and largest modulus |B_j|.

        Closed forms where no mode decays; else a maximum that is searched for in time, with a bound
        of what it may miss.

        Parameters
        ----------
        values, amplitudes
            As for `evolution`.

        Returns
        -------
        Beating
            ``period``, ``largest``, ``margin``, each of shape (..., n). A real amplitude
            is a_j = 2|B_j|. Infinite where an amplitude grows without bound.

        Raises
        ------
        ExpansionError, MmsgenError
            As for `evolution`.
        """
        return beating(self.linear, self.table, self._with_detunings(values), amplitudes)

    def beating_formulas(self) -> tuple[BeatingFormula, ...]:
        """Period and largest amplitudes as formulas, one for each pair of undamped modes.

        They hold the amplitudes in which these two alone are seen; A_j stands for B_j at t = 0 in
        them. Other amplitudes have none.
        """
        return beating_formulas(self.linear)
