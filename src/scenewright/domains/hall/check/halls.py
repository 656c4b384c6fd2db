"""Halls as the referee sees them: zones, groups and links of the scene graph as exact shapes.

The scene graph comes with the answer and is input like any other: what it names that is not
there becomes a finding, never an error.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.check.bodies import PARTITION, Bodies, Indices, Members, Rooms, Shape, Shapes
from scenewright.core.brief import Room
from scenewright.core.report import Finding
from scenewright.core.space import Points, Space
from scenewright.domains.hall.hall_layout import HallLayout, Tour, Zone

_FAR = 1e5
_NO_FLOOR = 1e-4


class JudgedLink(NamedTuple):
    """Two zones by number, and the clear width in metres asked for between them."""

    first: int
    second: int
    width: float


class JudgedHall(NamedTuple):
    """One space: its number and free area, zones (ids, shapes, and which have their outline from
    the brief), links, groups, ``objects`` the rows of all their objects, ``solids`` the rows of
    what takes up floor a person needs (chairs included), ``partitions`` those that are walls,
    and the visitors' ``tour``."""

    space: Space
    room: int
    shape: Shape
    zones: tuple[str, ...]
    areas: Shapes
    given: tuple[bool, ...]
    links: tuple[JudgedLink, ...]
    groups: tuple[Members, ...]
    objects: Indices
    solids: Indices
    partitions: Indices
    tour: Points | None


def halls_of(
    graph: HallLayout,
    tours: tuple[Tour, ...],
    wishes: Mapping[str, Room],
    passage: float,
    bodies: Bodies,
    rooms: Rooms,
) -> tuple[list[JudgedHall], list[Finding]]:
    """Every space as a hall, and a finding for what the graph holds that cannot be judged.

    ``wishes`` are the rooms of the brief by the id of their space; a link the brief asks for is
    judged even if the graph lacks it, at ``passage`` metres where it states no width.
    """
    level = {space.id: space.level for space in rooms.spaces}
    faults: list[tuple[str, str]] = []
    rows = {piece.id: row for row, piece in reversed(list(enumerate(bodies.pieces)))}
    zones, groups = _zones(graph, level, faults), _groups(graph, level, rows, faults)
    links = _links(graph, zones, level, faults)
    halls = [
        _hall(room, rooms, bodies, zones, groups, links, tours, wishes.get(space.id), passage)
        for room, space in enumerate(rooms.spaces)
    ]
    for hall, placed in ((hall, groups.get(hall.space.id, [])) for hall in halls):
        faults += [
            (hall.space.id, f"group {message} is said to be in zone {zone}, which is not there")
            for message, zone, _ in placed
            if zone not in hall.zones
        ]
    return halls, [
        Finding("malformed", level.get(s, ""), s, "", "", message) for s, message in faults
    ]


_Zones = dict[str, dict[str, Shape]]
_Groups = dict[str, list[tuple[str, str, Indices]]]
_Faults = list[tuple[str, str]]


def _zones(graph: HallLayout, level: dict[str, str], faults: _Faults) -> _Zones:
    """Shapes of zones by space and id."""
    zones: _Zones = {space: {} for space in level}
    for zone in graph.zones:
        shape = _shape(zone)
        if zone.space not in zones:
            fault = f"zone {zone.id} lies in {zone.space!r}, which is not a room"
            faults.append((zone.space, fault))
        elif zone.id in zones[zone.space]:
            faults.append((zone.space, f"zone {zone.id} is there twice"))
        elif shape.is_empty:
            faults.append((zone.space, f"zone {zone.id} has no floor"))
        else:
            zones[zone.space][zone.id] = shape
    return zones


def _shape(zone: Zone) -> Shape:
    rings = [np.asarray(ring, float) for ring in (zone.outline, *zone.holes)]
    sound = [ring for ring in rings if ring.ndim == 2 and len(ring) > 2 and _finite(ring)]
    if not sound or sound[0] is not rings[0]:
        return shapely.Polygon()
    shape = shapely.Polygon(np.round(sound[0], 6), [np.round(ring, 6) for ring in sound[1:]])
    shape = shape if shape.is_valid else shape.buffer(0)
    return shape if shape.area > _NO_FLOOR else shapely.Polygon()


