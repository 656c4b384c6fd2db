"""Example-driven retrieval (Zhu, Jiang and Li 2022): which real house goes where the nets say.

Every candidate is turned until its door is at the angle foretold, seen from its base point, and
moved there. Its category score is 0.8 (shape + area) + 0.2 material; legality takes 1000 where it
leaves the block and 1000 where it overlaps; the angle score tells how near the way from its middle
to the door is to a right angle with the nearest side of the block. Both are brought to [0, 0.9];
the first houses weigh category more, later ones the angle. Overlap is exact here, in pixels there.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.village.paper.views import base_and_door
from scenewright.domains.village.standing import Floats, Shapes

ILLEGAL, MOST = -1000.0, 0.9
TOUCH = 0.005
"""Metres by which footprints may overlap (shared walls)."""
EARLY, LATE = 0.8, 0.4
"""What category weighs for the first and for the last house."""


class RetrievedHouse(NamedTuple):
    """A house of the library: its ring (n, 2), its door (2,), classes of material, shape, area."""

    ring: Points
    door: Floats
    classes: tuple[int, int, int]


class PlacedHouse(NamedTuple):
    """A candidate moved: its ring and door in the block, and the pose (3,) of its own frame."""

    ring: Points
    door: Floats
    pose: Floats


class Retrieved(NamedTuple):
    """The best candidate: its number, where it stands, and its score."""

    number: int
    placed: PlacedHouse
    score: float


def turn_to(candidate: RetrievedHouse, base: Floats, angle: float) -> PlacedHouse | None:
    """A candidate moved so that its base point is at ``base`` and its door at an angle in [0, π]
    from it; None if no corner of it can be its base then."""
    box = shapely.minimum_rotated_rectangle(shapely.Polygon(candidate.ring))
    best, found = np.inf, None
    for corner in shapely.get_coordinates(box)[:4]:
        step = candidate.door - corner
        spin = angle - np.arctan2(step[1], step[0])
        turn = np.array([[np.cos(spin), np.sin(spin)], [-np.sin(spin), np.cos(spin)]])
        ring = (candidate.ring - corner) @ turn + base
        door = step @ turn + base
        off = float(np.hypot(*(base_and_door(ring, door)[0] - base)))
        if off < best:
            best, found = off, PlacedHouse(ring, door, np.append(base - corner @ turn, spin))
    return found if best < 1e-6 else None


def retrieve(
    candidates: Sequence[RetrievedHouse],
    asked: tuple[int, int, int],
    base: Floats,
    angle: float,
    floor: shapely.Polygon,
    free: shapely.Geometry,
    standing: Shapes,
    progress: float,
) -> Retrieved | None:
    """The candidate with the best sum of scores; ``progress`` in [0, 1] shifts their weights;
    ``free`` is the part of the block's ``floor`` that may be built on. None if none is legal."""
    placed = [turn_to(one, base, angle) for one in candidates]
    rows = [k for k, one in enumerate(placed) if one is not None]
    if not rows:
        return None
    moved = [one for one in placed if one is not None]
    shapes = np.array([shapely.Polygon(one.ring) for one in moved], object)
    category = np.array([_category(candidates[k].classes, asked) for k in rows])
    legal = legality(shapes, free, standing)
    facing = np.array([door_facing(one.ring, one.door, floor) for one in moved])
    weight = EARLY + (LATE - EARLY) * progress
    total = weight * _brought(category) + (1 - weight) * _brought(facing) + legal
    best = int(total.argmax())
    if total[best] < 0:
        return None
    return Retrieved(rows[best], moved[best], float(total[best]))


def _category(classes: tuple[int, int, int], asked: tuple[int, int, int]) -> float:
    material, shape, area = (float(a == b) for a, b in zip(classes, asked, strict=True))
    return 0.8 * (shape + area) + 0.2 * material


def _brought(values: Floats) -> Floats:
    """Values brought to [0, MOST].

    >>> _brought(np.array([1.0, 3.0])).tolist()
    [0.0, 0.9]
    """
    low, high = values.min(), values.max()
    return MOST * (values - low) / (high - low) if high > low else np.full(len(values), MOST)


def legality(shapes: Shapes, free: shapely.Geometry, standing: Shapes) -> Floats:
    """0 for footprints (k,) that may stand; 1000 less outside, 1000 less on another house."""
    found = np.where(shapely.covers(free, shapes), 0.0, ILLEGAL)
    if len(standing):
        inner = shapely.buffer(standing, -TOUCH, join_style="mitre")
        hit = shapely.STRtree(inner).query(shapes, predicate="intersects")[0]
        found[np.unique(hit)] += ILLEGAL
    return found


def door_facing(ring: Points, door: Floats, floor: shapely.Polygon) -> float:
    """How near the way from a house's middle to its door is to a right angle with the nearest side
    of the block: 1 at a right angle, 0 along it."""
    corners = shapely.get_coordinates(floor.exterior)
    sides = shapely.linestrings(np.stack([corners[:-1], corners[1:]], 1))
    side = int(shapely.distance(shapely.Point(door), sides).argmin())
    along = corners[side + 1] - corners[side]
    step = door - shapely.get_coordinates(shapely.Polygon(ring).centroid)[0]
    size = np.hypot(*along) * np.hypot(*step)
    return float(abs(along[0] * step[1] - along[1] * step[0]) / size) if size > 0 else 0.0
