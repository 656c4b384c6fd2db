"""Needs of a household settled in its finished home: a place to eat for each, a soft seat.

Rooms are furnished one by one. What a home owes to all who live in it is looked for again when all
rooms stand, in whichever of them has a place for it (:data:`SETTLED`): beside all else, then with
what is merely welcome waiting, then where it stands less well, last with something that holds
things or a bed moved or in a smaller form. A change stays where nothing is held less, where nothing
else stands worse and the exact ways of the whole home are as open as before.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import chain, islice
from typing import NamedTuple

from scenewright.catalog.classes import SOFT_SEATS
from scenewright.core.catalog import Group
from scenewright.domains.home.attempt import Missing, RoomAnswer, RoomTask
from scenewright.domains.home.composing.filling.bare_floor import SECOND_ZONE_FROM, pieces_of
from scenewright.domains.home.composing.filling.voids import find_void, may_stand_free
from scenewright.domains.home.composing.homewide.settling import (
    HomeState,
    is_home,
    list_back,
    list_moved,
    list_placed,
    list_sound,
    may_take_in,
    put_back,
    try_in_home,
    wait,
)
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.places.moving import AMID_FROM
from scenewright.domains.home.groups.classes import TABLES
from scenewright.domains.home.groups.living import talking
from scenewright.domains.home.household import STORING
from scenewright.domains.home.measures import TUCKED
from scenewright.domains.home.needs.counting import count_eaters
from scenewright.domains.home.needs.forms import LEAST, list_seats, list_tables, measure_places
from scenewright.domains.home.needs.proof import tell_proof
from scenewright.domains.home.needs.solve_for import solve_for
from scenewright.domains.home.needs.table import RAIL, SHELF
from scenewright.domains.home.programme import STANDS_FOR, Wish

USUAL, MOST = 4, 6
"""Places at a table where there is floor for them, and at most."""
USUAL_FLOOR = 0.95
"""Radius in metres of the empty circle from which a room has floor for :data:`USUAL` places."""
BARE = 0.9
"""Radius in metres of the empty circle from which a kitchen without a table is bare."""
COOKED_IN = frozenset(("kitchen", "hall"))
"""What a kitchen may be besides and still be nothing else."""
BLEMISH = 15.0
"""What it may cost how a thing stands that a home cannot do without: by a window, at the wall of a
door."""
SHRUNK = 0.6
"""Metres of storage that a room gives up for a need at most."""
WALKED = 3
"""Trials of a need that are walked past through the whole home, of each number of places; twice as
many where all is tried."""
SMALL = "no room of the home is large enough for {}"
PROVED = 2
"""Rooms that are laid out anew for a need, the best."""
SMALLEST = 2
"""Forms of a need for which something else moves, the smallest."""
SOUND = 2
"""Places of a need beside which what moved for it is put back."""
Tiers = tuple[tuple[frozenset[str], float], ...]
EATEN_IN: Tiers = (
    (frozenset(("living", "dining", "kitchen")), 4.0),
    (frozenset(("hall",)), 6.0),
    (frozenset(("bedroom", "study", "double_bedroom", "single_bedroom")), 7.0),
)
SAT_IN: Tiers = (
    (frozenset(("living",)), 3.0),
    (frozenset(("bedroom", "double_bedroom", "single_bedroom", "study", "dining")), 7.0),
    (frozenset(("kitchen", "hall")), 9.0),
)
"""Rooms that may have the table and the seat, and their least area in m², the more fitting
first."""


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


def set_table(home: HomeState, answers: list[RoomAnswer]) -> list[RoomAnswer]:
    """The answers with places to eat for all residents, as far as there is a place for them; one
    with :data:`USUAL` places where there is floor for that beside all else."""
    tables = frozenset(STANDS_FOR["dining"])
    fixed = any(p.category in tables for task in home.tasks for p in task.fixed)
    if fixed or home.household is None or not _may_settle(home):
        return answers
    there = [measure_places(g.pieces) for a in answers for g in a.placed]
    eat = sum(count_eaters([p for g in a.placed for p in g.pieces]) for a in answers)
    most = min(max(home.household.residents, LEAST), MOST)
    if sum(there) >= most:
        served = max(there) >= USUAL
        return answers if served else _set_for(home, answers, USUAL, (Stage(),), roomy=True)
    tried = STAGES[:3] if not eat else STAGES if eat < most else STAGES[:2]
    for wanted in range(most, max(int(sum(there)), LEAST - 1), -1):
        found = _set_for(home, answers, wanted, tried if wanted == most else STAGES[:3])
        if found is not answers:
            return found
    if not eat and (found := _set_for(home, answers, LEAST / 2, STAGES)) is not answers:
        return found
    if eat >= most:
        return answers
    short = f"places to eat for {eat:.0f} of {most}: " if eat else ""
    words = "a table with two stools"
    return _say_why(home, answers, EATEN_IN, Wish("dining_wall", 1), short, words, list_tables(1.0))


def _set_for(
    home: HomeState,
    answers: list[RoomAnswer],
    wanted: float,
    stages: Sequence[Stage],
    roomy: bool = False,
) -> list[RoomAnswer]:
    """The answers with ``wanted`` places to eat in all, or as they were."""
    rooms = _list_rooms(home, answers, EATEN_IN, "dining_wall", TABLES)
    held = [sum(measure_places(g.pieces) for g in a.placed) for a in answers]

    def list_forms(place: NeedRoom, rest: Placed) -> Iterator[Group]:
        kept = sum(held) - sum(measure_places(g.pieces) for g in answers[place.room].placed)
        seats = max(wanted - kept, 1.0 if wanted < LEAST else float(LEAST))
        task = home.tasks[place.room]
        radius = find_void(task, pieces_of(task, rest)).radius
        if roomy and radius < USUAL_FLOOR:
            return
        for case in (*list_tables(seats), *(list_tables(float(LEAST)) if seats < LEAST else ())):
            if min(case.width, case.depth) / 2 - TUCKED <= radius:
                yield case

    if roomy:
        rooms = [place for place in rooms if not place.tier]
    return _settle(home, answers, rooms, stages, list_forms, _is_free)


def add_kitchen_tables(home: HomeState, answers: list[RoomAnswer]) -> list[RoomAnswer]:
    """The answers with a second table in each bare kitchen of a home that eats elsewhere."""
    found = answers
    for room, task in enumerate(home.tasks) if _may_settle(home) else ():
        placed = answers[room].placed
        if not _is_without_table(task, placed) or not may_take_in(task, "dining_wall"):
            continue
        radius = find_void(task, pieces_of(task, placed)).radius
        for seats in (USUAL, LEAST) if radius >= BARE else ():
            fit = [c for c in list_tables(seats) if min(c.width, c.depth) / 2 - TUCKED <= radius]
            place = NeedRoom(room, placed, Wish("dining_wall", 1), 0)
            more = _settle(
                home, found, (place,), (Stage(),), lambda *_, fit=fit: iter(fit), _is_free
            )
            if more is not found:
                found = more
                break
    return found


def _is_without_table(task: RoomTask, placed: Placed) -> bool:
    """Whether a room is a kitchen in which nobody eats, nor elsewhere in its open space."""
    kitchen = "kitchen" in task.space.functions and set(task.space.functions) <= COOKED_IN
    table = any(p.wish.group in TABLES for p in placed)
    return kitchen and not table and not TABLES & task.elsewhere


def _is_free(case: Group) -> bool:
    """Whether a table stands free of walls."""
    return case.function == "dining"


def add_soft_seat(home: HomeState, answers: list[RoomAnswer]) -> list[RoomAnswer]:
    """The answers with a soft seat in a home without one."""
    placed = (pieces_of(t, a.placed) for t, a in zip(home.tasks, answers, strict=True))
    if not _may_settle(home) or any(p.category in SOFT_SEATS for each in placed for p in each):
        return answers
    rooms = _list_rooms(home, answers, SAT_IN, "reading", frozenset())
    tasks = home.tasks
    found = _settle(
        home, answers, rooms, STAGES, lambda place, _: iter(list_seats(not place.tier)), None
    )
    if found is not answers:
        return found
    large = [p for p in rooms if tasks[p.room].ground.area >= SECOND_ZONE_FROM]
    found = _settle(
        home, answers, large, STAGES[:2], lambda *_: iter(tuple(talking())), lambda _: True
    )
    if found is not answers:
        return found
    return _say_why(home, answers, SAT_IN, Wish("reading", 1), "", "an armchair", list_seats(False))


def _say_why(
    home: HomeState,
    answers: list[RoomAnswer],
    tiers: Tiers,
    wish: Wish,
    short: str,
    words: str,
    forms: Sequence[Group],
) -> list[RoomAnswer]:
    """The answers with a need missing in the best room for it, for what its smallest form failed
    of there and in the next, instead of what was merely usual or welcome and is missing; as they
    were where something asked for or essential is missing or no room may have it."""
    lacking = [m for a in answers for m in a.missing if m.wish.group in _serving(wish)]
    if any(m.wish.required or not m.wish.rank for m in lacking):
        return answers
    rooms = _list_rooms(home, answers, tiers, wish.group, _serving(wish))[:PROVED]
    uses = frozenset[str]().union(*(names for names, _ in tiers))
    tried = [place.room for place in rooms] or [
        room
        for room, task in enumerate(home.tasks)
        if uses.intersection(task.space.functions) and may_take_in(task, wish.group)
    ]
    if not tried:
        return answers
    case = min(forms, key=lambda form: form.width * form.depth)
    bare = [(place.room, wait(place.rest, home.timed)[0]) for place in rooms]
    why = tell_proof(home.tasks, bare, case, words) if bare else SMALL.format(words)
    kept = [tuple(m for m in a.missing if m not in lacking) for a in answers]
    kept[tried[0]] += (Missing(wish, short + why),)
    return [a._replace(missing=m) for a, m in zip(answers, kept, strict=True)]


def _may_settle(home: HomeState) -> bool:
    known = is_home(home.tasks) or not home.whole
    return known and not any(task.cancelled() for task in home.tasks)


def _list_rooms(
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
    people = home.household.residents if home.household else MOST
    pieces = (p for a in answers for group in a.placed for p in group.pieces)
    held = sum(piece.size.width for piece in pieces if piece.category in STORING)
    return min(max(held - people * (RAIL + SHELF), 0.0), SHRUNK)


Forms = Callable[[NeedRoom, Placed], Iterator[Group]]


def _settle(
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
        for place in rooms
        if place.tier == tier
        for trial in _list_in(home, answers, place, stage, list_forms, stands_free)
    )
    solved = _list_solved(home, answers, rooms, list_forms) if stages[-1].moves else ()
    walked = WALKED * (1 + stages[-1].moves)
    for room, answer in chain(islice(trials, walked), solved):
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
        own = tuple(p for p in place.rest if p.wish.required)
        forms = tuple(list_forms(place, own))
        if place.wish.group in TABLES:
            at_wall = task.ground.area < AMID_FROM
            forms = tuple(form for form in forms if _is_free(form) != at_wall) or forms
        stand = [p.wish for p in answer.placed if p.wish.group in TABLES]
        asked = [w for w in home.wishes[place.room] if w.group not in TABLES]
        wishes = [w for w in (*asked, *stand) if w.group not in _serving(place.wish)]
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
    use = "table" if place.wish.group in TABLES else "soft seat"
    bare, waiting = wait(place.rest, home.timed) if stage.waits else (place.rest, ())
    if stage.waits and not waiting and not stage.spare and not stage.moves:
        return
    movable = list_moved(bare) if stage.moves else iter(((bare, None),))
    for rest, moved in movable:
        forms = list(list_forms(place, rest))
        if stage.moves:
            forms = sorted(forms, key=lambda form: form.width * form.depth)[:SMALLEST]
        for case in forms:
            wish = place.wish._replace(group=case.function)
            free = stands_free is not None and stands_free(case)
            found = list_placed(task, rest, wish, case, free)
            if free and case.function == "reading":
                there = pieces_of(task, rest)
                found = (g for g in found if may_stand_free(task, there, g.dressed.box))
            sound = islice(list_sound(task, before, rest, found, stage.spare), SOUND)
            for placed in sound:
                whole = (
                    placed
                    if moved is None
                    else next(list_back(task, before, placed, moved, stage.spare, spare), None)
                )
                if whole is None:
                    continue
                whole, gone = put_back(task, before, whole, waiting)
                lost = tuple(Missing(w, f"it makes room for the {use} of the home") for w in gone)
                served = (m for m in answer.missing if not _is_served(m, wish))
                yield place.room, answer._replace(placed=whole, missing=(*served, *lost))
                break


def _is_served(missing: Missing, wish: Wish) -> bool:
    """Whether what is missing stands now."""
    return missing.wish.group in _serving(wish) and not missing.wish.required


def _serving(wish: Wish) -> frozenset[str]:
    """The groups that serve as one does."""
    return TABLES if wish.group in TABLES else frozenset((wish.group,))
