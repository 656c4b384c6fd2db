"""A soft seat in a home that has none, once all its rooms stand.

A living room brings a sofa. Where no room is a living room, or none found a place, nobody has
anywhere to sit but chairs and beds. So in a finished home without one a loveseat or an armchair is
put where the home has floor for it: in the room one lives in, else in the largest one sleeps, eats
or cooks in.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import islice

from scenewright.catalog.classes import SOFAS
from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.attempt import RoomAnswer, RoomTask
from scenewright.domains.home.cases.library import shipped_cases
from scenewright.domains.home.composing.filling.bare_floor import SECOND_ZONE_FROM, pieces_of
from scenewright.domains.home.composing.filling.voids import may_stand_free
from scenewright.domains.home.composing.homewide.settling import (
    is_home,
    list_placed,
    list_sound,
    list_yielding,
    may_take_in,
    try_in_home,
)
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.groups.least import LEAST
from scenewright.domains.home.groups.living import talking
from scenewright.domains.home.programme import WELCOME, Wish
from scenewright.domains.home.remove_blockers import Opened

SOFT = (*SOFAS, "armchair")
SAT_IN = (
    (frozenset(("living",)), 3.0),
    (frozenset(("bedroom", "double_bedroom", "single_bedroom", "study", "dining")), 7.0),
    (frozenset(("kitchen", "hall")), 9.0),
)
"""Rooms that may have the seat, and their least area in m², the more fitting first."""
CHAIRS = (Size(0.78, 0.8, 0.85), Size(0.66, 0.68, 0.8))
"""Armchairs without a lamp, the larger first."""
SMALL = 1.45
"""No seats wider than this are put in, metres."""
ROOMS, WALKED = 2, 3
"""Rooms that are looked at, and places of seats that are walked past through the whole home."""


def add_soft_seat(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened, timed: bool = False
) -> list[RoomAnswer]:
    """The answers with a soft seat in a home without one where it stands in the way of nothing, the
    ways of the home ``opened``, unless ``timed`` also in the place of what is merely welcome."""
    placed = [pieces_of(t, a.placed) for t, a in zip(tasks, answers, strict=True)]
    seated = any(piece.category in SOFT for pieces in placed for piece in pieces)
    if seated or not is_home(tasks) or any(task.cancelled() for task in tasks):
        return answers
    for trial in islice(_list_trials(tasks, answers, timed), WALKED):
        found = try_in_home(*trial, answers, opened)
        if found is not None:
            return found
    return answers


def _list_trials(
    tasks: Sequence[RoomTask], answers: Sequence[RoomAnswer], timed: bool
) -> Iterator[tuple[int, RoomAnswer]]:
    """Rooms with a soft seat, each with its number, the most fitting first, beside all else before
    something welcome gives way."""
    ranked = [(_rank(task), -task.ground.area, room) for room, task in enumerate(tasks)]
    rooms = sorted(row for row in ranked if row[0] < len(SAT_IN))[:ROOMS]
    for rank, _, room in rooms:
        for placed in _list_seated(tasks[room], answers[room].placed, list_seats(rank == 0)):
            yield room, answers[room]._replace(placed=placed)
    for rank, _, room in () if timed else rooms:
        for rest, gone in list_yielding(answers[room].placed, "soft seat", timed):
            missing = (*answers[room].missing, *gone)
            for placed in _list_seated(tasks[room], rest, list_seats(rank == 0)):
                yield room, answers[room]._replace(placed=placed, missing=missing)


def _list_seated(task: RoomTask, before: Placed, forms: Sequence[Group]) -> Iterator[Placed]:
    """The groups of a room with each of some seats beside them at its best sound place at a wall;
    none where the least has no such place. In a large one two armchairs stand free."""
    least = _seat_in(task, before, forms[-1])
    if least is not None:
        each = (_seat_in(task, before, case) for case in forms[:-1])
        yield from (placed for placed in each if placed is not None)
        yield least
    elif task.ground.area >= SECOND_ZONE_FROM:
        pairs = (_seat_in(task, before, case, free=True) for case in talking())
        yield from (placed for placed in pairs if placed is not None)


def _seat_in(task: RoomTask, before: Placed, case: Group, free: bool = False) -> Placed | None:
    """The groups of a room with a seat beside them at its best sound place, at a wall or also
    ``free``-standing."""
    if not may_take_in(task, case.function):
        return None
    found = list_placed(task, before, Wish(case.function, WELCOME), case, free)
    pieces = pieces_of(task, before)
    sound = (p for p in found if not free or may_stand_free(task, pieces, p.dressed.box))
    return next(list_sound(task, before, before, sound), None)


def _rank(task: RoomTask) -> int:
    """The first row of :data:`SAT_IN` that a room is of; their number if it is of none."""
    uses, area = frozenset(task.space.functions), task.ground.area
    rows = enumerate(SAT_IN)
    fit = (k for k, (names, least) in rows if uses & names and area >= least)
    return next(fit, len(SAT_IN))


@cache
def list_seats(lived_in: bool) -> tuple[Group, ...]:
    """Small seats, the better first: in a room one lives in a sofa for two before an armchair.

    >>> [case.name for case in list_seats(False)][-2:]
    ['0.78 m armchair', '0.66 m armchair']
    """
    sofas = [case for case in shipped_cases("seating").groups if case.width <= SMALL + 0.42]
    small = [case for case in sofas if case.members[0].size.width <= SMALL and case.depth < 1.0]
    single = (*shipped_cases("reading").groups, *map(_make_armchair, CHAIRS))
    wide = sorted((*small, *LEAST["seating"]()), key=lambda case: -case.width)
    return (*wide, *single) if lived_in else single


def _make_armchair(size: Size) -> Group:
    piece = Member("armchair", 0, 0, 0, 0, size)
    name = f"{size.width:.2f} m armchair"
    return Group("reading", name, size.width, size.depth + 0.02, (piece,))
