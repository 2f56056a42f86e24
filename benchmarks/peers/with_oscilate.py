"""An example through the public interface of oscilate, as its documentation has it.

    python with_oscilate.py EXAMPLE

prints one line of JSON: seconds from equations to slow flow and for what the example goes on to do,
and the slow flow itself in the user's parameters at ε = 1. Runs in an environment of its own.
"""

from __future__ import annotations

import contextlib
import io
import json
import sys
import time
from typing import Any

import sympy as sp
from oscilate import MMS
from peer_systems import SYSTEMS, System, t

epsilon = sp.Symbol("epsilon", positive=True)


def expand(system: System, table: Any) -> Any:
    """The expansion, to the modulation equations."""
    dynamics = MMS.Dynamical_system(
        t,
        system.coordinates,
        list(system.equations),
        list(system.natural),
        F=system.force,
        fF=list(system.forcing),
    )
    kind = MMS.Multiple_scales_oscillator
    if system.complex_form:
        dynamics.complex_form()
        kind = MMS.Multiple_scales_complex
    expansion = kind(
        dynamics,
        epsilon,
        system.order,
        system.reference,
        table,
        ratio_omegaMMS=system.ratio,
        eps_pow_0=system.amplitude,
        ratio_omega_osc=list(system.ratios),
        detunings=list(system.detunings),
    )
    expansion.apply_MMS(orders_polar="all" if system.motion else 0)
    return expansion


def analyse(system: System, expansion: Any, scaled: dict[sp.Symbol, sp.Symbol]) -> Any:
    """Backbone curve, response, stability or limit cycle, as the example goes on."""
    steady = MMS.Steady_state(expansion)
    for step in system.solve:
        if step == "backbone":
            damping = [scaled[s] for s in system.damping]
            steady.solve_bbc(solve_dof=system.driven, c=damping)
        elif step == "response":
            steady.solve_forced(solve_dof=system.driven)
        elif step == "stability":
            steady.stability_analysis_forced(**system.stability)
        else:
            expansion.solve_transient(solve_dof=system.driven)
            steady.solve_LC(solve_dof=system.driven)
            steady.Jacobian_polar()
    return steady


def plain(expansion: Any) -> dict[str, str]:
    """The modulation equations with plain symbols, in the user's parameters at ε = 1."""
    coordinates = expansion.coord
    names = [(a, sp.Symbol(f"a_{i}")) for i, a in enumerate(coordinates.at)]
    names += [(b, sp.Symbol(f"beta_{i}")) for i, b in enumerate(coordinates.betat)]
    names += [(expansion.sigma, sp.Symbol("sigma"))]
    rates = {}
    for i, (a, b) in enumerate(zip(expansion.sol.fa, expansion.sol.fbeta, strict=True)):
        for name, rate in ((f"da_{i}", a), (f"a_{i} dbeta_{i}", b)):
            own = rate.subs(expansion.sub.sub_B).subs(expansion.sub.sub_scaling_back)
            rates[name] = str(own.subs(epsilon, 1).subs(names))
    return rates


def fundamentals(expansion: Any) -> list[str]:
    """The coefficient of e^{iω_j T0} in each coordinate, in A_j and Ā_j at ε = 1."""
    result = []
    for j, (orders, frequency) in enumerate(
        zip(expansion.sol.xO, expansion.omegas_O0, strict=True)
    ):
        wave = sp.exp(sp.I * frequency * expansion.tS[0])
        total = sp.Add(*orders).expand().subs(expansion.sub.sub_scaling_back).subs(epsilon, 1)
        names = [(a, sp.Symbol(f"A_{i}")) for i, a in enumerate(expansion.coord.A)]
        names += [(expansion.sigma, sp.Symbol("sigma")), (expansion.tS[1], t)]
        bars = [(sp.conjugate(a), sp.Symbol(f"Abar_{i}")) for i, a in enumerate(expansion.coord.A)]
        result.append(str(total.subs(bars).subs(names).expand().coeff(wave)))
    return result


def main() -> None:
    system = SYSTEMS[sys.argv[1]]()
    with contextlib.redirect_stdout(io.StringIO()):
        begun = time.process_time()
        small, table = MMS.scale_parameters(
            tuple(system.small), tuple(system.small.values()), epsilon
        )
        expansion = expand(system, table)
        derived = time.process_time()
        analyse(system, expansion, dict(zip(system.small, small, strict=True)))
        done = time.process_time()
    report = {
        "slow_flow": derived - begun,
        "analysis": done - derived,
        "rates": plain(expansion),
        "fundamentals": fundamentals(expansion) if system.complex_form else [],
    }
    print(json.dumps(report))


if __name__ == "__main__":
    main()
