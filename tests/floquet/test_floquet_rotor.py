"""Ground resonance: Floquet against the multiblade equations and published numbers."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from floquet_systems import (
    TIME,
    distance_modulo,
    isotropic,
    linear,
    multiblade_exponents,
    rotor,
)

from mmsgen import floquet

HERTZ = 2 * np.pi


def test_agrees_with_the_multiblade_equations_at_every_speed() -> None:
    # 1e-9 s⁻¹ is what the reference promises; where its own estimate is smaller than that, the
    # estimate must hold as well (1e-11 is left for the multiblade eigenvalues, which are
    # conditioned like the multipliers: eps · 50 s⁻¹ · a few hundred).
    speeds = HERTZ * np.linspace(1, 8, 141)
    result = floquet.exponents(rotor(), isotropic(Omega=speeds))
    assert result.value.shape == (141, 12)
    assert np.all(result.error < 1e-9)
    for speed, value, error in zip(speeds, result.value, result.error, strict=True):
        distance = distance_modulo(value, multiblade_exponents(speed), speed)
        assert distance.max() < 1e-9
        assert np.all(distance <= error + 1e-11)


@pytest.mark.parametrize("blades", [3, 5])
def test_agrees_with_the_multiblade_equations_for_other_numbers_of_blades(blades: int) -> None:
    speeds = HERTZ * np.linspace(1.5, 7.5, 13)
    result = floquet.exponents(rotor(blades), isotropic(blades, Omega=speeds))
    for speed, value in zip(speeds, result.value, strict=True):
        assert distance_modulo(value, multiblade_exponents(speed, blades), speed).max() < 1e-9


def test_coupled_frequencies_at_33_rad_per_second() -> None:
    # Known to ten decimals, multiblade equations of the undamped rotor at these numbers.
    known = np.array([19.0880287552, 21.6131048419, 24.6101094693, 45.3153929059])
    value = floquet.exponents(rotor(), isotropic(Omega=33.0)).value
    for frequency in known:
        # The fixed-frame modes are seen modulo iΩ.
        distance = np.abs((value.imag - frequency + 16.5) % 33.0 - 16.5).min()
        assert distance < 1e-10


def test_zone_edges_of_the_isotropic_rotor() -> None:
    # Known to thirteen decimals in Hz; the estimate of the error must be as good.
    known = [4.4502080451259, 5.0320592577578, 5.4947813208074, 6.3663311352138]
    result = floquet.boundary(rotor(), isotropic(), "Omega", (4 * HERTZ, 7 * HERTZ), points=41)
    assert np.all(result.error < HERTZ * 1e-9)
    assert np.all(np.abs(result.value - HERTZ * np.array(known)) <= result.error + HERTZ * 1e-12)
    assert len(result.zones) == 2


def test_largest_growth_of_the_isotropic_rotor() -> None:
    # Printed with six decimals.
    result = floquet.growth_rate(rotor(), isotropic(Omega=HERTZ * np.array([4.7435, 5.9264])))
    np.testing.assert_allclose(result.value, [0.846554, 1.216064], atol=6e-7)
    assert result.verdict.tolist() == ["unstable", "unstable"]


def test_one_blade_with_half_the_lag_stiffness() -> None:
    # Known to six decimals in Hz. The narrow zones are 0.009 Hz wide: a scan around each finds
    # them, and the wide ones, in few points.
    known = [
        (2.968358, 2.977730),
        (3.447717, 3.462331),
        (3.941025, 3.955095),
        (4.154279, 4.491269),
        (4.526819, 5.037609),
        (5.222633, 6.340248),
    ]
    values = isotropic(omega_b1=3 * np.pi * 0.5**0.5)
    for low, high in known:
        margin = (high - low) / 20  # the next zones are further away
        interval = (HERTZ * (low - margin), HERTZ * (high + margin))
        result = floquet.boundary(rotor(), values, "Omega", interval, points=8)
        np.testing.assert_allclose(result.value / HERTZ, [low, high], atol=6e-7)
        assert np.all(result.error < 1e-8)


def hammond(blades: int = 4) -> object:
    """Hammond's rotor (1974), Lagrangian form, in slug, ft, lb and s."""
    speed = sp.Symbol("Omega", positive=True)
    moment, inertia, offset = sp.Integer(65), sp.Integer(800), 1
    mass, damping, stiffness = sp.zeros(6), sp.zeros(6), sp.zeros(6)
    for j, (hub, damper) in enumerate(((550, 3500), (225, 1750))):
        mass[j, j] = hub + blades * sp.Rational(13, 2)
        damping[j, j], stiffness[j, j] = damper, 85000
    for k in range(blades):
        j = k + 2
        azimuth = speed * TIME + 2 * sp.pi * k / sp.Integer(blades)
        for row, arm in ((0, -moment * sp.sin(azimuth)), (1, moment * sp.cos(azimuth))):
            mass[row, j] = mass[j, row] = arm
            damping[row, j] = 2 * sp.diff(arm, TIME)
            stiffness[row, j] = sp.diff(arm, TIME, 2)
        mass[j, j], damping[j, j] = inertia, 3000
        stiffness[j, j] = offset * moment * speed**2
    return linear(mass, damping, stiffness)


