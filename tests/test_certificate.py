"""Fits, digits and the record of a certificate."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, replace
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mmsgen.certificate import TAKEN, Certificate, Fit, Zone, fit_exponent, supported
from mmsgen.errors import CertificateError
from mmsgen.keeping import certificate_key, kept

EPSILONS = tuple(2.0**-k for k in range(3, 15))


def fitted(errors: list[float], epsilons: tuple[float, ...] = EPSILONS, **kwargs: float) -> Fit:
    return fit_exponent("edges", 2, epsilons, errors, [1e-16] * len(errors), **kwargs)


def weights(epsilons: np.ndarray) -> np.ndarray:
    """How the fitted exponent depends on each log(error): a row of the pseudo-inverse."""
    design = np.stack([np.ones_like(epsilons), np.log(epsilons), epsilons], axis=1)
    return np.linalg.pinv(design)[1]


# --- the exponent ---------------------------------------------------------------------------------


@given(st.integers(1, 6), st.floats(1e-3, 1e3), st.integers(4, 12))
def test_an_exact_power_is_recovered(power: int, size: float, count: int) -> None:
    epsilons = EPSILONS[:count]
    errors = [size * e**power for e in epsilons]
    fit = fitted(errors, epsilons, limit=1e-30)
    # log(error) is of size 70 and rounded; the columns have a condition number below 1e2 in the
    # units of the fit, and below 1e4 when only four points at large ε are left
    assert abs(fit.exponent - power) < 70 * 2e-16 * 1e4


@given(
    st.integers(1, 4),
    st.lists(st.floats(-2, 2), min_size=2, max_size=2),
    st.sampled_from([4, 6, 9]),
)
def test_the_next_terms_shift_it_by_what_the_fit_leaves_out(
    power: int, further: list[float], count: int
) -> None:
    """For ε^p(1 + aε + bε²): aε is fitted, the rest of the logarithm moves the exponent.

    The fit is linear in the logarithms, so its shift is the weighted sum of that rest.
    """
    a, b = further
    e = np.array(EPSILONS[:count])
    factor = 1 + a * e + b * e**2
    fit = fitted(list(e**power * factor), EPSILONS[:count], limit=1e-30)
    taken = np.sort(e)[:TAKEN]
    rest = np.log(1 + a * taken + b * taken**2) - a * taken
    bound = np.abs(weights(taken)) @ np.abs(rest)
    assert abs(fit.exponent - power) <= bound + 1e-10
    if count == 9:
        assert bound < 0.05  # what TOLERANCE allows for, and more


@given(st.lists(st.floats(-1, 1), min_size=12, max_size=12), st.floats(1e-8, 1e-2))
def test_noise_shifts_it_in_proportion(noise: list[float], level: float) -> None:
    errors = [e**2 * (1 + level * x) for e, x in zip(EPSILONS, noise, strict=True)]
    fit = fitted(errors, limit=1e-30)
    taken = np.sort(np.array(EPSILONS))[:TAKEN]
    bound = np.abs(weights(taken)).sum() * -np.log1p(-level)
    assert abs(fit.exponent - 2) <= bound + 1e-10


@pytest.mark.parametrize("part", [1e-3, -1e-3, 1e-2, 1.0])
def test_a_small_error_of_lower_order_is_seen(part: float) -> None:
    assert fitted([e**2 for e in EPSILONS]).passed
    assert not fitted([abs(e**2 + part * e) for e in EPSILONS]).passed


def test_a_higher_exponent_passes() -> None:
    assert fitted([e**3 for e in EPSILONS], limit=1e-20).passed


def test_unresolved_points_do_not_matter() -> None:
    """Whatever stands below the floors, below the limit, or where there is no number."""
    epsilons = EPSILONS[:8]
    errors = [e**2 for e in epsilons]
    floors = [1e-16] * 8
    plain = fit_exponent("edges", 2, epsilons, errors, floors)
    for error, floor in (
        (1e-10, 1e-16),
        (0.0, 0.0),
        (3.0, 0.2),
        (1e-3, np.inf),
        (np.nan, np.inf),
        (np.inf, 0.0),
    ):
        fit = fit_exponent("edges", 2, (*epsilons, 2.0**-12), [*errors, error], [*floors, floor])
        assert fit.exponent == plain.exponent
        assert fit.resolved == (*(True,) * 8, False)
        assert len(fit.as_dict()["points"]) == 8


def test_order_of_the_points_does_not_matter() -> None:
    errors = [e**2 * (1 + e) for e in EPSILONS]
    turned = fit_exponent("edges", 2, EPSILONS[::-1], errors[::-1], [1e-16] * 12)
    assert turned.exponent == fitted(errors).exponent


@pytest.mark.parametrize("count", [0, 1, 3])
def test_fewer_than_four_resolved_points_are_refused(count: int) -> None:
    errors = [1e-3] * count + [1e-12] * (6 - count)
    with pytest.raises(CertificateError, match=f"only {count} of 6 errors of the edges are above"):
        fitted(errors, EPSILONS[:6])


def test_the_same_epsilon_twice_is_one_point() -> None:
    with pytest.raises(CertificateError, match="errors of the edges are above"):
        fitted([1e-2, 1e-2, 1e-3, 1e-4], (0.1, 0.1, 0.01, 0.001))


# --- digits ---------------------------------------------------------------------------------------


@given(st.floats(-1e30, 1e30), st.floats(0, 1e30), st.integers(1, 9))
def test_supported_digits(value: float, error: float, digits: int) -> None:
    text = supported(value, error, digits)
    if abs(value) <= error:
        assert text == "0"
        return
    mantissa, exponent = text.lstrip("-").split("e")
    shown = len(mantissa.replace(".", ""))
    unit = Decimal(10) ** (int(exponent) - shown + 1)
    # rounded to the last digit shown
    assert abs(Decimal(text) - Decimal(value)) <= unit / 2
    assert shown <= digits
    # a further digit would be within the error, or one more than asked for
    if shown > 1:
        assert unit >= Decimal(error)
    if shown < digits:
        assert unit / 1000 < Decimal(error)


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (1.23456, 1e-9, "1.23e+00"),
        (-1.23456, 1e-2, "-1e+00"),
        (1.23456, 0.0, "1.23e+00"),
        (0.0, 0.0, "0"),
        (1.0, math.inf, "0"),
        (1.0, math.nan, "0"),
        (1e300, 1e-300, "1.00e+300"),
        (1.0, 5e-324, "1.00e+00"),
        (math.nan, 0.1, "nan"),
        (math.inf, 0.1, "nan"),
    ],
)
def test_supported_at_the_edges(value: float, error: float, text: str) -> None:
    assert supported(value, error) == text


def test_digits_of_a_record_do_not_depend_on_the_floors() -> None:
    """The floors are estimates whose last bits differ between machines."""
    errors = [3.21987 * e**2 for e in EPSILONS]
    texts = set()
    for floor in (1e-13, 7e-13, 3e-12):
        fit = fit_exponent("edges", 2, EPSILONS, errors, [floor] * 12)
        texts.add(json.dumps(fit.as_dict()))
    assert len(texts) == 1


# --- the record -----------------------------------------------------------------------------------


def certificate() -> Certificate:
    good, bad = fitted([e**2 for e in EPSILONS]), fitted([e**1.5 for e in EPSILONS])
    zone = Zone("Omega", "rad/s", (27.9312181, 31.6294632), (27.9614822, 31.6173612), 2e-7)
    return Certificate("Omega = 2*omega", 1, (("f", 0.1), ("omega", 2.0)), (good, bad), (zone,))


def test_certificate_says_what_fails() -> None:
    record = certificate()
    assert not record.passed
    assert record.failure == (
        "edges of Omega = 2*omega at order 1: the error falls like ε^1.50, the theory demands ε^2"
    )
    with pytest.raises(CertificateError, match="edges of Omega"):
        record.demand()
    held = replace(record, fits=record.fits[:1])
    assert held.passed
    assert held.failure == ""
    held.demand()
    nameless = replace(record, relation="none")
    assert nameless.failure.startswith("edges of the case without resonance at order 1")


def test_certificate_texts() -> None:
    record = certificate()
    assert str(record).splitlines() == [
        "Omega = 2*omega, order 1: FAILS",
        "  edges: error ~ ε^2.00, theory ε^2",
        "  edges: error ~ ε^1.50, theory ε^2",
        "  Omega 27.93122 … 31.62946 rad/s, Floquet 27.96148 … 31.61736",
    ]
    assert "&lt;" in replace(record, relation="a < b")._repr_html_()


def test_certificate_json() -> None:
    data = json.loads(certificate().to_json())
    assert data["relation"] == "Omega = 2*omega"
    assert data["values"] == {"f": "0.1", "omega": "2.0"}
    assert data["passed"] is False
    assert [fit["fitted"] for fit in data["fits"]] == ["2.00", "1.50"]
    assert data["fits"][0]["points"][0] == {"epsilon": 0.125, "error": "1.56e-02"}
    # the zone's own numbers in eight digits, of which the error leaves so many
    assert data["zones"][0]["emitted"] == ["2.7931218e+01", "3.1629463e+01"]
    assert data["zones"][0]["floquet"] == ["2.796148e+01", "3.161736e+01"]


# --- kept between runs ----------------------------------------------------------------------------


def test_kept_certificates_come_back_as_they_were(tmp_path: Path) -> None:
    made = []

    def make() -> Certificate:
        made.append(1)
        return certificate()

    first = kept(tmp_path, "key", make)
    again = kept(tmp_path, "key", make)
    assert len(made) == 1
    assert again == first == certificate()
    assert asdict(again) == asdict(first)
    assert again.to_json() == first.to_json()
    kept(tmp_path, "other", make)
    kept(None, "key", make)
    assert len(made) == 3


def test_kept_under_everything_that_it_follows_from() -> None:
    texts, values, numbers = {"a.py": "x"}, {"f": 1.0}, {"g": 2.0}
    key = certificate_key(texts, values, numbers)
    assert key == certificate_key(dict(texts), dict(values), dict(numbers))
    others = {
        certificate_key({"a.py": "y"}, values, numbers),
        certificate_key({"b.py": "x"}, values, numbers),
        certificate_key(texts, {"f": 1.0000000000000002}, numbers),
        certificate_key(texts, {"h": 1.0}, numbers),
        certificate_key(texts, values, {}),
        certificate_key(texts, numbers, values),
    }
    assert len(others | {key}) == 7
