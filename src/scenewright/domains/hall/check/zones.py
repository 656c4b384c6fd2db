"""Zone fidelity: does each group stand in the zone it belongs to, and can a wheelchair turn there?

Cao, Cheng and Zhang (2024) lay every group out inside its functional zone; here a piece may leave
it by 1 cm. A wheelchair turns in a circle of 1.5 m and needs a route of 0.9 m (ISO 21542).
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Bodies, Shape, Shapes
from scenewright.check.routes import Walk
from scenewright.core.brief import Room
from scenewright.core.report import Finding, Note
from scenewright.domains.hall.check.halls import JudgedHall

WHEELCHAIR = 0.9
"""Width of the route a wheelchair needs, in metres."""

_BESIDE = 0.2
OTHER_AREA = 0.1
"""By what share of the area asked for a zone may be larger or smaller unsaid."""


def find_outside_zone(bodies: Bodies, hall: JudgedHall) -> list[Finding]:
    """A finding for each piece of a group more than 1 cm outside its group's zone."""
    found: list[Finding] = []
    wider: Shapes = shapely.buffer(hall.areas, TOLERANCE, join_style="mitre")
    shapely.prepare(wider)
    for group in hall.groups:
        if group.zone < 0 or not len(group.rows):
            continue
        outside = ~shapely.covers(wider[group.zone], bodies.footprints[group.rows])
        for row in group.rows[outside]:
            found.append(state_outside(bodies, hall, group.zone, int(row)))
    return found


def note_zone_sizes(hall: JudgedHall, asked: Mapping[str, Room]) -> list[Note]:
    """A note for each zone whose floor is not the area that the brief asks for."""
    room, notes = asked.get(hall.space.id), list[Note]()
    areas = dict(zip(hall.zones, shapely.area(hall.areas), strict=True))
    for zone in room.zones if room is not None else ():
        there = float(areas.get(zone.id, 0.0))
        if zone.area and there and abs(there - zone.area) > OTHER_AREA * zone.area:
            text = f"{hall.space.id}: {zone.id} has {there:.1f} m², {zone.area:g} m² asked"
            notes.append(Note(hall.space.id, zone.id, "", text))
    return notes


def state_outside(bodies: Bodies, hall: JudgedHall, zone: int, row: int) -> Finding:
    """The finding that a piece (its row) leaves a zone (its number)."""
    piece = bodies.pieces[row]
    rest = shapely.difference(bodies.footprints[row], hall.areas[zone])
    edge = shapely.points(shapely.get_coordinates(shapely.segmentize(rest, 0.02)))
    depth = float(shapely.distance(edge, hall.areas[zone]).max(initial=0.0))
    message = (
        f"{piece.id} is {depth:.2f} m ({rest.area:.2f} m²) outside its zone {hall.zones[zone]}"
    )
    return Finding(
        "outside_zone",
        hall.space.level,
        hall.space.id,
        piece.id,
        hall.zones[zone],
        message,
        round(depth, 4),
        round(float(rest.area), 4),
        piece.fixed,
    )


def turning(hall: JudgedHall, open_floor: Shape) -> dict[str, bool]:
    """Whether a wheelchair can come into each zone and turn there.

    ``open_floor`` is where the centre of a free circle of 1.5 m may be that can be rolled into.
    """
    fits = shapely.intersects(open_floor, hall.areas)
    return {name: bool(fit) for name, fit in zip(hall.zones, np.atleast_1d(fits), strict=True)}


def reached_by(bodies: Bodies, hall: JudgedHall, walk: Walk) -> float:
    """The share of groups a route comes within 0.2 m of, at one of their objects; 1 if none."""
    placed = [group for group in hall.groups if len(group.rows)]
    if not placed or walk.reached.is_empty:
        return 0.0 if placed else 1.0
    shapely.prepare(walk.reached)
    within = walk.radius + _BESIDE
    near = [shapely.dwithin(walk.reached, bodies.footprints[g.rows], within).any() for g in placed]
    return round(float(np.mean(near)), 4)
