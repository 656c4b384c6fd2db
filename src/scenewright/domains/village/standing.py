"""Houses that stand: footprints in the plan, the rectangles about them, classes of area."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.domains.village.house import rectangle_about

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.int64]
Shapes = NDArray[np.object_]


class StandingHouses(NamedTuple):
    """Houses that stand, row by row: ``shapes`` (n,) polygons, ``frames`` (n, 5) the least
    rectangle about each (x, y, angle of the longer side, longer side, shorter side), and classes
    of area ``sizes`` (n,)."""

    shapes: Shapes
    frames: Floats
    sizes: Indices

    def take(self, rows: Any) -> StandingHouses:
        """Some of the houses, by their numbers or as flags."""
        return StandingHouses(self.shapes[rows], self.frames[rows], self.sizes[rows])


def place(outline: Points, poses: Floats) -> Floats:
    """A ring (n, 2) of a house's own frame at poses (k, 3) in the plan: (k, n, 2).

    >>> place(np.array([[1.0, 0.0]]), np.array([[5.0, 5.0, np.pi / 2]])).round(9).tolist()
    [[[5.0, 6.0]]]
    """
    cos, sin = np.cos(poses[:, 2]), np.sin(poses[:, 2])
    x, y = outline[:, 0], outline[:, 1]
    east = poses[:, :1] + cos[:, None] * x - sin[:, None] * y
    north = poses[:, 1:2] + sin[:, None] * x + cos[:, None] * y
    return np.stack([east, north], -1)


def stand(outlines: list[Points], sizes: list[int]) -> StandingHouses:
    """Some houses by their footprints in the plan and classes of area."""
    shapes = np.empty(len(outlines), object)
    shapes[:] = [shapely.Polygon(ring) for ring in outlines]
    frames = np.zeros((len(outlines), 5))
    for k, ring in enumerate(outlines):
        angle, middle, sides = rectangle_about(ring)
        frames[k] = (*middle, angle, *sides)
    return StandingHouses(shapes, frames, np.array(sizes, np.int64))


def add(standing: StandingHouses, shape: Any, frame: Floats, size: int) -> StandingHouses:
    """The same and one more house at ``frame`` (5,)."""
    shapes = np.empty(len(standing.shapes) + 1, object)
    shapes[:-1], shapes[-1] = standing.shapes, shape
    frames = np.concatenate([standing.frames, frame[None]])
    return StandingHouses(shapes, frames, np.append(standing.sizes, size))
