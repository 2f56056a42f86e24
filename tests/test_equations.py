"""Equations of motion: linearisation, other parameters, and the proof that the old are gone."""

from __future__ import annotations

import os
import subprocess
import sys
from typing import Any

import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

from mmsgen.equations import EquationsOfMotion
from mmsgen.errors import ModelError
from mmsgen.model import Model
from mmsgen.parameters import Parameter

t = dynamicsymbols._t
m, k, c, g, h, w, r, s, mu = sp.symbols("m k c g h w r s mu", positive=True)
F = sp.Symbol("F", real=True)
q, p = dynamicsymbols("q p")
dq, dp = q.diff(t), p.diff(t)
ddq, ddp = q.diff(t, 2), p.diff(t, 2)


def record(*equations: sp.Expr, coordinates: tuple[sp.Expr, ...] = (q,)) -> EquationsOfMotion:
    """Equations with all their symbols declared, by name."""
    free = sorted(set().union(*(e.free_symbols for e in equations)) - {t}, key=str)
    return EquationsOfMotion(equations, coordinates, tuple(Parameter(x) for x in free))


def oscillator() -> EquationsOfMotion:
    """m q'' + c q' + k q + h q³ = F cos(wt)."""
    return record(m * ddq + c * dq + k * q + h * q**3 - F * sp.cos(w * t))


def symbols_of(eom: EquationsOfMotion) -> list[sp.Symbol]:
    """The parameters' symbols, in order."""
    return [parameter.symbol for parameter in eom.parameters]


# --- the record -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("fields", "phrases"),
    [
        (((ddq + q, ddq), (q,), ()), ["2 equations for 1 coordinates"]),
        (((ddq + k * q,), (q,), ()), ["equation of q(t)", "undeclared symbol k", "Parameter(k"]),
        (((ddq + 0.1 * q,), (q,), ()), ["equation of q(t)", "0.1", "Rational"]),
        (((dq + q,), (q,), ()), ["q(t)", "no kinetic energy"]),
        (((ddq + p,), (q,), ()), ["equation of q(t)", "undeclared function p(t)"]),
        (((ddq + q.diff(t, 3),), (q,), ()), ["equation of q(t)", "higher derivative"]),
        (((ddq,), (q,), (sp.Symbol("class"),)), ["'class'", "keyword"]),
    ],
)
def test_refused_by_name(fields: Any, phrases: list[str]) -> None:
    with pytest.raises(ModelError) as caught:
        EquationsOfMotion(*fields)
    for phrase in phrases:
        assert phrase in str(caught.value)


def test_shown_in_a_notebook() -> None:
    latex = oscillator()._repr_latex_()
    assert latex.startswith(r"$\displaystyle \begin{aligned}")
    assert r"\ddot{q}" in latex
    assert "&= 0" in latex


# --- linear part ----------------------------------------------------------------------------------


def test_matrices_of_a_cart_with_a_pendulum() -> None:
    """By hand: cos p → 1 and sin p → p; the centrifugal p'² sin p is of third order.

    The force F cos(wt) acts along q + p and has no linear part beside its value at rest.
    """
    lagrangian = (
        m * dq**2 / 2
        + h * ((dq + r * dp * sp.cos(p)) ** 2 + (r * dp * sp.sin(p)) ** 2) / 2
        + h * g * r * sp.cos(p)
        - k * q**2 / 2
        + F * sp.cos(w * t) * sp.sin(q + p)
    )
    damper = s * (dq - dp) ** 2 / 2
    eom = Model(lagrangian, [q, p], [m, h, r, g, k, F, w, s], damper).equations_of_motion()
    assert eom.M == sp.Matrix([[m + h, h * r], [h * r, h * r**2]])
    assert eom.C == sp.Matrix([[s, -s], [-s, s]])
    assert eom.K == sp.Matrix([[k, 0], [0, g * h * r]])
    assert eom.f == sp.Matrix([F * sp.cos(w * t), F * sp.cos(w * t)])
    assert eom.M is eom.M  # kept, not derived again

    linear = eom.linearise()
    motion = sp.Matrix([q, p])
    left = eom.M * motion.diff(t, 2) + eom.C * motion.diff(t) + eom.K * motion - eom.f
    assert all(sp.expand(a - b) == 0 for a, b in zip(linear.equations, left, strict=True))
    assert linear.linearise() == linear
    assert set(symbols_of(linear)) == {m, h, r, g, k, F, w, s}


def test_parametric_terms_in_displacement_velocity_and_acceleration() -> None:
    cos, sin = sp.cos(w * t), sp.sin(w * t)
    eom = record((m + h * cos**2) * ddq * sp.exp(q) + c * sin * dq * (1 + dq) + sp.tan(k * cos * q))
    assert eom.M == sp.Matrix([[m + h / 2 + h * sp.cos(2 * w * t) / 2]])
    assert eom.C == sp.Matrix([[c * sin]])
    assert eom.K == sp.Matrix([[k * cos]])
    assert eom.f == sp.Matrix([0])