def test_hammond_rotor() -> None:
    # J. Am. Helicopter Soc. 19(4), 1974; recomputed to twelve decimals.
    speeds = np.array([100, 200, 250, 300]) * np.pi / 30
    known = [-1.870701996975, -0.992341165396, -0.329375382436, -0.734830831711]
    result = floquet.growth_rate(hammond(), {"Omega": speeds})
    assert np.all(np.abs(result.value - known) <= result.error + 1e-12)
    assert np.all(result.error < 1e-9)
    assert set(result.verdict) == {"stable"}


def test_undamped_rotor_outside_its_zones_is_stable() -> None:
    # Idle blade modes and all others have real parts of ±1e-16: not a reason to be unstable, and
    # the double multipliers of the idle blades not one to be undecided.
    result = floquet.growth_rate(rotor(), isotropic(Omega=HERTZ * np.linspace(1, 4.4, 18)))
    assert set(result.verdict) == {"stable"}
    assert np.all(result.error < 1e-9)


def test_the_equations_of_the_model_agree_with_those_written_by_hand() -> None:
    # From the nonlinear Lagrangian, linearised, in two sets of parameters; ω_φ has a definition.
    from rotor import at_speed, helicopter, in_ratios, paper_values, undamped
    from rotor import isotropic as alike

    ratios = in_ratios(undamped(alike(helicopter(4).equations_of_motion().linearise())))
    speeds = HERTZ * np.array([2.0, 4.7435, 5.3, 5.9264])
    by_hand = floquet.growth_rate(rotor(), isotropic(Omega=speeds))
    for eom in (ratios, at_speed(ratios)):
        values = {**paper_values(ratios), "Omega": speeds}
        result = floquet.growth_rate(eom, values)
        assert np.all(np.abs(result.value - by_hand.value) <= result.error + by_hand.error)
        assert result.verdict.tolist() == by_hand.verdict.tolist()


def test_no_wrong_verdict_close_to_an_edge() -> None:
    # The edge is known to 5e-14 Hz. Undecided is allowed where √E reaches the resolution, 1e-11 Hz
    # away at most; a verdict on the wrong side never.
    distance = np.logspace(-12, -3, 10)
    edge = 4.4502080451259
    outside = floquet.growth_rate(rotor(), isotropic(Omega=HERTZ * (edge - distance)))
    inside = floquet.growth_rate(rotor(), isotropic(Omega=HERTZ * (edge + distance)))
    assert "unstable" not in outside.verdict and "stable" not in inside.verdict
    assert set(outside.verdict[distance > 1e-11]) == {"stable"}
    assert set(inside.verdict[distance > 1e-11]) == {"unstable"}
