"""Names: ε, the time scales, amplitudes, detunings. The one place that makes them."""

from __future__ import annotations

import sympy as sp

__all__ = [
    "amplitude",
    "coordinate_name",
    "detuning",
    "epsilon",
    "imaginary_part",
    "modal_coordinate",
    "mode_frequency",
    "modulus",
    "phase",
    "real_part",
    "shape",
    "time_scale",
]

epsilon = sp.Symbol("epsilon", positive=True)
"""The bookkeeping parameter ε. It marks orders in displays; results are written at ε = 1."""


def time_scale(p: int) -> sp.Symbol:
    """T_p = ε^p t."""
    return sp.Symbol(f"T_{p}", real=True)


def coordinate_name(q: sp.Expr) -> str:
    """The name of a coordinate q(t), without its argument."""
    return str(q.func.__name__) if q.args else str(q)


def amplitude(q: sp.Expr) -> sp.Symbol:
    """The complex amplitude A_q of the fundamental of q = A_q e^{iωt} + c.c. + …."""
    return sp.Symbol(f"A_{coordinate_name(q)}", complex=True)


def modulus(q: sp.Expr) -> sp.Symbol:
    """The real amplitude a_q in A_q = (a_q/2) e^{iβ_q}."""
    return sp.Symbol(f"a_{coordinate_name(q)}", nonnegative=True)


def phase(q: sp.Expr) -> sp.Symbol:
    """The slow phase of q in the frame that makes the slow flow autonomous."""
    return sp.Symbol(f"gamma_{coordinate_name(q)}", real=True)


def real_part(q: sp.Expr) -> sp.Symbol:
    """u_q in A_q = (u_q + i v_q)/2, in the frame that makes the slow flow autonomous."""
    return sp.Symbol(f"u_{coordinate_name(q)}", real=True)


def imaginary_part(q: sp.Expr) -> sp.Symbol:
    """v_q in A_q = (u_q + i v_q)/2, in the frame that makes the slow flow autonomous."""
    return sp.Symbol(f"v_{coordinate_name(q)}", real=True)


def detuning(index: int, total: int) -> sp.Symbol:
    """σ for a single relation, σ_1, σ_2, … for several."""
    return sp.Symbol("sigma" if total == 1 else f"sigma_{index + 1}", real=True)


def modal_coordinate(name: str, q: sp.Expr) -> sp.Expr:
    """A modal coordinate, a function of the same time as q."""
    return sp.Function(name, real=True)(*q.args)


def mode_frequency(name: str) -> sp.Symbol:
    """A natural frequency that the program names."""
    return sp.Symbol(name, positive=True)


def shape(name: str) -> sp.Symbol:
    """A component of a mode shape."""
    return sp.Symbol(name, real=True)
