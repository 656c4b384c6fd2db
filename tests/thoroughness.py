"""How much a test tries: a little in `make test`, a lot in `make test-all`."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TypeVar

import pytest

Row = TypeVar("Row")

THOROUGH = bool(os.environ.get("SCENEWRIGHT_THOROUGH"))
only_thorough = pytest.mark.skipif(not THOROUGH, reason="in make test-all")
"""A test, or a row of one, for the thorough check: a quicker one beside it guards the same."""


def few_or_many(few: int, many: int) -> int:
    """``few`` rounds of a test in the usual check, ``many`` in the thorough one.

    >>> few_or_many(3, 20) in (3, 20)
    True
    """
    return many if THOROUGH else few


def spread(rows: Sequence[Row], few: int) -> list[Row]:
    """``few`` rows of a table of equals, evenly spread; all of them in the thorough check.

    >>> len(spread(range(100), 4)) in (4, 100)
    True
    """
    number = few_or_many(min(few, len(rows)), len(rows))
    return [rows[k * len(rows) // number] for k in range(number)]
