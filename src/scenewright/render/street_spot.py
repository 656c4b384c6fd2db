"""Where to stand for a picture of a street: ways first, else open ground; and where to look.

Spots are ranked by what a walker sees there (:mod:`scenewright.geometry.walker_meshes`); of the
best, coarse trial pictures against everything that stands decide: facades in view, some sky,
nothing close before the eye.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog
from scenewright.core.heights import HeightGrid, heights_at
from scenewright.core.layout import corners
from scenewright.core.scene import Piece
from scenewright.geometry import rays
from scenewright.geometry.box_grid import box_grid
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.walker import Sights, sights_of_boxes
from scenewright.geometry.walker_meshes import best_spots
from scenewright.ground.plan import SitePlan, Way
from scenewright.ground.ways.surfaces import kerb
from scenewright.render.building_quality import collect_building_quality
from scenewright.render.picture import Camera, view_of
from scenewright.render.stage import PartTriangles

ANGLE = float(np.deg2rad(75.0))
"""How wide a street picture is."""
TALL, HORIZON = 0.625, 0.62
"""Height by width, and how far down the horizon lies: verticals stay upright, as through a lens
shifted up."""
PACE, EYES, TRIED = 6.0, 500, 60
"""Metres between points on the ways, most points looked from, and points tried in pictures."""
FREE = 2.6
"""Metres kept from trunks, masts and walls."""
NEAR, FAR, CLOSE = 25.0, 250.0, 6.0
"""Buildings are best seen from more than the first and not much more than the second, in metres;
nothing should stand nearer than the last."""
FEW, RAYS = 12, 128
COLUMNS, ROWS = 60, 38
GROUND, BUILDING, GREEN, SKY = range(4)

Floats = NDArray[np.float64]


class Standpoint(NamedTuple):
    """The eye ``(3,)`` and the level direction ``(2,)`` it looks in."""

    eye: Floats
    way: Floats


class Stands(NamedTuple):
    """All that stands: rays against it, what each triangle is and the number of its part; and
    where trunks and masts ``(n, 2)`` are."""

    caster: rays.Caster
    kinds: NDArray[np.int64]
    parts: NDArray[np.int64]
    stems: Floats


def standpoint(
    plans: Sequence[SitePlan],
    pieces: Sequence[Piece],
    blocks: Sequence[PartTriangles],
    catalog: Catalog,
    ground: HeightGrid | None = None,
) -> Standpoint:
    """The best place for a picture of a scene, and where to look; ``ground`` are the heights of
    its ground (none: 0)."""
    buildings = [piece for piece in pieces if piece.category == "building"]
    eyes = _eyes(plans, pieces)
    found = best_spots(_measure_sights(buildings, eyes, catalog), ANGLE)[:TRIED]
    tried = [Standpoint(s.point, s.way[:2] / np.hypot(*s.way[:2])) for s in found]
    along = np.concatenate(
        [np.zeros((0, 4)), *(_space_points(w, 0.0) for p in plans for w in p.roads)]
    )
    for eye, _ in list(tried) if len(along) else ():
        ahead = along[np.argmin(np.hypot(*(along[:, :2] - eye[:2]).T)), 2:]
        tried += [Standpoint(eye, ahead), Standpoint(eye, -ahead)]
    stands = _stands(pieces, blocks)
    tried = [_raise(spot, ground) for spot in tried] if ground else tried
    return max(tried, key=lambda spot: _worth(stands, spot))


def _raise(spot: Standpoint, ground: HeightGrid) -> Standpoint:
    high = float(heights_at(ground, spot.eye[None, :2])[0])
    return spot._replace(eye=spot.eye + np.array([0.0, 0.0, high]))


def _stands(pieces: Sequence[Piece], blocks: Sequence[PartTriangles]) -> Stands:
    counts = [len(b.faces) for b in blocks]
    stems = [p.pose[:2] for p in pieces if p.category != "building"]
    return Stands(
        rays.build(*merge([Mesh(b.vertices, b.faces) for b in blocks])[:2]),
        np.repeat([_kind(b.category) for b in blocks], counts),
        np.repeat(np.arange(len(blocks)), counts),
        np.array(stems).reshape(-1, 2),
    )


def camera_of(spot: Standpoint) -> Camera:
    """A level camera at a standpoint."""
    target = spot.eye + np.array([*spot.way, 0.0])
    (x, y, z), (u, v, w) = spot.eye.tolist(), target.tolist()
    return Camera((x, y, z), (u, v, w), ANGLE)


def _measure_sights(buildings: Sequence[Piece], eyes: Floats, catalog: Catalog) -> Sights:
    """What is seen of the buildings from all eyes, by what their models show on each side."""
    boxes, heights, sides = collect_building_quality(buildings, catalog)
    return sights_of_boxes(box_grid(boxes, heights), sides, eyes, 1.0, RAYS)


def _eyes(plans: Sequence[SitePlan], pieces: Sequence[Piece]) -> Floats:
    """Points on the ways, on open ground if there are few, that keep clear of all that stands."""
    off = [
        (way, side * max(way.width / 2 - max(kerb(way.width), 1.0) / 2, 0.0))
        for plan in plans
        for way in plan.roads
        for side in (0, 1, -1)
    ]
    points = np.concatenate([np.zeros((0, 2)), *(_space_points(way, by)[:, :2] for way, by in off)])
    points = _free(points, pieces)
    if len(points) < FEW:
        points = np.concatenate([points, *(_free(_open(plan), pieces) for plan in plans)])
    if not len(points):
        points = np.concatenate([plan.outline for plan in plans])
    return points[np.unique(np.linspace(0, len(points) - 1, EYES).astype(int))]


def _space_points(way: Way, off: float) -> Floats:
    """Points of a way ``(n, 4)`` every few metres, ``off`` to its left, and its direction."""
    rows = [np.zeros((0, 4))]
    for line in way.inside:
        step = np.diff(line, axis=0)
        length = np.hypot(*step.T)
        along = np.concatenate([[0.0], np.cumsum(length)])
        at = np.arange(PACE / 2, along[-1], max(PACE, along[-1] / EYES))
        k = np.clip(np.searchsorted(along, at, side="right") - 1, 0, len(length) - 1)
        ways = step[k] / length[k, None]
        points = line[k] + ways * (at - along[k])[:, None]
        rows.append(np.column_stack([points + off * ways[:, ::-1] * [-1, 1], ways]))
    return np.concatenate(rows)


def _open(plan: SitePlan) -> Floats:
    """A grid of points on the ground of a site."""
    low, high = plan.outline.min(0), plan.outline.max(0)
    step = max(PACE, float(np.sqrt(plan.area / EYES)))
    grid = np.stack(
        np.meshgrid(*(np.arange(a + step / 2, b, step) for a, b in zip(low, high, strict=True)))
    )
    points = grid.reshape(2, -1).T
    floor = shapely.Polygon(plan.outline, plan.holes)
    return np.asarray(points[shapely.contains_xy(floor, points[:, 0], points[:, 1])])


def _free(points: Floats, pieces: Sequence[Piece]) -> Floats:
    """The points not within reach of anything that stands."""
    thin = [p for p in pieces if p.category != "building"]
    boxes = [
        (*p.pose[:2], p.pose.heading, p.size.width, p.size.depth)
        for p in pieces
        if p.category == "building"
    ]
    stems = shapely.points([p.pose[:2] for p in thin]) if thin else []
    shapes = [*shapely.polygons(corners(np.array(boxes).reshape(-1, 5))), *stems]
    if not shapes or not len(points):
        return points
    near = shapely.STRtree(shapes).query(
        shapely.points(points), predicate="dwithin", distance=FREE
    )[0]
    return np.delete(points, np.unique(near), axis=0)


def _kind(category: str) -> int:
    """What a thing is in a trial picture."""
    if category in ("space", "slab", "surface", ""):
        return GROUND
    return BUILDING if category == "building" else GREEN


def _worth(stands: Stands, spot: Standpoint) -> float:
    """How good a trial picture is: buildings at a good distance in all its thirds, rich in
    detail; less where there is little or much sky, much green, or anything close."""
    view = view_of(camera_of(spot), COLUMNS, ROWS)
    x, y = np.meshgrid(
        (np.arange(COLUMNS) + 0.5) / COLUMNS * 2 - 1,
        (HORIZON - (np.arange(ROWS) + 0.5) / ROWS) * 2 * TALL,
    )
    local = np.stack([x * view.across, y * view.across, np.ones_like(x)], -1).reshape(-1, 3)
    ways = (local @ view.axes.astype(float)) / np.linalg.norm(local, axis=1, keepdims=True)
    away, face, _ = rays.hits(stands.caster, np.broadcast_to(spot.eye, ways.shape), ways)
    met = np.where(face >= 0, stands.kinds[face], SKY)
    built = (met == BUILDING) * np.minimum(away / NEAR, 1.0) ** 2 * np.exp(-away / FAR)
    sky, leaves = float((met == SKY).mean()), float((met == GREEN).mean())
    close = float(((met != GROUND) & (met != SKY) & (away < CLOSE)).mean())
    thirds = built.reshape(ROWS, 3, -1).mean((0, 2))
    spread = float(np.sqrt(np.maximum(thirds, 0.0)).sum() ** 2)
    parts = np.where(met == BUILDING, stands.parts[face], -1).reshape(ROWS, COLUMNS)
    return (
        spread
        * (0.1 + _detail(parts))
        * _clear_of(stands.stems, spot)
        * np.exp(-((max(0.2 - sky, sky - 0.5, 0.0) / 0.12) ** 2))
        * np.exp(-((max(leaves - 0.2, 0.0) / 0.08) ** 2))
        * np.exp(-12.0 * close)
    )


def _detail(parts: NDArray[np.int64]) -> float:
    """Share of neighbours on buildings ``(rows, columns)`` that belong to different parts."""
    wide = (parts[:, 1:] >= 0) & (parts[:, :-1] >= 0)
    high = (parts[1:] >= 0) & (parts[:-1] >= 0)
    differ = (wide & (parts[:, 1:] != parts[:, :-1])).sum() + (
        high & (parts[1:] != parts[:-1])
    ).sum()
    return float(differ / max(wide.sum() + high.sum(), 1))


def _clear_of(stems: Floats, spot: Standpoint) -> float:
    """1, less for trunks and masts close by and ahead."""
    step = stems - spot.eye[:2]
    away = np.hypot(*step.T)
    aside = np.arccos(np.clip(step @ spot.way / np.maximum(away, 1e-9), -1.0, 1.0))
    shown = aside < 0.6 * ANGLE
    ahead = shown & (aside < 0.33 * ANGLE)
    return float(0.3 ** (shown & (away < 7.0)).sum() * 0.4 ** (ahead & (away < 16.0)).sum())
