"""How far one thing is off what a row asks of it and the room: kernels of single measures."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.arranging.rows import BACK, TURNS
from scenewright.geometry.boxes import Frame, distance_to_segment, make_frame
from scenewright.geometry.compiled import inlined

Floats = NDArray[np.float64]

X, Y, HEADING, WIDTH, DEPTH, ABOVE, KIND, OF_GROUP, NUMBER, IS_FLOOR, THINGS = range(11)
"""The columns of a thing: its box, where it begins above the floor, the numbers of its kind and of
its group's function in the table, that of its group (-1: it is there already), and whether it is
the floor of a group as a whole; how many columns there are."""
PART = 5
"""The column of a box that says which part of a room it is; those before are its box."""
ALONG_WALL = 0.3
"""Of the depth, ahead of the middle and behind it: where a side is measured."""


class RoomParts(NamedTuple):
    """The parts of a room that rows are about: directed ``edges`` (e, 4) of its floor and ``paths``
    (p, 4) of the ways from door to door, inside on the left; ``walls`` (w, 4); ``boxes`` (b, 6)
    with the part each is; its ``area``, square metres."""

    edges: Floats
    paths: Floats
    walls: Floats
    boxes: Floats
    area: float


@inlined
def read_thing(things: Floats, i: int) -> Frame:
    """The frame of a thing."""
    return make_frame(
        things[i, X], things[i, Y], things[i, HEADING], things[i, WIDTH], things[i, DEPTH]
    )


@inlined
def read_part(boxes: Floats, b: int, grown: float) -> Frame:
    """The frame of a part of a room, grown by ``grown`` metres on all sides."""
    wide, deep = boxes[b, WIDTH] + 2 * grown, boxes[b, DEPTH] + 2 * grown
    return make_frame(boxes[b, X], boxes[b, Y], boxes[b, HEADING], wide, deep)


@inlined
def measure_turn(heading: float, boxes: Floats) -> float:
    """How far a heading is off the nearest direction of a wall or a right angle to it, radians."""
    least, quarter = math.inf, math.pi / 2
    for b in range(boxes.shape[0]):
        if int(boxes[b, PART]) == TURNS:
            off = heading - boxes[b, HEADING]
            least = min(least, abs(off - quarter * math.floor(off / quarter + 0.5)))
    return least if least < math.inf else 0.0


@inlined
def measure_gap(things: Floats, i: int, side: int, walls: Floats) -> float:
    """Metres from a thing's back, or the nearer of its long sides, to the nearest wall, the larger
    of two places of each."""
    x, y, heading = things[i, X], things[i, Y], things[i, HEADING]
    wide, deep = things[i, WIDTH], things[i, DEPTH]
    if side == BACK:
        return _measure_side(x, y, heading + math.pi / 2, -deep / 2, wide, walls)
    left = _measure_side(x, y, heading, -wide / 2, deep, walls)
    return min(left, _measure_side(x, y, heading, wide / 2, deep, walls))


@inlined
def _measure_side(
    x: float, y: float, heading: float, out: float, long: float, walls: Floats
) -> float:
    """The same, of the side so far to the right."""
    c, s, far = math.cos(heading), math.sin(heading), 0.0
    for end in range(2):
        ahead = (2 * end - 1) * ALONG_WALL * long
        u, v, near = x + out * s + ahead * c, y - out * c + ahead * s, math.inf
        for k in range(walls.shape[0]):
            x0, y0, x1, y1 = walls[k, 0], walls[k, 1], walls[k, 2], walls[k, 3]
            near = min(near, distance_to_segment(u, v, x0, y0, x1, y1))
        far = max(far, near)
    return far


@inlined
def measure_distance(things: Floats, i: int, boxes: Floats, parts: int) -> float:
    """Metres from the middle of a thing to the nearest box of some parts of a room, as far as it is
    ahead or aside of that; 0 without any."""
    nearest = math.inf
    for b in range(boxes.shape[0]):
        if int(boxes[b, PART]) & parts:
            u, v = things[i, X] - boxes[b, X], things[i, Y] - boxes[b, Y]
            c, s = math.cos(boxes[b, HEADING]), math.sin(boxes[b, HEADING])
            along = max(abs(u * s - v * c) - boxes[b, WIDTH] / 2, 0.0)
            ahead = max(u * c + v * s + boxes[b, DEPTH] / 2, 0.0)
            nearest = min(nearest, math.sqrt(along * along + ahead * ahead))
    return nearest if nearest < math.inf else 0.0


@inlined
def measure_away(things: Floats, i: int, boxes: Floats, parts: int) -> float:
    """The cosine between the back of a thing and the way to the nearest box of some parts of a
    room, at least 0; 0 without any."""
    nearest, found = math.inf, 0.0
    for b in range(boxes.shape[0]):
        if int(boxes[b, PART]) & parts:
            u, v = boxes[b, X] - things[i, X], boxes[b, Y] - things[i, Y]
            far = max(math.sqrt(u * u + v * v), 1e-9)
            if far < nearest:
                c, s = math.cos(things[i, HEADING]), math.sin(things[i, HEADING])
                nearest, found = far, max(-(u * c + v * s) / far, 0.0)
    return found


@inlined
def touches(things: Floats, i: int, j: int, gap: float, ahead: float, alike: float) -> bool:
    """Whether two things stand side by side: their gap along, how far one is ahead of the other,
    and the cosine of the angle between them, are within bounds."""
    dx, dy = things[j, X] - things[i, X], things[j, Y] - things[i, Y]
    s, c = math.sin(things[i, HEADING]), math.cos(things[i, HEADING])
    between = abs(dx * s - dy * c) - (things[i, WIDTH] + things[j, WIDTH]) / 2
    turn = math.cos(things[i, HEADING] - things[j, HEADING])
    return turn > alike and abs(between) < gap and abs(dx * c + dy * s) < ahead
