"""The systems that mmsgen and oscilate are both given, in SymPy alone.

They are those of the examples in oscilate's documentation: equations and orders, written anew.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

t = sp.Symbol("t")
x, y = (sp.Function(name, real=True)(t) for name in ("x", "y"))
dx, dy, ddx, ddy = x.diff(t), y.diff(t), x.diff(t, 2), y.diff(t, 2)

omega_0, omega_1, F, c, c_0, c_1, mu, mu_0, mu_1 = sp.symbols(
    "omega_0 omega_1 F c c_0 c_1 mu mu_0 mu_1", positive=True
)
gamma, gamma_0, gamma_1, gamma_01, gamma_3, gamma_5, gamma_7 = sp.symbols(
    "gamma gamma_0 gamma_1 gamma_01 gamma_3 gamma_5 gamma_7", real=True
)
delta, sigma = sp.symbols("delta sigma", real=True)
eta_0, eta_1 = sp.symbols("eta_0 eta_1", real=True)


@dataclass(frozen=True)
class System:
    """Equations = forcing · force · cos Ωt, with Ω = ratio · reference + σ, σ of order 1.

    Attributes
    ----------
    equations : sequence of sympy.Expr
        Left-hand sides, one for each coordinate x, y.
    order : int
        Highest power of ε in the slow flow.
    small : mapping
        Parameter → its order in ε.
    forcing, force : sympy.Expr
        What multiplies cos Ωt.
    reference : sympy.Expr
        The frequency that all others are referred to.
    ratio : Rational
        Excitation frequency over the reference.
    natural : sequence of sympy.Symbol
        Natural frequencies.
    ratios, detunings : sequences
        Natural frequency = ratio · reference + detuning.
    amplitude : int
        Order of the coordinates.
    damping : sequence of sympy.Symbol
        What is left out for the backbone curve.
    driven : int
        The coordinate whose response is looked for, the others at rest.
    complex_form : bool
        For oscilate: the equations as complex ones of first order.
    motion : bool
        Whether the example writes out the motion to all orders, or the leading one alone.
    solve, stability
        What the example does with the slow flow, and oscilate's options for the last of it.
    """

    equations: Sequence[sp.Expr]
    order: int
    small: Mapping[sp.Symbol, int]
    forcing: Sequence[sp.Expr] = (sp.S.One,)
    force: sp.Expr = F
    reference: sp.Expr = omega_0
    ratio: sp.Rational = sp.S.One
    natural: Sequence[sp.Symbol] = (omega_0,)
    ratios: Sequence[int] = (1,)
    detunings: Sequence[sp.Expr] = (0,)
    amplitude: int = 0
    damping: Sequence[sp.Symbol] = (c,)
    driven: int = 0
    complex_form: bool = False
    motion: bool = False
    solve: Sequence[str] = ("backbone", "response")
    stability: Mapping[str, Any] = field(default_factory=dict)

    @property
    def coordinates(self) -> list[sp.Expr]:
        return [x, y][: len(self.equations)]


def _duffing(order: int, small: Mapping[sp.Symbol, int], **options: Any) -> System:
    return System([ddx + omega_0**2 * x + gamma * x**3 + c * dx], order, small, **options)


def duffing() -> System:
    """Forced and damped, primary resonance, order 3."""
    stability = {"coord": "polar", "eigenvalues": True, "bifurcation_curves": True}
    solve = ("response", "backbone", "stability")
    return _duffing(3, {gamma: 1, F: 3, c: 3}, solve=solve, stability=stability)


def duffing_complex() -> System:
    """Forced and damped, primary resonance, order 5; for the peer in its complex form."""
    return _duffing(5, {gamma: 1, F: 5, c: 5}, solve=("backbone",), complex_form=True, motion=True)


def odd_nonlinearity() -> System:
    """Powers 3, 5 and 7, primary resonance, order 3."""
    odd = gamma_3 * x**3 + gamma_5 * x**5 + gamma_7 * x**7
    return System(
        [ddx + omega_0**2 * x + odd + c * dx],
        3,
        {gamma_3: 1, gamma_5: 1, gamma_7: 1, F: 3, c: 3},
        solve=("response", "backbone", "stability"),
        stability={"coord": "polar", "eigenvalues": True, "bifurcation_curves": True},
    )


def superharmonic() -> System:
    """Duffing with hard forcing at a third of the natural frequency, order 1."""
    return _duffing(1, {gamma: 1, F: 0, c: 1}, ratio=sp.Rational(1, 3), motion=True)


def subharmonic() -> System:
    """Duffing with hard forcing at three times the natural frequency, order 1."""
    return _duffing(1, {gamma: 1, F: 0, c: 1}, ratio=sp.Integer(3), motion=True)


def parametric_duffing() -> System:
    """Stiffness modulated at twice the natural frequency, order 1."""
    small = {gamma: 1, F: 1, c: 1}
    stability = {"coord": "polar", "eigenvalues": True}
    solve = ("backbone", "response", "stability")
    options = {"ratio": sp.Integer(2), "solve": solve, "stability": stability}
    return _duffing(1, small, forcing=[-2 * x], motion=True, **options)


def parametric_rayleigh() -> System:
    """Rayleigh's oscillator, its stiffness modulated at twice the frequency, order 1."""
    return System(
        [ddx + omega_0**2 * x + gamma * dx**3 - c * dx],
        1,
        {gamma: 1, F: 1, c: 1},
        forcing=[-2 * x],
        ratio=sp.Integer(2),
        motion=True,
        solve=("backbone", "response", "stability"),
        stability={"coord": "polar", "eigenvalues": True},
    )