def test_linearising_drops_what_is_of_higher_order() -> None:
    linear = oscillator().linearise()
    assert linear.equations == (m * ddq + c * dq + k * q - F * sp.cos(w * t),)
    assert h not in symbols_of(linear)


@pytest.mark.parametrize(
    ("equation", "phrases"),
    [
        (ddq + k * q + g, ["equation of q(t)", "no equilibrium", "-g"]),
        (ddq + k * sp.cos(q), ["equation of q(t)", "no equilibrium", "-k"]),
        # a rectified force has a mean: cos² = 1/2 + cos(2wt)/2
        (ddq + k * q + F * sp.cos(w * t) ** 2, ["no equilibrium", "-F/2"]),
        (ddq + k / q, ["equation of q(t)", "singular at rest"]),
        (ddq + k * q**2 * sp.log(q), ["singular at rest"]),
        (ddq + k * sp.sqrt(q), ["singular at rest"]),
        (ddq + k * sp.Abs(q), ["Abs(q(t))", "no Taylor expansion"]),
        (ddq + k * sp.sign(dq), ["no Taylor expansion"]),
        (ddq + k * q * sp.sign(q), ["no Taylor expansion"]),
    ],
)
def test_no_linear_part(equation: sp.Expr, phrases: list[str]) -> None:
    with pytest.raises(ModelError) as caught:
        record(equation).linearise()
    for phrase in phrases:
        assert phrase in str(caught.value)


def test_what_vanishes_twice_has_no_linear_part() -> None:
    """x|x| has the slope 2|x|, and sgn is bounded."""
    forces = k * dq * sp.Abs(dq) + k * q**2 * sp.sign(dq)
    linear = record(ddq + k * q + forces).linearise()
    assert linear.equations == (ddq + k * q,)


def test_singular_mass_matrix() -> None:
    lagrangian = m * (dq + dp) ** 2 / 2 - k * q**2 - k * p**2
    eom = Model(lagrangian, [q, p], [m, k]).equations_of_motion()
    with pytest.raises(ModelError, match=r"mass matrix of \(q\(t\), p\(t\)\) is singular"):
        eom.linearise()
    # coupled through their accelerations only, but not singular
    swapped = Model(m * dq * dp - k * q * p, [q, p], [m, k]).equations_of_motion()
    assert swapped.M == sp.Matrix([[0, m], [m, 0]])


# --- other parameters -----------------------------------------------------------------------------


def test_ratios_of_an_oscillator() -> None:
    eom = oscillator()
    new = [Parameter(r, "rad/s", "frequency"), Parameter(mu, "1/s", "damping rate")]
    ratios = eom.reparametrise({k: m * r**2, "c": 2 * m * mu, h: m * s, F: m * F}, new)
    assert ratios.equations == (ddq + 2 * mu * dq + r**2 * q + s * q**3 - F * sp.cos(w * t),)
    # remaining ones first, then the declared new ones, then the undeclared; m is gone
    assert symbols_of(ratios) == [F, w, r, mu, s]
    assert ratios.parameters[2] == new[0]
    assert ratios.parameters[4] == Parameter(s)


def test_replacements_are_made_at_once() -> None:
    swapped = record(m * ddq + k * q + h * dq).reparametrise({k: h, h: k})
    assert sp.expand(swapped.equations[0] * m - (m * ddq + h * q + k * dq)) == 0


def test_zero_drops_terms_and_parameters() -> None:
    eom = oscillator().reparametrise({c: 0, F: 0})
    assert sp.expand(eom.equations[0] * m - (m * ddq + k * q + h * q**3)) == 0
    assert symbols_of(eom) == [h, k, m]


def test_inertia_that_varies_with_time_is_not_divided_by() -> None:
    eom = record((m + h * sp.cos(w * t)) * ddq + k * q).reparametrise({k: m * r**2, h: m * s})
    assert sp.expand(eom.equations[0] / m - (1 + s * sp.cos(w * t)) * ddq - r**2 * q) == 0


def test_inertia_is_that_at_rest() -> None:
    # divided by m + h, the coefficient of q'' for q = 0
    eom = record((m + h * sp.cos(q)) * ddq + k * q).reparametrise({k: (m + h) * r**2})
    expected = (m + h * sp.cos(q)) * ddq / (m + h) + r**2 * q
    assert sp.cancel(eom.equations[0] - expected) == 0


def test_it_commutes_with_linearising() -> None:
    mapping = {k: m * r**2, h: m * s, c: 2 * m * mu}
    one = oscillator().reparametrise(mapping).linearise()
    other = oscillator().linearise().reparametrise({k: m * r**2, c: 2 * m * mu})
    assert one.equations == other.equations
    assert one.coordinates == other.coordinates
    assert set(one.parameters) == set(other.parameters)


def test_round_trip() -> None:
    eom = oscillator()
    there = eom.reparametrise({k: m * r**2, c: 2 * m * mu, h: m * s, F: m * g})
    back = there.reparametrise({r: sp.sqrt(k / m), mu: c / (2 * m), s: h / m, g: F / m})
    assert back.equations == eom.reparametrise({}).equations


