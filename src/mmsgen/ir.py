"""`IR`: a function of real arguments as a list of assignments that any language can print.

From SymPy expressions to ordered arguments, intermediates and outputs: products of square roots
become one root, common subexpressions are named once, integer powers become products.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from hashlib import sha256

import sympy as sp

from .errors import EmissionError

__all__ = ["IR", "compute_ir", "fresh"]

Definitions = dict[sp.Symbol, sp.Expr]


@dataclass(frozen=True)
class IR:
    """A function as assignments.

    Attributes
    ----------
    name : str
    arguments : tuple of sympy.Symbol
        In the order in which the function takes them.
    intermediates : tuple of (symbol, expression)
        In an order in which each needs only what comes before it.
    outputs : tuple of (name, expression)
    source : tuple of (name, expression)
        The outputs as they were before subexpressions were named.
    """

    name: str
    arguments: tuple[sp.Symbol, ...]
    intermediates: tuple[tuple[sp.Symbol, sp.Expr], ...]
    outputs: tuple[tuple[str, sp.Expr], ...]
    source: tuple[tuple[str, sp.Expr], ...]

    def __post_init__(self) -> None:
        known = set(self.arguments)
        for symbol, expression in (*self.intermediates, *self.outputs):
            missing = expression.free_symbols - known
            if missing:
                raise EmissionError(f"{self.name}: {symbol} needs {missing} before they are known")
            if isinstance(symbol, sp.Symbol):
                known.add(symbol)

    @cached_property
    def operations(self) -> int:
        """Additions, multiplications, divisions and roots in one evaluation."""
        assigned = (*self.intermediates, *self.outputs)
        return sum(_operations(expression) for _, expression in assigned)

    @cached_property
    def canonical(self) -> str:
        """Arguments and outputs as text that depends on their mathematics alone."""
        arguments = ", ".join(sp.srepr(s) for s in self.arguments)
        lines = (f"{name} = {_canonical(expression)}" for name, expression in self.source)
        return "\n".join((f"{self.name}({arguments})", *lines))

    @cached_property
    def digest(self) -> str:
        """SHA-256 of `canonical`."""
        return sha256(self.canonical.encode()).hexdigest()


def _canonical(expression: sp.Expr) -> str:
    """An expression as a tree; SymPy keeps the arguments of sums and products sorted."""
    if not expression.args:
        return str(expression)
    return f"{expression.func.__name__}({','.join(map(_canonical, expression.args))})"


def _operations(expression: sp.Expr) -> int:
    inner = sum(_operations(a) for a in expression.args)
    if expression.is_Add or expression.is_Mul:
        free = sum(1 for a in expression.args if a == -1)
        return inner + len(expression.args) - 1 - free
    return inner + (1 if expression.args else 0)


def fresh(name: str, taken: Iterable[str]) -> str:
    """`name`, or the first of name_, name__, … that is not taken."""
    others = set(taken)
    while name in others:
        name += "_"
    return name


def compute_ir(name: str, arguments: Sequence[sp.Symbol], outputs: Mapping[str, sp.Expr]) -> IR:
    """Name common subexpressions and lower powers.

    Parameters
    ----------
    name : str
        What the function is called in error messages and in its digest.
    arguments : sequence of sympy.Symbol
        In the order in which the function takes them.
    outputs : mapping
        Name → expression in the arguments, exact.

    Returns
    -------
    IR

    Raises
    ------
    EmissionError
        If an expression contains a symbol that is not among the arguments, or a float.
    """
    outputs = {key: sp.sympify(e) for key, e in outputs.items()}
    _check(name, arguments, outputs)
    expressions, constants = _named_constants(list(outputs.values()), arguments)
    merged = _Roots((*arguments, *constants))
    expressions = [merged(e) for e in expressions]
    radicands = list(merged.radicands.values())
    taken = {s.name for s in (*arguments, *constants, *merged.radicands)}
    replacements, reduced = sp.cse([*radicands, *expressions], symbols=_numbered("x", taken))
    definitions: Definitions = {**constants, **dict(replacements)}
    for symbol, radicand in zip(merged.radicands, reduced, strict=False):
        definitions[symbol] = sp.sqrt(radicand, evaluate=False)
    results = reduced[len(radicands) :]
    powers = _Powers(taken | {s.name for s in definitions})
    definitions = {s: e if s in constants else powers(e) for s, e in definitions.items()}
    results = [powers(e) for e in results]
    definitions.update(powers.definitions)
    definitions, results = _without_aliases(definitions, results)
    ordered = _renamed(_in_order(definitions, results), results, arguments)
    return IR(
        name,
        tuple(arguments),
        ordered[0],
        tuple(zip(outputs, ordered[1], strict=True)),
        tuple(outputs.items()),
    )


def _named_constants(
    expressions: Sequence[sp.Expr], arguments: Sequence[sp.Symbol]
) -> tuple[list[sp.Expr], Definitions]:
    """A name for every sine and cosine of a number, so that none is taken apart.

    Roots of unity are written with them first.
    """
    turned = [
        e.replace(lambda f: isinstance(f, sp.exp) and f.is_number, lambda f: f.rewrite(sp.cos))
        for e in expressions
    ]
    found = {f for e in turned for f in e.atoms(sp.cos, sp.sin) if f.is_number}
    names = _numbered("constant", (s.name for s in arguments))
    constants = dict(zip(names, sorted(found, key=sp.default_sort_key), strict=False))
    back = {f: s for s, f in constants.items()}
    return [e.xreplace(back) for e in turned], constants


def _check(name: str, arguments: Sequence[sp.Symbol], outputs: Mapping[str, sp.Expr]) -> None:
    inputs = ", ".join(s.name for s in arguments) or "none"
    for key, expression in outputs.items():
        missing = sorted(s.name for s in expression.free_symbols - set(arguments))
        if missing:
            raise EmissionError(
                f"{name}: the output {key} contains {', '.join(missing)}, which is not among the "
                f"inputs {inputs}: declare it as a parameter of the model, with a domain and a unit"
            )
        floats = expression.atoms(sp.Float)
        if floats:
            raise EmissionError(
                f"{name}: the output {key} contains the float {min(map(str, floats))}: pass exact "
                "numbers, such as sympy.Rational"
            )


def _numbered(stem: str, taken: Iterable[str]) -> Iterator[sp.Symbol]:
    others, k = set(taken), 0
    while True:
        if f"{stem}{k}" not in others:
            yield sp.Symbol(f"{stem}{k}")
        k += 1


class _Roots:
    """Writes √a·√b/√c as one root of ab/c, for factors that are known not to be negative."""

    def __init__(self, arguments: Sequence[sp.Symbol]) -> None:
        self._names = _numbered("root", (s.name for s in arguments))
        self._known: dict[sp.Expr, sp.Symbol] = {}
        self._seen: dict[sp.Expr, sp.Expr] = {}
        self.radicands: dict[sp.Symbol, sp.Expr] = {}

    def __call__(self, expression: sp.Expr) -> sp.Expr:
        """The expression with a symbol for each merged root."""
        if not expression.args:
            return expression
        if expression not in self._seen:
            self._seen[expression] = self._rewrite(expression)
        return self._seen[expression]

    def _rewrite(self, expression: sp.Expr) -> sp.Expr:
        inside, outside = [], []
        for factor in sp.Mul.make_args(expression):
            base, exponent = factor.as_base_exp()
            half = exponent.is_Rational and exponent.q == 2
            if not half:
                outside.append(factor.func(*map(self, factor.args)) if factor.args else factor)
            elif base.is_nonnegative or expression is factor:
                inside.append(self(base) ** (2 * exponent))
            else:
                outside.append(self(factor))
        if not inside:
            return sp.Mul(*outside)
        return sp.Mul(*outside, self._root(sp.Mul(*inside)))

    def _root(self, radicand: sp.Expr) -> sp.Expr:
        number, rest = radicand.as_coeff_Mul()
        if number.is_positive and sp.sqrt(number).is_Rational and number != 1:
            return sp.sqrt(number) * self._root(rest)
        if radicand not in self._known:
            self._known[radicand] = next(self._names)
            self.radicands[self._known[radicand]] = radicand
        return self._known[radicand]


class _Powers:
    """Writes x^n, n whole, as products of squares that are shared by all."""

    def __init__(self, taken: Iterable[str]) -> None:
        self._names = _numbered("power", taken)
        self._known: dict[tuple[sp.Expr, int], sp.Symbol] = {}
        self.definitions: Definitions = {}

    def __call__(self, expression: sp.Expr) -> sp.Expr:
        """The expression without powers beyond ±1 and 1/2."""
        if not expression.args:
            return expression
        arguments = [self(a) for a in expression.args]
        if not expression.is_Pow:
            return expression.func(*arguments)
        base, exponent = arguments
        if exponent.is_Integer and abs(exponent) > 1 and not base.is_number:
            return self._power(base, abs(int(exponent))) ** sp.sign(exponent)
        return sp.Pow(base, exponent, evaluate=False)

    def _power(self, base: sp.Expr, n: int) -> sp.Symbol:
        if n == 1:
            return base if base.is_Symbol else self._name(base, 1, base)
        if (base, n) in self._known:
            return self._known[base, n]
        x = self._power(base, 1)
        if n == 2:
            return self._name(base, n, sp.Pow(x, 2))
        high = 1 << ((n - 1).bit_length() - 1)  # the highest power of two below n
        left, right = self._power(base, high), self._power(base, n - high)
        product = sp.Pow(left, 2) if left == right else left * right
        return self._name(base, n, product)

    def _name(self, base: sp.Expr, n: int, value: sp.Expr) -> sp.Symbol:
        if (base, n) not in self._known:
            symbol = self._known[base, n] = next(self._names)
            self.definitions[symbol] = value
        return self._known[base, n]


def _without_aliases(
    definitions: Definitions, results: Sequence[sp.Expr]
) -> tuple[Definitions, list[sp.Expr]]:
    """No second name for what has one."""
    aliases = {s: e for s, e in definitions.items() if e.is_Symbol}

    def original(expression: sp.Expr) -> sp.Expr:
        while expression in aliases:
            expression = aliases[expression]
        return _rebuilt(expression, original)

    kept = {s: original(e) for s, e in definitions.items() if s not in aliases}
    return kept, [original(e) for e in results]


def _rebuilt(expression: sp.Expr, change: Callable[[sp.Expr], sp.Expr]) -> sp.Expr:
    """The expression with changed arguments, its powers left as they are written."""
    if not expression.args:
        return expression
    inner = [change(a) for a in expression.args]
    return sp.Pow(*inner, evaluate=False) if expression.is_Pow else expression.func(*inner)


def _in_order(definitions: Definitions, results: Sequence[sp.Expr]) -> Definitions:
    """Definitions that the results need, each after what it needs and close to its first use."""
    rank = {s: k for k, s in enumerate(definitions)}
    ordered: Definitions = {}

    def visit(expression: sp.Expr) -> None:
        needed = (s for s in expression.free_symbols if s in rank and s not in ordered)
        for symbol in sorted(needed, key=rank.__getitem__):
            if symbol not in ordered:
                visit(definitions[symbol])
                ordered[symbol] = definitions[symbol]

    for result in results:
        visit(result)
    return ordered


def _renamed(
    definitions: Definitions, results: Sequence[sp.Expr], arguments: Sequence[sp.Symbol]
) -> tuple[tuple[tuple[sp.Symbol, sp.Expr], ...], list[sp.Expr]]:
    """The intermediates numbered x0, x1, … in their order."""
    numbers = _numbered("x", (s.name for s in arguments))
    names: dict[sp.Symbol, sp.Symbol] = {old: next(numbers) for old in definitions}

    def replaced(expression: sp.Expr) -> sp.Expr:
        return names[expression] if expression in names else _rebuilt(expression, replaced)

    intermediates = tuple((names[s], replaced(e)) for s, e in definitions.items())
    return intermediates, [replaced(e) for e in results]