def van_der_pol() -> System:
    """Free, its frequency detuned from 1, order 2."""
    return System(
        [ddx + omega_0**2 * x + mu * (x**2 - 1) * dx],
        2,
        {mu: 1, delta: 1},
        force=sp.S.Zero,
        reference=sp.S.One,
        detunings=[delta],
        motion=True,
        solve=("limit cycle",),
    )


def one_to_one() -> System:
    """Two Duffing oscillators of one frequency, the second driven, order 1."""
    in_x = ddx + omega_0**2 * x + gamma_0 * x**3 + gamma_01 * x * y**2 + c_0 * dx
    in_y = ddy + omega_0**2 * y + gamma_1 * y**3 + gamma_01 * x**2 * y + c_1 * dy
    return System(
        [in_x, in_y],
        1,
        dict.fromkeys((gamma_0, gamma_1, gamma_01, F, c_0, c_1), 1),
        forcing=[sp.S.Zero, sp.S.One],
        natural=(omega_0, omega_0),
        ratios=(1, 1),
        detunings=(0, 0),
        damping=(c_0, c_1),
        driven=1,
        solve=("backbone", "response", "stability"),
        stability={"coord": "cartesian", "eigenvalues": False, "rewrite_polar": True},
    )


def one_to_two() -> System:
    """Quadratic coupling, ω_1 near 2ω_0, driven near ω_1, order 1 in small amplitudes."""
    alpha_0, alpha_1 = sp.symbols("alpha_0 alpha_1", real=True)
    in_x = ddx + omega_0**2 * x + 2 * mu_0 * dx + alpha_0 * x * y
    in_y = ddy + omega_1**2 * y + 2 * mu_1 * dy + alpha_1 * x**2
    return System(
        [in_x, in_y],
        1,
        {F: 0, eta_0: 1, eta_1: 2, mu_0: 1, mu_1: 1, delta: 1, alpha_0: 0, alpha_1: 0},
        forcing=[eta_0, eta_1],
        ratio=sp.Integer(2),
        natural=(omega_0, omega_1),
        ratios=(1, 2),
        detunings=(0, delta),
        amplitude=1,
        damping=(mu_0, mu_1),
        solve=("backbone",),
    )


