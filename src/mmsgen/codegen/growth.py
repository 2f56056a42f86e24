"""The emitted `growth_rate`: closed form factor by factor where there is one.

A conservative factor of degree one is neutral; one of degree two grows like half the root of its
discriminant, where that is positive; one of a higher degree is real in Λ, Γ = iΛ, and the
eigenvalues of its real companion matrix say exactly which roots are real. A factor with damping has
a closed form up to degree two; beyond that the block of the slow-flow matrix is what LAPACK gets.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain
from typing import Any

import mpmath
import sympy as sp

from ..factoring import MonicFactor
from ..field import Coefficient
from ..ir import compute_ir, fresh
from ..linear_flow import Block
from .exact import exact
from .kernels import EmittedFunction, Kernel, Reference, Statement, called
from .options import gradient_option, wanted
from .rounding import UNIT, Rounded, rounded
from .setting import Setting, values_of

__all__ = ["growth_function"]


@dataclass
class _Plan:
    """The formulas of a growth rate while they are collected.

    Attributes
    ----------
    outputs : dict
        Name → expression.
    rates : dict
        The growth rate of each factor, as a call of the runtime → kind and names of its outputs.
    """

    taken: frozenset[str]
    outputs: dict[str, sp.Expr] = field(default_factory=dict)
    rates: dict[Statement, tuple[str, tuple[str, ...]]] = field(default_factory=dict)

    def output(self, stem: str, expression: sp.Expr) -> str:
        """Name an expression, once."""
        known = next((name for name, e in self.outputs.items() if e == expression), None)
        if known is not None:
            return known
        count = sum(1 for name in self.outputs if name.startswith(f"{stem}_"))
        name = fresh(f"{stem}_{count + 1}", self.taken)
        self.outputs[name] = expression
        return name


def is_conservative(factor: MonicFactor) -> bool:
    """True where the factor is real in Λ, Γ = iΛ."""
    degree = factor.degree
    turned = (c.times_i(k - degree) for k, c in enumerate(factor.coefficients))
    return all(not (c - c.conjugate()) for c in turned)


def _real(c: Coefficient) -> Coefficient:
    return (c + c.conjugate()).scale(Fraction(1, 2))


def _add_conservative(plan: _Plan, factor: MonicFactor, setting: Setting) -> None:
    degree = factor.degree
    if degree == 1:
        plan.rates["", ("0.0",)] = "neutral", ()
    elif degree == 2:
        c, b, _ = factor.coefficients
        name = plan.output("discriminant", setting.parts(b * b - c.scale(4))[0])
        plan.rates["growing", (name,)] = "growing", (name,)
    else:
        turned = (c.times_i(k - degree) for k, c in enumerate(factor.coefficients[:-1]))
        names = tuple(plan.output("coefficient", setting.parts(c)[0]) for c in turned)
        plan.rates["conservative_growth", names] = "conservative", names


def _add_dissipative(plan: _Plan, factor: MonicFactor, setting: Setting) -> None:
    if factor.degree == 1:
        name = plan.output("decay", -setting.parts(_real(factor.coefficients[0]))[0])
        plan.rates["", (name,)] = "linear", (name,)
        return
    c, b, _ = factor.coefficients
    names = tuple(
        plan.output(stem, re + sp.I * im)
        for stem, (re, im) in (("b", setting.parts(b)), ("c", setting.parts(c)))
    )
    plan.rates["quadratic_growth", names] = "quadratic", names


def _add_block(plan: _Plan, block: Block, setting: Setting) -> None:
    names, texts = [], []
    for c in chain.from_iterable(block.entries):
        if not c:
            texts.append("0.0")
            continue
        names.append(plan.output("entry", setting.shown(c)))
        texts.append(names[-1])
    plan.rates["matrix_growth", (str(len(block.nodes)), *texts)] = "matrix", tuple(names)


def _plan(setting: Setting) -> _Plan:
    assert setting.linear is not None
    plan = _Plan(frozenset(p.name for p in setting.parameters))
    for block in setting.linear.blocks:
        closed = all(is_conservative(f) or f.degree <= 2 for f in block.factors)
        if not closed:
            _add_block(plan, block, setting)
            continue
        for factor in block.factors:
            add = _add_conservative if is_conservative(factor) else _add_dissipative
            add(plan, factor, setting)
    if len(plan.rates) > 1 and all(
        kind in ("neutral", "growing", "conservative") for kind, _ in plan.rates.values()
    ):
        plan.rates.pop(("", ("0.0",)), None)  # the others are never below zero
    return plan


def growth_function(setting: Setting) -> EmittedFunction:
    """The function `growth_rate` of a case with a linear slow flow."""
    plan = _plan(setting)
    symbols = [p.symbol for p in setting.parameters]
    ir = compute_ir(f"{setting.name}.growth_rate", symbols, plan.outputs)
    closing, uses = _closing(plan)
    kernel = Kernel("_growth_rate", ir, closing, uses=uses)
    kinds = dict.fromkeys(kind for kind, _ in plan.rates.values())

    def reference(point: Mapping[str, Any]) -> Reference:
        arguments = values_of(point, setting.parameters)
        return _reference(setting, plan, kernel, arguments)

    names = [p.name for p in setting.parameters]
    gradient = gradient_option(names)
    items = ["{evaluate}", "{_growth_rate}", "{arguments}"]
    items.append(wanted(names, gradient) if names else "()")
    result = "In 1/s, float64, in the shape to which the arguments broadcast"
    if names:
        result += (
            "; with gradient this and name -> derivative, 0.0 where modes are neutral and NaN "
            "where they meet, as at edges"
        )

    return EmittedFunction(
        name="growth_rate",
        arguments=setting.parameters,
        body=called("{real_at}", items),
        returns="Any",
        summary="Growth rate of the fastest mode: the largest real part of Γ.",
        description=" ".join(_EXPLAINED[kind] for kind in kinds),
        result=f"{result}.",
        reference=reference,
        kernels=(kernel,),
        uses=("evaluate", "real_at"),
        options=(gradient,) if names else (),
    )


def _closing(plan: _Plan) -> tuple[tuple[Statement, ...], tuple[str, ...]]:
    """The statements that make one rate of all, and what they use of the runtime."""
    called = [call for call, _ in plan.rates if call]
    if len(plan.rates) == 1:
        ((call, items),) = plan.rates
        return ((f"return {call}", items),), tuple(called)
    statements: list[Statement] = []
    terms: list[str] = []
    for call, items in plan.rates:
        if not call:
            terms += items
            continue
        terms.append(fresh(f"rate_{len(terms) + 1}", plan.taken | set(plan.outputs)))
        statements.append((f"{terms[-1]} = {call}", items))
    return (*statements, ("return largest", tuple(terms))), ("largest", *dict.fromkeys(called))


_EXPLAINED = {
    "neutral": "Modes that turn without growing give exactly 0.0.",
    "growing": (
        "Amplitudes grow like exp(Γ t). Where the discriminant of the quadratic in Γ is positive, "
        "the rate is half its root; elsewhere both modes are neutral and the rate is exactly 0.0."
    ),
    "linear": "A mode that is not coupled decays at the rate of its damping.",
    "quadratic": (
        "The larger real part of the roots of Γ² + bΓ + c, each of them found without cancellation."
    ),
    "conservative": (
        "The polynomial of the undamped modes is real in Λ, Γ = iΛ; the eigenvalues of its "
        "companion matrix are exactly real where the modes are neutral, so that the rate is "
        "exactly 0.0 there."
    ),
    "matrix": "The eigenvalues of a block of the slow-flow matrix, all points in one call.",
}


# --- reference values -----------------------------------------------------------------------------


def _reference(
    setting: Setting, plan: _Plan, kernel: Kernel, arguments: Mapping[str, Any]
) -> Reference:
    assert setting.linear is not None
    exact_rate = mpmath.mpf("-inf")
    for factor in setting.linear.factors:
        numbers = [exact(setting.shown(c), arguments) for c in factor.coefficients]
        if is_conservative(factor) and factor.degree == 1:
            exact_rate = max(exact_rate, mpmath.mpf(0))
            continue
        roots = mpmath.polyroots(numbers[::-1], maxsteps=200, extraprec=200)
        rates = [mpmath.re(z) for z in roots]
        noise = mpmath.mpf(10) ** (8 - mpmath.mp.dps) * max(map(abs, roots))
        if is_conservative(factor):  # neutral modes are neutral exactly
            rates = [r if abs(r) > noise else mpmath.mpf(0) for r in rates]
        exact_rate = max(exact_rate, *rates)
    inner = rounded(kernel.ir, arguments)
    errors = [_error(kind, [inner[n] for n in names]) for kind, names in plan.rates.values()]
    return Reference(arguments, (), (exact_rate,), (max(errors),))


def _error(kind: str, inner: list[Rounded]) -> Any:
    """Bound of the error in the growth rate of one factor."""
    if kind == "neutral":
        return mpmath.mpf(0)
    if kind == "linear":
        return inner[0].error
    if kind == "growing":
        d = inner[0]
        rate = mpmath.sqrt(abs(d.value)) / 2
        if d.value < 0 and -d.value > d.error:
            return mpmath.mpf(0)
        return d.error / (8 * rate) + UNIT * rate if rate else mpmath.sqrt(d.error)
    if kind in ("quadratic", "conservative"):
        if kind == "quadratic":
            inner = inner[::-1]
        return _root_error([*inner, Rounded(mpmath.mpf(1), mpmath.mpf(0))])
    return _eigenvalue_error(inner)


def _root_error(polynomial: list[Rounded]) -> Any:
    """Bound for the root of largest real or imaginary part, lowest power first.

    A backward stable method finds the roots of a polynomial whose coefficients are off by a small
    multiple of u of what roots of the largest modulus would make of them.
    """
    values = [c.value for c in polynomial]
    degree = len(values) - 1
    roots = mpmath.polyroots(values[::-1], maxsteps=200, extraprec=200)
    size = max(map(abs, roots))
    slopes = [
        abs(mpmath.fsum(k * c * z ** (k - 1) for k, c in enumerate(values) if k)) for z in roots
    ]
    own = mpmath.fsum(c.error * size**k for k, c in enumerate(polynomial))
    backward = 8 * degree * UNIT * mpmath.fsum(abs(c) * size**k for k, c in enumerate(values))
    return max((own + backward) / slope for slope in slopes if slope) + 2 * UNIT * size


def _eigenvalue_error(entries: list[Rounded]) -> Any:
    """Bound for the eigenvalues of a matrix, the condition of the eigenvectors taken as ten."""
    norm = mpmath.sqrt(mpmath.fsum(abs(e.value) ** 2 for e in entries))
    own = mpmath.sqrt(mpmath.fsum(e.error**2 for e in entries))
    return 10 * (own + 8 * UNIT * norm)
