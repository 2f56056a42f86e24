"""A coefficient as a sum over its divisors: shorter to read, and better conditioned to evaluate.

Where several divisors are linear in one generator, the coefficient is a polynomial part plus one
residue over each of them. The polynomial part is what remains in exact arithmetic, so that the
terms add up to the coefficient whatever the residues.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from .field import Coefficient, ParameterField

__all__ = ["partial_fractions"]


def partial_fractions(c: Coefficient) -> tuple[Coefficient, ...]:
    """Terms that add up to a coefficient, with fewer monomials in all than it has itself.

    Parameters
    ----------
    c : Coefficient

    Returns
    -------
    tuple of Coefficient
        The coefficient alone where a sum is not shorter.
    """
    best: tuple[Coefficient, ...] = (c,)
    size = _size(c)
    for name in reversed(c.field.names):
        poles = _simple_poles(c, name)
        if len(poles) < 2:
            continue
        terms = _split(c, name, poles)
        length = sum(_size(t) for t in terms)
        if length < size:
            best, size = terms, length
    return best


def _size(c: Coefficient) -> int:
    return sum(len(p) for p in c.num.values())


def _simple_poles(c: Coefficient, name: str) -> dict[int, fmpq_mpoly]:
    """Divisors a·name + b, a rational, of exponent 1: index → −b/a; empty if others contain it."""
    field = c.field
    index = field.names.index(name)
    poles = {}
    for m, e in sorted(c.den.items()):
        divisor = field.divisors[m]
        degree = int(divisor.degrees()[index])
        if not degree:
            continue
        slope = divisor.derivative(index)
        if degree > 1 or e > 1 or not slope.is_constant():
            return {}
        poles[m] = field.gens[name] - divisor / slope
    return poles


def _split(c: Coefficient, name: str, poles: dict[int, fmpq_mpoly]) -> tuple[Coefficient, ...]:
    field = c.field
    terms = []
    for m, root in poles.items():
        rest = Coefficient(field, c.num, {k: e for k, e in c.den.items() if k != m})
        residue = _at(rest, name, root)
        terms.append(residue * field.reciprocal(field.divisors[m]))
    remainder = field.sum((c, *(-t for t in terms)))
    return tuple(t for t in (remainder, *terms) if t)


def _at(c: Coefficient, name: str, value: fmpq_mpoly) -> Coefficient:
    """A coefficient with a polynomial put in for a generator."""
    field = c.field
    num = {k: _compose(field, p, name, value) for k, p in c.num.items()}
    result = Coefficient(field, {k: p for k, p in num.items() if p}, {})
    for m, e in sorted(c.den.items()):
        result = result * field.reciprocal(_compose(field, field.divisors[m], name, value)) ** e
    return result


def _compose(field: ParameterField, p: fmpq_mpoly, name: str, value: fmpq_mpoly) -> fmpq_mpoly:
    images = [value if n == name else g for n, g in field.gens.items()]
    return p.compose(*images, ctx=field.ctx)
