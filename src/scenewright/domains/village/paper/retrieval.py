"""Example-driven retrieval (Zhu, Jiang and Li 2022): which real house goes where the nets say.

Every candidate is turned until its door is at the angle foretold, seen from its base point, and
moved there. Its category score is 0.8 (shape + area) + 0.2 material; legality takes 1000 where it
leaves the block and 1000 where it overlaps; the angle score is the angle in degrees between the way
from its middle to the door and the nearest side of the block, 90 at best. Both are brought to
[0, 0.9] as printed, category / 2 and angle / 100, and added; the best of the whole library is
taken. Overlap is exact here, in pixels there.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.village.house import rectangle_about
from scenewright.domains.village.paper.views import base_and_door
from scenewright.domains.village.standing import Floats, Shapes

ILLEGAL = -1000.0
TOUCH = 0.005
"""Metres by which footprints may overlap (shared walls)."""


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
) -> Retrieved | None:
    """The candidate with the best sum of scores; ``free`` is the part of the block's ``floor`` that
    may be built on. None if none is legal."""
    placed = [turn_to(one, base, angle) for one in candidates]
    rows = [k for k, one in enumerate(placed) if one is not None]
    if not rows:
        return None
    moved = [one for one in placed if one is not None]
    shapes = np.array([shapely.Polygon(one.ring) for one in moved], object)
    category = np.array([_category(candidates[k].classes, asked) for k in rows])
    legal = legality(shapes, free, standing)
    facing = np.array([door_facing(one.ring, one.door, floor) for one in moved])
    total = category / 2 + facing / 100 + legal
    best = int(total.argmax())
    if total[best] < 0:
        return None
    return Retrieved(rows[best], moved[best], float(total[best]))


def _category(classes: tuple[int, int, int], asked: tuple[int, int, int]) -> float:
    material, shape, area = (float(a == b) for a, b in zip(classes, asked, strict=True))
    return 0.8 * (shape + area) + 0.2 * material


def legality(shapes: Shapes, free: shapely.Geometry, standing: Shapes) -> Floats:
    """0 for footprints (k,) that may stand; 1000 less outside, 1000 less on another house."""
    found = np.where(shapely.covers(free, shapes), 0.0, ILLEGAL)
    if len(standing):
        inner = shapely.buffer(standing, -TOUCH, join_style="mitre")
        hit = shapely.STRtree(inner).query(shapes, predicate="intersects")[0]
        found[np.unique(hit)] += ILLEGAL
    return found


def door_facing(ring: Points, door: Floats, floor: shapely.Polygon) -> float:
    """The angle in degrees, 0 to 90, between the way from a house's middle, that of its least
    rectangle, to its door and the side of the block that is nearest to the door.

    >>> floor, ring = shapely.box(0, 0, 9, 9), np.array([[4.0, 1], [6, 1], [6, 3], [4, 3]])
    >>> round(door_facing(ring, np.array([5.0, 1.0]), floor), 6)
    90.0
    """
    corners = shapely.get_coordinates(floor.exterior)
    sides = shapely.linestrings(np.stack([corners[:-1], corners[1:]], 1))
    side = int(shapely.distance(shapely.Point(door), sides).argmin())
    along = corners[side + 1] - corners[side]
    step = door - rectangle_about(ring)[1]
    size = np.hypot(*along) * np.hypot(*step)
    if size <= 0:
        return 0.0
    sine = abs(along[0] * step[1] - along[1] * step[0]) / size
    return float(np.degrees(np.arcsin(min(sine, 1.0))))
