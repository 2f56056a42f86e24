"""Roots of unity: i and every static phase 2πk/n as exact elements of one cyclotomic field.

ζ = e^{2πi/n} with n a multiple of 4, so that i = ζ^{n/4}. Elements are integer combinations of
1, ζ, …, ζ^{φ(n)−1}; a power beyond φ(n) − 1 is reduced by the n-th cyclotomic polynomial.

References
----------
L. C. Washington, *Introduction to Cyclotomic Fields* (1997), chapters 1 and 2 (the power basis);
K. Ireland and M. Rosen, *A Classical Introduction to Modern Number Theory* (1990), chapter 6
(square roots as Gauss sums).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from math import gcd

import flint

__all__ = ["Cyclotomic", "cyclotomic", "gauss_sum"]

Combination = tuple[tuple[int, int], ...]
"""Pairs (power of ζ, integer coefficient), powers ascending, coefficients non-zero."""


@dataclass(frozen=True)
class Cyclotomic:
    """The field ℚ(ζ) of the n-th roots of unity.

    Attributes
    ----------
    n : int
        Order of ζ, a multiple of 4.
    degree : int
        φ(n), the number of basis powers.
    powers : tuple
        ``powers[k]`` is ζ^k in the basis, for 0 ≤ k < n.
    """

    n: int
    degree: int
    powers: tuple[Combination, ...]

    @property
    def i(self) -> int:
        """The power of ζ that is the imaginary unit."""
        return self.n // 4

    def power(self, k: int) -> Combination:
        """ζ^k in the basis, for any integer k."""
        return self.powers[k % self.n]

    def units(self) -> tuple[int, ...]:
        """The exponents a of the Galois group ζ → ζ^a."""
        return tuple(a for a in range(1, self.n) if gcd(a, self.n) == 1)


@cache
def cyclotomic(n: int) -> Cyclotomic:
    """The field of the n-th roots of unity.

    Parameters
    ----------
    n : int
        Order, a positive multiple of 4.

    Raises
    ------
    ValueError
        If `n` is not a positive multiple of 4.
    """
    if n <= 0 or n % 4:
        raise ValueError(f"the order of the roots of unity must be a multiple of 4, got {n}")
    polynomial = flint.fmpz_poly.cyclotomic(n)
    degree = polynomial.degree()
    powers = []
    current = flint.fmpz_poly([1])
    zeta = flint.fmpz_poly([0, 1])
    for _ in range(n):
        powers.append(tuple((k, int(c)) for k, c in enumerate(current.coeffs()) if c != 0))
        current = (current * zeta) % polynomial
    return Cyclotomic(n, degree, tuple(powers))


def gauss_sum(radicand: int) -> tuple[int, dict[int, int]]:
    """√radicand as a combination of roots of unity.

    Parameters
    ----------
    radicand : int
        A square-free integer greater than 1.

    Returns
    -------
    n : int
        Order of the roots of unity used, a multiple of 4.
    terms : dict
        √radicand = Σ terms[k] e^{2πik/n}.
    """
    n, terms = 4, {0: 1}
    for prime, _ in flint.fmpz(radicand).factor():
        p = int(prime)
        order, factor = (8, {1: 1, 7: 1}) if p == 2 else _odd_prime_root(p)
        common = n * order // gcd(n, order)
        product: dict[int, int] = {}
        for k, c in terms.items():
            for m, d in factor.items():
                power = (k * (common // n) + m * (common // order)) % common
                product[power] = product.get(power, 0) + c * d
        n, terms = common, product
    return n, {k: c for k, c in sorted(terms.items()) if c}


def _odd_prime_root(p: int) -> tuple[int, dict[int, int]]:
    """√p from the quadratic Gauss sum, which is √p for p = 1 and i√p for p = 3 modulo 4."""
    n = 4 * p
    turn = 0 if p % 4 == 1 else 3 * p  # e^{2πi·3p/4p} = −i
    return n, {(4 * a + turn) % n: 1 if pow(a, (p - 1) // 2, p) == 1 else -1 for a in range(1, p)}
