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
from scenewright.ground.lanes import lay_lanes
from scenewright.ground.path_raster import make_raster
from scenewright.ground.plan import SitePlan
from scenewright.ground.walks import COMFORT, find_doors, lay_walks
from scenewright.ground.works import Pathway

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


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
    solids = [*(np.asarray(ring, float) for ring in footprints), *marks]
    built = np.array([shapely.Polygon(ring) for ring in solids], object)
    raster = make_raster(plan, solids, max(0.5 * width + 1.0, COMFORT) + 1.0, width)
    doors = find_doors(footprints, headings)
    lanes, near = lay_lanes(plan, raster, solids, built, doors.ways, width, reach)
    walks, served = lay_walks(plan, raster, built, doors, lanes)
    return Network((*lanes, *walks), near, served)
