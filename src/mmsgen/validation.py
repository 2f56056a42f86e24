"""What a model and its equations of motion must satisfy, checked when they are built.

Every check names the offender and the remedy, and raises `ModelError`.
"""

from __future__ import annotations

import keyword
import unicodedata
from collections.abc import Iterable, Sequence

import sympy as sp
from sympy.core.function import AppliedUndef

from .errors import ModelError
from .parameters import Parameter, by_name
from .terms import motion

__all__ = [
    "TIME",
    "as_expression",
    "as_parameters",
    "check_accelerations",
    "check_content",
    "check_coordinates",
    "check_definitions",
    "names",
]

#: the time of SymPy's mechanics, `dynamicsymbols._t`, without loading it
TIME = sp.Symbol("t")


def names(items: Iterable[sp.Basic]) -> str:
    """List symbols readably, in alphabetical order."""
    return ", ".join(sorted(str(item) for item in items))


def as_expression(value: object, where: str) -> sp.Expr:
    """Check that a value is a SymPy expression without floating-point numbers.

    Raises
    ------
    ModelError
        If `value` is text (which is never evaluated), no scalar expression, contains a float
        or an imaginary unit, or is not finite.
    """
    if isinstance(value, str):
        raise ModelError(
            f"{where} is the text {value!r}: pass a SymPy expression, text is not evaluated"
        )
    try:
        expr = sp.sympify(value, strict=True)
    except sp.SympifyError:
        expr = None
    if not isinstance(expr, sp.Expr) or getattr(expr, "is_Matrix", False):
        raise ModelError(f"{where} must be a scalar SymPy expression, got {value!r}")
    floats = expr.atoms(sp.Float)
    if floats:
        raise ModelError(
            f"{where} contains the floating-point number {names(floats)}: derivations are exact, "
            "use sympy.Rational, or a parameter whose number is given later"
        )
    if expr.has(sp.I):
        raise ModelError(f"{where} contains the imaginary unit: models are real")
    if expr.has(sp.nan, sp.zoo, sp.oo, -sp.oo):
        raise ModelError(f"{where} is not finite: {expr}")
    return expr


def as_parameters(parameters: Iterable[Parameter | sp.Symbol]) -> tuple[Parameter, ...]:
    """Check names and domains; bare symbols become parameters without unit and meaning.

    Raises
    ------
    ModelError
        If an entry is neither, is not real, has a name that cannot be a keyword argument, is
        called like time, or if two share a name.
    """
    if isinstance(parameters, str | sp.Basic) or not isinstance(parameters, Iterable):
        raise ModelError(f"parameters must be a list of Parameter, got {parameters!r}")
    result = tuple(p if isinstance(p, Parameter) else Parameter(p) for p in parameters)
    for parameter in result:
        _check_name("parameter", parameter.name)
        _check_real(parameter)
    by_name(result)
    return result


def _check_name(kind: str, name: str) -> None:
    """Names become keyword arguments of emitted functions."""
    if name == TIME.name:
        raise ModelError(
            f"the {kind} {name!r} is called like time: rename it, for time use "
            "sympy.physics.mechanics.dynamicsymbols._t"
        )
    if keyword.iskeyword(name):
        raise ModelError(
            f"the {kind} {name!r} is a Python keyword, and emitted functions take it as a "
            f"keyword argument: rename the symbol, for example to {name + '_0'!r}"
        )
    # Python reads identifiers in their NFKC form: a name that changes would not be found again
    if not name.isidentifier() or name != unicodedata.normalize("NFKC", name):
        raise ModelError(
            f"the {kind} {name!r} is not a Python identifier, and emitted functions take it "
            "as a keyword argument: rename the symbol with letters, digits and underscores"
        )


def _check_real(parameter: Parameter) -> None:
    symbol = parameter.symbol
    if not symbol.is_commutative:
        raise ModelError(f"the parameter {symbol} does not commute: declare it real")
    if symbol.is_extended_real is False or (symbol.is_complex and symbol.is_extended_real is None):
        raise ModelError(
            f"the parameter {symbol} is declared complex: declare it with real=True, or give its "
            "real and imaginary parts as two parameters"
        )


def check_coordinates(coordinates: Sequence[sp.Expr], parameters: Sequence[Parameter]) -> None:
    """Check that coordinates are distinct functions of time whose names no parameter has.

    Raises
    ------
    ModelError
        Naming the coordinate that is not.
    """
    if not coordinates:
        raise ModelError("a model needs at least one coordinate: dynamicsymbols('q')")
    seen: dict[str, sp.Expr] = {}
    taken = by_name(parameters)
    for q in coordinates:
        if not isinstance(q, AppliedUndef) or q.args != (TIME,):
            raise ModelError(
                f"the coordinate {q} is not a function of time: make it with "
                "sympy.physics.mechanics.dynamicsymbols"
            )
        name = str(q.func)
        _check_name("coordinate", name)
        if name in seen:
            raise ModelError(f"the coordinate {q} is given twice: every coordinate once")
        if name in taken:
            raise ModelError(f"{name!r} is both a coordinate and a parameter: rename one of them")
        seen[name] = q


