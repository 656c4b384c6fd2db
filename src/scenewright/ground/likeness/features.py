"""What is measured of every building: what it is, and how it stands to those around it.

*What*: floor area, height, length, depth, their ratio, how much of its box it fills, its outline by
the root of its area, its corners. *How*: distance to the nearest building, how much larger or
smaller that is, gaps to the sides and ahead or behind, by how much the next building ahead or
behind is shifted aside, where the four nearest stand in its own frame, the angle to the nearest,
its direction, the share of ground built on around it, distance and angle to the street of
those in its front row. Gaps are in metres up to :data:`FAR`; what has no neighbour that way has
:data:`FAR`; what a building has not, as the street of one in the second row, is nan.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.ground.buildings.built import (
    BuiltFrames,
    BuiltRoad,
    BuiltScene,
    frames_of,
    to_frames,
)

Floats = NDArray[np.float64]
FAR = 60.0
"""Metres beyond which buildings are no neighbours."""
NEAREST = 4
AROUND = 45.0
"""Metres within which the share of built ground counts."""
FRONT = 15.0
"""Metres to the middle of a street within which a building that nothing parts from it is of its
front row. Farther off, sheds and second rows say nothing of the street."""
SMOOTH = 0.5
"""Metres by which outlines are simplified before corners are counted."""
FACING = 0.2
"""The share of the shorter side by which boxes must overlap to stand beside or before."""


class FeatureRow(NamedTuple):
    """One feature: its name, whether it is of ``what`` or ``how``, the least ``scale`` its
    distances are divided by, its unit, and what it is in words."""

    name: str
    side: str
    scale: float
    unit: str
    words: str


ROWS = (
    FeatureRow("area", "what", 0.15, "log m²", "floor areas"),
    FeatureRow("height", "what", 1.5, "m", "heights"),
    FeatureRow("length", "what", 1.5, "m", "lengths"),
    FeatureRow("depth", "what", 1.0, "m", "depths"),
    FeatureRow("fill", "what", 0.05, "share", "footprints filling their boxes"),
    FeatureRow("ratio", "what", 0.05, "", "how long buildings are for their depth"),
    FeatureRow("ragged", "what", 0.1, "", "how ragged outlines are"),
    FeatureRow("corners", "what", 0.5, "", "corners of outlines"),
    FeatureRow("nearest", "how", 1.5, "m", "distances to the nearest building"),
    FeatureRow("contrast", "how", 0.15, "", "sizes beside each other"),
    FeatureRow("side_gap", "how", 2.0, "m", "side gaps"),
    FeatureRow("front_gap", "how", 3.0, "m", "front gaps"),
    FeatureRow("offset", "how", 2.0, "m", "lateral offsets"),
    FeatureRow("beside", "how", 3.0, "m", "places of neighbours to the side"),
    FeatureRow("ahead", "how", 3.0, "m", "places of neighbours ahead and behind"),
    FeatureRow("turn", "how", 0.08, "rad", "angles to the nearest building"),
    FeatureRow("north", "how", 0.1, "", "directions"),
    FeatureRow("east", "how", 0.1, "", "directions across"),
    FeatureRow("density", "how", 0.04, "share", "ground built on around"),
    FeatureRow("street", "how", 2.0, "m", "distances to the street"),
    FeatureRow("street_turn", "how", 0.08, "rad", "angles to the street"),
)
"""All features; those of streets only where both scenes have streets."""


def measure_buildings(
    frames: BuiltFrames, roads: Sequence[BuiltRoad] = (), count: int | None = None
) -> dict[str, Floats]:
    """The features of the first ``count`` buildings (left out: of all) among all: a vector (n,) for
    each name of :data:`ROWS`."""
    mine = BuiltFrames(frames.boxes[:count], frames.shapes[:count], frames.heights[:count])
    found = {**_what(mine), **_how(mine, frames.shapes, frames.boxes)}
    driven = [shapely.LineString(road.line) for road in roads if road.kind == "road"]
    if driven and len(mine.boxes):
        found |= _streets(mine, frames.shapes, driven)
    return found


def join_measures(rows: Sequence[dict[str, Floats]]) -> dict[str, Floats]:
    """The features of several scenes together, each measured separately; nan where one of them has
    not what another has (streets).

    >>> one, two = {"area": np.ones(1), "street": np.zeros(1)}, {"area": np.ones(2)}
    >>> {name: values.tolist() for name, values in join_measures([one, two]).items()}
    {'area': [1.0, 1.0, 1.0], 'street': [0.0, nan, nan]}
    """
    names = sorted(set().union(*rows))
    return {
        name: np.concatenate([row.get(name, np.full(len(row["area"]), np.nan)) for row in rows])
        for name in names
    }


def measure_scene(scene: BuiltScene) -> dict[str, Floats]:
    """The features of the buildings of a scene, measured among its context."""
    frames = frames_of([*scene.buildings, *scene.context], scene.roads)
    count = len(scene.buildings)
    return measure_buildings(frames, scene.roads, count)


def _what(frames: BuiltFrames) -> dict[str, Floats]:
    area = np.asarray(shapely.area(frames.shapes))
    sides = np.sort(frames.boxes[:, 3:], axis=1)
    return {
        "area": np.log(np.maximum(area, 1.0)),
        "height": frames.heights,
        "length": sides[:, 1],
        "depth": sides[:, 0],
        "fill": area / np.maximum(sides.prod(1), 1e-6),
        "ratio": sides[:, 0] / np.maximum(sides[:, 1], 1e-6),
        "ragged": np.asarray(shapely.length(frames.shapes)) / np.sqrt(np.maximum(area, 1.0)),
        "corners": np.asarray(
            shapely.get_num_coordinates(shapely.simplify(frames.shapes, SMOOTH)) - 1.0
        ),
    }


def _how(frames: BuiltFrames, shapes: NDArray[np.object_], boxes: Floats) -> dict[str, Floats]:
    """How buildings stand among all that have ``shapes`` and ``boxes``, of which they are the
    first."""
    count = len(frames.boxes)
    near, away = _neighbours(frames.shapes, shapes)
    found = {
        name: np.full(count, FAR)
        for name in ("nearest", "side_gap", "front_gap", "offset", "beside", "ahead")
    }
    found["turn"], found["contrast"] = np.zeros(count), np.zeros(count)
    size = np.log(np.maximum(np.asarray(shapely.area(shapes)), 1.0))
    for k in range(count):
        others, gaps = near[k], away[k]
        if len(others):
            _relate(boxes, k, others, gaps, found)
            found["contrast"][k] = abs(size[k] - size[others[0]])
    quadruple = 4.0 * frames.boxes[:, 2]
    found["north"], found["east"] = np.cos(quadruple), np.sin(quadruple)
    found["density"] = _density(frames.boxes, shapes)
    return found


def _neighbours(
    mine: NDArray[np.object_], shapes: NDArray[np.object_]
) -> tuple[list[NDArray[np.int64]], list[Floats]]:
    """For each of the first buildings those of all nearer than :data:`FAR`, nearest first, and the
    distances."""
    i, j = shapely.STRtree(shapes).query(mine, predicate="dwithin", distance=FAR)
    i, j = i[i != j], j[i != j]
    away = np.asarray(shapely.distance(mine[i], shapes[j]))
    order = np.lexsort((j, away, i))
    i, j, away = i[order], j[order], away[order]
    cuts = np.searchsorted(i, np.arange(len(mine) + 1))
    spans = list(zip(cuts[:-1].tolist(), cuts[1:].tolist(), strict=True))
    return [j[a:b] for a, b in spans], [away[a:b] for a, b in spans]


def _relate(
    boxes: Floats, k: int, others: NDArray[np.int64], gaps: Floats, found: dict[str, Floats]
) -> None:
    """Fill in what building ``k`` is to its neighbours."""
    local = to_frames(boxes[others, :2], boxes[k][None])
    turn = boxes[others, 2] - boxes[k, 2]
    cos, sin = np.abs(np.cos(turn)), np.abs(np.sin(turn))
    half_x = (boxes[others, 3] * cos + boxes[others, 4] * sin) / 2
    half_y = (boxes[others, 3] * sin + boxes[others, 4] * cos) / 2
    over_x = boxes[k, 3] / 2 + half_x - np.abs(local[:, 0])
    over_y = boxes[k, 4] / 2 + half_y - np.abs(local[:, 1])
    before = over_x > FACING * np.minimum(boxes[k, 3], 2 * half_x)
    beside = ~before & (over_y > FACING * np.minimum(boxes[k, 4], 2 * half_y))
    found["nearest"][k] = gaps[0]
    if beside.any():
        found["side_gap"][k] = gaps[beside][0]
    if before.any():
        found["front_gap"][k] = gaps[before][0]
        found["offset"][k] = abs(float(local[before][0, 0]))
    few = np.abs(local[:NEAREST])
    found["beside"][k], found["ahead"][k] = few.mean(0)
    angle = float(turn[0])
    found["turn"][k] = abs((angle + np.pi / 4) % (np.pi / 2) - np.pi / 4)


def _density(boxes: Floats, shapes: NDArray[np.object_]) -> Floats:
    """The share of a disc about each box that is built on."""
    discs = shapely.buffer(shapely.points(boxes[:, :2]), AROUND, quad_segs=4)
    i, j = shapely.STRtree(shapes).query(discs, predicate="intersects")
    shared = shapely.area(shapely.intersection(discs[i], shapes[j]))
    return np.asarray(np.bincount(i, shared, len(discs)) / shapely.area(discs))


def _streets(
    frames: BuiltFrames, shapes: NDArray[np.object_], lines: list[shapely.LineString]
) -> dict[str, Floats]:
    """Distance and angle to the nearest street of the front row; nan of the others."""
    every = np.array(lines, object)
    nearest = every[shapely.STRtree(lines).nearest(frames.shapes)]
    way = shapely.shortest_line(frames.shapes, nearest)
    away = np.asarray(shapely.length(way))
    i, j = shapely.STRtree(shapes).query(way, predicate="intersects")
    behind = np.bincount(i[i != j], minlength=len(away)) > 0
    turn = np.full(len(away), np.nan)
    for k in np.flatnonzero((away <= FRONT) & ~behind).tolist():
        line = nearest[k]
        at = line.project(shapely.Point(frames.boxes[k, :2]))
        ends = [line.interpolate(max(at - 1.0, 0.0)), line.interpolate(at + 1.0)]
        step = np.diff(shapely.get_coordinates(ends), axis=0)[0]
        angle = float(np.arctan2(step[1], step[0])) - frames.boxes[k, 2]
        turn[k] = abs((angle + np.pi / 4) % (np.pi / 2) - np.pi / 4)
    return {"street": np.where(np.isfinite(turn), away, np.nan), "street_turn": turn}