@pytest.mark.parametrize(
    ("mapping", "options", "phrases"),
    [
        # k = m r² forgotten for c: c/m stays
        ({k: m * r**2}, {"eliminate": [m]}, ["m did not cancel", "equation of q(t)", "c"]),
        ({k: m * r**2, c: c + r}, {"eliminate": ["m", h]}, ["h, m did not cancel"]),
        ({r: k / m}, {}, ["r is no parameter", "F, c, h, k, m, w"]),
        ({"r": k / m}, {}, ["r is no parameter"]),
        ({sp.Symbol("k"): r}, {}, ["k is no parameter"]),
        ({k: r}, {"eliminate": ["x"]}, ["x is no parameter"]),
        ({k: r, "k": s}, {}, ["k is replaced twice"]),
        ({k: 0.5}, {}, ["expression for k", "0.5", "Rational"]),
        ({k: "r"}, {}, ["expression for k", "text"]),
        ({k: sp.Symbol("h")}, {}, ["two parameters", "'h'"]),
        ({k: r}, {"parameters": [sp.Symbol("lambda")]}, ["'lambda'", "keyword"]),
        ({k: t}, {}, ["expression for k", "depends on time"]),
        ({k: m * q}, {}, ["expression for k", "depends on time"]),
        ({m: 0}, {}, ["no kinetic energy"]),
    ],
)
def test_reparametrisation_refused(
    mapping: Any, options: dict[str, Any], phrases: list[str]
) -> None:
    with pytest.raises(ModelError) as caught:
        oscillator().reparametrise(mapping, **options)
    for phrase in phrases:
        assert phrase in str(caught.value)


# --- definitions ----------------------------------------------------------------------------------


def spinning() -> EquationsOfMotion:
    """q'' + (k + r²w²) q = 0: a frequency that grows with the speed w."""
    return record(ddq + (k**2 + r**2 * w**2) * q)


def test_a_defined_frequency_keeps_what_it_depends_on() -> None:
    lag = Parameter(s, "rad/s", "frequency at speed", sp.sqrt(k**2 + r**2 * w**2))
    eom = spinning().reparametrise({k: sp.sqrt(s**2 - r**2 * w**2)}, [lag])
    assert eom.equations == (ddq + s**2 * q,)
    assert symbols_of(eom) == [s, k, r, w]  # the last three for the definition only
    assert eom.parameters[0] == lag

    # later steps change the definition along, until it is not needed any more
    frozen = eom.reparametrise({w: 3 * g})
    assert frozen.parameters[0].definition == sp.sqrt(k**2 + 9 * r**2 * g**2)
    assert symbols_of(frozen) == [s, k, r, g]
    back = eom.reparametrise({s: sp.sqrt(k**2 + r**2 * w**2)})
    assert back.equations == spinning().equations
    assert symbols_of(back) == symbols_of(spinning())


@pytest.mark.parametrize(
    ("mapping", "definition", "phrases"),
    [
        # a sign, a square root and a factor forgotten
        ({k: sp.sqrt(s**2 - r**2 * w**2)}, sp.sqrt(k**2 - r**2 * w**2), ["definition s"]),
        ({k: sp.sqrt(s**2 - r**2 * w**2)}, k**2 + r**2 * w**2, ["definition s"]),
        ({k: sp.sqrt(s**2 - 2 * r**2 * w**2)}, sp.sqrt(k**2 + r**2 * w**2), ["definition s"]),
        # s = k is right, but w = s would say that w is k
        ({k: s, w: s}, k, ["w is replaced by s", "is k and not w"]),
    ],
)
def test_definitions_are_checked(mapping: Any, definition: sp.Expr, phrases: list[str]) -> None:
    with pytest.raises(ModelError) as caught:
        spinning().reparametrise(mapping, [Parameter(s, definition=definition)])
    for phrase in phrases:
        assert phrase in str(caught.value)


def test_a_symbol_in_use_is_not_redefined() -> None:
    with pytest.raises(ModelError, match="w is in use already"):
        spinning().reparametrise({k: s}, [Parameter(w, definition=2 * r)])


# --- the same on every run ------------------------------------------------------------------------

_SCRIPT = """
import sympy as sp
from rotor import at_speed, helicopter, in_ratios, isotropic
eom = at_speed(in_ratios(isotropic(helicopter(3).equations_of_motion())))
print(sp.srepr(eom.equations), sp.latex(eom.equations), eom.parameters, eom.linearise().K)
"""


def test_the_order_of_terms_does_not_depend_on_hashes() -> None:
    outputs = set()
    for seed in ("1", "2"):
        environment = {
            **os.environ,
            "PYTHONHASHSEED": seed,
            "PYTHONPATH": os.pathsep.join(sys.path),
        }
        done = subprocess.run(
            [sys.executable, "-c", _SCRIPT],
            env=environment,
            capture_output=True,
            text=True,
            check=True,
        )
        outputs.add(done.stdout)
    assert len(outputs) == 1
    assert "Symbol('omega_phi'" in outputs.pop()
