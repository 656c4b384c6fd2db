"""What is built somewhere, as values: buildings with their footprints, streets, the ground.

A scene may come from a map, a city model, a solution or a drawing; what is measured or learned of
it is the same for all.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points

Floats = NDArray[np.float64]
Spot = tuple[float, float]
QUARTER = np.pi / 2
SCATTERED = 12.0
"""Times the ground of its parts that the hull of a scene is where these are places apart."""


class BuiltBuilding(NamedTuple):
    """A building: its ``outline`` (n, 2) counter-clockwise in metres, height in metres, the
    ``heading`` of its front in radians (``None``: not known), the ``model`` that draws it, what
    it is used for in a word and the form of its roof (empty: none is named)."""

    id: str
    name: str
    outline: Points
    height: float
    heading: float | None = None
    model: str = ""
    use: str = ""
    roof: str = ""


class BuiltRoad(NamedTuple):
    """A street or path: middle line (n, 2) and width in metres."""

    line: Points
    width: float
    kind: str = "road"
    name: str = ""


class BuiltScene(NamedTuple):
    """What is built: buildings, streets, the ``outline`` (n, 2) of its ground (``None``: not
    known), what was left out with the reason, the longitude and latitude of (0, 0) if known, the
    ``catalog``, a path to the models that its buildings name, ``context``: buildings around
    that are neighbours, but not of the scene; and where trees and street lamps stand."""

    name: str
    buildings: tuple[BuiltBuilding, ...]
    roads: tuple[BuiltRoad, ...] = ()
    outline: Points | None = None
    left_out: tuple[str, ...] = ()
    origin: tuple[float, float] | None = None
    catalog: str = ""
    context: tuple[BuiltBuilding, ...] = ()
    trees: tuple[Spot, ...] = ()
    lamps: tuple[Spot, ...] = ()


class BuiltFrames(NamedTuple):
    """Buildings as boxes: ``boxes`` (n, 5) x, y, heading of the front, width along the front,
    depth, in metres and radians; ``shapes`` (n,) polygons; ``heights`` (n,) metres."""

    boxes: Floats
    shapes: NDArray[np.object_]
    heights: Floats


def frames_of(buildings: Sequence[BuiltBuilding], roads: Sequence[BuiltRoad] = ()) -> BuiltFrames:
    """The box of every building, along the sides of its least rectangle. Where no front is known
    it is the side that faces the nearest street within 40 m; without streets the long side
    nearest to the south.

    >>> hut = BuiltBuilding("a", "", np.array([[0, 0], [8, 0], [8, 5], [0, 5.0]]), 6.0)
    >>> frames_of([hut]).boxes.round(3).tolist()
    [[4.0, 2.5, -1.571, 8.0, 5.0]]
    """
    shapes = np.empty(len(buildings), object)
    shapes[:] = [shapely.Polygon(one.outline) for one in buildings]
    streets = shapely.union_all([shapely.LineString(r.line) for r in roads if r.kind == "road"])
    boxes = np.zeros((len(buildings), 5))
    for k, one in enumerate(buildings):
        boxes[k] = _box(one, shapes[k], streets)
    return BuiltFrames(boxes, shapes, np.array([one.height for one in buildings], float))


def _box(one: BuiltBuilding, shape: shapely.Polygon, streets: shapely.Geometry) -> Floats:
    frame = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shape))
    sides = np.diff(frame[:3], axis=0)
    length = np.hypot(sides[:, 0], sides[:, 1])
    long = int(length[1] > length[0] + 1e-6)
    middle = frame[:4].mean(0)
    out = float(np.arctan2(sides[long][1], sides[long][0])) - QUARTER
    wish = one.heading
    if wish is None and not streets.is_empty and shape.distance(streets) < 40.0:
        step = np.diff(shapely.get_coordinates(shapely.shortest_line(shape, streets)), axis=0)[0]
        if np.hypot(*step) > 1e-6:
            wish = float(np.arctan2(step[1], step[0]))
    if wish is None:
        heading = out + np.pi * (np.sin(out) > 1e-9)
    else:
        heading = out + QUARTER * np.round((wish - out) / QUARTER)
    turned = round((heading - out) / QUARTER) % 2 == 1
    width, depth = length[1 - long if turned else long], length[long if turned else 1 - long]
    return np.array([*middle, (heading + np.pi) % (2 * np.pi) - np.pi, width, depth])


def wrap_angles(angles: Floats) -> Floats:
    """Angles (n,) in [-π, π).

    >>> wrap_angles(np.array([4.0, 0.5])).round(3).tolist()
    [-2.283, 0.5]
    """
    return np.asarray((angles + np.pi) % (2 * np.pi) - np.pi)


def to_frames(points: Floats, boxes: Floats) -> Floats:
    """Points (..., 2) in the frames of boxes (..., 5): x along the width to the right of the
    front, y ahead.

    >>> to_frames(np.array([[3.0, 1.0]]), np.array([[1.0, 1.0, np.pi / 2, 2, 2]])).round(6).tolist()
    [[2.0, 0.0]]
    """
    step = points - boxes[..., :2]
    cos, sin = np.cos(boxes[..., 2]), np.sin(boxes[..., 2])
    return np.stack(
        [step[..., 0] * sin - step[..., 1] * cos, step[..., 0] * cos + step[..., 1] * sin], -1
    )


def from_frames(local: Floats, boxes: Floats) -> Floats:
    """Points (..., 2) of the frames of boxes (..., 5) in the plan; undoes :func:`to_frames`.

    >>> box = np.array([[1.0, 1.0, 0.4, 2, 2]])
    >>> from_frames(to_frames(np.array([[3.0, 1.0]]), box), box).round(6).tolist()
    [[3.0, 1.0]]
    """
    cos, sin = np.cos(boxes[..., 2]), np.sin(boxes[..., 2])
    x = boxes[..., 0] + local[..., 0] * sin + local[..., 1] * cos
    y = boxes[..., 1] - local[..., 0] * cos + local[..., 1] * sin
    return np.stack([x, y], -1)


def ground_of(scene: BuiltScene) -> shapely.Polygon:
    """The ground of a scene: its outline, else what lies within half the usual distance between
    its buildings, closed to one piece."""
    if scene.outline is not None:
        return shapely.Polygon(scene.outline).buffer(0)
    frames = frames_of(scene.buildings, scene.roads)
    if not len(frames.shapes):
        return shapely.Polygon()
    middles = frames.boxes[:, :2]
    away = np.hypot(*(middles[:, None] - middles[None]).transpose(2, 0, 1))
    np.fill_diagonal(away, np.inf)
    near = float(np.median(away.min(1))) if len(middles) > 1 else 20.0
    reach = max(near, 8.0)
    grown = shapely.union_all(shapely.buffer(frames.shapes, reach, join_style="mitre"))
    back = grown.buffer(-0.6 * reach, join_style="mitre")
    parts = [part for part in shapely.get_parts(back) if part.geom_type == "Polygon"]
    whole = shapely.union_all([shapely.Polygon(part.exterior) for part in parts])
    if whole.geom_type == "Polygon":
        return whole
    hull = shapely.convex_hull(whole)
    scattered = hull.area > SCATTERED * whole.area
    return max(shapely.get_parts(whole), key=lambda p: p.area) if scattered else hull