def one_to_three() -> System:
    """All cubic terms, ω_1 near 3ω_0, driven near ω_1, order 1."""
    alpha = sp.symbols("alpha_1:9", real=True)
    cubic = [x**3, x**2 * y, x * y**2, y**3]
    in_x = ddx + omega_0**2 * x + 2 * mu_0 * dx
    in_y = ddy + omega_1**2 * y + 2 * mu_1 * dy
    in_x += sum(a * m for a, m in zip(alpha[:4], cubic, strict=True))
    in_y += sum(a * m for a, m in zip(alpha[4:], cubic, strict=True))
    return System(
        [in_x, in_y],
        1,
        dict.fromkeys((*alpha, F, mu_0, mu_1, delta), 1),
        forcing=[eta_0, eta_1],
        ratio=sp.Integer(3),
        natural=(omega_0, omega_1),
        ratios=(1, 3),
        detunings=(0, delta),
        damping=(mu_0, mu_1),
        driven=1,
        solve=("backbone",),
    )


def centrifugal_pendulum() -> System:
    """Two modes of a pair of centrifugal pendulums in a rotor, driven at twice the order.

    After Mahé, Renault, Grolet, Mahé and Thomas, On the dynamic stability and efficiency of
    centrifugal pendulum vibration absorbers with rotating pendulums (2022).
    """
    n_p, n_t, eta, lambda_m, b, torque = sp.symbols("n_p n_t eta lambda_m b T", positive=True)
    lambda_c, alpha_1, alpha_3, x_4 = sp.symbols("lambda_c alpha_1 alpha_3 x_4", real=True)
    bend = n_t**2 * (1 + n_t**2)
    rotor_x = lambda_m * dx - bend * x * y
    rotor_y = lambda_c + lambda_m * dy - bend * (x**2 + y**2) / 2
    drive, tilt = mu * n_p**2 * lambda_c, 6 * eta * alpha_1 * alpha_3
    square = x * dx + y * dy
    in_x = rotor_x * drive * y + 2 * mu * n_t**2 * lambda_m * dx * square + b * dx
    in_x += tilt * (x * dx**2 + 2 * y * dx * dy + x * dy**2 + x**2 * ddx + 2 * x * y * ddy)
    in_x += tilt * y**2 * ddx - 2 * x_4 * (x**3 + 3 * x * y**2)
    in_y = rotor_y * drive * y + 2 * mu * n_t**2 * (lambda_c + lambda_m * dy) * square + b * dy
    in_y -= drive * bend * (3 * x**2 * y + y**3) / 2
    in_y += lambda_c * mu * bend * (2 * x * dx * dy + y * dx**2 + y * dy**2)
    in_y += tilt * (2 * x * dx * dy + y * dx**2 + y * dy**2 + 2 * x * y * ddx)
    in_y += tilt * (x**2 + y**2) * ddy - 2 * x_4 * (3 * x**2 * y + y**3)
    return System(
        [ddx + n_p**2 * x + in_x / lambda_m, ddy + n_p**2 * y + in_y / lambda_m],
        1,
        {mu: 1, alpha_3: 1, x_4: 1, b: 1, torque: 1},
        forcing=[-rotor_x / lambda_m, -rotor_y / lambda_m],
        force=torque,
        reference=n_p,
        ratio=sp.Integer(2),
        natural=(n_p, n_p),
        ratios=(1, 1),
        detunings=(0, 0),
        damping=(b,),
        solve=("response", "backbone", "stability"),
        stability={"coord": "cartesian", "eigenvalues": True, "bifurcation_curves": True},
    )


SYSTEMS: dict[str, Callable[[], System]] = {
    make.__name__: make
    for make in (
        duffing,
        parametric_duffing,
        parametric_rayleigh,
        one_to_two,
        one_to_three,
        one_to_one,
        van_der_pol,
        superharmonic,
        subharmonic,
        centrifugal_pendulum,
        odd_nonlinearity,
        duffing_complex,
    )
}
