"""Systems whose emitted functions are tested, and how a JSON of reference values is read."""

from __future__ import annotations

import json
import warnings
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

from mmsgen.codegen import case_name, render
from mmsgen.equations import EquationsOfMotion
from mmsgen.expansion import Expansion
from mmsgen.loading import load_files
from mmsgen.parameters import Parameter

t = dynamicsymbols._t
q, p = dynamicsymbols("q p")
x, y = dynamicsymbols("x y")
omega, Omega, alpha, r_m, r_b, r_a, f = sp.symbols("omega Omega alpha r_m r_b r_a f", positive=True)
omega_x, omega_y, omega_phi, omega_b = sp.symbols(
    "omega_x omega_y omega_phi omega_b", positive=True
)
omega_1, omega_2, f_12, f_21 = sp.symbols("omega_1 omega_2 f_12 f_21", positive=True)
mu, mu_1, mu_2 = sp.symbols("mu mu_1 mu_2", nonnegative=True)

PAPER = {
    "r_m": 1 / 38,
    "r_b": 0.17398418325606767,
    "r_a": 0.034796836651213525**0.5,
    "omega_x": 6 * np.pi,
    "omega_y": 8 * np.pi,
    "omega_b": 3 * np.pi,
}
"""The numbers of the paper named in derivations/rotor.py."""


def parameters(*symbols: sp.Symbol, **definitions: sp.Expr) -> tuple[Parameter, ...]:
    return tuple(Parameter(s, "rad/s", "", definitions.get(s.name)) for s in symbols)


def rotor(blades: int, damping: tuple[sp.Symbol, ...] = ()) -> EquationsOfMotion:
    """The linearised isotropic rotor, in ratios, with the lag frequency at speed.

    `damping`: that of x, of y and of the blades.
    """
    phi = [dynamicsymbols(f"phi_{k}") for k in range(1, blades + 1)]
    zeta = [Omega * t + 2 * sp.pi * sp.Rational(k, blades) for k in range(blades)]
    pairs = list(zip(phi, zeta, strict=True))
    in_x = -r_m * sum((b * sp.sin(z)).diff(t, 2) for b, z in pairs)
    in_y = r_m * sum((b * sp.cos(z)).diff(t, 2) for b, z in pairs)
    equations = [x.diff(t, 2) + omega_x**2 * x + in_x, y.diff(t, 2) + omega_y**2 * y + in_y]
    for b, z in pairs:
        drive = -sp.sin(z) * x.diff(t, 2) + sp.cos(z) * y.diff(t, 2)
        equations.append(b.diff(t, 2) + omega_phi**2 * b + r_b * drive)
    for k, coordinate in enumerate((x, y, *phi)):
        if damping:
            equations[k] += 2 * damping[min(k, 2)] * coordinate.diff(t)
    known = parameters(
        *damping,
        Omega,
        r_m,
        r_b,
        omega_x,
        omega_y,
        omega_phi,
        r_a,
        omega_b,
        omega_phi=sp.sqrt(omega_b**2 + r_a**2 * Omega**2),
    )
    return EquationsOfMotion(tuple(equations), (x, y, *phi), known)


@cache
def _scaled(name: str) -> Any:
    if name == "lossy":
        eom = rotor(4, (mu_1, mu_2, mu))
        return eom.scale({r_m: 1, r_b: 1, mu_1: 1, mu_2: 1, mu: 1})
    if name.startswith("rotor"):
        return rotor(int(name[5:])).scale({r_m: 1, r_b: 1})
    swing = 2 * f * sp.cos(Omega * t)
    one = {
        "mathieu": ((omega**2 + swing) * q, (omega, f, Omega), {f: 1}),
        "damped": (
            2 * mu * q.diff(t) + (omega**2 + swing) * q,
            (omega, f, mu, Omega),
            {f: 1, mu: 1},
        ),
        "duffing": (omega**2 * q + alpha * q**3, (omega, alpha), {alpha: 1}),
        "numeric": ((1 + swing) * q, (f, Omega), {f: 1}),
    }
    if name in one:
        terms, symbols, orders = one[name]
        eom = EquationsOfMotion((q.diff(t, 2) + terms,), (q,), parameters(*symbols))
        return eom.scale(orders)
    assert name == "pair"
    left = q.diff(t, 2) + 2 * mu_1 * q.diff(t) + omega_1**2 * q + 2 * f_12 * sp.cos(Omega * t) * p
    right = p.diff(t, 2) + 2 * mu_2 * p.diff(t) + omega_2**2 * p + 2 * f_21 * sp.cos(Omega * t) * q
    symbols = (omega_1, omega_2, mu_1, mu_2, f_12, f_21, Omega)
    eom = EquationsOfMotion((left, right), (q, p), parameters(*symbols))
    return eom.scale(dict.fromkeys((mu_1, mu_2, f_12, f_21), 1))


