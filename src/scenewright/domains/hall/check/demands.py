"""The demands of a hall against its objects: how many, of what category, and in which zone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
import shapely

from scenewright.catalog.kinds import name_of
from scenewright.check.bodies import TOLERANCE, Bodies
from scenewright.check.owed import ALL, Owed
from scenewright.core.brief import Room
from scenewright.core.brief.zones import Demand
from scenewright.core.report import Finding
from scenewright.domains.hall.check.halls import JudgedHall
from scenewright.domains.hall.check.zones import state_outside
from scenewright.domains.hall.demands.checked import ids_of, sizes_of

REDRAWN = 0.05
"""What the border of a zone may lie off that of the brief, in metres."""


def list_owed(asked: Mapping[str, Room], bodies: Bodies) -> Iterator[Owed]:
    """What each hall is to hold; objects answer the demand that is their function."""
    for space, room in asked.items():
        here = [piece for piece in bodies.pieces if piece.space == space]
        kept = {item.id for item in room.fixed}
        for demand, name in zip(room.demands, ids_of(room.demands), strict=True):
            category = demand.category
            mine = [p for p in here if p.function == name and p.category == category]
            stay = sum(p.fixed or p.id in kept for p in mine)
            least, most = _count_asked(demand)
            words = (demand.name or demand.id or name_of(category),)
            yield Owed(space, name, len(mine), least, max(most, stay), words)


def _count_asked(demand: Demand) -> tuple[int, int]:
    """How many objects a demand asks for at least and at most."""
    if demand.fill not in (None, "none"):
        return demand.count or 1, ALL
    most = len(sizes_of(demand))
    return (demand.count or 1, most) if demand.most is not None else (most, most)


def find_changed_zones(halls: Sequence[JudgedHall], asked: Mapping[str, Room]) -> Iterator[Finding]:
    """A finding for each zone that the brief names for something and the layout lacks, or has
    elsewhere than it was drawn where its borders may not be moved."""
    known = {hall.space.id: hall for hall in halls}
    for space, room in asked.items():
        hall = known.get(space)
        areas = dict(zip(hall.zones, hall.areas, strict=True)) if hall else {}
        used = {zone for demand in room.demands for zone in _zones_of(demand)}
        for zone in room.zones:
            if zone.id not in areas and zone.id in used:
                text = f"zone {zone.id} of {space} is not laid out"
                yield Finding("missing", room.level, space, "", zone.id, text)
            elif hall and zone.id in areas and zone.outline and zone.slack is None:
                drawn = shapely.intersection(shapely.Polygon(zone.outline).buffer(0), hall.shape)
                off = float(shapely.hausdorff_distance(drawn, areas[zone.id]))
                if off > REDRAWN:
                    text = f"zone {zone.id} lies {off:.2f} m from where the brief draws it"
                    place = ("changed_given", hall.space.level, space, "", zone.id)
                    yield Finding(*place, text, round(off, 4))


def find_misplaced(
    hall: JudgedHall, asked: Mapping[str, Room], bodies: Bodies, known: Sequence[Finding]
) -> Iterator[Finding]:
    """A finding for each object outside all zones that its demand names, but those ``known``."""
    room, seen = asked.get(hall.space.id), {found.piece for found in known}
    demands = room.demands if room else []
    for demand, name in zip(demands, ids_of(demands), strict=True):
        allowed = np.isin(hall.zones, _zones_of(demand))
        if not allowed.any():
            continue
        ground = shapely.buffer(shapely.union_all(hall.areas[allowed]), TOLERANCE)
        mine = [
            k
            for k, p in enumerate(bodies.pieces)
            if p.function == name and p.space == hall.space.id and p.id not in seen
        ]
        outside = ~shapely.covers(ground, bodies.footprints[mine])
        for row in np.array(mine, np.int64)[outside]:
            yield state_outside(bodies, hall, int(np.flatnonzero(allowed)[0]), int(row))


def _zones_of(demand: Demand) -> list[str]:
    return [demand.zone] if isinstance(demand.zone, str) else list(demand.zone or ())
