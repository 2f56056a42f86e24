"""The phase of one amplitude eliminated: a real polynomial in the modulus, in batches.

With B = r e^{iγ} the slow flow is e^{iγ} F, F = Σ_h g_h(r) e^{ihγ}, a short Fourier sum whose
coefficients are polynomials in r. Let m be the common divisor of the differences of the h and
w = e^{imγ}; apart from powers of e^{iγ} and r, F is then a polynomial f_0 + f_1 w + … + f_d w^d. On
the unit circle it vanishes together with its reciprocal f̄_d + … + f̄_0 w^d, so r is a root of their
resultant, the determinant of the Schur–Cohn form: a real polynomial in r. For d = 1 it is
|f_0|² − |f_1|², the frequency-response relation of the textbooks.

Sources: Schur (1918) and Cohn (1922) on roots and the unit circle; Nayfeh and Mook (1979), chapter
4, for d = 1.
"""

from __future__ import annotations

from functools import lru_cache
from math import gcd
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._flow import Flow

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "Polynomial",
    "Structure",
    "added",
    "harmonics",
    "multiplied",
    "phase_quotient",
    "relation",
    "resultant",
    "rows_of",
    "structure_of",
]

Polynomial = dict[int, Any]
"""Exponent of r → an array, one coefficient for each point."""


class Structure(NamedTuple):
    """What the exponents of a flow tell, those terms left out that vanish.

    Attributes
    ----------
    degree : int
        d.
    fold : int
        m, the number of phases of each w.
    terms : tuple of (int, int, int)
        Index of a term, its k in f_k, its power of r after the common one is taken out.
    lowest : int
        The lowest h.
    common : int
        The power of r that is taken out.
    circle : bool
        Whether the flow has a symmetry, so that equilibria are circles that may drift.
    """

    degree: int
    fold: int
    terms: tuple[tuple[int, int, int], ...]
    lowest: int
    common: int
    circle: bool