def check_content(
    expr: sp.Expr,
    where: str,
    coordinates: Sequence[sp.Expr],
    parameters: Sequence[Parameter],
    highest: int,
) -> None:
    """Check that an expression holds only what is declared, and no higher derivatives.

    Parameters
    ----------
    expr : sympy.Expr
        What is checked.
    where : str
        What to call it in the message, such as ``"the Lagrangian"``.
    coordinates, parameters
        What is declared.
    highest : int
        The highest order of a time derivative allowed.

    Raises
    ------
    ModelError
        Naming what does not belong.
    """
    for derivative in sorted(expr.atoms(sp.Derivative), key=sp.default_sort_key):
        if derivative.expr not in coordinates or set(derivative.variables) != {TIME}:
            raise ModelError(
                f"{where} contains {derivative}, which is not a time derivative of a "
                "coordinate: add the function to the coordinates, or write it out"
            )
        if derivative.derivative_count > highest:
            order = "second" if derivative.derivative_count == 2 else "higher"
            raise ModelError(
                f"{where} contains the {order} derivative {derivative}: "
                + ("only velocities are allowed" if highest == 1 else "second order at most")
            )
    strangers = sorted(expr.atoms(AppliedUndef) - set(coordinates), key=sp.default_sort_key)
    if strangers:
        raise ModelError(
            f"{where} contains the undeclared function {names(strangers)}: add it to the "
            "coordinates, or replace it by an expression in time and parameters"
        )
    declared = {p.symbol for p in parameters}
    _check_declared(expr.free_symbols - declared - {TIME}, where, parameters)


def _check_declared(unknown: set[sp.Symbol], where: str, parameters: Sequence[Parameter]) -> None:
    if not unknown:
        return
    known = by_name(parameters)
    for symbol in sorted(unknown, key=sp.default_sort_key):
        if symbol.name in known or symbol.name == TIME.name:
            raise ModelError(
                f"{where} contains a symbol called {symbol.name!r} that is not the declared one: "
                "their assumptions differ, use one and the same symbol object"
            )
    remedy = ", ".join(f"Parameter({name}, unit, meaning)" for name in names(unknown).split(", "))
    plural = "s" if len(unknown) > 1 else ""
    raise ModelError(
        f"{where} contains the undeclared symbol{plural} {names(unknown)}: add {remedy} "
        f"to the parameters (declared are {names(p.symbol for p in parameters) or 'none'})"
    )


def check_definitions(parameters: Sequence[Parameter]) -> None:
    """Check that definitions contain declared parameters only, and do not go round in a circle.

    Raises
    ------
    ModelError
        Naming the parameter whose definition is unusable.
    """
    defined = {p.symbol: p.definition for p in parameters if p.definition is not None}
    for symbol, definition in defined.items():
        where = f"the definition of {symbol}"
        as_expression(definition, where)
        check_content(definition, where, (), parameters, highest=0)
        if TIME in definition.free_symbols:
            raise ModelError(f"{where} depends on time: a parameter is constant")
        reached, new = set(), {symbol}
        while new:
            reached |= new
            new = {s for d in new if d in defined for s in defined[d].free_symbols}
            if symbol in new:
                raise ModelError(f"{where} leads back to {symbol} through other definitions")
            new -= reached


def check_accelerations(equations: Sequence[sp.Expr], coordinates: Sequence[sp.Expr]) -> None:
    """Check that every coordinate has an acceleration, and every equation is of second order.

    Raises
    ------
    ModelError
        Naming the coordinate or the equation without.
    """
    accelerations = {q: motion(q, TIME)[2] for q in coordinates}
    present = [equation.atoms(sp.Derivative) for equation in equations]
    for q, acceleration in accelerations.items():
        if not any(acceleration in atoms for atoms in present):
            raise ModelError(
                f"the coordinate {q} has no kinetic energy: no equation is of second order in "
                "it. Give it inertia, or eliminate it"
            )
    for number, atoms in enumerate(present, start=1):
        if not any(acceleration in atoms for acceleration in accelerations.values()):
            raise ModelError(
                f"equation {number} contains no second derivative of a coordinate: eliminate it, "
                "every equation must be of second order"
            )
