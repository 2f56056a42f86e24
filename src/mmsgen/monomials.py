"""Exponent vectors packed into one integer: adding two integers multiplies two monomials.

A monomial Π v_i^{e_i} with signed exponents is held as Σ e_i B^i. The sum is unique as long as
every |e_i| < B/2, which `Packing` guarantees by refusing larger exponents.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

__all__ = ["Packing"]

_BITS = 20
_BASE = 1 << _BITS
_HALF = _BASE >> 1


class Packing:
    """Monomials in a fixed number of variables, as integers.

    Parameters
    ----------
    size : int
        Number of variables.
    """

    def __init__(self, size: int) -> None:
        self.size = size
        self.unit = tuple(1 << (_BITS * i) for i in range(size))
        self._exponents: dict[int, tuple[int, ...]] = {0: (0,) * size}

    def pack(self, exponents: Sequence[int] | Mapping[int, int]) -> int:
        """The integer of an exponent vector, or of a mapping variable index → exponent.

        Raises
        ------
        OverflowError
            If an exponent is too large to be packed uniquely.
        """
        pairs = exponents.items() if isinstance(exponents, Mapping) else enumerate(exponents)
        key = 0
        for i, e in pairs:
            if abs(e) >= _HALF // 2:
                raise OverflowError(f"the exponent {e} of variable {i} is beyond {_HALF // 2}")
            key += e << (_BITS * i)
        return key

    def exponents(self, key: int) -> tuple[int, ...]:
        """The exponent vector of an integer."""
        vector = self._exponents.get(key)
        if vector is None:
            rest, digits = key, []
            for _ in range(self.size):
                digit = rest & (_BASE - 1)
                if digit >= _HALF:
                    digit -= _BASE
                digits.append(digit)
                rest = (rest - digit) >> _BITS
            vector = self._exponents[key] = tuple(digits)
        return vector

    def support(self, key: int) -> tuple[tuple[int, int], ...]:
        """Pairs (variable index, non-zero exponent)."""
        return tuple((i, e) for i, e in enumerate(self.exponents(key)) if e)
