"""How a layout of boxes is composed: measures that say what two layouts look like, not how good
they are.

They change slowly as boxes move, do not depend on the order of the boxes, and lengths are shares
of the root of the floor's area, so that small and large floors compare.
"""

from __future__ import annotations

import math

import numpy as np
import shapely
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

GRID = 20
"""Points along the longer side of a floor at which its openness is measured."""
RAYS, REACH = 12, 0.4
"""Directions in which enclosure is looked for from each point, and how far, as a share."""
EYES = 40
"""Most points from which enclosure is looked for."""
NAMES = (
    "density",
    "gaps",
    "uneven_gaps",
    "alignment",
    "axis_straight",
    "axis_diagonal",
    "facing_east",
    "facing_north",
    "off_east",
    "off_north",
    "spread",
    "open",
    "open_from_middle",
    "from_edge",
    "mixing",
    "rows",
    "enclosure",
)
"""What :func:`measure_composition` measures, in order."""


def measure_composition(boxes: Floats, kinds: Ints, floor: shapely.Polygon) -> Floats:
    """The composition (17,) of ``boxes`` (n, 5) of some ``kinds`` (n,) on a floor, by
    :data:`NAMES`.

    Share of the floor covered; mean distance of middles to the nearest other and its variation;
    how far the boxes share one axis (mean resultant length of four times the heading; Fisher
    1993) and that axis, straight or diagonal; the mean front; the middle of all off the floor's;
    how far they spread; the largest open circle and how far it lies off the middle; distance from
    the edge; share of neighbours of another kind; share of boxes in line with another; share of
    directions in which something closes the view. All 0 without boxes.
    """
    if not len(boxes):
        return np.zeros(len(NAMES))
    area = max(float(floor.area), 1e-9)
    unit, middle = area**0.5, np.array(floor.centroid.coords[0])
    weights = boxes[:, 3] * boxes[:, 4]
    share = weights / max(float(weights.sum()), 1e-9)
    at = (boxes[:, :2] - middle) / unit
    near, who = _nearest(at)
    turn = (share * np.exp(4j * boxes[:, 2])).sum()
    front = (share * np.exp(1j * boxes[:, 2])).sum()
    off = (share[:, None] * at).sum(0)
    spread = float(np.sqrt((share * ((at - off) ** 2).sum(1)).sum()))
    open_size, open_off, eyes = _openness(boxes, floor, unit, middle)
    edge = shapely.distance(shapely.points(boxes[:, :2]), floor.boundary)
    return np.array(
        [
            float(weights.sum()) / area,
            float(near.mean()),
            float(near.std() / max(float(near.mean()), 1e-9)),
            abs(turn),
            turn.real,
            turn.imag,
            front.real,
            front.imag,
            off[0],
            off[1],
            spread,
            open_size,
            open_off,
            float((share * edge).sum()) / unit,
            float((kinds[who] != kinds).mean()) if len(boxes) > 1 else 0.0,
            _share_in_line(boxes),
            _enclosure(eyes, boxes, REACH * unit),
        ]
    )


def _nearest(at: Floats) -> tuple[Floats, Ints]:
    """Distance (n,) to the nearest other of points (n, 2), and which it is."""
    if len(at) < 2:
        return np.zeros(len(at)), np.zeros(len(at), np.int64)
    apart = np.hypot(*(at[:, None] - at[None]).transpose(2, 0, 1))
    np.fill_diagonal(apart, np.inf)
    who = apart.argmin(1)
    return apart[np.arange(len(at)), who], who


