"""Slow flows of one and two coordinates, as tables of terms written down by hand."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from mmsgen.runtime._flow import Flow

#: of one amplitude: the powers of B, B̄ and |B| in each term
SHAPES = {
    "primary": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (2, 0, 0), (2, 1, 0), (3, 2, 0)],
    "order three": [(0, 0, 0), (0, 1, 0), (1, 0, 0), (2, 0, 0), (2, 1, 0), (3, 2, 0)],
    "three orders": [
        *((0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0), (2, 0, 0)),
        *((2, 1, 0), (2, 2, 0), (3, 1, 0), (3, 2, 0), (4, 3, 0)),
    ],
    "parametric": [(0, 1, 0), (1, 0, 0), (1, 2, 0), (2, 1, 0), (3, 0, 0), (3, 2, 0)],
    "subharmonic": [(0, 2, 0), (1, 0, 0), (2, 1, 0), (3, 2, 0)],
    "not smooth": [(0, 0, 0), (1, 0, 0), (1, 0, 1), (2, 1, 0)],
    "two harmonics": [(0, 1, 0), (0, 4, 0), (1, 0, 0), (2, 1, 0)],
}


def shaped(name: str) -> Flow:
    """The flow of one of `SHAPES`."""
    return Flow(1, tuple((0, e) for e in sorted(SHAPES[name])))


# Of each term its equation, and the exponents of B_1, B̄_1, B_2, B̄_2.
DAMPED = [(0, 1, 0, 0, 0), (1, 0, 0, 1, 0)]
QUADRATIC = [(0, 0, 1, 1, 0), (1, 2, 0, 0, 0)]
CUBIC = [(0, 2, 1, 0, 0), (0, 1, 0, 1, 1), (1, 1, 1, 1, 0), (1, 0, 0, 2, 1)]
ONE_TO_THREE = [*CUBIC, (0, 0, 2, 1, 0), (1, 3, 0, 0, 0)]
ONE_TO_ONE = [(0, 0, 1, 2, 0), (0, 2, 0, 0, 1), (0, 0, 0, 1, 0), (1, 2, 1, 0, 0)]
FORCE_1, FORCE_2 = (0, 0, 0, 0, 0), (1, 0, 0, 0, 0)


def table(terms: Sequence[tuple[int, ...]], symmetries: tuple[tuple[int, ...], ...] = ()) -> Flow:
    """A flow of two amplitudes without moduli."""
    whole = tuple((j, (r, s, 0, p, q, 0)) for j, r, s, p, q in terms)
    return Flow(2, whole, symmetries)


def saturating(
    sigma_1: float, sigma_2: float, force: float, mu_1: float = 0.02, mu_2: float = 0.03
) -> tuple[Flow, np.ndarray]:
    """Nayfeh and Mook (1979), chapter 6: ω_2 = 2ω_1 + σ_1, force of Ω = ω_2 + σ_2 on the second.

    u_1'' + ω_1² u_1 + 2μ_1 u_1' = u_1 u_2 and u_2'' + ω_2² u_2 + 2μ_2 u_2' = u_1² + F cos Ωt with
    ω_1 = 1, ω_2 = 2, in the frame A_1 = B_1 e^{i(σ_1 + σ_2)t/2}, A_2 = B_2 e^{iσ_2 t}.
    """
    c = [
        -mu_1 - 0.5j * (sigma_1 + sigma_2),
        -mu_2 - 1j * sigma_2,
        -0.5j,
        -0.25j,
        -0.125j * force,
    ]
    return table([*DAMPED, *QUADRATIC, FORCE_2]), np.array(c)
