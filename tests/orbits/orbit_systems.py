"""Equations of motion for the tests of periodic orbits, written down by hand."""

from __future__ import annotations

import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg

t = dynamicsymbols._t
u, w = dynamicsymbols("u w")
mu, alpha, K, Omega, f = sp.symbols("mu alpha K Omega f", real=True)


def equations(left: list[sp.Expr], coordinates: list[sp.Expr]) -> mg.EquationsOfMotion:
    """Equations of motion whose parameters are all symbols that occur, by name."""
    found = set().union(*(e.free_symbols for e in left)) - {t}
    parameters = tuple(mg.Parameter(s) for s in sorted(found, key=str))
    return mg.EquationsOfMotion(tuple(left), tuple(coordinates), parameters)


def duffing() -> mg.EquationsOfMotion:
    """u'' + 2μu' + u + αu³ = K cos Ωt."""
    return equations(
        [u.diff(t, 2) + 2 * mu * u.diff(t) + u + alpha * u**3 - K * sp.cos(Omega * t)], [u]
    )


def free_duffing() -> mg.EquationsOfMotion:
    """u'' + u + αu³ = 0."""
    return equations([u.diff(t, 2) + u + alpha * u**3], [u])


def van_der_pol() -> mg.EquationsOfMotion:
    """u'' − μ(1 − u²)u' + u = 0."""
    return equations([u.diff(t, 2) - mu * (1 - u**2) * u.diff(t) + u], [u])


def mathieu_duffing() -> mg.EquationsOfMotion:
    """u'' + 2μu' + (1 + 2f cos Ωt)u + αu³ = 0."""
    stiffness = 1 + 2 * f * sp.cos(Omega * t)
    return equations([u.diff(t, 2) + 2 * mu * u.diff(t) + stiffness * u + alpha * u**3], [u])


def pendulum_on_cart() -> mg.EquationsOfMotion:
    """A damped cart on a spring, driven, with a damped pendulum: its mass matrix moves."""
    ratio = sp.Rational(1, 2)
    return equations(
        [
            u.diff(t, 2) + ratio * (w.diff(t, 2) * sp.cos(w) - w.diff(t) ** 2 * sp.sin(w))
            + 2 * mu * u.diff(t) + u - K * sp.cos(Omega * t),
            w.diff(t, 2) + u.diff(t, 2) * sp.cos(w) + 2 * mu * w.diff(t) + 3 * sp.sin(w),
        ],
        [u, w],
    )  # fmt: skip
