"""Kinds of buildings by shape: the same footprint and height, wherever it stands, is one letter."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.ground.buildings.built import BuiltBuilding, BuiltFrames, to_frames

UNALIKE, ALIKE = 0.6, 0.3
"""The share of buildings of their own kind from which classes of size stand for kinds, and the
logarithm of the ratio within which sizes are of one class."""
SAME_SIDE, SAME_SHAPE, SAME_HEIGHT = 0.4, 0.95, 0.6
"""Metres by which sides, the share of shapes and metres of height that one kind may differ in."""


def letter_of(number: int) -> str:
    """A, B … Z, AA, AB …

    >>> letter_of(0), letter_of(27)
    ('A', 'AB')
    """
    text = ""
    number += 1
    while number:
        number, rest = divmod(number - 1, 26)
        text = chr(65 + rest) + text
    return text


def group_kinds(buildings: Sequence[BuiltBuilding], frames: BuiltFrames) -> list[int]:
    """The number of the kind of each building, in the order in which kinds occur.

    >>> from scenewright.ground.buildings.built import frames_of
    >>> ring = np.array([[0, 0], [8, 0], [8, 5], [0, 5.0]])
    >>> rows = [BuiltBuilding(str(k), "", ring * (1 + k % 2) + 20 * k, 6.0) for k in range(4)]
    >>> group_kinds(rows, frames_of(rows))
    [0, 1, 0, 1]
    """
    known: list[tuple[shapely.Polygon, tuple[float, ...], str]] = []
    found = []
    for built, box, height in zip(buildings, frames.boxes, frames.heights, strict=True):
        size = (float(box[3]), float(box[4]), float(height))
        polygon = shapely.Polygon(np.round(to_frames(built.outline, box[None]), 4))
        match = next(
            (k for k, one in enumerate(known) if _same(one, polygon, size, built.model)), None
        )
        if match is None:
            match = len(known)
            known.append((polygon, size, built.model))
        found.append(match)
    return found


def name_kinds(buildings: Sequence[BuiltBuilding], frames: BuiltFrames) -> list[str]:
    """The letter of the kind of each building; of its class of size, where hardly two are alike,
    as in real towns."""
    kinds = group_kinds(buildings, frames)
    if len(set(kinds)) > UNALIKE * len(kinds):
        kinds = group_sizes(frames)
    return [letter_of(k) for k in kinds]


def group_sizes(frames: BuiltFrames) -> list[int]:
    """The class of size of each building: the first leader whose width, depth and height are
    within :data:`ALIKE` of its own, as ratios (a leader algorithm, Hartigan 1975).

    >>> boxes = np.array([[0, 0, 0, 6.0, 9.0], [0, 0, 0, 6.5, 9.0], [0, 0, 0, 14.0, 9.0]])
    >>> group_sizes(BuiltFrames(boxes, np.empty(3, object), np.full(3, 8.0)))
    [0, 0, 1]
    """
    sizes = np.log(np.maximum(np.column_stack([frames.boxes[:, 3:], frames.heights]), 0.5))
    leaders: list[np.ndarray] = []
    found = []
    for size in sizes:
        near = [k for k, one in enumerate(leaders) if np.abs(one - size).max() < ALIKE]
        if not near:
            leaders.append(size)
        found.append(near[0] if near else len(leaders) - 1)
    return found


def _same(
    one: tuple[shapely.Polygon, tuple[float, ...], str],
    polygon: shapely.Polygon,
    size: tuple[float, ...],
    model: str,
) -> bool:
    theirs, known, named = one
    if named != model or abs(known[2] - size[2]) > SAME_HEIGHT:
        return False
    if max(abs(known[k] - size[k]) for k in (0, 1)) > SAME_SIDE:
        return False
    both = shapely.intersection(theirs, polygon).area
    return bool(both > SAME_SHAPE * max(theirs.area, polygon.area))
