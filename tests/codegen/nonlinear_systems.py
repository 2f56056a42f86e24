"""Nonlinear systems whose emitted functions are tested: equations, cases, modules."""

from __future__ import annotations

from functools import cache
from types import ModuleType
from typing import Any

import numpy as np
import sympy as sp
from codegen_systems import Emitted
from sympy.physics.mechanics import dynamicsymbols

from mmsgen.codegen import case_name, render
from mmsgen.equations import EquationsOfMotion
from mmsgen.loading import load_files
from mmsgen.parameters import Parameter

t = dynamicsymbols._t
u, w = dynamicsymbols("u w")
omega, Omega, alpha, k, K = sp.symbols("omega Omega alpha k K", positive=True)
mu, nu = sp.symbols("mu nu", nonnegative=True)
omega_1, omega_2, Omega_2 = sp.symbols("omega_1 omega_2 Omega_2", positive=True)


def _system(equations: list[sp.Expr], coordinates: list[sp.Expr], orders: Any) -> Any:
    symbols = sorted(
        set().union(*(e.free_symbols for e in equations)) - {t}, key=lambda s: str(s.name)
    )
    known = tuple(Parameter(s, "1") for s in symbols)
    return EquationsOfMotion(tuple(equations), tuple(coordinates), known).scale(orders)


def _damped(more: sp.Expr) -> sp.Expr:
    return u.diff(t, 2) + omega**2 * u + 2 * mu * u.diff(t) + alpha * u**3 + more


@cache
def _scaled(name: str) -> Any:
    small = {alpha: 1, mu: 1}
    drive = sp.cos(Omega * t)
    if name == "free":
        return _system([u.diff(t, 2) + omega**2 * u + alpha * u**3], [u], {alpha: 1})
    if name == "soft":
        return _system([_damped(-k * drive)], [u], {**small, k: 1})
    if name == "beats":
        left = u.diff(t, 2) + omega**2 * u + alpha * u**3 - k * drive - k * sp.cos(Omega_2 * t)
        return _system([left], [u], {alpha: 1, k: 1})
    if name == "driven":
        return _system([_damped(-k * drive).subs(alpha, 0)], [u], {mu: 1, k: 1})
    if name == "hard":
        return _system([_damped(-K * drive)], [u], small)
    if name == "swing":
        return _system([_damped(2 * k * drive * u)], [u], {**small, k: 1})
    if name == "pol":
        left = u.diff(t, 2) + omega**2 * u - mu * (1 - u**2) * u.diff(t)
        return _system([left], [u], {mu: 1})
    if name == "rough":
        left = u.diff(t, 2) + omega**2 * u - mu * u.diff(t) + nu * sp.Abs(u.diff(t)) * u.diff(t)
        return _system([left], [u], {mu: 1, nu: 1})
    assert name == "two"
    first = u.diff(t, 2) + omega_1**2 * u + 2 * mu * u.diff(t) + alpha * u * w
    second = w.diff(t, 2) + omega_2**2 * w + 2 * nu * w.diff(t) + alpha * u**2 - k * drive
    return _system([first, second], [u, w], {alpha: 1, mu: 1, nu: 1, k: 1})


CASES: dict[str, tuple[str, int, dict[sp.Expr, sp.Expr] | None]] = {
    "free1": ("free", 1, None),
    "free2": ("free", 2, None),
    "free3": ("free", 3, None),
    "primary1": ("soft", 1, {Omega: omega}),
    "primary2": ("soft", 2, {Omega: omega}),
    "driven": ("driven", 1, {Omega: omega}),
    "super": ("hard", 2, {3 * Omega: omega}),
    "sub": ("hard", 1, {Omega: 3 * omega}),
    "swing": ("swing", 1, {Omega: 2 * omega}),
    "pol": ("pol", 2, None),
    "rough": ("rough", 1, None),
    "two": ("two", 1, {omega_2: 2 * omega_1, Omega: omega_2}),
    "pair": ("two", 1, {omega_2: 2 * omega_1}),
}


BEATS = ("beats", 1, {Omega: omega, Omega_2: omega})
"""Two forces of nearly the same frequency: no frame makes the slow flow autonomous."""


@cache
def nonlinear(name: str) -> Emitted:
    """The emitted functions of one of `CASES`, or of `BEATS`."""
    system, order, relation = BEATS if name == "beats" else CASES[name]
    case = _scaled(system).expand(order=order, resonance=relation)
    files = render(case, model="nonlinear")
    (module,) = load_files(files, [case_name(case)]).values()
    return Emitted(case, files, module)


def functions(name: str) -> ModuleType:
    """The emitted module of one of `CASES`."""
    return nonlinear(name).module


NUMBERS = {
    "sigma": 0.21,
    "sigma_1": 0.03,
    "sigma_2": 0.02,
    "alpha": 0.3,
    "k": 0.25,
    "mu": 0.03,
    "nu": 0.05,
    "omega": 1.3,
    "omega_1": 1.1,
    "K": 1.7,
    "Omega": 5.1,
}

ISOLATED = [name for name in CASES if not name.startswith("free")]


def values(name: str, function: str = "equilibria") -> dict[str, float]:
    """Numbers for the parameters of a function."""
    text = getattr(functions(name), function).__kwdefaults__ or {}
    code = getattr(functions(name), function).__code__
    names = code.co_varnames[code.co_argcount :][: code.co_kwonlyargcount]
    return {n: NUMBERS[n] for n in names if n not in text}


def points(name: str) -> Any:
    """Two rows of amplitudes."""
    n = len(functions(name).COORDINATES)
    return (np.arange(1, n + 1) - 0.4j) * np.array([[0.5], [0.7 + 0.2j]])
