"""How much a test tries: a little in `make test`, a lot in `make test-all`."""

from __future__ import annotations

import os

import pytest

THOROUGH = bool(os.environ.get("SCENEWRIGHT_THOROUGH"))
only_thorough = pytest.mark.skipif(not THOROUGH, reason="in make test-all")
"""A test, or a row of one, for the thorough check: a quicker one beside it guards the same."""


def few_or_many(few: int, many: int) -> int:
    """``few`` rounds of a test in the usual check, ``many`` in the thorough one.

    >>> few_or_many(3, 20) in (3, 20)
    True
    """
    return many if THOROUGH else few
