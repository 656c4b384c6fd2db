"""Whether a door has room before it: the border of a site ahead, and no way in between."""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.ground.plan import SitePlan
from scenewright.ground.streetside.border import is_entered_anywhere
from scenewright.ground.ways.walks import Doors

SLACK = 0.005


def find_doors_at_border(plan: SitePlan, doors: Doors, distance: float) -> NDArray[np.bool_]:
    """Which doors have the border less than ``distance`` metres ahead of them and no road or path
    before it, nor one beside the border there. None on sites without ways, which are entered from
    anywhere on their border."""
    none = np.zeros(len(doors.places), bool)
    if is_entered_anywhere(plan) or not len(none) or distance <= SLACK:
        return none
    floor = shapely.Polygon(plan.outline, plan.holes)
    ahead = doors.places + (distance - SLACK) * doors.ways
    lines = shapely.linestrings(np.stack([doors.places, ahead], 1))
    shapely.prepare(floor)
    streets = [shapely.Polygon(a.outline, a.holes) for way in plan.roads for a in way.areas]
    streets += [shapely.LineString(mouth) for way in plan.roads for mouth in way.mouths]
    reached = none.copy()
    if streets:
        reached[np.unique(shapely.STRtree(streets).query(lines, predicate="intersects")[0])] = True
    found: NDArray[np.bool_] = ~shapely.covers(floor, lines) & ~reached
    return found
