"""The largest empty circle of a furnished room, and what may stand free in it."""

from __future__ import annotations

from math import atan2, cos, hypot, sin
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.catalog.classes import RUN, SOFAS
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import RoomTask
from scenewright.domains.home.furnishing.obstacles import flat_kinds
from scenewright.domains.home.measures import RAISED

Floats = NDArray[np.float64]

EXACT = 0.05  # accuracy of a radius, metres
SIGHT = 1.0  # width of the floor between seats and screen that is left free, metres
FREE_BEFORE = 1.2  # floor before a free-standing piece, metres
TURNED = 3.0  # it turns its back on nobody's seat that is nearer than this, metres
COOKS, EATS = 1.2, 0.6  # its distance from a kitchen, and from chairs at a table, metres
TOUCH = 0.05


class Void(NamedTuple):
    """The largest empty circle of a room: its middle and radius, metres."""

    x: float
    y: float
    radius: float


def find_void(task: RoomTask, pieces: tuple[Piece, ...]) -> Void:
    """The largest circle on the floor of a room clear of walls, doors, furniture and the sight
    from seats to a screen (Toussaint 1983; by polygons, within :data:`EXACT`)."""
    return find_circle(free_floor(task, pieces))


def find_circle(floor: shapely.Geometry) -> Void:
    """The largest circle on a floor, within :data:`EXACT`; of radius 0 where none is left."""
    parts = shapely.get_parts(floor)
    polygons = parts[shapely.area(parts) > 0.0]
    if not len(polygons):
        return Void(0.0, 0.0, 0.0)
    whole = shapely.multipolygons(polygons)
    circle = shapely.maximum_inscribed_circle(whole, tolerance=EXACT)
    x, y = circle.coords[0]
    return Void(x, y, float(circle.length))


def free_floor(task: RoomTask, pieces: tuple[Piece, ...]) -> shapely.Geometry:
    """The floor of a room clear of doors, furniture and the sight from seats to a screen."""
    zones = [_outline(box) for box in (*task.ground.keep_free, *_list_sights(pieces))]
    taken = shapely.union_all([*polygons_of(_list_low(task, pieces)), *zones])
    return _floor_of(task).difference(taken)


def open_floor(task: RoomTask, pieces: tuple[Piece, ...]) -> shapely.Geometry:
    """The floor of a room clear of furniture, also that before doors and screens."""
    return _floor_of(task).difference(shapely.union_all(polygons_of(_list_low(task, pieces))))


def free_beside(
    task: RoomTask, floor: shapely.Geometry, pieces: tuple[Piece, ...], added: tuple[Piece, ...]
) -> shapely.Geometry:
    """A ``floor`` free beside some pieces, with more ``added`` to them."""
    sights = [_outline(box) for box in _list_sights((*pieces, *added))]
    taken = shapely.union_all([*polygons_of(_list_low(task, added)), *sights])
    return floor.difference(taken)


def may_stand_free(task: RoomTask, pieces: tuple[Piece, ...], box: Floats) -> bool:
    """Whether seats on a box (5,) have the floor before them free, no sofa or armchair behind them
    and no kitchen or table beside them; ``pieces`` are all others."""
    x, y, heading, width, depth = box.tolist()
    c, s = cos(heading), sin(heading)
    out = (depth + FREE_BEFORE) / 2
    front = _outline(np.array([x + out * c, y + out * s, heading, width / 2, FREE_BEFORE]))
    seats = (p for p in pieces if p.category in SOFAS or p.category == "armchair")
    sofas = ((p.pose.x - x, p.pose.y - y) for p in seats)
    if any(hypot(dx, dy) < TURNED and dx * c + dy * s < 0.0 for dx, dy in sofas):
        return False
    units = tuple(p for p in pieces if p.category in RUN)
    if any(_outline(box).distance(unit) < COOKS for unit in polygons_of(units)):
        return False
    chairs = tuple(p for p in pieces if p.category == "dining_chair")
    if any(_outline(box).distance(chair) < EATS for chair in polygons_of(chairs)):
        return False
    low = polygons_of(_list_low(task, pieces))
    return _floor_of(task).buffer(TOUCH).contains(front) and not front.intersects(low).any()


def _list_low(task: RoomTask, pieces: tuple[Piece, ...]) -> tuple[Piece, ...]:
    """What stands on the floor and is not flat."""
    flat = flat_kinds(task.catalog)
    return tuple(p for p in pieces if p.category not in flat and p.pose.z < RAISED)


def _list_sights(pieces: tuple[Piece, ...]) -> list[Floats]:
    """The floor between each sofa and each screen as boxes (5,)."""
    sofas = [p.pose for p in pieces if p.category in SOFAS]
    ways = [(a, p.pose) for p in pieces if p.category == "tv" for a in sofas]
    found = []
    for a, b in ways:
        dx, dy = b.x - a.x, b.y - a.y
        middle = (a.x + dx / 2, a.y + dy / 2)
        found.append(np.array([*middle, atan2(dy, dx), SIGHT, hypot(dx, dy)]))
    return found


def _floor_of(task: RoomTask) -> shapely.Polygon:
    return shapely.Polygon(task.space.outline, list(task.space.holes))


def _outline(box: Floats) -> shapely.Polygon:
    return shapely.Polygon(corners(box[None])[0])
