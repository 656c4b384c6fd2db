"""Trees and lamps of a site: rows along the streets, groves on the open ground.

They are dressing: placed after the buildings, clear of them, of ways and of the walks to doors.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog
from scenewright.core.layout import corners
from scenewright.core.scene import Piece
from scenewright.domains.site.problem import Floats
from scenewright.ground.buildings.built import BuiltRoad
from scenewright.ground.plan import SitePlan
from scenewright.ground.planting.pieces import lamp_piece, tree_piece
from scenewright.ground.planting.places import AVENUE, FROM_WAYS, drop_near, keep_apart, shake_grid
from scenewright.ground.planting.streets import (
    TRIED,
    TakenGround,
    keep_sight,
    list_lamp_places,
    list_tree_places,
)
from scenewright.ground.ways.surfaces import kerb
from scenewright.ground.works import GREEN, GroundWorks, middle_lines

TREES = 900
"""Most trees of a site."""
GROVE = 6.5
"""Side of the squares that hold at most one tree of a grove, in metres."""
LAMPS = 28.0
"""Metres between the lamps on one side of a street."""
RIM = 4.0
"""How far inside the edge of a square its trees stand, in metres."""
FROM_BUILDINGS, FROM_WALKS, FROM_BORDER = 4.6, 1.3, 2.5
SCALES = (0.75, 0.88, 1.0, 1.15)
"""Sizes of trees, few so that files can share their meshes."""


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
    ground, taken = _floor(plan), _take_ground(plan, works, buildings, ways)
    roads = [BuiltRoad(at, way.width, way.kind) for way in plan.roads for at in way.inside]
    lamps = _lamps(plan, roads, taken)
    lit = taken._replace(doors=shapely.STRtree(shapely.points(lamps[:, :2])))
    long = sum(shapely.LineString(road.line).length for road in roads)
    sides = list_tree_places(roads, lit, max(TRIED, long / (4 * TREES)))
    beside = np.concatenate([np.zeros((0, 2)), *(keep_apart(at, AVENUE) for at in sides)])
    around = _clear(_rim_of_squares(works), taken._replace(walks=shapely.STRtree(ways)))
    beside = beside[shapely.contains_xy(ground, beside[:, 0], beside[:, 1])]
    rows = keep_apart(np.vstack([around, beside]), 0.55 * AVENUE)[: 2 * TREES // 3]
    groves = _groves(plan, ground, taken, rows, rng)[: TREES - len(rows)]
    species = np.concatenate([np.zeros(len(rows)), _waves(groves, 55.0, rng) < -0.35])
    sizes = rng.integers(len(SCALES), size=len(rows) + len(groves))
    free = drop_near(rows, taken.buildings, FROM_BUILDINGS)
    sizes[: len(rows)] = np.where((rows[:, None] == free).all(2).any(1), 2, 0)
    trees = [
        tree_piece(
            f"{plan.id}/tree_{k}", plan.id, kinds[int(kind) % len(kinds)], at, SCALES[size], rng
        )
        for k, (at, kind, size) in enumerate(
            zip(np.vstack([rows, groves]), species, sizes, strict=True), 1
        )
    ]
    posts = catalog.of("lamp_post")[:1] * len(lamps)
    lit_by = enumerate(zip(posts, lamps.tolist(), strict=False), 1)
    return (*trees, *(lamp_piece(f"{plan.id}/lamp_{k}", plan.id, *row) for k, row in lit_by))


def _floor(plan: SitePlan) -> shapely.Polygon:
    """The site, shrunk by what trees keep from its border."""
    return shapely.Polygon(plan.outline, plan.holes).buffer(-FROM_BORDER)


def _take_ground(
    plan: SitePlan, works: GroundWorks, buildings: Sequence[Piece], ways: NDArray[np.object_]
) -> TakenGround:
    boxes = [(p.pose.x, p.pose.y, p.pose.heading, p.size.width, p.size.depth) for p in buildings]
    areas = [shapely.Polygon(a.outline, a.holes) for way in plan.roads for a in way.areas]
    set_apart = [shapely.Polygon(a.outline) for a in works.areas if a.kind not in GREEN]
    areas += [shapely.Polygon(outline) for outline in plan.waters]
    return TakenGround(
        shapely.STRtree(shapely.polygons(corners(np.array(boxes).reshape(-1, 5)))),
        shapely.STRtree(areas),
        shapely.STRtree([*ways, *set_apart]),
        shapely.STRtree([]),
        *keep_sight(plan),
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


def _clear(points: Floats, taken: TakenGround) -> Floats:
    """The points that keep their distances."""
    for tree, distance in (
        (taken.buildings, FROM_BUILDINGS),
        (taken.ways, FROM_WAYS),
        (taken.walks, FROM_WALKS),
    ):
        points = drop_near(points, tree, distance)
    return points


def _groves(
    plan: SitePlan,
    floor: shapely.Polygon,
    taken: TakenGround,
    rows: Floats,
    rng: np.random.Generator,
) -> Floats:
    """Points of a shaken grid where a slow wave is high: groves, and lawns between them."""
    low, high = plan.outline.min(0), plan.outline.max(0)
    step = max(GROVE, math.sqrt(0.5 * plan.area / TREES))
    points = shake_grid(low, high, step, rng)
    points = points[_waves(points, 38.0, rng) > 0.1]
    points = _clear(points[shapely.contains_xy(floor, points[:, 0], points[:, 1])], taken)
    if len(rows) and len(points):
        points = drop_near(points, shapely.STRtree(shapely.points(rows)), 0.7 * AVENUE)
    return points[rng.permutation(len(points))]


def _waves(points: Floats, long: float, rng: np.random.Generator) -> Floats:
    """A smooth random field, about -1 to 1, that changes over ``long`` metres."""
    angle, shift = rng.uniform(0, 2 * math.pi, (2, 5))
    ways = np.stack([np.cos(angle), np.sin(angle)]) * 2 * math.pi / long
    return np.asarray(np.cos(points @ (ways * np.linspace(0.6, 1.5, 5)) + shift).sum(1) / 2.0)


def _lamps(plan: SitePlan, roads: Sequence[BuiltRoad], taken: TakenGround) -> Floats:
    """Places (n, 3) of lamps on the pavements, their arms over the road."""
    paved = [road for road in roads if kerb(road.width)]
    sides = list_lamp_places(paved, taken)
    started = [at[round(LAMPS / (2 * TRIED)) :] if k % 2 else at for k, at in enumerate(sides)]
    spots = np.concatenate([np.zeros((0, 3)), *(keep_apart(at, LAMPS) for at in started)])
    floor = shapely.Polygon(plan.outline, plan.holes)
    return spots[shapely.contains_xy(floor, spots[:, 0], spots[:, 1])][:TREES]
