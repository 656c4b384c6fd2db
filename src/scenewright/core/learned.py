"""Habits a domain learned from scenes that people furnished."""

from __future__ import annotations

from typing import Any, NamedTuple


class LearnedGroups(NamedTuple):
    """How many furnished ``rooms`` were looked at, a row for each function of the groups found, and
    the ``document`` that was written."""

    rooms: int
    rows: tuple[dict[str, Any], ...]
    document: dict[str, Any]
