"""The doors of a hall as its visitors use them: in by one, out by another, never by an emergency
exit.
"""

from __future__ import annotations

import re

from scenewright.core.space import Opening, Space

FRONT = ("front", "street", "main", "entrance", "lobby", "concourse", "foyer", "west")
SERVICE = (
    *("back", "staff", "kitchen", "store", "delivery", "workshop", "yard", "goods", "office", "wc"),
    *("lab", "stock", "vestry", "bakehouse", "service", "garage", "emergency", "surgery", "stage"),
)
"""Words in the ids of doors visitors come in by, and of doors they do not use."""
EMERGENCY = 0.7
"""A door out narrower than this share of the widest is an emergency exit where that one is left."""


def ways_in(space: Space) -> list[Opening]:
    """The doors visitors may come in by, the main entrance first."""
    return _rank_doors(space, "entrance", "exit")


def ways_out(space: Space) -> list[Opening]:
    """Every door people may leave by in an emergency, those for it alone first."""
    return _rank_doors(space, "exit", "entrance")


def visitor_exits(space: Space) -> list[Opening]:
    """The doors visitors leave by, best first: emergency exits only where there is no other.

    An emergency exit is one that is much narrower than the widest way out, as a stage door or the
    back door of a shop.
    """
    doors = ways_out(space)
    alone = [door for door in doors if door.use == "exit" and not _is_called(door, SERVICE)]
    if any(door.use == "entrance" for door in space.openings):
        doors = alone or doors
    doors = [door for door in doors if not _is_called(door, SERVICE)] or doors
    widest = max((door.width for door in doors), default=0.0)
    return [door for door in doors if door.width > EMERGENCY * widest]


def _rank_doors(space: Space, use: str, other: str) -> list[Opening]:
    """Doors for one use, those for it alone first, then those called so, then those to the
    outside, then wide ones."""
    doors = [door for door in space.openings if door.kind != "window"]
    uses = [door.use if door.spaces[:1] in ((), (space.id,)) else "both" for door in doors]
    rows = [
        (mark != use, _rank_name(door), len(door.spaces) > 1, -door.width, k)
        for k, (door, mark) in enumerate(zip(doors, uses, strict=True))
        if mark != other
    ]
    return [doors[row[-1]] for row in sorted(rows)]


def _rank_name(door: Opening) -> int:
    """0 for a door called after its visitors, 2 after those who work there, else 1."""
    return 0 if _is_called(door, FRONT) else 2 if _is_called(door, SERVICE) else 1


def _is_called(door: Opening, words: tuple[str, ...]) -> bool:
    return not set(re.split(r"[^a-z]+", door.id.rpartition("/")[2].lower())).isdisjoint(words)
