"""One programme for the whole home: what it has once, and in which of its rooms.

Rooms are furnished one by one, and each would bring what its function asks for. What a home has
once is decided first: where its people eat, where shoes stand, where one works and where the
washing is done. Residents are counted from the bedrooms: two in a room for two, one in any other,
two where children share. Where a brief states how many live there, beds and seats follow: bunks
where beds are short, a table and sofas with a place for each.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building.ceiling import living_area, planes
from scenewright.building.labels import is_entered
from scenewright.building.room_needs import USABLE
from scenewright.catalog.classes import DESKS, TABLE_SEATS
from scenewright.core.brief import Room
from scenewright.core.catalog import Group, Member
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut, Solution
from scenewright.core.space import Space
from scenewright.domains.home.cases.library import (
    SHIPPED,
    Cases,
    Library,
    cases,
    index_cases,
    subset,
)
from scenewright.domains.home.groups.classes import COOKING, SLEPT_IN, TABLES, WET_ROOMS
from scenewright.domains.home.groups.dining import tables_for_many
from scenewright.domains.home.groups.living import seats_for_many
from scenewright.domains.home.measures import SOFA_OF_THREE
from scenewright.domains.home.programme import Wish, resolve_bedrooms

SLEEPERS = {"double_bedroom": 2, "single_bedroom": 1, "child_bedroom": 1}
SHARED_ROOM = 14.0  # area from which two children share a room, m²
LEAST_EATING = 9.0  # a room of less has no table put into it for the home's sake, square metres
LEAST_DESK, LEAST_WORKING = 6.5, 13.0  # the same of a desk, where one sleeps alone, and elsewhere
LEAST_BUNK = 7.0  # a room of less has no bunk beds, square metres
ALL_ROUND, LEAST_TABLE = 4, 14.0  # residents and square metres from which a table stands free
SEATED: dict[str, tuple[float, int]] = {
    "dining": (0.3, 8),
    "dining_wall": (0.25, 6),
    "seating": (0.45, 5),
}
"""Groups with a place for each resident: the share of its room's floor it takes at most, and how
many it seats at most."""
FURTHER = {"dining_wall": tables_for_many, "seating": seats_for_many}
"""Forms beside the usual ones, so that there are such with enough places."""
BED_PLACES = {"double_bed": 2, "single_bed": 1, "bunk_bed": 2}
SOFA_PLACES = {"sofa": 3, "loveseat": 2, "corner_sofa": 4, "armchair": 1}
WASHER = "washer"
STORING = frozenset(
    ("wardrobe", "chest_of_drawers", "bookcase", "sideboard", "shelf_unit", "storage_shelf")
)
WASHROOM = "washroom"
WET = ("bathroom", "toilet", WASHROOM)


class Household(NamedTuple):
    """What is decided for a home as a whole: how many live there, in how many bedrooms; the rooms
    (their ids, empty: none) where they eat, where shoes stand and where one works; the wet rooms;
    where a number of residents is ``stated``, the rooms that get ``bunks``, those large enough for
    two children in which one sleeps ``alone``; the area of each room, square metres; which
    washroom has the washing machine, and in which of several kitchens one cooks.
    """

    residents: int
    bedrooms: int
    eats_in: str
    shoes_in: str
    works_in: str
    wet: tuple[str, ...]
    stated: bool = False
    bunks: tuple[str, ...] = ()
    alone: tuple[str, ...] = ()
    areas: Mapping[str, float] = MappingProxyType({})
    washes_in: str = ""
    cooks_in: str = ""


def decide_household(rooms: Sequence[Space], stated: int | None = None) -> Household:
    """The programme of a home, from its rooms and the number of residents, if one is stated.

    >>> import numpy as np
    >>> def room(name, use, w, d):
    ...     return Space(name, name, (use,), "0", np.array([[0, 0], [w, 0], [w, d], [0, d]]) * 1.0)
    >>> home = decide_household([room("a", "bedroom", 4, 3), room("b", "bedroom", 2.5, 3),
    ...                          room("c", "living", 5, 4), room("d", "hall", 2, 2)])
    >>> home.residents, home.eats_in, home.shoes_in, home.works_in
    (3, 'c', 'd', 'b')
    >>> decide_household([room("b", "bedroom", 2.5, 3)], 2).bunks
    ('b',)
    """
    areas = {room.id: _area(room) for room in rooms}
    uses = {room.id: resolve_bedrooms(room.functions, areas[room.id]) for room in rooms}
    beds = [_sleepers(uses[room.id], areas[room.id]) for room in rooms]
    halls = [room for room in rooms if "hall" in uses[room.id]]
    entered = [room for room in halls if _is_entered(room)] or halls

    wet = tuple(room.id for room in rooms if set(WET) & set(uses[room.id]))
    reached = [room.id for room in rooms if is_entered(room)] or list(areas)

    def largest(functions: Sequence[str], least: float = 0.0, but: Sequence[str] = ()) -> str:
        for function in functions:
            known = [
                k for k in reached if function in uses[k] and areas[k] >= least and k not in but
            ]
            if known:
                return max(known, key=lambda k: areas[k])
        return ""

    return Household(
        residents=stated or max(sum(beds), 1),
        bedrooms=sum(bed > 0 for bed in beds),
        eats_in=largest(("dining",)) or largest(("living", "kitchen"), LEAST_EATING),
        shoes_in=max(entered, key=lambda room: areas[room.id]).id if entered else "",
        works_in=largest(("study",))
        or largest(("single_bedroom",), LEAST_DESK)
        or largest(("double_bedroom", "living"), LEAST_WORKING),
        wet=wet,
        stated=stated is not None,
        bunks=_bunks(uses, areas, (stated or 0) - sum(beds)),
        alone=_alone(uses, areas, sum(beds) - (stated or sum(beds))),
        areas=areas,
        washes_in=largest((WASHROOM,)),
        cooks_in=largest(("kitchen",), USABLE["kitchen"].area, wet) or largest(("kitchen",)),
    )


def _bunks(
    uses: Mapping[str, Sequence[str]], areas: Mapping[str, float], short: int
) -> tuple[str, ...]:
    """The rooms of single beds that get bunks instead while beds are short, the largest first."""
    single = [
        room
        for room, functions in uses.items()
        if areas[room] >= LEAST_BUNK and _sleepers(functions, areas[room]) == 1
    ]
    return tuple(sorted(single, key=lambda room: -areas[room])[: max(short, 0)])


def _alone(
    uses: Mapping[str, Sequence[str]], areas: Mapping[str, float], spare: int
) -> tuple[str, ...]:
    """The rooms large enough for two children that one has while beds are to spare, the smallest
    first."""
    shared = [
        room
        for room, functions in uses.items()
        if "double_bedroom" not in functions and _sleepers(functions, areas[room]) > 1
    ]
    return tuple(sorted(shared, key=lambda room: areas[room])[: max(spare, 0)])


def _area(room: Space) -> float:
    shape = shapely.Polygon(room.outline, list(room.holes))
    return float(living_area(shape, planes(room), room.height))


def _sleepers(functions: Sequence[str], area: float) -> int:
    """How many sleep in a room."""
    most = max((SLEEPERS.get(function, 0) for function in functions), default=0)
    return 2 if "child_bedroom" in functions and area >= SHARED_ROOM else most


def count_residents(rooms: Sequence[Space]) -> int:
    """How many sleep in rooms that are furnished by what they are for."""
    areas = {room.id: _area(room) for room in rooms}
    return sum(_sleepers(resolve_bedrooms(r.functions, areas[r.id]), areas[r.id]) for r in rooms)


def is_dwelling(rooms: Iterable[Space]) -> bool:
    """Whether rooms make a dwelling: one in which people sleep or live, and another with water."""
    uses = [frozenset(room.functions) for room in rooms]
    lived = any(use & (SLEPT_IN | {"living"}) for use in uses)
    return lived and any(use & (WET_ROOMS | {"kitchen"}) for use in uses)


def _is_entered(room: Space) -> bool:
    """Whether one comes into a room from outside."""
    return any(o.kind == "door" and len(o.spaces) == 1 for o in room.openings)


def share_out(
    household: Household, room: str, wishes: tuple[Wish, ...], others: frozenset[str]
) -> tuple[Wish, ...]:
    """The wishes of a room as the household has them: shoes stand in one room, elsewhere is a rack
    for coats; of several washrooms one has the washing machine, and no second kitchen is fitted
    into a wet room; a home none of whose rooms brings a table eats where it has room.
    ``others`` are the groups that all rooms wish for.

    >>> home = Household(3, 2, "living", "hall", "", ())
    >>> [wish.group for wish in share_out(home, "landing", (Wish("shoes", 1),), frozenset())]
    ['coats']
    """
    found = list(wishes)
    if room != household.shoes_in:
        away = [wish for wish in found if wish.group == "shoes" and not wish.required]
        racks = [wish._replace(group="coats") for wish in away]
        found = [w for w in found if w not in away and not (racks and w.group == "coats")]
        found += racks
    if household.washes_in not in ("", room):
        found = [wish for wish in found if wish.group != WASHER or wish.required]
    if has_no_kitchen(household, room):
        found = [wish for wish in found if wish.group not in COOKING or wish.required]
    if any(wish.group in TABLES and wish.required for wish in found):
        found = [wish for wish in found if wish.group not in TABLES or wish.required]
    if room == household.eats_in and not others & TABLES:
        found.append(Wish("dining_wall", 1))
    return tuple(_for_residents(household, room, wish) for wish in found)


def has_no_kitchen(household: Household, room: str) -> bool:
    """Whether a room is wet and the home cooks in another: it is no second kitchen."""
    return room in household.wet and household.cooks_in not in ("", room)


def explain_no_kitchen(household: Household, room: Room, out: LeftOut) -> LeftOut:
    """What is left out of a room, a second kitchen that nobody asked for with the reason why there
    is none.

    >>> home = Household(1, 1, "", "", "", ("bath",), cooks_in="living")
    >>> room = Room(outline=[(0, 0), (2, 0), (2, 2), (0, 2)])
    >>> explain_no_kitchen(home, room, LeftOut("bath", "kitchen", "no place", True)).reason
    'the home cooks in living'
    """
    asked = room.ask is not None or any(wish.required for wish in room.wishes)
    if asked or out.what not in COOKING or not has_no_kitchen(household, out.space):
        return out
    return out._replace(reason=f"the home cooks in {household.cooks_in}")


def _for_residents(household: Household, room: str, wish: Wish) -> Wish:
    """A wish as the stated residents need it: a bunk for a single bed or, where beds suffice, a
    single bed for a bunk, a table all round."""
    if wish.group == "single" and room in household.bunks:
        return wish._replace(group="bunk")
    if wish.group == "bunk" and room in household.alone:
        return wish._replace(group="single")
    if not household.stated or wish.group not in TABLES:
        return wish
    area, people = household.areas.get(room, 0.0), household.residents
    many = people >= ALL_ROUND and area >= LEAST_TABLE
    places = {group: min(_most_places(group, area), people) for group in sorted(TABLES)}
    usual = "dining" if many else wish.group
    group = "dining_wall" if places["dining_wall"] > places["dining"] else usual
    here = household.eats_in in ("", room)
    return wish._replace(group=group, rank=0 if here else wish.rank)


def _most_places(group: str, area: float) -> int:
    """How many the largest case of a group seats that leaves a room of an area its floor."""
    share, most = SEATED[group]
    fits = (c for c in _every_case(group, SHIPPED).groups if c.width * c.depth <= share * area)
    return min(max(map(_places, fits), default=0), most)


def _every_case(group: str, library: Library) -> Cases:
    """The cases of a group, with further forms unless they are the user's own."""
    known = cases(group, library)
    if group not in FURTHER or group in library.own:
        return known
    return index_cases((*known.groups, *FURTHER[group]()))


