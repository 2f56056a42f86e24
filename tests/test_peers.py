"""The benchmark's examples with mmsgen give what is printed; nothing is timed here.

Sources: Nayfeh and Mook, *Nonlinear Oscillations* (1979), chapters 4 to 6; the frequency of a
Duffing oscillator by elliptic functions.
"""

from __future__ import annotations

import sys
from itertools import pairwise
from pathlib import Path

import mpmath
import pytest
import sympy as sp

from mmsgen.symbols import amplitude, modulus

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "benchmarks" / "peers"))
import autonomous
import compare
import measure
import peer_systems as ps
import with_mmsgen as twin

a = modulus(ps.x)
sigma = sp.Symbol("sigma", real=True)
w, g, c, F = ps.omega_0, ps.gamma, ps.c, ps.F


def same(left: sp.Expr, right: sp.Expr) -> bool:
    return bool(sp.cancel(sp.together(left - right)) == 0)


def implicit(system: ps.System) -> sp.Expr:
    """(σ − σ_1)(σ − σ_2) over the amplitude of the response."""
    first, second = twin.response(system, twin.expand(system).slow_flow)
    return sp.expand((sigma - first) * (sigma - second))


def test_every_example_has_its_system() -> None:
    assert tuple(ps.SYSTEMS) == measure.OSCILATE
    assert tuple(autonomous.EXAMPLES) == measure.ASYMPTOTICS


@pytest.mark.parametrize("name", ps.SYSTEMS)
def test_examples_are_carried_through(name: str) -> None:
    system = ps.SYSTEMS[name]()
    flow = twin.expand(system).slow_flow
    assert flow.case.order == system.order
    if name not in ("centrifugal_pendulum", "odd_nonlinearity"):  # a second each
        assert all(result is not None for result in twin.analyse(system, flow))


def test_duffing_backbone_of_order_three() -> None:
    system = ps.duffing()
    curve = twin.backbone(system, twin.expand(system).slow_flow)
    series = 3 * g * a**2 / (8 * w) - 15 * g**2 * a**4 / (256 * w**3)
    assert same(curve, series + 123 * g**3 * a**6 / (8192 * w**5))


def test_duffing_backbone_of_order_five_against_elliptic_functions() -> None:
    """An error of ε^6: the amplitude of the fundamental is that of the Fourier series of cn."""
    system = ps.duffing_complex()
    curve = twin.backbone(system, twin.expand(system).slow_flow).subs({w: 1, a: 1})
    errors = []
    with mpmath.workdps(40):
        for k in (5, 6, 7):
            small = mpmath.mpf(2) ** -k

            def cn(start: mpmath.mpf, small: mpmath.mpf = small) -> tuple[mpmath.mpf, mpmath.mpf]:
                """Fundamental and frequency of the motion that starts at rest."""
                y = small * start**2
                m = y / (2 * (1 + y))
                quarter = mpmath.ellipk(m)
                nome = mpmath.qfrom(m=m)
                fundamental = start * 2 * mpmath.pi / (quarter * mpmath.sqrt(m))
                fundamental *= mpmath.sqrt(nome) / (1 + nome)
                return fundamental, mpmath.pi * mpmath.sqrt(1 + y) / (2 * quarter)

            start = mpmath.findroot(lambda x: cn(x)[0] - 1, 1 + small / 32)
            exact = cn(start)[1]
            errors.append(abs(1 + sp.Float(curve.subs(g, sp.Rational(1, 2**k)), 40) - exact))
    orders = [float(sp.log(p / q, 2)) for p, q in pairwise(errors)]
    assert all(abs(order - 6) < 0.2 for order in orders)  # halving ε: 2^6, up to O(ε)


