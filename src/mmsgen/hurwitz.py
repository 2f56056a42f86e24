"""Where all roots of a polynomial lie in a half-plane, or on a line: exact inequalities.

With Γ = iz a monic P(Γ) becomes Q(z) = U(z) + iV(z), U and V real. All roots Γ have negative real
parts exactly where the Bezoutian of V and U,

    Σ B_jk x^j y^k = (V(x)U(y) − U(x)V(y))/(x − y),

is positive definite (Hermite 1856), that is where its n nested minors D_1 … D_n are positive: they
are the determinants of Bilharz (1944). D_1 is the damping on the whole, and D_n vanishes where a
root crosses the axis. Where P itself is real, half of the conditions are enough, those of Liénard
and Chipart (1914). With no damping, V = 0, all Γ are imaginary and distinct exactly where the
Bezoutian of −U' and U is positive definite; its minors are the subdiscriminants. Where P is even,
P(Γ) = R(Γ²), they are of half the degree: the roots of R are real and distinct exactly where its
own subdiscriminants are positive, and then negative exactly where its coefficients are positive.
The subdiscriminants of P itself would have common factors.

Source: F. R. Gantmacher, *The Theory of Matrices* (1959), chapter on the Routh–Hurwitz problem;
M. G. Krein and M. A. Naimark (1936), "The method of symmetric and Hermitian forms".
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from .field import Coefficient

__all__ = ["damped_conditions", "halves", "is_even", "neutral_conditions"]


def halves(
    coefficients: Sequence[Coefficient],
) -> tuple[tuple[Coefficient, ...], tuple[Coefficient, ...]]:
    """U and V of a monic polynomial in Γ, lowest power first; V has one coefficient less."""
    n = len(coefficients) - 1
    turned = [c.times_i(k - n) for k, c in enumerate(coefficients)]
    half = Fraction(1, 2)
    u = tuple((c + c.conjugate()).scale(half) for c in turned)
    v = tuple((c - c.conjugate()).times_i(-1).scale(half) for c in turned[:-1])
    return u, v


def damped_conditions(coefficients: Sequence[Coefficient]) -> tuple[Coefficient, ...]:
    """What is positive exactly where all roots Γ have negative real parts.

    Parameters
    ----------
    coefficients : sequence of Coefficient
        Of Γ^k at index k; the last is 1.

    Returns
    -------
    tuple of Coefficient
        The last one vanishes where a pair of roots crosses the imaginary axis; for a real
        polynomial the first one where a single root does so.
    """
    if all(not (c - c.conjugate()) for c in coefficients):
        return _lienard_chipart(coefficients)
    u, v = halves(coefficients)
    return _minors(_bezoutian(v, u))


def neutral_conditions(coefficients: Sequence[Coefficient]) -> tuple[Coefficient, ...]:
    """What is positive exactly where all roots Γ are imaginary and distinct, if V is zero.

    Returns
    -------
    tuple of Coefficient
        The last one is the discriminant of U, of R where P is even. For a cubic it is the only one:
        with two roots that are complex it is negative.
    """
    if is_even(coefficients):
        halved = coefficients[::2]
        return (*halved[:-1], *_real_conditions(halved))
    return _real_conditions(halves(coefficients)[0])


def is_even(coefficients: Sequence[Coefficient]) -> bool:
    """Whether a polynomial of degree two and more holds even powers only."""
    return len(coefficients) > 2 and not any(coefficients[1::2]) and len(coefficients) % 2 == 1


def _real_conditions(u: Sequence[Coefficient]) -> tuple[Coefficient, ...]:
    """What is positive exactly where all roots of a real polynomial are real and distinct."""
    if len(u) == 2:
        return ()
    slope = tuple(c.scale(Fraction(-k)) for k, c in enumerate(u))[1:]
    minors = _minors(_bezoutian(slope, u))
    return minors[1:] if len(minors) > 3 else minors[-1:]


def _bezoutian(f: Sequence[Coefficient], g: Sequence[Coefficient]) -> list[list[Coefficient]]:
    """The matrix of (f(x)g(y) − f(y)g(x))/(x − y), g being of a higher degree than f."""
    n, field = len(g) - 1, g[0].field
    f = [*f, *(field.zero for _ in range(n + 1 - len(f)))]
    rows = [[field.zero] * n for _ in range(n)]
    for i in range(n):
        for j in range(i, n):
            terms = []
            for k in range(min(i, n - 1 - j) + 1):
                terms.append(f[j + k + 1].times(g[i - k]))
                terms.append(f[i - k].times(g[j + k + 1]).scale(Fraction(-1)))
            rows[i][j] = rows[j][i] = field.sum(terms)
    return rows


def _minors(rows: Sequence[Sequence[Coefficient]]) -> tuple[Coefficient, ...]:
    """The determinants of the last k rows and columns, k = 1 … n, without any division."""
    n, field = len(rows), rows[0][0].field
    known: dict[tuple[int, ...], Coefficient] = {(): field.one}
    found = []
    for k in range(1, n + 1):
        row, larger = rows[n - k], {}
        for columns in {tuple(sorted((c, *s))) for s in known for c in range(n) if c not in s}:
            # Along the uppermost of the last k rows.
            terms = []
            for place, c in enumerate(columns):
                rest = columns[:place] + columns[place + 1 :]
                terms.append(row[c].times(known[rest]).scale(Fraction((-1) ** place)))
            larger[columns] = field.sum(terms)
        known = larger
        found.append(known[tuple(range(n - k, n))])
    return tuple(found)


def _lienard_chipart(coefficients: Sequence[Coefficient]) -> tuple[Coefficient, ...]:
    """P(0), every second coefficient from there on, every second Hurwitz determinant."""
    n, field = len(coefficients) - 1, coefficients[0].field
    a = dict(enumerate(reversed(coefficients)))
    # Rows and columns backwards, so that the leading minors are those of the last rows.
    matrix = [[a.get(2 * j - i, field.zero) for j in range(n, 0, -1)] for i in range(n, 0, -1)]
    determinants = _minors(matrix)
    chosen = tuple(d for k, d in enumerate(determinants[: n - 1], 1) if (n - 1 - k) % 2 == 0)
    return (*coefficients[0:n:2], *chosen)
