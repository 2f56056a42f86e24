"""From the leading order to its oscillators: what is coupled, which frequencies coincide, names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

import sympy as sp

from .alphabet import fraction
from .errors import ScalingError
from .expressions import FieldSymbols
from .field import Coefficient, sign
from .leading import Entries, LeadingPart, LinearForm, frequency_form, no_inertia
from .modes import Component, Modes, Part
from .parameters import Parameter
from .symbols import coordinate_name, modal_coordinate, mode_frequency, shape

__all__ = ["find_modes"]

Factor = tuple[tuple[sp.Expr, ...], int]
"""Coefficients in ω², lowest power first, and multiplicity."""


@dataclass
class _Names:
    """Frequencies named so far, each with its square."""

    taken: set[str]
    positive: frozenset[str]
    parameters: list[Parameter] = field(default_factory=list)
    squares: list[tuple[sp.Expr, LinearForm]] = field(default_factory=list)

    def known(self, square: sp.Expr) -> LinearForm | None:
        """The form of a frequency that is a rational multiple of one named before."""
        for other, form in self.squares:
            ratio = sp.cancel(square / other)
            root = sp.sqrt(ratio) if ratio.is_Rational and ratio > 0 else None
            if root is not None and root.is_Rational:
                return {name: c * fraction(root) for name, c in form.items()}
        return None

    def fresh(self, candidates: Sequence[str]) -> str:
        """The first name that is not taken."""
        name = next((c for c in candidates if c not in self.taken), None)
        if name is None:
            raise ScalingError(f"the names {', '.join(candidates)} are taken: rename a parameter")
        self.taken.add(name)
        return name

    def frequency(
        self, label: str, meaning: str, square: sp.Expr | None, definition: sp.Expr | None
    ) -> LinearForm:
        """A new frequency symbol."""
        name = self.fresh([f"omega_{label}", f"omega_mode_{label}"])
        form = {name: Fraction(1)}
        self.parameters.append(Parameter(mode_frequency(name), "rad/s", meaning, definition))
        if square is not None:
            self.squares.append((square, form))
        return form


def find_modes(
    coordinates: Sequence[sp.Expr],
    part: LeadingPart,
    symbols: FieldSymbols,
    positive: frozenset[str],
    taken: set[str],
) -> Modes:
    """Split the leading order into oscillators and name what has no name.

    Parameters
    ----------
    coordinates : sequence
        q_j(t).
    part : LeadingPart
    symbols : FieldSymbols
        The coefficient field in the user's symbols.
    positive : frozenset of str
        Generators that are positive.
    taken : set of str
        Names that are in use.

    Raises
    ------
    ScalingError
        If something does not oscillate, or is coupled other than by symmetric M0 and K0 and skew
        G0.
    """
    names = _Names(set(taken), positive)
    components: list[Component] = []
    shapes: dict[int, tuple[Part, ...]] = {}
    forms: dict[int, LinearForm] = {}
    named = [False] * len(coordinates)
    modal = list(coordinates)
    mode_parameters: list[Parameter] = []
    for members in _connected(len(coordinates), part):
        if len(members) == 1:
            (j,) = members
            forms[j], named[j] = _single(coordinates[j], part, j, symbols, names)
            shapes[j] = ((j, None, None),)
            continue
        start = 1 + sum(len(c.members) for c in components)
        component = _component(coordinates, part, members, start, symbols, names)
        components.append(component)
        for index, j in enumerate(members):
            forms[j], named[j] = component.forms[index], True
            number = start + index
            label = names.fresh([f"eta_{number}", f"eta_mode_{number}"])
            modal[j] = modal_coordinate(label, coordinates[j])
        for row, j in enumerate(members):
            shapes[j], fresh = _shape(coordinates, component, modal, row, names)
            mode_parameters += fresh
    order = range(len(coordinates))
    return Modes(
        tuple(modal),
        tuple(forms[j] for j in order),
        tuple(shapes[j] for j in order),
        tuple(components),
        (*names.parameters, *mode_parameters),
        tuple(named),
        part,
    )


def _connected(n: int, part: LeadingPart) -> list[tuple[int, ...]]:
    """Sets of coordinates that are coupled with one another."""
    group = list(range(n))
    for entries in (part.stiffness, part.gyroscopic, part.inertia):
        for i, j in entries:
            old, new = max(group[i], group[j]), min(group[i], group[j])
            group = [new if g == old else g for g in group]
    return [tuple(j for j in range(n) if group[j] == g) for g in sorted(set(group))]


def _single(
    q: sp.Expr, part: LeadingPart, j: int, symbols: FieldSymbols, names: _Names
) -> tuple[LinearForm, bool]:
    """The frequency of an oscillator on its own, and whether it had to be named."""
    mass, stiffness = part.inertia.get((j, j)), part.stiffness.get((j, j))
    form, ratio = frequency_form(q, mass, stiffness, symbols.field)
    square = symbols(ratio)
    if sign(ratio, names.positive) == -1:
        raise ScalingError(
            f"the equation of {q} at leading order does not oscillate: its stiffness over inertia "
            f"is {square} < 0, so the equilibrium is unstable; .equilibria() of the equations of "
            "motion lists others, and .about(...) moves there"
        )
    if form is not None:
        names.squares.append((square, form))
        return form, False
    known = names.known(square)
    if known is not None:
        return known, True
    meaning = f"natural frequency of {coordinate_name(q)}"
    root = sp.sqrt(sp.factor(square))
    return names.frequency(coordinate_name(q), meaning, square, root), True


def _component(
    coordinates: Sequence[sp.Expr],
    part: LeadingPart,
    members: tuple[int, ...],
    start: int,
    symbols: FieldSymbols,
    names: _Names,
) -> Component:
    """Coordinates that are coupled with one another."""
    for j in members:
        if not any(j in place for place in part.inertia):
            raise no_inertia(coordinates[j])
    multipliers = _multipliers(coordinates, part, members, symbols, names.positive)
    matrices = tuple(
        sp.ImmutableDenseMatrix(
            [
                [
                    symbols(multipliers[j] * entries[j, i]) if (j, i) in entries else 0
                    for i in members
                ]
                for j in members
            ]
        )
        for entries in (part.inertia, part.gyroscopic, part.stiffness)
    )
    inertia, gyroscopic, stiffness = matrices
    where = ", ".join(coordinate_name(coordinates[j]) for j in members)
    factors = _factors(inertia, gyroscopic, stiffness, where)
    return Component(
        members,
        (inertia, gyroscopic, stiffness),
        tuple(multipliers[j] for j in members),
        _quadrature(part, members),
        factors,
        _forms(factors, where, start, names),
    )


def _multipliers(
    coordinates: Sequence[sp.Expr],
    part: LeadingPart,
    members: tuple[int, ...],
    symbols: FieldSymbols,
    positive: frozenset[str],
) -> dict[int, Coefficient]:
    """Factors of the equations that make M0 and K0 symmetric and G0 skew.

    Raises
    ------
    ScalingError
        If there are none.
    """
    signed = ((part.stiffness, 1), (part.inertia, 1), (part.gyroscopic, -1))
    result = {members[0]: symbols.field.one}
    pending = [members[0]]
    while pending:
        j = pending.pop()
        for entries, turn in signed:
            for i in members:
                if i in result or (i, j) not in entries or (j, i) not in entries:
                    continue
                ratio = entries[j, i] * entries[i, j].inverse()
                result[i] = (result[j] * ratio).scale(turn)
                pending.append(i)
    _check_multipliers(coordinates, result, signed, members)
    for i, c in result.items():
        if sign(c, positive) == -1:
            raise _energy_error(coordinates, members[0], i)
    return result


def _check_multipliers(
    coordinates: Sequence[sp.Expr],
    found: Mapping[int, Coefficient],
    signed: Sequence[tuple[Entries, int]],
    members: tuple[int, ...],
) -> None:
    """Refuse matrices that are not symmetric or skew once the equations are multiplied."""
    for entries, turn in signed:
        for j in members:
            for i in members:
                left, right = (
                    found[a] * entries[a, b] if a in found and (a, b) in entries else None
                    for a, b in ((j, i), (i, j))
                )
                if left is None and right is None:
                    continue
                if left is None or right is None or left != right.scale(turn):
                    raise _energy_error(coordinates, j, i)


def _energy_error(coordinates: Sequence[sp.Expr], j: int, i: int) -> ScalingError:
    return ScalingError(
        f"{coordinate_name(coordinates[j])} and {coordinate_name(coordinates[i])} are coupled at "
        "leading order by inertia or stiffness that is not symmetric, or by velocities in a part "
        "that is not skew (gyroscopic), even with the equations multiplied by positive constants: "
        "that feeds or takes energy; scale it with an order of 1 or more"
    )


def _quadrature(part: LeadingPart, members: tuple[int, ...]) -> tuple[bool, ...] | None:
    """Which coordinates are in quadrature: G0 only couples these with the others, M0, K0 never."""
    turned = {members[0]: False}
    pending = [members[0]]
    signed = ((part.stiffness, False), (part.inertia, False), (part.gyroscopic, True))
    while pending:
        j = pending.pop()
        for entries, other in signed:
            for i in members:
                if (j, i) not in entries and (i, j) not in entries:
                    continue
                if i not in turned:
                    turned[i] = turned[j] ^ other
                    pending.append(i)
                elif turned[i] != turned[j] ^ other:
                    return None
    return tuple(turned[j] for j in members)


def _factors(
    inertia: sp.Matrix, gyroscopic: sp.Matrix, stiffness: sp.Matrix, where: str
) -> tuple[Factor, ...]:
    """det(K0 + iωG0 − ω²M0) as irreducible factors in λ = ω²."""
    omega, square = sp.Dummy("omega"), sp.Dummy("lambda")
    matrix = stiffness + sp.I * omega * gyroscopic - omega**2 * inertia
    determinant = sp.together(sp.expand(matrix.det(method="berkowitz")))
    polynomial = sp.Poly(sp.expand(sp.fraction(determinant)[0]), omega)
    # real and even: M0, K0 are symmetric and G0 is skew
    even = sum(c * square ** (k // 2) for (k,), c in polynomial.terms())
    _, pairs = sp.factor_list(sp.expand(even), square)
    factors: list[tuple[sp.Rational, str, Factor]] = []
    for factor, multiplicity in pairs:
        poly = sp.Poly(factor, square)
        if poly.degree() == 0:
            continue
        coefficients = tuple(poly.all_coeffs()[::-1])
        if coefficients[0] == 0:
            raise ScalingError(
                f"the leading order of {where} has a rigid-body mode, of frequency zero: it does "
                "not oscillate; remove that motion by a conserved momentum, or give it a stiffness"
            )
        factors.append((_place(poly), str(coefficients), (coefficients, int(multiplicity))))
    return tuple(factor for *_, factor in sorted(factors, key=lambda f: f[:2]))


def _place(poly: sp.Poly) -> sp.Rational:
    """Where a factor stands among the others: by the mean of its roots if all parameters are 1.

    Only names depend on it: modes are then mostly numbered by ascending frequency.
    """
    ones = dict.fromkeys(poly.free_symbols_in_domain, 1)
    highest, next_one = (sp.cancel(c.subs(ones)) for c in poly.all_coeffs()[:2])
    return -next_one / (highest * poly.degree()) if highest else sp.S.Zero


def _forms(
    factors: Sequence[Factor], where: str, start: int, names: _Names
) -> tuple[LinearForm, ...]:
    """A frequency for every mode, the first of which has the number `start`."""
    forms: list[LinearForm] = []
    for coefficients, multiplicity in factors:
        squares = _closed_forms(coefficients)
        for index in range(len(coefficients) - 1):
            square = squares[index] if squares else None
            single = square if len(coefficients) == 2 else None
            form = None if single is None else _exact(single, names)
            if form is None:
                number = str(start + len(forms))
                definition = None if square is None else sp.sqrt(sp.factor(square))
                meaning = f"natural frequency {number}, of {where}"
                form = names.frequency(number, meaning, single, definition)
            forms += [form] * multiplicity
    return tuple(forms)


def _closed_forms(coefficients: Sequence[sp.Expr]) -> list[sp.Expr]:
    """ω² of a factor of degree one or two, ascending; empty for a higher degree."""
    monic = [sp.cancel(c / coefficients[-1]) for c in coefficients[:-1]]
    if len(monic) == 1:
        return [-monic[0]]
    if len(monic) == 2:
        root = sp.sqrt(sp.factor(monic[1] ** 2 - 4 * monic[0]))
        return [(-monic[1] - root) / 2, (-monic[1] + root) / 2]
    return []


def _exact(square: sp.Expr, names: _Names) -> LinearForm | None:
    """A frequency that is a number or a multiple of one that has a name."""
    known = names.known(square)
    if known is not None:
        return known
    if square.is_Rational:
        if square < 0:
            raise ScalingError(f"the leading order does not oscillate: ω² = {square}")
        root = sp.sqrt(square)
        if root.is_Rational:
            form = {"1": fraction(root)}
            names.squares.append((square, form))
            return form
    root = sp.sqrt(sp.factor(square))
    if root.is_Symbol and str(root.name) in names.positive:
        form = {str(root.name): Fraction(1)}
        names.squares.append((square, form))
        return form
    return None


def _shape(
    coordinates: Sequence[sp.Expr],
    component: Component,
    modal: Sequence[sp.Expr],
    row: int,
    names: _Names,
) -> tuple[tuple[Part, ...], list[Parameter]]:
    """The parts of a coordinate in the modes of its component, with their symbols."""
    parts: list[Part] = []
    parameters = []
    name = coordinate_name(coordinates[component.members[row]])
    kinds = (True, True)
    if not component.gyroscopic:
        kinds = (True, False)
    elif component.quadrature is not None:
        kinds = (not component.quadrature[row], component.quadrature[row])
    for j in component.members:
        mode = coordinate_name(modal[j]).removeprefix("eta_")
        pair: list[str | None] = []
        for wanted, head, phase in zip(
            kinds, ("Phi", "Theta"), ("", ", in quadrature"), strict=True
        ):
            if not wanted:
                pair.append(None)
                continue
            label = names.fresh([f"{head}_{name}_{mode}", f"{head}_mode_{name}_{mode}"])
            meaning = f"component {name} of mode {mode}{phase}"
            parameters.append(Parameter(shape(label), "1", meaning))
            pair.append(label)
        parts.append((j, pair[0], pair[1]))
    return tuple(parts), parameters
