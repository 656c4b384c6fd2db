"""Cameras of a document: one in every room at eye height, one on the whole, one straight down."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Scene
from scenewright.core.space import Space
from scenewright.formats.gltf.lights import turn_of
from scenewright.formats.gltf.tree import Tree

EYE = 1.5
"""Height of the eye in metres."""
WIDE = float(np.deg2rad(50.0))
"""Angle of a room's picture from its lower to its upper edge: a lens of 24 mm at 16:10."""
NARROW = float(np.deg2rad(28.0))
"""The same of the picture of the whole."""
ASPECT = 1.6
STEEP, ASIDE = float(np.deg2rad(48.0)), float(np.deg2rad(18.0))
"""How steeply the whole is looked down on, and how far from the south, to the east."""
CLEAR = 0.3
"""Metres that an eye keeps off walls and furniture."""
STEP = 0.25
"""Distance in metres of places where an eye is tried."""
OPEN = frozenset(("site", "village", "extend"))
Floats = NDArray[np.float64]
Json = dict[str, Any]


def add_cameras(tree: Tree, scene: Scene) -> list[Json]:
    """The cameras, with a node each: below its level in a room, else below the root."""
    below = tree.nodes[0].get("children", [])[: len(scene.levels)]
    levels = {level.id: number for level, number in zip(scene.levels, below, strict=True)}
    cameras: list[Json] = []
    for space in scene.spaces:
        stand = None if OPEN & set(space.functions) else stand_in(space, scene.pieces)
        if stand is not None:
            x, y, yaw = stand
            eye = {"translation": [x, EYE, -y], "rotation": turn_of(yaw, 0.0)}
            lens = {"yfov": round(WIDE, 5), "aspectRatio": ASPECT, "znear": 0.05, "zfar": 100.0}
            _add(tree, cameras, levels[space.level], f"camera {space.id}", eye, perspective=lens)
    low, high = _bounds(scene)
    _add_whole(tree, cameras, low, high)
    _add_plan(tree, cameras, low, high)
    return cameras


def stand_in(space: Space, pieces: tuple[Piece, ...]) -> tuple[float, float, float] | None:
    """Where an eye stands in a room and the way it looks (radians about glTF's y): the free place
    that is farthest from the middle of the furniture and sees it, None where there is none."""
    room = shapely.Polygon(space.outline, space.holes)
    mine = [p for p in pieces if p.space == space.id]
    boxes = [_box_of(p) for p in mine if p.pose.z < EYE + 0.3 and p.pose.z + p.size.height > 0.4]
    free = room.buffer(-CLEAR).difference(shapely.union_all(boxes).buffer(CLEAR))
    places = _grid_in(free)
    if not len(places):
        return None
    middle = np.array(room.representative_point().coords[0])
    if mine:
        middle = np.mean([(p.pose.x, p.pose.y) for p in mine], axis=0)
    tall = shapely.union_all([_box_of(p) for p in mine if p.pose.z + p.size.height > EYE])
    lines = shapely.linestrings(np.stack([places, np.broadcast_to(middle, places.shape)], 1))
    away = np.linalg.norm(places - middle, axis=1)
    hidden = shapely.length(shapely.intersection(lines, tall))
    hidden += shapely.length(shapely.difference(lines, room))
    best = int(np.argmax(away - 3.0 * hidden))
    way = middle - places[best]
    yaw = float(np.arctan2(-way[0], way[1]))
    return float(places[best, 0]), float(places[best, 1]), yaw


def _add_whole(tree: Tree, cameras: list[Json], low: Floats, high: Floats) -> None:
    """From the south and above, as near as all corners of the whole are seen: a corner that is r
    to the right, u up and f ahead of the middle is inside for an eye at |r| / (a t) - f and
    |u| / t - f behind it, t the tangent of half the angle and a the aspect."""
    level, tangent = np.cos(STEEP), np.tan(NARROW / 2)
    back = np.array([level * np.sin(ASIDE), -level * np.cos(ASIDE), np.sin(STEEP)])
    right = np.array([np.cos(ASIDE), np.sin(ASIDE), 0.0])
    middle = (low + high) / 2
    ends = np.stack(np.meshgrid(*np.stack([low, high], -1)), -1).reshape(-1, 3) - middle
    seen = np.abs(ends @ np.stack([right / ASPECT, np.cross(back, right)], -1)).max(1) / tangent
    away = 1.08 * float((seen + ends @ back).max())
    x, y, z = middle + away * back
    eye = {"translation": [float(x), float(z), float(-y)], "rotation": turn_of(ASIDE, -STEEP)}
    reach = float(np.linalg.norm(high - low))
    near = round(max(away - reach, 0.05 * away), 3)
    lens = {"yfov": round(NARROW, 5), "aspectRatio": ASPECT, "znear": near, "zfar": away + reach}
    _add(tree, cameras, 0, "camera dollhouse", eye, perspective=lens)


def _add_plan(tree: Tree, cameras: list[Json], low: Floats, high: Floats) -> None:
    """Straight down, north up."""
    x, y, _ = (low + high) / 2
    wide, deep, tall = high - low
    half = 0.52 * max(float(deep), float(wide) / ASPECT)
    eye = {"translation": [float(x), float(high[2]) + 1.0, float(-y)]}
    lens = {"xmag": half * ASPECT, "ymag": half, "znear": 0.01, "zfar": float(tall) + 2.0}
    turned = eye | {"rotation": turn_of(0.0, -np.pi / 2)}
    _add(tree, cameras, 0, "camera plan", turned, orthographic=lens)


def _add(
    tree: Tree, cameras: list[Json], parent: int, name: str, place: Json, **lens: Json
) -> None:
    (kind,) = lens
    cameras.append({"type": kind, "name": name} | lens)
    node = {"name": tree.free(name), "camera": len(cameras) - 1, "extras": {"category": "camera"}}
    tree.add(parent, node | place)


def _bounds(scene: Scene) -> tuple[Floats, Floats]:
    """The lower and upper corner of all rooms and pieces."""
    rise = {level.id: level.elevation for level in scene.levels}
    points = [np.zeros((1, 3))] if not scene.spaces else []
    for space in scene.spaces:
        tall = 0.0 if OPEN & set(space.functions) else space.height
        for height in (0.0, tall):
            base = np.full(len(space.outline), rise[space.level] + height)
            points.append(np.column_stack([space.outline, base]))
    tops = [(p.pose.x, p.pose.y, p.pose.z + p.size.height) for p in scene.pieces]
    found = np.vstack([*points, np.array(tops).reshape(-1, 3)])
    return found.min(0), found.max(0)


def _box_of(piece: Piece) -> shapely.Polygon:
    x, y, _, heading = piece.pose
    return shapely.Polygon(corners(np.array([x, y, heading, piece.size.width, piece.size.depth])))


def _grid_in(shape: shapely.Geometry) -> Floats:
    """Places of a grid in a shape ``(n, 2)``."""
    if shape.is_empty:
        return np.zeros((0, 2))
    x0, y0, x1, y1 = shape.bounds
    xs, ys = np.arange(x0, x1 + 1e-9, STEP), np.arange(y0, y1 + 1e-9, STEP)
    grid = np.stack(np.meshgrid(xs, ys), -1).reshape(-1, 2)
    return grid[shapely.intersects_xy(shape, grid[:, 0], grid[:, 1])]
