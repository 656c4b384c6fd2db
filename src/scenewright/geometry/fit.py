"""Whether upright boxes fit: inside the outline, clear of zones, windows and one another."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.boxes import (
    Frame,
    area_in_polygon,
    common_area,
    distance_to_segment,
    make_frame,
)
from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]
Row = Floats | tuple[float, float, float, float, float]

FITS, OUTSIDE, IN_ZONE, AT_WINDOW, COLLIDES = 0, 1, 2, 3, 4
_NOTHING = 1e-7


def faults(
    boxes: Floats,
    spans: Floats,
    flat: NDArray[np.bool_],
    edges: Floats,
    zones: Floats,
    windows: Floats,
    others: Floats,
    other_spans: Floats,
    slack: float,
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """What is wrong with each of the boxes ``(m, 5)``: a code and the index of the offender.

    ``spans`` (m, 2) are underside and top. Everything is judged on boxes drawn in by ``slack``
    metres a side, so a touch is no fault. ``flat`` boxes need only lie inside ``edges``.
    ``zones`` (k, 5) nothing below 2 m may enter; ``windows`` (q, 6) nothing above the sill;
    ``others`` (o, 5) with ``other_spans`` may not be met where the heights meet too.
    """
    found = np.empty((len(boxes), 2), np.int64)
    _find_faults(boxes, spans, flat, edges, zones, windows, others, other_spans, slack, found)
    return found[:, 0], found[:, 1]


@compiled
def _find_faults(
    boxes: Floats,
    spans: Floats,
    flat: NDArray[np.bool_],
    edges: Floats,
    zones: Floats,
    windows: Floats,
    others: Floats,
    other_spans: Floats,
    slack: float,
    found: NDArray[np.int64],
) -> None:
    for i in range(boxes.shape[0]):
        found[i, 0], found[i, 1] = _fault(
            boxes[i], spans[i], flat[i], edges, zones, windows, others, other_spans, slack
        )


@compiled
def mark_free(
    boxes: Floats,
    turns: Floats,
    shape: Floats,
    spans: Floats,
    flat: NDArray[np.bool_],
    edges: Floats,
    zones: Floats,
    windows: Floats,
    others: Floats,
    other_spans: Floats,
    slack: float,
    free: NDArray[np.bool_],
) -> None:
    """Write into ``free`` (n,) on which boxes ``(n, 5)`` of a group all its parts stand as
    :func:`faults` asks: ``shape`` (m, 5) their boxes about the middle of the group with its front
    to +y, ``turns`` (n, 2) sine and cosine of the boxes' headings. A box is given up at the first
    part with a fault."""
    for i in range(boxes.shape[0]):
        x, y, sin, cos, free[i] = boxes[i, 0], boxes[i, 1], turns[i, 0], turns[i, 1], True
        for k in range(shape.shape[0]):
            box = (
                x + shape[k, 0] * sin + shape[k, 1] * cos,
                y - shape[k, 0] * cos + shape[k, 1] * sin,
                boxes[i, 2] + shape[k, 2] - 0.5 * np.pi,
                shape[k, 3],
                shape[k, 4],
            )
            code, _ = _fault(
                box, spans[k], flat[k], edges, zones, windows, others, other_spans, slack
            )
            if code != FITS:
                free[i] = False
                break


@inlined
def shared_area(frame: Frame, box: Floats) -> float:
    """Area of a frame ∩ a box (5,), square metres; boxes the circles round which do not meet need
    no frame of their own."""
    dx, dy, w, d = box[0] - frame[0], box[1] - frame[1], 0.5 * box[3], 0.5 * box[4]
    reach = frame[6] + math.sqrt(w * w + d * d)
    if dx * dx + dy * dy >= reach * reach:
        return 0.0
    return common_area(frame, make_frame(box[0], box[1], box[2], box[3], box[4]))


@inlined
def _fault(
    box: Row,
    span: Floats,
    flat: bool,
    edges: Floats,
    zones: Floats,
    windows: Floats,
    others: Floats,
    other_spans: Floats,
    slack: float,
) -> tuple[int, int]:
    width, depth = max(box[3] - 2 * slack, 1e-3), max(box[4] - 2 * slack, 1e-3)
    frame = make_frame(box[0], box[1], box[2], width, depth)
    if width * depth - area_in_polygon(frame, edges) > _NOTHING:
        return OUTSIDE, -1
    if flat:
        return FITS, -1
    if span[0] < 2.0:
        for k in range(zones.shape[0]):
            if shared_area(frame, zones[k]) > _NOTHING:
                return IN_ZONE, k
    for k in range(windows.shape[0]):
        if span[1] > windows[k, 5] and shared_area(frame, windows[k]) > 0:
            return AT_WINDOW, k
    for k in range(others.shape[0]):
        meets = span[0] < other_spans[k, 1] - 1e-3 and other_spans[k, 0] < span[1] - 1e-3
        if meets and shared_area(frame, others[k]) > _NOTHING:
            return COLLIDES, k
    return FITS, -1


@compiled
def is_backed(box: Floats, walls: Floats, reach: float) -> bool:
    """True if both back corners of a box lie within ``reach`` metres of one and the same wall.

    ``box`` (5,), ``walls`` (w, 4) x0, y0, x1, y1.

    >>> wall = np.array([[0.0, 0.0, 4.0, 0.0]])
    >>> is_backed(np.array([2.0, 0.5, np.pi / 2, 1.0, 1.0]), wall, 0.01)
    True
    >>> is_backed(np.array([2.0, 0.6, np.pi / 2, 1.0, 1.0]), wall, 0.01)
    False
    """
    c, s = np.cos(box[2]), np.sin(box[2])
    x, y = box[0] - c * box[4] / 2, box[1] - s * box[4] / 2
    dx, dy = s * box[3] / 2, -c * box[3] / 2
    for k in range(walls.shape[0]):
        w = walls[k]
        first = distance_to_segment(x + dx, y + dy, w[0], w[1], w[2], w[3])
        if first <= reach and (
            distance_to_segment(x - dx, y - dy, w[0], w[1], w[2], w[3]) <= reach
        ):
            return True
    return False


@compiled
def side_gaps(box: Floats, walls: Floats) -> tuple[float, float]:
    """Distance from the middle of a box's left and right side to the nearest wall, metres.

    ``box`` (5,), ``walls`` (w, 4) x0, y0, x1, y1.
    """
    c, s = np.cos(box[2]), np.sin(box[2])
    dx, dy = s * box[3] / 2, -c * box[3] / 2
    left, right = np.inf, np.inf
    for k in range(walls.shape[0]):
        w = walls[k]
        left = min(left, distance_to_segment(box[0] - dx, box[1] - dy, w[0], w[1], w[2], w[3]))
        right = min(right, distance_to_segment(box[0] + dx, box[1] + dy, w[0], w[1], w[2], w[3]))
    return left, right


@inlined
def _stands(x: float, y: float, boxes: Floats, me: int, edges: Floats, zones: Floats) -> bool:
    """True if box ``me`` moved to (x, y), drawn in by a millimetre a side, meets nothing."""
    width, depth = max(boxes[me, 3] - 2e-3, 1e-3), max(boxes[me, 4] - 2e-3, 1e-3)
    frame = make_frame(x, y, boxes[me, 2], width, depth)
    if width * depth - area_in_polygon(frame, edges) > _NOTHING:
        return False
    for k in range(boxes.shape[0]):
        if k != me and shared_area(frame, boxes[k]) > _NOTHING:
            return False
    for k in range(zones.shape[0]):
        z = zones[k]
        if shared_area(frame, z) > _NOTHING:
            return False
    return True


@inlined
def _room_beside(
    boxes: Floats, me: int, sign: float, most: float, edges: Floats, zones: Floats
) -> float:
    """How far a box can slide sideways until it touches something; ``most`` if nothing is met."""
    x, y = boxes[me, 0], boxes[me, 1]
    dx, dy = sign * np.sin(boxes[me, 2]), -sign * np.cos(boxes[me, 2])
    if _stands(x + dx * most, y + dy * most, boxes, me, edges, zones):
        return most
    low, high = 0.0, most
    for _ in range(9):
        middle = 0.5 * (low + high)
        if _stands(x + dx * middle, y + dy * middle, boxes, me, edges, zones):
            low = middle
        else:
            high = middle
    return low


def settle(
    boxes: Floats,
    may: NDArray[np.bool_],
    grow: NDArray[np.bool_],
    edges: Floats,
    zones: Floats,
    most: float,
) -> Floats:
    """Boxes ``(n, 5)`` pushed sideways against the nearer neighbour or wall, where a gap of less
    than ``most`` metres lies between; only those that ``may``, one after the other. Those that may
    ``grow`` also widen over such a gap on their other side.

    >>> room = np.array([[0, 0, 4, 0], [4, 0, 4, 3], [4, 3, 0, 3], [0, 3, 0, 0]], float)
    >>> row = np.array([[0.6, 0.3, np.pi / 2, 1.0, 0.6]])
    >>> yes, no = np.array([True]), np.array([False])
    >>> float(settle(row, yes, no, room, row[:0], 0.3)[0, 0].round(2))
    0.5
    """
    found = boxes.copy()
    _settle(found, may, grow, edges, zones, most)
    return found


@compiled
def _settle(
    found: Floats,
    may: NDArray[np.bool_],
    grow: NDArray[np.bool_],
    edges: Floats,
    zones: Floats,
    most: float,
) -> None:
    for i in range(found.shape[0]):
        if may[i] and _stands(found[i, 0], found[i, 1], found, i, edges, zones):
            right = _room_beside(found, i, 1.0, most, edges, zones)
            left = _room_beside(found, i, -1.0, most, edges, zones)
            if min(left, right) < most:
                shift, rest = right if right <= left else -left, max(left, right)
                if grow[i] and left + right < most:
                    shift, rest = 0.5 * (right - left), left + right
                    found[i, 3] += rest
                found[i, 0] += shift * np.sin(found[i, 2])
                found[i, 1] -= shift * np.cos(found[i, 2])


@compiled
def stands(boxes: Floats, i: int, edges: Floats, zones: Floats) -> bool:
    """True if box ``i`` lies inside ``edges`` and meets no other box and none of the ``zones``.

    ``boxes`` (n, 5), ``edges`` (e, 4), ``zones`` (k, 5); metres and radians.
    """
    return _stands(boxes[i, 0], boxes[i, 1], boxes, i, edges, zones)
