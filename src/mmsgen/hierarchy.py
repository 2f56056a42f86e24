"""The hierarchy of order-ε^p equations, in the operator form in which papers print it.

With d/dt = D_0 + εD_1 + … and q_j = q_{j,0} + εq_{j,1} + …, equation j at order p reads
D_0² q_{j,p} + ω_j² q_{j,p} = −2D_0D_p q_{j,0} − …, with every coefficient written in real form.
Coordinates that the leading order couples keep their matrices M0, G0 and K0.
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

__all__ = ["hierarchy", "indexed"]


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
    coupled = {j for component in scaled.modes.components for j in component.members}
    for j, q in enumerate(scaled.eom.coordinates):
        if j in coupled:
            left, terms = _coupled_row(scaled, j, names, order, table)
        else:
            form = weak.ring.form_polynomial(weak.ring.amplitude_frequencies[j])
            own = indexed(names[j], order)
            square = sp.latex(symbols.polynomial(form) ** 2)
            left = f"D_0^2 {own} + {own if square == '1' else f'{square} {own}'}"
            terms = list(_kinematic_terms(names[j], order)) if order else []
        for factors, by_order in weak.forces[j].items():
            for s, series in by_order.items():
                if s <= order:
                    coefficient = _real_form(weak, symbols, series)
                    shown = _with_moduli(factors, len(names))
                    terms += _products(coefficient, shown, names, order - s)
        if order == 0 and weak.forcing[j]:
            terms.append(sp.latex(-_real_form(weak, symbols, weak.forcing[j])))
        result[q] = left, terms
    return result


def _coupled_row(
    scaled: ScaledSystem, j: int, names: Sequence[str], order: int, table: dict[str, sp.Expr]
) -> tuple[str, list[str]]:
    """M0 D0²q + G0 D0 q + K0 q of one equation, and what the later time scales add to it."""
    part = scaled.modes.part
    left, terms = [], []
    for derivative, entries in ((2, part.inertia), (1, part.gyroscopic), (0, part.stiffness)):
        for (row, i), c in sorted(entries.items(), key=lambda item: item[0]):
            if row != j:
                continue
            shown = FieldSymbols(c.field, table)(c)
            operator = ("", "D_0 ", "D_0^2 ")[derivative]
            left.append(_with_factor(shown, operator + indexed(names[i], order)))
            for k in range(order):
                for number, text in _operators(derivative, order - k):
                    terms.append(_with_factor(-number * shown, text + indexed(names[i], k)))
    return _joined(left), terms


def _with_factor(factor: sp.Expr, text: str) -> str:
    """A factor before an operator, without a 1."""
    if factor in (1, -1):
        return text if factor == 1 else f"-{text}"
    shown = sp.latex(factor)
    return rf"\left({shown}\right) {text}" if factor.is_Add else f"{shown} {text}"


def indexed(name: str, order: int) -> str:
    """The name of q_{j,p}: the order joins the subscripts."""
    if "_{" in name:
        head, tail = name.split("_{", 1)
        return f"{head}_{{{tail[:-1]},{order}}}"
    return f"{name}_{{{order}}}" if "_" not in name else f"{{{name}}}_{{,{order}}}"


def _operators(derivative: int, order: int) -> Iterator[tuple[int, str]]:
    """(d/dt)^derivative at order ε^order, each term with its multiplicity."""
    if derivative == 0:
        if order == 0:
            yield 1, ""
    elif derivative == 1:
        yield 1, f"D_{{{order}}} "
    else:
        for a in range(order // 2 + 1):
            b = order - a
            yield (1, f"D_{{{a}}}^2 ") if a == b else (2, f"D_{{{a}}} D_{{{b}}} ")


_SIGN, _MODULUS = 3, 5
"""Places of sgn q, sgn q' and |q|, |q'| among the derivatives in a product of variables."""


def _with_moduli(factors: Sequence[int], n: int) -> tuple[int, ...]:
    """A product of variables in which x sgn x is written |x|."""
    result = list(factors)
    for sign in factors:
        place = sign - _SIGN * n
        if place >= 0 and place in result:
            result.remove(place)
            result[result.index(sign)] = sign + (_MODULUS - _SIGN) * n
    return tuple(result)


def _motion(name: str, derivative: int, order: int) -> Iterator[tuple[int, str]]:
    """The ε^order part of a derivative of q, each term with its multiplicity."""
    if derivative >= _SIGN:  # known at order zero alone
        modulus, inner = divmod(derivative - _SIGN, 2)
        text = ("", "D_{0} ")[inner] + indexed(name, 0)
        if order == 0:
            whole = rf"\left|{text}\right|"
            yield 1, whole if modulus else rf"\operatorname{{sgn}}\left({text}\right)"
        return
    for k in range(order + 1):
        for number, operator in _operators(derivative, order - k):
            yield number, f"{operator}{indexed(name, k)}"


def _kinematic_terms(name: str, order: int) -> Iterator[str]:
    """−q'' at one order, without D_0² of the unknown."""
    for k in range(order):
        for number, operator in _operators(2, order - k):
            yield f"-{_times(number, operator + indexed(name, k))}"


def _times(number: int, text: str) -> str:
    return text if number == 1 else f"{number} {text}"


def _products(
    coefficient: sp.Expr, factors: Sequence[int], names: Sequence[str], order: int
) -> list[str]:
    """The ε^order part of −coefficient·Π factors, as one term with a bracket where needed."""
    # Equal products come up once for each order of their factors.
    counts: dict[_Product, int] = {}
    for number, product in _distributed(factors, names, order):
        key = tuple(sorted(product))
        counts[key] = counts.get(key, 0) + number
    if not counts:
        return []
    single = next(iter(counts.values())) if len(counts) == 1 else 1
    coefficient = -coefficient * single
    leading = sp.latex(coefficient)
    if isinstance(coefficient, sp.Add):
        leading = rf"\left({leading}\right)"
    if not factors:
        return [leading]
    if len(counts) == 1:
        body = _shown(next(iter(counts)))
    else:
        body = rf"\left({_joined([_times(n, _shown(p)) for p, n in counts.items()])}\right)"
    if leading in ("1", "-1"):
        return [f"{leading[:-1]}{body}"]
    return [f"{leading} {body}"]


_Product = tuple[tuple[int, int, str], ...]
"""Factors, each with its variable and its place among the terms of that variable, and its text."""


def _distributed(
    factors: Sequence[int], names: Sequence[str], order: int
) -> Iterator[tuple[int, _Product]]:
    """Every product of one term of each factor, with the number of its occurrences."""
    if not factors:
        if order == 0:
            yield 1, ()
        return
    derivative, i = divmod(factors[0], len(names))
    for k in range(order + 1):
        for place, (number, text) in enumerate(_motion(names[i], derivative, k)):
            own = (factors[0], 1000 * k + place, text)
            for others, tail in _distributed(factors[1:], names, order - k):
                yield number * others, (own, *tail)


def _shown(product: _Product) -> str:
    """A product with powers; an operator acts on what stands in its own brackets."""
    texts = [text for *_, text in product]
    parts = []
    for text in dict.fromkeys(texts):
        power = texts.count(text)
        bracketed = (text.startswith("D_") and len(texts) > 1) or (power > 1 and "^" in text)
        part = rf"\left({text}\right)" if bracketed else text
        parts.append(part if power == 1 else f"{part}^{{{power}}}")
    return " ".join(parts)


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
    pairs = zip(weak.scaled.alphabet.phasors, ring.phasors(key), strict=True)
    return moving + sp.Add(*(k * p.angle for p, k in pairs if k and not p.moving))
