"""The problem of continuing sources into one area, and its answer."""

from __future__ import annotations

from collections.abc import Mapping
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


class PreparedSources(NamedTuple):
    """What is asked of the sources over and over and does not change while an area is filled: the
    features of their buildings, and a circle within each footprint, as x, y, radius: of copies
    (n, 3) in the frames of their boxes, of what stands (m, 3) in the plan."""

    measured: Mapping[str, Floats]
    circles: Floats
    standing: Floats


class ExtendProblem(NamedTuple):
    """One area: the ``floor`` that may be built on, its whole outline, what is learned of the
    sources, fixed buildings, streets in and about it, how many buildings (``number``) or what share
    of the outline (``coverage``) are wanted, settings, and
    rows to lay first; the ``grounds`` of the sources, where they are drawn; and what of them is
    ``prepared`` (see :mod:`~scenewright.domains.extend.prepared`)."""

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
    prepared: PreparedSources | None = None


class GrownLayout(NamedTuple):
    """A filled area: poses (n, 3) x, y, heading, the building of the sources that each is a copy
    of ``origin`` (n,), how each came there ``how`` (n,), how many were ``asked`` for (0: by
    coverage), what each measure says, and the ``form`` (n, 2) of each (left out: as in the
    sources): how many times as wide and as deep as its original it is; negative: mirrored."""

    poses: Floats
    origin: Indices
    how: tuple[str, ...]
    asked: int
    score: dict[str, float]
    form: Floats | None = None


ExtendFound = Found[GrownLayout]


def boxes_at(
    pattern: SourcePattern, poses: Floats, origin: Indices, form: Floats | None = None
) -> Floats:
    """The boxes (n, 5) of copies of buildings of the sources at poses (n, 3), in their forms."""
    sides = pattern.boxes[origin, 3:]
    if form is not None:
        sides = np.abs(sides * form)
    return np.concatenate([poses, sides], 1)


def shapes_at(
    pattern: SourcePattern, poses: Floats, origin: Indices, form: Floats | None = None
) -> NDArray[np.object_]:
    """The footprints (n,) of copies of buildings of the sources at poses (n, 3), in their forms."""
    if not len(poses):
        return np.empty(0, object)
    locals_ = [pattern.kinds[kind].local for kind in pattern.kind[origin].tolist()]
    of = np.repeat(np.arange(len(poses)), [len(local) for local in locals_])
    local = np.concatenate(locals_)
    corners = from_frames(local if form is None else local * form[of], poses[of])
    return np.asarray(shapely.polygons(shapely.linearrings(corners, indices=of)))
