"""What stands in the way of a need: its smallest form, tried in the best rooms of a home."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import DOOR, FurnishedGroup, RoomTask, find_blocked
from scenewright.domains.home.attempts.bed_first import with_narrow_ways
from scenewright.domains.home.composing.homewide.settling import (
    find_barred,
    list_placed,
    measure_harm,
)
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.spacing.leave_out import find_left_out
from scenewright.domains.home.groups import LABELS
from scenewright.domains.home.measures import ROUNDING
from scenewright.domains.home.programme import Wish

LOOKED = 12
"""Places of the smallest form that are looked at in a room."""
HARMS = (
    "stands before a window or at a door",
    "takes the floor that {others} is used from",
    "stands before a wide door",
    "leaves no room between table and seats",
    "is in the view of the screen",
    "stands where somebody wished for something else",
)
"""What a place is refused for, as :func:`.settling.measure_harm` measures it."""


def tell_proof(
    tasks: Sequence[RoomTask], rooms: Sequence[tuple[int, Placed]], case: Group, words: str
) -> str:
    """What was tried and what is in its way, room by room: the groups of a room beside which
    the smallest form has no place, the nearest miss of its places."""
    found = [
        f"{tasks[room].space.name or tasks[room].space.id}, {_find_miss(tasks[room], rest, case)}"
        for room, rest in rooms
    ]
    size = f"{case.width:.1f} x {case.depth:.1f} m"
    return f"tried {words} ({size} of floor) in " + "; in ".join(found)


def _find_miss(task: RoomTask, rest: Placed, case: Group) -> str:
    """Why a form stands nowhere beside the rest of a room: of its places the one refused for
    least."""
    others = " and ".join(dict.fromkeys(LABELS.get(p.wish.group, p.wish.group) for p in rest))
    wish = Wish(case.function, 1)
    placed = islice(list_placed(task, rest, wish, case, case.function == "dining"), LOOKED)
    misses = [_list_misses(task, rest, group) for group in placed]
    each = sorted((list(miss) for miss in misses), key=len)
    if not each:
        return f"no place is left beside {others}" if others else "no wall or floor is long enough"
    if not each[0]:
        return "the ways through the whole home would be barred"
    return "it " + " and ".join(each[0]).format(others=others or "a door")


def _list_misses(task: RoomTask, rest: Placed, group: FurnishedGroup) -> Iterator[str]:
    placed = (*rest, group)
    most = measure_harm(task, rest, rest)
    harm = measure_harm(task, placed, rest)
    for words, now, before in zip(HARMS, harm, most, strict=True):
        if now > before + ROUNDING:
            yield words
    shut = set(find_blocked(with_narrow_ways(task), placed)) - find_barred(task, rest)
    names = sorted({name_way(task, name) for name in shut - {group.name}})
    if find_left_out(task, placed) - find_left_out(task, rest):
        yield "stands too near to what else is here"
    if names:
        yield f"leaves no way to {' and '.join(names)}"
    elif shut:
        yield "is reached by no way"


def name_way(task: RoomTask, name: str) -> str:
    """What no way leads to, in words: a door by the room behind it, a group by its label."""
    if not name.startswith(DOOR):
        stem = name.rstrip("0123456789").rstrip("_")
        return f"the {LABELS.get(stem, stem.replace('_', ' '))}"
    doors = [opening for opening in task.space.openings if opening.kind != "window"]
    number = int(name.removeprefix(DOOR)) - 1
    if number >= len(doors):
        return "the stairs"
    behind = [space for space in doors[number].spaces if space != task.space.id]
    return f"the door to {behind[0]}" if behind else "the door outside"
