"""Models: what is accepted, and what is refused by name with its remedy."""

from __future__ import annotations

import keyword
from typing import Any

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from mmsgen.errors import ModelError
from mmsgen.model import Model
from mmsgen.parameters import Parameter
from mmsgen.terms import expanded

t = dynamicsymbols._t
m, k, c, g, length = sp.symbols("m k c g l", positive=True)
q, p = dynamicsymbols("q p")
dq, dp = q.diff(t), p.diff(t)
OSCILLATOR = m * dq**2 / 2 - k * q**2 / 2


def build(**changes: Any) -> Model:
    """An oscillator, with some of its fields changed."""
    fields = {"lagrangian": OSCILLATOR, "coordinates": [q], "parameters": [m, k], **changes}
    return Model(**fields)


def test_oscillator_with_everything() -> None:
    F = sp.Symbol("F", real=True)
    model = Model(
        OSCILLATOR,
        [q],
        [Parameter(m, "kg", "mass"), Parameter(k, "N/m", "stiffness"), c, F],
        dissipation=c * dq**2 / 2,
        forces={q: F * sp.cos(3 * t)},
    )
    eom = model.equations_of_motion()
    assert eom.equations == (m * q.diff(t, 2) + c * dq + k * q - F * sp.cos(3 * t),)
    assert eom.coordinates == (q,)
    assert eom.time == t
    assert [parameter.name for parameter in eom.parameters] == ["m", "k", "c", "F"]
    assert eom.parameters[0] == Parameter(m, "kg", "mass")
    assert eom.parameters[2] == Parameter(c)
    assert hash(model) == hash(model)


def test_cart_with_a_pendulum() -> None:
    """By hand: horizontal momentum of both, moment of the bob's forces about the pivot."""
    M = sp.Symbol("M", positive=True)
    x, y = q + length * sp.sin(p), -length * sp.cos(p)
    lagrangian = M * dq**2 / 2 + m * (x.diff(t) ** 2 + y.diff(t) ** 2) / 2 - m * g * y
    eom = Model(lagrangian, [q, p], [M, m, g, length]).equations_of_motion()
    ddq, ddp = q.diff(t, 2), p.diff(t, 2)
    by_hand = (
        (M + m) * ddq + m * length * ddp * sp.cos(p) - m * length * dp**2 * sp.sin(p),
        m * length**2 * ddp + m * length * ddq * sp.cos(p) + m * g * length * sp.sin(p),
    )
    assert all(sp.expand(a - b) == 0 for a, b in zip(eom.equations, by_hand, strict=True))


def test_agrees_with_the_whole_lagrangian_given_to_sympy() -> None:
    """Feeding `LagrangesMethod` term by term, renamed and without phases, changes nothing."""
    w = sp.Symbol("w", positive=True)
    lagrangian = (
        m * (dq + length * dp * sp.cos(w * t + p + sp.pi / 5)) ** 2 / 2
        + m * length**2 * dp**2 * (1 + q**2) / 2
        + m * dp**2 * sp.exp(-(q**2))
        - k * sp.sqrt(length**2 + q**2)
        + k * sp.cos(w * t - sp.pi / 7) * sp.sin(p) * sp.cos(q - p)
        + k * sp.tan(w * t)
    )
    mine = Model(lagrangian, [q, p], [m, length, w, k]).equations_of_motion().equations
    whole = LagrangesMethod(lagrangian, [q, p]).form_lagranges_equations()
    for left, right in zip(mine, whole, strict=True):
        assert expanded(left - right) == 0
        assert expanded(left - 2 * right) != 0


def test_unevaluated_derivatives_are_written_out() -> None:
    lagrangian = m * sp.Derivative(q**2, t) ** 2 / 8 + m * dq**2 / 2 - k * q**2 / 2
    (equation,) = build(lagrangian=lagrangian).equations_of_motion().equations
    ddq = q.diff(t, 2)
    assert sp.expand(equation - (m * ddq + m * q**2 * ddq + m * q * dq**2 + k * q)) == 0


def test_parameters_that_drop_out_are_not_asked_for() -> None:
    model = build(lagrangian=OSCILLATOR + g * sp.cos(t), parameters=[g, m, k])
    assert [parameter.name for parameter in model.equations_of_motion().parameters] == ["m", "k"]


