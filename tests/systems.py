"""Oscillators that several tests share, and exact comparison of expressions."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

from mmsgen.equations import EquationsOfMotion
from mmsgen.parameters import Parameter
from mmsgen.scaling import ScaledSystem
from mmsgen.symbols import amplitude

t = dynamicsymbols._t
x, y, z, w = dynamicsymbols("x y z w")
A, B = amplitude(x), amplitude(y)
Ac, Bc = sp.conjugate(A), sp.conjugate(B)
omega, omega_1, omega_2, omega_3, Omega, Omega_2 = sp.symbols(
    "omega omega_1 omega_2 omega_3 Omega Omega_2", positive=True
)
alpha, beta, kappa, mu, f, k, p = sp.symbols("alpha beta kappa mu f k p", positive=True)
theta = sp.Symbol("theta", real=True)
sigma, sigma_1, sigma_2 = sp.symbols("sigma sigma_1 sigma_2", real=True)


def d(q: sp.Expr, order: int = 1) -> sp.Expr:
    """A time derivative."""
    return q.diff(t, order)


def equations(left_sides: Sequence[sp.Expr], coordinates: Sequence[sp.Expr]) -> EquationsOfMotion:
    """Equations of motion whose parameters are all symbols that occur, by name."""
    found = set().union(*(sp.sympify(e).free_symbols for e in left_sides)) - {t}
    parameters = tuple(Parameter(s) for s in sorted(found, key=str))
    return EquationsOfMotion(tuple(left_sides), tuple(coordinates), parameters)


def oscillator(terms: sp.Expr, frequency: sp.Expr = omega) -> EquationsOfMotion:
    """One coordinate: x'' + ω²x + terms = 0."""
    return equations([d(x, 2) + frequency**2 * x + terms], [x])


def pair(in_x: sp.Expr, in_y: sp.Expr) -> EquationsOfMotion:
    """Two coordinates of frequencies ω_1 and ω_2 with further terms."""
    return equations([d(x, 2) + omega_1**2 * x + in_x, d(y, 2) + omega_2**2 * y + in_y], [x, y])


def duffing() -> ScaledSystem:
    """x'' + ω²x + εα x³ = 0."""
    return oscillator(alpha * x**3).scale({alpha: 1})


def van_der_pol() -> ScaledSystem:
    """x'' + x − εμ(1 − x²)x' = 0."""
    return oscillator(-mu * (1 - x**2) * d(x), sp.Integer(1)).scale({mu: 1})


def mathieu() -> ScaledSystem:
    """x'' + (ω² + 2εα cos Ωt)x = 0."""
    return oscillator(2 * alpha * sp.cos(Omega * t) * x).scale({alpha: 1})


def coupled_mathieu() -> ScaledSystem:
    """Two coordinates with parametric coupling f_12, f_21 (Nayfeh and Mook, chapter 5)."""
    f12, f21 = sp.symbols("f_12 f_21", positive=True)
    c = 2 * sp.cos(Omega * t)
    return pair(c * f12 * y, c * f21 * x).scale({f12: 1, f21: 1})


def linear_rotor(n: int) -> EquationsOfMotion:
    """A rotor of n blades on a support, linear, in ratios, at the blades' frequency at speed.

    Written down by hand from section 4.1 of Sanches et al. (2014), doi
    10.1016/j.ijnonlinmec.2014.04.003, not taken from the model that the derivations use.
    """
    r_m, r_b, w_x, w_y, w_phi = sp.symbols("r_m r_b omega_x omega_y omega_phi", positive=True)
    blades = [dynamicsymbols(f"phi_{j + 1}") for j in range(n)]
    azimuths = [Omega * t + 2 * sp.pi * sp.Rational(j, n) for j in range(n)]
    pairs = list(zip(blades, azimuths, strict=True))
    lateral = sum((q * sp.sin(v)).diff(t, 2) for q, v in pairs)
    forward = sum((q * sp.cos(v)).diff(t, 2) for q, v in pairs)
    left = [
        d(x, 2) + w_x**2 * x - r_m * lateral,
        d(y, 2) + w_y**2 * y + r_m * forward,
        *(
            d(q, 2) + w_phi**2 * q + r_b * (sp.cos(v) * d(y, 2) - sp.sin(v) * d(x, 2))
            for q, v in pairs
        ),
    ]
    return equations(left, [x, y, *blades])


def same(left: sp.Expr, right: sp.Expr) -> bool:
    """Exact equality of two rational expressions in symbols, conjugates and exponentials."""
    return bool(sp.cancel(sp.together(sp.expand(left - right))) == 0)
