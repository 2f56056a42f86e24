"""Results in the conventions of others, so that a printed formula can be compared.

What comes out here (q = A e^{iωt} + c.c. + …, A the whole fundamental harmonic, Ω = Ω_res + εσ)
goes over into other definitions of amplitude, frequency and detuning by substitutions that are
exact and truncated at the order of the result. A slow flow is {p: {A: D_p A}}, as
`Expansion.solvability` is; a series is {p: coefficient of ε^p}. Every symbol but the amplitudes is
real, and a detuning counts as of the first order, as do the turns e^{iσt}.

Source: Nayfeh, *Perturbation Methods* (1973), chapters 2 and 6, on near-identity transformations,
expansions of frequencies and reversion of series; Kevorkian and Cole, *Multiple Scale and Singular
Perturbation Methods* (1996), chapter 4, on the freedom in the homogeneous parts.
"""

from __future__ import annotations

from .changes import (
    Change,
    Flow,
    autonomous,
    changed,
    first_order_variables,
    followed_by,
    inverse,
    rescaled,
)
from .detunings import detuned, substituted
from .graded import Graded
from .motions import displacement, frequency, power, reversion

__all__ = [
    "Change",
    "Flow",
    "Graded",
    "autonomous",
    "changed",
    "detuned",
    "displacement",
    "first_order_variables",
    "followed_by",
    "frequency",
    "inverse",
    "power",
    "rescaled",
    "reversion",
    "substituted",
]