def test_superharmonic_response_of_duffing() -> None:
    """[μ² + (s − 3αΛ²/ω − 3αa²/8ω)²]a² = α²Λ⁶/ω², 3Ω = ω + s, Λ = K/(2(ω² − Ω²))."""
    system, mu, s = ps.superharmonic(), c / 2, 3 * sigma
    forced = F / (2 * (w**2 - w**2 / 9))
    shift = s - 3 * g * forced**2 / w - 3 * g * a**2 / (8 * w)
    printed = (mu**2 + shift**2) - g**2 * forced**6 / (w * a) ** 2
    assert same(implicit(system), printed / 9)


def test_subharmonic_response_of_duffing() -> None:
    """9μ² + (σ − 9αΛ²/ω − 9αa²/8ω)² = (81α²Λ²/16ω²)a², Ω = 3ω + σ."""
    system, mu = ps.subharmonic(), c / 2
    forced = F / (2 * (w**2 - 9 * w**2))
    shift = sigma - 9 * g * forced**2 / w - 9 * g * a**2 / (8 * w)
    printed = 9 * mu**2 + shift**2 - 81 * g**2 * forced**2 * a**2 / (16 * w**2)
    assert same(implicit(system), printed)


def test_parametric_response_of_duffing() -> None:
    """a² = 4(σ ± √(f² − 4μ²))/(3α) at ω = 1, with f = F and 2μ = c."""
    response = implicit(ps.parametric_duffing()).subs(w, 1)
    assert same(response, (sigma - 3 * g * a**2 / 4) ** 2 - (F**2 - c**2))


def test_limit_cycle_of_van_der_pol() -> None:
    system = ps.van_der_pol()
    amplitudes, turning, _ = twin.limit_cycle(system, twin.expand(system).slow_flow)
    assert amplitudes == [2] and same(turning[0], -(ps.mu**2) / (16 * w))


def test_internal_resonance_1_2() -> None:
    """The quadratic coupling of Nayfeh and Mook's chapter 6, and a force on the second mode."""
    system = ps.one_to_two()
    case = twin.expand(system)
    in_x, in_y = (case.slow_flow.complex[amplitude(q)] for q in system.coordinates)
    A, B = (amplitude(q) for q in system.coordinates)
    alpha_0, alpha_1 = sp.symbols("alpha_0 alpha_1", real=True)
    assert same(in_x, -ps.mu_0 * A + sp.I * alpha_0 * B * sp.conjugate(A) / (2 * w))
    free = (-ps.mu_1 + sp.I * case.relations[0].detuning) * B + sp.I * alpha_1 * A**2 / (4 * w)
    force = -sp.I * F * ps.eta_1 / (8 * w) * sp.exp(sp.I * case.relations[1].detuning * ps.t)
    assert same(in_y, free + force)


@pytest.mark.parametrize(("name", "second"), [("strained_cubic", -21), ("cubic", 0)])
def test_frequency_over_the_initial_displacement(name: str, second: int) -> None:
    case = twin.expand_autonomous(autonomous.EXAMPLES[name])
    (eps,) = (p.symbol for p in case.weak.scaled.eom.parameters)
    printed = 1 + 3 * eps / 8 + second * eps**2 / 256
    assert same(compare.strained_frequency(case), printed)


def test_a_wrong_coefficient_is_seen_by_the_comparison() -> None:
    rates = {"da_0": "(F*sin(beta_0) - a_0*c*omega_0)/(2*omega_0)"}
    series = "-3*gamma*a_0**3/(8*omega_0) + 15*gamma**2*a_0**5/(256*omega_0**3) + sigma*a_0"
    third = "F*cos(beta_0)/(2*omega_0) - 123*a_0**7*gamma**3/(8192*omega_0**5)"
    right = {**rates, "a_0 dbeta_0": f"{series} + {third}"}
    assert compare.oscilate_gaps("duffing", {"rates": right}) == [float("inf")]
    wrong = {**rates, "a_0 dbeta_0": f"{series} + {third.replace('123', '124')}"}
    assert compare.oscilate_gaps("duffing", {"rates": wrong}) == [3]
