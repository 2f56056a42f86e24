"""The Duffing family: what is emitted against exact motions and printed formulas."""

from __future__ import annotations

import mpmath as mp
import pytest
from entries import certificates, demand_notebook, emitted


@pytest.mark.pinned
def test_the_notebook_of_the_free_oscillator() -> None:
    demand_notebook("duffing")


def test_certificates_of_the_free_oscillator() -> None:
    found = certificates("duffing")
    assert sorted(found) == [f"nonresonant_order_{n}" for n in (1, 2, 3, 4)]
    for data in found.values():
        (fit,) = data["fits"]
        assert fit["theory"] == data["order"]
        # ten per cent of the next term, at y = 5ε
        assert 0 < float(fit["fitted"]) - fit["theory"] < 0.2


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_frequency_against_the_elliptic_integral(order: int) -> None:
    """The error of the frequency at equal fundamental is c y^{N+1}, with the next coefficient.

    y = αa²/ω_0². At y = 1/70 the term after the next changes the ratio by less than 5 %; the error
    of order 4 is 1.6e-13, rounding 2e-16.
    """
    m = mp.mpf(1) / 140  # of the exact motion cn(·|m)
    big_y = 2 * m / (1 - 2 * m)
    quarter, nome = mp.ellipk(m), mp.qfrom(m=m)
    share = 2 * mp.pi / (mp.sqrt(m) * quarter) * mp.sqrt(nome) / (1 + nome)
    y = share**2 * big_y
    exact = float(mp.pi * mp.sqrt(1 + big_y) / (2 * quarter))
    omega_0, alpha = 1.7, 0.9
    a = float(mp.sqrt(y * omega_0**2 / alpha))
    case = emitted("duffing", f"nonresonant_order_{order}")
    rate = case.slow_flow([a / 2], omega_0=omega_0, alpha=alpha)[0] / (a / 2)
    assert rate.real == 0
    error = 1 + rate.imag / omega_0 - exact
    following = {1: -15 / 256, 2: 123 / 8192, 3: -921 / 262144, 4: 579 / 2097152}[order]
    assert -error / (following * float(y) ** (order + 1)) == pytest.approx(1, abs=0.05)
