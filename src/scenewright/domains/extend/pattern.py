"""What is learned of the sources: kinds of buildings, who stands how to whom, gaps, coverage."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.domains.extend.repeats import repeat_steps
from scenewright.ground.buildings.built import (
    BuiltBuilding,
    BuiltFrames,
    BuiltScene,
    frames_of,
    ground_of,
    to_frames,
)
from scenewright.ground.buildings.kinds import group_kinds, letter_of

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]

NEIGHBOURS = 8
"""Neighbours by whose places a building is known."""
FARTHEST = 90.0
"""Metres beyond which nobody is a neighbour."""
ALIKE = 5
"""Buildings of the sources that stand in for one."""
TOUCHING, TERRACED = 0.5, 0.35
"""Metres below which buildings touch, and the share of buildings that must for it to be the
rule."""
TIGHT = 0.05
"""The quantile of gaps below which nothing is built."""
STOREY = 3.0
"""Metres of a storey that is added or counted."""


class BuildingKind(NamedTuple):
    """One kind of building: its letter, what people call it, footprint (n, 2) in the frame of its
    box (x right, y to the front), width, depth and height, the model that draws it, the source it
    is of, and how many ``copies`` there are."""

    letter: str
    name: str
    local: Points
    size: tuple[float, float, float]
    model: str
    source: int
    copies: int


class GapRules(NamedTuple):
    """The least distances in metres between buildings beside, before, and diagonally."""

    side: float
    front: float
    corner: float


class SourcePattern(NamedTuple):
    """All buildings of the sources, row by row: ``boxes`` (n, 5), ``kind`` (n,), which ``source``
    (n,), neighbours ``near`` (n, k), -1 for none, with poses ``relative`` (n, k, 3) in the frame
    of each, the buildings ``alike`` (n, a) that may stand in for each, ``reach``: metres within
    which neighbours count; gaps, the share of ground covered, and the share in which each is
    followed, ``weight`` (n,); of each source the ``steps`` (m, 2) at which it repeats itself; and
    what is told of each building, its use and the form of its roof."""

    kinds: tuple[BuildingKind, ...]
    boxes: Floats
    kind: Indices
    source: Indices
    shapes: NDArray[np.object_]
    near: Indices
    relative: Floats
    alike: Indices
    reach: float
    gaps: GapRules
    coverage: float
    weight: Floats
    steps: tuple[Floats, ...]
    told: tuple[tuple[str, str], ...] = ()


def learn_pattern(scenes: Sequence[BuiltScene], shares: Sequence[float]) -> SourcePattern:
    """The pattern of some sources; ``shares`` are those in which each is followed."""
    frames = [frames_of(scene.buildings, scene.roads) for scene in scenes]
    kinds, kind = _kinds(scenes, frames)
    boxes = np.concatenate([one.boxes for one in frames])
    shapes = np.concatenate([one.shapes for one in frames])
    source = np.repeat(np.arange(len(scenes)), [len(one.boxes) for one in frames])
    near, relative = _neighbours(boxes, source)
    total = sum(shares)
    counts = np.bincount(source, minlength=len(scenes))
    weight = np.array([shares[s] / total / counts[s] for s in source.tolist()])
    covered = [
        float(shapely.area(one.shapes).sum() / max(ground_of(scene).area, 1.0))
        for scene, one in zip(scenes, frames, strict=True)
    ]
    steps = np.hypot(relative[..., 0], relative[..., 1])
    reach = float(np.clip(np.median(np.where(near >= 0, steps, 0.0).max(1)), 15.0, FARTHEST))
    return SourcePattern(
        kinds,
        boxes,
        kind,
        source,
        shapes,
        near,
        relative,
        _alike(boxes, kind, relative, near),
        reach,
        _gap_rules(boxes, shapes, source),
        min(float(np.average(covered, weights=shares)), 0.75),
        weight,
        tuple(repeat_steps(one.boxes) for one in frames),
        tuple((one.use, one.roof) for scene in scenes for one in scene.buildings),
    )


def _kinds(
    scenes: Sequence[BuiltScene], frames: Sequence[BuiltFrames]
) -> tuple[tuple[BuildingKind, ...], Indices]:
    """Buildings of one source, size and shape are one kind; kinds in the order they occur."""
    found: list[BuildingKind] = []
    of: list[int] = []
    for number, (scene, one) in enumerate(zip(scenes, frames, strict=True)):
        kinds, before = group_kinds(scene.buildings, one), len(found)
        for k, kind in enumerate(kinds):
            if before + kind == len(found):
                found.append(_kind(scene.buildings[k], one, k, len(found), number))
            of.append(before + kind)
    counts = np.bincount(of, minlength=len(found)).tolist()
    named = tuple(kind._replace(copies=n) for kind, n in zip(found, counts, strict=True))
    return named, np.array(of, np.int64)


def _kind(
    built: BuiltBuilding, frames: BuiltFrames, row: int, number: int, source: int
) -> BuildingKind:
    box = frames.boxes[row]
    local = np.round(to_frames(built.outline, box[None]), 4)
    letter = letter_of(number)
    size = (float(box[3]), float(box[4]), float(frames.heights[row]))
    return BuildingKind(letter, letter, local, size, built.model, source, 0)


def _neighbours(boxes: Floats, source: Indices) -> tuple[Indices, Floats]:
    """The nearest buildings of each in its own source, and their poses in its frame."""
    count = len(boxes)
    few = max(min(NEIGHBOURS, count - 1), 1)
    near, relative = np.full((count, few), -1), np.zeros((count, few, 3))
    for k in range(count):
        away = np.hypot(*(boxes[:, :2] - boxes[k, :2]).T)
        away[(source != source[k]) | (np.arange(count) == k)] = np.inf
        order = np.argsort(away, kind="stable")[:few]
        order = order[away[order] < FARTHEST]
        near[k, : len(order)] = order
        relative[k, : len(order), :2] = to_frames(boxes[order, :2], boxes[k][None])
        relative[k, : len(order), 2] = boxes[order, 2] - boxes[k, 2]
    return near, relative


def _alike(boxes: Floats, kind: Indices, relative: Floats, near: Indices) -> Indices:
    """For each building those most like it in size, kind and the places of neighbours."""
    sides = np.log(np.maximum(boxes[:, 3:], 0.5))
    size = np.abs(sides[:, None] - sides[None]).sum(2)
    size += 0.3 * (kind[:, None] != kind[None])
    around = np.where((near >= 0)[..., None], np.abs(relative[..., :2]), FARTHEST / 2).mean(1)
    size += np.abs(around[:, None] - around[None]).sum(2) / FARTHEST
    return np.argsort(size, axis=1, kind="stable")[:, :ALIKE]


def _least_gap(gaps: Floats, of: Indices, count: int) -> float:
    """The least gap in use: a low quantile. That few buildings touch is no rule, as between the
    parts of one; only where many do, as in terraces, touching counts."""
    touching = len(np.unique(of[gaps < TOUCHING])) / max(count, 1)
    known = gaps if touching >= TERRACED else gaps[gaps >= TOUCHING]
    return float(np.quantile(known, TIGHT)) * 0.98 if len(known) else np.nan


def pair_kind(box: Floats, others: Floats) -> Indices:
    """How boxes (n, 5) stand to a box (5,), or each to its own (n, 5): 0 beside, 1 before or
    behind, 2 at a corner.

    >>> one = np.array([0.0, 0.0, np.pi / 2, 10.0, 6.0])
    >>> pair_kind(one, np.array([[12.0, 0, np.pi / 2, 10, 6], [1, 20, np.pi / 2, 10, 6]])).tolist()
    [0, 1]
    """
    local = np.abs(to_frames(others[:, :2], box))
    turn = others[:, 2] - box[..., 2]
    cos, sin = np.abs(np.cos(turn)), np.abs(np.sin(turn))
    half_x = (others[:, 3] * cos + others[:, 4] * sin) / 2
    half_y = (others[:, 3] * sin + others[:, 4] * cos) / 2
    over_x = box[..., 3] / 2 + half_x - local[:, 0]
    over_y = box[..., 4] / 2 + half_y - local[:, 1]
    before = over_x > 0.2 * np.minimum(box[..., 3], 2 * half_x)
    beside = over_y > 0.2 * np.minimum(box[..., 4], 2 * half_y)
    return np.where(before, 1, np.where(beside, 0, 2))


def _gap_rules(boxes: Floats, shapes: NDArray[np.object_], source: Indices) -> GapRules:
    """Low quantiles of the gaps of the sources, by how the pair stands."""
    i, j = shapely.STRtree(shapes).query(shapes, predicate="dwithin", distance=60.0)
    apart = (i != j) & (source[i] == source[j])
    i, j = i[apart], j[apart]
    gaps = np.asarray(shapely.distance(shapes[i], shapes[j]))
    how = pair_kind(boxes[i], boxes[j])
    least = [_least_gap(gaps[how == k], i[how == k], len(boxes)) for k in range(3)]
    known = [value for value in least if np.isfinite(value)] or [6.0]
    side, front, corner = (v if np.isfinite(v) else min(known) for v in least)
    return GapRules(side, front, min(corner, front))
