"""A place of worship: the altar before the far wall on the axis of the entrance, looking to those
who come in, pews in blocks beside a middle aisle before it, filled from the front."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building.door_approach import DoorApproach
from scenewright.core.catalog import Catalog
from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.build_problem import HallContext, taken_floor
from scenewright.domains.hall.classes import PEW_PITCH, is_altar, is_pew
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.furnishing.pieces import make_piece
from scenewright.domains.hall.measures import AISLE
from scenewright.domains.hall.problem import Floats

ALTAR_BEHIND, ALTAR_BEFORE, NAVE_SIDE, NAVE_BACK = 1.2, 1.9, 0.75, 2.2
"""Metres behind an altar and before it, beside the pews, and behind the last of them (Neufert 2012,
churches: 1.5 m before the altar, aisles of 0.75 and 1.2 m)."""
NAVE_PITCH, NAVE_MIDDLE = PEW_PITCH + 0.05, 0.4
"""Metres from pew to pew, and the share of what is left across that the middle aisle takes."""
LECTERN, LECTERN_ASIDE, LECTERN_AHEAD = "lectern", 0.9, 0.3
"""What is read at, and how far beside the altar and ahead of its front it stands, in metres."""
STAGE = "stage"
BEYOND_HALL = 200.0
"""Metres beyond which no hall goes."""


class Nave(NamedTuple):
    """A point of the axis in the far wall, the unit directions to the entrance and across, metres
    along the axis, and the floor that is free."""

    end: Floats
    back: Floats
    across: Floats
    length: float
    floor: shapely.Geometry


def furnish_nave(
    hall: HallContext, asked: list[HallDemand], door: DoorApproach, catalog: Catalog
) -> tuple[list[HallDemand], tuple[Piece, ...]]:
    """The demands less altar, lectern and pews, where one altar and pews leave open how they stand
    and all have room, and the pieces of these."""
    altars = [wish for wish in asked if is_altar(wish.category, f"{wish.id} {wish.name}")]
    pews = [wish for wish in asked if _is_nave(wish)]
    if len(altars) != 1 or len(altars[0].sizes) != 1 or not pews or altars[0].zones:
        return asked, ()
    nave, altar = _find_nave(hall, door), altars[0]
    size, stage = altar.sizes[0], altar.category == STAGE
    behind = 0.02 if stage else ALTAR_BEHIND
    boxes = [_stand(nave, behind + 0.5 * size.depth, 0.0, size)]
    sets = [(altar, boxes, [size])]
    for wish in (w for w in asked if w.category == LECTERN and len(w.sizes) == 1 and not stage):
        own, aside = wish.sizes[0], 0.5 * size.width + LECTERN_ASIDE
        sets.append((wish, [_stand(nave, behind + size.depth + LECTERN_AHEAD, aside, own)], [own]))
    if not all(_is_free(nave, box) for _, boxes, _ in sets for box in boxes):
        return asked, ()
    first = behind + size.depth + ALTAR_BEFORE
    for wish in pews:
        spots = [box for box in _list_pews(nave, wish.sizes[0], first) if _is_free(nave, box)]
        spots = spots[: len(wish.sizes)]
        if spots:
            sets.append((wish, spots, list(wish.sizes[: len(spots)])))
            first += NAVE_PITCH * (1 + len({round(float(nave.back @ b[:2]), 2) for b in spots}))
        if len(spots) < (wish.least or len(wish.sizes)):
            return asked, ()
    done = {wish.id for wish, _, _ in sets} | {wish.id for wish in pews}
    pieces = tuple(
        make_piece(hall, wish, f"{hall.space.id}/{wish.id}", k, (_pose(box), one), catalog)
        for wish, boxes, sizes in sets
        for k, (box, one) in enumerate(zip(boxes, sizes, strict=True), 1)
    )
    return [wish for wish in asked if wish.id not in done], pieces


def _is_nave(wish: HallDemand) -> bool:
    return (
        is_pew(wish.category, wish.sizes[0].width)
        and wish.patterns in (("chain",), ("single",))
        and not wish.zones
        and not wish.aisle
    )


def _find_nave(hall: HallContext, door: DoorApproach) -> Nave:
    """The nave from a door inwards, its axis in the middle of the floor across it."""
    inward = door.inward
    across = np.array([inward[1], -inward[0]])
    inside = shapely.Polygon(hall.space.outline, hall.space.holes)
    middle = np.array(inside.envelope.centroid.coords[0])
    line = _cut(inside, middle, across)
    start = line.mean(0)
    ends = _cut(inside, start, inward) @ inward
    end = start + (ends.max() - start @ inward) * inward
    taken = shapely.union_all(shapely.polygons(corners(taken_floor(hall))))
    return Nave(end, -inward, across, float(np.ptp(ends)), inside.difference(taken))


def _cut(inside: shapely.Polygon, point: Floats, way: Floats) -> Floats:
    """The ends (2, 2) of the longest piece of a line through a point inside a hall."""
    ends = np.array([point - BEYOND_HALL * way, point + BEYOND_HALL * way])
    parts = shapely.get_parts(shapely.intersection(shapely.LineString(ends), inside))
    return shapely.get_coordinates(max(parts, key=lambda part: part.length))[[0, -1]]


def _stand(nave: Nave, far: float, aside: float, size: Size, turned: bool = False) -> Floats:
    """A box (5,) some metres off the far wall and beside the axis, looking to the entrance or, if
    ``turned``, to the altar."""
    x, y = nave.end + far * nave.back + aside * nave.across
    front = -nave.back if turned else nave.back
    return np.array([x, y, atan2(front[1], front[0]), size.width, size.depth])


def _pose(box: Floats) -> Pose:
    return Pose(float(box[0]), float(box[1]), 0.0, float(box[2]))


def _is_free(nave: Nave, box: Floats) -> bool:
    smaller = box - np.array([0.0, 0.0, 0.0, 0.01, 0.01])
    return bool(nave.floor.covers(shapely.polygons(corners(smaller[None]))[0]))


def _list_pews(nave: Nave, size: Size, first: float) -> Iterator[Floats]:
    """Boxes (5,) of pews from the front, two by two beside the middle aisle."""
    for row in range(int(max(nave.length - NAVE_BACK - first, 0.0) / NAVE_PITCH)):
        far = first + row * NAVE_PITCH + 0.5 * size.depth
        at = nave.end + far * nave.back
        wide = float(np.ptp(_cut(nave.floor.envelope, at, nave.across) @ nave.across))
        each = int((0.5 * (wide - AISLE) - NAVE_SIDE) / size.width + 1e-6)
        spare = wide - AISLE - 2.0 * (NAVE_SIDE + each * size.width)
        middle = 0.5 * (AISLE + NAVE_MIDDLE * max(spare, 0.0))
        for k in range(each):
            aside = middle + (k + 0.5) * size.width
            yield _stand(nave, far, -aside, size, turned=True)
            yield _stand(nave, far, aside, size, turned=True)
        if not each:
            yield _stand(nave, far, 0.0, size, turned=True)
