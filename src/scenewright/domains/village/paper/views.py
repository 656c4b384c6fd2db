"""What the networks of Zhu, Jiang and Li (2022) see: a block from above in twelve channels.

Channels: the block; all houses; sine and cosine of the door angle painted over each house; three
of material; two of shape; three of area. A house is given by its *base point*, the corner of its
least rectangle that is lowest in the picture, and its *door angle* in [0, π], from that corner to
the door. Doors that no map tells stand in the middle of the most street-ward side, and materials
are all of the first kind (both assumed).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.domains.village.standing import Floats, Indices, Shapes

CHANNELS, MATERIALS, SHAPES, AREAS = 12, 3, 2, 3
COUNTED = MATERIALS + SHAPES + AREAS
"""How many numbers the count vector has."""
MARGIN = 1.05
"""How much larger than the block a view is."""


class PaperHouses(NamedTuple):
    """Houses (n,) as the paper tells them: footprints, base points (n, 2), door angles, classes
    of material, shape and area."""

    footprints: Shapes
    bases: Floats
    doors: Floats
    materials: Indices
    shapes: Indices
    areas: Indices

    def take(self, rows: Indices) -> PaperHouses:
        """Some of the houses."""
        return PaperHouses(
            self.footprints[rows],
            self.bases[rows],
            self.doors[rows],
            self.materials[rows],
            self.shapes[rows],
            self.areas[rows],
        )


class ViewFrame(NamedTuple):
    """Where a view lies: its lower left corner in metres, metres a pixel, pixels a side."""

    corner: Floats
    pixel: float
    size: int

    def pixels(self, points: Floats) -> Floats:
        """Points (n, 2) in metres as columns and rows, rows from the top."""
        found = (points - self.corner) / self.pixel
        return np.column_stack([found[:, 0], self.size - found[:, 1]])

    def metres(self, pixels: Floats) -> Floats:
        """The other way round.

        >>> frame = ViewFrame(np.array([10.0, 20.0]), 0.5, 64)
        >>> frame.metres(frame.pixels(np.array([[12.0, 25.0]]))).tolist()
        [[12.0, 25.0]]
        """
        return self.corner + np.column_stack([pixels[:, 0], self.size - pixels[:, 1]]) * self.pixel


def frame_of(floor: shapely.Polygon, size: int) -> ViewFrame:
    """The view of a whole block."""
    west, south, east, north = floor.bounds
    side = max(east - west, north - south) * MARGIN
    return ViewFrame(np.array([west + east - side, south + north - side]) / 2, side / size, size)


def centre_view(frame: ViewFrame, at: Floats) -> ViewFrame:
    """The same view shifted so that a point (2,) is in its middle."""
    return frame._replace(corner=at - frame.pixel * frame.size / 2)


def paint(frame: ViewFrame, floor: shapely.Polygon, houses: PaperHouses) -> NDArray[np.float32]:
    """The twelve channels (CHANNELS, size, size), rows from the top."""
    steps = np.arange(frame.size) + 0.5
    x, y = np.meshgrid(steps, steps)
    points = frame.metres(np.column_stack([x.ravel(), y.ravel()]))
    view = np.zeros((CHANNELS, frame.size * frame.size), np.float32)
    view[0] = shapely.contains_xy(floor, points[:, 0], points[:, 1])
    if len(houses.footprints):
        tree = shapely.STRtree(houses.footprints)
        at, house = tree.query(shapely.points(points), predicate="intersects")
        view[1, at] = 1.0
        view[2, at] = np.sin(houses.doors[house])
        view[3, at] = np.cos(houses.doors[house])
        view[4 + houses.materials[house], at] = 1.0
        view[7 + houses.shapes[house], at] = 1.0
        view[9 + houses.areas[house], at] = 1.0
    return view.reshape(CHANNELS, frame.size, frame.size)


def door_points(rings: Sequence[Points], streets: Points) -> list[Floats]:
    """The middle of the side of each ring that is nearest to a street."""
    lines = shapely.union_all(shapely.linestrings(streets))
    found = []
    for ring in rings:
        middles = (ring + np.roll(ring, -1, axis=0)) / 2
        found.append(middles[int(shapely.distance(shapely.points(middles), lines).argmin())])
    return found


def base_and_door(ring: Points, door: Floats) -> tuple[Floats, float]:
    """The base point of a ring (n, 2) and the angle in [0, π] from it to a door (2,).

    >>> ring = np.array([[0.0, 0.0], [4, 0.2], [4, 3.2], [0, 3.0]])
    >>> base, angle = base_and_door(ring, np.array([4.0, 1.7]))
    >>> base.round(1).tolist(), round(angle, 2)
    ([0.0, 0.0], 0.4)
    """
    box = shapely.minimum_rotated_rectangle(shapely.Polygon(ring))
    corners = shapely.get_coordinates(box)[:4]
    base = corners[int(np.argmin(np.round(corners[:, 1], 6)))]
    step = door - base
    return base, float(np.clip(np.arctan2(step[1], step[0]), 0.0, np.pi))


def count_vector(houses: PaperHouses) -> Floats:
    """How many houses of each material, shape and area (COUNTED,), in tens."""
    parts = [
        np.bincount(values, minlength=size)
        for values, size in zip(houses[3:], (MATERIALS, SHAPES, AREAS), strict=True)
    ]
    return np.concatenate(parts) / 10.0


def class_planes(classes: tuple[int, int, int], size: int) -> NDArray[np.float32]:
    """The classes of a house as planes (COUNTED, size, size), 1 where it is of one."""
    planes = np.zeros((COUNTED, size, size), np.float32)
    planes[[classes[0], MATERIALS + classes[1], MATERIALS + SHAPES + classes[2]]] = 1.0
    return planes
