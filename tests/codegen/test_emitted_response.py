"""The emitted `response`: harmonics, times, shapes, derivatives, and the warning of its limits."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from inspect import signature
from typing import Any

import mpmath
import numpy as np
import pytest
from codegen_systems import emitted
from nonlinear_systems import CASES, functions, nonlinear

from mmsgen.motion import reconstruction

quiet = pytest.mark.filterwarnings("ignore:outside of the validity:UserWarning")

# At ε = 1; what is small is multiplied by ε.
SMALL = {"sigma": 0.7, "sigma_1": 0.3, "sigma_2": 0.2, "alpha": 0.9, "mu": 0.4, "nu": 0.3, "k": 0.8}
LARGE = {"omega": 1.3, "omega_1": 1.1, "K": 1.7, "Omega": 5.1}


def values(name: str, epsilon: float) -> dict[str, float]:
    module = functions(name)
    small = SMALL | (dict.fromkeys(("mu", "nu"), 0.05) if name == "two" else {})
    scaled = {n: epsilon * v for n, v in small.items()} | LARGE
    return {n: scaled[n] for n in module.PARAMETERS}


def equilibrium(name: str, start: Any, given: dict[str, float]) -> Any:
    """By Newton's method on the emitted slow flow and its Jacobian."""
    module, b = functions(name), np.array(start, dtype=complex)
    for _ in range(30):
        rate = module.slow_flow(b, **given)
        right = np.ravel(np.stack([2 * rate.real, 2 * rate.imag], -1))
        step = np.linalg.solve(module.jacobian(b, **given), right)
        b = b - (step[0::2] + 1j * step[1::2]) / 2
    assert np.abs(module.slow_flow(b, **given)).max() < 1e-15
    return b


# --- against what is exact ------------------------------------------------------------------------


def duffing(epsilon: float, size: float, times: Any) -> tuple[Any, float]:
    """x'' + ω²x + αx³ = 0, x = X cn(√(ω² + αX²) t, m): x(t), and the amplitude of cos.

    DLMF 22.11.2 gives the harmonics of cn: (2π/(K√m)) Σ q^{n+1/2}/(1 + q^{2n+1}) cos((2n+1)πt/2K).
    """
    alpha, omega = 0.9 * epsilon, 1.3
    speed = mpmath.sqrt(omega**2 + alpha * size**2)
    m = alpha * size**2 / (2 * speed**2)
    q, quarter = mpmath.qfrom(m=m), mpmath.ellipk(m)
    first = size * 2 * mpmath.pi / (quarter * mpmath.sqrt(m)) * mpmath.sqrt(q) / (1 + q)
    found = [float(size * mpmath.ellipfun("cn", speed * t, m=m)) for t in times]
    return np.array(found), float(first)


@pytest.mark.parametrize(
    ("name", "order", "power"), [("free1", 1, 2), ("free2", 2, 3), ("free2", 1, 2), ("free3", 3, 4)]
)
def test_free_duffing_against_elliptic_functions(name: str, order: int, power: int) -> None:
    """After a few periods the frequency is off by ε^{N+1}, and so are the harmonics.

    Summed through a lower order the first harmonics left out show.
    """
    times, errors = np.linspace(0.0, 9.0, 40), []
    for epsilon in (0.08, 0.04):
        exact, a = duffing(epsilon, 1.0, times)
        given = values(name, epsilon)
        b = np.array([a / 2 + 0j])
        drift = (functions(name).slow_flow(b, **given) / (1j * b)).real
        found = functions(name).response(times, b, **given, order=order, drift=drift)
        errors.append(np.abs(found[:, 0] - exact).max())
    # The following term is smaller by about ε, which shifts the exponent by less than 2ε.
    assert np.log2(errors[0] / errors[1]) == pytest.approx(power, abs=0.16)


STEADY = {
    "primary1": ([-0.17 - 0.10j], 1),
    "primary2": ([-0.17 - 0.10j], 1),
    "super": ([0.01 + 0.15j], 3),
    "two": ([-0.91 + 0.31j, 0.41 - 0.47j], 1),
}
"""Where Newton's method starts, and how many times the drive's frequency that of u is."""