def seat_residents(household: Household, room: str, library: Library) -> Library:
    """The library of a room with a place for each of the stated residents at its table and, up to
    those of :data:`SEATED`, on its sofas, as far as such cases leave the room its floor."""
    if not household.stated:
        return library
    own = dict(library.own)
    for group, (share, most) in SEATED.items():
        known = _every_case(group, library)
        room_for = share * household.areas[room]
        fits = [c.width * c.depth <= room_for for c in known.groups]
        least = min(household.residents, most)
        best = max((_places(c) for c, ok in zip(known.groups, fits, strict=True) if ok), default=0)
        kept = np.array(
            [
                ok and _places(c) >= min(least, best)
                for c, ok in zip(known.groups, fits, strict=True)
            ]
        )
        if kept.any() and not kept.all():
            own[group] = subset(known, kept)
    seated = frozenset(own.keys() - library.own.keys())
    return library._replace(own=own, seated=seated)


def count_places(parts: Iterable[Member | Piece]) -> int:
    """How many sit on the parts of a case, or on pieces: on chairs, or on sofas by their width."""
    places = {"dining_chair": 1, "armchair": 1, "loveseat": 2, "sofa": 3, "corner_sofa": 4}
    return sum(
        places.get(part.category, 0) - (part.category == "sofa" and part.size.width < SOFA_OF_THREE)
        for part in parts
    )


