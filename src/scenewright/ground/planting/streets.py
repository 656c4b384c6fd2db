"""Places of the trees and lamps of streets, along both sides: trees beside the street, or on a
pavement wide enough for one; lamps on the pavement. Clear of houses, doors, crossings and corners.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.ground.buildings.built import BuiltRoad, Floats
from scenewright.ground.plan import SitePlan, Way
from scenewright.ground.planting.places import (
    FROM_HOUSES,
    FROM_WAYS,
    VERGE,
    drop_near,
    points_beside,
    turn_to_road,
)
from scenewright.ground.ways.surfaces import kerb, list_zebras

STEM, CLEAR = 0.7, 0.6
"""Metres from the edge of a carriageway of the stems of trees on its pavement, and from any."""
LAMP_IN, LAMP_OFF = 0.45, 0.5
"""Metres that lamps stand inside the edge of a street with pavements, and off one without."""
TRIED = 2.0
"""Metres between the places beside a street that are tried."""
FROM_LAMPS, FROM_DOORS, FROM_ROADS = 0.6, 2.0, 0.4
"""Metres that lamps keep from buildings and walks, everything from doors, lamps from streets."""
BEFORE, ACROSS = 5.0, 6.0
"""Metres before a crossing that are free of trees (StVO § 12: of cars), and by which it is wider
with its pavements."""
SIGHT = 10.0
"""Legs in metres of the triangles at corners that are free of trees, for drivers to see."""


class TakenGround(NamedTuple):
    """What trees and lamps keep clear of: ``ways`` with waters, ``walks`` and lanes, places of
    ``doors``, crossings, and the triangles of ``sight`` at corners."""

    buildings: shapely.STRtree
    ways: shapely.STRtree
    walks: shapely.STRtree
    doors: shapely.STRtree
    crossings: shapely.STRtree
    sight: shapely.STRtree


def keep_sight(plan: SitePlan) -> tuple[shapely.STRtree, shapely.STRtree]:
    """The crossings of the streets of a ground with their pavements, and the triangles of sight at
    its corners."""
    crossings = [one._replace(wide=one.wide + ACROSS).area() for one in list_zebras(plan)]
    return shapely.STRtree(crossings), shapely.STRtree(_triangles(plan.roads))


def _triangles(ways: Sequence[Way]) -> list[shapely.Geometry]:
    """Around every meeting of two streets, what lies between their arms."""
    driven = [way for way in ways if way.kind == "road"]
    lines = np.array([shapely.LineString(way.line) for way in driven], object)
    half = np.array([way.width / 2 for way in driven])
    ground = shapely.buffer(lines, half, cap_style="flat")
    found = []
    for a, b in shapely.STRtree(lines).query(lines, predicate="intersects").T.tolist():
        at = shapely.intersection(lines[a], lines[b]) if a < b else shapely.Point()
        for point in (part for part in shapely.get_parts(at) if part.geom_type == "Point"):
            near = shapely.buffer(point, SIGHT + max(half[a], half[b]))
            arms = shapely.intersection(shapely.union(ground[a], ground[b]), near)
            found.append(shapely.convex_hull(arms))
    return found


def list_tree_places(
    roads: Sequence[BuiltRoad], taken: TakenGround, step: float = TRIED
) -> list[Floats]:
    """Places (n, 2) of trees along each side of each way in turn, every ``step`` metres: on the
    pavement of streets where it is as wide as :data:`VERGE`, else :data:`VERGE` beside them."""
    hard = shapely.STRtree([_carriageway(road) for road in roads])
    found = []
    for road in roads:
        pavement = _pavement(road)
        inside = pavement >= VERGE
        for at in _line(road, STEM - pavement if inside else VERGE, step):
            at = drop_near(at, hard, CLEAR) if inside else drop_near(at, taken.ways, FROM_WAYS)
            found.append(_clear(at, taken, (FROM_HOUSES, FROM_WAYS, BEFORE))[:, :2])
    return [drop_near(at, taken.sight, 0.0) for at in found]


def list_lamp_places(
    roads: Sequence[BuiltRoad], taken: TakenGround, step: float = TRIED
) -> list[Floats]:
    """Places (n, 3) of lamps with their headings along each side of each street, every ``step``
    metres: on its pavement, or beside a street that has none."""
    hard = shapely.STRtree([_carriageway(road) for road in roads])
    found = []
    for road in (road for road in roads if road.kind == "road"):
        for at in _line(road, -LAMP_IN if _pavement(road) else LAMP_OFF, step):
            at = _clear(at, taken, (FROM_LAMPS, FROM_LAMPS, FROM_LAMPS))
            found.append(drop_near(at, hard, FROM_ROADS))
    return found


def _line(road: BuiltRoad, off: float, step: float) -> Iterator[Floats]:
    """Places (n, 3) with headings towards the street, ``off`` metres from its edges."""
    for side, start in ((1, step / 4), (-1, 3 * step / 4)):
        at = points_beside(road.line, side * (road.width / 2 + off), step, start)
        at[:, 2] = turn_to_road(at[:, 2], side)
        yield at


def _clear(spots: Floats, taken: TakenGround, off: tuple[float, float, float]) -> Floats:
    """Spots that keep ``off`` buildings, walks and crossings, in metres, and off doors."""
    shapes = (taken.buildings, taken.walks, taken.crossings, taken.doors)
    for one, distance in zip(shapes, (*off, FROM_DOORS), strict=True):
        spots = drop_near(spots, one, distance)
    return spots


def _pavement(road: BuiltRoad) -> float:
    return kerb(road.width) if road.kind == "road" else 0.0


def _carriageway(road: BuiltRoad) -> shapely.Geometry:
    """The ground of a street without its pavements."""
    line = shapely.LineString(road.line)
    return shapely.buffer(line, road.width / 2 - _pavement(road), cap_style="flat")