def residual(name: str, epsilon: float, order: int | None = None) -> float:
    """What the unexpanded equations leave of a steady motion, differentiated as a Fourier sum."""
    start, multiple = STEADY[name]
    given = values(name, epsilon)
    b = equilibrium(name, start, given)
    if name == "two":
        omega_2 = 2 * given["omega_1"] + given["sigma_1"]
        drive = omega_2 + given["sigma_2"]
    else:
        drive = (given["omega"] + given["sigma"]) / multiple
    period = (2 if name == "two" else 1) * 2 * np.pi / drive
    times = np.arange(64) * period / 64
    q = functions(name).response(times, b, **given, order=order).T
    turns = 2j * np.pi / period * np.fft.fftfreq(64, 1 / 64)
    v, w = (np.fft.ifft(np.fft.fft(q) * turns**p).real for p in (1, 2))
    alpha, mu = given["alpha"], given["mu"]
    if name == "two":
        force = given["k"] * np.cos(drive * times)
        first = w[0] + given["omega_1"] ** 2 * q[0] + 2 * mu * v[0] + alpha * q[0] * q[1]
        second = w[1] + omega_2**2 * q[1] + 2 * given["nu"] * v[1] + alpha * q[0] ** 2 - force
        return float(np.abs([first, second]).max())
    force = given.get("k", given.get("K", 0.0)) * np.cos(drive * times)
    left = w + given["omega"] ** 2 * q + 2 * mu * v + alpha * q**3 - force
    return float(np.abs(left).max())


@quiet
@pytest.mark.parametrize("name", STEADY)
def test_steady_motions_solve_the_unexpanded_equations(name: str) -> None:
    """What is left falls like ε^{N+1}; one order less is left without the last harmonics."""
    order = CASES[name][1]
    steps = (1 / 64, 1 / 128) if order == 2 else (1 / 512, 1 / 1024)
    whole = [residual(name, e) for e in steps]
    # The next term shifts the exponent by a few ε.
    assert np.log2(whole[0] / whole[1]) == pytest.approx(order + 1, abs=0.1)
    less = [residual(name, e, order - 1) for e in steps]
    assert np.log2(less[0] / less[1]) == pytest.approx(order, abs=0.1)


# --- against the engine ---------------------------------------------------------------------------


@quiet
@pytest.mark.parametrize("name", ["primary2", "super", "sub", "swing", "pol", "rough", "pair"])
def test_through_the_order_below_it_is_the_engines_reconstruction(name: str) -> None:
    case, given = nonlinear(name).case, values(name, 1.0)
    n = len(case.coordinates)
    times = np.linspace(0.0, 3.0, 5)
    b = (np.arange(1, n + 1) - 0.4j)[:, None] * np.linspace(0.5, 1.0, 5)
    wanted = reconstruction(case, given)(times, b)[:n]
    found = functions(name).response(times, b.T, **given, order=case.order - 1)
    # A few dozen products each, of numbers of this size.
    assert found.T == pytest.approx(wanted, rel=1e-12, abs=1e-12 * np.abs(wanted).max())


@pytest.mark.parametrize("name", ["rotor2", "pair", "damped2"])
@quiet
def test_linear_cases_have_it_too(name: str) -> None:
    one = emitted(name)
    point = one.reference["functions"]["response"][0]
    n, given = len(one.case.coordinates), point["arguments"]
    times, b = np.linspace(0.0, 2.0, 3), np.exp(1j * np.arange(3 * n)).reshape(n, 3)
    wanted = reconstruction(one.case, given)(times, b)[:n]
    found = one.module.response(times, b.T, **given, order=one.case.order - 1)
    assert found.T == pytest.approx(wanted, rel=1e-12, abs=1e-12 * np.abs(wanted).max())


def test_without_an_autonomous_frame_it_takes_the_amplitudes_themselves() -> None:
    """u = A e^{iωt} + αA³/(8ω²) e^{3iωt} + c.c.: of two forces in resonance nothing is left."""
    module, times = functions("beats"), np.linspace(0.0, 5.0, 4)
    assert module.FRAME is None
    named = ["initial_amplitudes", "response", "slow_flow"]
    assert [n for n in module.__all__ if n.islower()] == named
    given = {"sigma_1": 0.1, "sigma_2": 0.2, "alpha": 0.1, "k": 0.1, "omega": 1.3}
    a = (0.1 + 0.2j) * np.exp(0.3j * times)
    z = a * np.exp(1.3j * times)
    wanted = 2 * (z + 0.1 * z**3 / (8 * 1.3**2)).real
    found = module.response(times, a[:, None], **given)
    assert found[:, 0] == pytest.approx(wanted, rel=1e-14, abs=1e-15)


# --- shapes and arguments -------------------------------------------------------------------------


