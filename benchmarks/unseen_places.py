"""Whether what a home lacks has a free place in it: a search of its own, by polygons alone.

Of a home without a table or without a soft seat every place on a grid along the walls of the rooms
that may have it is looked at. A place is free where the piece and the floor before it run into
nothing, where it takes no floor that doors, beds, cupboards or a kitchen are used from, and where a
disc of 0.6 m still gets everywhere it got before. Nothing of the solver is asked.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import atan2, cos, pi, sin
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from benchmarks.composition_faults import Count, Home, Room, shape_of
from benchmarks.unseen_counters import RUN, SOFT, SOFT_FROM, TABLES
from scenewright.building.door_approach import gates
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut

Floats = NDArray[np.float64]
GRID, WAY, BACK = 0.1, 0.6, 0.15
"""Metres between places, width of a way, and how far off its wall a back may be."""
AT_DOOR = 0.9
"""Metres of floor before a door on which nothing stands."""
USED = {"wardrobe": 0.6, "chest_of_drawers": 0.45, "bookcase": 0.45, "desk": 0.6}
USED |= dict.fromkeys(RUN, 0.75) | {"washing_machine": 0.6}
"""Metres of floor that pieces are used from."""
FLAT = frozenset(("rug", "small_rug", "floor_mat"))
TOLD = ("tried ", "places to eat for", "no room of the home is large enough")
"""How a proof begins."""


class Wanted(NamedTuple):
    """What may be missing: its kinds, its width and depth and the floor before it in metres; rooms
    that may have it, each with its least area in m²; the groups that bring it."""

    kinds: tuple[str, ...]
    size: tuple[float, float, float]
    rooms: dict[str, float]
    groups: tuple[str, ...]


BEDROOMS = {"bedroom": 7.0, "double_bedroom": 7.0, "single_bedroom": 7.0, "study": 7.0}
WANTED = {
    "table": Wanted(
        TABLES,
        (0.8, 0.6, 0.55),
        {"living": 4.0, "dining": 4.0, "kitchen": 4.0, "hall": 6.0} | BEDROOMS,
        ("dining", "dining_wall"),
    ),
    "soft seat": Wanted(
        SOFT, (0.66, 0.7, 0.4), {"living": 3.0, "dining": 7.0} | BEDROOMS, ("seating", "reading")
    ),
}


def count_missing(home: Home, left_out: Sequence[LeftOut]) -> dict[str, Count]:
    """Homes that lack a table or a soft seat though floor is free for one, those in which none is,
    and of all that lack one those that do not say what was tried.

    >>> count_missing((), ())["table missing, no floor is free for it"]
    Count(faulty=1, of=1)
    """
    found = {}
    area = sum(room.floor.area for room in home if "balcony" not in room.space.functions)
    for name, wanted in WANTED.items():
        owed = int(name == "table" or area >= SOFT_FROM)
        lacks = owed * all(not room.find(*wanted.kinds) for room in home)
        free = lacks and any(_has_place(room, wanted) for room in home)
        told = any(o.what in wanted.groups and o.reason.startswith(TOLD) for o in left_out)
        found[f"{name} missing though floor is free for it"] = Count(int(free), owed)
        found[f"{name} missing, no floor is free for it"] = Count(int(lacks and not free), owed)
        found[f"{name} missing without a proof"] = Count(int(lacks and not told), int(lacks))
    return found


def _has_place(room: Room, wanted: Wanted) -> bool:
    area = room.floor.area
    if not any(area >= wanted.rooms.get(use, np.inf) for use in room.space.functions):
        return False
    return next(list_places(room, *wanted.size), None) is not None


def list_places(room: Room, width: float, depth: float, before: float) -> Iterator[Floats]:
    """The boxes (5,) of a piece with its back at a wall on which it stands free in a room."""
    low = [p for p in room.pieces if p.pose.z < 0.3 and p.category not in FLAT]
    solid = shapely.union_all([shape_of(p) for p in low])
    used = shapely.union_all([solid, *_list_used(room, low)])
    floor = room.floor.buffer(0.01)
    boxes = _list_boxes(room, width, depth)
    bodies, fronts = _outlines(boxes), _outlines(_shift(boxes, before))
    ring = room.floor.boundary
    backs = shapely.linestrings(shapely.get_coordinates(bodies).reshape(-1, 5, 2)[:, :2])
    free = shapely.contains(floor, bodies) & ~shapely.intersects(bodies, used.buffer(-0.01))
    free &= shapely.contains(floor, fronts) & ~shapely.intersects(fronts, solid.buffer(-0.01))
    near = shapely.hausdorff_distance(backs, shapely.intersection(backs, ring.buffer(BACK)))
    free &= near < 0.01
    reached = _reach(room, low, solid)
    for k in np.flatnonzero(free):
        if _reach(room, low, solid.union(bodies[k])) >= reached:
            yield boxes[k]


def _list_boxes(room: Room, width: float, depth: float) -> Floats:
    x0, y0, x1, y1 = room.floor.bounds
    ring = np.asarray(room.floor.exterior.coords)
    long = np.diff(ring, axis=0)[np.argmax(np.hypot(*np.diff(ring, axis=0).T))]
    turns = atan2(long[1], long[0]) + np.arange(4) * pi / 2
    axes = np.arange(x0, x1, GRID), np.arange(y0, y1, GRID), turns
    x, y, turn = (axis.ravel() for axis in np.meshgrid(*axes))
    return np.column_stack([x, y, turn, np.full(len(x), width), np.full(len(x), depth)])


def _shift(boxes: Floats, before: float) -> Floats:
    """The boxes of the floor before others."""
    ahead, front = (boxes[:, 4] + before) / 2, boxes.copy()
    front[:, 0] += ahead * np.cos(boxes[:, 2])
    front[:, 1] += ahead * np.sin(boxes[:, 2])
    front[:, 4] = before
    return front


def _outlines(boxes: Floats) -> NDArray[np.object_]:
    """The polygons of boxes, whose first two corners are those of the back."""
    ahead = np.column_stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])]) * boxes[:, 4:] / 2
    side = np.column_stack([np.sin(boxes[:, 2]), -np.cos(boxes[:, 2])]) * boxes[:, 3:4] / 2
    at = boxes[:, :2]
    corners = (at - ahead - side, at - ahead + side, at + ahead + side, at + ahead - side)
    return np.asarray(shapely.polygons(np.stack(corners, axis=1)))


def _list_used(room: Room, low: Sequence[Piece]) -> Iterator[shapely.Polygon]:
    """The floor that doors and pieces are used from."""
    for gate in gates(room.space):
        if gate.opening.kind != "window":
            x, y = gate.face + gate.inward * AT_DOOR / 2
            turn = atan2(gate.inward[1], gate.inward[0])
            yield _outlines(np.array([[x, y, turn, gate.opening.width, AT_DOOR]]))[0]
    for piece in low:
        deep = USED.get(piece.category)
        if deep is not None:
            yield _aside(piece, 0.0, (piece.size.depth + deep) / 2, piece.size.width, deep)
        elif piece.category == "double_bed":
            for side in (-1.0, 1.0):
                aside = side * (piece.size.width + 0.5) / 2
                yield _aside(piece, aside, piece.size.depth / 4, 0.5, piece.size.depth / 2)


def _aside(piece: Piece, aside: float, ahead: float, width: float, depth: float) -> shapely.Polygon:
    x, y, _, turn = piece.pose
    at = (x + ahead * cos(turn) + aside * sin(turn), y + ahead * sin(turn) - aside * cos(turn))
    return _outlines(np.array([[*at, turn, width, depth]]))[0]


def _reach(room: Room, low: Sequence[Piece], solid: shapely.Geometry) -> int:
    """How many doors and pieces a disc as wide as a way gets to from the first door."""
    walk = room.floor.buffer(0.01).difference(solid).buffer(-WAY / 2)
    parts = shapely.get_parts(walk)
    doors = [
        shapely.Point(gate.face + gate.inward * WAY / 2).buffer(WAY / 2)
        for gate in gates(room.space)
        if gate.opening.kind != "window"
    ]
    zones = [*doors, *(shape_of(piece).buffer(WAY / 2 + 0.2) for piece in low)]
    if not doors or not len(parts):
        return 0
    return max(sum(part.intersects(zone) for zone in zones) for part in parts)
