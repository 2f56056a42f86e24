"""Reference values of nonlinear slow flows: Jacobians, their eigenvalues, and equilibria.

Rates and their derivatives come from the right-hand sides as formulas, to the working precision of
mpmath; the table of terms says what rounding makes of them in double precision.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from ..errors import MmsgenError
from ..runtime._flow import Flow
from ..runtime._slopes import phase_rows
from .exact import exact
from .kernels import Kernel
from .rounding import UNIT, Rounded, rounded
from .setting import Setting

__all__ = ["MOST", "ExactFlow", "Formulas", "eigenvalues", "equilibrium_values", "jacobian_values"]

#: amplitudes up to which equilibria are among the reference values: more take minutes
MOST = 2

_Numbers = tuple[Any, ...]


@dataclass(frozen=True)
class Formulas:
    """The right-hand sides of a slow flow, and the kernel of its coefficients.

    Attributes
    ----------
    setting : Setting
    kernel : Kernel
        That of the coefficients.
    out : str
        How it calls its output.
    """

    setting: Setting
    kernel: Kernel
    out: str

    @cached_property
    def barred(self) -> dict[sp.Expr, sp.Symbol]:
        """Symbols that stand for the conjugates of the amplitudes."""
        amplitudes = self.setting.case.amplitudes
        return {sp.conjugate(a): sp.Dummy(f"{a.name}_bar") for a in amplitudes}

    @cached_property
    def rates(self) -> list[sp.Expr]:
        """The right-hand sides, by amplitudes and these symbols."""
        pairs = zip(self.setting.case.amplitudes, self.barred.values(), strict=True)
        moduli = {sp.Abs(a): sp.sqrt(a * bar) for a, bar in pairs}
        return [rate.xreplace({**self.barred, **moduli}) for rate in self.setting.rates.values()]

    @cached_property
    def slopes(self) -> list[list[tuple[sp.Expr, sp.Expr]]]:
        """Their derivatives by both."""
        pairs = list(zip(self.setting.case.amplitudes, self.barred.values(), strict=True))
        return [[(rate.diff(a), rate.diff(bar)) for a, bar in pairs] for rate in self.rates]

    @property
    def flow(self) -> Flow:
        """The table of the terms."""
        return self.setting.flow.table.flow


@dataclass(frozen=True)
class ExactFlow:
    """A slow flow at numbers.

    Attributes
    ----------
    formulas : Formulas
    own : mapping
        Name of a parameter → number.
    """

    formulas: Formulas
    own: Mapping[str, Any]

    @cached_property
    def coefficients(self) -> list[Rounded]:
        """Of the table's terms, with the errors that double precision makes of them."""
        inner = rounded(self.formulas.kernel.ir, self.own)
        zero, out = Rounded(mpmath.mpf(0), mpmath.mpf(0)), self.formulas.out
        return [inner.get(f"{out}[..., {m}]", zero) for m in range(len(self.formulas.flow.terms))]

    def _values(self, b: Sequence[Any]) -> dict[str, Any]:
        amplitudes = self.formulas.setting.case.amplitudes
        barred = self.formulas.barred
        values = {**self.own, **{a.name: x for a, x in zip(amplitudes, b, strict=True)}}
        return values | {s.name: mpmath.conj(x) for s, x in zip(barred.values(), b, strict=True)}

    def rates(self, b: Sequence[Any]) -> list[Any]:
        """dB_j/dt."""
        values = self._values(b)
        return [mpmath.mpc(exact(rate, values)) for rate in self.formulas.rates]

    def drift(self, b: Sequence[Any]) -> list[Any]:
        """Rates along the symmetries that leave least of the motion."""
        symmetries = self.formulas.flow.symmetries
        if not symmetries:
            return []
        speed = self.rates(b)
        normal = mpmath.matrix(
            [[_weighted(k, other, b) for other in symmetries] for k in symmetries]
        )
        right = mpmath.matrix([_turning(k, b, speed) for k in symmetries])
        return list(mpmath.lu_solve(normal, right))

    def jacobian(self, b: Sequence[Any], drift: Sequence[Any]) -> mpmath.matrix:
        """Of the Cartesian slow flow, in a frame that drifts."""
        # Derivatives of |B|B are quotients at zero, but continuous: what is stored has 25 digits.
        n, values = len(b), self._values([x or mpmath.mpf(10) ** -40 for x in b])
        whole = mpmath.matrix(2 * n, 2 * n)
        for j, row in enumerate(self.formulas.slopes):
            for k, (by_plain, by_barred) in enumerate(row):
                p, q = exact(by_plain, values), exact(by_barred, values)
                if j == k:
                    p -= mpmath.mpc(0, 1) * self.turn(drift, j)
                both, apart = mpmath.mpc(p + q), mpmath.mpc(p - q)
                whole[2 * j, 2 * k], whole[2 * j, 2 * k + 1] = both.real, -apart.imag
                whole[2 * j + 1, 2 * k], whole[2 * j + 1, 2 * k + 1] = both.imag, apart.real
        return whole

    def turn(self, drift: Sequence[Any], j: int) -> Any:
        """The rate at which one amplitude turns."""
        symmetries = self.formulas.flow.symmetries
        return mpmath.fsum(rho * k[j] for rho, k in zip(drift, symmetries, strict=True))

    def sizes(self, b: Sequence[Any], shift: Any = 0) -> tuple[list[Any], list[list[Any]]]:
        """What rounding makes of the rates, and of their derivatives by each amplitude.

        Parameters
        ----------
        b : sequence
        shift : number
            By how much the amplitudes may be off, relatively.
        """
        n, terms, _ = self.formulas.flow
        rates = [mpmath.mpf(0)] * n
        slopes = [[mpmath.mpf(0)] * n for _ in range(n)]
        for c, (j, e) in zip(self.coefficients, terms, strict=True):
            powers = [sum(map(abs, e[3 * k : 3 * k + 3])) for k in range(n)]
            # One rounding for each factor and each sum, three for complex ones.
            count = (3 * sum(powers) + len(terms) + 2) * UNIT
            error = c.error + abs(c.value) * count
            rates[j] += error * mpmath.fprod(abs(x) ** p for x, p in zip(b, powers, strict=True))
            moved = error + abs(c.value) * max(sum(powers) - 1, 0) * shift
            for k in range(n):
                rest = [p - (i == k) for i, p in enumerate(powers)]
                if powers[k]:
                    product = mpmath.fprod(abs(x) ** p for x, p in zip(b, rest, strict=True))
                    slopes[j][k] += powers[k] * moved * product
        return rates, slopes


