"""Steady states, for the notebooks: of a slow flow, and of the exact equations beside it.

The periodic motion of the unexpanded equation is found by collocation: its values at equidistant
times are the unknowns, derivatives are those of the trigonometric polynomial through them, and
Newton's method solves the equation at every one of these times. For smooth motions the error falls
faster than any power of the number of points. Nothing of the expansion enters but the first guess.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray
from scipy.optimize import root

from mmsgen import EquationsOfMotion, Expansion
from mmsgen.certify import scaled_values
from mmsgen.motion import reconstruction
from mmsgen.symbols import modulus, phase

STEPS = 12
"""Newton steps at most; five are usual, and wandering finds some other motion."""


_COMPILED: dict[tuple[str, int], tuple[Any, Callable[..., Any]]] = {}
"""Functions by purpose and record; the record is kept, so that its number stays its own."""


def compiled(purpose: str, record: Any, make: Callable[[], Callable[..., Any]]) -> Any:
    """A function made once for a record."""
    key = purpose, id(record)
    if key not in _COMPILED:
        _COMPILED[key] = record, make()
    return _COMPILED[key][1]


def numbers_of(record: Any, values: Mapping[str, float]) -> list[float]:
    """The values of a record's parameters in their order, nan for those that are not given."""
    return [values.get(p.name, np.nan) for p in record.parameters]


def forms(case: Expansion, multiple: int) -> tuple[tuple[sp.Expr, ...], ...]:
    """(p, r, k) for each polar rate, written p sin nγ + r cos nγ + k."""
    (q,) = case.coordinates
    waves = sp.symbols("s c", real=True)
    angle = multiple * phase(q)
    found = []
    for rate in case.slow_flow.polar.values():
        plain = sp.expand(rate).subs({sp.sin(angle): waves[0], sp.cos(angle): waves[1]})
        found.append((*(plain.coeff(w) for w in waves), plain.subs(dict.fromkeys(waves, 0))))
    return tuple(found)


def eliminated(case: Expansion, multiple: int) -> tuple[sp.Expr, sp.Expr]:
    """Sin nγ and cos nγ of a steady state, from da/dt = dγ/dt = 0."""
    (s1, c1, k1), (s2, c2, k2) = forms(case, multiple)
    area = s1 * c2 - s2 * c1
    return (c1 * k2 - c2 * k1) / area, (s2 * k1 - s1 * k2) / area


def response(case: Expansion, multiple: int = 1) -> sp.Expr:
    """What is one in every steady state: sin² nγ + cos² nγ, in amplitude and detuning.

    Parameters
    ----------
    case : Expansion
        One coordinate, its polar slow flow linear in sin nγ and cos nγ.
    multiple : int
        n.
    """
    return sp.cancel(sum(part**2 for part in eliminated(case, multiple)))


def determinant(case: Expansion, multiple: int = 1) -> sp.Expr:
    """The determinant of the polar slow flow's Jacobian at a steady state, in the same."""
    (q,) = case.coordinates
    s, c = eliminated(case, multiple)
    rows = [
        [
            p.diff(modulus(q)) * s + r.diff(modulus(q)) * c + k.diff(modulus(q)),
            multiple * (p * c - r * s),
        ]
        for p, r, k in forms(case, multiple)
    ]
    return sp.cancel(sp.Matrix(rows).det())


def at_numbers(
    case: Expansion, values: Mapping[str, float], detunings: Any, sizes: Any, multiple: int
) -> Any:
    """`forms` and their slopes over the amplitude, at numbers and arrays."""
    (q,), (relation,) = case.coordinates, case.relations

    def make() -> Callable[..., Any]:
        rows = forms(case, multiple)
        slopes = [[e.diff(modulus(q)) for e in row] for row in rows]
        symbols = [p.symbol for p in case.parameters]
        return sp.lambdify([symbols, modulus(q)], [rows, slopes], "numpy", cse=True)

    given = numbers_of(case, {**values, str(relation.detuning): detunings})
    return compiled(f"forms {multiple}", case, make)(given, sizes)


def level(
    case: Expansion, values: Mapping[str, float], detunings: Any, sizes: Any, multiple: int = 1
) -> tuple[Any, Any]:
    """`response` and `determinant` at numbers, over arrays of the detuning and the amplitude."""
    ((s1, c1, k1), (s2, c2, k2)), by_size = at_numbers(case, values, detunings, sizes, multiple)
    area = s1 * c2 - s2 * c1
    s, c = (c1 * k2 - c2 * k1) / area, (s2 * k1 - s1 * k2) / area
    (x1, x2) = (p * s + r * c + k for p, r, k in by_size)
    return s**2 + c**2, multiple * (x1 * (s2 * c - c2 * s) - x2 * (s1 * c - c1 * s))


def on_curve(case: Expansion, values: Mapping[str, float], a: float, multiple: int = 1) -> complex:
    """B of the steady state of amplitude a, at numbers that lie on its response curve."""
    sigma = values[str(case.relations[0].detuning)]
    ((s1, c1, k1), (s2, c2, k2)), _ = at_numbers(case, values, sigma, a, multiple)
    area = s1 * c2 - s2 * c1
    angle = np.arctan2((c1 * k2 - c2 * k1) / area, (s2 * k1 - s1 * k2) / area)
    return complex(a / 2 * np.exp(1j * angle / multiple))


