"""Non-smooth forces such as q'|q'|, by their exact average along the motion of order zero.

A coordinate that moves with one frequency at order zero has x = 2ρκ cos ψ, with ρ = |A_j|, e^{iψ}
= a_j/ρ and κ = 1 for x = q_j, and e^{iψ} = i a_j/ρ and κ = ω_j for x = q_j'. Then

    x^p sgn x = (2ρκ)^p cos^p ψ sgn(cos ψ) = (ρκ)^p Σ_m c_m e^{imψ},   m ≡ p + 1 mod 2,

    c_m = p! / (Γ(1 + (p + m)/2) Γ(1 + (p − m)/2)),

a rational number over π, by Cauchy's integral for cos^p ψ cos mψ over a quarter turn. There are
infinitely many harmonics, but a resonance condition picks a finite number: all other factors
together are a finite sum, and each of its terms resonates with one m at most. So the solvability
condition of the order at which such a force appears is exact. The particular solution would be an
infinite sum, and the next order with it; both are refused.

References
----------
N. M. Krylov and N. N. Bogoliubov, *Introduction to Nonlinear Mechanics* (1943), on damping by
powers of the velocity; I. S. Gradshteyn and I. M. Ryzhik, *Table of Integrals*, section 3.63, for
the integral.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import factorial
from typing import TYPE_CHECKING

from .errors import ExpansionError, ResonanceError
from .field import Coefficient, ParameterField
from .series import Form, HarmonicRing, Series
from .symbols import coordinate_name

if TYPE_CHECKING:
    from .solver import Solver
    from .weak import WeakSystem

__all__ = ["averaged", "check_enumerable", "check_finite", "harmonic", "not_smooth"]


def not_smooth(shown: str, where: str, order: int) -> ExpansionError:
    """The error for a non-smooth force below the highest order of an expansion."""
    return ExpansionError(
        f"{shown} in the equation of {where} is not smooth: it has infinitely many harmonics, so "
        f"that no expansion goes beyond the order at which it appears, and order {order} does; "
        "ask for the order at which it appears, or scale its parameter higher"
    )


def harmonic(power: int, m: int) -> Fraction:
    """π times the coefficient of e^{imψ} in 2^p cos^p ψ sgn(cos ψ), zero unless m ≡ p + 1 mod 2."""
    if (power + m) % 2 == 0:
        return Fraction(0)
    above, below = _half_gamma(power + m), _half_gamma(power - m)
    return factorial(power) / (above * below)


def _half_gamma(k: int) -> Fraction:
    """Γ(1 + k/2)/√π for an odd k."""
    value = Fraction(1)
    while k > 0:
        value, k = value * Fraction(k, 2), k - 2
    while k < -1:
        k += 2
        value = value / Fraction(k, 2)
    return value


def averaged(
    solver: Solver, j: int, factors: tuple[int, ...], coefficient: Series
) -> Iterator[tuple[int, Coefficient]]:
    """The terms of a non-smooth force of equation j that resonate there, uncollected.

    Parameters
    ----------
    solver : Solver
        Solved at order zero.
    j : int
    factors : tuple of int
        As in `weak.Factors`; the last ones are signs.
    coefficient : Series
        In the phasors.

    Raises
    ------
    ExpansionError
        If signs of several quantities are multiplied, or the coordinate does not move with one
        frequency at order zero.
    """
    if not coefficient:
        return
    i, derivative, power, rest = _parts(solver, j, factors)
    ring = solver.ring
    own, target = ring.amplitude_frequencies[i], ring.amplitude_frequencies[j]
    others = ring.multiply(coefficient, solver.product(rest, 0))
    for key, c in others.items():
        m = _multiple(target, ring.frequency(key), own)
        number = Fraction(0) if m is None else harmonic(power, m)
        if m is None or not number:
            continue
        size = _size(ring, own, derivative, power).scale(number).times_i(derivative * m)
        yield _canonical(ring, key + _turned(ring, i, power, m)), c * size


def check_finite(weak: WeakSystem, what: str) -> None:
    """Refuse what would be an infinite sum: all that is known at the highest order.

    Raises
    ------
    ExpansionError
        If some equation holds a non-smooth force.
    """
    for q, forces in zip(weak.scaled.coordinates, weak.forces, strict=True):
        if any(factors and factors[-1] >= 3 * weak.ring.n for factors in forces):
            raise ExpansionError(
                f"{what} at order {weak.order} is an infinite sum, as a force in the equation of "
                f"{coordinate_name(q)} is not smooth and has infinitely many harmonics; of these "
                "only the ones that resonate are known, see secular_terms"
            )


def check_enumerable(solver: Solver) -> None:
    """Refuse to list infinitely many resonances.

    Raises
    ------
    ResonanceError
        If the overtones of a non-smooth force can meet other frequencies.
    """
    ring = solver.ring
    for j, forces in enumerate(solver.weak.forces):
        for factors, by_order in forces.items():
            if not factors or factors[-1] < 3 * ring.n:
                continue
            i, _, _, rest = _parts(solver, j, factors)
            own, target = ring.amplitude_frequencies[i], ring.amplitude_frequencies[j]
            for coefficient in by_order.values():
                for key in ring.multiply(coefficient, solver.product(rest, 0)):
                    if _ratio(target, own) is None or _ratio(ring.frequency(key), own) is None:
                        names = [coordinate_name(q) for q in solver.weak.scaled.coordinates]
                        raise ResonanceError(
                            f"a non-smooth function of {names[i]} in the equation of {names[j]} "
                            "has infinitely many harmonics, and each gives a resonance: they "
                            "cannot be listed; give the relations to expand"
                        )


def _parts(
    solver: Solver, j: int, factors: tuple[int, ...]
) -> tuple[int, int, int, tuple[int, ...]]:
    """Coordinate, derivative, power p of x^p sgn x, and the remaining factors."""
    n, names = solver.n, [coordinate_name(q) for q in solver.weak.scaled.eom.coordinates]
    signs = [f for f in factors if f >= 3 * n]
    derivative, i = divmod(signs[0] - 3 * n, n)
    where = f"a force in the equation of {names[j]} is not smooth in {names[i]}" + "'" * derivative
    if len(signs) > 1:
        second = names[(signs[1] - 3 * n) % n]
        raise ExpansionError(
            f"{where} and in {second} at once: averages are known of one such factor"
        )
    ring = solver.ring
    if solver.modal is not None or set(solver.q[0][i]) != {ring.a(i), ring.abar(i)}:
        reason = "forced" if solver.modal is None else "coupled to others"
        raise ExpansionError(
            f"{where}, which does not move with one frequency at order zero, as it is {reason} "
            "there: the average is known for one frequency only"
        )
    own = derivative * n + i
    rest = tuple(f for f in factors if f < 3 * n and f != own)
    return i, derivative, factors.count(own), rest


def _ratio(form: Form, own: Form) -> Fraction | None:
    """The number m with form = m·own; None where there is none."""
    place = next(k for k, c in enumerate(own) if c)
    m = form[place] / own[place]
    return m if all(f == m * c for f, c in zip(form, own, strict=True)) else None


def _multiple(target: Form, frequency: Form, own: Form) -> int | None:
    """The whole number m with frequency + m·own = target; None where there is none."""
    m = _ratio(tuple(a - b for a, b in zip(target, frequency, strict=True)), own)
    return None if m is None or m.denominator != 1 else int(m)


def _size(ring: HarmonicRing, own: Form, derivative: int, power: int) -> Coefficient:
    """κ^p/π."""
    field: ParameterField = ring.field
    over_pi = field.reciprocal(field.gens["<pi>"])
    if not derivative:
        return over_pi
    omega: Coefficient = field.polynomial(ring.form_polynomial(own))
    return over_pi * omega**power


def _turned(ring: HarmonicRing, i: int, power: int, m: int) -> int:
    """ρ^p e^{imψ}, but for the power of i, as a monomial."""
    phase = ring.a(i) * m if m >= 0 else ring.abar(i) * -m
    return phase + ring.modulus(i) * (power - abs(m))


def _canonical(ring: HarmonicRing, key: int) -> int:
    """A monomial with aā written as |a|² where a modulus stands beside it."""
    exponents = ring.packing.exponents(key)
    for i, t in enumerate(ring.moduli(key)):
        common = min(exponents[2 * i], exponents[2 * i + 1]) if t else 0
        key += common * (2 * ring.modulus(i) - ring.a(i) - ring.abar(i))
    return key