def _openness(
    boxes: Floats, floor: shapely.Polygon, unit: float, middle: Floats
) -> tuple[float, float, Floats]:
    """Radius of the largest circle on the floor that no box touches and how far it lies off the
    middle, as shares; free points (k, 2) of the floor."""
    west, south, east, north = floor.bounds
    step = max(east - west, north - south, 1e-9) / GRID
    across, along = (max(math.ceil(w / step - 1e-9), 1) for w in (east - west, north - south))
    x, y = np.meshgrid(
        west + (np.arange(across) + 0.5) * (east - west) / across,
        south + (np.arange(along) + 0.5) * (north - south) / along,
    )
    points = np.stack([x.ravel(), y.ravel()], 1)
    points = points[shapely.contains_xy(floor, points)]
    if not len(points):
        return 0.0, 0.0, points
    clear = np.minimum(
        box_distances(points, boxes).min(1),
        shapely.distance(shapely.points(points), floor.boundary),
    )
    best = int(clear.argmax())
    off = float(np.hypot(*(points[best] - middle))) / unit
    return float(clear[best]) / unit, off, points[clear > 0.0]


def box_distances(points: Floats, boxes: Floats) -> Floats:
    """Distances (k, n) of ``points`` (k, 2) to ``boxes`` (n, 5); 0 inside.

    >>> box_distances(np.array([[0.0, 3.0], [0.5, 0.0]]), np.array([[0, 0, 0, 2, 2.0]])).tolist()
    [[2.0], [0.0]]
    """
    along, across = _local(points, boxes)
    beyond = np.maximum(np.abs(along) - boxes[:, 4] / 2, 0.0)
    beside = np.maximum(np.abs(across) - boxes[:, 3] / 2, 0.0)
    return np.hypot(beyond, beside)


def _local(points: Floats, boxes: Floats) -> tuple[Floats, Floats]:
    """Points (k, 2) along the heading of each box and across it, (k, n) each."""
    apart = points[:, None] - boxes[None, :, :2]
    cos, sin = np.cos(boxes[:, 2]), np.sin(boxes[:, 2])
    along = apart[..., 0] * cos + apart[..., 1] * sin
    return along, apart[..., 0] * sin - apart[..., 1] * cos


def _share_in_line(boxes: Floats) -> float:
    """The share of boxes whose front or back is in line with that of another of like heading."""
    if len(boxes) < 2:
        return 0.0
    along, _ = _local(boxes[:, :2], boxes)
    depths = np.abs(boxes[:, None, 4] - boxes[None, :, 4]) / 2
    like = np.cos(2 * (boxes[:, None, 2] - boxes[None, :, 2])) > 0.98
    line = like & (np.abs(along) <= depths + 0.1 * np.minimum.outer(boxes[:, 4], boxes[:, 4]))
    np.fill_diagonal(line, False)
    return float(line.any(1).mean())


def _enclosure(eyes: Floats, boxes: Floats, reach: float) -> float:
    """The share of directions from free points in which a box stands within ``reach``."""
    if not len(eyes):
        return 0.0
    places = np.rint(np.linspace(0, len(eyes) - 1, min(len(eyes), EYES)))
    some = eyes[np.unique(places.astype(np.int64))]
    along, across = _local(some, boxes)
    angle = np.linspace(0.0, 2 * np.pi, RAYS, endpoint=False)
    ahead = np.cos(angle[:, None] - boxes[None, :, 2])
    aside = np.sin(boxes[None, :, 2] - angle[:, None])
    met = _ray_meets(
        along[:, None], ahead, boxes[:, 4] / 2, across[:, None], aside, boxes[:, 3] / 2
    )
    return float((met <= reach).any(-1).mean())


def _ray_meets(
    along: Floats, ahead: Floats, deep: Floats, across: Floats, aside: Floats, wide: Floats
) -> Floats:
    """How far rays go to each box, by slabs; infinite where they miss."""
    first, last = _slab(along, ahead, deep)
    second, end = _slab(across, aside, wide)
    enter, leave = np.maximum(first, second), np.minimum(last, end)
    return np.where((leave >= np.maximum(enter, 0.0)), np.maximum(enter, 0.0), np.inf)


def _slab(at: Floats, way: Floats, half: Floats) -> tuple[Floats, Floats]:
    """Where rays enter and leave |x| <= half."""
    safe = np.where(np.abs(way) < 1e-12, 1e-12, way)
    one, other = (-half - at) / safe, (half - at) / safe
    return np.minimum(one, other), np.maximum(one, other)
