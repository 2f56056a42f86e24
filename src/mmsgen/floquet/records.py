"""The records that the Floquet functions return: values, error estimates, verdicts."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from .points import Floats

__all__ = ["Exponents", "GrowthRate", "Monodromy", "Multipliers", "Verdict", "judge"]

Verdicts: TypeAlias = npt.NDArray[np.str_]


class Verdict(StrEnum):
    """What can be said about the stability of a point."""

    STABLE = "stable"
    UNSTABLE = "unstable"
    UNDECIDED = "undecided"


@dataclass(frozen=True, eq=False)
class _Numbers:
    """Values with error estimates that convert to their values."""

    value: Any
    error: Floats

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        """The values alone, for NumPy."""
        return np.array(self.value, dtype=dtype, copy=copy)

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of `value`."""
        return tuple(self.value.shape)


@dataclass(frozen=True, eq=False)
class GrowthRate(_Numbers):
    """Largest real part of the characteristic exponents.

    Parameters
    ----------
    value : numpy.ndarray, batch shape
        Growth rate in s⁻¹.
    error : numpy.ndarray, batch shape
        Estimated error in s⁻¹; inf where the equations were not resolved.
    verdict : numpy.ndarray of str, batch shape
        ``"stable"``, ``"unstable"`` or ``"undecided"``: see `judge`.
    threshold : numpy.ndarray, batch shape
        Growth rate in s⁻¹ below which a point may be called stable.
    """

    verdict: Verdicts
    threshold: Floats

    def __float__(self) -> float:
        """The growth rate of a single point."""
        return float(self.value)


@dataclass(frozen=True, eq=False)
class Monodromy(_Numbers):
    """Monodromy matrices Φ(T): the state (q, dq/dt) after one period.

    Parameters
    ----------
    value : numpy.ndarray, batch shape + (2n, 2n)
        Φ(T), in the units of the coordinates and s.
    error : numpy.ndarray, batch shape + (2n, 2n)
        Estimated error of each entry.
    period : numpy.ndarray, batch shape
        T in s.
    steps : numpy.ndarray of int, batch shape
        Collocation steps per period.
    """

    period: Floats
    steps: npt.NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Multipliers(_Numbers):
    """Characteristic multipliers: the eigenvalues of Φ(T).

    Parameters
    ----------
    value : numpy.ndarray of complex, batch shape + (2n,)
        Sorted by angle in (-π, π], then by modulus.
    error : numpy.ndarray, batch shape + (2n,)
        Radius about each value within which a multiplier of the exact equations lies.
    period : numpy.ndarray, batch shape
        T in s.
    """

    period: Floats


@dataclass(frozen=True, eq=False)
class Exponents(_Numbers):
    """Characteristic exponents λ = ln(multiplier)/T in s⁻¹.

    Parameters
    ----------
    value : numpy.ndarray of complex, batch shape + (2n,)
        Sorted by imaginary part, then by real part. With a period, defined modulo 2πi/T: the
        imaginary parts lie in (-π/T, π/T]. Without one (constant coefficients), the eigenvalues.
    error : numpy.ndarray, batch shape + (2n,)
        Radius about each value; inf for multipliers too small to have a logarithm.
    period : numpy.ndarray or None
        T in s, None when M, C and K are constant.
    """

    period: Floats | None


def judge(
    value: Floats,
    error: Floats,
    resolution: Floats,
    threshold: npt.ArrayLike | None,
) -> tuple[Verdicts, Floats]:
    """Turn growth rates into verdicts.

    With a `threshold` given: unstable if value - error > threshold, stable if
    value + error ≤ threshold, undecided in between.

    Without one, the question "> 0?" has no answer for an undamped system, whose multipliers
    lie on the unit circle: rounding makes ±1e-16 of zero. Then a point is

    - unstable if value - error > 0: growth is certain, however slow;
    - stable if value + error ≤ `resolution`: no growth was found, and none above the resolution
      can have been missed. Stable so means "grows, if at all, more slowly than the resolution";
    - undecided otherwise: where multipliers collide, an error E of the monodromy matrix leaves √E
      in the growth rate, and where the equations were not resolved.

    Parameters
    ----------
    value, error : numpy.ndarray
        Growth rate and its estimated error, s⁻¹.
    resolution : numpy.ndarray
        Growth rate that counts as none, s⁻¹.
    threshold : array_like, optional
        Growth rate from which the user calls a point unstable, s⁻¹.

    Returns
    -------
    verdict : numpy.ndarray of str
        One verdict for each point.
    threshold : numpy.ndarray
        The level used.
    """
    if threshold is None:
        lower, level = np.zeros_like(resolution), resolution
    else:
        level = np.broadcast_to(np.asarray(threshold, dtype=np.float64), value.shape)
        lower = level
    with np.errstate(invalid="ignore"):
        stable = value + error <= level
        unstable = value - error > lower
    verdict = np.full(value.shape, Verdict.UNDECIDED.value, dtype="<U9")
    verdict[stable] = Verdict.STABLE.value
    verdict[unstable] = Verdict.UNSTABLE.value
    return verdict, np.array(level)
