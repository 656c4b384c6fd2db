"""The functional zones of a hall: from what the brief says to polygons that fit the floor.

Zones never overlap and never leave the floor; what belongs to no zone is circulation. Links tell
between which zones people must be able to walk.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import NamedTuple

import shapely

from scenewright import outlines
from scenewright.borders import Border, WallStretch, border_lengths, shared_borders, wall_stretches
from scenewright.brief import Brief, Room
from scenewright.errors import InputError
from scenewright.plan import place
from scenewright.scene_graph import Zone, ZoneLink
from scenewright.space import Space

__all__ = ["Border", "HallPlan", "WallStretch", "borders_of", "wall_stretches", "zones_of"]

OUTSIDE = 0.02
OVERLAP = 0.02
LEAST_ZONE = 1.0
NEGLIGIBLE = 0.05


class HallPlan(NamedTuple):
    """The zones of a hall and the links between them."""

    zones: tuple[Zone, ...]
    links: tuple[ZoneLink, ...]


def zones_of(brief: Brief, number: int, space: Space) -> HallPlan:
    """The zones and links of room ``number`` of a brief, whose space is ``space``.

    Raises InputError, with the place in the brief, for zones that cannot be built and links that
    cannot be walked.
    """
    room = brief.rooms[number]
    check_names(brief, number, space)
    zones = given_zones(brief, number, space)
    if not room.zones:
        zones = (zone_of(floor_of(space), ("hall", room.name), space),)
    borders = shared_borders(zones)
    links = _given_links(brief, number, space, zones, borders)
    return HallPlan(zones, links or default_links(zones, borders, brief.passage_width))


def borders_of(plan: HallPlan, space: Space) -> tuple[Border, ...]:
    """The straight pieces of border between every two zones of a hall: passages lead through
    them and partitions stand on them."""
    del space
    return shared_borders(plan.zones)


def floor_of(space: Space) -> shapely.Polygon:
    """The floor of a space: its outline without its holes."""
    return shapely.Polygon(space.outline, space.holes)


def zone_of(outline: shapely.Polygon, name: tuple[str, str], space: Space) -> Zone:
    """A zone with a clean outline; ``name`` is its id and its name."""
    ring, holes = outlines.rings(outline)
    return Zone(name[0], name[1] or name[0], space.id, ring, holes)


def given_zones(brief: Brief, number: int, space: Space) -> tuple[Zone, ...]:
    """The zones whose outline the brief states, cut to the floor."""
    floor, shell = floor_of(space), shapely.Polygon(space.outline)
    reach = OUTSIDE + (brief.wall_thickness if brief.outlines == "centre" else 0.0)
    found: list[tuple[str, shapely.Polygon]] = []
    zones: list[Zone] = []
    for index, wish in enumerate(brief.rooms[number].zones):
        if wish.outline is None:
            continue
        told = place(brief, number, f"zones[{index}] '{wish.id}'")
        try:
            shape = outlines.polygon(wish.outline)
            _check_inside(shape, shell, reach)
            part = _one_piece(shape.intersection(floor))
            _check_apart(part, found)
            part = _one_piece(part.difference(shapely.union_all([s for _, s in found])))
        except InputError as error:
            raise error.located(place=told) from None
        found.append((wish.id, part))
        zones.append(zone_of(part, (wish.id, wish.name), space))
    return tuple(zones)


def default_links(
    zones: tuple[Zone, ...], borders: tuple[Border, ...], width: float
) -> tuple[ZoneLink, ...]:
    """Links that make every zone reachable where the brief states none: the spanning tree of
    greatest borders (Kruskal 1956) among the zones that share one at least ``width`` long."""
    lengths = border_lengths(borders)
    root = list(range(len(zones)))
    links = []
    for (first, second), length in sorted(lengths.items(), key=lambda row: (-row[1], row[0])):
        if length >= width and root[first] != root[second]:
            root = [root[first] if one == root[second] else one for one in root]
            links.append((first, second))
    return tuple(
        ZoneLink(zones[i].space, zones[i].id, zones[j].id, width) for i, j in sorted(links)
    )


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
    doors = [opening.id for opening in space.openings if opening.kind != "window"]
    for index, zone in enumerate(room.zones):
        told = place(brief, number, f"zones[{index}] '{zone.id}'")
        if zone.id in [earlier.id for earlier in room.zones[:index]]:
            raise InputError("the id is used twice", "give every zone its own id", place=told)
        for name in zone.beside:
            _check_known(name, names, f"{told} beside", "zone")
            if name == zone.id:
                raise InputError("is to lie beside itself", "name another zone", place=told)
        if zone.door is not None:
            _check_known(zone.door, doors, f"{told} door", "door of the hall")
    for index, link in enumerate(room.links):
        told = place(brief, number, f"links[{index}]")
        for name in link.between:
            _check_known(name, names, told, "zone")
        if link.between[0] == link.between[1]:
            raise InputError(f"links '{link.between[0]}' with itself", "name two zones", place=told)
    for index, demand in enumerate(room.demands):
        told = place(brief, number, f"demands[{index}] '{demand.id or demand.category}' zone")
        for name in _names(demand.zone):
            _check_known(name, names, told, "zone")


def _names(zone: str | list[str] | None) -> list[str]:
    return [zone] if isinstance(zone, str) else list(zone or ())


def _check_known(name: str, known: Iterable[str], told: str, what: str) -> None:
    listed = list(known)
    if name in listed:
        return
    near = difflib.get_close_matches(name, listed, 3) or listed[:12]
    remedy = f"use one of: {', '.join(near)}" if near else f"there is no {what}: leave it out"
    raise InputError(f"'{name}' is no {what}", remedy, place=told)


def _check_inside(shape: shapely.Polygon, shell: shapely.Polygon, reach: float) -> None:
    points = shapely.points(shapely.get_coordinates(shape.difference(shell)))
    away = shapely.distance(points, shell)
    if len(away) and away.max() > reach:
        far = points[int(away.argmax())]
        raise InputError(
            f"reaches {away.max():.2f} m out of the hall at ({far.x:.2f}, {far.y:.2f})",
            "keep its corners inside the hall's outline",
        )


def _one_piece(shape: shapely.Geometry) -> shapely.Polygon:
    """The largest part of a zone, if all others together are negligible."""
    parts = [part for part in shapely.get_parts(shape).tolist() if part.area > 0.0]
    parts = sorted((p for p in parts if p.geom_type == "Polygon"), key=lambda part: -part.area)
    if not parts or parts[0].area < LEAST_ZONE:
        area = parts[0].area if parts else 0.0
        raise InputError(
            f"holds only {area:.2f} m² of floor", f"a zone needs at least {LEAST_ZONE:g} m²"
        )
    if sum(part.area for part in parts[1:]) > max(NEGLIGIBLE, 0.01 * parts[0].area):
        raise InputError(
            f"is cut into {len(parts)} pieces by walls, columns or other zones, the second of "
            f"{parts[1].area:.2f} m²",
            "make each piece a zone of its own",
        )
    largest: shapely.Polygon = parts[0]
    return largest


def _check_apart(shape: shapely.Polygon, found: list[tuple[str, shapely.Polygon]]) -> None:
    for name, other in found:
        shared = shape.intersection(other)
        if shared.area > OVERLAP:
            middle = shared.representative_point()
            raise InputError(
                f"overlaps zone '{name}' by {shared.area:.2f} m² "
                f"near ({middle.x:.2f}, {middle.y:.2f})",
                "move their common border",
            )


def _given_links(
    brief: Brief, number: int, space: Space, zones: tuple[Zone, ...], borders: tuple[Border, ...]
) -> tuple[ZoneLink, ...]:
    order = {zone.id: index for index, zone in enumerate(zones)}
    lengths = border_lengths(borders)
    widest: dict[tuple[int, int], float] = {}
    for index, link in enumerate(brief.rooms[number].links):
        width = brief.passage_width if link.width is None else link.width
        first, second = sorted(order[name] for name in link.between)
        length = lengths.get((first, second), 0.0)
        if length < width - OUTSIDE:
            told = place(brief, number, f"links[{index}]")
            raise InputError(_no_passage(link.between, length, width), _WIDEN, place=told)
        widest[first, second] = max(width, widest.get((first, second), 0.0))
    return tuple(
        ZoneLink(space.id, zones[i].id, zones[j].id, width)
        for (i, j), width in sorted(widest.items())
    )


_WIDEN = "draw the zones so that they share a longer border, or leave out the link"


def _no_passage(between: tuple[str, str], length: float, width: float) -> str:
    first, second = between
    if length == 0.0:
        return f"the zones '{first}' and '{second}' share no border"
    return (
        f"the border of the zones '{first}' and '{second}' is only {length:.2f} m long, "
        f"the passage is to be {width:g} m wide"
    )
