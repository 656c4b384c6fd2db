"""An oriented box and a segment: how far apart they are, and how far the box looks past it."""

from __future__ import annotations

import math

from scenewright.geometry.boxes import Frame, distance_to_box, distance_to_segment, wrap
from scenewright.geometry.compiled import compiled, inlined


@inlined
def crosses(u0: float, v0: float, u1: float, v1: float, w: float, d: float) -> bool:
    """True if a segment in a box's own axes meets the box |u| <= w, |v| <= d: what is left of it
    between the four sides (Liang and Barsky 1984)."""
    low, high, du, dv = 0.0, 1.0, u1 - u0, v1 - v0
    for side in range(4):
        step = du if side < 2 else dv
        room = (w if side < 2 else d) - (u0 if side < 2 else v0)
        if side % 2 == 1:
            step, room = -step, (w if side < 2 else d) + (u0 if side < 2 else v0)
        if step == 0.0:
            if room < 0.0:
                return False
        elif step > 0.0:
            high = min(high, room / step)
        else:
            low = max(low, room / step)
    return low <= high


@compiled
def segment_to_box(x0: float, y0: float, x1: float, y1: float, frame: Frame) -> float:
    """Distance of a segment (a point, if its ends are one) to a box, 0 where they meet, metres.

    Two convex shapes that do not meet are nearest at a corner of one of them.

    >>> from scenewright.geometry.boxes import make_frame
    >>> segment_to_box(-3.0, 2.0, 3.0, 2.0, make_frame(0.0, 0.0, 0.0, 1.0, 2.0))
    1.5
    """
    x, y, c, s, w, d = frame[0], frame[1], frame[2], frame[3], frame[4], frame[5]
    u0, v0 = (x0 - x) * s - (y0 - y) * c, (x0 - x) * c + (y0 - y) * s
    u1, v1 = (x1 - x) * s - (y1 - y) * c, (x1 - x) * c + (y1 - y) * s
    if crosses(u0, v0, u1, v1, w, d):
        return 0.0
    least = min(distance_to_box(x0, y0, frame), distance_to_box(x1, y1, frame))
    for corner in range(4):
        u, v = (w if corner % 2 else -w), (d if corner < 2 else -d)
        least = min(least, distance_to_segment(u, v, u0, v0, u1, v1))
    return least


@compiled
def angle_past(x0: float, y0: float, x1: float, y1: float, frame: Frame, back: bool) -> float:
    """Radians by which the look straight ahead from a box's centre (or, if ``back``, straight
    behind it) misses a segment; 0 where it meets it, at most π.

    >>> from scenewright.geometry.boxes import make_frame
    >>> round(angle_past(0.0, 2.0, 1.0, 2.0, make_frame(0.0, 0.0, 0.0, 1.0, 1.0), False), 4)
    1.1071
    """
    look = frame[7] + (math.pi if back else 0.0)
    first = wrap(math.atan2(y0 - frame[1], x0 - frame[0]) - look)
    last = wrap(math.atan2(y1 - frame[1], x1 - frame[0]) - look)
    if first * last <= 0.0 and abs(first - last) < math.pi:
        return 0.0
    return min(abs(first), abs(last))
