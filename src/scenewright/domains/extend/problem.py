"""The problem of continuing sources into one area, and its answer."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.domains.extend.pattern import SourcePattern
from scenewright.domains.extend.settings import GrowthSettings
from scenewright.engine.solve import Found
from scenewright.ground.buildings.built import BuiltRoad, from_frames

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


class StandingGround(NamedTuple):
    """What stands about an area before it is filled: ``boxes`` (n, 5), polygons (n,), the number
    of the building of the sources that each is or is like (n,), and whether it is in the area and
    counts (n,)."""

    boxes: Floats
    shapes: NDArray[np.object_]
    origin: Indices
    inside: NDArray[np.bool_]


class ExtendProblem(NamedTuple):
    """One area: the ``floor`` that may be built on, its whole outline, what is learned of the
    sources, fixed buildings, streets in and about it, how many buildings (``number``) or what share
    of the outline (``coverage``) are wanted, settings, and
    rows to lay first; and the ``grounds`` of the sources, where they are drawn."""

    name: str
    floor: shapely.Polygon
    outline: shapely.Polygon
    pattern: SourcePattern
    standing: StandingGround
    roads: tuple[BuiltRoad, ...]
    number: int | None
    coverage: float
    source_roads: tuple[tuple[BuiltRoad, ...], ...]
    settings: GrowthSettings
    rows: tuple[Any, ...] = ()
    grounds: tuple[shapely.Polygon | None, ...] = ()


class GrownLayout(NamedTuple):
    """A filled area: poses (n, 3) x, y, heading, the building of the sources that each is a copy
    of ``origin`` (n,), how each came there ``how`` (n,), how many were ``asked`` for (0: by
    coverage), and what each measure says."""

    poses: Floats
    origin: Indices
    how: tuple[str, ...]
    asked: int
    score: dict[str, float]


ExtendFound = Found[GrownLayout]


def boxes_at(pattern: SourcePattern, poses: Floats, origin: Indices) -> Floats:
    """The boxes (n, 5) of copies of buildings of the sources at poses (n, 3)."""
    return np.concatenate([poses, pattern.boxes[origin, 3:]], 1)


def shapes_at(pattern: SourcePattern, poses: Floats, origin: Indices) -> NDArray[np.object_]:
    """The footprints (n,) of copies of buildings of the sources at poses (n, 3)."""
    boxes = boxes_at(pattern, poses, origin)
    found = np.empty(len(poses), object)
    kinds = pattern.kind[origin]
    for kind in np.unique(kinds).tolist():
        rows = np.flatnonzero(kinds == kind)
        local = pattern.kinds[kind].local
        found[rows] = shapely.polygons(from_frames(local[None], boxes[rows, None]))
    return found
