"""How emitted functions are called: shapes, types, domains, errors that name the parameter."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np
import pytest
from codegen_systems import CASES, emitted, leading
from hypothesis import assume, example, given
from hypothesis import strategies as st

from mmsgen.runtime import _growth
from mmsgen.runtime._edges import zone

VALUES = {"sigma": 0.1, "r_m": 0.03, "r_b": 0.2, "omega_x": 3.0, "omega_phi": 2.0}
OTHERS = {k: v for k, v in VALUES.items() if k != "sigma"}


def rotor() -> Any:
    return emitted("rotor").module


def test_scalars_give_scalars() -> None:
    rate = rotor().growth_rate(**VALUES)
    assert isinstance(rate, np.float64)
    lower, upper = rotor().boundaries(**OTHERS)
    assert isinstance(lower, np.float64)
    assert isinstance(upper, np.float64)
    assert rotor().slow_flow_matrix(**VALUES).shape == (6, 6)
    assert rotor().characteristic_coefficients(**VALUES).shape == (7,)
    assert rotor().slow_flow(np.ones(6), **VALUES).shape == (6,)


@pytest.mark.filterwarnings("ignore:outside of the validity:UserWarning")
@pytest.mark.parametrize("name", [n for n in CASES if n not in ("duffing", "plain")])
def test_arrays_broadcast_and_agree_with_scalars(name: str) -> None:
    one = emitted(name)
    for function, points in one.reference["functions"].items():
        arguments = points[0]["arguments"]
        names = list(arguments)
        if len(names) == 1:
            continue
        many = dict(arguments)
        factors = np.array([1.0, 1.0625])
        many[names[0]] = arguments[names[0]] * factors[:, None]
        many[names[-1]] = arguments[names[-1]] * np.array([[1.0, 1.125, 0.9375]])
        call = partial(getattr(one.module, function), *leading(points[0]))
        together = np.asarray(call(**many))
        for i in range(2):
            for j in range(3):
                alone = {
                    **arguments,
                    **{names[0]: many[names[0]][i, 0]},
                    **{names[-1]: many[names[-1]][0, j]},
                }
                single = np.asarray(call(**alone))
                found = (
                    together[:, i, j]
                    if single.shape == (2,) and function in ("boundaries", "critical_speeds")
                    else together[i, j]
                )
                # The same operations on the same numbers; LAPACK and root finding to their noise.
                assert np.allclose(found, single, rtol=1e-13, atol=1e-13, equal_nan=True), function


def test_types_shapes_and_layouts() -> None:
    module = rotor()
    base = np.linspace(1.0, 2.0, 24)
    expected = module.growth_rate(**{**VALUES, "omega_phi": base})
    assert expected.dtype == np.float64
    for other in (
        base.reshape(2, 3, 4),
        np.asfortranarray(base.reshape(4, 6)),
        base.reshape(6, 4).T,
    ):
        rates = module.growth_rate(**{**VALUES, "omega_phi": other})
        assert rates.shape == other.shape
        assert rates.dtype == np.float64
        alone = [module.growth_rate(**{**VALUES, "omega_phi": w}) for w in other.ravel()]
        assert rates.ravel().tolist() == alone
    assert (
        module.growth_rate(**{**VALUES, "omega_phi": base.tolist()}).tolist() == expected.tolist()
    )
    single = module.growth_rate(**{**VALUES, "omega_phi": np.float32(2.0), "omega_x": 3})
    assert single == module.growth_rate(**VALUES)
    assert module.growth_rate(**{**VALUES, "sigma": np.array(0.1)}).shape == ()
    assert module.slow_flow_matrix(**{**VALUES, "sigma": base}).dtype == np.complex128
    assert module.slow_flow(np.ones((5, 1, 6)), **{**VALUES, "sigma": base}).shape == (5, 24, 6)


def test_arguments_are_not_changed() -> None:
    values = {k: np.full(3, v) for k, v in VALUES.items()}
    before = {k: v.copy() for k, v in values.items()}
    rotor().growth_rate(**values)
    rotor().slow_flow_matrix(**values)
    assert all((values[k] == before[k]).all() for k in values)


@pytest.mark.parametrize("shape", [(0,), (0, 3), (2, 0, 1)])
@pytest.mark.parametrize("name", ["rotor", "coupled", "pair"])
def test_empty_arrays(name: str, shape: tuple[int, ...]) -> None:
    one = emitted(name)
    n = len(one.module.VARIABLES)
    trailing = {
        "slow_flow_matrix": (n, n),
        "characteristic_coefficients": (n + 1,),
        "slow_flow": (len(one.module.COORDINATES),),
        "response": (len(one.module.COORDINATES),),
        "evolution": (len(one.module.COORDINATES),),
    }
    for function, points in one.reference["functions"].items():
        arguments = dict(points[0]["arguments"])
        arguments[next(iter(arguments))] = np.empty(shape)
        result = getattr(one.module, function)(*leading(points[0]), **arguments)
        for part in result if isinstance(result, tuple) else (result,):
            assert part.shape == (*shape, *trailing.get(function, ()))


def test_blocks_do_not_show() -> None:
    # More points than are evaluated together, in every layout of the broadcast.
    module = rotor()
    n = 40_000
    speeds = np.linspace(1.0, 3.0, n)
    whole = module.growth_rate(**{**VALUES, "omega_phi": speeds})
    parts = [module.growth_rate(**{**VALUES, "omega_phi": s}) for s in np.split(speeds, 8)]
    assert (whole == np.concatenate(parts)).all()
    grid = module.growth_rate(
        **{**VALUES, "omega_phi": speeds[:250, None], "sigma": np.linspace(-0.1, 0.1, 300)}
    )
    rows = [
        module.growth_rate(**{**VALUES, "omega_phi": s, "sigma": np.linspace(-0.1, 0.1, 300)})
        for s in speeds[:250]
    ]
    assert (grid == np.stack(rows)).all()
    long = module.boundaries(**{**OTHERS, "omega_phi": np.stack([speeds, speeds[::-1]])})
    assert (long[0][0] == long[0][1][::-1]).all()
    assert long[1].shape == (2, n)


# --- errors ---------------------------------------------------------------------------------------


BAD = {
    "negative": -1.0,
    "zero": 0.0,
    "nan": math.nan,
    "infinite": math.inf,
    "complex": 1.0 + 1.0j,
    "text": "3",
    "none": None,
    "boolean": True,
    "object": [1.0, None],
    "ragged": [[1.0], [1.0, 2.0]],
    "one of many": np.array([1.0, 2.0, -3.0]),
    "last of many": np.array([1.0, 2.0, np.nan]),
}


@pytest.mark.parametrize("kind", BAD)
@pytest.mark.parametrize("function", ["growth_rate", "boundaries", "critical_speeds", "slow_flow"])
def test_values_out_of_their_domain_are_named(function: str, kind: str) -> None:
    values = dict(VALUES if function in ("growth_rate", "slow_flow") else OTHERS)
    if function == "critical_speeds":
        values = {**values, "r_a": 0.2, "omega_b": 1.0}
        del values["omega_phi"]
    leading = [np.ones(6)] if function == "slow_flow" else []
    with pytest.raises(ValueError, match=r"^omega_x must be ") as caught:
        getattr(rotor(), function)(*leading, **{**values, "omega_x": BAD[kind]})
    if kind not in ("ragged", "object"):
        shown = {"one of many": "-3.0", "last of many": "nan"}.get(kind, str(BAD[kind]))
        assert shown in str(caught.value)
    if kind == "last of many":
        assert "index 2" in str(caught.value)


def test_domains_follow_from_the_symbols() -> None:
    damped = emitted("damped").module
    assert damped.growth_rate(sigma=-0.1, omega=1.0, f=0.2, mu=0.0) > 0
    with pytest.raises(ValueError, match="mu must be finite and not negative, got"):
        damped.growth_rate(sigma=-0.1, omega=1.0, f=0.2, mu=-1e-300)
    with pytest.raises(ValueError, match="sigma must be finite, got"):
        damped.growth_rate(sigma=-np.inf, omega=1.0, f=0.2, mu=0.0)


def test_unknown_and_missing_parameters_are_named() -> None:
    with pytest.raises(TypeError, match="omega_z"):
        rotor().growth_rate(**VALUES, omega_z=1.0)
    with pytest.raises(TypeError, match="r_b"):
        rotor().growth_rate(**{k: v for k, v in VALUES.items() if k != "r_b"})
    with pytest.raises(TypeError, match="positional"):
        rotor().growth_rate(*VALUES.values())


@pytest.mark.parametrize(
    ("amplitudes", "message"),
    [
        (np.ones(5), "shape"),
        (1.0, "shape"),
        (np.array([1, 1, 1, 1, 1, np.nan]), "finite"),
        (["a"] * 6, "complex"),
    ],
)
def test_amplitudes_are_checked(amplitudes: Any, message: str) -> None:
    with pytest.raises(ValueError, match=rf"amplitudes must .*{message}"):
        rotor().slow_flow(amplitudes, **VALUES)


@given(
    st.lists(st.floats(allow_nan=True, allow_infinity=True), min_size=1, max_size=6),
    st.sampled_from(["sigma", "r_m", "omega_phi"]),
)
@example([1e308, 5e-324], "omega_phi")
def test_refused_exactly_outside_of_the_domain(values: list[float], name: str) -> None:
    inside = all(math.isfinite(v) and (name == "sigma" or v > 0) for v in values)
    arguments = {**VALUES, name: values}
    if inside:
        assert rotor().growth_rate(**arguments).shape == (len(values),)
    else:
        with pytest.raises(ValueError, match=f"^{name} must be"):
            rotor().growth_rate(**arguments)


@given(st.floats(1e-6, 1e6), st.floats(1e-6, 1e3), st.floats(1e-3, 1e3))
def test_scaling_of_time(omega_x: float, rate: float, factor: float) -> None:
    # All frequencies times a factor: growth rates and edges times the same factor.
    assume(omega_x * factor < 1e9)
    base = {**VALUES, "omega_x": omega_x, "omega_phi": rate}
    scaled = {k: v * (factor if k.startswith(("omega", "sigma")) else 1) for k, v in base.items()}
    one, other = (
        rotor().boundaries(**{k: v for k, v in d.items() if k != "sigma"}) for d in (base, scaled)
    )
    # Seven operations on either side.
    assert np.array(other) == pytest.approx(np.array(one) * factor, rel=16 * 2**-52)


# --- where a formula does not hold ----------------------------------------------------------------


def test_nan_on_a_further_resonance() -> None:
    module = emitted("rotor2").module
    values = {"r_m": 0.03, "r_b": 0.2, "omega_x": 3.0, "omega_phi": 2.0}
    lower, upper = module.boundaries(omega_y=[3.0, 4.0], **values)
    assert np.isnan([lower[0], upper[0]]).all()
    assert np.isfinite([lower[1], upper[1]]).all()
    rate = module.growth_rate(sigma=0.0, omega_y=[3.0, 4.0], **values)
    assert np.isnan(rate[0])
    assert rate[1] > 0
    assert "omega_x - omega_y" in module.__doc__


def test_nan_in_one_factor_is_not_hidden_by_another() -> None:
    nan, inf = np.nan, np.inf
    with np.errstate(invalid="ignore"):
        assert np.isnan(_growth.largest(_growth.growing(nan), 0.0))
        assert np.isnan(_growth.growing(-inf))
        assert np.isnan(_growth.conservative_growth(np.array([nan]), np.array([1.0]), 0.0)).all()
        assert np.isnan(_growth.quadratic_growth(np.array([inf]), np.array([1.0]))).all()
        assert np.isnan(_growth.matrix_growth(2, np.array([nan]), 0.0, 0.0, 1.0)).all()


def test_quadratic_roots_without_cancellation() -> None:
    # (Γ + 1e9)(Γ + 1e-9): the slow root would be lost in b² − 4c.
    assert _growth.quadratic_growth(1e9 + 1e-9, 1.0) == pytest.approx(-1e-9, rel=4 * 2**-52)
    assert _growth.quadratic_growth(0.0, 0.0) == 0.0
    assert _growth.quadratic_growth(-2.0, 1.0) == 1.0


@pytest.mark.filterwarnings("ignore::RuntimeWarning")  # callers switch these off
def test_zone_agrees_with_roots_that_are_known() -> None:
    # −(σ+3)(σ+1)(σ−2)(σ−5) is positive in (−3, −1) and (2, 5): the former is nearer to zero.
    one = np.polynomial.polynomial.polyfromroots([-3, -1, 2, 5]) * -1.0
    assert zone(tuple(one)) == pytest.approx((-3, -1), rel=1e-14)
    assert np.isnan(zone((-1.0, 0.0, -1.0))).all()
    assert np.array(zone((1.0, 0.0, 0.0))).tolist() == [-np.inf, np.inf]
    assert np.array(zone((-1.0, 2.0, 0.0))).tolist() == [0.5, np.inf]
    assert np.isnan(zone((0.0, 0.0, 0.0))).all()
    # Degrees may differ from point to point.
    ends = np.array(zone(([1.0, -1.0, 4.0], 0.0, [-1.0, 0.0, -1.0])))
    assert np.array_equal(ends, [[-1.0, np.nan, -2.0], [1.0, np.nan, 2.0]], equal_nan=True)


def test_shapes_that_do_not_broadcast_are_told_by_name() -> None:
    wrong = {**VALUES, "sigma": np.zeros(3), "r_b": np.full((2, 2), 0.2)}
    with pytest.raises(ValueError, match=r"sigma: \(3,\).*r_b: \(2, 2\)"):
        rotor().growth_rate(**wrong)


def test_masked_values_are_refused() -> None:
    # Without its mask an array would show what is beneath it.
    masked = np.ma.masked_array([0.1, 0.2], [False, True])
    for value in (masked, [masked, masked]):
        with pytest.raises(ValueError, match="sigma has masked values"):
            rotor().growth_rate(**OTHERS, sigma=value)
    amplitudes = np.ma.masked_array(np.ones(6), np.arange(6) == 2)
    with pytest.raises(ValueError, match="array of amplitudes has masked values"):
        rotor().slow_flow(amplitudes, **VALUES)
    with pytest.raises(ValueError, match="array of times has masked values"):
        rotor().evolution(masked, np.ones(6), **VALUES)
    whole = np.ma.masked_array([0.1, 0.2], False)
    assert rotor().growth_rate(**OTHERS, sigma=whole).shape == (2,)