@lru_cache(maxsize=256)
def structure_of(flow: Flow, present: tuple[bool, ...]) -> Structure:
    """The structure of a flow, from its exponents and which of its terms do not vanish."""
    found = [
        (i, r - s - 1, r + s + t)
        for (i, (_, (r, s, t))), here in zip(enumerate(flow.terms), present, strict=True)
        if here
    ]
    lowest = min((h for _, h, _ in found), default=0)
    common = min((power for _, _, power in found), default=0)
    fold = gcd(*(h - lowest for _, h, _ in found)) or 1
    terms = tuple((i, (h - lowest) // fold, power - common) for i, h, power in found)
    degree = max((k for _, k, _ in terms), default=0)
    return Structure(degree, fold, terms, lowest, common, bool(flow.symmetries))


# --- polynomials whose coefficients are arrays ----------------------------------------------------


def added(a: Polynomial, b: Polynomial, sign: int = 1) -> Polynomial:
    """a + sign·b."""
    out = dict(a)
    for e, c in b.items():
        out[e] = out[e] + sign * c if e in out else sign * c
    return out


def multiplied(a: Polynomial, b: Polynomial) -> Polynomial:
    """a·b."""
    out: Polynomial = {}
    for i, x in a.items():
        for j, y in b.items():
            out[i + j] = out[i + j] + x * y if i + j in out else x * y
    return out


def _bar(a: Polynomial) -> Polynomial:
    return {e: c.conj() for e, c in a.items()}


def _square(a: Polynomial) -> Polynomial:
    """|a|², in real numbers."""
    out: Polynomial = {}
    items = list(a.items())
    for n, (i, x) in enumerate(items):
        out[2 * i] = out.get(2 * i, 0) + (x.real * x.real + x.imag * x.imag)
        for j, y in items[n + 1 :]:
            out[i + j] = out.get(i + j, 0) + 2 * (x.real * y.real + x.imag * y.imag)
    return out


def resultant(f: list[Polynomial]) -> Polynomial:
    """The determinant of the Schur–Cohn form, real."""
    d = len(f) - 1
    if d == 1:
        return added(_square(f[0]), _square(f[1]), -1)
    if d == 2:
        x, y = _linear_remainder(f)
        return added(multiplied(x, x), _square(y), -1)
    form = [[_entry(f, j, k) for k in range(d)] for j in range(d)]
    minors: dict[tuple[int, ...], Polynomial] = {(k,): form[-1][k] for k in range(d)}

    def minor(columns: tuple[int, ...]) -> Polynomial:
        """The determinant of the last rows and these columns."""
        if columns not in minors:
            row = d - len(columns)
            total: Polynomial = {}
            for n, k in enumerate(columns):
                rest = minor(columns[:n] + columns[n + 1 :])
                total = added(total, multiplied(form[row][k], rest), -1 if n % 2 else 1)
            minors[columns] = total
        return minors[columns]

    return {e: c.real for e, c in minor(tuple(range(d))).items()}


def _linear_remainder(f: list[Polynomial]) -> tuple[Polynomial, Polynomial]:
    """X + Y w, what is left of f_0 + f_1 w + f_2 w² and its reciprocal when w² is eliminated."""
    x = added(_square(f[0]), _square(f[2]), -1)
    y = added(multiplied(_bar(f[0]), f[1]), multiplied(f[2], _bar(f[1])), -1)
    return x, y


def phase_quotient(f: list[Polynomial]) -> tuple[Polynomial, Polynomial]:
    """Numerator and real denominator of w on the relation, for d = 1 and 2."""
    above, below = f if len(f) == 2 else _linear_remainder(f)
    minus: Polynomial = {e: -1 * c for e, c in above.items()}
    return multiplied(minus, _bar(below)), _square(below)


def _entry(f: list[Polynomial], j: int, k: int) -> Polynomial:
    """Σ_l f_{j-l} f̄_{k-l} − f̄_{d-j+l} f_{d-k+l}."""
    d = len(f) - 1
    out: Polynomial = {}
    for n in range(min(j, k) + 1):
        out = added(out, multiplied(f[j - n], _bar(f[k - n])))
        out = added(out, multiplied(_bar(f[d - j + n]), f[d - k + n]), -1)
    return out


class _Gaussian:
    """A Gaussian integer, with what a resultant asks of its coefficients."""

    def __init__(self, real: int, imag: int) -> None:
        self.real, self.imag = real, imag

    def __add__(self, other: _Gaussian) -> _Gaussian:
        return _Gaussian(self.real + other.real, self.imag + other.imag)

    def __mul__(self, other: _Gaussian) -> _Gaussian:
        x, y = self.real * other.real, self.imag * other.imag
        return _Gaussian(x - y, self.real * other.imag + self.imag * other.real)

    def __rmul__(self, factor: int) -> _Gaussian:
        return _Gaussian(factor * self.real, factor * self.imag)

    def conj(self) -> _Gaussian:
        return _Gaussian(self.real, -self.imag)


# The powers of 7 modulo this prime look as if they were drawn by lot.
_PRIME = 2**61 - 1


@lru_cache(maxsize=256)
def _powers(structure: Structure) -> frozenset[int]:
    """The powers of r that the resultant has at all.

    Others cancel for any coefficients; in floating point rounding is left of them, which hides the
    roots near zero, or invents some. Exact integers decide: a polynomial in the coefficients that
    vanishes at numbers of a range so large that were chosen at random is zero, but for a chance of
    its degree over the range (Schwartz, 1980; Zippel, 1979).
    """
    f: list[Polynomial] = [{} for _ in range(structure.degree + 1)]
    for n, (_, k, power) in enumerate(structure.terms):
        number = _Gaussian(pow(7, 20 * n + 31, _PRIME), pow(7, 20 * n + 41, _PRIME))
        f[k][power] = f[k][power] + number if power in f[k] else number
    return frozenset(e for e, x in resultant(f).items() if x)


def relation(structure: Structure, c: NDArray[np.complex128]) -> Polynomial:
    """A real polynomial in r that vanishes at equilibria."""
    f: list[Polynomial] = [{} for _ in range(structure.degree + 1)]
    for i, k, power in structure.terms:
        f[k][power] = f[k][power] + c[:, i] if power in f[k] else np.ascontiguousarray(c[:, i])
    if structure.degree:
        powers = _powers(structure)
        return {e: x for e, x in resultant(f).items() if e in powers}
    if structure.circle:
        return {e: x.real for e, x in f[0].items()}
    # One harmonic alone: real and imaginary part have to vanish together. The first that is not
    # zero throughout is looked at.
    flat = np.all([x.real == 0.0 for x in f[0].values()], axis=0)
    return {e: np.where(flat, x.imag, x.real) for e, x in f[0].items()}


def rows_of(polynomial: Polynomial, count: int) -> tuple[NDArray[np.float64], int]:
    """One row for each point, lowest power first, and the step k: polynomials in r^k."""
    exponents = sorted(polynomial)
    step = gcd(*(e - exponents[0] for e in exponents)) or 1
    table = np.zeros((count, (exponents[-1] - exponents[0]) // step + 1 if exponents else 1))
    for e in exponents:
        table[:, (e - exponents[0]) // step] = polynomial[e]
    return table, step


def harmonics(
    structure: Structure, c: NDArray[np.complex128], r: NDArray[np.float64]
) -> tuple[list[Any], list[Any], list[Any]]:
    """f_k(r), r f_k'(r), and the sums of their terms' absolute values."""
    zero = np.zeros(len(r), dtype=np.complex128)
    value: list[Any] = [zero] * (structure.degree + 1)
    slope, size = list(value), [0.0 * r] * (structure.degree + 1)
    powers = [np.ones_like(r)]  # a power of NumPy's takes as long as a dozen products
    for _ in range(max((p for _, _, p in structure.terms), default=0)):
        powers.append(powers[-1] * r)
    for i, k, p in structure.terms:
        term = c[:, i] * powers[p]
        value[k] = value[k] + term
        if p:
            slope[k] = slope[k] + p * term
        size[k] = size[k] + np.abs(term)
    return value, slope, size