def _places(case: Group) -> int:
    """How many sit in a case."""
    return count_places(case.members)


def tell_programme(solution: Solution, plan: Plan) -> str:
    """The programme of a home and what came of it, in one paragraph."""
    household = decide_household(plan.spaces, solution.brief.residents)
    names, pieces = plan.names, solution.pieces
    parts = [_tell_people(household, pieces)]
    if household.stated:
        parts.append(_tell_places(pieces, household.residents))
    if household.eats_in:
        parts.append(f"they eat in {_tell_chairs(household.eats_in, pieces, names)}")
    if (
        household.wet
        and household.bedrooms
        and not any("kitchen" in r.functions for r in plan.spaces)
    ):
        parts.append("no room is a kitchen")
    if household.works_in and any(p.function in DESKS for p in pieces):
        parts.append(f"the desk is in {_where(pieces, DESKS, names)}")
    if household.shoes_in:
        parts.append(f"shoes are in {names[household.shoes_in]}")
    if household.wet:
        parts.append(f"water is in {', '.join(names[room] for room in household.wet)}")
    metres = sum(p.size.width for p in pieces if p.category in STORING)
    return f"{'; '.join(parts)}; {metres:.1f} m of storage."


def _tell_people(household: Household, pieces: Sequence[Piece]) -> str:
    """How many live here, or sleep here where that is not stated, and in how many rooms: those
    with beds."""
    beds = [p for p in pieces if p.category in BED_PLACES]
    people = household.residents if household.stated else sum(BED_PLACES[p.category] for p in beds)
    rooms = _count(len({p.space for p in beds}), "bedroom")
    return (
        f"{people or 'no'} {'person' if people == 1 else 'people'} in {rooms}"
        if people
        else "no bed"
    )