COMPLEX = sp.Symbol("z", complex=True)
WHOLE_TIME = sp.Function("w")(t)
OTHER_TIME = sp.Function("q")(sp.Symbol("t", real=True))
REFUSED = {
    "not a function of time": ({"coordinates": [k]}, ["k", "not a function of time", "dynamics"]),
    "function of two": (
        {"coordinates": [sp.Function("q")(t, m)]},
        ["q(t, m)", "not a function of time"],
    ),
    "another time": ({"coordinates": [OTHER_TIME]}, ["q(t)", "dynamicsymbols"]),
    "no coordinates": ({"coordinates": []}, ["at least one coordinate"]),
    "one coordinate unlisted": ({"coordinates": q}, ["must be a list"]),
    "coordinate twice": ({"coordinates": [q, q]}, ["q(t)", "twice"]),
    "coordinate like a parameter": (
        {"parameters": [m, k, sp.Symbol("q")]},
        ["'q'", "both a coordinate and a parameter"],
    ),
    "coordinate with an odd name": (
        {"coordinates": [dynamicsymbols(r"\phi")]},
        [r"\\phi", "identifier"],
    ),
    "undeclared": ({"parameters": [m]}, ["Lagrangian", "undeclared symbol k", "Parameter(k"]),
    "undeclared two": ({"parameters": []}, ["k, m", "Parameter(k", "Parameter(m"]),
    "undeclared in dissipation": ({"dissipation": c * dq**2}, ["dissipation", "c", "Parameter("]),
    "undeclared in force": ({"forces": {q: c}}, ["force on q(t)", "c", "Parameter("]),
    "same name, other assumptions": (
        {"parameters": [m, sp.Symbol("k", real=True)]},
        ["'k'", "assumptions differ"],
    ),
    "undeclared function": (
        {"lagrangian": OSCILLATOR + k * WHOLE_TIME * q},
        ["w(t)", "add it to the coordinates"],
    ),
    "undeclared velocity": (
        {"lagrangian": OSCILLATOR + k * WHOLE_TIME.diff(t) * q},
        ["w(t)", "coordinates"],
    ),
    "float": ({"lagrangian": 0.5 * m * dq**2}, ["0.5", "sympy.Rational"]),
    "float in the dissipation": ({"dissipation": 0.1 * dq**2}, ["dissipation", "0.1", "Rational"]),
    "float in a force": ({"forces": {q: 1.5}}, ["force on q(t)", "1.5", "Rational"]),
    "text": ({"lagrangian": "m*q"}, ["text", "not evaluated"]),
    "no expression": ({"lagrangian": None}, ["scalar SymPy expression", "None"]),
    "matrix": ({"lagrangian": sp.Matrix([OSCILLATOR])}, ["scalar SymPy expression"]),
    "imaginary": ({"lagrangian": sp.I * OSCILLATOR}, ["imaginary unit"]),
    "infinite": ({"lagrangian": OSCILLATOR + sp.oo * m}, ["not finite"]),
    "acceleration": (
        {"lagrangian": OSCILLATOR + m * q.diff(t, 2) ** 2},
        ["second derivative", "only velocities"],
    ),
    "third derivative in a force": (
        {"forces": {q: m * q.diff(t, 3)}},
        ["higher derivative", "second order at most"],
    ),
    "no kinetic energy": (
        {"coordinates": [q, p], "lagrangian": OSCILLATOR - k * p**2 + k * dp * q},
        ["p(t)", "no kinetic energy"],
    ),
    "force on a stranger": ({"forces": {p: m}}, ["p(t)", "no coordinate", "q(t)"]),
    "complex parameter": ({"parameters": [m, k, COMPLEX]}, ["z", "complex", "real=True"]),
    "imaginary parameter": (
        {"parameters": [m, k, sp.Symbol("z", imaginary=True)]},
        ["z", "declared complex"],
    ),
    "matrix parameter": (
        {"parameters": [m, k, sp.Symbol("z", commutative=False)]},
        ["z", "commute"],
    ),
    "parameter twice": ({"parameters": [m, k, sp.Symbol("m")]}, ["'m'", "rename"]),
    "parameter called t": ({"parameters": [m, k, t]}, ["'t'", "time", "rename"]),
    "keyword": ({"parameters": [m, k, sp.Symbol("lambda")]}, ["'lambda'", "keyword", "lambda_0"]),
    "no symbol": ({"parameters": [m, k, 3]}, ["sympy.Symbol", "3"]),
    "no list": ({"parameters": m}, ["list of Parameter"]),
    "circular definition": (
        {"parameters": [m, Parameter(k, definition=c + m), Parameter(c, definition=k - m)]},
        ["definition", "leads back"],
    ),
    "undeclared in a definition": (
        {"parameters": [m, Parameter(k, definition=c + m)]},
        ["definition of k", "c", "Parameter("],
    ),
    "definition in time": (
        {"parameters": [m, Parameter(k, definition=m * t)]},
        ["definition of k", "time"],
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refused_by_name(case: str) -> None:
    changes, expected = REFUSED[case]
    with pytest.raises(ModelError) as caught:
        build(**changes)
    for phrase in expected:
        assert phrase in str(caught.value)


names = st.one_of(
    st.text(min_size=1, max_size=8),
    st.sampled_from([*keyword.kwlist, "", r"\omega", "K b", "1st", "ϕ", "x-y", "a.b"]),
)


@given(names)
def test_names_are_usable_as_keyword_arguments(name: str) -> None:
    """Accepted is exactly what Python can pass by keyword under that very name."""
    try:
        # the definition of "usable", by Python itself and not by its list of keywords
        compiled = compile(f"def f(*, {name}): pass", "names", "exec")
        arguments = compiled.co_consts[0].co_varnames
        usable = arguments == (name,)
    except (SyntaxError, ValueError, UnicodeEncodeError):
        usable = False
    if name in {"m", "k", "q", "t"}:
        return
    try:
        build(parameters=[m, k, sp.Symbol(name)])
    except ModelError as error:
        assert not usable
        assert repr(name) in str(error)
    else:
        assert usable


def test_from_equations() -> None:
    w, h = sp.symbols("w h", positive=True)
    equations = [sp.Eq(q.diff(t, 2) + w**2 * q, h * p**3), p.diff(t, 2) + p * sp.cos(t) ** 2]
    model = Model.from_equations(equations, [q, p], [w, h])
    eom = model.equations_of_motion()
    assert eom.equations == (
        q.diff(t, 2) + w**2 * q - h * p**3,
        p.diff(t, 2) + p / 2 + p * sp.cos(2 * t) / 2,
    )
    assert model.lagrangian is None
    assert "ddot{q}" in model._repr_latex_()
    assert "dot{q}" in build()._repr_latex_()


def test_from_a_single_equation_too_few() -> None:
    with pytest.raises(ModelError, match="1 equations for 2 coordinates"):
        Model.from_equations([q.diff(t, 2) + p], [q, p], [])


@pytest.mark.parametrize(
    ("equations", "phrases"),
    [
        ([q.diff(t, 2) + q, q.diff(t, 2) + q + dp], ["p(t)", "no kinetic energy"]),
        ([q.diff(t, 2) + p.diff(t, 2), q + p], ["equation 2", "no second derivative"]),
        ([q.diff(t, 3) + q, p.diff(t, 2)], ["equation 1", "second order at most"]),
        ([q.diff(t, 2) + k * q, p.diff(t, 2)], ["equation 1", "undeclared symbol k"]),
        ([q.diff(t, 2) + 0.1 * q, p.diff(t, 2)], ["equation 1", "0.1", "Rational"]),
        ([sp.Eq(q.diff(t, 2), 0.1 * q), p.diff(t, 2)], ["equation 1", "0.1", "Rational"]),
        ([sp.true, p.diff(t, 2)], ["equation 1", "scalar SymPy expression"]),
        (["q", p.diff(t, 2)], ["equation 1", "text", "not evaluated"]),
        (q.diff(t, 2), ["must be a list"]),
    ],
)
def test_equations_refused(equations: Any, phrases: list[str]) -> None:
    with pytest.raises(ModelError) as caught:
        Model.from_equations(equations, [q, p], [m])
    for phrase in phrases:
        assert phrase in str(caught.value)


def test_either_lagrangian_or_equations() -> None:
    with pytest.raises(ModelError, match="either"):
        build(equations=(q.diff(t, 2),))


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: Model(dq**2, None, []),
        lambda: Model(dq**2, [q], None),
        lambda: Model(dq**2, [q], 3),
        lambda: Model(dq**2, [q], [], forces=None),
        lambda: Model(dq**2, [q], [], forces=[q]),
        lambda: Model.from_equations(None, [q], []),
        lambda: Model.from_equations([q.diff(t, 2)], None, []),
        lambda: Model.from_equations([q.diff(t, 2)], [q], None),
        lambda: Parameter(sp.Symbol("w"), 1, "x"),
        lambda: Parameter(sp.Symbol("w"), "1", None),
        lambda: Parameter(sp.Symbol("w"), definition=3),
    ],
)
def test_arguments_of_the_wrong_kind_are_refused(wrong: object) -> None:
    with pytest.raises(ModelError, match=r"must be (a list|a mapping|text|a SymPy)"):
        wrong()
