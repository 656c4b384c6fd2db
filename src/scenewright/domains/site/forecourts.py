"""The forecourt and quad of a landmark, and the ground over which it is seen along the street.

The street of a landmark is the first way ahead of its front, else the nearest one that its front
looks towards. The forecourt is as wide as the landmark and reaches to that street if it comes
within a few metres of it. The landmark is in sight from a stretch of the street if nothing stands
on the triangles between that stretch and the middle of its front.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import shapely

from scenewright.domains.site.problem import Floats
from scenewright.ground.plan import Standing, Way

AHEAD, JOIN = 200.0, 8.0
"""Metres ahead in which a street is looked for, and by which a forecourt reaches on to it."""
ASIDE = 0.2
"""Cosine of how far from straight ahead a front is still looked at."""


def lay_forecourt(
    landmark: Standing, depth: float, floor: shapely.Polygon, ways: Sequence[Way]
) -> Floats:
    """Corners (4, 2) of the ground ``depth`` metres ahead of a landmark, as wide as it is; on to
    the street if that is nearly there, never over it, and never beyond the border."""
    front, ahead, aside = _front_of(landmark)
    half = 0.5 * landmark.box[3]
    corners = np.array([front + half * aside, front - half * aside])
    lines = shapely.linestrings(np.stack([corners, corners + (depth + JOIN) * ahead], 1))
    streets = [shapely.Polygon(a.outline, a.holes) for way in ways for a in way.areas]
    stops = shapely.union_all([*streets, floor.exterior])
    gaps = [
        float(shapely.distance(shapely.Point(corner), shapely.intersection(line, stops)))
        for corner, line in zip(corners, lines, strict=True)
    ]
    deep = [depth if np.isnan(gap) else max(gap, 0.1) for gap in gaps]
    found: Floats = np.array(
        [corners[0], corners[0] + deep[0] * ahead, corners[1] + deep[1] * ahead, corners[1]]
    )
    return found if shapely.Polygon(found).exterior.is_ccw else found[::-1]


def lay_quad(
    landmark: Standing, wide: float, floor: shapely.Polygon, ways: Sequence[Way]
) -> shapely.Polygon:
    """The ground ``wide`` metres all round the box of a landmark, as far as it is on the site and
    no way leads over it."""
    front, ahead, aside = _front_of(landmark)
    _, _, _, width, depth = landmark.box
    u, v = (0.5 * depth + wide) * ahead, (0.5 * width + wide) * aside
    middle = front - 0.5 * depth * ahead
    whole = shapely.Polygon([middle - u - v, middle + u - v, middle + u + v, middle - u + v])
    streets = [shapely.Polygon(a.outline, a.holes) for way in ways for a in way.areas]
    parts = shapely.difference(shapely.intersection(whole, floor), shapely.union_all(streets))
    found = [part for part in shapely.get_parts(parts) if part.geom_type == "Polygon"]
    at = shapely.Point(middle)
    return shapely.Polygon(min(found or [whole], key=lambda part: part.distance(at)).exterior)


def find_sight(
    landmark: Standing, reach: float, floor: shapely.Polygon, ways: Sequence[Way]
) -> shapely.Geometry:
    """The ground between a landmark's front and ``reach`` metres of its street, to either side of
    the point ahead; empty where no street is ahead."""
    front, ahead, _ = _front_of(landmark)
    street = _find_stretch(front, ahead, reach, ways)
    if street is None:
        return shapely.Polygon()
    points = shapely.get_coordinates(street)
    fan = [shapely.Polygon([front, a, b]) for a, b in pairwise(points)]
    return shapely.intersection(shapely.union_all(shapely.make_valid(fan)), floor)


def _front_of(landmark: Standing) -> tuple[Floats, Floats, Floats]:
    """The middle of a landmark's front, the direction it looks in, and that to its left."""
    x, y, heading, _, depth = landmark.box
    ahead = np.array([np.cos(heading), np.sin(heading)])
    return np.array([x, y]) + 0.5 * depth * ahead, ahead, np.array([-ahead[1], ahead[0]])


def _find_stretch(
    front: Floats, ahead: Floats, reach: float, ways: Sequence[Way]
) -> shapely.LineString | None:
    """The stretch of the street before a front from which it is to be seen."""
    ray = shapely.LineString([front, front + AHEAD * ahead])
    best, nearest = None, np.inf
    for line in (shapely.LineString(line) for way in ways for line in way.inside or way.beside):
        met = shapely.intersection(line, ray)
        point = met if not met.is_empty else shapely.shortest_line(line, shapely.Point(front))
        at = shapely.get_coordinates(point)[0]
        far = float(np.hypot(*(at - front)))
        if far > 0.0 and (at - front) @ ahead > ASIDE * far and far < nearest:
            best, nearest = (line, float(line.project(shapely.Point(at)))), far
    if best is None:
        return None
    line, along = best
    stops = np.arange(along - reach, along + reach + 0.5, 1.0)
    points = shapely.get_coordinates(line.interpolate(np.clip(stops, 0.0, line.length)))
    way = points - front
    seen = way @ ahead > ASIDE * np.hypot(*way.T)
    kept = points[seen]
    return shapely.LineString(kept) if len(kept) > 1 else None