def _tell_places(pieces: Sequence[Piece], people: int) -> str:
    """Beds and seats for the stated residents, and how many are short."""
    parts = []
    for what, places in (("beds", BED_PLACES), ("sofa seats", SOFA_PLACES)):
        count = sum(places.get(p.category, 0) for p in pieces)
        short = f" ({people - count} short)" if count < people else ""
        parts.append(f"{what} for {count}{short}")
    return ", ".join(parts)


def _tell_chairs(eats_in: str, pieces: Sequence[Piece], names: Mapping[str, str]) -> str:
    """The room in which they eat and every other with chairs at a table, with how many."""
    chairs = Counter(p.space for p in pieces if p.category in TABLE_SEATS and p.function in TABLES)
    rooms = dict.fromkeys((eats_in, *chairs))
    return " and ".join(f"{names[room]} ({_count(chairs[room], 'chair')})" for room in rooms)


def _count(number: int, what: str) -> str:
    return f"{number or 'no'} {what}{'' if number == 1 else 's'}"


def _where(pieces: Sequence[Piece], groups: frozenset[str], names: Mapping[str, str]) -> str:
    """The rooms in which groups stand."""
    rooms = dict.fromkeys(names[p.space] for p in pieces if p.function in groups)
    return ", ".join(rooms)
