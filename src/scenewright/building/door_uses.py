"""What doors are for, by what they join: their leaves are made by that, not by their width."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal

from scenewright.core.space import Opening, Space

DoorUse = Literal["inner", "closet", "garden", "entrance"]
"""``inner`` joins two rooms, ``closet`` closes shelves, ``garden`` leads to the open air and is
glazed, ``entrance`` is the way into a home."""

OPEN_AIR = frozenset(("balcony",))
CLOSETS = frozenset(("storage",))
LIVED_IN = frozenset(
    (
        "living",
        "dining",
        "kitchen",
        "bedroom",
        "double_bedroom",
        "single_bedroom",
        "child_bedroom",
        "study",
    )
)


def classify_doors(openings: Sequence[Opening], spaces: Sequence[Space]) -> Mapping[str, DoorUse]:
    """The use of each door by its id.

    Doors to a balcony are garden doors, and so are those outside, except where people come in: a
    leaf that turns outside is an entrance where its room is a hall or none that is lived in, or
    where no other leaf of the level is.

    >>> import numpy as np
    >>> def room(name, function):
    ...     return Space(name, "", (function,), "0", np.zeros((3, 2)))
    >>> rooms = [room(f, f) for f in ("hall", "living", "balcony", "storage")]
    >>> def door(name, *joins, hinge=1):
    ...     return Opening(name, "door", "0", 0, 0, 1, 0, 0.8, 0.1, 0, 2, hinge, 1, joins)
    >>> doors = [door("a", "hall"), door("b", "living"), door("c", "living", "balcony"),
    ...          door("d", "storage", "living"), door("e", "hall", "living")]
    >>> list(classify_doors(doors, rooms).values())
    ['entrance', 'garden', 'garden', 'closet', 'inner']
    >>> classify_doors(doors[1:], rooms)["b"]
    'entrance'
    """
    functions = {space.id: frozenset(space.functions) for space in spaces}
    doors = [opening for opening in openings if opening.kind == "door"]
    entered = {door.level for door in doors if _is_entered(door, functions)}
    return {door.id: _classify(door, functions, entered) for door in doors}


def _is_entered(door: Opening, functions: Mapping[str, frozenset[str]]) -> bool:
    """Whether a leaf turns from outside into a room that people pass through."""
    joined = [functions.get(name, frozenset()) for name in door.spaces]
    return len(joined) == 1 and door.hinge != 0 and _is_passed(joined[0])


def _is_passed(of: frozenset[str]) -> bool:
    return "hall" in of or not of & LIVED_IN


def _classify(door: Opening, functions: Mapping[str, frozenset[str]], entered: set[str]) -> DoorUse:
    joined = [functions.get(name, frozenset()) for name in door.spaces]
    if any(of & OPEN_AIR for of in joined):
        return "garden"
    if len(joined) < 2:
        known = door.level in entered and not any(_is_passed(of) for of in joined)
        return "entrance" if door.hinge and not known else "garden"
    return "closet" if any(of and of <= CLOSETS for of in joined) else "inner"
