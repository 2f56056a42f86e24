"""Certificates of orders at which errors are soon too small to be resolved."""

from __future__ import annotations

import pytest
from certify_systems import MATHIEU, PRINCIPAL, mathieu

import mmsgen as mg
from mmsgen.certify import EPSILONS


def test_high_orders_choose_larger_epsilons_themselves() -> None:
    """Errors of ε⁵ are soon below 1e-10: the fit goes on from ε = 1/2."""
    certificate = mg.certify(mathieu().expand(4, PRINCIPAL), {**MATHIEU, "mu": 0.7, "f": 3.9})
    assert max(certificate.fits[0].epsilons) > max(EPSILONS)
    for fit in certificate.fits:
        assert fit.exponent == pytest.approx(5, abs=0.1)
    with pytest.raises(mg.CertificateError, match="choose larger values of ε"):
        mg.certify(mathieu().expand(4, PRINCIPAL), MATHIEU, epsilons=EPSILONS[:6])