def _weighted(k: Sequence[int], other: Sequence[int], b: Sequence[Any]) -> Any:
    return mpmath.fsum(x * y * abs(z) ** 2 for x, y, z in zip(k, other, b, strict=True))


def _turning(k: Sequence[int], b: Sequence[Any], speed: Sequence[Any]) -> Any:
    products = zip(k, b, speed, strict=True)
    return mpmath.fsum(x * (mpmath.conj(y) * z).imag for x, y, z in products)


def jacobian_values(flow: ExactFlow, b: Sequence[Any]) -> tuple[_Numbers, _Numbers]:
    """The Jacobian at given amplitudes, row by row, and bounds of the errors."""
    matrix, bounds = flow.jacobian(b, flow.drift(b)), _entry_errors(flow, b)
    places = [(i, j) for i in range(matrix.rows) for j in range(matrix.cols)]
    return tuple(matrix[i, j] for i, j in places), tuple(bounds[i, j] for i, j in places)


def _entry_errors(flow: ExactFlow, b: Sequence[Any], shift: Any = 0, rate: Any = None) -> Any:
    """Bounds for the entries of a Jacobian: four of them for each pair of amplitudes."""
    rates, slopes = flow.sizes(b, shift)
    if flow.formulas.flow.symmetries and rate is None:
        # The drift is a quotient of sums over the amplitudes.
        least = min(abs(x) for x in b if x)
        rate = 8 * mpmath.fsum(rates) / least
    n = len(b)
    found = mpmath.matrix(2 * n, 2 * n)
    for i in range(2 * n):
        for j in range(2 * n):
            found[i, j] = slopes[i // 2][j // 2] + (rate or 0) * (i // 2 == j // 2)
    return found


# --- eigenvalues ----------------------------------------------------------------------------------


def eigenvalues(flow: ExactFlow, b: Sequence[Any]) -> tuple[_Numbers, _Numbers] | None:
    """Those of the Jacobian at given amplitudes, as `stability` sorts them.

    None where two of them meet.
    """
    return _sorted(flow, flow.jacobian(b, flow.drift(b)), _entry_errors(flow, b), b)


def _sorted(
    flow: ExactFlow, matrix: mpmath.matrix, bounds: mpmath.matrix, b: Sequence[Any]
) -> tuple[_Numbers, _Numbers] | None:
    norm = mpmath.mnorm(matrix, "f")
    across = _across(flow, b)
    units = 32 if matrix.rows == across.cols else 64
    matrix = across.T * matrix * across
    bounds = across.T.apply(abs) * bounds * across.apply(abs)
    values, left, right = mpmath.eig(matrix, left=True, right=True)
    found = []
    for i, value in enumerate(values):
        y, x = left[i, :], right[:, i]
        own = mpmath.fsum(
            abs(y[0, r]) * bounds[r, c] * abs(x[c])
            for r in range(matrix.rows)
            for c in range(matrix.cols)
        )
        # The method is backward stable, with some units of the norm; so is the projection.
        backward = units * UNIT * norm * mpmath.mnorm(y, "f") * mpmath.mnorm(x, "f")
        weight = abs(mpmath.fsum(y[0, r] * x[r] for r in range(matrix.rows)))
        if weight < mpmath.mpf(10) ** -10 * mpmath.mnorm(y, "f") * mpmath.mnorm(x, "f"):
            return None
        found.append((mpmath.mpc(value), (own + backward) / weight))
    noise = norm * mpmath.mpf(10) ** (8 - mpmath.mp.dps)

    def rank(pair: tuple[Any, Any]) -> tuple[Any, Any]:
        return -mpmath.nint(pair[0].real / noise), -pair[0].imag

    found = sorted(found, key=rank)
    moved = 2 * len(b) - len(found)
    found += [(mpmath.mpc(mpmath.nan, mpmath.nan), mpmath.mpf(0))] * moved
    return tuple(value for value, _ in found), tuple(error for _, error in found)


def _across(flow: ExactFlow, b: Sequence[Any]) -> mpmath.matrix:
    """An orthonormal basis of what is across the circles of the symmetries, in its columns."""
    active = np.array([bool(x) for x in b])
    rows: list[tuple[int, ...]] = []
    for k in flow.formulas.flow.symmetries:
        if np.linalg.matrix_rank(np.array([*rows, k]) * active) > len(rows):
            rows.append(k)
    if not rows:
        return mpmath.eye(2 * len(b))
    along = mpmath.matrix(2 * len(b), len(rows))
    for a, k in enumerate(rows):
        for j, x in enumerate(b):
            moved = mpmath.mpc(0, k[j]) * x
            along[2 * j, a], along[2 * j + 1, a] = moved.real, moved.imag
    return mpmath.qr(along, mode="full")[0][:, len(rows) :]


# --- equilibria -----------------------------------------------------------------------------------


def equilibrium_values(
    flow: ExactFlow,
) -> tuple[tuple[int, ...], _Numbers, _Numbers] | None:
    """Shape of the amplitudes; all amplitudes, drifts and growth rates; and bounds of the errors.

    The engine finds them in double precision; here Newton's method takes them to the working one,
    and the right-hand sides as formulas decide. None where they fill curves, or might.
    """
    numbers = {name: float(x) for name, x in flow.own.items()}
    try:
        found = flow.formulas.setting.flow.equilibria(numbers)
    except MmsgenError:
        return None
    there = np.isfinite(found.growth)
    amplitudes: list[Any] = []
    drift: list[Any] = []
    growth: list[Any] = []
    for b, rho in zip(found.amplitudes[there], found.drift[there], strict=True):
        parts = _refined(flow, [mpmath.mpc(complex(x)) for x in b], [mpmath.mpf(x) for x in rho])
        if parts is None:
            return None
        for whole, part in zip((amplitudes, drift, growth), parts, strict=True):
            whole += part
    every = [*amplitudes, *drift, *growth]
    shape = (int(there.sum()), found.amplitudes.shape[-1])
    return shape, tuple(value for value, _ in every), tuple(error for _, error in every)


def _refined(flow: ExactFlow, b: list[Any], drift: list[Any]) -> tuple[list[Any], ...] | None:
    """Amplitudes, drift and growth of one equilibrium, each with a bound of its error.

    None where eigenvalues meet.
    """
    n, symmetries = len(b), flow.formulas.flow.symmetries
    active = np.array([bool(x) for x in b])
    rows = phase_rows(flow.formulas.flow, active) if symmetries else np.zeros((0, 2 * n))
    for _ in range(6):
        matrix = _bordered(flow, b, drift, rows)
        right = mpmath.matrix(2 * n + len(symmetries), 1)
        for j, rate in enumerate(flow.rates(b)):
            left = rate - mpmath.mpc(0, 1) * flow.turn(drift, j) * b[j]
            right[2 * j], right[2 * j + 1] = -2 * left.real, -2 * left.imag
        step = mpmath.lu_solve(matrix, right)
        moved = [mpmath.mpc(step[2 * j], step[2 * j + 1]) / 2 for j in range(n)]
        b = [x + y if x else x for x, y in zip(b, moved, strict=True)]
        drift = [x + step[2 * n + a] for a, x in enumerate(drift)]
        if mpmath.mnorm(step, "f") < mpmath.mpf(10) ** (5 - mpmath.mp.dps):
            break
    inverse = mpmath.inverse(_bordered(flow, b, drift, rows))
    rates, _ = flow.sizes(b)
    # As much as rounding leaves of the rates, Newton's method leaves of them, and its result once.
    error = [4 * rates[j // 2] for j in range(2 * n)]
    off = [
        mpmath.fsum(abs(inverse[i, j]) * 2 * error[j] for j in range(2 * n))
        for i in range(inverse.rows)
    ]
    pairs = [mpmath.hypot(off[2 * j], off[2 * j + 1]) / 2 for j in range(n)]
    errors = [y + 8 * UNIT * abs(x) if x else mpmath.mpf(0) for x, y in zip(b, pairs, strict=True)]
    turns = [x + 8 * UNIT * abs(rho) for x, rho in zip(off[2 * n :], drift, strict=True)]
    shift = max((e / abs(x) for e, x in zip(errors, b, strict=True) if x), default=mpmath.mpf(0))
    bounds = _entry_errors(flow, b, shift, max(turns, default=mpmath.mpf(0)))
    spectrum = _sorted(flow, flow.jacobian(b, drift), bounds, b)
    if spectrum is None:
        return None
    growth = spectrum[0][0].real, spectrum[1][0]
    return list(zip(b, errors, strict=True)), list(zip(drift, turns, strict=True)), [growth]


def _bordered(
    flow: ExactFlow, b: Sequence[Any], drift: Sequence[Any], rows: np.ndarray
) -> mpmath.matrix:
    n, symmetries = len(b), flow.formulas.flow.symmetries
    size = 2 * n + len(symmetries)
    whole = mpmath.matrix(size, size)
    inner = flow.jacobian(b, drift)
    for i in range(2 * n):
        for j in range(2 * n):
            whole[i, j] = inner[i, j]
    for a, k in enumerate(symmetries):
        for j, x in enumerate(b):
            turned = mpmath.mpc(0, -2 * k[j]) * x
            whole[2 * j, 2 * n + a], whole[2 * j + 1, 2 * n + a] = turned.real, turned.imag
        for i in range(size):
            whole[2 * n + a, i] = mpmath.mpf(float(rows[a, i]))
    return whole
