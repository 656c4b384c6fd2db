"""A hall when its small objects are set: doors, walls, and the floor left free."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.door_approach import gates
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.classes import SERVING
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.measures import QUEUE
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.visit.doors import visitor_exits, ways_in

Bools = NDArray[np.bool_]

SETTING_WAY = 3.0
"""Metres that stay free on the way in and out behind a door."""
SETTING_LITTLE, SHORTENED = 1e-4, 1e-3


class Doorway(NamedTuple):
    """A door of visitors: its ``middle`` (2,) in the inner face of the wall, the unit direction
    ``inward`` (2,), its width, and whether people come in by it."""

    middle: Floats
    inward: Floats
    width: float
    entrance: bool


class Setting(NamedTuple):
    """The doorways of a hall, the main entrance first, its walls (w, 4) with the inside on the
    left, the objects there, and which of them (``others``, n, 5) are of the kind being placed."""

    doorways: tuple[Doorway, ...]
    walls: Floats
    pieces: tuple[Piece, ...]
    others: Floats


class FreeFloor(NamedTuple):
    """The ``floor`` small objects may stand on, zone by zone, the objects there (``bodies``), and
    the floor that has to stay free as well (``kept``)."""

    floor: shapely.GeometryCollection
    bodies: shapely.STRtree
    kept: shapely.STRtree


def find_doorways(space: Space) -> tuple[Doorway, ...]:
    """The doors visitors come in by, the main one first, then those they only leave by."""
    seen = {gate.opening.id: gate for gate in gates(space)}
    into = [door.id for door in ways_in(space)]
    out = [door.id for door in visitor_exits(space) if door.id not in into]
    found = [(seen[name], name in into) for name in (*into, *out)]
    return tuple(Doorway(g.face, g.inward, g.opening.width, comes) for g, comes in found)


def find_walls(hall: HallContext) -> Floats:
    """The walls (w, 4) of all zones of a hall."""
    rows = [[wall.x0, wall.y0, wall.x1, wall.y1] for walls in hall.walls for wall in walls]
    return np.array(rows, np.float64).reshape(-1, 4)


def find_floor(
    hall: HallContext,
    zones: tuple[str, ...],
    pieces: tuple[Piece, ...],
    wishes: list[HallDemand],
    keep_free: Floats,
) -> FreeFloor:
    """The floor of some zones (all if none is named) past ``pieces`` and the free floor these
    need; ``keep_free`` (k, 5) are boxes before doors and windows."""
    rings = [z.outline for z in hall.plan.zones if not zones or z.id in zones]
    inside = shapely.Polygon(hall.space.outline, hall.space.holes)
    floors = [shapely.buffer(shapely.Polygon(ring) & inside, SETTING_LITTLE) for ring in rings]
    known = {wish.id: wish for wish in wishes}
    used = [_grow(p, known[p.function]) for p in pieces if p.function in known]
    ways = [_lead_in(door) for door in find_doorways(hall.space)]
    kept = np.array([*ways, *used, *keep_free.tolist()]).reshape(-1, 5)
    kept = kept[kept[:, 3:].min(1) > SHORTENED] if len(kept) else kept
    return FreeFloor(
        shapely.geometrycollections(floors),
        shapely.STRtree(shapely.buffer(polygons_of(pieces), -SETTING_LITTLE)),
        shapely.STRtree(shapely.buffer(shapely.polygons(corners(kept)), -SETTING_LITTLE)),
    )


def _lead_in(door: Doorway) -> list[float]:
    """The box (5,) of the floor on which people come in at a door."""
    x, y = door.middle + 0.5 * SETTING_WAY * door.inward
    return [x, y, float(np.arctan2(door.inward[1], door.inward[0])), door.width, SETTING_WAY]


def _grow(piece: Piece, wish: HallDemand) -> list[float]:
    """The box (5,) of a piece with the free floor before and behind it, of desks with the queue."""
    front, _, back, _ = wish.clearance
    if wish.category in SERVING:
        front = max(front, QUEUE)
    c, s = np.cos(piece.pose.heading), np.sin(piece.pose.heading)
    off = 0.5 * (front - back)
    wide, deep = piece.size.width, piece.size.depth + front + back
    return [piece.pose.x + off * c, piece.pose.y + off * s, piece.pose.heading, wide, deep]


def find_free(free: FreeFloor, boxes: Floats, used: bool = False) -> Bools:
    """Which of boxes (k, 5) stand on free floor (k,), or where ``used`` also on what is kept free
    for use."""
    shapes = shapely.polygons(corners(boxes))
    floors = shapely.get_parts(free.floor)
    stand = shapely.covers(floors[:, None], shapes).any(0)
    for tree in (free.bodies,) if used else (free.bodies, free.kept):
        stand[tree.query(shapes, predicate="intersects")[0]] = False
    return np.asarray(stand, bool)


def lie_open(free: FreeFloor, boxes: Floats, before: float, around: float) -> Bools:
    """Which of boxes (k, 5) have ``before`` and ``around`` metres of free floor (k,)."""
    wider = boxes.copy()
    wider[:, 3:] += 2.0 * around
    found = np.ones(len(boxes), bool)
    for rows in (lead_before(boxes, before), wider):
        shapes = shapely.polygons(corners(rows))
        found[free.bodies.query(shapes, predicate="intersects")[0]] = False
    return found


def lead_before(boxes: Floats, deep: float) -> Floats:
    """The floor in front of boxes (k, 5), ``deep`` metres deep, as boxes (k, 5)."""
    ahead, off = boxes.copy(), 0.5 * (boxes[:, 4] + deep)
    ahead[:, 0] += off * np.cos(boxes[:, 2])
    ahead[:, 1] += off * np.sin(boxes[:, 2])
    ahead[:, 4] = deep
    return ahead
