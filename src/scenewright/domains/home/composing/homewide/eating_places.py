"""A table for all who live in a home, once all its rooms stand.

Rooms bring a table by what each is for, and where a room is tight it has one for two, or none. How
many eat is known of the home only. So in a finished home that seats fewer at a table than sleep in
it, larger tables are tried in the rooms one may eat in, those one lives or cooks in first, of these
the one with the freest floor: freestanding before at a wall, at last a table for two with stools. A
home without any table says so.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from itertools import islice, product
from typing import NamedTuple

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import Missing, RoomAnswer, RoomTask
from scenewright.domains.home.cases.library import shipped_cases
from scenewright.domains.home.composing.filling.bare_floor import pieces_of
from scenewright.domains.home.composing.filling.voids import find_void
from scenewright.domains.home.composing.homewide.settling import (
    is_home,
    list_placed,
    list_sound,
    list_yielding,
    may_take_in,
    try_in_home,
)
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.places.forms import list_further
from scenewright.domains.home.composing.seats.lounges import PLACES
from scenewright.domains.home.groups.classes import TABLES
from scenewright.domains.home.household import Household
from scenewright.domains.home.measures import TUCKED
from scenewright.domains.home.programme import STANDS_FOR, Wish
from scenewright.domains.home.remove_blockers import Opened

LEAST, USUAL, MOST = 2, 4, 6
"""Places at a table: at the very least, where there is floor for them, and at most."""
USUAL_FLOOR = 0.95
"""Radius in metres of the empty circle from which a room has floor for :data:`USUAL` places."""
BARE = 0.9
"""Radius in metres of the empty circle from which a kitchen without a table is bare."""
COOKED_IN = frozenset(("kitchen", "hall"))
"""What a kitchen may be besides and still be nothing else."""
EATEN_IN = (
    (frozenset(("living", "dining", "kitchen")), 4.0),
    (frozenset(("hall",)), 6.0),
    (frozenset(("bedroom", "study", "double_bedroom", "single_bedroom")), 7.0),
)
"""Rooms that may have the table, and their least area in m², the more fitting first; one that is
neither lived nor cooked in only where no other has one."""
FORMS = 3
"""Tables of a kind tried, the smallest first: where none of them fits no larger one does."""
WALKED = 3
"""Places of tables that are walked past through the whole home."""
REASON = "no room of the home has a place for a table with two stools"


class DiningPlace(NamedTuple):
    """A room that may have the table: its number, its groups without tables, the wish its table
    came by, how it ranks among the rooms, and the radius of its empty circle, metres."""

    room: int
    rest: Placed
    wish: Wish | None
    tier: int
    radius: float


def set_table(
    household: Household,
    tasks: Sequence[RoomTask],
    answers: list[RoomAnswer],
    opened: Opened,
    timed: bool = False,
) -> list[RoomAnswer]:
    """The answers with a table for all residents where one stands in the way of nothing, the ways
    of the home ``opened``, unless ``timed`` also in the place of what is merely welcome; where
    there is none at all, that is missing by name."""
    tables = frozenset(STANDS_FOR["dining"])
    if not is_home(tasks) or any(p.category in tables for task in tasks for p in task.fixed):
        return answers
    there = max((measure_places(g.pieces) for a in answers for g in a.placed), default=0.0)
    most = min(max(household.residents, LEAST), MOST)
    if there >= max(most, USUAL) or any(task.cancelled() for task in tasks):
        return answers
    rooms = _list_rooms(tasks, answers, there > 0.0)
    for trial in islice(_list_trials(tasks, answers, rooms, there, most, timed), WALKED):
        found = try_in_home(*trial, answers, opened)
        if found is not None:
            return found
    return answers if there > 0.0 else _say_why(household, tasks, answers)


def add_kitchen_tables(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers with a second table in each bare kitchen of a home that eats elsewhere."""
    found = answers
    for room, task in enumerate(tasks) if is_home(tasks) else ():
        if not _is_without_table(task, answers[room]) or task.cancelled():
            continue
        place = _find_place(room, task, answers[room])
        if place is not None and place.radius >= BARE:
            found = _set_in(task, place, found, opened)
    return found


def _is_without_table(task: RoomTask, answer: RoomAnswer) -> bool:
    """Whether a room is a kitchen in which nobody eats, nor elsewhere in its open space."""
    kitchen = "kitchen" in task.space.functions and set(task.space.functions) <= COOKED_IN
    table = any(p.wish.group in TABLES for p in answer.placed)
    return kitchen and not table and not TABLES & task.elsewhere


