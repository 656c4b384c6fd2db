"""Tables of many rows, each checked within a millisecond, as one test that reports all that fail.

A parametrised test costs pytest more for every row than such a check does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any


def every(
    rows: Iterable[Any] | Callable[[], Iterable[Any]], name: Callable[[Any], str] = str
) -> Callable[[Callable[..., None]], Callable[[], None]]:
    """Make one test of a check of one row: each is checked, whatever the others do.

    A row that is a plain tuple is handed over as several arguments. ``name`` says which row failed.
    A table that takes long to make is handed over as the function that makes it.
    """

    def make(check: Callable[..., None]) -> Callable[[], None]:
        def checked() -> None:
            listed = list(rows() if callable(rows) else rows)
            assert listed, "the table has no rows"
            failed = [f"{name(row)}: {fault}" for row in listed if (fault := fault_of(check, row))]
            assert not failed, "\n".join([f"{len(failed)} of {len(listed)} rows fail", *failed])

        checked.__name__, checked.__doc__ = check.__name__, check.__doc__
        checked.__module__, checked.__qualname__ = check.__module__, check.__qualname__
        return checked

    return make


def fault_of(check: Callable[..., None], row: Any) -> str:
    """What a check says of one row; empty if it holds."""
    try:
        check(*row) if type(row) is tuple else check(row)
    except Exception as error:
        return f"{type(error).__name__} {error}"
    return ""
