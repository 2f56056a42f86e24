"""Growth rates of linear slow flows, and their derivatives where numbers come with slopes.

A root z of P, or an eigenvalue of a matrix, that is simple moves by −∂_pP/P′(z), or by the change
of the matrix between its left and right eigenvectors.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._dual import Dual
from ._runtime import companion_roots, stacked

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["conservative_growth", "growing", "largest", "matrix_growth", "quadratic_growth"]

# Where an eigenvalue's left and right eigenvectors are so nearly perpendicular, it meets another.
PERPENDICULAR = 2.0**-26


def _values(numbers: Sequence[Any]) -> list[Any]:
    """Numbers without their slopes."""
    return [x.value if isinstance(x, Dual) else x for x in numbers]


def _slopes(numbers: Sequence[Any]) -> list[Any]:
    """Slopes, zero where there are none; empty if no number has any."""
    if not any(isinstance(x, Dual) for x in numbers):
        return []
    return [x.slopes if isinstance(x, Dual) else 0.0 for x in numbers]


def _moving(value: Any, slopes: Any) -> Dual:
    """A rate with its slopes, NaN where there are none."""
    known = np.isfinite(slopes) & np.isfinite(value)
    return Dual(value, np.where(known, slopes, np.nan))


def largest(*rates: Any) -> Any:
    """The largest of several growth rates; NaN where one of them is."""
    result = rates[0]
    for rate in rates[1:]:
        pair = _values((result, rate))
        slopes = _slopes((result, rate))
        result = np.maximum(*pair)
        if slopes:
            # Where two rates cross, neither is the derivative of the larger one.
            own = np.where(pair[0] > pair[1], *slopes)
            result = _moving(result, np.where(pair[0] == pair[1], _same(*slopes), own))
    return result


def _same(a: Any, b: Any) -> Any:
    return np.where(np.equal(a, b), a, np.nan)


def growing(discriminant: Any) -> Any:
    """Growth rate of a quadratic whose modes are neutral unless its discriminant is positive."""
    (d,), slopes = _values((discriminant,)), _slopes((discriminant,))
    rate = 0.5 * np.sqrt(np.maximum(d, 0.0))
    rate = np.where(np.isfinite(d), rate, np.nan)
    if not slopes:
        return rate
    return _moving(rate, np.where(d < 0.0, 0.0, slopes[0] / (8.0 * rate)))


def quadratic_growth(b: Any, c: Any) -> Any:
    """Largest real part of the roots of Γ² + bΓ + c."""
    slopes = _slopes((b, c))
    b, c = (np.asarray(x, dtype=np.complex128) for x in _values((b, c)))
    root = np.sqrt(b * b - 4.0 * c)
    # The root of larger modulus by a sum without cancellation, the other from their product.
    root = np.where((b.conj() * root).real < 0.0, -root, root)
    q = -0.5 * (b + root)
    other = np.where(q == 0.0, 0.0, c / np.where(q == 0.0, 1.0, q))
    rate = np.maximum(q.real, other.real)
    rate = np.where(np.isfinite(b) & np.isfinite(c), rate, np.nan)
    if not slopes:
        return rate
    z = np.where(q.real >= other.real, q, other)
    return _moving(rate, (-(z * slopes[0] + slopes[1]) / (2.0 * z + b)).real)


def conservative_growth(*coefficients: Any) -> Any:
    """Largest imaginary part of the roots of a real monic polynomial, lowest power first.

    Real roots come out exactly real from the eigenvalues of a real matrix, so that neutral modes
    give exactly 0.0.
    """
    slopes, values = _slopes(coefficients), _values(coefficients)
    roots = companion_roots(stacked(values))
    rate = np.abs(roots.imag).max(axis=-1)
    if not slopes:
        return rate
    place = np.argmax(np.nan_to_num(roots.imag), axis=-1)
    z = np.take_along_axis(roots, place[..., None], axis=-1)[..., 0]
    whole = [*values, 1.0]
    slope = sum(k * c * z ** (k - 1) for k, c in enumerate(whole) if k)
    moved = (-sum(s * z**k for k, s in enumerate(slopes)) / slope).imag
    return _moving(rate, np.where(rate == 0.0, 0.0, moved))


def matrix_growth(n: int, *entries: Any) -> Any:
    """Largest real part of the eigenvalues of an n × n matrix, its entries row by row."""
    slopes, table = _slopes(entries), stacked(_values(entries))
    matrices = table.reshape(*table.shape[:-1], n, n)
    finite = np.asarray(np.isfinite(table).all(axis=-1))
    plain = np.where(finite[..., None, None], matrices, 0.0)
    if not slopes:
        values = np.linalg.eigvals(plain)
        return np.where(finite, values.real.max(axis=-1), np.nan)
    values, right = np.linalg.eig(plain)
    place = np.argmax(values.real, axis=-1)[..., None]
    rate = np.where(finite, np.take_along_axis(values.real, place, axis=-1)[..., 0], np.nan)
    vector = np.take_along_axis(right, place[..., None], axis=-1)[..., 0]
    left = _left(right, place)
    change = stacked(slopes)
    change = change.reshape(*change.shape[:-1], n, n)
    moved = np.einsum("...i,...ij,...j->...", left, change, vector).real
    skew = 1.0 / np.linalg.norm(left, axis=-1)
    return _moving(rate, np.where(skew > PERPENDICULAR, moved, np.nan))


def _left(right: NDArray[Any], place: NDArray[np.int64]) -> NDArray[np.complex128]:
    """The left eigenvector of one eigenvalue, its product with the right one being one."""
    regular = np.asarray(np.linalg.slogdet(right)[0] != 0.0)
    plain = np.where(regular[..., None, None], right, np.eye(right.shape[-1]))
    left = np.take_along_axis(np.linalg.inv(plain), place[..., None], axis=-2)[..., 0, :]
    return np.where(regular[..., None], left.astype(complex), np.inf)
