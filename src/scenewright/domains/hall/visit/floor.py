"""The floor a visitor walks on: doors, obstacles, and walking speed by place."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building import outlines
from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece
from scenewright.core.space import Opening, Points, Space
from scenewright.domains.hall.measures import HEAD_HEIGHT
from scenewright.geometry.distance_raster import DistanceRaster, clearance, walls_between

Floats = NDArray[np.float64]

CELL, MOST_CELLS = 0.1, 400_000
AT_EASE = 1.2
"""Clearance to both sides from which on more makes nobody walk faster, in metres."""
PRESSED = 0.5
"""Speed at the least width asked for, as a share of the full speed of 1 m/s."""
BRUSHING = 6.0
"""Seconds a metre through a cell that is less than half a cell too narrow."""
NARROW = 1e6
"""Seconds a metre where it is narrower than asked for: any other way is quicker."""
LEAST_PASSED = 0.15
"""Nobody passes with less clearance to both sides, in metres."""


class WalkingFloor(NamedTuple):
    """``clear``: the clearance of every cell, at most :data:`AT_EASE`; ``slow`` (rows, columns)
    seconds a metre; ``solids`` (k, 5) boxes of all walls and obstacles."""

    clear: DistanceRaster
    slow: Floats
    solids: Floats


def find_floor(
    space: Space, pieces: tuple[Piece, ...], catalog: Catalog, width: float
) -> WalkingFloor:
    """The floor of a hall for a visitor who would like ways of ``width`` metres.

    Speed rises from half at the least width to 1 m/s where 1.2 m are free to both sides.
    Narrower places are so slow that only those with no other way go there.
    """
    doors = [o for o in space.openings if o.kind != "window"]
    edges = np.vstack([outlines.edges(ring) for ring in (space.outline, *space.holes)])
    gaps = _rows([_across(o, o.width, o.thickness + 0.1) for o in doors])
    walls = np.vstack([walls_between(edges, gaps), _rows([j for o in doors for j in _jambs(o)])])
    stands = _rows(
        [b for p in pieces if p.space == space.id and _in_the_way(p, catalog) for b in boxes_of(p)]
    )
    low, high = _reach(space.outline, gaps)
    cell = max(CELL, float(np.sqrt(np.prod(high - low) / MOST_CELLS)))
    strips = _rows(
        [_across(o, max(o.width - width, 2.1 * cell), o.thickness + width) for o in doors]
    )
    clear = clearance(
        edges, walls, strips, stands, np.concatenate([low, high]), cell, AT_EASE, width / 2
    )
    return WalkingFloor(clear, _slowness(clear, width / 2), np.vstack([walls, stands]))


def _slowness(clear: DistanceRaster, half: float) -> Floats:
    """Seconds a metre; half a cell is let pass, since a way seldom runs along cell centres.

    Nobody passes where cells are too coarse to tell whether a wall is between them.
    """
    free = clear.values
    ease = np.clip((free - half) / max(AT_EASE - half, 0.1), 0.0, 1.0)
    slow = 1.0 / (PRESSED + (1.0 - PRESSED) * ease)
    slow[free < half] = BRUSHING
    tight = free < half - clear.cell / 2
    slow[tight] = NARROW * half / np.maximum(free[tight], LEAST_PASSED)
    slow[free < max(LEAST_PASSED, 0.75 * clear.cell)] = np.inf
    return slow


def _in_the_way(piece: Piece, catalog: Catalog) -> bool:
    kind = catalog.kinds.get(piece.category)
    above = piece.on is not None or piece.pose.z >= HEAD_HEIGHT
    passed = kind is not None and (kind.flat or kind.swings or kind.support == "ceiling")
    return not above and not passed


def _across(door: Opening, width: float, depth: float) -> list[float]:
    """A box in a door: ``width`` along the wall, ``depth`` across it."""
    return [door.x, door.y, float(np.arctan2(door.ux, -door.uy)), width, depth]


def _jambs(door: Opening) -> list[list[float]]:
    heading = float(np.arctan2(door.ux, -door.uy))
    return [
        [door.x + side * door.ux, door.y + side * door.uy, heading, 0.0, door.thickness]
        for side in (-door.width / 2, door.width / 2)
    ]


def _reach(outline: Points, gaps: Floats) -> tuple[Floats, Floats]:
    """Corners of the box round an outline and the doors in it."""
    far = np.abs(gaps[:, 3:4]) / 2 + gaps[:, 4:5]
    points = np.vstack([outline, gaps[:, :2] - far, gaps[:, :2] + far])
    return points.min(axis=0), points.max(axis=0)


def _rows(rows: list[list[float]]) -> Floats:
    return np.array(rows, np.float64).reshape(-1, 5)
