"""A house: its footprint in a frame of its own, and the classes of its area and shape.

The frame has the longer side of the least rectangle about the footprint along x and the middle of
that rectangle at the origin; which side has the door is decided where the house stands. The
classes are those of Zhu, Jiang and Li (2022): small below 50 m², large above 100 m²; convex or
concave.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
import shapely

from scenewright.core.brief.uses import UseName
from scenewright.core.space import Points
from scenewright.ground.streetside.plots import OUTBUILDING

SMALL, LARGE = 50.0, 100.0
CONCAVE = 1e-6


class House(NamedTuple):
    """A house of the library: ``outline`` (n, 2) counter-clockwise in its own frame, its square
    metres, the ``extent`` (2,) of the least rectangle, class of area (0 small, 1 medium, 2 large)
    and of shape (0 convex, 1 concave), storeys, height in metres, the asset that draws it, how
    often it is chosen, whether its model has a front of its own (along +y of the model, which
    is ``front`` here, in radians), and, where real ones tell them, where its ``door`` is and the
    class of its ``material``; its ``use`` (empty: by its area)."""

    name: str
    outline: Points
    area: float
    extent: tuple[float, float]
    size: int
    shape: int
    levels: int
    height: float
    asset: str
    share: float
    front: float | None = None
    door: tuple[float, float] | None = None
    material: int = 0
    use: UseName | Literal[""] = ""


def is_outbuilding(use: str, area: float) -> bool:
    """Whether a house serves another: by its use, else by its square metres.

    >>> is_outbuilding("", 20.0), is_outbuilding("dwelling", 20.0), is_outbuilding("", 80.0)
    (True, False, False)
    """
    return use == "outbuilding" or (not use and area < OUTBUILDING)


def class_of_area(area: float) -> int:
    """0 below 50 m², 2 above 100 m², else 1.

    >>> [class_of_area(a) for a in (49.0, 50.0, 100.0, 101.0)]
    [0, 1, 1, 2]
    """
    return 0 if area < SMALL else 1 if area <= LARGE else 2


def class_of_shape(outline: Points) -> int:
    """0 if every corner of a ring (n, 2) turns left, else 1.

    >>> class_of_shape(np.array([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2.0]]))
    1
    """
    step = np.roll(outline, -1, axis=0) - outline
    after = np.roll(step, -1, axis=0)
    cross = step[:, 0] * after[:, 1] - step[:, 1] * after[:, 0]
    return int((cross < -CONCAVE * np.abs(cross).max()).any())


def to_own_frame(outline: Points) -> tuple[Points, float]:
    """A ring (n, 2), counter-clockwise, in the frame of the least rectangle about it, and the
    angle in [0, π) by which that frame is turned from the given one.

    >>> ring, turn = to_own_frame(np.array([[1, 0], [2, 0], [2, 3], [1, 3.0]]))
    >>> np.ptp(ring, axis=0).tolist(), round(turn, 3)
    ([3.0, 1.0], 1.571)
    """
    angle, middle, _ = rectangle_about(outline)
    cos, sin = np.cos(angle), np.sin(angle)
    local = np.round((outline - middle) @ np.array([[cos, -sin], [sin, cos]]), 9) + 0.0
    if not shapely.is_ccw(shapely.LinearRing(local)):
        local = local[::-1]
    return local, angle


def own_door(outline: Points, door: Points) -> tuple[float, float]:
    """A door (2,) of a ring in the frame of :func:`to_own_frame`.

    >>> own_door(np.array([[1, 0], [2, 0], [2, 3], [1, 3.0]]), np.array([2.0, 1.5]))
    (0.0, -0.5)
    """
    angle, middle, _ = rectangle_about(outline)
    cos, sin = np.cos(angle), np.sin(angle)
    x, y = (np.round((door - middle) @ np.array([[cos, -sin], [sin, cos]]), 9) + 0.0).tolist()
    return x, y


def rectangle_about(outline: Points) -> tuple[float, Points, tuple[float, float]]:
    """The angle in [0, π) of the longer side of the least rectangle about a ring (n, 2), its
    middle (2,), and its longer and shorter side in metres."""
    frame = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shapely.Polygon(outline)))
    sides = frame[1:3] - frame[:2]
    length = np.hypot(sides[:, 0], sides[:, 1])
    k = int(np.argmax(np.round(length, 6)))
    angle = float(np.round(np.arctan2(sides[k, 1], sides[k, 0]) % np.pi, 12))
    angle = 0.0 if angle > np.pi - 1e-9 else angle
    return angle, frame[:4].mean(0), (float(length[k]), float(length[1 - k]))
