"""Values at ε: those of a slow flow, and those of the exact equations that belong to it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from .errors import CertificateError

if TYPE_CHECKING:
    from .expansion import Expansion

__all__ = ["scaled_values"]

STEPS = 50
"""Newton steps to a resonance at most; from values that are near it, five are usual."""


def scaled_values(
    case: Expansion, values: Mapping[str, float], epsilon: float
) -> tuple[dict[str, float], dict[str, float]]:
    """Values at ε: those of the slow flow's parameters, and those of the exact equations.

    A natural frequency that the program has named follows from the parameters of the equations.
    Where a relation detunes such a one, these parameters are changed by as little as possible, in
    the sum of the squares of their logarithms, so that the relation holds with its detuning.

    Parameters
    ----------
    case : Expansion
    values : mapping
        Name → number at ε = 1.
    epsilon : float

    Raises
    ------
    CertificateError
        If a value is missing, or no parameters near the given ones satisfy a relation.
    """
    scaled = case.weak.scaled
    orders = {str(s.name): order for s, order in scaled.orders}
    sigmas = {str(r.detuning.name) for r in case.relations}
    derived = {p.name for p in scaled.modes.parameters}
    given = {
        name: v * epsilon ** (1 if name in sigmas else orders.get(name, 0))
        for name, v in values.items()
        if name not in derived and name not in case.weak.detuned
    }
    if derived & set(case.weak.detuned):
        given = _on_resonance(case, given, sorted(derived & set(case.weak.detuned)))
    slow = given
    if derived:
        own = {name: v for name, v in given.items() if name not in sigmas}
        follow = {n: float(v) for n, v in scaled.numbers(own).items() if n in derived}
        slow = {**given, **{n: v for n, v in follow.items() if n not in case.weak.detuned}}
    exact = {name: v for name, v in slow.items() if name not in sigmas}
    for name in case.weak.detuned:
        exact[name] = _detuned_value(case, name, slow)
    return slow, exact


def _detuned_value(case: Expansion, name: str, slow: Mapping[str, float]) -> float:
    """A detuned frequency, from those that are left and the detunings."""
    detuned = case.weak.detuned[name]
    parts = {**detuned.resonant, **detuned.detuning}
    missing = [k for k in parts if k != "1" and k not in slow]
    if missing:
        raise CertificateError(f"a value of {missing[0]} is needed to certify {name}")
    return sum(float(c) * (1.0 if k == "1" else slow[k]) for k, c in parts.items())


def _on_resonance(
    case: Expansion, given: Mapping[str, float], pivots: list[str]
) -> dict[str, float]:
    """Parameters at which natural frequencies that have only a name are as the relations say."""
    scaled = case.weak.scaled
    sigmas = {str(r.detuning.name) for r in case.relations}
    small = {str(s.name) for s, order in scaled.orders if order}
    drives = {str(p.base.name) for p in scaled.alphabet.phasors if p.moving and p.base.is_Symbol}
    free = [n for n in given if n not in sigmas | small | drives and given[n] > 0]

    def mismatch(logarithms: np.ndarray) -> np.ndarray:
        table = {**given, **dict(zip(free, np.exp(logarithms), strict=True))}
        numbers = scaled.numbers({n: v for n, v in table.items() if n not in sigmas})
        known = {**table, **{n: float(numbers[n]) for n in numbers}}
        return np.array([known[n] - _detuned_value(case, n, known) for n in pivots])

    x = np.log([given[n] for n in free])
    for _ in range(STEPS):
        gap = mismatch(x)
        step = 1e-6
        jacobian = np.stack(
            [
                (mismatch(x + step * e) - mismatch(x - step * e)) / (2 * step)
                for e in np.eye(len(x))
            ],
            axis=-1,
        )
        change = np.linalg.lstsq(jacobian, -gap, rcond=None)[0]
        x = x + change
        # beyond this the numbers only wander by their rounding
        if np.max(np.abs(change)) < 1e-14 * max(1.0, float(np.max(np.abs(x)))):
            break
    if np.max(np.abs(mismatch(x))) > 1e-12 * max(1.0, float(np.max(np.abs(list(given.values()))))):
        raise CertificateError(
            f"no parameters near the given ones make {', '.join(pivots)} resonant as the relations "
            "say: give values that are nearer"
        )
    return {**given, **dict(zip(free, map(float, np.exp(x)), strict=True))}
