"""A rotor whose blades differ in mass: the notebook, its force, and its equilibria."""

from __future__ import annotations

import numpy as np
import pytest
import rotor
import sympy as sp
from entries import ROOT, certificates, demand_fits, demand_notebook

from mmsgen import orbits
from mmsgen.certify import scaled_values
from mmsgen.equations import EquationsOfMotion
from mmsgen.motion import reconstruction

NAME = "ground_resonance_forced"
SHARES = {"e_1": 0.06, "e_2": -0.02, "e_3": 0.01}


def unlike(blades: int) -> EquationsOfMotion:
    return rotor.in_ratios(rotor.unlike_masses(rotor.helicopter(blades).equations_of_motion()))


@pytest.mark.pinned
def test_the_notebook_is_that_of_the_script() -> None:
    demand_notebook(NAME)


def test_certificates() -> None:
    found = certificates(NAME)
    assert len(found) == 4
    for data in found.values():
        # generic values: no error term vanishes, and the next one is small beside it
        demand_fits(data, 0.1)


def test_figures() -> None:
    for ending in ("", "_x", "_y"):
        assert (ROOT / "docs" / "figures" / f"{NAME}{ending}.png").is_file()


def test_blades_that_do_not_differ() -> None:
    eom = unlike(3)
    alike = rotor.in_ratios(rotor.isotropic(rotor.helicopter(3).equations_of_motion()))
    shares = {p.symbol: 0 for p in eom.parameters if p.name.startswith("e_")}
    for old, new in zip(alike.equations, eom.equations, strict=True):
        assert sp.expand(new.subs(shares) - old) == 0


def test_the_force_is_the_first_harmonic_of_the_masses() -> None:
    """d'Alembert's force of centres of gravity at a + b: m e_k (a + b)Ω² in each azimuth."""
    eom = unlike(3)
    names = {p.name: p.symbol for p in eom.parameters}
    arm = names["r_m"] * (1 + names["r_h"]) * rotor.Omega**2
    for j, wave in enumerate((sp.cos, sp.sin)):
        expected = sum(
            arm * names[f"e_{k}"] * wave(rotor.azimuth(k, 3)).expand(trig=True) for k in (1, 2, 3)
        )
        force = eom.f[j].expand(trig=True)
        assert sp.expand(force - expected) == 0


def test_equilibria_beside_periodic_motions() -> None:
    """Three blades, Ω ≈ ω_x, σ = 0.2 ε: order N errs by ε^N of the amplitude.

    From ε = 1/8 to 1/16 what follows changes the slope by some ε, times numbers of order one:
    a tenth is allowed.
    """
    eom = rotor.at_speed(unlike(3))
    small = ["r_m", "r_b", "mu_x", "mu_y", "mu_b", *SHARES]
    scaled = eom.linearise().scale(dict.fromkeys(small, 1), amplitude=1)
    values = {n: rotor.PAPER_VALUES[n] for n in ("r_m", "r_b", "r_a", "r_h", "omega_x", "omega_y")}
    values |= {**SHARES, "mu_x": 0.4, "mu_y": 0.4, "mu_b": 0.4, "omega_phi": 10.1, "sigma": 0.2}
    cases = [scaled.expand(order, {rotor.Omega: rotor.omega_x}) for order in (1, 2)]
    errors = []
    for epsilon in (1 / 8, 1 / 16):
        slow, exact = scaled_values(cases[1], values, epsilon)
        amplitudes = []
        for case in cases:
            symbols = {p.symbol: slow[p.name] for p in case.parameters if p.name in slow}
            rates = [e.subs(symbols) for e in case.slow_flow.autonomous.values()]
            matrix = sp.Matrix(rates).jacobian(case.amplitudes)
            rest = sp.Matrix(rates).subs(dict.fromkeys(case.amplitudes, 0))
            b = np.linalg.solve(np.array(matrix, complex), -np.array(rest, complex).ravel())
            amplitudes.append(b)
        shape = reconstruction(cases[1], slow)

        def guess(t: np.ndarray, shape=shape, b=amplitudes[1]) -> np.ndarray:  # type: ignore[no-untyped-def, type-arg]
            return shape(t, np.repeat(b[:, None], len(t), axis=1))

        orbit = orbits.find(orbits.problem(eom, exact), guess)
        assert orbit.stable
        errors.append([2 * abs(b[0]) / orbit.amplitude(0) - 1 for b in amplitudes])
    slopes = np.log2(np.abs(np.array(errors[0]) / errors[1]))
    assert slopes == pytest.approx([1, 2], abs=0.1)
