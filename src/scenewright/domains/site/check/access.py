"""Ways for the fire brigade: can a way of the stated width be driven from a road to a building?

The middle of the way may go where a disc of its width stays on the site, or on ground over which
one crosses from a street beside it, and off every building. It starts on a road, or where the line
of a road or path lies at the border or outside; on sites that no street serves, anywhere along the
outline. A building is reached if the way comes within 2 m of it.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Flags, Shape
from scenewright.core.report import Finding
from scenewright.domains.site.check.bodies import JudgedSite, SiteBodies

ARRIVE = 2.0
_ROUND = 8


def find_reached_bodies(grounds: JudgedSite, bodies: SiteBodies) -> Flags:
    """Which bodies a way of the width of ``fire_access`` reaches."""
    radius = grounds.site.fire_access / 2 - TOLERANCE
    around = shapely.buffer(bodies.footprints, radius, quad_segs=_ROUND)
    whole = shapely.union_all([grounds.floor, *grounds.streets.crossings])
    room = shapely.buffer(whole, -radius, quad_segs=_ROUND)
    free = shapely.get_parts(shapely.difference(room, shapely.union_all(around)))
    start = _start(grounds, radius)
    shapely.prepare(start)
    driven = free[shapely.intersects(start, free)]
    shapely.prepare(driven)
    got = np.zeros(len(bodies.ids), bool)
    for part in driven:
        got |= shapely.dwithin(part, bodies.footprints, radius + ARRIVE)
    return got


def _start(grounds: JudgedSite, radius: float) -> Shape:
    streets = grounds.streets
    starts = [
        *streets.surfaces[streets.road],
        *shapely.buffer(streets.ends[~shapely.is_empty(streets.ends)], 1.5 * radius),
    ]
    return shapely.union_all(starts or [shapely.buffer(grounds.border, 1.5 * radius)])


def find_unreachable(grounds: JudgedSite, bodies: SiteBodies, got: Flags) -> list[Finding]:
    """Buildings that no such way reaches."""
    width = grounds.site.fire_access
    return [
        Finding(
            "unreachable_building",
            "",
            grounds.plan.id,
            bodies.ids[row],
            "",
            f"no way {width:g} m wide leads from a road or entrance to {bodies.ids[row]}",
            width,
            0.0,
            bool(bodies.given[row]),
        )
        for row in np.flatnonzero(~got & ~bodies.landmark)
    ]
