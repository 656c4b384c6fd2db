"""Sloped ceilings: what rises through them, and the floor they are too low to walk on.

Over a floor the height of a ceiling is the least of the flat one's and of every slope's, which is
that of its knee wall and then grows with the distance from the wall. What has a convex footprint is
under its lowest ceiling at one of its corners. A person walks where the ceiling leaves
:data:`HEADROOM` over the middle of the way (the least clear height over stairs in DIN 18065) and
:data:`SHOULDERS` over its whole width, and bends down to pieces under a slope.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Bodies, Floats, Rooms, Shape
from scenewright.core.report import Finding
from scenewright.core.space import Slope, Space

HEADROOM = 2.0
"""Least height of the ceiling over the middle of a walking route, in metres."""

SHOULDERS = 1.5
"""Least height of the ceiling over the whole width of a walking route, in metres."""

BENDING = 0.4
"""How much further one reaches, bending down, a piece before a low ceiling, in metres."""

_FAR = 1e3


def ceiling_over(bodies: Bodies, rooms: Rooms) -> Floats:
    """The lowest ceiling over the footprint of each piece, in metres."""
    lowest = np.array([space.height for space in rooms.spaces])[bodies.room]
    for room, space in enumerate(rooms.spaces):
        here = bodies.room == room
        for slope in space.slopes:
            start, along = _edge(space, slope)
            off = bodies.corners[here] - start
            inwards = along[0] * off[..., 1] - along[1] * off[..., 0]
            over = slope.knee + np.tan(slope.pitch) * np.maximum(inwards.min(1), 0.0)
            lowest[here] = np.minimum(lowest[here], over)
    return lowest


def lower_than(space: Space, shape: Shape, height: float) -> Shape:
    """The part of a shape over which the ceiling of a space is lower than ``height``."""
    if space.height < height:
        return shape
    low = [slope for slope in space.slopes if slope.knee < height]
    return shapely.intersection(shape, shapely.union_all([_strip(space, s, height) for s in low]))


def find_through_slopes(bodies: Bodies, rooms: Rooms) -> list[Finding]:
    """Pieces that rise more than 1 cm through a slope (not those through the flat ceiling)."""
    flat = np.array([space.height for space in rooms.spaces])[bodies.room]
    ceiling = ceiling_over(bodies, rooms)
    through = (bodies.high > ceiling + TOLERANCE) & (bodies.high <= flat + TOLERANCE)
    return [
        _through(bodies, rooms, int(i), float(ceiling[i]))
        for i in np.flatnonzero(through & ~bodies.flat)
    ]


def _through(bodies: Bodies, rooms: Rooms, i: int, ceiling: float) -> Finding:
    piece, over = bodies.pieces[i], float(bodies.high[i]) - ceiling
    inside = lower_than(rooms.spaces[bodies.room[i]], bodies.footprints[i], float(bodies.high[i]))
    text = (
        f"{piece.id} rises {over:.2f} m through the slope of {piece.space}, "
        f"which is {ceiling:.2f} m high there"
    )
    return Finding(
        "through_slope",
        rooms.levels[bodies.level[i]],
        piece.space,
        piece.id,
        "",
        text,
        round(over, 4),
        round(float(inside.area), 4),
        piece.fixed,
    )


def _edge(space: Space, slope: Slope) -> tuple[Floats, Floats]:
    """Where a slope's edge begins, and its unit direction; the room is on its left."""
    start = space.outline[slope.edge]
    along = space.outline[(slope.edge + 1) % len(space.outline)] - start
    return start, along / np.hypot(*along)


def _strip(space: Space, slope: Slope, height: float) -> Shape:
    """All that lies no further inwards of a slope's edge than where it is ``height`` high."""
    start, along = _edge(space, slope)
    inward = np.array([-along[1], along[0]])
    deep = inward * (height - slope.knee) / np.tan(slope.pitch)
    left, right = start - along * _FAR, start + along * _FAR
    return shapely.polygons(
        np.stack([left - inward * _FAR, right - inward * _FAR, right + deep, left + deep])
    )
