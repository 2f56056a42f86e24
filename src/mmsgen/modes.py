"""`Modes`: the leading order in modal coordinates, where it is coupled or a frequency has no name.

Where M0, G0 and K0 couple coordinates, the modes are named quantities: a symbol for each natural
frequency and for each component of a mode shape, which numbers are computed for when they are
needed. With a mode φ = Φ + iΘ of (K0 + iωG0 − ω²M0)φ = 0 that is scaled by
φᴴ(2ωM0 − iG0)φ = 2ω, the modal coordinate η and its companion s obey

    η'' + ω²η + Φᵀ F − (Θᵀ F)'/ω = 0,    s = (η' − Θᵀ F/ω)/ω,

exactly, F being all that is not of leading order, and the coordinates are

    q = Σ (Φ η + Θ s),    q' = Σ ω(Φ s − Θ η).

A mode that is real (Θ = 0) is that of a system without gyroscopic coupling: q = Σ Φ η, and
Φᵀ M0 Φ = 1. An oscillator on its own is its own mode; its frequency is named if it is no linear
form in the user's symbols.

Reference: L. Meirovitch, "A new method of solution of the eigenvalue problem for gyroscopic
systems", AIAA Journal 12 (1974).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp

from .errors import ScalingError
from .field import Coefficient
from .leading import LeadingPart, LinearForm
from .numeric import compiled
from .parameters import Parameter
from .runtime._eigenmodes import Layout, modal_values

__all__ = ["Component", "Modes", "Part"]

Part = tuple[int, str | None, str | None]
"""Mode, name of Φ, name of Θ: one term of a coordinate. Φ is 1 where both names are None."""


@dataclass(frozen=True)
class Component:
    """Coordinates that are coupled with one another, and with no others.

    Attributes
    ----------
    members : tuple of int
        Coordinates, and modes of the same numbers.
    matrices : tuple of sympy.Matrix
        M0, G0 and K0, made symmetric and skew by `multipliers`.
    multipliers : tuple of Coefficient
        The factor of each equation that does it.
    quadrature : tuple of bool or None
        Coordinates that move in quadrature with the others in every mode; None where the modes
        have no such form.
    factors : tuple of (coefficients, multiplicity)
        Of the characteristic polynomial in ω², lowest power first, irreducible.
    forms : tuple of LinearForm
        The frequencies: of the first factor in ascending order, then of the second, …, each once
        for every mode that it has.
    """

    members: tuple[int, ...]
    matrices: tuple[sp.Matrix, sp.Matrix, sp.Matrix]
    multipliers: tuple[Coefficient, ...]
    quadrature: tuple[bool, ...] | None
    factors: tuple[tuple[tuple[sp.Expr, ...], int], ...]
    forms: tuple[LinearForm, ...]

    @property
    def gyroscopic(self) -> bool:
        """Whether G0 is not zero."""
        return not self.matrices[1].is_zero_matrix

    @property
    def entries(self) -> tuple[sp.Expr, ...]:
        """What its numbers are computed from; see `runtime._eigenmodes.modal_values`."""
        flat = [entry for matrix in self.matrices for entry in matrix]
        return (*flat, *(c for coefficients, _ in self.factors for c in coefficients))


@dataclass(frozen=True)
class Modes:
    """The leading order in modal coordinates.

    Attributes
    ----------
    coordinates : tuple
        Modal coordinates; a coordinate that is coupled to no other is its own.
    frequencies : tuple of LinearForm
    shapes : tuple of tuple of Part
        For each coordinate the modes that it takes part in.
    components : tuple of Component
        Those with more than one coordinate.
    parameters : tuple of Parameter
        The named quantities; frequencies first.
    named : tuple of bool
        Which equations have named quantities at leading order.
    part : LeadingPart
        M0, G0 and K0.
    """

    coordinates: tuple[sp.Expr, ...]
    frequencies: tuple[LinearForm, ...]
    shapes: tuple[tuple[Part, ...], ...]
    components: tuple[Component, ...]
    parameters: tuple[Parameter, ...]
    named: tuple[bool, ...]
    part: LeadingPart

    def numbers(self, table: Mapping[str, Any], known: Sequence[Parameter]) -> dict[str, Any]:
        """The named quantities of coupled coordinates at numbers.

        Parameters
        ----------
        table : mapping
            Name → number or array.
        known : sequence of Parameter
            The parameters of the equations.

        Returns
        -------
        dict
            Name → array; empty where a value is missing.

        Raises
        ------
        ScalingError
            If M0 or K0 is not positive definite there.
        """
        symbols = tuple(p.symbol for p in known if p.symbol in self._needed)
        if not all(str(s.name) in table for s in symbols):
            return {}
        numbers = compiled(symbols, self.entries)(*(table[str(s.name)] for s in symbols))
        entries = np.stack(np.broadcast_arrays(*numbers), axis=-1)
        result = modal_values(entries, self.layouts)
        for name, value in result.items():
            if not np.all(np.isfinite(value)):
                raise ScalingError(
                    "at these values the leading order does not oscillate: its M0 or K0 is not "
                    f"positive definite, and {name} has no value"
                )
        return result

    @property
    def entries(self) -> tuple[sp.Expr, ...]:
        """What the numbers of all components are computed from."""
        return tuple(e for component in self.components for e in component.entries)

    @cached_property
    def _needed(self) -> frozenset[sp.Symbol]:
        return frozenset().union(*(e.free_symbols for e in self.entries))

    @cached_property
    def layouts(self) -> tuple[Layout, ...]:
        """How the numbers of each component are arranged."""
        own = {p.name for p in self.parameters}
        layouts: list[Layout] = []
        for component in self.components:
            frequencies = []
            for form in component.forms:
                name, multiple = next(iter(form.items()))
                frequencies.append((name, float(multiple)) if name in own else ("", 1.0))
            shapes = [
                (name, row, mode, imaginary)
                for row, j in enumerate(component.members)
                for mode, (_, *names) in enumerate(self.shapes[j])
                for name, imaginary in zip(names, (False, True), strict=True)
                if name is not None
            ]
            degrees = tuple((len(c) - 1, multiplicity) for c, multiplicity in component.factors)
            layouts.append(
                (
                    len(component.members),
                    component.quadrature if component.gyroscopic else None,
                    degrees,
                    tuple(frequencies),
                    tuple(shapes),
                )
            )
        return tuple(layouts)
