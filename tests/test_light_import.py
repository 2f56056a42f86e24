"""`import mmsgen` loads what every derivation needs, and leaves the rest to its first use."""

from __future__ import annotations

import subprocess
import sys

import pytest
from sympy.physics.mechanics import dynamicsymbols

import mmsgen
from mmsgen.validation import TIME

HEAVY = (
    "matplotlib",
    "mmsgen.codegen",
    "mmsgen.floquet",
    "scipy.integrate",
    "scipy.linalg",
    "scipy.optimize",
    "sympy.physics",
)


def test_import_leaves_heavy_packages_to_their_first_use() -> None:
    program = f"import mmsgen, sys; print(*(m for m in {HEAVY} if m in sys.modules))"
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == []


@pytest.mark.parametrize("first", ["mmsgen.certify", "mmsgen.emission", "mmsgen.report"])
def test_certify_is_the_function_whatever_is_loaded_first(first: str) -> None:
    program = f"import {first}, mmsgen; from mmsgen import certify; print(certify.__qualname__)"
    program += "; assert mmsgen.certify is certify"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout.split() == ["certify"], done.stderr


def test_everything_public_is_there() -> None:
    assert all(getattr(mmsgen, name) is not None for name in mmsgen.__all__)
    assert set(mmsgen.__all__) <= set(dir(mmsgen))
    with pytest.raises(AttributeError, match="no attribute 'certificat'"):
        mmsgen.certificat


def test_time_is_that_of_sympy_mechanics() -> None:
    assert TIME == dynamicsymbols._t
