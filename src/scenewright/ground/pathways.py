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
from scenewright.ground.border import find_mouths, is_entered_anywhere
from scenewright.ground.lanes import lay_lanes
from scenewright.ground.path_raster import make_raster
from scenewright.ground.plan import SitePlan
from scenewright.ground.walks import COMFORT, Doors, find_doors, lay_walks
from scenewright.ground.works import Pathway

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

JOIN = 0.05
"""Metres between an area and a street that adjoin."""


class Network(NamedTuple):
    """The ways of a site, which buildings a lane or road is near to, and which have a walk to
    their door."""

    pathways: tuple[Pathway, ...]
    near: Flags
    served: Flags


def lay_pathways(
    plan: SitePlan, footprints: Sequence[Points], headings: Floats, width: float, reach: float
) -> Network:
    """Lanes of some ``width`` that come within ``reach`` of every building, and walks to the
    doors. ``footprints`` are corners (k, 2), ``headings`` (n,) those of the fronts; landmarks
    stand in the way."""
    marks = [np.asarray(row.footprint, float) for row in plan.landmarks]
    lots = [np.array(area.outline) for area in plan.areas if area.kind == "parking"]
    solids = [*(np.asarray(ring, float) for ring in footprints), *marks, *lots]
    built = np.array([shapely.Polygon(ring) for ring in solids], object)
    squares, apart = find_joined_areas(plan)
    cap = max(0.5 * width + 1.0, COMFORT) + 1.0
    raster = make_raster(plan, solids, cap, width, squares)
    doors = find_doors(footprints, headings)
    lanes, near = lay_lanes(plan, raster, solids, built, doors.ways, width, reach)
    named = [row for row in plan.landmarks if row.model]
    of_marks = find_doors(
        [np.asarray(row.footprint, float) for row in named], np.array([r.box[2] for r in named])
    )
    places = np.vstack([doors.places, apart.places, of_marks.places])
    every = Doors(places, np.vstack([doors.ways, apart.ways, of_marks.ways]))
    walks, served = lay_walks(plan, raster, built, every, lanes)
    return Network((*lanes, *walks), near, served[: len(footprints)])


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
