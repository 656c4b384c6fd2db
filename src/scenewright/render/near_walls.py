"""Walls between the eye and a room, lowered in pictures from above at an angle.

A wall 2 m high hides the floor behind it as far as the view leans. What stands on the near side of
a room is therefore cut low: outer walls to a kerb, walls between two rooms to the height of a
sofa, so that pieces at their far side show.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from shapely import Geometry, Polygon
from shapely.affinity import translate

from scenewright.building.masonry import polygons
from scenewright.building.shafts import is_shaft
from scenewright.core.scene import Piece, Prism, Scene
from scenewright.core.space import Opening, Space

KERB, RAIL = 0.3, 0.9
"""Heights above the floor to which near walls are cut, metres: outer ones, those between rooms."""
THICK = 0.6
"""A wall is as thick as this at most, metres."""
COLUMN = 1.2
"""Greatest length of a column, metres: longer masonry inside a room is a wall."""
LEFT = 0.6
"""Of a piece on a lowered wall at least this share stands below its top, or none is drawn: of
curtains only their hems would show."""
HANGING = 0.1
"""Half of this behind what hangs on a wall is the wall, metres."""
ENCLOSED = frozenset(("shower", "wall_shower"))
"""What stands on the floor but is held by the walls behind and beside it: screens, rails, heads."""
BESIDE = 0.05
"""So far beyond its ends an opening's wall is asked for its height, metres."""


class NearWalls(NamedTuple):
    """Where walls are lowered, in plan, each with the height above the floor."""

    parts: tuple[tuple[Geometry, float], ...] = ()

    def top_at(self, x: float, y: float, cut: float) -> float:
        """The height to which things at a point are cut.

        >>> NearWalls(((shapely.box(0, 0, 1, 1), 0.3),)).top_at(0.5, 0.5, 2.0)
        0.3
        """
        at = shapely.Point(x, y)
        return min([cut, *(top for region, top in self.parts if region.covers(at))])


def find_near_walls(scene: Scene, level: str, towards: tuple[float, float, float]) -> NearWalls:
    """The strips before the rooms of a level, seen by an eye that looks ``towards``.

    A strip is what a room sweeps when it is moved towards the eye by the thickness of a wall, less
    all rooms; where another room lies before it the wall is one between rooms. Sides of a room that
    run along the view are left alone, and so are columns. Shafts are no rooms but part of the wall.
    """
    here = [space for space in scene.spaces if space.level == level]
    rooms = [_floor(space) for space in here if not is_shaft(space)]
    if not rooms:
        return NearWalls()
    away = -np.array(towards[:2]) / max(float(np.hypot(*towards[:2])), 1e-9)
    across = "y" if abs(away[1]) >= abs(away[0]) else "x"
    step = (
        (0.0, float(np.sign(away[1])) * THICK)
        if across == "y"
        else (float(np.sign(away[0])) * THICK, 0.0)
    )
    floors = shapely.union_all(rooms)
    near = _solid(shapely.union_all([_sweep(room, step) for room in rooms]).difference(floors))
    before = shapely.union_all([_sweep(room, (-step[0], -step[1])) for room in rooms])
    shafts = _find_near_shafts([_floor(space) for space in here if is_shaft(space)], near)
    inner = _solid(near.intersection(before).union(shafts.difference(floors)))
    return NearWalls(((_solid(near.difference(inner)), KERB), (inner, RAIL)))


def _find_near_shafts(shafts: Sequence[Polygon], near: Geometry) -> Geometry:
    """Those shafts, with their walls, that stand before a room."""
    found = [shaft for shaft in shafts if shaft.intersection(near).area > 0.1 * shaft.area]
    return shapely.union_all([shaft.buffer(THICK / 2, join_style="mitre") for shaft in found])


def _solid(shape: Geometry) -> Geometry:
    """The parts of a shape that have an area, to the millimetre."""
    return shapely.set_precision(shapely.union_all(polygons(shape)), 1e-3)


def _floor(space: Space) -> Polygon:
    """The floor of a room and its columns, which hide little and are not lowered."""
    walls = [hole for hole in space.holes if np.ptp(np.asarray(hole), axis=0).max() > COLUMN]
    return Polygon(space.outline, walls).buffer(0)


def _sweep(room: Geometry, step: tuple[float, float]) -> Geometry:
    """All places of a room moved by up to a step: the hulls that each edge sweeps."""
    moved = translate(room, *step)
    edges = []
    for part in polygons(room):
        ring = np.asarray(part.exterior.coords)
        for a, b in pairwise(ring):
            edges.append(Polygon([a, b, b + step, a + step]).buffer(0))
    return shapely.union_all([room, moved, *edges])


def split_prism(solid: Prism, near: NearWalls, cut: float) -> list[tuple[Prism, float]]:
    """A prism of a wall in parts, each with the height it is cut at."""
    rest = _solid(Polygon(solid.outline, solid.holes).buffer(0))
    found: list[tuple[Prism, float]] = []
    for region, top in near.parts:
        low = _solid(rest.intersection(region))
        if top >= cut or low.area < 1e-4:
            continue
        found += [(part, top) for part in _prisms(low, solid)]
        rest = _solid(rest.difference(region))
    return [(solid, cut)] if not found else [*found, *((p, cut) for p in _prisms(rest, solid))]


def _prisms(shape: Geometry, like: Prism) -> list[Prism]:
    ordered = [shapely.orient_polygons(part) for part in polygons(shape) if part.area > 1e-4]
    return [
        Prism(
            np.asarray(part.exterior.coords)[:-1],
            like.base,
            like.top,
            tuple(np.asarray(ring.coords)[:-1] for ring in part.interiors),
            like.tilt,
        )
        for part in ordered
    ]


def cut_of_opening(opening: Opening, near: NearWalls, cut: float) -> float:
    """The height at which an opening is cut: that of its wall, beside it too."""
    reach = opening.width / 2 + BESIDE
    ends = [
        near.top_at(opening.x + k * reach * opening.ux, opening.y + k * reach * opening.uy, cut)
        for k in (-1, 1)
    ]
    return min(near.top_at(opening.x, opening.y, cut), max(ends))


def cut_of_enclosure(piece: Piece, near: NearWalls, cut: float) -> float:
    """The height at which a shower is cut: that of the lowest wall behind or beside it."""
    x, y, _, heading = piece.pose
    cos, sin = float(np.cos(heading)), float(np.sin(heading))
    back = -(piece.size.depth + HANGING) / 2
    side = (piece.size.width + HANGING) / 2
    spots = ((0.0, back), (side, 0.0), (-side, 0.0))
    return min(near.top_at(x + a * sin + b * cos, y - a * cos + b * sin, cut) for a, b in spots)


def find_lid_height(space: Space, near: NearWalls, cut: float) -> float:
    """How high a shaft is closed: at the top of the walls round it."""
    inside = Polygon(space.outline, space.holes).representative_point()
    return near.top_at(inside.x, inside.y, cut)


def cut_of_piece(piece: Piece, near: NearWalls, cut: float) -> float:
    """The height at which a piece that hangs on a wall is cut: that of the wall behind it, and
    its foot, so that nothing of it is drawn, where that leaves less than :data:`LEFT` of it."""
    x, y, foot, heading = piece.pose
    back = piece.size.depth / 2 + HANGING / 2
    top = near.top_at(x - back * np.cos(heading), y - back * np.sin(heading), cut)
    return top if top - foot >= LEFT * piece.size.height else foot