def equilibrium(case: Expansion, values: Mapping[str, float], guess: complex) -> complex:
    """B of a steady state of the slow flow near a guess, at numbers."""

    def make() -> Callable[..., Any]:
        flow = case.slow_flow.cartesian
        symbols = [p.symbol for p in case.parameters]
        return sp.lambdify([list(flow), symbols], list(flow.values()), "numpy", cse=True)

    rates = compiled("rates", case, make)
    given = numbers_of(case, values)
    found = root(rates, [2 * guess.real, 2 * guess.imag], args=(given,), tol=1e-13)
    assert np.abs(found.fun).max() < 1e-10, found.message
    return complex(*found.x) / 2


def collocation(n: int, period: float) -> NDArray[np.float64]:
    """The matrix of d/dt for n values, n odd, of a periodic function."""
    difference = np.subtract.outer(np.arange(n), np.arange(n))
    with np.errstate(divide="ignore"):
        matrix = np.where(difference % 2, -1, 1) / np.sin(np.pi * difference / n)
    np.fill_diagonal(matrix, 0)
    return np.pi / period * matrix


def left_side(eom: EquationsOfMotion, values: Mapping[str, float]) -> Callable[..., Any]:
    """The left side of the equation of one coordinate, with its slopes over u, u' and u''."""

    def make() -> Callable[..., Any]:
        (q,), (equation,), t = eom.coordinates, eom.equations, eom.time
        state = sp.symbols("u v w")
        motions = (q.diff(t, 2), q.diff(t), q)
        plain = equation.subs(dict(zip(motions, reversed(state), strict=True)))
        parts = [plain, *(plain.diff(s) for s in state)]
        return sp.lambdify([[p.symbol for p in eom.parameters], t, *state], parts, "numpy")

    return partial(compiled("left side", eom, make), numbers_of(eom, values))


def periodic_motion(
    eom: EquationsOfMotion,
    values: Mapping[str, float],
    period: float,
    guess: Callable[[NDArray[np.float64]], NDArray[np.float64]],
    points: int = 65,
) -> NDArray[np.float64]:
    """Values over one period of a motion of one coordinate; nan if none is near the guess."""
    function = left_side(eom, values)
    times = period * np.arange(points) / points
    first = collocation(points, period)
    second = first @ first
    u = guess(times)
    for _ in range(STEPS):
        left, *slopes = function(times, u, first @ u, second @ u)
        by_u, by_v, by_w = (np.broadcast_to(s, u.shape)[:, None] for s in slopes)
        step = np.linalg.solve(by_u * np.eye(points) + by_v * first + by_w * second, -left)
        u = u + step
        if np.abs(step).max() < 1e-11 * np.abs(u).max():
            return u
    return np.full(points, np.nan)


def harmonic(motion: NDArray[np.float64], n: int) -> float:
    """The amplitude of the n-th harmonic of a motion over one period."""
    return float(2 * np.abs(np.fft.rfft(motion)[n]) / len(motion))


def exact_amplitude(
    case: Expansion, values: Mapping[str, float], start: complex, periods: int = 1, number: int = 1
) -> float:
    """The amplitude of a harmonic of the exact motion near a steady state, at ε = 1.

    Parameters
    ----------
    case : Expansion
    values : mapping
        Name → number, of the slow flow's parameters and detunings.
    start : complex
        B of the steady state; the motion that the expansion makes of it is the first guess.
    periods : int
        Of the excitation of frequency Ω, in one period of the motion.
    number : int
        The harmonic of that motion that is the fundamental of the coordinate.
    """
    _, exact = scaled_values(case, values, 1.0)
    shape = reconstruction(case, values)

    def guess(times: NDArray[np.float64]) -> NDArray[np.float64]:
        return shape(times, np.full((1, len(times)), start))[0]

    period = 2 * np.pi * periods / exact["Omega"]
    return harmonic(periodic_motion(case.weak.scaled.eom, exact, period, guess), number)


def exact_growth(
    case: Expansion, values: Mapping[str, float], guess: Callable[[Any], Any], points: int = 33
) -> float:
    """The largest growth rate of disturbances of the exact motion of the force's own period.

    The variational equation is solved by collocation too: e^{λt} times a periodic function, the
    exponents λ from the eigenvalues of its companion matrix.

    Parameters
    ----------
    case : Expansion
    values : mapping
        Name → number, of the slow flow's parameters and detunings.
    guess : callable
        Times → values of the periodic motion, roughly.
    points : int
        Over one period.
    """
    eom = case.weak.scaled.eom
    _, exact = scaled_values(case, values, 1.0)
    period = 2 * np.pi / exact["Omega"]
    motion = periodic_motion(eom, exact, period, guess, points)
    function = left_side(eom, exact)
    first, one = collocation(points, period), np.eye(points)
    times = period * np.arange(points) / points
    _, *slopes = function(times, motion, first @ motion, first @ first @ motion)
    stiff, damp, mass = (np.broadcast_to(s, motion.shape)[:, None] for s in slopes)
    # (d/dt + λ)(x, y) = (y, −(stiff x + damp y)/mass) for periodic x and y.
    companion = np.block([[-first, one], [-stiff / mass * one, -damp / mass * one - first]])
    exponents = np.linalg.eigvals(companion)
    inner = exponents[np.abs(exponents.imag) <= 1.01 * np.pi / period]
    return float(inner.real.max())
