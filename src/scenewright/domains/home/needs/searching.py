"""Where a need of a household is looked for: in which rooms, and how much gives way to it there.

A need stands beside all else, then with what is merely welcome waiting, then where it stands less
well; last everything in the room but what has water stands elsewhere for it, or in a smaller form,
and what is not owed goes (:mod:`.jointly`). Kitchens are laid out anew (:mod:`.solve_for`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import chain, islice
from typing import NamedTuple

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, RoomTask
from scenewright.domains.home.composing.filling.bare_floor import pieces_of
from scenewright.domains.home.composing.filling.voids import may_stand_free
from scenewright.domains.home.composing.homewide.settling import (
    HomeState,
    is_home,
    list_placed,
    list_sound,
    may_take_in,
    put_back,
    try_in_home,
    wait,
)
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.places.moving import AMID_FROM
from scenewright.domains.home.groups.classes import COOKING, TABLES
from scenewright.domains.home.needs.household import STORING
from scenewright.domains.home.needs.jointly import list_jointly
from scenewright.domains.home.needs.solve_for import solve_for
from scenewright.domains.home.needs.table import RAIL, SHELF
from scenewright.domains.home.programme import Wish

BLEMISH = 15.0
"""What it may cost how a thing stands that a home cannot do without: by a window, at the wall of a
door."""
SHRUNK = 1.0
"""Metres of storage that a room gives up for a need at most."""
WALKED = 3
"""Trials of a need that are walked past through the whole home, of each number of places; three
times as many where all is tried."""
JOINED = 3
"""Rooms in which something else moves for a need, the best."""
PROVED = 2
"""Rooms that are laid out anew for a need, the best."""
MADE_ROOM = "it makes room for the {} of the home"
USES = {
    "dining": "table",
    "dining_wall": "table",
    "reading": "soft seat",
    "wardrobe": "wardrobe",
    "washer": "washing machine",
    "media": "screen",
}
"""What a need is called."""
Tiers = tuple[tuple[frozenset[str], float], ...]
Forms = Callable[["NeedRoom", Placed], Iterator[Group]]


class NeedRoom(NamedTuple):
    """A room that may take in a need: its number, its groups less what the need takes the place
    of, the wish that came by, and which of the tiers it is of."""

    room: int
    rest: Placed
    wish: Wish
    tier: int


class Stage(NamedTuple):
    """How much gives way to a need: whether what is welcome ``waits``, what its stand may cost,
    and whether something else ``moves``."""

    waits: bool = False
    spare: float = 0.0
    moves: bool = False


STAGES = (Stage(), Stage(True), Stage(True, BLEMISH), Stage(True, BLEMISH, True))


def may_settle(home: HomeState) -> bool:
    """Whether rooms make a home whose needs are looked for, and nobody waits."""
    known = is_home(home.tasks) or not home.whole
    return known and not is_stopped(home)


def is_stopped(home: HomeState) -> bool:
    """Whether whoever asked for a home wants no more of it."""
    return any(task.cancelled() for task in home.tasks)


def list_need_rooms(
    home: HomeState,
    answers: Sequence[RoomAnswer],
    tiers: Tiers,
    group: str,
    replaced: frozenset[str],
) -> list[NeedRoom]:
    """The rooms that may take in a group, the more fitting and larger first; not those whose own
    of the groups it replaces was asked for."""
    found = []
    for room, (task, answer) in enumerate(zip(home.tasks, answers, strict=True)):
        tier, old = rank_room(task, tiers), [p for p in answer.placed if p.wish.group in replaced]
        stays = any(p.wish.required or p.wish.most for p in old) or len(old) > 1
        if tier < len(tiers) and not stays and may_take_in(task, group):
            wish = old[0].wish if old else Wish(group, 1)
            rest = tuple(p for p in answer.placed if p.wish.group not in replaced)
            found.append(NeedRoom(room, rest, wish, tier))
    return sorted(found, key=lambda place: (place.tier, -home.tasks[place.room].ground.area))


def rank_room(task: RoomTask, tiers: Tiers) -> int:
    """The first of tiers that a room is of; their number if it is of none."""
    uses, area = frozenset(task.space.functions), task.ground.area
    fit = (k for k, (names, least) in enumerate(tiers) if uses & names and area >= least)
    return next(fit, len(tiers))


def measure_spare(home: HomeState, answers: Sequence[RoomAnswer]) -> float:
    """Metres by which the storage of a home may shrink for a need: what it has more than it owes,
    at most :data:`SHRUNK`."""
    if home.household is None:
        return 0.0
    pieces = (p for a in answers for group in a.placed for p in group.pieces)
    held = sum(piece.size.width for piece in pieces if piece.category in STORING)
    return min(max(held - home.household.residents * (RAIL + SHELF), 0.0), SHRUNK)


def settle_need(
    home: HomeState,
    answers: list[RoomAnswer],
    rooms: Sequence[NeedRoom],
    stages: Sequence[Stage],
    list_forms: Forms,
    stands_free: Callable[[Group], bool] | None,
) -> list[RoomAnswer]:
    """The answers with a need in one of the rooms, in the first form and at the first stage that
    leaves the ways of the home open; as they were where there is none."""
    trials = (
        trial
        for tier in sorted({place.tier for place in rooms})
        for stage in (stages[:2] if home.timed else stages)
        for place in (rooms[:JOINED] if stage.moves else rooms)
        if place.tier == tier and not is_stopped(home)
        for trial in _list_in(home, answers, place, stage, list_forms, stands_free)
    )
    solved = _list_solved(home, answers, rooms, list_forms) if stages[-1].moves else ()
    walked = WALKED * (1 + 2 * stages[-1].moves)
    for room, answer in chain(islice(trials, walked), solved):
        if is_stopped(home):
            break
        found = try_in_home(room, answer, answers, home.opened)
        if found is not None:
            return found
    return answers


def _list_solved(
    home: HomeState, answers: Sequence[RoomAnswer], rooms: Sequence[NeedRoom], list_forms: Forms
) -> Iterator[tuple[int, RoomAnswer]]:
    """The best rooms laid out anew for a need, each with its number."""
    for place in rooms[:PROVED] if home.wishes and not home.timed else ():
        task, answer = home.tasks[place.room], answers[place.room]
        if not any(p.wish.group in COOKING for p in answer.placed):
            continue
        own = tuple(p for p in place.rest if p.wish.required)
        forms = tuple(list_forms(place, own))
        if place.wish.group in TABLES:
            at_wall = task.ground.area < AMID_FROM
            forms = tuple(form for form in forms if (form.function == "dining") != at_wall) or forms
        stand = [p.wish for p in answer.placed if p.wish.group in TABLES]
        asked = [w for w in home.wishes[place.room] if w.group not in TABLES]
        wishes = [w for w in (*asked, *stand) if w.group not in list_serving(place.wish)]
        budget, need = home.budgets[place.room], place.wish
        spare = measure_spare(home, answers)
        for solved in solve_for(task, wishes, budget, answer, need, forms, spare) if forms else ():
            yield place.room, solved


def _list_in(
    home: HomeState,
    answers: Sequence[RoomAnswer],
    place: NeedRoom,
    stage: Stage,
    list_forms: Forms,
    stands_free: Callable[[Group], bool] | None,
) -> Iterator[tuple[int, RoomAnswer]]:
    """A room with a need at a stage, once for each form that has a sound place."""
    task, answer = home.tasks[place.room], answers[place.room]
    before = answer.placed
    spare = measure_spare(home, answers) if stage.moves else 0.0
    bare, waiting = wait(place.rest, home.timed) if stage.waits else (place.rest, ())
    if stage.waits and not waiting and not stage.spare and not stage.moves:
        return
    for case, placed in _list_standing(
        task, before, place, bare, stage, spare, list_forms, stands_free
    ):
        whole, gone = put_back(task, before, placed, waiting)
        wish = place.wish._replace(group=case)
        there = {p.name for p in placed}
        gone += tuple(p.wish for p in bare if p.name not in there)
        lost = tuple(Missing(w, MADE_ROOM.format(USES[case])) for w in gone)
        served = (m for m in answer.missing if not _is_served(m, wish))
        yield place.room, answer._replace(placed=whole, missing=(*served, *lost))


def _list_standing(
    task: RoomTask,
    before: Placed,
    place: NeedRoom,
    rest: Placed,
    stage: Stage,
    spare: float,
    list_forms: Forms,
    stands_free: Callable[[Group], bool] | None,
) -> Iterator[tuple[str, Placed]]:
    """The rest of a room with a need in one of its groups, which comes first; ``spare`` metres of
    storage may go for it."""
    forms = list(list_forms(place, rest))
    if stage.moves:
        for name in dict.fromkeys(form.function for form in forms):
            each = [form for form in forms if form.function == name]
            wish = place.wish._replace(group=name)
            for placed in list_jointly(task, before, rest, wish, each, 2 * stage.spare, spare):
                yield name, placed
        return
    for case in forms:
        wish = place.wish._replace(group=case.function)
        free = stands_free is not None and stands_free(case)
        found = list_placed(task, rest, wish, case, free)
        if free and case.function == "reading":
            there = pieces_of(task, rest)
            found = (g for g in found if may_stand_free(task, there, g.dressed.box))
        for placed in islice(list_sound(task, before, rest, found, stage.spare), 1):
            yield case.function, placed


def has_made_room(missing: Missing) -> bool:
    """Whether something went for a need."""
    return missing.reason.startswith(MADE_ROOM.partition("{")[0])


def _is_served(missing: Missing, wish: Wish) -> bool:
    """Whether what is missing stands now."""
    return missing.wish.group in list_serving(wish) and not missing.wish.required


def list_serving(wish: Wish) -> frozenset[str]:
    """The groups that serve as one does."""
    return TABLES if wish.group in TABLES else frozenset((wish.group,))
