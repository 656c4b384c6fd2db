"""Which zones a hall is to have: their names, checked, and the area each needs."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable

import shapely

from scenewright.building.plan import place
from scenewright.core.brief import Brief, Room
from scenewright.core.brief.zones import ZoneBrief
from scenewright.core.errors import InputError
from scenewright.core.space import Space
from scenewright.domains.hall.demands.checked import floor_needed
from scenewright.domains.hall.hall_layout import Zone
from scenewright.domains.hall.visit.doors import ways_in
from scenewright.domains.hall.visit.roles import turn_of
from scenewright.domains.hall.zoning import LEAST_ZONE, ZoneWish
from scenewright.domains.hall.zoning.borders import floor_of

MOST_ZONES = 200
AT_DOOR = 0.5
"""A drawn zone this near to a door holds it, in metres."""
ENTRIES = frozenset(
    [
        "entrance",
        "entry",
        "foyer",
        "lobby",
        "reception",
        "welcome",
        "front",
        "vestibule",
        "arrival",
        "eingang",
        "empfang",
        "foyers",
        "entrée",
        "accueil",
        "vestibulo",
        "entrada",
        "recepción",
    ]
)
"""Names of the zone at the entrance."""


def zone_names(room: Room) -> tuple[str, ...]:
    """The ids of a hall's zones: those listed, else those its demands name."""
    listed = [zone.id for zone in room.zones]
    asked = (name for demand in room.demands for name in _names(demand.zone))
    return tuple(dict.fromkeys(listed or asked))


def check_names(brief: Brief, number: int, space: Space) -> None:
    """InputError where a zone is listed twice or a name in zones, links or demands means
    nothing."""
    room = brief.rooms[number]
    names = zone_names(room)
    if len(names) > MOST_ZONES:
        raise InputError(
            f"the demands name {len(names)} zones",
            f"a hall has at most {MOST_ZONES}: divide the hall",
            place=place(brief, number, "demands"),
        )
    doors = [opening.id for opening in space.openings if opening.kind != "window"]
    for index, zone in enumerate(room.zones):
        where = place(brief, number, f"zones[{index}] '{zone.id}'")
        if zone.id in [earlier.id for earlier in room.zones[:index]]:
            raise InputError("the id is used twice", "give every zone its own id", place=where)
        for name in zone.beside:
            _check_known(name, names, f"{where} beside", "zone")
            if name == zone.id:
                raise InputError("is to lie beside itself", "name another zone", place=where)
        if zone.area is not None and zone.area < LEAST_ZONE:
            raise InputError(
                f"is to have only {zone.area:g} m²",
                f"a zone needs at least {LEAST_ZONE:g} m²",
                place=where,
            )
        if zone.door is not None:
            _check_known(zone.door, doors, f"{where} door", "door of the hall")
    for index, link in enumerate(room.links):
        where = place(brief, number, f"links[{index}]")
        for name in link.between:
            _check_known(name, names, where, "zone")
        if link.between[0] == link.between[1]:
            raise InputError(
                f"links '{link.between[0]}' with itself", "name two zones", place=where
            )
    for index, demand in enumerate(room.demands):
        where = place(brief, number, f"demands[{index}] '{demand.id or demand.category}' zone")
        for name in _names(demand.zone):
            _check_known(name, names, where, "zone")


