"""From a solved site to its pieces: buildings, landmarks, roads and trees."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import shapely

from scenewright.catalog import Catalog
from scenewright.domains.site.wanted import Wanted
from scenewright.layout import corners
from scenewright.scene import Piece, Pose, Size
from scenewright.site_plan import SitePlan
from scenewright.site_problem import Flags, Floats

THICKNESS = 0.04
"""Of roads, in metres."""
TREES, TREE_GAP, TREE_CLEAR = 400, 7.0, 2.5
"""Most trees of a site, their distance and what they keep from buildings and roads, metres."""


def buildings(
    plan: SitePlan, rows: list[Wanted], boxes: Floats, present: Flags
) -> tuple[Piece, ...]:
    """One piece a building that found a place; ids count by model."""
    counts: dict[str, int] = {}
    found = []
    for row, box, there in zip(rows, boxes, present, strict=True):
        if not there:
            continue
        counts[row.asset.id] = counts.get(row.asset.id, 0) + 1
        x, y, heading = (float(v) for v in box[:3])
        found.append(
            Piece(
                id=f"{plan.id}/{row.asset.id}_{counts[row.asset.id]}", category="building",
                asset=row.asset.id, space=plan.id, pose=Pose(x, y, 0.0, wrapped(heading)),
                size=row.size, group=f"{plan.id}/buildings", function=row.name,
            )
        )  # fmt: skip
    return tuple(found)


def roads(plan: SitePlan, catalog: Catalog) -> tuple[Piece, ...]:
    """Roads and paths, one piece for each straight part inside the site."""
    asset = catalog.of("road")[0]
    found: list[Piece] = []
    for way in plan.roads:
        for line in way.inside:
            for (x0, y0), (x1, y1) in pairwise(line.tolist()):
                length = math.hypot(x1 - x0, y1 - y0)
                if length < 0.5:
                    continue
                found.append(
                    Piece(
                        id=f"{plan.id}/{way.id}_{len(found) + 1}", category="road",
                        asset=asset.id, space=plan.id,
                        pose=Pose((x0 + x1) / 2, (y0 + y1) / 2, 0.0,
                                  math.atan2(y1 - y0, x1 - x0)),
                        size=Size(way.width, length, THICKNESS), group=f"{plan.id}/roads",
                        function=way.kind, fixed=True,
                    )
                )  # fmt: skip
    return tuple(found)


def landmarks(plan: SitePlan, catalog: Catalog) -> tuple[Piece, ...]:
    """What stands already."""
    found = []
    for row in plan.landmarks:
        x, y, heading, width, depth = row.box
        size = Size(width, depth, row.height)
        known = row.model in catalog.assets
        chosen = catalog.assets[row.model] if known else catalog.choose("building", size)
        found.append(
            Piece(
                id=f"{plan.id}/{row.id}", category="building",
                asset=chosen.id if chosen else "", space=plan.id,
                pose=Pose(x, y, 0.0, wrapped(heading)), size=size,
                group=f"{plan.id}/landmarks", function="landmark", fixed=True,
            )
        )  # fmt: skip
    return tuple(found)


def trees(
    plan: SitePlan, solid: tuple[Piece, ...], catalog: Catalog, rng: np.random.Generator
) -> tuple[Piece, ...]:
    """Trees on the open ground, at most one in a square of :data:`TREE_GAP` metres."""
    assets = catalog.of("tree")
    if not assets:
        return ()
    at = _open_ground(plan, solid, rng)
    found = []
    for k, (x, y) in enumerate(at, 1):
        asset = assets[int(rng.integers(len(assets)))]
        scale = float(rng.uniform(0.8, 1.2))
        size = Size(*(side * scale for side in asset.usual))
        found.append(
            Piece(
                id=f"{plan.id}/tree_{k}", category="tree", asset=asset.id, space=plan.id,
                pose=Pose(float(x), float(y), 0.0, float(rng.uniform(-math.pi, math.pi))),
                size=size, group=f"{plan.id}/green", function="tree",
            )
        )  # fmt: skip
    return tuple(found)


def _open_ground(plan: SitePlan, solid: tuple[Piece, ...], rng: np.random.Generator) -> Floats:
    """Jittered grid points of the site that keep clear of roads and buildings."""
    low, high = plan.outline.min(0), plan.outline.max(0)
    step = max(TREE_GAP, math.sqrt(plan.area / TREES))
    grid = np.stack(np.meshgrid(*(np.arange(a, b, step) for a, b in zip(low, high, strict=True))))
    points = grid.reshape(2, -1).T + rng.uniform(-0.3, 0.3, (grid[0].size, 2)) * step
    floor = shapely.Polygon(plan.outline, plan.holes).buffer(-TREE_CLEAR)
    boxes = [(p.pose.x, p.pose.y, p.pose.heading, p.size.width, p.size.depth) for p in solid]
    taken = [shapely.Polygon(ring) for ring in corners(np.array(boxes).reshape(-1, 5))]
    taken += [shapely.Polygon(a.outline, a.holes) for way in plan.roads for a in way.areas]
    inside = shapely.contains_xy(floor, points[:, 0], points[:, 1])
    points = points[inside]
    if taken and len(points):
        tree = shapely.STRtree(taken)
        near = tree.query(shapely.points(points), predicate="dwithin", distance=TREE_CLEAR)[0]
        points = np.delete(points, np.unique(near), axis=0)
    return points[:TREES]


def wrapped(angle: float) -> float:
    """An angle in [-π, π)."""
    return (angle + math.pi) % (2 * math.pi) - math.pi
