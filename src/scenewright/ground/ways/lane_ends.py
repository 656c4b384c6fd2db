"""Ends of lanes: each is led on to another lane or a street where free ground lies between, and one
that stays a dead end gets a head to turn in.

A fire engine turns on a circle of :data:`TURN` metres; dead ends over :data:`LONG` metres need one.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from shapely.ops import substring

from scenewright.ground.plan import SitePlan
from scenewright.ground.streetside.border import cover_beside

LONG, LINK, TURN, ASIDE = 30.0, 60.0, 6.0, 10.0
"""Metres of the longest dead end without a head, of the longest link to another way, of the radius
of a head, and how far aside of its lane a head may lie."""
BACK = (0.0, 4.0, 8.0, 12.0, 16.0, 20.0)
"""Metres before the end of a lane at which a head may lie: a fire engine backs up 20 m at most
(Approved Document B, volume 2, 2019: 15.4)."""
STUMP, JOINED = 0.2, 0.3
"""Metres of the middle line of a head; metres within which an end is on another way."""

Lines = Sequence[shapely.LineString]


def find_dead_ends(
    lanes: Lines, streets: shapely.Geometry, radius: float
) -> dict[int, shapely.Point]:
    """By the number of each lane that ends on no other way, ``radius`` metres of each side being
    the lane's, that end.

    >>> lanes = [shapely.LineString([(0, 0), (40, 0)]), shapely.LineString([(20, 0), (20, 9)])]
    >>> find_dead_ends(lanes, shapely.Point(0, 0), 2.0)[0].wkt
    'POINT (40 0)'
    """
    if not lanes:
        return {}
    rows = shapely.points([point for lane in lanes for point in (lane.coords[0], lane.coords[-1])])
    tree = shapely.STRtree([*lanes, streets])
    end, way = tree.query(rows, predicate="dwithin", distance=radius + JOINED)
    joined = np.zeros(len(rows), bool)
    joined[end[way != end // 2]] = True
    return {int(k) // 2: rows[k] for k in np.flatnonzero(~joined)}


def link_ends(
    lanes: Lines, streets: shapely.Geometry, centres: shapely.Geometry, radius: float
) -> list[shapely.LineString]:
    """Straight links from dead ends to another lane or a street, where the middle of a lane may lie
    (``centres``) all the way: lanes that are loops."""
    links: list[shapely.LineString] = []
    ground, tree = shapely.buffer(centres, 0.01), shapely.STRtree([*lanes, streets])
    shapely.prepare(ground)
    shapely.prepare(streets)
    for number, end in find_dead_ends(lanes, streets, radius).items():
        near = tree.query(end, predicate="dwithin", distance=LINK)
        ways = [*tree.geometries[near[near != number]], *links]
        lines = shapely.shortest_line(end, np.array(ways, object))
        long = shapely.length(lines)
        lines = lines[np.argsort(long, kind="stable")][: int((long <= LINK).sum())]
        own = lanes[number].difference(end.buffer(1.0)) if len(lines) else None
        for line in lines:
            ahead = line.interpolate(max(line.length - radius - 1.0, 0.0))
            drive = shapely.LineString([end, ahead])
            if line.length <= 1.0 or line.distance(own) <= 0.5:
                continue
            joins = shapely.dwithin(streets, line, JOINED)
            free = shapely.covers(ground, drive if joins else line)
            if free and not shapely.intersects(streets, drive):
                links.append(line)
                break
    return links


def lay_head(
    lane: shapely.LineString, end: shapely.Point, centres: shapely.Geometry, wide: shapely.Geometry
) -> list[tuple[shapely.LineString, float]]:
    """The middle lines and widths of a head near the ``end`` of a lane, and of what leads to it
    (width 0: that of the lane); the first line is the lane up to there. A head lies at most
    :data:`BACK` metres before the end and :data:`ASIDE` metres off the lane; none if there is no
    room. ``wide`` is where the middle of a head may lie, ``centres`` where that of a lane may.

    >>> lane, ground = shapely.LineString([(0, 0), (40, 0)]), shapely.box(0, -9, 50, 9)
    >>> [line.wkt for line, _ in lay_head(lane, shapely.Point(40, 0), ground, ground)]
    ['LINESTRING (0 0, 40 0)', 'LINESTRING (40 0, 40.2 0)']
    """
    if wide.is_empty:
        return []
    away = lane if end.distance(shapely.Point(lane.coords[-1])) < JOINED else lane.reverse()
    for back in BACK:
        place = away.interpolate(away.length - back)
        link = shapely.shortest_line(place, wide)
        if link.length > ASIDE or not shapely.covers(centres, link):
            continue
        x, y = link.coords[-1]
        rows = [(substring(away, 0.0, away.length - back), 0.0)] if back else [(lane, 0.0)]
        rows.append((shapely.LineString([(x, y), (x + STUMP, y)]), 2.0 * TURN))
        if back:
            rows.append((substring(away, away.length - back, away.length), 0.0))
        return [*rows, (link, 0.0)] if link.length > 1.0 else rows
    return []


def list_streets(plan: SitePlan) -> shapely.Geometry:
    """The ground of roads inside a site and beside it, and the border that is open to those."""
    areas: list[shapely.Geometry] = [
        shapely.Polygon(area.outline, area.holes)
        for way in plan.roads
        if way.kind == "road"
        for area in way.areas
    ]
    beside = [cover_beside(way) for way in plan.roads if way.beside]
    mouths = [shapely.LineString(mouth) for way in plan.roads for mouth in way.mouths]
    return shapely.union_all([*areas, *beside, *mouths])
