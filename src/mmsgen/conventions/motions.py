"""Frequency and amplitude of free motions, as series that can be solved for one another."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import sympy as sp

from ..errors import ConventionError
from ..symbols import modulus, time_scale
from ..validation import TIME
from .graded import Graded, composed, exact, graded, tidy

if TYPE_CHECKING:
    from ..expansion import Expansion

__all__ = ["displacement", "frequency", "natural_frequencies", "power", "reversion"]


def frequency(case: Expansion) -> Graded:
    """The frequency of a free undamped motion over its amplitude a, A = (a/2) e^{iβ}.

    Parameters
    ----------
    case : Expansion
        Of one coordinate.

    Returns
    -------
    dict
        {0: ω, p: coefficient of ε^p}, ω plus dβ/dt.

    Raises
    ------
    ConventionError
        If the motion is not periodic for every amplitude: the system is excited or damped.
    """
    q, a = _single(case)
    (w,) = natural_frequencies(case)
    result: Graded = {0: w}
    (amplitude,) = case.amplitudes
    half = {amplitude: a / 2, sp.conjugate(amplitude): a / 2}
    for p, rates in case.solvability.items():
        rate = tidy(rates[amplitude].xreplace(half) / (sp.I * a / 2), [a])
        if TIME in rate.free_symbols or rate.has(sp.I):
            raise ConventionError(
                f"the amplitude of {q} changes at order {p}: only free undamped motions have a "
                "frequency for every amplitude"
            )
        result[p] = rate
    return result


def displacement(case: Expansion, phase: sp.Expr | int = 0) -> Graded:
    """The displacement at which a free motion turns, over the amplitude a of its fundamental.

    With zero initial velocity it is the initial displacement; at phase 0 the largest one, and at
    phase π the other end. `reversion` gives a over it, and `substituted` puts that into
    `frequency`.

    Parameters
    ----------
    case : Expansion
        Of one coordinate.
    phase : sympy.Expr
        0 or π.

    Returns
    -------
    dict
        {p: coefficient of ε^p}, p below the order of the case.

    Raises
    ------
    ConventionError
        If the motion does not turn at that phase, as where it is damped or excited.
    """
    q, a = _single(case)
    (w,) = natural_frequencies(case)
    (amplitude,) = case.amplitudes
    half = {amplitude: a / 2, sp.conjugate(amplitude): a / 2}
    fast, turn = time_scale(0), exact(phase, "the phase")
    result: Graded = {}
    for p in range(case.order):
        motion = case.particular(p)[q].xreplace(half)
        phasors = [e.args[0] for e in motion.atoms(sp.exp) if e.has(fast)]
        if not all(sp.cancel(e / (sp.I * w * fast)).is_Integer for e in phasors):
            raise ConventionError(
                f"the motion of {q} is excited: it is not periodic, and has no largest displacement"
            )
        at = {fast: turn / w}
        speed = tidy(motion.diff(fast).xreplace(at), [a])
        value = tidy(motion.xreplace(at), [a])
        if speed != 0 or TIME in value.free_symbols or value.has(sp.I, sp.exp):
            raise ConventionError(
                f"{q} does not turn at the phase {phase} at order {p}: its largest displacement "
                "has no such series; only free undamped motions do"
            )
        result[p] = value
    return result


def reversion(series: Mapping[int, Any], old: sp.Symbol, new: sp.Symbol) -> Graded:
    """Solve new = Σ ε^p series_p(old) for old, as a series in ε.

    Parameters
    ----------
    series : mapping
        {p: expression in `old`}; at order 0 a constant times `old`.
    old, new : sympy.Symbol

    Raises
    ------
    ConventionError
        If order 0 is anything else.
    """
    terms = graded(series, "the series")
    slope = sp.cancel(terms.get(0, sp.S.Zero) / old)
    if slope == 0 or slope.free_symbols & {old, new}:
        raise ConventionError(
            f"the series begins with {terms.get(0, 0)}: only one that begins with a constant times "
            f"{old} can be solved for it"
        )
    result: Graded = {0: new / slope}
    for p in range(1, max(terms) + 1):
        higher = sp.Add(
            *(composed(c, {old: result}, p - k)[p - k] for k, c in terms.items() if 1 <= k <= p)
        )
        result[p] = tidy(-higher / slope, [new])
    return result


def power(series: Mapping[int, Any], exponent: sp.Rational | int) -> Graded:
    """A power of a series: ω² = Σ … or the period 2π/ω from ω, and ω from ω².

    Parameters
    ----------
    series : mapping
        {p: coefficient}, not zero at order 0.
    exponent : Rational

    Raises
    ------
    ConventionError
        If the exponent is not rational, or order 0 is zero.
    """
    terms = graded(series, "the series")
    number = exact(exponent, "the exponent")
    if not number.is_Rational or terms.get(0, sp.S.Zero) == 0:
        raise ConventionError(
            "a power needs a rational exponent and a series that begins at order 0"
        )
    base = sp.Dummy("base")
    parts = composed(base**number, {base: terms}, max(terms))
    return {p: sp.factor(c) for p, c in enumerate(parts)}


def _single(case: Expansion) -> tuple[sp.Expr, sp.Symbol]:
    """The coordinate and its amplitude a, of which there has to be one."""
    if len(case.coordinates) != 1:
        raise ConventionError(
            f"the case has the coordinates {', '.join(map(str, case.coordinates))}: a frequency "
            "over one amplitude needs a single one"
        )
    (q,) = case.coordinates
    return q, modulus(q)


def natural_frequencies(case: Expansion) -> tuple[sp.Expr, ...]:
    """The frequency that stands beside each amplitude, q = A e^{iωT0} + …."""
    frequencies = []
    for (q, motion), a in zip(case.particular(0).items(), case.amplitudes, strict=True):
        turn = sp.expand(motion).coeff(a)
        if not isinstance(turn, sp.exp):
            raise ConventionError(f"{a} is not the amplitude of {q} alone: no such variables here")
        frequencies.append(sp.cancel(turn.args[0] / (sp.I * time_scale(0))))
    return tuple(frequencies)
