"""Parks of a layout: open ground farther than :data:`FAR` metres from every building is made one,
with a walk round it that begins at the nearest way."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
import shapely.ops
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.ground.plan import SitePlan
from scenewright.ground.ways.surfaces import pave
from scenewright.ground.ways.walks import WALK
from scenewright.ground.works import Pathway, PavedArea

Shapes = NDArray[np.object_]

FAR, LEAST, NARROW = 25.0, 400.0, 4.0
"""Metres from a building beyond which ground is void; square metres of a park at least (a pocket
park); half the width in metres of ground that is too narrow for one."""
FROM_WALLS, FROM_WAYS, FROM_BORDER = 8.0, 1.0, 2.0
"""Metres that a park stays off walls, ways and the border."""
REACH, INSET, LINK = 17.0, 5.0, 40.0
"""Metres by which a park is larger than the void it takes up, from its edge to the walk round it,
and of the longest walk to it."""
PLAIN, TURNED, ROUND = 0.5, 4.0, 80.0
"""Metres by which its outline is drawn more simply, radius of the corners of its walk, and square
metres at least that this goes round."""


def lay_parks(
    plan: SitePlan,
    pathways: Sequence[Pathway],
    areas: Sequence[PavedArea],
    footprints: Sequence[Points],
) -> tuple[tuple[PavedArea, ...], tuple[Pathway, ...]]:
    """The parks of a site, the largest first, and the walks of each; ``footprints`` (k, 2) are
    those of its buildings."""
    floor = shapely.Polygon(plan.outline, plan.holes)
    marks = [*footprints, *(row.footprint for row in plan.landmarks)]
    built = np.array([shapely.Polygon(ring) for ring in marks], object)
    if not len(built):
        return (), ()
    near = shapely.union_all(shapely.buffer(built, FAR, quad_segs=4))
    void = shapely.difference(floor.buffer(-FROM_BORDER), near)
    void = shapely.union_all([part for part in shapely.get_parts(void) if part.area >= LEAST])
    if void.is_empty:
        return (), ()
    zone = void.buffer(LINK, quad_segs=2)
    shapely.prepare(zone)
    built = built[shapely.intersects(zone, built)]
    ways = _cover_ways(plan, pathways, areas, zone)
    open_ = shapely.difference(shapely.intersection(floor, zone), ways.buffer(FROM_WAYS))
    open_ = shapely.intersection(open_, floor.buffer(-FROM_BORDER))
    void = shapely.intersection(void, open_)
    parts = [p for p in _parts(void.buffer(-NARROW).buffer(NARROW)) if p.area >= LEAST]
    if not parts:
        return (), ()
    walls = shapely.union_all(shapely.buffer(built, FROM_WALLS, quad_segs=2))
    waters = [shapely.Polygon(ring) for ring in plan.waters]
    open_ = shapely.difference(open_, shapely.union_all([walls, *waters]))
    grown = shapely.intersection(shapely.union_all(parts).buffer(REACH), open_)
    plain = shapely.simplify(grown.buffer(-NARROW).buffer(NARROW), PLAIN)
    grounds = [p for whole in _parts(plain) for p in _cut_at_holes(whole) if p.area >= LEAST]
    grounds.sort(key=_area, reverse=True)
    names = ["Park"] if len(grounds) == 1 else [f"Park {k + 1}" for k in range(len(grounds))]
    parks = [
        PavedArea("park", _corners(ground.exterior), 0, name)
        for ground, name in zip(grounds, names, strict=True)
    ]
    solid = shapely.STRtree(built)
    walks = [walk for ground in grounds for walk in _lay_walks(ground, ways, solid)]
    return tuple(parks), tuple(walks)


def _cover_ways(
    plan: SitePlan, pathways: Sequence[Pathway], areas: Sequence[PavedArea], zone: shapely.Geometry
) -> shapely.Geometry:
    """All that is paved in a zone."""
    lines = np.array([shapely.LineString(row.line) for row in pathways], object)
    here = [pathways[k] for k in np.flatnonzero(shapely.intersects(zone, lines)).tolist()]
    streets = [shapely.Polygon(a.outline, a.holes) for way in plan.roads for a in way.areas]
    paved = [pave(here, kind) for kind in ("lane", "drive", "walk")]
    apart = [shapely.Polygon(row.outline) for row in areas]
    return shapely.union_all([*streets, *paved, *apart])


def _parts(shape: shapely.Geometry) -> list[shapely.Polygon]:
    return [part for part in shapely.get_parts(shape) if part.geom_type == "Polygon"]


def _cut_at_holes(ground: shapely.Polygon) -> list[shapely.Polygon]:
    """Ground as parts without holes: cut along the meridian of each."""
    if not len(ground.interiors):
        return [ground]
    x, low, high = ground.interiors[0].centroid.x, ground.bounds[1] - 1.0, ground.bounds[3] + 1.0
    halves = shapely.ops.split(ground, shapely.LineString([(x, low), (x, high)]))
    return [part for half in _parts(halves) for part in _cut_at_holes(half)]


def _lay_walks(
    ground: shapely.Polygon, ways: shapely.Geometry, solid: shapely.STRtree
) -> list[Pathway]:
    """The walk round a park and the one that leads to it, if no wall is in its way."""
    inner = max(_parts(ground.buffer(-INSET - TURNED).buffer(TURNED)), key=_area, default=None)
    if inner is None or inner.area < ROUND:
        return []
    ring = shapely.simplify(inner.exterior, 0.25)
    found = [Pathway("walk", WALK, (*_corners(ring), _corners(ring)[0]))]
    if ways.is_empty:
        return found
    link = shapely.shortest_line(ring, ways)
    free = not len(solid.query(link, predicate="dwithin", distance=WALK))
    if free and 0.1 < link.length <= LINK:
        found.append(Pathway("walk", WALK, _corners(link, closed=False)))
    return found


def _area(shape: shapely.Polygon) -> float:
    return float(shape.area)


def _corners(line: shapely.Geometry, closed: bool = True) -> tuple[tuple[float, float], ...]:
    points = shapely.get_coordinates(line)[: -1 if closed else None]
    return tuple((x, y) for x, y in np.round(points, 3).tolist())
