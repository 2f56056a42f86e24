"""The hierarchy of order-ε^p equations, in the operator form in which papers print it.

With d/dt = D_0 + εD_1 + … and q_j = q_{j,0} + εq_{j,1} + …, equation j at order p reads
D_0² q_{j,p} + ω_j² q_{j,p} = −2D_0D_p q_{j,0} − …, with every coefficient written in real form.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import sympy as sp

from .alphabet import CONSTANTS
from .expressions import FieldSymbols
from .series import Series
from .symbols import coordinate_name, time_scale
from .weak import WeakSystem

if TYPE_CHECKING:
    from .scaling import ScaledSystem

__all__ = ["hierarchy"]


def hierarchy(scaled: ScaledSystem, order: int) -> dict[sp.Expr, tuple[str, list[str]]]:
    """The equations at one order in ε, without any resonance relation.

    Parameters
    ----------
    scaled : ScaledSystem
    order : int
        p ≥ 0.

    Returns
    -------
    dict
        {q_j: (LaTeX of the left side, LaTeX of each term of the right side)}.
    """
    weak = scaled.weak(max(order, 1))
    table = {p.name: p.symbol for p in scaled.eom.parameters}
    symbols = FieldSymbols(weak.ring.field, {**{str(c): c for c in CONSTANTS}, **table})
    names = [sp.latex(sp.Symbol(coordinate_name(q))) for q in scaled.eom.coordinates]
    result = {}
    for j, q in enumerate(scaled.eom.coordinates):
        omega = sp.latex(
            symbols.polynomial(weak.ring.form_polynomial(weak.ring.amplitude_frequencies[j])) ** 2
        )
        own = _indexed(names[j], order)
        left = f"D_0^2 {own} + {omega} {own}"
        terms = list(_kinematic_terms(names[j], order)) if order else []
        for factors, by_order in weak.forces[j].items():
            for s, series in by_order.items():
                if s <= order:
                    coefficient = _real_form(weak, symbols, series)
                    terms += _products(coefficient, factors, names, order - s)
        if order == 0 and weak.forcing[j]:
            terms.append(sp.latex(-_real_form(weak, symbols, weak.forcing[j])))
        result[q] = left, terms
    return result


def _indexed(name: str, order: int) -> str:
    """The name of q_{j,p}: the order joins the subscripts."""
    if "_{" in name:
        head, tail = name.split("_{", 1)
        return f"{head}_{{{tail[:-1]},{order}}}"
    return f"{name}_{{{order}}}" if "_" not in name else f"{{{name}}}_{{,{order}}}"


def _operators(derivative: int, order: int) -> Iterator[str]:
    """(d/dt)^derivative at order ε^order, each term with its multiplicity."""
    if derivative == 0:
        if order == 0:
            yield ""
    elif derivative == 1:
        yield f"D_{{{order}}} "
    else:
        for a in range(order // 2 + 1):
            b = order - a
            yield f"D_{{{a}}}^2 " if a == b else f"2 D_{{{a}}} D_{{{b}}} "


def _motion(name: str, derivative: int, order: int) -> Iterator[str]:
    """The ε^order part of a derivative of q, term by term."""
    for k in range(order + 1):
        for operator in _operators(derivative, order - k):
            yield f"{operator}{_indexed(name, k)}"


def _kinematic_terms(name: str, order: int) -> Iterator[str]:
    """−q'' at one order, without D_0² of the unknown."""
    for k in range(order):
        for operator in _operators(2, order - k):
            yield f"-{operator}{_indexed(name, k)}"


def _products(
    coefficient: sp.Expr, factors: Sequence[int], names: Sequence[str], order: int
) -> list[str]:
    """The ε^order part of −coefficient·Π factors, as one term with a bracket where needed."""
    sums = list(_distributed(factors, names, order))
    if not sums:
        return []
    negative = sp.latex(-coefficient)
    if isinstance(-coefficient, sp.Add):
        negative = rf"\left({negative}\right)"
    if sums == [""]:
        return [negative]
    body = sums[0] if len(sums) == 1 else rf"\left({_joined(sums)}\right)"
    if negative in ("1", "-1"):
        return [f"{negative[:-1]}{body}"]
    return [f"{negative} {body}"]


def _distributed(factors: Sequence[int], names: Sequence[str], order: int) -> Iterator[str]:
    if not factors:
        if order == 0:
            yield ""
        return
    derivative, i = divmod(factors[0], len(names))
    for k in range(order + 1):
        for head in _motion(names[i], derivative, k):
            for tail in _distributed(factors[1:], names, order - k):
                yield f"{head} {tail}".strip()


def _joined(terms: Sequence[str]) -> str:
    text = ""
    for term in terms:
        if not text:
            text = term
        elif term.startswith("-"):
            text += f" - {term[1:].strip()}"
        else:
            text += f" + {term}"
    return text or "0"


def _real_form(weak: WeakSystem, symbols: FieldSymbols, series: Series) -> sp.Expr:
    """A series in phasors in sines and cosines."""
    ring = weak.ring
    terms = []
    for key in sorted(series):
        bar = ring.conjugate_key(key)
        if key == bar:
            terms.append(symbols(series[key]))
            continue
        if bar < key:
            continue
        angle = _angle(weak, symbols, bar)
        re, im = symbols.real_imaginary(series[bar])
        terms.append(2 * re * sp.cos(angle) - 2 * im * sp.sin(angle))
    return sp.Add(*terms)


def _angle(weak: WeakSystem, symbols: FieldSymbols, key: int) -> sp.Expr:
    ring = weak.ring
    moving = symbols.polynomial(ring.form_polynomial(ring.frequency(key))) * time_scale(0)
    exponents = ring.packing.exponents(key)[2 * ring.n :]
    phasors = weak.scaled.alphabet.phasors
    pairs = zip(phasors, exponents, strict=True)
    return moving + sp.Add(*(k * p.angle for p, k in pairs if k and not p.moving))
