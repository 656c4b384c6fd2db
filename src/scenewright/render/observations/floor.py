"""The floor of a level where a camera may go: how far each place is from walls and pieces.

A raster of exact distances (:mod:`scenewright.geometry.distance_raster`) to walls, to doors as
they are drawn, half open, and to the boxes of all that stands or hangs below head height.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building import joinery, outlines
from scenewright.building.ceiling import heights, planes
from scenewright.building.door_uses import DoorUse, classify_doors
from scenewright.catalog.kinds import KINDS
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece, Scene
from scenewright.core.space import Opening, Space
from scenewright.geometry.distance_raster import DistanceRaster, clearance, walls_between

CELL, MOST_CELLS = 0.025, 1_000_000
"""Metres of a cell, and how many there are at most; larger floors have larger ones."""
CAP = 1.5
"""More clearance than this is not told apart, in metres."""
HEAD, STEP = 2.0, 0.1
"""What begins above the first or ends below the second is in no camera's way, in metres."""
OVER = 0.15
"""Free height over a camera, in metres."""

Floats = NDArray[np.float64]


class WalkableFloor(NamedTuple):
    """One level: its ``id`` and ``elevation``, the ``clear`` raster, the number of the room each
    cell is in (-1: none), the rooms, and the boxes (k, 5) that distances are to."""

    level: str
    elevation: float
    clear: DistanceRaster
    room: NDArray[np.int32]
    spaces: tuple[Space, ...]
    solids: Floats

    def centres(self, cells: NDArray[np.int64]) -> Floats:
        """Middles (k, 2) of cells by their number, in metres."""
        row, column = np.divmod(cells, self.room.shape[1])
        at = np.column_stack([column, row]) + 0.5
        return np.asarray(self.clear.cell * at + (self.clear.x0, self.clear.y0))


def walkable_floor(scene: Scene, level: str, eye: float) -> WalkableFloor:
    """The floor of a level for a camera ``eye`` metres above it."""
    spaces = tuple(space for space in scene.spaces if space.level == level)
    names = {space.id for space in spaces}
    doors = [o for o in scene.openings if o.level == level and o.kind != "window"]
    rings = [ring for space in spaces for ring in (space.outline, *space.holes)]
    edges = np.vstack([outlines.edges(ring) for ring in rings])
    gaps = _rows(_gap(door) for door in doors)
    stands = _rows(
        box for p in scene.pieces if p.space in names and _in_the_way(p) for box in boxes_of(p)
    )
    uses = classify_doors(scene.openings, scene.spaces)
    leaves = [_segments(door, uses.get(door.id, "inner")) for door in doors]
    solids = np.vstack([walls_between(edges, gaps), *leaves, stands])
    low, high = edges.reshape(-1, 2).min(0) - 0.5, edges.reshape(-1, 2).max(0) + 0.5
    cell = max(CELL, float(np.sqrt(np.prod(high - low) / MOST_CELLS)))
    bounds = np.concatenate([low, high])
    clear = clearance(edges, solids, gaps, stands, bounds, cell, CAP, 0.0)
    room = _rooms(clear, spaces, eye)
    elevation = next(one.elevation for one in scene.levels if one.id == level)
    return WalkableFloor(level, elevation, clear, room, spaces, solids)


def _in_the_way(piece: Piece) -> bool:
    """Whether a piece takes room between the floor and head height; rugs do not."""
    kind = KINDS.get(piece.category)
    flat = kind is not None and kind.flat and piece.size.height <= STEP
    return piece.pose.z < HEAD and piece.pose.z + piece.size.height > STEP / 2 and not flat


def _gap(door: Opening) -> list[float]:
    """The floor of a doorway as a box, a little into both rooms."""
    heading = float(np.arctan2(door.ux, -door.uy))
    return [door.x, door.y, heading, door.width, door.thickness + 0.1]


def _segments(door: Opening, use: DoorUse) -> Floats:
    """What a door is drawn as between the floor and head height, as boxes (k, 5) without depth
    along the edges of its triangles in plan."""
    corners = [np.zeros((0, 3, 3))]
    for part in joinery.parts(door, use):
        corners.append(joinery.to_plan_coordinates(door, part.vertices)[part.faces])
    found = np.concatenate(corners)
    found = found[(found[..., 2].min(1) < HEAD) & (found[..., 2].max(1) > STEP)][..., :2]
    ends = np.stack([found, np.roll(found, -1, axis=1)], 2).reshape(-1, 4)
    ends = np.unique(ends.round(4), axis=0)
    return walls_between(ends, np.zeros((0, 5)))


def _rooms(clear: DistanceRaster, spaces: Sequence[Space], eye: float) -> NDArray[np.int32]:
    """The room of each cell; cells where a ceiling is too low for a camera get no clearance."""
    rows, columns = clear.values.shape
    x, y = np.meshgrid(
        clear.x0 + (np.arange(columns) + 0.5) * clear.cell,
        clear.y0 + (np.arange(rows) + 0.5) * clear.cell,
    )
    room = np.full(clear.values.shape, -1, np.int32)
    for number, space in enumerate(spaces):
        floor = shapely.Polygon(space.outline, space.holes)
        inside = shapely.contains_xy(floor, x, y)
        room[inside] = number
        points = np.stack([x[inside], y[inside]], -1)
        low = heights(points, planes(space), space.height) < eye + OVER
        clear.values[inside] = np.where(low, 0.0, clear.values[inside])
    return room


def _rows(rows: Iterable[list[float]]) -> Floats:
    return np.array(list(rows), np.float64).reshape(-1, 5)