def _finite(points: Points) -> bool:
    return bool(np.isfinite(points).all() and np.abs(points).max(initial=0.0) < _FAR)


def _groups(
    graph: HallLayout, level: dict[str, str], rows: dict[str, int], faults: _Faults
) -> _Groups:
    """Groups by space: id, zone and the rows of those of their objects that are there."""
    groups: _Groups = {space: [] for space in level}
    for group in graph.groups:
        missing = [name for name in group.objects if name not in rows]
        if group.space not in groups:
            message = f"group {group.id} stands in {group.space!r}, which is not a room"
            faults.append((group.space, message))
            continue
        if missing:
            message = f"group {group.id} names {missing[0]}"
            message += f" and {len(missing) - 1} more" if len(missing) > 1 else ""
            faults.append((group.space, f"{message}, not among the valid pieces"))
        held = [rows[name] for name in dict.fromkeys(group.objects) if name in rows]
        groups[group.space].append((group.id, group.zone, np.array(held, np.int64)))
    return groups


def _links(
    graph: HallLayout, zones: _Zones, level: dict[str, str], faults: _Faults
) -> dict[str, dict[tuple[str, str], float]]:
    """Widths asked for by space and pair of zones."""
    links: dict[str, dict[tuple[str, str], float]] = {space: {} for space in level}
    for link in graph.links:
        known = zones.get(link.space, {})
        unknown = [name for name in (link.first, link.second) if name not in known]
        if unknown or link.first == link.second or not 0 < link.width < _FAR:
            why = f"zone {unknown[0]} is not there" if unknown else "that cannot be judged"
            faults.append((link.space, f"a link joins {link.first} and {link.second}: {why}"))
        else:
            links[link.space][link.first, link.second] = link.width
    return links


def _hall(
    room: int,
    rooms: Rooms,
    bodies: Bodies,
    zones: _Zones,
    groups: _Groups,
    links: dict[str, dict[tuple[str, str], float]],
    tours: tuple[Tour, ...],
    wish: Room | None,
    passage: float,
) -> JudgedHall:
    space = rooms.spaces[room]
    names = tuple(zones[space.id])
    number = {name: i for i, name in enumerate(names)}
    outlined = {zone.id for zone in wish.zones if zone.outline} if wish else set()
    asked = links[space.id] | _collect_requested_links(wish, passage, links[space.id], number)
    areas = np.empty(len(names), object)
    areas[:] = [zones[space.id][name] for name in names]
    members = tuple(Members(g, number.get(z, -1), rows) for g, z, rows in groups[space.id])
    held = np.unique(np.concatenate([np.empty(0, np.int64), *(m.rows for m in members)]))
    here = np.flatnonzero(bodies.room == room)
    built = np.array([bodies.pieces[row].category == PARTITION for row in here], bool)
    return JudgedHall(
        space,
        room,
        rooms.shapes[room],
        names,
        areas,
        tuple(name in outlined for name in names),
        tuple(JudgedLink(number[a], number[b], width) for (a, b), width in asked.items()),
        members,
        held,
        here[bodies.underfoot[here]],
        here[built],
        _tour(tours, space.id),
    )


def _collect_requested_links(
    wish: Room | None,
    passage: float,
    stated: Mapping[tuple[str, str], float],
    known: Mapping[str, int],
) -> dict[tuple[str, str], float]:
    """Links of the brief between zones that are there, but which the graph does not state."""
    asked = {link.between: link.width or passage for link in wish.links} if wish else {}
    return {
        (a, b): width
        for (a, b), width in asked.items()
        if a in known and b in known and a != b and not {(a, b), (b, a)} & set(stated)
    }


def _tour(tours: tuple[Tour, ...], space: str) -> Points | None:
    """The points of the first tour of a space; none if fewer than two are sound and differ."""
    for tour in tours:
        if tour.space == space:
            points = np.asarray(tour.points, float)
            points = points.reshape(-1, 2) if points.size % 2 == 0 else np.empty((0, 2))
            sound = points[np.isfinite(points).all(1) & (np.abs(points) < _FAR).all(1)].round(6)
            moved = np.ones(len(sound), bool)
            moved[1:] = (np.diff(sound, axis=0) != 0).any(1)
            return sound[moved] if moved.sum() > 1 else None
    return None
