"""Changes of a scene by hand in words, and by what became of each piece."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from scenewright.core.edits import Change

MOST_OF_ONE = 6
"""Pieces of one group that are named one by one."""


def list_changes(changes: Sequence[Change]) -> dict[str, list[str]]:
    """Ids of the pieces that are ``moved``, ``new`` or ``gone``."""
    return {how: [c.piece for c in changes if c.change == how] for how in ("moved", "new", "gone")}


def describe_changes(changes: Sequence[Change]) -> list[str]:
    """The changes in words, those of one kind and reason on one line."""
    values: dict[tuple[str, str], list[str]] = {}
    for change in changes:
        renamed = change.was not in ("", change.piece)
        name = f"{change.was} -> {change.piece}" if renamed else change.piece
        values.setdefault((change.change, change.reason), []).append(name)
    return [f"{how}: {', '.join(_join(names))} ({why})" for (how, why), names in values.items()]


def _join(names: Sequence[str]) -> list[str]:
    """Names of pieces, those of one group together where there are more than :data:`MOST_OF_ONE`.

    >>> _join(["a/bed", *(f"hall/seats/seat_{k}" for k in range(40))])
    ['a/bed', 'hall/seats (40 pieces)']
    """
    groups = Counter(name.rpartition("/")[0] for name in names)
    many = {group for group, count in groups.items() if group and count > MOST_OF_ONE}
    owners = {name: name.rpartition("/")[0] for name in names}
    shown = (
        f"{owners[name]} ({groups[owners[name]]} pieces)" if owners[name] in many else name
        for name in names
    )
    return list(dict.fromkeys(shown))
