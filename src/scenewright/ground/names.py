"""Ids of what a brief of open ground lists: given, else made of names or numbers."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from typing import Protocol

from scenewright.core.errors import InputError


class Named(Protocol):
    """A thing with an id and a name; either may be empty."""

    @property
    def id(self) -> str:
        """Given by the user, or empty."""

    @property
    def name(self) -> str:
        """The name people use for it."""


def assign_ids(rows: Sequence[Named], word: str, key: str, place: str = "") -> tuple[str, ...]:
    """The id of every row: the one given, else its name in plain letters, else ``road-3``;
    InputError if one is given twice."""
    given = Counter(row.id for row in rows if row.id)
    taken, found = set(given), []
    for number, row in enumerate(rows):
        if row.id and given[row.id] > 1:
            where = f"{place} {key}[{number}]".strip()
            raise InputError(f"the id '{row.id}' is used twice", "give each its own", place=where)
        wish = re.sub(r"[\W_]+", "-", row.name.casefold()).strip("-") or f"{word}-{number + 1}"
        fresh = (wish if k == 1 else f"{wish}-{k}" for k in range(1, len(taken) + 2))
        found.append(row.id or next(name for name in fresh if name not in taken))
        taken.add(found[-1])
    return tuple(found)
