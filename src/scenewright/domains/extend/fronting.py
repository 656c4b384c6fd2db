"""Fronts of new buildings whose models are drawn over any footprint: on the side by the street.

Sources tell footprints and no doors; the front of each is read as the side towards its street, and
a copy whose front looks elsewhere gets another side of its footprint as its front. It covers the
same ground.
"""

from __future__ import annotations

import math
from collections.abc import Container, Sequence
from dataclasses import replace

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.piece_outlines import outline_of, polygons_of
from scenewright.core.scene import Piece, Size
from scenewright.domains.extend.given import wrap_angle
from scenewright.ground.buildings.plain_buildings import fits_footprint
from scenewright.ground.plan import SitePlan
from scenewright.ground.streetside.fronts import find_fronting, list_ways
from scenewright.ground.streetside.plots import OUTBUILDING
from scenewright.ground.ways.door_walks import NARROW
from scenewright.ground.ways.walks import find_doors

QUARTERS = (0, 2, 1, 3)
"""Quarters of a turn that are tried for a front, in turn."""
CLEAR, STARTS, LED = 0.65, 1.3, 2
"""Metres that walks keep from houses, and from a street at which they begin; what it is worth that
a walk leads to a door."""


def front_pieces(
    plan: SitePlan, pieces: Sequence[Piece], counted: Container[str] = ()
) -> tuple[Piece, ...]:
    """Pieces with the fronts of new buildings on a side that a walk leads to and that looks at the
    street the building stands by, as far as there is one. Outbuildings that no passage leads to
    are left out, but in areas (by id) whose buildings are ``counted``."""
    ways, found = list_ways(plan, ()), list(pieces)
    rows = [k for k, p in enumerate(pieces) if not p.fixed and fits_footprint(p.asset)]
    if not rows or not len(ways):
        return tuple(found)
    shapes = polygons_of(list(pieces))
    reach = [find_walkable(plan, ways, shapes, clear) for clear in (CLEAR, NARROW)]
    sides = [[turn_front(pieces[k], quarters) for k in rows] for quarters in QUARTERS]
    worth = np.stack([rate_fronts(ways, reach, turned) for turned in sides])
    for number, best in enumerate(worth.argmax(0).tolist()):
        found[rows[number]] = sides[best][number]
    small = shapely.area(shapes[rows]) < OUTBUILDING
    shut = {rows[k] for k in np.flatnonzero(small & (worth.max(0) < LED)).tolist()}
    shut = {k for k in shut if pieces[k].space not in counted}
    return tuple(piece for k, piece in enumerate(found) if k not in shut)


def rate_fronts(
    ways: NDArray[np.object_], reach: Sequence[shapely.Geometry], pieces: Sequence[Piece]
) -> NDArray[np.int64]:
    """:data:`LED` for each way in which a door (n,) is within ``reach``, and 1 more for one that
    looks at the way by it."""
    doors = find_doors(
        [outline_of(piece) for piece in pieces], np.array([p.pose.heading for p in pieces])
    )
    by, fronting = find_fronting(ways, polygons_of(list(pieces)), doors)
    worth = (fronting | ~by).astype(np.int64)
    for area, clear in zip(reach, (CLEAR, NARROW), strict=True):
        steps = shapely.points(doors.places + (clear + 0.05) * doors.ways)
        worth += LED * shapely.dwithin(area, steps, 0.1)
    return worth


def find_walkable(
    plan: SitePlan, ways: NDArray[np.object_], shapes: NDArray[np.object_], clear: float
) -> shapely.Geometry:
    """Where the middle of a walk from a street may lie between some buildings, ``clear`` of them by
    metres."""
    floor, streets = shapely.Polygon(plan.outline, plan.holes), shapely.union_all(ways)
    around = shapely.union_all(shapely.buffer(shapes, clear, quad_segs=2))
    parts = shapely.get_parts(shapely.difference(floor, around))
    found = shapely.union_all(parts[shapely.dwithin(parts, streets, STARTS)])
    shapely.prepare(found)
    return found


def turn_front(piece: Piece, quarters: int) -> Piece:
    """The same ground with the front some quarters of a turn further.

    >>> from scenewright.core.scene import Pose
    >>> house = Piece("h", "building", "b", "a", Pose(0, 0, 0, 0.0), Size(9.0, 4.0, 6.0))
    >>> turn_front(house, 1).size.width, turn_front(house, 2).size.width
    (4.0, 9.0)
    """
    if not quarters:
        return piece
    size, footprint = piece.size, piece.footprint
    for _ in range(quarters):
        size = Size(size.depth, size.width, size.height)
        footprint = tuple((y, -x) for x, y in footprint)
    heading = wrap_angle(piece.pose.heading + quarters * math.pi / 2)
    pose = piece.pose._replace(heading=heading)
    return replace(piece, pose=pose, size=size, footprint=footprint)
