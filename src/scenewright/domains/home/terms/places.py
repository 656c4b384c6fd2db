"""The term of places: items near or far from points of the room, and looking at them."""

from __future__ import annotations

import math

from scenewright.geometry.box_segment import angle_past, segment_to_box
from scenewright.geometry.boxes import Floats, Frame
from scenewright.geometry.compiled import inlined


@inlined
def place(frame: Frame, k: int, places: Floats, spots: Floats) -> float:
    """weight (max(0, d - far) + max(0, near - d) + |f| α): metres and radians off a place.

    ``places`` (s, 6), row ``k``: the first of its ``spots`` and the one after its last, near, far,
    f, weight. d is the distance of the box to the nearest of these spots (k, 4), which are segments
    x0, y0, x1, y1 (points, if the ends are one): outlets of one kind, windows, doors, walls, sides
    of fixed pieces. It should be at least ``near`` and at most ``far``. α is by how much the look
    ahead (f > 0) or behind (f < 0) misses the spot it misses least; f = 0: any heading.
    """
    first, end = int(places[k, 0]), int(places[k, 1])
    near, far, facing = places[k, 2], places[k, 3], places[k, 4]
    distance, past = math.inf, math.inf
    for j in range(first, end):
        x0, y0, x1, y1 = spots[j, 0], spots[j, 1], spots[j, 2], spots[j, 3]
        if near > 0.0 or far < math.inf:
            distance = min(distance, segment_to_box(x0, y0, x1, y1, frame))
        if facing != 0.0:
            past = min(past, angle_past(x0, y0, x1, y1, frame, facing < 0.0))
    off = 0.0
    if distance < math.inf:
        off += max(0.0, distance - far) + max(0.0, near - distance)
    if past < math.inf:
        off += abs(facing) * past
    return places[k, 5] * off
