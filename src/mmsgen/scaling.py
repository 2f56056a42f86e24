"""`ScaledSystem`: which parameter and which amplitude is of which order in ε.

The scaled equations are held as truncated polynomials with exact coefficients. Parameters keep
their symbols: a parameter p of order k stands for ε^k p, and results are written at ε = 1.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

import sympy as sp

from .alphabet import Alphabet, survey
from .errors import ResonanceError, ScalingError
from .expansion import Expansion, expand
from .expressions import FieldSymbols
from .field import Coefficient
from .grading import Grading
from .leading import GradedTerm, LinearForm, at_leading_order, graded_terms, leading_part
from .modes import Modes
from .numeric import named_values
from .orders import amplitude_orders, check_names, is_coordinate, whole
from .oscillators import find_modes
from .parameters import Parameter
from .relations import solve_relations
from .resonance import enumerate_resonances
from .symbols import coordinate_name
from .tables import ResonanceTable
from .taylor import Polynomial, Taylor
from .truncation import weight_limit
from .weak import WeakSystem, weak_system

if TYPE_CHECKING:
    from .equations import EquationsOfMotion

__all__ = ["ScaledSystem", "scale"]


def scale(
    eom: EquationsOfMotion,
    orders: Mapping[sp.Symbol | str, int],
    amplitude: int | sp.Rational | Mapping[sp.Expr, int | sp.Rational] = 0,
) -> ScaledSystem:
    """Say which parameter and which amplitude is small.

    Parameters
    ----------
    eom : EquationsOfMotion
    orders : mapping
        Parameter → its order in ε, a whole number; parameters not named are of order 0.
    amplitude : int, Rational or mapping
        Order in ε of the coordinates' amplitudes, one for all or one per coordinate. With 0
        nothing is truncated, and every nonlinear term needs a small parameter.

    Returns
    -------
    ScaledSystem

    Raises
    ------
    ScalingError
        If a parameter is unknown or scaled twice, an order is not a whole number ≥ 0, or the
        leading-order part is not a set of uncoupled oscillators.
    """
    if not isinstance(orders, Mapping):
        raise ScalingError(
            "orders are written as a mapping parameter -> order like {epsilon: 1}, "
            f"got {orders!r}"
        )
    known = {p.name: p.symbol for p in eom.parameters}
    check_names(eom, known)
    resolved: dict[str, int] = {}
    for key, order in orders.items():
        name = key if isinstance(key, str) else str(getattr(key, "name", key))
        if name not in known:
            hint = "; amplitudes are scaled by amplitude={...}" if is_coordinate(eom, key) else ""
            raise ScalingError(
                f"{key} is not a parameter of these equations, so it cannot be scaled; they have "
                f"{', '.join(known)}{hint}"
            )
        if name in resolved:
            raise ScalingError(f"the parameter {name} is scaled twice: give it one order")
        resolved[name] = whole(order, f"the order of {name}", 0)
    return ScaledSystem(
        eom,
        tuple((known[name], order) for name, order in resolved.items()),
        amplitude_orders(eom, amplitude),
    )


@dataclass(frozen=True)
class ScaledSystem:
    """Equations of motion with an order in ε for every parameter and amplitude.

    Attributes
    ----------
    eom : EquationsOfMotion
        The exact equations.
    orders : tuple of (symbol, int)
        The small parameters.
    amplitude : tuple of Fraction
        Order of each coordinate's amplitude.

    Raises
    ------
    ScalingError
        When built, if the leading order is not a set of uncoupled oscillators.
    """

    eom: EquationsOfMotion
    orders: tuple[tuple[sp.Symbol, int], ...]
    amplitude: tuple[Fraction, ...]
    _cache: dict[Any, Any] = field(default_factory=dict, init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        self._check_frequencies_are_not_small()

    # -- the polynomial form -------------------------------------------------------------

    def _alphabet(self, named: tuple[Parameter, ...]) -> Alphabet:
        time = self.eom.time
        moving = [q.diff(time, k) if k else q for k in range(3) for q in self.eom.coordinates]
        symbols = [p.symbol for p in (*self.eom.parameters, *named)]
        return survey(self.eom.equations, time, symbols, frozenset(moving))

    @cached_property
    def _own_alphabet(self) -> Alphabet:
        return self._alphabet(())

    @cached_property
    def alphabet(self) -> Alphabet:
        """Generators, phasors and roots of unity of the equations, and what their modes name."""
        named = self.modes.parameters
        return self._alphabet(named) if named else self._own_alphabet

    @cached_property
    def modes(self) -> Modes:
        """The oscillators of the leading order, in modal coordinates where they are coupled."""
        grading = Grading(self._own_alphabet.field, self.generator_orders)
        taylor, polynomials = self._polynomials(self._own_alphabet, 0)
        terms = [graded_terms(taylor, p, grading, j) for j, p in enumerate(polynomials)]
        symbols = FieldSymbols(grading.field, self._table(self._own_alphabet, self.eom.parameters))
        names = {p.name for p in self.eom.parameters}
        names |= {coordinate_name(q) for q in self.eom.coordinates}
        part = leading_part(taylor, terms)
        modes = find_modes(self.eom.coordinates, part, symbols, self._own_alphabet.positive, names)
        for component in modes.components:
            if len({self.amplitude[j] for j in component.members}) > 1:
                shown = ", ".join(
                    coordinate_name(self.eom.coordinates[j]) for j in component.members
                )
                raise ScalingError(
                    f"{shown} are coupled at leading order: their amplitudes need the same order"
                )
        return modes

    def _table(self, alphabet: Alphabet, parameters: tuple[Parameter, ...]) -> dict[str, sp.Expr]:
        """Generator name → what it stands for."""
        return {
            p.name: p.symbol ** sp.Rational(1, alphabet.roots.get(p.name, 1)) for p in parameters
        }

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters of the equations, then the named quantities of the modes."""
        return (*self.eom.parameters, *self.modes.parameters)

    def numbers(
        self, values: Mapping[Any, Any], detunings: tuple[Parameter, ...] = ()
    ) -> dict[str, Any]:
        """Values by name, with those that follow from definitions and those of the modes.

        Parameters
        ----------
        values : mapping
            Symbol or name → number or array.
        detunings : tuple of Parameter
            Further parameters that may be given.

        Raises
        ------
        MmsgenError
            If a value is unknown or unusable, or the leading order does not oscillate there.
        """
        parameters = (*self.parameters, *detunings)
        table = named_values(parameters, values)
        if not self.modes.components:
            return table
        missing = self.modes.numbers(table, self.eom.parameters)
        return named_values(parameters, {**missing, **table})

    @property
    def coordinates(self) -> tuple[sp.Expr, ...]:
        """Modal coordinates; one that is coupled to no other at leading order is its own."""
        return self.modes.coordinates

    def polynomials(self, order: int) -> tuple[Taylor, tuple[Polynomial, ...]]:
        """The equations as polynomials in q, q', q'' and phasors, exact through ε^order."""
        return self._polynomials(self.alphabet, order)

    def _polynomials(self, alphabet: Alphabet, order: int) -> tuple[Taylor, tuple[Polynomial, ...]]:
        limit = max(self.amplitude) + (order if any(self.amplitude) else 0)
        if any(self.amplitude):
            taylor = Taylor(alphabet, self.eom.coordinates, self.amplitude, limit)
            limit = weight_limit(taylor, self.eom.equations, self.generator_orders, limit)
        key = id(alphabet), limit
        if key not in self._cache:
            taylor = Taylor(alphabet, self.eom.coordinates, self.amplitude, limit)
            self._cache[key] = taylor, tuple(taylor(e) for e in self.eom.equations)
        result: tuple[Taylor, tuple[Polynomial, ...]] = self._cache[key]
        return result

    def graded(self, grading: Grading) -> tuple[Taylor, list[list[GradedTerm]]]:
        """The terms of every equation by their order in ε, without what the modes account for."""
        taylor, polynomials = self.polynomials(grading.order)
        taken = self._taken(taylor, polynomials)
        terms = []
        for j, polynomial in enumerate(polynomials):
            rest = {
                key: c - taken[j, key] if (j, key) in taken else c for key, c in polynomial.items()
            }
            rest = {key: c for key, c in rest.items() if c}
            terms.append(graded_terms(taylor, rest, grading, j))
        return taylor, terms

    def _taken(
        self, taylor: Taylor, polynomials: tuple[Polynomial, ...]
    ) -> dict[tuple[int, int], Coefficient]:
        """(equation, monomial) → what the named modes hold of it."""
        small = {name for name, order in self.generator_orders.items() if order}
        units = frozenset(taylor.packing.unit[: 3 * len(taylor.coordinates)])
        return {
            (j, key): at_leading_order(c, small)
            for j, polynomial in enumerate(polynomials)
            if self.modes.named[j]
            for key, c in polynomial.items()
            if key in units and taylor.weight(key) == taylor.weights[j]
        }

    @cached_property
    def generator_orders(self) -> dict[str, int]:
        """Order of every generator of the field; a root of a parameter takes its share."""
        result = {}
        for symbol, order in self.orders:
            q = self._own_alphabet.roots.get(str(symbol.name), 1)
            if order % q:
                raise ScalingError(
                    f"{symbol}**(1/{q}) occurs, so the order of {symbol} must be a multiple of {q}"
                )
            result[str(symbol.name)] = order // q
        return result

    @property
    def natural_frequencies(self) -> tuple[LinearForm, ...]:
        """ω_j of each mode as a linear form in frequency symbols."""
        return self.modes.frequencies

    @cached_property
    def frequencies(self) -> tuple[sp.Symbol, ...]:
        """The frequency symbols: natural ones in coordinate order, then those of excitations."""
        names = [n for form in self.natural_frequencies for n in form if n != "1"]
        names += [str(p.base.name) for p in self.alphabet.phasors if p.moving and p.base.is_Symbol]
        symbols = {p.name: p.symbol for p in self.parameters}
        return tuple(symbols[name] for name in dict.fromkeys(names))

    def _check_frequencies_are_not_small(self) -> None:
        small = {str(s.name) for s, order in self.orders if order}
        for symbol in self.frequencies:
            if symbol.name in small:
                raise ScalingError(
                    f"the frequency {symbol} has an order in ε: a slow excitation or a vanishing "
                    "natural frequency has no expansion of this kind; leave it at order 0"
                )
            if self.alphabet.roots.get(str(symbol.name), 1) != 1:
                raise ScalingError(
                    f"a fractional power of the frequency {symbol} occurs: name that power as a "
                    "parameter of its own"
                )
            if not symbol.is_positive:
                raise ScalingError(
                    f"the frequency {symbol} must be declared positive: Symbol('{symbol}', "
                    "positive=True)"
                )
        for phasor in self.alphabet.phasors:
            if not phasor.moving and phasor.base.free_symbols & set(self.frequencies):
                raise ScalingError(
                    f"the constant phase {phasor.angle} contains a frequency: name it as a "
                    "parameter of its own"
                )
            if not phasor.moving and {str(s.name) for s in phasor.base.free_symbols} & small:
                raise ScalingError(
                    f"the constant phase {phasor.angle} contains a small parameter: expand it first"
                )

    # -- the next stages -----------------------------------------------------------------

    def weak(self, order: int, resonance: Mapping[sp.Expr, sp.Expr] | None = None) -> WeakSystem:
        """The equations through ε^order with the resonance relations imposed."""
        order = whole(order, "the order of an expansion", 1)
        taken = frozenset(p.name for p in self.parameters)
        relations, detuned = solve_relations(resonance, self.frequencies, taken)
        sigmas = [str(r.detuning.name) for r in relations]
        grading = Grading(self.alphabet.field, self.generator_orders, detuned, sigmas, order)
        taylor, terms = self.graded(grading)
        return weak_system(self, taylor, terms, grading, relations, detuned)

    def expand(
        self,
        order: int,
        resonance: Mapping[sp.Expr, sp.Expr] | str | None = None,
        *,
        values: Mapping[Any, Any] | None = None,
    ) -> Expansion:
        """Expand by the method of multiple scales.

        Parameters
        ----------
        order : int
            Highest power of ε in the solvability conditions, at least 1.
        resonance : mapping or "nearest", optional
            Relations {kΩ: linear form in the other frequencies} that hold up to a detuning of
            order ε; ``"nearest"`` for the coupled resonance nearest to `values`; None for the case
            without resonance.
        values : mapping, optional
            Symbol or name → number, for every frequency; with ``"nearest"`` only.

        Raises
        ------
        ScalingError, ResonanceError, ExpansionError
        """
        if isinstance(resonance, str):
            resonance = self._nearest(order, resonance, values)
        elif values is not None:
            raise ResonanceError('values choose a resonance only with resonance="nearest"')
        return expand(self.weak(order, resonance))

    def _nearest(
        self, order: int, word: str, values: Mapping[Any, Any] | None
    ) -> dict[sp.Expr, sp.Expr]:
        """The relation of the coupled resonance nearest to numbers."""
        if word != "nearest" or values is None:
            raise ResonanceError(
                f'resonance={word!r} is not known: give relations, or "nearest" together with '
                "values={frequency: number, ...}"
            )
        table = self.resonances(order).coupled
        if not table:
            raise ResonanceError(f"the system has no resonance up to order {order}")
        return table.rank(values)[0].mapping

    def resonances(self, order: int) -> ResonanceTable:
        """Every resonance that appears up to ε^order, found from the divisors.

        Parameters
        ----------
        order : int
            At least 1.
        """
        return enumerate_resonances(self.weak(order))
