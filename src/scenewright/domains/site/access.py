"""Which buildings of a layout a way of the width of ``fire_access`` leads to.

Layouts keep such ways between rows and around courts; where ground is ragged or holes bar the way,
a building may still be cut off, and is left out rather than built.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.core.footprint import place_outline
from scenewright.core.layout import corners
from scenewright.domains.site.brief import VERGE
from scenewright.domains.site.problem import Flags, Floats
from scenewright.ground.plan import SitePlan
from scenewright.ground.streetside.border import find_mouths

ARRIVE, SLACK, ROUND = 1.995, 0.0095, 8
"""How near a way must come, in metres; what a way may lack of its width on each side, so that one
exactly wide enough counts; segments of a quarter of a circle."""
END = 0.005
"""Metres before the border from which a street goes on outside."""


def find_reached_buildings(
    plan: SitePlan,
    boxes: Floats,
    width: float,
    outlines: Sequence[Floats] = (),
    verge: float = VERGE,
) -> Flags:
    """Which of the buildings (n, 5) the middle of a way of some width comes near to, from a road
    or an entrance or the border beside a street, or from anywhere on the outline of a site without
    any. ``outlines`` are corners (k, 2) of what each covers in its own frame (left out: all are
    boxes); outside, a way runs on streets and within a ``verge`` of them."""
    radius = 0.5 * width - SLACK
    footprints = shapely.polygons(corners(boxes))
    for number, (outline, box) in enumerate(zip(outlines, boxes, strict=False)):
        footprints[number] = shapely.Polygon(place_outline(outline, *box[:3]))
    marks = [shapely.Polygon(row.footprint) for row in (*plan.landmarks, *plan.fixed)]
    solid = np.concatenate([footprints, np.array(marks, object)])
    floor = shapely.Polygon(plan.outline, plan.holes)
    around = shapely.union_all(shapely.buffer(solid, radius, quad_segs=ROUND))
    room = shapely.union_all([floor, *_list_ground_outside(plan, width, verge)])
    free = shapely.get_parts(shapely.difference(room.buffer(-radius, quad_segs=ROUND), around))
    start = _start(plan, floor, radius)
    shapely.prepare(start)
    driven = free[shapely.intersects(start, free)]
    shapely.prepare(driven)
    got = np.zeros(len(boxes), np.bool_)
    for part in driven:
        got |= shapely.dwithin(part, footprints, radius + ARRIVE)
    return got


def _list_ground_outside(plan: SitePlan, width: float, verge: float) -> list[shapely.Geometry]:
    """The ground along streets outside, and where they run so near the border that a way of some
    width does not stay inside on them."""
    whole, found = shapely.Polygon(plan.outline), []
    for street in plan.roads:
        deep = max(0.5 * (width - street.width), 0.0) + END
        line = shapely.difference(shapely.LineString(street.line), shapely.buffer(whole, -deep))
        ground = shapely.buffer(line, 0.5 * street.width + verge, cap_style="square")
        found.append(shapely.difference(ground, whole))
    return found


def _start(plan: SitePlan, floor: shapely.Polygon, radius: float) -> shapely.Geometry:
    """Where ways begin: on roads, at entrances, and along the border that is open to streets beside
    it."""
    roads = [
        shapely.Polygon(area.outline, area.holes)
        for way in plan.roads
        if way.kind == "road"
        for area in way.areas
    ]
    doors = [shapely.Point(e.x, e.y) for e in plan.entrances]
    mouths = find_mouths(plan)
    if not roads and not doors and mouths.is_empty:
        return floor.exterior.buffer(1.5 * radius)
    ways_in = [row.buffer(1.5 * radius) for row in (*doors, mouths)]
    return shapely.union_all([*roads, *ways_in])
