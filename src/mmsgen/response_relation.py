"""One amplitude: frequency-response relation, backbone and bifurcations as exact formulas.

The phase is eliminated as in `mmsgen.runtime._elimination`, with exact coefficients in the place of
numbers. Write F = Σ f_k(a) w^k for the slow flow, w a power of e^{iγ}. With one power of w beside a
constant, the only case at order one, the relation is |f_0|² − |f_1|² = 0: it holds exactly where
w = −f_0/f_1 lies on the unit circle, so that no solution is lost and none is added. Its derivative
by a is proportional to the determinant of the Jacobian, since

    |f_1|² Re(f̄_0 f_0') − |f_0|² Re(f̄_1 f_1') = |f_1|² d(|f_0|² − |f_1|²)/2da   on the relation.

With more powers of w it is the resultant of F and its reciprocal, a polynomial combination of the
two, so that no solution is lost; it vanishes besides where they share a root off the unit circle,
which for two powers needs both |f_0| = |f_2| and f̄_0 f_1 = f_2 f̄_1.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

import sympy as sp
from flint import fmpq_mpoly

from .errors import ExpansionError
from .exact_polynomials import AmplitudePolynomials, Exact
from .field import Coefficient
from .runtime._elimination import (
    Polynomial,
    Structure,
    added,
    multiplied,
    phase_quotient,
    resultant,
    structure_of,
)
from .runtime._flow import Flow
from .symbols import modulus, phase

if TYPE_CHECKING:
    from .slowflow import SlowFlow

__all__ = ["OneAmplitude", "one_amplitude"]


@dataclass(frozen=True)
class OneAmplitude:
    """The exact slow flow of one amplitude, ready for elimination.

    Attributes
    ----------
    flow : SlowFlow
    structure : Structure
    terms : tuple of (int, int, int, Exact)
        Harmonic h, k in f_k, power of |B|, coefficient.
    """

    flow: SlowFlow
    structure: Structure
    terms: tuple[tuple[int, int, int, Exact], ...]

    @property
    def amplitude(self) -> sp.Symbol:
        """The symbol a."""
        return modulus(self.flow.case.coordinates[0])

    @cached_property
    def _algebra(self) -> AmplitudePolynomials:
        return AmplitudePolynomials(self.flow.case.symbols, self.amplitude)

    @cached_property
    def harmonics(self) -> list[Polynomial]:
        """f_k as {power of a: exact coefficient}, apart from powers of a that all have."""
        f: list[Polynomial] = [{} for _ in range(self.structure.degree + 1)]
        for _, k, power, c in self.terms:
            f[k] = added(f[k], {power - self.structure.common: c.scaled(Fraction(1, 2**power))})
        return f

    @cached_property
    def _relation(self) -> fmpq_mpoly:
        if self.structure.degree:
            found = resultant(self.harmonics)
        elif self.structure.circle:
            found = {e: c.real for e, c in self.harmonics[0].items()}
        else:
            raise ExpansionError(
                "this slow flow has no equilibrium but zero: its phase cannot stand still"
            )
        p = self._algebra.polynomial(found)
        if not p:
            raise ExpansionError(
                "there is no response relation: equilibria fill a curve, since nothing dissipates "
                "or forces; .backbone() gives the frequency of every amplitude"
            )
        return self._algebra.with_amplitude(self._algebra.essential(p))

    @cached_property
    def relation(self) -> sp.Expr:
        """See `NonlinearAnswers.response_relation`."""
        return self._algebra.shown(self._relation)

    @cached_property
    def backbone(self) -> dict[sp.Symbol, sp.Expr]:
        """See `NonlinearAnswers.backbone`."""
        case, a = self.flow.case, self.amplitude
        rate = sp.Add(
            *(
                case.symbols(c.imag.value) * sp.Rational(1, 2**power) * 2 * a ** (power - 1)
                for h, _, power, c in self.terms
                if h == 0 and c.imag
            )
        )
        if self.structure.circle:
            return {phase(case.coordinates[0]): rate}
        return _solved(sp.expand(rate), a, [r.detuning for r in case.relations])

    # -- bifurcations --------------------------------------------------------------------

    @cached_property
    def bifurcations(self) -> dict[str, tuple[sp.Expr, ...]]:
        """See `NonlinearAnswers.bifurcation_equations`."""
        algebra = self._algebra
        found: dict[str, tuple[fmpq_mpoly, ...]] = {}
        slope = algebra.essential(algebra.slope(self._relation))
        if not slope.is_one():
            found["saddle-node"] = (self._relation, slope)
        linear = {h: c for h, _, power, c in self.terms if power == 1}
        if all(power for _, _, power, _ in self.terms) and 0 in linear:
            at_rest = {0: linear[0].real}
            if not self.structure.circle:
                found["Hopf of zero"] = (algebra.essential(algebra.polynomial(at_rest)),)
                at_rest = {}
            if -2 in linear:
                at_rest = resultant([{0: linear[0]}, {0: linear[-2]}])
            if at_rest:
                name = "Hopf" if self.structure.circle else "pitchfork"
                found[name] = (algebra.essential(algebra.polynomial(at_rest)),)
        trace = self._trace()
        if trace:
            found["Hopf"] = (self._relation, algebra.essential(algebra.polynomial(trace)))
        return {
            kind: tuple(algebra.shown(p) for p in equations)
            for kind, equations in found.items()
            if not any(p.is_one() for p in equations)
        }

    def _trace(self) -> Polynomial:
        """The trace of the Jacobian at equilibria with a > 0, but for positive factors.

        The divergence of c B^r B̄^s |B|^t is 2 Re of (r + t/2) c r^{p-1} e^{ihγ}.
        """
        by_turn: dict[int, Polynomial] = {}
        for h, _, power, c in self.terms:
            weight = Fraction(power + h + 1, 2**power)
            if weight:
                turn = h // self.structure.fold
                by_turn[turn] = added(by_turn.get(turn, {}), {power: c.scaled(weight)})
        whole = all(h % self.structure.fold == 0 for h, _, _, _ in self.terms)
        if self.structure.circle or not whole:
            return {}
        reach = max(map(abs, by_turn), default=0)
        if reach and self.structure.degree > 2:
            return {}  # no quotient gives the phase
        one: Polynomial = {0: Exact(self.flow.case.weak.ring.field.one)}
        above, below = phase_quotient(self.harmonics) if reach else (one, one)
        total: Polynomial = {}
        for turn, part in by_turn.items():
            for _ in range(abs(turn)):
                factor = above if turn > 0 else {e: c.conj() for e, c in above.items()}
                part = multiplied(part, factor)
            for _ in range(reach - abs(turn)):
                part = multiplied(part, below)
            total = added(total, {e: c.real for e, c in part.items()})
        return {e: c for e, c in total.items() if c}


def _solved(rate: sp.Expr, a: sp.Symbol, detunings: list[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """The first detuning for which the phase stands still."""
    for sigma in detunings:
        powers = sp.Poly(rate, sigma)
        if powers.degree() == 1:
            slope, rest = powers.all_coeffs()
            parts = sp.Poly(rest, a).terms() if rest != 0 else []
            return {sigma: sp.Add(*(sp.factor(-c / slope) * a**k for (k,), c in reversed(parts)))}
        if powers.degree() > 1:
            raise ExpansionError(
                f"the backbone is not linear in {sigma} at this order; use .response_relation(), "
                "or the backbone of a lower order"
            )
    raise ExpansionError("no detuning turns this amplitude, so it has no backbone")


def one_amplitude(flow: SlowFlow) -> OneAmplitude:
    """Collect the terms of a slow flow of one amplitude.

    Raises
    ------
    ExpansionError
        If there are several amplitudes, if no frame makes the slow flow autonomous, or if constant
        phases cannot be turned away.
    """
    case, ring = flow.case, flow.case.weak.ring
    if ring.n != 1:
        raise ExpansionError(
            "formulas for the response are made for one amplitude; this slow flow has "
            f"{ring.n}: use .equilibria, or .cartesian and .jacobian"
        )
    found: dict[tuple[int, int, int], list[Coefficient]] = {}
    turns: dict[int, int] = {}
    flow.frame_rate(0)
    assert flow.frame is not None
    form = {str(s.name): c for s, c in flow.frame[0].items()}
    frame = ring.field.polynomial(ring.field.linear(form)).times_i(-1)
    if frame:
        found[1, 0, 0], turns[0] = [frame], 0
    for key, c in flow.rates[0].items():
        r, s, *_ = ring.packing.exponents(key)
        turn = case.phase_key(key)
        if turns.setdefault(r - s - 1, turn) != turn:
            raise _phase_error()
        found.setdefault((r, s, ring.moduli(key)[0]), []).append(c)
    summed = {e: ring.field.sum(cs) for e, cs in sorted(found.items())}
    summed = {e: c for e, c in summed.items() if c}
    _check_turns(turns)
    exponents = tuple((0, e) for e in summed)
    table = Flow(1, exponents, flow.table.flow.symmetries)
    structure = structure_of(table, (True,) * len(exponents))
    terms = tuple(
        (structure.lowest + structure.fold * k, k, power + structure.common, Exact(c))
        for (_, k, power), c in zip(structure.terms, summed.values(), strict=True)
    )
    return OneAmplitude(flow, structure, terms)


def _check_turns(turns: dict[int, int]) -> None:
    """Constant phases can be turned away where they are linear in the harmonic."""
    harmonics = sorted(turns)
    for h, j, k in zip(harmonics, harmonics[1:], harmonics[2:], strict=False):
        if (turns[j] - turns[h]) * (k - j) != (turns[k] - turns[j]) * (j - h):
            raise _phase_error()


def _phase_error() -> ExpansionError:
    """The error for phases that matter."""
    return ExpansionError(
        "the response depends on constant phases that no shift of time turns away, and has no "
        "rational form: write their cosines and sines as parameters, or use .equilibria"
    )
