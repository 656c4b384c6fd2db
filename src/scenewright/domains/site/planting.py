"""Trees and lamps of a site: rows along the streets, groves on the open ground.

They are dressing: placed after the buildings, clear of them, of ways and of the walks to doors.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog
from scenewright.core.layout import corners
from scenewright.core.scene import Piece
from scenewright.domains.site.problem import Floats
from scenewright.ground.plan import SitePlan, Way
from scenewright.ground.planting.pieces import lamp_piece, tree_piece
from scenewright.ground.planting.places import (
    AVENUE,
    FROM_WAYS,
    VERGE,
    drop_near,
    keep_apart,
    points_beside,
    shake_grid,
    turn_to_road,
)
from scenewright.ground.ways.surfaces import kerb
from scenewright.ground.works import GREEN, GroundWorks, middle_lines

TREES = 900
"""Most trees of a site."""
GROVE = 6.5
"""Side of the squares that hold at most one tree of a grove, in metres."""
LAMPS, LAMP_IN = 28.0, 0.45
"""Distance of the lamps of a street, and how far inside its edge they stand, in metres."""
RIM = 4.0
"""How far inside the edge of a square its trees stand, in metres."""
FROM_BUILDINGS, FROM_WALKS, FROM_BORDER = 4.6, 1.3, 2.5
SCALES = (0.75, 0.88, 1.0, 1.15)
"""Sizes of trees, few so that files can share their meshes."""


class GreenGround(NamedTuple):
    """The site, shrunk by what trees keep from its border, and what they keep clear of."""

    floor: shapely.Polygon
    buildings: shapely.STRtree
    ways: shapely.STRtree
    walks: shapely.STRtree


def green(
    plan: SitePlan,
    works: GroundWorks,
    buildings: Sequence[Piece],
    catalog: Catalog,
    rng: np.random.Generator,
) -> tuple[Piece, ...]:
    """Trees and lamps of a site with its buildings and landmarks, and the ways to them."""
    kinds = catalog.of("tree")
    if not kinds:
        return ()
    ways = cover_ways(works)
    ground = _ground(plan, works, buildings, ways)
    beside = np.concatenate([np.zeros((0, 2)), *(_avenue(way) for way in plan.roads)])
    beside = beside[:: max(1, len(beside) // (8 * TREES))]
    around = _clear(_rim_of_squares(works), ground._replace(walks=shapely.STRtree(ways)), False)
    rows = np.vstack([around, _clear(beside, ground)])
    rows = keep_apart(rows, 0.55 * AVENUE)[: 2 * TREES // 3]
    groves = _groves(plan, ground, rows, rng)[: TREES - len(rows)]
    species = np.concatenate([np.zeros(len(rows)), _waves(groves, 55.0, rng) < -0.35])
    sizes = rng.integers(len(SCALES), size=len(rows) + len(groves))
    sizes[: len(rows)] = 2
    trees = [
        tree_piece(
            f"{plan.id}/tree_{k}", plan.id, kinds[int(kind) % len(kinds)], at, SCALES[size], rng
        )
        for k, (at, kind, size) in enumerate(
            zip(np.vstack([rows, groves]), species, sizes, strict=True), 1
        )
    ]
    return (*trees, *_lamps(plan, catalog))


def _ground(
    plan: SitePlan, works: GroundWorks, buildings: Sequence[Piece], ways: NDArray[np.object_]
) -> GreenGround:
    boxes = [(p.pose.x, p.pose.y, p.pose.heading, p.size.width, p.size.depth) for p in buildings]
    areas = [shapely.Polygon(a.outline, a.holes) for way in plan.roads for a in way.areas]
    set_apart = [shapely.Polygon(a.outline) for a in works.areas if a.kind not in GREEN]
    areas += [shapely.Polygon(outline) for outline in plan.waters]
    return GreenGround(
        shapely.Polygon(plan.outline, plan.holes).buffer(-FROM_BORDER),
        shapely.STRtree(shapely.polygons(corners(np.array(boxes).reshape(-1, 5)))),
        shapely.STRtree(areas),
        shapely.STRtree([*ways, *set_apart]),
    )


def cover_ways(works: GroundWorks) -> NDArray[np.object_]:
    """The ground of the ways of a site, which trees keep clear of."""
    lines = middle_lines([row.line for row in works.pathways])
    wide = np.array([0.5 * row.width for row in works.pathways])
    found: NDArray[np.object_] = shapely.buffer(lines, wide, quad_segs=16)
    return found


def _rim_of_squares(works: GroundWorks) -> Floats:
    """Places (n, 2) of trees round the rim of squares and parks."""
    found = [np.zeros((0, 2))]
    planted = [row for row in works.areas if row.kind in ("square", "park")]
    rims = [shapely.Polygon(row.outline).buffer(-RIM, join_style="mitre") for row in planted]
    for inner in shapely.get_parts(np.array(rims, object)):
        if inner.area > RIM * RIM:
            count = max(round(inner.exterior.length / AVENUE), 4)
            at = np.arange(count) / count
            points = inner.exterior.interpolate(at, normalized=True)
            found.append(shapely.get_coordinates(points))
    return np.concatenate(found)


def _clear(points: Floats, ground: GreenGround, border: bool = True) -> Floats:
    """The points that keep their distances."""
    if border:
        points = points[shapely.contains_xy(ground.floor, points[:, 0], points[:, 1])]
    for tree, distance in (
        (ground.buildings, FROM_BUILDINGS),
        (ground.ways, FROM_WAYS),
        (ground.walks, FROM_WALKS),
    ):
        points = drop_near(points, tree, distance)
    return points


def _avenue(way: Way) -> Floats:
    """Places of trees on both sides of a way."""
    at = [
        points_beside(line, side * (way.width / 2 + VERGE), AVENUE, AVENUE / 2)[:, :2]
        for line in way.inside
        for side in (1, -1)
    ]
    return np.concatenate([np.zeros((0, 2)), *at])


def _groves(plan: SitePlan, ground: GreenGround, rows: Floats, rng: np.random.Generator) -> Floats:
    """Points of a shaken grid where a slow wave is high: groves, and lawns between them."""
    low, high = plan.outline.min(0), plan.outline.max(0)
    step = max(GROVE, math.sqrt(0.5 * plan.area / TREES))
    points = shake_grid(low, high, step, rng)
    points = points[_waves(points, 38.0, rng) > 0.1]
    points = _clear(points, ground)
    if len(rows) and len(points):
        points = drop_near(points, shapely.STRtree(shapely.points(rows)), 0.7 * AVENUE)
    return points[rng.permutation(len(points))]


def _waves(points: Floats, long: float, rng: np.random.Generator) -> Floats:
    """A smooth random field, about -1 to 1, that changes over ``long`` metres."""
    angle, shift = rng.uniform(0, 2 * math.pi, (2, 5))
    ways = np.stack([np.cos(angle), np.sin(angle)]) * 2 * math.pi / long
    return np.asarray(np.cos(points @ (ways * np.linspace(0.6, 1.5, 5)) + shift).sum(1) / 2.0)


def _lamps(plan: SitePlan, catalog: Catalog) -> Iterator[Piece]:
    """Lamps on the pavements, their arms over the road."""
    assets = catalog.of("lamp_post")
    for count, at in enumerate(_lamp_spots(plan)[:TREES] if assets else (), 1):
        yield lamp_piece(f"{plan.id}/lamp_{count}", plan.id, assets[0], at)


def _lamp_spots(plan: SitePlan) -> list[tuple[float, float, float]]:
    """Place and heading of lamps on both sides of the roads in turn, inside, off other ways."""
    found, owners = [np.zeros((0, 3))], [np.zeros(0, np.int64)]
    for number, way in enumerate(plan.roads):
        if way.kind != "road" or not kerb(way.width):
            continue
        for line in way.inside:
            for side, start in ((1, LAMPS / 4), (-1, 3 * LAMPS / 4)):
                at = points_beside(line, side * (way.width / 2 - LAMP_IN), LAMPS, start)
                at[:, 2] = turn_to_road(at[:, 2], side)
                found.append(at)
                owners.append(np.full(len(at), number))
    spots, owner = np.concatenate(found), np.concatenate(owners)
    areas = [
        (number, shapely.Polygon(a.outline, a.holes))
        for number, way in enumerate(plan.roads)
        for a in way.areas
    ]
    floor = shapely.Polygon(plan.outline, plan.holes)
    good = shapely.contains_xy(floor, spots[:, 0], spots[:, 1])
    lamp, area = shapely.STRtree([shape for _, shape in areas]).query(
        shapely.points(spots[:, :2]), predicate="intersects"
    )
    good[lamp[owner[lamp] != np.array([number for number, _ in areas], np.int64)[area]]] = False
    return [(x, y, turn) for x, y, turn in spots[good].tolist()]
