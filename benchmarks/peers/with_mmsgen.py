"""The examples of the peers with mmsgen: from the same equations to the same results.

    python with_mmsgen.py EXAMPLE

prints one line of JSON: seconds from equations to slow flow, and for what the example goes on to do
with it.
"""

from __future__ import annotations

import json
import sys
import time
from dataclasses import replace
from typing import Any

import autonomous
import sympy as sp
from peer_systems import SYSTEMS, System, t

import mmsgen as mg
from mmsgen.symbols import modulus, phase

Omega = sp.Symbol("Omega", positive=True)
cosine, sine = sp.symbols("cosine sine", real=True)
u = sp.Function("u")(t)


def expand(system: System) -> mg.Expansion:
    """The expansion on the resonance of an example of oscilate."""
    wave = system.force * sp.cos(Omega * t)
    equations = [e - f * wave for e, f in zip(system.equations, system.forcing, strict=True)]
    own = {s for e in equations for s in e.free_symbols} - {t}
    model = mg.Model.from_equations(equations, system.coordinates, sorted(own, key=str))
    resonance = {
        frequency: ratio * system.reference
        for frequency, ratio, detuned in zip(
            system.natural, system.ratios, system.detunings, strict=True
        )
        if detuned != 0 and system.reference.is_Symbol
    }
    if system.force != 0:
        resonance[Omega] = system.ratio * system.reference
    small = {s: p for s, p in system.small.items() if s in own}
    scaled = model.equations_of_motion().scale(small, amplitude=system.amplitude)
    return scaled.expand(system.order, resonance or None)


def at_rest(system: System, flow: mg.SlowFlow) -> tuple[sp.Expr, sp.Expr, sp.Symbol]:
    """da/dt and a dγ/dt of the driven coordinate, all others at rest; its amplitude."""
    q = system.coordinates[system.driven]
    others = {modulus(p): 0 for p in system.coordinates if p != q}
    a, gamma = modulus(q), phase(q)
    radial, angular = flow.polar[a].subs(others), sp.expand(a * flow.polar[gamma]).subs(others)
    return radial, angular, a


def backbone(system: System, flow: mg.SlowFlow) -> Any:
    """σ over the amplitude, without damping and forcing."""
    _, angular, _ = at_rest(system, flow)
    free = angular.subs(dict.fromkeys([*system.damping, system.force], 0))
    sigma = flow.case.relations[-1].detuning
    slope = free.diff(sigma)
    return sp.cancel(-(free - slope * sigma) / slope)


def response(system: System, flow: mg.SlowFlow) -> Any:
    """σ over the amplitude of the steady response: both roots of cos² + sin² = 1."""
    rows = [sp.expand(e) for e in at_rest(system, flow)[:2]]
    waves = sorted(set().union(*(e.atoms(sp.cos, sp.sin) for e in rows)), key=str)
    turned = [e.xreplace({w: cosine if w.func is sp.cos else sine for w in waves}) for e in rows]
    matrix, right = sp.linear_eq_to_matrix(turned, [cosine, sine])
    c, s = matrix.adjugate() * right
    sigma = flow.case.relations[-1].detuning
    curve = sp.expand(sp.fraction(sp.together(c**2 + s**2 - matrix.det() ** 2))[0])
    second, first, constant = (sp.factor_terms(curve.coeff(sigma, k)) for k in (2, 1, 0))
    root = sp.sqrt(first**2 - 4 * second * constant)
    return [(-first + sign * root) / (2 * second) for sign in (1, -1)]


def stability(system: System, flow: mg.SlowFlow) -> Any:
    """Jacobian of the slow flow, its trace and determinant for the driven coordinate."""
    k = 2 * system.driven
    jacobian = flow.jacobian if system.stability["coord"] == "cartesian" else polar_jacobian(flow)
    block = jacobian[k : k + 2, k : k + 2]
    trace, determinant = block.trace(), block.det()
    return jacobian, trace, determinant, sp.sqrt(trace**2 / 4 - determinant)


def polar_jacobian(flow: mg.SlowFlow) -> sp.Matrix:
    return sp.Matrix([[rate.diff(v) for v in flow.polar] for rate in flow.polar.values()])


def limit_cycle(system: System, flow: mg.SlowFlow) -> Any:
    """Amplitudes, their frequencies relative to ω_0, and the Jacobian of the polar slow flow."""
    radial, angular, a = at_rest(system, flow)
    amplitudes = sp.solve(sp.cancel(radial / a), a)
    turning = [sp.cancel((angular / a).subs(a, value)) for value in amplitudes]
    return amplitudes, turning, polar_jacobian(flow)


def motion(system: System) -> list[dict[sp.Expr, sp.Expr]]:
    """The motion to all orders, the highest included: it stands in the expansion of one more."""
    case = expand(replace(system, order=system.order + 1))
    return [case.particular(p) for p in range(system.order + 1)]


STEPS = {
    "backbone": backbone,
    "response": response,
    "stability": stability,
    "limit cycle": limit_cycle,
}


def analyse(system: System, flow: mg.SlowFlow) -> list[Any]:
    """What the example goes on to do: motion, backbone curve, response, stability, limit cycle."""
    results: list[Any] = [motion(system)] if system.motion else []
    return results + [STEPS[name](system, flow) for name in system.solve]


def expand_autonomous(example: autonomous.Autonomous) -> mg.Expansion:
    """The expansion of an example of asymptotics, in a parameter ε."""
    eps = sp.Symbol("eps", positive=True)
    du = u.diff(t)
    small = example.cubic * u**3 + (example.damping + example.pumping * u**2) * du
    equation = du.diff(t) + example.square * u + eps * small
    model = mg.Model.from_equations([equation], [u], [eps])
    return model.equations_of_motion().scale({eps: 1}).expand(example.order)


def frequency(case: mg.Expansion) -> sp.Expr:
    """ω + γ' of a conservative oscillator, over the amplitude of the fundamental."""
    (natural,) = case.weak.scaled.natural_frequencies
    return sp.Rational(natural["1"]) + case.slow_flow.polar[phase(u)]


def main() -> None:
    name = sys.argv[1]
    if name in SYSTEMS:
        system = SYSTEMS[name]()
        begun = time.process_time()
        flow = expand(system).slow_flow
        flow.polar
        derived = time.process_time()
        analyse(system, flow)
    else:
        begun = time.process_time()
        expand_autonomous(autonomous.EXAMPLES[name]).slow_flow.polar
        derived = time.process_time()
    done = time.process_time()
    print(json.dumps({"slow_flow": derived - begun, "analysis": done - derived}))


if __name__ == "__main__":
    main()
