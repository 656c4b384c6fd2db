"""By which of its doors one comes into a room, walking in by the front door of the home."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.core.space import Opening, Space


def entered_by(space: Space, rooms: Sequence[Space]) -> tuple[int, ...]:
    """The numbers of the doors of a room (its openings but for the windows, in order, then its
    stairs) that lead in from outside, from stairs, or from a room that one can come to without
    walking through this one; all where none does, as in a home without a front door.
    """
    reached = _reached_without(space, rooms)
    doors = [opening for opening in space.openings if opening.kind != "window"]
    by = [k for k, door in enumerate(doors) if _leads_in(door, space, reached)]
    by += range(len(doors), len(doors) + len(space.stairs))
    return tuple(by or range(len(doors) + len(space.stairs)))


def _leads_in(door: Opening, space: Space, reached: set[str]) -> bool:
    others = [other for other in door.spaces if other != space.id]
    return door.use != "exit" if not others else bool(reached.intersection(others))


def _reached_without(space: Space, rooms: Sequence[Space]) -> set[str]:
    """The rooms one comes to from outside or by stairs without passing through a room."""
    others = [room for room in rooms if room.id != space.id]
    doors = {room.id: [o for o in room.openings if o.kind != "window"] for room in others}
    waiting = [
        room.id
        for room in others
        if room.stairs or any(len(d.spaces) == 1 and d.use != "exit" for d in doors[room.id])
    ]
    reached = set(waiting)
    while waiting:
        for door in doors[waiting.pop()]:
            more = [o for o in door.spaces if o in doors and o not in reached]
            reached.update(more)
            waiting += more
    return reached