SUM = {Omega: omega_x + omega_phi}
BOTH = {Omega: omega_x + omega_phi, omega_y: omega_x}

CASES: dict[str, tuple[str, int, dict[sp.Expr, sp.Expr] | None]] = {
    "rotor": ("rotor4", 1, SUM),
    "rotor2": ("rotor4", 2, SUM),
    "stable": ("rotor4", 1, {Omega: omega_phi - omega_x}),
    "coupled": ("rotor4", 1, BOTH),
    "three": ("rotor3", 1, BOTH),
    "five": ("rotor5", 1, SUM),
    "plain": ("rotor4", 1, None),
    "shifts": ("rotor4", 2, None),
    "lossy": ("lossy", 1, SUM),
    "lossy_both": ("lossy", 1, BOTH),
    "mathieu": ("mathieu", 3, {Omega: 2 * omega}),
    "fundamental": ("mathieu", 2, {Omega: omega}),
    "damped": ("damped", 1, {Omega: 2 * omega}),
    "damped2": ("damped", 2, {Omega: 2 * omega}),
    "pair": ("pair", 1, {Omega: omega_1 + omega_2}),
    "natural": ("mathieu", 1, {2 * omega: Omega}),
    "numeric": ("numeric", 2, {Omega: 2}),
    "duffing": ("duffing", 2, None),
}


@dataclass(frozen=True)
class Emitted:
    """A solved case, the text of its files, and its module."""

    case: Expansion
    files: Mapping[str, str]
    module: ModuleType

    @property
    def text(self) -> str:
        return next(v for k, v in self.files.items() if k.endswith(f"{case_name(self.case)}.py"))

    @property
    def reference(self) -> dict[str, Any]:
        return json.loads(next(v for k, v in self.files.items() if k.endswith(".json")))


@cache
def emitted(name: str) -> Emitted:
    """The emitted functions of one of `CASES`."""
    system, order, relation = CASES[name]
    case = _scaled(system).expand(order=order, resonance=relation)
    files = render(case, model="systems")
    (module,) = load_files(files, [case_name(case)]).values()
    return Emitted(case, files, module)


def number(text: Any) -> Any:
    """A stored value: a decimal string, or a pair of them."""
    if isinstance(text, list):
        return mpmath.mpc(mpmath.mpf(text[0]), mpmath.mpf(text[1]))
    return mpmath.mpf(text)


def leading(point: Mapping[str, Any]) -> list[Any]:
    """What a function takes before its keywords at a stored point: the time, and amplitudes."""
    amplitudes = [[complex(*pair) for pair in point[k]] for k in ("amplitudes",) if k in point]
    return [*(point[k] for k in ("time", "amplitude") if k in point), *amplitudes]


def calls(name: str) -> Iterator[tuple[str, dict[str, float], Any, list[Any], list[Any]]]:
    """`stored` of one of `CASES`."""
    return stored(emitted(name))


def stored(one: Emitted) -> Iterator[tuple[str, dict[str, float], Any, list[Any], list[Any]]]:
    """Every stored point: function, arguments, emitted result (flat), values, error bounds."""
    for function, points in one.reference["functions"].items():
        for point in points:
            arguments = point["arguments"]
            with warnings.catch_warnings():
                # generic points are no places for the method
                warnings.filterwarnings("ignore", "outside of the validity", UserWarning)
                result = getattr(one.module, function)(*leading(point), **arguments)
            if function == "equilibria":
                assert list(result.amplitudes.shape) == point["shape"]
                result = np.concatenate([np.ravel(part) for part in result])
            values = [number(v) for v in point["values"]]
            yield (
                function,
                arguments,
                np.ravel(result),
                values,
                [mpmath.mpf(e) for e in point["errors"]],
            )
