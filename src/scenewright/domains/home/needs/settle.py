"""Needs of a household settled in its finished home: a place to eat for each, a soft seat.

Rooms are furnished one by one. What a home owes to all who live in it is looked for again when all
rooms stand, in whichever of them has a place for it (:data:`SETTLED`): beside all else, then with
what is merely welcome waiting, then where it stands less well, last with something that holds
things or a bed moved or in a smaller form. A change stays where nothing is held less, where nothing
else stands worse and the exact ways of the whole home are as open as before.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from scenewright.catalog.classes import SOFT_SEATS
from scenewright.core.catalog import Group
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, RoomTask
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.filling.bare_floor import SECOND_ZONE_FROM, pieces_of
from scenewright.domains.home.composing.filling.voids import find_void
from scenewright.domains.home.composing.homewide.settling import (
    HomeState,
    is_roomy,
    may_take_in,
    wait,
)
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.places.forms import list_forms
from scenewright.domains.home.groups.classes import SLEPT_IN, TABLES
from scenewright.domains.home.groups.living import talking
from scenewright.domains.home.measures import TUCKED
from scenewright.domains.home.needs.counting import count_eaters, count_sleepers, measure_widths
from scenewright.domains.home.needs.forms import LEAST, list_seats, list_tables, measure_places
from scenewright.domains.home.needs.proof import tell_proof
from scenewright.domains.home.needs.searching import (
    PROVED,
    STAGES,
    NeedRoom,
    Stage,
    Tiers,
    has_made_room,
    list_need_rooms,
    list_serving,
    may_settle,
    settle_need,
)
from scenewright.domains.home.needs.table import RAIL
from scenewright.domains.home.programme import STANDS_FOR, Wish

USUAL, MOST = 4, 6
"""Places at a table where there is floor for them, and at most."""
USUAL_FLOOR = 0.95
"""Radius in metres of the empty circle from which a room has floor for :data:`USUAL` places."""
BARE = 0.9
"""Radius in metres of the empty circle from which a kitchen without a table is bare."""
COOKED_IN = frozenset(("kitchen", "hall"))
"""What a kitchen may be besides and still be nothing else."""
SMALL = "no room of the home is large enough for {}"
GROWN = 0.15
"""Metres by which a wardrobe grows at least."""
WIDE = 4
"""Wider forms of a wardrobe that are tried."""
STORED = frozenset(("chest", "shelf", "sideboard"))
"""What holds things and is looked for elsewhere if it made room for a need."""
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
HUNG_IN: Tiers = ((SLEPT_IN, 0.0),)
STORED_IN: Tiers = (*HUNG_IN, (frozenset(("living", "study", "dining", "hall")), 4.0))
"""Rooms that may have the table, the seat, clothes and what holds things, and their least area in
m², the more fitting first."""


def set_table(home: HomeState, answers: list[RoomAnswer]) -> list[RoomAnswer]:
    """The answers with places to eat for all who live and sleep there, as far as there is a place
    for them; one with :data:`USUAL` places where there is floor for that beside all else."""
    tables = frozenset(STANDS_FOR["dining"])
    fixed = any(p.category in tables for task in home.tasks for p in task.fixed)
    if fixed or home.household is None or not may_settle(home):
        return answers
    there = [measure_places(g.pieces) for a in answers for g in a.placed]
    eat, sleep = _count(count_eaters, answers), _count(count_sleepers, answers)
    most = int(min(max(home.household.residents, sleep, LEAST), MOST))
    if sum(there) >= most:
        served = max(there) >= USUAL
        return answers if served else _set_for(home, answers, USUAL, (Stage(),), roomy=True)
    beside = STAGES[:2] if eat >= most else STAGES[:3]
    down = range(most, max(int(sum(there)), LEAST - 1), -1)
    trials = (_set_for(home, answers, wanted, beside) for wanted in down)
    found = next((trial for trial in trials if trial is not answers), answers)
    if _count(count_eaters, found) < most:
        found = _set_for(home, found, most, STAGES[3:])
    if found is answers and not eat:
        found = _set_for(home, answers, LEAST / 2, STAGES)
    if found is not answers:
        return found
    if eat >= most:
        return answers
    short = f"places to eat for {eat:.0f} of {most}: " if eat else ""
    words = "a table with two stools"
    return _say_why(home, answers, EATEN_IN, Wish("dining_wall", 1), short, words, list_tables(1.0))


def _count(serve: Callable[[Sequence[Piece]], float], answers: Sequence[RoomAnswer]) -> float:
    """How much of a need the rooms serve."""
    return sum(serve([p for group in a.placed for p in group.pieces]) for a in answers)


def _set_for(
    home: HomeState,
    answers: list[RoomAnswer],
    wanted: float,
    stages: Sequence[Stage],
    roomy: bool = False,
) -> list[RoomAnswer]:
    """The answers with ``wanted`` places to eat in all, or as they were."""
    rooms = list_need_rooms(home, answers, EATEN_IN, "dining_wall", TABLES)
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
    return settle_need(home, answers, rooms, stages, list_forms, _is_free)


def add_kitchen_tables(home: HomeState, answers: list[RoomAnswer]) -> list[RoomAnswer]:
    """The answers with a second table in each bare kitchen of a home that eats elsewhere."""
    found = answers
    for room, task in enumerate(home.tasks) if may_settle(home) else ():
        placed = answers[room].placed
        if not _is_without_table(task, placed) or not may_take_in(task, "dining_wall"):
            continue
        radius = find_void(task, pieces_of(task, placed)).radius
        for seats in (USUAL, LEAST) if radius >= BARE else ():
            fit = [c for c in list_tables(seats) if min(c.width, c.depth) / 2 - TUCKED <= radius]
            place = NeedRoom(room, placed, Wish("dining_wall", 1), 0)
            more = settle_need(
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
    if not may_settle(home) or any(p.category in SOFT_SEATS for each in placed for p in each):
        return answers
    rooms = list_need_rooms(home, answers, SAT_IN, "reading", frozenset())
    tasks = home.tasks
    found = settle_need(
        home, answers, rooms, STAGES, lambda place, _: iter(list_seats(not place.tier)), None
    )
    if found is not answers:
        return found
    large = [p for p in rooms if tasks[p.room].ground.area >= SECOND_ZONE_FROM]
    found = settle_need(
        home, answers, large, STAGES[:2], lambda *_: iter(tuple(talking())), lambda _: True
    )
    if found is not answers:
        return found
    return _say_why(home, answers, SAT_IN, Wish("reading", 1), "", "an armchair", list_seats(False))


def hang_clothes(home: HomeState, answers: list[RoomAnswer]) -> list[RoomAnswer]:
    """The answers with wider wardrobes where a home owes more rail than it has, or something that
    holds things made room for a need; and with that elsewhere."""
    found, wardrobe = answers, frozenset(("wardrobe",))
    rail = measure_widths(wardrobe)
    if home.household is None or not may_settle(home):
        return answers
    lost = [m.wish.group for a in answers for m in a.missing if has_made_room(m)]
    lost = [group for group in lost if group in STORED]
    for room in range(len(home.tasks)):
        if _count(rail, found) >= RAIL * home.household.residents and not lost:
            break
        rooms = list_need_rooms(home, found, HUNG_IN, "wardrobe", wardrobe)
        own = [g for g in found[room].placed if g.wish.group == "wardrobe"]
        place = next((p for p in rooms if p.room == room), None)
        if place is None or not own:
            continue
        least = own[0].pieces[0].size.width + GROWN
        known = list_forms(home.tasks[room], own[0])
        wide = [c for c in known if c.members[0].size.width >= least][:WIDE]
        found = _settle_roomy(home, found, (place,), wide)
    for group in lost:
        rooms = list_need_rooms(home, found, STORED_IN, group, frozenset())
        forms = sorted(cases(group).groups, key=lambda case: -case.width)
        found = _settle_roomy(home, found, rooms, forms)
    return found


def _settle_roomy(
    home: HomeState, answers: list[RoomAnswer], rooms: Sequence[NeedRoom], forms: Sequence[Group]
) -> list[RoomAnswer]:
    """The answers with one of the forms in one of the rooms beside all else, if nothing would be
    left out for it."""
    found = settle_need(home, answers, rooms, (Stage(),), lambda *_: iter(forms), None)
    each = zip(home.tasks, answers, found, strict=True)
    return found if all(is_roomy(t, old.placed, new.placed) for t, old, new in each) else answers


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
    lacking = [m for a in answers for m in a.missing if m.wish.group in list_serving(wish)]
    if any(m.wish.required or not m.wish.rank for m in lacking):
        return answers
    rooms = list_need_rooms(home, answers, tiers, wish.group, list_serving(wish))[:PROVED]
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
