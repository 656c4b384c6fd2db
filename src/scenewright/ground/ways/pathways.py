"""Ways between buildings: lanes for fire engines and cars, and walks from streets to every door.

Lanes come first: as few as bring a way of the stated width to within reach of every building. Walks
lead from each door to the nearest street, lane or path, and run together where they can. On sites
without roads or paths ways begin anywhere on the border.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.ground.plan import SitePlan
from scenewright.ground.streetside.border import find_exits, find_mouths, is_entered_anywhere
from scenewright.ground.streetside.fronts import cover_lanes, list_ways
from scenewright.ground.ways.front_lanes import lay_front_lanes, turn_fronts
from scenewright.ground.ways.lane_finish import finish_lanes
from scenewright.ground.ways.lanes import LaneGround, laid_lanes, lay_lanes
from scenewright.ground.ways.path_raster import make_raster
from scenewright.ground.ways.walks import COMFORT, Doors, find_doors, join_doors, lay_walks
from scenewright.ground.works import Pathway

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

ROUNDS = 2
"""How often fronts turn to the ways and lanes are led before the others."""
JOIN = 0.05
"""Metres between an area and a street that adjoin."""


class Network(NamedTuple):
    """The ways of a site, which buildings a lane or road is near to, which have a walk to their
    door, and the headings (n,) of their fronts, turned to the ways."""

    pathways: tuple[Pathway, ...]
    near: Flags
    served: Flags
    headings: Floats


def lay_pathways(
    plan: SitePlan,
    footprints: Sequence[Points],
    headings: Floats,
    width: float,
    reach: float,
    free: Flags | None = None,
) -> Network:
    """Lanes of some ``width`` that come within ``reach`` of every building, and walks to the
    doors. ``footprints`` are corners (k, 2), ``headings`` (n,) those of the fronts; landmarks
    stand in the way. With ``free`` (n,), boxes that may be turned round, fronts turn to the
    ways beside them, and lanes lead before those that look at none."""
    marks = [np.asarray(row.footprint, float) for row in plan.landmarks]
    marks += plan.waters
    lots = [np.array(area.outline) for area in plan.areas if area.kind == "parking"]
    solids = [*(np.asarray(ring, float) for ring in footprints), *marks, *lots]
    built = np.array([shapely.Polygon(ring) for ring in solids], object)
    squares, apart = find_joined_areas(plan)
    cap = max(0.5 * width + 1.0, COMFORT) + 1.0
    raster = make_raster(plan, solids, cap, width, squares)
    exits, radius = find_exits(plan, width), 0.5 * width
    ground = LaneGround(plan, raster, built, shapely.STRtree(built), exits, radius)
    doors = find_doors(footprints, headings)
    laying, near = lay_lanes(ground, solids, doors.ways, reach)
    marked = [k for k, row in enumerate(plan.landmarks) if row.model]
    of_marks = find_doors(
        [marks[k] for k in marked], np.array([plan.landmarks[k].box[2] for k in marked])
    )
    if free is not None:
        streets, count = list_ways(plan, ()), len(footprints)
        rows = [*range(count), *(count + k for k in marked)]
        for _ in range(ROUNDS):
            ways = np.append(streets, cover_lanes(laid_lanes(laying, width)))
            headings = turn_fronts(ways, built, footprints, headings, free)
            led = find_doors(footprints, headings)
            laying = lay_front_lanes(
                ground, streets, built[rows], join_doors(led, of_marks), laying
            )
    lanes = finish_lanes(ground, laying)
    if free is not None:
        ways = np.append(streets, cover_lanes(lanes))
        headings = turn_fronts(ways, built, footprints, headings, free)
    doors = join_doors(find_doors(footprints, headings), apart, of_marks)
    walks, served = lay_walks(plan, raster, built, doors, lanes)
    return Network((*lanes, *walks), near, served[: len(footprints)], headings)


def find_joined_areas(plan: SitePlan) -> tuple[list[Points], Doors]:
    """The squares and forecourts that adjoin a street, and where others are entered: the middle of
    the second edge of each, which lies opposite what it is before. None on sites without ways,
    which are entered from anywhere on their border."""
    streets = [shapely.Polygon(a.outline, a.holes) for way in plan.roads for a in way.areas]
    around = shapely.union_all([*streets, find_mouths(plan)])
    anywhere = is_entered_anywhere(plan)
    joined, places, ways = [], np.zeros((0, 2)), np.zeros((0, 2))
    for area in plan.areas:
        ring = np.array(area.outline)
        if not anywhere and area.kind in ("square", "forecourt"):
            if shapely.dwithin(around, shapely.Polygon(ring), JOIN):
                joined.append(ring)
            else:
                out = ring[1] + ring[2] - ring[0] - ring[3]
                places = np.vstack([places, 0.5 * (ring[1] + ring[2])])
                ways = np.vstack([ways, out / max(float(np.hypot(*out)), 1e-9)])
    return joined, Doors(places, ways)
