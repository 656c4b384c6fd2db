"""Benches before what is looked at: one by one, with a few metres to see the whole of it."""

from __future__ import annotations

from itertools import product

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.core.piece_outlines import boxes_of, polygons_of
from scenewright.core.scene import Piece, Size
from scenewright.domains.hall.accessories.setting import Bools, Setting, lead_before
from scenewright.domains.hall.accessories.spots import (
    Spots,
    face,
    join_spots,
    line_walls,
    make_spots,
    measure_crowd,
)
from scenewright.domains.hall.classes import LONGEST_BENCH
from scenewright.domains.hall.demands.holdings import HallDemand, may_stand_together
from scenewright.domains.hall.measures import HEAD_HEIGHT
from scenewright.domains.hall.problem import Floats

PICTURE, ISLAND = "wall_exhibit", "exhibit_island"
LARGE = 2.0
"""Sides of an island as long as this are sat before, in metres."""
FARS, BENCH_OFF = (2.5, 2.2, 2.8, 2.0, 3.0), 0.5
"""Metres from what one looks at to the middle of a bench, the best first, and what a metre more or
less than that costs."""
WALL_BEHIND = 4.0
"""Cost of a place with its back at a wall, where there is nothing to look at."""
PITCH = 3.0
"""Metres of a side of an island for each bench."""
BENCHES_WITHIN, BENCHES_CROWD = 5.0, 0.4
"""Within how many metres benches are too many, and what each metre of that costs."""
BENCH_BEFORE, BENCH_ASIDE, BARS = 1.5, 0.6, 3.0
"""Metres before a picture and beside it that a bench bars, and what that costs: whoever looks at it
stands there."""
BENCH_CLOSE, WEDGED = 0.8, 4.5
"""Metres that a free-standing bench keeps from walls, columns and objects, and what
it costs nearer: wedged between two tables it looks pushed aside, at a wall it does not."""
BENCH_TOUCHING, PUSHED = 0.4, 4.0
"""The same for a bench that all but touches its neighbour; added to the cost above."""

BENCH_HIDDEN, SIGHT = 6.0, 0.2
"""What a place costs from where a column or a wall hides what one is to look at, and half of the
width of the look there; metres."""
BENCH_FREE = 0.8
"""Metres before a bench at a wall in which no column is."""


def may_look(wish: HallDemand, wishes: list[HallDemand]) -> bool:
    """Whether some picture or island may stand in a zone of benches."""
    return max(size.width for size in wish.sizes) <= LONGEST_BENCH and any(
        (other.category == PICTURE or is_large_island(other)) and may_stand_together(wish, other)
        for other in wishes
    )


def is_large_island(wish: HallDemand) -> bool:
    """Whether a demand is for islands large enough to sit before and to rope off."""
    return wish.category == ISLAND and max(wish.sizes[0][:2]) >= LARGE


def find_bench_spots(setting: Setting, size: Size) -> Spots:
    """Spots before pictures and the long sides of islands, turned to these; cheaper away from the
    benches that stand and from what hangs right beside; else at walls."""
    at_walls = make_spots(line_walls(setting.walls, size)[0], WALL_BEHIND)
    blocked = _cross_walls(lead_before(at_walls.boxes, BENCH_FREE), setting)
    at_walls = at_walls._replace(costs=at_walls.costs + BENCH_HIDDEN * blocked)
    parts = [make_spots(np.zeros((0, 5)), 0.0)]
    for piece in setting.pieces:
        sides = (0,) if piece.category == PICTURE else range(4) if piece.category == ISLAND else ()
        for side, far in product(sides, FARS):
            spots = _face_side(piece, side, size, far)
            looks = lead_before(spots.boxes, far - 0.5 * size.depth - SIGHT)
            looks[:, 3] = 2.0 * SIGHT
            hidden = BENCH_HIDDEN * _cross_walls(looks, setting)
            parts.append(spots._replace(costs=spots.costs + hidden))
    free = join_spots(parts)
    wedged = WEDGED * _stand_near(free.boxes, setting, BENCH_CLOSE)
    wedged = wedged + PUSHED * _stand_near(free.boxes, setting, BENCH_TOUCHING)
    found = join_spots([at_walls, free._replace(costs=free.costs + wedged)])
    crowd = BENCHES_CROWD * measure_crowd(found.boxes, setting.others, BENCHES_WITHIN)
    barring = BARS * _bar_pictures(found.boxes, setting)
    return found._replace(costs=found.costs + crowd + barring)


def _bar_pictures(boxes: Floats, setting: Setting) -> Bools:
    """Which of boxes (k, 5) stand right before or under some picture, or beside it."""
    rows = [box for p in setting.pieces if p.category == PICTURE for box in boxes_of(p)]
    pictures = np.array(rows).reshape(-1, 5)
    pictures[:, 3] += 2.0 * BENCH_ASIDE
    floors = shapely.polygons(corners(lead_before(pictures, BENCH_BEFORE)))
    floors = np.concatenate([floors, shapely.polygons(corners(pictures))])
    near = np.zeros(len(boxes), np.bool_)
    stands = shapely.polygons(corners(boxes))
    near[shapely.STRtree(floors).query(stands, "intersects")[0]] = True
    return near


def _cross_walls(boxes: Floats, setting: Setting) -> Bools:
    """Which of boxes (k, 5) a wall or a side of a column crosses."""
    walls = shapely.linestrings(setting.walls.reshape(-1, 2, 2))
    found = np.zeros(len(boxes), np.bool_)
    found[shapely.STRtree(walls).query(shapely.polygons(corners(boxes)), "intersects")[0]] = True
    return found


def _stand_near(boxes: Floats, setting: Setting, near_by: float) -> Bools:
    """Which of boxes (k, 5) are nearer than ``near_by`` metres to a piece, another bench, a column
    or a wall."""
    bodies = polygons_of([p for p in setting.pieces if p.pose.z < HEAD_HEIGHT])
    walls = shapely.linestrings(setting.walls.reshape(-1, 2, 2))
    others = shapely.polygons(corners(setting.others))
    tree = shapely.STRtree(np.concatenate([bodies, walls, others]))
    near = np.zeros(len(boxes), np.bool_)
    near[tree.query(shapely.polygons(corners(boxes)), "dwithin", near_by)[0]] = True
    return near


def _face_side(piece: Piece, side: int, size: Size, far: float) -> Spots:
    """Spots so ``far`` before one side of a piece, counted from its front, at even distances."""
    long, deep = piece.size[:2] if side % 2 == 0 else piece.size[1::-1]
    if piece.category == ISLAND and long < LARGE:
        return make_spots(np.zeros((0, 5)), 0.0)
    heading = piece.pose.heading + 0.5 * np.pi * side
    front = np.array([np.cos(heading), np.sin(heading)])
    count = max(int(long / PITCH), 1)
    along = ((np.arange(count) + 0.5) / count - 0.5) * long
    points = np.array(piece.pose[:2]) + (0.5 * deep + far) * front
    points = points + along[:, None] * np.array([front[1], -front[0]])
    return make_spots(face(points, heading + np.pi, size), BENCH_OFF * abs(far - FARS[0]))
