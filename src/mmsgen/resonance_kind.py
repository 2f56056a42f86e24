"""The field's name for a resonance, from the relation and from how its excitation enters."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd

from .series import Form
from .weak import WeakSystem

__all__ = ["kind_of"]


def kind_of(weak: WeakSystem, form: Form, signatures: Sequence[tuple[int, tuple[int, ...]]]) -> str:
    """Name the kind of a resonance.

    Parameters
    ----------
    weak : WeakSystem
    form : Form
        The relation, zero on resonance, over the basis of the ring.
    signatures : sequence of (int, exponents)
        The equation and the monomial of each resonant term.

    Returns
    -------
    str
        Nayfeh and Mook, *Nonlinear Oscillations* (1979), chapters 4 to 6, use these names.
    """
    natural = {name for f in weak.scaled.natural_frequencies for name in f}
    pairs = list(zip((*weak.ring.basis, "1"), form, strict=True))
    step = _numeric_step(weak)
    whole = (form[-1] / step).denominator
    pairs = [(name, whole * (c / step if name == "1" else c)) for name, c in pairs]
    # 2Ω = 1 with a natural frequency of 1/2 is 2Ω = 2ω.
    common = gcd(*(int(c) for _, c in pairs)) or 1
    pairs = [(name, c / common) for name, c in pairs]
    modes = [(name, c) for name, c in pairs if c and name in natural]
    drives = [(name, c) for name, c in pairs if c and name not in natural]
    if not drives:
        return "internal " + ":".join(
            str(abs(c)) for _, c in sorted(modes, key=lambda m: -abs(m[1]))
        )
    if len(drives) > 1:
        return "combination of excitations"
    if not modes:
        return "excitations among themselves"
    multiple = abs(drives[0][1])
    if _free_of_amplitudes(weak, signatures):
        return "primary" if multiple == 1 else f"superharmonic {multiple}"
    if len(modes) == 1:
        (_, c), d = modes[0], drives[0][1]
        if _is_parametric(weak):
            if abs(c) == 2 and multiple == 1:
                return "principal parametric"
            return f"parametric {abs(c)}:{multiple}"
        ratio = f"1/{abs(c)}" if multiple == 1 else f"{multiple}/{abs(c)}"
        return f"subharmonic {ratio}" if abs(c) > abs(d) else f"superharmonic {multiple}"
    signs = {c > 0 for _, c in modes}
    return "sum combination" if len(signs) == 1 else "difference combination"


def _numeric_step(weak: WeakSystem) -> Fraction:
    """What a number in a relation counts in: the numeric natural frequency, if there is just one.

    Otherwise the frequency of a numeric excitation such as cos 2t; 1 where there is neither.
    """
    numeric = {f["1"] for f in weak.scaled.natural_frequencies if set(f) == {"1"}}
    if len(numeric) == 1:
        return Fraction(*numeric.pop().as_integer_ratio())
    steps = (p.step for p in weak.scaled.alphabet.phasors if p.moving and p.base == 1)
    return next(steps, Fraction(1))


def _free_of_amplitudes(
    weak: WeakSystem, signatures: Sequence[tuple[int, tuple[int, ...]]]
) -> bool:
    """True where some resonant term holds no amplitude: it is forced."""
    return any(not any(e[: 2 * weak.ring.n]) for _, e in signatures)


def _is_parametric(weak: WeakSystem) -> bool:
    """True where a phasor multiplies a coordinate in the equations."""
    return any(
        any(key for key in series)
        for force in weak.forces
        for factors, by_order in force.items()
        if factors
        for series in by_order.values()
    )