def _set_in(
    task: RoomTask, place: DiningPlace, found: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers with a table in one room, if one stands there."""
    answer = found[place.room]
    trials = (t for n in (USUAL, LEAST) for t in _list_set(task, answer, place, n))
    tried = (try_in_home(*trial, found, opened) for trial in islice(trials, WALKED))
    return next((each for each in tried if each is not None), found)


def measure_places(pieces: Iterable[Piece | Member]) -> float:
    """The places at the table of a group; one on a stool is half of one, and there is none without
    a table."""
    each = Counter(p.category for p in pieces)
    if not any(each[name] for name in STANDS_FOR["dining"]):
        return 0.0
    return sum(worth * each[name] for name, worth in PLACES.items())


def _list_rooms(
    tasks: Sequence[RoomTask], answers: Sequence[RoomAnswer], served: bool
) -> list[DiningPlace]:
    """The rooms that may have the table, the best first, of those one sleeps in the largest; with a
    home ``served`` already those one lives or cooks in."""
    ranks = [(_rank(task), -task.ground.area, room) for room, task in enumerate(tasks)]
    asleep = sorted(row for row in ranks if row[0] == len(EATEN_IN) - 1)[1:]
    rooms = [room for rank, _, room in sorted(set(ranks) - set(asleep)) if not (served and rank)]
    found = (_find_place(room, tasks[room], answers[room]) for room in rooms)
    places = [place for place in found if place is not None]
    return sorted(places, key=lambda place: (place.tier, -place.radius))


def _find_place(room: int, task: RoomTask, answer: RoomAnswer) -> DiningPlace | None:
    """A room as one that may have the table; None where it may not, or its own is to stay."""
    tier, old = _rank(task), [p for p in answer.placed if p.wish.group in TABLES]
    stays = any(p.wish.required or p.wish.most for p in old) or len(old) > 1
    if tier == len(EATEN_IN) or stays or not may_take_in(task, "dining_wall"):
        return None
    rest = tuple(p for p in answer.placed if p not in old)
    radius = find_void(task, pieces_of(task, rest)).radius
    return DiningPlace(room, rest, old[0].wish if old else None, tier, radius)


def _rank(task: RoomTask) -> int:
    """The first row of :data:`EATEN_IN` that a room is of; their number if it is of none."""
    uses, area = frozenset(task.space.functions), task.ground.area
    rows = enumerate(EATEN_IN)
    fit = (k for k, (names, least) in rows if uses & names and area >= least)
    return next(fit, len(EATEN_IN))


def _list_trials(
    tasks: Sequence[RoomTask],
    answers: Sequence[RoomAnswer],
    rooms: Sequence[DiningPlace],
    there: float,
    most: int,
    timed: bool,
) -> Iterator[tuple[int, RoomAnswer]]:
    """Rooms with more places at a table than are ``there``, each with its number: in the more
    fitting rooms first, those for ``most`` before ever fewer, beside all else before something
    welcome gives way to a first one or, unless ``timed``, to one for all."""
    enough = there >= most
    yields = (False,) if enough or (timed and there) else (False, True)
    wanted = [float(USUAL)] if enough else _list_seats(max(most, USUAL), there)
    orders = product(range(len(EATEN_IN)), yields, wanted)
    for tier, gives, seats in orders:
        for place in rooms:
            wide = seats <= most or place.radius >= USUAL_FLOOR
            if place.tier == tier and wide:
                here = tasks[place.room], answers[place.room]
                yield from _list_set(*here, place, seats, gives, timed)


def _list_seats(most: int, there: float) -> list[float]:
    """How many places tables may have that have more than are ``there``, the most first; two on
    stools, which count as one, only for want of any."""
    return [seats for seats in (*range(most, LEAST - 1, -1), LEAST / 2) if seats > there]


def _list_set(
    task: RoomTask,
    answer: RoomAnswer,
    place: DiningPlace,
    seats: float,
    yields: bool = False,
    timed: bool = False,
) -> Iterator[tuple[int, RoomAnswer]]:
    """The room with one of the tables for ``seats``, beside all else or, where something
    ``yields``, in its place."""
    rooms = list_yielding(place.rest, "table", timed) if yields else ((place.rest, ()),)
    for rest, gone in rooms:
        radius = find_void(task, pieces_of(task, rest)).radius if yields else place.radius
        for case in list_tables(seats):
            if min(case.width, case.depth) / 2 - TUCKED > radius:
                continue
            wish = (place.wish or Wish(case.function, 1))._replace(group=case.function)
            found = list_placed(task, rest, wish, case, case.function == "dining")
            for placed in islice(list_sound(task, answer.placed, rest, found), 1):
                missing = (*(m for m in answer.missing if not _is_served(m)), *gone)
                yield place.room, answer._replace(placed=placed, missing=missing)


def _is_served(missing: Missing) -> bool:
    return missing.wish.group in TABLES and not missing.wish.required


@cache
def list_tables(seats: float) -> tuple[Group, ...]:
    """The smallest tables with ``seats`` places, the better first: freestanding ones, then those
    at a wall.

    >>> [case.name for case in list_tables(6)][:2]
    ['1.6 m table for 6', '1.8 m table for 6']
    """
    known = [c for name in ("dining", "dining_wall") for c in shipped_cases(name).groups]
    forms = (*known, *list_further("dining_wall"))
    fit = [c for c in forms if measure_places(c.members) == seats and len(_find_seats(c)) >= LEAST]
    fit.sort(key=lambda case: case.width * case.depth)
    kinds = ([case for case in fit if case.function == name] for name in ("dining", "dining_wall"))
    return tuple(case for kind in kinds for case in kind[:FORMS])


def _find_seats(case: Group) -> list[Member]:
    """The chairs and stools of a case."""
    return [member for member in case.members if member.category in PLACES]


def _say_why(
    household: Household, tasks: Sequence[RoomTask], answers: list[RoomAnswer]
) -> list[RoomAnswer]:
    """The answers with the table of the home missing in the room they would eat in, unless one is
    missing by now or all that rooms hold is listed."""
    uses = frozenset[str]().union(*(names for names, _ in EATEN_IN))
    free = [
        room
        for room, task in enumerate(tasks)
        if uses & frozenset(task.space.functions) and may_take_in(task, "dining_wall")
    ]
    if not free or any(m.wish.group in TABLES for answer in answers for m in answer.missing):
        return answers
    room = max(free, key=lambda k: (tasks[k].space.id == household.eats_in, tasks[k].ground.area))
    lost = Missing(Wish("dining_wall", 1), REASON)
    answer = answers[room]._replace(missing=(*answers[room].missing, lost))
    return [answer if k == room else other for k, other in enumerate(answers)]