def test_shapes() -> None:
    response, given = functions("two").response, values("two", 0.01)
    b = np.array([0.1, 0.2j])
    assert response(1.0, b, **given).shape == (2,)
    assert response(np.zeros(5), b, **given).shape == (5, 2)
    many = {**given, "alpha": np.full((4, 1), given["alpha"])}
    assert response(np.zeros(5), b, **many).shape == (4, 5, 2)
    value, slopes = response(np.zeros(5), np.ones((3, 1, 1, 2)), **many, gradient=True)
    assert value.shape == (3, 4, 5, 2)
    assert set(slopes) == set(given)
    assert all(s.shape == value.shape for s in slopes.values())
    lost = response([0.0, 1.0], [[np.nan, 1.0], [0.1, 0.2]], **given)
    assert np.isnan(lost[0]).any() and np.isfinite(lost[1]).all()
    assert response(np.zeros(0), b, **given).shape == (0, 2)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([0.0, np.nan], [0.1]), "the time must be real and finite"),
        ((1j, [0.1]), "the time must be real"),
        ((0.0, [0.1, 0.2]), "amplitudes must have the shape"),
        ((0.0, [np.inf]), "amplitudes must be finite"),
        ((np.zeros(3), np.zeros((2, 1))), "shapes that do not broadcast together: the time"),
    ],
)
def test_what_is_no_time_or_amplitude(arguments: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        functions("free1").response(*arguments, **values("free1", 0.1))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"order": 3}, "order must be from 0 to 2"),
        ({"order": -1}, "order must be from 0 to 2"),
        ({"order": 1.0}, "order must be a whole number"),
        ({"order": True}, "order must be a whole number"),
        ({"drift": 0.1}, "drift must be real, of the shape"),
        ({"drift": [np.inf]}, "drift must be finite"),
        ({"drift": [1j]}, "drift must be real"),
        ({"alpha": -1.0}, "alpha must be positive"),
    ],
)
def test_what_is_no_order_drift_or_parameter(options: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        functions("free2").response(0.0, [0.1], **{**values("free2", 0.1), **options})


def test_where_a_harmonic_resonates_there_is_no_number() -> None:
    """The force at Ω = 2ω_1 = ω_2, which the case takes to be far from there."""
    given = {**values("pair", 0.01), "sigma": 0.0}
    speeds = {"Omega": np.array([5.0, 2 * given["omega_1"]])}
    with pytest.warns(UserWarning, match="amounts to inf"):
        found = functions("pair").response(0.0, [0.1, 0.1], **{**given, **speeds})
    assert np.isfinite(found[0]).all()
    assert np.isnan(found[1]).all()


# --- derivatives ----------------------------------------------------------------------------------


def differences(function: Callable[..., Any], given: dict[str, float], name: str) -> Any:
    """A central difference of the fourth order."""
    h = 1e-3 * abs(given[name])
    at = {k: function(**{**given, name: given[name] + k * h}) for k in (-2, -1, 1, 2)}
    return (at[-2] - 8 * at[-1] + 8 * at[1] - at[2]) / (12 * h)


@quiet
@pytest.mark.parametrize("name", ["primary2", "super", "pol", "rough", "two"])
def test_derivatives_by_every_parameter(name: str) -> None:
    given = values(name, 0.3)
    b = np.array([0.4 - 0.3j, 0.2 + 0.1j])[: len(nonlinear(name).case.coordinates)]
    drift = {"drift": [0.2]} if name in ("pol", "rough") else {}

    def motion(**arguments: Any) -> Any:
        return functions(name).response(np.array([0.0, 1.5]), b, **arguments, **drift)

    value, slopes = motion(**given, gradient=True)
    assert (value == motion(**given)).all()
    for parameter, slope in slopes.items():
        other = differences(motion, given, parameter)
        # The relative step to the fourth power over 30, of a fifth derivative that grows with the
        # powers of 1/ω and with (ωt)⁵: 1e-12/30·10⁴; and 1e-16/1e-3 of rounding.
        size = np.abs(value).max() / given[parameter]
        assert np.abs(slope - other).max() < 1e-9 * (size + np.abs(other).max()), parameter


# --- limits ---------------------------------------------------------------------------------------


def test_inside_of_the_scaling_there_is_no_warning() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        functions("free1").response(0.0, [0.5], alpha=0.1, omega=1.0)
        functions("free1").response(0.0, [0.0], alpha=0.1, omega=1.0)
        functions("rough").response(0.0, [0.5], mu=0.1, nu=0.1, omega=1.0)
        # from rest, where the force alone moves the amplitude
        given = {"sigma": 0.0, "alpha": 0.1, "k": 0.1, "mu": 0.01, "omega": 1.0}
        functions("primary1").response(0.0, [1e-9], **given)


def test_outside_of_the_scaling_a_warning_says_by_how_much() -> None:
    # The largest term of the slow flow over ω|B|: 3αa²/8ω² = 1.5; order 1 leaves out its square.
    with pytest.warns(UserWarning, match=r"amounts to 1\.5 here.*order 1 are estimated at 2\.2 "):
        functions("free1").response(0.0, [1.0], alpha=1.0, omega=1.0)
    # The one bad point of many counts, what is missing does not.
    with pytest.warns(UserWarning, match=r"amounts to 1\.5 here"):
        functions("free1").response(0.0, [[0.1], [1.0], [np.nan]], alpha=1.0, omega=1.0)
    # Not the rate of the slow flow, but harmonics that are too large: a linear case, near another
    # resonance, where 2f/(ω_x² − (Ω ± ω_φ)²) is no small number.
    with pytest.warns(UserWarning, match="outside of the validity"):
        emitted("rotor2").module.response(
            0.0, np.ones(6), sigma=0.0, r_m=0.03, r_b=0.2, omega_x=3.0, omega_phi=2.0, omega_y=3.001
        )


@pytest.mark.parametrize("unit", [1e-6, 1e6])
def test_units_of_a_coordinate_do_not_matter(unit: float) -> None:
    """u_1'' + … = α_1 u_1 u_2 and u_2'' + … = α_2 u_1² + …, with u_2 in another unit."""
    from mms_functions.internal_resonance_1_2 import omega_2_is_two_omega_1_order_1 as module

    names = signature(module.response).parameters
    given = {n: 0.3 for n in names if n not in ("t", "amplitudes", "order", "drift", "gradient")}
    given |= {"alpha_1": 2.0, "alpha_2": 3.0, "omega_1": 1.0}
    texts = []
    for scale in (1.0, unit):
        own = {**given, "alpha_1": 2.0 / scale, "alpha_2": 3.0 * scale}
        own |= {n: x * scale for n, x in given.items() if n == "F_2"}
        with pytest.warns(UserWarning) as caught:
            module.response(0.0, [0.7, 0.4 * scale], **own)
        texts.append(str(caught[0].message))
    assert texts[0] == texts[1]


def test_a_coordinate_that_hardly_moves_is_no_reason_for_a_warning() -> None:
    """What the second one gets of the first is small beside the first, and gives nothing back."""
    given = {**values("pair", 0.01), "Omega": 9.0}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        functions("pair").response(0.0, [0.1, 1e-9], **given)
        functions("pair").response(0.0, [0.1, 0.0], **given)


def test_a_warning_points_to_the_caller() -> None:
    with pytest.warns(UserWarning) as caught:
        functions("free1").response(0.0, [9.0], alpha=1.0, omega=1.0)
    assert caught[0].filename == __file__


def test_a_missing_amplitude_alone_is_missing_in_silence() -> None:
    # warnings are errors here: NaN in, NaN out, and nothing to be said about sizes
    found = functions("free1").response(0.0, [np.nan], alpha=1.0, omega=1.0)
    assert np.isnan(found).all()


# --- from states ----------------------------------------------------------------------------------


@quiet
@pytest.mark.parametrize("name", [n for n in CASES if n != "beats"])
def test_initial_amplitudes_are_those_of_the_engine(name: str) -> None:
    flow, given = nonlinear(name).case.slow_flow, values(name, 0.05)
    n = len(flow.case.coordinates)
    q, v = np.linspace(0.2, 0.5, 3 * n).reshape(3, n), np.linspace(-0.4, 0.3, n)
    found = functions(name).initial_amplitudes(q, v, **given)
    # The last step of Newton's method is 1e-10, and what follows it a millionth of that.
    assert np.abs(found - flow.initial_amplitudes(given, q, v)).max() < 1e-14
    assert np.abs(functions(name).response(0.0, found, **given) - q).max() < 1e-14


def test_initial_amplitudes_without_an_autonomous_frame() -> None:
    given = {"sigma_1": 0.1, "sigma_2": 0.2, "alpha": 0.01, "k": 0.02, "omega": 1.3}
    a = functions("beats").initial_amplitudes([0.4], [0.1], **given)
    rate = functions("beats").slow_flow(a, **given, t=0.0)[0]
    z, third = a[0], 0.01 / (8 * 1.3**2)
    moving = 1.3j * z + rate
    assert 2 * (z + third * z**3).real == pytest.approx(0.4, rel=1e-13)
    assert 2 * (moving + third * 3 * z**2 * moving).real == pytest.approx(0.1, rel=1e-12)
