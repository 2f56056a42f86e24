"""`SlowFlow`: the modulation equations of a case, complex, polar and Cartesian.

The solvability conditions are put together, dA_j/dt = Σ_p D_p A_j at ε = 1. A frame

    A_j = B_j e^{iλ_j t},   λ_j a linear form in the detunings,

that makes them autonomous is found from the resonance lattice: every monomial of the equation of
A_j must turn at the same rate λ_j. Where amplitudes are free to turn together, the first of them
stays at rest.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

import sympy as sp

from .amplitude_flow import AmplitudeFlow, amplitude_flow
from .cycle_answers import CycleAnswers
from .errors import ExpansionError
from .expressions import rational
from .linear_answers import LinearAnswers
from .motion_answers import MotionAnswers
from .nonlinear_answers import NonlinearAnswers
from .series import Series
from .symbols import imaginary_part, modulus, phase, real_part

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["SlowFlow", "slow_flow"]


@dataclass(frozen=True)
class SlowFlow(LinearAnswers, NonlinearAnswers, CycleAnswers, MotionAnswers):
    """The slow flow of a case.

    Attributes
    ----------
    case : Expansion
    rates : tuple of Series
        dA_j/dt in the sparse algebra, all orders together.
    frame : tuple or None
        λ_j for each coordinate as {detuning: coefficient}; None where no frame makes the
        equations autonomous.
    """

    case: Expansion
    rates: tuple[Series, ...]
    frame: tuple[Mapping[sp.Symbol, Fraction], ...] | None

    def __repr__(self) -> str:
        return f"SlowFlow({self.case!r})"

    def __post_init__(self) -> None:
        declared = {p.symbol for p in self.case.parameters} | set(self.case.amplitudes)
        declared.add(self.case.weak.scaled.eom.time)
        for a, expression in self.complex.items():
            foreign = expression.free_symbols - declared
            if foreign:
                raise ExpansionError(f"the slow flow of {a} contains undeclared {foreign}")

    # -- forms ---------------------------------------------------------------------------

    @cached_property
    def complex(self) -> dict[sp.Symbol, sp.Expr]:
        """{A_j: dA_j/dt}, with e^{iσt} where a detuning turns a term."""
        return {
            a: sp.Add(
                *(self.case.solvability[p][a] for p in range(1, self.case.order + 1)),
            )
            for a in self.case.amplitudes
        }

    def frame_rate(self, j: int) -> sp.Expr:
        """λ_j as an expression in the detunings.

        Raises
        ------
        ExpansionError
            If no frame makes the slow flow autonomous.
        """
        if self.frame is None:
            raise ExpansionError(
                "no rotating frame makes this slow flow autonomous: its resonance terms turn at "
                "incommensurate detunings; use .complex, which keeps the time"
            )
        return sp.Add(*(rational(c) * s for s, c in self.frame[j].items()))

    @cached_property
    def autonomous(self) -> dict[sp.Symbol, sp.Expr]:
        """{A_j: dB_j/dt} in the frame A_j = B_j e^{iλ_j t}, with A_j written for B_j."""
        case = self.case
        flow = {}
        for j, a in enumerate(case.amplitudes):
            terms = [-sp.I * self.frame_rate(j) * a]
            for key in sorted(self.rates[j]):
                turned = sp.exp(sp.I * case.constant_phase(key))
                powers = case.amplitude_monomial(key)
                terms.append(sp.Mul(case.symbols(self.rates[j][key]), powers, turned))
            flow[a] = sp.Add(*terms)
        return flow

    def _polar_terms(self, j: int) -> list[tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]]:
        """Each term of e^{−iγ_j} dB_j/dt as (real, imaginary, modulus, angle)."""
        case, ring = self.case, self.case.weak.ring
        terms = []
        for key in sorted(self.rates[j]):
            exponents, moduli = ring.packing.exponents(key), ring.moduli(key)
            size, angle = sp.Integer(1), case.constant_phase(key) - phase(case.coordinates[j])
            for i, q in enumerate(case.coordinates):
                r, s = exponents[2 * i], exponents[2 * i + 1]
                size *= (modulus(q) / 2) ** (r + s + moduli[i])
                angle += (r - s) * phase(q)
            re, im = case.symbols.real_imaginary(self.rates[j][key])
            terms.append((re, im, size, angle))
        return terms

    @cached_property
    def polar(self) -> dict[sp.Symbol, sp.Expr]:
        """{a_j: da_j/dt, γ_j: dγ_j/dt} with B_j = (a_j/2) e^{iγ_j}, in the autonomous frame."""
        flow: dict[sp.Symbol, sp.Expr] = {}
        for j, q in enumerate(self.case.coordinates):
            a, terms = modulus(q), self._polar_terms(j)
            radial = (2 * m * (re * sp.cos(v) - im * sp.sin(v)) for re, im, m, v in terms)
            angular = (2 * m / a * (re * sp.sin(v) + im * sp.cos(v)) for re, im, m, v in terms)
            flow[a] = sp.Add(*radial)
            flow[phase(q)] = sp.Add(-self.frame_rate(j), *angular)
        return flow

    @cached_property
    def cartesian(self) -> dict[sp.Symbol, sp.Expr]:
        """{u_j: du_j/dt, v_j: dv_j/dt} with B_j = (u_j + i v_j)/2, in the autonomous frame."""
        case, ring = self.case, self.case.weak.ring
        flow: dict[sp.Symbol, sp.Expr] = {}
        for j, q in enumerate(case.coordinates):
            u, v = real_part(q), imaginary_part(q)
            real, imaginary = [self.frame_rate(j) * v], [-self.frame_rate(j) * u]
            for key in sorted(self.rates[j]):
                exponents, moduli = ring.packing.exponents(key), ring.moduli(key)
                product, size = sp.Integer(2), sp.Integer(1)
                for i, p in enumerate(case.coordinates):
                    half = (real_part(p) + sp.I * imaginary_part(p)) / 2
                    product *= half ** exponents[2 * i]
                    product *= sp.conjugate(half) ** exponents[2 * i + 1]
                    square = real_part(p) ** 2 + imaginary_part(p) ** 2
                    size *= (sp.sqrt(square) / 2) ** moduli[i]
                x, y = (size * part for part in sp.expand(product).as_real_imag())
                angle = case.constant_phase(key)
                x, y = (
                    x * sp.cos(angle) - y * sp.sin(angle),
                    x * sp.sin(angle) + y * sp.cos(angle),
                )
                re, im = case.symbols.real_imaginary(self.rates[j][key])
                real.append(re * x - im * y)
                imaginary.append(re * y + im * x)
            flow[u], flow[v] = sp.Add(*real), sp.Add(*imaginary)
        return flow

    @cached_property
    def jacobian(self) -> sp.ImmutableDenseMatrix:
        """Derivatives of the Cartesian slow flow, rows and columns in its order."""
        flow = self.cartesian
        rows = [[rate.diff(x) for x in flow] for rate in flow.values()]
        return sp.ImmutableDenseMatrix(rows)

    @cached_property
    def table(self) -> AmplitudeFlow:
        """The autonomous slow flow as a table of terms, for functions that take numbers.

        Raises
        ------
        ExpansionError
            If no frame makes it autonomous.
        """
        return amplitude_flow(self)


def _frame(case: Expansion, rates: tuple[Series, ...]) -> tuple[Any, ...] | None:
    """Rates λ_j such that every term of equation j turns at λ_j; None if there are none."""
    ring = case.weak.ring
    sigmas = [r.detuning for r in case.relations]
    n = ring.n
    rows: dict[tuple[Any, ...], None] = {}
    for j, series in enumerate(rates):
        for key in sorted(series):
            e = ring.packing.exponents(key)
            row = [sp.Integer(e[2 * i] - e[2 * i + 1] - (i == j)) for i in range(n)]
            turn = sp.expand(case.detuning_phase(key))
            right = [-turn.coeff(s) for s in sigmas]
            rows[tuple(reversed(row)), tuple(right)] = None
    if not rows:
        return tuple({} for _ in range(n))
    m = len(sigmas)
    system = sp.Matrix([[*row, *right] for row, right in rows])
    reduced, pivots = system.rref()
    if any(p >= n for p in pivots):
        return None
    frame: list[dict[sp.Symbol, Fraction]] = [{} for _ in range(n)]
    for r, p in enumerate(pivots):
        for k in range(m):
            value = reduced[r, n + k]
            if value != 0:
                frame[n - 1 - p][sigmas[k]] = Fraction(int(value.p), int(value.q))
    return tuple(frame)


def slow_flow(case: Expansion) -> SlowFlow:
    """Put the solvability conditions of all orders together and find the autonomous frame."""
    ring = case.weak.ring
    rates = tuple(
        ring.add(*(case.solver.g[p][j] for p in range(1, case.order + 1))) for j in range(ring.n)
    )
    return SlowFlow(case, rates, _frame(case, rates))
