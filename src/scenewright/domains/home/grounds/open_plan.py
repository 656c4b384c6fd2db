"""Rooms that are one open space share what such a space has once: one seating with one screen.

Rooms are furnished one by one. Where several of an open space would each bring the same, one of
them has it, and the others know that it stands elsewhere; a part of a living room that so loses
its seating is where people eat or read.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from scenewright.building.open_spaces import find_open_spaces
from scenewright.core.brief import Room
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.attempts.attempt import RoomTask, floor_of
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.groups.classes import COOKING, SITTING, TABLES
from scenewright.domains.home.programme import Wish, standing_groups
from scenewright.domains.home.tasks import wishes_of
from scenewright.domains.home.wished.wishes import groups_of

SERVING = frozenset(("sideboard",))
ONCE = (
    SITTING,
    COOKING,
    TABLES,
    SERVING,
    frozenset(("shoes",)),
    frozenset(("coats",)),
    frozenset(("console",)),
)
"""Uses that an open space has once, each with the groups that serve it."""
TO_EAT, TO_READ, TO_SHELVE = 8.0, 5.0, 9.0
"""Floor from which on a part without seating is for eating, has a reading corner or bookcases,
square metres."""


class OpenPart(NamedTuple):
    """One room of an open space: its number, the groups it would hold alone, those that
    already stand in it, those the household names for it, whether all is listed (``ask``), and
    its free floor in square metres."""

    number: int
    groups: frozenset[str]
    standing: frozenset[str]
    named: frozenset[str]
    listed: bool
    area: float


def share_open_plans(
    tasks: Sequence[RoomTask], asked: Sequence[Room], rooms: tuple[Space, ...]
) -> list[RoomTask]:
    """The tasks of a home, those of open spaces with what they hold ``elsewhere`` and
    ``instead``."""
    shared = list(tasks)
    number = {space.id: i for i, space in enumerate(rooms)}
    eaten_in = any("dining" in space.functions for space in rooms)
    for ids in find_open_spaces(rooms):
        parts = [_part(number[i], tasks, asked, rooms) for i in sorted(ids, key=number.__getitem__)]
        for part, elsewhere, instead in divide(parts, eaten_in):
            shared[part.number] = tasks[part.number]._replace(elsewhere=elsewhere, instead=instead)
    return shared


def _part(
    number: int, tasks: Sequence[RoomTask], asked: Sequence[Room], rooms: tuple[Space, ...]
) -> OpenPart:
    task, room = tasks[number], asked[number]
    named = [group for wish in room.wishes if not wish.forbid for group in groups_of(wish.what)]
    return OpenPart(
        number,
        frozenset(wish.group for wish in wishes_of(room, task, rooms, task.fixed)),
        groups_there(task.fixed),
        frozenset(named),
        room.ask is not None,
        floor_of(task.ground),
    )


def groups_there(pieces: Sequence[Piece]) -> frozenset[str]:
    """The groups that pieces are of, or make unnecessary."""
    return standing_groups(pieces) | {p.function for p in pieces if p.function in GROUPS}


def divide(
    parts: Sequence[OpenPart], eaten_in: bool
) -> list[tuple[OpenPart, frozenset[str], tuple[Wish, ...]]]:
    """For every part of an open space, its groups in another part and what it has instead;
    ``eaten_in`` if some room of the home is for dining."""
    elsewhere: dict[int, frozenset[str]] = {part.number: frozenset() for part in parts}
    instead: dict[int, tuple[Wish, ...]] = {part.number: () for part in parts}
    for use in ONCE:
        if use is TABLES:
            instead |= _instead(parts, elsewhere, eaten_in)
            parts = [p._replace(groups=p.groups | _groups(instead[p.number])) for p in parts]
        holders = [part for part in parts if use & (part.groups | part.standing)]
        host = max(holders, key=lambda p: _claim(p, use, elsewhere[p.number]), default=None)
        for part in holders:
            if part is not host and not part.listed:
                elsewhere[part.number] |= use - part.named
    return [(part, elsewhere[part.number], instead[part.number]) for part in parts]


def _claim(part: OpenPart, use: frozenset[str], elsewhere: frozenset[str]) -> tuple[float, ...]:
    """How much a part is the one for a use: it stands there, was asked for there, can be there as
    a whole; people eat where they neither sit nor cook, and a sideboard stands where they eat;
    then the larger one."""
    other = (SITTING, COOKING) if use is TABLES else (TABLES,) if use is COOKING else ()
    return (
        bool(use & part.standing),
        bool(use & (part.groups if part.listed else part.named)),
        len(use & part.groups),
        -sum(bool(part.groups & groups - elsewhere) for groups in other),
        use is SERVING and bool(part.groups & TABLES - elsewhere),
        part.area,
    )


def _instead(
    parts: Sequence[OpenPart], elsewhere: dict[int, frozenset[str]], eaten_in: bool
) -> dict[int, tuple[Wish, ...]]:
    """What parts have that lost their seating: the largest a table, where nobody else in the home
    has one, the others a reading corner and bookcases."""
    found: dict[int, tuple[Wish, ...]] = {}
    more: tuple[tuple[str, float], ...]
    lost = [part for part in parts if "seating" in elsewhere[part.number] & part.groups]
    for part in sorted(lost, key=lambda p: -p.area):
        if not eaten_in and part.area >= TO_EAT:
            more, eaten_in = (("dining", TO_EAT),), True
        else:
            more = (("reading", TO_READ), ("shelf", TO_SHELVE))
        found[part.number] = tuple(
            Wish(group, 1)
            for group, least in more
            if part.area >= least and group not in part.groups
        )
    return found


def _groups(wishes: Sequence[Wish]) -> frozenset[str]:
    return frozenset(wish.group for wish in wishes)


def held_elsewhere(room: str, pieces: Sequence[Piece], rooms: tuple[Space, ...]) -> frozenset[str]:
    """The groups of uses for which other parts of a furnished open space have something standing,
    and ``room`` has not."""
    others = [ids for ids in find_open_spaces(rooms) if room in ids]
    there = groups_there([p for p in pieces if others and p.space in others[0] - {room}])
    here = groups_there([p for p in pieces if p.space == room])
    uses = [use for use in ONCE if use & there and not use & here]
    return frozenset(group for use in uses for group in use)
