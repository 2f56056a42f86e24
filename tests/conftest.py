"""What every test starts from: the default precision, and the same random examples each time."""

from __future__ import annotations

from collections.abc import Iterator

import mpmath
import pytest
from hypothesis import settings

# The gate has to give the same verdict twice; `make test-all` looks further, with
# --hypothesis-profile=long, and prints what reproduces a failure. No profile has a deadline: how
# fast a machine is says nothing about whether the result is right.
settings.register_profile("gate", derandomize=True, database=None, deadline=None, max_examples=50)
settings.register_profile("long", deadline=None, max_examples=1000, print_blob=True)
settings.load_profile("gate")


@pytest.fixture(autouse=True)
def default_precision() -> Iterator[None]:
    """Start each test with mpmath's default precision, whatever the one before it set."""
    contexts = (mpmath.mp, mpmath.iv)
    for context in contexts:
        context.prec = 53
    yield
    for context in contexts:
        context.prec = 53
