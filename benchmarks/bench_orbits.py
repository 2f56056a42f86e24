"""Periodic orbits of the exact equations, run with ``make bench``.

The same response curve as the emitted `frequency_response` of ``bench_nonlinear.py`` (one
amplitude, order 1), followed by pseudo-arclength continuation through both folds: how much slower
the reference is. The emitted curve has 10,000 frequencies, this one some thirty orbits.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

import mmsgen as mg

VALUES = {"omega_0": 1.0, "alpha": 1.0, "mu": 0.05, "K": 0.2}
START, END = 0.7, 1.6


def problem() -> mg.orbits.Problem:
    """u'' + 2μu' + ω₀²u + αu³ = K cos Ωt at the lowest frequency."""
    t, u = dynamicsymbols._t, dynamicsymbols("u")
    omega_0, alpha, mu, K, Omega = sp.symbols("omega_0 alpha mu K Omega", positive=True)
    left = u.diff(t, 2) + 2 * mu * u.diff(t) + omega_0**2 * u + alpha * u**3
    parameters = [mg.Parameter(s) for s in (omega_0, alpha, mu, K, Omega)]
    model = mg.Model.from_equations([left - K * sp.cos(Omega * t)], [u], parameters)
    return mg.orbits.problem(model.equations_of_motion(), {**VALUES, "Omega": START})


def test_one_orbit(benchmark: Any) -> None:
    own = problem()
    orbit = benchmark(mg.orbits.find, own, [[0.3, 0.0, -0.3, 0.0], [0.0, -0.2, 0.0, 0.2]])
    assert orbit.verdict == "stable"


def test_continuation_through_folds(benchmark: Any) -> None:
    own = problem()
    orbit = mg.orbits.find(own, [[0.3, 0.0, -0.3, 0.0], [0.0, -0.2, 0.0, 0.2]])
    path = benchmark.pedantic(
        mg.orbits.follow, (own, orbit, "Omega", END), rounds=3, warmup_rounds=1
    )
    assert path.reason == "reached"
    assert len(path.folds) == 2
