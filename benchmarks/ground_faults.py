"""What a passer-by would call a fault between houses: roofs that crash, walls that lead nowhere.

Measured on what is drawn, and not on what placed it: roofs are the outlines of the meshes seen from
above, walls and hedges the surfaces of the scene.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import shapely

from benchmarks.ground_measures import Ground
from scenewright.catalog.loading import catalog_of
from scenewright.core.catalog import asset_of, footprint_of
from scenewright.core.scene import GroundSurface, Piece, Size
from scenewright.render.piece_meshes import mesh_asset, mesh_outline

Floats = Any
MEET, TOUCH, ASKEW = 1.0, 0.05, np.radians(3.0)
"""Metres between roofs that nobody passes through, within which they touch, and the angle from
which they are askew to each other."""
WALLS = ("hedge", "fence", "stone_wall", "white_wall")
END, SQUARE, HELD, GATE = 1.0, 0.85, 0.6, 2.0
"""Metres of the longest edge that is the end of a wall, sine of its corners, metres within which it
is held by a house or another wall, and by a gate: a walk, a square or a way."""
BEFORE, WIDE = 1.5, 1.2
"""Metres before a door, and across it, that no wall may stand in."""
GARDEN, THIN, HOUSE = 20.0, 0.4, 2.0
"""Square metres of the least garden, metres of the widest gap that is none, and of the wall of a
house that may have a door to a garden."""


def fault_counts(
    ground: Ground, others: Sequence[Piece], surfaces: Sequence[GroundSurface]
) -> dict[str, tuple[float, float]]:
    """Every fault as how many of how many; ``others`` are houses that stood before."""
    walls = shapely.union_all(
        [shapely.Polygon(*a).buffer(0) for s in surfaces if s.kind in WALLS for a in s.areas]
    )
    return {
        "roofs that meet askew": count_askew(ground.houses, others),
        "walls before a door": _before_doors(ground, walls),
        "wall ends held by nothing": _loose_ends(ground, others, walls),
        "gardens without a gate": _shut_gardens(ground, others, walls),
    }


def count_askew(houses: Sequence[Piece], others: Sequence[Piece]) -> tuple[float, float]:
    """Houses whose roof meets that of another that is not parallel or at right angles to it, or
    touches it by a corner alone."""
    every = [*houses, *others]
    roofs = np.array([roof_outline(one) for one in every], object)
    if not len(houses):
        return 0.0, 0.0
    turns = np.array([_direction(one) for one in roofs])
    one, other = shapely.STRtree(roofs).query(
        roofs[: len(houses)], predicate="dwithin", distance=MEET
    )
    apart = np.abs((turns[one] - turns[other] + np.pi / 4) % (np.pi / 2) - np.pi / 4)
    wide = shapely.buffer(roofs, 2 * TOUCH, quad_segs=2)
    shared = shapely.length(shapely.intersection(shapely.boundary(roofs[one]), wide[other]))
    corner = (shapely.distance(roofs[one], roofs[other]) < TOUCH) & (shared < 1.0)
    crash = (one != other) & ((apart > ASKEW) | corner)
    return float(len(set(one[crash].tolist()))), float(len(houses))


def roof_outline(piece: Piece) -> shapely.Geometry:
    """What a house as drawn covers, seen from above."""
    asset, size = asset_of(piece, catalog_of(())), Size(*(round(v, 4) for v in piece.size))
    parts = mesh_asset(asset, size)
    if piece.footprint != footprint_of(asset, size):
        parts = mesh_outline(piece, size, asset, parts)
    corners = np.concatenate([part.vertices[part.faces] for part in parts])[..., :2]
    area = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    flat = shapely.union_all(shapely.polygons(corners[np.abs(area) > 1e-4]), grid_size=1e-3)
    turn = piece.pose.heading - np.pi / 2
    spin = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    at = np.array([piece.pose.x, piece.pose.y])
    return shapely.transform(flat, lambda points: points @ spin + at)


def _direction(shape: shapely.Geometry) -> float:
    """The direction of most of an outline, modulo a right angle."""
    step = np.diff(shapely.get_coordinates(shapely.boundary(shape)), axis=0)
    long = np.hypot(*step.T)
    return float(np.angle((long * np.exp(4j * np.arctan2(step[:, 1], step[:, 0]))).sum()) / 4)


def _before_doors(ground: Ground, walls: shapely.Geometry) -> tuple[float, float]:
    """Doors with a wall before them."""
    along = np.stack([-ground.ahead[:, 1], ground.ahead[:, 0]], 1)
    rows = ((-1, 0.05), (-1, BEFORE), (1, BEFORE), (1, 0.05))
    corners = [ground.doors + s * WIDE / 2 * along + d * ground.ahead for s, d in rows]
    courts = shapely.polygons(np.stack(corners, 1))
    return float((shapely.area(shapely.intersection(courts, walls)) > 0.01).sum()), float(
        len(courts)
    )


def _loose_ends(
    ground: Ground, others: Sequence[Piece], walls: shapely.Geometry
) -> tuple[float, float]:
    """Ends of walls that are on no house, no other wall and no gate."""
    houses = shapely.union_all([*ground.shapes, *(roof_outline(one) for one in others)])
    gates = shapely.union_all([ground.ways, ground.walks, *ground.squares])
    parts = [p for p in shapely.get_parts(walls) if p.geom_type == "Polygon"]
    loose, count = 0, 0
    for k, part in enumerate(parts):
        rest = shapely.union_all([houses, *parts[:k], *parts[k + 1 :]])
        for middle in _ends(part):
            count += 1
            held = middle.distance(rest) <= HELD or middle.distance(gates) <= GATE
            loose += not held
    return float(loose), float(count)


def _ends(wall: shapely.Polygon) -> Iterator[shapely.Point]:
    """The middles of the short edges of a wall between two convex corners."""
    ring = shapely.get_coordinates(shapely.orient_polygons(wall.simplify(0.02)).exterior)[:-1]
    step = np.roll(ring, -1, axis=0) - ring
    long = np.hypot(*step.T)
    before, after = np.roll(step, 1, axis=0), np.roll(step, -1, axis=0)
    left = (np.cross(before, step) > SQUARE * long * np.hypot(*before.T)) & (
        np.cross(step, after) > SQUARE * long * np.hypot(*after.T)
    )
    thin = (long <= END) & (np.hypot(*before.T) > long) & (np.hypot(*after.T) > long)
    for k in np.flatnonzero(left & thin).tolist():
        yield shapely.Point(ring[k] + step[k] / 2)


def _shut_gardens(
    ground: Ground, others: Sequence[Piece], walls: shapely.Geometry
) -> tuple[float, float]:
    """Gardens within walls that neither a way, a walk nor a house leads to."""
    plots = shapely.union_all(list(ground.plots.values()))
    houses = shapely.union_all([*ground.shapes, *(roof_outline(one) for one in others)])
    shut = shapely.buffer(shapely.union(walls, houses), THIN / 2, join_style="mitre")
    open_ = shapely.difference(shapely.union(plots.buffer(4.0), ground.ways), shut)
    parts = [p for p in shapely.get_parts(open_) if p.geom_type == "Polygon"]
    gardens = [p for p in parts if p.intersection(plots).area >= GARDEN]
    fronts = shapely.boundary(shapely.buffer(houses, THIN, join_style="mitre"))
    paths = shapely.union_all([ground.ways, ground.walks, *ground.squares])
    bare = [
        p
        for p in gardens
        if p.intersection(fronts).length < HOUSE and p.intersection(paths).area < 0.5
    ]
    return float(len(bare)), float(len(gardens))
