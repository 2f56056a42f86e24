"""The sparse algebra of harmonics: finite sums of monomials in a_j, ā_j and z_m.

Everything that the method of multiple scales produces is a finite sum

    Σ c · Π a_j^{r_j} ā_j^{s_j} · Π z_m^{k_m},   a_j = A_j e^{iω_j T0},  z_m = e^{iΩ_m t},

with coefficients c in a `ParameterField`. A `Series` maps the packed exponent vector to the
coefficient. The frequency of a monomial is its exponent vector applied to the frequencies of
a_j and z_m, each an exact linear form in independent frequency symbols: two monomials resonate
when the forms are equal. No trigonometry and no floating-point comparison takes place.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction

from .field import Coefficient, ParameterField
from .monomials import Packing

__all__ = ["Form", "HarmonicRing", "Series"]

Series = dict[int, Coefficient]
"""Packed monomial → non-zero coefficient; treat it as immutable once made."""

Form = tuple[Fraction, ...]
"""A linear form: the rational coefficient of each basis element, in the order of the basis."""


class HarmonicRing:
    """Series in the amplitudes of n coordinates and m phasors.

    The variables are a_1, ā_1, …, a_n, ā_n, z_1, …, z_m in this order, and then |a_1|, …, |a_n|
    where non-smooth functions need them.

    Parameters
    ----------
    field : ParameterField
        Holds a generator for every frequency symbol in `basis`.
    basis : sequence of str
        Independent frequency symbols; the constant 1 is appended as a last basis element.
    amplitudes : sequence of Form
        Frequency of each a_j.
    phasors : sequence of Form
        Frequency of each z_m; zero for a constant phase.
    moduli : bool
        Whether there are variables |a_j|, of frequency zero.
    """

    def __init__(
        self,
        field: ParameterField,
        basis: Sequence[str],
        amplitudes: Sequence[Form],
        phasors: Sequence[Form],
        moduli: bool = False,
    ) -> None:
        self.field = field
        self.basis = tuple(basis)
        self.n, self.m = len(amplitudes), len(phasors)
        self._last = 2 * self.n + self.m
        self.packing = Packing(self._last + moduli * self.n)
        self.amplitude_frequencies = tuple(amplitudes)
        forms: list[Form] = []
        for form in amplitudes:
            forms += [form, tuple(-c for c in form)]
        still = (Fraction(0),) * (len(self.basis) + 1)
        self._forms = (*forms, *phasors, *([still] * self.n if moduli else []))
        self._frequency: dict[int, Form] = {}
        self._conjugate: dict[int, int] = {}
        self._i_frequency: dict[int, Coefficient] = {}

    # -- monomials -----------------------------------------------------------------------

    def a(self, j: int) -> int:
        """The monomial a_j."""
        return self.packing.unit[2 * j]

    def abar(self, j: int) -> int:
        """The monomial ā_j."""
        return self.packing.unit[2 * j + 1]

    def z(self, exponents: Iterable[int]) -> int:
        """The monomial Π z_m^{k_m}."""
        return self.packing.pack({2 * self.n + m: k for m, k in enumerate(exponents)})

    def modulus(self, j: int) -> int:
        """The monomial |a_j|."""
        return self.packing.unit[self._last + j]

    def phasors(self, key: int) -> tuple[int, ...]:
        """The exponents of z_1, …, z_m."""
        return self.packing.exponents(key)[2 * self.n : self._last]

    def moduli(self, key: int) -> tuple[int, ...]:
        """The exponents of |a_1|, …, |a_n|."""
        return self.packing.exponents(key)[self._last :] or (0,) * self.n

    def frequency(self, key: int) -> Form:
        """The frequency of a monomial as a linear form in the basis."""
        form = self._frequency.get(key)
        if form is None:
            total = [Fraction(0)] * (len(self.basis) + 1)
            for i, e in self.packing.support(key):
                for k, c in enumerate(self._forms[i]):
                    if c:
                        total[k] += e * c
            form = self._frequency[key] = tuple(total)
        return form

    def form_polynomial(self, form: Form):  # type: ignore[no-untyped-def]
        """A linear form as a polynomial of the field."""
        *symbols, constant = form
        return self.field.linear(dict(zip(self.basis, symbols, strict=True)), constant)

    def conjugate_key(self, key: int) -> int:
        """The complex conjugate of a monomial: a_j ↔ ā_j, z_m → 1/z_m, and |a_j| stays."""
        result = self._conjugate.get(key)
        if result is None:
            e = self.packing.exponents(key)
            swapped = [e[i ^ 1] for i in range(2 * self.n)]
            swapped += [-k for k in e[2 * self.n : self._last]]
            result = self._conjugate[key] = self.packing.pack([*swapped, *e[self._last :]])
            self._conjugate[result] = key
        return result

    # -- arithmetic ----------------------------------------------------------------------

    def collect(self, contributions: Iterable[tuple[int, Coefficient]]) -> Series:
        """The sum of single terms, each coefficient brought to canonical form once."""
        bins: dict[int, list[Coefficient]] = {}
        for key, c in contributions:
            if c.num:
                bins.setdefault(key, []).append(c)
        total = self.field.sum
        sums = ((key, total(terms)) for key, terms in bins.items())
        return {key: c for key, c in sums if c.num}

    def add(self, *parts: Series) -> Series:
        """The sum of series."""
        return self.collect(term for part in parts for term in part.items())

    def product_terms(self, f: Series, g: Series) -> Iterable[tuple[int, Coefficient]]:
        """The terms of f·g, uncollected."""
        return ((k + m, c.times(d)) for k, c in f.items() for m, d in g.items())

    def multiply(self, f: Series, g: Series) -> Series:
        """The product of two series."""
        return self.collect(self.product_terms(f, g))

    def scale(self, f: Series, c: Coefficient) -> Series:
        """The product with a coefficient."""
        return {key: d * c for key, d in f.items()} if c else {}

    def conjugate(self, f: Series) -> Series:
        """The complex conjugate."""
        return {self.conjugate_key(key): c.conjugate() for key, c in f.items()}

    # -- derivatives ---------------------------------------------------------------------

    def i_frequency(self, key: int) -> Coefficient:
        """i times the frequency of a monomial."""
        c = self._i_frequency.get(key)
        if c is None:
            form = self.field.polynomial(self.form_polynomial(self.frequency(key)))
            c = self._i_frequency[key] = form.times_i()
        return c

    def d0(self, f: Series) -> Series:
        """D0 f: every monomial times i·(its frequency)."""
        terms = ((key, c * self.i_frequency(key)) for key, c in f.items())
        return {key: c for key, c in terms if c.num}

    def derivation(
        self, f: Series, images: Sequence[Series], rates: Mapping[int, Coefficient]
    ) -> Iterable[tuple[int, Coefficient]]:
        """The terms of D f for the derivation with D a_j = images[j], D z_m = rates[m]·z_m.

        ā_j goes to the conjugate of images[j]. The terms are uncollected. Moduli have no place
        here: they come with the last order, which is not differentiated.
        """
        first = 2 * self.n
        conjugates: dict[int, Series] = {}
        for key, c in f.items():
            for i, e in self.packing.support(key):
                assert i < self._last, "a modulus is not differentiated"
                if i >= first:
                    if i - first in rates:
                        yield key, c.times(rates[i - first]).scale(e)
                    continue
                j, barred = divmod(i, 2)
                image = images[j]
                if barred:
                    if j not in conjugates:
                        conjugates[j] = self.conjugate(image)
                    image = conjugates[j]
                weighted = c if e == 1 else c.scale(e)
                rest = key - self.packing.unit[i]
                for m, d in image.items():
                    yield rest + m, weighted.times(d)