def wishes_of(
    brief: Brief, number: int, space: Space, given: dict[str, Zone]
) -> tuple[ZoneWish, ...]:
    """The zones of a hall as they are wanted, with the area each needs.

    Areas that are given stay as they are; what is left of the floor is shared by what the zones
    are to hold, an empty one counting as a third of the mean.
    """
    room = brief.rooms[number]
    names = zone_names(room) or ("hall",)
    listed = {zone.id: zone for zone in room.zones} or {n: ZoneBrief(id=n) for n in names}
    areas = {name: zone.area for name, zone in listed.items() if zone.area and name not in given}
    free = floor_of(space).area - sum(
        shapely.Polygon(zone.outline, zone.holes).area for zone in given.values()
    )
    open_ = [name for name in names if name not in given and name not in areas]
    left = free - sum(areas.values())
    if areas and left < -0.02 * free:
        raise InputError(
            f"the zones ask for {sum(areas.values()):.1f} m², but only {free:.1f} m² of floor "
            "are free",
            "give smaller areas",
            place=place(brief, number, "zones"),
        )
    if open_ and left < LEAST_ZONE * len(open_):
        raise InputError(
            f"only {max(left, 0.0):.1f} m² of floor are left for " + _format_list(open_),
            "make the other zones smaller, or leave out some",
            place=place(brief, number, "zones"),
        )
    needs = _needs(room, open_)
    areas |= {name: left * needs[name] / sum(needs.values()) for name in open_}
    doors = {name: zone.door for name, zone in listed.items()} | _entrance_zone(
        room, space, listed, given
    )
    return tuple(
        ZoneWish(
            name,
            zone.name or (room.name if name == "hall" else ""),
            areas.get(name, 0.0),
            tuple(zone.beside),
            doors[name],
            given.get(name),
        )
        for name, zone in listed.items()
    )


def _entrance_zone(
    room: Room, space: Space, listed: dict[str, ZoneBrief], given: dict[str, Zone]
) -> dict[str, str | None]:
    """The zone that is to lie at the main entrance though the brief does not say so: one called
    foyer or the like, else that of the desk visitors come to first or of the tills; none where a
    zone is drawn there or another asks for a door to come in by."""
    doors = ways_in(space)
    taken = {zone.door for zone in listed.values()}
    if not doors or len(listed) < 2 or taken & {door.id for door in doors}:
        return {}
    main = shapely.Point(doors[0].x, doors[0].y)
    if any(main.distance(shapely.Polygon(zone.outline)) < AT_DOOR for zone in given.values()):
        return {}
    free = [name for name, zone in listed.items() if name not in given and zone.door is None]
    called = [name for name in free if _is_entry(f"{name} {listed[name].name or ''}")]
    return dict.fromkeys([*called, *_arrival(room, free)][:1], doors[0].id)


def _is_entry(name: str) -> bool:
    """Whether a zone is called what one comes into first."""
    return bool(ENTRIES & set(re.findall(r"[^\W\d_]+", name.casefold())))


def _arrival(room: Room, free: list[str]) -> list[str]:
    """Of the zones those that hold a desk to ask at, then those that hold tills."""
    beside = {demand.category for demand in room.demands}
    return [
        name
        for turn in (0, 2)
        for demand in room.demands
        for name in _names(demand.zone)
        if name in free and turn_of(demand.category, beside) == turn
    ]


def _format_list(names: list[str]) -> str:
    names_listed = ", ".join(f"'{name}'" for name in names[:5])
    return names_listed + f" and {len(names) - 5} more" * (len(names) > 5)


def _needs(room: Room, names: list[str]) -> dict[str, float]:
    """What each zone is to hold, as square metres of objects with their clearances; a demand
    for several zones is shared evenly."""
    needs = dict.fromkeys(names, 0.0)
    for demand in room.demands:
        wanted = _names(demand.zone)
        for name in wanted:
            if name in needs:
                needs[name] += floor_needed(demand) / len(wanted)
    mean = sum(needs.values()) / max(sum(need > 0 for need in needs.values()), 1)
    return {name: max(need, mean / 3, 1e-3) for name, need in needs.items()}


def _names(zone: str | list[str] | None) -> list[str]:
    return [zone] if isinstance(zone, str) else list(zone or ())


def _check_known(name: str, known: Iterable[str], where: str, what: str) -> None:
    listed = list(known)
    if name in listed:
        return
    near = difflib.get_close_matches(name, listed, 3) or listed[:12]
    remedy = f"use one of: {', '.join(near)}" if near else f"there is no {what}: leave it out"
    raise InputError(f"'{name}' is not a {what}", remedy, place=where)
