"""Systems whose certificates are tested, and values for them."""

from __future__ import annotations

from functools import cache

import sympy as sp
from sympy.physics.mechanics import dynamicsymbols
from systems import d, t, x, y

import mmsgen as mg
from mmsgen.scaling import ScaledSystem

omega, omega_1, omega_2, Omega = sp.symbols("omega omega_1 omega_2 Omega", positive=True)
f, f_12, f_21, mu, kappa = sp.symbols("f f_12 f_21 mu kappa", positive=True)
z = dynamicsymbols("z")


def system(left: list[sp.Expr], q: list[sp.Expr], orders: dict[sp.Symbol, int]) -> ScaledSystem:
    symbols = sorted(set().union(*(e.free_symbols for e in left)) - {t}, key=str)
    model = mg.Model.from_equations(left, q, parameters=[mg.Parameter(s) for s in symbols])
    return model.equations_of_motion().scale(orders)


@cache
def mathieu(damping: int = 1) -> ScaledSystem:
    """x'' + 2μx' + (ω² + f cos Ωt)x = 0."""
    left = d(x, 2) + 2 * mu * d(x) + (omega**2 + f * sp.cos(Omega * t)) * x
    return system([left], [x], {f: 1, mu: damping})


@cache
def pair() -> ScaledSystem:
    """Two coordinates, parametric coupling both ways and one frequency of its own modulated."""
    c = 2 * sp.cos(Omega * t)
    left = [
        d(x, 2) + omega_1**2 * x + c * (f * x + f_12 * y),
        d(y, 2) + omega_2**2 * y + c * f_21 * x,
    ]
    return system(left, [x, y], {f: 1, f_12: 1, f_21: 1})


MATHIEU = {"omega": 2.3, "f": 1.9, "mu": 0.07, "sigma": 0.11}
STRONG = {"omega": 2.3, "f": 5.9, "mu": 0.2, "sigma": 0.31}
PAIR = {"omega_1": 1.7, "omega_2": 3.1, "f": 0.83, "f_12": 1.9, "f_21": 1.3, "sigma": 0.13}
COARSE = tuple(0.5 * 2 ** (-k / 2) for k in range(8))
PRINCIPAL, SUM = {Omega: 2 * omega}, {Omega: omega_1 + omega_2}
DIFFERENCE = {Omega: omega_2 - omega_1}
