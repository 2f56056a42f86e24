"""The algebra of harmonics: exact identities of its products and derivations."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from mmsgen.field import Coefficient, ParameterField
from mmsgen.series import HarmonicRing, Series

ONE, ZERO = Fraction(1), Fraction(0)


def ring() -> HarmonicRing:
    """Two amplitudes of frequencies u and u + 2v, phasors of frequencies v and 1/2."""
    field = ParameterField(("u", "v", "s", "p"), 12)
    return HarmonicRing(
        field,
        ("u", "v"),
        [(ONE, ZERO, ZERO), (ONE, Fraction(2), ZERO)],
        [(ZERO, ONE, ZERO), (ZERO, ZERO, Fraction(1, 2))],
    )


@st.composite
def many_series(draw: st.DrawFn, count: int) -> tuple[HarmonicRing, list[Series]]:
    """Random series of one ring."""
    r = ring()
    result = []
    for _ in range(count):
        terms: list[tuple[int, Coefficient]] = []
        for _ in range(draw(st.integers(0, 3))):
            exponents = [draw(st.integers(0, 2)) for _ in range(4)]
            exponents += [draw(st.integers(-2, 2)) for _ in range(2)]
            c = r.field.rational(Fraction(draw(st.integers(-4, 4)), draw(st.integers(1, 3))))
            c = r.field.rotate(c * r.field.generator("p"), draw(st.integers(0, 11)))
            if draw(st.booleans()):
                c = c * r.field.reciprocal(r.field.gens["u"] - r.field.gens["v"])
            terms.append((r.packing.pack(exponents), c))
        result.append(r.collect(terms))
    return r, result


def derived(r: HarmonicRing, f: Series, images: list[Series], slow: bool = True) -> Series:
    """D f with D z_1 = i s z_1."""
    rates = {0: r.field.generator("s").times_i()} if slow else {}
    return r.collect(r.derivation(f, images, rates))


def total(r: HarmonicRing, f: Series, images: list[Series]) -> Series:
    """(D0 + D1) f."""
    return r.add(r.d0(f), derived(r, f, images))


@given(many_series(3))
def test_products_form_a_ring(case: tuple[HarmonicRing, list[Series]]) -> None:
    r, (f, g, h) = case
    assert r.multiply(f, g) == r.multiply(g, f)
    assert r.multiply(r.multiply(f, g), h) == r.multiply(f, r.multiply(g, h))
    assert r.multiply(f, r.add(g, h)) == r.add(r.multiply(f, g), r.multiply(f, h))
    assert r.add(f, r.scale(f, r.field.rational(-1))) == {}


@given(many_series(2))
def test_conjugation(case: tuple[HarmonicRing, list[Series]]) -> None:
    r, (f, g) = case
    assert r.conjugate(r.conjugate(f)) == f
    assert r.conjugate(r.multiply(f, g)) == r.multiply(r.conjugate(f), r.conjugate(g))
    assert r.conjugate(r.d0(f)) == r.d0(r.conjugate(f))
    for key in f:
        assert r.frequency(r.conjugate_key(key)) == tuple(-c for c in r.frequency(key))


@given(many_series(2))
def test_d0_is_a_linear_derivation(case: tuple[HarmonicRing, list[Series]]) -> None:
    r, (f, g) = case
    assert r.d0(r.add(f, g)) == r.add(r.d0(f), r.d0(g))
    product = r.add(r.multiply(r.d0(f), g), r.multiply(f, r.d0(g)))
    assert r.d0(r.multiply(f, g)) == product


@given(many_series(4))
def test_slow_derivatives_obey_leibniz(case: tuple[HarmonicRing, list[Series]]) -> None:
    r, (f, g, first, second) = case
    images = [first, second]
    left = derived(r, r.multiply(f, g), images)
    right = r.add(r.multiply(derived(r, f, images), g), r.multiply(f, derived(r, g, images)))
    assert left == right
    assert r.conjugate(derived(r, f, images)) == derived(r, r.conjugate(f), images)


@given(many_series(3))
def test_d0_commutes_with_slow_derivatives(case: tuple[HarmonicRing, list[Series]]) -> None:
    """For images of their amplitude's frequency, as solvability conditions are, D0 D1 = D1 D0.

    With other images the commutator is the derivation by the frequency differences, so that the
    identity is one of the method and not of the code.
    """
    r, (f, first, second) = case
    images = []
    for j, image in enumerate((first, second)):
        omega = r.amplitude_frequencies[j]
        images.append({k: c for k, c in image.items() if r.frequency(k) == omega})
        images[j][r.a(j)] = r.field.generator("p").times_i()
    assert r.d0(derived(r, f, images)) == derived(r, r.d0(f), images)


@given(many_series(3))
def test_commutators_are_derivations(case: tuple[HarmonicRing, list[Series]]) -> None:
    """[D1, D2] is again a derivation: D1 D2 on a product, with every mixed term."""
    r, (f, g, image) = case
    one, two = [image, {r.a(0): r.field.one}], [{r.abar(1): r.field.one}, image]

    def bracket(h: Series) -> Series:
        forth = derived(r, derived(r, h, two, slow=False), one)
        back = derived(r, derived(r, h, one), two, slow=False)
        return r.add(forth, r.scale(back, r.field.rational(-1)))

    left = bracket(r.multiply(f, g))
    assert left == r.add(r.multiply(bracket(f), g), r.multiply(f, bracket(g)))


@given(many_series(1))
def test_frequencies_are_exponents_times_frequencies(
    case: tuple[HarmonicRing, list[Series]],
) -> None:
    r, (f,) = case
    for key in f:
        a, abar, b, bbar, z1, z2 = r.packing.exponents(key)
        u = Fraction(a - abar + b - bbar)
        assert r.frequency(key) == (u, Fraction(2 * (b - bbar) + z1), Fraction(z2, 2))


def test_resonance_is_equality_of_forms() -> None:
    """a_2 has the frequency of a_1 z_1²; a_1 z_1 has not."""
    r = ring()
    assert r.frequency(r.a(1)) == r.frequency(r.a(0) + r.z((2, 0)))
    assert r.frequency(r.a(1)) != r.frequency(r.a(0) + r.z((1, 0)))
    assert r.frequency(r.a(0) + r.abar(0)) == (ZERO, ZERO, ZERO)
    assert r.d0({r.a(0) + r.abar(0): r.field.one}) == {}
