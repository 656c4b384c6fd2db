"""Ways for the fire brigade: can a way of the stated width be driven from a road to a building?

The middle of the way may go where a disc of its width stays on the site and off every building.
It starts on a road, or where a road or path crosses the outline; on sites without either,
anywhere along the outline. A building is reached if the way comes within 2 m of it.
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
    room = shapely.buffer(grounds.floor, -radius, quad_segs=_ROUND)
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
    roads = grounds.ways[grounds.drivable]
    entrances = shapely.points([(e.x, e.y) for e in grounds.plan.entrances] or np.empty((0, 2)))
    if not len(roads) and not len(entrances):
        return shapely.buffer(grounds.border, 1.5 * radius)
    return shapely.union_all([*roads, *shapely.buffer(entrances, 1.5 * radius)])


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
